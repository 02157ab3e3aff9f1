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
    var phi_168_: lt_bvh_traverse_Tree;
    var phi_169_: bool;
    var phi_170_: lt_bvh_traverse_Tree;
    var phi_171_: bool;
    var phi_176_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_168_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_169_ = false;
        } else {
            phi_168_ = lt_bvh_traverse_Tree();
            phi_169_ = true;
        }
        let _e59 = phi_168_;
        let _e61 = phi_169_;
        phi_170_ = _e59;
        phi_171_ = _e61;
    } else {
        phi_170_ = lt_bvh_traverse_Tree();
        phi_171_ = true;
    }
    let _e63 = phi_170_;
    let _e65 = phi_171_;
    if _e65 {
        phi_176_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_176_ = _e63;
    }
    let _e70 = phi_176_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_225_: f32;
    var phi_226_: f32;
    var phi_227_: f32;
    var phi_233_: bool;
    var phi_255_: f32;
    var phi_256_: f32;
    var phi_257_: f32;
    var phi_258_: f32;
    var phi_259_: bool;
    var phi_260_: f32;
    var phi_261_: bool;
    var phi_299_: vec2<f32>;
    var phi_333_: f32;
    var phi_334_: f32;
    var phi_335_: f32;
    var phi_364_: f32;
    var phi_365_: f32;
    var phi_366_: f32;
    var phi_370_: f32;
    var phi_371_: f32;
    var phi_372_: f32;
    var phi_373_: f32;

    let _e49 = (*param_4);
    let _e50 = (1f - _e49);
    let _e59 = (0.5f * _e49);
    let _e60 = ((param_5.x * _e50) + _e59);
    let _e61 = ((param_5.y * _e50) + _e59);
    let _e63 = ((param_5.w * _e50) + _e59);
    let _e65 = (_e61 - (_e60 * _e60));
    let _e67 = (((param_5.z * _e50) + _e59) - (_e60 * _e61));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_227_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_226_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_225_ = 1f;
            } else {
                phi_225_ = param_6;
            }
            let _e79 = phi_225_;
            phi_226_ = _e79;
        }
        let _e81 = phi_226_;
        phi_227_ = _e81;
    }
    let _e83 = phi_227_;
    if (_e60 == _e63) {
        phi_233_ = (_e60 > 0.5f);
    } else {
        phi_233_ = false;
    }
    let _e87 = phi_233_;
    if _e87 {
        if (_e83 > 0f) {
            if ((bitcast<u32>(_e60) & 2147483647u) > 2139095040u) {
                phi_257_ = _e60;
            } else {
                if (_e60 < 0f) {
                    phi_256_ = 0f;
                } else {
                    if (_e60 > 1f) {
                        phi_255_ = 1f;
                    } else {
                        phi_255_ = _e60;
                    }
                    let _e95 = phi_255_;
                    phi_256_ = _e95;
                }
                let _e97 = phi_256_;
                phi_257_ = _e97;
            }
            let _e99 = phi_257_;
            phi_258_ = _e99;
            phi_259_ = false;
        } else {
            phi_258_ = f32();
            phi_259_ = true;
        }
        let _e101 = phi_258_;
        let _e103 = phi_259_;
        phi_260_ = _e101;
        phi_261_ = _e103;
    } else {
        phi_260_ = f32();
        phi_261_ = true;
    }
    let _e105 = phi_260_;
    let _e107 = phi_261_;
    if _e107 {
        let _e108 = (_e67 / _e65);
        let _e109 = (_e83 - _e60);
        let _e115 = (((((_e83 * _e83) - _e61) - (_e108 * _e109)) * _e65) / (((_e63 - (_e61 * _e61)) * _e65) - (_e67 * _e67)));
        let _e118 = ((_e109 / _e65) - (_e108 * _e115));
        let _e124 = ((0.5f * _e118) / _e115);
        let _e127 = ((_e124 * _e124) - (((1f - (_e118 * _e60)) - (_e115 * _e61)) / _e115));
        if (_e127 >= 0f) {
            let _e129 = sqrt(_e127);
            phi_299_ = vec2<f32>((-(_e124) - _e129), (-(_e124) + _e129));
        } else {
            phi_299_ = vec2(bitcast<f32>((bitcast<u32>(_e127) | 2143289344u)));
        }
        let _e140 = phi_299_;
        if (_e83 <= _e140.x) {
            phi_372_ = 1f;
        } else {
            if (_e83 > _e140.y) {
                let _e153 = (((_e61 - (_e60 * (_e140.x + _e140.y))) + (_e140.x * _e140.y)) / ((_e83 - _e140.x) * (_e83 - _e140.y)));
                if ((bitcast<u32>(_e153) & 2147483647u) > 2139095040u) {
                    phi_335_ = _e153;
                } else {
                    if (_e153 < 0f) {
                        phi_334_ = 0f;
                    } else {
                        if (_e153 > 1f) {
                            phi_333_ = 1f;
                        } else {
                            phi_333_ = _e153;
                        }
                        let _e160 = phi_333_;
                        phi_334_ = _e160;
                    }
                    let _e162 = phi_334_;
                    phi_335_ = _e162;
                }
                let _e164 = phi_335_;
                phi_371_ = _e164;
            } else {
                if (_e83 > _e140.x) {
                    let _e175 = (1f - (((_e61 - (_e60 * (_e83 + _e140.y))) + (_e83 * _e140.y)) / ((_e140.x - _e83) * (_e140.x - _e140.y))));
                    if ((bitcast<u32>(_e175) & 2147483647u) > 2139095040u) {
                        phi_366_ = _e175;
                    } else {
                        if (_e175 < 0f) {
                            phi_365_ = 0f;
                        } else {
                            if (_e175 > 1f) {
                                phi_364_ = 1f;
                            } else {
                                phi_364_ = _e175;
                            }
                            let _e182 = phi_364_;
                            phi_365_ = _e182;
                        }
                        let _e184 = phi_365_;
                        phi_366_ = _e184;
                    }
                    let _e186 = phi_366_;
                    phi_370_ = _e186;
                } else {
                    phi_370_ = bitcast<f32>((bitcast<u32>(_e140.x) | 2143289344u));
                }
                let _e191 = phi_370_;
                phi_371_ = _e191;
            }
            let _e193 = phi_371_;
            phi_372_ = _e193;
        }
        let _e195 = phi_372_;
        phi_373_ = _e195;
    } else {
        phi_373_ = _e105;
    }
    let _e197 = phi_373_;
    return _e197;
}

