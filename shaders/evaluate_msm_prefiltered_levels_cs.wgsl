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
    var phi_151_: lt_bvh_traverse_Tree;
    var phi_152_: bool;
    var phi_153_: lt_bvh_traverse_Tree;
    var phi_154_: bool;
    var phi_159_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_151_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_152_ = false;
        } else {
            phi_151_ = lt_bvh_traverse_Tree();
            phi_152_ = true;
        }
        let _e53 = phi_151_;
        let _e55 = phi_152_;
        phi_153_ = _e53;
        phi_154_ = _e55;
    } else {
        phi_153_ = lt_bvh_traverse_Tree();
        phi_154_ = true;
    }
    let _e57 = phi_153_;
    let _e59 = phi_154_;
    if _e59 {
        phi_159_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_159_ = _e57;
    }
    let _e64 = phi_159_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_4: f32, param_5: f32) -> f32 {
    var phi_173_: f32;

    if (param_4 < param_5) {
        phi_173_ = param_4;
    } else {
        phi_173_ = param_5;
    }
    let _e44 = phi_173_;
    return _e44;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_216_: f32;
    var phi_217_: f32;
    var phi_218_: f32;
    var phi_224_: bool;
    var phi_246_: f32;
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_249_: f32;
    var phi_250_: bool;
    var phi_251_: f32;
    var phi_252_: bool;
    var phi_290_: vec2<f32>;
    var phi_324_: f32;
    var phi_325_: f32;
    var phi_326_: f32;
    var phi_355_: f32;
    var phi_356_: f32;
    var phi_357_: f32;
    var phi_361_: f32;
    var phi_362_: f32;
    var phi_363_: f32;
    var phi_364_: f32;

    let _e43 = (*param_6);
    let _e44 = (1f - _e43);
    let _e53 = (0.5f * _e43);
    let _e54 = ((param_7.x * _e44) + _e53);
    let _e55 = ((param_7.y * _e44) + _e53);
    let _e57 = ((param_7.w * _e44) + _e53);
    let _e59 = (_e55 - (_e54 * _e54));
    let _e61 = (((param_7.z * _e44) + _e53) - (_e54 * _e55));
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_218_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_217_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_216_ = 1f;
            } else {
                phi_216_ = param_8;
            }
            let _e73 = phi_216_;
            phi_217_ = _e73;
        }
        let _e75 = phi_217_;
        phi_218_ = _e75;
    }
    let _e77 = phi_218_;
    if (_e54 == _e57) {
        phi_224_ = (_e54 > 0.5f);
    } else {
        phi_224_ = false;
    }
    let _e81 = phi_224_;
    if _e81 {
        if (_e77 > 0f) {
            if ((bitcast<u32>(_e54) & 2147483647u) > 2139095040u) {
                phi_248_ = _e54;
            } else {
                if (_e54 < 0f) {
                    phi_247_ = 0f;
                } else {
                    if (_e54 > 1f) {
                        phi_246_ = 1f;
                    } else {
                        phi_246_ = _e54;
                    }
                    let _e89 = phi_246_;
                    phi_247_ = _e89;
                }
                let _e91 = phi_247_;
                phi_248_ = _e91;
            }
            let _e93 = phi_248_;
            phi_249_ = _e93;
            phi_250_ = false;
        } else {
            phi_249_ = f32();
            phi_250_ = true;
        }
        let _e95 = phi_249_;
        let _e97 = phi_250_;
        phi_251_ = _e95;
        phi_252_ = _e97;
    } else {
        phi_251_ = f32();
        phi_252_ = true;
    }
    let _e99 = phi_251_;
    let _e101 = phi_252_;
    if _e101 {
        let _e102 = (_e61 / _e59);
        let _e103 = (_e77 - _e54);
        let _e109 = (((((_e77 * _e77) - _e55) - (_e102 * _e103)) * _e59) / (((_e57 - (_e55 * _e55)) * _e59) - (_e61 * _e61)));
        let _e112 = ((_e103 / _e59) - (_e102 * _e109));
        let _e118 = ((0.5f * _e112) / _e109);
        let _e121 = ((_e118 * _e118) - (((1f - (_e112 * _e54)) - (_e109 * _e55)) / _e109));
        if (_e121 >= 0f) {
            let _e123 = sqrt(_e121);
            phi_290_ = vec2<f32>((-(_e118) - _e123), (-(_e118) + _e123));
        } else {
            phi_290_ = vec2(bitcast<f32>((bitcast<u32>(_e121) | 2143289344u)));
        }
        let _e134 = phi_290_;
        if (_e77 <= _e134.x) {
            phi_363_ = 1f;
        } else {
            if (_e77 > _e134.y) {
                let _e147 = (((_e55 - (_e54 * (_e134.x + _e134.y))) + (_e134.x * _e134.y)) / ((_e77 - _e134.x) * (_e77 - _e134.y)));
                if ((bitcast<u32>(_e147) & 2147483647u) > 2139095040u) {
                    phi_326_ = _e147;
                } else {
                    if (_e147 < 0f) {
                        phi_325_ = 0f;
                    } else {
                        if (_e147 > 1f) {
                            phi_324_ = 1f;
                        } else {
                            phi_324_ = _e147;
                        }
                        let _e154 = phi_324_;
                        phi_325_ = _e154;
                    }
                    let _e156 = phi_325_;
                    phi_326_ = _e156;
                }
                let _e158 = phi_326_;
                phi_362_ = _e158;
            } else {
                if (_e77 > _e134.x) {
                    let _e169 = (1f - (((_e55 - (_e54 * (_e77 + _e134.y))) + (_e77 * _e134.y)) / ((_e134.x - _e77) * (_e134.x - _e134.y))));
                    if ((bitcast<u32>(_e169) & 2147483647u) > 2139095040u) {
                        phi_357_ = _e169;
                    } else {
                        if (_e169 < 0f) {
                            phi_356_ = 0f;
                        } else {
                            if (_e169 > 1f) {
                                phi_355_ = 1f;
                            } else {
                                phi_355_ = _e169;
                            }
                            let _e176 = phi_355_;
                            phi_356_ = _e176;
                        }
                        let _e178 = phi_356_;
                        phi_357_ = _e178;
                    }
                    let _e180 = phi_357_;
                    phi_361_ = _e180;
                } else {
                    phi_361_ = bitcast<f32>((bitcast<u32>(_e134.x) | 2143289344u));
                }
                let _e185 = phi_361_;
                phi_362_ = _e185;
            }
            let _e187 = phi_362_;
            phi_363_ = _e187;
        }
        let _e189 = phi_363_;
        phi_364_ = _e189;
    } else {
        phi_364_ = _e99;
    }
    let _e191 = phi_364_;
    return _e191;
}

