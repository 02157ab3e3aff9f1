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
    var phi_134_: lt_bvh_traverse_Tree;
    var phi_135_: bool;
    var phi_136_: lt_bvh_traverse_Tree;
    var phi_137_: bool;
    var phi_142_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_134_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_135_ = false;
        } else {
            phi_134_ = lt_bvh_traverse_Tree();
            phi_135_ = true;
        }
        let _e47 = phi_134_;
        let _e49 = phi_135_;
        phi_136_ = _e47;
        phi_137_ = _e49;
    } else {
        phi_136_ = lt_bvh_traverse_Tree();
        phi_137_ = true;
    }
    let _e51 = phi_136_;
    let _e53 = phi_137_;
    if _e53 {
        phi_142_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_142_ = _e51;
    }
    let _e58 = phi_142_;
    return lt_bvh_traverse_Tree(_e58.root, _e58.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_786_: f32;
    var phi_787_: f32;
    var phi_788_: f32;
    var phi_806_: bool;
    var phi_810_: f32;
    var phi_822_: bool;
    var phi_829_: f32;
    var phi_844_: f32;
    var phi_845_: f32;
    var phi_846_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_788_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_787_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_786_ = 1f;
            } else {
                phi_786_ = param_6;
            }
            let _e43 = phi_786_;
            phi_787_ = _e43;
        }
        let _e45 = phi_787_;
        phi_788_ = _e45;
    }
    let _e47 = phi_788_;
    let _e50 = (*param_4);
    let _e54 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e50) & 2147483647u) > 2139095040u) {
        phi_806_ = true;
    } else {
        let _e58 = (_e50 > _e54);
        if _e58 {
        }
        phi_806_ = _e58;
    }
    let _e60 = phi_806_;
    if _e60 {
        phi_810_ = _e50;
    } else {
        phi_810_ = _e54;
    }
    let _e62 = phi_810_;
    let _e63 = (_e47 - param_5.x);
    if (_e63 <= 0f) {
        let _e67 = ((bitcast<u32>(_e62) & 2147483647u) > 2139095040u);
        if _e67 {
        }
        phi_822_ = _e67;
    } else {
        phi_822_ = true;
    }
    let _e69 = phi_822_;
    if _e69 {
        phi_829_ = (_e62 / (_e62 + (_e63 * _e63)));
    } else {
        phi_829_ = 1f;
    }
    let _e74 = phi_829_;
    if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
        phi_846_ = _e74;
    } else {
        if (_e74 < 0f) {
            phi_845_ = 0f;
        } else {
            if (_e74 > 1f) {
                phi_844_ = 1f;
            } else {
                phi_844_ = _e74;
            }
            let _e81 = phi_844_;
            phi_845_ = _e81;
        }
        let _e83 = phi_845_;
        phi_846_ = _e83;
    }
    let _e85 = phi_846_;
    return _e85;
}

