struct type_15 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_FilterParams {
    test: vec4<f32>,
    map_size: u32,
    sigma: f32,
    pad: vec2<u32>,
}

struct type_19 {
    member: abi_FilterParams,
}

struct type_23 {
    member: array<vec4<f32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_19;
@group(0) @binding(1) 
var<storage> depths: type_15;
@group(0) @binding(2) 
var<storage, read_write> rows: type_23;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_113_: lt_bvh_traverse_Tree;
    var phi_114_: bool;
    var phi_115_: lt_bvh_traverse_Tree;
    var phi_116_: bool;
    var phi_121_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_113_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_114_ = false;
        } else {
            phi_113_ = lt_bvh_traverse_Tree();
            phi_114_ = true;
        }
        let _e54 = phi_113_;
        let _e56 = phi_114_;
        phi_115_ = _e54;
        phi_116_ = _e56;
    } else {
        phi_115_ = lt_bvh_traverse_Tree();
        phi_116_ = true;
    }
    let _e58 = phi_115_;
    let _e60 = phi_116_;
    if _e60 {
        phi_121_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_121_ = _e58;
    }
    let _e65 = phi_121_;
    return lt_bvh_traverse_Tree(_e65.root, _e65.first_primitive);
}

fn _lt_math_esm_Esm_clamped_exponent(param_3: ptr<function, f32>) -> f32 {
    var phi_469_: bool;
    var phi_473_: f32;
    var phi_474_: f32;

    let _e42 = (*param_3);
    if ((bitcast<u32>(_e42) & 2147483647u) > 2139095040u) {
        phi_474_ = _e42;
    } else {
        if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
            phi_469_ = true;
        } else {
            let _e49 = (84f < _e42);
            if _e49 {
            }
            phi_469_ = _e49;
        }
        let _e51 = phi_469_;
        if _e51 {
            phi_473_ = 84f;
        } else {
            phi_473_ = _e42;
        }
        let _e53 = phi_473_;
        phi_474_ = _e53;
    }
    let _e55 = phi_474_;
    return _e55;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, f32>, param_5: f32) -> vec4<f32> {
    var phi_353_: f32;
    var phi_354_: f32;
    var phi_355_: f32;
    var phi_380_: bool;
    var phi_384_: f32;
    var phi_385_: f32;
    var phi_402_: bool;
    var phi_406_: f32;
    var phi_407_: f32;
    var phi_448_: f32;

    let _e43 = _lt_math_esm_Esm_clamped_exponent(param_4);
    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_355_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_354_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_353_ = 1f;
            } else {
                phi_353_ = param_5;
            }
            let _e50 = phi_353_;
            phi_354_ = _e50;
        }
        let _e52 = phi_354_;
        phi_355_ = _e52;
    }
    let _e54 = phi_355_;
    let _e56 = (_e43 * (_e54 - 1f));
    if ((bitcast<u32>(_e56) & 2147483647u) > 2139095040u) {
        phi_448_ = _e56;
    } else {
        if ((bitcast<u32>(_e56) & 2147483647u) > 2139095040u) {
            phi_385_ = _e56;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_380_ = true;
            } else {
                let _e66 = (-87f > _e56);
                if _e66 {
                }
                phi_380_ = _e66;
            }
            let _e68 = phi_380_;
            if _e68 {
                phi_384_ = -87f;
            } else {
                phi_384_ = _e56;
            }
            let _e70 = phi_384_;
            phi_385_ = _e70;
        }
        let _e72 = phi_385_;
        if ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u) {
            phi_407_ = _e72;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_402_ = true;
            } else {
                let _e79 = (88f < _e72);
                if _e79 {
                }
                phi_402_ = _e79;
            }
            let _e81 = phi_402_;
            if _e81 {
                phi_406_ = 88f;
            } else {
                phi_406_ = _e72;
            }
            let _e83 = phi_406_;
            phi_407_ = _e83;
        }
        let _e85 = phi_407_;
        let _e88 = floor(((_e85 * 1.442695f) + 0.5f));
        let _e92 = ((_e85 - (_e88 * 0.69314575f)) - (_e88 * 0.0000014286068f));
        phi_448_ = ((((((((((((((((1f / 5040f) * _e92) + (1f / 720f)) * _e92) + (1f / 120f)) * _e92) + (1f / 24f)) * _e92) + (1f / 6f)) * _e92) + 0.5f) * _e92) + 1f) * _e92) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e88), i32(-2147483648), (_e88 < bitcast<f32>(3472883712u))), 2147483647i, (_e88 > bitcast<f32>(1325400063u))), (_e88 == _e88)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e128 = phi_448_;
    return vec4<f32>(_e128, 0f, 0f, 0f);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_6: vec4<f32>) -> f32 {
    return param_6.x;
}

