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
    var phi_109_: lt_bvh_traverse_Tree;
    var phi_110_: bool;
    var phi_111_: lt_bvh_traverse_Tree;
    var phi_112_: bool;
    var phi_117_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_109_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_110_ = false;
        } else {
            phi_109_ = lt_bvh_traverse_Tree();
            phi_110_ = true;
        }
        let _e55 = phi_109_;
        let _e57 = phi_110_;
        phi_111_ = _e55;
        phi_112_ = _e57;
    } else {
        phi_111_ = lt_bvh_traverse_Tree();
        phi_112_ = true;
    }
    let _e59 = phi_111_;
    let _e61 = phi_112_;
    if _e61 {
        phi_117_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_117_ = _e59;
    }
    let _e66 = phi_117_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_3: f32) -> vec4<f32> {
    var phi_343_: f32;
    var phi_344_: f32;
    var phi_345_: f32;

    if ((bitcast<u32>(param_3) & 2147483647u) > 2139095040u) {
        phi_345_ = param_3;
    } else {
        if (param_3 < 0f) {
            phi_344_ = 0f;
        } else {
            if (param_3 > 1f) {
                phi_343_ = 1f;
            } else {
                phi_343_ = param_3;
            }
            let _e49 = phi_343_;
            phi_344_ = _e49;
        }
        let _e51 = phi_344_;
        phi_345_ = _e51;
    }
    let _e53 = phi_345_;
    let _e54 = (_e53 * _e53);
    return vec4<f32>(_e53, _e54, (_e54 * _e53), (_e54 * _e54));
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_4: vec4<f32>) -> f32 {
    return param_4.x;
}

