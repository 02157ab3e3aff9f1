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
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_29 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_35 {
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
var<uniform> p: type_29;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_35;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_139_: lt_bvh_traverse_Tree;
    var phi_140_: bool;
    var phi_141_: lt_bvh_traverse_Tree;
    var phi_142_: bool;
    var phi_147_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_139_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_140_ = false;
        } else {
            phi_139_ = lt_bvh_traverse_Tree();
            phi_140_ = true;
        }
        let _e51 = phi_139_;
        let _e53 = phi_140_;
        phi_141_ = _e51;
        phi_142_ = _e53;
    } else {
        phi_141_ = lt_bvh_traverse_Tree();
        phi_142_ = true;
    }
    let _e55 = phi_141_;
    let _e57 = phi_142_;
    if _e57 {
        phi_147_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_147_ = _e55;
    }
    let _e62 = phi_147_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_173_: f32;
    var phi_174_: f32;
    var phi_175_: f32;
    var phi_191_: f32;
    var phi_192_: f32;
    var phi_193_: f32;
    var phi_209_: f32;
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_227_: f32;
    var phi_228_: f32;
    var phi_229_: f32;
    var phi_245_: f32;
    var phi_246_: f32;
    var phi_247_: f32;
    var phi_293_: bool;
    var phi_297_: f32;
    var phi_309_: bool;
    var phi_316_: f32;
    var phi_331_: f32;
    var phi_332_: f32;
    var phi_333_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_175_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_174_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_173_ = 1f;
            } else {
                phi_173_ = param_7;
            }
            let _e48 = phi_173_;
            phi_174_ = _e48;
        }
        let _e50 = phi_174_;
        phi_175_ = _e50;
    }
    let _e52 = phi_175_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_193_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_192_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_191_ = 1f;
            } else {
                phi_191_ = param_5.x;
            }
            let _e60 = phi_191_;
            phi_192_ = _e60;
        }
        let _e62 = phi_192_;
        phi_193_ = _e62;
    }
    let _e64 = phi_193_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_211_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_210_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_209_ = 1f;
            } else {
                phi_209_ = param_5.y;
            }
            let _e72 = phi_209_;
            phi_210_ = _e72;
        }
        let _e74 = phi_210_;
        phi_211_ = _e74;
    }
    let _e76 = phi_211_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_229_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_228_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_227_ = 1f;
            } else {
                phi_227_ = param_5.z;
            }
            let _e84 = phi_227_;
            phi_228_ = _e84;
        }
        let _e86 = phi_228_;
        phi_229_ = _e86;
    }
    let _e88 = phi_229_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_247_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_246_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_245_ = 1f;
            } else {
                phi_245_ = param_5.w;
            }
            let _e96 = phi_245_;
            phi_246_ = _e96;
        }
        let _e98 = phi_246_;
        phi_247_ = _e98;
    }
    let _e100 = phi_247_;
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
        phi_293_ = true;
    } else {
        let _e139 = (_e105 > _e135);
        if _e139 {
        }
        phi_293_ = _e139;
    }
    let _e141 = phi_293_;
    if _e141 {
        phi_297_ = _e105;
    } else {
        phi_297_ = _e135;
    }
    let _e143 = phi_297_;
    let _e144 = -(_e116);
    if (_e144 <= 0f) {
        let _e148 = ((bitcast<u32>(_e143) & 2147483647u) > 2139095040u);
        if _e148 {
        }
        phi_309_ = _e148;
    } else {
        phi_309_ = true;
    }
    let _e150 = phi_309_;
    if _e150 {
        phi_316_ = (_e143 / (_e143 + (_e144 * _e144)));
    } else {
        phi_316_ = 1f;
    }
    let _e155 = phi_316_;
    if ((bitcast<u32>(_e155) & 2147483647u) > 2139095040u) {
        phi_333_ = _e155;
    } else {
        if (_e155 < 0f) {
            phi_332_ = 0f;
        } else {
            if (_e155 > 1f) {
                phi_331_ = 1f;
            } else {
                phi_331_ = _e155;
            }
            let _e162 = phi_331_;
            phi_332_ = _e162;
        }
        let _e164 = phi_332_;
        phi_333_ = _e164;
    }
    let _e166 = phi_333_;
    return _e166;
}

