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

struct type_27 {
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
var<uniform> p: type_27;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_124_: lt_bvh_traverse_Tree;
    var phi_125_: bool;
    var phi_126_: lt_bvh_traverse_Tree;
    var phi_127_: bool;
    var phi_132_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_124_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_125_ = false;
        } else {
            phi_124_ = lt_bvh_traverse_Tree();
            phi_125_ = true;
        }
        let _e46 = phi_124_;
        let _e48 = phi_125_;
        phi_126_ = _e46;
        phi_127_ = _e48;
    } else {
        phi_126_ = lt_bvh_traverse_Tree();
        phi_127_ = true;
    }
    let _e50 = phi_126_;
    let _e52 = phi_127_;
    if _e52 {
        phi_132_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_132_ = _e50;
    }
    let _e57 = phi_132_;
    return lt_bvh_traverse_Tree(_e57.root, _e57.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_686_: f32;
    var phi_687_: f32;
    var phi_688_: f32;
    var phi_704_: f32;
    var phi_705_: f32;
    var phi_706_: f32;
    var phi_722_: f32;
    var phi_723_: f32;
    var phi_724_: f32;
    var phi_740_: f32;
    var phi_741_: f32;
    var phi_742_: f32;
    var phi_758_: f32;
    var phi_759_: f32;
    var phi_760_: f32;
    var phi_806_: bool;
    var phi_810_: f32;
    var phi_822_: bool;
    var phi_829_: f32;
    var phi_844_: f32;
    var phi_845_: f32;
    var phi_846_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_688_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_687_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_686_ = 1f;
            } else {
                phi_686_ = param_7;
            }
            let _e43 = phi_686_;
            phi_687_ = _e43;
        }
        let _e45 = phi_687_;
        phi_688_ = _e45;
    }
    let _e47 = phi_688_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_706_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_705_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_704_ = 1f;
            } else {
                phi_704_ = param_5.x;
            }
            let _e55 = phi_704_;
            phi_705_ = _e55;
        }
        let _e57 = phi_705_;
        phi_706_ = _e57;
    }
    let _e59 = phi_706_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_724_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_723_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_722_ = 1f;
            } else {
                phi_722_ = param_5.y;
            }
            let _e67 = phi_722_;
            phi_723_ = _e67;
        }
        let _e69 = phi_723_;
        phi_724_ = _e69;
    }
    let _e71 = phi_724_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_742_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_741_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_740_ = 1f;
            } else {
                phi_740_ = param_5.z;
            }
            let _e79 = phi_740_;
            phi_741_ = _e79;
        }
        let _e81 = phi_741_;
        phi_742_ = _e81;
    }
    let _e83 = phi_742_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_760_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_759_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_758_ = 1f;
            } else {
                phi_758_ = param_5.w;
            }
            let _e91 = phi_758_;
            phi_759_ = _e91;
        }
        let _e93 = phi_759_;
        phi_760_ = _e93;
    }
    let _e95 = phi_760_;
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
        phi_806_ = true;
    } else {
        let _e134 = (_e100 > _e130);
        if _e134 {
        }
        phi_806_ = _e134;
    }
    let _e136 = phi_806_;
    if _e136 {
        phi_810_ = _e100;
    } else {
        phi_810_ = _e130;
    }
    let _e138 = phi_810_;
    let _e139 = -(_e111);
    if (_e139 <= 0f) {
        let _e143 = ((bitcast<u32>(_e138) & 2147483647u) > 2139095040u);
        if _e143 {
        }
        phi_822_ = _e143;
    } else {
        phi_822_ = true;
    }
    let _e145 = phi_822_;
    if _e145 {
        phi_829_ = (_e138 / (_e138 + (_e139 * _e139)));
    } else {
        phi_829_ = 1f;
    }
    let _e150 = phi_829_;
    if ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u) {
        phi_846_ = _e150;
    } else {
        if (_e150 < 0f) {
            phi_845_ = 0f;
        } else {
            if (_e150 > 1f) {
                phi_844_ = 1f;
            } else {
                phi_844_ = _e150;
            }
            let _e157 = phi_844_;
            phi_845_ = _e157;
        }
        let _e159 = phi_845_;
        phi_846_ = _e159;
    }
    let _e161 = phi_846_;
    return _e161;
}

