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
    var phi_148_: lt_bvh_traverse_Tree;
    var phi_149_: bool;
    var phi_150_: lt_bvh_traverse_Tree;
    var phi_151_: bool;
    var phi_156_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_148_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_149_ = false;
        } else {
            phi_148_ = lt_bvh_traverse_Tree();
            phi_149_ = true;
        }
        let _e57 = phi_148_;
        let _e59 = phi_149_;
        phi_150_ = _e57;
        phi_151_ = _e59;
    } else {
        phi_150_ = lt_bvh_traverse_Tree();
        phi_151_ = true;
    }
    let _e61 = phi_150_;
    let _e63 = phi_151_;
    if _e63 {
        phi_156_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_156_ = _e61;
    }
    let _e68 = phi_156_;
    return lt_bvh_traverse_Tree(_e68.root, _e68.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_4: f32, param_5: f32) -> f32 {
    var phi_170_: f32;

    if (param_4 < param_5) {
        phi_170_ = param_4;
    } else {
        phi_170_ = param_5;
    }
    let _e48 = phi_170_;
    return _e48;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_6: ptr<function, f32>, param_7: vec4<f32>, param_8: vec4<f32>, param_9: f32) -> f32 {
    var phi_191_: f32;
    var phi_192_: f32;
    var phi_193_: f32;
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_228_: f32;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_246_: f32;
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_264_: f32;
    var phi_265_: f32;
    var phi_266_: f32;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_304_: bool;
    var phi_305_: bool;
    var phi_306_: bool;
    var phi_310_: bool;
    var phi_621_: f32;
    var phi_622_: f32;
    var phi_623_: f32;
    var phi_640_: f32;
    var phi_641_: f32;
    var phi_642_: f32;
    var phi_659_: f32;
    var phi_660_: f32;
    var phi_661_: f32;
    var phi_678_: f32;
    var phi_679_: f32;
    var phi_680_: f32;
    var phi_703_: f32;
    var phi_704_: f32;
    var phi_705_: f32;
    var phi_716_: f32;
    var phi_731_: f32;
    var phi_733_: lt_bvh_slab_Span;
    var phi_791_: f32;
    var phi_792_: f32;
    var phi_793_: f32;
    var phi_794_: f32;
    var phi_795_: f32;
    var phi_796_: bool;
    var phi_800_: f32;
    var phi_810_: bool;
    var phi_823_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_844_: bool;
    var phi_895_: f32;
    var phi_896_: f32;
    var phi_897_: f32;
    var phi_914_: f32;
    var phi_915_: f32;
    var phi_916_: f32;
    var phi_933_: f32;
    var phi_934_: f32;
    var phi_935_: f32;
    var phi_952_: f32;
    var phi_953_: f32;
    var phi_954_: f32;
    var phi_977_: f32;
    var phi_978_: f32;
    var phi_979_: f32;
    var phi_1066_: f32;
    var phi_1067_: f32;
    var phi_1078_: bool;
    var phi_1082_: f32;
    var phi_1083_: f32;
    var phi_1098_: f32;
    var phi_1099_: f32;
    var phi_1100_: f32;
    var phi_1101_: f32;
    var phi_1102_: f32;
    var phi_1103_: f32;
    var phi_1104_: f32;
    var phi_1105_: bool;
    var phi_1106_: f32;
    var phi_1107_: f32;
    var phi_1108_: bool;
    var phi_1112_: f32;

    let _e48 = (*param_6);
    if ((bitcast<u32>(param_9) & 2147483647u) > 2139095040u) {
        phi_193_ = param_9;
    } else {
        if (param_9 < 0f) {
            phi_192_ = 0f;
        } else {
            if (param_9 > 1f) {
                phi_191_ = 1f;
            } else {
                phi_191_ = param_9;
            }
            let _e55 = phi_191_;
            phi_192_ = _e55;
        }
        let _e57 = phi_192_;
        phi_193_ = _e57;
    }
    let _e59 = phi_193_;
    let _e60 = (_e59 - 0.00000047683716f);
    if ((bitcast<u32>(param_7.x) & 2147483647u) > 2139095040u) {
        phi_212_ = param_7.x;
    } else {
        if (param_7.x < 0f) {
            phi_211_ = 0f;
        } else {
            if (param_7.x > 1f) {
                phi_210_ = 1f;
            } else {
                phi_210_ = param_7.x;
            }
            let _e68 = phi_210_;
            phi_211_ = _e68;
        }
        let _e70 = phi_211_;
        phi_212_ = _e70;
    }
    let _e72 = phi_212_;
    if ((bitcast<u32>(param_7.y) & 2147483647u) > 2139095040u) {
        phi_230_ = param_7.y;
    } else {
        if (param_7.y < 0f) {
            phi_229_ = 0f;
        } else {
            if (param_7.y > 1f) {
                phi_228_ = 1f;
            } else {
                phi_228_ = param_7.y;
            }
            let _e80 = phi_228_;
            phi_229_ = _e80;
        }
        let _e82 = phi_229_;
        phi_230_ = _e82;
    }
    let _e84 = phi_230_;
    if ((bitcast<u32>(param_7.z) & 2147483647u) > 2139095040u) {
        phi_248_ = param_7.z;
    } else {
        if (param_7.z < 0f) {
            phi_247_ = 0f;
        } else {
            if (param_7.z > 1f) {
                phi_246_ = 1f;
            } else {
                phi_246_ = param_7.z;
            }
            let _e92 = phi_246_;
            phi_247_ = _e92;
        }
        let _e94 = phi_247_;
        phi_248_ = _e94;
    }
    let _e96 = phi_248_;
    if ((bitcast<u32>(param_7.w) & 2147483647u) > 2139095040u) {
        phi_266_ = param_7.w;
    } else {
        if (param_7.w < 0f) {
            phi_265_ = 0f;
        } else {
            if (param_7.w > 1f) {
                phi_264_ = 1f;
            } else {
                phi_264_ = param_7.w;
            }
            let _e104 = phi_264_;
            phi_265_ = _e104;
        }
        let _e106 = phi_265_;
        phi_266_ = _e106;
    }
    let _e108 = phi_266_;
    let _e109 = (_e72 - _e60);
    let _e110 = (_e84 - _e60);
    let _e111 = (_e96 - _e60);
    let _e112 = (_e108 - _e60);
    let _e123 = ((((_e109 * param_8.x) + (_e110 * param_8.y)) + (_e111 * param_8.z)) + (_e112 * param_8.w));
    if ((bitcast<u32>(_e123) & 2147483647u) > 2139095040u) {
        phi_1106_ = _e123;
        phi_1107_ = f32();
        phi_1108_ = true;
    } else {
        if (_e109 >= 0f) {
            if (_e110 >= 0f) {
                if (_e111 >= 0f) {
                    phi_301_ = (_e112 >= 0f);
                    phi_302_ = false;
                } else {
                    phi_301_ = bool();
                    phi_302_ = true;
                }
                let _e132 = phi_301_;
                let _e134 = phi_302_;
                phi_303_ = _e132;
                phi_304_ = _e134;
            } else {
                phi_303_ = bool();
                phi_304_ = true;
            }
            let _e136 = phi_303_;
            let _e138 = phi_304_;
            phi_305_ = _e136;
            phi_306_ = _e138;
        } else {
            phi_305_ = bool();
            phi_306_ = true;
        }
        let _e140 = phi_305_;
        let _e142 = phi_306_;
        if _e142 {
            phi_310_ = false;
        } else {
            phi_310_ = _e140;
        }
        let _e144 = phi_310_;
        if _e144 {
            phi_1103_ = 1f;
            phi_1104_ = f32();
            phi_1105_ = true;
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
                    phi_623_ = _e109;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_622_ = 0f;
                    } else {
                        if (_e109 < 0f) {
                            phi_621_ = 0f;
                        } else {
                            phi_621_ = 1f;
                        }
                        let _e441 = phi_621_;
                        phi_622_ = _e441;
                    }
                    let _e443 = phi_622_;
                    phi_623_ = _e443;
                }
                let _e445 = phi_623_;
                if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                    phi_642_ = _e110;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_641_ = 0f;
                    } else {
                        if (_e110 < 0f) {
                            phi_640_ = 0f;
                        } else {
                            phi_640_ = 1f;
                        }
                        let _e454 = phi_640_;
                        phi_641_ = _e454;
                    }
                    let _e456 = phi_641_;
                    phi_642_ = _e456;
                }
                let _e458 = phi_642_;
                if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                    phi_661_ = _e111;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_660_ = 0f;
                    } else {
                        if (_e111 < 0f) {
                            phi_659_ = 0f;
                        } else {
                            phi_659_ = 1f;
                        }
                        let _e467 = phi_659_;
                        phi_660_ = _e467;
                    }
                    let _e469 = phi_660_;
                    phi_661_ = _e469;
                }
                let _e471 = phi_661_;
                if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
                    phi_680_ = _e112;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_679_ = 0f;
                    } else {
                        if (_e112 < 0f) {
                            phi_678_ = 0f;
                        } else {
                            phi_678_ = 1f;
                        }
                        let _e480 = phi_678_;
                        phi_679_ = _e480;
                    }
                    let _e482 = phi_679_;
                    phi_680_ = _e482;
                }
                let _e484 = phi_680_;
                let _e492 = (((((_e445 * _e148) + (_e458 * _e150)) + (_e471 * _e152)) + (_e484 * _e154)) + _e145);
                if ((bitcast<u32>(_e492) & 2147483647u) > 2139095040u) {
                    phi_705_ = _e492;
                } else {
                    if (_e492 < 0f) {
                        phi_704_ = 0f;
                    } else {
                        if (_e492 > 1f) {
                            phi_703_ = 1f;
                        } else {
                            phi_703_ = _e492;
                        }
                        let _e499 = phi_703_;
                        phi_704_ = _e499;
                    }
                    let _e501 = phi_704_;
                    phi_705_ = _e501;
                }
                let _e503 = phi_705_;
                phi_1101_ = _e503;
                phi_1102_ = f32();
            } else {
                let _e505 = ((0.5f * -(((((((((_e209 * (_e109 + _e110)) + (_e213 * (_e109 + _e111))) + (_e237 * (_e109 + _e155))) + (_e249 * (_e109 + _e156))) + ((((_e210 * (_e110 + _e111)) + (_e214 * (_e110 + _e112))) + (_e238 * (_e110 + _e155))) + (_e250 * (_e110 + _e156)))) + ((((_e211 * (_e111 + _e112)) + (_e215 * (_e111 + _e109))) + (_e239 * (_e111 + _e155))) + (_e251 * (_e111 + _e156)))) + ((((_e212 * (_e112 + _e109)) + (_e216 * (_e112 + _e110))) + (_e240 * (_e112 + _e155))) + (_e252 * (_e112 + _e156)))) + (_e423 * (_e155 + _e156))))) / _e426);
                let _e506 = ((((((((_e209 + _e213) + _e237) + _e249) + (((_e210 + _e214) + _e238) + _e250)) + (((_e211 + _e215) + _e239) + _e251)) + (((_e212 + _e216) + _e240) + _e252)) + _e423) / _e426);
                let _e508 = ((_e505 * _e505) - _e506);
                if (_e508 > 0f) {
                    phi_716_ = sqrt(_e508);
                } else {
                    phi_716_ = 0f;
                }
                let _e512 = phi_716_;
                if (_e505 > 0f) {
                    let _e515 = (-(_e505) - _e512);
                    phi_733_ = lt_bvh_slab_Span(_e515, (_e506 / _e515));
                } else {
                    let _e518 = (_e512 - _e505);
                    if (_e518 > 0f) {
                        phi_731_ = (_e506 / _e518);
                    } else {
                        phi_731_ = 0f;
                    }
                    let _e522 = phi_731_;
                    phi_733_ = lt_bvh_slab_Span(_e522, _e518);
                }
                let _e525 = phi_733_;
                if (_e525.near >= 0f) {
                    phi_794_ = 1f;
                    phi_795_ = f32();
                    phi_796_ = true;
                } else {
                    let _e529 = (_e525.far <= 0f);
                    if _e529 {
                        phi_792_ = (_e420 / _e426);
                        phi_793_ = f32();
                    } else {
                        let _e540 = (((((_e148 * _e109) + (_e150 * _e110)) + (_e152 * _e111)) + (_e154 * _e112)) + (_e145 * (_e155 + _e156)));
                        let _e556 = (((((_e148 * (_e109 * _e109)) + (_e150 * (_e110 * _e110))) + (_e152 * (_e111 * _e111))) + (_e154 * (_e112 * _e112))) + (_e145 * ((_e155 * _e155) + (_e156 * _e156))));
                        if (-(_e525.near) <= _e525.far) {
                            phi_791_ = (1f - (((_e525.near * _e525.near) * ((_e525.far * _e556) - _e540)) / (_e525.far - _e525.near)));
                        } else {
                            phi_791_ = ((_e420 / _e426) + (((_e525.far * _e525.far) * (_e540 - (_e525.near * _e556))) / (_e525.far - _e525.near)));
                        }
                        let _e575 = phi_791_;
                        phi_792_ = f32();
                        phi_793_ = _e575;
                    }
                    let _e577 = phi_792_;
                    let _e579 = phi_793_;
                    phi_794_ = _e577;
                    phi_795_ = _e579;
                    phi_796_ = _e529;
                }
                let _e581 = phi_794_;
                let _e583 = phi_795_;
                let _e585 = phi_796_;
                if _e585 {
                    phi_800_ = _e581;
                } else {
                    phi_800_ = _e583;
                }
                let _e587 = phi_800_;
                if ((_e525.near * _e155) >= (1f - 0.00001f)) {
                    phi_810_ = true;
                } else {
                    phi_810_ = ((_e525.near * _e156) >= (1f - 0.00001f));
                }
                let _e595 = phi_810_;
                if _e595 {
                    if ((_e525.far * _e155) >= (1f - 0.00001f)) {
                        phi_823_ = true;
                    } else {
                        phi_823_ = ((_e525.far * _e156) >= (1f - 0.00001f));
                    }
                    let _e603 = phi_823_;
                    if _e603 {
                        phi_827_ = false;
                    } else {
                        phi_827_ = true;
                    }
                    let _e605 = phi_827_;
                    phi_828_ = _e605;
                } else {
                    phi_828_ = true;
                }
                let _e607 = phi_828_;
                if _e607 {
                    let _e609 = (-(_e155) < 0.0001f);
                    if _e609 {
                        phi_838_ = bool();
                    } else {
                        phi_838_ = (_e156 < 0.0001f);
                    }
                    let _e612 = phi_838_;
                    phi_839_ = _e612;
                    phi_840_ = _e609;
                } else {
                    phi_839_ = bool();
                    phi_840_ = true;
                }
                let _e614 = phi_839_;
                let _e616 = phi_840_;
                if _e616 {
                    phi_844_ = true;
                } else {
                    phi_844_ = _e614;
                }
                let _e618 = phi_844_;
                if !(_e618) {
                    let _e624 = ((_e148 * _e72) * _e158);
                    let _e625 = ((_e150 * _e84) * _e160);
                    let _e626 = ((_e152 * _e96) * _e162);
                    let _e627 = ((_e154 * _e108) * _e164);
                    let _e645 = ((((_e624 * (_e109 * _e109)) + (_e625 * (_e110 * _e110))) + (_e626 * (_e111 * _e111))) + (_e627 * (_e112 * _e112)));
                    if (_e645 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
                            phi_897_ = _e109;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_896_ = 0f;
                            } else {
                                if (_e109 < 0f) {
                                    phi_895_ = 0f;
                                } else {
                                    phi_895_ = 1f;
                                }
                                let _e655 = phi_895_;
                                phi_896_ = _e655;
                            }
                            let _e657 = phi_896_;
                            phi_897_ = _e657;
                        }
                        let _e659 = phi_897_;
                        if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                            phi_916_ = _e110;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_915_ = 0f;
                            } else {
                                if (_e110 < 0f) {
                                    phi_914_ = 0f;
                                } else {
                                    phi_914_ = 1f;
                                }
                                let _e668 = phi_914_;
                                phi_915_ = _e668;
                            }
                            let _e670 = phi_915_;
                            phi_916_ = _e670;
                        }
                        let _e672 = phi_916_;
                        if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                            phi_935_ = _e111;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_934_ = 0f;
                            } else {
                                if (_e111 < 0f) {
                                    phi_933_ = 0f;
                                } else {
                                    phi_933_ = 1f;
                                }
                                let _e681 = phi_933_;
                                phi_934_ = _e681;
                            }
                            let _e683 = phi_934_;
                            phi_935_ = _e683;
                        }
                        let _e685 = phi_935_;
                        if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
                            phi_954_ = _e112;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_953_ = 0f;
                            } else {
                                if (_e112 < 0f) {
                                    phi_952_ = 0f;
                                } else {
                                    phi_952_ = 1f;
                                }
                                let _e694 = phi_952_;
                                phi_953_ = _e694;
                            }
                            let _e696 = phi_953_;
                            phi_954_ = _e696;
                        }
                        let _e698 = phi_954_;
                        let _e706 = (((((_e659 * _e148) + (_e672 * _e150)) + (_e685 * _e152)) + (_e698 * _e154)) + _e145);
                        if ((bitcast<u32>(_e706) & 2147483647u) > 2139095040u) {
                            phi_979_ = _e706;
                        } else {
                            if (_e706 < 0f) {
                                phi_978_ = 0f;
                            } else {
                                if (_e706 > 1f) {
                                    phi_977_ = 1f;
                                } else {
                                    phi_977_ = _e706;
                                }
                                let _e713 = phi_977_;
                                phi_978_ = _e713;
                            }
                            let _e715 = phi_978_;
                            phi_979_ = _e715;
                        }
                        let _e717 = phi_979_;
                        phi_1067_ = _e717;
                    } else {
                        let _e718 = (((((_e624 * _e109) + (_e625 * _e110)) + (_e626 * _e111)) + (_e627 * _e112)) / _e645);
                        let _e735 = ((_e148 * _e109) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e718 * _e109)));
                        let _e736 = ((_e150 * _e110) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e718 * _e110)));
                        let _e737 = ((_e152 * _e111) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e718 * _e111)));
                        let _e738 = ((_e154 * _e112) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e718 * _e112)));
                        if (_e718 > 0f) {
                            phi_1066_ = ((1f - _e145) - (((((_e735 * _e158) + (_e736 * _e160)) + (_e737 * _e162)) + (_e738 * _e164)) / (_e155 * (1f - (_e155 * _e718)))));
                        } else {
                            phi_1066_ = ((((((((_e624 * ((_e625 * _e169) + ((0.5f * _e626) * _e177))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e625 * ((_e626 * _e170) + ((0.5f * _e627) * _e178))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e626 * ((_e627 * _e171) + ((0.5f * _e624) * _e179))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e627 * ((_e624 * _e172) + ((0.5f * _e625) * _e180))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e645 * (-(_e155) * _e156))) + _e145) + (((((_e735 * _e72) + (_e736 * _e84)) + (_e737 * _e96)) + (_e738 * _e108)) / (_e156 * (1f - (_e718 * _e156)))));
                        }
                        let _e802 = phi_1066_;
                        phi_1067_ = _e802;
                    }
                    let _e804 = phi_1067_;
                    if ((bitcast<u32>(_e587) & 2147483647u) > 2139095040u) {
                        phi_1078_ = true;
                    } else {
                        let _e808 = (_e587 < _e804);
                        if _e808 {
                        }
                        phi_1078_ = _e808;
                    }
                    let _e810 = phi_1078_;
                    if _e810 {
                        phi_1082_ = _e587;
                    } else {
                        phi_1082_ = _e804;
                    }
                    let _e812 = phi_1082_;
                    phi_1083_ = _e812;
                } else {
                    phi_1083_ = _e587;
                }
                let _e814 = phi_1083_;
                if ((bitcast<u32>(_e814) & 2147483647u) > 2139095040u) {
                    phi_1100_ = _e814;
                } else {
                    if (_e814 < 0f) {
                        phi_1099_ = 0f;
                    } else {
                        if (_e814 > 1f) {
                            phi_1098_ = 1f;
                        } else {
                            phi_1098_ = _e814;
                        }
                        let _e821 = phi_1098_;
                        phi_1099_ = _e821;
                    }
                    let _e823 = phi_1099_;
                    phi_1100_ = _e823;
                }
                let _e825 = phi_1100_;
                phi_1101_ = f32();
                phi_1102_ = _e825;
            }
            let _e827 = phi_1101_;
            let _e829 = phi_1102_;
            phi_1103_ = _e827;
            phi_1104_ = _e829;
            phi_1105_ = _e432;
        }
        let _e831 = phi_1103_;
        let _e833 = phi_1104_;
        let _e835 = phi_1105_;
        phi_1106_ = _e831;
        phi_1107_ = _e833;
        phi_1108_ = _e835;
    }
    let _e837 = phi_1106_;
    let _e839 = phi_1107_;
    let _e841 = phi_1108_;
    if _e841 {
        phi_1112_ = _e837;
    } else {
        phi_1112_ = _e839;
    }
    let _e843 = phi_1112_;
    return _e843;
}

