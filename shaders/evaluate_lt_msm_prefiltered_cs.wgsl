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

struct type_29 {
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
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_33 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_33;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(2) 
var<storage> map: type_29;

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

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_191_: f32;
    var phi_192_: f32;
    var phi_193_: f32;
    var phi_199_: bool;
    var phi_221_: f32;
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_225_: bool;
    var phi_226_: f32;
    var phi_227_: bool;
    var phi_265_: vec2<f32>;
    var phi_299_: f32;
    var phi_300_: f32;
    var phi_301_: f32;
    var phi_330_: f32;
    var phi_331_: f32;
    var phi_332_: f32;
    var phi_336_: f32;
    var phi_337_: f32;
    var phi_338_: f32;
    var phi_339_: f32;

    let _e37 = (*param_4);
    let _e38 = (1f - _e37);
    let _e47 = (0.5f * _e37);
    let _e48 = ((param_5.x * _e38) + _e47);
    let _e49 = ((param_5.y * _e38) + _e47);
    let _e51 = ((param_5.w * _e38) + _e47);
    let _e53 = (_e49 - (_e48 * _e48));
    let _e55 = (((param_5.z * _e38) + _e47) - (_e48 * _e49));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_193_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_192_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_191_ = 1f;
            } else {
                phi_191_ = param_6;
            }
            let _e67 = phi_191_;
            phi_192_ = _e67;
        }
        let _e69 = phi_192_;
        phi_193_ = _e69;
    }
    let _e71 = phi_193_;
    if (_e48 == _e51) {
        phi_199_ = (_e48 > 0.5f);
    } else {
        phi_199_ = false;
    }
    let _e75 = phi_199_;
    if _e75 {
        if (_e71 > 0f) {
            if ((bitcast<u32>(_e48) & 2147483647u) > 2139095040u) {
                phi_223_ = _e48;
            } else {
                if (_e48 < 0f) {
                    phi_222_ = 0f;
                } else {
                    if (_e48 > 1f) {
                        phi_221_ = 1f;
                    } else {
                        phi_221_ = _e48;
                    }
                    let _e83 = phi_221_;
                    phi_222_ = _e83;
                }
                let _e85 = phi_222_;
                phi_223_ = _e85;
            }
            let _e87 = phi_223_;
            phi_224_ = _e87;
            phi_225_ = false;
        } else {
            phi_224_ = f32();
            phi_225_ = true;
        }
        let _e89 = phi_224_;
        let _e91 = phi_225_;
        phi_226_ = _e89;
        phi_227_ = _e91;
    } else {
        phi_226_ = f32();
        phi_227_ = true;
    }
    let _e93 = phi_226_;
    let _e95 = phi_227_;
    if _e95 {
        let _e96 = (_e55 / _e53);
        let _e97 = (_e71 - _e48);
        let _e103 = (((((_e71 * _e71) - _e49) - (_e96 * _e97)) * _e53) / (((_e51 - (_e49 * _e49)) * _e53) - (_e55 * _e55)));
        let _e106 = ((_e97 / _e53) - (_e96 * _e103));
        let _e112 = ((0.5f * _e106) / _e103);
        let _e115 = ((_e112 * _e112) - (((1f - (_e106 * _e48)) - (_e103 * _e49)) / _e103));
        if (_e115 >= 0f) {
            let _e117 = sqrt(_e115);
            phi_265_ = vec2<f32>((-(_e112) - _e117), (-(_e112) + _e117));
        } else {
            phi_265_ = vec2(bitcast<f32>((bitcast<u32>(_e115) | 2143289344u)));
        }
        let _e128 = phi_265_;
        if (_e71 <= _e128.x) {
            phi_338_ = 1f;
        } else {
            if (_e71 > _e128.y) {
                let _e141 = (((_e49 - (_e48 * (_e128.x + _e128.y))) + (_e128.x * _e128.y)) / ((_e71 - _e128.x) * (_e71 - _e128.y)));
                if ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u) {
                    phi_301_ = _e141;
                } else {
                    if (_e141 < 0f) {
                        phi_300_ = 0f;
                    } else {
                        if (_e141 > 1f) {
                            phi_299_ = 1f;
                        } else {
                            phi_299_ = _e141;
                        }
                        let _e148 = phi_299_;
                        phi_300_ = _e148;
                    }
                    let _e150 = phi_300_;
                    phi_301_ = _e150;
                }
                let _e152 = phi_301_;
                phi_337_ = _e152;
            } else {
                if (_e71 > _e128.x) {
                    let _e163 = (1f - (((_e49 - (_e48 * (_e71 + _e128.y))) + (_e71 * _e128.y)) / ((_e128.x - _e71) * (_e128.x - _e128.y))));
                    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
                        phi_332_ = _e163;
                    } else {
                        if (_e163 < 0f) {
                            phi_331_ = 0f;
                        } else {
                            if (_e163 > 1f) {
                                phi_330_ = 1f;
                            } else {
                                phi_330_ = _e163;
                            }
                            let _e170 = phi_330_;
                            phi_331_ = _e170;
                        }
                        let _e172 = phi_331_;
                        phi_332_ = _e172;
                    }
                    let _e174 = phi_332_;
                    phi_336_ = _e174;
                } else {
                    phi_336_ = bitcast<f32>((bitcast<u32>(_e128.x) | 2143289344u));
                }
                let _e179 = phi_336_;
                phi_337_ = _e179;
            }
            let _e181 = phi_337_;
            phi_338_ = _e181;
        }
        let _e183 = phi_338_;
        phi_339_ = _e183;
    } else {
        phi_339_ = _e93;
    }
    let _e185 = phi_339_;
    return _e185;
}

