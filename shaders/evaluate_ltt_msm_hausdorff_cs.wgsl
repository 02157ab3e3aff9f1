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
    var phi_712_: f32;
    var phi_727_: f32;
    var phi_729_: lt_bvh_slab_Span;
    var phi_787_: f32;
    var phi_788_: f32;
    var phi_789_: f32;
    var phi_790_: f32;
    var phi_791_: f32;
    var phi_792_: bool;
    var phi_796_: f32;
    var phi_806_: bool;
    var phi_819_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_834_: bool;
    var phi_835_: bool;
    var phi_836_: bool;
    var phi_840_: bool;
    var phi_891_: f32;
    var phi_892_: f32;
    var phi_893_: f32;
    var phi_910_: f32;
    var phi_911_: f32;
    var phi_912_: f32;
    var phi_929_: f32;
    var phi_930_: f32;
    var phi_931_: f32;
    var phi_948_: f32;
    var phi_949_: f32;
    var phi_950_: f32;
    var phi_973_: f32;
    var phi_974_: f32;
    var phi_975_: f32;
    var phi_1062_: f32;
    var phi_1063_: f32;
    var phi_1074_: bool;
    var phi_1078_: f32;
    var phi_1079_: f32;
    var phi_1094_: f32;
    var phi_1095_: f32;
    var phi_1096_: f32;
    var phi_1097_: f32;
    var phi_1098_: f32;
    var phi_1099_: f32;
    var phi_1100_: f32;
    var phi_1101_: bool;
    var phi_1102_: f32;
    var phi_1103_: f32;
    var phi_1104_: bool;
    var phi_1108_: f32;

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
        phi_1102_ = _e121;
        phi_1103_ = f32();
        phi_1104_ = true;
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
            phi_1099_ = 1f;
            phi_1100_ = f32();
            phi_1101_ = true;
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
                phi_1097_ = _e501;
                phi_1098_ = f32();
            } else {
                let _e503 = ((0.5f * -(((((((((_e207 * (_e107 + _e108)) + (_e211 * (_e107 + _e109))) + (_e235 * (_e107 + _e153))) + (_e247 * (_e107 + _e154))) + ((((_e208 * (_e108 + _e109)) + (_e212 * (_e108 + _e110))) + (_e236 * (_e108 + _e153))) + (_e248 * (_e108 + _e154)))) + ((((_e209 * (_e109 + _e110)) + (_e213 * (_e109 + _e107))) + (_e237 * (_e109 + _e153))) + (_e249 * (_e109 + _e154)))) + ((((_e210 * (_e110 + _e107)) + (_e214 * (_e110 + _e108))) + (_e238 * (_e110 + _e153))) + (_e250 * (_e110 + _e154)))) + (_e421 * (_e153 + _e154))))) / _e424);
                let _e504 = ((((((((_e207 + _e211) + _e235) + _e247) + (((_e208 + _e212) + _e236) + _e248)) + (((_e209 + _e213) + _e237) + _e249)) + (((_e210 + _e214) + _e238) + _e250)) + _e421) / _e424);
                let _e506 = ((_e503 * _e503) - _e504);
                if (_e506 > 0f) {
                    phi_712_ = sqrt(_e506);
                } else {
                    phi_712_ = 0f;
                }
                let _e510 = phi_712_;
                if (_e503 > 0f) {
                    let _e513 = (-(_e503) - _e510);
                    phi_729_ = lt_bvh_slab_Span(_e513, (_e504 / _e513));
                } else {
                    let _e516 = (_e510 - _e503);
                    if (_e516 > 0f) {
                        phi_727_ = (_e504 / _e516);
                    } else {
                        phi_727_ = 0f;
                    }
                    let _e520 = phi_727_;
                    phi_729_ = lt_bvh_slab_Span(_e520, _e516);
                }
                let _e523 = phi_729_;
                if (_e523.near >= 0f) {
                    phi_790_ = 1f;
                    phi_791_ = f32();
                    phi_792_ = true;
                } else {
                    let _e527 = (_e523.far <= 0f);
                    if _e527 {
                        phi_788_ = (_e418 / _e424);
                        phi_789_ = f32();
                    } else {
                        let _e538 = (((((_e146 * _e107) + (_e148 * _e108)) + (_e150 * _e109)) + (_e152 * _e110)) + (_e143 * (_e153 + _e154)));
                        let _e554 = (((((_e146 * (_e107 * _e107)) + (_e148 * (_e108 * _e108))) + (_e150 * (_e109 * _e109))) + (_e152 * (_e110 * _e110))) + (_e143 * ((_e153 * _e153) + (_e154 * _e154))));
                        if (-(_e523.near) <= _e523.far) {
                            phi_787_ = (1f - (((_e523.near * _e523.near) * ((_e523.far * _e554) - _e538)) / (_e523.far - _e523.near)));
                        } else {
                            phi_787_ = ((_e418 / _e424) + (((_e523.far * _e523.far) * (_e538 - (_e523.near * _e554))) / (_e523.far - _e523.near)));
                        }
                        let _e573 = phi_787_;
                        phi_788_ = f32();
                        phi_789_ = _e573;
                    }
                    let _e575 = phi_788_;
                    let _e577 = phi_789_;
                    phi_790_ = _e575;
                    phi_791_ = _e577;
                    phi_792_ = _e527;
                }
                let _e579 = phi_790_;
                let _e581 = phi_791_;
                let _e583 = phi_792_;
                if _e583 {
                    phi_796_ = _e579;
                } else {
                    phi_796_ = _e581;
                }
                let _e585 = phi_796_;
                if ((_e523.near * _e153) >= (1f - 0.00001f)) {
                    phi_806_ = true;
                } else {
                    phi_806_ = ((_e523.near * _e154) >= (1f - 0.00001f));
                }
                let _e593 = phi_806_;
                if _e593 {
                    if ((_e523.far * _e153) >= (1f - 0.00001f)) {
                        phi_819_ = true;
                    } else {
                        phi_819_ = ((_e523.far * _e154) >= (1f - 0.00001f));
                    }
                    let _e601 = phi_819_;
                    if _e601 {
                        phi_823_ = false;
                    } else {
                        phi_823_ = true;
                    }
                    let _e603 = phi_823_;
                    phi_824_ = _e603;
                } else {
                    phi_824_ = true;
                }
                let _e605 = phi_824_;
                if _e605 {
                    let _e607 = (-(_e153) < 0.0001f);
                    if _e607 {
                        phi_834_ = bool();
                    } else {
                        phi_834_ = (_e154 < 0.0001f);
                    }
                    let _e610 = phi_834_;
                    phi_835_ = _e610;
                    phi_836_ = _e607;
                } else {
                    phi_835_ = bool();
                    phi_836_ = true;
                }
                let _e612 = phi_835_;
                let _e614 = phi_836_;
                if _e614 {
                    phi_840_ = true;
                } else {
                    phi_840_ = _e612;
                }
                let _e616 = phi_840_;
                if !(_e616) {
                    let _e622 = ((_e146 * _e70) * _e156);
                    let _e623 = ((_e148 * _e82) * _e158);
                    let _e624 = ((_e150 * _e94) * _e160);
                    let _e625 = ((_e152 * _e106) * _e162);
                    let _e643 = ((((_e622 * (_e107 * _e107)) + (_e623 * (_e108 * _e108))) + (_e624 * (_e109 * _e109))) + (_e625 * (_e110 * _e110)));
                    if (_e643 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e107) & 2147483647u) > 2139095040u) {
                            phi_893_ = _e107;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_892_ = 0f;
                            } else {
                                if (_e107 < 0f) {
                                    phi_891_ = 0f;
                                } else {
                                    phi_891_ = 1f;
                                }
                                let _e653 = phi_891_;
                                phi_892_ = _e653;
                            }
                            let _e655 = phi_892_;
                            phi_893_ = _e655;
                        }
                        let _e657 = phi_893_;
                        if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
                            phi_912_ = _e108;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_911_ = 0f;
                            } else {
                                if (_e108 < 0f) {
                                    phi_910_ = 0f;
                                } else {
                                    phi_910_ = 1f;
                                }
                                let _e666 = phi_910_;
                                phi_911_ = _e666;
                            }
                            let _e668 = phi_911_;
                            phi_912_ = _e668;
                        }
                        let _e670 = phi_912_;
                        if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                            phi_931_ = _e109;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_930_ = 0f;
                            } else {
                                if (_e109 < 0f) {
                                    phi_929_ = 0f;
                                } else {
                                    phi_929_ = 1f;
                                }
                                let _e679 = phi_929_;
                                phi_930_ = _e679;
                            }
                            let _e681 = phi_930_;
                            phi_931_ = _e681;
                        }
                        let _e683 = phi_931_;
                        if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                            phi_950_ = _e110;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_949_ = 0f;
                            } else {
                                if (_e110 < 0f) {
                                    phi_948_ = 0f;
                                } else {
                                    phi_948_ = 1f;
                                }
                                let _e692 = phi_948_;
                                phi_949_ = _e692;
                            }
                            let _e694 = phi_949_;
                            phi_950_ = _e694;
                        }
                        let _e696 = phi_950_;
                        let _e704 = (((((_e657 * _e146) + (_e670 * _e148)) + (_e683 * _e150)) + (_e696 * _e152)) + _e143);
                        if ((bitcast<u32>(_e704) & 2147483647u) > 2139095040u) {
                            phi_975_ = _e704;
                        } else {
                            if (_e704 < 0f) {
                                phi_974_ = 0f;
                            } else {
                                if (_e704 > 1f) {
                                    phi_973_ = 1f;
                                } else {
                                    phi_973_ = _e704;
                                }
                                let _e711 = phi_973_;
                                phi_974_ = _e711;
                            }
                            let _e713 = phi_974_;
                            phi_975_ = _e713;
                        }
                        let _e715 = phi_975_;
                        phi_1063_ = _e715;
                    } else {
                        let _e716 = (((((_e622 * _e107) + (_e623 * _e108)) + (_e624 * _e109)) + (_e625 * _e110)) / _e643);
                        let _e733 = ((_e146 * _e107) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e716 * _e107)));
                        let _e734 = ((_e148 * _e108) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e716 * _e108)));
                        let _e735 = ((_e150 * _e109) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e716 * _e109)));
                        let _e736 = ((_e152 * _e110) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e716 * _e110)));
                        if (_e716 > 0f) {
                            phi_1062_ = ((1f - _e143) - (((((_e733 * _e156) + (_e734 * _e158)) + (_e735 * _e160)) + (_e736 * _e162)) / (_e153 * (1f - (_e153 * _e716)))));
                        } else {
                            phi_1062_ = ((((((((_e622 * ((_e623 * _e167) + ((0.5f * _e624) * _e175))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e623 * ((_e624 * _e168) + ((0.5f * _e625) * _e176))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e624 * ((_e625 * _e169) + ((0.5f * _e622) * _e177))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e625 * ((_e622 * _e170) + ((0.5f * _e623) * _e178))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e643 * (-(_e153) * _e154))) + _e143) + (((((_e733 * _e70) + (_e734 * _e82)) + (_e735 * _e94)) + (_e736 * _e106)) / (_e154 * (1f - (_e716 * _e154)))));
                        }
                        let _e800 = phi_1062_;
                        phi_1063_ = _e800;
                    }
                    let _e802 = phi_1063_;
                    if ((bitcast<u32>(_e585) & 2147483647u) > 2139095040u) {
                        phi_1074_ = true;
                    } else {
                        let _e806 = (_e585 < _e802);
                        if _e806 {
                        }
                        phi_1074_ = _e806;
                    }
                    let _e808 = phi_1074_;
                    if _e808 {
                        phi_1078_ = _e585;
                    } else {
                        phi_1078_ = _e802;
                    }
                    let _e810 = phi_1078_;
                    phi_1079_ = _e810;
                } else {
                    phi_1079_ = _e585;
                }
                let _e812 = phi_1079_;
                if ((bitcast<u32>(_e812) & 2147483647u) > 2139095040u) {
                    phi_1096_ = _e812;
                } else {
                    if (_e812 < 0f) {
                        phi_1095_ = 0f;
                    } else {
                        if (_e812 > 1f) {
                            phi_1094_ = 1f;
                        } else {
                            phi_1094_ = _e812;
                        }
                        let _e819 = phi_1094_;
                        phi_1095_ = _e819;
                    }
                    let _e821 = phi_1095_;
                    phi_1096_ = _e821;
                }
                let _e823 = phi_1096_;
                phi_1097_ = f32();
                phi_1098_ = _e823;
            }
            let _e825 = phi_1097_;
            let _e827 = phi_1098_;
            phi_1099_ = _e825;
            phi_1100_ = _e827;
            phi_1101_ = _e430;
        }
        let _e829 = phi_1099_;
        let _e831 = phi_1100_;
        let _e833 = phi_1101_;
        phi_1102_ = _e829;
        phi_1103_ = _e831;
        phi_1104_ = _e833;
    }
    let _e835 = phi_1102_;
    let _e837 = phi_1103_;
    let _e839 = phi_1104_;
    if _e839 {
        phi_1108_ = _e835;
    } else {
        phi_1108_ = _e837;
    }
    let _e841 = phi_1108_;
    return _e841;
}

