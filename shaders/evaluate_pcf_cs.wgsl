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
    var phi_128_: lt_bvh_traverse_Tree;
    var phi_129_: bool;
    var phi_130_: lt_bvh_traverse_Tree;
    var phi_131_: bool;
    var phi_136_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_128_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_129_ = false;
        } else {
            phi_128_ = lt_bvh_traverse_Tree();
            phi_129_ = true;
        }
        let _e46 = phi_128_;
        let _e48 = phi_129_;
        phi_130_ = _e46;
        phi_131_ = _e48;
    } else {
        phi_130_ = lt_bvh_traverse_Tree();
        phi_131_ = true;
    }
    let _e50 = phi_130_;
    let _e52 = phi_131_;
    if _e52 {
        phi_136_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_136_ = _e50;
    }
    let _e57 = phi_136_;
    return lt_bvh_traverse_Tree(_e57.root, _e57.first_primitive);
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_3: ptr<function, f32>, param_4: vec4<f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_738_: f32;
    var phi_739_: f32;
    var phi_740_: f32;
    var phi_756_: f32;
    var phi_757_: f32;
    var phi_758_: f32;
    var phi_774_: f32;
    var phi_775_: f32;
    var phi_776_: f32;
    var phi_792_: f32;
    var phi_793_: f32;
    var phi_794_: f32;
    var phi_814_: f32;
    var phi_815_: f32;
    var phi_816_: f32;
    var phi_833_: f32;
    var phi_834_: f32;
    var phi_835_: f32;
    var phi_852_: f32;
    var phi_853_: f32;
    var phi_854_: f32;
    var phi_871_: f32;
    var phi_872_: f32;
    var phi_873_: f32;
    var phi_890_: f32;
    var phi_891_: f32;
    var phi_892_: f32;
    var phi_918_: f32;
    var phi_919_: f32;
    var phi_920_: f32;

    if ((bitcast<u32>(param_4.x) & 2147483647u) > 2139095040u) {
        phi_740_ = param_4.x;
    } else {
        if (param_4.x < 0f) {
            phi_739_ = 0f;
        } else {
            if (param_4.x > 1f) {
                phi_738_ = 1f;
            } else {
                phi_738_ = param_4.x;
            }
            let _e44 = phi_738_;
            phi_739_ = _e44;
        }
        let _e46 = phi_739_;
        phi_740_ = _e46;
    }
    let _e48 = phi_740_;
    if ((bitcast<u32>(param_4.y) & 2147483647u) > 2139095040u) {
        phi_758_ = param_4.y;
    } else {
        if (param_4.y < 0f) {
            phi_757_ = 0f;
        } else {
            if (param_4.y > 1f) {
                phi_756_ = 1f;
            } else {
                phi_756_ = param_4.y;
            }
            let _e56 = phi_756_;
            phi_757_ = _e56;
        }
        let _e58 = phi_757_;
        phi_758_ = _e58;
    }
    let _e60 = phi_758_;
    if ((bitcast<u32>(param_4.z) & 2147483647u) > 2139095040u) {
        phi_776_ = param_4.z;
    } else {
        if (param_4.z < 0f) {
            phi_775_ = 0f;
        } else {
            if (param_4.z > 1f) {
                phi_774_ = 1f;
            } else {
                phi_774_ = param_4.z;
            }
            let _e68 = phi_774_;
            phi_775_ = _e68;
        }
        let _e70 = phi_775_;
        phi_776_ = _e70;
    }
    let _e72 = phi_776_;
    if ((bitcast<u32>(param_4.w) & 2147483647u) > 2139095040u) {
        phi_794_ = param_4.w;
    } else {
        if (param_4.w < 0f) {
            phi_793_ = 0f;
        } else {
            if (param_4.w > 1f) {
                phi_792_ = 1f;
            } else {
                phi_792_ = param_4.w;
            }
            let _e80 = phi_792_;
            phi_793_ = _e80;
        }
        let _e82 = phi_793_;
        phi_794_ = _e82;
    }
    let _e84 = phi_794_;
    let _e85 = (*param_3);
    let _e86 = (_e48 + _e85);
    let _e87 = (_e60 + _e85);
    let _e88 = (_e72 + _e85);
    let _e89 = (_e84 + _e85);
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_816_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_815_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_814_ = 1f;
            } else {
                phi_814_ = param_6;
            }
            let _e96 = phi_814_;
            phi_815_ = _e96;
        }
        let _e98 = phi_815_;
        phi_816_ = _e98;
    }
    let _e100 = phi_816_;
    if ((bitcast<u32>(_e86) & 2147483647u) > 2139095040u) {
        phi_835_ = _e86;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_834_ = _e100;
        } else {
            if (_e86 < _e100) {
                phi_833_ = 0f;
            } else {
                phi_833_ = 1f;
            }
            let _e109 = phi_833_;
            phi_834_ = _e109;
        }
        let _e111 = phi_834_;
        phi_835_ = _e111;
    }
    let _e113 = phi_835_;
    if ((bitcast<u32>(_e87) & 2147483647u) > 2139095040u) {
        phi_854_ = _e87;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_853_ = _e100;
        } else {
            if (_e87 < _e100) {
                phi_852_ = 0f;
            } else {
                phi_852_ = 1f;
            }
            let _e122 = phi_852_;
            phi_853_ = _e122;
        }
        let _e124 = phi_853_;
        phi_854_ = _e124;
    }
    let _e126 = phi_854_;
    if ((bitcast<u32>(_e88) & 2147483647u) > 2139095040u) {
        phi_873_ = _e88;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_872_ = _e100;
        } else {
            if (_e88 < _e100) {
                phi_871_ = 0f;
            } else {
                phi_871_ = 1f;
            }
            let _e135 = phi_871_;
            phi_872_ = _e135;
        }
        let _e137 = phi_872_;
        phi_873_ = _e137;
    }
    let _e139 = phi_873_;
    if ((bitcast<u32>(_e89) & 2147483647u) > 2139095040u) {
        phi_892_ = _e89;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_891_ = _e100;
        } else {
            if (_e89 < _e100) {
                phi_890_ = 0f;
            } else {
                phi_890_ = 1f;
            }
            let _e148 = phi_890_;
            phi_891_ = _e148;
        }
        let _e150 = phi_891_;
        phi_892_ = _e150;
    }
    let _e152 = phi_892_;
    let _e163 = ((((_e113 * param_5.x) + (_e126 * param_5.y)) + (_e139 * param_5.z)) + (_e152 * param_5.w));
    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
        phi_920_ = _e163;
    } else {
        if (_e163 < 0f) {
            phi_919_ = 0f;
        } else {
            if (_e163 > 1f) {
                phi_918_ = 1f;
            } else {
                phi_918_ = _e163;
            }
            let _e170 = phi_918_;
            phi_919_ = _e170;
        }
        let _e172 = phi_919_;
        phi_920_ = _e172;
    }
    let _e174 = phi_920_;
    return _e174;
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_7: vec4<f32>) -> f32 {
    return param_7.x;
}

