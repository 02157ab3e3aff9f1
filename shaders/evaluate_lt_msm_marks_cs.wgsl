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

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
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
    var phi_811_: f32;
    var phi_812_: f32;
    var phi_813_: f32;
    var phi_814_: f32;
    var phi_815_: f32;
    var phi_816_: f32;
    var phi_817_: f32;
    var phi_818_: bool;
    var phi_819_: f32;
    var phi_820_: f32;
    var phi_821_: bool;
    var phi_825_: f32;

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
        phi_819_ = _e121;
        phi_820_ = f32();
        phi_821_ = true;
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
            phi_816_ = 1f;
            phi_817_ = f32();
            phi_818_ = true;
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
                phi_814_ = _e501;
                phi_815_ = f32();
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
                if ((bitcast<u32>(_e585) & 2147483647u) > 2139095040u) {
                    phi_813_ = _e585;
                } else {
                    if (_e585 < 0f) {
                        phi_812_ = 0f;
                    } else {
                        if (_e585 > 1f) {
                            phi_811_ = 1f;
                        } else {
                            phi_811_ = _e585;
                        }
                        let _e592 = phi_811_;
                        phi_812_ = _e592;
                    }
                    let _e594 = phi_812_;
                    phi_813_ = _e594;
                }
                let _e596 = phi_813_;
                phi_814_ = f32();
                phi_815_ = _e596;
            }
            let _e598 = phi_814_;
            let _e600 = phi_815_;
            phi_816_ = _e598;
            phi_817_ = _e600;
            phi_818_ = _e430;
        }
        let _e602 = phi_816_;
        let _e604 = phi_817_;
        let _e606 = phi_818_;
        phi_819_ = _e602;
        phi_820_ = _e604;
        phi_821_ = _e606;
    }
    let _e608 = phi_819_;
    let _e610 = phi_820_;
    let _e612 = phi_821_;
    if _e612 {
        phi_825_ = _e608;
    } else {
        phi_825_ = _e610;
    }
    let _e614 = phi_825_;
    return _e614;
}

