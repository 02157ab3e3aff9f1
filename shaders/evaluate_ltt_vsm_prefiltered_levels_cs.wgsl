struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct type_9 {
    member: array<u32>,
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

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
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

struct type_39 {
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

struct type_43 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_49 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct type_55 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_5: u32;
@group(0) @binding(1) 
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_55;
@group(0) @binding(5) 
var<storage> levels: type_49;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_164_: lt_bvh_traverse_Tree;
    var phi_165_: bool;
    var phi_166_: lt_bvh_traverse_Tree;
    var phi_167_: bool;
    var phi_172_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_164_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_165_ = false;
        } else {
            phi_164_ = lt_bvh_traverse_Tree();
            phi_165_ = true;
        }
        let _e57 = phi_164_;
        let _e59 = phi_165_;
        phi_166_ = _e57;
        phi_167_ = _e59;
    } else {
        phi_166_ = lt_bvh_traverse_Tree();
        phi_167_ = true;
    }
    let _e61 = phi_166_;
    let _e63 = phi_167_;
    if _e63 {
        phi_172_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_172_ = _e61;
    }
    let _e68 = phi_172_;
    return lt_bvh_traverse_Tree(_e68.root, _e68.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_197_: f32;
    var phi_198_: f32;
    var phi_199_: f32;
    var phi_217_: bool;
    var phi_221_: f32;
    var phi_233_: bool;
    var phi_240_: f32;
    var phi_255_: f32;
    var phi_256_: f32;
    var phi_257_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_199_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_198_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_197_ = 1f;
            } else {
                phi_197_ = param_6;
            }
            let _e53 = phi_197_;
            phi_198_ = _e53;
        }
        let _e55 = phi_198_;
        phi_199_ = _e55;
    }
    let _e57 = phi_199_;
    let _e60 = (*param_4);
    let _e64 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e60) & 2147483647u) > 2139095040u) {
        phi_217_ = true;
    } else {
        let _e68 = (_e60 > _e64);
        if _e68 {
        }
        phi_217_ = _e68;
    }
    let _e70 = phi_217_;
    if _e70 {
        phi_221_ = _e60;
    } else {
        phi_221_ = _e64;
    }
    let _e72 = phi_221_;
    let _e73 = (_e57 - param_5.x);
    if (_e73 <= 0f) {
        let _e77 = ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u);
        if _e77 {
        }
        phi_233_ = _e77;
    } else {
        phi_233_ = true;
    }
    let _e79 = phi_233_;
    if _e79 {
        phi_240_ = (_e72 / (_e72 + (_e73 * _e73)));
    } else {
        phi_240_ = 1f;
    }
    let _e84 = phi_240_;
    if ((bitcast<u32>(_e84) & 2147483647u) > 2139095040u) {
        phi_257_ = _e84;
    } else {
        if (_e84 < 0f) {
            phi_256_ = 0f;
        } else {
            if (_e84 > 1f) {
                phi_255_ = 1f;
            } else {
                phi_255_ = _e84;
            }
            let _e91 = phi_255_;
            phi_256_ = _e91;
        }
        let _e93 = phi_256_;
        phi_257_ = _e93;
    }
    let _e95 = phi_257_;
    return _e95;
}