fn function_() {
    var local: f32;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_403_: bool;
    var phi_447_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_451_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_525_: bool;
    var phi_534_: bool;
    var phi_543_: bool;
    var phi_544_: bool;
    var phi_545_: bool;
    var phi_546_: bool;
    var phi_547_: bool;
    var phi_548_: bool;
    var phi_549_: bool;
    var phi_553_: bool;
    var phi_643_: f32;
    var phi_646_: f32;
    var phi_675_: f32;
    var phi_680_: f32;
    var phi_681_: bool;
    var phi_682_: f32;
    var phi_683_: bool;
    var phi_687_: f32;
    var phi_707_: f32;
    var phi_712_: f32;
    var phi_713_: bool;
    var phi_714_: f32;
    var phi_715_: bool;
    var phi_719_: f32;
    var phi_767_: i32;
    var phi_772_: i32;
    var phi_777_: i32;
    var phi_782_: i32;
    var phi_791_: i32;
    var phi_796_: i32;
    var phi_801_: i32;
    var phi_806_: i32;
    var phi_901_: bool;
    var phi_909_: bool;
    var phi_921_: bool;
    var phi_922_: bool;
    var phi_926_: f32;
    var phi_932_: f32;
    var phi_934_: evaluate_Verdict;
    var phi_939_: evaluate_Verdict;
    var phi_940_: evaluate_Verdict;

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
        let _e63 = p.member.light;
        let _e66 = samples.member[(0u + _e51.first_primitive)].normal[0u];
        let _e68 = global[0u];
        if (_e66 == _e68) {
            let _e71 = samples.member[(0u + _e51.first_primitive)].normal[1u];
            let _e73 = global[1u];
            if (_e71 == _e73) {
                let _e76 = samples.member[(0u + _e51.first_primitive)].normal[2u];
                let _e78 = global[2u];
                phi_396_ = (_e76 == _e78);
                phi_397_ = false;
            } else {
                phi_396_ = bool();
                phi_397_ = true;
            }
            let _e81 = phi_396_;
            let _e83 = phi_397_;
            phi_398_ = _e81;
            phi_399_ = _e83;
        } else {
            phi_398_ = bool();
            phi_399_ = true;
        }
        let _e85 = phi_398_;
        let _e87 = phi_399_;
        if _e87 {
            phi_403_ = false;
        } else {
            phi_403_ = _e85;
        }
        let _e89 = phi_403_;
        if !(_e89) {
            let _e92 = samples.member[(0u + _e51.first_primitive)].normal;
            let _e94 = samples.member[(0u + _e51.first_primitive)].position;
            if ((((_e92.x * (_e63.x - (_e94.x * _e63.w))) + (_e92.y * (_e63.y - (_e94.y * _e63.w)))) + (_e92.z * (_e63.z - (_e94.z * _e63.w)))) > 0f) {
                let _e118 = samples.member[(0u + _e51.first_primitive)].flags;
                let _e126 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e132 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e126.unnamed.visibility, false), _e126.unnamed_1);
                phi_447_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e132.unnamed, ((_e118 & 1u) == 0u));
            } else {
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e147 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e141.unnamed.visibility, false), _e141.unnamed_1);
                phi_447_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e147.unnamed, true);
            }
            let _e152 = phi_447_;
            phi_451_ = _e152;
        } else {
            let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e164 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e158.unnamed.visibility, false), _e158.unnamed_1);
            phi_451_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e164.unnamed, true);
        }
        let _e169 = phi_451_;
        if _e169.unnamed_1 {
            phi_940_ = evaluate_Verdict(_e169.unnamed.visibility, _e169.unnamed.is_doubted);
        } else {
            let _e177 = samples.member[(0u + _e51.first_primitive)].position;
            let _e195 = ((((_e61.projection.row_w.x * _e177.x) + (_e61.projection.row_w.y * _e177.y)) + (_e61.projection.row_w.z * _e177.z)) + (_e61.projection.row_w.w * 1f));
            let _e209 = (((((_e61.projection.row_x.x * _e177.x) + (_e61.projection.row_x.y * _e177.y)) + (_e61.projection.row_x.z * _e177.z)) + (_e61.projection.row_x.w * 1f)) / _e195);
            let _e223 = (((((_e61.projection.row_y.x * _e177.x) + (_e61.projection.row_y.y * _e177.y)) + (_e61.projection.row_y.z * _e177.z)) + (_e61.projection.row_y.w * 1f)) / _e195);
            let _e236 = ((((_e61.projection.row_z.x * _e177.x) + (_e61.projection.row_z.y * _e177.y)) + (_e61.projection.row_z.z * _e177.z)) + (_e61.projection.row_z.w * 1f));
            if (_e195 > 0f) {
                if (_e209 >= 0f) {
                    phi_525_ = (_e209 <= 1f);
                } else {
                    phi_525_ = false;
                }
                let _e241 = phi_525_;
                if _e241 {
                    if (_e223 >= 0f) {
                        phi_534_ = (_e223 <= 1f);
                    } else {
                        phi_534_ = false;
                    }
                    let _e245 = phi_534_;
                    if _e245 {
                        if (_e236 >= 0f) {
                            phi_543_ = (_e236 <= 1f);
                        } else {
                            phi_543_ = false;
                        }
                        let _e249 = phi_543_;
                        phi_544_ = _e249;
                        phi_545_ = false;
                    } else {
                        phi_544_ = bool();
                        phi_545_ = true;
                    }
                    let _e251 = phi_544_;
                    let _e253 = phi_545_;
                    phi_546_ = _e251;
                    phi_547_ = _e253;
                } else {
                    phi_546_ = bool();
                    phi_547_ = true;
                }
                let _e255 = phi_546_;
                let _e257 = phi_547_;
                phi_548_ = _e255;
                phi_549_ = _e257;
            } else {
                phi_548_ = bool();
                phi_549_ = true;
            }
            let _e259 = phi_548_;
            let _e261 = phi_549_;
            if _e261 {
                phi_553_ = false;
            } else {
                phi_553_ = _e259;
            }
            let _e263 = phi_553_;
            if _e263 {
                if (0f > 0f) {
                    let _e266 = samples.member[(0u + _e51.first_primitive)].normal;
                    let _e268 = p.member.map_size;
                    let _e338 = ((abs(((((_e57.row_x.x * _e266.x) + (_e57.row_x.y * _e266.y)) + (_e57.row_x.z * _e266.z)) / (((_e57.row_x.x * _e57.row_x.x) + (_e57.row_x.y * _e57.row_x.y)) + (_e57.row_x.z * _e57.row_x.z)))) + abs(((((_e57.row_y.x * _e266.x) + (_e57.row_y.y * _e266.y)) + (_e57.row_y.z * _e266.z)) / (((_e57.row_y.x * _e57.row_y.x) + (_e57.row_y.y * _e57.row_y.y)) + (_e57.row_y.z * _e57.row_y.z))))) / (abs(((((_e57.row_z.x * _e266.x) + (_e57.row_z.y * _e266.y)) + (_e57.row_z.z * _e266.z)) / (((_e57.row_z.x * _e57.row_z.x) + (_e57.row_z.y * _e57.row_z.y)) + (_e57.row_z.z * _e57.row_z.z)))) * f32(_e268)));
                    if (_e338 < 0.002f) {
                        phi_643_ = _e338;
                    } else {
                        phi_643_ = 0.002f;
                    }
                    let _e341 = phi_643_;
                    phi_646_ = (_e236 - (0f * _e341));
                } else {
                    phi_646_ = _e236;
                }
                let _e345 = phi_646_;
                let _e347 = p.member.map_size;
                let _e348 = f32(_e347);
                let _e351 = ((_e209 * _e348) - 0.5f);
                let _e352 = ((_e223 * _e348) - 0.5f);
                if (_e351 > -8388608f) {
                    let _e364 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e364 > _e351) {
                        phi_675_ = 1f;
                    } else {
                        phi_675_ = 0f;
                    }
                    let _e367 = phi_675_;
                    if (_e351 < 8388608f) {
                        phi_680_ = (_e364 - _e367);
                        phi_681_ = false;
                    } else {
                        phi_680_ = f32();
                        phi_681_ = true;
                    }
                    let _e370 = phi_680_;
                    let _e372 = phi_681_;
                    phi_682_ = _e370;
                    phi_683_ = _e372;
                } else {
                    phi_682_ = f32();
                    phi_683_ = true;
                }
                let _e374 = phi_682_;
                let _e376 = phi_683_;
                if _e376 {
                    phi_687_ = _e351;
                } else {
                    phi_687_ = _e374;
                }
                let _e378 = phi_687_;
                if (_e352 > -8388608f) {
                    let _e390 = f32(select(0i, select(select(i32(_e352), i32(-2147483648), (_e352 < bitcast<f32>(3472883712u))), 2147483647i, (_e352 > bitcast<f32>(1325400063u))), (_e352 == _e352)));
                    if (_e390 > _e352) {
                        phi_707_ = 1f;
                    } else {
                        phi_707_ = 0f;
                    }
                    let _e393 = phi_707_;
                    if (_e352 < 8388608f) {
                        phi_712_ = (_e390 - _e393);
                        phi_713_ = false;
                    } else {
                        phi_712_ = f32();
                        phi_713_ = true;
                    }
                    let _e396 = phi_712_;
                    let _e398 = phi_713_;
                    phi_714_ = _e396;
                    phi_715_ = _e398;
                } else {
                    phi_714_ = f32();
                    phi_715_ = true;
                }
                let _e400 = phi_714_;
                let _e402 = phi_715_;
                if _e402 {
                    phi_719_ = _e352;
                } else {
                    phi_719_ = _e400;
                }
                let _e404 = phi_719_;
                let _e405 = (_e351 - _e378);
                let _e406 = (_e352 - _e404);
                let _e415 = select(0i, select(select(i32(_e378), i32(-2147483648), (_e378 < bitcast<f32>(3472883712u))), 2147483647i, (_e378 > bitcast<f32>(1325400063u))), (_e378 == _e378));
                let _e424 = select(0i, select(select(i32(_e404), i32(-2147483648), (_e404 < bitcast<f32>(3472883712u))), 2147483647i, (_e404 > bitcast<f32>(1325400063u))), (_e404 == _e404));
                let _e427 = ((1f - _e405) * (1f - _e406));
                let _e429 = (_e405 * (1f - _e406));
                let _e431 = ((1f - _e405) * _e406);
                let _e432 = (_e405 * _e406);
                let _e434 = p.member.test;
                let _e435 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e434);
                let _e437 = p.member.map_size;
                local = _e435;
                let _e439 = ((0u * _e437) * _e437);
                let _e441 = (bitcast<i32>(_e437) - 1i);
                if (_e415 > 0i) {
                    phi_767_ = _e415;
                } else {
                    phi_767_ = 0i;
                }
                let _e444 = phi_767_;
                if (_e424 > 0i) {
                    phi_772_ = _e424;
                } else {
                    phi_772_ = 0i;
                }
                let _e447 = phi_772_;
                if (_e444 < _e441) {
                    phi_777_ = _e444;
                } else {
                    phi_777_ = _e441;
                }
                let _e450 = phi_777_;
                if (_e447 < _e441) {
                    phi_782_ = _e447;
                } else {
                    phi_782_ = _e441;
                }
                let _e453 = phi_782_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e415 + 1i);
                let _e457 = (_e424 + 1i);
                if (_e456 > 0i) {
                    phi_791_ = _e456;
                } else {
                    phi_791_ = 0i;
                }
                let _e460 = phi_791_;
                if (_e457 > 0i) {
                    phi_796_ = _e457;
                } else {
                    phi_796_ = 0i;
                }
                let _e463 = phi_796_;
                if (_e460 < _e441) {
                    phi_801_ = _e460;
                } else {
                    phi_801_ = _e441;
                }
                let _e466 = phi_801_;
                if (_e463 < _e441) {
                    phi_806_ = _e463;
                } else {
                    phi_806_ = _e441;
                }
                let _e469 = phi_806_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (bitcast<u32>(_e453) * _e437);
                let _e473 = (bitcast<u32>(_e469) * _e437);
                let _e478 = ((_e472 + _e454) + _e439);
                let _e479 = ((_e472 + _e470) + _e439);
                let _e480 = ((_e473 + _e454) + _e439);
                let _e481 = ((_e473 + _e470) + _e439);
                if (_e478 < _e42) {
                } else {
                    return;
                }
                let _e485 = map.member[(0u + _e478)];
                if (_e479 < _e42) {
                } else {
                    return;
                }
                let _e497 = map.member[(0u + _e479)];
                if (_e480 < _e42) {
                } else {
                    return;
                }
                let _e513 = map.member[(0u + _e480)];
                if (_e481 < _e42) {
                } else {
                    return;
                }
                let _e529 = map.member[(0u + _e481)];
                let _e543 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e485.x * _e427) + (_e497.x * _e429)) + (_e513.x * _e431)) + (_e529.x * _e432)), ((((_e485.y * _e427) + (_e497.y * _e429)) + (_e513.y * _e431)) + (_e529.y * _e432)), ((((_e485.z * _e427) + (_e497.z * _e429)) + (_e513.z * _e431)) + (_e529.z * _e432)), ((((_e485.w * _e427) + (_e497.w * _e429)) + (_e513.w * _e431)) + (_e529.w * _e432))), _e345);
                let _e545 = p.member.epsilon;
                if (_e543 <= _e545) {
                    phi_901_ = true;
                } else {
                    phi_901_ = (_e543 >= (1f - _e545));
                }
                let _e550 = phi_901_;
                if ((bitcast<u32>(_e543) & 2147483647u) > 2139095040u) {
                    phi_909_ = true;
                } else {
                    phi_909_ = !(_e550);
                }
                let _e556 = phi_909_;
                if _e556 {
                    if (_e543 > 0f) {
                        if (_e543 < 1f) {
                            phi_921_ = false;
                        } else {
                            phi_921_ = true;
                        }
                        let _e560 = phi_921_;
                        phi_922_ = _e560;
                    } else {
                        phi_922_ = true;
                    }
                    let _e562 = phi_922_;
                    if _e562 {
                        phi_926_ = 0.5f;
                    } else {
                        phi_926_ = _e543;
                    }
                    let _e564 = phi_926_;
                    phi_934_ = evaluate_Verdict(_e564, true);
                } else {
                    if (_e543 > 0.5f) {
                        phi_932_ = 1f;
                    } else {
                        phi_932_ = 0f;
                    }
                    let _e568 = phi_932_;
                    phi_934_ = evaluate_Verdict(_e568, false);
                }
                let _e571 = phi_934_;
                phi_939_ = evaluate_Verdict(_e571.visibility, _e571.is_doubted);
            } else {
                phi_939_ = evaluate_Verdict(0.5f, true);
            }
            let _e577 = phi_939_;
            phi_940_ = _e577;
        }
        let _e579 = phi_940_;
        if (_e51.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e51.first_primitive)] = _e579.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
