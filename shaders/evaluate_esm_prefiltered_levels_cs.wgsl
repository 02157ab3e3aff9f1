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
    var phi_158_: lt_bvh_traverse_Tree;
    var phi_159_: bool;
    var phi_160_: lt_bvh_traverse_Tree;
    var phi_161_: bool;
    var phi_166_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_158_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_159_ = false;
        } else {
            phi_158_ = lt_bvh_traverse_Tree();
            phi_159_ = true;
        }
        let _e65 = phi_158_;
        let _e67 = phi_159_;
        phi_160_ = _e65;
        phi_161_ = _e67;
    } else {
        phi_160_ = lt_bvh_traverse_Tree();
        phi_161_ = true;
    }
    let _e69 = phi_160_;
    let _e71 = phi_161_;
    if _e71 {
        phi_166_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_166_ = _e69;
    }
    let _e76 = phi_166_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_191_: f32;
    var phi_192_: f32;
    var phi_193_: f32;
    var phi_206_: bool;
    var phi_210_: f32;
    var phi_223_: f32;
    var phi_228_: f32;
    var phi_250_: f32;
    var phi_255_: f32;
    var phi_256_: bool;
    var phi_257_: f32;
    var phi_258_: bool;
    var phi_262_: f32;
    var phi_300_: f32;
    var phi_316_: f32;
    var phi_317_: f32;
    var phi_318_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_193_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_192_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_191_ = 1f;
            } else {
                phi_191_ = param_6;
            }
            let _e61 = phi_191_;
            phi_192_ = _e61;
        }
        let _e63 = phi_192_;
        phi_193_ = _e63;
    }
    let _e65 = phi_193_;
    let _e67 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_206_ = true;
    } else {
        let _e71 = (84f < _e67);
        if _e71 {
        }
        phi_206_ = _e71;
    }
    let _e73 = phi_206_;
    if _e73 {
        phi_210_ = 84f;
    } else {
        phi_210_ = _e67;
    }
    let _e75 = phi_210_;
    let _e77 = (_e75 * (1f - _e65));
    if ((bitcast<u32>(_e77) & 2147483647u) > 2139095040u) {
        phi_300_ = _e77;
    } else {
        if (_e77 < -87f) {
            phi_223_ = -87f;
        } else {
            phi_223_ = _e77;
        }
        let _e83 = phi_223_;
        if (_e83 > 88f) {
            phi_228_ = 88f;
        } else {
            phi_228_ = _e83;
        }
        let _e86 = phi_228_;
        let _e88 = ((_e86 * 1.442695f) + 0.5f);
        if (_e88 > -8388608f) {
            let _e100 = f32(select(0i, select(select(i32(_e88), i32(-2147483648), (_e88 < bitcast<f32>(3472883712u))), 2147483647i, (_e88 > bitcast<f32>(1325400063u))), (_e88 == _e88)));
            if (_e100 > _e88) {
                phi_250_ = 1f;
            } else {
                phi_250_ = 0f;
            }
            let _e103 = phi_250_;
            if (_e88 < 8388608f) {
                phi_255_ = (_e100 - _e103);
                phi_256_ = false;
            } else {
                phi_255_ = f32();
                phi_256_ = true;
            }
            let _e106 = phi_255_;
            let _e108 = phi_256_;
            phi_257_ = _e106;
            phi_258_ = _e108;
        } else {
            phi_257_ = f32();
            phi_258_ = true;
        }
        let _e110 = phi_257_;
        let _e112 = phi_258_;
        if _e112 {
            phi_262_ = _e88;
        } else {
            phi_262_ = _e110;
        }
        let _e114 = phi_262_;
        let _e118 = ((_e86 - (_e114 * 0.69314575f)) - (_e114 * 0.0000014286068f));
        phi_300_ = ((((((((((((((((1f / 5040f) * _e118) + (1f / 720f)) * _e118) + (1f / 120f)) * _e118) + (1f / 24f)) * _e118) + (1f / 6f)) * _e118) + 0.5f) * _e118) + 1f) * _e118) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e154 = phi_300_;
    let _e155 = (param_5.x * _e154);
    if ((bitcast<u32>(_e155) & 2147483647u) > 2139095040u) {
        phi_318_ = _e155;
    } else {
        if (_e155 < 0f) {
            phi_317_ = 0f;
        } else {
            if (_e155 > 1f) {
                phi_316_ = 1f;
            } else {
                phi_316_ = _e155;
            }
            let _e162 = phi_316_;
            phi_317_ = _e162;
        }
        let _e164 = phi_317_;
        phi_318_ = _e164;
    }
    let _e166 = phi_318_;
    return _e166;
}

fn function_() {
    var local: f32;
    var phi_378_: bool;
    var phi_379_: bool;
    var phi_380_: bool;
    var phi_381_: bool;
    var phi_385_: bool;
    var phi_455_: bool;
    var phi_456_: bool;
    var phi_467_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_468_: bool;
    var phi_469_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_470_: bool;
    var phi_477_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_481_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_501_: lt_math_LightPoint;
    var phi_504_: u32;
    var phi_506_: lt_math_LevelPoint;
    var phi_592_: bool;
    var phi_601_: bool;
    var phi_610_: bool;
    var phi_611_: bool;
    var phi_612_: bool;
    var phi_613_: bool;
    var phi_614_: bool;
    var phi_615_: bool;
    var phi_616_: bool;
    var phi_620_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_658_: bool;
    var phi_667_: lt_math_LightPoint;
    var phi_668_: u32;
    var phi_669_: lt_math_LevelPoint;
    var phi_670_: bool;
    var phi_502_: lt_math_LightPoint;
    var phi_505_: u32;
    var phi_507_: lt_math_LevelPoint;
    var phi_671_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_711_: bool;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_714_: bool;
    var phi_718_: bool;
    var phi_800_: f32;
    var phi_918_: f32;
    var phi_919_: f32;
    var phi_922_: f32;
    var phi_951_: f32;
    var phi_956_: f32;
    var phi_957_: bool;
    var phi_958_: f32;
    var phi_959_: bool;
    var phi_963_: f32;
    var phi_983_: f32;
    var phi_988_: f32;
    var phi_989_: bool;
    var phi_990_: f32;
    var phi_991_: bool;
    var phi_995_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1044_: i32;
    var phi_1049_: i32;
    var phi_1054_: i32;
    var phi_1059_: i32;
    var phi_1068_: i32;
    var phi_1073_: i32;
    var phi_1078_: i32;
    var phi_1083_: i32;
    var phi_1172_: evaluate_Verdict;
    var phi_1173_: evaluate_Verdict;
    var phi_1174_: bool;
    var phi_1175_: evaluate_Verdict;
    var phi_1176_: evaluate_Verdict;
    var phi_1177_: bool;
    var phi_1181_: evaluate_Verdict;

    let _e53 = id_1;
    let _e60 = arrayLength((&map.member));
    let _e66 = arrayLength((&levels.member));
    let _e69 = p.member.size[0u];
    let _e71 = p.member.size[1u];
    let _e72 = lt_shaders_entry_pixel_index(_e53, _e69, _e71);
    if (bitcast<i32>(_e72.root) != 0i) {
        let _e78 = p.member.level_count;
        if (_e72.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e85 = samples.member[(0u + _e72.first_primitive)].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[(0u + _e72.first_primitive)].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[(0u + _e72.first_primitive)].normal[2u];
                let _e97 = global[2u];
                phi_378_ = (_e95 == _e97);
                phi_379_ = false;
            } else {
                phi_378_ = bool();
                phi_379_ = true;
            }
            let _e100 = phi_378_;
            let _e102 = phi_379_;
            phi_380_ = _e100;
            phi_381_ = _e102;
        } else {
            phi_380_ = bool();
            phi_381_ = true;
        }
        let _e104 = phi_380_;
        let _e106 = phi_381_;
        if _e106 {
            phi_385_ = false;
        } else {
            phi_385_ = _e104;
        }
        let _e108 = phi_385_;
        if !(_e108) {
            let _e111 = samples.member[(0u + _e72.first_primitive)].position;
            let _e113 = p.member.light.place;
            let _e119 = p.member.light.place[3u];
            let _e126 = (_e113.x - (_e111.x * _e119));
            let _e127 = (_e113.y - (_e111.y * _e119));
            let _e128 = (_e113.z - (_e111.z * _e119));
            let _e130 = samples.member[(0u + _e72.first_primitive)].normal;
            if ((((_e130.x * _e126) + (_e130.y * _e127)) + (_e130.z * _e128)) > 0f) {
                let _e144 = (((_e126 * _e126) + (_e127 * _e127)) + (_e128 * _e128));
                let _e146 = p.member.light.axis;
                let _e158 = p.member.light.place[3u];
                if (_e158 == 0f) {
                    phi_456_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_455_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_455_ = false;
                    }
                    let _e169 = phi_455_;
                    phi_456_ = _e169;
                }
                let _e171 = phi_456_;
                if _e171 {
                    let _e173 = samples.member[(0u + _e72.first_primitive)].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_467_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_468_ = false;
                } else {
                    phi_467_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_468_ = true;
                }
                let _e192 = phi_467_;
                let _e194 = phi_468_;
                phi_469_ = _e192;
                phi_470_ = _e194;
            } else {
                phi_469_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_470_ = true;
            }
            let _e196 = phi_469_;
            let _e198 = phi_470_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_477_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_477_ = _e196;
            }
            let _e215 = phi_477_;
            phi_481_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_481_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_481_;
        if _e232.unnamed_1 {
            phi_1175_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
            phi_1176_ = evaluate_Verdict();
            phi_1177_ = true;
        } else {
            let _e240 = samples.member[(0u + _e72.first_primitive)].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_501_ = lt_math_LightPoint();
            phi_504_ = 0u;
            phi_506_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_501_;
                let _e271 = phi_504_;
                let _e273 = phi_506_;
                local_1 = _e273;
                local_2 = _e273;
                local_3 = _e273;
                if (_e271 < _e78) {
                    if _e273.point.is_inside {
                        phi_667_ = lt_math_LightPoint();
                        phi_668_ = u32();
                        phi_669_ = lt_math_LevelPoint();
                        phi_670_ = false;
                    } else {
                        if (_e271 < _e66) {
                        } else {
                            return;
                        }
                        let _e284 = levels.member[(0u + _e271)].row_w;
                        let _e295 = ((((_e284.x * _e240.x) + (_e284.y * _e240.y)) + (_e284.z * _e240.z)) + (_e284.w * 1f));
                        let _e297 = levels.member[(0u + _e271)].row_x;
                        let _e309 = (((((_e297.x * _e240.x) + (_e297.y * _e240.y)) + (_e297.z * _e240.z)) + (_e297.w * 1f)) / _e295);
                        let _e311 = levels.member[(0u + _e271)].row_y;
                        let _e323 = (((((_e311.x * _e240.x) + (_e311.y * _e240.y)) + (_e311.z * _e240.z)) + (_e311.w * 1f)) / _e295);
                        let _e325 = levels.member[(0u + _e271)].row_z;
                        let _e336 = ((((_e325.x * _e240.x) + (_e325.y * _e240.y)) + (_e325.z * _e240.z)) + (_e325.w * 1f));
                        if (_e295 > 0f) {
                            if (_e309 >= 0f) {
                                phi_592_ = (_e309 <= 1f);
                            } else {
                                phi_592_ = false;
                            }
                            let _e341 = phi_592_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_601_ = (_e323 <= 1f);
                                } else {
                                    phi_601_ = false;
                                }
                                let _e345 = phi_601_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_610_ = (_e336 <= 1f);
                                    } else {
                                        phi_610_ = false;
                                    }
                                    let _e349 = phi_610_;
                                    phi_611_ = _e349;
                                    phi_612_ = false;
                                } else {
                                    phi_611_ = bool();
                                    phi_612_ = true;
                                }
                                let _e351 = phi_611_;
                                let _e353 = phi_612_;
                                phi_613_ = _e351;
                                phi_614_ = _e353;
                            } else {
                                phi_613_ = bool();
                                phi_614_ = true;
                            }
                            let _e355 = phi_613_;
                            let _e357 = phi_614_;
                            phi_615_ = _e355;
                            phi_616_ = _e357;
                        } else {
                            phi_615_ = bool();
                            phi_616_ = true;
                        }
                        let _e359 = phi_615_;
                        let _e361 = phi_616_;
                        if _e361 {
                            phi_620_ = false;
                        } else {
                            phi_620_ = _e359;
                        }
                        let _e363 = phi_620_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_647_ = (_e323 <= (1f - _e244));
                                        phi_648_ = false;
                                    } else {
                                        phi_647_ = bool();
                                        phi_648_ = true;
                                    }
                                    let _e371 = phi_647_;
                                    let _e373 = phi_648_;
                                    phi_649_ = _e371;
                                    phi_650_ = _e373;
                                } else {
                                    phi_649_ = bool();
                                    phi_650_ = true;
                                }
                                let _e375 = phi_649_;
                                let _e377 = phi_650_;
                                phi_651_ = _e375;
                                phi_652_ = _e377;
                            } else {
                                phi_651_ = bool();
                                phi_652_ = true;
                            }
                            let _e379 = phi_651_;
                            let _e381 = phi_652_;
                            phi_653_ = _e379;
                            phi_654_ = _e381;
                        } else {
                            phi_653_ = bool();
                            phi_654_ = true;
                        }
                        let _e383 = phi_653_;
                        let _e385 = phi_654_;
                        if _e385 {
                            phi_658_ = false;
                        } else {
                            phi_658_ = _e383;
                        }
                        let _e387 = phi_658_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_667_ = _e409;
                        phi_668_ = (_e271 + 1u);
                        phi_669_ = lt_math_LevelPoint(_e271, _e409);
                        phi_670_ = true;
                    }
                    let _e413 = phi_667_;
                    let _e415 = phi_668_;
                    let _e417 = phi_669_;
                    let _e419 = phi_670_;
                    phi_502_ = _e413;
                    phi_505_ = _e415;
                    phi_507_ = _e417;
                    phi_671_ = _e419;
                } else {
                    phi_502_ = lt_math_LightPoint();
                    phi_505_ = u32();
                    phi_507_ = lt_math_LevelPoint();
                    phi_671_ = false;
                }
                let _e421 = phi_502_;
                let _e423 = phi_505_;
                let _e425 = phi_507_;
                let _e427 = phi_671_;
                continue;
                continuing {
                    phi_501_ = _e421;
                    phi_504_ = _e423;
                    phi_506_ = _e425;
                    break if !(_e427);
                }
            }
            let _e430 = local_1;
            if _e430.point.is_inside {
                if (0f > 0f) {
                    let _e436 = local_2;
                    if (_e436.level < _e66) {
                    } else {
                        return;
                    }
                    let _e441 = levels.member[(0u + _e436.level)];
                    let _e447 = global[0u];
                    if (_e441.row_w.x == _e447) {
                        let _e450 = global[1u];
                        if (_e441.row_w.y == _e450) {
                            let _e453 = global[2u];
                            phi_711_ = (_e441.row_w.z == _e453);
                            phi_712_ = false;
                        } else {
                            phi_711_ = bool();
                            phi_712_ = true;
                        }
                        let _e456 = phi_711_;
                        let _e458 = phi_712_;
                        phi_713_ = _e456;
                        phi_714_ = _e458;
                    } else {
                        phi_713_ = bool();
                        phi_714_ = true;
                    }
                    let _e460 = phi_713_;
                    let _e462 = phi_714_;
                    if _e462 {
                        phi_718_ = false;
                    } else {
                        phi_718_ = _e460;
                    }
                    let _e464 = phi_718_;
                    if _e464 {
                        let _e466 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_800_ = _e538;
                        } else {
                            phi_800_ = 0.002f;
                        }
                        let _e541 = phi_800_;
                        phi_919_ = _e541;
                    } else {
                        let _e543 = p.member.map_size;
                        let _e549 = samples.member[(0u + _e72.first_primitive)].position;
                        let _e560 = ((((_e441.row_w.x * _e549.x) + (_e441.row_w.y * _e549.y)) + (_e441.row_w.z * _e549.z)) + _e441.row_w.w);
                        let _e573 = ((_e441.row_x.x - (_e441.row_w.x * _e430.point.uv.x)) / _e560);
                        let _e574 = ((_e441.row_x.y - (_e441.row_w.y * _e430.point.uv.x)) / _e560);
                        let _e575 = ((_e441.row_x.z - (_e441.row_w.z * _e430.point.uv.x)) / _e560);
                        let _e588 = ((_e441.row_y.x - (_e441.row_w.x * _e430.point.uv.y)) / _e560);
                        let _e589 = ((_e441.row_y.y - (_e441.row_w.y * _e430.point.uv.y)) / _e560);
                        let _e590 = ((_e441.row_y.z - (_e441.row_w.z * _e430.point.uv.y)) / _e560);
                        let _e596 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e601 = ((_e589 * _e596.z) - (_e596.y * _e590));
                        let _e606 = ((_e590 * _e596.x) - (_e596.z * _e588));
                        let _e611 = ((_e588 * _e596.y) - (_e596.x * _e589));
                        let _e613 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e618 = ((_e574 * _e613.z) - (_e613.y * _e575));
                        let _e623 = ((_e575 * _e613.x) - (_e613.z * _e573));
                        let _e628 = ((_e573 * _e613.y) - (_e613.x * _e574));
                        let _e655 = ((abs(((((_e441.row_z.x * _e601) + (_e441.row_z.y * _e606)) + (_e441.row_z.z * _e611)) / (((_e573 * _e601) + (_e574 * _e606)) + (_e575 * _e611)))) + abs(((((_e441.row_z.x * _e618) + (_e441.row_z.y * _e623)) + (_e441.row_z.z * _e628)) / (((_e588 * _e618) + (_e589 * _e623)) + (_e590 * _e628))))) / f32(_e543));
                        let _e657 = (16f / f32(_e543));
                        if (_e655 < _e657) {
                            phi_918_ = _e655;
                        } else {
                            phi_918_ = _e657;
                        }
                        let _e660 = phi_918_;
                        phi_919_ = _e660;
                    }
                    let _e662 = phi_919_;
                    phi_922_ = (_e430.point.depth - (0f * _e662));
                } else {
                    phi_922_ = _e430.point.depth;
                }
                let _e666 = phi_922_;
                let _e672 = p.member.map_size;
                let _e673 = f32(_e672);
                let _e676 = ((_e430.point.uv.x * _e673) - 0.5f);
                let _e677 = ((_e430.point.uv.y * _e673) - 0.5f);
                if (_e676 > -8388608f) {
                    let _e689 = f32(select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < bitcast<f32>(3472883712u))), 2147483647i, (_e676 > bitcast<f32>(1325400063u))), (_e676 == _e676)));
                    if (_e689 > _e676) {
                        phi_951_ = 1f;
                    } else {
                        phi_951_ = 0f;
                    }
                    let _e692 = phi_951_;
                    if (_e676 < 8388608f) {
                        phi_956_ = (_e689 - _e692);
                        phi_957_ = false;
                    } else {
                        phi_956_ = f32();
                        phi_957_ = true;
                    }
                    let _e695 = phi_956_;
                    let _e697 = phi_957_;
                    phi_958_ = _e695;
                    phi_959_ = _e697;
                } else {
                    phi_958_ = f32();
                    phi_959_ = true;
                }
                let _e699 = phi_958_;
                let _e701 = phi_959_;
                if _e701 {
                    phi_963_ = _e676;
                } else {
                    phi_963_ = _e699;
                }
                let _e703 = phi_963_;
                if (_e677 > -8388608f) {
                    let _e715 = f32(select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < bitcast<f32>(3472883712u))), 2147483647i, (_e677 > bitcast<f32>(1325400063u))), (_e677 == _e677)));
                    if (_e715 > _e677) {
                        phi_983_ = 1f;
                    } else {
                        phi_983_ = 0f;
                    }
                    let _e718 = phi_983_;
                    if (_e677 < 8388608f) {
                        phi_988_ = (_e715 - _e718);
                        phi_989_ = false;
                    } else {
                        phi_988_ = f32();
                        phi_989_ = true;
                    }
                    let _e721 = phi_988_;
                    let _e723 = phi_989_;
                    phi_990_ = _e721;
                    phi_991_ = _e723;
                } else {
                    phi_990_ = f32();
                    phi_991_ = true;
                }
                let _e725 = phi_990_;
                let _e727 = phi_991_;
                if _e727 {
                    phi_995_ = _e677;
                } else {
                    phi_995_ = _e725;
                }
                let _e729 = phi_995_;
                let _e730 = (_e676 - _e703);
                let _e731 = (_e677 - _e729);
                let _e740 = select(0i, select(select(i32(_e703), i32(-2147483648), (_e703 < bitcast<f32>(3472883712u))), 2147483647i, (_e703 > bitcast<f32>(1325400063u))), (_e703 == _e703));
                let _e749 = select(0i, select(select(i32(_e729), i32(-2147483648), (_e729 < bitcast<f32>(3472883712u))), 2147483647i, (_e729 > bitcast<f32>(1325400063u))), (_e729 == _e729));
                let _e752 = ((1f - _e730) * (1f - _e731));
                let _e754 = (_e730 * (1f - _e731));
                let _e756 = ((1f - _e730) * _e731);
                let _e757 = (_e730 * _e731);
                let _e759 = p.member.test;
                let _e760 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e759);
                let _e762 = p.member.map_size;
                let _e764 = local_3;
                local = _e760;
                let _e767 = ((_e764.level * _e762) * _e762);
                let _e769 = (bitcast<i32>(_e762) - 1i);
                if (_e740 > 0i) {
                    phi_1044_ = _e740;
                } else {
                    phi_1044_ = 0i;
                }
                let _e772 = phi_1044_;
                if (_e749 > 0i) {
                    phi_1049_ = _e749;
                } else {
                    phi_1049_ = 0i;
                }
                let _e775 = phi_1049_;
                if (_e772 < _e769) {
                    phi_1054_ = _e772;
                } else {
                    phi_1054_ = _e769;
                }
                let _e778 = phi_1054_;
                if (_e775 < _e769) {
                    phi_1059_ = _e775;
                } else {
                    phi_1059_ = _e769;
                }
                let _e781 = phi_1059_;
                let _e782 = bitcast<u32>(_e778);
                let _e784 = (_e740 + 1i);
                let _e785 = (_e749 + 1i);
                if (_e784 > 0i) {
                    phi_1068_ = _e784;
                } else {
                    phi_1068_ = 0i;
                }
                let _e788 = phi_1068_;
                if (_e785 > 0i) {
                    phi_1073_ = _e785;
                } else {
                    phi_1073_ = 0i;
                }
                let _e791 = phi_1073_;
                if (_e788 < _e769) {
                    phi_1078_ = _e788;
                } else {
                    phi_1078_ = _e769;
                }
                let _e794 = phi_1078_;
                if (_e791 < _e769) {
                    phi_1083_ = _e791;
                } else {
                    phi_1083_ = _e769;
                }
                let _e797 = phi_1083_;
                let _e798 = bitcast<u32>(_e794);
                let _e800 = (bitcast<u32>(_e781) * _e762);
                let _e801 = (bitcast<u32>(_e797) * _e762);
                let _e806 = ((_e800 + _e782) + _e767);
                let _e807 = ((_e800 + _e798) + _e767);
                let _e808 = ((_e801 + _e782) + _e767);
                let _e809 = ((_e801 + _e798) + _e767);
                if (_e806 < _e60) {
                } else {
                    return;
                }
                let _e813 = map.member[(0u + _e806)];
                if (_e807 < _e60) {
                } else {
                    return;
                }
                let _e825 = map.member[(0u + _e807)];
                if (_e808 < _e60) {
                } else {
                    return;
                }
                let _e841 = map.member[(0u + _e808)];
                if (_e809 < _e60) {
                } else {
                    return;
                }
                let _e857 = map.member[(0u + _e809)];
                let _e871 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e813.x * _e752) + (_e825.x * _e754)) + (_e841.x * _e756)) + (_e857.x * _e757)), ((((_e813.y * _e752) + (_e825.y * _e754)) + (_e841.y * _e756)) + (_e857.y * _e757)), ((((_e813.z * _e752) + (_e825.z * _e754)) + (_e841.z * _e756)) + (_e857.z * _e757)), ((((_e813.w * _e752) + (_e825.w * _e754)) + (_e841.w * _e756)) + (_e857.w * _e757))), _e666);
                phi_1172_ = evaluate_Verdict(_e871, false);
                phi_1173_ = evaluate_Verdict();
                phi_1174_ = false;
            } else {
                phi_1172_ = evaluate_Verdict();
                phi_1173_ = evaluate_Verdict(1f, false);
                phi_1174_ = true;
            }
            let _e875 = phi_1172_;
            let _e877 = phi_1173_;
            let _e879 = phi_1174_;
            phi_1175_ = _e877;
            phi_1176_ = _e875;
            phi_1177_ = _e879;
        }
        let _e881 = phi_1175_;
        let _e883 = phi_1176_;
        let _e885 = phi_1177_;
        if _e885 {
            phi_1181_ = _e881;
        } else {
            phi_1181_ = _e883;
        }
        let _e887 = phi_1181_;
        if (_e72.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.first_primitive)] = _e887.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
