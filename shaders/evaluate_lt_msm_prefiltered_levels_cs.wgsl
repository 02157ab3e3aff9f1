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

struct type_39 {
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
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_39;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_154_: lt_bvh_traverse_Tree;
    var phi_155_: bool;
    var phi_156_: lt_bvh_traverse_Tree;
    var phi_157_: bool;
    var phi_162_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_154_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_155_ = false;
        } else {
            phi_154_ = lt_bvh_traverse_Tree();
            phi_155_ = true;
        }
        let _e56 = phi_154_;
        let _e58 = phi_155_;
        phi_156_ = _e56;
        phi_157_ = _e58;
    } else {
        phi_156_ = lt_bvh_traverse_Tree();
        phi_157_ = true;
    }
    let _e60 = phi_156_;
    let _e62 = phi_157_;
    if _e62 {
        phi_162_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_162_ = _e60;
    }
    let _e67 = phi_162_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_219_: bool;
    var phi_241_: f32;
    var phi_242_: f32;
    var phi_243_: f32;
    var phi_244_: f32;
    var phi_245_: bool;
    var phi_246_: f32;
    var phi_247_: bool;
    var phi_285_: vec2<f32>;
    var phi_319_: f32;
    var phi_320_: f32;
    var phi_321_: f32;
    var phi_350_: f32;
    var phi_351_: f32;
    var phi_352_: f32;
    var phi_356_: f32;
    var phi_357_: f32;
    var phi_358_: f32;
    var phi_359_: f32;

    let _e46 = (*param_4);
    let _e47 = (1f - _e46);
    let _e56 = (0.5f * _e46);
    let _e57 = ((param_5.x * _e47) + _e56);
    let _e58 = ((param_5.y * _e47) + _e56);
    let _e60 = ((param_5.w * _e47) + _e56);
    let _e62 = (_e58 - (_e57 * _e57));
    let _e64 = (((param_5.z * _e47) + _e56) - (_e57 * _e58));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_213_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_212_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_211_ = 1f;
            } else {
                phi_211_ = param_6;
            }
            let _e76 = phi_211_;
            phi_212_ = _e76;
        }
        let _e78 = phi_212_;
        phi_213_ = _e78;
    }
    let _e80 = phi_213_;
    if (_e57 == _e60) {
        phi_219_ = (_e57 > 0.5f);
    } else {
        phi_219_ = false;
    }
    let _e84 = phi_219_;
    if _e84 {
        if (_e80 > 0f) {
            if ((bitcast<u32>(_e57) & 2147483647u) > 2139095040u) {
                phi_243_ = _e57;
            } else {
                if (_e57 < 0f) {
                    phi_242_ = 0f;
                } else {
                    if (_e57 > 1f) {
                        phi_241_ = 1f;
                    } else {
                        phi_241_ = _e57;
                    }
                    let _e92 = phi_241_;
                    phi_242_ = _e92;
                }
                let _e94 = phi_242_;
                phi_243_ = _e94;
            }
            let _e96 = phi_243_;
            phi_244_ = _e96;
            phi_245_ = false;
        } else {
            phi_244_ = f32();
            phi_245_ = true;
        }
        let _e98 = phi_244_;
        let _e100 = phi_245_;
        phi_246_ = _e98;
        phi_247_ = _e100;
    } else {
        phi_246_ = f32();
        phi_247_ = true;
    }
    let _e102 = phi_246_;
    let _e104 = phi_247_;
    if _e104 {
        let _e105 = (_e64 / _e62);
        let _e106 = (_e80 - _e57);
        let _e112 = (((((_e80 * _e80) - _e58) - (_e105 * _e106)) * _e62) / (((_e60 - (_e58 * _e58)) * _e62) - (_e64 * _e64)));
        let _e115 = ((_e106 / _e62) - (_e105 * _e112));
        let _e121 = ((0.5f * _e115) / _e112);
        let _e124 = ((_e121 * _e121) - (((1f - (_e115 * _e57)) - (_e112 * _e58)) / _e112));
        if (_e124 >= 0f) {
            let _e126 = sqrt(_e124);
            phi_285_ = vec2<f32>((-(_e121) - _e126), (-(_e121) + _e126));
        } else {
            phi_285_ = vec2(bitcast<f32>((bitcast<u32>(_e124) | 2143289344u)));
        }
        let _e137 = phi_285_;
        if (_e80 <= _e137.x) {
            phi_358_ = 1f;
        } else {
            if (_e80 > _e137.y) {
                let _e150 = (((_e58 - (_e57 * (_e137.x + _e137.y))) + (_e137.x * _e137.y)) / ((_e80 - _e137.x) * (_e80 - _e137.y)));
                if ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u) {
                    phi_321_ = _e150;
                } else {
                    if (_e150 < 0f) {
                        phi_320_ = 0f;
                    } else {
                        if (_e150 > 1f) {
                            phi_319_ = 1f;
                        } else {
                            phi_319_ = _e150;
                        }
                        let _e157 = phi_319_;
                        phi_320_ = _e157;
                    }
                    let _e159 = phi_320_;
                    phi_321_ = _e159;
                }
                let _e161 = phi_321_;
                phi_357_ = _e161;
            } else {
                if (_e80 > _e137.x) {
                    let _e172 = (1f - (((_e58 - (_e57 * (_e80 + _e137.y))) + (_e80 * _e137.y)) / ((_e137.x - _e80) * (_e137.x - _e137.y))));
                    if ((bitcast<u32>(_e172) & 2147483647u) > 2139095040u) {
                        phi_352_ = _e172;
                    } else {
                        if (_e172 < 0f) {
                            phi_351_ = 0f;
                        } else {
                            if (_e172 > 1f) {
                                phi_350_ = 1f;
                            } else {
                                phi_350_ = _e172;
                            }
                            let _e179 = phi_350_;
                            phi_351_ = _e179;
                        }
                        let _e181 = phi_351_;
                        phi_352_ = _e181;
                    }
                    let _e183 = phi_352_;
                    phi_356_ = _e183;
                } else {
                    phi_356_ = bitcast<f32>((bitcast<u32>(_e137.x) | 2143289344u));
                }
                let _e188 = phi_356_;
                phi_357_ = _e188;
            }
            let _e190 = phi_357_;
            phi_358_ = _e190;
        }
        let _e192 = phi_358_;
        phi_359_ = _e192;
    } else {
        phi_359_ = _e102;
    }
    let _e194 = phi_359_;
    return _e194;
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
    var phi_1221_: bool;
    var phi_1229_: bool;
    var phi_1241_: bool;
    var phi_1242_: bool;
    var phi_1246_: f32;
    var phi_1252_: f32;
    var phi_1254_: evaluate_Verdict;
    var phi_1264_: u32;
    var phi_1273_: f32;
    var phi_1275_: evaluate_Verdict;
    var phi_1276_: bool;
    var phi_1277_: evaluate_Verdict;
    var phi_1278_: bool;
    var phi_1283_: evaluate_Verdict;
    var phi_1288_: evaluate_Verdict;
    var phi_1289_: evaluate_Verdict;

    let _e44 = id_1;
    let _e51 = arrayLength((&map.member));
    let _e57 = arrayLength((&levels.member));
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e44, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        let _e69 = p.member.level_count;
        if (_e63.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e76 = samples.member[(0u + _e63.first_primitive)].normal[0u];
        let _e78 = global[0u];
        if (_e76 == _e78) {
            let _e81 = samples.member[(0u + _e63.first_primitive)].normal[1u];
            let _e83 = global[1u];
            if (_e81 == _e83) {
                let _e86 = samples.member[(0u + _e63.first_primitive)].normal[2u];
                let _e88 = global[2u];
                phi_419_ = (_e86 == _e88);
                phi_420_ = false;
            } else {
                phi_419_ = bool();
                phi_420_ = true;
            }
            let _e91 = phi_419_;
            let _e93 = phi_420_;
            phi_421_ = _e91;
            phi_422_ = _e93;
        } else {
            phi_421_ = bool();
            phi_422_ = true;
        }
        let _e95 = phi_421_;
        let _e97 = phi_422_;
        if _e97 {
            phi_426_ = false;
        } else {
            phi_426_ = _e95;
        }
        let _e99 = phi_426_;
        if !(_e99) {
            let _e102 = samples.member[(0u + _e63.first_primitive)].position;
            let _e104 = p.member.light.place;
            let _e110 = p.member.light.place[3u];
            let _e117 = (_e104.x - (_e102.x * _e110));
            let _e118 = (_e104.y - (_e102.y * _e110));
            let _e119 = (_e104.z - (_e102.z * _e110));
            let _e121 = samples.member[(0u + _e63.first_primitive)].normal;
            if ((((_e121.x * _e117) + (_e121.y * _e118)) + (_e121.z * _e119)) > 0f) {
                let _e135 = (((_e117 * _e117) + (_e118 * _e118)) + (_e119 * _e119));
                let _e137 = p.member.light.axis;
                let _e149 = p.member.light.place[3u];
                if (_e149 == 0f) {
                    phi_497_ = true;
                } else {
                    let _e152 = p.member.light.range_squared;
                    if (_e135 <= _e152) {
                        let _e155 = p.member.light.cos_outer;
                        phi_496_ = (-((((_e117 * _e137.x) + (_e118 * _e137.y)) + (_e119 * _e137.z))) >= (_e155 * sqrt(_e135)));
                    } else {
                        phi_496_ = false;
                    }
                    let _e160 = phi_496_;
                    phi_497_ = _e160;
                }
                let _e162 = phi_497_;
                if _e162 {
                    let _e164 = samples.member[(0u + _e63.first_primitive)].flags;
                    let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e172.unnamed.visibility, false), _e172.unnamed_1);
                    phi_508_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e178.unnamed, ((_e164 & 1u) == 0u));
                    phi_509_ = false;
                } else {
                    phi_508_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_509_ = true;
                }
                let _e183 = phi_508_;
                let _e185 = phi_509_;
                phi_510_ = _e183;
                phi_511_ = _e185;
            } else {
                phi_510_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_511_ = true;
            }
            let _e187 = phi_510_;
            let _e189 = phi_511_;
            if _e189 {
                let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e195.unnamed.visibility, false), _e195.unnamed_1);
                phi_518_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e201.unnamed, true);
            } else {
                phi_518_ = _e187;
            }
            let _e206 = phi_518_;
            phi_522_ = _e206;
        } else {
            let _e212 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e212.unnamed.visibility, false), _e212.unnamed_1);
            phi_522_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e218.unnamed, true);
        }
        let _e223 = phi_522_;
        if _e223.unnamed_1 {
            phi_1289_ = evaluate_Verdict(_e223.unnamed.visibility, _e223.unnamed.is_doubted);
        } else {
            let _e231 = samples.member[(0u + _e63.first_primitive)].position;
            let _e233 = p.member.map_size;
            let _e235 = (0.5f / f32(_e233));
            let _e242 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e249 = lt_math_LightPoint(vec2<f32>(_e242.uv.x, 0f), _e242.depth, _e242.is_inside);
            let _e253 = lt_math_LightPoint(_e249.uv, 0f, _e249.is_inside);
            phi_542_ = lt_math_LightPoint();
            phi_545_ = 0u;
            phi_547_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e253.uv, _e253.depth, false));
            loop {
                let _e260 = phi_542_;
                let _e262 = phi_545_;
                let _e264 = phi_547_;
                local_1 = _e264;
                local_2 = _e264;
                local_3 = _e264;
                if (_e262 < _e69) {
                    if _e264.point.is_inside {
                        phi_708_ = lt_math_LightPoint();
                        phi_709_ = u32();
                        phi_710_ = lt_math_LevelPoint();
                        phi_711_ = false;
                    } else {
                        if (_e262 < _e57) {
                        } else {
                            return;
                        }
                        let _e275 = levels.member[(0u + _e262)].row_w;
                        let _e286 = ((((_e275.x * _e231.x) + (_e275.y * _e231.y)) + (_e275.z * _e231.z)) + (_e275.w * 1f));
                        let _e288 = levels.member[(0u + _e262)].row_x;
                        let _e300 = (((((_e288.x * _e231.x) + (_e288.y * _e231.y)) + (_e288.z * _e231.z)) + (_e288.w * 1f)) / _e286);
                        let _e302 = levels.member[(0u + _e262)].row_y;
                        let _e314 = (((((_e302.x * _e231.x) + (_e302.y * _e231.y)) + (_e302.z * _e231.z)) + (_e302.w * 1f)) / _e286);
                        let _e316 = levels.member[(0u + _e262)].row_z;
                        let _e327 = ((((_e316.x * _e231.x) + (_e316.y * _e231.y)) + (_e316.z * _e231.z)) + (_e316.w * 1f));
                        if (_e286 > 0f) {
                            if (_e300 >= 0f) {
                                phi_633_ = (_e300 <= 1f);
                            } else {
                                phi_633_ = false;
                            }
                            let _e332 = phi_633_;
                            if _e332 {
                                if (_e314 >= 0f) {
                                    phi_642_ = (_e314 <= 1f);
                                } else {
                                    phi_642_ = false;
                                }
                                let _e336 = phi_642_;
                                if _e336 {
                                    if (_e327 >= 0f) {
                                        phi_651_ = (_e327 <= 1f);
                                    } else {
                                        phi_651_ = false;
                                    }
                                    let _e340 = phi_651_;
                                    phi_652_ = _e340;
                                    phi_653_ = false;
                                } else {
                                    phi_652_ = bool();
                                    phi_653_ = true;
                                }
                                let _e342 = phi_652_;
                                let _e344 = phi_653_;
                                phi_654_ = _e342;
                                phi_655_ = _e344;
                            } else {
                                phi_654_ = bool();
                                phi_655_ = true;
                            }
                            let _e346 = phi_654_;
                            let _e348 = phi_655_;
                            phi_656_ = _e346;
                            phi_657_ = _e348;
                        } else {
                            phi_656_ = bool();
                            phi_657_ = true;
                        }
                        let _e350 = phi_656_;
                        let _e352 = phi_657_;
                        if _e352 {
                            phi_661_ = false;
                        } else {
                            phi_661_ = _e350;
                        }
                        let _e354 = phi_661_;
                        if _e354 {
                            if (_e300 >= _e235) {
                                if (_e300 <= (1f - _e235)) {
                                    if (_e314 >= _e235) {
                                        phi_688_ = (_e314 <= (1f - _e235));
                                        phi_689_ = false;
                                    } else {
                                        phi_688_ = bool();
                                        phi_689_ = true;
                                    }
                                    let _e362 = phi_688_;
                                    let _e364 = phi_689_;
                                    phi_690_ = _e362;
                                    phi_691_ = _e364;
                                } else {
                                    phi_690_ = bool();
                                    phi_691_ = true;
                                }
                                let _e366 = phi_690_;
                                let _e368 = phi_691_;
                                phi_692_ = _e366;
                                phi_693_ = _e368;
                            } else {
                                phi_692_ = bool();
                                phi_693_ = true;
                            }
                            let _e370 = phi_692_;
                            let _e372 = phi_693_;
                            phi_694_ = _e370;
                            phi_695_ = _e372;
                        } else {
                            phi_694_ = bool();
                            phi_695_ = true;
                        }
                        let _e374 = phi_694_;
                        let _e376 = phi_695_;
                        if _e376 {
                            phi_699_ = false;
                        } else {
                            phi_699_ = _e374;
                        }
                        let _e378 = phi_699_;
                        let _e385 = lt_math_LightPoint(vec2<f32>(_e300, _e260.uv.y), _e260.depth, _e260.is_inside);
                        let _e392 = lt_math_LightPoint(vec2<f32>(_e385.uv.x, _e314), _e385.depth, _e385.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e327, _e392.is_inside);
                        let _e400 = lt_math_LightPoint(_e396.uv, _e396.depth, _e378);
                        phi_708_ = _e400;
                        phi_709_ = (_e262 + 1u);
                        phi_710_ = lt_math_LevelPoint(_e262, _e400);
                        phi_711_ = true;
                    }
                    let _e404 = phi_708_;
                    let _e406 = phi_709_;
                    let _e408 = phi_710_;
                    let _e410 = phi_711_;
                    phi_543_ = _e404;
                    phi_546_ = _e406;
                    phi_548_ = _e408;
                    phi_712_ = _e410;
                } else {
                    phi_543_ = lt_math_LightPoint();
                    phi_546_ = u32();
                    phi_548_ = lt_math_LevelPoint();
                    phi_712_ = false;
                }
                let _e412 = phi_543_;
                let _e414 = phi_546_;
                let _e416 = phi_548_;
                let _e418 = phi_712_;
                continue;
                continuing {
                    phi_542_ = _e412;
                    phi_545_ = _e414;
                    phi_547_ = _e416;
                    break if !(_e418);
                }
            }
            let _e421 = local_1;
            if _e421.point.is_inside {
                if (0f > 0f) {
                    let _e427 = local_2;
                    if (_e427.level < _e57) {
                    } else {
                        return;
                    }
                    let _e432 = levels.member[(0u + _e427.level)];
                    let _e438 = global[0u];
                    if (_e432.row_w.x == _e438) {
                        let _e441 = global[1u];
                        if (_e432.row_w.y == _e441) {
                            let _e444 = global[2u];
                            phi_752_ = (_e432.row_w.z == _e444);
                            phi_753_ = false;
                        } else {
                            phi_752_ = bool();
                            phi_753_ = true;
                        }
                        let _e447 = phi_752_;
                        let _e449 = phi_753_;
                        phi_754_ = _e447;
                        phi_755_ = _e449;
                    } else {
                        phi_754_ = bool();
                        phi_755_ = true;
                    }
                    let _e451 = phi_754_;
                    let _e453 = phi_755_;
                    if _e453 {
                        phi_759_ = false;
                    } else {
                        phi_759_ = _e451;
                    }
                    let _e455 = phi_759_;
                    if _e455 {
                        let _e457 = samples.member[(0u + _e63.first_primitive)].normal;
                        let _e459 = p.member.map_size;
                        let _e529 = ((abs(((((_e432.row_x.x * _e457.x) + (_e432.row_x.y * _e457.y)) + (_e432.row_x.z * _e457.z)) / (((_e432.row_x.x * _e432.row_x.x) + (_e432.row_x.y * _e432.row_x.y)) + (_e432.row_x.z * _e432.row_x.z)))) + abs(((((_e432.row_y.x * _e457.x) + (_e432.row_y.y * _e457.y)) + (_e432.row_y.z * _e457.z)) / (((_e432.row_y.x * _e432.row_y.x) + (_e432.row_y.y * _e432.row_y.y)) + (_e432.row_y.z * _e432.row_y.z))))) / (abs(((((_e432.row_z.x * _e457.x) + (_e432.row_z.y * _e457.y)) + (_e432.row_z.z * _e457.z)) / (((_e432.row_z.x * _e432.row_z.x) + (_e432.row_z.y * _e432.row_z.y)) + (_e432.row_z.z * _e432.row_z.z)))) * f32(_e459)));
                        if (_e529 < 0.002f) {
                            phi_841_ = _e529;
                        } else {
                            phi_841_ = 0.002f;
                        }
                        let _e532 = phi_841_;
                        phi_960_ = _e532;
                    } else {
                        let _e534 = p.member.map_size;
                        let _e540 = samples.member[(0u + _e63.first_primitive)].position;
                        let _e551 = ((((_e432.row_w.x * _e540.x) + (_e432.row_w.y * _e540.y)) + (_e432.row_w.z * _e540.z)) + _e432.row_w.w);
                        let _e564 = ((_e432.row_x.x - (_e432.row_w.x * _e421.point.uv.x)) / _e551);
                        let _e565 = ((_e432.row_x.y - (_e432.row_w.y * _e421.point.uv.x)) / _e551);
                        let _e566 = ((_e432.row_x.z - (_e432.row_w.z * _e421.point.uv.x)) / _e551);
                        let _e579 = ((_e432.row_y.x - (_e432.row_w.x * _e421.point.uv.y)) / _e551);
                        let _e580 = ((_e432.row_y.y - (_e432.row_w.y * _e421.point.uv.y)) / _e551);
                        let _e581 = ((_e432.row_y.z - (_e432.row_w.z * _e421.point.uv.y)) / _e551);
                        let _e587 = samples.member[(0u + _e63.first_primitive)].normal;
                        let _e592 = ((_e580 * _e587.z) - (_e587.y * _e581));
                        let _e597 = ((_e581 * _e587.x) - (_e587.z * _e579));
                        let _e602 = ((_e579 * _e587.y) - (_e587.x * _e580));
                        let _e604 = samples.member[(0u + _e63.first_primitive)].normal;
                        let _e609 = ((_e565 * _e604.z) - (_e604.y * _e566));
                        let _e614 = ((_e566 * _e604.x) - (_e604.z * _e564));
                        let _e619 = ((_e564 * _e604.y) - (_e604.x * _e565));
                        let _e646 = ((abs(((((_e432.row_z.x * _e592) + (_e432.row_z.y * _e597)) + (_e432.row_z.z * _e602)) / (((_e564 * _e592) + (_e565 * _e597)) + (_e566 * _e602)))) + abs(((((_e432.row_z.x * _e609) + (_e432.row_z.y * _e614)) + (_e432.row_z.z * _e619)) / (((_e579 * _e609) + (_e580 * _e614)) + (_e581 * _e619))))) / f32(_e534));
                        let _e648 = (16f / f32(_e534));
                        if (_e646 < _e648) {
                            phi_959_ = _e646;
                        } else {
                            phi_959_ = _e648;
                        }
                        let _e651 = phi_959_;
                        phi_960_ = _e651;
                    }
                    let _e653 = phi_960_;
                    phi_963_ = (_e421.point.depth - (0f * _e653));
                } else {
                    phi_963_ = _e421.point.depth;
                }
                let _e657 = phi_963_;
                let _e663 = p.member.map_size;
                let _e664 = f32(_e663);
                let _e667 = ((_e421.point.uv.x * _e664) - 0.5f);
                let _e668 = ((_e421.point.uv.y * _e664) - 0.5f);
                if (_e667 > -8388608f) {
                    let _e680 = f32(select(0i, select(select(i32(_e667), i32(-2147483648), (_e667 < bitcast<f32>(3472883712u))), 2147483647i, (_e667 > bitcast<f32>(1325400063u))), (_e667 == _e667)));
                    if (_e680 > _e667) {
                        phi_992_ = 1f;
                    } else {
                        phi_992_ = 0f;
                    }
                    let _e683 = phi_992_;
                    if (_e667 < 8388608f) {
                        phi_997_ = (_e680 - _e683);
                        phi_998_ = false;
                    } else {
                        phi_997_ = f32();
                        phi_998_ = true;
                    }
                    let _e686 = phi_997_;
                    let _e688 = phi_998_;
                    phi_999_ = _e686;
                    phi_1000_ = _e688;
                } else {
                    phi_999_ = f32();
                    phi_1000_ = true;
                }
                let _e690 = phi_999_;
                let _e692 = phi_1000_;
                if _e692 {
                    phi_1004_ = _e667;
                } else {
                    phi_1004_ = _e690;
                }
                let _e694 = phi_1004_;
                if (_e668 > -8388608f) {
                    let _e706 = f32(select(0i, select(select(i32(_e668), i32(-2147483648), (_e668 < bitcast<f32>(3472883712u))), 2147483647i, (_e668 > bitcast<f32>(1325400063u))), (_e668 == _e668)));
                    if (_e706 > _e668) {
                        phi_1024_ = 1f;
                    } else {
                        phi_1024_ = 0f;
                    }
                    let _e709 = phi_1024_;
                    if (_e668 < 8388608f) {
                        phi_1029_ = (_e706 - _e709);
                        phi_1030_ = false;
                    } else {
                        phi_1029_ = f32();
                        phi_1030_ = true;
                    }
                    let _e712 = phi_1029_;
                    let _e714 = phi_1030_;
                    phi_1031_ = _e712;
                    phi_1032_ = _e714;
                } else {
                    phi_1031_ = f32();
                    phi_1032_ = true;
                }
                let _e716 = phi_1031_;
                let _e718 = phi_1032_;
                if _e718 {
                    phi_1036_ = _e668;
                } else {
                    phi_1036_ = _e716;
                }
                let _e720 = phi_1036_;
                let _e721 = (_e667 - _e694);
                let _e722 = (_e668 - _e720);
                let _e731 = select(0i, select(select(i32(_e694), i32(-2147483648), (_e694 < bitcast<f32>(3472883712u))), 2147483647i, (_e694 > bitcast<f32>(1325400063u))), (_e694 == _e694));
                let _e740 = select(0i, select(select(i32(_e720), i32(-2147483648), (_e720 < bitcast<f32>(3472883712u))), 2147483647i, (_e720 > bitcast<f32>(1325400063u))), (_e720 == _e720));
                let _e743 = ((1f - _e721) * (1f - _e722));
                let _e745 = (_e721 * (1f - _e722));
                let _e747 = ((1f - _e721) * _e722);
                let _e748 = (_e721 * _e722);
                let _e750 = p.member.test;
                let _e751 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e750);
                let _e753 = p.member.map_size;
                let _e755 = local_3;
                local = _e751;
                let _e758 = ((_e755.level * _e753) * _e753);
                let _e760 = (bitcast<i32>(_e753) - 1i);
                if (_e731 > 0i) {
                    phi_1085_ = _e731;
                } else {
                    phi_1085_ = 0i;
                }
                let _e763 = phi_1085_;
                if (_e740 > 0i) {
                    phi_1090_ = _e740;
                } else {
                    phi_1090_ = 0i;
                }
                let _e766 = phi_1090_;
                if (_e763 < _e760) {
                    phi_1095_ = _e763;
                } else {
                    phi_1095_ = _e760;
                }
                let _e769 = phi_1095_;
                if (_e766 < _e760) {
                    phi_1100_ = _e766;
                } else {
                    phi_1100_ = _e760;
                }
                let _e772 = phi_1100_;
                let _e773 = bitcast<u32>(_e769);
                let _e775 = (_e731 + 1i);
                let _e776 = (_e740 + 1i);
                if (_e775 > 0i) {
                    phi_1109_ = _e775;
                } else {
                    phi_1109_ = 0i;
                }
                let _e779 = phi_1109_;
                if (_e776 > 0i) {
                    phi_1114_ = _e776;
                } else {
                    phi_1114_ = 0i;
                }
                let _e782 = phi_1114_;
                if (_e779 < _e760) {
                    phi_1119_ = _e779;
                } else {
                    phi_1119_ = _e760;
                }
                let _e785 = phi_1119_;
                if (_e782 < _e760) {
                    phi_1124_ = _e782;
                } else {
                    phi_1124_ = _e760;
                }
                let _e788 = phi_1124_;
                let _e789 = bitcast<u32>(_e785);
                let _e791 = (bitcast<u32>(_e772) * _e753);
                let _e792 = (bitcast<u32>(_e788) * _e753);
                let _e797 = ((_e791 + _e773) + _e758);
                let _e798 = ((_e791 + _e789) + _e758);
                let _e799 = ((_e792 + _e773) + _e758);
                let _e800 = ((_e792 + _e789) + _e758);
                if (_e797 < _e51) {
                } else {
                    return;
                }
                let _e804 = map.member[(0u + _e797)];
                if (_e798 < _e51) {
                } else {
                    return;
                }
                let _e816 = map.member[(0u + _e798)];
                if (_e799 < _e51) {
                } else {
                    return;
                }
                let _e832 = map.member[(0u + _e799)];
                if (_e800 < _e51) {
                } else {
                    return;
                }
                let _e848 = map.member[(0u + _e800)];
                let _e862 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e804.x * _e743) + (_e816.x * _e745)) + (_e832.x * _e747)) + (_e848.x * _e748)), ((((_e804.y * _e743) + (_e816.y * _e745)) + (_e832.y * _e747)) + (_e848.y * _e748)), ((((_e804.z * _e743) + (_e816.z * _e745)) + (_e832.z * _e747)) + (_e848.z * _e748)), ((((_e804.w * _e743) + (_e816.w * _e745)) + (_e832.w * _e747)) + (_e848.w * _e748))), _e657);
                let _e866 = p.member.epsilon;
                if (_e862 <= _e866) {
                    phi_1221_ = true;
                } else {
                    phi_1221_ = (_e862 >= (1f - _e866));
                }
                let _e871 = phi_1221_;
                if ((bitcast<u32>(_e862) & 2147483647u) > 2139095040u) {
                    phi_1229_ = true;
                } else {
                    phi_1229_ = !(_e871);
                }
                let _e877 = phi_1229_;
                if _e877 {
                    if (_e862 > 0f) {
                        if (_e862 < 1f) {
                            phi_1241_ = false;
                        } else {
                            phi_1241_ = true;
                        }
                        let _e881 = phi_1241_;
                        phi_1242_ = _e881;
                    } else {
                        phi_1242_ = true;
                    }
                    let _e883 = phi_1242_;
                    if _e883 {
                        phi_1246_ = 0.5f;
                    } else {
                        phi_1246_ = _e862;
                    }
                    let _e885 = phi_1246_;
                    phi_1254_ = evaluate_Verdict(_e885, true);
                } else {
                    if (_e862 > 0.5f) {
                        phi_1252_ = 1f;
                    } else {
                        phi_1252_ = 0f;
                    }
                    let _e889 = phi_1252_;
                    phi_1254_ = evaluate_Verdict(_e889, false);
                }
                let _e892 = phi_1254_;
                let _e895 = (_e892.visibility < 0.5f);
                if _e892.is_doubted {
                    phi_1277_ = evaluate_Verdict();
                    phi_1278_ = true;
                } else {
                    if _e895 {
                        phi_1264_ = 2u;
                    } else {
                        phi_1264_ = 1u;
                    }
                    let _e897 = phi_1264_;
                    if ((0u & _e897) != 0u) {
                        if _e895 {
                            phi_1273_ = 0.000000059604645f;
                        } else {
                            phi_1273_ = 0.99999994f;
                        }
                        let _e901 = phi_1273_;
                        phi_1275_ = evaluate_Verdict(_e901, true);
                        phi_1276_ = false;
                    } else {
                        phi_1275_ = evaluate_Verdict();
                        phi_1276_ = true;
                    }
                    let _e904 = phi_1275_;
                    let _e906 = phi_1276_;
                    phi_1277_ = _e904;
                    phi_1278_ = _e906;
                }
                let _e908 = phi_1277_;
                let _e910 = phi_1278_;
                if _e910 {
                    phi_1283_ = evaluate_Verdict(_e892.visibility, _e892.is_doubted);
                } else {
                    phi_1283_ = _e908;
                }
                let _e913 = phi_1283_;
                phi_1288_ = evaluate_Verdict(_e913.visibility, _e913.is_doubted);
            } else {
                phi_1288_ = evaluate_Verdict(0.5f, true);
            }
            let _e919 = phi_1288_;
            phi_1289_ = _e919;
        }
        let _e921 = phi_1289_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e921.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
