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
    var phi_156_: lt_bvh_traverse_Tree;
    var phi_157_: bool;
    var phi_158_: lt_bvh_traverse_Tree;
    var phi_159_: bool;
    var phi_164_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_156_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_157_ = false;
        } else {
            phi_156_ = lt_bvh_traverse_Tree();
            phi_157_ = true;
        }
        let _e64 = phi_156_;
        let _e66 = phi_157_;
        phi_158_ = _e64;
        phi_159_ = _e66;
    } else {
        phi_158_ = lt_bvh_traverse_Tree();
        phi_159_ = true;
    }
    let _e68 = phi_158_;
    let _e70 = phi_159_;
    if _e70 {
        phi_164_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_164_ = _e68;
    }
    let _e75 = phi_164_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_184_: bool;
    var phi_188_: f32;

    let _e52 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_184_ = true;
    } else {
        let _e56 = (84f < _e52);
        if _e56 {
        }
        phi_184_ = _e56;
    }
    let _e58 = phi_184_;
    if _e58 {
        phi_188_ = 84f;
    } else {
        phi_188_ = _e52;
    }
    let _e60 = phi_188_;
    return _e60;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_207_: f32;
    var phi_208_: f32;
    var phi_209_: f32;
    var phi_224_: f32;
    var phi_229_: f32;
    var phi_251_: f32;
    var phi_256_: f32;
    var phi_257_: bool;
    var phi_258_: f32;
    var phi_259_: bool;
    var phi_263_: f32;
    var phi_301_: f32;
    var phi_317_: f32;
    var phi_318_: f32;
    var phi_319_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_209_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_208_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_207_ = 1f;
            } else {
                phi_207_ = param_7;
            }
            let _e60 = phi_207_;
            phi_208_ = _e60;
        }
        let _e62 = phi_208_;
        phi_209_ = _e62;
    }
    let _e64 = phi_209_;
    let _e66 = _lt_math_esm_Esm_clamped_exponent(param_5);
    let _e68 = (_e66 * (1f - _e64));
    if ((bitcast<u32>(_e68) & 2147483647u) > 2139095040u) {
        phi_301_ = _e68;
    } else {
        if (_e68 < -87f) {
            phi_224_ = -87f;
        } else {
            phi_224_ = _e68;
        }
        let _e74 = phi_224_;
        if (_e74 > 88f) {
            phi_229_ = 88f;
        } else {
            phi_229_ = _e74;
        }
        let _e77 = phi_229_;
        let _e79 = ((_e77 * 1.442695f) + 0.5f);
        if (_e79 > -8388608f) {
            let _e91 = f32(select(0i, select(select(i32(_e79), i32(-2147483648), (_e79 < bitcast<f32>(3472883712u))), 2147483647i, (_e79 > bitcast<f32>(1325400063u))), (_e79 == _e79)));
            if (_e91 > _e79) {
                phi_251_ = 1f;
            } else {
                phi_251_ = 0f;
            }
            let _e94 = phi_251_;
            if (_e79 < 8388608f) {
                phi_256_ = (_e91 - _e94);
                phi_257_ = false;
            } else {
                phi_256_ = f32();
                phi_257_ = true;
            }
            let _e97 = phi_256_;
            let _e99 = phi_257_;
            phi_258_ = _e97;
            phi_259_ = _e99;
        } else {
            phi_258_ = f32();
            phi_259_ = true;
        }
        let _e101 = phi_258_;
        let _e103 = phi_259_;
        if _e103 {
            phi_263_ = _e79;
        } else {
            phi_263_ = _e101;
        }
        let _e105 = phi_263_;
        let _e109 = ((_e77 - (_e105 * 0.69314575f)) - (_e105 * 0.0000014286068f));
        phi_301_ = ((((((((((((((((1f / 5040f) * _e109) + (1f / 720f)) * _e109) + (1f / 120f)) * _e109) + (1f / 24f)) * _e109) + (1f / 6f)) * _e109) + 0.5f) * _e109) + 1f) * _e109) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e105), i32(-2147483648), (_e105 < bitcast<f32>(3472883712u))), 2147483647i, (_e105 > bitcast<f32>(1325400063u))), (_e105 == _e105)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e145 = phi_301_;
    let _e146 = (param_6.x * _e145);
    if ((bitcast<u32>(_e146) & 2147483647u) > 2139095040u) {
        phi_319_ = _e146;
    } else {
        if (_e146 < 0f) {
            phi_318_ = 0f;
        } else {
            if (_e146 > 1f) {
                phi_317_ = 1f;
            } else {
                phi_317_ = _e146;
            }
            let _e153 = phi_317_;
            phi_318_ = _e153;
        }
        let _e155 = phi_318_;
        phi_319_ = _e155;
    }
    let _e157 = phi_319_;
    return _e157;
}

