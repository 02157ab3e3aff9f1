struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
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

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_161_: lt_mask_LightPlace;
    var phi_162_: bool;
    var phi_163_: lt_mask_LightPlace;
    var phi_164_: bool;
    var phi_169_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_161_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_162_ = false;
        } else {
            phi_161_ = lt_mask_LightPlace();
            phi_162_ = true;
        }
        let _e65 = phi_161_;
        let _e67 = phi_162_;
        phi_163_ = _e65;
        phi_164_ = _e67;
    } else {
        phi_163_ = lt_mask_LightPlace();
        phi_164_ = true;
    }
    let _e69 = phi_163_;
    let _e71 = phi_164_;
    if _e71 {
        phi_169_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_169_ = _e69;
    }
    let _e76 = phi_169_;
    return lt_mask_LightPlace(_e76.word, _e76.shift);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_189_: bool;
    var phi_193_: f32;

    let _e53 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_189_ = true;
    } else {
        let _e57 = (84f < _e53);
        if _e57 {
        }
        phi_189_ = _e57;
    }
    let _e59 = phi_189_;
    if _e59 {
        phi_193_ = 84f;
    } else {
        phi_193_ = _e53;
    }
    let _e61 = phi_193_;
    return _e61;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_214_: f32;
    var phi_229_: f32;
    var phi_234_: f32;
    var phi_256_: f32;
    var phi_261_: f32;
    var phi_262_: bool;
    var phi_263_: f32;
    var phi_264_: bool;
    var phi_268_: f32;
    var phi_306_: f32;
    var phi_322_: f32;
    var phi_323_: f32;
    var phi_324_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_214_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_213_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_212_ = 1f;
            } else {
                phi_212_ = param_7;
            }
            let _e61 = phi_212_;
            phi_213_ = _e61;
        }
        let _e63 = phi_213_;
        phi_214_ = _e63;
    }
    let _e65 = phi_214_;
    let _e67 = _lt_math_esm_Esm_clamped_exponent(param_5);
    let _e69 = (_e67 * (1f - _e65));
    if ((bitcast<u32>(_e69) & 2147483647u) > 2139095040u) {
        phi_306_ = _e69;
    } else {
        if (_e69 < -87f) {
            phi_229_ = -87f;
        } else {
            phi_229_ = _e69;
        }
        let _e75 = phi_229_;
        if (_e75 > 88f) {
            phi_234_ = 88f;
        } else {
            phi_234_ = _e75;
        }
        let _e78 = phi_234_;
        let _e80 = ((_e78 * 1.442695f) + 0.5f);
        if (_e80 > -8388608f) {
            let _e92 = f32(select(0i, select(select(i32(_e80), i32(-2147483648), (_e80 < bitcast<f32>(3472883712u))), 2147483647i, (_e80 > bitcast<f32>(1325400063u))), (_e80 == _e80)));
            if (_e92 > _e80) {
                phi_256_ = 1f;
            } else {
                phi_256_ = 0f;
            }
            let _e95 = phi_256_;
            if (_e80 < 8388608f) {
                phi_261_ = (_e92 - _e95);
                phi_262_ = false;
            } else {
                phi_261_ = f32();
                phi_262_ = true;
            }
            let _e98 = phi_261_;
            let _e100 = phi_262_;
            phi_263_ = _e98;
            phi_264_ = _e100;
        } else {
            phi_263_ = f32();
            phi_264_ = true;
        }
        let _e102 = phi_263_;
        let _e104 = phi_264_;
        if _e104 {
            phi_268_ = _e80;
        } else {
            phi_268_ = _e102;
        }
        let _e106 = phi_268_;
        let _e110 = ((_e78 - (_e106 * 0.69314575f)) - (_e106 * 0.0000014286068f));
        phi_306_ = ((((((((((((((((1f / 5040f) * _e110) + (1f / 720f)) * _e110) + (1f / 120f)) * _e110) + (1f / 24f)) * _e110) + (1f / 6f)) * _e110) + 0.5f) * _e110) + 1f) * _e110) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e106), i32(-2147483648), (_e106 < bitcast<f32>(3472883712u))), 2147483647i, (_e106 > bitcast<f32>(1325400063u))), (_e106 == _e106)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e146 = phi_306_;
    let _e147 = (param_6.x * _e146);
    if ((bitcast<u32>(_e147) & 2147483647u) > 2139095040u) {
        phi_324_ = _e147;
    } else {
        if (_e147 < 0f) {
            phi_323_ = 0f;
        } else {
            if (_e147 > 1f) {
                phi_322_ = 1f;
            } else {
                phi_322_ = _e147;
            }
            let _e154 = phi_322_;
            phi_323_ = _e154;
        }
        let _e156 = phi_323_;
        phi_324_ = _e156;
    }
    let _e158 = phi_324_;
    return _e158;
}

