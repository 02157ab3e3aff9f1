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

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_206_: f32;
    var phi_207_: f32;
    var phi_208_: f32;
    var phi_214_: bool;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_239_: f32;
    var phi_240_: bool;
    var phi_241_: f32;
    var phi_242_: bool;
    var phi_280_: vec2<f32>;
    var phi_314_: f32;
    var phi_315_: f32;
    var phi_316_: f32;
    var phi_345_: f32;
    var phi_346_: f32;
    var phi_347_: f32;
    var phi_351_: f32;
    var phi_352_: f32;
    var phi_353_: f32;
    var phi_354_: f32;

    let _e43 = (*param_4);
    let _e44 = (1f - _e43);
    let _e53 = (0.5f * _e43);
    let _e54 = ((param_5.x * _e44) + _e53);
    let _e55 = ((param_5.y * _e44) + _e53);
    let _e57 = ((param_5.w * _e44) + _e53);
    let _e59 = (_e55 - (_e54 * _e54));
    let _e61 = (((param_5.z * _e44) + _e53) - (_e54 * _e55));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_208_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_207_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_206_ = 1f;
            } else {
                phi_206_ = param_6;
            }
            let _e73 = phi_206_;
            phi_207_ = _e73;
        }
        let _e75 = phi_207_;
        phi_208_ = _e75;
    }
    let _e77 = phi_208_;
    if (_e54 == _e57) {
        phi_214_ = (_e54 > 0.5f);
    } else {
        phi_214_ = false;
    }
    let _e81 = phi_214_;
    if _e81 {
        if (_e77 > 0f) {
            if ((bitcast<u32>(_e54) & 2147483647u) > 2139095040u) {
                phi_238_ = _e54;
            } else {
                if (_e54 < 0f) {
                    phi_237_ = 0f;
                } else {
                    if (_e54 > 1f) {
                        phi_236_ = 1f;
                    } else {
                        phi_236_ = _e54;
                    }
                    let _e89 = phi_236_;
                    phi_237_ = _e89;
                }
                let _e91 = phi_237_;
                phi_238_ = _e91;
            }
            let _e93 = phi_238_;
            phi_239_ = _e93;
            phi_240_ = false;
        } else {
            phi_239_ = f32();
            phi_240_ = true;
        }
        let _e95 = phi_239_;
        let _e97 = phi_240_;
        phi_241_ = _e95;
        phi_242_ = _e97;
    } else {
        phi_241_ = f32();
        phi_242_ = true;
    }
    let _e99 = phi_241_;
    let _e101 = phi_242_;
    if _e101 {
        let _e102 = (_e61 / _e59);
        let _e103 = (_e77 - _e54);
        let _e109 = (((((_e77 * _e77) - _e55) - (_e102 * _e103)) * _e59) / (((_e57 - (_e55 * _e55)) * _e59) - (_e61 * _e61)));
        let _e112 = ((_e103 / _e59) - (_e102 * _e109));
        let _e118 = ((0.5f * _e112) / _e109);
        let _e121 = ((_e118 * _e118) - (((1f - (_e112 * _e54)) - (_e109 * _e55)) / _e109));
        if (_e121 >= 0f) {
            let _e123 = sqrt(_e121);
            phi_280_ = vec2<f32>((-(_e118) - _e123), (-(_e118) + _e123));
        } else {
            phi_280_ = vec2(bitcast<f32>((bitcast<u32>(_e121) | 2143289344u)));
        }
        let _e134 = phi_280_;
        if (_e77 <= _e134.x) {
            phi_353_ = 1f;
        } else {
            if (_e77 > _e134.y) {
                let _e147 = (((_e55 - (_e54 * (_e134.x + _e134.y))) + (_e134.x * _e134.y)) / ((_e77 - _e134.x) * (_e77 - _e134.y)));
                if ((bitcast<u32>(_e147) & 2147483647u) > 2139095040u) {
                    phi_316_ = _e147;
                } else {
                    if (_e147 < 0f) {
                        phi_315_ = 0f;
                    } else {
                        if (_e147 > 1f) {
                            phi_314_ = 1f;
                        } else {
                            phi_314_ = _e147;
                        }
                        let _e154 = phi_314_;
                        phi_315_ = _e154;
                    }
                    let _e156 = phi_315_;
                    phi_316_ = _e156;
                }
                let _e158 = phi_316_;
                phi_352_ = _e158;
            } else {
                if (_e77 > _e134.x) {
                    let _e169 = (1f - (((_e55 - (_e54 * (_e77 + _e134.y))) + (_e77 * _e134.y)) / ((_e134.x - _e77) * (_e134.x - _e134.y))));
                    if ((bitcast<u32>(_e169) & 2147483647u) > 2139095040u) {
                        phi_347_ = _e169;
                    } else {
                        if (_e169 < 0f) {
                            phi_346_ = 0f;
                        } else {
                            if (_e169 > 1f) {
                                phi_345_ = 1f;
                            } else {
                                phi_345_ = _e169;
                            }
                            let _e176 = phi_345_;
                            phi_346_ = _e176;
                        }
                        let _e178 = phi_346_;
                        phi_347_ = _e178;
                    }
                    let _e180 = phi_347_;
                    phi_351_ = _e180;
                } else {
                    phi_351_ = bitcast<f32>((bitcast<u32>(_e134.x) | 2143289344u));
                }
                let _e185 = phi_351_;
                phi_352_ = _e185;
            }
            let _e187 = phi_352_;
            phi_353_ = _e187;
        }
        let _e189 = phi_353_;
        phi_354_ = _e189;
    } else {
        phi_354_ = _e99;
    }
    let _e191 = phi_354_;
    return _e191;
}

