struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
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
    fade_uv: f32,
    pad0_: u32,
}

struct type_36 {
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
var<uniform> p: type_36;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_41;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_164_: lt_bvh_traverse_Tree;
    var phi_165_: bool;
    var phi_170_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_162_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_163_ = false;
        } else {
            phi_162_ = lt_bvh_traverse_Tree();
            phi_163_ = true;
        }
        let _e65 = phi_162_;
        let _e67 = phi_163_;
        phi_164_ = _e65;
        phi_165_ = _e67;
    } else {
        phi_164_ = lt_bvh_traverse_Tree();
        phi_165_ = true;
    }
    let _e69 = phi_164_;
    let _e71 = phi_165_;
    if _e71 {
        phi_170_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_170_ = _e69;
    }
    let _e76 = phi_170_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_190_: bool;
    var phi_194_: f32;

    let _e53 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_190_ = true;
    } else {
        let _e57 = (84f < _e53);
        if _e57 {
        }
        phi_190_ = _e57;
    }
    let _e59 = phi_190_;
    if _e59 {
        phi_194_ = 84f;
    } else {
        phi_194_ = _e53;
    }
    let _e61 = phi_194_;
    return _e61;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_5: f32, param_6: f32) -> f32 {
    var phi_202_: f32;

    if (param_5 < param_6) {
        phi_202_ = param_5;
    } else {
        phi_202_ = param_6;
    }
    let _e56 = phi_202_;
    return _e56;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_7: ptr<function, f32>, param_8: vec4<f32>, param_9: f32) -> f32 {
    var phi_221_: f32;
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_238_: f32;
    var phi_243_: f32;
    var phi_265_: f32;
    var phi_270_: f32;
    var phi_271_: bool;
    var phi_272_: f32;
    var phi_273_: bool;
    var phi_277_: f32;
    var phi_315_: f32;
    var phi_331_: f32;
    var phi_332_: f32;
    var phi_333_: f32;

    if ((bitcast<u32>(param_9) & 2147483647u) > 2139095040u) {
        phi_223_ = param_9;
    } else {
        if (param_9 < 0f) {
            phi_222_ = 0f;
        } else {
            if (param_9 > 1f) {
                phi_221_ = 1f;
            } else {
                phi_221_ = param_9;
            }
            let _e61 = phi_221_;
            phi_222_ = _e61;
        }
        let _e63 = phi_222_;
        phi_223_ = _e63;
    }
    let _e65 = phi_223_;
    let _e67 = _lt_math_esm_Esm_clamped_exponent(param_7);
    let _e69 = (_e67 * (1f - _e65));
    if ((bitcast<u32>(_e69) & 2147483647u) > 2139095040u) {
        phi_315_ = _e69;
    } else {
        if (_e69 < -87f) {
            phi_238_ = -87f;
        } else {
            phi_238_ = _e69;
        }
        let _e75 = phi_238_;
        if (_e75 > 88f) {
            phi_243_ = 88f;
        } else {
            phi_243_ = _e75;
        }
        let _e78 = phi_243_;
        let _e80 = ((_e78 * 1.442695f) + 0.5f);
        if (_e80 > -8388608f) {
            let _e92 = f32(select(0i, select(select(i32(_e80), i32(-2147483648), (_e80 < bitcast<f32>(3472883712u))), 2147483647i, (_e80 > bitcast<f32>(1325400063u))), (_e80 == _e80)));
            if (_e92 > _e80) {
                phi_265_ = 1f;
            } else {
                phi_265_ = 0f;
            }
            let _e95 = phi_265_;
            if (_e80 < 8388608f) {
                phi_270_ = (_e92 - _e95);
                phi_271_ = false;
            } else {
                phi_270_ = f32();
                phi_271_ = true;
            }
            let _e98 = phi_270_;
            let _e100 = phi_271_;
            phi_272_ = _e98;
            phi_273_ = _e100;
        } else {
            phi_272_ = f32();
            phi_273_ = true;
        }
        let _e102 = phi_272_;
        let _e104 = phi_273_;
        if _e104 {
            phi_277_ = _e80;
        } else {
            phi_277_ = _e102;
        }
        let _e106 = phi_277_;
        let _e110 = ((_e78 - (_e106 * 0.69314575f)) - (_e106 * 0.0000014286068f));
        phi_315_ = ((((((((((((((((1f / 5040f) * _e110) + (1f / 720f)) * _e110) + (1f / 120f)) * _e110) + (1f / 24f)) * _e110) + (1f / 6f)) * _e110) + 0.5f) * _e110) + 1f) * _e110) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e106), i32(-2147483648), (_e106 < bitcast<f32>(3472883712u))), 2147483647i, (_e106 > bitcast<f32>(1325400063u))), (_e106 == _e106)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e146 = phi_315_;
    let _e147 = (param_8.x * _e146);
    if ((bitcast<u32>(_e147) & 2147483647u) > 2139095040u) {
        phi_333_ = _e147;
    } else {
        if (_e147 < 0f) {
            phi_332_ = 0f;
        } else {
            if (_e147 > 1f) {
                phi_331_ = 1f;
            } else {
                phi_331_ = _e147;
            }
            let _e154 = phi_331_;
            phi_332_ = _e154;
        }
        let _e156 = phi_332_;
        phi_333_ = _e156;
    }
    let _e158 = phi_333_;
    return _e158;
}

