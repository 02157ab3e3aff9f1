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
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_33 {
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
var<uniform> p: type_33;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(2) 
var<storage> map: type_29;

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

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_164_: f32;
    var phi_165_: f32;
    var phi_166_: f32;
    var phi_184_: bool;
    var phi_188_: f32;
    var phi_200_: bool;
    var phi_207_: f32;
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_224_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_166_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_165_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_164_ = 1f;
            } else {
                phi_164_ = param_6;
            }
            let _e43 = phi_164_;
            phi_165_ = _e43;
        }
        let _e45 = phi_165_;
        phi_166_ = _e45;
    }
    let _e47 = phi_166_;
    let _e50 = (*param_4);
    let _e54 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e50) & 2147483647u) > 2139095040u) {
        phi_184_ = true;
    } else {
        let _e58 = (_e50 > _e54);
        if _e58 {
        }
        phi_184_ = _e58;
    }
    let _e60 = phi_184_;
    if _e60 {
        phi_188_ = _e50;
    } else {
        phi_188_ = _e54;
    }
    let _e62 = phi_188_;
    let _e63 = (_e47 - param_5.x);
    if (_e63 <= 0f) {
        let _e67 = ((bitcast<u32>(_e62) & 2147483647u) > 2139095040u);
        if _e67 {
        }
        phi_200_ = _e67;
    } else {
        phi_200_ = true;
    }
    let _e69 = phi_200_;
    if _e69 {
        phi_207_ = (_e62 / (_e62 + (_e63 * _e63)));
    } else {
        phi_207_ = 1f;
    }
    let _e74 = phi_207_;
    if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
        phi_224_ = _e74;
    } else {
        if (_e74 < 0f) {
            phi_223_ = 0f;
        } else {
            if (_e74 > 1f) {
                phi_222_ = 1f;
            } else {
                phi_222_ = _e74;
            }
            let _e81 = phi_222_;
            phi_223_ = _e81;
        }
        let _e83 = phi_223_;
        phi_224_ = _e83;
    }
    let _e85 = phi_224_;
    return _e85;
}

