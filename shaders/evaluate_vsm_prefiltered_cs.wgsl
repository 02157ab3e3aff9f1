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
    var phi_129_: lt_bvh_traverse_Tree;
    var phi_130_: bool;
    var phi_131_: lt_bvh_traverse_Tree;
    var phi_132_: bool;
    var phi_137_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_129_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_130_ = false;
        } else {
            phi_129_ = lt_bvh_traverse_Tree();
            phi_130_ = true;
        }
        let _e47 = phi_129_;
        let _e49 = phi_130_;
        phi_131_ = _e47;
        phi_132_ = _e49;
    } else {
        phi_131_ = lt_bvh_traverse_Tree();
        phi_132_ = true;
    }
    let _e51 = phi_131_;
    let _e53 = phi_132_;
    if _e53 {
        phi_137_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_137_ = _e51;
    }
    let _e58 = phi_137_;
    return lt_bvh_traverse_Tree(_e58.root, _e58.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_734_: f32;
    var phi_735_: f32;
    var phi_736_: f32;
    var phi_754_: bool;
    var phi_758_: f32;
    var phi_770_: bool;
    var phi_777_: f32;
    var phi_792_: f32;
    var phi_793_: f32;
    var phi_794_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_736_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_735_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_734_ = 1f;
            } else {
                phi_734_ = param_6;
            }
            let _e43 = phi_734_;
            phi_735_ = _e43;
        }
        let _e45 = phi_735_;
        phi_736_ = _e45;
    }
    let _e47 = phi_736_;
    let _e50 = (*param_4);
    let _e54 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e50) & 2147483647u) > 2139095040u) {
        phi_754_ = true;
    } else {
        let _e58 = (_e50 > _e54);
        if _e58 {
        }
        phi_754_ = _e58;
    }
    let _e60 = phi_754_;
    if _e60 {
        phi_758_ = _e50;
    } else {
        phi_758_ = _e54;
    }
    let _e62 = phi_758_;
    let _e63 = (_e47 - param_5.x);
    if (_e63 <= 0f) {
        let _e67 = ((bitcast<u32>(_e62) & 2147483647u) > 2139095040u);
        if _e67 {
        }
        phi_770_ = _e67;
    } else {
        phi_770_ = true;
    }
    let _e69 = phi_770_;
    if _e69 {
        phi_777_ = (_e62 / (_e62 + (_e63 * _e63)));
    } else {
        phi_777_ = 1f;
    }
    let _e74 = phi_777_;
    if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
        phi_794_ = _e74;
    } else {
        if (_e74 < 0f) {
            phi_793_ = 0f;
        } else {
            if (_e74 > 1f) {
                phi_792_ = 1f;
            } else {
                phi_792_ = _e74;
            }
            let _e81 = phi_792_;
            phi_793_ = _e81;
        }
        let _e83 = phi_793_;
        phi_794_ = _e83;
    }
    let _e85 = phi_794_;
    return _e85;
}

