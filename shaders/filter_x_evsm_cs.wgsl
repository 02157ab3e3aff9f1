struct type_8 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
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
var<storage> depths: type_8;
@group(0) @binding(2) 
var<storage, read_write> rows: type_18;

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
        let _e56 = phi_117_;
        let _e58 = phi_118_;
        phi_119_ = _e56;
        phi_120_ = _e58;
    } else {
        phi_119_ = lt_bvh_traverse_Tree();
        phi_120_ = true;
    }
    let _e60 = phi_119_;
    let _e62 = phi_120_;
    if _e62 {
        phi_125_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_125_ = _e60;
    }
    let _e67 = phi_125_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
}

fn _lt_math_evsm_Evsm_negative(param_3: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_581_: bool;
    var phi_585_: f32;

    let _e45 = (*param_3).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_581_ = true;
    } else {
        let _e49 = (42f < _e45);
        if _e49 {
        }
        phi_581_ = _e49;
    }
    let _e51 = phi_581_;
    if _e51 {
        phi_585_ = 42f;
    } else {
        phi_585_ = _e45;
    }
    let _e53 = phi_585_;
    return _e53;
}

fn _lt_math_evsm_Evsm_positive(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_562_: bool;
    var phi_566_: f32;

    let _e45 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_562_ = true;
    } else {
        let _e49 = (42f < _e45);
        if _e49 {
        }
        phi_562_ = _e49;
    }
    let _e51 = phi_562_;
    if _e51 {
        phi_566_ = 42f;
    } else {
        phi_566_ = _e45;
    }
    let _e53 = phi_566_;
    return _e53;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_5: ptr<function, lt_math_Evsm>, param_6: f32) -> vec4<f32> {
    var phi_360_: f32;
    var phi_361_: f32;
    var phi_362_: f32;
    var phi_375_: f32;
    var phi_380_: f32;
    var phi_402_: f32;
    var phi_407_: f32;
    var phi_408_: bool;
    var phi_409_: f32;
    var phi_410_: bool;
    var phi_414_: f32;
    var phi_452_: f32;
    var phi_466_: f32;
    var phi_471_: f32;
    var phi_493_: f32;
    var phi_498_: f32;
    var phi_499_: bool;
    var phi_500_: f32;
    var phi_501_: bool;
    var phi_505_: f32;
    var phi_543_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_362_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_361_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_360_ = 1f;
            } else {
                phi_360_ = param_6;
            }
            let _e51 = phi_360_;
            phi_361_ = _e51;
        }
        let _e53 = phi_361_;
        phi_362_ = _e53;
    }
    let _e55 = phi_362_;
    let _e56 = _lt_math_evsm_Evsm_positive(param_5);
    let _e57 = (_e56 * _e55);
    if ((bitcast<u32>(_e57) & 2147483647u) > 2139095040u) {
        phi_452_ = _e57;
    } else {
        if (_e57 < -87f) {
            phi_375_ = -87f;
        } else {
            phi_375_ = _e57;
        }
        let _e63 = phi_375_;
        if (_e63 > 88f) {
            phi_380_ = 88f;
        } else {
            phi_380_ = _e63;
        }
        let _e66 = phi_380_;
        let _e68 = ((_e66 * 1.442695f) + 0.5f);
        if (_e68 > -8388608f) {
            let _e80 = f32(select(0i, select(select(i32(_e68), i32(-2147483648), (_e68 < bitcast<f32>(3472883712u))), 2147483647i, (_e68 > bitcast<f32>(1325400063u))), (_e68 == _e68)));
            if (_e80 > _e68) {
                phi_402_ = 1f;
            } else {
                phi_402_ = 0f;
            }
            let _e83 = phi_402_;
            if (_e68 < 8388608f) {
                phi_407_ = (_e80 - _e83);
                phi_408_ = false;
            } else {
                phi_407_ = f32();
                phi_408_ = true;
            }
            let _e86 = phi_407_;
            let _e88 = phi_408_;
            phi_409_ = _e86;
            phi_410_ = _e88;
        } else {
            phi_409_ = f32();
            phi_410_ = true;
        }
        let _e90 = phi_409_;
        let _e92 = phi_410_;
        if _e92 {
            phi_414_ = _e68;
        } else {
            phi_414_ = _e90;
        }
        let _e94 = phi_414_;
        let _e98 = ((_e66 - (_e94 * 0.69314575f)) - (_e94 * 0.0000014286068f));
        phi_452_ = ((((((((((((((((1f / 5040f) * _e98) + (1f / 720f)) * _e98) + (1f / 120f)) * _e98) + (1f / 24f)) * _e98) + (1f / 6f)) * _e98) + 0.5f) * _e98) + 1f) * _e98) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e94), i32(-2147483648), (_e94 < bitcast<f32>(3472883712u))), 2147483647i, (_e94 > bitcast<f32>(1325400063u))), (_e94 == _e94)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e134 = phi_452_;
    let _e135 = _lt_math_evsm_Evsm_negative(param_5);
    let _e137 = (-(_e135) * _e55);
    if ((bitcast<u32>(_e137) & 2147483647u) > 2139095040u) {
        phi_543_ = _e137;
    } else {
        if (_e137 < -87f) {
            phi_466_ = -87f;
        } else {
            phi_466_ = _e137;
        }
        let _e143 = phi_466_;
        if (_e143 > 88f) {
            phi_471_ = 88f;
        } else {
            phi_471_ = _e143;
        }
        let _e146 = phi_471_;
        let _e148 = ((_e146 * 1.442695f) + 0.5f);
        if (_e148 > -8388608f) {
            let _e160 = f32(select(0i, select(select(i32(_e148), i32(-2147483648), (_e148 < bitcast<f32>(3472883712u))), 2147483647i, (_e148 > bitcast<f32>(1325400063u))), (_e148 == _e148)));
            if (_e160 > _e148) {
                phi_493_ = 1f;
            } else {
                phi_493_ = 0f;
            }
            let _e163 = phi_493_;
            if (_e148 < 8388608f) {
                phi_498_ = (_e160 - _e163);
                phi_499_ = false;
            } else {
                phi_498_ = f32();
                phi_499_ = true;
            }
            let _e166 = phi_498_;
            let _e168 = phi_499_;
            phi_500_ = _e166;
            phi_501_ = _e168;
        } else {
            phi_500_ = f32();
            phi_501_ = true;
        }
        let _e170 = phi_500_;
        let _e172 = phi_501_;
        if _e172 {
            phi_505_ = _e148;
        } else {
            phi_505_ = _e170;
        }
        let _e174 = phi_505_;
        let _e178 = ((_e146 - (_e174 * 0.69314575f)) - (_e174 * 0.0000014286068f));
        phi_543_ = ((((((((((((((((1f / 5040f) * _e178) + (1f / 720f)) * _e178) + (1f / 120f)) * _e178) + (1f / 24f)) * _e178) + (1f / 6f)) * _e178) + 0.5f) * _e178) + 1f) * _e178) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e174), i32(-2147483648), (_e174 < bitcast<f32>(3472883712u))), 2147483647i, (_e174 > bitcast<f32>(1325400063u))), (_e174 == _e174)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e214 = phi_543_;
    let _e215 = -(_e214);
    return vec4<f32>(_e134, (_e134 * _e134), _e215, (_e215 * _e215));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_7: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_7.x, param_7.y, param_7.z);
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_157_: vec4<f32>;
    var phi_160_: i32;
    var phi_162_: f32;
    var phi_190_: f32;
    var phi_195_: f32;
    var phi_217_: f32;
    var phi_222_: f32;
    var phi_223_: bool;
    var phi_224_: f32;
    var phi_225_: bool;
    var phi_229_: f32;
    var phi_267_: f32;
    var phi_272_: f32;
    var phi_273_: f32;
    var phi_295_: i32;
    var phi_296_: i32;
    var phi_158_: vec4<f32>;
    var phi_161_: i32;
    var phi_163_: f32;
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
        phi_157_ = vec4<f32>(0f, 0f, 0f, 0f);
        phi_160_ = -2i;
        phi_162_ = 0f;
        loop {
            let _e69 = phi_157_;
            let _e71 = phi_160_;
            let _e73 = phi_162_;
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
                        phi_267_ = _e81;
                    } else {
                        if (_e81 < -87f) {
                            phi_190_ = -87f;
                        } else {
                            phi_190_ = _e81;
                        }
                        let _e87 = phi_190_;
                        if (_e87 > 88f) {
                            phi_195_ = 88f;
                        } else {
                            phi_195_ = _e87;
                        }
                        let _e90 = phi_195_;
                        let _e92 = ((_e90 * 1.442695f) + 0.5f);
                        if (_e92 > -8388608f) {
                            let _e104 = f32(select(0i, select(select(i32(_e92), i32(-2147483648), (_e92 < bitcast<f32>(3472883712u))), 2147483647i, (_e92 > bitcast<f32>(1325400063u))), (_e92 == _e92)));
                            if (_e104 > _e92) {
                                phi_217_ = 1f;
                            } else {
                                phi_217_ = 0f;
                            }
                            let _e107 = phi_217_;
                            if (_e92 < 8388608f) {
                                phi_222_ = (_e104 - _e107);
                                phi_223_ = false;
                            } else {
                                phi_222_ = f32();
                                phi_223_ = true;
                            }
                            let _e110 = phi_222_;
                            let _e112 = phi_223_;
                            phi_224_ = _e110;
                            phi_225_ = _e112;
                        } else {
                            phi_224_ = f32();
                            phi_225_ = true;
                        }
                        let _e114 = phi_224_;
                        let _e116 = phi_225_;
                        if _e116 {
                            phi_229_ = _e92;
                        } else {
                            phi_229_ = _e114;
                        }
                        let _e118 = phi_229_;
                        let _e122 = ((_e90 - (_e118 * 0.69314575f)) - (_e118 * 0.0000014286068f));
                        phi_267_ = ((((((((((((((((1f / 5040f) * _e122) + (1f / 720f)) * _e122) + (1f / 120f)) * _e122) + (1f / 24f)) * _e122) + (1f / 6f)) * _e122) + 0.5f) * _e122) + 1f) * _e122) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < bitcast<f32>(3472883712u))), 2147483647i, (_e118 > bitcast<f32>(1325400063u))), (_e118 == _e118)) + 127i)) << bitcast<u32>(23i))));
                    }
                    let _e158 = phi_267_;
                    phi_273_ = _e158;
                } else {
                    if (_e71 == 0i) {
                        phi_272_ = 1f;
                    } else {
                        phi_272_ = 0f;
                    }
                    let _e161 = phi_272_;
                    phi_273_ = _e161;
                }
                let _e163 = phi_273_;
                let _e165 = p.member.map_size;
                let _e168 = p.member.map_size;
                let _e170 = (bitcast<i32>(_e44.x) + _e71);
                let _e172 = (bitcast<i32>(_e168) - 1i);
                if (0i <= _e172) {
                } else {
                    return;
                }
                if (_e170 < 0i) {
                    phi_296_ = 0i;
                } else {
                    if (_e170 > _e172) {
                        phi_295_ = _e172;
                    } else {
                        phi_295_ = _e170;
                    }
                    let _e177 = phi_295_;
                    phi_296_ = _e177;
                }
                let _e179 = phi_296_;
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
                phi_158_ = vec4<f32>(_e196, _e203, _e210, (vec4<f32>(_e208.x, _e208.y, _e210, _e208.w).w + (_e186.w * _e163)));
                phi_161_ = (_e71 + 1i);
                phi_163_ = (_e73 + _e163);
            } else {
                phi_158_ = vec4<f32>();
                phi_161_ = i32();
                phi_163_ = f32();
            }
            let _e222 = phi_158_;
            let _e224 = phi_161_;
            let _e226 = phi_163_;
            continue;
            continuing {
                phi_157_ = _e222;
                phi_160_ = _e224;
                phi_162_ = _e226;
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
