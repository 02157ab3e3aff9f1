struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_15 {
    member: array<abi_Sample>,
}

struct type_19 {
    member: array<f32>,
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
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    pad0_: u32,
    pad1_: u32,
}

struct type_30 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;

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
        let _e46 = phi_130_;
        let _e48 = phi_131_;
        phi_132_ = _e46;
        phi_133_ = _e48;
    } else {
        phi_132_ = lt_bvh_traverse_Tree();
        phi_133_ = true;
    }
    let _e50 = phi_132_;
    let _e52 = phi_133_;
    if _e52 {
        phi_138_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_138_ = _e50;
    }
    let _e57 = phi_138_;
    return lt_bvh_traverse_Tree(_e57.root, _e57.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_164_: f32;
    var phi_165_: f32;
    var phi_166_: f32;
    var phi_182_: f32;
    var phi_183_: f32;
    var phi_184_: f32;
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_202_: f32;
    var phi_218_: f32;
    var phi_219_: f32;
    var phi_220_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_284_: bool;
    var phi_288_: f32;
    var phi_300_: bool;
    var phi_307_: f32;
    var phi_322_: f32;
    var phi_323_: f32;
    var phi_324_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_166_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_165_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_164_ = 1f;
            } else {
                phi_164_ = param_7;
            }
            let _e43 = phi_164_;
            phi_165_ = _e43;
        }
        let _e45 = phi_165_;
        phi_166_ = _e45;
    }
    let _e47 = phi_166_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_184_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_183_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_182_ = 1f;
            } else {
                phi_182_ = param_5.x;
            }
            let _e55 = phi_182_;
            phi_183_ = _e55;
        }
        let _e57 = phi_183_;
        phi_184_ = _e57;
    }
    let _e59 = phi_184_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_202_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_201_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_200_ = 1f;
            } else {
                phi_200_ = param_5.y;
            }
            let _e67 = phi_200_;
            phi_201_ = _e67;
        }
        let _e69 = phi_201_;
        phi_202_ = _e69;
    }
    let _e71 = phi_202_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_220_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_219_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_218_ = 1f;
            } else {
                phi_218_ = param_5.z;
            }
            let _e79 = phi_218_;
            phi_219_ = _e79;
        }
        let _e81 = phi_219_;
        phi_220_ = _e81;
    }
    let _e83 = phi_220_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_238_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_237_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_236_ = 1f;
            } else {
                phi_236_ = param_5.w;
            }
            let _e91 = phi_236_;
            phi_237_ = _e91;
        }
        let _e93 = phi_237_;
        phi_238_ = _e93;
    }
    let _e95 = phi_238_;
    let _e96 = (_e59 - _e47);
    let _e97 = (_e71 - _e47);
    let _e98 = (_e83 - _e47);
    let _e99 = (_e95 - _e47);
    let _e100 = (*param_4);
    let _e111 = ((((_e96 * param_6.x) + (_e97 * param_6.y)) + (_e98 * param_6.z)) + (_e99 * param_6.w));
    let _e112 = (_e96 - _e111);
    let _e113 = (_e97 - _e111);
    let _e114 = (_e98 - _e111);
    let _e115 = (_e99 - _e111);
    let _e130 = (((((_e112 * _e112) * param_6.x) + ((_e113 * _e113) * param_6.y)) + ((_e114 * _e114) * param_6.z)) + ((_e115 * _e115) * param_6.w));
    if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
        phi_284_ = true;
    } else {
        let _e134 = (_e100 > _e130);
        if _e134 {
        }
        phi_284_ = _e134;
    }
    let _e136 = phi_284_;
    if _e136 {
        phi_288_ = _e100;
    } else {
        phi_288_ = _e130;
    }
    let _e138 = phi_288_;
    let _e139 = -(_e111);
    if (_e139 <= 0f) {
        let _e143 = ((bitcast<u32>(_e138) & 2147483647u) > 2139095040u);
        if _e143 {
        }
        phi_300_ = _e143;
    } else {
        phi_300_ = true;
    }
    let _e145 = phi_300_;
    if _e145 {
        phi_307_ = (_e138 / (_e138 + (_e139 * _e139)));
    } else {
        phi_307_ = 1f;
    }
    let _e150 = phi_307_;
    if ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u) {
        phi_324_ = _e150;
    } else {
        if (_e150 < 0f) {
            phi_323_ = 0f;
        } else {
            if (_e150 > 1f) {
                phi_322_ = 1f;
            } else {
                phi_322_ = _e150;
            }
            let _e157 = phi_322_;
            phi_323_ = _e157;
        }
        let _e159 = phi_323_;
        phi_324_ = _e159;
    }
    let _e161 = phi_324_;
    return _e161;
}

