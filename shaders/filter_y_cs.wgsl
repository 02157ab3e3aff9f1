struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_12 {
    member: array<vec4<f32>>,
}

struct abi_FilterParams {
    test: vec4<f32>,
    map_size: u32,
    sigma: f32,
    pad: vec2<u32>,
}

struct type_16 {
    member: abi_FilterParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_16;
@group(0) @binding(1) 
var<storage> rows: type_12;
@group(0) @binding(2) 
var<storage, read_write> vectors: type_12;

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
        let _e55 = phi_97_;
        let _e57 = phi_98_;
        phi_99_ = _e55;
        phi_100_ = _e57;
    } else {
        phi_99_ = lt_bvh_traverse_Tree();
        phi_100_ = true;
    }
    let _e59 = phi_99_;
    let _e61 = phi_100_;
    if _e61 {
        phi_105_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_105_ = _e59;
    }
    let _e66 = phi_105_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn function_() {
    var phi_129_: vec4<f32>;
    var phi_132_: i32;
    var phi_134_: f32;
    var phi_162_: f32;
    var phi_167_: f32;
    var phi_189_: f32;
    var phi_194_: f32;
    var phi_195_: bool;
    var phi_196_: f32;
    var phi_197_: bool;
    var phi_201_: f32;
    var phi_239_: f32;
    var phi_244_: f32;
    var phi_245_: f32;
    var phi_264_: i32;
    var phi_265_: i32;
    var phi_130_: vec4<f32>;
    var phi_133_: i32;
    var phi_135_: f32;
    var local: f32;
    var local_1: f32;
    var local_2: f32;
    var local_3: f32;
    var local_4: vec4<f32>;

    let _e42 = id_1;
    let _e51 = p.member.map_size;
    let _e52 = lt_shaders_entry_pixel_index(_e42, _e51, _e51);
    if (bitcast<i32>(_e52.root) != 0i) {
        phi_129_ = vec4<f32>(0f, 0f, 0f, 0f);
        phi_132_ = -2i;
        phi_134_ = 0f;
        loop {
            let _e60 = phi_129_;
            let _e62 = phi_132_;
            let _e64 = phi_134_;
            local = _e64;
            local_1 = _e64;
            local_2 = _e64;
            local_3 = _e64;
            local_4 = _e60;
            let _e65 = (_e62 <= 2i);
            if _e65 {
                let _e67 = p.member.sigma;
                if (_e67 > 0f) {
                    let _e70 = (f32(_e62) / _e67);
                    let _e72 = ((-0.5f * _e70) * _e70);
                    if ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u) {
                        phi_239_ = _e72;
                    } else {
                        if (_e72 < -87f) {
                            phi_162_ = -87f;
                        } else {
                            phi_162_ = _e72;
                        }
                        let _e78 = phi_162_;
                        if (_e78 > 88f) {
                            phi_167_ = 88f;
                        } else {
                            phi_167_ = _e78;
                        }
                        let _e81 = phi_167_;
                        let _e83 = ((_e81 * 1.442695f) + 0.5f);
                        if (_e83 > -8388608f) {
                            let _e95 = f32(select(0i, select(select(i32(_e83), i32(-2147483648), (_e83 < bitcast<f32>(3472883712u))), 2147483647i, (_e83 > bitcast<f32>(1325400063u))), (_e83 == _e83)));
                            if (_e95 > _e83) {
                                phi_189_ = 1f;
                            } else {
                                phi_189_ = 0f;
                            }
                            let _e98 = phi_189_;
                            if (_e83 < 8388608f) {
                                phi_194_ = (_e95 - _e98);
                                phi_195_ = false;
                            } else {
                                phi_194_ = f32();
                                phi_195_ = true;
                            }
                            let _e101 = phi_194_;
                            let _e103 = phi_195_;
                            phi_196_ = _e101;
                            phi_197_ = _e103;
                        } else {
                            phi_196_ = f32();
                            phi_197_ = true;
                        }
                        let _e105 = phi_196_;
                        let _e107 = phi_197_;
                        if _e107 {
                            phi_201_ = _e83;
                        } else {
                            phi_201_ = _e105;
                        }
                        let _e109 = phi_201_;
                        let _e113 = ((_e81 - (_e109 * 0.69314575f)) - (_e109 * 0.0000014286068f));
                        phi_239_ = ((((((((((((((((1f / 5040f) * _e113) + (1f / 720f)) * _e113) + (1f / 120f)) * _e113) + (1f / 24f)) * _e113) + (1f / 6f)) * _e113) + 0.5f) * _e113) + 1f) * _e113) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e109), i32(-2147483648), (_e109 < bitcast<f32>(3472883712u))), 2147483647i, (_e109 > bitcast<f32>(1325400063u))), (_e109 == _e109)) + 127i)) << bitcast<u32>(23i))));
                    }
                    let _e149 = phi_239_;
                    phi_245_ = _e149;
                } else {
                    if (_e62 == 0i) {
                        phi_244_ = 1f;
                    } else {
                        phi_244_ = 0f;
                    }
                    let _e152 = phi_244_;
                    phi_245_ = _e152;
                }
                let _e154 = phi_245_;
                let _e156 = p.member.map_size;
                let _e158 = (bitcast<i32>(_e42.y) + _e62);
                let _e160 = (bitcast<i32>(_e156) - 1i);
                if (0i <= _e160) {
                } else {
                    return;
                }
                if (_e158 < 0i) {
                    phi_265_ = 0i;
                } else {
                    if (_e158 > _e160) {
                        phi_264_ = _e160;
                    } else {
                        phi_264_ = _e158;
                    }
                    let _e165 = phi_264_;
                    phi_265_ = _e165;
                }
                let _e167 = phi_265_;
                let _e170 = p.member.map_size;
                let _e172 = ((bitcast<u32>(_e167) * _e170) + _e42.x);
                if (_e172 < arrayLength((&rows.member))) {
                } else {
                    return;
                }
                let _e176 = rows.member[(0u + _e172)];
                let _e186 = (_e60.x + (_e176.x * _e154));
                let _e191 = vec4<f32>(_e186, _e60.y, _e60.z, _e60.w);
                let _e193 = (_e191.y + (_e176.y * _e154));
                let _e198 = vec4<f32>(_e191.x, _e193, _e191.z, _e191.w);
                let _e200 = (_e198.z + (_e176.z * _e154));
                phi_130_ = vec4<f32>(_e186, _e193, _e200, (vec4<f32>(_e198.x, _e198.y, _e200, _e198.w).w + (_e176.w * _e154)));
                phi_133_ = (_e62 + 1i);
                phi_135_ = (_e64 + _e154);
            } else {
                phi_130_ = vec4<f32>();
                phi_133_ = i32();
                phi_135_ = f32();
            }
            let _e212 = phi_130_;
            let _e214 = phi_133_;
            let _e216 = phi_135_;
            continue;
            continuing {
                phi_129_ = _e212;
                phi_132_ = _e214;
                phi_134_ = _e216;
                break if !(_e65);
            }
        }
        let _e219 = local;
        let _e221 = local_1;
        let _e223 = local_2;
        let _e225 = local_3;
        let _e228 = local_4;
        if (_e52.first_primitive < arrayLength((&vectors.member))) {
        } else {
            return;
        }
        vectors.member[(0u + _e52.first_primitive)] = (_e228 / vec4<f32>(_e219, _e221, _e223, _e225));
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_filter_filter_y_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
