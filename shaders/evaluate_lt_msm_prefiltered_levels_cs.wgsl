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
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_41;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_151_: lt_bvh_traverse_Tree;
    var phi_152_: bool;
    var phi_157_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_149_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_150_ = false;
        } else {
            phi_149_ = lt_bvh_traverse_Tree();
            phi_150_ = true;
        }
        let _e52 = phi_149_;
        let _e54 = phi_150_;
        phi_151_ = _e52;
        phi_152_ = _e54;
    } else {
        phi_151_ = lt_bvh_traverse_Tree();
        phi_152_ = true;
    }
    let _e56 = phi_151_;
    let _e58 = phi_152_;
    if _e58 {
        phi_157_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_157_ = _e56;
    }
    let _e63 = phi_157_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_206_: f32;
    var phi_207_: f32;
    var phi_208_: f32;
    var phi_214_: bool;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_239_: f32;
    var phi_240_: bool;
    var phi_241_: f32;
    var phi_242_: bool;
    var phi_280_: vec2<f32>;
    var phi_314_: f32;
    var phi_315_: f32;
    var phi_316_: f32;
    var phi_345_: f32;
    var phi_346_: f32;
    var phi_347_: f32;
    var phi_351_: f32;
    var phi_352_: f32;
    var phi_353_: f32;
    var phi_354_: f32;

    let _e42 = (*param_4);
    let _e43 = (1f - _e42);
    let _e52 = (0.5f * _e42);
    let _e53 = ((param_5.x * _e43) + _e52);
    let _e54 = ((param_5.y * _e43) + _e52);
    let _e56 = ((param_5.w * _e43) + _e52);
    let _e58 = (_e54 - (_e53 * _e53));
    let _e60 = (((param_5.z * _e43) + _e52) - (_e53 * _e54));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_208_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_207_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_206_ = 1f;
            } else {
                phi_206_ = param_6;
            }
            let _e72 = phi_206_;
            phi_207_ = _e72;
        }
        let _e74 = phi_207_;
        phi_208_ = _e74;
    }
    let _e76 = phi_208_;
    if (_e53 == _e56) {
        phi_214_ = (_e53 > 0.5f);
    } else {
        phi_214_ = false;
    }
    let _e80 = phi_214_;
    if _e80 {
        if (_e76 > 0f) {
            if ((bitcast<u32>(_e53) & 2147483647u) > 2139095040u) {
                phi_238_ = _e53;
            } else {
                if (_e53 < 0f) {
                    phi_237_ = 0f;
                } else {
                    if (_e53 > 1f) {
                        phi_236_ = 1f;
                    } else {
                        phi_236_ = _e53;
                    }
                    let _e88 = phi_236_;
                    phi_237_ = _e88;
                }
                let _e90 = phi_237_;
                phi_238_ = _e90;
            }
            let _e92 = phi_238_;
            phi_239_ = _e92;
            phi_240_ = false;
        } else {
            phi_239_ = f32();
            phi_240_ = true;
        }
        let _e94 = phi_239_;
        let _e96 = phi_240_;
        phi_241_ = _e94;
        phi_242_ = _e96;
    } else {
        phi_241_ = f32();
        phi_242_ = true;
    }
    let _e98 = phi_241_;
    let _e100 = phi_242_;
    if _e100 {
        let _e101 = (_e60 / _e58);
        let _e102 = (_e76 - _e53);
        let _e108 = (((((_e76 * _e76) - _e54) - (_e101 * _e102)) * _e58) / (((_e56 - (_e54 * _e54)) * _e58) - (_e60 * _e60)));
        let _e111 = ((_e102 / _e58) - (_e101 * _e108));
        let _e117 = ((0.5f * _e111) / _e108);
        let _e120 = ((_e117 * _e117) - (((1f - (_e111 * _e53)) - (_e108 * _e54)) / _e108));
        if (_e120 >= 0f) {
            let _e122 = sqrt(_e120);
            phi_280_ = vec2<f32>((-(_e117) - _e122), (-(_e117) + _e122));
        } else {
            phi_280_ = vec2(bitcast<f32>((bitcast<u32>(_e120) | 2143289344u)));
        }
        let _e133 = phi_280_;
        if (_e76 <= _e133.x) {
            phi_353_ = 1f;
        } else {
            if (_e76 > _e133.y) {
                let _e146 = (((_e54 - (_e53 * (_e133.x + _e133.y))) + (_e133.x * _e133.y)) / ((_e76 - _e133.x) * (_e76 - _e133.y)));
                if ((bitcast<u32>(_e146) & 2147483647u) > 2139095040u) {
                    phi_316_ = _e146;
                } else {
                    if (_e146 < 0f) {
                        phi_315_ = 0f;
                    } else {
                        if (_e146 > 1f) {
                            phi_314_ = 1f;
                        } else {
                            phi_314_ = _e146;
                        }
                        let _e153 = phi_314_;
                        phi_315_ = _e153;
                    }
                    let _e155 = phi_315_;
                    phi_316_ = _e155;
                }
                let _e157 = phi_316_;
                phi_352_ = _e157;
            } else {
                if (_e76 > _e133.x) {
                    let _e168 = (1f - (((_e54 - (_e53 * (_e76 + _e133.y))) + (_e76 * _e133.y)) / ((_e133.x - _e76) * (_e133.x - _e133.y))));
                    if ((bitcast<u32>(_e168) & 2147483647u) > 2139095040u) {
                        phi_347_ = _e168;
                    } else {
                        if (_e168 < 0f) {
                            phi_346_ = 0f;
                        } else {
                            if (_e168 > 1f) {
                                phi_345_ = 1f;
                            } else {
                                phi_345_ = _e168;
                            }
                            let _e175 = phi_345_;
                            phi_346_ = _e175;
                        }
                        let _e177 = phi_346_;
                        phi_347_ = _e177;
                    }
                    let _e179 = phi_347_;
                    phi_351_ = _e179;
                } else {
                    phi_351_ = bitcast<f32>((bitcast<u32>(_e133.x) | 2143289344u));
                }
                let _e184 = phi_351_;
                phi_352_ = _e184;
            }
            let _e186 = phi_352_;
            phi_353_ = _e186;
        }
        let _e188 = phi_353_;
        phi_354_ = _e188;
    } else {
        phi_354_ = _e98;
    }
    let _e190 = phi_354_;
    return _e190;
}

