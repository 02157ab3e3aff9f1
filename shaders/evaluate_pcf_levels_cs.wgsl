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

struct type_35 {
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
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_35;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_142_: lt_bvh_traverse_Tree;
    var phi_143_: bool;
    var phi_144_: lt_bvh_traverse_Tree;
    var phi_145_: bool;
    var phi_150_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_142_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_143_ = false;
        } else {
            phi_142_ = lt_bvh_traverse_Tree();
            phi_143_ = true;
        }
        let _e52 = phi_142_;
        let _e54 = phi_143_;
        phi_144_ = _e52;
        phi_145_ = _e54;
    } else {
        phi_144_ = lt_bvh_traverse_Tree();
        phi_145_ = true;
    }
    let _e56 = phi_144_;
    let _e58 = phi_145_;
    if _e58 {
        phi_150_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_150_ = _e56;
    }
    let _e63 = phi_150_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
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
    var phi_253_: f32;
    var phi_254_: f32;
    var phi_255_: f32;
    var phi_272_: f32;
    var phi_273_: f32;
    var phi_274_: f32;
    var phi_291_: f32;
    var phi_292_: f32;
    var phi_293_: f32;
    var phi_310_: f32;
    var phi_311_: f32;
    var phi_312_: f32;
    var phi_329_: f32;
    var phi_330_: f32;
    var phi_331_: f32;
    var phi_357_: f32;
    var phi_358_: f32;
    var phi_359_: f32;

    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_179_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_178_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_177_ = 1f;
            } else {
                phi_177_ = param_5.x;
            }
            let _e50 = phi_177_;
            phi_178_ = _e50;
        }
        let _e52 = phi_178_;
        phi_179_ = _e52;
    }
    let _e54 = phi_179_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_197_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_196_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_195_ = 1f;
            } else {
                phi_195_ = param_5.y;
            }
            let _e62 = phi_195_;
            phi_196_ = _e62;
        }
        let _e64 = phi_196_;
        phi_197_ = _e64;
    }
    let _e66 = phi_197_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_215_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_214_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_213_ = 1f;
            } else {
                phi_213_ = param_5.z;
            }
            let _e74 = phi_213_;
            phi_214_ = _e74;
        }
        let _e76 = phi_214_;
        phi_215_ = _e76;
    }
    let _e78 = phi_215_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_233_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_232_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_231_ = 1f;
            } else {
                phi_231_ = param_5.w;
            }
            let _e86 = phi_231_;
            phi_232_ = _e86;
        }
        let _e88 = phi_232_;
        phi_233_ = _e88;
    }
    let _e90 = phi_233_;
    let _e91 = (*param_4);
    let _e92 = (_e54 + _e91);
    let _e93 = (_e66 + _e91);
    let _e94 = (_e78 + _e91);
    let _e95 = (_e90 + _e91);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_255_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_254_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_253_ = 1f;
            } else {
                phi_253_ = param_7;
            }
            let _e102 = phi_253_;
            phi_254_ = _e102;
        }
        let _e104 = phi_254_;
        phi_255_ = _e104;
    }
    let _e106 = phi_255_;
    if ((bitcast<u32>(_e92) & 2147483647u) > 2139095040u) {
        phi_274_ = _e92;
    } else {
        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
            phi_273_ = _e106;
        } else {
            if (_e92 < _e106) {
                phi_272_ = 0f;
            } else {
                phi_272_ = 1f;
            }
            let _e115 = phi_272_;
            phi_273_ = _e115;
        }
        let _e117 = phi_273_;
        phi_274_ = _e117;
    }
    let _e119 = phi_274_;
    if ((bitcast<u32>(_e93) & 2147483647u) > 2139095040u) {
        phi_293_ = _e93;
    } else {
        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
            phi_292_ = _e106;
        } else {
            if (_e93 < _e106) {
                phi_291_ = 0f;
            } else {
                phi_291_ = 1f;
            }
            let _e128 = phi_291_;
            phi_292_ = _e128;
        }
        let _e130 = phi_292_;
        phi_293_ = _e130;
    }
    let _e132 = phi_293_;
    if ((bitcast<u32>(_e94) & 2147483647u) > 2139095040u) {
        phi_312_ = _e94;
    } else {
        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
            phi_311_ = _e106;
        } else {
            if (_e94 < _e106) {
                phi_310_ = 0f;
            } else {
                phi_310_ = 1f;
            }
            let _e141 = phi_310_;
            phi_311_ = _e141;
        }
        let _e143 = phi_311_;
        phi_312_ = _e143;
    }
    let _e145 = phi_312_;
    if ((bitcast<u32>(_e95) & 2147483647u) > 2139095040u) {
        phi_331_ = _e95;
    } else {
        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
            phi_330_ = _e106;
        } else {
            if (_e95 < _e106) {
                phi_329_ = 0f;
            } else {
                phi_329_ = 1f;
            }
            let _e154 = phi_329_;
            phi_330_ = _e154;
        }
        let _e156 = phi_330_;
        phi_331_ = _e156;
    }
    let _e158 = phi_331_;
    let _e169 = ((((_e119 * param_6.x) + (_e132 * param_6.y)) + (_e145 * param_6.z)) + (_e158 * param_6.w));
    if ((bitcast<u32>(_e169) & 2147483647u) > 2139095040u) {
        phi_359_ = _e169;
    } else {
        if (_e169 < 0f) {
            phi_358_ = 0f;
        } else {
            if (_e169 > 1f) {
                phi_357_ = 1f;
            } else {
                phi_357_ = _e169;
            }
            let _e176 = phi_357_;
            phi_358_ = _e176;
        }
        let _e178 = phi_358_;
        phi_359_ = _e178;
    }
    let _e180 = phi_359_;
    return _e180;
}

