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
    var phi_147_: lt_bvh_traverse_Tree;
    var phi_148_: bool;
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_155_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_147_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_148_ = false;
        } else {
            phi_147_ = lt_bvh_traverse_Tree();
            phi_148_ = true;
        }
        let _e52 = phi_147_;
        let _e54 = phi_148_;
        phi_149_ = _e52;
        phi_150_ = _e54;
    } else {
        phi_149_ = lt_bvh_traverse_Tree();
        phi_150_ = true;
    }
    let _e56 = phi_149_;
    let _e58 = phi_150_;
    if _e58 {
        phi_155_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_155_ = _e56;
    }
    let _e63 = phi_155_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_251_: f32;
    var phi_252_: f32;
    var phi_253_: f32;
    var phi_270_: f32;
    var phi_271_: f32;
    var phi_272_: f32;

    let _e43 = (*param_4);
    let _e44 = (param_5.x + _e43);
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_253_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_252_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_251_ = 1f;
            } else {
                phi_251_ = param_6;
            }
            let _e51 = phi_251_;
            phi_252_ = _e51;
        }
        let _e53 = phi_252_;
        phi_253_ = _e53;
    }
    let _e55 = phi_253_;
    if ((bitcast<u32>(_e44) & 2147483647u) > 2139095040u) {
        phi_272_ = _e44;
    } else {
        if ((bitcast<u32>(_e55) & 2147483647u) > 2139095040u) {
            phi_271_ = _e55;
        } else {
            if (_e44 < _e55) {
                phi_270_ = 0f;
            } else {
                phi_270_ = 1f;
            }
            let _e64 = phi_270_;
            phi_271_ = _e64;
        }
        let _e66 = phi_271_;
        phi_272_ = _e66;
    }
    let _e68 = phi_272_;
    return _e68;
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_7: f32) -> vec4<f32> {
    var phi_226_: f32;
    var phi_227_: f32;
    var phi_228_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_228_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_227_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_226_ = 1f;
            } else {
                phi_226_ = param_7;
            }
            let _e46 = phi_226_;
            phi_227_ = _e46;
        }
        let _e48 = phi_227_;
        phi_228_ = _e48;
    }
    let _e50 = phi_228_;
    return vec4<f32>(_e50, 0f, 0f, 0f);
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_8: ptr<function, f32>, param_9: vec4<f32>, param_10: vec4<f32>, param_11: f32) -> f32 {
    var phi_189_: f32;
    var phi_190_: f32;
    var phi_198_: f32;
    var phi_199_: f32;
    var phi_206_: f32;
    var phi_209_: f32;

    let _e49 = (((param_10.x + param_10.y) + param_10.z) + param_10.w);
    if ((bitcast<u32>(_e49) & 2147483647u) > 2139095040u) {
        phi_209_ = _e49;
    } else {
        if (param_10.y > param_10.x) {
            phi_189_ = param_9.y;
            phi_190_ = param_10.y;
        } else {
            phi_189_ = param_9.x;
            phi_190_ = param_10.x;
        }
        let _e60 = phi_189_;
        let _e62 = phi_190_;
        if (param_10.z > _e62) {
            phi_198_ = param_9.z;
            phi_199_ = param_10.z;
        } else {
            phi_198_ = _e60;
            phi_199_ = _e62;
        }
        let _e68 = phi_198_;
        let _e70 = phi_199_;
        if (param_10.w > _e70) {
            phi_206_ = param_9.w;
        } else {
            phi_206_ = _e68;
        }
        let _e75 = phi_206_;
        let _e76 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e75);
        let _e77 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_8, _e76, param_11);
        phi_209_ = _e77;
    }
    let _e79 = phi_209_;
    return _e79;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_1147_: f32;

    if (param_12 < param_13) {
        phi_1147_ = param_12;
    } else {
        phi_1147_ = param_13;
    }
    let _e43 = phi_1147_;
    return _e43;
}

