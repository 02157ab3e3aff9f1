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
    var phi_129_: lt_bvh_traverse_Tree;
    var phi_130_: bool;
    var phi_131_: lt_bvh_traverse_Tree;
    var phi_132_: bool;
    var phi_137_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_129_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_130_ = false;
        } else {
            phi_129_ = lt_bvh_traverse_Tree();
            phi_130_ = true;
        }
        let _e46 = phi_129_;
        let _e48 = phi_130_;
        phi_131_ = _e46;
        phi_132_ = _e48;
    } else {
        phi_131_ = lt_bvh_traverse_Tree();
        phi_132_ = true;
    }
    let _e50 = phi_131_;
    let _e52 = phi_132_;
    if _e52 {
        phi_137_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_137_ = _e50;
    }
    let _e57 = phi_137_;
    return lt_bvh_traverse_Tree(_e57.root, _e57.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_738_: f32;
    var phi_739_: f32;
    var phi_740_: f32;
    var phi_756_: f32;
    var phi_757_: f32;
    var phi_758_: f32;
    var phi_774_: f32;
    var phi_775_: f32;
    var phi_776_: f32;
    var phi_792_: f32;
    var phi_793_: f32;
    var phi_794_: f32;
    var phi_810_: f32;
    var phi_811_: f32;
    var phi_812_: f32;
    var phi_858_: bool;
    var phi_862_: f32;
    var phi_874_: bool;
    var phi_881_: f32;
    var phi_896_: f32;
    var phi_897_: f32;
    var phi_898_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_740_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_739_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_738_ = 1f;
            } else {
                phi_738_ = param_7;
            }
            let _e43 = phi_738_;
            phi_739_ = _e43;
        }
        let _e45 = phi_739_;
        phi_740_ = _e45;
    }
    let _e47 = phi_740_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_758_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_757_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_756_ = 1f;
            } else {
                phi_756_ = param_5.x;
            }
            let _e55 = phi_756_;
            phi_757_ = _e55;
        }
        let _e57 = phi_757_;
        phi_758_ = _e57;
    }
    let _e59 = phi_758_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_776_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_775_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_774_ = 1f;
            } else {
                phi_774_ = param_5.y;
            }
            let _e67 = phi_774_;
            phi_775_ = _e67;
        }
        let _e69 = phi_775_;
        phi_776_ = _e69;
    }
    let _e71 = phi_776_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_794_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_793_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_792_ = 1f;
            } else {
                phi_792_ = param_5.z;
            }
            let _e79 = phi_792_;
            phi_793_ = _e79;
        }
        let _e81 = phi_793_;
        phi_794_ = _e81;
    }
    let _e83 = phi_794_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_812_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_811_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_810_ = 1f;
            } else {
                phi_810_ = param_5.w;
            }
            let _e91 = phi_810_;
            phi_811_ = _e91;
        }
        let _e93 = phi_811_;
        phi_812_ = _e93;
    }
    let _e95 = phi_812_;
    let _e96 = (_e59 - _e47);
    let _e97 = (_e71 - _e47);
    let _e98 = (_e83 - _e47);
    let _e99 = (_e95 - _e47);
    let _e100 = (*param_4);
    let _e111 = ((((_e96 * param_6.x) + (_e97 * param_6.y)) + (_e98 * param_6.z)) + (_e99 * param_6.w));
    let _e112 = (_e96 - _e111);
    let _e113 = (_e97 - _e111);
    let _e114 = (_e98 - _e111);
    let _e115 = (_e99 - _e111);
    let _e130 = (((((_e112 * _e112) * param_6.x) + ((_e113 * _e113) * param_6.y)) + ((_e114 * _e114) * param_6.z)) + ((_e115 * _e115) * param_6.w));
    if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
        phi_858_ = true;
    } else {
        let _e134 = (_e100 > _e130);
        if _e134 {
        }
        phi_858_ = _e134;
    }
    let _e136 = phi_858_;
    if _e136 {
        phi_862_ = _e100;
    } else {
        phi_862_ = _e130;
    }
    let _e138 = phi_862_;
    let _e139 = -(_e111);
    if (_e139 <= 0f) {
        let _e143 = ((bitcast<u32>(_e138) & 2147483647u) > 2139095040u);
        if _e143 {
        }
        phi_874_ = _e143;
    } else {
        phi_874_ = true;
    }
    let _e145 = phi_874_;
    if _e145 {
        phi_881_ = (_e138 / (_e138 + (_e139 * _e139)));
    } else {
        phi_881_ = 1f;
    }
    let _e150 = phi_881_;
    if ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u) {
        phi_898_ = _e150;
    } else {
        if (_e150 < 0f) {
            phi_897_ = 0f;
        } else {
            if (_e150 > 1f) {
                phi_896_ = 1f;
            } else {
                phi_896_ = _e150;
            }
            let _e157 = phi_896_;
            phi_897_ = _e157;
        }
        let _e159 = phi_897_;
        phi_898_ = _e159;
    }
    let _e161 = phi_898_;
    return _e161;
}

