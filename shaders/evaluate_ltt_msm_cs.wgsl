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

struct type_43 {
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
var<storage, read_write> list: type_43;
var<workgroup> shared_: array<atomic<u32>, 2>;

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
        let _e50 = phi_147_;
        let _e52 = phi_148_;
        phi_149_ = _e50;
        phi_150_ = _e52;
    } else {
        phi_149_ = lt_bvh_traverse_Tree();
        phi_150_ = true;
    }
    let _e54 = phi_149_;
    let _e56 = phi_150_;
    if _e56 {
        phi_155_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_155_ = _e54;
    }
    let _e61 = phi_155_;
    return lt_bvh_traverse_Tree(_e61.root, _e61.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_178_: f32;
    var phi_179_: f32;
    var phi_180_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_180_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_179_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_178_ = 1f;
            } else {
                phi_178_ = param_4;
            }
            let _e44 = phi_178_;
            phi_179_ = _e44;
        }
        let _e46 = phi_179_;
        phi_180_ = _e46;
    }
    let _e48 = phi_180_;
    let _e49 = (_e48 * _e48);
    return vec4<f32>(_e48, _e49, (_e49 * _e48), (_e49 * _e49));
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_290_: f32;
    var phi_291_: f32;
    var phi_292_: f32;
    var phi_298_: bool;
    var phi_320_: f32;
    var phi_321_: f32;
    var phi_322_: f32;
    var phi_323_: f32;
    var phi_324_: bool;
    var phi_325_: f32;
    var phi_326_: bool;
    var phi_364_: vec2<f32>;
    var phi_398_: f32;
    var phi_399_: f32;
    var phi_400_: f32;
    var phi_429_: f32;
    var phi_430_: f32;
    var phi_431_: f32;
    var phi_435_: f32;
    var phi_436_: f32;
    var phi_437_: f32;
    var phi_438_: f32;

    let _e40 = (*param_5);
    let _e41 = (1f - _e40);
    let _e50 = (0.5f * _e40);
    let _e51 = ((param_6.x * _e41) + _e50);
    let _e52 = ((param_6.y * _e41) + _e50);
    let _e54 = ((param_6.w * _e41) + _e50);
    let _e56 = (_e52 - (_e51 * _e51));
    let _e58 = (((param_6.z * _e41) + _e50) - (_e51 * _e52));
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_292_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_291_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_290_ = 1f;
            } else {
                phi_290_ = param_7;
            }
            let _e70 = phi_290_;
            phi_291_ = _e70;
        }
        let _e72 = phi_291_;
        phi_292_ = _e72;
    }
    let _e74 = phi_292_;
    if (_e51 == _e54) {
        phi_298_ = (_e51 > 0.5f);
    } else {
        phi_298_ = false;
    }
    let _e78 = phi_298_;
    if _e78 {
        if (_e74 > 0f) {
            if ((bitcast<u32>(_e51) & 2147483647u) > 2139095040u) {
                phi_322_ = _e51;
            } else {
                if (_e51 < 0f) {
                    phi_321_ = 0f;
                } else {
                    if (_e51 > 1f) {
                        phi_320_ = 1f;
                    } else {
                        phi_320_ = _e51;
                    }
                    let _e86 = phi_320_;
                    phi_321_ = _e86;
                }
                let _e88 = phi_321_;
                phi_322_ = _e88;
            }
            let _e90 = phi_322_;
            phi_323_ = _e90;
            phi_324_ = false;
        } else {
            phi_323_ = f32();
            phi_324_ = true;
        }
        let _e92 = phi_323_;
        let _e94 = phi_324_;
        phi_325_ = _e92;
        phi_326_ = _e94;
    } else {
        phi_325_ = f32();
        phi_326_ = true;
    }
    let _e96 = phi_325_;
    let _e98 = phi_326_;
    if _e98 {
        let _e99 = (_e58 / _e56);
        let _e100 = (_e74 - _e51);
        let _e106 = (((((_e74 * _e74) - _e52) - (_e99 * _e100)) * _e56) / (((_e54 - (_e52 * _e52)) * _e56) - (_e58 * _e58)));
        let _e109 = ((_e100 / _e56) - (_e99 * _e106));
        let _e115 = ((0.5f * _e109) / _e106);
        let _e118 = ((_e115 * _e115) - (((1f - (_e109 * _e51)) - (_e106 * _e52)) / _e106));
        if (_e118 >= 0f) {
            let _e120 = sqrt(_e118);
            phi_364_ = vec2<f32>((-(_e115) - _e120), (-(_e115) + _e120));
        } else {
            phi_364_ = vec2(bitcast<f32>((bitcast<u32>(_e118) | 2143289344u)));
        }
        let _e131 = phi_364_;
        if (_e74 <= _e131.x) {
            phi_437_ = 1f;
        } else {
            if (_e74 > _e131.y) {
                let _e144 = (((_e52 - (_e51 * (_e131.x + _e131.y))) + (_e131.x * _e131.y)) / ((_e74 - _e131.x) * (_e74 - _e131.y)));
                if ((bitcast<u32>(_e144) & 2147483647u) > 2139095040u) {
                    phi_400_ = _e144;
                } else {
                    if (_e144 < 0f) {
                        phi_399_ = 0f;
                    } else {
                        if (_e144 > 1f) {
                            phi_398_ = 1f;
                        } else {
                            phi_398_ = _e144;
                        }
                        let _e151 = phi_398_;
                        phi_399_ = _e151;
                    }
                    let _e153 = phi_399_;
                    phi_400_ = _e153;
                }
                let _e155 = phi_400_;
                phi_436_ = _e155;
            } else {
                if (_e74 > _e131.x) {
                    let _e166 = (1f - (((_e52 - (_e51 * (_e74 + _e131.y))) + (_e74 * _e131.y)) / ((_e131.x - _e74) * (_e131.x - _e131.y))));
                    if ((bitcast<u32>(_e166) & 2147483647u) > 2139095040u) {
                        phi_431_ = _e166;
                    } else {
                        if (_e166 < 0f) {
                            phi_430_ = 0f;
                        } else {
                            if (_e166 > 1f) {
                                phi_429_ = 1f;
                            } else {
                                phi_429_ = _e166;
                            }
                            let _e173 = phi_429_;
                            phi_430_ = _e173;
                        }
                        let _e175 = phi_430_;
                        phi_431_ = _e175;
                    }
                    let _e177 = phi_431_;
                    phi_435_ = _e177;
                } else {
                    phi_435_ = bitcast<f32>((bitcast<u32>(_e131.x) | 2143289344u));
                }
                let _e182 = phi_435_;
                phi_436_ = _e182;
            }
            let _e184 = phi_436_;
            phi_437_ = _e184;
        }
        let _e186 = phi_437_;
        phi_438_ = _e186;
    } else {
        phi_438_ = _e96;
    }
    let _e188 = phi_438_;
    return _e188;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_8: ptr<function, f32>, param_9: vec4<f32>, param_10: vec4<f32>, param_11: f32) -> f32 {
    let _e42 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_9.x);
    let _e44 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_9.y);
    let _e46 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_9.z);
    let _e48 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_9.w);
    let _e98 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_8, vec4<f32>(((((_e42.x * param_10.x) + (_e44.x * param_10.y)) + (_e46.x * param_10.z)) + (_e48.x * param_10.w)), ((((_e42.y * param_10.x) + (_e44.y * param_10.y)) + (_e46.y * param_10.z)) + (_e48.y * param_10.w)), ((((_e42.z * param_10.x) + (_e44.z * param_10.y)) + (_e46.z * param_10.z)) + (_e48.z * param_10.w)), ((((_e42.w * param_10.x) + (_e44.w * param_10.y)) + (_e46.w * param_10.z)) + (_e48.w * param_10.w))), param_11);
    return _e98;
}

