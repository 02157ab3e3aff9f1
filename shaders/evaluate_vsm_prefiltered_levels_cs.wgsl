struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_15 {
    member: array<abi_Sample>,
}

struct type_19 {
    member: array<f32>,
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

struct type_39 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_39;
@group(0) @binding(2) 
var<storage> map: type_31;

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
        let _e53 = phi_147_;
        let _e55 = phi_148_;
        phi_149_ = _e53;
        phi_150_ = _e55;
    } else {
        phi_149_ = lt_bvh_traverse_Tree();
        phi_150_ = true;
    }
    let _e57 = phi_149_;
    let _e59 = phi_150_;
    if _e59 {
        phi_155_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_155_ = _e57;
    }
    let _e64 = phi_155_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
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
            let _e49 = phi_180_;
            phi_181_ = _e49;
        }
        let _e51 = phi_181_;
        phi_182_ = _e51;
    }
    let _e53 = phi_182_;
    let _e56 = (*param_4);
    let _e60 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e56) & 2147483647u) > 2139095040u) {
        phi_200_ = true;
    } else {
        let _e64 = (_e56 > _e60);
        if _e64 {
        }
        phi_200_ = _e64;
    }
    let _e66 = phi_200_;
    if _e66 {
        phi_204_ = _e56;
    } else {
        phi_204_ = _e60;
    }
    let _e68 = phi_204_;
    let _e69 = (_e53 - param_5.x);
    if (_e69 <= 0f) {
        let _e73 = ((bitcast<u32>(_e68) & 2147483647u) > 2139095040u);
        if _e73 {
        }
        phi_216_ = _e73;
    } else {
        phi_216_ = true;
    }
    let _e75 = phi_216_;
    if _e75 {
        phi_223_ = (_e68 / (_e68 + (_e69 * _e69)));
    } else {
        phi_223_ = 1f;
    }
    let _e80 = phi_223_;
    if ((bitcast<u32>(_e80) & 2147483647u) > 2139095040u) {
        phi_240_ = _e80;
    } else {
        if (_e80 < 0f) {
            phi_239_ = 0f;
        } else {
            if (_e80 > 1f) {
                phi_238_ = 1f;
            } else {
                phi_238_ = _e80;
            }
            let _e87 = phi_238_;
            phi_239_ = _e87;
        }
        let _e89 = phi_239_;
        phi_240_ = _e89;
    }
    let _e91 = phi_240_;
    return _e91;
}

