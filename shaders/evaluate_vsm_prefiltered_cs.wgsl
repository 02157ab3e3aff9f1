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

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_731_: f32;
    var phi_732_: f32;
    var phi_733_: f32;
    var phi_751_: bool;
    var phi_755_: f32;
    var phi_767_: bool;
    var phi_774_: f32;
    var phi_789_: f32;
    var phi_790_: f32;
    var phi_791_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_733_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_732_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_731_ = 1f;
            } else {
                phi_731_ = param_6;
            }
            let _e43 = phi_731_;
            phi_732_ = _e43;
        }
        let _e45 = phi_732_;
        phi_733_ = _e45;
    }
    let _e47 = phi_733_;
    let _e50 = (*param_4);
    let _e54 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e50) & 2147483647u) > 2139095040u) {
        phi_751_ = true;
    } else {
        let _e58 = (_e50 > _e54);
        if _e58 {
        }
        phi_751_ = _e58;
    }
    let _e60 = phi_751_;
    if _e60 {
        phi_755_ = _e50;
    } else {
        phi_755_ = _e54;
    }
    let _e62 = phi_755_;
    let _e63 = (_e47 - param_5.x);
    if (_e63 <= 0f) {
        let _e67 = ((bitcast<u32>(_e62) & 2147483647u) > 2139095040u);
        if _e67 {
        }
        phi_767_ = _e67;
    } else {
        phi_767_ = true;
    }
    let _e69 = phi_767_;
    if _e69 {
        phi_774_ = (_e62 / (_e62 + (_e63 * _e63)));
    } else {
        phi_774_ = 1f;
    }
    let _e74 = phi_774_;
    if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
        phi_791_ = _e74;
    } else {
        if (_e74 < 0f) {
            phi_790_ = 0f;
        } else {
            if (_e74 > 1f) {
                phi_789_ = 1f;
            } else {
                phi_789_ = _e74;
            }
            let _e81 = phi_789_;
            phi_790_ = _e81;
        }
        let _e83 = phi_790_;
        phi_791_ = _e83;
    }
    let _e85 = phi_791_;
    return _e85;
}

