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
    var phi_158_: lt_bvh_traverse_Tree;
    var phi_159_: bool;
    var phi_160_: lt_bvh_traverse_Tree;
    var phi_161_: bool;
    var phi_166_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_158_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_159_ = false;
        } else {
            phi_158_ = lt_bvh_traverse_Tree();
            phi_159_ = true;
        }
        let _e65 = phi_158_;
        let _e67 = phi_159_;
        phi_160_ = _e65;
        phi_161_ = _e67;
    } else {
        phi_160_ = lt_bvh_traverse_Tree();
        phi_161_ = true;
    }
    let _e69 = phi_160_;
    let _e71 = phi_161_;
    if _e71 {
        phi_166_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_166_ = _e69;
    }
    let _e76 = phi_166_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_186_: bool;
    var phi_190_: f32;

    let _e53 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_186_ = true;
    } else {
        let _e57 = (84f < _e53);
        if _e57 {
        }
        phi_186_ = _e57;
    }
    let _e59 = phi_186_;
    if _e59 {
        phi_190_ = 84f;
    } else {
        phi_190_ = _e53;
    }
    let _e61 = phi_190_;
    return _e61;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_5: f32, param_6: f32) -> f32 {
    var phi_198_: f32;

    if (param_5 < param_6) {
        phi_198_ = param_5;
    } else {
        phi_198_ = param_6;
    }
    let _e56 = phi_198_;
    return _e56;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_7: ptr<function, f32>, param_8: vec4<f32>, param_9: f32) -> f32 {
    var phi_217_: f32;
    var phi_218_: f32;
    var phi_219_: f32;
    var phi_234_: f32;
    var phi_239_: f32;
    var phi_261_: f32;
    var phi_266_: f32;
    var phi_267_: bool;
    var phi_268_: f32;
    var phi_269_: bool;
    var phi_273_: f32;
    var phi_311_: f32;
    var phi_327_: f32;
    var phi_328_: f32;
    var phi_329_: f32;

    if ((bitcast<u32>(param_9) & 2147483647u) > 2139095040u) {
        phi_219_ = param_9;
    } else {
        if (param_9 < 0f) {
            phi_218_ = 0f;
        } else {
            if (param_9 > 1f) {
                phi_217_ = 1f;
            } else {
                phi_217_ = param_9;
            }
            let _e61 = phi_217_;
            phi_218_ = _e61;
        }
        let _e63 = phi_218_;
        phi_219_ = _e63;
    }
    let _e65 = phi_219_;
    let _e67 = _lt_math_esm_Esm_clamped_exponent(param_7);
    let _e69 = (_e67 * (1f - _e65));
    if ((bitcast<u32>(_e69) & 2147483647u) > 2139095040u) {
        phi_311_ = _e69;
    } else {
        if (_e69 < -87f) {
            phi_234_ = -87f;
        } else {
            phi_234_ = _e69;
        }
        let _e75 = phi_234_;
        if (_e75 > 88f) {
            phi_239_ = 88f;
        } else {
            phi_239_ = _e75;
        }
        let _e78 = phi_239_;
        let _e80 = ((_e78 * 1.442695f) + 0.5f);
        if (_e80 > -8388608f) {
            let _e92 = f32(select(0i, select(select(i32(_e80), i32(-2147483648), (_e80 < bitcast<f32>(3472883712u))), 2147483647i, (_e80 > bitcast<f32>(1325400063u))), (_e80 == _e80)));
            if (_e92 > _e80) {
                phi_261_ = 1f;
            } else {
                phi_261_ = 0f;
            }
            let _e95 = phi_261_;
            if (_e80 < 8388608f) {
                phi_266_ = (_e92 - _e95);
                phi_267_ = false;
            } else {
                phi_266_ = f32();
                phi_267_ = true;
            }
            let _e98 = phi_266_;
            let _e100 = phi_267_;
            phi_268_ = _e98;
            phi_269_ = _e100;
        } else {
            phi_268_ = f32();
            phi_269_ = true;
        }
        let _e102 = phi_268_;
        let _e104 = phi_269_;
        if _e104 {
            phi_273_ = _e80;
        } else {
            phi_273_ = _e102;
        }
        let _e106 = phi_273_;
        let _e110 = ((_e78 - (_e106 * 0.69314575f)) - (_e106 * 0.0000014286068f));
        phi_311_ = ((((((((((((((((1f / 5040f) * _e110) + (1f / 720f)) * _e110) + (1f / 120f)) * _e110) + (1f / 24f)) * _e110) + (1f / 6f)) * _e110) + 0.5f) * _e110) + 1f) * _e110) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e106), i32(-2147483648), (_e106 < bitcast<f32>(3472883712u))), 2147483647i, (_e106 > bitcast<f32>(1325400063u))), (_e106 == _e106)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e146 = phi_311_;
    let _e147 = (param_8.x * _e146);
    if ((bitcast<u32>(_e147) & 2147483647u) > 2139095040u) {
        phi_329_ = _e147;
    } else {
        if (_e147 < 0f) {
            phi_328_ = 0f;
        } else {
            if (_e147 > 1f) {
                phi_327_ = 1f;
            } else {
                phi_327_ = _e147;
            }
            let _e154 = phi_327_;
            phi_328_ = _e154;
        }
        let _e156 = phi_328_;
        phi_329_ = _e156;
    }
    let _e158 = phi_329_;
    return _e158;
}