fn function_() {
    var local: f32;
    var phi_195_: bool;
    var phi_196_: bool;
    var phi_197_: bool;
    var phi_198_: bool;
    var phi_202_: bool;
    var phi_272_: bool;
    var phi_273_: bool;
    var phi_284_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_285_: bool;
    var phi_286_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_287_: bool;
    var phi_294_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_298_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_372_: bool;
    var phi_381_: bool;
    var phi_390_: bool;
    var phi_391_: bool;
    var phi_392_: bool;
    var phi_393_: bool;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_400_: bool;
    var phi_490_: f32;
    var phi_493_: f32;
    var phi_522_: f32;
    var phi_527_: f32;
    var phi_528_: bool;
    var phi_529_: f32;
    var phi_530_: bool;
    var phi_534_: f32;
    var phi_554_: f32;
    var phi_559_: f32;
    var phi_560_: bool;
    var phi_561_: f32;
    var phi_562_: bool;
    var phi_566_: f32;
    var phi_614_: i32;
    var phi_619_: i32;
    var phi_624_: i32;
    var phi_629_: i32;
    var phi_638_: i32;
    var phi_643_: i32;
    var phi_648_: i32;
    var phi_653_: i32;
    var phi_698_: evaluate_Verdict;
    var phi_699_: evaluate_Verdict;
    var phi_700_: bool;
    var phi_701_: evaluate_Verdict;
    var phi_702_: evaluate_Verdict;
    var phi_703_: bool;
    var phi_707_: evaluate_Verdict;

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
                phi_195_ = (_e74 == _e76);
                phi_196_ = false;
            } else {
                phi_195_ = bool();
                phi_196_ = true;
            }
            let _e79 = phi_195_;
            let _e81 = phi_196_;
            phi_197_ = _e79;
            phi_198_ = _e81;
        } else {
            phi_197_ = bool();
            phi_198_ = true;
        }
        let _e83 = phi_197_;
        let _e85 = phi_198_;
        if _e85 {
            phi_202_ = false;
        } else {
            phi_202_ = _e83;
        }
        let _e87 = phi_202_;
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
                    phi_273_ = true;
                } else {
                    let _e140 = p.member.light.range_squared;
                    if (_e123 <= _e140) {
                        let _e143 = p.member.light.cos_outer;
                        phi_272_ = (-((((_e105 * _e125.x) + (_e106 * _e125.y)) + (_e107 * _e125.z))) >= (_e143 * sqrt(_e123)));
                    } else {
                        phi_272_ = false;
                    }
                    let _e148 = phi_272_;
                    phi_273_ = _e148;
                }
                let _e150 = phi_273_;
                if _e150 {
                    let _e152 = samples.member[(0u + _e50.first_primitive)].flags;
                    let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e160.unnamed.visibility, false), _e160.unnamed_1);
                    phi_284_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e166.unnamed, ((_e152 & 1u) == 0u));
                    phi_285_ = false;
                } else {
                    phi_284_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_285_ = true;
                }
                let _e171 = phi_284_;
                let _e173 = phi_285_;
                phi_286_ = _e171;
                phi_287_ = _e173;
            } else {
                phi_286_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_287_ = true;
            }
            let _e175 = phi_286_;
            let _e177 = phi_287_;
            if _e177 {
                let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e189 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e183.unnamed.visibility, false), _e183.unnamed_1);
                phi_294_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e189.unnamed, true);
            } else {
                phi_294_ = _e175;
            }
            let _e194 = phi_294_;
            phi_298_ = _e194;
        } else {
            let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e200.unnamed.visibility, false), _e200.unnamed_1);
            phi_298_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e206.unnamed, true);
        }
        let _e211 = phi_298_;
        if _e211.unnamed_1 {
            phi_701_ = evaluate_Verdict(_e211.unnamed.visibility, _e211.unnamed.is_doubted);
            phi_702_ = evaluate_Verdict();
            phi_703_ = true;
        } else {
            let _e219 = samples.member[(0u + _e50.first_primitive)].position;
            let _e237 = ((((_e60.projection.row_w.x * _e219.x) + (_e60.projection.row_w.y * _e219.y)) + (_e60.projection.row_w.z * _e219.z)) + (_e60.projection.row_w.w * 1f));
            let _e251 = (((((_e60.projection.row_x.x * _e219.x) + (_e60.projection.row_x.y * _e219.y)) + (_e60.projection.row_x.z * _e219.z)) + (_e60.projection.row_x.w * 1f)) / _e237);
            let _e265 = (((((_e60.projection.row_y.x * _e219.x) + (_e60.projection.row_y.y * _e219.y)) + (_e60.projection.row_y.z * _e219.z)) + (_e60.projection.row_y.w * 1f)) / _e237);
            let _e278 = ((((_e60.projection.row_z.x * _e219.x) + (_e60.projection.row_z.y * _e219.y)) + (_e60.projection.row_z.z * _e219.z)) + (_e60.projection.row_z.w * 1f));
            if (_e237 > 0f) {
                if (_e251 >= 0f) {
                    phi_372_ = (_e251 <= 1f);
                } else {
                    phi_372_ = false;
                }
                let _e283 = phi_372_;
                if _e283 {
                    if (_e265 >= 0f) {
                        phi_381_ = (_e265 <= 1f);
                    } else {
                        phi_381_ = false;
                    }
                    let _e287 = phi_381_;
                    if _e287 {
                        if (_e278 >= 0f) {
                            phi_390_ = (_e278 <= 1f);
                        } else {
                            phi_390_ = false;
                        }
                        let _e291 = phi_390_;
                        phi_391_ = _e291;
                        phi_392_ = false;
                    } else {
                        phi_391_ = bool();
                        phi_392_ = true;
                    }
                    let _e293 = phi_391_;
                    let _e295 = phi_392_;
                    phi_393_ = _e293;
                    phi_394_ = _e295;
                } else {
                    phi_393_ = bool();
                    phi_394_ = true;
                }
                let _e297 = phi_393_;
                let _e299 = phi_394_;
                phi_395_ = _e297;
                phi_396_ = _e299;
            } else {
                phi_395_ = bool();
                phi_396_ = true;
            }
            let _e301 = phi_395_;
            let _e303 = phi_396_;
            if _e303 {
                phi_400_ = false;
            } else {
                phi_400_ = _e301;
            }
            let _e305 = phi_400_;
            if _e305 {
                if (1f > 0f) {
                    let _e308 = samples.member[(0u + _e50.first_primitive)].normal;
                    let _e310 = p.member.map_size;
                    let _e380 = ((abs(((((_e56.row_x.x * _e308.x) + (_e56.row_x.y * _e308.y)) + (_e56.row_x.z * _e308.z)) / (((_e56.row_x.x * _e56.row_x.x) + (_e56.row_x.y * _e56.row_x.y)) + (_e56.row_x.z * _e56.row_x.z)))) + abs(((((_e56.row_y.x * _e308.x) + (_e56.row_y.y * _e308.y)) + (_e56.row_y.z * _e308.z)) / (((_e56.row_y.x * _e56.row_y.x) + (_e56.row_y.y * _e56.row_y.y)) + (_e56.row_y.z * _e56.row_y.z))))) / (abs(((((_e56.row_z.x * _e308.x) + (_e56.row_z.y * _e308.y)) + (_e56.row_z.z * _e308.z)) / (((_e56.row_z.x * _e56.row_z.x) + (_e56.row_z.y * _e56.row_z.y)) + (_e56.row_z.z * _e56.row_z.z)))) * f32(_e310)));
                    if (_e380 < 0.002f) {
                        phi_490_ = _e380;
                    } else {
                        phi_490_ = 0.002f;
                    }
                    let _e383 = phi_490_;
                    phi_493_ = (_e278 - (1f * _e383));
                } else {
                    phi_493_ = _e278;
                }
                let _e387 = phi_493_;
                let _e389 = p.member.map_size;
                let _e390 = f32(_e389);
                let _e393 = ((_e251 * _e390) - 0.5f);
                let _e394 = ((_e265 * _e390) - 0.5f);
                if (_e393 > -8388608f) {
                    let _e406 = f32(select(0i, select(select(i32(_e393), i32(-2147483648), (_e393 < bitcast<f32>(3472883712u))), 2147483647i, (_e393 > bitcast<f32>(1325400063u))), (_e393 == _e393)));
                    if (_e406 > _e393) {
                        phi_522_ = 1f;
                    } else {
                        phi_522_ = 0f;
                    }
                    let _e409 = phi_522_;
                    if (_e393 < 8388608f) {
                        phi_527_ = (_e406 - _e409);
                        phi_528_ = false;
                    } else {
                        phi_527_ = f32();
                        phi_528_ = true;
                    }
                    let _e412 = phi_527_;
                    let _e414 = phi_528_;
                    phi_529_ = _e412;
                    phi_530_ = _e414;
                } else {
                    phi_529_ = f32();
                    phi_530_ = true;
                }
                let _e416 = phi_529_;
                let _e418 = phi_530_;
                if _e418 {
                    phi_534_ = _e393;
                } else {
                    phi_534_ = _e416;
                }
                let _e420 = phi_534_;
                if (_e394 > -8388608f) {
                    let _e432 = f32(select(0i, select(select(i32(_e394), i32(-2147483648), (_e394 < bitcast<f32>(3472883712u))), 2147483647i, (_e394 > bitcast<f32>(1325400063u))), (_e394 == _e394)));
                    if (_e432 > _e394) {
                        phi_554_ = 1f;
                    } else {
                        phi_554_ = 0f;
                    }
                    let _e435 = phi_554_;
                    if (_e394 < 8388608f) {
                        phi_559_ = (_e432 - _e435);
                        phi_560_ = false;
                    } else {
                        phi_559_ = f32();
                        phi_560_ = true;
                    }
                    let _e438 = phi_559_;
                    let _e440 = phi_560_;
                    phi_561_ = _e438;
                    phi_562_ = _e440;
                } else {
                    phi_561_ = f32();
                    phi_562_ = true;
                }
                let _e442 = phi_561_;
                let _e444 = phi_562_;
                if _e444 {
                    phi_566_ = _e394;
                } else {
                    phi_566_ = _e442;
                }
                let _e446 = phi_566_;
                let _e447 = (_e393 - _e420);
                let _e448 = (_e394 - _e446);
                let _e457 = select(0i, select(select(i32(_e420), i32(-2147483648), (_e420 < bitcast<f32>(3472883712u))), 2147483647i, (_e420 > bitcast<f32>(1325400063u))), (_e420 == _e420));
                let _e466 = select(0i, select(select(i32(_e446), i32(-2147483648), (_e446 < bitcast<f32>(3472883712u))), 2147483647i, (_e446 > bitcast<f32>(1325400063u))), (_e446 == _e446));
                let _e477 = p.member.test;
                let _e478 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e477);
                let _e480 = p.member.map_size;
                local = _e478;
                let _e482 = ((0u * _e480) * _e480);
                let _e484 = (bitcast<i32>(_e480) - 1i);
                if (_e457 > 0i) {
                    phi_614_ = _e457;
                } else {
                    phi_614_ = 0i;
                }
                let _e487 = phi_614_;
                if (_e466 > 0i) {
                    phi_619_ = _e466;
                } else {
                    phi_619_ = 0i;
                }
                let _e490 = phi_619_;
                if (_e487 < _e484) {
                    phi_624_ = _e487;
                } else {
                    phi_624_ = _e484;
                }
                let _e493 = phi_624_;
                if (_e490 < _e484) {
                    phi_629_ = _e490;
                } else {
                    phi_629_ = _e484;
                }
                let _e496 = phi_629_;
                let _e497 = bitcast<u32>(_e493);
                let _e499 = (_e457 + 1i);
                let _e500 = (_e466 + 1i);
                if (_e499 > 0i) {
                    phi_638_ = _e499;
                } else {
                    phi_638_ = 0i;
                }
                let _e503 = phi_638_;
                if (_e500 > 0i) {
                    phi_643_ = _e500;
                } else {
                    phi_643_ = 0i;
                }
                let _e506 = phi_643_;
                if (_e503 < _e484) {
                    phi_648_ = _e503;
                } else {
                    phi_648_ = _e484;
                }
                let _e509 = phi_648_;
                if (_e506 < _e484) {
                    phi_653_ = _e506;
                } else {
                    phi_653_ = _e484;
                }
                let _e512 = phi_653_;
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
                let _e542 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e528, _e532, _e536, _e540), vec4<f32>(((1f - _e447) * (1f - _e448)), (_e447 * (1f - _e448)), ((1f - _e447) * _e448), (_e447 * _e448)), _e387);
                phi_698_ = evaluate_Verdict(_e542, false);
                phi_699_ = evaluate_Verdict();
                phi_700_ = false;
            } else {
                phi_698_ = evaluate_Verdict();
                phi_699_ = evaluate_Verdict(1f, false);
                phi_700_ = true;
            }
            let _e546 = phi_698_;
            let _e548 = phi_699_;
            let _e550 = phi_700_;
            phi_701_ = _e548;
            phi_702_ = _e546;
            phi_703_ = _e550;
        }
        let _e552 = phi_701_;
        let _e554 = phi_702_;
        let _e556 = phi_703_;
        if _e556 {
            phi_707_ = _e552;
        } else {
            phi_707_ = _e554;
        }
        let _e558 = phi_707_;
        if (_e50.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e50.first_primitive)] = _e558.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_pcf_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
