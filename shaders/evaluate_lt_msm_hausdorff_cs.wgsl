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
    var phi_136_: lt_bvh_traverse_Tree;
    var phi_137_: bool;
    var phi_138_: lt_bvh_traverse_Tree;
    var phi_139_: bool;
    var phi_144_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_136_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_137_ = false;
        } else {
            phi_136_ = lt_bvh_traverse_Tree();
            phi_137_ = true;
        }
        let _e51 = phi_136_;
        let _e53 = phi_137_;
        phi_138_ = _e51;
        phi_139_ = _e53;
    } else {
        phi_138_ = lt_bvh_traverse_Tree();
        phi_139_ = true;
    }
    let _e55 = phi_138_;
    let _e57 = phi_139_;
    if _e57 {
        phi_144_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_144_ = _e55;
    }
    let _e62 = phi_144_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_171_: f32;
    var phi_172_: f32;
    var phi_173_: f32;
    var phi_190_: f32;
    var phi_191_: f32;
    var phi_192_: f32;
    var phi_208_: f32;
    var phi_209_: f32;
    var phi_210_: f32;
    var phi_226_: f32;
    var phi_227_: f32;
    var phi_228_: f32;
    var phi_244_: f32;
    var phi_245_: f32;
    var phi_246_: f32;
    var phi_281_: bool;
    var phi_282_: bool;
    var phi_283_: bool;
    var phi_284_: bool;
    var phi_285_: bool;
    var phi_286_: bool;
    var phi_290_: bool;
    var phi_601_: f32;
    var phi_602_: f32;
    var phi_603_: f32;
    var phi_620_: f32;
    var phi_621_: f32;
    var phi_622_: f32;
    var phi_639_: f32;
    var phi_640_: f32;
    var phi_641_: f32;
    var phi_658_: f32;
    var phi_659_: f32;
    var phi_660_: f32;
    var phi_683_: f32;
    var phi_684_: f32;
    var phi_685_: f32;
    var phi_696_: f32;
    var phi_711_: f32;
    var phi_713_: lt_bvh_slab_Span;
    var phi_771_: f32;
    var phi_772_: f32;
    var phi_773_: f32;
    var phi_774_: f32;
    var phi_775_: f32;
    var phi_776_: bool;
    var phi_780_: f32;
    var phi_790_: bool;
    var phi_803_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_824_: bool;
    var phi_875_: f32;
    var phi_876_: f32;
    var phi_877_: f32;
    var phi_894_: f32;
    var phi_895_: f32;
    var phi_896_: f32;
    var phi_913_: f32;
    var phi_914_: f32;
    var phi_915_: f32;
    var phi_932_: f32;
    var phi_933_: f32;
    var phi_934_: f32;
    var phi_957_: f32;
    var phi_958_: f32;
    var phi_959_: f32;
    var phi_1046_: f32;
    var phi_1047_: f32;
    var phi_1058_: bool;
    var phi_1062_: f32;
    var phi_1063_: f32;
    var phi_1078_: f32;
    var phi_1079_: f32;
    var phi_1080_: f32;
    var phi_1081_: f32;
    var phi_1082_: f32;
    var phi_1083_: f32;
    var phi_1084_: f32;
    var phi_1085_: bool;
    var phi_1086_: f32;
    var phi_1087_: f32;
    var phi_1088_: bool;
    var phi_1092_: f32;

    let _e42 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_173_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_172_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_171_ = 1f;
            } else {
                phi_171_ = param_7;
            }
            let _e49 = phi_171_;
            phi_172_ = _e49;
        }
        let _e51 = phi_172_;
        phi_173_ = _e51;
    }
    let _e53 = phi_173_;
    let _e54 = (_e53 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_192_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_191_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_190_ = 1f;
            } else {
                phi_190_ = param_5.x;
            }
            let _e62 = phi_190_;
            phi_191_ = _e62;
        }
        let _e64 = phi_191_;
        phi_192_ = _e64;
    }
    let _e66 = phi_192_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_210_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_209_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_208_ = 1f;
            } else {
                phi_208_ = param_5.y;
            }
            let _e74 = phi_208_;
            phi_209_ = _e74;
        }
        let _e76 = phi_209_;
        phi_210_ = _e76;
    }
    let _e78 = phi_210_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_228_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_227_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_226_ = 1f;
            } else {
                phi_226_ = param_5.z;
            }
            let _e86 = phi_226_;
            phi_227_ = _e86;
        }
        let _e88 = phi_227_;
        phi_228_ = _e88;
    }
    let _e90 = phi_228_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_246_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_245_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_244_ = 1f;
            } else {
                phi_244_ = param_5.w;
            }
            let _e98 = phi_244_;
            phi_245_ = _e98;
        }
        let _e100 = phi_245_;
        phi_246_ = _e100;
    }
    let _e102 = phi_246_;
    let _e103 = (_e66 - _e54);
    let _e104 = (_e78 - _e54);
    let _e105 = (_e90 - _e54);
    let _e106 = (_e102 - _e54);
    let _e117 = ((((_e103 * param_6.x) + (_e104 * param_6.y)) + (_e105 * param_6.z)) + (_e106 * param_6.w));
    if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
        phi_1086_ = _e117;
        phi_1087_ = f32();
        phi_1088_ = true;
    } else {
        if (_e103 >= 0f) {
            if (_e104 >= 0f) {
                if (_e105 >= 0f) {
                    phi_281_ = (_e106 >= 0f);
                    phi_282_ = false;
                } else {
                    phi_281_ = bool();
                    phi_282_ = true;
                }
                let _e126 = phi_281_;
                let _e128 = phi_282_;
                phi_283_ = _e126;
                phi_284_ = _e128;
            } else {
                phi_283_ = bool();
                phi_284_ = true;
            }
            let _e130 = phi_283_;
            let _e132 = phi_284_;
            phi_285_ = _e130;
            phi_286_ = _e132;
        } else {
            phi_285_ = bool();
            phi_286_ = true;
        }
        let _e134 = phi_285_;
        let _e136 = phi_286_;
        if _e136 {
            phi_290_ = false;
        } else {
            phi_290_ = _e134;
        }
        let _e138 = phi_290_;
        if _e138 {
            phi_1083_ = 1f;
            phi_1084_ = f32();
            phi_1085_ = true;
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
                    phi_603_ = _e103;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_602_ = 0f;
                    } else {
                        if (_e103 < 0f) {
                            phi_601_ = 0f;
                        } else {
                            phi_601_ = 1f;
                        }
                        let _e435 = phi_601_;
                        phi_602_ = _e435;
                    }
                    let _e437 = phi_602_;
                    phi_603_ = _e437;
                }
                let _e439 = phi_603_;
                if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                    phi_622_ = _e104;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_621_ = 0f;
                    } else {
                        if (_e104 < 0f) {
                            phi_620_ = 0f;
                        } else {
                            phi_620_ = 1f;
                        }
                        let _e448 = phi_620_;
                        phi_621_ = _e448;
                    }
                    let _e450 = phi_621_;
                    phi_622_ = _e450;
                }
                let _e452 = phi_622_;
                if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
                    phi_641_ = _e105;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_640_ = 0f;
                    } else {
                        if (_e105 < 0f) {
                            phi_639_ = 0f;
                        } else {
                            phi_639_ = 1f;
                        }
                        let _e461 = phi_639_;
                        phi_640_ = _e461;
                    }
                    let _e463 = phi_640_;
                    phi_641_ = _e463;
                }
                let _e465 = phi_641_;
                if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                    phi_660_ = _e106;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_659_ = 0f;
                    } else {
                        if (_e106 < 0f) {
                            phi_658_ = 0f;
                        } else {
                            phi_658_ = 1f;
                        }
                        let _e474 = phi_658_;
                        phi_659_ = _e474;
                    }
                    let _e476 = phi_659_;
                    phi_660_ = _e476;
                }
                let _e478 = phi_660_;
                let _e486 = (((((_e439 * _e142) + (_e452 * _e144)) + (_e465 * _e146)) + (_e478 * _e148)) + _e139);
                if ((bitcast<u32>(_e486) & 2147483647u) > 2139095040u) {
                    phi_685_ = _e486;
                } else {
                    if (_e486 < 0f) {
                        phi_684_ = 0f;
                    } else {
                        if (_e486 > 1f) {
                            phi_683_ = 1f;
                        } else {
                            phi_683_ = _e486;
                        }
                        let _e493 = phi_683_;
                        phi_684_ = _e493;
                    }
                    let _e495 = phi_684_;
                    phi_685_ = _e495;
                }
                let _e497 = phi_685_;
                phi_1081_ = _e497;
                phi_1082_ = f32();
            } else {
                let _e499 = ((0.5f * -(((((((((_e203 * (_e103 + _e104)) + (_e207 * (_e103 + _e105))) + (_e231 * (_e103 + _e149))) + (_e243 * (_e103 + _e150))) + ((((_e204 * (_e104 + _e105)) + (_e208 * (_e104 + _e106))) + (_e232 * (_e104 + _e149))) + (_e244 * (_e104 + _e150)))) + ((((_e205 * (_e105 + _e106)) + (_e209 * (_e105 + _e103))) + (_e233 * (_e105 + _e149))) + (_e245 * (_e105 + _e150)))) + ((((_e206 * (_e106 + _e103)) + (_e210 * (_e106 + _e104))) + (_e234 * (_e106 + _e149))) + (_e246 * (_e106 + _e150)))) + (_e417 * (_e149 + _e150))))) / _e420);
                let _e500 = ((((((((_e203 + _e207) + _e231) + _e243) + (((_e204 + _e208) + _e232) + _e244)) + (((_e205 + _e209) + _e233) + _e245)) + (((_e206 + _e210) + _e234) + _e246)) + _e417) / _e420);
                let _e502 = ((_e499 * _e499) - _e500);
                if (_e502 > 0f) {
                    phi_696_ = sqrt(_e502);
                } else {
                    phi_696_ = 0f;
                }
                let _e506 = phi_696_;
                if (_e499 > 0f) {
                    let _e509 = (-(_e499) - _e506);
                    phi_713_ = lt_bvh_slab_Span(_e509, (_e500 / _e509));
                } else {
                    let _e512 = (_e506 - _e499);
                    if (_e512 > 0f) {
                        phi_711_ = (_e500 / _e512);
                    } else {
                        phi_711_ = 0f;
                    }
                    let _e516 = phi_711_;
                    phi_713_ = lt_bvh_slab_Span(_e516, _e512);
                }
                let _e519 = phi_713_;
                if (_e519.near >= 0f) {
                    phi_774_ = 1f;
                    phi_775_ = f32();
                    phi_776_ = true;
                } else {
                    let _e523 = (_e519.far <= 0f);
                    if _e523 {
                        phi_772_ = (_e414 / _e420);
                        phi_773_ = f32();
                    } else {
                        let _e534 = (((((_e142 * _e103) + (_e144 * _e104)) + (_e146 * _e105)) + (_e148 * _e106)) + (_e139 * (_e149 + _e150)));
                        let _e550 = (((((_e142 * (_e103 * _e103)) + (_e144 * (_e104 * _e104))) + (_e146 * (_e105 * _e105))) + (_e148 * (_e106 * _e106))) + (_e139 * ((_e149 * _e149) + (_e150 * _e150))));
                        if (-(_e519.near) <= _e519.far) {
                            phi_771_ = (1f - (((_e519.near * _e519.near) * ((_e519.far * _e550) - _e534)) / (_e519.far - _e519.near)));
                        } else {
                            phi_771_ = ((_e414 / _e420) + (((_e519.far * _e519.far) * (_e534 - (_e519.near * _e550))) / (_e519.far - _e519.near)));
                        }
                        let _e569 = phi_771_;
                        phi_772_ = f32();
                        phi_773_ = _e569;
                    }
                    let _e571 = phi_772_;
                    let _e573 = phi_773_;
                    phi_774_ = _e571;
                    phi_775_ = _e573;
                    phi_776_ = _e523;
                }
                let _e575 = phi_774_;
                let _e577 = phi_775_;
                let _e579 = phi_776_;
                if _e579 {
                    phi_780_ = _e575;
                } else {
                    phi_780_ = _e577;
                }
                let _e581 = phi_780_;
                if ((_e519.near * _e149) >= (1f - 0.00001f)) {
                    phi_790_ = true;
                } else {
                    phi_790_ = ((_e519.near * _e150) >= (1f - 0.00001f));
                }
                let _e589 = phi_790_;
                if _e589 {
                    if ((_e519.far * _e149) >= (1f - 0.00001f)) {
                        phi_803_ = true;
                    } else {
                        phi_803_ = ((_e519.far * _e150) >= (1f - 0.00001f));
                    }
                    let _e597 = phi_803_;
                    if _e597 {
                        phi_807_ = false;
                    } else {
                        phi_807_ = true;
                    }
                    let _e599 = phi_807_;
                    phi_808_ = _e599;
                } else {
                    phi_808_ = true;
                }
                let _e601 = phi_808_;
                if _e601 {
                    let _e603 = (-(_e149) < 0.0001f);
                    if _e603 {
                        phi_818_ = bool();
                    } else {
                        phi_818_ = (_e150 < 0.0001f);
                    }
                    let _e606 = phi_818_;
                    phi_819_ = _e606;
                    phi_820_ = _e603;
                } else {
                    phi_819_ = bool();
                    phi_820_ = true;
                }
                let _e608 = phi_819_;
                let _e610 = phi_820_;
                if _e610 {
                    phi_824_ = true;
                } else {
                    phi_824_ = _e608;
                }
                let _e612 = phi_824_;
                if !(_e612) {
                    let _e618 = ((_e142 * _e66) * _e152);
                    let _e619 = ((_e144 * _e78) * _e154);
                    let _e620 = ((_e146 * _e90) * _e156);
                    let _e621 = ((_e148 * _e102) * _e158);
                    let _e639 = ((((_e618 * (_e103 * _e103)) + (_e619 * (_e104 * _e104))) + (_e620 * (_e105 * _e105))) + (_e621 * (_e106 * _e106)));
                    if (_e639 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
                            phi_877_ = _e103;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_876_ = 0f;
                            } else {
                                if (_e103 < 0f) {
                                    phi_875_ = 0f;
                                } else {
                                    phi_875_ = 1f;
                                }
                                let _e649 = phi_875_;
                                phi_876_ = _e649;
                            }
                            let _e651 = phi_876_;
                            phi_877_ = _e651;
                        }
                        let _e653 = phi_877_;
                        if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                            phi_896_ = _e104;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_895_ = 0f;
                            } else {
                                if (_e104 < 0f) {
                                    phi_894_ = 0f;
                                } else {
                                    phi_894_ = 1f;
                                }
                                let _e662 = phi_894_;
                                phi_895_ = _e662;
                            }
                            let _e664 = phi_895_;
                            phi_896_ = _e664;
                        }
                        let _e666 = phi_896_;
                        if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
                            phi_915_ = _e105;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_914_ = 0f;
                            } else {
                                if (_e105 < 0f) {
                                    phi_913_ = 0f;
                                } else {
                                    phi_913_ = 1f;
                                }
                                let _e675 = phi_913_;
                                phi_914_ = _e675;
                            }
                            let _e677 = phi_914_;
                            phi_915_ = _e677;
                        }
                        let _e679 = phi_915_;
                        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                            phi_934_ = _e106;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_933_ = 0f;
                            } else {
                                if (_e106 < 0f) {
                                    phi_932_ = 0f;
                                } else {
                                    phi_932_ = 1f;
                                }
                                let _e688 = phi_932_;
                                phi_933_ = _e688;
                            }
                            let _e690 = phi_933_;
                            phi_934_ = _e690;
                        }
                        let _e692 = phi_934_;
                        let _e700 = (((((_e653 * _e142) + (_e666 * _e144)) + (_e679 * _e146)) + (_e692 * _e148)) + _e139);
                        if ((bitcast<u32>(_e700) & 2147483647u) > 2139095040u) {
                            phi_959_ = _e700;
                        } else {
                            if (_e700 < 0f) {
                                phi_958_ = 0f;
                            } else {
                                if (_e700 > 1f) {
                                    phi_957_ = 1f;
                                } else {
                                    phi_957_ = _e700;
                                }
                                let _e707 = phi_957_;
                                phi_958_ = _e707;
                            }
                            let _e709 = phi_958_;
                            phi_959_ = _e709;
                        }
                        let _e711 = phi_959_;
                        phi_1047_ = _e711;
                    } else {
                        let _e712 = (((((_e618 * _e103) + (_e619 * _e104)) + (_e620 * _e105)) + (_e621 * _e106)) / _e639);
                        let _e729 = ((_e142 * _e103) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e712 * _e103)));
                        let _e730 = ((_e144 * _e104) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e712 * _e104)));
                        let _e731 = ((_e146 * _e105) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e712 * _e105)));
                        let _e732 = ((_e148 * _e106) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e712 * _e106)));
                        if (_e712 > 0f) {
                            phi_1046_ = ((1f - _e139) - (((((_e729 * _e152) + (_e730 * _e154)) + (_e731 * _e156)) + (_e732 * _e158)) / (_e149 * (1f - (_e149 * _e712)))));
                        } else {
                            phi_1046_ = ((((((((_e618 * ((_e619 * _e163) + ((0.5f * _e620) * _e171))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e619 * ((_e620 * _e164) + ((0.5f * _e621) * _e172))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e620 * ((_e621 * _e165) + ((0.5f * _e618) * _e173))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e621 * ((_e618 * _e166) + ((0.5f * _e619) * _e174))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e639 * (-(_e149) * _e150))) + _e139) + (((((_e729 * _e66) + (_e730 * _e78)) + (_e731 * _e90)) + (_e732 * _e102)) / (_e150 * (1f - (_e712 * _e150)))));
                        }
                        let _e796 = phi_1046_;
                        phi_1047_ = _e796;
                    }
                    let _e798 = phi_1047_;
                    if ((bitcast<u32>(_e581) & 2147483647u) > 2139095040u) {
                        phi_1058_ = true;
                    } else {
                        let _e802 = (_e581 < _e798);
                        if _e802 {
                        }
                        phi_1058_ = _e802;
                    }
                    let _e804 = phi_1058_;
                    if _e804 {
                        phi_1062_ = _e581;
                    } else {
                        phi_1062_ = _e798;
                    }
                    let _e806 = phi_1062_;
                    phi_1063_ = _e806;
                } else {
                    phi_1063_ = _e581;
                }
                let _e808 = phi_1063_;
                if ((bitcast<u32>(_e808) & 2147483647u) > 2139095040u) {
                    phi_1080_ = _e808;
                } else {
                    if (_e808 < 0f) {
                        phi_1079_ = 0f;
                    } else {
                        if (_e808 > 1f) {
                            phi_1078_ = 1f;
                        } else {
                            phi_1078_ = _e808;
                        }
                        let _e815 = phi_1078_;
                        phi_1079_ = _e815;
                    }
                    let _e817 = phi_1079_;
                    phi_1080_ = _e817;
                }
                let _e819 = phi_1080_;
                phi_1081_ = f32();
                phi_1082_ = _e819;
            }
            let _e821 = phi_1081_;
            let _e823 = phi_1082_;
            phi_1083_ = _e821;
            phi_1084_ = _e823;
            phi_1085_ = _e426;
        }
        let _e825 = phi_1083_;
        let _e827 = phi_1084_;
        let _e829 = phi_1085_;
        phi_1086_ = _e825;
        phi_1087_ = _e827;
        phi_1088_ = _e829;
    }
    let _e831 = phi_1086_;
    let _e833 = phi_1087_;
    let _e835 = phi_1088_;
    if _e835 {
        phi_1092_ = _e831;
    } else {
        phi_1092_ = _e833;
    }
    let _e837 = phi_1092_;
    return _e837;
}

