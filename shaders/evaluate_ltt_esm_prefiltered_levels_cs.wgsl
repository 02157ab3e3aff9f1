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
    var phi_176_: lt_bvh_traverse_Tree;
    var phi_177_: bool;
    var phi_178_: lt_bvh_traverse_Tree;
    var phi_179_: bool;
    var phi_184_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_176_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_177_ = false;
        } else {
            phi_176_ = lt_bvh_traverse_Tree();
            phi_177_ = true;
        }
        let _e68 = phi_176_;
        let _e70 = phi_177_;
        phi_178_ = _e68;
        phi_179_ = _e70;
    } else {
        phi_178_ = lt_bvh_traverse_Tree();
        phi_179_ = true;
    }
    let _e72 = phi_178_;
    let _e74 = phi_179_;
    if _e74 {
        phi_184_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_184_ = _e72;
    }
    let _e79 = phi_184_;
    return lt_bvh_traverse_Tree(_e79.root, _e79.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_204_: bool;
    var phi_208_: f32;

    let _e56 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_204_ = true;
    } else {
        let _e60 = (84f < _e56);
        if _e60 {
        }
        phi_204_ = _e60;
    }
    let _e62 = phi_204_;
    if _e62 {
        phi_208_ = 84f;
    } else {
        phi_208_ = _e56;
    }
    let _e64 = phi_208_;
    return _e64;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_227_: f32;
    var phi_228_: f32;
    var phi_229_: f32;
    var phi_244_: f32;
    var phi_249_: f32;
    var phi_271_: f32;
    var phi_276_: f32;
    var phi_277_: bool;
    var phi_278_: f32;
    var phi_279_: bool;
    var phi_283_: f32;
    var phi_321_: f32;
    var phi_337_: f32;
    var phi_338_: f32;
    var phi_339_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_229_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_228_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_227_ = 1f;
            } else {
                phi_227_ = param_7;
            }
            let _e64 = phi_227_;
            phi_228_ = _e64;
        }
        let _e66 = phi_228_;
        phi_229_ = _e66;
    }
    let _e68 = phi_229_;
    let _e70 = _lt_math_esm_Esm_clamped_exponent(param_5);
    let _e72 = (_e70 * (1f - _e68));
    if ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u) {
        phi_321_ = _e72;
    } else {
        if (_e72 < -87f) {
            phi_244_ = -87f;
        } else {
            phi_244_ = _e72;
        }
        let _e78 = phi_244_;
        if (_e78 > 88f) {
            phi_249_ = 88f;
        } else {
            phi_249_ = _e78;
        }
        let _e81 = phi_249_;
        let _e83 = ((_e81 * 1.442695f) + 0.5f);
        if (_e83 > -8388608f) {
            let _e95 = f32(select(0i, select(select(i32(_e83), i32(-2147483648), (_e83 < bitcast<f32>(3472883712u))), 2147483647i, (_e83 > bitcast<f32>(1325400063u))), (_e83 == _e83)));
            if (_e95 > _e83) {
                phi_271_ = 1f;
            } else {
                phi_271_ = 0f;
            }
            let _e98 = phi_271_;
            if (_e83 < 8388608f) {
                phi_276_ = (_e95 - _e98);
                phi_277_ = false;
            } else {
                phi_276_ = f32();
                phi_277_ = true;
            }
            let _e101 = phi_276_;
            let _e103 = phi_277_;
            phi_278_ = _e101;
            phi_279_ = _e103;
        } else {
            phi_278_ = f32();
            phi_279_ = true;
        }
        let _e105 = phi_278_;
        let _e107 = phi_279_;
        if _e107 {
            phi_283_ = _e83;
        } else {
            phi_283_ = _e105;
        }
        let _e109 = phi_283_;
        let _e113 = ((_e81 - (_e109 * 0.69314575f)) - (_e109 * 0.0000014286068f));
        phi_321_ = ((((((((((((((((1f / 5040f) * _e113) + (1f / 720f)) * _e113) + (1f / 120f)) * _e113) + (1f / 24f)) * _e113) + (1f / 6f)) * _e113) + 0.5f) * _e113) + 1f) * _e113) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e109), i32(-2147483648), (_e109 < bitcast<f32>(3472883712u))), 2147483647i, (_e109 > bitcast<f32>(1325400063u))), (_e109 == _e109)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e149 = phi_321_;
    let _e150 = (param_6.x * _e149);
    if ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u) {
        phi_339_ = _e150;
    } else {
        if (_e150 < 0f) {
            phi_338_ = 0f;
        } else {
            if (_e150 > 1f) {
                phi_337_ = 1f;
            } else {
                phi_337_ = _e150;
            }
            let _e157 = phi_337_;
            phi_338_ = _e157;
        }
        let _e159 = phi_338_;
        phi_339_ = _e159;
    }
    let _e161 = phi_339_;
    return _e161;
}

