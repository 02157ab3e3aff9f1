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

struct type_12 {
    member: abi_FilterParams,
}

struct type_16 {
    member: array<vec4<f32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_12;
@group(0) @binding(1) 
var<storage> rows: type_16;
@group(0) @binding(2) 
var<storage, read_write> vectors: type_16;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_97_: lt_bvh_traverse_Tree;
    var phi_98_: bool;
    var phi_99_: lt_bvh_traverse_Tree;
    var phi_100_: bool;
    var phi_105_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_97_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_98_ = false;
        } else {
            phi_97_ = lt_bvh_traverse_Tree();
            phi_98_ = true;
        }
        let _e53 = phi_97_;
        let _e55 = phi_98_;
        phi_99_ = _e53;
        phi_100_ = _e55;
    } else {
        phi_99_ = lt_bvh_traverse_Tree();
        phi_100_ = true;
    }
    let _e57 = phi_99_;
    let _e59 = phi_100_;
    if _e59 {
        phi_105_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_105_ = _e57;
    }
    let _e64 = phi_105_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn function_() {
    var phi_129_: vec4<f32>;
    var phi_132_: i32;
    var phi_134_: f32;
    var phi_174_: bool;
    var phi_178_: f32;
    var phi_179_: f32;
    var phi_196_: bool;
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_242_: f32;
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_267_: i32;
    var phi_268_: i32;
    var phi_130_: vec4<f32>;
    var phi_133_: i32;
    var phi_135_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: vec4<f32>;

    let _e40 = id_1;
    let _e49 = p.member.map_size;
    let _e50 = lt_shaders_entry_pixel_index(_e40, _e49, _e49);
    if (bitcast<i32>(_e50.root) != 0i) {
        phi_129_ = vec4<f32>(0f, 0f, 0f, 0f);
        phi_132_ = -2i;
        phi_134_ = 0f;
        loop {
            let _e58 = phi_129_;
            let _e60 = phi_132_;
            let _e62 = phi_134_;
            local = _e62;
            local_1 = _e62;
            local_2 = _e62;
            local_3 = _e62;
            local_4 = _e58;
            let _e63 = (_e60 <= 2i);
            if _e63 {
                let _e65 = p.member.sigma;
                if (_e65 > 0f) {
                    let _e68 = (f32(_e60) / _e65);
                    let _e70 = ((-0.5f * _e68) * _e68);
                    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
                        phi_242_ = _e70;
                    } else {
                        if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
                            phi_179_ = _e70;
                        } else {
                            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                                phi_174_ = true;
                            } else {
                                let _e80 = (-87f > _e70);
                                if _e80 {
                                }
                                phi_174_ = _e80;
                            }
                            let _e82 = phi_174_;
                            if _e82 {
                                phi_178_ = -87f;
                            } else {
                                phi_178_ = _e70;
                            }
                            let _e84 = phi_178_;
                            phi_179_ = _e84;
                        }
                        let _e86 = phi_179_;
                        if ((bitcast<u32>(_e86) & 2147483647u) > 2139095040u) {
                            phi_201_ = _e86;
                        } else {
                            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                                phi_196_ = true;
                            } else {
                                let _e93 = (88f < _e86);
                                if _e93 {
                                }
                                phi_196_ = _e93;
                            }
                            let _e95 = phi_196_;
                            if _e95 {
                                phi_200_ = 88f;
                            } else {
                                phi_200_ = _e86;
                            }
                            let _e97 = phi_200_;
                            phi_201_ = _e97;
                        }
                        let _e99 = phi_201_;
                        let _e102 = floor(((_e99 * 1.442695f) + 0.5f));
                        let _e106 = ((_e99 - (_e102 * 0.69314575f)) - (_e102 * 0.0000014286068f));
                        phi_242_ = ((((((((((((((((1f / 5040f) * _e106) + (1f / 720f)) * _e106) + (1f / 120f)) * _e106) + (1f / 24f)) * _e106) + (1f / 6f)) * _e106) + 0.5f) * _e106) + 1f) * _e106) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e102), i32(-2147483648), (_e102 < bitcast<f32>(3472883712u))), 2147483647i, (_e102 > bitcast<f32>(1325400063u))), (_e102 == _e102)) + 127i)) << bitcast<u32>(23i))));
                    }
                    let _e142 = phi_242_;
                    phi_248_ = _e142;
                } else {
                    if (_e60 == 0i) {
                        phi_247_ = 1f;
                    } else {
                        phi_247_ = 0f;
                    }
                    let _e145 = phi_247_;
                    phi_248_ = _e145;
                }
                let _e147 = phi_248_;
                let _e149 = p.member.map_size;
                let _e151 = (bitcast<i32>(_e40.y) + _e60);
                let _e153 = (bitcast<i32>(_e149) - 1i);
                if (0i <= _e153) {
                } else {
                    return;
                }
                if (_e151 < 0i) {
                    phi_268_ = 0i;
                } else {
                    if (_e151 > _e153) {
                        phi_267_ = _e153;
                    } else {
                        phi_267_ = _e151;
                    }
                    let _e158 = phi_267_;
                    phi_268_ = _e158;
                }
                let _e160 = phi_268_;
                let _e163 = p.member.map_size;
                let _e165 = ((bitcast<u32>(_e160) * _e163) + _e40.x);
                if (_e165 < arrayLength((&rows.member))) {
                } else {
                    return;
                }
                let _e169 = rows.member[(0u + _e165)];
                let _e179 = (_e58.x + (_e169.x * _e147));
                let _e184 = vec4<f32>(_e179, _e58.y, _e58.z, _e58.w);
                let _e186 = (_e184.y + (_e169.y * _e147));
                let _e191 = vec4<f32>(_e184.x, _e186, _e184.z, _e184.w);
                let _e193 = (_e191.z + (_e169.z * _e147));
                phi_130_ = vec4<f32>(_e179, _e186, _e193, (vec4<f32>(_e191.x, _e191.y, _e193, _e191.w).w + (_e169.w * _e147)));
                phi_133_ = (_e60 + 1i);
                phi_135_ = (_e62 + _e147);
            } else {
                phi_130_ = vec4<f32>();
                phi_133_ = i32();
                phi_135_ = f32();
            }
            let _e205 = phi_130_;
            let _e207 = phi_133_;
            let _e209 = phi_135_;
            continue;
            continuing {
                phi_129_ = _e205;
                phi_132_ = _e207;
                phi_134_ = _e209;
                break if !(_e63);
            }
        }
        let _e212 = local;
        let _e214 = local_1;
        let _e216 = local_2;
        let _e218 = local_3;
        let _e221 = local_4;
        if (_e50.first_primitive < arrayLength((&vectors.member))) {
        } else {
            return;
        }
        vectors.member[(0u + _e50.first_primitive)] = (_e221 / vec4<f32>(_e212, _e214, _e216, _e218));
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_filter_filter_y_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