fn function_() {
    var local: f32;
    var phi_199_: bool;
    var phi_200_: bool;
    var phi_201_: bool;
    var phi_202_: bool;
    var phi_206_: bool;
    var phi_276_: bool;
    var phi_277_: bool;
    var phi_288_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_289_: bool;
    var phi_290_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_291_: bool;
    var phi_298_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_302_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_376_: bool;
    var phi_385_: bool;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_404_: bool;
    var phi_494_: f32;
    var phi_497_: f32;
    var phi_526_: f32;
    var phi_531_: f32;
    var phi_532_: bool;
    var phi_533_: f32;
    var phi_534_: bool;
    var phi_538_: f32;
    var phi_558_: f32;
    var phi_563_: f32;
    var phi_564_: bool;
    var phi_565_: f32;
    var phi_566_: bool;
    var phi_570_: f32;
    var phi_618_: i32;
    var phi_623_: i32;
    var phi_628_: i32;
    var phi_633_: i32;
    var phi_642_: i32;
    var phi_647_: i32;
    var phi_652_: i32;
    var phi_657_: i32;
    var phi_702_: evaluate_Verdict;
    var phi_703_: evaluate_Verdict;
    var phi_704_: bool;
    var phi_705_: evaluate_Verdict;
    var phi_706_: evaluate_Verdict;
    var phi_707_: bool;
    var phi_711_: evaluate_Verdict;

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
                phi_199_ = (_e74 == _e76);
                phi_200_ = false;
            } else {
                phi_199_ = bool();
                phi_200_ = true;
            }
            let _e79 = phi_199_;
            let _e81 = phi_200_;
            phi_201_ = _e79;
            phi_202_ = _e81;
        } else {
            phi_201_ = bool();
            phi_202_ = true;
        }
        let _e83 = phi_201_;
        let _e85 = phi_202_;
        if _e85 {
            phi_206_ = false;
        } else {
            phi_206_ = _e83;
        }
        let _e87 = phi_206_;
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
                    phi_277_ = true;
                } else {
                    let _e140 = p.member.light.range_squared;
                    if (_e123 <= _e140) {
                        let _e143 = p.member.light.cos_outer;
                        phi_276_ = (-((((_e105 * _e125.x) + (_e106 * _e125.y)) + (_e107 * _e125.z))) >= (_e143 * sqrt(_e123)));
                    } else {
                        phi_276_ = false;
                    }
                    let _e148 = phi_276_;
                    phi_277_ = _e148;
                }
                let _e150 = phi_277_;
                if _e150 {
                    let _e152 = samples.member[(0u + _e50.first_primitive)].flags;
                    let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e160.unnamed.visibility, false), _e160.unnamed_1);
                    phi_288_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e166.unnamed, ((_e152 & 1u) == 0u));
                    phi_289_ = false;
                } else {
                    phi_288_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_289_ = true;
                }
                let _e171 = phi_288_;
                let _e173 = phi_289_;
                phi_290_ = _e171;
                phi_291_ = _e173;
            } else {
                phi_290_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_291_ = true;
            }
            let _e175 = phi_290_;
            let _e177 = phi_291_;
            if _e177 {
                let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e189 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e183.unnamed.visibility, false), _e183.unnamed_1);
                phi_298_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e189.unnamed, true);
            } else {
                phi_298_ = _e175;
            }
            let _e194 = phi_298_;
            phi_302_ = _e194;
        } else {
            let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e200.unnamed.visibility, false), _e200.unnamed_1);
            phi_302_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e206.unnamed, true);
        }
        let _e211 = phi_302_;
        if _e211.unnamed_1 {
            phi_705_ = evaluate_Verdict(_e211.unnamed.visibility, _e211.unnamed.is_doubted);
            phi_706_ = evaluate_Verdict();
            phi_707_ = true;
        } else {
            let _e219 = samples.member[(0u + _e50.first_primitive)].position;
            let _e237 = ((((_e60.projection.row_w.x * _e219.x) + (_e60.projection.row_w.y * _e219.y)) + (_e60.projection.row_w.z * _e219.z)) + (_e60.projection.row_w.w * 1f));
            let _e251 = (((((_e60.projection.row_x.x * _e219.x) + (_e60.projection.row_x.y * _e219.y)) + (_e60.projection.row_x.z * _e219.z)) + (_e60.projection.row_x.w * 1f)) / _e237);
            let _e265 = (((((_e60.projection.row_y.x * _e219.x) + (_e60.projection.row_y.y * _e219.y)) + (_e60.projection.row_y.z * _e219.z)) + (_e60.projection.row_y.w * 1f)) / _e237);
            let _e278 = ((((_e60.projection.row_z.x * _e219.x) + (_e60.projection.row_z.y * _e219.y)) + (_e60.projection.row_z.z * _e219.z)) + (_e60.projection.row_z.w * 1f));
            if (_e237 > 0f) {
                if (_e251 >= 0f) {
                    phi_376_ = (_e251 <= 1f);
                } else {
                    phi_376_ = false;
                }
                let _e283 = phi_376_;
                if _e283 {
                    if (_e265 >= 0f) {
                        phi_385_ = (_e265 <= 1f);
                    } else {
                        phi_385_ = false;
                    }
                    let _e287 = phi_385_;
                    if _e287 {
                        if (_e278 >= 0f) {
                            phi_394_ = (_e278 <= 1f);
                        } else {
                            phi_394_ = false;
                        }
                        let _e291 = phi_394_;
                        phi_395_ = _e291;
                        phi_396_ = false;
                    } else {
                        phi_395_ = bool();
                        phi_396_ = true;
                    }
                    let _e293 = phi_395_;
                    let _e295 = phi_396_;
                    phi_397_ = _e293;
                    phi_398_ = _e295;
                } else {
                    phi_397_ = bool();
                    phi_398_ = true;
                }
                let _e297 = phi_397_;
                let _e299 = phi_398_;
                phi_399_ = _e297;
                phi_400_ = _e299;
            } else {
                phi_399_ = bool();
                phi_400_ = true;
            }
            let _e301 = phi_399_;
            let _e303 = phi_400_;
            if _e303 {
                phi_404_ = false;
            } else {
                phi_404_ = _e301;
            }
            let _e305 = phi_404_;
            if _e305 {
                if (0f > 0f) {
                    let _e308 = samples.member[(0u + _e50.first_primitive)].normal;
                    let _e310 = p.member.map_size;
                    let _e380 = ((abs(((((_e56.row_x.x * _e308.x) + (_e56.row_x.y * _e308.y)) + (_e56.row_x.z * _e308.z)) / (((_e56.row_x.x * _e56.row_x.x) + (_e56.row_x.y * _e56.row_x.y)) + (_e56.row_x.z * _e56.row_x.z)))) + abs(((((_e56.row_y.x * _e308.x) + (_e56.row_y.y * _e308.y)) + (_e56.row_y.z * _e308.z)) / (((_e56.row_y.x * _e56.row_y.x) + (_e56.row_y.y * _e56.row_y.y)) + (_e56.row_y.z * _e56.row_y.z))))) / (abs(((((_e56.row_z.x * _e308.x) + (_e56.row_z.y * _e308.y)) + (_e56.row_z.z * _e308.z)) / (((_e56.row_z.x * _e56.row_z.x) + (_e56.row_z.y * _e56.row_z.y)) + (_e56.row_z.z * _e56.row_z.z)))) * f32(_e310)));
                    if (_e380 < 0.002f) {
                        phi_494_ = _e380;
                    } else {
                        phi_494_ = 0.002f;
                    }
                    let _e383 = phi_494_;
                    phi_497_ = (_e278 - (0f * _e383));
                } else {
                    phi_497_ = _e278;
                }
                let _e387 = phi_497_;
                let _e389 = p.member.map_size;
                let _e390 = f32(_e389);
                let _e393 = ((_e251 * _e390) - 0.5f);
                let _e394 = ((_e265 * _e390) - 0.5f);
                if (_e393 > -8388608f) {
                    let _e406 = f32(select(0i, select(select(i32(_e393), i32(-2147483648), (_e393 < bitcast<f32>(3472883712u))), 2147483647i, (_e393 > bitcast<f32>(1325400063u))), (_e393 == _e393)));
                    if (_e406 > _e393) {
                        phi_526_ = 1f;
                    } else {
                        phi_526_ = 0f;
                    }
                    let _e409 = phi_526_;
                    if (_e393 < 8388608f) {
                        phi_531_ = (_e406 - _e409);
                        phi_532_ = false;
                    } else {
                        phi_531_ = f32();
                        phi_532_ = true;
                    }
                    let _e412 = phi_531_;
                    let _e414 = phi_532_;
                    phi_533_ = _e412;
                    phi_534_ = _e414;
                } else {
                    phi_533_ = f32();
                    phi_534_ = true;
                }
                let _e416 = phi_533_;
                let _e418 = phi_534_;
                if _e418 {
                    phi_538_ = _e393;
                } else {
                    phi_538_ = _e416;
                }
                let _e420 = phi_538_;
                if (_e394 > -8388608f) {
                    let _e432 = f32(select(0i, select(select(i32(_e394), i32(-2147483648), (_e394 < bitcast<f32>(3472883712u))), 2147483647i, (_e394 > bitcast<f32>(1325400063u))), (_e394 == _e394)));
                    if (_e432 > _e394) {
                        phi_558_ = 1f;
                    } else {
                        phi_558_ = 0f;
                    }
                    let _e435 = phi_558_;
                    if (_e394 < 8388608f) {
                        phi_563_ = (_e432 - _e435);
                        phi_564_ = false;
                    } else {
                        phi_563_ = f32();
                        phi_564_ = true;
                    }
                    let _e438 = phi_563_;
                    let _e440 = phi_564_;
                    phi_565_ = _e438;
                    phi_566_ = _e440;
                } else {
                    phi_565_ = f32();
                    phi_566_ = true;
                }
                let _e442 = phi_565_;
                let _e444 = phi_566_;
                if _e444 {
                    phi_570_ = _e394;
                } else {
                    phi_570_ = _e442;
                }
                let _e446 = phi_570_;
                let _e447 = (_e393 - _e420);
                let _e448 = (_e394 - _e446);
                let _e457 = select(0i, select(select(i32(_e420), i32(-2147483648), (_e420 < bitcast<f32>(3472883712u))), 2147483647i, (_e420 > bitcast<f32>(1325400063u))), (_e420 == _e420));
                let _e466 = select(0i, select(select(i32(_e446), i32(-2147483648), (_e446 < bitcast<f32>(3472883712u))), 2147483647i, (_e446 > bitcast<f32>(1325400063u))), (_e446 == _e446));
                let _e477 = p.member.test;
                let _e478 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e477);
                let _e480 = p.member.map_size;
                local = _e478;
                let _e482 = ((0u * _e480) * _e480);
                let _e484 = (bitcast<i32>(_e480) - 1i);
                if (_e457 > 0i) {
                    phi_618_ = _e457;
                } else {
                    phi_618_ = 0i;
                }
                let _e487 = phi_618_;
                if (_e466 > 0i) {
                    phi_623_ = _e466;
                } else {
                    phi_623_ = 0i;
                }
                let _e490 = phi_623_;
                if (_e487 < _e484) {
                    phi_628_ = _e487;
                } else {
                    phi_628_ = _e484;
                }
                let _e493 = phi_628_;
                if (_e490 < _e484) {
                    phi_633_ = _e490;
                } else {
                    phi_633_ = _e484;
                }
                let _e496 = phi_633_;
                let _e497 = bitcast<u32>(_e493);
                let _e499 = (_e457 + 1i);
                let _e500 = (_e466 + 1i);
                if (_e499 > 0i) {
                    phi_642_ = _e499;
                } else {
                    phi_642_ = 0i;
                }
                let _e503 = phi_642_;
                if (_e500 > 0i) {
                    phi_647_ = _e500;
                } else {
                    phi_647_ = 0i;
                }
                let _e506 = phi_647_;
                if (_e503 < _e484) {
                    phi_652_ = _e503;
                } else {
                    phi_652_ = _e484;
                }
                let _e509 = phi_652_;
                if (_e506 < _e484) {
                    phi_657_ = _e506;
                } else {
                    phi_657_ = _e484;
                }
                let _e512 = phi_657_;
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
                let _e542 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e528, _e532, _e536, _e540), vec4<f32>(((1f - _e447) * (1f - _e448)), (_e447 * (1f - _e448)), ((1f - _e447) * _e448), (_e447 * _e448)), _e387);
                phi_702_ = evaluate_Verdict(_e542, false);
                phi_703_ = evaluate_Verdict();
                phi_704_ = false;
            } else {
                phi_702_ = evaluate_Verdict();
                phi_703_ = evaluate_Verdict(1f, false);
                phi_704_ = true;
            }
            let _e546 = phi_702_;
            let _e548 = phi_703_;
            let _e550 = phi_704_;
            phi_705_ = _e548;
            phi_706_ = _e546;
            phi_707_ = _e550;
        }
        let _e552 = phi_705_;
        let _e554 = phi_706_;
        let _e556 = phi_707_;
        if _e556 {
            phi_711_ = _e552;
        } else {
            phi_711_ = _e554;
        }
        let _e558 = phi_711_;
        if (_e50.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e50.first_primitive)] = _e558.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_vsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
