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
    var phi_130_: lt_bvh_traverse_Tree;
    var phi_131_: bool;
    var phi_132_: lt_bvh_traverse_Tree;
    var phi_133_: bool;
    var phi_138_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_130_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_131_ = false;
        } else {
            phi_130_ = lt_bvh_traverse_Tree();
            phi_131_ = true;
        }
        let _e49 = phi_130_;
        let _e51 = phi_131_;
        phi_132_ = _e49;
        phi_133_ = _e51;
    } else {
        phi_132_ = lt_bvh_traverse_Tree();
        phi_133_ = true;
    }
    let _e53 = phi_132_;
    let _e55 = phi_133_;
    if _e55 {
        phi_138_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_138_ = _e53;
    }
    let _e60 = phi_138_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_165_: f32;
    var phi_166_: f32;
    var phi_167_: f32;
    var phi_184_: f32;
    var phi_185_: f32;
    var phi_186_: f32;
    var phi_202_: f32;
    var phi_203_: f32;
    var phi_204_: f32;
    var phi_220_: f32;
    var phi_221_: f32;
    var phi_222_: f32;
    var phi_238_: f32;
    var phi_239_: f32;
    var phi_240_: f32;
    var phi_275_: bool;
    var phi_276_: bool;
    var phi_277_: bool;
    var phi_278_: bool;
    var phi_279_: bool;
    var phi_280_: bool;
    var phi_284_: bool;
    var phi_595_: f32;
    var phi_596_: f32;
    var phi_597_: f32;
    var phi_614_: f32;
    var phi_615_: f32;
    var phi_616_: f32;
    var phi_633_: f32;
    var phi_634_: f32;
    var phi_635_: f32;
    var phi_652_: f32;
    var phi_653_: f32;
    var phi_654_: f32;
    var phi_677_: f32;
    var phi_678_: f32;
    var phi_679_: f32;
    var phi_690_: f32;
    var phi_705_: f32;
    var phi_707_: lt_bvh_slab_Span;
    var phi_765_: f32;
    var phi_766_: f32;
    var phi_767_: f32;
    var phi_768_: f32;
    var phi_769_: f32;
    var phi_770_: bool;
    var phi_774_: f32;
    var phi_789_: f32;
    var phi_790_: f32;
    var phi_791_: f32;
    var phi_792_: f32;
    var phi_793_: f32;
    var phi_794_: f32;
    var phi_795_: f32;
    var phi_796_: bool;
    var phi_797_: f32;
    var phi_798_: f32;
    var phi_799_: bool;
    var phi_803_: f32;

    let _e40 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_167_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_166_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_165_ = 1f;
            } else {
                phi_165_ = param_7;
            }
            let _e47 = phi_165_;
            phi_166_ = _e47;
        }
        let _e49 = phi_166_;
        phi_167_ = _e49;
    }
    let _e51 = phi_167_;
    let _e52 = (_e51 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_186_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_185_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_184_ = 1f;
            } else {
                phi_184_ = param_5.x;
            }
            let _e60 = phi_184_;
            phi_185_ = _e60;
        }
        let _e62 = phi_185_;
        phi_186_ = _e62;
    }
    let _e64 = phi_186_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_204_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_203_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_202_ = 1f;
            } else {
                phi_202_ = param_5.y;
            }
            let _e72 = phi_202_;
            phi_203_ = _e72;
        }
        let _e74 = phi_203_;
        phi_204_ = _e74;
    }
    let _e76 = phi_204_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_222_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_221_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_220_ = 1f;
            } else {
                phi_220_ = param_5.z;
            }
            let _e84 = phi_220_;
            phi_221_ = _e84;
        }
        let _e86 = phi_221_;
        phi_222_ = _e86;
    }
    let _e88 = phi_222_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_240_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_239_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_238_ = 1f;
            } else {
                phi_238_ = param_5.w;
            }
            let _e96 = phi_238_;
            phi_239_ = _e96;
        }
        let _e98 = phi_239_;
        phi_240_ = _e98;
    }
    let _e100 = phi_240_;
    let _e101 = (_e64 - _e52);
    let _e102 = (_e76 - _e52);
    let _e103 = (_e88 - _e52);
    let _e104 = (_e100 - _e52);
    let _e115 = ((((_e101 * param_6.x) + (_e102 * param_6.y)) + (_e103 * param_6.z)) + (_e104 * param_6.w));
    if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
        phi_797_ = _e115;
        phi_798_ = f32();
        phi_799_ = true;
    } else {
        if (_e101 >= 0f) {
            if (_e102 >= 0f) {
                if (_e103 >= 0f) {
                    phi_275_ = (_e104 >= 0f);
                    phi_276_ = false;
                } else {
                    phi_275_ = bool();
                    phi_276_ = true;
                }
                let _e124 = phi_275_;
                let _e126 = phi_276_;
                phi_277_ = _e124;
                phi_278_ = _e126;
            } else {
                phi_277_ = bool();
                phi_278_ = true;
            }
            let _e128 = phi_277_;
            let _e130 = phi_278_;
            phi_279_ = _e128;
            phi_280_ = _e130;
        } else {
            phi_279_ = bool();
            phi_280_ = true;
        }
        let _e132 = phi_279_;
        let _e134 = phi_280_;
        if _e134 {
            phi_284_ = false;
        } else {
            phi_284_ = _e132;
        }
        let _e136 = phi_284_;
        if _e136 {
            phi_794_ = 1f;
            phi_795_ = f32();
            phi_796_ = true;
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
                    phi_597_ = _e101;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_596_ = 0f;
                    } else {
                        if (_e101 < 0f) {
                            phi_595_ = 0f;
                        } else {
                            phi_595_ = 1f;
                        }
                        let _e433 = phi_595_;
                        phi_596_ = _e433;
                    }
                    let _e435 = phi_596_;
                    phi_597_ = _e435;
                }
                let _e437 = phi_597_;
                if ((bitcast<u32>(_e102) & 2147483647u) > 2139095040u) {
                    phi_616_ = _e102;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_615_ = 0f;
                    } else {
                        if (_e102 < 0f) {
                            phi_614_ = 0f;
                        } else {
                            phi_614_ = 1f;
                        }
                        let _e446 = phi_614_;
                        phi_615_ = _e446;
                    }
                    let _e448 = phi_615_;
                    phi_616_ = _e448;
                }
                let _e450 = phi_616_;
                if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
                    phi_635_ = _e103;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_634_ = 0f;
                    } else {
                        if (_e103 < 0f) {
                            phi_633_ = 0f;
                        } else {
                            phi_633_ = 1f;
                        }
                        let _e459 = phi_633_;
                        phi_634_ = _e459;
                    }
                    let _e461 = phi_634_;
                    phi_635_ = _e461;
                }
                let _e463 = phi_635_;
                if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
                    phi_654_ = _e104;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_653_ = 0f;
                    } else {
                        if (_e104 < 0f) {
                            phi_652_ = 0f;
                        } else {
                            phi_652_ = 1f;
                        }
                        let _e472 = phi_652_;
                        phi_653_ = _e472;
                    }
                    let _e474 = phi_653_;
                    phi_654_ = _e474;
                }
                let _e476 = phi_654_;
                let _e484 = (((((_e437 * _e140) + (_e450 * _e142)) + (_e463 * _e144)) + (_e476 * _e146)) + _e137);
                if ((bitcast<u32>(_e484) & 2147483647u) > 2139095040u) {
                    phi_679_ = _e484;
                } else {
                    if (_e484 < 0f) {
                        phi_678_ = 0f;
                    } else {
                        if (_e484 > 1f) {
                            phi_677_ = 1f;
                        } else {
                            phi_677_ = _e484;
                        }
                        let _e491 = phi_677_;
                        phi_678_ = _e491;
                    }
                    let _e493 = phi_678_;
                    phi_679_ = _e493;
                }
                let _e495 = phi_679_;
                phi_792_ = _e495;
                phi_793_ = f32();
            } else {
                let _e497 = ((0.5f * -(((((((((_e201 * (_e101 + _e102)) + (_e205 * (_e101 + _e103))) + (_e229 * (_e101 + _e147))) + (_e241 * (_e101 + _e148))) + ((((_e202 * (_e102 + _e103)) + (_e206 * (_e102 + _e104))) + (_e230 * (_e102 + _e147))) + (_e242 * (_e102 + _e148)))) + ((((_e203 * (_e103 + _e104)) + (_e207 * (_e103 + _e101))) + (_e231 * (_e103 + _e147))) + (_e243 * (_e103 + _e148)))) + ((((_e204 * (_e104 + _e101)) + (_e208 * (_e104 + _e102))) + (_e232 * (_e104 + _e147))) + (_e244 * (_e104 + _e148)))) + (_e415 * (_e147 + _e148))))) / _e418);
                let _e498 = ((((((((_e201 + _e205) + _e229) + _e241) + (((_e202 + _e206) + _e230) + _e242)) + (((_e203 + _e207) + _e231) + _e243)) + (((_e204 + _e208) + _e232) + _e244)) + _e415) / _e418);
                let _e500 = ((_e497 * _e497) - _e498);
                if (_e500 > 0f) {
                    phi_690_ = sqrt(_e500);
                } else {
                    phi_690_ = 0f;
                }
                let _e504 = phi_690_;
                if (_e497 > 0f) {
                    let _e507 = (-(_e497) - _e504);
                    phi_707_ = lt_bvh_slab_Span(_e507, (_e498 / _e507));
                } else {
                    let _e510 = (_e504 - _e497);
                    if (_e510 > 0f) {
                        phi_705_ = (_e498 / _e510);
                    } else {
                        phi_705_ = 0f;
                    }
                    let _e514 = phi_705_;
                    phi_707_ = lt_bvh_slab_Span(_e514, _e510);
                }
                let _e517 = phi_707_;
                if (_e517.near >= 0f) {
                    phi_768_ = 1f;
                    phi_769_ = f32();
                    phi_770_ = true;
                } else {
                    let _e521 = (_e517.far <= 0f);
                    if _e521 {
                        phi_766_ = (_e412 / _e418);
                        phi_767_ = f32();
                    } else {
                        let _e532 = (((((_e140 * _e101) + (_e142 * _e102)) + (_e144 * _e103)) + (_e146 * _e104)) + (_e137 * (_e147 + _e148)));
                        let _e548 = (((((_e140 * (_e101 * _e101)) + (_e142 * (_e102 * _e102))) + (_e144 * (_e103 * _e103))) + (_e146 * (_e104 * _e104))) + (_e137 * ((_e147 * _e147) + (_e148 * _e148))));
                        if (-(_e517.near) <= _e517.far) {
                            phi_765_ = (1f - (((_e517.near * _e517.near) * ((_e517.far * _e548) - _e532)) / (_e517.far - _e517.near)));
                        } else {
                            phi_765_ = ((_e412 / _e418) + (((_e517.far * _e517.far) * (_e532 - (_e517.near * _e548))) / (_e517.far - _e517.near)));
                        }
                        let _e567 = phi_765_;
                        phi_766_ = f32();
                        phi_767_ = _e567;
                    }
                    let _e569 = phi_766_;
                    let _e571 = phi_767_;
                    phi_768_ = _e569;
                    phi_769_ = _e571;
                    phi_770_ = _e521;
                }
                let _e573 = phi_768_;
                let _e575 = phi_769_;
                let _e577 = phi_770_;
                if _e577 {
                    phi_774_ = _e573;
                } else {
                    phi_774_ = _e575;
                }
                let _e579 = phi_774_;
                if ((bitcast<u32>(_e579) & 2147483647u) > 2139095040u) {
                    phi_791_ = _e579;
                } else {
                    if (_e579 < 0f) {
                        phi_790_ = 0f;
                    } else {
                        if (_e579 > 1f) {
                            phi_789_ = 1f;
                        } else {
                            phi_789_ = _e579;
                        }
                        let _e586 = phi_789_;
                        phi_790_ = _e586;
                    }
                    let _e588 = phi_790_;
                    phi_791_ = _e588;
                }
                let _e590 = phi_791_;
                phi_792_ = f32();
                phi_793_ = _e590;
            }
            let _e592 = phi_792_;
            let _e594 = phi_793_;
            phi_794_ = _e592;
            phi_795_ = _e594;
            phi_796_ = _e424;
        }
        let _e596 = phi_794_;
        let _e598 = phi_795_;
        let _e600 = phi_796_;
        phi_797_ = _e596;
        phi_798_ = _e598;
        phi_799_ = _e600;
    }
    let _e602 = phi_797_;
    let _e604 = phi_798_;
    let _e606 = phi_799_;
    if _e606 {
        phi_803_ = _e602;
    } else {
        phi_803_ = _e604;
    }
    let _e608 = phi_803_;
    return _e608;
}

