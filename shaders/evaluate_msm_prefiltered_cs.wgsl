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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_32 {
    member: abi_ShadowParams,
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
    var phi_131_: lt_bvh_traverse_Tree;
    var phi_132_: bool;
    var phi_133_: lt_bvh_traverse_Tree;
    var phi_134_: bool;
    var phi_139_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_131_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_132_ = false;
        } else {
            phi_131_ = lt_bvh_traverse_Tree();
            phi_132_ = true;
        }
        let _e47 = phi_131_;
        let _e49 = phi_132_;
        phi_133_ = _e47;
        phi_134_ = _e49;
    } else {
        phi_133_ = lt_bvh_traverse_Tree();
        phi_134_ = true;
    }
    let _e51 = phi_133_;
    let _e53 = phi_134_;
    if _e53 {
        phi_139_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_139_ = _e51;
    }
    let _e58 = phi_139_;
    return lt_bvh_traverse_Tree(_e58.root, _e58.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_758_: f32;
    var phi_759_: f32;
    var phi_760_: f32;
    var phi_766_: bool;
    var phi_788_: f32;
    var phi_789_: f32;
    var phi_790_: f32;
    var phi_791_: f32;
    var phi_792_: bool;
    var phi_793_: f32;
    var phi_794_: bool;
    var phi_832_: vec2<f32>;
    var phi_866_: f32;
    var phi_867_: f32;
    var phi_868_: f32;
    var phi_897_: f32;
    var phi_898_: f32;
    var phi_899_: f32;
    var phi_903_: f32;
    var phi_904_: f32;
    var phi_905_: f32;
    var phi_906_: f32;

    let _e37 = (*param_4);
    let _e38 = (1f - _e37);
    let _e47 = (0.5f * _e37);
    let _e48 = ((param_5.x * _e38) + _e47);
    let _e49 = ((param_5.y * _e38) + _e47);
    let _e51 = ((param_5.w * _e38) + _e47);
    let _e53 = (_e49 - (_e48 * _e48));
    let _e55 = (((param_5.z * _e38) + _e47) - (_e48 * _e49));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_760_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_759_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_758_ = 1f;
            } else {
                phi_758_ = param_6;
            }
            let _e67 = phi_758_;
            phi_759_ = _e67;
        }
        let _e69 = phi_759_;
        phi_760_ = _e69;
    }
    let _e71 = phi_760_;
    if (_e48 == _e51) {
        phi_766_ = (_e48 > 0.5f);
    } else {
        phi_766_ = false;
    }
    let _e75 = phi_766_;
    if _e75 {
        if (_e71 > 0f) {
            if ((bitcast<u32>(_e48) & 2147483647u) > 2139095040u) {
                phi_790_ = _e48;
            } else {
                if (_e48 < 0f) {
                    phi_789_ = 0f;
                } else {
                    if (_e48 > 1f) {
                        phi_788_ = 1f;
                    } else {
                        phi_788_ = _e48;
                    }
                    let _e83 = phi_788_;
                    phi_789_ = _e83;
                }
                let _e85 = phi_789_;
                phi_790_ = _e85;
            }
            let _e87 = phi_790_;
            phi_791_ = _e87;
            phi_792_ = false;
        } else {
            phi_791_ = f32();
            phi_792_ = true;
        }
        let _e89 = phi_791_;
        let _e91 = phi_792_;
        phi_793_ = _e89;
        phi_794_ = _e91;
    } else {
        phi_793_ = f32();
        phi_794_ = true;
    }
    let _e93 = phi_793_;
    let _e95 = phi_794_;
    if _e95 {
        let _e96 = (_e55 / _e53);
        let _e97 = (_e71 - _e48);
        let _e103 = (((((_e71 * _e71) - _e49) - (_e96 * _e97)) * _e53) / (((_e51 - (_e49 * _e49)) * _e53) - (_e55 * _e55)));
        let _e106 = ((_e97 / _e53) - (_e96 * _e103));
        let _e112 = ((0.5f * _e106) / _e103);
        let _e115 = ((_e112 * _e112) - (((1f - (_e106 * _e48)) - (_e103 * _e49)) / _e103));
        if (_e115 >= 0f) {
            let _e117 = sqrt(_e115);
            phi_832_ = vec2<f32>((-(_e112) - _e117), (-(_e112) + _e117));
        } else {
            phi_832_ = vec2(bitcast<f32>((bitcast<u32>(_e115) | 2143289344u)));
        }
        let _e128 = phi_832_;
        if (_e71 <= _e128.x) {
            phi_905_ = 1f;
        } else {
            if (_e71 > _e128.y) {
                let _e141 = (((_e49 - (_e48 * (_e128.x + _e128.y))) + (_e128.x * _e128.y)) / ((_e71 - _e128.x) * (_e71 - _e128.y)));
                if ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u) {
                    phi_868_ = _e141;
                } else {
                    if (_e141 < 0f) {
                        phi_867_ = 0f;
                    } else {
                        if (_e141 > 1f) {
                            phi_866_ = 1f;
                        } else {
                            phi_866_ = _e141;
                        }
                        let _e148 = phi_866_;
                        phi_867_ = _e148;
                    }
                    let _e150 = phi_867_;
                    phi_868_ = _e150;
                }
                let _e152 = phi_868_;
                phi_904_ = _e152;
            } else {
                if (_e71 > _e128.x) {
                    let _e163 = (1f - (((_e49 - (_e48 * (_e71 + _e128.y))) + (_e71 * _e128.y)) / ((_e128.x - _e71) * (_e128.x - _e128.y))));
                    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
                        phi_899_ = _e163;
                    } else {
                        if (_e163 < 0f) {
                            phi_898_ = 0f;
                        } else {
                            if (_e163 > 1f) {
                                phi_897_ = 1f;
                            } else {
                                phi_897_ = _e163;
                            }
                            let _e170 = phi_897_;
                            phi_898_ = _e170;
                        }
                        let _e172 = phi_898_;
                        phi_899_ = _e172;
                    }
                    let _e174 = phi_899_;
                    phi_903_ = _e174;
                } else {
                    phi_903_ = bitcast<f32>((bitcast<u32>(_e128.x) | 2143289344u));
                }
                let _e179 = phi_903_;
                phi_904_ = _e179;
            }
            let _e181 = phi_904_;
            phi_905_ = _e181;
        }
        let _e183 = phi_905_;
        phi_906_ = _e183;
    } else {
        phi_906_ = _e93;
    }
    let _e185 = phi_906_;
    return _e185;
}