fn function_() {
    var local: f32;
    var phi_1173_: bool;
    var phi_1174_: bool;
    var phi_1175_: bool;
    var phi_1176_: bool;
    var phi_1180_: bool;
    var phi_1224_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1228_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1248_: lt_math_LightPoint;
    var phi_1251_: u32;
    var phi_1253_: lt_math_LevelPoint;
    var phi_1339_: bool;
    var phi_1348_: bool;
    var phi_1357_: bool;
    var phi_1358_: bool;
    var phi_1359_: bool;
    var phi_1360_: bool;
    var phi_1361_: bool;
    var phi_1362_: bool;
    var phi_1363_: bool;
    var phi_1367_: bool;
    var phi_1394_: bool;
    var phi_1395_: bool;
    var phi_1396_: bool;
    var phi_1397_: bool;
    var phi_1398_: bool;
    var phi_1399_: bool;
    var phi_1400_: bool;
    var phi_1401_: bool;
    var phi_1405_: bool;
    var phi_1414_: lt_math_LightPoint;
    var phi_1415_: u32;
    var phi_1416_: lt_math_LevelPoint;
    var phi_1417_: bool;
    var phi_1249_: lt_math_LightPoint;
    var phi_1252_: u32;
    var phi_1254_: lt_math_LevelPoint;
    var phi_1418_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1458_: bool;
    var phi_1459_: bool;
    var phi_1460_: bool;
    var phi_1461_: bool;
    var phi_1465_: bool;
    var phi_1547_: f32;
    var phi_1663_: f32;
    var phi_1664_: f32;
    var phi_1667_: f32;
    var phi_1696_: f32;
    var phi_1701_: f32;
    var phi_1702_: bool;
    var phi_1703_: f32;
    var phi_1704_: bool;
    var phi_1708_: f32;
    var phi_1728_: f32;
    var phi_1733_: f32;
    var phi_1734_: bool;
    var phi_1735_: f32;
    var phi_1736_: bool;
    var phi_1740_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1789_: i32;
    var phi_1794_: i32;
    var phi_1799_: i32;
    var phi_1804_: i32;
    var phi_1813_: i32;
    var phi_1818_: i32;
    var phi_1823_: i32;
    var phi_1828_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1900_: f32;
    var phi_1902_: evaluate_Verdict;
    var phi_1903_: bool;
    var phi_1904_: evaluate_Verdict;
    var phi_1905_: bool;
    var phi_1910_: evaluate_Verdict;
    var phi_1911_: bool;
    var phi_1913_: evaluate_Verdict;
    var phi_1914_: evaluate_Verdict;
    var phi_1915_: bool;
    var phi_1919_: evaluate_Verdict;
    var phi_1920_: evaluate_Verdict;
    var phi_1921_: bool;
    var phi_1925_: evaluate_Verdict;

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
        let _e75 = p.member.light;
        let _e78 = samples.member[(0u + _e64.first_primitive)].normal[0u];
        let _e80 = global[0u];
        if (_e78 == _e80) {
            let _e83 = samples.member[(0u + _e64.first_primitive)].normal[1u];
            let _e85 = global[1u];
            if (_e83 == _e85) {
                let _e88 = samples.member[(0u + _e64.first_primitive)].normal[2u];
                let _e90 = global[2u];
                phi_1173_ = (_e88 == _e90);
                phi_1174_ = false;
            } else {
                phi_1173_ = bool();
                phi_1174_ = true;
            }
            let _e93 = phi_1173_;
            let _e95 = phi_1174_;
            phi_1175_ = _e93;
            phi_1176_ = _e95;
        } else {
            phi_1175_ = bool();
            phi_1176_ = true;
        }
        let _e97 = phi_1175_;
        let _e99 = phi_1176_;
        if _e99 {
            phi_1180_ = false;
        } else {
            phi_1180_ = _e97;
        }
        let _e101 = phi_1180_;
        if !(_e101) {
            let _e104 = samples.member[(0u + _e64.first_primitive)].normal;
            let _e106 = samples.member[(0u + _e64.first_primitive)].position;
            if ((((_e104.x * (_e75.x - (_e106.x * _e75.w))) + (_e104.y * (_e75.y - (_e106.y * _e75.w)))) + (_e104.z * (_e75.z - (_e106.z * _e75.w)))) > 0f) {
                let _e130 = samples.member[(0u + _e64.first_primitive)].flags;
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_1224_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, ((_e130 & 1u) == 0u));
            } else {
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e153.unnamed.visibility, false), _e153.unnamed_1);
                phi_1224_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e159.unnamed, true);
            }
            let _e164 = phi_1224_;
            phi_1228_ = _e164;
        } else {
            let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
            phi_1228_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, true);
        }
        let _e181 = phi_1228_;
        if _e181.unnamed_1 {
            phi_1919_ = evaluate_Verdict(_e181.unnamed.visibility, _e181.unnamed.is_doubted);
            phi_1920_ = evaluate_Verdict();
            phi_1921_ = true;
        } else {
            let _e189 = samples.member[(0u + _e64.first_primitive)].position;
            let _e191 = p.member.map_size;
            let _e193 = (0.5f / f32(_e191));
            let _e200 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e207 = lt_math_LightPoint(vec2<f32>(_e200.uv.x, 0f), _e200.depth, _e200.is_inside);
            let _e211 = lt_math_LightPoint(_e207.uv, 0f, _e207.is_inside);
            phi_1248_ = lt_math_LightPoint();
            phi_1251_ = 0u;
            phi_1253_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e211.uv, _e211.depth, false));
            loop {
                let _e218 = phi_1248_;
                let _e220 = phi_1251_;
                let _e222 = phi_1253_;
                local_1 = _e222;
                local_2 = _e222;
                local_3 = _e222;
                local_4 = _e222;
                if (_e220 < _e70) {
                    if _e222.point.is_inside {
                        phi_1414_ = lt_math_LightPoint();
                        phi_1415_ = u32();
                        phi_1416_ = lt_math_LevelPoint();
                        phi_1417_ = false;
                    } else {
                        if (_e220 < _e58) {
                        } else {
                            return;
                        }
                        let _e233 = levels.member[(0u + _e220)].row_w;
                        let _e244 = ((((_e233.x * _e189.x) + (_e233.y * _e189.y)) + (_e233.z * _e189.z)) + (_e233.w * 1f));
                        let _e246 = levels.member[(0u + _e220)].row_x;
                        let _e258 = (((((_e246.x * _e189.x) + (_e246.y * _e189.y)) + (_e246.z * _e189.z)) + (_e246.w * 1f)) / _e244);
                        let _e260 = levels.member[(0u + _e220)].row_y;
                        let _e272 = (((((_e260.x * _e189.x) + (_e260.y * _e189.y)) + (_e260.z * _e189.z)) + (_e260.w * 1f)) / _e244);
                        let _e274 = levels.member[(0u + _e220)].row_z;
                        let _e285 = ((((_e274.x * _e189.x) + (_e274.y * _e189.y)) + (_e274.z * _e189.z)) + (_e274.w * 1f));
                        if (_e244 > 0f) {
                            if (_e258 >= 0f) {
                                phi_1339_ = (_e258 <= 1f);
                            } else {
                                phi_1339_ = false;
                            }
                            let _e290 = phi_1339_;
                            if _e290 {
                                if (_e272 >= 0f) {
                                    phi_1348_ = (_e272 <= 1f);
                                } else {
                                    phi_1348_ = false;
                                }
                                let _e294 = phi_1348_;
                                if _e294 {
                                    if (_e285 >= 0f) {
                                        phi_1357_ = (_e285 <= 1f);
                                    } else {
                                        phi_1357_ = false;
                                    }
                                    let _e298 = phi_1357_;
                                    phi_1358_ = _e298;
                                    phi_1359_ = false;
                                } else {
                                    phi_1358_ = bool();
                                    phi_1359_ = true;
                                }
                                let _e300 = phi_1358_;
                                let _e302 = phi_1359_;
                                phi_1360_ = _e300;
                                phi_1361_ = _e302;
                            } else {
                                phi_1360_ = bool();
                                phi_1361_ = true;
                            }
                            let _e304 = phi_1360_;
                            let _e306 = phi_1361_;
                            phi_1362_ = _e304;
                            phi_1363_ = _e306;
                        } else {
                            phi_1362_ = bool();
                            phi_1363_ = true;
                        }
                        let _e308 = phi_1362_;
                        let _e310 = phi_1363_;
                        if _e310 {
                            phi_1367_ = false;
                        } else {
                            phi_1367_ = _e308;
                        }
                        let _e312 = phi_1367_;
                        if _e312 {
                            if (_e258 >= _e193) {
                                if (_e258 <= (1f - _e193)) {
                                    if (_e272 >= _e193) {
                                        phi_1394_ = (_e272 <= (1f - _e193));
                                        phi_1395_ = false;
                                    } else {
                                        phi_1394_ = bool();
                                        phi_1395_ = true;
                                    }
                                    let _e320 = phi_1394_;
                                    let _e322 = phi_1395_;
                                    phi_1396_ = _e320;
                                    phi_1397_ = _e322;
                                } else {
                                    phi_1396_ = bool();
                                    phi_1397_ = true;
                                }
                                let _e324 = phi_1396_;
                                let _e326 = phi_1397_;
                                phi_1398_ = _e324;
                                phi_1399_ = _e326;
                            } else {
                                phi_1398_ = bool();
                                phi_1399_ = true;
                            }
                            let _e328 = phi_1398_;
                            let _e330 = phi_1399_;
                            phi_1400_ = _e328;
                            phi_1401_ = _e330;
                        } else {
                            phi_1400_ = bool();
                            phi_1401_ = true;
                        }
                        let _e332 = phi_1400_;
                        let _e334 = phi_1401_;
                        if _e334 {
                            phi_1405_ = false;
                        } else {
                            phi_1405_ = _e332;
                        }
                        let _e336 = phi_1405_;
                        let _e343 = lt_math_LightPoint(vec2<f32>(_e258, _e218.uv.y), _e218.depth, _e218.is_inside);
                        let _e350 = lt_math_LightPoint(vec2<f32>(_e343.uv.x, _e272), _e343.depth, _e343.is_inside);
                        let _e354 = lt_math_LightPoint(_e350.uv, _e285, _e350.is_inside);
                        let _e358 = lt_math_LightPoint(_e354.uv, _e354.depth, _e336);
                        phi_1414_ = _e358;
                        phi_1415_ = (_e220 + 1u);
                        phi_1416_ = lt_math_LevelPoint(_e220, _e358);
                        phi_1417_ = true;
                    }
                    let _e362 = phi_1414_;
                    let _e364 = phi_1415_;
                    let _e366 = phi_1416_;
                    let _e368 = phi_1417_;
                    phi_1249_ = _e362;
                    phi_1252_ = _e364;
                    phi_1254_ = _e366;
                    phi_1418_ = _e368;
                } else {
                    phi_1249_ = lt_math_LightPoint();
                    phi_1252_ = u32();
                    phi_1254_ = lt_math_LevelPoint();
                    phi_1418_ = false;
                }
                let _e370 = phi_1249_;
                let _e372 = phi_1252_;
                let _e374 = phi_1254_;
                let _e376 = phi_1418_;
                continue;
                continuing {
                    phi_1248_ = _e370;
                    phi_1251_ = _e372;
                    phi_1253_ = _e374;
                    break if !(_e376);
                }
            }
            let _e379 = local_1;
            if _e379.point.is_inside {
                if (0f > 0f) {
                    let _e385 = local_2;
                    if (_e385.level < _e58) {
                    } else {
                        return;
                    }
                    let _e390 = levels.member[(0u + _e385.level)];
                    let _e396 = global[0u];
                    if (_e390.row_w.x == _e396) {
                        let _e399 = global[1u];
                        if (_e390.row_w.y == _e399) {
                            let _e402 = global[2u];
                            phi_1458_ = (_e390.row_w.z == _e402);
                            phi_1459_ = false;
                        } else {
                            phi_1458_ = bool();
                            phi_1459_ = true;
                        }
                        let _e405 = phi_1458_;
                        let _e407 = phi_1459_;
                        phi_1460_ = _e405;
                        phi_1461_ = _e407;
                    } else {
                        phi_1460_ = bool();
                        phi_1461_ = true;
                    }
                    let _e409 = phi_1460_;
                    let _e411 = phi_1461_;
                    if _e411 {
                        phi_1465_ = false;
                    } else {
                        phi_1465_ = _e409;
                    }
                    let _e413 = phi_1465_;
                    if _e413 {
                        let _e415 = samples.member[(0u + _e64.first_primitive)].normal;
                        let _e417 = p.member.map_size;
                        let _e487 = ((abs(((((_e390.row_x.x * _e415.x) + (_e390.row_x.y * _e415.y)) + (_e390.row_x.z * _e415.z)) / (((_e390.row_x.x * _e390.row_x.x) + (_e390.row_x.y * _e390.row_x.y)) + (_e390.row_x.z * _e390.row_x.z)))) + abs(((((_e390.row_y.x * _e415.x) + (_e390.row_y.y * _e415.y)) + (_e390.row_y.z * _e415.z)) / (((_e390.row_y.x * _e390.row_y.x) + (_e390.row_y.y * _e390.row_y.y)) + (_e390.row_y.z * _e390.row_y.z))))) / (abs(((((_e390.row_z.x * _e415.x) + (_e390.row_z.y * _e415.y)) + (_e390.row_z.z * _e415.z)) / (((_e390.row_z.x * _e390.row_z.x) + (_e390.row_z.y * _e390.row_z.y)) + (_e390.row_z.z * _e390.row_z.z)))) * f32(_e417)));
                        if (_e487 < 0.002f) {
                            phi_1547_ = _e487;
                        } else {
                            phi_1547_ = 0.002f;
                        }
                        let _e490 = phi_1547_;
                        phi_1664_ = _e490;
                    } else {
                        let _e492 = p.member.map_size;
                        let _e498 = samples.member[(0u + _e64.first_primitive)].position;
                        let _e509 = ((((_e390.row_w.x * _e498.x) + (_e390.row_w.y * _e498.y)) + (_e390.row_w.z * _e498.z)) + _e390.row_w.w);
                        let _e522 = ((_e390.row_x.x - (_e390.row_w.x * _e379.point.uv.x)) / _e509);
                        let _e523 = ((_e390.row_x.y - (_e390.row_w.y * _e379.point.uv.x)) / _e509);
                        let _e524 = ((_e390.row_x.z - (_e390.row_w.z * _e379.point.uv.x)) / _e509);
                        let _e537 = ((_e390.row_y.x - (_e390.row_w.x * _e379.point.uv.y)) / _e509);
                        let _e538 = ((_e390.row_y.y - (_e390.row_w.y * _e379.point.uv.y)) / _e509);
                        let _e539 = ((_e390.row_y.z - (_e390.row_w.z * _e379.point.uv.y)) / _e509);
                        let _e545 = samples.member[(0u + _e64.first_primitive)].normal;
                        let _e550 = ((_e538 * _e545.z) - (_e545.y * _e539));
                        let _e555 = ((_e539 * _e545.x) - (_e545.z * _e537));
                        let _e560 = ((_e537 * _e545.y) - (_e545.x * _e538));
                        let _e562 = samples.member[(0u + _e64.first_primitive)].normal;
                        let _e567 = ((_e523 * _e562.z) - (_e562.y * _e524));
                        let _e572 = ((_e524 * _e562.x) - (_e562.z * _e522));
                        let _e577 = ((_e522 * _e562.y) - (_e562.x * _e523));
                        let _e604 = ((abs(((((_e390.row_z.x * _e550) + (_e390.row_z.y * _e555)) + (_e390.row_z.z * _e560)) / (((_e522 * _e550) + (_e523 * _e555)) + (_e524 * _e560)))) + abs(((((_e390.row_z.x * _e567) + (_e390.row_z.y * _e572)) + (_e390.row_z.z * _e577)) / (((_e537 * _e567) + (_e538 * _e572)) + (_e539 * _e577))))) / f32(_e492));
                        if (_e604 < 0.002f) {
                            phi_1663_ = _e604;
                        } else {
                            phi_1663_ = 0.002f;
                        }
                        let _e607 = phi_1663_;
                        phi_1664_ = _e607;
                    }
                    let _e609 = phi_1664_;
                    phi_1667_ = (_e379.point.depth - (0f * _e609));
                } else {
                    phi_1667_ = _e379.point.depth;
                }
                let _e613 = phi_1667_;
                let _e619 = p.member.map_size;
                let _e620 = f32(_e619);
                let _e623 = ((_e379.point.uv.x * _e620) - 0.5f);
                let _e624 = ((_e379.point.uv.y * _e620) - 0.5f);
                if (_e623 > -8388608f) {
                    let _e636 = f32(select(0i, select(select(i32(_e623), i32(-2147483648), (_e623 < bitcast<f32>(3472883712u))), 2147483647i, (_e623 > bitcast<f32>(1325400063u))), (_e623 == _e623)));
                    if (_e636 > _e623) {
                        phi_1696_ = 1f;
                    } else {
                        phi_1696_ = 0f;
                    }
                    let _e639 = phi_1696_;
                    if (_e623 < 8388608f) {
                        phi_1701_ = (_e636 - _e639);
                        phi_1702_ = false;
                    } else {
                        phi_1701_ = f32();
                        phi_1702_ = true;
                    }
                    let _e642 = phi_1701_;
                    let _e644 = phi_1702_;
                    phi_1703_ = _e642;
                    phi_1704_ = _e644;
                } else {
                    phi_1703_ = f32();
                    phi_1704_ = true;
                }
                let _e646 = phi_1703_;
                let _e648 = phi_1704_;
                if _e648 {
                    phi_1708_ = _e623;
                } else {
                    phi_1708_ = _e646;
                }
                let _e650 = phi_1708_;
                if (_e624 > -8388608f) {
                    let _e662 = f32(select(0i, select(select(i32(_e624), i32(-2147483648), (_e624 < bitcast<f32>(3472883712u))), 2147483647i, (_e624 > bitcast<f32>(1325400063u))), (_e624 == _e624)));
                    if (_e662 > _e624) {
                        phi_1728_ = 1f;
                    } else {
                        phi_1728_ = 0f;
                    }
                    let _e665 = phi_1728_;
                    if (_e624 < 8388608f) {
                        phi_1733_ = (_e662 - _e665);
                        phi_1734_ = false;
                    } else {
                        phi_1733_ = f32();
                        phi_1734_ = true;
                    }
                    let _e668 = phi_1733_;
                    let _e670 = phi_1734_;
                    phi_1735_ = _e668;
                    phi_1736_ = _e670;
                } else {
                    phi_1735_ = f32();
                    phi_1736_ = true;
                }
                let _e672 = phi_1735_;
                let _e674 = phi_1736_;
                if _e674 {
                    phi_1740_ = _e624;
                } else {
                    phi_1740_ = _e672;
                }
                let _e676 = phi_1740_;
                let _e677 = (_e623 - _e650);
                let _e678 = (_e624 - _e676);
                let _e687 = select(0i, select(select(i32(_e650), i32(-2147483648), (_e650 < bitcast<f32>(3472883712u))), 2147483647i, (_e650 > bitcast<f32>(1325400063u))), (_e650 == _e650));
                let _e696 = select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < bitcast<f32>(3472883712u))), 2147483647i, (_e676 > bitcast<f32>(1325400063u))), (_e676 == _e676));
                let _e707 = p.member.test;
                let _e708 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e707);
                let _e710 = p.member.map_size;
                let _e712 = local_3;
                local = _e708;
                let _e715 = ((_e712.level * _e710) * _e710);
                let _e717 = (bitcast<i32>(_e710) - 1i);
                if (_e687 > 0i) {
                    phi_1789_ = _e687;
                } else {
                    phi_1789_ = 0i;
                }
                let _e720 = phi_1789_;
                if (_e696 > 0i) {
                    phi_1794_ = _e696;
                } else {
                    phi_1794_ = 0i;
                }
                let _e723 = phi_1794_;
                if (_e720 < _e717) {
                    phi_1799_ = _e720;
                } else {
                    phi_1799_ = _e717;
                }
                let _e726 = phi_1799_;
                if (_e723 < _e717) {
                    phi_1804_ = _e723;
                } else {
                    phi_1804_ = _e717;
                }
                let _e729 = phi_1804_;
                let _e730 = bitcast<u32>(_e726);
                let _e732 = (_e687 + 1i);
                let _e733 = (_e696 + 1i);
                if (_e732 > 0i) {
                    phi_1813_ = _e732;
                } else {
                    phi_1813_ = 0i;
                }
                let _e736 = phi_1813_;
                if (_e733 > 0i) {
                    phi_1818_ = _e733;
                } else {
                    phi_1818_ = 0i;
                }
                let _e739 = phi_1818_;
                if (_e736 < _e717) {
                    phi_1823_ = _e736;
                } else {
                    phi_1823_ = _e717;
                }
                let _e742 = phi_1823_;
                if (_e739 < _e717) {
                    phi_1828_ = _e739;
                } else {
                    phi_1828_ = _e717;
                }
                let _e745 = phi_1828_;
                let _e746 = bitcast<u32>(_e742);
                let _e748 = (bitcast<u32>(_e729) * _e710);
                let _e749 = (bitcast<u32>(_e745) * _e710);
                let _e754 = ((_e748 + _e730) + _e715);
                let _e755 = ((_e748 + _e746) + _e715);
                let _e756 = ((_e749 + _e730) + _e715);
                let _e757 = ((_e749 + _e746) + _e715);
                if (_e754 < _e52) {
                } else {
                    return;
                }
                let _e761 = map.member[(0u + _e754)];
                if (_e755 < _e52) {
                } else {
                    return;
                }
                let _e765 = map.member[(0u + _e755)];
                if (_e756 < _e52) {
                } else {
                    return;
                }
                let _e769 = map.member[(0u + _e756)];
                if (_e757 < _e52) {
                } else {
                    return;
                }
                let _e773 = map.member[(0u + _e757)];
                let _e775 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e761, _e765, _e769, _e773), vec4<f32>(((1f - _e677) * (1f - _e678)), (_e677 * (1f - _e678)), ((1f - _e677) * _e678), (_e677 * _e678)), _e613);
                let _e777 = p.member.fade_uv;
                if (_e777 > 0f) {
                    let _e780 = local_4;
                    if ((_e780.level + 1u) == _e70) {
                        let _e789 = p.member.fade_uv;
                        let _e791 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e379.point.uv.x, (1f - _e379.point.uv.x));
                        let _e793 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e379.point.uv.y, (1f - _e379.point.uv.y));
                        let _e794 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e791, _e793);
                        if (_e794 < _e789) {
                            phi_1900_ = (1f - ((1f - _e775) * (_e794 / _e789)));
                        } else {
                            phi_1900_ = _e775;
                        }
                        let _e801 = phi_1900_;
                        phi_1902_ = evaluate_Verdict(_e801, false);
                        phi_1903_ = false;
                    } else {
                        phi_1902_ = evaluate_Verdict();
                        phi_1903_ = true;
                    }
                    let _e804 = phi_1902_;
                    let _e806 = phi_1903_;
                    phi_1904_ = _e804;
                    phi_1905_ = _e806;
                } else {
                    phi_1904_ = evaluate_Verdict();
                    phi_1905_ = true;
                }
                let _e808 = phi_1904_;
                let _e810 = phi_1905_;
                if _e810 {
                    phi_1910_ = evaluate_Verdict(_e775, false);
                    phi_1911_ = false;
                } else {
                    phi_1910_ = evaluate_Verdict();
                    phi_1911_ = true;
                }
                let _e813 = phi_1910_;
                let _e815 = phi_1911_;
                phi_1913_ = _e813;
                phi_1914_ = _e808;
                phi_1915_ = _e815;
            } else {
                phi_1913_ = evaluate_Verdict();
                phi_1914_ = evaluate_Verdict(1f, false);
                phi_1915_ = true;
            }
            let _e818 = phi_1913_;
            let _e820 = phi_1914_;
            let _e822 = phi_1915_;
            if _e822 {
            }
            phi_1919_ = _e820;
            phi_1920_ = _e818;
            phi_1921_ = _e822;
        }
        let _e824 = phi_1919_;
        let _e826 = phi_1920_;
        let _e828 = phi_1921_;
        if _e828 {
            phi_1925_ = _e824;
        } else {
            phi_1925_ = _e826;
        }
        let _e830 = phi_1925_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e830.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_hausdorff_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
