struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct type_9 {
    member: array<u32>,
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

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
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
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_55;
@group(0) @binding(5) 
var<storage> levels: type_49;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_175_: lt_bvh_traverse_Tree;
    var phi_176_: bool;
    var phi_177_: lt_bvh_traverse_Tree;
    var phi_178_: bool;
    var phi_183_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_175_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_176_ = false;
        } else {
            phi_175_ = lt_bvh_traverse_Tree();
            phi_176_ = true;
        }
        let _e69 = phi_175_;
        let _e71 = phi_176_;
        phi_177_ = _e69;
        phi_178_ = _e71;
    } else {
        phi_177_ = lt_bvh_traverse_Tree();
        phi_178_ = true;
    }
    let _e73 = phi_177_;
    let _e75 = phi_178_;
    if _e75 {
        phi_183_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_183_ = _e73;
    }
    let _e80 = phi_183_;
    return lt_bvh_traverse_Tree(_e80.root, _e80.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_208_: f32;
    var phi_209_: f32;
    var phi_210_: f32;
    var phi_223_: bool;
    var phi_227_: f32;
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

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_210_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_209_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_208_ = 1f;
            } else {
                phi_208_ = param_6;
            }
            let _e65 = phi_208_;
            phi_209_ = _e65;
        }
        let _e67 = phi_209_;
        phi_210_ = _e67;
    }
    let _e69 = phi_210_;
    let _e71 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_223_ = true;
    } else {
        let _e75 = (84f < _e71);
        if _e75 {
        }
        phi_223_ = _e75;
    }
    let _e77 = phi_223_;
    if _e77 {
        phi_227_ = 84f;
    } else {
        phi_227_ = _e71;
    }
    let _e79 = phi_227_;
    let _e81 = (_e79 * (1f - _e69));
    if ((bitcast<u32>(_e81) & 2147483647u) > 2139095040u) {
        phi_317_ = _e81;
    } else {
        if (_e81 < -87f) {
            phi_240_ = -87f;
        } else {
            phi_240_ = _e81;
        }
        let _e87 = phi_240_;
        if (_e87 > 88f) {
            phi_245_ = 88f;
        } else {
            phi_245_ = _e87;
        }
        let _e90 = phi_245_;
        let _e92 = ((_e90 * 1.442695f) + 0.5f);
        if (_e92 > -8388608f) {
            let _e104 = f32(select(0i, select(select(i32(_e92), i32(-2147483648), (_e92 < bitcast<f32>(3472883712u))), 2147483647i, (_e92 > bitcast<f32>(1325400063u))), (_e92 == _e92)));
            if (_e104 > _e92) {
                phi_267_ = 1f;
            } else {
                phi_267_ = 0f;
            }
            let _e107 = phi_267_;
            if (_e92 < 8388608f) {
                phi_272_ = (_e104 - _e107);
                phi_273_ = false;
            } else {
                phi_272_ = f32();
                phi_273_ = true;
            }
            let _e110 = phi_272_;
            let _e112 = phi_273_;
            phi_274_ = _e110;
            phi_275_ = _e112;
        } else {
            phi_274_ = f32();
            phi_275_ = true;
        }
        let _e114 = phi_274_;
        let _e116 = phi_275_;
        if _e116 {
            phi_279_ = _e92;
        } else {
            phi_279_ = _e114;
        }
        let _e118 = phi_279_;
        let _e122 = ((_e90 - (_e118 * 0.69314575f)) - (_e118 * 0.0000014286068f));
        phi_317_ = ((((((((((((((((1f / 5040f) * _e122) + (1f / 720f)) * _e122) + (1f / 120f)) * _e122) + (1f / 24f)) * _e122) + (1f / 6f)) * _e122) + 0.5f) * _e122) + 1f) * _e122) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < bitcast<f32>(3472883712u))), 2147483647i, (_e118 > bitcast<f32>(1325400063u))), (_e118 == _e118)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e158 = phi_317_;
    let _e159 = (param_5.x * _e158);
    if ((bitcast<u32>(_e159) & 2147483647u) > 2139095040u) {
        phi_335_ = _e159;
    } else {
        if (_e159 < 0f) {
            phi_334_ = 0f;
        } else {
            if (_e159 > 1f) {
                phi_333_ = 1f;
            } else {
                phi_333_ = _e159;
            }
            let _e166 = phi_333_;
            phi_334_ = _e166;
        }
        let _e168 = phi_334_;
        phi_335_ = _e168;
    }
    let _e170 = phi_335_;
    return _e170;
}

