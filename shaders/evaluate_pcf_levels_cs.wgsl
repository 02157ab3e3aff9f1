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
    fade_uv: f32,
    pad0_: u32,
}

struct type_32 {
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
var<uniform> p: type_32;
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
        let _e52 = phi_144_;
        let _e54 = phi_145_;
        phi_146_ = _e52;
        phi_147_ = _e54;
    } else {
        phi_146_ = lt_bvh_traverse_Tree();
        phi_147_ = true;
    }
    let _e56 = phi_146_;
    let _e58 = phi_147_;
    if _e58 {
        phi_152_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_152_ = _e56;
    }
    let _e63 = phi_152_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_179_: f32;
    var phi_180_: f32;
    var phi_181_: f32;
    var phi_197_: f32;
    var phi_198_: f32;
    var phi_199_: f32;
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_217_: f32;
    var phi_233_: f32;
    var phi_234_: f32;
    var phi_235_: f32;
    var phi_255_: f32;
    var phi_256_: f32;
    var phi_257_: f32;
    var phi_274_: f32;
    var phi_275_: f32;
    var phi_276_: f32;
    var phi_293_: f32;
    var phi_294_: f32;
    var phi_295_: f32;
    var phi_312_: f32;
    var phi_313_: f32;
    var phi_314_: f32;
    var phi_331_: f32;
    var phi_332_: f32;
    var phi_333_: f32;
    var phi_359_: f32;
    var phi_360_: f32;
    var phi_361_: f32;

    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_181_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_180_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_179_ = 1f;
            } else {
                phi_179_ = param_5.x;
            }
            let _e50 = phi_179_;
            phi_180_ = _e50;
        }
        let _e52 = phi_180_;
        phi_181_ = _e52;
    }
    let _e54 = phi_181_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_199_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_198_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_197_ = 1f;
            } else {
                phi_197_ = param_5.y;
            }
            let _e62 = phi_197_;
            phi_198_ = _e62;
        }
        let _e64 = phi_198_;
        phi_199_ = _e64;
    }
    let _e66 = phi_199_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_217_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_216_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_215_ = 1f;
            } else {
                phi_215_ = param_5.z;
            }
            let _e74 = phi_215_;
            phi_216_ = _e74;
        }
        let _e76 = phi_216_;
        phi_217_ = _e76;
    }
    let _e78 = phi_217_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_235_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_234_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_233_ = 1f;
            } else {
                phi_233_ = param_5.w;
            }
            let _e86 = phi_233_;
            phi_234_ = _e86;
        }
        let _e88 = phi_234_;
        phi_235_ = _e88;
    }
    let _e90 = phi_235_;
    let _e91 = (*param_4);
    let _e92 = (_e54 + _e91);
    let _e93 = (_e66 + _e91);
    let _e94 = (_e78 + _e91);
    let _e95 = (_e90 + _e91);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_257_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_256_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_255_ = 1f;
            } else {
                phi_255_ = param_7;
            }
            let _e102 = phi_255_;
            phi_256_ = _e102;
        }
        let _e104 = phi_256_;
        phi_257_ = _e104;
    }
    let _e106 = phi_257_;
    if ((bitcast<u32>(_e92) & 2147483647u) > 2139095040u) {
        phi_276_ = _e92;
    } else {
        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
            phi_275_ = _e106;
        } else {
            if (_e92 < _e106) {
                phi_274_ = 0f;
            } else {
                phi_274_ = 1f;
            }
            let _e115 = phi_274_;
            phi_275_ = _e115;
        }
        let _e117 = phi_275_;
        phi_276_ = _e117;
    }
    let _e119 = phi_276_;
    if ((bitcast<u32>(_e93) & 2147483647u) > 2139095040u) {
        phi_295_ = _e93;
    } else {
        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
            phi_294_ = _e106;
        } else {
            if (_e93 < _e106) {
                phi_293_ = 0f;
            } else {
                phi_293_ = 1f;
            }
            let _e128 = phi_293_;
            phi_294_ = _e128;
        }
        let _e130 = phi_294_;
        phi_295_ = _e130;
    }
    let _e132 = phi_295_;
    if ((bitcast<u32>(_e94) & 2147483647u) > 2139095040u) {
        phi_314_ = _e94;
    } else {
        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
            phi_313_ = _e106;
        } else {
            if (_e94 < _e106) {
                phi_312_ = 0f;
            } else {
                phi_312_ = 1f;
            }
            let _e141 = phi_312_;
            phi_313_ = _e141;
        }
        let _e143 = phi_313_;
        phi_314_ = _e143;
    }
    let _e145 = phi_314_;
    if ((bitcast<u32>(_e95) & 2147483647u) > 2139095040u) {
        phi_333_ = _e95;
    } else {
        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
            phi_332_ = _e106;
        } else {
            if (_e95 < _e106) {
                phi_331_ = 0f;
            } else {
                phi_331_ = 1f;
            }
            let _e154 = phi_331_;
            phi_332_ = _e154;
        }
        let _e156 = phi_332_;
        phi_333_ = _e156;
    }
    let _e158 = phi_333_;
    let _e169 = ((((_e119 * param_6.x) + (_e132 * param_6.y)) + (_e145 * param_6.z)) + (_e158 * param_6.w));
    if ((bitcast<u32>(_e169) & 2147483647u) > 2139095040u) {
        phi_361_ = _e169;
    } else {
        if (_e169 < 0f) {
            phi_360_ = 0f;
        } else {
            if (_e169 > 1f) {
                phi_359_ = 1f;
            } else {
                phi_359_ = _e169;
            }
            let _e176 = phi_359_;
            phi_360_ = _e176;
        }
        let _e178 = phi_360_;
        phi_361_ = _e178;
    }
    let _e180 = phi_361_;
    return _e180;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_8: f32, param_9: f32) -> f32 {
    var phi_369_: f32;

    if (param_8 < param_9) {
        phi_369_ = param_8;
    } else {
        phi_369_ = param_9;
    }
    let _e43 = phi_369_;
    return _e43;
}

