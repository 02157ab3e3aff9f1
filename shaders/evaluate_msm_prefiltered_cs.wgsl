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
    var phi_187_: f32;
    var phi_188_: f32;
    var phi_189_: f32;
    var phi_195_: bool;
    var phi_217_: f32;
    var phi_218_: f32;
    var phi_219_: f32;
    var phi_220_: f32;
    var phi_221_: bool;
    var phi_222_: f32;
    var phi_223_: bool;
    var phi_261_: vec2<f32>;
    var phi_295_: f32;
    var phi_296_: f32;
    var phi_297_: f32;
    var phi_326_: f32;
    var phi_327_: f32;
    var phi_328_: f32;
    var phi_332_: f32;
    var phi_333_: f32;
    var phi_334_: f32;
    var phi_335_: f32;

    let _e36 = (*param_4);
    let _e37 = (1f - _e36);
    let _e46 = (0.5f * _e36);
    let _e47 = ((param_5.x * _e37) + _e46);
    let _e48 = ((param_5.y * _e37) + _e46);
    let _e50 = ((param_5.w * _e37) + _e46);
    let _e52 = (_e48 - (_e47 * _e47));
    let _e54 = (((param_5.z * _e37) + _e46) - (_e47 * _e48));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_189_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_188_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_187_ = 1f;
            } else {
                phi_187_ = param_6;
            }
            let _e66 = phi_187_;
            phi_188_ = _e66;
        }
        let _e68 = phi_188_;
        phi_189_ = _e68;
    }
    let _e70 = phi_189_;
    if (_e47 == _e50) {
        phi_195_ = (_e47 > 0.5f);
    } else {
        phi_195_ = false;
    }
    let _e74 = phi_195_;
    if _e74 {
        if (_e70 > 0f) {
            if ((bitcast<u32>(_e47) & 2147483647u) > 2139095040u) {
                phi_219_ = _e47;
            } else {
                if (_e47 < 0f) {
                    phi_218_ = 0f;
                } else {
                    if (_e47 > 1f) {
                        phi_217_ = 1f;
                    } else {
                        phi_217_ = _e47;
                    }
                    let _e82 = phi_217_;
                    phi_218_ = _e82;
                }
                let _e84 = phi_218_;
                phi_219_ = _e84;
            }
            let _e86 = phi_219_;
            phi_220_ = _e86;
            phi_221_ = false;
        } else {
            phi_220_ = f32();
            phi_221_ = true;
        }
        let _e88 = phi_220_;
        let _e90 = phi_221_;
        phi_222_ = _e88;
        phi_223_ = _e90;
    } else {
        phi_222_ = f32();
        phi_223_ = true;
    }
    let _e92 = phi_222_;
    let _e94 = phi_223_;
    if _e94 {
        let _e95 = (_e54 / _e52);
        let _e96 = (_e70 - _e47);
        let _e102 = (((((_e70 * _e70) - _e48) - (_e95 * _e96)) * _e52) / (((_e50 - (_e48 * _e48)) * _e52) - (_e54 * _e54)));
        let _e105 = ((_e96 / _e52) - (_e95 * _e102));
        let _e111 = ((0.5f * _e105) / _e102);
        let _e114 = ((_e111 * _e111) - (((1f - (_e105 * _e47)) - (_e102 * _e48)) / _e102));
        if (_e114 >= 0f) {
            let _e116 = sqrt(_e114);
            phi_261_ = vec2<f32>((-(_e111) - _e116), (-(_e111) + _e116));
        } else {
            phi_261_ = vec2(bitcast<f32>((bitcast<u32>(_e114) | 2143289344u)));
        }
        let _e127 = phi_261_;
        if (_e70 <= _e127.x) {
            phi_334_ = 1f;
        } else {
            if (_e70 > _e127.y) {
                let _e140 = (((_e48 - (_e47 * (_e127.x + _e127.y))) + (_e127.x * _e127.y)) / ((_e70 - _e127.x) * (_e70 - _e127.y)));
                if ((bitcast<u32>(_e140) & 2147483647u) > 2139095040u) {
                    phi_297_ = _e140;
                } else {
                    if (_e140 < 0f) {
                        phi_296_ = 0f;
                    } else {
                        if (_e140 > 1f) {
                            phi_295_ = 1f;
                        } else {
                            phi_295_ = _e140;
                        }
                        let _e147 = phi_295_;
                        phi_296_ = _e147;
                    }
                    let _e149 = phi_296_;
                    phi_297_ = _e149;
                }
                let _e151 = phi_297_;
                phi_333_ = _e151;
            } else {
                if (_e70 > _e127.x) {
                    let _e162 = (1f - (((_e48 - (_e47 * (_e70 + _e127.y))) + (_e70 * _e127.y)) / ((_e127.x - _e70) * (_e127.x - _e127.y))));
                    if ((bitcast<u32>(_e162) & 2147483647u) > 2139095040u) {
                        phi_328_ = _e162;
                    } else {
                        if (_e162 < 0f) {
                            phi_327_ = 0f;
                        } else {
                            if (_e162 > 1f) {
                                phi_326_ = 1f;
                            } else {
                                phi_326_ = _e162;
                            }
                            let _e169 = phi_326_;
                            phi_327_ = _e169;
                        }
                        let _e171 = phi_327_;
                        phi_328_ = _e171;
                    }
                    let _e173 = phi_328_;
                    phi_332_ = _e173;
                } else {
                    phi_332_ = bitcast<f32>((bitcast<u32>(_e127.x) | 2143289344u));
                }
                let _e178 = phi_332_;
                phi_333_ = _e178;
            }
            let _e180 = phi_333_;
            phi_334_ = _e180;
        }
        let _e182 = phi_334_;
        phi_335_ = _e182;
    } else {
        phi_335_ = _e92;
    }
    let _e184 = phi_335_;
    return _e184;
}