fn function_() {
    var local: f32;
    var phi_196_: bool;
    var phi_197_: bool;
    var phi_198_: bool;
    var phi_199_: bool;
    var phi_203_: bool;
    var phi_247_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_251_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_328_: bool;
    var phi_337_: bool;
    var phi_346_: bool;
    var phi_347_: bool;
    var phi_348_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_352_: bool;
    var phi_356_: bool;
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
    var phi_572_: i32;
    var phi_577_: i32;
    var phi_582_: i32;
    var phi_587_: i32;
    var phi_596_: i32;
    var phi_601_: i32;
    var phi_606_: i32;
    var phi_611_: i32;
    var phi_696_: evaluate_Verdict;
    var phi_697_: evaluate_Verdict;
    var phi_698_: bool;
    var phi_699_: evaluate_Verdict;
    var phi_700_: evaluate_Verdict;
    var phi_701_: bool;
    var phi_705_: evaluate_Verdict;

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
                phi_196_ = (_e73 == _e75);
                phi_197_ = false;
            } else {
                phi_196_ = bool();
                phi_197_ = true;
            }
            let _e78 = phi_196_;
            let _e80 = phi_197_;
            phi_198_ = _e78;
            phi_199_ = _e80;
        } else {
            phi_198_ = bool();
            phi_199_ = true;
        }
        let _e82 = phi_198_;
        let _e84 = phi_199_;
        if _e84 {
            phi_203_ = false;
        } else {
            phi_203_ = _e82;
        }
        let _e86 = phi_203_;
        if !(_e86) {
            let _e89 = samples.member[(0u + _e51.first_primitive)].normal;
            let _e91 = samples.member[(0u + _e51.first_primitive)].position;
            if ((((_e89.x * (_e60.x - (_e91.x * _e60.w))) + (_e89.y * (_e60.y - (_e91.y * _e60.w)))) + (_e89.z * (_e60.z - (_e91.z * _e60.w)))) > 0f) {
                let _e115 = samples.member[(0u + _e51.first_primitive)].flags;
                let _e123 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e123.unnamed.visibility, false), _e123.unnamed_1);
                phi_247_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e129.unnamed, ((_e115 & 1u) == 0u));
            } else {
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_247_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, true);
            }
            let _e149 = phi_247_;
            phi_251_ = _e149;
        } else {
            let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e155.unnamed.visibility, false), _e155.unnamed_1);
            phi_251_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e161.unnamed, true);
        }
        let _e166 = phi_251_;
        if _e166.unnamed_1 {
            phi_699_ = evaluate_Verdict(_e166.unnamed.visibility, _e166.unnamed.is_doubted);
            phi_700_ = evaluate_Verdict();
            phi_701_ = true;
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
                    phi_328_ = (_e205 <= 1f);
                } else {
                    phi_328_ = false;
                }
                let _e237 = phi_328_;
                if _e237 {
                    if (_e219 >= 0f) {
                        phi_337_ = (_e219 <= 1f);
                    } else {
                        phi_337_ = false;
                    }
                    let _e241 = phi_337_;
                    if _e241 {
                        if (_e232 >= 0f) {
                            phi_346_ = (_e232 <= 1f);
                        } else {
                            phi_346_ = false;
                        }
                        let _e245 = phi_346_;
                        phi_347_ = _e245;
                        phi_348_ = false;
                    } else {
                        phi_347_ = bool();
                        phi_348_ = true;
                    }
                    let _e247 = phi_347_;
                    let _e249 = phi_348_;
                    phi_349_ = _e247;
                    phi_350_ = _e249;
                } else {
                    phi_349_ = bool();
                    phi_350_ = true;
                }
                let _e251 = phi_349_;
                let _e253 = phi_350_;
                phi_351_ = _e251;
                phi_352_ = _e253;
            } else {
                phi_351_ = bool();
                phi_352_ = true;
            }
            let _e255 = phi_351_;
            let _e257 = phi_352_;
            if _e257 {
                phi_356_ = false;
            } else {
                phi_356_ = _e255;
            }
            let _e259 = phi_356_;
            if _e259 {
                if (0f > 0f) {
                    let _e262 = samples.member[(0u + _e51.first_primitive)].normal;
                    let _e264 = p.member.map_size;
                    let _e267 = p.member.projection.row_x;
                    let _e289 = p.member.projection.row_y;
                    let _e311 = p.member.projection.row_z;
                    let _e338 = ((abs(((((_e267.x * _e262.x) + (_e267.y * _e262.y)) + (_e267.z * _e262.z)) / (((_e267.x * _e267.x) + (_e267.y * _e267.y)) + (_e267.z * _e267.z)))) + abs(((((_e289.x * _e262.x) + (_e289.y * _e262.y)) + (_e289.z * _e262.z)) / (((_e289.x * _e289.x) + (_e289.y * _e289.y)) + (_e289.z * _e289.z))))) / (abs(((((_e311.x * _e262.x) + (_e311.y * _e262.y)) + (_e311.z * _e262.z)) / (((_e311.x * _e311.x) + (_e311.y * _e311.y)) + (_e311.z * _e311.z)))) * f32(_e264)));
                    if (_e338 < 0.002f) {
                        phi_450_ = _e338;
                    } else {
                        phi_450_ = 0.002f;
                    }
                    let _e341 = phi_450_;
                    phi_453_ = (_e232 - (0f * _e341));
                } else {
                    phi_453_ = _e232;
                }
                let _e345 = phi_453_;
                let _e347 = p.member.map_size;
                let _e348 = f32(_e347);
                let _e351 = ((_e205 * _e348) - 0.5f);
                let _e352 = ((_e219 * _e348) - 0.5f);
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
                let _e435 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e434);
                let _e437 = p.member.map_size;
                local = _e435;
                let _e439 = (bitcast<i32>(_e437) - 1i);
                if (_e415 > 0i) {
                    phi_572_ = _e415;
                } else {
                    phi_572_ = 0i;
                }
                let _e442 = phi_572_;
                if (_e424 > 0i) {
                    phi_577_ = _e424;
                } else {
                    phi_577_ = 0i;
                }
                let _e445 = phi_577_;
                if (_e442 < _e439) {
                    phi_582_ = _e442;
                } else {
                    phi_582_ = _e439;
                }
                let _e448 = phi_582_;
                if (_e445 < _e439) {
                    phi_587_ = _e445;
                } else {
                    phi_587_ = _e439;
                }
                let _e451 = phi_587_;
                let _e452 = bitcast<u32>(_e448);
                let _e454 = (_e415 + 1i);
                let _e455 = (_e424 + 1i);
                if (_e454 > 0i) {
                    phi_596_ = _e454;
                } else {
                    phi_596_ = 0i;
                }
                let _e458 = phi_596_;
                if (_e455 > 0i) {
                    phi_601_ = _e455;
                } else {
                    phi_601_ = 0i;
                }
                let _e461 = phi_601_;
                if (_e458 < _e439) {
                    phi_606_ = _e458;
                } else {
                    phi_606_ = _e439;
                }
                let _e464 = phi_606_;
                if (_e461 < _e439) {
                    phi_611_ = _e461;
                } else {
                    phi_611_ = _e439;
                }
                let _e467 = phi_611_;
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
                phi_696_ = evaluate_Verdict(_e537, false);
                phi_697_ = evaluate_Verdict();
                phi_698_ = false;
            } else {
                phi_696_ = evaluate_Verdict();
                phi_697_ = evaluate_Verdict(1f, false);
                phi_698_ = true;
            }
            let _e541 = phi_696_;
            let _e543 = phi_697_;
            let _e545 = phi_698_;
            phi_699_ = _e543;
            phi_700_ = _e541;
            phi_701_ = _e545;
        }
        let _e547 = phi_699_;
        let _e549 = phi_700_;
        let _e551 = phi_701_;
        if _e551 {
            phi_705_ = _e547;
        } else {
            phi_705_ = _e549;
        }
        let _e553 = phi_705_;
        if (_e51.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e51.first_primitive)] = _e553.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_vsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