fn function_() {
    var local: f32;
    var phi_439_: bool;
    var phi_440_: bool;
    var phi_441_: bool;
    var phi_442_: bool;
    var phi_446_: bool;
    var phi_516_: bool;
    var phi_517_: bool;
    var phi_528_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_529_: bool;
    var phi_530_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_531_: bool;
    var phi_538_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_542_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_562_: lt_math_LightPoint;
    var phi_565_: u32;
    var phi_567_: lt_math_LevelPoint;
    var phi_653_: bool;
    var phi_662_: bool;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_674_: bool;
    var phi_675_: bool;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_681_: bool;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_711_: bool;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_714_: bool;
    var phi_715_: bool;
    var phi_719_: bool;
    var phi_728_: lt_math_LightPoint;
    var phi_729_: u32;
    var phi_730_: lt_math_LevelPoint;
    var phi_731_: bool;
    var phi_563_: lt_math_LightPoint;
    var phi_566_: u32;
    var phi_568_: lt_math_LevelPoint;
    var phi_732_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_772_: bool;
    var phi_773_: bool;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_779_: bool;
    var phi_861_: f32;
    var phi_979_: f32;
    var phi_980_: f32;
    var phi_983_: f32;
    var phi_1012_: f32;
    var phi_1017_: f32;
    var phi_1018_: bool;
    var phi_1019_: f32;
    var phi_1020_: bool;
    var phi_1024_: f32;
    var phi_1044_: f32;
    var phi_1049_: f32;
    var phi_1050_: bool;
    var phi_1051_: f32;
    var phi_1052_: bool;
    var phi_1056_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1107_: i32;
    var phi_1112_: i32;
    var phi_1117_: i32;
    var phi_1122_: i32;
    var phi_1131_: i32;
    var phi_1136_: i32;
    var phi_1141_: i32;
    var phi_1146_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1246_: i32;
    var phi_1251_: i32;
    var phi_1256_: i32;
    var phi_1261_: i32;
    var phi_1280_: i32;
    var phi_1285_: i32;
    var phi_1290_: i32;
    var phi_1295_: i32;
    var phi_1314_: i32;
    var phi_1319_: i32;
    var phi_1324_: i32;
    var phi_1329_: i32;
    var phi_1348_: i32;
    var phi_1353_: i32;
    var phi_1358_: i32;
    var phi_1363_: i32;
    var phi_1441_: bool;
    var phi_1449_: bool;
    var phi_1461_: bool;
    var phi_1462_: bool;
    var phi_1466_: f32;
    var phi_1472_: f32;
    var phi_1474_: evaluate_Verdict;
    var phi_1484_: u32;
    var phi_1493_: f32;
    var phi_1495_: evaluate_Verdict;
    var phi_1496_: bool;
    var phi_1497_: evaluate_Verdict;
    var phi_1498_: bool;
    var phi_1503_: evaluate_Verdict;
    var phi_1508_: evaluate_Verdict;
    var phi_1509_: evaluate_Verdict;

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
                phi_439_ = (_e92 == _e94);
                phi_440_ = false;
            } else {
                phi_439_ = bool();
                phi_440_ = true;
            }
            let _e97 = phi_439_;
            let _e99 = phi_440_;
            phi_441_ = _e97;
            phi_442_ = _e99;
        } else {
            phi_441_ = bool();
            phi_442_ = true;
        }
        let _e101 = phi_441_;
        let _e103 = phi_442_;
        if _e103 {
            phi_446_ = false;
        } else {
            phi_446_ = _e101;
        }
        let _e105 = phi_446_;
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
                    phi_517_ = true;
                } else {
                    let _e158 = p.member.light.range_squared;
                    if (_e141 <= _e158) {
                        let _e161 = p.member.light.cos_outer;
                        phi_516_ = (-((((_e123 * _e143.x) + (_e124 * _e143.y)) + (_e125 * _e143.z))) >= (_e161 * sqrt(_e141)));
                    } else {
                        phi_516_ = false;
                    }
                    let _e166 = phi_516_;
                    phi_517_ = _e166;
                }
                let _e168 = phi_517_;
                if _e168 {
                    let _e170 = samples.member[(0u + _e69.first_primitive)].flags;
                    let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e178.unnamed.visibility, false), _e178.unnamed_1);
                    phi_528_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e184.unnamed, ((_e170 & 1u) == 0u));
                    phi_529_ = false;
                } else {
                    phi_528_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_529_ = true;
                }
                let _e189 = phi_528_;
                let _e191 = phi_529_;
                phi_530_ = _e189;
                phi_531_ = _e191;
            } else {
                phi_530_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_531_ = true;
            }
            let _e193 = phi_530_;
            let _e195 = phi_531_;
            if _e195 {
                let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e201.unnamed.visibility, false), _e201.unnamed_1);
                phi_538_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e207.unnamed, true);
            } else {
                phi_538_ = _e193;
            }
            let _e212 = phi_538_;
            phi_542_ = _e212;
        } else {
            let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e224 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e218.unnamed.visibility, false), _e218.unnamed_1);
            phi_542_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e224.unnamed, true);
        }
        let _e229 = phi_542_;
        if _e229.unnamed_1 {
            phi_1509_ = evaluate_Verdict(_e229.unnamed.visibility, _e229.unnamed.is_doubted);
        } else {
            let _e237 = samples.member[(0u + _e69.first_primitive)].position;
            let _e239 = p.member.map_size;
            let _e241 = (0.5f / f32(_e239));
            let _e248 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e255 = lt_math_LightPoint(vec2<f32>(_e248.uv.x, 0f), _e248.depth, _e248.is_inside);
            let _e259 = lt_math_LightPoint(_e255.uv, 0f, _e255.is_inside);
            phi_562_ = lt_math_LightPoint();
            phi_565_ = 0u;
            phi_567_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e259.uv, _e259.depth, false));
            loop {
                let _e266 = phi_562_;
                let _e268 = phi_565_;
                let _e270 = phi_567_;
                local_1 = _e270;
                local_2 = _e270;
                local_3 = _e270;
                local_4 = _e270;
                if (_e268 < _e75) {
                    if _e270.point.is_inside {
                        phi_728_ = lt_math_LightPoint();
                        phi_729_ = u32();
                        phi_730_ = lt_math_LevelPoint();
                        phi_731_ = false;
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
                                phi_653_ = (_e306 <= 1f);
                            } else {
                                phi_653_ = false;
                            }
                            let _e338 = phi_653_;
                            if _e338 {
                                if (_e320 >= 0f) {
                                    phi_662_ = (_e320 <= 1f);
                                } else {
                                    phi_662_ = false;
                                }
                                let _e342 = phi_662_;
                                if _e342 {
                                    if (_e333 >= 0f) {
                                        phi_671_ = (_e333 <= 1f);
                                    } else {
                                        phi_671_ = false;
                                    }
                                    let _e346 = phi_671_;
                                    phi_672_ = _e346;
                                    phi_673_ = false;
                                } else {
                                    phi_672_ = bool();
                                    phi_673_ = true;
                                }
                                let _e348 = phi_672_;
                                let _e350 = phi_673_;
                                phi_674_ = _e348;
                                phi_675_ = _e350;
                            } else {
                                phi_674_ = bool();
                                phi_675_ = true;
                            }
                            let _e352 = phi_674_;
                            let _e354 = phi_675_;
                            phi_676_ = _e352;
                            phi_677_ = _e354;
                        } else {
                            phi_676_ = bool();
                            phi_677_ = true;
                        }
                        let _e356 = phi_676_;
                        let _e358 = phi_677_;
                        if _e358 {
                            phi_681_ = false;
                        } else {
                            phi_681_ = _e356;
                        }
                        let _e360 = phi_681_;
                        if _e360 {
                            if (_e306 >= _e241) {
                                if (_e306 <= (1f - _e241)) {
                                    if (_e320 >= _e241) {
                                        phi_708_ = (_e320 <= (1f - _e241));
                                        phi_709_ = false;
                                    } else {
                                        phi_708_ = bool();
                                        phi_709_ = true;
                                    }
                                    let _e368 = phi_708_;
                                    let _e370 = phi_709_;
                                    phi_710_ = _e368;
                                    phi_711_ = _e370;
                                } else {
                                    phi_710_ = bool();
                                    phi_711_ = true;
                                }
                                let _e372 = phi_710_;
                                let _e374 = phi_711_;
                                phi_712_ = _e372;
                                phi_713_ = _e374;
                            } else {
                                phi_712_ = bool();
                                phi_713_ = true;
                            }
                            let _e376 = phi_712_;
                            let _e378 = phi_713_;
                            phi_714_ = _e376;
                            phi_715_ = _e378;
                        } else {
                            phi_714_ = bool();
                            phi_715_ = true;
                        }
                        let _e380 = phi_714_;
                        let _e382 = phi_715_;
                        if _e382 {
                            phi_719_ = false;
                        } else {
                            phi_719_ = _e380;
                        }
                        let _e384 = phi_719_;
                        let _e391 = lt_math_LightPoint(vec2<f32>(_e306, _e266.uv.y), _e266.depth, _e266.is_inside);
                        let _e398 = lt_math_LightPoint(vec2<f32>(_e391.uv.x, _e320), _e391.depth, _e391.is_inside);
                        let _e402 = lt_math_LightPoint(_e398.uv, _e333, _e398.is_inside);
                        let _e406 = lt_math_LightPoint(_e402.uv, _e402.depth, _e384);
                        phi_728_ = _e406;
                        phi_729_ = (_e268 + 1u);
                        phi_730_ = lt_math_LevelPoint(_e268, _e406);
                        phi_731_ = true;
                    }
                    let _e410 = phi_728_;
                    let _e412 = phi_729_;
                    let _e414 = phi_730_;
                    let _e416 = phi_731_;
                    phi_563_ = _e410;
                    phi_566_ = _e412;
                    phi_568_ = _e414;
                    phi_732_ = _e416;
                } else {
                    phi_563_ = lt_math_LightPoint();
                    phi_566_ = u32();
                    phi_568_ = lt_math_LevelPoint();
                    phi_732_ = false;
                }
                let _e418 = phi_563_;
                let _e420 = phi_566_;
                let _e422 = phi_568_;
                let _e424 = phi_732_;
                continue;
                continuing {
                    phi_562_ = _e418;
                    phi_565_ = _e420;
                    phi_567_ = _e422;
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
                            phi_772_ = (_e438.row_w.z == _e450);
                            phi_773_ = false;
                        } else {
                            phi_772_ = bool();
                            phi_773_ = true;
                        }
                        let _e453 = phi_772_;
                        let _e455 = phi_773_;
                        phi_774_ = _e453;
                        phi_775_ = _e455;
                    } else {
                        phi_774_ = bool();
                        phi_775_ = true;
                    }
                    let _e457 = phi_774_;
                    let _e459 = phi_775_;
                    if _e459 {
                        phi_779_ = false;
                    } else {
                        phi_779_ = _e457;
                    }
                    let _e461 = phi_779_;
                    if _e461 {
                        let _e463 = samples.member[(0u + _e69.first_primitive)].normal;
                        let _e465 = p.member.map_size;
                        let _e535 = ((abs(((((_e438.row_x.x * _e463.x) + (_e438.row_x.y * _e463.y)) + (_e438.row_x.z * _e463.z)) / (((_e438.row_x.x * _e438.row_x.x) + (_e438.row_x.y * _e438.row_x.y)) + (_e438.row_x.z * _e438.row_x.z)))) + abs(((((_e438.row_y.x * _e463.x) + (_e438.row_y.y * _e463.y)) + (_e438.row_y.z * _e463.z)) / (((_e438.row_y.x * _e438.row_y.x) + (_e438.row_y.y * _e438.row_y.y)) + (_e438.row_y.z * _e438.row_y.z))))) / (abs(((((_e438.row_z.x * _e463.x) + (_e438.row_z.y * _e463.y)) + (_e438.row_z.z * _e463.z)) / (((_e438.row_z.x * _e438.row_z.x) + (_e438.row_z.y * _e438.row_z.y)) + (_e438.row_z.z * _e438.row_z.z)))) * f32(_e465)));
                        if (_e535 < 0.002f) {
                            phi_861_ = _e535;
                        } else {
                            phi_861_ = 0.002f;
                        }
                        let _e538 = phi_861_;
                        phi_980_ = _e538;
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
                            phi_979_ = _e652;
                        } else {
                            phi_979_ = _e654;
                        }
                        let _e657 = phi_979_;
                        phi_980_ = _e657;
                    }
                    let _e659 = phi_980_;
                    phi_983_ = (_e427.point.depth - (0f * _e659));
                } else {
                    phi_983_ = _e427.point.depth;
                }
                let _e663 = phi_983_;
                let _e669 = p.member.map_size;
                let _e670 = f32(_e669);
                let _e673 = ((_e427.point.uv.x * _e670) - 0.5f);
                let _e674 = ((_e427.point.uv.y * _e670) - 0.5f);
                if (_e673 > -8388608f) {
                    let _e686 = f32(select(0i, select(select(i32(_e673), i32(-2147483648), (_e673 < bitcast<f32>(3472883712u))), 2147483647i, (_e673 > bitcast<f32>(1325400063u))), (_e673 == _e673)));
                    if (_e686 > _e673) {
                        phi_1012_ = 1f;
                    } else {
                        phi_1012_ = 0f;
                    }
                    let _e689 = phi_1012_;
                    if (_e673 < 8388608f) {
                        phi_1017_ = (_e686 - _e689);
                        phi_1018_ = false;
                    } else {
                        phi_1017_ = f32();
                        phi_1018_ = true;
                    }
                    let _e692 = phi_1017_;
                    let _e694 = phi_1018_;
                    phi_1019_ = _e692;
                    phi_1020_ = _e694;
                } else {
                    phi_1019_ = f32();
                    phi_1020_ = true;
                }
                let _e696 = phi_1019_;
                let _e698 = phi_1020_;
                if _e698 {
                    phi_1024_ = _e673;
                } else {
                    phi_1024_ = _e696;
                }
                let _e700 = phi_1024_;
                if (_e674 > -8388608f) {
                    let _e712 = f32(select(0i, select(select(i32(_e674), i32(-2147483648), (_e674 < bitcast<f32>(3472883712u))), 2147483647i, (_e674 > bitcast<f32>(1325400063u))), (_e674 == _e674)));
                    if (_e712 > _e674) {
                        phi_1044_ = 1f;
                    } else {
                        phi_1044_ = 0f;
                    }
                    let _e715 = phi_1044_;
                    if (_e674 < 8388608f) {
                        phi_1049_ = (_e712 - _e715);
                        phi_1050_ = false;
                    } else {
                        phi_1049_ = f32();
                        phi_1050_ = true;
                    }
                    let _e718 = phi_1049_;
                    let _e720 = phi_1050_;
                    phi_1051_ = _e718;
                    phi_1052_ = _e720;
                } else {
                    phi_1051_ = f32();
                    phi_1052_ = true;
                }
                let _e722 = phi_1051_;
                let _e724 = phi_1052_;
                if _e724 {
                    phi_1056_ = _e674;
                } else {
                    phi_1056_ = _e722;
                }
                let _e726 = phi_1056_;
                let _e727 = (_e673 - _e700);
                let _e728 = (_e674 - _e726);
                let _e737 = select(0i, select(select(i32(_e700), i32(-2147483648), (_e700 < bitcast<f32>(3472883712u))), 2147483647i, (_e700 > bitcast<f32>(1325400063u))), (_e700 == _e700));
                let _e746 = select(0i, select(select(i32(_e726), i32(-2147483648), (_e726 < bitcast<f32>(3472883712u))), 2147483647i, (_e726 > bitcast<f32>(1325400063u))), (_e726 == _e726));
                let _e749 = ((1f - _e727) * (1f - _e728));
                let _e751 = (_e727 * (1f - _e728));
                let _e753 = ((1f - _e727) * _e728);
                let _e754 = (_e727 * _e728);
                let _e756 = p.member.test;
                let _e757 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e756);
                let _e759 = p.member.map_size;
                let _e761 = local_3;
                local = _e757;
                let _e764 = ((_e761.level * _e759) * _e759);
                let _e766 = (bitcast<i32>(_e759) - 1i);
                if (_e737 > 0i) {
                    phi_1107_ = _e737;
                } else {
                    phi_1107_ = 0i;
                }
                let _e769 = phi_1107_;
                if (_e746 > 0i) {
                    phi_1112_ = _e746;
                } else {
                    phi_1112_ = 0i;
                }
                let _e772 = phi_1112_;
                if (_e769 < _e766) {
                    phi_1117_ = _e769;
                } else {
                    phi_1117_ = _e766;
                }
                let _e775 = phi_1117_;
                if (_e772 < _e766) {
                    phi_1122_ = _e772;
                } else {
                    phi_1122_ = _e766;
                }
                let _e778 = phi_1122_;
                let _e779 = bitcast<u32>(_e775);
                let _e781 = (_e737 + 1i);
                let _e782 = (_e746 + 1i);
                if (_e781 > 0i) {
                    phi_1131_ = _e781;
                } else {
                    phi_1131_ = 0i;
                }
                let _e785 = phi_1131_;
                if (_e782 > 0i) {
                    phi_1136_ = _e782;
                } else {
                    phi_1136_ = 0i;
                }
                let _e788 = phi_1136_;
                if (_e785 < _e766) {
                    phi_1141_ = _e785;
                } else {
                    phi_1141_ = _e766;
                }
                let _e791 = phi_1141_;
                if (_e788 < _e766) {
                    phi_1146_ = _e788;
                } else {
                    phi_1146_ = _e766;
                }
                let _e794 = phi_1146_;
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
                let _e868 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e810.x * _e749) + (_e822.x * _e751)) + (_e838.x * _e753)) + (_e854.x * _e754)), ((((_e810.y * _e749) + (_e822.y * _e751)) + (_e838.y * _e753)) + (_e854.y * _e754)), ((((_e810.z * _e749) + (_e822.z * _e751)) + (_e838.z * _e753)) + (_e854.z * _e754)), ((((_e810.w * _e749) + (_e822.w * _e751)) + (_e838.w * _e753)) + (_e854.w * _e754))), _e663);
                let _e870 = p.member.map_size;
                let _e872 = local_4;
                let _e875 = (bitcast<i32>(_e870) - 1i);
                if (_e737 > 0i) {
                    phi_1246_ = _e737;
                } else {
                    phi_1246_ = 0i;
                }
                let _e878 = phi_1246_;
                if (_e746 > 0i) {
                    phi_1251_ = _e746;
                } else {
                    phi_1251_ = 0i;
                }
                let _e881 = phi_1251_;
                if (_e878 < _e875) {
                    phi_1256_ = _e878;
                } else {
                    phi_1256_ = _e875;
                }
                let _e884 = phi_1256_;
                if (_e881 < _e875) {
                    phi_1261_ = _e881;
                } else {
                    phi_1261_ = _e875;
                }
                let _e887 = phi_1261_;
                let _e888 = bitcast<u32>(_e884);
                let _e895 = ((((_e872.level * _e870) + bitcast<u32>(_e887)) * (_e870 / 16u)) + (_e888 / 16u));
                let _e898 = (_e737 + 1i);
                let _e899 = (_e746 + 0i);
                let _e901 = (bitcast<i32>(_e870) - 1i);
                if (_e898 > 0i) {
                    phi_1280_ = _e898;
                } else {
                    phi_1280_ = 0i;
                }
                let _e904 = phi_1280_;
                if (_e899 > 0i) {
                    phi_1285_ = _e899;
                } else {
                    phi_1285_ = 0i;
                }
                let _e907 = phi_1285_;
                if (_e904 < _e901) {
                    phi_1290_ = _e904;
                } else {
                    phi_1290_ = _e901;
                }
                let _e910 = phi_1290_;
                if (_e907 < _e901) {
                    phi_1295_ = _e907;
                } else {
                    phi_1295_ = _e901;
                }
                let _e913 = phi_1295_;
                let _e914 = bitcast<u32>(_e910);
                let _e921 = ((((_e872.level * _e870) + bitcast<u32>(_e913)) * (_e870 / 16u)) + (_e914 / 16u));
                let _e924 = (_e737 + 0i);
                let _e925 = (_e746 + 1i);
                let _e927 = (bitcast<i32>(_e870) - 1i);
                if (_e924 > 0i) {
                    phi_1314_ = _e924;
                } else {
                    phi_1314_ = 0i;
                }
                let _e930 = phi_1314_;
                if (_e925 > 0i) {
                    phi_1319_ = _e925;
                } else {
                    phi_1319_ = 0i;
                }
                let _e933 = phi_1319_;
                if (_e930 < _e927) {
                    phi_1324_ = _e930;
                } else {
                    phi_1324_ = _e927;
                }
                let _e936 = phi_1324_;
                if (_e933 < _e927) {
                    phi_1329_ = _e933;
                } else {
                    phi_1329_ = _e927;
                }
                let _e939 = phi_1329_;
                let _e940 = bitcast<u32>(_e936);
                let _e947 = ((((_e872.level * _e870) + bitcast<u32>(_e939)) * (_e870 / 16u)) + (_e940 / 16u));
                let _e950 = (_e737 + 1i);
                let _e951 = (_e746 + 1i);
                let _e953 = (bitcast<i32>(_e870) - 1i);
                if (_e950 > 0i) {
                    phi_1348_ = _e950;
                } else {
                    phi_1348_ = 0i;
                }
                let _e956 = phi_1348_;
                if (_e951 > 0i) {
                    phi_1353_ = _e951;
                } else {
                    phi_1353_ = 0i;
                }
                let _e959 = phi_1353_;
                if (_e956 < _e953) {
                    phi_1358_ = _e956;
                } else {
                    phi_1358_ = _e953;
                }
                let _e962 = phi_1358_;
                if (_e959 < _e953) {
                    phi_1363_ = _e959;
                } else {
                    phi_1363_ = _e953;
                }
                let _e965 = phi_1363_;
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
                    phi_1441_ = true;
                } else {
                    phi_1441_ = (_e868 >= (1f - _e1012));
                }
                let _e1017 = phi_1441_;
                if ((bitcast<u32>(_e868) & 2147483647u) > 2139095040u) {
                    phi_1449_ = true;
                } else {
                    phi_1449_ = !(_e1017);
                }
                let _e1023 = phi_1449_;
                if _e1023 {
                    if (_e868 > 0f) {
                        if (_e868 < 1f) {
                            phi_1461_ = false;
                        } else {
                            phi_1461_ = true;
                        }
                        let _e1027 = phi_1461_;
                        phi_1462_ = _e1027;
                    } else {
                        phi_1462_ = true;
                    }
                    let _e1029 = phi_1462_;
                    if _e1029 {
                        phi_1466_ = 0.5f;
                    } else {
                        phi_1466_ = _e868;
                    }
                    let _e1031 = phi_1466_;
                    phi_1474_ = evaluate_Verdict(_e1031, true);
                } else {
                    if (_e868 > 0.5f) {
                        phi_1472_ = 1f;
                    } else {
                        phi_1472_ = 0f;
                    }
                    let _e1035 = phi_1472_;
                    phi_1474_ = evaluate_Verdict(_e1035, false);
                }
                let _e1038 = phi_1474_;
                let _e1041 = (_e1038.visibility < 0.5f);
                if _e1038.is_doubted {
                    phi_1497_ = evaluate_Verdict();
                    phi_1498_ = true;
                } else {
                    if _e1041 {
                        phi_1484_ = 2u;
                    } else {
                        phi_1484_ = 1u;
                    }
                    let _e1043 = phi_1484_;
                    if ((((((_e979 >> bitcast<u32>((((_e888 % 16u) * 2u) & 31u))) & 3u) | ((_e987 >> bitcast<u32>((((_e914 % 16u) * 2u) & 31u))) & 3u)) | (((_e996 >> bitcast<u32>((((_e940 % 16u) * 2u) & 31u))) & 3u) | ((_e1004 >> bitcast<u32>((((_e966 % 16u) * 2u) & 31u))) & 3u))) & _e1043) != 0u) {
                        if _e1041 {
                            phi_1493_ = 0.000000059604645f;
                        } else {
                            phi_1493_ = 0.99999994f;
                        }
                        let _e1047 = phi_1493_;
                        phi_1495_ = evaluate_Verdict(_e1047, true);
                        phi_1496_ = false;
                    } else {
                        phi_1495_ = evaluate_Verdict();
                        phi_1496_ = true;
                    }
                    let _e1050 = phi_1495_;
                    let _e1052 = phi_1496_;
                    phi_1497_ = _e1050;
                    phi_1498_ = _e1052;
                }
                let _e1054 = phi_1497_;
                let _e1056 = phi_1498_;
                if _e1056 {
                    phi_1503_ = evaluate_Verdict(_e1038.visibility, _e1038.is_doubted);
                } else {
                    phi_1503_ = _e1054;
                }
                let _e1059 = phi_1503_;
                phi_1508_ = evaluate_Verdict(_e1059.visibility, _e1059.is_doubted);
            } else {
                phi_1508_ = evaluate_Verdict(0.5f, true);
            }
            let _e1065 = phi_1508_;
            phi_1509_ = _e1065;
        }
        let _e1067 = phi_1509_;
        if (_e69.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e69.first_primitive)] = _e1067.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_prefiltered_levels_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