fn function_() {
    var phi_144_: vec4<f32>;
    var phi_147_: i32;
    var phi_149_: f32;
    var phi_177_: f32;
    var phi_182_: f32;
    var phi_204_: f32;
    var phi_209_: f32;
    var phi_210_: bool;
    var phi_211_: f32;
    var phi_212_: bool;
    var phi_216_: f32;
    var phi_254_: f32;
    var phi_259_: f32;
    var phi_260_: f32;
    var phi_282_: i32;
    var phi_283_: i32;
    var phi_145_: vec4<f32>;
    var phi_148_: i32;
    var phi_150_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: vec4<f32>;

    let _e42 = id_1;
    let _e51 = p.member.map_size;
    let _e52 = lt_shaders_entry_pixel_index(_e42, _e51, _e51);
    if (bitcast<i32>(_e52.root) != 0i) {
        let _e60 = p.member.test;
        let _e61 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e60);
        phi_144_ = vec4<f32>(0f, 0f, 0f, 0f);
        phi_147_ = -2i;
        phi_149_ = 0f;
        loop {
            let _e63 = phi_144_;
            let _e65 = phi_147_;
            let _e67 = phi_149_;
            local = _e67;
            local_1 = _e67;
            local_2 = _e67;
            local_3 = _e67;
            local_4 = _e63;
            let _e68 = (_e65 <= 2i);
            if _e68 {
                let _e70 = p.member.sigma;
                if (_e70 > 0f) {
                    let _e73 = (f32(_e65) / _e70);
                    let _e75 = ((-0.5f * _e73) * _e73);
                    if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
                        phi_254_ = _e75;
                    } else {
                        if (_e75 < -87f) {
                            phi_177_ = -87f;
                        } else {
                            phi_177_ = _e75;
                        }
                        let _e81 = phi_177_;
                        if (_e81 > 88f) {
                            phi_182_ = 88f;
                        } else {
                            phi_182_ = _e81;
                        }
                        let _e84 = phi_182_;
                        let _e86 = ((_e84 * 1.442695f) + 0.5f);
                        if (_e86 > -8388608f) {
                            let _e98 = f32(select(0i, select(select(i32(_e86), i32(-2147483648), (_e86 < bitcast<f32>(3472883712u))), 2147483647i, (_e86 > bitcast<f32>(1325400063u))), (_e86 == _e86)));
                            if (_e98 > _e86) {
                                phi_204_ = 1f;
                            } else {
                                phi_204_ = 0f;
                            }
                            let _e101 = phi_204_;
                            if (_e86 < 8388608f) {
                                phi_209_ = (_e98 - _e101);
                                phi_210_ = false;
                            } else {
                                phi_209_ = f32();
                                phi_210_ = true;
                            }
                            let _e104 = phi_209_;
                            let _e106 = phi_210_;
                            phi_211_ = _e104;
                            phi_212_ = _e106;
                        } else {
                            phi_211_ = f32();
                            phi_212_ = true;
                        }
                        let _e108 = phi_211_;
                        let _e110 = phi_212_;
                        if _e110 {
                            phi_216_ = _e86;
                        } else {
                            phi_216_ = _e108;
                        }
                        let _e112 = phi_216_;
                        let _e116 = ((_e84 - (_e112 * 0.69314575f)) - (_e112 * 0.0000014286068f));
                        phi_254_ = ((((((((((((((((1f / 5040f) * _e116) + (1f / 720f)) * _e116) + (1f / 120f)) * _e116) + (1f / 24f)) * _e116) + (1f / 6f)) * _e116) + 0.5f) * _e116) + 1f) * _e116) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e112), i32(-2147483648), (_e112 < bitcast<f32>(3472883712u))), 2147483647i, (_e112 > bitcast<f32>(1325400063u))), (_e112 == _e112)) + 127i)) << bitcast<u32>(23i))));
                    }
                    let _e152 = phi_254_;
                    phi_260_ = _e152;
                } else {
                    if (_e65 == 0i) {
                        phi_259_ = 1f;
                    } else {
                        phi_259_ = 0f;
                    }
                    let _e155 = phi_259_;
                    phi_260_ = _e155;
                }
                let _e157 = phi_260_;
                let _e159 = p.member.map_size;
                let _e162 = p.member.map_size;
                let _e164 = (bitcast<i32>(_e42.x) + _e65);
                let _e166 = (bitcast<i32>(_e162) - 1i);
                if (0i <= _e166) {
                } else {
                    return;
                }
                if (_e164 < 0i) {
                    phi_283_ = 0i;
                } else {
                    if (_e164 > _e166) {
                        phi_282_ = _e166;
                    } else {
                        phi_282_ = _e164;
                    }
                    let _e171 = phi_282_;
                    phi_283_ = _e171;
                }
                let _e173 = phi_283_;
                let _e175 = ((_e42.y * _e159) + bitcast<u32>(_e173));
                if (_e175 < arrayLength((&depths.member))) {
                } else {
                    return;
                }
                let _e179 = depths.member[(0u + _e175)];
                let _e180 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e179);
                let _e190 = (_e63.x + (_e180.x * _e157));
                let _e195 = vec4<f32>(_e190, _e63.y, _e63.z, _e63.w);
                let _e197 = (_e195.y + (_e180.y * _e157));
                let _e202 = vec4<f32>(_e195.x, _e197, _e195.z, _e195.w);
                let _e204 = (_e202.z + (_e180.z * _e157));
                phi_145_ = vec4<f32>(_e190, _e197, _e204, (vec4<f32>(_e202.x, _e202.y, _e204, _e202.w).w + (_e180.w * _e157)));
                phi_148_ = (_e65 + 1i);
                phi_150_ = (_e67 + _e157);
            } else {
                phi_145_ = vec4<f32>();
                phi_148_ = i32();
                phi_150_ = f32();
            }
            let _e216 = phi_145_;
            let _e218 = phi_148_;
            let _e220 = phi_150_;
            continue;
            continuing {
                phi_144_ = _e216;
                phi_147_ = _e218;
                phi_149_ = _e220;
                break if !(_e68);
            }
        }
        let _e223 = local;
        let _e225 = local_1;
        let _e227 = local_2;
        let _e229 = local_3;
        let _e232 = local_4;
        if (_e52.first_primitive < arrayLength((&rows.member))) {
        } else {
            return;
        }
        rows.member[(0u + _e52.first_primitive)] = (_e232 / vec4<f32>(_e223, _e225, _e227, _e229));
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_filter_filter_x_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
