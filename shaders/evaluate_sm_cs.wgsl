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

struct type_30 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_131_: lt_bvh_traverse_Tree;
    var phi_132_: bool;
    var phi_133_: lt_bvh_traverse_Tree;
    var phi_134_: bool;
    var phi_139_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_131_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_132_ = false;
        } else {
            phi_131_ = lt_bvh_traverse_Tree();
            phi_132_ = true;
        }
        let _e46 = phi_131_;
        let _e48 = phi_132_;
        phi_133_ = _e46;
        phi_134_ = _e48;
    } else {
        phi_133_ = lt_bvh_traverse_Tree();
        phi_134_ = true;
    }
    let _e50 = phi_133_;
    let _e52 = phi_134_;
    if _e52 {
        phi_139_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_139_ = _e50;
    }
    let _e57 = phi_139_;
    return lt_bvh_traverse_Tree(_e57.root, _e57.first_primitive);
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_3: ptr<function, f32>, param_4: vec4<f32>, param_5: f32) -> f32 {
    var phi_810_: f32;
    var phi_811_: f32;
    var phi_812_: f32;
    var phi_829_: f32;
    var phi_830_: f32;
    var phi_831_: f32;

    let _e37 = (*param_3);
    let _e38 = (param_4.x + _e37);
    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_812_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_811_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_810_ = 1f;
            } else {
                phi_810_ = param_5;
            }
            let _e45 = phi_810_;
            phi_811_ = _e45;
        }
        let _e47 = phi_811_;
        phi_812_ = _e47;
    }
    let _e49 = phi_812_;
    if ((bitcast<u32>(_e38) & 2147483647u) > 2139095040u) {
        phi_831_ = _e38;
    } else {
        if ((bitcast<u32>(_e49) & 2147483647u) > 2139095040u) {
            phi_830_ = _e49;
        } else {
            if (_e38 < _e49) {
                phi_829_ = 0f;
            } else {
                phi_829_ = 1f;
            }
            let _e58 = phi_829_;
            phi_830_ = _e58;
        }
        let _e60 = phi_830_;
        phi_831_ = _e60;
    }
    let _e62 = phi_831_;
    return _e62;
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6: f32) -> vec4<f32> {
    var phi_785_: f32;
    var phi_786_: f32;
    var phi_787_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_787_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_786_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_785_ = 1f;
            } else {
                phi_785_ = param_6;
            }
            let _e40 = phi_785_;
            phi_786_ = _e40;
        }
        let _e42 = phi_786_;
        phi_787_ = _e42;
    }
    let _e44 = phi_787_;
    return vec4<f32>(_e44, 0f, 0f, 0f);
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, f32>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_748_: f32;
    var phi_749_: f32;
    var phi_757_: f32;
    var phi_758_: f32;
    var phi_765_: f32;
    var phi_768_: f32;

    let _e43 = (((param_9.x + param_9.y) + param_9.z) + param_9.w);
    if ((bitcast<u32>(_e43) & 2147483647u) > 2139095040u) {
        phi_768_ = _e43;
    } else {
        if (param_9.y > param_9.x) {
            phi_748_ = param_8.y;
            phi_749_ = param_9.y;
        } else {
            phi_748_ = param_8.x;
            phi_749_ = param_9.x;
        }
        let _e54 = phi_748_;
        let _e56 = phi_749_;
        if (param_9.z > _e56) {
            phi_757_ = param_8.z;
            phi_758_ = param_9.z;
        } else {
            phi_757_ = _e54;
            phi_758_ = _e56;
        }
        let _e62 = phi_757_;
        let _e64 = phi_758_;
        if (param_9.w > _e64) {
            phi_765_ = param_8.w;
        } else {
            phi_765_ = _e62;
        }
        let _e69 = phi_765_;
        let _e70 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e69);
        let _e71 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_7, _e70, param_10);
        phi_768_ = _e71;
    }
    let _e73 = phi_768_;
    return _e73;
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_11: vec4<f32>) -> f32 {
    return param_11.x;
}

