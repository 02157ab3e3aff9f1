struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_9 {
    member: array<abi_Sample>,
}

struct type_13 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct type_28 {
    member: array<vec4<f32>>,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_32 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_32;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(2) 
var<storage> map: type_28;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_132_: lt_bvh_traverse_Tree;
    var phi_133_: bool;
    var phi_134_: lt_bvh_traverse_Tree;
    var phi_135_: bool;
    var phi_140_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_132_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_133_ = false;
        } else {
            phi_132_ = lt_bvh_traverse_Tree();
            phi_133_ = true;
        }
        let _e47 = phi_132_;
        let _e49 = phi_133_;
        phi_134_ = _e47;
        phi_135_ = _e49;
    } else {
        phi_134_ = lt_bvh_traverse_Tree();
        phi_135_ = true;
    }
    let _e51 = phi_134_;
    let _e53 = phi_135_;
    if _e53 {
        phi_140_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_140_ = _e51;
    }
    let _e58 = phi_140_;
    return lt_bvh_traverse_Tree(_e58.root, _e58.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_761_: f32;
    var phi_762_: f32;
    var phi_763_: f32;
    var phi_769_: bool;
    var phi_791_: f32;
    var phi_792_: f32;
    var phi_793_: f32;
    var phi_794_: f32;
    var phi_795_: bool;
    var phi_796_: f32;
    var phi_797_: bool;
    var phi_835_: vec2<f32>;
    var phi_869_: f32;
    var phi_870_: f32;
    var phi_871_: f32;
    var phi_900_: f32;
    var phi_901_: f32;
    var phi_902_: f32;
    var phi_906_: f32;
    var phi_907_: f32;
    var phi_908_: f32;
    var phi_909_: f32;

    let _e37 = (*param_4);
    let _e38 = (1f - _e37);
    let _e47 = (0.5f * _e37);
    let _e48 = ((param_5.x * _e38) + _e47);
    let _e49 = ((param_5.y * _e38) + _e47);
    let _e51 = ((param_5.w * _e38) + _e47);
    let _e53 = (_e49 - (_e48 * _e48));
    let _e55 = (((param_5.z * _e38) + _e47) - (_e48 * _e49));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_763_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_762_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_761_ = 1f;
            } else {
                phi_761_ = param_6;
            }
            let _e67 = phi_761_;
            phi_762_ = _e67;
        }
        let _e69 = phi_762_;
        phi_763_ = _e69;
    }
    let _e71 = phi_763_;
    if (_e48 == _e51) {
        phi_769_ = (_e48 > 0.5f);
    } else {
        phi_769_ = false;
    }
    let _e75 = phi_769_;
    if _e75 {
        if (_e71 > 0f) {
            if ((bitcast<u32>(_e48) & 2147483647u) > 2139095040u) {
                phi_793_ = _e48;
            } else {
                if (_e48 < 0f) {
                    phi_792_ = 0f;
                } else {
                    if (_e48 > 1f) {
                        phi_791_ = 1f;
                    } else {
                        phi_791_ = _e48;
                    }
                    let _e83 = phi_791_;
                    phi_792_ = _e83;
                }
                let _e85 = phi_792_;
                phi_793_ = _e85;
            }
            let _e87 = phi_793_;
            phi_794_ = _e87;
            phi_795_ = false;
        } else {
            phi_794_ = f32();
            phi_795_ = true;
        }
        let _e89 = phi_794_;
        let _e91 = phi_795_;
        phi_796_ = _e89;
        phi_797_ = _e91;
    } else {
        phi_796_ = f32();
        phi_797_ = true;
    }
    let _e93 = phi_796_;
    let _e95 = phi_797_;
    if _e95 {
        let _e96 = (_e55 / _e53);
        let _e97 = (_e71 - _e48);
        let _e103 = (((((_e71 * _e71) - _e49) - (_e96 * _e97)) * _e53) / (((_e51 - (_e49 * _e49)) * _e53) - (_e55 * _e55)));
        let _e106 = ((_e97 / _e53) - (_e96 * _e103));
        let _e112 = ((0.5f * _e106) / _e103);
        let _e115 = ((_e112 * _e112) - (((1f - (_e106 * _e48)) - (_e103 * _e49)) / _e103));
        if (_e115 >= 0f) {
            let _e117 = sqrt(_e115);
            phi_835_ = vec2<f32>((-(_e112) - _e117), (-(_e112) + _e117));
        } else {
            phi_835_ = vec2(bitcast<f32>((bitcast<u32>(_e115) | 2143289344u)));
        }
        let _e128 = phi_835_;
        if (_e71 <= _e128.x) {
            phi_908_ = 1f;
        } else {
            if (_e71 > _e128.y) {
                let _e141 = (((_e49 - (_e48 * (_e128.x + _e128.y))) + (_e128.x * _e128.y)) / ((_e71 - _e128.x) * (_e71 - _e128.y)));
                if ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u) {
                    phi_871_ = _e141;
                } else {
                    if (_e141 < 0f) {
                        phi_870_ = 0f;
                    } else {
                        if (_e141 > 1f) {
                            phi_869_ = 1f;
                        } else {
                            phi_869_ = _e141;
                        }
                        let _e148 = phi_869_;
                        phi_870_ = _e148;
                    }
                    let _e150 = phi_870_;
                    phi_871_ = _e150;
                }
                let _e152 = phi_871_;
                phi_907_ = _e152;
            } else {
                if (_e71 > _e128.x) {
                    let _e163 = (1f - (((_e49 - (_e48 * (_e71 + _e128.y))) + (_e71 * _e128.y)) / ((_e128.x - _e71) * (_e128.x - _e128.y))));
                    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
                        phi_902_ = _e163;
                    } else {
                        if (_e163 < 0f) {
                            phi_901_ = 0f;
                        } else {
                            if (_e163 > 1f) {
                                phi_900_ = 1f;
                            } else {
                                phi_900_ = _e163;
                            }
                            let _e170 = phi_900_;
                            phi_901_ = _e170;
                        }
                        let _e172 = phi_901_;
                        phi_902_ = _e172;
                    }
                    let _e174 = phi_902_;
                    phi_906_ = _e174;
                } else {
                    phi_906_ = bitcast<f32>((bitcast<u32>(_e128.x) | 2143289344u));
                }
                let _e179 = phi_906_;
                phi_907_ = _e179;
            }
            let _e181 = phi_907_;
            phi_908_ = _e181;
        }
        let _e183 = phi_908_;
        phi_909_ = _e183;
    } else {
        phi_909_ = _e93;
    }
    let _e185 = phi_909_;
    return _e185;
}