fn function_() {
    var local: f32;
    var phi_857_: bool;
    var phi_858_: bool;
    var phi_859_: bool;
    var phi_860_: bool;
    var phi_864_: bool;
    var phi_908_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_912_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_989_: bool;
    var phi_998_: bool;
    var phi_1007_: bool;
    var phi_1008_: bool;
    var phi_1009_: bool;
    var phi_1010_: bool;
    var phi_1011_: bool;
    var phi_1012_: bool;
    var phi_1013_: bool;
    var phi_1017_: bool;
    var phi_1111_: f32;
    var phi_1114_: f32;
    var phi_1143_: f32;
    var phi_1148_: f32;
    var phi_1149_: bool;
    var phi_1150_: f32;
    var phi_1151_: bool;
    var phi_1155_: f32;
    var phi_1175_: f32;
    var phi_1180_: f32;
    var phi_1181_: bool;
    var phi_1182_: f32;
    var phi_1183_: bool;
    var phi_1187_: f32;
    var phi_1233_: i32;
    var phi_1238_: i32;
    var phi_1243_: i32;
    var phi_1248_: i32;
    var phi_1257_: i32;
    var phi_1262_: i32;
    var phi_1267_: i32;
    var phi_1272_: i32;
    var phi_1319_: bool;
    var phi_1327_: bool;
    var phi_1339_: bool;
    var phi_1340_: bool;
    var phi_1344_: f32;
    var phi_1350_: f32;
    var phi_1352_: evaluate_Verdict;
    var phi_1357_: evaluate_Verdict;
    var phi_1358_: evaluate_Verdict;

    let _e37 = id_1;
    let _e44 = arrayLength((&map.member));
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e37, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        if (_e53.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e62 = p.member.light;
        let _e65 = samples.member[(0u + _e53.first_primitive)].normal[0u];
        let _e67 = global[0u];
        if (_e65 == _e67) {
            let _e70 = samples.member[(0u + _e53.first_primitive)].normal[1u];
            let _e72 = global[1u];
            if (_e70 == _e72) {
                let _e75 = samples.member[(0u + _e53.first_primitive)].normal[2u];
                let _e77 = global[2u];
                phi_857_ = (_e75 == _e77);
                phi_858_ = false;
            } else {
                phi_857_ = bool();
                phi_858_ = true;
            }
            let _e80 = phi_857_;
            let _e82 = phi_858_;
            phi_859_ = _e80;
            phi_860_ = _e82;
        } else {
            phi_859_ = bool();
            phi_860_ = true;
        }
        let _e84 = phi_859_;
        let _e86 = phi_860_;
        if _e86 {
            phi_864_ = false;
        } else {
            phi_864_ = _e84;
        }
        let _e88 = phi_864_;
        if !(_e88) {
            let _e91 = samples.member[(0u + _e53.first_primitive)].normal;
            let _e93 = samples.member[(0u + _e53.first_primitive)].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[(0u + _e53.first_primitive)].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_908_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_908_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_908_;
            phi_912_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_912_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_912_;
        if _e168.unnamed_1 {
            phi_1358_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
        } else {
            let _e176 = samples.member[(0u + _e53.first_primitive)].position;
            let _e182 = p.member.projection.row_w;
            let _e193 = ((((_e182.x * _e176.x) + (_e182.y * _e176.y)) + (_e182.z * _e176.z)) + (_e182.w * 1f));
            let _e195 = p.member.projection.row_x;
            let _e207 = (((((_e195.x * _e176.x) + (_e195.y * _e176.y)) + (_e195.z * _e176.z)) + (_e195.w * 1f)) / _e193);
            let _e209 = p.member.projection.row_y;
            let _e221 = (((((_e209.x * _e176.x) + (_e209.y * _e176.y)) + (_e209.z * _e176.z)) + (_e209.w * 1f)) / _e193);
            let _e223 = p.member.projection.row_z;
            let _e234 = ((((_e223.x * _e176.x) + (_e223.y * _e176.y)) + (_e223.z * _e176.z)) + (_e223.w * 1f));
            if (_e193 > 0f) {
                if (_e207 >= 0f) {
                    phi_989_ = (_e207 <= 1f);
                } else {
                    phi_989_ = false;
                }
                let _e239 = phi_989_;
                if _e239 {
                    if (_e221 >= 0f) {
                        phi_998_ = (_e221 <= 1f);
                    } else {
                        phi_998_ = false;
                    }
                    let _e243 = phi_998_;
                    if _e243 {
                        if (_e234 >= 0f) {
                            phi_1007_ = (_e234 <= 1f);
                        } else {
                            phi_1007_ = false;
                        }
                        let _e247 = phi_1007_;
                        phi_1008_ = _e247;
                        phi_1009_ = false;
                    } else {
                        phi_1008_ = bool();
                        phi_1009_ = true;
                    }
                    let _e249 = phi_1008_;
                    let _e251 = phi_1009_;
                    phi_1010_ = _e249;
                    phi_1011_ = _e251;
                } else {
                    phi_1010_ = bool();
                    phi_1011_ = true;
                }
                let _e253 = phi_1010_;
                let _e255 = phi_1011_;
                phi_1012_ = _e253;
                phi_1013_ = _e255;
            } else {
                phi_1012_ = bool();
                phi_1013_ = true;
            }
            let _e257 = phi_1012_;
            let _e259 = phi_1013_;
            if _e259 {
                phi_1017_ = false;
            } else {
                phi_1017_ = _e257;
            }
            let _e261 = phi_1017_;
            if _e261 {
                if (0f > 0f) {
                    let _e264 = samples.member[(0u + _e53.first_primitive)].normal;
                    let _e266 = p.member.map_size;
                    let _e269 = p.member.projection.row_x;
                    let _e291 = p.member.projection.row_y;
                    let _e313 = p.member.projection.row_z;
                    let _e340 = ((abs(((((_e269.x * _e264.x) + (_e269.y * _e264.y)) + (_e269.z * _e264.z)) / (((_e269.x * _e269.x) + (_e269.y * _e269.y)) + (_e269.z * _e269.z)))) + abs(((((_e291.x * _e264.x) + (_e291.y * _e264.y)) + (_e291.z * _e264.z)) / (((_e291.x * _e291.x) + (_e291.y * _e291.y)) + (_e291.z * _e291.z))))) / (abs(((((_e313.x * _e264.x) + (_e313.y * _e264.y)) + (_e313.z * _e264.z)) / (((_e313.x * _e313.x) + (_e313.y * _e313.y)) + (_e313.z * _e313.z)))) * f32(_e266)));
                    if (_e340 < 0.002f) {
                        phi_1111_ = _e340;
                    } else {
                        phi_1111_ = 0.002f;
                    }
                    let _e343 = phi_1111_;
                    phi_1114_ = (_e234 - (0f * _e343));
                } else {
                    phi_1114_ = _e234;
                }
                let _e347 = phi_1114_;
                let _e349 = p.member.map_size;
                let _e350 = f32(_e349);
                let _e353 = ((_e207 * _e350) - 0.5f);
                let _e354 = ((_e221 * _e350) - 0.5f);
                if (_e353 > -8388608f) {
                    let _e366 = f32(select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < bitcast<f32>(3472883712u))), 2147483647i, (_e353 > bitcast<f32>(1325400063u))), (_e353 == _e353)));
                    if (_e366 > _e353) {
                        phi_1143_ = 1f;
                    } else {
                        phi_1143_ = 0f;
                    }
                    let _e369 = phi_1143_;
                    if (_e353 < 8388608f) {
                        phi_1148_ = (_e366 - _e369);
                        phi_1149_ = false;
                    } else {
                        phi_1148_ = f32();
                        phi_1149_ = true;
                    }
                    let _e372 = phi_1148_;
                    let _e374 = phi_1149_;
                    phi_1150_ = _e372;
                    phi_1151_ = _e374;
                } else {
                    phi_1150_ = f32();
                    phi_1151_ = true;
                }
                let _e376 = phi_1150_;
                let _e378 = phi_1151_;
                if _e378 {
                    phi_1155_ = _e353;
                } else {
                    phi_1155_ = _e376;
                }
                let _e380 = phi_1155_;
                if (_e354 > -8388608f) {
                    let _e392 = f32(select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < bitcast<f32>(3472883712u))), 2147483647i, (_e354 > bitcast<f32>(1325400063u))), (_e354 == _e354)));
                    if (_e392 > _e354) {
                        phi_1175_ = 1f;
                    } else {
                        phi_1175_ = 0f;
                    }
                    let _e395 = phi_1175_;
                    if (_e354 < 8388608f) {
                        phi_1180_ = (_e392 - _e395);
                        phi_1181_ = false;
                    } else {
                        phi_1180_ = f32();
                        phi_1181_ = true;
                    }
                    let _e398 = phi_1180_;
                    let _e400 = phi_1181_;
                    phi_1182_ = _e398;
                    phi_1183_ = _e400;
                } else {
                    phi_1182_ = f32();
                    phi_1183_ = true;
                }
                let _e402 = phi_1182_;
                let _e404 = phi_1183_;
                if _e404 {
                    phi_1187_ = _e354;
                } else {
                    phi_1187_ = _e402;
                }
                let _e406 = phi_1187_;
                let _e407 = (_e353 - _e380);
                let _e408 = (_e354 - _e406);
                let _e417 = select(0i, select(select(i32(_e380), i32(-2147483648), (_e380 < bitcast<f32>(3472883712u))), 2147483647i, (_e380 > bitcast<f32>(1325400063u))), (_e380 == _e380));
                let _e426 = select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406));
                let _e437 = p.member.test;
                let _e438 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e437);
                let _e440 = p.member.map_size;
                local = _e438;
                let _e442 = (bitcast<i32>(_e440) - 1i);
                if (_e417 > 0i) {
                    phi_1233_ = _e417;
                } else {
                    phi_1233_ = 0i;
                }
                let _e445 = phi_1233_;
                if (_e426 > 0i) {
                    phi_1238_ = _e426;
                } else {
                    phi_1238_ = 0i;
                }
                let _e448 = phi_1238_;
                if (_e445 < _e442) {
                    phi_1243_ = _e445;
                } else {
                    phi_1243_ = _e442;
                }
                let _e451 = phi_1243_;
                if (_e448 < _e442) {
                    phi_1248_ = _e448;
                } else {
                    phi_1248_ = _e442;
                }
                let _e454 = phi_1248_;
                let _e455 = bitcast<u32>(_e451);
                let _e457 = (_e417 + 1i);
                let _e458 = (_e426 + 1i);
                if (_e457 > 0i) {
                    phi_1257_ = _e457;
                } else {
                    phi_1257_ = 0i;
                }
                let _e461 = phi_1257_;
                if (_e458 > 0i) {
                    phi_1262_ = _e458;
                } else {
                    phi_1262_ = 0i;
                }
                let _e464 = phi_1262_;
                if (_e461 < _e442) {
                    phi_1267_ = _e461;
                } else {
                    phi_1267_ = _e442;
                }
                let _e467 = phi_1267_;
                if (_e464 < _e442) {
                    phi_1272_ = _e464;
                } else {
                    phi_1272_ = _e442;
                }
                let _e470 = phi_1272_;
                let _e471 = bitcast<u32>(_e467);
                let _e473 = (bitcast<u32>(_e454) * _e440);
                let _e474 = (bitcast<u32>(_e470) * _e440);
                let _e475 = (_e473 + _e455);
                let _e476 = (_e473 + _e471);
                let _e477 = (_e474 + _e455);
                let _e478 = (_e474 + _e471);
                if (_e475 < _e44) {
                } else {
                    return;
                }
                let _e482 = map.member[(0u + _e475)];
                if (_e476 < _e44) {
                } else {
                    return;
                }
                let _e486 = map.member[(0u + _e476)];
                if (_e477 < _e44) {
                } else {
                    return;
                }
                let _e490 = map.member[(0u + _e477)];
                if (_e478 < _e44) {
                } else {
                    return;
                }
                let _e494 = map.member[(0u + _e478)];
                let _e496 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e482, _e486, _e490, _e494), vec4<f32>(((1f - _e407) * (1f - _e408)), (_e407 * (1f - _e408)), ((1f - _e407) * _e408), (_e407 * _e408)), _e347);
                let _e498 = p.member.epsilon;
                if (_e496 <= _e498) {
                    phi_1319_ = true;
                } else {
                    phi_1319_ = (_e496 >= (1f - _e498));
                }
                let _e503 = phi_1319_;
                if ((bitcast<u32>(_e496) & 2147483647u) > 2139095040u) {
                    phi_1327_ = true;
                } else {
                    phi_1327_ = !(_e503);
                }
                let _e509 = phi_1327_;
                if _e509 {
                    if (_e496 > 0f) {
                        if (_e496 < 1f) {
                            phi_1339_ = false;
                        } else {
                            phi_1339_ = true;
                        }
                        let _e513 = phi_1339_;
                        phi_1340_ = _e513;
                    } else {
                        phi_1340_ = true;
                    }
                    let _e515 = phi_1340_;
                    if _e515 {
                        phi_1344_ = 0.5f;
                    } else {
                        phi_1344_ = _e496;
                    }
                    let _e517 = phi_1344_;
                    phi_1352_ = evaluate_Verdict(_e517, true);
                } else {
                    if (_e496 > 0.5f) {
                        phi_1350_ = 1f;
                    } else {
                        phi_1350_ = 0f;
                    }
                    let _e521 = phi_1350_;
                    phi_1352_ = evaluate_Verdict(_e521, false);
                }
                let _e524 = phi_1352_;
                phi_1357_ = evaluate_Verdict(_e524.visibility, _e524.is_doubted);
            } else {
                phi_1357_ = evaluate_Verdict(0.5f, true);
            }
            let _e530 = phi_1357_;
            phi_1358_ = _e530;
        }
        let _e532 = phi_1358_;
        if (_e53.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e53.first_primitive)] = _e532.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
