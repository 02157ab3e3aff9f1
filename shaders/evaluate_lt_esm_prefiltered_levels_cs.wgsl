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

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_160_: lt_bvh_traverse_Tree;
    var phi_161_: bool;
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_168_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_160_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_161_ = false;
        } else {
            phi_160_ = lt_bvh_traverse_Tree();
            phi_161_ = true;
        }
        let _e64 = phi_160_;
        let _e66 = phi_161_;
        phi_162_ = _e64;
        phi_163_ = _e66;
    } else {
        phi_162_ = lt_bvh_traverse_Tree();
        phi_163_ = true;
    }
    let _e68 = phi_162_;
    let _e70 = phi_163_;
    if _e70 {
        phi_168_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_168_ = _e68;
    }
    let _e75 = phi_168_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_188_: bool;
    var phi_192_: f32;

    let _e52 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_188_ = true;
    } else {
        let _e56 = (84f < _e52);
        if _e56 {
        }
        phi_188_ = _e56;
    }
    let _e58 = phi_188_;
    if _e58 {
        phi_192_ = 84f;
    } else {
        phi_192_ = _e52;
    }
    let _e60 = phi_192_;
    return _e60;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_213_: f32;
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

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_213_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_212_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_211_ = 1f;
            } else {
                phi_211_ = param_7;
            }
            let _e60 = phi_211_;
            phi_212_ = _e60;
        }
        let _e62 = phi_212_;
        phi_213_ = _e62;
    }
    let _e64 = phi_213_;
    let _e66 = _lt_math_esm_Esm_clamped_exponent(param_5);
    let _e68 = (_e66 * (1f - _e64));
    if ((bitcast<u32>(_e68) & 2147483647u) > 2139095040u) {
        phi_305_ = _e68;
    } else {
        if (_e68 < -87f) {
            phi_228_ = -87f;
        } else {
            phi_228_ = _e68;
        }
        let _e74 = phi_228_;
        if (_e74 > 88f) {
            phi_233_ = 88f;
        } else {
            phi_233_ = _e74;
        }
        let _e77 = phi_233_;
        let _e79 = ((_e77 * 1.442695f) + 0.5f);
        if (_e79 > -8388608f) {
            let _e91 = f32(select(0i, select(select(i32(_e79), i32(-2147483648), (_e79 < bitcast<f32>(3472883712u))), 2147483647i, (_e79 > bitcast<f32>(1325400063u))), (_e79 == _e79)));
            if (_e91 > _e79) {
                phi_255_ = 1f;
            } else {
                phi_255_ = 0f;
            }
            let _e94 = phi_255_;
            if (_e79 < 8388608f) {
                phi_260_ = (_e91 - _e94);
                phi_261_ = false;
            } else {
                phi_260_ = f32();
                phi_261_ = true;
            }
            let _e97 = phi_260_;
            let _e99 = phi_261_;
            phi_262_ = _e97;
            phi_263_ = _e99;
        } else {
            phi_262_ = f32();
            phi_263_ = true;
        }
        let _e101 = phi_262_;
        let _e103 = phi_263_;
        if _e103 {
            phi_267_ = _e79;
        } else {
            phi_267_ = _e101;
        }
        let _e105 = phi_267_;
        let _e109 = ((_e77 - (_e105 * 0.69314575f)) - (_e105 * 0.0000014286068f));
        phi_305_ = ((((((((((((((((1f / 5040f) * _e109) + (1f / 720f)) * _e109) + (1f / 120f)) * _e109) + (1f / 24f)) * _e109) + (1f / 6f)) * _e109) + 0.5f) * _e109) + 1f) * _e109) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e105), i32(-2147483648), (_e105 < bitcast<f32>(3472883712u))), 2147483647i, (_e105 > bitcast<f32>(1325400063u))), (_e105 == _e105)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e145 = phi_305_;
    let _e146 = (param_6.x * _e145);
    if ((bitcast<u32>(_e146) & 2147483647u) > 2139095040u) {
        phi_323_ = _e146;
    } else {
        if (_e146 < 0f) {
            phi_322_ = 0f;
        } else {
            if (_e146 > 1f) {
                phi_321_ = 1f;
            } else {
                phi_321_ = _e146;
            }
            let _e153 = phi_321_;
            phi_322_ = _e153;
        }
        let _e155 = phi_322_;
        phi_323_ = _e155;
    }
    let _e157 = phi_323_;
    return _e157;
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
    var phi_921_: f32;
    var phi_922_: f32;
    var phi_925_: f32;
    var phi_954_: f32;
    var phi_959_: f32;
    var phi_960_: bool;
    var phi_961_: f32;
    var phi_962_: bool;
    var phi_966_: f32;
    var phi_986_: f32;
    var phi_991_: f32;
    var phi_992_: bool;
    var phi_993_: f32;
    var phi_994_: bool;
    var phi_998_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1047_: i32;
    var phi_1052_: i32;
    var phi_1057_: i32;
    var phi_1062_: i32;
    var phi_1071_: i32;
    var phi_1076_: i32;
    var phi_1081_: i32;
    var phi_1086_: i32;
    var phi_1181_: bool;
    var phi_1189_: bool;
    var phi_1201_: bool;
    var phi_1202_: bool;
    var phi_1206_: f32;
    var phi_1212_: f32;
    var phi_1214_: evaluate_Verdict;
    var phi_1219_: evaluate_Verdict;
    var phi_1220_: evaluate_Verdict;

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
        let _e84 = samples.member[(0u + _e71.first_primitive)].normal[0u];
        let _e86 = global[0u];
        if (_e84 == _e86) {
            let _e89 = samples.member[(0u + _e71.first_primitive)].normal[1u];
            let _e91 = global[1u];
            if (_e89 == _e91) {
                let _e94 = samples.member[(0u + _e71.first_primitive)].normal[2u];
                let _e96 = global[2u];
                phi_383_ = (_e94 == _e96);
                phi_384_ = false;
            } else {
                phi_383_ = bool();
                phi_384_ = true;
            }
            let _e99 = phi_383_;
            let _e101 = phi_384_;
            phi_385_ = _e99;
            phi_386_ = _e101;
        } else {
            phi_385_ = bool();
            phi_386_ = true;
        }
        let _e103 = phi_385_;
        let _e105 = phi_386_;
        if _e105 {
            phi_390_ = false;
        } else {
            phi_390_ = _e103;
        }
        let _e107 = phi_390_;
        if !(_e107) {
            let _e110 = samples.member[(0u + _e71.first_primitive)].position;
            let _e112 = p.member.light.place;
            let _e118 = p.member.light.place[3u];
            let _e125 = (_e112.x - (_e110.x * _e118));
            let _e126 = (_e112.y - (_e110.y * _e118));
            let _e127 = (_e112.z - (_e110.z * _e118));
            let _e129 = samples.member[(0u + _e71.first_primitive)].normal;
            if ((((_e129.x * _e125) + (_e129.y * _e126)) + (_e129.z * _e127)) > 0f) {
                let _e143 = (((_e125 * _e125) + (_e126 * _e126)) + (_e127 * _e127));
                let _e145 = p.member.light.axis;
                let _e157 = p.member.light.place[3u];
                if (_e157 == 0f) {
                    phi_461_ = true;
                } else {
                    let _e160 = p.member.light.range_squared;
                    if (_e143 <= _e160) {
                        let _e163 = p.member.light.cos_outer;
                        phi_460_ = (-((((_e125 * _e145.x) + (_e126 * _e145.y)) + (_e127 * _e145.z))) >= (_e163 * sqrt(_e143)));
                    } else {
                        phi_460_ = false;
                    }
                    let _e168 = phi_460_;
                    phi_461_ = _e168;
                }
                let _e170 = phi_461_;
                if _e170 {
                    let _e172 = samples.member[(0u + _e71.first_primitive)].flags;
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e180.unnamed.visibility, false), _e180.unnamed_1);
                    phi_472_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e186.unnamed, ((_e172 & 1u) == 0u));
                    phi_473_ = false;
                } else {
                    phi_472_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_473_ = true;
                }
                let _e191 = phi_472_;
                let _e193 = phi_473_;
                phi_474_ = _e191;
                phi_475_ = _e193;
            } else {
                phi_474_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_475_ = true;
            }
            let _e195 = phi_474_;
            let _e197 = phi_475_;
            if _e197 {
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e203.unnamed.visibility, false), _e203.unnamed_1);
                phi_482_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e209.unnamed, true);
            } else {
                phi_482_ = _e195;
            }
            let _e214 = phi_482_;
            phi_486_ = _e214;
        } else {
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e226 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e220.unnamed.visibility, false), _e220.unnamed_1);
            phi_486_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e226.unnamed, true);
        }
        let _e231 = phi_486_;
        if _e231.unnamed_1 {
            phi_1220_ = evaluate_Verdict(_e231.unnamed.visibility, _e231.unnamed.is_doubted);
        } else {
            let _e239 = samples.member[(0u + _e71.first_primitive)].position;
            let _e241 = p.member.map_size;
            let _e243 = (0.5f / f32(_e241));
            let _e250 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e257 = lt_math_LightPoint(vec2<f32>(_e250.uv.x, 0f), _e250.depth, _e250.is_inside);
            let _e261 = lt_math_LightPoint(_e257.uv, 0f, _e257.is_inside);
            phi_506_ = lt_math_LightPoint();
            phi_509_ = 0u;
            phi_511_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e261.uv, _e261.depth, false));
            loop {
                let _e268 = phi_506_;
                let _e270 = phi_509_;
                let _e272 = phi_511_;
                local_1 = _e272;
                local_2 = _e272;
                local_3 = _e272;
                if (_e270 < _e77) {
                    if _e272.point.is_inside {
                        phi_672_ = lt_math_LightPoint();
                        phi_673_ = u32();
                        phi_674_ = lt_math_LevelPoint();
                        phi_675_ = false;
                    } else {
                        if (_e270 < _e65) {
                        } else {
                            return;
                        }
                        let _e283 = levels.member[(0u + _e270)].row_w;
                        let _e294 = ((((_e283.x * _e239.x) + (_e283.y * _e239.y)) + (_e283.z * _e239.z)) + (_e283.w * 1f));
                        let _e296 = levels.member[(0u + _e270)].row_x;
                        let _e308 = (((((_e296.x * _e239.x) + (_e296.y * _e239.y)) + (_e296.z * _e239.z)) + (_e296.w * 1f)) / _e294);
                        let _e310 = levels.member[(0u + _e270)].row_y;
                        let _e322 = (((((_e310.x * _e239.x) + (_e310.y * _e239.y)) + (_e310.z * _e239.z)) + (_e310.w * 1f)) / _e294);
                        let _e324 = levels.member[(0u + _e270)].row_z;
                        let _e335 = ((((_e324.x * _e239.x) + (_e324.y * _e239.y)) + (_e324.z * _e239.z)) + (_e324.w * 1f));
                        if (_e294 > 0f) {
                            if (_e308 >= 0f) {
                                phi_597_ = (_e308 <= 1f);
                            } else {
                                phi_597_ = false;
                            }
                            let _e340 = phi_597_;
                            if _e340 {
                                if (_e322 >= 0f) {
                                    phi_606_ = (_e322 <= 1f);
                                } else {
                                    phi_606_ = false;
                                }
                                let _e344 = phi_606_;
                                if _e344 {
                                    if (_e335 >= 0f) {
                                        phi_615_ = (_e335 <= 1f);
                                    } else {
                                        phi_615_ = false;
                                    }
                                    let _e348 = phi_615_;
                                    phi_616_ = _e348;
                                    phi_617_ = false;
                                } else {
                                    phi_616_ = bool();
                                    phi_617_ = true;
                                }
                                let _e350 = phi_616_;
                                let _e352 = phi_617_;
                                phi_618_ = _e350;
                                phi_619_ = _e352;
                            } else {
                                phi_618_ = bool();
                                phi_619_ = true;
                            }
                            let _e354 = phi_618_;
                            let _e356 = phi_619_;
                            phi_620_ = _e354;
                            phi_621_ = _e356;
                        } else {
                            phi_620_ = bool();
                            phi_621_ = true;
                        }
                        let _e358 = phi_620_;
                        let _e360 = phi_621_;
                        if _e360 {
                            phi_625_ = false;
                        } else {
                            phi_625_ = _e358;
                        }
                        let _e362 = phi_625_;
                        if _e362 {
                            if (_e308 >= _e243) {
                                if (_e308 <= (1f - _e243)) {
                                    if (_e322 >= _e243) {
                                        phi_652_ = (_e322 <= (1f - _e243));
                                        phi_653_ = false;
                                    } else {
                                        phi_652_ = bool();
                                        phi_653_ = true;
                                    }
                                    let _e370 = phi_652_;
                                    let _e372 = phi_653_;
                                    phi_654_ = _e370;
                                    phi_655_ = _e372;
                                } else {
                                    phi_654_ = bool();
                                    phi_655_ = true;
                                }
                                let _e374 = phi_654_;
                                let _e376 = phi_655_;
                                phi_656_ = _e374;
                                phi_657_ = _e376;
                            } else {
                                phi_656_ = bool();
                                phi_657_ = true;
                            }
                            let _e378 = phi_656_;
                            let _e380 = phi_657_;
                            phi_658_ = _e378;
                            phi_659_ = _e380;
                        } else {
                            phi_658_ = bool();
                            phi_659_ = true;
                        }
                        let _e382 = phi_658_;
                        let _e384 = phi_659_;
                        if _e384 {
                            phi_663_ = false;
                        } else {
                            phi_663_ = _e382;
                        }
                        let _e386 = phi_663_;
                        let _e393 = lt_math_LightPoint(vec2<f32>(_e308, _e268.uv.y), _e268.depth, _e268.is_inside);
                        let _e400 = lt_math_LightPoint(vec2<f32>(_e393.uv.x, _e322), _e393.depth, _e393.is_inside);
                        let _e404 = lt_math_LightPoint(_e400.uv, _e335, _e400.is_inside);
                        let _e408 = lt_math_LightPoint(_e404.uv, _e404.depth, _e386);
                        phi_672_ = _e408;
                        phi_673_ = (_e270 + 1u);
                        phi_674_ = lt_math_LevelPoint(_e270, _e408);
                        phi_675_ = true;
                    }
                    let _e412 = phi_672_;
                    let _e414 = phi_673_;
                    let _e416 = phi_674_;
                    let _e418 = phi_675_;
                    phi_507_ = _e412;
                    phi_510_ = _e414;
                    phi_512_ = _e416;
                    phi_676_ = _e418;
                } else {
                    phi_507_ = lt_math_LightPoint();
                    phi_510_ = u32();
                    phi_512_ = lt_math_LevelPoint();
                    phi_676_ = false;
                }
                let _e420 = phi_507_;
                let _e422 = phi_510_;
                let _e424 = phi_512_;
                let _e426 = phi_676_;
                continue;
                continuing {
                    phi_506_ = _e420;
                    phi_509_ = _e422;
                    phi_511_ = _e424;
                    break if !(_e426);
                }
            }
            let _e429 = local_1;
            if _e429.point.is_inside {
                if (0f > 0f) {
                    let _e435 = local_2;
                    if (_e435.level < _e65) {
                    } else {
                        return;
                    }
                    let _e440 = levels.member[(0u + _e435.level)];
                    let _e446 = global[0u];
                    if (_e440.row_w.x == _e446) {
                        let _e449 = global[1u];
                        if (_e440.row_w.y == _e449) {
                            let _e452 = global[2u];
                            phi_716_ = (_e440.row_w.z == _e452);
                            phi_717_ = false;
                        } else {
                            phi_716_ = bool();
                            phi_717_ = true;
                        }
                        let _e455 = phi_716_;
                        let _e457 = phi_717_;
                        phi_718_ = _e455;
                        phi_719_ = _e457;
                    } else {
                        phi_718_ = bool();
                        phi_719_ = true;
                    }
                    let _e459 = phi_718_;
                    let _e461 = phi_719_;
                    if _e461 {
                        phi_723_ = false;
                    } else {
                        phi_723_ = _e459;
                    }
                    let _e463 = phi_723_;
                    if _e463 {
                        let _e465 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e467 = p.member.map_size;
                        let _e537 = ((abs(((((_e440.row_x.x * _e465.x) + (_e440.row_x.y * _e465.y)) + (_e440.row_x.z * _e465.z)) / (((_e440.row_x.x * _e440.row_x.x) + (_e440.row_x.y * _e440.row_x.y)) + (_e440.row_x.z * _e440.row_x.z)))) + abs(((((_e440.row_y.x * _e465.x) + (_e440.row_y.y * _e465.y)) + (_e440.row_y.z * _e465.z)) / (((_e440.row_y.x * _e440.row_y.x) + (_e440.row_y.y * _e440.row_y.y)) + (_e440.row_y.z * _e440.row_y.z))))) / (abs(((((_e440.row_z.x * _e465.x) + (_e440.row_z.y * _e465.y)) + (_e440.row_z.z * _e465.z)) / (((_e440.row_z.x * _e440.row_z.x) + (_e440.row_z.y * _e440.row_z.y)) + (_e440.row_z.z * _e440.row_z.z)))) * f32(_e467)));
                        if (_e537 < 0.002f) {
                            phi_805_ = _e537;
                        } else {
                            phi_805_ = 0.002f;
                        }
                        let _e540 = phi_805_;
                        phi_922_ = _e540;
                    } else {
                        let _e542 = p.member.map_size;
                        let _e548 = samples.member[(0u + _e71.first_primitive)].position;
                        let _e559 = ((((_e440.row_w.x * _e548.x) + (_e440.row_w.y * _e548.y)) + (_e440.row_w.z * _e548.z)) + _e440.row_w.w);
                        let _e572 = ((_e440.row_x.x - (_e440.row_w.x * _e429.point.uv.x)) / _e559);
                        let _e573 = ((_e440.row_x.y - (_e440.row_w.y * _e429.point.uv.x)) / _e559);
                        let _e574 = ((_e440.row_x.z - (_e440.row_w.z * _e429.point.uv.x)) / _e559);
                        let _e587 = ((_e440.row_y.x - (_e440.row_w.x * _e429.point.uv.y)) / _e559);
                        let _e588 = ((_e440.row_y.y - (_e440.row_w.y * _e429.point.uv.y)) / _e559);
                        let _e589 = ((_e440.row_y.z - (_e440.row_w.z * _e429.point.uv.y)) / _e559);
                        let _e595 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e600 = ((_e588 * _e595.z) - (_e595.y * _e589));
                        let _e605 = ((_e589 * _e595.x) - (_e595.z * _e587));
                        let _e610 = ((_e587 * _e595.y) - (_e595.x * _e588));
                        let _e612 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e617 = ((_e573 * _e612.z) - (_e612.y * _e574));
                        let _e622 = ((_e574 * _e612.x) - (_e612.z * _e572));
                        let _e627 = ((_e572 * _e612.y) - (_e612.x * _e573));
                        let _e654 = ((abs(((((_e440.row_z.x * _e600) + (_e440.row_z.y * _e605)) + (_e440.row_z.z * _e610)) / (((_e572 * _e600) + (_e573 * _e605)) + (_e574 * _e610)))) + abs(((((_e440.row_z.x * _e617) + (_e440.row_z.y * _e622)) + (_e440.row_z.z * _e627)) / (((_e587 * _e617) + (_e588 * _e622)) + (_e589 * _e627))))) / f32(_e542));
                        if (_e654 < 0.002f) {
                            phi_921_ = _e654;
                        } else {
                            phi_921_ = 0.002f;
                        }
                        let _e657 = phi_921_;
                        phi_922_ = _e657;
                    }
                    let _e659 = phi_922_;
                    phi_925_ = (_e429.point.depth - (0f * _e659));
                } else {
                    phi_925_ = _e429.point.depth;
                }
                let _e663 = phi_925_;
                let _e669 = p.member.map_size;
                let _e670 = f32(_e669);
                let _e673 = ((_e429.point.uv.x * _e670) - 0.5f);
                let _e674 = ((_e429.point.uv.y * _e670) - 0.5f);
                if (_e673 > -8388608f) {
                    let _e686 = f32(select(0i, select(select(i32(_e673), i32(-2147483648), (_e673 < bitcast<f32>(3472883712u))), 2147483647i, (_e673 > bitcast<f32>(1325400063u))), (_e673 == _e673)));
                    if (_e686 > _e673) {
                        phi_954_ = 1f;
                    } else {
                        phi_954_ = 0f;
                    }
                    let _e689 = phi_954_;
                    if (_e673 < 8388608f) {
                        phi_959_ = (_e686 - _e689);
                        phi_960_ = false;
                    } else {
                        phi_959_ = f32();
                        phi_960_ = true;
                    }
                    let _e692 = phi_959_;
                    let _e694 = phi_960_;
                    phi_961_ = _e692;
                    phi_962_ = _e694;
                } else {
                    phi_961_ = f32();
                    phi_962_ = true;
                }
                let _e696 = phi_961_;
                let _e698 = phi_962_;
                if _e698 {
                    phi_966_ = _e673;
                } else {
                    phi_966_ = _e696;
                }
                let _e700 = phi_966_;
                if (_e674 > -8388608f) {
                    let _e712 = f32(select(0i, select(select(i32(_e674), i32(-2147483648), (_e674 < bitcast<f32>(3472883712u))), 2147483647i, (_e674 > bitcast<f32>(1325400063u))), (_e674 == _e674)));
                    if (_e712 > _e674) {
                        phi_986_ = 1f;
                    } else {
                        phi_986_ = 0f;
                    }
                    let _e715 = phi_986_;
                    if (_e674 < 8388608f) {
                        phi_991_ = (_e712 - _e715);
                        phi_992_ = false;
                    } else {
                        phi_991_ = f32();
                        phi_992_ = true;
                    }
                    let _e718 = phi_991_;
                    let _e720 = phi_992_;
                    phi_993_ = _e718;
                    phi_994_ = _e720;
                } else {
                    phi_993_ = f32();
                    phi_994_ = true;
                }
                let _e722 = phi_993_;
                let _e724 = phi_994_;
                if _e724 {
                    phi_998_ = _e674;
                } else {
                    phi_998_ = _e722;
                }
                let _e726 = phi_998_;
                let _e727 = (_e673 - _e700);
                let _e728 = (_e674 - _e726);
                let _e737 = select(0i, select(select(i32(_e700), i32(-2147483648), (_e700 < bitcast<f32>(3472883712u))), 2147483647i, (_e700 > bitcast<f32>(1325400063u))), (_e700 == _e700));
                let _e746 = select(0i, select(select(i32(_e726), i32(-2147483648), (_e726 < bitcast<f32>(3472883712u))), 2147483647i, (_e726 > bitcast<f32>(1325400063u))), (_e726 == _e726));
                let _e749 = ((1f - _e727) * (1f - _e728));
                let _e751 = (_e727 * (1f - _e728));
                let _e753 = ((1f - _e727) * _e728);
                let _e754 = (_e727 * _e728);
                let _e756 = p.member.test;
                let _e757 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e756);
                let _e759 = p.member.map_size;
                let _e761 = local_3;
                local = _e757;
                let _e764 = ((_e761.level * _e759) * _e759);
                let _e766 = (bitcast<i32>(_e759) - 1i);
                if (_e737 > 0i) {
                    phi_1047_ = _e737;
                } else {
                    phi_1047_ = 0i;
                }
                let _e769 = phi_1047_;
                if (_e746 > 0i) {
                    phi_1052_ = _e746;
                } else {
                    phi_1052_ = 0i;
                }
                let _e772 = phi_1052_;
                if (_e769 < _e766) {
                    phi_1057_ = _e769;
                } else {
                    phi_1057_ = _e766;
                }
                let _e775 = phi_1057_;
                if (_e772 < _e766) {
                    phi_1062_ = _e772;
                } else {
                    phi_1062_ = _e766;
                }
                let _e778 = phi_1062_;
                let _e779 = bitcast<u32>(_e775);
                let _e781 = (_e737 + 1i);
                let _e782 = (_e746 + 1i);
                if (_e781 > 0i) {
                    phi_1071_ = _e781;
                } else {
                    phi_1071_ = 0i;
                }
                let _e785 = phi_1071_;
                if (_e782 > 0i) {
                    phi_1076_ = _e782;
                } else {
                    phi_1076_ = 0i;
                }
                let _e788 = phi_1076_;
                if (_e785 < _e766) {
                    phi_1081_ = _e785;
                } else {
                    phi_1081_ = _e766;
                }
                let _e791 = phi_1081_;
                if (_e788 < _e766) {
                    phi_1086_ = _e788;
                } else {
                    phi_1086_ = _e766;
                }
                let _e794 = phi_1086_;
                let _e795 = bitcast<u32>(_e791);
                let _e797 = (bitcast<u32>(_e778) * _e759);
                let _e798 = (bitcast<u32>(_e794) * _e759);
                let _e803 = ((_e797 + _e779) + _e764);
                let _e804 = ((_e797 + _e795) + _e764);
                let _e805 = ((_e798 + _e779) + _e764);
                let _e806 = ((_e798 + _e795) + _e764);
                if (_e803 < _e59) {
                } else {
                    return;
                }
                let _e810 = map.member[(0u + _e803)];
                if (_e804 < _e59) {
                } else {
                    return;
                }
                let _e822 = map.member[(0u + _e804)];
                if (_e805 < _e59) {
                } else {
                    return;
                }
                let _e838 = map.member[(0u + _e805)];
                if (_e806 < _e59) {
                } else {
                    return;
                }
                let _e854 = map.member[(0u + _e806)];
                let _e868 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e810.x * _e749) + (_e822.x * _e751)) + (_e838.x * _e753)) + (_e854.x * _e754)), ((((_e810.y * _e749) + (_e822.y * _e751)) + (_e838.y * _e753)) + (_e854.y * _e754)), ((((_e810.z * _e749) + (_e822.z * _e751)) + (_e838.z * _e753)) + (_e854.z * _e754)), ((((_e810.w * _e749) + (_e822.w * _e751)) + (_e838.w * _e753)) + (_e854.w * _e754))), _e663);
                let _e870 = p.member.epsilon;
                if (_e868 <= _e870) {
                    phi_1181_ = true;
                } else {
                    phi_1181_ = (_e868 >= (1f - _e870));
                }
                let _e875 = phi_1181_;
                if ((bitcast<u32>(_e868) & 2147483647u) > 2139095040u) {
                    phi_1189_ = true;
                } else {
                    phi_1189_ = !(_e875);
                }
                let _e881 = phi_1189_;
                if _e881 {
                    if (_e868 > 0f) {
                        if (_e868 < 1f) {
                            phi_1201_ = false;
                        } else {
                            phi_1201_ = true;
                        }
                        let _e885 = phi_1201_;
                        phi_1202_ = _e885;
                    } else {
                        phi_1202_ = true;
                    }
                    let _e887 = phi_1202_;
                    if _e887 {
                        phi_1206_ = 0.5f;
                    } else {
                        phi_1206_ = _e868;
                    }
                    let _e889 = phi_1206_;
                    phi_1214_ = evaluate_Verdict(_e889, true);
                } else {
                    if (_e868 > 0.5f) {
                        phi_1212_ = 1f;
                    } else {
                        phi_1212_ = 0f;
                    }
                    let _e893 = phi_1212_;
                    phi_1214_ = evaluate_Verdict(_e893, false);
                }
                let _e896 = phi_1214_;
                phi_1219_ = evaluate_Verdict(_e896.visibility, _e896.is_doubted);
            } else {
                phi_1219_ = evaluate_Verdict(0.5f, true);
            }
            let _e902 = phi_1219_;
            phi_1220_ = _e902;
        }
        let _e904 = phi_1220_;
        if (_e71.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e71.first_primitive)] = _e904.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
