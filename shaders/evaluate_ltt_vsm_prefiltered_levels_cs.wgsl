struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_10 {
    member: array<abi_Sample>,
}

struct type_14 {
    member: array<u32>,
}

struct type_18 {
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

struct type_37 {
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

struct type_41 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_47 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct type_53 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_5: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_41;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_53;
@group(0) @binding(5) 
var<storage> levels: type_47;
@group(0) @binding(2) 
var<storage> map: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_161_: lt_bvh_traverse_Tree;
    var phi_162_: bool;
    var phi_167_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_159_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_160_ = false;
        } else {
            phi_159_ = lt_bvh_traverse_Tree();
            phi_160_ = true;
        }
        let _e56 = phi_159_;
        let _e58 = phi_160_;
        phi_161_ = _e56;
        phi_162_ = _e58;
    } else {
        phi_161_ = lt_bvh_traverse_Tree();
        phi_162_ = true;
    }
    let _e60 = phi_161_;
    let _e62 = phi_162_;
    if _e62 {
        phi_167_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_167_ = _e60;
    }
    let _e67 = phi_167_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_192_: f32;
    var phi_193_: f32;
    var phi_194_: f32;
    var phi_212_: bool;
    var phi_216_: f32;
    var phi_228_: bool;
    var phi_235_: f32;
    var phi_250_: f32;
    var phi_251_: f32;
    var phi_252_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_194_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_193_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_192_ = 1f;
            } else {
                phi_192_ = param_6;
            }
            let _e52 = phi_192_;
            phi_193_ = _e52;
        }
        let _e54 = phi_193_;
        phi_194_ = _e54;
    }
    let _e56 = phi_194_;
    let _e59 = (*param_4);
    let _e63 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e59) & 2147483647u) > 2139095040u) {
        phi_212_ = true;
    } else {
        let _e67 = (_e59 > _e63);
        if _e67 {
        }
        phi_212_ = _e67;
    }
    let _e69 = phi_212_;
    if _e69 {
        phi_216_ = _e59;
    } else {
        phi_216_ = _e63;
    }
    let _e71 = phi_216_;
    let _e72 = (_e56 - param_5.x);
    if (_e72 <= 0f) {
        let _e76 = ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u);
        if _e76 {
        }
        phi_228_ = _e76;
    } else {
        phi_228_ = true;
    }
    let _e78 = phi_228_;
    if _e78 {
        phi_235_ = (_e71 / (_e71 + (_e72 * _e72)));
    } else {
        phi_235_ = 1f;
    }
    let _e83 = phi_235_;
    if ((bitcast<u32>(_e83) & 2147483647u) > 2139095040u) {
        phi_252_ = _e83;
    } else {
        if (_e83 < 0f) {
            phi_251_ = 0f;
        } else {
            if (_e83 > 1f) {
                phi_250_ = 1f;
            } else {
                phi_250_ = _e83;
            }
            let _e90 = phi_250_;
            phi_251_ = _e90;
        }
        let _e92 = phi_251_;
        phi_252_ = _e92;
    }
    let _e94 = phi_252_;
    return _e94;
}

