struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_10 {
    member: array<abi_Sample>,
}

struct type_14 {
    member: array<u32>,
}

struct type_18 {
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

struct type_37 {
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

struct type_41 {
    member: abi_ShadowParams,
}

struct type_48 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_41;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_48;
@group(0) @binding(2) 
var<storage> map: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_146_: lt_bvh_traverse_Tree;
    var phi_147_: bool;
    var phi_148_: lt_bvh_traverse_Tree;
    var phi_149_: bool;
    var phi_154_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_146_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_147_ = false;
        } else {
            phi_146_ = lt_bvh_traverse_Tree();
            phi_147_ = true;
        }
        let _e51 = phi_146_;
        let _e53 = phi_147_;
        phi_148_ = _e51;
        phi_149_ = _e53;
    } else {
        phi_148_ = lt_bvh_traverse_Tree();
        phi_149_ = true;
    }
    let _e55 = phi_148_;
    let _e57 = phi_149_;
    if _e57 {
        phi_154_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_154_ = _e55;
    }
    let _e62 = phi_154_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_179_: f32;
    var phi_180_: f32;
    var phi_181_: f32;
    var phi_199_: bool;
    var phi_203_: f32;
    var phi_215_: bool;
    var phi_222_: f32;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_239_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_181_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_180_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_179_ = 1f;
            } else {
                phi_179_ = param_6;
            }
            let _e47 = phi_179_;
            phi_180_ = _e47;
        }
        let _e49 = phi_180_;
        phi_181_ = _e49;
    }
    let _e51 = phi_181_;
    let _e54 = (*param_4);
    let _e58 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e54) & 2147483647u) > 2139095040u) {
        phi_199_ = true;
    } else {
        let _e62 = (_e54 > _e58);
        if _e62 {
        }
        phi_199_ = _e62;
    }
    let _e64 = phi_199_;
    if _e64 {
        phi_203_ = _e54;
    } else {
        phi_203_ = _e58;
    }
    let _e66 = phi_203_;
    let _e67 = (_e51 - param_5.x);
    if (_e67 <= 0f) {
        let _e71 = ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u);
        if _e71 {
        }
        phi_215_ = _e71;
    } else {
        phi_215_ = true;
    }
    let _e73 = phi_215_;
    if _e73 {
        phi_222_ = (_e66 / (_e66 + (_e67 * _e67)));
    } else {
        phi_222_ = 1f;
    }
    let _e78 = phi_222_;
    if ((bitcast<u32>(_e78) & 2147483647u) > 2139095040u) {
        phi_239_ = _e78;
    } else {
        if (_e78 < 0f) {
            phi_238_ = 0f;
        } else {
            if (_e78 > 1f) {
                phi_237_ = 1f;
            } else {
                phi_237_ = _e78;
            }
            let _e85 = phi_237_;
            phi_238_ = _e85;
        }
        let _e87 = phi_238_;
        phi_239_ = _e87;
    }
    let _e89 = phi_239_;
    return _e89;
}