fn function_() {
    var local: f32;
    var phi_149_: vec4<f32>;
    var phi_152_: i32;
    var phi_154_: f32;
    var phi_194_: bool;
    var phi_198_: f32;
    var phi_199_: f32;
    var phi_216_: bool;
    var phi_220_: f32;
    var phi_221_: f32;
    var phi_262_: f32;
    var phi_267_: f32;
    var phi_268_: f32;
    var phi_290_: i32;
    var phi_291_: i32;
    var phi_150_: vec4<f32>;
    var phi_153_: i32;
    var phi_155_: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var local_5: vec4<f32>;

    let _e42 = id_1;
    let _e51 = p.member.map_size;
    let _e52 = lt_shaders_entry_pixel_index(_e42, _e51, _e51);
    if (bitcast<i32>(_e52.root) != 0i) {
        let _e60 = p.member.test;
        let _e61 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e60);
        local = _e61;
        phi_149_ = vec4<f32>(0f, 0f, 0f, 0f);
        phi_152_ = -2i;
        phi_154_ = 0f;
        loop {
            let _e63 = phi_149_;
            let _e65 = phi_152_;
            let _e67 = phi_154_;
            local_1 = _e67;
            local_2 = _e67;
            local_3 = _e67;
            local_4 = _e67;
            local_5 = _e63;
            let _e68 = (_e65 <= 2i);
            if _e68 {
                let _e70 = p.member.sigma;
                if (_e70 > 0f) {
                    let _e73 = (f32(_e65) / _e70);
                    let _e75 = ((-0.5f * _e73) * _e73);
                    if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
                        phi_262_ = _e75;
                    } else {
                        if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
                            phi_199_ = _e75;
                        } else {
                            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                                phi_194_ = true;
                            } else {
                                let _e85 = (-87f > _e75);
                                if _e85 {
                                }
                                phi_194_ = _e85;
                            }
                            let _e87 = phi_194_;
                            if _e87 {
                                phi_198_ = -87f;
                            } else {
                                phi_198_ = _e75;
                            }
                            let _e89 = phi_198_;
                            phi_199_ = _e89;
                        }
                        let _e91 = phi_199_;
                        if ((bitcast<u32>(_e91) & 2147483647u) > 2139095040u) {
                            phi_221_ = _e91;
                        } else {
                            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                                phi_216_ = true;
                            } else {
                                let _e98 = (88f < _e91);
                                if _e98 {
                                }
                                phi_216_ = _e98;
                            }
                            let _e100 = phi_216_;
                            if _e100 {
                                phi_220_ = 88f;
                            } else {
                                phi_220_ = _e91;
                            }
                            let _e102 = phi_220_;
                            phi_221_ = _e102;
                        }
                        let _e104 = phi_221_;
                        let _e107 = floor(((_e104 * 1.442695f) + 0.5f));
                        let _e111 = ((_e104 - (_e107 * 0.69314575f)) - (_e107 * 0.0000014286068f));
                        phi_262_ = ((((((((((((((((1f / 5040f) * _e111) + (1f / 720f)) * _e111) + (1f / 120f)) * _e111) + (1f / 24f)) * _e111) + (1f / 6f)) * _e111) + 0.5f) * _e111) + 1f) * _e111) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e107), i32(-2147483648), (_e107 < bitcast<f32>(3472883712u))), 2147483647i, (_e107 > bitcast<f32>(1325400063u))), (_e107 == _e107)) + 127i)) << bitcast<u32>(23i))));
                    }
                    let _e147 = phi_262_;
                    phi_268_ = _e147;
                } else {
                    if (_e65 == 0i) {
                        phi_267_ = 1f;
                    } else {
                        phi_267_ = 0f;
                    }
                    let _e150 = phi_267_;
                    phi_268_ = _e150;
                }
                let _e152 = phi_268_;
                let _e154 = p.member.map_size;
                let _e157 = p.member.map_size;
                let _e159 = (bitcast<i32>(_e42.x) + _e65);
                let _e161 = (bitcast<i32>(_e157) - 1i);
                if (0i <= _e161) {
                } else {
                    return;
                }
                if (_e159 < 0i) {
                    phi_291_ = 0i;
                } else {
                    if (_e159 > _e161) {
                        phi_290_ = _e161;
                    } else {
                        phi_290_ = _e159;
                    }
                    let _e166 = phi_290_;
                    phi_291_ = _e166;
                }
                let _e168 = phi_291_;
                let _e170 = ((_e42.y * _e154) + bitcast<u32>(_e168));
                if (_e170 < arrayLength((&depths.member))) {
                } else {
                    return;
                }
                let _e174 = depths.member[(0u + _e170)];
                let _e175 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector((&local), _e174);
                let _e185 = (_e63.x + (_e175.x * _e152));
                let _e190 = vec4<f32>(_e185, _e63.y, _e63.z, _e63.w);
                let _e192 = (_e190.y + (_e175.y * _e152));
                let _e197 = vec4<f32>(_e190.x, _e192, _e190.z, _e190.w);
                let _e199 = (_e197.z + (_e175.z * _e152));
                phi_150_ = vec4<f32>(_e185, _e192, _e199, (vec4<f32>(_e197.x, _e197.y, _e199, _e197.w).w + (_e175.w * _e152)));
                phi_153_ = (_e65 + 1i);
                phi_155_ = (_e67 + _e152);
            } else {
                phi_150_ = vec4<f32>();
                phi_153_ = i32();
                phi_155_ = f32();
            }
            let _e211 = phi_150_;
            let _e213 = phi_153_;
            let _e215 = phi_155_;
            continue;
            continuing {
                phi_149_ = _e211;
                phi_152_ = _e213;
                phi_154_ = _e215;
                break if !(_e68);
            }
        }
        let _e218 = local_1;
        let _e220 = local_2;
        let _e222 = local_3;
        let _e224 = local_4;
        let _e227 = local_5;
        if (_e52.first_primitive < arrayLength((&rows.member))) {
        } else {
            return;
        }
        rows.member[(0u + _e52.first_primitive)] = (_e227 / vec4<f32>(_e218, _e220, _e222, _e224));
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_filter_filter_x_esm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
