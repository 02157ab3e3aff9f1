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

struct type_30 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

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
        let _e47 = phi_130_;
        let _e49 = phi_131_;
        phi_132_ = _e47;
        phi_133_ = _e49;
    } else {
        phi_132_ = lt_bvh_traverse_Tree();
        phi_133_ = true;
    }
    let _e51 = phi_132_;
    let _e53 = phi_133_;
    if _e53 {
        phi_138_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_138_ = _e51;
    }
    let _e58 = phi_138_;
    return lt_bvh_traverse_Tree(_e58.root, _e58.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_161_: f32;
    var phi_162_: f32;
    var phi_163_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_163_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_162_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_161_ = 1f;
            } else {
                phi_161_ = param_4;
            }
            let _e41 = phi_161_;
            phi_162_ = _e41;
        }
        let _e43 = phi_162_;
        phi_163_ = _e43;
    }
    let _e45 = phi_163_;
    let _e46 = (_e45 * _e45);
    return vec4<f32>(_e45, _e46, (_e46 * _e45), (_e46 * _e46));
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_218_: bool;
    var phi_240_: f32;
    var phi_241_: f32;
    var phi_242_: f32;
    var phi_243_: f32;
    var phi_244_: bool;
    var phi_245_: f32;
    var phi_246_: bool;
    var phi_284_: vec2<f32>;
    var phi_318_: f32;
    var phi_319_: f32;
    var phi_320_: f32;
    var phi_349_: f32;
    var phi_350_: f32;
    var phi_351_: f32;
    var phi_355_: f32;
    var phi_356_: f32;
    var phi_357_: f32;
    var phi_358_: f32;

    let _e37 = (*param_5);
    let _e38 = (1f - _e37);
    let _e47 = (0.5f * _e37);
    let _e48 = ((param_6.x * _e38) + _e47);
    let _e49 = ((param_6.y * _e38) + _e47);
    let _e51 = ((param_6.w * _e38) + _e47);
    let _e53 = (_e49 - (_e48 * _e48));
    let _e55 = (((param_6.z * _e38) + _e47) - (_e48 * _e49));
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_212_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_211_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_210_ = 1f;
            } else {
                phi_210_ = param_7;
            }
            let _e67 = phi_210_;
            phi_211_ = _e67;
        }
        let _e69 = phi_211_;
        phi_212_ = _e69;
    }
    let _e71 = phi_212_;
    if (_e48 == _e51) {
        phi_218_ = (_e48 > 0.5f);
    } else {
        phi_218_ = false;
    }
    let _e75 = phi_218_;
    if _e75 {
        if (_e71 > 0f) {
            if ((bitcast<u32>(_e48) & 2147483647u) > 2139095040u) {
                phi_242_ = _e48;
            } else {
                if (_e48 < 0f) {
                    phi_241_ = 0f;
                } else {
                    if (_e48 > 1f) {
                        phi_240_ = 1f;
                    } else {
                        phi_240_ = _e48;
                    }
                    let _e83 = phi_240_;
                    phi_241_ = _e83;
                }
                let _e85 = phi_241_;
                phi_242_ = _e85;
            }
            let _e87 = phi_242_;
            phi_243_ = _e87;
            phi_244_ = false;
        } else {
            phi_243_ = f32();
            phi_244_ = true;
        }
        let _e89 = phi_243_;
        let _e91 = phi_244_;
        phi_245_ = _e89;
        phi_246_ = _e91;
    } else {
        phi_245_ = f32();
        phi_246_ = true;
    }
    let _e93 = phi_245_;
    let _e95 = phi_246_;
    if _e95 {
        let _e96 = (_e55 / _e53);
        let _e97 = (_e71 - _e48);
        let _e103 = (((((_e71 * _e71) - _e49) - (_e96 * _e97)) * _e53) / (((_e51 - (_e49 * _e49)) * _e53) - (_e55 * _e55)));
        let _e106 = ((_e97 / _e53) - (_e96 * _e103));
        let _e112 = ((0.5f * _e106) / _e103);
        let _e115 = ((_e112 * _e112) - (((1f - (_e106 * _e48)) - (_e103 * _e49)) / _e103));
        if (_e115 >= 0f) {
            let _e117 = sqrt(_e115);
            phi_284_ = vec2<f32>((-(_e112) - _e117), (-(_e112) + _e117));
        } else {
            phi_284_ = vec2(bitcast<f32>((bitcast<u32>(_e115) | 2143289344u)));
        }
        let _e128 = phi_284_;
        if (_e71 <= _e128.x) {
            phi_357_ = 1f;
        } else {
            if (_e71 > _e128.y) {
                let _e141 = (((_e49 - (_e48 * (_e128.x + _e128.y))) + (_e128.x * _e128.y)) / ((_e71 - _e128.x) * (_e71 - _e128.y)));
                if ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u) {
                    phi_320_ = _e141;
                } else {
                    if (_e141 < 0f) {
                        phi_319_ = 0f;
                    } else {
                        if (_e141 > 1f) {
                            phi_318_ = 1f;
                        } else {
                            phi_318_ = _e141;
                        }
                        let _e148 = phi_318_;
                        phi_319_ = _e148;
                    }
                    let _e150 = phi_319_;
                    phi_320_ = _e150;
                }
                let _e152 = phi_320_;
                phi_356_ = _e152;
            } else {
                if (_e71 > _e128.x) {
                    let _e163 = (1f - (((_e49 - (_e48 * (_e71 + _e128.y))) + (_e71 * _e128.y)) / ((_e128.x - _e71) * (_e128.x - _e128.y))));
                    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
                        phi_351_ = _e163;
                    } else {
                        if (_e163 < 0f) {
                            phi_350_ = 0f;
                        } else {
                            if (_e163 > 1f) {
                                phi_349_ = 1f;
                            } else {
                                phi_349_ = _e163;
                            }
                            let _e170 = phi_349_;
                            phi_350_ = _e170;
                        }
                        let _e172 = phi_350_;
                        phi_351_ = _e172;
                    }
                    let _e174 = phi_351_;
                    phi_355_ = _e174;
                } else {
                    phi_355_ = bitcast<f32>((bitcast<u32>(_e128.x) | 2143289344u));
                }
                let _e179 = phi_355_;
                phi_356_ = _e179;
            }
            let _e181 = phi_356_;
            phi_357_ = _e181;
        }
        let _e183 = phi_357_;
        phi_358_ = _e183;
    } else {
        phi_358_ = _e93;
    }
    let _e185 = phi_358_;
    return _e185;
}