fn function_() {
    var local_1: f32;
    var phi_288_: bool;
    var phi_289_: bool;
    var phi_290_: bool;
    var phi_291_: bool;
    var phi_295_: bool;
    var phi_339_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_343_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_420_: bool;
    var phi_429_: bool;
    var phi_438_: bool;
    var phi_439_: bool;
    var phi_440_: bool;
    var phi_441_: bool;
    var phi_442_: bool;
    var phi_443_: bool;
    var phi_444_: bool;
    var phi_448_: bool;
    var phi_542_: f32;
    var phi_545_: f32;
    var phi_574_: f32;
    var phi_579_: f32;
    var phi_580_: bool;
    var phi_581_: f32;
    var phi_582_: bool;
    var phi_586_: f32;
    var phi_606_: f32;
    var phi_611_: f32;
    var phi_612_: bool;
    var phi_613_: f32;
    var phi_614_: bool;
    var phi_618_: f32;
    var phi_664_: i32;
    var phi_669_: i32;
    var phi_674_: i32;
    var phi_679_: i32;
    var phi_688_: i32;
    var phi_693_: i32;
    var phi_698_: i32;
    var phi_703_: i32;
    var phi_794_: bool;
    var phi_802_: bool;
    var phi_814_: bool;
    var phi_815_: bool;
    var phi_819_: f32;
    var phi_825_: f32;
    var phi_827_: evaluate_Verdict;
    var phi_832_: evaluate_Verdict;
    var phi_833_: evaluate_Verdict;
    var phi_837_: bool;
    var phi_838_: u32;
    var phi_849_: u32;

    let _e39 = id_1;
    let _e40 = local_2;
    let _e45 = arrayLength((&map.member));
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e39, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        let _e60 = p.member.light;
        let _e63 = samples.member[_e53.first_primitive].normal[0u];
        let _e65 = global[0u];
        if (_e63 == _e65) {
            let _e68 = samples.member[_e53.first_primitive].normal[1u];
            let _e70 = global[1u];
            if (_e68 == _e70) {
                let _e73 = samples.member[_e53.first_primitive].normal[2u];
                let _e75 = global[2u];
                phi_288_ = (_e73 == _e75);
                phi_289_ = false;
            } else {
                phi_288_ = bool();
                phi_289_ = true;
            }
            let _e78 = phi_288_;
            let _e80 = phi_289_;
            phi_290_ = _e78;
            phi_291_ = _e80;
        } else {
            phi_290_ = bool();
            phi_291_ = true;
        }
        let _e82 = phi_290_;
        let _e84 = phi_291_;
        if _e84 {
            phi_295_ = false;
        } else {
            phi_295_ = _e82;
        }
        let _e86 = phi_295_;
        if !(_e86) {
            let _e89 = samples.member[_e53.first_primitive].normal;
            let _e91 = samples.member[_e53.first_primitive].position;
            if ((((_e89.x * (_e60.x - (_e91.x * _e60.w))) + (_e89.y * (_e60.y - (_e91.y * _e60.w)))) + (_e89.z * (_e60.z - (_e91.z * _e60.w)))) > 0f) {
                let _e115 = samples.member[_e53.first_primitive].flags;
                let _e123 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e123.unnamed.visibility, false), _e123.unnamed_1);
                phi_339_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e129.unnamed, ((_e115 & 1u) == 0u));
            } else {
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_339_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, true);
            }
            let _e149 = phi_339_;
            phi_343_ = _e149;
        } else {
            let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e155.unnamed.visibility, false), _e155.unnamed_1);
            phi_343_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e161.unnamed, true);
        }
        let _e166 = phi_343_;
        if _e166.unnamed_1 {
            phi_833_ = evaluate_Verdict(_e166.unnamed.visibility, _e166.unnamed.is_doubted);
        } else {
            let _e174 = samples.member[_e53.first_primitive].position;
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
                    phi_420_ = (_e205 <= 1f);
                } else {
                    phi_420_ = false;
                }
                let _e237 = phi_420_;
                if _e237 {
                    if (_e219 >= 0f) {
                        phi_429_ = (_e219 <= 1f);
                    } else {
                        phi_429_ = false;
                    }
                    let _e241 = phi_429_;
                    if _e241 {
                        if (_e232 >= 0f) {
                            phi_438_ = (_e232 <= 1f);
                        } else {
                            phi_438_ = false;
                        }
                        let _e245 = phi_438_;
                        phi_439_ = _e245;
                        phi_440_ = false;
                    } else {
                        phi_439_ = bool();
                        phi_440_ = true;
                    }
                    let _e247 = phi_439_;
                    let _e249 = phi_440_;
                    phi_441_ = _e247;
                    phi_442_ = _e249;
                } else {
                    phi_441_ = bool();
                    phi_442_ = true;
                }
                let _e251 = phi_441_;
                let _e253 = phi_442_;
                phi_443_ = _e251;
                phi_444_ = _e253;
            } else {
                phi_443_ = bool();
                phi_444_ = true;
            }
            let _e255 = phi_443_;
            let _e257 = phi_444_;
            if _e257 {
                phi_448_ = false;
            } else {
                phi_448_ = _e255;
            }
            let _e259 = phi_448_;
            if _e259 {
                if (0f > 0f) {
                    let _e262 = samples.member[_e53.first_primitive].normal;
                    let _e264 = p.member.map_size;
                    let _e267 = p.member.projection.row_x;
                    let _e289 = p.member.projection.row_y;
                    let _e311 = p.member.projection.row_z;
                    let _e338 = ((abs(((((_e267.x * _e262.x) + (_e267.y * _e262.y)) + (_e267.z * _e262.z)) / (((_e267.x * _e267.x) + (_e267.y * _e267.y)) + (_e267.z * _e267.z)))) + abs(((((_e289.x * _e262.x) + (_e289.y * _e262.y)) + (_e289.z * _e262.z)) / (((_e289.x * _e289.x) + (_e289.y * _e289.y)) + (_e289.z * _e289.z))))) / (abs(((((_e311.x * _e262.x) + (_e311.y * _e262.y)) + (_e311.z * _e262.z)) / (((_e311.x * _e311.x) + (_e311.y * _e311.y)) + (_e311.z * _e311.z)))) * f32(_e264)));
                    if (_e338 < 0.002f) {
                        phi_542_ = _e338;
                    } else {
                        phi_542_ = 0.002f;
                    }
                    let _e341 = phi_542_;
                    phi_545_ = (_e232 - (0f * _e341));
                } else {
                    phi_545_ = _e232;
                }
                let _e345 = phi_545_;
                let _e347 = p.member.map_size;
                let _e348 = f32(_e347);
                let _e351 = ((_e205 * _e348) - 0.5f);
                let _e352 = ((_e219 * _e348) - 0.5f);
                if (_e351 > -8388608f) {
                    let _e364 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e364 > _e351) {
                        phi_574_ = 1f;
                    } else {
                        phi_574_ = 0f;
                    }
                    let _e367 = phi_574_;
                    if (_e351 < 8388608f) {
                        phi_579_ = (_e364 - _e367);
                        phi_580_ = false;
                    } else {
                        phi_579_ = f32();
                        phi_580_ = true;
                    }
                    let _e370 = phi_579_;
                    let _e372 = phi_580_;
                    phi_581_ = _e370;
                    phi_582_ = _e372;
                } else {
                    phi_581_ = f32();
                    phi_582_ = true;
                }
                let _e374 = phi_581_;
                let _e376 = phi_582_;
                if _e376 {
                    phi_586_ = _e351;
                } else {
                    phi_586_ = _e374;
                }
                let _e378 = phi_586_;
                if (_e352 > -8388608f) {
                    let _e390 = f32(select(0i, select(select(i32(_e352), i32(-2147483648), (_e352 < bitcast<f32>(3472883712u))), 2147483647i, (_e352 > bitcast<f32>(1325400063u))), (_e352 == _e352)));
                    if (_e390 > _e352) {
                        phi_606_ = 1f;
                    } else {
                        phi_606_ = 0f;
                    }
                    let _e393 = phi_606_;
                    if (_e352 < 8388608f) {
                        phi_611_ = (_e390 - _e393);
                        phi_612_ = false;
                    } else {
                        phi_611_ = f32();
                        phi_612_ = true;
                    }
                    let _e396 = phi_611_;
                    let _e398 = phi_612_;
                    phi_613_ = _e396;
                    phi_614_ = _e398;
                } else {
                    phi_613_ = f32();
                    phi_614_ = true;
                }
                let _e400 = phi_613_;
                let _e402 = phi_614_;
                if _e402 {
                    phi_618_ = _e352;
                } else {
                    phi_618_ = _e400;
                }
                let _e404 = phi_618_;
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
                local_1 = _e435;
                let _e439 = (bitcast<i32>(_e437) - 1i);
                if (_e415 > 0i) {
                    phi_664_ = _e415;
                } else {
                    phi_664_ = 0i;
                }
                let _e442 = phi_664_;
                if (_e424 > 0i) {
                    phi_669_ = _e424;
                } else {
                    phi_669_ = 0i;
                }
                let _e445 = phi_669_;
                if (_e442 < _e439) {
                    phi_674_ = _e442;
                } else {
                    phi_674_ = _e439;
                }
                let _e448 = phi_674_;
                if (_e445 < _e439) {
                    phi_679_ = _e445;
                } else {
                    phi_679_ = _e439;
                }
                let _e451 = phi_679_;
                let _e452 = bitcast<u32>(_e448);
                let _e454 = (_e415 + 1i);
                let _e455 = (_e424 + 1i);
                if (_e454 > 0i) {
                    phi_688_ = _e454;
                } else {
                    phi_688_ = 0i;
                }
                let _e458 = phi_688_;
                if (_e455 > 0i) {
                    phi_693_ = _e455;
                } else {
                    phi_693_ = 0i;
                }
                let _e461 = phi_693_;
                if (_e458 < _e439) {
                    phi_698_ = _e458;
                } else {
                    phi_698_ = _e439;
                }
                let _e464 = phi_698_;
                if (_e461 < _e439) {
                    phi_703_ = _e461;
                } else {
                    phi_703_ = _e439;
                }
                let _e467 = phi_703_;
                let _e468 = bitcast<u32>(_e464);
                let _e470 = (bitcast<u32>(_e451) * _e437);
                let _e471 = (bitcast<u32>(_e467) * _e437);
                let _e472 = (_e470 + _e452);
                let _e473 = (_e470 + _e468);
                let _e474 = (_e471 + _e452);
                let _e475 = (_e471 + _e468);
                if (_e472 < _e45) {
                } else {
                    return;
                }
                let _e479 = map.member[(0u + _e472)];
                if (_e473 < _e45) {
                } else {
                    return;
                }
                let _e491 = map.member[(0u + _e473)];
                if (_e474 < _e45) {
                } else {
                    return;
                }
                let _e507 = map.member[(0u + _e474)];
                if (_e475 < _e45) {
                } else {
                    return;
                }
                let _e523 = map.member[(0u + _e475)];
                let _e537 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e479.x * _e427) + (_e491.x * _e429)) + (_e507.x * _e431)) + (_e523.x * _e432)), ((((_e479.y * _e427) + (_e491.y * _e429)) + (_e507.y * _e431)) + (_e523.y * _e432)), ((((_e479.z * _e427) + (_e491.z * _e429)) + (_e507.z * _e431)) + (_e523.z * _e432)), ((((_e479.w * _e427) + (_e491.w * _e429)) + (_e507.w * _e431)) + (_e523.w * _e432))), _e345);
                let _e539 = p.member.epsilon;
                if (_e537 <= _e539) {
                    phi_794_ = true;
                } else {
                    phi_794_ = (_e537 >= (1f - _e539));
                }
                let _e544 = phi_794_;
                if ((bitcast<u32>(_e537) & 2147483647u) > 2139095040u) {
                    phi_802_ = true;
                } else {
                    phi_802_ = !(_e544);
                }
                let _e550 = phi_802_;
                if _e550 {
                    if (_e537 > 0f) {
                        if (_e537 < 1f) {
                            phi_814_ = false;
                        } else {
                            phi_814_ = true;
                        }
                        let _e554 = phi_814_;
                        phi_815_ = _e554;
                    } else {
                        phi_815_ = true;
                    }
                    let _e556 = phi_815_;
                    if _e556 {
                        phi_819_ = 0.5f;
                    } else {
                        phi_819_ = _e537;
                    }
                    let _e558 = phi_819_;
                    phi_827_ = evaluate_Verdict(_e558, true);
                } else {
                    if (_e537 > 0.5f) {
                        phi_825_ = 1f;
                    } else {
                        phi_825_ = 0f;
                    }
                    let _e562 = phi_825_;
                    phi_827_ = evaluate_Verdict(_e562, false);
                }
                let _e565 = phi_827_;
                phi_832_ = evaluate_Verdict(_e565.visibility, _e565.is_doubted);
            } else {
                phi_832_ = evaluate_Verdict(0.5f, true);
            }
            let _e571 = phi_832_;
            phi_833_ = _e571;
        }
        let _e573 = phi_833_;
        visibility.member[_e53.first_primitive] = _e573.visibility;
        phi_837_ = _e573.is_doubted;
        phi_838_ = _e53.first_primitive;
    } else {
        phi_837_ = false;
        phi_838_ = 0u;
    }
    let _e578 = phi_837_;
    let _e580 = phi_838_;
    if (_e40 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e578 {
        let _e584 = atomicAdd((&shared_[0u]), 1u);
        phi_849_ = _e584;
    } else {
        phi_849_ = 0u;
    }
    let _e586 = phi_849_;
    workgroupBarrier();
    if (_e40 == 0u) {
        let _e590 = atomicLoad((&shared_[0u]));
        let _e591 = atomicAdd((&list.member[3u]), _e590);
        atomicStore((&shared_[1u]), _e591);
    }
    workgroupBarrier();
    if _e578 {
        let _e594 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e594) + _e586)]), _e580);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