fn function_() {
    var local: f32;
    var phi_390_: bool;
    var phi_391_: bool;
    var phi_392_: bool;
    var phi_393_: bool;
    var phi_397_: bool;
    var phi_441_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_445_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_465_: lt_math_LightPoint;
    var phi_468_: u32;
    var phi_470_: lt_math_LevelPoint;
    var phi_556_: bool;
    var phi_565_: bool;
    var phi_574_: bool;
    var phi_575_: bool;
    var phi_576_: bool;
    var phi_577_: bool;
    var phi_578_: bool;
    var phi_579_: bool;
    var phi_580_: bool;
    var phi_584_: bool;
    var phi_611_: bool;
    var phi_612_: bool;
    var phi_613_: bool;
    var phi_614_: bool;
    var phi_615_: bool;
    var phi_616_: bool;
    var phi_617_: bool;
    var phi_618_: bool;
    var phi_622_: bool;
    var phi_631_: lt_math_LightPoint;
    var phi_632_: u32;
    var phi_633_: lt_math_LevelPoint;
    var phi_634_: bool;
    var phi_466_: lt_math_LightPoint;
    var phi_469_: u32;
    var phi_471_: lt_math_LevelPoint;
    var phi_635_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_675_: bool;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_678_: bool;
    var phi_682_: bool;
    var phi_764_: f32;
    var phi_880_: f32;
    var phi_881_: f32;
    var phi_884_: f32;
    var phi_913_: f32;
    var phi_918_: f32;
    var phi_919_: bool;
    var phi_920_: f32;
    var phi_921_: bool;
    var phi_925_: f32;
    var phi_945_: f32;
    var phi_950_: f32;
    var phi_951_: bool;
    var phi_952_: f32;
    var phi_953_: bool;
    var phi_957_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1006_: i32;
    var phi_1011_: i32;
    var phi_1016_: i32;
    var phi_1021_: i32;
    var phi_1030_: i32;
    var phi_1035_: i32;
    var phi_1040_: i32;
    var phi_1045_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1161_: f32;
    var phi_1163_: evaluate_Verdict;
    var phi_1164_: bool;
    var phi_1165_: evaluate_Verdict;
    var phi_1166_: bool;
    var phi_1171_: evaluate_Verdict;
    var phi_1172_: bool;
    var phi_1174_: evaluate_Verdict;
    var phi_1175_: evaluate_Verdict;
    var phi_1176_: bool;
    var phi_1180_: evaluate_Verdict;
    var phi_1181_: evaluate_Verdict;
    var phi_1182_: bool;
    var phi_1186_: evaluate_Verdict;

    let _e53 = id_1;
    let _e60 = arrayLength((&map.member));
    let _e66 = arrayLength((&levels.member));
    let _e69 = p.member.size[0u];
    let _e71 = p.member.size[1u];
    let _e72 = lt_shaders_entry_pixel_index(_e53, _e69, _e71);
    if (bitcast<i32>(_e72.root) != 0i) {
        let _e78 = p.member.level_count;
        if (_e72.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e83 = p.member.light;
        let _e86 = samples.member[(0u + _e72.first_primitive)].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[(0u + _e72.first_primitive)].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[(0u + _e72.first_primitive)].normal[2u];
                let _e98 = global[2u];
                phi_390_ = (_e96 == _e98);
                phi_391_ = false;
            } else {
                phi_390_ = bool();
                phi_391_ = true;
            }
            let _e101 = phi_390_;
            let _e103 = phi_391_;
            phi_392_ = _e101;
            phi_393_ = _e103;
        } else {
            phi_392_ = bool();
            phi_393_ = true;
        }
        let _e105 = phi_392_;
        let _e107 = phi_393_;
        if _e107 {
            phi_397_ = false;
        } else {
            phi_397_ = _e105;
        }
        let _e109 = phi_397_;
        if !(_e109) {
            let _e112 = samples.member[(0u + _e72.first_primitive)].normal;
            let _e114 = samples.member[(0u + _e72.first_primitive)].position;
            if ((((_e112.x * (_e83.x - (_e114.x * _e83.w))) + (_e112.y * (_e83.y - (_e114.y * _e83.w)))) + (_e112.z * (_e83.z - (_e114.z * _e83.w)))) > 0f) {
                let _e138 = samples.member[(0u + _e72.first_primitive)].flags;
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e146.unnamed.visibility, false), _e146.unnamed_1);
                phi_441_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e152.unnamed, ((_e138 & 1u) == 0u));
            } else {
                let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e161.unnamed.visibility, false), _e161.unnamed_1);
                phi_441_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e167.unnamed, true);
            }
            let _e172 = phi_441_;
            phi_445_ = _e172;
        } else {
            let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e178.unnamed.visibility, false), _e178.unnamed_1);
            phi_445_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e184.unnamed, true);
        }
        let _e189 = phi_445_;
        if _e189.unnamed_1 {
            phi_1180_ = evaluate_Verdict(_e189.unnamed.visibility, _e189.unnamed.is_doubted);
            phi_1181_ = evaluate_Verdict();
            phi_1182_ = true;
        } else {
            let _e197 = samples.member[(0u + _e72.first_primitive)].position;
            let _e199 = p.member.map_size;
            let _e201 = (0.5f / f32(_e199));
            let _e208 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e215 = lt_math_LightPoint(vec2<f32>(_e208.uv.x, 0f), _e208.depth, _e208.is_inside);
            let _e219 = lt_math_LightPoint(_e215.uv, 0f, _e215.is_inside);
            phi_465_ = lt_math_LightPoint();
            phi_468_ = 0u;
            phi_470_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e219.uv, _e219.depth, false));
            loop {
                let _e226 = phi_465_;
                let _e228 = phi_468_;
                let _e230 = phi_470_;
                local_1 = _e230;
                local_2 = _e230;
                local_3 = _e230;
                local_4 = _e230;
                if (_e228 < _e78) {
                    if _e230.point.is_inside {
                        phi_631_ = lt_math_LightPoint();
                        phi_632_ = u32();
                        phi_633_ = lt_math_LevelPoint();
                        phi_634_ = false;
                    } else {
                        if (_e228 < _e66) {
                        } else {
                            return;
                        }
                        let _e241 = levels.member[(0u + _e228)].row_w;
                        let _e252 = ((((_e241.x * _e197.x) + (_e241.y * _e197.y)) + (_e241.z * _e197.z)) + (_e241.w * 1f));
                        let _e254 = levels.member[(0u + _e228)].row_x;
                        let _e266 = (((((_e254.x * _e197.x) + (_e254.y * _e197.y)) + (_e254.z * _e197.z)) + (_e254.w * 1f)) / _e252);
                        let _e268 = levels.member[(0u + _e228)].row_y;
                        let _e280 = (((((_e268.x * _e197.x) + (_e268.y * _e197.y)) + (_e268.z * _e197.z)) + (_e268.w * 1f)) / _e252);
                        let _e282 = levels.member[(0u + _e228)].row_z;
                        let _e293 = ((((_e282.x * _e197.x) + (_e282.y * _e197.y)) + (_e282.z * _e197.z)) + (_e282.w * 1f));
                        if (_e252 > 0f) {
                            if (_e266 >= 0f) {
                                phi_556_ = (_e266 <= 1f);
                            } else {
                                phi_556_ = false;
                            }
                            let _e298 = phi_556_;
                            if _e298 {
                                if (_e280 >= 0f) {
                                    phi_565_ = (_e280 <= 1f);
                                } else {
                                    phi_565_ = false;
                                }
                                let _e302 = phi_565_;
                                if _e302 {
                                    if (_e293 >= 0f) {
                                        phi_574_ = (_e293 <= 1f);
                                    } else {
                                        phi_574_ = false;
                                    }
                                    let _e306 = phi_574_;
                                    phi_575_ = _e306;
                                    phi_576_ = false;
                                } else {
                                    phi_575_ = bool();
                                    phi_576_ = true;
                                }
                                let _e308 = phi_575_;
                                let _e310 = phi_576_;
                                phi_577_ = _e308;
                                phi_578_ = _e310;
                            } else {
                                phi_577_ = bool();
                                phi_578_ = true;
                            }
                            let _e312 = phi_577_;
                            let _e314 = phi_578_;
                            phi_579_ = _e312;
                            phi_580_ = _e314;
                        } else {
                            phi_579_ = bool();
                            phi_580_ = true;
                        }
                        let _e316 = phi_579_;
                        let _e318 = phi_580_;
                        if _e318 {
                            phi_584_ = false;
                        } else {
                            phi_584_ = _e316;
                        }
                        let _e320 = phi_584_;
                        if _e320 {
                            if (_e266 >= _e201) {
                                if (_e266 <= (1f - _e201)) {
                                    if (_e280 >= _e201) {
                                        phi_611_ = (_e280 <= (1f - _e201));
                                        phi_612_ = false;
                                    } else {
                                        phi_611_ = bool();
                                        phi_612_ = true;
                                    }
                                    let _e328 = phi_611_;
                                    let _e330 = phi_612_;
                                    phi_613_ = _e328;
                                    phi_614_ = _e330;
                                } else {
                                    phi_613_ = bool();
                                    phi_614_ = true;
                                }
                                let _e332 = phi_613_;
                                let _e334 = phi_614_;
                                phi_615_ = _e332;
                                phi_616_ = _e334;
                            } else {
                                phi_615_ = bool();
                                phi_616_ = true;
                            }
                            let _e336 = phi_615_;
                            let _e338 = phi_616_;
                            phi_617_ = _e336;
                            phi_618_ = _e338;
                        } else {
                            phi_617_ = bool();
                            phi_618_ = true;
                        }
                        let _e340 = phi_617_;
                        let _e342 = phi_618_;
                        if _e342 {
                            phi_622_ = false;
                        } else {
                            phi_622_ = _e340;
                        }
                        let _e344 = phi_622_;
                        let _e351 = lt_math_LightPoint(vec2<f32>(_e266, _e226.uv.y), _e226.depth, _e226.is_inside);
                        let _e358 = lt_math_LightPoint(vec2<f32>(_e351.uv.x, _e280), _e351.depth, _e351.is_inside);
                        let _e362 = lt_math_LightPoint(_e358.uv, _e293, _e358.is_inside);
                        let _e366 = lt_math_LightPoint(_e362.uv, _e362.depth, _e344);
                        phi_631_ = _e366;
                        phi_632_ = (_e228 + 1u);
                        phi_633_ = lt_math_LevelPoint(_e228, _e366);
                        phi_634_ = true;
                    }
                    let _e370 = phi_631_;
                    let _e372 = phi_632_;
                    let _e374 = phi_633_;
                    let _e376 = phi_634_;
                    phi_466_ = _e370;
                    phi_469_ = _e372;
                    phi_471_ = _e374;
                    phi_635_ = _e376;
                } else {
                    phi_466_ = lt_math_LightPoint();
                    phi_469_ = u32();
                    phi_471_ = lt_math_LevelPoint();
                    phi_635_ = false;
                }
                let _e378 = phi_466_;
                let _e380 = phi_469_;
                let _e382 = phi_471_;
                let _e384 = phi_635_;
                continue;
                continuing {
                    phi_465_ = _e378;
                    phi_468_ = _e380;
                    phi_470_ = _e382;
                    break if !(_e384);
                }
            }
            let _e387 = local_1;
            if _e387.point.is_inside {
                if (0f > 0f) {
                    let _e393 = local_2;
                    if (_e393.level < _e66) {
                    } else {
                        return;
                    }
                    let _e398 = levels.member[(0u + _e393.level)];
                    let _e404 = global[0u];
                    if (_e398.row_w.x == _e404) {
                        let _e407 = global[1u];
                        if (_e398.row_w.y == _e407) {
                            let _e410 = global[2u];
                            phi_675_ = (_e398.row_w.z == _e410);
                            phi_676_ = false;
                        } else {
                            phi_675_ = bool();
                            phi_676_ = true;
                        }
                        let _e413 = phi_675_;
                        let _e415 = phi_676_;
                        phi_677_ = _e413;
                        phi_678_ = _e415;
                    } else {
                        phi_677_ = bool();
                        phi_678_ = true;
                    }
                    let _e417 = phi_677_;
                    let _e419 = phi_678_;
                    if _e419 {
                        phi_682_ = false;
                    } else {
                        phi_682_ = _e417;
                    }
                    let _e421 = phi_682_;
                    if _e421 {
                        let _e423 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e425 = p.member.map_size;
                        let _e495 = ((abs(((((_e398.row_x.x * _e423.x) + (_e398.row_x.y * _e423.y)) + (_e398.row_x.z * _e423.z)) / (((_e398.row_x.x * _e398.row_x.x) + (_e398.row_x.y * _e398.row_x.y)) + (_e398.row_x.z * _e398.row_x.z)))) + abs(((((_e398.row_y.x * _e423.x) + (_e398.row_y.y * _e423.y)) + (_e398.row_y.z * _e423.z)) / (((_e398.row_y.x * _e398.row_y.x) + (_e398.row_y.y * _e398.row_y.y)) + (_e398.row_y.z * _e398.row_y.z))))) / (abs(((((_e398.row_z.x * _e423.x) + (_e398.row_z.y * _e423.y)) + (_e398.row_z.z * _e423.z)) / (((_e398.row_z.x * _e398.row_z.x) + (_e398.row_z.y * _e398.row_z.y)) + (_e398.row_z.z * _e398.row_z.z)))) * f32(_e425)));
                        if (_e495 < 0.002f) {
                            phi_764_ = _e495;
                        } else {
                            phi_764_ = 0.002f;
                        }
                        let _e498 = phi_764_;
                        phi_881_ = _e498;
                    } else {
                        let _e500 = p.member.map_size;
                        let _e506 = samples.member[(0u + _e72.first_primitive)].position;
                        let _e517 = ((((_e398.row_w.x * _e506.x) + (_e398.row_w.y * _e506.y)) + (_e398.row_w.z * _e506.z)) + _e398.row_w.w);
                        let _e530 = ((_e398.row_x.x - (_e398.row_w.x * _e387.point.uv.x)) / _e517);
                        let _e531 = ((_e398.row_x.y - (_e398.row_w.y * _e387.point.uv.x)) / _e517);
                        let _e532 = ((_e398.row_x.z - (_e398.row_w.z * _e387.point.uv.x)) / _e517);
                        let _e545 = ((_e398.row_y.x - (_e398.row_w.x * _e387.point.uv.y)) / _e517);
                        let _e546 = ((_e398.row_y.y - (_e398.row_w.y * _e387.point.uv.y)) / _e517);
                        let _e547 = ((_e398.row_y.z - (_e398.row_w.z * _e387.point.uv.y)) / _e517);
                        let _e553 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e558 = ((_e546 * _e553.z) - (_e553.y * _e547));
                        let _e563 = ((_e547 * _e553.x) - (_e553.z * _e545));
                        let _e568 = ((_e545 * _e553.y) - (_e553.x * _e546));
                        let _e570 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e575 = ((_e531 * _e570.z) - (_e570.y * _e532));
                        let _e580 = ((_e532 * _e570.x) - (_e570.z * _e530));
                        let _e585 = ((_e530 * _e570.y) - (_e570.x * _e531));
                        let _e612 = ((abs(((((_e398.row_z.x * _e558) + (_e398.row_z.y * _e563)) + (_e398.row_z.z * _e568)) / (((_e530 * _e558) + (_e531 * _e563)) + (_e532 * _e568)))) + abs(((((_e398.row_z.x * _e575) + (_e398.row_z.y * _e580)) + (_e398.row_z.z * _e585)) / (((_e545 * _e575) + (_e546 * _e580)) + (_e547 * _e585))))) / f32(_e500));
                        if (_e612 < 0.002f) {
                            phi_880_ = _e612;
                        } else {
                            phi_880_ = 0.002f;
                        }
                        let _e615 = phi_880_;
                        phi_881_ = _e615;
                    }
                    let _e617 = phi_881_;
                    phi_884_ = (_e387.point.depth - (0f * _e617));
                } else {
                    phi_884_ = _e387.point.depth;
                }
                let _e621 = phi_884_;
                let _e627 = p.member.map_size;
                let _e628 = f32(_e627);
                let _e631 = ((_e387.point.uv.x * _e628) - 0.5f);
                let _e632 = ((_e387.point.uv.y * _e628) - 0.5f);
                if (_e631 > -8388608f) {
                    let _e644 = f32(select(0i, select(select(i32(_e631), i32(-2147483648), (_e631 < bitcast<f32>(3472883712u))), 2147483647i, (_e631 > bitcast<f32>(1325400063u))), (_e631 == _e631)));
                    if (_e644 > _e631) {
                        phi_913_ = 1f;
                    } else {
                        phi_913_ = 0f;
                    }
                    let _e647 = phi_913_;
                    if (_e631 < 8388608f) {
                        phi_918_ = (_e644 - _e647);
                        phi_919_ = false;
                    } else {
                        phi_918_ = f32();
                        phi_919_ = true;
                    }
                    let _e650 = phi_918_;
                    let _e652 = phi_919_;
                    phi_920_ = _e650;
                    phi_921_ = _e652;
                } else {
                    phi_920_ = f32();
                    phi_921_ = true;
                }
                let _e654 = phi_920_;
                let _e656 = phi_921_;
                if _e656 {
                    phi_925_ = _e631;
                } else {
                    phi_925_ = _e654;
                }
                let _e658 = phi_925_;
                if (_e632 > -8388608f) {
                    let _e670 = f32(select(0i, select(select(i32(_e632), i32(-2147483648), (_e632 < bitcast<f32>(3472883712u))), 2147483647i, (_e632 > bitcast<f32>(1325400063u))), (_e632 == _e632)));
                    if (_e670 > _e632) {
                        phi_945_ = 1f;
                    } else {
                        phi_945_ = 0f;
                    }
                    let _e673 = phi_945_;
                    if (_e632 < 8388608f) {
                        phi_950_ = (_e670 - _e673);
                        phi_951_ = false;
                    } else {
                        phi_950_ = f32();
                        phi_951_ = true;
                    }
                    let _e676 = phi_950_;
                    let _e678 = phi_951_;
                    phi_952_ = _e676;
                    phi_953_ = _e678;
                } else {
                    phi_952_ = f32();
                    phi_953_ = true;
                }
                let _e680 = phi_952_;
                let _e682 = phi_953_;
                if _e682 {
                    phi_957_ = _e632;
                } else {
                    phi_957_ = _e680;
                }
                let _e684 = phi_957_;
                let _e685 = (_e631 - _e658);
                let _e686 = (_e632 - _e684);
                let _e695 = select(0i, select(select(i32(_e658), i32(-2147483648), (_e658 < bitcast<f32>(3472883712u))), 2147483647i, (_e658 > bitcast<f32>(1325400063u))), (_e658 == _e658));
                let _e704 = select(0i, select(select(i32(_e684), i32(-2147483648), (_e684 < bitcast<f32>(3472883712u))), 2147483647i, (_e684 > bitcast<f32>(1325400063u))), (_e684 == _e684));
                let _e707 = ((1f - _e685) * (1f - _e686));
                let _e709 = (_e685 * (1f - _e686));
                let _e711 = ((1f - _e685) * _e686);
                let _e712 = (_e685 * _e686);
                let _e714 = p.member.test;
                let _e715 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e714);
                let _e717 = p.member.map_size;
                let _e719 = local_3;
                local = _e715;
                let _e722 = ((_e719.level * _e717) * _e717);
                let _e724 = (bitcast<i32>(_e717) - 1i);
                if (_e695 > 0i) {
                    phi_1006_ = _e695;
                } else {
                    phi_1006_ = 0i;
                }
                let _e727 = phi_1006_;
                if (_e704 > 0i) {
                    phi_1011_ = _e704;
                } else {
                    phi_1011_ = 0i;
                }
                let _e730 = phi_1011_;
                if (_e727 < _e724) {
                    phi_1016_ = _e727;
                } else {
                    phi_1016_ = _e724;
                }
                let _e733 = phi_1016_;
                if (_e730 < _e724) {
                    phi_1021_ = _e730;
                } else {
                    phi_1021_ = _e724;
                }
                let _e736 = phi_1021_;
                let _e737 = bitcast<u32>(_e733);
                let _e739 = (_e695 + 1i);
                let _e740 = (_e704 + 1i);
                if (_e739 > 0i) {
                    phi_1030_ = _e739;
                } else {
                    phi_1030_ = 0i;
                }
                let _e743 = phi_1030_;
                if (_e740 > 0i) {
                    phi_1035_ = _e740;
                } else {
                    phi_1035_ = 0i;
                }
                let _e746 = phi_1035_;
                if (_e743 < _e724) {
                    phi_1040_ = _e743;
                } else {
                    phi_1040_ = _e724;
                }
                let _e749 = phi_1040_;
                if (_e746 < _e724) {
                    phi_1045_ = _e746;
                } else {
                    phi_1045_ = _e724;
                }
                let _e752 = phi_1045_;
                let _e753 = bitcast<u32>(_e749);
                let _e755 = (bitcast<u32>(_e736) * _e717);
                let _e756 = (bitcast<u32>(_e752) * _e717);
                let _e761 = ((_e755 + _e737) + _e722);
                let _e762 = ((_e755 + _e753) + _e722);
                let _e763 = ((_e756 + _e737) + _e722);
                let _e764 = ((_e756 + _e753) + _e722);
                if (_e761 < _e60) {
                } else {
                    return;
                }
                let _e768 = map.member[(0u + _e761)];
                if (_e762 < _e60) {
                } else {
                    return;
                }
                let _e780 = map.member[(0u + _e762)];
                if (_e763 < _e60) {
                } else {
                    return;
                }
                let _e796 = map.member[(0u + _e763)];
                if (_e764 < _e60) {
                } else {
                    return;
                }
                let _e812 = map.member[(0u + _e764)];
                let _e826 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e768.x * _e707) + (_e780.x * _e709)) + (_e796.x * _e711)) + (_e812.x * _e712)), ((((_e768.y * _e707) + (_e780.y * _e709)) + (_e796.y * _e711)) + (_e812.y * _e712)), ((((_e768.z * _e707) + (_e780.z * _e709)) + (_e796.z * _e711)) + (_e812.z * _e712)), ((((_e768.w * _e707) + (_e780.w * _e709)) + (_e796.w * _e711)) + (_e812.w * _e712))), _e621);
                let _e828 = p.member.fade_uv;
                if (_e828 > 0f) {
                    let _e831 = local_4;
                    if ((_e831.level + 1u) == _e78) {
                        let _e840 = p.member.fade_uv;
                        let _e842 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e387.point.uv.x, (1f - _e387.point.uv.x));
                        let _e844 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e387.point.uv.y, (1f - _e387.point.uv.y));
                        let _e845 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e842, _e844);
                        if (_e845 < _e840) {
                            phi_1161_ = (1f - ((1f - _e826) * (_e845 / _e840)));
                        } else {
                            phi_1161_ = _e826;
                        }
                        let _e852 = phi_1161_;
                        phi_1163_ = evaluate_Verdict(_e852, false);
                        phi_1164_ = false;
                    } else {
                        phi_1163_ = evaluate_Verdict();
                        phi_1164_ = true;
                    }
                    let _e855 = phi_1163_;
                    let _e857 = phi_1164_;
                    phi_1165_ = _e855;
                    phi_1166_ = _e857;
                } else {
                    phi_1165_ = evaluate_Verdict();
                    phi_1166_ = true;
                }
                let _e859 = phi_1165_;
                let _e861 = phi_1166_;
                if _e861 {
                    phi_1171_ = evaluate_Verdict(_e826, false);
                    phi_1172_ = false;
                } else {
                    phi_1171_ = evaluate_Verdict();
                    phi_1172_ = true;
                }
                let _e864 = phi_1171_;
                let _e866 = phi_1172_;
                phi_1174_ = _e864;
                phi_1175_ = _e859;
                phi_1176_ = _e866;
            } else {
                phi_1174_ = evaluate_Verdict();
                phi_1175_ = evaluate_Verdict(1f, false);
                phi_1176_ = true;
            }
            let _e869 = phi_1174_;
            let _e871 = phi_1175_;
            let _e873 = phi_1176_;
            if _e873 {
            }
            phi_1180_ = _e871;
            phi_1181_ = _e869;
            phi_1182_ = _e873;
        }
        let _e875 = phi_1180_;
        let _e877 = phi_1181_;
        let _e879 = phi_1182_;
        if _e879 {
            phi_1186_ = _e875;
        } else {
            phi_1186_ = _e877;
        }
        let _e881 = phi_1186_;
        if (_e72.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.first_primitive)] = _e881.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
