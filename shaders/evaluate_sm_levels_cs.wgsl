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
    var phi_145_: lt_bvh_traverse_Tree;
    var phi_146_: bool;
    var phi_147_: lt_bvh_traverse_Tree;
    var phi_148_: bool;
    var phi_153_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_145_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_146_ = false;
        } else {
            phi_145_ = lt_bvh_traverse_Tree();
            phi_146_ = true;
        }
        let _e52 = phi_145_;
        let _e54 = phi_146_;
        phi_147_ = _e52;
        phi_148_ = _e54;
    } else {
        phi_147_ = lt_bvh_traverse_Tree();
        phi_148_ = true;
    }
    let _e56 = phi_147_;
    let _e58 = phi_148_;
    if _e58 {
        phi_153_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_153_ = _e56;
    }
    let _e63 = phi_153_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_249_: f32;
    var phi_250_: f32;
    var phi_251_: f32;
    var phi_268_: f32;
    var phi_269_: f32;
    var phi_270_: f32;

    let _e43 = (*param_4);
    let _e44 = (param_5.x + _e43);
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_251_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_250_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_249_ = 1f;
            } else {
                phi_249_ = param_6;
            }
            let _e51 = phi_249_;
            phi_250_ = _e51;
        }
        let _e53 = phi_250_;
        phi_251_ = _e53;
    }
    let _e55 = phi_251_;
    if ((bitcast<u32>(_e44) & 2147483647u) > 2139095040u) {
        phi_270_ = _e44;
    } else {
        if ((bitcast<u32>(_e55) & 2147483647u) > 2139095040u) {
            phi_269_ = _e55;
        } else {
            if (_e44 < _e55) {
                phi_268_ = 0f;
            } else {
                phi_268_ = 1f;
            }
            let _e64 = phi_268_;
            phi_269_ = _e64;
        }
        let _e66 = phi_269_;
        phi_270_ = _e66;
    }
    let _e68 = phi_270_;
    return _e68;
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_7: f32) -> vec4<f32> {
    var phi_224_: f32;
    var phi_225_: f32;
    var phi_226_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_226_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_225_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_224_ = 1f;
            } else {
                phi_224_ = param_7;
            }
            let _e46 = phi_224_;
            phi_225_ = _e46;
        }
        let _e48 = phi_225_;
        phi_226_ = _e48;
    }
    let _e50 = phi_226_;
    return vec4<f32>(_e50, 0f, 0f, 0f);
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_8: ptr<function, f32>, param_9: vec4<f32>, param_10: vec4<f32>, param_11: f32) -> f32 {
    var phi_187_: f32;
    var phi_188_: f32;
    var phi_196_: f32;
    var phi_197_: f32;
    var phi_204_: f32;
    var phi_207_: f32;

    let _e49 = (((param_10.x + param_10.y) + param_10.z) + param_10.w);
    if ((bitcast<u32>(_e49) & 2147483647u) > 2139095040u) {
        phi_207_ = _e49;
    } else {
        if (param_10.y > param_10.x) {
            phi_187_ = param_9.y;
            phi_188_ = param_10.y;
        } else {
            phi_187_ = param_9.x;
            phi_188_ = param_10.x;
        }
        let _e60 = phi_187_;
        let _e62 = phi_188_;
        if (param_10.z > _e62) {
            phi_196_ = param_9.z;
            phi_197_ = param_10.z;
        } else {
            phi_196_ = _e60;
            phi_197_ = _e62;
        }
        let _e68 = phi_196_;
        let _e70 = phi_197_;
        if (param_10.w > _e70) {
            phi_204_ = param_9.w;
        } else {
            phi_204_ = _e68;
        }
        let _e75 = phi_204_;
        let _e76 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e75);
        let _e77 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_8, _e76, param_11);
        phi_207_ = _e77;
    }
    let _e79 = phi_207_;
    return _e79;
}