fn function_() {
    var local: f32;
    var phi_393_: bool;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_400_: bool;
    var phi_470_: bool;
    var phi_471_: bool;
    var phi_482_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_483_: bool;
    var phi_484_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_485_: bool;
    var phi_492_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_496_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_516_: lt_math_LightPoint;
    var phi_519_: u32;
    var phi_521_: lt_math_LevelPoint;
    var phi_607_: bool;
    var phi_616_: bool;
    var phi_625_: bool;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_628_: bool;
    var phi_629_: bool;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_635_: bool;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_673_: bool;
    var phi_682_: lt_math_LightPoint;
    var phi_683_: u32;
    var phi_684_: lt_math_LevelPoint;
    var phi_685_: bool;
    var phi_517_: lt_math_LightPoint;
    var phi_520_: u32;
    var phi_522_: lt_math_LevelPoint;
    var phi_686_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_726_: bool;
    var phi_727_: bool;
    var phi_728_: bool;
    var phi_729_: bool;
    var phi_733_: bool;
    var phi_815_: f32;
    var phi_931_: f32;
    var phi_932_: f32;
    var phi_935_: f32;
    var phi_964_: f32;
    var phi_969_: f32;
    var phi_970_: bool;
    var phi_971_: f32;
    var phi_972_: bool;
    var phi_976_: f32;
    var phi_996_: f32;
    var phi_1001_: f32;
    var phi_1002_: bool;
    var phi_1003_: f32;
    var phi_1004_: bool;
    var phi_1008_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1057_: i32;
    var phi_1062_: i32;
    var phi_1067_: i32;
    var phi_1072_: i32;
    var phi_1081_: i32;
    var phi_1086_: i32;
    var phi_1091_: i32;
    var phi_1096_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1212_: f32;
    var phi_1214_: evaluate_Verdict;
    var phi_1215_: bool;
    var phi_1216_: evaluate_Verdict;
    var phi_1217_: bool;
    var phi_1222_: evaluate_Verdict;
    var phi_1223_: bool;
    var phi_1225_: evaluate_Verdict;
    var phi_1226_: evaluate_Verdict;
    var phi_1227_: bool;
    var phi_1231_: evaluate_Verdict;
    var phi_1232_: evaluate_Verdict;
    var phi_1233_: bool;
    var phi_1237_: evaluate_Verdict;

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
        let _e85 = samples.member[(0u + _e72.first_primitive)].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[(0u + _e72.first_primitive)].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[(0u + _e72.first_primitive)].normal[2u];
                let _e97 = global[2u];
                phi_393_ = (_e95 == _e97);
                phi_394_ = false;
            } else {
                phi_393_ = bool();
                phi_394_ = true;
            }
            let _e100 = phi_393_;
            let _e102 = phi_394_;
            phi_395_ = _e100;
            phi_396_ = _e102;
        } else {
            phi_395_ = bool();
            phi_396_ = true;
        }
        let _e104 = phi_395_;
        let _e106 = phi_396_;
        if _e106 {
            phi_400_ = false;
        } else {
            phi_400_ = _e104;
        }
        let _e108 = phi_400_;
        if !(_e108) {
            let _e111 = samples.member[(0u + _e72.first_primitive)].position;
            let _e113 = p.member.light.place;
            let _e119 = p.member.light.place[3u];
            let _e126 = (_e113.x - (_e111.x * _e119));
            let _e127 = (_e113.y - (_e111.y * _e119));
            let _e128 = (_e113.z - (_e111.z * _e119));
            let _e130 = samples.member[(0u + _e72.first_primitive)].normal;
            if ((((_e130.x * _e126) + (_e130.y * _e127)) + (_e130.z * _e128)) > 0f) {
                let _e144 = (((_e126 * _e126) + (_e127 * _e127)) + (_e128 * _e128));
                let _e146 = p.member.light.axis;
                let _e158 = p.member.light.place[3u];
                if (_e158 == 0f) {
                    phi_471_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_470_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_470_ = false;
                    }
                    let _e169 = phi_470_;
                    phi_471_ = _e169;
                }
                let _e171 = phi_471_;
                if _e171 {
                    let _e173 = samples.member[(0u + _e72.first_primitive)].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_482_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_483_ = false;
                } else {
                    phi_482_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_483_ = true;
                }
                let _e192 = phi_482_;
                let _e194 = phi_483_;
                phi_484_ = _e192;
                phi_485_ = _e194;
            } else {
                phi_484_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_485_ = true;
            }
            let _e196 = phi_484_;
            let _e198 = phi_485_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_492_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_492_ = _e196;
            }
            let _e215 = phi_492_;
            phi_496_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_496_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_496_;
        if _e232.unnamed_1 {
            phi_1231_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
            phi_1232_ = evaluate_Verdict();
            phi_1233_ = true;
        } else {
            let _e240 = samples.member[(0u + _e72.first_primitive)].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_516_ = lt_math_LightPoint();
            phi_519_ = 0u;
            phi_521_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_516_;
                let _e271 = phi_519_;
                let _e273 = phi_521_;
                local_1 = _e273;
                local_2 = _e273;
                local_3 = _e273;
                local_4 = _e273;
                if (_e271 < _e78) {
                    if _e273.point.is_inside {
                        phi_682_ = lt_math_LightPoint();
                        phi_683_ = u32();
                        phi_684_ = lt_math_LevelPoint();
                        phi_685_ = false;
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
                                phi_607_ = (_e309 <= 1f);
                            } else {
                                phi_607_ = false;
                            }
                            let _e341 = phi_607_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_616_ = (_e323 <= 1f);
                                } else {
                                    phi_616_ = false;
                                }
                                let _e345 = phi_616_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_625_ = (_e336 <= 1f);
                                    } else {
                                        phi_625_ = false;
                                    }
                                    let _e349 = phi_625_;
                                    phi_626_ = _e349;
                                    phi_627_ = false;
                                } else {
                                    phi_626_ = bool();
                                    phi_627_ = true;
                                }
                                let _e351 = phi_626_;
                                let _e353 = phi_627_;
                                phi_628_ = _e351;
                                phi_629_ = _e353;
                            } else {
                                phi_628_ = bool();
                                phi_629_ = true;
                            }
                            let _e355 = phi_628_;
                            let _e357 = phi_629_;
                            phi_630_ = _e355;
                            phi_631_ = _e357;
                        } else {
                            phi_630_ = bool();
                            phi_631_ = true;
                        }
                        let _e359 = phi_630_;
                        let _e361 = phi_631_;
                        if _e361 {
                            phi_635_ = false;
                        } else {
                            phi_635_ = _e359;
                        }
                        let _e363 = phi_635_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_662_ = (_e323 <= (1f - _e244));
                                        phi_663_ = false;
                                    } else {
                                        phi_662_ = bool();
                                        phi_663_ = true;
                                    }
                                    let _e371 = phi_662_;
                                    let _e373 = phi_663_;
                                    phi_664_ = _e371;
                                    phi_665_ = _e373;
                                } else {
                                    phi_664_ = bool();
                                    phi_665_ = true;
                                }
                                let _e375 = phi_664_;
                                let _e377 = phi_665_;
                                phi_666_ = _e375;
                                phi_667_ = _e377;
                            } else {
                                phi_666_ = bool();
                                phi_667_ = true;
                            }
                            let _e379 = phi_666_;
                            let _e381 = phi_667_;
                            phi_668_ = _e379;
                            phi_669_ = _e381;
                        } else {
                            phi_668_ = bool();
                            phi_669_ = true;
                        }
                        let _e383 = phi_668_;
                        let _e385 = phi_669_;
                        if _e385 {
                            phi_673_ = false;
                        } else {
                            phi_673_ = _e383;
                        }
                        let _e387 = phi_673_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_682_ = _e409;
                        phi_683_ = (_e271 + 1u);
                        phi_684_ = lt_math_LevelPoint(_e271, _e409);
                        phi_685_ = true;
                    }
                    let _e413 = phi_682_;
                    let _e415 = phi_683_;
                    let _e417 = phi_684_;
                    let _e419 = phi_685_;
                    phi_517_ = _e413;
                    phi_520_ = _e415;
                    phi_522_ = _e417;
                    phi_686_ = _e419;
                } else {
                    phi_517_ = lt_math_LightPoint();
                    phi_520_ = u32();
                    phi_522_ = lt_math_LevelPoint();
                    phi_686_ = false;
                }
                let _e421 = phi_517_;
                let _e423 = phi_520_;
                let _e425 = phi_522_;
                let _e427 = phi_686_;
                continue;
                continuing {
                    phi_516_ = _e421;
                    phi_519_ = _e423;
                    phi_521_ = _e425;
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
                            phi_726_ = (_e441.row_w.z == _e453);
                            phi_727_ = false;
                        } else {
                            phi_726_ = bool();
                            phi_727_ = true;
                        }
                        let _e456 = phi_726_;
                        let _e458 = phi_727_;
                        phi_728_ = _e456;
                        phi_729_ = _e458;
                    } else {
                        phi_728_ = bool();
                        phi_729_ = true;
                    }
                    let _e460 = phi_728_;
                    let _e462 = phi_729_;
                    if _e462 {
                        phi_733_ = false;
                    } else {
                        phi_733_ = _e460;
                    }
                    let _e464 = phi_733_;
                    if _e464 {
                        let _e466 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_815_ = _e538;
                        } else {
                            phi_815_ = 0.002f;
                        }
                        let _e541 = phi_815_;
                        phi_932_ = _e541;
                    } else {
                        let _e543 = p.member.map_size;
                        let _e549 = samples.member[(0u + _e72.first_primitive)].position;
                        let _e560 = ((((_e441.row_w.x * _e549.x) + (_e441.row_w.y * _e549.y)) + (_e441.row_w.z * _e549.z)) + _e441.row_w.w);
                        let _e573 = ((_e441.row_x.x - (_e441.row_w.x * _e430.point.uv.x)) / _e560);
                        let _e574 = ((_e441.row_x.y - (_e441.row_w.y * _e430.point.uv.x)) / _e560);
                        let _e575 = ((_e441.row_x.z - (_e441.row_w.z * _e430.point.uv.x)) / _e560);
                        let _e588 = ((_e441.row_y.x - (_e441.row_w.x * _e430.point.uv.y)) / _e560);
                        let _e589 = ((_e441.row_y.y - (_e441.row_w.y * _e430.point.uv.y)) / _e560);
                        let _e590 = ((_e441.row_y.z - (_e441.row_w.z * _e430.point.uv.y)) / _e560);
                        let _e596 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e601 = ((_e589 * _e596.z) - (_e596.y * _e590));
                        let _e606 = ((_e590 * _e596.x) - (_e596.z * _e588));
                        let _e611 = ((_e588 * _e596.y) - (_e596.x * _e589));
                        let _e613 = samples.member[(0u + _e72.first_primitive)].normal;
                        let _e618 = ((_e574 * _e613.z) - (_e613.y * _e575));
                        let _e623 = ((_e575 * _e613.x) - (_e613.z * _e573));
                        let _e628 = ((_e573 * _e613.y) - (_e613.x * _e574));
                        let _e655 = ((abs(((((_e441.row_z.x * _e601) + (_e441.row_z.y * _e606)) + (_e441.row_z.z * _e611)) / (((_e573 * _e601) + (_e574 * _e606)) + (_e575 * _e611)))) + abs(((((_e441.row_z.x * _e618) + (_e441.row_z.y * _e623)) + (_e441.row_z.z * _e628)) / (((_e588 * _e618) + (_e589 * _e623)) + (_e590 * _e628))))) / f32(_e543));
                        if (_e655 < 0.002f) {
                            phi_931_ = _e655;
                        } else {
                            phi_931_ = 0.002f;
                        }
                        let _e658 = phi_931_;
                        phi_932_ = _e658;
                    }
                    let _e660 = phi_932_;
                    phi_935_ = (_e430.point.depth - (0f * _e660));
                } else {
                    phi_935_ = _e430.point.depth;
                }
                let _e664 = phi_935_;
                let _e670 = p.member.map_size;
                let _e671 = f32(_e670);
                let _e674 = ((_e430.point.uv.x * _e671) - 0.5f);
                let _e675 = ((_e430.point.uv.y * _e671) - 0.5f);
                if (_e674 > -8388608f) {
                    let _e687 = f32(select(0i, select(select(i32(_e674), i32(-2147483648), (_e674 < bitcast<f32>(3472883712u))), 2147483647i, (_e674 > bitcast<f32>(1325400063u))), (_e674 == _e674)));
                    if (_e687 > _e674) {
                        phi_964_ = 1f;
                    } else {
                        phi_964_ = 0f;
                    }
                    let _e690 = phi_964_;
                    if (_e674 < 8388608f) {
                        phi_969_ = (_e687 - _e690);
                        phi_970_ = false;
                    } else {
                        phi_969_ = f32();
                        phi_970_ = true;
                    }
                    let _e693 = phi_969_;
                    let _e695 = phi_970_;
                    phi_971_ = _e693;
                    phi_972_ = _e695;
                } else {
                    phi_971_ = f32();
                    phi_972_ = true;
                }
                let _e697 = phi_971_;
                let _e699 = phi_972_;
                if _e699 {
                    phi_976_ = _e674;
                } else {
                    phi_976_ = _e697;
                }
                let _e701 = phi_976_;
                if (_e675 > -8388608f) {
                    let _e713 = f32(select(0i, select(select(i32(_e675), i32(-2147483648), (_e675 < bitcast<f32>(3472883712u))), 2147483647i, (_e675 > bitcast<f32>(1325400063u))), (_e675 == _e675)));
                    if (_e713 > _e675) {
                        phi_996_ = 1f;
                    } else {
                        phi_996_ = 0f;
                    }
                    let _e716 = phi_996_;
                    if (_e675 < 8388608f) {
                        phi_1001_ = (_e713 - _e716);
                        phi_1002_ = false;
                    } else {
                        phi_1001_ = f32();
                        phi_1002_ = true;
                    }
                    let _e719 = phi_1001_;
                    let _e721 = phi_1002_;
                    phi_1003_ = _e719;
                    phi_1004_ = _e721;
                } else {
                    phi_1003_ = f32();
                    phi_1004_ = true;
                }
                let _e723 = phi_1003_;
                let _e725 = phi_1004_;
                if _e725 {
                    phi_1008_ = _e675;
                } else {
                    phi_1008_ = _e723;
                }
                let _e727 = phi_1008_;
                let _e728 = (_e674 - _e701);
                let _e729 = (_e675 - _e727);
                let _e738 = select(0i, select(select(i32(_e701), i32(-2147483648), (_e701 < bitcast<f32>(3472883712u))), 2147483647i, (_e701 > bitcast<f32>(1325400063u))), (_e701 == _e701));
                let _e747 = select(0i, select(select(i32(_e727), i32(-2147483648), (_e727 < bitcast<f32>(3472883712u))), 2147483647i, (_e727 > bitcast<f32>(1325400063u))), (_e727 == _e727));
                let _e750 = ((1f - _e728) * (1f - _e729));
                let _e752 = (_e728 * (1f - _e729));
                let _e754 = ((1f - _e728) * _e729);
                let _e755 = (_e728 * _e729);
                let _e757 = p.member.test;
                let _e758 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e757);
                let _e760 = p.member.map_size;
                let _e762 = local_3;
                local = _e758;
                let _e765 = ((_e762.level * _e760) * _e760);
                let _e767 = (bitcast<i32>(_e760) - 1i);
                if (_e738 > 0i) {
                    phi_1057_ = _e738;
                } else {
                    phi_1057_ = 0i;
                }
                let _e770 = phi_1057_;
                if (_e747 > 0i) {
                    phi_1062_ = _e747;
                } else {
                    phi_1062_ = 0i;
                }
                let _e773 = phi_1062_;
                if (_e770 < _e767) {
                    phi_1067_ = _e770;
                } else {
                    phi_1067_ = _e767;
                }
                let _e776 = phi_1067_;
                if (_e773 < _e767) {
                    phi_1072_ = _e773;
                } else {
                    phi_1072_ = _e767;
                }
                let _e779 = phi_1072_;
                let _e780 = bitcast<u32>(_e776);
                let _e782 = (_e738 + 1i);
                let _e783 = (_e747 + 1i);
                if (_e782 > 0i) {
                    phi_1081_ = _e782;
                } else {
                    phi_1081_ = 0i;
                }
                let _e786 = phi_1081_;
                if (_e783 > 0i) {
                    phi_1086_ = _e783;
                } else {
                    phi_1086_ = 0i;
                }
                let _e789 = phi_1086_;
                if (_e786 < _e767) {
                    phi_1091_ = _e786;
                } else {
                    phi_1091_ = _e767;
                }
                let _e792 = phi_1091_;
                if (_e789 < _e767) {
                    phi_1096_ = _e789;
                } else {
                    phi_1096_ = _e767;
                }
                let _e795 = phi_1096_;
                let _e796 = bitcast<u32>(_e792);
                let _e798 = (bitcast<u32>(_e779) * _e760);
                let _e799 = (bitcast<u32>(_e795) * _e760);
                let _e804 = ((_e798 + _e780) + _e765);
                let _e805 = ((_e798 + _e796) + _e765);
                let _e806 = ((_e799 + _e780) + _e765);
                let _e807 = ((_e799 + _e796) + _e765);
                if (_e804 < _e60) {
                } else {
                    return;
                }
                let _e811 = map.member[(0u + _e804)];
                if (_e805 < _e60) {
                } else {
                    return;
                }
                let _e823 = map.member[(0u + _e805)];
                if (_e806 < _e60) {
                } else {
                    return;
                }
                let _e839 = map.member[(0u + _e806)];
                if (_e807 < _e60) {
                } else {
                    return;
                }
                let _e855 = map.member[(0u + _e807)];
                let _e869 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e811.x * _e750) + (_e823.x * _e752)) + (_e839.x * _e754)) + (_e855.x * _e755)), ((((_e811.y * _e750) + (_e823.y * _e752)) + (_e839.y * _e754)) + (_e855.y * _e755)), ((((_e811.z * _e750) + (_e823.z * _e752)) + (_e839.z * _e754)) + (_e855.z * _e755)), ((((_e811.w * _e750) + (_e823.w * _e752)) + (_e839.w * _e754)) + (_e855.w * _e755))), _e664);
                let _e871 = p.member.fade_uv;
                if (_e871 > 0f) {
                    let _e874 = local_4;
                    if ((_e874.level + 1u) == _e78) {
                        let _e883 = p.member.fade_uv;
                        let _e885 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e430.point.uv.x, (1f - _e430.point.uv.x));
                        let _e887 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e430.point.uv.y, (1f - _e430.point.uv.y));
                        let _e888 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e885, _e887);
                        if (_e888 < _e883) {
                            phi_1212_ = (1f - ((1f - _e869) * (_e888 / _e883)));
                        } else {
                            phi_1212_ = _e869;
                        }
                        let _e895 = phi_1212_;
                        phi_1214_ = evaluate_Verdict(_e895, false);
                        phi_1215_ = false;
                    } else {
                        phi_1214_ = evaluate_Verdict();
                        phi_1215_ = true;
                    }
                    let _e898 = phi_1214_;
                    let _e900 = phi_1215_;
                    phi_1216_ = _e898;
                    phi_1217_ = _e900;
                } else {
                    phi_1216_ = evaluate_Verdict();
                    phi_1217_ = true;
                }
                let _e902 = phi_1216_;
                let _e904 = phi_1217_;
                if _e904 {
                    phi_1222_ = evaluate_Verdict(_e869, false);
                    phi_1223_ = false;
                } else {
                    phi_1222_ = evaluate_Verdict();
                    phi_1223_ = true;
                }
                let _e907 = phi_1222_;
                let _e909 = phi_1223_;
                phi_1225_ = _e907;
                phi_1226_ = _e902;
                phi_1227_ = _e909;
            } else {
                phi_1225_ = evaluate_Verdict();
                phi_1226_ = evaluate_Verdict(1f, false);
                phi_1227_ = true;
            }
            let _e912 = phi_1225_;
            let _e914 = phi_1226_;
            let _e916 = phi_1227_;
            if _e916 {
            }
            phi_1231_ = _e914;
            phi_1232_ = _e912;
            phi_1233_ = _e916;
        }
        let _e918 = phi_1231_;
        let _e920 = phi_1232_;
        let _e922 = phi_1233_;
        if _e922 {
            phi_1237_ = _e918;
        } else {
            phi_1237_ = _e920;
        }
        let _e924 = phi_1237_;
        if (_e72.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.first_primitive)] = _e924.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
