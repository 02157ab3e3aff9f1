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

struct type_19 {
    member: array<abi_Sample>,
}

struct type_23 {
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
var<storage> samples: type_19;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(2) 
var<storage> map: type_23;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_23;
@group(0) @binding(4) 
var<storage> marks: type_9;
@group(0) @binding(5) 
var<storage> levels: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_164_: lt_bvh_traverse_Tree;
    var phi_165_: bool;
    var phi_170_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_162_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_163_ = false;
        } else {
            phi_162_ = lt_bvh_traverse_Tree();
            phi_163_ = true;
        }
        let _e58 = phi_162_;
        let _e60 = phi_163_;
        phi_164_ = _e58;
        phi_165_ = _e60;
    } else {
        phi_164_ = lt_bvh_traverse_Tree();
        phi_165_ = true;
    }
    let _e62 = phi_164_;
    let _e64 = phi_165_;
    if _e64 {
        phi_170_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_170_ = _e62;
    }
    let _e69 = phi_170_;
    return lt_bvh_traverse_Tree(_e69.root, _e69.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_196_: f32;
    var phi_197_: f32;
    var phi_198_: f32;
    var phi_214_: f32;
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_232_: f32;
    var phi_233_: f32;
    var phi_234_: f32;
    var phi_250_: f32;
    var phi_251_: f32;
    var phi_252_: f32;
    var phi_268_: f32;
    var phi_269_: f32;
    var phi_270_: f32;
    var phi_316_: bool;
    var phi_320_: f32;
    var phi_332_: bool;
    var phi_339_: f32;
    var phi_354_: f32;
    var phi_355_: f32;
    var phi_356_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_198_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_197_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_196_ = 1f;
            } else {
                phi_196_ = param_7;
            }
            let _e55 = phi_196_;
            phi_197_ = _e55;
        }
        let _e57 = phi_197_;
        phi_198_ = _e57;
    }
    let _e59 = phi_198_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_216_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_215_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_214_ = 1f;
            } else {
                phi_214_ = param_5.x;
            }
            let _e67 = phi_214_;
            phi_215_ = _e67;
        }
        let _e69 = phi_215_;
        phi_216_ = _e69;
    }
    let _e71 = phi_216_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_234_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_233_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_232_ = 1f;
            } else {
                phi_232_ = param_5.y;
            }
            let _e79 = phi_232_;
            phi_233_ = _e79;
        }
        let _e81 = phi_233_;
        phi_234_ = _e81;
    }
    let _e83 = phi_234_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_252_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_251_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_250_ = 1f;
            } else {
                phi_250_ = param_5.z;
            }
            let _e91 = phi_250_;
            phi_251_ = _e91;
        }
        let _e93 = phi_251_;
        phi_252_ = _e93;
    }
    let _e95 = phi_252_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_270_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_269_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_268_ = 1f;
            } else {
                phi_268_ = param_5.w;
            }
            let _e103 = phi_268_;
            phi_269_ = _e103;
        }
        let _e105 = phi_269_;
        phi_270_ = _e105;
    }
    let _e107 = phi_270_;
    let _e108 = (_e71 - _e59);
    let _e109 = (_e83 - _e59);
    let _e110 = (_e95 - _e59);
    let _e111 = (_e107 - _e59);
    let _e112 = (*param_4);
    let _e123 = ((((_e108 * param_6.x) + (_e109 * param_6.y)) + (_e110 * param_6.z)) + (_e111 * param_6.w));
    let _e124 = (_e108 - _e123);
    let _e125 = (_e109 - _e123);
    let _e126 = (_e110 - _e123);
    let _e127 = (_e111 - _e123);
    let _e142 = (((((_e124 * _e124) * param_6.x) + ((_e125 * _e125) * param_6.y)) + ((_e126 * _e126) * param_6.z)) + ((_e127 * _e127) * param_6.w));
    if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
        phi_316_ = true;
    } else {
        let _e146 = (_e112 > _e142);
        if _e146 {
        }
        phi_316_ = _e146;
    }
    let _e148 = phi_316_;
    if _e148 {
        phi_320_ = _e112;
    } else {
        phi_320_ = _e142;
    }
    let _e150 = phi_320_;
    let _e151 = -(_e123);
    if (_e151 <= 0f) {
        let _e155 = ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u);
        if _e155 {
        }
        phi_332_ = _e155;
    } else {
        phi_332_ = true;
    }
    let _e157 = phi_332_;
    if _e157 {
        phi_339_ = (_e150 / (_e150 + (_e151 * _e151)));
    } else {
        phi_339_ = 1f;
    }
    let _e162 = phi_339_;
    if ((bitcast<u32>(_e162) & 2147483647u) > 2139095040u) {
        phi_356_ = _e162;
    } else {
        if (_e162 < 0f) {
            phi_355_ = 0f;
        } else {
            if (_e162 > 1f) {
                phi_354_ = 1f;
            } else {
                phi_354_ = _e162;
            }
            let _e169 = phi_354_;
            phi_355_ = _e169;
        }
        let _e171 = phi_355_;
        phi_356_ = _e171;
    }
    let _e173 = phi_356_;
    return _e173;
}