fn function_() {
    var local_1: f32;
    var phi_492_: bool;
    var phi_493_: bool;
    var phi_494_: bool;
    var phi_495_: bool;
    var phi_499_: bool;
    var phi_543_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_547_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_624_: bool;
    var phi_633_: bool;
    var phi_642_: bool;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_652_: bool;
    var phi_688_: f32;
    var phi_693_: f32;
    var phi_694_: bool;
    var phi_695_: f32;
    var phi_696_: bool;
    var phi_700_: f32;
    var phi_720_: f32;
    var phi_725_: f32;
    var phi_726_: bool;
    var phi_727_: f32;
    var phi_728_: bool;
    var phi_732_: f32;
    var phi_778_: i32;
    var phi_783_: i32;
    var phi_788_: i32;
    var phi_793_: i32;
    var phi_802_: i32;
    var phi_807_: i32;
    var phi_812_: i32;
    var phi_817_: i32;
    var phi_864_: bool;
    var phi_872_: bool;
    var phi_877_: f32;
    var phi_880_: evaluate_Verdict;
    var phi_881_: evaluate_Verdict;
    var phi_885_: bool;
    var phi_886_: u32;
    var phi_892_: u32;

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
                phi_492_ = (_e74 == _e76);
                phi_493_ = false;
            } else {
                phi_492_ = bool();
                phi_493_ = true;
            }
            let _e79 = phi_492_;
            let _e81 = phi_493_;
            phi_494_ = _e79;
            phi_495_ = _e81;
        } else {
            phi_494_ = bool();
            phi_495_ = true;
        }
        let _e83 = phi_494_;
        let _e85 = phi_495_;
        if _e85 {
            phi_499_ = false;
        } else {
            phi_499_ = _e83;
        }
        let _e87 = phi_499_;
        if !(_e87) {
            let _e90 = samples.member[_e54.first_primitive].normal;
            let _e92 = samples.member[_e54.first_primitive].position;
            if ((((_e90.x * (_e61.x - (_e92.x * _e61.w))) + (_e90.y * (_e61.y - (_e92.y * _e61.w)))) + (_e90.z * (_e61.z - (_e92.z * _e61.w)))) > 0f) {
                let _e116 = samples.member[_e54.first_primitive].flags;
                let _e124 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e130 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e124.unnamed.visibility, false), _e124.unnamed_1);
                phi_543_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e130.unnamed, ((_e116 & 1u) == 0u));
            } else {
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e139.unnamed.visibility, false), _e139.unnamed_1);
                phi_543_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e145.unnamed, true);
            }
            let _e150 = phi_543_;
            phi_547_ = _e150;
        } else {
            let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e156.unnamed.visibility, false), _e156.unnamed_1);
            phi_547_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e162.unnamed, true);
        }
        let _e167 = phi_547_;
        if _e167.unnamed_1 {
            phi_881_ = evaluate_Verdict(_e167.unnamed.visibility, _e167.unnamed.is_doubted);
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
                    phi_624_ = (_e206 <= 1f);
                } else {
                    phi_624_ = false;
                }
                let _e238 = phi_624_;
                if _e238 {
                    if (_e220 >= 0f) {
                        phi_633_ = (_e220 <= 1f);
                    } else {
                        phi_633_ = false;
                    }
                    let _e242 = phi_633_;
                    if _e242 {
                        if (_e233 >= 0f) {
                            phi_642_ = (_e233 <= 1f);
                        } else {
                            phi_642_ = false;
                        }
                        let _e246 = phi_642_;
                        phi_643_ = _e246;
                        phi_644_ = false;
                    } else {
                        phi_643_ = bool();
                        phi_644_ = true;
                    }
                    let _e248 = phi_643_;
                    let _e250 = phi_644_;
                    phi_645_ = _e248;
                    phi_646_ = _e250;
                } else {
                    phi_645_ = bool();
                    phi_646_ = true;
                }
                let _e252 = phi_645_;
                let _e254 = phi_646_;
                phi_647_ = _e252;
                phi_648_ = _e254;
            } else {
                phi_647_ = bool();
                phi_648_ = true;
            }
            let _e256 = phi_647_;
            let _e258 = phi_648_;
            if _e258 {
                phi_652_ = false;
            } else {
                phi_652_ = _e256;
            }
            let _e260 = phi_652_;
            if _e260 {
                let _e262 = p.member.map_size;
                let _e263 = f32(_e262);
                let _e266 = ((_e206 * _e263) - 0.5f);
                let _e267 = ((_e220 * _e263) - 0.5f);
                if (_e266 > -8388608f) {
                    let _e279 = f32(select(0i, select(select(i32(_e266), i32(-2147483648), (_e266 < bitcast<f32>(3472883712u))), 2147483647i, (_e266 > bitcast<f32>(1325400063u))), (_e266 == _e266)));
                    if (_e279 > _e266) {
                        phi_688_ = 1f;
                    } else {
                        phi_688_ = 0f;
                    }
                    let _e282 = phi_688_;
                    if (_e266 < 8388608f) {
                        phi_693_ = (_e279 - _e282);
                        phi_694_ = false;
                    } else {
                        phi_693_ = f32();
                        phi_694_ = true;
                    }
                    let _e285 = phi_693_;
                    let _e287 = phi_694_;
                    phi_695_ = _e285;
                    phi_696_ = _e287;
                } else {
                    phi_695_ = f32();
                    phi_696_ = true;
                }
                let _e289 = phi_695_;
                let _e291 = phi_696_;
                if _e291 {
                    phi_700_ = _e266;
                } else {
                    phi_700_ = _e289;
                }
                let _e293 = phi_700_;
                if (_e267 > -8388608f) {
                    let _e305 = f32(select(0i, select(select(i32(_e267), i32(-2147483648), (_e267 < bitcast<f32>(3472883712u))), 2147483647i, (_e267 > bitcast<f32>(1325400063u))), (_e267 == _e267)));
                    if (_e305 > _e267) {
                        phi_720_ = 1f;
                    } else {
                        phi_720_ = 0f;
                    }
                    let _e308 = phi_720_;
                    if (_e267 < 8388608f) {
                        phi_725_ = (_e305 - _e308);
                        phi_726_ = false;
                    } else {
                        phi_725_ = f32();
                        phi_726_ = true;
                    }
                    let _e311 = phi_725_;
                    let _e313 = phi_726_;
                    phi_727_ = _e311;
                    phi_728_ = _e313;
                } else {
                    phi_727_ = f32();
                    phi_728_ = true;
                }
                let _e315 = phi_727_;
                let _e317 = phi_728_;
                if _e317 {
                    phi_732_ = _e267;
                } else {
                    phi_732_ = _e315;
                }
                let _e319 = phi_732_;
                let _e320 = (_e266 - _e293);
                let _e321 = (_e267 - _e319);
                let _e330 = select(0i, select(select(i32(_e293), i32(-2147483648), (_e293 < bitcast<f32>(3472883712u))), 2147483647i, (_e293 > bitcast<f32>(1325400063u))), (_e293 == _e293));
                let _e339 = select(0i, select(select(i32(_e319), i32(-2147483648), (_e319 < bitcast<f32>(3472883712u))), 2147483647i, (_e319 > bitcast<f32>(1325400063u))), (_e319 == _e319));
                let _e350 = p.member.test;
                let _e351 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e350);
                let _e353 = p.member.map_size;
                local_1 = _e351;
                let _e355 = (bitcast<i32>(_e353) - 1i);
                if (_e330 > 0i) {
                    phi_778_ = _e330;
                } else {
                    phi_778_ = 0i;
                }
                let _e358 = phi_778_;
                if (_e339 > 0i) {
                    phi_783_ = _e339;
                } else {
                    phi_783_ = 0i;
                }
                let _e361 = phi_783_;
                if (_e358 < _e355) {
                    phi_788_ = _e358;
                } else {
                    phi_788_ = _e355;
                }
                let _e364 = phi_788_;
                if (_e361 < _e355) {
                    phi_793_ = _e361;
                } else {
                    phi_793_ = _e355;
                }
                let _e367 = phi_793_;
                let _e368 = bitcast<u32>(_e364);
                let _e370 = (_e330 + 1i);
                let _e371 = (_e339 + 1i);
                if (_e370 > 0i) {
                    phi_802_ = _e370;
                } else {
                    phi_802_ = 0i;
                }
                let _e374 = phi_802_;
                if (_e371 > 0i) {
                    phi_807_ = _e371;
                } else {
                    phi_807_ = 0i;
                }
                let _e377 = phi_807_;
                if (_e374 < _e355) {
                    phi_812_ = _e374;
                } else {
                    phi_812_ = _e355;
                }
                let _e380 = phi_812_;
                if (_e377 < _e355) {
                    phi_817_ = _e377;
                } else {
                    phi_817_ = _e355;
                }
                let _e383 = phi_817_;
                let _e384 = bitcast<u32>(_e380);
                let _e386 = (bitcast<u32>(_e367) * _e353);
                let _e387 = (bitcast<u32>(_e383) * _e353);
                let _e388 = (_e386 + _e368);
                let _e389 = (_e386 + _e384);
                let _e390 = (_e387 + _e368);
                let _e391 = (_e387 + _e384);
                if (_e388 < _e44) {
                } else {
                    return;
                }
                let _e395 = map.member[(0u + _e388)];
                if (_e389 < _e44) {
                } else {
                    return;
                }
                let _e399 = map.member[(0u + _e389)];
                if (_e390 < _e44) {
                } else {
                    return;
                }
                let _e403 = map.member[(0u + _e390)];
                if (_e391 < _e44) {
                } else {
                    return;
                }
                let _e407 = map.member[(0u + _e391)];
                let _e409 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e395, _e399, _e403, _e407), vec4<f32>(((1f - _e320) * (1f - _e321)), (_e320 * (1f - _e321)), ((1f - _e320) * _e321), (_e320 * _e321)), _e233);
                let _e411 = p.member.epsilon;
                if (_e409 <= _e411) {
                    phi_864_ = true;
                } else {
                    phi_864_ = (_e409 >= (1f - _e411));
                }
                let _e416 = phi_864_;
                if ((bitcast<u32>(_e409) & 2147483647u) > 2139095040u) {
                    phi_872_ = true;
                } else {
                    phi_872_ = !(_e416);
                }
                let _e422 = phi_872_;
                if (_e409 > 0.5f) {
                    phi_877_ = 1f;
                } else {
                    phi_877_ = 0f;
                }
                let _e425 = phi_877_;
                phi_880_ = evaluate_Verdict(_e425, _e422);
            } else {
                phi_880_ = evaluate_Verdict(1f, true);
            }
            let _e429 = phi_880_;
            phi_881_ = _e429;
        }
        let _e431 = phi_881_;
        visibility.member[_e54.first_primitive] = _e431.visibility;
        phi_885_ = _e431.is_doubted;
        phi_886_ = _e54.first_primitive;
    } else {
        phi_885_ = false;
        phi_886_ = 0u;
    }
    let _e436 = phi_885_;
    let _e438 = phi_886_;
    if _e436 {
        let _e440 = atomicAdd((&shared_[0u]), 1u);
        phi_892_ = _e440;
    } else {
        phi_892_ = 0u;
    }
    let _e442 = phi_892_;
    workgroupBarrier();
    if (_e39 == 0u) {
        let _e446 = atomicLoad((&shared_[0u]));
        let _e447 = atomicAdd((&list.member[3u]), _e446);
        atomicStore((&shared_[1u]), _e447);
    }
    workgroupBarrier();
    if _e436 {
        let _e450 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e450) + _e442)]), _e438);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