fn function_() {
    var local: f32;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_401_: bool;
    var phi_445_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_449_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_469_: lt_math_LightPoint;
    var phi_472_: u32;
    var phi_474_: lt_math_LevelPoint;
    var phi_560_: bool;
    var phi_569_: bool;
    var phi_578_: bool;
    var phi_579_: bool;
    var phi_580_: bool;
    var phi_581_: bool;
    var phi_582_: bool;
    var phi_583_: bool;
    var phi_584_: bool;
    var phi_588_: bool;
    var phi_615_: bool;
    var phi_616_: bool;
    var phi_617_: bool;
    var phi_618_: bool;
    var phi_619_: bool;
    var phi_620_: bool;
    var phi_621_: bool;
    var phi_622_: bool;
    var phi_626_: bool;
    var phi_635_: lt_math_LightPoint;
    var phi_636_: u32;
    var phi_637_: lt_math_LevelPoint;
    var phi_638_: bool;
    var phi_470_: lt_math_LightPoint;
    var phi_473_: u32;
    var phi_475_: lt_math_LevelPoint;
    var phi_639_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_679_: bool;
    var phi_680_: bool;
    var phi_681_: bool;
    var phi_682_: bool;
    var phi_686_: bool;
    var phi_768_: f32;
    var phi_884_: f32;
    var phi_885_: f32;
    var phi_888_: f32;
    var phi_917_: f32;
    var phi_922_: f32;
    var phi_923_: bool;
    var phi_924_: f32;
    var phi_925_: bool;
    var phi_929_: f32;
    var phi_949_: f32;
    var phi_954_: f32;
    var phi_955_: bool;
    var phi_956_: f32;
    var phi_957_: bool;
    var phi_961_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1010_: i32;
    var phi_1015_: i32;
    var phi_1020_: i32;
    var phi_1025_: i32;
    var phi_1034_: i32;
    var phi_1039_: i32;
    var phi_1044_: i32;
    var phi_1049_: i32;
    var phi_1100_: bool;
    var phi_1108_: bool;
    var phi_1120_: bool;
    var phi_1121_: bool;
    var phi_1125_: f32;
    var phi_1131_: f32;
    var phi_1133_: evaluate_Verdict;
    var phi_1138_: evaluate_Verdict;
    var phi_1139_: evaluate_Verdict;

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
        let _e69 = p.member.light;
        let _e72 = samples.member[(0u + _e58.first_primitive)].normal[0u];
        let _e74 = global[0u];
        if (_e72 == _e74) {
            let _e77 = samples.member[(0u + _e58.first_primitive)].normal[1u];
            let _e79 = global[1u];
            if (_e77 == _e79) {
                let _e82 = samples.member[(0u + _e58.first_primitive)].normal[2u];
                let _e84 = global[2u];
                phi_394_ = (_e82 == _e84);
                phi_395_ = false;
            } else {
                phi_394_ = bool();
                phi_395_ = true;
            }
            let _e87 = phi_394_;
            let _e89 = phi_395_;
            phi_396_ = _e87;
            phi_397_ = _e89;
        } else {
            phi_396_ = bool();
            phi_397_ = true;
        }
        let _e91 = phi_396_;
        let _e93 = phi_397_;
        if _e93 {
            phi_401_ = false;
        } else {
            phi_401_ = _e91;
        }
        let _e95 = phi_401_;
        if !(_e95) {
            let _e98 = samples.member[(0u + _e58.first_primitive)].normal;
            let _e100 = samples.member[(0u + _e58.first_primitive)].position;
            if ((((_e98.x * (_e69.x - (_e100.x * _e69.w))) + (_e98.y * (_e69.y - (_e100.y * _e69.w)))) + (_e98.z * (_e69.z - (_e100.z * _e69.w)))) > 0f) {
                let _e124 = samples.member[(0u + _e58.first_primitive)].flags;
                let _e132 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e132.unnamed.visibility, false), _e132.unnamed_1);
                phi_445_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e138.unnamed, ((_e124 & 1u) == 0u));
            } else {
                let _e147 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e147.unnamed.visibility, false), _e147.unnamed_1);
                phi_445_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e153.unnamed, true);
            }
            let _e158 = phi_445_;
            phi_449_ = _e158;
        } else {
            let _e164 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e164.unnamed.visibility, false), _e164.unnamed_1);
            phi_449_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e170.unnamed, true);
        }
        let _e175 = phi_449_;
        if _e175.unnamed_1 {
            phi_1139_ = evaluate_Verdict(_e175.unnamed.visibility, _e175.unnamed.is_doubted);
        } else {
            let _e183 = samples.member[(0u + _e58.first_primitive)].position;
            let _e185 = p.member.map_size;
            let _e187 = (0.5f / f32(_e185));
            let _e194 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e201 = lt_math_LightPoint(vec2<f32>(_e194.uv.x, 0f), _e194.depth, _e194.is_inside);
            let _e205 = lt_math_LightPoint(_e201.uv, 0f, _e201.is_inside);
            phi_469_ = lt_math_LightPoint();
            phi_472_ = 0u;
            phi_474_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e205.uv, _e205.depth, false));
            loop {
                let _e212 = phi_469_;
                let _e214 = phi_472_;
                let _e216 = phi_474_;
                local_1 = _e216;
                local_2 = _e216;
                local_3 = _e216;
                if (_e214 < _e64) {
                    if _e216.point.is_inside {
                        phi_635_ = lt_math_LightPoint();
                        phi_636_ = u32();
                        phi_637_ = lt_math_LevelPoint();
                        phi_638_ = false;
                    } else {
                        if (_e214 < _e52) {
                        } else {
                            return;
                        }
                        let _e227 = levels.member[(0u + _e214)].row_w;
                        let _e238 = ((((_e227.x * _e183.x) + (_e227.y * _e183.y)) + (_e227.z * _e183.z)) + (_e227.w * 1f));
                        let _e240 = levels.member[(0u + _e214)].row_x;
                        let _e252 = (((((_e240.x * _e183.x) + (_e240.y * _e183.y)) + (_e240.z * _e183.z)) + (_e240.w * 1f)) / _e238);
                        let _e254 = levels.member[(0u + _e214)].row_y;
                        let _e266 = (((((_e254.x * _e183.x) + (_e254.y * _e183.y)) + (_e254.z * _e183.z)) + (_e254.w * 1f)) / _e238);
                        let _e268 = levels.member[(0u + _e214)].row_z;
                        let _e279 = ((((_e268.x * _e183.x) + (_e268.y * _e183.y)) + (_e268.z * _e183.z)) + (_e268.w * 1f));
                        if (_e238 > 0f) {
                            if (_e252 >= 0f) {
                                phi_560_ = (_e252 <= 1f);
                            } else {
                                phi_560_ = false;
                            }
                            let _e284 = phi_560_;
                            if _e284 {
                                if (_e266 >= 0f) {
                                    phi_569_ = (_e266 <= 1f);
                                } else {
                                    phi_569_ = false;
                                }
                                let _e288 = phi_569_;
                                if _e288 {
                                    if (_e279 >= 0f) {
                                        phi_578_ = (_e279 <= 1f);
                                    } else {
                                        phi_578_ = false;
                                    }
                                    let _e292 = phi_578_;
                                    phi_579_ = _e292;
                                    phi_580_ = false;
                                } else {
                                    phi_579_ = bool();
                                    phi_580_ = true;
                                }
                                let _e294 = phi_579_;
                                let _e296 = phi_580_;
                                phi_581_ = _e294;
                                phi_582_ = _e296;
                            } else {
                                phi_581_ = bool();
                                phi_582_ = true;
                            }
                            let _e298 = phi_581_;
                            let _e300 = phi_582_;
                            phi_583_ = _e298;
                            phi_584_ = _e300;
                        } else {
                            phi_583_ = bool();
                            phi_584_ = true;
                        }
                        let _e302 = phi_583_;
                        let _e304 = phi_584_;
                        if _e304 {
                            phi_588_ = false;
                        } else {
                            phi_588_ = _e302;
                        }
                        let _e306 = phi_588_;
                        if _e306 {
                            if (_e252 >= _e187) {
                                if (_e252 <= (1f - _e187)) {
                                    if (_e266 >= _e187) {
                                        phi_615_ = (_e266 <= (1f - _e187));
                                        phi_616_ = false;
                                    } else {
                                        phi_615_ = bool();
                                        phi_616_ = true;
                                    }
                                    let _e314 = phi_615_;
                                    let _e316 = phi_616_;
                                    phi_617_ = _e314;
                                    phi_618_ = _e316;
                                } else {
                                    phi_617_ = bool();
                                    phi_618_ = true;
                                }
                                let _e318 = phi_617_;
                                let _e320 = phi_618_;
                                phi_619_ = _e318;
                                phi_620_ = _e320;
                            } else {
                                phi_619_ = bool();
                                phi_620_ = true;
                            }
                            let _e322 = phi_619_;
                            let _e324 = phi_620_;
                            phi_621_ = _e322;
                            phi_622_ = _e324;
                        } else {
                            phi_621_ = bool();
                            phi_622_ = true;
                        }
                        let _e326 = phi_621_;
                        let _e328 = phi_622_;
                        if _e328 {
                            phi_626_ = false;
                        } else {
                            phi_626_ = _e326;
                        }
                        let _e330 = phi_626_;
                        let _e337 = lt_math_LightPoint(vec2<f32>(_e252, _e212.uv.y), _e212.depth, _e212.is_inside);
                        let _e344 = lt_math_LightPoint(vec2<f32>(_e337.uv.x, _e266), _e337.depth, _e337.is_inside);
                        let _e348 = lt_math_LightPoint(_e344.uv, _e279, _e344.is_inside);
                        let _e352 = lt_math_LightPoint(_e348.uv, _e348.depth, _e330);
                        phi_635_ = _e352;
                        phi_636_ = (_e214 + 1u);
                        phi_637_ = lt_math_LevelPoint(_e214, _e352);
                        phi_638_ = true;
                    }
                    let _e356 = phi_635_;
                    let _e358 = phi_636_;
                    let _e360 = phi_637_;
                    let _e362 = phi_638_;
                    phi_470_ = _e356;
                    phi_473_ = _e358;
                    phi_475_ = _e360;
                    phi_639_ = _e362;
                } else {
                    phi_470_ = lt_math_LightPoint();
                    phi_473_ = u32();
                    phi_475_ = lt_math_LevelPoint();
                    phi_639_ = false;
                }
                let _e364 = phi_470_;
                let _e366 = phi_473_;
                let _e368 = phi_475_;
                let _e370 = phi_639_;
                continue;
                continuing {
                    phi_469_ = _e364;
                    phi_472_ = _e366;
                    phi_474_ = _e368;
                    break if !(_e370);
                }
            }
            let _e373 = local_1;
            if _e373.point.is_inside {
                if (0f > 0f) {
                    let _e379 = local_2;
                    if (_e379.level < _e52) {
                    } else {
                        return;
                    }
                    let _e384 = levels.member[(0u + _e379.level)];
                    let _e390 = global[0u];
                    if (_e384.row_w.x == _e390) {
                        let _e393 = global[1u];
                        if (_e384.row_w.y == _e393) {
                            let _e396 = global[2u];
                            phi_679_ = (_e384.row_w.z == _e396);
                            phi_680_ = false;
                        } else {
                            phi_679_ = bool();
                            phi_680_ = true;
                        }
                        let _e399 = phi_679_;
                        let _e401 = phi_680_;
                        phi_681_ = _e399;
                        phi_682_ = _e401;
                    } else {
                        phi_681_ = bool();
                        phi_682_ = true;
                    }
                    let _e403 = phi_681_;
                    let _e405 = phi_682_;
                    if _e405 {
                        phi_686_ = false;
                    } else {
                        phi_686_ = _e403;
                    }
                    let _e407 = phi_686_;
                    if _e407 {
                        let _e409 = samples.member[(0u + _e58.first_primitive)].normal;
                        let _e411 = p.member.map_size;
                        let _e481 = ((abs(((((_e384.row_x.x * _e409.x) + (_e384.row_x.y * _e409.y)) + (_e384.row_x.z * _e409.z)) / (((_e384.row_x.x * _e384.row_x.x) + (_e384.row_x.y * _e384.row_x.y)) + (_e384.row_x.z * _e384.row_x.z)))) + abs(((((_e384.row_y.x * _e409.x) + (_e384.row_y.y * _e409.y)) + (_e384.row_y.z * _e409.z)) / (((_e384.row_y.x * _e384.row_y.x) + (_e384.row_y.y * _e384.row_y.y)) + (_e384.row_y.z * _e384.row_y.z))))) / (abs(((((_e384.row_z.x * _e409.x) + (_e384.row_z.y * _e409.y)) + (_e384.row_z.z * _e409.z)) / (((_e384.row_z.x * _e384.row_z.x) + (_e384.row_z.y * _e384.row_z.y)) + (_e384.row_z.z * _e384.row_z.z)))) * f32(_e411)));
                        if (_e481 < 0.002f) {
                            phi_768_ = _e481;
                        } else {
                            phi_768_ = 0.002f;
                        }
                        let _e484 = phi_768_;
                        phi_885_ = _e484;
                    } else {
                        let _e486 = p.member.map_size;
                        let _e492 = samples.member[(0u + _e58.first_primitive)].position;
                        let _e503 = ((((_e384.row_w.x * _e492.x) + (_e384.row_w.y * _e492.y)) + (_e384.row_w.z * _e492.z)) + _e384.row_w.w);
                        let _e516 = ((_e384.row_x.x - (_e384.row_w.x * _e373.point.uv.x)) / _e503);
                        let _e517 = ((_e384.row_x.y - (_e384.row_w.y * _e373.point.uv.x)) / _e503);
                        let _e518 = ((_e384.row_x.z - (_e384.row_w.z * _e373.point.uv.x)) / _e503);
                        let _e531 = ((_e384.row_y.x - (_e384.row_w.x * _e373.point.uv.y)) / _e503);
                        let _e532 = ((_e384.row_y.y - (_e384.row_w.y * _e373.point.uv.y)) / _e503);
                        let _e533 = ((_e384.row_y.z - (_e384.row_w.z * _e373.point.uv.y)) / _e503);
                        let _e539 = samples.member[(0u + _e58.first_primitive)].normal;
                        let _e544 = ((_e532 * _e539.z) - (_e539.y * _e533));
                        let _e549 = ((_e533 * _e539.x) - (_e539.z * _e531));
                        let _e554 = ((_e531 * _e539.y) - (_e539.x * _e532));
                        let _e556 = samples.member[(0u + _e58.first_primitive)].normal;
                        let _e561 = ((_e517 * _e556.z) - (_e556.y * _e518));
                        let _e566 = ((_e518 * _e556.x) - (_e556.z * _e516));
                        let _e571 = ((_e516 * _e556.y) - (_e556.x * _e517));
                        let _e598 = ((abs(((((_e384.row_z.x * _e544) + (_e384.row_z.y * _e549)) + (_e384.row_z.z * _e554)) / (((_e516 * _e544) + (_e517 * _e549)) + (_e518 * _e554)))) + abs(((((_e384.row_z.x * _e561) + (_e384.row_z.y * _e566)) + (_e384.row_z.z * _e571)) / (((_e531 * _e561) + (_e532 * _e566)) + (_e533 * _e571))))) / f32(_e486));
                        if (_e598 < 0.002f) {
                            phi_884_ = _e598;
                        } else {
                            phi_884_ = 0.002f;
                        }
                        let _e601 = phi_884_;
                        phi_885_ = _e601;
                    }
                    let _e603 = phi_885_;
                    phi_888_ = (_e373.point.depth - (0f * _e603));
                } else {
                    phi_888_ = _e373.point.depth;
                }
                let _e607 = phi_888_;
                let _e613 = p.member.map_size;
                let _e614 = f32(_e613);
                let _e617 = ((_e373.point.uv.x * _e614) - 0.5f);
                let _e618 = ((_e373.point.uv.y * _e614) - 0.5f);
                if (_e617 > -8388608f) {
                    let _e630 = f32(select(0i, select(select(i32(_e617), i32(-2147483648), (_e617 < bitcast<f32>(3472883712u))), 2147483647i, (_e617 > bitcast<f32>(1325400063u))), (_e617 == _e617)));
                    if (_e630 > _e617) {
                        phi_917_ = 1f;
                    } else {
                        phi_917_ = 0f;
                    }
                    let _e633 = phi_917_;
                    if (_e617 < 8388608f) {
                        phi_922_ = (_e630 - _e633);
                        phi_923_ = false;
                    } else {
                        phi_922_ = f32();
                        phi_923_ = true;
                    }
                    let _e636 = phi_922_;
                    let _e638 = phi_923_;
                    phi_924_ = _e636;
                    phi_925_ = _e638;
                } else {
                    phi_924_ = f32();
                    phi_925_ = true;
                }
                let _e640 = phi_924_;
                let _e642 = phi_925_;
                if _e642 {
                    phi_929_ = _e617;
                } else {
                    phi_929_ = _e640;
                }
                let _e644 = phi_929_;
                if (_e618 > -8388608f) {
                    let _e656 = f32(select(0i, select(select(i32(_e618), i32(-2147483648), (_e618 < bitcast<f32>(3472883712u))), 2147483647i, (_e618 > bitcast<f32>(1325400063u))), (_e618 == _e618)));
                    if (_e656 > _e618) {
                        phi_949_ = 1f;
                    } else {
                        phi_949_ = 0f;
                    }
                    let _e659 = phi_949_;
                    if (_e618 < 8388608f) {
                        phi_954_ = (_e656 - _e659);
                        phi_955_ = false;
                    } else {
                        phi_954_ = f32();
                        phi_955_ = true;
                    }
                    let _e662 = phi_954_;
                    let _e664 = phi_955_;
                    phi_956_ = _e662;
                    phi_957_ = _e664;
                } else {
                    phi_956_ = f32();
                    phi_957_ = true;
                }
                let _e666 = phi_956_;
                let _e668 = phi_957_;
                if _e668 {
                    phi_961_ = _e618;
                } else {
                    phi_961_ = _e666;
                }
                let _e670 = phi_961_;
                let _e671 = (_e617 - _e644);
                let _e672 = (_e618 - _e670);
                let _e681 = select(0i, select(select(i32(_e644), i32(-2147483648), (_e644 < bitcast<f32>(3472883712u))), 2147483647i, (_e644 > bitcast<f32>(1325400063u))), (_e644 == _e644));
                let _e690 = select(0i, select(select(i32(_e670), i32(-2147483648), (_e670 < bitcast<f32>(3472883712u))), 2147483647i, (_e670 > bitcast<f32>(1325400063u))), (_e670 == _e670));
                let _e701 = p.member.test;
                let _e702 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e701);
                let _e704 = p.member.map_size;
                let _e706 = local_3;
                local = _e702;
                let _e709 = ((_e706.level * _e704) * _e704);
                let _e711 = (bitcast<i32>(_e704) - 1i);
                if (_e681 > 0i) {
                    phi_1010_ = _e681;
                } else {
                    phi_1010_ = 0i;
                }
                let _e714 = phi_1010_;
                if (_e690 > 0i) {
                    phi_1015_ = _e690;
                } else {
                    phi_1015_ = 0i;
                }
                let _e717 = phi_1015_;
                if (_e714 < _e711) {
                    phi_1020_ = _e714;
                } else {
                    phi_1020_ = _e711;
                }
                let _e720 = phi_1020_;
                if (_e717 < _e711) {
                    phi_1025_ = _e717;
                } else {
                    phi_1025_ = _e711;
                }
                let _e723 = phi_1025_;
                let _e724 = bitcast<u32>(_e720);
                let _e726 = (_e681 + 1i);
                let _e727 = (_e690 + 1i);
                if (_e726 > 0i) {
                    phi_1034_ = _e726;
                } else {
                    phi_1034_ = 0i;
                }
                let _e730 = phi_1034_;
                if (_e727 > 0i) {
                    phi_1039_ = _e727;
                } else {
                    phi_1039_ = 0i;
                }
                let _e733 = phi_1039_;
                if (_e730 < _e711) {
                    phi_1044_ = _e730;
                } else {
                    phi_1044_ = _e711;
                }
                let _e736 = phi_1044_;
                if (_e733 < _e711) {
                    phi_1049_ = _e733;
                } else {
                    phi_1049_ = _e711;
                }
                let _e739 = phi_1049_;
                let _e740 = bitcast<u32>(_e736);
                let _e742 = (bitcast<u32>(_e723) * _e704);
                let _e743 = (bitcast<u32>(_e739) * _e704);
                let _e748 = ((_e742 + _e724) + _e709);
                let _e749 = ((_e742 + _e740) + _e709);
                let _e750 = ((_e743 + _e724) + _e709);
                let _e751 = ((_e743 + _e740) + _e709);
                if (_e748 < _e46) {
                } else {
                    return;
                }
                let _e755 = map.member[(0u + _e748)];
                if (_e749 < _e46) {
                } else {
                    return;
                }
                let _e759 = map.member[(0u + _e749)];
                if (_e750 < _e46) {
                } else {
                    return;
                }
                let _e763 = map.member[(0u + _e750)];
                if (_e751 < _e46) {
                } else {
                    return;
                }
                let _e767 = map.member[(0u + _e751)];
                let _e769 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e755, _e759, _e763, _e767), vec4<f32>(((1f - _e671) * (1f - _e672)), (_e671 * (1f - _e672)), ((1f - _e671) * _e672), (_e671 * _e672)), _e607);
                let _e771 = p.member.epsilon;
                if (_e769 <= _e771) {
                    phi_1100_ = true;
                } else {
                    phi_1100_ = (_e769 >= (1f - _e771));
                }
                let _e776 = phi_1100_;
                if ((bitcast<u32>(_e769) & 2147483647u) > 2139095040u) {
                    phi_1108_ = true;
                } else {
                    phi_1108_ = !(_e776);
                }
                let _e782 = phi_1108_;
                if _e782 {
                    if (_e769 > 0f) {
                        if (_e769 < 1f) {
                            phi_1120_ = false;
                        } else {
                            phi_1120_ = true;
                        }
                        let _e786 = phi_1120_;
                        phi_1121_ = _e786;
                    } else {
                        phi_1121_ = true;
                    }
                    let _e788 = phi_1121_;
                    if _e788 {
                        phi_1125_ = 0.5f;
                    } else {
                        phi_1125_ = _e769;
                    }
                    let _e790 = phi_1125_;
                    phi_1133_ = evaluate_Verdict(_e790, true);
                } else {
                    if (_e769 > 0.5f) {
                        phi_1131_ = 1f;
                    } else {
                        phi_1131_ = 0f;
                    }
                    let _e794 = phi_1131_;
                    phi_1133_ = evaluate_Verdict(_e794, false);
                }
                let _e797 = phi_1133_;
                phi_1138_ = evaluate_Verdict(_e797.visibility, _e797.is_doubted);
            } else {
                phi_1138_ = evaluate_Verdict(0.5f, true);
            }
            let _e803 = phi_1138_;
            phi_1139_ = _e803;
        }
        let _e805 = phi_1139_;
        if (_e58.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e58.first_primitive)] = _e805.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_vsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
