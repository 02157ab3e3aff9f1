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
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_28 {
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
var<uniform> p: type_28;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_126_: lt_bvh_traverse_Tree;
    var phi_127_: bool;
    var phi_128_: lt_bvh_traverse_Tree;
    var phi_129_: bool;
    var phi_134_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_126_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_127_ = false;
        } else {
            phi_126_ = lt_bvh_traverse_Tree();
            phi_127_ = true;
        }
        let _e46 = phi_126_;
        let _e48 = phi_127_;
        phi_128_ = _e46;
        phi_129_ = _e48;
    } else {
        phi_128_ = lt_bvh_traverse_Tree();
        phi_129_ = true;
    }
    let _e50 = phi_128_;
    let _e52 = phi_129_;
    if _e52 {
        phi_134_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_134_ = _e50;
    }
    let _e57 = phi_134_;
    return lt_bvh_traverse_Tree(_e57.root, _e57.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_160_: f32;
    var phi_161_: f32;
    var phi_162_: f32;
    var phi_178_: f32;
    var phi_179_: f32;
    var phi_180_: f32;
    var phi_196_: f32;
    var phi_197_: f32;
    var phi_198_: f32;
    var phi_214_: f32;
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_232_: f32;
    var phi_233_: f32;
    var phi_234_: f32;
    var phi_280_: bool;
    var phi_284_: f32;
    var phi_296_: bool;
    var phi_303_: f32;
    var phi_318_: f32;
    var phi_319_: f32;
    var phi_320_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_162_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_161_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_160_ = 1f;
            } else {
                phi_160_ = param_7;
            }
            let _e43 = phi_160_;
            phi_161_ = _e43;
        }
        let _e45 = phi_161_;
        phi_162_ = _e45;
    }
    let _e47 = phi_162_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_180_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_179_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_178_ = 1f;
            } else {
                phi_178_ = param_5.x;
            }
            let _e55 = phi_178_;
            phi_179_ = _e55;
        }
        let _e57 = phi_179_;
        phi_180_ = _e57;
    }
    let _e59 = phi_180_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_198_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_197_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_196_ = 1f;
            } else {
                phi_196_ = param_5.y;
            }
            let _e67 = phi_196_;
            phi_197_ = _e67;
        }
        let _e69 = phi_197_;
        phi_198_ = _e69;
    }
    let _e71 = phi_198_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_216_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_215_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_214_ = 1f;
            } else {
                phi_214_ = param_5.z;
            }
            let _e79 = phi_214_;
            phi_215_ = _e79;
        }
        let _e81 = phi_215_;
        phi_216_ = _e81;
    }
    let _e83 = phi_216_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_234_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_233_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_232_ = 1f;
            } else {
                phi_232_ = param_5.w;
            }
            let _e91 = phi_232_;
            phi_233_ = _e91;
        }
        let _e93 = phi_233_;
        phi_234_ = _e93;
    }
    let _e95 = phi_234_;
    let _e96 = (_e59 - _e47);
    let _e97 = (_e71 - _e47);
    let _e98 = (_e83 - _e47);
    let _e99 = (_e95 - _e47);
    let _e100 = (*param_4);
    let _e111 = ((((_e96 * param_6.x) + (_e97 * param_6.y)) + (_e98 * param_6.z)) + (_e99 * param_6.w));
    let _e112 = (_e96 - _e111);
    let _e113 = (_e97 - _e111);
    let _e114 = (_e98 - _e111);
    let _e115 = (_e99 - _e111);
    let _e130 = (((((_e112 * _e112) * param_6.x) + ((_e113 * _e113) * param_6.y)) + ((_e114 * _e114) * param_6.z)) + ((_e115 * _e115) * param_6.w));
    if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
        phi_280_ = true;
    } else {
        let _e134 = (_e100 > _e130);
        if _e134 {
        }
        phi_280_ = _e134;
    }
    let _e136 = phi_280_;
    if _e136 {
        phi_284_ = _e100;
    } else {
        phi_284_ = _e130;
    }
    let _e138 = phi_284_;
    let _e139 = -(_e111);
    if (_e139 <= 0f) {
        let _e143 = ((bitcast<u32>(_e138) & 2147483647u) > 2139095040u);
        if _e143 {
        }
        phi_296_ = _e143;
    } else {
        phi_296_ = true;
    }
    let _e145 = phi_296_;
    if _e145 {
        phi_303_ = (_e138 / (_e138 + (_e139 * _e139)));
    } else {
        phi_303_ = 1f;
    }
    let _e150 = phi_303_;
    if ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u) {
        phi_320_ = _e150;
    } else {
        if (_e150 < 0f) {
            phi_319_ = 0f;
        } else {
            if (_e150 > 1f) {
                phi_318_ = 1f;
            } else {
                phi_318_ = _e150;
            }
            let _e157 = phi_318_;
            phi_319_ = _e157;
        }
        let _e159 = phi_319_;
        phi_320_ = _e159;
    }
    let _e161 = phi_320_;
    return _e161;
}

