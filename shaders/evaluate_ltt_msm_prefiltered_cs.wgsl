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
    var phi_150_: lt_bvh_traverse_Tree;
    var phi_151_: bool;
    var phi_152_: lt_bvh_traverse_Tree;
    var phi_153_: bool;
    var phi_158_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_150_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_151_ = false;
        } else {
            phi_150_ = lt_bvh_traverse_Tree();
            phi_151_ = true;
        }
        let _e48 = phi_150_;
        let _e50 = phi_151_;
        phi_152_ = _e48;
        phi_153_ = _e50;
    } else {
        phi_152_ = lt_bvh_traverse_Tree();
        phi_153_ = true;
    }
    let _e52 = phi_152_;
    let _e54 = phi_153_;
    if _e54 {
        phi_158_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_158_ = _e52;
    }
    let _e59 = phi_158_;
    return lt_bvh_traverse_Tree(_e59.root, _e59.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_to_light(param_4: vec3<f32>, param_5: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_5.x - (param_4.x * param_5.w)), (param_5.y - (param_4.y * param_5.w)), (param_5.z - (param_4.z * param_5.w)));
}

fn lt_shaders_evaluate_quad_indices(param_6: i32, param_7: i32, param_8: u32) -> array<u32, 4> {
    var phi_192_: i32;
    var phi_197_: i32;
    var phi_202_: i32;
    var phi_207_: i32;
    var phi_216_: i32;
    var phi_221_: i32;
    var phi_226_: i32;
    var phi_231_: i32;

    let _e39 = (bitcast<i32>(param_8) - 1i);
    if (param_6 > 0i) {
        phi_192_ = param_6;
    } else {
        phi_192_ = 0i;
    }
    let _e42 = phi_192_;
    if (param_7 > 0i) {
        phi_197_ = param_7;
    } else {
        phi_197_ = 0i;
    }
    let _e45 = phi_197_;
    if (_e42 < _e39) {
        phi_202_ = _e42;
    } else {
        phi_202_ = _e39;
    }
    let _e48 = phi_202_;
    if (_e45 < _e39) {
        phi_207_ = _e45;
    } else {
        phi_207_ = _e39;
    }
    let _e51 = phi_207_;
    let _e52 = bitcast<u32>(_e48);
    let _e54 = (param_6 + 1i);
    let _e55 = (param_7 + 1i);
    if (_e54 > 0i) {
        phi_216_ = _e54;
    } else {
        phi_216_ = 0i;
    }
    let _e58 = phi_216_;
    if (_e55 > 0i) {
        phi_221_ = _e55;
    } else {
        phi_221_ = 0i;
    }
    let _e61 = phi_221_;
    if (_e58 < _e39) {
        phi_226_ = _e58;
    } else {
        phi_226_ = _e39;
    }
    let _e64 = phi_226_;
    if (_e61 < _e39) {
        phi_231_ = _e61;
    } else {
        phi_231_ = _e39;
    }
    let _e67 = phi_231_;
    let _e68 = bitcast<u32>(_e64);
    let _e70 = (bitcast<u32>(_e51) * param_8);
    let _e71 = (bitcast<u32>(_e67) * param_8);
    return array<u32, 4>((_e70 + _e52), (_e70 + _e68), (_e71 + _e52), (_e71 + _e68));
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_9: ptr<function, f32>, param_10: vec4<f32>, param_11: f32) -> f32 {
    var phi_283_: f32;
    var phi_284_: f32;
    var phi_285_: f32;
    var phi_308_: f32;
    var phi_309_: f32;
    var phi_310_: f32;
    var phi_311_: f32;
    var phi_312_: bool;
    var phi_313_: f32;
    var phi_314_: bool;
    var phi_352_: vec2<f32>;
    var phi_386_: f32;
    var phi_387_: f32;
    var phi_388_: f32;
    var phi_417_: f32;
    var phi_418_: f32;
    var phi_419_: f32;
    var phi_423_: f32;
    var phi_424_: f32;
    var phi_425_: f32;
    var phi_426_: f32;

    let _e38 = (*param_9);
    let _e39 = (1f - _e38);
    let _e48 = (0.5f * _e38);
    let _e49 = ((param_10.x * _e39) + _e48);
    let _e50 = ((param_10.y * _e39) + _e48);
    let _e52 = ((param_10.w * _e39) + _e48);
    let _e54 = (_e50 - (_e49 * _e49));
    let _e56 = (((param_10.z * _e39) + _e48) - (_e49 * _e50));
    if ((bitcast<u32>(param_11) & 2147483647u) > 2139095040u) {
        phi_285_ = param_11;
    } else {
        if (param_11 < 0f) {
            phi_284_ = 0f;
        } else {
            if (param_11 > 1f) {
                phi_283_ = 1f;
            } else {
                phi_283_ = param_11;
            }
            let _e68 = phi_283_;
            phi_284_ = _e68;
        }
        let _e70 = phi_284_;
        phi_285_ = _e70;
    }
    let _e72 = phi_285_;
    if (_e49 == _e52) {
        if (_e72 > 0f) {
            if ((bitcast<u32>(_e49) & 2147483647u) > 2139095040u) {
                phi_310_ = _e49;
            } else {
                if (_e49 < 0f) {
                    phi_309_ = 0f;
                } else {
                    if (_e49 > 1f) {
                        phi_308_ = 1f;
                    } else {
                        phi_308_ = _e49;
                    }
                    let _e81 = phi_308_;
                    phi_309_ = _e81;
                }
                let _e83 = phi_309_;
                phi_310_ = _e83;
            }
            let _e85 = phi_310_;
            phi_311_ = _e85;
            phi_312_ = false;
        } else {
            phi_311_ = f32();
            phi_312_ = true;
        }
        let _e87 = phi_311_;
        let _e89 = phi_312_;
        phi_313_ = _e87;
        phi_314_ = _e89;
    } else {
        phi_313_ = f32();
        phi_314_ = true;
    }
    let _e91 = phi_313_;
    let _e93 = phi_314_;
    if _e93 {
        let _e94 = (_e56 / _e54);
        let _e95 = (_e72 - _e49);
        let _e101 = (((((_e72 * _e72) - _e50) - (_e94 * _e95)) * _e54) / (((_e52 - (_e50 * _e50)) * _e54) - (_e56 * _e56)));
        let _e104 = ((_e95 / _e54) - (_e94 * _e101));
        let _e110 = ((0.5f * _e104) / _e101);
        let _e113 = ((_e110 * _e110) - (((1f - (_e104 * _e49)) - (_e101 * _e50)) / _e101));
        if (_e113 >= 0f) {
            let _e115 = sqrt(_e113);
            phi_352_ = vec2<f32>((-(_e110) - _e115), (-(_e110) + _e115));
        } else {
            phi_352_ = vec2(bitcast<f32>((bitcast<u32>(_e113) | 2143289344u)));
        }
        let _e126 = phi_352_;
        if (_e72 <= _e126.x) {
            phi_425_ = 1f;
        } else {
            if (_e72 > _e126.y) {
                let _e139 = (((_e50 - (_e49 * (_e126.x + _e126.y))) + (_e126.x * _e126.y)) / ((_e72 - _e126.x) * (_e72 - _e126.y)));
                if ((bitcast<u32>(_e139) & 2147483647u) > 2139095040u) {
                    phi_388_ = _e139;
                } else {
                    if (_e139 < 0f) {
                        phi_387_ = 0f;
                    } else {
                        if (_e139 > 1f) {
                            phi_386_ = 1f;
                        } else {
                            phi_386_ = _e139;
                        }
                        let _e146 = phi_386_;
                        phi_387_ = _e146;
                    }
                    let _e148 = phi_387_;
                    phi_388_ = _e148;
                }
                let _e150 = phi_388_;
                phi_424_ = _e150;
            } else {
                if (_e72 > _e126.x) {
                    let _e161 = (1f - (((_e50 - (_e49 * (_e72 + _e126.y))) + (_e72 * _e126.y)) / ((_e126.x - _e72) * (_e126.x - _e126.y))));
                    if ((bitcast<u32>(_e161) & 2147483647u) > 2139095040u) {
                        phi_419_ = _e161;
                    } else {
                        if (_e161 < 0f) {
                            phi_418_ = 0f;
                        } else {
                            if (_e161 > 1f) {
                                phi_417_ = 1f;
                            } else {
                                phi_417_ = _e161;
                            }
                            let _e168 = phi_417_;
                            phi_418_ = _e168;
                        }
                        let _e170 = phi_418_;
                        phi_419_ = _e170;
                    }
                    let _e172 = phi_419_;
                    phi_423_ = _e172;
                } else {
                    phi_423_ = bitcast<f32>((bitcast<u32>(_e126.x) | 2143289344u));
                }
                let _e177 = phi_423_;
                phi_424_ = _e177;
            }
            let _e179 = phi_424_;
            phi_425_ = _e179;
        }
        let _e181 = phi_425_;
        phi_426_ = _e181;
    } else {
        phi_426_ = _e91;
    }
    let _e183 = phi_426_;
    return _e183;
}

