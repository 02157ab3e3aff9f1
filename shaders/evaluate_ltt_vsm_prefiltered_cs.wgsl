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

struct type_25 {
    member: array<abi_Sample>,
}

struct type_29 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_38 {
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

struct type_41 {
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

struct type_48 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_25;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_41;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_29;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_48;
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(2) 
var<storage> map: type_38;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_147_: lt_bvh_traverse_Tree;
    var phi_148_: bool;
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_155_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_147_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_148_ = false;
        } else {
            phi_147_ = lt_bvh_traverse_Tree();
            phi_148_ = true;
        }
        let _e47 = phi_147_;
        let _e49 = phi_148_;
        phi_149_ = _e47;
        phi_150_ = _e49;
    } else {
        phi_149_ = lt_bvh_traverse_Tree();
        phi_150_ = true;
    }
    let _e51 = phi_149_;
    let _e53 = phi_150_;
    if _e53 {
        phi_155_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_155_ = _e51;
    }
    let _e58 = phi_155_;
    return lt_bvh_traverse_Tree(_e58.root, _e58.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_to_light(param_4: vec3<f32>, param_5: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_5.x - (param_4.x * param_5.w)), (param_5.y - (param_4.y * param_5.w)), (param_5.z - (param_4.z * param_5.w)));
}

fn lt_shaders_evaluate_quad_indices(param_6: i32, param_7: i32, param_8: u32) -> array<u32, 4> {
    var phi_189_: i32;
    var phi_194_: i32;
    var phi_199_: i32;
    var phi_204_: i32;
    var phi_213_: i32;
    var phi_218_: i32;
    var phi_223_: i32;
    var phi_228_: i32;

    let _e38 = (bitcast<i32>(param_8) - 1i);
    if (param_6 > 0i) {
        phi_189_ = param_6;
    } else {
        phi_189_ = 0i;
    }
    let _e41 = phi_189_;
    if (param_7 > 0i) {
        phi_194_ = param_7;
    } else {
        phi_194_ = 0i;
    }
    let _e44 = phi_194_;
    if (_e41 < _e38) {
        phi_199_ = _e41;
    } else {
        phi_199_ = _e38;
    }
    let _e47 = phi_199_;
    if (_e44 < _e38) {
        phi_204_ = _e44;
    } else {
        phi_204_ = _e38;
    }
    let _e50 = phi_204_;
    let _e51 = bitcast<u32>(_e47);
    let _e53 = (param_6 + 1i);
    let _e54 = (param_7 + 1i);
    if (_e53 > 0i) {
        phi_213_ = _e53;
    } else {
        phi_213_ = 0i;
    }
    let _e57 = phi_213_;
    if (_e54 > 0i) {
        phi_218_ = _e54;
    } else {
        phi_218_ = 0i;
    }
    let _e60 = phi_218_;
    if (_e57 < _e38) {
        phi_223_ = _e57;
    } else {
        phi_223_ = _e38;
    }
    let _e63 = phi_223_;
    if (_e60 < _e38) {
        phi_228_ = _e60;
    } else {
        phi_228_ = _e38;
    }
    let _e66 = phi_228_;
    let _e67 = bitcast<u32>(_e63);
    let _e69 = (bitcast<u32>(_e50) * param_8);
    let _e70 = (bitcast<u32>(_e66) * param_8);
    return array<u32, 4>((_e69 + _e51), (_e69 + _e67), (_e70 + _e51), (_e70 + _e67));
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_9: ptr<function, f32>, param_10: vec4<f32>, param_11: f32) -> f32 {
    var phi_256_: f32;
    var phi_257_: f32;
    var phi_258_: f32;
    var phi_281_: bool;
    var phi_285_: f32;
    var phi_286_: f32;
    var phi_303_: bool;
    var phi_307_: f32;
    var phi_308_: f32;
    var phi_320_: bool;
    var phi_327_: f32;
    var phi_342_: f32;
    var phi_343_: f32;
    var phi_344_: f32;

    if ((bitcast<u32>(param_11) & 2147483647u) > 2139095040u) {
        phi_258_ = param_11;
    } else {
        if (param_11 < 0f) {
            phi_257_ = 0f;
        } else {
            if (param_11 > 1f) {
                phi_256_ = 1f;
            } else {
                phi_256_ = param_11;
            }
            let _e43 = phi_256_;
            phi_257_ = _e43;
        }
        let _e45 = phi_257_;
        phi_258_ = _e45;
    }
    let _e47 = phi_258_;
    let _e50 = (*param_9);
    let _e52 = (param_10.y - (param_10.x * param_10.x));
    let _e53 = (0.00000047683716f * param_10.y);
    if ((bitcast<u32>(_e50) & 2147483647u) > 2139095040u) {
        phi_286_ = _e50;
    } else {
        if ((bitcast<u32>(_e53) & 2147483647u) > 2139095040u) {
            phi_281_ = true;
        } else {
            let _e60 = (_e53 > _e50);
            if _e60 {
            }
            phi_281_ = _e60;
        }
        let _e62 = phi_281_;
        if _e62 {
            phi_285_ = _e53;
        } else {
            phi_285_ = _e50;
        }
        let _e64 = phi_285_;
        phi_286_ = _e64;
    }
    let _e66 = phi_286_;
    if ((bitcast<u32>(_e52) & 2147483647u) > 2139095040u) {
        phi_308_ = _e52;
    } else {
        if ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u) {
            phi_303_ = true;
        } else {
            let _e73 = (_e66 > _e52);
            if _e73 {
            }
            phi_303_ = _e73;
        }
        let _e75 = phi_303_;
        if _e75 {
            phi_307_ = _e66;
        } else {
            phi_307_ = _e52;
        }
        let _e77 = phi_307_;
        phi_308_ = _e77;
    }
    let _e79 = phi_308_;
    let _e80 = (_e47 - param_10.x);
    if (_e80 <= 0f) {
        let _e84 = ((bitcast<u32>(_e79) & 2147483647u) > 2139095040u);
        if _e84 {
        }
        phi_320_ = _e84;
    } else {
        phi_320_ = true;
    }
    let _e86 = phi_320_;
    if _e86 {
        phi_327_ = (_e79 / (_e79 + (_e80 * _e80)));
    } else {
        phi_327_ = 1f;
    }
    let _e91 = phi_327_;
    if ((bitcast<u32>(_e91) & 2147483647u) > 2139095040u) {
        phi_344_ = _e91;
    } else {
        if (_e91 < 0f) {
            phi_343_ = 0f;
        } else {
            if (_e91 > 1f) {
                phi_342_ = 1f;
            } else {
                phi_342_ = _e91;
            }
            let _e98 = phi_342_;
            phi_343_ = _e98;
        }
        let _e100 = phi_343_;
        phi_344_ = _e100;
    }
    let _e102 = phi_344_;
    return _e102;
}

