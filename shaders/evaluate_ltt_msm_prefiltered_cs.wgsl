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

struct type_26 {
    member: array<abi_Sample>,
}

struct type_30 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_39 {
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

struct type_42 {
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

struct type_49 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_26;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_42;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_30;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_49;
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_151_: lt_bvh_traverse_Tree;
    var phi_152_: bool;
    var phi_157_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_149_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_150_ = false;
        } else {
            phi_149_ = lt_bvh_traverse_Tree();
            phi_150_ = true;
        }
        let _e47 = phi_149_;
        let _e49 = phi_150_;
        phi_151_ = _e47;
        phi_152_ = _e49;
    } else {
        phi_151_ = lt_bvh_traverse_Tree();
        phi_152_ = true;
    }
    let _e51 = phi_151_;
    let _e53 = phi_152_;
    if _e53 {
        phi_157_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_157_ = _e51;
    }
    let _e58 = phi_157_;
    return lt_bvh_traverse_Tree(_e58.root, _e58.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_to_light(param_4: vec3<f32>, param_5: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_5.x - (param_4.x * param_5.w)), (param_5.y - (param_4.y * param_5.w)), (param_5.z - (param_4.z * param_5.w)));
}

fn lt_shaders_evaluate_quad_indices(param_6: i32, param_7: i32, param_8: u32) -> array<u32, 4> {
    var phi_191_: i32;
    var phi_196_: i32;
    var phi_201_: i32;
    var phi_206_: i32;
    var phi_215_: i32;
    var phi_220_: i32;
    var phi_225_: i32;
    var phi_230_: i32;

    let _e38 = (bitcast<i32>(param_8) - 1i);
    if (param_6 > 0i) {
        phi_191_ = param_6;
    } else {
        phi_191_ = 0i;
    }
    let _e41 = phi_191_;
    if (param_7 > 0i) {
        phi_196_ = param_7;
    } else {
        phi_196_ = 0i;
    }
    let _e44 = phi_196_;
    if (_e41 < _e38) {
        phi_201_ = _e41;
    } else {
        phi_201_ = _e38;
    }
    let _e47 = phi_201_;
    if (_e44 < _e38) {
        phi_206_ = _e44;
    } else {
        phi_206_ = _e38;
    }
    let _e50 = phi_206_;
    let _e51 = bitcast<u32>(_e47);
    let _e53 = (param_6 + 1i);
    let _e54 = (param_7 + 1i);
    if (_e53 > 0i) {
        phi_215_ = _e53;
    } else {
        phi_215_ = 0i;
    }
    let _e57 = phi_215_;
    if (_e54 > 0i) {
        phi_220_ = _e54;
    } else {
        phi_220_ = 0i;
    }
    let _e60 = phi_220_;
    if (_e57 < _e38) {
        phi_225_ = _e57;
    } else {
        phi_225_ = _e38;
    }
    let _e63 = phi_225_;
    if (_e60 < _e38) {
        phi_230_ = _e60;
    } else {
        phi_230_ = _e38;
    }
    let _e66 = phi_230_;
    let _e67 = bitcast<u32>(_e63);
    let _e69 = (bitcast<u32>(_e50) * param_8);
    let _e70 = (bitcast<u32>(_e66) * param_8);
    return array<u32, 4>((_e69 + _e51), (_e69 + _e67), (_e70 + _e51), (_e70 + _e67));
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_9: ptr<function, f32>, param_10: vec4<f32>, param_11: f32) -> f32 {
    var phi_282_: f32;
    var phi_283_: f32;
    var phi_284_: f32;
    var phi_319_: vec2<f32>;
    var phi_353_: f32;
    var phi_354_: f32;
    var phi_355_: f32;
    var phi_384_: f32;
    var phi_385_: f32;
    var phi_386_: f32;
    var phi_390_: f32;
    var phi_391_: f32;
    var phi_392_: f32;

    let _e37 = (*param_9);
    let _e38 = (1f - _e37);
    let _e47 = (0.5f * _e37);
    let _e48 = ((param_10.x * _e38) + _e47);
    let _e49 = ((param_10.y * _e38) + _e47);
    let _e53 = (_e49 - (_e48 * _e48));
    let _e55 = (((param_10.z * _e38) + _e47) - (_e48 * _e49));
    if ((bitcast<u32>(param_11) & 2147483647u) > 2139095040u) {
        phi_284_ = param_11;
    } else {
        if (param_11 < 0f) {
            phi_283_ = 0f;
        } else {
            if (param_11 > 1f) {
                phi_282_ = 1f;
            } else {
                phi_282_ = param_11;
            }
            let _e67 = phi_282_;
            phi_283_ = _e67;
        }
        let _e69 = phi_283_;
        phi_284_ = _e69;
    }
    let _e71 = phi_284_;
    let _e72 = (_e55 / _e53);
    let _e73 = (_e71 - _e48);
    let _e79 = (((((_e71 * _e71) - _e49) - (_e72 * _e73)) * _e53) / (((((param_10.w * _e38) + _e47) - (_e49 * _e49)) * _e53) - (_e55 * _e55)));
    let _e82 = ((_e73 / _e53) - (_e72 * _e79));
    let _e88 = ((0.5f * _e82) / _e79);
    let _e91 = ((_e88 * _e88) - (((1f - (_e82 * _e48)) - (_e79 * _e49)) / _e79));
    if (_e91 >= 0f) {
        let _e93 = sqrt(_e91);
        phi_319_ = vec2<f32>((-(_e88) - _e93), (-(_e88) + _e93));
    } else {
        phi_319_ = vec2(bitcast<f32>((bitcast<u32>(_e91) | 2143289344u)));
    }
    let _e104 = phi_319_;
    if (_e71 <= _e104.x) {
        phi_392_ = 1f;
    } else {
        if (_e71 > _e104.y) {
            let _e117 = (((_e49 - (_e48 * (_e104.x + _e104.y))) + (_e104.x * _e104.y)) / ((_e71 - _e104.x) * (_e71 - _e104.y)));
            if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
                phi_355_ = _e117;
            } else {
                if (_e117 < 0f) {
                    phi_354_ = 0f;
                } else {
                    if (_e117 > 1f) {
                        phi_353_ = 1f;
                    } else {
                        phi_353_ = _e117;
                    }
                    let _e124 = phi_353_;
                    phi_354_ = _e124;
                }
                let _e126 = phi_354_;
                phi_355_ = _e126;
            }
            let _e128 = phi_355_;
            phi_391_ = _e128;
        } else {
            if (_e71 > _e104.x) {
                let _e139 = (1f - (((_e49 - (_e48 * (_e71 + _e104.y))) + (_e71 * _e104.y)) / ((_e104.x - _e71) * (_e104.x - _e104.y))));
                if ((bitcast<u32>(_e139) & 2147483647u) > 2139095040u) {
                    phi_386_ = _e139;
                } else {
                    if (_e139 < 0f) {
                        phi_385_ = 0f;
                    } else {
                        if (_e139 > 1f) {
                            phi_384_ = 1f;
                        } else {
                            phi_384_ = _e139;
                        }
                        let _e146 = phi_384_;
                        phi_385_ = _e146;
                    }
                    let _e148 = phi_385_;
                    phi_386_ = _e148;
                }
                let _e150 = phi_386_;
                phi_390_ = _e150;
            } else {
                phi_390_ = bitcast<f32>((bitcast<u32>(_e104.x) | 2143289344u));
            }
            let _e155 = phi_390_;
            phi_391_ = _e155;
        }
        let _e157 = phi_391_;
        phi_392_ = _e157;
    }
    let _e159 = phi_392_;
    return _e159;
}

