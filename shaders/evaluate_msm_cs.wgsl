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

struct type_29 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_29;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_128_: lt_bvh_traverse_Tree;
    var phi_129_: bool;
    var phi_130_: lt_bvh_traverse_Tree;
    var phi_131_: bool;
    var phi_136_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_128_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_129_ = false;
        } else {
            phi_128_ = lt_bvh_traverse_Tree();
            phi_129_ = true;
        }
        let _e47 = phi_128_;
        let _e49 = phi_129_;
        phi_130_ = _e47;
        phi_131_ = _e49;
    } else {
        phi_130_ = lt_bvh_traverse_Tree();
        phi_131_ = true;
    }
    let _e51 = phi_130_;
    let _e53 = phi_131_;
    if _e53 {
        phi_136_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_136_ = _e51;
    }
    let _e58 = phi_136_;
    return lt_bvh_traverse_Tree(_e58.root, _e58.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_159_: f32;
    var phi_160_: f32;
    var phi_161_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_161_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_160_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_159_ = 1f;
            } else {
                phi_159_ = param_4;
            }
            let _e41 = phi_159_;
            phi_160_ = _e41;
        }
        let _e43 = phi_160_;
        phi_161_ = _e43;
    }
    let _e45 = phi_161_;
    let _e46 = (_e45 * _e45);
    return vec4<f32>(_e45, _e46, (_e46 * _e45), (_e46 * _e46));
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_782_: f32;
    var phi_783_: f32;
    var phi_784_: f32;
    var phi_790_: bool;
    var phi_812_: f32;
    var phi_813_: f32;
    var phi_814_: f32;
    var phi_815_: f32;
    var phi_816_: bool;
    var phi_817_: f32;
    var phi_818_: bool;
    var phi_856_: vec2<f32>;
    var phi_890_: f32;
    var phi_891_: f32;
    var phi_892_: f32;
    var phi_921_: f32;
    var phi_922_: f32;
    var phi_923_: f32;
    var phi_927_: f32;
    var phi_928_: f32;
    var phi_929_: f32;
    var phi_930_: f32;

    let _e37 = (*param_5);
    let _e38 = (1f - _e37);
    let _e47 = (0.5f * _e37);
    let _e48 = ((param_6.x * _e38) + _e47);
    let _e49 = ((param_6.y * _e38) + _e47);
    let _e51 = ((param_6.w * _e38) + _e47);
    let _e53 = (_e49 - (_e48 * _e48));
    let _e55 = (((param_6.z * _e38) + _e47) - (_e48 * _e49));
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_784_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_783_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_782_ = 1f;
            } else {
                phi_782_ = param_7;
            }
            let _e67 = phi_782_;
            phi_783_ = _e67;
        }
        let _e69 = phi_783_;
        phi_784_ = _e69;
    }
    let _e71 = phi_784_;
    if (_e48 == _e51) {
        phi_790_ = (_e48 > 0.5f);
    } else {
        phi_790_ = false;
    }
    let _e75 = phi_790_;
    if _e75 {
        if (_e71 > 0f) {
            if ((bitcast<u32>(_e48) & 2147483647u) > 2139095040u) {
                phi_814_ = _e48;
            } else {
                if (_e48 < 0f) {
                    phi_813_ = 0f;
                } else {
                    if (_e48 > 1f) {
                        phi_812_ = 1f;
                    } else {
                        phi_812_ = _e48;
                    }
                    let _e83 = phi_812_;
                    phi_813_ = _e83;
                }
                let _e85 = phi_813_;
                phi_814_ = _e85;
            }
            let _e87 = phi_814_;
            phi_815_ = _e87;
            phi_816_ = false;
        } else {
            phi_815_ = f32();
            phi_816_ = true;
        }
        let _e89 = phi_815_;
        let _e91 = phi_816_;
        phi_817_ = _e89;
        phi_818_ = _e91;
    } else {
        phi_817_ = f32();
        phi_818_ = true;
    }
    let _e93 = phi_817_;
    let _e95 = phi_818_;
    if _e95 {
        let _e96 = (_e55 / _e53);
        let _e97 = (_e71 - _e48);
        let _e103 = (((((_e71 * _e71) - _e49) - (_e96 * _e97)) * _e53) / (((_e51 - (_e49 * _e49)) * _e53) - (_e55 * _e55)));
        let _e106 = ((_e97 / _e53) - (_e96 * _e103));
        let _e112 = ((0.5f * _e106) / _e103);
        let _e115 = ((_e112 * _e112) - (((1f - (_e106 * _e48)) - (_e103 * _e49)) / _e103));
        if (_e115 >= 0f) {
            let _e117 = sqrt(_e115);
            phi_856_ = vec2<f32>((-(_e112) - _e117), (-(_e112) + _e117));
        } else {
            phi_856_ = vec2(bitcast<f32>((bitcast<u32>(_e115) | 2143289344u)));
        }
        let _e128 = phi_856_;
        if (_e71 <= _e128.x) {
            phi_929_ = 1f;
        } else {
            if (_e71 > _e128.y) {
                let _e141 = (((_e49 - (_e48 * (_e128.x + _e128.y))) + (_e128.x * _e128.y)) / ((_e71 - _e128.x) * (_e71 - _e128.y)));
                if ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u) {
                    phi_892_ = _e141;
                } else {
                    if (_e141 < 0f) {
                        phi_891_ = 0f;
                    } else {
                        if (_e141 > 1f) {
                            phi_890_ = 1f;
                        } else {
                            phi_890_ = _e141;
                        }
                        let _e148 = phi_890_;
                        phi_891_ = _e148;
                    }
                    let _e150 = phi_891_;
                    phi_892_ = _e150;
                }
                let _e152 = phi_892_;
                phi_928_ = _e152;
            } else {
                if (_e71 > _e128.x) {
                    let _e163 = (1f - (((_e49 - (_e48 * (_e71 + _e128.y))) + (_e71 * _e128.y)) / ((_e128.x - _e71) * (_e128.x - _e128.y))));
                    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
                        phi_923_ = _e163;
                    } else {
                        if (_e163 < 0f) {
                            phi_922_ = 0f;
                        } else {
                            if (_e163 > 1f) {
                                phi_921_ = 1f;
                            } else {
                                phi_921_ = _e163;
                            }
                            let _e170 = phi_921_;
                            phi_922_ = _e170;
                        }
                        let _e172 = phi_922_;
                        phi_923_ = _e172;
                    }
                    let _e174 = phi_923_;
                    phi_927_ = _e174;
                } else {
                    phi_927_ = bitcast<f32>((bitcast<u32>(_e128.x) | 2143289344u));
                }
                let _e179 = phi_927_;
                phi_928_ = _e179;
            }
            let _e181 = phi_928_;
            phi_929_ = _e181;
        }
        let _e183 = phi_929_;
        phi_930_ = _e183;
    } else {
        phi_930_ = _e93;
    }
    let _e185 = phi_930_;
    return _e185;
}