fn function_() {
    var local: f32;
    var phi_200_: bool;
    var phi_201_: bool;
    var phi_202_: bool;
    var phi_203_: bool;
    var phi_207_: bool;
    var phi_251_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_255_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_329_: bool;
    var phi_338_: bool;
    var phi_347_: bool;
    var phi_348_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_352_: bool;
    var phi_353_: bool;
    var phi_357_: bool;
    var phi_447_: f32;
    var phi_450_: f32;
    var phi_479_: f32;
    var phi_484_: f32;
    var phi_485_: bool;
    var phi_486_: f32;
    var phi_487_: bool;
    var phi_491_: f32;
    var phi_511_: f32;
    var phi_516_: f32;
    var phi_517_: bool;
    var phi_518_: f32;
    var phi_519_: bool;
    var phi_523_: f32;
    var phi_571_: i32;
    var phi_576_: i32;
    var phi_581_: i32;
    var phi_586_: i32;
    var phi_595_: i32;
    var phi_600_: i32;
    var phi_605_: i32;
    var phi_610_: i32;
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
                phi_200_ = (_e76 == _e78);
                phi_201_ = false;
            } else {
                phi_200_ = bool();
                phi_201_ = true;
            }
            let _e81 = phi_200_;
            let _e83 = phi_201_;
            phi_202_ = _e81;
            phi_203_ = _e83;
        } else {
            phi_202_ = bool();
            phi_203_ = true;
        }
        let _e85 = phi_202_;
        let _e87 = phi_203_;
        if _e87 {
            phi_207_ = false;
        } else {
            phi_207_ = _e85;
        }
        let _e89 = phi_207_;
        if !(_e89) {
            let _e92 = samples.member[(0u + _e51.first_primitive)].normal;
            let _e94 = samples.member[(0u + _e51.first_primitive)].position;
            if ((((_e92.x * (_e63.x - (_e94.x * _e63.w))) + (_e92.y * (_e63.y - (_e94.y * _e63.w)))) + (_e92.z * (_e63.z - (_e94.z * _e63.w)))) > 0f) {
                let _e118 = samples.member[(0u + _e51.first_primitive)].flags;
                let _e126 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e132 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e126.unnamed.visibility, false), _e126.unnamed_1);
                phi_251_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e132.unnamed, ((_e118 & 1u) == 0u));
            } else {
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e147 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e141.unnamed.visibility, false), _e141.unnamed_1);
                phi_251_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e147.unnamed, true);
            }
            let _e152 = phi_251_;
            phi_255_ = _e152;
        } else {
            let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e164 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e158.unnamed.visibility, false), _e158.unnamed_1);
            phi_255_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e164.unnamed, true);
        }
        let _e169 = phi_255_;
        if _e169.unnamed_1 {
            phi_702_ = evaluate_Verdict(_e169.unnamed.visibility, _e169.unnamed.is_doubted);
            phi_703_ = evaluate_Verdict();
            phi_704_ = true;
        } else {
            let _e177 = samples.member[(0u + _e51.first_primitive)].position;
            let _e195 = ((((_e61.projection.row_w.x * _e177.x) + (_e61.projection.row_w.y * _e177.y)) + (_e61.projection.row_w.z * _e177.z)) + (_e61.projection.row_w.w * 1f));
            let _e209 = (((((_e61.projection.row_x.x * _e177.x) + (_e61.projection.row_x.y * _e177.y)) + (_e61.projection.row_x.z * _e177.z)) + (_e61.projection.row_x.w * 1f)) / _e195);
            let _e223 = (((((_e61.projection.row_y.x * _e177.x) + (_e61.projection.row_y.y * _e177.y)) + (_e61.projection.row_y.z * _e177.z)) + (_e61.projection.row_y.w * 1f)) / _e195);
            let _e236 = ((((_e61.projection.row_z.x * _e177.x) + (_e61.projection.row_z.y * _e177.y)) + (_e61.projection.row_z.z * _e177.z)) + (_e61.projection.row_z.w * 1f));
            if (_e195 > 0f) {
                if (_e209 >= 0f) {
                    phi_329_ = (_e209 <= 1f);
                } else {
                    phi_329_ = false;
                }
                let _e241 = phi_329_;
                if _e241 {
                    if (_e223 >= 0f) {
                        phi_338_ = (_e223 <= 1f);
                    } else {
                        phi_338_ = false;
                    }
                    let _e245 = phi_338_;
                    if _e245 {
                        if (_e236 >= 0f) {
                            phi_347_ = (_e236 <= 1f);
                        } else {
                            phi_347_ = false;
                        }
                        let _e249 = phi_347_;
                        phi_348_ = _e249;
                        phi_349_ = false;
                    } else {
                        phi_348_ = bool();
                        phi_349_ = true;
                    }
                    let _e251 = phi_348_;
                    let _e253 = phi_349_;
                    phi_350_ = _e251;
                    phi_351_ = _e253;
                } else {
                    phi_350_ = bool();
                    phi_351_ = true;
                }
                let _e255 = phi_350_;
                let _e257 = phi_351_;
                phi_352_ = _e255;
                phi_353_ = _e257;
            } else {
                phi_352_ = bool();
                phi_353_ = true;
            }
            let _e259 = phi_352_;
            let _e261 = phi_353_;
            if _e261 {
                phi_357_ = false;
            } else {
                phi_357_ = _e259;
            }
            let _e263 = phi_357_;
            if _e263 {
                if (0f > 0f) {
                    let _e266 = samples.member[(0u + _e51.first_primitive)].normal;
                    let _e268 = p.member.map_size;
                    let _e338 = ((abs(((((_e57.row_x.x * _e266.x) + (_e57.row_x.y * _e266.y)) + (_e57.row_x.z * _e266.z)) / (((_e57.row_x.x * _e57.row_x.x) + (_e57.row_x.y * _e57.row_x.y)) + (_e57.row_x.z * _e57.row_x.z)))) + abs(((((_e57.row_y.x * _e266.x) + (_e57.row_y.y * _e266.y)) + (_e57.row_y.z * _e266.z)) / (((_e57.row_y.x * _e57.row_y.x) + (_e57.row_y.y * _e57.row_y.y)) + (_e57.row_y.z * _e57.row_y.z))))) / (abs(((((_e57.row_z.x * _e266.x) + (_e57.row_z.y * _e266.y)) + (_e57.row_z.z * _e266.z)) / (((_e57.row_z.x * _e57.row_z.x) + (_e57.row_z.y * _e57.row_z.y)) + (_e57.row_z.z * _e57.row_z.z)))) * f32(_e268)));
                    if (_e338 < 0.002f) {
                        phi_447_ = _e338;
                    } else {
                        phi_447_ = 0.002f;
                    }
                    let _e341 = phi_447_;
                    phi_450_ = (_e236 - (0f * _e341));
                } else {
                    phi_450_ = _e236;
                }
                let _e345 = phi_450_;
                let _e347 = p.member.map_size;
                let _e348 = f32(_e347);
                let _e351 = ((_e209 * _e348) - 0.5f);
                let _e352 = ((_e223 * _e348) - 0.5f);
                if (_e351 > -8388608f) {
                    let _e364 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e364 > _e351) {
                        phi_479_ = 1f;
                    } else {
                        phi_479_ = 0f;
                    }
                    let _e367 = phi_479_;
                    if (_e351 < 8388608f) {
                        phi_484_ = (_e364 - _e367);
                        phi_485_ = false;
                    } else {
                        phi_484_ = f32();
                        phi_485_ = true;
                    }
                    let _e370 = phi_484_;
                    let _e372 = phi_485_;
                    phi_486_ = _e370;
                    phi_487_ = _e372;
                } else {
                    phi_486_ = f32();
                    phi_487_ = true;
                }
                let _e374 = phi_486_;
                let _e376 = phi_487_;
                if _e376 {
                    phi_491_ = _e351;
                } else {
                    phi_491_ = _e374;
                }
                let _e378 = phi_491_;
                if (_e352 > -8388608f) {
                    let _e390 = f32(select(0i, select(select(i32(_e352), i32(-2147483648), (_e352 < bitcast<f32>(3472883712u))), 2147483647i, (_e352 > bitcast<f32>(1325400063u))), (_e352 == _e352)));
                    if (_e390 > _e352) {
                        phi_511_ = 1f;
                    } else {
                        phi_511_ = 0f;
                    }
                    let _e393 = phi_511_;
                    if (_e352 < 8388608f) {
                        phi_516_ = (_e390 - _e393);
                        phi_517_ = false;
                    } else {
                        phi_516_ = f32();
                        phi_517_ = true;
                    }
                    let _e396 = phi_516_;
                    let _e398 = phi_517_;
                    phi_518_ = _e396;
                    phi_519_ = _e398;
                } else {
                    phi_518_ = f32();
                    phi_519_ = true;
                }
                let _e400 = phi_518_;
                let _e402 = phi_519_;
                if _e402 {
                    phi_523_ = _e352;
                } else {
                    phi_523_ = _e400;
                }
                let _e404 = phi_523_;
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
                    phi_571_ = _e415;
                } else {
                    phi_571_ = 0i;
                }
                let _e444 = phi_571_;
                if (_e424 > 0i) {
                    phi_576_ = _e424;
                } else {
                    phi_576_ = 0i;
                }
                let _e447 = phi_576_;
                if (_e444 < _e441) {
                    phi_581_ = _e444;
                } else {
                    phi_581_ = _e441;
                }
                let _e450 = phi_581_;
                if (_e447 < _e441) {
                    phi_586_ = _e447;
                } else {
                    phi_586_ = _e441;
                }
                let _e453 = phi_586_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e415 + 1i);
                let _e457 = (_e424 + 1i);
                if (_e456 > 0i) {
                    phi_595_ = _e456;
                } else {
                    phi_595_ = 0i;
                }
                let _e460 = phi_595_;
                if (_e457 > 0i) {
                    phi_600_ = _e457;
                } else {
                    phi_600_ = 0i;
                }
                let _e463 = phi_600_;
                if (_e460 < _e441) {
                    phi_605_ = _e460;
                } else {
                    phi_605_ = _e441;
                }
                let _e466 = phi_605_;
                if (_e463 < _e441) {
                    phi_610_ = _e463;
                } else {
                    phi_610_ = _e441;
                }
                let _e469 = phi_610_;
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
                phi_699_ = evaluate_Verdict(_e543, false);
                phi_700_ = evaluate_Verdict();
                phi_701_ = false;
            } else {
                phi_699_ = evaluate_Verdict();
                phi_700_ = evaluate_Verdict(1f, false);
                phi_701_ = true;
            }
            let _e547 = phi_699_;
            let _e549 = phi_700_;
            let _e551 = phi_701_;
            phi_702_ = _e549;
            phi_703_ = _e547;
            phi_704_ = _e551;
        }
        let _e553 = phi_702_;
        let _e555 = phi_703_;
        let _e557 = phi_704_;
        if _e557 {
            phi_708_ = _e553;
        } else {
            phi_708_ = _e555;
        }
        let _e559 = phi_708_;
        if (_e51.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e51.first_primitive)] = _e559.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_vsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
