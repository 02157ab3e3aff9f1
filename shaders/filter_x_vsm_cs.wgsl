struct type_14 {
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

struct type_18 {
    member: abi_FilterParams,
}

struct type_22 {
    member: array<vec4<f32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_18;
@group(0) @binding(1) 
var<storage> depths: type_14;
@group(0) @binding(2) 
var<storage, read_write> rows: type_22;

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
        let _e53 = phi_109_;
        let _e55 = phi_110_;
        phi_111_ = _e53;
        phi_112_ = _e55;
    } else {
        phi_111_ = lt_bvh_traverse_Tree();
        phi_112_ = true;
    }
    let _e57 = phi_111_;
    let _e59 = phi_112_;
    if _e59 {
        phi_117_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_117_ = _e57;
    }
    let _e64 = phi_117_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_3: f32) -> vec4<f32> {
    var phi_346_: f32;
    var phi_347_: f32;
    var phi_348_: f32;

    if ((bitcast<u32>(param_3) & 2147483647u) > 2139095040u) {
        phi_348_ = param_3;
    } else {
        if (param_3 < 0f) {
            phi_347_ = 0f;
        } else {
            if (param_3 > 1f) {
                phi_346_ = 1f;
            } else {
                phi_346_ = param_3;
            }
            let _e47 = phi_346_;
            phi_347_ = _e47;
        }
        let _e49 = phi_347_;
        phi_348_ = _e49;
    }
    let _e51 = phi_348_;
    return vec4<f32>(_e51, (_e51 * _e51), 0f, 0f);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_4: vec4<f32>) -> f32 {
    return param_4.x;
}