fn function_() {
    var local: f32;
    var phi_219_: bool;
    var phi_220_: bool;
    var phi_221_: bool;
    var phi_222_: bool;
    var phi_226_: bool;
    var phi_270_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_274_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_351_: bool;
    var phi_360_: bool;
    var phi_369_: bool;
    var phi_370_: bool;
    var phi_371_: bool;
    var phi_372_: bool;
    var phi_373_: bool;
    var phi_374_: bool;
    var phi_375_: bool;
    var phi_379_: bool;
    var phi_473_: f32;
    var phi_476_: f32;
    var phi_505_: f32;
    var phi_510_: f32;
    var phi_511_: bool;
    var phi_512_: f32;
    var phi_513_: bool;
    var phi_517_: f32;
    var phi_537_: f32;
    var phi_542_: f32;
    var phi_543_: bool;
    var phi_544_: f32;
    var phi_545_: bool;
    var phi_549_: f32;
    var phi_595_: i32;
    var phi_600_: i32;
    var phi_605_: i32;
    var phi_610_: i32;
    var phi_619_: i32;
    var phi_624_: i32;
    var phi_629_: i32;
    var phi_634_: i32;
    var phi_723_: evaluate_Verdict;
    var phi_724_: evaluate_Verdict;
    var phi_725_: bool;
    var phi_726_: evaluate_Verdict;
    var phi_727_: evaluate_Verdict;
    var phi_728_: bool;
    var phi_732_: evaluate_Verdict;

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
                phi_219_ = (_e73 == _e75);
                phi_220_ = false;
            } else {
                phi_219_ = bool();
                phi_220_ = true;
            }
            let _e78 = phi_219_;
            let _e80 = phi_220_;
            phi_221_ = _e78;
            phi_222_ = _e80;
        } else {
            phi_221_ = bool();
            phi_222_ = true;
        }
        let _e82 = phi_221_;
        let _e84 = phi_222_;
        if _e84 {
            phi_226_ = false;
        } else {
            phi_226_ = _e82;
        }
        let _e86 = phi_226_;
        if !(_e86) {
            let _e89 = samples.member[(0u + _e51.first_primitive)].normal;
            let _e91 = samples.member[(0u + _e51.first_primitive)].position;
            if ((((_e89.x * (_e60.x - (_e91.x * _e60.w))) + (_e89.y * (_e60.y - (_e91.y * _e60.w)))) + (_e89.z * (_e60.z - (_e91.z * _e60.w)))) > 0f) {
                let _e115 = samples.member[(0u + _e51.first_primitive)].flags;
                let _e123 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e123.unnamed.visibility, false), _e123.unnamed_1);
                phi_270_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e129.unnamed, ((_e115 & 1u) == 0u));
            } else {
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_270_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, true);
            }
            let _e149 = phi_270_;
            phi_274_ = _e149;
        } else {
            let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e155.unnamed.visibility, false), _e155.unnamed_1);
            phi_274_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e161.unnamed, true);
        }
        let _e166 = phi_274_;
        if _e166.unnamed_1 {
            phi_726_ = evaluate_Verdict(_e166.unnamed.visibility, _e166.unnamed.is_doubted);
            phi_727_ = evaluate_Verdict();
            phi_728_ = true;
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
                    phi_351_ = (_e205 <= 1f);
                } else {
                    phi_351_ = false;
                }
                let _e237 = phi_351_;
                if _e237 {
                    if (_e219 >= 0f) {
                        phi_360_ = (_e219 <= 1f);
                    } else {
                        phi_360_ = false;
                    }
                    let _e241 = phi_360_;
                    if _e241 {
                        if (_e232 >= 0f) {
                            phi_369_ = (_e232 <= 1f);
                        } else {
                            phi_369_ = false;
                        }
                        let _e245 = phi_369_;
                        phi_370_ = _e245;
                        phi_371_ = false;
                    } else {
                        phi_370_ = bool();
                        phi_371_ = true;
                    }
                    let _e247 = phi_370_;
                    let _e249 = phi_371_;
                    phi_372_ = _e247;
                    phi_373_ = _e249;
                } else {
                    phi_372_ = bool();
                    phi_373_ = true;
                }
                let _e251 = phi_372_;
                let _e253 = phi_373_;
                phi_374_ = _e251;
                phi_375_ = _e253;
            } else {
                phi_374_ = bool();
                phi_375_ = true;
            }
            let _e255 = phi_374_;
            let _e257 = phi_375_;
            if _e257 {
                phi_379_ = false;
            } else {
                phi_379_ = _e255;
            }
            let _e259 = phi_379_;
            if _e259 {
                if (0f > 0f) {
                    let _e262 = samples.member[(0u + _e51.first_primitive)].normal;
                    let _e264 = p.member.map_size;
                    let _e267 = p.member.projection.row_x;
                    let _e289 = p.member.projection.row_y;
                    let _e311 = p.member.projection.row_z;
                    let _e338 = ((abs(((((_e267.x * _e262.x) + (_e267.y * _e262.y)) + (_e267.z * _e262.z)) / (((_e267.x * _e267.x) + (_e267.y * _e267.y)) + (_e267.z * _e267.z)))) + abs(((((_e289.x * _e262.x) + (_e289.y * _e262.y)) + (_e289.z * _e262.z)) / (((_e289.x * _e289.x) + (_e289.y * _e289.y)) + (_e289.z * _e289.z))))) / (abs(((((_e311.x * _e262.x) + (_e311.y * _e262.y)) + (_e311.z * _e262.z)) / (((_e311.x * _e311.x) + (_e311.y * _e311.y)) + (_e311.z * _e311.z)))) * f32(_e264)));
                    if (_e338 < 0.002f) {
                        phi_473_ = _e338;
                    } else {
                        phi_473_ = 0.002f;
                    }
                    let _e341 = phi_473_;
                    phi_476_ = (_e232 - (0f * _e341));
                } else {
                    phi_476_ = _e232;
                }
                let _e345 = phi_476_;
                let _e347 = p.member.map_size;
                let _e348 = f32(_e347);
                let _e351 = ((_e205 * _e348) - 0.5f);
                let _e352 = ((_e219 * _e348) - 0.5f);
                if (_e351 > -8388608f) {
                    let _e364 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e364 > _e351) {
                        phi_505_ = 1f;
                    } else {
                        phi_505_ = 0f;
                    }
                    let _e367 = phi_505_;
                    if (_e351 < 8388608f) {
                        phi_510_ = (_e364 - _e367);
                        phi_511_ = false;
                    } else {
                        phi_510_ = f32();
                        phi_511_ = true;
                    }
                    let _e370 = phi_510_;
                    let _e372 = phi_511_;
                    phi_512_ = _e370;
                    phi_513_ = _e372;
                } else {
                    phi_512_ = f32();
                    phi_513_ = true;
                }
                let _e374 = phi_512_;
                let _e376 = phi_513_;
                if _e376 {
                    phi_517_ = _e351;
                } else {
                    phi_517_ = _e374;
                }
                let _e378 = phi_517_;
                if (_e352 > -8388608f) {
                    let _e390 = f32(select(0i, select(select(i32(_e352), i32(-2147483648), (_e352 < bitcast<f32>(3472883712u))), 2147483647i, (_e352 > bitcast<f32>(1325400063u))), (_e352 == _e352)));
                    if (_e390 > _e352) {
                        phi_537_ = 1f;
                    } else {
                        phi_537_ = 0f;
                    }
                    let _e393 = phi_537_;
                    if (_e352 < 8388608f) {
                        phi_542_ = (_e390 - _e393);
                        phi_543_ = false;
                    } else {
                        phi_542_ = f32();
                        phi_543_ = true;
                    }
                    let _e396 = phi_542_;
                    let _e398 = phi_543_;
                    phi_544_ = _e396;
                    phi_545_ = _e398;
                } else {
                    phi_544_ = f32();
                    phi_545_ = true;
                }
                let _e400 = phi_544_;
                let _e402 = phi_545_;
                if _e402 {
                    phi_549_ = _e352;
                } else {
                    phi_549_ = _e400;
                }
                let _e404 = phi_549_;
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
                    phi_595_ = _e415;
                } else {
                    phi_595_ = 0i;
                }
                let _e442 = phi_595_;
                if (_e424 > 0i) {
                    phi_600_ = _e424;
                } else {
                    phi_600_ = 0i;
                }
                let _e445 = phi_600_;
                if (_e442 < _e439) {
                    phi_605_ = _e442;
                } else {
                    phi_605_ = _e439;
                }
                let _e448 = phi_605_;
                if (_e445 < _e439) {
                    phi_610_ = _e445;
                } else {
                    phi_610_ = _e439;
                }
                let _e451 = phi_610_;
                let _e452 = bitcast<u32>(_e448);
                let _e454 = (_e415 + 1i);
                let _e455 = (_e424 + 1i);
                if (_e454 > 0i) {
                    phi_619_ = _e454;
                } else {
                    phi_619_ = 0i;
                }
                let _e458 = phi_619_;
                if (_e455 > 0i) {
                    phi_624_ = _e455;
                } else {
                    phi_624_ = 0i;
                }
                let _e461 = phi_624_;
                if (_e458 < _e439) {
                    phi_629_ = _e458;
                } else {
                    phi_629_ = _e439;
                }
                let _e464 = phi_629_;
                if (_e461 < _e439) {
                    phi_634_ = _e461;
                } else {
                    phi_634_ = _e439;
                }
                let _e467 = phi_634_;
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
                let _e483 = map.member[(0u + _e473)];
                if (_e474 < _e42) {
                } else {
                    return;
                }
                let _e487 = map.member[(0u + _e474)];
                if (_e475 < _e42) {
                } else {
                    return;
                }
                let _e491 = map.member[(0u + _e475)];
                let _e492 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e479);
                let _e493 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e483);
                let _e494 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e487);
                let _e495 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e491);
                let _e541 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e492.x * _e427) + (_e493.x * _e429)) + (_e494.x * _e431)) + (_e495.x * _e432)), ((((_e492.y * _e427) + (_e493.y * _e429)) + (_e494.y * _e431)) + (_e495.y * _e432)), ((((_e492.z * _e427) + (_e493.z * _e429)) + (_e494.z * _e431)) + (_e495.z * _e432)), ((((_e492.w * _e427) + (_e493.w * _e429)) + (_e494.w * _e431)) + (_e495.w * _e432))), _e345);
                phi_723_ = evaluate_Verdict(_e541, false);
                phi_724_ = evaluate_Verdict();
                phi_725_ = false;
            } else {
                phi_723_ = evaluate_Verdict();
                phi_724_ = evaluate_Verdict(1f, false);
                phi_725_ = true;
            }
            let _e545 = phi_723_;
            let _e547 = phi_724_;
            let _e549 = phi_725_;
            phi_726_ = _e547;
            phi_727_ = _e545;
            phi_728_ = _e549;
        }
        let _e551 = phi_726_;
        let _e553 = phi_727_;
        let _e555 = phi_728_;
        if _e555 {
            phi_732_ = _e551;
        } else {
            phi_732_ = _e553;
        }
        let _e557 = phi_732_;
        if (_e51.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e51.first_primitive)] = _e557.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
