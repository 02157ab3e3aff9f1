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
    var phi_148_: lt_bvh_traverse_Tree;
    var phi_149_: bool;
    var phi_150_: lt_bvh_traverse_Tree;
    var phi_151_: bool;
    var phi_156_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_148_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_149_ = false;
        } else {
            phi_148_ = lt_bvh_traverse_Tree();
            phi_149_ = true;
        }
        let _e52 = phi_148_;
        let _e54 = phi_149_;
        phi_150_ = _e52;
        phi_151_ = _e54;
    } else {
        phi_150_ = lt_bvh_traverse_Tree();
        phi_151_ = true;
    }
    let _e56 = phi_150_;
    let _e58 = phi_151_;
    if _e58 {
        phi_156_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_156_ = _e56;
    }
    let _e63 = phi_156_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_205_: f32;
    var phi_206_: f32;
    var phi_207_: f32;
    var phi_213_: bool;
    var phi_235_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_239_: bool;
    var phi_240_: f32;
    var phi_241_: bool;
    var phi_279_: vec2<f32>;
    var phi_313_: f32;
    var phi_314_: f32;
    var phi_315_: f32;
    var phi_344_: f32;
    var phi_345_: f32;
    var phi_346_: f32;
    var phi_350_: f32;
    var phi_351_: f32;
    var phi_352_: f32;
    var phi_353_: f32;

    let _e42 = (*param_4);
    let _e43 = (1f - _e42);
    let _e52 = (0.5f * _e42);
    let _e53 = ((param_5.x * _e43) + _e52);
    let _e54 = ((param_5.y * _e43) + _e52);
    let _e56 = ((param_5.w * _e43) + _e52);
    let _e58 = (_e54 - (_e53 * _e53));
    let _e60 = (((param_5.z * _e43) + _e52) - (_e53 * _e54));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_207_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_206_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_205_ = 1f;
            } else {
                phi_205_ = param_6;
            }
            let _e72 = phi_205_;
            phi_206_ = _e72;
        }
        let _e74 = phi_206_;
        phi_207_ = _e74;
    }
    let _e76 = phi_207_;
    if (_e53 == _e56) {
        phi_213_ = (_e53 > 0.5f);
    } else {
        phi_213_ = false;
    }
    let _e80 = phi_213_;
    if _e80 {
        if (_e76 > 0f) {
            if ((bitcast<u32>(_e53) & 2147483647u) > 2139095040u) {
                phi_237_ = _e53;
            } else {
                if (_e53 < 0f) {
                    phi_236_ = 0f;
                } else {
                    if (_e53 > 1f) {
                        phi_235_ = 1f;
                    } else {
                        phi_235_ = _e53;
                    }
                    let _e88 = phi_235_;
                    phi_236_ = _e88;
                }
                let _e90 = phi_236_;
                phi_237_ = _e90;
            }
            let _e92 = phi_237_;
            phi_238_ = _e92;
            phi_239_ = false;
        } else {
            phi_238_ = f32();
            phi_239_ = true;
        }
        let _e94 = phi_238_;
        let _e96 = phi_239_;
        phi_240_ = _e94;
        phi_241_ = _e96;
    } else {
        phi_240_ = f32();
        phi_241_ = true;
    }
    let _e98 = phi_240_;
    let _e100 = phi_241_;
    if _e100 {
        let _e101 = (_e60 / _e58);
        let _e102 = (_e76 - _e53);
        let _e108 = (((((_e76 * _e76) - _e54) - (_e101 * _e102)) * _e58) / (((_e56 - (_e54 * _e54)) * _e58) - (_e60 * _e60)));
        let _e111 = ((_e102 / _e58) - (_e101 * _e108));
        let _e117 = ((0.5f * _e111) / _e108);
        let _e120 = ((_e117 * _e117) - (((1f - (_e111 * _e53)) - (_e108 * _e54)) / _e108));
        if (_e120 >= 0f) {
            let _e122 = sqrt(_e120);
            phi_279_ = vec2<f32>((-(_e117) - _e122), (-(_e117) + _e122));
        } else {
            phi_279_ = vec2(bitcast<f32>((bitcast<u32>(_e120) | 2143289344u)));
        }
        let _e133 = phi_279_;
        if (_e76 <= _e133.x) {
            phi_352_ = 1f;
        } else {
            if (_e76 > _e133.y) {
                let _e146 = (((_e54 - (_e53 * (_e133.x + _e133.y))) + (_e133.x * _e133.y)) / ((_e76 - _e133.x) * (_e76 - _e133.y)));
                if ((bitcast<u32>(_e146) & 2147483647u) > 2139095040u) {
                    phi_315_ = _e146;
                } else {
                    if (_e146 < 0f) {
                        phi_314_ = 0f;
                    } else {
                        if (_e146 > 1f) {
                            phi_313_ = 1f;
                        } else {
                            phi_313_ = _e146;
                        }
                        let _e153 = phi_313_;
                        phi_314_ = _e153;
                    }
                    let _e155 = phi_314_;
                    phi_315_ = _e155;
                }
                let _e157 = phi_315_;
                phi_351_ = _e157;
            } else {
                if (_e76 > _e133.x) {
                    let _e168 = (1f - (((_e54 - (_e53 * (_e76 + _e133.y))) + (_e76 * _e133.y)) / ((_e133.x - _e76) * (_e133.x - _e133.y))));
                    if ((bitcast<u32>(_e168) & 2147483647u) > 2139095040u) {
                        phi_346_ = _e168;
                    } else {
                        if (_e168 < 0f) {
                            phi_345_ = 0f;
                        } else {
                            if (_e168 > 1f) {
                                phi_344_ = 1f;
                            } else {
                                phi_344_ = _e168;
                            }
                            let _e175 = phi_344_;
                            phi_345_ = _e175;
                        }
                        let _e177 = phi_345_;
                        phi_346_ = _e177;
                    }
                    let _e179 = phi_346_;
                    phi_350_ = _e179;
                } else {
                    phi_350_ = bitcast<f32>((bitcast<u32>(_e133.x) | 2143289344u));
                }
                let _e184 = phi_350_;
                phi_351_ = _e184;
            }
            let _e186 = phi_351_;
            phi_352_ = _e186;
        }
        let _e188 = phi_352_;
        phi_353_ = _e188;
    } else {
        phi_353_ = _e98;
    }
    let _e190 = phi_353_;
    return _e190;
}

