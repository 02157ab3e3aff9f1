struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_11 {
    member: array<f32>,
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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_22;
@group(0) @binding(1) 
var<storage> depths: type_11;
@group(0) @binding(2) 
var<storage, read_write> rows: type_18;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_114_: lt_bvh_traverse_Tree;
    var phi_115_: bool;
    var phi_116_: lt_bvh_traverse_Tree;
    var phi_117_: bool;
    var phi_122_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_114_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_115_ = false;
        } else {
            phi_114_ = lt_bvh_traverse_Tree();
            phi_115_ = true;
        }
        let _e56 = phi_114_;
        let _e58 = phi_115_;
        phi_116_ = _e56;
        phi_117_ = _e58;
    } else {
        phi_116_ = lt_bvh_traverse_Tree();
        phi_117_ = true;
    }
    let _e60 = phi_116_;
    let _e62 = phi_117_;
    if _e62 {
        phi_122_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_122_ = _e60;
    }
    let _e67 = phi_122_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_3: ptr<function, lt_math_Evsm>, param_4: f32) -> vec4<f32> {
    var phi_357_: f32;
    var phi_358_: f32;
    var phi_359_: f32;
    var phi_372_: bool;
    var phi_376_: f32;
    var phi_388_: f32;
    var phi_393_: f32;
    var phi_415_: f32;
    var phi_420_: f32;
    var phi_421_: bool;
    var phi_422_: f32;
    var phi_423_: bool;
    var phi_427_: f32;
    var phi_465_: f32;
    var phi_478_: bool;
    var phi_482_: f32;
    var phi_495_: f32;
    var phi_500_: f32;
    var phi_522_: f32;
    var phi_527_: f32;
    var phi_528_: bool;
    var phi_529_: f32;
    var phi_530_: bool;
    var phi_534_: f32;
    var phi_572_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_359_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_358_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_357_ = 1f;
            } else {
                phi_357_ = param_4;
            }
            let _e51 = phi_357_;
            phi_358_ = _e51;
        }
        let _e53 = phi_358_;
        phi_359_ = _e53;
    }
    let _e55 = phi_359_;
    let _e57 = (*param_3).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_372_ = true;
    } else {
        let _e61 = (42f < _e57);
        if _e61 {
        }
        phi_372_ = _e61;
    }
    let _e63 = phi_372_;
    if _e63 {
        phi_376_ = 42f;
    } else {
        phi_376_ = _e57;
    }
    let _e65 = phi_376_;
    let _e66 = (_e65 * _e55);
    if ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u) {
        phi_465_ = _e66;
    } else {
        if (_e66 < -87f) {
            phi_388_ = -87f;
        } else {
            phi_388_ = _e66;
        }
        let _e72 = phi_388_;
        if (_e72 > 88f) {
            phi_393_ = 88f;
        } else {
            phi_393_ = _e72;
        }
        let _e75 = phi_393_;
        let _e77 = ((_e75 * 1.442695f) + 0.5f);
        if (_e77 > -8388608f) {
            let _e89 = f32(select(0i, select(select(i32(_e77), i32(-2147483648), (_e77 < bitcast<f32>(3472883712u))), 2147483647i, (_e77 > bitcast<f32>(1325400063u))), (_e77 == _e77)));
            if (_e89 > _e77) {
                phi_415_ = 1f;
            } else {
                phi_415_ = 0f;
            }
            let _e92 = phi_415_;
            if (_e77 < 8388608f) {
                phi_420_ = (_e89 - _e92);
                phi_421_ = false;
            } else {
                phi_420_ = f32();
                phi_421_ = true;
            }
            let _e95 = phi_420_;
            let _e97 = phi_421_;
            phi_422_ = _e95;
            phi_423_ = _e97;
        } else {
            phi_422_ = f32();
            phi_423_ = true;
        }
        let _e99 = phi_422_;
        let _e101 = phi_423_;
        if _e101 {
            phi_427_ = _e77;
        } else {
            phi_427_ = _e99;
        }
        let _e103 = phi_427_;
        let _e107 = ((_e75 - (_e103 * 0.69314575f)) - (_e103 * 0.0000014286068f));
        phi_465_ = ((((((((((((((((1f / 5040f) * _e107) + (1f / 720f)) * _e107) + (1f / 120f)) * _e107) + (1f / 24f)) * _e107) + (1f / 6f)) * _e107) + 0.5f) * _e107) + 1f) * _e107) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e103), i32(-2147483648), (_e103 < bitcast<f32>(3472883712u))), 2147483647i, (_e103 > bitcast<f32>(1325400063u))), (_e103 == _e103)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e143 = phi_465_;
    let _e145 = (*param_3).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_478_ = true;
    } else {
        let _e149 = (42f < _e145);
        if _e149 {
        }
        phi_478_ = _e149;
    }
    let _e151 = phi_478_;
    if _e151 {
        phi_482_ = 42f;
    } else {
        phi_482_ = _e145;
    }
    let _e153 = phi_482_;
    let _e155 = (-(_e153) * _e55);
    if ((bitcast<u32>(_e155) & 2147483647u) > 2139095040u) {
        phi_572_ = _e155;
    } else {
        if (_e155 < -87f) {
            phi_495_ = -87f;
        } else {
            phi_495_ = _e155;
        }
        let _e161 = phi_495_;
        if (_e161 > 88f) {
            phi_500_ = 88f;
        } else {
            phi_500_ = _e161;
        }
        let _e164 = phi_500_;
        let _e166 = ((_e164 * 1.442695f) + 0.5f);
        if (_e166 > -8388608f) {
            let _e178 = f32(select(0i, select(select(i32(_e166), i32(-2147483648), (_e166 < bitcast<f32>(3472883712u))), 2147483647i, (_e166 > bitcast<f32>(1325400063u))), (_e166 == _e166)));
            if (_e178 > _e166) {
                phi_522_ = 1f;
            } else {
                phi_522_ = 0f;
            }
            let _e181 = phi_522_;
            if (_e166 < 8388608f) {
                phi_527_ = (_e178 - _e181);
                phi_528_ = false;
            } else {
                phi_527_ = f32();
                phi_528_ = true;
            }
            let _e184 = phi_527_;
            let _e186 = phi_528_;
            phi_529_ = _e184;
            phi_530_ = _e186;
        } else {
            phi_529_ = f32();
            phi_530_ = true;
        }
        let _e188 = phi_529_;
        let _e190 = phi_530_;
        if _e190 {
            phi_534_ = _e166;
        } else {
            phi_534_ = _e188;
        }
        let _e192 = phi_534_;
        let _e196 = ((_e164 - (_e192 * 0.69314575f)) - (_e192 * 0.0000014286068f));
        phi_572_ = ((((((((((((((((1f / 5040f) * _e196) + (1f / 720f)) * _e196) + (1f / 120f)) * _e196) + (1f / 24f)) * _e196) + (1f / 6f)) * _e196) + 0.5f) * _e196) + 1f) * _e196) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e192), i32(-2147483648), (_e192 < bitcast<f32>(3472883712u))), 2147483647i, (_e192 > bitcast<f32>(1325400063u))), (_e192 == _e192)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e232 = phi_572_;
    let _e233 = -(_e232);
    return vec4<f32>(_e143, (_e143 * _e143), _e233, (_e233 * _e233));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_5: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_5.x, param_5.y, param_5.z);
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_154_: vec4<f32>;
    var phi_157_: i32;
    var phi_159_: f32;
    var phi_187_: f32;
    var phi_192_: f32;
    var phi_214_: f32;
    var phi_219_: f32;
    var phi_220_: bool;
    var phi_221_: f32;
    var phi_222_: bool;
    var phi_226_: f32;
    var phi_264_: f32;
    var phi_269_: f32;
    var phi_270_: f32;
    var phi_292_: i32;
    var phi_293_: i32;
    var phi_155_: vec4<f32>;
    var phi_158_: i32;
    var phi_160_: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: f32;
    var local_5: vec4<f32>;

    let _e44 = id_1;
    let _e53 = p.member.map_size;
    let _e54 = lt_shaders_entry_pixel_index(_e44, _e53, _e53);
    if (bitcast<i32>(_e54.root) != 0i) {
        let _e62 = p.member.test;
        let _e63 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e62);
        local = lt_math_Evsm(_e63.positive_exponent, _e63.negative_exponent, _e63.min_variance);
        phi_154_ = vec4<f32>(0f, 0f, 0f, 0f);
        phi_157_ = -2i;
        phi_159_ = 0f;
        loop {
            let _e69 = phi_154_;
            let _e71 = phi_157_;
            let _e73 = phi_159_;
            local_1 = _e73;
            local_2 = _e73;
            local_3 = _e73;
            local_4 = _e73;
            local_5 = _e69;
            let _e74 = (_e71 <= 2i);
            if _e74 {
                let _e76 = p.member.sigma;
                if (_e76 > 0f) {
                    let _e79 = (f32(_e71) / _e76);
                    let _e81 = ((-0.5f * _e79) * _e79);
                    if ((bitcast<u32>(_e81) & 2147483647u) > 2139095040u) {
                        phi_264_ = _e81;
                    } else {
                        if (_e81 < -87f) {
                            phi_187_ = -87f;
                        } else {
                            phi_187_ = _e81;
                        }
                        let _e87 = phi_187_;
                        if (_e87 > 88f) {
                            phi_192_ = 88f;
                        } else {
                            phi_192_ = _e87;
                        }
                        let _e90 = phi_192_;
                        let _e92 = ((_e90 * 1.442695f) + 0.5f);
                        if (_e92 > -8388608f) {
                            let _e104 = f32(select(0i, select(select(i32(_e92), i32(-2147483648), (_e92 < bitcast<f32>(3472883712u))), 2147483647i, (_e92 > bitcast<f32>(1325400063u))), (_e92 == _e92)));
                            if (_e104 > _e92) {
                                phi_214_ = 1f;
                            } else {
                                phi_214_ = 0f;
                            }
                            let _e107 = phi_214_;
                            if (_e92 < 8388608f) {
                                phi_219_ = (_e104 - _e107);
                                phi_220_ = false;
                            } else {
                                phi_219_ = f32();
                                phi_220_ = true;
                            }
                            let _e110 = phi_219_;
                            let _e112 = phi_220_;
                            phi_221_ = _e110;
                            phi_222_ = _e112;
                        } else {
                            phi_221_ = f32();
                            phi_222_ = true;
                        }
                        let _e114 = phi_221_;
                        let _e116 = phi_222_;
                        if _e116 {
                            phi_226_ = _e92;
                        } else {
                            phi_226_ = _e114;
                        }
                        let _e118 = phi_226_;
                        let _e122 = ((_e90 - (_e118 * 0.69314575f)) - (_e118 * 0.0000014286068f));
                        phi_264_ = ((((((((((((((((1f / 5040f) * _e122) + (1f / 720f)) * _e122) + (1f / 120f)) * _e122) + (1f / 24f)) * _e122) + (1f / 6f)) * _e122) + 0.5f) * _e122) + 1f) * _e122) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < bitcast<f32>(3472883712u))), 2147483647i, (_e118 > bitcast<f32>(1325400063u))), (_e118 == _e118)) + 127i)) << bitcast<u32>(23i))));
                    }
                    let _e158 = phi_264_;
                    phi_270_ = _e158;
                } else {
                    if (_e71 == 0i) {
                        phi_269_ = 1f;
                    } else {
                        phi_269_ = 0f;
                    }
                    let _e161 = phi_269_;
                    phi_270_ = _e161;
                }
                let _e163 = phi_270_;
                let _e165 = p.member.map_size;
                let _e168 = p.member.map_size;
                let _e170 = (bitcast<i32>(_e44.x) + _e71);
                let _e172 = (bitcast<i32>(_e168) - 1i);
                if (0i <= _e172) {
                } else {
                    return;
                }
                if (_e170 < 0i) {
                    phi_293_ = 0i;
                } else {
                    if (_e170 > _e172) {
                        phi_292_ = _e172;
                    } else {
                        phi_292_ = _e170;
                    }
                    let _e177 = phi_292_;
                    phi_293_ = _e177;
                }
                let _e179 = phi_293_;
                let _e181 = ((_e44.y * _e165) + bitcast<u32>(_e179));
                if (_e181 < arrayLength((&depths.member))) {
                } else {
                    return;
                }
                let _e185 = depths.member[(0u + _e181)];
                let _e186 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector((&local), _e185);
                let _e196 = (_e69.x + (_e186.x * _e163));
                let _e201 = vec4<f32>(_e196, _e69.y, _e69.z, _e69.w);
                let _e203 = (_e201.y + (_e186.y * _e163));
                let _e208 = vec4<f32>(_e201.x, _e203, _e201.z, _e201.w);
                let _e210 = (_e208.z + (_e186.z * _e163));
                phi_155_ = vec4<f32>(_e196, _e203, _e210, (vec4<f32>(_e208.x, _e208.y, _e210, _e208.w).w + (_e186.w * _e163)));
                phi_158_ = (_e71 + 1i);
                phi_160_ = (_e73 + _e163);
            } else {
                phi_155_ = vec4<f32>();
                phi_158_ = i32();
                phi_160_ = f32();
            }
            let _e222 = phi_155_;
            let _e224 = phi_158_;
            let _e226 = phi_160_;
            continue;
            continuing {
                phi_154_ = _e222;
                phi_157_ = _e224;
                phi_159_ = _e226;
                break if !(_e74);
            }
        }
        let _e229 = local_1;
        let _e231 = local_2;
        let _e233 = local_3;
        let _e235 = local_4;
        let _e238 = local_5;
        if (_e54.first_primitive < arrayLength((&rows.member))) {
        } else {
            return;
        }
        rows.member[(0u + _e54.first_primitive)] = (_e238 / vec4<f32>(_e229, _e231, _e233, _e235));
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_filter_filter_x_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