fn function_() {
    var local: f32;
    var phi_198_: bool;
    var phi_199_: bool;
    var phi_200_: bool;
    var phi_201_: bool;
    var phi_205_: bool;
    var phi_275_: bool;
    var phi_276_: bool;
    var phi_287_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_288_: bool;
    var phi_289_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_290_: bool;
    var phi_297_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_301_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_375_: bool;
    var phi_384_: bool;
    var phi_393_: bool;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_403_: bool;
    var phi_493_: f32;
    var phi_496_: f32;
    var phi_525_: f32;
    var phi_530_: f32;
    var phi_531_: bool;
    var phi_532_: f32;
    var phi_533_: bool;
    var phi_537_: f32;
    var phi_557_: f32;
    var phi_562_: f32;
    var phi_563_: bool;
    var phi_564_: f32;
    var phi_565_: bool;
    var phi_569_: f32;
    var phi_617_: i32;
    var phi_622_: i32;
    var phi_627_: i32;
    var phi_632_: i32;
    var phi_641_: i32;
    var phi_646_: i32;
    var phi_651_: i32;
    var phi_656_: i32;
    var phi_701_: evaluate_Verdict;
    var phi_702_: evaluate_Verdict;
    var phi_703_: bool;
    var phi_704_: evaluate_Verdict;
    var phi_705_: evaluate_Verdict;
    var phi_706_: bool;
    var phi_710_: evaluate_Verdict;

    let _e34 = id_1;
    let _e41 = arrayLength((&map.member));
    let _e47 = p.member.size[0u];
    let _e49 = p.member.size[1u];
    let _e50 = lt_shaders_entry_pixel_index(_e34, _e47, _e49);
    if (bitcast<i32>(_e50.root) != 0i) {
        let _e56 = p.member.projection;
        if (_e50.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e60 = lt_math_OneLevel(_e56);
        let _e64 = samples.member[(0u + _e50.first_primitive)].normal[0u];
        let _e66 = global[0u];
        if (_e64 == _e66) {
            let _e69 = samples.member[(0u + _e50.first_primitive)].normal[1u];
            let _e71 = global[1u];
            if (_e69 == _e71) {
                let _e74 = samples.member[(0u + _e50.first_primitive)].normal[2u];
                let _e76 = global[2u];
                phi_198_ = (_e74 == _e76);
                phi_199_ = false;
            } else {
                phi_198_ = bool();
                phi_199_ = true;
            }
            let _e79 = phi_198_;
            let _e81 = phi_199_;
            phi_200_ = _e79;
            phi_201_ = _e81;
        } else {
            phi_200_ = bool();
            phi_201_ = true;
        }
        let _e83 = phi_200_;
        let _e85 = phi_201_;
        if _e85 {
            phi_205_ = false;
        } else {
            phi_205_ = _e83;
        }
        let _e87 = phi_205_;
        if !(_e87) {
            let _e90 = samples.member[(0u + _e50.first_primitive)].position;
            let _e92 = p.member.light.place;
            let _e98 = p.member.light.place[3u];
            let _e105 = (_e92.x - (_e90.x * _e98));
            let _e106 = (_e92.y - (_e90.y * _e98));
            let _e107 = (_e92.z - (_e90.z * _e98));
            let _e109 = samples.member[(0u + _e50.first_primitive)].normal;
            if ((((_e109.x * _e105) + (_e109.y * _e106)) + (_e109.z * _e107)) > 0f) {
                let _e123 = (((_e105 * _e105) + (_e106 * _e106)) + (_e107 * _e107));
                let _e125 = p.member.light.axis;
                let _e137 = p.member.light.place[3u];
                if (_e137 == 0f) {
                    phi_276_ = true;
                } else {
                    let _e140 = p.member.light.range_squared;
                    if (_e123 <= _e140) {
                        let _e143 = p.member.light.cos_outer;
                        phi_275_ = (-((((_e105 * _e125.x) + (_e106 * _e125.y)) + (_e107 * _e125.z))) >= (_e143 * sqrt(_e123)));
                    } else {
                        phi_275_ = false;
                    }
                    let _e148 = phi_275_;
                    phi_276_ = _e148;
                }
                let _e150 = phi_276_;
                if _e150 {
                    let _e152 = samples.member[(0u + _e50.first_primitive)].flags;
                    let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e160.unnamed.visibility, false), _e160.unnamed_1);
                    phi_287_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e166.unnamed, ((_e152 & 1u) == 0u));
                    phi_288_ = false;
                } else {
                    phi_287_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_288_ = true;
                }
                let _e171 = phi_287_;
                let _e173 = phi_288_;
                phi_289_ = _e171;
                phi_290_ = _e173;
            } else {
                phi_289_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_290_ = true;
            }
            let _e175 = phi_289_;
            let _e177 = phi_290_;
            if _e177 {
                let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e189 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e183.unnamed.visibility, false), _e183.unnamed_1);
                phi_297_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e189.unnamed, true);
            } else {
                phi_297_ = _e175;
            }
            let _e194 = phi_297_;
            phi_301_ = _e194;
        } else {
            let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e200.unnamed.visibility, false), _e200.unnamed_1);
            phi_301_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e206.unnamed, true);
        }
        let _e211 = phi_301_;
        if _e211.unnamed_1 {
            phi_704_ = evaluate_Verdict(_e211.unnamed.visibility, _e211.unnamed.is_doubted);
            phi_705_ = evaluate_Verdict();
            phi_706_ = true;
        } else {
            let _e219 = samples.member[(0u + _e50.first_primitive)].position;
            let _e237 = ((((_e60.projection.row_w.x * _e219.x) + (_e60.projection.row_w.y * _e219.y)) + (_e60.projection.row_w.z * _e219.z)) + (_e60.projection.row_w.w * 1f));
            let _e251 = (((((_e60.projection.row_x.x * _e219.x) + (_e60.projection.row_x.y * _e219.y)) + (_e60.projection.row_x.z * _e219.z)) + (_e60.projection.row_x.w * 1f)) / _e237);
            let _e265 = (((((_e60.projection.row_y.x * _e219.x) + (_e60.projection.row_y.y * _e219.y)) + (_e60.projection.row_y.z * _e219.z)) + (_e60.projection.row_y.w * 1f)) / _e237);
            let _e278 = ((((_e60.projection.row_z.x * _e219.x) + (_e60.projection.row_z.y * _e219.y)) + (_e60.projection.row_z.z * _e219.z)) + (_e60.projection.row_z.w * 1f));
            if (_e237 > 0f) {
                if (_e251 >= 0f) {
                    phi_375_ = (_e251 <= 1f);
                } else {
                    phi_375_ = false;
                }
                let _e283 = phi_375_;
                if _e283 {
                    if (_e265 >= 0f) {
                        phi_384_ = (_e265 <= 1f);
                    } else {
                        phi_384_ = false;
                    }
                    let _e287 = phi_384_;
                    if _e287 {
                        if (_e278 >= 0f) {
                            phi_393_ = (_e278 <= 1f);
                        } else {
                            phi_393_ = false;
                        }
                        let _e291 = phi_393_;
                        phi_394_ = _e291;
                        phi_395_ = false;
                    } else {
                        phi_394_ = bool();
                        phi_395_ = true;
                    }
                    let _e293 = phi_394_;
                    let _e295 = phi_395_;
                    phi_396_ = _e293;
                    phi_397_ = _e295;
                } else {
                    phi_396_ = bool();
                    phi_397_ = true;
                }
                let _e297 = phi_396_;
                let _e299 = phi_397_;
                phi_398_ = _e297;
                phi_399_ = _e299;
            } else {
                phi_398_ = bool();
                phi_399_ = true;
            }
            let _e301 = phi_398_;
            let _e303 = phi_399_;
            if _e303 {
                phi_403_ = false;
            } else {
                phi_403_ = _e301;
            }
            let _e305 = phi_403_;
            if _e305 {
                if (0.5f > 0f) {
                    let _e308 = samples.member[(0u + _e50.first_primitive)].normal;
                    let _e310 = p.member.map_size;
                    let _e380 = ((abs(((((_e56.row_x.x * _e308.x) + (_e56.row_x.y * _e308.y)) + (_e56.row_x.z * _e308.z)) / (((_e56.row_x.x * _e56.row_x.x) + (_e56.row_x.y * _e56.row_x.y)) + (_e56.row_x.z * _e56.row_x.z)))) + abs(((((_e56.row_y.x * _e308.x) + (_e56.row_y.y * _e308.y)) + (_e56.row_y.z * _e308.z)) / (((_e56.row_y.x * _e56.row_y.x) + (_e56.row_y.y * _e56.row_y.y)) + (_e56.row_y.z * _e56.row_y.z))))) / (abs(((((_e56.row_z.x * _e308.x) + (_e56.row_z.y * _e308.y)) + (_e56.row_z.z * _e308.z)) / (((_e56.row_z.x * _e56.row_z.x) + (_e56.row_z.y * _e56.row_z.y)) + (_e56.row_z.z * _e56.row_z.z)))) * f32(_e310)));
                    if (_e380 < 0.002f) {
                        phi_493_ = _e380;
                    } else {
                        phi_493_ = 0.002f;
                    }
                    let _e383 = phi_493_;
                    phi_496_ = (_e278 - (0.5f * _e383));
                } else {
                    phi_496_ = _e278;
                }
                let _e387 = phi_496_;
                let _e389 = p.member.map_size;
                let _e390 = f32(_e389);
                let _e393 = ((_e251 * _e390) - 0.5f);
                let _e394 = ((_e265 * _e390) - 0.5f);
                if (_e393 > -8388608f) {
                    let _e406 = f32(select(0i, select(select(i32(_e393), i32(-2147483648), (_e393 < bitcast<f32>(3472883712u))), 2147483647i, (_e393 > bitcast<f32>(1325400063u))), (_e393 == _e393)));
                    if (_e406 > _e393) {
                        phi_525_ = 1f;
                    } else {
                        phi_525_ = 0f;
                    }
                    let _e409 = phi_525_;
                    if (_e393 < 8388608f) {
                        phi_530_ = (_e406 - _e409);
                        phi_531_ = false;
                    } else {
                        phi_530_ = f32();
                        phi_531_ = true;
                    }
                    let _e412 = phi_530_;
                    let _e414 = phi_531_;
                    phi_532_ = _e412;
                    phi_533_ = _e414;
                } else {
                    phi_532_ = f32();
                    phi_533_ = true;
                }
                let _e416 = phi_532_;
                let _e418 = phi_533_;
                if _e418 {
                    phi_537_ = _e393;
                } else {
                    phi_537_ = _e416;
                }
                let _e420 = phi_537_;
                if (_e394 > -8388608f) {
                    let _e432 = f32(select(0i, select(select(i32(_e394), i32(-2147483648), (_e394 < bitcast<f32>(3472883712u))), 2147483647i, (_e394 > bitcast<f32>(1325400063u))), (_e394 == _e394)));
                    if (_e432 > _e394) {
                        phi_557_ = 1f;
                    } else {
                        phi_557_ = 0f;
                    }
                    let _e435 = phi_557_;
                    if (_e394 < 8388608f) {
                        phi_562_ = (_e432 - _e435);
                        phi_563_ = false;
                    } else {
                        phi_562_ = f32();
                        phi_563_ = true;
                    }
                    let _e438 = phi_562_;
                    let _e440 = phi_563_;
                    phi_564_ = _e438;
                    phi_565_ = _e440;
                } else {
                    phi_564_ = f32();
                    phi_565_ = true;
                }
                let _e442 = phi_564_;
                let _e444 = phi_565_;
                if _e444 {
                    phi_569_ = _e394;
                } else {
                    phi_569_ = _e442;
                }
                let _e446 = phi_569_;
                let _e447 = (_e393 - _e420);
                let _e448 = (_e394 - _e446);
                let _e457 = select(0i, select(select(i32(_e420), i32(-2147483648), (_e420 < bitcast<f32>(3472883712u))), 2147483647i, (_e420 > bitcast<f32>(1325400063u))), (_e420 == _e420));
                let _e466 = select(0i, select(select(i32(_e446), i32(-2147483648), (_e446 < bitcast<f32>(3472883712u))), 2147483647i, (_e446 > bitcast<f32>(1325400063u))), (_e446 == _e446));
                let _e477 = p.member.test;
                let _e478 = _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e477);
                let _e480 = p.member.map_size;
                local = _e478;
                let _e482 = ((0u * _e480) * _e480);
                let _e484 = (bitcast<i32>(_e480) - 1i);
                if (_e457 > 0i) {
                    phi_617_ = _e457;
                } else {
                    phi_617_ = 0i;
                }
                let _e487 = phi_617_;
                if (_e466 > 0i) {
                    phi_622_ = _e466;
                } else {
                    phi_622_ = 0i;
                }
                let _e490 = phi_622_;
                if (_e487 < _e484) {
                    phi_627_ = _e487;
                } else {
                    phi_627_ = _e484;
                }
                let _e493 = phi_627_;
                if (_e490 < _e484) {
                    phi_632_ = _e490;
                } else {
                    phi_632_ = _e484;
                }
                let _e496 = phi_632_;
                let _e497 = bitcast<u32>(_e493);
                let _e499 = (_e457 + 1i);
                let _e500 = (_e466 + 1i);
                if (_e499 > 0i) {
                    phi_641_ = _e499;
                } else {
                    phi_641_ = 0i;
                }
                let _e503 = phi_641_;
                if (_e500 > 0i) {
                    phi_646_ = _e500;
                } else {
                    phi_646_ = 0i;
                }
                let _e506 = phi_646_;
                if (_e503 < _e484) {
                    phi_651_ = _e503;
                } else {
                    phi_651_ = _e484;
                }
                let _e509 = phi_651_;
                if (_e506 < _e484) {
                    phi_656_ = _e506;
                } else {
                    phi_656_ = _e484;
                }
                let _e512 = phi_656_;
                let _e513 = bitcast<u32>(_e509);
                let _e515 = (bitcast<u32>(_e496) * _e480);
                let _e516 = (bitcast<u32>(_e512) * _e480);
                let _e521 = ((_e515 + _e497) + _e482);
                let _e522 = ((_e515 + _e513) + _e482);
                let _e523 = ((_e516 + _e497) + _e482);
                let _e524 = ((_e516 + _e513) + _e482);
                if (_e521 < _e41) {
                } else {
                    return;
                }
                let _e528 = map.member[(0u + _e521)];
                if (_e522 < _e41) {
                } else {
                    return;
                }
                let _e532 = map.member[(0u + _e522)];
                if (_e523 < _e41) {
                } else {
                    return;
                }
                let _e536 = map.member[(0u + _e523)];
                if (_e524 < _e41) {
                } else {
                    return;
                }
                let _e540 = map.member[(0u + _e524)];
                let _e542 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e528, _e532, _e536, _e540), vec4<f32>(((1f - _e447) * (1f - _e448)), (_e447 * (1f - _e448)), ((1f - _e447) * _e448), (_e447 * _e448)), _e387);
                phi_701_ = evaluate_Verdict(_e542, false);
                phi_702_ = evaluate_Verdict();
                phi_703_ = false;
            } else {
                phi_701_ = evaluate_Verdict();
                phi_702_ = evaluate_Verdict(1f, false);
                phi_703_ = true;
            }
            let _e546 = phi_701_;
            let _e548 = phi_702_;
            let _e550 = phi_703_;
            phi_704_ = _e548;
            phi_705_ = _e546;
            phi_706_ = _e550;
        }
        let _e552 = phi_704_;
        let _e554 = phi_705_;
        let _e556 = phi_706_;
        if _e556 {
            phi_710_ = _e552;
        } else {
            phi_710_ = _e554;
        }
        let _e558 = phi_710_;
        if (_e50.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e50.first_primitive)] = _e558.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_sm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
