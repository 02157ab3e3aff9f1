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
    var phi_126_: lt_bvh_traverse_Tree;
    var phi_127_: bool;
    var phi_128_: lt_bvh_traverse_Tree;
    var phi_129_: bool;
    var phi_134_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_126_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_127_ = false;
        } else {
            phi_126_ = lt_bvh_traverse_Tree();
            phi_127_ = true;
        }
        let _e46 = phi_126_;
        let _e48 = phi_127_;
        phi_128_ = _e46;
        phi_129_ = _e48;
    } else {
        phi_128_ = lt_bvh_traverse_Tree();
        phi_129_ = true;
    }
    let _e50 = phi_128_;
    let _e52 = phi_129_;
    if _e52 {
        phi_134_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_134_ = _e50;
    }
    let _e57 = phi_134_;
    return lt_bvh_traverse_Tree(_e57.root, _e57.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_639_: f32;
    var phi_640_: f32;
    var phi_641_: f32;
    var phi_659_: bool;
    var phi_663_: f32;
    var phi_675_: bool;
    var phi_682_: f32;
    var phi_697_: f32;
    var phi_698_: f32;
    var phi_699_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_641_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_640_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_639_ = 1f;
            } else {
                phi_639_ = param_6;
            }
            let _e42 = phi_639_;
            phi_640_ = _e42;
        }
        let _e44 = phi_640_;
        phi_641_ = _e44;
    }
    let _e46 = phi_641_;
    let _e49 = (*param_4);
    let _e53 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e49) & 2147483647u) > 2139095040u) {
        phi_659_ = true;
    } else {
        let _e57 = (_e49 > _e53);
        if _e57 {
        }
        phi_659_ = _e57;
    }
    let _e59 = phi_659_;
    if _e59 {
        phi_663_ = _e49;
    } else {
        phi_663_ = _e53;
    }
    let _e61 = phi_663_;
    let _e62 = (_e46 - param_5.x);
    if (_e62 <= 0f) {
        let _e66 = ((bitcast<u32>(_e61) & 2147483647u) > 2139095040u);
        if _e66 {
        }
        phi_675_ = _e66;
    } else {
        phi_675_ = true;
    }
    let _e68 = phi_675_;
    if _e68 {
        phi_682_ = (_e61 / (_e61 + (_e62 * _e62)));
    } else {
        phi_682_ = 1f;
    }
    let _e73 = phi_682_;
    if ((bitcast<u32>(_e73) & 2147483647u) > 2139095040u) {
        phi_699_ = _e73;
    } else {
        if (_e73 < 0f) {
            phi_698_ = 0f;
        } else {
            if (_e73 > 1f) {
                phi_697_ = 1f;
            } else {
                phi_697_ = _e73;
            }
            let _e80 = phi_697_;
            phi_698_ = _e80;
        }
        let _e82 = phi_698_;
        phi_699_ = _e82;
    }
    let _e84 = phi_699_;
    return _e84;
}

