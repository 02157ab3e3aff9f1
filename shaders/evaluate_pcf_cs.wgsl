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

struct type_27 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_27;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_122_: lt_bvh_traverse_Tree;
    var phi_123_: bool;
    var phi_124_: lt_bvh_traverse_Tree;
    var phi_125_: bool;
    var phi_130_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_122_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_123_ = false;
        } else {
            phi_122_ = lt_bvh_traverse_Tree();
            phi_123_ = true;
        }
        let _e46 = phi_122_;
        let _e48 = phi_123_;
        phi_124_ = _e46;
        phi_125_ = _e48;
    } else {
        phi_124_ = lt_bvh_traverse_Tree();
        phi_125_ = true;
    }
    let _e50 = phi_124_;
    let _e52 = phi_125_;
    if _e52 {
        phi_130_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_130_ = _e50;
    }
    let _e57 = phi_130_;
    return lt_bvh_traverse_Tree(_e57.root, _e57.first_primitive);
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_3: ptr<function, f32>, param_4: vec4<f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_683_: f32;
    var phi_684_: f32;
    var phi_685_: f32;
    var phi_701_: f32;
    var phi_702_: f32;
    var phi_703_: f32;
    var phi_719_: f32;
    var phi_720_: f32;
    var phi_721_: f32;
    var phi_737_: f32;
    var phi_738_: f32;
    var phi_739_: f32;
    var phi_759_: f32;
    var phi_760_: f32;
    var phi_761_: f32;
    var phi_778_: f32;
    var phi_779_: f32;
    var phi_780_: f32;
    var phi_797_: f32;
    var phi_798_: f32;
    var phi_799_: f32;
    var phi_816_: f32;
    var phi_817_: f32;
    var phi_818_: f32;
    var phi_835_: f32;
    var phi_836_: f32;
    var phi_837_: f32;
    var phi_863_: f32;
    var phi_864_: f32;
    var phi_865_: f32;

    if ((bitcast<u32>(param_4.x) & 2147483647u) > 2139095040u) {
        phi_685_ = param_4.x;
    } else {
        if (param_4.x < 0f) {
            phi_684_ = 0f;
        } else {
            if (param_4.x > 1f) {
                phi_683_ = 1f;
            } else {
                phi_683_ = param_4.x;
            }
            let _e44 = phi_683_;
            phi_684_ = _e44;
        }
        let _e46 = phi_684_;
        phi_685_ = _e46;
    }
    let _e48 = phi_685_;
    if ((bitcast<u32>(param_4.y) & 2147483647u) > 2139095040u) {
        phi_703_ = param_4.y;
    } else {
        if (param_4.y < 0f) {
            phi_702_ = 0f;
        } else {
            if (param_4.y > 1f) {
                phi_701_ = 1f;
            } else {
                phi_701_ = param_4.y;
            }
            let _e56 = phi_701_;
            phi_702_ = _e56;
        }
        let _e58 = phi_702_;
        phi_703_ = _e58;
    }
    let _e60 = phi_703_;
    if ((bitcast<u32>(param_4.z) & 2147483647u) > 2139095040u) {
        phi_721_ = param_4.z;
    } else {
        if (param_4.z < 0f) {
            phi_720_ = 0f;
        } else {
            if (param_4.z > 1f) {
                phi_719_ = 1f;
            } else {
                phi_719_ = param_4.z;
            }
            let _e68 = phi_719_;
            phi_720_ = _e68;
        }
        let _e70 = phi_720_;
        phi_721_ = _e70;
    }
    let _e72 = phi_721_;
    if ((bitcast<u32>(param_4.w) & 2147483647u) > 2139095040u) {
        phi_739_ = param_4.w;
    } else {
        if (param_4.w < 0f) {
            phi_738_ = 0f;
        } else {
            if (param_4.w > 1f) {
                phi_737_ = 1f;
            } else {
                phi_737_ = param_4.w;
            }
            let _e80 = phi_737_;
            phi_738_ = _e80;
        }
        let _e82 = phi_738_;
        phi_739_ = _e82;
    }
    let _e84 = phi_739_;
    let _e85 = (*param_3);
    let _e86 = (_e48 + _e85);
    let _e87 = (_e60 + _e85);
    let _e88 = (_e72 + _e85);
    let _e89 = (_e84 + _e85);
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_761_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_760_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_759_ = 1f;
            } else {
                phi_759_ = param_6;
            }
            let _e96 = phi_759_;
            phi_760_ = _e96;
        }
        let _e98 = phi_760_;
        phi_761_ = _e98;
    }
    let _e100 = phi_761_;
    if ((bitcast<u32>(_e86) & 2147483647u) > 2139095040u) {
        phi_780_ = _e86;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_779_ = _e100;
        } else {
            if (_e86 < _e100) {
                phi_778_ = 0f;
            } else {
                phi_778_ = 1f;
            }
            let _e109 = phi_778_;
            phi_779_ = _e109;
        }
        let _e111 = phi_779_;
        phi_780_ = _e111;
    }
    let _e113 = phi_780_;
    if ((bitcast<u32>(_e87) & 2147483647u) > 2139095040u) {
        phi_799_ = _e87;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_798_ = _e100;
        } else {
            if (_e87 < _e100) {
                phi_797_ = 0f;
            } else {
                phi_797_ = 1f;
            }
            let _e122 = phi_797_;
            phi_798_ = _e122;
        }
        let _e124 = phi_798_;
        phi_799_ = _e124;
    }
    let _e126 = phi_799_;
    if ((bitcast<u32>(_e88) & 2147483647u) > 2139095040u) {
        phi_818_ = _e88;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_817_ = _e100;
        } else {
            if (_e88 < _e100) {
                phi_816_ = 0f;
            } else {
                phi_816_ = 1f;
            }
            let _e135 = phi_816_;
            phi_817_ = _e135;
        }
        let _e137 = phi_817_;
        phi_818_ = _e137;
    }
    let _e139 = phi_818_;
    if ((bitcast<u32>(_e89) & 2147483647u) > 2139095040u) {
        phi_837_ = _e89;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_836_ = _e100;
        } else {
            if (_e89 < _e100) {
                phi_835_ = 0f;
            } else {
                phi_835_ = 1f;
            }
            let _e148 = phi_835_;
            phi_836_ = _e148;
        }
        let _e150 = phi_836_;
        phi_837_ = _e150;
    }
    let _e152 = phi_837_;
    let _e163 = ((((_e113 * param_5.x) + (_e126 * param_5.y)) + (_e139 * param_5.z)) + (_e152 * param_5.w));
    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
        phi_865_ = _e163;
    } else {
        if (_e163 < 0f) {
            phi_864_ = 0f;
        } else {
            if (_e163 > 1f) {
                phi_863_ = 1f;
            } else {
                phi_863_ = _e163;
            }
            let _e170 = phi_863_;
            phi_864_ = _e170;
        }
        let _e172 = phi_864_;
        phi_865_ = _e172;
    }
    let _e174 = phi_865_;
    return _e174;
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_7: vec4<f32>) -> f32 {
    return param_7.x;
}