fn function_() {
    var local: f32;
    var phi_204_: bool;
    var phi_205_: bool;
    var phi_206_: bool;
    var phi_207_: bool;
    var phi_211_: bool;
    var phi_281_: bool;
    var phi_282_: bool;
    var phi_293_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_294_: bool;
    var phi_295_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_296_: bool;
    var phi_303_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_307_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_381_: bool;
    var phi_390_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_401_: bool;
    var phi_402_: bool;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_409_: bool;
    var phi_499_: f32;
    var phi_502_: f32;
    var phi_531_: f32;
    var phi_536_: f32;
    var phi_537_: bool;
    var phi_538_: f32;
    var phi_539_: bool;
    var phi_543_: f32;
    var phi_563_: f32;
    var phi_568_: f32;
    var phi_569_: bool;
    var phi_570_: f32;
    var phi_571_: bool;
    var phi_575_: f32;
    var phi_623_: i32;
    var phi_628_: i32;
    var phi_633_: i32;
    var phi_638_: i32;
    var phi_647_: i32;
    var phi_652_: i32;
    var phi_657_: i32;
    var phi_662_: i32;
    var phi_751_: evaluate_Verdict;
    var phi_752_: evaluate_Verdict;
    var phi_753_: bool;
    var phi_754_: evaluate_Verdict;
    var phi_755_: evaluate_Verdict;
    var phi_756_: bool;
    var phi_760_: evaluate_Verdict;

    let _e35 = id_1;
    let _e42 = arrayLength((&map.member));
    let _e48 = p.member.size[0u];
    let _e50 = p.member.size[1u];
    let _e51 = lt_shaders_entry_pixel_index(_e35, _e48, _e50);
    if (bitcast<i32>(_e51.root) != 0i) {
        let _e57 = p.member.projection;
        if (_e51.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e61 = lt_math_OneLevel(_e57);
        let _e65 = samples.member[(0u + _e51.first_primitive)].normal[0u];
        let _e67 = global[0u];
        if (_e65 == _e67) {
            let _e70 = samples.member[(0u + _e51.first_primitive)].normal[1u];
            let _e72 = global[1u];
            if (_e70 == _e72) {
                let _e75 = samples.member[(0u + _e51.first_primitive)].normal[2u];
                let _e77 = global[2u];
                phi_204_ = (_e75 == _e77);
                phi_205_ = false;
            } else {
                phi_204_ = bool();
                phi_205_ = true;
            }
            let _e80 = phi_204_;
            let _e82 = phi_205_;
            phi_206_ = _e80;
            phi_207_ = _e82;
        } else {
            phi_206_ = bool();
            phi_207_ = true;
        }
        let _e84 = phi_206_;
        let _e86 = phi_207_;
        if _e86 {
            phi_211_ = false;
        } else {
            phi_211_ = _e84;
        }
        let _e88 = phi_211_;
        if !(_e88) {
            let _e91 = samples.member[(0u + _e51.first_primitive)].position;
            let _e93 = p.member.light.place;
            let _e99 = p.member.light.place[3u];
            let _e106 = (_e93.x - (_e91.x * _e99));
            let _e107 = (_e93.y - (_e91.y * _e99));
            let _e108 = (_e93.z - (_e91.z * _e99));
            let _e110 = samples.member[(0u + _e51.first_primitive)].normal;
            if ((((_e110.x * _e106) + (_e110.y * _e107)) + (_e110.z * _e108)) > 0f) {
                let _e124 = (((_e106 * _e106) + (_e107 * _e107)) + (_e108 * _e108));
                let _e126 = p.member.light.axis;
                let _e138 = p.member.light.place[3u];
                if (_e138 == 0f) {
                    phi_282_ = true;
                } else {
                    let _e141 = p.member.light.range_squared;
                    if (_e124 <= _e141) {
                        let _e144 = p.member.light.cos_outer;
                        phi_281_ = (-((((_e106 * _e126.x) + (_e107 * _e126.y)) + (_e108 * _e126.z))) >= (_e144 * sqrt(_e124)));
                    } else {
                        phi_281_ = false;
                    }
                    let _e149 = phi_281_;
                    phi_282_ = _e149;
                }
                let _e151 = phi_282_;
                if _e151 {
                    let _e153 = samples.member[(0u + _e51.first_primitive)].flags;
                    let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e161.unnamed.visibility, false), _e161.unnamed_1);
                    phi_293_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e167.unnamed, ((_e153 & 1u) == 0u));
                    phi_294_ = false;
                } else {
                    phi_293_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_294_ = true;
                }
                let _e172 = phi_293_;
                let _e174 = phi_294_;
                phi_295_ = _e172;
                phi_296_ = _e174;
            } else {
                phi_295_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_296_ = true;
            }
            let _e176 = phi_295_;
            let _e178 = phi_296_;
            if _e178 {
                let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e184.unnamed.visibility, false), _e184.unnamed_1);
                phi_303_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e190.unnamed, true);
            } else {
                phi_303_ = _e176;
            }
            let _e195 = phi_303_;
            phi_307_ = _e195;
        } else {
            let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e201.unnamed.visibility, false), _e201.unnamed_1);
            phi_307_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e207.unnamed, true);
        }
        let _e212 = phi_307_;
        if _e212.unnamed_1 {
            phi_754_ = evaluate_Verdict(_e212.unnamed.visibility, _e212.unnamed.is_doubted);
            phi_755_ = evaluate_Verdict();
            phi_756_ = true;
        } else {
            let _e220 = samples.member[(0u + _e51.first_primitive)].position;
            let _e238 = ((((_e61.projection.row_w.x * _e220.x) + (_e61.projection.row_w.y * _e220.y)) + (_e61.projection.row_w.z * _e220.z)) + (_e61.projection.row_w.w * 1f));
            let _e252 = (((((_e61.projection.row_x.x * _e220.x) + (_e61.projection.row_x.y * _e220.y)) + (_e61.projection.row_x.z * _e220.z)) + (_e61.projection.row_x.w * 1f)) / _e238);
            let _e266 = (((((_e61.projection.row_y.x * _e220.x) + (_e61.projection.row_y.y * _e220.y)) + (_e61.projection.row_y.z * _e220.z)) + (_e61.projection.row_y.w * 1f)) / _e238);
            let _e279 = ((((_e61.projection.row_z.x * _e220.x) + (_e61.projection.row_z.y * _e220.y)) + (_e61.projection.row_z.z * _e220.z)) + (_e61.projection.row_z.w * 1f));
            if (_e238 > 0f) {
                if (_e252 >= 0f) {
                    phi_381_ = (_e252 <= 1f);
                } else {
                    phi_381_ = false;
                }
                let _e284 = phi_381_;
                if _e284 {
                    if (_e266 >= 0f) {
                        phi_390_ = (_e266 <= 1f);
                    } else {
                        phi_390_ = false;
                    }
                    let _e288 = phi_390_;
                    if _e288 {
                        if (_e279 >= 0f) {
                            phi_399_ = (_e279 <= 1f);
                        } else {
                            phi_399_ = false;
                        }
                        let _e292 = phi_399_;
                        phi_400_ = _e292;
                        phi_401_ = false;
                    } else {
                        phi_400_ = bool();
                        phi_401_ = true;
                    }
                    let _e294 = phi_400_;
                    let _e296 = phi_401_;
                    phi_402_ = _e294;
                    phi_403_ = _e296;
                } else {
                    phi_402_ = bool();
                    phi_403_ = true;
                }
                let _e298 = phi_402_;
                let _e300 = phi_403_;
                phi_404_ = _e298;
                phi_405_ = _e300;
            } else {
                phi_404_ = bool();
                phi_405_ = true;
            }
            let _e302 = phi_404_;
            let _e304 = phi_405_;
            if _e304 {
                phi_409_ = false;
            } else {
                phi_409_ = _e302;
            }
            let _e306 = phi_409_;
            if _e306 {
                if (0f > 0f) {
                    let _e309 = samples.member[(0u + _e51.first_primitive)].normal;
                    let _e311 = p.member.map_size;
                    let _e381 = ((abs(((((_e57.row_x.x * _e309.x) + (_e57.row_x.y * _e309.y)) + (_e57.row_x.z * _e309.z)) / (((_e57.row_x.x * _e57.row_x.x) + (_e57.row_x.y * _e57.row_x.y)) + (_e57.row_x.z * _e57.row_x.z)))) + abs(((((_e57.row_y.x * _e309.x) + (_e57.row_y.y * _e309.y)) + (_e57.row_y.z * _e309.z)) / (((_e57.row_y.x * _e57.row_y.x) + (_e57.row_y.y * _e57.row_y.y)) + (_e57.row_y.z * _e57.row_y.z))))) / (abs(((((_e57.row_z.x * _e309.x) + (_e57.row_z.y * _e309.y)) + (_e57.row_z.z * _e309.z)) / (((_e57.row_z.x * _e57.row_z.x) + (_e57.row_z.y * _e57.row_z.y)) + (_e57.row_z.z * _e57.row_z.z)))) * f32(_e311)));
                    if (_e381 < 0.002f) {
                        phi_499_ = _e381;
                    } else {
                        phi_499_ = 0.002f;
                    }
                    let _e384 = phi_499_;
                    phi_502_ = (_e279 - (0f * _e384));
                } else {
                    phi_502_ = _e279;
                }
                let _e388 = phi_502_;
                let _e390 = p.member.map_size;
                let _e391 = f32(_e390);
                let _e394 = ((_e252 * _e391) - 0.5f);
                let _e395 = ((_e266 * _e391) - 0.5f);
                if (_e394 > -8388608f) {
                    let _e407 = f32(select(0i, select(select(i32(_e394), i32(-2147483648), (_e394 < bitcast<f32>(3472883712u))), 2147483647i, (_e394 > bitcast<f32>(1325400063u))), (_e394 == _e394)));
                    if (_e407 > _e394) {
                        phi_531_ = 1f;
                    } else {
                        phi_531_ = 0f;
                    }
                    let _e410 = phi_531_;
                    if (_e394 < 8388608f) {
                        phi_536_ = (_e407 - _e410);
                        phi_537_ = false;
                    } else {
                        phi_536_ = f32();
                        phi_537_ = true;
                    }
                    let _e413 = phi_536_;
                    let _e415 = phi_537_;
                    phi_538_ = _e413;
                    phi_539_ = _e415;
                } else {
                    phi_538_ = f32();
                    phi_539_ = true;
                }
                let _e417 = phi_538_;
                let _e419 = phi_539_;
                if _e419 {
                    phi_543_ = _e394;
                } else {
                    phi_543_ = _e417;
                }
                let _e421 = phi_543_;
                if (_e395 > -8388608f) {
                    let _e433 = f32(select(0i, select(select(i32(_e395), i32(-2147483648), (_e395 < bitcast<f32>(3472883712u))), 2147483647i, (_e395 > bitcast<f32>(1325400063u))), (_e395 == _e395)));
                    if (_e433 > _e395) {
                        phi_563_ = 1f;
                    } else {
                        phi_563_ = 0f;
                    }
                    let _e436 = phi_563_;
                    if (_e395 < 8388608f) {
                        phi_568_ = (_e433 - _e436);
                        phi_569_ = false;
                    } else {
                        phi_568_ = f32();
                        phi_569_ = true;
                    }
                    let _e439 = phi_568_;
                    let _e441 = phi_569_;
                    phi_570_ = _e439;
                    phi_571_ = _e441;
                } else {
                    phi_570_ = f32();
                    phi_571_ = true;
                }
                let _e443 = phi_570_;
                let _e445 = phi_571_;
                if _e445 {
                    phi_575_ = _e395;
                } else {
                    phi_575_ = _e443;
                }
                let _e447 = phi_575_;
                let _e448 = (_e394 - _e421);
                let _e449 = (_e395 - _e447);
                let _e458 = select(0i, select(select(i32(_e421), i32(-2147483648), (_e421 < bitcast<f32>(3472883712u))), 2147483647i, (_e421 > bitcast<f32>(1325400063u))), (_e421 == _e421));
                let _e467 = select(0i, select(select(i32(_e447), i32(-2147483648), (_e447 < bitcast<f32>(3472883712u))), 2147483647i, (_e447 > bitcast<f32>(1325400063u))), (_e447 == _e447));
                let _e470 = ((1f - _e448) * (1f - _e449));
                let _e472 = (_e448 * (1f - _e449));
                let _e474 = ((1f - _e448) * _e449);
                let _e475 = (_e448 * _e449);
                let _e477 = p.member.test;
                let _e478 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e477);
                let _e480 = p.member.map_size;
                local = _e478;
                let _e482 = ((0u * _e480) * _e480);
                let _e484 = (bitcast<i32>(_e480) - 1i);
                if (_e458 > 0i) {
                    phi_623_ = _e458;
                } else {
                    phi_623_ = 0i;
                }
                let _e487 = phi_623_;
                if (_e467 > 0i) {
                    phi_628_ = _e467;
                } else {
                    phi_628_ = 0i;
                }
                let _e490 = phi_628_;
                if (_e487 < _e484) {
                    phi_633_ = _e487;
                } else {
                    phi_633_ = _e484;
                }
                let _e493 = phi_633_;
                if (_e490 < _e484) {
                    phi_638_ = _e490;
                } else {
                    phi_638_ = _e484;
                }
                let _e496 = phi_638_;
                let _e497 = bitcast<u32>(_e493);
                let _e499 = (_e458 + 1i);
                let _e500 = (_e467 + 1i);
                if (_e499 > 0i) {
                    phi_647_ = _e499;
                } else {
                    phi_647_ = 0i;
                }
                let _e503 = phi_647_;
                if (_e500 > 0i) {
                    phi_652_ = _e500;
                } else {
                    phi_652_ = 0i;
                }
                let _e506 = phi_652_;
                if (_e503 < _e484) {
                    phi_657_ = _e503;
                } else {
                    phi_657_ = _e484;
                }
                let _e509 = phi_657_;
                if (_e506 < _e484) {
                    phi_662_ = _e506;
                } else {
                    phi_662_ = _e484;
                }
                let _e512 = phi_662_;
                let _e513 = bitcast<u32>(_e509);
                let _e515 = (bitcast<u32>(_e496) * _e480);
                let _e516 = (bitcast<u32>(_e512) * _e480);
                let _e521 = ((_e515 + _e497) + _e482);
                let _e522 = ((_e515 + _e513) + _e482);
                let _e523 = ((_e516 + _e497) + _e482);
                let _e524 = ((_e516 + _e513) + _e482);
                if (_e521 < _e42) {
                } else {
                    return;
                }
                let _e528 = map.member[(0u + _e521)];
                if (_e522 < _e42) {
                } else {
                    return;
                }
                let _e540 = map.member[(0u + _e522)];
                if (_e523 < _e42) {
                } else {
                    return;
                }
                let _e556 = map.member[(0u + _e523)];
                if (_e524 < _e42) {
                } else {
                    return;
                }
                let _e572 = map.member[(0u + _e524)];
                let _e586 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e528.x * _e470) + (_e540.x * _e472)) + (_e556.x * _e474)) + (_e572.x * _e475)), ((((_e528.y * _e470) + (_e540.y * _e472)) + (_e556.y * _e474)) + (_e572.y * _e475)), ((((_e528.z * _e470) + (_e540.z * _e472)) + (_e556.z * _e474)) + (_e572.z * _e475)), ((((_e528.w * _e470) + (_e540.w * _e472)) + (_e556.w * _e474)) + (_e572.w * _e475))), _e388);
                phi_751_ = evaluate_Verdict(_e586, false);
                phi_752_ = evaluate_Verdict();
                phi_753_ = false;
            } else {
                phi_751_ = evaluate_Verdict();
                phi_752_ = evaluate_Verdict(1f, false);
                phi_753_ = true;
            }
            let _e590 = phi_751_;
            let _e592 = phi_752_;
            let _e594 = phi_753_;
            phi_754_ = _e592;
            phi_755_ = _e590;
            phi_756_ = _e594;
        }
        let _e596 = phi_754_;
        let _e598 = phi_755_;
        let _e600 = phi_756_;
        if _e600 {
            phi_760_ = _e596;
        } else {
            phi_760_ = _e598;
        }
        let _e602 = phi_760_;
        if (_e51.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e51.first_primitive)] = _e602.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_vsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
