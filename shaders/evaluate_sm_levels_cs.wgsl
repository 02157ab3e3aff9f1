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

struct type_31 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_37 {
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
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_144_: lt_bvh_traverse_Tree;
    var phi_145_: bool;
    var phi_146_: lt_bvh_traverse_Tree;
    var phi_147_: bool;
    var phi_152_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_144_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_145_ = false;
        } else {
            phi_144_ = lt_bvh_traverse_Tree();
            phi_145_ = true;
        }
        let _e51 = phi_144_;
        let _e53 = phi_145_;
        phi_146_ = _e51;
        phi_147_ = _e53;
    } else {
        phi_146_ = lt_bvh_traverse_Tree();
        phi_147_ = true;
    }
    let _e55 = phi_146_;
    let _e57 = phi_147_;
    if _e57 {
        phi_152_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_152_ = _e55;
    }
    let _e62 = phi_152_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_248_: f32;
    var phi_249_: f32;
    var phi_250_: f32;
    var phi_267_: f32;
    var phi_268_: f32;
    var phi_269_: f32;

    let _e42 = (*param_4);
    let _e43 = (param_5.x + _e42);
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_250_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_249_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_248_ = 1f;
            } else {
                phi_248_ = param_6;
            }
            let _e50 = phi_248_;
            phi_249_ = _e50;
        }
        let _e52 = phi_249_;
        phi_250_ = _e52;
    }
    let _e54 = phi_250_;
    if ((bitcast<u32>(_e43) & 2147483647u) > 2139095040u) {
        phi_269_ = _e43;
    } else {
        if ((bitcast<u32>(_e54) & 2147483647u) > 2139095040u) {
            phi_268_ = _e54;
        } else {
            if (_e43 < _e54) {
                phi_267_ = 0f;
            } else {
                phi_267_ = 1f;
            }
            let _e63 = phi_267_;
            phi_268_ = _e63;
        }
        let _e65 = phi_268_;
        phi_269_ = _e65;
    }
    let _e67 = phi_269_;
    return _e67;
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_7: f32) -> vec4<f32> {
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_225_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_225_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_224_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_223_ = 1f;
            } else {
                phi_223_ = param_7;
            }
            let _e45 = phi_223_;
            phi_224_ = _e45;
        }
        let _e47 = phi_224_;
        phi_225_ = _e47;
    }
    let _e49 = phi_225_;
    return vec4<f32>(_e49, 0f, 0f, 0f);
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_8: ptr<function, f32>, param_9: vec4<f32>, param_10: vec4<f32>, param_11: f32) -> f32 {
    var phi_186_: f32;
    var phi_187_: f32;
    var phi_195_: f32;
    var phi_196_: f32;
    var phi_203_: f32;
    var phi_206_: f32;

    let _e48 = (((param_10.x + param_10.y) + param_10.z) + param_10.w);
    if ((bitcast<u32>(_e48) & 2147483647u) > 2139095040u) {
        phi_206_ = _e48;
    } else {
        if (param_10.y > param_10.x) {
            phi_186_ = param_9.y;
            phi_187_ = param_10.y;
        } else {
            phi_186_ = param_9.x;
            phi_187_ = param_10.x;
        }
        let _e59 = phi_186_;
        let _e61 = phi_187_;
        if (param_10.z > _e61) {
            phi_195_ = param_9.z;
            phi_196_ = param_10.z;
        } else {
            phi_195_ = _e59;
            phi_196_ = _e61;
        }
        let _e67 = phi_195_;
        let _e69 = phi_196_;
        if (param_10.w > _e69) {
            phi_203_ = param_9.w;
        } else {
            phi_203_ = _e67;
        }
        let _e74 = phi_203_;
        let _e75 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e74);
        let _e76 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_8, _e75, param_11);
        phi_206_ = _e76;
    }
    let _e78 = phi_206_;
    return _e78;
}