fn function_() {
    var phi_144_: vec4<f32>;
    var phi_147_: i32;
    var phi_149_: f32;
    var phi_189_: bool;
    var phi_193_: f32;
    var phi_194_: f32;
    var phi_211_: bool;
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_257_: f32;
    var phi_262_: f32;
    var phi_263_: f32;
    var phi_285_: i32;
    var phi_286_: i32;
    var phi_145_: vec4<f32>;
    var phi_148_: i32;
    var phi_150_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: vec4<f32>;

    let _e40 = id_1;
    let _e49 = p.member.map_size;
    let _e50 = lt_shaders_entry_pixel_index(_e40, _e49, _e49);
    if (bitcast<i32>(_e50.root) != 0i) {
        let _e58 = p.member.test;
        let _e59 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e58);
        phi_144_ = vec4<f32>(0f, 0f, 0f, 0f);
        phi_147_ = -2i;
        phi_149_ = 0f;
        loop {
            let _e61 = phi_144_;
            let _e63 = phi_147_;
            let _e65 = phi_149_;
            local = _e65;
            local_1 = _e65;
            local_2 = _e65;
            local_3 = _e65;
            local_4 = _e61;
            let _e66 = (_e63 <= 2i);
            if _e66 {
                let _e68 = p.member.sigma;
                if (_e68 > 0f) {
                    let _e71 = (f32(_e63) / _e68);
                    let _e73 = ((-0.5f * _e71) * _e71);
                    if ((bitcast<u32>(_e73) & 2147483647u) > 2139095040u) {
                        phi_257_ = _e73;
                    } else {
                        if ((bitcast<u32>(_e73) & 2147483647u) > 2139095040u) {
                            phi_194_ = _e73;
                        } else {
                            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                                phi_189_ = true;
                            } else {
                                let _e83 = (-87f > _e73);
                                if _e83 {
                                }
                                phi_189_ = _e83;
                            }
                            let _e85 = phi_189_;
                            if _e85 {
                                phi_193_ = -87f;
                            } else {
                                phi_193_ = _e73;
                            }
                            let _e87 = phi_193_;
                            phi_194_ = _e87;
                        }
                        let _e89 = phi_194_;
                        if ((bitcast<u32>(_e89) & 2147483647u) > 2139095040u) {
                            phi_216_ = _e89;
                        } else {
                            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                                phi_211_ = true;
                            } else {
                                let _e96 = (88f < _e89);
                                if _e96 {
                                }
                                phi_211_ = _e96;
                            }
                            let _e98 = phi_211_;
                            if _e98 {
                                phi_215_ = 88f;
                            } else {
                                phi_215_ = _e89;
                            }
                            let _e100 = phi_215_;
                            phi_216_ = _e100;
                        }
                        let _e102 = phi_216_;
                        let _e105 = floor(((_e102 * 1.442695f) + 0.5f));
                        let _e109 = ((_e102 - (_e105 * 0.69314575f)) - (_e105 * 0.0000014286068f));
                        phi_257_ = ((((((((((((((((1f / 5040f) * _e109) + (1f / 720f)) * _e109) + (1f / 120f)) * _e109) + (1f / 24f)) * _e109) + (1f / 6f)) * _e109) + 0.5f) * _e109) + 1f) * _e109) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e105), i32(-2147483648), (_e105 < bitcast<f32>(3472883712u))), 2147483647i, (_e105 > bitcast<f32>(1325400063u))), (_e105 == _e105)) + 127i)) << bitcast<u32>(23i))));
                    }
                    let _e145 = phi_257_;
                    phi_263_ = _e145;
                } else {
                    if (_e63 == 0i) {
                        phi_262_ = 1f;
                    } else {
                        phi_262_ = 0f;
                    }
                    let _e148 = phi_262_;
                    phi_263_ = _e148;
                }
                let _e150 = phi_263_;
                let _e152 = p.member.map_size;
                let _e155 = p.member.map_size;
                let _e157 = (bitcast<i32>(_e40.x) + _e63);
                let _e159 = (bitcast<i32>(_e155) - 1i);
                if (0i <= _e159) {
                } else {
                    return;
                }
                if (_e157 < 0i) {
                    phi_286_ = 0i;
                } else {
                    if (_e157 > _e159) {
                        phi_285_ = _e159;
                    } else {
                        phi_285_ = _e157;
                    }
                    let _e164 = phi_285_;
                    phi_286_ = _e164;
                }
                let _e166 = phi_286_;
                let _e168 = ((_e40.y * _e152) + bitcast<u32>(_e166));
                if (_e168 < arrayLength((&depths.member))) {
                } else {
                    return;
                }
                let _e172 = depths.member[(0u + _e168)];
                let _e173 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e172);
                let _e183 = (_e61.x + (_e173.x * _e150));
                let _e188 = vec4<f32>(_e183, _e61.y, _e61.z, _e61.w);
                let _e190 = (_e188.y + (_e173.y * _e150));
                let _e195 = vec4<f32>(_e188.x, _e190, _e188.z, _e188.w);
                let _e197 = (_e195.z + (_e173.z * _e150));
                phi_145_ = vec4<f32>(_e183, _e190, _e197, (vec4<f32>(_e195.x, _e195.y, _e197, _e195.w).w + (_e173.w * _e150)));
                phi_148_ = (_e63 + 1i);
                phi_150_ = (_e65 + _e150);
            } else {
                phi_145_ = vec4<f32>();
                phi_148_ = i32();
                phi_150_ = f32();
            }
            let _e209 = phi_145_;
            let _e211 = phi_148_;
            let _e213 = phi_150_;
            continue;
            continuing {
                phi_144_ = _e209;
                phi_147_ = _e211;
                phi_149_ = _e213;
                break if !(_e66);
            }
        }
        let _e216 = local;
        let _e218 = local_1;
        let _e220 = local_2;
        let _e222 = local_3;
        let _e225 = local_4;
        if (_e50.first_primitive < arrayLength((&rows.member))) {
        } else {
            return;
        }
        rows.member[(0u + _e50.first_primitive)] = (_e225 / vec4<f32>(_e216, _e218, _e220, _e222));
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_filter_filter_x_vsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
