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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_28 {
    member: abi_ShadowParams,
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
    var phi_132_: lt_bvh_traverse_Tree;
    var phi_133_: bool;
    var phi_134_: lt_bvh_traverse_Tree;
    var phi_135_: bool;
    var phi_140_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_132_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_133_ = false;
        } else {
            phi_132_ = lt_bvh_traverse_Tree();
            phi_133_ = true;
        }
        let _e51 = phi_132_;
        let _e53 = phi_133_;
        phi_134_ = _e51;
        phi_135_ = _e53;
    } else {
        phi_134_ = lt_bvh_traverse_Tree();
        phi_135_ = true;
    }
    let _e55 = phi_134_;
    let _e57 = phi_135_;
    if _e57 {
        phi_140_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_140_ = _e55;
    }
    let _e62 = phi_140_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_167_: f32;
    var phi_168_: f32;
    var phi_169_: f32;
    var phi_186_: f32;
    var phi_187_: f32;
    var phi_188_: f32;
    var phi_204_: f32;
    var phi_205_: f32;
    var phi_206_: f32;
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_240_: f32;
    var phi_241_: f32;
    var phi_242_: f32;
    var phi_277_: bool;
    var phi_278_: bool;
    var phi_279_: bool;
    var phi_280_: bool;
    var phi_281_: bool;
    var phi_282_: bool;
    var phi_286_: bool;
    var phi_597_: f32;
    var phi_598_: f32;
    var phi_599_: f32;
    var phi_616_: f32;
    var phi_617_: f32;
    var phi_618_: f32;
    var phi_635_: f32;
    var phi_636_: f32;
    var phi_637_: f32;
    var phi_654_: f32;
    var phi_655_: f32;
    var phi_656_: f32;
    var phi_679_: f32;
    var phi_680_: f32;
    var phi_681_: f32;
    var phi_692_: f32;
    var phi_707_: f32;
    var phi_709_: lt_bvh_slab_Span;
    var phi_767_: f32;
    var phi_768_: f32;
    var phi_769_: f32;
    var phi_770_: f32;
    var phi_771_: f32;
    var phi_772_: bool;
    var phi_776_: f32;
    var phi_786_: bool;
    var phi_799_: bool;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_814_: bool;
    var phi_815_: bool;
    var phi_816_: bool;
    var phi_820_: bool;
    var phi_871_: f32;
    var phi_872_: f32;
    var phi_873_: f32;
    var phi_890_: f32;
    var phi_891_: f32;
    var phi_892_: f32;
    var phi_909_: f32;
    var phi_910_: f32;
    var phi_911_: f32;
    var phi_928_: f32;
    var phi_929_: f32;
    var phi_930_: f32;
    var phi_953_: f32;
    var phi_954_: f32;
    var phi_955_: f32;
    var phi_1042_: f32;
    var phi_1043_: f32;
    var phi_1054_: bool;
    var phi_1058_: f32;
    var phi_1059_: f32;
    var phi_1074_: f32;
    var phi_1075_: f32;
    var phi_1076_: f32;
    var phi_1077_: f32;
    var phi_1078_: f32;
    var phi_1079_: f32;
    var phi_1080_: f32;
    var phi_1081_: bool;
    var phi_1082_: f32;
    var phi_1083_: f32;
    var phi_1084_: bool;
    var phi_1088_: f32;

    let _e42 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_169_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_168_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_167_ = 1f;
            } else {
                phi_167_ = param_7;
            }
            let _e49 = phi_167_;
            phi_168_ = _e49;
        }
        let _e51 = phi_168_;
        phi_169_ = _e51;
    }
    let _e53 = phi_169_;
    let _e54 = (_e53 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_188_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_187_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_186_ = 1f;
            } else {
                phi_186_ = param_5.x;
            }
            let _e62 = phi_186_;
            phi_187_ = _e62;
        }
        let _e64 = phi_187_;
        phi_188_ = _e64;
    }
    let _e66 = phi_188_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_206_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_205_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_204_ = 1f;
            } else {
                phi_204_ = param_5.y;
            }
            let _e74 = phi_204_;
            phi_205_ = _e74;
        }
        let _e76 = phi_205_;
        phi_206_ = _e76;
    }
    let _e78 = phi_206_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_224_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_223_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_222_ = 1f;
            } else {
                phi_222_ = param_5.z;
            }
            let _e86 = phi_222_;
            phi_223_ = _e86;
        }
        let _e88 = phi_223_;
        phi_224_ = _e88;
    }
    let _e90 = phi_224_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_242_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_241_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_240_ = 1f;
            } else {
                phi_240_ = param_5.w;
            }
            let _e98 = phi_240_;
            phi_241_ = _e98;
        }
        let _e100 = phi_241_;
        phi_242_ = _e100;
    }
    let _e102 = phi_242_;
    let _e103 = (_e66 - _e54);
    let _e104 = (_e78 - _e54);
    let _e105 = (_e90 - _e54);
    let _e106 = (_e102 - _e54);
    let _e117 = ((((_e103 * param_6.x) + (_e104 * param_6.y)) + (_e105 * param_6.z)) + (_e106 * param_6.w));
    if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
        phi_1082_ = _e117;
        phi_1083_ = f32();
        phi_1084_ = true;
    } else {
        if (_e103 >= 0f) {
            if (_e104 >= 0f) {
                if (_e105 >= 0f) {
                    phi_277_ = (_e106 >= 0f);
                    phi_278_ = false;
                } else {
                    phi_277_ = bool();
                    phi_278_ = true;
                }
                let _e126 = phi_277_;
                let _e128 = phi_278_;
                phi_279_ = _e126;
                phi_280_ = _e128;
            } else {
                phi_279_ = bool();
                phi_280_ = true;
            }
            let _e130 = phi_279_;
            let _e132 = phi_280_;
            phi_281_ = _e130;
            phi_282_ = _e132;
        } else {
            phi_281_ = bool();
            phi_282_ = true;
        }
        let _e134 = phi_281_;
        let _e136 = phi_282_;
        if _e136 {
            phi_286_ = false;
        } else {
            phi_286_ = _e134;
        }
        let _e138 = phi_286_;
        if _e138 {
            phi_1079_ = 1f;
            phi_1080_ = f32();
            phi_1081_ = true;
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
                    phi_599_ = _e103;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_598_ = 0f;
                    } else {
                        if (_e103 < 0f) {
                            phi_597_ = 0f;
                        } else {
                            phi_597_ = 1f;
                        }
                        let _e435 = phi_597_;
                        phi_598_ = _e435;
                    }
                    let _e437 = phi_598_;
                    phi_599_ = _e437;
                }
                let _e439 = phi_599_;
                if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                    phi_618_ = _e104;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_617_ = 0f;
                    } else {
                        if (_e104 < 0f) {
                            phi_616_ = 0f;
                        } else {
                            phi_616_ = 1f;
                        }
                        let _e448 = phi_616_;
                        phi_617_ = _e448;
                    }
                    let _e450 = phi_617_;
                    phi_618_ = _e450;
                }
                let _e452 = phi_618_;
                if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
                    phi_637_ = _e105;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_636_ = 0f;
                    } else {
                        if (_e105 < 0f) {
                            phi_635_ = 0f;
                        } else {
                            phi_635_ = 1f;
                        }
                        let _e461 = phi_635_;
                        phi_636_ = _e461;
                    }
                    let _e463 = phi_636_;
                    phi_637_ = _e463;
                }
                let _e465 = phi_637_;
                if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                    phi_656_ = _e106;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_655_ = 0f;
                    } else {
                        if (_e106 < 0f) {
                            phi_654_ = 0f;
                        } else {
                            phi_654_ = 1f;
                        }
                        let _e474 = phi_654_;
                        phi_655_ = _e474;
                    }
                    let _e476 = phi_655_;
                    phi_656_ = _e476;
                }
                let _e478 = phi_656_;
                let _e486 = (((((_e439 * _e142) + (_e452 * _e144)) + (_e465 * _e146)) + (_e478 * _e148)) + _e139);
                if ((bitcast<u32>(_e486) & 2147483647u) > 2139095040u) {
                    phi_681_ = _e486;
                } else {
                    if (_e486 < 0f) {
                        phi_680_ = 0f;
                    } else {
                        if (_e486 > 1f) {
                            phi_679_ = 1f;
                        } else {
                            phi_679_ = _e486;
                        }
                        let _e493 = phi_679_;
                        phi_680_ = _e493;
                    }
                    let _e495 = phi_680_;
                    phi_681_ = _e495;
                }
                let _e497 = phi_681_;
                phi_1077_ = _e497;
                phi_1078_ = f32();
            } else {
                let _e499 = ((0.5f * -(((((((((_e203 * (_e103 + _e104)) + (_e207 * (_e103 + _e105))) + (_e231 * (_e103 + _e149))) + (_e243 * (_e103 + _e150))) + ((((_e204 * (_e104 + _e105)) + (_e208 * (_e104 + _e106))) + (_e232 * (_e104 + _e149))) + (_e244 * (_e104 + _e150)))) + ((((_e205 * (_e105 + _e106)) + (_e209 * (_e105 + _e103))) + (_e233 * (_e105 + _e149))) + (_e245 * (_e105 + _e150)))) + ((((_e206 * (_e106 + _e103)) + (_e210 * (_e106 + _e104))) + (_e234 * (_e106 + _e149))) + (_e246 * (_e106 + _e150)))) + (_e417 * (_e149 + _e150))))) / _e420);
                let _e500 = ((((((((_e203 + _e207) + _e231) + _e243) + (((_e204 + _e208) + _e232) + _e244)) + (((_e205 + _e209) + _e233) + _e245)) + (((_e206 + _e210) + _e234) + _e246)) + _e417) / _e420);
                let _e502 = ((_e499 * _e499) - _e500);
                if (_e502 > 0f) {
                    phi_692_ = sqrt(_e502);
                } else {
                    phi_692_ = 0f;
                }
                let _e506 = phi_692_;
                if (_e499 > 0f) {
                    let _e509 = (-(_e499) - _e506);
                    phi_709_ = lt_bvh_slab_Span(_e509, (_e500 / _e509));
                } else {
                    let _e512 = (_e506 - _e499);
                    if (_e512 > 0f) {
                        phi_707_ = (_e500 / _e512);
                    } else {
                        phi_707_ = 0f;
                    }
                    let _e516 = phi_707_;
                    phi_709_ = lt_bvh_slab_Span(_e516, _e512);
                }
                let _e519 = phi_709_;
                if (_e519.near >= 0f) {
                    phi_770_ = 1f;
                    phi_771_ = f32();
                    phi_772_ = true;
                } else {
                    let _e523 = (_e519.far <= 0f);
                    if _e523 {
                        phi_768_ = (_e414 / _e420);
                        phi_769_ = f32();
                    } else {
                        let _e534 = (((((_e142 * _e103) + (_e144 * _e104)) + (_e146 * _e105)) + (_e148 * _e106)) + (_e139 * (_e149 + _e150)));
                        let _e550 = (((((_e142 * (_e103 * _e103)) + (_e144 * (_e104 * _e104))) + (_e146 * (_e105 * _e105))) + (_e148 * (_e106 * _e106))) + (_e139 * ((_e149 * _e149) + (_e150 * _e150))));
                        if (-(_e519.near) <= _e519.far) {
                            phi_767_ = (1f - (((_e519.near * _e519.near) * ((_e519.far * _e550) - _e534)) / (_e519.far - _e519.near)));
                        } else {
                            phi_767_ = ((_e414 / _e420) + (((_e519.far * _e519.far) * (_e534 - (_e519.near * _e550))) / (_e519.far - _e519.near)));
                        }
                        let _e569 = phi_767_;
                        phi_768_ = f32();
                        phi_769_ = _e569;
                    }
                    let _e571 = phi_768_;
                    let _e573 = phi_769_;
                    phi_770_ = _e571;
                    phi_771_ = _e573;
                    phi_772_ = _e523;
                }
                let _e575 = phi_770_;
                let _e577 = phi_771_;
                let _e579 = phi_772_;
                if _e579 {
                    phi_776_ = _e575;
                } else {
                    phi_776_ = _e577;
                }
                let _e581 = phi_776_;
                if ((_e519.near * _e149) >= (1f - 0.00001f)) {
                    phi_786_ = true;
                } else {
                    phi_786_ = ((_e519.near * _e150) >= (1f - 0.00001f));
                }
                let _e589 = phi_786_;
                if _e589 {
                    if ((_e519.far * _e149) >= (1f - 0.00001f)) {
                        phi_799_ = true;
                    } else {
                        phi_799_ = ((_e519.far * _e150) >= (1f - 0.00001f));
                    }
                    let _e597 = phi_799_;
                    if _e597 {
                        phi_803_ = false;
                    } else {
                        phi_803_ = true;
                    }
                    let _e599 = phi_803_;
                    phi_804_ = _e599;
                } else {
                    phi_804_ = true;
                }
                let _e601 = phi_804_;
                if _e601 {
                    let _e603 = (-(_e149) < 0.0001f);
                    if _e603 {
                        phi_814_ = bool();
                    } else {
                        phi_814_ = (_e150 < 0.0001f);
                    }
                    let _e606 = phi_814_;
                    phi_815_ = _e606;
                    phi_816_ = _e603;
                } else {
                    phi_815_ = bool();
                    phi_816_ = true;
                }
                let _e608 = phi_815_;
                let _e610 = phi_816_;
                if _e610 {
                    phi_820_ = true;
                } else {
                    phi_820_ = _e608;
                }
                let _e612 = phi_820_;
                if !(_e612) {
                    let _e618 = ((_e142 * _e66) * _e152);
                    let _e619 = ((_e144 * _e78) * _e154);
                    let _e620 = ((_e146 * _e90) * _e156);
                    let _e621 = ((_e148 * _e102) * _e158);
                    let _e639 = ((((_e618 * (_e103 * _e103)) + (_e619 * (_e104 * _e104))) + (_e620 * (_e105 * _e105))) + (_e621 * (_e106 * _e106)));
                    if (_e639 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
                            phi_873_ = _e103;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_872_ = 0f;
                            } else {
                                if (_e103 < 0f) {
                                    phi_871_ = 0f;
                                } else {
                                    phi_871_ = 1f;
                                }
                                let _e649 = phi_871_;
                                phi_872_ = _e649;
                            }
                            let _e651 = phi_872_;
                            phi_873_ = _e651;
                        }
                        let _e653 = phi_873_;
                        if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                            phi_892_ = _e104;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_891_ = 0f;
                            } else {
                                if (_e104 < 0f) {
                                    phi_890_ = 0f;
                                } else {
                                    phi_890_ = 1f;
                                }
                                let _e662 = phi_890_;
                                phi_891_ = _e662;
                            }
                            let _e664 = phi_891_;
                            phi_892_ = _e664;
                        }
                        let _e666 = phi_892_;
                        if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
                            phi_911_ = _e105;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_910_ = 0f;
                            } else {
                                if (_e105 < 0f) {
                                    phi_909_ = 0f;
                                } else {
                                    phi_909_ = 1f;
                                }
                                let _e675 = phi_909_;
                                phi_910_ = _e675;
                            }
                            let _e677 = phi_910_;
                            phi_911_ = _e677;
                        }
                        let _e679 = phi_911_;
                        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
                            phi_930_ = _e106;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_929_ = 0f;
                            } else {
                                if (_e106 < 0f) {
                                    phi_928_ = 0f;
                                } else {
                                    phi_928_ = 1f;
                                }
                                let _e688 = phi_928_;
                                phi_929_ = _e688;
                            }
                            let _e690 = phi_929_;
                            phi_930_ = _e690;
                        }
                        let _e692 = phi_930_;
                        let _e700 = (((((_e653 * _e142) + (_e666 * _e144)) + (_e679 * _e146)) + (_e692 * _e148)) + _e139);
                        if ((bitcast<u32>(_e700) & 2147483647u) > 2139095040u) {
                            phi_955_ = _e700;
                        } else {
                            if (_e700 < 0f) {
                                phi_954_ = 0f;
                            } else {
                                if (_e700 > 1f) {
                                    phi_953_ = 1f;
                                } else {
                                    phi_953_ = _e700;
                                }
                                let _e707 = phi_953_;
                                phi_954_ = _e707;
                            }
                            let _e709 = phi_954_;
                            phi_955_ = _e709;
                        }
                        let _e711 = phi_955_;
                        phi_1043_ = _e711;
                    } else {
                        let _e712 = (((((_e618 * _e103) + (_e619 * _e104)) + (_e620 * _e105)) + (_e621 * _e106)) / _e639);
                        let _e729 = ((_e142 * _e103) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e712 * _e103)));
                        let _e730 = ((_e144 * _e104) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e712 * _e104)));
                        let _e731 = ((_e146 * _e105) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e712 * _e105)));
                        let _e732 = ((_e148 * _e106) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e712 * _e106)));
                        if (_e712 > 0f) {
                            phi_1042_ = ((1f - _e139) - (((((_e729 * _e152) + (_e730 * _e154)) + (_e731 * _e156)) + (_e732 * _e158)) / (_e149 * (1f - (_e149 * _e712)))));
                        } else {
                            phi_1042_ = ((((((((_e618 * ((_e619 * _e163) + ((0.5f * _e620) * _e171))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e619 * ((_e620 * _e164) + ((0.5f * _e621) * _e172))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e620 * ((_e621 * _e165) + ((0.5f * _e618) * _e173))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e621 * ((_e618 * _e166) + ((0.5f * _e619) * _e174))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e639 * (-(_e149) * _e150))) + _e139) + (((((_e729 * _e66) + (_e730 * _e78)) + (_e731 * _e90)) + (_e732 * _e102)) / (_e150 * (1f - (_e712 * _e150)))));
                        }
                        let _e796 = phi_1042_;
                        phi_1043_ = _e796;
                    }
                    let _e798 = phi_1043_;
                    if ((bitcast<u32>(_e581) & 2147483647u) > 2139095040u) {
                        phi_1054_ = true;
                    } else {
                        let _e802 = (_e581 < _e798);
                        if _e802 {
                        }
                        phi_1054_ = _e802;
                    }
                    let _e804 = phi_1054_;
                    if _e804 {
                        phi_1058_ = _e581;
                    } else {
                        phi_1058_ = _e798;
                    }
                    let _e806 = phi_1058_;
                    phi_1059_ = _e806;
                } else {
                    phi_1059_ = _e581;
                }
                let _e808 = phi_1059_;
                if ((bitcast<u32>(_e808) & 2147483647u) > 2139095040u) {
                    phi_1076_ = _e808;
                } else {
                    if (_e808 < 0f) {
                        phi_1075_ = 0f;
                    } else {
                        if (_e808 > 1f) {
                            phi_1074_ = 1f;
                        } else {
                            phi_1074_ = _e808;
                        }
                        let _e815 = phi_1074_;
                        phi_1075_ = _e815;
                    }
                    let _e817 = phi_1075_;
                    phi_1076_ = _e817;
                }
                let _e819 = phi_1076_;
                phi_1077_ = f32();
                phi_1078_ = _e819;
            }
            let _e821 = phi_1077_;
            let _e823 = phi_1078_;
            phi_1079_ = _e821;
            phi_1080_ = _e823;
            phi_1081_ = _e426;
        }
        let _e825 = phi_1079_;
        let _e827 = phi_1080_;
        let _e829 = phi_1081_;
        phi_1082_ = _e825;
        phi_1083_ = _e827;
        phi_1084_ = _e829;
    }
    let _e831 = phi_1082_;
    let _e833 = phi_1083_;
    let _e835 = phi_1084_;
    if _e835 {
        phi_1088_ = _e831;
    } else {
        phi_1088_ = _e833;
    }
    let _e837 = phi_1088_;
    return _e837;
}

