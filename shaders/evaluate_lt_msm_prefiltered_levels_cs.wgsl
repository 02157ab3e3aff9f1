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
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_41;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_150_: lt_bvh_traverse_Tree;
    var phi_151_: bool;
    var phi_152_: lt_bvh_traverse_Tree;
    var phi_153_: bool;
    var phi_158_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_150_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_151_ = false;
        } else {
            phi_150_ = lt_bvh_traverse_Tree();
            phi_151_ = true;
        }
        let _e53 = phi_150_;
        let _e55 = phi_151_;
        phi_152_ = _e53;
        phi_153_ = _e55;
    } else {
        phi_152_ = lt_bvh_traverse_Tree();
        phi_153_ = true;
    }
    let _e57 = phi_152_;
    let _e59 = phi_153_;
    if _e59 {
        phi_158_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_158_ = _e57;
    }
    let _e64 = phi_158_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_207_: f32;
    var phi_208_: f32;
    var phi_209_: f32;
    var phi_215_: bool;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_239_: f32;
    var phi_240_: f32;
    var phi_241_: bool;
    var phi_242_: f32;
    var phi_243_: bool;
    var phi_281_: vec2<f32>;
    var phi_315_: f32;
    var phi_316_: f32;
    var phi_317_: f32;
    var phi_346_: f32;
    var phi_347_: f32;
    var phi_348_: f32;
    var phi_352_: f32;
    var phi_353_: f32;
    var phi_354_: f32;
    var phi_355_: f32;

    let _e43 = (*param_4);
    let _e44 = (1f - _e43);
    let _e53 = (0.5f * _e43);
    let _e54 = ((param_5.x * _e44) + _e53);
    let _e55 = ((param_5.y * _e44) + _e53);
    let _e57 = ((param_5.w * _e44) + _e53);
    let _e59 = (_e55 - (_e54 * _e54));
    let _e61 = (((param_5.z * _e44) + _e53) - (_e54 * _e55));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_209_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_208_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_207_ = 1f;
            } else {
                phi_207_ = param_6;
            }
            let _e73 = phi_207_;
            phi_208_ = _e73;
        }
        let _e75 = phi_208_;
        phi_209_ = _e75;
    }
    let _e77 = phi_209_;
    if (_e54 == _e57) {
        phi_215_ = (_e54 > 0.5f);
    } else {
        phi_215_ = false;
    }
    let _e81 = phi_215_;
    if _e81 {
        if (_e77 > 0f) {
            if ((bitcast<u32>(_e54) & 2147483647u) > 2139095040u) {
                phi_239_ = _e54;
            } else {
                if (_e54 < 0f) {
                    phi_238_ = 0f;
                } else {
                    if (_e54 > 1f) {
                        phi_237_ = 1f;
                    } else {
                        phi_237_ = _e54;
                    }
                    let _e89 = phi_237_;
                    phi_238_ = _e89;
                }
                let _e91 = phi_238_;
                phi_239_ = _e91;
            }
            let _e93 = phi_239_;
            phi_240_ = _e93;
            phi_241_ = false;
        } else {
            phi_240_ = f32();
            phi_241_ = true;
        }
        let _e95 = phi_240_;
        let _e97 = phi_241_;
        phi_242_ = _e95;
        phi_243_ = _e97;
    } else {
        phi_242_ = f32();
        phi_243_ = true;
    }
    let _e99 = phi_242_;
    let _e101 = phi_243_;
    if _e101 {
        let _e102 = (_e61 / _e59);
        let _e103 = (_e77 - _e54);
        let _e109 = (((((_e77 * _e77) - _e55) - (_e102 * _e103)) * _e59) / (((_e57 - (_e55 * _e55)) * _e59) - (_e61 * _e61)));
        let _e112 = ((_e103 / _e59) - (_e102 * _e109));
        let _e118 = ((0.5f * _e112) / _e109);
        let _e121 = ((_e118 * _e118) - (((1f - (_e112 * _e54)) - (_e109 * _e55)) / _e109));
        if (_e121 >= 0f) {
            let _e123 = sqrt(_e121);
            phi_281_ = vec2<f32>((-(_e118) - _e123), (-(_e118) + _e123));
        } else {
            phi_281_ = vec2(bitcast<f32>((bitcast<u32>(_e121) | 2143289344u)));
        }
        let _e134 = phi_281_;
        if (_e77 <= _e134.x) {
            phi_354_ = 1f;
        } else {
            if (_e77 > _e134.y) {
                let _e147 = (((_e55 - (_e54 * (_e134.x + _e134.y))) + (_e134.x * _e134.y)) / ((_e77 - _e134.x) * (_e77 - _e134.y)));
                if ((bitcast<u32>(_e147) & 2147483647u) > 2139095040u) {
                    phi_317_ = _e147;
                } else {
                    if (_e147 < 0f) {
                        phi_316_ = 0f;
                    } else {
                        if (_e147 > 1f) {
                            phi_315_ = 1f;
                        } else {
                            phi_315_ = _e147;
                        }
                        let _e154 = phi_315_;
                        phi_316_ = _e154;
                    }
                    let _e156 = phi_316_;
                    phi_317_ = _e156;
                }
                let _e158 = phi_317_;
                phi_353_ = _e158;
            } else {
                if (_e77 > _e134.x) {
                    let _e169 = (1f - (((_e55 - (_e54 * (_e77 + _e134.y))) + (_e77 * _e134.y)) / ((_e134.x - _e77) * (_e134.x - _e134.y))));
                    if ((bitcast<u32>(_e169) & 2147483647u) > 2139095040u) {
                        phi_348_ = _e169;
                    } else {
                        if (_e169 < 0f) {
                            phi_347_ = 0f;
                        } else {
                            if (_e169 > 1f) {
                                phi_346_ = 1f;
                            } else {
                                phi_346_ = _e169;
                            }
                            let _e176 = phi_346_;
                            phi_347_ = _e176;
                        }
                        let _e178 = phi_347_;
                        phi_348_ = _e178;
                    }
                    let _e180 = phi_348_;
                    phi_352_ = _e180;
                } else {
                    phi_352_ = bitcast<f32>((bitcast<u32>(_e134.x) | 2143289344u));
                }
                let _e185 = phi_352_;
                phi_353_ = _e185;
            }
            let _e187 = phi_353_;
            phi_354_ = _e187;
        }
        let _e189 = phi_354_;
        phi_355_ = _e189;
    } else {
        phi_355_ = _e99;
    }
    let _e191 = phi_355_;
    return _e191;
}

