struct type_8 {
    member: array<f32>,
}

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
}

struct type_18 {
    member: array<vec4<f32>>,
}

struct abi_FilterParams {
    test: vec4<f32>,
    map_size: u32,
    sigma: f32,
    pad: vec2<u32>,
}

struct type_22 {
    member: abi_FilterParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_22;
@group(0) @binding(1) 
var<storage> depths: type_8;
@group(0) @binding(2) 
var<storage, read_write> rows: type_18;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_113_: lt_mask_LightPlace;
    var phi_114_: bool;
    var phi_115_: lt_mask_LightPlace;
    var phi_116_: bool;
    var phi_121_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_113_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_114_ = false;
        } else {
            phi_113_ = lt_mask_LightPlace();
            phi_114_ = true;
        }
        let _e56 = phi_113_;
        let _e58 = phi_114_;
        phi_115_ = _e56;
        phi_116_ = _e58;
    } else {
        phi_115_ = lt_mask_LightPlace();
        phi_116_ = true;
    }
    let _e60 = phi_115_;
    let _e62 = phi_116_;
    if _e62 {
        phi_121_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_121_ = _e60;
    }
    let _e67 = phi_121_;
    return lt_mask_LightPlace(_e67.word, _e67.shift);
}

fn _lt_math_esm_Esm_clamped_exponent(param_3: ptr<function, f32>) -> f32 {
    var phi_457_: bool;
    var phi_461_: f32;

    let _e44 = (*param_3);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_457_ = true;
    } else {
        let _e48 = (84f < _e44);
        if _e48 {
        }
        phi_457_ = _e48;
    }
    let _e50 = phi_457_;
    if _e50 {
        phi_461_ = 84f;
    } else {
        phi_461_ = _e44;
    }
    let _e52 = phi_461_;
    return _e52;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, f32>, param_5: f32) -> vec4<f32> {
    var phi_350_: f32;
    var phi_351_: f32;
    var phi_352_: f32;
    var phi_365_: f32;
    var phi_370_: f32;
    var phi_392_: f32;
    var phi_397_: f32;
    var phi_398_: bool;
    var phi_399_: f32;
    var phi_400_: bool;
    var phi_404_: f32;
    var phi_442_: f32;

    let _e45 = _lt_math_esm_Esm_clamped_exponent(param_4);
    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_352_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_351_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_350_ = 1f;
            } else {
                phi_350_ = param_5;
            }
            let _e52 = phi_350_;
            phi_351_ = _e52;
        }
        let _e54 = phi_351_;
        phi_352_ = _e54;
    }
    let _e56 = phi_352_;
    let _e58 = (_e45 * (_e56 - 1f));
    if ((bitcast<u32>(_e58) & 2147483647u) > 2139095040u) {
        phi_442_ = _e58;
    } else {
        if (_e58 < -87f) {
            phi_365_ = -87f;
        } else {
            phi_365_ = _e58;
        }
        let _e64 = phi_365_;
        if (_e64 > 88f) {
            phi_370_ = 88f;
        } else {
            phi_370_ = _e64;
        }
        let _e67 = phi_370_;
        let _e69 = ((_e67 * 1.442695f) + 0.5f);
        if (_e69 > -8388608f) {
            let _e81 = f32(select(0i, select(select(i32(_e69), i32(-2147483648), (_e69 < bitcast<f32>(3472883712u))), 2147483647i, (_e69 > bitcast<f32>(1325400063u))), (_e69 == _e69)));
            if (_e81 > _e69) {
                phi_392_ = 1f;
            } else {
                phi_392_ = 0f;
            }
            let _e84 = phi_392_;
            if (_e69 < 8388608f) {
                phi_397_ = (_e81 - _e84);
                phi_398_ = false;
            } else {
                phi_397_ = f32();
                phi_398_ = true;
            }
            let _e87 = phi_397_;
            let _e89 = phi_398_;
            phi_399_ = _e87;
            phi_400_ = _e89;
        } else {
            phi_399_ = f32();
            phi_400_ = true;
        }
        let _e91 = phi_399_;
        let _e93 = phi_400_;
        if _e93 {
            phi_404_ = _e69;
        } else {
            phi_404_ = _e91;
        }
        let _e95 = phi_404_;
        let _e99 = ((_e67 - (_e95 * 0.69314575f)) - (_e95 * 0.0000014286068f));
        phi_442_ = ((((((((((((((((1f / 5040f) * _e99) + (1f / 720f)) * _e99) + (1f / 120f)) * _e99) + (1f / 24f)) * _e99) + (1f / 6f)) * _e99) + 0.5f) * _e99) + 1f) * _e99) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e95), i32(-2147483648), (_e95 < bitcast<f32>(3472883712u))), 2147483647i, (_e95 > bitcast<f32>(1325400063u))), (_e95 == _e95)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e135 = phi_442_;
    return vec4<f32>(_e135, 0f, 0f, 0f);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_6: vec4<f32>) -> f32 {
    return param_6.x;
}