fn function_() {
    var local: f32;
    var phi_1142_: bool;
    var phi_1143_: bool;
    var phi_1144_: bool;
    var phi_1145_: bool;
    var phi_1149_: bool;
    var phi_1193_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1197_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1274_: bool;
    var phi_1283_: bool;
    var phi_1292_: bool;
    var phi_1293_: bool;
    var phi_1294_: bool;
    var phi_1295_: bool;
    var phi_1296_: bool;
    var phi_1297_: bool;
    var phi_1298_: bool;
    var phi_1302_: bool;
    var phi_1396_: f32;
    var phi_1399_: f32;
    var phi_1428_: f32;
    var phi_1433_: f32;
    var phi_1434_: bool;
    var phi_1435_: f32;
    var phi_1436_: bool;
    var phi_1440_: f32;
    var phi_1460_: f32;
    var phi_1465_: f32;
    var phi_1466_: bool;
    var phi_1467_: f32;
    var phi_1468_: bool;
    var phi_1472_: f32;
    var phi_1518_: i32;
    var phi_1523_: i32;
    var phi_1528_: i32;
    var phi_1533_: i32;
    var phi_1542_: i32;
    var phi_1547_: i32;
    var phi_1552_: i32;
    var phi_1557_: i32;
    var phi_1604_: bool;
    var phi_1612_: bool;
    var phi_1624_: bool;
    var phi_1625_: bool;
    var phi_1629_: f32;
    var phi_1635_: f32;
    var phi_1637_: evaluate_Verdict;
    var phi_1642_: evaluate_Verdict;
    var phi_1643_: evaluate_Verdict;

    let _e39 = id_1;
    let _e46 = arrayLength((&map.member));
    let _e52 = p.member.size[0u];
    let _e54 = p.member.size[1u];
    let _e55 = lt_shaders_entry_pixel_index(_e39, _e52, _e54);
    if (bitcast<i32>(_e55.root) != 0i) {
        if (_e55.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e64 = p.member.light;
        let _e67 = samples.member[(0u + _e55.first_primitive)].normal[0u];
        let _e69 = global[0u];
        if (_e67 == _e69) {
            let _e72 = samples.member[(0u + _e55.first_primitive)].normal[1u];
            let _e74 = global[1u];
            if (_e72 == _e74) {
                let _e77 = samples.member[(0u + _e55.first_primitive)].normal[2u];
                let _e79 = global[2u];
                phi_1142_ = (_e77 == _e79);
                phi_1143_ = false;
            } else {
                phi_1142_ = bool();
                phi_1143_ = true;
            }
            let _e82 = phi_1142_;
            let _e84 = phi_1143_;
            phi_1144_ = _e82;
            phi_1145_ = _e84;
        } else {
            phi_1144_ = bool();
            phi_1145_ = true;
        }
        let _e86 = phi_1144_;
        let _e88 = phi_1145_;
        if _e88 {
            phi_1149_ = false;
        } else {
            phi_1149_ = _e86;
        }
        let _e90 = phi_1149_;
        if !(_e90) {
            let _e93 = samples.member[(0u + _e55.first_primitive)].normal;
            let _e95 = samples.member[(0u + _e55.first_primitive)].position;
            if ((((_e93.x * (_e64.x - (_e95.x * _e64.w))) + (_e93.y * (_e64.y - (_e95.y * _e64.w)))) + (_e93.z * (_e64.z - (_e95.z * _e64.w)))) > 0f) {
                let _e119 = samples.member[(0u + _e55.first_primitive)].flags;
                let _e127 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e127.unnamed.visibility, false), _e127.unnamed_1);
                phi_1193_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e133.unnamed, ((_e119 & 1u) == 0u));
            } else {
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e142.unnamed.visibility, false), _e142.unnamed_1);
                phi_1193_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e148.unnamed, true);
            }
            let _e153 = phi_1193_;
            phi_1197_ = _e153;
        } else {
            let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e159.unnamed.visibility, false), _e159.unnamed_1);
            phi_1197_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e165.unnamed, true);
        }
        let _e170 = phi_1197_;
        if _e170.unnamed_1 {
            phi_1643_ = evaluate_Verdict(_e170.unnamed.visibility, _e170.unnamed.is_doubted);
        } else {
            let _e178 = samples.member[(0u + _e55.first_primitive)].position;
            let _e184 = p.member.projection.row_w;
            let _e195 = ((((_e184.x * _e178.x) + (_e184.y * _e178.y)) + (_e184.z * _e178.z)) + (_e184.w * 1f));
            let _e197 = p.member.projection.row_x;
            let _e209 = (((((_e197.x * _e178.x) + (_e197.y * _e178.y)) + (_e197.z * _e178.z)) + (_e197.w * 1f)) / _e195);
            let _e211 = p.member.projection.row_y;
            let _e223 = (((((_e211.x * _e178.x) + (_e211.y * _e178.y)) + (_e211.z * _e178.z)) + (_e211.w * 1f)) / _e195);
            let _e225 = p.member.projection.row_z;
            let _e236 = ((((_e225.x * _e178.x) + (_e225.y * _e178.y)) + (_e225.z * _e178.z)) + (_e225.w * 1f));
            if (_e195 > 0f) {
                if (_e209 >= 0f) {
                    phi_1274_ = (_e209 <= 1f);
                } else {
                    phi_1274_ = false;
                }
                let _e241 = phi_1274_;
                if _e241 {
                    if (_e223 >= 0f) {
                        phi_1283_ = (_e223 <= 1f);
                    } else {
                        phi_1283_ = false;
                    }
                    let _e245 = phi_1283_;
                    if _e245 {
                        if (_e236 >= 0f) {
                            phi_1292_ = (_e236 <= 1f);
                        } else {
                            phi_1292_ = false;
                        }
                        let _e249 = phi_1292_;
                        phi_1293_ = _e249;
                        phi_1294_ = false;
                    } else {
                        phi_1293_ = bool();
                        phi_1294_ = true;
                    }
                    let _e251 = phi_1293_;
                    let _e253 = phi_1294_;
                    phi_1295_ = _e251;
                    phi_1296_ = _e253;
                } else {
                    phi_1295_ = bool();
                    phi_1296_ = true;
                }
                let _e255 = phi_1295_;
                let _e257 = phi_1296_;
                phi_1297_ = _e255;
                phi_1298_ = _e257;
            } else {
                phi_1297_ = bool();
                phi_1298_ = true;
            }
            let _e259 = phi_1297_;
            let _e261 = phi_1298_;
            if _e261 {
                phi_1302_ = false;
            } else {
                phi_1302_ = _e259;
            }
            let _e263 = phi_1302_;
            if _e263 {
                if (0f > 0f) {
                    let _e266 = samples.member[(0u + _e55.first_primitive)].normal;
                    let _e268 = p.member.map_size;
                    let _e271 = p.member.projection.row_x;
                    let _e293 = p.member.projection.row_y;
                    let _e315 = p.member.projection.row_z;
                    let _e342 = ((abs(((((_e271.x * _e266.x) + (_e271.y * _e266.y)) + (_e271.z * _e266.z)) / (((_e271.x * _e271.x) + (_e271.y * _e271.y)) + (_e271.z * _e271.z)))) + abs(((((_e293.x * _e266.x) + (_e293.y * _e266.y)) + (_e293.z * _e266.z)) / (((_e293.x * _e293.x) + (_e293.y * _e293.y)) + (_e293.z * _e293.z))))) / (abs(((((_e315.x * _e266.x) + (_e315.y * _e266.y)) + (_e315.z * _e266.z)) / (((_e315.x * _e315.x) + (_e315.y * _e315.y)) + (_e315.z * _e315.z)))) * f32(_e268)));
                    if (_e342 < 0.002f) {
                        phi_1396_ = _e342;
                    } else {
                        phi_1396_ = 0.002f;
                    }
                    let _e345 = phi_1396_;
                    phi_1399_ = (_e236 - (0f * _e345));
                } else {
                    phi_1399_ = _e236;
                }
                let _e349 = phi_1399_;
                let _e351 = p.member.map_size;
                let _e352 = f32(_e351);
                let _e355 = ((_e209 * _e352) - 0.5f);
                let _e356 = ((_e223 * _e352) - 0.5f);
                if (_e355 > -8388608f) {
                    let _e368 = f32(select(0i, select(select(i32(_e355), i32(-2147483648), (_e355 < bitcast<f32>(3472883712u))), 2147483647i, (_e355 > bitcast<f32>(1325400063u))), (_e355 == _e355)));
                    if (_e368 > _e355) {
                        phi_1428_ = 1f;
                    } else {
                        phi_1428_ = 0f;
                    }
                    let _e371 = phi_1428_;
                    if (_e355 < 8388608f) {
                        phi_1433_ = (_e368 - _e371);
                        phi_1434_ = false;
                    } else {
                        phi_1433_ = f32();
                        phi_1434_ = true;
                    }
                    let _e374 = phi_1433_;
                    let _e376 = phi_1434_;
                    phi_1435_ = _e374;
                    phi_1436_ = _e376;
                } else {
                    phi_1435_ = f32();
                    phi_1436_ = true;
                }
                let _e378 = phi_1435_;
                let _e380 = phi_1436_;
                if _e380 {
                    phi_1440_ = _e355;
                } else {
                    phi_1440_ = _e378;
                }
                let _e382 = phi_1440_;
                if (_e356 > -8388608f) {
                    let _e394 = f32(select(0i, select(select(i32(_e356), i32(-2147483648), (_e356 < bitcast<f32>(3472883712u))), 2147483647i, (_e356 > bitcast<f32>(1325400063u))), (_e356 == _e356)));
                    if (_e394 > _e356) {
                        phi_1460_ = 1f;
                    } else {
                        phi_1460_ = 0f;
                    }
                    let _e397 = phi_1460_;
                    if (_e356 < 8388608f) {
                        phi_1465_ = (_e394 - _e397);
                        phi_1466_ = false;
                    } else {
                        phi_1465_ = f32();
                        phi_1466_ = true;
                    }
                    let _e400 = phi_1465_;
                    let _e402 = phi_1466_;
                    phi_1467_ = _e400;
                    phi_1468_ = _e402;
                } else {
                    phi_1467_ = f32();
                    phi_1468_ = true;
                }
                let _e404 = phi_1467_;
                let _e406 = phi_1468_;
                if _e406 {
                    phi_1472_ = _e356;
                } else {
                    phi_1472_ = _e404;
                }
                let _e408 = phi_1472_;
                let _e409 = (_e355 - _e382);
                let _e410 = (_e356 - _e408);
                let _e419 = select(0i, select(select(i32(_e382), i32(-2147483648), (_e382 < bitcast<f32>(3472883712u))), 2147483647i, (_e382 > bitcast<f32>(1325400063u))), (_e382 == _e382));
                let _e428 = select(0i, select(select(i32(_e408), i32(-2147483648), (_e408 < bitcast<f32>(3472883712u))), 2147483647i, (_e408 > bitcast<f32>(1325400063u))), (_e408 == _e408));
                let _e439 = p.member.test;
                let _e440 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e439);
                let _e442 = p.member.map_size;
                local = _e440;
                let _e444 = (bitcast<i32>(_e442) - 1i);
                if (_e419 > 0i) {
                    phi_1518_ = _e419;
                } else {
                    phi_1518_ = 0i;
                }
                let _e447 = phi_1518_;
                if (_e428 > 0i) {
                    phi_1523_ = _e428;
                } else {
                    phi_1523_ = 0i;
                }
                let _e450 = phi_1523_;
                if (_e447 < _e444) {
                    phi_1528_ = _e447;
                } else {
                    phi_1528_ = _e444;
                }
                let _e453 = phi_1528_;
                if (_e450 < _e444) {
                    phi_1533_ = _e450;
                } else {
                    phi_1533_ = _e444;
                }
                let _e456 = phi_1533_;
                let _e457 = bitcast<u32>(_e453);
                let _e459 = (_e419 + 1i);
                let _e460 = (_e428 + 1i);
                if (_e459 > 0i) {
                    phi_1542_ = _e459;
                } else {
                    phi_1542_ = 0i;
                }
                let _e463 = phi_1542_;
                if (_e460 > 0i) {
                    phi_1547_ = _e460;
                } else {
                    phi_1547_ = 0i;
                }
                let _e466 = phi_1547_;
                if (_e463 < _e444) {
                    phi_1552_ = _e463;
                } else {
                    phi_1552_ = _e444;
                }
                let _e469 = phi_1552_;
                if (_e466 < _e444) {
                    phi_1557_ = _e466;
                } else {
                    phi_1557_ = _e444;
                }
                let _e472 = phi_1557_;
                let _e473 = bitcast<u32>(_e469);
                let _e475 = (bitcast<u32>(_e456) * _e442);
                let _e476 = (bitcast<u32>(_e472) * _e442);
                let _e477 = (_e475 + _e457);
                let _e478 = (_e475 + _e473);
                let _e479 = (_e476 + _e457);
                let _e480 = (_e476 + _e473);
                if (_e477 < _e46) {
                } else {
                    return;
                }
                let _e484 = map.member[(0u + _e477)];
                if (_e478 < _e46) {
                } else {
                    return;
                }
                let _e488 = map.member[(0u + _e478)];
                if (_e479 < _e46) {
                } else {
                    return;
                }
                let _e492 = map.member[(0u + _e479)];
                if (_e480 < _e46) {
                } else {
                    return;
                }
                let _e496 = map.member[(0u + _e480)];
                let _e498 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e484, _e488, _e492, _e496), vec4<f32>(((1f - _e409) * (1f - _e410)), (_e409 * (1f - _e410)), ((1f - _e409) * _e410), (_e409 * _e410)), _e349);
                let _e500 = p.member.epsilon;
                if (_e498 <= _e500) {
                    phi_1604_ = true;
                } else {
                    phi_1604_ = (_e498 >= (1f - _e500));
                }
                let _e505 = phi_1604_;
                if ((bitcast<u32>(_e498) & 2147483647u) > 2139095040u) {
                    phi_1612_ = true;
                } else {
                    phi_1612_ = !(_e505);
                }
                let _e511 = phi_1612_;
                if _e511 {
                    if (_e498 > 0f) {
                        if (_e498 < 1f) {
                            phi_1624_ = false;
                        } else {
                            phi_1624_ = true;
                        }
                        let _e515 = phi_1624_;
                        phi_1625_ = _e515;
                    } else {
                        phi_1625_ = true;
                    }
                    let _e517 = phi_1625_;
                    if _e517 {
                        phi_1629_ = 0.5f;
                    } else {
                        phi_1629_ = _e498;
                    }
                    let _e519 = phi_1629_;
                    phi_1637_ = evaluate_Verdict(_e519, true);
                } else {
                    if (_e498 > 0.5f) {
                        phi_1635_ = 1f;
                    } else {
                        phi_1635_ = 0f;
                    }
                    let _e523 = phi_1635_;
                    phi_1637_ = evaluate_Verdict(_e523, false);
                }
                let _e526 = phi_1637_;
                phi_1642_ = evaluate_Verdict(_e526.visibility, _e526.is_doubted);
            } else {
                phi_1642_ = evaluate_Verdict(0.5f, true);
            }
            let _e532 = phi_1642_;
            phi_1643_ = _e532;
        }
        let _e534 = phi_1643_;
        if (_e55.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e55.first_primitive)] = _e534.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