fn function_() {
    var local: f32;
    var phi_195_: bool;
    var phi_196_: bool;
    var phi_197_: bool;
    var phi_198_: bool;
    var phi_202_: bool;
    var phi_246_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_250_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_324_: bool;
    var phi_333_: bool;
    var phi_342_: bool;
    var phi_343_: bool;
    var phi_344_: bool;
    var phi_345_: bool;
    var phi_346_: bool;
    var phi_347_: bool;
    var phi_348_: bool;
    var phi_352_: bool;
    var phi_442_: f32;
    var phi_445_: f32;
    var phi_474_: f32;
    var phi_479_: f32;
    var phi_480_: bool;
    var phi_481_: f32;
    var phi_482_: bool;
    var phi_486_: f32;
    var phi_506_: f32;
    var phi_511_: f32;
    var phi_512_: bool;
    var phi_513_: f32;
    var phi_514_: bool;
    var phi_518_: f32;
    var phi_566_: i32;
    var phi_571_: i32;
    var phi_576_: i32;
    var phi_581_: i32;
    var phi_590_: i32;
    var phi_595_: i32;
    var phi_600_: i32;
    var phi_605_: i32;
    var phi_650_: evaluate_Verdict;
    var phi_651_: evaluate_Verdict;
    var phi_652_: bool;
    var phi_653_: evaluate_Verdict;
    var phi_654_: evaluate_Verdict;
    var phi_655_: bool;
    var phi_659_: evaluate_Verdict;

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
                phi_195_ = (_e75 == _e77);
                phi_196_ = false;
            } else {
                phi_195_ = bool();
                phi_196_ = true;
            }
            let _e80 = phi_195_;
            let _e82 = phi_196_;
            phi_197_ = _e80;
            phi_198_ = _e82;
        } else {
            phi_197_ = bool();
            phi_198_ = true;
        }
        let _e84 = phi_197_;
        let _e86 = phi_198_;
        if _e86 {
            phi_202_ = false;
        } else {
            phi_202_ = _e84;
        }
        let _e88 = phi_202_;
        if !(_e88) {
            let _e91 = samples.member[(0u + _e50.first_primitive)].normal;
            let _e93 = samples.member[(0u + _e50.first_primitive)].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[(0u + _e50.first_primitive)].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_246_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_246_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_246_;
            phi_250_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_250_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_250_;
        if _e168.unnamed_1 {
            phi_653_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
            phi_654_ = evaluate_Verdict();
            phi_655_ = true;
        } else {
            let _e176 = samples.member[(0u + _e50.first_primitive)].position;
            let _e194 = ((((_e60.projection.row_w.x * _e176.x) + (_e60.projection.row_w.y * _e176.y)) + (_e60.projection.row_w.z * _e176.z)) + (_e60.projection.row_w.w * 1f));
            let _e208 = (((((_e60.projection.row_x.x * _e176.x) + (_e60.projection.row_x.y * _e176.y)) + (_e60.projection.row_x.z * _e176.z)) + (_e60.projection.row_x.w * 1f)) / _e194);
            let _e222 = (((((_e60.projection.row_y.x * _e176.x) + (_e60.projection.row_y.y * _e176.y)) + (_e60.projection.row_y.z * _e176.z)) + (_e60.projection.row_y.w * 1f)) / _e194);
            let _e235 = ((((_e60.projection.row_z.x * _e176.x) + (_e60.projection.row_z.y * _e176.y)) + (_e60.projection.row_z.z * _e176.z)) + (_e60.projection.row_z.w * 1f));
            if (_e194 > 0f) {
                if (_e208 >= 0f) {
                    phi_324_ = (_e208 <= 1f);
                } else {
                    phi_324_ = false;
                }
                let _e240 = phi_324_;
                if _e240 {
                    if (_e222 >= 0f) {
                        phi_333_ = (_e222 <= 1f);
                    } else {
                        phi_333_ = false;
                    }
                    let _e244 = phi_333_;
                    if _e244 {
                        if (_e235 >= 0f) {
                            phi_342_ = (_e235 <= 1f);
                        } else {
                            phi_342_ = false;
                        }
                        let _e248 = phi_342_;
                        phi_343_ = _e248;
                        phi_344_ = false;
                    } else {
                        phi_343_ = bool();
                        phi_344_ = true;
                    }
                    let _e250 = phi_343_;
                    let _e252 = phi_344_;
                    phi_345_ = _e250;
                    phi_346_ = _e252;
                } else {
                    phi_345_ = bool();
                    phi_346_ = true;
                }
                let _e254 = phi_345_;
                let _e256 = phi_346_;
                phi_347_ = _e254;
                phi_348_ = _e256;
            } else {
                phi_347_ = bool();
                phi_348_ = true;
            }
            let _e258 = phi_347_;
            let _e260 = phi_348_;
            if _e260 {
                phi_352_ = false;
            } else {
                phi_352_ = _e258;
            }
            let _e262 = phi_352_;
            if _e262 {
                if (0f > 0f) {
                    let _e265 = samples.member[(0u + _e50.first_primitive)].normal;
                    let _e267 = p.member.map_size;
                    let _e337 = ((abs(((((_e56.row_x.x * _e265.x) + (_e56.row_x.y * _e265.y)) + (_e56.row_x.z * _e265.z)) / (((_e56.row_x.x * _e56.row_x.x) + (_e56.row_x.y * _e56.row_x.y)) + (_e56.row_x.z * _e56.row_x.z)))) + abs(((((_e56.row_y.x * _e265.x) + (_e56.row_y.y * _e265.y)) + (_e56.row_y.z * _e265.z)) / (((_e56.row_y.x * _e56.row_y.x) + (_e56.row_y.y * _e56.row_y.y)) + (_e56.row_y.z * _e56.row_y.z))))) / (abs(((((_e56.row_z.x * _e265.x) + (_e56.row_z.y * _e265.y)) + (_e56.row_z.z * _e265.z)) / (((_e56.row_z.x * _e56.row_z.x) + (_e56.row_z.y * _e56.row_z.y)) + (_e56.row_z.z * _e56.row_z.z)))) * f32(_e267)));
                    if (_e337 < 0.002f) {
                        phi_442_ = _e337;
                    } else {
                        phi_442_ = 0.002f;
                    }
                    let _e340 = phi_442_;
                    phi_445_ = (_e235 - (0f * _e340));
                } else {
                    phi_445_ = _e235;
                }
                let _e344 = phi_445_;
                let _e346 = p.member.map_size;
                let _e347 = f32(_e346);
                let _e350 = ((_e208 * _e347) - 0.5f);
                let _e351 = ((_e222 * _e347) - 0.5f);
                if (_e350 > -8388608f) {
                    let _e363 = f32(select(0i, select(select(i32(_e350), i32(-2147483648), (_e350 < bitcast<f32>(3472883712u))), 2147483647i, (_e350 > bitcast<f32>(1325400063u))), (_e350 == _e350)));
                    if (_e363 > _e350) {
                        phi_474_ = 1f;
                    } else {
                        phi_474_ = 0f;
                    }
                    let _e366 = phi_474_;
                    if (_e350 < 8388608f) {
                        phi_479_ = (_e363 - _e366);
                        phi_480_ = false;
                    } else {
                        phi_479_ = f32();
                        phi_480_ = true;
                    }
                    let _e369 = phi_479_;
                    let _e371 = phi_480_;
                    phi_481_ = _e369;
                    phi_482_ = _e371;
                } else {
                    phi_481_ = f32();
                    phi_482_ = true;
                }
                let _e373 = phi_481_;
                let _e375 = phi_482_;
                if _e375 {
                    phi_486_ = _e350;
                } else {
                    phi_486_ = _e373;
                }
                let _e377 = phi_486_;
                if (_e351 > -8388608f) {
                    let _e389 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e389 > _e351) {
                        phi_506_ = 1f;
                    } else {
                        phi_506_ = 0f;
                    }
                    let _e392 = phi_506_;
                    if (_e351 < 8388608f) {
                        phi_511_ = (_e389 - _e392);
                        phi_512_ = false;
                    } else {
                        phi_511_ = f32();
                        phi_512_ = true;
                    }
                    let _e395 = phi_511_;
                    let _e397 = phi_512_;
                    phi_513_ = _e395;
                    phi_514_ = _e397;
                } else {
                    phi_513_ = f32();
                    phi_514_ = true;
                }
                let _e399 = phi_513_;
                let _e401 = phi_514_;
                if _e401 {
                    phi_518_ = _e351;
                } else {
                    phi_518_ = _e399;
                }
                let _e403 = phi_518_;
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
                    phi_566_ = _e414;
                } else {
                    phi_566_ = 0i;
                }
                let _e444 = phi_566_;
                if (_e423 > 0i) {
                    phi_571_ = _e423;
                } else {
                    phi_571_ = 0i;
                }
                let _e447 = phi_571_;
                if (_e444 < _e441) {
                    phi_576_ = _e444;
                } else {
                    phi_576_ = _e441;
                }
                let _e450 = phi_576_;
                if (_e447 < _e441) {
                    phi_581_ = _e447;
                } else {
                    phi_581_ = _e441;
                }
                let _e453 = phi_581_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e414 + 1i);
                let _e457 = (_e423 + 1i);
                if (_e456 > 0i) {
                    phi_590_ = _e456;
                } else {
                    phi_590_ = 0i;
                }
                let _e460 = phi_590_;
                if (_e457 > 0i) {
                    phi_595_ = _e457;
                } else {
                    phi_595_ = 0i;
                }
                let _e463 = phi_595_;
                if (_e460 < _e441) {
                    phi_600_ = _e460;
                } else {
                    phi_600_ = _e441;
                }
                let _e466 = phi_600_;
                if (_e463 < _e441) {
                    phi_605_ = _e463;
                } else {
                    phi_605_ = _e441;
                }
                let _e469 = phi_605_;
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
                phi_650_ = evaluate_Verdict(_e499, false);
                phi_651_ = evaluate_Verdict();
                phi_652_ = false;
            } else {
                phi_650_ = evaluate_Verdict();
                phi_651_ = evaluate_Verdict(1f, false);
                phi_652_ = true;
            }
            let _e503 = phi_650_;
            let _e505 = phi_651_;
            let _e507 = phi_652_;
            phi_653_ = _e505;
            phi_654_ = _e503;
            phi_655_ = _e507;
        }
        let _e509 = phi_653_;
        let _e511 = phi_654_;
        let _e513 = phi_655_;
        if _e513 {
            phi_659_ = _e509;
        } else {
            phi_659_ = _e511;
        }
        let _e515 = phi_659_;
        if (_e50.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e50.first_primitive)] = _e515.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_vsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