fn function_() {
    var local: f32;
    var phi_422_: bool;
    var phi_423_: bool;
    var phi_424_: bool;
    var phi_425_: bool;
    var phi_429_: bool;
    var phi_499_: bool;
    var phi_500_: bool;
    var phi_511_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_512_: bool;
    var phi_513_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_514_: bool;
    var phi_521_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_525_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_545_: lt_math_LightPoint;
    var phi_548_: u32;
    var phi_550_: lt_math_LevelPoint;
    var phi_636_: bool;
    var phi_645_: bool;
    var phi_654_: bool;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_664_: bool;
    var phi_691_: bool;
    var phi_692_: bool;
    var phi_693_: bool;
    var phi_694_: bool;
    var phi_695_: bool;
    var phi_696_: bool;
    var phi_697_: bool;
    var phi_698_: bool;
    var phi_702_: bool;
    var phi_711_: lt_math_LightPoint;
    var phi_712_: u32;
    var phi_713_: lt_math_LevelPoint;
    var phi_714_: bool;
    var phi_546_: lt_math_LightPoint;
    var phi_549_: u32;
    var phi_551_: lt_math_LevelPoint;
    var phi_715_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_755_: bool;
    var phi_756_: bool;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_762_: bool;
    var phi_844_: f32;
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
    var phi_1090_: i32;
    var phi_1095_: i32;
    var phi_1100_: i32;
    var phi_1105_: i32;
    var phi_1114_: i32;
    var phi_1119_: i32;
    var phi_1124_: i32;
    var phi_1129_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1185_: i32;
    var phi_1190_: i32;
    var phi_1195_: i32;
    var phi_1200_: i32;
    var phi_1219_: i32;
    var phi_1224_: i32;
    var phi_1229_: i32;
    var phi_1234_: i32;
    var phi_1253_: i32;
    var phi_1258_: i32;
    var phi_1263_: i32;
    var phi_1268_: i32;
    var phi_1287_: i32;
    var phi_1292_: i32;
    var phi_1297_: i32;
    var phi_1302_: i32;
    var phi_1380_: bool;
    var phi_1388_: bool;
    var phi_1400_: bool;
    var phi_1401_: bool;
    var phi_1405_: f32;
    var phi_1411_: f32;
    var phi_1413_: evaluate_Verdict;
    var phi_1423_: u32;
    var phi_1432_: f32;
    var phi_1434_: evaluate_Verdict;
    var phi_1435_: bool;
    var phi_1436_: evaluate_Verdict;
    var phi_1437_: bool;
    var phi_1442_: evaluate_Verdict;
    var phi_1447_: evaluate_Verdict;
    var phi_1448_: evaluate_Verdict;

    let _e46 = id_1;
    let _e53 = arrayLength((&map.member));
    let _e59 = arrayLength((&marks.member));
    let _e62 = arrayLength((&levels.member));
    let _e65 = p.member.size[0u];
    let _e67 = p.member.size[1u];
    let _e68 = lt_shaders_entry_pixel_index(_e46, _e65, _e67);
    if (bitcast<i32>(_e68.root) != 0i) {
        let _e74 = p.member.level_count;
        if (_e68.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e81 = samples.member[(0u + _e68.first_primitive)].normal[0u];
        let _e83 = global[0u];
        if (_e81 == _e83) {
            let _e86 = samples.member[(0u + _e68.first_primitive)].normal[1u];
            let _e88 = global[1u];
            if (_e86 == _e88) {
                let _e91 = samples.member[(0u + _e68.first_primitive)].normal[2u];
                let _e93 = global[2u];
                phi_422_ = (_e91 == _e93);
                phi_423_ = false;
            } else {
                phi_422_ = bool();
                phi_423_ = true;
            }
            let _e96 = phi_422_;
            let _e98 = phi_423_;
            phi_424_ = _e96;
            phi_425_ = _e98;
        } else {
            phi_424_ = bool();
            phi_425_ = true;
        }
        let _e100 = phi_424_;
        let _e102 = phi_425_;
        if _e102 {
            phi_429_ = false;
        } else {
            phi_429_ = _e100;
        }
        let _e104 = phi_429_;
        if !(_e104) {
            let _e107 = samples.member[(0u + _e68.first_primitive)].position;
            let _e109 = p.member.light.place;
            let _e115 = p.member.light.place[3u];
            let _e122 = (_e109.x - (_e107.x * _e115));
            let _e123 = (_e109.y - (_e107.y * _e115));
            let _e124 = (_e109.z - (_e107.z * _e115));
            let _e126 = samples.member[(0u + _e68.first_primitive)].normal;
            if ((((_e126.x * _e122) + (_e126.y * _e123)) + (_e126.z * _e124)) > 0f) {
                let _e140 = (((_e122 * _e122) + (_e123 * _e123)) + (_e124 * _e124));
                let _e142 = p.member.light.axis;
                let _e154 = p.member.light.place[3u];
                if (_e154 == 0f) {
                    phi_500_ = true;
                } else {
                    let _e157 = p.member.light.range_squared;
                    if (_e140 <= _e157) {
                        let _e160 = p.member.light.cos_outer;
                        phi_499_ = (-((((_e122 * _e142.x) + (_e123 * _e142.y)) + (_e124 * _e142.z))) >= (_e160 * sqrt(_e140)));
                    } else {
                        phi_499_ = false;
                    }
                    let _e165 = phi_499_;
                    phi_500_ = _e165;
                }
                let _e167 = phi_500_;
                if _e167 {
                    let _e169 = samples.member[(0u + _e68.first_primitive)].flags;
                    let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e177.unnamed.visibility, false), _e177.unnamed_1);
                    phi_511_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e183.unnamed, ((_e169 & 1u) == 0u));
                    phi_512_ = false;
                } else {
                    phi_511_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_512_ = true;
                }
                let _e188 = phi_511_;
                let _e190 = phi_512_;
                phi_513_ = _e188;
                phi_514_ = _e190;
            } else {
                phi_513_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_514_ = true;
            }
            let _e192 = phi_513_;
            let _e194 = phi_514_;
            if _e194 {
                let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e200.unnamed.visibility, false), _e200.unnamed_1);
                phi_521_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e206.unnamed, true);
            } else {
                phi_521_ = _e192;
            }
            let _e211 = phi_521_;
            phi_525_ = _e211;
        } else {
            let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e223 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e217.unnamed.visibility, false), _e217.unnamed_1);
            phi_525_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e223.unnamed, true);
        }
        let _e228 = phi_525_;
        if _e228.unnamed_1 {
            phi_1448_ = evaluate_Verdict(_e228.unnamed.visibility, _e228.unnamed.is_doubted);
        } else {
            let _e236 = samples.member[(0u + _e68.first_primitive)].position;
            let _e238 = p.member.map_size;
            let _e240 = (0.5f / f32(_e238));
            let _e247 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e254 = lt_math_LightPoint(vec2<f32>(_e247.uv.x, 0f), _e247.depth, _e247.is_inside);
            let _e258 = lt_math_LightPoint(_e254.uv, 0f, _e254.is_inside);
            phi_545_ = lt_math_LightPoint();
            phi_548_ = 0u;
            phi_550_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e258.uv, _e258.depth, false));
            loop {
                let _e265 = phi_545_;
                let _e267 = phi_548_;
                let _e269 = phi_550_;
                local_1 = _e269;
                local_2 = _e269;
                local_3 = _e269;
                local_4 = _e269;
                if (_e267 < _e74) {
                    if _e269.point.is_inside {
                        phi_711_ = lt_math_LightPoint();
                        phi_712_ = u32();
                        phi_713_ = lt_math_LevelPoint();
                        phi_714_ = false;
                    } else {
                        if (_e267 < _e62) {
                        } else {
                            return;
                        }
                        let _e280 = levels.member[(0u + _e267)].row_w;
                        let _e291 = ((((_e280.x * _e236.x) + (_e280.y * _e236.y)) + (_e280.z * _e236.z)) + (_e280.w * 1f));
                        let _e293 = levels.member[(0u + _e267)].row_x;
                        let _e305 = (((((_e293.x * _e236.x) + (_e293.y * _e236.y)) + (_e293.z * _e236.z)) + (_e293.w * 1f)) / _e291);
                        let _e307 = levels.member[(0u + _e267)].row_y;
                        let _e319 = (((((_e307.x * _e236.x) + (_e307.y * _e236.y)) + (_e307.z * _e236.z)) + (_e307.w * 1f)) / _e291);
                        let _e321 = levels.member[(0u + _e267)].row_z;
                        let _e332 = ((((_e321.x * _e236.x) + (_e321.y * _e236.y)) + (_e321.z * _e236.z)) + (_e321.w * 1f));
                        if (_e291 > 0f) {
                            if (_e305 >= 0f) {
                                phi_636_ = (_e305 <= 1f);
                            } else {
                                phi_636_ = false;
                            }
                            let _e337 = phi_636_;
                            if _e337 {
                                if (_e319 >= 0f) {
                                    phi_645_ = (_e319 <= 1f);
                                } else {
                                    phi_645_ = false;
                                }
                                let _e341 = phi_645_;
                                if _e341 {
                                    if (_e332 >= 0f) {
                                        phi_654_ = (_e332 <= 1f);
                                    } else {
                                        phi_654_ = false;
                                    }
                                    let _e345 = phi_654_;
                                    phi_655_ = _e345;
                                    phi_656_ = false;
                                } else {
                                    phi_655_ = bool();
                                    phi_656_ = true;
                                }
                                let _e347 = phi_655_;
                                let _e349 = phi_656_;
                                phi_657_ = _e347;
                                phi_658_ = _e349;
                            } else {
                                phi_657_ = bool();
                                phi_658_ = true;
                            }
                            let _e351 = phi_657_;
                            let _e353 = phi_658_;
                            phi_659_ = _e351;
                            phi_660_ = _e353;
                        } else {
                            phi_659_ = bool();
                            phi_660_ = true;
                        }
                        let _e355 = phi_659_;
                        let _e357 = phi_660_;
                        if _e357 {
                            phi_664_ = false;
                        } else {
                            phi_664_ = _e355;
                        }
                        let _e359 = phi_664_;
                        if _e359 {
                            if (_e305 >= _e240) {
                                if (_e305 <= (1f - _e240)) {
                                    if (_e319 >= _e240) {
                                        phi_691_ = (_e319 <= (1f - _e240));
                                        phi_692_ = false;
                                    } else {
                                        phi_691_ = bool();
                                        phi_692_ = true;
                                    }
                                    let _e367 = phi_691_;
                                    let _e369 = phi_692_;
                                    phi_693_ = _e367;
                                    phi_694_ = _e369;
                                } else {
                                    phi_693_ = bool();
                                    phi_694_ = true;
                                }
                                let _e371 = phi_693_;
                                let _e373 = phi_694_;
                                phi_695_ = _e371;
                                phi_696_ = _e373;
                            } else {
                                phi_695_ = bool();
                                phi_696_ = true;
                            }
                            let _e375 = phi_695_;
                            let _e377 = phi_696_;
                            phi_697_ = _e375;
                            phi_698_ = _e377;
                        } else {
                            phi_697_ = bool();
                            phi_698_ = true;
                        }
                        let _e379 = phi_697_;
                        let _e381 = phi_698_;
                        if _e381 {
                            phi_702_ = false;
                        } else {
                            phi_702_ = _e379;
                        }
                        let _e383 = phi_702_;
                        let _e390 = lt_math_LightPoint(vec2<f32>(_e305, _e265.uv.y), _e265.depth, _e265.is_inside);
                        let _e397 = lt_math_LightPoint(vec2<f32>(_e390.uv.x, _e319), _e390.depth, _e390.is_inside);
                        let _e401 = lt_math_LightPoint(_e397.uv, _e332, _e397.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e401.depth, _e383);
                        phi_711_ = _e405;
                        phi_712_ = (_e267 + 1u);
                        phi_713_ = lt_math_LevelPoint(_e267, _e405);
                        phi_714_ = true;
                    }
                    let _e409 = phi_711_;
                    let _e411 = phi_712_;
                    let _e413 = phi_713_;
                    let _e415 = phi_714_;
                    phi_546_ = _e409;
                    phi_549_ = _e411;
                    phi_551_ = _e413;
                    phi_715_ = _e415;
                } else {
                    phi_546_ = lt_math_LightPoint();
                    phi_549_ = u32();
                    phi_551_ = lt_math_LevelPoint();
                    phi_715_ = false;
                }
                let _e417 = phi_546_;
                let _e419 = phi_549_;
                let _e421 = phi_551_;
                let _e423 = phi_715_;
                continue;
                continuing {
                    phi_545_ = _e417;
                    phi_548_ = _e419;
                    phi_550_ = _e421;
                    break if !(_e423);
                }
            }
            let _e426 = local_1;
            if _e426.point.is_inside {
                if (0f > 0f) {
                    let _e432 = local_2;
                    if (_e432.level < _e62) {
                    } else {
                        return;
                    }
                    let _e437 = levels.member[(0u + _e432.level)];
                    let _e443 = global[0u];
                    if (_e437.row_w.x == _e443) {
                        let _e446 = global[1u];
                        if (_e437.row_w.y == _e446) {
                            let _e449 = global[2u];
                            phi_755_ = (_e437.row_w.z == _e449);
                            phi_756_ = false;
                        } else {
                            phi_755_ = bool();
                            phi_756_ = true;
                        }
                        let _e452 = phi_755_;
                        let _e454 = phi_756_;
                        phi_757_ = _e452;
                        phi_758_ = _e454;
                    } else {
                        phi_757_ = bool();
                        phi_758_ = true;
                    }
                    let _e456 = phi_757_;
                    let _e458 = phi_758_;
                    if _e458 {
                        phi_762_ = false;
                    } else {
                        phi_762_ = _e456;
                    }
                    let _e460 = phi_762_;
                    if _e460 {
                        let _e462 = samples.member[(0u + _e68.first_primitive)].normal;
                        let _e464 = p.member.map_size;
                        let _e534 = ((abs(((((_e437.row_x.x * _e462.x) + (_e437.row_x.y * _e462.y)) + (_e437.row_x.z * _e462.z)) / (((_e437.row_x.x * _e437.row_x.x) + (_e437.row_x.y * _e437.row_x.y)) + (_e437.row_x.z * _e437.row_x.z)))) + abs(((((_e437.row_y.x * _e462.x) + (_e437.row_y.y * _e462.y)) + (_e437.row_y.z * _e462.z)) / (((_e437.row_y.x * _e437.row_y.x) + (_e437.row_y.y * _e437.row_y.y)) + (_e437.row_y.z * _e437.row_y.z))))) / (abs(((((_e437.row_z.x * _e462.x) + (_e437.row_z.y * _e462.y)) + (_e437.row_z.z * _e462.z)) / (((_e437.row_z.x * _e437.row_z.x) + (_e437.row_z.y * _e437.row_z.y)) + (_e437.row_z.z * _e437.row_z.z)))) * f32(_e464)));
                        if (_e534 < 0.002f) {
                            phi_844_ = _e534;
                        } else {
                            phi_844_ = 0.002f;
                        }
                        let _e537 = phi_844_;
                        phi_963_ = _e537;
                    } else {
                        let _e539 = p.member.map_size;
                        let _e545 = samples.member[(0u + _e68.first_primitive)].position;
                        let _e556 = ((((_e437.row_w.x * _e545.x) + (_e437.row_w.y * _e545.y)) + (_e437.row_w.z * _e545.z)) + _e437.row_w.w);
                        let _e569 = ((_e437.row_x.x - (_e437.row_w.x * _e426.point.uv.x)) / _e556);
                        let _e570 = ((_e437.row_x.y - (_e437.row_w.y * _e426.point.uv.x)) / _e556);
                        let _e571 = ((_e437.row_x.z - (_e437.row_w.z * _e426.point.uv.x)) / _e556);
                        let _e584 = ((_e437.row_y.x - (_e437.row_w.x * _e426.point.uv.y)) / _e556);
                        let _e585 = ((_e437.row_y.y - (_e437.row_w.y * _e426.point.uv.y)) / _e556);
                        let _e586 = ((_e437.row_y.z - (_e437.row_w.z * _e426.point.uv.y)) / _e556);
                        let _e592 = samples.member[(0u + _e68.first_primitive)].normal;
                        let _e597 = ((_e585 * _e592.z) - (_e592.y * _e586));
                        let _e602 = ((_e586 * _e592.x) - (_e592.z * _e584));
                        let _e607 = ((_e584 * _e592.y) - (_e592.x * _e585));
                        let _e609 = samples.member[(0u + _e68.first_primitive)].normal;
                        let _e614 = ((_e570 * _e609.z) - (_e609.y * _e571));
                        let _e619 = ((_e571 * _e609.x) - (_e609.z * _e569));
                        let _e624 = ((_e569 * _e609.y) - (_e609.x * _e570));
                        let _e651 = ((abs(((((_e437.row_z.x * _e597) + (_e437.row_z.y * _e602)) + (_e437.row_z.z * _e607)) / (((_e569 * _e597) + (_e570 * _e602)) + (_e571 * _e607)))) + abs(((((_e437.row_z.x * _e614) + (_e437.row_z.y * _e619)) + (_e437.row_z.z * _e624)) / (((_e584 * _e614) + (_e585 * _e619)) + (_e586 * _e624))))) / f32(_e539));
                        let _e653 = (16f / f32(_e539));
                        if (_e651 < _e653) {
                            phi_962_ = _e651;
                        } else {
                            phi_962_ = _e653;
                        }
                        let _e656 = phi_962_;
                        phi_963_ = _e656;
                    }
                    let _e658 = phi_963_;
                    phi_966_ = (_e426.point.depth - (0f * _e658));
                } else {
                    phi_966_ = _e426.point.depth;
                }
                let _e662 = phi_966_;
                let _e668 = p.member.map_size;
                let _e669 = f32(_e668);
                let _e672 = ((_e426.point.uv.x * _e669) - 0.5f);
                let _e673 = ((_e426.point.uv.y * _e669) - 0.5f);
                if (_e672 > -8388608f) {
                    let _e685 = f32(select(0i, select(select(i32(_e672), i32(-2147483648), (_e672 < bitcast<f32>(3472883712u))), 2147483647i, (_e672 > bitcast<f32>(1325400063u))), (_e672 == _e672)));
                    if (_e685 > _e672) {
                        phi_995_ = 1f;
                    } else {
                        phi_995_ = 0f;
                    }
                    let _e688 = phi_995_;
                    if (_e672 < 8388608f) {
                        phi_1000_ = (_e685 - _e688);
                        phi_1001_ = false;
                    } else {
                        phi_1000_ = f32();
                        phi_1001_ = true;
                    }
                    let _e691 = phi_1000_;
                    let _e693 = phi_1001_;
                    phi_1002_ = _e691;
                    phi_1003_ = _e693;
                } else {
                    phi_1002_ = f32();
                    phi_1003_ = true;
                }
                let _e695 = phi_1002_;
                let _e697 = phi_1003_;
                if _e697 {
                    phi_1007_ = _e672;
                } else {
                    phi_1007_ = _e695;
                }
                let _e699 = phi_1007_;
                if (_e673 > -8388608f) {
                    let _e711 = f32(select(0i, select(select(i32(_e673), i32(-2147483648), (_e673 < bitcast<f32>(3472883712u))), 2147483647i, (_e673 > bitcast<f32>(1325400063u))), (_e673 == _e673)));
                    if (_e711 > _e673) {
                        phi_1027_ = 1f;
                    } else {
                        phi_1027_ = 0f;
                    }
                    let _e714 = phi_1027_;
                    if (_e673 < 8388608f) {
                        phi_1032_ = (_e711 - _e714);
                        phi_1033_ = false;
                    } else {
                        phi_1032_ = f32();
                        phi_1033_ = true;
                    }
                    let _e717 = phi_1032_;
                    let _e719 = phi_1033_;
                    phi_1034_ = _e717;
                    phi_1035_ = _e719;
                } else {
                    phi_1034_ = f32();
                    phi_1035_ = true;
                }
                let _e721 = phi_1034_;
                let _e723 = phi_1035_;
                if _e723 {
                    phi_1039_ = _e673;
                } else {
                    phi_1039_ = _e721;
                }
                let _e725 = phi_1039_;
                let _e726 = (_e672 - _e699);
                let _e727 = (_e673 - _e725);
                let _e736 = select(0i, select(select(i32(_e699), i32(-2147483648), (_e699 < bitcast<f32>(3472883712u))), 2147483647i, (_e699 > bitcast<f32>(1325400063u))), (_e699 == _e699));
                let _e745 = select(0i, select(select(i32(_e725), i32(-2147483648), (_e725 < bitcast<f32>(3472883712u))), 2147483647i, (_e725 > bitcast<f32>(1325400063u))), (_e725 == _e725));
                let _e756 = p.member.test;
                let _e757 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e756);
                let _e759 = p.member.map_size;
                let _e761 = local_3;
                local = _e757;
                let _e764 = ((_e761.level * _e759) * _e759);
                let _e766 = (bitcast<i32>(_e759) - 1i);
                if (_e736 > 0i) {
                    phi_1090_ = _e736;
                } else {
                    phi_1090_ = 0i;
                }
                let _e769 = phi_1090_;
                if (_e745 > 0i) {
                    phi_1095_ = _e745;
                } else {
                    phi_1095_ = 0i;
                }
                let _e772 = phi_1095_;
                if (_e769 < _e766) {
                    phi_1100_ = _e769;
                } else {
                    phi_1100_ = _e766;
                }
                let _e775 = phi_1100_;
                if (_e772 < _e766) {
                    phi_1105_ = _e772;
                } else {
                    phi_1105_ = _e766;
                }
                let _e778 = phi_1105_;
                let _e779 = bitcast<u32>(_e775);
                let _e781 = (_e736 + 1i);
                let _e782 = (_e745 + 1i);
                if (_e781 > 0i) {
                    phi_1114_ = _e781;
                } else {
                    phi_1114_ = 0i;
                }
                let _e785 = phi_1114_;
                if (_e782 > 0i) {
                    phi_1119_ = _e782;
                } else {
                    phi_1119_ = 0i;
                }
                let _e788 = phi_1119_;
                if (_e785 < _e766) {
                    phi_1124_ = _e785;
                } else {
                    phi_1124_ = _e766;
                }
                let _e791 = phi_1124_;
                if (_e788 < _e766) {
                    phi_1129_ = _e788;
                } else {
                    phi_1129_ = _e766;
                }
                let _e794 = phi_1129_;
                let _e795 = bitcast<u32>(_e791);
                let _e797 = (bitcast<u32>(_e778) * _e759);
                let _e798 = (bitcast<u32>(_e794) * _e759);
                let _e803 = ((_e797 + _e779) + _e764);
                let _e804 = ((_e797 + _e795) + _e764);
                let _e805 = ((_e798 + _e779) + _e764);
                let _e806 = ((_e798 + _e795) + _e764);
                if (_e803 < _e53) {
                } else {
                    return;
                }
                let _e810 = map.member[(0u + _e803)];
                if (_e804 < _e53) {
                } else {
                    return;
                }
                let _e814 = map.member[(0u + _e804)];
                if (_e805 < _e53) {
                } else {
                    return;
                }
                let _e818 = map.member[(0u + _e805)];
                if (_e806 < _e53) {
                } else {
                    return;
                }
                let _e822 = map.member[(0u + _e806)];
                let _e824 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e810, _e814, _e818, _e822), vec4<f32>(((1f - _e726) * (1f - _e727)), (_e726 * (1f - _e727)), ((1f - _e726) * _e727), (_e726 * _e727)), _e662);
                let _e826 = p.member.map_size;
                let _e828 = local_4;
                let _e831 = (bitcast<i32>(_e826) - 1i);
                if (_e736 > 0i) {
                    phi_1185_ = _e736;
                } else {
                    phi_1185_ = 0i;
                }
                let _e834 = phi_1185_;
                if (_e745 > 0i) {
                    phi_1190_ = _e745;
                } else {
                    phi_1190_ = 0i;
                }
                let _e837 = phi_1190_;
                if (_e834 < _e831) {
                    phi_1195_ = _e834;
                } else {
                    phi_1195_ = _e831;
                }
                let _e840 = phi_1195_;
                if (_e837 < _e831) {
                    phi_1200_ = _e837;
                } else {
                    phi_1200_ = _e831;
                }
                let _e843 = phi_1200_;
                let _e844 = bitcast<u32>(_e840);
                let _e851 = ((((_e828.level * _e826) + bitcast<u32>(_e843)) * (_e826 / 16u)) + (_e844 / 16u));
                let _e854 = (_e736 + 1i);
                let _e855 = (_e745 + 0i);
                let _e857 = (bitcast<i32>(_e826) - 1i);
                if (_e854 > 0i) {
                    phi_1219_ = _e854;
                } else {
                    phi_1219_ = 0i;
                }
                let _e860 = phi_1219_;
                if (_e855 > 0i) {
                    phi_1224_ = _e855;
                } else {
                    phi_1224_ = 0i;
                }
                let _e863 = phi_1224_;
                if (_e860 < _e857) {
                    phi_1229_ = _e860;
                } else {
                    phi_1229_ = _e857;
                }
                let _e866 = phi_1229_;
                if (_e863 < _e857) {
                    phi_1234_ = _e863;
                } else {
                    phi_1234_ = _e857;
                }
                let _e869 = phi_1234_;
                let _e870 = bitcast<u32>(_e866);
                let _e877 = ((((_e828.level * _e826) + bitcast<u32>(_e869)) * (_e826 / 16u)) + (_e870 / 16u));
                let _e880 = (_e736 + 0i);
                let _e881 = (_e745 + 1i);
                let _e883 = (bitcast<i32>(_e826) - 1i);
                if (_e880 > 0i) {
                    phi_1253_ = _e880;
                } else {
                    phi_1253_ = 0i;
                }
                let _e886 = phi_1253_;
                if (_e881 > 0i) {
                    phi_1258_ = _e881;
                } else {
                    phi_1258_ = 0i;
                }
                let _e889 = phi_1258_;
                if (_e886 < _e883) {
                    phi_1263_ = _e886;
                } else {
                    phi_1263_ = _e883;
                }
                let _e892 = phi_1263_;
                if (_e889 < _e883) {
                    phi_1268_ = _e889;
                } else {
                    phi_1268_ = _e883;
                }
                let _e895 = phi_1268_;
                let _e896 = bitcast<u32>(_e892);
                let _e903 = ((((_e828.level * _e826) + bitcast<u32>(_e895)) * (_e826 / 16u)) + (_e896 / 16u));
                let _e906 = (_e736 + 1i);
                let _e907 = (_e745 + 1i);
                let _e909 = (bitcast<i32>(_e826) - 1i);
                if (_e906 > 0i) {
                    phi_1287_ = _e906;
                } else {
                    phi_1287_ = 0i;
                }
                let _e912 = phi_1287_;
                if (_e907 > 0i) {
                    phi_1292_ = _e907;
                } else {
                    phi_1292_ = 0i;
                }
                let _e915 = phi_1292_;
                if (_e912 < _e909) {
                    phi_1297_ = _e912;
                } else {
                    phi_1297_ = _e909;
                }
                let _e918 = phi_1297_;
                if (_e915 < _e909) {
                    phi_1302_ = _e915;
                } else {
                    phi_1302_ = _e909;
                }
                let _e921 = phi_1302_;
                let _e922 = bitcast<u32>(_e918);
                let _e929 = ((((_e828.level * _e826) + bitcast<u32>(_e921)) * (_e826 / 16u)) + (_e922 / 16u));
                if (_e851 < _e59) {
                } else {
                    return;
                }
                let _e935 = marks.member[(0u + _e851)];
                if (_e877 < _e59) {
                } else {
                    return;
                }
                let _e943 = marks.member[(0u + _e877)];
                if (_e903 < _e59) {
                } else {
                    return;
                }
                let _e952 = marks.member[(0u + _e903)];
                if (_e929 < _e59) {
                } else {
                    return;
                }
                let _e960 = marks.member[(0u + _e929)];
                let _e968 = p.member.epsilon;
                if (_e824 <= _e968) {
                    phi_1380_ = true;
                } else {
                    phi_1380_ = (_e824 >= (1f - _e968));
                }
                let _e973 = phi_1380_;
                if ((bitcast<u32>(_e824) & 2147483647u) > 2139095040u) {
                    phi_1388_ = true;
                } else {
                    phi_1388_ = !(_e973);
                }
                let _e979 = phi_1388_;
                if _e979 {
                    if (_e824 > 0f) {
                        if (_e824 < 1f) {
                            phi_1400_ = false;
                        } else {
                            phi_1400_ = true;
                        }
                        let _e983 = phi_1400_;
                        phi_1401_ = _e983;
                    } else {
                        phi_1401_ = true;
                    }
                    let _e985 = phi_1401_;
                    if _e985 {
                        phi_1405_ = 0.5f;
                    } else {
                        phi_1405_ = _e824;
                    }
                    let _e987 = phi_1405_;
                    phi_1413_ = evaluate_Verdict(_e987, true);
                } else {
                    if (_e824 > 0.5f) {
                        phi_1411_ = 1f;
                    } else {
                        phi_1411_ = 0f;
                    }
                    let _e991 = phi_1411_;
                    phi_1413_ = evaluate_Verdict(_e991, false);
                }
                let _e994 = phi_1413_;
                let _e997 = (_e994.visibility < 0.5f);
                if _e994.is_doubted {
                    phi_1436_ = evaluate_Verdict();
                    phi_1437_ = true;
                } else {
                    if _e997 {
                        phi_1423_ = 2u;
                    } else {
                        phi_1423_ = 1u;
                    }
                    let _e999 = phi_1423_;
                    if ((((((_e935 >> bitcast<u32>((((_e844 % 16u) * 2u) & 31u))) & 3u) | ((_e943 >> bitcast<u32>((((_e870 % 16u) * 2u) & 31u))) & 3u)) | (((_e952 >> bitcast<u32>((((_e896 % 16u) * 2u) & 31u))) & 3u) | ((_e960 >> bitcast<u32>((((_e922 % 16u) * 2u) & 31u))) & 3u))) & _e999) != 0u) {
                        if _e997 {
                            phi_1432_ = 0.000000059604645f;
                        } else {
                            phi_1432_ = 0.99999994f;
                        }
                        let _e1003 = phi_1432_;
                        phi_1434_ = evaluate_Verdict(_e1003, true);
                        phi_1435_ = false;
                    } else {
                        phi_1434_ = evaluate_Verdict();
                        phi_1435_ = true;
                    }
                    let _e1006 = phi_1434_;
                    let _e1008 = phi_1435_;
                    phi_1436_ = _e1006;
                    phi_1437_ = _e1008;
                }
                let _e1010 = phi_1436_;
                let _e1012 = phi_1437_;
                if _e1012 {
                    phi_1442_ = evaluate_Verdict(_e994.visibility, _e994.is_doubted);
                } else {
                    phi_1442_ = _e1010;
                }
                let _e1015 = phi_1442_;
                phi_1447_ = evaluate_Verdict(_e1015.visibility, _e1015.is_doubted);
            } else {
                phi_1447_ = evaluate_Verdict(0.5f, true);
            }
            let _e1021 = phi_1447_;
            phi_1448_ = _e1021;
        }
        let _e1023 = phi_1448_;
        if (_e68.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e68.first_primitive)] = _e1023.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_vsm_levels_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
