struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_17 {
    member: array<abi_Sample>,
}

struct type_21 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_29 {
    member: abi_ShadowParams,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_17;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_29;
@group(0) @binding(2) 
var<storage> map: type_21;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_21;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_130_: lt_bvh_traverse_Tree;
    var phi_131_: bool;
    var phi_132_: lt_bvh_traverse_Tree;
    var phi_133_: bool;
    var phi_138_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_130_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_131_ = false;
        } else {
            phi_130_ = lt_bvh_traverse_Tree();
            phi_131_ = true;
        }
        let _e46 = phi_130_;
        let _e48 = phi_131_;
        phi_132_ = _e46;
        phi_133_ = _e48;
    } else {
        phi_132_ = lt_bvh_traverse_Tree();
        phi_133_ = true;
    }
    let _e50 = phi_132_;
    let _e52 = phi_133_;
    if _e52 {
        phi_138_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_138_ = _e50;
    }
    let _e57 = phi_138_;
    return lt_bvh_traverse_Tree(_e57.root, _e57.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_161_: f32;
    var phi_162_: f32;
    var phi_163_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_163_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_162_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_161_ = 1f;
            } else {
                phi_161_ = param_4;
            }
            let _e40 = phi_161_;
            phi_162_ = _e40;
        }
        let _e42 = phi_162_;
        phi_163_ = _e42;
    }
    let _e44 = phi_163_;
    let _e45 = (_e44 * _e44);
    return vec4<f32>(_e44, _e45, (_e45 * _e44), (_e45 * _e45));
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_709_: f32;
    var phi_710_: f32;
    var phi_711_: f32;
    var phi_717_: bool;
    var phi_739_: f32;
    var phi_740_: f32;
    var phi_741_: f32;
    var phi_742_: f32;
    var phi_743_: bool;
    var phi_744_: f32;
    var phi_745_: bool;
    var phi_783_: vec2<f32>;
    var phi_817_: f32;
    var phi_818_: f32;
    var phi_819_: f32;
    var phi_848_: f32;
    var phi_849_: f32;
    var phi_850_: f32;
    var phi_854_: f32;
    var phi_855_: f32;
    var phi_856_: f32;
    var phi_857_: f32;

    let _e36 = (*param_5);
    let _e37 = (1f - _e36);
    let _e46 = (0.5f * _e36);
    let _e47 = ((param_6.x * _e37) + _e46);
    let _e48 = ((param_6.y * _e37) + _e46);
    let _e50 = ((param_6.w * _e37) + _e46);
    let _e52 = (_e48 - (_e47 * _e47));
    let _e54 = (((param_6.z * _e37) + _e46) - (_e47 * _e48));
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_711_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_710_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_709_ = 1f;
            } else {
                phi_709_ = param_7;
            }
            let _e66 = phi_709_;
            phi_710_ = _e66;
        }
        let _e68 = phi_710_;
        phi_711_ = _e68;
    }
    let _e70 = phi_711_;
    if (_e47 == _e50) {
        phi_717_ = (_e47 > 0.5f);
    } else {
        phi_717_ = false;
    }
    let _e74 = phi_717_;
    if _e74 {
        if (_e70 > 0f) {
            if ((bitcast<u32>(_e47) & 2147483647u) > 2139095040u) {
                phi_741_ = _e47;
            } else {
                if (_e47 < 0f) {
                    phi_740_ = 0f;
                } else {
                    if (_e47 > 1f) {
                        phi_739_ = 1f;
                    } else {
                        phi_739_ = _e47;
                    }
                    let _e82 = phi_739_;
                    phi_740_ = _e82;
                }
                let _e84 = phi_740_;
                phi_741_ = _e84;
            }
            let _e86 = phi_741_;
            phi_742_ = _e86;
            phi_743_ = false;
        } else {
            phi_742_ = f32();
            phi_743_ = true;
        }
        let _e88 = phi_742_;
        let _e90 = phi_743_;
        phi_744_ = _e88;
        phi_745_ = _e90;
    } else {
        phi_744_ = f32();
        phi_745_ = true;
    }
    let _e92 = phi_744_;
    let _e94 = phi_745_;
    if _e94 {
        let _e95 = (_e54 / _e52);
        let _e96 = (_e70 - _e47);
        let _e102 = (((((_e70 * _e70) - _e48) - (_e95 * _e96)) * _e52) / (((_e50 - (_e48 * _e48)) * _e52) - (_e54 * _e54)));
        let _e105 = ((_e96 / _e52) - (_e95 * _e102));
        let _e111 = ((0.5f * _e105) / _e102);
        let _e114 = ((_e111 * _e111) - (((1f - (_e105 * _e47)) - (_e102 * _e48)) / _e102));
        if (_e114 >= 0f) {
            let _e116 = sqrt(_e114);
            phi_783_ = vec2<f32>((-(_e111) - _e116), (-(_e111) + _e116));
        } else {
            phi_783_ = vec2(bitcast<f32>((bitcast<u32>(_e114) | 2143289344u)));
        }
        let _e127 = phi_783_;
        if (_e70 <= _e127.x) {
            phi_856_ = 1f;
        } else {
            if (_e70 > _e127.y) {
                let _e140 = (((_e48 - (_e47 * (_e127.x + _e127.y))) + (_e127.x * _e127.y)) / ((_e70 - _e127.x) * (_e70 - _e127.y)));
                if ((bitcast<u32>(_e140) & 2147483647u) > 2139095040u) {
                    phi_819_ = _e140;
                } else {
                    if (_e140 < 0f) {
                        phi_818_ = 0f;
                    } else {
                        if (_e140 > 1f) {
                            phi_817_ = 1f;
                        } else {
                            phi_817_ = _e140;
                        }
                        let _e147 = phi_817_;
                        phi_818_ = _e147;
                    }
                    let _e149 = phi_818_;
                    phi_819_ = _e149;
                }
                let _e151 = phi_819_;
                phi_855_ = _e151;
            } else {
                if (_e70 > _e127.x) {
                    let _e162 = (1f - (((_e48 - (_e47 * (_e70 + _e127.y))) + (_e70 * _e127.y)) / ((_e127.x - _e70) * (_e127.x - _e127.y))));
                    if ((bitcast<u32>(_e162) & 2147483647u) > 2139095040u) {
                        phi_850_ = _e162;
                    } else {
                        if (_e162 < 0f) {
                            phi_849_ = 0f;
                        } else {
                            if (_e162 > 1f) {
                                phi_848_ = 1f;
                            } else {
                                phi_848_ = _e162;
                            }
                            let _e169 = phi_848_;
                            phi_849_ = _e169;
                        }
                        let _e171 = phi_849_;
                        phi_850_ = _e171;
                    }
                    let _e173 = phi_850_;
                    phi_854_ = _e173;
                } else {
                    phi_854_ = bitcast<f32>((bitcast<u32>(_e127.x) | 2143289344u));
                }
                let _e178 = phi_854_;
                phi_855_ = _e178;
            }
            let _e180 = phi_855_;
            phi_856_ = _e180;
        }
        let _e182 = phi_856_;
        phi_857_ = _e182;
    } else {
        phi_857_ = _e92;
    }
    let _e184 = phi_857_;
    return _e184;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_8: ptr<function, f32>, param_9: vec4<f32>, param_10: vec4<f32>, param_11: f32) -> f32 {
    let _e38 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_9.x);
    let _e40 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_9.y);
    let _e42 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_9.z);
    let _e44 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_9.w);
    let _e94 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_8, vec4<f32>(((((_e38.x * param_10.x) + (_e40.x * param_10.y)) + (_e42.x * param_10.z)) + (_e44.x * param_10.w)), ((((_e38.y * param_10.x) + (_e40.y * param_10.y)) + (_e42.y * param_10.z)) + (_e44.y * param_10.w)), ((((_e38.z * param_10.x) + (_e40.z * param_10.y)) + (_e42.z * param_10.z)) + (_e44.z * param_10.w)), ((((_e38.w * param_10.x) + (_e40.w * param_10.y)) + (_e42.w * param_10.z)) + (_e44.w * param_10.w))), param_11);
    return _e94;
}

