struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct type_8 {
    member: array<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_25 {
    member: array<abi_Sample>,
}

struct type_29 {
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

struct type_37 {
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

struct type_44 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_25;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_37;
@group(0) @binding(2) 
var<storage> map: type_29;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_29;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_44;
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_151_: lt_bvh_traverse_Tree;
    var phi_152_: bool;
    var phi_157_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_149_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_150_ = false;
        } else {
            phi_149_ = lt_bvh_traverse_Tree();
            phi_150_ = true;
        }
        let _e47 = phi_149_;
        let _e49 = phi_150_;
        phi_151_ = _e47;
        phi_152_ = _e49;
    } else {
        phi_151_ = lt_bvh_traverse_Tree();
        phi_152_ = true;
    }
    let _e51 = phi_151_;
    let _e53 = phi_152_;
    if _e53 {
        phi_157_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_157_ = _e51;
    }
    let _e58 = phi_157_;
    return lt_bvh_traverse_Tree(_e58.root, _e58.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_180_: f32;
    var phi_181_: f32;
    var phi_182_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_182_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_181_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_180_ = 1f;
            } else {
                phi_180_ = param_4;
            }
            let _e41 = phi_180_;
            phi_181_ = _e41;
        }
        let _e43 = phi_181_;
        phi_182_ = _e43;
    }
    let _e45 = phi_182_;
    let _e46 = (_e45 * _e45);
    return vec4<f32>(_e45, _e46, (_e46 * _e45), (_e46 * _e46));
}

fn lt_shaders_evaluate_to_light(param_5: vec3<f32>, param_6: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_6.x - (param_5.x * param_6.w)), (param_6.y - (param_5.y * param_6.w)), (param_6.z - (param_5.z * param_6.w)));
}