fn function_() {
    var local: f32;
    var phi_887_: bool;
    var phi_888_: bool;
    var phi_889_: bool;
    var phi_890_: bool;
    var phi_894_: bool;
    var phi_964_: bool;
    var phi_965_: bool;
    var phi_976_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_977_: bool;
    var phi_978_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_979_: bool;
    var phi_986_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_990_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1064_: bool;
    var phi_1073_: bool;
    var phi_1082_: bool;
    var phi_1083_: bool;
    var phi_1084_: bool;
    var phi_1085_: bool;
    var phi_1086_: bool;
    var phi_1087_: bool;
    var phi_1088_: bool;
    var phi_1092_: bool;
    var phi_1182_: f32;
    var phi_1185_: f32;
    var phi_1214_: f32;
    var phi_1219_: f32;
    var phi_1220_: bool;
    var phi_1221_: f32;
    var phi_1222_: bool;
    var phi_1226_: f32;
    var phi_1246_: f32;
    var phi_1251_: f32;
    var phi_1252_: bool;
    var phi_1253_: f32;
    var phi_1254_: bool;
    var phi_1258_: f32;
    var phi_1308_: i32;
    var phi_1313_: i32;
    var phi_1318_: i32;
    var phi_1323_: i32;
    var phi_1332_: i32;
    var phi_1337_: i32;
    var phi_1342_: i32;
    var phi_1347_: i32;
    var phi_1402_: i32;
    var phi_1407_: i32;
    var phi_1412_: i32;
    var phi_1417_: i32;
    var phi_1436_: i32;
    var phi_1441_: i32;
    var phi_1446_: i32;
    var phi_1451_: i32;
    var phi_1470_: i32;
    var phi_1475_: i32;
    var phi_1480_: i32;
    var phi_1485_: i32;
    var phi_1504_: i32;
    var phi_1509_: i32;
    var phi_1514_: i32;
    var phi_1519_: i32;
    var phi_1597_: bool;
    var phi_1605_: bool;
    var phi_1617_: bool;
    var phi_1618_: bool;
    var phi_1622_: f32;
    var phi_1628_: f32;
    var phi_1630_: evaluate_Verdict;
    var phi_1640_: u32;
    var phi_1649_: f32;
    var phi_1651_: evaluate_Verdict;
    var phi_1652_: bool;
    var phi_1653_: evaluate_Verdict;
    var phi_1654_: bool;
    var phi_1659_: evaluate_Verdict;
    var phi_1664_: evaluate_Verdict;
    var phi_1665_: evaluate_Verdict;

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
                phi_887_ = (_e86 == _e88);
                phi_888_ = false;
            } else {
                phi_887_ = bool();
                phi_888_ = true;
            }
            let _e91 = phi_887_;
            let _e93 = phi_888_;
            phi_889_ = _e91;
            phi_890_ = _e93;
        } else {
            phi_889_ = bool();
            phi_890_ = true;
        }
        let _e95 = phi_889_;
        let _e97 = phi_890_;
        if _e97 {
            phi_894_ = false;
        } else {
            phi_894_ = _e95;
        }
        let _e99 = phi_894_;
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
                    phi_965_ = true;
                } else {
                    let _e152 = p.member.light.range_squared;
                    if (_e135 <= _e152) {
                        let _e155 = p.member.light.cos_outer;
                        phi_964_ = (-((((_e117 * _e137.x) + (_e118 * _e137.y)) + (_e119 * _e137.z))) >= (_e155 * sqrt(_e135)));
                    } else {
                        phi_964_ = false;
                    }
                    let _e160 = phi_964_;
                    phi_965_ = _e160;
                }
                let _e162 = phi_965_;
                if _e162 {
                    let _e164 = samples.member[(0u + _e62.first_primitive)].flags;
                    let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e172.unnamed.visibility, false), _e172.unnamed_1);
                    phi_976_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e178.unnamed, ((_e164 & 1u) == 0u));
                    phi_977_ = false;
                } else {
                    phi_976_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_977_ = true;
                }
                let _e183 = phi_976_;
                let _e185 = phi_977_;
                phi_978_ = _e183;
                phi_979_ = _e185;
            } else {
                phi_978_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_979_ = true;
            }
            let _e187 = phi_978_;
            let _e189 = phi_979_;
            if _e189 {
                let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e195.unnamed.visibility, false), _e195.unnamed_1);
                phi_986_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e201.unnamed, true);
            } else {
                phi_986_ = _e187;
            }
            let _e206 = phi_986_;
            phi_990_ = _e206;
        } else {
            let _e212 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e212.unnamed.visibility, false), _e212.unnamed_1);
            phi_990_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e218.unnamed, true);
        }
        let _e223 = phi_990_;
        if _e223.unnamed_1 {
            phi_1665_ = evaluate_Verdict(_e223.unnamed.visibility, _e223.unnamed.is_doubted);
        } else {
            let _e231 = samples.member[(0u + _e62.first_primitive)].position;
            let _e249 = ((((_e72.projection.row_w.x * _e231.x) + (_e72.projection.row_w.y * _e231.y)) + (_e72.projection.row_w.z * _e231.z)) + (_e72.projection.row_w.w * 1f));
            let _e263 = (((((_e72.projection.row_x.x * _e231.x) + (_e72.projection.row_x.y * _e231.y)) + (_e72.projection.row_x.z * _e231.z)) + (_e72.projection.row_x.w * 1f)) / _e249);
            let _e277 = (((((_e72.projection.row_y.x * _e231.x) + (_e72.projection.row_y.y * _e231.y)) + (_e72.projection.row_y.z * _e231.z)) + (_e72.projection.row_y.w * 1f)) / _e249);
            let _e290 = ((((_e72.projection.row_z.x * _e231.x) + (_e72.projection.row_z.y * _e231.y)) + (_e72.projection.row_z.z * _e231.z)) + (_e72.projection.row_z.w * 1f));
            if (_e249 > 0f) {
                if (_e263 >= 0f) {
                    phi_1064_ = (_e263 <= 1f);
                } else {
                    phi_1064_ = false;
                }
                let _e295 = phi_1064_;
                if _e295 {
                    if (_e277 >= 0f) {
                        phi_1073_ = (_e277 <= 1f);
                    } else {
                        phi_1073_ = false;
                    }
                    let _e299 = phi_1073_;
                    if _e299 {
                        if (_e290 >= 0f) {
                            phi_1082_ = (_e290 <= 1f);
                        } else {
                            phi_1082_ = false;
                        }
                        let _e303 = phi_1082_;
                        phi_1083_ = _e303;
                        phi_1084_ = false;
                    } else {
                        phi_1083_ = bool();
                        phi_1084_ = true;
                    }
                    let _e305 = phi_1083_;
                    let _e307 = phi_1084_;
                    phi_1085_ = _e305;
                    phi_1086_ = _e307;
                } else {
                    phi_1085_ = bool();
                    phi_1086_ = true;
                }
                let _e309 = phi_1085_;
                let _e311 = phi_1086_;
                phi_1087_ = _e309;
                phi_1088_ = _e311;
            } else {
                phi_1087_ = bool();
                phi_1088_ = true;
            }
            let _e313 = phi_1087_;
            let _e315 = phi_1088_;
            if _e315 {
                phi_1092_ = false;
            } else {
                phi_1092_ = _e313;
            }
            let _e317 = phi_1092_;
            if _e317 {
                if (0f > 0f) {
                    let _e320 = samples.member[(0u + _e62.first_primitive)].normal;
                    let _e322 = p.member.map_size;
                    let _e392 = ((abs(((((_e68.row_x.x * _e320.x) + (_e68.row_x.y * _e320.y)) + (_e68.row_x.z * _e320.z)) / (((_e68.row_x.x * _e68.row_x.x) + (_e68.row_x.y * _e68.row_x.y)) + (_e68.row_x.z * _e68.row_x.z)))) + abs(((((_e68.row_y.x * _e320.x) + (_e68.row_y.y * _e320.y)) + (_e68.row_y.z * _e320.z)) / (((_e68.row_y.x * _e68.row_y.x) + (_e68.row_y.y * _e68.row_y.y)) + (_e68.row_y.z * _e68.row_y.z))))) / (abs(((((_e68.row_z.x * _e320.x) + (_e68.row_z.y * _e320.y)) + (_e68.row_z.z * _e320.z)) / (((_e68.row_z.x * _e68.row_z.x) + (_e68.row_z.y * _e68.row_z.y)) + (_e68.row_z.z * _e68.row_z.z)))) * f32(_e322)));
                    if (_e392 < 0.002f) {
                        phi_1182_ = _e392;
                    } else {
                        phi_1182_ = 0.002f;
                    }
                    let _e395 = phi_1182_;
                    phi_1185_ = (_e290 - (0f * _e395));
                } else {
                    phi_1185_ = _e290;
                }
                let _e399 = phi_1185_;
                let _e401 = p.member.map_size;
                let _e402 = f32(_e401);
                let _e405 = ((_e263 * _e402) - 0.5f);
                let _e406 = ((_e277 * _e402) - 0.5f);
                if (_e405 > -8388608f) {
                    let _e418 = f32(select(0i, select(select(i32(_e405), i32(-2147483648), (_e405 < bitcast<f32>(3472883712u))), 2147483647i, (_e405 > bitcast<f32>(1325400063u))), (_e405 == _e405)));
                    if (_e418 > _e405) {
                        phi_1214_ = 1f;
                    } else {
                        phi_1214_ = 0f;
                    }
                    let _e421 = phi_1214_;
                    if (_e405 < 8388608f) {
                        phi_1219_ = (_e418 - _e421);
                        phi_1220_ = false;
                    } else {
                        phi_1219_ = f32();
                        phi_1220_ = true;
                    }
                    let _e424 = phi_1219_;
                    let _e426 = phi_1220_;
                    phi_1221_ = _e424;
                    phi_1222_ = _e426;
                } else {
                    phi_1221_ = f32();
                    phi_1222_ = true;
                }
                let _e428 = phi_1221_;
                let _e430 = phi_1222_;
                if _e430 {
                    phi_1226_ = _e405;
                } else {
                    phi_1226_ = _e428;
                }
                let _e432 = phi_1226_;
                if (_e406 > -8388608f) {
                    let _e444 = f32(select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406)));
                    if (_e444 > _e406) {
                        phi_1246_ = 1f;
                    } else {
                        phi_1246_ = 0f;
                    }
                    let _e447 = phi_1246_;
                    if (_e406 < 8388608f) {
                        phi_1251_ = (_e444 - _e447);
                        phi_1252_ = false;
                    } else {
                        phi_1251_ = f32();
                        phi_1252_ = true;
                    }
                    let _e450 = phi_1251_;
                    let _e452 = phi_1252_;
                    phi_1253_ = _e450;
                    phi_1254_ = _e452;
                } else {
                    phi_1253_ = f32();
                    phi_1254_ = true;
                }
                let _e454 = phi_1253_;
                let _e456 = phi_1254_;
                if _e456 {
                    phi_1258_ = _e406;
                } else {
                    phi_1258_ = _e454;
                }
                let _e458 = phi_1258_;
                let _e459 = (_e405 - _e432);
                let _e460 = (_e406 - _e458);
                let _e469 = select(0i, select(select(i32(_e432), i32(-2147483648), (_e432 < bitcast<f32>(3472883712u))), 2147483647i, (_e432 > bitcast<f32>(1325400063u))), (_e432 == _e432));
                let _e478 = select(0i, select(select(i32(_e458), i32(-2147483648), (_e458 < bitcast<f32>(3472883712u))), 2147483647i, (_e458 > bitcast<f32>(1325400063u))), (_e458 == _e458));
                let _e489 = p.member.test;
                let _e490 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e489);
                let _e492 = p.member.map_size;
                local = _e490;
                let _e494 = ((0u * _e492) * _e492);
                let _e496 = (bitcast<i32>(_e492) - 1i);
                if (_e469 > 0i) {
                    phi_1308_ = _e469;
                } else {
                    phi_1308_ = 0i;
                }
                let _e499 = phi_1308_;
                if (_e478 > 0i) {
                    phi_1313_ = _e478;
                } else {
                    phi_1313_ = 0i;
                }
                let _e502 = phi_1313_;
                if (_e499 < _e496) {
                    phi_1318_ = _e499;
                } else {
                    phi_1318_ = _e496;
                }
                let _e505 = phi_1318_;
                if (_e502 < _e496) {
                    phi_1323_ = _e502;
                } else {
                    phi_1323_ = _e496;
                }
                let _e508 = phi_1323_;
                let _e509 = bitcast<u32>(_e505);
                let _e511 = (_e469 + 1i);
                let _e512 = (_e478 + 1i);
                if (_e511 > 0i) {
                    phi_1332_ = _e511;
                } else {
                    phi_1332_ = 0i;
                }
                let _e515 = phi_1332_;
                if (_e512 > 0i) {
                    phi_1337_ = _e512;
                } else {
                    phi_1337_ = 0i;
                }
                let _e518 = phi_1337_;
                if (_e515 < _e496) {
                    phi_1342_ = _e515;
                } else {
                    phi_1342_ = _e496;
                }
                let _e521 = phi_1342_;
                if (_e518 < _e496) {
                    phi_1347_ = _e518;
                } else {
                    phi_1347_ = _e496;
                }
                let _e524 = phi_1347_;
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
                let _e554 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e540, _e544, _e548, _e552), vec4<f32>(((1f - _e459) * (1f - _e460)), (_e459 * (1f - _e460)), ((1f - _e459) * _e460), (_e459 * _e460)), _e399);
                let _e556 = p.member.map_size;
                let _e558 = (bitcast<i32>(_e556) - 1i);
                if (_e469 > 0i) {
                    phi_1402_ = _e469;
                } else {
                    phi_1402_ = 0i;
                }
                let _e561 = phi_1402_;
                if (_e478 > 0i) {
                    phi_1407_ = _e478;
                } else {
                    phi_1407_ = 0i;
                }
                let _e564 = phi_1407_;
                if (_e561 < _e558) {
                    phi_1412_ = _e561;
                } else {
                    phi_1412_ = _e558;
                }
                let _e567 = phi_1412_;
                if (_e564 < _e558) {
                    phi_1417_ = _e564;
                } else {
                    phi_1417_ = _e558;
                }
                let _e570 = phi_1417_;
                let _e571 = bitcast<u32>(_e567);
                let _e578 = ((((0u * _e556) + bitcast<u32>(_e570)) * (_e556 / 16u)) + (_e571 / 16u));
                let _e581 = (_e469 + 1i);
                let _e582 = (_e478 + 0i);
                let _e584 = (bitcast<i32>(_e556) - 1i);
                if (_e581 > 0i) {
                    phi_1436_ = _e581;
                } else {
                    phi_1436_ = 0i;
                }
                let _e587 = phi_1436_;
                if (_e582 > 0i) {
                    phi_1441_ = _e582;
                } else {
                    phi_1441_ = 0i;
                }
                let _e590 = phi_1441_;
                if (_e587 < _e584) {
                    phi_1446_ = _e587;
                } else {
                    phi_1446_ = _e584;
                }
                let _e593 = phi_1446_;
                if (_e590 < _e584) {
                    phi_1451_ = _e590;
                } else {
                    phi_1451_ = _e584;
                }
                let _e596 = phi_1451_;
                let _e597 = bitcast<u32>(_e593);
                let _e604 = ((((0u * _e556) + bitcast<u32>(_e596)) * (_e556 / 16u)) + (_e597 / 16u));
                let _e607 = (_e469 + 0i);
                let _e608 = (_e478 + 1i);
                let _e610 = (bitcast<i32>(_e556) - 1i);
                if (_e607 > 0i) {
                    phi_1470_ = _e607;
                } else {
                    phi_1470_ = 0i;
                }
                let _e613 = phi_1470_;
                if (_e608 > 0i) {
                    phi_1475_ = _e608;
                } else {
                    phi_1475_ = 0i;
                }
                let _e616 = phi_1475_;
                if (_e613 < _e610) {
                    phi_1480_ = _e613;
                } else {
                    phi_1480_ = _e610;
                }
                let _e619 = phi_1480_;
                if (_e616 < _e610) {
                    phi_1485_ = _e616;
                } else {
                    phi_1485_ = _e610;
                }
                let _e622 = phi_1485_;
                let _e623 = bitcast<u32>(_e619);
                let _e630 = ((((0u * _e556) + bitcast<u32>(_e622)) * (_e556 / 16u)) + (_e623 / 16u));
                let _e633 = (_e469 + 1i);
                let _e634 = (_e478 + 1i);
                let _e636 = (bitcast<i32>(_e556) - 1i);
                if (_e633 > 0i) {
                    phi_1504_ = _e633;
                } else {
                    phi_1504_ = 0i;
                }
                let _e639 = phi_1504_;
                if (_e634 > 0i) {
                    phi_1509_ = _e634;
                } else {
                    phi_1509_ = 0i;
                }
                let _e642 = phi_1509_;
                if (_e639 < _e636) {
                    phi_1514_ = _e639;
                } else {
                    phi_1514_ = _e636;
                }
                let _e645 = phi_1514_;
                if (_e642 < _e636) {
                    phi_1519_ = _e642;
                } else {
                    phi_1519_ = _e636;
                }
                let _e648 = phi_1519_;
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
                    phi_1597_ = true;
                } else {
                    phi_1597_ = (_e554 >= (1f - _e695));
                }
                let _e700 = phi_1597_;
                if ((bitcast<u32>(_e554) & 2147483647u) > 2139095040u) {
                    phi_1605_ = true;
                } else {
                    phi_1605_ = !(_e700);
                }
                let _e706 = phi_1605_;
                if _e706 {
                    if (_e554 > 0f) {
                        if (_e554 < 1f) {
                            phi_1617_ = false;
                        } else {
                            phi_1617_ = true;
                        }
                        let _e710 = phi_1617_;
                        phi_1618_ = _e710;
                    } else {
                        phi_1618_ = true;
                    }
                    let _e712 = phi_1618_;
                    if _e712 {
                        phi_1622_ = 0.5f;
                    } else {
                        phi_1622_ = _e554;
                    }
                    let _e714 = phi_1622_;
                    phi_1630_ = evaluate_Verdict(_e714, true);
                } else {
                    if (_e554 > 0.5f) {
                        phi_1628_ = 1f;
                    } else {
                        phi_1628_ = 0f;
                    }
                    let _e718 = phi_1628_;
                    phi_1630_ = evaluate_Verdict(_e718, false);
                }
                let _e721 = phi_1630_;
                let _e724 = (_e721.visibility < 0.5f);
                if _e721.is_doubted {
                    phi_1653_ = evaluate_Verdict();
                    phi_1654_ = true;
                } else {
                    if _e724 {
                        phi_1640_ = 2u;
                    } else {
                        phi_1640_ = 1u;
                    }
                    let _e726 = phi_1640_;
                    if ((((((_e662 >> bitcast<u32>((((_e571 % 16u) * 2u) & 31u))) & 3u) | ((_e670 >> bitcast<u32>((((_e597 % 16u) * 2u) & 31u))) & 3u)) | (((_e679 >> bitcast<u32>((((_e623 % 16u) * 2u) & 31u))) & 3u) | ((_e687 >> bitcast<u32>((((_e649 % 16u) * 2u) & 31u))) & 3u))) & _e726) != 0u) {
                        if _e724 {
                            phi_1649_ = 0.000000059604645f;
                        } else {
                            phi_1649_ = 0.99999994f;
                        }
                        let _e730 = phi_1649_;
                        phi_1651_ = evaluate_Verdict(_e730, true);
                        phi_1652_ = false;
                    } else {
                        phi_1651_ = evaluate_Verdict();
                        phi_1652_ = true;
                    }
                    let _e733 = phi_1651_;
                    let _e735 = phi_1652_;
                    phi_1653_ = _e733;
                    phi_1654_ = _e735;
                }
                let _e737 = phi_1653_;
                let _e739 = phi_1654_;
                if _e739 {
                    phi_1659_ = evaluate_Verdict(_e721.visibility, _e721.is_doubted);
                } else {
                    phi_1659_ = _e737;
                }
                let _e742 = phi_1659_;
                phi_1664_ = evaluate_Verdict(_e742.visibility, _e742.is_doubted);
            } else {
                phi_1664_ = evaluate_Verdict(0.5f, true);
            }
            let _e748 = phi_1664_;
            phi_1665_ = _e748;
        }
        let _e750 = phi_1665_;
        if (_e62.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e62.first_primitive)] = _e750.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