fn function_() {
    var local: f32;
    var phi_389_: bool;
    var phi_390_: bool;
    var phi_391_: bool;
    var phi_392_: bool;
    var phi_396_: bool;
    var phi_440_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_444_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_521_: bool;
    var phi_530_: bool;
    var phi_539_: bool;
    var phi_540_: bool;
    var phi_541_: bool;
    var phi_542_: bool;
    var phi_543_: bool;
    var phi_544_: bool;
    var phi_545_: bool;
    var phi_549_: bool;
    var phi_585_: f32;
    var phi_590_: f32;
    var phi_591_: bool;
    var phi_592_: f32;
    var phi_593_: bool;
    var phi_597_: f32;
    var phi_617_: f32;
    var phi_622_: f32;
    var phi_623_: bool;
    var phi_624_: f32;
    var phi_625_: bool;
    var phi_629_: f32;
    var phi_675_: i32;
    var phi_680_: i32;
    var phi_685_: i32;
    var phi_690_: i32;
    var phi_699_: i32;
    var phi_704_: i32;
    var phi_709_: i32;
    var phi_714_: i32;
    var phi_799_: evaluate_Verdict;
    var phi_800_: evaluate_Verdict;
    var phi_801_: bool;
    var phi_802_: evaluate_Verdict;
    var phi_803_: evaluate_Verdict;
    var phi_804_: bool;
    var phi_808_: evaluate_Verdict;

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
                phi_389_ = (_e72 == _e74);
                phi_390_ = false;
            } else {
                phi_389_ = bool();
                phi_390_ = true;
            }
            let _e77 = phi_389_;
            let _e79 = phi_390_;
            phi_391_ = _e77;
            phi_392_ = _e79;
        } else {
            phi_391_ = bool();
            phi_392_ = true;
        }
        let _e81 = phi_391_;
        let _e83 = phi_392_;
        if _e83 {
            phi_396_ = false;
        } else {
            phi_396_ = _e81;
        }
        let _e85 = phi_396_;
        if !(_e85) {
            let _e88 = samples.member[(0u + _e50.first_primitive)].normal;
            let _e90 = samples.member[(0u + _e50.first_primitive)].position;
            if ((((_e88.x * (_e59.x - (_e90.x * _e59.w))) + (_e88.y * (_e59.y - (_e90.y * _e59.w)))) + (_e88.z * (_e59.z - (_e90.z * _e59.w)))) > 0f) {
                let _e114 = samples.member[(0u + _e50.first_primitive)].flags;
                let _e122 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e122.unnamed.visibility, false), _e122.unnamed_1);
                phi_440_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e128.unnamed, ((_e114 & 1u) == 0u));
            } else {
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_440_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, true);
            }
            let _e148 = phi_440_;
            phi_444_ = _e148;
        } else {
            let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
            phi_444_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
        }
        let _e165 = phi_444_;
        if _e165.unnamed_1 {
            phi_802_ = evaluate_Verdict(_e165.unnamed.visibility, _e165.unnamed.is_doubted);
            phi_803_ = evaluate_Verdict();
            phi_804_ = true;
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
                    phi_521_ = (_e204 <= 1f);
                } else {
                    phi_521_ = false;
                }
                let _e236 = phi_521_;
                if _e236 {
                    if (_e218 >= 0f) {
                        phi_530_ = (_e218 <= 1f);
                    } else {
                        phi_530_ = false;
                    }
                    let _e240 = phi_530_;
                    if _e240 {
                        if (_e231 >= 0f) {
                            phi_539_ = (_e231 <= 1f);
                        } else {
                            phi_539_ = false;
                        }
                        let _e244 = phi_539_;
                        phi_540_ = _e244;
                        phi_541_ = false;
                    } else {
                        phi_540_ = bool();
                        phi_541_ = true;
                    }
                    let _e246 = phi_540_;
                    let _e248 = phi_541_;
                    phi_542_ = _e246;
                    phi_543_ = _e248;
                } else {
                    phi_542_ = bool();
                    phi_543_ = true;
                }
                let _e250 = phi_542_;
                let _e252 = phi_543_;
                phi_544_ = _e250;
                phi_545_ = _e252;
            } else {
                phi_544_ = bool();
                phi_545_ = true;
            }
            let _e254 = phi_544_;
            let _e256 = phi_545_;
            if _e256 {
                phi_549_ = false;
            } else {
                phi_549_ = _e254;
            }
            let _e258 = phi_549_;
            if _e258 {
                let _e260 = p.member.map_size;
                let _e261 = f32(_e260);
                let _e264 = ((_e204 * _e261) - 0.5f);
                let _e265 = ((_e218 * _e261) - 0.5f);
                if (_e264 > -8388608f) {
                    let _e277 = f32(select(0i, select(select(i32(_e264), i32(-2147483648), (_e264 < bitcast<f32>(3472883712u))), 2147483647i, (_e264 > bitcast<f32>(1325400063u))), (_e264 == _e264)));
                    if (_e277 > _e264) {
                        phi_585_ = 1f;
                    } else {
                        phi_585_ = 0f;
                    }
                    let _e280 = phi_585_;
                    if (_e264 < 8388608f) {
                        phi_590_ = (_e277 - _e280);
                        phi_591_ = false;
                    } else {
                        phi_590_ = f32();
                        phi_591_ = true;
                    }
                    let _e283 = phi_590_;
                    let _e285 = phi_591_;
                    phi_592_ = _e283;
                    phi_593_ = _e285;
                } else {
                    phi_592_ = f32();
                    phi_593_ = true;
                }
                let _e287 = phi_592_;
                let _e289 = phi_593_;
                if _e289 {
                    phi_597_ = _e264;
                } else {
                    phi_597_ = _e287;
                }
                let _e291 = phi_597_;
                if (_e265 > -8388608f) {
                    let _e303 = f32(select(0i, select(select(i32(_e265), i32(-2147483648), (_e265 < bitcast<f32>(3472883712u))), 2147483647i, (_e265 > bitcast<f32>(1325400063u))), (_e265 == _e265)));
                    if (_e303 > _e265) {
                        phi_617_ = 1f;
                    } else {
                        phi_617_ = 0f;
                    }
                    let _e306 = phi_617_;
                    if (_e265 < 8388608f) {
                        phi_622_ = (_e303 - _e306);
                        phi_623_ = false;
                    } else {
                        phi_622_ = f32();
                        phi_623_ = true;
                    }
                    let _e309 = phi_622_;
                    let _e311 = phi_623_;
                    phi_624_ = _e309;
                    phi_625_ = _e311;
                } else {
                    phi_624_ = f32();
                    phi_625_ = true;
                }
                let _e313 = phi_624_;
                let _e315 = phi_625_;
                if _e315 {
                    phi_629_ = _e265;
                } else {
                    phi_629_ = _e313;
                }
                let _e317 = phi_629_;
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
                    phi_675_ = _e328;
                } else {
                    phi_675_ = 0i;
                }
                let _e355 = phi_675_;
                if (_e337 > 0i) {
                    phi_680_ = _e337;
                } else {
                    phi_680_ = 0i;
                }
                let _e358 = phi_680_;
                if (_e355 < _e352) {
                    phi_685_ = _e355;
                } else {
                    phi_685_ = _e352;
                }
                let _e361 = phi_685_;
                if (_e358 < _e352) {
                    phi_690_ = _e358;
                } else {
                    phi_690_ = _e352;
                }
                let _e364 = phi_690_;
                let _e365 = bitcast<u32>(_e361);
                let _e367 = (_e328 + 1i);
                let _e368 = (_e337 + 1i);
                if (_e367 > 0i) {
                    phi_699_ = _e367;
                } else {
                    phi_699_ = 0i;
                }
                let _e371 = phi_699_;
                if (_e368 > 0i) {
                    phi_704_ = _e368;
                } else {
                    phi_704_ = 0i;
                }
                let _e374 = phi_704_;
                if (_e371 < _e352) {
                    phi_709_ = _e371;
                } else {
                    phi_709_ = _e352;
                }
                let _e377 = phi_709_;
                if (_e374 < _e352) {
                    phi_714_ = _e374;
                } else {
                    phi_714_ = _e352;
                }
                let _e380 = phi_714_;
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
                phi_799_ = evaluate_Verdict(_e450, false);
                phi_800_ = evaluate_Verdict();
                phi_801_ = false;
            } else {
                phi_799_ = evaluate_Verdict();
                phi_800_ = evaluate_Verdict(1f, false);
                phi_801_ = true;
            }
            let _e454 = phi_799_;
            let _e456 = phi_800_;
            let _e458 = phi_801_;
            phi_802_ = _e456;
            phi_803_ = _e454;
            phi_804_ = _e458;
        }
        let _e460 = phi_802_;
        let _e462 = phi_803_;
        let _e464 = phi_804_;
        if _e464 {
            phi_808_ = _e460;
        } else {
            phi_808_ = _e462;
        }
        let _e466 = phi_808_;
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
