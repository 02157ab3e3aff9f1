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

struct type_10 {
    member: array<abi_Sample>,
}

struct type_14 {
    member: array<u32>,
}

struct type_18 {
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

struct type_39 {
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

struct type_43 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_49 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct type_55 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_5: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_55;
@group(0) @binding(5) 
var<storage> levels: type_49;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_177_: lt_mask_LightPlace;
    var phi_178_: bool;
    var phi_179_: lt_mask_LightPlace;
    var phi_180_: bool;
    var phi_185_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_177_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_178_ = false;
        } else {
            phi_177_ = lt_mask_LightPlace();
            phi_178_ = true;
        }
        let _e69 = phi_177_;
        let _e71 = phi_178_;
        phi_179_ = _e69;
        phi_180_ = _e71;
    } else {
        phi_179_ = lt_mask_LightPlace();
        phi_180_ = true;
    }
    let _e73 = phi_179_;
    let _e75 = phi_180_;
    if _e75 {
        phi_185_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_185_ = _e73;
    }
    let _e80 = phi_185_;
    return lt_mask_LightPlace(_e80.word, _e80.shift);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_205_: bool;
    var phi_209_: f32;

    let _e57 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_205_ = true;
    } else {
        let _e61 = (84f < _e57);
        if _e61 {
        }
        phi_205_ = _e61;
    }
    let _e63 = phi_205_;
    if _e63 {
        phi_209_ = 84f;
    } else {
        phi_209_ = _e57;
    }
    let _e65 = phi_209_;
    return _e65;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_228_: f32;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_245_: f32;
    var phi_250_: f32;
    var phi_272_: f32;
    var phi_277_: f32;
    var phi_278_: bool;
    var phi_279_: f32;
    var phi_280_: bool;
    var phi_284_: f32;
    var phi_322_: f32;
    var phi_338_: f32;
    var phi_339_: f32;
    var phi_340_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_230_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_229_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_228_ = 1f;
            } else {
                phi_228_ = param_7;
            }
            let _e65 = phi_228_;
            phi_229_ = _e65;
        }
        let _e67 = phi_229_;
        phi_230_ = _e67;
    }
    let _e69 = phi_230_;
    let _e71 = _lt_math_esm_Esm_clamped_exponent(param_5);
    let _e73 = (_e71 * (1f - _e69));
    if ((bitcast<u32>(_e73) & 2147483647u) > 2139095040u) {
        phi_322_ = _e73;
    } else {
        if (_e73 < -87f) {
            phi_245_ = -87f;
        } else {
            phi_245_ = _e73;
        }
        let _e79 = phi_245_;
        if (_e79 > 88f) {
            phi_250_ = 88f;
        } else {
            phi_250_ = _e79;
        }
        let _e82 = phi_250_;
        let _e84 = ((_e82 * 1.442695f) + 0.5f);
        if (_e84 > -8388608f) {
            let _e96 = f32(select(0i, select(select(i32(_e84), i32(-2147483648), (_e84 < bitcast<f32>(3472883712u))), 2147483647i, (_e84 > bitcast<f32>(1325400063u))), (_e84 == _e84)));
            if (_e96 > _e84) {
                phi_272_ = 1f;
            } else {
                phi_272_ = 0f;
            }
            let _e99 = phi_272_;
            if (_e84 < 8388608f) {
                phi_277_ = (_e96 - _e99);
                phi_278_ = false;
            } else {
                phi_277_ = f32();
                phi_278_ = true;
            }
            let _e102 = phi_277_;
            let _e104 = phi_278_;
            phi_279_ = _e102;
            phi_280_ = _e104;
        } else {
            phi_279_ = f32();
            phi_280_ = true;
        }
        let _e106 = phi_279_;
        let _e108 = phi_280_;
        if _e108 {
            phi_284_ = _e84;
        } else {
            phi_284_ = _e106;
        }
        let _e110 = phi_284_;
        let _e114 = ((_e82 - (_e110 * 0.69314575f)) - (_e110 * 0.0000014286068f));
        phi_322_ = ((((((((((((((((1f / 5040f) * _e114) + (1f / 720f)) * _e114) + (1f / 120f)) * _e114) + (1f / 24f)) * _e114) + (1f / 6f)) * _e114) + 0.5f) * _e114) + 1f) * _e114) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e110), i32(-2147483648), (_e110 < bitcast<f32>(3472883712u))), 2147483647i, (_e110 > bitcast<f32>(1325400063u))), (_e110 == _e110)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e150 = phi_322_;
    let _e151 = (param_6.x * _e150);
    if ((bitcast<u32>(_e151) & 2147483647u) > 2139095040u) {
        phi_340_ = _e151;
    } else {
        if (_e151 < 0f) {
            phi_339_ = 0f;
        } else {
            if (_e151 > 1f) {
                phi_338_ = 1f;
            } else {
                phi_338_ = _e151;
            }
            let _e158 = phi_338_;
            phi_339_ = _e158;
        }
        let _e160 = phi_339_;
        phi_340_ = _e160;
    }
    let _e162 = phi_340_;
    return _e162;
}