fn function_() {
    var local: f32;
    var phi_221_: bool;
    var phi_222_: bool;
    var phi_223_: bool;
    var phi_224_: bool;
    var phi_228_: bool;
    var phi_272_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_276_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_353_: bool;
    var phi_362_: bool;
    var phi_371_: bool;
    var phi_372_: bool;
    var phi_373_: bool;
    var phi_374_: bool;
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_377_: bool;
    var phi_381_: bool;
    var phi_417_: f32;
    var phi_422_: f32;
    var phi_423_: bool;
    var phi_424_: f32;
    var phi_425_: bool;
    var phi_429_: f32;
    var phi_449_: f32;
    var phi_454_: f32;
    var phi_455_: bool;
    var phi_456_: f32;
    var phi_457_: bool;
    var phi_461_: f32;
    var phi_507_: i32;
    var phi_512_: i32;
    var phi_517_: i32;
    var phi_522_: i32;
    var phi_531_: i32;
    var phi_536_: i32;
    var phi_541_: i32;
    var phi_546_: i32;
    var phi_587_: evaluate_Verdict;
    var phi_588_: evaluate_Verdict;
    var phi_589_: bool;
    var phi_590_: evaluate_Verdict;
    var phi_591_: evaluate_Verdict;
    var phi_592_: bool;
    var phi_596_: evaluate_Verdict;

    let _e34 = id_1;
    let _e41 = arrayLength((&map.member));
    let _e47 = p.member.size[0u];
    let _e49 = p.member.size[1u];
    let _e50 = lt_shaders_entry_pixel_index(_e34, _e47, _e49);
    if (bitcast<i32>(_e50.root) != 0i) {
        if (_e50.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e59 = p.member.light;
        let _e62 = samples.member[(0u + _e50.first_primitive)].normal[0u];
        let _e64 = global[0u];
        if (_e62 == _e64) {
            let _e67 = samples.member[(0u + _e50.first_primitive)].normal[1u];
            let _e69 = global[1u];
            if (_e67 == _e69) {
                let _e72 = samples.member[(0u + _e50.first_primitive)].normal[2u];
                let _e74 = global[2u];
                phi_221_ = (_e72 == _e74);
                phi_222_ = false;
            } else {
                phi_221_ = bool();
                phi_222_ = true;
            }
            let _e77 = phi_221_;
            let _e79 = phi_222_;
            phi_223_ = _e77;
            phi_224_ = _e79;
        } else {
            phi_223_ = bool();
            phi_224_ = true;
        }
        let _e81 = phi_223_;
        let _e83 = phi_224_;
        if _e83 {
            phi_228_ = false;
        } else {
            phi_228_ = _e81;
        }
        let _e85 = phi_228_;
        if !(_e85) {
            let _e88 = samples.member[(0u + _e50.first_primitive)].normal;
            let _e90 = samples.member[(0u + _e50.first_primitive)].position;
            if ((((_e88.x * (_e59.x - (_e90.x * _e59.w))) + (_e88.y * (_e59.y - (_e90.y * _e59.w)))) + (_e88.z * (_e59.z - (_e90.z * _e59.w)))) > 0f) {
                let _e114 = samples.member[(0u + _e50.first_primitive)].flags;
                let _e122 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e122.unnamed.visibility, false), _e122.unnamed_1);
                phi_272_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e128.unnamed, ((_e114 & 1u) == 0u));
            } else {
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_272_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, true);
            }
            let _e148 = phi_272_;
            phi_276_ = _e148;
        } else {
            let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
            phi_276_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
        }
        let _e165 = phi_276_;
        if _e165.unnamed_1 {
            phi_590_ = evaluate_Verdict(_e165.unnamed.visibility, _e165.unnamed.is_doubted);
            phi_591_ = evaluate_Verdict();
            phi_592_ = true;
        } else {
            let _e173 = samples.member[(0u + _e50.first_primitive)].position;
            let _e179 = p.member.projection.row_w;
            let _e190 = ((((_e179.x * _e173.x) + (_e179.y * _e173.y)) + (_e179.z * _e173.z)) + (_e179.w * 1f));
            let _e192 = p.member.projection.row_x;
            let _e204 = (((((_e192.x * _e173.x) + (_e192.y * _e173.y)) + (_e192.z * _e173.z)) + (_e192.w * 1f)) / _e190);
            let _e206 = p.member.projection.row_y;
            let _e218 = (((((_e206.x * _e173.x) + (_e206.y * _e173.y)) + (_e206.z * _e173.z)) + (_e206.w * 1f)) / _e190);
            let _e220 = p.member.projection.row_z;
            let _e231 = ((((_e220.x * _e173.x) + (_e220.y * _e173.y)) + (_e220.z * _e173.z)) + (_e220.w * 1f));
            if (_e190 > 0f) {
                if (_e204 >= 0f) {
                    phi_353_ = (_e204 <= 1f);
                } else {
                    phi_353_ = false;
                }
                let _e236 = phi_353_;
                if _e236 {
                    if (_e218 >= 0f) {
                        phi_362_ = (_e218 <= 1f);
                    } else {
                        phi_362_ = false;
                    }
                    let _e240 = phi_362_;
                    if _e240 {
                        if (_e231 >= 0f) {
                            phi_371_ = (_e231 <= 1f);
                        } else {
                            phi_371_ = false;
                        }
                        let _e244 = phi_371_;
                        phi_372_ = _e244;
                        phi_373_ = false;
                    } else {
                        phi_372_ = bool();
                        phi_373_ = true;
                    }
                    let _e246 = phi_372_;
                    let _e248 = phi_373_;
                    phi_374_ = _e246;
                    phi_375_ = _e248;
                } else {
                    phi_374_ = bool();
                    phi_375_ = true;
                }
                let _e250 = phi_374_;
                let _e252 = phi_375_;
                phi_376_ = _e250;
                phi_377_ = _e252;
            } else {
                phi_376_ = bool();
                phi_377_ = true;
            }
            let _e254 = phi_376_;
            let _e256 = phi_377_;
            if _e256 {
                phi_381_ = false;
            } else {
                phi_381_ = _e254;
            }
            let _e258 = phi_381_;
            if _e258 {
                let _e260 = p.member.map_size;
                let _e261 = f32(_e260);
                let _e264 = ((_e204 * _e261) - 0.5f);
                let _e265 = ((_e218 * _e261) - 0.5f);
                if (_e264 > -8388608f) {
                    let _e277 = f32(select(0i, select(select(i32(_e264), i32(-2147483648), (_e264 < bitcast<f32>(3472883712u))), 2147483647i, (_e264 > bitcast<f32>(1325400063u))), (_e264 == _e264)));
                    if (_e277 > _e264) {
                        phi_417_ = 1f;
                    } else {
                        phi_417_ = 0f;
                    }
                    let _e280 = phi_417_;
                    if (_e264 < 8388608f) {
                        phi_422_ = (_e277 - _e280);
                        phi_423_ = false;
                    } else {
                        phi_422_ = f32();
                        phi_423_ = true;
                    }
                    let _e283 = phi_422_;
                    let _e285 = phi_423_;
                    phi_424_ = _e283;
                    phi_425_ = _e285;
                } else {
                    phi_424_ = f32();
                    phi_425_ = true;
                }
                let _e287 = phi_424_;
                let _e289 = phi_425_;
                if _e289 {
                    phi_429_ = _e264;
                } else {
                    phi_429_ = _e287;
                }
                let _e291 = phi_429_;
                if (_e265 > -8388608f) {
                    let _e303 = f32(select(0i, select(select(i32(_e265), i32(-2147483648), (_e265 < bitcast<f32>(3472883712u))), 2147483647i, (_e265 > bitcast<f32>(1325400063u))), (_e265 == _e265)));
                    if (_e303 > _e265) {
                        phi_449_ = 1f;
                    } else {
                        phi_449_ = 0f;
                    }
                    let _e306 = phi_449_;
                    if (_e265 < 8388608f) {
                        phi_454_ = (_e303 - _e306);
                        phi_455_ = false;
                    } else {
                        phi_454_ = f32();
                        phi_455_ = true;
                    }
                    let _e309 = phi_454_;
                    let _e311 = phi_455_;
                    phi_456_ = _e309;
                    phi_457_ = _e311;
                } else {
                    phi_456_ = f32();
                    phi_457_ = true;
                }
                let _e313 = phi_456_;
                let _e315 = phi_457_;
                if _e315 {
                    phi_461_ = _e265;
                } else {
                    phi_461_ = _e313;
                }
                let _e317 = phi_461_;
                let _e318 = (_e264 - _e291);
                let _e319 = (_e265 - _e317);
                let _e328 = select(0i, select(select(i32(_e291), i32(-2147483648), (_e291 < bitcast<f32>(3472883712u))), 2147483647i, (_e291 > bitcast<f32>(1325400063u))), (_e291 == _e291));
                let _e337 = select(0i, select(select(i32(_e317), i32(-2147483648), (_e317 < bitcast<f32>(3472883712u))), 2147483647i, (_e317 > bitcast<f32>(1325400063u))), (_e317 == _e317));
                let _e348 = p.member.test;
                let _e349 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e348);
                let _e351 = p.member.map_size;
                local = _e349;
                let _e353 = (bitcast<i32>(_e351) - 1i);
                if (_e328 > 0i) {
                    phi_507_ = _e328;
                } else {
                    phi_507_ = 0i;
                }
                let _e356 = phi_507_;
                if (_e337 > 0i) {
                    phi_512_ = _e337;
                } else {
                    phi_512_ = 0i;
                }
                let _e359 = phi_512_;
                if (_e356 < _e353) {
                    phi_517_ = _e356;
                } else {
                    phi_517_ = _e353;
                }
                let _e362 = phi_517_;
                if (_e359 < _e353) {
                    phi_522_ = _e359;
                } else {
                    phi_522_ = _e353;
                }
                let _e365 = phi_522_;
                let _e366 = bitcast<u32>(_e362);
                let _e368 = (_e328 + 1i);
                let _e369 = (_e337 + 1i);
                if (_e368 > 0i) {
                    phi_531_ = _e368;
                } else {
                    phi_531_ = 0i;
                }
                let _e372 = phi_531_;
                if (_e369 > 0i) {
                    phi_536_ = _e369;
                } else {
                    phi_536_ = 0i;
                }
                let _e375 = phi_536_;
                if (_e372 < _e353) {
                    phi_541_ = _e372;
                } else {
                    phi_541_ = _e353;
                }
                let _e378 = phi_541_;
                if (_e375 < _e353) {
                    phi_546_ = _e375;
                } else {
                    phi_546_ = _e353;
                }
                let _e381 = phi_546_;
                let _e382 = bitcast<u32>(_e378);
                let _e384 = (bitcast<u32>(_e365) * _e351);
                let _e385 = (bitcast<u32>(_e381) * _e351);
                let _e386 = (_e384 + _e366);
                let _e387 = (_e384 + _e382);
                let _e388 = (_e385 + _e366);
                let _e389 = (_e385 + _e382);
                if (_e386 < _e41) {
                } else {
                    return;
                }
                let _e393 = map.member[(0u + _e386)];
                if (_e387 < _e41) {
                } else {
                    return;
                }
                let _e397 = map.member[(0u + _e387)];
                if (_e388 < _e41) {
                } else {
                    return;
                }
                let _e401 = map.member[(0u + _e388)];
                if (_e389 < _e41) {
                } else {
                    return;
                }
                let _e405 = map.member[(0u + _e389)];
                let _e407 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e393, _e397, _e401, _e405), vec4<f32>(((1f - _e318) * (1f - _e319)), (_e318 * (1f - _e319)), ((1f - _e318) * _e319), (_e318 * _e319)), _e231);
                phi_587_ = evaluate_Verdict(_e407, false);
                phi_588_ = evaluate_Verdict();
                phi_589_ = false;
            } else {
                phi_587_ = evaluate_Verdict();
                phi_588_ = evaluate_Verdict(1f, false);
                phi_589_ = true;
            }
            let _e411 = phi_587_;
            let _e413 = phi_588_;
            let _e415 = phi_589_;
            phi_590_ = _e413;
            phi_591_ = _e411;
            phi_592_ = _e415;
        }
        let _e417 = phi_590_;
        let _e419 = phi_591_;
        let _e421 = phi_592_;
        if _e421 {
            phi_596_ = _e417;
        } else {
            phi_596_ = _e419;
        }
        let _e423 = phi_596_;
        if (_e50.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e50.first_primitive)] = _e423.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
