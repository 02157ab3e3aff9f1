struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_18 {
    member: array<abi_Sample>,
}

struct type_22 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_30 {
    member: array<vec4<f32>>,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_34 {
    member: abi_ShadowParams,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_18;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_34;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_22;
@group(0) @binding(2) 
var<storage> map: type_30;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_130_: lt_bvh_traverse_Tree;
    var phi_131_: bool;
    var phi_132_: lt_bvh_traverse_Tree;
    var phi_133_: bool;
    var phi_138_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_130_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_131_ = false;
        } else {
            phi_130_ = lt_bvh_traverse_Tree();
            phi_131_ = true;
        }
        let _e46 = phi_130_;
        let _e48 = phi_131_;
        phi_132_ = _e46;
        phi_133_ = _e48;
    } else {
        phi_132_ = lt_bvh_traverse_Tree();
        phi_133_ = true;
    }
    let _e50 = phi_132_;
    let _e52 = phi_133_;
    if _e52 {
        phi_138_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_138_ = _e50;
    }
    let _e57 = phi_138_;
    return lt_bvh_traverse_Tree(_e57.root, _e57.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_667_: f32;
    var phi_668_: f32;
    var phi_669_: f32;
    var phi_675_: bool;
    var phi_697_: f32;
    var phi_698_: f32;
    var phi_699_: f32;
    var phi_700_: f32;
    var phi_701_: bool;
    var phi_702_: f32;
    var phi_703_: bool;
    var phi_741_: vec2<f32>;
    var phi_775_: f32;
    var phi_776_: f32;
    var phi_777_: f32;
    var phi_806_: f32;
    var phi_807_: f32;
    var phi_808_: f32;
    var phi_812_: f32;
    var phi_813_: f32;
    var phi_814_: f32;
    var phi_815_: f32;

    let _e36 = (*param_4);
    let _e37 = (1f - _e36);
    let _e46 = (0.5f * _e36);
    let _e47 = ((param_5.x * _e37) + _e46);
    let _e48 = ((param_5.y * _e37) + _e46);
    let _e50 = ((param_5.w * _e37) + _e46);
    let _e52 = (_e48 - (_e47 * _e47));
    let _e54 = (((param_5.z * _e37) + _e46) - (_e47 * _e48));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_669_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_668_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_667_ = 1f;
            } else {
                phi_667_ = param_6;
            }
            let _e66 = phi_667_;
            phi_668_ = _e66;
        }
        let _e68 = phi_668_;
        phi_669_ = _e68;
    }
    let _e70 = phi_669_;
    if (_e47 == _e50) {
        phi_675_ = (_e47 > 0.5f);
    } else {
        phi_675_ = false;
    }
    let _e74 = phi_675_;
    if _e74 {
        if (_e70 > 0f) {
            if ((bitcast<u32>(_e47) & 2147483647u) > 2139095040u) {
                phi_699_ = _e47;
            } else {
                if (_e47 < 0f) {
                    phi_698_ = 0f;
                } else {
                    if (_e47 > 1f) {
                        phi_697_ = 1f;
                    } else {
                        phi_697_ = _e47;
                    }
                    let _e82 = phi_697_;
                    phi_698_ = _e82;
                }
                let _e84 = phi_698_;
                phi_699_ = _e84;
            }
            let _e86 = phi_699_;
            phi_700_ = _e86;
            phi_701_ = false;
        } else {
            phi_700_ = f32();
            phi_701_ = true;
        }
        let _e88 = phi_700_;
        let _e90 = phi_701_;
        phi_702_ = _e88;
        phi_703_ = _e90;
    } else {
        phi_702_ = f32();
        phi_703_ = true;
    }
    let _e92 = phi_702_;
    let _e94 = phi_703_;
    if _e94 {
        let _e95 = (_e54 / _e52);
        let _e96 = (_e70 - _e47);
        let _e102 = (((((_e70 * _e70) - _e48) - (_e95 * _e96)) * _e52) / (((_e50 - (_e48 * _e48)) * _e52) - (_e54 * _e54)));
        let _e105 = ((_e96 / _e52) - (_e95 * _e102));
        let _e111 = ((0.5f * _e105) / _e102);
        let _e114 = ((_e111 * _e111) - (((1f - (_e105 * _e47)) - (_e102 * _e48)) / _e102));
        if (_e114 >= 0f) {
            let _e116 = sqrt(_e114);
            phi_741_ = vec2<f32>((-(_e111) - _e116), (-(_e111) + _e116));
        } else {
            phi_741_ = vec2(bitcast<f32>((bitcast<u32>(_e114) | 2143289344u)));
        }
        let _e127 = phi_741_;
        if (_e70 <= _e127.x) {
            phi_814_ = 1f;
        } else {
            if (_e70 > _e127.y) {
                let _e140 = (((_e48 - (_e47 * (_e127.x + _e127.y))) + (_e127.x * _e127.y)) / ((_e70 - _e127.x) * (_e70 - _e127.y)));
                if ((bitcast<u32>(_e140) & 2147483647u) > 2139095040u) {
                    phi_777_ = _e140;
                } else {
                    if (_e140 < 0f) {
                        phi_776_ = 0f;
                    } else {
                        if (_e140 > 1f) {
                            phi_775_ = 1f;
                        } else {
                            phi_775_ = _e140;
                        }
                        let _e147 = phi_775_;
                        phi_776_ = _e147;
                    }
                    let _e149 = phi_776_;
                    phi_777_ = _e149;
                }
                let _e151 = phi_777_;
                phi_813_ = _e151;
            } else {
                if (_e70 > _e127.x) {
                    let _e162 = (1f - (((_e48 - (_e47 * (_e70 + _e127.y))) + (_e70 * _e127.y)) / ((_e127.x - _e70) * (_e127.x - _e127.y))));
                    if ((bitcast<u32>(_e162) & 2147483647u) > 2139095040u) {
                        phi_808_ = _e162;
                    } else {
                        if (_e162 < 0f) {
                            phi_807_ = 0f;
                        } else {
                            if (_e162 > 1f) {
                                phi_806_ = 1f;
                            } else {
                                phi_806_ = _e162;
                            }
                            let _e169 = phi_806_;
                            phi_807_ = _e169;
                        }
                        let _e171 = phi_807_;
                        phi_808_ = _e171;
                    }
                    let _e173 = phi_808_;
                    phi_812_ = _e173;
                } else {
                    phi_812_ = bitcast<f32>((bitcast<u32>(_e127.x) | 2143289344u));
                }
                let _e178 = phi_812_;
                phi_813_ = _e178;
            }
            let _e180 = phi_813_;
            phi_814_ = _e180;
        }
        let _e182 = phi_814_;
        phi_815_ = _e182;
    } else {
        phi_815_ = _e92;
    }
    let _e184 = phi_815_;
    return _e184;
}