fn function_() {
    var local: f32;
    var phi_380_: bool;
    var phi_381_: bool;
    var phi_382_: bool;
    var phi_383_: bool;
    var phi_387_: bool;
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
    var phi_1130_: bool;
    var phi_1138_: bool;
    var phi_1150_: bool;
    var phi_1151_: bool;
    var phi_1155_: f32;
    var phi_1161_: f32;
    var phi_1163_: evaluate_Verdict;
    var phi_1168_: evaluate_Verdict;
    var phi_1169_: evaluate_Verdict;

    let _e52 = id_1;
    let _e59 = arrayLength((&map.member));
    let _e65 = arrayLength((&levels.member));
    let _e68 = p.member.size[0u];
    let _e70 = p.member.size[1u];
    let _e71 = lt_shaders_entry_pixel_index(_e52, _e68, _e70);
    if (bitcast<i32>(_e71.root) != 0i) {
        let _e77 = p.member.level_count;
        if (_e71.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e82 = p.member.light;
        let _e85 = samples.member[(0u + _e71.first_primitive)].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[(0u + _e71.first_primitive)].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[(0u + _e71.first_primitive)].normal[2u];
                let _e97 = global[2u];
                phi_380_ = (_e95 == _e97);
                phi_381_ = false;
            } else {
                phi_380_ = bool();
                phi_381_ = true;
            }
            let _e100 = phi_380_;
            let _e102 = phi_381_;
            phi_382_ = _e100;
            phi_383_ = _e102;
        } else {
            phi_382_ = bool();
            phi_383_ = true;
        }
        let _e104 = phi_382_;
        let _e106 = phi_383_;
        if _e106 {
            phi_387_ = false;
        } else {
            phi_387_ = _e104;
        }
        let _e108 = phi_387_;
        if !(_e108) {
            let _e111 = samples.member[(0u + _e71.first_primitive)].normal;
            let _e113 = samples.member[(0u + _e71.first_primitive)].position;
            if ((((_e111.x * (_e82.x - (_e113.x * _e82.w))) + (_e111.y * (_e82.y - (_e113.y * _e82.w)))) + (_e111.z * (_e82.z - (_e113.z * _e82.w)))) > 0f) {
                let _e137 = samples.member[(0u + _e71.first_primitive)].flags;
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e145.unnamed.visibility, false), _e145.unnamed_1);
                phi_431_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e151.unnamed, ((_e137 & 1u) == 0u));
            } else {
                let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e160.unnamed.visibility, false), _e160.unnamed_1);
                phi_431_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e166.unnamed, true);
            }
            let _e171 = phi_431_;
            phi_435_ = _e171;
        } else {
            let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e177.unnamed.visibility, false), _e177.unnamed_1);
            phi_435_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e183.unnamed, true);
        }
        let _e188 = phi_435_;
        if _e188.unnamed_1 {
            phi_1169_ = evaluate_Verdict(_e188.unnamed.visibility, _e188.unnamed.is_doubted);
        } else {
            let _e196 = samples.member[(0u + _e71.first_primitive)].position;
            let _e198 = p.member.map_size;
            let _e200 = (0.5f / f32(_e198));
            let _e207 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e214 = lt_math_LightPoint(vec2<f32>(_e207.uv.x, 0f), _e207.depth, _e207.is_inside);
            let _e218 = lt_math_LightPoint(_e214.uv, 0f, _e214.is_inside);
            phi_455_ = lt_math_LightPoint();
            phi_458_ = 0u;
            phi_460_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e218.uv, _e218.depth, false));
            loop {
                let _e225 = phi_455_;
                let _e227 = phi_458_;
                let _e229 = phi_460_;
                local_1 = _e229;
                local_2 = _e229;
                local_3 = _e229;
                if (_e227 < _e77) {
                    if _e229.point.is_inside {
                        phi_621_ = lt_math_LightPoint();
                        phi_622_ = u32();
                        phi_623_ = lt_math_LevelPoint();
                        phi_624_ = false;
                    } else {
                        if (_e227 < _e65) {
                        } else {
                            return;
                        }
                        let _e240 = levels.member[(0u + _e227)].row_w;
                        let _e251 = ((((_e240.x * _e196.x) + (_e240.y * _e196.y)) + (_e240.z * _e196.z)) + (_e240.w * 1f));
                        let _e253 = levels.member[(0u + _e227)].row_x;
                        let _e265 = (((((_e253.x * _e196.x) + (_e253.y * _e196.y)) + (_e253.z * _e196.z)) + (_e253.w * 1f)) / _e251);
                        let _e267 = levels.member[(0u + _e227)].row_y;
                        let _e279 = (((((_e267.x * _e196.x) + (_e267.y * _e196.y)) + (_e267.z * _e196.z)) + (_e267.w * 1f)) / _e251);
                        let _e281 = levels.member[(0u + _e227)].row_z;
                        let _e292 = ((((_e281.x * _e196.x) + (_e281.y * _e196.y)) + (_e281.z * _e196.z)) + (_e281.w * 1f));
                        if (_e251 > 0f) {
                            if (_e265 >= 0f) {
                                phi_546_ = (_e265 <= 1f);
                            } else {
                                phi_546_ = false;
                            }
                            let _e297 = phi_546_;
                            if _e297 {
                                if (_e279 >= 0f) {
                                    phi_555_ = (_e279 <= 1f);
                                } else {
                                    phi_555_ = false;
                                }
                                let _e301 = phi_555_;
                                if _e301 {
                                    if (_e292 >= 0f) {
                                        phi_564_ = (_e292 <= 1f);
                                    } else {
                                        phi_564_ = false;
                                    }
                                    let _e305 = phi_564_;
                                    phi_565_ = _e305;
                                    phi_566_ = false;
                                } else {
                                    phi_565_ = bool();
                                    phi_566_ = true;
                                }
                                let _e307 = phi_565_;
                                let _e309 = phi_566_;
                                phi_567_ = _e307;
                                phi_568_ = _e309;
                            } else {
                                phi_567_ = bool();
                                phi_568_ = true;
                            }
                            let _e311 = phi_567_;
                            let _e313 = phi_568_;
                            phi_569_ = _e311;
                            phi_570_ = _e313;
                        } else {
                            phi_569_ = bool();
                            phi_570_ = true;
                        }
                        let _e315 = phi_569_;
                        let _e317 = phi_570_;
                        if _e317 {
                            phi_574_ = false;
                        } else {
                            phi_574_ = _e315;
                        }
                        let _e319 = phi_574_;
                        if _e319 {
                            if (_e265 >= _e200) {
                                if (_e265 <= (1f - _e200)) {
                                    if (_e279 >= _e200) {
                                        phi_601_ = (_e279 <= (1f - _e200));
                                        phi_602_ = false;
                                    } else {
                                        phi_601_ = bool();
                                        phi_602_ = true;
                                    }
                                    let _e327 = phi_601_;
                                    let _e329 = phi_602_;
                                    phi_603_ = _e327;
                                    phi_604_ = _e329;
                                } else {
                                    phi_603_ = bool();
                                    phi_604_ = true;
                                }
                                let _e331 = phi_603_;
                                let _e333 = phi_604_;
                                phi_605_ = _e331;
                                phi_606_ = _e333;
                            } else {
                                phi_605_ = bool();
                                phi_606_ = true;
                            }
                            let _e335 = phi_605_;
                            let _e337 = phi_606_;
                            phi_607_ = _e335;
                            phi_608_ = _e337;
                        } else {
                            phi_607_ = bool();
                            phi_608_ = true;
                        }
                        let _e339 = phi_607_;
                        let _e341 = phi_608_;
                        if _e341 {
                            phi_612_ = false;
                        } else {
                            phi_612_ = _e339;
                        }
                        let _e343 = phi_612_;
                        let _e350 = lt_math_LightPoint(vec2<f32>(_e265, _e225.uv.y), _e225.depth, _e225.is_inside);
                        let _e357 = lt_math_LightPoint(vec2<f32>(_e350.uv.x, _e279), _e350.depth, _e350.is_inside);
                        let _e361 = lt_math_LightPoint(_e357.uv, _e292, _e357.is_inside);
                        let _e365 = lt_math_LightPoint(_e361.uv, _e361.depth, _e343);
                        phi_621_ = _e365;
                        phi_622_ = (_e227 + 1u);
                        phi_623_ = lt_math_LevelPoint(_e227, _e365);
                        phi_624_ = true;
                    }
                    let _e369 = phi_621_;
                    let _e371 = phi_622_;
                    let _e373 = phi_623_;
                    let _e375 = phi_624_;
                    phi_456_ = _e369;
                    phi_459_ = _e371;
                    phi_461_ = _e373;
                    phi_625_ = _e375;
                } else {
                    phi_456_ = lt_math_LightPoint();
                    phi_459_ = u32();
                    phi_461_ = lt_math_LevelPoint();
                    phi_625_ = false;
                }
                let _e377 = phi_456_;
                let _e379 = phi_459_;
                let _e381 = phi_461_;
                let _e383 = phi_625_;
                continue;
                continuing {
                    phi_455_ = _e377;
                    phi_458_ = _e379;
                    phi_460_ = _e381;
                    break if !(_e383);
                }
            }
            let _e386 = local_1;
            if _e386.point.is_inside {
                if (0f > 0f) {
                    let _e392 = local_2;
                    if (_e392.level < _e65) {
                    } else {
                        return;
                    }
                    let _e397 = levels.member[(0u + _e392.level)];
                    let _e403 = global[0u];
                    if (_e397.row_w.x == _e403) {
                        let _e406 = global[1u];
                        if (_e397.row_w.y == _e406) {
                            let _e409 = global[2u];
                            phi_665_ = (_e397.row_w.z == _e409);
                            phi_666_ = false;
                        } else {
                            phi_665_ = bool();
                            phi_666_ = true;
                        }
                        let _e412 = phi_665_;
                        let _e414 = phi_666_;
                        phi_667_ = _e412;
                        phi_668_ = _e414;
                    } else {
                        phi_667_ = bool();
                        phi_668_ = true;
                    }
                    let _e416 = phi_667_;
                    let _e418 = phi_668_;
                    if _e418 {
                        phi_672_ = false;
                    } else {
                        phi_672_ = _e416;
                    }
                    let _e420 = phi_672_;
                    if _e420 {
                        let _e422 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e424 = p.member.map_size;
                        let _e494 = ((abs(((((_e397.row_x.x * _e422.x) + (_e397.row_x.y * _e422.y)) + (_e397.row_x.z * _e422.z)) / (((_e397.row_x.x * _e397.row_x.x) + (_e397.row_x.y * _e397.row_x.y)) + (_e397.row_x.z * _e397.row_x.z)))) + abs(((((_e397.row_y.x * _e422.x) + (_e397.row_y.y * _e422.y)) + (_e397.row_y.z * _e422.z)) / (((_e397.row_y.x * _e397.row_y.x) + (_e397.row_y.y * _e397.row_y.y)) + (_e397.row_y.z * _e397.row_y.z))))) / (abs(((((_e397.row_z.x * _e422.x) + (_e397.row_z.y * _e422.y)) + (_e397.row_z.z * _e422.z)) / (((_e397.row_z.x * _e397.row_z.x) + (_e397.row_z.y * _e397.row_z.y)) + (_e397.row_z.z * _e397.row_z.z)))) * f32(_e424)));
                        if (_e494 < 0.002f) {
                            phi_754_ = _e494;
                        } else {
                            phi_754_ = 0.002f;
                        }
                        let _e497 = phi_754_;
                        phi_871_ = _e497;
                    } else {
                        let _e499 = p.member.map_size;
                        let _e505 = samples.member[(0u + _e71.first_primitive)].position;
                        let _e516 = ((((_e397.row_w.x * _e505.x) + (_e397.row_w.y * _e505.y)) + (_e397.row_w.z * _e505.z)) + _e397.row_w.w);
                        let _e529 = ((_e397.row_x.x - (_e397.row_w.x * _e386.point.uv.x)) / _e516);
                        let _e530 = ((_e397.row_x.y - (_e397.row_w.y * _e386.point.uv.x)) / _e516);
                        let _e531 = ((_e397.row_x.z - (_e397.row_w.z * _e386.point.uv.x)) / _e516);
                        let _e544 = ((_e397.row_y.x - (_e397.row_w.x * _e386.point.uv.y)) / _e516);
                        let _e545 = ((_e397.row_y.y - (_e397.row_w.y * _e386.point.uv.y)) / _e516);
                        let _e546 = ((_e397.row_y.z - (_e397.row_w.z * _e386.point.uv.y)) / _e516);
                        let _e552 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e557 = ((_e545 * _e552.z) - (_e552.y * _e546));
                        let _e562 = ((_e546 * _e552.x) - (_e552.z * _e544));
                        let _e567 = ((_e544 * _e552.y) - (_e552.x * _e545));
                        let _e569 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e574 = ((_e530 * _e569.z) - (_e569.y * _e531));
                        let _e579 = ((_e531 * _e569.x) - (_e569.z * _e529));
                        let _e584 = ((_e529 * _e569.y) - (_e569.x * _e530));
                        let _e611 = ((abs(((((_e397.row_z.x * _e557) + (_e397.row_z.y * _e562)) + (_e397.row_z.z * _e567)) / (((_e529 * _e557) + (_e530 * _e562)) + (_e531 * _e567)))) + abs(((((_e397.row_z.x * _e574) + (_e397.row_z.y * _e579)) + (_e397.row_z.z * _e584)) / (((_e544 * _e574) + (_e545 * _e579)) + (_e546 * _e584))))) / f32(_e499));
                        if (_e611 < 0.002f) {
                            phi_870_ = _e611;
                        } else {
                            phi_870_ = 0.002f;
                        }
                        let _e614 = phi_870_;
                        phi_871_ = _e614;
                    }
                    let _e616 = phi_871_;
                    phi_874_ = (_e386.point.depth - (0f * _e616));
                } else {
                    phi_874_ = _e386.point.depth;
                }
                let _e620 = phi_874_;
                let _e626 = p.member.map_size;
                let _e627 = f32(_e626);
                let _e630 = ((_e386.point.uv.x * _e627) - 0.5f);
                let _e631 = ((_e386.point.uv.y * _e627) - 0.5f);
                if (_e630 > -8388608f) {
                    let _e643 = f32(select(0i, select(select(i32(_e630), i32(-2147483648), (_e630 < bitcast<f32>(3472883712u))), 2147483647i, (_e630 > bitcast<f32>(1325400063u))), (_e630 == _e630)));
                    if (_e643 > _e630) {
                        phi_903_ = 1f;
                    } else {
                        phi_903_ = 0f;
                    }
                    let _e646 = phi_903_;
                    if (_e630 < 8388608f) {
                        phi_908_ = (_e643 - _e646);
                        phi_909_ = false;
                    } else {
                        phi_908_ = f32();
                        phi_909_ = true;
                    }
                    let _e649 = phi_908_;
                    let _e651 = phi_909_;
                    phi_910_ = _e649;
                    phi_911_ = _e651;
                } else {
                    phi_910_ = f32();
                    phi_911_ = true;
                }
                let _e653 = phi_910_;
                let _e655 = phi_911_;
                if _e655 {
                    phi_915_ = _e630;
                } else {
                    phi_915_ = _e653;
                }
                let _e657 = phi_915_;
                if (_e631 > -8388608f) {
                    let _e669 = f32(select(0i, select(select(i32(_e631), i32(-2147483648), (_e631 < bitcast<f32>(3472883712u))), 2147483647i, (_e631 > bitcast<f32>(1325400063u))), (_e631 == _e631)));
                    if (_e669 > _e631) {
                        phi_935_ = 1f;
                    } else {
                        phi_935_ = 0f;
                    }
                    let _e672 = phi_935_;
                    if (_e631 < 8388608f) {
                        phi_940_ = (_e669 - _e672);
                        phi_941_ = false;
                    } else {
                        phi_940_ = f32();
                        phi_941_ = true;
                    }
                    let _e675 = phi_940_;
                    let _e677 = phi_941_;
                    phi_942_ = _e675;
                    phi_943_ = _e677;
                } else {
                    phi_942_ = f32();
                    phi_943_ = true;
                }
                let _e679 = phi_942_;
                let _e681 = phi_943_;
                if _e681 {
                    phi_947_ = _e631;
                } else {
                    phi_947_ = _e679;
                }
                let _e683 = phi_947_;
                let _e684 = (_e630 - _e657);
                let _e685 = (_e631 - _e683);
                let _e694 = select(0i, select(select(i32(_e657), i32(-2147483648), (_e657 < bitcast<f32>(3472883712u))), 2147483647i, (_e657 > bitcast<f32>(1325400063u))), (_e657 == _e657));
                let _e703 = select(0i, select(select(i32(_e683), i32(-2147483648), (_e683 < bitcast<f32>(3472883712u))), 2147483647i, (_e683 > bitcast<f32>(1325400063u))), (_e683 == _e683));
                let _e706 = ((1f - _e684) * (1f - _e685));
                let _e708 = (_e684 * (1f - _e685));
                let _e710 = ((1f - _e684) * _e685);
                let _e711 = (_e684 * _e685);
                let _e713 = p.member.test;
                let _e714 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e713);
                let _e716 = p.member.map_size;
                let _e718 = local_3;
                local = _e714;
                let _e721 = ((_e718.level * _e716) * _e716);
                let _e723 = (bitcast<i32>(_e716) - 1i);
                if (_e694 > 0i) {
                    phi_996_ = _e694;
                } else {
                    phi_996_ = 0i;
                }
                let _e726 = phi_996_;
                if (_e703 > 0i) {
                    phi_1001_ = _e703;
                } else {
                    phi_1001_ = 0i;
                }
                let _e729 = phi_1001_;
                if (_e726 < _e723) {
                    phi_1006_ = _e726;
                } else {
                    phi_1006_ = _e723;
                }
                let _e732 = phi_1006_;
                if (_e729 < _e723) {
                    phi_1011_ = _e729;
                } else {
                    phi_1011_ = _e723;
                }
                let _e735 = phi_1011_;
                let _e736 = bitcast<u32>(_e732);
                let _e738 = (_e694 + 1i);
                let _e739 = (_e703 + 1i);
                if (_e738 > 0i) {
                    phi_1020_ = _e738;
                } else {
                    phi_1020_ = 0i;
                }
                let _e742 = phi_1020_;
                if (_e739 > 0i) {
                    phi_1025_ = _e739;
                } else {
                    phi_1025_ = 0i;
                }
                let _e745 = phi_1025_;
                if (_e742 < _e723) {
                    phi_1030_ = _e742;
                } else {
                    phi_1030_ = _e723;
                }
                let _e748 = phi_1030_;
                if (_e745 < _e723) {
                    phi_1035_ = _e745;
                } else {
                    phi_1035_ = _e723;
                }
                let _e751 = phi_1035_;
                let _e752 = bitcast<u32>(_e748);
                let _e754 = (bitcast<u32>(_e735) * _e716);
                let _e755 = (bitcast<u32>(_e751) * _e716);
                let _e760 = ((_e754 + _e736) + _e721);
                let _e761 = ((_e754 + _e752) + _e721);
                let _e762 = ((_e755 + _e736) + _e721);
                let _e763 = ((_e755 + _e752) + _e721);
                if (_e760 < _e59) {
                } else {
                    return;
                }
                let _e767 = map.member[(0u + _e760)];
                if (_e761 < _e59) {
                } else {
                    return;
                }
                let _e779 = map.member[(0u + _e761)];
                if (_e762 < _e59) {
                } else {
                    return;
                }
                let _e795 = map.member[(0u + _e762)];
                if (_e763 < _e59) {
                } else {
                    return;
                }
                let _e811 = map.member[(0u + _e763)];
                let _e825 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e767.x * _e706) + (_e779.x * _e708)) + (_e795.x * _e710)) + (_e811.x * _e711)), ((((_e767.y * _e706) + (_e779.y * _e708)) + (_e795.y * _e710)) + (_e811.y * _e711)), ((((_e767.z * _e706) + (_e779.z * _e708)) + (_e795.z * _e710)) + (_e811.z * _e711)), ((((_e767.w * _e706) + (_e779.w * _e708)) + (_e795.w * _e710)) + (_e811.w * _e711))), _e620);
                let _e827 = p.member.epsilon;
                if (_e825 <= _e827) {
                    phi_1130_ = true;
                } else {
                    phi_1130_ = (_e825 >= (1f - _e827));
                }
                let _e832 = phi_1130_;
                if ((bitcast<u32>(_e825) & 2147483647u) > 2139095040u) {
                    phi_1138_ = true;
                } else {
                    phi_1138_ = !(_e832);
                }
                let _e838 = phi_1138_;
                if _e838 {
                    if (_e825 > 0f) {
                        if (_e825 < 1f) {
                            phi_1150_ = false;
                        } else {
                            phi_1150_ = true;
                        }
                        let _e842 = phi_1150_;
                        phi_1151_ = _e842;
                    } else {
                        phi_1151_ = true;
                    }
                    let _e844 = phi_1151_;
                    if _e844 {
                        phi_1155_ = 0.5f;
                    } else {
                        phi_1155_ = _e825;
                    }
                    let _e846 = phi_1155_;
                    phi_1163_ = evaluate_Verdict(_e846, true);
                } else {
                    if (_e825 > 0.5f) {
                        phi_1161_ = 1f;
                    } else {
                        phi_1161_ = 0f;
                    }
                    let _e850 = phi_1161_;
                    phi_1163_ = evaluate_Verdict(_e850, false);
                }
                let _e853 = phi_1163_;
                phi_1168_ = evaluate_Verdict(_e853.visibility, _e853.is_doubted);
            } else {
                phi_1168_ = evaluate_Verdict(0.5f, true);
            }
            let _e859 = phi_1168_;
            phi_1169_ = _e859;
        }
        let _e861 = phi_1169_;
        if (_e71.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e71.first_primitive)] = _e861.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
