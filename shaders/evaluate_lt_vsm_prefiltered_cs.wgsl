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

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_139_: lt_bvh_traverse_Tree;
    var phi_140_: bool;
    var phi_141_: lt_bvh_traverse_Tree;
    var phi_142_: bool;
    var phi_147_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_139_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_140_ = false;
        } else {
            phi_139_ = lt_bvh_traverse_Tree();
            phi_140_ = true;
        }
        let _e50 = phi_139_;
        let _e52 = phi_140_;
        phi_141_ = _e50;
        phi_142_ = _e52;
    } else {
        phi_141_ = lt_bvh_traverse_Tree();
        phi_142_ = true;
    }
    let _e54 = phi_141_;
    let _e56 = phi_142_;
    if _e56 {
        phi_147_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_147_ = _e54;
    }
    let _e61 = phi_147_;
    return lt_bvh_traverse_Tree(_e61.root, _e61.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_172_: f32;
    var phi_173_: f32;
    var phi_174_: f32;
    var phi_192_: bool;
    var phi_196_: f32;
    var phi_208_: bool;
    var phi_215_: f32;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_232_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_174_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_173_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_172_ = 1f;
            } else {
                phi_172_ = param_6;
            }
            let _e46 = phi_172_;
            phi_173_ = _e46;
        }
        let _e48 = phi_173_;
        phi_174_ = _e48;
    }
    let _e50 = phi_174_;
    let _e53 = (*param_4);
    let _e57 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e53) & 2147483647u) > 2139095040u) {
        phi_192_ = true;
    } else {
        let _e61 = (_e53 > _e57);
        if _e61 {
        }
        phi_192_ = _e61;
    }
    let _e63 = phi_192_;
    if _e63 {
        phi_196_ = _e53;
    } else {
        phi_196_ = _e57;
    }
    let _e65 = phi_196_;
    let _e66 = (_e50 - param_5.x);
    if (_e66 <= 0f) {
        let _e70 = ((bitcast<u32>(_e65) & 2147483647u) > 2139095040u);
        if _e70 {
        }
        phi_208_ = _e70;
    } else {
        phi_208_ = true;
    }
    let _e72 = phi_208_;
    if _e72 {
        phi_215_ = (_e65 / (_e65 + (_e66 * _e66)));
    } else {
        phi_215_ = 1f;
    }
    let _e77 = phi_215_;
    if ((bitcast<u32>(_e77) & 2147483647u) > 2139095040u) {
        phi_232_ = _e77;
    } else {
        if (_e77 < 0f) {
            phi_231_ = 0f;
        } else {
            if (_e77 > 1f) {
                phi_230_ = 1f;
            } else {
                phi_230_ = _e77;
            }
            let _e84 = phi_230_;
            phi_231_ = _e84;
        }
        let _e86 = phi_231_;
        phi_232_ = _e86;
    }
    let _e88 = phi_232_;
    return _e88;
}

