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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_19;
@group(0) @binding(1) 
var<storage> depths: type_15;
@group(0) @binding(2) 
var<storage, read_write> rows: type_23;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_117_: lt_bvh_traverse_Tree;
    var phi_118_: bool;
    var phi_119_: lt_bvh_traverse_Tree;
    var phi_120_: bool;
    var phi_125_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_117_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_118_ = false;
        } else {
            phi_117_ = lt_bvh_traverse_Tree();
            phi_118_ = true;
        }
        let _e54 = phi_117_;
        let _e56 = phi_118_;
        phi_119_ = _e54;
        phi_120_ = _e56;
    } else {
        phi_119_ = lt_bvh_traverse_Tree();
        phi_120_ = true;
    }
    let _e58 = phi_119_;
    let _e60 = phi_120_;
    if _e60 {
        phi_125_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_125_ = _e58;
    }
    let _e65 = phi_125_;
    return lt_bvh_traverse_Tree(_e65.root, _e65.first_primitive);
}

fn _lt_math_evsm_Evsm_negative(param_3: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_603_: bool;
    var phi_607_: f32;
    var phi_608_: f32;

    let _e43 = (*param_3).negative_exponent;
    if ((bitcast<u32>(_e43) & 2147483647u) > 2139095040u) {
        phi_608_ = _e43;
    } else {
        if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
            phi_603_ = true;
        } else {
            let _e50 = (42f < _e43);
            if _e50 {
            }
            phi_603_ = _e50;
        }
        let _e52 = phi_603_;
        if _e52 {
            phi_607_ = 42f;
        } else {
            phi_607_ = _e43;
        }
        let _e54 = phi_607_;
        phi_608_ = _e54;
    }
    let _e56 = phi_608_;
    return _e56;
}

