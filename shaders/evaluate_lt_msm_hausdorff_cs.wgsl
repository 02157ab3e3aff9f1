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

struct type_28 {
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
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_28;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_133_: lt_bvh_traverse_Tree;
    var phi_134_: bool;
    var phi_135_: lt_bvh_traverse_Tree;
    var phi_136_: bool;
    var phi_141_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_133_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_134_ = false;
        } else {
            phi_133_ = lt_bvh_traverse_Tree();
            phi_134_ = true;
        }
        let _e51 = phi_133_;
        let _e53 = phi_134_;
        phi_135_ = _e51;
        phi_136_ = _e53;
    } else {
        phi_135_ = lt_bvh_traverse_Tree();
        phi_136_ = true;
    }
    let _e55 = phi_135_;
    let _e57 = phi_136_;
    if _e57 {
        phi_141_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_141_ = _e55;
    }
    let _e62 = phi_141_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_168_: f32;
    var phi_169_: f32;
    var phi_170_: f32;
    var phi_187_: f32;
    var phi_188_: f32;
    var phi_189_: f32;
    var phi_205_: f32;
    var phi_206_: f32;
    var phi_207_: f32;
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_225_: f32;
    var phi_241_: f32;
    var phi_242_: f32;
    var phi_243_: f32;
    var phi_278_: bool;
    var phi_279_: bool;
    var phi_280_: bool;
    var phi_281_: bool;
    var phi_282_: bool;
    var phi_283_: bool;
    var phi_287_: bool;
    var phi_598_: f32;
    var phi_599_: f32;
    var phi_600_: f32;
    var phi_617_: f32;
    var phi_618_: f32;
    var phi_619_: f32;
    var phi_636_: f32;
    var phi_637_: f32;
    var phi_638_: f32;
    var phi_655_: f32;
    var phi_656_: f32;
    var phi_657_: f32;
    var phi_680_: f32;
    var phi_681_: f32;
    var phi_682_: f32;
    var phi_693_: f32;
    var phi_708_: f32;
    var phi_710_: lt_bvh_slab_Span;
    var phi_768_: f32;
    var phi_769_: f32;
    var phi_770_: f32;
    var phi_771_: f32;
    var phi_772_: f32;
    var phi_773_: bool;
    var phi_777_: f32;
    var phi_787_: bool;
    var phi_800_: bool;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_815_: bool;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_821_: bool;
    var phi_872_: f32;
    var phi_873_: f32;
    var phi_874_: f32;
    var phi_891_: f32;
    var phi_892_: f32;
    var phi_893_: f32;
    var phi_910_: f32;
    var phi_911_: f32;
    var phi_912_: f32;
    var phi_929_: f32;
    var phi_930_: f32;
    var phi_931_: f32;
    var phi_954_: f32;
    var phi_955_: f32;
    var phi_956_: f32;
    var phi_1043_: f32;
    var phi_1044_: f32;
    var phi_1055_: bool;
    var phi_1059_: f32;
    var phi_1060_: f32;
    var phi_1075_: f32;
    var phi_1076_: f32;
    var phi_1077_: f32;
    var phi_1078_: f32;
    var phi_1079_: f32;
    var phi_1080_: f32;
    var phi_1081_: f32;
    var phi_1082_: bool;
    var phi_1083_: f32;
    var phi_1084_: f32;
    var phi_1085_: bool;
    var phi_1089_: f32;

    let _e42 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_170_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_169_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_168_ = 1f;
            } else {
                phi_168_ = param_7;
            }
            let _e49 = phi_168_;
            phi_169_ = _e49;
        }
        let _e51 = phi_169_;
        phi_170_ = _e51;
    }
    let _e53 = phi_170_;
    let _e54 = (_e53 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_189_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_188_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_187_ = 1f;
            } else {
                phi_187_ = param_5.x;
            }
            let _e62 = phi_187_;
            phi_188_ = _e62;
        }
        let _e64 = phi_188_;
        phi_189_ = _e64;
    }
    let _e66 = phi_189_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_207_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_206_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_205_ = 1f;
            } else {
                phi_205_ = param_5.y;
            }
            let _e74 = phi_205_;
            phi_206_ = _e74;
        }
        let _e76 = phi_206_;
        phi_207_ = _e76;
    }
    let _e78 = phi_207_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_225_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_224_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_223_ = 1f;
            } else {
                phi_223_ = param_5.z;
            }
            let _e86 = phi_223_;
            phi_224_ = _e86;
        }
        let _e88 = phi_224_;
        phi_225_ = _e88;
    }
    let _e90 = phi_225_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_243_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_242_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_241_ = 1f;
            } else {
                phi_241_ = param_5.w;
            }
            let _e98 = phi_241_;
            phi_242_ = _e98;
        }
        let _e100 = phi_242_;
        phi_243_ = _e100;
    }
    let _e102 = phi_243_;
    let _e103 = (_e66 - _e54);
    let _e104 = (_e78 - _e54);
    let _e105 = (_e90 - _e54);
    let _e106 = (_e102 - _e54);
    let _e117 = ((((_e103 * param_6.x) + (_e104 * param_6.y)) + (_e105 * param_6.z)) + (_e106 * param_6.w));
    if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
        phi_1083_ = _e117;
        phi_1084_ = f32();
        phi_1085_ = true;
    } else {
        if (_e103 >= 0f) {
            if (_e104 >= 0f) {
                if (_e105 >= 0f) {
                    phi_278_ = (_e106 >= 0f);
                    phi_279_ = false;
                } else {
                    phi_278_ = bool();
                    phi_279_ = true;
                }
                let _e126 = phi_278_;
                let _e128 = phi_279_;
                phi_280_ = _e126;
                phi_281_ = _e128;
            } else {
                phi_280_ = bool();
                phi_281_ = true;
            }
            let _e130 = phi_280_;
            let _e132 = phi_281_;
            phi_282_ = _e130;
            phi_283_ = _e132;
        } else {
            phi_282_ = bool();
            phi_283_ = true;
        }
        let _e134 = phi_282_;
        let _e136 = phi_283_;
        if _e136 {
            phi_287_ = false;
        } else {
            phi_287_ = _e134;
        }
        let _e138 = phi_287_;
        if _e138 {
            phi_1080_ = 1f;
            phi_1081_ = f32();
            phi_1082_ = true;
        } else {
            let _e139 = (0.5f * _e42);
            let _e140 = (1f - _e42);
            let _e142 = (param_6.x * _e140);
            let _e144 = (param_6.y * _e140);
            let _e146 = (param_6.z * _e140);
            let _e148 = (param_6.w * _e140);
            let _e149 = -(_e54);
            let _e150 = (1f - _e54);
            let _e152 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e66);
            let _e154 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e78);
            let _e156 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e90);
            let _e158 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e102);
            let _e159 = (_e103 - _e104);
            let _e160 = (_e104 - _e105);
            let _e161 = (_e105 - _e106);
            let _e162 = (_e106 - _e103);
            let _e163 = (_e159 * _e159);
            let _e164 = (_e160 * _e160);
            let _e165 = (_e161 * _e161);
            let _e166 = (_e162 * _e162);
            let _e167 = (_e103 - _e105);
            let _e168 = (_e104 - _e106);
            let _e169 = (_e105 - _e103);
            let _e170 = (_e106 - _e104);
            let _e171 = (_e167 * _e167);
            let _e172 = (_e168 * _e168);
            let _e173 = (_e169 * _e169);
            let _e174 = (_e170 * _e170);
            let _e179 = ((_e142 * _e144) * _e163);
            let _e180 = ((_e144 * _e146) * _e164);
            let _e181 = ((_e146 * _e148) * _e165);
            let _e182 = ((_e148 * _e142) * _e166);
            let _e191 = (((0.5f * _e142) * _e146) * _e171);
            let _e192 = (((0.5f * _e144) * _e148) * _e172);
            let _e193 = (((0.5f * _e146) * _e142) * _e173);
            let _e194 = (((0.5f * _e148) * _e144) * _e174);
            let _e195 = (_e103 * _e104);
            let _e196 = (_e104 * _e105);
            let _e197 = (_e105 * _e106);
            let _e198 = (_e106 * _e103);
            let _e199 = (_e103 * _e105);
            let _e200 = (_e104 * _e106);
            let _e201 = (_e105 * _e103);
            let _e202 = (_e106 * _e104);
            let _e203 = (_e179 * _e195);
            let _e204 = (_e180 * _e196);
            let _e205 = (_e181 * _e197);
            let _e206 = (_e182 * _e198);
            let _e207 = (_e191 * _e199);
            let _e208 = (_e192 * _e200);
            let _e209 = (_e193 * _e201);
            let _e210 = (_e194 * _e202);
            let _e211 = (_e66 * _e66);
            let _e212 = (_e78 * _e78);
            let _e213 = (_e90 * _e90);
            let _e214 = (_e102 * _e102);
            let _e215 = (_e152 * _e152);
            let _e216 = (_e154 * _e154);
            let _e217 = (_e156 * _e156);
            let _e218 = (_e158 * _e158);
            let _e219 = (_e139 * _e142);
            let _e220 = (_e139 * _e144);
            let _e221 = (_e139 * _e146);
            let _e222 = (_e139 * _e148);
            let _e231 = (((_e219 * _e103) * _e211) * _e149);
            let _e232 = (((_e220 * _e104) * _e212) * _e149);
            let _e233 = (((_e221 * _e105) * _e213) * _e149);
            let _e234 = (((_e222 * _e106) * _e214) * _e149);
            let _e243 = (((_e219 * _e103) * _e215) * _e150);
            let _e244 = (((_e220 * _e104) * _e216) * _e150);
            let _e245 = (((_e221 * _e105) * _e217) * _e150);
            let _e246 = (((_e222 * _e106) * _e218) * _e150);
            let _e414 = (((((((_e179 * _e146) * _e164) * _e171) + (_e139 * (((_e179 * ((_e211 * _e212) + (_e215 * _e216))) + (_e191 * ((_e211 * _e213) + (_e215 * _e217)))) + ((_e219 * _e211) * _e215)))) + ((((_e180 * _e148) * _e165) * _e172) + (_e139 * (((_e180 * ((_e212 * _e213) + (_e216 * _e217))) + (_e192 * ((_e212 * _e214) + (_e216 * _e218)))) + ((_e220 * _e212) * _e216))))) + ((((_e181 * _e142) * _e166) * _e173) + (_e139 * (((_e181 * ((_e213 * _e214) + (_e217 * _e218))) + (_e193 * ((_e213 * _e211) + (_e217 * _e215)))) + ((_e221 * _e213) * _e217))))) + ((((_e182 * _e144) * _e163) * _e174) + (_e139 * (((_e182 * ((_e214 * _e211) + (_e218 * _e215))) + (_e194 * ((_e214 * _e212) + (_e218 * _e216)))) + ((_e222 * _e214) * _e218)))));
            let _e417 = (((_e139 * _e139) * _e149) * _e150);
            let _e420 = (((((((_e203 * _e195) + (_e207 * _e199)) + (_e103 * ((_e231 * _e149) + (_e243 * _e150)))) + (((_e204 * _e196) + (_e208 * _e200)) + (_e104 * ((_e232 * _e149) + (_e244 * _e150))))) + (((_e205 * _e197) + (_e209 * _e201)) + (_e105 * ((_e233 * _e149) + (_e245 * _e150))))) + (((_e206 * _e198) + (_e210 * _e202)) + (_e106 * ((_e234 * _e149) + (_e246 * _e150))))) + ((_e417 * _e149) * _e150));
            let _e426 = (_e420 < 0.0000000000000000000000000000000001f);
            if _e426 {
                if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
                    phi_600_ = _e103;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_599_ = 0f;
                    } else {
                        if (_e103 < 0f) {
                            phi_598_ = 0f;
                        } else {
                            phi_598_ = 1f;
                        }
                        let _e435 = phi_598_;
                        phi_599_ = _e435;
                    }
                    let _e437 = phi_599_;
                    phi_600_ = _e437;
                }
                let _e439 = phi_600_;
                if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                    phi_619_ = _e104;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_618_ = 0f;
                    } else {
                        if (_e104 < 0f) {
                            phi_617_ = 0f;
                        } else {
                            phi_617_ = 1f;
                        }
                        let _e448 = phi_617_;
                        phi_618_ = _e448;
                    }
                    let _e450 = phi_618_;
                    phi_619_ = _e450;
                }
                let _e452 = phi_619_;
                if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
                    phi_638_ = _e105;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_637_ = 0f;
                    } else {
                        if (_e105 < 0f) {
                            phi_636_ = 0f;
                        } else {
                            phi_636_ = 1f;
                        }
                        let _e461 = phi_636_;
                        phi_637_ = _e461;
                    }
                    let _e463 = phi_637_;
                    phi_638_ = _e463;
                }
                let _e465 = phi_638_;
                if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                    phi_657_ = _e106;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_656_ = 0f;
                    } else {
                        if (_e106 < 0f) {
                            phi_655_ = 0f;
                        } else {
                            phi_655_ = 1f;
                        }
                        let _e474 = phi_655_;
                        phi_656_ = _e474;
                    }
                    let _e476 = phi_656_;
                    phi_657_ = _e476;
                }
                let _e478 = phi_657_;
                let _e486 = (((((_e439 * _e142) + (_e452 * _e144)) + (_e465 * _e146)) + (_e478 * _e148)) + _e139);
                if ((bitcast<u32>(_e486) & 2147483647u) > 2139095040u) {
                    phi_682_ = _e486;
                } else {
                    if (_e486 < 0f) {
                        phi_681_ = 0f;
                    } else {
                        if (_e486 > 1f) {
                            phi_680_ = 1f;
                        } else {
                            phi_680_ = _e486;
                        }
                        let _e493 = phi_680_;
                        phi_681_ = _e493;
                    }
                    let _e495 = phi_681_;
                    phi_682_ = _e495;
                }
                let _e497 = phi_682_;
                phi_1078_ = _e497;
                phi_1079_ = f32();
            } else {
                let _e499 = ((0.5f * -(((((((((_e203 * (_e103 + _e104)) + (_e207 * (_e103 + _e105))) + (_e231 * (_e103 + _e149))) + (_e243 * (_e103 + _e150))) + ((((_e204 * (_e104 + _e105)) + (_e208 * (_e104 + _e106))) + (_e232 * (_e104 + _e149))) + (_e244 * (_e104 + _e150)))) + ((((_e205 * (_e105 + _e106)) + (_e209 * (_e105 + _e103))) + (_e233 * (_e105 + _e149))) + (_e245 * (_e105 + _e150)))) + ((((_e206 * (_e106 + _e103)) + (_e210 * (_e106 + _e104))) + (_e234 * (_e106 + _e149))) + (_e246 * (_e106 + _e150)))) + (_e417 * (_e149 + _e150))))) / _e420);
                let _e500 = ((((((((_e203 + _e207) + _e231) + _e243) + (((_e204 + _e208) + _e232) + _e244)) + (((_e205 + _e209) + _e233) + _e245)) + (((_e206 + _e210) + _e234) + _e246)) + _e417) / _e420);
                let _e502 = ((_e499 * _e499) - _e500);
                if (_e502 > 0f) {
                    phi_693_ = sqrt(_e502);
                } else {
                    phi_693_ = 0f;
                }
                let _e506 = phi_693_;
                if (_e499 > 0f) {
                    let _e509 = (-(_e499) - _e506);
                    phi_710_ = lt_bvh_slab_Span(_e509, (_e500 / _e509));
                } else {
                    let _e512 = (_e506 - _e499);
                    if (_e512 > 0f) {
                        phi_708_ = (_e500 / _e512);
                    } else {
                        phi_708_ = 0f;
                    }
                    let _e516 = phi_708_;
                    phi_710_ = lt_bvh_slab_Span(_e516, _e512);
                }
                let _e519 = phi_710_;
                if (_e519.near >= 0f) {
                    phi_771_ = 1f;
                    phi_772_ = f32();
                    phi_773_ = true;
                } else {
                    let _e523 = (_e519.far <= 0f);
                    if _e523 {
                        phi_769_ = (_e414 / _e420);
                        phi_770_ = f32();
                    } else {
                        let _e534 = (((((_e142 * _e103) + (_e144 * _e104)) + (_e146 * _e105)) + (_e148 * _e106)) + (_e139 * (_e149 + _e150)));
                        let _e550 = (((((_e142 * (_e103 * _e103)) + (_e144 * (_e104 * _e104))) + (_e146 * (_e105 * _e105))) + (_e148 * (_e106 * _e106))) + (_e139 * ((_e149 * _e149) + (_e150 * _e150))));
                        if (-(_e519.near) <= _e519.far) {
                            phi_768_ = (1f - (((_e519.near * _e519.near) * ((_e519.far * _e550) - _e534)) / (_e519.far - _e519.near)));
                        } else {
                            phi_768_ = ((_e414 / _e420) + (((_e519.far * _e519.far) * (_e534 - (_e519.near * _e550))) / (_e519.far - _e519.near)));
                        }
                        let _e569 = phi_768_;
                        phi_769_ = f32();
                        phi_770_ = _e569;
                    }
                    let _e571 = phi_769_;
                    let _e573 = phi_770_;
                    phi_771_ = _e571;
                    phi_772_ = _e573;
                    phi_773_ = _e523;
                }
                let _e575 = phi_771_;
                let _e577 = phi_772_;
                let _e579 = phi_773_;
                if _e579 {
                    phi_777_ = _e575;
                } else {
                    phi_777_ = _e577;
                }
                let _e581 = phi_777_;
                if ((_e519.near * _e149) >= (1f - 0.00001f)) {
                    phi_787_ = true;
                } else {
                    phi_787_ = ((_e519.near * _e150) >= (1f - 0.00001f));
                }
                let _e589 = phi_787_;
                if _e589 {
                    if ((_e519.far * _e149) >= (1f - 0.00001f)) {
                        phi_800_ = true;
                    } else {
                        phi_800_ = ((_e519.far * _e150) >= (1f - 0.00001f));
                    }
                    let _e597 = phi_800_;
                    if _e597 {
                        phi_804_ = false;
                    } else {
                        phi_804_ = true;
                    }
                    let _e599 = phi_804_;
                    phi_805_ = _e599;
                } else {
                    phi_805_ = true;
                }
                let _e601 = phi_805_;
                if _e601 {
                    let _e603 = (-(_e149) < 0.0001f);
                    if _e603 {
                        phi_815_ = bool();
                    } else {
                        phi_815_ = (_e150 < 0.0001f);
                    }
                    let _e606 = phi_815_;
                    phi_816_ = _e606;
                    phi_817_ = _e603;
                } else {
                    phi_816_ = bool();
                    phi_817_ = true;
                }
                let _e608 = phi_816_;
                let _e610 = phi_817_;
                if _e610 {
                    phi_821_ = true;
                } else {
                    phi_821_ = _e608;
                }
                let _e612 = phi_821_;
                if !(_e612) {
                    let _e618 = ((_e142 * _e66) * _e152);
                    let _e619 = ((_e144 * _e78) * _e154);
                    let _e620 = ((_e146 * _e90) * _e156);
                    let _e621 = ((_e148 * _e102) * _e158);
                    let _e639 = ((((_e618 * (_e103 * _e103)) + (_e619 * (_e104 * _e104))) + (_e620 * (_e105 * _e105))) + (_e621 * (_e106 * _e106)));
                    if (_e639 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
                            phi_874_ = _e103;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_873_ = 0f;
                            } else {
                                if (_e103 < 0f) {
                                    phi_872_ = 0f;
                                } else {
                                    phi_872_ = 1f;
                                }
                                let _e649 = phi_872_;
                                phi_873_ = _e649;
                            }
                            let _e651 = phi_873_;
                            phi_874_ = _e651;
                        }
                        let _e653 = phi_874_;
                        if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                            phi_893_ = _e104;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_892_ = 0f;
                            } else {
                                if (_e104 < 0f) {
                                    phi_891_ = 0f;
                                } else {
                                    phi_891_ = 1f;
                                }
                                let _e662 = phi_891_;
                                phi_892_ = _e662;
                            }
                            let _e664 = phi_892_;
                            phi_893_ = _e664;
                        }
                        let _e666 = phi_893_;
                        if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
                            phi_912_ = _e105;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_911_ = 0f;
                            } else {
                                if (_e105 < 0f) {
                                    phi_910_ = 0f;
                                } else {
                                    phi_910_ = 1f;
                                }
                                let _e675 = phi_910_;
                                phi_911_ = _e675;
                            }
                            let _e677 = phi_911_;
                            phi_912_ = _e677;
                        }
                        let _e679 = phi_912_;
                        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                            phi_931_ = _e106;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_930_ = 0f;
                            } else {
                                if (_e106 < 0f) {
                                    phi_929_ = 0f;
                                } else {
                                    phi_929_ = 1f;
                                }
                                let _e688 = phi_929_;
                                phi_930_ = _e688;
                            }
                            let _e690 = phi_930_;
                            phi_931_ = _e690;
                        }
                        let _e692 = phi_931_;
                        let _e700 = (((((_e653 * _e142) + (_e666 * _e144)) + (_e679 * _e146)) + (_e692 * _e148)) + _e139);
                        if ((bitcast<u32>(_e700) & 2147483647u) > 2139095040u) {
                            phi_956_ = _e700;
                        } else {
                            if (_e700 < 0f) {
                                phi_955_ = 0f;
                            } else {
                                if (_e700 > 1f) {
                                    phi_954_ = 1f;
                                } else {
                                    phi_954_ = _e700;
                                }
                                let _e707 = phi_954_;
                                phi_955_ = _e707;
                            }
                            let _e709 = phi_955_;
                            phi_956_ = _e709;
                        }
                        let _e711 = phi_956_;
                        phi_1044_ = _e711;
                    } else {
                        let _e712 = (((((_e618 * _e103) + (_e619 * _e104)) + (_e620 * _e105)) + (_e621 * _e106)) / _e639);
                        let _e729 = ((_e142 * _e103) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e712 * _e103)));
                        let _e730 = ((_e144 * _e104) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e712 * _e104)));
                        let _e731 = ((_e146 * _e105) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e712 * _e105)));
                        let _e732 = ((_e148 * _e106) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e712 * _e106)));
                        if (_e712 > 0f) {
                            phi_1043_ = ((1f - _e139) - (((((_e729 * _e152) + (_e730 * _e154)) + (_e731 * _e156)) + (_e732 * _e158)) / (_e149 * (1f - (_e149 * _e712)))));
                        } else {
                            phi_1043_ = ((((((((_e618 * ((_e619 * _e163) + ((0.5f * _e620) * _e171))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e619 * ((_e620 * _e164) + ((0.5f * _e621) * _e172))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e620 * ((_e621 * _e165) + ((0.5f * _e618) * _e173))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e621 * ((_e618 * _e166) + ((0.5f * _e619) * _e174))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e639 * (-(_e149) * _e150))) + _e139) + (((((_e729 * _e66) + (_e730 * _e78)) + (_e731 * _e90)) + (_e732 * _e102)) / (_e150 * (1f - (_e712 * _e150)))));
                        }
                        let _e796 = phi_1043_;
                        phi_1044_ = _e796;
                    }
                    let _e798 = phi_1044_;
                    if ((bitcast<u32>(_e581) & 2147483647u) > 2139095040u) {
                        phi_1055_ = true;
                    } else {
                        let _e802 = (_e581 < _e798);
                        if _e802 {
                        }
                        phi_1055_ = _e802;
                    }
                    let _e804 = phi_1055_;
                    if _e804 {
                        phi_1059_ = _e581;
                    } else {
                        phi_1059_ = _e798;
                    }
                    let _e806 = phi_1059_;
                    phi_1060_ = _e806;
                } else {
                    phi_1060_ = _e581;
                }
                let _e808 = phi_1060_;
                if ((bitcast<u32>(_e808) & 2147483647u) > 2139095040u) {
                    phi_1077_ = _e808;
                } else {
                    if (_e808 < 0f) {
                        phi_1076_ = 0f;
                    } else {
                        if (_e808 > 1f) {
                            phi_1075_ = 1f;
                        } else {
                            phi_1075_ = _e808;
                        }
                        let _e815 = phi_1075_;
                        phi_1076_ = _e815;
                    }
                    let _e817 = phi_1076_;
                    phi_1077_ = _e817;
                }
                let _e819 = phi_1077_;
                phi_1078_ = f32();
                phi_1079_ = _e819;
            }
            let _e821 = phi_1078_;
            let _e823 = phi_1079_;
            phi_1080_ = _e821;
            phi_1081_ = _e823;
            phi_1082_ = _e426;
        }
        let _e825 = phi_1080_;
        let _e827 = phi_1081_;
        let _e829 = phi_1082_;
        phi_1083_ = _e825;
        phi_1084_ = _e827;
        phi_1085_ = _e829;
    }
    let _e831 = phi_1083_;
    let _e833 = phi_1084_;
    let _e835 = phi_1085_;
    if _e835 {
        phi_1089_ = _e831;
    } else {
        phi_1089_ = _e833;
    }
    let _e837 = phi_1089_;
    return _e837;
}