fn function_() {
    var local_1: f32;
    var phi_480_: bool;
    var phi_481_: bool;
    var phi_482_: bool;
    var phi_483_: bool;
    var phi_487_: bool;
    var phi_522_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_526_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_619_: bool;
    var phi_620_: bool;
    var phi_621_: bool;
    var phi_622_: bool;
    var phi_623_: bool;
    var phi_624_: bool;
    var phi_625_: bool;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_628_: bool;
    var phi_629_: bool;
    var phi_630_: bool;
    var phi_634_: bool;
    var phi_779_: bool;
    var phi_787_: bool;
    var phi_792_: f32;
    var phi_795_: evaluate_Verdict;
    var phi_796_: evaluate_Verdict;
    var phi_800_: bool;
    var phi_801_: u32;
    var phi_807_: u32;

    let _e36 = id_1;
    let _e37 = local_2;
    let _e42 = arrayLength((&map.member));
    if (_e37 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e49 = p.member.size[0u];
    let _e51 = p.member.size[1u];
    let _e52 = lt_shaders_entry_pixel_index(_e36, _e49, _e51);
    if (bitcast<i32>(_e52.root) != 0i) {
        let _e59 = p.member.light;
        let _e62 = samples.member[_e52.first_primitive].normal[0u];
        let _e64 = global[0u];
        if (_e62 == _e64) {
            let _e67 = samples.member[_e52.first_primitive].normal[1u];
            let _e69 = global[1u];
            if (_e67 == _e69) {
                let _e72 = samples.member[_e52.first_primitive].normal[2u];
                let _e74 = global[2u];
                phi_480_ = (_e72 == _e74);
                phi_481_ = false;
            } else {
                phi_480_ = bool();
                phi_481_ = true;
            }
            let _e77 = phi_480_;
            let _e79 = phi_481_;
            phi_482_ = _e77;
            phi_483_ = _e79;
        } else {
            phi_482_ = bool();
            phi_483_ = true;
        }
        let _e81 = phi_482_;
        let _e83 = phi_483_;
        if _e83 {
            phi_487_ = false;
        } else {
            phi_487_ = _e81;
        }
        let _e85 = phi_487_;
        if !(_e85) {
            let _e88 = samples.member[_e52.first_primitive].normal;
            let _e90 = samples.member[_e52.first_primitive].position;
            let _e91 = lt_shaders_evaluate_to_light(_e90, _e59);
            if ((((_e88.x * _e91.x) + (_e88.y * _e91.y)) + (_e88.z * _e91.z)) > 0f) {
                let _e105 = samples.member[_e52.first_primitive].flags;
                let _e113 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e119 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e113.unnamed.visibility, false), _e113.unnamed_1);
                phi_522_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e119.unnamed, ((_e105 & 1u) == 0u));
            } else {
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e134 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e128.unnamed.visibility, false), _e128.unnamed_1);
                phi_522_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e134.unnamed, true);
            }
            let _e139 = phi_522_;
            phi_526_ = _e139;
        } else {
            let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e145.unnamed.visibility, false), _e145.unnamed_1);
            phi_526_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e151.unnamed, true);
        }
        let _e156 = phi_526_;
        if _e156.unnamed_1 {
            phi_796_ = evaluate_Verdict(_e156.unnamed.visibility, _e156.unnamed.is_doubted);
        } else {
            let _e164 = samples.member[_e52.first_primitive].position;
            let _e170 = p.member.projection.row_w;
            let _e181 = ((((_e170.x * _e164.x) + (_e170.y * _e164.y)) + (_e170.z * _e164.z)) + (_e170.w * 1f));
            let _e183 = p.member.projection.row_x;
            let _e195 = (((((_e183.x * _e164.x) + (_e183.y * _e164.y)) + (_e183.z * _e164.z)) + (_e183.w * 1f)) / _e181);
            let _e197 = p.member.projection.row_y;
            let _e209 = (((((_e197.x * _e164.x) + (_e197.y * _e164.y)) + (_e197.z * _e164.z)) + (_e197.w * 1f)) / _e181);
            let _e211 = p.member.projection.row_z;
            let _e222 = ((((_e211.x * _e164.x) + (_e211.y * _e164.y)) + (_e211.z * _e164.z)) + (_e211.w * 1f));
            if (_e181 > 0f) {
                if (_e195 >= 0f) {
                    if (_e195 <= 1f) {
                        if (_e209 >= 0f) {
                            if (_e209 <= 1f) {
                                if (_e222 >= 0f) {
                                    phi_619_ = (_e222 <= 1f);
                                    phi_620_ = false;
                                } else {
                                    phi_619_ = bool();
                                    phi_620_ = true;
                                }
                                let _e231 = phi_619_;
                                let _e233 = phi_620_;
                                phi_621_ = _e231;
                                phi_622_ = _e233;
                            } else {
                                phi_621_ = bool();
                                phi_622_ = true;
                            }
                            let _e235 = phi_621_;
                            let _e237 = phi_622_;
                            phi_623_ = _e235;
                            phi_624_ = _e237;
                        } else {
                            phi_623_ = bool();
                            phi_624_ = true;
                        }
                        let _e239 = phi_623_;
                        let _e241 = phi_624_;
                        phi_625_ = _e239;
                        phi_626_ = _e241;
                    } else {
                        phi_625_ = bool();
                        phi_626_ = true;
                    }
                    let _e243 = phi_625_;
                    let _e245 = phi_626_;
                    phi_627_ = _e243;
                    phi_628_ = _e245;
                } else {
                    phi_627_ = bool();
                    phi_628_ = true;
                }
                let _e247 = phi_627_;
                let _e249 = phi_628_;
                phi_629_ = _e247;
                phi_630_ = _e249;
            } else {
                phi_629_ = bool();
                phi_630_ = true;
            }
            let _e251 = phi_629_;
            let _e253 = phi_630_;
            if _e253 {
                phi_634_ = false;
            } else {
                phi_634_ = _e251;
            }
            let _e255 = phi_634_;
            if _e255 {
                let _e257 = p.member.map_size;
                let _e258 = f32(_e257);
                let _e261 = ((_e195 * _e258) - 0.5f);
                let _e262 = ((_e209 * _e258) - 0.5f);
                let _e263 = floor(_e261);
                let _e264 = floor(_e262);
                let _e265 = (_e261 - _e263);
                let _e266 = (_e262 - _e264);
                let _e287 = ((1f - _e265) * (1f - _e266));
                let _e289 = (_e265 * (1f - _e266));
                let _e291 = ((1f - _e265) * _e266);
                let _e292 = (_e265 * _e266);
                let _e294 = p.member.test;
                let _e295 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e294);
                let _e297 = p.member.map_size;
                local_1 = _e295;
                let _e298 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e263), i32(-2147483648), (_e263 < bitcast<f32>(3472883712u))), 2147483647i, (_e263 > bitcast<f32>(1325400063u))), (_e263 == _e263)), select(0i, select(select(i32(_e264), i32(-2147483648), (_e264 < bitcast<f32>(3472883712u))), 2147483647i, (_e264 > bitcast<f32>(1325400063u))), (_e264 == _e264)), _e297);
                if (_e298[0] < _e42) {
                } else {
                    return;
                }
                let _e303 = map.member[(0u + _e298[0])];
                if (_e298[1] < _e42) {
                } else {
                    return;
                }
                let _e316 = map.member[(0u + _e298[1])];
                if (_e298[2] < _e42) {
                } else {
                    return;
                }
                let _e333 = map.member[(0u + _e298[2])];
                if (_e298[3] < _e42) {
                } else {
                    return;
                }
                let _e350 = map.member[(0u + _e298[3])];
                let _e364 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e303.x * _e287) + (_e316.x * _e289)) + (_e333.x * _e291)) + (_e350.x * _e292)), ((((_e303.y * _e287) + (_e316.y * _e289)) + (_e333.y * _e291)) + (_e350.y * _e292)), ((((_e303.z * _e287) + (_e316.z * _e289)) + (_e333.z * _e291)) + (_e350.z * _e292)), ((((_e303.w * _e287) + (_e316.w * _e289)) + (_e333.w * _e291)) + (_e350.w * _e292))), _e222);
                let _e366 = p.member.epsilon;
                if (_e364 <= _e366) {
                    phi_779_ = true;
                } else {
                    phi_779_ = (_e364 >= (1f - _e366));
                }
                let _e371 = phi_779_;
                if ((bitcast<u32>(_e364) & 2147483647u) > 2139095040u) {
                    phi_787_ = true;
                } else {
                    phi_787_ = !(_e371);
                }
                let _e377 = phi_787_;
                if (_e364 > 0.5f) {
                    phi_792_ = 1f;
                } else {
                    phi_792_ = 0f;
                }
                let _e380 = phi_792_;
                phi_795_ = evaluate_Verdict(_e380, _e377);
            } else {
                phi_795_ = evaluate_Verdict(1f, true);
            }
            let _e384 = phi_795_;
            phi_796_ = _e384;
        }
        let _e386 = phi_796_;
        visibility.member[_e52.first_primitive] = _e386.visibility;
        phi_800_ = _e386.is_doubted;
        phi_801_ = _e52.first_primitive;
    } else {
        phi_800_ = false;
        phi_801_ = 0u;
    }
    let _e391 = phi_800_;
    let _e393 = phi_801_;
    if _e391 {
        let _e395 = atomicAdd((&shared_[0u]), 1u);
        phi_807_ = _e395;
    } else {
        phi_807_ = 0u;
    }
    let _e397 = phi_807_;
    workgroupBarrier();
    if (_e37 == 0u) {
        let _e401 = atomicLoad((&shared_[0u]));
        let _e402 = atomicAdd((&list.member[3u]), _e401);
        atomicStore((&shared_[1u]), _e402);
    }
    workgroupBarrier();
    if _e391 {
        let _e405 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e405) + _e397)]), _e393);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
