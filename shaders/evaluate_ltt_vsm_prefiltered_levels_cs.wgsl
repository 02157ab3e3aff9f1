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

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_163_: lt_bvh_traverse_Tree;
    var phi_164_: bool;
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_171_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_163_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_164_ = false;
        } else {
            phi_163_ = lt_bvh_traverse_Tree();
            phi_164_ = true;
        }
        let _e56 = phi_163_;
        let _e58 = phi_164_;
        phi_165_ = _e56;
        phi_166_ = _e58;
    } else {
        phi_165_ = lt_bvh_traverse_Tree();
        phi_166_ = true;
    }
    let _e60 = phi_165_;
    let _e62 = phi_166_;
    if _e62 {
        phi_171_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_171_ = _e60;
    }
    let _e67 = phi_171_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_196_: f32;
    var phi_197_: f32;
    var phi_198_: f32;
    var phi_216_: bool;
    var phi_220_: f32;
    var phi_232_: bool;
    var phi_239_: f32;
    var phi_254_: f32;
    var phi_255_: f32;
    var phi_256_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_198_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_197_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_196_ = 1f;
            } else {
                phi_196_ = param_6;
            }
            let _e52 = phi_196_;
            phi_197_ = _e52;
        }
        let _e54 = phi_197_;
        phi_198_ = _e54;
    }
    let _e56 = phi_198_;
    let _e59 = (*param_4);
    let _e63 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e59) & 2147483647u) > 2139095040u) {
        phi_216_ = true;
    } else {
        let _e67 = (_e59 > _e63);
        if _e67 {
        }
        phi_216_ = _e67;
    }
    let _e69 = phi_216_;
    if _e69 {
        phi_220_ = _e59;
    } else {
        phi_220_ = _e63;
    }
    let _e71 = phi_220_;
    let _e72 = (_e56 - param_5.x);
    if (_e72 <= 0f) {
        let _e76 = ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u);
        if _e76 {
        }
        phi_232_ = _e76;
    } else {
        phi_232_ = true;
    }
    let _e78 = phi_232_;
    if _e78 {
        phi_239_ = (_e71 / (_e71 + (_e72 * _e72)));
    } else {
        phi_239_ = 1f;
    }
    let _e83 = phi_239_;
    if ((bitcast<u32>(_e83) & 2147483647u) > 2139095040u) {
        phi_256_ = _e83;
    } else {
        if (_e83 < 0f) {
            phi_255_ = 0f;
        } else {
            if (_e83 > 1f) {
                phi_254_ = 1f;
            } else {
                phi_254_ = _e83;
            }
            let _e90 = phi_254_;
            phi_255_ = _e90;
        }
        let _e92 = phi_255_;
        phi_256_ = _e92;
    }
    let _e94 = phi_256_;
    return _e94;
}

