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
    var phi_143_: lt_bvh_traverse_Tree;
    var phi_144_: bool;
    var phi_145_: lt_bvh_traverse_Tree;
    var phi_146_: bool;
    var phi_151_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_143_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_144_ = false;
        } else {
            phi_143_ = lt_bvh_traverse_Tree();
            phi_144_ = true;
        }
        let _e52 = phi_143_;
        let _e54 = phi_144_;
        phi_145_ = _e52;
        phi_146_ = _e54;
    } else {
        phi_145_ = lt_bvh_traverse_Tree();
        phi_146_ = true;
    }
    let _e56 = phi_145_;
    let _e58 = phi_146_;
    if _e58 {
        phi_151_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_151_ = _e56;
    }
    let _e63 = phi_151_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_176_: f32;
    var phi_177_: f32;
    var phi_178_: f32;
    var phi_196_: bool;
    var phi_200_: f32;
    var phi_212_: bool;
    var phi_219_: f32;
    var phi_234_: f32;
    var phi_235_: f32;
    var phi_236_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_178_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_177_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_176_ = 1f;
            } else {
                phi_176_ = param_6;
            }
            let _e48 = phi_176_;
            phi_177_ = _e48;
        }
        let _e50 = phi_177_;
        phi_178_ = _e50;
    }
    let _e52 = phi_178_;
    let _e55 = (*param_4);
    let _e59 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e55) & 2147483647u) > 2139095040u) {
        phi_196_ = true;
    } else {
        let _e63 = (_e55 > _e59);
        if _e63 {
        }
        phi_196_ = _e63;
    }
    let _e65 = phi_196_;
    if _e65 {
        phi_200_ = _e55;
    } else {
        phi_200_ = _e59;
    }
    let _e67 = phi_200_;
    let _e68 = (_e52 - param_5.x);
    if (_e68 <= 0f) {
        let _e72 = ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u);
        if _e72 {
        }
        phi_212_ = _e72;
    } else {
        phi_212_ = true;
    }
    let _e74 = phi_212_;
    if _e74 {
        phi_219_ = (_e67 / (_e67 + (_e68 * _e68)));
    } else {
        phi_219_ = 1f;
    }
    let _e79 = phi_219_;
    if ((bitcast<u32>(_e79) & 2147483647u) > 2139095040u) {
        phi_236_ = _e79;
    } else {
        if (_e79 < 0f) {
            phi_235_ = 0f;
        } else {
            if (_e79 > 1f) {
                phi_234_ = 1f;
            } else {
                phi_234_ = _e79;
            }
            let _e86 = phi_234_;
            phi_235_ = _e86;
        }
        let _e88 = phi_235_;
        phi_236_ = _e88;
    }
    let _e90 = phi_236_;
    return _e90;
}

