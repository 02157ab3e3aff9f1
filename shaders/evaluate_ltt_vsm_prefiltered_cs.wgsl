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
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_41 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
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
    var phi_147_: lt_bvh_traverse_Tree;
    var phi_148_: bool;
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_155_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_147_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_148_ = false;
        } else {
            phi_147_ = lt_bvh_traverse_Tree();
            phi_148_ = true;
        }
        let _e51 = phi_147_;
        let _e53 = phi_148_;
        phi_149_ = _e51;
        phi_150_ = _e53;
    } else {
        phi_149_ = lt_bvh_traverse_Tree();
        phi_150_ = true;
    }
    let _e55 = phi_149_;
    let _e57 = phi_150_;
    if _e57 {
        phi_155_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_155_ = _e55;
    }
    let _e62 = phi_155_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_180_: f32;
    var phi_181_: f32;
    var phi_182_: f32;
    var phi_200_: bool;
    var phi_204_: f32;
    var phi_216_: bool;
    var phi_223_: f32;
    var phi_238_: f32;
    var phi_239_: f32;
    var phi_240_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_182_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_181_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_180_ = 1f;
            } else {
                phi_180_ = param_6;
            }
            let _e47 = phi_180_;
            phi_181_ = _e47;
        }
        let _e49 = phi_181_;
        phi_182_ = _e49;
    }
    let _e51 = phi_182_;
    let _e54 = (*param_4);
    let _e58 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e54) & 2147483647u) > 2139095040u) {
        phi_200_ = true;
    } else {
        let _e62 = (_e54 > _e58);
        if _e62 {
        }
        phi_200_ = _e62;
    }
    let _e64 = phi_200_;
    if _e64 {
        phi_204_ = _e54;
    } else {
        phi_204_ = _e58;
    }
    let _e66 = phi_204_;
    let _e67 = (_e51 - param_5.x);
    if (_e67 <= 0f) {
        let _e71 = ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u);
        if _e71 {
        }
        phi_216_ = _e71;
    } else {
        phi_216_ = true;
    }
    let _e73 = phi_216_;
    if _e73 {
        phi_223_ = (_e66 / (_e66 + (_e67 * _e67)));
    } else {
        phi_223_ = 1f;
    }
    let _e78 = phi_223_;
    if ((bitcast<u32>(_e78) & 2147483647u) > 2139095040u) {
        phi_240_ = _e78;
    } else {
        if (_e78 < 0f) {
            phi_239_ = 0f;
        } else {
            if (_e78 > 1f) {
                phi_238_ = 1f;
            } else {
                phi_238_ = _e78;
            }
            let _e85 = phi_238_;
            phi_239_ = _e85;
        }
        let _e87 = phi_239_;
        phi_240_ = _e87;
    }
    let _e89 = phi_240_;
    return _e89;
}

