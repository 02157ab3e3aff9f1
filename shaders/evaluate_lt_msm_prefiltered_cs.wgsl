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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_33 {
    member: abi_ShadowParams,
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
    var phi_133_: lt_bvh_traverse_Tree;
    var phi_134_: bool;
    var phi_135_: lt_bvh_traverse_Tree;
    var phi_136_: bool;
    var phi_141_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_133_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_134_ = false;
        } else {
            phi_133_ = lt_bvh_traverse_Tree();
            phi_134_ = true;
        }
        let _e47 = phi_133_;
        let _e49 = phi_134_;
        phi_135_ = _e47;
        phi_136_ = _e49;
    } else {
        phi_135_ = lt_bvh_traverse_Tree();
        phi_136_ = true;
    }
    let _e51 = phi_135_;
    let _e53 = phi_136_;
    if _e53 {
        phi_141_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_141_ = _e51;
    }
    let _e58 = phi_141_;
    return lt_bvh_traverse_Tree(_e58.root, _e58.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_190_: f32;
    var phi_191_: f32;
    var phi_192_: f32;
    var phi_198_: bool;
    var phi_220_: f32;
    var phi_221_: f32;
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_224_: bool;
    var phi_225_: f32;
    var phi_226_: bool;
    var phi_264_: vec2<f32>;
    var phi_298_: f32;
    var phi_299_: f32;
    var phi_300_: f32;
    var phi_329_: f32;
    var phi_330_: f32;
    var phi_331_: f32;
    var phi_335_: f32;
    var phi_336_: f32;
    var phi_337_: f32;
    var phi_338_: f32;

    let _e37 = (*param_4);
    let _e38 = (1f - _e37);
    let _e47 = (0.5f * _e37);
    let _e48 = ((param_5.x * _e38) + _e47);
    let _e49 = ((param_5.y * _e38) + _e47);
    let _e51 = ((param_5.w * _e38) + _e47);
    let _e53 = (_e49 - (_e48 * _e48));
    let _e55 = (((param_5.z * _e38) + _e47) - (_e48 * _e49));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_192_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_191_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_190_ = 1f;
            } else {
                phi_190_ = param_6;
            }
            let _e67 = phi_190_;
            phi_191_ = _e67;
        }
        let _e69 = phi_191_;
        phi_192_ = _e69;
    }
    let _e71 = phi_192_;
    if (_e48 == _e51) {
        phi_198_ = (_e48 > 0.5f);
    } else {
        phi_198_ = false;
    }
    let _e75 = phi_198_;
    if _e75 {
        if (_e71 > 0f) {
            if ((bitcast<u32>(_e48) & 2147483647u) > 2139095040u) {
                phi_222_ = _e48;
            } else {
                if (_e48 < 0f) {
                    phi_221_ = 0f;
                } else {
                    if (_e48 > 1f) {
                        phi_220_ = 1f;
                    } else {
                        phi_220_ = _e48;
                    }
                    let _e83 = phi_220_;
                    phi_221_ = _e83;
                }
                let _e85 = phi_221_;
                phi_222_ = _e85;
            }
            let _e87 = phi_222_;
            phi_223_ = _e87;
            phi_224_ = false;
        } else {
            phi_223_ = f32();
            phi_224_ = true;
        }
        let _e89 = phi_223_;
        let _e91 = phi_224_;
        phi_225_ = _e89;
        phi_226_ = _e91;
    } else {
        phi_225_ = f32();
        phi_226_ = true;
    }
    let _e93 = phi_225_;
    let _e95 = phi_226_;
    if _e95 {
        let _e96 = (_e55 / _e53);
        let _e97 = (_e71 - _e48);
        let _e103 = (((((_e71 * _e71) - _e49) - (_e96 * _e97)) * _e53) / (((_e51 - (_e49 * _e49)) * _e53) - (_e55 * _e55)));
        let _e106 = ((_e97 / _e53) - (_e96 * _e103));
        let _e112 = ((0.5f * _e106) / _e103);
        let _e115 = ((_e112 * _e112) - (((1f - (_e106 * _e48)) - (_e103 * _e49)) / _e103));
        if (_e115 >= 0f) {
            let _e117 = sqrt(_e115);
            phi_264_ = vec2<f32>((-(_e112) - _e117), (-(_e112) + _e117));
        } else {
            phi_264_ = vec2(bitcast<f32>((bitcast<u32>(_e115) | 2143289344u)));
        }
        let _e128 = phi_264_;
        if (_e71 <= _e128.x) {
            phi_337_ = 1f;
        } else {
            if (_e71 > _e128.y) {
                let _e141 = (((_e49 - (_e48 * (_e128.x + _e128.y))) + (_e128.x * _e128.y)) / ((_e71 - _e128.x) * (_e71 - _e128.y)));
                if ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u) {
                    phi_300_ = _e141;
                } else {
                    if (_e141 < 0f) {
                        phi_299_ = 0f;
                    } else {
                        if (_e141 > 1f) {
                            phi_298_ = 1f;
                        } else {
                            phi_298_ = _e141;
                        }
                        let _e148 = phi_298_;
                        phi_299_ = _e148;
                    }
                    let _e150 = phi_299_;
                    phi_300_ = _e150;
                }
                let _e152 = phi_300_;
                phi_336_ = _e152;
            } else {
                if (_e71 > _e128.x) {
                    let _e163 = (1f - (((_e49 - (_e48 * (_e71 + _e128.y))) + (_e71 * _e128.y)) / ((_e128.x - _e71) * (_e128.x - _e128.y))));
                    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
                        phi_331_ = _e163;
                    } else {
                        if (_e163 < 0f) {
                            phi_330_ = 0f;
                        } else {
                            if (_e163 > 1f) {
                                phi_329_ = 1f;
                            } else {
                                phi_329_ = _e163;
                            }
                            let _e170 = phi_329_;
                            phi_330_ = _e170;
                        }
                        let _e172 = phi_330_;
                        phi_331_ = _e172;
                    }
                    let _e174 = phi_331_;
                    phi_335_ = _e174;
                } else {
                    phi_335_ = bitcast<f32>((bitcast<u32>(_e128.x) | 2143289344u));
                }
                let _e179 = phi_335_;
                phi_336_ = _e179;
            }
            let _e181 = phi_336_;
            phi_337_ = _e181;
        }
        let _e183 = phi_337_;
        phi_338_ = _e183;
    } else {
        phi_338_ = _e93;
    }
    let _e185 = phi_338_;
    return _e185;
}