fn function_() {
    var local: f32;
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_336_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_418_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_419_: bool;
    var phi_420_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_421_: bool;
    var phi_428_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_432_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_452_: lt_math_LightPoint;
    var phi_455_: u32;
    var phi_457_: lt_math_LevelPoint;
    var phi_543_: bool;
    var phi_552_: bool;
    var phi_561_: bool;
    var phi_562_: bool;
    var phi_563_: bool;
    var phi_564_: bool;
    var phi_565_: bool;
    var phi_566_: bool;
    var phi_567_: bool;
    var phi_571_: bool;
    var phi_598_: bool;
    var phi_599_: bool;
    var phi_600_: bool;
    var phi_601_: bool;
    var phi_602_: bool;
    var phi_603_: bool;
    var phi_604_: bool;
    var phi_605_: bool;
    var phi_609_: bool;
    var phi_618_: lt_math_LightPoint;
    var phi_619_: u32;
    var phi_620_: lt_math_LevelPoint;
    var phi_621_: bool;
    var phi_453_: lt_math_LightPoint;
    var phi_456_: u32;
    var phi_458_: lt_math_LevelPoint;
    var phi_622_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_669_: bool;
    var phi_751_: f32;
    var phi_867_: f32;
    var phi_868_: f32;
    var phi_871_: f32;
    var phi_900_: f32;
    var phi_905_: f32;
    var phi_906_: bool;
    var phi_907_: f32;
    var phi_908_: bool;
    var phi_912_: f32;
    var phi_932_: f32;
    var phi_937_: f32;
    var phi_938_: bool;
    var phi_939_: f32;
    var phi_940_: bool;
    var phi_944_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_993_: i32;
    var phi_998_: i32;
    var phi_1003_: i32;
    var phi_1008_: i32;
    var phi_1017_: i32;
    var phi_1022_: i32;
    var phi_1027_: i32;
    var phi_1032_: i32;
    var phi_1077_: evaluate_Verdict;
    var phi_1078_: evaluate_Verdict;
    var phi_1079_: bool;
    var phi_1080_: evaluate_Verdict;
    var phi_1081_: evaluate_Verdict;
    var phi_1082_: bool;
    var phi_1086_: evaluate_Verdict;

    let _e39 = id_1;
    let _e46 = arrayLength((&map.member));
    let _e52 = arrayLength((&levels.member));
    let _e55 = p.member.size[0u];
    let _e57 = p.member.size[1u];
    let _e58 = lt_shaders_entry_pixel_index(_e39, _e55, _e57);
    if (bitcast<i32>(_e58.root) != 0i) {
        let _e64 = p.member.level_count;
        if (_e58.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e71 = samples.member[(0u + _e58.first_primitive)].normal[0u];
        let _e73 = global[0u];
        if (_e71 == _e73) {
            let _e76 = samples.member[(0u + _e58.first_primitive)].normal[1u];
            let _e78 = global[1u];
            if (_e76 == _e78) {
                let _e81 = samples.member[(0u + _e58.first_primitive)].normal[2u];
                let _e83 = global[2u];
                phi_329_ = (_e81 == _e83);
                phi_330_ = false;
            } else {
                phi_329_ = bool();
                phi_330_ = true;
            }
            let _e86 = phi_329_;
            let _e88 = phi_330_;
            phi_331_ = _e86;
            phi_332_ = _e88;
        } else {
            phi_331_ = bool();
            phi_332_ = true;
        }
        let _e90 = phi_331_;
        let _e92 = phi_332_;
        if _e92 {
            phi_336_ = false;
        } else {
            phi_336_ = _e90;
        }
        let _e94 = phi_336_;
        if !(_e94) {
            let _e97 = samples.member[(0u + _e58.first_primitive)].position;
            let _e99 = p.member.light.place;
            let _e105 = p.member.light.place[3u];
            let _e112 = (_e99.x - (_e97.x * _e105));
            let _e113 = (_e99.y - (_e97.y * _e105));
            let _e114 = (_e99.z - (_e97.z * _e105));
            let _e116 = samples.member[(0u + _e58.first_primitive)].normal;
            if ((((_e116.x * _e112) + (_e116.y * _e113)) + (_e116.z * _e114)) > 0f) {
                let _e130 = (((_e112 * _e112) + (_e113 * _e113)) + (_e114 * _e114));
                let _e132 = p.member.light.axis;
                let _e144 = p.member.light.place[3u];
                if (_e144 == 0f) {
                    phi_407_ = true;
                } else {
                    let _e147 = p.member.light.range_squared;
                    if (_e130 <= _e147) {
                        let _e150 = p.member.light.cos_outer;
                        phi_406_ = (-((((_e112 * _e132.x) + (_e113 * _e132.y)) + (_e114 * _e132.z))) >= (_e150 * sqrt(_e130)));
                    } else {
                        phi_406_ = false;
                    }
                    let _e155 = phi_406_;
                    phi_407_ = _e155;
                }
                let _e157 = phi_407_;
                if _e157 {
                    let _e159 = samples.member[(0u + _e58.first_primitive)].flags;
                    let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
                    phi_418_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, ((_e159 & 1u) == 0u));
                    phi_419_ = false;
                } else {
                    phi_418_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_419_ = true;
                }
                let _e178 = phi_418_;
                let _e180 = phi_419_;
                phi_420_ = _e178;
                phi_421_ = _e180;
            } else {
                phi_420_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_421_ = true;
            }
            let _e182 = phi_420_;
            let _e184 = phi_421_;
            if _e184 {
                let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e190.unnamed.visibility, false), _e190.unnamed_1);
                phi_428_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e196.unnamed, true);
            } else {
                phi_428_ = _e182;
            }
            let _e201 = phi_428_;
            phi_432_ = _e201;
        } else {
            let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e207.unnamed.visibility, false), _e207.unnamed_1);
            phi_432_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e213.unnamed, true);
        }
        let _e218 = phi_432_;
        if _e218.unnamed_1 {
            phi_1080_ = evaluate_Verdict(_e218.unnamed.visibility, _e218.unnamed.is_doubted);
            phi_1081_ = evaluate_Verdict();
            phi_1082_ = true;
        } else {
            let _e226 = samples.member[(0u + _e58.first_primitive)].position;
            let _e228 = p.member.map_size;
            let _e230 = (0.5f / f32(_e228));
            let _e237 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e244 = lt_math_LightPoint(vec2<f32>(_e237.uv.x, 0f), _e237.depth, _e237.is_inside);
            let _e248 = lt_math_LightPoint(_e244.uv, 0f, _e244.is_inside);
            phi_452_ = lt_math_LightPoint();
            phi_455_ = 0u;
            phi_457_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e248.uv, _e248.depth, false));
            loop {
                let _e255 = phi_452_;
                let _e257 = phi_455_;
                let _e259 = phi_457_;
                local_1 = _e259;
                local_2 = _e259;
                local_3 = _e259;
                if (_e257 < _e64) {
                    if _e259.point.is_inside {
                        phi_618_ = lt_math_LightPoint();
                        phi_619_ = u32();
                        phi_620_ = lt_math_LevelPoint();
                        phi_621_ = false;
                    } else {
                        if (_e257 < _e52) {
                        } else {
                            return;
                        }
                        let _e270 = levels.member[(0u + _e257)].row_w;
                        let _e281 = ((((_e270.x * _e226.x) + (_e270.y * _e226.y)) + (_e270.z * _e226.z)) + (_e270.w * 1f));
                        let _e283 = levels.member[(0u + _e257)].row_x;
                        let _e295 = (((((_e283.x * _e226.x) + (_e283.y * _e226.y)) + (_e283.z * _e226.z)) + (_e283.w * 1f)) / _e281);
                        let _e297 = levels.member[(0u + _e257)].row_y;
                        let _e309 = (((((_e297.x * _e226.x) + (_e297.y * _e226.y)) + (_e297.z * _e226.z)) + (_e297.w * 1f)) / _e281);
                        let _e311 = levels.member[(0u + _e257)].row_z;
                        let _e322 = ((((_e311.x * _e226.x) + (_e311.y * _e226.y)) + (_e311.z * _e226.z)) + (_e311.w * 1f));
                        if (_e281 > 0f) {
                            if (_e295 >= 0f) {
                                phi_543_ = (_e295 <= 1f);
                            } else {
                                phi_543_ = false;
                            }
                            let _e327 = phi_543_;
                            if _e327 {
                                if (_e309 >= 0f) {
                                    phi_552_ = (_e309 <= 1f);
                                } else {
                                    phi_552_ = false;
                                }
                                let _e331 = phi_552_;
                                if _e331 {
                                    if (_e322 >= 0f) {
                                        phi_561_ = (_e322 <= 1f);
                                    } else {
                                        phi_561_ = false;
                                    }
                                    let _e335 = phi_561_;
                                    phi_562_ = _e335;
                                    phi_563_ = false;
                                } else {
                                    phi_562_ = bool();
                                    phi_563_ = true;
                                }
                                let _e337 = phi_562_;
                                let _e339 = phi_563_;
                                phi_564_ = _e337;
                                phi_565_ = _e339;
                            } else {
                                phi_564_ = bool();
                                phi_565_ = true;
                            }
                            let _e341 = phi_564_;
                            let _e343 = phi_565_;
                            phi_566_ = _e341;
                            phi_567_ = _e343;
                        } else {
                            phi_566_ = bool();
                            phi_567_ = true;
                        }
                        let _e345 = phi_566_;
                        let _e347 = phi_567_;
                        if _e347 {
                            phi_571_ = false;
                        } else {
                            phi_571_ = _e345;
                        }
                        let _e349 = phi_571_;
                        if _e349 {
                            if (_e295 >= _e230) {
                                if (_e295 <= (1f - _e230)) {
                                    if (_e309 >= _e230) {
                                        phi_598_ = (_e309 <= (1f - _e230));
                                        phi_599_ = false;
                                    } else {
                                        phi_598_ = bool();
                                        phi_599_ = true;
                                    }
                                    let _e357 = phi_598_;
                                    let _e359 = phi_599_;
                                    phi_600_ = _e357;
                                    phi_601_ = _e359;
                                } else {
                                    phi_600_ = bool();
                                    phi_601_ = true;
                                }
                                let _e361 = phi_600_;
                                let _e363 = phi_601_;
                                phi_602_ = _e361;
                                phi_603_ = _e363;
                            } else {
                                phi_602_ = bool();
                                phi_603_ = true;
                            }
                            let _e365 = phi_602_;
                            let _e367 = phi_603_;
                            phi_604_ = _e365;
                            phi_605_ = _e367;
                        } else {
                            phi_604_ = bool();
                            phi_605_ = true;
                        }
                        let _e369 = phi_604_;
                        let _e371 = phi_605_;
                        if _e371 {
                            phi_609_ = false;
                        } else {
                            phi_609_ = _e369;
                        }
                        let _e373 = phi_609_;
                        let _e380 = lt_math_LightPoint(vec2<f32>(_e295, _e255.uv.y), _e255.depth, _e255.is_inside);
                        let _e387 = lt_math_LightPoint(vec2<f32>(_e380.uv.x, _e309), _e380.depth, _e380.is_inside);
                        let _e391 = lt_math_LightPoint(_e387.uv, _e322, _e387.is_inside);
                        let _e395 = lt_math_LightPoint(_e391.uv, _e391.depth, _e373);
                        phi_618_ = _e395;
                        phi_619_ = (_e257 + 1u);
                        phi_620_ = lt_math_LevelPoint(_e257, _e395);
                        phi_621_ = true;
                    }
                    let _e399 = phi_618_;
                    let _e401 = phi_619_;
                    let _e403 = phi_620_;
                    let _e405 = phi_621_;
                    phi_453_ = _e399;
                    phi_456_ = _e401;
                    phi_458_ = _e403;
                    phi_622_ = _e405;
                } else {
                    phi_453_ = lt_math_LightPoint();
                    phi_456_ = u32();
                    phi_458_ = lt_math_LevelPoint();
                    phi_622_ = false;
                }
                let _e407 = phi_453_;
                let _e409 = phi_456_;
                let _e411 = phi_458_;
                let _e413 = phi_622_;
                continue;
                continuing {
                    phi_452_ = _e407;
                    phi_455_ = _e409;
                    phi_457_ = _e411;
                    break if !(_e413);
                }
            }
            let _e416 = local_1;
            if _e416.point.is_inside {
                if (0.5f > 0f) {
                    let _e422 = local_2;
                    if (_e422.level < _e52) {
                    } else {
                        return;
                    }
                    let _e427 = levels.member[(0u + _e422.level)];
                    let _e433 = global[0u];
                    if (_e427.row_w.x == _e433) {
                        let _e436 = global[1u];
                        if (_e427.row_w.y == _e436) {
                            let _e439 = global[2u];
                            phi_662_ = (_e427.row_w.z == _e439);
                            phi_663_ = false;
                        } else {
                            phi_662_ = bool();
                            phi_663_ = true;
                        }
                        let _e442 = phi_662_;
                        let _e444 = phi_663_;
                        phi_664_ = _e442;
                        phi_665_ = _e444;
                    } else {
                        phi_664_ = bool();
                        phi_665_ = true;
                    }
                    let _e446 = phi_664_;
                    let _e448 = phi_665_;
                    if _e448 {
                        phi_669_ = false;
                    } else {
                        phi_669_ = _e446;
                    }
                    let _e450 = phi_669_;
                    if _e450 {
                        let _e452 = samples.member[(0u + _e58.first_primitive)].normal;
                        let _e454 = p.member.map_size;
                        let _e524 = ((abs(((((_e427.row_x.x * _e452.x) + (_e427.row_x.y * _e452.y)) + (_e427.row_x.z * _e452.z)) / (((_e427.row_x.x * _e427.row_x.x) + (_e427.row_x.y * _e427.row_x.y)) + (_e427.row_x.z * _e427.row_x.z)))) + abs(((((_e427.row_y.x * _e452.x) + (_e427.row_y.y * _e452.y)) + (_e427.row_y.z * _e452.z)) / (((_e427.row_y.x * _e427.row_y.x) + (_e427.row_y.y * _e427.row_y.y)) + (_e427.row_y.z * _e427.row_y.z))))) / (abs(((((_e427.row_z.x * _e452.x) + (_e427.row_z.y * _e452.y)) + (_e427.row_z.z * _e452.z)) / (((_e427.row_z.x * _e427.row_z.x) + (_e427.row_z.y * _e427.row_z.y)) + (_e427.row_z.z * _e427.row_z.z)))) * f32(_e454)));
                        if (_e524 < 0.002f) {
                            phi_751_ = _e524;
                        } else {
                            phi_751_ = 0.002f;
                        }
                        let _e527 = phi_751_;
                        phi_868_ = _e527;
                    } else {
                        let _e529 = p.member.map_size;
                        let _e535 = samples.member[(0u + _e58.first_primitive)].position;
                        let _e546 = ((((_e427.row_w.x * _e535.x) + (_e427.row_w.y * _e535.y)) + (_e427.row_w.z * _e535.z)) + _e427.row_w.w);
                        let _e559 = ((_e427.row_x.x - (_e427.row_w.x * _e416.point.uv.x)) / _e546);
                        let _e560 = ((_e427.row_x.y - (_e427.row_w.y * _e416.point.uv.x)) / _e546);
                        let _e561 = ((_e427.row_x.z - (_e427.row_w.z * _e416.point.uv.x)) / _e546);
                        let _e574 = ((_e427.row_y.x - (_e427.row_w.x * _e416.point.uv.y)) / _e546);
                        let _e575 = ((_e427.row_y.y - (_e427.row_w.y * _e416.point.uv.y)) / _e546);
                        let _e576 = ((_e427.row_y.z - (_e427.row_w.z * _e416.point.uv.y)) / _e546);
                        let _e582 = samples.member[(0u + _e58.first_primitive)].normal;
                        let _e587 = ((_e575 * _e582.z) - (_e582.y * _e576));
                        let _e592 = ((_e576 * _e582.x) - (_e582.z * _e574));
                        let _e597 = ((_e574 * _e582.y) - (_e582.x * _e575));
                        let _e599 = samples.member[(0u + _e58.first_primitive)].normal;
                        let _e604 = ((_e560 * _e599.z) - (_e599.y * _e561));
                        let _e609 = ((_e561 * _e599.x) - (_e599.z * _e559));
                        let _e614 = ((_e559 * _e599.y) - (_e599.x * _e560));
                        let _e641 = ((abs(((((_e427.row_z.x * _e587) + (_e427.row_z.y * _e592)) + (_e427.row_z.z * _e597)) / (((_e559 * _e587) + (_e560 * _e592)) + (_e561 * _e597)))) + abs(((((_e427.row_z.x * _e604) + (_e427.row_z.y * _e609)) + (_e427.row_z.z * _e614)) / (((_e574 * _e604) + (_e575 * _e609)) + (_e576 * _e614))))) / f32(_e529));
                        if (_e641 < 0.002f) {
                            phi_867_ = _e641;
                        } else {
                            phi_867_ = 0.002f;
                        }
                        let _e644 = phi_867_;
                        phi_868_ = _e644;
                    }
                    let _e646 = phi_868_;
                    phi_871_ = (_e416.point.depth - (0.5f * _e646));
                } else {
                    phi_871_ = _e416.point.depth;
                }
                let _e650 = phi_871_;
                let _e656 = p.member.map_size;
                let _e657 = f32(_e656);
                let _e660 = ((_e416.point.uv.x * _e657) - 0.5f);
                let _e661 = ((_e416.point.uv.y * _e657) - 0.5f);
                if (_e660 > -8388608f) {
                    let _e673 = f32(select(0i, select(select(i32(_e660), i32(-2147483648), (_e660 < bitcast<f32>(3472883712u))), 2147483647i, (_e660 > bitcast<f32>(1325400063u))), (_e660 == _e660)));
                    if (_e673 > _e660) {
                        phi_900_ = 1f;
                    } else {
                        phi_900_ = 0f;
                    }
                    let _e676 = phi_900_;
                    if (_e660 < 8388608f) {
                        phi_905_ = (_e673 - _e676);
                        phi_906_ = false;
                    } else {
                        phi_905_ = f32();
                        phi_906_ = true;
                    }
                    let _e679 = phi_905_;
                    let _e681 = phi_906_;
                    phi_907_ = _e679;
                    phi_908_ = _e681;
                } else {
                    phi_907_ = f32();
                    phi_908_ = true;
                }
                let _e683 = phi_907_;
                let _e685 = phi_908_;
                if _e685 {
                    phi_912_ = _e660;
                } else {
                    phi_912_ = _e683;
                }
                let _e687 = phi_912_;
                if (_e661 > -8388608f) {
                    let _e699 = f32(select(0i, select(select(i32(_e661), i32(-2147483648), (_e661 < bitcast<f32>(3472883712u))), 2147483647i, (_e661 > bitcast<f32>(1325400063u))), (_e661 == _e661)));
                    if (_e699 > _e661) {
                        phi_932_ = 1f;
                    } else {
                        phi_932_ = 0f;
                    }
                    let _e702 = phi_932_;
                    if (_e661 < 8388608f) {
                        phi_937_ = (_e699 - _e702);
                        phi_938_ = false;
                    } else {
                        phi_937_ = f32();
                        phi_938_ = true;
                    }
                    let _e705 = phi_937_;
                    let _e707 = phi_938_;
                    phi_939_ = _e705;
                    phi_940_ = _e707;
                } else {
                    phi_939_ = f32();
                    phi_940_ = true;
                }
                let _e709 = phi_939_;
                let _e711 = phi_940_;
                if _e711 {
                    phi_944_ = _e661;
                } else {
                    phi_944_ = _e709;
                }
                let _e713 = phi_944_;
                let _e714 = (_e660 - _e687);
                let _e715 = (_e661 - _e713);
                let _e724 = select(0i, select(select(i32(_e687), i32(-2147483648), (_e687 < bitcast<f32>(3472883712u))), 2147483647i, (_e687 > bitcast<f32>(1325400063u))), (_e687 == _e687));
                let _e733 = select(0i, select(select(i32(_e713), i32(-2147483648), (_e713 < bitcast<f32>(3472883712u))), 2147483647i, (_e713 > bitcast<f32>(1325400063u))), (_e713 == _e713));
                let _e744 = p.member.test;
                let _e745 = _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e744);
                let _e747 = p.member.map_size;
                let _e749 = local_3;
                local = _e745;
                let _e752 = ((_e749.level * _e747) * _e747);
                let _e754 = (bitcast<i32>(_e747) - 1i);
                if (_e724 > 0i) {
                    phi_993_ = _e724;
                } else {
                    phi_993_ = 0i;
                }
                let _e757 = phi_993_;
                if (_e733 > 0i) {
                    phi_998_ = _e733;
                } else {
                    phi_998_ = 0i;
                }
                let _e760 = phi_998_;
                if (_e757 < _e754) {
                    phi_1003_ = _e757;
                } else {
                    phi_1003_ = _e754;
                }
                let _e763 = phi_1003_;
                if (_e760 < _e754) {
                    phi_1008_ = _e760;
                } else {
                    phi_1008_ = _e754;
                }
                let _e766 = phi_1008_;
                let _e767 = bitcast<u32>(_e763);
                let _e769 = (_e724 + 1i);
                let _e770 = (_e733 + 1i);
                if (_e769 > 0i) {
                    phi_1017_ = _e769;
                } else {
                    phi_1017_ = 0i;
                }
                let _e773 = phi_1017_;
                if (_e770 > 0i) {
                    phi_1022_ = _e770;
                } else {
                    phi_1022_ = 0i;
                }
                let _e776 = phi_1022_;
                if (_e773 < _e754) {
                    phi_1027_ = _e773;
                } else {
                    phi_1027_ = _e754;
                }
                let _e779 = phi_1027_;
                if (_e776 < _e754) {
                    phi_1032_ = _e776;
                } else {
                    phi_1032_ = _e754;
                }
                let _e782 = phi_1032_;
                let _e783 = bitcast<u32>(_e779);
                let _e785 = (bitcast<u32>(_e766) * _e747);
                let _e786 = (bitcast<u32>(_e782) * _e747);
                let _e791 = ((_e785 + _e767) + _e752);
                let _e792 = ((_e785 + _e783) + _e752);
                let _e793 = ((_e786 + _e767) + _e752);
                let _e794 = ((_e786 + _e783) + _e752);
                if (_e791 < _e46) {
                } else {
                    return;
                }
                let _e798 = map.member[(0u + _e791)];
                if (_e792 < _e46) {
                } else {
                    return;
                }
                let _e802 = map.member[(0u + _e792)];
                if (_e793 < _e46) {
                } else {
                    return;
                }
                let _e806 = map.member[(0u + _e793)];
                if (_e794 < _e46) {
                } else {
                    return;
                }
                let _e810 = map.member[(0u + _e794)];
                let _e812 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e798, _e802, _e806, _e810), vec4<f32>(((1f - _e714) * (1f - _e715)), (_e714 * (1f - _e715)), ((1f - _e714) * _e715), (_e714 * _e715)), _e650);
                phi_1077_ = evaluate_Verdict(_e812, false);
                phi_1078_ = evaluate_Verdict();
                phi_1079_ = false;
            } else {
                phi_1077_ = evaluate_Verdict();
                phi_1078_ = evaluate_Verdict(1f, false);
                phi_1079_ = true;
            }
            let _e816 = phi_1077_;
            let _e818 = phi_1078_;
            let _e820 = phi_1079_;
            phi_1080_ = _e818;
            phi_1081_ = _e816;
            phi_1082_ = _e820;
        }
        let _e822 = phi_1080_;
        let _e824 = phi_1081_;
        let _e826 = phi_1082_;
        if _e826 {
            phi_1086_ = _e822;
        } else {
            phi_1086_ = _e824;
        }
        let _e828 = phi_1086_;
        if (_e58.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e58.first_primitive)] = _e828.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_sm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
