struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct type_8 {
    member: array<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_22 {
    member: array<abi_Sample>,
}

struct type_26 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
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

struct type_35 {
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

struct type_42 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_22;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(2) 
var<storage> map: type_26;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_26;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_42;
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_137_: lt_bvh_traverse_Tree;
    var phi_138_: bool;
    var phi_139_: lt_bvh_traverse_Tree;
    var phi_140_: bool;
    var phi_145_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_137_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_138_ = false;
        } else {
            phi_137_ = lt_bvh_traverse_Tree();
            phi_138_ = true;
        }
        let _e49 = phi_137_;
        let _e51 = phi_138_;
        phi_139_ = _e49;
        phi_140_ = _e51;
    } else {
        phi_139_ = lt_bvh_traverse_Tree();
        phi_140_ = true;
    }
    let _e53 = phi_139_;
    let _e55 = phi_140_;
    if _e55 {
        phi_145_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_145_ = _e53;
    }
    let _e60 = phi_145_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_171_: f32;
    var phi_172_: f32;
    var phi_173_: f32;
    var phi_189_: f32;
    var phi_190_: f32;
    var phi_191_: f32;
    var phi_208_: f32;
    var phi_209_: f32;
    var phi_210_: f32;
    var phi_227_: f32;
    var phi_228_: f32;
    var phi_229_: f32;
    var phi_246_: f32;
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_297_: bool;
    var phi_301_: f32;
    var phi_302_: f32;
    var phi_314_: bool;
    var phi_321_: f32;
    var phi_336_: f32;
    var phi_337_: f32;
    var phi_338_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_173_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_172_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_171_ = 1f;
            } else {
                phi_171_ = param_7;
            }
            let _e46 = phi_171_;
            phi_172_ = _e46;
        }
        let _e48 = phi_172_;
        phi_173_ = _e48;
    }
    let _e50 = phi_173_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_191_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_190_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_189_ = 1f;
            } else {
                phi_189_ = param_5.x;
            }
            let _e58 = phi_189_;
            phi_190_ = _e58;
        }
        let _e60 = phi_190_;
        phi_191_ = _e60;
    }
    let _e62 = phi_191_;
    let _e63 = (_e62 - _e50);
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_210_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_209_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_208_ = 1f;
            } else {
                phi_208_ = param_5.y;
            }
            let _e71 = phi_208_;
            phi_209_ = _e71;
        }
        let _e73 = phi_209_;
        phi_210_ = _e73;
    }
    let _e75 = phi_210_;
    let _e76 = (_e75 - _e50);
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_229_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_228_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_227_ = 1f;
            } else {
                phi_227_ = param_5.z;
            }
            let _e84 = phi_227_;
            phi_228_ = _e84;
        }
        let _e86 = phi_228_;
        phi_229_ = _e86;
    }
    let _e88 = phi_229_;
    let _e89 = (_e88 - _e50);
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_248_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_247_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_246_ = 1f;
            } else {
                phi_246_ = param_5.w;
            }
            let _e97 = phi_246_;
            phi_247_ = _e97;
        }
        let _e99 = phi_247_;
        phi_248_ = _e99;
    }
    let _e101 = phi_248_;
    let _e102 = (_e101 - _e50);
    let _e103 = (*param_4);
    let _e114 = ((((_e63 * param_6.x) + (_e76 * param_6.y)) + (_e89 * param_6.z)) + (_e102 * param_6.w));
    let _e115 = (_e63 - _e114);
    let _e116 = (_e76 - _e114);
    let _e117 = (_e89 - _e114);
    let _e118 = (_e102 - _e114);
    let _e133 = (((((_e115 * _e115) * param_6.x) + ((_e116 * _e116) * param_6.y)) + ((_e117 * _e117) * param_6.z)) + ((_e118 * _e118) * param_6.w));
    if ((bitcast<u32>(_e133) & 2147483647u) > 2139095040u) {
        phi_302_ = _e133;
    } else {
        if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
            phi_297_ = true;
        } else {
            let _e140 = (_e103 > _e133);
            if _e140 {
            }
            phi_297_ = _e140;
        }
        let _e142 = phi_297_;
        if _e142 {
            phi_301_ = _e103;
        } else {
            phi_301_ = _e133;
        }
        let _e144 = phi_301_;
        phi_302_ = _e144;
    }
    let _e146 = phi_302_;
    let _e147 = -(_e114);
    if (_e147 <= 0f) {
        let _e151 = ((bitcast<u32>(_e146) & 2147483647u) > 2139095040u);
        if _e151 {
        }
        phi_314_ = _e151;
    } else {
        phi_314_ = true;
    }
    let _e153 = phi_314_;
    if _e153 {
        phi_321_ = (_e146 / (_e146 + (_e147 * _e147)));
    } else {
        phi_321_ = 1f;
    }
    let _e158 = phi_321_;
    if ((bitcast<u32>(_e158) & 2147483647u) > 2139095040u) {
        phi_338_ = _e158;
    } else {
        if (_e158 < 0f) {
            phi_337_ = 0f;
        } else {
            if (_e158 > 1f) {
                phi_336_ = 1f;
            } else {
                phi_336_ = _e158;
            }
            let _e165 = phi_336_;
            phi_337_ = _e165;
        }
        let _e167 = phi_337_;
        phi_338_ = _e167;
    }
    let _e169 = phi_338_;
    return _e169;
}

