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

struct type_19 {
    member: array<abi_Sample>,
}

struct type_23 {
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

struct type_34 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct lt_bvh_slab_Span {
    near: f32,
    far: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_19;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_34;
@group(0) @binding(2) 
var<storage> map: type_23;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_23;
@group(0) @binding(4) 
var<storage> marks: type_9;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_152_: lt_bvh_traverse_Tree;
    var phi_153_: bool;
    var phi_154_: lt_bvh_traverse_Tree;
    var phi_155_: bool;
    var phi_160_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_152_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_153_ = false;
        } else {
            phi_152_ = lt_bvh_traverse_Tree();
            phi_153_ = true;
        }
        let _e55 = phi_152_;
        let _e57 = phi_153_;
        phi_154_ = _e55;
        phi_155_ = _e57;
    } else {
        phi_154_ = lt_bvh_traverse_Tree();
        phi_155_ = true;
    }
    let _e59 = phi_154_;
    let _e61 = phi_155_;
    if _e61 {
        phi_160_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_160_ = _e59;
    }
    let _e66 = phi_160_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_187_: f32;
    var phi_188_: f32;
    var phi_189_: f32;
    var phi_206_: f32;
    var phi_207_: f32;
    var phi_208_: f32;
    var phi_224_: f32;
    var phi_225_: f32;
    var phi_226_: f32;
    var phi_242_: f32;
    var phi_243_: f32;
    var phi_244_: f32;
    var phi_260_: f32;
    var phi_261_: f32;
    var phi_262_: f32;
    var phi_297_: bool;
    var phi_298_: bool;
    var phi_299_: bool;
    var phi_300_: bool;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_306_: bool;
    var phi_617_: f32;
    var phi_618_: f32;
    var phi_619_: f32;
    var phi_636_: f32;
    var phi_637_: f32;
    var phi_638_: f32;
    var phi_655_: f32;
    var phi_656_: f32;
    var phi_657_: f32;
    var phi_674_: f32;
    var phi_675_: f32;
    var phi_676_: f32;
    var phi_699_: f32;
    var phi_700_: f32;
    var phi_701_: f32;
    var phi_748_: f32;
    var phi_749_: f32;
    var phi_750_: f32;
    var phi_767_: f32;
    var phi_768_: f32;
    var phi_769_: f32;
    var phi_786_: f32;
    var phi_787_: f32;
    var phi_788_: f32;
    var phi_805_: f32;
    var phi_806_: f32;
    var phi_807_: f32;
    var phi_830_: f32;
    var phi_831_: f32;
    var phi_832_: f32;
    var phi_911_: bool;
    var phi_955_: f32;
    var phi_956_: f32;
    var phi_957_: bool;
    var phi_958_: f32;
    var phi_959_: bool;
    var phi_960_: f32;
    var phi_961_: bool;
    var phi_965_: f32;
    var phi_966_: f32;
    var phi_985_: f32;
    var phi_986_: f32;
    var phi_987_: f32;
    var phi_998_: f32;
    var phi_1013_: f32;
    var phi_1015_: lt_bvh_slab_Span;
    var phi_1073_: f32;
    var phi_1074_: f32;
    var phi_1075_: f32;
    var phi_1076_: f32;
    var phi_1077_: f32;
    var phi_1078_: bool;
    var phi_1082_: f32;
    var phi_1097_: f32;
    var phi_1098_: f32;
    var phi_1099_: f32;
    var phi_1100_: f32;
    var phi_1101_: f32;
    var phi_1102_: f32;
    var phi_1103_: f32;
    var phi_1104_: bool;
    var phi_1108_: f32;
    var phi_1109_: f32;
    var phi_1110_: bool;
    var phi_1111_: f32;
    var phi_1112_: f32;
    var phi_1113_: bool;
    var phi_1117_: f32;

    let _e46 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_189_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_188_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_187_ = 1f;
            } else {
                phi_187_ = param_7;
            }
            let _e53 = phi_187_;
            phi_188_ = _e53;
        }
        let _e55 = phi_188_;
        phi_189_ = _e55;
    }
    let _e57 = phi_189_;
    let _e58 = (_e57 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_208_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_207_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_206_ = 1f;
            } else {
                phi_206_ = param_5.x;
            }
            let _e66 = phi_206_;
            phi_207_ = _e66;
        }
        let _e68 = phi_207_;
        phi_208_ = _e68;
    }
    let _e70 = phi_208_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_226_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_225_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_224_ = 1f;
            } else {
                phi_224_ = param_5.y;
            }
            let _e78 = phi_224_;
            phi_225_ = _e78;
        }
        let _e80 = phi_225_;
        phi_226_ = _e80;
    }
    let _e82 = phi_226_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_244_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_243_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_242_ = 1f;
            } else {
                phi_242_ = param_5.z;
            }
            let _e90 = phi_242_;
            phi_243_ = _e90;
        }
        let _e92 = phi_243_;
        phi_244_ = _e92;
    }
    let _e94 = phi_244_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_262_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_261_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_260_ = 1f;
            } else {
                phi_260_ = param_5.w;
            }
            let _e102 = phi_260_;
            phi_261_ = _e102;
        }
        let _e104 = phi_261_;
        phi_262_ = _e104;
    }
    let _e106 = phi_262_;
    let _e107 = (_e70 - _e58);
    let _e108 = (_e82 - _e58);
    let _e109 = (_e94 - _e58);
    let _e110 = (_e106 - _e58);
    let _e121 = ((((_e107 * param_6.x) + (_e108 * param_6.y)) + (_e109 * param_6.z)) + (_e110 * param_6.w));
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_1111_ = _e121;
        phi_1112_ = f32();
        phi_1113_ = true;
    } else {
        if (_e107 >= 0f) {
            if (_e108 >= 0f) {
                if (_e109 >= 0f) {
                    phi_297_ = (_e110 >= 0f);
                    phi_298_ = false;
                } else {
                    phi_297_ = bool();
                    phi_298_ = true;
                }
                let _e130 = phi_297_;
                let _e132 = phi_298_;
                phi_299_ = _e130;
                phi_300_ = _e132;
            } else {
                phi_299_ = bool();
                phi_300_ = true;
            }
            let _e134 = phi_299_;
            let _e136 = phi_300_;
            phi_301_ = _e134;
            phi_302_ = _e136;
        } else {
            phi_301_ = bool();
            phi_302_ = true;
        }
        let _e138 = phi_301_;
        let _e140 = phi_302_;
        if _e140 {
            phi_306_ = false;
        } else {
            phi_306_ = _e138;
        }
        let _e142 = phi_306_;
        if _e142 {
            phi_1108_ = 1f;
            phi_1109_ = f32();
            phi_1110_ = true;
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
            if (_e424 < 0.0000000000000000000000000000000001f) {
                if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                    phi_619_ = _e107;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_618_ = 0f;
                    } else {
                        if (_e107 < 0f) {
                            phi_617_ = 0f;
                        } else {
                            phi_617_ = 1f;
                        }
                        let _e439 = phi_617_;
                        phi_618_ = _e439;
                    }
                    let _e441 = phi_618_;
                    phi_619_ = _e441;
                }
                let _e443 = phi_619_;
                if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                    phi_638_ = _e108;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_637_ = 0f;
                    } else {
                        if (_e108 < 0f) {
                            phi_636_ = 0f;
                        } else {
                            phi_636_ = 1f;
                        }
                        let _e452 = phi_636_;
                        phi_637_ = _e452;
                    }
                    let _e454 = phi_637_;
                    phi_638_ = _e454;
                }
                let _e456 = phi_638_;
                if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                    phi_657_ = _e109;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_656_ = 0f;
                    } else {
                        if (_e109 < 0f) {
                            phi_655_ = 0f;
                        } else {
                            phi_655_ = 1f;
                        }
                        let _e465 = phi_655_;
                        phi_656_ = _e465;
                    }
                    let _e467 = phi_656_;
                    phi_657_ = _e467;
                }
                let _e469 = phi_657_;
                if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                    phi_676_ = _e110;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_675_ = 0f;
                    } else {
                        if (_e110 < 0f) {
                            phi_674_ = 0f;
                        } else {
                            phi_674_ = 1f;
                        }
                        let _e478 = phi_674_;
                        phi_675_ = _e478;
                    }
                    let _e480 = phi_675_;
                    phi_676_ = _e480;
                }
                let _e482 = phi_676_;
                let _e490 = (((((_e443 * _e146) + (_e456 * _e148)) + (_e469 * _e150)) + (_e482 * _e152)) + _e143);
                if ((bitcast<u32>(_e490) & 2147483647u) > 2139095040u) {
                    phi_701_ = _e490;
                } else {
                    if (_e490 < 0f) {
                        phi_700_ = 0f;
                    } else {
                        if (_e490 > 1f) {
                            phi_699_ = 1f;
                        } else {
                            phi_699_ = _e490;
                        }
                        let _e497 = phi_699_;
                        phi_700_ = _e497;
                    }
                    let _e499 = phi_700_;
                    phi_701_ = _e499;
                }
                let _e501 = phi_701_;
                phi_1102_ = _e501;
                phi_1103_ = f32();
                phi_1104_ = true;
            } else {
                let _e506 = ((_e146 * _e70) * _e156);
                let _e507 = ((_e148 * _e82) * _e158);
                let _e508 = ((_e150 * _e94) * _e160);
                let _e509 = ((_e152 * _e106) * _e162);
                let _e516 = ((((_e506 * _e107) + (_e507 * _e108)) + (_e508 * _e109)) + (_e509 * _e110));
                let _e527 = ((((_e506 * (_e107 * _e107)) + (_e507 * (_e108 * _e108))) + (_e508 * (_e109 * _e109))) + (_e509 * (_e110 * _e110)));
                if (_e527 < 0.0000000000000000000000000000000001f) {
                    if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                        phi_750_ = _e107;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_749_ = 0f;
                        } else {
                            if (_e107 < 0f) {
                                phi_748_ = 0f;
                            } else {
                                phi_748_ = 1f;
                            }
                            let _e537 = phi_748_;
                            phi_749_ = _e537;
                        }
                        let _e539 = phi_749_;
                        phi_750_ = _e539;
                    }
                    let _e541 = phi_750_;
                    if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                        phi_769_ = _e108;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_768_ = 0f;
                        } else {
                            if (_e108 < 0f) {
                                phi_767_ = 0f;
                            } else {
                                phi_767_ = 1f;
                            }
                            let _e550 = phi_767_;
                            phi_768_ = _e550;
                        }
                        let _e552 = phi_768_;
                        phi_769_ = _e552;
                    }
                    let _e554 = phi_769_;
                    if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                        phi_788_ = _e109;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_787_ = 0f;
                        } else {
                            if (_e109 < 0f) {
                                phi_786_ = 0f;
                            } else {
                                phi_786_ = 1f;
                            }
                            let _e563 = phi_786_;
                            phi_787_ = _e563;
                        }
                        let _e565 = phi_787_;
                        phi_788_ = _e565;
                    }
                    let _e567 = phi_788_;
                    if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                        phi_807_ = _e110;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_806_ = 0f;
                        } else {
                            if (_e110 < 0f) {
                                phi_805_ = 0f;
                            } else {
                                phi_805_ = 1f;
                            }
                            let _e576 = phi_805_;
                            phi_806_ = _e576;
                        }
                        let _e578 = phi_806_;
                        phi_807_ = _e578;
                    }
                    let _e580 = phi_807_;
                    let _e588 = (((((_e541 * _e146) + (_e554 * _e148)) + (_e567 * _e150)) + (_e580 * _e152)) + _e143);
                    if ((bitcast<u32>(_e588) & 2147483647u) > 2139095040u) {
                        phi_832_ = _e588;
                    } else {
                        if (_e588 < 0f) {
                            phi_831_ = 0f;
                        } else {
                            if (_e588 > 1f) {
                                phi_830_ = 1f;
                            } else {
                                phi_830_ = _e588;
                            }
                            let _e595 = phi_830_;
                            phi_831_ = _e595;
                        }
                        let _e597 = phi_831_;
                        phi_832_ = _e597;
                    }
                    let _e599 = phi_832_;
                    phi_966_ = _e599;
                } else {
                    let _e601 = (_e527 - (_e153 * _e516));
                    let _e603 = ((_e154 * _e516) - _e527);
                    let _e608 = ((_e146 * _e107) * _e156);
                    let _e609 = ((_e148 * _e108) * _e158);
                    let _e610 = ((_e150 * _e109) * _e160);
                    let _e611 = ((_e152 * _e110) * _e162);
                    let _e637 = (_e143 + (((((_e608 * ((_e609 * _e167) + ((0.5f * _e610) * _e175))) + (_e609 * ((_e610 * _e168) + ((0.5f * _e611) * _e176)))) + (_e610 * ((_e611 * _e169) + ((0.5f * _e608) * _e177)))) + (_e611 * ((_e608 * _e170) + ((0.5f * _e609) * _e178)))) / (_e153 * _e601)));
                    let _e642 = ((_e146 * _e107) * _e70);
                    let _e643 = ((_e148 * _e108) * _e82);
                    let _e644 = ((_e150 * _e109) * _e94);
                    let _e645 = ((_e152 * _e110) * _e106);
                    let _e671 = (_e143 + (((((_e642 * ((_e643 * _e167) + ((0.5f * _e644) * _e175))) + (_e643 * ((_e644 * _e168) + ((0.5f * _e645) * _e176)))) + (_e644 * ((_e645 * _e169) + ((0.5f * _e642) * _e177)))) + (_e645 * ((_e642 * _e170) + ((0.5f * _e643) * _e178)))) / (_e154 * _e603)));
                    let _e672 = (_e516 > 0f);
                    if _e672 {
                        phi_911_ = (_e603 > 0f);
                    } else {
                        phi_911_ = (_e601 < 0f);
                    }
                    let _e676 = phi_911_;
                    if _e676 {
                        if (_e637 >= 0f) {
                            if (_e671 >= 0f) {
                                if _e672 {
                                    phi_955_ = (1f - _e637);
                                } else {
                                    phi_955_ = ((((((_e506 * ((_e507 * _e167) + ((0.5f * _e508) * _e175))) + (_e507 * ((_e508 * _e168) + ((0.5f * _e509) * _e176)))) + (_e508 * ((_e509 * _e169) + ((0.5f * _e506) * _e177)))) + (_e509 * ((_e506 * _e170) + ((0.5f * _e507) * _e178)))) / (_e527 * (-(_e153) * _e154))) + _e671);
                                }
                                let _e709 = phi_955_;
                                phi_956_ = _e709;
                                phi_957_ = false;
                            } else {
                                phi_956_ = f32();
                                phi_957_ = true;
                            }
                            let _e711 = phi_956_;
                            let _e713 = phi_957_;
                            phi_958_ = _e711;
                            phi_959_ = _e713;
                        } else {
                            phi_958_ = f32();
                            phi_959_ = true;
                        }
                        let _e715 = phi_958_;
                        let _e717 = phi_959_;
                        phi_960_ = _e715;
                        phi_961_ = _e717;
                    } else {
                        phi_960_ = f32();
                        phi_961_ = true;
                    }
                    let _e719 = phi_960_;
                    let _e721 = phi_961_;
                    if _e721 {
                        phi_965_ = 1f;
                    } else {
                        phi_965_ = _e719;
                    }
                    let _e723 = phi_965_;
                    phi_966_ = _e723;
                }
                let _e725 = phi_966_;
                let _e726 = (_e725 < 1f);
                if _e726 {
                    if ((bitcast<u32>(_e725) & 2147483647u) > 2139095040u) {
                        phi_987_ = _e725;
                    } else {
                        if (_e725 < 0f) {
                            phi_986_ = 0f;
                        } else {
                            if (_e725 > 1f) {
                                phi_985_ = 1f;
                            } else {
                                phi_985_ = _e725;
                            }
                            let _e733 = phi_985_;
                            phi_986_ = _e733;
                        }
                        let _e735 = phi_986_;
                        phi_987_ = _e735;
                    }
                    let _e737 = phi_987_;
                    phi_1100_ = _e737;
                    phi_1101_ = f32();
                } else {
                    let _e739 = ((0.5f * -(((((((((_e207 * (_e107 + _e108)) + (_e211 * (_e107 + _e109))) + (_e235 * (_e107 + _e153))) + (_e247 * (_e107 + _e154))) + ((((_e208 * (_e108 + _e109)) + (_e212 * (_e108 + _e110))) + (_e236 * (_e108 + _e153))) + (_e248 * (_e108 + _e154)))) + ((((_e209 * (_e109 + _e110)) + (_e213 * (_e109 + _e107))) + (_e237 * (_e109 + _e153))) + (_e249 * (_e109 + _e154)))) + ((((_e210 * (_e110 + _e107)) + (_e214 * (_e110 + _e108))) + (_e238 * (_e110 + _e153))) + (_e250 * (_e110 + _e154)))) + (_e421 * (_e153 + _e154))))) / _e424);
                    let _e740 = ((((((((_e207 + _e211) + _e235) + _e247) + (((_e208 + _e212) + _e236) + _e248)) + (((_e209 + _e213) + _e237) + _e249)) + (((_e210 + _e214) + _e238) + _e250)) + _e421) / _e424);
                    let _e742 = ((_e739 * _e739) - _e740);
                    if (_e742 > 0f) {
                        phi_998_ = sqrt(_e742);
                    } else {
                        phi_998_ = 0f;
                    }
                    let _e746 = phi_998_;
                    if (_e739 > 0f) {
                        let _e749 = (-(_e739) - _e746);
                        phi_1015_ = lt_bvh_slab_Span(_e749, (_e740 / _e749));
                    } else {
                        let _e752 = (_e746 - _e739);
                        if (_e752 > 0f) {
                            phi_1013_ = (_e740 / _e752);
                        } else {
                            phi_1013_ = 0f;
                        }
                        let _e756 = phi_1013_;
                        phi_1015_ = lt_bvh_slab_Span(_e756, _e752);
                    }
                    let _e759 = phi_1015_;
                    if (_e759.near >= 0f) {
                        phi_1076_ = 1f;
                        phi_1077_ = f32();
                        phi_1078_ = true;
                    } else {
                        let _e763 = (_e759.far <= 0f);
                        if _e763 {
                            phi_1074_ = (_e418 / _e424);
                            phi_1075_ = f32();
                        } else {
                            let _e774 = (((((_e146 * _e107) + (_e148 * _e108)) + (_e150 * _e109)) + (_e152 * _e110)) + (_e143 * (_e153 + _e154)));
                            let _e790 = (((((_e146 * (_e107 * _e107)) + (_e148 * (_e108 * _e108))) + (_e150 * (_e109 * _e109))) + (_e152 * (_e110 * _e110))) + (_e143 * ((_e153 * _e153) + (_e154 * _e154))));
                            if (-(_e759.near) <= _e759.far) {
                                phi_1073_ = (1f - (((_e759.near * _e759.near) * ((_e759.far * _e790) - _e774)) / (_e759.far - _e759.near)));
                            } else {
                                phi_1073_ = ((_e418 / _e424) + (((_e759.far * _e759.far) * (_e774 - (_e759.near * _e790))) / (_e759.far - _e759.near)));
                            }
                            let _e809 = phi_1073_;
                            phi_1074_ = f32();
                            phi_1075_ = _e809;
                        }
                        let _e811 = phi_1074_;
                        let _e813 = phi_1075_;
                        phi_1076_ = _e811;
                        phi_1077_ = _e813;
                        phi_1078_ = _e763;
                    }
                    let _e815 = phi_1076_;
                    let _e817 = phi_1077_;
                    let _e819 = phi_1078_;
                    if _e819 {
                        phi_1082_ = _e815;
                    } else {
                        phi_1082_ = _e817;
                    }
                    let _e821 = phi_1082_;
                    if ((bitcast<u32>(_e821) & 2147483647u) > 2139095040u) {
                        phi_1099_ = _e821;
                    } else {
                        if (_e821 < 0f) {
                            phi_1098_ = 0f;
                        } else {
                            if (_e821 > 1f) {
                                phi_1097_ = 1f;
                            } else {
                                phi_1097_ = _e821;
                            }
                            let _e828 = phi_1097_;
                            phi_1098_ = _e828;
                        }
                        let _e830 = phi_1098_;
                        phi_1099_ = _e830;
                    }
                    let _e832 = phi_1099_;
                    phi_1100_ = f32();
                    phi_1101_ = _e832;
                }
                let _e834 = phi_1100_;
                let _e836 = phi_1101_;
                phi_1102_ = _e834;
                phi_1103_ = _e836;
                phi_1104_ = _e726;
            }
            let _e838 = phi_1102_;
            let _e840 = phi_1103_;
            let _e842 = phi_1104_;
            if _e842 {
            }
            phi_1108_ = _e838;
            phi_1109_ = _e840;
            phi_1110_ = _e842;
        }
        let _e844 = phi_1108_;
        let _e846 = phi_1109_;
        let _e848 = phi_1110_;
        phi_1111_ = _e844;
        phi_1112_ = _e846;
        phi_1113_ = _e848;
    }
    let _e850 = phi_1111_;
    let _e852 = phi_1112_;
    let _e854 = phi_1113_;
    if _e854 {
        phi_1117_ = _e850;
    } else {
        phi_1117_ = _e852;
    }
    let _e856 = phi_1117_;
    return _e856;
}

