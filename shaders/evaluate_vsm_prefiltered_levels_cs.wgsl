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
    fade_uv: f32,
    pad0_: u32,
}

struct type_36 {
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
var<uniform> p: type_36;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_41;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_151_: lt_bvh_traverse_Tree;
    var phi_152_: bool;
    var phi_157_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_149_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_150_ = false;
        } else {
            phi_149_ = lt_bvh_traverse_Tree();
            phi_150_ = true;
        }
        let _e53 = phi_149_;
        let _e55 = phi_150_;
        phi_151_ = _e53;
        phi_152_ = _e55;
    } else {
        phi_151_ = lt_bvh_traverse_Tree();
        phi_152_ = true;
    }
    let _e57 = phi_151_;
    let _e59 = phi_152_;
    if _e59 {
        phi_157_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_157_ = _e57;
    }
    let _e64 = phi_157_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_4: f32, param_5: f32) -> f32 {
    var phi_171_: f32;

    if (param_4 < param_5) {
        phi_171_ = param_4;
    } else {
        phi_171_ = param_5;
    }
    let _e44 = phi_171_;
    return _e44;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_190_: f32;
    var phi_191_: f32;
    var phi_192_: f32;
    var phi_210_: bool;
    var phi_214_: f32;
    var phi_226_: bool;
    var phi_233_: f32;
    var phi_248_: f32;
    var phi_249_: f32;
    var phi_250_: f32;

    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_192_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_191_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_190_ = 1f;
            } else {
                phi_190_ = param_8;
            }
            let _e49 = phi_190_;
            phi_191_ = _e49;
        }
        let _e51 = phi_191_;
        phi_192_ = _e51;
    }
    let _e53 = phi_192_;
    let _e56 = (*param_6);
    let _e60 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e56) & 2147483647u) > 2139095040u) {
        phi_210_ = true;
    } else {
        let _e64 = (_e56 > _e60);
        if _e64 {
        }
        phi_210_ = _e64;
    }
    let _e66 = phi_210_;
    if _e66 {
        phi_214_ = _e56;
    } else {
        phi_214_ = _e60;
    }
    let _e68 = phi_214_;
    let _e69 = (_e53 - param_7.x);
    if (_e69 <= 0f) {
        let _e73 = ((bitcast<u32>(_e68) & 2147483647u) > 2139095040u);
        if _e73 {
        }
        phi_226_ = _e73;
    } else {
        phi_226_ = true;
    }
    let _e75 = phi_226_;
    if _e75 {
        phi_233_ = (_e68 / (_e68 + (_e69 * _e69)));
    } else {
        phi_233_ = 1f;
    }
    let _e80 = phi_233_;
    if ((bitcast<u32>(_e80) & 2147483647u) > 2139095040u) {
        phi_250_ = _e80;
    } else {
        if (_e80 < 0f) {
            phi_249_ = 0f;
        } else {
            if (_e80 > 1f) {
                phi_248_ = 1f;
            } else {
                phi_248_ = _e80;
            }
            let _e87 = phi_248_;
            phi_249_ = _e87;
        }
        let _e89 = phi_249_;
        phi_250_ = _e89;
    }
    let _e91 = phi_250_;
    return _e91;
}

