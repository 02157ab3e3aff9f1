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

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_39 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_33;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_39;
@group(0) @binding(2) 
var<storage> map: type_29;

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
        let _e52 = phi_146_;
        let _e54 = phi_147_;
        phi_148_ = _e52;
        phi_149_ = _e54;
    } else {
        phi_148_ = lt_bvh_traverse_Tree();
        phi_149_ = true;
    }
    let _e56 = phi_148_;
    let _e58 = phi_149_;
    if _e58 {
        phi_154_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_154_ = _e56;
    }
    let _e63 = phi_154_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_203_: f32;
    var phi_204_: f32;
    var phi_205_: f32;
    var phi_211_: bool;
    var phi_233_: f32;
    var phi_234_: f32;
    var phi_235_: f32;
    var phi_236_: f32;
    var phi_237_: bool;
    var phi_238_: f32;
    var phi_239_: bool;
    var phi_277_: vec2<f32>;
    var phi_311_: f32;
    var phi_312_: f32;
    var phi_313_: f32;
    var phi_342_: f32;
    var phi_343_: f32;
    var phi_344_: f32;
    var phi_348_: f32;
    var phi_349_: f32;
    var phi_350_: f32;
    var phi_351_: f32;

    let _e42 = (*param_4);
    let _e43 = (1f - _e42);
    let _e52 = (0.5f * _e42);
    let _e53 = ((param_5.x * _e43) + _e52);
    let _e54 = ((param_5.y * _e43) + _e52);
    let _e56 = ((param_5.w * _e43) + _e52);
    let _e58 = (_e54 - (_e53 * _e53));
    let _e60 = (((param_5.z * _e43) + _e52) - (_e53 * _e54));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_205_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_204_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_203_ = 1f;
            } else {
                phi_203_ = param_6;
            }
            let _e72 = phi_203_;
            phi_204_ = _e72;
        }
        let _e74 = phi_204_;
        phi_205_ = _e74;
    }
    let _e76 = phi_205_;
    if (_e53 == _e56) {
        phi_211_ = (_e53 > 0.5f);
    } else {
        phi_211_ = false;
    }
    let _e80 = phi_211_;
    if _e80 {
        if (_e76 > 0f) {
            if ((bitcast<u32>(_e53) & 2147483647u) > 2139095040u) {
                phi_235_ = _e53;
            } else {
                if (_e53 < 0f) {
                    phi_234_ = 0f;
                } else {
                    if (_e53 > 1f) {
                        phi_233_ = 1f;
                    } else {
                        phi_233_ = _e53;
                    }
                    let _e88 = phi_233_;
                    phi_234_ = _e88;
                }
                let _e90 = phi_234_;
                phi_235_ = _e90;
            }
            let _e92 = phi_235_;
            phi_236_ = _e92;
            phi_237_ = false;
        } else {
            phi_236_ = f32();
            phi_237_ = true;
        }
        let _e94 = phi_236_;
        let _e96 = phi_237_;
        phi_238_ = _e94;
        phi_239_ = _e96;
    } else {
        phi_238_ = f32();
        phi_239_ = true;
    }
    let _e98 = phi_238_;
    let _e100 = phi_239_;
    if _e100 {
        let _e101 = (_e60 / _e58);
        let _e102 = (_e76 - _e53);
        let _e108 = (((((_e76 * _e76) - _e54) - (_e101 * _e102)) * _e58) / (((_e56 - (_e54 * _e54)) * _e58) - (_e60 * _e60)));
        let _e111 = ((_e102 / _e58) - (_e101 * _e108));
        let _e117 = ((0.5f * _e111) / _e108);
        let _e120 = ((_e117 * _e117) - (((1f - (_e111 * _e53)) - (_e108 * _e54)) / _e108));
        if (_e120 >= 0f) {
            let _e122 = sqrt(_e120);
            phi_277_ = vec2<f32>((-(_e117) - _e122), (-(_e117) + _e122));
        } else {
            phi_277_ = vec2(bitcast<f32>((bitcast<u32>(_e120) | 2143289344u)));
        }
        let _e133 = phi_277_;
        if (_e76 <= _e133.x) {
            phi_350_ = 1f;
        } else {
            if (_e76 > _e133.y) {
                let _e146 = (((_e54 - (_e53 * (_e133.x + _e133.y))) + (_e133.x * _e133.y)) / ((_e76 - _e133.x) * (_e76 - _e133.y)));
                if ((bitcast<u32>(_e146) & 2147483647u) > 2139095040u) {
                    phi_313_ = _e146;
                } else {
                    if (_e146 < 0f) {
                        phi_312_ = 0f;
                    } else {
                        if (_e146 > 1f) {
                            phi_311_ = 1f;
                        } else {
                            phi_311_ = _e146;
                        }
                        let _e153 = phi_311_;
                        phi_312_ = _e153;
                    }
                    let _e155 = phi_312_;
                    phi_313_ = _e155;
                }
                let _e157 = phi_313_;
                phi_349_ = _e157;
            } else {
                if (_e76 > _e133.x) {
                    let _e168 = (1f - (((_e54 - (_e53 * (_e76 + _e133.y))) + (_e76 * _e133.y)) / ((_e133.x - _e76) * (_e133.x - _e133.y))));
                    if ((bitcast<u32>(_e168) & 2147483647u) > 2139095040u) {
                        phi_344_ = _e168;
                    } else {
                        if (_e168 < 0f) {
                            phi_343_ = 0f;
                        } else {
                            if (_e168 > 1f) {
                                phi_342_ = 1f;
                            } else {
                                phi_342_ = _e168;
                            }
                            let _e175 = phi_342_;
                            phi_343_ = _e175;
                        }
                        let _e177 = phi_343_;
                        phi_344_ = _e177;
                    }
                    let _e179 = phi_344_;
                    phi_348_ = _e179;
                } else {
                    phi_348_ = bitcast<f32>((bitcast<u32>(_e133.x) | 2143289344u));
                }
                let _e184 = phi_348_;
                phi_349_ = _e184;
            }
            let _e186 = phi_349_;
            phi_350_ = _e186;
        }
        let _e188 = phi_350_;
        phi_351_ = _e188;
    } else {
        phi_351_ = _e98;
    }
    let _e190 = phi_351_;
    return _e190;
}