fn function_() {
    var local: f32;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_417_: bool;
    var phi_418_: bool;
    var phi_422_: bool;
    var phi_492_: bool;
    var phi_493_: bool;
    var phi_504_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_505_: bool;
    var phi_506_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_507_: bool;
    var phi_514_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_518_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_538_: lt_math_LightPoint;
    var phi_541_: u32;
    var phi_543_: lt_math_LevelPoint;
    var phi_629_: bool;
    var phi_638_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_657_: bool;
    var phi_684_: bool;
    var phi_685_: bool;
    var phi_686_: bool;
    var phi_687_: bool;
    var phi_688_: bool;
    var phi_689_: bool;
    var phi_690_: bool;
    var phi_691_: bool;
    var phi_695_: bool;
    var phi_704_: lt_math_LightPoint;
    var phi_705_: u32;
    var phi_706_: lt_math_LevelPoint;
    var phi_707_: bool;
    var phi_539_: lt_math_LightPoint;
    var phi_542_: u32;
    var phi_544_: lt_math_LevelPoint;
    var phi_708_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_748_: bool;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_755_: bool;
    var phi_837_: f32;
    var phi_955_: f32;
    var phi_956_: f32;
    var phi_959_: f32;
    var phi_988_: f32;
    var phi_993_: f32;
    var phi_994_: bool;
    var phi_995_: f32;
    var phi_996_: bool;
    var phi_1000_: f32;
    var phi_1020_: f32;
    var phi_1025_: f32;
    var phi_1026_: bool;
    var phi_1027_: f32;
    var phi_1028_: bool;
    var phi_1032_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1081_: i32;
    var phi_1086_: i32;
    var phi_1091_: i32;
    var phi_1096_: i32;
    var phi_1105_: i32;
    var phi_1110_: i32;
    var phi_1115_: i32;
    var phi_1120_: i32;
    var phi_1215_: bool;
    var phi_1223_: bool;
    var phi_1235_: bool;
    var phi_1236_: bool;
    var phi_1240_: f32;
    var phi_1246_: f32;
    var phi_1248_: evaluate_Verdict;
    var phi_1253_: evaluate_Verdict;
    var phi_1254_: evaluate_Verdict;

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
                phi_415_ = (_e83 == _e85);
                phi_416_ = false;
            } else {
                phi_415_ = bool();
                phi_416_ = true;
            }
            let _e88 = phi_415_;
            let _e90 = phi_416_;
            phi_417_ = _e88;
            phi_418_ = _e90;
        } else {
            phi_417_ = bool();
            phi_418_ = true;
        }
        let _e92 = phi_417_;
        let _e94 = phi_418_;
        if _e94 {
            phi_422_ = false;
        } else {
            phi_422_ = _e92;
        }
        let _e96 = phi_422_;
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
                    phi_493_ = true;
                } else {
                    let _e149 = p.member.light.range_squared;
                    if (_e132 <= _e149) {
                        let _e152 = p.member.light.cos_outer;
                        phi_492_ = (-((((_e114 * _e134.x) + (_e115 * _e134.y)) + (_e116 * _e134.z))) >= (_e152 * sqrt(_e132)));
                    } else {
                        phi_492_ = false;
                    }
                    let _e157 = phi_492_;
                    phi_493_ = _e157;
                }
                let _e159 = phi_493_;
                if _e159 {
                    let _e161 = samples.member[(0u + _e60.first_primitive)].flags;
                    let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e169.unnamed.visibility, false), _e169.unnamed_1);
                    phi_504_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e175.unnamed, ((_e161 & 1u) == 0u));
                    phi_505_ = false;
                } else {
                    phi_504_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_505_ = true;
                }
                let _e180 = phi_504_;
                let _e182 = phi_505_;
                phi_506_ = _e180;
                phi_507_ = _e182;
            } else {
                phi_506_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_507_ = true;
            }
            let _e184 = phi_506_;
            let _e186 = phi_507_;
            if _e186 {
                let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e192.unnamed.visibility, false), _e192.unnamed_1);
                phi_514_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e198.unnamed, true);
            } else {
                phi_514_ = _e184;
            }
            let _e203 = phi_514_;
            phi_518_ = _e203;
        } else {
            let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e209.unnamed.visibility, false), _e209.unnamed_1);
            phi_518_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e215.unnamed, true);
        }
        let _e220 = phi_518_;
        if _e220.unnamed_1 {
            phi_1254_ = evaluate_Verdict(_e220.unnamed.visibility, _e220.unnamed.is_doubted);
        } else {
            let _e228 = samples.member[(0u + _e60.first_primitive)].position;
            let _e230 = p.member.map_size;
            let _e232 = (0.5f / f32(_e230));
            let _e239 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e246 = lt_math_LightPoint(vec2<f32>(_e239.uv.x, 0f), _e239.depth, _e239.is_inside);
            let _e250 = lt_math_LightPoint(_e246.uv, 0f, _e246.is_inside);
            phi_538_ = lt_math_LightPoint();
            phi_541_ = 0u;
            phi_543_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e250.uv, _e250.depth, false));
            loop {
                let _e257 = phi_538_;
                let _e259 = phi_541_;
                let _e261 = phi_543_;
                local_1 = _e261;
                local_2 = _e261;
                local_3 = _e261;
                if (_e259 < _e66) {
                    if _e261.point.is_inside {
                        phi_704_ = lt_math_LightPoint();
                        phi_705_ = u32();
                        phi_706_ = lt_math_LevelPoint();
                        phi_707_ = false;
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
                                phi_629_ = (_e297 <= 1f);
                            } else {
                                phi_629_ = false;
                            }
                            let _e329 = phi_629_;
                            if _e329 {
                                if (_e311 >= 0f) {
                                    phi_638_ = (_e311 <= 1f);
                                } else {
                                    phi_638_ = false;
                                }
                                let _e333 = phi_638_;
                                if _e333 {
                                    if (_e324 >= 0f) {
                                        phi_647_ = (_e324 <= 1f);
                                    } else {
                                        phi_647_ = false;
                                    }
                                    let _e337 = phi_647_;
                                    phi_648_ = _e337;
                                    phi_649_ = false;
                                } else {
                                    phi_648_ = bool();
                                    phi_649_ = true;
                                }
                                let _e339 = phi_648_;
                                let _e341 = phi_649_;
                                phi_650_ = _e339;
                                phi_651_ = _e341;
                            } else {
                                phi_650_ = bool();
                                phi_651_ = true;
                            }
                            let _e343 = phi_650_;
                            let _e345 = phi_651_;
                            phi_652_ = _e343;
                            phi_653_ = _e345;
                        } else {
                            phi_652_ = bool();
                            phi_653_ = true;
                        }
                        let _e347 = phi_652_;
                        let _e349 = phi_653_;
                        if _e349 {
                            phi_657_ = false;
                        } else {
                            phi_657_ = _e347;
                        }
                        let _e351 = phi_657_;
                        if _e351 {
                            if (_e297 >= _e232) {
                                if (_e297 <= (1f - _e232)) {
                                    if (_e311 >= _e232) {
                                        phi_684_ = (_e311 <= (1f - _e232));
                                        phi_685_ = false;
                                    } else {
                                        phi_684_ = bool();
                                        phi_685_ = true;
                                    }
                                    let _e359 = phi_684_;
                                    let _e361 = phi_685_;
                                    phi_686_ = _e359;
                                    phi_687_ = _e361;
                                } else {
                                    phi_686_ = bool();
                                    phi_687_ = true;
                                }
                                let _e363 = phi_686_;
                                let _e365 = phi_687_;
                                phi_688_ = _e363;
                                phi_689_ = _e365;
                            } else {
                                phi_688_ = bool();
                                phi_689_ = true;
                            }
                            let _e367 = phi_688_;
                            let _e369 = phi_689_;
                            phi_690_ = _e367;
                            phi_691_ = _e369;
                        } else {
                            phi_690_ = bool();
                            phi_691_ = true;
                        }
                        let _e371 = phi_690_;
                        let _e373 = phi_691_;
                        if _e373 {
                            phi_695_ = false;
                        } else {
                            phi_695_ = _e371;
                        }
                        let _e375 = phi_695_;
                        let _e382 = lt_math_LightPoint(vec2<f32>(_e297, _e257.uv.y), _e257.depth, _e257.is_inside);
                        let _e389 = lt_math_LightPoint(vec2<f32>(_e382.uv.x, _e311), _e382.depth, _e382.is_inside);
                        let _e393 = lt_math_LightPoint(_e389.uv, _e324, _e389.is_inside);
                        let _e397 = lt_math_LightPoint(_e393.uv, _e393.depth, _e375);
                        phi_704_ = _e397;
                        phi_705_ = (_e259 + 1u);
                        phi_706_ = lt_math_LevelPoint(_e259, _e397);
                        phi_707_ = true;
                    }
                    let _e401 = phi_704_;
                    let _e403 = phi_705_;
                    let _e405 = phi_706_;
                    let _e407 = phi_707_;
                    phi_539_ = _e401;
                    phi_542_ = _e403;
                    phi_544_ = _e405;
                    phi_708_ = _e407;
                } else {
                    phi_539_ = lt_math_LightPoint();
                    phi_542_ = u32();
                    phi_544_ = lt_math_LevelPoint();
                    phi_708_ = false;
                }
                let _e409 = phi_539_;
                let _e411 = phi_542_;
                let _e413 = phi_544_;
                let _e415 = phi_708_;
                continue;
                continuing {
                    phi_538_ = _e409;
                    phi_541_ = _e411;
                    phi_543_ = _e413;
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
                            phi_748_ = (_e429.row_w.z == _e441);
                            phi_749_ = false;
                        } else {
                            phi_748_ = bool();
                            phi_749_ = true;
                        }
                        let _e444 = phi_748_;
                        let _e446 = phi_749_;
                        phi_750_ = _e444;
                        phi_751_ = _e446;
                    } else {
                        phi_750_ = bool();
                        phi_751_ = true;
                    }
                    let _e448 = phi_750_;
                    let _e450 = phi_751_;
                    if _e450 {
                        phi_755_ = false;
                    } else {
                        phi_755_ = _e448;
                    }
                    let _e452 = phi_755_;
                    if _e452 {
                        let _e454 = samples.member[(0u + _e60.first_primitive)].normal;
                        let _e456 = p.member.map_size;
                        let _e526 = ((abs(((((_e429.row_x.x * _e454.x) + (_e429.row_x.y * _e454.y)) + (_e429.row_x.z * _e454.z)) / (((_e429.row_x.x * _e429.row_x.x) + (_e429.row_x.y * _e429.row_x.y)) + (_e429.row_x.z * _e429.row_x.z)))) + abs(((((_e429.row_y.x * _e454.x) + (_e429.row_y.y * _e454.y)) + (_e429.row_y.z * _e454.z)) / (((_e429.row_y.x * _e429.row_y.x) + (_e429.row_y.y * _e429.row_y.y)) + (_e429.row_y.z * _e429.row_y.z))))) / (abs(((((_e429.row_z.x * _e454.x) + (_e429.row_z.y * _e454.y)) + (_e429.row_z.z * _e454.z)) / (((_e429.row_z.x * _e429.row_z.x) + (_e429.row_z.y * _e429.row_z.y)) + (_e429.row_z.z * _e429.row_z.z)))) * f32(_e456)));
                        if (_e526 < 0.002f) {
                            phi_837_ = _e526;
                        } else {
                            phi_837_ = 0.002f;
                        }
                        let _e529 = phi_837_;
                        phi_956_ = _e529;
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
                            phi_955_ = _e643;
                        } else {
                            phi_955_ = _e645;
                        }
                        let _e648 = phi_955_;
                        phi_956_ = _e648;
                    }
                    let _e650 = phi_956_;
                    phi_959_ = (_e418.point.depth - (0f * _e650));
                } else {
                    phi_959_ = _e418.point.depth;
                }
                let _e654 = phi_959_;
                let _e660 = p.member.map_size;
                let _e661 = f32(_e660);
                let _e664 = ((_e418.point.uv.x * _e661) - 0.5f);
                let _e665 = ((_e418.point.uv.y * _e661) - 0.5f);
                if (_e664 > -8388608f) {
                    let _e677 = f32(select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < bitcast<f32>(3472883712u))), 2147483647i, (_e664 > bitcast<f32>(1325400063u))), (_e664 == _e664)));
                    if (_e677 > _e664) {
                        phi_988_ = 1f;
                    } else {
                        phi_988_ = 0f;
                    }
                    let _e680 = phi_988_;
                    if (_e664 < 8388608f) {
                        phi_993_ = (_e677 - _e680);
                        phi_994_ = false;
                    } else {
                        phi_993_ = f32();
                        phi_994_ = true;
                    }
                    let _e683 = phi_993_;
                    let _e685 = phi_994_;
                    phi_995_ = _e683;
                    phi_996_ = _e685;
                } else {
                    phi_995_ = f32();
                    phi_996_ = true;
                }
                let _e687 = phi_995_;
                let _e689 = phi_996_;
                if _e689 {
                    phi_1000_ = _e664;
                } else {
                    phi_1000_ = _e687;
                }
                let _e691 = phi_1000_;
                if (_e665 > -8388608f) {
                    let _e703 = f32(select(0i, select(select(i32(_e665), i32(-2147483648), (_e665 < bitcast<f32>(3472883712u))), 2147483647i, (_e665 > bitcast<f32>(1325400063u))), (_e665 == _e665)));
                    if (_e703 > _e665) {
                        phi_1020_ = 1f;
                    } else {
                        phi_1020_ = 0f;
                    }
                    let _e706 = phi_1020_;
                    if (_e665 < 8388608f) {
                        phi_1025_ = (_e703 - _e706);
                        phi_1026_ = false;
                    } else {
                        phi_1025_ = f32();
                        phi_1026_ = true;
                    }
                    let _e709 = phi_1025_;
                    let _e711 = phi_1026_;
                    phi_1027_ = _e709;
                    phi_1028_ = _e711;
                } else {
                    phi_1027_ = f32();
                    phi_1028_ = true;
                }
                let _e713 = phi_1027_;
                let _e715 = phi_1028_;
                if _e715 {
                    phi_1032_ = _e665;
                } else {
                    phi_1032_ = _e713;
                }
                let _e717 = phi_1032_;
                let _e718 = (_e664 - _e691);
                let _e719 = (_e665 - _e717);
                let _e728 = select(0i, select(select(i32(_e691), i32(-2147483648), (_e691 < bitcast<f32>(3472883712u))), 2147483647i, (_e691 > bitcast<f32>(1325400063u))), (_e691 == _e691));
                let _e737 = select(0i, select(select(i32(_e717), i32(-2147483648), (_e717 < bitcast<f32>(3472883712u))), 2147483647i, (_e717 > bitcast<f32>(1325400063u))), (_e717 == _e717));
                let _e740 = ((1f - _e718) * (1f - _e719));
                let _e742 = (_e718 * (1f - _e719));
                let _e744 = ((1f - _e718) * _e719);
                let _e745 = (_e718 * _e719);
                let _e747 = p.member.test;
                let _e748 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e747);
                let _e750 = p.member.map_size;
                let _e752 = local_3;
                local = _e748;
                let _e755 = ((_e752.level * _e750) * _e750);
                let _e757 = (bitcast<i32>(_e750) - 1i);
                if (_e728 > 0i) {
                    phi_1081_ = _e728;
                } else {
                    phi_1081_ = 0i;
                }
                let _e760 = phi_1081_;
                if (_e737 > 0i) {
                    phi_1086_ = _e737;
                } else {
                    phi_1086_ = 0i;
                }
                let _e763 = phi_1086_;
                if (_e760 < _e757) {
                    phi_1091_ = _e760;
                } else {
                    phi_1091_ = _e757;
                }
                let _e766 = phi_1091_;
                if (_e763 < _e757) {
                    phi_1096_ = _e763;
                } else {
                    phi_1096_ = _e757;
                }
                let _e769 = phi_1096_;
                let _e770 = bitcast<u32>(_e766);
                let _e772 = (_e728 + 1i);
                let _e773 = (_e737 + 1i);
                if (_e772 > 0i) {
                    phi_1105_ = _e772;
                } else {
                    phi_1105_ = 0i;
                }
                let _e776 = phi_1105_;
                if (_e773 > 0i) {
                    phi_1110_ = _e773;
                } else {
                    phi_1110_ = 0i;
                }
                let _e779 = phi_1110_;
                if (_e776 < _e757) {
                    phi_1115_ = _e776;
                } else {
                    phi_1115_ = _e757;
                }
                let _e782 = phi_1115_;
                if (_e779 < _e757) {
                    phi_1120_ = _e779;
                } else {
                    phi_1120_ = _e757;
                }
                let _e785 = phi_1120_;
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
                let _e859 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e801.x * _e740) + (_e813.x * _e742)) + (_e829.x * _e744)) + (_e845.x * _e745)), ((((_e801.y * _e740) + (_e813.y * _e742)) + (_e829.y * _e744)) + (_e845.y * _e745)), ((((_e801.z * _e740) + (_e813.z * _e742)) + (_e829.z * _e744)) + (_e845.z * _e745)), ((((_e801.w * _e740) + (_e813.w * _e742)) + (_e829.w * _e744)) + (_e845.w * _e745))), _e654);
                let _e861 = p.member.epsilon;
                if (_e859 <= _e861) {
                    phi_1215_ = true;
                } else {
                    phi_1215_ = (_e859 >= (1f - _e861));
                }
                let _e866 = phi_1215_;
                if ((bitcast<u32>(_e859) & 2147483647u) > 2139095040u) {
                    phi_1223_ = true;
                } else {
                    phi_1223_ = !(_e866);
                }
                let _e872 = phi_1223_;
                if _e872 {
                    if (_e859 > 0f) {
                        if (_e859 < 1f) {
                            phi_1235_ = false;
                        } else {
                            phi_1235_ = true;
                        }
                        let _e876 = phi_1235_;
                        phi_1236_ = _e876;
                    } else {
                        phi_1236_ = true;
                    }
                    let _e878 = phi_1236_;
                    if _e878 {
                        phi_1240_ = 0.5f;
                    } else {
                        phi_1240_ = _e859;
                    }
                    let _e880 = phi_1240_;
                    phi_1248_ = evaluate_Verdict(_e880, true);
                } else {
                    if (_e859 > 0.5f) {
                        phi_1246_ = 1f;
                    } else {
                        phi_1246_ = 0f;
                    }
                    let _e884 = phi_1246_;
                    phi_1248_ = evaluate_Verdict(_e884, false);
                }
                let _e887 = phi_1248_;
                phi_1253_ = evaluate_Verdict(_e887.visibility, _e887.is_doubted);
            } else {
                phi_1253_ = evaluate_Verdict(0.5f, true);
            }
            let _e893 = phi_1253_;
            phi_1254_ = _e893;
        }
        let _e895 = phi_1254_;
        if (_e60.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e60.first_primitive)] = _e895.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