fn function_() {
    var local: f32;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_417_: bool;
    var phi_421_: bool;
    var phi_491_: bool;
    var phi_492_: bool;
    var phi_503_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_504_: bool;
    var phi_505_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_506_: bool;
    var phi_513_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_517_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_537_: lt_math_LightPoint;
    var phi_540_: u32;
    var phi_542_: lt_math_LevelPoint;
    var phi_628_: bool;
    var phi_637_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_656_: bool;
    var phi_683_: bool;
    var phi_684_: bool;
    var phi_685_: bool;
    var phi_686_: bool;
    var phi_687_: bool;
    var phi_688_: bool;
    var phi_689_: bool;
    var phi_690_: bool;
    var phi_694_: bool;
    var phi_703_: lt_math_LightPoint;
    var phi_704_: u32;
    var phi_705_: lt_math_LevelPoint;
    var phi_706_: bool;
    var phi_538_: lt_math_LightPoint;
    var phi_541_: u32;
    var phi_543_: lt_math_LevelPoint;
    var phi_707_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_747_: bool;
    var phi_748_: bool;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_754_: bool;
    var phi_836_: f32;
    var phi_954_: f32;
    var phi_955_: f32;
    var phi_958_: f32;
    var phi_987_: f32;
    var phi_992_: f32;
    var phi_993_: bool;
    var phi_994_: f32;
    var phi_995_: bool;
    var phi_999_: f32;
    var phi_1019_: f32;
    var phi_1024_: f32;
    var phi_1025_: bool;
    var phi_1026_: f32;
    var phi_1027_: bool;
    var phi_1031_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1080_: i32;
    var phi_1085_: i32;
    var phi_1090_: i32;
    var phi_1095_: i32;
    var phi_1104_: i32;
    var phi_1109_: i32;
    var phi_1114_: i32;
    var phi_1119_: i32;
    var phi_1208_: evaluate_Verdict;
    var phi_1209_: evaluate_Verdict;
    var phi_1210_: bool;
    var phi_1211_: evaluate_Verdict;
    var phi_1212_: evaluate_Verdict;
    var phi_1213_: bool;
    var phi_1217_: evaluate_Verdict;

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
                phi_414_ = (_e83 == _e85);
                phi_415_ = false;
            } else {
                phi_414_ = bool();
                phi_415_ = true;
            }
            let _e88 = phi_414_;
            let _e90 = phi_415_;
            phi_416_ = _e88;
            phi_417_ = _e90;
        } else {
            phi_416_ = bool();
            phi_417_ = true;
        }
        let _e92 = phi_416_;
        let _e94 = phi_417_;
        if _e94 {
            phi_421_ = false;
        } else {
            phi_421_ = _e92;
        }
        let _e96 = phi_421_;
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
                    phi_492_ = true;
                } else {
                    let _e149 = p.member.light.range_squared;
                    if (_e132 <= _e149) {
                        let _e152 = p.member.light.cos_outer;
                        phi_491_ = (-((((_e114 * _e134.x) + (_e115 * _e134.y)) + (_e116 * _e134.z))) >= (_e152 * sqrt(_e132)));
                    } else {
                        phi_491_ = false;
                    }
                    let _e157 = phi_491_;
                    phi_492_ = _e157;
                }
                let _e159 = phi_492_;
                if _e159 {
                    let _e161 = samples.member[(0u + _e60.first_primitive)].flags;
                    let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e169.unnamed.visibility, false), _e169.unnamed_1);
                    phi_503_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e175.unnamed, ((_e161 & 1u) == 0u));
                    phi_504_ = false;
                } else {
                    phi_503_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_504_ = true;
                }
                let _e180 = phi_503_;
                let _e182 = phi_504_;
                phi_505_ = _e180;
                phi_506_ = _e182;
            } else {
                phi_505_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_506_ = true;
            }
            let _e184 = phi_505_;
            let _e186 = phi_506_;
            if _e186 {
                let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e192.unnamed.visibility, false), _e192.unnamed_1);
                phi_513_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e198.unnamed, true);
            } else {
                phi_513_ = _e184;
            }
            let _e203 = phi_513_;
            phi_517_ = _e203;
        } else {
            let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e209.unnamed.visibility, false), _e209.unnamed_1);
            phi_517_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e215.unnamed, true);
        }
        let _e220 = phi_517_;
        if _e220.unnamed_1 {
            phi_1211_ = evaluate_Verdict(_e220.unnamed.visibility, _e220.unnamed.is_doubted);
            phi_1212_ = evaluate_Verdict();
            phi_1213_ = true;
        } else {
            let _e228 = samples.member[(0u + _e60.first_primitive)].position;
            let _e230 = p.member.map_size;
            let _e232 = (0.5f / f32(_e230));
            let _e239 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e246 = lt_math_LightPoint(vec2<f32>(_e239.uv.x, 0f), _e239.depth, _e239.is_inside);
            let _e250 = lt_math_LightPoint(_e246.uv, 0f, _e246.is_inside);
            phi_537_ = lt_math_LightPoint();
            phi_540_ = 0u;
            phi_542_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e250.uv, _e250.depth, false));
            loop {
                let _e257 = phi_537_;
                let _e259 = phi_540_;
                let _e261 = phi_542_;
                local_1 = _e261;
                local_2 = _e261;
                local_3 = _e261;
                if (_e259 < _e66) {
                    if _e261.point.is_inside {
                        phi_703_ = lt_math_LightPoint();
                        phi_704_ = u32();
                        phi_705_ = lt_math_LevelPoint();
                        phi_706_ = false;
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
                                phi_628_ = (_e297 <= 1f);
                            } else {
                                phi_628_ = false;
                            }
                            let _e329 = phi_628_;
                            if _e329 {
                                if (_e311 >= 0f) {
                                    phi_637_ = (_e311 <= 1f);
                                } else {
                                    phi_637_ = false;
                                }
                                let _e333 = phi_637_;
                                if _e333 {
                                    if (_e324 >= 0f) {
                                        phi_646_ = (_e324 <= 1f);
                                    } else {
                                        phi_646_ = false;
                                    }
                                    let _e337 = phi_646_;
                                    phi_647_ = _e337;
                                    phi_648_ = false;
                                } else {
                                    phi_647_ = bool();
                                    phi_648_ = true;
                                }
                                let _e339 = phi_647_;
                                let _e341 = phi_648_;
                                phi_649_ = _e339;
                                phi_650_ = _e341;
                            } else {
                                phi_649_ = bool();
                                phi_650_ = true;
                            }
                            let _e343 = phi_649_;
                            let _e345 = phi_650_;
                            phi_651_ = _e343;
                            phi_652_ = _e345;
                        } else {
                            phi_651_ = bool();
                            phi_652_ = true;
                        }
                        let _e347 = phi_651_;
                        let _e349 = phi_652_;
                        if _e349 {
                            phi_656_ = false;
                        } else {
                            phi_656_ = _e347;
                        }
                        let _e351 = phi_656_;
                        if _e351 {
                            if (_e297 >= _e232) {
                                if (_e297 <= (1f - _e232)) {
                                    if (_e311 >= _e232) {
                                        phi_683_ = (_e311 <= (1f - _e232));
                                        phi_684_ = false;
                                    } else {
                                        phi_683_ = bool();
                                        phi_684_ = true;
                                    }
                                    let _e359 = phi_683_;
                                    let _e361 = phi_684_;
                                    phi_685_ = _e359;
                                    phi_686_ = _e361;
                                } else {
                                    phi_685_ = bool();
                                    phi_686_ = true;
                                }
                                let _e363 = phi_685_;
                                let _e365 = phi_686_;
                                phi_687_ = _e363;
                                phi_688_ = _e365;
                            } else {
                                phi_687_ = bool();
                                phi_688_ = true;
                            }
                            let _e367 = phi_687_;
                            let _e369 = phi_688_;
                            phi_689_ = _e367;
                            phi_690_ = _e369;
                        } else {
                            phi_689_ = bool();
                            phi_690_ = true;
                        }
                        let _e371 = phi_689_;
                        let _e373 = phi_690_;
                        if _e373 {
                            phi_694_ = false;
                        } else {
                            phi_694_ = _e371;
                        }
                        let _e375 = phi_694_;
                        let _e382 = lt_math_LightPoint(vec2<f32>(_e297, _e257.uv.y), _e257.depth, _e257.is_inside);
                        let _e389 = lt_math_LightPoint(vec2<f32>(_e382.uv.x, _e311), _e382.depth, _e382.is_inside);
                        let _e393 = lt_math_LightPoint(_e389.uv, _e324, _e389.is_inside);
                        let _e397 = lt_math_LightPoint(_e393.uv, _e393.depth, _e375);
                        phi_703_ = _e397;
                        phi_704_ = (_e259 + 1u);
                        phi_705_ = lt_math_LevelPoint(_e259, _e397);
                        phi_706_ = true;
                    }
                    let _e401 = phi_703_;
                    let _e403 = phi_704_;
                    let _e405 = phi_705_;
                    let _e407 = phi_706_;
                    phi_538_ = _e401;
                    phi_541_ = _e403;
                    phi_543_ = _e405;
                    phi_707_ = _e407;
                } else {
                    phi_538_ = lt_math_LightPoint();
                    phi_541_ = u32();
                    phi_543_ = lt_math_LevelPoint();
                    phi_707_ = false;
                }
                let _e409 = phi_538_;
                let _e411 = phi_541_;
                let _e413 = phi_543_;
                let _e415 = phi_707_;
                continue;
                continuing {
                    phi_537_ = _e409;
                    phi_540_ = _e411;
                    phi_542_ = _e413;
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
                            phi_747_ = (_e429.row_w.z == _e441);
                            phi_748_ = false;
                        } else {
                            phi_747_ = bool();
                            phi_748_ = true;
                        }
                        let _e444 = phi_747_;
                        let _e446 = phi_748_;
                        phi_749_ = _e444;
                        phi_750_ = _e446;
                    } else {
                        phi_749_ = bool();
                        phi_750_ = true;
                    }
                    let _e448 = phi_749_;
                    let _e450 = phi_750_;
                    if _e450 {
                        phi_754_ = false;
                    } else {
                        phi_754_ = _e448;
                    }
                    let _e452 = phi_754_;
                    if _e452 {
                        let _e454 = samples.member[(0u + _e60.first_primitive)].normal;
                        let _e456 = p.member.map_size;
                        let _e526 = ((abs(((((_e429.row_x.x * _e454.x) + (_e429.row_x.y * _e454.y)) + (_e429.row_x.z * _e454.z)) / (((_e429.row_x.x * _e429.row_x.x) + (_e429.row_x.y * _e429.row_x.y)) + (_e429.row_x.z * _e429.row_x.z)))) + abs(((((_e429.row_y.x * _e454.x) + (_e429.row_y.y * _e454.y)) + (_e429.row_y.z * _e454.z)) / (((_e429.row_y.x * _e429.row_y.x) + (_e429.row_y.y * _e429.row_y.y)) + (_e429.row_y.z * _e429.row_y.z))))) / (abs(((((_e429.row_z.x * _e454.x) + (_e429.row_z.y * _e454.y)) + (_e429.row_z.z * _e454.z)) / (((_e429.row_z.x * _e429.row_z.x) + (_e429.row_z.y * _e429.row_z.y)) + (_e429.row_z.z * _e429.row_z.z)))) * f32(_e456)));
                        if (_e526 < 0.002f) {
                            phi_836_ = _e526;
                        } else {
                            phi_836_ = 0.002f;
                        }
                        let _e529 = phi_836_;
                        phi_955_ = _e529;
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
                            phi_954_ = _e643;
                        } else {
                            phi_954_ = _e645;
                        }
                        let _e648 = phi_954_;
                        phi_955_ = _e648;
                    }
                    let _e650 = phi_955_;
                    phi_958_ = (_e418.point.depth - (0f * _e650));
                } else {
                    phi_958_ = _e418.point.depth;
                }
                let _e654 = phi_958_;
                let _e660 = p.member.map_size;
                let _e661 = f32(_e660);
                let _e664 = ((_e418.point.uv.x * _e661) - 0.5f);
                let _e665 = ((_e418.point.uv.y * _e661) - 0.5f);
                if (_e664 > -8388608f) {
                    let _e677 = f32(select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < bitcast<f32>(3472883712u))), 2147483647i, (_e664 > bitcast<f32>(1325400063u))), (_e664 == _e664)));
                    if (_e677 > _e664) {
                        phi_987_ = 1f;
                    } else {
                        phi_987_ = 0f;
                    }
                    let _e680 = phi_987_;
                    if (_e664 < 8388608f) {
                        phi_992_ = (_e677 - _e680);
                        phi_993_ = false;
                    } else {
                        phi_992_ = f32();
                        phi_993_ = true;
                    }
                    let _e683 = phi_992_;
                    let _e685 = phi_993_;
                    phi_994_ = _e683;
                    phi_995_ = _e685;
                } else {
                    phi_994_ = f32();
                    phi_995_ = true;
                }
                let _e687 = phi_994_;
                let _e689 = phi_995_;
                if _e689 {
                    phi_999_ = _e664;
                } else {
                    phi_999_ = _e687;
                }
                let _e691 = phi_999_;
                if (_e665 > -8388608f) {
                    let _e703 = f32(select(0i, select(select(i32(_e665), i32(-2147483648), (_e665 < bitcast<f32>(3472883712u))), 2147483647i, (_e665 > bitcast<f32>(1325400063u))), (_e665 == _e665)));
                    if (_e703 > _e665) {
                        phi_1019_ = 1f;
                    } else {
                        phi_1019_ = 0f;
                    }
                    let _e706 = phi_1019_;
                    if (_e665 < 8388608f) {
                        phi_1024_ = (_e703 - _e706);
                        phi_1025_ = false;
                    } else {
                        phi_1024_ = f32();
                        phi_1025_ = true;
                    }
                    let _e709 = phi_1024_;
                    let _e711 = phi_1025_;
                    phi_1026_ = _e709;
                    phi_1027_ = _e711;
                } else {
                    phi_1026_ = f32();
                    phi_1027_ = true;
                }
                let _e713 = phi_1026_;
                let _e715 = phi_1027_;
                if _e715 {
                    phi_1031_ = _e665;
                } else {
                    phi_1031_ = _e713;
                }
                let _e717 = phi_1031_;
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
                    phi_1080_ = _e728;
                } else {
                    phi_1080_ = 0i;
                }
                let _e760 = phi_1080_;
                if (_e737 > 0i) {
                    phi_1085_ = _e737;
                } else {
                    phi_1085_ = 0i;
                }
                let _e763 = phi_1085_;
                if (_e760 < _e757) {
                    phi_1090_ = _e760;
                } else {
                    phi_1090_ = _e757;
                }
                let _e766 = phi_1090_;
                if (_e763 < _e757) {
                    phi_1095_ = _e763;
                } else {
                    phi_1095_ = _e757;
                }
                let _e769 = phi_1095_;
                let _e770 = bitcast<u32>(_e766);
                let _e772 = (_e728 + 1i);
                let _e773 = (_e737 + 1i);
                if (_e772 > 0i) {
                    phi_1104_ = _e772;
                } else {
                    phi_1104_ = 0i;
                }
                let _e776 = phi_1104_;
                if (_e773 > 0i) {
                    phi_1109_ = _e773;
                } else {
                    phi_1109_ = 0i;
                }
                let _e779 = phi_1109_;
                if (_e776 < _e757) {
                    phi_1114_ = _e776;
                } else {
                    phi_1114_ = _e757;
                }
                let _e782 = phi_1114_;
                if (_e779 < _e757) {
                    phi_1119_ = _e779;
                } else {
                    phi_1119_ = _e757;
                }
                let _e785 = phi_1119_;
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
                phi_1208_ = evaluate_Verdict(_e859, false);
                phi_1209_ = evaluate_Verdict();
                phi_1210_ = false;
            } else {
                phi_1208_ = evaluate_Verdict();
                phi_1209_ = evaluate_Verdict(1f, false);
                phi_1210_ = true;
            }
            let _e863 = phi_1208_;
            let _e865 = phi_1209_;
            let _e867 = phi_1210_;
            phi_1211_ = _e865;
            phi_1212_ = _e863;
            phi_1213_ = _e867;
        }
        let _e869 = phi_1211_;
        let _e871 = phi_1212_;
        let _e873 = phi_1213_;
        if _e873 {
            phi_1217_ = _e869;
        } else {
            phi_1217_ = _e871;
        }
        let _e875 = phi_1217_;
        if (_e60.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e60.first_primitive)] = _e875.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