fn function_() {
    var local: f32;
    var phi_1146_: bool;
    var phi_1147_: bool;
    var phi_1148_: bool;
    var phi_1149_: bool;
    var phi_1153_: bool;
    var phi_1197_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1201_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1275_: bool;
    var phi_1284_: bool;
    var phi_1293_: bool;
    var phi_1294_: bool;
    var phi_1295_: bool;
    var phi_1296_: bool;
    var phi_1297_: bool;
    var phi_1298_: bool;
    var phi_1299_: bool;
    var phi_1303_: bool;
    var phi_1393_: f32;
    var phi_1396_: f32;
    var phi_1425_: f32;
    var phi_1430_: f32;
    var phi_1431_: bool;
    var phi_1432_: f32;
    var phi_1433_: bool;
    var phi_1437_: f32;
    var phi_1457_: f32;
    var phi_1462_: f32;
    var phi_1463_: bool;
    var phi_1464_: f32;
    var phi_1465_: bool;
    var phi_1469_: f32;
    var phi_1517_: i32;
    var phi_1522_: i32;
    var phi_1527_: i32;
    var phi_1532_: i32;
    var phi_1541_: i32;
    var phi_1546_: i32;
    var phi_1551_: i32;
    var phi_1556_: i32;
    var phi_1607_: bool;
    var phi_1615_: bool;
    var phi_1627_: bool;
    var phi_1628_: bool;
    var phi_1632_: f32;
    var phi_1638_: f32;
    var phi_1640_: evaluate_Verdict;
    var phi_1645_: evaluate_Verdict;
    var phi_1646_: evaluate_Verdict;

    let _e39 = id_1;
    let _e46 = arrayLength((&map.member));
    let _e52 = p.member.size[0u];
    let _e54 = p.member.size[1u];
    let _e55 = lt_shaders_entry_pixel_index(_e39, _e52, _e54);
    if (bitcast<i32>(_e55.root) != 0i) {
        let _e61 = p.member.projection;
        if (_e55.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e65 = lt_math_OneLevel(_e61);
        let _e67 = p.member.light;
        let _e70 = samples.member[(0u + _e55.first_primitive)].normal[0u];
        let _e72 = global[0u];
        if (_e70 == _e72) {
            let _e75 = samples.member[(0u + _e55.first_primitive)].normal[1u];
            let _e77 = global[1u];
            if (_e75 == _e77) {
                let _e80 = samples.member[(0u + _e55.first_primitive)].normal[2u];
                let _e82 = global[2u];
                phi_1146_ = (_e80 == _e82);
                phi_1147_ = false;
            } else {
                phi_1146_ = bool();
                phi_1147_ = true;
            }
            let _e85 = phi_1146_;
            let _e87 = phi_1147_;
            phi_1148_ = _e85;
            phi_1149_ = _e87;
        } else {
            phi_1148_ = bool();
            phi_1149_ = true;
        }
        let _e89 = phi_1148_;
        let _e91 = phi_1149_;
        if _e91 {
            phi_1153_ = false;
        } else {
            phi_1153_ = _e89;
        }
        let _e93 = phi_1153_;
        if !(_e93) {
            let _e96 = samples.member[(0u + _e55.first_primitive)].normal;
            let _e98 = samples.member[(0u + _e55.first_primitive)].position;
            if ((((_e96.x * (_e67.x - (_e98.x * _e67.w))) + (_e96.y * (_e67.y - (_e98.y * _e67.w)))) + (_e96.z * (_e67.z - (_e98.z * _e67.w)))) > 0f) {
                let _e122 = samples.member[(0u + _e55.first_primitive)].flags;
                let _e130 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e130.unnamed.visibility, false), _e130.unnamed_1);
                phi_1197_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e136.unnamed, ((_e122 & 1u) == 0u));
            } else {
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e145.unnamed.visibility, false), _e145.unnamed_1);
                phi_1197_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e151.unnamed, true);
            }
            let _e156 = phi_1197_;
            phi_1201_ = _e156;
        } else {
            let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e162.unnamed.visibility, false), _e162.unnamed_1);
            phi_1201_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e168.unnamed, true);
        }
        let _e173 = phi_1201_;
        if _e173.unnamed_1 {
            phi_1646_ = evaluate_Verdict(_e173.unnamed.visibility, _e173.unnamed.is_doubted);
        } else {
            let _e181 = samples.member[(0u + _e55.first_primitive)].position;
            let _e199 = ((((_e65.projection.row_w.x * _e181.x) + (_e65.projection.row_w.y * _e181.y)) + (_e65.projection.row_w.z * _e181.z)) + (_e65.projection.row_w.w * 1f));
            let _e213 = (((((_e65.projection.row_x.x * _e181.x) + (_e65.projection.row_x.y * _e181.y)) + (_e65.projection.row_x.z * _e181.z)) + (_e65.projection.row_x.w * 1f)) / _e199);
            let _e227 = (((((_e65.projection.row_y.x * _e181.x) + (_e65.projection.row_y.y * _e181.y)) + (_e65.projection.row_y.z * _e181.z)) + (_e65.projection.row_y.w * 1f)) / _e199);
            let _e240 = ((((_e65.projection.row_z.x * _e181.x) + (_e65.projection.row_z.y * _e181.y)) + (_e65.projection.row_z.z * _e181.z)) + (_e65.projection.row_z.w * 1f));
            if (_e199 > 0f) {
                if (_e213 >= 0f) {
                    phi_1275_ = (_e213 <= 1f);
                } else {
                    phi_1275_ = false;
                }
                let _e245 = phi_1275_;
                if _e245 {
                    if (_e227 >= 0f) {
                        phi_1284_ = (_e227 <= 1f);
                    } else {
                        phi_1284_ = false;
                    }
                    let _e249 = phi_1284_;
                    if _e249 {
                        if (_e240 >= 0f) {
                            phi_1293_ = (_e240 <= 1f);
                        } else {
                            phi_1293_ = false;
                        }
                        let _e253 = phi_1293_;
                        phi_1294_ = _e253;
                        phi_1295_ = false;
                    } else {
                        phi_1294_ = bool();
                        phi_1295_ = true;
                    }
                    let _e255 = phi_1294_;
                    let _e257 = phi_1295_;
                    phi_1296_ = _e255;
                    phi_1297_ = _e257;
                } else {
                    phi_1296_ = bool();
                    phi_1297_ = true;
                }
                let _e259 = phi_1296_;
                let _e261 = phi_1297_;
                phi_1298_ = _e259;
                phi_1299_ = _e261;
            } else {
                phi_1298_ = bool();
                phi_1299_ = true;
            }
            let _e263 = phi_1298_;
            let _e265 = phi_1299_;
            if _e265 {
                phi_1303_ = false;
            } else {
                phi_1303_ = _e263;
            }
            let _e267 = phi_1303_;
            if _e267 {
                if (0f > 0f) {
                    let _e270 = samples.member[(0u + _e55.first_primitive)].normal;
                    let _e272 = p.member.map_size;
                    let _e342 = ((abs(((((_e61.row_x.x * _e270.x) + (_e61.row_x.y * _e270.y)) + (_e61.row_x.z * _e270.z)) / (((_e61.row_x.x * _e61.row_x.x) + (_e61.row_x.y * _e61.row_x.y)) + (_e61.row_x.z * _e61.row_x.z)))) + abs(((((_e61.row_y.x * _e270.x) + (_e61.row_y.y * _e270.y)) + (_e61.row_y.z * _e270.z)) / (((_e61.row_y.x * _e61.row_y.x) + (_e61.row_y.y * _e61.row_y.y)) + (_e61.row_y.z * _e61.row_y.z))))) / (abs(((((_e61.row_z.x * _e270.x) + (_e61.row_z.y * _e270.y)) + (_e61.row_z.z * _e270.z)) / (((_e61.row_z.x * _e61.row_z.x) + (_e61.row_z.y * _e61.row_z.y)) + (_e61.row_z.z * _e61.row_z.z)))) * f32(_e272)));
                    if (_e342 < 0.002f) {
                        phi_1393_ = _e342;
                    } else {
                        phi_1393_ = 0.002f;
                    }
                    let _e345 = phi_1393_;
                    phi_1396_ = (_e240 - (0f * _e345));
                } else {
                    phi_1396_ = _e240;
                }
                let _e349 = phi_1396_;
                let _e351 = p.member.map_size;
                let _e352 = f32(_e351);
                let _e355 = ((_e213 * _e352) - 0.5f);
                let _e356 = ((_e227 * _e352) - 0.5f);
                if (_e355 > -8388608f) {
                    let _e368 = f32(select(0i, select(select(i32(_e355), i32(-2147483648), (_e355 < bitcast<f32>(3472883712u))), 2147483647i, (_e355 > bitcast<f32>(1325400063u))), (_e355 == _e355)));
                    if (_e368 > _e355) {
                        phi_1425_ = 1f;
                    } else {
                        phi_1425_ = 0f;
                    }
                    let _e371 = phi_1425_;
                    if (_e355 < 8388608f) {
                        phi_1430_ = (_e368 - _e371);
                        phi_1431_ = false;
                    } else {
                        phi_1430_ = f32();
                        phi_1431_ = true;
                    }
                    let _e374 = phi_1430_;
                    let _e376 = phi_1431_;
                    phi_1432_ = _e374;
                    phi_1433_ = _e376;
                } else {
                    phi_1432_ = f32();
                    phi_1433_ = true;
                }
                let _e378 = phi_1432_;
                let _e380 = phi_1433_;
                if _e380 {
                    phi_1437_ = _e355;
                } else {
                    phi_1437_ = _e378;
                }
                let _e382 = phi_1437_;
                if (_e356 > -8388608f) {
                    let _e394 = f32(select(0i, select(select(i32(_e356), i32(-2147483648), (_e356 < bitcast<f32>(3472883712u))), 2147483647i, (_e356 > bitcast<f32>(1325400063u))), (_e356 == _e356)));
                    if (_e394 > _e356) {
                        phi_1457_ = 1f;
                    } else {
                        phi_1457_ = 0f;
                    }
                    let _e397 = phi_1457_;
                    if (_e356 < 8388608f) {
                        phi_1462_ = (_e394 - _e397);
                        phi_1463_ = false;
                    } else {
                        phi_1462_ = f32();
                        phi_1463_ = true;
                    }
                    let _e400 = phi_1462_;
                    let _e402 = phi_1463_;
                    phi_1464_ = _e400;
                    phi_1465_ = _e402;
                } else {
                    phi_1464_ = f32();
                    phi_1465_ = true;
                }
                let _e404 = phi_1464_;
                let _e406 = phi_1465_;
                if _e406 {
                    phi_1469_ = _e356;
                } else {
                    phi_1469_ = _e404;
                }
                let _e408 = phi_1469_;
                let _e409 = (_e355 - _e382);
                let _e410 = (_e356 - _e408);
                let _e419 = select(0i, select(select(i32(_e382), i32(-2147483648), (_e382 < bitcast<f32>(3472883712u))), 2147483647i, (_e382 > bitcast<f32>(1325400063u))), (_e382 == _e382));
                let _e428 = select(0i, select(select(i32(_e408), i32(-2147483648), (_e408 < bitcast<f32>(3472883712u))), 2147483647i, (_e408 > bitcast<f32>(1325400063u))), (_e408 == _e408));
                let _e439 = p.member.test;
                let _e440 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e439);
                let _e442 = p.member.map_size;
                local = _e440;
                let _e444 = ((0u * _e442) * _e442);
                let _e446 = (bitcast<i32>(_e442) - 1i);
                if (_e419 > 0i) {
                    phi_1517_ = _e419;
                } else {
                    phi_1517_ = 0i;
                }
                let _e449 = phi_1517_;
                if (_e428 > 0i) {
                    phi_1522_ = _e428;
                } else {
                    phi_1522_ = 0i;
                }
                let _e452 = phi_1522_;
                if (_e449 < _e446) {
                    phi_1527_ = _e449;
                } else {
                    phi_1527_ = _e446;
                }
                let _e455 = phi_1527_;
                if (_e452 < _e446) {
                    phi_1532_ = _e452;
                } else {
                    phi_1532_ = _e446;
                }
                let _e458 = phi_1532_;
                let _e459 = bitcast<u32>(_e455);
                let _e461 = (_e419 + 1i);
                let _e462 = (_e428 + 1i);
                if (_e461 > 0i) {
                    phi_1541_ = _e461;
                } else {
                    phi_1541_ = 0i;
                }
                let _e465 = phi_1541_;
                if (_e462 > 0i) {
                    phi_1546_ = _e462;
                } else {
                    phi_1546_ = 0i;
                }
                let _e468 = phi_1546_;
                if (_e465 < _e446) {
                    phi_1551_ = _e465;
                } else {
                    phi_1551_ = _e446;
                }
                let _e471 = phi_1551_;
                if (_e468 < _e446) {
                    phi_1556_ = _e468;
                } else {
                    phi_1556_ = _e446;
                }
                let _e474 = phi_1556_;
                let _e475 = bitcast<u32>(_e471);
                let _e477 = (bitcast<u32>(_e458) * _e442);
                let _e478 = (bitcast<u32>(_e474) * _e442);
                let _e483 = ((_e477 + _e459) + _e444);
                let _e484 = ((_e477 + _e475) + _e444);
                let _e485 = ((_e478 + _e459) + _e444);
                let _e486 = ((_e478 + _e475) + _e444);
                if (_e483 < _e46) {
                } else {
                    return;
                }
                let _e490 = map.member[(0u + _e483)];
                if (_e484 < _e46) {
                } else {
                    return;
                }
                let _e494 = map.member[(0u + _e484)];
                if (_e485 < _e46) {
                } else {
                    return;
                }
                let _e498 = map.member[(0u + _e485)];
                if (_e486 < _e46) {
                } else {
                    return;
                }
                let _e502 = map.member[(0u + _e486)];
                let _e504 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e490, _e494, _e498, _e502), vec4<f32>(((1f - _e409) * (1f - _e410)), (_e409 * (1f - _e410)), ((1f - _e409) * _e410), (_e409 * _e410)), _e349);
                let _e506 = p.member.epsilon;
                if (_e504 <= _e506) {
                    phi_1607_ = true;
                } else {
                    phi_1607_ = (_e504 >= (1f - _e506));
                }
                let _e511 = phi_1607_;
                if ((bitcast<u32>(_e504) & 2147483647u) > 2139095040u) {
                    phi_1615_ = true;
                } else {
                    phi_1615_ = !(_e511);
                }
                let _e517 = phi_1615_;
                if _e517 {
                    if (_e504 > 0f) {
                        if (_e504 < 1f) {
                            phi_1627_ = false;
                        } else {
                            phi_1627_ = true;
                        }
                        let _e521 = phi_1627_;
                        phi_1628_ = _e521;
                    } else {
                        phi_1628_ = true;
                    }
                    let _e523 = phi_1628_;
                    if _e523 {
                        phi_1632_ = 0.5f;
                    } else {
                        phi_1632_ = _e504;
                    }
                    let _e525 = phi_1632_;
                    phi_1640_ = evaluate_Verdict(_e525, true);
                } else {
                    if (_e504 > 0.5f) {
                        phi_1638_ = 1f;
                    } else {
                        phi_1638_ = 0f;
                    }
                    let _e529 = phi_1638_;
                    phi_1640_ = evaluate_Verdict(_e529, false);
                }
                let _e532 = phi_1640_;
                phi_1645_ = evaluate_Verdict(_e532.visibility, _e532.is_doubted);
            } else {
                phi_1645_ = evaluate_Verdict(0.5f, true);
            }
            let _e538 = phi_1645_;
            phi_1646_ = _e538;
        }
        let _e540 = phi_1646_;
        if (_e55.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e55.first_primitive)] = _e540.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