fn function_() {
    var local: f32;
    var phi_392_: bool;
    var phi_393_: bool;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_399_: bool;
    var phi_443_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_447_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_524_: bool;
    var phi_533_: bool;
    var phi_542_: bool;
    var phi_543_: bool;
    var phi_544_: bool;
    var phi_545_: bool;
    var phi_546_: bool;
    var phi_547_: bool;
    var phi_548_: bool;
    var phi_552_: bool;
    var phi_646_: f32;
    var phi_649_: f32;
    var phi_678_: f32;
    var phi_683_: f32;
    var phi_684_: bool;
    var phi_685_: f32;
    var phi_686_: bool;
    var phi_690_: f32;
    var phi_710_: f32;
    var phi_715_: f32;
    var phi_716_: bool;
    var phi_717_: f32;
    var phi_718_: bool;
    var phi_722_: f32;
    var phi_768_: i32;
    var phi_773_: i32;
    var phi_778_: i32;
    var phi_783_: i32;
    var phi_792_: i32;
    var phi_797_: i32;
    var phi_802_: i32;
    var phi_807_: i32;
    var phi_898_: bool;
    var phi_906_: bool;
    var phi_918_: bool;
    var phi_919_: bool;
    var phi_923_: f32;
    var phi_929_: f32;
    var phi_931_: evaluate_Verdict;
    var phi_936_: evaluate_Verdict;
    var phi_937_: evaluate_Verdict;

    let _e35 = id_1;
    let _e42 = arrayLength((&map.member));
    let _e48 = p.member.size[0u];
    let _e50 = p.member.size[1u];
    let _e51 = lt_shaders_entry_pixel_index(_e35, _e48, _e50);
    if (bitcast<i32>(_e51.root) != 0i) {
        if (_e51.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e60 = p.member.light;
        let _e63 = samples.member[(0u + _e51.first_primitive)].normal[0u];
        let _e65 = global[0u];
        if (_e63 == _e65) {
            let _e68 = samples.member[(0u + _e51.first_primitive)].normal[1u];
            let _e70 = global[1u];
            if (_e68 == _e70) {
                let _e73 = samples.member[(0u + _e51.first_primitive)].normal[2u];
                let _e75 = global[2u];
                phi_392_ = (_e73 == _e75);
                phi_393_ = false;
            } else {
                phi_392_ = bool();
                phi_393_ = true;
            }
            let _e78 = phi_392_;
            let _e80 = phi_393_;
            phi_394_ = _e78;
            phi_395_ = _e80;
        } else {
            phi_394_ = bool();
            phi_395_ = true;
        }
        let _e82 = phi_394_;
        let _e84 = phi_395_;
        if _e84 {
            phi_399_ = false;
        } else {
            phi_399_ = _e82;
        }
        let _e86 = phi_399_;
        if !(_e86) {
            let _e89 = samples.member[(0u + _e51.first_primitive)].normal;
            let _e91 = samples.member[(0u + _e51.first_primitive)].position;
            if ((((_e89.x * (_e60.x - (_e91.x * _e60.w))) + (_e89.y * (_e60.y - (_e91.y * _e60.w)))) + (_e89.z * (_e60.z - (_e91.z * _e60.w)))) > 0f) {
                let _e115 = samples.member[(0u + _e51.first_primitive)].flags;
                let _e123 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e123.unnamed.visibility, false), _e123.unnamed_1);
                phi_443_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e129.unnamed, ((_e115 & 1u) == 0u));
            } else {
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_443_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, true);
            }
            let _e149 = phi_443_;
            phi_447_ = _e149;
        } else {
            let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e155.unnamed.visibility, false), _e155.unnamed_1);
            phi_447_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e161.unnamed, true);
        }
        let _e166 = phi_447_;
        if _e166.unnamed_1 {
            phi_937_ = evaluate_Verdict(_e166.unnamed.visibility, _e166.unnamed.is_doubted);
        } else {
            let _e174 = samples.member[(0u + _e51.first_primitive)].position;
            let _e180 = p.member.projection.row_w;
            let _e191 = ((((_e180.x * _e174.x) + (_e180.y * _e174.y)) + (_e180.z * _e174.z)) + (_e180.w * 1f));
            let _e193 = p.member.projection.row_x;
            let _e205 = (((((_e193.x * _e174.x) + (_e193.y * _e174.y)) + (_e193.z * _e174.z)) + (_e193.w * 1f)) / _e191);
            let _e207 = p.member.projection.row_y;
            let _e219 = (((((_e207.x * _e174.x) + (_e207.y * _e174.y)) + (_e207.z * _e174.z)) + (_e207.w * 1f)) / _e191);
            let _e221 = p.member.projection.row_z;
            let _e232 = ((((_e221.x * _e174.x) + (_e221.y * _e174.y)) + (_e221.z * _e174.z)) + (_e221.w * 1f));
            if (_e191 > 0f) {
                if (_e205 >= 0f) {
                    phi_524_ = (_e205 <= 1f);
                } else {
                    phi_524_ = false;
                }
                let _e237 = phi_524_;
                if _e237 {
                    if (_e219 >= 0f) {
                        phi_533_ = (_e219 <= 1f);
                    } else {
                        phi_533_ = false;
                    }
                    let _e241 = phi_533_;
                    if _e241 {
                        if (_e232 >= 0f) {
                            phi_542_ = (_e232 <= 1f);
                        } else {
                            phi_542_ = false;
                        }
                        let _e245 = phi_542_;
                        phi_543_ = _e245;
                        phi_544_ = false;
                    } else {
                        phi_543_ = bool();
                        phi_544_ = true;
                    }
                    let _e247 = phi_543_;
                    let _e249 = phi_544_;
                    phi_545_ = _e247;
                    phi_546_ = _e249;
                } else {
                    phi_545_ = bool();
                    phi_546_ = true;
                }
                let _e251 = phi_545_;
                let _e253 = phi_546_;
                phi_547_ = _e251;
                phi_548_ = _e253;
            } else {
                phi_547_ = bool();
                phi_548_ = true;
            }
            let _e255 = phi_547_;
            let _e257 = phi_548_;
            if _e257 {
                phi_552_ = false;
            } else {
                phi_552_ = _e255;
            }
            let _e259 = phi_552_;
            if _e259 {
                if (0f > 0f) {
                    let _e262 = samples.member[(0u + _e51.first_primitive)].normal;
                    let _e264 = p.member.map_size;
                    let _e267 = p.member.projection.row_x;
                    let _e289 = p.member.projection.row_y;
                    let _e311 = p.member.projection.row_z;
                    let _e338 = ((abs(((((_e267.x * _e262.x) + (_e267.y * _e262.y)) + (_e267.z * _e262.z)) / (((_e267.x * _e267.x) + (_e267.y * _e267.y)) + (_e267.z * _e267.z)))) + abs(((((_e289.x * _e262.x) + (_e289.y * _e262.y)) + (_e289.z * _e262.z)) / (((_e289.x * _e289.x) + (_e289.y * _e289.y)) + (_e289.z * _e289.z))))) / (abs(((((_e311.x * _e262.x) + (_e311.y * _e262.y)) + (_e311.z * _e262.z)) / (((_e311.x * _e311.x) + (_e311.y * _e311.y)) + (_e311.z * _e311.z)))) * f32(_e264)));
                    if (_e338 < 0.002f) {
                        phi_646_ = _e338;
                    } else {
                        phi_646_ = 0.002f;
                    }
                    let _e341 = phi_646_;
                    phi_649_ = (_e232 - (0f * _e341));
                } else {
                    phi_649_ = _e232;
                }
                let _e345 = phi_649_;
                let _e347 = p.member.map_size;
                let _e348 = f32(_e347);
                let _e351 = ((_e205 * _e348) - 0.5f);
                let _e352 = ((_e219 * _e348) - 0.5f);
                if (_e351 > -8388608f) {
                    let _e364 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e364 > _e351) {
                        phi_678_ = 1f;
                    } else {
                        phi_678_ = 0f;
                    }
                    let _e367 = phi_678_;
                    if (_e351 < 8388608f) {
                        phi_683_ = (_e364 - _e367);
                        phi_684_ = false;
                    } else {
                        phi_683_ = f32();
                        phi_684_ = true;
                    }
                    let _e370 = phi_683_;
                    let _e372 = phi_684_;
                    phi_685_ = _e370;
                    phi_686_ = _e372;
                } else {
                    phi_685_ = f32();
                    phi_686_ = true;
                }
                let _e374 = phi_685_;
                let _e376 = phi_686_;
                if _e376 {
                    phi_690_ = _e351;
                } else {
                    phi_690_ = _e374;
                }
                let _e378 = phi_690_;
                if (_e352 > -8388608f) {
                    let _e390 = f32(select(0i, select(select(i32(_e352), i32(-2147483648), (_e352 < bitcast<f32>(3472883712u))), 2147483647i, (_e352 > bitcast<f32>(1325400063u))), (_e352 == _e352)));
                    if (_e390 > _e352) {
                        phi_710_ = 1f;
                    } else {
                        phi_710_ = 0f;
                    }
                    let _e393 = phi_710_;
                    if (_e352 < 8388608f) {
                        phi_715_ = (_e390 - _e393);
                        phi_716_ = false;
                    } else {
                        phi_715_ = f32();
                        phi_716_ = true;
                    }
                    let _e396 = phi_715_;
                    let _e398 = phi_716_;
                    phi_717_ = _e396;
                    phi_718_ = _e398;
                } else {
                    phi_717_ = f32();
                    phi_718_ = true;
                }
                let _e400 = phi_717_;
                let _e402 = phi_718_;
                if _e402 {
                    phi_722_ = _e352;
                } else {
                    phi_722_ = _e400;
                }
                let _e404 = phi_722_;
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
                let _e439 = (bitcast<i32>(_e437) - 1i);
                if (_e415 > 0i) {
                    phi_768_ = _e415;
                } else {
                    phi_768_ = 0i;
                }
                let _e442 = phi_768_;
                if (_e424 > 0i) {
                    phi_773_ = _e424;
                } else {
                    phi_773_ = 0i;
                }
                let _e445 = phi_773_;
                if (_e442 < _e439) {
                    phi_778_ = _e442;
                } else {
                    phi_778_ = _e439;
                }
                let _e448 = phi_778_;
                if (_e445 < _e439) {
                    phi_783_ = _e445;
                } else {
                    phi_783_ = _e439;
                }
                let _e451 = phi_783_;
                let _e452 = bitcast<u32>(_e448);
                let _e454 = (_e415 + 1i);
                let _e455 = (_e424 + 1i);
                if (_e454 > 0i) {
                    phi_792_ = _e454;
                } else {
                    phi_792_ = 0i;
                }
                let _e458 = phi_792_;
                if (_e455 > 0i) {
                    phi_797_ = _e455;
                } else {
                    phi_797_ = 0i;
                }
                let _e461 = phi_797_;
                if (_e458 < _e439) {
                    phi_802_ = _e458;
                } else {
                    phi_802_ = _e439;
                }
                let _e464 = phi_802_;
                if (_e461 < _e439) {
                    phi_807_ = _e461;
                } else {
                    phi_807_ = _e439;
                }
                let _e467 = phi_807_;
                let _e468 = bitcast<u32>(_e464);
                let _e470 = (bitcast<u32>(_e451) * _e437);
                let _e471 = (bitcast<u32>(_e467) * _e437);
                let _e472 = (_e470 + _e452);
                let _e473 = (_e470 + _e468);
                let _e474 = (_e471 + _e452);
                let _e475 = (_e471 + _e468);
                if (_e472 < _e42) {
                } else {
                    return;
                }
                let _e479 = map.member[(0u + _e472)];
                if (_e473 < _e42) {
                } else {
                    return;
                }
                let _e491 = map.member[(0u + _e473)];
                if (_e474 < _e42) {
                } else {
                    return;
                }
                let _e507 = map.member[(0u + _e474)];
                if (_e475 < _e42) {
                } else {
                    return;
                }
                let _e523 = map.member[(0u + _e475)];
                let _e537 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e479.x * _e427) + (_e491.x * _e429)) + (_e507.x * _e431)) + (_e523.x * _e432)), ((((_e479.y * _e427) + (_e491.y * _e429)) + (_e507.y * _e431)) + (_e523.y * _e432)), ((((_e479.z * _e427) + (_e491.z * _e429)) + (_e507.z * _e431)) + (_e523.z * _e432)), ((((_e479.w * _e427) + (_e491.w * _e429)) + (_e507.w * _e431)) + (_e523.w * _e432))), _e345);
                let _e539 = p.member.epsilon;
                if (_e537 <= _e539) {
                    phi_898_ = true;
                } else {
                    phi_898_ = (_e537 >= (1f - _e539));
                }
                let _e544 = phi_898_;
                if ((bitcast<u32>(_e537) & 2147483647u) > 2139095040u) {
                    phi_906_ = true;
                } else {
                    phi_906_ = !(_e544);
                }
                let _e550 = phi_906_;
                if _e550 {
                    if (_e537 > 0f) {
                        if (_e537 < 1f) {
                            phi_918_ = false;
                        } else {
                            phi_918_ = true;
                        }
                        let _e554 = phi_918_;
                        phi_919_ = _e554;
                    } else {
                        phi_919_ = true;
                    }
                    let _e556 = phi_919_;
                    if _e556 {
                        phi_923_ = 0.5f;
                    } else {
                        phi_923_ = _e537;
                    }
                    let _e558 = phi_923_;
                    phi_931_ = evaluate_Verdict(_e558, true);
                } else {
                    if (_e537 > 0.5f) {
                        phi_929_ = 1f;
                    } else {
                        phi_929_ = 0f;
                    }
                    let _e562 = phi_929_;
                    phi_931_ = evaluate_Verdict(_e562, false);
                }
                let _e565 = phi_931_;
                phi_936_ = evaluate_Verdict(_e565.visibility, _e565.is_doubted);
            } else {
                phi_936_ = evaluate_Verdict(0.5f, true);
            }
            let _e571 = phi_936_;
            phi_937_ = _e571;
        }
        let _e573 = phi_937_;
        if (_e51.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e51.first_primitive)] = _e573.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