fn function_() {
    var local: f32;
    var phi_1179_: bool;
    var phi_1180_: bool;
    var phi_1181_: bool;
    var phi_1182_: bool;
    var phi_1186_: bool;
    var phi_1256_: bool;
    var phi_1257_: bool;
    var phi_1268_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1269_: bool;
    var phi_1270_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1271_: bool;
    var phi_1278_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1282_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1356_: bool;
    var phi_1365_: bool;
    var phi_1374_: bool;
    var phi_1375_: bool;
    var phi_1376_: bool;
    var phi_1377_: bool;
    var phi_1378_: bool;
    var phi_1379_: bool;
    var phi_1380_: bool;
    var phi_1384_: bool;
    var phi_1474_: f32;
    var phi_1477_: f32;
    var phi_1506_: f32;
    var phi_1511_: f32;
    var phi_1512_: bool;
    var phi_1513_: f32;
    var phi_1514_: bool;
    var phi_1518_: f32;
    var phi_1538_: f32;
    var phi_1543_: f32;
    var phi_1544_: bool;
    var phi_1545_: f32;
    var phi_1546_: bool;
    var phi_1550_: f32;
    var phi_1600_: i32;
    var phi_1605_: i32;
    var phi_1610_: i32;
    var phi_1615_: i32;
    var phi_1624_: i32;
    var phi_1629_: i32;
    var phi_1634_: i32;
    var phi_1639_: i32;
    var phi_1694_: i32;
    var phi_1699_: i32;
    var phi_1704_: i32;
    var phi_1709_: i32;
    var phi_1728_: i32;
    var phi_1733_: i32;
    var phi_1738_: i32;
    var phi_1743_: i32;
    var phi_1762_: i32;
    var phi_1767_: i32;
    var phi_1772_: i32;
    var phi_1777_: i32;
    var phi_1796_: i32;
    var phi_1801_: i32;
    var phi_1806_: i32;
    var phi_1811_: i32;
    var phi_1889_: bool;
    var phi_1897_: bool;
    var phi_1909_: bool;
    var phi_1910_: bool;
    var phi_1914_: f32;
    var phi_1920_: f32;
    var phi_1922_: evaluate_Verdict;
    var phi_1932_: u32;
    var phi_1941_: f32;
    var phi_1943_: evaluate_Verdict;
    var phi_1944_: bool;
    var phi_1945_: evaluate_Verdict;
    var phi_1946_: bool;
    var phi_1951_: evaluate_Verdict;
    var phi_1956_: evaluate_Verdict;
    var phi_1957_: evaluate_Verdict;

    let _e43 = id_1;
    let _e50 = arrayLength((&map.member));
    let _e56 = arrayLength((&marks.member));
    let _e59 = p.member.size[0u];
    let _e61 = p.member.size[1u];
    let _e62 = lt_shaders_entry_pixel_index(_e43, _e59, _e61);
    if (bitcast<i32>(_e62.root) != 0i) {
        let _e68 = p.member.projection;
        if (_e62.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e72 = lt_math_OneLevel(_e68);
        let _e76 = samples.member[(0u + _e62.first_primitive)].normal[0u];
        let _e78 = global[0u];
        if (_e76 == _e78) {
            let _e81 = samples.member[(0u + _e62.first_primitive)].normal[1u];
            let _e83 = global[1u];
            if (_e81 == _e83) {
                let _e86 = samples.member[(0u + _e62.first_primitive)].normal[2u];
                let _e88 = global[2u];
                phi_1179_ = (_e86 == _e88);
                phi_1180_ = false;
            } else {
                phi_1179_ = bool();
                phi_1180_ = true;
            }
            let _e91 = phi_1179_;
            let _e93 = phi_1180_;
            phi_1181_ = _e91;
            phi_1182_ = _e93;
        } else {
            phi_1181_ = bool();
            phi_1182_ = true;
        }
        let _e95 = phi_1181_;
        let _e97 = phi_1182_;
        if _e97 {
            phi_1186_ = false;
        } else {
            phi_1186_ = _e95;
        }
        let _e99 = phi_1186_;
        if !(_e99) {
            let _e102 = samples.member[(0u + _e62.first_primitive)].position;
            let _e104 = p.member.light.place;
            let _e110 = p.member.light.place[3u];
            let _e117 = (_e104.x - (_e102.x * _e110));
            let _e118 = (_e104.y - (_e102.y * _e110));
            let _e119 = (_e104.z - (_e102.z * _e110));
            let _e121 = samples.member[(0u + _e62.first_primitive)].normal;
            if ((((_e121.x * _e117) + (_e121.y * _e118)) + (_e121.z * _e119)) > 0f) {
                let _e135 = (((_e117 * _e117) + (_e118 * _e118)) + (_e119 * _e119));
                let _e137 = p.member.light.axis;
                let _e149 = p.member.light.place[3u];
                if (_e149 == 0f) {
                    phi_1257_ = true;
                } else {
                    let _e152 = p.member.light.range_squared;
                    if (_e135 <= _e152) {
                        let _e155 = p.member.light.cos_outer;
                        phi_1256_ = (-((((_e117 * _e137.x) + (_e118 * _e137.y)) + (_e119 * _e137.z))) >= (_e155 * sqrt(_e135)));
                    } else {
                        phi_1256_ = false;
                    }
                    let _e160 = phi_1256_;
                    phi_1257_ = _e160;
                }
                let _e162 = phi_1257_;
                if _e162 {
                    let _e164 = samples.member[(0u + _e62.first_primitive)].flags;
                    let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e172.unnamed.visibility, false), _e172.unnamed_1);
                    phi_1268_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e178.unnamed, ((_e164 & 1u) == 0u));
                    phi_1269_ = false;
                } else {
                    phi_1268_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1269_ = true;
                }
                let _e183 = phi_1268_;
                let _e185 = phi_1269_;
                phi_1270_ = _e183;
                phi_1271_ = _e185;
            } else {
                phi_1270_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1271_ = true;
            }
            let _e187 = phi_1270_;
            let _e189 = phi_1271_;
            if _e189 {
                let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e195.unnamed.visibility, false), _e195.unnamed_1);
                phi_1278_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e201.unnamed, true);
            } else {
                phi_1278_ = _e187;
            }
            let _e206 = phi_1278_;
            phi_1282_ = _e206;
        } else {
            let _e212 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e212.unnamed.visibility, false), _e212.unnamed_1);
            phi_1282_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e218.unnamed, true);
        }
        let _e223 = phi_1282_;
        if _e223.unnamed_1 {
            phi_1957_ = evaluate_Verdict(_e223.unnamed.visibility, _e223.unnamed.is_doubted);
        } else {
            let _e231 = samples.member[(0u + _e62.first_primitive)].position;
            let _e249 = ((((_e72.projection.row_w.x * _e231.x) + (_e72.projection.row_w.y * _e231.y)) + (_e72.projection.row_w.z * _e231.z)) + (_e72.projection.row_w.w * 1f));
            let _e263 = (((((_e72.projection.row_x.x * _e231.x) + (_e72.projection.row_x.y * _e231.y)) + (_e72.projection.row_x.z * _e231.z)) + (_e72.projection.row_x.w * 1f)) / _e249);
            let _e277 = (((((_e72.projection.row_y.x * _e231.x) + (_e72.projection.row_y.y * _e231.y)) + (_e72.projection.row_y.z * _e231.z)) + (_e72.projection.row_y.w * 1f)) / _e249);
            let _e290 = ((((_e72.projection.row_z.x * _e231.x) + (_e72.projection.row_z.y * _e231.y)) + (_e72.projection.row_z.z * _e231.z)) + (_e72.projection.row_z.w * 1f));
            if (_e249 > 0f) {
                if (_e263 >= 0f) {
                    phi_1356_ = (_e263 <= 1f);
                } else {
                    phi_1356_ = false;
                }
                let _e295 = phi_1356_;
                if _e295 {
                    if (_e277 >= 0f) {
                        phi_1365_ = (_e277 <= 1f);
                    } else {
                        phi_1365_ = false;
                    }
                    let _e299 = phi_1365_;
                    if _e299 {
                        if (_e290 >= 0f) {
                            phi_1374_ = (_e290 <= 1f);
                        } else {
                            phi_1374_ = false;
                        }
                        let _e303 = phi_1374_;
                        phi_1375_ = _e303;
                        phi_1376_ = false;
                    } else {
                        phi_1375_ = bool();
                        phi_1376_ = true;
                    }
                    let _e305 = phi_1375_;
                    let _e307 = phi_1376_;
                    phi_1377_ = _e305;
                    phi_1378_ = _e307;
                } else {
                    phi_1377_ = bool();
                    phi_1378_ = true;
                }
                let _e309 = phi_1377_;
                let _e311 = phi_1378_;
                phi_1379_ = _e309;
                phi_1380_ = _e311;
            } else {
                phi_1379_ = bool();
                phi_1380_ = true;
            }
            let _e313 = phi_1379_;
            let _e315 = phi_1380_;
            if _e315 {
                phi_1384_ = false;
            } else {
                phi_1384_ = _e313;
            }
            let _e317 = phi_1384_;
            if _e317 {
                if (0f > 0f) {
                    let _e320 = samples.member[(0u + _e62.first_primitive)].normal;
                    let _e322 = p.member.map_size;
                    let _e392 = ((abs(((((_e68.row_x.x * _e320.x) + (_e68.row_x.y * _e320.y)) + (_e68.row_x.z * _e320.z)) / (((_e68.row_x.x * _e68.row_x.x) + (_e68.row_x.y * _e68.row_x.y)) + (_e68.row_x.z * _e68.row_x.z)))) + abs(((((_e68.row_y.x * _e320.x) + (_e68.row_y.y * _e320.y)) + (_e68.row_y.z * _e320.z)) / (((_e68.row_y.x * _e68.row_y.x) + (_e68.row_y.y * _e68.row_y.y)) + (_e68.row_y.z * _e68.row_y.z))))) / (abs(((((_e68.row_z.x * _e320.x) + (_e68.row_z.y * _e320.y)) + (_e68.row_z.z * _e320.z)) / (((_e68.row_z.x * _e68.row_z.x) + (_e68.row_z.y * _e68.row_z.y)) + (_e68.row_z.z * _e68.row_z.z)))) * f32(_e322)));
                    if (_e392 < 0.002f) {
                        phi_1474_ = _e392;
                    } else {
                        phi_1474_ = 0.002f;
                    }
                    let _e395 = phi_1474_;
                    phi_1477_ = (_e290 - (0f * _e395));
                } else {
                    phi_1477_ = _e290;
                }
                let _e399 = phi_1477_;
                let _e401 = p.member.map_size;
                let _e402 = f32(_e401);
                let _e405 = ((_e263 * _e402) - 0.5f);
                let _e406 = ((_e277 * _e402) - 0.5f);
                if (_e405 > -8388608f) {
                    let _e418 = f32(select(0i, select(select(i32(_e405), i32(-2147483648), (_e405 < bitcast<f32>(3472883712u))), 2147483647i, (_e405 > bitcast<f32>(1325400063u))), (_e405 == _e405)));
                    if (_e418 > _e405) {
                        phi_1506_ = 1f;
                    } else {
                        phi_1506_ = 0f;
                    }
                    let _e421 = phi_1506_;
                    if (_e405 < 8388608f) {
                        phi_1511_ = (_e418 - _e421);
                        phi_1512_ = false;
                    } else {
                        phi_1511_ = f32();
                        phi_1512_ = true;
                    }
                    let _e424 = phi_1511_;
                    let _e426 = phi_1512_;
                    phi_1513_ = _e424;
                    phi_1514_ = _e426;
                } else {
                    phi_1513_ = f32();
                    phi_1514_ = true;
                }
                let _e428 = phi_1513_;
                let _e430 = phi_1514_;
                if _e430 {
                    phi_1518_ = _e405;
                } else {
                    phi_1518_ = _e428;
                }
                let _e432 = phi_1518_;
                if (_e406 > -8388608f) {
                    let _e444 = f32(select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406)));
                    if (_e444 > _e406) {
                        phi_1538_ = 1f;
                    } else {
                        phi_1538_ = 0f;
                    }
                    let _e447 = phi_1538_;
                    if (_e406 < 8388608f) {
                        phi_1543_ = (_e444 - _e447);
                        phi_1544_ = false;
                    } else {
                        phi_1543_ = f32();
                        phi_1544_ = true;
                    }
                    let _e450 = phi_1543_;
                    let _e452 = phi_1544_;
                    phi_1545_ = _e450;
                    phi_1546_ = _e452;
                } else {
                    phi_1545_ = f32();
                    phi_1546_ = true;
                }
                let _e454 = phi_1545_;
                let _e456 = phi_1546_;
                if _e456 {
                    phi_1550_ = _e406;
                } else {
                    phi_1550_ = _e454;
                }
                let _e458 = phi_1550_;
                let _e459 = (_e405 - _e432);
                let _e460 = (_e406 - _e458);
                let _e469 = select(0i, select(select(i32(_e432), i32(-2147483648), (_e432 < bitcast<f32>(3472883712u))), 2147483647i, (_e432 > bitcast<f32>(1325400063u))), (_e432 == _e432));
                let _e478 = select(0i, select(select(i32(_e458), i32(-2147483648), (_e458 < bitcast<f32>(3472883712u))), 2147483647i, (_e458 > bitcast<f32>(1325400063u))), (_e458 == _e458));
                let _e489 = p.member.test;
                let _e490 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e489);
                let _e492 = p.member.map_size;
                local = _e490;
                let _e494 = ((0u * _e492) * _e492);
                let _e496 = (bitcast<i32>(_e492) - 1i);
                if (_e469 > 0i) {
                    phi_1600_ = _e469;
                } else {
                    phi_1600_ = 0i;
                }
                let _e499 = phi_1600_;
                if (_e478 > 0i) {
                    phi_1605_ = _e478;
                } else {
                    phi_1605_ = 0i;
                }
                let _e502 = phi_1605_;
                if (_e499 < _e496) {
                    phi_1610_ = _e499;
                } else {
                    phi_1610_ = _e496;
                }
                let _e505 = phi_1610_;
                if (_e502 < _e496) {
                    phi_1615_ = _e502;
                } else {
                    phi_1615_ = _e496;
                }
                let _e508 = phi_1615_;
                let _e509 = bitcast<u32>(_e505);
                let _e511 = (_e469 + 1i);
                let _e512 = (_e478 + 1i);
                if (_e511 > 0i) {
                    phi_1624_ = _e511;
                } else {
                    phi_1624_ = 0i;
                }
                let _e515 = phi_1624_;
                if (_e512 > 0i) {
                    phi_1629_ = _e512;
                } else {
                    phi_1629_ = 0i;
                }
                let _e518 = phi_1629_;
                if (_e515 < _e496) {
                    phi_1634_ = _e515;
                } else {
                    phi_1634_ = _e496;
                }
                let _e521 = phi_1634_;
                if (_e518 < _e496) {
                    phi_1639_ = _e518;
                } else {
                    phi_1639_ = _e496;
                }
                let _e524 = phi_1639_;
                let _e525 = bitcast<u32>(_e521);
                let _e527 = (bitcast<u32>(_e508) * _e492);
                let _e528 = (bitcast<u32>(_e524) * _e492);
                let _e533 = ((_e527 + _e509) + _e494);
                let _e534 = ((_e527 + _e525) + _e494);
                let _e535 = ((_e528 + _e509) + _e494);
                let _e536 = ((_e528 + _e525) + _e494);
                if (_e533 < _e50) {
                } else {
                    return;
                }
                let _e540 = map.member[(0u + _e533)];
                if (_e534 < _e50) {
                } else {
                    return;
                }
                let _e544 = map.member[(0u + _e534)];
                if (_e535 < _e50) {
                } else {
                    return;
                }
                let _e548 = map.member[(0u + _e535)];
                if (_e536 < _e50) {
                } else {
                    return;
                }
                let _e552 = map.member[(0u + _e536)];
                let _e554 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e540, _e544, _e548, _e552), vec4<f32>(((1f - _e459) * (1f - _e460)), (_e459 * (1f - _e460)), ((1f - _e459) * _e460), (_e459 * _e460)), _e399);
                let _e556 = p.member.map_size;
                let _e558 = (bitcast<i32>(_e556) - 1i);
                if (_e469 > 0i) {
                    phi_1694_ = _e469;
                } else {
                    phi_1694_ = 0i;
                }
                let _e561 = phi_1694_;
                if (_e478 > 0i) {
                    phi_1699_ = _e478;
                } else {
                    phi_1699_ = 0i;
                }
                let _e564 = phi_1699_;
                if (_e561 < _e558) {
                    phi_1704_ = _e561;
                } else {
                    phi_1704_ = _e558;
                }
                let _e567 = phi_1704_;
                if (_e564 < _e558) {
                    phi_1709_ = _e564;
                } else {
                    phi_1709_ = _e558;
                }
                let _e570 = phi_1709_;
                let _e571 = bitcast<u32>(_e567);
                let _e578 = ((((0u * _e556) + bitcast<u32>(_e570)) * (_e556 / 16u)) + (_e571 / 16u));
                let _e581 = (_e469 + 1i);
                let _e582 = (_e478 + 0i);
                let _e584 = (bitcast<i32>(_e556) - 1i);
                if (_e581 > 0i) {
                    phi_1728_ = _e581;
                } else {
                    phi_1728_ = 0i;
                }
                let _e587 = phi_1728_;
                if (_e582 > 0i) {
                    phi_1733_ = _e582;
                } else {
                    phi_1733_ = 0i;
                }
                let _e590 = phi_1733_;
                if (_e587 < _e584) {
                    phi_1738_ = _e587;
                } else {
                    phi_1738_ = _e584;
                }
                let _e593 = phi_1738_;
                if (_e590 < _e584) {
                    phi_1743_ = _e590;
                } else {
                    phi_1743_ = _e584;
                }
                let _e596 = phi_1743_;
                let _e597 = bitcast<u32>(_e593);
                let _e604 = ((((0u * _e556) + bitcast<u32>(_e596)) * (_e556 / 16u)) + (_e597 / 16u));
                let _e607 = (_e469 + 0i);
                let _e608 = (_e478 + 1i);
                let _e610 = (bitcast<i32>(_e556) - 1i);
                if (_e607 > 0i) {
                    phi_1762_ = _e607;
                } else {
                    phi_1762_ = 0i;
                }
                let _e613 = phi_1762_;
                if (_e608 > 0i) {
                    phi_1767_ = _e608;
                } else {
                    phi_1767_ = 0i;
                }
                let _e616 = phi_1767_;
                if (_e613 < _e610) {
                    phi_1772_ = _e613;
                } else {
                    phi_1772_ = _e610;
                }
                let _e619 = phi_1772_;
                if (_e616 < _e610) {
                    phi_1777_ = _e616;
                } else {
                    phi_1777_ = _e610;
                }
                let _e622 = phi_1777_;
                let _e623 = bitcast<u32>(_e619);
                let _e630 = ((((0u * _e556) + bitcast<u32>(_e622)) * (_e556 / 16u)) + (_e623 / 16u));
                let _e633 = (_e469 + 1i);
                let _e634 = (_e478 + 1i);
                let _e636 = (bitcast<i32>(_e556) - 1i);
                if (_e633 > 0i) {
                    phi_1796_ = _e633;
                } else {
                    phi_1796_ = 0i;
                }
                let _e639 = phi_1796_;
                if (_e634 > 0i) {
                    phi_1801_ = _e634;
                } else {
                    phi_1801_ = 0i;
                }
                let _e642 = phi_1801_;
                if (_e639 < _e636) {
                    phi_1806_ = _e639;
                } else {
                    phi_1806_ = _e636;
                }
                let _e645 = phi_1806_;
                if (_e642 < _e636) {
                    phi_1811_ = _e642;
                } else {
                    phi_1811_ = _e636;
                }
                let _e648 = phi_1811_;
                let _e649 = bitcast<u32>(_e645);
                let _e656 = ((((0u * _e556) + bitcast<u32>(_e648)) * (_e556 / 16u)) + (_e649 / 16u));
                if (_e578 < _e56) {
                } else {
                    return;
                }
                let _e662 = marks.member[(0u + _e578)];
                if (_e604 < _e56) {
                } else {
                    return;
                }
                let _e670 = marks.member[(0u + _e604)];
                if (_e630 < _e56) {
                } else {
                    return;
                }
                let _e679 = marks.member[(0u + _e630)];
                if (_e656 < _e56) {
                } else {
                    return;
                }
                let _e687 = marks.member[(0u + _e656)];
                let _e695 = p.member.epsilon;
                if (_e554 <= _e695) {
                    phi_1889_ = true;
                } else {
                    phi_1889_ = (_e554 >= (1f - _e695));
                }
                let _e700 = phi_1889_;
                if ((bitcast<u32>(_e554) & 2147483647u) > 2139095040u) {
                    phi_1897_ = true;
                } else {
                    phi_1897_ = !(_e700);
                }
                let _e706 = phi_1897_;
                if _e706 {
                    if (_e554 > 0f) {
                        if (_e554 < 1f) {
                            phi_1909_ = false;
                        } else {
                            phi_1909_ = true;
                        }
                        let _e710 = phi_1909_;
                        phi_1910_ = _e710;
                    } else {
                        phi_1910_ = true;
                    }
                    let _e712 = phi_1910_;
                    if _e712 {
                        phi_1914_ = 0.5f;
                    } else {
                        phi_1914_ = _e554;
                    }
                    let _e714 = phi_1914_;
                    phi_1922_ = evaluate_Verdict(_e714, true);
                } else {
                    if (_e554 > 0.5f) {
                        phi_1920_ = 1f;
                    } else {
                        phi_1920_ = 0f;
                    }
                    let _e718 = phi_1920_;
                    phi_1922_ = evaluate_Verdict(_e718, false);
                }
                let _e721 = phi_1922_;
                let _e724 = (_e721.visibility < 0.5f);
                if _e721.is_doubted {
                    phi_1945_ = evaluate_Verdict();
                    phi_1946_ = true;
                } else {
                    if _e724 {
                        phi_1932_ = 2u;
                    } else {
                        phi_1932_ = 1u;
                    }
                    let _e726 = phi_1932_;
                    if ((((((_e662 >> bitcast<u32>((((_e571 % 16u) * 2u) & 31u))) & 3u) | ((_e670 >> bitcast<u32>((((_e597 % 16u) * 2u) & 31u))) & 3u)) | (((_e679 >> bitcast<u32>((((_e623 % 16u) * 2u) & 31u))) & 3u) | ((_e687 >> bitcast<u32>((((_e649 % 16u) * 2u) & 31u))) & 3u))) & _e726) != 0u) {
                        if _e724 {
                            phi_1941_ = 0.000000059604645f;
                        } else {
                            phi_1941_ = 0.99999994f;
                        }
                        let _e730 = phi_1941_;
                        phi_1943_ = evaluate_Verdict(_e730, true);
                        phi_1944_ = false;
                    } else {
                        phi_1943_ = evaluate_Verdict();
                        phi_1944_ = true;
                    }
                    let _e733 = phi_1943_;
                    let _e735 = phi_1944_;
                    phi_1945_ = _e733;
                    phi_1946_ = _e735;
                }
                let _e737 = phi_1945_;
                let _e739 = phi_1946_;
                if _e739 {
                    phi_1951_ = evaluate_Verdict(_e721.visibility, _e721.is_doubted);
                } else {
                    phi_1951_ = _e737;
                }
                let _e742 = phi_1951_;
                phi_1956_ = evaluate_Verdict(_e742.visibility, _e742.is_doubted);
            } else {
                phi_1956_ = evaluate_Verdict(0.5f, true);
            }
            let _e748 = phi_1956_;
            phi_1957_ = _e748;
        }
        let _e750 = phi_1957_;
        if (_e62.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e62.first_primitive)] = _e750.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