fn function_() {
    var local: f32;
    var phi_424_: bool;
    var phi_425_: bool;
    var phi_426_: bool;
    var phi_427_: bool;
    var phi_431_: bool;
    var phi_501_: bool;
    var phi_502_: bool;
    var phi_513_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_514_: bool;
    var phi_515_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_516_: bool;
    var phi_523_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_527_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_547_: lt_math_LightPoint;
    var phi_550_: u32;
    var phi_552_: lt_math_LevelPoint;
    var phi_638_: bool;
    var phi_647_: bool;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_666_: bool;
    var phi_693_: bool;
    var phi_694_: bool;
    var phi_695_: bool;
    var phi_696_: bool;
    var phi_697_: bool;
    var phi_698_: bool;
    var phi_699_: bool;
    var phi_700_: bool;
    var phi_704_: bool;
    var phi_713_: lt_math_LightPoint;
    var phi_714_: u32;
    var phi_715_: lt_math_LevelPoint;
    var phi_716_: bool;
    var phi_548_: lt_math_LightPoint;
    var phi_551_: u32;
    var phi_553_: lt_math_LevelPoint;
    var phi_717_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_760_: bool;
    var phi_764_: bool;
    var phi_846_: f32;
    var phi_962_: f32;
    var phi_963_: f32;
    var phi_966_: f32;
    var phi_995_: f32;
    var phi_1000_: f32;
    var phi_1001_: bool;
    var phi_1002_: f32;
    var phi_1003_: bool;
    var phi_1007_: f32;
    var phi_1027_: f32;
    var phi_1032_: f32;
    var phi_1033_: bool;
    var phi_1034_: f32;
    var phi_1035_: bool;
    var phi_1039_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1088_: i32;
    var phi_1093_: i32;
    var phi_1098_: i32;
    var phi_1103_: i32;
    var phi_1112_: i32;
    var phi_1117_: i32;
    var phi_1122_: i32;
    var phi_1127_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1243_: f32;
    var phi_1245_: evaluate_Verdict;
    var phi_1246_: bool;
    var phi_1247_: evaluate_Verdict;
    var phi_1248_: bool;
    var phi_1253_: evaluate_Verdict;
    var phi_1254_: bool;
    var phi_1256_: evaluate_Verdict;
    var phi_1257_: evaluate_Verdict;
    var phi_1258_: bool;
    var phi_1262_: evaluate_Verdict;
    var phi_1263_: evaluate_Verdict;
    var phi_1264_: bool;
    var phi_1268_: evaluate_Verdict;

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
                phi_424_ = (_e83 == _e85);
                phi_425_ = false;
            } else {
                phi_424_ = bool();
                phi_425_ = true;
            }
            let _e88 = phi_424_;
            let _e90 = phi_425_;
            phi_426_ = _e88;
            phi_427_ = _e90;
        } else {
            phi_426_ = bool();
            phi_427_ = true;
        }
        let _e92 = phi_426_;
        let _e94 = phi_427_;
        if _e94 {
            phi_431_ = false;
        } else {
            phi_431_ = _e92;
        }
        let _e96 = phi_431_;
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
                    phi_502_ = true;
                } else {
                    let _e149 = p.member.light.range_squared;
                    if (_e132 <= _e149) {
                        let _e152 = p.member.light.cos_outer;
                        phi_501_ = (-((((_e114 * _e134.x) + (_e115 * _e134.y)) + (_e116 * _e134.z))) >= (_e152 * sqrt(_e132)));
                    } else {
                        phi_501_ = false;
                    }
                    let _e157 = phi_501_;
                    phi_502_ = _e157;
                }
                let _e159 = phi_502_;
                if _e159 {
                    let _e161 = samples.member[(0u + _e60.first_primitive)].flags;
                    let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e169.unnamed.visibility, false), _e169.unnamed_1);
                    phi_513_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e175.unnamed, ((_e161 & 1u) == 0u));
                    phi_514_ = false;
                } else {
                    phi_513_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_514_ = true;
                }
                let _e180 = phi_513_;
                let _e182 = phi_514_;
                phi_515_ = _e180;
                phi_516_ = _e182;
            } else {
                phi_515_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_516_ = true;
            }
            let _e184 = phi_515_;
            let _e186 = phi_516_;
            if _e186 {
                let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e192.unnamed.visibility, false), _e192.unnamed_1);
                phi_523_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e198.unnamed, true);
            } else {
                phi_523_ = _e184;
            }
            let _e203 = phi_523_;
            phi_527_ = _e203;
        } else {
            let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e209.unnamed.visibility, false), _e209.unnamed_1);
            phi_527_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e215.unnamed, true);
        }
        let _e220 = phi_527_;
        if _e220.unnamed_1 {
            phi_1262_ = evaluate_Verdict(_e220.unnamed.visibility, _e220.unnamed.is_doubted);
            phi_1263_ = evaluate_Verdict();
            phi_1264_ = true;
        } else {
            let _e228 = samples.member[(0u + _e60.first_primitive)].position;
            let _e230 = p.member.map_size;
            let _e232 = (0.5f / f32(_e230));
            let _e239 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e246 = lt_math_LightPoint(vec2<f32>(_e239.uv.x, 0f), _e239.depth, _e239.is_inside);
            let _e250 = lt_math_LightPoint(_e246.uv, 0f, _e246.is_inside);
            phi_547_ = lt_math_LightPoint();
            phi_550_ = 0u;
            phi_552_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e250.uv, _e250.depth, false));
            loop {
                let _e257 = phi_547_;
                let _e259 = phi_550_;
                let _e261 = phi_552_;
                local_1 = _e261;
                local_2 = _e261;
                local_3 = _e261;
                local_4 = _e261;
                if (_e259 < _e66) {
                    if _e261.point.is_inside {
                        phi_713_ = lt_math_LightPoint();
                        phi_714_ = u32();
                        phi_715_ = lt_math_LevelPoint();
                        phi_716_ = false;
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
                                phi_638_ = (_e297 <= 1f);
                            } else {
                                phi_638_ = false;
                            }
                            let _e329 = phi_638_;
                            if _e329 {
                                if (_e311 >= 0f) {
                                    phi_647_ = (_e311 <= 1f);
                                } else {
                                    phi_647_ = false;
                                }
                                let _e333 = phi_647_;
                                if _e333 {
                                    if (_e324 >= 0f) {
                                        phi_656_ = (_e324 <= 1f);
                                    } else {
                                        phi_656_ = false;
                                    }
                                    let _e337 = phi_656_;
                                    phi_657_ = _e337;
                                    phi_658_ = false;
                                } else {
                                    phi_657_ = bool();
                                    phi_658_ = true;
                                }
                                let _e339 = phi_657_;
                                let _e341 = phi_658_;
                                phi_659_ = _e339;
                                phi_660_ = _e341;
                            } else {
                                phi_659_ = bool();
                                phi_660_ = true;
                            }
                            let _e343 = phi_659_;
                            let _e345 = phi_660_;
                            phi_661_ = _e343;
                            phi_662_ = _e345;
                        } else {
                            phi_661_ = bool();
                            phi_662_ = true;
                        }
                        let _e347 = phi_661_;
                        let _e349 = phi_662_;
                        if _e349 {
                            phi_666_ = false;
                        } else {
                            phi_666_ = _e347;
                        }
                        let _e351 = phi_666_;
                        if _e351 {
                            if (_e297 >= _e232) {
                                if (_e297 <= (1f - _e232)) {
                                    if (_e311 >= _e232) {
                                        phi_693_ = (_e311 <= (1f - _e232));
                                        phi_694_ = false;
                                    } else {
                                        phi_693_ = bool();
                                        phi_694_ = true;
                                    }
                                    let _e359 = phi_693_;
                                    let _e361 = phi_694_;
                                    phi_695_ = _e359;
                                    phi_696_ = _e361;
                                } else {
                                    phi_695_ = bool();
                                    phi_696_ = true;
                                }
                                let _e363 = phi_695_;
                                let _e365 = phi_696_;
                                phi_697_ = _e363;
                                phi_698_ = _e365;
                            } else {
                                phi_697_ = bool();
                                phi_698_ = true;
                            }
                            let _e367 = phi_697_;
                            let _e369 = phi_698_;
                            phi_699_ = _e367;
                            phi_700_ = _e369;
                        } else {
                            phi_699_ = bool();
                            phi_700_ = true;
                        }
                        let _e371 = phi_699_;
                        let _e373 = phi_700_;
                        if _e373 {
                            phi_704_ = false;
                        } else {
                            phi_704_ = _e371;
                        }
                        let _e375 = phi_704_;
                        let _e382 = lt_math_LightPoint(vec2<f32>(_e297, _e257.uv.y), _e257.depth, _e257.is_inside);
                        let _e389 = lt_math_LightPoint(vec2<f32>(_e382.uv.x, _e311), _e382.depth, _e382.is_inside);
                        let _e393 = lt_math_LightPoint(_e389.uv, _e324, _e389.is_inside);
                        let _e397 = lt_math_LightPoint(_e393.uv, _e393.depth, _e375);
                        phi_713_ = _e397;
                        phi_714_ = (_e259 + 1u);
                        phi_715_ = lt_math_LevelPoint(_e259, _e397);
                        phi_716_ = true;
                    }
                    let _e401 = phi_713_;
                    let _e403 = phi_714_;
                    let _e405 = phi_715_;
                    let _e407 = phi_716_;
                    phi_548_ = _e401;
                    phi_551_ = _e403;
                    phi_553_ = _e405;
                    phi_717_ = _e407;
                } else {
                    phi_548_ = lt_math_LightPoint();
                    phi_551_ = u32();
                    phi_553_ = lt_math_LevelPoint();
                    phi_717_ = false;
                }
                let _e409 = phi_548_;
                let _e411 = phi_551_;
                let _e413 = phi_553_;
                let _e415 = phi_717_;
                continue;
                continuing {
                    phi_547_ = _e409;
                    phi_550_ = _e411;
                    phi_552_ = _e413;
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
                            phi_757_ = (_e429.row_w.z == _e441);
                            phi_758_ = false;
                        } else {
                            phi_757_ = bool();
                            phi_758_ = true;
                        }
                        let _e444 = phi_757_;
                        let _e446 = phi_758_;
                        phi_759_ = _e444;
                        phi_760_ = _e446;
                    } else {
                        phi_759_ = bool();
                        phi_760_ = true;
                    }
                    let _e448 = phi_759_;
                    let _e450 = phi_760_;
                    if _e450 {
                        phi_764_ = false;
                    } else {
                        phi_764_ = _e448;
                    }
                    let _e452 = phi_764_;
                    if _e452 {
                        let _e454 = samples.member[(0u + _e60.first_primitive)].normal;
                        let _e456 = p.member.map_size;
                        let _e526 = ((abs(((((_e429.row_x.x * _e454.x) + (_e429.row_x.y * _e454.y)) + (_e429.row_x.z * _e454.z)) / (((_e429.row_x.x * _e429.row_x.x) + (_e429.row_x.y * _e429.row_x.y)) + (_e429.row_x.z * _e429.row_x.z)))) + abs(((((_e429.row_y.x * _e454.x) + (_e429.row_y.y * _e454.y)) + (_e429.row_y.z * _e454.z)) / (((_e429.row_y.x * _e429.row_y.x) + (_e429.row_y.y * _e429.row_y.y)) + (_e429.row_y.z * _e429.row_y.z))))) / (abs(((((_e429.row_z.x * _e454.x) + (_e429.row_z.y * _e454.y)) + (_e429.row_z.z * _e454.z)) / (((_e429.row_z.x * _e429.row_z.x) + (_e429.row_z.y * _e429.row_z.y)) + (_e429.row_z.z * _e429.row_z.z)))) * f32(_e456)));
                        if (_e526 < 0.002f) {
                            phi_846_ = _e526;
                        } else {
                            phi_846_ = 0.002f;
                        }
                        let _e529 = phi_846_;
                        phi_963_ = _e529;
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
                            phi_962_ = _e643;
                        } else {
                            phi_962_ = 0.002f;
                        }
                        let _e646 = phi_962_;
                        phi_963_ = _e646;
                    }
                    let _e648 = phi_963_;
                    phi_966_ = (_e418.point.depth - (0f * _e648));
                } else {
                    phi_966_ = _e418.point.depth;
                }
                let _e652 = phi_966_;
                let _e658 = p.member.map_size;
                let _e659 = f32(_e658);
                let _e662 = ((_e418.point.uv.x * _e659) - 0.5f);
                let _e663 = ((_e418.point.uv.y * _e659) - 0.5f);
                if (_e662 > -8388608f) {
                    let _e675 = f32(select(0i, select(select(i32(_e662), i32(-2147483648), (_e662 < bitcast<f32>(3472883712u))), 2147483647i, (_e662 > bitcast<f32>(1325400063u))), (_e662 == _e662)));
                    if (_e675 > _e662) {
                        phi_995_ = 1f;
                    } else {
                        phi_995_ = 0f;
                    }
                    let _e678 = phi_995_;
                    if (_e662 < 8388608f) {
                        phi_1000_ = (_e675 - _e678);
                        phi_1001_ = false;
                    } else {
                        phi_1000_ = f32();
                        phi_1001_ = true;
                    }
                    let _e681 = phi_1000_;
                    let _e683 = phi_1001_;
                    phi_1002_ = _e681;
                    phi_1003_ = _e683;
                } else {
                    phi_1002_ = f32();
                    phi_1003_ = true;
                }
                let _e685 = phi_1002_;
                let _e687 = phi_1003_;
                if _e687 {
                    phi_1007_ = _e662;
                } else {
                    phi_1007_ = _e685;
                }
                let _e689 = phi_1007_;
                if (_e663 > -8388608f) {
                    let _e701 = f32(select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < bitcast<f32>(3472883712u))), 2147483647i, (_e663 > bitcast<f32>(1325400063u))), (_e663 == _e663)));
                    if (_e701 > _e663) {
                        phi_1027_ = 1f;
                    } else {
                        phi_1027_ = 0f;
                    }
                    let _e704 = phi_1027_;
                    if (_e663 < 8388608f) {
                        phi_1032_ = (_e701 - _e704);
                        phi_1033_ = false;
                    } else {
                        phi_1032_ = f32();
                        phi_1033_ = true;
                    }
                    let _e707 = phi_1032_;
                    let _e709 = phi_1033_;
                    phi_1034_ = _e707;
                    phi_1035_ = _e709;
                } else {
                    phi_1034_ = f32();
                    phi_1035_ = true;
                }
                let _e711 = phi_1034_;
                let _e713 = phi_1035_;
                if _e713 {
                    phi_1039_ = _e663;
                } else {
                    phi_1039_ = _e711;
                }
                let _e715 = phi_1039_;
                let _e716 = (_e662 - _e689);
                let _e717 = (_e663 - _e715);
                let _e726 = select(0i, select(select(i32(_e689), i32(-2147483648), (_e689 < bitcast<f32>(3472883712u))), 2147483647i, (_e689 > bitcast<f32>(1325400063u))), (_e689 == _e689));
                let _e735 = select(0i, select(select(i32(_e715), i32(-2147483648), (_e715 < bitcast<f32>(3472883712u))), 2147483647i, (_e715 > bitcast<f32>(1325400063u))), (_e715 == _e715));
                let _e738 = ((1f - _e716) * (1f - _e717));
                let _e740 = (_e716 * (1f - _e717));
                let _e742 = ((1f - _e716) * _e717);
                let _e743 = (_e716 * _e717);
                let _e745 = p.member.test;
                let _e746 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e745);
                let _e748 = p.member.map_size;
                let _e750 = local_3;
                local = _e746;
                let _e753 = ((_e750.level * _e748) * _e748);
                let _e755 = (bitcast<i32>(_e748) - 1i);
                if (_e726 > 0i) {
                    phi_1088_ = _e726;
                } else {
                    phi_1088_ = 0i;
                }
                let _e758 = phi_1088_;
                if (_e735 > 0i) {
                    phi_1093_ = _e735;
                } else {
                    phi_1093_ = 0i;
                }
                let _e761 = phi_1093_;
                if (_e758 < _e755) {
                    phi_1098_ = _e758;
                } else {
                    phi_1098_ = _e755;
                }
                let _e764 = phi_1098_;
                if (_e761 < _e755) {
                    phi_1103_ = _e761;
                } else {
                    phi_1103_ = _e755;
                }
                let _e767 = phi_1103_;
                let _e768 = bitcast<u32>(_e764);
                let _e770 = (_e726 + 1i);
                let _e771 = (_e735 + 1i);
                if (_e770 > 0i) {
                    phi_1112_ = _e770;
                } else {
                    phi_1112_ = 0i;
                }
                let _e774 = phi_1112_;
                if (_e771 > 0i) {
                    phi_1117_ = _e771;
                } else {
                    phi_1117_ = 0i;
                }
                let _e777 = phi_1117_;
                if (_e774 < _e755) {
                    phi_1122_ = _e774;
                } else {
                    phi_1122_ = _e755;
                }
                let _e780 = phi_1122_;
                if (_e777 < _e755) {
                    phi_1127_ = _e777;
                } else {
                    phi_1127_ = _e755;
                }
                let _e783 = phi_1127_;
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
                let _e857 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e799.x * _e738) + (_e811.x * _e740)) + (_e827.x * _e742)) + (_e843.x * _e743)), ((((_e799.y * _e738) + (_e811.y * _e740)) + (_e827.y * _e742)) + (_e843.y * _e743)), ((((_e799.z * _e738) + (_e811.z * _e740)) + (_e827.z * _e742)) + (_e843.z * _e743)), ((((_e799.w * _e738) + (_e811.w * _e740)) + (_e827.w * _e742)) + (_e843.w * _e743))), _e652);
                let _e859 = p.member.fade_uv;
                if (_e859 > 0f) {
                    let _e862 = local_4;
                    if ((_e862.level + 1u) == _e66) {
                        let _e871 = p.member.fade_uv;
                        let _e873 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e418.point.uv.x, (1f - _e418.point.uv.x));
                        let _e875 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e418.point.uv.y, (1f - _e418.point.uv.y));
                        let _e876 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e873, _e875);
                        if (_e876 < _e871) {
                            phi_1243_ = (1f - ((1f - _e857) * (_e876 / _e871)));
                        } else {
                            phi_1243_ = _e857;
                        }
                        let _e883 = phi_1243_;
                        phi_1245_ = evaluate_Verdict(_e883, false);
                        phi_1246_ = false;
                    } else {
                        phi_1245_ = evaluate_Verdict();
                        phi_1246_ = true;
                    }
                    let _e886 = phi_1245_;
                    let _e888 = phi_1246_;
                    phi_1247_ = _e886;
                    phi_1248_ = _e888;
                } else {
                    phi_1247_ = evaluate_Verdict();
                    phi_1248_ = true;
                }
                let _e890 = phi_1247_;
                let _e892 = phi_1248_;
                if _e892 {
                    phi_1253_ = evaluate_Verdict(_e857, false);
                    phi_1254_ = false;
                } else {
                    phi_1253_ = evaluate_Verdict();
                    phi_1254_ = true;
                }
                let _e895 = phi_1253_;
                let _e897 = phi_1254_;
                phi_1256_ = _e895;
                phi_1257_ = _e890;
                phi_1258_ = _e897;
            } else {
                phi_1256_ = evaluate_Verdict();
                phi_1257_ = evaluate_Verdict(1f, false);
                phi_1258_ = true;
            }
            let _e900 = phi_1256_;
            let _e902 = phi_1257_;
            let _e904 = phi_1258_;
            if _e904 {
            }
            phi_1262_ = _e902;
            phi_1263_ = _e900;
            phi_1264_ = _e904;
        }
        let _e906 = phi_1262_;
        let _e908 = phi_1263_;
        let _e910 = phi_1264_;
        if _e910 {
            phi_1268_ = _e906;
        } else {
            phi_1268_ = _e908;
        }
        let _e912 = phi_1268_;
        if (_e60.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e60.first_primitive)] = _e912.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
