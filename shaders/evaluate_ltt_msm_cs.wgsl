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
    var phi_145_: lt_bvh_traverse_Tree;
    var phi_146_: bool;
    var phi_147_: lt_bvh_traverse_Tree;
    var phi_148_: bool;
    var phi_153_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_145_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_146_ = false;
        } else {
            phi_145_ = lt_bvh_traverse_Tree();
            phi_146_ = true;
        }
        let _e51 = phi_145_;
        let _e53 = phi_146_;
        phi_147_ = _e51;
        phi_148_ = _e53;
    } else {
        phi_147_ = lt_bvh_traverse_Tree();
        phi_148_ = true;
    }
    let _e55 = phi_147_;
    let _e57 = phi_148_;
    if _e57 {
        phi_153_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_153_ = _e55;
    }
    let _e62 = phi_153_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_176_: f32;
    var phi_177_: f32;
    var phi_178_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_178_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_177_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_176_ = 1f;
            } else {
                phi_176_ = param_4;
            }
            let _e45 = phi_176_;
            phi_177_ = _e45;
        }
        let _e47 = phi_177_;
        phi_178_ = _e47;
    }
    let _e49 = phi_178_;
    let _e50 = (_e49 * _e49);
    return vec4<f32>(_e49, _e50, (_e50 * _e49), (_e50 * _e50));
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_225_: f32;
    var phi_226_: f32;
    var phi_227_: f32;
    var phi_233_: bool;
    var phi_255_: f32;
    var phi_256_: f32;
    var phi_257_: f32;
    var phi_258_: f32;
    var phi_259_: bool;
    var phi_260_: f32;
    var phi_261_: bool;
    var phi_299_: vec2<f32>;
    var phi_333_: f32;
    var phi_334_: f32;
    var phi_335_: f32;
    var phi_364_: f32;
    var phi_365_: f32;
    var phi_366_: f32;
    var phi_370_: f32;
    var phi_371_: f32;
    var phi_372_: f32;
    var phi_373_: f32;

    let _e41 = (*param_5);
    let _e42 = (1f - _e41);
    let _e51 = (0.5f * _e41);
    let _e52 = ((param_6.x * _e42) + _e51);
    let _e53 = ((param_6.y * _e42) + _e51);
    let _e55 = ((param_6.w * _e42) + _e51);
    let _e57 = (_e53 - (_e52 * _e52));
    let _e59 = (((param_6.z * _e42) + _e51) - (_e52 * _e53));
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_227_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_226_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_225_ = 1f;
            } else {
                phi_225_ = param_7;
            }
            let _e71 = phi_225_;
            phi_226_ = _e71;
        }
        let _e73 = phi_226_;
        phi_227_ = _e73;
    }
    let _e75 = phi_227_;
    if (_e52 == _e55) {
        phi_233_ = (_e52 > 0.5f);
    } else {
        phi_233_ = false;
    }
    let _e79 = phi_233_;
    if _e79 {
        if (_e75 > 0f) {
            if ((bitcast<u32>(_e52) & 2147483647u) > 2139095040u) {
                phi_257_ = _e52;
            } else {
                if (_e52 < 0f) {
                    phi_256_ = 0f;
                } else {
                    if (_e52 > 1f) {
                        phi_255_ = 1f;
                    } else {
                        phi_255_ = _e52;
                    }
                    let _e87 = phi_255_;
                    phi_256_ = _e87;
                }
                let _e89 = phi_256_;
                phi_257_ = _e89;
            }
            let _e91 = phi_257_;
            phi_258_ = _e91;
            phi_259_ = false;
        } else {
            phi_258_ = f32();
            phi_259_ = true;
        }
        let _e93 = phi_258_;
        let _e95 = phi_259_;
        phi_260_ = _e93;
        phi_261_ = _e95;
    } else {
        phi_260_ = f32();
        phi_261_ = true;
    }
    let _e97 = phi_260_;
    let _e99 = phi_261_;
    if _e99 {
        let _e100 = (_e59 / _e57);
        let _e101 = (_e75 - _e52);
        let _e107 = (((((_e75 * _e75) - _e53) - (_e100 * _e101)) * _e57) / (((_e55 - (_e53 * _e53)) * _e57) - (_e59 * _e59)));
        let _e110 = ((_e101 / _e57) - (_e100 * _e107));
        let _e116 = ((0.5f * _e110) / _e107);
        let _e119 = ((_e116 * _e116) - (((1f - (_e110 * _e52)) - (_e107 * _e53)) / _e107));
        if (_e119 >= 0f) {
            let _e121 = sqrt(_e119);
            phi_299_ = vec2<f32>((-(_e116) - _e121), (-(_e116) + _e121));
        } else {
            phi_299_ = vec2(bitcast<f32>((bitcast<u32>(_e119) | 2143289344u)));
        }
        let _e132 = phi_299_;
        if (_e75 <= _e132.x) {
            phi_372_ = 1f;
        } else {
            if (_e75 > _e132.y) {
                let _e145 = (((_e53 - (_e52 * (_e132.x + _e132.y))) + (_e132.x * _e132.y)) / ((_e75 - _e132.x) * (_e75 - _e132.y)));
                if ((bitcast<u32>(_e145) & 2147483647u) > 2139095040u) {
                    phi_335_ = _e145;
                } else {
                    if (_e145 < 0f) {
                        phi_334_ = 0f;
                    } else {
                        if (_e145 > 1f) {
                            phi_333_ = 1f;
                        } else {
                            phi_333_ = _e145;
                        }
                        let _e152 = phi_333_;
                        phi_334_ = _e152;
                    }
                    let _e154 = phi_334_;
                    phi_335_ = _e154;
                }
                let _e156 = phi_335_;
                phi_371_ = _e156;
            } else {
                if (_e75 > _e132.x) {
                    let _e167 = (1f - (((_e53 - (_e52 * (_e75 + _e132.y))) + (_e75 * _e132.y)) / ((_e132.x - _e75) * (_e132.x - _e132.y))));
                    if ((bitcast<u32>(_e167) & 2147483647u) > 2139095040u) {
                        phi_366_ = _e167;
                    } else {
                        if (_e167 < 0f) {
                            phi_365_ = 0f;
                        } else {
                            if (_e167 > 1f) {
                                phi_364_ = 1f;
                            } else {
                                phi_364_ = _e167;
                            }
                            let _e174 = phi_364_;
                            phi_365_ = _e174;
                        }
                        let _e176 = phi_365_;
                        phi_366_ = _e176;
                    }
                    let _e178 = phi_366_;
                    phi_370_ = _e178;
                } else {
                    phi_370_ = bitcast<f32>((bitcast<u32>(_e132.x) | 2143289344u));
                }
                let _e183 = phi_370_;
                phi_371_ = _e183;
            }
            let _e185 = phi_371_;
            phi_372_ = _e185;
        }
        let _e187 = phi_372_;
        phi_373_ = _e187;
    } else {
        phi_373_ = _e97;
    }
    let _e189 = phi_373_;
    return _e189;
}