fn function_() {
    var local: f32;
    var phi_203_: bool;
    var phi_204_: bool;
    var phi_205_: bool;
    var phi_206_: bool;
    var phi_210_: bool;
    var phi_254_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_258_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_332_: bool;
    var phi_341_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_352_: bool;
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_356_: bool;
    var phi_360_: bool;
    var phi_450_: f32;
    var phi_453_: f32;
    var phi_482_: f32;
    var phi_487_: f32;
    var phi_488_: bool;
    var phi_489_: f32;
    var phi_490_: bool;
    var phi_494_: f32;
    var phi_514_: f32;
    var phi_519_: f32;
    var phi_520_: bool;
    var phi_521_: f32;
    var phi_522_: bool;
    var phi_526_: f32;
    var phi_574_: i32;
    var phi_579_: i32;
    var phi_584_: i32;
    var phi_589_: i32;
    var phi_598_: i32;
    var phi_603_: i32;
    var phi_608_: i32;
    var phi_613_: i32;
    var phi_702_: evaluate_Verdict;
    var phi_703_: evaluate_Verdict;
    var phi_704_: bool;
    var phi_705_: evaluate_Verdict;
    var phi_706_: evaluate_Verdict;
    var phi_707_: bool;
    var phi_711_: evaluate_Verdict;

    let _e35 = id_1;
    let _e42 = arrayLength((&map.member));
    let _e48 = p.member.size[0u];
    let _e50 = p.member.size[1u];
    let _e51 = lt_shaders_entry_pixel_index(_e35, _e48, _e50);
    if (bitcast<i32>(_e51.root) != 0i) {
        let _e57 = p.member.projection;
        if (_e51.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e61 = lt_math_OneLevel(_e57);
        let _e63 = p.member.light;
        let _e66 = samples.member[(0u + _e51.first_primitive)].normal[0u];
        let _e68 = global[0u];
        if (_e66 == _e68) {
            let _e71 = samples.member[(0u + _e51.first_primitive)].normal[1u];
            let _e73 = global[1u];
            if (_e71 == _e73) {
                let _e76 = samples.member[(0u + _e51.first_primitive)].normal[2u];
                let _e78 = global[2u];
                phi_203_ = (_e76 == _e78);
                phi_204_ = false;
            } else {
                phi_203_ = bool();
                phi_204_ = true;
            }
            let _e81 = phi_203_;
            let _e83 = phi_204_;
            phi_205_ = _e81;
            phi_206_ = _e83;
        } else {
            phi_205_ = bool();
            phi_206_ = true;
        }
        let _e85 = phi_205_;
        let _e87 = phi_206_;
        if _e87 {
            phi_210_ = false;
        } else {
            phi_210_ = _e85;
        }
        let _e89 = phi_210_;
        if !(_e89) {
            let _e92 = samples.member[(0u + _e51.first_primitive)].normal;
            let _e94 = samples.member[(0u + _e51.first_primitive)].position;
            if ((((_e92.x * (_e63.x - (_e94.x * _e63.w))) + (_e92.y * (_e63.y - (_e94.y * _e63.w)))) + (_e92.z * (_e63.z - (_e94.z * _e63.w)))) > 0f) {
                let _e118 = samples.member[(0u + _e51.first_primitive)].flags;
                let _e126 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e132 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e126.unnamed.visibility, false), _e126.unnamed_1);
                phi_254_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e132.unnamed, ((_e118 & 1u) == 0u));
            } else {
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e147 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e141.unnamed.visibility, false), _e141.unnamed_1);
                phi_254_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e147.unnamed, true);
            }
            let _e152 = phi_254_;
            phi_258_ = _e152;
        } else {
            let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e164 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e158.unnamed.visibility, false), _e158.unnamed_1);
            phi_258_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e164.unnamed, true);
        }
        let _e169 = phi_258_;
        if _e169.unnamed_1 {
            phi_705_ = evaluate_Verdict(_e169.unnamed.visibility, _e169.unnamed.is_doubted);
            phi_706_ = evaluate_Verdict();
            phi_707_ = true;
        } else {
            let _e177 = samples.member[(0u + _e51.first_primitive)].position;
            let _e195 = ((((_e61.projection.row_w.x * _e177.x) + (_e61.projection.row_w.y * _e177.y)) + (_e61.projection.row_w.z * _e177.z)) + (_e61.projection.row_w.w * 1f));
            let _e209 = (((((_e61.projection.row_x.x * _e177.x) + (_e61.projection.row_x.y * _e177.y)) + (_e61.projection.row_x.z * _e177.z)) + (_e61.projection.row_x.w * 1f)) / _e195);
            let _e223 = (((((_e61.projection.row_y.x * _e177.x) + (_e61.projection.row_y.y * _e177.y)) + (_e61.projection.row_y.z * _e177.z)) + (_e61.projection.row_y.w * 1f)) / _e195);
            let _e236 = ((((_e61.projection.row_z.x * _e177.x) + (_e61.projection.row_z.y * _e177.y)) + (_e61.projection.row_z.z * _e177.z)) + (_e61.projection.row_z.w * 1f));
            if (_e195 > 0f) {
                if (_e209 >= 0f) {
                    phi_332_ = (_e209 <= 1f);
                } else {
                    phi_332_ = false;
                }
                let _e241 = phi_332_;
                if _e241 {
                    if (_e223 >= 0f) {
                        phi_341_ = (_e223 <= 1f);
                    } else {
                        phi_341_ = false;
                    }
                    let _e245 = phi_341_;
                    if _e245 {
                        if (_e236 >= 0f) {
                            phi_350_ = (_e236 <= 1f);
                        } else {
                            phi_350_ = false;
                        }
                        let _e249 = phi_350_;
                        phi_351_ = _e249;
                        phi_352_ = false;
                    } else {
                        phi_351_ = bool();
                        phi_352_ = true;
                    }
                    let _e251 = phi_351_;
                    let _e253 = phi_352_;
                    phi_353_ = _e251;
                    phi_354_ = _e253;
                } else {
                    phi_353_ = bool();
                    phi_354_ = true;
                }
                let _e255 = phi_353_;
                let _e257 = phi_354_;
                phi_355_ = _e255;
                phi_356_ = _e257;
            } else {
                phi_355_ = bool();
                phi_356_ = true;
            }
            let _e259 = phi_355_;
            let _e261 = phi_356_;
            if _e261 {
                phi_360_ = false;
            } else {
                phi_360_ = _e259;
            }
            let _e263 = phi_360_;
            if _e263 {
                if (0f > 0f) {
                    let _e266 = samples.member[(0u + _e51.first_primitive)].normal;
                    let _e268 = p.member.map_size;
                    let _e338 = ((abs(((((_e57.row_x.x * _e266.x) + (_e57.row_x.y * _e266.y)) + (_e57.row_x.z * _e266.z)) / (((_e57.row_x.x * _e57.row_x.x) + (_e57.row_x.y * _e57.row_x.y)) + (_e57.row_x.z * _e57.row_x.z)))) + abs(((((_e57.row_y.x * _e266.x) + (_e57.row_y.y * _e266.y)) + (_e57.row_y.z * _e266.z)) / (((_e57.row_y.x * _e57.row_y.x) + (_e57.row_y.y * _e57.row_y.y)) + (_e57.row_y.z * _e57.row_y.z))))) / (abs(((((_e57.row_z.x * _e266.x) + (_e57.row_z.y * _e266.y)) + (_e57.row_z.z * _e266.z)) / (((_e57.row_z.x * _e57.row_z.x) + (_e57.row_z.y * _e57.row_z.y)) + (_e57.row_z.z * _e57.row_z.z)))) * f32(_e268)));
                    if (_e338 < 0.002f) {
                        phi_450_ = _e338;
                    } else {
                        phi_450_ = 0.002f;
                    }
                    let _e341 = phi_450_;
                    phi_453_ = (_e236 - (0f * _e341));
                } else {
                    phi_453_ = _e236;
                }
                let _e345 = phi_453_;
                let _e347 = p.member.map_size;
                let _e348 = f32(_e347);
                let _e351 = ((_e209 * _e348) - 0.5f);
                let _e352 = ((_e223 * _e348) - 0.5f);
                if (_e351 > -8388608f) {
                    let _e364 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e364 > _e351) {
                        phi_482_ = 1f;
                    } else {
                        phi_482_ = 0f;
                    }
                    let _e367 = phi_482_;
                    if (_e351 < 8388608f) {
                        phi_487_ = (_e364 - _e367);
                        phi_488_ = false;
                    } else {
                        phi_487_ = f32();
                        phi_488_ = true;
                    }
                    let _e370 = phi_487_;
                    let _e372 = phi_488_;
                    phi_489_ = _e370;
                    phi_490_ = _e372;
                } else {
                    phi_489_ = f32();
                    phi_490_ = true;
                }
                let _e374 = phi_489_;
                let _e376 = phi_490_;
                if _e376 {
                    phi_494_ = _e351;
                } else {
                    phi_494_ = _e374;
                }
                let _e378 = phi_494_;
                if (_e352 > -8388608f) {
                    let _e390 = f32(select(0i, select(select(i32(_e352), i32(-2147483648), (_e352 < bitcast<f32>(3472883712u))), 2147483647i, (_e352 > bitcast<f32>(1325400063u))), (_e352 == _e352)));
                    if (_e390 > _e352) {
                        phi_514_ = 1f;
                    } else {
                        phi_514_ = 0f;
                    }
                    let _e393 = phi_514_;
                    if (_e352 < 8388608f) {
                        phi_519_ = (_e390 - _e393);
                        phi_520_ = false;
                    } else {
                        phi_519_ = f32();
                        phi_520_ = true;
                    }
                    let _e396 = phi_519_;
                    let _e398 = phi_520_;
                    phi_521_ = _e396;
                    phi_522_ = _e398;
                } else {
                    phi_521_ = f32();
                    phi_522_ = true;
                }
                let _e400 = phi_521_;
                let _e402 = phi_522_;
                if _e402 {
                    phi_526_ = _e352;
                } else {
                    phi_526_ = _e400;
                }
                let _e404 = phi_526_;
                let _e405 = (_e351 - _e378);
                let _e406 = (_e352 - _e404);
                let _e415 = select(0i, select(select(i32(_e378), i32(-2147483648), (_e378 < bitcast<f32>(3472883712u))), 2147483647i, (_e378 > bitcast<f32>(1325400063u))), (_e378 == _e378));
                let _e424 = select(0i, select(select(i32(_e404), i32(-2147483648), (_e404 < bitcast<f32>(3472883712u))), 2147483647i, (_e404 > bitcast<f32>(1325400063u))), (_e404 == _e404));
                let _e427 = ((1f - _e405) * (1f - _e406));
                let _e429 = (_e405 * (1f - _e406));
                let _e431 = ((1f - _e405) * _e406);
                let _e432 = (_e405 * _e406);
                let _e434 = p.member.test;
                let _e435 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e434);
                let _e437 = p.member.map_size;
                local = _e435;
                let _e439 = ((0u * _e437) * _e437);
                let _e441 = (bitcast<i32>(_e437) - 1i);
                if (_e415 > 0i) {
                    phi_574_ = _e415;
                } else {
                    phi_574_ = 0i;
                }
                let _e444 = phi_574_;
                if (_e424 > 0i) {
                    phi_579_ = _e424;
                } else {
                    phi_579_ = 0i;
                }
                let _e447 = phi_579_;
                if (_e444 < _e441) {
                    phi_584_ = _e444;
                } else {
                    phi_584_ = _e441;
                }
                let _e450 = phi_584_;
                if (_e447 < _e441) {
                    phi_589_ = _e447;
                } else {
                    phi_589_ = _e441;
                }
                let _e453 = phi_589_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e415 + 1i);
                let _e457 = (_e424 + 1i);
                if (_e456 > 0i) {
                    phi_598_ = _e456;
                } else {
                    phi_598_ = 0i;
                }
                let _e460 = phi_598_;
                if (_e457 > 0i) {
                    phi_603_ = _e457;
                } else {
                    phi_603_ = 0i;
                }
                let _e463 = phi_603_;
                if (_e460 < _e441) {
                    phi_608_ = _e460;
                } else {
                    phi_608_ = _e441;
                }
                let _e466 = phi_608_;
                if (_e463 < _e441) {
                    phi_613_ = _e463;
                } else {
                    phi_613_ = _e441;
                }
                let _e469 = phi_613_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (bitcast<u32>(_e453) * _e437);
                let _e473 = (bitcast<u32>(_e469) * _e437);
                let _e478 = ((_e472 + _e454) + _e439);
                let _e479 = ((_e472 + _e470) + _e439);
                let _e480 = ((_e473 + _e454) + _e439);
                let _e481 = ((_e473 + _e470) + _e439);
                if (_e478 < _e42) {
                } else {
                    return;
                }
                let _e485 = map.member[(0u + _e478)];
                if (_e479 < _e42) {
                } else {
                    return;
                }
                let _e497 = map.member[(0u + _e479)];
                if (_e480 < _e42) {
                } else {
                    return;
                }
                let _e513 = map.member[(0u + _e480)];
                if (_e481 < _e42) {
                } else {
                    return;
                }
                let _e529 = map.member[(0u + _e481)];
                let _e543 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e485.x * _e427) + (_e497.x * _e429)) + (_e513.x * _e431)) + (_e529.x * _e432)), ((((_e485.y * _e427) + (_e497.y * _e429)) + (_e513.y * _e431)) + (_e529.y * _e432)), ((((_e485.z * _e427) + (_e497.z * _e429)) + (_e513.z * _e431)) + (_e529.z * _e432)), ((((_e485.w * _e427) + (_e497.w * _e429)) + (_e513.w * _e431)) + (_e529.w * _e432))), _e345);
                phi_702_ = evaluate_Verdict(_e543, false);
                phi_703_ = evaluate_Verdict();
                phi_704_ = false;
            } else {
                phi_702_ = evaluate_Verdict();
                phi_703_ = evaluate_Verdict(1f, false);
                phi_704_ = true;
            }
            let _e547 = phi_702_;
            let _e549 = phi_703_;
            let _e551 = phi_704_;
            phi_705_ = _e549;
            phi_706_ = _e547;
            phi_707_ = _e551;
        }
        let _e553 = phi_705_;
        let _e555 = phi_706_;
        let _e557 = phi_707_;
        if _e557 {
            phi_711_ = _e553;
        } else {
            phi_711_ = _e555;
        }
        let _e559 = phi_711_;
        if (_e51.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e51.first_primitive)] = _e559.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