fn function_() {
    var local: f32;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_317_: bool;
    var phi_387_: bool;
    var phi_388_: bool;
    var phi_399_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_400_: bool;
    var phi_401_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_402_: bool;
    var phi_409_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_413_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_433_: lt_math_LightPoint;
    var phi_436_: u32;
    var phi_438_: lt_math_LevelPoint;
    var phi_524_: bool;
    var phi_533_: bool;
    var phi_542_: bool;
    var phi_543_: bool;
    var phi_544_: bool;
    var phi_545_: bool;
    var phi_546_: bool;
    var phi_547_: bool;
    var phi_548_: bool;
    var phi_552_: bool;
    var phi_579_: bool;
    var phi_580_: bool;
    var phi_581_: bool;
    var phi_582_: bool;
    var phi_583_: bool;
    var phi_584_: bool;
    var phi_585_: bool;
    var phi_586_: bool;
    var phi_590_: bool;
    var phi_599_: lt_math_LightPoint;
    var phi_600_: u32;
    var phi_601_: lt_math_LevelPoint;
    var phi_602_: bool;
    var phi_434_: lt_math_LightPoint;
    var phi_437_: u32;
    var phi_439_: lt_math_LevelPoint;
    var phi_603_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_650_: bool;
    var phi_732_: f32;
    var phi_848_: f32;
    var phi_849_: f32;
    var phi_852_: f32;
    var phi_881_: f32;
    var phi_886_: f32;
    var phi_887_: bool;
    var phi_888_: f32;
    var phi_889_: bool;
    var phi_893_: f32;
    var phi_913_: f32;
    var phi_918_: f32;
    var phi_919_: bool;
    var phi_920_: f32;
    var phi_921_: bool;
    var phi_925_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_974_: i32;
    var phi_979_: i32;
    var phi_984_: i32;
    var phi_989_: i32;
    var phi_998_: i32;
    var phi_1003_: i32;
    var phi_1008_: i32;
    var phi_1013_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1129_: f32;
    var phi_1131_: evaluate_Verdict;
    var phi_1132_: bool;
    var phi_1133_: evaluate_Verdict;
    var phi_1134_: bool;
    var phi_1139_: evaluate_Verdict;
    var phi_1140_: bool;
    var phi_1142_: evaluate_Verdict;
    var phi_1143_: evaluate_Verdict;
    var phi_1144_: bool;
    var phi_1148_: evaluate_Verdict;
    var phi_1149_: evaluate_Verdict;
    var phi_1150_: bool;
    var phi_1154_: evaluate_Verdict;

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
                phi_310_ = (_e83 == _e85);
                phi_311_ = false;
            } else {
                phi_310_ = bool();
                phi_311_ = true;
            }
            let _e88 = phi_310_;
            let _e90 = phi_311_;
            phi_312_ = _e88;
            phi_313_ = _e90;
        } else {
            phi_312_ = bool();
            phi_313_ = true;
        }
        let _e92 = phi_312_;
        let _e94 = phi_313_;
        if _e94 {
            phi_317_ = false;
        } else {
            phi_317_ = _e92;
        }
        let _e96 = phi_317_;
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
                    phi_388_ = true;
                } else {
                    let _e149 = p.member.light.range_squared;
                    if (_e132 <= _e149) {
                        let _e152 = p.member.light.cos_outer;
                        phi_387_ = (-((((_e114 * _e134.x) + (_e115 * _e134.y)) + (_e116 * _e134.z))) >= (_e152 * sqrt(_e132)));
                    } else {
                        phi_387_ = false;
                    }
                    let _e157 = phi_387_;
                    phi_388_ = _e157;
                }
                let _e159 = phi_388_;
                if _e159 {
                    let _e161 = samples.member[(0u + _e60.first_primitive)].flags;
                    let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e169.unnamed.visibility, false), _e169.unnamed_1);
                    phi_399_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e175.unnamed, ((_e161 & 1u) == 0u));
                    phi_400_ = false;
                } else {
                    phi_399_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_400_ = true;
                }
                let _e180 = phi_399_;
                let _e182 = phi_400_;
                phi_401_ = _e180;
                phi_402_ = _e182;
            } else {
                phi_401_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_402_ = true;
            }
            let _e184 = phi_401_;
            let _e186 = phi_402_;
            if _e186 {
                let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e192.unnamed.visibility, false), _e192.unnamed_1);
                phi_409_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e198.unnamed, true);
            } else {
                phi_409_ = _e184;
            }
            let _e203 = phi_409_;
            phi_413_ = _e203;
        } else {
            let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e209.unnamed.visibility, false), _e209.unnamed_1);
            phi_413_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e215.unnamed, true);
        }
        let _e220 = phi_413_;
        if _e220.unnamed_1 {
            phi_1148_ = evaluate_Verdict(_e220.unnamed.visibility, _e220.unnamed.is_doubted);
            phi_1149_ = evaluate_Verdict();
            phi_1150_ = true;
        } else {
            let _e228 = samples.member[(0u + _e60.first_primitive)].position;
            let _e230 = p.member.map_size;
            let _e232 = (0.5f / f32(_e230));
            let _e239 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e246 = lt_math_LightPoint(vec2<f32>(_e239.uv.x, 0f), _e239.depth, _e239.is_inside);
            let _e250 = lt_math_LightPoint(_e246.uv, 0f, _e246.is_inside);
            phi_433_ = lt_math_LightPoint();
            phi_436_ = 0u;
            phi_438_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e250.uv, _e250.depth, false));
            loop {
                let _e257 = phi_433_;
                let _e259 = phi_436_;
                let _e261 = phi_438_;
                local_1 = _e261;
                local_2 = _e261;
                local_3 = _e261;
                local_4 = _e261;
                if (_e259 < _e66) {
                    if _e261.point.is_inside {
                        phi_599_ = lt_math_LightPoint();
                        phi_600_ = u32();
                        phi_601_ = lt_math_LevelPoint();
                        phi_602_ = false;
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
                                phi_524_ = (_e297 <= 1f);
                            } else {
                                phi_524_ = false;
                            }
                            let _e329 = phi_524_;
                            if _e329 {
                                if (_e311 >= 0f) {
                                    phi_533_ = (_e311 <= 1f);
                                } else {
                                    phi_533_ = false;
                                }
                                let _e333 = phi_533_;
                                if _e333 {
                                    if (_e324 >= 0f) {
                                        phi_542_ = (_e324 <= 1f);
                                    } else {
                                        phi_542_ = false;
                                    }
                                    let _e337 = phi_542_;
                                    phi_543_ = _e337;
                                    phi_544_ = false;
                                } else {
                                    phi_543_ = bool();
                                    phi_544_ = true;
                                }
                                let _e339 = phi_543_;
                                let _e341 = phi_544_;
                                phi_545_ = _e339;
                                phi_546_ = _e341;
                            } else {
                                phi_545_ = bool();
                                phi_546_ = true;
                            }
                            let _e343 = phi_545_;
                            let _e345 = phi_546_;
                            phi_547_ = _e343;
                            phi_548_ = _e345;
                        } else {
                            phi_547_ = bool();
                            phi_548_ = true;
                        }
                        let _e347 = phi_547_;
                        let _e349 = phi_548_;
                        if _e349 {
                            phi_552_ = false;
                        } else {
                            phi_552_ = _e347;
                        }
                        let _e351 = phi_552_;
                        if _e351 {
                            if (_e297 >= _e232) {
                                if (_e297 <= (1f - _e232)) {
                                    if (_e311 >= _e232) {
                                        phi_579_ = (_e311 <= (1f - _e232));
                                        phi_580_ = false;
                                    } else {
                                        phi_579_ = bool();
                                        phi_580_ = true;
                                    }
                                    let _e359 = phi_579_;
                                    let _e361 = phi_580_;
                                    phi_581_ = _e359;
                                    phi_582_ = _e361;
                                } else {
                                    phi_581_ = bool();
                                    phi_582_ = true;
                                }
                                let _e363 = phi_581_;
                                let _e365 = phi_582_;
                                phi_583_ = _e363;
                                phi_584_ = _e365;
                            } else {
                                phi_583_ = bool();
                                phi_584_ = true;
                            }
                            let _e367 = phi_583_;
                            let _e369 = phi_584_;
                            phi_585_ = _e367;
                            phi_586_ = _e369;
                        } else {
                            phi_585_ = bool();
                            phi_586_ = true;
                        }
                        let _e371 = phi_585_;
                        let _e373 = phi_586_;
                        if _e373 {
                            phi_590_ = false;
                        } else {
                            phi_590_ = _e371;
                        }
                        let _e375 = phi_590_;
                        let _e382 = lt_math_LightPoint(vec2<f32>(_e297, _e257.uv.y), _e257.depth, _e257.is_inside);
                        let _e389 = lt_math_LightPoint(vec2<f32>(_e382.uv.x, _e311), _e382.depth, _e382.is_inside);
                        let _e393 = lt_math_LightPoint(_e389.uv, _e324, _e389.is_inside);
                        let _e397 = lt_math_LightPoint(_e393.uv, _e393.depth, _e375);
                        phi_599_ = _e397;
                        phi_600_ = (_e259 + 1u);
                        phi_601_ = lt_math_LevelPoint(_e259, _e397);
                        phi_602_ = true;
                    }
                    let _e401 = phi_599_;
                    let _e403 = phi_600_;
                    let _e405 = phi_601_;
                    let _e407 = phi_602_;
                    phi_434_ = _e401;
                    phi_437_ = _e403;
                    phi_439_ = _e405;
                    phi_603_ = _e407;
                } else {
                    phi_434_ = lt_math_LightPoint();
                    phi_437_ = u32();
                    phi_439_ = lt_math_LevelPoint();
                    phi_603_ = false;
                }
                let _e409 = phi_434_;
                let _e411 = phi_437_;
                let _e413 = phi_439_;
                let _e415 = phi_603_;
                continue;
                continuing {
                    phi_433_ = _e409;
                    phi_436_ = _e411;
                    phi_438_ = _e413;
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
                            phi_643_ = (_e429.row_w.z == _e441);
                            phi_644_ = false;
                        } else {
                            phi_643_ = bool();
                            phi_644_ = true;
                        }
                        let _e444 = phi_643_;
                        let _e446 = phi_644_;
                        phi_645_ = _e444;
                        phi_646_ = _e446;
                    } else {
                        phi_645_ = bool();
                        phi_646_ = true;
                    }
                    let _e448 = phi_645_;
                    let _e450 = phi_646_;
                    if _e450 {
                        phi_650_ = false;
                    } else {
                        phi_650_ = _e448;
                    }
                    let _e452 = phi_650_;
                    if _e452 {
                        let _e454 = samples.member[(0u + _e60.first_primitive)].normal;
                        let _e456 = p.member.map_size;
                        let _e526 = ((abs(((((_e429.row_x.x * _e454.x) + (_e429.row_x.y * _e454.y)) + (_e429.row_x.z * _e454.z)) / (((_e429.row_x.x * _e429.row_x.x) + (_e429.row_x.y * _e429.row_x.y)) + (_e429.row_x.z * _e429.row_x.z)))) + abs(((((_e429.row_y.x * _e454.x) + (_e429.row_y.y * _e454.y)) + (_e429.row_y.z * _e454.z)) / (((_e429.row_y.x * _e429.row_y.x) + (_e429.row_y.y * _e429.row_y.y)) + (_e429.row_y.z * _e429.row_y.z))))) / (abs(((((_e429.row_z.x * _e454.x) + (_e429.row_z.y * _e454.y)) + (_e429.row_z.z * _e454.z)) / (((_e429.row_z.x * _e429.row_z.x) + (_e429.row_z.y * _e429.row_z.y)) + (_e429.row_z.z * _e429.row_z.z)))) * f32(_e456)));
                        if (_e526 < 0.002f) {
                            phi_732_ = _e526;
                        } else {
                            phi_732_ = 0.002f;
                        }
                        let _e529 = phi_732_;
                        phi_849_ = _e529;
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
                        if (_e643 < 0.002f) {
                            phi_848_ = _e643;
                        } else {
                            phi_848_ = 0.002f;
                        }
                        let _e646 = phi_848_;
                        phi_849_ = _e646;
                    }
                    let _e648 = phi_849_;
                    phi_852_ = (_e418.point.depth - (0f * _e648));
                } else {
                    phi_852_ = _e418.point.depth;
                }
                let _e652 = phi_852_;
                let _e658 = p.member.map_size;
                let _e659 = f32(_e658);
                let _e662 = ((_e418.point.uv.x * _e659) - 0.5f);
                let _e663 = ((_e418.point.uv.y * _e659) - 0.5f);
                if (_e662 > -8388608f) {
                    let _e675 = f32(select(0i, select(select(i32(_e662), i32(-2147483648), (_e662 < bitcast<f32>(3472883712u))), 2147483647i, (_e662 > bitcast<f32>(1325400063u))), (_e662 == _e662)));
                    if (_e675 > _e662) {
                        phi_881_ = 1f;
                    } else {
                        phi_881_ = 0f;
                    }
                    let _e678 = phi_881_;
                    if (_e662 < 8388608f) {
                        phi_886_ = (_e675 - _e678);
                        phi_887_ = false;
                    } else {
                        phi_886_ = f32();
                        phi_887_ = true;
                    }
                    let _e681 = phi_886_;
                    let _e683 = phi_887_;
                    phi_888_ = _e681;
                    phi_889_ = _e683;
                } else {
                    phi_888_ = f32();
                    phi_889_ = true;
                }
                let _e685 = phi_888_;
                let _e687 = phi_889_;
                if _e687 {
                    phi_893_ = _e662;
                } else {
                    phi_893_ = _e685;
                }
                let _e689 = phi_893_;
                if (_e663 > -8388608f) {
                    let _e701 = f32(select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < bitcast<f32>(3472883712u))), 2147483647i, (_e663 > bitcast<f32>(1325400063u))), (_e663 == _e663)));
                    if (_e701 > _e663) {
                        phi_913_ = 1f;
                    } else {
                        phi_913_ = 0f;
                    }
                    let _e704 = phi_913_;
                    if (_e663 < 8388608f) {
                        phi_918_ = (_e701 - _e704);
                        phi_919_ = false;
                    } else {
                        phi_918_ = f32();
                        phi_919_ = true;
                    }
                    let _e707 = phi_918_;
                    let _e709 = phi_919_;
                    phi_920_ = _e707;
                    phi_921_ = _e709;
                } else {
                    phi_920_ = f32();
                    phi_921_ = true;
                }
                let _e711 = phi_920_;
                let _e713 = phi_921_;
                if _e713 {
                    phi_925_ = _e663;
                } else {
                    phi_925_ = _e711;
                }
                let _e715 = phi_925_;
                let _e716 = (_e662 - _e689);
                let _e717 = (_e663 - _e715);
                let _e726 = select(0i, select(select(i32(_e689), i32(-2147483648), (_e689 < bitcast<f32>(3472883712u))), 2147483647i, (_e689 > bitcast<f32>(1325400063u))), (_e689 == _e689));
                let _e735 = select(0i, select(select(i32(_e715), i32(-2147483648), (_e715 < bitcast<f32>(3472883712u))), 2147483647i, (_e715 > bitcast<f32>(1325400063u))), (_e715 == _e715));
                let _e738 = ((1f - _e716) * (1f - _e717));
                let _e740 = (_e716 * (1f - _e717));
                let _e742 = ((1f - _e716) * _e717);
                let _e743 = (_e716 * _e717);
                let _e745 = p.member.test;
                let _e746 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e745);
                let _e748 = p.member.map_size;
                let _e750 = local_3;
                local = _e746;
                let _e753 = ((_e750.level * _e748) * _e748);
                let _e755 = (bitcast<i32>(_e748) - 1i);
                if (_e726 > 0i) {
                    phi_974_ = _e726;
                } else {
                    phi_974_ = 0i;
                }
                let _e758 = phi_974_;
                if (_e735 > 0i) {
                    phi_979_ = _e735;
                } else {
                    phi_979_ = 0i;
                }
                let _e761 = phi_979_;
                if (_e758 < _e755) {
                    phi_984_ = _e758;
                } else {
                    phi_984_ = _e755;
                }
                let _e764 = phi_984_;
                if (_e761 < _e755) {
                    phi_989_ = _e761;
                } else {
                    phi_989_ = _e755;
                }
                let _e767 = phi_989_;
                let _e768 = bitcast<u32>(_e764);
                let _e770 = (_e726 + 1i);
                let _e771 = (_e735 + 1i);
                if (_e770 > 0i) {
                    phi_998_ = _e770;
                } else {
                    phi_998_ = 0i;
                }
                let _e774 = phi_998_;
                if (_e771 > 0i) {
                    phi_1003_ = _e771;
                } else {
                    phi_1003_ = 0i;
                }
                let _e777 = phi_1003_;
                if (_e774 < _e755) {
                    phi_1008_ = _e774;
                } else {
                    phi_1008_ = _e755;
                }
                let _e780 = phi_1008_;
                if (_e777 < _e755) {
                    phi_1013_ = _e777;
                } else {
                    phi_1013_ = _e755;
                }
                let _e783 = phi_1013_;
                let _e784 = bitcast<u32>(_e780);
                let _e786 = (bitcast<u32>(_e767) * _e748);
                let _e787 = (bitcast<u32>(_e783) * _e748);
                let _e792 = ((_e786 + _e768) + _e753);
                let _e793 = ((_e786 + _e784) + _e753);
                let _e794 = ((_e787 + _e768) + _e753);
                let _e795 = ((_e787 + _e784) + _e753);
                if (_e792 < _e48) {
                } else {
                    return;
                }
                let _e799 = map.member[(0u + _e792)];
                if (_e793 < _e48) {
                } else {
                    return;
                }
                let _e811 = map.member[(0u + _e793)];
                if (_e794 < _e48) {
                } else {
                    return;
                }
                let _e827 = map.member[(0u + _e794)];
                if (_e795 < _e48) {
                } else {
                    return;
                }
                let _e843 = map.member[(0u + _e795)];
                let _e857 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e799.x * _e738) + (_e811.x * _e740)) + (_e827.x * _e742)) + (_e843.x * _e743)), ((((_e799.y * _e738) + (_e811.y * _e740)) + (_e827.y * _e742)) + (_e843.y * _e743)), ((((_e799.z * _e738) + (_e811.z * _e740)) + (_e827.z * _e742)) + (_e843.z * _e743)), ((((_e799.w * _e738) + (_e811.w * _e740)) + (_e827.w * _e742)) + (_e843.w * _e743))), _e652);
                let _e859 = p.member.fade_uv;
                if (_e859 > 0f) {
                    let _e862 = local_4;
                    if ((_e862.level + 1u) == _e66) {
                        let _e871 = p.member.fade_uv;
                        let _e873 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e418.point.uv.x, (1f - _e418.point.uv.x));
                        let _e875 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e418.point.uv.y, (1f - _e418.point.uv.y));
                        let _e876 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e873, _e875);
                        if (_e876 < _e871) {
                            phi_1129_ = (1f - ((1f - _e857) * (_e876 / _e871)));
                        } else {
                            phi_1129_ = _e857;
                        }
                        let _e883 = phi_1129_;
                        phi_1131_ = evaluate_Verdict(_e883, false);
                        phi_1132_ = false;
                    } else {
                        phi_1131_ = evaluate_Verdict();
                        phi_1132_ = true;
                    }
                    let _e886 = phi_1131_;
                    let _e888 = phi_1132_;
                    phi_1133_ = _e886;
                    phi_1134_ = _e888;
                } else {
                    phi_1133_ = evaluate_Verdict();
                    phi_1134_ = true;
                }
                let _e890 = phi_1133_;
                let _e892 = phi_1134_;
                if _e892 {
                    phi_1139_ = evaluate_Verdict(_e857, false);
                    phi_1140_ = false;
                } else {
                    phi_1139_ = evaluate_Verdict();
                    phi_1140_ = true;
                }
                let _e895 = phi_1139_;
                let _e897 = phi_1140_;
                phi_1142_ = _e895;
                phi_1143_ = _e890;
                phi_1144_ = _e897;
            } else {
                phi_1142_ = evaluate_Verdict();
                phi_1143_ = evaluate_Verdict(1f, false);
                phi_1144_ = true;
            }
            let _e900 = phi_1142_;
            let _e902 = phi_1143_;
            let _e904 = phi_1144_;
            if _e904 {
            }
            phi_1148_ = _e902;
            phi_1149_ = _e900;
            phi_1150_ = _e904;
        }
        let _e906 = phi_1148_;
        let _e908 = phi_1149_;
        let _e910 = phi_1150_;
        if _e910 {
            phi_1154_ = _e906;
        } else {
            phi_1154_ = _e908;
        }
        let _e912 = phi_1154_;
        if (_e60.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e60.first_primitive)] = _e912.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_vsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
