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
    var phi_151_: lt_bvh_traverse_Tree;
    var phi_152_: bool;
    var phi_153_: lt_bvh_traverse_Tree;
    var phi_154_: bool;
    var phi_159_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_151_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_152_ = false;
        } else {
            phi_151_ = lt_bvh_traverse_Tree();
            phi_152_ = true;
        }
        let _e57 = phi_151_;
        let _e59 = phi_152_;
        phi_153_ = _e57;
        phi_154_ = _e59;
    } else {
        phi_153_ = lt_bvh_traverse_Tree();
        phi_154_ = true;
    }
    let _e61 = phi_153_;
    let _e63 = phi_154_;
    if _e63 {
        phi_159_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_159_ = _e61;
    }
    let _e68 = phi_159_;
    return lt_bvh_traverse_Tree(_e68.root, _e68.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_4: f32, param_5: f32) -> f32 {
    var phi_173_: f32;

    if (param_4 < param_5) {
        phi_173_ = param_4;
    } else {
        phi_173_ = param_5;
    }
    let _e48 = phi_173_;
    return _e48;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_6: ptr<function, f32>, param_7: vec4<f32>, param_8: vec4<f32>, param_9: f32) -> f32 {
    var phi_194_: f32;
    var phi_195_: f32;
    var phi_196_: f32;
    var phi_213_: f32;
    var phi_214_: f32;
    var phi_215_: f32;
    var phi_231_: f32;
    var phi_232_: f32;
    var phi_233_: f32;
    var phi_249_: f32;
    var phi_250_: f32;
    var phi_251_: f32;
    var phi_267_: f32;
    var phi_268_: f32;
    var phi_269_: f32;
    var phi_304_: bool;
    var phi_305_: bool;
    var phi_306_: bool;
    var phi_307_: bool;
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_313_: bool;
    var phi_624_: f32;
    var phi_625_: f32;
    var phi_626_: f32;
    var phi_643_: f32;
    var phi_644_: f32;
    var phi_645_: f32;
    var phi_662_: f32;
    var phi_663_: f32;
    var phi_664_: f32;
    var phi_681_: f32;
    var phi_682_: f32;
    var phi_683_: f32;
    var phi_706_: f32;
    var phi_707_: f32;
    var phi_708_: f32;
    var phi_719_: f32;
    var phi_734_: f32;
    var phi_736_: lt_bvh_slab_Span;
    var phi_794_: f32;
    var phi_795_: f32;
    var phi_796_: f32;
    var phi_797_: f32;
    var phi_798_: f32;
    var phi_799_: bool;
    var phi_803_: f32;
    var phi_813_: bool;
    var phi_826_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_841_: bool;
    var phi_842_: bool;
    var phi_843_: bool;
    var phi_847_: bool;
    var phi_898_: f32;
    var phi_899_: f32;
    var phi_900_: f32;
    var phi_917_: f32;
    var phi_918_: f32;
    var phi_919_: f32;
    var phi_936_: f32;
    var phi_937_: f32;
    var phi_938_: f32;
    var phi_955_: f32;
    var phi_956_: f32;
    var phi_957_: f32;
    var phi_980_: f32;
    var phi_981_: f32;
    var phi_982_: f32;
    var phi_1069_: f32;
    var phi_1070_: f32;
    var phi_1081_: bool;
    var phi_1085_: f32;
    var phi_1086_: f32;
    var phi_1101_: f32;
    var phi_1102_: f32;
    var phi_1103_: f32;
    var phi_1104_: f32;
    var phi_1105_: f32;
    var phi_1106_: f32;
    var phi_1107_: f32;
    var phi_1108_: bool;
    var phi_1109_: f32;
    var phi_1110_: f32;
    var phi_1111_: bool;
    var phi_1115_: f32;

    let _e48 = (*param_6);
    if ((bitcast<u32>(param_9) & 2147483647u) > 2139095040u) {
        phi_196_ = param_9;
    } else {
        if (param_9 < 0f) {
            phi_195_ = 0f;
        } else {
            if (param_9 > 1f) {
                phi_194_ = 1f;
            } else {
                phi_194_ = param_9;
            }
            let _e55 = phi_194_;
            phi_195_ = _e55;
        }
        let _e57 = phi_195_;
        phi_196_ = _e57;
    }
    let _e59 = phi_196_;
    let _e60 = (_e59 - 0.00000047683716f);
    if ((bitcast<u32>(param_7.x) & 2147483647u) > 2139095040u) {
        phi_215_ = param_7.x;
    } else {
        if (param_7.x < 0f) {
            phi_214_ = 0f;
        } else {
            if (param_7.x > 1f) {
                phi_213_ = 1f;
            } else {
                phi_213_ = param_7.x;
            }
            let _e68 = phi_213_;
            phi_214_ = _e68;
        }
        let _e70 = phi_214_;
        phi_215_ = _e70;
    }
    let _e72 = phi_215_;
    if ((bitcast<u32>(param_7.y) & 2147483647u) > 2139095040u) {
        phi_233_ = param_7.y;
    } else {
        if (param_7.y < 0f) {
            phi_232_ = 0f;
        } else {
            if (param_7.y > 1f) {
                phi_231_ = 1f;
            } else {
                phi_231_ = param_7.y;
            }
            let _e80 = phi_231_;
            phi_232_ = _e80;
        }
        let _e82 = phi_232_;
        phi_233_ = _e82;
    }
    let _e84 = phi_233_;
    if ((bitcast<u32>(param_7.z) & 2147483647u) > 2139095040u) {
        phi_251_ = param_7.z;
    } else {
        if (param_7.z < 0f) {
            phi_250_ = 0f;
        } else {
            if (param_7.z > 1f) {
                phi_249_ = 1f;
            } else {
                phi_249_ = param_7.z;
            }
            let _e92 = phi_249_;
            phi_250_ = _e92;
        }
        let _e94 = phi_250_;
        phi_251_ = _e94;
    }
    let _e96 = phi_251_;
    if ((bitcast<u32>(param_7.w) & 2147483647u) > 2139095040u) {
        phi_269_ = param_7.w;
    } else {
        if (param_7.w < 0f) {
            phi_268_ = 0f;
        } else {
            if (param_7.w > 1f) {
                phi_267_ = 1f;
            } else {
                phi_267_ = param_7.w;
            }
            let _e104 = phi_267_;
            phi_268_ = _e104;
        }
        let _e106 = phi_268_;
        phi_269_ = _e106;
    }
    let _e108 = phi_269_;
    let _e109 = (_e72 - _e60);
    let _e110 = (_e84 - _e60);
    let _e111 = (_e96 - _e60);
    let _e112 = (_e108 - _e60);
    let _e123 = ((((_e109 * param_8.x) + (_e110 * param_8.y)) + (_e111 * param_8.z)) + (_e112 * param_8.w));
    if ((bitcast<u32>(_e123) & 2147483647u) > 2139095040u) {
        phi_1109_ = _e123;
        phi_1110_ = f32();
        phi_1111_ = true;
    } else {
        if (_e109 >= 0f) {
            if (_e110 >= 0f) {
                if (_e111 >= 0f) {
                    phi_304_ = (_e112 >= 0f);
                    phi_305_ = false;
                } else {
                    phi_304_ = bool();
                    phi_305_ = true;
                }
                let _e132 = phi_304_;
                let _e134 = phi_305_;
                phi_306_ = _e132;
                phi_307_ = _e134;
            } else {
                phi_306_ = bool();
                phi_307_ = true;
            }
            let _e136 = phi_306_;
            let _e138 = phi_307_;
            phi_308_ = _e136;
            phi_309_ = _e138;
        } else {
            phi_308_ = bool();
            phi_309_ = true;
        }
        let _e140 = phi_308_;
        let _e142 = phi_309_;
        if _e142 {
            phi_313_ = false;
        } else {
            phi_313_ = _e140;
        }
        let _e144 = phi_313_;
        if _e144 {
            phi_1106_ = 1f;
            phi_1107_ = f32();
            phi_1108_ = true;
        } else {
            let _e145 = (0.5f * _e48);
            let _e146 = (1f - _e48);
            let _e148 = (param_8.x * _e146);
            let _e150 = (param_8.y * _e146);
            let _e152 = (param_8.z * _e146);
            let _e154 = (param_8.w * _e146);
            let _e155 = -(_e60);
            let _e156 = (1f - _e60);
            let _e158 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e72);
            let _e160 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e84);
            let _e162 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e96);
            let _e164 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e108);
            let _e165 = (_e109 - _e110);
            let _e166 = (_e110 - _e111);
            let _e167 = (_e111 - _e112);
            let _e168 = (_e112 - _e109);
            let _e169 = (_e165 * _e165);
            let _e170 = (_e166 * _e166);
            let _e171 = (_e167 * _e167);
            let _e172 = (_e168 * _e168);
            let _e173 = (_e109 - _e111);
            let _e174 = (_e110 - _e112);
            let _e175 = (_e111 - _e109);
            let _e176 = (_e112 - _e110);
            let _e177 = (_e173 * _e173);
            let _e178 = (_e174 * _e174);
            let _e179 = (_e175 * _e175);
            let _e180 = (_e176 * _e176);
            let _e185 = ((_e148 * _e150) * _e169);
            let _e186 = ((_e150 * _e152) * _e170);
            let _e187 = ((_e152 * _e154) * _e171);
            let _e188 = ((_e154 * _e148) * _e172);
            let _e197 = (((0.5f * _e148) * _e152) * _e177);
            let _e198 = (((0.5f * _e150) * _e154) * _e178);
            let _e199 = (((0.5f * _e152) * _e148) * _e179);
            let _e200 = (((0.5f * _e154) * _e150) * _e180);
            let _e201 = (_e109 * _e110);
            let _e202 = (_e110 * _e111);
            let _e203 = (_e111 * _e112);
            let _e204 = (_e112 * _e109);
            let _e205 = (_e109 * _e111);
            let _e206 = (_e110 * _e112);
            let _e207 = (_e111 * _e109);
            let _e208 = (_e112 * _e110);
            let _e209 = (_e185 * _e201);
            let _e210 = (_e186 * _e202);
            let _e211 = (_e187 * _e203);
            let _e212 = (_e188 * _e204);
            let _e213 = (_e197 * _e205);
            let _e214 = (_e198 * _e206);
            let _e215 = (_e199 * _e207);
            let _e216 = (_e200 * _e208);
            let _e217 = (_e72 * _e72);
            let _e218 = (_e84 * _e84);
            let _e219 = (_e96 * _e96);
            let _e220 = (_e108 * _e108);
            let _e221 = (_e158 * _e158);
            let _e222 = (_e160 * _e160);
            let _e223 = (_e162 * _e162);
            let _e224 = (_e164 * _e164);
            let _e225 = (_e145 * _e148);
            let _e226 = (_e145 * _e150);
            let _e227 = (_e145 * _e152);
            let _e228 = (_e145 * _e154);
            let _e237 = (((_e225 * _e109) * _e217) * _e155);
            let _e238 = (((_e226 * _e110) * _e218) * _e155);
            let _e239 = (((_e227 * _e111) * _e219) * _e155);
            let _e240 = (((_e228 * _e112) * _e220) * _e155);
            let _e249 = (((_e225 * _e109) * _e221) * _e156);
            let _e250 = (((_e226 * _e110) * _e222) * _e156);
            let _e251 = (((_e227 * _e111) * _e223) * _e156);
            let _e252 = (((_e228 * _e112) * _e224) * _e156);
            let _e420 = (((((((_e185 * _e152) * _e170) * _e177) + (_e145 * (((_e185 * ((_e217 * _e218) + (_e221 * _e222))) + (_e197 * ((_e217 * _e219) + (_e221 * _e223)))) + ((_e225 * _e217) * _e221)))) + ((((_e186 * _e154) * _e171) * _e178) + (_e145 * (((_e186 * ((_e218 * _e219) + (_e222 * _e223))) + (_e198 * ((_e218 * _e220) + (_e222 * _e224)))) + ((_e226 * _e218) * _e222))))) + ((((_e187 * _e148) * _e172) * _e179) + (_e145 * (((_e187 * ((_e219 * _e220) + (_e223 * _e224))) + (_e199 * ((_e219 * _e217) + (_e223 * _e221)))) + ((_e227 * _e219) * _e223))))) + ((((_e188 * _e150) * _e169) * _e180) + (_e145 * (((_e188 * ((_e220 * _e217) + (_e224 * _e221))) + (_e200 * ((_e220 * _e218) + (_e224 * _e222)))) + ((_e228 * _e220) * _e224)))));
            let _e423 = (((_e145 * _e145) * _e155) * _e156);
            let _e426 = (((((((_e209 * _e201) + (_e213 * _e205)) + (_e109 * ((_e237 * _e155) + (_e249 * _e156)))) + (((_e210 * _e202) + (_e214 * _e206)) + (_e110 * ((_e238 * _e155) + (_e250 * _e156))))) + (((_e211 * _e203) + (_e215 * _e207)) + (_e111 * ((_e239 * _e155) + (_e251 * _e156))))) + (((_e212 * _e204) + (_e216 * _e208)) + (_e112 * ((_e240 * _e155) + (_e252 * _e156))))) + ((_e423 * _e155) * _e156));
            let _e432 = (_e426 < 0.0000000000000000000000000000000001f);
            if _e432 {
                if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                    phi_626_ = _e109;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_625_ = 0f;
                    } else {
                        if (_e109 < 0f) {
                            phi_624_ = 0f;
                        } else {
                            phi_624_ = 1f;
                        }
                        let _e441 = phi_624_;
                        phi_625_ = _e441;
                    }
                    let _e443 = phi_625_;
                    phi_626_ = _e443;
                }
                let _e445 = phi_626_;
                if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                    phi_645_ = _e110;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_644_ = 0f;
                    } else {
                        if (_e110 < 0f) {
                            phi_643_ = 0f;
                        } else {
                            phi_643_ = 1f;
                        }
                        let _e454 = phi_643_;
                        phi_644_ = _e454;
                    }
                    let _e456 = phi_644_;
                    phi_645_ = _e456;
                }
                let _e458 = phi_645_;
                if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                    phi_664_ = _e111;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_663_ = 0f;
                    } else {
                        if (_e111 < 0f) {
                            phi_662_ = 0f;
                        } else {
                            phi_662_ = 1f;
                        }
                        let _e467 = phi_662_;
                        phi_663_ = _e467;
                    }
                    let _e469 = phi_663_;
                    phi_664_ = _e469;
                }
                let _e471 = phi_664_;
                if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
                    phi_683_ = _e112;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_682_ = 0f;
                    } else {
                        if (_e112 < 0f) {
                            phi_681_ = 0f;
                        } else {
                            phi_681_ = 1f;
                        }
                        let _e480 = phi_681_;
                        phi_682_ = _e480;
                    }
                    let _e482 = phi_682_;
                    phi_683_ = _e482;
                }
                let _e484 = phi_683_;
                let _e492 = (((((_e445 * _e148) + (_e458 * _e150)) + (_e471 * _e152)) + (_e484 * _e154)) + _e145);
                if ((bitcast<u32>(_e492) & 2147483647u) > 2139095040u) {
                    phi_708_ = _e492;
                } else {
                    if (_e492 < 0f) {
                        phi_707_ = 0f;
                    } else {
                        if (_e492 > 1f) {
                            phi_706_ = 1f;
                        } else {
                            phi_706_ = _e492;
                        }
                        let _e499 = phi_706_;
                        phi_707_ = _e499;
                    }
                    let _e501 = phi_707_;
                    phi_708_ = _e501;
                }
                let _e503 = phi_708_;
                phi_1104_ = _e503;
                phi_1105_ = f32();
            } else {
                let _e505 = ((0.5f * -(((((((((_e209 * (_e109 + _e110)) + (_e213 * (_e109 + _e111))) + (_e237 * (_e109 + _e155))) + (_e249 * (_e109 + _e156))) + ((((_e210 * (_e110 + _e111)) + (_e214 * (_e110 + _e112))) + (_e238 * (_e110 + _e155))) + (_e250 * (_e110 + _e156)))) + ((((_e211 * (_e111 + _e112)) + (_e215 * (_e111 + _e109))) + (_e239 * (_e111 + _e155))) + (_e251 * (_e111 + _e156)))) + ((((_e212 * (_e112 + _e109)) + (_e216 * (_e112 + _e110))) + (_e240 * (_e112 + _e155))) + (_e252 * (_e112 + _e156)))) + (_e423 * (_e155 + _e156))))) / _e426);
                let _e506 = ((((((((_e209 + _e213) + _e237) + _e249) + (((_e210 + _e214) + _e238) + _e250)) + (((_e211 + _e215) + _e239) + _e251)) + (((_e212 + _e216) + _e240) + _e252)) + _e423) / _e426);
                let _e508 = ((_e505 * _e505) - _e506);
                if (_e508 > 0f) {
                    phi_719_ = sqrt(_e508);
                } else {
                    phi_719_ = 0f;
                }
                let _e512 = phi_719_;
                if (_e505 > 0f) {
                    let _e515 = (-(_e505) - _e512);
                    phi_736_ = lt_bvh_slab_Span(_e515, (_e506 / _e515));
                } else {
                    let _e518 = (_e512 - _e505);
                    if (_e518 > 0f) {
                        phi_734_ = (_e506 / _e518);
                    } else {
                        phi_734_ = 0f;
                    }
                    let _e522 = phi_734_;
                    phi_736_ = lt_bvh_slab_Span(_e522, _e518);
                }
                let _e525 = phi_736_;
                if (_e525.near >= 0f) {
                    phi_797_ = 1f;
                    phi_798_ = f32();
                    phi_799_ = true;
                } else {
                    let _e529 = (_e525.far <= 0f);
                    if _e529 {
                        phi_795_ = (_e420 / _e426);
                        phi_796_ = f32();
                    } else {
                        let _e540 = (((((_e148 * _e109) + (_e150 * _e110)) + (_e152 * _e111)) + (_e154 * _e112)) + (_e145 * (_e155 + _e156)));
                        let _e556 = (((((_e148 * (_e109 * _e109)) + (_e150 * (_e110 * _e110))) + (_e152 * (_e111 * _e111))) + (_e154 * (_e112 * _e112))) + (_e145 * ((_e155 * _e155) + (_e156 * _e156))));
                        if (-(_e525.near) <= _e525.far) {
                            phi_794_ = (1f - (((_e525.near * _e525.near) * ((_e525.far * _e556) - _e540)) / (_e525.far - _e525.near)));
                        } else {
                            phi_794_ = ((_e420 / _e426) + (((_e525.far * _e525.far) * (_e540 - (_e525.near * _e556))) / (_e525.far - _e525.near)));
                        }
                        let _e575 = phi_794_;
                        phi_795_ = f32();
                        phi_796_ = _e575;
                    }
                    let _e577 = phi_795_;
                    let _e579 = phi_796_;
                    phi_797_ = _e577;
                    phi_798_ = _e579;
                    phi_799_ = _e529;
                }
                let _e581 = phi_797_;
                let _e583 = phi_798_;
                let _e585 = phi_799_;
                if _e585 {
                    phi_803_ = _e581;
                } else {
                    phi_803_ = _e583;
                }
                let _e587 = phi_803_;
                if ((_e525.near * _e155) >= (1f - 0.00001f)) {
                    phi_813_ = true;
                } else {
                    phi_813_ = ((_e525.near * _e156) >= (1f - 0.00001f));
                }
                let _e595 = phi_813_;
                if _e595 {
                    if ((_e525.far * _e155) >= (1f - 0.00001f)) {
                        phi_826_ = true;
                    } else {
                        phi_826_ = ((_e525.far * _e156) >= (1f - 0.00001f));
                    }
                    let _e603 = phi_826_;
                    if _e603 {
                        phi_830_ = false;
                    } else {
                        phi_830_ = true;
                    }
                    let _e605 = phi_830_;
                    phi_831_ = _e605;
                } else {
                    phi_831_ = true;
                }
                let _e607 = phi_831_;
                if _e607 {
                    let _e609 = (-(_e155) < 0.0001f);
                    if _e609 {
                        phi_841_ = bool();
                    } else {
                        phi_841_ = (_e156 < 0.0001f);
                    }
                    let _e612 = phi_841_;
                    phi_842_ = _e612;
                    phi_843_ = _e609;
                } else {
                    phi_842_ = bool();
                    phi_843_ = true;
                }
                let _e614 = phi_842_;
                let _e616 = phi_843_;
                if _e616 {
                    phi_847_ = true;
                } else {
                    phi_847_ = _e614;
                }
                let _e618 = phi_847_;
                if !(_e618) {
                    let _e624 = ((_e148 * _e72) * _e158);
                    let _e625 = ((_e150 * _e84) * _e160);
                    let _e626 = ((_e152 * _e96) * _e162);
                    let _e627 = ((_e154 * _e108) * _e164);
                    let _e645 = ((((_e624 * (_e109 * _e109)) + (_e625 * (_e110 * _e110))) + (_e626 * (_e111 * _e111))) + (_e627 * (_e112 * _e112)));
                    if (_e645 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                            phi_900_ = _e109;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_899_ = 0f;
                            } else {
                                if (_e109 < 0f) {
                                    phi_898_ = 0f;
                                } else {
                                    phi_898_ = 1f;
                                }
                                let _e655 = phi_898_;
                                phi_899_ = _e655;
                            }
                            let _e657 = phi_899_;
                            phi_900_ = _e657;
                        }
                        let _e659 = phi_900_;
                        if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                            phi_919_ = _e110;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_918_ = 0f;
                            } else {
                                if (_e110 < 0f) {
                                    phi_917_ = 0f;
                                } else {
                                    phi_917_ = 1f;
                                }
                                let _e668 = phi_917_;
                                phi_918_ = _e668;
                            }
                            let _e670 = phi_918_;
                            phi_919_ = _e670;
                        }
                        let _e672 = phi_919_;
                        if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                            phi_938_ = _e111;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_937_ = 0f;
                            } else {
                                if (_e111 < 0f) {
                                    phi_936_ = 0f;
                                } else {
                                    phi_936_ = 1f;
                                }
                                let _e681 = phi_936_;
                                phi_937_ = _e681;
                            }
                            let _e683 = phi_937_;
                            phi_938_ = _e683;
                        }
                        let _e685 = phi_938_;
                        if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
                            phi_957_ = _e112;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_956_ = 0f;
                            } else {
                                if (_e112 < 0f) {
                                    phi_955_ = 0f;
                                } else {
                                    phi_955_ = 1f;
                                }
                                let _e694 = phi_955_;
                                phi_956_ = _e694;
                            }
                            let _e696 = phi_956_;
                            phi_957_ = _e696;
                        }
                        let _e698 = phi_957_;
                        let _e706 = (((((_e659 * _e148) + (_e672 * _e150)) + (_e685 * _e152)) + (_e698 * _e154)) + _e145);
                        if ((bitcast<u32>(_e706) & 2147483647u) > 2139095040u) {
                            phi_982_ = _e706;
                        } else {
                            if (_e706 < 0f) {
                                phi_981_ = 0f;
                            } else {
                                if (_e706 > 1f) {
                                    phi_980_ = 1f;
                                } else {
                                    phi_980_ = _e706;
                                }
                                let _e713 = phi_980_;
                                phi_981_ = _e713;
                            }
                            let _e715 = phi_981_;
                            phi_982_ = _e715;
                        }
                        let _e717 = phi_982_;
                        phi_1070_ = _e717;
                    } else {
                        let _e718 = (((((_e624 * _e109) + (_e625 * _e110)) + (_e626 * _e111)) + (_e627 * _e112)) / _e645);
                        let _e735 = ((_e148 * _e109) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e718 * _e109)));
                        let _e736 = ((_e150 * _e110) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e718 * _e110)));
                        let _e737 = ((_e152 * _e111) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e718 * _e111)));
                        let _e738 = ((_e154 * _e112) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e718 * _e112)));
                        if (_e718 > 0f) {
                            phi_1069_ = ((1f - _e145) - (((((_e735 * _e158) + (_e736 * _e160)) + (_e737 * _e162)) + (_e738 * _e164)) / (_e155 * (1f - (_e155 * _e718)))));
                        } else {
                            phi_1069_ = ((((((((_e624 * ((_e625 * _e169) + ((0.5f * _e626) * _e177))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e625 * ((_e626 * _e170) + ((0.5f * _e627) * _e178))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e626 * ((_e627 * _e171) + ((0.5f * _e624) * _e179))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e627 * ((_e624 * _e172) + ((0.5f * _e625) * _e180))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e645 * (-(_e155) * _e156))) + _e145) + (((((_e735 * _e72) + (_e736 * _e84)) + (_e737 * _e96)) + (_e738 * _e108)) / (_e156 * (1f - (_e718 * _e156)))));
                        }
                        let _e802 = phi_1069_;
                        phi_1070_ = _e802;
                    }
                    let _e804 = phi_1070_;
                    if ((bitcast<u32>(_e587) & 2147483647u) > 2139095040u) {
                        phi_1081_ = true;
                    } else {
                        let _e808 = (_e587 < _e804);
                        if _e808 {
                        }
                        phi_1081_ = _e808;
                    }
                    let _e810 = phi_1081_;
                    if _e810 {
                        phi_1085_ = _e587;
                    } else {
                        phi_1085_ = _e804;
                    }
                    let _e812 = phi_1085_;
                    phi_1086_ = _e812;
                } else {
                    phi_1086_ = _e587;
                }
                let _e814 = phi_1086_;
                if ((bitcast<u32>(_e814) & 2147483647u) > 2139095040u) {
                    phi_1103_ = _e814;
                } else {
                    if (_e814 < 0f) {
                        phi_1102_ = 0f;
                    } else {
                        if (_e814 > 1f) {
                            phi_1101_ = 1f;
                        } else {
                            phi_1101_ = _e814;
                        }
                        let _e821 = phi_1101_;
                        phi_1102_ = _e821;
                    }
                    let _e823 = phi_1102_;
                    phi_1103_ = _e823;
                }
                let _e825 = phi_1103_;
                phi_1104_ = f32();
                phi_1105_ = _e825;
            }
            let _e827 = phi_1104_;
            let _e829 = phi_1105_;
            phi_1106_ = _e827;
            phi_1107_ = _e829;
            phi_1108_ = _e432;
        }
        let _e831 = phi_1106_;
        let _e833 = phi_1107_;
        let _e835 = phi_1108_;
        phi_1109_ = _e831;
        phi_1110_ = _e833;
        phi_1111_ = _e835;
    }
    let _e837 = phi_1109_;
    let _e839 = phi_1110_;
    let _e841 = phi_1111_;
    if _e841 {
        phi_1115_ = _e837;
    } else {
        phi_1115_ = _e839;
    }
    let _e843 = phi_1115_;
    return _e843;
}