fn lt_shaders_evaluate_quad_indices(param_7: i32, param_8: i32, param_9: u32) -> array<u32, 4> {
    var phi_214_: i32;
    var phi_219_: i32;
    var phi_224_: i32;
    var phi_229_: i32;
    var phi_238_: i32;
    var phi_243_: i32;
    var phi_248_: i32;
    var phi_253_: i32;

    let _e38 = (bitcast<i32>(param_9) - 1i);
    if (param_7 > 0i) {
        phi_214_ = param_7;
    } else {
        phi_214_ = 0i;
    }
    let _e41 = phi_214_;
    if (param_8 > 0i) {
        phi_219_ = param_8;
    } else {
        phi_219_ = 0i;
    }
    let _e44 = phi_219_;
    if (_e41 < _e38) {
        phi_224_ = _e41;
    } else {
        phi_224_ = _e38;
    }
    let _e47 = phi_224_;
    if (_e44 < _e38) {
        phi_229_ = _e44;
    } else {
        phi_229_ = _e38;
    }
    let _e50 = phi_229_;
    let _e51 = bitcast<u32>(_e47);
    let _e53 = (param_7 + 1i);
    let _e54 = (param_8 + 1i);
    if (_e53 > 0i) {
        phi_238_ = _e53;
    } else {
        phi_238_ = 0i;
    }
    let _e57 = phi_238_;
    if (_e54 > 0i) {
        phi_243_ = _e54;
    } else {
        phi_243_ = 0i;
    }
    let _e60 = phi_243_;
    if (_e57 < _e38) {
        phi_248_ = _e57;
    } else {
        phi_248_ = _e38;
    }
    let _e63 = phi_248_;
    if (_e60 < _e38) {
        phi_253_ = _e60;
    } else {
        phi_253_ = _e38;
    }
    let _e66 = phi_253_;
    let _e67 = bitcast<u32>(_e63);
    let _e69 = (bitcast<u32>(_e50) * param_9);
    let _e70 = (bitcast<u32>(_e66) * param_9);
    return array<u32, 4>((_e69 + _e51), (_e69 + _e67), (_e70 + _e51), (_e70 + _e67));
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_10: ptr<function, f32>, param_11: vec4<f32>, param_12: f32) -> f32 {
    var phi_368_: f32;
    var phi_369_: f32;
    var phi_370_: f32;
    var phi_405_: vec2<f32>;
    var phi_439_: f32;
    var phi_440_: f32;
    var phi_441_: f32;
    var phi_470_: f32;
    var phi_471_: f32;
    var phi_472_: f32;
    var phi_476_: f32;
    var phi_477_: f32;
    var phi_478_: f32;

    let _e37 = (*param_10);
    let _e38 = (1f - _e37);
    let _e47 = (0.5f * _e37);
    let _e48 = ((param_11.x * _e38) + _e47);
    let _e49 = ((param_11.y * _e38) + _e47);
    let _e53 = (_e49 - (_e48 * _e48));
    let _e55 = (((param_11.z * _e38) + _e47) - (_e48 * _e49));
    if ((bitcast<u32>(param_12) & 2147483647u) > 2139095040u) {
        phi_370_ = param_12;
    } else {
        if (param_12 < 0f) {
            phi_369_ = 0f;
        } else {
            if (param_12 > 1f) {
                phi_368_ = 1f;
            } else {
                phi_368_ = param_12;
            }
            let _e67 = phi_368_;
            phi_369_ = _e67;
        }
        let _e69 = phi_369_;
        phi_370_ = _e69;
    }
    let _e71 = phi_370_;
    let _e72 = (_e55 / _e53);
    let _e73 = (_e71 - _e48);
    let _e79 = (((((_e71 * _e71) - _e49) - (_e72 * _e73)) * _e53) / (((((param_11.w * _e38) + _e47) - (_e49 * _e49)) * _e53) - (_e55 * _e55)));
    let _e82 = ((_e73 / _e53) - (_e72 * _e79));
    let _e88 = ((0.5f * _e82) / _e79);
    let _e91 = ((_e88 * _e88) - (((1f - (_e82 * _e48)) - (_e79 * _e49)) / _e79));
    if (_e91 >= 0f) {
        let _e93 = sqrt(_e91);
        phi_405_ = vec2<f32>((-(_e88) - _e93), (-(_e88) + _e93));
    } else {
        phi_405_ = vec2(bitcast<f32>((bitcast<u32>(_e91) | 2143289344u)));
    }
    let _e104 = phi_405_;
    if (_e71 <= _e104.x) {
        phi_478_ = 1f;
    } else {
        if (_e71 > _e104.y) {
            let _e117 = (((_e49 - (_e48 * (_e104.x + _e104.y))) + (_e104.x * _e104.y)) / ((_e71 - _e104.x) * (_e71 - _e104.y)));
            if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
                phi_441_ = _e117;
            } else {
                if (_e117 < 0f) {
                    phi_440_ = 0f;
                } else {
                    if (_e117 > 1f) {
                        phi_439_ = 1f;
                    } else {
                        phi_439_ = _e117;
                    }
                    let _e124 = phi_439_;
                    phi_440_ = _e124;
                }
                let _e126 = phi_440_;
                phi_441_ = _e126;
            }
            let _e128 = phi_441_;
            phi_477_ = _e128;
        } else {
            if (_e71 > _e104.x) {
                let _e139 = (1f - (((_e49 - (_e48 * (_e71 + _e104.y))) + (_e71 * _e104.y)) / ((_e104.x - _e71) * (_e104.x - _e104.y))));
                if ((bitcast<u32>(_e139) & 2147483647u) > 2139095040u) {
                    phi_472_ = _e139;
                } else {
                    if (_e139 < 0f) {
                        phi_471_ = 0f;
                    } else {
                        if (_e139 > 1f) {
                            phi_470_ = 1f;
                        } else {
                            phi_470_ = _e139;
                        }
                        let _e146 = phi_470_;
                        phi_471_ = _e146;
                    }
                    let _e148 = phi_471_;
                    phi_472_ = _e148;
                }
                let _e150 = phi_472_;
                phi_476_ = _e150;
            } else {
                phi_476_ = bitcast<f32>((bitcast<u32>(_e104.x) | 2143289344u));
            }
            let _e155 = phi_476_;
            phi_477_ = _e155;
        }
        let _e157 = phi_477_;
        phi_478_ = _e157;
    }
    let _e159 = phi_478_;
    return _e159;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_13: ptr<function, f32>, param_14: vec4<f32>, param_15: vec4<f32>, param_16: f32) -> f32 {
    let _e39 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_14.x);
    let _e41 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_14.y);
    let _e43 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_14.z);
    let _e45 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_14.w);
    let _e95 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_13, vec4<f32>(((((_e39.x * param_15.x) + (_e41.x * param_15.y)) + (_e43.x * param_15.z)) + (_e45.x * param_15.w)), ((((_e39.y * param_15.x) + (_e41.y * param_15.y)) + (_e43.y * param_15.z)) + (_e45.y * param_15.w)), ((((_e39.z * param_15.x) + (_e41.z * param_15.y)) + (_e43.z * param_15.z)) + (_e45.z * param_15.w)), ((((_e39.w * param_15.x) + (_e41.w * param_15.y)) + (_e43.w * param_15.z)) + (_e45.w * param_15.w))), param_16);
    return _e95;
}

