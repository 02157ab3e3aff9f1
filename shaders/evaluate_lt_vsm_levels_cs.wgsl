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
    var phi_143_: lt_bvh_traverse_Tree;
    var phi_144_: bool;
    var phi_145_: lt_bvh_traverse_Tree;
    var phi_146_: bool;
    var phi_151_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_143_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_144_ = false;
        } else {
            phi_143_ = lt_bvh_traverse_Tree();
            phi_144_ = true;
        }
        let _e51 = phi_143_;
        let _e53 = phi_144_;
        phi_145_ = _e51;
        phi_146_ = _e53;
    } else {
        phi_145_ = lt_bvh_traverse_Tree();
        phi_146_ = true;
    }
    let _e55 = phi_145_;
    let _e57 = phi_146_;
    if _e57 {
        phi_151_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_151_ = _e55;
    }
    let _e62 = phi_151_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_177_: f32;
    var phi_178_: f32;
    var phi_179_: f32;
    var phi_195_: f32;
    var phi_196_: f32;
    var phi_197_: f32;
    var phi_213_: f32;
    var phi_214_: f32;
    var phi_215_: f32;
    var phi_231_: f32;
    var phi_232_: f32;
    var phi_233_: f32;
    var phi_249_: f32;
    var phi_250_: f32;
    var phi_251_: f32;
    var phi_297_: bool;
    var phi_301_: f32;
    var phi_313_: bool;
    var phi_320_: f32;
    var phi_335_: f32;
    var phi_336_: f32;
    var phi_337_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_179_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_178_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_177_ = 1f;
            } else {
                phi_177_ = param_7;
            }
            let _e48 = phi_177_;
            phi_178_ = _e48;
        }
        let _e50 = phi_178_;
        phi_179_ = _e50;
    }
    let _e52 = phi_179_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_197_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_196_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_195_ = 1f;
            } else {
                phi_195_ = param_5.x;
            }
            let _e60 = phi_195_;
            phi_196_ = _e60;
        }
        let _e62 = phi_196_;
        phi_197_ = _e62;
    }
    let _e64 = phi_197_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_215_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_214_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_213_ = 1f;
            } else {
                phi_213_ = param_5.y;
            }
            let _e72 = phi_213_;
            phi_214_ = _e72;
        }
        let _e74 = phi_214_;
        phi_215_ = _e74;
    }
    let _e76 = phi_215_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_233_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_232_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_231_ = 1f;
            } else {
                phi_231_ = param_5.z;
            }
            let _e84 = phi_231_;
            phi_232_ = _e84;
        }
        let _e86 = phi_232_;
        phi_233_ = _e86;
    }
    let _e88 = phi_233_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_251_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_250_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_249_ = 1f;
            } else {
                phi_249_ = param_5.w;
            }
            let _e96 = phi_249_;
            phi_250_ = _e96;
        }
        let _e98 = phi_250_;
        phi_251_ = _e98;
    }
    let _e100 = phi_251_;
    let _e101 = (_e64 - _e52);
    let _e102 = (_e76 - _e52);
    let _e103 = (_e88 - _e52);
    let _e104 = (_e100 - _e52);
    let _e105 = (*param_4);
    let _e116 = ((((_e101 * param_6.x) + (_e102 * param_6.y)) + (_e103 * param_6.z)) + (_e104 * param_6.w));
    let _e117 = (_e101 - _e116);
    let _e118 = (_e102 - _e116);
    let _e119 = (_e103 - _e116);
    let _e120 = (_e104 - _e116);
    let _e135 = (((((_e117 * _e117) * param_6.x) + ((_e118 * _e118) * param_6.y)) + ((_e119 * _e119) * param_6.z)) + ((_e120 * _e120) * param_6.w));
    if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
        phi_297_ = true;
    } else {
        let _e139 = (_e105 > _e135);
        if _e139 {
        }
        phi_297_ = _e139;
    }
    let _e141 = phi_297_;
    if _e141 {
        phi_301_ = _e105;
    } else {
        phi_301_ = _e135;
    }
    let _e143 = phi_301_;
    let _e144 = -(_e116);
    if (_e144 <= 0f) {
        let _e148 = ((bitcast<u32>(_e143) & 2147483647u) > 2139095040u);
        if _e148 {
        }
        phi_313_ = _e148;
    } else {
        phi_313_ = true;
    }
    let _e150 = phi_313_;
    if _e150 {
        phi_320_ = (_e143 / (_e143 + (_e144 * _e144)));
    } else {
        phi_320_ = 1f;
    }
    let _e155 = phi_320_;
    if ((bitcast<u32>(_e155) & 2147483647u) > 2139095040u) {
        phi_337_ = _e155;
    } else {
        if (_e155 < 0f) {
            phi_336_ = 0f;
        } else {
            if (_e155 > 1f) {
                phi_335_ = 1f;
            } else {
                phi_335_ = _e155;
            }
            let _e162 = phi_335_;
            phi_336_ = _e162;
        }
        let _e164 = phi_336_;
        phi_337_ = _e164;
    }
    let _e166 = phi_337_;
    return _e166;
}