fn function_() {
    var local: f32;
    var phi_377_: bool;
    var phi_378_: bool;
    var phi_379_: bool;
    var phi_380_: bool;
    var phi_384_: bool;
    var phi_428_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_432_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_506_: bool;
    var phi_515_: bool;
    var phi_524_: bool;
    var phi_525_: bool;
    var phi_526_: bool;
    var phi_527_: bool;
    var phi_528_: bool;
    var phi_529_: bool;
    var phi_530_: bool;
    var phi_534_: bool;
    var phi_624_: f32;
    var phi_627_: f32;
    var phi_656_: f32;
    var phi_661_: f32;
    var phi_662_: bool;
    var phi_663_: f32;
    var phi_664_: bool;
    var phi_668_: f32;
    var phi_688_: f32;
    var phi_693_: f32;
    var phi_694_: bool;
    var phi_695_: f32;
    var phi_696_: bool;
    var phi_700_: f32;
    var phi_748_: i32;
    var phi_753_: i32;
    var phi_758_: i32;
    var phi_763_: i32;
    var phi_772_: i32;
    var phi_777_: i32;
    var phi_782_: i32;
    var phi_787_: i32;
    var phi_838_: bool;
    var phi_846_: bool;
    var phi_858_: bool;
    var phi_859_: bool;
    var phi_863_: f32;
    var phi_869_: f32;
    var phi_871_: evaluate_Verdict;
    var phi_876_: evaluate_Verdict;
    var phi_877_: evaluate_Verdict;

    let _e34 = id_1;
    let _e41 = arrayLength((&map.member));
    let _e47 = p.member.size[0u];
    let _e49 = p.member.size[1u];
    let _e50 = lt_shaders_entry_pixel_index(_e34, _e47, _e49);
    if (bitcast<i32>(_e50.root) != 0i) {
        let _e56 = p.member.projection;
        if (_e50.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e60 = lt_math_OneLevel(_e56);
        let _e62 = p.member.light;
        let _e65 = samples.member[(0u + _e50.first_primitive)].normal[0u];
        let _e67 = global[0u];
        if (_e65 == _e67) {
            let _e70 = samples.member[(0u + _e50.first_primitive)].normal[1u];
            let _e72 = global[1u];
            if (_e70 == _e72) {
                let _e75 = samples.member[(0u + _e50.first_primitive)].normal[2u];
                let _e77 = global[2u];
                phi_377_ = (_e75 == _e77);
                phi_378_ = false;
            } else {
                phi_377_ = bool();
                phi_378_ = true;
            }
            let _e80 = phi_377_;
            let _e82 = phi_378_;
            phi_379_ = _e80;
            phi_380_ = _e82;
        } else {
            phi_379_ = bool();
            phi_380_ = true;
        }
        let _e84 = phi_379_;
        let _e86 = phi_380_;
        if _e86 {
            phi_384_ = false;
        } else {
            phi_384_ = _e84;
        }
        let _e88 = phi_384_;
        if !(_e88) {
            let _e91 = samples.member[(0u + _e50.first_primitive)].normal;
            let _e93 = samples.member[(0u + _e50.first_primitive)].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[(0u + _e50.first_primitive)].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_428_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_428_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_428_;
            phi_432_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_432_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_432_;
        if _e168.unnamed_1 {
            phi_877_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
        } else {
            let _e176 = samples.member[(0u + _e50.first_primitive)].position;
            let _e194 = ((((_e60.projection.row_w.x * _e176.x) + (_e60.projection.row_w.y * _e176.y)) + (_e60.projection.row_w.z * _e176.z)) + (_e60.projection.row_w.w * 1f));
            let _e208 = (((((_e60.projection.row_x.x * _e176.x) + (_e60.projection.row_x.y * _e176.y)) + (_e60.projection.row_x.z * _e176.z)) + (_e60.projection.row_x.w * 1f)) / _e194);
            let _e222 = (((((_e60.projection.row_y.x * _e176.x) + (_e60.projection.row_y.y * _e176.y)) + (_e60.projection.row_y.z * _e176.z)) + (_e60.projection.row_y.w * 1f)) / _e194);
            let _e235 = ((((_e60.projection.row_z.x * _e176.x) + (_e60.projection.row_z.y * _e176.y)) + (_e60.projection.row_z.z * _e176.z)) + (_e60.projection.row_z.w * 1f));
            if (_e194 > 0f) {
                if (_e208 >= 0f) {
                    phi_506_ = (_e208 <= 1f);
                } else {
                    phi_506_ = false;
                }
                let _e240 = phi_506_;
                if _e240 {
                    if (_e222 >= 0f) {
                        phi_515_ = (_e222 <= 1f);
                    } else {
                        phi_515_ = false;
                    }
                    let _e244 = phi_515_;
                    if _e244 {
                        if (_e235 >= 0f) {
                            phi_524_ = (_e235 <= 1f);
                        } else {
                            phi_524_ = false;
                        }
                        let _e248 = phi_524_;
                        phi_525_ = _e248;
                        phi_526_ = false;
                    } else {
                        phi_525_ = bool();
                        phi_526_ = true;
                    }
                    let _e250 = phi_525_;
                    let _e252 = phi_526_;
                    phi_527_ = _e250;
                    phi_528_ = _e252;
                } else {
                    phi_527_ = bool();
                    phi_528_ = true;
                }
                let _e254 = phi_527_;
                let _e256 = phi_528_;
                phi_529_ = _e254;
                phi_530_ = _e256;
            } else {
                phi_529_ = bool();
                phi_530_ = true;
            }
            let _e258 = phi_529_;
            let _e260 = phi_530_;
            if _e260 {
                phi_534_ = false;
            } else {
                phi_534_ = _e258;
            }
            let _e262 = phi_534_;
            if _e262 {
                if (0f > 0f) {
                    let _e265 = samples.member[(0u + _e50.first_primitive)].normal;
                    let _e267 = p.member.map_size;
                    let _e337 = ((abs(((((_e56.row_x.x * _e265.x) + (_e56.row_x.y * _e265.y)) + (_e56.row_x.z * _e265.z)) / (((_e56.row_x.x * _e56.row_x.x) + (_e56.row_x.y * _e56.row_x.y)) + (_e56.row_x.z * _e56.row_x.z)))) + abs(((((_e56.row_y.x * _e265.x) + (_e56.row_y.y * _e265.y)) + (_e56.row_y.z * _e265.z)) / (((_e56.row_y.x * _e56.row_y.x) + (_e56.row_y.y * _e56.row_y.y)) + (_e56.row_y.z * _e56.row_y.z))))) / (abs(((((_e56.row_z.x * _e265.x) + (_e56.row_z.y * _e265.y)) + (_e56.row_z.z * _e265.z)) / (((_e56.row_z.x * _e56.row_z.x) + (_e56.row_z.y * _e56.row_z.y)) + (_e56.row_z.z * _e56.row_z.z)))) * f32(_e267)));
                    if (_e337 < 0.002f) {
                        phi_624_ = _e337;
                    } else {
                        phi_624_ = 0.002f;
                    }
                    let _e340 = phi_624_;
                    phi_627_ = (_e235 - (0f * _e340));
                } else {
                    phi_627_ = _e235;
                }
                let _e344 = phi_627_;
                let _e346 = p.member.map_size;
                let _e347 = f32(_e346);
                let _e350 = ((_e208 * _e347) - 0.5f);
                let _e351 = ((_e222 * _e347) - 0.5f);
                if (_e350 > -8388608f) {
                    let _e363 = f32(select(0i, select(select(i32(_e350), i32(-2147483648), (_e350 < bitcast<f32>(3472883712u))), 2147483647i, (_e350 > bitcast<f32>(1325400063u))), (_e350 == _e350)));
                    if (_e363 > _e350) {
                        phi_656_ = 1f;
                    } else {
                        phi_656_ = 0f;
                    }
                    let _e366 = phi_656_;
                    if (_e350 < 8388608f) {
                        phi_661_ = (_e363 - _e366);
                        phi_662_ = false;
                    } else {
                        phi_661_ = f32();
                        phi_662_ = true;
                    }
                    let _e369 = phi_661_;
                    let _e371 = phi_662_;
                    phi_663_ = _e369;
                    phi_664_ = _e371;
                } else {
                    phi_663_ = f32();
                    phi_664_ = true;
                }
                let _e373 = phi_663_;
                let _e375 = phi_664_;
                if _e375 {
                    phi_668_ = _e350;
                } else {
                    phi_668_ = _e373;
                }
                let _e377 = phi_668_;
                if (_e351 > -8388608f) {
                    let _e389 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e389 > _e351) {
                        phi_688_ = 1f;
                    } else {
                        phi_688_ = 0f;
                    }
                    let _e392 = phi_688_;
                    if (_e351 < 8388608f) {
                        phi_693_ = (_e389 - _e392);
                        phi_694_ = false;
                    } else {
                        phi_693_ = f32();
                        phi_694_ = true;
                    }
                    let _e395 = phi_693_;
                    let _e397 = phi_694_;
                    phi_695_ = _e395;
                    phi_696_ = _e397;
                } else {
                    phi_695_ = f32();
                    phi_696_ = true;
                }
                let _e399 = phi_695_;
                let _e401 = phi_696_;
                if _e401 {
                    phi_700_ = _e351;
                } else {
                    phi_700_ = _e399;
                }
                let _e403 = phi_700_;
                let _e404 = (_e350 - _e377);
                let _e405 = (_e351 - _e403);
                let _e414 = select(0i, select(select(i32(_e377), i32(-2147483648), (_e377 < bitcast<f32>(3472883712u))), 2147483647i, (_e377 > bitcast<f32>(1325400063u))), (_e377 == _e377));
                let _e423 = select(0i, select(select(i32(_e403), i32(-2147483648), (_e403 < bitcast<f32>(3472883712u))), 2147483647i, (_e403 > bitcast<f32>(1325400063u))), (_e403 == _e403));
                let _e434 = p.member.test;
                let _e435 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e434);
                let _e437 = p.member.map_size;
                local = _e435;
                let _e439 = ((0u * _e437) * _e437);
                let _e441 = (bitcast<i32>(_e437) - 1i);
                if (_e414 > 0i) {
                    phi_748_ = _e414;
                } else {
                    phi_748_ = 0i;
                }
                let _e444 = phi_748_;
                if (_e423 > 0i) {
                    phi_753_ = _e423;
                } else {
                    phi_753_ = 0i;
                }
                let _e447 = phi_753_;
                if (_e444 < _e441) {
                    phi_758_ = _e444;
                } else {
                    phi_758_ = _e441;
                }
                let _e450 = phi_758_;
                if (_e447 < _e441) {
                    phi_763_ = _e447;
                } else {
                    phi_763_ = _e441;
                }
                let _e453 = phi_763_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e414 + 1i);
                let _e457 = (_e423 + 1i);
                if (_e456 > 0i) {
                    phi_772_ = _e456;
                } else {
                    phi_772_ = 0i;
                }
                let _e460 = phi_772_;
                if (_e457 > 0i) {
                    phi_777_ = _e457;
                } else {
                    phi_777_ = 0i;
                }
                let _e463 = phi_777_;
                if (_e460 < _e441) {
                    phi_782_ = _e460;
                } else {
                    phi_782_ = _e441;
                }
                let _e466 = phi_782_;
                if (_e463 < _e441) {
                    phi_787_ = _e463;
                } else {
                    phi_787_ = _e441;
                }
                let _e469 = phi_787_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (bitcast<u32>(_e453) * _e437);
                let _e473 = (bitcast<u32>(_e469) * _e437);
                let _e478 = ((_e472 + _e454) + _e439);
                let _e479 = ((_e472 + _e470) + _e439);
                let _e480 = ((_e473 + _e454) + _e439);
                let _e481 = ((_e473 + _e470) + _e439);
                if (_e478 < _e41) {
                } else {
                    return;
                }
                let _e485 = map.member[(0u + _e478)];
                if (_e479 < _e41) {
                } else {
                    return;
                }
                let _e489 = map.member[(0u + _e479)];
                if (_e480 < _e41) {
                } else {
                    return;
                }
                let _e493 = map.member[(0u + _e480)];
                if (_e481 < _e41) {
                } else {
                    return;
                }
                let _e497 = map.member[(0u + _e481)];
                let _e499 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e485, _e489, _e493, _e497), vec4<f32>(((1f - _e404) * (1f - _e405)), (_e404 * (1f - _e405)), ((1f - _e404) * _e405), (_e404 * _e405)), _e344);
                let _e501 = p.member.epsilon;
                if (_e499 <= _e501) {
                    phi_838_ = true;
                } else {
                    phi_838_ = (_e499 >= (1f - _e501));
                }
                let _e506 = phi_838_;
                if ((bitcast<u32>(_e499) & 2147483647u) > 2139095040u) {
                    phi_846_ = true;
                } else {
                    phi_846_ = !(_e506);
                }
                let _e512 = phi_846_;
                if _e512 {
                    if (_e499 > 0f) {
                        if (_e499 < 1f) {
                            phi_858_ = false;
                        } else {
                            phi_858_ = true;
                        }
                        let _e516 = phi_858_;
                        phi_859_ = _e516;
                    } else {
                        phi_859_ = true;
                    }
                    let _e518 = phi_859_;
                    if _e518 {
                        phi_863_ = 0.5f;
                    } else {
                        phi_863_ = _e499;
                    }
                    let _e520 = phi_863_;
                    phi_871_ = evaluate_Verdict(_e520, true);
                } else {
                    if (_e499 > 0.5f) {
                        phi_869_ = 1f;
                    } else {
                        phi_869_ = 0f;
                    }
                    let _e524 = phi_869_;
                    phi_871_ = evaluate_Verdict(_e524, false);
                }
                let _e527 = phi_871_;
                phi_876_ = evaluate_Verdict(_e527.visibility, _e527.is_doubted);
            } else {
                phi_876_ = evaluate_Verdict(0.5f, true);
            }
            let _e533 = phi_876_;
            phi_877_ = _e533;
        }
        let _e535 = phi_877_;
        if (_e50.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e50.first_primitive)] = _e535.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_vsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
