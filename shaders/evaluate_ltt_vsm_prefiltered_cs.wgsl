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

struct type_23 {
    member: array<abi_Sample>,
}

struct type_27 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_36 {
    member: array<vec4<f32>>,
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

struct type_40 {
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

struct type_47 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_23;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_40;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_27;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_47;
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(2) 
var<storage> map: type_36;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_145_: lt_bvh_traverse_Tree;
    var phi_146_: bool;
    var phi_147_: lt_bvh_traverse_Tree;
    var phi_148_: bool;
    var phi_153_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_145_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_146_ = false;
        } else {
            phi_145_ = lt_bvh_traverse_Tree();
            phi_146_ = true;
        }
        let _e51 = phi_145_;
        let _e53 = phi_146_;
        phi_147_ = _e51;
        phi_148_ = _e53;
    } else {
        phi_147_ = lt_bvh_traverse_Tree();
        phi_148_ = true;
    }
    let _e55 = phi_147_;
    let _e57 = phi_148_;
    if _e57 {
        phi_153_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_153_ = _e55;
    }
    let _e62 = phi_153_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_178_: f32;
    var phi_179_: f32;
    var phi_180_: f32;
    var phi_198_: bool;
    var phi_202_: f32;
    var phi_214_: bool;
    var phi_221_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_238_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_180_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_179_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_178_ = 1f;
            } else {
                phi_178_ = param_6;
            }
            let _e47 = phi_178_;
            phi_179_ = _e47;
        }
        let _e49 = phi_179_;
        phi_180_ = _e49;
    }
    let _e51 = phi_180_;
    let _e54 = (*param_4);
    let _e58 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e54) & 2147483647u) > 2139095040u) {
        phi_198_ = true;
    } else {
        let _e62 = (_e54 > _e58);
        if _e62 {
        }
        phi_198_ = _e62;
    }
    let _e64 = phi_198_;
    if _e64 {
        phi_202_ = _e54;
    } else {
        phi_202_ = _e58;
    }
    let _e66 = phi_202_;
    let _e67 = (_e51 - param_5.x);
    if (_e67 <= 0f) {
        let _e71 = ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u);
        if _e71 {
        }
        phi_214_ = _e71;
    } else {
        phi_214_ = true;
    }
    let _e73 = phi_214_;
    if _e73 {
        phi_221_ = (_e66 / (_e66 + (_e67 * _e67)));
    } else {
        phi_221_ = 1f;
    }
    let _e78 = phi_221_;
    if ((bitcast<u32>(_e78) & 2147483647u) > 2139095040u) {
        phi_238_ = _e78;
    } else {
        if (_e78 < 0f) {
            phi_237_ = 0f;
        } else {
            if (_e78 > 1f) {
                phi_236_ = 1f;
            } else {
                phi_236_ = _e78;
            }
            let _e85 = phi_236_;
            phi_237_ = _e85;
        }
        let _e87 = phi_237_;
        phi_238_ = _e87;
    }
    let _e89 = phi_238_;
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
    var phi_424_: bool;
    var phi_433_: bool;
    var phi_442_: bool;
    var phi_443_: bool;
    var phi_444_: bool;
    var phi_445_: bool;
    var phi_446_: bool;
    var phi_447_: bool;
    var phi_448_: bool;
    var phi_452_: bool;
    var phi_546_: f32;
    var phi_549_: f32;
    var phi_578_: f32;
    var phi_583_: f32;
    var phi_584_: bool;
    var phi_585_: f32;
    var phi_586_: bool;
    var phi_590_: f32;
    var phi_610_: f32;
    var phi_615_: f32;
    var phi_616_: bool;
    var phi_617_: f32;
    var phi_618_: bool;
    var phi_622_: f32;
    var phi_668_: i32;
    var phi_673_: i32;
    var phi_678_: i32;
    var phi_683_: i32;
    var phi_692_: i32;
    var phi_697_: i32;
    var phi_702_: i32;
    var phi_707_: i32;
    var phi_798_: bool;
    var phi_806_: bool;
    var phi_811_: f32;
    var phi_814_: evaluate_Verdict;
    var phi_815_: evaluate_Verdict;
    var phi_819_: bool;
    var phi_820_: u32;
    var phi_826_: u32;

    let _e39 = id_1;
    let _e40 = local_2;
    let _e45 = arrayLength((&map.member));
    if (_e40 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e52 = p.member.size[0u];
    let _e54 = p.member.size[1u];
    let _e55 = lt_shaders_entry_pixel_index(_e39, _e52, _e54);
    if (bitcast<i32>(_e55.root) != 0i) {
        let _e62 = p.member.light;
        let _e65 = samples.member[_e55.first_primitive].normal[0u];
        let _e67 = global[0u];
        if (_e65 == _e67) {
            let _e70 = samples.member[_e55.first_primitive].normal[1u];
            let _e72 = global[1u];
            if (_e70 == _e72) {
                let _e75 = samples.member[_e55.first_primitive].normal[2u];
                let _e77 = global[2u];
                phi_292_ = (_e75 == _e77);
                phi_293_ = false;
            } else {
                phi_292_ = bool();
                phi_293_ = true;
            }
            let _e80 = phi_292_;
            let _e82 = phi_293_;
            phi_294_ = _e80;
            phi_295_ = _e82;
        } else {
            phi_294_ = bool();
            phi_295_ = true;
        }
        let _e84 = phi_294_;
        let _e86 = phi_295_;
        if _e86 {
            phi_299_ = false;
        } else {
            phi_299_ = _e84;
        }
        let _e88 = phi_299_;
        if !(_e88) {
            let _e91 = samples.member[_e55.first_primitive].normal;
            let _e93 = samples.member[_e55.first_primitive].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[_e55.first_primitive].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_343_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_343_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_343_;
            phi_347_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_347_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_347_;
        if _e168.unnamed_1 {
            phi_815_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
        } else {
            let _e176 = samples.member[_e55.first_primitive].position;
            let _e182 = p.member.projection.row_w;
            let _e193 = ((((_e182.x * _e176.x) + (_e182.y * _e176.y)) + (_e182.z * _e176.z)) + (_e182.w * 1f));
            let _e195 = p.member.projection.row_x;
            let _e207 = (((((_e195.x * _e176.x) + (_e195.y * _e176.y)) + (_e195.z * _e176.z)) + (_e195.w * 1f)) / _e193);
            let _e209 = p.member.projection.row_y;
            let _e221 = (((((_e209.x * _e176.x) + (_e209.y * _e176.y)) + (_e209.z * _e176.z)) + (_e209.w * 1f)) / _e193);
            let _e223 = p.member.projection.row_z;
            let _e234 = ((((_e223.x * _e176.x) + (_e223.y * _e176.y)) + (_e223.z * _e176.z)) + (_e223.w * 1f));
            if (_e193 > 0f) {
                if (_e207 >= 0f) {
                    phi_424_ = (_e207 <= 1f);
                } else {
                    phi_424_ = false;
                }
                let _e239 = phi_424_;
                if _e239 {
                    if (_e221 >= 0f) {
                        phi_433_ = (_e221 <= 1f);
                    } else {
                        phi_433_ = false;
                    }
                    let _e243 = phi_433_;
                    if _e243 {
                        if (_e234 >= 0f) {
                            phi_442_ = (_e234 <= 1f);
                        } else {
                            phi_442_ = false;
                        }
                        let _e247 = phi_442_;
                        phi_443_ = _e247;
                        phi_444_ = false;
                    } else {
                        phi_443_ = bool();
                        phi_444_ = true;
                    }
                    let _e249 = phi_443_;
                    let _e251 = phi_444_;
                    phi_445_ = _e249;
                    phi_446_ = _e251;
                } else {
                    phi_445_ = bool();
                    phi_446_ = true;
                }
                let _e253 = phi_445_;
                let _e255 = phi_446_;
                phi_447_ = _e253;
                phi_448_ = _e255;
            } else {
                phi_447_ = bool();
                phi_448_ = true;
            }
            let _e257 = phi_447_;
            let _e259 = phi_448_;
            if _e259 {
                phi_452_ = false;
            } else {
                phi_452_ = _e257;
            }
            let _e261 = phi_452_;
            if _e261 {
                if (0f > 0f) {
                    let _e264 = samples.member[_e55.first_primitive].normal;
                    let _e266 = p.member.map_size;
                    let _e269 = p.member.projection.row_x;
                    let _e291 = p.member.projection.row_y;
                    let _e313 = p.member.projection.row_z;
                    let _e340 = ((abs(((((_e269.x * _e264.x) + (_e269.y * _e264.y)) + (_e269.z * _e264.z)) / (((_e269.x * _e269.x) + (_e269.y * _e269.y)) + (_e269.z * _e269.z)))) + abs(((((_e291.x * _e264.x) + (_e291.y * _e264.y)) + (_e291.z * _e264.z)) / (((_e291.x * _e291.x) + (_e291.y * _e291.y)) + (_e291.z * _e291.z))))) / (abs(((((_e313.x * _e264.x) + (_e313.y * _e264.y)) + (_e313.z * _e264.z)) / (((_e313.x * _e313.x) + (_e313.y * _e313.y)) + (_e313.z * _e313.z)))) * f32(_e266)));
                    if (_e340 < 0.002f) {
                        phi_546_ = _e340;
                    } else {
                        phi_546_ = 0.002f;
                    }
                    let _e343 = phi_546_;
                    phi_549_ = (_e234 - (0f * _e343));
                } else {
                    phi_549_ = _e234;
                }
                let _e347 = phi_549_;
                let _e349 = p.member.map_size;
                let _e350 = f32(_e349);
                let _e353 = ((_e207 * _e350) - 0.5f);
                let _e354 = ((_e221 * _e350) - 0.5f);
                if (_e353 > -8388608f) {
                    let _e366 = f32(select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < bitcast<f32>(3472883712u))), 2147483647i, (_e353 > bitcast<f32>(1325400063u))), (_e353 == _e353)));
                    if (_e366 > _e353) {
                        phi_578_ = 1f;
                    } else {
                        phi_578_ = 0f;
                    }
                    let _e369 = phi_578_;
                    if (_e353 < 8388608f) {
                        phi_583_ = (_e366 - _e369);
                        phi_584_ = false;
                    } else {
                        phi_583_ = f32();
                        phi_584_ = true;
                    }
                    let _e372 = phi_583_;
                    let _e374 = phi_584_;
                    phi_585_ = _e372;
                    phi_586_ = _e374;
                } else {
                    phi_585_ = f32();
                    phi_586_ = true;
                }
                let _e376 = phi_585_;
                let _e378 = phi_586_;
                if _e378 {
                    phi_590_ = _e353;
                } else {
                    phi_590_ = _e376;
                }
                let _e380 = phi_590_;
                if (_e354 > -8388608f) {
                    let _e392 = f32(select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < bitcast<f32>(3472883712u))), 2147483647i, (_e354 > bitcast<f32>(1325400063u))), (_e354 == _e354)));
                    if (_e392 > _e354) {
                        phi_610_ = 1f;
                    } else {
                        phi_610_ = 0f;
                    }
                    let _e395 = phi_610_;
                    if (_e354 < 8388608f) {
                        phi_615_ = (_e392 - _e395);
                        phi_616_ = false;
                    } else {
                        phi_615_ = f32();
                        phi_616_ = true;
                    }
                    let _e398 = phi_615_;
                    let _e400 = phi_616_;
                    phi_617_ = _e398;
                    phi_618_ = _e400;
                } else {
                    phi_617_ = f32();
                    phi_618_ = true;
                }
                let _e402 = phi_617_;
                let _e404 = phi_618_;
                if _e404 {
                    phi_622_ = _e354;
                } else {
                    phi_622_ = _e402;
                }
                let _e406 = phi_622_;
                let _e407 = (_e353 - _e380);
                let _e408 = (_e354 - _e406);
                let _e417 = select(0i, select(select(i32(_e380), i32(-2147483648), (_e380 < bitcast<f32>(3472883712u))), 2147483647i, (_e380 > bitcast<f32>(1325400063u))), (_e380 == _e380));
                let _e426 = select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406));
                let _e429 = ((1f - _e407) * (1f - _e408));
                let _e431 = (_e407 * (1f - _e408));
                let _e433 = ((1f - _e407) * _e408);
                let _e434 = (_e407 * _e408);
                let _e436 = p.member.test;
                let _e437 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e436);
                let _e439 = p.member.map_size;
                local_1 = _e437;
                let _e441 = (bitcast<i32>(_e439) - 1i);
                if (_e417 > 0i) {
                    phi_668_ = _e417;
                } else {
                    phi_668_ = 0i;
                }
                let _e444 = phi_668_;
                if (_e426 > 0i) {
                    phi_673_ = _e426;
                } else {
                    phi_673_ = 0i;
                }
                let _e447 = phi_673_;
                if (_e444 < _e441) {
                    phi_678_ = _e444;
                } else {
                    phi_678_ = _e441;
                }
                let _e450 = phi_678_;
                if (_e447 < _e441) {
                    phi_683_ = _e447;
                } else {
                    phi_683_ = _e441;
                }
                let _e453 = phi_683_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e417 + 1i);
                let _e457 = (_e426 + 1i);
                if (_e456 > 0i) {
                    phi_692_ = _e456;
                } else {
                    phi_692_ = 0i;
                }
                let _e460 = phi_692_;
                if (_e457 > 0i) {
                    phi_697_ = _e457;
                } else {
                    phi_697_ = 0i;
                }
                let _e463 = phi_697_;
                if (_e460 < _e441) {
                    phi_702_ = _e460;
                } else {
                    phi_702_ = _e441;
                }
                let _e466 = phi_702_;
                if (_e463 < _e441) {
                    phi_707_ = _e463;
                } else {
                    phi_707_ = _e441;
                }
                let _e469 = phi_707_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (bitcast<u32>(_e453) * _e439);
                let _e473 = (bitcast<u32>(_e469) * _e439);
                let _e474 = (_e472 + _e454);
                let _e475 = (_e472 + _e470);
                let _e476 = (_e473 + _e454);
                let _e477 = (_e473 + _e470);
                if (_e474 < _e45) {
                } else {
                    return;
                }
                let _e481 = map.member[(0u + _e474)];
                if (_e475 < _e45) {
                } else {
                    return;
                }
                let _e493 = map.member[(0u + _e475)];
                if (_e476 < _e45) {
                } else {
                    return;
                }
                let _e509 = map.member[(0u + _e476)];
                if (_e477 < _e45) {
                } else {
                    return;
                }
                let _e525 = map.member[(0u + _e477)];
                let _e539 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e481.x * _e429) + (_e493.x * _e431)) + (_e509.x * _e433)) + (_e525.x * _e434)), ((((_e481.y * _e429) + (_e493.y * _e431)) + (_e509.y * _e433)) + (_e525.y * _e434)), ((((_e481.z * _e429) + (_e493.z * _e431)) + (_e509.z * _e433)) + (_e525.z * _e434)), ((((_e481.w * _e429) + (_e493.w * _e431)) + (_e509.w * _e433)) + (_e525.w * _e434))), _e347);
                let _e541 = p.member.epsilon;
                if (_e539 <= _e541) {
                    phi_798_ = true;
                } else {
                    phi_798_ = (_e539 >= (1f - _e541));
                }
                let _e546 = phi_798_;
                if ((bitcast<u32>(_e539) & 2147483647u) > 2139095040u) {
                    phi_806_ = true;
                } else {
                    phi_806_ = !(_e546);
                }
                let _e552 = phi_806_;
                if (_e539 > 0.5f) {
                    phi_811_ = 1f;
                } else {
                    phi_811_ = 0f;
                }
                let _e555 = phi_811_;
                phi_814_ = evaluate_Verdict(_e555, _e552);
            } else {
                phi_814_ = evaluate_Verdict(1f, true);
            }
            let _e559 = phi_814_;
            phi_815_ = _e559;
        }
        let _e561 = phi_815_;
        visibility.member[_e55.first_primitive] = _e561.visibility;
        phi_819_ = _e561.is_doubted;
        phi_820_ = _e55.first_primitive;
    } else {
        phi_819_ = false;
        phi_820_ = 0u;
    }
    let _e566 = phi_819_;
    let _e568 = phi_820_;
    if _e566 {
        let _e570 = atomicAdd((&shared_[0u]), 1u);
        phi_826_ = _e570;
    } else {
        phi_826_ = 0u;
    }
    let _e572 = phi_826_;
    workgroupBarrier();
    if (_e40 == 0u) {
        let _e576 = atomicLoad((&shared_[0u]));
        let _e577 = atomicAdd((&list.member[3u]), _e576);
        atomicStore((&shared_[1u]), _e577);
    }
    workgroupBarrier();
    if _e566 {
        let _e580 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e580) + _e572)]), _e568);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