fn function_() {
    var local: f32;
    var phi_1175_: bool;
    var phi_1176_: bool;
    var phi_1177_: bool;
    var phi_1178_: bool;
    var phi_1182_: bool;
    var phi_1252_: bool;
    var phi_1253_: bool;
    var phi_1264_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1265_: bool;
    var phi_1266_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1267_: bool;
    var phi_1274_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1278_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1298_: lt_math_LightPoint;
    var phi_1301_: u32;
    var phi_1303_: lt_math_LevelPoint;
    var phi_1389_: bool;
    var phi_1398_: bool;
    var phi_1407_: bool;
    var phi_1408_: bool;
    var phi_1409_: bool;
    var phi_1410_: bool;
    var phi_1411_: bool;
    var phi_1412_: bool;
    var phi_1413_: bool;
    var phi_1417_: bool;
    var phi_1444_: bool;
    var phi_1445_: bool;
    var phi_1446_: bool;
    var phi_1447_: bool;
    var phi_1448_: bool;
    var phi_1449_: bool;
    var phi_1450_: bool;
    var phi_1451_: bool;
    var phi_1455_: bool;
    var phi_1464_: lt_math_LightPoint;
    var phi_1465_: u32;
    var phi_1466_: lt_math_LevelPoint;
    var phi_1467_: bool;
    var phi_1299_: lt_math_LightPoint;
    var phi_1302_: u32;
    var phi_1304_: lt_math_LevelPoint;
    var phi_1468_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1508_: bool;
    var phi_1509_: bool;
    var phi_1510_: bool;
    var phi_1511_: bool;
    var phi_1515_: bool;
    var phi_1597_: f32;
    var phi_1713_: f32;
    var phi_1714_: f32;
    var phi_1717_: f32;
    var phi_1746_: f32;
    var phi_1751_: f32;
    var phi_1752_: bool;
    var phi_1753_: f32;
    var phi_1754_: bool;
    var phi_1758_: f32;
    var phi_1778_: f32;
    var phi_1783_: f32;
    var phi_1784_: bool;
    var phi_1785_: f32;
    var phi_1786_: bool;
    var phi_1790_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1839_: i32;
    var phi_1844_: i32;
    var phi_1849_: i32;
    var phi_1854_: i32;
    var phi_1863_: i32;
    var phi_1868_: i32;
    var phi_1873_: i32;
    var phi_1878_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1950_: f32;
    var phi_1952_: evaluate_Verdict;
    var phi_1953_: bool;
    var phi_1954_: evaluate_Verdict;
    var phi_1955_: bool;
    var phi_1960_: evaluate_Verdict;
    var phi_1961_: bool;
    var phi_1963_: evaluate_Verdict;
    var phi_1964_: evaluate_Verdict;
    var phi_1965_: bool;
    var phi_1969_: evaluate_Verdict;
    var phi_1970_: evaluate_Verdict;
    var phi_1971_: bool;
    var phi_1975_: evaluate_Verdict;

    let _e45 = id_1;
    let _e52 = arrayLength((&map.member));
    let _e58 = arrayLength((&levels.member));
    let _e61 = p.member.size[0u];
    let _e63 = p.member.size[1u];
    let _e64 = lt_shaders_entry_pixel_index(_e45, _e61, _e63);
    if (bitcast<i32>(_e64.root) != 0i) {
        let _e70 = p.member.level_count;
        if (_e64.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e77 = samples.member[(0u + _e64.first_primitive)].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[(0u + _e64.first_primitive)].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[(0u + _e64.first_primitive)].normal[2u];
                let _e89 = global[2u];
                phi_1175_ = (_e87 == _e89);
                phi_1176_ = false;
            } else {
                phi_1175_ = bool();
                phi_1176_ = true;
            }
            let _e92 = phi_1175_;
            let _e94 = phi_1176_;
            phi_1177_ = _e92;
            phi_1178_ = _e94;
        } else {
            phi_1177_ = bool();
            phi_1178_ = true;
        }
        let _e96 = phi_1177_;
        let _e98 = phi_1178_;
        if _e98 {
            phi_1182_ = false;
        } else {
            phi_1182_ = _e96;
        }
        let _e100 = phi_1182_;
        if !(_e100) {
            let _e103 = samples.member[(0u + _e64.first_primitive)].position;
            let _e105 = p.member.light.place;
            let _e111 = p.member.light.place[3u];
            let _e118 = (_e105.x - (_e103.x * _e111));
            let _e119 = (_e105.y - (_e103.y * _e111));
            let _e120 = (_e105.z - (_e103.z * _e111));
            let _e122 = samples.member[(0u + _e64.first_primitive)].normal;
            if ((((_e122.x * _e118) + (_e122.y * _e119)) + (_e122.z * _e120)) > 0f) {
                let _e136 = (((_e118 * _e118) + (_e119 * _e119)) + (_e120 * _e120));
                let _e138 = p.member.light.axis;
                let _e150 = p.member.light.place[3u];
                if (_e150 == 0f) {
                    phi_1253_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_1252_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_1252_ = false;
                    }
                    let _e161 = phi_1252_;
                    phi_1253_ = _e161;
                }
                let _e163 = phi_1253_;
                if _e163 {
                    let _e165 = samples.member[(0u + _e64.first_primitive)].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_1264_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_1265_ = false;
                } else {
                    phi_1264_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1265_ = true;
                }
                let _e184 = phi_1264_;
                let _e186 = phi_1265_;
                phi_1266_ = _e184;
                phi_1267_ = _e186;
            } else {
                phi_1266_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1267_ = true;
            }
            let _e188 = phi_1266_;
            let _e190 = phi_1267_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_1274_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_1274_ = _e188;
            }
            let _e207 = phi_1274_;
            phi_1278_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_1278_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_1278_;
        if _e224.unnamed_1 {
            phi_1969_ = evaluate_Verdict(_e224.unnamed.visibility, _e224.unnamed.is_doubted);
            phi_1970_ = evaluate_Verdict();
            phi_1971_ = true;
        } else {
            let _e232 = samples.member[(0u + _e64.first_primitive)].position;
            let _e234 = p.member.map_size;
            let _e236 = (0.5f / f32(_e234));
            let _e243 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e250 = lt_math_LightPoint(vec2<f32>(_e243.uv.x, 0f), _e243.depth, _e243.is_inside);
            let _e254 = lt_math_LightPoint(_e250.uv, 0f, _e250.is_inside);
            phi_1298_ = lt_math_LightPoint();
            phi_1301_ = 0u;
            phi_1303_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e254.uv, _e254.depth, false));
            loop {
                let _e261 = phi_1298_;
                let _e263 = phi_1301_;
                let _e265 = phi_1303_;
                local_1 = _e265;
                local_2 = _e265;
                local_3 = _e265;
                local_4 = _e265;
                if (_e263 < _e70) {
                    if _e265.point.is_inside {
                        phi_1464_ = lt_math_LightPoint();
                        phi_1465_ = u32();
                        phi_1466_ = lt_math_LevelPoint();
                        phi_1467_ = false;
                    } else {
                        if (_e263 < _e58) {
                        } else {
                            return;
                        }
                        let _e276 = levels.member[(0u + _e263)].row_w;
                        let _e287 = ((((_e276.x * _e232.x) + (_e276.y * _e232.y)) + (_e276.z * _e232.z)) + (_e276.w * 1f));
                        let _e289 = levels.member[(0u + _e263)].row_x;
                        let _e301 = (((((_e289.x * _e232.x) + (_e289.y * _e232.y)) + (_e289.z * _e232.z)) + (_e289.w * 1f)) / _e287);
                        let _e303 = levels.member[(0u + _e263)].row_y;
                        let _e315 = (((((_e303.x * _e232.x) + (_e303.y * _e232.y)) + (_e303.z * _e232.z)) + (_e303.w * 1f)) / _e287);
                        let _e317 = levels.member[(0u + _e263)].row_z;
                        let _e328 = ((((_e317.x * _e232.x) + (_e317.y * _e232.y)) + (_e317.z * _e232.z)) + (_e317.w * 1f));
                        if (_e287 > 0f) {
                            if (_e301 >= 0f) {
                                phi_1389_ = (_e301 <= 1f);
                            } else {
                                phi_1389_ = false;
                            }
                            let _e333 = phi_1389_;
                            if _e333 {
                                if (_e315 >= 0f) {
                                    phi_1398_ = (_e315 <= 1f);
                                } else {
                                    phi_1398_ = false;
                                }
                                let _e337 = phi_1398_;
                                if _e337 {
                                    if (_e328 >= 0f) {
                                        phi_1407_ = (_e328 <= 1f);
                                    } else {
                                        phi_1407_ = false;
                                    }
                                    let _e341 = phi_1407_;
                                    phi_1408_ = _e341;
                                    phi_1409_ = false;
                                } else {
                                    phi_1408_ = bool();
                                    phi_1409_ = true;
                                }
                                let _e343 = phi_1408_;
                                let _e345 = phi_1409_;
                                phi_1410_ = _e343;
                                phi_1411_ = _e345;
                            } else {
                                phi_1410_ = bool();
                                phi_1411_ = true;
                            }
                            let _e347 = phi_1410_;
                            let _e349 = phi_1411_;
                            phi_1412_ = _e347;
                            phi_1413_ = _e349;
                        } else {
                            phi_1412_ = bool();
                            phi_1413_ = true;
                        }
                        let _e351 = phi_1412_;
                        let _e353 = phi_1413_;
                        if _e353 {
                            phi_1417_ = false;
                        } else {
                            phi_1417_ = _e351;
                        }
                        let _e355 = phi_1417_;
                        if _e355 {
                            if (_e301 >= _e236) {
                                if (_e301 <= (1f - _e236)) {
                                    if (_e315 >= _e236) {
                                        phi_1444_ = (_e315 <= (1f - _e236));
                                        phi_1445_ = false;
                                    } else {
                                        phi_1444_ = bool();
                                        phi_1445_ = true;
                                    }
                                    let _e363 = phi_1444_;
                                    let _e365 = phi_1445_;
                                    phi_1446_ = _e363;
                                    phi_1447_ = _e365;
                                } else {
                                    phi_1446_ = bool();
                                    phi_1447_ = true;
                                }
                                let _e367 = phi_1446_;
                                let _e369 = phi_1447_;
                                phi_1448_ = _e367;
                                phi_1449_ = _e369;
                            } else {
                                phi_1448_ = bool();
                                phi_1449_ = true;
                            }
                            let _e371 = phi_1448_;
                            let _e373 = phi_1449_;
                            phi_1450_ = _e371;
                            phi_1451_ = _e373;
                        } else {
                            phi_1450_ = bool();
                            phi_1451_ = true;
                        }
                        let _e375 = phi_1450_;
                        let _e377 = phi_1451_;
                        if _e377 {
                            phi_1455_ = false;
                        } else {
                            phi_1455_ = _e375;
                        }
                        let _e379 = phi_1455_;
                        let _e386 = lt_math_LightPoint(vec2<f32>(_e301, _e261.uv.y), _e261.depth, _e261.is_inside);
                        let _e393 = lt_math_LightPoint(vec2<f32>(_e386.uv.x, _e315), _e386.depth, _e386.is_inside);
                        let _e397 = lt_math_LightPoint(_e393.uv, _e328, _e393.is_inside);
                        let _e401 = lt_math_LightPoint(_e397.uv, _e397.depth, _e379);
                        phi_1464_ = _e401;
                        phi_1465_ = (_e263 + 1u);
                        phi_1466_ = lt_math_LevelPoint(_e263, _e401);
                        phi_1467_ = true;
                    }
                    let _e405 = phi_1464_;
                    let _e407 = phi_1465_;
                    let _e409 = phi_1466_;
                    let _e411 = phi_1467_;
                    phi_1299_ = _e405;
                    phi_1302_ = _e407;
                    phi_1304_ = _e409;
                    phi_1468_ = _e411;
                } else {
                    phi_1299_ = lt_math_LightPoint();
                    phi_1302_ = u32();
                    phi_1304_ = lt_math_LevelPoint();
                    phi_1468_ = false;
                }
                let _e413 = phi_1299_;
                let _e415 = phi_1302_;
                let _e417 = phi_1304_;
                let _e419 = phi_1468_;
                continue;
                continuing {
                    phi_1298_ = _e413;
                    phi_1301_ = _e415;
                    phi_1303_ = _e417;
                    break if !(_e419);
                }
            }
            let _e422 = local_1;
            if _e422.point.is_inside {
                if (0f > 0f) {
                    let _e428 = local_2;
                    if (_e428.level < _e58) {
                    } else {
                        return;
                    }
                    let _e433 = levels.member[(0u + _e428.level)];
                    let _e439 = global[0u];
                    if (_e433.row_w.x == _e439) {
                        let _e442 = global[1u];
                        if (_e433.row_w.y == _e442) {
                            let _e445 = global[2u];
                            phi_1508_ = (_e433.row_w.z == _e445);
                            phi_1509_ = false;
                        } else {
                            phi_1508_ = bool();
                            phi_1509_ = true;
                        }
                        let _e448 = phi_1508_;
                        let _e450 = phi_1509_;
                        phi_1510_ = _e448;
                        phi_1511_ = _e450;
                    } else {
                        phi_1510_ = bool();
                        phi_1511_ = true;
                    }
                    let _e452 = phi_1510_;
                    let _e454 = phi_1511_;
                    if _e454 {
                        phi_1515_ = false;
                    } else {
                        phi_1515_ = _e452;
                    }
                    let _e456 = phi_1515_;
                    if _e456 {
                        let _e458 = samples.member[(0u + _e64.first_primitive)].normal;
                        let _e460 = p.member.map_size;
                        let _e530 = ((abs(((((_e433.row_x.x * _e458.x) + (_e433.row_x.y * _e458.y)) + (_e433.row_x.z * _e458.z)) / (((_e433.row_x.x * _e433.row_x.x) + (_e433.row_x.y * _e433.row_x.y)) + (_e433.row_x.z * _e433.row_x.z)))) + abs(((((_e433.row_y.x * _e458.x) + (_e433.row_y.y * _e458.y)) + (_e433.row_y.z * _e458.z)) / (((_e433.row_y.x * _e433.row_y.x) + (_e433.row_y.y * _e433.row_y.y)) + (_e433.row_y.z * _e433.row_y.z))))) / (abs(((((_e433.row_z.x * _e458.x) + (_e433.row_z.y * _e458.y)) + (_e433.row_z.z * _e458.z)) / (((_e433.row_z.x * _e433.row_z.x) + (_e433.row_z.y * _e433.row_z.y)) + (_e433.row_z.z * _e433.row_z.z)))) * f32(_e460)));
                        if (_e530 < 0.002f) {
                            phi_1597_ = _e530;
                        } else {
                            phi_1597_ = 0.002f;
                        }
                        let _e533 = phi_1597_;
                        phi_1714_ = _e533;
                    } else {
                        let _e535 = p.member.map_size;
                        let _e541 = samples.member[(0u + _e64.first_primitive)].position;
                        let _e552 = ((((_e433.row_w.x * _e541.x) + (_e433.row_w.y * _e541.y)) + (_e433.row_w.z * _e541.z)) + _e433.row_w.w);
                        let _e565 = ((_e433.row_x.x - (_e433.row_w.x * _e422.point.uv.x)) / _e552);
                        let _e566 = ((_e433.row_x.y - (_e433.row_w.y * _e422.point.uv.x)) / _e552);
                        let _e567 = ((_e433.row_x.z - (_e433.row_w.z * _e422.point.uv.x)) / _e552);
                        let _e580 = ((_e433.row_y.x - (_e433.row_w.x * _e422.point.uv.y)) / _e552);
                        let _e581 = ((_e433.row_y.y - (_e433.row_w.y * _e422.point.uv.y)) / _e552);
                        let _e582 = ((_e433.row_y.z - (_e433.row_w.z * _e422.point.uv.y)) / _e552);
                        let _e588 = samples.member[(0u + _e64.first_primitive)].normal;
                        let _e593 = ((_e581 * _e588.z) - (_e588.y * _e582));
                        let _e598 = ((_e582 * _e588.x) - (_e588.z * _e580));
                        let _e603 = ((_e580 * _e588.y) - (_e588.x * _e581));
                        let _e605 = samples.member[(0u + _e64.first_primitive)].normal;
                        let _e610 = ((_e566 * _e605.z) - (_e605.y * _e567));
                        let _e615 = ((_e567 * _e605.x) - (_e605.z * _e565));
                        let _e620 = ((_e565 * _e605.y) - (_e605.x * _e566));
                        let _e647 = ((abs(((((_e433.row_z.x * _e593) + (_e433.row_z.y * _e598)) + (_e433.row_z.z * _e603)) / (((_e565 * _e593) + (_e566 * _e598)) + (_e567 * _e603)))) + abs(((((_e433.row_z.x * _e610) + (_e433.row_z.y * _e615)) + (_e433.row_z.z * _e620)) / (((_e580 * _e610) + (_e581 * _e615)) + (_e582 * _e620))))) / f32(_e535));
                        if (_e647 < 0.002f) {
                            phi_1713_ = _e647;
                        } else {
                            phi_1713_ = 0.002f;
                        }
                        let _e650 = phi_1713_;
                        phi_1714_ = _e650;
                    }
                    let _e652 = phi_1714_;
                    phi_1717_ = (_e422.point.depth - (0f * _e652));
                } else {
                    phi_1717_ = _e422.point.depth;
                }
                let _e656 = phi_1717_;
                let _e662 = p.member.map_size;
                let _e663 = f32(_e662);
                let _e666 = ((_e422.point.uv.x * _e663) - 0.5f);
                let _e667 = ((_e422.point.uv.y * _e663) - 0.5f);
                if (_e666 > -8388608f) {
                    let _e679 = f32(select(0i, select(select(i32(_e666), i32(-2147483648), (_e666 < bitcast<f32>(3472883712u))), 2147483647i, (_e666 > bitcast<f32>(1325400063u))), (_e666 == _e666)));
                    if (_e679 > _e666) {
                        phi_1746_ = 1f;
                    } else {
                        phi_1746_ = 0f;
                    }
                    let _e682 = phi_1746_;
                    if (_e666 < 8388608f) {
                        phi_1751_ = (_e679 - _e682);
                        phi_1752_ = false;
                    } else {
                        phi_1751_ = f32();
                        phi_1752_ = true;
                    }
                    let _e685 = phi_1751_;
                    let _e687 = phi_1752_;
                    phi_1753_ = _e685;
                    phi_1754_ = _e687;
                } else {
                    phi_1753_ = f32();
                    phi_1754_ = true;
                }
                let _e689 = phi_1753_;
                let _e691 = phi_1754_;
                if _e691 {
                    phi_1758_ = _e666;
                } else {
                    phi_1758_ = _e689;
                }
                let _e693 = phi_1758_;
                if (_e667 > -8388608f) {
                    let _e705 = f32(select(0i, select(select(i32(_e667), i32(-2147483648), (_e667 < bitcast<f32>(3472883712u))), 2147483647i, (_e667 > bitcast<f32>(1325400063u))), (_e667 == _e667)));
                    if (_e705 > _e667) {
                        phi_1778_ = 1f;
                    } else {
                        phi_1778_ = 0f;
                    }
                    let _e708 = phi_1778_;
                    if (_e667 < 8388608f) {
                        phi_1783_ = (_e705 - _e708);
                        phi_1784_ = false;
                    } else {
                        phi_1783_ = f32();
                        phi_1784_ = true;
                    }
                    let _e711 = phi_1783_;
                    let _e713 = phi_1784_;
                    phi_1785_ = _e711;
                    phi_1786_ = _e713;
                } else {
                    phi_1785_ = f32();
                    phi_1786_ = true;
                }
                let _e715 = phi_1785_;
                let _e717 = phi_1786_;
                if _e717 {
                    phi_1790_ = _e667;
                } else {
                    phi_1790_ = _e715;
                }
                let _e719 = phi_1790_;
                let _e720 = (_e666 - _e693);
                let _e721 = (_e667 - _e719);
                let _e730 = select(0i, select(select(i32(_e693), i32(-2147483648), (_e693 < bitcast<f32>(3472883712u))), 2147483647i, (_e693 > bitcast<f32>(1325400063u))), (_e693 == _e693));
                let _e739 = select(0i, select(select(i32(_e719), i32(-2147483648), (_e719 < bitcast<f32>(3472883712u))), 2147483647i, (_e719 > bitcast<f32>(1325400063u))), (_e719 == _e719));
                let _e750 = p.member.test;
                let _e751 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e750);
                let _e753 = p.member.map_size;
                let _e755 = local_3;
                local = _e751;
                let _e758 = ((_e755.level * _e753) * _e753);
                let _e760 = (bitcast<i32>(_e753) - 1i);
                if (_e730 > 0i) {
                    phi_1839_ = _e730;
                } else {
                    phi_1839_ = 0i;
                }
                let _e763 = phi_1839_;
                if (_e739 > 0i) {
                    phi_1844_ = _e739;
                } else {
                    phi_1844_ = 0i;
                }
                let _e766 = phi_1844_;
                if (_e763 < _e760) {
                    phi_1849_ = _e763;
                } else {
                    phi_1849_ = _e760;
                }
                let _e769 = phi_1849_;
                if (_e766 < _e760) {
                    phi_1854_ = _e766;
                } else {
                    phi_1854_ = _e760;
                }
                let _e772 = phi_1854_;
                let _e773 = bitcast<u32>(_e769);
                let _e775 = (_e730 + 1i);
                let _e776 = (_e739 + 1i);
                if (_e775 > 0i) {
                    phi_1863_ = _e775;
                } else {
                    phi_1863_ = 0i;
                }
                let _e779 = phi_1863_;
                if (_e776 > 0i) {
                    phi_1868_ = _e776;
                } else {
                    phi_1868_ = 0i;
                }
                let _e782 = phi_1868_;
                if (_e779 < _e760) {
                    phi_1873_ = _e779;
                } else {
                    phi_1873_ = _e760;
                }
                let _e785 = phi_1873_;
                if (_e782 < _e760) {
                    phi_1878_ = _e782;
                } else {
                    phi_1878_ = _e760;
                }
                let _e788 = phi_1878_;
                let _e789 = bitcast<u32>(_e785);
                let _e791 = (bitcast<u32>(_e772) * _e753);
                let _e792 = (bitcast<u32>(_e788) * _e753);
                let _e797 = ((_e791 + _e773) + _e758);
                let _e798 = ((_e791 + _e789) + _e758);
                let _e799 = ((_e792 + _e773) + _e758);
                let _e800 = ((_e792 + _e789) + _e758);
                if (_e797 < _e52) {
                } else {
                    return;
                }
                let _e804 = map.member[(0u + _e797)];
                if (_e798 < _e52) {
                } else {
                    return;
                }
                let _e808 = map.member[(0u + _e798)];
                if (_e799 < _e52) {
                } else {
                    return;
                }
                let _e812 = map.member[(0u + _e799)];
                if (_e800 < _e52) {
                } else {
                    return;
                }
                let _e816 = map.member[(0u + _e800)];
                let _e818 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e804, _e808, _e812, _e816), vec4<f32>(((1f - _e720) * (1f - _e721)), (_e720 * (1f - _e721)), ((1f - _e720) * _e721), (_e720 * _e721)), _e656);
                let _e820 = p.member.fade_uv;
                if (_e820 > 0f) {
                    let _e823 = local_4;
                    if ((_e823.level + 1u) == _e70) {
                        let _e832 = p.member.fade_uv;
                        let _e834 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e422.point.uv.x, (1f - _e422.point.uv.x));
                        let _e836 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e422.point.uv.y, (1f - _e422.point.uv.y));
                        let _e837 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e834, _e836);
                        if (_e837 < _e832) {
                            phi_1950_ = (1f - ((1f - _e818) * (_e837 / _e832)));
                        } else {
                            phi_1950_ = _e818;
                        }
                        let _e844 = phi_1950_;
                        phi_1952_ = evaluate_Verdict(_e844, false);
                        phi_1953_ = false;
                    } else {
                        phi_1952_ = evaluate_Verdict();
                        phi_1953_ = true;
                    }
                    let _e847 = phi_1952_;
                    let _e849 = phi_1953_;
                    phi_1954_ = _e847;
                    phi_1955_ = _e849;
                } else {
                    phi_1954_ = evaluate_Verdict();
                    phi_1955_ = true;
                }
                let _e851 = phi_1954_;
                let _e853 = phi_1955_;
                if _e853 {
                    phi_1960_ = evaluate_Verdict(_e818, false);
                    phi_1961_ = false;
                } else {
                    phi_1960_ = evaluate_Verdict();
                    phi_1961_ = true;
                }
                let _e856 = phi_1960_;
                let _e858 = phi_1961_;
                phi_1963_ = _e856;
                phi_1964_ = _e851;
                phi_1965_ = _e858;
            } else {
                phi_1963_ = evaluate_Verdict();
                phi_1964_ = evaluate_Verdict(1f, false);
                phi_1965_ = true;
            }
            let _e861 = phi_1963_;
            let _e863 = phi_1964_;
            let _e865 = phi_1965_;
            if _e865 {
            }
            phi_1969_ = _e863;
            phi_1970_ = _e861;
            phi_1971_ = _e865;
        }
        let _e867 = phi_1969_;
        let _e869 = phi_1970_;
        let _e871 = phi_1971_;
        if _e871 {
            phi_1975_ = _e867;
        } else {
            phi_1975_ = _e869;
        }
        let _e873 = phi_1975_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e873.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
