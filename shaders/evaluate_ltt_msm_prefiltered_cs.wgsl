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

struct type_48 {
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
var<storage, read_write> list: type_48;
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(2) 
var<storage> map: type_36;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_148_: lt_bvh_traverse_Tree;
    var phi_149_: bool;
    var phi_150_: lt_bvh_traverse_Tree;
    var phi_151_: bool;
    var phi_156_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_148_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_149_ = false;
        } else {
            phi_148_ = lt_bvh_traverse_Tree();
            phi_149_ = true;
        }
        let _e51 = phi_148_;
        let _e53 = phi_149_;
        phi_150_ = _e51;
        phi_151_ = _e53;
    } else {
        phi_150_ = lt_bvh_traverse_Tree();
        phi_151_ = true;
    }
    let _e55 = phi_150_;
    let _e57 = phi_151_;
    if _e57 {
        phi_156_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_156_ = _e55;
    }
    let _e62 = phi_156_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_205_: f32;
    var phi_206_: f32;
    var phi_207_: f32;
    var phi_213_: bool;
    var phi_235_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_239_: bool;
    var phi_240_: f32;
    var phi_241_: bool;
    var phi_279_: vec2<f32>;
    var phi_313_: f32;
    var phi_314_: f32;
    var phi_315_: f32;
    var phi_344_: f32;
    var phi_345_: f32;
    var phi_346_: f32;
    var phi_350_: f32;
    var phi_351_: f32;
    var phi_352_: f32;
    var phi_353_: f32;

    let _e41 = (*param_4);
    let _e42 = (1f - _e41);
    let _e51 = (0.5f * _e41);
    let _e52 = ((param_5.x * _e42) + _e51);
    let _e53 = ((param_5.y * _e42) + _e51);
    let _e55 = ((param_5.w * _e42) + _e51);
    let _e57 = (_e53 - (_e52 * _e52));
    let _e59 = (((param_5.z * _e42) + _e51) - (_e52 * _e53));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_207_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_206_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_205_ = 1f;
            } else {
                phi_205_ = param_6;
            }
            let _e71 = phi_205_;
            phi_206_ = _e71;
        }
        let _e73 = phi_206_;
        phi_207_ = _e73;
    }
    let _e75 = phi_207_;
    if (_e52 == _e55) {
        phi_213_ = (_e52 > 0.5f);
    } else {
        phi_213_ = false;
    }
    let _e79 = phi_213_;
    if _e79 {
        if (_e75 > 0f) {
            if ((bitcast<u32>(_e52) & 2147483647u) > 2139095040u) {
                phi_237_ = _e52;
            } else {
                if (_e52 < 0f) {
                    phi_236_ = 0f;
                } else {
                    if (_e52 > 1f) {
                        phi_235_ = 1f;
                    } else {
                        phi_235_ = _e52;
                    }
                    let _e87 = phi_235_;
                    phi_236_ = _e87;
                }
                let _e89 = phi_236_;
                phi_237_ = _e89;
            }
            let _e91 = phi_237_;
            phi_238_ = _e91;
            phi_239_ = false;
        } else {
            phi_238_ = f32();
            phi_239_ = true;
        }
        let _e93 = phi_238_;
        let _e95 = phi_239_;
        phi_240_ = _e93;
        phi_241_ = _e95;
    } else {
        phi_240_ = f32();
        phi_241_ = true;
    }
    let _e97 = phi_240_;
    let _e99 = phi_241_;
    if _e99 {
        let _e100 = (_e59 / _e57);
        let _e101 = (_e75 - _e52);
        let _e107 = (((((_e75 * _e75) - _e53) - (_e100 * _e101)) * _e57) / (((_e55 - (_e53 * _e53)) * _e57) - (_e59 * _e59)));
        let _e110 = ((_e101 / _e57) - (_e100 * _e107));
        let _e116 = ((0.5f * _e110) / _e107);
        let _e119 = ((_e116 * _e116) - (((1f - (_e110 * _e52)) - (_e107 * _e53)) / _e107));
        if (_e119 >= 0f) {
            let _e121 = sqrt(_e119);
            phi_279_ = vec2<f32>((-(_e116) - _e121), (-(_e116) + _e121));
        } else {
            phi_279_ = vec2(bitcast<f32>((bitcast<u32>(_e119) | 2143289344u)));
        }
        let _e132 = phi_279_;
        if (_e75 <= _e132.x) {
            phi_352_ = 1f;
        } else {
            if (_e75 > _e132.y) {
                let _e145 = (((_e53 - (_e52 * (_e132.x + _e132.y))) + (_e132.x * _e132.y)) / ((_e75 - _e132.x) * (_e75 - _e132.y)));
                if ((bitcast<u32>(_e145) & 2147483647u) > 2139095040u) {
                    phi_315_ = _e145;
                } else {
                    if (_e145 < 0f) {
                        phi_314_ = 0f;
                    } else {
                        if (_e145 > 1f) {
                            phi_313_ = 1f;
                        } else {
                            phi_313_ = _e145;
                        }
                        let _e152 = phi_313_;
                        phi_314_ = _e152;
                    }
                    let _e154 = phi_314_;
                    phi_315_ = _e154;
                }
                let _e156 = phi_315_;
                phi_351_ = _e156;
            } else {
                if (_e75 > _e132.x) {
                    let _e167 = (1f - (((_e53 - (_e52 * (_e75 + _e132.y))) + (_e75 * _e132.y)) / ((_e132.x - _e75) * (_e132.x - _e132.y))));
                    if ((bitcast<u32>(_e167) & 2147483647u) > 2139095040u) {
                        phi_346_ = _e167;
                    } else {
                        if (_e167 < 0f) {
                            phi_345_ = 0f;
                        } else {
                            if (_e167 > 1f) {
                                phi_344_ = 1f;
                            } else {
                                phi_344_ = _e167;
                            }
                            let _e174 = phi_344_;
                            phi_345_ = _e174;
                        }
                        let _e176 = phi_345_;
                        phi_346_ = _e176;
                    }
                    let _e178 = phi_346_;
                    phi_350_ = _e178;
                } else {
                    phi_350_ = bitcast<f32>((bitcast<u32>(_e132.x) | 2143289344u));
                }
                let _e183 = phi_350_;
                phi_351_ = _e183;
            }
            let _e185 = phi_351_;
            phi_352_ = _e185;
        }
        let _e187 = phi_352_;
        phi_353_ = _e187;
    } else {
        phi_353_ = _e97;
    }
    let _e189 = phi_353_;
    return _e189;
}

