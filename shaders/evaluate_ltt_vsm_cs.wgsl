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
    var phi_138_: lt_bvh_traverse_Tree;
    var phi_139_: bool;
    var phi_140_: lt_bvh_traverse_Tree;
    var phi_141_: bool;
    var phi_146_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_138_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_139_ = false;
        } else {
            phi_138_ = lt_bvh_traverse_Tree();
            phi_139_ = true;
        }
        let _e49 = phi_138_;
        let _e51 = phi_139_;
        phi_140_ = _e49;
        phi_141_ = _e51;
    } else {
        phi_140_ = lt_bvh_traverse_Tree();
        phi_141_ = true;
    }
    let _e53 = phi_140_;
    let _e55 = phi_141_;
    if _e55 {
        phi_146_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_146_ = _e53;
    }
    let _e60 = phi_146_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_172_: f32;
    var phi_173_: f32;
    var phi_174_: f32;
    var phi_190_: f32;
    var phi_191_: f32;
    var phi_192_: f32;
    var phi_208_: f32;
    var phi_209_: f32;
    var phi_210_: f32;
    var phi_226_: f32;
    var phi_227_: f32;
    var phi_228_: f32;
    var phi_244_: f32;
    var phi_245_: f32;
    var phi_246_: f32;
    var phi_292_: bool;
    var phi_296_: f32;
    var phi_308_: bool;
    var phi_315_: f32;
    var phi_330_: f32;
    var phi_331_: f32;
    var phi_332_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_174_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_173_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_172_ = 1f;
            } else {
                phi_172_ = param_7;
            }
            let _e46 = phi_172_;
            phi_173_ = _e46;
        }
        let _e48 = phi_173_;
        phi_174_ = _e48;
    }
    let _e50 = phi_174_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_192_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_191_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_190_ = 1f;
            } else {
                phi_190_ = param_5.x;
            }
            let _e58 = phi_190_;
            phi_191_ = _e58;
        }
        let _e60 = phi_191_;
        phi_192_ = _e60;
    }
    let _e62 = phi_192_;
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
            let _e70 = phi_208_;
            phi_209_ = _e70;
        }
        let _e72 = phi_209_;
        phi_210_ = _e72;
    }
    let _e74 = phi_210_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_228_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_227_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_226_ = 1f;
            } else {
                phi_226_ = param_5.z;
            }
            let _e82 = phi_226_;
            phi_227_ = _e82;
        }
        let _e84 = phi_227_;
        phi_228_ = _e84;
    }
    let _e86 = phi_228_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_246_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_245_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_244_ = 1f;
            } else {
                phi_244_ = param_5.w;
            }
            let _e94 = phi_244_;
            phi_245_ = _e94;
        }
        let _e96 = phi_245_;
        phi_246_ = _e96;
    }
    let _e98 = phi_246_;
    let _e99 = (_e62 - _e50);
    let _e100 = (_e74 - _e50);
    let _e101 = (_e86 - _e50);
    let _e102 = (_e98 - _e50);
    let _e103 = (*param_4);
    let _e114 = ((((_e99 * param_6.x) + (_e100 * param_6.y)) + (_e101 * param_6.z)) + (_e102 * param_6.w));
    let _e115 = (_e99 - _e114);
    let _e116 = (_e100 - _e114);
    let _e117 = (_e101 - _e114);
    let _e118 = (_e102 - _e114);
    let _e133 = (((((_e115 * _e115) * param_6.x) + ((_e116 * _e116) * param_6.y)) + ((_e117 * _e117) * param_6.z)) + ((_e118 * _e118) * param_6.w));
    if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
        phi_292_ = true;
    } else {
        let _e137 = (_e103 > _e133);
        if _e137 {
        }
        phi_292_ = _e137;
    }
    let _e139 = phi_292_;
    if _e139 {
        phi_296_ = _e103;
    } else {
        phi_296_ = _e133;
    }
    let _e141 = phi_296_;
    let _e142 = -(_e114);
    if (_e142 <= 0f) {
        let _e146 = ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u);
        if _e146 {
        }
        phi_308_ = _e146;
    } else {
        phi_308_ = true;
    }
    let _e148 = phi_308_;
    if _e148 {
        phi_315_ = (_e141 / (_e141 + (_e142 * _e142)));
    } else {
        phi_315_ = 1f;
    }
    let _e153 = phi_315_;
    if ((bitcast<u32>(_e153) & 2147483647u) > 2139095040u) {
        phi_332_ = _e153;
    } else {
        if (_e153 < 0f) {
            phi_331_ = 0f;
        } else {
            if (_e153 > 1f) {
                phi_330_ = 1f;
            } else {
                phi_330_ = _e153;
            }
            let _e160 = phi_330_;
            phi_331_ = _e160;
        }
        let _e162 = phi_331_;
        phi_332_ = _e162;
    }
    let _e164 = phi_332_;
    return _e164;
}