fn function_() {
    var local: f32;
    var phi_429_: bool;
    var phi_430_: bool;
    var phi_431_: bool;
    var phi_432_: bool;
    var phi_436_: bool;
    var phi_506_: bool;
    var phi_507_: bool;
    var phi_518_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_519_: bool;
    var phi_520_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_521_: bool;
    var phi_528_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_532_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_552_: lt_math_LightPoint;
    var phi_555_: u32;
    var phi_557_: lt_math_LevelPoint;
    var phi_643_: bool;
    var phi_652_: bool;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_667_: bool;
    var phi_671_: bool;
    var phi_698_: bool;
    var phi_699_: bool;
    var phi_700_: bool;
    var phi_701_: bool;
    var phi_702_: bool;
    var phi_703_: bool;
    var phi_704_: bool;
    var phi_705_: bool;
    var phi_709_: bool;
    var phi_718_: lt_math_LightPoint;
    var phi_719_: u32;
    var phi_720_: lt_math_LevelPoint;
    var phi_721_: bool;
    var phi_553_: lt_math_LightPoint;
    var phi_556_: u32;
    var phi_558_: lt_math_LevelPoint;
    var phi_722_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_762_: bool;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_769_: bool;
    var phi_851_: f32;
    var phi_967_: f32;
    var phi_968_: f32;
    var phi_971_: f32;
    var phi_1000_: f32;
    var phi_1005_: f32;
    var phi_1006_: bool;
    var phi_1007_: f32;
    var phi_1008_: bool;
    var phi_1012_: f32;
    var phi_1032_: f32;
    var phi_1037_: f32;
    var phi_1038_: bool;
    var phi_1039_: f32;
    var phi_1040_: bool;
    var phi_1044_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1093_: i32;
    var phi_1098_: i32;
    var phi_1103_: i32;
    var phi_1108_: i32;
    var phi_1117_: i32;
    var phi_1122_: i32;
    var phi_1127_: i32;
    var phi_1132_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1204_: f32;
    var phi_1206_: evaluate_Verdict;
    var phi_1207_: bool;
    var phi_1208_: evaluate_Verdict;
    var phi_1209_: bool;
    var phi_1214_: evaluate_Verdict;
    var phi_1215_: bool;
    var phi_1217_: evaluate_Verdict;
    var phi_1218_: evaluate_Verdict;
    var phi_1219_: bool;
    var phi_1223_: evaluate_Verdict;
    var phi_1224_: evaluate_Verdict;
    var phi_1225_: bool;
    var phi_1229_: evaluate_Verdict;

    let _e40 = id_1;
    let _e47 = arrayLength((&map.member));
    let _e53 = arrayLength((&levels.member));
    let _e56 = p.member.size[0u];
    let _e58 = p.member.size[1u];
    let _e59 = lt_shaders_entry_pixel_index(_e40, _e56, _e58);
    if (bitcast<i32>(_e59.root) != 0i) {
        let _e65 = p.member.level_count;
        if (_e59.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e72 = samples.member[(0u + _e59.first_primitive)].normal[0u];
        let _e74 = global[0u];
        if (_e72 == _e74) {
            let _e77 = samples.member[(0u + _e59.first_primitive)].normal[1u];
            let _e79 = global[1u];
            if (_e77 == _e79) {
                let _e82 = samples.member[(0u + _e59.first_primitive)].normal[2u];
                let _e84 = global[2u];
                phi_429_ = (_e82 == _e84);
                phi_430_ = false;
            } else {
                phi_429_ = bool();
                phi_430_ = true;
            }
            let _e87 = phi_429_;
            let _e89 = phi_430_;
            phi_431_ = _e87;
            phi_432_ = _e89;
        } else {
            phi_431_ = bool();
            phi_432_ = true;
        }
        let _e91 = phi_431_;
        let _e93 = phi_432_;
        if _e93 {
            phi_436_ = false;
        } else {
            phi_436_ = _e91;
        }
        let _e95 = phi_436_;
        if !(_e95) {
            let _e98 = samples.member[(0u + _e59.first_primitive)].position;
            let _e100 = p.member.light.place;
            let _e106 = p.member.light.place[3u];
            let _e113 = (_e100.x - (_e98.x * _e106));
            let _e114 = (_e100.y - (_e98.y * _e106));
            let _e115 = (_e100.z - (_e98.z * _e106));
            let _e117 = samples.member[(0u + _e59.first_primitive)].normal;
            if ((((_e117.x * _e113) + (_e117.y * _e114)) + (_e117.z * _e115)) > 0f) {
                let _e131 = (((_e113 * _e113) + (_e114 * _e114)) + (_e115 * _e115));
                let _e133 = p.member.light.axis;
                let _e145 = p.member.light.place[3u];
                if (_e145 == 0f) {
                    phi_507_ = true;
                } else {
                    let _e148 = p.member.light.range_squared;
                    if (_e131 <= _e148) {
                        let _e151 = p.member.light.cos_outer;
                        phi_506_ = (-((((_e113 * _e133.x) + (_e114 * _e133.y)) + (_e115 * _e133.z))) >= (_e151 * sqrt(_e131)));
                    } else {
                        phi_506_ = false;
                    }
                    let _e156 = phi_506_;
                    phi_507_ = _e156;
                }
                let _e158 = phi_507_;
                if _e158 {
                    let _e160 = samples.member[(0u + _e59.first_primitive)].flags;
                    let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                    phi_518_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, ((_e160 & 1u) == 0u));
                    phi_519_ = false;
                } else {
                    phi_518_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_519_ = true;
                }
                let _e179 = phi_518_;
                let _e181 = phi_519_;
                phi_520_ = _e179;
                phi_521_ = _e181;
            } else {
                phi_520_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_521_ = true;
            }
            let _e183 = phi_520_;
            let _e185 = phi_521_;
            if _e185 {
                let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                phi_528_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, true);
            } else {
                phi_528_ = _e183;
            }
            let _e202 = phi_528_;
            phi_532_ = _e202;
        } else {
            let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
            phi_532_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
        }
        let _e219 = phi_532_;
        if _e219.unnamed_1 {
            phi_1223_ = evaluate_Verdict(_e219.unnamed.visibility, _e219.unnamed.is_doubted);
            phi_1224_ = evaluate_Verdict();
            phi_1225_ = true;
        } else {
            let _e227 = samples.member[(0u + _e59.first_primitive)].position;
            let _e229 = p.member.map_size;
            let _e231 = (0.5f / f32(_e229));
            let _e238 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e245 = lt_math_LightPoint(vec2<f32>(_e238.uv.x, 0f), _e238.depth, _e238.is_inside);
            let _e249 = lt_math_LightPoint(_e245.uv, 0f, _e245.is_inside);
            phi_552_ = lt_math_LightPoint();
            phi_555_ = 0u;
            phi_557_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e249.uv, _e249.depth, false));
            loop {
                let _e256 = phi_552_;
                let _e258 = phi_555_;
                let _e260 = phi_557_;
                local_1 = _e260;
                local_2 = _e260;
                local_3 = _e260;
                local_4 = _e260;
                if (_e258 < _e65) {
                    if _e260.point.is_inside {
                        phi_718_ = lt_math_LightPoint();
                        phi_719_ = u32();
                        phi_720_ = lt_math_LevelPoint();
                        phi_721_ = false;
                    } else {
                        if (_e258 < _e53) {
                        } else {
                            return;
                        }
                        let _e271 = levels.member[(0u + _e258)].row_w;
                        let _e282 = ((((_e271.x * _e227.x) + (_e271.y * _e227.y)) + (_e271.z * _e227.z)) + (_e271.w * 1f));
                        let _e284 = levels.member[(0u + _e258)].row_x;
                        let _e296 = (((((_e284.x * _e227.x) + (_e284.y * _e227.y)) + (_e284.z * _e227.z)) + (_e284.w * 1f)) / _e282);
                        let _e298 = levels.member[(0u + _e258)].row_y;
                        let _e310 = (((((_e298.x * _e227.x) + (_e298.y * _e227.y)) + (_e298.z * _e227.z)) + (_e298.w * 1f)) / _e282);
                        let _e312 = levels.member[(0u + _e258)].row_z;
                        let _e323 = ((((_e312.x * _e227.x) + (_e312.y * _e227.y)) + (_e312.z * _e227.z)) + (_e312.w * 1f));
                        if (_e282 > 0f) {
                            if (_e296 >= 0f) {
                                phi_643_ = (_e296 <= 1f);
                            } else {
                                phi_643_ = false;
                            }
                            let _e328 = phi_643_;
                            if _e328 {
                                if (_e310 >= 0f) {
                                    phi_652_ = (_e310 <= 1f);
                                } else {
                                    phi_652_ = false;
                                }
                                let _e332 = phi_652_;
                                if _e332 {
                                    if (_e323 >= 0f) {
                                        phi_661_ = (_e323 <= 1f);
                                    } else {
                                        phi_661_ = false;
                                    }
                                    let _e336 = phi_661_;
                                    phi_662_ = _e336;
                                    phi_663_ = false;
                                } else {
                                    phi_662_ = bool();
                                    phi_663_ = true;
                                }
                                let _e338 = phi_662_;
                                let _e340 = phi_663_;
                                phi_664_ = _e338;
                                phi_665_ = _e340;
                            } else {
                                phi_664_ = bool();
                                phi_665_ = true;
                            }
                            let _e342 = phi_664_;
                            let _e344 = phi_665_;
                            phi_666_ = _e342;
                            phi_667_ = _e344;
                        } else {
                            phi_666_ = bool();
                            phi_667_ = true;
                        }
                        let _e346 = phi_666_;
                        let _e348 = phi_667_;
                        if _e348 {
                            phi_671_ = false;
                        } else {
                            phi_671_ = _e346;
                        }
                        let _e350 = phi_671_;
                        if _e350 {
                            if (_e296 >= _e231) {
                                if (_e296 <= (1f - _e231)) {
                                    if (_e310 >= _e231) {
                                        phi_698_ = (_e310 <= (1f - _e231));
                                        phi_699_ = false;
                                    } else {
                                        phi_698_ = bool();
                                        phi_699_ = true;
                                    }
                                    let _e358 = phi_698_;
                                    let _e360 = phi_699_;
                                    phi_700_ = _e358;
                                    phi_701_ = _e360;
                                } else {
                                    phi_700_ = bool();
                                    phi_701_ = true;
                                }
                                let _e362 = phi_700_;
                                let _e364 = phi_701_;
                                phi_702_ = _e362;
                                phi_703_ = _e364;
                            } else {
                                phi_702_ = bool();
                                phi_703_ = true;
                            }
                            let _e366 = phi_702_;
                            let _e368 = phi_703_;
                            phi_704_ = _e366;
                            phi_705_ = _e368;
                        } else {
                            phi_704_ = bool();
                            phi_705_ = true;
                        }
                        let _e370 = phi_704_;
                        let _e372 = phi_705_;
                        if _e372 {
                            phi_709_ = false;
                        } else {
                            phi_709_ = _e370;
                        }
                        let _e374 = phi_709_;
                        let _e381 = lt_math_LightPoint(vec2<f32>(_e296, _e256.uv.y), _e256.depth, _e256.is_inside);
                        let _e388 = lt_math_LightPoint(vec2<f32>(_e381.uv.x, _e310), _e381.depth, _e381.is_inside);
                        let _e392 = lt_math_LightPoint(_e388.uv, _e323, _e388.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e392.depth, _e374);
                        phi_718_ = _e396;
                        phi_719_ = (_e258 + 1u);
                        phi_720_ = lt_math_LevelPoint(_e258, _e396);
                        phi_721_ = true;
                    }
                    let _e400 = phi_718_;
                    let _e402 = phi_719_;
                    let _e404 = phi_720_;
                    let _e406 = phi_721_;
                    phi_553_ = _e400;
                    phi_556_ = _e402;
                    phi_558_ = _e404;
                    phi_722_ = _e406;
                } else {
                    phi_553_ = lt_math_LightPoint();
                    phi_556_ = u32();
                    phi_558_ = lt_math_LevelPoint();
                    phi_722_ = false;
                }
                let _e408 = phi_553_;
                let _e410 = phi_556_;
                let _e412 = phi_558_;
                let _e414 = phi_722_;
                continue;
                continuing {
                    phi_552_ = _e408;
                    phi_555_ = _e410;
                    phi_557_ = _e412;
                    break if !(_e414);
                }
            }
            let _e417 = local_1;
            if _e417.point.is_inside {
                if (1f > 0f) {
                    let _e423 = local_2;
                    if (_e423.level < _e53) {
                    } else {
                        return;
                    }
                    let _e428 = levels.member[(0u + _e423.level)];
                    let _e434 = global[0u];
                    if (_e428.row_w.x == _e434) {
                        let _e437 = global[1u];
                        if (_e428.row_w.y == _e437) {
                            let _e440 = global[2u];
                            phi_762_ = (_e428.row_w.z == _e440);
                            phi_763_ = false;
                        } else {
                            phi_762_ = bool();
                            phi_763_ = true;
                        }
                        let _e443 = phi_762_;
                        let _e445 = phi_763_;
                        phi_764_ = _e443;
                        phi_765_ = _e445;
                    } else {
                        phi_764_ = bool();
                        phi_765_ = true;
                    }
                    let _e447 = phi_764_;
                    let _e449 = phi_765_;
                    if _e449 {
                        phi_769_ = false;
                    } else {
                        phi_769_ = _e447;
                    }
                    let _e451 = phi_769_;
                    if _e451 {
                        let _e453 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e455 = p.member.map_size;
                        let _e525 = ((abs(((((_e428.row_x.x * _e453.x) + (_e428.row_x.y * _e453.y)) + (_e428.row_x.z * _e453.z)) / (((_e428.row_x.x * _e428.row_x.x) + (_e428.row_x.y * _e428.row_x.y)) + (_e428.row_x.z * _e428.row_x.z)))) + abs(((((_e428.row_y.x * _e453.x) + (_e428.row_y.y * _e453.y)) + (_e428.row_y.z * _e453.z)) / (((_e428.row_y.x * _e428.row_y.x) + (_e428.row_y.y * _e428.row_y.y)) + (_e428.row_y.z * _e428.row_y.z))))) / (abs(((((_e428.row_z.x * _e453.x) + (_e428.row_z.y * _e453.y)) + (_e428.row_z.z * _e453.z)) / (((_e428.row_z.x * _e428.row_z.x) + (_e428.row_z.y * _e428.row_z.y)) + (_e428.row_z.z * _e428.row_z.z)))) * f32(_e455)));
                        if (_e525 < 0.002f) {
                            phi_851_ = _e525;
                        } else {
                            phi_851_ = 0.002f;
                        }
                        let _e528 = phi_851_;
                        phi_968_ = _e528;
                    } else {
                        let _e530 = p.member.map_size;
                        let _e536 = samples.member[(0u + _e59.first_primitive)].position;
                        let _e547 = ((((_e428.row_w.x * _e536.x) + (_e428.row_w.y * _e536.y)) + (_e428.row_w.z * _e536.z)) + _e428.row_w.w);
                        let _e560 = ((_e428.row_x.x - (_e428.row_w.x * _e417.point.uv.x)) / _e547);
                        let _e561 = ((_e428.row_x.y - (_e428.row_w.y * _e417.point.uv.x)) / _e547);
                        let _e562 = ((_e428.row_x.z - (_e428.row_w.z * _e417.point.uv.x)) / _e547);
                        let _e575 = ((_e428.row_y.x - (_e428.row_w.x * _e417.point.uv.y)) / _e547);
                        let _e576 = ((_e428.row_y.y - (_e428.row_w.y * _e417.point.uv.y)) / _e547);
                        let _e577 = ((_e428.row_y.z - (_e428.row_w.z * _e417.point.uv.y)) / _e547);
                        let _e583 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e588 = ((_e576 * _e583.z) - (_e583.y * _e577));
                        let _e593 = ((_e577 * _e583.x) - (_e583.z * _e575));
                        let _e598 = ((_e575 * _e583.y) - (_e583.x * _e576));
                        let _e600 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e605 = ((_e561 * _e600.z) - (_e600.y * _e562));
                        let _e610 = ((_e562 * _e600.x) - (_e600.z * _e560));
                        let _e615 = ((_e560 * _e600.y) - (_e600.x * _e561));
                        let _e642 = ((abs(((((_e428.row_z.x * _e588) + (_e428.row_z.y * _e593)) + (_e428.row_z.z * _e598)) / (((_e560 * _e588) + (_e561 * _e593)) + (_e562 * _e598)))) + abs(((((_e428.row_z.x * _e605) + (_e428.row_z.y * _e610)) + (_e428.row_z.z * _e615)) / (((_e575 * _e605) + (_e576 * _e610)) + (_e577 * _e615))))) / f32(_e530));
                        if (_e642 < 0.002f) {
                            phi_967_ = _e642;
                        } else {
                            phi_967_ = 0.002f;
                        }
                        let _e645 = phi_967_;
                        phi_968_ = _e645;
                    }
                    let _e647 = phi_968_;
                    phi_971_ = (_e417.point.depth - (1f * _e647));
                } else {
                    phi_971_ = _e417.point.depth;
                }
                let _e651 = phi_971_;
                let _e657 = p.member.map_size;
                let _e658 = f32(_e657);
                let _e661 = ((_e417.point.uv.x * _e658) - 0.5f);
                let _e662 = ((_e417.point.uv.y * _e658) - 0.5f);
                if (_e661 > -8388608f) {
                    let _e674 = f32(select(0i, select(select(i32(_e661), i32(-2147483648), (_e661 < bitcast<f32>(3472883712u))), 2147483647i, (_e661 > bitcast<f32>(1325400063u))), (_e661 == _e661)));
                    if (_e674 > _e661) {
                        phi_1000_ = 1f;
                    } else {
                        phi_1000_ = 0f;
                    }
                    let _e677 = phi_1000_;
                    if (_e661 < 8388608f) {
                        phi_1005_ = (_e674 - _e677);
                        phi_1006_ = false;
                    } else {
                        phi_1005_ = f32();
                        phi_1006_ = true;
                    }
                    let _e680 = phi_1005_;
                    let _e682 = phi_1006_;
                    phi_1007_ = _e680;
                    phi_1008_ = _e682;
                } else {
                    phi_1007_ = f32();
                    phi_1008_ = true;
                }
                let _e684 = phi_1007_;
                let _e686 = phi_1008_;
                if _e686 {
                    phi_1012_ = _e661;
                } else {
                    phi_1012_ = _e684;
                }
                let _e688 = phi_1012_;
                if (_e662 > -8388608f) {
                    let _e700 = f32(select(0i, select(select(i32(_e662), i32(-2147483648), (_e662 < bitcast<f32>(3472883712u))), 2147483647i, (_e662 > bitcast<f32>(1325400063u))), (_e662 == _e662)));
                    if (_e700 > _e662) {
                        phi_1032_ = 1f;
                    } else {
                        phi_1032_ = 0f;
                    }
                    let _e703 = phi_1032_;
                    if (_e662 < 8388608f) {
                        phi_1037_ = (_e700 - _e703);
                        phi_1038_ = false;
                    } else {
                        phi_1037_ = f32();
                        phi_1038_ = true;
                    }
                    let _e706 = phi_1037_;
                    let _e708 = phi_1038_;
                    phi_1039_ = _e706;
                    phi_1040_ = _e708;
                } else {
                    phi_1039_ = f32();
                    phi_1040_ = true;
                }
                let _e710 = phi_1039_;
                let _e712 = phi_1040_;
                if _e712 {
                    phi_1044_ = _e662;
                } else {
                    phi_1044_ = _e710;
                }
                let _e714 = phi_1044_;
                let _e715 = (_e661 - _e688);
                let _e716 = (_e662 - _e714);
                let _e725 = select(0i, select(select(i32(_e688), i32(-2147483648), (_e688 < bitcast<f32>(3472883712u))), 2147483647i, (_e688 > bitcast<f32>(1325400063u))), (_e688 == _e688));
                let _e734 = select(0i, select(select(i32(_e714), i32(-2147483648), (_e714 < bitcast<f32>(3472883712u))), 2147483647i, (_e714 > bitcast<f32>(1325400063u))), (_e714 == _e714));
                let _e745 = p.member.test;
                let _e746 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e745);
                let _e748 = p.member.map_size;
                let _e750 = local_3;
                local = _e746;
                let _e753 = ((_e750.level * _e748) * _e748);
                let _e755 = (bitcast<i32>(_e748) - 1i);
                if (_e725 > 0i) {
                    phi_1093_ = _e725;
                } else {
                    phi_1093_ = 0i;
                }
                let _e758 = phi_1093_;
                if (_e734 > 0i) {
                    phi_1098_ = _e734;
                } else {
                    phi_1098_ = 0i;
                }
                let _e761 = phi_1098_;
                if (_e758 < _e755) {
                    phi_1103_ = _e758;
                } else {
                    phi_1103_ = _e755;
                }
                let _e764 = phi_1103_;
                if (_e761 < _e755) {
                    phi_1108_ = _e761;
                } else {
                    phi_1108_ = _e755;
                }
                let _e767 = phi_1108_;
                let _e768 = bitcast<u32>(_e764);
                let _e770 = (_e725 + 1i);
                let _e771 = (_e734 + 1i);
                if (_e770 > 0i) {
                    phi_1117_ = _e770;
                } else {
                    phi_1117_ = 0i;
                }
                let _e774 = phi_1117_;
                if (_e771 > 0i) {
                    phi_1122_ = _e771;
                } else {
                    phi_1122_ = 0i;
                }
                let _e777 = phi_1122_;
                if (_e774 < _e755) {
                    phi_1127_ = _e774;
                } else {
                    phi_1127_ = _e755;
                }
                let _e780 = phi_1127_;
                if (_e777 < _e755) {
                    phi_1132_ = _e777;
                } else {
                    phi_1132_ = _e755;
                }
                let _e783 = phi_1132_;
                let _e784 = bitcast<u32>(_e780);
                let _e786 = (bitcast<u32>(_e767) * _e748);
                let _e787 = (bitcast<u32>(_e783) * _e748);
                let _e792 = ((_e786 + _e768) + _e753);
                let _e793 = ((_e786 + _e784) + _e753);
                let _e794 = ((_e787 + _e768) + _e753);
                let _e795 = ((_e787 + _e784) + _e753);
                if (_e792 < _e47) {
                } else {
                    return;
                }
                let _e799 = map.member[(0u + _e792)];
                if (_e793 < _e47) {
                } else {
                    return;
                }
                let _e803 = map.member[(0u + _e793)];
                if (_e794 < _e47) {
                } else {
                    return;
                }
                let _e807 = map.member[(0u + _e794)];
                if (_e795 < _e47) {
                } else {
                    return;
                }
                let _e811 = map.member[(0u + _e795)];
                let _e813 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e799, _e803, _e807, _e811), vec4<f32>(((1f - _e715) * (1f - _e716)), (_e715 * (1f - _e716)), ((1f - _e715) * _e716), (_e715 * _e716)), _e651);
                let _e815 = p.member.fade_uv;
                if (_e815 > 0f) {
                    let _e818 = local_4;
                    if ((_e818.level + 1u) == _e65) {
                        let _e827 = p.member.fade_uv;
                        let _e829 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e417.point.uv.x, (1f - _e417.point.uv.x));
                        let _e831 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e417.point.uv.y, (1f - _e417.point.uv.y));
                        let _e832 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e829, _e831);
                        if (_e832 < _e827) {
                            phi_1204_ = (1f - ((1f - _e813) * (_e832 / _e827)));
                        } else {
                            phi_1204_ = _e813;
                        }
                        let _e839 = phi_1204_;
                        phi_1206_ = evaluate_Verdict(_e839, false);
                        phi_1207_ = false;
                    } else {
                        phi_1206_ = evaluate_Verdict();
                        phi_1207_ = true;
                    }
                    let _e842 = phi_1206_;
                    let _e844 = phi_1207_;
                    phi_1208_ = _e842;
                    phi_1209_ = _e844;
                } else {
                    phi_1208_ = evaluate_Verdict();
                    phi_1209_ = true;
                }
                let _e846 = phi_1208_;
                let _e848 = phi_1209_;
                if _e848 {
                    phi_1214_ = evaluate_Verdict(_e813, false);
                    phi_1215_ = false;
                } else {
                    phi_1214_ = evaluate_Verdict();
                    phi_1215_ = true;
                }
                let _e851 = phi_1214_;
                let _e853 = phi_1215_;
                phi_1217_ = _e851;
                phi_1218_ = _e846;
                phi_1219_ = _e853;
            } else {
                phi_1217_ = evaluate_Verdict();
                phi_1218_ = evaluate_Verdict(1f, false);
                phi_1219_ = true;
            }
            let _e856 = phi_1217_;
            let _e858 = phi_1218_;
            let _e860 = phi_1219_;
            if _e860 {
            }
            phi_1223_ = _e858;
            phi_1224_ = _e856;
            phi_1225_ = _e860;
        }
        let _e862 = phi_1223_;
        let _e864 = phi_1224_;
        let _e866 = phi_1225_;
        if _e866 {
            phi_1229_ = _e862;
        } else {
            phi_1229_ = _e864;
        }
        let _e868 = phi_1229_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e868.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_pcf_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