fn function_() {
    var local: f32;
    var phi_412_: bool;
    var phi_413_: bool;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_419_: bool;
    var phi_463_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_467_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_544_: bool;
    var phi_553_: bool;
    var phi_562_: bool;
    var phi_563_: bool;
    var phi_564_: bool;
    var phi_565_: bool;
    var phi_566_: bool;
    var phi_567_: bool;
    var phi_568_: bool;
    var phi_572_: bool;
    var phi_666_: f32;
    var phi_669_: f32;
    var phi_698_: f32;
    var phi_703_: f32;
    var phi_704_: bool;
    var phi_705_: f32;
    var phi_706_: bool;
    var phi_710_: f32;
    var phi_730_: f32;
    var phi_735_: f32;
    var phi_736_: bool;
    var phi_737_: f32;
    var phi_738_: bool;
    var phi_742_: f32;
    var phi_788_: i32;
    var phi_793_: i32;
    var phi_798_: i32;
    var phi_803_: i32;
    var phi_812_: i32;
    var phi_817_: i32;
    var phi_822_: i32;
    var phi_827_: i32;
    var phi_922_: bool;
    var phi_930_: bool;
    var phi_942_: bool;
    var phi_943_: bool;
    var phi_947_: f32;
    var phi_953_: f32;
    var phi_955_: evaluate_Verdict;
    var phi_960_: evaluate_Verdict;
    var phi_961_: evaluate_Verdict;

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
                phi_412_ = (_e73 == _e75);
                phi_413_ = false;
            } else {
                phi_412_ = bool();
                phi_413_ = true;
            }
            let _e78 = phi_412_;
            let _e80 = phi_413_;
            phi_414_ = _e78;
            phi_415_ = _e80;
        } else {
            phi_414_ = bool();
            phi_415_ = true;
        }
        let _e82 = phi_414_;
        let _e84 = phi_415_;
        if _e84 {
            phi_419_ = false;
        } else {
            phi_419_ = _e82;
        }
        let _e86 = phi_419_;
        if !(_e86) {
            let _e89 = samples.member[(0u + _e51.first_primitive)].normal;
            let _e91 = samples.member[(0u + _e51.first_primitive)].position;
            if ((((_e89.x * (_e60.x - (_e91.x * _e60.w))) + (_e89.y * (_e60.y - (_e91.y * _e60.w)))) + (_e89.z * (_e60.z - (_e91.z * _e60.w)))) > 0f) {
                let _e115 = samples.member[(0u + _e51.first_primitive)].flags;
                let _e123 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e123.unnamed.visibility, false), _e123.unnamed_1);
                phi_463_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e129.unnamed, ((_e115 & 1u) == 0u));
            } else {
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_463_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, true);
            }
            let _e149 = phi_463_;
            phi_467_ = _e149;
        } else {
            let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e155.unnamed.visibility, false), _e155.unnamed_1);
            phi_467_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e161.unnamed, true);
        }
        let _e166 = phi_467_;
        if _e166.unnamed_1 {
            phi_961_ = evaluate_Verdict(_e166.unnamed.visibility, _e166.unnamed.is_doubted);
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
                    phi_544_ = (_e205 <= 1f);
                } else {
                    phi_544_ = false;
                }
                let _e237 = phi_544_;
                if _e237 {
                    if (_e219 >= 0f) {
                        phi_553_ = (_e219 <= 1f);
                    } else {
                        phi_553_ = false;
                    }
                    let _e241 = phi_553_;
                    if _e241 {
                        if (_e232 >= 0f) {
                            phi_562_ = (_e232 <= 1f);
                        } else {
                            phi_562_ = false;
                        }
                        let _e245 = phi_562_;
                        phi_563_ = _e245;
                        phi_564_ = false;
                    } else {
                        phi_563_ = bool();
                        phi_564_ = true;
                    }
                    let _e247 = phi_563_;
                    let _e249 = phi_564_;
                    phi_565_ = _e247;
                    phi_566_ = _e249;
                } else {
                    phi_565_ = bool();
                    phi_566_ = true;
                }
                let _e251 = phi_565_;
                let _e253 = phi_566_;
                phi_567_ = _e251;
                phi_568_ = _e253;
            } else {
                phi_567_ = bool();
                phi_568_ = true;
            }
            let _e255 = phi_567_;
            let _e257 = phi_568_;
            if _e257 {
                phi_572_ = false;
            } else {
                phi_572_ = _e255;
            }
            let _e259 = phi_572_;
            if _e259 {
                if (0f > 0f) {
                    let _e262 = samples.member[(0u + _e51.first_primitive)].normal;
                    let _e264 = p.member.map_size;
                    let _e267 = p.member.projection.row_x;
                    let _e289 = p.member.projection.row_y;
                    let _e311 = p.member.projection.row_z;
                    let _e338 = ((abs(((((_e267.x * _e262.x) + (_e267.y * _e262.y)) + (_e267.z * _e262.z)) / (((_e267.x * _e267.x) + (_e267.y * _e267.y)) + (_e267.z * _e267.z)))) + abs(((((_e289.x * _e262.x) + (_e289.y * _e262.y)) + (_e289.z * _e262.z)) / (((_e289.x * _e289.x) + (_e289.y * _e289.y)) + (_e289.z * _e289.z))))) / (abs(((((_e311.x * _e262.x) + (_e311.y * _e262.y)) + (_e311.z * _e262.z)) / (((_e311.x * _e311.x) + (_e311.y * _e311.y)) + (_e311.z * _e311.z)))) * f32(_e264)));
                    if (_e338 < 0.002f) {
                        phi_666_ = _e338;
                    } else {
                        phi_666_ = 0.002f;
                    }
                    let _e341 = phi_666_;
                    phi_669_ = (_e232 - (0f * _e341));
                } else {
                    phi_669_ = _e232;
                }
                let _e345 = phi_669_;
                let _e347 = p.member.map_size;
                let _e348 = f32(_e347);
                let _e351 = ((_e205 * _e348) - 0.5f);
                let _e352 = ((_e219 * _e348) - 0.5f);
                if (_e351 > -8388608f) {
                    let _e364 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e364 > _e351) {
                        phi_698_ = 1f;
                    } else {
                        phi_698_ = 0f;
                    }
                    let _e367 = phi_698_;
                    if (_e351 < 8388608f) {
                        phi_703_ = (_e364 - _e367);
                        phi_704_ = false;
                    } else {
                        phi_703_ = f32();
                        phi_704_ = true;
                    }
                    let _e370 = phi_703_;
                    let _e372 = phi_704_;
                    phi_705_ = _e370;
                    phi_706_ = _e372;
                } else {
                    phi_705_ = f32();
                    phi_706_ = true;
                }
                let _e374 = phi_705_;
                let _e376 = phi_706_;
                if _e376 {
                    phi_710_ = _e351;
                } else {
                    phi_710_ = _e374;
                }
                let _e378 = phi_710_;
                if (_e352 > -8388608f) {
                    let _e390 = f32(select(0i, select(select(i32(_e352), i32(-2147483648), (_e352 < bitcast<f32>(3472883712u))), 2147483647i, (_e352 > bitcast<f32>(1325400063u))), (_e352 == _e352)));
                    if (_e390 > _e352) {
                        phi_730_ = 1f;
                    } else {
                        phi_730_ = 0f;
                    }
                    let _e393 = phi_730_;
                    if (_e352 < 8388608f) {
                        phi_735_ = (_e390 - _e393);
                        phi_736_ = false;
                    } else {
                        phi_735_ = f32();
                        phi_736_ = true;
                    }
                    let _e396 = phi_735_;
                    let _e398 = phi_736_;
                    phi_737_ = _e396;
                    phi_738_ = _e398;
                } else {
                    phi_737_ = f32();
                    phi_738_ = true;
                }
                let _e400 = phi_737_;
                let _e402 = phi_738_;
                if _e402 {
                    phi_742_ = _e352;
                } else {
                    phi_742_ = _e400;
                }
                let _e404 = phi_742_;
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
                    phi_788_ = _e415;
                } else {
                    phi_788_ = 0i;
                }
                let _e442 = phi_788_;
                if (_e424 > 0i) {
                    phi_793_ = _e424;
                } else {
                    phi_793_ = 0i;
                }
                let _e445 = phi_793_;
                if (_e442 < _e439) {
                    phi_798_ = _e442;
                } else {
                    phi_798_ = _e439;
                }
                let _e448 = phi_798_;
                if (_e445 < _e439) {
                    phi_803_ = _e445;
                } else {
                    phi_803_ = _e439;
                }
                let _e451 = phi_803_;
                let _e452 = bitcast<u32>(_e448);
                let _e454 = (_e415 + 1i);
                let _e455 = (_e424 + 1i);
                if (_e454 > 0i) {
                    phi_812_ = _e454;
                } else {
                    phi_812_ = 0i;
                }
                let _e458 = phi_812_;
                if (_e455 > 0i) {
                    phi_817_ = _e455;
                } else {
                    phi_817_ = 0i;
                }
                let _e461 = phi_817_;
                if (_e458 < _e439) {
                    phi_822_ = _e458;
                } else {
                    phi_822_ = _e439;
                }
                let _e464 = phi_822_;
                if (_e461 < _e439) {
                    phi_827_ = _e461;
                } else {
                    phi_827_ = _e439;
                }
                let _e467 = phi_827_;
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
                let _e483 = map.member[(0u + _e473)];
                if (_e474 < _e42) {
                } else {
                    return;
                }
                let _e487 = map.member[(0u + _e474)];
                if (_e475 < _e42) {
                } else {
                    return;
                }
                let _e491 = map.member[(0u + _e475)];
                let _e492 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e479);
                let _e493 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e483);
                let _e494 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e487);
                let _e495 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e491);
                let _e541 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e492.x * _e427) + (_e493.x * _e429)) + (_e494.x * _e431)) + (_e495.x * _e432)), ((((_e492.y * _e427) + (_e493.y * _e429)) + (_e494.y * _e431)) + (_e495.y * _e432)), ((((_e492.z * _e427) + (_e493.z * _e429)) + (_e494.z * _e431)) + (_e495.z * _e432)), ((((_e492.w * _e427) + (_e493.w * _e429)) + (_e494.w * _e431)) + (_e495.w * _e432))), _e345);
                let _e543 = p.member.epsilon;
                if (_e541 <= _e543) {
                    phi_922_ = true;
                } else {
                    phi_922_ = (_e541 >= (1f - _e543));
                }
                let _e548 = phi_922_;
                if ((bitcast<u32>(_e541) & 2147483647u) > 2139095040u) {
                    phi_930_ = true;
                } else {
                    phi_930_ = !(_e548);
                }
                let _e554 = phi_930_;
                if _e554 {
                    if (_e541 > 0f) {
                        if (_e541 < 1f) {
                            phi_942_ = false;
                        } else {
                            phi_942_ = true;
                        }
                        let _e558 = phi_942_;
                        phi_943_ = _e558;
                    } else {
                        phi_943_ = true;
                    }
                    let _e560 = phi_943_;
                    if _e560 {
                        phi_947_ = 0.5f;
                    } else {
                        phi_947_ = _e541;
                    }
                    let _e562 = phi_947_;
                    phi_955_ = evaluate_Verdict(_e562, true);
                } else {
                    if (_e541 > 0.5f) {
                        phi_953_ = 1f;
                    } else {
                        phi_953_ = 0f;
                    }
                    let _e566 = phi_953_;
                    phi_955_ = evaluate_Verdict(_e566, false);
                }
                let _e569 = phi_955_;
                phi_960_ = evaluate_Verdict(_e569.visibility, _e569.is_doubted);
            } else {
                phi_960_ = evaluate_Verdict(0.5f, true);
            }
            let _e575 = phi_960_;
            phi_961_ = _e575;
        }
        let _e577 = phi_961_;
        if (_e51.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e51.first_primitive)] = _e577.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
