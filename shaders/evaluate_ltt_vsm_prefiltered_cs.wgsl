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

struct type_23 {
    member: array<abi_Sample>,
}

struct type_27 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_36 {
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

struct type_40 {
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

struct type_47 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_23;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_40;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_27;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_47;
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(2) 
var<storage> map: type_36;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_143_: lt_bvh_traverse_Tree;
    var phi_144_: bool;
    var phi_145_: lt_bvh_traverse_Tree;
    var phi_146_: bool;
    var phi_151_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_143_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_144_ = false;
        } else {
            phi_143_ = lt_bvh_traverse_Tree();
            phi_144_ = true;
        }
        let _e50 = phi_143_;
        let _e52 = phi_144_;
        phi_145_ = _e50;
        phi_146_ = _e52;
    } else {
        phi_145_ = lt_bvh_traverse_Tree();
        phi_146_ = true;
    }
    let _e54 = phi_145_;
    let _e56 = phi_146_;
    if _e56 {
        phi_151_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_151_ = _e54;
    }
    let _e61 = phi_151_;
    return lt_bvh_traverse_Tree(_e61.root, _e61.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_176_: f32;
    var phi_177_: f32;
    var phi_178_: f32;
    var phi_196_: bool;
    var phi_200_: f32;
    var phi_212_: bool;
    var phi_219_: f32;
    var phi_234_: f32;
    var phi_235_: f32;
    var phi_236_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_178_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_177_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_176_ = 1f;
            } else {
                phi_176_ = param_6;
            }
            let _e46 = phi_176_;
            phi_177_ = _e46;
        }
        let _e48 = phi_177_;
        phi_178_ = _e48;
    }
    let _e50 = phi_178_;
    let _e53 = (*param_4);
    let _e57 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e53) & 2147483647u) > 2139095040u) {
        phi_196_ = true;
    } else {
        let _e61 = (_e53 > _e57);
        if _e61 {
        }
        phi_196_ = _e61;
    }
    let _e63 = phi_196_;
    if _e63 {
        phi_200_ = _e53;
    } else {
        phi_200_ = _e57;
    }
    let _e65 = phi_200_;
    let _e66 = (_e50 - param_5.x);
    if (_e66 <= 0f) {
        let _e70 = ((bitcast<u32>(_e65) & 2147483647u) > 2139095040u);
        if _e70 {
        }
        phi_212_ = _e70;
    } else {
        phi_212_ = true;
    }
    let _e72 = phi_212_;
    if _e72 {
        phi_219_ = (_e65 / (_e65 + (_e66 * _e66)));
    } else {
        phi_219_ = 1f;
    }
    let _e77 = phi_219_;
    if ((bitcast<u32>(_e77) & 2147483647u) > 2139095040u) {
        phi_236_ = _e77;
    } else {
        if (_e77 < 0f) {
            phi_235_ = 0f;
        } else {
            if (_e77 > 1f) {
                phi_234_ = 1f;
            } else {
                phi_234_ = _e77;
            }
            let _e84 = phi_234_;
            phi_235_ = _e84;
        }
        let _e86 = phi_235_;
        phi_236_ = _e86;
    }
    let _e88 = phi_236_;
    return _e88;
}

