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

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
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
    var phi_746_: f32;
    var phi_747_: f32;
    var phi_748_: f32;
    var phi_765_: f32;
    var phi_766_: f32;
    var phi_767_: f32;
    var phi_784_: f32;
    var phi_785_: f32;
    var phi_786_: f32;
    var phi_803_: f32;
    var phi_804_: f32;
    var phi_805_: f32;
    var phi_828_: f32;
    var phi_829_: f32;
    var phi_830_: f32;
    var phi_909_: bool;
    var phi_953_: f32;
    var phi_954_: f32;
    var phi_955_: bool;
    var phi_956_: f32;
    var phi_957_: bool;
    var phi_958_: f32;
    var phi_959_: bool;
    var phi_963_: f32;
    var phi_964_: f32;
    var phi_983_: f32;
    var phi_984_: f32;
    var phi_985_: f32;
    var phi_996_: f32;
    var phi_1011_: f32;
    var phi_1013_: lt_bvh_slab_Span;
    var phi_1071_: f32;
    var phi_1072_: f32;
    var phi_1073_: f32;
    var phi_1074_: f32;
    var phi_1075_: f32;
    var phi_1076_: bool;
    var phi_1080_: f32;
    var phi_1095_: f32;
    var phi_1096_: f32;
    var phi_1097_: f32;
    var phi_1098_: f32;
    var phi_1099_: f32;
    var phi_1100_: f32;
    var phi_1101_: f32;
    var phi_1102_: bool;
    var phi_1106_: f32;
    var phi_1107_: f32;
    var phi_1108_: bool;
    var phi_1109_: f32;
    var phi_1110_: f32;
    var phi_1111_: bool;
    var phi_1115_: f32;

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
        phi_1109_ = _e119;
        phi_1110_ = f32();
        phi_1111_ = true;
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
            phi_1106_ = 1f;
            phi_1107_ = f32();
            phi_1108_ = true;
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
            if (_e422 < 0.0000000000000000000000000000000001f) {
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
                phi_1100_ = _e499;
                phi_1101_ = f32();
                phi_1102_ = true;
            } else {
                let _e504 = ((_e144 * _e68) * _e154);
                let _e505 = ((_e146 * _e80) * _e156);
                let _e506 = ((_e148 * _e92) * _e158);
                let _e507 = ((_e150 * _e104) * _e160);
                let _e514 = ((((_e504 * _e105) + (_e505 * _e106)) + (_e506 * _e107)) + (_e507 * _e108));
                let _e525 = ((((_e504 * (_e105 * _e105)) + (_e505 * (_e106 * _e106))) + (_e506 * (_e107 * _e107))) + (_e507 * (_e108 * _e108)));
                if (_e525 < 0.0000000000000000000000000000000001f) {
                    if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
                        phi_748_ = _e105;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_747_ = 0f;
                        } else {
                            if (_e105 < 0f) {
                                phi_746_ = 0f;
                            } else {
                                phi_746_ = 1f;
                            }
                            let _e535 = phi_746_;
                            phi_747_ = _e535;
                        }
                        let _e537 = phi_747_;
                        phi_748_ = _e537;
                    }
                    let _e539 = phi_748_;
                    if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                        phi_767_ = _e106;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_766_ = 0f;
                        } else {
                            if (_e106 < 0f) {
                                phi_765_ = 0f;
                            } else {
                                phi_765_ = 1f;
                            }
                            let _e548 = phi_765_;
                            phi_766_ = _e548;
                        }
                        let _e550 = phi_766_;
                        phi_767_ = _e550;
                    }
                    let _e552 = phi_767_;
                    if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                        phi_786_ = _e107;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_785_ = 0f;
                        } else {
                            if (_e107 < 0f) {
                                phi_784_ = 0f;
                            } else {
                                phi_784_ = 1f;
                            }
                            let _e561 = phi_784_;
                            phi_785_ = _e561;
                        }
                        let _e563 = phi_785_;
                        phi_786_ = _e563;
                    }
                    let _e565 = phi_786_;
                    if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                        phi_805_ = _e108;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_804_ = 0f;
                        } else {
                            if (_e108 < 0f) {
                                phi_803_ = 0f;
                            } else {
                                phi_803_ = 1f;
                            }
                            let _e574 = phi_803_;
                            phi_804_ = _e574;
                        }
                        let _e576 = phi_804_;
                        phi_805_ = _e576;
                    }
                    let _e578 = phi_805_;
                    let _e586 = (((((_e539 * _e144) + (_e552 * _e146)) + (_e565 * _e148)) + (_e578 * _e150)) + _e141);
                    if ((bitcast<u32>(_e586) & 2147483647u) > 2139095040u) {
                        phi_830_ = _e586;
                    } else {
                        if (_e586 < 0f) {
                            phi_829_ = 0f;
                        } else {
                            if (_e586 > 1f) {
                                phi_828_ = 1f;
                            } else {
                                phi_828_ = _e586;
                            }
                            let _e593 = phi_828_;
                            phi_829_ = _e593;
                        }
                        let _e595 = phi_829_;
                        phi_830_ = _e595;
                    }
                    let _e597 = phi_830_;
                    phi_964_ = _e597;
                } else {
                    let _e599 = (_e525 - (_e151 * _e514));
                    let _e601 = ((_e152 * _e514) - _e525);
                    let _e606 = ((_e144 * _e105) * _e154);
                    let _e607 = ((_e146 * _e106) * _e156);
                    let _e608 = ((_e148 * _e107) * _e158);
                    let _e609 = ((_e150 * _e108) * _e160);
                    let _e635 = (_e141 + (((((_e606 * ((_e607 * _e165) + ((0.5f * _e608) * _e173))) + (_e607 * ((_e608 * _e166) + ((0.5f * _e609) * _e174)))) + (_e608 * ((_e609 * _e167) + ((0.5f * _e606) * _e175)))) + (_e609 * ((_e606 * _e168) + ((0.5f * _e607) * _e176)))) / (_e151 * _e599)));
                    let _e640 = ((_e144 * _e105) * _e68);
                    let _e641 = ((_e146 * _e106) * _e80);
                    let _e642 = ((_e148 * _e107) * _e92);
                    let _e643 = ((_e150 * _e108) * _e104);
                    let _e669 = (_e141 + (((((_e640 * ((_e641 * _e165) + ((0.5f * _e642) * _e173))) + (_e641 * ((_e642 * _e166) + ((0.5f * _e643) * _e174)))) + (_e642 * ((_e643 * _e167) + ((0.5f * _e640) * _e175)))) + (_e643 * ((_e640 * _e168) + ((0.5f * _e641) * _e176)))) / (_e152 * _e601)));
                    let _e670 = (_e514 > 0f);
                    if _e670 {
                        phi_909_ = (_e601 > 0f);
                    } else {
                        phi_909_ = (_e599 < 0f);
                    }
                    let _e674 = phi_909_;
                    if _e674 {
                        if (_e635 >= 0f) {
                            if (_e669 >= 0f) {
                                if _e670 {
                                    phi_953_ = (1f - _e635);
                                } else {
                                    phi_953_ = ((((((_e504 * ((_e505 * _e165) + ((0.5f * _e506) * _e173))) + (_e505 * ((_e506 * _e166) + ((0.5f * _e507) * _e174)))) + (_e506 * ((_e507 * _e167) + ((0.5f * _e504) * _e175)))) + (_e507 * ((_e504 * _e168) + ((0.5f * _e505) * _e176)))) / (_e525 * (-(_e151) * _e152))) + _e669);
                                }
                                let _e707 = phi_953_;
                                phi_954_ = _e707;
                                phi_955_ = false;
                            } else {
                                phi_954_ = f32();
                                phi_955_ = true;
                            }
                            let _e709 = phi_954_;
                            let _e711 = phi_955_;
                            phi_956_ = _e709;
                            phi_957_ = _e711;
                        } else {
                            phi_956_ = f32();
                            phi_957_ = true;
                        }
                        let _e713 = phi_956_;
                        let _e715 = phi_957_;
                        phi_958_ = _e713;
                        phi_959_ = _e715;
                    } else {
                        phi_958_ = f32();
                        phi_959_ = true;
                    }
                    let _e717 = phi_958_;
                    let _e719 = phi_959_;
                    if _e719 {
                        phi_963_ = 1f;
                    } else {
                        phi_963_ = _e717;
                    }
                    let _e721 = phi_963_;
                    phi_964_ = _e721;
                }
                let _e723 = phi_964_;
                let _e724 = (_e723 < 1f);
                if _e724 {
                    if ((bitcast<u32>(_e723) & 2147483647u) > 2139095040u) {
                        phi_985_ = _e723;
                    } else {
                        if (_e723 < 0f) {
                            phi_984_ = 0f;
                        } else {
                            if (_e723 > 1f) {
                                phi_983_ = 1f;
                            } else {
                                phi_983_ = _e723;
                            }
                            let _e731 = phi_983_;
                            phi_984_ = _e731;
                        }
                        let _e733 = phi_984_;
                        phi_985_ = _e733;
                    }
                    let _e735 = phi_985_;
                    phi_1098_ = _e735;
                    phi_1099_ = f32();
                } else {
                    let _e737 = ((0.5f * -(((((((((_e205 * (_e105 + _e106)) + (_e209 * (_e105 + _e107))) + (_e233 * (_e105 + _e151))) + (_e245 * (_e105 + _e152))) + ((((_e206 * (_e106 + _e107)) + (_e210 * (_e106 + _e108))) + (_e234 * (_e106 + _e151))) + (_e246 * (_e106 + _e152)))) + ((((_e207 * (_e107 + _e108)) + (_e211 * (_e107 + _e105))) + (_e235 * (_e107 + _e151))) + (_e247 * (_e107 + _e152)))) + ((((_e208 * (_e108 + _e105)) + (_e212 * (_e108 + _e106))) + (_e236 * (_e108 + _e151))) + (_e248 * (_e108 + _e152)))) + (_e419 * (_e151 + _e152))))) / _e422);
                    let _e738 = ((((((((_e205 + _e209) + _e233) + _e245) + (((_e206 + _e210) + _e234) + _e246)) + (((_e207 + _e211) + _e235) + _e247)) + (((_e208 + _e212) + _e236) + _e248)) + _e419) / _e422);
                    let _e740 = ((_e737 * _e737) - _e738);
                    if (_e740 > 0f) {
                        phi_996_ = sqrt(_e740);
                    } else {
                        phi_996_ = 0f;
                    }
                    let _e744 = phi_996_;
                    if (_e737 > 0f) {
                        let _e747 = (-(_e737) - _e744);
                        phi_1013_ = lt_bvh_slab_Span(_e747, (_e738 / _e747));
                    } else {
                        let _e750 = (_e744 - _e737);
                        if (_e750 > 0f) {
                            phi_1011_ = (_e738 / _e750);
                        } else {
                            phi_1011_ = 0f;
                        }
                        let _e754 = phi_1011_;
                        phi_1013_ = lt_bvh_slab_Span(_e754, _e750);
                    }
                    let _e757 = phi_1013_;
                    if (_e757.near >= 0f) {
                        phi_1074_ = 1f;
                        phi_1075_ = f32();
                        phi_1076_ = true;
                    } else {
                        let _e761 = (_e757.far <= 0f);
                        if _e761 {
                            phi_1072_ = (_e416 / _e422);
                            phi_1073_ = f32();
                        } else {
                            let _e772 = (((((_e144 * _e105) + (_e146 * _e106)) + (_e148 * _e107)) + (_e150 * _e108)) + (_e141 * (_e151 + _e152)));
                            let _e788 = (((((_e144 * (_e105 * _e105)) + (_e146 * (_e106 * _e106))) + (_e148 * (_e107 * _e107))) + (_e150 * (_e108 * _e108))) + (_e141 * ((_e151 * _e151) + (_e152 * _e152))));
                            if (-(_e757.near) <= _e757.far) {
                                phi_1071_ = (1f - (((_e757.near * _e757.near) * ((_e757.far * _e788) - _e772)) / (_e757.far - _e757.near)));
                            } else {
                                phi_1071_ = ((_e416 / _e422) + (((_e757.far * _e757.far) * (_e772 - (_e757.near * _e788))) / (_e757.far - _e757.near)));
                            }
                            let _e807 = phi_1071_;
                            phi_1072_ = f32();
                            phi_1073_ = _e807;
                        }
                        let _e809 = phi_1072_;
                        let _e811 = phi_1073_;
                        phi_1074_ = _e809;
                        phi_1075_ = _e811;
                        phi_1076_ = _e761;
                    }
                    let _e813 = phi_1074_;
                    let _e815 = phi_1075_;
                    let _e817 = phi_1076_;
                    if _e817 {
                        phi_1080_ = _e813;
                    } else {
                        phi_1080_ = _e815;
                    }
                    let _e819 = phi_1080_;
                    if ((bitcast<u32>(_e819) & 2147483647u) > 2139095040u) {
                        phi_1097_ = _e819;
                    } else {
                        if (_e819 < 0f) {
                            phi_1096_ = 0f;
                        } else {
                            if (_e819 > 1f) {
                                phi_1095_ = 1f;
                            } else {
                                phi_1095_ = _e819;
                            }
                            let _e826 = phi_1095_;
                            phi_1096_ = _e826;
                        }
                        let _e828 = phi_1096_;
                        phi_1097_ = _e828;
                    }
                    let _e830 = phi_1097_;
                    phi_1098_ = f32();
                    phi_1099_ = _e830;
                }
                let _e832 = phi_1098_;
                let _e834 = phi_1099_;
                phi_1100_ = _e832;
                phi_1101_ = _e834;
                phi_1102_ = _e724;
            }
            let _e836 = phi_1100_;
            let _e838 = phi_1101_;
            let _e840 = phi_1102_;
            if _e840 {
            }
            phi_1106_ = _e836;
            phi_1107_ = _e838;
            phi_1108_ = _e840;
        }
        let _e842 = phi_1106_;
        let _e844 = phi_1107_;
        let _e846 = phi_1108_;
        phi_1109_ = _e842;
        phi_1110_ = _e844;
        phi_1111_ = _e846;
    }
    let _e848 = phi_1109_;
    let _e850 = phi_1110_;
    let _e852 = phi_1111_;
    if _e852 {
        phi_1115_ = _e848;
    } else {
        phi_1115_ = _e850;
    }
    let _e854 = phi_1115_;
    return _e854;
}

