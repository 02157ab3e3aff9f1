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
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_161_: lt_bvh_traverse_Tree;
    var phi_162_: bool;
    var phi_167_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_159_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_160_ = false;
        } else {
            phi_159_ = lt_bvh_traverse_Tree();
            phi_160_ = true;
        }
        let _e65 = phi_159_;
        let _e67 = phi_160_;
        phi_161_ = _e65;
        phi_162_ = _e67;
    } else {
        phi_161_ = lt_bvh_traverse_Tree();
        phi_162_ = true;
    }
    let _e69 = phi_161_;
    let _e71 = phi_162_;
    if _e71 {
        phi_167_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_167_ = _e69;
    }
    let _e76 = phi_167_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_192_: f32;
    var phi_193_: f32;
    var phi_194_: f32;
    var phi_207_: bool;
    var phi_211_: f32;
    var phi_224_: f32;
    var phi_229_: f32;
    var phi_251_: f32;
    var phi_256_: f32;
    var phi_257_: bool;
    var phi_258_: f32;
    var phi_259_: bool;
    var phi_263_: f32;
    var phi_301_: f32;
    var phi_317_: f32;
    var phi_318_: f32;
    var phi_319_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_194_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_193_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_192_ = 1f;
            } else {
                phi_192_ = param_6;
            }
            let _e61 = phi_192_;
            phi_193_ = _e61;
        }
        let _e63 = phi_193_;
        phi_194_ = _e63;
    }
    let _e65 = phi_194_;
    let _e67 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_207_ = true;
    } else {
        let _e71 = (84f < _e67);
        if _e71 {
        }
        phi_207_ = _e71;
    }
    let _e73 = phi_207_;
    if _e73 {
        phi_211_ = 84f;
    } else {
        phi_211_ = _e67;
    }
    let _e75 = phi_211_;
    let _e77 = (_e75 * (1f - _e65));
    if ((bitcast<u32>(_e77) & 2147483647u) > 2139095040u) {
        phi_301_ = _e77;
    } else {
        if (_e77 < -87f) {
            phi_224_ = -87f;
        } else {
            phi_224_ = _e77;
        }
        let _e83 = phi_224_;
        if (_e83 > 88f) {
            phi_229_ = 88f;
        } else {
            phi_229_ = _e83;
        }
        let _e86 = phi_229_;
        let _e88 = ((_e86 * 1.442695f) + 0.5f);
        if (_e88 > -8388608f) {
            let _e100 = f32(select(0i, select(select(i32(_e88), i32(-2147483648), (_e88 < bitcast<f32>(3472883712u))), 2147483647i, (_e88 > bitcast<f32>(1325400063u))), (_e88 == _e88)));
            if (_e100 > _e88) {
                phi_251_ = 1f;
            } else {
                phi_251_ = 0f;
            }
            let _e103 = phi_251_;
            if (_e88 < 8388608f) {
                phi_256_ = (_e100 - _e103);
                phi_257_ = false;
            } else {
                phi_256_ = f32();
                phi_257_ = true;
            }
            let _e106 = phi_256_;
            let _e108 = phi_257_;
            phi_258_ = _e106;
            phi_259_ = _e108;
        } else {
            phi_258_ = f32();
            phi_259_ = true;
        }
        let _e110 = phi_258_;
        let _e112 = phi_259_;
        if _e112 {
            phi_263_ = _e88;
        } else {
            phi_263_ = _e110;
        }
        let _e114 = phi_263_;
        let _e118 = ((_e86 - (_e114 * 0.69314575f)) - (_e114 * 0.0000014286068f));
        phi_301_ = ((((((((((((((((1f / 5040f) * _e118) + (1f / 720f)) * _e118) + (1f / 120f)) * _e118) + (1f / 24f)) * _e118) + (1f / 6f)) * _e118) + 0.5f) * _e118) + 1f) * _e118) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e154 = phi_301_;
    let _e155 = (param_5.x * _e154);
    if ((bitcast<u32>(_e155) & 2147483647u) > 2139095040u) {
        phi_319_ = _e155;
    } else {
        if (_e155 < 0f) {
            phi_318_ = 0f;
        } else {
            if (_e155 > 1f) {
                phi_317_ = 1f;
            } else {
                phi_317_ = _e155;
            }
            let _e162 = phi_317_;
            phi_318_ = _e162;
        }
        let _e164 = phi_318_;
        phi_319_ = _e164;
    }
    let _e166 = phi_319_;
    return _e166;
}

fn function_() {
    var local: f32;
    var phi_379_: bool;
    var phi_380_: bool;
    var phi_381_: bool;
    var phi_382_: bool;
    var phi_386_: bool;
    var phi_456_: bool;
    var phi_457_: bool;
    var phi_468_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_469_: bool;
    var phi_470_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_471_: bool;
    var phi_478_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_482_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_502_: lt_math_LightPoint;
    var phi_505_: u32;
    var phi_507_: lt_math_LevelPoint;
    var phi_593_: bool;
    var phi_602_: bool;
    var phi_611_: bool;
    var phi_612_: bool;
    var phi_613_: bool;
    var phi_614_: bool;
    var phi_615_: bool;
    var phi_616_: bool;
    var phi_617_: bool;
    var phi_621_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_655_: bool;
    var phi_659_: bool;
    var phi_668_: lt_math_LightPoint;
    var phi_669_: u32;
    var phi_670_: lt_math_LevelPoint;
    var phi_671_: bool;
    var phi_503_: lt_math_LightPoint;
    var phi_506_: u32;
    var phi_508_: lt_math_LevelPoint;
    var phi_672_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_714_: bool;
    var phi_715_: bool;
    var phi_719_: bool;
    var phi_801_: f32;
    var phi_919_: f32;
    var phi_920_: f32;
    var phi_923_: f32;
    var phi_952_: f32;
    var phi_957_: f32;
    var phi_958_: bool;
    var phi_959_: f32;
    var phi_960_: bool;
    var phi_964_: f32;
    var phi_984_: f32;
    var phi_989_: f32;
    var phi_990_: bool;
    var phi_991_: f32;
    var phi_992_: bool;
    var phi_996_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1045_: i32;
    var phi_1050_: i32;
    var phi_1055_: i32;
    var phi_1060_: i32;
    var phi_1069_: i32;
    var phi_1074_: i32;
    var phi_1079_: i32;
    var phi_1084_: i32;
    var phi_1179_: bool;
    var phi_1187_: bool;
    var phi_1199_: bool;
    var phi_1200_: bool;
    var phi_1204_: f32;
    var phi_1210_: f32;
    var phi_1212_: evaluate_Verdict;
    var phi_1217_: evaluate_Verdict;
    var phi_1218_: evaluate_Verdict;

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
                phi_379_ = (_e95 == _e97);
                phi_380_ = false;
            } else {
                phi_379_ = bool();
                phi_380_ = true;
            }
            let _e100 = phi_379_;
            let _e102 = phi_380_;
            phi_381_ = _e100;
            phi_382_ = _e102;
        } else {
            phi_381_ = bool();
            phi_382_ = true;
        }
        let _e104 = phi_381_;
        let _e106 = phi_382_;
        if _e106 {
            phi_386_ = false;
        } else {
            phi_386_ = _e104;
        }
        let _e108 = phi_386_;
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
                    phi_457_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_456_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_456_ = false;
                    }
                    let _e169 = phi_456_;
                    phi_457_ = _e169;
                }
                let _e171 = phi_457_;
                if _e171 {
                    let _e173 = samples.member[(0u + _e72.first_primitive)].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_468_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_469_ = false;
                } else {
                    phi_468_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_469_ = true;
                }
                let _e192 = phi_468_;
                let _e194 = phi_469_;
                phi_470_ = _e192;
                phi_471_ = _e194;
            } else {
                phi_470_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_471_ = true;
            }
            let _e196 = phi_470_;
            let _e198 = phi_471_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_478_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_478_ = _e196;
            }
            let _e215 = phi_478_;
            phi_482_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_482_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_482_;
        if _e232.unnamed_1 {
            phi_1218_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
        } else {
            let _e240 = samples.member[(0u + _e72.first_primitive)].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_502_ = lt_math_LightPoint();
            phi_505_ = 0u;
            phi_507_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_502_;
                let _e271 = phi_505_;
                let _e273 = phi_507_;
                local_1 = _e273;
                local_2 = _e273;
                local_3 = _e273;
                if (_e271 < _e78) {
                    if _e273.point.is_inside {
                        phi_668_ = lt_math_LightPoint();
                        phi_669_ = u32();
                        phi_670_ = lt_math_LevelPoint();
                        phi_671_ = false;
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
                                phi_593_ = (_e309 <= 1f);
                            } else {
                                phi_593_ = false;
                            }
                            let _e341 = phi_593_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_602_ = (_e323 <= 1f);
                                } else {
                                    phi_602_ = false;
                                }
                                let _e345 = phi_602_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_611_ = (_e336 <= 1f);
                                    } else {
                                        phi_611_ = false;
                                    }
                                    let _e349 = phi_611_;
                                    phi_612_ = _e349;
                                    phi_613_ = false;
                                } else {
                                    phi_612_ = bool();
                                    phi_613_ = true;
                                }
                                let _e351 = phi_612_;
                                let _e353 = phi_613_;
                                phi_614_ = _e351;
                                phi_615_ = _e353;
                            } else {
                                phi_614_ = bool();
                                phi_615_ = true;
                            }
                            let _e355 = phi_614_;
                            let _e357 = phi_615_;
                            phi_616_ = _e355;
                            phi_617_ = _e357;
                        } else {
                            phi_616_ = bool();
                            phi_617_ = true;
                        }
                        let _e359 = phi_616_;
                        let _e361 = phi_617_;
                        if _e361 {
                            phi_621_ = false;
                        } else {
                            phi_621_ = _e359;
                        }
                        let _e363 = phi_621_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_648_ = (_e323 <= (1f - _e244));
                                        phi_649_ = false;
                                    } else {
                                        phi_648_ = bool();
                                        phi_649_ = true;
                                    }
                                    let _e371 = phi_648_;
                                    let _e373 = phi_649_;
                                    phi_650_ = _e371;
                                    phi_651_ = _e373;
                                } else {
                                    phi_650_ = bool();
                                    phi_651_ = true;
                                }
                                let _e375 = phi_650_;
                                let _e377 = phi_651_;
                                phi_652_ = _e375;
                                phi_653_ = _e377;
                            } else {
                                phi_652_ = bool();
                                phi_653_ = true;
                            }
                            let _e379 = phi_652_;
                            let _e381 = phi_653_;
                            phi_654_ = _e379;
                            phi_655_ = _e381;
                        } else {
                            phi_654_ = bool();
                            phi_655_ = true;
                        }
                        let _e383 = phi_654_;
                        let _e385 = phi_655_;
                        if _e385 {
                            phi_659_ = false;
                        } else {
                            phi_659_ = _e383;
                        }
                        let _e387 = phi_659_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_668_ = _e409;
                        phi_669_ = (_e271 + 1u);
                        phi_670_ = lt_math_LevelPoint(_e271, _e409);
                        phi_671_ = true;
                    }
                    let _e413 = phi_668_;
                    let _e415 = phi_669_;
                    let _e417 = phi_670_;
                    let _e419 = phi_671_;
                    phi_503_ = _e413;
                    phi_506_ = _e415;
                    phi_508_ = _e417;
                    phi_672_ = _e419;
                } else {
                    phi_503_ = lt_math_LightPoint();
                    phi_506_ = u32();
                    phi_508_ = lt_math_LevelPoint();
                    phi_672_ = false;
                }
                let _e421 = phi_503_;
                let _e423 = phi_506_;
                let _e425 = phi_508_;
                let _e427 = phi_672_;
                continue;
                continuing {
                    phi_502_ = _e421;
                    phi_505_ = _e423;
                    phi_507_ = _e425;
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
                            phi_712_ = (_e441.row_w.z == _e453);
                            phi_713_ = false;
                        } else {
                            phi_712_ = bool();
                            phi_713_ = true;
                        }
                        let _e456 = phi_712_;
                        let _e458 = phi_713_;
                        phi_714_ = _e456;
                        phi_715_ = _e458;
                    } else {
                        phi_714_ = bool();
                        phi_715_ = true;
                    }
                    let _e460 = phi_714_;
                    let _e462 = phi_715_;
                    if _e462 {
                        phi_719_ = false;
                    } else {
                        phi_719_ = _e460;
                    }
                    let _e464 = phi_719_;
                    if _e464 {
                        let _e466 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_801_ = _e538;
                        } else {
                            phi_801_ = 0.002f;
                        }
                        let _e541 = phi_801_;
                        phi_920_ = _e541;
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
                            phi_919_ = _e655;
                        } else {
                            phi_919_ = _e657;
                        }
                        let _e660 = phi_919_;
                        phi_920_ = _e660;
                    }
                    let _e662 = phi_920_;
                    phi_923_ = (_e430.point.depth - (0f * _e662));
                } else {
                    phi_923_ = _e430.point.depth;
                }
                let _e666 = phi_923_;
                let _e672 = p.member.map_size;
                let _e673 = f32(_e672);
                let _e676 = ((_e430.point.uv.x * _e673) - 0.5f);
                let _e677 = ((_e430.point.uv.y * _e673) - 0.5f);
                if (_e676 > -8388608f) {
                    let _e689 = f32(select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < bitcast<f32>(3472883712u))), 2147483647i, (_e676 > bitcast<f32>(1325400063u))), (_e676 == _e676)));
                    if (_e689 > _e676) {
                        phi_952_ = 1f;
                    } else {
                        phi_952_ = 0f;
                    }
                    let _e692 = phi_952_;
                    if (_e676 < 8388608f) {
                        phi_957_ = (_e689 - _e692);
                        phi_958_ = false;
                    } else {
                        phi_957_ = f32();
                        phi_958_ = true;
                    }
                    let _e695 = phi_957_;
                    let _e697 = phi_958_;
                    phi_959_ = _e695;
                    phi_960_ = _e697;
                } else {
                    phi_959_ = f32();
                    phi_960_ = true;
                }
                let _e699 = phi_959_;
                let _e701 = phi_960_;
                if _e701 {
                    phi_964_ = _e676;
                } else {
                    phi_964_ = _e699;
                }
                let _e703 = phi_964_;
                if (_e677 > -8388608f) {
                    let _e715 = f32(select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < bitcast<f32>(3472883712u))), 2147483647i, (_e677 > bitcast<f32>(1325400063u))), (_e677 == _e677)));
                    if (_e715 > _e677) {
                        phi_984_ = 1f;
                    } else {
                        phi_984_ = 0f;
                    }
                    let _e718 = phi_984_;
                    if (_e677 < 8388608f) {
                        phi_989_ = (_e715 - _e718);
                        phi_990_ = false;
                    } else {
                        phi_989_ = f32();
                        phi_990_ = true;
                    }
                    let _e721 = phi_989_;
                    let _e723 = phi_990_;
                    phi_991_ = _e721;
                    phi_992_ = _e723;
                } else {
                    phi_991_ = f32();
                    phi_992_ = true;
                }
                let _e725 = phi_991_;
                let _e727 = phi_992_;
                if _e727 {
                    phi_996_ = _e677;
                } else {
                    phi_996_ = _e725;
                }
                let _e729 = phi_996_;
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
                    phi_1045_ = _e740;
                } else {
                    phi_1045_ = 0i;
                }
                let _e772 = phi_1045_;
                if (_e749 > 0i) {
                    phi_1050_ = _e749;
                } else {
                    phi_1050_ = 0i;
                }
                let _e775 = phi_1050_;
                if (_e772 < _e769) {
                    phi_1055_ = _e772;
                } else {
                    phi_1055_ = _e769;
                }
                let _e778 = phi_1055_;
                if (_e775 < _e769) {
                    phi_1060_ = _e775;
                } else {
                    phi_1060_ = _e769;
                }
                let _e781 = phi_1060_;
                let _e782 = bitcast<u32>(_e778);
                let _e784 = (_e740 + 1i);
                let _e785 = (_e749 + 1i);
                if (_e784 > 0i) {
                    phi_1069_ = _e784;
                } else {
                    phi_1069_ = 0i;
                }
                let _e788 = phi_1069_;
                if (_e785 > 0i) {
                    phi_1074_ = _e785;
                } else {
                    phi_1074_ = 0i;
                }
                let _e791 = phi_1074_;
                if (_e788 < _e769) {
                    phi_1079_ = _e788;
                } else {
                    phi_1079_ = _e769;
                }
                let _e794 = phi_1079_;
                if (_e791 < _e769) {
                    phi_1084_ = _e791;
                } else {
                    phi_1084_ = _e769;
                }
                let _e797 = phi_1084_;
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
                let _e873 = p.member.epsilon;
                if (_e871 <= _e873) {
                    phi_1179_ = true;
                } else {
                    phi_1179_ = (_e871 >= (1f - _e873));
                }
                let _e878 = phi_1179_;
                if ((bitcast<u32>(_e871) & 2147483647u) > 2139095040u) {
                    phi_1187_ = true;
                } else {
                    phi_1187_ = !(_e878);
                }
                let _e884 = phi_1187_;
                if _e884 {
                    if (_e871 > 0f) {
                        if (_e871 < 1f) {
                            phi_1199_ = false;
                        } else {
                            phi_1199_ = true;
                        }
                        let _e888 = phi_1199_;
                        phi_1200_ = _e888;
                    } else {
                        phi_1200_ = true;
                    }
                    let _e890 = phi_1200_;
                    if _e890 {
                        phi_1204_ = 0.5f;
                    } else {
                        phi_1204_ = _e871;
                    }
                    let _e892 = phi_1204_;
                    phi_1212_ = evaluate_Verdict(_e892, true);
                } else {
                    if (_e871 > 0.5f) {
                        phi_1210_ = 1f;
                    } else {
                        phi_1210_ = 0f;
                    }
                    let _e896 = phi_1210_;
                    phi_1212_ = evaluate_Verdict(_e896, false);
                }
                let _e899 = phi_1212_;
                phi_1217_ = evaluate_Verdict(_e899.visibility, _e899.is_doubted);
            } else {
                phi_1217_ = evaluate_Verdict(0.5f, true);
            }
            let _e905 = phi_1217_;
            phi_1218_ = _e905;
        }
        let _e907 = phi_1218_;
        if (_e72.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.first_primitive)] = _e907.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
