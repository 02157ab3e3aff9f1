struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct type_15 {
    member: array<abi_Sample>,
}

struct type_19 {
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

struct type_30 {
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
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_134_: lt_bvh_traverse_Tree;
    var phi_135_: bool;
    var phi_136_: lt_bvh_traverse_Tree;
    var phi_137_: bool;
    var phi_142_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_134_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_135_ = false;
        } else {
            phi_134_ = lt_bvh_traverse_Tree();
            phi_135_ = true;
        }
        let _e49 = phi_134_;
        let _e51 = phi_135_;
        phi_136_ = _e49;
        phi_137_ = _e51;
    } else {
        phi_136_ = lt_bvh_traverse_Tree();
        phi_137_ = true;
    }
    let _e53 = phi_136_;
    let _e55 = phi_137_;
    if _e55 {
        phi_142_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_142_ = _e53;
    }
    let _e60 = phi_142_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_169_: f32;
    var phi_170_: f32;
    var phi_171_: f32;
    var phi_188_: f32;
    var phi_189_: f32;
    var phi_190_: f32;
    var phi_206_: f32;
    var phi_207_: f32;
    var phi_208_: f32;
    var phi_224_: f32;
    var phi_225_: f32;
    var phi_226_: f32;
    var phi_242_: f32;
    var phi_243_: f32;
    var phi_244_: f32;
    var phi_279_: bool;
    var phi_280_: bool;
    var phi_281_: bool;
    var phi_282_: bool;
    var phi_283_: bool;
    var phi_284_: bool;
    var phi_288_: bool;
    var phi_599_: f32;
    var phi_600_: f32;
    var phi_601_: f32;
    var phi_618_: f32;
    var phi_619_: f32;
    var phi_620_: f32;
    var phi_637_: f32;
    var phi_638_: f32;
    var phi_639_: f32;
    var phi_656_: f32;
    var phi_657_: f32;
    var phi_658_: f32;
    var phi_681_: f32;
    var phi_682_: f32;
    var phi_683_: f32;
    var phi_730_: f32;
    var phi_731_: f32;
    var phi_732_: f32;
    var phi_749_: f32;
    var phi_750_: f32;
    var phi_751_: f32;
    var phi_768_: f32;
    var phi_769_: f32;
    var phi_770_: f32;
    var phi_787_: f32;
    var phi_788_: f32;
    var phi_789_: f32;
    var phi_812_: f32;
    var phi_813_: f32;
    var phi_814_: f32;
    var phi_893_: bool;
    var phi_937_: f32;
    var phi_938_: f32;
    var phi_939_: bool;
    var phi_940_: f32;
    var phi_941_: bool;
    var phi_942_: f32;
    var phi_943_: bool;
    var phi_947_: f32;
    var phi_948_: f32;
    var phi_967_: f32;
    var phi_968_: f32;
    var phi_969_: f32;
    var phi_980_: f32;
    var phi_995_: f32;
    var phi_997_: lt_bvh_slab_Span;
    var phi_1055_: f32;
    var phi_1056_: f32;
    var phi_1057_: f32;
    var phi_1058_: f32;
    var phi_1059_: f32;
    var phi_1060_: bool;
    var phi_1064_: f32;
    var phi_1079_: f32;
    var phi_1080_: f32;
    var phi_1081_: f32;
    var phi_1082_: f32;
    var phi_1083_: f32;
    var phi_1084_: f32;
    var phi_1085_: f32;
    var phi_1086_: bool;
    var phi_1090_: f32;
    var phi_1091_: f32;
    var phi_1092_: bool;
    var phi_1093_: f32;
    var phi_1094_: f32;
    var phi_1095_: bool;
    var phi_1099_: f32;

    let _e40 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_171_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_170_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_169_ = 1f;
            } else {
                phi_169_ = param_7;
            }
            let _e47 = phi_169_;
            phi_170_ = _e47;
        }
        let _e49 = phi_170_;
        phi_171_ = _e49;
    }
    let _e51 = phi_171_;
    let _e52 = (_e51 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_190_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_189_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_188_ = 1f;
            } else {
                phi_188_ = param_5.x;
            }
            let _e60 = phi_188_;
            phi_189_ = _e60;
        }
        let _e62 = phi_189_;
        phi_190_ = _e62;
    }
    let _e64 = phi_190_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_208_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_207_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_206_ = 1f;
            } else {
                phi_206_ = param_5.y;
            }
            let _e72 = phi_206_;
            phi_207_ = _e72;
        }
        let _e74 = phi_207_;
        phi_208_ = _e74;
    }
    let _e76 = phi_208_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_226_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_225_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_224_ = 1f;
            } else {
                phi_224_ = param_5.z;
            }
            let _e84 = phi_224_;
            phi_225_ = _e84;
        }
        let _e86 = phi_225_;
        phi_226_ = _e86;
    }
    let _e88 = phi_226_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_244_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_243_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_242_ = 1f;
            } else {
                phi_242_ = param_5.w;
            }
            let _e96 = phi_242_;
            phi_243_ = _e96;
        }
        let _e98 = phi_243_;
        phi_244_ = _e98;
    }
    let _e100 = phi_244_;
    let _e101 = (_e64 - _e52);
    let _e102 = (_e76 - _e52);
    let _e103 = (_e88 - _e52);
    let _e104 = (_e100 - _e52);
    let _e115 = ((((_e101 * param_6.x) + (_e102 * param_6.y)) + (_e103 * param_6.z)) + (_e104 * param_6.w));
    if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
        phi_1093_ = _e115;
        phi_1094_ = f32();
        phi_1095_ = true;
    } else {
        if (_e101 >= 0f) {
            if (_e102 >= 0f) {
                if (_e103 >= 0f) {
                    phi_279_ = (_e104 >= 0f);
                    phi_280_ = false;
                } else {
                    phi_279_ = bool();
                    phi_280_ = true;
                }
                let _e124 = phi_279_;
                let _e126 = phi_280_;
                phi_281_ = _e124;
                phi_282_ = _e126;
            } else {
                phi_281_ = bool();
                phi_282_ = true;
            }
            let _e128 = phi_281_;
            let _e130 = phi_282_;
            phi_283_ = _e128;
            phi_284_ = _e130;
        } else {
            phi_283_ = bool();
            phi_284_ = true;
        }
        let _e132 = phi_283_;
        let _e134 = phi_284_;
        if _e134 {
            phi_288_ = false;
        } else {
            phi_288_ = _e132;
        }
        let _e136 = phi_288_;
        if _e136 {
            phi_1090_ = 1f;
            phi_1091_ = f32();
            phi_1092_ = true;
        } else {
            let _e137 = (0.5f * _e40);
            let _e138 = (1f - _e40);
            let _e140 = (param_6.x * _e138);
            let _e142 = (param_6.y * _e138);
            let _e144 = (param_6.z * _e138);
            let _e146 = (param_6.w * _e138);
            let _e147 = -(_e52);
            let _e148 = (1f - _e52);
            let _e150 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e64);
            let _e152 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e76);
            let _e154 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e88);
            let _e156 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e100);
            let _e157 = (_e101 - _e102);
            let _e158 = (_e102 - _e103);
            let _e159 = (_e103 - _e104);
            let _e160 = (_e104 - _e101);
            let _e161 = (_e157 * _e157);
            let _e162 = (_e158 * _e158);
            let _e163 = (_e159 * _e159);
            let _e164 = (_e160 * _e160);
            let _e165 = (_e101 - _e103);
            let _e166 = (_e102 - _e104);
            let _e167 = (_e103 - _e101);
            let _e168 = (_e104 - _e102);
            let _e169 = (_e165 * _e165);
            let _e170 = (_e166 * _e166);
            let _e171 = (_e167 * _e167);
            let _e172 = (_e168 * _e168);
            let _e177 = ((_e140 * _e142) * _e161);
            let _e178 = ((_e142 * _e144) * _e162);
            let _e179 = ((_e144 * _e146) * _e163);
            let _e180 = ((_e146 * _e140) * _e164);
            let _e189 = (((0.5f * _e140) * _e144) * _e169);
            let _e190 = (((0.5f * _e142) * _e146) * _e170);
            let _e191 = (((0.5f * _e144) * _e140) * _e171);
            let _e192 = (((0.5f * _e146) * _e142) * _e172);
            let _e193 = (_e101 * _e102);
            let _e194 = (_e102 * _e103);
            let _e195 = (_e103 * _e104);
            let _e196 = (_e104 * _e101);
            let _e197 = (_e101 * _e103);
            let _e198 = (_e102 * _e104);
            let _e199 = (_e103 * _e101);
            let _e200 = (_e104 * _e102);
            let _e201 = (_e177 * _e193);
            let _e202 = (_e178 * _e194);
            let _e203 = (_e179 * _e195);
            let _e204 = (_e180 * _e196);
            let _e205 = (_e189 * _e197);
            let _e206 = (_e190 * _e198);
            let _e207 = (_e191 * _e199);
            let _e208 = (_e192 * _e200);
            let _e209 = (_e64 * _e64);
            let _e210 = (_e76 * _e76);
            let _e211 = (_e88 * _e88);
            let _e212 = (_e100 * _e100);
            let _e213 = (_e150 * _e150);
            let _e214 = (_e152 * _e152);
            let _e215 = (_e154 * _e154);
            let _e216 = (_e156 * _e156);
            let _e217 = (_e137 * _e140);
            let _e218 = (_e137 * _e142);
            let _e219 = (_e137 * _e144);
            let _e220 = (_e137 * _e146);
            let _e229 = (((_e217 * _e101) * _e209) * _e147);
            let _e230 = (((_e218 * _e102) * _e210) * _e147);
            let _e231 = (((_e219 * _e103) * _e211) * _e147);
            let _e232 = (((_e220 * _e104) * _e212) * _e147);
            let _e241 = (((_e217 * _e101) * _e213) * _e148);
            let _e242 = (((_e218 * _e102) * _e214) * _e148);
            let _e243 = (((_e219 * _e103) * _e215) * _e148);
            let _e244 = (((_e220 * _e104) * _e216) * _e148);
            let _e412 = (((((((_e177 * _e144) * _e162) * _e169) + (_e137 * (((_e177 * ((_e209 * _e210) + (_e213 * _e214))) + (_e189 * ((_e209 * _e211) + (_e213 * _e215)))) + ((_e217 * _e209) * _e213)))) + ((((_e178 * _e146) * _e163) * _e170) + (_e137 * (((_e178 * ((_e210 * _e211) + (_e214 * _e215))) + (_e190 * ((_e210 * _e212) + (_e214 * _e216)))) + ((_e218 * _e210) * _e214))))) + ((((_e179 * _e140) * _e164) * _e171) + (_e137 * (((_e179 * ((_e211 * _e212) + (_e215 * _e216))) + (_e191 * ((_e211 * _e209) + (_e215 * _e213)))) + ((_e219 * _e211) * _e215))))) + ((((_e180 * _e142) * _e161) * _e172) + (_e137 * (((_e180 * ((_e212 * _e209) + (_e216 * _e213))) + (_e192 * ((_e212 * _e210) + (_e216 * _e214)))) + ((_e220 * _e212) * _e216)))));
            let _e415 = (((_e137 * _e137) * _e147) * _e148);
            let _e418 = (((((((_e201 * _e193) + (_e205 * _e197)) + (_e101 * ((_e229 * _e147) + (_e241 * _e148)))) + (((_e202 * _e194) + (_e206 * _e198)) + (_e102 * ((_e230 * _e147) + (_e242 * _e148))))) + (((_e203 * _e195) + (_e207 * _e199)) + (_e103 * ((_e231 * _e147) + (_e243 * _e148))))) + (((_e204 * _e196) + (_e208 * _e200)) + (_e104 * ((_e232 * _e147) + (_e244 * _e148))))) + ((_e415 * _e147) * _e148));
            if (_e418 < 0.0000000000000000000000000000000001f) {
                if ((bitcast<u32>(_e101) & 2147483647u) > 2139095040u) {
                    phi_601_ = _e101;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_600_ = 0f;
                    } else {
                        if (_e101 < 0f) {
                            phi_599_ = 0f;
                        } else {
                            phi_599_ = 1f;
                        }
                        let _e433 = phi_599_;
                        phi_600_ = _e433;
                    }
                    let _e435 = phi_600_;
                    phi_601_ = _e435;
                }
                let _e437 = phi_601_;
                if ((bitcast<u32>(_e102) & 2147483647u) > 2139095040u) {
                    phi_620_ = _e102;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_619_ = 0f;
                    } else {
                        if (_e102 < 0f) {
                            phi_618_ = 0f;
                        } else {
                            phi_618_ = 1f;
                        }
                        let _e446 = phi_618_;
                        phi_619_ = _e446;
                    }
                    let _e448 = phi_619_;
                    phi_620_ = _e448;
                }
                let _e450 = phi_620_;
                if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
                    phi_639_ = _e103;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_638_ = 0f;
                    } else {
                        if (_e103 < 0f) {
                            phi_637_ = 0f;
                        } else {
                            phi_637_ = 1f;
                        }
                        let _e459 = phi_637_;
                        phi_638_ = _e459;
                    }
                    let _e461 = phi_638_;
                    phi_639_ = _e461;
                }
                let _e463 = phi_639_;
                if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                    phi_658_ = _e104;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_657_ = 0f;
                    } else {
                        if (_e104 < 0f) {
                            phi_656_ = 0f;
                        } else {
                            phi_656_ = 1f;
                        }
                        let _e472 = phi_656_;
                        phi_657_ = _e472;
                    }
                    let _e474 = phi_657_;
                    phi_658_ = _e474;
                }
                let _e476 = phi_658_;
                let _e484 = (((((_e437 * _e140) + (_e450 * _e142)) + (_e463 * _e144)) + (_e476 * _e146)) + _e137);
                if ((bitcast<u32>(_e484) & 2147483647u) > 2139095040u) {
                    phi_683_ = _e484;
                } else {
                    if (_e484 < 0f) {
                        phi_682_ = 0f;
                    } else {
                        if (_e484 > 1f) {
                            phi_681_ = 1f;
                        } else {
                            phi_681_ = _e484;
                        }
                        let _e491 = phi_681_;
                        phi_682_ = _e491;
                    }
                    let _e493 = phi_682_;
                    phi_683_ = _e493;
                }
                let _e495 = phi_683_;
                phi_1084_ = _e495;
                phi_1085_ = f32();
                phi_1086_ = true;
            } else {
                let _e500 = ((_e140 * _e64) * _e150);
                let _e501 = ((_e142 * _e76) * _e152);
                let _e502 = ((_e144 * _e88) * _e154);
                let _e503 = ((_e146 * _e100) * _e156);
                let _e510 = ((((_e500 * _e101) + (_e501 * _e102)) + (_e502 * _e103)) + (_e503 * _e104));
                let _e521 = ((((_e500 * (_e101 * _e101)) + (_e501 * (_e102 * _e102))) + (_e502 * (_e103 * _e103))) + (_e503 * (_e104 * _e104)));
                if (_e521 < 0.0000000000000000000000000000000001f) {
                    if ((bitcast<u32>(_e101) & 2147483647u) > 2139095040u) {
                        phi_732_ = _e101;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_731_ = 0f;
                        } else {
                            if (_e101 < 0f) {
                                phi_730_ = 0f;
                            } else {
                                phi_730_ = 1f;
                            }
                            let _e531 = phi_730_;
                            phi_731_ = _e531;
                        }
                        let _e533 = phi_731_;
                        phi_732_ = _e533;
                    }
                    let _e535 = phi_732_;
                    if ((bitcast<u32>(_e102) & 2147483647u) > 2139095040u) {
                        phi_751_ = _e102;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_750_ = 0f;
                        } else {
                            if (_e102 < 0f) {
                                phi_749_ = 0f;
                            } else {
                                phi_749_ = 1f;
                            }
                            let _e544 = phi_749_;
                            phi_750_ = _e544;
                        }
                        let _e546 = phi_750_;
                        phi_751_ = _e546;
                    }
                    let _e548 = phi_751_;
                    if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
                        phi_770_ = _e103;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_769_ = 0f;
                        } else {
                            if (_e103 < 0f) {
                                phi_768_ = 0f;
                            } else {
                                phi_768_ = 1f;
                            }
                            let _e557 = phi_768_;
                            phi_769_ = _e557;
                        }
                        let _e559 = phi_769_;
                        phi_770_ = _e559;
                    }
                    let _e561 = phi_770_;
                    if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                        phi_789_ = _e104;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_788_ = 0f;
                        } else {
                            if (_e104 < 0f) {
                                phi_787_ = 0f;
                            } else {
                                phi_787_ = 1f;
                            }
                            let _e570 = phi_787_;
                            phi_788_ = _e570;
                        }
                        let _e572 = phi_788_;
                        phi_789_ = _e572;
                    }
                    let _e574 = phi_789_;
                    let _e582 = (((((_e535 * _e140) + (_e548 * _e142)) + (_e561 * _e144)) + (_e574 * _e146)) + _e137);
                    if ((bitcast<u32>(_e582) & 2147483647u) > 2139095040u) {
                        phi_814_ = _e582;
                    } else {
                        if (_e582 < 0f) {
                            phi_813_ = 0f;
                        } else {
                            if (_e582 > 1f) {
                                phi_812_ = 1f;
                            } else {
                                phi_812_ = _e582;
                            }
                            let _e589 = phi_812_;
                            phi_813_ = _e589;
                        }
                        let _e591 = phi_813_;
                        phi_814_ = _e591;
                    }
                    let _e593 = phi_814_;
                    phi_948_ = _e593;
                } else {
                    let _e595 = (_e521 - (_e147 * _e510));
                    let _e597 = ((_e148 * _e510) - _e521);
                    let _e602 = ((_e140 * _e101) * _e150);
                    let _e603 = ((_e142 * _e102) * _e152);
                    let _e604 = ((_e144 * _e103) * _e154);
                    let _e605 = ((_e146 * _e104) * _e156);
                    let _e631 = (_e137 + (((((_e602 * ((_e603 * _e161) + ((0.5f * _e604) * _e169))) + (_e603 * ((_e604 * _e162) + ((0.5f * _e605) * _e170)))) + (_e604 * ((_e605 * _e163) + ((0.5f * _e602) * _e171)))) + (_e605 * ((_e602 * _e164) + ((0.5f * _e603) * _e172)))) / (_e147 * _e595)));
                    let _e636 = ((_e140 * _e101) * _e64);
                    let _e637 = ((_e142 * _e102) * _e76);
                    let _e638 = ((_e144 * _e103) * _e88);
                    let _e639 = ((_e146 * _e104) * _e100);
                    let _e665 = (_e137 + (((((_e636 * ((_e637 * _e161) + ((0.5f * _e638) * _e169))) + (_e637 * ((_e638 * _e162) + ((0.5f * _e639) * _e170)))) + (_e638 * ((_e639 * _e163) + ((0.5f * _e636) * _e171)))) + (_e639 * ((_e636 * _e164) + ((0.5f * _e637) * _e172)))) / (_e148 * _e597)));
                    let _e666 = (_e510 > 0f);
                    if _e666 {
                        phi_893_ = (_e597 > 0f);
                    } else {
                        phi_893_ = (_e595 < 0f);
                    }
                    let _e670 = phi_893_;
                    if _e670 {
                        if (_e631 >= 0f) {
                            if (_e665 >= 0f) {
                                if _e666 {
                                    phi_937_ = (1f - _e631);
                                } else {
                                    phi_937_ = ((((((_e500 * ((_e501 * _e161) + ((0.5f * _e502) * _e169))) + (_e501 * ((_e502 * _e162) + ((0.5f * _e503) * _e170)))) + (_e502 * ((_e503 * _e163) + ((0.5f * _e500) * _e171)))) + (_e503 * ((_e500 * _e164) + ((0.5f * _e501) * _e172)))) / (_e521 * (-(_e147) * _e148))) + _e665);
                                }
                                let _e703 = phi_937_;
                                phi_938_ = _e703;
                                phi_939_ = false;
                            } else {
                                phi_938_ = f32();
                                phi_939_ = true;
                            }
                            let _e705 = phi_938_;
                            let _e707 = phi_939_;
                            phi_940_ = _e705;
                            phi_941_ = _e707;
                        } else {
                            phi_940_ = f32();
                            phi_941_ = true;
                        }
                        let _e709 = phi_940_;
                        let _e711 = phi_941_;
                        phi_942_ = _e709;
                        phi_943_ = _e711;
                    } else {
                        phi_942_ = f32();
                        phi_943_ = true;
                    }
                    let _e713 = phi_942_;
                    let _e715 = phi_943_;
                    if _e715 {
                        phi_947_ = 1f;
                    } else {
                        phi_947_ = _e713;
                    }
                    let _e717 = phi_947_;
                    phi_948_ = _e717;
                }
                let _e719 = phi_948_;
                let _e720 = (_e719 < 1f);
                if _e720 {
                    if ((bitcast<u32>(_e719) & 2147483647u) > 2139095040u) {
                        phi_969_ = _e719;
                    } else {
                        if (_e719 < 0f) {
                            phi_968_ = 0f;
                        } else {
                            if (_e719 > 1f) {
                                phi_967_ = 1f;
                            } else {
                                phi_967_ = _e719;
                            }
                            let _e727 = phi_967_;
                            phi_968_ = _e727;
                        }
                        let _e729 = phi_968_;
                        phi_969_ = _e729;
                    }
                    let _e731 = phi_969_;
                    phi_1082_ = _e731;
                    phi_1083_ = f32();
                } else {
                    let _e733 = ((0.5f * -(((((((((_e201 * (_e101 + _e102)) + (_e205 * (_e101 + _e103))) + (_e229 * (_e101 + _e147))) + (_e241 * (_e101 + _e148))) + ((((_e202 * (_e102 + _e103)) + (_e206 * (_e102 + _e104))) + (_e230 * (_e102 + _e147))) + (_e242 * (_e102 + _e148)))) + ((((_e203 * (_e103 + _e104)) + (_e207 * (_e103 + _e101))) + (_e231 * (_e103 + _e147))) + (_e243 * (_e103 + _e148)))) + ((((_e204 * (_e104 + _e101)) + (_e208 * (_e104 + _e102))) + (_e232 * (_e104 + _e147))) + (_e244 * (_e104 + _e148)))) + (_e415 * (_e147 + _e148))))) / _e418);
                    let _e734 = ((((((((_e201 + _e205) + _e229) + _e241) + (((_e202 + _e206) + _e230) + _e242)) + (((_e203 + _e207) + _e231) + _e243)) + (((_e204 + _e208) + _e232) + _e244)) + _e415) / _e418);
                    let _e736 = ((_e733 * _e733) - _e734);
                    if (_e736 > 0f) {
                        phi_980_ = sqrt(_e736);
                    } else {
                        phi_980_ = 0f;
                    }
                    let _e740 = phi_980_;
                    if (_e733 > 0f) {
                        let _e743 = (-(_e733) - _e740);
                        phi_997_ = lt_bvh_slab_Span(_e743, (_e734 / _e743));
                    } else {
                        let _e746 = (_e740 - _e733);
                        if (_e746 > 0f) {
                            phi_995_ = (_e734 / _e746);
                        } else {
                            phi_995_ = 0f;
                        }
                        let _e750 = phi_995_;
                        phi_997_ = lt_bvh_slab_Span(_e750, _e746);
                    }
                    let _e753 = phi_997_;
                    if (_e753.near >= 0f) {
                        phi_1058_ = 1f;
                        phi_1059_ = f32();
                        phi_1060_ = true;
                    } else {
                        let _e757 = (_e753.far <= 0f);
                        if _e757 {
                            phi_1056_ = (_e412 / _e418);
                            phi_1057_ = f32();
                        } else {
                            let _e768 = (((((_e140 * _e101) + (_e142 * _e102)) + (_e144 * _e103)) + (_e146 * _e104)) + (_e137 * (_e147 + _e148)));
                            let _e784 = (((((_e140 * (_e101 * _e101)) + (_e142 * (_e102 * _e102))) + (_e144 * (_e103 * _e103))) + (_e146 * (_e104 * _e104))) + (_e137 * ((_e147 * _e147) + (_e148 * _e148))));
                            if (-(_e753.near) <= _e753.far) {
                                phi_1055_ = (1f - (((_e753.near * _e753.near) * ((_e753.far * _e784) - _e768)) / (_e753.far - _e753.near)));
                            } else {
                                phi_1055_ = ((_e412 / _e418) + (((_e753.far * _e753.far) * (_e768 - (_e753.near * _e784))) / (_e753.far - _e753.near)));
                            }
                            let _e803 = phi_1055_;
                            phi_1056_ = f32();
                            phi_1057_ = _e803;
                        }
                        let _e805 = phi_1056_;
                        let _e807 = phi_1057_;
                        phi_1058_ = _e805;
                        phi_1059_ = _e807;
                        phi_1060_ = _e757;
                    }
                    let _e809 = phi_1058_;
                    let _e811 = phi_1059_;
                    let _e813 = phi_1060_;
                    if _e813 {
                        phi_1064_ = _e809;
                    } else {
                        phi_1064_ = _e811;
                    }
                    let _e815 = phi_1064_;
                    if ((bitcast<u32>(_e815) & 2147483647u) > 2139095040u) {
                        phi_1081_ = _e815;
                    } else {
                        if (_e815 < 0f) {
                            phi_1080_ = 0f;
                        } else {
                            if (_e815 > 1f) {
                                phi_1079_ = 1f;
                            } else {
                                phi_1079_ = _e815;
                            }
                            let _e822 = phi_1079_;
                            phi_1080_ = _e822;
                        }
                        let _e824 = phi_1080_;
                        phi_1081_ = _e824;
                    }
                    let _e826 = phi_1081_;
                    phi_1082_ = f32();
                    phi_1083_ = _e826;
                }
                let _e828 = phi_1082_;
                let _e830 = phi_1083_;
                phi_1084_ = _e828;
                phi_1085_ = _e830;
                phi_1086_ = _e720;
            }
            let _e832 = phi_1084_;
            let _e834 = phi_1085_;
            let _e836 = phi_1086_;
            if _e836 {
            }
            phi_1090_ = _e832;
            phi_1091_ = _e834;
            phi_1092_ = _e836;
        }
        let _e838 = phi_1090_;
        let _e840 = phi_1091_;
        let _e842 = phi_1092_;
        phi_1093_ = _e838;
        phi_1094_ = _e840;
        phi_1095_ = _e842;
    }
    let _e844 = phi_1093_;
    let _e846 = phi_1094_;
    let _e848 = phi_1095_;
    if _e848 {
        phi_1099_ = _e844;
    } else {
        phi_1099_ = _e846;
    }
    let _e850 = phi_1099_;
    return _e850;
}