fn function_() {
    var local: f32;
    var phi_149_: vec4<f32>;
    var phi_152_: i32;
    var phi_154_: f32;
    var phi_182_: f32;
    var phi_187_: f32;
    var phi_209_: f32;
    var phi_214_: f32;
    var phi_215_: bool;
    var phi_216_: f32;
    var phi_217_: bool;
    var phi_221_: f32;
    var phi_259_: f32;
    var phi_264_: f32;
    var phi_265_: f32;
    var phi_287_: i32;
    var phi_288_: i32;
    var phi_150_: vec4<f32>;
    var phi_153_: i32;
    var phi_155_: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var local_5: vec4<f32>;

    let _e44 = id_1;
    let _e53 = p.member.map_size;
    let _e54 = lt_shaders_entry_pixel_index(_e44, _e53, _e53);
    if (bitcast<i32>(_e54.word) != 0i) {
        let _e62 = p.member.test;
        let _e63 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e62);
        local = _e63;
        phi_149_ = vec4<f32>(0f, 0f, 0f, 0f);
        phi_152_ = -2i;
        phi_154_ = 0f;
        loop {
            let _e65 = phi_149_;
            let _e67 = phi_152_;
            let _e69 = phi_154_;
            local_1 = _e69;
            local_2 = _e69;
            local_3 = _e69;
            local_4 = _e69;
            local_5 = _e65;
            let _e70 = (_e67 <= 2i);
            if _e70 {
                let _e72 = p.member.sigma;
                if (_e72 > 0f) {
                    let _e75 = (f32(_e67) / _e72);
                    let _e77 = ((-0.5f * _e75) * _e75);
                    if ((bitcast<u32>(_e77) & 2147483647u) > 2139095040u) {
                        phi_259_ = _e77;
                    } else {
                        if (_e77 < -87f) {
                            phi_182_ = -87f;
                        } else {
                            phi_182_ = _e77;
                        }
                        let _e83 = phi_182_;
                        if (_e83 > 88f) {
                            phi_187_ = 88f;
                        } else {
                            phi_187_ = _e83;
                        }
                        let _e86 = phi_187_;
                        let _e88 = ((_e86 * 1.442695f) + 0.5f);
                        if (_e88 > -8388608f) {
                            let _e100 = f32(select(0i, select(select(i32(_e88), i32(-2147483648), (_e88 < bitcast<f32>(3472883712u))), 2147483647i, (_e88 > bitcast<f32>(1325400063u))), (_e88 == _e88)));
                            if (_e100 > _e88) {
                                phi_209_ = 1f;
                            } else {
                                phi_209_ = 0f;
                            }
                            let _e103 = phi_209_;
                            if (_e88 < 8388608f) {
                                phi_214_ = (_e100 - _e103);
                                phi_215_ = false;
                            } else {
                                phi_214_ = f32();
                                phi_215_ = true;
                            }
                            let _e106 = phi_214_;
                            let _e108 = phi_215_;
                            phi_216_ = _e106;
                            phi_217_ = _e108;
                        } else {
                            phi_216_ = f32();
                            phi_217_ = true;
                        }
                        let _e110 = phi_216_;
                        let _e112 = phi_217_;
                        if _e112 {
                            phi_221_ = _e88;
                        } else {
                            phi_221_ = _e110;
                        }
                        let _e114 = phi_221_;
                        let _e118 = ((_e86 - (_e114 * 0.69314575f)) - (_e114 * 0.0000014286068f));
                        phi_259_ = ((((((((((((((((1f / 5040f) * _e118) + (1f / 720f)) * _e118) + (1f / 120f)) * _e118) + (1f / 24f)) * _e118) + (1f / 6f)) * _e118) + 0.5f) * _e118) + 1f) * _e118) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)) + 127i)) << bitcast<u32>(23i))));
                    }
                    let _e154 = phi_259_;
                    phi_265_ = _e154;
                } else {
                    if (_e67 == 0i) {
                        phi_264_ = 1f;
                    } else {
                        phi_264_ = 0f;
                    }
                    let _e157 = phi_264_;
                    phi_265_ = _e157;
                }
                let _e159 = phi_265_;
                let _e161 = p.member.map_size;
                let _e164 = p.member.map_size;
                let _e166 = (bitcast<i32>(_e44.x) + _e67);
                let _e168 = (bitcast<i32>(_e164) - 1i);
                if (0i <= _e168) {
                } else {
                    return;
                }
                if (_e166 < 0i) {
                    phi_288_ = 0i;
                } else {
                    if (_e166 > _e168) {
                        phi_287_ = _e168;
                    } else {
                        phi_287_ = _e166;
                    }
                    let _e173 = phi_287_;
                    phi_288_ = _e173;
                }
                let _e175 = phi_288_;
                let _e177 = ((_e44.y * _e161) + bitcast<u32>(_e175));
                if (_e177 < arrayLength((&depths.member))) {
                } else {
                    return;
                }
                let _e181 = depths.member[(0u + _e177)];
                let _e182 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector((&local), _e181);
                let _e192 = (_e65.x + (_e182.x * _e159));
                let _e197 = vec4<f32>(_e192, _e65.y, _e65.z, _e65.w);
                let _e199 = (_e197.y + (_e182.y * _e159));
                let _e204 = vec4<f32>(_e197.x, _e199, _e197.z, _e197.w);
                let _e206 = (_e204.z + (_e182.z * _e159));
                phi_150_ = vec4<f32>(_e192, _e199, _e206, (vec4<f32>(_e204.x, _e204.y, _e206, _e204.w).w + (_e182.w * _e159)));
                phi_153_ = (_e67 + 1i);
                phi_155_ = (_e69 + _e159);
            } else {
                phi_150_ = vec4<f32>();
                phi_153_ = i32();
                phi_155_ = f32();
            }
            let _e218 = phi_150_;
            let _e220 = phi_153_;
            let _e222 = phi_155_;
            continue;
            continuing {
                phi_149_ = _e218;
                phi_152_ = _e220;
                phi_154_ = _e222;
                break if !(_e70);
            }
        }
        let _e225 = local_1;
        let _e227 = local_2;
        let _e229 = local_3;
        let _e231 = local_4;
        let _e234 = local_5;
        if (_e54.shift < arrayLength((&rows.member))) {
        } else {
            return;
        }
        rows.member[(0u + _e54.shift)] = (_e234 / vec4<f32>(_e225, _e227, _e229, _e231));
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_filter_filter_x_esm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