fn function_() {
    var local: f32;
    var phi_419_: bool;
    var phi_420_: bool;
    var phi_421_: bool;
    var phi_422_: bool;
    var phi_426_: bool;
    var phi_496_: bool;
    var phi_497_: bool;
    var phi_508_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_509_: bool;
    var phi_510_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_511_: bool;
    var phi_518_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_522_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_542_: lt_math_LightPoint;
    var phi_545_: u32;
    var phi_547_: lt_math_LevelPoint;
    var phi_633_: bool;
    var phi_642_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_661_: bool;
    var phi_688_: bool;
    var phi_689_: bool;
    var phi_690_: bool;
    var phi_691_: bool;
    var phi_692_: bool;
    var phi_693_: bool;
    var phi_694_: bool;
    var phi_695_: bool;
    var phi_699_: bool;
    var phi_708_: lt_math_LightPoint;
    var phi_709_: u32;
    var phi_710_: lt_math_LevelPoint;
    var phi_711_: bool;
    var phi_543_: lt_math_LightPoint;
    var phi_546_: u32;
    var phi_548_: lt_math_LevelPoint;
    var phi_712_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_754_: bool;
    var phi_755_: bool;
    var phi_759_: bool;
    var phi_841_: f32;
    var phi_959_: f32;
    var phi_960_: f32;
    var phi_963_: f32;
    var phi_992_: f32;
    var phi_997_: f32;
    var phi_998_: bool;
    var phi_999_: f32;
    var phi_1000_: bool;
    var phi_1004_: f32;
    var phi_1024_: f32;
    var phi_1029_: f32;
    var phi_1030_: bool;
    var phi_1031_: f32;
    var phi_1032_: bool;
    var phi_1036_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1085_: i32;
    var phi_1090_: i32;
    var phi_1095_: i32;
    var phi_1100_: i32;
    var phi_1109_: i32;
    var phi_1114_: i32;
    var phi_1119_: i32;
    var phi_1124_: i32;
    var phi_1169_: evaluate_Verdict;
    var phi_1170_: evaluate_Verdict;
    var phi_1171_: bool;
    var phi_1172_: evaluate_Verdict;
    var phi_1173_: evaluate_Verdict;
    var phi_1174_: bool;
    var phi_1178_: evaluate_Verdict;

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
                phi_419_ = (_e82 == _e84);
                phi_420_ = false;
            } else {
                phi_419_ = bool();
                phi_420_ = true;
            }
            let _e87 = phi_419_;
            let _e89 = phi_420_;
            phi_421_ = _e87;
            phi_422_ = _e89;
        } else {
            phi_421_ = bool();
            phi_422_ = true;
        }
        let _e91 = phi_421_;
        let _e93 = phi_422_;
        if _e93 {
            phi_426_ = false;
        } else {
            phi_426_ = _e91;
        }
        let _e95 = phi_426_;
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
                    phi_497_ = true;
                } else {
                    let _e148 = p.member.light.range_squared;
                    if (_e131 <= _e148) {
                        let _e151 = p.member.light.cos_outer;
                        phi_496_ = (-((((_e113 * _e133.x) + (_e114 * _e133.y)) + (_e115 * _e133.z))) >= (_e151 * sqrt(_e131)));
                    } else {
                        phi_496_ = false;
                    }
                    let _e156 = phi_496_;
                    phi_497_ = _e156;
                }
                let _e158 = phi_497_;
                if _e158 {
                    let _e160 = samples.member[(0u + _e59.first_primitive)].flags;
                    let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                    phi_508_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, ((_e160 & 1u) == 0u));
                    phi_509_ = false;
                } else {
                    phi_508_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_509_ = true;
                }
                let _e179 = phi_508_;
                let _e181 = phi_509_;
                phi_510_ = _e179;
                phi_511_ = _e181;
            } else {
                phi_510_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_511_ = true;
            }
            let _e183 = phi_510_;
            let _e185 = phi_511_;
            if _e185 {
                let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                phi_518_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, true);
            } else {
                phi_518_ = _e183;
            }
            let _e202 = phi_518_;
            phi_522_ = _e202;
        } else {
            let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
            phi_522_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
        }
        let _e219 = phi_522_;
        if _e219.unnamed_1 {
            phi_1172_ = evaluate_Verdict(_e219.unnamed.visibility, _e219.unnamed.is_doubted);
            phi_1173_ = evaluate_Verdict();
            phi_1174_ = true;
        } else {
            let _e227 = samples.member[(0u + _e59.first_primitive)].position;
            let _e229 = p.member.map_size;
            let _e231 = (0.5f / f32(_e229));
            let _e238 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e245 = lt_math_LightPoint(vec2<f32>(_e238.uv.x, 0f), _e238.depth, _e238.is_inside);
            let _e249 = lt_math_LightPoint(_e245.uv, 0f, _e245.is_inside);
            phi_542_ = lt_math_LightPoint();
            phi_545_ = 0u;
            phi_547_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e249.uv, _e249.depth, false));
            loop {
                let _e256 = phi_542_;
                let _e258 = phi_545_;
                let _e260 = phi_547_;
                local_1 = _e260;
                local_2 = _e260;
                local_3 = _e260;
                if (_e258 < _e65) {
                    if _e260.point.is_inside {
                        phi_708_ = lt_math_LightPoint();
                        phi_709_ = u32();
                        phi_710_ = lt_math_LevelPoint();
                        phi_711_ = false;
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
                                phi_633_ = (_e296 <= 1f);
                            } else {
                                phi_633_ = false;
                            }
                            let _e328 = phi_633_;
                            if _e328 {
                                if (_e310 >= 0f) {
                                    phi_642_ = (_e310 <= 1f);
                                } else {
                                    phi_642_ = false;
                                }
                                let _e332 = phi_642_;
                                if _e332 {
                                    if (_e323 >= 0f) {
                                        phi_651_ = (_e323 <= 1f);
                                    } else {
                                        phi_651_ = false;
                                    }
                                    let _e336 = phi_651_;
                                    phi_652_ = _e336;
                                    phi_653_ = false;
                                } else {
                                    phi_652_ = bool();
                                    phi_653_ = true;
                                }
                                let _e338 = phi_652_;
                                let _e340 = phi_653_;
                                phi_654_ = _e338;
                                phi_655_ = _e340;
                            } else {
                                phi_654_ = bool();
                                phi_655_ = true;
                            }
                            let _e342 = phi_654_;
                            let _e344 = phi_655_;
                            phi_656_ = _e342;
                            phi_657_ = _e344;
                        } else {
                            phi_656_ = bool();
                            phi_657_ = true;
                        }
                        let _e346 = phi_656_;
                        let _e348 = phi_657_;
                        if _e348 {
                            phi_661_ = false;
                        } else {
                            phi_661_ = _e346;
                        }
                        let _e350 = phi_661_;
                        if _e350 {
                            if (_e296 >= _e231) {
                                if (_e296 <= (1f - _e231)) {
                                    if (_e310 >= _e231) {
                                        phi_688_ = (_e310 <= (1f - _e231));
                                        phi_689_ = false;
                                    } else {
                                        phi_688_ = bool();
                                        phi_689_ = true;
                                    }
                                    let _e358 = phi_688_;
                                    let _e360 = phi_689_;
                                    phi_690_ = _e358;
                                    phi_691_ = _e360;
                                } else {
                                    phi_690_ = bool();
                                    phi_691_ = true;
                                }
                                let _e362 = phi_690_;
                                let _e364 = phi_691_;
                                phi_692_ = _e362;
                                phi_693_ = _e364;
                            } else {
                                phi_692_ = bool();
                                phi_693_ = true;
                            }
                            let _e366 = phi_692_;
                            let _e368 = phi_693_;
                            phi_694_ = _e366;
                            phi_695_ = _e368;
                        } else {
                            phi_694_ = bool();
                            phi_695_ = true;
                        }
                        let _e370 = phi_694_;
                        let _e372 = phi_695_;
                        if _e372 {
                            phi_699_ = false;
                        } else {
                            phi_699_ = _e370;
                        }
                        let _e374 = phi_699_;
                        let _e381 = lt_math_LightPoint(vec2<f32>(_e296, _e256.uv.y), _e256.depth, _e256.is_inside);
                        let _e388 = lt_math_LightPoint(vec2<f32>(_e381.uv.x, _e310), _e381.depth, _e381.is_inside);
                        let _e392 = lt_math_LightPoint(_e388.uv, _e323, _e388.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e392.depth, _e374);
                        phi_708_ = _e396;
                        phi_709_ = (_e258 + 1u);
                        phi_710_ = lt_math_LevelPoint(_e258, _e396);
                        phi_711_ = true;
                    }
                    let _e400 = phi_708_;
                    let _e402 = phi_709_;
                    let _e404 = phi_710_;
                    let _e406 = phi_711_;
                    phi_543_ = _e400;
                    phi_546_ = _e402;
                    phi_548_ = _e404;
                    phi_712_ = _e406;
                } else {
                    phi_543_ = lt_math_LightPoint();
                    phi_546_ = u32();
                    phi_548_ = lt_math_LevelPoint();
                    phi_712_ = false;
                }
                let _e408 = phi_543_;
                let _e410 = phi_546_;
                let _e412 = phi_548_;
                let _e414 = phi_712_;
                continue;
                continuing {
                    phi_542_ = _e408;
                    phi_545_ = _e410;
                    phi_547_ = _e412;
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
                            phi_752_ = (_e428.row_w.z == _e440);
                            phi_753_ = false;
                        } else {
                            phi_752_ = bool();
                            phi_753_ = true;
                        }
                        let _e443 = phi_752_;
                        let _e445 = phi_753_;
                        phi_754_ = _e443;
                        phi_755_ = _e445;
                    } else {
                        phi_754_ = bool();
                        phi_755_ = true;
                    }
                    let _e447 = phi_754_;
                    let _e449 = phi_755_;
                    if _e449 {
                        phi_759_ = false;
                    } else {
                        phi_759_ = _e447;
                    }
                    let _e451 = phi_759_;
                    if _e451 {
                        let _e453 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e455 = p.member.map_size;
                        let _e525 = ((abs(((((_e428.row_x.x * _e453.x) + (_e428.row_x.y * _e453.y)) + (_e428.row_x.z * _e453.z)) / (((_e428.row_x.x * _e428.row_x.x) + (_e428.row_x.y * _e428.row_x.y)) + (_e428.row_x.z * _e428.row_x.z)))) + abs(((((_e428.row_y.x * _e453.x) + (_e428.row_y.y * _e453.y)) + (_e428.row_y.z * _e453.z)) / (((_e428.row_y.x * _e428.row_y.x) + (_e428.row_y.y * _e428.row_y.y)) + (_e428.row_y.z * _e428.row_y.z))))) / (abs(((((_e428.row_z.x * _e453.x) + (_e428.row_z.y * _e453.y)) + (_e428.row_z.z * _e453.z)) / (((_e428.row_z.x * _e428.row_z.x) + (_e428.row_z.y * _e428.row_z.y)) + (_e428.row_z.z * _e428.row_z.z)))) * f32(_e455)));
                        if (_e525 < 0.002f) {
                            phi_841_ = _e525;
                        } else {
                            phi_841_ = 0.002f;
                        }
                        let _e528 = phi_841_;
                        phi_960_ = _e528;
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
                        let _e644 = (16f / f32(_e530));
                        if (_e642 < _e644) {
                            phi_959_ = _e642;
                        } else {
                            phi_959_ = _e644;
                        }
                        let _e647 = phi_959_;
                        phi_960_ = _e647;
                    }
                    let _e649 = phi_960_;
                    phi_963_ = (_e417.point.depth - (1f * _e649));
                } else {
                    phi_963_ = _e417.point.depth;
                }
                let _e653 = phi_963_;
                let _e659 = p.member.map_size;
                let _e660 = f32(_e659);
                let _e663 = ((_e417.point.uv.x * _e660) - 0.5f);
                let _e664 = ((_e417.point.uv.y * _e660) - 0.5f);
                if (_e663 > -8388608f) {
                    let _e676 = f32(select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < bitcast<f32>(3472883712u))), 2147483647i, (_e663 > bitcast<f32>(1325400063u))), (_e663 == _e663)));
                    if (_e676 > _e663) {
                        phi_992_ = 1f;
                    } else {
                        phi_992_ = 0f;
                    }
                    let _e679 = phi_992_;
                    if (_e663 < 8388608f) {
                        phi_997_ = (_e676 - _e679);
                        phi_998_ = false;
                    } else {
                        phi_997_ = f32();
                        phi_998_ = true;
                    }
                    let _e682 = phi_997_;
                    let _e684 = phi_998_;
                    phi_999_ = _e682;
                    phi_1000_ = _e684;
                } else {
                    phi_999_ = f32();
                    phi_1000_ = true;
                }
                let _e686 = phi_999_;
                let _e688 = phi_1000_;
                if _e688 {
                    phi_1004_ = _e663;
                } else {
                    phi_1004_ = _e686;
                }
                let _e690 = phi_1004_;
                if (_e664 > -8388608f) {
                    let _e702 = f32(select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < bitcast<f32>(3472883712u))), 2147483647i, (_e664 > bitcast<f32>(1325400063u))), (_e664 == _e664)));
                    if (_e702 > _e664) {
                        phi_1024_ = 1f;
                    } else {
                        phi_1024_ = 0f;
                    }
                    let _e705 = phi_1024_;
                    if (_e664 < 8388608f) {
                        phi_1029_ = (_e702 - _e705);
                        phi_1030_ = false;
                    } else {
                        phi_1029_ = f32();
                        phi_1030_ = true;
                    }
                    let _e708 = phi_1029_;
                    let _e710 = phi_1030_;
                    phi_1031_ = _e708;
                    phi_1032_ = _e710;
                } else {
                    phi_1031_ = f32();
                    phi_1032_ = true;
                }
                let _e712 = phi_1031_;
                let _e714 = phi_1032_;
                if _e714 {
                    phi_1036_ = _e664;
                } else {
                    phi_1036_ = _e712;
                }
                let _e716 = phi_1036_;
                let _e717 = (_e663 - _e690);
                let _e718 = (_e664 - _e716);
                let _e727 = select(0i, select(select(i32(_e690), i32(-2147483648), (_e690 < bitcast<f32>(3472883712u))), 2147483647i, (_e690 > bitcast<f32>(1325400063u))), (_e690 == _e690));
                let _e736 = select(0i, select(select(i32(_e716), i32(-2147483648), (_e716 < bitcast<f32>(3472883712u))), 2147483647i, (_e716 > bitcast<f32>(1325400063u))), (_e716 == _e716));
                let _e747 = p.member.test;
                let _e748 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e747);
                let _e750 = p.member.map_size;
                let _e752 = local_3;
                local = _e748;
                let _e755 = ((_e752.level * _e750) * _e750);
                let _e757 = (bitcast<i32>(_e750) - 1i);
                if (_e727 > 0i) {
                    phi_1085_ = _e727;
                } else {
                    phi_1085_ = 0i;
                }
                let _e760 = phi_1085_;
                if (_e736 > 0i) {
                    phi_1090_ = _e736;
                } else {
                    phi_1090_ = 0i;
                }
                let _e763 = phi_1090_;
                if (_e760 < _e757) {
                    phi_1095_ = _e760;
                } else {
                    phi_1095_ = _e757;
                }
                let _e766 = phi_1095_;
                if (_e763 < _e757) {
                    phi_1100_ = _e763;
                } else {
                    phi_1100_ = _e757;
                }
                let _e769 = phi_1100_;
                let _e770 = bitcast<u32>(_e766);
                let _e772 = (_e727 + 1i);
                let _e773 = (_e736 + 1i);
                if (_e772 > 0i) {
                    phi_1109_ = _e772;
                } else {
                    phi_1109_ = 0i;
                }
                let _e776 = phi_1109_;
                if (_e773 > 0i) {
                    phi_1114_ = _e773;
                } else {
                    phi_1114_ = 0i;
                }
                let _e779 = phi_1114_;
                if (_e776 < _e757) {
                    phi_1119_ = _e776;
                } else {
                    phi_1119_ = _e757;
                }
                let _e782 = phi_1119_;
                if (_e779 < _e757) {
                    phi_1124_ = _e779;
                } else {
                    phi_1124_ = _e757;
                }
                let _e785 = phi_1124_;
                let _e786 = bitcast<u32>(_e782);
                let _e788 = (bitcast<u32>(_e769) * _e750);
                let _e789 = (bitcast<u32>(_e785) * _e750);
                let _e794 = ((_e788 + _e770) + _e755);
                let _e795 = ((_e788 + _e786) + _e755);
                let _e796 = ((_e789 + _e770) + _e755);
                let _e797 = ((_e789 + _e786) + _e755);
                if (_e794 < _e47) {
                } else {
                    return;
                }
                let _e801 = map.member[(0u + _e794)];
                if (_e795 < _e47) {
                } else {
                    return;
                }
                let _e805 = map.member[(0u + _e795)];
                if (_e796 < _e47) {
                } else {
                    return;
                }
                let _e809 = map.member[(0u + _e796)];
                if (_e797 < _e47) {
                } else {
                    return;
                }
                let _e813 = map.member[(0u + _e797)];
                let _e815 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e801, _e805, _e809, _e813), vec4<f32>(((1f - _e717) * (1f - _e718)), (_e717 * (1f - _e718)), ((1f - _e717) * _e718), (_e717 * _e718)), _e653);
                phi_1169_ = evaluate_Verdict(_e815, false);
                phi_1170_ = evaluate_Verdict();
                phi_1171_ = false;
            } else {
                phi_1169_ = evaluate_Verdict();
                phi_1170_ = evaluate_Verdict(1f, false);
                phi_1171_ = true;
            }
            let _e819 = phi_1169_;
            let _e821 = phi_1170_;
            let _e823 = phi_1171_;
            phi_1172_ = _e821;
            phi_1173_ = _e819;
            phi_1174_ = _e823;
        }
        let _e825 = phi_1172_;
        let _e827 = phi_1173_;
        let _e829 = phi_1174_;
        if _e829 {
            phi_1178_ = _e825;
        } else {
            phi_1178_ = _e827;
        }
        let _e831 = phi_1178_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e831.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_pcf_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
