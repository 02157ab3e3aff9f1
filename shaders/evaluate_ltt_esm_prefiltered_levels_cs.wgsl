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

struct type_47 {
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
var<storage> levels: type_47;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_181_: lt_bvh_traverse_Tree;
    var phi_182_: bool;
    var phi_183_: lt_bvh_traverse_Tree;
    var phi_184_: bool;
    var phi_189_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_181_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_182_ = false;
        } else {
            phi_181_ = lt_bvh_traverse_Tree();
            phi_182_ = true;
        }
        let _e73 = phi_181_;
        let _e75 = phi_182_;
        phi_183_ = _e73;
        phi_184_ = _e75;
    } else {
        phi_183_ = lt_bvh_traverse_Tree();
        phi_184_ = true;
    }
    let _e77 = phi_183_;
    let _e79 = phi_184_;
    if _e79 {
        phi_189_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_189_ = _e77;
    }
    let _e84 = phi_189_;
    return lt_bvh_traverse_Tree(_e84.root, _e84.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_214_: f32;
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_229_: bool;
    var phi_233_: f32;
    var phi_246_: f32;
    var phi_251_: f32;
    var phi_273_: f32;
    var phi_278_: f32;
    var phi_279_: bool;
    var phi_280_: f32;
    var phi_281_: bool;
    var phi_285_: f32;
    var phi_323_: f32;
    var phi_339_: f32;
    var phi_340_: f32;
    var phi_341_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_216_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_215_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_214_ = 1f;
            } else {
                phi_214_ = param_6;
            }
            let _e69 = phi_214_;
            phi_215_ = _e69;
        }
        let _e71 = phi_215_;
        phi_216_ = _e71;
    }
    let _e73 = phi_216_;
    let _e75 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_229_ = true;
    } else {
        let _e79 = (84f < _e75);
        if _e79 {
        }
        phi_229_ = _e79;
    }
    let _e81 = phi_229_;
    if _e81 {
        phi_233_ = 84f;
    } else {
        phi_233_ = _e75;
    }
    let _e83 = phi_233_;
    let _e85 = (_e83 * (1f - _e73));
    if ((bitcast<u32>(_e85) & 2147483647u) > 2139095040u) {
        phi_323_ = _e85;
    } else {
        if (_e85 < -87f) {
            phi_246_ = -87f;
        } else {
            phi_246_ = _e85;
        }
        let _e91 = phi_246_;
        if (_e91 > 88f) {
            phi_251_ = 88f;
        } else {
            phi_251_ = _e91;
        }
        let _e94 = phi_251_;
        let _e96 = ((_e94 * 1.442695f) + 0.5f);
        if (_e96 > -8388608f) {
            let _e108 = f32(select(0i, select(select(i32(_e96), i32(-2147483648), (_e96 < bitcast<f32>(3472883712u))), 2147483647i, (_e96 > bitcast<f32>(1325400063u))), (_e96 == _e96)));
            if (_e108 > _e96) {
                phi_273_ = 1f;
            } else {
                phi_273_ = 0f;
            }
            let _e111 = phi_273_;
            if (_e96 < 8388608f) {
                phi_278_ = (_e108 - _e111);
                phi_279_ = false;
            } else {
                phi_278_ = f32();
                phi_279_ = true;
            }
            let _e114 = phi_278_;
            let _e116 = phi_279_;
            phi_280_ = _e114;
            phi_281_ = _e116;
        } else {
            phi_280_ = f32();
            phi_281_ = true;
        }
        let _e118 = phi_280_;
        let _e120 = phi_281_;
        if _e120 {
            phi_285_ = _e96;
        } else {
            phi_285_ = _e118;
        }
        let _e122 = phi_285_;
        let _e126 = ((_e94 - (_e122 * 0.69314575f)) - (_e122 * 0.0000014286068f));
        phi_323_ = ((((((((((((((((1f / 5040f) * _e126) + (1f / 720f)) * _e126) + (1f / 120f)) * _e126) + (1f / 24f)) * _e126) + (1f / 6f)) * _e126) + 0.5f) * _e126) + 1f) * _e126) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e122), i32(-2147483648), (_e122 < bitcast<f32>(3472883712u))), 2147483647i, (_e122 > bitcast<f32>(1325400063u))), (_e122 == _e122)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e162 = phi_323_;
    let _e163 = (param_5.x * _e162);
    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
        phi_341_ = _e163;
    } else {
        if (_e163 < 0f) {
            phi_340_ = 0f;
        } else {
            if (_e163 > 1f) {
                phi_339_ = 1f;
            } else {
                phi_339_ = _e163;
            }
            let _e170 = phi_339_;
            phi_340_ = _e170;
        }
        let _e172 = phi_340_;
        phi_341_ = _e172;
    }
    let _e174 = phi_341_;
    return _e174;
}