fn function_() {
    var local: f32;
    var phi_332_: bool;
    var phi_333_: bool;
    var phi_334_: bool;
    var phi_335_: bool;
    var phi_339_: bool;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_421_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_422_: bool;
    var phi_423_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_424_: bool;
    var phi_431_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_435_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_455_: lt_math_LightPoint;
    var phi_458_: u32;
    var phi_460_: lt_math_LevelPoint;
    var phi_546_: bool;
    var phi_555_: bool;
    var phi_564_: bool;
    var phi_565_: bool;
    var phi_566_: bool;
    var phi_567_: bool;
    var phi_568_: bool;
    var phi_569_: bool;
    var phi_570_: bool;
    var phi_574_: bool;
    var phi_601_: bool;
    var phi_602_: bool;
    var phi_603_: bool;
    var phi_604_: bool;
    var phi_605_: bool;
    var phi_606_: bool;
    var phi_607_: bool;
    var phi_608_: bool;
    var phi_612_: bool;
    var phi_621_: lt_math_LightPoint;
    var phi_622_: u32;
    var phi_623_: lt_math_LevelPoint;
    var phi_624_: bool;
    var phi_456_: lt_math_LightPoint;
    var phi_459_: u32;
    var phi_461_: lt_math_LevelPoint;
    var phi_625_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_672_: bool;
    var phi_754_: f32;
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
    var local_4: lt_math_LevelPoint;
    var phi_1107_: f32;
    var phi_1109_: evaluate_Verdict;
    var phi_1110_: bool;
    var phi_1111_: evaluate_Verdict;
    var phi_1112_: bool;
    var phi_1117_: evaluate_Verdict;
    var phi_1118_: bool;
    var phi_1120_: evaluate_Verdict;
    var phi_1121_: evaluate_Verdict;
    var phi_1122_: bool;
    var phi_1126_: evaluate_Verdict;
    var phi_1127_: evaluate_Verdict;
    var phi_1128_: bool;
    var phi_1132_: evaluate_Verdict;

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
                phi_332_ = (_e82 == _e84);
                phi_333_ = false;
            } else {
                phi_332_ = bool();
                phi_333_ = true;
            }
            let _e87 = phi_332_;
            let _e89 = phi_333_;
            phi_334_ = _e87;
            phi_335_ = _e89;
        } else {
            phi_334_ = bool();
            phi_335_ = true;
        }
        let _e91 = phi_334_;
        let _e93 = phi_335_;
        if _e93 {
            phi_339_ = false;
        } else {
            phi_339_ = _e91;
        }
        let _e95 = phi_339_;
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
                    phi_410_ = true;
                } else {
                    let _e148 = p.member.light.range_squared;
                    if (_e131 <= _e148) {
                        let _e151 = p.member.light.cos_outer;
                        phi_409_ = (-((((_e113 * _e133.x) + (_e114 * _e133.y)) + (_e115 * _e133.z))) >= (_e151 * sqrt(_e131)));
                    } else {
                        phi_409_ = false;
                    }
                    let _e156 = phi_409_;
                    phi_410_ = _e156;
                }
                let _e158 = phi_410_;
                if _e158 {
                    let _e160 = samples.member[(0u + _e59.first_primitive)].flags;
                    let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                    phi_421_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, ((_e160 & 1u) == 0u));
                    phi_422_ = false;
                } else {
                    phi_421_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_422_ = true;
                }
                let _e179 = phi_421_;
                let _e181 = phi_422_;
                phi_423_ = _e179;
                phi_424_ = _e181;
            } else {
                phi_423_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_424_ = true;
            }
            let _e183 = phi_423_;
            let _e185 = phi_424_;
            if _e185 {
                let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                phi_431_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, true);
            } else {
                phi_431_ = _e183;
            }
            let _e202 = phi_431_;
            phi_435_ = _e202;
        } else {
            let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
            phi_435_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
        }
        let _e219 = phi_435_;
        if _e219.unnamed_1 {
            phi_1126_ = evaluate_Verdict(_e219.unnamed.visibility, _e219.unnamed.is_doubted);
            phi_1127_ = evaluate_Verdict();
            phi_1128_ = true;
        } else {
            let _e227 = samples.member[(0u + _e59.first_primitive)].position;
            let _e229 = p.member.map_size;
            let _e231 = (0.5f / f32(_e229));
            let _e238 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e245 = lt_math_LightPoint(vec2<f32>(_e238.uv.x, 0f), _e238.depth, _e238.is_inside);
            let _e249 = lt_math_LightPoint(_e245.uv, 0f, _e245.is_inside);
            phi_455_ = lt_math_LightPoint();
            phi_458_ = 0u;
            phi_460_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e249.uv, _e249.depth, false));
            loop {
                let _e256 = phi_455_;
                let _e258 = phi_458_;
                let _e260 = phi_460_;
                local_1 = _e260;
                local_2 = _e260;
                local_3 = _e260;
                local_4 = _e260;
                if (_e258 < _e65) {
                    if _e260.point.is_inside {
                        phi_621_ = lt_math_LightPoint();
                        phi_622_ = u32();
                        phi_623_ = lt_math_LevelPoint();
                        phi_624_ = false;
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
                                phi_546_ = (_e296 <= 1f);
                            } else {
                                phi_546_ = false;
                            }
                            let _e328 = phi_546_;
                            if _e328 {
                                if (_e310 >= 0f) {
                                    phi_555_ = (_e310 <= 1f);
                                } else {
                                    phi_555_ = false;
                                }
                                let _e332 = phi_555_;
                                if _e332 {
                                    if (_e323 >= 0f) {
                                        phi_564_ = (_e323 <= 1f);
                                    } else {
                                        phi_564_ = false;
                                    }
                                    let _e336 = phi_564_;
                                    phi_565_ = _e336;
                                    phi_566_ = false;
                                } else {
                                    phi_565_ = bool();
                                    phi_566_ = true;
                                }
                                let _e338 = phi_565_;
                                let _e340 = phi_566_;
                                phi_567_ = _e338;
                                phi_568_ = _e340;
                            } else {
                                phi_567_ = bool();
                                phi_568_ = true;
                            }
                            let _e342 = phi_567_;
                            let _e344 = phi_568_;
                            phi_569_ = _e342;
                            phi_570_ = _e344;
                        } else {
                            phi_569_ = bool();
                            phi_570_ = true;
                        }
                        let _e346 = phi_569_;
                        let _e348 = phi_570_;
                        if _e348 {
                            phi_574_ = false;
                        } else {
                            phi_574_ = _e346;
                        }
                        let _e350 = phi_574_;
                        if _e350 {
                            if (_e296 >= _e231) {
                                if (_e296 <= (1f - _e231)) {
                                    if (_e310 >= _e231) {
                                        phi_601_ = (_e310 <= (1f - _e231));
                                        phi_602_ = false;
                                    } else {
                                        phi_601_ = bool();
                                        phi_602_ = true;
                                    }
                                    let _e358 = phi_601_;
                                    let _e360 = phi_602_;
                                    phi_603_ = _e358;
                                    phi_604_ = _e360;
                                } else {
                                    phi_603_ = bool();
                                    phi_604_ = true;
                                }
                                let _e362 = phi_603_;
                                let _e364 = phi_604_;
                                phi_605_ = _e362;
                                phi_606_ = _e364;
                            } else {
                                phi_605_ = bool();
                                phi_606_ = true;
                            }
                            let _e366 = phi_605_;
                            let _e368 = phi_606_;
                            phi_607_ = _e366;
                            phi_608_ = _e368;
                        } else {
                            phi_607_ = bool();
                            phi_608_ = true;
                        }
                        let _e370 = phi_607_;
                        let _e372 = phi_608_;
                        if _e372 {
                            phi_612_ = false;
                        } else {
                            phi_612_ = _e370;
                        }
                        let _e374 = phi_612_;
                        let _e381 = lt_math_LightPoint(vec2<f32>(_e296, _e256.uv.y), _e256.depth, _e256.is_inside);
                        let _e388 = lt_math_LightPoint(vec2<f32>(_e381.uv.x, _e310), _e381.depth, _e381.is_inside);
                        let _e392 = lt_math_LightPoint(_e388.uv, _e323, _e388.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e392.depth, _e374);
                        phi_621_ = _e396;
                        phi_622_ = (_e258 + 1u);
                        phi_623_ = lt_math_LevelPoint(_e258, _e396);
                        phi_624_ = true;
                    }
                    let _e400 = phi_621_;
                    let _e402 = phi_622_;
                    let _e404 = phi_623_;
                    let _e406 = phi_624_;
                    phi_456_ = _e400;
                    phi_459_ = _e402;
                    phi_461_ = _e404;
                    phi_625_ = _e406;
                } else {
                    phi_456_ = lt_math_LightPoint();
                    phi_459_ = u32();
                    phi_461_ = lt_math_LevelPoint();
                    phi_625_ = false;
                }
                let _e408 = phi_456_;
                let _e410 = phi_459_;
                let _e412 = phi_461_;
                let _e414 = phi_625_;
                continue;
                continuing {
                    phi_455_ = _e408;
                    phi_458_ = _e410;
                    phi_460_ = _e412;
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
                            phi_665_ = (_e428.row_w.z == _e440);
                            phi_666_ = false;
                        } else {
                            phi_665_ = bool();
                            phi_666_ = true;
                        }
                        let _e443 = phi_665_;
                        let _e445 = phi_666_;
                        phi_667_ = _e443;
                        phi_668_ = _e445;
                    } else {
                        phi_667_ = bool();
                        phi_668_ = true;
                    }
                    let _e447 = phi_667_;
                    let _e449 = phi_668_;
                    if _e449 {
                        phi_672_ = false;
                    } else {
                        phi_672_ = _e447;
                    }
                    let _e451 = phi_672_;
                    if _e451 {
                        let _e453 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e455 = p.member.map_size;
                        let _e525 = ((abs(((((_e428.row_x.x * _e453.x) + (_e428.row_x.y * _e453.y)) + (_e428.row_x.z * _e453.z)) / (((_e428.row_x.x * _e428.row_x.x) + (_e428.row_x.y * _e428.row_x.y)) + (_e428.row_x.z * _e428.row_x.z)))) + abs(((((_e428.row_y.x * _e453.x) + (_e428.row_y.y * _e453.y)) + (_e428.row_y.z * _e453.z)) / (((_e428.row_y.x * _e428.row_y.x) + (_e428.row_y.y * _e428.row_y.y)) + (_e428.row_y.z * _e428.row_y.z))))) / (abs(((((_e428.row_z.x * _e453.x) + (_e428.row_z.y * _e453.y)) + (_e428.row_z.z * _e453.z)) / (((_e428.row_z.x * _e428.row_z.x) + (_e428.row_z.y * _e428.row_z.y)) + (_e428.row_z.z * _e428.row_z.z)))) * f32(_e455)));
                        if (_e525 < 0.002f) {
                            phi_754_ = _e525;
                        } else {
                            phi_754_ = 0.002f;
                        }
                        let _e528 = phi_754_;
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
                        if (_e642 < 0.002f) {
                            phi_870_ = _e642;
                        } else {
                            phi_870_ = 0.002f;
                        }
                        let _e645 = phi_870_;
                        phi_871_ = _e645;
                    }
                    let _e647 = phi_871_;
                    phi_874_ = (_e417.point.depth - (0.5f * _e647));
                } else {
                    phi_874_ = _e417.point.depth;
                }
                let _e651 = phi_874_;
                let _e657 = p.member.map_size;
                let _e658 = f32(_e657);
                let _e661 = ((_e417.point.uv.x * _e658) - 0.5f);
                let _e662 = ((_e417.point.uv.y * _e658) - 0.5f);
                if (_e661 > -8388608f) {
                    let _e674 = f32(select(0i, select(select(i32(_e661), i32(-2147483648), (_e661 < bitcast<f32>(3472883712u))), 2147483647i, (_e661 > bitcast<f32>(1325400063u))), (_e661 == _e661)));
                    if (_e674 > _e661) {
                        phi_903_ = 1f;
                    } else {
                        phi_903_ = 0f;
                    }
                    let _e677 = phi_903_;
                    if (_e661 < 8388608f) {
                        phi_908_ = (_e674 - _e677);
                        phi_909_ = false;
                    } else {
                        phi_908_ = f32();
                        phi_909_ = true;
                    }
                    let _e680 = phi_908_;
                    let _e682 = phi_909_;
                    phi_910_ = _e680;
                    phi_911_ = _e682;
                } else {
                    phi_910_ = f32();
                    phi_911_ = true;
                }
                let _e684 = phi_910_;
                let _e686 = phi_911_;
                if _e686 {
                    phi_915_ = _e661;
                } else {
                    phi_915_ = _e684;
                }
                let _e688 = phi_915_;
                if (_e662 > -8388608f) {
                    let _e700 = f32(select(0i, select(select(i32(_e662), i32(-2147483648), (_e662 < bitcast<f32>(3472883712u))), 2147483647i, (_e662 > bitcast<f32>(1325400063u))), (_e662 == _e662)));
                    if (_e700 > _e662) {
                        phi_935_ = 1f;
                    } else {
                        phi_935_ = 0f;
                    }
                    let _e703 = phi_935_;
                    if (_e662 < 8388608f) {
                        phi_940_ = (_e700 - _e703);
                        phi_941_ = false;
                    } else {
                        phi_940_ = f32();
                        phi_941_ = true;
                    }
                    let _e706 = phi_940_;
                    let _e708 = phi_941_;
                    phi_942_ = _e706;
                    phi_943_ = _e708;
                } else {
                    phi_942_ = f32();
                    phi_943_ = true;
                }
                let _e710 = phi_942_;
                let _e712 = phi_943_;
                if _e712 {
                    phi_947_ = _e662;
                } else {
                    phi_947_ = _e710;
                }
                let _e714 = phi_947_;
                let _e715 = (_e661 - _e688);
                let _e716 = (_e662 - _e714);
                let _e725 = select(0i, select(select(i32(_e688), i32(-2147483648), (_e688 < bitcast<f32>(3472883712u))), 2147483647i, (_e688 > bitcast<f32>(1325400063u))), (_e688 == _e688));
                let _e734 = select(0i, select(select(i32(_e714), i32(-2147483648), (_e714 < bitcast<f32>(3472883712u))), 2147483647i, (_e714 > bitcast<f32>(1325400063u))), (_e714 == _e714));
                let _e745 = p.member.test;
                let _e746 = _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e745);
                let _e748 = p.member.map_size;
                let _e750 = local_3;
                local = _e746;
                let _e753 = ((_e750.level * _e748) * _e748);
                let _e755 = (bitcast<i32>(_e748) - 1i);
                if (_e725 > 0i) {
                    phi_996_ = _e725;
                } else {
                    phi_996_ = 0i;
                }
                let _e758 = phi_996_;
                if (_e734 > 0i) {
                    phi_1001_ = _e734;
                } else {
                    phi_1001_ = 0i;
                }
                let _e761 = phi_1001_;
                if (_e758 < _e755) {
                    phi_1006_ = _e758;
                } else {
                    phi_1006_ = _e755;
                }
                let _e764 = phi_1006_;
                if (_e761 < _e755) {
                    phi_1011_ = _e761;
                } else {
                    phi_1011_ = _e755;
                }
                let _e767 = phi_1011_;
                let _e768 = bitcast<u32>(_e764);
                let _e770 = (_e725 + 1i);
                let _e771 = (_e734 + 1i);
                if (_e770 > 0i) {
                    phi_1020_ = _e770;
                } else {
                    phi_1020_ = 0i;
                }
                let _e774 = phi_1020_;
                if (_e771 > 0i) {
                    phi_1025_ = _e771;
                } else {
                    phi_1025_ = 0i;
                }
                let _e777 = phi_1025_;
                if (_e774 < _e755) {
                    phi_1030_ = _e774;
                } else {
                    phi_1030_ = _e755;
                }
                let _e780 = phi_1030_;
                if (_e777 < _e755) {
                    phi_1035_ = _e777;
                } else {
                    phi_1035_ = _e755;
                }
                let _e783 = phi_1035_;
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
                let _e813 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e799, _e803, _e807, _e811), vec4<f32>(((1f - _e715) * (1f - _e716)), (_e715 * (1f - _e716)), ((1f - _e715) * _e716), (_e715 * _e716)), _e651);
                let _e815 = p.member.fade_uv;
                if (_e815 > 0f) {
                    let _e818 = local_4;
                    if ((_e818.level + 1u) == _e65) {
                        let _e827 = p.member.fade_uv;
                        let _e829 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e417.point.uv.x, (1f - _e417.point.uv.x));
                        let _e831 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e417.point.uv.y, (1f - _e417.point.uv.y));
                        let _e832 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e829, _e831);
                        if (_e832 < _e827) {
                            phi_1107_ = (1f - ((1f - _e813) * (_e832 / _e827)));
                        } else {
                            phi_1107_ = _e813;
                        }
                        let _e839 = phi_1107_;
                        phi_1109_ = evaluate_Verdict(_e839, false);
                        phi_1110_ = false;
                    } else {
                        phi_1109_ = evaluate_Verdict();
                        phi_1110_ = true;
                    }
                    let _e842 = phi_1109_;
                    let _e844 = phi_1110_;
                    phi_1111_ = _e842;
                    phi_1112_ = _e844;
                } else {
                    phi_1111_ = evaluate_Verdict();
                    phi_1112_ = true;
                }
                let _e846 = phi_1111_;
                let _e848 = phi_1112_;
                if _e848 {
                    phi_1117_ = evaluate_Verdict(_e813, false);
                    phi_1118_ = false;
                } else {
                    phi_1117_ = evaluate_Verdict();
                    phi_1118_ = true;
                }
                let _e851 = phi_1117_;
                let _e853 = phi_1118_;
                phi_1120_ = _e851;
                phi_1121_ = _e846;
                phi_1122_ = _e853;
            } else {
                phi_1120_ = evaluate_Verdict();
                phi_1121_ = evaluate_Verdict(1f, false);
                phi_1122_ = true;
            }
            let _e856 = phi_1120_;
            let _e858 = phi_1121_;
            let _e860 = phi_1122_;
            if _e860 {
            }
            phi_1126_ = _e858;
            phi_1127_ = _e856;
            phi_1128_ = _e860;
        }
        let _e862 = phi_1126_;
        let _e864 = phi_1127_;
        let _e866 = phi_1128_;
        if _e866 {
            phi_1132_ = _e862;
        } else {
            phi_1132_ = _e864;
        }
        let _e868 = phi_1132_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e868.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_sm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
