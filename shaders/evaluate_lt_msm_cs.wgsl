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
    var phi_131_: lt_bvh_traverse_Tree;
    var phi_132_: bool;
    var phi_133_: lt_bvh_traverse_Tree;
    var phi_134_: bool;
    var phi_139_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_131_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_132_ = false;
        } else {
            phi_131_ = lt_bvh_traverse_Tree();
            phi_132_ = true;
        }
        let _e49 = phi_131_;
        let _e51 = phi_132_;
        phi_133_ = _e49;
        phi_134_ = _e51;
    } else {
        phi_133_ = lt_bvh_traverse_Tree();
        phi_134_ = true;
    }
    let _e53 = phi_133_;
    let _e55 = phi_134_;
    if _e55 {
        phi_139_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_139_ = _e53;
    }
    let _e60 = phi_139_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_166_: f32;
    var phi_167_: f32;
    var phi_168_: f32;
    var phi_185_: f32;
    var phi_186_: f32;
    var phi_187_: f32;
    var phi_203_: f32;
    var phi_204_: f32;
    var phi_205_: f32;
    var phi_221_: f32;
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_239_: f32;
    var phi_240_: f32;
    var phi_241_: f32;
    var phi_276_: bool;
    var phi_277_: bool;
    var phi_278_: bool;
    var phi_279_: bool;
    var phi_280_: bool;
    var phi_281_: bool;
    var phi_285_: bool;
    var phi_596_: f32;
    var phi_597_: f32;
    var phi_598_: f32;
    var phi_615_: f32;
    var phi_616_: f32;
    var phi_617_: f32;
    var phi_634_: f32;
    var phi_635_: f32;
    var phi_636_: f32;
    var phi_653_: f32;
    var phi_654_: f32;
    var phi_655_: f32;
    var phi_678_: f32;
    var phi_679_: f32;
    var phi_680_: f32;
    var phi_691_: f32;
    var phi_706_: f32;
    var phi_708_: lt_bvh_slab_Span;
    var phi_766_: f32;
    var phi_767_: f32;
    var phi_768_: f32;
    var phi_769_: f32;
    var phi_770_: f32;
    var phi_771_: bool;
    var phi_775_: f32;
    var phi_790_: f32;
    var phi_791_: f32;
    var phi_792_: f32;
    var phi_793_: f32;
    var phi_794_: f32;
    var phi_795_: f32;
    var phi_796_: f32;
    var phi_797_: bool;
    var phi_798_: f32;
    var phi_799_: f32;
    var phi_800_: bool;
    var phi_804_: f32;

    let _e40 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_168_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_167_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_166_ = 1f;
            } else {
                phi_166_ = param_7;
            }
            let _e47 = phi_166_;
            phi_167_ = _e47;
        }
        let _e49 = phi_167_;
        phi_168_ = _e49;
    }
    let _e51 = phi_168_;
    let _e52 = (_e51 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_187_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_186_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_185_ = 1f;
            } else {
                phi_185_ = param_5.x;
            }
            let _e60 = phi_185_;
            phi_186_ = _e60;
        }
        let _e62 = phi_186_;
        phi_187_ = _e62;
    }
    let _e64 = phi_187_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_205_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_204_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_203_ = 1f;
            } else {
                phi_203_ = param_5.y;
            }
            let _e72 = phi_203_;
            phi_204_ = _e72;
        }
        let _e74 = phi_204_;
        phi_205_ = _e74;
    }
    let _e76 = phi_205_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_223_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_222_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_221_ = 1f;
            } else {
                phi_221_ = param_5.z;
            }
            let _e84 = phi_221_;
            phi_222_ = _e84;
        }
        let _e86 = phi_222_;
        phi_223_ = _e86;
    }
    let _e88 = phi_223_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_241_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_240_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_239_ = 1f;
            } else {
                phi_239_ = param_5.w;
            }
            let _e96 = phi_239_;
            phi_240_ = _e96;
        }
        let _e98 = phi_240_;
        phi_241_ = _e98;
    }
    let _e100 = phi_241_;
    let _e101 = (_e64 - _e52);
    let _e102 = (_e76 - _e52);
    let _e103 = (_e88 - _e52);
    let _e104 = (_e100 - _e52);
    let _e115 = ((((_e101 * param_6.x) + (_e102 * param_6.y)) + (_e103 * param_6.z)) + (_e104 * param_6.w));
    if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
        phi_798_ = _e115;
        phi_799_ = f32();
        phi_800_ = true;
    } else {
        if (_e101 >= 0f) {
            if (_e102 >= 0f) {
                if (_e103 >= 0f) {
                    phi_276_ = (_e104 >= 0f);
                    phi_277_ = false;
                } else {
                    phi_276_ = bool();
                    phi_277_ = true;
                }
                let _e124 = phi_276_;
                let _e126 = phi_277_;
                phi_278_ = _e124;
                phi_279_ = _e126;
            } else {
                phi_278_ = bool();
                phi_279_ = true;
            }
            let _e128 = phi_278_;
            let _e130 = phi_279_;
            phi_280_ = _e128;
            phi_281_ = _e130;
        } else {
            phi_280_ = bool();
            phi_281_ = true;
        }
        let _e132 = phi_280_;
        let _e134 = phi_281_;
        if _e134 {
            phi_285_ = false;
        } else {
            phi_285_ = _e132;
        }
        let _e136 = phi_285_;
        if _e136 {
            phi_795_ = 1f;
            phi_796_ = f32();
            phi_797_ = true;
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
            let _e424 = (_e418 < 0.0000000000000000000000000000000001f);
            if _e424 {
                if ((bitcast<u32>(_e101) & 2147483647u) > 2139095040u) {
                    phi_598_ = _e101;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_597_ = 0f;
                    } else {
                        if (_e101 < 0f) {
                            phi_596_ = 0f;
                        } else {
                            phi_596_ = 1f;
                        }
                        let _e433 = phi_596_;
                        phi_597_ = _e433;
                    }
                    let _e435 = phi_597_;
                    phi_598_ = _e435;
                }
                let _e437 = phi_598_;
                if ((bitcast<u32>(_e102) & 2147483647u) > 2139095040u) {
                    phi_617_ = _e102;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_616_ = 0f;
                    } else {
                        if (_e102 < 0f) {
                            phi_615_ = 0f;
                        } else {
                            phi_615_ = 1f;
                        }
                        let _e446 = phi_615_;
                        phi_616_ = _e446;
                    }
                    let _e448 = phi_616_;
                    phi_617_ = _e448;
                }
                let _e450 = phi_617_;
                if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
                    phi_636_ = _e103;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_635_ = 0f;
                    } else {
                        if (_e103 < 0f) {
                            phi_634_ = 0f;
                        } else {
                            phi_634_ = 1f;
                        }
                        let _e459 = phi_634_;
                        phi_635_ = _e459;
                    }
                    let _e461 = phi_635_;
                    phi_636_ = _e461;
                }
                let _e463 = phi_636_;
                if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                    phi_655_ = _e104;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_654_ = 0f;
                    } else {
                        if (_e104 < 0f) {
                            phi_653_ = 0f;
                        } else {
                            phi_653_ = 1f;
                        }
                        let _e472 = phi_653_;
                        phi_654_ = _e472;
                    }
                    let _e474 = phi_654_;
                    phi_655_ = _e474;
                }
                let _e476 = phi_655_;
                let _e484 = (((((_e437 * _e140) + (_e450 * _e142)) + (_e463 * _e144)) + (_e476 * _e146)) + _e137);
                if ((bitcast<u32>(_e484) & 2147483647u) > 2139095040u) {
                    phi_680_ = _e484;
                } else {
                    if (_e484 < 0f) {
                        phi_679_ = 0f;
                    } else {
                        if (_e484 > 1f) {
                            phi_678_ = 1f;
                        } else {
                            phi_678_ = _e484;
                        }
                        let _e491 = phi_678_;
                        phi_679_ = _e491;
                    }
                    let _e493 = phi_679_;
                    phi_680_ = _e493;
                }
                let _e495 = phi_680_;
                phi_793_ = _e495;
                phi_794_ = f32();
            } else {
                let _e497 = ((0.5f * -(((((((((_e201 * (_e101 + _e102)) + (_e205 * (_e101 + _e103))) + (_e229 * (_e101 + _e147))) + (_e241 * (_e101 + _e148))) + ((((_e202 * (_e102 + _e103)) + (_e206 * (_e102 + _e104))) + (_e230 * (_e102 + _e147))) + (_e242 * (_e102 + _e148)))) + ((((_e203 * (_e103 + _e104)) + (_e207 * (_e103 + _e101))) + (_e231 * (_e103 + _e147))) + (_e243 * (_e103 + _e148)))) + ((((_e204 * (_e104 + _e101)) + (_e208 * (_e104 + _e102))) + (_e232 * (_e104 + _e147))) + (_e244 * (_e104 + _e148)))) + (_e415 * (_e147 + _e148))))) / _e418);
                let _e498 = ((((((((_e201 + _e205) + _e229) + _e241) + (((_e202 + _e206) + _e230) + _e242)) + (((_e203 + _e207) + _e231) + _e243)) + (((_e204 + _e208) + _e232) + _e244)) + _e415) / _e418);
                let _e500 = ((_e497 * _e497) - _e498);
                if (_e500 > 0f) {
                    phi_691_ = sqrt(_e500);
                } else {
                    phi_691_ = 0f;
                }
                let _e504 = phi_691_;
                if (_e497 > 0f) {
                    let _e507 = (-(_e497) - _e504);
                    phi_708_ = lt_bvh_slab_Span(_e507, (_e498 / _e507));
                } else {
                    let _e510 = (_e504 - _e497);
                    if (_e510 > 0f) {
                        phi_706_ = (_e498 / _e510);
                    } else {
                        phi_706_ = 0f;
                    }
                    let _e514 = phi_706_;
                    phi_708_ = lt_bvh_slab_Span(_e514, _e510);
                }
                let _e517 = phi_708_;
                if (_e517.near >= 0f) {
                    phi_769_ = 1f;
                    phi_770_ = f32();
                    phi_771_ = true;
                } else {
                    let _e521 = (_e517.far <= 0f);
                    if _e521 {
                        phi_767_ = (_e412 / _e418);
                        phi_768_ = f32();
                    } else {
                        let _e532 = (((((_e140 * _e101) + (_e142 * _e102)) + (_e144 * _e103)) + (_e146 * _e104)) + (_e137 * (_e147 + _e148)));
                        let _e548 = (((((_e140 * (_e101 * _e101)) + (_e142 * (_e102 * _e102))) + (_e144 * (_e103 * _e103))) + (_e146 * (_e104 * _e104))) + (_e137 * ((_e147 * _e147) + (_e148 * _e148))));
                        if (-(_e517.near) <= _e517.far) {
                            phi_766_ = (1f - (((_e517.near * _e517.near) * ((_e517.far * _e548) - _e532)) / (_e517.far - _e517.near)));
                        } else {
                            phi_766_ = ((_e412 / _e418) + (((_e517.far * _e517.far) * (_e532 - (_e517.near * _e548))) / (_e517.far - _e517.near)));
                        }
                        let _e567 = phi_766_;
                        phi_767_ = f32();
                        phi_768_ = _e567;
                    }
                    let _e569 = phi_767_;
                    let _e571 = phi_768_;
                    phi_769_ = _e569;
                    phi_770_ = _e571;
                    phi_771_ = _e521;
                }
                let _e573 = phi_769_;
                let _e575 = phi_770_;
                let _e577 = phi_771_;
                if _e577 {
                    phi_775_ = _e573;
                } else {
                    phi_775_ = _e575;
                }
                let _e579 = phi_775_;
                if ((bitcast<u32>(_e579) & 2147483647u) > 2139095040u) {
                    phi_792_ = _e579;
                } else {
                    if (_e579 < 0f) {
                        phi_791_ = 0f;
                    } else {
                        if (_e579 > 1f) {
                            phi_790_ = 1f;
                        } else {
                            phi_790_ = _e579;
                        }
                        let _e586 = phi_790_;
                        phi_791_ = _e586;
                    }
                    let _e588 = phi_791_;
                    phi_792_ = _e588;
                }
                let _e590 = phi_792_;
                phi_793_ = f32();
                phi_794_ = _e590;
            }
            let _e592 = phi_793_;
            let _e594 = phi_794_;
            phi_795_ = _e592;
            phi_796_ = _e594;
            phi_797_ = _e424;
        }
        let _e596 = phi_795_;
        let _e598 = phi_796_;
        let _e600 = phi_797_;
        phi_798_ = _e596;
        phi_799_ = _e598;
        phi_800_ = _e600;
    }
    let _e602 = phi_798_;
    let _e604 = phi_799_;
    let _e606 = phi_800_;
    if _e606 {
        phi_804_ = _e602;
    } else {
        phi_804_ = _e604;
    }
    let _e608 = phi_804_;
    return _e608;
}

