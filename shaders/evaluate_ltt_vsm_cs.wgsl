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

struct type_24 {
    member: array<abi_Sample>,
}

struct type_28 {
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

struct type_36 {
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

struct type_43 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_24;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_36;
@group(0) @binding(2) 
var<storage> map: type_28;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_28;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_43;
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_141_: lt_bvh_traverse_Tree;
    var phi_142_: bool;
    var phi_143_: lt_bvh_traverse_Tree;
    var phi_144_: bool;
    var phi_149_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_141_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_142_ = false;
        } else {
            phi_141_ = lt_bvh_traverse_Tree();
            phi_142_ = true;
        }
        let _e46 = phi_141_;
        let _e48 = phi_142_;
        phi_143_ = _e46;
        phi_144_ = _e48;
    } else {
        phi_143_ = lt_bvh_traverse_Tree();
        phi_144_ = true;
    }
    let _e50 = phi_143_;
    let _e52 = phi_144_;
    if _e52 {
        phi_149_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_149_ = _e50;
    }
    let _e57 = phi_149_;
    return lt_bvh_traverse_Tree(_e57.root, _e57.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_to_light(param_4: vec3<f32>, param_5: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_5.x - (param_4.x * param_5.w)), (param_5.y - (param_4.y * param_5.w)), (param_5.z - (param_4.z * param_5.w)));
}