fn function_() {
    var local_1: f32;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_314_: bool;
    var phi_318_: bool;
    var phi_388_: bool;
    var phi_389_: bool;
    var phi_400_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_401_: bool;
    var phi_402_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_403_: bool;
    var phi_410_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_414_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_434_: lt_math_LightPoint;
    var phi_437_: u32;
    var phi_439_: lt_math_LevelPoint;
    var phi_525_: bool;
    var phi_534_: bool;
    var phi_543_: bool;
    var phi_544_: bool;
    var phi_545_: bool;
    var phi_546_: bool;
    var phi_547_: bool;
    var phi_548_: bool;
    var phi_549_: bool;
    var phi_553_: bool;
    var phi_580_: bool;
    var phi_581_: bool;
    var phi_582_: bool;
    var phi_583_: bool;
    var phi_584_: bool;
    var phi_585_: bool;
    var phi_586_: bool;
    var phi_587_: bool;
    var phi_591_: bool;
    var phi_600_: lt_math_LightPoint;
    var phi_601_: u32;
    var phi_602_: lt_math_LevelPoint;
    var phi_603_: bool;
    var phi_435_: lt_math_LightPoint;
    var phi_438_: u32;
    var phi_440_: lt_math_LevelPoint;
    var phi_604_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_651_: bool;
    var phi_733_: f32;
    var phi_849_: f32;
    var phi_850_: f32;
    var phi_853_: f32;
    var phi_882_: f32;
    var phi_887_: f32;
    var phi_888_: bool;
    var phi_889_: f32;
    var phi_890_: bool;
    var phi_894_: f32;
    var phi_914_: f32;
    var phi_919_: f32;
    var phi_920_: bool;
    var phi_921_: f32;
    var phi_922_: bool;
    var phi_926_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_975_: i32;
    var phi_980_: i32;
    var phi_985_: i32;
    var phi_990_: i32;
    var phi_999_: i32;
    var phi_1004_: i32;
    var phi_1009_: i32;
    var phi_1014_: i32;
    var phi_1109_: bool;
    var phi_1117_: bool;
    var phi_1129_: bool;
    var phi_1130_: bool;
    var phi_1134_: f32;
    var phi_1140_: f32;
    var phi_1142_: evaluate_Verdict;
    var phi_1147_: evaluate_Verdict;
    var phi_1148_: evaluate_Verdict;
    var phi_1152_: bool;
    var phi_1153_: u32;
    var phi_1164_: u32;

    let _e44 = id_1;
    let _e45 = local_5;
    let _e50 = arrayLength((&map.member));
    let _e55 = arrayLength((&levels.member));
    let _e58 = p.member.size[0u];
    let _e60 = p.member.size[1u];
    let _e61 = lt_shaders_entry_pixel_index(_e44, _e58, _e60);
    if (bitcast<i32>(_e61.root) != 0i) {
        let _e68 = p.member.level_count;
        let _e72 = samples.member[_e61.first_primitive].normal[0u];
        let _e74 = global[0u];
        if (_e72 == _e74) {
            let _e77 = samples.member[_e61.first_primitive].normal[1u];
            let _e79 = global[1u];
            if (_e77 == _e79) {
                let _e82 = samples.member[_e61.first_primitive].normal[2u];
                let _e84 = global[2u];
                phi_311_ = (_e82 == _e84);
                phi_312_ = false;
            } else {
                phi_311_ = bool();
                phi_312_ = true;
            }
            let _e87 = phi_311_;
            let _e89 = phi_312_;
            phi_313_ = _e87;
            phi_314_ = _e89;
        } else {
            phi_313_ = bool();
            phi_314_ = true;
        }
        let _e91 = phi_313_;
        let _e93 = phi_314_;
        if _e93 {
            phi_318_ = false;
        } else {
            phi_318_ = _e91;
        }
        let _e95 = phi_318_;
        if !(_e95) {
            let _e98 = samples.member[_e61.first_primitive].position;
            let _e100 = p.member.light.place;
            let _e106 = p.member.light.place[3u];
            let _e113 = (_e100.x - (_e98.x * _e106));
            let _e114 = (_e100.y - (_e98.y * _e106));
            let _e115 = (_e100.z - (_e98.z * _e106));
            let _e117 = samples.member[_e61.first_primitive].normal;
            if ((((_e117.x * _e113) + (_e117.y * _e114)) + (_e117.z * _e115)) > 0f) {
                let _e131 = (((_e113 * _e113) + (_e114 * _e114)) + (_e115 * _e115));
                let _e133 = p.member.light.axis;
                let _e145 = p.member.light.place[3u];
                if (_e145 == 0f) {
                    phi_389_ = true;
                } else {
                    let _e148 = p.member.light.range_squared;
                    if (_e131 <= _e148) {
                        let _e151 = p.member.light.cos_outer;
                        phi_388_ = (-((((_e113 * _e133.x) + (_e114 * _e133.y)) + (_e115 * _e133.z))) >= (_e151 * sqrt(_e131)));
                    } else {
                        phi_388_ = false;
                    }
                    let _e156 = phi_388_;
                    phi_389_ = _e156;
                }
                let _e158 = phi_389_;
                if _e158 {
                    let _e160 = samples.member[_e61.first_primitive].flags;
                    let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                    phi_400_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, ((_e160 & 1u) == 0u));
                    phi_401_ = false;
                } else {
                    phi_400_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_401_ = true;
                }
                let _e179 = phi_400_;
                let _e181 = phi_401_;
                phi_402_ = _e179;
                phi_403_ = _e181;
            } else {
                phi_402_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_403_ = true;
            }
            let _e183 = phi_402_;
            let _e185 = phi_403_;
            if _e185 {
                let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                phi_410_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, true);
            } else {
                phi_410_ = _e183;
            }
            let _e202 = phi_410_;
            phi_414_ = _e202;
        } else {
            let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
            phi_414_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
        }
        let _e219 = phi_414_;
        if _e219.unnamed_1 {
            phi_1148_ = evaluate_Verdict(_e219.unnamed.visibility, _e219.unnamed.is_doubted);
        } else {
            let _e227 = samples.member[_e61.first_primitive].position;
            let _e229 = p.member.map_size;
            let _e231 = (0.5f / f32(_e229));
            let _e238 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e245 = lt_math_LightPoint(vec2<f32>(_e238.uv.x, 0f), _e238.depth, _e238.is_inside);
            let _e249 = lt_math_LightPoint(_e245.uv, 0f, _e245.is_inside);
            phi_434_ = lt_math_LightPoint();
            phi_437_ = 0u;
            phi_439_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e249.uv, _e249.depth, false));
            loop {
                let _e256 = phi_434_;
                let _e258 = phi_437_;
                let _e260 = phi_439_;
                local_2 = _e260;
                local_3 = _e260;
                local_4 = _e260;
                if (_e258 < _e68) {
                    if _e260.point.is_inside {
                        phi_600_ = lt_math_LightPoint();
                        phi_601_ = u32();
                        phi_602_ = lt_math_LevelPoint();
                        phi_603_ = false;
                    } else {
                        if (_e258 < _e55) {
                        } else {
                            return;
                        }
                        let _e271 = levels.member[(0u + _e258)].row_w;
                        let _e282 = ((((_e271.x * _e227.x) + (_e271.y * _e227.y)) + (_e271.z * _e227.z)) + (_e271.w * 1f));
                        let _e284 = levels.member[(0u + _e258)].row_x;
                        let _e296 = (((((_e284.x * _e227.x) + (_e284.y * _e227.y)) + (_e284.z * _e227.z)) + (_e284.w * 1f)) / _e282);
                        let _e298 = levels.member[(0u + _e258)].row_y;
                        let _e310 = (((((_e298.x * _e227.x) + (_e298.y * _e227.y)) + (_e298.z * _e227.z)) + (_e298.w * 1f)) / _e282);
                        let _e312 = levels.member[(0u + _e258)].row_z;
                        let _e323 = ((((_e312.x * _e227.x) + (_e312.y * _e227.y)) + (_e312.z * _e227.z)) + (_e312.w * 1f));
                        if (_e282 > 0f) {
                            if (_e296 >= 0f) {
                                phi_525_ = (_e296 <= 1f);
                            } else {
                                phi_525_ = false;
                            }
                            let _e328 = phi_525_;
                            if _e328 {
                                if (_e310 >= 0f) {
                                    phi_534_ = (_e310 <= 1f);
                                } else {
                                    phi_534_ = false;
                                }
                                let _e332 = phi_534_;
                                if _e332 {
                                    if (_e323 >= 0f) {
                                        phi_543_ = (_e323 <= 1f);
                                    } else {
                                        phi_543_ = false;
                                    }
                                    let _e336 = phi_543_;
                                    phi_544_ = _e336;
                                    phi_545_ = false;
                                } else {
                                    phi_544_ = bool();
                                    phi_545_ = true;
                                }
                                let _e338 = phi_544_;
                                let _e340 = phi_545_;
                                phi_546_ = _e338;
                                phi_547_ = _e340;
                            } else {
                                phi_546_ = bool();
                                phi_547_ = true;
                            }
                            let _e342 = phi_546_;
                            let _e344 = phi_547_;
                            phi_548_ = _e342;
                            phi_549_ = _e344;
                        } else {
                            phi_548_ = bool();
                            phi_549_ = true;
                        }
                        let _e346 = phi_548_;
                        let _e348 = phi_549_;
                        if _e348 {
                            phi_553_ = false;
                        } else {
                            phi_553_ = _e346;
                        }
                        let _e350 = phi_553_;
                        if _e350 {
                            if (_e296 >= _e231) {
                                if (_e296 <= (1f - _e231)) {
                                    if (_e310 >= _e231) {
                                        phi_580_ = (_e310 <= (1f - _e231));
                                        phi_581_ = false;
                                    } else {
                                        phi_580_ = bool();
                                        phi_581_ = true;
                                    }
                                    let _e358 = phi_580_;
                                    let _e360 = phi_581_;
                                    phi_582_ = _e358;
                                    phi_583_ = _e360;
                                } else {
                                    phi_582_ = bool();
                                    phi_583_ = true;
                                }
                                let _e362 = phi_582_;
                                let _e364 = phi_583_;
                                phi_584_ = _e362;
                                phi_585_ = _e364;
                            } else {
                                phi_584_ = bool();
                                phi_585_ = true;
                            }
                            let _e366 = phi_584_;
                            let _e368 = phi_585_;
                            phi_586_ = _e366;
                            phi_587_ = _e368;
                        } else {
                            phi_586_ = bool();
                            phi_587_ = true;
                        }
                        let _e370 = phi_586_;
                        let _e372 = phi_587_;
                        if _e372 {
                            phi_591_ = false;
                        } else {
                            phi_591_ = _e370;
                        }
                        let _e374 = phi_591_;
                        let _e381 = lt_math_LightPoint(vec2<f32>(_e296, _e256.uv.y), _e256.depth, _e256.is_inside);
                        let _e388 = lt_math_LightPoint(vec2<f32>(_e381.uv.x, _e310), _e381.depth, _e381.is_inside);
                        let _e392 = lt_math_LightPoint(_e388.uv, _e323, _e388.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e392.depth, _e374);
                        phi_600_ = _e396;
                        phi_601_ = (_e258 + 1u);
                        phi_602_ = lt_math_LevelPoint(_e258, _e396);
                        phi_603_ = true;
                    }
                    let _e400 = phi_600_;
                    let _e402 = phi_601_;
                    let _e404 = phi_602_;
                    let _e406 = phi_603_;
                    phi_435_ = _e400;
                    phi_438_ = _e402;
                    phi_440_ = _e404;
                    phi_604_ = _e406;
                } else {
                    phi_435_ = lt_math_LightPoint();
                    phi_438_ = u32();
                    phi_440_ = lt_math_LevelPoint();
                    phi_604_ = false;
                }
                let _e408 = phi_435_;
                let _e410 = phi_438_;
                let _e412 = phi_440_;
                let _e414 = phi_604_;
                continue;
                continuing {
                    phi_434_ = _e408;
                    phi_437_ = _e410;
                    phi_439_ = _e412;
                    break if !(_e414);
                }
            }
            let _e417 = local_2;
            if _e417.point.is_inside {
                if (0f > 0f) {
                    let _e423 = local_3;
                    if (_e423.level < _e55) {
                    } else {
                        return;
                    }
                    let _e428 = levels.member[(0u + _e423.level)];
                    let _e434 = global[0u];
                    if (_e428.row_w.x == _e434) {
                        let _e437 = global[1u];
                        if (_e428.row_w.y == _e437) {
                            let _e440 = global[2u];
                            phi_644_ = (_e428.row_w.z == _e440);
                            phi_645_ = false;
                        } else {
                            phi_644_ = bool();
                            phi_645_ = true;
                        }
                        let _e443 = phi_644_;
                        let _e445 = phi_645_;
                        phi_646_ = _e443;
                        phi_647_ = _e445;
                    } else {
                        phi_646_ = bool();
                        phi_647_ = true;
                    }
                    let _e447 = phi_646_;
                    let _e449 = phi_647_;
                    if _e449 {
                        phi_651_ = false;
                    } else {
                        phi_651_ = _e447;
                    }
                    let _e451 = phi_651_;
                    if _e451 {
                        let _e453 = samples.member[_e61.first_primitive].normal;
                        let _e455 = p.member.map_size;
                        let _e525 = ((abs(((((_e428.row_x.x * _e453.x) + (_e428.row_x.y * _e453.y)) + (_e428.row_x.z * _e453.z)) / (((_e428.row_x.x * _e428.row_x.x) + (_e428.row_x.y * _e428.row_x.y)) + (_e428.row_x.z * _e428.row_x.z)))) + abs(((((_e428.row_y.x * _e453.x) + (_e428.row_y.y * _e453.y)) + (_e428.row_y.z * _e453.z)) / (((_e428.row_y.x * _e428.row_y.x) + (_e428.row_y.y * _e428.row_y.y)) + (_e428.row_y.z * _e428.row_y.z))))) / (abs(((((_e428.row_z.x * _e453.x) + (_e428.row_z.y * _e453.y)) + (_e428.row_z.z * _e453.z)) / (((_e428.row_z.x * _e428.row_z.x) + (_e428.row_z.y * _e428.row_z.y)) + (_e428.row_z.z * _e428.row_z.z)))) * f32(_e455)));
                        if (_e525 < 0.002f) {
                            phi_733_ = _e525;
                        } else {
                            phi_733_ = 0.002f;
                        }
                        let _e528 = phi_733_;
                        phi_850_ = _e528;
                    } else {
                        let _e530 = p.member.map_size;
                        let _e536 = samples.member[_e61.first_primitive].position;
                        let _e547 = ((((_e428.row_w.x * _e536.x) + (_e428.row_w.y * _e536.y)) + (_e428.row_w.z * _e536.z)) + _e428.row_w.w);
                        let _e560 = ((_e428.row_x.x - (_e428.row_w.x * _e417.point.uv.x)) / _e547);
                        let _e561 = ((_e428.row_x.y - (_e428.row_w.y * _e417.point.uv.x)) / _e547);
                        let _e562 = ((_e428.row_x.z - (_e428.row_w.z * _e417.point.uv.x)) / _e547);
                        let _e575 = ((_e428.row_y.x - (_e428.row_w.x * _e417.point.uv.y)) / _e547);
                        let _e576 = ((_e428.row_y.y - (_e428.row_w.y * _e417.point.uv.y)) / _e547);
                        let _e577 = ((_e428.row_y.z - (_e428.row_w.z * _e417.point.uv.y)) / _e547);
                        let _e583 = samples.member[_e61.first_primitive].normal;
                        let _e588 = ((_e576 * _e583.z) - (_e583.y * _e577));
                        let _e593 = ((_e577 * _e583.x) - (_e583.z * _e575));
                        let _e598 = ((_e575 * _e583.y) - (_e583.x * _e576));
                        let _e600 = samples.member[_e61.first_primitive].normal;
                        let _e605 = ((_e561 * _e600.z) - (_e600.y * _e562));
                        let _e610 = ((_e562 * _e600.x) - (_e600.z * _e560));
                        let _e615 = ((_e560 * _e600.y) - (_e600.x * _e561));
                        let _e642 = ((abs(((((_e428.row_z.x * _e588) + (_e428.row_z.y * _e593)) + (_e428.row_z.z * _e598)) / (((_e560 * _e588) + (_e561 * _e593)) + (_e562 * _e598)))) + abs(((((_e428.row_z.x * _e605) + (_e428.row_z.y * _e610)) + (_e428.row_z.z * _e615)) / (((_e575 * _e605) + (_e576 * _e610)) + (_e577 * _e615))))) / f32(_e530));
                        if (_e642 < 0.002f) {
                            phi_849_ = _e642;
                        } else {
                            phi_849_ = 0.002f;
                        }
                        let _e645 = phi_849_;
                        phi_850_ = _e645;
                    }
                    let _e647 = phi_850_;
                    phi_853_ = (_e417.point.depth - (0f * _e647));
                } else {
                    phi_853_ = _e417.point.depth;
                }
                let _e651 = phi_853_;
                let _e657 = p.member.map_size;
                let _e658 = f32(_e657);
                let _e661 = ((_e417.point.uv.x * _e658) - 0.5f);
                let _e662 = ((_e417.point.uv.y * _e658) - 0.5f);
                if (_e661 > -8388608f) {
                    let _e674 = f32(select(0i, select(select(i32(_e661), i32(-2147483648), (_e661 < bitcast<f32>(3472883712u))), 2147483647i, (_e661 > bitcast<f32>(1325400063u))), (_e661 == _e661)));
                    if (_e674 > _e661) {
                        phi_882_ = 1f;
                    } else {
                        phi_882_ = 0f;
                    }
                    let _e677 = phi_882_;
                    if (_e661 < 8388608f) {
                        phi_887_ = (_e674 - _e677);
                        phi_888_ = false;
                    } else {
                        phi_887_ = f32();
                        phi_888_ = true;
                    }
                    let _e680 = phi_887_;
                    let _e682 = phi_888_;
                    phi_889_ = _e680;
                    phi_890_ = _e682;
                } else {
                    phi_889_ = f32();
                    phi_890_ = true;
                }
                let _e684 = phi_889_;
                let _e686 = phi_890_;
                if _e686 {
                    phi_894_ = _e661;
                } else {
                    phi_894_ = _e684;
                }
                let _e688 = phi_894_;
                if (_e662 > -8388608f) {
                    let _e700 = f32(select(0i, select(select(i32(_e662), i32(-2147483648), (_e662 < bitcast<f32>(3472883712u))), 2147483647i, (_e662 > bitcast<f32>(1325400063u))), (_e662 == _e662)));
                    if (_e700 > _e662) {
                        phi_914_ = 1f;
                    } else {
                        phi_914_ = 0f;
                    }
                    let _e703 = phi_914_;
                    if (_e662 < 8388608f) {
                        phi_919_ = (_e700 - _e703);
                        phi_920_ = false;
                    } else {
                        phi_919_ = f32();
                        phi_920_ = true;
                    }
                    let _e706 = phi_919_;
                    let _e708 = phi_920_;
                    phi_921_ = _e706;
                    phi_922_ = _e708;
                } else {
                    phi_921_ = f32();
                    phi_922_ = true;
                }
                let _e710 = phi_921_;
                let _e712 = phi_922_;
                if _e712 {
                    phi_926_ = _e662;
                } else {
                    phi_926_ = _e710;
                }
                let _e714 = phi_926_;
                let _e715 = (_e661 - _e688);
                let _e716 = (_e662 - _e714);
                let _e725 = select(0i, select(select(i32(_e688), i32(-2147483648), (_e688 < bitcast<f32>(3472883712u))), 2147483647i, (_e688 > bitcast<f32>(1325400063u))), (_e688 == _e688));
                let _e734 = select(0i, select(select(i32(_e714), i32(-2147483648), (_e714 < bitcast<f32>(3472883712u))), 2147483647i, (_e714 > bitcast<f32>(1325400063u))), (_e714 == _e714));
                let _e737 = ((1f - _e715) * (1f - _e716));
                let _e739 = (_e715 * (1f - _e716));
                let _e741 = ((1f - _e715) * _e716);
                let _e742 = (_e715 * _e716);
                let _e744 = p.member.test;
                let _e745 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e744);
                let _e747 = p.member.map_size;
                let _e749 = local_4;
                local_1 = _e745;
                let _e752 = ((_e749.level * _e747) * _e747);
                let _e754 = (bitcast<i32>(_e747) - 1i);
                if (_e725 > 0i) {
                    phi_975_ = _e725;
                } else {
                    phi_975_ = 0i;
                }
                let _e757 = phi_975_;
                if (_e734 > 0i) {
                    phi_980_ = _e734;
                } else {
                    phi_980_ = 0i;
                }
                let _e760 = phi_980_;
                if (_e757 < _e754) {
                    phi_985_ = _e757;
                } else {
                    phi_985_ = _e754;
                }
                let _e763 = phi_985_;
                if (_e760 < _e754) {
                    phi_990_ = _e760;
                } else {
                    phi_990_ = _e754;
                }
                let _e766 = phi_990_;
                let _e767 = bitcast<u32>(_e763);
                let _e769 = (_e725 + 1i);
                let _e770 = (_e734 + 1i);
                if (_e769 > 0i) {
                    phi_999_ = _e769;
                } else {
                    phi_999_ = 0i;
                }
                let _e773 = phi_999_;
                if (_e770 > 0i) {
                    phi_1004_ = _e770;
                } else {
                    phi_1004_ = 0i;
                }
                let _e776 = phi_1004_;
                if (_e773 < _e754) {
                    phi_1009_ = _e773;
                } else {
                    phi_1009_ = _e754;
                }
                let _e779 = phi_1009_;
                if (_e776 < _e754) {
                    phi_1014_ = _e776;
                } else {
                    phi_1014_ = _e754;
                }
                let _e782 = phi_1014_;
                let _e783 = bitcast<u32>(_e779);
                let _e785 = (bitcast<u32>(_e766) * _e747);
                let _e786 = (bitcast<u32>(_e782) * _e747);
                let _e791 = ((_e785 + _e767) + _e752);
                let _e792 = ((_e785 + _e783) + _e752);
                let _e793 = ((_e786 + _e767) + _e752);
                let _e794 = ((_e786 + _e783) + _e752);
                if (_e791 < _e50) {
                } else {
                    return;
                }
                let _e798 = map.member[(0u + _e791)];
                if (_e792 < _e50) {
                } else {
                    return;
                }
                let _e810 = map.member[(0u + _e792)];
                if (_e793 < _e50) {
                } else {
                    return;
                }
                let _e826 = map.member[(0u + _e793)];
                if (_e794 < _e50) {
                } else {
                    return;
                }
                let _e842 = map.member[(0u + _e794)];
                let _e856 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e798.x * _e737) + (_e810.x * _e739)) + (_e826.x * _e741)) + (_e842.x * _e742)), ((((_e798.y * _e737) + (_e810.y * _e739)) + (_e826.y * _e741)) + (_e842.y * _e742)), ((((_e798.z * _e737) + (_e810.z * _e739)) + (_e826.z * _e741)) + (_e842.z * _e742)), ((((_e798.w * _e737) + (_e810.w * _e739)) + (_e826.w * _e741)) + (_e842.w * _e742))), _e651);
                let _e858 = p.member.epsilon;
                if (_e856 <= _e858) {
                    phi_1109_ = true;
                } else {
                    phi_1109_ = (_e856 >= (1f - _e858));
                }
                let _e863 = phi_1109_;
                if ((bitcast<u32>(_e856) & 2147483647u) > 2139095040u) {
                    phi_1117_ = true;
                } else {
                    phi_1117_ = !(_e863);
                }
                let _e869 = phi_1117_;
                if _e869 {
                    if (_e856 > 0f) {
                        if (_e856 < 1f) {
                            phi_1129_ = false;
                        } else {
                            phi_1129_ = true;
                        }
                        let _e873 = phi_1129_;
                        phi_1130_ = _e873;
                    } else {
                        phi_1130_ = true;
                    }
                    let _e875 = phi_1130_;
                    if _e875 {
                        phi_1134_ = 0.5f;
                    } else {
                        phi_1134_ = _e856;
                    }
                    let _e877 = phi_1134_;
                    phi_1142_ = evaluate_Verdict(_e877, true);
                } else {
                    if (_e856 > 0.5f) {
                        phi_1140_ = 1f;
                    } else {
                        phi_1140_ = 0f;
                    }
                    let _e881 = phi_1140_;
                    phi_1142_ = evaluate_Verdict(_e881, false);
                }
                let _e884 = phi_1142_;
                phi_1147_ = evaluate_Verdict(_e884.visibility, _e884.is_doubted);
            } else {
                phi_1147_ = evaluate_Verdict(0.5f, true);
            }
            let _e890 = phi_1147_;
            phi_1148_ = _e890;
        }
        let _e892 = phi_1148_;
        visibility.member[_e61.first_primitive] = _e892.visibility;
        phi_1152_ = _e892.is_doubted;
        phi_1153_ = _e61.first_primitive;
    } else {
        phi_1152_ = false;
        phi_1153_ = 0u;
    }
    let _e897 = phi_1152_;
    let _e899 = phi_1153_;
    if (_e45 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e897 {
        let _e903 = atomicAdd((&shared_[0u]), 1u);
        phi_1164_ = _e903;
    } else {
        phi_1164_ = 0u;
    }
    let _e905 = phi_1164_;
    workgroupBarrier();
    if (_e45 == 0u) {
        let _e909 = atomicLoad((&shared_[0u]));
        let _e910 = atomicAdd((&list.member[3u]), _e909);
        atomicStore((&shared_[1u]), _e910);
    }
    workgroupBarrier();
    if _e897 {
        let _e913 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e913) + _e905)]), _e899);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
