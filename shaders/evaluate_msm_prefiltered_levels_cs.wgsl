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

struct type_29 {
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

struct type_33 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_39 {
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
var<uniform> p: type_33;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_39;
@group(0) @binding(2) 
var<storage> map: type_29;

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
        let _e53 = phi_148_;
        let _e55 = phi_149_;
        phi_150_ = _e53;
        phi_151_ = _e55;
    } else {
        phi_150_ = lt_bvh_traverse_Tree();
        phi_151_ = true;
    }
    let _e57 = phi_150_;
    let _e59 = phi_151_;
    if _e59 {
        phi_156_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_156_ = _e57;
    }
    let _e64 = phi_156_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_4: f32, param_5: f32) -> f32 {
    var phi_170_: f32;

    if (param_4 < param_5) {
        phi_170_ = param_4;
    } else {
        phi_170_ = param_5;
    }
    let _e44 = phi_170_;
    return _e44;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_213_: f32;
    var phi_214_: f32;
    var phi_215_: f32;
    var phi_221_: bool;
    var phi_243_: f32;
    var phi_244_: f32;
    var phi_245_: f32;
    var phi_246_: f32;
    var phi_247_: bool;
    var phi_248_: f32;
    var phi_249_: bool;
    var phi_287_: vec2<f32>;
    var phi_321_: f32;
    var phi_322_: f32;
    var phi_323_: f32;
    var phi_352_: f32;
    var phi_353_: f32;
    var phi_354_: f32;
    var phi_358_: f32;
    var phi_359_: f32;
    var phi_360_: f32;
    var phi_361_: f32;

    let _e43 = (*param_6);
    let _e44 = (1f - _e43);
    let _e53 = (0.5f * _e43);
    let _e54 = ((param_7.x * _e44) + _e53);
    let _e55 = ((param_7.y * _e44) + _e53);
    let _e57 = ((param_7.w * _e44) + _e53);
    let _e59 = (_e55 - (_e54 * _e54));
    let _e61 = (((param_7.z * _e44) + _e53) - (_e54 * _e55));
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_215_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_214_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_213_ = 1f;
            } else {
                phi_213_ = param_8;
            }
            let _e73 = phi_213_;
            phi_214_ = _e73;
        }
        let _e75 = phi_214_;
        phi_215_ = _e75;
    }
    let _e77 = phi_215_;
    if (_e54 == _e57) {
        phi_221_ = (_e54 > 0.5f);
    } else {
        phi_221_ = false;
    }
    let _e81 = phi_221_;
    if _e81 {
        if (_e77 > 0f) {
            if ((bitcast<u32>(_e54) & 2147483647u) > 2139095040u) {
                phi_245_ = _e54;
            } else {
                if (_e54 < 0f) {
                    phi_244_ = 0f;
                } else {
                    if (_e54 > 1f) {
                        phi_243_ = 1f;
                    } else {
                        phi_243_ = _e54;
                    }
                    let _e89 = phi_243_;
                    phi_244_ = _e89;
                }
                let _e91 = phi_244_;
                phi_245_ = _e91;
            }
            let _e93 = phi_245_;
            phi_246_ = _e93;
            phi_247_ = false;
        } else {
            phi_246_ = f32();
            phi_247_ = true;
        }
        let _e95 = phi_246_;
        let _e97 = phi_247_;
        phi_248_ = _e95;
        phi_249_ = _e97;
    } else {
        phi_248_ = f32();
        phi_249_ = true;
    }
    let _e99 = phi_248_;
    let _e101 = phi_249_;
    if _e101 {
        let _e102 = (_e61 / _e59);
        let _e103 = (_e77 - _e54);
        let _e109 = (((((_e77 * _e77) - _e55) - (_e102 * _e103)) * _e59) / (((_e57 - (_e55 * _e55)) * _e59) - (_e61 * _e61)));
        let _e112 = ((_e103 / _e59) - (_e102 * _e109));
        let _e118 = ((0.5f * _e112) / _e109);
        let _e121 = ((_e118 * _e118) - (((1f - (_e112 * _e54)) - (_e109 * _e55)) / _e109));
        if (_e121 >= 0f) {
            let _e123 = sqrt(_e121);
            phi_287_ = vec2<f32>((-(_e118) - _e123), (-(_e118) + _e123));
        } else {
            phi_287_ = vec2(bitcast<f32>((bitcast<u32>(_e121) | 2143289344u)));
        }
        let _e134 = phi_287_;
        if (_e77 <= _e134.x) {
            phi_360_ = 1f;
        } else {
            if (_e77 > _e134.y) {
                let _e147 = (((_e55 - (_e54 * (_e134.x + _e134.y))) + (_e134.x * _e134.y)) / ((_e77 - _e134.x) * (_e77 - _e134.y)));
                if ((bitcast<u32>(_e147) & 2147483647u) > 2139095040u) {
                    phi_323_ = _e147;
                } else {
                    if (_e147 < 0f) {
                        phi_322_ = 0f;
                    } else {
                        if (_e147 > 1f) {
                            phi_321_ = 1f;
                        } else {
                            phi_321_ = _e147;
                        }
                        let _e154 = phi_321_;
                        phi_322_ = _e154;
                    }
                    let _e156 = phi_322_;
                    phi_323_ = _e156;
                }
                let _e158 = phi_323_;
                phi_359_ = _e158;
            } else {
                if (_e77 > _e134.x) {
                    let _e169 = (1f - (((_e55 - (_e54 * (_e77 + _e134.y))) + (_e77 * _e134.y)) / ((_e134.x - _e77) * (_e134.x - _e134.y))));
                    if ((bitcast<u32>(_e169) & 2147483647u) > 2139095040u) {
                        phi_354_ = _e169;
                    } else {
                        if (_e169 < 0f) {
                            phi_353_ = 0f;
                        } else {
                            if (_e169 > 1f) {
                                phi_352_ = 1f;
                            } else {
                                phi_352_ = _e169;
                            }
                            let _e176 = phi_352_;
                            phi_353_ = _e176;
                        }
                        let _e178 = phi_353_;
                        phi_354_ = _e178;
                    }
                    let _e180 = phi_354_;
                    phi_358_ = _e180;
                } else {
                    phi_358_ = bitcast<f32>((bitcast<u32>(_e134.x) | 2143289344u));
                }
                let _e185 = phi_358_;
                phi_359_ = _e185;
            }
            let _e187 = phi_359_;
            phi_360_ = _e187;
        }
        let _e189 = phi_360_;
        phi_361_ = _e189;
    } else {
        phi_361_ = _e99;
    }
    let _e191 = phi_361_;
    return _e191;
}