fn lt_shaders_evaluate_quad_indices(param_6: i32, param_7: i32, param_8: u32) -> array<u32, 4> {
    var phi_183_: i32;
    var phi_188_: i32;
    var phi_193_: i32;
    var phi_198_: i32;
    var phi_207_: i32;
    var phi_212_: i32;
    var phi_217_: i32;
    var phi_222_: i32;

    let _e37 = (bitcast<i32>(param_8) - 1i);
    if (param_6 > 0i) {
        phi_183_ = param_6;
    } else {
        phi_183_ = 0i;
    }
    let _e40 = phi_183_;
    if (param_7 > 0i) {
        phi_188_ = param_7;
    } else {
        phi_188_ = 0i;
    }
    let _e43 = phi_188_;
    if (_e40 < _e37) {
        phi_193_ = _e40;
    } else {
        phi_193_ = _e37;
    }
    let _e46 = phi_193_;
    if (_e43 < _e37) {
        phi_198_ = _e43;
    } else {
        phi_198_ = _e37;
    }
    let _e49 = phi_198_;
    let _e50 = bitcast<u32>(_e46);
    let _e52 = (param_6 + 1i);
    let _e53 = (param_7 + 1i);
    if (_e52 > 0i) {
        phi_207_ = _e52;
    } else {
        phi_207_ = 0i;
    }
    let _e56 = phi_207_;
    if (_e53 > 0i) {
        phi_212_ = _e53;
    } else {
        phi_212_ = 0i;
    }
    let _e59 = phi_212_;
    if (_e56 < _e37) {
        phi_217_ = _e56;
    } else {
        phi_217_ = _e37;
    }
    let _e62 = phi_217_;
    if (_e59 < _e37) {
        phi_222_ = _e59;
    } else {
        phi_222_ = _e37;
    }
    let _e65 = phi_222_;
    let _e66 = bitcast<u32>(_e62);
    let _e68 = (bitcast<u32>(_e49) * param_8);
    let _e69 = (bitcast<u32>(_e65) * param_8);
    return array<u32, 4>((_e68 + _e50), (_e68 + _e66), (_e69 + _e50), (_e69 + _e66));
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_9: ptr<function, f32>, param_10: vec4<f32>, param_11: vec4<f32>, param_12: f32) -> f32 {
    var phi_251_: f32;
    var phi_252_: f32;
    var phi_253_: f32;
    var phi_269_: f32;
    var phi_270_: f32;
    var phi_271_: f32;
    var phi_288_: f32;
    var phi_289_: f32;
    var phi_290_: f32;
    var phi_307_: f32;
    var phi_308_: f32;
    var phi_309_: f32;
    var phi_326_: f32;
    var phi_327_: f32;
    var phi_328_: f32;
    var phi_377_: bool;
    var phi_381_: f32;
    var phi_382_: f32;
    var phi_394_: bool;
    var phi_401_: f32;
    var phi_416_: f32;
    var phi_417_: f32;
    var phi_418_: f32;

    if ((bitcast<u32>(param_12) & 2147483647u) > 2139095040u) {
        phi_253_ = param_12;
    } else {
        if (param_12 < 0f) {
            phi_252_ = 0f;
        } else {
            if (param_12 > 1f) {
                phi_251_ = 1f;
            } else {
                phi_251_ = param_12;
            }
            let _e43 = phi_251_;
            phi_252_ = _e43;
        }
        let _e45 = phi_252_;
        phi_253_ = _e45;
    }
    let _e47 = phi_253_;
    if ((bitcast<u32>(param_10.x) & 2147483647u) > 2139095040u) {
        phi_271_ = param_10.x;
    } else {
        if (param_10.x < 0f) {
            phi_270_ = 0f;
        } else {
            if (param_10.x > 1f) {
                phi_269_ = 1f;
            } else {
                phi_269_ = param_10.x;
            }
            let _e55 = phi_269_;
            phi_270_ = _e55;
        }
        let _e57 = phi_270_;
        phi_271_ = _e57;
    }
    let _e59 = phi_271_;
    let _e60 = (_e59 - _e47);
    if ((bitcast<u32>(param_10.y) & 2147483647u) > 2139095040u) {
        phi_290_ = param_10.y;
    } else {
        if (param_10.y < 0f) {
            phi_289_ = 0f;
        } else {
            if (param_10.y > 1f) {
                phi_288_ = 1f;
            } else {
                phi_288_ = param_10.y;
            }
            let _e68 = phi_288_;
            phi_289_ = _e68;
        }
        let _e70 = phi_289_;
        phi_290_ = _e70;
    }
    let _e72 = phi_290_;
    let _e73 = (_e72 - _e47);
    if ((bitcast<u32>(param_10.z) & 2147483647u) > 2139095040u) {
        phi_309_ = param_10.z;
    } else {
        if (param_10.z < 0f) {
            phi_308_ = 0f;
        } else {
            if (param_10.z > 1f) {
                phi_307_ = 1f;
            } else {
                phi_307_ = param_10.z;
            }
            let _e81 = phi_307_;
            phi_308_ = _e81;
        }
        let _e83 = phi_308_;
        phi_309_ = _e83;
    }
    let _e85 = phi_309_;
    let _e86 = (_e85 - _e47);
    if ((bitcast<u32>(param_10.w) & 2147483647u) > 2139095040u) {
        phi_328_ = param_10.w;
    } else {
        if (param_10.w < 0f) {
            phi_327_ = 0f;
        } else {
            if (param_10.w > 1f) {
                phi_326_ = 1f;
            } else {
                phi_326_ = param_10.w;
            }
            let _e94 = phi_326_;
            phi_327_ = _e94;
        }
        let _e96 = phi_327_;
        phi_328_ = _e96;
    }
    let _e98 = phi_328_;
    let _e99 = (_e98 - _e47);
    let _e100 = (*param_9);
    let _e111 = ((((_e60 * param_11.x) + (_e73 * param_11.y)) + (_e86 * param_11.z)) + (_e99 * param_11.w));
    let _e112 = (_e60 - _e111);
    let _e113 = (_e73 - _e111);
    let _e114 = (_e86 - _e111);
    let _e115 = (_e99 - _e111);
    let _e130 = (((((_e112 * _e112) * param_11.x) + ((_e113 * _e113) * param_11.y)) + ((_e114 * _e114) * param_11.z)) + ((_e115 * _e115) * param_11.w));
    if ((bitcast<u32>(_e130) & 2147483647u) > 2139095040u) {
        phi_382_ = _e130;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_377_ = true;
        } else {
            let _e137 = (_e100 > _e130);
            if _e137 {
            }
            phi_377_ = _e137;
        }
        let _e139 = phi_377_;
        if _e139 {
            phi_381_ = _e100;
        } else {
            phi_381_ = _e130;
        }
        let _e141 = phi_381_;
        phi_382_ = _e141;
    }
    let _e143 = phi_382_;
    let _e144 = -(_e111);
    if (_e144 <= 0f) {
        let _e148 = ((bitcast<u32>(_e143) & 2147483647u) > 2139095040u);
        if _e148 {
        }
        phi_394_ = _e148;
    } else {
        phi_394_ = true;
    }
    let _e150 = phi_394_;
    if _e150 {
        phi_401_ = (_e143 / (_e143 + (_e144 * _e144)));
    } else {
        phi_401_ = 1f;
    }
    let _e155 = phi_401_;
    if ((bitcast<u32>(_e155) & 2147483647u) > 2139095040u) {
        phi_418_ = _e155;
    } else {
        if (_e155 < 0f) {
            phi_417_ = 0f;
        } else {
            if (_e155 > 1f) {
                phi_416_ = 1f;
            } else {
                phi_416_ = _e155;
            }
            let _e162 = phi_416_;
            phi_417_ = _e162;
        }
        let _e164 = phi_417_;
        phi_418_ = _e164;
    }
    let _e166 = phi_418_;
    return _e166;
}