fn function_() {
    var local: f32;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_333_: bool;
    var phi_337_: bool;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_419_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_420_: bool;
    var phi_421_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_422_: bool;
    var phi_429_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_433_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_453_: lt_math_LightPoint;
    var phi_456_: u32;
    var phi_458_: lt_math_LevelPoint;
    var phi_544_: bool;
    var phi_553_: bool;
    var phi_562_: bool;
    var phi_563_: bool;
    var phi_564_: bool;
    var phi_565_: bool;
    var phi_566_: bool;
    var phi_567_: bool;
    var phi_568_: bool;
    var phi_572_: bool;
    var phi_599_: bool;
    var phi_600_: bool;
    var phi_601_: bool;
    var phi_602_: bool;
    var phi_603_: bool;
    var phi_604_: bool;
    var phi_605_: bool;
    var phi_606_: bool;
    var phi_610_: bool;
    var phi_619_: lt_math_LightPoint;
    var phi_620_: u32;
    var phi_621_: lt_math_LevelPoint;
    var phi_622_: bool;
    var phi_454_: lt_math_LightPoint;
    var phi_457_: u32;
    var phi_459_: lt_math_LevelPoint;
    var phi_623_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_670_: bool;
    var phi_752_: f32;
    var phi_870_: f32;
    var phi_871_: f32;
    var phi_874_: f32;
    var phi_903_: f32;
    var phi_908_: f32;
    var phi_909_: bool;
    var phi_910_: f32;
    var phi_911_: bool;
    var phi_915_: f32;
    var phi_935_: f32;
    var phi_940_: f32;
    var phi_941_: bool;
    var phi_942_: f32;
    var phi_943_: bool;
    var phi_947_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_996_: i32;
    var phi_1001_: i32;
    var phi_1006_: i32;
    var phi_1011_: i32;
    var phi_1020_: i32;
    var phi_1025_: i32;
    var phi_1030_: i32;
    var phi_1035_: i32;
    var phi_1080_: evaluate_Verdict;
    var phi_1081_: evaluate_Verdict;
    var phi_1082_: bool;
    var phi_1083_: evaluate_Verdict;
    var phi_1084_: evaluate_Verdict;
    var phi_1085_: bool;
    var phi_1089_: evaluate_Verdict;

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
                phi_330_ = (_e82 == _e84);
                phi_331_ = false;
            } else {
                phi_330_ = bool();
                phi_331_ = true;
            }
            let _e87 = phi_330_;
            let _e89 = phi_331_;
            phi_332_ = _e87;
            phi_333_ = _e89;
        } else {
            phi_332_ = bool();
            phi_333_ = true;
        }
        let _e91 = phi_332_;
        let _e93 = phi_333_;
        if _e93 {
            phi_337_ = false;
        } else {
            phi_337_ = _e91;
        }
        let _e95 = phi_337_;
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
                    phi_408_ = true;
                } else {
                    let _e148 = p.member.light.range_squared;
                    if (_e131 <= _e148) {
                        let _e151 = p.member.light.cos_outer;
                        phi_407_ = (-((((_e113 * _e133.x) + (_e114 * _e133.y)) + (_e115 * _e133.z))) >= (_e151 * sqrt(_e131)));
                    } else {
                        phi_407_ = false;
                    }
                    let _e156 = phi_407_;
                    phi_408_ = _e156;
                }
                let _e158 = phi_408_;
                if _e158 {
                    let _e160 = samples.member[(0u + _e59.first_primitive)].flags;
                    let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                    phi_419_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, ((_e160 & 1u) == 0u));
                    phi_420_ = false;
                } else {
                    phi_419_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_420_ = true;
                }
                let _e179 = phi_419_;
                let _e181 = phi_420_;
                phi_421_ = _e179;
                phi_422_ = _e181;
            } else {
                phi_421_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_422_ = true;
            }
            let _e183 = phi_421_;
            let _e185 = phi_422_;
            if _e185 {
                let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                phi_429_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, true);
            } else {
                phi_429_ = _e183;
            }
            let _e202 = phi_429_;
            phi_433_ = _e202;
        } else {
            let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
            phi_433_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
        }
        let _e219 = phi_433_;
        if _e219.unnamed_1 {
            phi_1083_ = evaluate_Verdict(_e219.unnamed.visibility, _e219.unnamed.is_doubted);
            phi_1084_ = evaluate_Verdict();
            phi_1085_ = true;
        } else {
            let _e227 = samples.member[(0u + _e59.first_primitive)].position;
            let _e229 = p.member.map_size;
            let _e231 = (0.5f / f32(_e229));
            let _e238 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e245 = lt_math_LightPoint(vec2<f32>(_e238.uv.x, 0f), _e238.depth, _e238.is_inside);
            let _e249 = lt_math_LightPoint(_e245.uv, 0f, _e245.is_inside);
            phi_453_ = lt_math_LightPoint();
            phi_456_ = 0u;
            phi_458_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e249.uv, _e249.depth, false));
            loop {
                let _e256 = phi_453_;
                let _e258 = phi_456_;
                let _e260 = phi_458_;
                local_1 = _e260;
                local_2 = _e260;
                local_3 = _e260;
                if (_e258 < _e65) {
                    if _e260.point.is_inside {
                        phi_619_ = lt_math_LightPoint();
                        phi_620_ = u32();
                        phi_621_ = lt_math_LevelPoint();
                        phi_622_ = false;
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
                                phi_544_ = (_e296 <= 1f);
                            } else {
                                phi_544_ = false;
                            }
                            let _e328 = phi_544_;
                            if _e328 {
                                if (_e310 >= 0f) {
                                    phi_553_ = (_e310 <= 1f);
                                } else {
                                    phi_553_ = false;
                                }
                                let _e332 = phi_553_;
                                if _e332 {
                                    if (_e323 >= 0f) {
                                        phi_562_ = (_e323 <= 1f);
                                    } else {
                                        phi_562_ = false;
                                    }
                                    let _e336 = phi_562_;
                                    phi_563_ = _e336;
                                    phi_564_ = false;
                                } else {
                                    phi_563_ = bool();
                                    phi_564_ = true;
                                }
                                let _e338 = phi_563_;
                                let _e340 = phi_564_;
                                phi_565_ = _e338;
                                phi_566_ = _e340;
                            } else {
                                phi_565_ = bool();
                                phi_566_ = true;
                            }
                            let _e342 = phi_565_;
                            let _e344 = phi_566_;
                            phi_567_ = _e342;
                            phi_568_ = _e344;
                        } else {
                            phi_567_ = bool();
                            phi_568_ = true;
                        }
                        let _e346 = phi_567_;
                        let _e348 = phi_568_;
                        if _e348 {
                            phi_572_ = false;
                        } else {
                            phi_572_ = _e346;
                        }
                        let _e350 = phi_572_;
                        if _e350 {
                            if (_e296 >= _e231) {
                                if (_e296 <= (1f - _e231)) {
                                    if (_e310 >= _e231) {
                                        phi_599_ = (_e310 <= (1f - _e231));
                                        phi_600_ = false;
                                    } else {
                                        phi_599_ = bool();
                                        phi_600_ = true;
                                    }
                                    let _e358 = phi_599_;
                                    let _e360 = phi_600_;
                                    phi_601_ = _e358;
                                    phi_602_ = _e360;
                                } else {
                                    phi_601_ = bool();
                                    phi_602_ = true;
                                }
                                let _e362 = phi_601_;
                                let _e364 = phi_602_;
                                phi_603_ = _e362;
                                phi_604_ = _e364;
                            } else {
                                phi_603_ = bool();
                                phi_604_ = true;
                            }
                            let _e366 = phi_603_;
                            let _e368 = phi_604_;
                            phi_605_ = _e366;
                            phi_606_ = _e368;
                        } else {
                            phi_605_ = bool();
                            phi_606_ = true;
                        }
                        let _e370 = phi_605_;
                        let _e372 = phi_606_;
                        if _e372 {
                            phi_610_ = false;
                        } else {
                            phi_610_ = _e370;
                        }
                        let _e374 = phi_610_;
                        let _e381 = lt_math_LightPoint(vec2<f32>(_e296, _e256.uv.y), _e256.depth, _e256.is_inside);
                        let _e388 = lt_math_LightPoint(vec2<f32>(_e381.uv.x, _e310), _e381.depth, _e381.is_inside);
                        let _e392 = lt_math_LightPoint(_e388.uv, _e323, _e388.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e392.depth, _e374);
                        phi_619_ = _e396;
                        phi_620_ = (_e258 + 1u);
                        phi_621_ = lt_math_LevelPoint(_e258, _e396);
                        phi_622_ = true;
                    }
                    let _e400 = phi_619_;
                    let _e402 = phi_620_;
                    let _e404 = phi_621_;
                    let _e406 = phi_622_;
                    phi_454_ = _e400;
                    phi_457_ = _e402;
                    phi_459_ = _e404;
                    phi_623_ = _e406;
                } else {
                    phi_454_ = lt_math_LightPoint();
                    phi_457_ = u32();
                    phi_459_ = lt_math_LevelPoint();
                    phi_623_ = false;
                }
                let _e408 = phi_454_;
                let _e410 = phi_457_;
                let _e412 = phi_459_;
                let _e414 = phi_623_;
                continue;
                continuing {
                    phi_453_ = _e408;
                    phi_456_ = _e410;
                    phi_458_ = _e412;
                    break if !(_e414);
                }
            }
            let _e417 = local_1;
            if _e417.point.is_inside {
                if (0.5f > 0f) {
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
                            phi_663_ = (_e428.row_w.z == _e440);
                            phi_664_ = false;
                        } else {
                            phi_663_ = bool();
                            phi_664_ = true;
                        }
                        let _e443 = phi_663_;
                        let _e445 = phi_664_;
                        phi_665_ = _e443;
                        phi_666_ = _e445;
                    } else {
                        phi_665_ = bool();
                        phi_666_ = true;
                    }
                    let _e447 = phi_665_;
                    let _e449 = phi_666_;
                    if _e449 {
                        phi_670_ = false;
                    } else {
                        phi_670_ = _e447;
                    }
                    let _e451 = phi_670_;
                    if _e451 {
                        let _e453 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e455 = p.member.map_size;
                        let _e525 = ((abs(((((_e428.row_x.x * _e453.x) + (_e428.row_x.y * _e453.y)) + (_e428.row_x.z * _e453.z)) / (((_e428.row_x.x * _e428.row_x.x) + (_e428.row_x.y * _e428.row_x.y)) + (_e428.row_x.z * _e428.row_x.z)))) + abs(((((_e428.row_y.x * _e453.x) + (_e428.row_y.y * _e453.y)) + (_e428.row_y.z * _e453.z)) / (((_e428.row_y.x * _e428.row_y.x) + (_e428.row_y.y * _e428.row_y.y)) + (_e428.row_y.z * _e428.row_y.z))))) / (abs(((((_e428.row_z.x * _e453.x) + (_e428.row_z.y * _e453.y)) + (_e428.row_z.z * _e453.z)) / (((_e428.row_z.x * _e428.row_z.x) + (_e428.row_z.y * _e428.row_z.y)) + (_e428.row_z.z * _e428.row_z.z)))) * f32(_e455)));
                        if (_e525 < 0.002f) {
                            phi_752_ = _e525;
                        } else {
                            phi_752_ = 0.002f;
                        }
                        let _e528 = phi_752_;
                        phi_871_ = _e528;
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
                            phi_870_ = _e642;
                        } else {
                            phi_870_ = _e644;
                        }
                        let _e647 = phi_870_;
                        phi_871_ = _e647;
                    }
                    let _e649 = phi_871_;
                    phi_874_ = (_e417.point.depth - (0.5f * _e649));
                } else {
                    phi_874_ = _e417.point.depth;
                }
                let _e653 = phi_874_;
                let _e659 = p.member.map_size;
                let _e660 = f32(_e659);
                let _e663 = ((_e417.point.uv.x * _e660) - 0.5f);
                let _e664 = ((_e417.point.uv.y * _e660) - 0.5f);
                if (_e663 > -8388608f) {
                    let _e676 = f32(select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < bitcast<f32>(3472883712u))), 2147483647i, (_e663 > bitcast<f32>(1325400063u))), (_e663 == _e663)));
                    if (_e676 > _e663) {
                        phi_903_ = 1f;
                    } else {
                        phi_903_ = 0f;
                    }
                    let _e679 = phi_903_;
                    if (_e663 < 8388608f) {
                        phi_908_ = (_e676 - _e679);
                        phi_909_ = false;
                    } else {
                        phi_908_ = f32();
                        phi_909_ = true;
                    }
                    let _e682 = phi_908_;
                    let _e684 = phi_909_;
                    phi_910_ = _e682;
                    phi_911_ = _e684;
                } else {
                    phi_910_ = f32();
                    phi_911_ = true;
                }
                let _e686 = phi_910_;
                let _e688 = phi_911_;
                if _e688 {
                    phi_915_ = _e663;
                } else {
                    phi_915_ = _e686;
                }
                let _e690 = phi_915_;
                if (_e664 > -8388608f) {
                    let _e702 = f32(select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < bitcast<f32>(3472883712u))), 2147483647i, (_e664 > bitcast<f32>(1325400063u))), (_e664 == _e664)));
                    if (_e702 > _e664) {
                        phi_935_ = 1f;
                    } else {
                        phi_935_ = 0f;
                    }
                    let _e705 = phi_935_;
                    if (_e664 < 8388608f) {
                        phi_940_ = (_e702 - _e705);
                        phi_941_ = false;
                    } else {
                        phi_940_ = f32();
                        phi_941_ = true;
                    }
                    let _e708 = phi_940_;
                    let _e710 = phi_941_;
                    phi_942_ = _e708;
                    phi_943_ = _e710;
                } else {
                    phi_942_ = f32();
                    phi_943_ = true;
                }
                let _e712 = phi_942_;
                let _e714 = phi_943_;
                if _e714 {
                    phi_947_ = _e664;
                } else {
                    phi_947_ = _e712;
                }
                let _e716 = phi_947_;
                let _e717 = (_e663 - _e690);
                let _e718 = (_e664 - _e716);
                let _e727 = select(0i, select(select(i32(_e690), i32(-2147483648), (_e690 < bitcast<f32>(3472883712u))), 2147483647i, (_e690 > bitcast<f32>(1325400063u))), (_e690 == _e690));
                let _e736 = select(0i, select(select(i32(_e716), i32(-2147483648), (_e716 < bitcast<f32>(3472883712u))), 2147483647i, (_e716 > bitcast<f32>(1325400063u))), (_e716 == _e716));
                let _e747 = p.member.test;
                let _e748 = _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e747);
                let _e750 = p.member.map_size;
                let _e752 = local_3;
                local = _e748;
                let _e755 = ((_e752.level * _e750) * _e750);
                let _e757 = (bitcast<i32>(_e750) - 1i);
                if (_e727 > 0i) {
                    phi_996_ = _e727;
                } else {
                    phi_996_ = 0i;
                }
                let _e760 = phi_996_;
                if (_e736 > 0i) {
                    phi_1001_ = _e736;
                } else {
                    phi_1001_ = 0i;
                }
                let _e763 = phi_1001_;
                if (_e760 < _e757) {
                    phi_1006_ = _e760;
                } else {
                    phi_1006_ = _e757;
                }
                let _e766 = phi_1006_;
                if (_e763 < _e757) {
                    phi_1011_ = _e763;
                } else {
                    phi_1011_ = _e757;
                }
                let _e769 = phi_1011_;
                let _e770 = bitcast<u32>(_e766);
                let _e772 = (_e727 + 1i);
                let _e773 = (_e736 + 1i);
                if (_e772 > 0i) {
                    phi_1020_ = _e772;
                } else {
                    phi_1020_ = 0i;
                }
                let _e776 = phi_1020_;
                if (_e773 > 0i) {
                    phi_1025_ = _e773;
                } else {
                    phi_1025_ = 0i;
                }
                let _e779 = phi_1025_;
                if (_e776 < _e757) {
                    phi_1030_ = _e776;
                } else {
                    phi_1030_ = _e757;
                }
                let _e782 = phi_1030_;
                if (_e779 < _e757) {
                    phi_1035_ = _e779;
                } else {
                    phi_1035_ = _e757;
                }
                let _e785 = phi_1035_;
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
                let _e815 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e801, _e805, _e809, _e813), vec4<f32>(((1f - _e717) * (1f - _e718)), (_e717 * (1f - _e718)), ((1f - _e717) * _e718), (_e717 * _e718)), _e653);
                phi_1080_ = evaluate_Verdict(_e815, false);
                phi_1081_ = evaluate_Verdict();
                phi_1082_ = false;
            } else {
                phi_1080_ = evaluate_Verdict();
                phi_1081_ = evaluate_Verdict(1f, false);
                phi_1082_ = true;
            }
            let _e819 = phi_1080_;
            let _e821 = phi_1081_;
            let _e823 = phi_1082_;
            phi_1083_ = _e821;
            phi_1084_ = _e819;
            phi_1085_ = _e823;
        }
        let _e825 = phi_1083_;
        let _e827 = phi_1084_;
        let _e829 = phi_1085_;
        if _e829 {
            phi_1089_ = _e825;
        } else {
            phi_1089_ = _e827;
        }
        let _e831 = phi_1089_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e831.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_sm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