fn function_() {
    var local_1: f32;
    var phi_427_: bool;
    var phi_428_: bool;
    var phi_429_: bool;
    var phi_430_: bool;
    var phi_434_: bool;
    var phi_478_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_482_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_559_: bool;
    var phi_568_: bool;
    var phi_577_: bool;
    var phi_578_: bool;
    var phi_579_: bool;
    var phi_580_: bool;
    var phi_581_: bool;
    var phi_582_: bool;
    var phi_583_: bool;
    var phi_587_: bool;
    var phi_681_: f32;
    var phi_684_: f32;
    var phi_713_: f32;
    var phi_718_: f32;
    var phi_719_: bool;
    var phi_720_: f32;
    var phi_721_: bool;
    var phi_725_: f32;
    var phi_745_: f32;
    var phi_750_: f32;
    var phi_751_: bool;
    var phi_752_: f32;
    var phi_753_: bool;
    var phi_757_: f32;
    var phi_803_: i32;
    var phi_808_: i32;
    var phi_813_: i32;
    var phi_818_: i32;
    var phi_827_: i32;
    var phi_832_: i32;
    var phi_837_: i32;
    var phi_842_: i32;
    var phi_937_: bool;
    var phi_945_: bool;
    var phi_950_: f32;
    var phi_953_: evaluate_Verdict;
    var phi_954_: evaluate_Verdict;
    var phi_958_: bool;
    var phi_959_: u32;
    var phi_965_: u32;

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
                phi_427_ = (_e75 == _e77);
                phi_428_ = false;
            } else {
                phi_427_ = bool();
                phi_428_ = true;
            }
            let _e80 = phi_427_;
            let _e82 = phi_428_;
            phi_429_ = _e80;
            phi_430_ = _e82;
        } else {
            phi_429_ = bool();
            phi_430_ = true;
        }
        let _e84 = phi_429_;
        let _e86 = phi_430_;
        if _e86 {
            phi_434_ = false;
        } else {
            phi_434_ = _e84;
        }
        let _e88 = phi_434_;
        if !(_e88) {
            let _e91 = samples.member[_e55.first_primitive].normal;
            let _e93 = samples.member[_e55.first_primitive].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[_e55.first_primitive].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_478_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_478_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_478_;
            phi_482_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_482_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_482_;
        if _e168.unnamed_1 {
            phi_954_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
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
                    phi_559_ = (_e207 <= 1f);
                } else {
                    phi_559_ = false;
                }
                let _e239 = phi_559_;
                if _e239 {
                    if (_e221 >= 0f) {
                        phi_568_ = (_e221 <= 1f);
                    } else {
                        phi_568_ = false;
                    }
                    let _e243 = phi_568_;
                    if _e243 {
                        if (_e234 >= 0f) {
                            phi_577_ = (_e234 <= 1f);
                        } else {
                            phi_577_ = false;
                        }
                        let _e247 = phi_577_;
                        phi_578_ = _e247;
                        phi_579_ = false;
                    } else {
                        phi_578_ = bool();
                        phi_579_ = true;
                    }
                    let _e249 = phi_578_;
                    let _e251 = phi_579_;
                    phi_580_ = _e249;
                    phi_581_ = _e251;
                } else {
                    phi_580_ = bool();
                    phi_581_ = true;
                }
                let _e253 = phi_580_;
                let _e255 = phi_581_;
                phi_582_ = _e253;
                phi_583_ = _e255;
            } else {
                phi_582_ = bool();
                phi_583_ = true;
            }
            let _e257 = phi_582_;
            let _e259 = phi_583_;
            if _e259 {
                phi_587_ = false;
            } else {
                phi_587_ = _e257;
            }
            let _e261 = phi_587_;
            if _e261 {
                if (0f > 0f) {
                    let _e264 = samples.member[_e55.first_primitive].normal;
                    let _e266 = p.member.map_size;
                    let _e269 = p.member.projection.row_x;
                    let _e291 = p.member.projection.row_y;
                    let _e313 = p.member.projection.row_z;
                    let _e340 = ((abs(((((_e269.x * _e264.x) + (_e269.y * _e264.y)) + (_e269.z * _e264.z)) / (((_e269.x * _e269.x) + (_e269.y * _e269.y)) + (_e269.z * _e269.z)))) + abs(((((_e291.x * _e264.x) + (_e291.y * _e264.y)) + (_e291.z * _e264.z)) / (((_e291.x * _e291.x) + (_e291.y * _e291.y)) + (_e291.z * _e291.z))))) / (abs(((((_e313.x * _e264.x) + (_e313.y * _e264.y)) + (_e313.z * _e264.z)) / (((_e313.x * _e313.x) + (_e313.y * _e313.y)) + (_e313.z * _e313.z)))) * f32(_e266)));
                    if (_e340 < 0.002f) {
                        phi_681_ = _e340;
                    } else {
                        phi_681_ = 0.002f;
                    }
                    let _e343 = phi_681_;
                    phi_684_ = (_e234 - (0f * _e343));
                } else {
                    phi_684_ = _e234;
                }
                let _e347 = phi_684_;
                let _e349 = p.member.map_size;
                let _e350 = f32(_e349);
                let _e353 = ((_e207 * _e350) - 0.5f);
                let _e354 = ((_e221 * _e350) - 0.5f);
                if (_e353 > -8388608f) {
                    let _e366 = f32(select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < bitcast<f32>(3472883712u))), 2147483647i, (_e353 > bitcast<f32>(1325400063u))), (_e353 == _e353)));
                    if (_e366 > _e353) {
                        phi_713_ = 1f;
                    } else {
                        phi_713_ = 0f;
                    }
                    let _e369 = phi_713_;
                    if (_e353 < 8388608f) {
                        phi_718_ = (_e366 - _e369);
                        phi_719_ = false;
                    } else {
                        phi_718_ = f32();
                        phi_719_ = true;
                    }
                    let _e372 = phi_718_;
                    let _e374 = phi_719_;
                    phi_720_ = _e372;
                    phi_721_ = _e374;
                } else {
                    phi_720_ = f32();
                    phi_721_ = true;
                }
                let _e376 = phi_720_;
                let _e378 = phi_721_;
                if _e378 {
                    phi_725_ = _e353;
                } else {
                    phi_725_ = _e376;
                }
                let _e380 = phi_725_;
                if (_e354 > -8388608f) {
                    let _e392 = f32(select(0i, select(select(i32(_e354), i32(-2147483648), (_e354 < bitcast<f32>(3472883712u))), 2147483647i, (_e354 > bitcast<f32>(1325400063u))), (_e354 == _e354)));
                    if (_e392 > _e354) {
                        phi_745_ = 1f;
                    } else {
                        phi_745_ = 0f;
                    }
                    let _e395 = phi_745_;
                    if (_e354 < 8388608f) {
                        phi_750_ = (_e392 - _e395);
                        phi_751_ = false;
                    } else {
                        phi_750_ = f32();
                        phi_751_ = true;
                    }
                    let _e398 = phi_750_;
                    let _e400 = phi_751_;
                    phi_752_ = _e398;
                    phi_753_ = _e400;
                } else {
                    phi_752_ = f32();
                    phi_753_ = true;
                }
                let _e402 = phi_752_;
                let _e404 = phi_753_;
                if _e404 {
                    phi_757_ = _e354;
                } else {
                    phi_757_ = _e402;
                }
                let _e406 = phi_757_;
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
                    phi_803_ = _e417;
                } else {
                    phi_803_ = 0i;
                }
                let _e444 = phi_803_;
                if (_e426 > 0i) {
                    phi_808_ = _e426;
                } else {
                    phi_808_ = 0i;
                }
                let _e447 = phi_808_;
                if (_e444 < _e441) {
                    phi_813_ = _e444;
                } else {
                    phi_813_ = _e441;
                }
                let _e450 = phi_813_;
                if (_e447 < _e441) {
                    phi_818_ = _e447;
                } else {
                    phi_818_ = _e441;
                }
                let _e453 = phi_818_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e417 + 1i);
                let _e457 = (_e426 + 1i);
                if (_e456 > 0i) {
                    phi_827_ = _e456;
                } else {
                    phi_827_ = 0i;
                }
                let _e460 = phi_827_;
                if (_e457 > 0i) {
                    phi_832_ = _e457;
                } else {
                    phi_832_ = 0i;
                }
                let _e463 = phi_832_;
                if (_e460 < _e441) {
                    phi_837_ = _e460;
                } else {
                    phi_837_ = _e441;
                }
                let _e466 = phi_837_;
                if (_e463 < _e441) {
                    phi_842_ = _e463;
                } else {
                    phi_842_ = _e441;
                }
                let _e469 = phi_842_;
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
                let _e485 = map.member[(0u + _e475)];
                if (_e476 < _e45) {
                } else {
                    return;
                }
                let _e489 = map.member[(0u + _e476)];
                if (_e477 < _e45) {
                } else {
                    return;
                }
                let _e493 = map.member[(0u + _e477)];
                let _e494 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e481);
                let _e495 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e485);
                let _e496 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e489);
                let _e497 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e493);
                let _e543 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e494.x * _e429) + (_e495.x * _e431)) + (_e496.x * _e433)) + (_e497.x * _e434)), ((((_e494.y * _e429) + (_e495.y * _e431)) + (_e496.y * _e433)) + (_e497.y * _e434)), ((((_e494.z * _e429) + (_e495.z * _e431)) + (_e496.z * _e433)) + (_e497.z * _e434)), ((((_e494.w * _e429) + (_e495.w * _e431)) + (_e496.w * _e433)) + (_e497.w * _e434))), _e347);
                let _e545 = p.member.epsilon;
                if (_e543 <= _e545) {
                    phi_937_ = true;
                } else {
                    phi_937_ = (_e543 >= (1f - _e545));
                }
                let _e550 = phi_937_;
                if ((bitcast<u32>(_e543) & 2147483647u) > 2139095040u) {
                    phi_945_ = true;
                } else {
                    phi_945_ = !(_e550);
                }
                let _e556 = phi_945_;
                if (_e543 > 0.5f) {
                    phi_950_ = 1f;
                } else {
                    phi_950_ = 0f;
                }
                let _e559 = phi_950_;
                phi_953_ = evaluate_Verdict(_e559, _e556);
            } else {
                phi_953_ = evaluate_Verdict(1f, true);
            }
            let _e563 = phi_953_;
            phi_954_ = _e563;
        }
        let _e565 = phi_954_;
        visibility.member[_e55.first_primitive] = _e565.visibility;
        phi_958_ = _e565.is_doubted;
        phi_959_ = _e55.first_primitive;
    } else {
        phi_958_ = false;
        phi_959_ = 0u;
    }
    let _e570 = phi_958_;
    let _e572 = phi_959_;
    if _e570 {
        let _e574 = atomicAdd((&shared_[0u]), 1u);
        phi_965_ = _e574;
    } else {
        phi_965_ = 0u;
    }
    let _e576 = phi_965_;
    workgroupBarrier();
    if (_e40 == 0u) {
        let _e580 = atomicLoad((&shared_[0u]));
        let _e581 = atomicAdd((&list.member[3u]), _e580);
        atomicStore((&shared_[1u]), _e581);
    }
    workgroupBarrier();
    if _e570 {
        let _e584 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e584) + _e576)]), _e572);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