fn function_() {
    var local: f32;
    var phi_384_: bool;
    var phi_385_: bool;
    var phi_386_: bool;
    var phi_387_: bool;
    var phi_391_: bool;
    var phi_461_: bool;
    var phi_462_: bool;
    var phi_473_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_474_: bool;
    var phi_475_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_476_: bool;
    var phi_483_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_487_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_507_: lt_math_LightPoint;
    var phi_510_: u32;
    var phi_512_: lt_math_LevelPoint;
    var phi_598_: bool;
    var phi_607_: bool;
    var phi_616_: bool;
    var phi_617_: bool;
    var phi_618_: bool;
    var phi_619_: bool;
    var phi_620_: bool;
    var phi_621_: bool;
    var phi_622_: bool;
    var phi_626_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_664_: bool;
    var phi_673_: lt_math_LightPoint;
    var phi_674_: u32;
    var phi_675_: lt_math_LevelPoint;
    var phi_676_: bool;
    var phi_508_: lt_math_LightPoint;
    var phi_511_: u32;
    var phi_513_: lt_math_LevelPoint;
    var phi_677_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_717_: bool;
    var phi_718_: bool;
    var phi_719_: bool;
    var phi_720_: bool;
    var phi_724_: bool;
    var phi_806_: f32;
    var phi_924_: f32;
    var phi_925_: f32;
    var phi_928_: f32;
    var phi_957_: f32;
    var phi_962_: f32;
    var phi_963_: bool;
    var phi_964_: f32;
    var phi_965_: bool;
    var phi_969_: f32;
    var phi_989_: f32;
    var phi_994_: f32;
    var phi_995_: bool;
    var phi_996_: f32;
    var phi_997_: bool;
    var phi_1001_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1050_: i32;
    var phi_1055_: i32;
    var phi_1060_: i32;
    var phi_1065_: i32;
    var phi_1074_: i32;
    var phi_1079_: i32;
    var phi_1084_: i32;
    var phi_1089_: i32;
    var phi_1184_: bool;
    var phi_1192_: bool;
    var phi_1204_: bool;
    var phi_1205_: bool;
    var phi_1209_: f32;
    var phi_1215_: f32;
    var phi_1217_: evaluate_Verdict;
    var phi_1222_: evaluate_Verdict;
    var phi_1223_: evaluate_Verdict;

    let _e53 = id_1;
    let _e60 = arrayLength((&map.member));
    let _e66 = arrayLength((&levels.member));
    let _e69 = p.member.size[0u];
    let _e71 = p.member.size[1u];
    let _e72 = lt_shaders_entry_pixel_index(_e53, _e69, _e71);
    if (bitcast<i32>(_e72.word) != 0i) {
        let _e78 = p.member.level_count;
        if (_e72.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e85 = samples.member[(0u + _e72.shift)].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[(0u + _e72.shift)].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[(0u + _e72.shift)].normal[2u];
                let _e97 = global[2u];
                phi_384_ = (_e95 == _e97);
                phi_385_ = false;
            } else {
                phi_384_ = bool();
                phi_385_ = true;
            }
            let _e100 = phi_384_;
            let _e102 = phi_385_;
            phi_386_ = _e100;
            phi_387_ = _e102;
        } else {
            phi_386_ = bool();
            phi_387_ = true;
        }
        let _e104 = phi_386_;
        let _e106 = phi_387_;
        if _e106 {
            phi_391_ = false;
        } else {
            phi_391_ = _e104;
        }
        let _e108 = phi_391_;
        if !(_e108) {
            let _e111 = samples.member[(0u + _e72.shift)].position;
            let _e113 = p.member.light.place;
            let _e119 = p.member.light.place[3u];
            let _e126 = (_e113.x - (_e111.x * _e119));
            let _e127 = (_e113.y - (_e111.y * _e119));
            let _e128 = (_e113.z - (_e111.z * _e119));
            let _e130 = samples.member[(0u + _e72.shift)].normal;
            if ((((_e130.x * _e126) + (_e130.y * _e127)) + (_e130.z * _e128)) > 0f) {
                let _e144 = (((_e126 * _e126) + (_e127 * _e127)) + (_e128 * _e128));
                let _e146 = p.member.light.axis;
                let _e158 = p.member.light.place[3u];
                if (_e158 == 0f) {
                    phi_462_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_461_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_461_ = false;
                    }
                    let _e169 = phi_461_;
                    phi_462_ = _e169;
                }
                let _e171 = phi_462_;
                if _e171 {
                    let _e173 = samples.member[(0u + _e72.shift)].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_473_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_474_ = false;
                } else {
                    phi_473_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_474_ = true;
                }
                let _e192 = phi_473_;
                let _e194 = phi_474_;
                phi_475_ = _e192;
                phi_476_ = _e194;
            } else {
                phi_475_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_476_ = true;
            }
            let _e196 = phi_475_;
            let _e198 = phi_476_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_483_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_483_ = _e196;
            }
            let _e215 = phi_483_;
            phi_487_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_487_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_487_;
        if _e232.unnamed_1 {
            phi_1223_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
        } else {
            let _e240 = samples.member[(0u + _e72.shift)].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_507_ = lt_math_LightPoint();
            phi_510_ = 0u;
            phi_512_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_507_;
                let _e271 = phi_510_;
                let _e273 = phi_512_;
                local_1 = _e273;
                local_2 = _e273;
                local_3 = _e273;
                if (_e271 < _e78) {
                    if _e273.point.is_inside {
                        phi_673_ = lt_math_LightPoint();
                        phi_674_ = u32();
                        phi_675_ = lt_math_LevelPoint();
                        phi_676_ = false;
                    } else {
                        if (_e271 < _e66) {
                        } else {
                            return;
                        }
                        let _e284 = levels.member[(0u + _e271)].row_w;
                        let _e295 = ((((_e284.x * _e240.x) + (_e284.y * _e240.y)) + (_e284.z * _e240.z)) + (_e284.w * 1f));
                        let _e297 = levels.member[(0u + _e271)].row_x;
                        let _e309 = (((((_e297.x * _e240.x) + (_e297.y * _e240.y)) + (_e297.z * _e240.z)) + (_e297.w * 1f)) / _e295);
                        let _e311 = levels.member[(0u + _e271)].row_y;
                        let _e323 = (((((_e311.x * _e240.x) + (_e311.y * _e240.y)) + (_e311.z * _e240.z)) + (_e311.w * 1f)) / _e295);
                        let _e325 = levels.member[(0u + _e271)].row_z;
                        let _e336 = ((((_e325.x * _e240.x) + (_e325.y * _e240.y)) + (_e325.z * _e240.z)) + (_e325.w * 1f));
                        if (_e295 > 0f) {
                            if (_e309 >= 0f) {
                                phi_598_ = (_e309 <= 1f);
                            } else {
                                phi_598_ = false;
                            }
                            let _e341 = phi_598_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_607_ = (_e323 <= 1f);
                                } else {
                                    phi_607_ = false;
                                }
                                let _e345 = phi_607_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_616_ = (_e336 <= 1f);
                                    } else {
                                        phi_616_ = false;
                                    }
                                    let _e349 = phi_616_;
                                    phi_617_ = _e349;
                                    phi_618_ = false;
                                } else {
                                    phi_617_ = bool();
                                    phi_618_ = true;
                                }
                                let _e351 = phi_617_;
                                let _e353 = phi_618_;
                                phi_619_ = _e351;
                                phi_620_ = _e353;
                            } else {
                                phi_619_ = bool();
                                phi_620_ = true;
                            }
                            let _e355 = phi_619_;
                            let _e357 = phi_620_;
                            phi_621_ = _e355;
                            phi_622_ = _e357;
                        } else {
                            phi_621_ = bool();
                            phi_622_ = true;
                        }
                        let _e359 = phi_621_;
                        let _e361 = phi_622_;
                        if _e361 {
                            phi_626_ = false;
                        } else {
                            phi_626_ = _e359;
                        }
                        let _e363 = phi_626_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_653_ = (_e323 <= (1f - _e244));
                                        phi_654_ = false;
                                    } else {
                                        phi_653_ = bool();
                                        phi_654_ = true;
                                    }
                                    let _e371 = phi_653_;
                                    let _e373 = phi_654_;
                                    phi_655_ = _e371;
                                    phi_656_ = _e373;
                                } else {
                                    phi_655_ = bool();
                                    phi_656_ = true;
                                }
                                let _e375 = phi_655_;
                                let _e377 = phi_656_;
                                phi_657_ = _e375;
                                phi_658_ = _e377;
                            } else {
                                phi_657_ = bool();
                                phi_658_ = true;
                            }
                            let _e379 = phi_657_;
                            let _e381 = phi_658_;
                            phi_659_ = _e379;
                            phi_660_ = _e381;
                        } else {
                            phi_659_ = bool();
                            phi_660_ = true;
                        }
                        let _e383 = phi_659_;
                        let _e385 = phi_660_;
                        if _e385 {
                            phi_664_ = false;
                        } else {
                            phi_664_ = _e383;
                        }
                        let _e387 = phi_664_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_673_ = _e409;
                        phi_674_ = (_e271 + 1u);
                        phi_675_ = lt_math_LevelPoint(_e271, _e409);
                        phi_676_ = true;
                    }
                    let _e413 = phi_673_;
                    let _e415 = phi_674_;
                    let _e417 = phi_675_;
                    let _e419 = phi_676_;
                    phi_508_ = _e413;
                    phi_511_ = _e415;
                    phi_513_ = _e417;
                    phi_677_ = _e419;
                } else {
                    phi_508_ = lt_math_LightPoint();
                    phi_511_ = u32();
                    phi_513_ = lt_math_LevelPoint();
                    phi_677_ = false;
                }
                let _e421 = phi_508_;
                let _e423 = phi_511_;
                let _e425 = phi_513_;
                let _e427 = phi_677_;
                continue;
                continuing {
                    phi_507_ = _e421;
                    phi_510_ = _e423;
                    phi_512_ = _e425;
                    break if !(_e427);
                }
            }
            let _e430 = local_1;
            if _e430.point.is_inside {
                if (0f > 0f) {
                    let _e436 = local_2;
                    if (_e436.level < _e66) {
                    } else {
                        return;
                    }
                    let _e441 = levels.member[(0u + _e436.level)];
                    let _e447 = global[0u];
                    if (_e441.row_w.x == _e447) {
                        let _e450 = global[1u];
                        if (_e441.row_w.y == _e450) {
                            let _e453 = global[2u];
                            phi_717_ = (_e441.row_w.z == _e453);
                            phi_718_ = false;
                        } else {
                            phi_717_ = bool();
                            phi_718_ = true;
                        }
                        let _e456 = phi_717_;
                        let _e458 = phi_718_;
                        phi_719_ = _e456;
                        phi_720_ = _e458;
                    } else {
                        phi_719_ = bool();
                        phi_720_ = true;
                    }
                    let _e460 = phi_719_;
                    let _e462 = phi_720_;
                    if _e462 {
                        phi_724_ = false;
                    } else {
                        phi_724_ = _e460;
                    }
                    let _e464 = phi_724_;
                    if _e464 {
                        let _e466 = samples.member[(0u + _e72.shift)].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_806_ = _e538;
                        } else {
                            phi_806_ = 0.002f;
                        }
                        let _e541 = phi_806_;
                        phi_925_ = _e541;
                    } else {
                        let _e543 = p.member.map_size;
                        let _e549 = samples.member[(0u + _e72.shift)].position;
                        let _e560 = ((((_e441.row_w.x * _e549.x) + (_e441.row_w.y * _e549.y)) + (_e441.row_w.z * _e549.z)) + _e441.row_w.w);
                        let _e573 = ((_e441.row_x.x - (_e441.row_w.x * _e430.point.uv.x)) / _e560);
                        let _e574 = ((_e441.row_x.y - (_e441.row_w.y * _e430.point.uv.x)) / _e560);
                        let _e575 = ((_e441.row_x.z - (_e441.row_w.z * _e430.point.uv.x)) / _e560);
                        let _e588 = ((_e441.row_y.x - (_e441.row_w.x * _e430.point.uv.y)) / _e560);
                        let _e589 = ((_e441.row_y.y - (_e441.row_w.y * _e430.point.uv.y)) / _e560);
                        let _e590 = ((_e441.row_y.z - (_e441.row_w.z * _e430.point.uv.y)) / _e560);
                        let _e596 = samples.member[(0u + _e72.shift)].normal;
                        let _e601 = ((_e589 * _e596.z) - (_e596.y * _e590));
                        let _e606 = ((_e590 * _e596.x) - (_e596.z * _e588));
                        let _e611 = ((_e588 * _e596.y) - (_e596.x * _e589));
                        let _e613 = samples.member[(0u + _e72.shift)].normal;
                        let _e618 = ((_e574 * _e613.z) - (_e613.y * _e575));
                        let _e623 = ((_e575 * _e613.x) - (_e613.z * _e573));
                        let _e628 = ((_e573 * _e613.y) - (_e613.x * _e574));
                        let _e655 = ((abs(((((_e441.row_z.x * _e601) + (_e441.row_z.y * _e606)) + (_e441.row_z.z * _e611)) / (((_e573 * _e601) + (_e574 * _e606)) + (_e575 * _e611)))) + abs(((((_e441.row_z.x * _e618) + (_e441.row_z.y * _e623)) + (_e441.row_z.z * _e628)) / (((_e588 * _e618) + (_e589 * _e623)) + (_e590 * _e628))))) / f32(_e543));
                        let _e657 = (16f / f32(_e543));
                        if (_e655 < _e657) {
                            phi_924_ = _e655;
                        } else {
                            phi_924_ = _e657;
                        }
                        let _e660 = phi_924_;
                        phi_925_ = _e660;
                    }
                    let _e662 = phi_925_;
                    phi_928_ = (_e430.point.depth - (0f * _e662));
                } else {
                    phi_928_ = _e430.point.depth;
                }
                let _e666 = phi_928_;
                let _e672 = p.member.map_size;
                let _e673 = f32(_e672);
                let _e676 = ((_e430.point.uv.x * _e673) - 0.5f);
                let _e677 = ((_e430.point.uv.y * _e673) - 0.5f);
                if (_e676 > -8388608f) {
                    let _e689 = f32(select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < bitcast<f32>(3472883712u))), 2147483647i, (_e676 > bitcast<f32>(1325400063u))), (_e676 == _e676)));
                    if (_e689 > _e676) {
                        phi_957_ = 1f;
                    } else {
                        phi_957_ = 0f;
                    }
                    let _e692 = phi_957_;
                    if (_e676 < 8388608f) {
                        phi_962_ = (_e689 - _e692);
                        phi_963_ = false;
                    } else {
                        phi_962_ = f32();
                        phi_963_ = true;
                    }
                    let _e695 = phi_962_;
                    let _e697 = phi_963_;
                    phi_964_ = _e695;
                    phi_965_ = _e697;
                } else {
                    phi_964_ = f32();
                    phi_965_ = true;
                }
                let _e699 = phi_964_;
                let _e701 = phi_965_;
                if _e701 {
                    phi_969_ = _e676;
                } else {
                    phi_969_ = _e699;
                }
                let _e703 = phi_969_;
                if (_e677 > -8388608f) {
                    let _e715 = f32(select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < bitcast<f32>(3472883712u))), 2147483647i, (_e677 > bitcast<f32>(1325400063u))), (_e677 == _e677)));
                    if (_e715 > _e677) {
                        phi_989_ = 1f;
                    } else {
                        phi_989_ = 0f;
                    }
                    let _e718 = phi_989_;
                    if (_e677 < 8388608f) {
                        phi_994_ = (_e715 - _e718);
                        phi_995_ = false;
                    } else {
                        phi_994_ = f32();
                        phi_995_ = true;
                    }
                    let _e721 = phi_994_;
                    let _e723 = phi_995_;
                    phi_996_ = _e721;
                    phi_997_ = _e723;
                } else {
                    phi_996_ = f32();
                    phi_997_ = true;
                }
                let _e725 = phi_996_;
                let _e727 = phi_997_;
                if _e727 {
                    phi_1001_ = _e677;
                } else {
                    phi_1001_ = _e725;
                }
                let _e729 = phi_1001_;
                let _e730 = (_e676 - _e703);
                let _e731 = (_e677 - _e729);
                let _e740 = select(0i, select(select(i32(_e703), i32(-2147483648), (_e703 < bitcast<f32>(3472883712u))), 2147483647i, (_e703 > bitcast<f32>(1325400063u))), (_e703 == _e703));
                let _e749 = select(0i, select(select(i32(_e729), i32(-2147483648), (_e729 < bitcast<f32>(3472883712u))), 2147483647i, (_e729 > bitcast<f32>(1325400063u))), (_e729 == _e729));
                let _e752 = ((1f - _e730) * (1f - _e731));
                let _e754 = (_e730 * (1f - _e731));
                let _e756 = ((1f - _e730) * _e731);
                let _e757 = (_e730 * _e731);
                let _e759 = p.member.test;
                let _e760 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e759);
                let _e762 = p.member.map_size;
                let _e764 = local_3;
                local = _e760;
                let _e767 = ((_e764.level * _e762) * _e762);
                let _e769 = (bitcast<i32>(_e762) - 1i);
                if (_e740 > 0i) {
                    phi_1050_ = _e740;
                } else {
                    phi_1050_ = 0i;
                }
                let _e772 = phi_1050_;
                if (_e749 > 0i) {
                    phi_1055_ = _e749;
                } else {
                    phi_1055_ = 0i;
                }
                let _e775 = phi_1055_;
                if (_e772 < _e769) {
                    phi_1060_ = _e772;
                } else {
                    phi_1060_ = _e769;
                }
                let _e778 = phi_1060_;
                if (_e775 < _e769) {
                    phi_1065_ = _e775;
                } else {
                    phi_1065_ = _e769;
                }
                let _e781 = phi_1065_;
                let _e782 = bitcast<u32>(_e778);
                let _e784 = (_e740 + 1i);
                let _e785 = (_e749 + 1i);
                if (_e784 > 0i) {
                    phi_1074_ = _e784;
                } else {
                    phi_1074_ = 0i;
                }
                let _e788 = phi_1074_;
                if (_e785 > 0i) {
                    phi_1079_ = _e785;
                } else {
                    phi_1079_ = 0i;
                }
                let _e791 = phi_1079_;
                if (_e788 < _e769) {
                    phi_1084_ = _e788;
                } else {
                    phi_1084_ = _e769;
                }
                let _e794 = phi_1084_;
                if (_e791 < _e769) {
                    phi_1089_ = _e791;
                } else {
                    phi_1089_ = _e769;
                }
                let _e797 = phi_1089_;
                let _e798 = bitcast<u32>(_e794);
                let _e800 = (bitcast<u32>(_e781) * _e762);
                let _e801 = (bitcast<u32>(_e797) * _e762);
                let _e806 = ((_e800 + _e782) + _e767);
                let _e807 = ((_e800 + _e798) + _e767);
                let _e808 = ((_e801 + _e782) + _e767);
                let _e809 = ((_e801 + _e798) + _e767);
                if (_e806 < _e60) {
                } else {
                    return;
                }
                let _e813 = map.member[(0u + _e806)];
                if (_e807 < _e60) {
                } else {
                    return;
                }
                let _e825 = map.member[(0u + _e807)];
                if (_e808 < _e60) {
                } else {
                    return;
                }
                let _e841 = map.member[(0u + _e808)];
                if (_e809 < _e60) {
                } else {
                    return;
                }
                let _e857 = map.member[(0u + _e809)];
                let _e871 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e813.x * _e752) + (_e825.x * _e754)) + (_e841.x * _e756)) + (_e857.x * _e757)), ((((_e813.y * _e752) + (_e825.y * _e754)) + (_e841.y * _e756)) + (_e857.y * _e757)), ((((_e813.z * _e752) + (_e825.z * _e754)) + (_e841.z * _e756)) + (_e857.z * _e757)), ((((_e813.w * _e752) + (_e825.w * _e754)) + (_e841.w * _e756)) + (_e857.w * _e757))), _e666);
                let _e873 = p.member.epsilon;
                if (_e871 <= _e873) {
                    phi_1184_ = true;
                } else {
                    phi_1184_ = (_e871 >= (1f - _e873));
                }
                let _e878 = phi_1184_;
                if ((bitcast<u32>(_e871) & 2147483647u) > 2139095040u) {
                    phi_1192_ = true;
                } else {
                    phi_1192_ = !(_e878);
                }
                let _e884 = phi_1192_;
                if _e884 {
                    if (_e871 > 0f) {
                        if (_e871 < 1f) {
                            phi_1204_ = false;
                        } else {
                            phi_1204_ = true;
                        }
                        let _e888 = phi_1204_;
                        phi_1205_ = _e888;
                    } else {
                        phi_1205_ = true;
                    }
                    let _e890 = phi_1205_;
                    if _e890 {
                        phi_1209_ = 0.5f;
                    } else {
                        phi_1209_ = _e871;
                    }
                    let _e892 = phi_1209_;
                    phi_1217_ = evaluate_Verdict(_e892, true);
                } else {
                    if (_e871 > 0.5f) {
                        phi_1215_ = 1f;
                    } else {
                        phi_1215_ = 0f;
                    }
                    let _e896 = phi_1215_;
                    phi_1217_ = evaluate_Verdict(_e896, false);
                }
                let _e899 = phi_1217_;
                phi_1222_ = evaluate_Verdict(_e899.visibility, _e899.is_doubted);
            } else {
                phi_1222_ = evaluate_Verdict(0.5f, true);
            }
            let _e905 = phi_1222_;
            phi_1223_ = _e905;
        }
        let _e907 = phi_1223_;
        if (_e72.shift < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.shift)] = _e907.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