fn function_() {
    var local: f32;
    var phi_194_: bool;
    var phi_195_: bool;
    var phi_196_: bool;
    var phi_197_: bool;
    var phi_201_: bool;
    var phi_245_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_249_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_326_: bool;
    var phi_335_: bool;
    var phi_344_: bool;
    var phi_345_: bool;
    var phi_346_: bool;
    var phi_347_: bool;
    var phi_348_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_354_: bool;
    var phi_390_: f32;
    var phi_395_: f32;
    var phi_396_: bool;
    var phi_397_: f32;
    var phi_398_: bool;
    var phi_402_: f32;
    var phi_422_: f32;
    var phi_427_: f32;
    var phi_428_: bool;
    var phi_429_: f32;
    var phi_430_: bool;
    var phi_434_: f32;
    var phi_480_: i32;
    var phi_485_: i32;
    var phi_490_: i32;
    var phi_495_: i32;
    var phi_504_: i32;
    var phi_509_: i32;
    var phi_514_: i32;
    var phi_519_: i32;
    var phi_604_: evaluate_Verdict;
    var phi_605_: evaluate_Verdict;
    var phi_606_: bool;
    var phi_607_: evaluate_Verdict;
    var phi_608_: evaluate_Verdict;
    var phi_609_: bool;
    var phi_613_: evaluate_Verdict;

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
                phi_194_ = (_e72 == _e74);
                phi_195_ = false;
            } else {
                phi_194_ = bool();
                phi_195_ = true;
            }
            let _e77 = phi_194_;
            let _e79 = phi_195_;
            phi_196_ = _e77;
            phi_197_ = _e79;
        } else {
            phi_196_ = bool();
            phi_197_ = true;
        }
        let _e81 = phi_196_;
        let _e83 = phi_197_;
        if _e83 {
            phi_201_ = false;
        } else {
            phi_201_ = _e81;
        }
        let _e85 = phi_201_;
        if !(_e85) {
            let _e88 = samples.member[(0u + _e50.first_primitive)].normal;
            let _e90 = samples.member[(0u + _e50.first_primitive)].position;
            if ((((_e88.x * (_e59.x - (_e90.x * _e59.w))) + (_e88.y * (_e59.y - (_e90.y * _e59.w)))) + (_e88.z * (_e59.z - (_e90.z * _e59.w)))) > 0f) {
                let _e114 = samples.member[(0u + _e50.first_primitive)].flags;
                let _e122 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e122.unnamed.visibility, false), _e122.unnamed_1);
                phi_245_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e128.unnamed, ((_e114 & 1u) == 0u));
            } else {
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_245_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, true);
            }
            let _e148 = phi_245_;
            phi_249_ = _e148;
        } else {
            let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
            phi_249_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
        }
        let _e165 = phi_249_;
        if _e165.unnamed_1 {
            phi_607_ = evaluate_Verdict(_e165.unnamed.visibility, _e165.unnamed.is_doubted);
            phi_608_ = evaluate_Verdict();
            phi_609_ = true;
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
                    phi_326_ = (_e204 <= 1f);
                } else {
                    phi_326_ = false;
                }
                let _e236 = phi_326_;
                if _e236 {
                    if (_e218 >= 0f) {
                        phi_335_ = (_e218 <= 1f);
                    } else {
                        phi_335_ = false;
                    }
                    let _e240 = phi_335_;
                    if _e240 {
                        if (_e231 >= 0f) {
                            phi_344_ = (_e231 <= 1f);
                        } else {
                            phi_344_ = false;
                        }
                        let _e244 = phi_344_;
                        phi_345_ = _e244;
                        phi_346_ = false;
                    } else {
                        phi_345_ = bool();
                        phi_346_ = true;
                    }
                    let _e246 = phi_345_;
                    let _e248 = phi_346_;
                    phi_347_ = _e246;
                    phi_348_ = _e248;
                } else {
                    phi_347_ = bool();
                    phi_348_ = true;
                }
                let _e250 = phi_347_;
                let _e252 = phi_348_;
                phi_349_ = _e250;
                phi_350_ = _e252;
            } else {
                phi_349_ = bool();
                phi_350_ = true;
            }
            let _e254 = phi_349_;
            let _e256 = phi_350_;
            if _e256 {
                phi_354_ = false;
            } else {
                phi_354_ = _e254;
            }
            let _e258 = phi_354_;
            if _e258 {
                let _e260 = p.member.map_size;
                let _e261 = f32(_e260);
                let _e264 = ((_e204 * _e261) - 0.5f);
                let _e265 = ((_e218 * _e261) - 0.5f);
                if (_e264 > -8388608f) {
                    let _e277 = f32(select(0i, select(select(i32(_e264), i32(-2147483648), (_e264 < bitcast<f32>(3472883712u))), 2147483647i, (_e264 > bitcast<f32>(1325400063u))), (_e264 == _e264)));
                    if (_e277 > _e264) {
                        phi_390_ = 1f;
                    } else {
                        phi_390_ = 0f;
                    }
                    let _e280 = phi_390_;
                    if (_e264 < 8388608f) {
                        phi_395_ = (_e277 - _e280);
                        phi_396_ = false;
                    } else {
                        phi_395_ = f32();
                        phi_396_ = true;
                    }
                    let _e283 = phi_395_;
                    let _e285 = phi_396_;
                    phi_397_ = _e283;
                    phi_398_ = _e285;
                } else {
                    phi_397_ = f32();
                    phi_398_ = true;
                }
                let _e287 = phi_397_;
                let _e289 = phi_398_;
                if _e289 {
                    phi_402_ = _e264;
                } else {
                    phi_402_ = _e287;
                }
                let _e291 = phi_402_;
                if (_e265 > -8388608f) {
                    let _e303 = f32(select(0i, select(select(i32(_e265), i32(-2147483648), (_e265 < bitcast<f32>(3472883712u))), 2147483647i, (_e265 > bitcast<f32>(1325400063u))), (_e265 == _e265)));
                    if (_e303 > _e265) {
                        phi_422_ = 1f;
                    } else {
                        phi_422_ = 0f;
                    }
                    let _e306 = phi_422_;
                    if (_e265 < 8388608f) {
                        phi_427_ = (_e303 - _e306);
                        phi_428_ = false;
                    } else {
                        phi_427_ = f32();
                        phi_428_ = true;
                    }
                    let _e309 = phi_427_;
                    let _e311 = phi_428_;
                    phi_429_ = _e309;
                    phi_430_ = _e311;
                } else {
                    phi_429_ = f32();
                    phi_430_ = true;
                }
                let _e313 = phi_429_;
                let _e315 = phi_430_;
                if _e315 {
                    phi_434_ = _e265;
                } else {
                    phi_434_ = _e313;
                }
                let _e317 = phi_434_;
                let _e318 = (_e264 - _e291);
                let _e319 = (_e265 - _e317);
                let _e328 = select(0i, select(select(i32(_e291), i32(-2147483648), (_e291 < bitcast<f32>(3472883712u))), 2147483647i, (_e291 > bitcast<f32>(1325400063u))), (_e291 == _e291));
                let _e337 = select(0i, select(select(i32(_e317), i32(-2147483648), (_e317 < bitcast<f32>(3472883712u))), 2147483647i, (_e317 > bitcast<f32>(1325400063u))), (_e317 == _e317));
                let _e340 = ((1f - _e318) * (1f - _e319));
                let _e342 = (_e318 * (1f - _e319));
                let _e344 = ((1f - _e318) * _e319);
                let _e345 = (_e318 * _e319);
                let _e347 = p.member.test;
                let _e348 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e347);
                let _e350 = p.member.map_size;
                local = _e348;
                let _e352 = (bitcast<i32>(_e350) - 1i);
                if (_e328 > 0i) {
                    phi_480_ = _e328;
                } else {
                    phi_480_ = 0i;
                }
                let _e355 = phi_480_;
                if (_e337 > 0i) {
                    phi_485_ = _e337;
                } else {
                    phi_485_ = 0i;
                }
                let _e358 = phi_485_;
                if (_e355 < _e352) {
                    phi_490_ = _e355;
                } else {
                    phi_490_ = _e352;
                }
                let _e361 = phi_490_;
                if (_e358 < _e352) {
                    phi_495_ = _e358;
                } else {
                    phi_495_ = _e352;
                }
                let _e364 = phi_495_;
                let _e365 = bitcast<u32>(_e361);
                let _e367 = (_e328 + 1i);
                let _e368 = (_e337 + 1i);
                if (_e367 > 0i) {
                    phi_504_ = _e367;
                } else {
                    phi_504_ = 0i;
                }
                let _e371 = phi_504_;
                if (_e368 > 0i) {
                    phi_509_ = _e368;
                } else {
                    phi_509_ = 0i;
                }
                let _e374 = phi_509_;
                if (_e371 < _e352) {
                    phi_514_ = _e371;
                } else {
                    phi_514_ = _e352;
                }
                let _e377 = phi_514_;
                if (_e374 < _e352) {
                    phi_519_ = _e374;
                } else {
                    phi_519_ = _e352;
                }
                let _e380 = phi_519_;
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
                let _e450 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e392.x * _e340) + (_e404.x * _e342)) + (_e420.x * _e344)) + (_e436.x * _e345)), ((((_e392.y * _e340) + (_e404.y * _e342)) + (_e420.y * _e344)) + (_e436.y * _e345)), ((((_e392.z * _e340) + (_e404.z * _e342)) + (_e420.z * _e344)) + (_e436.z * _e345)), ((((_e392.w * _e340) + (_e404.w * _e342)) + (_e420.w * _e344)) + (_e436.w * _e345))), _e231);
                phi_604_ = evaluate_Verdict(_e450, false);
                phi_605_ = evaluate_Verdict();
                phi_606_ = false;
            } else {
                phi_604_ = evaluate_Verdict();
                phi_605_ = evaluate_Verdict(1f, false);
                phi_606_ = true;
            }
            let _e454 = phi_604_;
            let _e456 = phi_605_;
            let _e458 = phi_606_;
            phi_607_ = _e456;
            phi_608_ = _e454;
            phi_609_ = _e458;
        }
        let _e460 = phi_607_;
        let _e462 = phi_608_;
        let _e464 = phi_609_;
        if _e464 {
            phi_613_ = _e460;
        } else {
            phi_613_ = _e462;
        }
        let _e466 = phi_613_;
        if (_e50.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e50.first_primitive)] = _e466.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_vsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