fn function_() {
    var local_1: f32;
    var phi_532_: bool;
    var phi_533_: bool;
    var phi_534_: bool;
    var phi_535_: bool;
    var phi_539_: bool;
    var phi_574_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_578_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_674_: bool;
    var phi_675_: bool;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_678_: bool;
    var phi_679_: bool;
    var phi_680_: bool;
    var phi_681_: bool;
    var phi_682_: bool;
    var phi_686_: bool;
    var phi_787_: bool;
    var phi_795_: bool;
    var phi_800_: f32;
    var phi_803_: evaluate_Verdict;
    var phi_804_: evaluate_Verdict;
    var phi_808_: bool;
    var phi_809_: u32;
    var phi_815_: u32;

    let _e35 = id_1;
    let _e36 = local_2;
    let _e41 = arrayLength((&map.member));
    if (_e36 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e48 = p.member.size[0u];
    let _e50 = p.member.size[1u];
    let _e51 = lt_shaders_entry_pixel_index(_e35, _e48, _e50);
    if (bitcast<i32>(_e51.root) != 0i) {
        let _e58 = p.member.light;
        let _e61 = samples.member[_e51.first_primitive].normal[0u];
        let _e63 = global[0u];
        if (_e61 == _e63) {
            let _e66 = samples.member[_e51.first_primitive].normal[1u];
            let _e68 = global[1u];
            if (_e66 == _e68) {
                let _e71 = samples.member[_e51.first_primitive].normal[2u];
                let _e73 = global[2u];
                phi_532_ = (_e71 == _e73);
                phi_533_ = false;
            } else {
                phi_532_ = bool();
                phi_533_ = true;
            }
            let _e76 = phi_532_;
            let _e78 = phi_533_;
            phi_534_ = _e76;
            phi_535_ = _e78;
        } else {
            phi_534_ = bool();
            phi_535_ = true;
        }
        let _e80 = phi_534_;
        let _e82 = phi_535_;
        if _e82 {
            phi_539_ = false;
        } else {
            phi_539_ = _e80;
        }
        let _e84 = phi_539_;
        if !(_e84) {
            let _e87 = samples.member[_e51.first_primitive].normal;
            let _e89 = samples.member[_e51.first_primitive].position;
            let _e90 = lt_shaders_evaluate_to_light(_e89, _e58);
            if ((((_e87.x * _e90.x) + (_e87.y * _e90.y)) + (_e87.z * _e90.z)) > 0f) {
                let _e104 = samples.member[_e51.first_primitive].flags;
                let _e112 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e118 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e112.unnamed.visibility, false), _e112.unnamed_1);
                phi_574_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e118.unnamed, ((_e104 & 1u) == 0u));
            } else {
                let _e127 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e127.unnamed.visibility, false), _e127.unnamed_1);
                phi_574_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e133.unnamed, true);
            }
            let _e138 = phi_574_;
            phi_578_ = _e138;
        } else {
            let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e144.unnamed.visibility, false), _e144.unnamed_1);
            phi_578_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e150.unnamed, true);
        }
        let _e155 = phi_578_;
        if _e155.unnamed_1 {
            phi_804_ = evaluate_Verdict(_e155.unnamed.visibility, _e155.unnamed.is_doubted);
        } else {
            let _e163 = samples.member[_e51.first_primitive].position;
            let _e169 = p.member.projection.row_w;
            let _e180 = ((((_e169.x * _e163.x) + (_e169.y * _e163.y)) + (_e169.z * _e163.z)) + (_e169.w * 1f));
            let _e182 = p.member.projection.row_x;
            let _e194 = (((((_e182.x * _e163.x) + (_e182.y * _e163.y)) + (_e182.z * _e163.z)) + (_e182.w * 1f)) / _e180);
            let _e196 = p.member.projection.row_y;
            let _e208 = (((((_e196.x * _e163.x) + (_e196.y * _e163.y)) + (_e196.z * _e163.z)) + (_e196.w * 1f)) / _e180);
            let _e210 = p.member.projection.row_z;
            let _e221 = ((((_e210.x * _e163.x) + (_e210.y * _e163.y)) + (_e210.z * _e163.z)) + (_e210.w * 1f));
            if (_e180 > 0f) {
                if (_e194 >= 0f) {
                    if (_e194 <= 1f) {
                        if (_e208 >= 0f) {
                            if (_e208 <= 1f) {
                                if (_e221 >= 0f) {
                                    phi_671_ = (_e221 <= 1f);
                                    phi_672_ = false;
                                } else {
                                    phi_671_ = bool();
                                    phi_672_ = true;
                                }
                                let _e230 = phi_671_;
                                let _e232 = phi_672_;
                                phi_673_ = _e230;
                                phi_674_ = _e232;
                            } else {
                                phi_673_ = bool();
                                phi_674_ = true;
                            }
                            let _e234 = phi_673_;
                            let _e236 = phi_674_;
                            phi_675_ = _e234;
                            phi_676_ = _e236;
                        } else {
                            phi_675_ = bool();
                            phi_676_ = true;
                        }
                        let _e238 = phi_675_;
                        let _e240 = phi_676_;
                        phi_677_ = _e238;
                        phi_678_ = _e240;
                    } else {
                        phi_677_ = bool();
                        phi_678_ = true;
                    }
                    let _e242 = phi_677_;
                    let _e244 = phi_678_;
                    phi_679_ = _e242;
                    phi_680_ = _e244;
                } else {
                    phi_679_ = bool();
                    phi_680_ = true;
                }
                let _e246 = phi_679_;
                let _e248 = phi_680_;
                phi_681_ = _e246;
                phi_682_ = _e248;
            } else {
                phi_681_ = bool();
                phi_682_ = true;
            }
            let _e250 = phi_681_;
            let _e252 = phi_682_;
            if _e252 {
                phi_686_ = false;
            } else {
                phi_686_ = _e250;
            }
            let _e254 = phi_686_;
            if _e254 {
                let _e256 = p.member.map_size;
                let _e257 = f32(_e256);
                let _e260 = ((_e194 * _e257) - 0.5f);
                let _e261 = ((_e208 * _e257) - 0.5f);
                let _e262 = floor(_e260);
                let _e263 = floor(_e261);
                let _e264 = (_e260 - _e262);
                let _e265 = (_e261 - _e263);
                let _e294 = p.member.test;
                let _e295 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e294);
                let _e297 = p.member.map_size;
                local_1 = _e295;
                let _e298 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e262), i32(-2147483648), (_e262 < bitcast<f32>(3472883712u))), 2147483647i, (_e262 > bitcast<f32>(1325400063u))), (_e262 == _e262)), select(0i, select(select(i32(_e263), i32(-2147483648), (_e263 < bitcast<f32>(3472883712u))), 2147483647i, (_e263 > bitcast<f32>(1325400063u))), (_e263 == _e263)), _e297);
                if (_e298[0] < _e41) {
                } else {
                    return;
                }
                let _e303 = map.member[(0u + _e298[0])];
                if (_e298[1] < _e41) {
                } else {
                    return;
                }
                let _e308 = map.member[(0u + _e298[1])];
                if (_e298[2] < _e41) {
                } else {
                    return;
                }
                let _e313 = map.member[(0u + _e298[2])];
                if (_e298[3] < _e41) {
                } else {
                    return;
                }
                let _e318 = map.member[(0u + _e298[3])];
                let _e320 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e303, _e308, _e313, _e318), vec4<f32>(((1f - _e264) * (1f - _e265)), (_e264 * (1f - _e265)), ((1f - _e264) * _e265), (_e264 * _e265)), _e221);
                let _e322 = p.member.epsilon;
                if (_e320 <= _e322) {
                    phi_787_ = true;
                } else {
                    phi_787_ = (_e320 >= (1f - _e322));
                }
                let _e327 = phi_787_;
                if ((bitcast<u32>(_e320) & 2147483647u) > 2139095040u) {
                    phi_795_ = true;
                } else {
                    phi_795_ = !(_e327);
                }
                let _e333 = phi_795_;
                if (_e320 > 0.5f) {
                    phi_800_ = 1f;
                } else {
                    phi_800_ = 0f;
                }
                let _e336 = phi_800_;
                phi_803_ = evaluate_Verdict(_e336, _e333);
            } else {
                phi_803_ = evaluate_Verdict(1f, true);
            }
            let _e340 = phi_803_;
            phi_804_ = _e340;
        }
        let _e342 = phi_804_;
        visibility.member[_e51.first_primitive] = _e342.visibility;
        phi_808_ = _e342.is_doubted;
        phi_809_ = _e51.first_primitive;
    } else {
        phi_808_ = false;
        phi_809_ = 0u;
    }
    let _e347 = phi_808_;
    let _e349 = phi_809_;
    if _e347 {
        let _e351 = atomicAdd((&shared_[0u]), 1u);
        phi_815_ = _e351;
    } else {
        phi_815_ = 0u;
    }
    let _e353 = phi_815_;
    workgroupBarrier();
    if (_e36 == 0u) {
        let _e357 = atomicLoad((&shared_[0u]));
        let _e358 = atomicAdd((&list.member[3u]), _e357);
        atomicStore((&shared_[1u]), _e358);
    }
    workgroupBarrier();
    if _e347 {
        let _e361 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e361) + _e353)]), _e349);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
