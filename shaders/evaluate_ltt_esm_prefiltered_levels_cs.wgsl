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
    var phi_172_: lt_bvh_traverse_Tree;
    var phi_173_: bool;
    var phi_174_: lt_bvh_traverse_Tree;
    var phi_175_: bool;
    var phi_180_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_172_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_173_ = false;
        } else {
            phi_172_ = lt_bvh_traverse_Tree();
            phi_173_ = true;
        }
        let _e68 = phi_172_;
        let _e70 = phi_173_;
        phi_174_ = _e68;
        phi_175_ = _e70;
    } else {
        phi_174_ = lt_bvh_traverse_Tree();
        phi_175_ = true;
    }
    let _e72 = phi_174_;
    let _e74 = phi_175_;
    if _e74 {
        phi_180_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_180_ = _e72;
    }
    let _e79 = phi_180_;
    return lt_bvh_traverse_Tree(_e79.root, _e79.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_200_: bool;
    var phi_204_: f32;

    let _e56 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_200_ = true;
    } else {
        let _e60 = (84f < _e56);
        if _e60 {
        }
        phi_200_ = _e60;
    }
    let _e62 = phi_200_;
    if _e62 {
        phi_204_ = 84f;
    } else {
        phi_204_ = _e56;
    }
    let _e64 = phi_204_;
    return _e64;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_225_: f32;
    var phi_240_: f32;
    var phi_245_: f32;
    var phi_267_: f32;
    var phi_272_: f32;
    var phi_273_: bool;
    var phi_274_: f32;
    var phi_275_: bool;
    var phi_279_: f32;
    var phi_317_: f32;
    var phi_333_: f32;
    var phi_334_: f32;
    var phi_335_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_225_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_224_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_223_ = 1f;
            } else {
                phi_223_ = param_7;
            }
            let _e64 = phi_223_;
            phi_224_ = _e64;
        }
        let _e66 = phi_224_;
        phi_225_ = _e66;
    }
    let _e68 = phi_225_;
    let _e70 = _lt_math_esm_Esm_clamped_exponent(param_5);
    let _e72 = (_e70 * (1f - _e68));
    if ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u) {
        phi_317_ = _e72;
    } else {
        if (_e72 < -87f) {
            phi_240_ = -87f;
        } else {
            phi_240_ = _e72;
        }
        let _e78 = phi_240_;
        if (_e78 > 88f) {
            phi_245_ = 88f;
        } else {
            phi_245_ = _e78;
        }
        let _e81 = phi_245_;
        let _e83 = ((_e81 * 1.442695f) + 0.5f);
        if (_e83 > -8388608f) {
            let _e95 = f32(select(0i, select(select(i32(_e83), i32(-2147483648), (_e83 < bitcast<f32>(3472883712u))), 2147483647i, (_e83 > bitcast<f32>(1325400063u))), (_e83 == _e83)));
            if (_e95 > _e83) {
                phi_267_ = 1f;
            } else {
                phi_267_ = 0f;
            }
            let _e98 = phi_267_;
            if (_e83 < 8388608f) {
                phi_272_ = (_e95 - _e98);
                phi_273_ = false;
            } else {
                phi_272_ = f32();
                phi_273_ = true;
            }
            let _e101 = phi_272_;
            let _e103 = phi_273_;
            phi_274_ = _e101;
            phi_275_ = _e103;
        } else {
            phi_274_ = f32();
            phi_275_ = true;
        }
        let _e105 = phi_274_;
        let _e107 = phi_275_;
        if _e107 {
            phi_279_ = _e83;
        } else {
            phi_279_ = _e105;
        }
        let _e109 = phi_279_;
        let _e113 = ((_e81 - (_e109 * 0.69314575f)) - (_e109 * 0.0000014286068f));
        phi_317_ = ((((((((((((((((1f / 5040f) * _e113) + (1f / 720f)) * _e113) + (1f / 120f)) * _e113) + (1f / 24f)) * _e113) + (1f / 6f)) * _e113) + 0.5f) * _e113) + 1f) * _e113) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e109), i32(-2147483648), (_e109 < bitcast<f32>(3472883712u))), 2147483647i, (_e109 > bitcast<f32>(1325400063u))), (_e109 == _e109)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e149 = phi_317_;
    let _e150 = (param_6.x * _e149);
    if ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u) {
        phi_335_ = _e150;
    } else {
        if (_e150 < 0f) {
            phi_334_ = 0f;
        } else {
            if (_e150 > 1f) {
                phi_333_ = 1f;
            } else {
                phi_333_ = _e150;
            }
            let _e157 = phi_333_;
            phi_334_ = _e157;
        }
        let _e159 = phi_334_;
        phi_335_ = _e159;
    }
    let _e161 = phi_335_;
    return _e161;
}