fn _lt_math_evsm_Evsm_positive(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_577_: bool;
    var phi_581_: f32;
    var phi_582_: f32;

    let _e43 = (*param_4).positive_exponent;
    if ((bitcast<u32>(_e43) & 2147483647u) > 2139095040u) {
        phi_582_ = _e43;
    } else {
        if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
            phi_577_ = true;
        } else {
            let _e50 = (42f < _e43);
            if _e50 {
            }
            phi_577_ = _e50;
        }
        let _e52 = phi_577_;
        if _e52 {
            phi_581_ = 42f;
        } else {
            phi_581_ = _e43;
        }
        let _e54 = phi_581_;
        phi_582_ = _e54;
    }
    let _e56 = phi_582_;
    return _e56;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_5: ptr<function, lt_math_Evsm>, param_6: f32) -> vec4<f32> {
    var phi_363_: f32;
    var phi_364_: f32;
    var phi_365_: f32;
    var phi_390_: bool;
    var phi_394_: f32;
    var phi_395_: f32;
    var phi_412_: bool;
    var phi_416_: f32;
    var phi_417_: f32;
    var phi_458_: f32;
    var phi_484_: bool;
    var phi_488_: f32;
    var phi_489_: f32;
    var phi_506_: bool;
    var phi_510_: f32;
    var phi_511_: f32;
    var phi_552_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_365_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_364_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_363_ = 1f;
            } else {
                phi_363_ = param_6;
            }
            let _e49 = phi_363_;
            phi_364_ = _e49;
        }
        let _e51 = phi_364_;
        phi_365_ = _e51;
    }
    let _e53 = phi_365_;
    let _e54 = _lt_math_evsm_Evsm_positive(param_5);
    let _e55 = (_e54 * _e53);
    if ((bitcast<u32>(_e55) & 2147483647u) > 2139095040u) {
        phi_458_ = _e55;
    } else {
        if ((bitcast<u32>(_e55) & 2147483647u) > 2139095040u) {
            phi_395_ = _e55;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_390_ = true;
            } else {
                let _e65 = (-87f > _e55);
                if _e65 {
                }
                phi_390_ = _e65;
            }
            let _e67 = phi_390_;
            if _e67 {
                phi_394_ = -87f;
            } else {
                phi_394_ = _e55;
            }
            let _e69 = phi_394_;
            phi_395_ = _e69;
        }
        let _e71 = phi_395_;
        if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
            phi_417_ = _e71;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_412_ = true;
            } else {
                let _e78 = (88f < _e71);
                if _e78 {
                }
                phi_412_ = _e78;
            }
            let _e80 = phi_412_;
            if _e80 {
                phi_416_ = 88f;
            } else {
                phi_416_ = _e71;
            }
            let _e82 = phi_416_;
            phi_417_ = _e82;
        }
        let _e84 = phi_417_;
        let _e87 = floor(((_e84 * 1.442695f) + 0.5f));
        let _e91 = ((_e84 - (_e87 * 0.69314575f)) - (_e87 * 0.0000014286068f));
        phi_458_ = ((((((((((((((((1f / 5040f) * _e91) + (1f / 720f)) * _e91) + (1f / 120f)) * _e91) + (1f / 24f)) * _e91) + (1f / 6f)) * _e91) + 0.5f) * _e91) + 1f) * _e91) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e87), i32(-2147483648), (_e87 < bitcast<f32>(3472883712u))), 2147483647i, (_e87 > bitcast<f32>(1325400063u))), (_e87 == _e87)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e127 = phi_458_;
    let _e128 = _lt_math_evsm_Evsm_negative(param_5);
    let _e130 = (-(_e128) * _e53);
    if ((bitcast<u32>(_e130) & 2147483647u) > 2139095040u) {
        phi_552_ = _e130;
    } else {
        if ((bitcast<u32>(_e130) & 2147483647u) > 2139095040u) {
            phi_489_ = _e130;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_484_ = true;
            } else {
                let _e140 = (-87f > _e130);
                if _e140 {
                }
                phi_484_ = _e140;
            }
            let _e142 = phi_484_;
            if _e142 {
                phi_488_ = -87f;
            } else {
                phi_488_ = _e130;
            }
            let _e144 = phi_488_;
            phi_489_ = _e144;
        }
        let _e146 = phi_489_;
        if ((bitcast<u32>(_e146) & 2147483647u) > 2139095040u) {
            phi_511_ = _e146;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_506_ = true;
            } else {
                let _e153 = (88f < _e146);
                if _e153 {
                }
                phi_506_ = _e153;
            }
            let _e155 = phi_506_;
            if _e155 {
                phi_510_ = 88f;
            } else {
                phi_510_ = _e146;
            }
            let _e157 = phi_510_;
            phi_511_ = _e157;
        }
        let _e159 = phi_511_;
        let _e162 = floor(((_e159 * 1.442695f) + 0.5f));
        let _e166 = ((_e159 - (_e162 * 0.69314575f)) - (_e162 * 0.0000014286068f));
        phi_552_ = ((((((((((((((((1f / 5040f) * _e166) + (1f / 720f)) * _e166) + (1f / 120f)) * _e166) + (1f / 24f)) * _e166) + (1f / 6f)) * _e166) + 0.5f) * _e166) + 1f) * _e166) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e162), i32(-2147483648), (_e162 < bitcast<f32>(3472883712u))), 2147483647i, (_e162 > bitcast<f32>(1325400063u))), (_e162 == _e162)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e202 = phi_552_;
    let _e203 = -(_e202);
    return vec4<f32>(_e127, (_e127 * _e127), _e203, (_e203 * _e203));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_7: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_7.x, param_7.y, param_7.z);
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_157_: vec4<f32>;
    var phi_160_: i32;
    var phi_162_: f32;
    var phi_202_: bool;
    var phi_206_: f32;
    var phi_207_: f32;
    var phi_224_: bool;
    var phi_228_: f32;
    var phi_229_: f32;
    var phi_270_: f32;
    var phi_275_: f32;
    var phi_276_: f32;
    var phi_298_: i32;
    var phi_299_: i32;
    var phi_158_: vec4<f32>;
    var phi_161_: i32;
    var phi_163_: f32;
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
        let _e61 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e60);
        local = lt_math_Evsm(_e61.positive_exponent, _e61.negative_exponent, _e61.min_variance);
        phi_157_ = vec4<f32>(0f, 0f, 0f, 0f);
        phi_160_ = -2i;
        phi_162_ = 0f;
        loop {
            let _e67 = phi_157_;
            let _e69 = phi_160_;
            let _e71 = phi_162_;
            local_1 = _e71;
            local_2 = _e71;
            local_3 = _e71;
            local_4 = _e71;
            local_5 = _e67;
            let _e72 = (_e69 <= 2i);
            if _e72 {
                let _e74 = p.member.sigma;
                if (_e74 > 0f) {
                    let _e77 = (f32(_e69) / _e74);
                    let _e79 = ((-0.5f * _e77) * _e77);
                    if ((bitcast<u32>(_e79) & 2147483647u) > 2139095040u) {
                        phi_270_ = _e79;
                    } else {
                        if ((bitcast<u32>(_e79) & 2147483647u) > 2139095040u) {
                            phi_207_ = _e79;
                        } else {
                            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                                phi_202_ = true;
                            } else {
                                let _e89 = (-87f > _e79);
                                if _e89 {
                                }
                                phi_202_ = _e89;
                            }
                            let _e91 = phi_202_;
                            if _e91 {
                                phi_206_ = -87f;
                            } else {
                                phi_206_ = _e79;
                            }
                            let _e93 = phi_206_;
                            phi_207_ = _e93;
                        }
                        let _e95 = phi_207_;
                        if ((bitcast<u32>(_e95) & 2147483647u) > 2139095040u) {
                            phi_229_ = _e95;
                        } else {
                            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                                phi_224_ = true;
                            } else {
                                let _e102 = (88f < _e95);
                                if _e102 {
                                }
                                phi_224_ = _e102;
                            }
                            let _e104 = phi_224_;
                            if _e104 {
                                phi_228_ = 88f;
                            } else {
                                phi_228_ = _e95;
                            }
                            let _e106 = phi_228_;
                            phi_229_ = _e106;
                        }
                        let _e108 = phi_229_;
                        let _e111 = floor(((_e108 * 1.442695f) + 0.5f));
                        let _e115 = ((_e108 - (_e111 * 0.69314575f)) - (_e111 * 0.0000014286068f));
                        phi_270_ = ((((((((((((((((1f / 5040f) * _e115) + (1f / 720f)) * _e115) + (1f / 120f)) * _e115) + (1f / 24f)) * _e115) + (1f / 6f)) * _e115) + 0.5f) * _e115) + 1f) * _e115) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e111), i32(-2147483648), (_e111 < bitcast<f32>(3472883712u))), 2147483647i, (_e111 > bitcast<f32>(1325400063u))), (_e111 == _e111)) + 127i)) << bitcast<u32>(23i))));
                    }
                    let _e151 = phi_270_;
                    phi_276_ = _e151;
                } else {
                    if (_e69 == 0i) {
                        phi_275_ = 1f;
                    } else {
                        phi_275_ = 0f;
                    }
                    let _e154 = phi_275_;
                    phi_276_ = _e154;
                }
                let _e156 = phi_276_;
                let _e158 = p.member.map_size;
                let _e161 = p.member.map_size;
                let _e163 = (bitcast<i32>(_e42.x) + _e69);
                let _e165 = (bitcast<i32>(_e161) - 1i);
                if (0i <= _e165) {
                } else {
                    return;
                }
                if (_e163 < 0i) {
                    phi_299_ = 0i;
                } else {
                    if (_e163 > _e165) {
                        phi_298_ = _e165;
                    } else {
                        phi_298_ = _e163;
                    }
                    let _e170 = phi_298_;
                    phi_299_ = _e170;
                }
                let _e172 = phi_299_;
                let _e174 = ((_e42.y * _e158) + bitcast<u32>(_e172));
                if (_e174 < arrayLength((&depths.member))) {
                } else {
                    return;
                }
                let _e178 = depths.member[(0u + _e174)];
                let _e179 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector((&local), _e178);
                let _e189 = (_e67.x + (_e179.x * _e156));
                let _e194 = vec4<f32>(_e189, _e67.y, _e67.z, _e67.w);
                let _e196 = (_e194.y + (_e179.y * _e156));
                let _e201 = vec4<f32>(_e194.x, _e196, _e194.z, _e194.w);
                let _e203 = (_e201.z + (_e179.z * _e156));
                phi_158_ = vec4<f32>(_e189, _e196, _e203, (vec4<f32>(_e201.x, _e201.y, _e203, _e201.w).w + (_e179.w * _e156)));
                phi_161_ = (_e69 + 1i);
                phi_163_ = (_e71 + _e156);
            } else {
                phi_158_ = vec4<f32>();
                phi_161_ = i32();
                phi_163_ = f32();
            }
            let _e215 = phi_158_;
            let _e217 = phi_161_;
            let _e219 = phi_163_;
            continue;
            continuing {
                phi_157_ = _e215;
                phi_160_ = _e217;
                phi_162_ = _e219;
                break if !(_e72);
            }
        }
        let _e222 = local_1;
        let _e224 = local_2;
        let _e226 = local_3;
        let _e228 = local_4;
        let _e231 = local_5;
        if (_e52.first_primitive < arrayLength((&rows.member))) {
        } else {
            return;
        }
        rows.member[(0u + _e52.first_primitive)] = (_e231 / vec4<f32>(_e222, _e224, _e226, _e228));
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_filter_filter_x_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
