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
    var phi_152_: lt_bvh_traverse_Tree;
    var phi_153_: bool;
    var phi_154_: lt_bvh_traverse_Tree;
    var phi_155_: bool;
    var phi_160_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_152_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_153_ = false;
        } else {
            phi_152_ = lt_bvh_traverse_Tree();
            phi_153_ = true;
        }
        let _e56 = phi_152_;
        let _e58 = phi_153_;
        phi_154_ = _e56;
        phi_155_ = _e58;
    } else {
        phi_154_ = lt_bvh_traverse_Tree();
        phi_155_ = true;
    }
    let _e60 = phi_154_;
    let _e62 = phi_155_;
    if _e62 {
        phi_160_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_160_ = _e60;
    }
    let _e67 = phi_160_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_185_: f32;
    var phi_186_: f32;
    var phi_187_: f32;
    var phi_205_: bool;
    var phi_209_: f32;
    var phi_221_: bool;
    var phi_228_: f32;
    var phi_243_: f32;
    var phi_244_: f32;
    var phi_245_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_187_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_186_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_185_ = 1f;
            } else {
                phi_185_ = param_6;
            }
            let _e52 = phi_185_;
            phi_186_ = _e52;
        }
        let _e54 = phi_186_;
        phi_187_ = _e54;
    }
    let _e56 = phi_187_;
    let _e59 = (*param_4);
    let _e63 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e59) & 2147483647u) > 2139095040u) {
        phi_205_ = true;
    } else {
        let _e67 = (_e59 > _e63);
        if _e67 {
        }
        phi_205_ = _e67;
    }
    let _e69 = phi_205_;
    if _e69 {
        phi_209_ = _e59;
    } else {
        phi_209_ = _e63;
    }
    let _e71 = phi_209_;
    let _e72 = (_e56 - param_5.x);
    if (_e72 <= 0f) {
        let _e76 = ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u);
        if _e76 {
        }
        phi_221_ = _e76;
    } else {
        phi_221_ = true;
    }
    let _e78 = phi_221_;
    if _e78 {
        phi_228_ = (_e71 / (_e71 + (_e72 * _e72)));
    } else {
        phi_228_ = 1f;
    }
    let _e83 = phi_228_;
    if ((bitcast<u32>(_e83) & 2147483647u) > 2139095040u) {
        phi_245_ = _e83;
    } else {
        if (_e83 < 0f) {
            phi_244_ = 0f;
        } else {
            if (_e83 > 1f) {
                phi_243_ = 1f;
            } else {
                phi_243_ = _e83;
            }
            let _e90 = phi_243_;
            phi_244_ = _e90;
        }
        let _e92 = phi_244_;
        phi_245_ = _e92;
    }
    let _e94 = phi_245_;
    return _e94;
}

