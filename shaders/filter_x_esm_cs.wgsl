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

var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_22;
@group(0) @binding(1) 
var<storage> depths: type_11;
@group(0) @binding(2) 
var<storage, read_write> rows: type_18;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_111_: lt_bvh_traverse_Tree;
    var phi_112_: bool;
    var phi_113_: lt_bvh_traverse_Tree;
    var phi_114_: bool;
    var phi_119_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_111_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_112_ = false;
        } else {
            phi_111_ = lt_bvh_traverse_Tree();
            phi_112_ = true;
        }
        let _e56 = phi_111_;
        let _e58 = phi_112_;
        phi_113_ = _e56;
        phi_114_ = _e58;
    } else {
        phi_113_ = lt_bvh_traverse_Tree();
        phi_114_ = true;
    }
    let _e60 = phi_113_;
    let _e62 = phi_114_;
    if _e62 {
        phi_119_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_119_ = _e60;
    }
    let _e67 = phi_119_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_3: ptr<function, f32>, param_4: f32) -> vec4<f32> {
    var phi_344_: bool;
    var phi_348_: f32;
    var phi_363_: f32;
    var phi_364_: f32;
    var phi_365_: f32;
    var phi_378_: f32;
    var phi_383_: f32;
    var phi_405_: f32;
    var phi_410_: f32;
    var phi_411_: bool;
    var phi_412_: f32;
    var phi_413_: bool;
    var phi_417_: f32;
    var phi_455_: f32;

    let _e45 = (*param_3);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_344_ = true;
    } else {
        let _e49 = (84f < _e45);
        if _e49 {
        }
        phi_344_ = _e49;
    }
    let _e51 = phi_344_;
    if _e51 {
        phi_348_ = 84f;
    } else {
        phi_348_ = _e45;
    }
    let _e53 = phi_348_;
    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_365_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_364_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_363_ = 1f;
            } else {
                phi_363_ = param_4;
            }
            let _e60 = phi_363_;
            phi_364_ = _e60;
        }
        let _e62 = phi_364_;
        phi_365_ = _e62;
    }
    let _e64 = phi_365_;
    let _e66 = (_e53 * (_e64 - 1f));
    if ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u) {
        phi_455_ = _e66;
    } else {
        if (_e66 < -87f) {
            phi_378_ = -87f;
        } else {
            phi_378_ = _e66;
        }
        let _e72 = phi_378_;
        if (_e72 > 88f) {
            phi_383_ = 88f;
        } else {
            phi_383_ = _e72;
        }
        let _e75 = phi_383_;
        let _e77 = ((_e75 * 1.442695f) + 0.5f);
        if (_e77 > -8388608f) {
            let _e89 = f32(select(0i, select(select(i32(_e77), i32(-2147483648), (_e77 < bitcast<f32>(3472883712u))), 2147483647i, (_e77 > bitcast<f32>(1325400063u))), (_e77 == _e77)));
            if (_e89 > _e77) {
                phi_405_ = 1f;
            } else {
                phi_405_ = 0f;
            }
            let _e92 = phi_405_;
            if (_e77 < 8388608f) {
                phi_410_ = (_e89 - _e92);
                phi_411_ = false;
            } else {
                phi_410_ = f32();
                phi_411_ = true;
            }
            let _e95 = phi_410_;
            let _e97 = phi_411_;
            phi_412_ = _e95;
            phi_413_ = _e97;
        } else {
            phi_412_ = f32();
            phi_413_ = true;
        }
        let _e99 = phi_412_;
        let _e101 = phi_413_;
        if _e101 {
            phi_417_ = _e77;
        } else {
            phi_417_ = _e99;
        }
        let _e103 = phi_417_;
        let _e107 = ((_e75 - (_e103 * 0.69314575f)) - (_e103 * 0.0000014286068f));
        phi_455_ = ((((((((((((((((1f / 5040f) * _e107) + (1f / 720f)) * _e107) + (1f / 120f)) * _e107) + (1f / 24f)) * _e107) + (1f / 6f)) * _e107) + 0.5f) * _e107) + 1f) * _e107) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e103), i32(-2147483648), (_e103 < bitcast<f32>(3472883712u))), 2147483647i, (_e103 > bitcast<f32>(1325400063u))), (_e103 == _e103)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e143 = phi_455_;
    return vec4<f32>(_e143, 0f, 0f, 0f);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_5: vec4<f32>) -> f32 {
    return param_5.x;
}

