struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
}

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

struct type_31 {
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
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    pad0_: u32,
    pad1_: u32,
}

struct type_35 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_41 {
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
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_41;
@group(0) @binding(2) 
var<storage> map: type_31;

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
            let _e48 = phi_179_;
            phi_180_ = _e48;
        }
        let _e50 = phi_180_;
        phi_181_ = _e50;
    }
    let _e52 = phi_181_;
    let _e55 = (*param_4);
    let _e59 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e55) & 2147483647u) > 2139095040u) {
        phi_199_ = true;
    } else {
        let _e63 = (_e55 > _e59);
        if _e63 {
        }
        phi_199_ = _e63;
    }
    let _e65 = phi_199_;
    if _e65 {
        phi_203_ = _e55;
    } else {
        phi_203_ = _e59;
    }
    let _e67 = phi_203_;
    let _e68 = (_e52 - param_5.x);
    if (_e68 <= 0f) {
        let _e72 = ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u);
        if _e72 {
        }
        phi_215_ = _e72;
    } else {
        phi_215_ = true;
    }
    let _e74 = phi_215_;
    if _e74 {
        phi_222_ = (_e67 / (_e67 + (_e68 * _e68)));
    } else {
        phi_222_ = 1f;
    }
    let _e79 = phi_222_;
    if ((bitcast<u32>(_e79) & 2147483647u) > 2139095040u) {
        phi_239_ = _e79;
    } else {
        if (_e79 < 0f) {
            phi_238_ = 0f;
        } else {
            if (_e79 > 1f) {
                phi_237_ = 1f;
            } else {
                phi_237_ = _e79;
            }
            let _e86 = phi_237_;
            phi_238_ = _e86;
        }
        let _e88 = phi_238_;
        phi_239_ = _e88;
    }
    let _e90 = phi_239_;
    return _e90;
}

