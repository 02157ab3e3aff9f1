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

struct type_29 {
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

struct type_33 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_33;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(2) 
var<storage> map: type_29;

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
        let _e47 = phi_130_;
        let _e49 = phi_131_;
        phi_132_ = _e47;
        phi_133_ = _e49;
    } else {
        phi_132_ = lt_bvh_traverse_Tree();
        phi_133_ = true;
    }
    let _e51 = phi_132_;
    let _e53 = phi_133_;
    if _e53 {
        phi_138_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_138_ = _e51;
    }
    let _e58 = phi_138_;
    return lt_bvh_traverse_Tree(_e58.root, _e58.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_163_: f32;
    var phi_164_: f32;
    var phi_165_: f32;
    var phi_183_: bool;
    var phi_187_: f32;
    var phi_199_: bool;
    var phi_206_: f32;
    var phi_221_: f32;
    var phi_222_: f32;
    var phi_223_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_165_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_164_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_163_ = 1f;
            } else {
                phi_163_ = param_6;
            }
            let _e43 = phi_163_;
            phi_164_ = _e43;
        }
        let _e45 = phi_164_;
        phi_165_ = _e45;
    }
    let _e47 = phi_165_;
    let _e50 = (*param_4);
    let _e54 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e50) & 2147483647u) > 2139095040u) {
        phi_183_ = true;
    } else {
        let _e58 = (_e50 > _e54);
        if _e58 {
        }
        phi_183_ = _e58;
    }
    let _e60 = phi_183_;
    if _e60 {
        phi_187_ = _e50;
    } else {
        phi_187_ = _e54;
    }
    let _e62 = phi_187_;
    let _e63 = (_e47 - param_5.x);
    if (_e63 <= 0f) {
        let _e67 = ((bitcast<u32>(_e62) & 2147483647u) > 2139095040u);
        if _e67 {
        }
        phi_199_ = _e67;
    } else {
        phi_199_ = true;
    }
    let _e69 = phi_199_;
    if _e69 {
        phi_206_ = (_e62 / (_e62 + (_e63 * _e63)));
    } else {
        phi_206_ = 1f;
    }
    let _e74 = phi_206_;
    if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
        phi_223_ = _e74;
    } else {
        if (_e74 < 0f) {
            phi_222_ = 0f;
        } else {
            if (_e74 > 1f) {
                phi_221_ = 1f;
            } else {
                phi_221_ = _e74;
            }
            let _e81 = phi_221_;
            phi_222_ = _e81;
        }
        let _e83 = phi_222_;
        phi_223_ = _e83;
    }
    let _e85 = phi_223_;
    return _e85;
}