fn function_() {
    var local_1: f32;
    var phi_292_: bool;
    var phi_293_: bool;
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_299_: bool;
    var phi_343_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_347_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_421_: bool;
    var phi_430_: bool;
    var phi_439_: bool;
    var phi_440_: bool;
    var phi_441_: bool;
    var phi_442_: bool;
    var phi_443_: bool;
    var phi_444_: bool;
    var phi_445_: bool;
    var phi_449_: bool;
    var phi_539_: f32;
    var phi_542_: f32;
    var phi_571_: f32;
    var phi_576_: f32;
    var phi_577_: bool;
    var phi_578_: f32;
    var phi_579_: bool;
    var phi_583_: f32;
    var phi_603_: f32;
    var phi_608_: f32;
    var phi_609_: bool;
    var phi_610_: f32;
    var phi_611_: bool;
    var phi_615_: f32;
    var phi_663_: i32;
    var phi_668_: i32;
    var phi_673_: i32;
    var phi_678_: i32;
    var phi_687_: i32;
    var phi_692_: i32;
    var phi_697_: i32;
    var phi_702_: i32;
    var phi_797_: bool;
    var phi_805_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_822_: f32;
    var phi_828_: f32;
    var phi_830_: evaluate_Verdict;
    var phi_835_: evaluate_Verdict;
    var phi_836_: evaluate_Verdict;
    var phi_840_: bool;
    var phi_841_: u32;
    var phi_852_: u32;

    let _e39 = id_1;
    let _e40 = local_2;
    let _e45 = arrayLength((&map.member));
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e39, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        let _e60 = p.member.projection;
        let _e61 = lt_math_OneLevel(_e60);
        let _e63 = p.member.light;
        let _e66 = samples.member[_e53.first_primitive].normal[0u];
        let _e68 = global[0u];
        if (_e66 == _e68) {
            let _e71 = samples.member[_e53.first_primitive].normal[1u];
            let _e73 = global[1u];
            if (_e71 == _e73) {
                let _e76 = samples.member[_e53.first_primitive].normal[2u];
                let _e78 = global[2u];
                phi_292_ = (_e76 == _e78);
                phi_293_ = false;
            } else {
                phi_292_ = bool();
                phi_293_ = true;
            }
            let _e81 = phi_292_;
            let _e83 = phi_293_;
            phi_294_ = _e81;
            phi_295_ = _e83;
        } else {
            phi_294_ = bool();
            phi_295_ = true;
        }
        let _e85 = phi_294_;
        let _e87 = phi_295_;
        if _e87 {
            phi_299_ = false;
        } else {
            phi_299_ = _e85;
        }
        let _e89 = phi_299_;
        if !(_e89) {
            let _e92 = samples.member[_e53.first_primitive].normal;
            let _e94 = samples.member[_e53.first_primitive].position;
            if ((((_e92.x * (_e63.x - (_e94.x * _e63.w))) + (_e92.y * (_e63.y - (_e94.y * _e63.w)))) + (_e92.z * (_e63.z - (_e94.z * _e63.w)))) > 0f) {
                let _e118 = samples.member[_e53.first_primitive].flags;
                let _e126 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e132 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e126.unnamed.visibility, false), _e126.unnamed_1);
                phi_343_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e132.unnamed, ((_e118 & 1u) == 0u));
            } else {
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e147 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e141.unnamed.visibility, false), _e141.unnamed_1);
                phi_343_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e147.unnamed, true);
            }
            let _e152 = phi_343_;
            phi_347_ = _e152;
        } else {
            let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e164 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e158.unnamed.visibility, false), _e158.unnamed_1);
            phi_347_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e164.unnamed, true);
        }
        let _e169 = phi_347_;
        if _e169.unnamed_1 {
            phi_836_ = evaluate_Verdict(_e169.unnamed.visibility, _e169.unnamed.is_doubted);
        } else {
            let _e177 = samples.member[_e53.first_primitive].position;
            let _e195 = ((((_e61.projection.row_w.x * _e177.x) + (_e61.projection.row_w.y * _e177.y)) + (_e61.projection.row_w.z * _e177.z)) + (_e61.projection.row_w.w * 1f));
            let _e209 = (((((_e61.projection.row_x.x * _e177.x) + (_e61.projection.row_x.y * _e177.y)) + (_e61.projection.row_x.z * _e177.z)) + (_e61.projection.row_x.w * 1f)) / _e195);
            let _e223 = (((((_e61.projection.row_y.x * _e177.x) + (_e61.projection.row_y.y * _e177.y)) + (_e61.projection.row_y.z * _e177.z)) + (_e61.projection.row_y.w * 1f)) / _e195);
            let _e236 = ((((_e61.projection.row_z.x * _e177.x) + (_e61.projection.row_z.y * _e177.y)) + (_e61.projection.row_z.z * _e177.z)) + (_e61.projection.row_z.w * 1f));
            if (_e195 > 0f) {
                if (_e209 >= 0f) {
                    phi_421_ = (_e209 <= 1f);
                } else {
                    phi_421_ = false;
                }
                let _e241 = phi_421_;
                if _e241 {
                    if (_e223 >= 0f) {
                        phi_430_ = (_e223 <= 1f);
                    } else {
                        phi_430_ = false;
                    }
                    let _e245 = phi_430_;
                    if _e245 {
                        if (_e236 >= 0f) {
                            phi_439_ = (_e236 <= 1f);
                        } else {
                            phi_439_ = false;
                        }
                        let _e249 = phi_439_;
                        phi_440_ = _e249;
                        phi_441_ = false;
                    } else {
                        phi_440_ = bool();
                        phi_441_ = true;
                    }
                    let _e251 = phi_440_;
                    let _e253 = phi_441_;
                    phi_442_ = _e251;
                    phi_443_ = _e253;
                } else {
                    phi_442_ = bool();
                    phi_443_ = true;
                }
                let _e255 = phi_442_;
                let _e257 = phi_443_;
                phi_444_ = _e255;
                phi_445_ = _e257;
            } else {
                phi_444_ = bool();
                phi_445_ = true;
            }
            let _e259 = phi_444_;
            let _e261 = phi_445_;
            if _e261 {
                phi_449_ = false;
            } else {
                phi_449_ = _e259;
            }
            let _e263 = phi_449_;
            if _e263 {
                if (0f > 0f) {
                    let _e266 = samples.member[_e53.first_primitive].normal;
                    let _e268 = p.member.map_size;
                    let _e338 = ((abs(((((_e60.row_x.x * _e266.x) + (_e60.row_x.y * _e266.y)) + (_e60.row_x.z * _e266.z)) / (((_e60.row_x.x * _e60.row_x.x) + (_e60.row_x.y * _e60.row_x.y)) + (_e60.row_x.z * _e60.row_x.z)))) + abs(((((_e60.row_y.x * _e266.x) + (_e60.row_y.y * _e266.y)) + (_e60.row_y.z * _e266.z)) / (((_e60.row_y.x * _e60.row_y.x) + (_e60.row_y.y * _e60.row_y.y)) + (_e60.row_y.z * _e60.row_y.z))))) / (abs(((((_e60.row_z.x * _e266.x) + (_e60.row_z.y * _e266.y)) + (_e60.row_z.z * _e266.z)) / (((_e60.row_z.x * _e60.row_z.x) + (_e60.row_z.y * _e60.row_z.y)) + (_e60.row_z.z * _e60.row_z.z)))) * f32(_e268)));
                    if (_e338 < 0.002f) {
                        phi_539_ = _e338;
                    } else {
                        phi_539_ = 0.002f;
                    }
                    let _e341 = phi_539_;
                    phi_542_ = (_e236 - (0f * _e341));
                } else {
                    phi_542_ = _e236;
                }
                let _e345 = phi_542_;
                let _e347 = p.member.map_size;
                let _e348 = f32(_e347);
                let _e351 = ((_e209 * _e348) - 0.5f);
                let _e352 = ((_e223 * _e348) - 0.5f);
                if (_e351 > -8388608f) {
                    let _e364 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e364 > _e351) {
                        phi_571_ = 1f;
                    } else {
                        phi_571_ = 0f;
                    }
                    let _e367 = phi_571_;
                    if (_e351 < 8388608f) {
                        phi_576_ = (_e364 - _e367);
                        phi_577_ = false;
                    } else {
                        phi_576_ = f32();
                        phi_577_ = true;
                    }
                    let _e370 = phi_576_;
                    let _e372 = phi_577_;
                    phi_578_ = _e370;
                    phi_579_ = _e372;
                } else {
                    phi_578_ = f32();
                    phi_579_ = true;
                }
                let _e374 = phi_578_;
                let _e376 = phi_579_;
                if _e376 {
                    phi_583_ = _e351;
                } else {
                    phi_583_ = _e374;
                }
                let _e378 = phi_583_;
                if (_e352 > -8388608f) {
                    let _e390 = f32(select(0i, select(select(i32(_e352), i32(-2147483648), (_e352 < bitcast<f32>(3472883712u))), 2147483647i, (_e352 > bitcast<f32>(1325400063u))), (_e352 == _e352)));
                    if (_e390 > _e352) {
                        phi_603_ = 1f;
                    } else {
                        phi_603_ = 0f;
                    }
                    let _e393 = phi_603_;
                    if (_e352 < 8388608f) {
                        phi_608_ = (_e390 - _e393);
                        phi_609_ = false;
                    } else {
                        phi_608_ = f32();
                        phi_609_ = true;
                    }
                    let _e396 = phi_608_;
                    let _e398 = phi_609_;
                    phi_610_ = _e396;
                    phi_611_ = _e398;
                } else {
                    phi_610_ = f32();
                    phi_611_ = true;
                }
                let _e400 = phi_610_;
                let _e402 = phi_611_;
                if _e402 {
                    phi_615_ = _e352;
                } else {
                    phi_615_ = _e400;
                }
                let _e404 = phi_615_;
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
                let _e439 = ((0u * _e437) * _e437);
                let _e441 = (bitcast<i32>(_e437) - 1i);
                if (_e415 > 0i) {
                    phi_663_ = _e415;
                } else {
                    phi_663_ = 0i;
                }
                let _e444 = phi_663_;
                if (_e424 > 0i) {
                    phi_668_ = _e424;
                } else {
                    phi_668_ = 0i;
                }
                let _e447 = phi_668_;
                if (_e444 < _e441) {
                    phi_673_ = _e444;
                } else {
                    phi_673_ = _e441;
                }
                let _e450 = phi_673_;
                if (_e447 < _e441) {
                    phi_678_ = _e447;
                } else {
                    phi_678_ = _e441;
                }
                let _e453 = phi_678_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e415 + 1i);
                let _e457 = (_e424 + 1i);
                if (_e456 > 0i) {
                    phi_687_ = _e456;
                } else {
                    phi_687_ = 0i;
                }
                let _e460 = phi_687_;
                if (_e457 > 0i) {
                    phi_692_ = _e457;
                } else {
                    phi_692_ = 0i;
                }
                let _e463 = phi_692_;
                if (_e460 < _e441) {
                    phi_697_ = _e460;
                } else {
                    phi_697_ = _e441;
                }
                let _e466 = phi_697_;
                if (_e463 < _e441) {
                    phi_702_ = _e463;
                } else {
                    phi_702_ = _e441;
                }
                let _e469 = phi_702_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (bitcast<u32>(_e453) * _e437);
                let _e473 = (bitcast<u32>(_e469) * _e437);
                let _e478 = ((_e472 + _e454) + _e439);
                let _e479 = ((_e472 + _e470) + _e439);
                let _e480 = ((_e473 + _e454) + _e439);
                let _e481 = ((_e473 + _e470) + _e439);
                if (_e478 < _e45) {
                } else {
                    return;
                }
                let _e485 = map.member[(0u + _e478)];
                if (_e479 < _e45) {
                } else {
                    return;
                }
                let _e497 = map.member[(0u + _e479)];
                if (_e480 < _e45) {
                } else {
                    return;
                }
                let _e513 = map.member[(0u + _e480)];
                if (_e481 < _e45) {
                } else {
                    return;
                }
                let _e529 = map.member[(0u + _e481)];
                let _e543 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e485.x * _e427) + (_e497.x * _e429)) + (_e513.x * _e431)) + (_e529.x * _e432)), ((((_e485.y * _e427) + (_e497.y * _e429)) + (_e513.y * _e431)) + (_e529.y * _e432)), ((((_e485.z * _e427) + (_e497.z * _e429)) + (_e513.z * _e431)) + (_e529.z * _e432)), ((((_e485.w * _e427) + (_e497.w * _e429)) + (_e513.w * _e431)) + (_e529.w * _e432))), _e345);
                let _e545 = p.member.epsilon;
                if (_e543 <= _e545) {
                    phi_797_ = true;
                } else {
                    phi_797_ = (_e543 >= (1f - _e545));
                }
                let _e550 = phi_797_;
                if ((bitcast<u32>(_e543) & 2147483647u) > 2139095040u) {
                    phi_805_ = true;
                } else {
                    phi_805_ = !(_e550);
                }
                let _e556 = phi_805_;
                if _e556 {
                    if (_e543 > 0f) {
                        if (_e543 < 1f) {
                            phi_817_ = false;
                        } else {
                            phi_817_ = true;
                        }
                        let _e560 = phi_817_;
                        phi_818_ = _e560;
                    } else {
                        phi_818_ = true;
                    }
                    let _e562 = phi_818_;
                    if _e562 {
                        phi_822_ = 0.5f;
                    } else {
                        phi_822_ = _e543;
                    }
                    let _e564 = phi_822_;
                    phi_830_ = evaluate_Verdict(_e564, true);
                } else {
                    if (_e543 > 0.5f) {
                        phi_828_ = 1f;
                    } else {
                        phi_828_ = 0f;
                    }
                    let _e568 = phi_828_;
                    phi_830_ = evaluate_Verdict(_e568, false);
                }
                let _e571 = phi_830_;
                phi_835_ = evaluate_Verdict(_e571.visibility, _e571.is_doubted);
            } else {
                phi_835_ = evaluate_Verdict(0.5f, true);
            }
            let _e577 = phi_835_;
            phi_836_ = _e577;
        }
        let _e579 = phi_836_;
        visibility.member[_e53.first_primitive] = _e579.visibility;
        phi_840_ = _e579.is_doubted;
        phi_841_ = _e53.first_primitive;
    } else {
        phi_840_ = false;
        phi_841_ = 0u;
    }
    let _e584 = phi_840_;
    let _e586 = phi_841_;
    if (_e40 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e584 {
        let _e590 = atomicAdd((&shared_[0u]), 1u);
        phi_852_ = _e590;
    } else {
        phi_852_ = 0u;
    }
    let _e592 = phi_852_;
    workgroupBarrier();
    if (_e40 == 0u) {
        let _e596 = atomicLoad((&shared_[0u]));
        let _e597 = atomicAdd((&list.member[3u]), _e596);
        atomicStore((&shared_[1u]), _e597);
    }
    workgroupBarrier();
    if _e584 {
        let _e600 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e600) + _e592)]), _e586);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