fn function_() {
    var local_1: f32;
    var phi_446_: bool;
    var phi_447_: bool;
    var phi_448_: bool;
    var phi_449_: bool;
    var phi_453_: bool;
    var phi_488_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_492_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_585_: bool;
    var phi_586_: bool;
    var phi_587_: bool;
    var phi_588_: bool;
    var phi_589_: bool;
    var phi_590_: bool;
    var phi_591_: bool;
    var phi_592_: bool;
    var phi_593_: bool;
    var phi_594_: bool;
    var phi_595_: bool;
    var phi_596_: bool;
    var phi_600_: bool;
    var phi_745_: bool;
    var phi_753_: bool;
    var phi_758_: f32;
    var phi_761_: evaluate_Verdict;
    var phi_762_: evaluate_Verdict;
    var phi_766_: bool;
    var phi_767_: u32;
    var phi_773_: u32;

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
                phi_446_ = (_e71 == _e73);
                phi_447_ = false;
            } else {
                phi_446_ = bool();
                phi_447_ = true;
            }
            let _e76 = phi_446_;
            let _e78 = phi_447_;
            phi_448_ = _e76;
            phi_449_ = _e78;
        } else {
            phi_448_ = bool();
            phi_449_ = true;
        }
        let _e80 = phi_448_;
        let _e82 = phi_449_;
        if _e82 {
            phi_453_ = false;
        } else {
            phi_453_ = _e80;
        }
        let _e84 = phi_453_;
        if !(_e84) {
            let _e87 = samples.member[_e51.first_primitive].normal;
            let _e89 = samples.member[_e51.first_primitive].position;
            let _e90 = lt_shaders_evaluate_to_light(_e89, _e58);
            if ((((_e87.x * _e90.x) + (_e87.y * _e90.y)) + (_e87.z * _e90.z)) > 0f) {
                let _e104 = samples.member[_e51.first_primitive].flags;
                let _e112 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e118 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e112.unnamed.visibility, false), _e112.unnamed_1);
                phi_488_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e118.unnamed, ((_e104 & 1u) == 0u));
            } else {
                let _e127 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e127.unnamed.visibility, false), _e127.unnamed_1);
                phi_488_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e133.unnamed, true);
            }
            let _e138 = phi_488_;
            phi_492_ = _e138;
        } else {
            let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e144.unnamed.visibility, false), _e144.unnamed_1);
            phi_492_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e150.unnamed, true);
        }
        let _e155 = phi_492_;
        if _e155.unnamed_1 {
            phi_762_ = evaluate_Verdict(_e155.unnamed.visibility, _e155.unnamed.is_doubted);
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
                                    phi_585_ = (_e221 <= 1f);
                                    phi_586_ = false;
                                } else {
                                    phi_585_ = bool();
                                    phi_586_ = true;
                                }
                                let _e230 = phi_585_;
                                let _e232 = phi_586_;
                                phi_587_ = _e230;
                                phi_588_ = _e232;
                            } else {
                                phi_587_ = bool();
                                phi_588_ = true;
                            }
                            let _e234 = phi_587_;
                            let _e236 = phi_588_;
                            phi_589_ = _e234;
                            phi_590_ = _e236;
                        } else {
                            phi_589_ = bool();
                            phi_590_ = true;
                        }
                        let _e238 = phi_589_;
                        let _e240 = phi_590_;
                        phi_591_ = _e238;
                        phi_592_ = _e240;
                    } else {
                        phi_591_ = bool();
                        phi_592_ = true;
                    }
                    let _e242 = phi_591_;
                    let _e244 = phi_592_;
                    phi_593_ = _e242;
                    phi_594_ = _e244;
                } else {
                    phi_593_ = bool();
                    phi_594_ = true;
                }
                let _e246 = phi_593_;
                let _e248 = phi_594_;
                phi_595_ = _e246;
                phi_596_ = _e248;
            } else {
                phi_595_ = bool();
                phi_596_ = true;
            }
            let _e250 = phi_595_;
            let _e252 = phi_596_;
            if _e252 {
                phi_600_ = false;
            } else {
                phi_600_ = _e250;
            }
            let _e254 = phi_600_;
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
                let _e294 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e293);
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
                let _e363 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e302.x * _e286) + (_e315.x * _e288)) + (_e332.x * _e290)) + (_e349.x * _e291)), ((((_e302.y * _e286) + (_e315.y * _e288)) + (_e332.y * _e290)) + (_e349.y * _e291)), ((((_e302.z * _e286) + (_e315.z * _e288)) + (_e332.z * _e290)) + (_e349.z * _e291)), ((((_e302.w * _e286) + (_e315.w * _e288)) + (_e332.w * _e290)) + (_e349.w * _e291))), _e221);
                let _e365 = p.member.epsilon;
                if (_e363 <= _e365) {
                    phi_745_ = true;
                } else {
                    phi_745_ = (_e363 >= (1f - _e365));
                }
                let _e370 = phi_745_;
                if ((bitcast<u32>(_e363) & 2147483647u) > 2139095040u) {
                    phi_753_ = true;
                } else {
                    phi_753_ = !(_e370);
                }
                let _e376 = phi_753_;
                if (_e363 > 0.5f) {
                    phi_758_ = 1f;
                } else {
                    phi_758_ = 0f;
                }
                let _e379 = phi_758_;
                phi_761_ = evaluate_Verdict(_e379, _e376);
            } else {
                phi_761_ = evaluate_Verdict(1f, true);
            }
            let _e383 = phi_761_;
            phi_762_ = _e383;
        }
        let _e385 = phi_762_;
        visibility.member[_e51.first_primitive] = _e385.visibility;
        phi_766_ = _e385.is_doubted;
        phi_767_ = _e51.first_primitive;
    } else {
        phi_766_ = false;
        phi_767_ = 0u;
    }
    let _e390 = phi_766_;
    let _e392 = phi_767_;
    if _e390 {
        let _e394 = atomicAdd((&shared_[0u]), 1u);
        phi_773_ = _e394;
    } else {
        phi_773_ = 0u;
    }
    let _e396 = phi_773_;
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
fn entry_evaluate_evaluate_ltt_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