fn function_() {
    var local: f32;
    var phi_861_: bool;
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_868_: bool;
    var phi_912_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_916_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_990_: bool;
    var phi_999_: bool;
    var phi_1008_: bool;
    var phi_1009_: bool;
    var phi_1010_: bool;
    var phi_1011_: bool;
    var phi_1012_: bool;
    var phi_1013_: bool;
    var phi_1014_: bool;
    var phi_1018_: bool;
    var phi_1108_: f32;
    var phi_1111_: f32;
    var phi_1140_: f32;
    var phi_1145_: f32;
    var phi_1146_: bool;
    var phi_1147_: f32;
    var phi_1148_: bool;
    var phi_1152_: f32;
    var phi_1172_: f32;
    var phi_1177_: f32;
    var phi_1178_: bool;
    var phi_1179_: f32;
    var phi_1180_: bool;
    var phi_1184_: f32;
    var phi_1232_: i32;
    var phi_1237_: i32;
    var phi_1242_: i32;
    var phi_1247_: i32;
    var phi_1256_: i32;
    var phi_1261_: i32;
    var phi_1266_: i32;
    var phi_1271_: i32;
    var phi_1322_: bool;
    var phi_1330_: bool;
    var phi_1342_: bool;
    var phi_1343_: bool;
    var phi_1347_: f32;
    var phi_1353_: f32;
    var phi_1355_: evaluate_Verdict;
    var phi_1360_: evaluate_Verdict;
    var phi_1361_: evaluate_Verdict;

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
        let _e65 = p.member.light;
        let _e68 = samples.member[(0u + _e53.first_primitive)].normal[0u];
        let _e70 = global[0u];
        if (_e68 == _e70) {
            let _e73 = samples.member[(0u + _e53.first_primitive)].normal[1u];
            let _e75 = global[1u];
            if (_e73 == _e75) {
                let _e78 = samples.member[(0u + _e53.first_primitive)].normal[2u];
                let _e80 = global[2u];
                phi_861_ = (_e78 == _e80);
                phi_862_ = false;
            } else {
                phi_861_ = bool();
                phi_862_ = true;
            }
            let _e83 = phi_861_;
            let _e85 = phi_862_;
            phi_863_ = _e83;
            phi_864_ = _e85;
        } else {
            phi_863_ = bool();
            phi_864_ = true;
        }
        let _e87 = phi_863_;
        let _e89 = phi_864_;
        if _e89 {
            phi_868_ = false;
        } else {
            phi_868_ = _e87;
        }
        let _e91 = phi_868_;
        if !(_e91) {
            let _e94 = samples.member[(0u + _e53.first_primitive)].normal;
            let _e96 = samples.member[(0u + _e53.first_primitive)].position;
            if ((((_e94.x * (_e65.x - (_e96.x * _e65.w))) + (_e94.y * (_e65.y - (_e96.y * _e65.w)))) + (_e94.z * (_e65.z - (_e96.z * _e65.w)))) > 0f) {
                let _e120 = samples.member[(0u + _e53.first_primitive)].flags;
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e134 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e128.unnamed.visibility, false), _e128.unnamed_1);
                phi_912_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e134.unnamed, ((_e120 & 1u) == 0u));
            } else {
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e149 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e143.unnamed.visibility, false), _e143.unnamed_1);
                phi_912_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e149.unnamed, true);
            }
            let _e154 = phi_912_;
            phi_916_ = _e154;
        } else {
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e160.unnamed.visibility, false), _e160.unnamed_1);
            phi_916_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e166.unnamed, true);
        }
        let _e171 = phi_916_;
        if _e171.unnamed_1 {
            phi_1361_ = evaluate_Verdict(_e171.unnamed.visibility, _e171.unnamed.is_doubted);
        } else {
            let _e179 = samples.member[(0u + _e53.first_primitive)].position;
            let _e197 = ((((_e63.projection.row_w.x * _e179.x) + (_e63.projection.row_w.y * _e179.y)) + (_e63.projection.row_w.z * _e179.z)) + (_e63.projection.row_w.w * 1f));
            let _e211 = (((((_e63.projection.row_x.x * _e179.x) + (_e63.projection.row_x.y * _e179.y)) + (_e63.projection.row_x.z * _e179.z)) + (_e63.projection.row_x.w * 1f)) / _e197);
            let _e225 = (((((_e63.projection.row_y.x * _e179.x) + (_e63.projection.row_y.y * _e179.y)) + (_e63.projection.row_y.z * _e179.z)) + (_e63.projection.row_y.w * 1f)) / _e197);
            let _e238 = ((((_e63.projection.row_z.x * _e179.x) + (_e63.projection.row_z.y * _e179.y)) + (_e63.projection.row_z.z * _e179.z)) + (_e63.projection.row_z.w * 1f));
            if (_e197 > 0f) {
                if (_e211 >= 0f) {
                    phi_990_ = (_e211 <= 1f);
                } else {
                    phi_990_ = false;
                }
                let _e243 = phi_990_;
                if _e243 {
                    if (_e225 >= 0f) {
                        phi_999_ = (_e225 <= 1f);
                    } else {
                        phi_999_ = false;
                    }
                    let _e247 = phi_999_;
                    if _e247 {
                        if (_e238 >= 0f) {
                            phi_1008_ = (_e238 <= 1f);
                        } else {
                            phi_1008_ = false;
                        }
                        let _e251 = phi_1008_;
                        phi_1009_ = _e251;
                        phi_1010_ = false;
                    } else {
                        phi_1009_ = bool();
                        phi_1010_ = true;
                    }
                    let _e253 = phi_1009_;
                    let _e255 = phi_1010_;
                    phi_1011_ = _e253;
                    phi_1012_ = _e255;
                } else {
                    phi_1011_ = bool();
                    phi_1012_ = true;
                }
                let _e257 = phi_1011_;
                let _e259 = phi_1012_;
                phi_1013_ = _e257;
                phi_1014_ = _e259;
            } else {
                phi_1013_ = bool();
                phi_1014_ = true;
            }
            let _e261 = phi_1013_;
            let _e263 = phi_1014_;
            if _e263 {
                phi_1018_ = false;
            } else {
                phi_1018_ = _e261;
            }
            let _e265 = phi_1018_;
            if _e265 {
                if (0f > 0f) {
                    let _e268 = samples.member[(0u + _e53.first_primitive)].normal;
                    let _e270 = p.member.map_size;
                    let _e340 = ((abs(((((_e59.row_x.x * _e268.x) + (_e59.row_x.y * _e268.y)) + (_e59.row_x.z * _e268.z)) / (((_e59.row_x.x * _e59.row_x.x) + (_e59.row_x.y * _e59.row_x.y)) + (_e59.row_x.z * _e59.row_x.z)))) + abs(((((_e59.row_y.x * _e268.x) + (_e59.row_y.y * _e268.y)) + (_e59.row_y.z * _e268.z)) / (((_e59.row_y.x * _e59.row_y.x) + (_e59.row_y.y * _e59.row_y.y)) + (_e59.row_y.z * _e59.row_y.z))))) / (abs(((((_e59.row_z.x * _e268.x) + (_e59.row_z.y * _e268.y)) + (_e59.row_z.z * _e268.z)) / (((_e59.row_z.x * _e59.row_z.x) + (_e59.row_z.y * _e59.row_z.y)) + (_e59.row_z.z * _e59.row_z.z)))) * f32(_e270)));
                    if (_e340 < 0.002f) {
                        phi_1108_ = _e340;
                    } else {
                        phi_1108_ = 0.002f;
                    }
                    let _e343 = phi_1108_;
                    phi_1111_ = (_e238 - (0f * _e343));
                } else {
                    phi_1111_ = _e238;
                }
                let _e347 = phi_1111_;
                let _e349 = p.member.map_size;
                let _e350 = f32(_e349);
                let _e353 = ((_e211 * _e350) - 0.5f);
                let _e354 = ((_e225 * _e350) - 0.5f);
                if (_e353 > -8388608f) {
                    let _e366 = f32(select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < bitcast<f32>(3472883712u))), 2147483647i, (_e353 > bitcast<f32>(1325400063u))), (_e353 == _e353)));
                    if (_e366 > _e353) {
                        phi_1140_ = 1f;
                    } else {
                        phi_1140_ = 0f;
                    }
                    let _e369 = phi_1140_;
                    if (_e353 < 8388608f) {
                        phi_1145_ = (_e366 - _e369);
                        phi_1146_ = false;
                    } else {
                        phi_1145_ = f32();
                        phi_1146_ = true;
                    }
                    let _e372 = phi_1145_;
                    let _e374 = phi_1146_;
                    phi_1147_ = _e372;
                    phi_1148_ = _e374;
                } else {
                    phi_1147_ = f32();
                    phi_1148_ = true;
                }
                let _e376 = phi_1147_;
                let _e378 = phi_1148_;
                if _e378 {
                    phi_1152_ = _e353;
                } else {
                    phi_1152_ = _e376;
                }
                let _e380 = phi_1152_;
                if (_e354 > -8388608f) {
                    let _e392 = f32(select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < bitcast<f32>(3472883712u))), 2147483647i, (_e354 > bitcast<f32>(1325400063u))), (_e354 == _e354)));
                    if (_e392 > _e354) {
                        phi_1172_ = 1f;
                    } else {
                        phi_1172_ = 0f;
                    }
                    let _e395 = phi_1172_;
                    if (_e354 < 8388608f) {
                        phi_1177_ = (_e392 - _e395);
                        phi_1178_ = false;
                    } else {
                        phi_1177_ = f32();
                        phi_1178_ = true;
                    }
                    let _e398 = phi_1177_;
                    let _e400 = phi_1178_;
                    phi_1179_ = _e398;
                    phi_1180_ = _e400;
                } else {
                    phi_1179_ = f32();
                    phi_1180_ = true;
                }
                let _e402 = phi_1179_;
                let _e404 = phi_1180_;
                if _e404 {
                    phi_1184_ = _e354;
                } else {
                    phi_1184_ = _e402;
                }
                let _e406 = phi_1184_;
                let _e407 = (_e353 - _e380);
                let _e408 = (_e354 - _e406);
                let _e417 = select(0i, select(select(i32(_e380), i32(-2147483648), (_e380 < bitcast<f32>(3472883712u))), 2147483647i, (_e380 > bitcast<f32>(1325400063u))), (_e380 == _e380));
                let _e426 = select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406));
                let _e437 = p.member.test;
                let _e438 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e437);
                let _e440 = p.member.map_size;
                local = _e438;
                let _e442 = ((0u * _e440) * _e440);
                let _e444 = (bitcast<i32>(_e440) - 1i);
                if (_e417 > 0i) {
                    phi_1232_ = _e417;
                } else {
                    phi_1232_ = 0i;
                }
                let _e447 = phi_1232_;
                if (_e426 > 0i) {
                    phi_1237_ = _e426;
                } else {
                    phi_1237_ = 0i;
                }
                let _e450 = phi_1237_;
                if (_e447 < _e444) {
                    phi_1242_ = _e447;
                } else {
                    phi_1242_ = _e444;
                }
                let _e453 = phi_1242_;
                if (_e450 < _e444) {
                    phi_1247_ = _e450;
                } else {
                    phi_1247_ = _e444;
                }
                let _e456 = phi_1247_;
                let _e457 = bitcast<u32>(_e453);
                let _e459 = (_e417 + 1i);
                let _e460 = (_e426 + 1i);
                if (_e459 > 0i) {
                    phi_1256_ = _e459;
                } else {
                    phi_1256_ = 0i;
                }
                let _e463 = phi_1256_;
                if (_e460 > 0i) {
                    phi_1261_ = _e460;
                } else {
                    phi_1261_ = 0i;
                }
                let _e466 = phi_1261_;
                if (_e463 < _e444) {
                    phi_1266_ = _e463;
                } else {
                    phi_1266_ = _e444;
                }
                let _e469 = phi_1266_;
                if (_e466 < _e444) {
                    phi_1271_ = _e466;
                } else {
                    phi_1271_ = _e444;
                }
                let _e472 = phi_1271_;
                let _e473 = bitcast<u32>(_e469);
                let _e475 = (bitcast<u32>(_e456) * _e440);
                let _e476 = (bitcast<u32>(_e472) * _e440);
                let _e481 = ((_e475 + _e457) + _e442);
                let _e482 = ((_e475 + _e473) + _e442);
                let _e483 = ((_e476 + _e457) + _e442);
                let _e484 = ((_e476 + _e473) + _e442);
                if (_e481 < _e44) {
                } else {
                    return;
                }
                let _e488 = map.member[(0u + _e481)];
                if (_e482 < _e44) {
                } else {
                    return;
                }
                let _e492 = map.member[(0u + _e482)];
                if (_e483 < _e44) {
                } else {
                    return;
                }
                let _e496 = map.member[(0u + _e483)];
                if (_e484 < _e44) {
                } else {
                    return;
                }
                let _e500 = map.member[(0u + _e484)];
                let _e502 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e488, _e492, _e496, _e500), vec4<f32>(((1f - _e407) * (1f - _e408)), (_e407 * (1f - _e408)), ((1f - _e407) * _e408), (_e407 * _e408)), _e347);
                let _e504 = p.member.epsilon;
                if (_e502 <= _e504) {
                    phi_1322_ = true;
                } else {
                    phi_1322_ = (_e502 >= (1f - _e504));
                }
                let _e509 = phi_1322_;
                if ((bitcast<u32>(_e502) & 2147483647u) > 2139095040u) {
                    phi_1330_ = true;
                } else {
                    phi_1330_ = !(_e509);
                }
                let _e515 = phi_1330_;
                if _e515 {
                    if (_e502 > 0f) {
                        if (_e502 < 1f) {
                            phi_1342_ = false;
                        } else {
                            phi_1342_ = true;
                        }
                        let _e519 = phi_1342_;
                        phi_1343_ = _e519;
                    } else {
                        phi_1343_ = true;
                    }
                    let _e521 = phi_1343_;
                    if _e521 {
                        phi_1347_ = 0.5f;
                    } else {
                        phi_1347_ = _e502;
                    }
                    let _e523 = phi_1347_;
                    phi_1355_ = evaluate_Verdict(_e523, true);
                } else {
                    if (_e502 > 0.5f) {
                        phi_1353_ = 1f;
                    } else {
                        phi_1353_ = 0f;
                    }
                    let _e527 = phi_1353_;
                    phi_1355_ = evaluate_Verdict(_e527, false);
                }
                let _e530 = phi_1355_;
                phi_1360_ = evaluate_Verdict(_e530.visibility, _e530.is_doubted);
            } else {
                phi_1360_ = evaluate_Verdict(0.5f, true);
            }
            let _e536 = phi_1360_;
            phi_1361_ = _e536;
        }
        let _e538 = phi_1361_;
        if (_e53.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e53.first_primitive)] = _e538.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
