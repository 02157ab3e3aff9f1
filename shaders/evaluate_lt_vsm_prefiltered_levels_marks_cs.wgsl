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

struct type_35 {
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

struct type_39 {
    member: abi_ShadowParams,
}

struct type_43 {
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
var<uniform> p: type_39;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_23;
@group(0) @binding(4) 
var<storage> marks: type_9;
@group(0) @binding(5) 
var<storage> levels: type_43;
@group(0) @binding(2) 
var<storage> map: type_35;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_166_: lt_bvh_traverse_Tree;
    var phi_167_: bool;
    var phi_168_: lt_bvh_traverse_Tree;
    var phi_169_: bool;
    var phi_174_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_166_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_167_ = false;
        } else {
            phi_166_ = lt_bvh_traverse_Tree();
            phi_167_ = true;
        }
        let _e59 = phi_166_;
        let _e61 = phi_167_;
        phi_168_ = _e59;
        phi_169_ = _e61;
    } else {
        phi_168_ = lt_bvh_traverse_Tree();
        phi_169_ = true;
    }
    let _e63 = phi_168_;
    let _e65 = phi_169_;
    if _e65 {
        phi_174_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_174_ = _e63;
    }
    let _e70 = phi_174_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_199_: f32;
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_219_: bool;
    var phi_223_: f32;
    var phi_235_: bool;
    var phi_242_: f32;
    var phi_257_: f32;
    var phi_258_: f32;
    var phi_259_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_201_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_200_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_199_ = 1f;
            } else {
                phi_199_ = param_6;
            }
            let _e55 = phi_199_;
            phi_200_ = _e55;
        }
        let _e57 = phi_200_;
        phi_201_ = _e57;
    }
    let _e59 = phi_201_;
    let _e62 = (*param_4);
    let _e66 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e62) & 2147483647u) > 2139095040u) {
        phi_219_ = true;
    } else {
        let _e70 = (_e62 > _e66);
        if _e70 {
        }
        phi_219_ = _e70;
    }
    let _e72 = phi_219_;
    if _e72 {
        phi_223_ = _e62;
    } else {
        phi_223_ = _e66;
    }
    let _e74 = phi_223_;
    let _e75 = (_e59 - param_5.x);
    if (_e75 <= 0f) {
        let _e79 = ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u);
        if _e79 {
        }
        phi_235_ = _e79;
    } else {
        phi_235_ = true;
    }
    let _e81 = phi_235_;
    if _e81 {
        phi_242_ = (_e74 / (_e74 + (_e75 * _e75)));
    } else {
        phi_242_ = 1f;
    }
    let _e86 = phi_242_;
    if ((bitcast<u32>(_e86) & 2147483647u) > 2139095040u) {
        phi_259_ = _e86;
    } else {
        if (_e86 < 0f) {
            phi_258_ = 0f;
        } else {
            if (_e86 > 1f) {
                phi_257_ = 1f;
            } else {
                phi_257_ = _e86;
            }
            let _e93 = phi_257_;
            phi_258_ = _e93;
        }
        let _e95 = phi_258_;
        phi_259_ = _e95;
    }
    let _e97 = phi_259_;
    return _e97;
}