fn function_() {
    var local: f32;
    var phi_1148_: bool;
    var phi_1149_: bool;
    var phi_1150_: bool;
    var phi_1151_: bool;
    var phi_1155_: bool;
    var phi_1225_: bool;
    var phi_1226_: bool;
    var phi_1237_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1238_: bool;
    var phi_1239_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1240_: bool;
    var phi_1247_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1251_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1325_: bool;
    var phi_1334_: bool;
    var phi_1343_: bool;
    var phi_1344_: bool;
    var phi_1345_: bool;
    var phi_1346_: bool;
    var phi_1347_: bool;
    var phi_1348_: bool;
    var phi_1349_: bool;
    var phi_1353_: bool;
    var phi_1443_: f32;
    var phi_1446_: f32;
    var phi_1475_: f32;
    var phi_1480_: f32;
    var phi_1481_: bool;
    var phi_1482_: f32;
    var phi_1483_: bool;
    var phi_1487_: f32;
    var phi_1507_: f32;
    var phi_1512_: f32;
    var phi_1513_: bool;
    var phi_1514_: f32;
    var phi_1515_: bool;
    var phi_1519_: f32;
    var phi_1567_: i32;
    var phi_1572_: i32;
    var phi_1577_: i32;
    var phi_1582_: i32;
    var phi_1591_: i32;
    var phi_1596_: i32;
    var phi_1601_: i32;
    var phi_1606_: i32;
    var phi_1657_: bool;
    var phi_1665_: bool;
    var phi_1677_: bool;
    var phi_1678_: bool;
    var phi_1682_: f32;
    var phi_1688_: f32;
    var phi_1690_: evaluate_Verdict;
    var phi_1695_: evaluate_Verdict;
    var phi_1696_: evaluate_Verdict;

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
        let _e69 = samples.member[(0u + _e55.first_primitive)].normal[0u];
        let _e71 = global[0u];
        if (_e69 == _e71) {
            let _e74 = samples.member[(0u + _e55.first_primitive)].normal[1u];
            let _e76 = global[1u];
            if (_e74 == _e76) {
                let _e79 = samples.member[(0u + _e55.first_primitive)].normal[2u];
                let _e81 = global[2u];
                phi_1148_ = (_e79 == _e81);
                phi_1149_ = false;
            } else {
                phi_1148_ = bool();
                phi_1149_ = true;
            }
            let _e84 = phi_1148_;
            let _e86 = phi_1149_;
            phi_1150_ = _e84;
            phi_1151_ = _e86;
        } else {
            phi_1150_ = bool();
            phi_1151_ = true;
        }
        let _e88 = phi_1150_;
        let _e90 = phi_1151_;
        if _e90 {
            phi_1155_ = false;
        } else {
            phi_1155_ = _e88;
        }
        let _e92 = phi_1155_;
        if !(_e92) {
            let _e95 = samples.member[(0u + _e55.first_primitive)].position;
            let _e97 = p.member.light.place;
            let _e103 = p.member.light.place[3u];
            let _e110 = (_e97.x - (_e95.x * _e103));
            let _e111 = (_e97.y - (_e95.y * _e103));
            let _e112 = (_e97.z - (_e95.z * _e103));
            let _e114 = samples.member[(0u + _e55.first_primitive)].normal;
            if ((((_e114.x * _e110) + (_e114.y * _e111)) + (_e114.z * _e112)) > 0f) {
                let _e128 = (((_e110 * _e110) + (_e111 * _e111)) + (_e112 * _e112));
                let _e130 = p.member.light.axis;
                let _e142 = p.member.light.place[3u];
                if (_e142 == 0f) {
                    phi_1226_ = true;
                } else {
                    let _e145 = p.member.light.range_squared;
                    if (_e128 <= _e145) {
                        let _e148 = p.member.light.cos_outer;
                        phi_1225_ = (-((((_e110 * _e130.x) + (_e111 * _e130.y)) + (_e112 * _e130.z))) >= (_e148 * sqrt(_e128)));
                    } else {
                        phi_1225_ = false;
                    }
                    let _e153 = phi_1225_;
                    phi_1226_ = _e153;
                }
                let _e155 = phi_1226_;
                if _e155 {
                    let _e157 = samples.member[(0u + _e55.first_primitive)].flags;
                    let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e165.unnamed.visibility, false), _e165.unnamed_1);
                    phi_1237_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e171.unnamed, ((_e157 & 1u) == 0u));
                    phi_1238_ = false;
                } else {
                    phi_1237_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1238_ = true;
                }
                let _e176 = phi_1237_;
                let _e178 = phi_1238_;
                phi_1239_ = _e176;
                phi_1240_ = _e178;
            } else {
                phi_1239_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1240_ = true;
            }
            let _e180 = phi_1239_;
            let _e182 = phi_1240_;
            if _e182 {
                let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e188.unnamed.visibility, false), _e188.unnamed_1);
                phi_1247_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e194.unnamed, true);
            } else {
                phi_1247_ = _e180;
            }
            let _e199 = phi_1247_;
            phi_1251_ = _e199;
        } else {
            let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
            phi_1251_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
        }
        let _e216 = phi_1251_;
        if _e216.unnamed_1 {
            phi_1696_ = evaluate_Verdict(_e216.unnamed.visibility, _e216.unnamed.is_doubted);
        } else {
            let _e224 = samples.member[(0u + _e55.first_primitive)].position;
            let _e242 = ((((_e65.projection.row_w.x * _e224.x) + (_e65.projection.row_w.y * _e224.y)) + (_e65.projection.row_w.z * _e224.z)) + (_e65.projection.row_w.w * 1f));
            let _e256 = (((((_e65.projection.row_x.x * _e224.x) + (_e65.projection.row_x.y * _e224.y)) + (_e65.projection.row_x.z * _e224.z)) + (_e65.projection.row_x.w * 1f)) / _e242);
            let _e270 = (((((_e65.projection.row_y.x * _e224.x) + (_e65.projection.row_y.y * _e224.y)) + (_e65.projection.row_y.z * _e224.z)) + (_e65.projection.row_y.w * 1f)) / _e242);
            let _e283 = ((((_e65.projection.row_z.x * _e224.x) + (_e65.projection.row_z.y * _e224.y)) + (_e65.projection.row_z.z * _e224.z)) + (_e65.projection.row_z.w * 1f));
            if (_e242 > 0f) {
                if (_e256 >= 0f) {
                    phi_1325_ = (_e256 <= 1f);
                } else {
                    phi_1325_ = false;
                }
                let _e288 = phi_1325_;
                if _e288 {
                    if (_e270 >= 0f) {
                        phi_1334_ = (_e270 <= 1f);
                    } else {
                        phi_1334_ = false;
                    }
                    let _e292 = phi_1334_;
                    if _e292 {
                        if (_e283 >= 0f) {
                            phi_1343_ = (_e283 <= 1f);
                        } else {
                            phi_1343_ = false;
                        }
                        let _e296 = phi_1343_;
                        phi_1344_ = _e296;
                        phi_1345_ = false;
                    } else {
                        phi_1344_ = bool();
                        phi_1345_ = true;
                    }
                    let _e298 = phi_1344_;
                    let _e300 = phi_1345_;
                    phi_1346_ = _e298;
                    phi_1347_ = _e300;
                } else {
                    phi_1346_ = bool();
                    phi_1347_ = true;
                }
                let _e302 = phi_1346_;
                let _e304 = phi_1347_;
                phi_1348_ = _e302;
                phi_1349_ = _e304;
            } else {
                phi_1348_ = bool();
                phi_1349_ = true;
            }
            let _e306 = phi_1348_;
            let _e308 = phi_1349_;
            if _e308 {
                phi_1353_ = false;
            } else {
                phi_1353_ = _e306;
            }
            let _e310 = phi_1353_;
            if _e310 {
                if (0f > 0f) {
                    let _e313 = samples.member[(0u + _e55.first_primitive)].normal;
                    let _e315 = p.member.map_size;
                    let _e385 = ((abs(((((_e61.row_x.x * _e313.x) + (_e61.row_x.y * _e313.y)) + (_e61.row_x.z * _e313.z)) / (((_e61.row_x.x * _e61.row_x.x) + (_e61.row_x.y * _e61.row_x.y)) + (_e61.row_x.z * _e61.row_x.z)))) + abs(((((_e61.row_y.x * _e313.x) + (_e61.row_y.y * _e313.y)) + (_e61.row_y.z * _e313.z)) / (((_e61.row_y.x * _e61.row_y.x) + (_e61.row_y.y * _e61.row_y.y)) + (_e61.row_y.z * _e61.row_y.z))))) / (abs(((((_e61.row_z.x * _e313.x) + (_e61.row_z.y * _e313.y)) + (_e61.row_z.z * _e313.z)) / (((_e61.row_z.x * _e61.row_z.x) + (_e61.row_z.y * _e61.row_z.y)) + (_e61.row_z.z * _e61.row_z.z)))) * f32(_e315)));
                    if (_e385 < 0.002f) {
                        phi_1443_ = _e385;
                    } else {
                        phi_1443_ = 0.002f;
                    }
                    let _e388 = phi_1443_;
                    phi_1446_ = (_e283 - (0f * _e388));
                } else {
                    phi_1446_ = _e283;
                }
                let _e392 = phi_1446_;
                let _e394 = p.member.map_size;
                let _e395 = f32(_e394);
                let _e398 = ((_e256 * _e395) - 0.5f);
                let _e399 = ((_e270 * _e395) - 0.5f);
                if (_e398 > -8388608f) {
                    let _e411 = f32(select(0i, select(select(i32(_e398), i32(-2147483648), (_e398 < bitcast<f32>(3472883712u))), 2147483647i, (_e398 > bitcast<f32>(1325400063u))), (_e398 == _e398)));
                    if (_e411 > _e398) {
                        phi_1475_ = 1f;
                    } else {
                        phi_1475_ = 0f;
                    }
                    let _e414 = phi_1475_;
                    if (_e398 < 8388608f) {
                        phi_1480_ = (_e411 - _e414);
                        phi_1481_ = false;
                    } else {
                        phi_1480_ = f32();
                        phi_1481_ = true;
                    }
                    let _e417 = phi_1480_;
                    let _e419 = phi_1481_;
                    phi_1482_ = _e417;
                    phi_1483_ = _e419;
                } else {
                    phi_1482_ = f32();
                    phi_1483_ = true;
                }
                let _e421 = phi_1482_;
                let _e423 = phi_1483_;
                if _e423 {
                    phi_1487_ = _e398;
                } else {
                    phi_1487_ = _e421;
                }
                let _e425 = phi_1487_;
                if (_e399 > -8388608f) {
                    let _e437 = f32(select(0i, select(select(i32(_e399), i32(-2147483648), (_e399 < bitcast<f32>(3472883712u))), 2147483647i, (_e399 > bitcast<f32>(1325400063u))), (_e399 == _e399)));
                    if (_e437 > _e399) {
                        phi_1507_ = 1f;
                    } else {
                        phi_1507_ = 0f;
                    }
                    let _e440 = phi_1507_;
                    if (_e399 < 8388608f) {
                        phi_1512_ = (_e437 - _e440);
                        phi_1513_ = false;
                    } else {
                        phi_1512_ = f32();
                        phi_1513_ = true;
                    }
                    let _e443 = phi_1512_;
                    let _e445 = phi_1513_;
                    phi_1514_ = _e443;
                    phi_1515_ = _e445;
                } else {
                    phi_1514_ = f32();
                    phi_1515_ = true;
                }
                let _e447 = phi_1514_;
                let _e449 = phi_1515_;
                if _e449 {
                    phi_1519_ = _e399;
                } else {
                    phi_1519_ = _e447;
                }
                let _e451 = phi_1519_;
                let _e452 = (_e398 - _e425);
                let _e453 = (_e399 - _e451);
                let _e462 = select(0i, select(select(i32(_e425), i32(-2147483648), (_e425 < bitcast<f32>(3472883712u))), 2147483647i, (_e425 > bitcast<f32>(1325400063u))), (_e425 == _e425));
                let _e471 = select(0i, select(select(i32(_e451), i32(-2147483648), (_e451 < bitcast<f32>(3472883712u))), 2147483647i, (_e451 > bitcast<f32>(1325400063u))), (_e451 == _e451));
                let _e482 = p.member.test;
                let _e483 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e482);
                let _e485 = p.member.map_size;
                local = _e483;
                let _e487 = ((0u * _e485) * _e485);
                let _e489 = (bitcast<i32>(_e485) - 1i);
                if (_e462 > 0i) {
                    phi_1567_ = _e462;
                } else {
                    phi_1567_ = 0i;
                }
                let _e492 = phi_1567_;
                if (_e471 > 0i) {
                    phi_1572_ = _e471;
                } else {
                    phi_1572_ = 0i;
                }
                let _e495 = phi_1572_;
                if (_e492 < _e489) {
                    phi_1577_ = _e492;
                } else {
                    phi_1577_ = _e489;
                }
                let _e498 = phi_1577_;
                if (_e495 < _e489) {
                    phi_1582_ = _e495;
                } else {
                    phi_1582_ = _e489;
                }
                let _e501 = phi_1582_;
                let _e502 = bitcast<u32>(_e498);
                let _e504 = (_e462 + 1i);
                let _e505 = (_e471 + 1i);
                if (_e504 > 0i) {
                    phi_1591_ = _e504;
                } else {
                    phi_1591_ = 0i;
                }
                let _e508 = phi_1591_;
                if (_e505 > 0i) {
                    phi_1596_ = _e505;
                } else {
                    phi_1596_ = 0i;
                }
                let _e511 = phi_1596_;
                if (_e508 < _e489) {
                    phi_1601_ = _e508;
                } else {
                    phi_1601_ = _e489;
                }
                let _e514 = phi_1601_;
                if (_e511 < _e489) {
                    phi_1606_ = _e511;
                } else {
                    phi_1606_ = _e489;
                }
                let _e517 = phi_1606_;
                let _e518 = bitcast<u32>(_e514);
                let _e520 = (bitcast<u32>(_e501) * _e485);
                let _e521 = (bitcast<u32>(_e517) * _e485);
                let _e526 = ((_e520 + _e502) + _e487);
                let _e527 = ((_e520 + _e518) + _e487);
                let _e528 = ((_e521 + _e502) + _e487);
                let _e529 = ((_e521 + _e518) + _e487);
                if (_e526 < _e46) {
                } else {
                    return;
                }
                let _e533 = map.member[(0u + _e526)];
                if (_e527 < _e46) {
                } else {
                    return;
                }
                let _e537 = map.member[(0u + _e527)];
                if (_e528 < _e46) {
                } else {
                    return;
                }
                let _e541 = map.member[(0u + _e528)];
                if (_e529 < _e46) {
                } else {
                    return;
                }
                let _e545 = map.member[(0u + _e529)];
                let _e547 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e533, _e537, _e541, _e545), vec4<f32>(((1f - _e452) * (1f - _e453)), (_e452 * (1f - _e453)), ((1f - _e452) * _e453), (_e452 * _e453)), _e392);
                let _e549 = p.member.epsilon;
                if (_e547 <= _e549) {
                    phi_1657_ = true;
                } else {
                    phi_1657_ = (_e547 >= (1f - _e549));
                }
                let _e554 = phi_1657_;
                if ((bitcast<u32>(_e547) & 2147483647u) > 2139095040u) {
                    phi_1665_ = true;
                } else {
                    phi_1665_ = !(_e554);
                }
                let _e560 = phi_1665_;
                if _e560 {
                    if (_e547 > 0f) {
                        if (_e547 < 1f) {
                            phi_1677_ = false;
                        } else {
                            phi_1677_ = true;
                        }
                        let _e564 = phi_1677_;
                        phi_1678_ = _e564;
                    } else {
                        phi_1678_ = true;
                    }
                    let _e566 = phi_1678_;
                    if _e566 {
                        phi_1682_ = 0.5f;
                    } else {
                        phi_1682_ = _e547;
                    }
                    let _e568 = phi_1682_;
                    phi_1690_ = evaluate_Verdict(_e568, true);
                } else {
                    if (_e547 > 0.5f) {
                        phi_1688_ = 1f;
                    } else {
                        phi_1688_ = 0f;
                    }
                    let _e572 = phi_1688_;
                    phi_1690_ = evaluate_Verdict(_e572, false);
                }
                let _e575 = phi_1690_;
                phi_1695_ = evaluate_Verdict(_e575.visibility, _e575.is_doubted);
            } else {
                phi_1695_ = evaluate_Verdict(0.5f, true);
            }
            let _e581 = phi_1695_;
            phi_1696_ = _e581;
        }
        let _e583 = phi_1696_;
        if (_e55.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e55.first_primitive)] = _e583.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