fn function_() {
    var local_1: f32;
    var phi_1159_: bool;
    var phi_1160_: bool;
    var phi_1161_: bool;
    var phi_1162_: bool;
    var phi_1166_: bool;
    var phi_1236_: bool;
    var phi_1237_: bool;
    var phi_1248_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1249_: bool;
    var phi_1250_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1251_: bool;
    var phi_1258_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1262_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1336_: bool;
    var phi_1345_: bool;
    var phi_1354_: bool;
    var phi_1355_: bool;
    var phi_1356_: bool;
    var phi_1357_: bool;
    var phi_1358_: bool;
    var phi_1359_: bool;
    var phi_1360_: bool;
    var phi_1364_: bool;
    var phi_1454_: f32;
    var phi_1457_: f32;
    var phi_1486_: f32;
    var phi_1491_: f32;
    var phi_1492_: bool;
    var phi_1493_: f32;
    var phi_1494_: bool;
    var phi_1498_: f32;
    var phi_1518_: f32;
    var phi_1523_: f32;
    var phi_1524_: bool;
    var phi_1525_: f32;
    var phi_1526_: bool;
    var phi_1530_: f32;
    var phi_1578_: i32;
    var phi_1583_: i32;
    var phi_1588_: i32;
    var phi_1593_: i32;
    var phi_1602_: i32;
    var phi_1607_: i32;
    var phi_1612_: i32;
    var phi_1617_: i32;
    var phi_1668_: bool;
    var phi_1676_: bool;
    var phi_1688_: bool;
    var phi_1689_: bool;
    var phi_1693_: f32;
    var phi_1699_: f32;
    var phi_1701_: evaluate_Verdict;
    var phi_1706_: evaluate_Verdict;
    var phi_1707_: evaluate_Verdict;
    var phi_1711_: bool;
    var phi_1712_: u32;
    var phi_1723_: u32;

    let _e43 = id_1;
    let _e44 = local_2;
    let _e49 = arrayLength((&map.member));
    let _e54 = p.member.size[0u];
    let _e56 = p.member.size[1u];
    let _e57 = lt_shaders_entry_pixel_index(_e43, _e54, _e56);
    if (bitcast<i32>(_e57.root) != 0i) {
        let _e64 = p.member.projection;
        let _e65 = lt_math_OneLevel(_e64);
        let _e69 = samples.member[_e57.first_primitive].normal[0u];
        let _e71 = global[0u];
        if (_e69 == _e71) {
            let _e74 = samples.member[_e57.first_primitive].normal[1u];
            let _e76 = global[1u];
            if (_e74 == _e76) {
                let _e79 = samples.member[_e57.first_primitive].normal[2u];
                let _e81 = global[2u];
                phi_1159_ = (_e79 == _e81);
                phi_1160_ = false;
            } else {
                phi_1159_ = bool();
                phi_1160_ = true;
            }
            let _e84 = phi_1159_;
            let _e86 = phi_1160_;
            phi_1161_ = _e84;
            phi_1162_ = _e86;
        } else {
            phi_1161_ = bool();
            phi_1162_ = true;
        }
        let _e88 = phi_1161_;
        let _e90 = phi_1162_;
        if _e90 {
            phi_1166_ = false;
        } else {
            phi_1166_ = _e88;
        }
        let _e92 = phi_1166_;
        if !(_e92) {
            let _e95 = samples.member[_e57.first_primitive].position;
            let _e97 = p.member.light.place;
            let _e103 = p.member.light.place[3u];
            let _e110 = (_e97.x - (_e95.x * _e103));
            let _e111 = (_e97.y - (_e95.y * _e103));
            let _e112 = (_e97.z - (_e95.z * _e103));
            let _e114 = samples.member[_e57.first_primitive].normal;
            if ((((_e114.x * _e110) + (_e114.y * _e111)) + (_e114.z * _e112)) > 0f) {
                let _e128 = (((_e110 * _e110) + (_e111 * _e111)) + (_e112 * _e112));
                let _e130 = p.member.light.axis;
                let _e142 = p.member.light.place[3u];
                if (_e142 == 0f) {
                    phi_1237_ = true;
                } else {
                    let _e145 = p.member.light.range_squared;
                    if (_e128 <= _e145) {
                        let _e148 = p.member.light.cos_outer;
                        phi_1236_ = (-((((_e110 * _e130.x) + (_e111 * _e130.y)) + (_e112 * _e130.z))) >= (_e148 * sqrt(_e128)));
                    } else {
                        phi_1236_ = false;
                    }
                    let _e153 = phi_1236_;
                    phi_1237_ = _e153;
                }
                let _e155 = phi_1237_;
                if _e155 {
                    let _e157 = samples.member[_e57.first_primitive].flags;
                    let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e165.unnamed.visibility, false), _e165.unnamed_1);
                    phi_1248_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e171.unnamed, ((_e157 & 1u) == 0u));
                    phi_1249_ = false;
                } else {
                    phi_1248_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1249_ = true;
                }
                let _e176 = phi_1248_;
                let _e178 = phi_1249_;
                phi_1250_ = _e176;
                phi_1251_ = _e178;
            } else {
                phi_1250_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1251_ = true;
            }
            let _e180 = phi_1250_;
            let _e182 = phi_1251_;
            if _e182 {
                let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e188.unnamed.visibility, false), _e188.unnamed_1);
                phi_1258_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e194.unnamed, true);
            } else {
                phi_1258_ = _e180;
            }
            let _e199 = phi_1258_;
            phi_1262_ = _e199;
        } else {
            let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
            phi_1262_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
        }
        let _e216 = phi_1262_;
        if _e216.unnamed_1 {
            phi_1707_ = evaluate_Verdict(_e216.unnamed.visibility, _e216.unnamed.is_doubted);
        } else {
            let _e224 = samples.member[_e57.first_primitive].position;
            let _e242 = ((((_e65.projection.row_w.x * _e224.x) + (_e65.projection.row_w.y * _e224.y)) + (_e65.projection.row_w.z * _e224.z)) + (_e65.projection.row_w.w * 1f));
            let _e256 = (((((_e65.projection.row_x.x * _e224.x) + (_e65.projection.row_x.y * _e224.y)) + (_e65.projection.row_x.z * _e224.z)) + (_e65.projection.row_x.w * 1f)) / _e242);
            let _e270 = (((((_e65.projection.row_y.x * _e224.x) + (_e65.projection.row_y.y * _e224.y)) + (_e65.projection.row_y.z * _e224.z)) + (_e65.projection.row_y.w * 1f)) / _e242);
            let _e283 = ((((_e65.projection.row_z.x * _e224.x) + (_e65.projection.row_z.y * _e224.y)) + (_e65.projection.row_z.z * _e224.z)) + (_e65.projection.row_z.w * 1f));
            if (_e242 > 0f) {
                if (_e256 >= 0f) {
                    phi_1336_ = (_e256 <= 1f);
                } else {
                    phi_1336_ = false;
                }
                let _e288 = phi_1336_;
                if _e288 {
                    if (_e270 >= 0f) {
                        phi_1345_ = (_e270 <= 1f);
                    } else {
                        phi_1345_ = false;
                    }
                    let _e292 = phi_1345_;
                    if _e292 {
                        if (_e283 >= 0f) {
                            phi_1354_ = (_e283 <= 1f);
                        } else {
                            phi_1354_ = false;
                        }
                        let _e296 = phi_1354_;
                        phi_1355_ = _e296;
                        phi_1356_ = false;
                    } else {
                        phi_1355_ = bool();
                        phi_1356_ = true;
                    }
                    let _e298 = phi_1355_;
                    let _e300 = phi_1356_;
                    phi_1357_ = _e298;
                    phi_1358_ = _e300;
                } else {
                    phi_1357_ = bool();
                    phi_1358_ = true;
                }
                let _e302 = phi_1357_;
                let _e304 = phi_1358_;
                phi_1359_ = _e302;
                phi_1360_ = _e304;
            } else {
                phi_1359_ = bool();
                phi_1360_ = true;
            }
            let _e306 = phi_1359_;
            let _e308 = phi_1360_;
            if _e308 {
                phi_1364_ = false;
            } else {
                phi_1364_ = _e306;
            }
            let _e310 = phi_1364_;
            if _e310 {
                if (0f > 0f) {
                    let _e313 = samples.member[_e57.first_primitive].normal;
                    let _e315 = p.member.map_size;
                    let _e385 = ((abs(((((_e64.row_x.x * _e313.x) + (_e64.row_x.y * _e313.y)) + (_e64.row_x.z * _e313.z)) / (((_e64.row_x.x * _e64.row_x.x) + (_e64.row_x.y * _e64.row_x.y)) + (_e64.row_x.z * _e64.row_x.z)))) + abs(((((_e64.row_y.x * _e313.x) + (_e64.row_y.y * _e313.y)) + (_e64.row_y.z * _e313.z)) / (((_e64.row_y.x * _e64.row_y.x) + (_e64.row_y.y * _e64.row_y.y)) + (_e64.row_y.z * _e64.row_y.z))))) / (abs(((((_e64.row_z.x * _e313.x) + (_e64.row_z.y * _e313.y)) + (_e64.row_z.z * _e313.z)) / (((_e64.row_z.x * _e64.row_z.x) + (_e64.row_z.y * _e64.row_z.y)) + (_e64.row_z.z * _e64.row_z.z)))) * f32(_e315)));
                    if (_e385 < 0.002f) {
                        phi_1454_ = _e385;
                    } else {
                        phi_1454_ = 0.002f;
                    }
                    let _e388 = phi_1454_;
                    phi_1457_ = (_e283 - (0f * _e388));
                } else {
                    phi_1457_ = _e283;
                }
                let _e392 = phi_1457_;
                let _e394 = p.member.map_size;
                let _e395 = f32(_e394);
                let _e398 = ((_e256 * _e395) - 0.5f);
                let _e399 = ((_e270 * _e395) - 0.5f);
                if (_e398 > -8388608f) {
                    let _e411 = f32(select(0i, select(select(i32(_e398), i32(-2147483648), (_e398 < bitcast<f32>(3472883712u))), 2147483647i, (_e398 > bitcast<f32>(1325400063u))), (_e398 == _e398)));
                    if (_e411 > _e398) {
                        phi_1486_ = 1f;
                    } else {
                        phi_1486_ = 0f;
                    }
                    let _e414 = phi_1486_;
                    if (_e398 < 8388608f) {
                        phi_1491_ = (_e411 - _e414);
                        phi_1492_ = false;
                    } else {
                        phi_1491_ = f32();
                        phi_1492_ = true;
                    }
                    let _e417 = phi_1491_;
                    let _e419 = phi_1492_;
                    phi_1493_ = _e417;
                    phi_1494_ = _e419;
                } else {
                    phi_1493_ = f32();
                    phi_1494_ = true;
                }
                let _e421 = phi_1493_;
                let _e423 = phi_1494_;
                if _e423 {
                    phi_1498_ = _e398;
                } else {
                    phi_1498_ = _e421;
                }
                let _e425 = phi_1498_;
                if (_e399 > -8388608f) {
                    let _e437 = f32(select(0i, select(select(i32(_e399), i32(-2147483648), (_e399 < bitcast<f32>(3472883712u))), 2147483647i, (_e399 > bitcast<f32>(1325400063u))), (_e399 == _e399)));
                    if (_e437 > _e399) {
                        phi_1518_ = 1f;
                    } else {
                        phi_1518_ = 0f;
                    }
                    let _e440 = phi_1518_;
                    if (_e399 < 8388608f) {
                        phi_1523_ = (_e437 - _e440);
                        phi_1524_ = false;
                    } else {
                        phi_1523_ = f32();
                        phi_1524_ = true;
                    }
                    let _e443 = phi_1523_;
                    let _e445 = phi_1524_;
                    phi_1525_ = _e443;
                    phi_1526_ = _e445;
                } else {
                    phi_1525_ = f32();
                    phi_1526_ = true;
                }
                let _e447 = phi_1525_;
                let _e449 = phi_1526_;
                if _e449 {
                    phi_1530_ = _e399;
                } else {
                    phi_1530_ = _e447;
                }
                let _e451 = phi_1530_;
                let _e452 = (_e398 - _e425);
                let _e453 = (_e399 - _e451);
                let _e462 = select(0i, select(select(i32(_e425), i32(-2147483648), (_e425 < bitcast<f32>(3472883712u))), 2147483647i, (_e425 > bitcast<f32>(1325400063u))), (_e425 == _e425));
                let _e471 = select(0i, select(select(i32(_e451), i32(-2147483648), (_e451 < bitcast<f32>(3472883712u))), 2147483647i, (_e451 > bitcast<f32>(1325400063u))), (_e451 == _e451));
                let _e482 = p.member.test;
                let _e483 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e482);
                let _e485 = p.member.map_size;
                local_1 = _e483;
                let _e487 = ((0u * _e485) * _e485);
                let _e489 = (bitcast<i32>(_e485) - 1i);
                if (_e462 > 0i) {
                    phi_1578_ = _e462;
                } else {
                    phi_1578_ = 0i;
                }
                let _e492 = phi_1578_;
                if (_e471 > 0i) {
                    phi_1583_ = _e471;
                } else {
                    phi_1583_ = 0i;
                }
                let _e495 = phi_1583_;
                if (_e492 < _e489) {
                    phi_1588_ = _e492;
                } else {
                    phi_1588_ = _e489;
                }
                let _e498 = phi_1588_;
                if (_e495 < _e489) {
                    phi_1593_ = _e495;
                } else {
                    phi_1593_ = _e489;
                }
                let _e501 = phi_1593_;
                let _e502 = bitcast<u32>(_e498);
                let _e504 = (_e462 + 1i);
                let _e505 = (_e471 + 1i);
                if (_e504 > 0i) {
                    phi_1602_ = _e504;
                } else {
                    phi_1602_ = 0i;
                }
                let _e508 = phi_1602_;
                if (_e505 > 0i) {
                    phi_1607_ = _e505;
                } else {
                    phi_1607_ = 0i;
                }
                let _e511 = phi_1607_;
                if (_e508 < _e489) {
                    phi_1612_ = _e508;
                } else {
                    phi_1612_ = _e489;
                }
                let _e514 = phi_1612_;
                if (_e511 < _e489) {
                    phi_1617_ = _e511;
                } else {
                    phi_1617_ = _e489;
                }
                let _e517 = phi_1617_;
                let _e518 = bitcast<u32>(_e514);
                let _e520 = (bitcast<u32>(_e501) * _e485);
                let _e521 = (bitcast<u32>(_e517) * _e485);
                let _e526 = ((_e520 + _e502) + _e487);
                let _e527 = ((_e520 + _e518) + _e487);
                let _e528 = ((_e521 + _e502) + _e487);
                let _e529 = ((_e521 + _e518) + _e487);
                if (_e526 < _e49) {
                } else {
                    return;
                }
                let _e533 = map.member[(0u + _e526)];
                if (_e527 < _e49) {
                } else {
                    return;
                }
                let _e537 = map.member[(0u + _e527)];
                if (_e528 < _e49) {
                } else {
                    return;
                }
                let _e541 = map.member[(0u + _e528)];
                if (_e529 < _e49) {
                } else {
                    return;
                }
                let _e545 = map.member[(0u + _e529)];
                let _e547 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e533, _e537, _e541, _e545), vec4<f32>(((1f - _e452) * (1f - _e453)), (_e452 * (1f - _e453)), ((1f - _e452) * _e453), (_e452 * _e453)), _e392);
                let _e549 = p.member.epsilon;
                if (_e547 <= _e549) {
                    phi_1668_ = true;
                } else {
                    phi_1668_ = (_e547 >= (1f - _e549));
                }
                let _e554 = phi_1668_;
                if ((bitcast<u32>(_e547) & 2147483647u) > 2139095040u) {
                    phi_1676_ = true;
                } else {
                    phi_1676_ = !(_e554);
                }
                let _e560 = phi_1676_;
                if _e560 {
                    if (_e547 > 0f) {
                        if (_e547 < 1f) {
                            phi_1688_ = false;
                        } else {
                            phi_1688_ = true;
                        }
                        let _e564 = phi_1688_;
                        phi_1689_ = _e564;
                    } else {
                        phi_1689_ = true;
                    }
                    let _e566 = phi_1689_;
                    if _e566 {
                        phi_1693_ = 0.5f;
                    } else {
                        phi_1693_ = _e547;
                    }
                    let _e568 = phi_1693_;
                    phi_1701_ = evaluate_Verdict(_e568, true);
                } else {
                    if (_e547 > 0.5f) {
                        phi_1699_ = 1f;
                    } else {
                        phi_1699_ = 0f;
                    }
                    let _e572 = phi_1699_;
                    phi_1701_ = evaluate_Verdict(_e572, false);
                }
                let _e575 = phi_1701_;
                phi_1706_ = evaluate_Verdict(_e575.visibility, _e575.is_doubted);
            } else {
                phi_1706_ = evaluate_Verdict(0.5f, true);
            }
            let _e581 = phi_1706_;
            phi_1707_ = _e581;
        }
        let _e583 = phi_1707_;
        visibility.member[_e57.first_primitive] = _e583.visibility;
        phi_1711_ = _e583.is_doubted;
        phi_1712_ = _e57.first_primitive;
    } else {
        phi_1711_ = false;
        phi_1712_ = 0u;
    }
    let _e588 = phi_1711_;
    let _e590 = phi_1712_;
    if (_e44 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e588 {
        let _e594 = atomicAdd((&shared_[0u]), 1u);
        phi_1723_ = _e594;
    } else {
        phi_1723_ = 0u;
    }
    let _e596 = phi_1723_;
    workgroupBarrier();
    if (_e44 == 0u) {
        let _e600 = atomicLoad((&shared_[0u]));
        let _e601 = atomicAdd((&list.member[3u]), _e600);
        atomicStore((&shared_[1u]), _e601);
    }
    workgroupBarrier();
    if _e588 {
        let _e604 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e604) + _e596)]), _e590);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