fn function_() {
    var local_1: f32;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_402_: bool;
    var phi_472_: bool;
    var phi_473_: bool;
    var phi_484_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_485_: bool;
    var phi_486_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_487_: bool;
    var phi_494_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_498_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_518_: lt_math_LightPoint;
    var phi_521_: u32;
    var phi_523_: lt_math_LevelPoint;
    var phi_609_: bool;
    var phi_618_: bool;
    var phi_627_: bool;
    var phi_628_: bool;
    var phi_629_: bool;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_633_: bool;
    var phi_637_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_675_: bool;
    var phi_684_: lt_math_LightPoint;
    var phi_685_: u32;
    var phi_686_: lt_math_LevelPoint;
    var phi_687_: bool;
    var phi_519_: lt_math_LightPoint;
    var phi_522_: u32;
    var phi_524_: lt_math_LevelPoint;
    var phi_688_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_728_: bool;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_735_: bool;
    var phi_817_: f32;
    var phi_935_: f32;
    var phi_936_: f32;
    var phi_939_: f32;
    var phi_968_: f32;
    var phi_973_: f32;
    var phi_974_: bool;
    var phi_975_: f32;
    var phi_976_: bool;
    var phi_980_: f32;
    var phi_1000_: f32;
    var phi_1005_: f32;
    var phi_1006_: bool;
    var phi_1007_: f32;
    var phi_1008_: bool;
    var phi_1012_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1061_: i32;
    var phi_1066_: i32;
    var phi_1071_: i32;
    var phi_1076_: i32;
    var phi_1085_: i32;
    var phi_1090_: i32;
    var phi_1095_: i32;
    var phi_1100_: i32;
    var phi_1195_: bool;
    var phi_1203_: bool;
    var phi_1215_: bool;
    var phi_1216_: bool;
    var phi_1220_: f32;
    var phi_1226_: f32;
    var phi_1228_: evaluate_Verdict;
    var phi_1233_: evaluate_Verdict;
    var phi_1234_: evaluate_Verdict;
    var phi_1238_: bool;
    var phi_1239_: u32;
    var phi_1250_: u32;

    let _e57 = id_1;
    let _e58 = local_5;
    let _e63 = arrayLength((&map.member));
    let _e68 = arrayLength((&levels.member));
    let _e71 = p.member.size[0u];
    let _e73 = p.member.size[1u];
    let _e74 = lt_shaders_entry_pixel_index(_e57, _e71, _e73);
    if (bitcast<i32>(_e74.word) != 0i) {
        let _e81 = p.member.level_count;
        let _e85 = samples.member[_e74.shift].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[_e74.shift].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[_e74.shift].normal[2u];
                let _e97 = global[2u];
                phi_395_ = (_e95 == _e97);
                phi_396_ = false;
            } else {
                phi_395_ = bool();
                phi_396_ = true;
            }
            let _e100 = phi_395_;
            let _e102 = phi_396_;
            phi_397_ = _e100;
            phi_398_ = _e102;
        } else {
            phi_397_ = bool();
            phi_398_ = true;
        }
        let _e104 = phi_397_;
        let _e106 = phi_398_;
        if _e106 {
            phi_402_ = false;
        } else {
            phi_402_ = _e104;
        }
        let _e108 = phi_402_;
        if !(_e108) {
            let _e111 = samples.member[_e74.shift].position;
            let _e113 = p.member.light.place;
            let _e119 = p.member.light.place[3u];
            let _e126 = (_e113.x - (_e111.x * _e119));
            let _e127 = (_e113.y - (_e111.y * _e119));
            let _e128 = (_e113.z - (_e111.z * _e119));
            let _e130 = samples.member[_e74.shift].normal;
            if ((((_e130.x * _e126) + (_e130.y * _e127)) + (_e130.z * _e128)) > 0f) {
                let _e144 = (((_e126 * _e126) + (_e127 * _e127)) + (_e128 * _e128));
                let _e146 = p.member.light.axis;
                let _e158 = p.member.light.place[3u];
                if (_e158 == 0f) {
                    phi_473_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_472_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_472_ = false;
                    }
                    let _e169 = phi_472_;
                    phi_473_ = _e169;
                }
                let _e171 = phi_473_;
                if _e171 {
                    let _e173 = samples.member[_e74.shift].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_484_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_485_ = false;
                } else {
                    phi_484_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_485_ = true;
                }
                let _e192 = phi_484_;
                let _e194 = phi_485_;
                phi_486_ = _e192;
                phi_487_ = _e194;
            } else {
                phi_486_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_487_ = true;
            }
            let _e196 = phi_486_;
            let _e198 = phi_487_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_494_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_494_ = _e196;
            }
            let _e215 = phi_494_;
            phi_498_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_498_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_498_;
        if _e232.unnamed_1 {
            phi_1234_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
        } else {
            let _e240 = samples.member[_e74.shift].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_518_ = lt_math_LightPoint();
            phi_521_ = 0u;
            phi_523_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_518_;
                let _e271 = phi_521_;
                let _e273 = phi_523_;
                local_2 = _e273;
                local_3 = _e273;
                local_4 = _e273;
                if (_e271 < _e81) {
                    if _e273.point.is_inside {
                        phi_684_ = lt_math_LightPoint();
                        phi_685_ = u32();
                        phi_686_ = lt_math_LevelPoint();
                        phi_687_ = false;
                    } else {
                        if (_e271 < _e68) {
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
                                phi_609_ = (_e309 <= 1f);
                            } else {
                                phi_609_ = false;
                            }
                            let _e341 = phi_609_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_618_ = (_e323 <= 1f);
                                } else {
                                    phi_618_ = false;
                                }
                                let _e345 = phi_618_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_627_ = (_e336 <= 1f);
                                    } else {
                                        phi_627_ = false;
                                    }
                                    let _e349 = phi_627_;
                                    phi_628_ = _e349;
                                    phi_629_ = false;
                                } else {
                                    phi_628_ = bool();
                                    phi_629_ = true;
                                }
                                let _e351 = phi_628_;
                                let _e353 = phi_629_;
                                phi_630_ = _e351;
                                phi_631_ = _e353;
                            } else {
                                phi_630_ = bool();
                                phi_631_ = true;
                            }
                            let _e355 = phi_630_;
                            let _e357 = phi_631_;
                            phi_632_ = _e355;
                            phi_633_ = _e357;
                        } else {
                            phi_632_ = bool();
                            phi_633_ = true;
                        }
                        let _e359 = phi_632_;
                        let _e361 = phi_633_;
                        if _e361 {
                            phi_637_ = false;
                        } else {
                            phi_637_ = _e359;
                        }
                        let _e363 = phi_637_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_664_ = (_e323 <= (1f - _e244));
                                        phi_665_ = false;
                                    } else {
                                        phi_664_ = bool();
                                        phi_665_ = true;
                                    }
                                    let _e371 = phi_664_;
                                    let _e373 = phi_665_;
                                    phi_666_ = _e371;
                                    phi_667_ = _e373;
                                } else {
                                    phi_666_ = bool();
                                    phi_667_ = true;
                                }
                                let _e375 = phi_666_;
                                let _e377 = phi_667_;
                                phi_668_ = _e375;
                                phi_669_ = _e377;
                            } else {
                                phi_668_ = bool();
                                phi_669_ = true;
                            }
                            let _e379 = phi_668_;
                            let _e381 = phi_669_;
                            phi_670_ = _e379;
                            phi_671_ = _e381;
                        } else {
                            phi_670_ = bool();
                            phi_671_ = true;
                        }
                        let _e383 = phi_670_;
                        let _e385 = phi_671_;
                        if _e385 {
                            phi_675_ = false;
                        } else {
                            phi_675_ = _e383;
                        }
                        let _e387 = phi_675_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_684_ = _e409;
                        phi_685_ = (_e271 + 1u);
                        phi_686_ = lt_math_LevelPoint(_e271, _e409);
                        phi_687_ = true;
                    }
                    let _e413 = phi_684_;
                    let _e415 = phi_685_;
                    let _e417 = phi_686_;
                    let _e419 = phi_687_;
                    phi_519_ = _e413;
                    phi_522_ = _e415;
                    phi_524_ = _e417;
                    phi_688_ = _e419;
                } else {
                    phi_519_ = lt_math_LightPoint();
                    phi_522_ = u32();
                    phi_524_ = lt_math_LevelPoint();
                    phi_688_ = false;
                }
                let _e421 = phi_519_;
                let _e423 = phi_522_;
                let _e425 = phi_524_;
                let _e427 = phi_688_;
                continue;
                continuing {
                    phi_518_ = _e421;
                    phi_521_ = _e423;
                    phi_523_ = _e425;
                    break if !(_e427);
                }
            }
            let _e430 = local_2;
            if _e430.point.is_inside {
                if (0f > 0f) {
                    let _e436 = local_3;
                    if (_e436.level < _e68) {
                    } else {
                        return;
                    }
                    let _e441 = levels.member[(0u + _e436.level)];
                    let _e447 = global[0u];
                    if (_e441.row_w.x == _e447) {
                        let _e450 = global[1u];
                        if (_e441.row_w.y == _e450) {
                            let _e453 = global[2u];
                            phi_728_ = (_e441.row_w.z == _e453);
                            phi_729_ = false;
                        } else {
                            phi_728_ = bool();
                            phi_729_ = true;
                        }
                        let _e456 = phi_728_;
                        let _e458 = phi_729_;
                        phi_730_ = _e456;
                        phi_731_ = _e458;
                    } else {
                        phi_730_ = bool();
                        phi_731_ = true;
                    }
                    let _e460 = phi_730_;
                    let _e462 = phi_731_;
                    if _e462 {
                        phi_735_ = false;
                    } else {
                        phi_735_ = _e460;
                    }
                    let _e464 = phi_735_;
                    if _e464 {
                        let _e466 = samples.member[_e74.shift].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_817_ = _e538;
                        } else {
                            phi_817_ = 0.002f;
                        }
                        let _e541 = phi_817_;
                        phi_936_ = _e541;
                    } else {
                        let _e543 = p.member.map_size;
                        let _e549 = samples.member[_e74.shift].position;
                        let _e560 = ((((_e441.row_w.x * _e549.x) + (_e441.row_w.y * _e549.y)) + (_e441.row_w.z * _e549.z)) + _e441.row_w.w);
                        let _e573 = ((_e441.row_x.x - (_e441.row_w.x * _e430.point.uv.x)) / _e560);
                        let _e574 = ((_e441.row_x.y - (_e441.row_w.y * _e430.point.uv.x)) / _e560);
                        let _e575 = ((_e441.row_x.z - (_e441.row_w.z * _e430.point.uv.x)) / _e560);
                        let _e588 = ((_e441.row_y.x - (_e441.row_w.x * _e430.point.uv.y)) / _e560);
                        let _e589 = ((_e441.row_y.y - (_e441.row_w.y * _e430.point.uv.y)) / _e560);
                        let _e590 = ((_e441.row_y.z - (_e441.row_w.z * _e430.point.uv.y)) / _e560);
                        let _e596 = samples.member[_e74.shift].normal;
                        let _e601 = ((_e589 * _e596.z) - (_e596.y * _e590));
                        let _e606 = ((_e590 * _e596.x) - (_e596.z * _e588));
                        let _e611 = ((_e588 * _e596.y) - (_e596.x * _e589));
                        let _e613 = samples.member[_e74.shift].normal;
                        let _e618 = ((_e574 * _e613.z) - (_e613.y * _e575));
                        let _e623 = ((_e575 * _e613.x) - (_e613.z * _e573));
                        let _e628 = ((_e573 * _e613.y) - (_e613.x * _e574));
                        let _e655 = ((abs(((((_e441.row_z.x * _e601) + (_e441.row_z.y * _e606)) + (_e441.row_z.z * _e611)) / (((_e573 * _e601) + (_e574 * _e606)) + (_e575 * _e611)))) + abs(((((_e441.row_z.x * _e618) + (_e441.row_z.y * _e623)) + (_e441.row_z.z * _e628)) / (((_e588 * _e618) + (_e589 * _e623)) + (_e590 * _e628))))) / f32(_e543));
                        let _e657 = (16f / f32(_e543));
                        if (_e655 < _e657) {
                            phi_935_ = _e655;
                        } else {
                            phi_935_ = _e657;
                        }
                        let _e660 = phi_935_;
                        phi_936_ = _e660;
                    }
                    let _e662 = phi_936_;
                    phi_939_ = (_e430.point.depth - (0f * _e662));
                } else {
                    phi_939_ = _e430.point.depth;
                }
                let _e666 = phi_939_;
                let _e672 = p.member.map_size;
                let _e673 = f32(_e672);
                let _e676 = ((_e430.point.uv.x * _e673) - 0.5f);
                let _e677 = ((_e430.point.uv.y * _e673) - 0.5f);
                if (_e676 > -8388608f) {
                    let _e689 = f32(select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < bitcast<f32>(3472883712u))), 2147483647i, (_e676 > bitcast<f32>(1325400063u))), (_e676 == _e676)));
                    if (_e689 > _e676) {
                        phi_968_ = 1f;
                    } else {
                        phi_968_ = 0f;
                    }
                    let _e692 = phi_968_;
                    if (_e676 < 8388608f) {
                        phi_973_ = (_e689 - _e692);
                        phi_974_ = false;
                    } else {
                        phi_973_ = f32();
                        phi_974_ = true;
                    }
                    let _e695 = phi_973_;
                    let _e697 = phi_974_;
                    phi_975_ = _e695;
                    phi_976_ = _e697;
                } else {
                    phi_975_ = f32();
                    phi_976_ = true;
                }
                let _e699 = phi_975_;
                let _e701 = phi_976_;
                if _e701 {
                    phi_980_ = _e676;
                } else {
                    phi_980_ = _e699;
                }
                let _e703 = phi_980_;
                if (_e677 > -8388608f) {
                    let _e715 = f32(select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < bitcast<f32>(3472883712u))), 2147483647i, (_e677 > bitcast<f32>(1325400063u))), (_e677 == _e677)));
                    if (_e715 > _e677) {
                        phi_1000_ = 1f;
                    } else {
                        phi_1000_ = 0f;
                    }
                    let _e718 = phi_1000_;
                    if (_e677 < 8388608f) {
                        phi_1005_ = (_e715 - _e718);
                        phi_1006_ = false;
                    } else {
                        phi_1005_ = f32();
                        phi_1006_ = true;
                    }
                    let _e721 = phi_1005_;
                    let _e723 = phi_1006_;
                    phi_1007_ = _e721;
                    phi_1008_ = _e723;
                } else {
                    phi_1007_ = f32();
                    phi_1008_ = true;
                }
                let _e725 = phi_1007_;
                let _e727 = phi_1008_;
                if _e727 {
                    phi_1012_ = _e677;
                } else {
                    phi_1012_ = _e725;
                }
                let _e729 = phi_1012_;
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
                let _e764 = local_4;
                local_1 = _e760;
                let _e767 = ((_e764.level * _e762) * _e762);
                let _e769 = (bitcast<i32>(_e762) - 1i);
                if (_e740 > 0i) {
                    phi_1061_ = _e740;
                } else {
                    phi_1061_ = 0i;
                }
                let _e772 = phi_1061_;
                if (_e749 > 0i) {
                    phi_1066_ = _e749;
                } else {
                    phi_1066_ = 0i;
                }
                let _e775 = phi_1066_;
                if (_e772 < _e769) {
                    phi_1071_ = _e772;
                } else {
                    phi_1071_ = _e769;
                }
                let _e778 = phi_1071_;
                if (_e775 < _e769) {
                    phi_1076_ = _e775;
                } else {
                    phi_1076_ = _e769;
                }
                let _e781 = phi_1076_;
                let _e782 = bitcast<u32>(_e778);
                let _e784 = (_e740 + 1i);
                let _e785 = (_e749 + 1i);
                if (_e784 > 0i) {
                    phi_1085_ = _e784;
                } else {
                    phi_1085_ = 0i;
                }
                let _e788 = phi_1085_;
                if (_e785 > 0i) {
                    phi_1090_ = _e785;
                } else {
                    phi_1090_ = 0i;
                }
                let _e791 = phi_1090_;
                if (_e788 < _e769) {
                    phi_1095_ = _e788;
                } else {
                    phi_1095_ = _e769;
                }
                let _e794 = phi_1095_;
                if (_e791 < _e769) {
                    phi_1100_ = _e791;
                } else {
                    phi_1100_ = _e769;
                }
                let _e797 = phi_1100_;
                let _e798 = bitcast<u32>(_e794);
                let _e800 = (bitcast<u32>(_e781) * _e762);
                let _e801 = (bitcast<u32>(_e797) * _e762);
                let _e806 = ((_e800 + _e782) + _e767);
                let _e807 = ((_e800 + _e798) + _e767);
                let _e808 = ((_e801 + _e782) + _e767);
                let _e809 = ((_e801 + _e798) + _e767);
                if (_e806 < _e63) {
                } else {
                    return;
                }
                let _e813 = map.member[(0u + _e806)];
                if (_e807 < _e63) {
                } else {
                    return;
                }
                let _e825 = map.member[(0u + _e807)];
                if (_e808 < _e63) {
                } else {
                    return;
                }
                let _e841 = map.member[(0u + _e808)];
                if (_e809 < _e63) {
                } else {
                    return;
                }
                let _e857 = map.member[(0u + _e809)];
                let _e871 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e813.x * _e752) + (_e825.x * _e754)) + (_e841.x * _e756)) + (_e857.x * _e757)), ((((_e813.y * _e752) + (_e825.y * _e754)) + (_e841.y * _e756)) + (_e857.y * _e757)), ((((_e813.z * _e752) + (_e825.z * _e754)) + (_e841.z * _e756)) + (_e857.z * _e757)), ((((_e813.w * _e752) + (_e825.w * _e754)) + (_e841.w * _e756)) + (_e857.w * _e757))), _e666);
                let _e873 = p.member.epsilon;
                if (_e871 <= _e873) {
                    phi_1195_ = true;
                } else {
                    phi_1195_ = (_e871 >= (1f - _e873));
                }
                let _e878 = phi_1195_;
                if ((bitcast<u32>(_e871) & 2147483647u) > 2139095040u) {
                    phi_1203_ = true;
                } else {
                    phi_1203_ = !(_e878);
                }
                let _e884 = phi_1203_;
                if _e884 {
                    if (_e871 > 0f) {
                        if (_e871 < 1f) {
                            phi_1215_ = false;
                        } else {
                            phi_1215_ = true;
                        }
                        let _e888 = phi_1215_;
                        phi_1216_ = _e888;
                    } else {
                        phi_1216_ = true;
                    }
                    let _e890 = phi_1216_;
                    if _e890 {
                        phi_1220_ = 0.5f;
                    } else {
                        phi_1220_ = _e871;
                    }
                    let _e892 = phi_1220_;
                    phi_1228_ = evaluate_Verdict(_e892, true);
                } else {
                    if (_e871 > 0.5f) {
                        phi_1226_ = 1f;
                    } else {
                        phi_1226_ = 0f;
                    }
                    let _e896 = phi_1226_;
                    phi_1228_ = evaluate_Verdict(_e896, false);
                }
                let _e899 = phi_1228_;
                phi_1233_ = evaluate_Verdict(_e899.visibility, _e899.is_doubted);
            } else {
                phi_1233_ = evaluate_Verdict(0.5f, true);
            }
            let _e905 = phi_1233_;
            phi_1234_ = _e905;
        }
        let _e907 = phi_1234_;
        visibility.member[_e74.shift] = _e907.visibility;
        phi_1238_ = _e907.is_doubted;
        phi_1239_ = _e74.shift;
    } else {
        phi_1238_ = false;
        phi_1239_ = 0u;
    }
    let _e912 = phi_1238_;
    let _e914 = phi_1239_;
    if (_e58 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e912 {
        let _e918 = atomicAdd((&shared_[0u]), 1u);
        phi_1250_ = _e918;
    } else {
        phi_1250_ = 0u;
    }
    let _e920 = phi_1250_;
    workgroupBarrier();
    if (_e58 == 0u) {
        let _e924 = atomicLoad((&shared_[0u]));
        let _e925 = atomicAdd((&list.member[3u]), _e924);
        atomicStore((&shared_[1u]), _e925);
    }
    workgroupBarrier();
    if _e912 {
        let _e928 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e928) + _e920)]), _e914);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
