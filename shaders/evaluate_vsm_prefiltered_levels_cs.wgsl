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
        let _e53 = phi_145_;
        let _e55 = phi_146_;
        phi_147_ = _e53;
        phi_148_ = _e55;
    } else {
        phi_147_ = lt_bvh_traverse_Tree();
        phi_148_ = true;
    }
    let _e57 = phi_147_;
    let _e59 = phi_148_;
    if _e59 {
        phi_153_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_153_ = _e57;
    }
    let _e64 = phi_153_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_4: f32, param_5: f32) -> f32 {
    var phi_167_: f32;

    if (param_4 < param_5) {
        phi_167_ = param_4;
    } else {
        phi_167_ = param_5;
    }
    let _e44 = phi_167_;
    return _e44;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_186_: f32;
    var phi_187_: f32;
    var phi_188_: f32;
    var phi_206_: bool;
    var phi_210_: f32;
    var phi_222_: bool;
    var phi_229_: f32;
    var phi_244_: f32;
    var phi_245_: f32;
    var phi_246_: f32;

    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_188_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_187_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_186_ = 1f;
            } else {
                phi_186_ = param_8;
            }
            let _e49 = phi_186_;
            phi_187_ = _e49;
        }
        let _e51 = phi_187_;
        phi_188_ = _e51;
    }
    let _e53 = phi_188_;
    let _e56 = (*param_6);
    let _e60 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e56) & 2147483647u) > 2139095040u) {
        phi_206_ = true;
    } else {
        let _e64 = (_e56 > _e60);
        if _e64 {
        }
        phi_206_ = _e64;
    }
    let _e66 = phi_206_;
    if _e66 {
        phi_210_ = _e56;
    } else {
        phi_210_ = _e60;
    }
    let _e68 = phi_210_;
    let _e69 = (_e53 - param_7.x);
    if (_e69 <= 0f) {
        let _e73 = ((bitcast<u32>(_e68) & 2147483647u) > 2139095040u);
        if _e73 {
        }
        phi_222_ = _e73;
    } else {
        phi_222_ = true;
    }
    let _e75 = phi_222_;
    if _e75 {
        phi_229_ = (_e68 / (_e68 + (_e69 * _e69)));
    } else {
        phi_229_ = 1f;
    }
    let _e80 = phi_229_;
    if ((bitcast<u32>(_e80) & 2147483647u) > 2139095040u) {
        phi_246_ = _e80;
    } else {
        if (_e80 < 0f) {
            phi_245_ = 0f;
        } else {
            if (_e80 > 1f) {
                phi_244_ = 1f;
            } else {
                phi_244_ = _e80;
            }
            let _e87 = phi_244_;
            phi_245_ = _e87;
        }
        let _e89 = phi_245_;
        phi_246_ = _e89;
    }
    let _e91 = phi_246_;
    return _e91;
}