fn function_() {
    var local: f32;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_417_: bool;
    var phi_421_: bool;
    var phi_491_: bool;
    var phi_492_: bool;
    var phi_503_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_504_: bool;
    var phi_505_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_506_: bool;
    var phi_513_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_517_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_537_: lt_math_LightPoint;
    var phi_540_: u32;
    var phi_542_: lt_math_LevelPoint;
    var phi_628_: bool;
    var phi_637_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_656_: bool;
    var phi_683_: bool;
    var phi_684_: bool;
    var phi_685_: bool;
    var phi_686_: bool;
    var phi_687_: bool;
    var phi_688_: bool;
    var phi_689_: bool;
    var phi_690_: bool;
    var phi_694_: bool;
    var phi_703_: lt_math_LightPoint;
    var phi_704_: u32;
    var phi_705_: lt_math_LevelPoint;
    var phi_706_: bool;
    var phi_538_: lt_math_LightPoint;
    var phi_541_: u32;
    var phi_543_: lt_math_LevelPoint;
    var phi_707_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_747_: bool;
    var phi_748_: bool;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_754_: bool;
    var phi_836_: f32;
    var phi_952_: f32;
    var phi_953_: f32;
    var phi_956_: f32;
    var phi_985_: f32;
    var phi_990_: f32;
    var phi_991_: bool;
    var phi_992_: f32;
    var phi_993_: bool;
    var phi_997_: f32;
    var phi_1017_: f32;
    var phi_1022_: f32;
    var phi_1023_: bool;
    var phi_1024_: f32;
    var phi_1025_: bool;
    var phi_1029_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1078_: i32;
    var phi_1083_: i32;
    var phi_1088_: i32;
    var phi_1093_: i32;
    var phi_1102_: i32;
    var phi_1107_: i32;
    var phi_1112_: i32;
    var phi_1117_: i32;
    var phi_1212_: bool;
    var phi_1220_: bool;
    var phi_1232_: bool;
    var phi_1233_: bool;
    var phi_1237_: f32;
    var phi_1243_: f32;
    var phi_1245_: evaluate_Verdict;
    var phi_1250_: evaluate_Verdict;
    var phi_1251_: evaluate_Verdict;

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
                phi_414_ = (_e82 == _e84);
                phi_415_ = false;
            } else {
                phi_414_ = bool();
                phi_415_ = true;
            }
            let _e87 = phi_414_;
            let _e89 = phi_415_;
            phi_416_ = _e87;
            phi_417_ = _e89;
        } else {
            phi_416_ = bool();
            phi_417_ = true;
        }
        let _e91 = phi_416_;
        let _e93 = phi_417_;
        if _e93 {
            phi_421_ = false;
        } else {
            phi_421_ = _e91;
        }
        let _e95 = phi_421_;
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
                    phi_492_ = true;
                } else {
                    let _e148 = p.member.light.range_squared;
                    if (_e131 <= _e148) {
                        let _e151 = p.member.light.cos_outer;
                        phi_491_ = (-((((_e113 * _e133.x) + (_e114 * _e133.y)) + (_e115 * _e133.z))) >= (_e151 * sqrt(_e131)));
                    } else {
                        phi_491_ = false;
                    }
                    let _e156 = phi_491_;
                    phi_492_ = _e156;
                }
                let _e158 = phi_492_;
                if _e158 {
                    let _e160 = samples.member[(0u + _e59.first_primitive)].flags;
                    let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                    phi_503_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, ((_e160 & 1u) == 0u));
                    phi_504_ = false;
                } else {
                    phi_503_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_504_ = true;
                }
                let _e179 = phi_503_;
                let _e181 = phi_504_;
                phi_505_ = _e179;
                phi_506_ = _e181;
            } else {
                phi_505_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_506_ = true;
            }
            let _e183 = phi_505_;
            let _e185 = phi_506_;
            if _e185 {
                let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                phi_513_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, true);
            } else {
                phi_513_ = _e183;
            }
            let _e202 = phi_513_;
            phi_517_ = _e202;
        } else {
            let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
            phi_517_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
        }
        let _e219 = phi_517_;
        if _e219.unnamed_1 {
            phi_1251_ = evaluate_Verdict(_e219.unnamed.visibility, _e219.unnamed.is_doubted);
        } else {
            let _e227 = samples.member[(0u + _e59.first_primitive)].position;
            let _e229 = p.member.map_size;
            let _e231 = (0.5f / f32(_e229));
            let _e238 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e245 = lt_math_LightPoint(vec2<f32>(_e238.uv.x, 0f), _e238.depth, _e238.is_inside);
            let _e249 = lt_math_LightPoint(_e245.uv, 0f, _e245.is_inside);
            phi_537_ = lt_math_LightPoint();
            phi_540_ = 0u;
            phi_542_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e249.uv, _e249.depth, false));
            loop {
                let _e256 = phi_537_;
                let _e258 = phi_540_;
                let _e260 = phi_542_;
                local_1 = _e260;
                local_2 = _e260;
                local_3 = _e260;
                if (_e258 < _e65) {
                    if _e260.point.is_inside {
                        phi_703_ = lt_math_LightPoint();
                        phi_704_ = u32();
                        phi_705_ = lt_math_LevelPoint();
                        phi_706_ = false;
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
                                phi_628_ = (_e296 <= 1f);
                            } else {
                                phi_628_ = false;
                            }
                            let _e328 = phi_628_;
                            if _e328 {
                                if (_e310 >= 0f) {
                                    phi_637_ = (_e310 <= 1f);
                                } else {
                                    phi_637_ = false;
                                }
                                let _e332 = phi_637_;
                                if _e332 {
                                    if (_e323 >= 0f) {
                                        phi_646_ = (_e323 <= 1f);
                                    } else {
                                        phi_646_ = false;
                                    }
                                    let _e336 = phi_646_;
                                    phi_647_ = _e336;
                                    phi_648_ = false;
                                } else {
                                    phi_647_ = bool();
                                    phi_648_ = true;
                                }
                                let _e338 = phi_647_;
                                let _e340 = phi_648_;
                                phi_649_ = _e338;
                                phi_650_ = _e340;
                            } else {
                                phi_649_ = bool();
                                phi_650_ = true;
                            }
                            let _e342 = phi_649_;
                            let _e344 = phi_650_;
                            phi_651_ = _e342;
                            phi_652_ = _e344;
                        } else {
                            phi_651_ = bool();
                            phi_652_ = true;
                        }
                        let _e346 = phi_651_;
                        let _e348 = phi_652_;
                        if _e348 {
                            phi_656_ = false;
                        } else {
                            phi_656_ = _e346;
                        }
                        let _e350 = phi_656_;
                        if _e350 {
                            if (_e296 >= _e231) {
                                if (_e296 <= (1f - _e231)) {
                                    if (_e310 >= _e231) {
                                        phi_683_ = (_e310 <= (1f - _e231));
                                        phi_684_ = false;
                                    } else {
                                        phi_683_ = bool();
                                        phi_684_ = true;
                                    }
                                    let _e358 = phi_683_;
                                    let _e360 = phi_684_;
                                    phi_685_ = _e358;
                                    phi_686_ = _e360;
                                } else {
                                    phi_685_ = bool();
                                    phi_686_ = true;
                                }
                                let _e362 = phi_685_;
                                let _e364 = phi_686_;
                                phi_687_ = _e362;
                                phi_688_ = _e364;
                            } else {
                                phi_687_ = bool();
                                phi_688_ = true;
                            }
                            let _e366 = phi_687_;
                            let _e368 = phi_688_;
                            phi_689_ = _e366;
                            phi_690_ = _e368;
                        } else {
                            phi_689_ = bool();
                            phi_690_ = true;
                        }
                        let _e370 = phi_689_;
                        let _e372 = phi_690_;
                        if _e372 {
                            phi_694_ = false;
                        } else {
                            phi_694_ = _e370;
                        }
                        let _e374 = phi_694_;
                        let _e381 = lt_math_LightPoint(vec2<f32>(_e296, _e256.uv.y), _e256.depth, _e256.is_inside);
                        let _e388 = lt_math_LightPoint(vec2<f32>(_e381.uv.x, _e310), _e381.depth, _e381.is_inside);
                        let _e392 = lt_math_LightPoint(_e388.uv, _e323, _e388.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e392.depth, _e374);
                        phi_703_ = _e396;
                        phi_704_ = (_e258 + 1u);
                        phi_705_ = lt_math_LevelPoint(_e258, _e396);
                        phi_706_ = true;
                    }
                    let _e400 = phi_703_;
                    let _e402 = phi_704_;
                    let _e404 = phi_705_;
                    let _e406 = phi_706_;
                    phi_538_ = _e400;
                    phi_541_ = _e402;
                    phi_543_ = _e404;
                    phi_707_ = _e406;
                } else {
                    phi_538_ = lt_math_LightPoint();
                    phi_541_ = u32();
                    phi_543_ = lt_math_LevelPoint();
                    phi_707_ = false;
                }
                let _e408 = phi_538_;
                let _e410 = phi_541_;
                let _e412 = phi_543_;
                let _e414 = phi_707_;
                continue;
                continuing {
                    phi_537_ = _e408;
                    phi_540_ = _e410;
                    phi_542_ = _e412;
                    break if !(_e414);
                }
            }
            let _e417 = local_1;
            if _e417.point.is_inside {
                if (0f > 0f) {
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
                            phi_747_ = (_e428.row_w.z == _e440);
                            phi_748_ = false;
                        } else {
                            phi_747_ = bool();
                            phi_748_ = true;
                        }
                        let _e443 = phi_747_;
                        let _e445 = phi_748_;
                        phi_749_ = _e443;
                        phi_750_ = _e445;
                    } else {
                        phi_749_ = bool();
                        phi_750_ = true;
                    }
                    let _e447 = phi_749_;
                    let _e449 = phi_750_;
                    if _e449 {
                        phi_754_ = false;
                    } else {
                        phi_754_ = _e447;
                    }
                    let _e451 = phi_754_;
                    if _e451 {
                        let _e453 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e455 = p.member.map_size;
                        let _e525 = ((abs(((((_e428.row_x.x * _e453.x) + (_e428.row_x.y * _e453.y)) + (_e428.row_x.z * _e453.z)) / (((_e428.row_x.x * _e428.row_x.x) + (_e428.row_x.y * _e428.row_x.y)) + (_e428.row_x.z * _e428.row_x.z)))) + abs(((((_e428.row_y.x * _e453.x) + (_e428.row_y.y * _e453.y)) + (_e428.row_y.z * _e453.z)) / (((_e428.row_y.x * _e428.row_y.x) + (_e428.row_y.y * _e428.row_y.y)) + (_e428.row_y.z * _e428.row_y.z))))) / (abs(((((_e428.row_z.x * _e453.x) + (_e428.row_z.y * _e453.y)) + (_e428.row_z.z * _e453.z)) / (((_e428.row_z.x * _e428.row_z.x) + (_e428.row_z.y * _e428.row_z.y)) + (_e428.row_z.z * _e428.row_z.z)))) * f32(_e455)));
                        if (_e525 < 0.002f) {
                            phi_836_ = _e525;
                        } else {
                            phi_836_ = 0.002f;
                        }
                        let _e528 = phi_836_;
                        phi_953_ = _e528;
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
                            phi_952_ = _e642;
                        } else {
                            phi_952_ = 0.002f;
                        }
                        let _e645 = phi_952_;
                        phi_953_ = _e645;
                    }
                    let _e647 = phi_953_;
                    phi_956_ = (_e417.point.depth - (0f * _e647));
                } else {
                    phi_956_ = _e417.point.depth;
                }
                let _e651 = phi_956_;
                let _e657 = p.member.map_size;
                let _e658 = f32(_e657);
                let _e661 = ((_e417.point.uv.x * _e658) - 0.5f);
                let _e662 = ((_e417.point.uv.y * _e658) - 0.5f);
                if (_e661 > -8388608f) {
                    let _e674 = f32(select(0i, select(select(i32(_e661), i32(-2147483648), (_e661 < bitcast<f32>(3472883712u))), 2147483647i, (_e661 > bitcast<f32>(1325400063u))), (_e661 == _e661)));
                    if (_e674 > _e661) {
                        phi_985_ = 1f;
                    } else {
                        phi_985_ = 0f;
                    }
                    let _e677 = phi_985_;
                    if (_e661 < 8388608f) {
                        phi_990_ = (_e674 - _e677);
                        phi_991_ = false;
                    } else {
                        phi_990_ = f32();
                        phi_991_ = true;
                    }
                    let _e680 = phi_990_;
                    let _e682 = phi_991_;
                    phi_992_ = _e680;
                    phi_993_ = _e682;
                } else {
                    phi_992_ = f32();
                    phi_993_ = true;
                }
                let _e684 = phi_992_;
                let _e686 = phi_993_;
                if _e686 {
                    phi_997_ = _e661;
                } else {
                    phi_997_ = _e684;
                }
                let _e688 = phi_997_;
                if (_e662 > -8388608f) {
                    let _e700 = f32(select(0i, select(select(i32(_e662), i32(-2147483648), (_e662 < bitcast<f32>(3472883712u))), 2147483647i, (_e662 > bitcast<f32>(1325400063u))), (_e662 == _e662)));
                    if (_e700 > _e662) {
                        phi_1017_ = 1f;
                    } else {
                        phi_1017_ = 0f;
                    }
                    let _e703 = phi_1017_;
                    if (_e662 < 8388608f) {
                        phi_1022_ = (_e700 - _e703);
                        phi_1023_ = false;
                    } else {
                        phi_1022_ = f32();
                        phi_1023_ = true;
                    }
                    let _e706 = phi_1022_;
                    let _e708 = phi_1023_;
                    phi_1024_ = _e706;
                    phi_1025_ = _e708;
                } else {
                    phi_1024_ = f32();
                    phi_1025_ = true;
                }
                let _e710 = phi_1024_;
                let _e712 = phi_1025_;
                if _e712 {
                    phi_1029_ = _e662;
                } else {
                    phi_1029_ = _e710;
                }
                let _e714 = phi_1029_;
                let _e715 = (_e661 - _e688);
                let _e716 = (_e662 - _e714);
                let _e725 = select(0i, select(select(i32(_e688), i32(-2147483648), (_e688 < bitcast<f32>(3472883712u))), 2147483647i, (_e688 > bitcast<f32>(1325400063u))), (_e688 == _e688));
                let _e734 = select(0i, select(select(i32(_e714), i32(-2147483648), (_e714 < bitcast<f32>(3472883712u))), 2147483647i, (_e714 > bitcast<f32>(1325400063u))), (_e714 == _e714));
                let _e737 = ((1f - _e715) * (1f - _e716));
                let _e739 = (_e715 * (1f - _e716));
                let _e741 = ((1f - _e715) * _e716);
                let _e742 = (_e715 * _e716);
                let _e744 = p.member.test;
                let _e745 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e744);
                let _e747 = p.member.map_size;
                let _e749 = local_3;
                local = _e745;
                let _e752 = ((_e749.level * _e747) * _e747);
                let _e754 = (bitcast<i32>(_e747) - 1i);
                if (_e725 > 0i) {
                    phi_1078_ = _e725;
                } else {
                    phi_1078_ = 0i;
                }
                let _e757 = phi_1078_;
                if (_e734 > 0i) {
                    phi_1083_ = _e734;
                } else {
                    phi_1083_ = 0i;
                }
                let _e760 = phi_1083_;
                if (_e757 < _e754) {
                    phi_1088_ = _e757;
                } else {
                    phi_1088_ = _e754;
                }
                let _e763 = phi_1088_;
                if (_e760 < _e754) {
                    phi_1093_ = _e760;
                } else {
                    phi_1093_ = _e754;
                }
                let _e766 = phi_1093_;
                let _e767 = bitcast<u32>(_e763);
                let _e769 = (_e725 + 1i);
                let _e770 = (_e734 + 1i);
                if (_e769 > 0i) {
                    phi_1102_ = _e769;
                } else {
                    phi_1102_ = 0i;
                }
                let _e773 = phi_1102_;
                if (_e770 > 0i) {
                    phi_1107_ = _e770;
                } else {
                    phi_1107_ = 0i;
                }
                let _e776 = phi_1107_;
                if (_e773 < _e754) {
                    phi_1112_ = _e773;
                } else {
                    phi_1112_ = _e754;
                }
                let _e779 = phi_1112_;
                if (_e776 < _e754) {
                    phi_1117_ = _e776;
                } else {
                    phi_1117_ = _e754;
                }
                let _e782 = phi_1117_;
                let _e783 = bitcast<u32>(_e779);
                let _e785 = (bitcast<u32>(_e766) * _e747);
                let _e786 = (bitcast<u32>(_e782) * _e747);
                let _e791 = ((_e785 + _e767) + _e752);
                let _e792 = ((_e785 + _e783) + _e752);
                let _e793 = ((_e786 + _e767) + _e752);
                let _e794 = ((_e786 + _e783) + _e752);
                if (_e791 < _e47) {
                } else {
                    return;
                }
                let _e798 = map.member[(0u + _e791)];
                if (_e792 < _e47) {
                } else {
                    return;
                }
                let _e810 = map.member[(0u + _e792)];
                if (_e793 < _e47) {
                } else {
                    return;
                }
                let _e826 = map.member[(0u + _e793)];
                if (_e794 < _e47) {
                } else {
                    return;
                }
                let _e842 = map.member[(0u + _e794)];
                let _e856 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e798.x * _e737) + (_e810.x * _e739)) + (_e826.x * _e741)) + (_e842.x * _e742)), ((((_e798.y * _e737) + (_e810.y * _e739)) + (_e826.y * _e741)) + (_e842.y * _e742)), ((((_e798.z * _e737) + (_e810.z * _e739)) + (_e826.z * _e741)) + (_e842.z * _e742)), ((((_e798.w * _e737) + (_e810.w * _e739)) + (_e826.w * _e741)) + (_e842.w * _e742))), _e651);
                let _e858 = p.member.epsilon;
                if (_e856 <= _e858) {
                    phi_1212_ = true;
                } else {
                    phi_1212_ = (_e856 >= (1f - _e858));
                }
                let _e863 = phi_1212_;
                if ((bitcast<u32>(_e856) & 2147483647u) > 2139095040u) {
                    phi_1220_ = true;
                } else {
                    phi_1220_ = !(_e863);
                }
                let _e869 = phi_1220_;
                if _e869 {
                    if (_e856 > 0f) {
                        if (_e856 < 1f) {
                            phi_1232_ = false;
                        } else {
                            phi_1232_ = true;
                        }
                        let _e873 = phi_1232_;
                        phi_1233_ = _e873;
                    } else {
                        phi_1233_ = true;
                    }
                    let _e875 = phi_1233_;
                    if _e875 {
                        phi_1237_ = 0.5f;
                    } else {
                        phi_1237_ = _e856;
                    }
                    let _e877 = phi_1237_;
                    phi_1245_ = evaluate_Verdict(_e877, true);
                } else {
                    if (_e856 > 0.5f) {
                        phi_1243_ = 1f;
                    } else {
                        phi_1243_ = 0f;
                    }
                    let _e881 = phi_1243_;
                    phi_1245_ = evaluate_Verdict(_e881, false);
                }
                let _e884 = phi_1245_;
                phi_1250_ = evaluate_Verdict(_e884.visibility, _e884.is_doubted);
            } else {
                phi_1250_ = evaluate_Verdict(0.5f, true);
            }
            let _e890 = phi_1250_;
            phi_1251_ = _e890;
        }
        let _e892 = phi_1251_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e892.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
