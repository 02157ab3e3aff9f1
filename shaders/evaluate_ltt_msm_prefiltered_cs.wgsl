struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_10 {
    member: array<abi_Sample>,
}

struct type_14 {
    member: array<u32>,
}

struct type_18 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct type_37 {
    member: array<vec4<f32>>,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_41 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct type_49 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_41;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_49;
@group(0) @binding(2) 
var<storage> map: type_37;

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
        let _e51 = phi_150_;
        let _e53 = phi_151_;
        phi_152_ = _e51;
        phi_153_ = _e53;
    } else {
        phi_152_ = lt_bvh_traverse_Tree();
        phi_153_ = true;
    }
    let _e55 = phi_152_;
    let _e57 = phi_153_;
    if _e57 {
        phi_158_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_158_ = _e55;
    }
    let _e62 = phi_158_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_207_: f32;
    var phi_208_: f32;
    var phi_209_: f32;
    var phi_215_: bool;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_239_: f32;
    var phi_240_: f32;
    var phi_241_: bool;
    var phi_242_: f32;
    var phi_243_: bool;
    var phi_281_: vec2<f32>;
    var phi_315_: f32;
    var phi_316_: f32;
    var phi_317_: f32;
    var phi_346_: f32;
    var phi_347_: f32;
    var phi_348_: f32;
    var phi_352_: f32;
    var phi_353_: f32;
    var phi_354_: f32;
    var phi_355_: f32;

    let _e41 = (*param_4);
    let _e42 = (1f - _e41);
    let _e51 = (0.5f * _e41);
    let _e52 = ((param_5.x * _e42) + _e51);
    let _e53 = ((param_5.y * _e42) + _e51);
    let _e55 = ((param_5.w * _e42) + _e51);
    let _e57 = (_e53 - (_e52 * _e52));
    let _e59 = (((param_5.z * _e42) + _e51) - (_e52 * _e53));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_209_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_208_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_207_ = 1f;
            } else {
                phi_207_ = param_6;
            }
            let _e71 = phi_207_;
            phi_208_ = _e71;
        }
        let _e73 = phi_208_;
        phi_209_ = _e73;
    }
    let _e75 = phi_209_;
    if (_e52 == _e55) {
        phi_215_ = (_e52 > 0.5f);
    } else {
        phi_215_ = false;
    }
    let _e79 = phi_215_;
    if _e79 {
        if (_e75 > 0f) {
            if ((bitcast<u32>(_e52) & 2147483647u) > 2139095040u) {
                phi_239_ = _e52;
            } else {
                if (_e52 < 0f) {
                    phi_238_ = 0f;
                } else {
                    if (_e52 > 1f) {
                        phi_237_ = 1f;
                    } else {
                        phi_237_ = _e52;
                    }
                    let _e87 = phi_237_;
                    phi_238_ = _e87;
                }
                let _e89 = phi_238_;
                phi_239_ = _e89;
            }
            let _e91 = phi_239_;
            phi_240_ = _e91;
            phi_241_ = false;
        } else {
            phi_240_ = f32();
            phi_241_ = true;
        }
        let _e93 = phi_240_;
        let _e95 = phi_241_;
        phi_242_ = _e93;
        phi_243_ = _e95;
    } else {
        phi_242_ = f32();
        phi_243_ = true;
    }
    let _e97 = phi_242_;
    let _e99 = phi_243_;
    if _e99 {
        let _e100 = (_e59 / _e57);
        let _e101 = (_e75 - _e52);
        let _e107 = (((((_e75 * _e75) - _e53) - (_e100 * _e101)) * _e57) / (((_e55 - (_e53 * _e53)) * _e57) - (_e59 * _e59)));
        let _e110 = ((_e101 / _e57) - (_e100 * _e107));
        let _e116 = ((0.5f * _e110) / _e107);
        let _e119 = ((_e116 * _e116) - (((1f - (_e110 * _e52)) - (_e107 * _e53)) / _e107));
        if (_e119 >= 0f) {
            let _e121 = sqrt(_e119);
            phi_281_ = vec2<f32>((-(_e116) - _e121), (-(_e116) + _e121));
        } else {
            phi_281_ = vec2(bitcast<f32>((bitcast<u32>(_e119) | 2143289344u)));
        }
        let _e132 = phi_281_;
        if (_e75 <= _e132.x) {
            phi_354_ = 1f;
        } else {
            if (_e75 > _e132.y) {
                let _e145 = (((_e53 - (_e52 * (_e132.x + _e132.y))) + (_e132.x * _e132.y)) / ((_e75 - _e132.x) * (_e75 - _e132.y)));
                if ((bitcast<u32>(_e145) & 2147483647u) > 2139095040u) {
                    phi_317_ = _e145;
                } else {
                    if (_e145 < 0f) {
                        phi_316_ = 0f;
                    } else {
                        if (_e145 > 1f) {
                            phi_315_ = 1f;
                        } else {
                            phi_315_ = _e145;
                        }
                        let _e152 = phi_315_;
                        phi_316_ = _e152;
                    }
                    let _e154 = phi_316_;
                    phi_317_ = _e154;
                }
                let _e156 = phi_317_;
                phi_353_ = _e156;
            } else {
                if (_e75 > _e132.x) {
                    let _e167 = (1f - (((_e53 - (_e52 * (_e75 + _e132.y))) + (_e75 * _e132.y)) / ((_e132.x - _e75) * (_e132.x - _e132.y))));
                    if ((bitcast<u32>(_e167) & 2147483647u) > 2139095040u) {
                        phi_348_ = _e167;
                    } else {
                        if (_e167 < 0f) {
                            phi_347_ = 0f;
                        } else {
                            if (_e167 > 1f) {
                                phi_346_ = 1f;
                            } else {
                                phi_346_ = _e167;
                            }
                            let _e174 = phi_346_;
                            phi_347_ = _e174;
                        }
                        let _e176 = phi_347_;
                        phi_348_ = _e176;
                    }
                    let _e178 = phi_348_;
                    phi_352_ = _e178;
                } else {
                    phi_352_ = bitcast<f32>((bitcast<u32>(_e132.x) | 2143289344u));
                }
                let _e183 = phi_352_;
                phi_353_ = _e183;
            }
            let _e185 = phi_353_;
            phi_354_ = _e185;
        }
        let _e187 = phi_354_;
        phi_355_ = _e187;
    } else {
        phi_355_ = _e97;
    }
    let _e189 = phi_355_;
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
    var phi_536_: bool;
    var phi_545_: bool;
    var phi_554_: bool;
    var phi_555_: bool;
    var phi_556_: bool;
    var phi_557_: bool;
    var phi_558_: bool;
    var phi_559_: bool;
    var phi_560_: bool;
    var phi_564_: bool;
    var phi_654_: f32;
    var phi_657_: f32;
    var phi_686_: f32;
    var phi_691_: f32;
    var phi_692_: bool;
    var phi_693_: f32;
    var phi_694_: bool;
    var phi_698_: f32;
    var phi_718_: f32;
    var phi_723_: f32;
    var phi_724_: bool;
    var phi_725_: f32;
    var phi_726_: bool;
    var phi_730_: f32;
    var phi_778_: i32;
    var phi_783_: i32;
    var phi_788_: i32;
    var phi_793_: i32;
    var phi_802_: i32;
    var phi_807_: i32;
    var phi_812_: i32;
    var phi_817_: i32;
    var phi_912_: bool;
    var phi_920_: bool;
    var phi_932_: bool;
    var phi_933_: bool;
    var phi_937_: f32;
    var phi_943_: f32;
    var phi_945_: evaluate_Verdict;
    var phi_950_: evaluate_Verdict;
    var phi_951_: evaluate_Verdict;
    var phi_955_: bool;
    var phi_956_: u32;
    var phi_967_: u32;

    let _e39 = id_1;
    let _e40 = local_2;
    let _e45 = arrayLength((&map.member));
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e39, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        let _e60 = p.member.projection;
        let _e61 = lt_math_OneLevel(_e60);
        let _e63 = p.member.light;
        let _e66 = samples.member[_e53.first_primitive].normal[0u];
        let _e68 = global[0u];
        if (_e66 == _e68) {
            let _e71 = samples.member[_e53.first_primitive].normal[1u];
            let _e73 = global[1u];
            if (_e71 == _e73) {
                let _e76 = samples.member[_e53.first_primitive].normal[2u];
                let _e78 = global[2u];
                phi_407_ = (_e76 == _e78);
                phi_408_ = false;
            } else {
                phi_407_ = bool();
                phi_408_ = true;
            }
            let _e81 = phi_407_;
            let _e83 = phi_408_;
            phi_409_ = _e81;
            phi_410_ = _e83;
        } else {
            phi_409_ = bool();
            phi_410_ = true;
        }
        let _e85 = phi_409_;
        let _e87 = phi_410_;
        if _e87 {
            phi_414_ = false;
        } else {
            phi_414_ = _e85;
        }
        let _e89 = phi_414_;
        if !(_e89) {
            let _e92 = samples.member[_e53.first_primitive].normal;
            let _e94 = samples.member[_e53.first_primitive].position;
            if ((((_e92.x * (_e63.x - (_e94.x * _e63.w))) + (_e92.y * (_e63.y - (_e94.y * _e63.w)))) + (_e92.z * (_e63.z - (_e94.z * _e63.w)))) > 0f) {
                let _e118 = samples.member[_e53.first_primitive].flags;
                let _e126 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e132 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e126.unnamed.visibility, false), _e126.unnamed_1);
                phi_458_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e132.unnamed, ((_e118 & 1u) == 0u));
            } else {
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e147 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e141.unnamed.visibility, false), _e141.unnamed_1);
                phi_458_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e147.unnamed, true);
            }
            let _e152 = phi_458_;
            phi_462_ = _e152;
        } else {
            let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e164 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e158.unnamed.visibility, false), _e158.unnamed_1);
            phi_462_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e164.unnamed, true);
        }
        let _e169 = phi_462_;
        if _e169.unnamed_1 {
            phi_951_ = evaluate_Verdict(_e169.unnamed.visibility, _e169.unnamed.is_doubted);
        } else {
            let _e177 = samples.member[_e53.first_primitive].position;
            let _e195 = ((((_e61.projection.row_w.x * _e177.x) + (_e61.projection.row_w.y * _e177.y)) + (_e61.projection.row_w.z * _e177.z)) + (_e61.projection.row_w.w * 1f));
            let _e209 = (((((_e61.projection.row_x.x * _e177.x) + (_e61.projection.row_x.y * _e177.y)) + (_e61.projection.row_x.z * _e177.z)) + (_e61.projection.row_x.w * 1f)) / _e195);
            let _e223 = (((((_e61.projection.row_y.x * _e177.x) + (_e61.projection.row_y.y * _e177.y)) + (_e61.projection.row_y.z * _e177.z)) + (_e61.projection.row_y.w * 1f)) / _e195);
            let _e236 = ((((_e61.projection.row_z.x * _e177.x) + (_e61.projection.row_z.y * _e177.y)) + (_e61.projection.row_z.z * _e177.z)) + (_e61.projection.row_z.w * 1f));
            if (_e195 > 0f) {
                if (_e209 >= 0f) {
                    phi_536_ = (_e209 <= 1f);
                } else {
                    phi_536_ = false;
                }
                let _e241 = phi_536_;
                if _e241 {
                    if (_e223 >= 0f) {
                        phi_545_ = (_e223 <= 1f);
                    } else {
                        phi_545_ = false;
                    }
                    let _e245 = phi_545_;
                    if _e245 {
                        if (_e236 >= 0f) {
                            phi_554_ = (_e236 <= 1f);
                        } else {
                            phi_554_ = false;
                        }
                        let _e249 = phi_554_;
                        phi_555_ = _e249;
                        phi_556_ = false;
                    } else {
                        phi_555_ = bool();
                        phi_556_ = true;
                    }
                    let _e251 = phi_555_;
                    let _e253 = phi_556_;
                    phi_557_ = _e251;
                    phi_558_ = _e253;
                } else {
                    phi_557_ = bool();
                    phi_558_ = true;
                }
                let _e255 = phi_557_;
                let _e257 = phi_558_;
                phi_559_ = _e255;
                phi_560_ = _e257;
            } else {
                phi_559_ = bool();
                phi_560_ = true;
            }
            let _e259 = phi_559_;
            let _e261 = phi_560_;
            if _e261 {
                phi_564_ = false;
            } else {
                phi_564_ = _e259;
            }
            let _e263 = phi_564_;
            if _e263 {
                if (0f > 0f) {
                    let _e266 = samples.member[_e53.first_primitive].normal;
                    let _e268 = p.member.map_size;
                    let _e338 = ((abs(((((_e60.row_x.x * _e266.x) + (_e60.row_x.y * _e266.y)) + (_e60.row_x.z * _e266.z)) / (((_e60.row_x.x * _e60.row_x.x) + (_e60.row_x.y * _e60.row_x.y)) + (_e60.row_x.z * _e60.row_x.z)))) + abs(((((_e60.row_y.x * _e266.x) + (_e60.row_y.y * _e266.y)) + (_e60.row_y.z * _e266.z)) / (((_e60.row_y.x * _e60.row_y.x) + (_e60.row_y.y * _e60.row_y.y)) + (_e60.row_y.z * _e60.row_y.z))))) / (abs(((((_e60.row_z.x * _e266.x) + (_e60.row_z.y * _e266.y)) + (_e60.row_z.z * _e266.z)) / (((_e60.row_z.x * _e60.row_z.x) + (_e60.row_z.y * _e60.row_z.y)) + (_e60.row_z.z * _e60.row_z.z)))) * f32(_e268)));
                    if (_e338 < 0.002f) {
                        phi_654_ = _e338;
                    } else {
                        phi_654_ = 0.002f;
                    }
                    let _e341 = phi_654_;
                    phi_657_ = (_e236 - (0f * _e341));
                } else {
                    phi_657_ = _e236;
                }
                let _e345 = phi_657_;
                let _e347 = p.member.map_size;
                let _e348 = f32(_e347);
                let _e351 = ((_e209 * _e348) - 0.5f);
                let _e352 = ((_e223 * _e348) - 0.5f);
                if (_e351 > -8388608f) {
                    let _e364 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e364 > _e351) {
                        phi_686_ = 1f;
                    } else {
                        phi_686_ = 0f;
                    }
                    let _e367 = phi_686_;
                    if (_e351 < 8388608f) {
                        phi_691_ = (_e364 - _e367);
                        phi_692_ = false;
                    } else {
                        phi_691_ = f32();
                        phi_692_ = true;
                    }
                    let _e370 = phi_691_;
                    let _e372 = phi_692_;
                    phi_693_ = _e370;
                    phi_694_ = _e372;
                } else {
                    phi_693_ = f32();
                    phi_694_ = true;
                }
                let _e374 = phi_693_;
                let _e376 = phi_694_;
                if _e376 {
                    phi_698_ = _e351;
                } else {
                    phi_698_ = _e374;
                }
                let _e378 = phi_698_;
                if (_e352 > -8388608f) {
                    let _e390 = f32(select(0i, select(select(i32(_e352), i32(-2147483648), (_e352 < bitcast<f32>(3472883712u))), 2147483647i, (_e352 > bitcast<f32>(1325400063u))), (_e352 == _e352)));
                    if (_e390 > _e352) {
                        phi_718_ = 1f;
                    } else {
                        phi_718_ = 0f;
                    }
                    let _e393 = phi_718_;
                    if (_e352 < 8388608f) {
                        phi_723_ = (_e390 - _e393);
                        phi_724_ = false;
                    } else {
                        phi_723_ = f32();
                        phi_724_ = true;
                    }
                    let _e396 = phi_723_;
                    let _e398 = phi_724_;
                    phi_725_ = _e396;
                    phi_726_ = _e398;
                } else {
                    phi_725_ = f32();
                    phi_726_ = true;
                }
                let _e400 = phi_725_;
                let _e402 = phi_726_;
                if _e402 {
                    phi_730_ = _e352;
                } else {
                    phi_730_ = _e400;
                }
                let _e404 = phi_730_;
                let _e405 = (_e351 - _e378);
                let _e406 = (_e352 - _e404);
                let _e415 = select(0i, select(select(i32(_e378), i32(-2147483648), (_e378 < bitcast<f32>(3472883712u))), 2147483647i, (_e378 > bitcast<f32>(1325400063u))), (_e378 == _e378));
                let _e424 = select(0i, select(select(i32(_e404), i32(-2147483648), (_e404 < bitcast<f32>(3472883712u))), 2147483647i, (_e404 > bitcast<f32>(1325400063u))), (_e404 == _e404));
                let _e427 = ((1f - _e405) * (1f - _e406));
                let _e429 = (_e405 * (1f - _e406));
                let _e431 = ((1f - _e405) * _e406);
                let _e432 = (_e405 * _e406);
                let _e434 = p.member.test;
                let _e435 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e434);
                let _e437 = p.member.map_size;
                local_1 = _e435;
                let _e439 = ((0u * _e437) * _e437);
                let _e441 = (bitcast<i32>(_e437) - 1i);
                if (_e415 > 0i) {
                    phi_778_ = _e415;
                } else {
                    phi_778_ = 0i;
                }
                let _e444 = phi_778_;
                if (_e424 > 0i) {
                    phi_783_ = _e424;
                } else {
                    phi_783_ = 0i;
                }
                let _e447 = phi_783_;
                if (_e444 < _e441) {
                    phi_788_ = _e444;
                } else {
                    phi_788_ = _e441;
                }
                let _e450 = phi_788_;
                if (_e447 < _e441) {
                    phi_793_ = _e447;
                } else {
                    phi_793_ = _e441;
                }
                let _e453 = phi_793_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e415 + 1i);
                let _e457 = (_e424 + 1i);
                if (_e456 > 0i) {
                    phi_802_ = _e456;
                } else {
                    phi_802_ = 0i;
                }
                let _e460 = phi_802_;
                if (_e457 > 0i) {
                    phi_807_ = _e457;
                } else {
                    phi_807_ = 0i;
                }
                let _e463 = phi_807_;
                if (_e460 < _e441) {
                    phi_812_ = _e460;
                } else {
                    phi_812_ = _e441;
                }
                let _e466 = phi_812_;
                if (_e463 < _e441) {
                    phi_817_ = _e463;
                } else {
                    phi_817_ = _e441;
                }
                let _e469 = phi_817_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (bitcast<u32>(_e453) * _e437);
                let _e473 = (bitcast<u32>(_e469) * _e437);
                let _e478 = ((_e472 + _e454) + _e439);
                let _e479 = ((_e472 + _e470) + _e439);
                let _e480 = ((_e473 + _e454) + _e439);
                let _e481 = ((_e473 + _e470) + _e439);
                if (_e478 < _e45) {
                } else {
                    return;
                }
                let _e485 = map.member[(0u + _e478)];
                if (_e479 < _e45) {
                } else {
                    return;
                }
                let _e497 = map.member[(0u + _e479)];
                if (_e480 < _e45) {
                } else {
                    return;
                }
                let _e513 = map.member[(0u + _e480)];
                if (_e481 < _e45) {
                } else {
                    return;
                }
                let _e529 = map.member[(0u + _e481)];
                let _e543 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e485.x * _e427) + (_e497.x * _e429)) + (_e513.x * _e431)) + (_e529.x * _e432)), ((((_e485.y * _e427) + (_e497.y * _e429)) + (_e513.y * _e431)) + (_e529.y * _e432)), ((((_e485.z * _e427) + (_e497.z * _e429)) + (_e513.z * _e431)) + (_e529.z * _e432)), ((((_e485.w * _e427) + (_e497.w * _e429)) + (_e513.w * _e431)) + (_e529.w * _e432))), _e345);
                let _e545 = p.member.epsilon;
                if (_e543 <= _e545) {
                    phi_912_ = true;
                } else {
                    phi_912_ = (_e543 >= (1f - _e545));
                }
                let _e550 = phi_912_;
                if ((bitcast<u32>(_e543) & 2147483647u) > 2139095040u) {
                    phi_920_ = true;
                } else {
                    phi_920_ = !(_e550);
                }
                let _e556 = phi_920_;
                if _e556 {
                    if (_e543 > 0f) {
                        if (_e543 < 1f) {
                            phi_932_ = false;
                        } else {
                            phi_932_ = true;
                        }
                        let _e560 = phi_932_;
                        phi_933_ = _e560;
                    } else {
                        phi_933_ = true;
                    }
                    let _e562 = phi_933_;
                    if _e562 {
                        phi_937_ = 0.5f;
                    } else {
                        phi_937_ = _e543;
                    }
                    let _e564 = phi_937_;
                    phi_945_ = evaluate_Verdict(_e564, true);
                } else {
                    if (_e543 > 0.5f) {
                        phi_943_ = 1f;
                    } else {
                        phi_943_ = 0f;
                    }
                    let _e568 = phi_943_;
                    phi_945_ = evaluate_Verdict(_e568, false);
                }
                let _e571 = phi_945_;
                phi_950_ = evaluate_Verdict(_e571.visibility, _e571.is_doubted);
            } else {
                phi_950_ = evaluate_Verdict(0.5f, true);
            }
            let _e577 = phi_950_;
            phi_951_ = _e577;
        }
        let _e579 = phi_951_;
        visibility.member[_e53.first_primitive] = _e579.visibility;
        phi_955_ = _e579.is_doubted;
        phi_956_ = _e53.first_primitive;
    } else {
        phi_955_ = false;
        phi_956_ = 0u;
    }
    let _e584 = phi_955_;
    let _e586 = phi_956_;
    if (_e40 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e584 {
        let _e590 = atomicAdd((&shared_[0u]), 1u);
        phi_967_ = _e590;
    } else {
        phi_967_ = 0u;
    }
    let _e592 = phi_967_;
    workgroupBarrier();
    if (_e40 == 0u) {
        let _e596 = atomicLoad((&shared_[0u]));
        let _e597 = atomicAdd((&list.member[3u]), _e596);
        atomicStore((&shared_[1u]), _e597);
    }
    workgroupBarrier();
    if _e584 {
        let _e600 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e600) + _e592)]), _e586);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