fn function_() {
    var local: f32;
    var phi_307_: bool;
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_314_: bool;
    var phi_358_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_362_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_382_: lt_math_LightPoint;
    var phi_385_: u32;
    var phi_387_: lt_math_LevelPoint;
    var phi_473_: bool;
    var phi_482_: bool;
    var phi_491_: bool;
    var phi_492_: bool;
    var phi_493_: bool;
    var phi_494_: bool;
    var phi_495_: bool;
    var phi_496_: bool;
    var phi_497_: bool;
    var phi_501_: bool;
    var phi_528_: bool;
    var phi_529_: bool;
    var phi_530_: bool;
    var phi_531_: bool;
    var phi_532_: bool;
    var phi_533_: bool;
    var phi_534_: bool;
    var phi_535_: bool;
    var phi_539_: bool;
    var phi_548_: lt_math_LightPoint;
    var phi_549_: u32;
    var phi_550_: lt_math_LevelPoint;
    var phi_551_: bool;
    var phi_383_: lt_math_LightPoint;
    var phi_386_: u32;
    var phi_388_: lt_math_LevelPoint;
    var phi_552_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_592_: bool;
    var phi_593_: bool;
    var phi_594_: bool;
    var phi_595_: bool;
    var phi_599_: bool;
    var phi_681_: f32;
    var phi_797_: f32;
    var phi_798_: f32;
    var phi_801_: f32;
    var phi_830_: f32;
    var phi_835_: f32;
    var phi_836_: bool;
    var phi_837_: f32;
    var phi_838_: bool;
    var phi_842_: f32;
    var phi_862_: f32;
    var phi_867_: f32;
    var phi_868_: bool;
    var phi_869_: f32;
    var phi_870_: bool;
    var phi_874_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_923_: i32;
    var phi_928_: i32;
    var phi_933_: i32;
    var phi_938_: i32;
    var phi_947_: i32;
    var phi_952_: i32;
    var phi_957_: i32;
    var phi_962_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1078_: f32;
    var phi_1080_: evaluate_Verdict;
    var phi_1081_: bool;
    var phi_1082_: evaluate_Verdict;
    var phi_1083_: bool;
    var phi_1088_: evaluate_Verdict;
    var phi_1089_: bool;
    var phi_1091_: evaluate_Verdict;
    var phi_1092_: evaluate_Verdict;
    var phi_1093_: bool;
    var phi_1097_: evaluate_Verdict;
    var phi_1098_: evaluate_Verdict;
    var phi_1099_: bool;
    var phi_1103_: evaluate_Verdict;

    let _e41 = id_1;
    let _e48 = arrayLength((&map.member));
    let _e54 = arrayLength((&levels.member));
    let _e57 = p.member.size[0u];
    let _e59 = p.member.size[1u];
    let _e60 = lt_shaders_entry_pixel_index(_e41, _e57, _e59);
    if (bitcast<i32>(_e60.root) != 0i) {
        let _e66 = p.member.level_count;
        if (_e60.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e71 = p.member.light;
        let _e74 = samples.member[(0u + _e60.first_primitive)].normal[0u];
        let _e76 = global[0u];
        if (_e74 == _e76) {
            let _e79 = samples.member[(0u + _e60.first_primitive)].normal[1u];
            let _e81 = global[1u];
            if (_e79 == _e81) {
                let _e84 = samples.member[(0u + _e60.first_primitive)].normal[2u];
                let _e86 = global[2u];
                phi_307_ = (_e84 == _e86);
                phi_308_ = false;
            } else {
                phi_307_ = bool();
                phi_308_ = true;
            }
            let _e89 = phi_307_;
            let _e91 = phi_308_;
            phi_309_ = _e89;
            phi_310_ = _e91;
        } else {
            phi_309_ = bool();
            phi_310_ = true;
        }
        let _e93 = phi_309_;
        let _e95 = phi_310_;
        if _e95 {
            phi_314_ = false;
        } else {
            phi_314_ = _e93;
        }
        let _e97 = phi_314_;
        if !(_e97) {
            let _e100 = samples.member[(0u + _e60.first_primitive)].normal;
            let _e102 = samples.member[(0u + _e60.first_primitive)].position;
            if ((((_e100.x * (_e71.x - (_e102.x * _e71.w))) + (_e100.y * (_e71.y - (_e102.y * _e71.w)))) + (_e100.z * (_e71.z - (_e102.z * _e71.w)))) > 0f) {
                let _e126 = samples.member[(0u + _e60.first_primitive)].flags;
                let _e134 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e134.unnamed.visibility, false), _e134.unnamed_1);
                phi_358_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e140.unnamed, ((_e126 & 1u) == 0u));
            } else {
                let _e149 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e149.unnamed.visibility, false), _e149.unnamed_1);
                phi_358_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e155.unnamed, true);
            }
            let _e160 = phi_358_;
            phi_362_ = _e160;
        } else {
            let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e166.unnamed.visibility, false), _e166.unnamed_1);
            phi_362_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e172.unnamed, true);
        }
        let _e177 = phi_362_;
        if _e177.unnamed_1 {
            phi_1097_ = evaluate_Verdict(_e177.unnamed.visibility, _e177.unnamed.is_doubted);
            phi_1098_ = evaluate_Verdict();
            phi_1099_ = true;
        } else {
            let _e185 = samples.member[(0u + _e60.first_primitive)].position;
            let _e187 = p.member.map_size;
            let _e189 = (0.5f / f32(_e187));
            let _e196 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e203 = lt_math_LightPoint(vec2<f32>(_e196.uv.x, 0f), _e196.depth, _e196.is_inside);
            let _e207 = lt_math_LightPoint(_e203.uv, 0f, _e203.is_inside);
            phi_382_ = lt_math_LightPoint();
            phi_385_ = 0u;
            phi_387_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e207.uv, _e207.depth, false));
            loop {
                let _e214 = phi_382_;
                let _e216 = phi_385_;
                let _e218 = phi_387_;
                local_1 = _e218;
                local_2 = _e218;
                local_3 = _e218;
                local_4 = _e218;
                if (_e216 < _e66) {
                    if _e218.point.is_inside {
                        phi_548_ = lt_math_LightPoint();
                        phi_549_ = u32();
                        phi_550_ = lt_math_LevelPoint();
                        phi_551_ = false;
                    } else {
                        if (_e216 < _e54) {
                        } else {
                            return;
                        }
                        let _e229 = levels.member[(0u + _e216)].row_w;
                        let _e240 = ((((_e229.x * _e185.x) + (_e229.y * _e185.y)) + (_e229.z * _e185.z)) + (_e229.w * 1f));
                        let _e242 = levels.member[(0u + _e216)].row_x;
                        let _e254 = (((((_e242.x * _e185.x) + (_e242.y * _e185.y)) + (_e242.z * _e185.z)) + (_e242.w * 1f)) / _e240);
                        let _e256 = levels.member[(0u + _e216)].row_y;
                        let _e268 = (((((_e256.x * _e185.x) + (_e256.y * _e185.y)) + (_e256.z * _e185.z)) + (_e256.w * 1f)) / _e240);
                        let _e270 = levels.member[(0u + _e216)].row_z;
                        let _e281 = ((((_e270.x * _e185.x) + (_e270.y * _e185.y)) + (_e270.z * _e185.z)) + (_e270.w * 1f));
                        if (_e240 > 0f) {
                            if (_e254 >= 0f) {
                                phi_473_ = (_e254 <= 1f);
                            } else {
                                phi_473_ = false;
                            }
                            let _e286 = phi_473_;
                            if _e286 {
                                if (_e268 >= 0f) {
                                    phi_482_ = (_e268 <= 1f);
                                } else {
                                    phi_482_ = false;
                                }
                                let _e290 = phi_482_;
                                if _e290 {
                                    if (_e281 >= 0f) {
                                        phi_491_ = (_e281 <= 1f);
                                    } else {
                                        phi_491_ = false;
                                    }
                                    let _e294 = phi_491_;
                                    phi_492_ = _e294;
                                    phi_493_ = false;
                                } else {
                                    phi_492_ = bool();
                                    phi_493_ = true;
                                }
                                let _e296 = phi_492_;
                                let _e298 = phi_493_;
                                phi_494_ = _e296;
                                phi_495_ = _e298;
                            } else {
                                phi_494_ = bool();
                                phi_495_ = true;
                            }
                            let _e300 = phi_494_;
                            let _e302 = phi_495_;
                            phi_496_ = _e300;
                            phi_497_ = _e302;
                        } else {
                            phi_496_ = bool();
                            phi_497_ = true;
                        }
                        let _e304 = phi_496_;
                        let _e306 = phi_497_;
                        if _e306 {
                            phi_501_ = false;
                        } else {
                            phi_501_ = _e304;
                        }
                        let _e308 = phi_501_;
                        if _e308 {
                            if (_e254 >= _e189) {
                                if (_e254 <= (1f - _e189)) {
                                    if (_e268 >= _e189) {
                                        phi_528_ = (_e268 <= (1f - _e189));
                                        phi_529_ = false;
                                    } else {
                                        phi_528_ = bool();
                                        phi_529_ = true;
                                    }
                                    let _e316 = phi_528_;
                                    let _e318 = phi_529_;
                                    phi_530_ = _e316;
                                    phi_531_ = _e318;
                                } else {
                                    phi_530_ = bool();
                                    phi_531_ = true;
                                }
                                let _e320 = phi_530_;
                                let _e322 = phi_531_;
                                phi_532_ = _e320;
                                phi_533_ = _e322;
                            } else {
                                phi_532_ = bool();
                                phi_533_ = true;
                            }
                            let _e324 = phi_532_;
                            let _e326 = phi_533_;
                            phi_534_ = _e324;
                            phi_535_ = _e326;
                        } else {
                            phi_534_ = bool();
                            phi_535_ = true;
                        }
                        let _e328 = phi_534_;
                        let _e330 = phi_535_;
                        if _e330 {
                            phi_539_ = false;
                        } else {
                            phi_539_ = _e328;
                        }
                        let _e332 = phi_539_;
                        let _e339 = lt_math_LightPoint(vec2<f32>(_e254, _e214.uv.y), _e214.depth, _e214.is_inside);
                        let _e346 = lt_math_LightPoint(vec2<f32>(_e339.uv.x, _e268), _e339.depth, _e339.is_inside);
                        let _e350 = lt_math_LightPoint(_e346.uv, _e281, _e346.is_inside);
                        let _e354 = lt_math_LightPoint(_e350.uv, _e350.depth, _e332);
                        phi_548_ = _e354;
                        phi_549_ = (_e216 + 1u);
                        phi_550_ = lt_math_LevelPoint(_e216, _e354);
                        phi_551_ = true;
                    }
                    let _e358 = phi_548_;
                    let _e360 = phi_549_;
                    let _e362 = phi_550_;
                    let _e364 = phi_551_;
                    phi_383_ = _e358;
                    phi_386_ = _e360;
                    phi_388_ = _e362;
                    phi_552_ = _e364;
                } else {
                    phi_383_ = lt_math_LightPoint();
                    phi_386_ = u32();
                    phi_388_ = lt_math_LevelPoint();
                    phi_552_ = false;
                }
                let _e366 = phi_383_;
                let _e368 = phi_386_;
                let _e370 = phi_388_;
                let _e372 = phi_552_;
                continue;
                continuing {
                    phi_382_ = _e366;
                    phi_385_ = _e368;
                    phi_387_ = _e370;
                    break if !(_e372);
                }
            }
            let _e375 = local_1;
            if _e375.point.is_inside {
                if (0f > 0f) {
                    let _e381 = local_2;
                    if (_e381.level < _e54) {
                    } else {
                        return;
                    }
                    let _e386 = levels.member[(0u + _e381.level)];
                    let _e392 = global[0u];
                    if (_e386.row_w.x == _e392) {
                        let _e395 = global[1u];
                        if (_e386.row_w.y == _e395) {
                            let _e398 = global[2u];
                            phi_592_ = (_e386.row_w.z == _e398);
                            phi_593_ = false;
                        } else {
                            phi_592_ = bool();
                            phi_593_ = true;
                        }
                        let _e401 = phi_592_;
                        let _e403 = phi_593_;
                        phi_594_ = _e401;
                        phi_595_ = _e403;
                    } else {
                        phi_594_ = bool();
                        phi_595_ = true;
                    }
                    let _e405 = phi_594_;
                    let _e407 = phi_595_;
                    if _e407 {
                        phi_599_ = false;
                    } else {
                        phi_599_ = _e405;
                    }
                    let _e409 = phi_599_;
                    if _e409 {
                        let _e411 = samples.member[(0u + _e60.first_primitive)].normal;
                        let _e413 = p.member.map_size;
                        let _e483 = ((abs(((((_e386.row_x.x * _e411.x) + (_e386.row_x.y * _e411.y)) + (_e386.row_x.z * _e411.z)) / (((_e386.row_x.x * _e386.row_x.x) + (_e386.row_x.y * _e386.row_x.y)) + (_e386.row_x.z * _e386.row_x.z)))) + abs(((((_e386.row_y.x * _e411.x) + (_e386.row_y.y * _e411.y)) + (_e386.row_y.z * _e411.z)) / (((_e386.row_y.x * _e386.row_y.x) + (_e386.row_y.y * _e386.row_y.y)) + (_e386.row_y.z * _e386.row_y.z))))) / (abs(((((_e386.row_z.x * _e411.x) + (_e386.row_z.y * _e411.y)) + (_e386.row_z.z * _e411.z)) / (((_e386.row_z.x * _e386.row_z.x) + (_e386.row_z.y * _e386.row_z.y)) + (_e386.row_z.z * _e386.row_z.z)))) * f32(_e413)));
                        if (_e483 < 0.002f) {
                            phi_681_ = _e483;
                        } else {
                            phi_681_ = 0.002f;
                        }
                        let _e486 = phi_681_;
                        phi_798_ = _e486;
                    } else {
                        let _e488 = p.member.map_size;
                        let _e494 = samples.member[(0u + _e60.first_primitive)].position;
                        let _e505 = ((((_e386.row_w.x * _e494.x) + (_e386.row_w.y * _e494.y)) + (_e386.row_w.z * _e494.z)) + _e386.row_w.w);
                        let _e518 = ((_e386.row_x.x - (_e386.row_w.x * _e375.point.uv.x)) / _e505);
                        let _e519 = ((_e386.row_x.y - (_e386.row_w.y * _e375.point.uv.x)) / _e505);
                        let _e520 = ((_e386.row_x.z - (_e386.row_w.z * _e375.point.uv.x)) / _e505);
                        let _e533 = ((_e386.row_y.x - (_e386.row_w.x * _e375.point.uv.y)) / _e505);
                        let _e534 = ((_e386.row_y.y - (_e386.row_w.y * _e375.point.uv.y)) / _e505);
                        let _e535 = ((_e386.row_y.z - (_e386.row_w.z * _e375.point.uv.y)) / _e505);
                        let _e541 = samples.member[(0u + _e60.first_primitive)].normal;
                        let _e546 = ((_e534 * _e541.z) - (_e541.y * _e535));
                        let _e551 = ((_e535 * _e541.x) - (_e541.z * _e533));
                        let _e556 = ((_e533 * _e541.y) - (_e541.x * _e534));
                        let _e558 = samples.member[(0u + _e60.first_primitive)].normal;
                        let _e563 = ((_e519 * _e558.z) - (_e558.y * _e520));
                        let _e568 = ((_e520 * _e558.x) - (_e558.z * _e518));
                        let _e573 = ((_e518 * _e558.y) - (_e558.x * _e519));
                        let _e600 = ((abs(((((_e386.row_z.x * _e546) + (_e386.row_z.y * _e551)) + (_e386.row_z.z * _e556)) / (((_e518 * _e546) + (_e519 * _e551)) + (_e520 * _e556)))) + abs(((((_e386.row_z.x * _e563) + (_e386.row_z.y * _e568)) + (_e386.row_z.z * _e573)) / (((_e533 * _e563) + (_e534 * _e568)) + (_e535 * _e573))))) / f32(_e488));
                        if (_e600 < 0.002f) {
                            phi_797_ = _e600;
                        } else {
                            phi_797_ = 0.002f;
                        }
                        let _e603 = phi_797_;
                        phi_798_ = _e603;
                    }
                    let _e605 = phi_798_;
                    phi_801_ = (_e375.point.depth - (0f * _e605));
                } else {
                    phi_801_ = _e375.point.depth;
                }
                let _e609 = phi_801_;
                let _e615 = p.member.map_size;
                let _e616 = f32(_e615);
                let _e619 = ((_e375.point.uv.x * _e616) - 0.5f);
                let _e620 = ((_e375.point.uv.y * _e616) - 0.5f);
                if (_e619 > -8388608f) {
                    let _e632 = f32(select(0i, select(select(i32(_e619), i32(-2147483648), (_e619 < bitcast<f32>(3472883712u))), 2147483647i, (_e619 > bitcast<f32>(1325400063u))), (_e619 == _e619)));
                    if (_e632 > _e619) {
                        phi_830_ = 1f;
                    } else {
                        phi_830_ = 0f;
                    }
                    let _e635 = phi_830_;
                    if (_e619 < 8388608f) {
                        phi_835_ = (_e632 - _e635);
                        phi_836_ = false;
                    } else {
                        phi_835_ = f32();
                        phi_836_ = true;
                    }
                    let _e638 = phi_835_;
                    let _e640 = phi_836_;
                    phi_837_ = _e638;
                    phi_838_ = _e640;
                } else {
                    phi_837_ = f32();
                    phi_838_ = true;
                }
                let _e642 = phi_837_;
                let _e644 = phi_838_;
                if _e644 {
                    phi_842_ = _e619;
                } else {
                    phi_842_ = _e642;
                }
                let _e646 = phi_842_;
                if (_e620 > -8388608f) {
                    let _e658 = f32(select(0i, select(select(i32(_e620), i32(-2147483648), (_e620 < bitcast<f32>(3472883712u))), 2147483647i, (_e620 > bitcast<f32>(1325400063u))), (_e620 == _e620)));
                    if (_e658 > _e620) {
                        phi_862_ = 1f;
                    } else {
                        phi_862_ = 0f;
                    }
                    let _e661 = phi_862_;
                    if (_e620 < 8388608f) {
                        phi_867_ = (_e658 - _e661);
                        phi_868_ = false;
                    } else {
                        phi_867_ = f32();
                        phi_868_ = true;
                    }
                    let _e664 = phi_867_;
                    let _e666 = phi_868_;
                    phi_869_ = _e664;
                    phi_870_ = _e666;
                } else {
                    phi_869_ = f32();
                    phi_870_ = true;
                }
                let _e668 = phi_869_;
                let _e670 = phi_870_;
                if _e670 {
                    phi_874_ = _e620;
                } else {
                    phi_874_ = _e668;
                }
                let _e672 = phi_874_;
                let _e673 = (_e619 - _e646);
                let _e674 = (_e620 - _e672);
                let _e683 = select(0i, select(select(i32(_e646), i32(-2147483648), (_e646 < bitcast<f32>(3472883712u))), 2147483647i, (_e646 > bitcast<f32>(1325400063u))), (_e646 == _e646));
                let _e692 = select(0i, select(select(i32(_e672), i32(-2147483648), (_e672 < bitcast<f32>(3472883712u))), 2147483647i, (_e672 > bitcast<f32>(1325400063u))), (_e672 == _e672));
                let _e695 = ((1f - _e673) * (1f - _e674));
                let _e697 = (_e673 * (1f - _e674));
                let _e699 = ((1f - _e673) * _e674);
                let _e700 = (_e673 * _e674);
                let _e702 = p.member.test;
                let _e703 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e702);
                let _e705 = p.member.map_size;
                let _e707 = local_3;
                local = _e703;
                let _e710 = ((_e707.level * _e705) * _e705);
                let _e712 = (bitcast<i32>(_e705) - 1i);
                if (_e683 > 0i) {
                    phi_923_ = _e683;
                } else {
                    phi_923_ = 0i;
                }
                let _e715 = phi_923_;
                if (_e692 > 0i) {
                    phi_928_ = _e692;
                } else {
                    phi_928_ = 0i;
                }
                let _e718 = phi_928_;
                if (_e715 < _e712) {
                    phi_933_ = _e715;
                } else {
                    phi_933_ = _e712;
                }
                let _e721 = phi_933_;
                if (_e718 < _e712) {
                    phi_938_ = _e718;
                } else {
                    phi_938_ = _e712;
                }
                let _e724 = phi_938_;
                let _e725 = bitcast<u32>(_e721);
                let _e727 = (_e683 + 1i);
                let _e728 = (_e692 + 1i);
                if (_e727 > 0i) {
                    phi_947_ = _e727;
                } else {
                    phi_947_ = 0i;
                }
                let _e731 = phi_947_;
                if (_e728 > 0i) {
                    phi_952_ = _e728;
                } else {
                    phi_952_ = 0i;
                }
                let _e734 = phi_952_;
                if (_e731 < _e712) {
                    phi_957_ = _e731;
                } else {
                    phi_957_ = _e712;
                }
                let _e737 = phi_957_;
                if (_e734 < _e712) {
                    phi_962_ = _e734;
                } else {
                    phi_962_ = _e712;
                }
                let _e740 = phi_962_;
                let _e741 = bitcast<u32>(_e737);
                let _e743 = (bitcast<u32>(_e724) * _e705);
                let _e744 = (bitcast<u32>(_e740) * _e705);
                let _e749 = ((_e743 + _e725) + _e710);
                let _e750 = ((_e743 + _e741) + _e710);
                let _e751 = ((_e744 + _e725) + _e710);
                let _e752 = ((_e744 + _e741) + _e710);
                if (_e749 < _e48) {
                } else {
                    return;
                }
                let _e756 = map.member[(0u + _e749)];
                if (_e750 < _e48) {
                } else {
                    return;
                }
                let _e768 = map.member[(0u + _e750)];
                if (_e751 < _e48) {
                } else {
                    return;
                }
                let _e784 = map.member[(0u + _e751)];
                if (_e752 < _e48) {
                } else {
                    return;
                }
                let _e800 = map.member[(0u + _e752)];
                let _e814 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e756.x * _e695) + (_e768.x * _e697)) + (_e784.x * _e699)) + (_e800.x * _e700)), ((((_e756.y * _e695) + (_e768.y * _e697)) + (_e784.y * _e699)) + (_e800.y * _e700)), ((((_e756.z * _e695) + (_e768.z * _e697)) + (_e784.z * _e699)) + (_e800.z * _e700)), ((((_e756.w * _e695) + (_e768.w * _e697)) + (_e784.w * _e699)) + (_e800.w * _e700))), _e609);
                let _e816 = p.member.fade_uv;
                if (_e816 > 0f) {
                    let _e819 = local_4;
                    if ((_e819.level + 1u) == _e66) {
                        let _e828 = p.member.fade_uv;
                        let _e830 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e375.point.uv.x, (1f - _e375.point.uv.x));
                        let _e832 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e375.point.uv.y, (1f - _e375.point.uv.y));
                        let _e833 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e830, _e832);
                        if (_e833 < _e828) {
                            phi_1078_ = (1f - ((1f - _e814) * (_e833 / _e828)));
                        } else {
                            phi_1078_ = _e814;
                        }
                        let _e840 = phi_1078_;
                        phi_1080_ = evaluate_Verdict(_e840, false);
                        phi_1081_ = false;
                    } else {
                        phi_1080_ = evaluate_Verdict();
                        phi_1081_ = true;
                    }
                    let _e843 = phi_1080_;
                    let _e845 = phi_1081_;
                    phi_1082_ = _e843;
                    phi_1083_ = _e845;
                } else {
                    phi_1082_ = evaluate_Verdict();
                    phi_1083_ = true;
                }
                let _e847 = phi_1082_;
                let _e849 = phi_1083_;
                if _e849 {
                    phi_1088_ = evaluate_Verdict(_e814, false);
                    phi_1089_ = false;
                } else {
                    phi_1088_ = evaluate_Verdict();
                    phi_1089_ = true;
                }
                let _e852 = phi_1088_;
                let _e854 = phi_1089_;
                phi_1091_ = _e852;
                phi_1092_ = _e847;
                phi_1093_ = _e854;
            } else {
                phi_1091_ = evaluate_Verdict();
                phi_1092_ = evaluate_Verdict(1f, false);
                phi_1093_ = true;
            }
            let _e857 = phi_1091_;
            let _e859 = phi_1092_;
            let _e861 = phi_1093_;
            if _e861 {
            }
            phi_1097_ = _e859;
            phi_1098_ = _e857;
            phi_1099_ = _e861;
        }
        let _e863 = phi_1097_;
        let _e865 = phi_1098_;
        let _e867 = phi_1099_;
        if _e867 {
            phi_1103_ = _e863;
        } else {
            phi_1103_ = _e865;
        }
        let _e869 = phi_1103_;
        if (_e60.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e60.first_primitive)] = _e869.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_vsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