fn function_() {
    var local: f32;
    var phi_305_: bool;
    var phi_306_: bool;
    var phi_307_: bool;
    var phi_308_: bool;
    var phi_312_: bool;
    var phi_382_: bool;
    var phi_383_: bool;
    var phi_394_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_395_: bool;
    var phi_396_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_397_: bool;
    var phi_404_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_408_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_428_: lt_math_LightPoint;
    var phi_431_: u32;
    var phi_433_: lt_math_LevelPoint;
    var phi_519_: bool;
    var phi_528_: bool;
    var phi_537_: bool;
    var phi_538_: bool;
    var phi_539_: bool;
    var phi_540_: bool;
    var phi_541_: bool;
    var phi_542_: bool;
    var phi_543_: bool;
    var phi_547_: bool;
    var phi_574_: bool;
    var phi_575_: bool;
    var phi_576_: bool;
    var phi_577_: bool;
    var phi_578_: bool;
    var phi_579_: bool;
    var phi_580_: bool;
    var phi_581_: bool;
    var phi_585_: bool;
    var phi_594_: lt_math_LightPoint;
    var phi_595_: u32;
    var phi_596_: lt_math_LevelPoint;
    var phi_597_: bool;
    var phi_429_: lt_math_LightPoint;
    var phi_432_: u32;
    var phi_434_: lt_math_LevelPoint;
    var phi_598_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_638_: bool;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_645_: bool;
    var phi_727_: f32;
    var phi_845_: f32;
    var phi_846_: f32;
    var phi_849_: f32;
    var phi_878_: f32;
    var phi_883_: f32;
    var phi_884_: bool;
    var phi_885_: f32;
    var phi_886_: bool;
    var phi_890_: f32;
    var phi_910_: f32;
    var phi_915_: f32;
    var phi_916_: bool;
    var phi_917_: f32;
    var phi_918_: bool;
    var phi_922_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_971_: i32;
    var phi_976_: i32;
    var phi_981_: i32;
    var phi_986_: i32;
    var phi_995_: i32;
    var phi_1000_: i32;
    var phi_1005_: i32;
    var phi_1010_: i32;
    var phi_1107_: bool;
    var phi_1115_: bool;
    var phi_1127_: bool;
    var phi_1128_: bool;
    var phi_1132_: f32;
    var phi_1138_: f32;
    var phi_1140_: evaluate_Verdict;
    var phi_1150_: u32;
    var phi_1159_: f32;
    var phi_1161_: evaluate_Verdict;
    var phi_1162_: bool;
    var phi_1163_: evaluate_Verdict;
    var phi_1164_: bool;
    var phi_1169_: evaluate_Verdict;
    var phi_1174_: evaluate_Verdict;
    var phi_1175_: evaluate_Verdict;

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
                phi_305_ = (_e86 == _e88);
                phi_306_ = false;
            } else {
                phi_305_ = bool();
                phi_306_ = true;
            }
            let _e91 = phi_305_;
            let _e93 = phi_306_;
            phi_307_ = _e91;
            phi_308_ = _e93;
        } else {
            phi_307_ = bool();
            phi_308_ = true;
        }
        let _e95 = phi_307_;
        let _e97 = phi_308_;
        if _e97 {
            phi_312_ = false;
        } else {
            phi_312_ = _e95;
        }
        let _e99 = phi_312_;
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
                    phi_383_ = true;
                } else {
                    let _e152 = p.member.light.range_squared;
                    if (_e135 <= _e152) {
                        let _e155 = p.member.light.cos_outer;
                        phi_382_ = (-((((_e117 * _e137.x) + (_e118 * _e137.y)) + (_e119 * _e137.z))) >= (_e155 * sqrt(_e135)));
                    } else {
                        phi_382_ = false;
                    }
                    let _e160 = phi_382_;
                    phi_383_ = _e160;
                }
                let _e162 = phi_383_;
                if _e162 {
                    let _e164 = samples.member[(0u + _e63.first_primitive)].flags;
                    let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e172.unnamed.visibility, false), _e172.unnamed_1);
                    phi_394_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e178.unnamed, ((_e164 & 1u) == 0u));
                    phi_395_ = false;
                } else {
                    phi_394_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_395_ = true;
                }
                let _e183 = phi_394_;
                let _e185 = phi_395_;
                phi_396_ = _e183;
                phi_397_ = _e185;
            } else {
                phi_396_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_397_ = true;
            }
            let _e187 = phi_396_;
            let _e189 = phi_397_;
            if _e189 {
                let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e195.unnamed.visibility, false), _e195.unnamed_1);
                phi_404_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e201.unnamed, true);
            } else {
                phi_404_ = _e187;
            }
            let _e206 = phi_404_;
            phi_408_ = _e206;
        } else {
            let _e212 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e212.unnamed.visibility, false), _e212.unnamed_1);
            phi_408_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e218.unnamed, true);
        }
        let _e223 = phi_408_;
        if _e223.unnamed_1 {
            phi_1175_ = evaluate_Verdict(_e223.unnamed.visibility, _e223.unnamed.is_doubted);
        } else {
            let _e231 = samples.member[(0u + _e63.first_primitive)].position;
            let _e233 = p.member.map_size;
            let _e235 = (0.5f / f32(_e233));
            let _e242 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e249 = lt_math_LightPoint(vec2<f32>(_e242.uv.x, 0f), _e242.depth, _e242.is_inside);
            let _e253 = lt_math_LightPoint(_e249.uv, 0f, _e249.is_inside);
            phi_428_ = lt_math_LightPoint();
            phi_431_ = 0u;
            phi_433_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e253.uv, _e253.depth, false));
            loop {
                let _e260 = phi_428_;
                let _e262 = phi_431_;
                let _e264 = phi_433_;
                local_1 = _e264;
                local_2 = _e264;
                local_3 = _e264;
                if (_e262 < _e69) {
                    if _e264.point.is_inside {
                        phi_594_ = lt_math_LightPoint();
                        phi_595_ = u32();
                        phi_596_ = lt_math_LevelPoint();
                        phi_597_ = false;
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
                                phi_519_ = (_e300 <= 1f);
                            } else {
                                phi_519_ = false;
                            }
                            let _e332 = phi_519_;
                            if _e332 {
                                if (_e314 >= 0f) {
                                    phi_528_ = (_e314 <= 1f);
                                } else {
                                    phi_528_ = false;
                                }
                                let _e336 = phi_528_;
                                if _e336 {
                                    if (_e327 >= 0f) {
                                        phi_537_ = (_e327 <= 1f);
                                    } else {
                                        phi_537_ = false;
                                    }
                                    let _e340 = phi_537_;
                                    phi_538_ = _e340;
                                    phi_539_ = false;
                                } else {
                                    phi_538_ = bool();
                                    phi_539_ = true;
                                }
                                let _e342 = phi_538_;
                                let _e344 = phi_539_;
                                phi_540_ = _e342;
                                phi_541_ = _e344;
                            } else {
                                phi_540_ = bool();
                                phi_541_ = true;
                            }
                            let _e346 = phi_540_;
                            let _e348 = phi_541_;
                            phi_542_ = _e346;
                            phi_543_ = _e348;
                        } else {
                            phi_542_ = bool();
                            phi_543_ = true;
                        }
                        let _e350 = phi_542_;
                        let _e352 = phi_543_;
                        if _e352 {
                            phi_547_ = false;
                        } else {
                            phi_547_ = _e350;
                        }
                        let _e354 = phi_547_;
                        if _e354 {
                            if (_e300 >= _e235) {
                                if (_e300 <= (1f - _e235)) {
                                    if (_e314 >= _e235) {
                                        phi_574_ = (_e314 <= (1f - _e235));
                                        phi_575_ = false;
                                    } else {
                                        phi_574_ = bool();
                                        phi_575_ = true;
                                    }
                                    let _e362 = phi_574_;
                                    let _e364 = phi_575_;
                                    phi_576_ = _e362;
                                    phi_577_ = _e364;
                                } else {
                                    phi_576_ = bool();
                                    phi_577_ = true;
                                }
                                let _e366 = phi_576_;
                                let _e368 = phi_577_;
                                phi_578_ = _e366;
                                phi_579_ = _e368;
                            } else {
                                phi_578_ = bool();
                                phi_579_ = true;
                            }
                            let _e370 = phi_578_;
                            let _e372 = phi_579_;
                            phi_580_ = _e370;
                            phi_581_ = _e372;
                        } else {
                            phi_580_ = bool();
                            phi_581_ = true;
                        }
                        let _e374 = phi_580_;
                        let _e376 = phi_581_;
                        if _e376 {
                            phi_585_ = false;
                        } else {
                            phi_585_ = _e374;
                        }
                        let _e378 = phi_585_;
                        let _e385 = lt_math_LightPoint(vec2<f32>(_e300, _e260.uv.y), _e260.depth, _e260.is_inside);
                        let _e392 = lt_math_LightPoint(vec2<f32>(_e385.uv.x, _e314), _e385.depth, _e385.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e327, _e392.is_inside);
                        let _e400 = lt_math_LightPoint(_e396.uv, _e396.depth, _e378);
                        phi_594_ = _e400;
                        phi_595_ = (_e262 + 1u);
                        phi_596_ = lt_math_LevelPoint(_e262, _e400);
                        phi_597_ = true;
                    }
                    let _e404 = phi_594_;
                    let _e406 = phi_595_;
                    let _e408 = phi_596_;
                    let _e410 = phi_597_;
                    phi_429_ = _e404;
                    phi_432_ = _e406;
                    phi_434_ = _e408;
                    phi_598_ = _e410;
                } else {
                    phi_429_ = lt_math_LightPoint();
                    phi_432_ = u32();
                    phi_434_ = lt_math_LevelPoint();
                    phi_598_ = false;
                }
                let _e412 = phi_429_;
                let _e414 = phi_432_;
                let _e416 = phi_434_;
                let _e418 = phi_598_;
                continue;
                continuing {
                    phi_428_ = _e412;
                    phi_431_ = _e414;
                    phi_433_ = _e416;
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
                            phi_638_ = (_e432.row_w.z == _e444);
                            phi_639_ = false;
                        } else {
                            phi_638_ = bool();
                            phi_639_ = true;
                        }
                        let _e447 = phi_638_;
                        let _e449 = phi_639_;
                        phi_640_ = _e447;
                        phi_641_ = _e449;
                    } else {
                        phi_640_ = bool();
                        phi_641_ = true;
                    }
                    let _e451 = phi_640_;
                    let _e453 = phi_641_;
                    if _e453 {
                        phi_645_ = false;
                    } else {
                        phi_645_ = _e451;
                    }
                    let _e455 = phi_645_;
                    if _e455 {
                        let _e457 = samples.member[(0u + _e63.first_primitive)].normal;
                        let _e459 = p.member.map_size;
                        let _e529 = ((abs(((((_e432.row_x.x * _e457.x) + (_e432.row_x.y * _e457.y)) + (_e432.row_x.z * _e457.z)) / (((_e432.row_x.x * _e432.row_x.x) + (_e432.row_x.y * _e432.row_x.y)) + (_e432.row_x.z * _e432.row_x.z)))) + abs(((((_e432.row_y.x * _e457.x) + (_e432.row_y.y * _e457.y)) + (_e432.row_y.z * _e457.z)) / (((_e432.row_y.x * _e432.row_y.x) + (_e432.row_y.y * _e432.row_y.y)) + (_e432.row_y.z * _e432.row_y.z))))) / (abs(((((_e432.row_z.x * _e457.x) + (_e432.row_z.y * _e457.y)) + (_e432.row_z.z * _e457.z)) / (((_e432.row_z.x * _e432.row_z.x) + (_e432.row_z.y * _e432.row_z.y)) + (_e432.row_z.z * _e432.row_z.z)))) * f32(_e459)));
                        if (_e529 < 0.002f) {
                            phi_727_ = _e529;
                        } else {
                            phi_727_ = 0.002f;
                        }
                        let _e532 = phi_727_;
                        phi_846_ = _e532;
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
                            phi_845_ = _e646;
                        } else {
                            phi_845_ = _e648;
                        }
                        let _e651 = phi_845_;
                        phi_846_ = _e651;
                    }
                    let _e653 = phi_846_;
                    phi_849_ = (_e421.point.depth - (0f * _e653));
                } else {
                    phi_849_ = _e421.point.depth;
                }
                let _e657 = phi_849_;
                let _e663 = p.member.map_size;
                let _e664 = f32(_e663);
                let _e667 = ((_e421.point.uv.x * _e664) - 0.5f);
                let _e668 = ((_e421.point.uv.y * _e664) - 0.5f);
                if (_e667 > -8388608f) {
                    let _e680 = f32(select(0i, select(select(i32(_e667), i32(-2147483648), (_e667 < bitcast<f32>(3472883712u))), 2147483647i, (_e667 > bitcast<f32>(1325400063u))), (_e667 == _e667)));
                    if (_e680 > _e667) {
                        phi_878_ = 1f;
                    } else {
                        phi_878_ = 0f;
                    }
                    let _e683 = phi_878_;
                    if (_e667 < 8388608f) {
                        phi_883_ = (_e680 - _e683);
                        phi_884_ = false;
                    } else {
                        phi_883_ = f32();
                        phi_884_ = true;
                    }
                    let _e686 = phi_883_;
                    let _e688 = phi_884_;
                    phi_885_ = _e686;
                    phi_886_ = _e688;
                } else {
                    phi_885_ = f32();
                    phi_886_ = true;
                }
                let _e690 = phi_885_;
                let _e692 = phi_886_;
                if _e692 {
                    phi_890_ = _e667;
                } else {
                    phi_890_ = _e690;
                }
                let _e694 = phi_890_;
                if (_e668 > -8388608f) {
                    let _e706 = f32(select(0i, select(select(i32(_e668), i32(-2147483648), (_e668 < bitcast<f32>(3472883712u))), 2147483647i, (_e668 > bitcast<f32>(1325400063u))), (_e668 == _e668)));
                    if (_e706 > _e668) {
                        phi_910_ = 1f;
                    } else {
                        phi_910_ = 0f;
                    }
                    let _e709 = phi_910_;
                    if (_e668 < 8388608f) {
                        phi_915_ = (_e706 - _e709);
                        phi_916_ = false;
                    } else {
                        phi_915_ = f32();
                        phi_916_ = true;
                    }
                    let _e712 = phi_915_;
                    let _e714 = phi_916_;
                    phi_917_ = _e712;
                    phi_918_ = _e714;
                } else {
                    phi_917_ = f32();
                    phi_918_ = true;
                }
                let _e716 = phi_917_;
                let _e718 = phi_918_;
                if _e718 {
                    phi_922_ = _e668;
                } else {
                    phi_922_ = _e716;
                }
                let _e720 = phi_922_;
                let _e721 = (_e667 - _e694);
                let _e722 = (_e668 - _e720);
                let _e731 = select(0i, select(select(i32(_e694), i32(-2147483648), (_e694 < bitcast<f32>(3472883712u))), 2147483647i, (_e694 > bitcast<f32>(1325400063u))), (_e694 == _e694));
                let _e740 = select(0i, select(select(i32(_e720), i32(-2147483648), (_e720 < bitcast<f32>(3472883712u))), 2147483647i, (_e720 > bitcast<f32>(1325400063u))), (_e720 == _e720));
                let _e743 = ((1f - _e721) * (1f - _e722));
                let _e745 = (_e721 * (1f - _e722));
                let _e747 = ((1f - _e721) * _e722);
                let _e748 = (_e721 * _e722);
                let _e750 = p.member.test;
                let _e751 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e750);
                let _e753 = p.member.map_size;
                let _e755 = local_3;
                local = _e751;
                let _e758 = ((_e755.level * _e753) * _e753);
                let _e760 = (bitcast<i32>(_e753) - 1i);
                if (_e731 > 0i) {
                    phi_971_ = _e731;
                } else {
                    phi_971_ = 0i;
                }
                let _e763 = phi_971_;
                if (_e740 > 0i) {
                    phi_976_ = _e740;
                } else {
                    phi_976_ = 0i;
                }
                let _e766 = phi_976_;
                if (_e763 < _e760) {
                    phi_981_ = _e763;
                } else {
                    phi_981_ = _e760;
                }
                let _e769 = phi_981_;
                if (_e766 < _e760) {
                    phi_986_ = _e766;
                } else {
                    phi_986_ = _e760;
                }
                let _e772 = phi_986_;
                let _e773 = bitcast<u32>(_e769);
                let _e775 = (_e731 + 1i);
                let _e776 = (_e740 + 1i);
                if (_e775 > 0i) {
                    phi_995_ = _e775;
                } else {
                    phi_995_ = 0i;
                }
                let _e779 = phi_995_;
                if (_e776 > 0i) {
                    phi_1000_ = _e776;
                } else {
                    phi_1000_ = 0i;
                }
                let _e782 = phi_1000_;
                if (_e779 < _e760) {
                    phi_1005_ = _e779;
                } else {
                    phi_1005_ = _e760;
                }
                let _e785 = phi_1005_;
                if (_e782 < _e760) {
                    phi_1010_ = _e782;
                } else {
                    phi_1010_ = _e760;
                }
                let _e788 = phi_1010_;
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
                let _e862 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e804.x * _e743) + (_e816.x * _e745)) + (_e832.x * _e747)) + (_e848.x * _e748)), ((((_e804.y * _e743) + (_e816.y * _e745)) + (_e832.y * _e747)) + (_e848.y * _e748)), ((((_e804.z * _e743) + (_e816.z * _e745)) + (_e832.z * _e747)) + (_e848.z * _e748)), ((((_e804.w * _e743) + (_e816.w * _e745)) + (_e832.w * _e747)) + (_e848.w * _e748))), _e657);
                let _e866 = p.member.epsilon;
                if (_e862 <= _e866) {
                    phi_1107_ = true;
                } else {
                    phi_1107_ = (_e862 >= (1f - _e866));
                }
                let _e871 = phi_1107_;
                if ((bitcast<u32>(_e862) & 2147483647u) > 2139095040u) {
                    phi_1115_ = true;
                } else {
                    phi_1115_ = !(_e871);
                }
                let _e877 = phi_1115_;
                if _e877 {
                    if (_e862 > 0f) {
                        if (_e862 < 1f) {
                            phi_1127_ = false;
                        } else {
                            phi_1127_ = true;
                        }
                        let _e881 = phi_1127_;
                        phi_1128_ = _e881;
                    } else {
                        phi_1128_ = true;
                    }
                    let _e883 = phi_1128_;
                    if _e883 {
                        phi_1132_ = 0.5f;
                    } else {
                        phi_1132_ = _e862;
                    }
                    let _e885 = phi_1132_;
                    phi_1140_ = evaluate_Verdict(_e885, true);
                } else {
                    if (_e862 > 0.5f) {
                        phi_1138_ = 1f;
                    } else {
                        phi_1138_ = 0f;
                    }
                    let _e889 = phi_1138_;
                    phi_1140_ = evaluate_Verdict(_e889, false);
                }
                let _e892 = phi_1140_;
                let _e895 = (_e892.visibility < 0.5f);
                if _e892.is_doubted {
                    phi_1163_ = evaluate_Verdict();
                    phi_1164_ = true;
                } else {
                    if _e895 {
                        phi_1150_ = 2u;
                    } else {
                        phi_1150_ = 1u;
                    }
                    let _e897 = phi_1150_;
                    if ((0u & _e897) != 0u) {
                        if _e895 {
                            phi_1159_ = 0.000000059604645f;
                        } else {
                            phi_1159_ = 0.99999994f;
                        }
                        let _e901 = phi_1159_;
                        phi_1161_ = evaluate_Verdict(_e901, true);
                        phi_1162_ = false;
                    } else {
                        phi_1161_ = evaluate_Verdict();
                        phi_1162_ = true;
                    }
                    let _e904 = phi_1161_;
                    let _e906 = phi_1162_;
                    phi_1163_ = _e904;
                    phi_1164_ = _e906;
                }
                let _e908 = phi_1163_;
                let _e910 = phi_1164_;
                if _e910 {
                    phi_1169_ = evaluate_Verdict(_e892.visibility, _e892.is_doubted);
                } else {
                    phi_1169_ = _e908;
                }
                let _e913 = phi_1169_;
                phi_1174_ = evaluate_Verdict(_e913.visibility, _e913.is_doubted);
            } else {
                phi_1174_ = evaluate_Verdict(0.5f, true);
            }
            let _e919 = phi_1174_;
            phi_1175_ = _e919;
        }
        let _e921 = phi_1175_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e921.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_vsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