fn function_() {
    var local: f32;
    var phi_187_: bool;
    var phi_188_: bool;
    var phi_189_: bool;
    var phi_190_: bool;
    var phi_194_: bool;
    var phi_238_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_242_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_319_: bool;
    var phi_328_: bool;
    var phi_337_: bool;
    var phi_338_: bool;
    var phi_339_: bool;
    var phi_340_: bool;
    var phi_341_: bool;
    var phi_342_: bool;
    var phi_343_: bool;
    var phi_347_: bool;
    var phi_441_: f32;
    var phi_444_: f32;
    var phi_473_: f32;
    var phi_478_: f32;
    var phi_479_: bool;
    var phi_480_: f32;
    var phi_481_: bool;
    var phi_485_: f32;
    var phi_505_: f32;
    var phi_510_: f32;
    var phi_511_: bool;
    var phi_512_: f32;
    var phi_513_: bool;
    var phi_517_: f32;
    var phi_563_: i32;
    var phi_568_: i32;
    var phi_573_: i32;
    var phi_578_: i32;
    var phi_587_: i32;
    var phi_592_: i32;
    var phi_597_: i32;
    var phi_602_: i32;
    var phi_643_: evaluate_Verdict;
    var phi_644_: evaluate_Verdict;
    var phi_645_: bool;
    var phi_646_: evaluate_Verdict;
    var phi_647_: evaluate_Verdict;
    var phi_648_: bool;
    var phi_652_: evaluate_Verdict;

    let _e34 = id_1;
    let _e41 = arrayLength((&map.member));
    let _e47 = p.member.size[0u];
    let _e49 = p.member.size[1u];
    let _e50 = lt_shaders_entry_pixel_index(_e34, _e47, _e49);
    if (bitcast<i32>(_e50.root) != 0i) {
        if (_e50.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e59 = p.member.light;
        let _e62 = samples.member[(0u + _e50.first_primitive)].normal[0u];
        let _e64 = global[0u];
        if (_e62 == _e64) {
            let _e67 = samples.member[(0u + _e50.first_primitive)].normal[1u];
            let _e69 = global[1u];
            if (_e67 == _e69) {
                let _e72 = samples.member[(0u + _e50.first_primitive)].normal[2u];
                let _e74 = global[2u];
                phi_187_ = (_e72 == _e74);
                phi_188_ = false;
            } else {
                phi_187_ = bool();
                phi_188_ = true;
            }
            let _e77 = phi_187_;
            let _e79 = phi_188_;
            phi_189_ = _e77;
            phi_190_ = _e79;
        } else {
            phi_189_ = bool();
            phi_190_ = true;
        }
        let _e81 = phi_189_;
        let _e83 = phi_190_;
        if _e83 {
            phi_194_ = false;
        } else {
            phi_194_ = _e81;
        }
        let _e85 = phi_194_;
        if !(_e85) {
            let _e88 = samples.member[(0u + _e50.first_primitive)].normal;
            let _e90 = samples.member[(0u + _e50.first_primitive)].position;
            if ((((_e88.x * (_e59.x - (_e90.x * _e59.w))) + (_e88.y * (_e59.y - (_e90.y * _e59.w)))) + (_e88.z * (_e59.z - (_e90.z * _e59.w)))) > 0f) {
                let _e114 = samples.member[(0u + _e50.first_primitive)].flags;
                let _e122 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e122.unnamed.visibility, false), _e122.unnamed_1);
                phi_238_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e128.unnamed, ((_e114 & 1u) == 0u));
            } else {
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_238_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, true);
            }
            let _e148 = phi_238_;
            phi_242_ = _e148;
        } else {
            let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
            phi_242_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
        }
        let _e165 = phi_242_;
        if _e165.unnamed_1 {
            phi_646_ = evaluate_Verdict(_e165.unnamed.visibility, _e165.unnamed.is_doubted);
            phi_647_ = evaluate_Verdict();
            phi_648_ = true;
        } else {
            let _e173 = samples.member[(0u + _e50.first_primitive)].position;
            let _e179 = p.member.projection.row_w;
            let _e190 = ((((_e179.x * _e173.x) + (_e179.y * _e173.y)) + (_e179.z * _e173.z)) + (_e179.w * 1f));
            let _e192 = p.member.projection.row_x;
            let _e204 = (((((_e192.x * _e173.x) + (_e192.y * _e173.y)) + (_e192.z * _e173.z)) + (_e192.w * 1f)) / _e190);
            let _e206 = p.member.projection.row_y;
            let _e218 = (((((_e206.x * _e173.x) + (_e206.y * _e173.y)) + (_e206.z * _e173.z)) + (_e206.w * 1f)) / _e190);
            let _e220 = p.member.projection.row_z;
            let _e231 = ((((_e220.x * _e173.x) + (_e220.y * _e173.y)) + (_e220.z * _e173.z)) + (_e220.w * 1f));
            if (_e190 > 0f) {
                if (_e204 >= 0f) {
                    phi_319_ = (_e204 <= 1f);
                } else {
                    phi_319_ = false;
                }
                let _e236 = phi_319_;
                if _e236 {
                    if (_e218 >= 0f) {
                        phi_328_ = (_e218 <= 1f);
                    } else {
                        phi_328_ = false;
                    }
                    let _e240 = phi_328_;
                    if _e240 {
                        if (_e231 >= 0f) {
                            phi_337_ = (_e231 <= 1f);
                        } else {
                            phi_337_ = false;
                        }
                        let _e244 = phi_337_;
                        phi_338_ = _e244;
                        phi_339_ = false;
                    } else {
                        phi_338_ = bool();
                        phi_339_ = true;
                    }
                    let _e246 = phi_338_;
                    let _e248 = phi_339_;
                    phi_340_ = _e246;
                    phi_341_ = _e248;
                } else {
                    phi_340_ = bool();
                    phi_341_ = true;
                }
                let _e250 = phi_340_;
                let _e252 = phi_341_;
                phi_342_ = _e250;
                phi_343_ = _e252;
            } else {
                phi_342_ = bool();
                phi_343_ = true;
            }
            let _e254 = phi_342_;
            let _e256 = phi_343_;
            if _e256 {
                phi_347_ = false;
            } else {
                phi_347_ = _e254;
            }
            let _e258 = phi_347_;
            if _e258 {
                if (1f > 0f) {
                    let _e261 = samples.member[(0u + _e50.first_primitive)].normal;
                    let _e263 = p.member.map_size;
                    let _e266 = p.member.projection.row_x;
                    let _e288 = p.member.projection.row_y;
                    let _e310 = p.member.projection.row_z;
                    let _e337 = ((abs(((((_e266.x * _e261.x) + (_e266.y * _e261.y)) + (_e266.z * _e261.z)) / (((_e266.x * _e266.x) + (_e266.y * _e266.y)) + (_e266.z * _e266.z)))) + abs(((((_e288.x * _e261.x) + (_e288.y * _e261.y)) + (_e288.z * _e261.z)) / (((_e288.x * _e288.x) + (_e288.y * _e288.y)) + (_e288.z * _e288.z))))) / (abs(((((_e310.x * _e261.x) + (_e310.y * _e261.y)) + (_e310.z * _e261.z)) / (((_e310.x * _e310.x) + (_e310.y * _e310.y)) + (_e310.z * _e310.z)))) * f32(_e263)));
                    if (_e337 < 0.002f) {
                        phi_441_ = _e337;
                    } else {
                        phi_441_ = 0.002f;
                    }
                    let _e340 = phi_441_;
                    phi_444_ = (_e231 - (1f * _e340));
                } else {
                    phi_444_ = _e231;
                }
                let _e344 = phi_444_;
                let _e346 = p.member.map_size;
                let _e347 = f32(_e346);
                let _e350 = ((_e204 * _e347) - 0.5f);
                let _e351 = ((_e218 * _e347) - 0.5f);
                if (_e350 > -8388608f) {
                    let _e363 = f32(select(0i, select(select(i32(_e350), i32(-2147483648), (_e350 < bitcast<f32>(3472883712u))), 2147483647i, (_e350 > bitcast<f32>(1325400063u))), (_e350 == _e350)));
                    if (_e363 > _e350) {
                        phi_473_ = 1f;
                    } else {
                        phi_473_ = 0f;
                    }
                    let _e366 = phi_473_;
                    if (_e350 < 8388608f) {
                        phi_478_ = (_e363 - _e366);
                        phi_479_ = false;
                    } else {
                        phi_478_ = f32();
                        phi_479_ = true;
                    }
                    let _e369 = phi_478_;
                    let _e371 = phi_479_;
                    phi_480_ = _e369;
                    phi_481_ = _e371;
                } else {
                    phi_480_ = f32();
                    phi_481_ = true;
                }
                let _e373 = phi_480_;
                let _e375 = phi_481_;
                if _e375 {
                    phi_485_ = _e350;
                } else {
                    phi_485_ = _e373;
                }
                let _e377 = phi_485_;
                if (_e351 > -8388608f) {
                    let _e389 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e389 > _e351) {
                        phi_505_ = 1f;
                    } else {
                        phi_505_ = 0f;
                    }
                    let _e392 = phi_505_;
                    if (_e351 < 8388608f) {
                        phi_510_ = (_e389 - _e392);
                        phi_511_ = false;
                    } else {
                        phi_510_ = f32();
                        phi_511_ = true;
                    }
                    let _e395 = phi_510_;
                    let _e397 = phi_511_;
                    phi_512_ = _e395;
                    phi_513_ = _e397;
                } else {
                    phi_512_ = f32();
                    phi_513_ = true;
                }
                let _e399 = phi_512_;
                let _e401 = phi_513_;
                if _e401 {
                    phi_517_ = _e351;
                } else {
                    phi_517_ = _e399;
                }
                let _e403 = phi_517_;
                let _e404 = (_e350 - _e377);
                let _e405 = (_e351 - _e403);
                let _e414 = select(0i, select(select(i32(_e377), i32(-2147483648), (_e377 < bitcast<f32>(3472883712u))), 2147483647i, (_e377 > bitcast<f32>(1325400063u))), (_e377 == _e377));
                let _e423 = select(0i, select(select(i32(_e403), i32(-2147483648), (_e403 < bitcast<f32>(3472883712u))), 2147483647i, (_e403 > bitcast<f32>(1325400063u))), (_e403 == _e403));
                let _e434 = p.member.test;
                let _e435 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e434);
                let _e437 = p.member.map_size;
                local = _e435;
                let _e439 = (bitcast<i32>(_e437) - 1i);
                if (_e414 > 0i) {
                    phi_563_ = _e414;
                } else {
                    phi_563_ = 0i;
                }
                let _e442 = phi_563_;
                if (_e423 > 0i) {
                    phi_568_ = _e423;
                } else {
                    phi_568_ = 0i;
                }
                let _e445 = phi_568_;
                if (_e442 < _e439) {
                    phi_573_ = _e442;
                } else {
                    phi_573_ = _e439;
                }
                let _e448 = phi_573_;
                if (_e445 < _e439) {
                    phi_578_ = _e445;
                } else {
                    phi_578_ = _e439;
                }
                let _e451 = phi_578_;
                let _e452 = bitcast<u32>(_e448);
                let _e454 = (_e414 + 1i);
                let _e455 = (_e423 + 1i);
                if (_e454 > 0i) {
                    phi_587_ = _e454;
                } else {
                    phi_587_ = 0i;
                }
                let _e458 = phi_587_;
                if (_e455 > 0i) {
                    phi_592_ = _e455;
                } else {
                    phi_592_ = 0i;
                }
                let _e461 = phi_592_;
                if (_e458 < _e439) {
                    phi_597_ = _e458;
                } else {
                    phi_597_ = _e439;
                }
                let _e464 = phi_597_;
                if (_e461 < _e439) {
                    phi_602_ = _e461;
                } else {
                    phi_602_ = _e439;
                }
                let _e467 = phi_602_;
                let _e468 = bitcast<u32>(_e464);
                let _e470 = (bitcast<u32>(_e451) * _e437);
                let _e471 = (bitcast<u32>(_e467) * _e437);
                let _e472 = (_e470 + _e452);
                let _e473 = (_e470 + _e468);
                let _e474 = (_e471 + _e452);
                let _e475 = (_e471 + _e468);
                if (_e472 < _e41) {
                } else {
                    return;
                }
                let _e479 = map.member[(0u + _e472)];
                if (_e473 < _e41) {
                } else {
                    return;
                }
                let _e483 = map.member[(0u + _e473)];
                if (_e474 < _e41) {
                } else {
                    return;
                }
                let _e487 = map.member[(0u + _e474)];
                if (_e475 < _e41) {
                } else {
                    return;
                }
                let _e491 = map.member[(0u + _e475)];
                let _e493 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e479, _e483, _e487, _e491), vec4<f32>(((1f - _e404) * (1f - _e405)), (_e404 * (1f - _e405)), ((1f - _e404) * _e405), (_e404 * _e405)), _e344);
                phi_643_ = evaluate_Verdict(_e493, false);
                phi_644_ = evaluate_Verdict();
                phi_645_ = false;
            } else {
                phi_643_ = evaluate_Verdict();
                phi_644_ = evaluate_Verdict(1f, false);
                phi_645_ = true;
            }
            let _e497 = phi_643_;
            let _e499 = phi_644_;
            let _e501 = phi_645_;
            phi_646_ = _e499;
            phi_647_ = _e497;
            phi_648_ = _e501;
        }
        let _e503 = phi_646_;
        let _e505 = phi_647_;
        let _e507 = phi_648_;
        if _e507 {
            phi_652_ = _e503;
        } else {
            phi_652_ = _e505;
        }
        let _e509 = phi_652_;
        if (_e50.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e50.first_primitive)] = _e509.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_pcf_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