fn function_() {
    var local_1: f32;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_414_: bool;
    var phi_458_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_462_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_539_: bool;
    var phi_548_: bool;
    var phi_557_: bool;
    var phi_558_: bool;
    var phi_559_: bool;
    var phi_560_: bool;
    var phi_561_: bool;
    var phi_562_: bool;
    var phi_563_: bool;
    var phi_567_: bool;
    var phi_661_: f32;
    var phi_664_: f32;
    var phi_693_: f32;
    var phi_698_: f32;
    var phi_699_: bool;
    var phi_700_: f32;
    var phi_701_: bool;
    var phi_705_: f32;
    var phi_725_: f32;
    var phi_730_: f32;
    var phi_731_: bool;
    var phi_732_: f32;
    var phi_733_: bool;
    var phi_737_: f32;
    var phi_783_: i32;
    var phi_788_: i32;
    var phi_793_: i32;
    var phi_798_: i32;
    var phi_807_: i32;
    var phi_812_: i32;
    var phi_817_: i32;
    var phi_822_: i32;
    var phi_913_: bool;
    var phi_921_: bool;
    var phi_926_: f32;
    var phi_929_: evaluate_Verdict;
    var phi_930_: evaluate_Verdict;
    var phi_934_: bool;
    var phi_935_: u32;
    var phi_941_: u32;

    let _e39 = id_1;
    let _e40 = local_2;
    let _e45 = arrayLength((&map.member));
    if (_e40 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e52 = p.member.size[0u];
    let _e54 = p.member.size[1u];
    let _e55 = lt_shaders_entry_pixel_index(_e39, _e52, _e54);
    if (bitcast<i32>(_e55.root) != 0i) {
        let _e62 = p.member.light;
        let _e65 = samples.member[_e55.first_primitive].normal[0u];
        let _e67 = global[0u];
        if (_e65 == _e67) {
            let _e70 = samples.member[_e55.first_primitive].normal[1u];
            let _e72 = global[1u];
            if (_e70 == _e72) {
                let _e75 = samples.member[_e55.first_primitive].normal[2u];
                let _e77 = global[2u];
                phi_407_ = (_e75 == _e77);
                phi_408_ = false;
            } else {
                phi_407_ = bool();
                phi_408_ = true;
            }
            let _e80 = phi_407_;
            let _e82 = phi_408_;
            phi_409_ = _e80;
            phi_410_ = _e82;
        } else {
            phi_409_ = bool();
            phi_410_ = true;
        }
        let _e84 = phi_409_;
        let _e86 = phi_410_;
        if _e86 {
            phi_414_ = false;
        } else {
            phi_414_ = _e84;
        }
        let _e88 = phi_414_;
        if !(_e88) {
            let _e91 = samples.member[_e55.first_primitive].normal;
            let _e93 = samples.member[_e55.first_primitive].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[_e55.first_primitive].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_458_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_458_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_458_;
            phi_462_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_462_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_462_;
        if _e168.unnamed_1 {
            phi_930_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
        } else {
            let _e176 = samples.member[_e55.first_primitive].position;
            let _e182 = p.member.projection.row_w;
            let _e193 = ((((_e182.x * _e176.x) + (_e182.y * _e176.y)) + (_e182.z * _e176.z)) + (_e182.w * 1f));
            let _e195 = p.member.projection.row_x;
            let _e207 = (((((_e195.x * _e176.x) + (_e195.y * _e176.y)) + (_e195.z * _e176.z)) + (_e195.w * 1f)) / _e193);
            let _e209 = p.member.projection.row_y;
            let _e221 = (((((_e209.x * _e176.x) + (_e209.y * _e176.y)) + (_e209.z * _e176.z)) + (_e209.w * 1f)) / _e193);
            let _e223 = p.member.projection.row_z;
            let _e234 = ((((_e223.x * _e176.x) + (_e223.y * _e176.y)) + (_e223.z * _e176.z)) + (_e223.w * 1f));
            if (_e193 > 0f) {
                if (_e207 >= 0f) {
                    phi_539_ = (_e207 <= 1f);
                } else {
                    phi_539_ = false;
                }
                let _e239 = phi_539_;
                if _e239 {
                    if (_e221 >= 0f) {
                        phi_548_ = (_e221 <= 1f);
                    } else {
                        phi_548_ = false;
                    }
                    let _e243 = phi_548_;
                    if _e243 {
                        if (_e234 >= 0f) {
                            phi_557_ = (_e234 <= 1f);
                        } else {
                            phi_557_ = false;
                        }
                        let _e247 = phi_557_;
                        phi_558_ = _e247;
                        phi_559_ = false;
                    } else {
                        phi_558_ = bool();
                        phi_559_ = true;
                    }
                    let _e249 = phi_558_;
                    let _e251 = phi_559_;
                    phi_560_ = _e249;
                    phi_561_ = _e251;
                } else {
                    phi_560_ = bool();
                    phi_561_ = true;
                }
                let _e253 = phi_560_;
                let _e255 = phi_561_;
                phi_562_ = _e253;
                phi_563_ = _e255;
            } else {
                phi_562_ = bool();
                phi_563_ = true;
            }
            let _e257 = phi_562_;
            let _e259 = phi_563_;
            if _e259 {
                phi_567_ = false;
            } else {
                phi_567_ = _e257;
            }
            let _e261 = phi_567_;
            if _e261 {
                if (0f > 0f) {
                    let _e264 = samples.member[_e55.first_primitive].normal;
                    let _e266 = p.member.map_size;
                    let _e269 = p.member.projection.row_x;
                    let _e291 = p.member.projection.row_y;
                    let _e313 = p.member.projection.row_z;
                    let _e340 = ((abs(((((_e269.x * _e264.x) + (_e269.y * _e264.y)) + (_e269.z * _e264.z)) / (((_e269.x * _e269.x) + (_e269.y * _e269.y)) + (_e269.z * _e269.z)))) + abs(((((_e291.x * _e264.x) + (_e291.y * _e264.y)) + (_e291.z * _e264.z)) / (((_e291.x * _e291.x) + (_e291.y * _e291.y)) + (_e291.z * _e291.z))))) / (abs(((((_e313.x * _e264.x) + (_e313.y * _e264.y)) + (_e313.z * _e264.z)) / (((_e313.x * _e313.x) + (_e313.y * _e313.y)) + (_e313.z * _e313.z)))) * f32(_e266)));
                    if (_e340 < 0.002f) {
                        phi_661_ = _e340;
                    } else {
                        phi_661_ = 0.002f;
                    }
                    let _e343 = phi_661_;
                    phi_664_ = (_e234 - (0f * _e343));
                } else {
                    phi_664_ = _e234;
                }
                let _e347 = phi_664_;
                let _e349 = p.member.map_size;
                let _e350 = f32(_e349);
                let _e353 = ((_e207 * _e350) - 0.5f);
                let _e354 = ((_e221 * _e350) - 0.5f);
                if (_e353 > -8388608f) {
                    let _e366 = f32(select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < bitcast<f32>(3472883712u))), 2147483647i, (_e353 > bitcast<f32>(1325400063u))), (_e353 == _e353)));
                    if (_e366 > _e353) {
                        phi_693_ = 1f;
                    } else {
                        phi_693_ = 0f;
                    }
                    let _e369 = phi_693_;
                    if (_e353 < 8388608f) {
                        phi_698_ = (_e366 - _e369);
                        phi_699_ = false;
                    } else {
                        phi_698_ = f32();
                        phi_699_ = true;
                    }
                    let _e372 = phi_698_;
                    let _e374 = phi_699_;
                    phi_700_ = _e372;
                    phi_701_ = _e374;
                } else {
                    phi_700_ = f32();
                    phi_701_ = true;
                }
                let _e376 = phi_700_;
                let _e378 = phi_701_;
                if _e378 {
                    phi_705_ = _e353;
                } else {
                    phi_705_ = _e376;
                }
                let _e380 = phi_705_;
                if (_e354 > -8388608f) {
                    let _e392 = f32(select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < bitcast<f32>(3472883712u))), 2147483647i, (_e354 > bitcast<f32>(1325400063u))), (_e354 == _e354)));
                    if (_e392 > _e354) {
                        phi_725_ = 1f;
                    } else {
                        phi_725_ = 0f;
                    }
                    let _e395 = phi_725_;
                    if (_e354 < 8388608f) {
                        phi_730_ = (_e392 - _e395);
                        phi_731_ = false;
                    } else {
                        phi_730_ = f32();
                        phi_731_ = true;
                    }
                    let _e398 = phi_730_;
                    let _e400 = phi_731_;
                    phi_732_ = _e398;
                    phi_733_ = _e400;
                } else {
                    phi_732_ = f32();
                    phi_733_ = true;
                }
                let _e402 = phi_732_;
                let _e404 = phi_733_;
                if _e404 {
                    phi_737_ = _e354;
                } else {
                    phi_737_ = _e402;
                }
                let _e406 = phi_737_;
                let _e407 = (_e353 - _e380);
                let _e408 = (_e354 - _e406);
                let _e417 = select(0i, select(select(i32(_e380), i32(-2147483648), (_e380 < bitcast<f32>(3472883712u))), 2147483647i, (_e380 > bitcast<f32>(1325400063u))), (_e380 == _e380));
                let _e426 = select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406));
                let _e429 = ((1f - _e407) * (1f - _e408));
                let _e431 = (_e407 * (1f - _e408));
                let _e433 = ((1f - _e407) * _e408);
                let _e434 = (_e407 * _e408);
                let _e436 = p.member.test;
                let _e437 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e436);
                let _e439 = p.member.map_size;
                local_1 = _e437;
                let _e441 = (bitcast<i32>(_e439) - 1i);
                if (_e417 > 0i) {
                    phi_783_ = _e417;
                } else {
                    phi_783_ = 0i;
                }
                let _e444 = phi_783_;
                if (_e426 > 0i) {
                    phi_788_ = _e426;
                } else {
                    phi_788_ = 0i;
                }
                let _e447 = phi_788_;
                if (_e444 < _e441) {
                    phi_793_ = _e444;
                } else {
                    phi_793_ = _e441;
                }
                let _e450 = phi_793_;
                if (_e447 < _e441) {
                    phi_798_ = _e447;
                } else {
                    phi_798_ = _e441;
                }
                let _e453 = phi_798_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e417 + 1i);
                let _e457 = (_e426 + 1i);
                if (_e456 > 0i) {
                    phi_807_ = _e456;
                } else {
                    phi_807_ = 0i;
                }
                let _e460 = phi_807_;
                if (_e457 > 0i) {
                    phi_812_ = _e457;
                } else {
                    phi_812_ = 0i;
                }
                let _e463 = phi_812_;
                if (_e460 < _e441) {
                    phi_817_ = _e460;
                } else {
                    phi_817_ = _e441;
                }
                let _e466 = phi_817_;
                if (_e463 < _e441) {
                    phi_822_ = _e463;
                } else {
                    phi_822_ = _e441;
                }
                let _e469 = phi_822_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (bitcast<u32>(_e453) * _e439);
                let _e473 = (bitcast<u32>(_e469) * _e439);
                let _e474 = (_e472 + _e454);
                let _e475 = (_e472 + _e470);
                let _e476 = (_e473 + _e454);
                let _e477 = (_e473 + _e470);
                if (_e474 < _e45) {
                } else {
                    return;
                }
                let _e481 = map.member[(0u + _e474)];
                if (_e475 < _e45) {
                } else {
                    return;
                }
                let _e493 = map.member[(0u + _e475)];
                if (_e476 < _e45) {
                } else {
                    return;
                }
                let _e509 = map.member[(0u + _e476)];
                if (_e477 < _e45) {
                } else {
                    return;
                }
                let _e525 = map.member[(0u + _e477)];
                let _e539 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e481.x * _e429) + (_e493.x * _e431)) + (_e509.x * _e433)) + (_e525.x * _e434)), ((((_e481.y * _e429) + (_e493.y * _e431)) + (_e509.y * _e433)) + (_e525.y * _e434)), ((((_e481.z * _e429) + (_e493.z * _e431)) + (_e509.z * _e433)) + (_e525.z * _e434)), ((((_e481.w * _e429) + (_e493.w * _e431)) + (_e509.w * _e433)) + (_e525.w * _e434))), _e347);
                let _e541 = p.member.epsilon;
                if (_e539 <= _e541) {
                    phi_913_ = true;
                } else {
                    phi_913_ = (_e539 >= (1f - _e541));
                }
                let _e546 = phi_913_;
                if ((bitcast<u32>(_e539) & 2147483647u) > 2139095040u) {
                    phi_921_ = true;
                } else {
                    phi_921_ = !(_e546);
                }
                let _e552 = phi_921_;
                if (_e539 > 0.5f) {
                    phi_926_ = 1f;
                } else {
                    phi_926_ = 0f;
                }
                let _e555 = phi_926_;
                phi_929_ = evaluate_Verdict(_e555, _e552);
            } else {
                phi_929_ = evaluate_Verdict(1f, true);
            }
            let _e559 = phi_929_;
            phi_930_ = _e559;
        }
        let _e561 = phi_930_;
        visibility.member[_e55.first_primitive] = _e561.visibility;
        phi_934_ = _e561.is_doubted;
        phi_935_ = _e55.first_primitive;
    } else {
        phi_934_ = false;
        phi_935_ = 0u;
    }
    let _e566 = phi_934_;
    let _e568 = phi_935_;
    if _e566 {
        let _e570 = atomicAdd((&shared_[0u]), 1u);
        phi_941_ = _e570;
    } else {
        phi_941_ = 0u;
    }
    let _e572 = phi_941_;
    workgroupBarrier();
    if (_e40 == 0u) {
        let _e576 = atomicLoad((&shared_[0u]));
        let _e577 = atomicAdd((&list.member[3u]), _e576);
        atomicStore((&shared_[1u]), _e577);
    }
    workgroupBarrier();
    if _e566 {
        let _e580 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e580) + _e572)]), _e568);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