fn function_() {
    var local: f32;
    var phi_281_: bool;
    var phi_282_: bool;
    var phi_283_: bool;
    var phi_284_: bool;
    var phi_288_: bool;
    var phi_332_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_336_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_410_: bool;
    var phi_419_: bool;
    var phi_428_: bool;
    var phi_429_: bool;
    var phi_430_: bool;
    var phi_431_: bool;
    var phi_432_: bool;
    var phi_433_: bool;
    var phi_434_: bool;
    var phi_438_: bool;
    var phi_528_: f32;
    var phi_531_: f32;
    var phi_560_: f32;
    var phi_565_: f32;
    var phi_566_: bool;
    var phi_567_: f32;
    var phi_568_: bool;
    var phi_572_: f32;
    var phi_592_: f32;
    var phi_597_: f32;
    var phi_598_: bool;
    var phi_599_: f32;
    var phi_600_: bool;
    var phi_604_: f32;
    var phi_652_: i32;
    var phi_657_: i32;
    var phi_662_: i32;
    var phi_667_: i32;
    var phi_676_: i32;
    var phi_681_: i32;
    var phi_686_: i32;
    var phi_691_: i32;
    var phi_786_: bool;
    var phi_794_: bool;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_811_: f32;
    var phi_817_: f32;
    var phi_819_: evaluate_Verdict;
    var phi_824_: evaluate_Verdict;
    var phi_825_: evaluate_Verdict;

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
                phi_281_ = (_e76 == _e78);
                phi_282_ = false;
            } else {
                phi_281_ = bool();
                phi_282_ = true;
            }
            let _e81 = phi_281_;
            let _e83 = phi_282_;
            phi_283_ = _e81;
            phi_284_ = _e83;
        } else {
            phi_283_ = bool();
            phi_284_ = true;
        }
        let _e85 = phi_283_;
        let _e87 = phi_284_;
        if _e87 {
            phi_288_ = false;
        } else {
            phi_288_ = _e85;
        }
        let _e89 = phi_288_;
        if !(_e89) {
            let _e92 = samples.member[(0u + _e51.first_primitive)].normal;
            let _e94 = samples.member[(0u + _e51.first_primitive)].position;
            if ((((_e92.x * (_e63.x - (_e94.x * _e63.w))) + (_e92.y * (_e63.y - (_e94.y * _e63.w)))) + (_e92.z * (_e63.z - (_e94.z * _e63.w)))) > 0f) {
                let _e118 = samples.member[(0u + _e51.first_primitive)].flags;
                let _e126 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e132 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e126.unnamed.visibility, false), _e126.unnamed_1);
                phi_332_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e132.unnamed, ((_e118 & 1u) == 0u));
            } else {
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e147 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e141.unnamed.visibility, false), _e141.unnamed_1);
                phi_332_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e147.unnamed, true);
            }
            let _e152 = phi_332_;
            phi_336_ = _e152;
        } else {
            let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e164 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e158.unnamed.visibility, false), _e158.unnamed_1);
            phi_336_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e164.unnamed, true);
        }
        let _e169 = phi_336_;
        if _e169.unnamed_1 {
            phi_825_ = evaluate_Verdict(_e169.unnamed.visibility, _e169.unnamed.is_doubted);
        } else {
            let _e177 = samples.member[(0u + _e51.first_primitive)].position;
            let _e195 = ((((_e61.projection.row_w.x * _e177.x) + (_e61.projection.row_w.y * _e177.y)) + (_e61.projection.row_w.z * _e177.z)) + (_e61.projection.row_w.w * 1f));
            let _e209 = (((((_e61.projection.row_x.x * _e177.x) + (_e61.projection.row_x.y * _e177.y)) + (_e61.projection.row_x.z * _e177.z)) + (_e61.projection.row_x.w * 1f)) / _e195);
            let _e223 = (((((_e61.projection.row_y.x * _e177.x) + (_e61.projection.row_y.y * _e177.y)) + (_e61.projection.row_y.z * _e177.z)) + (_e61.projection.row_y.w * 1f)) / _e195);
            let _e236 = ((((_e61.projection.row_z.x * _e177.x) + (_e61.projection.row_z.y * _e177.y)) + (_e61.projection.row_z.z * _e177.z)) + (_e61.projection.row_z.w * 1f));
            if (_e195 > 0f) {
                if (_e209 >= 0f) {
                    phi_410_ = (_e209 <= 1f);
                } else {
                    phi_410_ = false;
                }
                let _e241 = phi_410_;
                if _e241 {
                    if (_e223 >= 0f) {
                        phi_419_ = (_e223 <= 1f);
                    } else {
                        phi_419_ = false;
                    }
                    let _e245 = phi_419_;
                    if _e245 {
                        if (_e236 >= 0f) {
                            phi_428_ = (_e236 <= 1f);
                        } else {
                            phi_428_ = false;
                        }
                        let _e249 = phi_428_;
                        phi_429_ = _e249;
                        phi_430_ = false;
                    } else {
                        phi_429_ = bool();
                        phi_430_ = true;
                    }
                    let _e251 = phi_429_;
                    let _e253 = phi_430_;
                    phi_431_ = _e251;
                    phi_432_ = _e253;
                } else {
                    phi_431_ = bool();
                    phi_432_ = true;
                }
                let _e255 = phi_431_;
                let _e257 = phi_432_;
                phi_433_ = _e255;
                phi_434_ = _e257;
            } else {
                phi_433_ = bool();
                phi_434_ = true;
            }
            let _e259 = phi_433_;
            let _e261 = phi_434_;
            if _e261 {
                phi_438_ = false;
            } else {
                phi_438_ = _e259;
            }
            let _e263 = phi_438_;
            if _e263 {
                if (0f > 0f) {
                    let _e266 = samples.member[(0u + _e51.first_primitive)].normal;
                    let _e268 = p.member.map_size;
                    let _e338 = ((abs(((((_e57.row_x.x * _e266.x) + (_e57.row_x.y * _e266.y)) + (_e57.row_x.z * _e266.z)) / (((_e57.row_x.x * _e57.row_x.x) + (_e57.row_x.y * _e57.row_x.y)) + (_e57.row_x.z * _e57.row_x.z)))) + abs(((((_e57.row_y.x * _e266.x) + (_e57.row_y.y * _e266.y)) + (_e57.row_y.z * _e266.z)) / (((_e57.row_y.x * _e57.row_y.x) + (_e57.row_y.y * _e57.row_y.y)) + (_e57.row_y.z * _e57.row_y.z))))) / (abs(((((_e57.row_z.x * _e266.x) + (_e57.row_z.y * _e266.y)) + (_e57.row_z.z * _e266.z)) / (((_e57.row_z.x * _e57.row_z.x) + (_e57.row_z.y * _e57.row_z.y)) + (_e57.row_z.z * _e57.row_z.z)))) * f32(_e268)));
                    if (_e338 < 0.002f) {
                        phi_528_ = _e338;
                    } else {
                        phi_528_ = 0.002f;
                    }
                    let _e341 = phi_528_;
                    phi_531_ = (_e236 - (0f * _e341));
                } else {
                    phi_531_ = _e236;
                }
                let _e345 = phi_531_;
                let _e347 = p.member.map_size;
                let _e348 = f32(_e347);
                let _e351 = ((_e209 * _e348) - 0.5f);
                let _e352 = ((_e223 * _e348) - 0.5f);
                if (_e351 > -8388608f) {
                    let _e364 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e364 > _e351) {
                        phi_560_ = 1f;
                    } else {
                        phi_560_ = 0f;
                    }
                    let _e367 = phi_560_;
                    if (_e351 < 8388608f) {
                        phi_565_ = (_e364 - _e367);
                        phi_566_ = false;
                    } else {
                        phi_565_ = f32();
                        phi_566_ = true;
                    }
                    let _e370 = phi_565_;
                    let _e372 = phi_566_;
                    phi_567_ = _e370;
                    phi_568_ = _e372;
                } else {
                    phi_567_ = f32();
                    phi_568_ = true;
                }
                let _e374 = phi_567_;
                let _e376 = phi_568_;
                if _e376 {
                    phi_572_ = _e351;
                } else {
                    phi_572_ = _e374;
                }
                let _e378 = phi_572_;
                if (_e352 > -8388608f) {
                    let _e390 = f32(select(0i, select(select(i32(_e352), i32(-2147483648), (_e352 < bitcast<f32>(3472883712u))), 2147483647i, (_e352 > bitcast<f32>(1325400063u))), (_e352 == _e352)));
                    if (_e390 > _e352) {
                        phi_592_ = 1f;
                    } else {
                        phi_592_ = 0f;
                    }
                    let _e393 = phi_592_;
                    if (_e352 < 8388608f) {
                        phi_597_ = (_e390 - _e393);
                        phi_598_ = false;
                    } else {
                        phi_597_ = f32();
                        phi_598_ = true;
                    }
                    let _e396 = phi_597_;
                    let _e398 = phi_598_;
                    phi_599_ = _e396;
                    phi_600_ = _e398;
                } else {
                    phi_599_ = f32();
                    phi_600_ = true;
                }
                let _e400 = phi_599_;
                let _e402 = phi_600_;
                if _e402 {
                    phi_604_ = _e352;
                } else {
                    phi_604_ = _e400;
                }
                let _e404 = phi_604_;
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
                let _e439 = ((0u * _e437) * _e437);
                let _e441 = (bitcast<i32>(_e437) - 1i);
                if (_e415 > 0i) {
                    phi_652_ = _e415;
                } else {
                    phi_652_ = 0i;
                }
                let _e444 = phi_652_;
                if (_e424 > 0i) {
                    phi_657_ = _e424;
                } else {
                    phi_657_ = 0i;
                }
                let _e447 = phi_657_;
                if (_e444 < _e441) {
                    phi_662_ = _e444;
                } else {
                    phi_662_ = _e441;
                }
                let _e450 = phi_662_;
                if (_e447 < _e441) {
                    phi_667_ = _e447;
                } else {
                    phi_667_ = _e441;
                }
                let _e453 = phi_667_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e415 + 1i);
                let _e457 = (_e424 + 1i);
                if (_e456 > 0i) {
                    phi_676_ = _e456;
                } else {
                    phi_676_ = 0i;
                }
                let _e460 = phi_676_;
                if (_e457 > 0i) {
                    phi_681_ = _e457;
                } else {
                    phi_681_ = 0i;
                }
                let _e463 = phi_681_;
                if (_e460 < _e441) {
                    phi_686_ = _e460;
                } else {
                    phi_686_ = _e441;
                }
                let _e466 = phi_686_;
                if (_e463 < _e441) {
                    phi_691_ = _e463;
                } else {
                    phi_691_ = _e441;
                }
                let _e469 = phi_691_;
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
                let _e543 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e485.x * _e427) + (_e497.x * _e429)) + (_e513.x * _e431)) + (_e529.x * _e432)), ((((_e485.y * _e427) + (_e497.y * _e429)) + (_e513.y * _e431)) + (_e529.y * _e432)), ((((_e485.z * _e427) + (_e497.z * _e429)) + (_e513.z * _e431)) + (_e529.z * _e432)), ((((_e485.w * _e427) + (_e497.w * _e429)) + (_e513.w * _e431)) + (_e529.w * _e432))), _e345);
                let _e545 = p.member.epsilon;
                if (_e543 <= _e545) {
                    phi_786_ = true;
                } else {
                    phi_786_ = (_e543 >= (1f - _e545));
                }
                let _e550 = phi_786_;
                if ((bitcast<u32>(_e543) & 2147483647u) > 2139095040u) {
                    phi_794_ = true;
                } else {
                    phi_794_ = !(_e550);
                }
                let _e556 = phi_794_;
                if _e556 {
                    if (_e543 > 0f) {
                        if (_e543 < 1f) {
                            phi_806_ = false;
                        } else {
                            phi_806_ = true;
                        }
                        let _e560 = phi_806_;
                        phi_807_ = _e560;
                    } else {
                        phi_807_ = true;
                    }
                    let _e562 = phi_807_;
                    if _e562 {
                        phi_811_ = 0.5f;
                    } else {
                        phi_811_ = _e543;
                    }
                    let _e564 = phi_811_;
                    phi_819_ = evaluate_Verdict(_e564, true);
                } else {
                    if (_e543 > 0.5f) {
                        phi_817_ = 1f;
                    } else {
                        phi_817_ = 0f;
                    }
                    let _e568 = phi_817_;
                    phi_819_ = evaluate_Verdict(_e568, false);
                }
                let _e571 = phi_819_;
                phi_824_ = evaluate_Verdict(_e571.visibility, _e571.is_doubted);
            } else {
                phi_824_ = evaluate_Verdict(0.5f, true);
            }
            let _e577 = phi_824_;
            phi_825_ = _e577;
        }
        let _e579 = phi_825_;
        if (_e51.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e51.first_primitive)] = _e579.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_vsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