fn function_() {
    var local: f32;
    var phi_422_: bool;
    var phi_423_: bool;
    var phi_424_: bool;
    var phi_425_: bool;
    var phi_429_: bool;
    var phi_473_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_477_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_497_: lt_math_LightPoint;
    var phi_500_: u32;
    var phi_502_: lt_math_LevelPoint;
    var phi_588_: bool;
    var phi_597_: bool;
    var phi_606_: bool;
    var phi_607_: bool;
    var phi_608_: bool;
    var phi_609_: bool;
    var phi_610_: bool;
    var phi_611_: bool;
    var phi_612_: bool;
    var phi_616_: bool;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_654_: bool;
    var phi_663_: lt_math_LightPoint;
    var phi_664_: u32;
    var phi_665_: lt_math_LevelPoint;
    var phi_666_: bool;
    var phi_498_: lt_math_LightPoint;
    var phi_501_: u32;
    var phi_503_: lt_math_LevelPoint;
    var phi_667_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_707_: bool;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_714_: bool;
    var phi_796_: f32;
    var phi_912_: f32;
    var phi_913_: f32;
    var phi_916_: f32;
    var phi_945_: f32;
    var phi_950_: f32;
    var phi_951_: bool;
    var phi_952_: f32;
    var phi_953_: bool;
    var phi_957_: f32;
    var phi_977_: f32;
    var phi_982_: f32;
    var phi_983_: bool;
    var phi_984_: f32;
    var phi_985_: bool;
    var phi_989_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1038_: i32;
    var phi_1043_: i32;
    var phi_1048_: i32;
    var phi_1053_: i32;
    var phi_1062_: i32;
    var phi_1067_: i32;
    var phi_1072_: i32;
    var phi_1077_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1193_: f32;
    var phi_1195_: evaluate_Verdict;
    var phi_1196_: bool;
    var phi_1197_: evaluate_Verdict;
    var phi_1198_: bool;
    var phi_1203_: evaluate_Verdict;
    var phi_1204_: bool;
    var phi_1206_: evaluate_Verdict;
    var phi_1207_: evaluate_Verdict;
    var phi_1208_: bool;
    var phi_1212_: evaluate_Verdict;
    var phi_1213_: evaluate_Verdict;
    var phi_1214_: bool;
    var phi_1218_: evaluate_Verdict;

    let _e41 = id_1;
    let _e48 = arrayLength((&map.member));
    let _e54 = arrayLength((&levels.member));
    let _e57 = p.member.size[0u];
    let _e59 = p.member.size[1u];
    let _e60 = lt_shaders_entry_pixel_index(_e41, _e57, _e59);
    if (bitcast<i32>(_e60.root) != 0i) {
        let _e66 = p.member.level_count;
        if (_e60.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e71 = p.member.light;
        let _e74 = samples.member[(0u + _e60.first_primitive)].normal[0u];
        let _e76 = global[0u];
        if (_e74 == _e76) {
            let _e79 = samples.member[(0u + _e60.first_primitive)].normal[1u];
            let _e81 = global[1u];
            if (_e79 == _e81) {
                let _e84 = samples.member[(0u + _e60.first_primitive)].normal[2u];
                let _e86 = global[2u];
                phi_422_ = (_e84 == _e86);
                phi_423_ = false;
            } else {
                phi_422_ = bool();
                phi_423_ = true;
            }
            let _e89 = phi_422_;
            let _e91 = phi_423_;
            phi_424_ = _e89;
            phi_425_ = _e91;
        } else {
            phi_424_ = bool();
            phi_425_ = true;
        }
        let _e93 = phi_424_;
        let _e95 = phi_425_;
        if _e95 {
            phi_429_ = false;
        } else {
            phi_429_ = _e93;
        }
        let _e97 = phi_429_;
        if !(_e97) {
            let _e100 = samples.member[(0u + _e60.first_primitive)].normal;
            let _e102 = samples.member[(0u + _e60.first_primitive)].position;
            if ((((_e100.x * (_e71.x - (_e102.x * _e71.w))) + (_e100.y * (_e71.y - (_e102.y * _e71.w)))) + (_e100.z * (_e71.z - (_e102.z * _e71.w)))) > 0f) {
                let _e126 = samples.member[(0u + _e60.first_primitive)].flags;
                let _e134 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e134.unnamed.visibility, false), _e134.unnamed_1);
                phi_473_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e140.unnamed, ((_e126 & 1u) == 0u));
            } else {
                let _e149 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e149.unnamed.visibility, false), _e149.unnamed_1);
                phi_473_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e155.unnamed, true);
            }
            let _e160 = phi_473_;
            phi_477_ = _e160;
        } else {
            let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e166.unnamed.visibility, false), _e166.unnamed_1);
            phi_477_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e172.unnamed, true);
        }
        let _e177 = phi_477_;
        if _e177.unnamed_1 {
            phi_1212_ = evaluate_Verdict(_e177.unnamed.visibility, _e177.unnamed.is_doubted);
            phi_1213_ = evaluate_Verdict();
            phi_1214_ = true;
        } else {
            let _e185 = samples.member[(0u + _e60.first_primitive)].position;
            let _e187 = p.member.map_size;
            let _e189 = (0.5f / f32(_e187));
            let _e196 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e203 = lt_math_LightPoint(vec2<f32>(_e196.uv.x, 0f), _e196.depth, _e196.is_inside);
            let _e207 = lt_math_LightPoint(_e203.uv, 0f, _e203.is_inside);
            phi_497_ = lt_math_LightPoint();
            phi_500_ = 0u;
            phi_502_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e207.uv, _e207.depth, false));
            loop {
                let _e214 = phi_497_;
                let _e216 = phi_500_;
                let _e218 = phi_502_;
                local_1 = _e218;
                local_2 = _e218;
                local_3 = _e218;
                local_4 = _e218;
                if (_e216 < _e66) {
                    if _e218.point.is_inside {
                        phi_663_ = lt_math_LightPoint();
                        phi_664_ = u32();
                        phi_665_ = lt_math_LevelPoint();
                        phi_666_ = false;
                    } else {
                        if (_e216 < _e54) {
                        } else {
                            return;
                        }
                        let _e229 = levels.member[(0u + _e216)].row_w;
                        let _e240 = ((((_e229.x * _e185.x) + (_e229.y * _e185.y)) + (_e229.z * _e185.z)) + (_e229.w * 1f));
                        let _e242 = levels.member[(0u + _e216)].row_x;
                        let _e254 = (((((_e242.x * _e185.x) + (_e242.y * _e185.y)) + (_e242.z * _e185.z)) + (_e242.w * 1f)) / _e240);
                        let _e256 = levels.member[(0u + _e216)].row_y;
                        let _e268 = (((((_e256.x * _e185.x) + (_e256.y * _e185.y)) + (_e256.z * _e185.z)) + (_e256.w * 1f)) / _e240);
                        let _e270 = levels.member[(0u + _e216)].row_z;
                        let _e281 = ((((_e270.x * _e185.x) + (_e270.y * _e185.y)) + (_e270.z * _e185.z)) + (_e270.w * 1f));
                        if (_e240 > 0f) {
                            if (_e254 >= 0f) {
                                phi_588_ = (_e254 <= 1f);
                            } else {
                                phi_588_ = false;
                            }
                            let _e286 = phi_588_;
                            if _e286 {
                                if (_e268 >= 0f) {
                                    phi_597_ = (_e268 <= 1f);
                                } else {
                                    phi_597_ = false;
                                }
                                let _e290 = phi_597_;
                                if _e290 {
                                    if (_e281 >= 0f) {
                                        phi_606_ = (_e281 <= 1f);
                                    } else {
                                        phi_606_ = false;
                                    }
                                    let _e294 = phi_606_;
                                    phi_607_ = _e294;
                                    phi_608_ = false;
                                } else {
                                    phi_607_ = bool();
                                    phi_608_ = true;
                                }
                                let _e296 = phi_607_;
                                let _e298 = phi_608_;
                                phi_609_ = _e296;
                                phi_610_ = _e298;
                            } else {
                                phi_609_ = bool();
                                phi_610_ = true;
                            }
                            let _e300 = phi_609_;
                            let _e302 = phi_610_;
                            phi_611_ = _e300;
                            phi_612_ = _e302;
                        } else {
                            phi_611_ = bool();
                            phi_612_ = true;
                        }
                        let _e304 = phi_611_;
                        let _e306 = phi_612_;
                        if _e306 {
                            phi_616_ = false;
                        } else {
                            phi_616_ = _e304;
                        }
                        let _e308 = phi_616_;
                        if _e308 {
                            if (_e254 >= _e189) {
                                if (_e254 <= (1f - _e189)) {
                                    if (_e268 >= _e189) {
                                        phi_643_ = (_e268 <= (1f - _e189));
                                        phi_644_ = false;
                                    } else {
                                        phi_643_ = bool();
                                        phi_644_ = true;
                                    }
                                    let _e316 = phi_643_;
                                    let _e318 = phi_644_;
                                    phi_645_ = _e316;
                                    phi_646_ = _e318;
                                } else {
                                    phi_645_ = bool();
                                    phi_646_ = true;
                                }
                                let _e320 = phi_645_;
                                let _e322 = phi_646_;
                                phi_647_ = _e320;
                                phi_648_ = _e322;
                            } else {
                                phi_647_ = bool();
                                phi_648_ = true;
                            }
                            let _e324 = phi_647_;
                            let _e326 = phi_648_;
                            phi_649_ = _e324;
                            phi_650_ = _e326;
                        } else {
                            phi_649_ = bool();
                            phi_650_ = true;
                        }
                        let _e328 = phi_649_;
                        let _e330 = phi_650_;
                        if _e330 {
                            phi_654_ = false;
                        } else {
                            phi_654_ = _e328;
                        }
                        let _e332 = phi_654_;
                        let _e339 = lt_math_LightPoint(vec2<f32>(_e254, _e214.uv.y), _e214.depth, _e214.is_inside);
                        let _e346 = lt_math_LightPoint(vec2<f32>(_e339.uv.x, _e268), _e339.depth, _e339.is_inside);
                        let _e350 = lt_math_LightPoint(_e346.uv, _e281, _e346.is_inside);
                        let _e354 = lt_math_LightPoint(_e350.uv, _e350.depth, _e332);
                        phi_663_ = _e354;
                        phi_664_ = (_e216 + 1u);
                        phi_665_ = lt_math_LevelPoint(_e216, _e354);
                        phi_666_ = true;
                    }
                    let _e358 = phi_663_;
                    let _e360 = phi_664_;
                    let _e362 = phi_665_;
                    let _e364 = phi_666_;
                    phi_498_ = _e358;
                    phi_501_ = _e360;
                    phi_503_ = _e362;
                    phi_667_ = _e364;
                } else {
                    phi_498_ = lt_math_LightPoint();
                    phi_501_ = u32();
                    phi_503_ = lt_math_LevelPoint();
                    phi_667_ = false;
                }
                let _e366 = phi_498_;
                let _e368 = phi_501_;
                let _e370 = phi_503_;
                let _e372 = phi_667_;
                continue;
                continuing {
                    phi_497_ = _e366;
                    phi_500_ = _e368;
                    phi_502_ = _e370;
                    break if !(_e372);
                }
            }
            let _e375 = local_1;
            if _e375.point.is_inside {
                if (0f > 0f) {
                    let _e381 = local_2;
                    if (_e381.level < _e54) {
                    } else {
                        return;
                    }
                    let _e386 = levels.member[(0u + _e381.level)];
                    let _e392 = global[0u];
                    if (_e386.row_w.x == _e392) {
                        let _e395 = global[1u];
                        if (_e386.row_w.y == _e395) {
                            let _e398 = global[2u];
                            phi_707_ = (_e386.row_w.z == _e398);
                            phi_708_ = false;
                        } else {
                            phi_707_ = bool();
                            phi_708_ = true;
                        }
                        let _e401 = phi_707_;
                        let _e403 = phi_708_;
                        phi_709_ = _e401;
                        phi_710_ = _e403;
                    } else {
                        phi_709_ = bool();
                        phi_710_ = true;
                    }
                    let _e405 = phi_709_;
                    let _e407 = phi_710_;
                    if _e407 {
                        phi_714_ = false;
                    } else {
                        phi_714_ = _e405;
                    }
                    let _e409 = phi_714_;
                    if _e409 {
                        let _e411 = samples.member[(0u + _e60.first_primitive)].normal;
                        let _e413 = p.member.map_size;
                        let _e483 = ((abs(((((_e386.row_x.x * _e411.x) + (_e386.row_x.y * _e411.y)) + (_e386.row_x.z * _e411.z)) / (((_e386.row_x.x * _e386.row_x.x) + (_e386.row_x.y * _e386.row_x.y)) + (_e386.row_x.z * _e386.row_x.z)))) + abs(((((_e386.row_y.x * _e411.x) + (_e386.row_y.y * _e411.y)) + (_e386.row_y.z * _e411.z)) / (((_e386.row_y.x * _e386.row_y.x) + (_e386.row_y.y * _e386.row_y.y)) + (_e386.row_y.z * _e386.row_y.z))))) / (abs(((((_e386.row_z.x * _e411.x) + (_e386.row_z.y * _e411.y)) + (_e386.row_z.z * _e411.z)) / (((_e386.row_z.x * _e386.row_z.x) + (_e386.row_z.y * _e386.row_z.y)) + (_e386.row_z.z * _e386.row_z.z)))) * f32(_e413)));
                        if (_e483 < 0.002f) {
                            phi_796_ = _e483;
                        } else {
                            phi_796_ = 0.002f;
                        }
                        let _e486 = phi_796_;
                        phi_913_ = _e486;
                    } else {
                        let _e488 = p.member.map_size;
                        let _e494 = samples.member[(0u + _e60.first_primitive)].position;
                        let _e505 = ((((_e386.row_w.x * _e494.x) + (_e386.row_w.y * _e494.y)) + (_e386.row_w.z * _e494.z)) + _e386.row_w.w);
                        let _e518 = ((_e386.row_x.x - (_e386.row_w.x * _e375.point.uv.x)) / _e505);
                        let _e519 = ((_e386.row_x.y - (_e386.row_w.y * _e375.point.uv.x)) / _e505);
                        let _e520 = ((_e386.row_x.z - (_e386.row_w.z * _e375.point.uv.x)) / _e505);
                        let _e533 = ((_e386.row_y.x - (_e386.row_w.x * _e375.point.uv.y)) / _e505);
                        let _e534 = ((_e386.row_y.y - (_e386.row_w.y * _e375.point.uv.y)) / _e505);
                        let _e535 = ((_e386.row_y.z - (_e386.row_w.z * _e375.point.uv.y)) / _e505);
                        let _e541 = samples.member[(0u + _e60.first_primitive)].normal;
                        let _e546 = ((_e534 * _e541.z) - (_e541.y * _e535));
                        let _e551 = ((_e535 * _e541.x) - (_e541.z * _e533));
                        let _e556 = ((_e533 * _e541.y) - (_e541.x * _e534));
                        let _e558 = samples.member[(0u + _e60.first_primitive)].normal;
                        let _e563 = ((_e519 * _e558.z) - (_e558.y * _e520));
                        let _e568 = ((_e520 * _e558.x) - (_e558.z * _e518));
                        let _e573 = ((_e518 * _e558.y) - (_e558.x * _e519));
                        let _e600 = ((abs(((((_e386.row_z.x * _e546) + (_e386.row_z.y * _e551)) + (_e386.row_z.z * _e556)) / (((_e518 * _e546) + (_e519 * _e551)) + (_e520 * _e556)))) + abs(((((_e386.row_z.x * _e563) + (_e386.row_z.y * _e568)) + (_e386.row_z.z * _e573)) / (((_e533 * _e563) + (_e534 * _e568)) + (_e535 * _e573))))) / f32(_e488));
                        if (_e600 < 0.002f) {
                            phi_912_ = _e600;
                        } else {
                            phi_912_ = 0.002f;
                        }
                        let _e603 = phi_912_;
                        phi_913_ = _e603;
                    }
                    let _e605 = phi_913_;
                    phi_916_ = (_e375.point.depth - (0f * _e605));
                } else {
                    phi_916_ = _e375.point.depth;
                }
                let _e609 = phi_916_;
                let _e615 = p.member.map_size;
                let _e616 = f32(_e615);
                let _e619 = ((_e375.point.uv.x * _e616) - 0.5f);
                let _e620 = ((_e375.point.uv.y * _e616) - 0.5f);
                if (_e619 > -8388608f) {
                    let _e632 = f32(select(0i, select(select(i32(_e619), i32(-2147483648), (_e619 < bitcast<f32>(3472883712u))), 2147483647i, (_e619 > bitcast<f32>(1325400063u))), (_e619 == _e619)));
                    if (_e632 > _e619) {
                        phi_945_ = 1f;
                    } else {
                        phi_945_ = 0f;
                    }
                    let _e635 = phi_945_;
                    if (_e619 < 8388608f) {
                        phi_950_ = (_e632 - _e635);
                        phi_951_ = false;
                    } else {
                        phi_950_ = f32();
                        phi_951_ = true;
                    }
                    let _e638 = phi_950_;
                    let _e640 = phi_951_;
                    phi_952_ = _e638;
                    phi_953_ = _e640;
                } else {
                    phi_952_ = f32();
                    phi_953_ = true;
                }
                let _e642 = phi_952_;
                let _e644 = phi_953_;
                if _e644 {
                    phi_957_ = _e619;
                } else {
                    phi_957_ = _e642;
                }
                let _e646 = phi_957_;
                if (_e620 > -8388608f) {
                    let _e658 = f32(select(0i, select(select(i32(_e620), i32(-2147483648), (_e620 < bitcast<f32>(3472883712u))), 2147483647i, (_e620 > bitcast<f32>(1325400063u))), (_e620 == _e620)));
                    if (_e658 > _e620) {
                        phi_977_ = 1f;
                    } else {
                        phi_977_ = 0f;
                    }
                    let _e661 = phi_977_;
                    if (_e620 < 8388608f) {
                        phi_982_ = (_e658 - _e661);
                        phi_983_ = false;
                    } else {
                        phi_982_ = f32();
                        phi_983_ = true;
                    }
                    let _e664 = phi_982_;
                    let _e666 = phi_983_;
                    phi_984_ = _e664;
                    phi_985_ = _e666;
                } else {
                    phi_984_ = f32();
                    phi_985_ = true;
                }
                let _e668 = phi_984_;
                let _e670 = phi_985_;
                if _e670 {
                    phi_989_ = _e620;
                } else {
                    phi_989_ = _e668;
                }
                let _e672 = phi_989_;
                let _e673 = (_e619 - _e646);
                let _e674 = (_e620 - _e672);
                let _e683 = select(0i, select(select(i32(_e646), i32(-2147483648), (_e646 < bitcast<f32>(3472883712u))), 2147483647i, (_e646 > bitcast<f32>(1325400063u))), (_e646 == _e646));
                let _e692 = select(0i, select(select(i32(_e672), i32(-2147483648), (_e672 < bitcast<f32>(3472883712u))), 2147483647i, (_e672 > bitcast<f32>(1325400063u))), (_e672 == _e672));
                let _e695 = ((1f - _e673) * (1f - _e674));
                let _e697 = (_e673 * (1f - _e674));
                let _e699 = ((1f - _e673) * _e674);
                let _e700 = (_e673 * _e674);
                let _e702 = p.member.test;
                let _e703 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e702);
                let _e705 = p.member.map_size;
                let _e707 = local_3;
                local = _e703;
                let _e710 = ((_e707.level * _e705) * _e705);
                let _e712 = (bitcast<i32>(_e705) - 1i);
                if (_e683 > 0i) {
                    phi_1038_ = _e683;
                } else {
                    phi_1038_ = 0i;
                }
                let _e715 = phi_1038_;
                if (_e692 > 0i) {
                    phi_1043_ = _e692;
                } else {
                    phi_1043_ = 0i;
                }
                let _e718 = phi_1043_;
                if (_e715 < _e712) {
                    phi_1048_ = _e715;
                } else {
                    phi_1048_ = _e712;
                }
                let _e721 = phi_1048_;
                if (_e718 < _e712) {
                    phi_1053_ = _e718;
                } else {
                    phi_1053_ = _e712;
                }
                let _e724 = phi_1053_;
                let _e725 = bitcast<u32>(_e721);
                let _e727 = (_e683 + 1i);
                let _e728 = (_e692 + 1i);
                if (_e727 > 0i) {
                    phi_1062_ = _e727;
                } else {
                    phi_1062_ = 0i;
                }
                let _e731 = phi_1062_;
                if (_e728 > 0i) {
                    phi_1067_ = _e728;
                } else {
                    phi_1067_ = 0i;
                }
                let _e734 = phi_1067_;
                if (_e731 < _e712) {
                    phi_1072_ = _e731;
                } else {
                    phi_1072_ = _e712;
                }
                let _e737 = phi_1072_;
                if (_e734 < _e712) {
                    phi_1077_ = _e734;
                } else {
                    phi_1077_ = _e712;
                }
                let _e740 = phi_1077_;
                let _e741 = bitcast<u32>(_e737);
                let _e743 = (bitcast<u32>(_e724) * _e705);
                let _e744 = (bitcast<u32>(_e740) * _e705);
                let _e749 = ((_e743 + _e725) + _e710);
                let _e750 = ((_e743 + _e741) + _e710);
                let _e751 = ((_e744 + _e725) + _e710);
                let _e752 = ((_e744 + _e741) + _e710);
                if (_e749 < _e48) {
                } else {
                    return;
                }
                let _e756 = map.member[(0u + _e749)];
                if (_e750 < _e48) {
                } else {
                    return;
                }
                let _e768 = map.member[(0u + _e750)];
                if (_e751 < _e48) {
                } else {
                    return;
                }
                let _e784 = map.member[(0u + _e751)];
                if (_e752 < _e48) {
                } else {
                    return;
                }
                let _e800 = map.member[(0u + _e752)];
                let _e814 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e756.x * _e695) + (_e768.x * _e697)) + (_e784.x * _e699)) + (_e800.x * _e700)), ((((_e756.y * _e695) + (_e768.y * _e697)) + (_e784.y * _e699)) + (_e800.y * _e700)), ((((_e756.z * _e695) + (_e768.z * _e697)) + (_e784.z * _e699)) + (_e800.z * _e700)), ((((_e756.w * _e695) + (_e768.w * _e697)) + (_e784.w * _e699)) + (_e800.w * _e700))), _e609);
                let _e816 = p.member.fade_uv;
                if (_e816 > 0f) {
                    let _e819 = local_4;
                    if ((_e819.level + 1u) == _e66) {
                        let _e828 = p.member.fade_uv;
                        let _e830 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e375.point.uv.x, (1f - _e375.point.uv.x));
                        let _e832 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e375.point.uv.y, (1f - _e375.point.uv.y));
                        let _e833 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e830, _e832);
                        if (_e833 < _e828) {
                            phi_1193_ = (1f - ((1f - _e814) * (_e833 / _e828)));
                        } else {
                            phi_1193_ = _e814;
                        }
                        let _e840 = phi_1193_;
                        phi_1195_ = evaluate_Verdict(_e840, false);
                        phi_1196_ = false;
                    } else {
                        phi_1195_ = evaluate_Verdict();
                        phi_1196_ = true;
                    }
                    let _e843 = phi_1195_;
                    let _e845 = phi_1196_;
                    phi_1197_ = _e843;
                    phi_1198_ = _e845;
                } else {
                    phi_1197_ = evaluate_Verdict();
                    phi_1198_ = true;
                }
                let _e847 = phi_1197_;
                let _e849 = phi_1198_;
                if _e849 {
                    phi_1203_ = evaluate_Verdict(_e814, false);
                    phi_1204_ = false;
                } else {
                    phi_1203_ = evaluate_Verdict();
                    phi_1204_ = true;
                }
                let _e852 = phi_1203_;
                let _e854 = phi_1204_;
                phi_1206_ = _e852;
                phi_1207_ = _e847;
                phi_1208_ = _e854;
            } else {
                phi_1206_ = evaluate_Verdict();
                phi_1207_ = evaluate_Verdict(1f, false);
                phi_1208_ = true;
            }
            let _e857 = phi_1206_;
            let _e859 = phi_1207_;
            let _e861 = phi_1208_;
            if _e861 {
            }
            phi_1212_ = _e859;
            phi_1213_ = _e857;
            phi_1214_ = _e861;
        }
        let _e863 = phi_1212_;
        let _e865 = phi_1213_;
        let _e867 = phi_1214_;
        if _e867 {
            phi_1218_ = _e863;
        } else {
            phi_1218_ = _e865;
        }
        let _e869 = phi_1218_;
        if (_e60.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e60.first_primitive)] = _e869.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