fn function_() {
    var local: f32;
    var phi_413_: bool;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_420_: bool;
    var phi_490_: bool;
    var phi_491_: bool;
    var phi_502_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_503_: bool;
    var phi_504_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_505_: bool;
    var phi_512_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_516_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_536_: lt_math_LightPoint;
    var phi_539_: u32;
    var phi_541_: lt_math_LevelPoint;
    var phi_627_: bool;
    var phi_636_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_655_: bool;
    var phi_682_: bool;
    var phi_683_: bool;
    var phi_684_: bool;
    var phi_685_: bool;
    var phi_686_: bool;
    var phi_687_: bool;
    var phi_688_: bool;
    var phi_689_: bool;
    var phi_693_: bool;
    var phi_702_: lt_math_LightPoint;
    var phi_703_: u32;
    var phi_704_: lt_math_LevelPoint;
    var phi_705_: bool;
    var phi_537_: lt_math_LightPoint;
    var phi_540_: u32;
    var phi_542_: lt_math_LevelPoint;
    var phi_706_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_746_: bool;
    var phi_747_: bool;
    var phi_748_: bool;
    var phi_749_: bool;
    var phi_753_: bool;
    var phi_835_: f32;
    var phi_951_: f32;
    var phi_952_: f32;
    var phi_955_: f32;
    var phi_984_: f32;
    var phi_989_: f32;
    var phi_990_: bool;
    var phi_991_: f32;
    var phi_992_: bool;
    var phi_996_: f32;
    var phi_1016_: f32;
    var phi_1021_: f32;
    var phi_1022_: bool;
    var phi_1023_: f32;
    var phi_1024_: bool;
    var phi_1028_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1077_: i32;
    var phi_1082_: i32;
    var phi_1087_: i32;
    var phi_1092_: i32;
    var phi_1101_: i32;
    var phi_1106_: i32;
    var phi_1111_: i32;
    var phi_1116_: i32;
    var phi_1205_: evaluate_Verdict;
    var phi_1206_: evaluate_Verdict;
    var phi_1207_: bool;
    var phi_1208_: evaluate_Verdict;
    var phi_1209_: evaluate_Verdict;
    var phi_1210_: bool;
    var phi_1214_: evaluate_Verdict;

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
                phi_413_ = (_e82 == _e84);
                phi_414_ = false;
            } else {
                phi_413_ = bool();
                phi_414_ = true;
            }
            let _e87 = phi_413_;
            let _e89 = phi_414_;
            phi_415_ = _e87;
            phi_416_ = _e89;
        } else {
            phi_415_ = bool();
            phi_416_ = true;
        }
        let _e91 = phi_415_;
        let _e93 = phi_416_;
        if _e93 {
            phi_420_ = false;
        } else {
            phi_420_ = _e91;
        }
        let _e95 = phi_420_;
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
                    phi_491_ = true;
                } else {
                    let _e148 = p.member.light.range_squared;
                    if (_e131 <= _e148) {
                        let _e151 = p.member.light.cos_outer;
                        phi_490_ = (-((((_e113 * _e133.x) + (_e114 * _e133.y)) + (_e115 * _e133.z))) >= (_e151 * sqrt(_e131)));
                    } else {
                        phi_490_ = false;
                    }
                    let _e156 = phi_490_;
                    phi_491_ = _e156;
                }
                let _e158 = phi_491_;
                if _e158 {
                    let _e160 = samples.member[(0u + _e59.first_primitive)].flags;
                    let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                    phi_502_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, ((_e160 & 1u) == 0u));
                    phi_503_ = false;
                } else {
                    phi_502_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_503_ = true;
                }
                let _e179 = phi_502_;
                let _e181 = phi_503_;
                phi_504_ = _e179;
                phi_505_ = _e181;
            } else {
                phi_504_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_505_ = true;
            }
            let _e183 = phi_504_;
            let _e185 = phi_505_;
            if _e185 {
                let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                phi_512_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, true);
            } else {
                phi_512_ = _e183;
            }
            let _e202 = phi_512_;
            phi_516_ = _e202;
        } else {
            let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
            phi_516_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
        }
        let _e219 = phi_516_;
        if _e219.unnamed_1 {
            phi_1208_ = evaluate_Verdict(_e219.unnamed.visibility, _e219.unnamed.is_doubted);
            phi_1209_ = evaluate_Verdict();
            phi_1210_ = true;
        } else {
            let _e227 = samples.member[(0u + _e59.first_primitive)].position;
            let _e229 = p.member.map_size;
            let _e231 = (0.5f / f32(_e229));
            let _e238 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e245 = lt_math_LightPoint(vec2<f32>(_e238.uv.x, 0f), _e238.depth, _e238.is_inside);
            let _e249 = lt_math_LightPoint(_e245.uv, 0f, _e245.is_inside);
            phi_536_ = lt_math_LightPoint();
            phi_539_ = 0u;
            phi_541_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e249.uv, _e249.depth, false));
            loop {
                let _e256 = phi_536_;
                let _e258 = phi_539_;
                let _e260 = phi_541_;
                local_1 = _e260;
                local_2 = _e260;
                local_3 = _e260;
                if (_e258 < _e65) {
                    if _e260.point.is_inside {
                        phi_702_ = lt_math_LightPoint();
                        phi_703_ = u32();
                        phi_704_ = lt_math_LevelPoint();
                        phi_705_ = false;
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
                                phi_627_ = (_e296 <= 1f);
                            } else {
                                phi_627_ = false;
                            }
                            let _e328 = phi_627_;
                            if _e328 {
                                if (_e310 >= 0f) {
                                    phi_636_ = (_e310 <= 1f);
                                } else {
                                    phi_636_ = false;
                                }
                                let _e332 = phi_636_;
                                if _e332 {
                                    if (_e323 >= 0f) {
                                        phi_645_ = (_e323 <= 1f);
                                    } else {
                                        phi_645_ = false;
                                    }
                                    let _e336 = phi_645_;
                                    phi_646_ = _e336;
                                    phi_647_ = false;
                                } else {
                                    phi_646_ = bool();
                                    phi_647_ = true;
                                }
                                let _e338 = phi_646_;
                                let _e340 = phi_647_;
                                phi_648_ = _e338;
                                phi_649_ = _e340;
                            } else {
                                phi_648_ = bool();
                                phi_649_ = true;
                            }
                            let _e342 = phi_648_;
                            let _e344 = phi_649_;
                            phi_650_ = _e342;
                            phi_651_ = _e344;
                        } else {
                            phi_650_ = bool();
                            phi_651_ = true;
                        }
                        let _e346 = phi_650_;
                        let _e348 = phi_651_;
                        if _e348 {
                            phi_655_ = false;
                        } else {
                            phi_655_ = _e346;
                        }
                        let _e350 = phi_655_;
                        if _e350 {
                            if (_e296 >= _e231) {
                                if (_e296 <= (1f - _e231)) {
                                    if (_e310 >= _e231) {
                                        phi_682_ = (_e310 <= (1f - _e231));
                                        phi_683_ = false;
                                    } else {
                                        phi_682_ = bool();
                                        phi_683_ = true;
                                    }
                                    let _e358 = phi_682_;
                                    let _e360 = phi_683_;
                                    phi_684_ = _e358;
                                    phi_685_ = _e360;
                                } else {
                                    phi_684_ = bool();
                                    phi_685_ = true;
                                }
                                let _e362 = phi_684_;
                                let _e364 = phi_685_;
                                phi_686_ = _e362;
                                phi_687_ = _e364;
                            } else {
                                phi_686_ = bool();
                                phi_687_ = true;
                            }
                            let _e366 = phi_686_;
                            let _e368 = phi_687_;
                            phi_688_ = _e366;
                            phi_689_ = _e368;
                        } else {
                            phi_688_ = bool();
                            phi_689_ = true;
                        }
                        let _e370 = phi_688_;
                        let _e372 = phi_689_;
                        if _e372 {
                            phi_693_ = false;
                        } else {
                            phi_693_ = _e370;
                        }
                        let _e374 = phi_693_;
                        let _e381 = lt_math_LightPoint(vec2<f32>(_e296, _e256.uv.y), _e256.depth, _e256.is_inside);
                        let _e388 = lt_math_LightPoint(vec2<f32>(_e381.uv.x, _e310), _e381.depth, _e381.is_inside);
                        let _e392 = lt_math_LightPoint(_e388.uv, _e323, _e388.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e392.depth, _e374);
                        phi_702_ = _e396;
                        phi_703_ = (_e258 + 1u);
                        phi_704_ = lt_math_LevelPoint(_e258, _e396);
                        phi_705_ = true;
                    }
                    let _e400 = phi_702_;
                    let _e402 = phi_703_;
                    let _e404 = phi_704_;
                    let _e406 = phi_705_;
                    phi_537_ = _e400;
                    phi_540_ = _e402;
                    phi_542_ = _e404;
                    phi_706_ = _e406;
                } else {
                    phi_537_ = lt_math_LightPoint();
                    phi_540_ = u32();
                    phi_542_ = lt_math_LevelPoint();
                    phi_706_ = false;
                }
                let _e408 = phi_537_;
                let _e410 = phi_540_;
                let _e412 = phi_542_;
                let _e414 = phi_706_;
                continue;
                continuing {
                    phi_536_ = _e408;
                    phi_539_ = _e410;
                    phi_541_ = _e412;
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
                            phi_746_ = (_e428.row_w.z == _e440);
                            phi_747_ = false;
                        } else {
                            phi_746_ = bool();
                            phi_747_ = true;
                        }
                        let _e443 = phi_746_;
                        let _e445 = phi_747_;
                        phi_748_ = _e443;
                        phi_749_ = _e445;
                    } else {
                        phi_748_ = bool();
                        phi_749_ = true;
                    }
                    let _e447 = phi_748_;
                    let _e449 = phi_749_;
                    if _e449 {
                        phi_753_ = false;
                    } else {
                        phi_753_ = _e447;
                    }
                    let _e451 = phi_753_;
                    if _e451 {
                        let _e453 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e455 = p.member.map_size;
                        let _e525 = ((abs(((((_e428.row_x.x * _e453.x) + (_e428.row_x.y * _e453.y)) + (_e428.row_x.z * _e453.z)) / (((_e428.row_x.x * _e428.row_x.x) + (_e428.row_x.y * _e428.row_x.y)) + (_e428.row_x.z * _e428.row_x.z)))) + abs(((((_e428.row_y.x * _e453.x) + (_e428.row_y.y * _e453.y)) + (_e428.row_y.z * _e453.z)) / (((_e428.row_y.x * _e428.row_y.x) + (_e428.row_y.y * _e428.row_y.y)) + (_e428.row_y.z * _e428.row_y.z))))) / (abs(((((_e428.row_z.x * _e453.x) + (_e428.row_z.y * _e453.y)) + (_e428.row_z.z * _e453.z)) / (((_e428.row_z.x * _e428.row_z.x) + (_e428.row_z.y * _e428.row_z.y)) + (_e428.row_z.z * _e428.row_z.z)))) * f32(_e455)));
                        if (_e525 < 0.002f) {
                            phi_835_ = _e525;
                        } else {
                            phi_835_ = 0.002f;
                        }
                        let _e528 = phi_835_;
                        phi_952_ = _e528;
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
                            phi_951_ = _e642;
                        } else {
                            phi_951_ = 0.002f;
                        }
                        let _e645 = phi_951_;
                        phi_952_ = _e645;
                    }
                    let _e647 = phi_952_;
                    phi_955_ = (_e417.point.depth - (0f * _e647));
                } else {
                    phi_955_ = _e417.point.depth;
                }
                let _e651 = phi_955_;
                let _e657 = p.member.map_size;
                let _e658 = f32(_e657);
                let _e661 = ((_e417.point.uv.x * _e658) - 0.5f);
                let _e662 = ((_e417.point.uv.y * _e658) - 0.5f);
                if (_e661 > -8388608f) {
                    let _e674 = f32(select(0i, select(select(i32(_e661), i32(-2147483648), (_e661 < bitcast<f32>(3472883712u))), 2147483647i, (_e661 > bitcast<f32>(1325400063u))), (_e661 == _e661)));
                    if (_e674 > _e661) {
                        phi_984_ = 1f;
                    } else {
                        phi_984_ = 0f;
                    }
                    let _e677 = phi_984_;
                    if (_e661 < 8388608f) {
                        phi_989_ = (_e674 - _e677);
                        phi_990_ = false;
                    } else {
                        phi_989_ = f32();
                        phi_990_ = true;
                    }
                    let _e680 = phi_989_;
                    let _e682 = phi_990_;
                    phi_991_ = _e680;
                    phi_992_ = _e682;
                } else {
                    phi_991_ = f32();
                    phi_992_ = true;
                }
                let _e684 = phi_991_;
                let _e686 = phi_992_;
                if _e686 {
                    phi_996_ = _e661;
                } else {
                    phi_996_ = _e684;
                }
                let _e688 = phi_996_;
                if (_e662 > -8388608f) {
                    let _e700 = f32(select(0i, select(select(i32(_e662), i32(-2147483648), (_e662 < bitcast<f32>(3472883712u))), 2147483647i, (_e662 > bitcast<f32>(1325400063u))), (_e662 == _e662)));
                    if (_e700 > _e662) {
                        phi_1016_ = 1f;
                    } else {
                        phi_1016_ = 0f;
                    }
                    let _e703 = phi_1016_;
                    if (_e662 < 8388608f) {
                        phi_1021_ = (_e700 - _e703);
                        phi_1022_ = false;
                    } else {
                        phi_1021_ = f32();
                        phi_1022_ = true;
                    }
                    let _e706 = phi_1021_;
                    let _e708 = phi_1022_;
                    phi_1023_ = _e706;
                    phi_1024_ = _e708;
                } else {
                    phi_1023_ = f32();
                    phi_1024_ = true;
                }
                let _e710 = phi_1023_;
                let _e712 = phi_1024_;
                if _e712 {
                    phi_1028_ = _e662;
                } else {
                    phi_1028_ = _e710;
                }
                let _e714 = phi_1028_;
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
                    phi_1077_ = _e725;
                } else {
                    phi_1077_ = 0i;
                }
                let _e757 = phi_1077_;
                if (_e734 > 0i) {
                    phi_1082_ = _e734;
                } else {
                    phi_1082_ = 0i;
                }
                let _e760 = phi_1082_;
                if (_e757 < _e754) {
                    phi_1087_ = _e757;
                } else {
                    phi_1087_ = _e754;
                }
                let _e763 = phi_1087_;
                if (_e760 < _e754) {
                    phi_1092_ = _e760;
                } else {
                    phi_1092_ = _e754;
                }
                let _e766 = phi_1092_;
                let _e767 = bitcast<u32>(_e763);
                let _e769 = (_e725 + 1i);
                let _e770 = (_e734 + 1i);
                if (_e769 > 0i) {
                    phi_1101_ = _e769;
                } else {
                    phi_1101_ = 0i;
                }
                let _e773 = phi_1101_;
                if (_e770 > 0i) {
                    phi_1106_ = _e770;
                } else {
                    phi_1106_ = 0i;
                }
                let _e776 = phi_1106_;
                if (_e773 < _e754) {
                    phi_1111_ = _e773;
                } else {
                    phi_1111_ = _e754;
                }
                let _e779 = phi_1111_;
                if (_e776 < _e754) {
                    phi_1116_ = _e776;
                } else {
                    phi_1116_ = _e754;
                }
                let _e782 = phi_1116_;
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
                phi_1205_ = evaluate_Verdict(_e856, false);
                phi_1206_ = evaluate_Verdict();
                phi_1207_ = false;
            } else {
                phi_1205_ = evaluate_Verdict();
                phi_1206_ = evaluate_Verdict(1f, false);
                phi_1207_ = true;
            }
            let _e860 = phi_1205_;
            let _e862 = phi_1206_;
            let _e864 = phi_1207_;
            phi_1208_ = _e862;
            phi_1209_ = _e860;
            phi_1210_ = _e864;
        }
        let _e866 = phi_1208_;
        let _e868 = phi_1209_;
        let _e870 = phi_1210_;
        if _e870 {
            phi_1214_ = _e866;
        } else {
            phi_1214_ = _e868;
        }
        let _e872 = phi_1214_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e872.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