fn function_() {
    var local: f32;
    var phi_325_: bool;
    var phi_326_: bool;
    var phi_327_: bool;
    var phi_328_: bool;
    var phi_332_: bool;
    var phi_402_: bool;
    var phi_403_: bool;
    var phi_414_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_415_: bool;
    var phi_416_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_417_: bool;
    var phi_424_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_428_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_448_: lt_math_LightPoint;
    var phi_451_: u32;
    var phi_453_: lt_math_LevelPoint;
    var phi_539_: bool;
    var phi_548_: bool;
    var phi_557_: bool;
    var phi_558_: bool;
    var phi_559_: bool;
    var phi_560_: bool;
    var phi_561_: bool;
    var phi_562_: bool;
    var phi_563_: bool;
    var phi_567_: bool;
    var phi_594_: bool;
    var phi_595_: bool;
    var phi_596_: bool;
    var phi_597_: bool;
    var phi_598_: bool;
    var phi_599_: bool;
    var phi_600_: bool;
    var phi_601_: bool;
    var phi_605_: bool;
    var phi_614_: lt_math_LightPoint;
    var phi_615_: u32;
    var phi_616_: lt_math_LevelPoint;
    var phi_617_: bool;
    var phi_449_: lt_math_LightPoint;
    var phi_452_: u32;
    var phi_454_: lt_math_LevelPoint;
    var phi_618_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_665_: bool;
    var phi_747_: f32;
    var phi_865_: f32;
    var phi_866_: f32;
    var phi_869_: f32;
    var phi_898_: f32;
    var phi_903_: f32;
    var phi_904_: bool;
    var phi_905_: f32;
    var phi_906_: bool;
    var phi_910_: f32;
    var phi_930_: f32;
    var phi_935_: f32;
    var phi_936_: bool;
    var phi_937_: f32;
    var phi_938_: bool;
    var phi_942_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_993_: i32;
    var phi_998_: i32;
    var phi_1003_: i32;
    var phi_1008_: i32;
    var phi_1017_: i32;
    var phi_1022_: i32;
    var phi_1027_: i32;
    var phi_1032_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1132_: i32;
    var phi_1137_: i32;
    var phi_1142_: i32;
    var phi_1147_: i32;
    var phi_1166_: i32;
    var phi_1171_: i32;
    var phi_1176_: i32;
    var phi_1181_: i32;
    var phi_1200_: i32;
    var phi_1205_: i32;
    var phi_1210_: i32;
    var phi_1215_: i32;
    var phi_1234_: i32;
    var phi_1239_: i32;
    var phi_1244_: i32;
    var phi_1249_: i32;
    var phi_1327_: bool;
    var phi_1335_: bool;
    var phi_1347_: bool;
    var phi_1348_: bool;
    var phi_1352_: f32;
    var phi_1358_: f32;
    var phi_1360_: evaluate_Verdict;
    var phi_1370_: u32;
    var phi_1379_: f32;
    var phi_1381_: evaluate_Verdict;
    var phi_1382_: bool;
    var phi_1383_: evaluate_Verdict;
    var phi_1384_: bool;
    var phi_1389_: evaluate_Verdict;
    var phi_1394_: evaluate_Verdict;
    var phi_1395_: evaluate_Verdict;

    let _e47 = id_1;
    let _e54 = arrayLength((&map.member));
    let _e60 = arrayLength((&marks.member));
    let _e63 = arrayLength((&levels.member));
    let _e66 = p.member.size[0u];
    let _e68 = p.member.size[1u];
    let _e69 = lt_shaders_entry_pixel_index(_e47, _e66, _e68);
    if (bitcast<i32>(_e69.root) != 0i) {
        let _e75 = p.member.level_count;
        if (_e69.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e82 = samples.member[(0u + _e69.first_primitive)].normal[0u];
        let _e84 = global[0u];
        if (_e82 == _e84) {
            let _e87 = samples.member[(0u + _e69.first_primitive)].normal[1u];
            let _e89 = global[1u];
            if (_e87 == _e89) {
                let _e92 = samples.member[(0u + _e69.first_primitive)].normal[2u];
                let _e94 = global[2u];
                phi_325_ = (_e92 == _e94);
                phi_326_ = false;
            } else {
                phi_325_ = bool();
                phi_326_ = true;
            }
            let _e97 = phi_325_;
            let _e99 = phi_326_;
            phi_327_ = _e97;
            phi_328_ = _e99;
        } else {
            phi_327_ = bool();
            phi_328_ = true;
        }
        let _e101 = phi_327_;
        let _e103 = phi_328_;
        if _e103 {
            phi_332_ = false;
        } else {
            phi_332_ = _e101;
        }
        let _e105 = phi_332_;
        if !(_e105) {
            let _e108 = samples.member[(0u + _e69.first_primitive)].position;
            let _e110 = p.member.light.place;
            let _e116 = p.member.light.place[3u];
            let _e123 = (_e110.x - (_e108.x * _e116));
            let _e124 = (_e110.y - (_e108.y * _e116));
            let _e125 = (_e110.z - (_e108.z * _e116));
            let _e127 = samples.member[(0u + _e69.first_primitive)].normal;
            if ((((_e127.x * _e123) + (_e127.y * _e124)) + (_e127.z * _e125)) > 0f) {
                let _e141 = (((_e123 * _e123) + (_e124 * _e124)) + (_e125 * _e125));
                let _e143 = p.member.light.axis;
                let _e155 = p.member.light.place[3u];
                if (_e155 == 0f) {
                    phi_403_ = true;
                } else {
                    let _e158 = p.member.light.range_squared;
                    if (_e141 <= _e158) {
                        let _e161 = p.member.light.cos_outer;
                        phi_402_ = (-((((_e123 * _e143.x) + (_e124 * _e143.y)) + (_e125 * _e143.z))) >= (_e161 * sqrt(_e141)));
                    } else {
                        phi_402_ = false;
                    }
                    let _e166 = phi_402_;
                    phi_403_ = _e166;
                }
                let _e168 = phi_403_;
                if _e168 {
                    let _e170 = samples.member[(0u + _e69.first_primitive)].flags;
                    let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e178.unnamed.visibility, false), _e178.unnamed_1);
                    phi_414_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e184.unnamed, ((_e170 & 1u) == 0u));
                    phi_415_ = false;
                } else {
                    phi_414_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_415_ = true;
                }
                let _e189 = phi_414_;
                let _e191 = phi_415_;
                phi_416_ = _e189;
                phi_417_ = _e191;
            } else {
                phi_416_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_417_ = true;
            }
            let _e193 = phi_416_;
            let _e195 = phi_417_;
            if _e195 {
                let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e201.unnamed.visibility, false), _e201.unnamed_1);
                phi_424_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e207.unnamed, true);
            } else {
                phi_424_ = _e193;
            }
            let _e212 = phi_424_;
            phi_428_ = _e212;
        } else {
            let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e224 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e218.unnamed.visibility, false), _e218.unnamed_1);
            phi_428_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e224.unnamed, true);
        }
        let _e229 = phi_428_;
        if _e229.unnamed_1 {
            phi_1395_ = evaluate_Verdict(_e229.unnamed.visibility, _e229.unnamed.is_doubted);
        } else {
            let _e237 = samples.member[(0u + _e69.first_primitive)].position;
            let _e239 = p.member.map_size;
            let _e241 = (0.5f / f32(_e239));
            let _e248 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e255 = lt_math_LightPoint(vec2<f32>(_e248.uv.x, 0f), _e248.depth, _e248.is_inside);
            let _e259 = lt_math_LightPoint(_e255.uv, 0f, _e255.is_inside);
            phi_448_ = lt_math_LightPoint();
            phi_451_ = 0u;
            phi_453_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e259.uv, _e259.depth, false));
            loop {
                let _e266 = phi_448_;
                let _e268 = phi_451_;
                let _e270 = phi_453_;
                local_1 = _e270;
                local_2 = _e270;
                local_3 = _e270;
                local_4 = _e270;
                if (_e268 < _e75) {
                    if _e270.point.is_inside {
                        phi_614_ = lt_math_LightPoint();
                        phi_615_ = u32();
                        phi_616_ = lt_math_LevelPoint();
                        phi_617_ = false;
                    } else {
                        if (_e268 < _e63) {
                        } else {
                            return;
                        }
                        let _e281 = levels.member[(0u + _e268)].row_w;
                        let _e292 = ((((_e281.x * _e237.x) + (_e281.y * _e237.y)) + (_e281.z * _e237.z)) + (_e281.w * 1f));
                        let _e294 = levels.member[(0u + _e268)].row_x;
                        let _e306 = (((((_e294.x * _e237.x) + (_e294.y * _e237.y)) + (_e294.z * _e237.z)) + (_e294.w * 1f)) / _e292);
                        let _e308 = levels.member[(0u + _e268)].row_y;
                        let _e320 = (((((_e308.x * _e237.x) + (_e308.y * _e237.y)) + (_e308.z * _e237.z)) + (_e308.w * 1f)) / _e292);
                        let _e322 = levels.member[(0u + _e268)].row_z;
                        let _e333 = ((((_e322.x * _e237.x) + (_e322.y * _e237.y)) + (_e322.z * _e237.z)) + (_e322.w * 1f));
                        if (_e292 > 0f) {
                            if (_e306 >= 0f) {
                                phi_539_ = (_e306 <= 1f);
                            } else {
                                phi_539_ = false;
                            }
                            let _e338 = phi_539_;
                            if _e338 {
                                if (_e320 >= 0f) {
                                    phi_548_ = (_e320 <= 1f);
                                } else {
                                    phi_548_ = false;
                                }
                                let _e342 = phi_548_;
                                if _e342 {
                                    if (_e333 >= 0f) {
                                        phi_557_ = (_e333 <= 1f);
                                    } else {
                                        phi_557_ = false;
                                    }
                                    let _e346 = phi_557_;
                                    phi_558_ = _e346;
                                    phi_559_ = false;
                                } else {
                                    phi_558_ = bool();
                                    phi_559_ = true;
                                }
                                let _e348 = phi_558_;
                                let _e350 = phi_559_;
                                phi_560_ = _e348;
                                phi_561_ = _e350;
                            } else {
                                phi_560_ = bool();
                                phi_561_ = true;
                            }
                            let _e352 = phi_560_;
                            let _e354 = phi_561_;
                            phi_562_ = _e352;
                            phi_563_ = _e354;
                        } else {
                            phi_562_ = bool();
                            phi_563_ = true;
                        }
                        let _e356 = phi_562_;
                        let _e358 = phi_563_;
                        if _e358 {
                            phi_567_ = false;
                        } else {
                            phi_567_ = _e356;
                        }
                        let _e360 = phi_567_;
                        if _e360 {
                            if (_e306 >= _e241) {
                                if (_e306 <= (1f - _e241)) {
                                    if (_e320 >= _e241) {
                                        phi_594_ = (_e320 <= (1f - _e241));
                                        phi_595_ = false;
                                    } else {
                                        phi_594_ = bool();
                                        phi_595_ = true;
                                    }
                                    let _e368 = phi_594_;
                                    let _e370 = phi_595_;
                                    phi_596_ = _e368;
                                    phi_597_ = _e370;
                                } else {
                                    phi_596_ = bool();
                                    phi_597_ = true;
                                }
                                let _e372 = phi_596_;
                                let _e374 = phi_597_;
                                phi_598_ = _e372;
                                phi_599_ = _e374;
                            } else {
                                phi_598_ = bool();
                                phi_599_ = true;
                            }
                            let _e376 = phi_598_;
                            let _e378 = phi_599_;
                            phi_600_ = _e376;
                            phi_601_ = _e378;
                        } else {
                            phi_600_ = bool();
                            phi_601_ = true;
                        }
                        let _e380 = phi_600_;
                        let _e382 = phi_601_;
                        if _e382 {
                            phi_605_ = false;
                        } else {
                            phi_605_ = _e380;
                        }
                        let _e384 = phi_605_;
                        let _e391 = lt_math_LightPoint(vec2<f32>(_e306, _e266.uv.y), _e266.depth, _e266.is_inside);
                        let _e398 = lt_math_LightPoint(vec2<f32>(_e391.uv.x, _e320), _e391.depth, _e391.is_inside);
                        let _e402 = lt_math_LightPoint(_e398.uv, _e333, _e398.is_inside);
                        let _e406 = lt_math_LightPoint(_e402.uv, _e402.depth, _e384);
                        phi_614_ = _e406;
                        phi_615_ = (_e268 + 1u);
                        phi_616_ = lt_math_LevelPoint(_e268, _e406);
                        phi_617_ = true;
                    }
                    let _e410 = phi_614_;
                    let _e412 = phi_615_;
                    let _e414 = phi_616_;
                    let _e416 = phi_617_;
                    phi_449_ = _e410;
                    phi_452_ = _e412;
                    phi_454_ = _e414;
                    phi_618_ = _e416;
                } else {
                    phi_449_ = lt_math_LightPoint();
                    phi_452_ = u32();
                    phi_454_ = lt_math_LevelPoint();
                    phi_618_ = false;
                }
                let _e418 = phi_449_;
                let _e420 = phi_452_;
                let _e422 = phi_454_;
                let _e424 = phi_618_;
                continue;
                continuing {
                    phi_448_ = _e418;
                    phi_451_ = _e420;
                    phi_453_ = _e422;
                    break if !(_e424);
                }
            }
            let _e427 = local_1;
            if _e427.point.is_inside {
                if (0f > 0f) {
                    let _e433 = local_2;
                    if (_e433.level < _e63) {
                    } else {
                        return;
                    }
                    let _e438 = levels.member[(0u + _e433.level)];
                    let _e444 = global[0u];
                    if (_e438.row_w.x == _e444) {
                        let _e447 = global[1u];
                        if (_e438.row_w.y == _e447) {
                            let _e450 = global[2u];
                            phi_658_ = (_e438.row_w.z == _e450);
                            phi_659_ = false;
                        } else {
                            phi_658_ = bool();
                            phi_659_ = true;
                        }
                        let _e453 = phi_658_;
                        let _e455 = phi_659_;
                        phi_660_ = _e453;
                        phi_661_ = _e455;
                    } else {
                        phi_660_ = bool();
                        phi_661_ = true;
                    }
                    let _e457 = phi_660_;
                    let _e459 = phi_661_;
                    if _e459 {
                        phi_665_ = false;
                    } else {
                        phi_665_ = _e457;
                    }
                    let _e461 = phi_665_;
                    if _e461 {
                        let _e463 = samples.member[(0u + _e69.first_primitive)].normal;
                        let _e465 = p.member.map_size;
                        let _e535 = ((abs(((((_e438.row_x.x * _e463.x) + (_e438.row_x.y * _e463.y)) + (_e438.row_x.z * _e463.z)) / (((_e438.row_x.x * _e438.row_x.x) + (_e438.row_x.y * _e438.row_x.y)) + (_e438.row_x.z * _e438.row_x.z)))) + abs(((((_e438.row_y.x * _e463.x) + (_e438.row_y.y * _e463.y)) + (_e438.row_y.z * _e463.z)) / (((_e438.row_y.x * _e438.row_y.x) + (_e438.row_y.y * _e438.row_y.y)) + (_e438.row_y.z * _e438.row_y.z))))) / (abs(((((_e438.row_z.x * _e463.x) + (_e438.row_z.y * _e463.y)) + (_e438.row_z.z * _e463.z)) / (((_e438.row_z.x * _e438.row_z.x) + (_e438.row_z.y * _e438.row_z.y)) + (_e438.row_z.z * _e438.row_z.z)))) * f32(_e465)));
                        if (_e535 < 0.002f) {
                            phi_747_ = _e535;
                        } else {
                            phi_747_ = 0.002f;
                        }
                        let _e538 = phi_747_;
                        phi_866_ = _e538;
                    } else {
                        let _e540 = p.member.map_size;
                        let _e546 = samples.member[(0u + _e69.first_primitive)].position;
                        let _e557 = ((((_e438.row_w.x * _e546.x) + (_e438.row_w.y * _e546.y)) + (_e438.row_w.z * _e546.z)) + _e438.row_w.w);
                        let _e570 = ((_e438.row_x.x - (_e438.row_w.x * _e427.point.uv.x)) / _e557);
                        let _e571 = ((_e438.row_x.y - (_e438.row_w.y * _e427.point.uv.x)) / _e557);
                        let _e572 = ((_e438.row_x.z - (_e438.row_w.z * _e427.point.uv.x)) / _e557);
                        let _e585 = ((_e438.row_y.x - (_e438.row_w.x * _e427.point.uv.y)) / _e557);
                        let _e586 = ((_e438.row_y.y - (_e438.row_w.y * _e427.point.uv.y)) / _e557);
                        let _e587 = ((_e438.row_y.z - (_e438.row_w.z * _e427.point.uv.y)) / _e557);
                        let _e593 = samples.member[(0u + _e69.first_primitive)].normal;
                        let _e598 = ((_e586 * _e593.z) - (_e593.y * _e587));
                        let _e603 = ((_e587 * _e593.x) - (_e593.z * _e585));
                        let _e608 = ((_e585 * _e593.y) - (_e593.x * _e586));
                        let _e610 = samples.member[(0u + _e69.first_primitive)].normal;
                        let _e615 = ((_e571 * _e610.z) - (_e610.y * _e572));
                        let _e620 = ((_e572 * _e610.x) - (_e610.z * _e570));
                        let _e625 = ((_e570 * _e610.y) - (_e610.x * _e571));
                        let _e652 = ((abs(((((_e438.row_z.x * _e598) + (_e438.row_z.y * _e603)) + (_e438.row_z.z * _e608)) / (((_e570 * _e598) + (_e571 * _e603)) + (_e572 * _e608)))) + abs(((((_e438.row_z.x * _e615) + (_e438.row_z.y * _e620)) + (_e438.row_z.z * _e625)) / (((_e585 * _e615) + (_e586 * _e620)) + (_e587 * _e625))))) / f32(_e540));
                        let _e654 = (16f / f32(_e540));
                        if (_e652 < _e654) {
                            phi_865_ = _e652;
                        } else {
                            phi_865_ = _e654;
                        }
                        let _e657 = phi_865_;
                        phi_866_ = _e657;
                    }
                    let _e659 = phi_866_;
                    phi_869_ = (_e427.point.depth - (0f * _e659));
                } else {
                    phi_869_ = _e427.point.depth;
                }
                let _e663 = phi_869_;
                let _e669 = p.member.map_size;
                let _e670 = f32(_e669);
                let _e673 = ((_e427.point.uv.x * _e670) - 0.5f);
                let _e674 = ((_e427.point.uv.y * _e670) - 0.5f);
                if (_e673 > -8388608f) {
                    let _e686 = f32(select(0i, select(select(i32(_e673), i32(-2147483648), (_e673 < bitcast<f32>(3472883712u))), 2147483647i, (_e673 > bitcast<f32>(1325400063u))), (_e673 == _e673)));
                    if (_e686 > _e673) {
                        phi_898_ = 1f;
                    } else {
                        phi_898_ = 0f;
                    }
                    let _e689 = phi_898_;
                    if (_e673 < 8388608f) {
                        phi_903_ = (_e686 - _e689);
                        phi_904_ = false;
                    } else {
                        phi_903_ = f32();
                        phi_904_ = true;
                    }
                    let _e692 = phi_903_;
                    let _e694 = phi_904_;
                    phi_905_ = _e692;
                    phi_906_ = _e694;
                } else {
                    phi_905_ = f32();
                    phi_906_ = true;
                }
                let _e696 = phi_905_;
                let _e698 = phi_906_;
                if _e698 {
                    phi_910_ = _e673;
                } else {
                    phi_910_ = _e696;
                }
                let _e700 = phi_910_;
                if (_e674 > -8388608f) {
                    let _e712 = f32(select(0i, select(select(i32(_e674), i32(-2147483648), (_e674 < bitcast<f32>(3472883712u))), 2147483647i, (_e674 > bitcast<f32>(1325400063u))), (_e674 == _e674)));
                    if (_e712 > _e674) {
                        phi_930_ = 1f;
                    } else {
                        phi_930_ = 0f;
                    }
                    let _e715 = phi_930_;
                    if (_e674 < 8388608f) {
                        phi_935_ = (_e712 - _e715);
                        phi_936_ = false;
                    } else {
                        phi_935_ = f32();
                        phi_936_ = true;
                    }
                    let _e718 = phi_935_;
                    let _e720 = phi_936_;
                    phi_937_ = _e718;
                    phi_938_ = _e720;
                } else {
                    phi_937_ = f32();
                    phi_938_ = true;
                }
                let _e722 = phi_937_;
                let _e724 = phi_938_;
                if _e724 {
                    phi_942_ = _e674;
                } else {
                    phi_942_ = _e722;
                }
                let _e726 = phi_942_;
                let _e727 = (_e673 - _e700);
                let _e728 = (_e674 - _e726);
                let _e737 = select(0i, select(select(i32(_e700), i32(-2147483648), (_e700 < bitcast<f32>(3472883712u))), 2147483647i, (_e700 > bitcast<f32>(1325400063u))), (_e700 == _e700));
                let _e746 = select(0i, select(select(i32(_e726), i32(-2147483648), (_e726 < bitcast<f32>(3472883712u))), 2147483647i, (_e726 > bitcast<f32>(1325400063u))), (_e726 == _e726));
                let _e749 = ((1f - _e727) * (1f - _e728));
                let _e751 = (_e727 * (1f - _e728));
                let _e753 = ((1f - _e727) * _e728);
                let _e754 = (_e727 * _e728);
                let _e756 = p.member.test;
                let _e757 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e756);
                let _e759 = p.member.map_size;
                let _e761 = local_3;
                local = _e757;
                let _e764 = ((_e761.level * _e759) * _e759);
                let _e766 = (bitcast<i32>(_e759) - 1i);
                if (_e737 > 0i) {
                    phi_993_ = _e737;
                } else {
                    phi_993_ = 0i;
                }
                let _e769 = phi_993_;
                if (_e746 > 0i) {
                    phi_998_ = _e746;
                } else {
                    phi_998_ = 0i;
                }
                let _e772 = phi_998_;
                if (_e769 < _e766) {
                    phi_1003_ = _e769;
                } else {
                    phi_1003_ = _e766;
                }
                let _e775 = phi_1003_;
                if (_e772 < _e766) {
                    phi_1008_ = _e772;
                } else {
                    phi_1008_ = _e766;
                }
                let _e778 = phi_1008_;
                let _e779 = bitcast<u32>(_e775);
                let _e781 = (_e737 + 1i);
                let _e782 = (_e746 + 1i);
                if (_e781 > 0i) {
                    phi_1017_ = _e781;
                } else {
                    phi_1017_ = 0i;
                }
                let _e785 = phi_1017_;
                if (_e782 > 0i) {
                    phi_1022_ = _e782;
                } else {
                    phi_1022_ = 0i;
                }
                let _e788 = phi_1022_;
                if (_e785 < _e766) {
                    phi_1027_ = _e785;
                } else {
                    phi_1027_ = _e766;
                }
                let _e791 = phi_1027_;
                if (_e788 < _e766) {
                    phi_1032_ = _e788;
                } else {
                    phi_1032_ = _e766;
                }
                let _e794 = phi_1032_;
                let _e795 = bitcast<u32>(_e791);
                let _e797 = (bitcast<u32>(_e778) * _e759);
                let _e798 = (bitcast<u32>(_e794) * _e759);
                let _e803 = ((_e797 + _e779) + _e764);
                let _e804 = ((_e797 + _e795) + _e764);
                let _e805 = ((_e798 + _e779) + _e764);
                let _e806 = ((_e798 + _e795) + _e764);
                if (_e803 < _e54) {
                } else {
                    return;
                }
                let _e810 = map.member[(0u + _e803)];
                if (_e804 < _e54) {
                } else {
                    return;
                }
                let _e822 = map.member[(0u + _e804)];
                if (_e805 < _e54) {
                } else {
                    return;
                }
                let _e838 = map.member[(0u + _e805)];
                if (_e806 < _e54) {
                } else {
                    return;
                }
                let _e854 = map.member[(0u + _e806)];
                let _e868 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e810.x * _e749) + (_e822.x * _e751)) + (_e838.x * _e753)) + (_e854.x * _e754)), ((((_e810.y * _e749) + (_e822.y * _e751)) + (_e838.y * _e753)) + (_e854.y * _e754)), ((((_e810.z * _e749) + (_e822.z * _e751)) + (_e838.z * _e753)) + (_e854.z * _e754)), ((((_e810.w * _e749) + (_e822.w * _e751)) + (_e838.w * _e753)) + (_e854.w * _e754))), _e663);
                let _e870 = p.member.map_size;
                let _e872 = local_4;
                let _e875 = (bitcast<i32>(_e870) - 1i);
                if (_e737 > 0i) {
                    phi_1132_ = _e737;
                } else {
                    phi_1132_ = 0i;
                }
                let _e878 = phi_1132_;
                if (_e746 > 0i) {
                    phi_1137_ = _e746;
                } else {
                    phi_1137_ = 0i;
                }
                let _e881 = phi_1137_;
                if (_e878 < _e875) {
                    phi_1142_ = _e878;
                } else {
                    phi_1142_ = _e875;
                }
                let _e884 = phi_1142_;
                if (_e881 < _e875) {
                    phi_1147_ = _e881;
                } else {
                    phi_1147_ = _e875;
                }
                let _e887 = phi_1147_;
                let _e888 = bitcast<u32>(_e884);
                let _e895 = ((((_e872.level * _e870) + bitcast<u32>(_e887)) * (_e870 / 16u)) + (_e888 / 16u));
                let _e898 = (_e737 + 1i);
                let _e899 = (_e746 + 0i);
                let _e901 = (bitcast<i32>(_e870) - 1i);
                if (_e898 > 0i) {
                    phi_1166_ = _e898;
                } else {
                    phi_1166_ = 0i;
                }
                let _e904 = phi_1166_;
                if (_e899 > 0i) {
                    phi_1171_ = _e899;
                } else {
                    phi_1171_ = 0i;
                }
                let _e907 = phi_1171_;
                if (_e904 < _e901) {
                    phi_1176_ = _e904;
                } else {
                    phi_1176_ = _e901;
                }
                let _e910 = phi_1176_;
                if (_e907 < _e901) {
                    phi_1181_ = _e907;
                } else {
                    phi_1181_ = _e901;
                }
                let _e913 = phi_1181_;
                let _e914 = bitcast<u32>(_e910);
                let _e921 = ((((_e872.level * _e870) + bitcast<u32>(_e913)) * (_e870 / 16u)) + (_e914 / 16u));
                let _e924 = (_e737 + 0i);
                let _e925 = (_e746 + 1i);
                let _e927 = (bitcast<i32>(_e870) - 1i);
                if (_e924 > 0i) {
                    phi_1200_ = _e924;
                } else {
                    phi_1200_ = 0i;
                }
                let _e930 = phi_1200_;
                if (_e925 > 0i) {
                    phi_1205_ = _e925;
                } else {
                    phi_1205_ = 0i;
                }
                let _e933 = phi_1205_;
                if (_e930 < _e927) {
                    phi_1210_ = _e930;
                } else {
                    phi_1210_ = _e927;
                }
                let _e936 = phi_1210_;
                if (_e933 < _e927) {
                    phi_1215_ = _e933;
                } else {
                    phi_1215_ = _e927;
                }
                let _e939 = phi_1215_;
                let _e940 = bitcast<u32>(_e936);
                let _e947 = ((((_e872.level * _e870) + bitcast<u32>(_e939)) * (_e870 / 16u)) + (_e940 / 16u));
                let _e950 = (_e737 + 1i);
                let _e951 = (_e746 + 1i);
                let _e953 = (bitcast<i32>(_e870) - 1i);
                if (_e950 > 0i) {
                    phi_1234_ = _e950;
                } else {
                    phi_1234_ = 0i;
                }
                let _e956 = phi_1234_;
                if (_e951 > 0i) {
                    phi_1239_ = _e951;
                } else {
                    phi_1239_ = 0i;
                }
                let _e959 = phi_1239_;
                if (_e956 < _e953) {
                    phi_1244_ = _e956;
                } else {
                    phi_1244_ = _e953;
                }
                let _e962 = phi_1244_;
                if (_e959 < _e953) {
                    phi_1249_ = _e959;
                } else {
                    phi_1249_ = _e953;
                }
                let _e965 = phi_1249_;
                let _e966 = bitcast<u32>(_e962);
                let _e973 = ((((_e872.level * _e870) + bitcast<u32>(_e965)) * (_e870 / 16u)) + (_e966 / 16u));
                if (_e895 < _e60) {
                } else {
                    return;
                }
                let _e979 = marks.member[(0u + _e895)];
                if (_e921 < _e60) {
                } else {
                    return;
                }
                let _e987 = marks.member[(0u + _e921)];
                if (_e947 < _e60) {
                } else {
                    return;
                }
                let _e996 = marks.member[(0u + _e947)];
                if (_e973 < _e60) {
                } else {
                    return;
                }
                let _e1004 = marks.member[(0u + _e973)];
                let _e1012 = p.member.epsilon;
                if (_e868 <= _e1012) {
                    phi_1327_ = true;
                } else {
                    phi_1327_ = (_e868 >= (1f - _e1012));
                }
                let _e1017 = phi_1327_;
                if ((bitcast<u32>(_e868) & 2147483647u) > 2139095040u) {
                    phi_1335_ = true;
                } else {
                    phi_1335_ = !(_e1017);
                }
                let _e1023 = phi_1335_;
                if _e1023 {
                    if (_e868 > 0f) {
                        if (_e868 < 1f) {
                            phi_1347_ = false;
                        } else {
                            phi_1347_ = true;
                        }
                        let _e1027 = phi_1347_;
                        phi_1348_ = _e1027;
                    } else {
                        phi_1348_ = true;
                    }
                    let _e1029 = phi_1348_;
                    if _e1029 {
                        phi_1352_ = 0.5f;
                    } else {
                        phi_1352_ = _e868;
                    }
                    let _e1031 = phi_1352_;
                    phi_1360_ = evaluate_Verdict(_e1031, true);
                } else {
                    if (_e868 > 0.5f) {
                        phi_1358_ = 1f;
                    } else {
                        phi_1358_ = 0f;
                    }
                    let _e1035 = phi_1358_;
                    phi_1360_ = evaluate_Verdict(_e1035, false);
                }
                let _e1038 = phi_1360_;
                let _e1041 = (_e1038.visibility < 0.5f);
                if _e1038.is_doubted {
                    phi_1383_ = evaluate_Verdict();
                    phi_1384_ = true;
                } else {
                    if _e1041 {
                        phi_1370_ = 2u;
                    } else {
                        phi_1370_ = 1u;
                    }
                    let _e1043 = phi_1370_;
                    if ((((((_e979 >> bitcast<u32>((((_e888 % 16u) * 2u) & 31u))) & 3u) | ((_e987 >> bitcast<u32>((((_e914 % 16u) * 2u) & 31u))) & 3u)) | (((_e996 >> bitcast<u32>((((_e940 % 16u) * 2u) & 31u))) & 3u) | ((_e1004 >> bitcast<u32>((((_e966 % 16u) * 2u) & 31u))) & 3u))) & _e1043) != 0u) {
                        if _e1041 {
                            phi_1379_ = 0.000000059604645f;
                        } else {
                            phi_1379_ = 0.99999994f;
                        }
                        let _e1047 = phi_1379_;
                        phi_1381_ = evaluate_Verdict(_e1047, true);
                        phi_1382_ = false;
                    } else {
                        phi_1381_ = evaluate_Verdict();
                        phi_1382_ = true;
                    }
                    let _e1050 = phi_1381_;
                    let _e1052 = phi_1382_;
                    phi_1383_ = _e1050;
                    phi_1384_ = _e1052;
                }
                let _e1054 = phi_1383_;
                let _e1056 = phi_1384_;
                if _e1056 {
                    phi_1389_ = evaluate_Verdict(_e1038.visibility, _e1038.is_doubted);
                } else {
                    phi_1389_ = _e1054;
                }
                let _e1059 = phi_1389_;
                phi_1394_ = evaluate_Verdict(_e1059.visibility, _e1059.is_doubted);
            } else {
                phi_1394_ = evaluate_Verdict(0.5f, true);
            }
            let _e1065 = phi_1394_;
            phi_1395_ = _e1065;
        }
        let _e1067 = phi_1395_;
        if (_e69.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e69.first_primitive)] = _e1067.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_vsm_prefiltered_levels_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