fn function_() {
    var local_1: f32;
    var phi_386_: bool;
    var phi_387_: bool;
    var phi_388_: bool;
    var phi_389_: bool;
    var phi_393_: bool;
    var phi_437_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_441_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_518_: bool;
    var phi_527_: bool;
    var phi_536_: bool;
    var phi_537_: bool;
    var phi_538_: bool;
    var phi_539_: bool;
    var phi_540_: bool;
    var phi_541_: bool;
    var phi_542_: bool;
    var phi_546_: bool;
    var phi_582_: f32;
    var phi_587_: f32;
    var phi_588_: bool;
    var phi_589_: f32;
    var phi_590_: bool;
    var phi_594_: f32;
    var phi_614_: f32;
    var phi_619_: f32;
    var phi_620_: bool;
    var phi_621_: f32;
    var phi_622_: bool;
    var phi_626_: f32;
    var phi_672_: i32;
    var phi_677_: i32;
    var phi_682_: i32;
    var phi_687_: i32;
    var phi_696_: i32;
    var phi_701_: i32;
    var phi_706_: i32;
    var phi_711_: i32;
    var phi_758_: bool;
    var phi_766_: bool;
    var phi_771_: f32;
    var phi_774_: evaluate_Verdict;
    var phi_775_: evaluate_Verdict;
    var phi_779_: bool;
    var phi_780_: u32;
    var phi_786_: u32;

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
                phi_386_ = (_e73 == _e75);
                phi_387_ = false;
            } else {
                phi_386_ = bool();
                phi_387_ = true;
            }
            let _e78 = phi_386_;
            let _e80 = phi_387_;
            phi_388_ = _e78;
            phi_389_ = _e80;
        } else {
            phi_388_ = bool();
            phi_389_ = true;
        }
        let _e82 = phi_388_;
        let _e84 = phi_389_;
        if _e84 {
            phi_393_ = false;
        } else {
            phi_393_ = _e82;
        }
        let _e86 = phi_393_;
        if !(_e86) {
            let _e89 = samples.member[_e53.first_primitive].normal;
            let _e91 = samples.member[_e53.first_primitive].position;
            if ((((_e89.x * (_e60.x - (_e91.x * _e60.w))) + (_e89.y * (_e60.y - (_e91.y * _e60.w)))) + (_e89.z * (_e60.z - (_e91.z * _e60.w)))) > 0f) {
                let _e115 = samples.member[_e53.first_primitive].flags;
                let _e123 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e123.unnamed.visibility, false), _e123.unnamed_1);
                phi_437_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e129.unnamed, ((_e115 & 1u) == 0u));
            } else {
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_437_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, true);
            }
            let _e149 = phi_437_;
            phi_441_ = _e149;
        } else {
            let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e155.unnamed.visibility, false), _e155.unnamed_1);
            phi_441_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e161.unnamed, true);
        }
        let _e166 = phi_441_;
        if _e166.unnamed_1 {
            phi_775_ = evaluate_Verdict(_e166.unnamed.visibility, _e166.unnamed.is_doubted);
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
                    phi_518_ = (_e205 <= 1f);
                } else {
                    phi_518_ = false;
                }
                let _e237 = phi_518_;
                if _e237 {
                    if (_e219 >= 0f) {
                        phi_527_ = (_e219 <= 1f);
                    } else {
                        phi_527_ = false;
                    }
                    let _e241 = phi_527_;
                    if _e241 {
                        if (_e232 >= 0f) {
                            phi_536_ = (_e232 <= 1f);
                        } else {
                            phi_536_ = false;
                        }
                        let _e245 = phi_536_;
                        phi_537_ = _e245;
                        phi_538_ = false;
                    } else {
                        phi_537_ = bool();
                        phi_538_ = true;
                    }
                    let _e247 = phi_537_;
                    let _e249 = phi_538_;
                    phi_539_ = _e247;
                    phi_540_ = _e249;
                } else {
                    phi_539_ = bool();
                    phi_540_ = true;
                }
                let _e251 = phi_539_;
                let _e253 = phi_540_;
                phi_541_ = _e251;
                phi_542_ = _e253;
            } else {
                phi_541_ = bool();
                phi_542_ = true;
            }
            let _e255 = phi_541_;
            let _e257 = phi_542_;
            if _e257 {
                phi_546_ = false;
            } else {
                phi_546_ = _e255;
            }
            let _e259 = phi_546_;
            if _e259 {
                let _e261 = p.member.map_size;
                let _e262 = f32(_e261);
                let _e265 = ((_e205 * _e262) - 0.5f);
                let _e266 = ((_e219 * _e262) - 0.5f);
                if (_e265 > -8388608f) {
                    let _e278 = f32(select(0i, select(select(i32(_e265), i32(-2147483648), (_e265 < bitcast<f32>(3472883712u))), 2147483647i, (_e265 > bitcast<f32>(1325400063u))), (_e265 == _e265)));
                    if (_e278 > _e265) {
                        phi_582_ = 1f;
                    } else {
                        phi_582_ = 0f;
                    }
                    let _e281 = phi_582_;
                    if (_e265 < 8388608f) {
                        phi_587_ = (_e278 - _e281);
                        phi_588_ = false;
                    } else {
                        phi_587_ = f32();
                        phi_588_ = true;
                    }
                    let _e284 = phi_587_;
                    let _e286 = phi_588_;
                    phi_589_ = _e284;
                    phi_590_ = _e286;
                } else {
                    phi_589_ = f32();
                    phi_590_ = true;
                }
                let _e288 = phi_589_;
                let _e290 = phi_590_;
                if _e290 {
                    phi_594_ = _e265;
                } else {
                    phi_594_ = _e288;
                }
                let _e292 = phi_594_;
                if (_e266 > -8388608f) {
                    let _e304 = f32(select(0i, select(select(i32(_e266), i32(-2147483648), (_e266 < bitcast<f32>(3472883712u))), 2147483647i, (_e266 > bitcast<f32>(1325400063u))), (_e266 == _e266)));
                    if (_e304 > _e266) {
                        phi_614_ = 1f;
                    } else {
                        phi_614_ = 0f;
                    }
                    let _e307 = phi_614_;
                    if (_e266 < 8388608f) {
                        phi_619_ = (_e304 - _e307);
                        phi_620_ = false;
                    } else {
                        phi_619_ = f32();
                        phi_620_ = true;
                    }
                    let _e310 = phi_619_;
                    let _e312 = phi_620_;
                    phi_621_ = _e310;
                    phi_622_ = _e312;
                } else {
                    phi_621_ = f32();
                    phi_622_ = true;
                }
                let _e314 = phi_621_;
                let _e316 = phi_622_;
                if _e316 {
                    phi_626_ = _e266;
                } else {
                    phi_626_ = _e314;
                }
                let _e318 = phi_626_;
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
                    phi_672_ = _e329;
                } else {
                    phi_672_ = 0i;
                }
                let _e357 = phi_672_;
                if (_e338 > 0i) {
                    phi_677_ = _e338;
                } else {
                    phi_677_ = 0i;
                }
                let _e360 = phi_677_;
                if (_e357 < _e354) {
                    phi_682_ = _e357;
                } else {
                    phi_682_ = _e354;
                }
                let _e363 = phi_682_;
                if (_e360 < _e354) {
                    phi_687_ = _e360;
                } else {
                    phi_687_ = _e354;
                }
                let _e366 = phi_687_;
                let _e367 = bitcast<u32>(_e363);
                let _e369 = (_e329 + 1i);
                let _e370 = (_e338 + 1i);
                if (_e369 > 0i) {
                    phi_696_ = _e369;
                } else {
                    phi_696_ = 0i;
                }
                let _e373 = phi_696_;
                if (_e370 > 0i) {
                    phi_701_ = _e370;
                } else {
                    phi_701_ = 0i;
                }
                let _e376 = phi_701_;
                if (_e373 < _e354) {
                    phi_706_ = _e373;
                } else {
                    phi_706_ = _e354;
                }
                let _e379 = phi_706_;
                if (_e376 < _e354) {
                    phi_711_ = _e376;
                } else {
                    phi_711_ = _e354;
                }
                let _e382 = phi_711_;
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
                    phi_758_ = true;
                } else {
                    phi_758_ = (_e408 >= (1f - _e410));
                }
                let _e415 = phi_758_;
                if ((bitcast<u32>(_e408) & 2147483647u) > 2139095040u) {
                    phi_766_ = true;
                } else {
                    phi_766_ = !(_e415);
                }
                let _e421 = phi_766_;
                if (_e408 > 0.5f) {
                    phi_771_ = 1f;
                } else {
                    phi_771_ = 0f;
                }
                let _e424 = phi_771_;
                phi_774_ = evaluate_Verdict(_e424, _e421);
            } else {
                phi_774_ = evaluate_Verdict(1f, true);
            }
            let _e428 = phi_774_;
            phi_775_ = _e428;
        }
        let _e430 = phi_775_;
        visibility.member[_e53.first_primitive] = _e430.visibility;
        phi_779_ = _e430.is_doubted;
        phi_780_ = _e53.first_primitive;
    } else {
        phi_779_ = false;
        phi_780_ = 0u;
    }
    let _e435 = phi_779_;
    let _e437 = phi_780_;
    if _e435 {
        let _e439 = atomicAdd((&shared_[0u]), 1u);
        phi_786_ = _e439;
    } else {
        phi_786_ = 0u;
    }
    let _e441 = phi_786_;
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