fn function_() {
    var local_1: f32;
    var phi_472_: bool;
    var phi_473_: bool;
    var phi_474_: bool;
    var phi_475_: bool;
    var phi_479_: bool;
    var phi_514_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_518_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_611_: bool;
    var phi_612_: bool;
    var phi_613_: bool;
    var phi_614_: bool;
    var phi_615_: bool;
    var phi_616_: bool;
    var phi_617_: bool;
    var phi_618_: bool;
    var phi_619_: bool;
    var phi_620_: bool;
    var phi_621_: bool;
    var phi_622_: bool;
    var phi_626_: bool;
    var phi_727_: bool;
    var phi_735_: bool;
    var phi_740_: f32;
    var phi_743_: evaluate_Verdict;
    var phi_744_: evaluate_Verdict;
    var phi_748_: bool;
    var phi_749_: u32;
    var phi_755_: u32;

    let _e34 = id_1;
    let _e35 = local_2;
    let _e40 = arrayLength((&map.member));
    if (_e35 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e47 = p.member.size[0u];
    let _e49 = p.member.size[1u];
    let _e50 = lt_shaders_entry_pixel_index(_e34, _e47, _e49);
    if (bitcast<i32>(_e50.root) != 0i) {
        let _e57 = p.member.light;
        let _e60 = samples.member[_e50.first_primitive].normal[0u];
        let _e62 = global[0u];
        if (_e60 == _e62) {
            let _e65 = samples.member[_e50.first_primitive].normal[1u];
            let _e67 = global[1u];
            if (_e65 == _e67) {
                let _e70 = samples.member[_e50.first_primitive].normal[2u];
                let _e72 = global[2u];
                phi_472_ = (_e70 == _e72);
                phi_473_ = false;
            } else {
                phi_472_ = bool();
                phi_473_ = true;
            }
            let _e75 = phi_472_;
            let _e77 = phi_473_;
            phi_474_ = _e75;
            phi_475_ = _e77;
        } else {
            phi_474_ = bool();
            phi_475_ = true;
        }
        let _e79 = phi_474_;
        let _e81 = phi_475_;
        if _e81 {
            phi_479_ = false;
        } else {
            phi_479_ = _e79;
        }
        let _e83 = phi_479_;
        if !(_e83) {
            let _e86 = samples.member[_e50.first_primitive].normal;
            let _e88 = samples.member[_e50.first_primitive].position;
            let _e89 = lt_shaders_evaluate_to_light(_e88, _e57);
            if ((((_e86.x * _e89.x) + (_e86.y * _e89.y)) + (_e86.z * _e89.z)) > 0f) {
                let _e103 = samples.member[_e50.first_primitive].flags;
                let _e111 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e117 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e111.unnamed.visibility, false), _e111.unnamed_1);
                phi_514_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e117.unnamed, ((_e103 & 1u) == 0u));
            } else {
                let _e126 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e132 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e126.unnamed.visibility, false), _e126.unnamed_1);
                phi_514_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e132.unnamed, true);
            }
            let _e137 = phi_514_;
            phi_518_ = _e137;
        } else {
            let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e149 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e143.unnamed.visibility, false), _e143.unnamed_1);
            phi_518_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e149.unnamed, true);
        }
        let _e154 = phi_518_;
        if _e154.unnamed_1 {
            phi_744_ = evaluate_Verdict(_e154.unnamed.visibility, _e154.unnamed.is_doubted);
        } else {
            let _e162 = samples.member[_e50.first_primitive].position;
            let _e168 = p.member.projection.row_w;
            let _e179 = ((((_e168.x * _e162.x) + (_e168.y * _e162.y)) + (_e168.z * _e162.z)) + (_e168.w * 1f));
            let _e181 = p.member.projection.row_x;
            let _e193 = (((((_e181.x * _e162.x) + (_e181.y * _e162.y)) + (_e181.z * _e162.z)) + (_e181.w * 1f)) / _e179);
            let _e195 = p.member.projection.row_y;
            let _e207 = (((((_e195.x * _e162.x) + (_e195.y * _e162.y)) + (_e195.z * _e162.z)) + (_e195.w * 1f)) / _e179);
            let _e209 = p.member.projection.row_z;
            let _e220 = ((((_e209.x * _e162.x) + (_e209.y * _e162.y)) + (_e209.z * _e162.z)) + (_e209.w * 1f));
            if (_e179 > 0f) {
                if (_e193 >= 0f) {
                    if (_e193 <= 1f) {
                        if (_e207 >= 0f) {
                            if (_e207 <= 1f) {
                                if (_e220 >= 0f) {
                                    phi_611_ = (_e220 <= 1f);
                                    phi_612_ = false;
                                } else {
                                    phi_611_ = bool();
                                    phi_612_ = true;
                                }
                                let _e229 = phi_611_;
                                let _e231 = phi_612_;
                                phi_613_ = _e229;
                                phi_614_ = _e231;
                            } else {
                                phi_613_ = bool();
                                phi_614_ = true;
                            }
                            let _e233 = phi_613_;
                            let _e235 = phi_614_;
                            phi_615_ = _e233;
                            phi_616_ = _e235;
                        } else {
                            phi_615_ = bool();
                            phi_616_ = true;
                        }
                        let _e237 = phi_615_;
                        let _e239 = phi_616_;
                        phi_617_ = _e237;
                        phi_618_ = _e239;
                    } else {
                        phi_617_ = bool();
                        phi_618_ = true;
                    }
                    let _e241 = phi_617_;
                    let _e243 = phi_618_;
                    phi_619_ = _e241;
                    phi_620_ = _e243;
                } else {
                    phi_619_ = bool();
                    phi_620_ = true;
                }
                let _e245 = phi_619_;
                let _e247 = phi_620_;
                phi_621_ = _e245;
                phi_622_ = _e247;
            } else {
                phi_621_ = bool();
                phi_622_ = true;
            }
            let _e249 = phi_621_;
            let _e251 = phi_622_;
            if _e251 {
                phi_626_ = false;
            } else {
                phi_626_ = _e249;
            }
            let _e253 = phi_626_;
            if _e253 {
                let _e255 = p.member.map_size;
                let _e256 = f32(_e255);
                let _e259 = ((_e193 * _e256) - 0.5f);
                let _e260 = ((_e207 * _e256) - 0.5f);
                let _e261 = floor(_e259);
                let _e262 = floor(_e260);
                let _e263 = (_e259 - _e261);
                let _e264 = (_e260 - _e262);
                let _e293 = p.member.test;
                let _e294 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e293);
                let _e296 = p.member.map_size;
                local_1 = _e294;
                let _e297 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e261), i32(-2147483648), (_e261 < bitcast<f32>(3472883712u))), 2147483647i, (_e261 > bitcast<f32>(1325400063u))), (_e261 == _e261)), select(0i, select(select(i32(_e262), i32(-2147483648), (_e262 < bitcast<f32>(3472883712u))), 2147483647i, (_e262 > bitcast<f32>(1325400063u))), (_e262 == _e262)), _e296);
                if (_e297[0] < _e40) {
                } else {
                    return;
                }
                let _e302 = map.member[(0u + _e297[0])];
                if (_e297[1] < _e40) {
                } else {
                    return;
                }
                let _e307 = map.member[(0u + _e297[1])];
                if (_e297[2] < _e40) {
                } else {
                    return;
                }
                let _e312 = map.member[(0u + _e297[2])];
                if (_e297[3] < _e40) {
                } else {
                    return;
                }
                let _e317 = map.member[(0u + _e297[3])];
                let _e319 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e302, _e307, _e312, _e317), vec4<f32>(((1f - _e263) * (1f - _e264)), (_e263 * (1f - _e264)), ((1f - _e263) * _e264), (_e263 * _e264)), _e220);
                let _e321 = p.member.epsilon;
                if (_e319 <= _e321) {
                    phi_727_ = true;
                } else {
                    phi_727_ = (_e319 >= (1f - _e321));
                }
                let _e326 = phi_727_;
                if ((bitcast<u32>(_e319) & 2147483647u) > 2139095040u) {
                    phi_735_ = true;
                } else {
                    phi_735_ = !(_e326);
                }
                let _e332 = phi_735_;
                if (_e319 > 0.5f) {
                    phi_740_ = 1f;
                } else {
                    phi_740_ = 0f;
                }
                let _e335 = phi_740_;
                phi_743_ = evaluate_Verdict(_e335, _e332);
            } else {
                phi_743_ = evaluate_Verdict(1f, true);
            }
            let _e339 = phi_743_;
            phi_744_ = _e339;
        }
        let _e341 = phi_744_;
        visibility.member[_e50.first_primitive] = _e341.visibility;
        phi_748_ = _e341.is_doubted;
        phi_749_ = _e50.first_primitive;
    } else {
        phi_748_ = false;
        phi_749_ = 0u;
    }
    let _e346 = phi_748_;
    let _e348 = phi_749_;
    if _e346 {
        let _e350 = atomicAdd((&shared_[0u]), 1u);
        phi_755_ = _e350;
    } else {
        phi_755_ = 0u;
    }
    let _e352 = phi_755_;
    workgroupBarrier();
    if (_e35 == 0u) {
        let _e356 = atomicLoad((&shared_[0u]));
        let _e357 = atomicAdd((&list.member[3u]), _e356);
        atomicStore((&shared_[1u]), _e357);
    }
    workgroupBarrier();
    if _e346 {
        let _e360 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e360) + _e352)]), _e348);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