fn function_() {
    var local_1: f32;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_401_: bool;
    var phi_405_: bool;
    var phi_440_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_444_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_537_: bool;
    var phi_538_: bool;
    var phi_539_: bool;
    var phi_540_: bool;
    var phi_541_: bool;
    var phi_542_: bool;
    var phi_543_: bool;
    var phi_544_: bool;
    var phi_545_: bool;
    var phi_546_: bool;
    var phi_547_: bool;
    var phi_548_: bool;
    var phi_552_: bool;
    var phi_697_: bool;
    var phi_705_: bool;
    var phi_710_: f32;
    var phi_713_: evaluate_Verdict;
    var phi_714_: evaluate_Verdict;
    var phi_718_: bool;
    var phi_719_: u32;
    var phi_725_: u32;

    let _e35 = id_1;
    let _e36 = local_2;
    let _e41 = arrayLength((&map.member));
    if (_e36 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e48 = p.member.size[0u];
    let _e50 = p.member.size[1u];
    let _e51 = lt_shaders_entry_pixel_index(_e35, _e48, _e50);
    if (bitcast<i32>(_e51.root) != 0i) {
        let _e58 = p.member.light;
        let _e61 = samples.member[_e51.first_primitive].normal[0u];
        let _e63 = global[0u];
        if (_e61 == _e63) {
            let _e66 = samples.member[_e51.first_primitive].normal[1u];
            let _e68 = global[1u];
            if (_e66 == _e68) {
                let _e71 = samples.member[_e51.first_primitive].normal[2u];
                let _e73 = global[2u];
                phi_398_ = (_e71 == _e73);
                phi_399_ = false;
            } else {
                phi_398_ = bool();
                phi_399_ = true;
            }
            let _e76 = phi_398_;
            let _e78 = phi_399_;
            phi_400_ = _e76;
            phi_401_ = _e78;
        } else {
            phi_400_ = bool();
            phi_401_ = true;
        }
        let _e80 = phi_400_;
        let _e82 = phi_401_;
        if _e82 {
            phi_405_ = false;
        } else {
            phi_405_ = _e80;
        }
        let _e84 = phi_405_;
        if !(_e84) {
            let _e87 = samples.member[_e51.first_primitive].normal;
            let _e89 = samples.member[_e51.first_primitive].position;
            let _e90 = lt_shaders_evaluate_to_light(_e89, _e58);
            if ((((_e87.x * _e90.x) + (_e87.y * _e90.y)) + (_e87.z * _e90.z)) > 0f) {
                let _e104 = samples.member[_e51.first_primitive].flags;
                let _e112 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e118 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e112.unnamed.visibility, false), _e112.unnamed_1);
                phi_440_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e118.unnamed, ((_e104 & 1u) == 0u));
            } else {
                let _e127 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e127.unnamed.visibility, false), _e127.unnamed_1);
                phi_440_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e133.unnamed, true);
            }
            let _e138 = phi_440_;
            phi_444_ = _e138;
        } else {
            let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e144.unnamed.visibility, false), _e144.unnamed_1);
            phi_444_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e150.unnamed, true);
        }
        let _e155 = phi_444_;
        if _e155.unnamed_1 {
            phi_714_ = evaluate_Verdict(_e155.unnamed.visibility, _e155.unnamed.is_doubted);
        } else {
            let _e163 = samples.member[_e51.first_primitive].position;
            let _e169 = p.member.projection.row_w;
            let _e180 = ((((_e169.x * _e163.x) + (_e169.y * _e163.y)) + (_e169.z * _e163.z)) + (_e169.w * 1f));
            let _e182 = p.member.projection.row_x;
            let _e194 = (((((_e182.x * _e163.x) + (_e182.y * _e163.y)) + (_e182.z * _e163.z)) + (_e182.w * 1f)) / _e180);
            let _e196 = p.member.projection.row_y;
            let _e208 = (((((_e196.x * _e163.x) + (_e196.y * _e163.y)) + (_e196.z * _e163.z)) + (_e196.w * 1f)) / _e180);
            let _e210 = p.member.projection.row_z;
            let _e221 = ((((_e210.x * _e163.x) + (_e210.y * _e163.y)) + (_e210.z * _e163.z)) + (_e210.w * 1f));
            if (_e180 > 0f) {
                if (_e194 >= 0f) {
                    if (_e194 <= 1f) {
                        if (_e208 >= 0f) {
                            if (_e208 <= 1f) {
                                if (_e221 >= 0f) {
                                    phi_537_ = (_e221 <= 1f);
                                    phi_538_ = false;
                                } else {
                                    phi_537_ = bool();
                                    phi_538_ = true;
                                }
                                let _e230 = phi_537_;
                                let _e232 = phi_538_;
                                phi_539_ = _e230;
                                phi_540_ = _e232;
                            } else {
                                phi_539_ = bool();
                                phi_540_ = true;
                            }
                            let _e234 = phi_539_;
                            let _e236 = phi_540_;
                            phi_541_ = _e234;
                            phi_542_ = _e236;
                        } else {
                            phi_541_ = bool();
                            phi_542_ = true;
                        }
                        let _e238 = phi_541_;
                        let _e240 = phi_542_;
                        phi_543_ = _e238;
                        phi_544_ = _e240;
                    } else {
                        phi_543_ = bool();
                        phi_544_ = true;
                    }
                    let _e242 = phi_543_;
                    let _e244 = phi_544_;
                    phi_545_ = _e242;
                    phi_546_ = _e244;
                } else {
                    phi_545_ = bool();
                    phi_546_ = true;
                }
                let _e246 = phi_545_;
                let _e248 = phi_546_;
                phi_547_ = _e246;
                phi_548_ = _e248;
            } else {
                phi_547_ = bool();
                phi_548_ = true;
            }
            let _e250 = phi_547_;
            let _e252 = phi_548_;
            if _e252 {
                phi_552_ = false;
            } else {
                phi_552_ = _e250;
            }
            let _e254 = phi_552_;
            if _e254 {
                let _e256 = p.member.map_size;
                let _e257 = f32(_e256);
                let _e260 = ((_e194 * _e257) - 0.5f);
                let _e261 = ((_e208 * _e257) - 0.5f);
                let _e262 = floor(_e260);
                let _e263 = floor(_e261);
                let _e264 = (_e260 - _e262);
                let _e265 = (_e261 - _e263);
                let _e286 = ((1f - _e264) * (1f - _e265));
                let _e288 = (_e264 * (1f - _e265));
                let _e290 = ((1f - _e264) * _e265);
                let _e291 = (_e264 * _e265);
                let _e293 = p.member.test;
                let _e294 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e293);
                let _e296 = p.member.map_size;
                local_1 = _e294;
                let _e297 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e262), i32(-2147483648), (_e262 < bitcast<f32>(3472883712u))), 2147483647i, (_e262 > bitcast<f32>(1325400063u))), (_e262 == _e262)), select(0i, select(select(i32(_e263), i32(-2147483648), (_e263 < bitcast<f32>(3472883712u))), 2147483647i, (_e263 > bitcast<f32>(1325400063u))), (_e263 == _e263)), _e296);
                if (_e297[0] < _e41) {
                } else {
                    return;
                }
                let _e302 = map.member[(0u + _e297[0])];
                if (_e297[1] < _e41) {
                } else {
                    return;
                }
                let _e315 = map.member[(0u + _e297[1])];
                if (_e297[2] < _e41) {
                } else {
                    return;
                }
                let _e332 = map.member[(0u + _e297[2])];
                if (_e297[3] < _e41) {
                } else {
                    return;
                }
                let _e349 = map.member[(0u + _e297[3])];
                let _e363 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e302.x * _e286) + (_e315.x * _e288)) + (_e332.x * _e290)) + (_e349.x * _e291)), ((((_e302.y * _e286) + (_e315.y * _e288)) + (_e332.y * _e290)) + (_e349.y * _e291)), ((((_e302.z * _e286) + (_e315.z * _e288)) + (_e332.z * _e290)) + (_e349.z * _e291)), ((((_e302.w * _e286) + (_e315.w * _e288)) + (_e332.w * _e290)) + (_e349.w * _e291))), _e221);
                let _e365 = p.member.epsilon;
                if (_e363 <= _e365) {
                    phi_697_ = true;
                } else {
                    phi_697_ = (_e363 >= (1f - _e365));
                }
                let _e370 = phi_697_;
                if ((bitcast<u32>(_e363) & 2147483647u) > 2139095040u) {
                    phi_705_ = true;
                } else {
                    phi_705_ = !(_e370);
                }
                let _e376 = phi_705_;
                if (_e363 > 0.5f) {
                    phi_710_ = 1f;
                } else {
                    phi_710_ = 0f;
                }
                let _e379 = phi_710_;
                phi_713_ = evaluate_Verdict(_e379, _e376);
            } else {
                phi_713_ = evaluate_Verdict(1f, true);
            }
            let _e383 = phi_713_;
            phi_714_ = _e383;
        }
        let _e385 = phi_714_;
        visibility.member[_e51.first_primitive] = _e385.visibility;
        phi_718_ = _e385.is_doubted;
        phi_719_ = _e51.first_primitive;
    } else {
        phi_718_ = false;
        phi_719_ = 0u;
    }
    let _e390 = phi_718_;
    let _e392 = phi_719_;
    if _e390 {
        let _e394 = atomicAdd((&shared_[0u]), 1u);
        phi_725_ = _e394;
    } else {
        phi_725_ = 0u;
    }
    let _e396 = phi_725_;
    workgroupBarrier();
    if (_e36 == 0u) {
        let _e400 = atomicLoad((&shared_[0u]));
        let _e401 = atomicAdd((&list.member[3u]), _e400);
        atomicStore((&shared_[1u]), _e401);
    }
    workgroupBarrier();
    if _e390 {
        let _e404 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e404) + _e396)]), _e392);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