fn function_() {
    var local_1: f32;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_401_: bool;
    var phi_471_: bool;
    var phi_472_: bool;
    var phi_483_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_484_: bool;
    var phi_485_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_486_: bool;
    var phi_493_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_497_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_517_: lt_math_LightPoint;
    var phi_520_: u32;
    var phi_522_: lt_math_LevelPoint;
    var phi_608_: bool;
    var phi_617_: bool;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_628_: bool;
    var phi_629_: bool;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_636_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_674_: bool;
    var phi_683_: lt_math_LightPoint;
    var phi_684_: u32;
    var phi_685_: lt_math_LevelPoint;
    var phi_686_: bool;
    var phi_518_: lt_math_LightPoint;
    var phi_521_: u32;
    var phi_523_: lt_math_LevelPoint;
    var phi_687_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_727_: bool;
    var phi_728_: bool;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_734_: bool;
    var phi_816_: f32;
    var phi_932_: f32;
    var phi_933_: f32;
    var phi_936_: f32;
    var phi_965_: f32;
    var phi_970_: f32;
    var phi_971_: bool;
    var phi_972_: f32;
    var phi_973_: bool;
    var phi_977_: f32;
    var phi_997_: f32;
    var phi_1002_: f32;
    var phi_1003_: bool;
    var phi_1004_: f32;
    var phi_1005_: bool;
    var phi_1009_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1058_: i32;
    var phi_1063_: i32;
    var phi_1068_: i32;
    var phi_1073_: i32;
    var phi_1082_: i32;
    var phi_1087_: i32;
    var phi_1092_: i32;
    var phi_1097_: i32;
    var phi_1192_: bool;
    var phi_1200_: bool;
    var phi_1212_: bool;
    var phi_1213_: bool;
    var phi_1217_: f32;
    var phi_1223_: f32;
    var phi_1225_: evaluate_Verdict;
    var phi_1230_: evaluate_Verdict;
    var phi_1231_: evaluate_Verdict;
    var phi_1235_: bool;
    var phi_1236_: u32;
    var phi_1247_: u32;

    let _e56 = id_1;
    let _e57 = local_5;
    let _e62 = arrayLength((&map.member));
    let _e67 = arrayLength((&levels.member));
    let _e70 = p.member.size[0u];
    let _e72 = p.member.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e56, _e70, _e72);
    if (bitcast<i32>(_e73.root) != 0i) {
        let _e80 = p.member.level_count;
        let _e84 = samples.member[_e73.first_primitive].normal[0u];
        let _e86 = global[0u];
        if (_e84 == _e86) {
            let _e89 = samples.member[_e73.first_primitive].normal[1u];
            let _e91 = global[1u];
            if (_e89 == _e91) {
                let _e94 = samples.member[_e73.first_primitive].normal[2u];
                let _e96 = global[2u];
                phi_394_ = (_e94 == _e96);
                phi_395_ = false;
            } else {
                phi_394_ = bool();
                phi_395_ = true;
            }
            let _e99 = phi_394_;
            let _e101 = phi_395_;
            phi_396_ = _e99;
            phi_397_ = _e101;
        } else {
            phi_396_ = bool();
            phi_397_ = true;
        }
        let _e103 = phi_396_;
        let _e105 = phi_397_;
        if _e105 {
            phi_401_ = false;
        } else {
            phi_401_ = _e103;
        }
        let _e107 = phi_401_;
        if !(_e107) {
            let _e110 = samples.member[_e73.first_primitive].position;
            let _e112 = p.member.light.place;
            let _e118 = p.member.light.place[3u];
            let _e125 = (_e112.x - (_e110.x * _e118));
            let _e126 = (_e112.y - (_e110.y * _e118));
            let _e127 = (_e112.z - (_e110.z * _e118));
            let _e129 = samples.member[_e73.first_primitive].normal;
            if ((((_e129.x * _e125) + (_e129.y * _e126)) + (_e129.z * _e127)) > 0f) {
                let _e143 = (((_e125 * _e125) + (_e126 * _e126)) + (_e127 * _e127));
                let _e145 = p.member.light.axis;
                let _e157 = p.member.light.place[3u];
                if (_e157 == 0f) {
                    phi_472_ = true;
                } else {
                    let _e160 = p.member.light.range_squared;
                    if (_e143 <= _e160) {
                        let _e163 = p.member.light.cos_outer;
                        phi_471_ = (-((((_e125 * _e145.x) + (_e126 * _e145.y)) + (_e127 * _e145.z))) >= (_e163 * sqrt(_e143)));
                    } else {
                        phi_471_ = false;
                    }
                    let _e168 = phi_471_;
                    phi_472_ = _e168;
                }
                let _e170 = phi_472_;
                if _e170 {
                    let _e172 = samples.member[_e73.first_primitive].flags;
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e180.unnamed.visibility, false), _e180.unnamed_1);
                    phi_483_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e186.unnamed, ((_e172 & 1u) == 0u));
                    phi_484_ = false;
                } else {
                    phi_483_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_484_ = true;
                }
                let _e191 = phi_483_;
                let _e193 = phi_484_;
                phi_485_ = _e191;
                phi_486_ = _e193;
            } else {
                phi_485_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_486_ = true;
            }
            let _e195 = phi_485_;
            let _e197 = phi_486_;
            if _e197 {
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e203.unnamed.visibility, false), _e203.unnamed_1);
                phi_493_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e209.unnamed, true);
            } else {
                phi_493_ = _e195;
            }
            let _e214 = phi_493_;
            phi_497_ = _e214;
        } else {
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e226 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e220.unnamed.visibility, false), _e220.unnamed_1);
            phi_497_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e226.unnamed, true);
        }
        let _e231 = phi_497_;
        if _e231.unnamed_1 {
            phi_1231_ = evaluate_Verdict(_e231.unnamed.visibility, _e231.unnamed.is_doubted);
        } else {
            let _e239 = samples.member[_e73.first_primitive].position;
            let _e241 = p.member.map_size;
            let _e243 = (0.5f / f32(_e241));
            let _e250 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e257 = lt_math_LightPoint(vec2<f32>(_e250.uv.x, 0f), _e250.depth, _e250.is_inside);
            let _e261 = lt_math_LightPoint(_e257.uv, 0f, _e257.is_inside);
            phi_517_ = lt_math_LightPoint();
            phi_520_ = 0u;
            phi_522_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e261.uv, _e261.depth, false));
            loop {
                let _e268 = phi_517_;
                let _e270 = phi_520_;
                let _e272 = phi_522_;
                local_2 = _e272;
                local_3 = _e272;
                local_4 = _e272;
                if (_e270 < _e80) {
                    if _e272.point.is_inside {
                        phi_683_ = lt_math_LightPoint();
                        phi_684_ = u32();
                        phi_685_ = lt_math_LevelPoint();
                        phi_686_ = false;
                    } else {
                        if (_e270 < _e67) {
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
                                phi_608_ = (_e308 <= 1f);
                            } else {
                                phi_608_ = false;
                            }
                            let _e340 = phi_608_;
                            if _e340 {
                                if (_e322 >= 0f) {
                                    phi_617_ = (_e322 <= 1f);
                                } else {
                                    phi_617_ = false;
                                }
                                let _e344 = phi_617_;
                                if _e344 {
                                    if (_e335 >= 0f) {
                                        phi_626_ = (_e335 <= 1f);
                                    } else {
                                        phi_626_ = false;
                                    }
                                    let _e348 = phi_626_;
                                    phi_627_ = _e348;
                                    phi_628_ = false;
                                } else {
                                    phi_627_ = bool();
                                    phi_628_ = true;
                                }
                                let _e350 = phi_627_;
                                let _e352 = phi_628_;
                                phi_629_ = _e350;
                                phi_630_ = _e352;
                            } else {
                                phi_629_ = bool();
                                phi_630_ = true;
                            }
                            let _e354 = phi_629_;
                            let _e356 = phi_630_;
                            phi_631_ = _e354;
                            phi_632_ = _e356;
                        } else {
                            phi_631_ = bool();
                            phi_632_ = true;
                        }
                        let _e358 = phi_631_;
                        let _e360 = phi_632_;
                        if _e360 {
                            phi_636_ = false;
                        } else {
                            phi_636_ = _e358;
                        }
                        let _e362 = phi_636_;
                        if _e362 {
                            if (_e308 >= _e243) {
                                if (_e308 <= (1f - _e243)) {
                                    if (_e322 >= _e243) {
                                        phi_663_ = (_e322 <= (1f - _e243));
                                        phi_664_ = false;
                                    } else {
                                        phi_663_ = bool();
                                        phi_664_ = true;
                                    }
                                    let _e370 = phi_663_;
                                    let _e372 = phi_664_;
                                    phi_665_ = _e370;
                                    phi_666_ = _e372;
                                } else {
                                    phi_665_ = bool();
                                    phi_666_ = true;
                                }
                                let _e374 = phi_665_;
                                let _e376 = phi_666_;
                                phi_667_ = _e374;
                                phi_668_ = _e376;
                            } else {
                                phi_667_ = bool();
                                phi_668_ = true;
                            }
                            let _e378 = phi_667_;
                            let _e380 = phi_668_;
                            phi_669_ = _e378;
                            phi_670_ = _e380;
                        } else {
                            phi_669_ = bool();
                            phi_670_ = true;
                        }
                        let _e382 = phi_669_;
                        let _e384 = phi_670_;
                        if _e384 {
                            phi_674_ = false;
                        } else {
                            phi_674_ = _e382;
                        }
                        let _e386 = phi_674_;
                        let _e393 = lt_math_LightPoint(vec2<f32>(_e308, _e268.uv.y), _e268.depth, _e268.is_inside);
                        let _e400 = lt_math_LightPoint(vec2<f32>(_e393.uv.x, _e322), _e393.depth, _e393.is_inside);
                        let _e404 = lt_math_LightPoint(_e400.uv, _e335, _e400.is_inside);
                        let _e408 = lt_math_LightPoint(_e404.uv, _e404.depth, _e386);
                        phi_683_ = _e408;
                        phi_684_ = (_e270 + 1u);
                        phi_685_ = lt_math_LevelPoint(_e270, _e408);
                        phi_686_ = true;
                    }
                    let _e412 = phi_683_;
                    let _e414 = phi_684_;
                    let _e416 = phi_685_;
                    let _e418 = phi_686_;
                    phi_518_ = _e412;
                    phi_521_ = _e414;
                    phi_523_ = _e416;
                    phi_687_ = _e418;
                } else {
                    phi_518_ = lt_math_LightPoint();
                    phi_521_ = u32();
                    phi_523_ = lt_math_LevelPoint();
                    phi_687_ = false;
                }
                let _e420 = phi_518_;
                let _e422 = phi_521_;
                let _e424 = phi_523_;
                let _e426 = phi_687_;
                continue;
                continuing {
                    phi_517_ = _e420;
                    phi_520_ = _e422;
                    phi_522_ = _e424;
                    break if !(_e426);
                }
            }
            let _e429 = local_2;
            if _e429.point.is_inside {
                if (0f > 0f) {
                    let _e435 = local_3;
                    if (_e435.level < _e67) {
                    } else {
                        return;
                    }
                    let _e440 = levels.member[(0u + _e435.level)];
                    let _e446 = global[0u];
                    if (_e440.row_w.x == _e446) {
                        let _e449 = global[1u];
                        if (_e440.row_w.y == _e449) {
                            let _e452 = global[2u];
                            phi_727_ = (_e440.row_w.z == _e452);
                            phi_728_ = false;
                        } else {
                            phi_727_ = bool();
                            phi_728_ = true;
                        }
                        let _e455 = phi_727_;
                        let _e457 = phi_728_;
                        phi_729_ = _e455;
                        phi_730_ = _e457;
                    } else {
                        phi_729_ = bool();
                        phi_730_ = true;
                    }
                    let _e459 = phi_729_;
                    let _e461 = phi_730_;
                    if _e461 {
                        phi_734_ = false;
                    } else {
                        phi_734_ = _e459;
                    }
                    let _e463 = phi_734_;
                    if _e463 {
                        let _e465 = samples.member[_e73.first_primitive].normal;
                        let _e467 = p.member.map_size;
                        let _e537 = ((abs(((((_e440.row_x.x * _e465.x) + (_e440.row_x.y * _e465.y)) + (_e440.row_x.z * _e465.z)) / (((_e440.row_x.x * _e440.row_x.x) + (_e440.row_x.y * _e440.row_x.y)) + (_e440.row_x.z * _e440.row_x.z)))) + abs(((((_e440.row_y.x * _e465.x) + (_e440.row_y.y * _e465.y)) + (_e440.row_y.z * _e465.z)) / (((_e440.row_y.x * _e440.row_y.x) + (_e440.row_y.y * _e440.row_y.y)) + (_e440.row_y.z * _e440.row_y.z))))) / (abs(((((_e440.row_z.x * _e465.x) + (_e440.row_z.y * _e465.y)) + (_e440.row_z.z * _e465.z)) / (((_e440.row_z.x * _e440.row_z.x) + (_e440.row_z.y * _e440.row_z.y)) + (_e440.row_z.z * _e440.row_z.z)))) * f32(_e467)));
                        if (_e537 < 0.002f) {
                            phi_816_ = _e537;
                        } else {
                            phi_816_ = 0.002f;
                        }
                        let _e540 = phi_816_;
                        phi_933_ = _e540;
                    } else {
                        let _e542 = p.member.map_size;
                        let _e548 = samples.member[_e73.first_primitive].position;
                        let _e559 = ((((_e440.row_w.x * _e548.x) + (_e440.row_w.y * _e548.y)) + (_e440.row_w.z * _e548.z)) + _e440.row_w.w);
                        let _e572 = ((_e440.row_x.x - (_e440.row_w.x * _e429.point.uv.x)) / _e559);
                        let _e573 = ((_e440.row_x.y - (_e440.row_w.y * _e429.point.uv.x)) / _e559);
                        let _e574 = ((_e440.row_x.z - (_e440.row_w.z * _e429.point.uv.x)) / _e559);
                        let _e587 = ((_e440.row_y.x - (_e440.row_w.x * _e429.point.uv.y)) / _e559);
                        let _e588 = ((_e440.row_y.y - (_e440.row_w.y * _e429.point.uv.y)) / _e559);
                        let _e589 = ((_e440.row_y.z - (_e440.row_w.z * _e429.point.uv.y)) / _e559);
                        let _e595 = samples.member[_e73.first_primitive].normal;
                        let _e600 = ((_e588 * _e595.z) - (_e595.y * _e589));
                        let _e605 = ((_e589 * _e595.x) - (_e595.z * _e587));
                        let _e610 = ((_e587 * _e595.y) - (_e595.x * _e588));
                        let _e612 = samples.member[_e73.first_primitive].normal;
                        let _e617 = ((_e573 * _e612.z) - (_e612.y * _e574));
                        let _e622 = ((_e574 * _e612.x) - (_e612.z * _e572));
                        let _e627 = ((_e572 * _e612.y) - (_e612.x * _e573));
                        let _e654 = ((abs(((((_e440.row_z.x * _e600) + (_e440.row_z.y * _e605)) + (_e440.row_z.z * _e610)) / (((_e572 * _e600) + (_e573 * _e605)) + (_e574 * _e610)))) + abs(((((_e440.row_z.x * _e617) + (_e440.row_z.y * _e622)) + (_e440.row_z.z * _e627)) / (((_e587 * _e617) + (_e588 * _e622)) + (_e589 * _e627))))) / f32(_e542));
                        if (_e654 < 0.002f) {
                            phi_932_ = _e654;
                        } else {
                            phi_932_ = 0.002f;
                        }
                        let _e657 = phi_932_;
                        phi_933_ = _e657;
                    }
                    let _e659 = phi_933_;
                    phi_936_ = (_e429.point.depth - (0f * _e659));
                } else {
                    phi_936_ = _e429.point.depth;
                }
                let _e663 = phi_936_;
                let _e669 = p.member.map_size;
                let _e670 = f32(_e669);
                let _e673 = ((_e429.point.uv.x * _e670) - 0.5f);
                let _e674 = ((_e429.point.uv.y * _e670) - 0.5f);
                if (_e673 > -8388608f) {
                    let _e686 = f32(select(0i, select(select(i32(_e673), i32(-2147483648), (_e673 < bitcast<f32>(3472883712u))), 2147483647i, (_e673 > bitcast<f32>(1325400063u))), (_e673 == _e673)));
                    if (_e686 > _e673) {
                        phi_965_ = 1f;
                    } else {
                        phi_965_ = 0f;
                    }
                    let _e689 = phi_965_;
                    if (_e673 < 8388608f) {
                        phi_970_ = (_e686 - _e689);
                        phi_971_ = false;
                    } else {
                        phi_970_ = f32();
                        phi_971_ = true;
                    }
                    let _e692 = phi_970_;
                    let _e694 = phi_971_;
                    phi_972_ = _e692;
                    phi_973_ = _e694;
                } else {
                    phi_972_ = f32();
                    phi_973_ = true;
                }
                let _e696 = phi_972_;
                let _e698 = phi_973_;
                if _e698 {
                    phi_977_ = _e673;
                } else {
                    phi_977_ = _e696;
                }
                let _e700 = phi_977_;
                if (_e674 > -8388608f) {
                    let _e712 = f32(select(0i, select(select(i32(_e674), i32(-2147483648), (_e674 < bitcast<f32>(3472883712u))), 2147483647i, (_e674 > bitcast<f32>(1325400063u))), (_e674 == _e674)));
                    if (_e712 > _e674) {
                        phi_997_ = 1f;
                    } else {
                        phi_997_ = 0f;
                    }
                    let _e715 = phi_997_;
                    if (_e674 < 8388608f) {
                        phi_1002_ = (_e712 - _e715);
                        phi_1003_ = false;
                    } else {
                        phi_1002_ = f32();
                        phi_1003_ = true;
                    }
                    let _e718 = phi_1002_;
                    let _e720 = phi_1003_;
                    phi_1004_ = _e718;
                    phi_1005_ = _e720;
                } else {
                    phi_1004_ = f32();
                    phi_1005_ = true;
                }
                let _e722 = phi_1004_;
                let _e724 = phi_1005_;
                if _e724 {
                    phi_1009_ = _e674;
                } else {
                    phi_1009_ = _e722;
                }
                let _e726 = phi_1009_;
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
                let _e761 = local_4;
                local_1 = _e757;
                let _e764 = ((_e761.level * _e759) * _e759);
                let _e766 = (bitcast<i32>(_e759) - 1i);
                if (_e737 > 0i) {
                    phi_1058_ = _e737;
                } else {
                    phi_1058_ = 0i;
                }
                let _e769 = phi_1058_;
                if (_e746 > 0i) {
                    phi_1063_ = _e746;
                } else {
                    phi_1063_ = 0i;
                }
                let _e772 = phi_1063_;
                if (_e769 < _e766) {
                    phi_1068_ = _e769;
                } else {
                    phi_1068_ = _e766;
                }
                let _e775 = phi_1068_;
                if (_e772 < _e766) {
                    phi_1073_ = _e772;
                } else {
                    phi_1073_ = _e766;
                }
                let _e778 = phi_1073_;
                let _e779 = bitcast<u32>(_e775);
                let _e781 = (_e737 + 1i);
                let _e782 = (_e746 + 1i);
                if (_e781 > 0i) {
                    phi_1082_ = _e781;
                } else {
                    phi_1082_ = 0i;
                }
                let _e785 = phi_1082_;
                if (_e782 > 0i) {
                    phi_1087_ = _e782;
                } else {
                    phi_1087_ = 0i;
                }
                let _e788 = phi_1087_;
                if (_e785 < _e766) {
                    phi_1092_ = _e785;
                } else {
                    phi_1092_ = _e766;
                }
                let _e791 = phi_1092_;
                if (_e788 < _e766) {
                    phi_1097_ = _e788;
                } else {
                    phi_1097_ = _e766;
                }
                let _e794 = phi_1097_;
                let _e795 = bitcast<u32>(_e791);
                let _e797 = (bitcast<u32>(_e778) * _e759);
                let _e798 = (bitcast<u32>(_e794) * _e759);
                let _e803 = ((_e797 + _e779) + _e764);
                let _e804 = ((_e797 + _e795) + _e764);
                let _e805 = ((_e798 + _e779) + _e764);
                let _e806 = ((_e798 + _e795) + _e764);
                if (_e803 < _e62) {
                } else {
                    return;
                }
                let _e810 = map.member[(0u + _e803)];
                if (_e804 < _e62) {
                } else {
                    return;
                }
                let _e822 = map.member[(0u + _e804)];
                if (_e805 < _e62) {
                } else {
                    return;
                }
                let _e838 = map.member[(0u + _e805)];
                if (_e806 < _e62) {
                } else {
                    return;
                }
                let _e854 = map.member[(0u + _e806)];
                let _e868 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e810.x * _e749) + (_e822.x * _e751)) + (_e838.x * _e753)) + (_e854.x * _e754)), ((((_e810.y * _e749) + (_e822.y * _e751)) + (_e838.y * _e753)) + (_e854.y * _e754)), ((((_e810.z * _e749) + (_e822.z * _e751)) + (_e838.z * _e753)) + (_e854.z * _e754)), ((((_e810.w * _e749) + (_e822.w * _e751)) + (_e838.w * _e753)) + (_e854.w * _e754))), _e663);
                let _e870 = p.member.epsilon;
                if (_e868 <= _e870) {
                    phi_1192_ = true;
                } else {
                    phi_1192_ = (_e868 >= (1f - _e870));
                }
                let _e875 = phi_1192_;
                if ((bitcast<u32>(_e868) & 2147483647u) > 2139095040u) {
                    phi_1200_ = true;
                } else {
                    phi_1200_ = !(_e875);
                }
                let _e881 = phi_1200_;
                if _e881 {
                    if (_e868 > 0f) {
                        if (_e868 < 1f) {
                            phi_1212_ = false;
                        } else {
                            phi_1212_ = true;
                        }
                        let _e885 = phi_1212_;
                        phi_1213_ = _e885;
                    } else {
                        phi_1213_ = true;
                    }
                    let _e887 = phi_1213_;
                    if _e887 {
                        phi_1217_ = 0.5f;
                    } else {
                        phi_1217_ = _e868;
                    }
                    let _e889 = phi_1217_;
                    phi_1225_ = evaluate_Verdict(_e889, true);
                } else {
                    if (_e868 > 0.5f) {
                        phi_1223_ = 1f;
                    } else {
                        phi_1223_ = 0f;
                    }
                    let _e893 = phi_1223_;
                    phi_1225_ = evaluate_Verdict(_e893, false);
                }
                let _e896 = phi_1225_;
                phi_1230_ = evaluate_Verdict(_e896.visibility, _e896.is_doubted);
            } else {
                phi_1230_ = evaluate_Verdict(0.5f, true);
            }
            let _e902 = phi_1230_;
            phi_1231_ = _e902;
        }
        let _e904 = phi_1231_;
        visibility.member[_e73.first_primitive] = _e904.visibility;
        phi_1235_ = _e904.is_doubted;
        phi_1236_ = _e73.first_primitive;
    } else {
        phi_1235_ = false;
        phi_1236_ = 0u;
    }
    let _e909 = phi_1235_;
    let _e911 = phi_1236_;
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e909 {
        let _e915 = atomicAdd((&shared_[0u]), 1u);
        phi_1247_ = _e915;
    } else {
        phi_1247_ = 0u;
    }
    let _e917 = phi_1247_;
    workgroupBarrier();
    if (_e57 == 0u) {
        let _e921 = atomicLoad((&shared_[0u]));
        let _e922 = atomicAdd((&list.member[3u]), _e921);
        atomicStore((&shared_[1u]), _e922);
    }
    workgroupBarrier();
    if _e909 {
        let _e925 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e925) + _e917)]), _e911);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