fn function_() {
    var local: f32;
    var phi_277_: bool;
    var phi_278_: bool;
    var phi_279_: bool;
    var phi_280_: bool;
    var phi_284_: bool;
    var phi_328_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_332_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_409_: bool;
    var phi_418_: bool;
    var phi_427_: bool;
    var phi_428_: bool;
    var phi_429_: bool;
    var phi_430_: bool;
    var phi_431_: bool;
    var phi_432_: bool;
    var phi_433_: bool;
    var phi_437_: bool;
    var phi_531_: f32;
    var phi_534_: f32;
    var phi_563_: f32;
    var phi_568_: f32;
    var phi_569_: bool;
    var phi_570_: f32;
    var phi_571_: bool;
    var phi_575_: f32;
    var phi_595_: f32;
    var phi_600_: f32;
    var phi_601_: bool;
    var phi_602_: f32;
    var phi_603_: bool;
    var phi_607_: f32;
    var phi_653_: i32;
    var phi_658_: i32;
    var phi_663_: i32;
    var phi_668_: i32;
    var phi_677_: i32;
    var phi_682_: i32;
    var phi_687_: i32;
    var phi_692_: i32;
    var phi_783_: bool;
    var phi_791_: bool;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_808_: f32;
    var phi_814_: f32;
    var phi_816_: evaluate_Verdict;
    var phi_821_: evaluate_Verdict;
    var phi_822_: evaluate_Verdict;

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
                phi_277_ = (_e73 == _e75);
                phi_278_ = false;
            } else {
                phi_277_ = bool();
                phi_278_ = true;
            }
            let _e78 = phi_277_;
            let _e80 = phi_278_;
            phi_279_ = _e78;
            phi_280_ = _e80;
        } else {
            phi_279_ = bool();
            phi_280_ = true;
        }
        let _e82 = phi_279_;
        let _e84 = phi_280_;
        if _e84 {
            phi_284_ = false;
        } else {
            phi_284_ = _e82;
        }
        let _e86 = phi_284_;
        if !(_e86) {
            let _e89 = samples.member[(0u + _e51.first_primitive)].normal;
            let _e91 = samples.member[(0u + _e51.first_primitive)].position;
            if ((((_e89.x * (_e60.x - (_e91.x * _e60.w))) + (_e89.y * (_e60.y - (_e91.y * _e60.w)))) + (_e89.z * (_e60.z - (_e91.z * _e60.w)))) > 0f) {
                let _e115 = samples.member[(0u + _e51.first_primitive)].flags;
                let _e123 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e123.unnamed.visibility, false), _e123.unnamed_1);
                phi_328_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e129.unnamed, ((_e115 & 1u) == 0u));
            } else {
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_328_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, true);
            }
            let _e149 = phi_328_;
            phi_332_ = _e149;
        } else {
            let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e155.unnamed.visibility, false), _e155.unnamed_1);
            phi_332_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e161.unnamed, true);
        }
        let _e166 = phi_332_;
        if _e166.unnamed_1 {
            phi_822_ = evaluate_Verdict(_e166.unnamed.visibility, _e166.unnamed.is_doubted);
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
                    phi_409_ = (_e205 <= 1f);
                } else {
                    phi_409_ = false;
                }
                let _e237 = phi_409_;
                if _e237 {
                    if (_e219 >= 0f) {
                        phi_418_ = (_e219 <= 1f);
                    } else {
                        phi_418_ = false;
                    }
                    let _e241 = phi_418_;
                    if _e241 {
                        if (_e232 >= 0f) {
                            phi_427_ = (_e232 <= 1f);
                        } else {
                            phi_427_ = false;
                        }
                        let _e245 = phi_427_;
                        phi_428_ = _e245;
                        phi_429_ = false;
                    } else {
                        phi_428_ = bool();
                        phi_429_ = true;
                    }
                    let _e247 = phi_428_;
                    let _e249 = phi_429_;
                    phi_430_ = _e247;
                    phi_431_ = _e249;
                } else {
                    phi_430_ = bool();
                    phi_431_ = true;
                }
                let _e251 = phi_430_;
                let _e253 = phi_431_;
                phi_432_ = _e251;
                phi_433_ = _e253;
            } else {
                phi_432_ = bool();
                phi_433_ = true;
            }
            let _e255 = phi_432_;
            let _e257 = phi_433_;
            if _e257 {
                phi_437_ = false;
            } else {
                phi_437_ = _e255;
            }
            let _e259 = phi_437_;
            if _e259 {
                if (0f > 0f) {
                    let _e262 = samples.member[(0u + _e51.first_primitive)].normal;
                    let _e264 = p.member.map_size;
                    let _e267 = p.member.projection.row_x;
                    let _e289 = p.member.projection.row_y;
                    let _e311 = p.member.projection.row_z;
                    let _e338 = ((abs(((((_e267.x * _e262.x) + (_e267.y * _e262.y)) + (_e267.z * _e262.z)) / (((_e267.x * _e267.x) + (_e267.y * _e267.y)) + (_e267.z * _e267.z)))) + abs(((((_e289.x * _e262.x) + (_e289.y * _e262.y)) + (_e289.z * _e262.z)) / (((_e289.x * _e289.x) + (_e289.y * _e289.y)) + (_e289.z * _e289.z))))) / (abs(((((_e311.x * _e262.x) + (_e311.y * _e262.y)) + (_e311.z * _e262.z)) / (((_e311.x * _e311.x) + (_e311.y * _e311.y)) + (_e311.z * _e311.z)))) * f32(_e264)));
                    if (_e338 < 0.002f) {
                        phi_531_ = _e338;
                    } else {
                        phi_531_ = 0.002f;
                    }
                    let _e341 = phi_531_;
                    phi_534_ = (_e232 - (0f * _e341));
                } else {
                    phi_534_ = _e232;
                }
                let _e345 = phi_534_;
                let _e347 = p.member.map_size;
                let _e348 = f32(_e347);
                let _e351 = ((_e205 * _e348) - 0.5f);
                let _e352 = ((_e219 * _e348) - 0.5f);
                if (_e351 > -8388608f) {
                    let _e364 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e364 > _e351) {
                        phi_563_ = 1f;
                    } else {
                        phi_563_ = 0f;
                    }
                    let _e367 = phi_563_;
                    if (_e351 < 8388608f) {
                        phi_568_ = (_e364 - _e367);
                        phi_569_ = false;
                    } else {
                        phi_568_ = f32();
                        phi_569_ = true;
                    }
                    let _e370 = phi_568_;
                    let _e372 = phi_569_;
                    phi_570_ = _e370;
                    phi_571_ = _e372;
                } else {
                    phi_570_ = f32();
                    phi_571_ = true;
                }
                let _e374 = phi_570_;
                let _e376 = phi_571_;
                if _e376 {
                    phi_575_ = _e351;
                } else {
                    phi_575_ = _e374;
                }
                let _e378 = phi_575_;
                if (_e352 > -8388608f) {
                    let _e390 = f32(select(0i, select(select(i32(_e352), i32(-2147483648), (_e352 < bitcast<f32>(3472883712u))), 2147483647i, (_e352 > bitcast<f32>(1325400063u))), (_e352 == _e352)));
                    if (_e390 > _e352) {
                        phi_595_ = 1f;
                    } else {
                        phi_595_ = 0f;
                    }
                    let _e393 = phi_595_;
                    if (_e352 < 8388608f) {
                        phi_600_ = (_e390 - _e393);
                        phi_601_ = false;
                    } else {
                        phi_600_ = f32();
                        phi_601_ = true;
                    }
                    let _e396 = phi_600_;
                    let _e398 = phi_601_;
                    phi_602_ = _e396;
                    phi_603_ = _e398;
                } else {
                    phi_602_ = f32();
                    phi_603_ = true;
                }
                let _e400 = phi_602_;
                let _e402 = phi_603_;
                if _e402 {
                    phi_607_ = _e352;
                } else {
                    phi_607_ = _e400;
                }
                let _e404 = phi_607_;
                let _e405 = (_e351 - _e378);
                let _e406 = (_e352 - _e404);
                let _e415 = select(0i, select(select(i32(_e378), i32(-2147483648), (_e378 < bitcast<f32>(3472883712u))), 2147483647i, (_e378 > bitcast<f32>(1325400063u))), (_e378 == _e378));
                let _e424 = select(0i, select(select(i32(_e404), i32(-2147483648), (_e404 < bitcast<f32>(3472883712u))), 2147483647i, (_e404 > bitcast<f32>(1325400063u))), (_e404 == _e404));
                let _e427 = ((1f - _e405) * (1f - _e406));
                let _e429 = (_e405 * (1f - _e406));
                let _e431 = ((1f - _e405) * _e406);
                let _e432 = (_e405 * _e406);
                let _e434 = p.member.test;
                let _e435 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e434);
                let _e437 = p.member.map_size;
                local = _e435;
                let _e439 = (bitcast<i32>(_e437) - 1i);
                if (_e415 > 0i) {
                    phi_653_ = _e415;
                } else {
                    phi_653_ = 0i;
                }
                let _e442 = phi_653_;
                if (_e424 > 0i) {
                    phi_658_ = _e424;
                } else {
                    phi_658_ = 0i;
                }
                let _e445 = phi_658_;
                if (_e442 < _e439) {
                    phi_663_ = _e442;
                } else {
                    phi_663_ = _e439;
                }
                let _e448 = phi_663_;
                if (_e445 < _e439) {
                    phi_668_ = _e445;
                } else {
                    phi_668_ = _e439;
                }
                let _e451 = phi_668_;
                let _e452 = bitcast<u32>(_e448);
                let _e454 = (_e415 + 1i);
                let _e455 = (_e424 + 1i);
                if (_e454 > 0i) {
                    phi_677_ = _e454;
                } else {
                    phi_677_ = 0i;
                }
                let _e458 = phi_677_;
                if (_e455 > 0i) {
                    phi_682_ = _e455;
                } else {
                    phi_682_ = 0i;
                }
                let _e461 = phi_682_;
                if (_e458 < _e439) {
                    phi_687_ = _e458;
                } else {
                    phi_687_ = _e439;
                }
                let _e464 = phi_687_;
                if (_e461 < _e439) {
                    phi_692_ = _e461;
                } else {
                    phi_692_ = _e439;
                }
                let _e467 = phi_692_;
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
                let _e537 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e479.x * _e427) + (_e491.x * _e429)) + (_e507.x * _e431)) + (_e523.x * _e432)), ((((_e479.y * _e427) + (_e491.y * _e429)) + (_e507.y * _e431)) + (_e523.y * _e432)), ((((_e479.z * _e427) + (_e491.z * _e429)) + (_e507.z * _e431)) + (_e523.z * _e432)), ((((_e479.w * _e427) + (_e491.w * _e429)) + (_e507.w * _e431)) + (_e523.w * _e432))), _e345);
                let _e539 = p.member.epsilon;
                if (_e537 <= _e539) {
                    phi_783_ = true;
                } else {
                    phi_783_ = (_e537 >= (1f - _e539));
                }
                let _e544 = phi_783_;
                if ((bitcast<u32>(_e537) & 2147483647u) > 2139095040u) {
                    phi_791_ = true;
                } else {
                    phi_791_ = !(_e544);
                }
                let _e550 = phi_791_;
                if _e550 {
                    if (_e537 > 0f) {
                        if (_e537 < 1f) {
                            phi_803_ = false;
                        } else {
                            phi_803_ = true;
                        }
                        let _e554 = phi_803_;
                        phi_804_ = _e554;
                    } else {
                        phi_804_ = true;
                    }
                    let _e556 = phi_804_;
                    if _e556 {
                        phi_808_ = 0.5f;
                    } else {
                        phi_808_ = _e537;
                    }
                    let _e558 = phi_808_;
                    phi_816_ = evaluate_Verdict(_e558, true);
                } else {
                    if (_e537 > 0.5f) {
                        phi_814_ = 1f;
                    } else {
                        phi_814_ = 0f;
                    }
                    let _e562 = phi_814_;
                    phi_816_ = evaluate_Verdict(_e562, false);
                }
                let _e565 = phi_816_;
                phi_821_ = evaluate_Verdict(_e565.visibility, _e565.is_doubted);
            } else {
                phi_821_ = evaluate_Verdict(0.5f, true);
            }
            let _e571 = phi_821_;
            phi_822_ = _e571;
        }
        let _e573 = phi_822_;
        if (_e51.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e51.first_primitive)] = _e573.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_vsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