fn function_() {
    var local: f32;
    var phi_147_: vec4<f32>;
    var phi_150_: i32;
    var phi_152_: f32;
    var phi_180_: f32;
    var phi_185_: f32;
    var phi_207_: f32;
    var phi_212_: f32;
    var phi_213_: bool;
    var phi_214_: f32;
    var phi_215_: bool;
    var phi_219_: f32;
    var phi_257_: f32;
    var phi_262_: f32;
    var phi_263_: f32;
    var phi_285_: i32;
    var phi_286_: i32;
    var phi_148_: vec4<f32>;
    var phi_151_: i32;
    var phi_153_: f32;
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
        let _e63 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e62);
        local = _e63;
        phi_147_ = vec4<f32>(0f, 0f, 0f, 0f);
        phi_150_ = -2i;
        phi_152_ = 0f;
        loop {
            let _e65 = phi_147_;
            let _e67 = phi_150_;
            let _e69 = phi_152_;
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
                        phi_257_ = _e77;
                    } else {
                        if (_e77 < -87f) {
                            phi_180_ = -87f;
                        } else {
                            phi_180_ = _e77;
                        }
                        let _e83 = phi_180_;
                        if (_e83 > 88f) {
                            phi_185_ = 88f;
                        } else {
                            phi_185_ = _e83;
                        }
                        let _e86 = phi_185_;
                        let _e88 = ((_e86 * 1.442695f) + 0.5f);
                        if (_e88 > -8388608f) {
                            let _e100 = f32(select(0i, select(select(i32(_e88), i32(-2147483648), (_e88 < bitcast<f32>(3472883712u))), 2147483647i, (_e88 > bitcast<f32>(1325400063u))), (_e88 == _e88)));
                            if (_e100 > _e88) {
                                phi_207_ = 1f;
                            } else {
                                phi_207_ = 0f;
                            }
                            let _e103 = phi_207_;
                            if (_e88 < 8388608f) {
                                phi_212_ = (_e100 - _e103);
                                phi_213_ = false;
                            } else {
                                phi_212_ = f32();
                                phi_213_ = true;
                            }
                            let _e106 = phi_212_;
                            let _e108 = phi_213_;
                            phi_214_ = _e106;
                            phi_215_ = _e108;
                        } else {
                            phi_214_ = f32();
                            phi_215_ = true;
                        }
                        let _e110 = phi_214_;
                        let _e112 = phi_215_;
                        if _e112 {
                            phi_219_ = _e88;
                        } else {
                            phi_219_ = _e110;
                        }
                        let _e114 = phi_219_;
                        let _e118 = ((_e86 - (_e114 * 0.69314575f)) - (_e114 * 0.0000014286068f));
                        phi_257_ = ((((((((((((((((1f / 5040f) * _e118) + (1f / 720f)) * _e118) + (1f / 120f)) * _e118) + (1f / 24f)) * _e118) + (1f / 6f)) * _e118) + 0.5f) * _e118) + 1f) * _e118) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)) + 127i)) << bitcast<u32>(23i))));
                    }
                    let _e154 = phi_257_;
                    phi_263_ = _e154;
                } else {
                    if (_e67 == 0i) {
                        phi_262_ = 1f;
                    } else {
                        phi_262_ = 0f;
                    }
                    let _e157 = phi_262_;
                    phi_263_ = _e157;
                }
                let _e159 = phi_263_;
                let _e161 = p.member.map_size;
                let _e164 = p.member.map_size;
                let _e166 = (bitcast<i32>(_e44.x) + _e67);
                let _e168 = (bitcast<i32>(_e164) - 1i);
                if (0i <= _e168) {
                } else {
                    return;
                }
                if (_e166 < 0i) {
                    phi_286_ = 0i;
                } else {
                    if (_e166 > _e168) {
                        phi_285_ = _e168;
                    } else {
                        phi_285_ = _e166;
                    }
                    let _e173 = phi_285_;
                    phi_286_ = _e173;
                }
                let _e175 = phi_286_;
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
                phi_148_ = vec4<f32>(_e192, _e199, _e206, (vec4<f32>(_e204.x, _e204.y, _e206, _e204.w).w + (_e182.w * _e159)));
                phi_151_ = (_e67 + 1i);
                phi_153_ = (_e69 + _e159);
            } else {
                phi_148_ = vec4<f32>();
                phi_151_ = i32();
                phi_153_ = f32();
            }
            let _e218 = phi_148_;
            let _e220 = phi_151_;
            let _e222 = phi_153_;
            continue;
            continuing {
                phi_147_ = _e218;
                phi_150_ = _e220;
                phi_152_ = _e222;
                break if !(_e70);
            }
        }
        let _e225 = local_1;
        let _e227 = local_2;
        let _e229 = local_3;
        let _e231 = local_4;
        let _e234 = local_5;
        if (_e54.first_primitive < arrayLength((&rows.member))) {
        } else {
            return;
        }
        rows.member[(0u + _e54.first_primitive)] = (_e234 / vec4<f32>(_e225, _e227, _e229, _e231));
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_filter_filter_x_esm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