fn function_() {
    var local_1: f32;
    var phi_1166_: bool;
    var phi_1167_: bool;
    var phi_1168_: bool;
    var phi_1169_: bool;
    var phi_1173_: bool;
    var phi_1243_: bool;
    var phi_1244_: bool;
    var phi_1255_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1256_: bool;
    var phi_1257_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1258_: bool;
    var phi_1265_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1269_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1343_: bool;
    var phi_1352_: bool;
    var phi_1361_: bool;
    var phi_1362_: bool;
    var phi_1363_: bool;
    var phi_1364_: bool;
    var phi_1365_: bool;
    var phi_1366_: bool;
    var phi_1367_: bool;
    var phi_1371_: bool;
    var phi_1461_: f32;
    var phi_1464_: f32;
    var phi_1493_: f32;
    var phi_1498_: f32;
    var phi_1499_: bool;
    var phi_1500_: f32;
    var phi_1501_: bool;
    var phi_1505_: f32;
    var phi_1525_: f32;
    var phi_1530_: f32;
    var phi_1531_: bool;
    var phi_1532_: f32;
    var phi_1533_: bool;
    var phi_1537_: f32;
    var phi_1585_: i32;
    var phi_1590_: i32;
    var phi_1595_: i32;
    var phi_1600_: i32;
    var phi_1609_: i32;
    var phi_1614_: i32;
    var phi_1619_: i32;
    var phi_1624_: i32;
    var phi_1675_: bool;
    var phi_1683_: bool;
    var phi_1695_: bool;
    var phi_1696_: bool;
    var phi_1700_: f32;
    var phi_1706_: f32;
    var phi_1708_: evaluate_Verdict;
    var phi_1713_: evaluate_Verdict;
    var phi_1714_: evaluate_Verdict;
    var phi_1718_: bool;
    var phi_1719_: u32;
    var phi_1730_: u32;

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
                phi_1166_ = (_e77 == _e79);
                phi_1167_ = false;
            } else {
                phi_1166_ = bool();
                phi_1167_ = true;
            }
            let _e82 = phi_1166_;
            let _e84 = phi_1167_;
            phi_1168_ = _e82;
            phi_1169_ = _e84;
        } else {
            phi_1168_ = bool();
            phi_1169_ = true;
        }
        let _e86 = phi_1168_;
        let _e88 = phi_1169_;
        if _e88 {
            phi_1173_ = false;
        } else {
            phi_1173_ = _e86;
        }
        let _e90 = phi_1173_;
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
                    phi_1244_ = true;
                } else {
                    let _e143 = p.member.light.range_squared;
                    if (_e126 <= _e143) {
                        let _e146 = p.member.light.cos_outer;
                        phi_1243_ = (-((((_e108 * _e128.x) + (_e109 * _e128.y)) + (_e110 * _e128.z))) >= (_e146 * sqrt(_e126)));
                    } else {
                        phi_1243_ = false;
                    }
                    let _e151 = phi_1243_;
                    phi_1244_ = _e151;
                }
                let _e153 = phi_1244_;
                if _e153 {
                    let _e155 = samples.member[_e55.first_primitive].flags;
                    let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e163.unnamed.visibility, false), _e163.unnamed_1);
                    phi_1255_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e169.unnamed, ((_e155 & 1u) == 0u));
                    phi_1256_ = false;
                } else {
                    phi_1255_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1256_ = true;
                }
                let _e174 = phi_1255_;
                let _e176 = phi_1256_;
                phi_1257_ = _e174;
                phi_1258_ = _e176;
            } else {
                phi_1257_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1258_ = true;
            }
            let _e178 = phi_1257_;
            let _e180 = phi_1258_;
            if _e180 {
                let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e186.unnamed.visibility, false), _e186.unnamed_1);
                phi_1265_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e192.unnamed, true);
            } else {
                phi_1265_ = _e178;
            }
            let _e197 = phi_1265_;
            phi_1269_ = _e197;
        } else {
            let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e203.unnamed.visibility, false), _e203.unnamed_1);
            phi_1269_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e209.unnamed, true);
        }
        let _e214 = phi_1269_;
        if _e214.unnamed_1 {
            phi_1714_ = evaluate_Verdict(_e214.unnamed.visibility, _e214.unnamed.is_doubted);
        } else {
            let _e222 = samples.member[_e55.first_primitive].position;
            let _e240 = ((((_e63.projection.row_w.x * _e222.x) + (_e63.projection.row_w.y * _e222.y)) + (_e63.projection.row_w.z * _e222.z)) + (_e63.projection.row_w.w * 1f));
            let _e254 = (((((_e63.projection.row_x.x * _e222.x) + (_e63.projection.row_x.y * _e222.y)) + (_e63.projection.row_x.z * _e222.z)) + (_e63.projection.row_x.w * 1f)) / _e240);
            let _e268 = (((((_e63.projection.row_y.x * _e222.x) + (_e63.projection.row_y.y * _e222.y)) + (_e63.projection.row_y.z * _e222.z)) + (_e63.projection.row_y.w * 1f)) / _e240);
            let _e281 = ((((_e63.projection.row_z.x * _e222.x) + (_e63.projection.row_z.y * _e222.y)) + (_e63.projection.row_z.z * _e222.z)) + (_e63.projection.row_z.w * 1f));
            if (_e240 > 0f) {
                if (_e254 >= 0f) {
                    phi_1343_ = (_e254 <= 1f);
                } else {
                    phi_1343_ = false;
                }
                let _e286 = phi_1343_;
                if _e286 {
                    if (_e268 >= 0f) {
                        phi_1352_ = (_e268 <= 1f);
                    } else {
                        phi_1352_ = false;
                    }
                    let _e290 = phi_1352_;
                    if _e290 {
                        if (_e281 >= 0f) {
                            phi_1361_ = (_e281 <= 1f);
                        } else {
                            phi_1361_ = false;
                        }
                        let _e294 = phi_1361_;
                        phi_1362_ = _e294;
                        phi_1363_ = false;
                    } else {
                        phi_1362_ = bool();
                        phi_1363_ = true;
                    }
                    let _e296 = phi_1362_;
                    let _e298 = phi_1363_;
                    phi_1364_ = _e296;
                    phi_1365_ = _e298;
                } else {
                    phi_1364_ = bool();
                    phi_1365_ = true;
                }
                let _e300 = phi_1364_;
                let _e302 = phi_1365_;
                phi_1366_ = _e300;
                phi_1367_ = _e302;
            } else {
                phi_1366_ = bool();
                phi_1367_ = true;
            }
            let _e304 = phi_1366_;
            let _e306 = phi_1367_;
            if _e306 {
                phi_1371_ = false;
            } else {
                phi_1371_ = _e304;
            }
            let _e308 = phi_1371_;
            if _e308 {
                if (0f > 0f) {
                    let _e311 = samples.member[_e55.first_primitive].normal;
                    let _e313 = p.member.map_size;
                    let _e383 = ((abs(((((_e62.row_x.x * _e311.x) + (_e62.row_x.y * _e311.y)) + (_e62.row_x.z * _e311.z)) / (((_e62.row_x.x * _e62.row_x.x) + (_e62.row_x.y * _e62.row_x.y)) + (_e62.row_x.z * _e62.row_x.z)))) + abs(((((_e62.row_y.x * _e311.x) + (_e62.row_y.y * _e311.y)) + (_e62.row_y.z * _e311.z)) / (((_e62.row_y.x * _e62.row_y.x) + (_e62.row_y.y * _e62.row_y.y)) + (_e62.row_y.z * _e62.row_y.z))))) / (abs(((((_e62.row_z.x * _e311.x) + (_e62.row_z.y * _e311.y)) + (_e62.row_z.z * _e311.z)) / (((_e62.row_z.x * _e62.row_z.x) + (_e62.row_z.y * _e62.row_z.y)) + (_e62.row_z.z * _e62.row_z.z)))) * f32(_e313)));
                    if (_e383 < 0.002f) {
                        phi_1461_ = _e383;
                    } else {
                        phi_1461_ = 0.002f;
                    }
                    let _e386 = phi_1461_;
                    phi_1464_ = (_e281 - (0f * _e386));
                } else {
                    phi_1464_ = _e281;
                }
                let _e390 = phi_1464_;
                let _e392 = p.member.map_size;
                let _e393 = f32(_e392);
                let _e396 = ((_e254 * _e393) - 0.5f);
                let _e397 = ((_e268 * _e393) - 0.5f);
                if (_e396 > -8388608f) {
                    let _e409 = f32(select(0i, select(select(i32(_e396), i32(-2147483648), (_e396 < bitcast<f32>(3472883712u))), 2147483647i, (_e396 > bitcast<f32>(1325400063u))), (_e396 == _e396)));
                    if (_e409 > _e396) {
                        phi_1493_ = 1f;
                    } else {
                        phi_1493_ = 0f;
                    }
                    let _e412 = phi_1493_;
                    if (_e396 < 8388608f) {
                        phi_1498_ = (_e409 - _e412);
                        phi_1499_ = false;
                    } else {
                        phi_1498_ = f32();
                        phi_1499_ = true;
                    }
                    let _e415 = phi_1498_;
                    let _e417 = phi_1499_;
                    phi_1500_ = _e415;
                    phi_1501_ = _e417;
                } else {
                    phi_1500_ = f32();
                    phi_1501_ = true;
                }
                let _e419 = phi_1500_;
                let _e421 = phi_1501_;
                if _e421 {
                    phi_1505_ = _e396;
                } else {
                    phi_1505_ = _e419;
                }
                let _e423 = phi_1505_;
                if (_e397 > -8388608f) {
                    let _e435 = f32(select(0i, select(select(i32(_e397), i32(-2147483648), (_e397 < bitcast<f32>(3472883712u))), 2147483647i, (_e397 > bitcast<f32>(1325400063u))), (_e397 == _e397)));
                    if (_e435 > _e397) {
                        phi_1525_ = 1f;
                    } else {
                        phi_1525_ = 0f;
                    }
                    let _e438 = phi_1525_;
                    if (_e397 < 8388608f) {
                        phi_1530_ = (_e435 - _e438);
                        phi_1531_ = false;
                    } else {
                        phi_1530_ = f32();
                        phi_1531_ = true;
                    }
                    let _e441 = phi_1530_;
                    let _e443 = phi_1531_;
                    phi_1532_ = _e441;
                    phi_1533_ = _e443;
                } else {
                    phi_1532_ = f32();
                    phi_1533_ = true;
                }
                let _e445 = phi_1532_;
                let _e447 = phi_1533_;
                if _e447 {
                    phi_1537_ = _e397;
                } else {
                    phi_1537_ = _e445;
                }
                let _e449 = phi_1537_;
                let _e450 = (_e396 - _e423);
                let _e451 = (_e397 - _e449);
                let _e460 = select(0i, select(select(i32(_e423), i32(-2147483648), (_e423 < bitcast<f32>(3472883712u))), 2147483647i, (_e423 > bitcast<f32>(1325400063u))), (_e423 == _e423));
                let _e469 = select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < bitcast<f32>(3472883712u))), 2147483647i, (_e449 > bitcast<f32>(1325400063u))), (_e449 == _e449));
                let _e480 = p.member.test;
                let _e481 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e480);
                let _e483 = p.member.map_size;
                local_1 = _e481;
                let _e485 = ((0u * _e483) * _e483);
                let _e487 = (bitcast<i32>(_e483) - 1i);
                if (_e460 > 0i) {
                    phi_1585_ = _e460;
                } else {
                    phi_1585_ = 0i;
                }
                let _e490 = phi_1585_;
                if (_e469 > 0i) {
                    phi_1590_ = _e469;
                } else {
                    phi_1590_ = 0i;
                }
                let _e493 = phi_1590_;
                if (_e490 < _e487) {
                    phi_1595_ = _e490;
                } else {
                    phi_1595_ = _e487;
                }
                let _e496 = phi_1595_;
                if (_e493 < _e487) {
                    phi_1600_ = _e493;
                } else {
                    phi_1600_ = _e487;
                }
                let _e499 = phi_1600_;
                let _e500 = bitcast<u32>(_e496);
                let _e502 = (_e460 + 1i);
                let _e503 = (_e469 + 1i);
                if (_e502 > 0i) {
                    phi_1609_ = _e502;
                } else {
                    phi_1609_ = 0i;
                }
                let _e506 = phi_1609_;
                if (_e503 > 0i) {
                    phi_1614_ = _e503;
                } else {
                    phi_1614_ = 0i;
                }
                let _e509 = phi_1614_;
                if (_e506 < _e487) {
                    phi_1619_ = _e506;
                } else {
                    phi_1619_ = _e487;
                }
                let _e512 = phi_1619_;
                if (_e509 < _e487) {
                    phi_1624_ = _e509;
                } else {
                    phi_1624_ = _e487;
                }
                let _e515 = phi_1624_;
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
                let _e545 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e531, _e535, _e539, _e543), vec4<f32>(((1f - _e450) * (1f - _e451)), (_e450 * (1f - _e451)), ((1f - _e450) * _e451), (_e450 * _e451)), _e390);
                let _e547 = p.member.epsilon;
                if (_e545 <= _e547) {
                    phi_1675_ = true;
                } else {
                    phi_1675_ = (_e545 >= (1f - _e547));
                }
                let _e552 = phi_1675_;
                if ((bitcast<u32>(_e545) & 2147483647u) > 2139095040u) {
                    phi_1683_ = true;
                } else {
                    phi_1683_ = !(_e552);
                }
                let _e558 = phi_1683_;
                if _e558 {
                    if (_e545 > 0f) {
                        if (_e545 < 1f) {
                            phi_1695_ = false;
                        } else {
                            phi_1695_ = true;
                        }
                        let _e562 = phi_1695_;
                        phi_1696_ = _e562;
                    } else {
                        phi_1696_ = true;
                    }
                    let _e564 = phi_1696_;
                    if _e564 {
                        phi_1700_ = 0.5f;
                    } else {
                        phi_1700_ = _e545;
                    }
                    let _e566 = phi_1700_;
                    phi_1708_ = evaluate_Verdict(_e566, true);
                } else {
                    if (_e545 > 0.5f) {
                        phi_1706_ = 1f;
                    } else {
                        phi_1706_ = 0f;
                    }
                    let _e570 = phi_1706_;
                    phi_1708_ = evaluate_Verdict(_e570, false);
                }
                let _e573 = phi_1708_;
                phi_1713_ = evaluate_Verdict(_e573.visibility, _e573.is_doubted);
            } else {
                phi_1713_ = evaluate_Verdict(0.5f, true);
            }
            let _e579 = phi_1713_;
            phi_1714_ = _e579;
        }
        let _e581 = phi_1714_;
        visibility.member[_e55.first_primitive] = _e581.visibility;
        phi_1718_ = _e581.is_doubted;
        phi_1719_ = _e55.first_primitive;
    } else {
        phi_1718_ = false;
        phi_1719_ = 0u;
    }
    let _e586 = phi_1718_;
    let _e588 = phi_1719_;
    if (_e42 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e586 {
        let _e592 = atomicAdd((&shared_[0u]), 1u);
        phi_1730_ = _e592;
    } else {
        phi_1730_ = 0u;
    }
    let _e594 = phi_1730_;
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
fn entry_evaluate_evaluate_ltt_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