fn function_() {
    var local: f32;
    var phi_380_: bool;
    var phi_381_: bool;
    var phi_382_: bool;
    var phi_383_: bool;
    var phi_387_: bool;
    var phi_457_: bool;
    var phi_458_: bool;
    var phi_469_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_470_: bool;
    var phi_471_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_472_: bool;
    var phi_479_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_483_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_557_: bool;
    var phi_566_: bool;
    var phi_575_: bool;
    var phi_576_: bool;
    var phi_577_: bool;
    var phi_578_: bool;
    var phi_579_: bool;
    var phi_580_: bool;
    var phi_581_: bool;
    var phi_585_: bool;
    var phi_675_: f32;
    var phi_678_: f32;
    var phi_707_: f32;
    var phi_712_: f32;
    var phi_713_: bool;
    var phi_714_: f32;
    var phi_715_: bool;
    var phi_719_: f32;
    var phi_739_: f32;
    var phi_744_: f32;
    var phi_745_: bool;
    var phi_746_: f32;
    var phi_747_: bool;
    var phi_751_: f32;
    var phi_799_: i32;
    var phi_804_: i32;
    var phi_809_: i32;
    var phi_814_: i32;
    var phi_823_: i32;
    var phi_828_: i32;
    var phi_833_: i32;
    var phi_838_: i32;
    var phi_889_: bool;
    var phi_897_: bool;
    var phi_909_: bool;
    var phi_910_: bool;
    var phi_914_: f32;
    var phi_920_: f32;
    var phi_922_: evaluate_Verdict;
    var phi_927_: evaluate_Verdict;
    var phi_928_: evaluate_Verdict;

    let _e34 = id_1;
    let _e41 = arrayLength((&map.member));
    let _e47 = p.member.size[0u];
    let _e49 = p.member.size[1u];
    let _e50 = lt_shaders_entry_pixel_index(_e34, _e47, _e49);
    if (bitcast<i32>(_e50.root) != 0i) {
        let _e56 = p.member.projection;
        if (_e50.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e60 = lt_math_OneLevel(_e56);
        let _e64 = samples.member[(0u + _e50.first_primitive)].normal[0u];
        let _e66 = global[0u];
        if (_e64 == _e66) {
            let _e69 = samples.member[(0u + _e50.first_primitive)].normal[1u];
            let _e71 = global[1u];
            if (_e69 == _e71) {
                let _e74 = samples.member[(0u + _e50.first_primitive)].normal[2u];
                let _e76 = global[2u];
                phi_380_ = (_e74 == _e76);
                phi_381_ = false;
            } else {
                phi_380_ = bool();
                phi_381_ = true;
            }
            let _e79 = phi_380_;
            let _e81 = phi_381_;
            phi_382_ = _e79;
            phi_383_ = _e81;
        } else {
            phi_382_ = bool();
            phi_383_ = true;
        }
        let _e83 = phi_382_;
        let _e85 = phi_383_;
        if _e85 {
            phi_387_ = false;
        } else {
            phi_387_ = _e83;
        }
        let _e87 = phi_387_;
        if !(_e87) {
            let _e90 = samples.member[(0u + _e50.first_primitive)].position;
            let _e92 = p.member.light.place;
            let _e98 = p.member.light.place[3u];
            let _e105 = (_e92.x - (_e90.x * _e98));
            let _e106 = (_e92.y - (_e90.y * _e98));
            let _e107 = (_e92.z - (_e90.z * _e98));
            let _e109 = samples.member[(0u + _e50.first_primitive)].normal;
            if ((((_e109.x * _e105) + (_e109.y * _e106)) + (_e109.z * _e107)) > 0f) {
                let _e123 = (((_e105 * _e105) + (_e106 * _e106)) + (_e107 * _e107));
                let _e125 = p.member.light.axis;
                let _e137 = p.member.light.place[3u];
                if (_e137 == 0f) {
                    phi_458_ = true;
                } else {
                    let _e140 = p.member.light.range_squared;
                    if (_e123 <= _e140) {
                        let _e143 = p.member.light.cos_outer;
                        phi_457_ = (-((((_e105 * _e125.x) + (_e106 * _e125.y)) + (_e107 * _e125.z))) >= (_e143 * sqrt(_e123)));
                    } else {
                        phi_457_ = false;
                    }
                    let _e148 = phi_457_;
                    phi_458_ = _e148;
                }
                let _e150 = phi_458_;
                if _e150 {
                    let _e152 = samples.member[(0u + _e50.first_primitive)].flags;
                    let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e160.unnamed.visibility, false), _e160.unnamed_1);
                    phi_469_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e166.unnamed, ((_e152 & 1u) == 0u));
                    phi_470_ = false;
                } else {
                    phi_469_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_470_ = true;
                }
                let _e171 = phi_469_;
                let _e173 = phi_470_;
                phi_471_ = _e171;
                phi_472_ = _e173;
            } else {
                phi_471_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_472_ = true;
            }
            let _e175 = phi_471_;
            let _e177 = phi_472_;
            if _e177 {
                let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e189 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e183.unnamed.visibility, false), _e183.unnamed_1);
                phi_479_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e189.unnamed, true);
            } else {
                phi_479_ = _e175;
            }
            let _e194 = phi_479_;
            phi_483_ = _e194;
        } else {
            let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e200.unnamed.visibility, false), _e200.unnamed_1);
            phi_483_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e206.unnamed, true);
        }
        let _e211 = phi_483_;
        if _e211.unnamed_1 {
            phi_928_ = evaluate_Verdict(_e211.unnamed.visibility, _e211.unnamed.is_doubted);
        } else {
            let _e219 = samples.member[(0u + _e50.first_primitive)].position;
            let _e237 = ((((_e60.projection.row_w.x * _e219.x) + (_e60.projection.row_w.y * _e219.y)) + (_e60.projection.row_w.z * _e219.z)) + (_e60.projection.row_w.w * 1f));
            let _e251 = (((((_e60.projection.row_x.x * _e219.x) + (_e60.projection.row_x.y * _e219.y)) + (_e60.projection.row_x.z * _e219.z)) + (_e60.projection.row_x.w * 1f)) / _e237);
            let _e265 = (((((_e60.projection.row_y.x * _e219.x) + (_e60.projection.row_y.y * _e219.y)) + (_e60.projection.row_y.z * _e219.z)) + (_e60.projection.row_y.w * 1f)) / _e237);
            let _e278 = ((((_e60.projection.row_z.x * _e219.x) + (_e60.projection.row_z.y * _e219.y)) + (_e60.projection.row_z.z * _e219.z)) + (_e60.projection.row_z.w * 1f));
            if (_e237 > 0f) {
                if (_e251 >= 0f) {
                    phi_557_ = (_e251 <= 1f);
                } else {
                    phi_557_ = false;
                }
                let _e283 = phi_557_;
                if _e283 {
                    if (_e265 >= 0f) {
                        phi_566_ = (_e265 <= 1f);
                    } else {
                        phi_566_ = false;
                    }
                    let _e287 = phi_566_;
                    if _e287 {
                        if (_e278 >= 0f) {
                            phi_575_ = (_e278 <= 1f);
                        } else {
                            phi_575_ = false;
                        }
                        let _e291 = phi_575_;
                        phi_576_ = _e291;
                        phi_577_ = false;
                    } else {
                        phi_576_ = bool();
                        phi_577_ = true;
                    }
                    let _e293 = phi_576_;
                    let _e295 = phi_577_;
                    phi_578_ = _e293;
                    phi_579_ = _e295;
                } else {
                    phi_578_ = bool();
                    phi_579_ = true;
                }
                let _e297 = phi_578_;
                let _e299 = phi_579_;
                phi_580_ = _e297;
                phi_581_ = _e299;
            } else {
                phi_580_ = bool();
                phi_581_ = true;
            }
            let _e301 = phi_580_;
            let _e303 = phi_581_;
            if _e303 {
                phi_585_ = false;
            } else {
                phi_585_ = _e301;
            }
            let _e305 = phi_585_;
            if _e305 {
                if (0f > 0f) {
                    let _e308 = samples.member[(0u + _e50.first_primitive)].normal;
                    let _e310 = p.member.map_size;
                    let _e380 = ((abs(((((_e56.row_x.x * _e308.x) + (_e56.row_x.y * _e308.y)) + (_e56.row_x.z * _e308.z)) / (((_e56.row_x.x * _e56.row_x.x) + (_e56.row_x.y * _e56.row_x.y)) + (_e56.row_x.z * _e56.row_x.z)))) + abs(((((_e56.row_y.x * _e308.x) + (_e56.row_y.y * _e308.y)) + (_e56.row_y.z * _e308.z)) / (((_e56.row_y.x * _e56.row_y.x) + (_e56.row_y.y * _e56.row_y.y)) + (_e56.row_y.z * _e56.row_y.z))))) / (abs(((((_e56.row_z.x * _e308.x) + (_e56.row_z.y * _e308.y)) + (_e56.row_z.z * _e308.z)) / (((_e56.row_z.x * _e56.row_z.x) + (_e56.row_z.y * _e56.row_z.y)) + (_e56.row_z.z * _e56.row_z.z)))) * f32(_e310)));
                    if (_e380 < 0.002f) {
                        phi_675_ = _e380;
                    } else {
                        phi_675_ = 0.002f;
                    }
                    let _e383 = phi_675_;
                    phi_678_ = (_e278 - (0f * _e383));
                } else {
                    phi_678_ = _e278;
                }
                let _e387 = phi_678_;
                let _e389 = p.member.map_size;
                let _e390 = f32(_e389);
                let _e393 = ((_e251 * _e390) - 0.5f);
                let _e394 = ((_e265 * _e390) - 0.5f);
                if (_e393 > -8388608f) {
                    let _e406 = f32(select(0i, select(select(i32(_e393), i32(-2147483648), (_e393 < bitcast<f32>(3472883712u))), 2147483647i, (_e393 > bitcast<f32>(1325400063u))), (_e393 == _e393)));
                    if (_e406 > _e393) {
                        phi_707_ = 1f;
                    } else {
                        phi_707_ = 0f;
                    }
                    let _e409 = phi_707_;
                    if (_e393 < 8388608f) {
                        phi_712_ = (_e406 - _e409);
                        phi_713_ = false;
                    } else {
                        phi_712_ = f32();
                        phi_713_ = true;
                    }
                    let _e412 = phi_712_;
                    let _e414 = phi_713_;
                    phi_714_ = _e412;
                    phi_715_ = _e414;
                } else {
                    phi_714_ = f32();
                    phi_715_ = true;
                }
                let _e416 = phi_714_;
                let _e418 = phi_715_;
                if _e418 {
                    phi_719_ = _e393;
                } else {
                    phi_719_ = _e416;
                }
                let _e420 = phi_719_;
                if (_e394 > -8388608f) {
                    let _e432 = f32(select(0i, select(select(i32(_e394), i32(-2147483648), (_e394 < bitcast<f32>(3472883712u))), 2147483647i, (_e394 > bitcast<f32>(1325400063u))), (_e394 == _e394)));
                    if (_e432 > _e394) {
                        phi_739_ = 1f;
                    } else {
                        phi_739_ = 0f;
                    }
                    let _e435 = phi_739_;
                    if (_e394 < 8388608f) {
                        phi_744_ = (_e432 - _e435);
                        phi_745_ = false;
                    } else {
                        phi_744_ = f32();
                        phi_745_ = true;
                    }
                    let _e438 = phi_744_;
                    let _e440 = phi_745_;
                    phi_746_ = _e438;
                    phi_747_ = _e440;
                } else {
                    phi_746_ = f32();
                    phi_747_ = true;
                }
                let _e442 = phi_746_;
                let _e444 = phi_747_;
                if _e444 {
                    phi_751_ = _e394;
                } else {
                    phi_751_ = _e442;
                }
                let _e446 = phi_751_;
                let _e447 = (_e393 - _e420);
                let _e448 = (_e394 - _e446);
                let _e457 = select(0i, select(select(i32(_e420), i32(-2147483648), (_e420 < bitcast<f32>(3472883712u))), 2147483647i, (_e420 > bitcast<f32>(1325400063u))), (_e420 == _e420));
                let _e466 = select(0i, select(select(i32(_e446), i32(-2147483648), (_e446 < bitcast<f32>(3472883712u))), 2147483647i, (_e446 > bitcast<f32>(1325400063u))), (_e446 == _e446));
                let _e477 = p.member.test;
                let _e478 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e477);
                let _e480 = p.member.map_size;
                local = _e478;
                let _e482 = ((0u * _e480) * _e480);
                let _e484 = (bitcast<i32>(_e480) - 1i);
                if (_e457 > 0i) {
                    phi_799_ = _e457;
                } else {
                    phi_799_ = 0i;
                }
                let _e487 = phi_799_;
                if (_e466 > 0i) {
                    phi_804_ = _e466;
                } else {
                    phi_804_ = 0i;
                }
                let _e490 = phi_804_;
                if (_e487 < _e484) {
                    phi_809_ = _e487;
                } else {
                    phi_809_ = _e484;
                }
                let _e493 = phi_809_;
                if (_e490 < _e484) {
                    phi_814_ = _e490;
                } else {
                    phi_814_ = _e484;
                }
                let _e496 = phi_814_;
                let _e497 = bitcast<u32>(_e493);
                let _e499 = (_e457 + 1i);
                let _e500 = (_e466 + 1i);
                if (_e499 > 0i) {
                    phi_823_ = _e499;
                } else {
                    phi_823_ = 0i;
                }
                let _e503 = phi_823_;
                if (_e500 > 0i) {
                    phi_828_ = _e500;
                } else {
                    phi_828_ = 0i;
                }
                let _e506 = phi_828_;
                if (_e503 < _e484) {
                    phi_833_ = _e503;
                } else {
                    phi_833_ = _e484;
                }
                let _e509 = phi_833_;
                if (_e506 < _e484) {
                    phi_838_ = _e506;
                } else {
                    phi_838_ = _e484;
                }
                let _e512 = phi_838_;
                let _e513 = bitcast<u32>(_e509);
                let _e515 = (bitcast<u32>(_e496) * _e480);
                let _e516 = (bitcast<u32>(_e512) * _e480);
                let _e521 = ((_e515 + _e497) + _e482);
                let _e522 = ((_e515 + _e513) + _e482);
                let _e523 = ((_e516 + _e497) + _e482);
                let _e524 = ((_e516 + _e513) + _e482);
                if (_e521 < _e41) {
                } else {
                    return;
                }
                let _e528 = map.member[(0u + _e521)];
                if (_e522 < _e41) {
                } else {
                    return;
                }
                let _e532 = map.member[(0u + _e522)];
                if (_e523 < _e41) {
                } else {
                    return;
                }
                let _e536 = map.member[(0u + _e523)];
                if (_e524 < _e41) {
                } else {
                    return;
                }
                let _e540 = map.member[(0u + _e524)];
                let _e542 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e528, _e532, _e536, _e540), vec4<f32>(((1f - _e447) * (1f - _e448)), (_e447 * (1f - _e448)), ((1f - _e447) * _e448), (_e447 * _e448)), _e387);
                let _e544 = p.member.epsilon;
                if (_e542 <= _e544) {
                    phi_889_ = true;
                } else {
                    phi_889_ = (_e542 >= (1f - _e544));
                }
                let _e549 = phi_889_;
                if ((bitcast<u32>(_e542) & 2147483647u) > 2139095040u) {
                    phi_897_ = true;
                } else {
                    phi_897_ = !(_e549);
                }
                let _e555 = phi_897_;
                if _e555 {
                    if (_e542 > 0f) {
                        if (_e542 < 1f) {
                            phi_909_ = false;
                        } else {
                            phi_909_ = true;
                        }
                        let _e559 = phi_909_;
                        phi_910_ = _e559;
                    } else {
                        phi_910_ = true;
                    }
                    let _e561 = phi_910_;
                    if _e561 {
                        phi_914_ = 0.5f;
                    } else {
                        phi_914_ = _e542;
                    }
                    let _e563 = phi_914_;
                    phi_922_ = evaluate_Verdict(_e563, true);
                } else {
                    if (_e542 > 0.5f) {
                        phi_920_ = 1f;
                    } else {
                        phi_920_ = 0f;
                    }
                    let _e567 = phi_920_;
                    phi_922_ = evaluate_Verdict(_e567, false);
                }
                let _e570 = phi_922_;
                phi_927_ = evaluate_Verdict(_e570.visibility, _e570.is_doubted);
            } else {
                phi_927_ = evaluate_Verdict(0.5f, true);
            }
            let _e576 = phi_927_;
            phi_928_ = _e576;
        }
        let _e578 = phi_928_;
        if (_e50.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e50.first_primitive)] = _e578.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_vsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