fn function_() {
    var local_1: f32;
    var phi_290_: bool;
    var phi_291_: bool;
    var phi_292_: bool;
    var phi_293_: bool;
    var phi_297_: bool;
    var phi_341_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_345_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_422_: bool;
    var phi_431_: bool;
    var phi_440_: bool;
    var phi_441_: bool;
    var phi_442_: bool;
    var phi_443_: bool;
    var phi_444_: bool;
    var phi_445_: bool;
    var phi_446_: bool;
    var phi_450_: bool;
    var phi_486_: f32;
    var phi_491_: f32;
    var phi_492_: bool;
    var phi_493_: f32;
    var phi_494_: bool;
    var phi_498_: f32;
    var phi_518_: f32;
    var phi_523_: f32;
    var phi_524_: bool;
    var phi_525_: f32;
    var phi_526_: bool;
    var phi_530_: f32;
    var phi_576_: i32;
    var phi_581_: i32;
    var phi_586_: i32;
    var phi_591_: i32;
    var phi_600_: i32;
    var phi_605_: i32;
    var phi_610_: i32;
    var phi_615_: i32;
    var phi_706_: bool;
    var phi_714_: bool;
    var phi_719_: f32;
    var phi_722_: evaluate_Verdict;
    var phi_723_: evaluate_Verdict;
    var phi_727_: bool;
    var phi_728_: u32;
    var phi_734_: u32;

    let _e38 = id_1;
    let _e39 = local_2;
    let _e44 = arrayLength((&map.member));
    if (_e39 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e51 = p.member.size[0u];
    let _e53 = p.member.size[1u];
    let _e54 = lt_shaders_entry_pixel_index(_e38, _e51, _e53);
    if (bitcast<i32>(_e54.root) != 0i) {
        let _e61 = p.member.light;
        let _e64 = samples.member[_e54.first_primitive].normal[0u];
        let _e66 = global[0u];
        if (_e64 == _e66) {
            let _e69 = samples.member[_e54.first_primitive].normal[1u];
            let _e71 = global[1u];
            if (_e69 == _e71) {
                let _e74 = samples.member[_e54.first_primitive].normal[2u];
                let _e76 = global[2u];
                phi_290_ = (_e74 == _e76);
                phi_291_ = false;
            } else {
                phi_290_ = bool();
                phi_291_ = true;
            }
            let _e79 = phi_290_;
            let _e81 = phi_291_;
            phi_292_ = _e79;
            phi_293_ = _e81;
        } else {
            phi_292_ = bool();
            phi_293_ = true;
        }
        let _e83 = phi_292_;
        let _e85 = phi_293_;
        if _e85 {
            phi_297_ = false;
        } else {
            phi_297_ = _e83;
        }
        let _e87 = phi_297_;
        if !(_e87) {
            let _e90 = samples.member[_e54.first_primitive].normal;
            let _e92 = samples.member[_e54.first_primitive].position;
            if ((((_e90.x * (_e61.x - (_e92.x * _e61.w))) + (_e90.y * (_e61.y - (_e92.y * _e61.w)))) + (_e90.z * (_e61.z - (_e92.z * _e61.w)))) > 0f) {
                let _e116 = samples.member[_e54.first_primitive].flags;
                let _e124 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e130 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e124.unnamed.visibility, false), _e124.unnamed_1);
                phi_341_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e130.unnamed, ((_e116 & 1u) == 0u));
            } else {
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e139.unnamed.visibility, false), _e139.unnamed_1);
                phi_341_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e145.unnamed, true);
            }
            let _e150 = phi_341_;
            phi_345_ = _e150;
        } else {
            let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e156.unnamed.visibility, false), _e156.unnamed_1);
            phi_345_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e162.unnamed, true);
        }
        let _e167 = phi_345_;
        if _e167.unnamed_1 {
            phi_723_ = evaluate_Verdict(_e167.unnamed.visibility, _e167.unnamed.is_doubted);
        } else {
            let _e175 = samples.member[_e54.first_primitive].position;
            let _e181 = p.member.projection.row_w;
            let _e192 = ((((_e181.x * _e175.x) + (_e181.y * _e175.y)) + (_e181.z * _e175.z)) + (_e181.w * 1f));
            let _e194 = p.member.projection.row_x;
            let _e206 = (((((_e194.x * _e175.x) + (_e194.y * _e175.y)) + (_e194.z * _e175.z)) + (_e194.w * 1f)) / _e192);
            let _e208 = p.member.projection.row_y;
            let _e220 = (((((_e208.x * _e175.x) + (_e208.y * _e175.y)) + (_e208.z * _e175.z)) + (_e208.w * 1f)) / _e192);
            let _e222 = p.member.projection.row_z;
            let _e233 = ((((_e222.x * _e175.x) + (_e222.y * _e175.y)) + (_e222.z * _e175.z)) + (_e222.w * 1f));
            if (_e192 > 0f) {
                if (_e206 >= 0f) {
                    phi_422_ = (_e206 <= 1f);
                } else {
                    phi_422_ = false;
                }
                let _e238 = phi_422_;
                if _e238 {
                    if (_e220 >= 0f) {
                        phi_431_ = (_e220 <= 1f);
                    } else {
                        phi_431_ = false;
                    }
                    let _e242 = phi_431_;
                    if _e242 {
                        if (_e233 >= 0f) {
                            phi_440_ = (_e233 <= 1f);
                        } else {
                            phi_440_ = false;
                        }
                        let _e246 = phi_440_;
                        phi_441_ = _e246;
                        phi_442_ = false;
                    } else {
                        phi_441_ = bool();
                        phi_442_ = true;
                    }
                    let _e248 = phi_441_;
                    let _e250 = phi_442_;
                    phi_443_ = _e248;
                    phi_444_ = _e250;
                } else {
                    phi_443_ = bool();
                    phi_444_ = true;
                }
                let _e252 = phi_443_;
                let _e254 = phi_444_;
                phi_445_ = _e252;
                phi_446_ = _e254;
            } else {
                phi_445_ = bool();
                phi_446_ = true;
            }
            let _e256 = phi_445_;
            let _e258 = phi_446_;
            if _e258 {
                phi_450_ = false;
            } else {
                phi_450_ = _e256;
            }
            let _e260 = phi_450_;
            if _e260 {
                let _e262 = p.member.map_size;
                let _e263 = f32(_e262);
                let _e266 = ((_e206 * _e263) - 0.5f);
                let _e267 = ((_e220 * _e263) - 0.5f);
                if (_e266 > -8388608f) {
                    let _e279 = f32(select(0i, select(select(i32(_e266), i32(-2147483648), (_e266 < bitcast<f32>(3472883712u))), 2147483647i, (_e266 > bitcast<f32>(1325400063u))), (_e266 == _e266)));
                    if (_e279 > _e266) {
                        phi_486_ = 1f;
                    } else {
                        phi_486_ = 0f;
                    }
                    let _e282 = phi_486_;
                    if (_e266 < 8388608f) {
                        phi_491_ = (_e279 - _e282);
                        phi_492_ = false;
                    } else {
                        phi_491_ = f32();
                        phi_492_ = true;
                    }
                    let _e285 = phi_491_;
                    let _e287 = phi_492_;
                    phi_493_ = _e285;
                    phi_494_ = _e287;
                } else {
                    phi_493_ = f32();
                    phi_494_ = true;
                }
                let _e289 = phi_493_;
                let _e291 = phi_494_;
                if _e291 {
                    phi_498_ = _e266;
                } else {
                    phi_498_ = _e289;
                }
                let _e293 = phi_498_;
                if (_e267 > -8388608f) {
                    let _e305 = f32(select(0i, select(select(i32(_e267), i32(-2147483648), (_e267 < bitcast<f32>(3472883712u))), 2147483647i, (_e267 > bitcast<f32>(1325400063u))), (_e267 == _e267)));
                    if (_e305 > _e267) {
                        phi_518_ = 1f;
                    } else {
                        phi_518_ = 0f;
                    }
                    let _e308 = phi_518_;
                    if (_e267 < 8388608f) {
                        phi_523_ = (_e305 - _e308);
                        phi_524_ = false;
                    } else {
                        phi_523_ = f32();
                        phi_524_ = true;
                    }
                    let _e311 = phi_523_;
                    let _e313 = phi_524_;
                    phi_525_ = _e311;
                    phi_526_ = _e313;
                } else {
                    phi_525_ = f32();
                    phi_526_ = true;
                }
                let _e315 = phi_525_;
                let _e317 = phi_526_;
                if _e317 {
                    phi_530_ = _e267;
                } else {
                    phi_530_ = _e315;
                }
                let _e319 = phi_530_;
                let _e320 = (_e266 - _e293);
                let _e321 = (_e267 - _e319);
                let _e330 = select(0i, select(select(i32(_e293), i32(-2147483648), (_e293 < bitcast<f32>(3472883712u))), 2147483647i, (_e293 > bitcast<f32>(1325400063u))), (_e293 == _e293));
                let _e339 = select(0i, select(select(i32(_e319), i32(-2147483648), (_e319 < bitcast<f32>(3472883712u))), 2147483647i, (_e319 > bitcast<f32>(1325400063u))), (_e319 == _e319));
                let _e342 = ((1f - _e320) * (1f - _e321));
                let _e344 = (_e320 * (1f - _e321));
                let _e346 = ((1f - _e320) * _e321);
                let _e347 = (_e320 * _e321);
                let _e349 = p.member.test;
                let _e350 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e349);
                let _e352 = p.member.map_size;
                local_1 = _e350;
                let _e354 = (bitcast<i32>(_e352) - 1i);
                if (_e330 > 0i) {
                    phi_576_ = _e330;
                } else {
                    phi_576_ = 0i;
                }
                let _e357 = phi_576_;
                if (_e339 > 0i) {
                    phi_581_ = _e339;
                } else {
                    phi_581_ = 0i;
                }
                let _e360 = phi_581_;
                if (_e357 < _e354) {
                    phi_586_ = _e357;
                } else {
                    phi_586_ = _e354;
                }
                let _e363 = phi_586_;
                if (_e360 < _e354) {
                    phi_591_ = _e360;
                } else {
                    phi_591_ = _e354;
                }
                let _e366 = phi_591_;
                let _e367 = bitcast<u32>(_e363);
                let _e369 = (_e330 + 1i);
                let _e370 = (_e339 + 1i);
                if (_e369 > 0i) {
                    phi_600_ = _e369;
                } else {
                    phi_600_ = 0i;
                }
                let _e373 = phi_600_;
                if (_e370 > 0i) {
                    phi_605_ = _e370;
                } else {
                    phi_605_ = 0i;
                }
                let _e376 = phi_605_;
                if (_e373 < _e354) {
                    phi_610_ = _e373;
                } else {
                    phi_610_ = _e354;
                }
                let _e379 = phi_610_;
                if (_e376 < _e354) {
                    phi_615_ = _e376;
                } else {
                    phi_615_ = _e354;
                }
                let _e382 = phi_615_;
                let _e383 = bitcast<u32>(_e379);
                let _e385 = (bitcast<u32>(_e366) * _e352);
                let _e386 = (bitcast<u32>(_e382) * _e352);
                let _e387 = (_e385 + _e367);
                let _e388 = (_e385 + _e383);
                let _e389 = (_e386 + _e367);
                let _e390 = (_e386 + _e383);
                if (_e387 < _e44) {
                } else {
                    return;
                }
                let _e394 = map.member[(0u + _e387)];
                if (_e388 < _e44) {
                } else {
                    return;
                }
                let _e406 = map.member[(0u + _e388)];
                if (_e389 < _e44) {
                } else {
                    return;
                }
                let _e422 = map.member[(0u + _e389)];
                if (_e390 < _e44) {
                } else {
                    return;
                }
                let _e438 = map.member[(0u + _e390)];
                let _e452 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e394.x * _e342) + (_e406.x * _e344)) + (_e422.x * _e346)) + (_e438.x * _e347)), ((((_e394.y * _e342) + (_e406.y * _e344)) + (_e422.y * _e346)) + (_e438.y * _e347)), ((((_e394.z * _e342) + (_e406.z * _e344)) + (_e422.z * _e346)) + (_e438.z * _e347)), ((((_e394.w * _e342) + (_e406.w * _e344)) + (_e422.w * _e346)) + (_e438.w * _e347))), _e233);
                let _e454 = p.member.epsilon;
                if (_e452 <= _e454) {
                    phi_706_ = true;
                } else {
                    phi_706_ = (_e452 >= (1f - _e454));
                }
                let _e459 = phi_706_;
                if ((bitcast<u32>(_e452) & 2147483647u) > 2139095040u) {
                    phi_714_ = true;
                } else {
                    phi_714_ = !(_e459);
                }
                let _e465 = phi_714_;
                if (_e452 > 0.5f) {
                    phi_719_ = 1f;
                } else {
                    phi_719_ = 0f;
                }
                let _e468 = phi_719_;
                phi_722_ = evaluate_Verdict(_e468, _e465);
            } else {
                phi_722_ = evaluate_Verdict(1f, true);
            }
            let _e472 = phi_722_;
            phi_723_ = _e472;
        }
        let _e474 = phi_723_;
        visibility.member[_e54.first_primitive] = _e474.visibility;
        phi_727_ = _e474.is_doubted;
        phi_728_ = _e54.first_primitive;
    } else {
        phi_727_ = false;
        phi_728_ = 0u;
    }
    let _e479 = phi_727_;
    let _e481 = phi_728_;
    if _e479 {
        let _e483 = atomicAdd((&shared_[0u]), 1u);
        phi_734_ = _e483;
    } else {
        phi_734_ = 0u;
    }
    let _e485 = phi_734_;
    workgroupBarrier();
    if (_e39 == 0u) {
        let _e489 = atomicLoad((&shared_[0u]));
        let _e490 = atomicAdd((&list.member[3u]), _e489);
        atomicStore((&shared_[1u]), _e490);
    }
    workgroupBarrier();
    if _e479 {
        let _e493 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e493) + _e485)]), _e481);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