fn function_() {
    var local_1: f32;
    var phi_390_: bool;
    var phi_391_: bool;
    var phi_392_: bool;
    var phi_393_: bool;
    var phi_397_: bool;
    var phi_467_: bool;
    var phi_468_: bool;
    var phi_479_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_480_: bool;
    var phi_481_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_482_: bool;
    var phi_489_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_493_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_513_: lt_math_LightPoint;
    var phi_516_: u32;
    var phi_518_: lt_math_LevelPoint;
    var phi_604_: bool;
    var phi_613_: bool;
    var phi_622_: bool;
    var phi_623_: bool;
    var phi_624_: bool;
    var phi_625_: bool;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_628_: bool;
    var phi_632_: bool;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_670_: bool;
    var phi_679_: lt_math_LightPoint;
    var phi_680_: u32;
    var phi_681_: lt_math_LevelPoint;
    var phi_682_: bool;
    var phi_514_: lt_math_LightPoint;
    var phi_517_: u32;
    var phi_519_: lt_math_LevelPoint;
    var phi_683_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_723_: bool;
    var phi_724_: bool;
    var phi_725_: bool;
    var phi_726_: bool;
    var phi_730_: bool;
    var phi_812_: f32;
    var phi_930_: f32;
    var phi_931_: f32;
    var phi_934_: f32;
    var phi_963_: f32;
    var phi_968_: f32;
    var phi_969_: bool;
    var phi_970_: f32;
    var phi_971_: bool;
    var phi_975_: f32;
    var phi_995_: f32;
    var phi_1000_: f32;
    var phi_1001_: bool;
    var phi_1002_: f32;
    var phi_1003_: bool;
    var phi_1007_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1056_: i32;
    var phi_1061_: i32;
    var phi_1066_: i32;
    var phi_1071_: i32;
    var phi_1080_: i32;
    var phi_1085_: i32;
    var phi_1090_: i32;
    var phi_1095_: i32;
    var phi_1190_: bool;
    var phi_1198_: bool;
    var phi_1210_: bool;
    var phi_1211_: bool;
    var phi_1215_: f32;
    var phi_1221_: f32;
    var phi_1223_: evaluate_Verdict;
    var phi_1228_: evaluate_Verdict;
    var phi_1229_: evaluate_Verdict;
    var phi_1233_: bool;
    var phi_1234_: u32;
    var phi_1245_: u32;

    let _e57 = id_1;
    let _e58 = local_5;
    let _e63 = arrayLength((&map.member));
    let _e68 = arrayLength((&levels.member));
    let _e71 = p.member.size[0u];
    let _e73 = p.member.size[1u];
    let _e74 = lt_shaders_entry_pixel_index(_e57, _e71, _e73);
    if (bitcast<i32>(_e74.root) != 0i) {
        let _e81 = p.member.level_count;
        let _e85 = samples.member[_e74.first_primitive].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[_e74.first_primitive].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[_e74.first_primitive].normal[2u];
                let _e97 = global[2u];
                phi_390_ = (_e95 == _e97);
                phi_391_ = false;
            } else {
                phi_390_ = bool();
                phi_391_ = true;
            }
            let _e100 = phi_390_;
            let _e102 = phi_391_;
            phi_392_ = _e100;
            phi_393_ = _e102;
        } else {
            phi_392_ = bool();
            phi_393_ = true;
        }
        let _e104 = phi_392_;
        let _e106 = phi_393_;
        if _e106 {
            phi_397_ = false;
        } else {
            phi_397_ = _e104;
        }
        let _e108 = phi_397_;
        if !(_e108) {
            let _e111 = samples.member[_e74.first_primitive].position;
            let _e113 = p.member.light.place;
            let _e119 = p.member.light.place[3u];
            let _e126 = (_e113.x - (_e111.x * _e119));
            let _e127 = (_e113.y - (_e111.y * _e119));
            let _e128 = (_e113.z - (_e111.z * _e119));
            let _e130 = samples.member[_e74.first_primitive].normal;
            if ((((_e130.x * _e126) + (_e130.y * _e127)) + (_e130.z * _e128)) > 0f) {
                let _e144 = (((_e126 * _e126) + (_e127 * _e127)) + (_e128 * _e128));
                let _e146 = p.member.light.axis;
                let _e158 = p.member.light.place[3u];
                if (_e158 == 0f) {
                    phi_468_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_467_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_467_ = false;
                    }
                    let _e169 = phi_467_;
                    phi_468_ = _e169;
                }
                let _e171 = phi_468_;
                if _e171 {
                    let _e173 = samples.member[_e74.first_primitive].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_479_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_480_ = false;
                } else {
                    phi_479_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_480_ = true;
                }
                let _e192 = phi_479_;
                let _e194 = phi_480_;
                phi_481_ = _e192;
                phi_482_ = _e194;
            } else {
                phi_481_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_482_ = true;
            }
            let _e196 = phi_481_;
            let _e198 = phi_482_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_489_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_489_ = _e196;
            }
            let _e215 = phi_489_;
            phi_493_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_493_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_493_;
        if _e232.unnamed_1 {
            phi_1229_ = evaluate_Verdict(_e232.unnamed.visibility, _e232.unnamed.is_doubted);
        } else {
            let _e240 = samples.member[_e74.first_primitive].position;
            let _e242 = p.member.map_size;
            let _e244 = (0.5f / f32(_e242));
            let _e251 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e258 = lt_math_LightPoint(vec2<f32>(_e251.uv.x, 0f), _e251.depth, _e251.is_inside);
            let _e262 = lt_math_LightPoint(_e258.uv, 0f, _e258.is_inside);
            phi_513_ = lt_math_LightPoint();
            phi_516_ = 0u;
            phi_518_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e262.uv, _e262.depth, false));
            loop {
                let _e269 = phi_513_;
                let _e271 = phi_516_;
                let _e273 = phi_518_;
                local_2 = _e273;
                local_3 = _e273;
                local_4 = _e273;
                if (_e271 < _e81) {
                    if _e273.point.is_inside {
                        phi_679_ = lt_math_LightPoint();
                        phi_680_ = u32();
                        phi_681_ = lt_math_LevelPoint();
                        phi_682_ = false;
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
                                phi_604_ = (_e309 <= 1f);
                            } else {
                                phi_604_ = false;
                            }
                            let _e341 = phi_604_;
                            if _e341 {
                                if (_e323 >= 0f) {
                                    phi_613_ = (_e323 <= 1f);
                                } else {
                                    phi_613_ = false;
                                }
                                let _e345 = phi_613_;
                                if _e345 {
                                    if (_e336 >= 0f) {
                                        phi_622_ = (_e336 <= 1f);
                                    } else {
                                        phi_622_ = false;
                                    }
                                    let _e349 = phi_622_;
                                    phi_623_ = _e349;
                                    phi_624_ = false;
                                } else {
                                    phi_623_ = bool();
                                    phi_624_ = true;
                                }
                                let _e351 = phi_623_;
                                let _e353 = phi_624_;
                                phi_625_ = _e351;
                                phi_626_ = _e353;
                            } else {
                                phi_625_ = bool();
                                phi_626_ = true;
                            }
                            let _e355 = phi_625_;
                            let _e357 = phi_626_;
                            phi_627_ = _e355;
                            phi_628_ = _e357;
                        } else {
                            phi_627_ = bool();
                            phi_628_ = true;
                        }
                        let _e359 = phi_627_;
                        let _e361 = phi_628_;
                        if _e361 {
                            phi_632_ = false;
                        } else {
                            phi_632_ = _e359;
                        }
                        let _e363 = phi_632_;
                        if _e363 {
                            if (_e309 >= _e244) {
                                if (_e309 <= (1f - _e244)) {
                                    if (_e323 >= _e244) {
                                        phi_659_ = (_e323 <= (1f - _e244));
                                        phi_660_ = false;
                                    } else {
                                        phi_659_ = bool();
                                        phi_660_ = true;
                                    }
                                    let _e371 = phi_659_;
                                    let _e373 = phi_660_;
                                    phi_661_ = _e371;
                                    phi_662_ = _e373;
                                } else {
                                    phi_661_ = bool();
                                    phi_662_ = true;
                                }
                                let _e375 = phi_661_;
                                let _e377 = phi_662_;
                                phi_663_ = _e375;
                                phi_664_ = _e377;
                            } else {
                                phi_663_ = bool();
                                phi_664_ = true;
                            }
                            let _e379 = phi_663_;
                            let _e381 = phi_664_;
                            phi_665_ = _e379;
                            phi_666_ = _e381;
                        } else {
                            phi_665_ = bool();
                            phi_666_ = true;
                        }
                        let _e383 = phi_665_;
                        let _e385 = phi_666_;
                        if _e385 {
                            phi_670_ = false;
                        } else {
                            phi_670_ = _e383;
                        }
                        let _e387 = phi_670_;
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e309, _e269.uv.y), _e269.depth, _e269.is_inside);
                        let _e401 = lt_math_LightPoint(vec2<f32>(_e394.uv.x, _e323), _e394.depth, _e394.is_inside);
                        let _e405 = lt_math_LightPoint(_e401.uv, _e336, _e401.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e405.depth, _e387);
                        phi_679_ = _e409;
                        phi_680_ = (_e271 + 1u);
                        phi_681_ = lt_math_LevelPoint(_e271, _e409);
                        phi_682_ = true;
                    }
                    let _e413 = phi_679_;
                    let _e415 = phi_680_;
                    let _e417 = phi_681_;
                    let _e419 = phi_682_;
                    phi_514_ = _e413;
                    phi_517_ = _e415;
                    phi_519_ = _e417;
                    phi_683_ = _e419;
                } else {
                    phi_514_ = lt_math_LightPoint();
                    phi_517_ = u32();
                    phi_519_ = lt_math_LevelPoint();
                    phi_683_ = false;
                }
                let _e421 = phi_514_;
                let _e423 = phi_517_;
                let _e425 = phi_519_;
                let _e427 = phi_683_;
                continue;
                continuing {
                    phi_513_ = _e421;
                    phi_516_ = _e423;
                    phi_518_ = _e425;
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
                            phi_723_ = (_e441.row_w.z == _e453);
                            phi_724_ = false;
                        } else {
                            phi_723_ = bool();
                            phi_724_ = true;
                        }
                        let _e456 = phi_723_;
                        let _e458 = phi_724_;
                        phi_725_ = _e456;
                        phi_726_ = _e458;
                    } else {
                        phi_725_ = bool();
                        phi_726_ = true;
                    }
                    let _e460 = phi_725_;
                    let _e462 = phi_726_;
                    if _e462 {
                        phi_730_ = false;
                    } else {
                        phi_730_ = _e460;
                    }
                    let _e464 = phi_730_;
                    if _e464 {
                        let _e466 = samples.member[_e74.first_primitive].normal;
                        let _e468 = p.member.map_size;
                        let _e538 = ((abs(((((_e441.row_x.x * _e466.x) + (_e441.row_x.y * _e466.y)) + (_e441.row_x.z * _e466.z)) / (((_e441.row_x.x * _e441.row_x.x) + (_e441.row_x.y * _e441.row_x.y)) + (_e441.row_x.z * _e441.row_x.z)))) + abs(((((_e441.row_y.x * _e466.x) + (_e441.row_y.y * _e466.y)) + (_e441.row_y.z * _e466.z)) / (((_e441.row_y.x * _e441.row_y.x) + (_e441.row_y.y * _e441.row_y.y)) + (_e441.row_y.z * _e441.row_y.z))))) / (abs(((((_e441.row_z.x * _e466.x) + (_e441.row_z.y * _e466.y)) + (_e441.row_z.z * _e466.z)) / (((_e441.row_z.x * _e441.row_z.x) + (_e441.row_z.y * _e441.row_z.y)) + (_e441.row_z.z * _e441.row_z.z)))) * f32(_e468)));
                        if (_e538 < 0.002f) {
                            phi_812_ = _e538;
                        } else {
                            phi_812_ = 0.002f;
                        }
                        let _e541 = phi_812_;
                        phi_931_ = _e541;
                    } else {
                        let _e543 = p.member.map_size;
                        let _e549 = samples.member[_e74.first_primitive].position;
                        let _e560 = ((((_e441.row_w.x * _e549.x) + (_e441.row_w.y * _e549.y)) + (_e441.row_w.z * _e549.z)) + _e441.row_w.w);
                        let _e573 = ((_e441.row_x.x - (_e441.row_w.x * _e430.point.uv.x)) / _e560);
                        let _e574 = ((_e441.row_x.y - (_e441.row_w.y * _e430.point.uv.x)) / _e560);
                        let _e575 = ((_e441.row_x.z - (_e441.row_w.z * _e430.point.uv.x)) / _e560);
                        let _e588 = ((_e441.row_y.x - (_e441.row_w.x * _e430.point.uv.y)) / _e560);
                        let _e589 = ((_e441.row_y.y - (_e441.row_w.y * _e430.point.uv.y)) / _e560);
                        let _e590 = ((_e441.row_y.z - (_e441.row_w.z * _e430.point.uv.y)) / _e560);
                        let _e596 = samples.member[_e74.first_primitive].normal;
                        let _e601 = ((_e589 * _e596.z) - (_e596.y * _e590));
                        let _e606 = ((_e590 * _e596.x) - (_e596.z * _e588));
                        let _e611 = ((_e588 * _e596.y) - (_e596.x * _e589));
                        let _e613 = samples.member[_e74.first_primitive].normal;
                        let _e618 = ((_e574 * _e613.z) - (_e613.y * _e575));
                        let _e623 = ((_e575 * _e613.x) - (_e613.z * _e573));
                        let _e628 = ((_e573 * _e613.y) - (_e613.x * _e574));
                        let _e655 = ((abs(((((_e441.row_z.x * _e601) + (_e441.row_z.y * _e606)) + (_e441.row_z.z * _e611)) / (((_e573 * _e601) + (_e574 * _e606)) + (_e575 * _e611)))) + abs(((((_e441.row_z.x * _e618) + (_e441.row_z.y * _e623)) + (_e441.row_z.z * _e628)) / (((_e588 * _e618) + (_e589 * _e623)) + (_e590 * _e628))))) / f32(_e543));
                        let _e657 = (16f / f32(_e543));
                        if (_e655 < _e657) {
                            phi_930_ = _e655;
                        } else {
                            phi_930_ = _e657;
                        }
                        let _e660 = phi_930_;
                        phi_931_ = _e660;
                    }
                    let _e662 = phi_931_;
                    phi_934_ = (_e430.point.depth - (0f * _e662));
                } else {
                    phi_934_ = _e430.point.depth;
                }
                let _e666 = phi_934_;
                let _e672 = p.member.map_size;
                let _e673 = f32(_e672);
                let _e676 = ((_e430.point.uv.x * _e673) - 0.5f);
                let _e677 = ((_e430.point.uv.y * _e673) - 0.5f);
                if (_e676 > -8388608f) {
                    let _e689 = f32(select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < bitcast<f32>(3472883712u))), 2147483647i, (_e676 > bitcast<f32>(1325400063u))), (_e676 == _e676)));
                    if (_e689 > _e676) {
                        phi_963_ = 1f;
                    } else {
                        phi_963_ = 0f;
                    }
                    let _e692 = phi_963_;
                    if (_e676 < 8388608f) {
                        phi_968_ = (_e689 - _e692);
                        phi_969_ = false;
                    } else {
                        phi_968_ = f32();
                        phi_969_ = true;
                    }
                    let _e695 = phi_968_;
                    let _e697 = phi_969_;
                    phi_970_ = _e695;
                    phi_971_ = _e697;
                } else {
                    phi_970_ = f32();
                    phi_971_ = true;
                }
                let _e699 = phi_970_;
                let _e701 = phi_971_;
                if _e701 {
                    phi_975_ = _e676;
                } else {
                    phi_975_ = _e699;
                }
                let _e703 = phi_975_;
                if (_e677 > -8388608f) {
                    let _e715 = f32(select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < bitcast<f32>(3472883712u))), 2147483647i, (_e677 > bitcast<f32>(1325400063u))), (_e677 == _e677)));
                    if (_e715 > _e677) {
                        phi_995_ = 1f;
                    } else {
                        phi_995_ = 0f;
                    }
                    let _e718 = phi_995_;
                    if (_e677 < 8388608f) {
                        phi_1000_ = (_e715 - _e718);
                        phi_1001_ = false;
                    } else {
                        phi_1000_ = f32();
                        phi_1001_ = true;
                    }
                    let _e721 = phi_1000_;
                    let _e723 = phi_1001_;
                    phi_1002_ = _e721;
                    phi_1003_ = _e723;
                } else {
                    phi_1002_ = f32();
                    phi_1003_ = true;
                }
                let _e725 = phi_1002_;
                let _e727 = phi_1003_;
                if _e727 {
                    phi_1007_ = _e677;
                } else {
                    phi_1007_ = _e725;
                }
                let _e729 = phi_1007_;
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
                    phi_1056_ = _e740;
                } else {
                    phi_1056_ = 0i;
                }
                let _e772 = phi_1056_;
                if (_e749 > 0i) {
                    phi_1061_ = _e749;
                } else {
                    phi_1061_ = 0i;
                }
                let _e775 = phi_1061_;
                if (_e772 < _e769) {
                    phi_1066_ = _e772;
                } else {
                    phi_1066_ = _e769;
                }
                let _e778 = phi_1066_;
                if (_e775 < _e769) {
                    phi_1071_ = _e775;
                } else {
                    phi_1071_ = _e769;
                }
                let _e781 = phi_1071_;
                let _e782 = bitcast<u32>(_e778);
                let _e784 = (_e740 + 1i);
                let _e785 = (_e749 + 1i);
                if (_e784 > 0i) {
                    phi_1080_ = _e784;
                } else {
                    phi_1080_ = 0i;
                }
                let _e788 = phi_1080_;
                if (_e785 > 0i) {
                    phi_1085_ = _e785;
                } else {
                    phi_1085_ = 0i;
                }
                let _e791 = phi_1085_;
                if (_e788 < _e769) {
                    phi_1090_ = _e788;
                } else {
                    phi_1090_ = _e769;
                }
                let _e794 = phi_1090_;
                if (_e791 < _e769) {
                    phi_1095_ = _e791;
                } else {
                    phi_1095_ = _e769;
                }
                let _e797 = phi_1095_;
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
                    phi_1190_ = true;
                } else {
                    phi_1190_ = (_e871 >= (1f - _e873));
                }
                let _e878 = phi_1190_;
                if ((bitcast<u32>(_e871) & 2147483647u) > 2139095040u) {
                    phi_1198_ = true;
                } else {
                    phi_1198_ = !(_e878);
                }
                let _e884 = phi_1198_;
                if _e884 {
                    if (_e871 > 0f) {
                        if (_e871 < 1f) {
                            phi_1210_ = false;
                        } else {
                            phi_1210_ = true;
                        }
                        let _e888 = phi_1210_;
                        phi_1211_ = _e888;
                    } else {
                        phi_1211_ = true;
                    }
                    let _e890 = phi_1211_;
                    if _e890 {
                        phi_1215_ = 0.5f;
                    } else {
                        phi_1215_ = _e871;
                    }
                    let _e892 = phi_1215_;
                    phi_1223_ = evaluate_Verdict(_e892, true);
                } else {
                    if (_e871 > 0.5f) {
                        phi_1221_ = 1f;
                    } else {
                        phi_1221_ = 0f;
                    }
                    let _e896 = phi_1221_;
                    phi_1223_ = evaluate_Verdict(_e896, false);
                }
                let _e899 = phi_1223_;
                phi_1228_ = evaluate_Verdict(_e899.visibility, _e899.is_doubted);
            } else {
                phi_1228_ = evaluate_Verdict(0.5f, true);
            }
            let _e905 = phi_1228_;
            phi_1229_ = _e905;
        }
        let _e907 = phi_1229_;
        visibility.member[_e74.first_primitive] = _e907.visibility;
        phi_1233_ = _e907.is_doubted;
        phi_1234_ = _e74.first_primitive;
    } else {
        phi_1233_ = false;
        phi_1234_ = 0u;
    }
    let _e912 = phi_1233_;
    let _e914 = phi_1234_;
    if (_e58 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e912 {
        let _e918 = atomicAdd((&shared_[0u]), 1u);
        phi_1245_ = _e918;
    } else {
        phi_1245_ = 0u;
    }
    let _e920 = phi_1245_;
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