fn function_() {
    var local: f32;
    var phi_299_: bool;
    var phi_300_: bool;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_306_: bool;
    var phi_376_: bool;
    var phi_377_: bool;
    var phi_388_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_389_: bool;
    var phi_390_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_391_: bool;
    var phi_398_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_402_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_422_: lt_math_LightPoint;
    var phi_425_: u32;
    var phi_427_: lt_math_LevelPoint;
    var phi_513_: bool;
    var phi_522_: bool;
    var phi_531_: bool;
    var phi_532_: bool;
    var phi_533_: bool;
    var phi_534_: bool;
    var phi_535_: bool;
    var phi_536_: bool;
    var phi_537_: bool;
    var phi_541_: bool;
    var phi_568_: bool;
    var phi_569_: bool;
    var phi_570_: bool;
    var phi_571_: bool;
    var phi_572_: bool;
    var phi_573_: bool;
    var phi_574_: bool;
    var phi_575_: bool;
    var phi_579_: bool;
    var phi_588_: lt_math_LightPoint;
    var phi_589_: u32;
    var phi_590_: lt_math_LevelPoint;
    var phi_591_: bool;
    var phi_423_: lt_math_LightPoint;
    var phi_426_: u32;
    var phi_428_: lt_math_LevelPoint;
    var phi_592_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_632_: bool;
    var phi_633_: bool;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_639_: bool;
    var phi_721_: f32;
    var phi_837_: f32;
    var phi_838_: f32;
    var phi_841_: f32;
    var phi_870_: f32;
    var phi_875_: f32;
    var phi_876_: bool;
    var phi_877_: f32;
    var phi_878_: bool;
    var phi_882_: f32;
    var phi_902_: f32;
    var phi_907_: f32;
    var phi_908_: bool;
    var phi_909_: f32;
    var phi_910_: bool;
    var phi_914_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_963_: i32;
    var phi_968_: i32;
    var phi_973_: i32;
    var phi_978_: i32;
    var phi_987_: i32;
    var phi_992_: i32;
    var phi_997_: i32;
    var phi_1002_: i32;
    var phi_1091_: evaluate_Verdict;
    var phi_1092_: evaluate_Verdict;
    var phi_1093_: bool;
    var phi_1094_: evaluate_Verdict;
    var phi_1095_: evaluate_Verdict;
    var phi_1096_: bool;
    var phi_1100_: evaluate_Verdict;

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
        let _e72 = samples.member[(0u + _e59.first_primitive)].normal[0u];
        let _e74 = global[0u];
        if (_e72 == _e74) {
            let _e77 = samples.member[(0u + _e59.first_primitive)].normal[1u];
            let _e79 = global[1u];
            if (_e77 == _e79) {
                let _e82 = samples.member[(0u + _e59.first_primitive)].normal[2u];
                let _e84 = global[2u];
                phi_299_ = (_e82 == _e84);
                phi_300_ = false;
            } else {
                phi_299_ = bool();
                phi_300_ = true;
            }
            let _e87 = phi_299_;
            let _e89 = phi_300_;
            phi_301_ = _e87;
            phi_302_ = _e89;
        } else {
            phi_301_ = bool();
            phi_302_ = true;
        }
        let _e91 = phi_301_;
        let _e93 = phi_302_;
        if _e93 {
            phi_306_ = false;
        } else {
            phi_306_ = _e91;
        }
        let _e95 = phi_306_;
        if !(_e95) {
            let _e98 = samples.member[(0u + _e59.first_primitive)].position;
            let _e100 = p.member.light.place;
            let _e106 = p.member.light.place[3u];
            let _e113 = (_e100.x - (_e98.x * _e106));
            let _e114 = (_e100.y - (_e98.y * _e106));
            let _e115 = (_e100.z - (_e98.z * _e106));
            let _e117 = samples.member[(0u + _e59.first_primitive)].normal;
            if ((((_e117.x * _e113) + (_e117.y * _e114)) + (_e117.z * _e115)) > 0f) {
                let _e131 = (((_e113 * _e113) + (_e114 * _e114)) + (_e115 * _e115));
                let _e133 = p.member.light.axis;
                let _e145 = p.member.light.place[3u];
                if (_e145 == 0f) {
                    phi_377_ = true;
                } else {
                    let _e148 = p.member.light.range_squared;
                    if (_e131 <= _e148) {
                        let _e151 = p.member.light.cos_outer;
                        phi_376_ = (-((((_e113 * _e133.x) + (_e114 * _e133.y)) + (_e115 * _e133.z))) >= (_e151 * sqrt(_e131)));
                    } else {
                        phi_376_ = false;
                    }
                    let _e156 = phi_376_;
                    phi_377_ = _e156;
                }
                let _e158 = phi_377_;
                if _e158 {
                    let _e160 = samples.member[(0u + _e59.first_primitive)].flags;
                    let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                    phi_388_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, ((_e160 & 1u) == 0u));
                    phi_389_ = false;
                } else {
                    phi_388_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_389_ = true;
                }
                let _e179 = phi_388_;
                let _e181 = phi_389_;
                phi_390_ = _e179;
                phi_391_ = _e181;
            } else {
                phi_390_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_391_ = true;
            }
            let _e183 = phi_390_;
            let _e185 = phi_391_;
            if _e185 {
                let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                phi_398_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, true);
            } else {
                phi_398_ = _e183;
            }
            let _e202 = phi_398_;
            phi_402_ = _e202;
        } else {
            let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
            phi_402_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
        }
        let _e219 = phi_402_;
        if _e219.unnamed_1 {
            phi_1094_ = evaluate_Verdict(_e219.unnamed.visibility, _e219.unnamed.is_doubted);
            phi_1095_ = evaluate_Verdict();
            phi_1096_ = true;
        } else {
            let _e227 = samples.member[(0u + _e59.first_primitive)].position;
            let _e229 = p.member.map_size;
            let _e231 = (0.5f / f32(_e229));
            let _e238 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e245 = lt_math_LightPoint(vec2<f32>(_e238.uv.x, 0f), _e238.depth, _e238.is_inside);
            let _e249 = lt_math_LightPoint(_e245.uv, 0f, _e245.is_inside);
            phi_422_ = lt_math_LightPoint();
            phi_425_ = 0u;
            phi_427_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e249.uv, _e249.depth, false));
            loop {
                let _e256 = phi_422_;
                let _e258 = phi_425_;
                let _e260 = phi_427_;
                local_1 = _e260;
                local_2 = _e260;
                local_3 = _e260;
                if (_e258 < _e65) {
                    if _e260.point.is_inside {
                        phi_588_ = lt_math_LightPoint();
                        phi_589_ = u32();
                        phi_590_ = lt_math_LevelPoint();
                        phi_591_ = false;
                    } else {
                        if (_e258 < _e53) {
                        } else {
                            return;
                        }
                        let _e271 = levels.member[(0u + _e258)].row_w;
                        let _e282 = ((((_e271.x * _e227.x) + (_e271.y * _e227.y)) + (_e271.z * _e227.z)) + (_e271.w * 1f));
                        let _e284 = levels.member[(0u + _e258)].row_x;
                        let _e296 = (((((_e284.x * _e227.x) + (_e284.y * _e227.y)) + (_e284.z * _e227.z)) + (_e284.w * 1f)) / _e282);
                        let _e298 = levels.member[(0u + _e258)].row_y;
                        let _e310 = (((((_e298.x * _e227.x) + (_e298.y * _e227.y)) + (_e298.z * _e227.z)) + (_e298.w * 1f)) / _e282);
                        let _e312 = levels.member[(0u + _e258)].row_z;
                        let _e323 = ((((_e312.x * _e227.x) + (_e312.y * _e227.y)) + (_e312.z * _e227.z)) + (_e312.w * 1f));
                        if (_e282 > 0f) {
                            if (_e296 >= 0f) {
                                phi_513_ = (_e296 <= 1f);
                            } else {
                                phi_513_ = false;
                            }
                            let _e328 = phi_513_;
                            if _e328 {
                                if (_e310 >= 0f) {
                                    phi_522_ = (_e310 <= 1f);
                                } else {
                                    phi_522_ = false;
                                }
                                let _e332 = phi_522_;
                                if _e332 {
                                    if (_e323 >= 0f) {
                                        phi_531_ = (_e323 <= 1f);
                                    } else {
                                        phi_531_ = false;
                                    }
                                    let _e336 = phi_531_;
                                    phi_532_ = _e336;
                                    phi_533_ = false;
                                } else {
                                    phi_532_ = bool();
                                    phi_533_ = true;
                                }
                                let _e338 = phi_532_;
                                let _e340 = phi_533_;
                                phi_534_ = _e338;
                                phi_535_ = _e340;
                            } else {
                                phi_534_ = bool();
                                phi_535_ = true;
                            }
                            let _e342 = phi_534_;
                            let _e344 = phi_535_;
                            phi_536_ = _e342;
                            phi_537_ = _e344;
                        } else {
                            phi_536_ = bool();
                            phi_537_ = true;
                        }
                        let _e346 = phi_536_;
                        let _e348 = phi_537_;
                        if _e348 {
                            phi_541_ = false;
                        } else {
                            phi_541_ = _e346;
                        }
                        let _e350 = phi_541_;
                        if _e350 {
                            if (_e296 >= _e231) {
                                if (_e296 <= (1f - _e231)) {
                                    if (_e310 >= _e231) {
                                        phi_568_ = (_e310 <= (1f - _e231));
                                        phi_569_ = false;
                                    } else {
                                        phi_568_ = bool();
                                        phi_569_ = true;
                                    }
                                    let _e358 = phi_568_;
                                    let _e360 = phi_569_;
                                    phi_570_ = _e358;
                                    phi_571_ = _e360;
                                } else {
                                    phi_570_ = bool();
                                    phi_571_ = true;
                                }
                                let _e362 = phi_570_;
                                let _e364 = phi_571_;
                                phi_572_ = _e362;
                                phi_573_ = _e364;
                            } else {
                                phi_572_ = bool();
                                phi_573_ = true;
                            }
                            let _e366 = phi_572_;
                            let _e368 = phi_573_;
                            phi_574_ = _e366;
                            phi_575_ = _e368;
                        } else {
                            phi_574_ = bool();
                            phi_575_ = true;
                        }
                        let _e370 = phi_574_;
                        let _e372 = phi_575_;
                        if _e372 {
                            phi_579_ = false;
                        } else {
                            phi_579_ = _e370;
                        }
                        let _e374 = phi_579_;
                        let _e381 = lt_math_LightPoint(vec2<f32>(_e296, _e256.uv.y), _e256.depth, _e256.is_inside);
                        let _e388 = lt_math_LightPoint(vec2<f32>(_e381.uv.x, _e310), _e381.depth, _e381.is_inside);
                        let _e392 = lt_math_LightPoint(_e388.uv, _e323, _e388.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e392.depth, _e374);
                        phi_588_ = _e396;
                        phi_589_ = (_e258 + 1u);
                        phi_590_ = lt_math_LevelPoint(_e258, _e396);
                        phi_591_ = true;
                    }
                    let _e400 = phi_588_;
                    let _e402 = phi_589_;
                    let _e404 = phi_590_;
                    let _e406 = phi_591_;
                    phi_423_ = _e400;
                    phi_426_ = _e402;
                    phi_428_ = _e404;
                    phi_592_ = _e406;
                } else {
                    phi_423_ = lt_math_LightPoint();
                    phi_426_ = u32();
                    phi_428_ = lt_math_LevelPoint();
                    phi_592_ = false;
                }
                let _e408 = phi_423_;
                let _e410 = phi_426_;
                let _e412 = phi_428_;
                let _e414 = phi_592_;
                continue;
                continuing {
                    phi_422_ = _e408;
                    phi_425_ = _e410;
                    phi_427_ = _e412;
                    break if !(_e414);
                }
            }
            let _e417 = local_1;
            if _e417.point.is_inside {
                if (0f > 0f) {
                    let _e423 = local_2;
                    if (_e423.level < _e53) {
                    } else {
                        return;
                    }
                    let _e428 = levels.member[(0u + _e423.level)];
                    let _e434 = global[0u];
                    if (_e428.row_w.x == _e434) {
                        let _e437 = global[1u];
                        if (_e428.row_w.y == _e437) {
                            let _e440 = global[2u];
                            phi_632_ = (_e428.row_w.z == _e440);
                            phi_633_ = false;
                        } else {
                            phi_632_ = bool();
                            phi_633_ = true;
                        }
                        let _e443 = phi_632_;
                        let _e445 = phi_633_;
                        phi_634_ = _e443;
                        phi_635_ = _e445;
                    } else {
                        phi_634_ = bool();
                        phi_635_ = true;
                    }
                    let _e447 = phi_634_;
                    let _e449 = phi_635_;
                    if _e449 {
                        phi_639_ = false;
                    } else {
                        phi_639_ = _e447;
                    }
                    let _e451 = phi_639_;
                    if _e451 {
                        let _e453 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e455 = p.member.map_size;
                        let _e525 = ((abs(((((_e428.row_x.x * _e453.x) + (_e428.row_x.y * _e453.y)) + (_e428.row_x.z * _e453.z)) / (((_e428.row_x.x * _e428.row_x.x) + (_e428.row_x.y * _e428.row_x.y)) + (_e428.row_x.z * _e428.row_x.z)))) + abs(((((_e428.row_y.x * _e453.x) + (_e428.row_y.y * _e453.y)) + (_e428.row_y.z * _e453.z)) / (((_e428.row_y.x * _e428.row_y.x) + (_e428.row_y.y * _e428.row_y.y)) + (_e428.row_y.z * _e428.row_y.z))))) / (abs(((((_e428.row_z.x * _e453.x) + (_e428.row_z.y * _e453.y)) + (_e428.row_z.z * _e453.z)) / (((_e428.row_z.x * _e428.row_z.x) + (_e428.row_z.y * _e428.row_z.y)) + (_e428.row_z.z * _e428.row_z.z)))) * f32(_e455)));
                        if (_e525 < 0.002f) {
                            phi_721_ = _e525;
                        } else {
                            phi_721_ = 0.002f;
                        }
                        let _e528 = phi_721_;
                        phi_838_ = _e528;
                    } else {
                        let _e530 = p.member.map_size;
                        let _e536 = samples.member[(0u + _e59.first_primitive)].position;
                        let _e547 = ((((_e428.row_w.x * _e536.x) + (_e428.row_w.y * _e536.y)) + (_e428.row_w.z * _e536.z)) + _e428.row_w.w);
                        let _e560 = ((_e428.row_x.x - (_e428.row_w.x * _e417.point.uv.x)) / _e547);
                        let _e561 = ((_e428.row_x.y - (_e428.row_w.y * _e417.point.uv.x)) / _e547);
                        let _e562 = ((_e428.row_x.z - (_e428.row_w.z * _e417.point.uv.x)) / _e547);
                        let _e575 = ((_e428.row_y.x - (_e428.row_w.x * _e417.point.uv.y)) / _e547);
                        let _e576 = ((_e428.row_y.y - (_e428.row_w.y * _e417.point.uv.y)) / _e547);
                        let _e577 = ((_e428.row_y.z - (_e428.row_w.z * _e417.point.uv.y)) / _e547);
                        let _e583 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e588 = ((_e576 * _e583.z) - (_e583.y * _e577));
                        let _e593 = ((_e577 * _e583.x) - (_e583.z * _e575));
                        let _e598 = ((_e575 * _e583.y) - (_e583.x * _e576));
                        let _e600 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e605 = ((_e561 * _e600.z) - (_e600.y * _e562));
                        let _e610 = ((_e562 * _e600.x) - (_e600.z * _e560));
                        let _e615 = ((_e560 * _e600.y) - (_e600.x * _e561));
                        let _e642 = ((abs(((((_e428.row_z.x * _e588) + (_e428.row_z.y * _e593)) + (_e428.row_z.z * _e598)) / (((_e560 * _e588) + (_e561 * _e593)) + (_e562 * _e598)))) + abs(((((_e428.row_z.x * _e605) + (_e428.row_z.y * _e610)) + (_e428.row_z.z * _e615)) / (((_e575 * _e605) + (_e576 * _e610)) + (_e577 * _e615))))) / f32(_e530));
                        if (_e642 < 0.002f) {
                            phi_837_ = _e642;
                        } else {
                            phi_837_ = 0.002f;
                        }
                        let _e645 = phi_837_;
                        phi_838_ = _e645;
                    }
                    let _e647 = phi_838_;
                    phi_841_ = (_e417.point.depth - (0f * _e647));
                } else {
                    phi_841_ = _e417.point.depth;
                }
                let _e651 = phi_841_;
                let _e657 = p.member.map_size;
                let _e658 = f32(_e657);
                let _e661 = ((_e417.point.uv.x * _e658) - 0.5f);
                let _e662 = ((_e417.point.uv.y * _e658) - 0.5f);
                if (_e661 > -8388608f) {
                    let _e674 = f32(select(0i, select(select(i32(_e661), i32(-2147483648), (_e661 < bitcast<f32>(3472883712u))), 2147483647i, (_e661 > bitcast<f32>(1325400063u))), (_e661 == _e661)));
                    if (_e674 > _e661) {
                        phi_870_ = 1f;
                    } else {
                        phi_870_ = 0f;
                    }
                    let _e677 = phi_870_;
                    if (_e661 < 8388608f) {
                        phi_875_ = (_e674 - _e677);
                        phi_876_ = false;
                    } else {
                        phi_875_ = f32();
                        phi_876_ = true;
                    }
                    let _e680 = phi_875_;
                    let _e682 = phi_876_;
                    phi_877_ = _e680;
                    phi_878_ = _e682;
                } else {
                    phi_877_ = f32();
                    phi_878_ = true;
                }
                let _e684 = phi_877_;
                let _e686 = phi_878_;
                if _e686 {
                    phi_882_ = _e661;
                } else {
                    phi_882_ = _e684;
                }
                let _e688 = phi_882_;
                if (_e662 > -8388608f) {
                    let _e700 = f32(select(0i, select(select(i32(_e662), i32(-2147483648), (_e662 < bitcast<f32>(3472883712u))), 2147483647i, (_e662 > bitcast<f32>(1325400063u))), (_e662 == _e662)));
                    if (_e700 > _e662) {
                        phi_902_ = 1f;
                    } else {
                        phi_902_ = 0f;
                    }
                    let _e703 = phi_902_;
                    if (_e662 < 8388608f) {
                        phi_907_ = (_e700 - _e703);
                        phi_908_ = false;
                    } else {
                        phi_907_ = f32();
                        phi_908_ = true;
                    }
                    let _e706 = phi_907_;
                    let _e708 = phi_908_;
                    phi_909_ = _e706;
                    phi_910_ = _e708;
                } else {
                    phi_909_ = f32();
                    phi_910_ = true;
                }
                let _e710 = phi_909_;
                let _e712 = phi_910_;
                if _e712 {
                    phi_914_ = _e662;
                } else {
                    phi_914_ = _e710;
                }
                let _e714 = phi_914_;
                let _e715 = (_e661 - _e688);
                let _e716 = (_e662 - _e714);
                let _e725 = select(0i, select(select(i32(_e688), i32(-2147483648), (_e688 < bitcast<f32>(3472883712u))), 2147483647i, (_e688 > bitcast<f32>(1325400063u))), (_e688 == _e688));
                let _e734 = select(0i, select(select(i32(_e714), i32(-2147483648), (_e714 < bitcast<f32>(3472883712u))), 2147483647i, (_e714 > bitcast<f32>(1325400063u))), (_e714 == _e714));
                let _e737 = ((1f - _e715) * (1f - _e716));
                let _e739 = (_e715 * (1f - _e716));
                let _e741 = ((1f - _e715) * _e716);
                let _e742 = (_e715 * _e716);
                let _e744 = p.member.test;
                let _e745 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e744);
                let _e747 = p.member.map_size;
                let _e749 = local_3;
                local = _e745;
                let _e752 = ((_e749.level * _e747) * _e747);
                let _e754 = (bitcast<i32>(_e747) - 1i);
                if (_e725 > 0i) {
                    phi_963_ = _e725;
                } else {
                    phi_963_ = 0i;
                }
                let _e757 = phi_963_;
                if (_e734 > 0i) {
                    phi_968_ = _e734;
                } else {
                    phi_968_ = 0i;
                }
                let _e760 = phi_968_;
                if (_e757 < _e754) {
                    phi_973_ = _e757;
                } else {
                    phi_973_ = _e754;
                }
                let _e763 = phi_973_;
                if (_e760 < _e754) {
                    phi_978_ = _e760;
                } else {
                    phi_978_ = _e754;
                }
                let _e766 = phi_978_;
                let _e767 = bitcast<u32>(_e763);
                let _e769 = (_e725 + 1i);
                let _e770 = (_e734 + 1i);
                if (_e769 > 0i) {
                    phi_987_ = _e769;
                } else {
                    phi_987_ = 0i;
                }
                let _e773 = phi_987_;
                if (_e770 > 0i) {
                    phi_992_ = _e770;
                } else {
                    phi_992_ = 0i;
                }
                let _e776 = phi_992_;
                if (_e773 < _e754) {
                    phi_997_ = _e773;
                } else {
                    phi_997_ = _e754;
                }
                let _e779 = phi_997_;
                if (_e776 < _e754) {
                    phi_1002_ = _e776;
                } else {
                    phi_1002_ = _e754;
                }
                let _e782 = phi_1002_;
                let _e783 = bitcast<u32>(_e779);
                let _e785 = (bitcast<u32>(_e766) * _e747);
                let _e786 = (bitcast<u32>(_e782) * _e747);
                let _e791 = ((_e785 + _e767) + _e752);
                let _e792 = ((_e785 + _e783) + _e752);
                let _e793 = ((_e786 + _e767) + _e752);
                let _e794 = ((_e786 + _e783) + _e752);
                if (_e791 < _e47) {
                } else {
                    return;
                }
                let _e798 = map.member[(0u + _e791)];
                if (_e792 < _e47) {
                } else {
                    return;
                }
                let _e810 = map.member[(0u + _e792)];
                if (_e793 < _e47) {
                } else {
                    return;
                }
                let _e826 = map.member[(0u + _e793)];
                if (_e794 < _e47) {
                } else {
                    return;
                }
                let _e842 = map.member[(0u + _e794)];
                let _e856 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e798.x * _e737) + (_e810.x * _e739)) + (_e826.x * _e741)) + (_e842.x * _e742)), ((((_e798.y * _e737) + (_e810.y * _e739)) + (_e826.y * _e741)) + (_e842.y * _e742)), ((((_e798.z * _e737) + (_e810.z * _e739)) + (_e826.z * _e741)) + (_e842.z * _e742)), ((((_e798.w * _e737) + (_e810.w * _e739)) + (_e826.w * _e741)) + (_e842.w * _e742))), _e651);
                phi_1091_ = evaluate_Verdict(_e856, false);
                phi_1092_ = evaluate_Verdict();
                phi_1093_ = false;
            } else {
                phi_1091_ = evaluate_Verdict();
                phi_1092_ = evaluate_Verdict(1f, false);
                phi_1093_ = true;
            }
            let _e860 = phi_1091_;
            let _e862 = phi_1092_;
            let _e864 = phi_1093_;
            phi_1094_ = _e862;
            phi_1095_ = _e860;
            phi_1096_ = _e864;
        }
        let _e866 = phi_1094_;
        let _e868 = phi_1095_;
        let _e870 = phi_1096_;
        if _e870 {
            phi_1100_ = _e866;
        } else {
            phi_1100_ = _e868;
        }
        let _e872 = phi_1100_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e872.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_vsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