fn function_() {
    var local: f32;
    var phi_1155_: bool;
    var phi_1156_: bool;
    var phi_1157_: bool;
    var phi_1158_: bool;
    var phi_1162_: bool;
    var phi_1232_: bool;
    var phi_1233_: bool;
    var phi_1244_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1245_: bool;
    var phi_1246_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1247_: bool;
    var phi_1254_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1258_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1332_: bool;
    var phi_1341_: bool;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1352_: bool;
    var phi_1353_: bool;
    var phi_1354_: bool;
    var phi_1355_: bool;
    var phi_1356_: bool;
    var phi_1360_: bool;
    var phi_1450_: f32;
    var phi_1453_: f32;
    var phi_1482_: f32;
    var phi_1487_: f32;
    var phi_1488_: bool;
    var phi_1489_: f32;
    var phi_1490_: bool;
    var phi_1494_: f32;
    var phi_1514_: f32;
    var phi_1519_: f32;
    var phi_1520_: bool;
    var phi_1521_: f32;
    var phi_1522_: bool;
    var phi_1526_: f32;
    var phi_1574_: i32;
    var phi_1579_: i32;
    var phi_1584_: i32;
    var phi_1589_: i32;
    var phi_1598_: i32;
    var phi_1603_: i32;
    var phi_1608_: i32;
    var phi_1613_: i32;
    var phi_1664_: bool;
    var phi_1672_: bool;
    var phi_1684_: bool;
    var phi_1685_: bool;
    var phi_1689_: f32;
    var phi_1695_: f32;
    var phi_1697_: evaluate_Verdict;
    var phi_1702_: evaluate_Verdict;
    var phi_1703_: evaluate_Verdict;

    let _e37 = id_1;
    let _e44 = arrayLength((&map.member));
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e37, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        let _e59 = p.member.projection;
        if (_e53.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e63 = lt_math_OneLevel(_e59);
        let _e67 = samples.member[(0u + _e53.first_primitive)].normal[0u];
        let _e69 = global[0u];
        if (_e67 == _e69) {
            let _e72 = samples.member[(0u + _e53.first_primitive)].normal[1u];
            let _e74 = global[1u];
            if (_e72 == _e74) {
                let _e77 = samples.member[(0u + _e53.first_primitive)].normal[2u];
                let _e79 = global[2u];
                phi_1155_ = (_e77 == _e79);
                phi_1156_ = false;
            } else {
                phi_1155_ = bool();
                phi_1156_ = true;
            }
            let _e82 = phi_1155_;
            let _e84 = phi_1156_;
            phi_1157_ = _e82;
            phi_1158_ = _e84;
        } else {
            phi_1157_ = bool();
            phi_1158_ = true;
        }
        let _e86 = phi_1157_;
        let _e88 = phi_1158_;
        if _e88 {
            phi_1162_ = false;
        } else {
            phi_1162_ = _e86;
        }
        let _e90 = phi_1162_;
        if !(_e90) {
            let _e93 = samples.member[(0u + _e53.first_primitive)].position;
            let _e95 = p.member.light.place;
            let _e101 = p.member.light.place[3u];
            let _e108 = (_e95.x - (_e93.x * _e101));
            let _e109 = (_e95.y - (_e93.y * _e101));
            let _e110 = (_e95.z - (_e93.z * _e101));
            let _e112 = samples.member[(0u + _e53.first_primitive)].normal;
            if ((((_e112.x * _e108) + (_e112.y * _e109)) + (_e112.z * _e110)) > 0f) {
                let _e126 = (((_e108 * _e108) + (_e109 * _e109)) + (_e110 * _e110));
                let _e128 = p.member.light.axis;
                let _e140 = p.member.light.place[3u];
                if (_e140 == 0f) {
                    phi_1233_ = true;
                } else {
                    let _e143 = p.member.light.range_squared;
                    if (_e126 <= _e143) {
                        let _e146 = p.member.light.cos_outer;
                        phi_1232_ = (-((((_e108 * _e128.x) + (_e109 * _e128.y)) + (_e110 * _e128.z))) >= (_e146 * sqrt(_e126)));
                    } else {
                        phi_1232_ = false;
                    }
                    let _e151 = phi_1232_;
                    phi_1233_ = _e151;
                }
                let _e153 = phi_1233_;
                if _e153 {
                    let _e155 = samples.member[(0u + _e53.first_primitive)].flags;
                    let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e163.unnamed.visibility, false), _e163.unnamed_1);
                    phi_1244_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e169.unnamed, ((_e155 & 1u) == 0u));
                    phi_1245_ = false;
                } else {
                    phi_1244_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1245_ = true;
                }
                let _e174 = phi_1244_;
                let _e176 = phi_1245_;
                phi_1246_ = _e174;
                phi_1247_ = _e176;
            } else {
                phi_1246_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1247_ = true;
            }
            let _e178 = phi_1246_;
            let _e180 = phi_1247_;
            if _e180 {
                let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e186.unnamed.visibility, false), _e186.unnamed_1);
                phi_1254_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e192.unnamed, true);
            } else {
                phi_1254_ = _e178;
            }
            let _e197 = phi_1254_;
            phi_1258_ = _e197;
        } else {
            let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e203.unnamed.visibility, false), _e203.unnamed_1);
            phi_1258_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e209.unnamed, true);
        }
        let _e214 = phi_1258_;
        if _e214.unnamed_1 {
            phi_1703_ = evaluate_Verdict(_e214.unnamed.visibility, _e214.unnamed.is_doubted);
        } else {
            let _e222 = samples.member[(0u + _e53.first_primitive)].position;
            let _e240 = ((((_e63.projection.row_w.x * _e222.x) + (_e63.projection.row_w.y * _e222.y)) + (_e63.projection.row_w.z * _e222.z)) + (_e63.projection.row_w.w * 1f));
            let _e254 = (((((_e63.projection.row_x.x * _e222.x) + (_e63.projection.row_x.y * _e222.y)) + (_e63.projection.row_x.z * _e222.z)) + (_e63.projection.row_x.w * 1f)) / _e240);
            let _e268 = (((((_e63.projection.row_y.x * _e222.x) + (_e63.projection.row_y.y * _e222.y)) + (_e63.projection.row_y.z * _e222.z)) + (_e63.projection.row_y.w * 1f)) / _e240);
            let _e281 = ((((_e63.projection.row_z.x * _e222.x) + (_e63.projection.row_z.y * _e222.y)) + (_e63.projection.row_z.z * _e222.z)) + (_e63.projection.row_z.w * 1f));
            if (_e240 > 0f) {
                if (_e254 >= 0f) {
                    phi_1332_ = (_e254 <= 1f);
                } else {
                    phi_1332_ = false;
                }
                let _e286 = phi_1332_;
                if _e286 {
                    if (_e268 >= 0f) {
                        phi_1341_ = (_e268 <= 1f);
                    } else {
                        phi_1341_ = false;
                    }
                    let _e290 = phi_1341_;
                    if _e290 {
                        if (_e281 >= 0f) {
                            phi_1350_ = (_e281 <= 1f);
                        } else {
                            phi_1350_ = false;
                        }
                        let _e294 = phi_1350_;
                        phi_1351_ = _e294;
                        phi_1352_ = false;
                    } else {
                        phi_1351_ = bool();
                        phi_1352_ = true;
                    }
                    let _e296 = phi_1351_;
                    let _e298 = phi_1352_;
                    phi_1353_ = _e296;
                    phi_1354_ = _e298;
                } else {
                    phi_1353_ = bool();
                    phi_1354_ = true;
                }
                let _e300 = phi_1353_;
                let _e302 = phi_1354_;
                phi_1355_ = _e300;
                phi_1356_ = _e302;
            } else {
                phi_1355_ = bool();
                phi_1356_ = true;
            }
            let _e304 = phi_1355_;
            let _e306 = phi_1356_;
            if _e306 {
                phi_1360_ = false;
            } else {
                phi_1360_ = _e304;
            }
            let _e308 = phi_1360_;
            if _e308 {
                if (0f > 0f) {
                    let _e311 = samples.member[(0u + _e53.first_primitive)].normal;
                    let _e313 = p.member.map_size;
                    let _e383 = ((abs(((((_e59.row_x.x * _e311.x) + (_e59.row_x.y * _e311.y)) + (_e59.row_x.z * _e311.z)) / (((_e59.row_x.x * _e59.row_x.x) + (_e59.row_x.y * _e59.row_x.y)) + (_e59.row_x.z * _e59.row_x.z)))) + abs(((((_e59.row_y.x * _e311.x) + (_e59.row_y.y * _e311.y)) + (_e59.row_y.z * _e311.z)) / (((_e59.row_y.x * _e59.row_y.x) + (_e59.row_y.y * _e59.row_y.y)) + (_e59.row_y.z * _e59.row_y.z))))) / (abs(((((_e59.row_z.x * _e311.x) + (_e59.row_z.y * _e311.y)) + (_e59.row_z.z * _e311.z)) / (((_e59.row_z.x * _e59.row_z.x) + (_e59.row_z.y * _e59.row_z.y)) + (_e59.row_z.z * _e59.row_z.z)))) * f32(_e313)));
                    if (_e383 < 0.002f) {
                        phi_1450_ = _e383;
                    } else {
                        phi_1450_ = 0.002f;
                    }
                    let _e386 = phi_1450_;
                    phi_1453_ = (_e281 - (0f * _e386));
                } else {
                    phi_1453_ = _e281;
                }
                let _e390 = phi_1453_;
                let _e392 = p.member.map_size;
                let _e393 = f32(_e392);
                let _e396 = ((_e254 * _e393) - 0.5f);
                let _e397 = ((_e268 * _e393) - 0.5f);
                if (_e396 > -8388608f) {
                    let _e409 = f32(select(0i, select(select(i32(_e396), i32(-2147483648), (_e396 < bitcast<f32>(3472883712u))), 2147483647i, (_e396 > bitcast<f32>(1325400063u))), (_e396 == _e396)));
                    if (_e409 > _e396) {
                        phi_1482_ = 1f;
                    } else {
                        phi_1482_ = 0f;
                    }
                    let _e412 = phi_1482_;
                    if (_e396 < 8388608f) {
                        phi_1487_ = (_e409 - _e412);
                        phi_1488_ = false;
                    } else {
                        phi_1487_ = f32();
                        phi_1488_ = true;
                    }
                    let _e415 = phi_1487_;
                    let _e417 = phi_1488_;
                    phi_1489_ = _e415;
                    phi_1490_ = _e417;
                } else {
                    phi_1489_ = f32();
                    phi_1490_ = true;
                }
                let _e419 = phi_1489_;
                let _e421 = phi_1490_;
                if _e421 {
                    phi_1494_ = _e396;
                } else {
                    phi_1494_ = _e419;
                }
                let _e423 = phi_1494_;
                if (_e397 > -8388608f) {
                    let _e435 = f32(select(0i, select(select(i32(_e397), i32(-2147483648), (_e397 < bitcast<f32>(3472883712u))), 2147483647i, (_e397 > bitcast<f32>(1325400063u))), (_e397 == _e397)));
                    if (_e435 > _e397) {
                        phi_1514_ = 1f;
                    } else {
                        phi_1514_ = 0f;
                    }
                    let _e438 = phi_1514_;
                    if (_e397 < 8388608f) {
                        phi_1519_ = (_e435 - _e438);
                        phi_1520_ = false;
                    } else {
                        phi_1519_ = f32();
                        phi_1520_ = true;
                    }
                    let _e441 = phi_1519_;
                    let _e443 = phi_1520_;
                    phi_1521_ = _e441;
                    phi_1522_ = _e443;
                } else {
                    phi_1521_ = f32();
                    phi_1522_ = true;
                }
                let _e445 = phi_1521_;
                let _e447 = phi_1522_;
                if _e447 {
                    phi_1526_ = _e397;
                } else {
                    phi_1526_ = _e445;
                }
                let _e449 = phi_1526_;
                let _e450 = (_e396 - _e423);
                let _e451 = (_e397 - _e449);
                let _e460 = select(0i, select(select(i32(_e423), i32(-2147483648), (_e423 < bitcast<f32>(3472883712u))), 2147483647i, (_e423 > bitcast<f32>(1325400063u))), (_e423 == _e423));
                let _e469 = select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < bitcast<f32>(3472883712u))), 2147483647i, (_e449 > bitcast<f32>(1325400063u))), (_e449 == _e449));
                let _e480 = p.member.test;
                let _e481 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e480);
                let _e483 = p.member.map_size;
                local = _e481;
                let _e485 = ((0u * _e483) * _e483);
                let _e487 = (bitcast<i32>(_e483) - 1i);
                if (_e460 > 0i) {
                    phi_1574_ = _e460;
                } else {
                    phi_1574_ = 0i;
                }
                let _e490 = phi_1574_;
                if (_e469 > 0i) {
                    phi_1579_ = _e469;
                } else {
                    phi_1579_ = 0i;
                }
                let _e493 = phi_1579_;
                if (_e490 < _e487) {
                    phi_1584_ = _e490;
                } else {
                    phi_1584_ = _e487;
                }
                let _e496 = phi_1584_;
                if (_e493 < _e487) {
                    phi_1589_ = _e493;
                } else {
                    phi_1589_ = _e487;
                }
                let _e499 = phi_1589_;
                let _e500 = bitcast<u32>(_e496);
                let _e502 = (_e460 + 1i);
                let _e503 = (_e469 + 1i);
                if (_e502 > 0i) {
                    phi_1598_ = _e502;
                } else {
                    phi_1598_ = 0i;
                }
                let _e506 = phi_1598_;
                if (_e503 > 0i) {
                    phi_1603_ = _e503;
                } else {
                    phi_1603_ = 0i;
                }
                let _e509 = phi_1603_;
                if (_e506 < _e487) {
                    phi_1608_ = _e506;
                } else {
                    phi_1608_ = _e487;
                }
                let _e512 = phi_1608_;
                if (_e509 < _e487) {
                    phi_1613_ = _e509;
                } else {
                    phi_1613_ = _e487;
                }
                let _e515 = phi_1613_;
                let _e516 = bitcast<u32>(_e512);
                let _e518 = (bitcast<u32>(_e499) * _e483);
                let _e519 = (bitcast<u32>(_e515) * _e483);
                let _e524 = ((_e518 + _e500) + _e485);
                let _e525 = ((_e518 + _e516) + _e485);
                let _e526 = ((_e519 + _e500) + _e485);
                let _e527 = ((_e519 + _e516) + _e485);
                if (_e524 < _e44) {
                } else {
                    return;
                }
                let _e531 = map.member[(0u + _e524)];
                if (_e525 < _e44) {
                } else {
                    return;
                }
                let _e535 = map.member[(0u + _e525)];
                if (_e526 < _e44) {
                } else {
                    return;
                }
                let _e539 = map.member[(0u + _e526)];
                if (_e527 < _e44) {
                } else {
                    return;
                }
                let _e543 = map.member[(0u + _e527)];
                let _e545 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e531, _e535, _e539, _e543), vec4<f32>(((1f - _e450) * (1f - _e451)), (_e450 * (1f - _e451)), ((1f - _e450) * _e451), (_e450 * _e451)), _e390);
                let _e547 = p.member.epsilon;
                if (_e545 <= _e547) {
                    phi_1664_ = true;
                } else {
                    phi_1664_ = (_e545 >= (1f - _e547));
                }
                let _e552 = phi_1664_;
                if ((bitcast<u32>(_e545) & 2147483647u) > 2139095040u) {
                    phi_1672_ = true;
                } else {
                    phi_1672_ = !(_e552);
                }
                let _e558 = phi_1672_;
                if _e558 {
                    if (_e545 > 0f) {
                        if (_e545 < 1f) {
                            phi_1684_ = false;
                        } else {
                            phi_1684_ = true;
                        }
                        let _e562 = phi_1684_;
                        phi_1685_ = _e562;
                    } else {
                        phi_1685_ = true;
                    }
                    let _e564 = phi_1685_;
                    if _e564 {
                        phi_1689_ = 0.5f;
                    } else {
                        phi_1689_ = _e545;
                    }
                    let _e566 = phi_1689_;
                    phi_1697_ = evaluate_Verdict(_e566, true);
                } else {
                    if (_e545 > 0.5f) {
                        phi_1695_ = 1f;
                    } else {
                        phi_1695_ = 0f;
                    }
                    let _e570 = phi_1695_;
                    phi_1697_ = evaluate_Verdict(_e570, false);
                }
                let _e573 = phi_1697_;
                phi_1702_ = evaluate_Verdict(_e573.visibility, _e573.is_doubted);
            } else {
                phi_1702_ = evaluate_Verdict(0.5f, true);
            }
            let _e579 = phi_1702_;
            phi_1703_ = _e579;
        }
        let _e581 = phi_1703_;
        if (_e53.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e53.first_primitive)] = _e581.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