fn function_() {
    var local: f32;
    var phi_198_: bool;
    var phi_199_: bool;
    var phi_200_: bool;
    var phi_201_: bool;
    var phi_205_: bool;
    var phi_249_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_253_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_330_: bool;
    var phi_339_: bool;
    var phi_348_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_352_: bool;
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_358_: bool;
    var phi_394_: f32;
    var phi_399_: f32;
    var phi_400_: bool;
    var phi_401_: f32;
    var phi_402_: bool;
    var phi_406_: f32;
    var phi_426_: f32;
    var phi_431_: f32;
    var phi_432_: bool;
    var phi_433_: f32;
    var phi_434_: bool;
    var phi_438_: f32;
    var phi_484_: i32;
    var phi_489_: i32;
    var phi_494_: i32;
    var phi_499_: i32;
    var phi_508_: i32;
    var phi_513_: i32;
    var phi_518_: i32;
    var phi_523_: i32;
    var phi_608_: evaluate_Verdict;
    var phi_609_: evaluate_Verdict;
    var phi_610_: bool;
    var phi_611_: evaluate_Verdict;
    var phi_612_: evaluate_Verdict;
    var phi_613_: bool;
    var phi_617_: evaluate_Verdict;

    let _e34 = id_1;
    let _e41 = arrayLength((&map.member));
    let _e47 = p.member.size[0u];
    let _e49 = p.member.size[1u];
    let _e50 = lt_shaders_entry_pixel_index(_e34, _e47, _e49);
    if (bitcast<i32>(_e50.root) != 0i) {
        if (_e50.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e59 = p.member.light;
        let _e62 = samples.member[(0u + _e50.first_primitive)].normal[0u];
        let _e64 = global[0u];
        if (_e62 == _e64) {
            let _e67 = samples.member[(0u + _e50.first_primitive)].normal[1u];
            let _e69 = global[1u];
            if (_e67 == _e69) {
                let _e72 = samples.member[(0u + _e50.first_primitive)].normal[2u];
                let _e74 = global[2u];
                phi_198_ = (_e72 == _e74);
                phi_199_ = false;
            } else {
                phi_198_ = bool();
                phi_199_ = true;
            }
            let _e77 = phi_198_;
            let _e79 = phi_199_;
            phi_200_ = _e77;
            phi_201_ = _e79;
        } else {
            phi_200_ = bool();
            phi_201_ = true;
        }
        let _e81 = phi_200_;
        let _e83 = phi_201_;
        if _e83 {
            phi_205_ = false;
        } else {
            phi_205_ = _e81;
        }
        let _e85 = phi_205_;
        if !(_e85) {
            let _e88 = samples.member[(0u + _e50.first_primitive)].normal;
            let _e90 = samples.member[(0u + _e50.first_primitive)].position;
            if ((((_e88.x * (_e59.x - (_e90.x * _e59.w))) + (_e88.y * (_e59.y - (_e90.y * _e59.w)))) + (_e88.z * (_e59.z - (_e90.z * _e59.w)))) > 0f) {
                let _e114 = samples.member[(0u + _e50.first_primitive)].flags;
                let _e122 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e122.unnamed.visibility, false), _e122.unnamed_1);
                phi_249_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e128.unnamed, ((_e114 & 1u) == 0u));
            } else {
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_249_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, true);
            }
            let _e148 = phi_249_;
            phi_253_ = _e148;
        } else {
            let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
            phi_253_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
        }
        let _e165 = phi_253_;
        if _e165.unnamed_1 {
            phi_611_ = evaluate_Verdict(_e165.unnamed.visibility, _e165.unnamed.is_doubted);
            phi_612_ = evaluate_Verdict();
            phi_613_ = true;
        } else {
            let _e173 = samples.member[(0u + _e50.first_primitive)].position;
            let _e179 = p.member.projection.row_w;
            let _e190 = ((((_e179.x * _e173.x) + (_e179.y * _e173.y)) + (_e179.z * _e173.z)) + (_e179.w * 1f));
            let _e192 = p.member.projection.row_x;
            let _e204 = (((((_e192.x * _e173.x) + (_e192.y * _e173.y)) + (_e192.z * _e173.z)) + (_e192.w * 1f)) / _e190);
            let _e206 = p.member.projection.row_y;
            let _e218 = (((((_e206.x * _e173.x) + (_e206.y * _e173.y)) + (_e206.z * _e173.z)) + (_e206.w * 1f)) / _e190);
            let _e220 = p.member.projection.row_z;
            let _e231 = ((((_e220.x * _e173.x) + (_e220.y * _e173.y)) + (_e220.z * _e173.z)) + (_e220.w * 1f));
            if (_e190 > 0f) {
                if (_e204 >= 0f) {
                    phi_330_ = (_e204 <= 1f);
                } else {
                    phi_330_ = false;
                }
                let _e236 = phi_330_;
                if _e236 {
                    if (_e218 >= 0f) {
                        phi_339_ = (_e218 <= 1f);
                    } else {
                        phi_339_ = false;
                    }
                    let _e240 = phi_339_;
                    if _e240 {
                        if (_e231 >= 0f) {
                            phi_348_ = (_e231 <= 1f);
                        } else {
                            phi_348_ = false;
                        }
                        let _e244 = phi_348_;
                        phi_349_ = _e244;
                        phi_350_ = false;
                    } else {
                        phi_349_ = bool();
                        phi_350_ = true;
                    }
                    let _e246 = phi_349_;
                    let _e248 = phi_350_;
                    phi_351_ = _e246;
                    phi_352_ = _e248;
                } else {
                    phi_351_ = bool();
                    phi_352_ = true;
                }
                let _e250 = phi_351_;
                let _e252 = phi_352_;
                phi_353_ = _e250;
                phi_354_ = _e252;
            } else {
                phi_353_ = bool();
                phi_354_ = true;
            }
            let _e254 = phi_353_;
            let _e256 = phi_354_;
            if _e256 {
                phi_358_ = false;
            } else {
                phi_358_ = _e254;
            }
            let _e258 = phi_358_;
            if _e258 {
                let _e260 = p.member.map_size;
                let _e261 = f32(_e260);
                let _e264 = ((_e204 * _e261) - 0.5f);
                let _e265 = ((_e218 * _e261) - 0.5f);
                if (_e264 > -8388608f) {
                    let _e277 = f32(select(0i, select(select(i32(_e264), i32(-2147483648), (_e264 < bitcast<f32>(3472883712u))), 2147483647i, (_e264 > bitcast<f32>(1325400063u))), (_e264 == _e264)));
                    if (_e277 > _e264) {
                        phi_394_ = 1f;
                    } else {
                        phi_394_ = 0f;
                    }
                    let _e280 = phi_394_;
                    if (_e264 < 8388608f) {
                        phi_399_ = (_e277 - _e280);
                        phi_400_ = false;
                    } else {
                        phi_399_ = f32();
                        phi_400_ = true;
                    }
                    let _e283 = phi_399_;
                    let _e285 = phi_400_;
                    phi_401_ = _e283;
                    phi_402_ = _e285;
                } else {
                    phi_401_ = f32();
                    phi_402_ = true;
                }
                let _e287 = phi_401_;
                let _e289 = phi_402_;
                if _e289 {
                    phi_406_ = _e264;
                } else {
                    phi_406_ = _e287;
                }
                let _e291 = phi_406_;
                if (_e265 > -8388608f) {
                    let _e303 = f32(select(0i, select(select(i32(_e265), i32(-2147483648), (_e265 < bitcast<f32>(3472883712u))), 2147483647i, (_e265 > bitcast<f32>(1325400063u))), (_e265 == _e265)));
                    if (_e303 > _e265) {
                        phi_426_ = 1f;
                    } else {
                        phi_426_ = 0f;
                    }
                    let _e306 = phi_426_;
                    if (_e265 < 8388608f) {
                        phi_431_ = (_e303 - _e306);
                        phi_432_ = false;
                    } else {
                        phi_431_ = f32();
                        phi_432_ = true;
                    }
                    let _e309 = phi_431_;
                    let _e311 = phi_432_;
                    phi_433_ = _e309;
                    phi_434_ = _e311;
                } else {
                    phi_433_ = f32();
                    phi_434_ = true;
                }
                let _e313 = phi_433_;
                let _e315 = phi_434_;
                if _e315 {
                    phi_438_ = _e265;
                } else {
                    phi_438_ = _e313;
                }
                let _e317 = phi_438_;
                let _e318 = (_e264 - _e291);
                let _e319 = (_e265 - _e317);
                let _e328 = select(0i, select(select(i32(_e291), i32(-2147483648), (_e291 < bitcast<f32>(3472883712u))), 2147483647i, (_e291 > bitcast<f32>(1325400063u))), (_e291 == _e291));
                let _e337 = select(0i, select(select(i32(_e317), i32(-2147483648), (_e317 < bitcast<f32>(3472883712u))), 2147483647i, (_e317 > bitcast<f32>(1325400063u))), (_e317 == _e317));
                let _e340 = ((1f - _e318) * (1f - _e319));
                let _e342 = (_e318 * (1f - _e319));
                let _e344 = ((1f - _e318) * _e319);
                let _e345 = (_e318 * _e319);
                let _e347 = p.member.test;
                let _e348 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e347);
                let _e350 = p.member.map_size;
                local = _e348;
                let _e352 = (bitcast<i32>(_e350) - 1i);
                if (_e328 > 0i) {
                    phi_484_ = _e328;
                } else {
                    phi_484_ = 0i;
                }
                let _e355 = phi_484_;
                if (_e337 > 0i) {
                    phi_489_ = _e337;
                } else {
                    phi_489_ = 0i;
                }
                let _e358 = phi_489_;
                if (_e355 < _e352) {
                    phi_494_ = _e355;
                } else {
                    phi_494_ = _e352;
                }
                let _e361 = phi_494_;
                if (_e358 < _e352) {
                    phi_499_ = _e358;
                } else {
                    phi_499_ = _e352;
                }
                let _e364 = phi_499_;
                let _e365 = bitcast<u32>(_e361);
                let _e367 = (_e328 + 1i);
                let _e368 = (_e337 + 1i);
                if (_e367 > 0i) {
                    phi_508_ = _e367;
                } else {
                    phi_508_ = 0i;
                }
                let _e371 = phi_508_;
                if (_e368 > 0i) {
                    phi_513_ = _e368;
                } else {
                    phi_513_ = 0i;
                }
                let _e374 = phi_513_;
                if (_e371 < _e352) {
                    phi_518_ = _e371;
                } else {
                    phi_518_ = _e352;
                }
                let _e377 = phi_518_;
                if (_e374 < _e352) {
                    phi_523_ = _e374;
                } else {
                    phi_523_ = _e352;
                }
                let _e380 = phi_523_;
                let _e381 = bitcast<u32>(_e377);
                let _e383 = (bitcast<u32>(_e364) * _e350);
                let _e384 = (bitcast<u32>(_e380) * _e350);
                let _e385 = (_e383 + _e365);
                let _e386 = (_e383 + _e381);
                let _e387 = (_e384 + _e365);
                let _e388 = (_e384 + _e381);
                if (_e385 < _e41) {
                } else {
                    return;
                }
                let _e392 = map.member[(0u + _e385)];
                if (_e386 < _e41) {
                } else {
                    return;
                }
                let _e404 = map.member[(0u + _e386)];
                if (_e387 < _e41) {
                } else {
                    return;
                }
                let _e420 = map.member[(0u + _e387)];
                if (_e388 < _e41) {
                } else {
                    return;
                }
                let _e436 = map.member[(0u + _e388)];
                let _e450 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e392.x * _e340) + (_e404.x * _e342)) + (_e420.x * _e344)) + (_e436.x * _e345)), ((((_e392.y * _e340) + (_e404.y * _e342)) + (_e420.y * _e344)) + (_e436.y * _e345)), ((((_e392.z * _e340) + (_e404.z * _e342)) + (_e420.z * _e344)) + (_e436.z * _e345)), ((((_e392.w * _e340) + (_e404.w * _e342)) + (_e420.w * _e344)) + (_e436.w * _e345))), _e231);
                phi_608_ = evaluate_Verdict(_e450, false);
                phi_609_ = evaluate_Verdict();
                phi_610_ = false;
            } else {
                phi_608_ = evaluate_Verdict();
                phi_609_ = evaluate_Verdict(1f, false);
                phi_610_ = true;
            }
            let _e454 = phi_608_;
            let _e456 = phi_609_;
            let _e458 = phi_610_;
            phi_611_ = _e456;
            phi_612_ = _e454;
            phi_613_ = _e458;
        }
        let _e460 = phi_611_;
        let _e462 = phi_612_;
        let _e464 = phi_613_;
        if _e464 {
            phi_617_ = _e460;
        } else {
            phi_617_ = _e462;
        }
        let _e466 = phi_617_;
        if (_e50.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e50.first_primitive)] = _e466.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