fn function_() {
    var local: f32;
    var phi_300_: bool;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_307_: bool;
    var phi_377_: bool;
    var phi_378_: bool;
    var phi_389_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_390_: bool;
    var phi_391_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_392_: bool;
    var phi_399_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_403_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_423_: lt_math_LightPoint;
    var phi_426_: u32;
    var phi_428_: lt_math_LevelPoint;
    var phi_514_: bool;
    var phi_523_: bool;
    var phi_532_: bool;
    var phi_533_: bool;
    var phi_534_: bool;
    var phi_535_: bool;
    var phi_536_: bool;
    var phi_537_: bool;
    var phi_538_: bool;
    var phi_542_: bool;
    var phi_569_: bool;
    var phi_570_: bool;
    var phi_571_: bool;
    var phi_572_: bool;
    var phi_573_: bool;
    var phi_574_: bool;
    var phi_575_: bool;
    var phi_576_: bool;
    var phi_580_: bool;
    var phi_589_: lt_math_LightPoint;
    var phi_590_: u32;
    var phi_591_: lt_math_LevelPoint;
    var phi_592_: bool;
    var phi_424_: lt_math_LightPoint;
    var phi_427_: u32;
    var phi_429_: lt_math_LevelPoint;
    var phi_593_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_633_: bool;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_636_: bool;
    var phi_640_: bool;
    var phi_722_: f32;
    var phi_840_: f32;
    var phi_841_: f32;
    var phi_844_: f32;
    var phi_873_: f32;
    var phi_878_: f32;
    var phi_879_: bool;
    var phi_880_: f32;
    var phi_881_: bool;
    var phi_885_: f32;
    var phi_905_: f32;
    var phi_910_: f32;
    var phi_911_: bool;
    var phi_912_: f32;
    var phi_913_: bool;
    var phi_917_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_966_: i32;
    var phi_971_: i32;
    var phi_976_: i32;
    var phi_981_: i32;
    var phi_990_: i32;
    var phi_995_: i32;
    var phi_1000_: i32;
    var phi_1005_: i32;
    var phi_1094_: evaluate_Verdict;
    var phi_1095_: evaluate_Verdict;
    var phi_1096_: bool;
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
        let _e73 = samples.member[(0u + _e60.first_primitive)].normal[0u];
        let _e75 = global[0u];
        if (_e73 == _e75) {
            let _e78 = samples.member[(0u + _e60.first_primitive)].normal[1u];
            let _e80 = global[1u];
            if (_e78 == _e80) {
                let _e83 = samples.member[(0u + _e60.first_primitive)].normal[2u];
                let _e85 = global[2u];
                phi_300_ = (_e83 == _e85);
                phi_301_ = false;
            } else {
                phi_300_ = bool();
                phi_301_ = true;
            }
            let _e88 = phi_300_;
            let _e90 = phi_301_;
            phi_302_ = _e88;
            phi_303_ = _e90;
        } else {
            phi_302_ = bool();
            phi_303_ = true;
        }
        let _e92 = phi_302_;
        let _e94 = phi_303_;
        if _e94 {
            phi_307_ = false;
        } else {
            phi_307_ = _e92;
        }
        let _e96 = phi_307_;
        if !(_e96) {
            let _e99 = samples.member[(0u + _e60.first_primitive)].position;
            let _e101 = p.member.light.place;
            let _e107 = p.member.light.place[3u];
            let _e114 = (_e101.x - (_e99.x * _e107));
            let _e115 = (_e101.y - (_e99.y * _e107));
            let _e116 = (_e101.z - (_e99.z * _e107));
            let _e118 = samples.member[(0u + _e60.first_primitive)].normal;
            if ((((_e118.x * _e114) + (_e118.y * _e115)) + (_e118.z * _e116)) > 0f) {
                let _e132 = (((_e114 * _e114) + (_e115 * _e115)) + (_e116 * _e116));
                let _e134 = p.member.light.axis;
                let _e146 = p.member.light.place[3u];
                if (_e146 == 0f) {
                    phi_378_ = true;
                } else {
                    let _e149 = p.member.light.range_squared;
                    if (_e132 <= _e149) {
                        let _e152 = p.member.light.cos_outer;
                        phi_377_ = (-((((_e114 * _e134.x) + (_e115 * _e134.y)) + (_e116 * _e134.z))) >= (_e152 * sqrt(_e132)));
                    } else {
                        phi_377_ = false;
                    }
                    let _e157 = phi_377_;
                    phi_378_ = _e157;
                }
                let _e159 = phi_378_;
                if _e159 {
                    let _e161 = samples.member[(0u + _e60.first_primitive)].flags;
                    let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e169.unnamed.visibility, false), _e169.unnamed_1);
                    phi_389_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e175.unnamed, ((_e161 & 1u) == 0u));
                    phi_390_ = false;
                } else {
                    phi_389_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_390_ = true;
                }
                let _e180 = phi_389_;
                let _e182 = phi_390_;
                phi_391_ = _e180;
                phi_392_ = _e182;
            } else {
                phi_391_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_392_ = true;
            }
            let _e184 = phi_391_;
            let _e186 = phi_392_;
            if _e186 {
                let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e192.unnamed.visibility, false), _e192.unnamed_1);
                phi_399_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e198.unnamed, true);
            } else {
                phi_399_ = _e184;
            }
            let _e203 = phi_399_;
            phi_403_ = _e203;
        } else {
            let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e209.unnamed.visibility, false), _e209.unnamed_1);
            phi_403_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e215.unnamed, true);
        }
        let _e220 = phi_403_;
        if _e220.unnamed_1 {
            phi_1097_ = evaluate_Verdict(_e220.unnamed.visibility, _e220.unnamed.is_doubted);
            phi_1098_ = evaluate_Verdict();
            phi_1099_ = true;
        } else {
            let _e228 = samples.member[(0u + _e60.first_primitive)].position;
            let _e230 = p.member.map_size;
            let _e232 = (0.5f / f32(_e230));
            let _e239 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e246 = lt_math_LightPoint(vec2<f32>(_e239.uv.x, 0f), _e239.depth, _e239.is_inside);
            let _e250 = lt_math_LightPoint(_e246.uv, 0f, _e246.is_inside);
            phi_423_ = lt_math_LightPoint();
            phi_426_ = 0u;
            phi_428_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e250.uv, _e250.depth, false));
            loop {
                let _e257 = phi_423_;
                let _e259 = phi_426_;
                let _e261 = phi_428_;
                local_1 = _e261;
                local_2 = _e261;
                local_3 = _e261;
                if (_e259 < _e66) {
                    if _e261.point.is_inside {
                        phi_589_ = lt_math_LightPoint();
                        phi_590_ = u32();
                        phi_591_ = lt_math_LevelPoint();
                        phi_592_ = false;
                    } else {
                        if (_e259 < _e54) {
                        } else {
                            return;
                        }
                        let _e272 = levels.member[(0u + _e259)].row_w;
                        let _e283 = ((((_e272.x * _e228.x) + (_e272.y * _e228.y)) + (_e272.z * _e228.z)) + (_e272.w * 1f));
                        let _e285 = levels.member[(0u + _e259)].row_x;
                        let _e297 = (((((_e285.x * _e228.x) + (_e285.y * _e228.y)) + (_e285.z * _e228.z)) + (_e285.w * 1f)) / _e283);
                        let _e299 = levels.member[(0u + _e259)].row_y;
                        let _e311 = (((((_e299.x * _e228.x) + (_e299.y * _e228.y)) + (_e299.z * _e228.z)) + (_e299.w * 1f)) / _e283);
                        let _e313 = levels.member[(0u + _e259)].row_z;
                        let _e324 = ((((_e313.x * _e228.x) + (_e313.y * _e228.y)) + (_e313.z * _e228.z)) + (_e313.w * 1f));
                        if (_e283 > 0f) {
                            if (_e297 >= 0f) {
                                phi_514_ = (_e297 <= 1f);
                            } else {
                                phi_514_ = false;
                            }
                            let _e329 = phi_514_;
                            if _e329 {
                                if (_e311 >= 0f) {
                                    phi_523_ = (_e311 <= 1f);
                                } else {
                                    phi_523_ = false;
                                }
                                let _e333 = phi_523_;
                                if _e333 {
                                    if (_e324 >= 0f) {
                                        phi_532_ = (_e324 <= 1f);
                                    } else {
                                        phi_532_ = false;
                                    }
                                    let _e337 = phi_532_;
                                    phi_533_ = _e337;
                                    phi_534_ = false;
                                } else {
                                    phi_533_ = bool();
                                    phi_534_ = true;
                                }
                                let _e339 = phi_533_;
                                let _e341 = phi_534_;
                                phi_535_ = _e339;
                                phi_536_ = _e341;
                            } else {
                                phi_535_ = bool();
                                phi_536_ = true;
                            }
                            let _e343 = phi_535_;
                            let _e345 = phi_536_;
                            phi_537_ = _e343;
                            phi_538_ = _e345;
                        } else {
                            phi_537_ = bool();
                            phi_538_ = true;
                        }
                        let _e347 = phi_537_;
                        let _e349 = phi_538_;
                        if _e349 {
                            phi_542_ = false;
                        } else {
                            phi_542_ = _e347;
                        }
                        let _e351 = phi_542_;
                        if _e351 {
                            if (_e297 >= _e232) {
                                if (_e297 <= (1f - _e232)) {
                                    if (_e311 >= _e232) {
                                        phi_569_ = (_e311 <= (1f - _e232));
                                        phi_570_ = false;
                                    } else {
                                        phi_569_ = bool();
                                        phi_570_ = true;
                                    }
                                    let _e359 = phi_569_;
                                    let _e361 = phi_570_;
                                    phi_571_ = _e359;
                                    phi_572_ = _e361;
                                } else {
                                    phi_571_ = bool();
                                    phi_572_ = true;
                                }
                                let _e363 = phi_571_;
                                let _e365 = phi_572_;
                                phi_573_ = _e363;
                                phi_574_ = _e365;
                            } else {
                                phi_573_ = bool();
                                phi_574_ = true;
                            }
                            let _e367 = phi_573_;
                            let _e369 = phi_574_;
                            phi_575_ = _e367;
                            phi_576_ = _e369;
                        } else {
                            phi_575_ = bool();
                            phi_576_ = true;
                        }
                        let _e371 = phi_575_;
                        let _e373 = phi_576_;
                        if _e373 {
                            phi_580_ = false;
                        } else {
                            phi_580_ = _e371;
                        }
                        let _e375 = phi_580_;
                        let _e382 = lt_math_LightPoint(vec2<f32>(_e297, _e257.uv.y), _e257.depth, _e257.is_inside);
                        let _e389 = lt_math_LightPoint(vec2<f32>(_e382.uv.x, _e311), _e382.depth, _e382.is_inside);
                        let _e393 = lt_math_LightPoint(_e389.uv, _e324, _e389.is_inside);
                        let _e397 = lt_math_LightPoint(_e393.uv, _e393.depth, _e375);
                        phi_589_ = _e397;
                        phi_590_ = (_e259 + 1u);
                        phi_591_ = lt_math_LevelPoint(_e259, _e397);
                        phi_592_ = true;
                    }
                    let _e401 = phi_589_;
                    let _e403 = phi_590_;
                    let _e405 = phi_591_;
                    let _e407 = phi_592_;
                    phi_424_ = _e401;
                    phi_427_ = _e403;
                    phi_429_ = _e405;
                    phi_593_ = _e407;
                } else {
                    phi_424_ = lt_math_LightPoint();
                    phi_427_ = u32();
                    phi_429_ = lt_math_LevelPoint();
                    phi_593_ = false;
                }
                let _e409 = phi_424_;
                let _e411 = phi_427_;
                let _e413 = phi_429_;
                let _e415 = phi_593_;
                continue;
                continuing {
                    phi_423_ = _e409;
                    phi_426_ = _e411;
                    phi_428_ = _e413;
                    break if !(_e415);
                }
            }
            let _e418 = local_1;
            if _e418.point.is_inside {
                if (0f > 0f) {
                    let _e424 = local_2;
                    if (_e424.level < _e54) {
                    } else {
                        return;
                    }
                    let _e429 = levels.member[(0u + _e424.level)];
                    let _e435 = global[0u];
                    if (_e429.row_w.x == _e435) {
                        let _e438 = global[1u];
                        if (_e429.row_w.y == _e438) {
                            let _e441 = global[2u];
                            phi_633_ = (_e429.row_w.z == _e441);
                            phi_634_ = false;
                        } else {
                            phi_633_ = bool();
                            phi_634_ = true;
                        }
                        let _e444 = phi_633_;
                        let _e446 = phi_634_;
                        phi_635_ = _e444;
                        phi_636_ = _e446;
                    } else {
                        phi_635_ = bool();
                        phi_636_ = true;
                    }
                    let _e448 = phi_635_;
                    let _e450 = phi_636_;
                    if _e450 {
                        phi_640_ = false;
                    } else {
                        phi_640_ = _e448;
                    }
                    let _e452 = phi_640_;
                    if _e452 {
                        let _e454 = samples.member[(0u + _e60.first_primitive)].normal;
                        let _e456 = p.member.map_size;
                        let _e526 = ((abs(((((_e429.row_x.x * _e454.x) + (_e429.row_x.y * _e454.y)) + (_e429.row_x.z * _e454.z)) / (((_e429.row_x.x * _e429.row_x.x) + (_e429.row_x.y * _e429.row_x.y)) + (_e429.row_x.z * _e429.row_x.z)))) + abs(((((_e429.row_y.x * _e454.x) + (_e429.row_y.y * _e454.y)) + (_e429.row_y.z * _e454.z)) / (((_e429.row_y.x * _e429.row_y.x) + (_e429.row_y.y * _e429.row_y.y)) + (_e429.row_y.z * _e429.row_y.z))))) / (abs(((((_e429.row_z.x * _e454.x) + (_e429.row_z.y * _e454.y)) + (_e429.row_z.z * _e454.z)) / (((_e429.row_z.x * _e429.row_z.x) + (_e429.row_z.y * _e429.row_z.y)) + (_e429.row_z.z * _e429.row_z.z)))) * f32(_e456)));
                        if (_e526 < 0.002f) {
                            phi_722_ = _e526;
                        } else {
                            phi_722_ = 0.002f;
                        }
                        let _e529 = phi_722_;
                        phi_841_ = _e529;
                    } else {
                        let _e531 = p.member.map_size;
                        let _e537 = samples.member[(0u + _e60.first_primitive)].position;
                        let _e548 = ((((_e429.row_w.x * _e537.x) + (_e429.row_w.y * _e537.y)) + (_e429.row_w.z * _e537.z)) + _e429.row_w.w);
                        let _e561 = ((_e429.row_x.x - (_e429.row_w.x * _e418.point.uv.x)) / _e548);
                        let _e562 = ((_e429.row_x.y - (_e429.row_w.y * _e418.point.uv.x)) / _e548);
                        let _e563 = ((_e429.row_x.z - (_e429.row_w.z * _e418.point.uv.x)) / _e548);
                        let _e576 = ((_e429.row_y.x - (_e429.row_w.x * _e418.point.uv.y)) / _e548);
                        let _e577 = ((_e429.row_y.y - (_e429.row_w.y * _e418.point.uv.y)) / _e548);
                        let _e578 = ((_e429.row_y.z - (_e429.row_w.z * _e418.point.uv.y)) / _e548);
                        let _e584 = samples.member[(0u + _e60.first_primitive)].normal;
                        let _e589 = ((_e577 * _e584.z) - (_e584.y * _e578));
                        let _e594 = ((_e578 * _e584.x) - (_e584.z * _e576));
                        let _e599 = ((_e576 * _e584.y) - (_e584.x * _e577));
                        let _e601 = samples.member[(0u + _e60.first_primitive)].normal;
                        let _e606 = ((_e562 * _e601.z) - (_e601.y * _e563));
                        let _e611 = ((_e563 * _e601.x) - (_e601.z * _e561));
                        let _e616 = ((_e561 * _e601.y) - (_e601.x * _e562));
                        let _e643 = ((abs(((((_e429.row_z.x * _e589) + (_e429.row_z.y * _e594)) + (_e429.row_z.z * _e599)) / (((_e561 * _e589) + (_e562 * _e594)) + (_e563 * _e599)))) + abs(((((_e429.row_z.x * _e606) + (_e429.row_z.y * _e611)) + (_e429.row_z.z * _e616)) / (((_e576 * _e606) + (_e577 * _e611)) + (_e578 * _e616))))) / f32(_e531));
                        let _e645 = (16f / f32(_e531));
                        if (_e643 < _e645) {
                            phi_840_ = _e643;
                        } else {
                            phi_840_ = _e645;
                        }
                        let _e648 = phi_840_;
                        phi_841_ = _e648;
                    }
                    let _e650 = phi_841_;
                    phi_844_ = (_e418.point.depth - (0f * _e650));
                } else {
                    phi_844_ = _e418.point.depth;
                }
                let _e654 = phi_844_;
                let _e660 = p.member.map_size;
                let _e661 = f32(_e660);
                let _e664 = ((_e418.point.uv.x * _e661) - 0.5f);
                let _e665 = ((_e418.point.uv.y * _e661) - 0.5f);
                if (_e664 > -8388608f) {
                    let _e677 = f32(select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < bitcast<f32>(3472883712u))), 2147483647i, (_e664 > bitcast<f32>(1325400063u))), (_e664 == _e664)));
                    if (_e677 > _e664) {
                        phi_873_ = 1f;
                    } else {
                        phi_873_ = 0f;
                    }
                    let _e680 = phi_873_;
                    if (_e664 < 8388608f) {
                        phi_878_ = (_e677 - _e680);
                        phi_879_ = false;
                    } else {
                        phi_878_ = f32();
                        phi_879_ = true;
                    }
                    let _e683 = phi_878_;
                    let _e685 = phi_879_;
                    phi_880_ = _e683;
                    phi_881_ = _e685;
                } else {
                    phi_880_ = f32();
                    phi_881_ = true;
                }
                let _e687 = phi_880_;
                let _e689 = phi_881_;
                if _e689 {
                    phi_885_ = _e664;
                } else {
                    phi_885_ = _e687;
                }
                let _e691 = phi_885_;
                if (_e665 > -8388608f) {
                    let _e703 = f32(select(0i, select(select(i32(_e665), i32(-2147483648), (_e665 < bitcast<f32>(3472883712u))), 2147483647i, (_e665 > bitcast<f32>(1325400063u))), (_e665 == _e665)));
                    if (_e703 > _e665) {
                        phi_905_ = 1f;
                    } else {
                        phi_905_ = 0f;
                    }
                    let _e706 = phi_905_;
                    if (_e665 < 8388608f) {
                        phi_910_ = (_e703 - _e706);
                        phi_911_ = false;
                    } else {
                        phi_910_ = f32();
                        phi_911_ = true;
                    }
                    let _e709 = phi_910_;
                    let _e711 = phi_911_;
                    phi_912_ = _e709;
                    phi_913_ = _e711;
                } else {
                    phi_912_ = f32();
                    phi_913_ = true;
                }
                let _e713 = phi_912_;
                let _e715 = phi_913_;
                if _e715 {
                    phi_917_ = _e665;
                } else {
                    phi_917_ = _e713;
                }
                let _e717 = phi_917_;
                let _e718 = (_e664 - _e691);
                let _e719 = (_e665 - _e717);
                let _e728 = select(0i, select(select(i32(_e691), i32(-2147483648), (_e691 < bitcast<f32>(3472883712u))), 2147483647i, (_e691 > bitcast<f32>(1325400063u))), (_e691 == _e691));
                let _e737 = select(0i, select(select(i32(_e717), i32(-2147483648), (_e717 < bitcast<f32>(3472883712u))), 2147483647i, (_e717 > bitcast<f32>(1325400063u))), (_e717 == _e717));
                let _e740 = ((1f - _e718) * (1f - _e719));
                let _e742 = (_e718 * (1f - _e719));
                let _e744 = ((1f - _e718) * _e719);
                let _e745 = (_e718 * _e719);
                let _e747 = p.member.test;
                let _e748 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e747);
                let _e750 = p.member.map_size;
                let _e752 = local_3;
                local = _e748;
                let _e755 = ((_e752.level * _e750) * _e750);
                let _e757 = (bitcast<i32>(_e750) - 1i);
                if (_e728 > 0i) {
                    phi_966_ = _e728;
                } else {
                    phi_966_ = 0i;
                }
                let _e760 = phi_966_;
                if (_e737 > 0i) {
                    phi_971_ = _e737;
                } else {
                    phi_971_ = 0i;
                }
                let _e763 = phi_971_;
                if (_e760 < _e757) {
                    phi_976_ = _e760;
                } else {
                    phi_976_ = _e757;
                }
                let _e766 = phi_976_;
                if (_e763 < _e757) {
                    phi_981_ = _e763;
                } else {
                    phi_981_ = _e757;
                }
                let _e769 = phi_981_;
                let _e770 = bitcast<u32>(_e766);
                let _e772 = (_e728 + 1i);
                let _e773 = (_e737 + 1i);
                if (_e772 > 0i) {
                    phi_990_ = _e772;
                } else {
                    phi_990_ = 0i;
                }
                let _e776 = phi_990_;
                if (_e773 > 0i) {
                    phi_995_ = _e773;
                } else {
                    phi_995_ = 0i;
                }
                let _e779 = phi_995_;
                if (_e776 < _e757) {
                    phi_1000_ = _e776;
                } else {
                    phi_1000_ = _e757;
                }
                let _e782 = phi_1000_;
                if (_e779 < _e757) {
                    phi_1005_ = _e779;
                } else {
                    phi_1005_ = _e757;
                }
                let _e785 = phi_1005_;
                let _e786 = bitcast<u32>(_e782);
                let _e788 = (bitcast<u32>(_e769) * _e750);
                let _e789 = (bitcast<u32>(_e785) * _e750);
                let _e794 = ((_e788 + _e770) + _e755);
                let _e795 = ((_e788 + _e786) + _e755);
                let _e796 = ((_e789 + _e770) + _e755);
                let _e797 = ((_e789 + _e786) + _e755);
                if (_e794 < _e48) {
                } else {
                    return;
                }
                let _e801 = map.member[(0u + _e794)];
                if (_e795 < _e48) {
                } else {
                    return;
                }
                let _e813 = map.member[(0u + _e795)];
                if (_e796 < _e48) {
                } else {
                    return;
                }
                let _e829 = map.member[(0u + _e796)];
                if (_e797 < _e48) {
                } else {
                    return;
                }
                let _e845 = map.member[(0u + _e797)];
                let _e859 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e801.x * _e740) + (_e813.x * _e742)) + (_e829.x * _e744)) + (_e845.x * _e745)), ((((_e801.y * _e740) + (_e813.y * _e742)) + (_e829.y * _e744)) + (_e845.y * _e745)), ((((_e801.z * _e740) + (_e813.z * _e742)) + (_e829.z * _e744)) + (_e845.z * _e745)), ((((_e801.w * _e740) + (_e813.w * _e742)) + (_e829.w * _e744)) + (_e845.w * _e745))), _e654);
                phi_1094_ = evaluate_Verdict(_e859, false);
                phi_1095_ = evaluate_Verdict();
                phi_1096_ = false;
            } else {
                phi_1094_ = evaluate_Verdict();
                phi_1095_ = evaluate_Verdict(1f, false);
                phi_1096_ = true;
            }
            let _e863 = phi_1094_;
            let _e865 = phi_1095_;
            let _e867 = phi_1096_;
            phi_1097_ = _e865;
            phi_1098_ = _e863;
            phi_1099_ = _e867;
        }
        let _e869 = phi_1097_;
        let _e871 = phi_1098_;
        let _e873 = phi_1099_;
        if _e873 {
            phi_1103_ = _e869;
        } else {
            phi_1103_ = _e871;
        }
        let _e875 = phi_1103_;
        if (_e60.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e60.first_primitive)] = _e875.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_vsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