fn function_() {
    var local_1: f32;
    var phi_391_: bool;
    var phi_392_: bool;
    var phi_393_: bool;
    var phi_394_: bool;
    var phi_398_: bool;
    var phi_442_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_446_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_466_: lt_math_LightPoint;
    var phi_469_: u32;
    var phi_471_: lt_math_LevelPoint;
    var phi_557_: bool;
    var phi_566_: bool;
    var phi_575_: bool;
    var phi_576_: bool;
    var phi_577_: bool;
    var phi_578_: bool;
    var phi_579_: bool;
    var phi_580_: bool;
    var phi_581_: bool;
    var phi_585_: bool;
    var phi_612_: bool;
    var phi_613_: bool;
    var phi_614_: bool;
    var phi_615_: bool;
    var phi_616_: bool;
    var phi_617_: bool;
    var phi_618_: bool;
    var phi_619_: bool;
    var phi_623_: bool;
    var phi_632_: lt_math_LightPoint;
    var phi_633_: u32;
    var phi_634_: lt_math_LevelPoint;
    var phi_635_: bool;
    var phi_467_: lt_math_LightPoint;
    var phi_470_: u32;
    var phi_472_: lt_math_LevelPoint;
    var phi_636_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_678_: bool;
    var phi_679_: bool;
    var phi_683_: bool;
    var phi_765_: f32;
    var phi_881_: f32;
    var phi_882_: f32;
    var phi_885_: f32;
    var phi_914_: f32;
    var phi_919_: f32;
    var phi_920_: bool;
    var phi_921_: f32;
    var phi_922_: bool;
    var phi_926_: f32;
    var phi_946_: f32;
    var phi_951_: f32;
    var phi_952_: bool;
    var phi_953_: f32;
    var phi_954_: bool;
    var phi_958_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1007_: i32;
    var phi_1012_: i32;
    var phi_1017_: i32;
    var phi_1022_: i32;
    var phi_1031_: i32;
    var phi_1036_: i32;
    var phi_1041_: i32;
    var phi_1046_: i32;
    var phi_1141_: bool;
    var phi_1149_: bool;
    var phi_1161_: bool;
    var phi_1162_: bool;
    var phi_1166_: f32;
    var phi_1172_: f32;
    var phi_1174_: evaluate_Verdict;
    var phi_1179_: evaluate_Verdict;
    var phi_1180_: evaluate_Verdict;
    var phi_1184_: bool;
    var phi_1185_: u32;
    var phi_1196_: u32;

    let _e56 = id_1;
    let _e57 = local_5;
    let _e62 = arrayLength((&map.member));
    let _e67 = arrayLength((&levels.member));
    let _e70 = p.member.size[0u];
    let _e72 = p.member.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e56, _e70, _e72);
    if (bitcast<i32>(_e73.root) != 0i) {
        let _e80 = p.member.level_count;
        let _e82 = p.member.light;
        let _e85 = samples.member[_e73.first_primitive].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[_e73.first_primitive].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[_e73.first_primitive].normal[2u];
                let _e97 = global[2u];
                phi_391_ = (_e95 == _e97);
                phi_392_ = false;
            } else {
                phi_391_ = bool();
                phi_392_ = true;
            }
            let _e100 = phi_391_;
            let _e102 = phi_392_;
            phi_393_ = _e100;
            phi_394_ = _e102;
        } else {
            phi_393_ = bool();
            phi_394_ = true;
        }
        let _e104 = phi_393_;
        let _e106 = phi_394_;
        if _e106 {
            phi_398_ = false;
        } else {
            phi_398_ = _e104;
        }
        let _e108 = phi_398_;
        if !(_e108) {
            let _e111 = samples.member[_e73.first_primitive].normal;
            let _e113 = samples.member[_e73.first_primitive].position;
            if ((((_e111.x * (_e82.x - (_e113.x * _e82.w))) + (_e111.y * (_e82.y - (_e113.y * _e82.w)))) + (_e111.z * (_e82.z - (_e113.z * _e82.w)))) > 0f) {
                let _e137 = samples.member[_e73.first_primitive].flags;
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e145.unnamed.visibility, false), _e145.unnamed_1);
                phi_442_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e151.unnamed, ((_e137 & 1u) == 0u));
            } else {
                let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e160.unnamed.visibility, false), _e160.unnamed_1);
                phi_442_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e166.unnamed, true);
            }
            let _e171 = phi_442_;
            phi_446_ = _e171;
        } else {
            let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e177.unnamed.visibility, false), _e177.unnamed_1);
            phi_446_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e183.unnamed, true);
        }
        let _e188 = phi_446_;
        if _e188.unnamed_1 {
            phi_1180_ = evaluate_Verdict(_e188.unnamed.visibility, _e188.unnamed.is_doubted);
        } else {
            let _e196 = samples.member[_e73.first_primitive].position;
            let _e198 = p.member.map_size;
            let _e200 = (0.5f / f32(_e198));
            let _e207 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e214 = lt_math_LightPoint(vec2<f32>(_e207.uv.x, 0f), _e207.depth, _e207.is_inside);
            let _e218 = lt_math_LightPoint(_e214.uv, 0f, _e214.is_inside);
            phi_466_ = lt_math_LightPoint();
            phi_469_ = 0u;
            phi_471_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e218.uv, _e218.depth, false));
            loop {
                let _e225 = phi_466_;
                let _e227 = phi_469_;
                let _e229 = phi_471_;
                local_2 = _e229;
                local_3 = _e229;
                local_4 = _e229;
                if (_e227 < _e80) {
                    if _e229.point.is_inside {
                        phi_632_ = lt_math_LightPoint();
                        phi_633_ = u32();
                        phi_634_ = lt_math_LevelPoint();
                        phi_635_ = false;
                    } else {
                        if (_e227 < _e67) {
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
                                phi_557_ = (_e265 <= 1f);
                            } else {
                                phi_557_ = false;
                            }
                            let _e297 = phi_557_;
                            if _e297 {
                                if (_e279 >= 0f) {
                                    phi_566_ = (_e279 <= 1f);
                                } else {
                                    phi_566_ = false;
                                }
                                let _e301 = phi_566_;
                                if _e301 {
                                    if (_e292 >= 0f) {
                                        phi_575_ = (_e292 <= 1f);
                                    } else {
                                        phi_575_ = false;
                                    }
                                    let _e305 = phi_575_;
                                    phi_576_ = _e305;
                                    phi_577_ = false;
                                } else {
                                    phi_576_ = bool();
                                    phi_577_ = true;
                                }
                                let _e307 = phi_576_;
                                let _e309 = phi_577_;
                                phi_578_ = _e307;
                                phi_579_ = _e309;
                            } else {
                                phi_578_ = bool();
                                phi_579_ = true;
                            }
                            let _e311 = phi_578_;
                            let _e313 = phi_579_;
                            phi_580_ = _e311;
                            phi_581_ = _e313;
                        } else {
                            phi_580_ = bool();
                            phi_581_ = true;
                        }
                        let _e315 = phi_580_;
                        let _e317 = phi_581_;
                        if _e317 {
                            phi_585_ = false;
                        } else {
                            phi_585_ = _e315;
                        }
                        let _e319 = phi_585_;
                        if _e319 {
                            if (_e265 >= _e200) {
                                if (_e265 <= (1f - _e200)) {
                                    if (_e279 >= _e200) {
                                        phi_612_ = (_e279 <= (1f - _e200));
                                        phi_613_ = false;
                                    } else {
                                        phi_612_ = bool();
                                        phi_613_ = true;
                                    }
                                    let _e327 = phi_612_;
                                    let _e329 = phi_613_;
                                    phi_614_ = _e327;
                                    phi_615_ = _e329;
                                } else {
                                    phi_614_ = bool();
                                    phi_615_ = true;
                                }
                                let _e331 = phi_614_;
                                let _e333 = phi_615_;
                                phi_616_ = _e331;
                                phi_617_ = _e333;
                            } else {
                                phi_616_ = bool();
                                phi_617_ = true;
                            }
                            let _e335 = phi_616_;
                            let _e337 = phi_617_;
                            phi_618_ = _e335;
                            phi_619_ = _e337;
                        } else {
                            phi_618_ = bool();
                            phi_619_ = true;
                        }
                        let _e339 = phi_618_;
                        let _e341 = phi_619_;
                        if _e341 {
                            phi_623_ = false;
                        } else {
                            phi_623_ = _e339;
                        }
                        let _e343 = phi_623_;
                        let _e350 = lt_math_LightPoint(vec2<f32>(_e265, _e225.uv.y), _e225.depth, _e225.is_inside);
                        let _e357 = lt_math_LightPoint(vec2<f32>(_e350.uv.x, _e279), _e350.depth, _e350.is_inside);
                        let _e361 = lt_math_LightPoint(_e357.uv, _e292, _e357.is_inside);
                        let _e365 = lt_math_LightPoint(_e361.uv, _e361.depth, _e343);
                        phi_632_ = _e365;
                        phi_633_ = (_e227 + 1u);
                        phi_634_ = lt_math_LevelPoint(_e227, _e365);
                        phi_635_ = true;
                    }
                    let _e369 = phi_632_;
                    let _e371 = phi_633_;
                    let _e373 = phi_634_;
                    let _e375 = phi_635_;
                    phi_467_ = _e369;
                    phi_470_ = _e371;
                    phi_472_ = _e373;
                    phi_636_ = _e375;
                } else {
                    phi_467_ = lt_math_LightPoint();
                    phi_470_ = u32();
                    phi_472_ = lt_math_LevelPoint();
                    phi_636_ = false;
                }
                let _e377 = phi_467_;
                let _e379 = phi_470_;
                let _e381 = phi_472_;
                let _e383 = phi_636_;
                continue;
                continuing {
                    phi_466_ = _e377;
                    phi_469_ = _e379;
                    phi_471_ = _e381;
                    break if !(_e383);
                }
            }
            let _e386 = local_2;
            if _e386.point.is_inside {
                if (0f > 0f) {
                    let _e392 = local_3;
                    if (_e392.level < _e67) {
                    } else {
                        return;
                    }
                    let _e397 = levels.member[(0u + _e392.level)];
                    let _e403 = global[0u];
                    if (_e397.row_w.x == _e403) {
                        let _e406 = global[1u];
                        if (_e397.row_w.y == _e406) {
                            let _e409 = global[2u];
                            phi_676_ = (_e397.row_w.z == _e409);
                            phi_677_ = false;
                        } else {
                            phi_676_ = bool();
                            phi_677_ = true;
                        }
                        let _e412 = phi_676_;
                        let _e414 = phi_677_;
                        phi_678_ = _e412;
                        phi_679_ = _e414;
                    } else {
                        phi_678_ = bool();
                        phi_679_ = true;
                    }
                    let _e416 = phi_678_;
                    let _e418 = phi_679_;
                    if _e418 {
                        phi_683_ = false;
                    } else {
                        phi_683_ = _e416;
                    }
                    let _e420 = phi_683_;
                    if _e420 {
                        let _e422 = samples.member[_e73.first_primitive].normal;
                        let _e424 = p.member.map_size;
                        let _e494 = ((abs(((((_e397.row_x.x * _e422.x) + (_e397.row_x.y * _e422.y)) + (_e397.row_x.z * _e422.z)) / (((_e397.row_x.x * _e397.row_x.x) + (_e397.row_x.y * _e397.row_x.y)) + (_e397.row_x.z * _e397.row_x.z)))) + abs(((((_e397.row_y.x * _e422.x) + (_e397.row_y.y * _e422.y)) + (_e397.row_y.z * _e422.z)) / (((_e397.row_y.x * _e397.row_y.x) + (_e397.row_y.y * _e397.row_y.y)) + (_e397.row_y.z * _e397.row_y.z))))) / (abs(((((_e397.row_z.x * _e422.x) + (_e397.row_z.y * _e422.y)) + (_e397.row_z.z * _e422.z)) / (((_e397.row_z.x * _e397.row_z.x) + (_e397.row_z.y * _e397.row_z.y)) + (_e397.row_z.z * _e397.row_z.z)))) * f32(_e424)));
                        if (_e494 < 0.002f) {
                            phi_765_ = _e494;
                        } else {
                            phi_765_ = 0.002f;
                        }
                        let _e497 = phi_765_;
                        phi_882_ = _e497;
                    } else {
                        let _e499 = p.member.map_size;
                        let _e505 = samples.member[_e73.first_primitive].position;
                        let _e516 = ((((_e397.row_w.x * _e505.x) + (_e397.row_w.y * _e505.y)) + (_e397.row_w.z * _e505.z)) + _e397.row_w.w);
                        let _e529 = ((_e397.row_x.x - (_e397.row_w.x * _e386.point.uv.x)) / _e516);
                        let _e530 = ((_e397.row_x.y - (_e397.row_w.y * _e386.point.uv.x)) / _e516);
                        let _e531 = ((_e397.row_x.z - (_e397.row_w.z * _e386.point.uv.x)) / _e516);
                        let _e544 = ((_e397.row_y.x - (_e397.row_w.x * _e386.point.uv.y)) / _e516);
                        let _e545 = ((_e397.row_y.y - (_e397.row_w.y * _e386.point.uv.y)) / _e516);
                        let _e546 = ((_e397.row_y.z - (_e397.row_w.z * _e386.point.uv.y)) / _e516);
                        let _e552 = samples.member[_e73.first_primitive].normal;
                        let _e557 = ((_e545 * _e552.z) - (_e552.y * _e546));
                        let _e562 = ((_e546 * _e552.x) - (_e552.z * _e544));
                        let _e567 = ((_e544 * _e552.y) - (_e552.x * _e545));
                        let _e569 = samples.member[_e73.first_primitive].normal;
                        let _e574 = ((_e530 * _e569.z) - (_e569.y * _e531));
                        let _e579 = ((_e531 * _e569.x) - (_e569.z * _e529));
                        let _e584 = ((_e529 * _e569.y) - (_e569.x * _e530));
                        let _e611 = ((abs(((((_e397.row_z.x * _e557) + (_e397.row_z.y * _e562)) + (_e397.row_z.z * _e567)) / (((_e529 * _e557) + (_e530 * _e562)) + (_e531 * _e567)))) + abs(((((_e397.row_z.x * _e574) + (_e397.row_z.y * _e579)) + (_e397.row_z.z * _e584)) / (((_e544 * _e574) + (_e545 * _e579)) + (_e546 * _e584))))) / f32(_e499));
                        if (_e611 < 0.002f) {
                            phi_881_ = _e611;
                        } else {
                            phi_881_ = 0.002f;
                        }
                        let _e614 = phi_881_;
                        phi_882_ = _e614;
                    }
                    let _e616 = phi_882_;
                    phi_885_ = (_e386.point.depth - (0f * _e616));
                } else {
                    phi_885_ = _e386.point.depth;
                }
                let _e620 = phi_885_;
                let _e626 = p.member.map_size;
                let _e627 = f32(_e626);
                let _e630 = ((_e386.point.uv.x * _e627) - 0.5f);
                let _e631 = ((_e386.point.uv.y * _e627) - 0.5f);
                if (_e630 > -8388608f) {
                    let _e643 = f32(select(0i, select(select(i32(_e630), i32(-2147483648), (_e630 < bitcast<f32>(3472883712u))), 2147483647i, (_e630 > bitcast<f32>(1325400063u))), (_e630 == _e630)));
                    if (_e643 > _e630) {
                        phi_914_ = 1f;
                    } else {
                        phi_914_ = 0f;
                    }
                    let _e646 = phi_914_;
                    if (_e630 < 8388608f) {
                        phi_919_ = (_e643 - _e646);
                        phi_920_ = false;
                    } else {
                        phi_919_ = f32();
                        phi_920_ = true;
                    }
                    let _e649 = phi_919_;
                    let _e651 = phi_920_;
                    phi_921_ = _e649;
                    phi_922_ = _e651;
                } else {
                    phi_921_ = f32();
                    phi_922_ = true;
                }
                let _e653 = phi_921_;
                let _e655 = phi_922_;
                if _e655 {
                    phi_926_ = _e630;
                } else {
                    phi_926_ = _e653;
                }
                let _e657 = phi_926_;
                if (_e631 > -8388608f) {
                    let _e669 = f32(select(0i, select(select(i32(_e631), i32(-2147483648), (_e631 < bitcast<f32>(3472883712u))), 2147483647i, (_e631 > bitcast<f32>(1325400063u))), (_e631 == _e631)));
                    if (_e669 > _e631) {
                        phi_946_ = 1f;
                    } else {
                        phi_946_ = 0f;
                    }
                    let _e672 = phi_946_;
                    if (_e631 < 8388608f) {
                        phi_951_ = (_e669 - _e672);
                        phi_952_ = false;
                    } else {
                        phi_951_ = f32();
                        phi_952_ = true;
                    }
                    let _e675 = phi_951_;
                    let _e677 = phi_952_;
                    phi_953_ = _e675;
                    phi_954_ = _e677;
                } else {
                    phi_953_ = f32();
                    phi_954_ = true;
                }
                let _e679 = phi_953_;
                let _e681 = phi_954_;
                if _e681 {
                    phi_958_ = _e631;
                } else {
                    phi_958_ = _e679;
                }
                let _e683 = phi_958_;
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
                let _e718 = local_4;
                local_1 = _e714;
                let _e721 = ((_e718.level * _e716) * _e716);
                let _e723 = (bitcast<i32>(_e716) - 1i);
                if (_e694 > 0i) {
                    phi_1007_ = _e694;
                } else {
                    phi_1007_ = 0i;
                }
                let _e726 = phi_1007_;
                if (_e703 > 0i) {
                    phi_1012_ = _e703;
                } else {
                    phi_1012_ = 0i;
                }
                let _e729 = phi_1012_;
                if (_e726 < _e723) {
                    phi_1017_ = _e726;
                } else {
                    phi_1017_ = _e723;
                }
                let _e732 = phi_1017_;
                if (_e729 < _e723) {
                    phi_1022_ = _e729;
                } else {
                    phi_1022_ = _e723;
                }
                let _e735 = phi_1022_;
                let _e736 = bitcast<u32>(_e732);
                let _e738 = (_e694 + 1i);
                let _e739 = (_e703 + 1i);
                if (_e738 > 0i) {
                    phi_1031_ = _e738;
                } else {
                    phi_1031_ = 0i;
                }
                let _e742 = phi_1031_;
                if (_e739 > 0i) {
                    phi_1036_ = _e739;
                } else {
                    phi_1036_ = 0i;
                }
                let _e745 = phi_1036_;
                if (_e742 < _e723) {
                    phi_1041_ = _e742;
                } else {
                    phi_1041_ = _e723;
                }
                let _e748 = phi_1041_;
                if (_e745 < _e723) {
                    phi_1046_ = _e745;
                } else {
                    phi_1046_ = _e723;
                }
                let _e751 = phi_1046_;
                let _e752 = bitcast<u32>(_e748);
                let _e754 = (bitcast<u32>(_e735) * _e716);
                let _e755 = (bitcast<u32>(_e751) * _e716);
                let _e760 = ((_e754 + _e736) + _e721);
                let _e761 = ((_e754 + _e752) + _e721);
                let _e762 = ((_e755 + _e736) + _e721);
                let _e763 = ((_e755 + _e752) + _e721);
                if (_e760 < _e62) {
                } else {
                    return;
                }
                let _e767 = map.member[(0u + _e760)];
                if (_e761 < _e62) {
                } else {
                    return;
                }
                let _e779 = map.member[(0u + _e761)];
                if (_e762 < _e62) {
                } else {
                    return;
                }
                let _e795 = map.member[(0u + _e762)];
                if (_e763 < _e62) {
                } else {
                    return;
                }
                let _e811 = map.member[(0u + _e763)];
                let _e825 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e767.x * _e706) + (_e779.x * _e708)) + (_e795.x * _e710)) + (_e811.x * _e711)), ((((_e767.y * _e706) + (_e779.y * _e708)) + (_e795.y * _e710)) + (_e811.y * _e711)), ((((_e767.z * _e706) + (_e779.z * _e708)) + (_e795.z * _e710)) + (_e811.z * _e711)), ((((_e767.w * _e706) + (_e779.w * _e708)) + (_e795.w * _e710)) + (_e811.w * _e711))), _e620);
                let _e827 = p.member.epsilon;
                if (_e825 <= _e827) {
                    phi_1141_ = true;
                } else {
                    phi_1141_ = (_e825 >= (1f - _e827));
                }
                let _e832 = phi_1141_;
                if ((bitcast<u32>(_e825) & 2147483647u) > 2139095040u) {
                    phi_1149_ = true;
                } else {
                    phi_1149_ = !(_e832);
                }
                let _e838 = phi_1149_;
                if _e838 {
                    if (_e825 > 0f) {
                        if (_e825 < 1f) {
                            phi_1161_ = false;
                        } else {
                            phi_1161_ = true;
                        }
                        let _e842 = phi_1161_;
                        phi_1162_ = _e842;
                    } else {
                        phi_1162_ = true;
                    }
                    let _e844 = phi_1162_;
                    if _e844 {
                        phi_1166_ = 0.5f;
                    } else {
                        phi_1166_ = _e825;
                    }
                    let _e846 = phi_1166_;
                    phi_1174_ = evaluate_Verdict(_e846, true);
                } else {
                    if (_e825 > 0.5f) {
                        phi_1172_ = 1f;
                    } else {
                        phi_1172_ = 0f;
                    }
                    let _e850 = phi_1172_;
                    phi_1174_ = evaluate_Verdict(_e850, false);
                }
                let _e853 = phi_1174_;
                phi_1179_ = evaluate_Verdict(_e853.visibility, _e853.is_doubted);
            } else {
                phi_1179_ = evaluate_Verdict(0.5f, true);
            }
            let _e859 = phi_1179_;
            phi_1180_ = _e859;
        }
        let _e861 = phi_1180_;
        visibility.member[_e73.first_primitive] = _e861.visibility;
        phi_1184_ = _e861.is_doubted;
        phi_1185_ = _e73.first_primitive;
    } else {
        phi_1184_ = false;
        phi_1185_ = 0u;
    }
    let _e866 = phi_1184_;
    let _e868 = phi_1185_;
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e866 {
        let _e872 = atomicAdd((&shared_[0u]), 1u);
        phi_1196_ = _e872;
    } else {
        phi_1196_ = 0u;
    }
    let _e874 = phi_1196_;
    workgroupBarrier();
    if (_e57 == 0u) {
        let _e878 = atomicLoad((&shared_[0u]));
        let _e879 = atomicAdd((&list.member[3u]), _e878);
        atomicStore((&shared_[1u]), _e879);
    }
    workgroupBarrier();
    if _e866 {
        let _e882 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e882) + _e874)]), _e868);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