fn function_() {
    var local: f32;
    var phi_412_: bool;
    var phi_413_: bool;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_419_: bool;
    var phi_463_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_467_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_487_: lt_math_LightPoint;
    var phi_490_: u32;
    var phi_492_: lt_math_LevelPoint;
    var phi_578_: bool;
    var phi_587_: bool;
    var phi_596_: bool;
    var phi_597_: bool;
    var phi_598_: bool;
    var phi_599_: bool;
    var phi_600_: bool;
    var phi_601_: bool;
    var phi_602_: bool;
    var phi_606_: bool;
    var phi_633_: bool;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_636_: bool;
    var phi_637_: bool;
    var phi_638_: bool;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_644_: bool;
    var phi_653_: lt_math_LightPoint;
    var phi_654_: u32;
    var phi_655_: lt_math_LevelPoint;
    var phi_656_: bool;
    var phi_488_: lt_math_LightPoint;
    var phi_491_: u32;
    var phi_493_: lt_math_LevelPoint;
    var phi_657_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_697_: bool;
    var phi_698_: bool;
    var phi_699_: bool;
    var phi_700_: bool;
    var phi_704_: bool;
    var phi_786_: f32;
    var phi_902_: f32;
    var phi_903_: f32;
    var phi_906_: f32;
    var phi_935_: f32;
    var phi_940_: f32;
    var phi_941_: bool;
    var phi_942_: f32;
    var phi_943_: bool;
    var phi_947_: f32;
    var phi_967_: f32;
    var phi_972_: f32;
    var phi_973_: bool;
    var phi_974_: f32;
    var phi_975_: bool;
    var phi_979_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1028_: i32;
    var phi_1033_: i32;
    var phi_1038_: i32;
    var phi_1043_: i32;
    var phi_1052_: i32;
    var phi_1057_: i32;
    var phi_1062_: i32;
    var phi_1067_: i32;
    var phi_1162_: bool;
    var phi_1170_: bool;
    var phi_1182_: bool;
    var phi_1183_: bool;
    var phi_1187_: f32;
    var phi_1193_: f32;
    var phi_1195_: evaluate_Verdict;
    var phi_1200_: evaluate_Verdict;
    var phi_1201_: evaluate_Verdict;

    let _e40 = id_1;
    let _e47 = arrayLength((&map.member));
    let _e53 = arrayLength((&levels.member));
    let _e56 = p.member.size[0u];
    let _e58 = p.member.size[1u];
    let _e59 = lt_shaders_entry_pixel_index(_e40, _e56, _e58);
    if (bitcast<i32>(_e59.root) != 0i) {
        let _e65 = p.member.level_count;
        if (_e59.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e70 = p.member.light;
        let _e73 = samples.member[(0u + _e59.first_primitive)].normal[0u];
        let _e75 = global[0u];
        if (_e73 == _e75) {
            let _e78 = samples.member[(0u + _e59.first_primitive)].normal[1u];
            let _e80 = global[1u];
            if (_e78 == _e80) {
                let _e83 = samples.member[(0u + _e59.first_primitive)].normal[2u];
                let _e85 = global[2u];
                phi_412_ = (_e83 == _e85);
                phi_413_ = false;
            } else {
                phi_412_ = bool();
                phi_413_ = true;
            }
            let _e88 = phi_412_;
            let _e90 = phi_413_;
            phi_414_ = _e88;
            phi_415_ = _e90;
        } else {
            phi_414_ = bool();
            phi_415_ = true;
        }
        let _e92 = phi_414_;
        let _e94 = phi_415_;
        if _e94 {
            phi_419_ = false;
        } else {
            phi_419_ = _e92;
        }
        let _e96 = phi_419_;
        if !(_e96) {
            let _e99 = samples.member[(0u + _e59.first_primitive)].normal;
            let _e101 = samples.member[(0u + _e59.first_primitive)].position;
            if ((((_e99.x * (_e70.x - (_e101.x * _e70.w))) + (_e99.y * (_e70.y - (_e101.y * _e70.w)))) + (_e99.z * (_e70.z - (_e101.z * _e70.w)))) > 0f) {
                let _e125 = samples.member[(0u + _e59.first_primitive)].flags;
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e133.unnamed.visibility, false), _e133.unnamed_1);
                phi_463_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e139.unnamed, ((_e125 & 1u) == 0u));
            } else {
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e148.unnamed.visibility, false), _e148.unnamed_1);
                phi_463_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e154.unnamed, true);
            }
            let _e159 = phi_463_;
            phi_467_ = _e159;
        } else {
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e165.unnamed.visibility, false), _e165.unnamed_1);
            phi_467_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e171.unnamed, true);
        }
        let _e176 = phi_467_;
        if _e176.unnamed_1 {
            phi_1201_ = evaluate_Verdict(_e176.unnamed.visibility, _e176.unnamed.is_doubted);
        } else {
            let _e184 = samples.member[(0u + _e59.first_primitive)].position;
            let _e186 = p.member.map_size;
            let _e188 = (0.5f / f32(_e186));
            let _e195 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e202 = lt_math_LightPoint(vec2<f32>(_e195.uv.x, 0f), _e195.depth, _e195.is_inside);
            let _e206 = lt_math_LightPoint(_e202.uv, 0f, _e202.is_inside);
            phi_487_ = lt_math_LightPoint();
            phi_490_ = 0u;
            phi_492_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e206.uv, _e206.depth, false));
            loop {
                let _e213 = phi_487_;
                let _e215 = phi_490_;
                let _e217 = phi_492_;
                local_1 = _e217;
                local_2 = _e217;
                local_3 = _e217;
                if (_e215 < _e65) {
                    if _e217.point.is_inside {
                        phi_653_ = lt_math_LightPoint();
                        phi_654_ = u32();
                        phi_655_ = lt_math_LevelPoint();
                        phi_656_ = false;
                    } else {
                        if (_e215 < _e53) {
                        } else {
                            return;
                        }
                        let _e228 = levels.member[(0u + _e215)].row_w;
                        let _e239 = ((((_e228.x * _e184.x) + (_e228.y * _e184.y)) + (_e228.z * _e184.z)) + (_e228.w * 1f));
                        let _e241 = levels.member[(0u + _e215)].row_x;
                        let _e253 = (((((_e241.x * _e184.x) + (_e241.y * _e184.y)) + (_e241.z * _e184.z)) + (_e241.w * 1f)) / _e239);
                        let _e255 = levels.member[(0u + _e215)].row_y;
                        let _e267 = (((((_e255.x * _e184.x) + (_e255.y * _e184.y)) + (_e255.z * _e184.z)) + (_e255.w * 1f)) / _e239);
                        let _e269 = levels.member[(0u + _e215)].row_z;
                        let _e280 = ((((_e269.x * _e184.x) + (_e269.y * _e184.y)) + (_e269.z * _e184.z)) + (_e269.w * 1f));
                        if (_e239 > 0f) {
                            if (_e253 >= 0f) {
                                phi_578_ = (_e253 <= 1f);
                            } else {
                                phi_578_ = false;
                            }
                            let _e285 = phi_578_;
                            if _e285 {
                                if (_e267 >= 0f) {
                                    phi_587_ = (_e267 <= 1f);
                                } else {
                                    phi_587_ = false;
                                }
                                let _e289 = phi_587_;
                                if _e289 {
                                    if (_e280 >= 0f) {
                                        phi_596_ = (_e280 <= 1f);
                                    } else {
                                        phi_596_ = false;
                                    }
                                    let _e293 = phi_596_;
                                    phi_597_ = _e293;
                                    phi_598_ = false;
                                } else {
                                    phi_597_ = bool();
                                    phi_598_ = true;
                                }
                                let _e295 = phi_597_;
                                let _e297 = phi_598_;
                                phi_599_ = _e295;
                                phi_600_ = _e297;
                            } else {
                                phi_599_ = bool();
                                phi_600_ = true;
                            }
                            let _e299 = phi_599_;
                            let _e301 = phi_600_;
                            phi_601_ = _e299;
                            phi_602_ = _e301;
                        } else {
                            phi_601_ = bool();
                            phi_602_ = true;
                        }
                        let _e303 = phi_601_;
                        let _e305 = phi_602_;
                        if _e305 {
                            phi_606_ = false;
                        } else {
                            phi_606_ = _e303;
                        }
                        let _e307 = phi_606_;
                        if _e307 {
                            if (_e253 >= _e188) {
                                if (_e253 <= (1f - _e188)) {
                                    if (_e267 >= _e188) {
                                        phi_633_ = (_e267 <= (1f - _e188));
                                        phi_634_ = false;
                                    } else {
                                        phi_633_ = bool();
                                        phi_634_ = true;
                                    }
                                    let _e315 = phi_633_;
                                    let _e317 = phi_634_;
                                    phi_635_ = _e315;
                                    phi_636_ = _e317;
                                } else {
                                    phi_635_ = bool();
                                    phi_636_ = true;
                                }
                                let _e319 = phi_635_;
                                let _e321 = phi_636_;
                                phi_637_ = _e319;
                                phi_638_ = _e321;
                            } else {
                                phi_637_ = bool();
                                phi_638_ = true;
                            }
                            let _e323 = phi_637_;
                            let _e325 = phi_638_;
                            phi_639_ = _e323;
                            phi_640_ = _e325;
                        } else {
                            phi_639_ = bool();
                            phi_640_ = true;
                        }
                        let _e327 = phi_639_;
                        let _e329 = phi_640_;
                        if _e329 {
                            phi_644_ = false;
                        } else {
                            phi_644_ = _e327;
                        }
                        let _e331 = phi_644_;
                        let _e338 = lt_math_LightPoint(vec2<f32>(_e253, _e213.uv.y), _e213.depth, _e213.is_inside);
                        let _e345 = lt_math_LightPoint(vec2<f32>(_e338.uv.x, _e267), _e338.depth, _e338.is_inside);
                        let _e349 = lt_math_LightPoint(_e345.uv, _e280, _e345.is_inside);
                        let _e353 = lt_math_LightPoint(_e349.uv, _e349.depth, _e331);
                        phi_653_ = _e353;
                        phi_654_ = (_e215 + 1u);
                        phi_655_ = lt_math_LevelPoint(_e215, _e353);
                        phi_656_ = true;
                    }
                    let _e357 = phi_653_;
                    let _e359 = phi_654_;
                    let _e361 = phi_655_;
                    let _e363 = phi_656_;
                    phi_488_ = _e357;
                    phi_491_ = _e359;
                    phi_493_ = _e361;
                    phi_657_ = _e363;
                } else {
                    phi_488_ = lt_math_LightPoint();
                    phi_491_ = u32();
                    phi_493_ = lt_math_LevelPoint();
                    phi_657_ = false;
                }
                let _e365 = phi_488_;
                let _e367 = phi_491_;
                let _e369 = phi_493_;
                let _e371 = phi_657_;
                continue;
                continuing {
                    phi_487_ = _e365;
                    phi_490_ = _e367;
                    phi_492_ = _e369;
                    break if !(_e371);
                }
            }
            let _e374 = local_1;
            if _e374.point.is_inside {
                if (0f > 0f) {
                    let _e380 = local_2;
                    if (_e380.level < _e53) {
                    } else {
                        return;
                    }
                    let _e385 = levels.member[(0u + _e380.level)];
                    let _e391 = global[0u];
                    if (_e385.row_w.x == _e391) {
                        let _e394 = global[1u];
                        if (_e385.row_w.y == _e394) {
                            let _e397 = global[2u];
                            phi_697_ = (_e385.row_w.z == _e397);
                            phi_698_ = false;
                        } else {
                            phi_697_ = bool();
                            phi_698_ = true;
                        }
                        let _e400 = phi_697_;
                        let _e402 = phi_698_;
                        phi_699_ = _e400;
                        phi_700_ = _e402;
                    } else {
                        phi_699_ = bool();
                        phi_700_ = true;
                    }
                    let _e404 = phi_699_;
                    let _e406 = phi_700_;
                    if _e406 {
                        phi_704_ = false;
                    } else {
                        phi_704_ = _e404;
                    }
                    let _e408 = phi_704_;
                    if _e408 {
                        let _e410 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e412 = p.member.map_size;
                        let _e482 = ((abs(((((_e385.row_x.x * _e410.x) + (_e385.row_x.y * _e410.y)) + (_e385.row_x.z * _e410.z)) / (((_e385.row_x.x * _e385.row_x.x) + (_e385.row_x.y * _e385.row_x.y)) + (_e385.row_x.z * _e385.row_x.z)))) + abs(((((_e385.row_y.x * _e410.x) + (_e385.row_y.y * _e410.y)) + (_e385.row_y.z * _e410.z)) / (((_e385.row_y.x * _e385.row_y.x) + (_e385.row_y.y * _e385.row_y.y)) + (_e385.row_y.z * _e385.row_y.z))))) / (abs(((((_e385.row_z.x * _e410.x) + (_e385.row_z.y * _e410.y)) + (_e385.row_z.z * _e410.z)) / (((_e385.row_z.x * _e385.row_z.x) + (_e385.row_z.y * _e385.row_z.y)) + (_e385.row_z.z * _e385.row_z.z)))) * f32(_e412)));
                        if (_e482 < 0.002f) {
                            phi_786_ = _e482;
                        } else {
                            phi_786_ = 0.002f;
                        }
                        let _e485 = phi_786_;
                        phi_903_ = _e485;
                    } else {
                        let _e487 = p.member.map_size;
                        let _e493 = samples.member[(0u + _e59.first_primitive)].position;
                        let _e504 = ((((_e385.row_w.x * _e493.x) + (_e385.row_w.y * _e493.y)) + (_e385.row_w.z * _e493.z)) + _e385.row_w.w);
                        let _e517 = ((_e385.row_x.x - (_e385.row_w.x * _e374.point.uv.x)) / _e504);
                        let _e518 = ((_e385.row_x.y - (_e385.row_w.y * _e374.point.uv.x)) / _e504);
                        let _e519 = ((_e385.row_x.z - (_e385.row_w.z * _e374.point.uv.x)) / _e504);
                        let _e532 = ((_e385.row_y.x - (_e385.row_w.x * _e374.point.uv.y)) / _e504);
                        let _e533 = ((_e385.row_y.y - (_e385.row_w.y * _e374.point.uv.y)) / _e504);
                        let _e534 = ((_e385.row_y.z - (_e385.row_w.z * _e374.point.uv.y)) / _e504);
                        let _e540 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e545 = ((_e533 * _e540.z) - (_e540.y * _e534));
                        let _e550 = ((_e534 * _e540.x) - (_e540.z * _e532));
                        let _e555 = ((_e532 * _e540.y) - (_e540.x * _e533));
                        let _e557 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e562 = ((_e518 * _e557.z) - (_e557.y * _e519));
                        let _e567 = ((_e519 * _e557.x) - (_e557.z * _e517));
                        let _e572 = ((_e517 * _e557.y) - (_e557.x * _e518));
                        let _e599 = ((abs(((((_e385.row_z.x * _e545) + (_e385.row_z.y * _e550)) + (_e385.row_z.z * _e555)) / (((_e517 * _e545) + (_e518 * _e550)) + (_e519 * _e555)))) + abs(((((_e385.row_z.x * _e562) + (_e385.row_z.y * _e567)) + (_e385.row_z.z * _e572)) / (((_e532 * _e562) + (_e533 * _e567)) + (_e534 * _e572))))) / f32(_e487));
                        if (_e599 < 0.002f) {
                            phi_902_ = _e599;
                        } else {
                            phi_902_ = 0.002f;
                        }
                        let _e602 = phi_902_;
                        phi_903_ = _e602;
                    }
                    let _e604 = phi_903_;
                    phi_906_ = (_e374.point.depth - (0f * _e604));
                } else {
                    phi_906_ = _e374.point.depth;
                }
                let _e608 = phi_906_;
                let _e614 = p.member.map_size;
                let _e615 = f32(_e614);
                let _e618 = ((_e374.point.uv.x * _e615) - 0.5f);
                let _e619 = ((_e374.point.uv.y * _e615) - 0.5f);
                if (_e618 > -8388608f) {
                    let _e631 = f32(select(0i, select(select(i32(_e618), i32(-2147483648), (_e618 < bitcast<f32>(3472883712u))), 2147483647i, (_e618 > bitcast<f32>(1325400063u))), (_e618 == _e618)));
                    if (_e631 > _e618) {
                        phi_935_ = 1f;
                    } else {
                        phi_935_ = 0f;
                    }
                    let _e634 = phi_935_;
                    if (_e618 < 8388608f) {
                        phi_940_ = (_e631 - _e634);
                        phi_941_ = false;
                    } else {
                        phi_940_ = f32();
                        phi_941_ = true;
                    }
                    let _e637 = phi_940_;
                    let _e639 = phi_941_;
                    phi_942_ = _e637;
                    phi_943_ = _e639;
                } else {
                    phi_942_ = f32();
                    phi_943_ = true;
                }
                let _e641 = phi_942_;
                let _e643 = phi_943_;
                if _e643 {
                    phi_947_ = _e618;
                } else {
                    phi_947_ = _e641;
                }
                let _e645 = phi_947_;
                if (_e619 > -8388608f) {
                    let _e657 = f32(select(0i, select(select(i32(_e619), i32(-2147483648), (_e619 < bitcast<f32>(3472883712u))), 2147483647i, (_e619 > bitcast<f32>(1325400063u))), (_e619 == _e619)));
                    if (_e657 > _e619) {
                        phi_967_ = 1f;
                    } else {
                        phi_967_ = 0f;
                    }
                    let _e660 = phi_967_;
                    if (_e619 < 8388608f) {
                        phi_972_ = (_e657 - _e660);
                        phi_973_ = false;
                    } else {
                        phi_972_ = f32();
                        phi_973_ = true;
                    }
                    let _e663 = phi_972_;
                    let _e665 = phi_973_;
                    phi_974_ = _e663;
                    phi_975_ = _e665;
                } else {
                    phi_974_ = f32();
                    phi_975_ = true;
                }
                let _e667 = phi_974_;
                let _e669 = phi_975_;
                if _e669 {
                    phi_979_ = _e619;
                } else {
                    phi_979_ = _e667;
                }
                let _e671 = phi_979_;
                let _e672 = (_e618 - _e645);
                let _e673 = (_e619 - _e671);
                let _e682 = select(0i, select(select(i32(_e645), i32(-2147483648), (_e645 < bitcast<f32>(3472883712u))), 2147483647i, (_e645 > bitcast<f32>(1325400063u))), (_e645 == _e645));
                let _e691 = select(0i, select(select(i32(_e671), i32(-2147483648), (_e671 < bitcast<f32>(3472883712u))), 2147483647i, (_e671 > bitcast<f32>(1325400063u))), (_e671 == _e671));
                let _e694 = ((1f - _e672) * (1f - _e673));
                let _e696 = (_e672 * (1f - _e673));
                let _e698 = ((1f - _e672) * _e673);
                let _e699 = (_e672 * _e673);
                let _e701 = p.member.test;
                let _e702 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e701);
                let _e704 = p.member.map_size;
                let _e706 = local_3;
                local = _e702;
                let _e709 = ((_e706.level * _e704) * _e704);
                let _e711 = (bitcast<i32>(_e704) - 1i);
                if (_e682 > 0i) {
                    phi_1028_ = _e682;
                } else {
                    phi_1028_ = 0i;
                }
                let _e714 = phi_1028_;
                if (_e691 > 0i) {
                    phi_1033_ = _e691;
                } else {
                    phi_1033_ = 0i;
                }
                let _e717 = phi_1033_;
                if (_e714 < _e711) {
                    phi_1038_ = _e714;
                } else {
                    phi_1038_ = _e711;
                }
                let _e720 = phi_1038_;
                if (_e717 < _e711) {
                    phi_1043_ = _e717;
                } else {
                    phi_1043_ = _e711;
                }
                let _e723 = phi_1043_;
                let _e724 = bitcast<u32>(_e720);
                let _e726 = (_e682 + 1i);
                let _e727 = (_e691 + 1i);
                if (_e726 > 0i) {
                    phi_1052_ = _e726;
                } else {
                    phi_1052_ = 0i;
                }
                let _e730 = phi_1052_;
                if (_e727 > 0i) {
                    phi_1057_ = _e727;
                } else {
                    phi_1057_ = 0i;
                }
                let _e733 = phi_1057_;
                if (_e730 < _e711) {
                    phi_1062_ = _e730;
                } else {
                    phi_1062_ = _e711;
                }
                let _e736 = phi_1062_;
                if (_e733 < _e711) {
                    phi_1067_ = _e733;
                } else {
                    phi_1067_ = _e711;
                }
                let _e739 = phi_1067_;
                let _e740 = bitcast<u32>(_e736);
                let _e742 = (bitcast<u32>(_e723) * _e704);
                let _e743 = (bitcast<u32>(_e739) * _e704);
                let _e748 = ((_e742 + _e724) + _e709);
                let _e749 = ((_e742 + _e740) + _e709);
                let _e750 = ((_e743 + _e724) + _e709);
                let _e751 = ((_e743 + _e740) + _e709);
                if (_e748 < _e47) {
                } else {
                    return;
                }
                let _e755 = map.member[(0u + _e748)];
                if (_e749 < _e47) {
                } else {
                    return;
                }
                let _e767 = map.member[(0u + _e749)];
                if (_e750 < _e47) {
                } else {
                    return;
                }
                let _e783 = map.member[(0u + _e750)];
                if (_e751 < _e47) {
                } else {
                    return;
                }
                let _e799 = map.member[(0u + _e751)];
                let _e813 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e755.x * _e694) + (_e767.x * _e696)) + (_e783.x * _e698)) + (_e799.x * _e699)), ((((_e755.y * _e694) + (_e767.y * _e696)) + (_e783.y * _e698)) + (_e799.y * _e699)), ((((_e755.z * _e694) + (_e767.z * _e696)) + (_e783.z * _e698)) + (_e799.z * _e699)), ((((_e755.w * _e694) + (_e767.w * _e696)) + (_e783.w * _e698)) + (_e799.w * _e699))), _e608);
                let _e815 = p.member.epsilon;
                if (_e813 <= _e815) {
                    phi_1162_ = true;
                } else {
                    phi_1162_ = (_e813 >= (1f - _e815));
                }
                let _e820 = phi_1162_;
                if ((bitcast<u32>(_e813) & 2147483647u) > 2139095040u) {
                    phi_1170_ = true;
                } else {
                    phi_1170_ = !(_e820);
                }
                let _e826 = phi_1170_;
                if _e826 {
                    if (_e813 > 0f) {
                        if (_e813 < 1f) {
                            phi_1182_ = false;
                        } else {
                            phi_1182_ = true;
                        }
                        let _e830 = phi_1182_;
                        phi_1183_ = _e830;
                    } else {
                        phi_1183_ = true;
                    }
                    let _e832 = phi_1183_;
                    if _e832 {
                        phi_1187_ = 0.5f;
                    } else {
                        phi_1187_ = _e813;
                    }
                    let _e834 = phi_1187_;
                    phi_1195_ = evaluate_Verdict(_e834, true);
                } else {
                    if (_e813 > 0.5f) {
                        phi_1193_ = 1f;
                    } else {
                        phi_1193_ = 0f;
                    }
                    let _e838 = phi_1193_;
                    phi_1195_ = evaluate_Verdict(_e838, false);
                }
                let _e841 = phi_1195_;
                phi_1200_ = evaluate_Verdict(_e841.visibility, _e841.is_doubted);
            } else {
                phi_1200_ = evaluate_Verdict(0.5f, true);
            }
            let _e847 = phi_1200_;
            phi_1201_ = _e847;
        }
        let _e849 = phi_1201_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e849.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