fn function_() {
    var local_1: f32;
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
    var phi_588_: f32;
    var phi_593_: f32;
    var phi_594_: bool;
    var phi_595_: f32;
    var phi_596_: bool;
    var phi_600_: f32;
    var phi_620_: f32;
    var phi_625_: f32;
    var phi_626_: bool;
    var phi_627_: f32;
    var phi_628_: bool;
    var phi_632_: f32;
    var phi_678_: i32;
    var phi_683_: i32;
    var phi_688_: i32;
    var phi_693_: i32;
    var phi_702_: i32;
    var phi_707_: i32;
    var phi_712_: i32;
    var phi_717_: i32;
    var phi_764_: bool;
    var phi_772_: bool;
    var phi_777_: f32;
    var phi_780_: evaluate_Verdict;
    var phi_781_: evaluate_Verdict;
    var phi_785_: bool;
    var phi_786_: u32;
    var phi_792_: u32;

    let _e37 = id_1;
    let _e38 = local_2;
    let _e43 = arrayLength((&map.member));
    if (_e38 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e37, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        let _e60 = p.member.light;
        let _e63 = samples.member[_e53.first_primitive].normal[0u];
        let _e65 = global[0u];
        if (_e63 == _e65) {
            let _e68 = samples.member[_e53.first_primitive].normal[1u];
            let _e70 = global[1u];
            if (_e68 == _e70) {
                let _e73 = samples.member[_e53.first_primitive].normal[2u];
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
            let _e89 = samples.member[_e53.first_primitive].normal;
            let _e91 = samples.member[_e53.first_primitive].position;
            if ((((_e89.x * (_e60.x - (_e91.x * _e60.w))) + (_e89.y * (_e60.y - (_e91.y * _e60.w)))) + (_e89.z * (_e60.z - (_e91.z * _e60.w)))) > 0f) {
                let _e115 = samples.member[_e53.first_primitive].flags;
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
            phi_781_ = evaluate_Verdict(_e166.unnamed.visibility, _e166.unnamed.is_doubted);
        } else {
            let _e174 = samples.member[_e53.first_primitive].position;
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
                let _e261 = p.member.map_size;
                let _e262 = f32(_e261);
                let _e265 = ((_e205 * _e262) - 0.5f);
                let _e266 = ((_e219 * _e262) - 0.5f);
                if (_e265 > -8388608f) {
                    let _e278 = f32(select(0i, select(select(i32(_e265), i32(-2147483648), (_e265 < bitcast<f32>(3472883712u))), 2147483647i, (_e265 > bitcast<f32>(1325400063u))), (_e265 == _e265)));
                    if (_e278 > _e265) {
                        phi_588_ = 1f;
                    } else {
                        phi_588_ = 0f;
                    }
                    let _e281 = phi_588_;
                    if (_e265 < 8388608f) {
                        phi_593_ = (_e278 - _e281);
                        phi_594_ = false;
                    } else {
                        phi_593_ = f32();
                        phi_594_ = true;
                    }
                    let _e284 = phi_593_;
                    let _e286 = phi_594_;
                    phi_595_ = _e284;
                    phi_596_ = _e286;
                } else {
                    phi_595_ = f32();
                    phi_596_ = true;
                }
                let _e288 = phi_595_;
                let _e290 = phi_596_;
                if _e290 {
                    phi_600_ = _e265;
                } else {
                    phi_600_ = _e288;
                }
                let _e292 = phi_600_;
                if (_e266 > -8388608f) {
                    let _e304 = f32(select(0i, select(select(i32(_e266), i32(-2147483648), (_e266 < bitcast<f32>(3472883712u))), 2147483647i, (_e266 > bitcast<f32>(1325400063u))), (_e266 == _e266)));
                    if (_e304 > _e266) {
                        phi_620_ = 1f;
                    } else {
                        phi_620_ = 0f;
                    }
                    let _e307 = phi_620_;
                    if (_e266 < 8388608f) {
                        phi_625_ = (_e304 - _e307);
                        phi_626_ = false;
                    } else {
                        phi_625_ = f32();
                        phi_626_ = true;
                    }
                    let _e310 = phi_625_;
                    let _e312 = phi_626_;
                    phi_627_ = _e310;
                    phi_628_ = _e312;
                } else {
                    phi_627_ = f32();
                    phi_628_ = true;
                }
                let _e314 = phi_627_;
                let _e316 = phi_628_;
                if _e316 {
                    phi_632_ = _e266;
                } else {
                    phi_632_ = _e314;
                }
                let _e318 = phi_632_;
                let _e319 = (_e265 - _e292);
                let _e320 = (_e266 - _e318);
                let _e329 = select(0i, select(select(i32(_e292), i32(-2147483648), (_e292 < bitcast<f32>(3472883712u))), 2147483647i, (_e292 > bitcast<f32>(1325400063u))), (_e292 == _e292));
                let _e338 = select(0i, select(select(i32(_e318), i32(-2147483648), (_e318 < bitcast<f32>(3472883712u))), 2147483647i, (_e318 > bitcast<f32>(1325400063u))), (_e318 == _e318));
                let _e349 = p.member.test;
                let _e350 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e349);
                let _e352 = p.member.map_size;
                local_1 = _e350;
                let _e354 = (bitcast<i32>(_e352) - 1i);
                if (_e329 > 0i) {
                    phi_678_ = _e329;
                } else {
                    phi_678_ = 0i;
                }
                let _e357 = phi_678_;
                if (_e338 > 0i) {
                    phi_683_ = _e338;
                } else {
                    phi_683_ = 0i;
                }
                let _e360 = phi_683_;
                if (_e357 < _e354) {
                    phi_688_ = _e357;
                } else {
                    phi_688_ = _e354;
                }
                let _e363 = phi_688_;
                if (_e360 < _e354) {
                    phi_693_ = _e360;
                } else {
                    phi_693_ = _e354;
                }
                let _e366 = phi_693_;
                let _e367 = bitcast<u32>(_e363);
                let _e369 = (_e329 + 1i);
                let _e370 = (_e338 + 1i);
                if (_e369 > 0i) {
                    phi_702_ = _e369;
                } else {
                    phi_702_ = 0i;
                }
                let _e373 = phi_702_;
                if (_e370 > 0i) {
                    phi_707_ = _e370;
                } else {
                    phi_707_ = 0i;
                }
                let _e376 = phi_707_;
                if (_e373 < _e354) {
                    phi_712_ = _e373;
                } else {
                    phi_712_ = _e354;
                }
                let _e379 = phi_712_;
                if (_e376 < _e354) {
                    phi_717_ = _e376;
                } else {
                    phi_717_ = _e354;
                }
                let _e382 = phi_717_;
                let _e383 = bitcast<u32>(_e379);
                let _e385 = (bitcast<u32>(_e366) * _e352);
                let _e386 = (bitcast<u32>(_e382) * _e352);
                let _e387 = (_e385 + _e367);
                let _e388 = (_e385 + _e383);
                let _e389 = (_e386 + _e367);
                let _e390 = (_e386 + _e383);
                if (_e387 < _e43) {
                } else {
                    return;
                }
                let _e394 = map.member[(0u + _e387)];
                if (_e388 < _e43) {
                } else {
                    return;
                }
                let _e398 = map.member[(0u + _e388)];
                if (_e389 < _e43) {
                } else {
                    return;
                }
                let _e402 = map.member[(0u + _e389)];
                if (_e390 < _e43) {
                } else {
                    return;
                }
                let _e406 = map.member[(0u + _e390)];
                let _e408 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e394, _e398, _e402, _e406), vec4<f32>(((1f - _e319) * (1f - _e320)), (_e319 * (1f - _e320)), ((1f - _e319) * _e320), (_e319 * _e320)), _e232);
                let _e410 = p.member.epsilon;
                if (_e408 <= _e410) {
                    phi_764_ = true;
                } else {
                    phi_764_ = (_e408 >= (1f - _e410));
                }
                let _e415 = phi_764_;
                if ((bitcast<u32>(_e408) & 2147483647u) > 2139095040u) {
                    phi_772_ = true;
                } else {
                    phi_772_ = !(_e415);
                }
                let _e421 = phi_772_;
                if (_e408 > 0.5f) {
                    phi_777_ = 1f;
                } else {
                    phi_777_ = 0f;
                }
                let _e424 = phi_777_;
                phi_780_ = evaluate_Verdict(_e424, _e421);
            } else {
                phi_780_ = evaluate_Verdict(1f, true);
            }
            let _e428 = phi_780_;
            phi_781_ = _e428;
        }
        let _e430 = phi_781_;
        visibility.member[_e53.first_primitive] = _e430.visibility;
        phi_785_ = _e430.is_doubted;
        phi_786_ = _e53.first_primitive;
    } else {
        phi_785_ = false;
        phi_786_ = 0u;
    }
    let _e435 = phi_785_;
    let _e437 = phi_786_;
    if _e435 {
        let _e439 = atomicAdd((&shared_[0u]), 1u);
        phi_792_ = _e439;
    } else {
        phi_792_ = 0u;
    }
    let _e441 = phi_792_;
    workgroupBarrier();
    if (_e38 == 0u) {
        let _e445 = atomicLoad((&shared_[0u]));
        let _e446 = atomicAdd((&list.member[3u]), _e445);
        atomicStore((&shared_[1u]), _e446);
    }
    workgroupBarrier();
    if _e435 {
        let _e449 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e449) + _e441)]), _e437);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