fn function_() {
    var local_1: f32;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_314_: bool;
    var phi_315_: bool;
    var phi_319_: bool;
    var phi_389_: bool;
    var phi_390_: bool;
    var phi_401_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_402_: bool;
    var phi_403_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_404_: bool;
    var phi_411_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_415_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_435_: lt_math_LightPoint;
    var phi_438_: u32;
    var phi_440_: lt_math_LevelPoint;
    var phi_526_: bool;
    var phi_535_: bool;
    var phi_544_: bool;
    var phi_545_: bool;
    var phi_546_: bool;
    var phi_547_: bool;
    var phi_548_: bool;
    var phi_549_: bool;
    var phi_550_: bool;
    var phi_554_: bool;
    var phi_581_: bool;
    var phi_582_: bool;
    var phi_583_: bool;
    var phi_584_: bool;
    var phi_585_: bool;
    var phi_586_: bool;
    var phi_587_: bool;
    var phi_588_: bool;
    var phi_592_: bool;
    var phi_601_: lt_math_LightPoint;
    var phi_602_: u32;
    var phi_603_: lt_math_LevelPoint;
    var phi_604_: bool;
    var phi_436_: lt_math_LightPoint;
    var phi_439_: u32;
    var phi_441_: lt_math_LevelPoint;
    var phi_605_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_652_: bool;
    var phi_734_: f32;
    var phi_852_: f32;
    var phi_853_: f32;
    var phi_856_: f32;
    var phi_885_: f32;
    var phi_890_: f32;
    var phi_891_: bool;
    var phi_892_: f32;
    var phi_893_: bool;
    var phi_897_: f32;
    var phi_917_: f32;
    var phi_922_: f32;
    var phi_923_: bool;
    var phi_924_: f32;
    var phi_925_: bool;
    var phi_929_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_978_: i32;
    var phi_983_: i32;
    var phi_988_: i32;
    var phi_993_: i32;
    var phi_1002_: i32;
    var phi_1007_: i32;
    var phi_1012_: i32;
    var phi_1017_: i32;
    var phi_1112_: bool;
    var phi_1120_: bool;
    var phi_1132_: bool;
    var phi_1133_: bool;
    var phi_1137_: f32;
    var phi_1143_: f32;
    var phi_1145_: evaluate_Verdict;
    var phi_1150_: evaluate_Verdict;
    var phi_1151_: evaluate_Verdict;
    var phi_1155_: bool;
    var phi_1156_: u32;
    var phi_1167_: u32;

    let _e45 = id_1;
    let _e46 = local_5;
    let _e51 = arrayLength((&map.member));
    let _e56 = arrayLength((&levels.member));
    let _e59 = p.member.size[0u];
    let _e61 = p.member.size[1u];
    let _e62 = lt_shaders_entry_pixel_index(_e45, _e59, _e61);
    if (bitcast<i32>(_e62.root) != 0i) {
        let _e69 = p.member.level_count;
        let _e73 = samples.member[_e62.first_primitive].normal[0u];
        let _e75 = global[0u];
        if (_e73 == _e75) {
            let _e78 = samples.member[_e62.first_primitive].normal[1u];
            let _e80 = global[1u];
            if (_e78 == _e80) {
                let _e83 = samples.member[_e62.first_primitive].normal[2u];
                let _e85 = global[2u];
                phi_312_ = (_e83 == _e85);
                phi_313_ = false;
            } else {
                phi_312_ = bool();
                phi_313_ = true;
            }
            let _e88 = phi_312_;
            let _e90 = phi_313_;
            phi_314_ = _e88;
            phi_315_ = _e90;
        } else {
            phi_314_ = bool();
            phi_315_ = true;
        }
        let _e92 = phi_314_;
        let _e94 = phi_315_;
        if _e94 {
            phi_319_ = false;
        } else {
            phi_319_ = _e92;
        }
        let _e96 = phi_319_;
        if !(_e96) {
            let _e99 = samples.member[_e62.first_primitive].position;
            let _e101 = p.member.light.place;
            let _e107 = p.member.light.place[3u];
            let _e114 = (_e101.x - (_e99.x * _e107));
            let _e115 = (_e101.y - (_e99.y * _e107));
            let _e116 = (_e101.z - (_e99.z * _e107));
            let _e118 = samples.member[_e62.first_primitive].normal;
            if ((((_e118.x * _e114) + (_e118.y * _e115)) + (_e118.z * _e116)) > 0f) {
                let _e132 = (((_e114 * _e114) + (_e115 * _e115)) + (_e116 * _e116));
                let _e134 = p.member.light.axis;
                let _e146 = p.member.light.place[3u];
                if (_e146 == 0f) {
                    phi_390_ = true;
                } else {
                    let _e149 = p.member.light.range_squared;
                    if (_e132 <= _e149) {
                        let _e152 = p.member.light.cos_outer;
                        phi_389_ = (-((((_e114 * _e134.x) + (_e115 * _e134.y)) + (_e116 * _e134.z))) >= (_e152 * sqrt(_e132)));
                    } else {
                        phi_389_ = false;
                    }
                    let _e157 = phi_389_;
                    phi_390_ = _e157;
                }
                let _e159 = phi_390_;
                if _e159 {
                    let _e161 = samples.member[_e62.first_primitive].flags;
                    let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e169.unnamed.visibility, false), _e169.unnamed_1);
                    phi_401_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e175.unnamed, ((_e161 & 1u) == 0u));
                    phi_402_ = false;
                } else {
                    phi_401_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_402_ = true;
                }
                let _e180 = phi_401_;
                let _e182 = phi_402_;
                phi_403_ = _e180;
                phi_404_ = _e182;
            } else {
                phi_403_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_404_ = true;
            }
            let _e184 = phi_403_;
            let _e186 = phi_404_;
            if _e186 {
                let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e192.unnamed.visibility, false), _e192.unnamed_1);
                phi_411_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e198.unnamed, true);
            } else {
                phi_411_ = _e184;
            }
            let _e203 = phi_411_;
            phi_415_ = _e203;
        } else {
            let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e209.unnamed.visibility, false), _e209.unnamed_1);
            phi_415_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e215.unnamed, true);
        }
        let _e220 = phi_415_;
        if _e220.unnamed_1 {
            phi_1151_ = evaluate_Verdict(_e220.unnamed.visibility, _e220.unnamed.is_doubted);
        } else {
            let _e228 = samples.member[_e62.first_primitive].position;
            let _e230 = p.member.map_size;
            let _e232 = (0.5f / f32(_e230));
            let _e239 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e246 = lt_math_LightPoint(vec2<f32>(_e239.uv.x, 0f), _e239.depth, _e239.is_inside);
            let _e250 = lt_math_LightPoint(_e246.uv, 0f, _e246.is_inside);
            phi_435_ = lt_math_LightPoint();
            phi_438_ = 0u;
            phi_440_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e250.uv, _e250.depth, false));
            loop {
                let _e257 = phi_435_;
                let _e259 = phi_438_;
                let _e261 = phi_440_;
                local_2 = _e261;
                local_3 = _e261;
                local_4 = _e261;
                if (_e259 < _e69) {
                    if _e261.point.is_inside {
                        phi_601_ = lt_math_LightPoint();
                        phi_602_ = u32();
                        phi_603_ = lt_math_LevelPoint();
                        phi_604_ = false;
                    } else {
                        if (_e259 < _e56) {
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
                                phi_526_ = (_e297 <= 1f);
                            } else {
                                phi_526_ = false;
                            }
                            let _e329 = phi_526_;
                            if _e329 {
                                if (_e311 >= 0f) {
                                    phi_535_ = (_e311 <= 1f);
                                } else {
                                    phi_535_ = false;
                                }
                                let _e333 = phi_535_;
                                if _e333 {
                                    if (_e324 >= 0f) {
                                        phi_544_ = (_e324 <= 1f);
                                    } else {
                                        phi_544_ = false;
                                    }
                                    let _e337 = phi_544_;
                                    phi_545_ = _e337;
                                    phi_546_ = false;
                                } else {
                                    phi_545_ = bool();
                                    phi_546_ = true;
                                }
                                let _e339 = phi_545_;
                                let _e341 = phi_546_;
                                phi_547_ = _e339;
                                phi_548_ = _e341;
                            } else {
                                phi_547_ = bool();
                                phi_548_ = true;
                            }
                            let _e343 = phi_547_;
                            let _e345 = phi_548_;
                            phi_549_ = _e343;
                            phi_550_ = _e345;
                        } else {
                            phi_549_ = bool();
                            phi_550_ = true;
                        }
                        let _e347 = phi_549_;
                        let _e349 = phi_550_;
                        if _e349 {
                            phi_554_ = false;
                        } else {
                            phi_554_ = _e347;
                        }
                        let _e351 = phi_554_;
                        if _e351 {
                            if (_e297 >= _e232) {
                                if (_e297 <= (1f - _e232)) {
                                    if (_e311 >= _e232) {
                                        phi_581_ = (_e311 <= (1f - _e232));
                                        phi_582_ = false;
                                    } else {
                                        phi_581_ = bool();
                                        phi_582_ = true;
                                    }
                                    let _e359 = phi_581_;
                                    let _e361 = phi_582_;
                                    phi_583_ = _e359;
                                    phi_584_ = _e361;
                                } else {
                                    phi_583_ = bool();
                                    phi_584_ = true;
                                }
                                let _e363 = phi_583_;
                                let _e365 = phi_584_;
                                phi_585_ = _e363;
                                phi_586_ = _e365;
                            } else {
                                phi_585_ = bool();
                                phi_586_ = true;
                            }
                            let _e367 = phi_585_;
                            let _e369 = phi_586_;
                            phi_587_ = _e367;
                            phi_588_ = _e369;
                        } else {
                            phi_587_ = bool();
                            phi_588_ = true;
                        }
                        let _e371 = phi_587_;
                        let _e373 = phi_588_;
                        if _e373 {
                            phi_592_ = false;
                        } else {
                            phi_592_ = _e371;
                        }
                        let _e375 = phi_592_;
                        let _e382 = lt_math_LightPoint(vec2<f32>(_e297, _e257.uv.y), _e257.depth, _e257.is_inside);
                        let _e389 = lt_math_LightPoint(vec2<f32>(_e382.uv.x, _e311), _e382.depth, _e382.is_inside);
                        let _e393 = lt_math_LightPoint(_e389.uv, _e324, _e389.is_inside);
                        let _e397 = lt_math_LightPoint(_e393.uv, _e393.depth, _e375);
                        phi_601_ = _e397;
                        phi_602_ = (_e259 + 1u);
                        phi_603_ = lt_math_LevelPoint(_e259, _e397);
                        phi_604_ = true;
                    }
                    let _e401 = phi_601_;
                    let _e403 = phi_602_;
                    let _e405 = phi_603_;
                    let _e407 = phi_604_;
                    phi_436_ = _e401;
                    phi_439_ = _e403;
                    phi_441_ = _e405;
                    phi_605_ = _e407;
                } else {
                    phi_436_ = lt_math_LightPoint();
                    phi_439_ = u32();
                    phi_441_ = lt_math_LevelPoint();
                    phi_605_ = false;
                }
                let _e409 = phi_436_;
                let _e411 = phi_439_;
                let _e413 = phi_441_;
                let _e415 = phi_605_;
                continue;
                continuing {
                    phi_435_ = _e409;
                    phi_438_ = _e411;
                    phi_440_ = _e413;
                    break if !(_e415);
                }
            }
            let _e418 = local_2;
            if _e418.point.is_inside {
                if (0f > 0f) {
                    let _e424 = local_3;
                    if (_e424.level < _e56) {
                    } else {
                        return;
                    }
                    let _e429 = levels.member[(0u + _e424.level)];
                    let _e435 = global[0u];
                    if (_e429.row_w.x == _e435) {
                        let _e438 = global[1u];
                        if (_e429.row_w.y == _e438) {
                            let _e441 = global[2u];
                            phi_645_ = (_e429.row_w.z == _e441);
                            phi_646_ = false;
                        } else {
                            phi_645_ = bool();
                            phi_646_ = true;
                        }
                        let _e444 = phi_645_;
                        let _e446 = phi_646_;
                        phi_647_ = _e444;
                        phi_648_ = _e446;
                    } else {
                        phi_647_ = bool();
                        phi_648_ = true;
                    }
                    let _e448 = phi_647_;
                    let _e450 = phi_648_;
                    if _e450 {
                        phi_652_ = false;
                    } else {
                        phi_652_ = _e448;
                    }
                    let _e452 = phi_652_;
                    if _e452 {
                        let _e454 = samples.member[_e62.first_primitive].normal;
                        let _e456 = p.member.map_size;
                        let _e526 = ((abs(((((_e429.row_x.x * _e454.x) + (_e429.row_x.y * _e454.y)) + (_e429.row_x.z * _e454.z)) / (((_e429.row_x.x * _e429.row_x.x) + (_e429.row_x.y * _e429.row_x.y)) + (_e429.row_x.z * _e429.row_x.z)))) + abs(((((_e429.row_y.x * _e454.x) + (_e429.row_y.y * _e454.y)) + (_e429.row_y.z * _e454.z)) / (((_e429.row_y.x * _e429.row_y.x) + (_e429.row_y.y * _e429.row_y.y)) + (_e429.row_y.z * _e429.row_y.z))))) / (abs(((((_e429.row_z.x * _e454.x) + (_e429.row_z.y * _e454.y)) + (_e429.row_z.z * _e454.z)) / (((_e429.row_z.x * _e429.row_z.x) + (_e429.row_z.y * _e429.row_z.y)) + (_e429.row_z.z * _e429.row_z.z)))) * f32(_e456)));
                        if (_e526 < 0.002f) {
                            phi_734_ = _e526;
                        } else {
                            phi_734_ = 0.002f;
                        }
                        let _e529 = phi_734_;
                        phi_853_ = _e529;
                    } else {
                        let _e531 = p.member.map_size;
                        let _e537 = samples.member[_e62.first_primitive].position;
                        let _e548 = ((((_e429.row_w.x * _e537.x) + (_e429.row_w.y * _e537.y)) + (_e429.row_w.z * _e537.z)) + _e429.row_w.w);
                        let _e561 = ((_e429.row_x.x - (_e429.row_w.x * _e418.point.uv.x)) / _e548);
                        let _e562 = ((_e429.row_x.y - (_e429.row_w.y * _e418.point.uv.x)) / _e548);
                        let _e563 = ((_e429.row_x.z - (_e429.row_w.z * _e418.point.uv.x)) / _e548);
                        let _e576 = ((_e429.row_y.x - (_e429.row_w.x * _e418.point.uv.y)) / _e548);
                        let _e577 = ((_e429.row_y.y - (_e429.row_w.y * _e418.point.uv.y)) / _e548);
                        let _e578 = ((_e429.row_y.z - (_e429.row_w.z * _e418.point.uv.y)) / _e548);
                        let _e584 = samples.member[_e62.first_primitive].normal;
                        let _e589 = ((_e577 * _e584.z) - (_e584.y * _e578));
                        let _e594 = ((_e578 * _e584.x) - (_e584.z * _e576));
                        let _e599 = ((_e576 * _e584.y) - (_e584.x * _e577));
                        let _e601 = samples.member[_e62.first_primitive].normal;
                        let _e606 = ((_e562 * _e601.z) - (_e601.y * _e563));
                        let _e611 = ((_e563 * _e601.x) - (_e601.z * _e561));
                        let _e616 = ((_e561 * _e601.y) - (_e601.x * _e562));
                        let _e643 = ((abs(((((_e429.row_z.x * _e589) + (_e429.row_z.y * _e594)) + (_e429.row_z.z * _e599)) / (((_e561 * _e589) + (_e562 * _e594)) + (_e563 * _e599)))) + abs(((((_e429.row_z.x * _e606) + (_e429.row_z.y * _e611)) + (_e429.row_z.z * _e616)) / (((_e576 * _e606) + (_e577 * _e611)) + (_e578 * _e616))))) / f32(_e531));
                        let _e645 = (16f / f32(_e531));
                        if (_e643 < _e645) {
                            phi_852_ = _e643;
                        } else {
                            phi_852_ = _e645;
                        }
                        let _e648 = phi_852_;
                        phi_853_ = _e648;
                    }
                    let _e650 = phi_853_;
                    phi_856_ = (_e418.point.depth - (0f * _e650));
                } else {
                    phi_856_ = _e418.point.depth;
                }
                let _e654 = phi_856_;
                let _e660 = p.member.map_size;
                let _e661 = f32(_e660);
                let _e664 = ((_e418.point.uv.x * _e661) - 0.5f);
                let _e665 = ((_e418.point.uv.y * _e661) - 0.5f);
                if (_e664 > -8388608f) {
                    let _e677 = f32(select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < bitcast<f32>(3472883712u))), 2147483647i, (_e664 > bitcast<f32>(1325400063u))), (_e664 == _e664)));
                    if (_e677 > _e664) {
                        phi_885_ = 1f;
                    } else {
                        phi_885_ = 0f;
                    }
                    let _e680 = phi_885_;
                    if (_e664 < 8388608f) {
                        phi_890_ = (_e677 - _e680);
                        phi_891_ = false;
                    } else {
                        phi_890_ = f32();
                        phi_891_ = true;
                    }
                    let _e683 = phi_890_;
                    let _e685 = phi_891_;
                    phi_892_ = _e683;
                    phi_893_ = _e685;
                } else {
                    phi_892_ = f32();
                    phi_893_ = true;
                }
                let _e687 = phi_892_;
                let _e689 = phi_893_;
                if _e689 {
                    phi_897_ = _e664;
                } else {
                    phi_897_ = _e687;
                }
                let _e691 = phi_897_;
                if (_e665 > -8388608f) {
                    let _e703 = f32(select(0i, select(select(i32(_e665), i32(-2147483648), (_e665 < bitcast<f32>(3472883712u))), 2147483647i, (_e665 > bitcast<f32>(1325400063u))), (_e665 == _e665)));
                    if (_e703 > _e665) {
                        phi_917_ = 1f;
                    } else {
                        phi_917_ = 0f;
                    }
                    let _e706 = phi_917_;
                    if (_e665 < 8388608f) {
                        phi_922_ = (_e703 - _e706);
                        phi_923_ = false;
                    } else {
                        phi_922_ = f32();
                        phi_923_ = true;
                    }
                    let _e709 = phi_922_;
                    let _e711 = phi_923_;
                    phi_924_ = _e709;
                    phi_925_ = _e711;
                } else {
                    phi_924_ = f32();
                    phi_925_ = true;
                }
                let _e713 = phi_924_;
                let _e715 = phi_925_;
                if _e715 {
                    phi_929_ = _e665;
                } else {
                    phi_929_ = _e713;
                }
                let _e717 = phi_929_;
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
                let _e752 = local_4;
                local_1 = _e748;
                let _e755 = ((_e752.level * _e750) * _e750);
                let _e757 = (bitcast<i32>(_e750) - 1i);
                if (_e728 > 0i) {
                    phi_978_ = _e728;
                } else {
                    phi_978_ = 0i;
                }
                let _e760 = phi_978_;
                if (_e737 > 0i) {
                    phi_983_ = _e737;
                } else {
                    phi_983_ = 0i;
                }
                let _e763 = phi_983_;
                if (_e760 < _e757) {
                    phi_988_ = _e760;
                } else {
                    phi_988_ = _e757;
                }
                let _e766 = phi_988_;
                if (_e763 < _e757) {
                    phi_993_ = _e763;
                } else {
                    phi_993_ = _e757;
                }
                let _e769 = phi_993_;
                let _e770 = bitcast<u32>(_e766);
                let _e772 = (_e728 + 1i);
                let _e773 = (_e737 + 1i);
                if (_e772 > 0i) {
                    phi_1002_ = _e772;
                } else {
                    phi_1002_ = 0i;
                }
                let _e776 = phi_1002_;
                if (_e773 > 0i) {
                    phi_1007_ = _e773;
                } else {
                    phi_1007_ = 0i;
                }
                let _e779 = phi_1007_;
                if (_e776 < _e757) {
                    phi_1012_ = _e776;
                } else {
                    phi_1012_ = _e757;
                }
                let _e782 = phi_1012_;
                if (_e779 < _e757) {
                    phi_1017_ = _e779;
                } else {
                    phi_1017_ = _e757;
                }
                let _e785 = phi_1017_;
                let _e786 = bitcast<u32>(_e782);
                let _e788 = (bitcast<u32>(_e769) * _e750);
                let _e789 = (bitcast<u32>(_e785) * _e750);
                let _e794 = ((_e788 + _e770) + _e755);
                let _e795 = ((_e788 + _e786) + _e755);
                let _e796 = ((_e789 + _e770) + _e755);
                let _e797 = ((_e789 + _e786) + _e755);
                if (_e794 < _e51) {
                } else {
                    return;
                }
                let _e801 = map.member[(0u + _e794)];
                if (_e795 < _e51) {
                } else {
                    return;
                }
                let _e813 = map.member[(0u + _e795)];
                if (_e796 < _e51) {
                } else {
                    return;
                }
                let _e829 = map.member[(0u + _e796)];
                if (_e797 < _e51) {
                } else {
                    return;
                }
                let _e845 = map.member[(0u + _e797)];
                let _e859 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e801.x * _e740) + (_e813.x * _e742)) + (_e829.x * _e744)) + (_e845.x * _e745)), ((((_e801.y * _e740) + (_e813.y * _e742)) + (_e829.y * _e744)) + (_e845.y * _e745)), ((((_e801.z * _e740) + (_e813.z * _e742)) + (_e829.z * _e744)) + (_e845.z * _e745)), ((((_e801.w * _e740) + (_e813.w * _e742)) + (_e829.w * _e744)) + (_e845.w * _e745))), _e654);
                let _e861 = p.member.epsilon;
                if (_e859 <= _e861) {
                    phi_1112_ = true;
                } else {
                    phi_1112_ = (_e859 >= (1f - _e861));
                }
                let _e866 = phi_1112_;
                if ((bitcast<u32>(_e859) & 2147483647u) > 2139095040u) {
                    phi_1120_ = true;
                } else {
                    phi_1120_ = !(_e866);
                }
                let _e872 = phi_1120_;
                if _e872 {
                    if (_e859 > 0f) {
                        if (_e859 < 1f) {
                            phi_1132_ = false;
                        } else {
                            phi_1132_ = true;
                        }
                        let _e876 = phi_1132_;
                        phi_1133_ = _e876;
                    } else {
                        phi_1133_ = true;
                    }
                    let _e878 = phi_1133_;
                    if _e878 {
                        phi_1137_ = 0.5f;
                    } else {
                        phi_1137_ = _e859;
                    }
                    let _e880 = phi_1137_;
                    phi_1145_ = evaluate_Verdict(_e880, true);
                } else {
                    if (_e859 > 0.5f) {
                        phi_1143_ = 1f;
                    } else {
                        phi_1143_ = 0f;
                    }
                    let _e884 = phi_1143_;
                    phi_1145_ = evaluate_Verdict(_e884, false);
                }
                let _e887 = phi_1145_;
                phi_1150_ = evaluate_Verdict(_e887.visibility, _e887.is_doubted);
            } else {
                phi_1150_ = evaluate_Verdict(0.5f, true);
            }
            let _e893 = phi_1150_;
            phi_1151_ = _e893;
        }
        let _e895 = phi_1151_;
        visibility.member[_e62.first_primitive] = _e895.visibility;
        phi_1155_ = _e895.is_doubted;
        phi_1156_ = _e62.first_primitive;
    } else {
        phi_1155_ = false;
        phi_1156_ = 0u;
    }
    let _e900 = phi_1155_;
    let _e902 = phi_1156_;
    if (_e46 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e900 {
        let _e906 = atomicAdd((&shared_[0u]), 1u);
        phi_1167_ = _e906;
    } else {
        phi_1167_ = 0u;
    }
    let _e908 = phi_1167_;
    workgroupBarrier();
    if (_e46 == 0u) {
        let _e912 = atomicLoad((&shared_[0u]));
        let _e913 = atomicAdd((&list.member[3u]), _e912);
        atomicStore((&shared_[1u]), _e913);
    }
    workgroupBarrier();
    if _e900 {
        let _e916 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e916) + _e908)]), _e902);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