fn function_() {
    var local_1: f32;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_403_: bool;
    var phi_473_: bool;
    var phi_474_: bool;
    var phi_485_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_486_: bool;
    var phi_487_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_488_: bool;
    var phi_495_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_499_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_519_: lt_math_LightPoint;
    var phi_522_: u32;
    var phi_524_: lt_math_LevelPoint;
    var phi_610_: bool;
    var phi_619_: bool;
    var phi_628_: bool;
    var phi_629_: bool;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_633_: bool;
    var phi_634_: bool;
    var phi_638_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_676_: bool;
    var phi_685_: lt_math_LightPoint;
    var phi_686_: u32;
    var phi_687_: lt_math_LevelPoint;
    var phi_688_: bool;
    var phi_520_: lt_math_LightPoint;
    var phi_523_: u32;
    var phi_525_: lt_math_LevelPoint;
    var phi_689_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_736_: bool;
    var phi_818_: f32;
    var phi_936_: f32;
    var phi_937_: f32;
    var phi_940_: f32;
    var phi_969_: f32;
    var phi_974_: f32;
    var phi_975_: bool;
    var phi_976_: f32;
    var phi_977_: bool;
    var phi_981_: f32;
    var phi_1001_: f32;
    var phi_1006_: f32;
    var phi_1007_: bool;
    var phi_1008_: f32;
    var phi_1009_: bool;
    var phi_1013_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1062_: i32;
    var phi_1067_: i32;
    var phi_1072_: i32;
    var phi_1077_: i32;
    var phi_1086_: i32;
    var phi_1091_: i32;
    var phi_1096_: i32;
    var phi_1101_: i32;
    var phi_1198_: bool;
    var phi_1206_: bool;
    var phi_1218_: bool;
    var phi_1219_: bool;
    var phi_1223_: f32;
    var phi_1229_: f32;
    var phi_1231_: evaluate_Verdict;
    var phi_1241_: u32;
    var phi_1250_: f32;
    var phi_1252_: evaluate_Verdict;
    var phi_1253_: bool;
    var phi_1254_: evaluate_Verdict;
    var phi_1255_: bool;
    var phi_1260_: evaluate_Verdict;
    var phi_1265_: evaluate_Verdict;
    var phi_1266_: evaluate_Verdict;
    var phi_1270_: bool;
    var phi_1271_: u32;
    var phi_1282_: u32;
    var phi_1299_: u32;

    let _e61 = id_1;
    let _e62 = local_5;
    let _e67 = arrayLength((&map.member));
    let _e72 = arrayLength((&levels.member));
    let _e75 = p.member.size[0u];
    let _e77 = p.member.size[1u];
    let _e78 = lt_shaders_entry_pixel_index(_e61, _e75, _e77);
    if (bitcast<i32>(_e78.root) != 0i) {
        let _e85 = p.member.level_count;
        let _e89 = samples.member[_e78.first_primitive].normal[0u];
        let _e91 = global[0u];
        if (_e89 == _e91) {
            let _e94 = samples.member[_e78.first_primitive].normal[1u];
            let _e96 = global[1u];
            if (_e94 == _e96) {
                let _e99 = samples.member[_e78.first_primitive].normal[2u];
                let _e101 = global[2u];
                phi_396_ = (_e99 == _e101);
                phi_397_ = false;
            } else {
                phi_396_ = bool();
                phi_397_ = true;
            }
            let _e104 = phi_396_;
            let _e106 = phi_397_;
            phi_398_ = _e104;
            phi_399_ = _e106;
        } else {
            phi_398_ = bool();
            phi_399_ = true;
        }
        let _e108 = phi_398_;
        let _e110 = phi_399_;
        if _e110 {
            phi_403_ = false;
        } else {
            phi_403_ = _e108;
        }
        let _e112 = phi_403_;
        if !(_e112) {
            let _e115 = samples.member[_e78.first_primitive].position;
            let _e117 = p.member.light.place;
            let _e123 = p.member.light.place[3u];
            let _e130 = (_e117.x - (_e115.x * _e123));
            let _e131 = (_e117.y - (_e115.y * _e123));
            let _e132 = (_e117.z - (_e115.z * _e123));
            let _e134 = samples.member[_e78.first_primitive].normal;
            if ((((_e134.x * _e130) + (_e134.y * _e131)) + (_e134.z * _e132)) > 0f) {
                let _e148 = (((_e130 * _e130) + (_e131 * _e131)) + (_e132 * _e132));
                let _e150 = p.member.light.axis;
                let _e162 = p.member.light.place[3u];
                if (_e162 == 0f) {
                    phi_474_ = true;
                } else {
                    let _e165 = p.member.light.range_squared;
                    if (_e148 <= _e165) {
                        let _e168 = p.member.light.cos_outer;
                        phi_473_ = (-((((_e130 * _e150.x) + (_e131 * _e150.y)) + (_e132 * _e150.z))) >= (_e168 * sqrt(_e148)));
                    } else {
                        phi_473_ = false;
                    }
                    let _e173 = phi_473_;
                    phi_474_ = _e173;
                }
                let _e175 = phi_474_;
                if _e175 {
                    let _e177 = samples.member[_e78.first_primitive].flags;
                    let _e185 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e185.unnamed.visibility, false), _e185.unnamed_1);
                    phi_485_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e191.unnamed, ((_e177 & 1u) == 0u));
                    phi_486_ = false;
                } else {
                    phi_485_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_486_ = true;
                }
                let _e196 = phi_485_;
                let _e198 = phi_486_;
                phi_487_ = _e196;
                phi_488_ = _e198;
            } else {
                phi_487_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_488_ = true;
            }
            let _e200 = phi_487_;
            let _e202 = phi_488_;
            if _e202 {
                let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
                phi_495_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
            } else {
                phi_495_ = _e200;
            }
            let _e219 = phi_495_;
            phi_499_ = _e219;
        } else {
            let _e225 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e231 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e225.unnamed.visibility, false), _e225.unnamed_1);
            phi_499_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e231.unnamed, true);
        }
        let _e236 = phi_499_;
        if _e236.unnamed_1 {
            phi_1266_ = evaluate_Verdict(_e236.unnamed.visibility, _e236.unnamed.is_doubted);
        } else {
            let _e244 = samples.member[_e78.first_primitive].position;
            let _e246 = p.member.map_size;
            let _e248 = (0.5f / f32(_e246));
            let _e255 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e262 = lt_math_LightPoint(vec2<f32>(_e255.uv.x, 0f), _e255.depth, _e255.is_inside);
            let _e266 = lt_math_LightPoint(_e262.uv, 0f, _e262.is_inside);
            phi_519_ = lt_math_LightPoint();
            phi_522_ = 0u;
            phi_524_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e266.uv, _e266.depth, false));
            loop {
                let _e273 = phi_519_;
                let _e275 = phi_522_;
                let _e277 = phi_524_;
                local_2 = _e277;
                local_3 = _e277;
                local_4 = _e277;
                if (_e275 < _e85) {
                    if _e277.point.is_inside {
                        phi_685_ = lt_math_LightPoint();
                        phi_686_ = u32();
                        phi_687_ = lt_math_LevelPoint();
                        phi_688_ = false;
                    } else {
                        if (_e275 < _e72) {
                        } else {
                            return;
                        }
                        let _e288 = levels.member[(0u + _e275)].row_w;
                        let _e299 = ((((_e288.x * _e244.x) + (_e288.y * _e244.y)) + (_e288.z * _e244.z)) + (_e288.w * 1f));
                        let _e301 = levels.member[(0u + _e275)].row_x;
                        let _e313 = (((((_e301.x * _e244.x) + (_e301.y * _e244.y)) + (_e301.z * _e244.z)) + (_e301.w * 1f)) / _e299);
                        let _e315 = levels.member[(0u + _e275)].row_y;
                        let _e327 = (((((_e315.x * _e244.x) + (_e315.y * _e244.y)) + (_e315.z * _e244.z)) + (_e315.w * 1f)) / _e299);
                        let _e329 = levels.member[(0u + _e275)].row_z;
                        let _e340 = ((((_e329.x * _e244.x) + (_e329.y * _e244.y)) + (_e329.z * _e244.z)) + (_e329.w * 1f));
                        if (_e299 > 0f) {
                            if (_e313 >= 0f) {
                                phi_610_ = (_e313 <= 1f);
                            } else {
                                phi_610_ = false;
                            }
                            let _e345 = phi_610_;
                            if _e345 {
                                if (_e327 >= 0f) {
                                    phi_619_ = (_e327 <= 1f);
                                } else {
                                    phi_619_ = false;
                                }
                                let _e349 = phi_619_;
                                if _e349 {
                                    if (_e340 >= 0f) {
                                        phi_628_ = (_e340 <= 1f);
                                    } else {
                                        phi_628_ = false;
                                    }
                                    let _e353 = phi_628_;
                                    phi_629_ = _e353;
                                    phi_630_ = false;
                                } else {
                                    phi_629_ = bool();
                                    phi_630_ = true;
                                }
                                let _e355 = phi_629_;
                                let _e357 = phi_630_;
                                phi_631_ = _e355;
                                phi_632_ = _e357;
                            } else {
                                phi_631_ = bool();
                                phi_632_ = true;
                            }
                            let _e359 = phi_631_;
                            let _e361 = phi_632_;
                            phi_633_ = _e359;
                            phi_634_ = _e361;
                        } else {
                            phi_633_ = bool();
                            phi_634_ = true;
                        }
                        let _e363 = phi_633_;
                        let _e365 = phi_634_;
                        if _e365 {
                            phi_638_ = false;
                        } else {
                            phi_638_ = _e363;
                        }
                        let _e367 = phi_638_;
                        if _e367 {
                            if (_e313 >= _e248) {
                                if (_e313 <= (1f - _e248)) {
                                    if (_e327 >= _e248) {
                                        phi_665_ = (_e327 <= (1f - _e248));
                                        phi_666_ = false;
                                    } else {
                                        phi_665_ = bool();
                                        phi_666_ = true;
                                    }
                                    let _e375 = phi_665_;
                                    let _e377 = phi_666_;
                                    phi_667_ = _e375;
                                    phi_668_ = _e377;
                                } else {
                                    phi_667_ = bool();
                                    phi_668_ = true;
                                }
                                let _e379 = phi_667_;
                                let _e381 = phi_668_;
                                phi_669_ = _e379;
                                phi_670_ = _e381;
                            } else {
                                phi_669_ = bool();
                                phi_670_ = true;
                            }
                            let _e383 = phi_669_;
                            let _e385 = phi_670_;
                            phi_671_ = _e383;
                            phi_672_ = _e385;
                        } else {
                            phi_671_ = bool();
                            phi_672_ = true;
                        }
                        let _e387 = phi_671_;
                        let _e389 = phi_672_;
                        if _e389 {
                            phi_676_ = false;
                        } else {
                            phi_676_ = _e387;
                        }
                        let _e391 = phi_676_;
                        let _e398 = lt_math_LightPoint(vec2<f32>(_e313, _e273.uv.y), _e273.depth, _e273.is_inside);
                        let _e405 = lt_math_LightPoint(vec2<f32>(_e398.uv.x, _e327), _e398.depth, _e398.is_inside);
                        let _e409 = lt_math_LightPoint(_e405.uv, _e340, _e405.is_inside);
                        let _e413 = lt_math_LightPoint(_e409.uv, _e409.depth, _e391);
                        phi_685_ = _e413;
                        phi_686_ = (_e275 + 1u);
                        phi_687_ = lt_math_LevelPoint(_e275, _e413);
                        phi_688_ = true;
                    }
                    let _e417 = phi_685_;
                    let _e419 = phi_686_;
                    let _e421 = phi_687_;
                    let _e423 = phi_688_;
                    phi_520_ = _e417;
                    phi_523_ = _e419;
                    phi_525_ = _e421;
                    phi_689_ = _e423;
                } else {
                    phi_520_ = lt_math_LightPoint();
                    phi_523_ = u32();
                    phi_525_ = lt_math_LevelPoint();
                    phi_689_ = false;
                }
                let _e425 = phi_520_;
                let _e427 = phi_523_;
                let _e429 = phi_525_;
                let _e431 = phi_689_;
                continue;
                continuing {
                    phi_519_ = _e425;
                    phi_522_ = _e427;
                    phi_524_ = _e429;
                    break if !(_e431);
                }
            }
            let _e434 = local_2;
            if _e434.point.is_inside {
                if (0f > 0f) {
                    let _e440 = local_3;
                    if (_e440.level < _e72) {
                    } else {
                        return;
                    }
                    let _e445 = levels.member[(0u + _e440.level)];
                    let _e451 = global[0u];
                    if (_e445.row_w.x == _e451) {
                        let _e454 = global[1u];
                        if (_e445.row_w.y == _e454) {
                            let _e457 = global[2u];
                            phi_729_ = (_e445.row_w.z == _e457);
                            phi_730_ = false;
                        } else {
                            phi_729_ = bool();
                            phi_730_ = true;
                        }
                        let _e460 = phi_729_;
                        let _e462 = phi_730_;
                        phi_731_ = _e460;
                        phi_732_ = _e462;
                    } else {
                        phi_731_ = bool();
                        phi_732_ = true;
                    }
                    let _e464 = phi_731_;
                    let _e466 = phi_732_;
                    if _e466 {
                        phi_736_ = false;
                    } else {
                        phi_736_ = _e464;
                    }
                    let _e468 = phi_736_;
                    if _e468 {
                        let _e470 = samples.member[_e78.first_primitive].normal;
                        let _e472 = p.member.map_size;
                        let _e542 = ((abs(((((_e445.row_x.x * _e470.x) + (_e445.row_x.y * _e470.y)) + (_e445.row_x.z * _e470.z)) / (((_e445.row_x.x * _e445.row_x.x) + (_e445.row_x.y * _e445.row_x.y)) + (_e445.row_x.z * _e445.row_x.z)))) + abs(((((_e445.row_y.x * _e470.x) + (_e445.row_y.y * _e470.y)) + (_e445.row_y.z * _e470.z)) / (((_e445.row_y.x * _e445.row_y.x) + (_e445.row_y.y * _e445.row_y.y)) + (_e445.row_y.z * _e445.row_y.z))))) / (abs(((((_e445.row_z.x * _e470.x) + (_e445.row_z.y * _e470.y)) + (_e445.row_z.z * _e470.z)) / (((_e445.row_z.x * _e445.row_z.x) + (_e445.row_z.y * _e445.row_z.y)) + (_e445.row_z.z * _e445.row_z.z)))) * f32(_e472)));
                        if (_e542 < 0.002f) {
                            phi_818_ = _e542;
                        } else {
                            phi_818_ = 0.002f;
                        }
                        let _e545 = phi_818_;
                        phi_937_ = _e545;
                    } else {
                        let _e547 = p.member.map_size;
                        let _e553 = samples.member[_e78.first_primitive].position;
                        let _e564 = ((((_e445.row_w.x * _e553.x) + (_e445.row_w.y * _e553.y)) + (_e445.row_w.z * _e553.z)) + _e445.row_w.w);
                        let _e577 = ((_e445.row_x.x - (_e445.row_w.x * _e434.point.uv.x)) / _e564);
                        let _e578 = ((_e445.row_x.y - (_e445.row_w.y * _e434.point.uv.x)) / _e564);
                        let _e579 = ((_e445.row_x.z - (_e445.row_w.z * _e434.point.uv.x)) / _e564);
                        let _e592 = ((_e445.row_y.x - (_e445.row_w.x * _e434.point.uv.y)) / _e564);
                        let _e593 = ((_e445.row_y.y - (_e445.row_w.y * _e434.point.uv.y)) / _e564);
                        let _e594 = ((_e445.row_y.z - (_e445.row_w.z * _e434.point.uv.y)) / _e564);
                        let _e600 = samples.member[_e78.first_primitive].normal;
                        let _e605 = ((_e593 * _e600.z) - (_e600.y * _e594));
                        let _e610 = ((_e594 * _e600.x) - (_e600.z * _e592));
                        let _e615 = ((_e592 * _e600.y) - (_e600.x * _e593));
                        let _e617 = samples.member[_e78.first_primitive].normal;
                        let _e622 = ((_e578 * _e617.z) - (_e617.y * _e579));
                        let _e627 = ((_e579 * _e617.x) - (_e617.z * _e577));
                        let _e632 = ((_e577 * _e617.y) - (_e617.x * _e578));
                        let _e659 = ((abs(((((_e445.row_z.x * _e605) + (_e445.row_z.y * _e610)) + (_e445.row_z.z * _e615)) / (((_e577 * _e605) + (_e578 * _e610)) + (_e579 * _e615)))) + abs(((((_e445.row_z.x * _e622) + (_e445.row_z.y * _e627)) + (_e445.row_z.z * _e632)) / (((_e592 * _e622) + (_e593 * _e627)) + (_e594 * _e632))))) / f32(_e547));
                        let _e661 = (16f / f32(_e547));
                        if (_e659 < _e661) {
                            phi_936_ = _e659;
                        } else {
                            phi_936_ = _e661;
                        }
                        let _e664 = phi_936_;
                        phi_937_ = _e664;
                    }
                    let _e666 = phi_937_;
                    phi_940_ = (_e434.point.depth - (0f * _e666));
                } else {
                    phi_940_ = _e434.point.depth;
                }
                let _e670 = phi_940_;
                let _e676 = p.member.map_size;
                let _e677 = f32(_e676);
                let _e680 = ((_e434.point.uv.x * _e677) - 0.5f);
                let _e681 = ((_e434.point.uv.y * _e677) - 0.5f);
                if (_e680 > -8388608f) {
                    let _e693 = f32(select(0i, select(select(i32(_e680), i32(-2147483648), (_e680 < bitcast<f32>(3472883712u))), 2147483647i, (_e680 > bitcast<f32>(1325400063u))), (_e680 == _e680)));
                    if (_e693 > _e680) {
                        phi_969_ = 1f;
                    } else {
                        phi_969_ = 0f;
                    }
                    let _e696 = phi_969_;
                    if (_e680 < 8388608f) {
                        phi_974_ = (_e693 - _e696);
                        phi_975_ = false;
                    } else {
                        phi_974_ = f32();
                        phi_975_ = true;
                    }
                    let _e699 = phi_974_;
                    let _e701 = phi_975_;
                    phi_976_ = _e699;
                    phi_977_ = _e701;
                } else {
                    phi_976_ = f32();
                    phi_977_ = true;
                }
                let _e703 = phi_976_;
                let _e705 = phi_977_;
                if _e705 {
                    phi_981_ = _e680;
                } else {
                    phi_981_ = _e703;
                }
                let _e707 = phi_981_;
                if (_e681 > -8388608f) {
                    let _e719 = f32(select(0i, select(select(i32(_e681), i32(-2147483648), (_e681 < bitcast<f32>(3472883712u))), 2147483647i, (_e681 > bitcast<f32>(1325400063u))), (_e681 == _e681)));
                    if (_e719 > _e681) {
                        phi_1001_ = 1f;
                    } else {
                        phi_1001_ = 0f;
                    }
                    let _e722 = phi_1001_;
                    if (_e681 < 8388608f) {
                        phi_1006_ = (_e719 - _e722);
                        phi_1007_ = false;
                    } else {
                        phi_1006_ = f32();
                        phi_1007_ = true;
                    }
                    let _e725 = phi_1006_;
                    let _e727 = phi_1007_;
                    phi_1008_ = _e725;
                    phi_1009_ = _e727;
                } else {
                    phi_1008_ = f32();
                    phi_1009_ = true;
                }
                let _e729 = phi_1008_;
                let _e731 = phi_1009_;
                if _e731 {
                    phi_1013_ = _e681;
                } else {
                    phi_1013_ = _e729;
                }
                let _e733 = phi_1013_;
                let _e734 = (_e680 - _e707);
                let _e735 = (_e681 - _e733);
                let _e744 = select(0i, select(select(i32(_e707), i32(-2147483648), (_e707 < bitcast<f32>(3472883712u))), 2147483647i, (_e707 > bitcast<f32>(1325400063u))), (_e707 == _e707));
                let _e753 = select(0i, select(select(i32(_e733), i32(-2147483648), (_e733 < bitcast<f32>(3472883712u))), 2147483647i, (_e733 > bitcast<f32>(1325400063u))), (_e733 == _e733));
                let _e756 = ((1f - _e734) * (1f - _e735));
                let _e758 = (_e734 * (1f - _e735));
                let _e760 = ((1f - _e734) * _e735);
                let _e761 = (_e734 * _e735);
                let _e763 = p.member.test;
                let _e764 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e763);
                let _e766 = p.member.map_size;
                let _e768 = local_4;
                local_1 = _e764;
                let _e771 = ((_e768.level * _e766) * _e766);
                let _e773 = (bitcast<i32>(_e766) - 1i);
                if (_e744 > 0i) {
                    phi_1062_ = _e744;
                } else {
                    phi_1062_ = 0i;
                }
                let _e776 = phi_1062_;
                if (_e753 > 0i) {
                    phi_1067_ = _e753;
                } else {
                    phi_1067_ = 0i;
                }
                let _e779 = phi_1067_;
                if (_e776 < _e773) {
                    phi_1072_ = _e776;
                } else {
                    phi_1072_ = _e773;
                }
                let _e782 = phi_1072_;
                if (_e779 < _e773) {
                    phi_1077_ = _e779;
                } else {
                    phi_1077_ = _e773;
                }
                let _e785 = phi_1077_;
                let _e786 = bitcast<u32>(_e782);
                let _e788 = (_e744 + 1i);
                let _e789 = (_e753 + 1i);
                if (_e788 > 0i) {
                    phi_1086_ = _e788;
                } else {
                    phi_1086_ = 0i;
                }
                let _e792 = phi_1086_;
                if (_e789 > 0i) {
                    phi_1091_ = _e789;
                } else {
                    phi_1091_ = 0i;
                }
                let _e795 = phi_1091_;
                if (_e792 < _e773) {
                    phi_1096_ = _e792;
                } else {
                    phi_1096_ = _e773;
                }
                let _e798 = phi_1096_;
                if (_e795 < _e773) {
                    phi_1101_ = _e795;
                } else {
                    phi_1101_ = _e773;
                }
                let _e801 = phi_1101_;
                let _e802 = bitcast<u32>(_e798);
                let _e804 = (bitcast<u32>(_e785) * _e766);
                let _e805 = (bitcast<u32>(_e801) * _e766);
                let _e810 = ((_e804 + _e786) + _e771);
                let _e811 = ((_e804 + _e802) + _e771);
                let _e812 = ((_e805 + _e786) + _e771);
                let _e813 = ((_e805 + _e802) + _e771);
                if (_e810 < _e67) {
                } else {
                    return;
                }
                let _e817 = map.member[(0u + _e810)];
                if (_e811 < _e67) {
                } else {
                    return;
                }
                let _e829 = map.member[(0u + _e811)];
                if (_e812 < _e67) {
                } else {
                    return;
                }
                let _e845 = map.member[(0u + _e812)];
                if (_e813 < _e67) {
                } else {
                    return;
                }
                let _e861 = map.member[(0u + _e813)];
                let _e875 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e817.x * _e756) + (_e829.x * _e758)) + (_e845.x * _e760)) + (_e861.x * _e761)), ((((_e817.y * _e756) + (_e829.y * _e758)) + (_e845.y * _e760)) + (_e861.y * _e761)), ((((_e817.z * _e756) + (_e829.z * _e758)) + (_e845.z * _e760)) + (_e861.z * _e761)), ((((_e817.w * _e756) + (_e829.w * _e758)) + (_e845.w * _e760)) + (_e861.w * _e761))), _e670);
                let _e879 = p.member.epsilon;
                if (_e875 <= _e879) {
                    phi_1198_ = true;
                } else {
                    phi_1198_ = (_e875 >= (1f - _e879));
                }
                let _e884 = phi_1198_;
                if ((bitcast<u32>(_e875) & 2147483647u) > 2139095040u) {
                    phi_1206_ = true;
                } else {
                    phi_1206_ = !(_e884);
                }
                let _e890 = phi_1206_;
                if _e890 {
                    if (_e875 > 0f) {
                        if (_e875 < 1f) {
                            phi_1218_ = false;
                        } else {
                            phi_1218_ = true;
                        }
                        let _e894 = phi_1218_;
                        phi_1219_ = _e894;
                    } else {
                        phi_1219_ = true;
                    }
                    let _e896 = phi_1219_;
                    if _e896 {
                        phi_1223_ = 0.5f;
                    } else {
                        phi_1223_ = _e875;
                    }
                    let _e898 = phi_1223_;
                    phi_1231_ = evaluate_Verdict(_e898, true);
                } else {
                    if (_e875 > 0.5f) {
                        phi_1229_ = 1f;
                    } else {
                        phi_1229_ = 0f;
                    }
                    let _e902 = phi_1229_;
                    phi_1231_ = evaluate_Verdict(_e902, false);
                }
                let _e905 = phi_1231_;
                let _e908 = (_e905.visibility < 0.5f);
                if _e905.is_doubted {
                    phi_1254_ = evaluate_Verdict();
                    phi_1255_ = true;
                } else {
                    if _e908 {
                        phi_1241_ = 2u;
                    } else {
                        phi_1241_ = 1u;
                    }
                    let _e910 = phi_1241_;
                    if ((0u & _e910) != 0u) {
                        if _e908 {
                            phi_1250_ = 0.000000059604645f;
                        } else {
                            phi_1250_ = 0.99999994f;
                        }
                        let _e914 = phi_1250_;
                        phi_1252_ = evaluate_Verdict(_e914, true);
                        phi_1253_ = false;
                    } else {
                        phi_1252_ = evaluate_Verdict();
                        phi_1253_ = true;
                    }
                    let _e917 = phi_1252_;
                    let _e919 = phi_1253_;
                    phi_1254_ = _e917;
                    phi_1255_ = _e919;
                }
                let _e921 = phi_1254_;
                let _e923 = phi_1255_;
                if _e923 {
                    phi_1260_ = evaluate_Verdict(_e905.visibility, _e905.is_doubted);
                } else {
                    phi_1260_ = _e921;
                }
                let _e926 = phi_1260_;
                phi_1265_ = evaluate_Verdict(_e926.visibility, _e926.is_doubted);
            } else {
                phi_1265_ = evaluate_Verdict(0.5f, true);
            }
            let _e932 = phi_1265_;
            phi_1266_ = _e932;
        }
        let _e934 = phi_1266_;
        visibility.member[_e78.first_primitive] = _e934.visibility;
        phi_1270_ = _e934.is_doubted;
        phi_1271_ = _e78.first_primitive;
    } else {
        phi_1270_ = false;
        phi_1271_ = 0u;
    }
    let _e939 = phi_1270_;
    let _e941 = phi_1271_;
    if (_e62 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e939 {
        let _e945 = atomicAdd((&shared_[0u]), 1u);
        phi_1282_ = _e945;
    } else {
        phi_1282_ = 0u;
    }
    let _e947 = phi_1282_;
    workgroupBarrier();
    if (_e62 == 0u) {
        let _e951 = atomicLoad((&shared_[0u]));
        let _e952 = atomicAdd((&list.member[3u]), _e951);
        atomicStore((&shared_[1u]), _e952);
    }
    workgroupBarrier();
    if _e939 {
        if false {
            phi_1299_ = (_e941 | 2147483648u);
        } else {
            phi_1299_ = _e941;
        }
        let _e956 = phi_1299_;
        let _e958 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e958) + _e947)]), _e956);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