fn function_() {
    var local: f32;
    var phi_297_: bool;
    var phi_298_: bool;
    var phi_299_: bool;
    var phi_300_: bool;
    var phi_304_: bool;
    var phi_348_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_352_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_372_: lt_math_LightPoint;
    var phi_375_: u32;
    var phi_377_: lt_math_LevelPoint;
    var phi_463_: bool;
    var phi_472_: bool;
    var phi_481_: bool;
    var phi_482_: bool;
    var phi_483_: bool;
    var phi_484_: bool;
    var phi_485_: bool;
    var phi_486_: bool;
    var phi_487_: bool;
    var phi_491_: bool;
    var phi_518_: bool;
    var phi_519_: bool;
    var phi_520_: bool;
    var phi_521_: bool;
    var phi_522_: bool;
    var phi_523_: bool;
    var phi_524_: bool;
    var phi_525_: bool;
    var phi_529_: bool;
    var phi_538_: lt_math_LightPoint;
    var phi_539_: u32;
    var phi_540_: lt_math_LevelPoint;
    var phi_541_: bool;
    var phi_373_: lt_math_LightPoint;
    var phi_376_: u32;
    var phi_378_: lt_math_LevelPoint;
    var phi_542_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_582_: bool;
    var phi_583_: bool;
    var phi_584_: bool;
    var phi_585_: bool;
    var phi_589_: bool;
    var phi_671_: f32;
    var phi_787_: f32;
    var phi_788_: f32;
    var phi_791_: f32;
    var phi_820_: f32;
    var phi_825_: f32;
    var phi_826_: bool;
    var phi_827_: f32;
    var phi_828_: bool;
    var phi_832_: f32;
    var phi_852_: f32;
    var phi_857_: f32;
    var phi_858_: bool;
    var phi_859_: f32;
    var phi_860_: bool;
    var phi_864_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_913_: i32;
    var phi_918_: i32;
    var phi_923_: i32;
    var phi_928_: i32;
    var phi_937_: i32;
    var phi_942_: i32;
    var phi_947_: i32;
    var phi_952_: i32;
    var phi_1047_: bool;
    var phi_1055_: bool;
    var phi_1067_: bool;
    var phi_1068_: bool;
    var phi_1072_: f32;
    var phi_1078_: f32;
    var phi_1080_: evaluate_Verdict;
    var phi_1085_: evaluate_Verdict;
    var phi_1086_: evaluate_Verdict;

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
        let _e70 = p.member.light;
        let _e73 = samples.member[(0u + _e59.first_primitive)].normal[0u];
        let _e75 = global[0u];
        if (_e73 == _e75) {
            let _e78 = samples.member[(0u + _e59.first_primitive)].normal[1u];
            let _e80 = global[1u];
            if (_e78 == _e80) {
                let _e83 = samples.member[(0u + _e59.first_primitive)].normal[2u];
                let _e85 = global[2u];
                phi_297_ = (_e83 == _e85);
                phi_298_ = false;
            } else {
                phi_297_ = bool();
                phi_298_ = true;
            }
            let _e88 = phi_297_;
            let _e90 = phi_298_;
            phi_299_ = _e88;
            phi_300_ = _e90;
        } else {
            phi_299_ = bool();
            phi_300_ = true;
        }
        let _e92 = phi_299_;
        let _e94 = phi_300_;
        if _e94 {
            phi_304_ = false;
        } else {
            phi_304_ = _e92;
        }
        let _e96 = phi_304_;
        if !(_e96) {
            let _e99 = samples.member[(0u + _e59.first_primitive)].normal;
            let _e101 = samples.member[(0u + _e59.first_primitive)].position;
            if ((((_e99.x * (_e70.x - (_e101.x * _e70.w))) + (_e99.y * (_e70.y - (_e101.y * _e70.w)))) + (_e99.z * (_e70.z - (_e101.z * _e70.w)))) > 0f) {
                let _e125 = samples.member[(0u + _e59.first_primitive)].flags;
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e133.unnamed.visibility, false), _e133.unnamed_1);
                phi_348_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e139.unnamed, ((_e125 & 1u) == 0u));
            } else {
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e148.unnamed.visibility, false), _e148.unnamed_1);
                phi_348_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e154.unnamed, true);
            }
            let _e159 = phi_348_;
            phi_352_ = _e159;
        } else {
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e165.unnamed.visibility, false), _e165.unnamed_1);
            phi_352_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e171.unnamed, true);
        }
        let _e176 = phi_352_;
        if _e176.unnamed_1 {
            phi_1086_ = evaluate_Verdict(_e176.unnamed.visibility, _e176.unnamed.is_doubted);
        } else {
            let _e184 = samples.member[(0u + _e59.first_primitive)].position;
            let _e186 = p.member.map_size;
            let _e188 = (0.5f / f32(_e186));
            let _e195 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e202 = lt_math_LightPoint(vec2<f32>(_e195.uv.x, 0f), _e195.depth, _e195.is_inside);
            let _e206 = lt_math_LightPoint(_e202.uv, 0f, _e202.is_inside);
            phi_372_ = lt_math_LightPoint();
            phi_375_ = 0u;
            phi_377_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e206.uv, _e206.depth, false));
            loop {
                let _e213 = phi_372_;
                let _e215 = phi_375_;
                let _e217 = phi_377_;
                local_1 = _e217;
                local_2 = _e217;
                local_3 = _e217;
                if (_e215 < _e65) {
                    if _e217.point.is_inside {
                        phi_538_ = lt_math_LightPoint();
                        phi_539_ = u32();
                        phi_540_ = lt_math_LevelPoint();
                        phi_541_ = false;
                    } else {
                        if (_e215 < _e53) {
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
                                phi_463_ = (_e253 <= 1f);
                            } else {
                                phi_463_ = false;
                            }
                            let _e285 = phi_463_;
                            if _e285 {
                                if (_e267 >= 0f) {
                                    phi_472_ = (_e267 <= 1f);
                                } else {
                                    phi_472_ = false;
                                }
                                let _e289 = phi_472_;
                                if _e289 {
                                    if (_e280 >= 0f) {
                                        phi_481_ = (_e280 <= 1f);
                                    } else {
                                        phi_481_ = false;
                                    }
                                    let _e293 = phi_481_;
                                    phi_482_ = _e293;
                                    phi_483_ = false;
                                } else {
                                    phi_482_ = bool();
                                    phi_483_ = true;
                                }
                                let _e295 = phi_482_;
                                let _e297 = phi_483_;
                                phi_484_ = _e295;
                                phi_485_ = _e297;
                            } else {
                                phi_484_ = bool();
                                phi_485_ = true;
                            }
                            let _e299 = phi_484_;
                            let _e301 = phi_485_;
                            phi_486_ = _e299;
                            phi_487_ = _e301;
                        } else {
                            phi_486_ = bool();
                            phi_487_ = true;
                        }
                        let _e303 = phi_486_;
                        let _e305 = phi_487_;
                        if _e305 {
                            phi_491_ = false;
                        } else {
                            phi_491_ = _e303;
                        }
                        let _e307 = phi_491_;
                        if _e307 {
                            if (_e253 >= _e188) {
                                if (_e253 <= (1f - _e188)) {
                                    if (_e267 >= _e188) {
                                        phi_518_ = (_e267 <= (1f - _e188));
                                        phi_519_ = false;
                                    } else {
                                        phi_518_ = bool();
                                        phi_519_ = true;
                                    }
                                    let _e315 = phi_518_;
                                    let _e317 = phi_519_;
                                    phi_520_ = _e315;
                                    phi_521_ = _e317;
                                } else {
                                    phi_520_ = bool();
                                    phi_521_ = true;
                                }
                                let _e319 = phi_520_;
                                let _e321 = phi_521_;
                                phi_522_ = _e319;
                                phi_523_ = _e321;
                            } else {
                                phi_522_ = bool();
                                phi_523_ = true;
                            }
                            let _e323 = phi_522_;
                            let _e325 = phi_523_;
                            phi_524_ = _e323;
                            phi_525_ = _e325;
                        } else {
                            phi_524_ = bool();
                            phi_525_ = true;
                        }
                        let _e327 = phi_524_;
                        let _e329 = phi_525_;
                        if _e329 {
                            phi_529_ = false;
                        } else {
                            phi_529_ = _e327;
                        }
                        let _e331 = phi_529_;
                        let _e338 = lt_math_LightPoint(vec2<f32>(_e253, _e213.uv.y), _e213.depth, _e213.is_inside);
                        let _e345 = lt_math_LightPoint(vec2<f32>(_e338.uv.x, _e267), _e338.depth, _e338.is_inside);
                        let _e349 = lt_math_LightPoint(_e345.uv, _e280, _e345.is_inside);
                        let _e353 = lt_math_LightPoint(_e349.uv, _e349.depth, _e331);
                        phi_538_ = _e353;
                        phi_539_ = (_e215 + 1u);
                        phi_540_ = lt_math_LevelPoint(_e215, _e353);
                        phi_541_ = true;
                    }
                    let _e357 = phi_538_;
                    let _e359 = phi_539_;
                    let _e361 = phi_540_;
                    let _e363 = phi_541_;
                    phi_373_ = _e357;
                    phi_376_ = _e359;
                    phi_378_ = _e361;
                    phi_542_ = _e363;
                } else {
                    phi_373_ = lt_math_LightPoint();
                    phi_376_ = u32();
                    phi_378_ = lt_math_LevelPoint();
                    phi_542_ = false;
                }
                let _e365 = phi_373_;
                let _e367 = phi_376_;
                let _e369 = phi_378_;
                let _e371 = phi_542_;
                continue;
                continuing {
                    phi_372_ = _e365;
                    phi_375_ = _e367;
                    phi_377_ = _e369;
                    break if !(_e371);
                }
            }
            let _e374 = local_1;
            if _e374.point.is_inside {
                if (0f > 0f) {
                    let _e380 = local_2;
                    if (_e380.level < _e53) {
                    } else {
                        return;
                    }
                    let _e385 = levels.member[(0u + _e380.level)];
                    let _e391 = global[0u];
                    if (_e385.row_w.x == _e391) {
                        let _e394 = global[1u];
                        if (_e385.row_w.y == _e394) {
                            let _e397 = global[2u];
                            phi_582_ = (_e385.row_w.z == _e397);
                            phi_583_ = false;
                        } else {
                            phi_582_ = bool();
                            phi_583_ = true;
                        }
                        let _e400 = phi_582_;
                        let _e402 = phi_583_;
                        phi_584_ = _e400;
                        phi_585_ = _e402;
                    } else {
                        phi_584_ = bool();
                        phi_585_ = true;
                    }
                    let _e404 = phi_584_;
                    let _e406 = phi_585_;
                    if _e406 {
                        phi_589_ = false;
                    } else {
                        phi_589_ = _e404;
                    }
                    let _e408 = phi_589_;
                    if _e408 {
                        let _e410 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e412 = p.member.map_size;
                        let _e482 = ((abs(((((_e385.row_x.x * _e410.x) + (_e385.row_x.y * _e410.y)) + (_e385.row_x.z * _e410.z)) / (((_e385.row_x.x * _e385.row_x.x) + (_e385.row_x.y * _e385.row_x.y)) + (_e385.row_x.z * _e385.row_x.z)))) + abs(((((_e385.row_y.x * _e410.x) + (_e385.row_y.y * _e410.y)) + (_e385.row_y.z * _e410.z)) / (((_e385.row_y.x * _e385.row_y.x) + (_e385.row_y.y * _e385.row_y.y)) + (_e385.row_y.z * _e385.row_y.z))))) / (abs(((((_e385.row_z.x * _e410.x) + (_e385.row_z.y * _e410.y)) + (_e385.row_z.z * _e410.z)) / (((_e385.row_z.x * _e385.row_z.x) + (_e385.row_z.y * _e385.row_z.y)) + (_e385.row_z.z * _e385.row_z.z)))) * f32(_e412)));
                        if (_e482 < 0.002f) {
                            phi_671_ = _e482;
                        } else {
                            phi_671_ = 0.002f;
                        }
                        let _e485 = phi_671_;
                        phi_788_ = _e485;
                    } else {
                        let _e487 = p.member.map_size;
                        let _e493 = samples.member[(0u + _e59.first_primitive)].position;
                        let _e504 = ((((_e385.row_w.x * _e493.x) + (_e385.row_w.y * _e493.y)) + (_e385.row_w.z * _e493.z)) + _e385.row_w.w);
                        let _e517 = ((_e385.row_x.x - (_e385.row_w.x * _e374.point.uv.x)) / _e504);
                        let _e518 = ((_e385.row_x.y - (_e385.row_w.y * _e374.point.uv.x)) / _e504);
                        let _e519 = ((_e385.row_x.z - (_e385.row_w.z * _e374.point.uv.x)) / _e504);
                        let _e532 = ((_e385.row_y.x - (_e385.row_w.x * _e374.point.uv.y)) / _e504);
                        let _e533 = ((_e385.row_y.y - (_e385.row_w.y * _e374.point.uv.y)) / _e504);
                        let _e534 = ((_e385.row_y.z - (_e385.row_w.z * _e374.point.uv.y)) / _e504);
                        let _e540 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e545 = ((_e533 * _e540.z) - (_e540.y * _e534));
                        let _e550 = ((_e534 * _e540.x) - (_e540.z * _e532));
                        let _e555 = ((_e532 * _e540.y) - (_e540.x * _e533));
                        let _e557 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e562 = ((_e518 * _e557.z) - (_e557.y * _e519));
                        let _e567 = ((_e519 * _e557.x) - (_e557.z * _e517));
                        let _e572 = ((_e517 * _e557.y) - (_e557.x * _e518));
                        let _e599 = ((abs(((((_e385.row_z.x * _e545) + (_e385.row_z.y * _e550)) + (_e385.row_z.z * _e555)) / (((_e517 * _e545) + (_e518 * _e550)) + (_e519 * _e555)))) + abs(((((_e385.row_z.x * _e562) + (_e385.row_z.y * _e567)) + (_e385.row_z.z * _e572)) / (((_e532 * _e562) + (_e533 * _e567)) + (_e534 * _e572))))) / f32(_e487));
                        if (_e599 < 0.002f) {
                            phi_787_ = _e599;
                        } else {
                            phi_787_ = 0.002f;
                        }
                        let _e602 = phi_787_;
                        phi_788_ = _e602;
                    }
                    let _e604 = phi_788_;
                    phi_791_ = (_e374.point.depth - (0f * _e604));
                } else {
                    phi_791_ = _e374.point.depth;
                }
                let _e608 = phi_791_;
                let _e614 = p.member.map_size;
                let _e615 = f32(_e614);
                let _e618 = ((_e374.point.uv.x * _e615) - 0.5f);
                let _e619 = ((_e374.point.uv.y * _e615) - 0.5f);
                if (_e618 > -8388608f) {
                    let _e631 = f32(select(0i, select(select(i32(_e618), i32(-2147483648), (_e618 < bitcast<f32>(3472883712u))), 2147483647i, (_e618 > bitcast<f32>(1325400063u))), (_e618 == _e618)));
                    if (_e631 > _e618) {
                        phi_820_ = 1f;
                    } else {
                        phi_820_ = 0f;
                    }
                    let _e634 = phi_820_;
                    if (_e618 < 8388608f) {
                        phi_825_ = (_e631 - _e634);
                        phi_826_ = false;
                    } else {
                        phi_825_ = f32();
                        phi_826_ = true;
                    }
                    let _e637 = phi_825_;
                    let _e639 = phi_826_;
                    phi_827_ = _e637;
                    phi_828_ = _e639;
                } else {
                    phi_827_ = f32();
                    phi_828_ = true;
                }
                let _e641 = phi_827_;
                let _e643 = phi_828_;
                if _e643 {
                    phi_832_ = _e618;
                } else {
                    phi_832_ = _e641;
                }
                let _e645 = phi_832_;
                if (_e619 > -8388608f) {
                    let _e657 = f32(select(0i, select(select(i32(_e619), i32(-2147483648), (_e619 < bitcast<f32>(3472883712u))), 2147483647i, (_e619 > bitcast<f32>(1325400063u))), (_e619 == _e619)));
                    if (_e657 > _e619) {
                        phi_852_ = 1f;
                    } else {
                        phi_852_ = 0f;
                    }
                    let _e660 = phi_852_;
                    if (_e619 < 8388608f) {
                        phi_857_ = (_e657 - _e660);
                        phi_858_ = false;
                    } else {
                        phi_857_ = f32();
                        phi_858_ = true;
                    }
                    let _e663 = phi_857_;
                    let _e665 = phi_858_;
                    phi_859_ = _e663;
                    phi_860_ = _e665;
                } else {
                    phi_859_ = f32();
                    phi_860_ = true;
                }
                let _e667 = phi_859_;
                let _e669 = phi_860_;
                if _e669 {
                    phi_864_ = _e619;
                } else {
                    phi_864_ = _e667;
                }
                let _e671 = phi_864_;
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
                let _e706 = local_3;
                local = _e702;
                let _e709 = ((_e706.level * _e704) * _e704);
                let _e711 = (bitcast<i32>(_e704) - 1i);
                if (_e682 > 0i) {
                    phi_913_ = _e682;
                } else {
                    phi_913_ = 0i;
                }
                let _e714 = phi_913_;
                if (_e691 > 0i) {
                    phi_918_ = _e691;
                } else {
                    phi_918_ = 0i;
                }
                let _e717 = phi_918_;
                if (_e714 < _e711) {
                    phi_923_ = _e714;
                } else {
                    phi_923_ = _e711;
                }
                let _e720 = phi_923_;
                if (_e717 < _e711) {
                    phi_928_ = _e717;
                } else {
                    phi_928_ = _e711;
                }
                let _e723 = phi_928_;
                let _e724 = bitcast<u32>(_e720);
                let _e726 = (_e682 + 1i);
                let _e727 = (_e691 + 1i);
                if (_e726 > 0i) {
                    phi_937_ = _e726;
                } else {
                    phi_937_ = 0i;
                }
                let _e730 = phi_937_;
                if (_e727 > 0i) {
                    phi_942_ = _e727;
                } else {
                    phi_942_ = 0i;
                }
                let _e733 = phi_942_;
                if (_e730 < _e711) {
                    phi_947_ = _e730;
                } else {
                    phi_947_ = _e711;
                }
                let _e736 = phi_947_;
                if (_e733 < _e711) {
                    phi_952_ = _e733;
                } else {
                    phi_952_ = _e711;
                }
                let _e739 = phi_952_;
                let _e740 = bitcast<u32>(_e736);
                let _e742 = (bitcast<u32>(_e723) * _e704);
                let _e743 = (bitcast<u32>(_e739) * _e704);
                let _e748 = ((_e742 + _e724) + _e709);
                let _e749 = ((_e742 + _e740) + _e709);
                let _e750 = ((_e743 + _e724) + _e709);
                let _e751 = ((_e743 + _e740) + _e709);
                if (_e748 < _e47) {
                } else {
                    return;
                }
                let _e755 = map.member[(0u + _e748)];
                if (_e749 < _e47) {
                } else {
                    return;
                }
                let _e767 = map.member[(0u + _e749)];
                if (_e750 < _e47) {
                } else {
                    return;
                }
                let _e783 = map.member[(0u + _e750)];
                if (_e751 < _e47) {
                } else {
                    return;
                }
                let _e799 = map.member[(0u + _e751)];
                let _e813 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e755.x * _e694) + (_e767.x * _e696)) + (_e783.x * _e698)) + (_e799.x * _e699)), ((((_e755.y * _e694) + (_e767.y * _e696)) + (_e783.y * _e698)) + (_e799.y * _e699)), ((((_e755.z * _e694) + (_e767.z * _e696)) + (_e783.z * _e698)) + (_e799.z * _e699)), ((((_e755.w * _e694) + (_e767.w * _e696)) + (_e783.w * _e698)) + (_e799.w * _e699))), _e608);
                let _e815 = p.member.epsilon;
                if (_e813 <= _e815) {
                    phi_1047_ = true;
                } else {
                    phi_1047_ = (_e813 >= (1f - _e815));
                }
                let _e820 = phi_1047_;
                if ((bitcast<u32>(_e813) & 2147483647u) > 2139095040u) {
                    phi_1055_ = true;
                } else {
                    phi_1055_ = !(_e820);
                }
                let _e826 = phi_1055_;
                if _e826 {
                    if (_e813 > 0f) {
                        if (_e813 < 1f) {
                            phi_1067_ = false;
                        } else {
                            phi_1067_ = true;
                        }
                        let _e830 = phi_1067_;
                        phi_1068_ = _e830;
                    } else {
                        phi_1068_ = true;
                    }
                    let _e832 = phi_1068_;
                    if _e832 {
                        phi_1072_ = 0.5f;
                    } else {
                        phi_1072_ = _e813;
                    }
                    let _e834 = phi_1072_;
                    phi_1080_ = evaluate_Verdict(_e834, true);
                } else {
                    if (_e813 > 0.5f) {
                        phi_1078_ = 1f;
                    } else {
                        phi_1078_ = 0f;
                    }
                    let _e838 = phi_1078_;
                    phi_1080_ = evaluate_Verdict(_e838, false);
                }
                let _e841 = phi_1080_;
                phi_1085_ = evaluate_Verdict(_e841.visibility, _e841.is_doubted);
            } else {
                phi_1085_ = evaluate_Verdict(0.5f, true);
            }
            let _e847 = phi_1085_;
            phi_1086_ = _e847;
        }
        let _e849 = phi_1086_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e849.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_vsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
