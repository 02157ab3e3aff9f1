struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct type_15 {
    member: array<abi_Sample>,
}

struct type_19 {
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

struct type_39 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_39;
@group(0) @binding(2) 
var<storage> map: type_31;

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
        let _e68 = phi_163_;
        let _e70 = phi_164_;
        phi_165_ = _e68;
        phi_166_ = _e70;
    } else {
        phi_165_ = lt_bvh_traverse_Tree();
        phi_166_ = true;
    }
    let _e72 = phi_165_;
    let _e74 = phi_166_;
    if _e74 {
        phi_171_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_171_ = _e72;
    }
    let _e79 = phi_171_;
    return lt_bvh_traverse_Tree(_e79.root, _e79.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_196_: f32;
    var phi_197_: f32;
    var phi_198_: f32;
    var phi_211_: bool;
    var phi_215_: f32;
    var phi_228_: f32;
    var phi_233_: f32;
    var phi_255_: f32;
    var phi_260_: f32;
    var phi_261_: bool;
    var phi_262_: f32;
    var phi_263_: bool;
    var phi_267_: f32;
    var phi_305_: f32;
    var phi_321_: f32;
    var phi_322_: f32;
    var phi_323_: f32;

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
            let _e64 = phi_196_;
            phi_197_ = _e64;
        }
        let _e66 = phi_197_;
        phi_198_ = _e66;
    }
    let _e68 = phi_198_;
    let _e70 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_211_ = true;
    } else {
        let _e74 = (84f < _e70);
        if _e74 {
        }
        phi_211_ = _e74;
    }
    let _e76 = phi_211_;
    if _e76 {
        phi_215_ = 84f;
    } else {
        phi_215_ = _e70;
    }
    let _e78 = phi_215_;
    let _e80 = (_e78 * (1f - _e68));
    if ((bitcast<u32>(_e80) & 2147483647u) > 2139095040u) {
        phi_305_ = _e80;
    } else {
        if (_e80 < -87f) {
            phi_228_ = -87f;
        } else {
            phi_228_ = _e80;
        }
        let _e86 = phi_228_;
        if (_e86 > 88f) {
            phi_233_ = 88f;
        } else {
            phi_233_ = _e86;
        }
        let _e89 = phi_233_;
        let _e91 = ((_e89 * 1.442695f) + 0.5f);
        if (_e91 > -8388608f) {
            let _e103 = f32(select(0i, select(select(i32(_e91), i32(-2147483648), (_e91 < bitcast<f32>(3472883712u))), 2147483647i, (_e91 > bitcast<f32>(1325400063u))), (_e91 == _e91)));
            if (_e103 > _e91) {
                phi_255_ = 1f;
            } else {
                phi_255_ = 0f;
            }
            let _e106 = phi_255_;
            if (_e91 < 8388608f) {
                phi_260_ = (_e103 - _e106);
                phi_261_ = false;
            } else {
                phi_260_ = f32();
                phi_261_ = true;
            }
            let _e109 = phi_260_;
            let _e111 = phi_261_;
            phi_262_ = _e109;
            phi_263_ = _e111;
        } else {
            phi_262_ = f32();
            phi_263_ = true;
        }
        let _e113 = phi_262_;
        let _e115 = phi_263_;
        if _e115 {
            phi_267_ = _e91;
        } else {
            phi_267_ = _e113;
        }
        let _e117 = phi_267_;
        let _e121 = ((_e89 - (_e117 * 0.69314575f)) - (_e117 * 0.0000014286068f));
        phi_305_ = ((((((((((((((((1f / 5040f) * _e121) + (1f / 720f)) * _e121) + (1f / 120f)) * _e121) + (1f / 24f)) * _e121) + (1f / 6f)) * _e121) + 0.5f) * _e121) + 1f) * _e121) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e117), i32(-2147483648), (_e117 < bitcast<f32>(3472883712u))), 2147483647i, (_e117 > bitcast<f32>(1325400063u))), (_e117 == _e117)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e157 = phi_305_;
    let _e158 = (param_5.x * _e157);
    if ((bitcast<u32>(_e158) & 2147483647u) > 2139095040u) {
        phi_323_ = _e158;
    } else {
        if (_e158 < 0f) {
            phi_322_ = 0f;
        } else {
            if (_e158 > 1f) {
                phi_321_ = 1f;
            } else {
                phi_321_ = _e158;
            }
            let _e165 = phi_321_;
            phi_322_ = _e165;
        }
        let _e167 = phi_322_;
        phi_323_ = _e167;
    }
    let _e169 = phi_323_;
    return _e169;
}