fn function_() {
    var local: f32;
    var phi_288_: bool;
    var phi_289_: bool;
    var phi_290_: bool;
    var phi_291_: bool;
    var phi_295_: bool;
    var phi_365_: bool;
    var phi_366_: bool;
    var phi_377_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_378_: bool;
    var phi_379_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_380_: bool;
    var phi_387_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_391_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_465_: bool;
    var phi_474_: bool;
    var phi_483_: bool;
    var phi_484_: bool;
    var phi_485_: bool;
    var phi_486_: bool;
    var phi_487_: bool;
    var phi_488_: bool;
    var phi_489_: bool;
    var phi_493_: bool;
    var phi_583_: f32;
    var phi_586_: f32;
    var phi_615_: f32;
    var phi_620_: f32;
    var phi_621_: bool;
    var phi_622_: f32;
    var phi_623_: bool;
    var phi_627_: f32;
    var phi_647_: f32;
    var phi_652_: f32;
    var phi_653_: bool;
    var phi_654_: f32;
    var phi_655_: bool;
    var phi_659_: f32;
    var phi_707_: i32;
    var phi_712_: i32;
    var phi_717_: i32;
    var phi_722_: i32;
    var phi_731_: i32;
    var phi_736_: i32;
    var phi_741_: i32;
    var phi_746_: i32;
    var phi_843_: bool;
    var phi_851_: bool;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_868_: f32;
    var phi_874_: f32;
    var phi_876_: evaluate_Verdict;
    var phi_886_: u32;
    var phi_895_: f32;
    var phi_897_: evaluate_Verdict;
    var phi_898_: bool;
    var phi_899_: evaluate_Verdict;
    var phi_900_: bool;
    var phi_905_: evaluate_Verdict;
    var phi_910_: evaluate_Verdict;
    var phi_911_: evaluate_Verdict;

    let _e38 = id_1;
    let _e45 = arrayLength((&map.member));
    let _e51 = p.member.size[0u];
    let _e53 = p.member.size[1u];
    let _e54 = lt_shaders_entry_pixel_index(_e38, _e51, _e53);
    if (bitcast<i32>(_e54.root) != 0i) {
        let _e60 = p.member.projection;
        if (_e54.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e64 = lt_math_OneLevel(_e60);
        let _e68 = samples.member[(0u + _e54.first_primitive)].normal[0u];
        let _e70 = global[0u];
        if (_e68 == _e70) {
            let _e73 = samples.member[(0u + _e54.first_primitive)].normal[1u];
            let _e75 = global[1u];
            if (_e73 == _e75) {
                let _e78 = samples.member[(0u + _e54.first_primitive)].normal[2u];
                let _e80 = global[2u];
                phi_288_ = (_e78 == _e80);
                phi_289_ = false;
            } else {
                phi_288_ = bool();
                phi_289_ = true;
            }
            let _e83 = phi_288_;
            let _e85 = phi_289_;
            phi_290_ = _e83;
            phi_291_ = _e85;
        } else {
            phi_290_ = bool();
            phi_291_ = true;
        }
        let _e87 = phi_290_;
        let _e89 = phi_291_;
        if _e89 {
            phi_295_ = false;
        } else {
            phi_295_ = _e87;
        }
        let _e91 = phi_295_;
        if !(_e91) {
            let _e94 = samples.member[(0u + _e54.first_primitive)].position;
            let _e96 = p.member.light.place;
            let _e102 = p.member.light.place[3u];
            let _e109 = (_e96.x - (_e94.x * _e102));
            let _e110 = (_e96.y - (_e94.y * _e102));
            let _e111 = (_e96.z - (_e94.z * _e102));
            let _e113 = samples.member[(0u + _e54.first_primitive)].normal;
            if ((((_e113.x * _e109) + (_e113.y * _e110)) + (_e113.z * _e111)) > 0f) {
                let _e127 = (((_e109 * _e109) + (_e110 * _e110)) + (_e111 * _e111));
                let _e129 = p.member.light.axis;
                let _e141 = p.member.light.place[3u];
                if (_e141 == 0f) {
                    phi_366_ = true;
                } else {
                    let _e144 = p.member.light.range_squared;
                    if (_e127 <= _e144) {
                        let _e147 = p.member.light.cos_outer;
                        phi_365_ = (-((((_e109 * _e129.x) + (_e110 * _e129.y)) + (_e111 * _e129.z))) >= (_e147 * sqrt(_e127)));
                    } else {
                        phi_365_ = false;
                    }
                    let _e152 = phi_365_;
                    phi_366_ = _e152;
                }
                let _e154 = phi_366_;
                if _e154 {
                    let _e156 = samples.member[(0u + _e54.first_primitive)].flags;
                    let _e164 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e164.unnamed.visibility, false), _e164.unnamed_1);
                    phi_377_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e170.unnamed, ((_e156 & 1u) == 0u));
                    phi_378_ = false;
                } else {
                    phi_377_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_378_ = true;
                }
                let _e175 = phi_377_;
                let _e177 = phi_378_;
                phi_379_ = _e175;
                phi_380_ = _e177;
            } else {
                phi_379_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_380_ = true;
            }
            let _e179 = phi_379_;
            let _e181 = phi_380_;
            if _e181 {
                let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e187.unnamed.visibility, false), _e187.unnamed_1);
                phi_387_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e193.unnamed, true);
            } else {
                phi_387_ = _e179;
            }
            let _e198 = phi_387_;
            phi_391_ = _e198;
        } else {
            let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
            phi_391_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
        }
        let _e215 = phi_391_;
        if _e215.unnamed_1 {
            phi_911_ = evaluate_Verdict(_e215.unnamed.visibility, _e215.unnamed.is_doubted);
        } else {
            let _e223 = samples.member[(0u + _e54.first_primitive)].position;
            let _e241 = ((((_e64.projection.row_w.x * _e223.x) + (_e64.projection.row_w.y * _e223.y)) + (_e64.projection.row_w.z * _e223.z)) + (_e64.projection.row_w.w * 1f));
            let _e255 = (((((_e64.projection.row_x.x * _e223.x) + (_e64.projection.row_x.y * _e223.y)) + (_e64.projection.row_x.z * _e223.z)) + (_e64.projection.row_x.w * 1f)) / _e241);
            let _e269 = (((((_e64.projection.row_y.x * _e223.x) + (_e64.projection.row_y.y * _e223.y)) + (_e64.projection.row_y.z * _e223.z)) + (_e64.projection.row_y.w * 1f)) / _e241);
            let _e282 = ((((_e64.projection.row_z.x * _e223.x) + (_e64.projection.row_z.y * _e223.y)) + (_e64.projection.row_z.z * _e223.z)) + (_e64.projection.row_z.w * 1f));
            if (_e241 > 0f) {
                if (_e255 >= 0f) {
                    phi_465_ = (_e255 <= 1f);
                } else {
                    phi_465_ = false;
                }
                let _e287 = phi_465_;
                if _e287 {
                    if (_e269 >= 0f) {
                        phi_474_ = (_e269 <= 1f);
                    } else {
                        phi_474_ = false;
                    }
                    let _e291 = phi_474_;
                    if _e291 {
                        if (_e282 >= 0f) {
                            phi_483_ = (_e282 <= 1f);
                        } else {
                            phi_483_ = false;
                        }
                        let _e295 = phi_483_;
                        phi_484_ = _e295;
                        phi_485_ = false;
                    } else {
                        phi_484_ = bool();
                        phi_485_ = true;
                    }
                    let _e297 = phi_484_;
                    let _e299 = phi_485_;
                    phi_486_ = _e297;
                    phi_487_ = _e299;
                } else {
                    phi_486_ = bool();
                    phi_487_ = true;
                }
                let _e301 = phi_486_;
                let _e303 = phi_487_;
                phi_488_ = _e301;
                phi_489_ = _e303;
            } else {
                phi_488_ = bool();
                phi_489_ = true;
            }
            let _e305 = phi_488_;
            let _e307 = phi_489_;
            if _e307 {
                phi_493_ = false;
            } else {
                phi_493_ = _e305;
            }
            let _e309 = phi_493_;
            if _e309 {
                if (0f > 0f) {
                    let _e312 = samples.member[(0u + _e54.first_primitive)].normal;
                    let _e314 = p.member.map_size;
                    let _e384 = ((abs(((((_e60.row_x.x * _e312.x) + (_e60.row_x.y * _e312.y)) + (_e60.row_x.z * _e312.z)) / (((_e60.row_x.x * _e60.row_x.x) + (_e60.row_x.y * _e60.row_x.y)) + (_e60.row_x.z * _e60.row_x.z)))) + abs(((((_e60.row_y.x * _e312.x) + (_e60.row_y.y * _e312.y)) + (_e60.row_y.z * _e312.z)) / (((_e60.row_y.x * _e60.row_y.x) + (_e60.row_y.y * _e60.row_y.y)) + (_e60.row_y.z * _e60.row_y.z))))) / (abs(((((_e60.row_z.x * _e312.x) + (_e60.row_z.y * _e312.y)) + (_e60.row_z.z * _e312.z)) / (((_e60.row_z.x * _e60.row_z.x) + (_e60.row_z.y * _e60.row_z.y)) + (_e60.row_z.z * _e60.row_z.z)))) * f32(_e314)));
                    if (_e384 < 0.002f) {
                        phi_583_ = _e384;
                    } else {
                        phi_583_ = 0.002f;
                    }
                    let _e387 = phi_583_;
                    phi_586_ = (_e282 - (0f * _e387));
                } else {
                    phi_586_ = _e282;
                }
                let _e391 = phi_586_;
                let _e393 = p.member.map_size;
                let _e394 = f32(_e393);
                let _e397 = ((_e255 * _e394) - 0.5f);
                let _e398 = ((_e269 * _e394) - 0.5f);
                if (_e397 > -8388608f) {
                    let _e410 = f32(select(0i, select(select(i32(_e397), i32(-2147483648), (_e397 < bitcast<f32>(3472883712u))), 2147483647i, (_e397 > bitcast<f32>(1325400063u))), (_e397 == _e397)));
                    if (_e410 > _e397) {
                        phi_615_ = 1f;
                    } else {
                        phi_615_ = 0f;
                    }
                    let _e413 = phi_615_;
                    if (_e397 < 8388608f) {
                        phi_620_ = (_e410 - _e413);
                        phi_621_ = false;
                    } else {
                        phi_620_ = f32();
                        phi_621_ = true;
                    }
                    let _e416 = phi_620_;
                    let _e418 = phi_621_;
                    phi_622_ = _e416;
                    phi_623_ = _e418;
                } else {
                    phi_622_ = f32();
                    phi_623_ = true;
                }
                let _e420 = phi_622_;
                let _e422 = phi_623_;
                if _e422 {
                    phi_627_ = _e397;
                } else {
                    phi_627_ = _e420;
                }
                let _e424 = phi_627_;
                if (_e398 > -8388608f) {
                    let _e436 = f32(select(0i, select(select(i32(_e398), i32(-2147483648), (_e398 < bitcast<f32>(3472883712u))), 2147483647i, (_e398 > bitcast<f32>(1325400063u))), (_e398 == _e398)));
                    if (_e436 > _e398) {
                        phi_647_ = 1f;
                    } else {
                        phi_647_ = 0f;
                    }
                    let _e439 = phi_647_;
                    if (_e398 < 8388608f) {
                        phi_652_ = (_e436 - _e439);
                        phi_653_ = false;
                    } else {
                        phi_652_ = f32();
                        phi_653_ = true;
                    }
                    let _e442 = phi_652_;
                    let _e444 = phi_653_;
                    phi_654_ = _e442;
                    phi_655_ = _e444;
                } else {
                    phi_654_ = f32();
                    phi_655_ = true;
                }
                let _e446 = phi_654_;
                let _e448 = phi_655_;
                if _e448 {
                    phi_659_ = _e398;
                } else {
                    phi_659_ = _e446;
                }
                let _e450 = phi_659_;
                let _e451 = (_e397 - _e424);
                let _e452 = (_e398 - _e450);
                let _e461 = select(0i, select(select(i32(_e424), i32(-2147483648), (_e424 < bitcast<f32>(3472883712u))), 2147483647i, (_e424 > bitcast<f32>(1325400063u))), (_e424 == _e424));
                let _e470 = select(0i, select(select(i32(_e450), i32(-2147483648), (_e450 < bitcast<f32>(3472883712u))), 2147483647i, (_e450 > bitcast<f32>(1325400063u))), (_e450 == _e450));
                let _e473 = ((1f - _e451) * (1f - _e452));
                let _e475 = (_e451 * (1f - _e452));
                let _e477 = ((1f - _e451) * _e452);
                let _e478 = (_e451 * _e452);
                let _e480 = p.member.test;
                let _e481 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e480);
                let _e483 = p.member.map_size;
                local = _e481;
                let _e485 = ((0u * _e483) * _e483);
                let _e487 = (bitcast<i32>(_e483) - 1i);
                if (_e461 > 0i) {
                    phi_707_ = _e461;
                } else {
                    phi_707_ = 0i;
                }
                let _e490 = phi_707_;
                if (_e470 > 0i) {
                    phi_712_ = _e470;
                } else {
                    phi_712_ = 0i;
                }
                let _e493 = phi_712_;
                if (_e490 < _e487) {
                    phi_717_ = _e490;
                } else {
                    phi_717_ = _e487;
                }
                let _e496 = phi_717_;
                if (_e493 < _e487) {
                    phi_722_ = _e493;
                } else {
                    phi_722_ = _e487;
                }
                let _e499 = phi_722_;
                let _e500 = bitcast<u32>(_e496);
                let _e502 = (_e461 + 1i);
                let _e503 = (_e470 + 1i);
                if (_e502 > 0i) {
                    phi_731_ = _e502;
                } else {
                    phi_731_ = 0i;
                }
                let _e506 = phi_731_;
                if (_e503 > 0i) {
                    phi_736_ = _e503;
                } else {
                    phi_736_ = 0i;
                }
                let _e509 = phi_736_;
                if (_e506 < _e487) {
                    phi_741_ = _e506;
                } else {
                    phi_741_ = _e487;
                }
                let _e512 = phi_741_;
                if (_e509 < _e487) {
                    phi_746_ = _e509;
                } else {
                    phi_746_ = _e487;
                }
                let _e515 = phi_746_;
                let _e516 = bitcast<u32>(_e512);
                let _e518 = (bitcast<u32>(_e499) * _e483);
                let _e519 = (bitcast<u32>(_e515) * _e483);
                let _e524 = ((_e518 + _e500) + _e485);
                let _e525 = ((_e518 + _e516) + _e485);
                let _e526 = ((_e519 + _e500) + _e485);
                let _e527 = ((_e519 + _e516) + _e485);
                if (_e524 < _e45) {
                } else {
                    return;
                }
                let _e531 = map.member[(0u + _e524)];
                if (_e525 < _e45) {
                } else {
                    return;
                }
                let _e543 = map.member[(0u + _e525)];
                if (_e526 < _e45) {
                } else {
                    return;
                }
                let _e559 = map.member[(0u + _e526)];
                if (_e527 < _e45) {
                } else {
                    return;
                }
                let _e575 = map.member[(0u + _e527)];
                let _e589 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e531.x * _e473) + (_e543.x * _e475)) + (_e559.x * _e477)) + (_e575.x * _e478)), ((((_e531.y * _e473) + (_e543.y * _e475)) + (_e559.y * _e477)) + (_e575.y * _e478)), ((((_e531.z * _e473) + (_e543.z * _e475)) + (_e559.z * _e477)) + (_e575.z * _e478)), ((((_e531.w * _e473) + (_e543.w * _e475)) + (_e559.w * _e477)) + (_e575.w * _e478))), _e391);
                let _e593 = p.member.epsilon;
                if (_e589 <= _e593) {
                    phi_843_ = true;
                } else {
                    phi_843_ = (_e589 >= (1f - _e593));
                }
                let _e598 = phi_843_;
                if ((bitcast<u32>(_e589) & 2147483647u) > 2139095040u) {
                    phi_851_ = true;
                } else {
                    phi_851_ = !(_e598);
                }
                let _e604 = phi_851_;
                if _e604 {
                    if (_e589 > 0f) {
                        if (_e589 < 1f) {
                            phi_863_ = false;
                        } else {
                            phi_863_ = true;
                        }
                        let _e608 = phi_863_;
                        phi_864_ = _e608;
                    } else {
                        phi_864_ = true;
                    }
                    let _e610 = phi_864_;
                    if _e610 {
                        phi_868_ = 0.5f;
                    } else {
                        phi_868_ = _e589;
                    }
                    let _e612 = phi_868_;
                    phi_876_ = evaluate_Verdict(_e612, true);
                } else {
                    if (_e589 > 0.5f) {
                        phi_874_ = 1f;
                    } else {
                        phi_874_ = 0f;
                    }
                    let _e616 = phi_874_;
                    phi_876_ = evaluate_Verdict(_e616, false);
                }
                let _e619 = phi_876_;
                let _e622 = (_e619.visibility < 0.5f);
                if _e619.is_doubted {
                    phi_899_ = evaluate_Verdict();
                    phi_900_ = true;
                } else {
                    if _e622 {
                        phi_886_ = 2u;
                    } else {
                        phi_886_ = 1u;
                    }
                    let _e624 = phi_886_;
                    if ((0u & _e624) != 0u) {
                        if _e622 {
                            phi_895_ = 0.000000059604645f;
                        } else {
                            phi_895_ = 0.99999994f;
                        }
                        let _e628 = phi_895_;
                        phi_897_ = evaluate_Verdict(_e628, true);
                        phi_898_ = false;
                    } else {
                        phi_897_ = evaluate_Verdict();
                        phi_898_ = true;
                    }
                    let _e631 = phi_897_;
                    let _e633 = phi_898_;
                    phi_899_ = _e631;
                    phi_900_ = _e633;
                }
                let _e635 = phi_899_;
                let _e637 = phi_900_;
                if _e637 {
                    phi_905_ = evaluate_Verdict(_e619.visibility, _e619.is_doubted);
                } else {
                    phi_905_ = _e635;
                }
                let _e640 = phi_905_;
                phi_910_ = evaluate_Verdict(_e640.visibility, _e640.is_doubted);
            } else {
                phi_910_ = evaluate_Verdict(0.5f, true);
            }
            let _e646 = phi_910_;
            phi_911_ = _e646;
        }
        let _e648 = phi_911_;
        if (_e54.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e54.first_primitive)] = _e648.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_vsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