fn function_() {
    var local_1: f32;
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_315_: bool;
    var phi_359_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_363_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_383_: lt_math_LightPoint;
    var phi_386_: u32;
    var phi_388_: lt_math_LevelPoint;
    var phi_474_: bool;
    var phi_483_: bool;
    var phi_492_: bool;
    var phi_493_: bool;
    var phi_494_: bool;
    var phi_495_: bool;
    var phi_496_: bool;
    var phi_497_: bool;
    var phi_498_: bool;
    var phi_502_: bool;
    var phi_529_: bool;
    var phi_530_: bool;
    var phi_531_: bool;
    var phi_532_: bool;
    var phi_533_: bool;
    var phi_534_: bool;
    var phi_535_: bool;
    var phi_536_: bool;
    var phi_540_: bool;
    var phi_549_: lt_math_LightPoint;
    var phi_550_: u32;
    var phi_551_: lt_math_LevelPoint;
    var phi_552_: bool;
    var phi_384_: lt_math_LightPoint;
    var phi_387_: u32;
    var phi_389_: lt_math_LevelPoint;
    var phi_553_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_593_: bool;
    var phi_594_: bool;
    var phi_595_: bool;
    var phi_596_: bool;
    var phi_600_: bool;
    var phi_682_: f32;
    var phi_798_: f32;
    var phi_799_: f32;
    var phi_802_: f32;
    var phi_831_: f32;
    var phi_836_: f32;
    var phi_837_: bool;
    var phi_838_: f32;
    var phi_839_: bool;
    var phi_843_: f32;
    var phi_863_: f32;
    var phi_868_: f32;
    var phi_869_: bool;
    var phi_870_: f32;
    var phi_871_: bool;
    var phi_875_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_924_: i32;
    var phi_929_: i32;
    var phi_934_: i32;
    var phi_939_: i32;
    var phi_948_: i32;
    var phi_953_: i32;
    var phi_958_: i32;
    var phi_963_: i32;
    var phi_1058_: bool;
    var phi_1066_: bool;
    var phi_1078_: bool;
    var phi_1079_: bool;
    var phi_1083_: f32;
    var phi_1089_: f32;
    var phi_1091_: evaluate_Verdict;
    var phi_1096_: evaluate_Verdict;
    var phi_1097_: evaluate_Verdict;
    var phi_1101_: bool;
    var phi_1102_: u32;
    var phi_1113_: u32;

    let _e44 = id_1;
    let _e45 = local_5;
    let _e50 = arrayLength((&map.member));
    let _e55 = arrayLength((&levels.member));
    let _e58 = p.member.size[0u];
    let _e60 = p.member.size[1u];
    let _e61 = lt_shaders_entry_pixel_index(_e44, _e58, _e60);
    if (bitcast<i32>(_e61.root) != 0i) {
        let _e68 = p.member.level_count;
        let _e70 = p.member.light;
        let _e73 = samples.member[_e61.first_primitive].normal[0u];
        let _e75 = global[0u];
        if (_e73 == _e75) {
            let _e78 = samples.member[_e61.first_primitive].normal[1u];
            let _e80 = global[1u];
            if (_e78 == _e80) {
                let _e83 = samples.member[_e61.first_primitive].normal[2u];
                let _e85 = global[2u];
                phi_308_ = (_e83 == _e85);
                phi_309_ = false;
            } else {
                phi_308_ = bool();
                phi_309_ = true;
            }
            let _e88 = phi_308_;
            let _e90 = phi_309_;
            phi_310_ = _e88;
            phi_311_ = _e90;
        } else {
            phi_310_ = bool();
            phi_311_ = true;
        }
        let _e92 = phi_310_;
        let _e94 = phi_311_;
        if _e94 {
            phi_315_ = false;
        } else {
            phi_315_ = _e92;
        }
        let _e96 = phi_315_;
        if !(_e96) {
            let _e99 = samples.member[_e61.first_primitive].normal;
            let _e101 = samples.member[_e61.first_primitive].position;
            if ((((_e99.x * (_e70.x - (_e101.x * _e70.w))) + (_e99.y * (_e70.y - (_e101.y * _e70.w)))) + (_e99.z * (_e70.z - (_e101.z * _e70.w)))) > 0f) {
                let _e125 = samples.member[_e61.first_primitive].flags;
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e133.unnamed.visibility, false), _e133.unnamed_1);
                phi_359_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e139.unnamed, ((_e125 & 1u) == 0u));
            } else {
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e148.unnamed.visibility, false), _e148.unnamed_1);
                phi_359_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e154.unnamed, true);
            }
            let _e159 = phi_359_;
            phi_363_ = _e159;
        } else {
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e165.unnamed.visibility, false), _e165.unnamed_1);
            phi_363_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e171.unnamed, true);
        }
        let _e176 = phi_363_;
        if _e176.unnamed_1 {
            phi_1097_ = evaluate_Verdict(_e176.unnamed.visibility, _e176.unnamed.is_doubted);
        } else {
            let _e184 = samples.member[_e61.first_primitive].position;
            let _e186 = p.member.map_size;
            let _e188 = (0.5f / f32(_e186));
            let _e195 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e202 = lt_math_LightPoint(vec2<f32>(_e195.uv.x, 0f), _e195.depth, _e195.is_inside);
            let _e206 = lt_math_LightPoint(_e202.uv, 0f, _e202.is_inside);
            phi_383_ = lt_math_LightPoint();
            phi_386_ = 0u;
            phi_388_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e206.uv, _e206.depth, false));
            loop {
                let _e213 = phi_383_;
                let _e215 = phi_386_;
                let _e217 = phi_388_;
                local_2 = _e217;
                local_3 = _e217;
                local_4 = _e217;
                if (_e215 < _e68) {
                    if _e217.point.is_inside {
                        phi_549_ = lt_math_LightPoint();
                        phi_550_ = u32();
                        phi_551_ = lt_math_LevelPoint();
                        phi_552_ = false;
                    } else {
                        if (_e215 < _e55) {
                        } else {
                            return;
                        }
                        let _e228 = levels.member[(0u + _e215)].row_w;
                        let _e239 = ((((_e228.x * _e184.x) + (_e228.y * _e184.y)) + (_e228.z * _e184.z)) + (_e228.w * 1f));
                        let _e241 = levels.member[(0u + _e215)].row_x;
                        let _e253 = (((((_e241.x * _e184.x) + (_e241.y * _e184.y)) + (_e241.z * _e184.z)) + (_e241.w * 1f)) / _e239);
                        let _e255 = levels.member[(0u + _e215)].row_y;
                        let _e267 = (((((_e255.x * _e184.x) + (_e255.y * _e184.y)) + (_e255.z * _e184.z)) + (_e255.w * 1f)) / _e239);
                        let _e269 = levels.member[(0u + _e215)].row_z;
                        let _e280 = ((((_e269.x * _e184.x) + (_e269.y * _e184.y)) + (_e269.z * _e184.z)) + (_e269.w * 1f));
                        if (_e239 > 0f) {
                            if (_e253 >= 0f) {
                                phi_474_ = (_e253 <= 1f);
                            } else {
                                phi_474_ = false;
                            }
                            let _e285 = phi_474_;
                            if _e285 {
                                if (_e267 >= 0f) {
                                    phi_483_ = (_e267 <= 1f);
                                } else {
                                    phi_483_ = false;
                                }
                                let _e289 = phi_483_;
                                if _e289 {
                                    if (_e280 >= 0f) {
                                        phi_492_ = (_e280 <= 1f);
                                    } else {
                                        phi_492_ = false;
                                    }
                                    let _e293 = phi_492_;
                                    phi_493_ = _e293;
                                    phi_494_ = false;
                                } else {
                                    phi_493_ = bool();
                                    phi_494_ = true;
                                }
                                let _e295 = phi_493_;
                                let _e297 = phi_494_;
                                phi_495_ = _e295;
                                phi_496_ = _e297;
                            } else {
                                phi_495_ = bool();
                                phi_496_ = true;
                            }
                            let _e299 = phi_495_;
                            let _e301 = phi_496_;
                            phi_497_ = _e299;
                            phi_498_ = _e301;
                        } else {
                            phi_497_ = bool();
                            phi_498_ = true;
                        }
                        let _e303 = phi_497_;
                        let _e305 = phi_498_;
                        if _e305 {
                            phi_502_ = false;
                        } else {
                            phi_502_ = _e303;
                        }
                        let _e307 = phi_502_;
                        if _e307 {
                            if (_e253 >= _e188) {
                                if (_e253 <= (1f - _e188)) {
                                    if (_e267 >= _e188) {
                                        phi_529_ = (_e267 <= (1f - _e188));
                                        phi_530_ = false;
                                    } else {
                                        phi_529_ = bool();
                                        phi_530_ = true;
                                    }
                                    let _e315 = phi_529_;
                                    let _e317 = phi_530_;
                                    phi_531_ = _e315;
                                    phi_532_ = _e317;
                                } else {
                                    phi_531_ = bool();
                                    phi_532_ = true;
                                }
                                let _e319 = phi_531_;
                                let _e321 = phi_532_;
                                phi_533_ = _e319;
                                phi_534_ = _e321;
                            } else {
                                phi_533_ = bool();
                                phi_534_ = true;
                            }
                            let _e323 = phi_533_;
                            let _e325 = phi_534_;
                            phi_535_ = _e323;
                            phi_536_ = _e325;
                        } else {
                            phi_535_ = bool();
                            phi_536_ = true;
                        }
                        let _e327 = phi_535_;
                        let _e329 = phi_536_;
                        if _e329 {
                            phi_540_ = false;
                        } else {
                            phi_540_ = _e327;
                        }
                        let _e331 = phi_540_;
                        let _e338 = lt_math_LightPoint(vec2<f32>(_e253, _e213.uv.y), _e213.depth, _e213.is_inside);
                        let _e345 = lt_math_LightPoint(vec2<f32>(_e338.uv.x, _e267), _e338.depth, _e338.is_inside);
                        let _e349 = lt_math_LightPoint(_e345.uv, _e280, _e345.is_inside);
                        let _e353 = lt_math_LightPoint(_e349.uv, _e349.depth, _e331);
                        phi_549_ = _e353;
                        phi_550_ = (_e215 + 1u);
                        phi_551_ = lt_math_LevelPoint(_e215, _e353);
                        phi_552_ = true;
                    }
                    let _e357 = phi_549_;
                    let _e359 = phi_550_;
                    let _e361 = phi_551_;
                    let _e363 = phi_552_;
                    phi_384_ = _e357;
                    phi_387_ = _e359;
                    phi_389_ = _e361;
                    phi_553_ = _e363;
                } else {
                    phi_384_ = lt_math_LightPoint();
                    phi_387_ = u32();
                    phi_389_ = lt_math_LevelPoint();
                    phi_553_ = false;
                }
                let _e365 = phi_384_;
                let _e367 = phi_387_;
                let _e369 = phi_389_;
                let _e371 = phi_553_;
                continue;
                continuing {
                    phi_383_ = _e365;
                    phi_386_ = _e367;
                    phi_388_ = _e369;
                    break if !(_e371);
                }
            }
            let _e374 = local_2;
            if _e374.point.is_inside {
                if (0f > 0f) {
                    let _e380 = local_3;
                    if (_e380.level < _e55) {
                    } else {
                        return;
                    }
                    let _e385 = levels.member[(0u + _e380.level)];
                    let _e391 = global[0u];
                    if (_e385.row_w.x == _e391) {
                        let _e394 = global[1u];
                        if (_e385.row_w.y == _e394) {
                            let _e397 = global[2u];
                            phi_593_ = (_e385.row_w.z == _e397);
                            phi_594_ = false;
                        } else {
                            phi_593_ = bool();
                            phi_594_ = true;
                        }
                        let _e400 = phi_593_;
                        let _e402 = phi_594_;
                        phi_595_ = _e400;
                        phi_596_ = _e402;
                    } else {
                        phi_595_ = bool();
                        phi_596_ = true;
                    }
                    let _e404 = phi_595_;
                    let _e406 = phi_596_;
                    if _e406 {
                        phi_600_ = false;
                    } else {
                        phi_600_ = _e404;
                    }
                    let _e408 = phi_600_;
                    if _e408 {
                        let _e410 = samples.member[_e61.first_primitive].normal;
                        let _e412 = p.member.map_size;
                        let _e482 = ((abs(((((_e385.row_x.x * _e410.x) + (_e385.row_x.y * _e410.y)) + (_e385.row_x.z * _e410.z)) / (((_e385.row_x.x * _e385.row_x.x) + (_e385.row_x.y * _e385.row_x.y)) + (_e385.row_x.z * _e385.row_x.z)))) + abs(((((_e385.row_y.x * _e410.x) + (_e385.row_y.y * _e410.y)) + (_e385.row_y.z * _e410.z)) / (((_e385.row_y.x * _e385.row_y.x) + (_e385.row_y.y * _e385.row_y.y)) + (_e385.row_y.z * _e385.row_y.z))))) / (abs(((((_e385.row_z.x * _e410.x) + (_e385.row_z.y * _e410.y)) + (_e385.row_z.z * _e410.z)) / (((_e385.row_z.x * _e385.row_z.x) + (_e385.row_z.y * _e385.row_z.y)) + (_e385.row_z.z * _e385.row_z.z)))) * f32(_e412)));
                        if (_e482 < 0.002f) {
                            phi_682_ = _e482;
                        } else {
                            phi_682_ = 0.002f;
                        }
                        let _e485 = phi_682_;
                        phi_799_ = _e485;
                    } else {
                        let _e487 = p.member.map_size;
                        let _e493 = samples.member[_e61.first_primitive].position;
                        let _e504 = ((((_e385.row_w.x * _e493.x) + (_e385.row_w.y * _e493.y)) + (_e385.row_w.z * _e493.z)) + _e385.row_w.w);
                        let _e517 = ((_e385.row_x.x - (_e385.row_w.x * _e374.point.uv.x)) / _e504);
                        let _e518 = ((_e385.row_x.y - (_e385.row_w.y * _e374.point.uv.x)) / _e504);
                        let _e519 = ((_e385.row_x.z - (_e385.row_w.z * _e374.point.uv.x)) / _e504);
                        let _e532 = ((_e385.row_y.x - (_e385.row_w.x * _e374.point.uv.y)) / _e504);
                        let _e533 = ((_e385.row_y.y - (_e385.row_w.y * _e374.point.uv.y)) / _e504);
                        let _e534 = ((_e385.row_y.z - (_e385.row_w.z * _e374.point.uv.y)) / _e504);
                        let _e540 = samples.member[_e61.first_primitive].normal;
                        let _e545 = ((_e533 * _e540.z) - (_e540.y * _e534));
                        let _e550 = ((_e534 * _e540.x) - (_e540.z * _e532));
                        let _e555 = ((_e532 * _e540.y) - (_e540.x * _e533));
                        let _e557 = samples.member[_e61.first_primitive].normal;
                        let _e562 = ((_e518 * _e557.z) - (_e557.y * _e519));
                        let _e567 = ((_e519 * _e557.x) - (_e557.z * _e517));
                        let _e572 = ((_e517 * _e557.y) - (_e557.x * _e518));
                        let _e599 = ((abs(((((_e385.row_z.x * _e545) + (_e385.row_z.y * _e550)) + (_e385.row_z.z * _e555)) / (((_e517 * _e545) + (_e518 * _e550)) + (_e519 * _e555)))) + abs(((((_e385.row_z.x * _e562) + (_e385.row_z.y * _e567)) + (_e385.row_z.z * _e572)) / (((_e532 * _e562) + (_e533 * _e567)) + (_e534 * _e572))))) / f32(_e487));
                        if (_e599 < 0.002f) {
                            phi_798_ = _e599;
                        } else {
                            phi_798_ = 0.002f;
                        }
                        let _e602 = phi_798_;
                        phi_799_ = _e602;
                    }
                    let _e604 = phi_799_;
                    phi_802_ = (_e374.point.depth - (0f * _e604));
                } else {
                    phi_802_ = _e374.point.depth;
                }
                let _e608 = phi_802_;
                let _e614 = p.member.map_size;
                let _e615 = f32(_e614);
                let _e618 = ((_e374.point.uv.x * _e615) - 0.5f);
                let _e619 = ((_e374.point.uv.y * _e615) - 0.5f);
                if (_e618 > -8388608f) {
                    let _e631 = f32(select(0i, select(select(i32(_e618), i32(-2147483648), (_e618 < bitcast<f32>(3472883712u))), 2147483647i, (_e618 > bitcast<f32>(1325400063u))), (_e618 == _e618)));
                    if (_e631 > _e618) {
                        phi_831_ = 1f;
                    } else {
                        phi_831_ = 0f;
                    }
                    let _e634 = phi_831_;
                    if (_e618 < 8388608f) {
                        phi_836_ = (_e631 - _e634);
                        phi_837_ = false;
                    } else {
                        phi_836_ = f32();
                        phi_837_ = true;
                    }
                    let _e637 = phi_836_;
                    let _e639 = phi_837_;
                    phi_838_ = _e637;
                    phi_839_ = _e639;
                } else {
                    phi_838_ = f32();
                    phi_839_ = true;
                }
                let _e641 = phi_838_;
                let _e643 = phi_839_;
                if _e643 {
                    phi_843_ = _e618;
                } else {
                    phi_843_ = _e641;
                }
                let _e645 = phi_843_;
                if (_e619 > -8388608f) {
                    let _e657 = f32(select(0i, select(select(i32(_e619), i32(-2147483648), (_e619 < bitcast<f32>(3472883712u))), 2147483647i, (_e619 > bitcast<f32>(1325400063u))), (_e619 == _e619)));
                    if (_e657 > _e619) {
                        phi_863_ = 1f;
                    } else {
                        phi_863_ = 0f;
                    }
                    let _e660 = phi_863_;
                    if (_e619 < 8388608f) {
                        phi_868_ = (_e657 - _e660);
                        phi_869_ = false;
                    } else {
                        phi_868_ = f32();
                        phi_869_ = true;
                    }
                    let _e663 = phi_868_;
                    let _e665 = phi_869_;
                    phi_870_ = _e663;
                    phi_871_ = _e665;
                } else {
                    phi_870_ = f32();
                    phi_871_ = true;
                }
                let _e667 = phi_870_;
                let _e669 = phi_871_;
                if _e669 {
                    phi_875_ = _e619;
                } else {
                    phi_875_ = _e667;
                }
                let _e671 = phi_875_;
                let _e672 = (_e618 - _e645);
                let _e673 = (_e619 - _e671);
                let _e682 = select(0i, select(select(i32(_e645), i32(-2147483648), (_e645 < bitcast<f32>(3472883712u))), 2147483647i, (_e645 > bitcast<f32>(1325400063u))), (_e645 == _e645));
                let _e691 = select(0i, select(select(i32(_e671), i32(-2147483648), (_e671 < bitcast<f32>(3472883712u))), 2147483647i, (_e671 > bitcast<f32>(1325400063u))), (_e671 == _e671));
                let _e694 = ((1f - _e672) * (1f - _e673));
                let _e696 = (_e672 * (1f - _e673));
                let _e698 = ((1f - _e672) * _e673);
                let _e699 = (_e672 * _e673);
                let _e701 = p.member.test;
                let _e702 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e701);
                let _e704 = p.member.map_size;
                let _e706 = local_4;
                local_1 = _e702;
                let _e709 = ((_e706.level * _e704) * _e704);
                let _e711 = (bitcast<i32>(_e704) - 1i);
                if (_e682 > 0i) {
                    phi_924_ = _e682;
                } else {
                    phi_924_ = 0i;
                }
                let _e714 = phi_924_;
                if (_e691 > 0i) {
                    phi_929_ = _e691;
                } else {
                    phi_929_ = 0i;
                }
                let _e717 = phi_929_;
                if (_e714 < _e711) {
                    phi_934_ = _e714;
                } else {
                    phi_934_ = _e711;
                }
                let _e720 = phi_934_;
                if (_e717 < _e711) {
                    phi_939_ = _e717;
                } else {
                    phi_939_ = _e711;
                }
                let _e723 = phi_939_;
                let _e724 = bitcast<u32>(_e720);
                let _e726 = (_e682 + 1i);
                let _e727 = (_e691 + 1i);
                if (_e726 > 0i) {
                    phi_948_ = _e726;
                } else {
                    phi_948_ = 0i;
                }
                let _e730 = phi_948_;
                if (_e727 > 0i) {
                    phi_953_ = _e727;
                } else {
                    phi_953_ = 0i;
                }
                let _e733 = phi_953_;
                if (_e730 < _e711) {
                    phi_958_ = _e730;
                } else {
                    phi_958_ = _e711;
                }
                let _e736 = phi_958_;
                if (_e733 < _e711) {
                    phi_963_ = _e733;
                } else {
                    phi_963_ = _e711;
                }
                let _e739 = phi_963_;
                let _e740 = bitcast<u32>(_e736);
                let _e742 = (bitcast<u32>(_e723) * _e704);
                let _e743 = (bitcast<u32>(_e739) * _e704);
                let _e748 = ((_e742 + _e724) + _e709);
                let _e749 = ((_e742 + _e740) + _e709);
                let _e750 = ((_e743 + _e724) + _e709);
                let _e751 = ((_e743 + _e740) + _e709);
                if (_e748 < _e50) {
                } else {
                    return;
                }
                let _e755 = map.member[(0u + _e748)];
                if (_e749 < _e50) {
                } else {
                    return;
                }
                let _e767 = map.member[(0u + _e749)];
                if (_e750 < _e50) {
                } else {
                    return;
                }
                let _e783 = map.member[(0u + _e750)];
                if (_e751 < _e50) {
                } else {
                    return;
                }
                let _e799 = map.member[(0u + _e751)];
                let _e813 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e755.x * _e694) + (_e767.x * _e696)) + (_e783.x * _e698)) + (_e799.x * _e699)), ((((_e755.y * _e694) + (_e767.y * _e696)) + (_e783.y * _e698)) + (_e799.y * _e699)), ((((_e755.z * _e694) + (_e767.z * _e696)) + (_e783.z * _e698)) + (_e799.z * _e699)), ((((_e755.w * _e694) + (_e767.w * _e696)) + (_e783.w * _e698)) + (_e799.w * _e699))), _e608);
                let _e815 = p.member.epsilon;
                if (_e813 <= _e815) {
                    phi_1058_ = true;
                } else {
                    phi_1058_ = (_e813 >= (1f - _e815));
                }
                let _e820 = phi_1058_;
                if ((bitcast<u32>(_e813) & 2147483647u) > 2139095040u) {
                    phi_1066_ = true;
                } else {
                    phi_1066_ = !(_e820);
                }
                let _e826 = phi_1066_;
                if _e826 {
                    if (_e813 > 0f) {
                        if (_e813 < 1f) {
                            phi_1078_ = false;
                        } else {
                            phi_1078_ = true;
                        }
                        let _e830 = phi_1078_;
                        phi_1079_ = _e830;
                    } else {
                        phi_1079_ = true;
                    }
                    let _e832 = phi_1079_;
                    if _e832 {
                        phi_1083_ = 0.5f;
                    } else {
                        phi_1083_ = _e813;
                    }
                    let _e834 = phi_1083_;
                    phi_1091_ = evaluate_Verdict(_e834, true);
                } else {
                    if (_e813 > 0.5f) {
                        phi_1089_ = 1f;
                    } else {
                        phi_1089_ = 0f;
                    }
                    let _e838 = phi_1089_;
                    phi_1091_ = evaluate_Verdict(_e838, false);
                }
                let _e841 = phi_1091_;
                phi_1096_ = evaluate_Verdict(_e841.visibility, _e841.is_doubted);
            } else {
                phi_1096_ = evaluate_Verdict(0.5f, true);
            }
            let _e847 = phi_1096_;
            phi_1097_ = _e847;
        }
        let _e849 = phi_1097_;
        visibility.member[_e61.first_primitive] = _e849.visibility;
        phi_1101_ = _e849.is_doubted;
        phi_1102_ = _e61.first_primitive;
    } else {
        phi_1101_ = false;
        phi_1102_ = 0u;
    }
    let _e854 = phi_1101_;
    let _e856 = phi_1102_;
    if (_e45 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e854 {
        let _e860 = atomicAdd((&shared_[0u]), 1u);
        phi_1113_ = _e860;
    } else {
        phi_1113_ = 0u;
    }
    let _e862 = phi_1113_;
    workgroupBarrier();
    if (_e45 == 0u) {
        let _e866 = atomicLoad((&shared_[0u]));
        let _e867 = atomicAdd((&list.member[3u]), _e866);
        atomicStore((&shared_[1u]), _e867);
    }
    workgroupBarrier();
    if _e854 {
        let _e870 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e870) + _e862)]), _e856);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