fn function_() {
    var local: f32;
    var phi_383_: bool;
    var phi_384_: bool;
    var phi_385_: bool;
    var phi_386_: bool;
    var phi_390_: bool;
    var phi_460_: bool;
    var phi_461_: bool;
    var phi_472_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_473_: bool;
    var phi_474_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_475_: bool;
    var phi_482_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_486_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_506_: lt_math_LightPoint;
    var phi_509_: u32;
    var phi_511_: lt_math_LevelPoint;
    var phi_597_: bool;
    var phi_606_: bool;
    var phi_615_: bool;
    var phi_616_: bool;
    var phi_617_: bool;
    var phi_618_: bool;
    var phi_619_: bool;
    var phi_620_: bool;
    var phi_621_: bool;
    var phi_625_: bool;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_663_: bool;
    var phi_672_: lt_math_LightPoint;
    var phi_673_: u32;
    var phi_674_: lt_math_LevelPoint;
    var phi_675_: bool;
    var phi_507_: lt_math_LightPoint;
    var phi_510_: u32;
    var phi_512_: lt_math_LevelPoint;
    var phi_676_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_716_: bool;
    var phi_717_: bool;
    var phi_718_: bool;
    var phi_719_: bool;
    var phi_723_: bool;
    var phi_805_: f32;
    var phi_923_: f32;
    var phi_924_: f32;
    var phi_927_: f32;
    var phi_956_: f32;
    var phi_961_: f32;
    var phi_962_: bool;
    var phi_963_: f32;
    var phi_964_: bool;
    var phi_968_: f32;
    var phi_988_: f32;
    var phi_993_: f32;
    var phi_994_: bool;
    var phi_995_: f32;
    var phi_996_: bool;
    var phi_1000_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1049_: i32;
    var phi_1054_: i32;
    var phi_1059_: i32;
    var phi_1064_: i32;
    var phi_1073_: i32;
    var phi_1078_: i32;
    var phi_1083_: i32;
    var phi_1088_: i32;
    var phi_1185_: bool;
    var phi_1193_: bool;
    var phi_1205_: bool;
    var phi_1206_: bool;
    var phi_1210_: f32;
    var phi_1216_: f32;
    var phi_1218_: evaluate_Verdict;
    var phi_1228_: u32;
    var phi_1237_: f32;
    var phi_1239_: evaluate_Verdict;
    var phi_1240_: bool;
    var phi_1241_: evaluate_Verdict;
    var phi_1242_: bool;
    var phi_1247_: evaluate_Verdict;
    var phi_1252_: evaluate_Verdict;
    var phi_1253_: evaluate_Verdict;

    let _e56 = id_1;
    let _e63 = arrayLength((&map.member));
    let _e69 = arrayLength((&levels.member));
    let _e72 = p.member.size[0u];
    let _e74 = p.member.size[1u];
    let _e75 = lt_shaders_entry_pixel_index(_e56, _e72, _e74);
    if (bitcast<i32>(_e75.root) != 0i) {
        let _e81 = p.member.level_count;
        if (_e75.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e88 = samples.member[(0u + _e75.first_primitive)].normal[0u];
        let _e90 = global[0u];
        if (_e88 == _e90) {
            let _e93 = samples.member[(0u + _e75.first_primitive)].normal[1u];
            let _e95 = global[1u];
            if (_e93 == _e95) {
                let _e98 = samples.member[(0u + _e75.first_primitive)].normal[2u];
                let _e100 = global[2u];
                phi_383_ = (_e98 == _e100);
                phi_384_ = false;
            } else {
                phi_383_ = bool();
                phi_384_ = true;
            }
            let _e103 = phi_383_;
            let _e105 = phi_384_;
            phi_385_ = _e103;
            phi_386_ = _e105;
        } else {
            phi_385_ = bool();
            phi_386_ = true;
        }
        let _e107 = phi_385_;
        let _e109 = phi_386_;
        if _e109 {
            phi_390_ = false;
        } else {
            phi_390_ = _e107;
        }
        let _e111 = phi_390_;
        if !(_e111) {
            let _e114 = samples.member[(0u + _e75.first_primitive)].position;
            let _e116 = p.member.light.place;
            let _e122 = p.member.light.place[3u];
            let _e129 = (_e116.x - (_e114.x * _e122));
            let _e130 = (_e116.y - (_e114.y * _e122));
            let _e131 = (_e116.z - (_e114.z * _e122));
            let _e133 = samples.member[(0u + _e75.first_primitive)].normal;
            if ((((_e133.x * _e129) + (_e133.y * _e130)) + (_e133.z * _e131)) > 0f) {
                let _e147 = (((_e129 * _e129) + (_e130 * _e130)) + (_e131 * _e131));
                let _e149 = p.member.light.axis;
                let _e161 = p.member.light.place[3u];
                if (_e161 == 0f) {
                    phi_461_ = true;
                } else {
                    let _e164 = p.member.light.range_squared;
                    if (_e147 <= _e164) {
                        let _e167 = p.member.light.cos_outer;
                        phi_460_ = (-((((_e129 * _e149.x) + (_e130 * _e149.y)) + (_e131 * _e149.z))) >= (_e167 * sqrt(_e147)));
                    } else {
                        phi_460_ = false;
                    }
                    let _e172 = phi_460_;
                    phi_461_ = _e172;
                }
                let _e174 = phi_461_;
                if _e174 {
                    let _e176 = samples.member[(0u + _e75.first_primitive)].flags;
                    let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e184.unnamed.visibility, false), _e184.unnamed_1);
                    phi_472_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e190.unnamed, ((_e176 & 1u) == 0u));
                    phi_473_ = false;
                } else {
                    phi_472_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_473_ = true;
                }
                let _e195 = phi_472_;
                let _e197 = phi_473_;
                phi_474_ = _e195;
                phi_475_ = _e197;
            } else {
                phi_474_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_475_ = true;
            }
            let _e199 = phi_474_;
            let _e201 = phi_475_;
            if _e201 {
                let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e207.unnamed.visibility, false), _e207.unnamed_1);
                phi_482_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e213.unnamed, true);
            } else {
                phi_482_ = _e199;
            }
            let _e218 = phi_482_;
            phi_486_ = _e218;
        } else {
            let _e224 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e230 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e224.unnamed.visibility, false), _e224.unnamed_1);
            phi_486_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e230.unnamed, true);
        }
        let _e235 = phi_486_;
        if _e235.unnamed_1 {
            phi_1253_ = evaluate_Verdict(_e235.unnamed.visibility, _e235.unnamed.is_doubted);
        } else {
            let _e243 = samples.member[(0u + _e75.first_primitive)].position;
            let _e245 = p.member.map_size;
            let _e247 = (0.5f / f32(_e245));
            let _e254 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e261 = lt_math_LightPoint(vec2<f32>(_e254.uv.x, 0f), _e254.depth, _e254.is_inside);
            let _e265 = lt_math_LightPoint(_e261.uv, 0f, _e261.is_inside);
            phi_506_ = lt_math_LightPoint();
            phi_509_ = 0u;
            phi_511_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e265.uv, _e265.depth, false));
            loop {
                let _e272 = phi_506_;
                let _e274 = phi_509_;
                let _e276 = phi_511_;
                local_1 = _e276;
                local_2 = _e276;
                local_3 = _e276;
                if (_e274 < _e81) {
                    if _e276.point.is_inside {
                        phi_672_ = lt_math_LightPoint();
                        phi_673_ = u32();
                        phi_674_ = lt_math_LevelPoint();
                        phi_675_ = false;
                    } else {
                        if (_e274 < _e69) {
                        } else {
                            return;
                        }
                        let _e287 = levels.member[(0u + _e274)].row_w;
                        let _e298 = ((((_e287.x * _e243.x) + (_e287.y * _e243.y)) + (_e287.z * _e243.z)) + (_e287.w * 1f));
                        let _e300 = levels.member[(0u + _e274)].row_x;
                        let _e312 = (((((_e300.x * _e243.x) + (_e300.y * _e243.y)) + (_e300.z * _e243.z)) + (_e300.w * 1f)) / _e298);
                        let _e314 = levels.member[(0u + _e274)].row_y;
                        let _e326 = (((((_e314.x * _e243.x) + (_e314.y * _e243.y)) + (_e314.z * _e243.z)) + (_e314.w * 1f)) / _e298);
                        let _e328 = levels.member[(0u + _e274)].row_z;
                        let _e339 = ((((_e328.x * _e243.x) + (_e328.y * _e243.y)) + (_e328.z * _e243.z)) + (_e328.w * 1f));
                        if (_e298 > 0f) {
                            if (_e312 >= 0f) {
                                phi_597_ = (_e312 <= 1f);
                            } else {
                                phi_597_ = false;
                            }
                            let _e344 = phi_597_;
                            if _e344 {
                                if (_e326 >= 0f) {
                                    phi_606_ = (_e326 <= 1f);
                                } else {
                                    phi_606_ = false;
                                }
                                let _e348 = phi_606_;
                                if _e348 {
                                    if (_e339 >= 0f) {
                                        phi_615_ = (_e339 <= 1f);
                                    } else {
                                        phi_615_ = false;
                                    }
                                    let _e352 = phi_615_;
                                    phi_616_ = _e352;
                                    phi_617_ = false;
                                } else {
                                    phi_616_ = bool();
                                    phi_617_ = true;
                                }
                                let _e354 = phi_616_;
                                let _e356 = phi_617_;
                                phi_618_ = _e354;
                                phi_619_ = _e356;
                            } else {
                                phi_618_ = bool();
                                phi_619_ = true;
                            }
                            let _e358 = phi_618_;
                            let _e360 = phi_619_;
                            phi_620_ = _e358;
                            phi_621_ = _e360;
                        } else {
                            phi_620_ = bool();
                            phi_621_ = true;
                        }
                        let _e362 = phi_620_;
                        let _e364 = phi_621_;
                        if _e364 {
                            phi_625_ = false;
                        } else {
                            phi_625_ = _e362;
                        }
                        let _e366 = phi_625_;
                        if _e366 {
                            if (_e312 >= _e247) {
                                if (_e312 <= (1f - _e247)) {
                                    if (_e326 >= _e247) {
                                        phi_652_ = (_e326 <= (1f - _e247));
                                        phi_653_ = false;
                                    } else {
                                        phi_652_ = bool();
                                        phi_653_ = true;
                                    }
                                    let _e374 = phi_652_;
                                    let _e376 = phi_653_;
                                    phi_654_ = _e374;
                                    phi_655_ = _e376;
                                } else {
                                    phi_654_ = bool();
                                    phi_655_ = true;
                                }
                                let _e378 = phi_654_;
                                let _e380 = phi_655_;
                                phi_656_ = _e378;
                                phi_657_ = _e380;
                            } else {
                                phi_656_ = bool();
                                phi_657_ = true;
                            }
                            let _e382 = phi_656_;
                            let _e384 = phi_657_;
                            phi_658_ = _e382;
                            phi_659_ = _e384;
                        } else {
                            phi_658_ = bool();
                            phi_659_ = true;
                        }
                        let _e386 = phi_658_;
                        let _e388 = phi_659_;
                        if _e388 {
                            phi_663_ = false;
                        } else {
                            phi_663_ = _e386;
                        }
                        let _e390 = phi_663_;
                        let _e397 = lt_math_LightPoint(vec2<f32>(_e312, _e272.uv.y), _e272.depth, _e272.is_inside);
                        let _e404 = lt_math_LightPoint(vec2<f32>(_e397.uv.x, _e326), _e397.depth, _e397.is_inside);
                        let _e408 = lt_math_LightPoint(_e404.uv, _e339, _e404.is_inside);
                        let _e412 = lt_math_LightPoint(_e408.uv, _e408.depth, _e390);
                        phi_672_ = _e412;
                        phi_673_ = (_e274 + 1u);
                        phi_674_ = lt_math_LevelPoint(_e274, _e412);
                        phi_675_ = true;
                    }
                    let _e416 = phi_672_;
                    let _e418 = phi_673_;
                    let _e420 = phi_674_;
                    let _e422 = phi_675_;
                    phi_507_ = _e416;
                    phi_510_ = _e418;
                    phi_512_ = _e420;
                    phi_676_ = _e422;
                } else {
                    phi_507_ = lt_math_LightPoint();
                    phi_510_ = u32();
                    phi_512_ = lt_math_LevelPoint();
                    phi_676_ = false;
                }
                let _e424 = phi_507_;
                let _e426 = phi_510_;
                let _e428 = phi_512_;
                let _e430 = phi_676_;
                continue;
                continuing {
                    phi_506_ = _e424;
                    phi_509_ = _e426;
                    phi_511_ = _e428;
                    break if !(_e430);
                }
            }
            let _e433 = local_1;
            if _e433.point.is_inside {
                if (0f > 0f) {
                    let _e439 = local_2;
                    if (_e439.level < _e69) {
                    } else {
                        return;
                    }
                    let _e444 = levels.member[(0u + _e439.level)];
                    let _e450 = global[0u];
                    if (_e444.row_w.x == _e450) {
                        let _e453 = global[1u];
                        if (_e444.row_w.y == _e453) {
                            let _e456 = global[2u];
                            phi_716_ = (_e444.row_w.z == _e456);
                            phi_717_ = false;
                        } else {
                            phi_716_ = bool();
                            phi_717_ = true;
                        }
                        let _e459 = phi_716_;
                        let _e461 = phi_717_;
                        phi_718_ = _e459;
                        phi_719_ = _e461;
                    } else {
                        phi_718_ = bool();
                        phi_719_ = true;
                    }
                    let _e463 = phi_718_;
                    let _e465 = phi_719_;
                    if _e465 {
                        phi_723_ = false;
                    } else {
                        phi_723_ = _e463;
                    }
                    let _e467 = phi_723_;
                    if _e467 {
                        let _e469 = samples.member[(0u + _e75.first_primitive)].normal;
                        let _e471 = p.member.map_size;
                        let _e541 = ((abs(((((_e444.row_x.x * _e469.x) + (_e444.row_x.y * _e469.y)) + (_e444.row_x.z * _e469.z)) / (((_e444.row_x.x * _e444.row_x.x) + (_e444.row_x.y * _e444.row_x.y)) + (_e444.row_x.z * _e444.row_x.z)))) + abs(((((_e444.row_y.x * _e469.x) + (_e444.row_y.y * _e469.y)) + (_e444.row_y.z * _e469.z)) / (((_e444.row_y.x * _e444.row_y.x) + (_e444.row_y.y * _e444.row_y.y)) + (_e444.row_y.z * _e444.row_y.z))))) / (abs(((((_e444.row_z.x * _e469.x) + (_e444.row_z.y * _e469.y)) + (_e444.row_z.z * _e469.z)) / (((_e444.row_z.x * _e444.row_z.x) + (_e444.row_z.y * _e444.row_z.y)) + (_e444.row_z.z * _e444.row_z.z)))) * f32(_e471)));
                        if (_e541 < 0.002f) {
                            phi_805_ = _e541;
                        } else {
                            phi_805_ = 0.002f;
                        }
                        let _e544 = phi_805_;
                        phi_924_ = _e544;
                    } else {
                        let _e546 = p.member.map_size;
                        let _e552 = samples.member[(0u + _e75.first_primitive)].position;
                        let _e563 = ((((_e444.row_w.x * _e552.x) + (_e444.row_w.y * _e552.y)) + (_e444.row_w.z * _e552.z)) + _e444.row_w.w);
                        let _e576 = ((_e444.row_x.x - (_e444.row_w.x * _e433.point.uv.x)) / _e563);
                        let _e577 = ((_e444.row_x.y - (_e444.row_w.y * _e433.point.uv.x)) / _e563);
                        let _e578 = ((_e444.row_x.z - (_e444.row_w.z * _e433.point.uv.x)) / _e563);
                        let _e591 = ((_e444.row_y.x - (_e444.row_w.x * _e433.point.uv.y)) / _e563);
                        let _e592 = ((_e444.row_y.y - (_e444.row_w.y * _e433.point.uv.y)) / _e563);
                        let _e593 = ((_e444.row_y.z - (_e444.row_w.z * _e433.point.uv.y)) / _e563);
                        let _e599 = samples.member[(0u + _e75.first_primitive)].normal;
                        let _e604 = ((_e592 * _e599.z) - (_e599.y * _e593));
                        let _e609 = ((_e593 * _e599.x) - (_e599.z * _e591));
                        let _e614 = ((_e591 * _e599.y) - (_e599.x * _e592));
                        let _e616 = samples.member[(0u + _e75.first_primitive)].normal;
                        let _e621 = ((_e577 * _e616.z) - (_e616.y * _e578));
                        let _e626 = ((_e578 * _e616.x) - (_e616.z * _e576));
                        let _e631 = ((_e576 * _e616.y) - (_e616.x * _e577));
                        let _e658 = ((abs(((((_e444.row_z.x * _e604) + (_e444.row_z.y * _e609)) + (_e444.row_z.z * _e614)) / (((_e576 * _e604) + (_e577 * _e609)) + (_e578 * _e614)))) + abs(((((_e444.row_z.x * _e621) + (_e444.row_z.y * _e626)) + (_e444.row_z.z * _e631)) / (((_e591 * _e621) + (_e592 * _e626)) + (_e593 * _e631))))) / f32(_e546));
                        let _e660 = (16f / f32(_e546));
                        if (_e658 < _e660) {
                            phi_923_ = _e658;
                        } else {
                            phi_923_ = _e660;
                        }
                        let _e663 = phi_923_;
                        phi_924_ = _e663;
                    }
                    let _e665 = phi_924_;
                    phi_927_ = (_e433.point.depth - (0f * _e665));
                } else {
                    phi_927_ = _e433.point.depth;
                }
                let _e669 = phi_927_;
                let _e675 = p.member.map_size;
                let _e676 = f32(_e675);
                let _e679 = ((_e433.point.uv.x * _e676) - 0.5f);
                let _e680 = ((_e433.point.uv.y * _e676) - 0.5f);
                if (_e679 > -8388608f) {
                    let _e692 = f32(select(0i, select(select(i32(_e679), i32(-2147483648), (_e679 < bitcast<f32>(3472883712u))), 2147483647i, (_e679 > bitcast<f32>(1325400063u))), (_e679 == _e679)));
                    if (_e692 > _e679) {
                        phi_956_ = 1f;
                    } else {
                        phi_956_ = 0f;
                    }
                    let _e695 = phi_956_;
                    if (_e679 < 8388608f) {
                        phi_961_ = (_e692 - _e695);
                        phi_962_ = false;
                    } else {
                        phi_961_ = f32();
                        phi_962_ = true;
                    }
                    let _e698 = phi_961_;
                    let _e700 = phi_962_;
                    phi_963_ = _e698;
                    phi_964_ = _e700;
                } else {
                    phi_963_ = f32();
                    phi_964_ = true;
                }
                let _e702 = phi_963_;
                let _e704 = phi_964_;
                if _e704 {
                    phi_968_ = _e679;
                } else {
                    phi_968_ = _e702;
                }
                let _e706 = phi_968_;
                if (_e680 > -8388608f) {
                    let _e718 = f32(select(0i, select(select(i32(_e680), i32(-2147483648), (_e680 < bitcast<f32>(3472883712u))), 2147483647i, (_e680 > bitcast<f32>(1325400063u))), (_e680 == _e680)));
                    if (_e718 > _e680) {
                        phi_988_ = 1f;
                    } else {
                        phi_988_ = 0f;
                    }
                    let _e721 = phi_988_;
                    if (_e680 < 8388608f) {
                        phi_993_ = (_e718 - _e721);
                        phi_994_ = false;
                    } else {
                        phi_993_ = f32();
                        phi_994_ = true;
                    }
                    let _e724 = phi_993_;
                    let _e726 = phi_994_;
                    phi_995_ = _e724;
                    phi_996_ = _e726;
                } else {
                    phi_995_ = f32();
                    phi_996_ = true;
                }
                let _e728 = phi_995_;
                let _e730 = phi_996_;
                if _e730 {
                    phi_1000_ = _e680;
                } else {
                    phi_1000_ = _e728;
                }
                let _e732 = phi_1000_;
                let _e733 = (_e679 - _e706);
                let _e734 = (_e680 - _e732);
                let _e743 = select(0i, select(select(i32(_e706), i32(-2147483648), (_e706 < bitcast<f32>(3472883712u))), 2147483647i, (_e706 > bitcast<f32>(1325400063u))), (_e706 == _e706));
                let _e752 = select(0i, select(select(i32(_e732), i32(-2147483648), (_e732 < bitcast<f32>(3472883712u))), 2147483647i, (_e732 > bitcast<f32>(1325400063u))), (_e732 == _e732));
                let _e755 = ((1f - _e733) * (1f - _e734));
                let _e757 = (_e733 * (1f - _e734));
                let _e759 = ((1f - _e733) * _e734);
                let _e760 = (_e733 * _e734);
                let _e762 = p.member.test;
                let _e763 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e762);
                let _e765 = p.member.map_size;
                let _e767 = local_3;
                local = _e763;
                let _e770 = ((_e767.level * _e765) * _e765);
                let _e772 = (bitcast<i32>(_e765) - 1i);
                if (_e743 > 0i) {
                    phi_1049_ = _e743;
                } else {
                    phi_1049_ = 0i;
                }
                let _e775 = phi_1049_;
                if (_e752 > 0i) {
                    phi_1054_ = _e752;
                } else {
                    phi_1054_ = 0i;
                }
                let _e778 = phi_1054_;
                if (_e775 < _e772) {
                    phi_1059_ = _e775;
                } else {
                    phi_1059_ = _e772;
                }
                let _e781 = phi_1059_;
                if (_e778 < _e772) {
                    phi_1064_ = _e778;
                } else {
                    phi_1064_ = _e772;
                }
                let _e784 = phi_1064_;
                let _e785 = bitcast<u32>(_e781);
                let _e787 = (_e743 + 1i);
                let _e788 = (_e752 + 1i);
                if (_e787 > 0i) {
                    phi_1073_ = _e787;
                } else {
                    phi_1073_ = 0i;
                }
                let _e791 = phi_1073_;
                if (_e788 > 0i) {
                    phi_1078_ = _e788;
                } else {
                    phi_1078_ = 0i;
                }
                let _e794 = phi_1078_;
                if (_e791 < _e772) {
                    phi_1083_ = _e791;
                } else {
                    phi_1083_ = _e772;
                }
                let _e797 = phi_1083_;
                if (_e794 < _e772) {
                    phi_1088_ = _e794;
                } else {
                    phi_1088_ = _e772;
                }
                let _e800 = phi_1088_;
                let _e801 = bitcast<u32>(_e797);
                let _e803 = (bitcast<u32>(_e784) * _e765);
                let _e804 = (bitcast<u32>(_e800) * _e765);
                let _e809 = ((_e803 + _e785) + _e770);
                let _e810 = ((_e803 + _e801) + _e770);
                let _e811 = ((_e804 + _e785) + _e770);
                let _e812 = ((_e804 + _e801) + _e770);
                if (_e809 < _e63) {
                } else {
                    return;
                }
                let _e816 = map.member[(0u + _e809)];
                if (_e810 < _e63) {
                } else {
                    return;
                }
                let _e828 = map.member[(0u + _e810)];
                if (_e811 < _e63) {
                } else {
                    return;
                }
                let _e844 = map.member[(0u + _e811)];
                if (_e812 < _e63) {
                } else {
                    return;
                }
                let _e860 = map.member[(0u + _e812)];
                let _e874 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e816.x * _e755) + (_e828.x * _e757)) + (_e844.x * _e759)) + (_e860.x * _e760)), ((((_e816.y * _e755) + (_e828.y * _e757)) + (_e844.y * _e759)) + (_e860.y * _e760)), ((((_e816.z * _e755) + (_e828.z * _e757)) + (_e844.z * _e759)) + (_e860.z * _e760)), ((((_e816.w * _e755) + (_e828.w * _e757)) + (_e844.w * _e759)) + (_e860.w * _e760))), _e669);
                let _e878 = p.member.epsilon;
                if (_e874 <= _e878) {
                    phi_1185_ = true;
                } else {
                    phi_1185_ = (_e874 >= (1f - _e878));
                }
                let _e883 = phi_1185_;
                if ((bitcast<u32>(_e874) & 2147483647u) > 2139095040u) {
                    phi_1193_ = true;
                } else {
                    phi_1193_ = !(_e883);
                }
                let _e889 = phi_1193_;
                if _e889 {
                    if (_e874 > 0f) {
                        if (_e874 < 1f) {
                            phi_1205_ = false;
                        } else {
                            phi_1205_ = true;
                        }
                        let _e893 = phi_1205_;
                        phi_1206_ = _e893;
                    } else {
                        phi_1206_ = true;
                    }
                    let _e895 = phi_1206_;
                    if _e895 {
                        phi_1210_ = 0.5f;
                    } else {
                        phi_1210_ = _e874;
                    }
                    let _e897 = phi_1210_;
                    phi_1218_ = evaluate_Verdict(_e897, true);
                } else {
                    if (_e874 > 0.5f) {
                        phi_1216_ = 1f;
                    } else {
                        phi_1216_ = 0f;
                    }
                    let _e901 = phi_1216_;
                    phi_1218_ = evaluate_Verdict(_e901, false);
                }
                let _e904 = phi_1218_;
                let _e907 = (_e904.visibility < 0.5f);
                if _e904.is_doubted {
                    phi_1241_ = evaluate_Verdict();
                    phi_1242_ = true;
                } else {
                    if _e907 {
                        phi_1228_ = 2u;
                    } else {
                        phi_1228_ = 1u;
                    }
                    let _e909 = phi_1228_;
                    if ((0u & _e909) != 0u) {
                        if _e907 {
                            phi_1237_ = 0.000000059604645f;
                        } else {
                            phi_1237_ = 0.99999994f;
                        }
                        let _e913 = phi_1237_;
                        phi_1239_ = evaluate_Verdict(_e913, true);
                        phi_1240_ = false;
                    } else {
                        phi_1239_ = evaluate_Verdict();
                        phi_1240_ = true;
                    }
                    let _e916 = phi_1239_;
                    let _e918 = phi_1240_;
                    phi_1241_ = _e916;
                    phi_1242_ = _e918;
                }
                let _e920 = phi_1241_;
                let _e922 = phi_1242_;
                if _e922 {
                    phi_1247_ = evaluate_Verdict(_e904.visibility, _e904.is_doubted);
                } else {
                    phi_1247_ = _e920;
                }
                let _e925 = phi_1247_;
                phi_1252_ = evaluate_Verdict(_e925.visibility, _e925.is_doubted);
            } else {
                phi_1252_ = evaluate_Verdict(0.5f, true);
            }
            let _e931 = phi_1252_;
            phi_1253_ = _e931;
        }
        let _e933 = phi_1253_;
        if (_e75.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e75.first_primitive)] = _e933.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