fn function_() {
    var local: f32;
    var phi_199_: bool;
    var phi_200_: bool;
    var phi_201_: bool;
    var phi_202_: bool;
    var phi_206_: bool;
    var phi_250_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_254_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_331_: bool;
    var phi_340_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_352_: bool;
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_359_: bool;
    var phi_453_: f32;
    var phi_456_: f32;
    var phi_485_: f32;
    var phi_490_: f32;
    var phi_491_: bool;
    var phi_492_: f32;
    var phi_493_: bool;
    var phi_497_: f32;
    var phi_517_: f32;
    var phi_522_: f32;
    var phi_523_: bool;
    var phi_524_: f32;
    var phi_525_: bool;
    var phi_529_: f32;
    var phi_575_: i32;
    var phi_580_: i32;
    var phi_585_: i32;
    var phi_590_: i32;
    var phi_599_: i32;
    var phi_604_: i32;
    var phi_609_: i32;
    var phi_614_: i32;
    var phi_699_: evaluate_Verdict;
    var phi_700_: evaluate_Verdict;
    var phi_701_: bool;
    var phi_702_: evaluate_Verdict;
    var phi_703_: evaluate_Verdict;
    var phi_704_: bool;
    var phi_708_: evaluate_Verdict;

    let _e35 = id_1;
    let _e42 = arrayLength((&map.member));
    let _e48 = p.member.size[0u];
    let _e50 = p.member.size[1u];
    let _e51 = lt_shaders_entry_pixel_index(_e35, _e48, _e50);
    if (bitcast<i32>(_e51.root) != 0i) {
        if (_e51.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e60 = p.member.light;
        let _e63 = samples.member[(0u + _e51.first_primitive)].normal[0u];
        let _e65 = global[0u];
        if (_e63 == _e65) {
            let _e68 = samples.member[(0u + _e51.first_primitive)].normal[1u];
            let _e70 = global[1u];
            if (_e68 == _e70) {
                let _e73 = samples.member[(0u + _e51.first_primitive)].normal[2u];
                let _e75 = global[2u];
                phi_199_ = (_e73 == _e75);
                phi_200_ = false;
            } else {
                phi_199_ = bool();
                phi_200_ = true;
            }
            let _e78 = phi_199_;
            let _e80 = phi_200_;
            phi_201_ = _e78;
            phi_202_ = _e80;
        } else {
            phi_201_ = bool();
            phi_202_ = true;
        }
        let _e82 = phi_201_;
        let _e84 = phi_202_;
        if _e84 {
            phi_206_ = false;
        } else {
            phi_206_ = _e82;
        }
        let _e86 = phi_206_;
        if !(_e86) {
            let _e89 = samples.member[(0u + _e51.first_primitive)].normal;
            let _e91 = samples.member[(0u + _e51.first_primitive)].position;
            if ((((_e89.x * (_e60.x - (_e91.x * _e60.w))) + (_e89.y * (_e60.y - (_e91.y * _e60.w)))) + (_e89.z * (_e60.z - (_e91.z * _e60.w)))) > 0f) {
                let _e115 = samples.member[(0u + _e51.first_primitive)].flags;
                let _e123 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e123.unnamed.visibility, false), _e123.unnamed_1);
                phi_250_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e129.unnamed, ((_e115 & 1u) == 0u));
            } else {
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_250_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, true);
            }
            let _e149 = phi_250_;
            phi_254_ = _e149;
        } else {
            let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e155.unnamed.visibility, false), _e155.unnamed_1);
            phi_254_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e161.unnamed, true);
        }
        let _e166 = phi_254_;
        if _e166.unnamed_1 {
            phi_702_ = evaluate_Verdict(_e166.unnamed.visibility, _e166.unnamed.is_doubted);
            phi_703_ = evaluate_Verdict();
            phi_704_ = true;
        } else {
            let _e174 = samples.member[(0u + _e51.first_primitive)].position;
            let _e180 = p.member.projection.row_w;
            let _e191 = ((((_e180.x * _e174.x) + (_e180.y * _e174.y)) + (_e180.z * _e174.z)) + (_e180.w * 1f));
            let _e193 = p.member.projection.row_x;
            let _e205 = (((((_e193.x * _e174.x) + (_e193.y * _e174.y)) + (_e193.z * _e174.z)) + (_e193.w * 1f)) / _e191);
            let _e207 = p.member.projection.row_y;
            let _e219 = (((((_e207.x * _e174.x) + (_e207.y * _e174.y)) + (_e207.z * _e174.z)) + (_e207.w * 1f)) / _e191);
            let _e221 = p.member.projection.row_z;
            let _e232 = ((((_e221.x * _e174.x) + (_e221.y * _e174.y)) + (_e221.z * _e174.z)) + (_e221.w * 1f));
            if (_e191 > 0f) {
                if (_e205 >= 0f) {
                    phi_331_ = (_e205 <= 1f);
                } else {
                    phi_331_ = false;
                }
                let _e237 = phi_331_;
                if _e237 {
                    if (_e219 >= 0f) {
                        phi_340_ = (_e219 <= 1f);
                    } else {
                        phi_340_ = false;
                    }
                    let _e241 = phi_340_;
                    if _e241 {
                        if (_e232 >= 0f) {
                            phi_349_ = (_e232 <= 1f);
                        } else {
                            phi_349_ = false;
                        }
                        let _e245 = phi_349_;
                        phi_350_ = _e245;
                        phi_351_ = false;
                    } else {
                        phi_350_ = bool();
                        phi_351_ = true;
                    }
                    let _e247 = phi_350_;
                    let _e249 = phi_351_;
                    phi_352_ = _e247;
                    phi_353_ = _e249;
                } else {
                    phi_352_ = bool();
                    phi_353_ = true;
                }
                let _e251 = phi_352_;
                let _e253 = phi_353_;
                phi_354_ = _e251;
                phi_355_ = _e253;
            } else {
                phi_354_ = bool();
                phi_355_ = true;
            }
            let _e255 = phi_354_;
            let _e257 = phi_355_;
            if _e257 {
                phi_359_ = false;
            } else {
                phi_359_ = _e255;
            }
            let _e259 = phi_359_;
            if _e259 {
                if (0f > 0f) {
                    let _e262 = samples.member[(0u + _e51.first_primitive)].normal;
                    let _e264 = p.member.map_size;
                    let _e267 = p.member.projection.row_x;
                    let _e289 = p.member.projection.row_y;
                    let _e311 = p.member.projection.row_z;
                    let _e338 = ((abs(((((_e267.x * _e262.x) + (_e267.y * _e262.y)) + (_e267.z * _e262.z)) / (((_e267.x * _e267.x) + (_e267.y * _e267.y)) + (_e267.z * _e267.z)))) + abs(((((_e289.x * _e262.x) + (_e289.y * _e262.y)) + (_e289.z * _e262.z)) / (((_e289.x * _e289.x) + (_e289.y * _e289.y)) + (_e289.z * _e289.z))))) / (abs(((((_e311.x * _e262.x) + (_e311.y * _e262.y)) + (_e311.z * _e262.z)) / (((_e311.x * _e311.x) + (_e311.y * _e311.y)) + (_e311.z * _e311.z)))) * f32(_e264)));
                    if (_e338 < 0.002f) {
                        phi_453_ = _e338;
                    } else {
                        phi_453_ = 0.002f;
                    }
                    let _e341 = phi_453_;
                    phi_456_ = (_e232 - (0f * _e341));
                } else {
                    phi_456_ = _e232;
                }
                let _e345 = phi_456_;
                let _e347 = p.member.map_size;
                let _e348 = f32(_e347);
                let _e351 = ((_e205 * _e348) - 0.5f);
                let _e352 = ((_e219 * _e348) - 0.5f);
                if (_e351 > -8388608f) {
                    let _e364 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e364 > _e351) {
                        phi_485_ = 1f;
                    } else {
                        phi_485_ = 0f;
                    }
                    let _e367 = phi_485_;
                    if (_e351 < 8388608f) {
                        phi_490_ = (_e364 - _e367);
                        phi_491_ = false;
                    } else {
                        phi_490_ = f32();
                        phi_491_ = true;
                    }
                    let _e370 = phi_490_;
                    let _e372 = phi_491_;
                    phi_492_ = _e370;
                    phi_493_ = _e372;
                } else {
                    phi_492_ = f32();
                    phi_493_ = true;
                }
                let _e374 = phi_492_;
                let _e376 = phi_493_;
                if _e376 {
                    phi_497_ = _e351;
                } else {
                    phi_497_ = _e374;
                }
                let _e378 = phi_497_;
                if (_e352 > -8388608f) {
                    let _e390 = f32(select(0i, select(select(i32(_e352), i32(-2147483648), (_e352 < bitcast<f32>(3472883712u))), 2147483647i, (_e352 > bitcast<f32>(1325400063u))), (_e352 == _e352)));
                    if (_e390 > _e352) {
                        phi_517_ = 1f;
                    } else {
                        phi_517_ = 0f;
                    }
                    let _e393 = phi_517_;
                    if (_e352 < 8388608f) {
                        phi_522_ = (_e390 - _e393);
                        phi_523_ = false;
                    } else {
                        phi_522_ = f32();
                        phi_523_ = true;
                    }
                    let _e396 = phi_522_;
                    let _e398 = phi_523_;
                    phi_524_ = _e396;
                    phi_525_ = _e398;
                } else {
                    phi_524_ = f32();
                    phi_525_ = true;
                }
                let _e400 = phi_524_;
                let _e402 = phi_525_;
                if _e402 {
                    phi_529_ = _e352;
                } else {
                    phi_529_ = _e400;
                }
                let _e404 = phi_529_;
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
                let _e439 = (bitcast<i32>(_e437) - 1i);
                if (_e415 > 0i) {
                    phi_575_ = _e415;
                } else {
                    phi_575_ = 0i;
                }
                let _e442 = phi_575_;
                if (_e424 > 0i) {
                    phi_580_ = _e424;
                } else {
                    phi_580_ = 0i;
                }
                let _e445 = phi_580_;
                if (_e442 < _e439) {
                    phi_585_ = _e442;
                } else {
                    phi_585_ = _e439;
                }
                let _e448 = phi_585_;
                if (_e445 < _e439) {
                    phi_590_ = _e445;
                } else {
                    phi_590_ = _e439;
                }
                let _e451 = phi_590_;
                let _e452 = bitcast<u32>(_e448);
                let _e454 = (_e415 + 1i);
                let _e455 = (_e424 + 1i);
                if (_e454 > 0i) {
                    phi_599_ = _e454;
                } else {
                    phi_599_ = 0i;
                }
                let _e458 = phi_599_;
                if (_e455 > 0i) {
                    phi_604_ = _e455;
                } else {
                    phi_604_ = 0i;
                }
                let _e461 = phi_604_;
                if (_e458 < _e439) {
                    phi_609_ = _e458;
                } else {
                    phi_609_ = _e439;
                }
                let _e464 = phi_609_;
                if (_e461 < _e439) {
                    phi_614_ = _e461;
                } else {
                    phi_614_ = _e439;
                }
                let _e467 = phi_614_;
                let _e468 = bitcast<u32>(_e464);
                let _e470 = (bitcast<u32>(_e451) * _e437);
                let _e471 = (bitcast<u32>(_e467) * _e437);
                let _e472 = (_e470 + _e452);
                let _e473 = (_e470 + _e468);
                let _e474 = (_e471 + _e452);
                let _e475 = (_e471 + _e468);
                if (_e472 < _e42) {
                } else {
                    return;
                }
                let _e479 = map.member[(0u + _e472)];
                if (_e473 < _e42) {
                } else {
                    return;
                }
                let _e491 = map.member[(0u + _e473)];
                if (_e474 < _e42) {
                } else {
                    return;
                }
                let _e507 = map.member[(0u + _e474)];
                if (_e475 < _e42) {
                } else {
                    return;
                }
                let _e523 = map.member[(0u + _e475)];
                let _e537 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e479.x * _e427) + (_e491.x * _e429)) + (_e507.x * _e431)) + (_e523.x * _e432)), ((((_e479.y * _e427) + (_e491.y * _e429)) + (_e507.y * _e431)) + (_e523.y * _e432)), ((((_e479.z * _e427) + (_e491.z * _e429)) + (_e507.z * _e431)) + (_e523.z * _e432)), ((((_e479.w * _e427) + (_e491.w * _e429)) + (_e507.w * _e431)) + (_e523.w * _e432))), _e345);
                phi_699_ = evaluate_Verdict(_e537, false);
                phi_700_ = evaluate_Verdict();
                phi_701_ = false;
            } else {
                phi_699_ = evaluate_Verdict();
                phi_700_ = evaluate_Verdict(1f, false);
                phi_701_ = true;
            }
            let _e541 = phi_699_;
            let _e543 = phi_700_;
            let _e545 = phi_701_;
            phi_702_ = _e543;
            phi_703_ = _e541;
            phi_704_ = _e545;
        }
        let _e547 = phi_702_;
        let _e549 = phi_703_;
        let _e551 = phi_704_;
        if _e551 {
            phi_708_ = _e547;
        } else {
            phi_708_ = _e549;
        }
        let _e553 = phi_708_;
        if (_e51.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e51.first_primitive)] = _e553.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