fn function_() {
    var local: f32;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_404_: bool;
    var phi_474_: bool;
    var phi_475_: bool;
    var phi_486_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_487_: bool;
    var phi_488_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_489_: bool;
    var phi_496_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_500_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_520_: lt_math_LightPoint;
    var phi_523_: u32;
    var phi_525_: lt_math_LevelPoint;
    var phi_611_: bool;
    var phi_620_: bool;
    var phi_629_: bool;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_633_: bool;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_639_: bool;
    var phi_666_: bool;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_677_: bool;
    var phi_686_: lt_math_LightPoint;
    var phi_687_: u32;
    var phi_688_: lt_math_LevelPoint;
    var phi_689_: bool;
    var phi_521_: lt_math_LightPoint;
    var phi_524_: u32;
    var phi_526_: lt_math_LevelPoint;
    var phi_690_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_737_: bool;
    var phi_819_: f32;
    var phi_935_: f32;
    var phi_936_: f32;
    var phi_939_: f32;
    var phi_968_: f32;
    var phi_973_: f32;
    var phi_974_: bool;
    var phi_975_: f32;
    var phi_976_: bool;
    var phi_980_: f32;
    var phi_1000_: f32;
    var phi_1005_: f32;
    var phi_1006_: bool;
    var phi_1007_: f32;
    var phi_1008_: bool;
    var phi_1012_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1061_: i32;
    var phi_1066_: i32;
    var phi_1071_: i32;
    var phi_1076_: i32;
    var phi_1085_: i32;
    var phi_1090_: i32;
    var phi_1095_: i32;
    var phi_1100_: i32;
    var phi_1151_: bool;
    var phi_1159_: bool;
    var phi_1171_: bool;
    var phi_1172_: bool;
    var phi_1176_: f32;
    var phi_1182_: f32;
    var phi_1184_: evaluate_Verdict;
    var phi_1189_: evaluate_Verdict;
    var phi_1190_: evaluate_Verdict;

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
                phi_397_ = (_e81 == _e83);
                phi_398_ = false;
            } else {
                phi_397_ = bool();
                phi_398_ = true;
            }
            let _e86 = phi_397_;
            let _e88 = phi_398_;
            phi_399_ = _e86;
            phi_400_ = _e88;
        } else {
            phi_399_ = bool();
            phi_400_ = true;
        }
        let _e90 = phi_399_;
        let _e92 = phi_400_;
        if _e92 {
            phi_404_ = false;
        } else {
            phi_404_ = _e90;
        }
        let _e94 = phi_404_;
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
                    phi_475_ = true;
                } else {
                    let _e147 = p.member.light.range_squared;
                    if (_e130 <= _e147) {
                        let _e150 = p.member.light.cos_outer;
                        phi_474_ = (-((((_e112 * _e132.x) + (_e113 * _e132.y)) + (_e114 * _e132.z))) >= (_e150 * sqrt(_e130)));
                    } else {
                        phi_474_ = false;
                    }
                    let _e155 = phi_474_;
                    phi_475_ = _e155;
                }
                let _e157 = phi_475_;
                if _e157 {
                    let _e159 = samples.member[(0u + _e58.first_primitive)].flags;
                    let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
                    phi_486_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, ((_e159 & 1u) == 0u));
                    phi_487_ = false;
                } else {
                    phi_486_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_487_ = true;
                }
                let _e178 = phi_486_;
                let _e180 = phi_487_;
                phi_488_ = _e178;
                phi_489_ = _e180;
            } else {
                phi_488_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_489_ = true;
            }
            let _e182 = phi_488_;
            let _e184 = phi_489_;
            if _e184 {
                let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e190.unnamed.visibility, false), _e190.unnamed_1);
                phi_496_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e196.unnamed, true);
            } else {
                phi_496_ = _e182;
            }
            let _e201 = phi_496_;
            phi_500_ = _e201;
        } else {
            let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e207.unnamed.visibility, false), _e207.unnamed_1);
            phi_500_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e213.unnamed, true);
        }
        let _e218 = phi_500_;
        if _e218.unnamed_1 {
            phi_1190_ = evaluate_Verdict(_e218.unnamed.visibility, _e218.unnamed.is_doubted);
        } else {
            let _e226 = samples.member[(0u + _e58.first_primitive)].position;
            let _e228 = p.member.map_size;
            let _e230 = (0.5f / f32(_e228));
            let _e237 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e244 = lt_math_LightPoint(vec2<f32>(_e237.uv.x, 0f), _e237.depth, _e237.is_inside);
            let _e248 = lt_math_LightPoint(_e244.uv, 0f, _e244.is_inside);
            phi_520_ = lt_math_LightPoint();
            phi_523_ = 0u;
            phi_525_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e248.uv, _e248.depth, false));
            loop {
                let _e255 = phi_520_;
                let _e257 = phi_523_;
                let _e259 = phi_525_;
                local_1 = _e259;
                local_2 = _e259;
                local_3 = _e259;
                if (_e257 < _e64) {
                    if _e259.point.is_inside {
                        phi_686_ = lt_math_LightPoint();
                        phi_687_ = u32();
                        phi_688_ = lt_math_LevelPoint();
                        phi_689_ = false;
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
                                phi_611_ = (_e295 <= 1f);
                            } else {
                                phi_611_ = false;
                            }
                            let _e327 = phi_611_;
                            if _e327 {
                                if (_e309 >= 0f) {
                                    phi_620_ = (_e309 <= 1f);
                                } else {
                                    phi_620_ = false;
                                }
                                let _e331 = phi_620_;
                                if _e331 {
                                    if (_e322 >= 0f) {
                                        phi_629_ = (_e322 <= 1f);
                                    } else {
                                        phi_629_ = false;
                                    }
                                    let _e335 = phi_629_;
                                    phi_630_ = _e335;
                                    phi_631_ = false;
                                } else {
                                    phi_630_ = bool();
                                    phi_631_ = true;
                                }
                                let _e337 = phi_630_;
                                let _e339 = phi_631_;
                                phi_632_ = _e337;
                                phi_633_ = _e339;
                            } else {
                                phi_632_ = bool();
                                phi_633_ = true;
                            }
                            let _e341 = phi_632_;
                            let _e343 = phi_633_;
                            phi_634_ = _e341;
                            phi_635_ = _e343;
                        } else {
                            phi_634_ = bool();
                            phi_635_ = true;
                        }
                        let _e345 = phi_634_;
                        let _e347 = phi_635_;
                        if _e347 {
                            phi_639_ = false;
                        } else {
                            phi_639_ = _e345;
                        }
                        let _e349 = phi_639_;
                        if _e349 {
                            if (_e295 >= _e230) {
                                if (_e295 <= (1f - _e230)) {
                                    if (_e309 >= _e230) {
                                        phi_666_ = (_e309 <= (1f - _e230));
                                        phi_667_ = false;
                                    } else {
                                        phi_666_ = bool();
                                        phi_667_ = true;
                                    }
                                    let _e357 = phi_666_;
                                    let _e359 = phi_667_;
                                    phi_668_ = _e357;
                                    phi_669_ = _e359;
                                } else {
                                    phi_668_ = bool();
                                    phi_669_ = true;
                                }
                                let _e361 = phi_668_;
                                let _e363 = phi_669_;
                                phi_670_ = _e361;
                                phi_671_ = _e363;
                            } else {
                                phi_670_ = bool();
                                phi_671_ = true;
                            }
                            let _e365 = phi_670_;
                            let _e367 = phi_671_;
                            phi_672_ = _e365;
                            phi_673_ = _e367;
                        } else {
                            phi_672_ = bool();
                            phi_673_ = true;
                        }
                        let _e369 = phi_672_;
                        let _e371 = phi_673_;
                        if _e371 {
                            phi_677_ = false;
                        } else {
                            phi_677_ = _e369;
                        }
                        let _e373 = phi_677_;
                        let _e380 = lt_math_LightPoint(vec2<f32>(_e295, _e255.uv.y), _e255.depth, _e255.is_inside);
                        let _e387 = lt_math_LightPoint(vec2<f32>(_e380.uv.x, _e309), _e380.depth, _e380.is_inside);
                        let _e391 = lt_math_LightPoint(_e387.uv, _e322, _e387.is_inside);
                        let _e395 = lt_math_LightPoint(_e391.uv, _e391.depth, _e373);
                        phi_686_ = _e395;
                        phi_687_ = (_e257 + 1u);
                        phi_688_ = lt_math_LevelPoint(_e257, _e395);
                        phi_689_ = true;
                    }
                    let _e399 = phi_686_;
                    let _e401 = phi_687_;
                    let _e403 = phi_688_;
                    let _e405 = phi_689_;
                    phi_521_ = _e399;
                    phi_524_ = _e401;
                    phi_526_ = _e403;
                    phi_690_ = _e405;
                } else {
                    phi_521_ = lt_math_LightPoint();
                    phi_524_ = u32();
                    phi_526_ = lt_math_LevelPoint();
                    phi_690_ = false;
                }
                let _e407 = phi_521_;
                let _e409 = phi_524_;
                let _e411 = phi_526_;
                let _e413 = phi_690_;
                continue;
                continuing {
                    phi_520_ = _e407;
                    phi_523_ = _e409;
                    phi_525_ = _e411;
                    break if !(_e413);
                }
            }
            let _e416 = local_1;
            if _e416.point.is_inside {
                if (0f > 0f) {
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
                            phi_730_ = (_e427.row_w.z == _e439);
                            phi_731_ = false;
                        } else {
                            phi_730_ = bool();
                            phi_731_ = true;
                        }
                        let _e442 = phi_730_;
                        let _e444 = phi_731_;
                        phi_732_ = _e442;
                        phi_733_ = _e444;
                    } else {
                        phi_732_ = bool();
                        phi_733_ = true;
                    }
                    let _e446 = phi_732_;
                    let _e448 = phi_733_;
                    if _e448 {
                        phi_737_ = false;
                    } else {
                        phi_737_ = _e446;
                    }
                    let _e450 = phi_737_;
                    if _e450 {
                        let _e452 = samples.member[(0u + _e58.first_primitive)].normal;
                        let _e454 = p.member.map_size;
                        let _e524 = ((abs(((((_e427.row_x.x * _e452.x) + (_e427.row_x.y * _e452.y)) + (_e427.row_x.z * _e452.z)) / (((_e427.row_x.x * _e427.row_x.x) + (_e427.row_x.y * _e427.row_x.y)) + (_e427.row_x.z * _e427.row_x.z)))) + abs(((((_e427.row_y.x * _e452.x) + (_e427.row_y.y * _e452.y)) + (_e427.row_y.z * _e452.z)) / (((_e427.row_y.x * _e427.row_y.x) + (_e427.row_y.y * _e427.row_y.y)) + (_e427.row_y.z * _e427.row_y.z))))) / (abs(((((_e427.row_z.x * _e452.x) + (_e427.row_z.y * _e452.y)) + (_e427.row_z.z * _e452.z)) / (((_e427.row_z.x * _e427.row_z.x) + (_e427.row_z.y * _e427.row_z.y)) + (_e427.row_z.z * _e427.row_z.z)))) * f32(_e454)));
                        if (_e524 < 0.002f) {
                            phi_819_ = _e524;
                        } else {
                            phi_819_ = 0.002f;
                        }
                        let _e527 = phi_819_;
                        phi_936_ = _e527;
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
                            phi_935_ = _e641;
                        } else {
                            phi_935_ = 0.002f;
                        }
                        let _e644 = phi_935_;
                        phi_936_ = _e644;
                    }
                    let _e646 = phi_936_;
                    phi_939_ = (_e416.point.depth - (0f * _e646));
                } else {
                    phi_939_ = _e416.point.depth;
                }
                let _e650 = phi_939_;
                let _e656 = p.member.map_size;
                let _e657 = f32(_e656);
                let _e660 = ((_e416.point.uv.x * _e657) - 0.5f);
                let _e661 = ((_e416.point.uv.y * _e657) - 0.5f);
                if (_e660 > -8388608f) {
                    let _e673 = f32(select(0i, select(select(i32(_e660), i32(-2147483648), (_e660 < bitcast<f32>(3472883712u))), 2147483647i, (_e660 > bitcast<f32>(1325400063u))), (_e660 == _e660)));
                    if (_e673 > _e660) {
                        phi_968_ = 1f;
                    } else {
                        phi_968_ = 0f;
                    }
                    let _e676 = phi_968_;
                    if (_e660 < 8388608f) {
                        phi_973_ = (_e673 - _e676);
                        phi_974_ = false;
                    } else {
                        phi_973_ = f32();
                        phi_974_ = true;
                    }
                    let _e679 = phi_973_;
                    let _e681 = phi_974_;
                    phi_975_ = _e679;
                    phi_976_ = _e681;
                } else {
                    phi_975_ = f32();
                    phi_976_ = true;
                }
                let _e683 = phi_975_;
                let _e685 = phi_976_;
                if _e685 {
                    phi_980_ = _e660;
                } else {
                    phi_980_ = _e683;
                }
                let _e687 = phi_980_;
                if (_e661 > -8388608f) {
                    let _e699 = f32(select(0i, select(select(i32(_e661), i32(-2147483648), (_e661 < bitcast<f32>(3472883712u))), 2147483647i, (_e661 > bitcast<f32>(1325400063u))), (_e661 == _e661)));
                    if (_e699 > _e661) {
                        phi_1000_ = 1f;
                    } else {
                        phi_1000_ = 0f;
                    }
                    let _e702 = phi_1000_;
                    if (_e661 < 8388608f) {
                        phi_1005_ = (_e699 - _e702);
                        phi_1006_ = false;
                    } else {
                        phi_1005_ = f32();
                        phi_1006_ = true;
                    }
                    let _e705 = phi_1005_;
                    let _e707 = phi_1006_;
                    phi_1007_ = _e705;
                    phi_1008_ = _e707;
                } else {
                    phi_1007_ = f32();
                    phi_1008_ = true;
                }
                let _e709 = phi_1007_;
                let _e711 = phi_1008_;
                if _e711 {
                    phi_1012_ = _e661;
                } else {
                    phi_1012_ = _e709;
                }
                let _e713 = phi_1012_;
                let _e714 = (_e660 - _e687);
                let _e715 = (_e661 - _e713);
                let _e724 = select(0i, select(select(i32(_e687), i32(-2147483648), (_e687 < bitcast<f32>(3472883712u))), 2147483647i, (_e687 > bitcast<f32>(1325400063u))), (_e687 == _e687));
                let _e733 = select(0i, select(select(i32(_e713), i32(-2147483648), (_e713 < bitcast<f32>(3472883712u))), 2147483647i, (_e713 > bitcast<f32>(1325400063u))), (_e713 == _e713));
                let _e744 = p.member.test;
                let _e745 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e744);
                let _e747 = p.member.map_size;
                let _e749 = local_3;
                local = _e745;
                let _e752 = ((_e749.level * _e747) * _e747);
                let _e754 = (bitcast<i32>(_e747) - 1i);
                if (_e724 > 0i) {
                    phi_1061_ = _e724;
                } else {
                    phi_1061_ = 0i;
                }
                let _e757 = phi_1061_;
                if (_e733 > 0i) {
                    phi_1066_ = _e733;
                } else {
                    phi_1066_ = 0i;
                }
                let _e760 = phi_1066_;
                if (_e757 < _e754) {
                    phi_1071_ = _e757;
                } else {
                    phi_1071_ = _e754;
                }
                let _e763 = phi_1071_;
                if (_e760 < _e754) {
                    phi_1076_ = _e760;
                } else {
                    phi_1076_ = _e754;
                }
                let _e766 = phi_1076_;
                let _e767 = bitcast<u32>(_e763);
                let _e769 = (_e724 + 1i);
                let _e770 = (_e733 + 1i);
                if (_e769 > 0i) {
                    phi_1085_ = _e769;
                } else {
                    phi_1085_ = 0i;
                }
                let _e773 = phi_1085_;
                if (_e770 > 0i) {
                    phi_1090_ = _e770;
                } else {
                    phi_1090_ = 0i;
                }
                let _e776 = phi_1090_;
                if (_e773 < _e754) {
                    phi_1095_ = _e773;
                } else {
                    phi_1095_ = _e754;
                }
                let _e779 = phi_1095_;
                if (_e776 < _e754) {
                    phi_1100_ = _e776;
                } else {
                    phi_1100_ = _e754;
                }
                let _e782 = phi_1100_;
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
                let _e812 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e798, _e802, _e806, _e810), vec4<f32>(((1f - _e714) * (1f - _e715)), (_e714 * (1f - _e715)), ((1f - _e714) * _e715), (_e714 * _e715)), _e650);
                let _e814 = p.member.epsilon;
                if (_e812 <= _e814) {
                    phi_1151_ = true;
                } else {
                    phi_1151_ = (_e812 >= (1f - _e814));
                }
                let _e819 = phi_1151_;
                if ((bitcast<u32>(_e812) & 2147483647u) > 2139095040u) {
                    phi_1159_ = true;
                } else {
                    phi_1159_ = !(_e819);
                }
                let _e825 = phi_1159_;
                if _e825 {
                    if (_e812 > 0f) {
                        if (_e812 < 1f) {
                            phi_1171_ = false;
                        } else {
                            phi_1171_ = true;
                        }
                        let _e829 = phi_1171_;
                        phi_1172_ = _e829;
                    } else {
                        phi_1172_ = true;
                    }
                    let _e831 = phi_1172_;
                    if _e831 {
                        phi_1176_ = 0.5f;
                    } else {
                        phi_1176_ = _e812;
                    }
                    let _e833 = phi_1176_;
                    phi_1184_ = evaluate_Verdict(_e833, true);
                } else {
                    if (_e812 > 0.5f) {
                        phi_1182_ = 1f;
                    } else {
                        phi_1182_ = 0f;
                    }
                    let _e837 = phi_1182_;
                    phi_1184_ = evaluate_Verdict(_e837, false);
                }
                let _e840 = phi_1184_;
                phi_1189_ = evaluate_Verdict(_e840.visibility, _e840.is_doubted);
            } else {
                phi_1189_ = evaluate_Verdict(0.5f, true);
            }
            let _e846 = phi_1189_;
            phi_1190_ = _e846;
        }
        let _e848 = phi_1190_;
        if (_e58.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e58.first_primitive)] = _e848.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_vsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
