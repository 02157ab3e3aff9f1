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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_41 {
    member: abi_ShadowParams,
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
        let _e51 = phi_149_;
        let _e53 = phi_150_;
        phi_151_ = _e51;
        phi_152_ = _e53;
    } else {
        phi_151_ = lt_bvh_traverse_Tree();
        phi_152_ = true;
    }
    let _e55 = phi_151_;
    let _e57 = phi_152_;
    if _e57 {
        phi_157_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_157_ = _e55;
    }
    let _e62 = phi_157_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_206_: f32;
    var phi_207_: f32;
    var phi_208_: f32;
    var phi_214_: bool;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_239_: f32;
    var phi_240_: bool;
    var phi_241_: f32;
    var phi_242_: bool;
    var phi_280_: vec2<f32>;
    var phi_314_: f32;
    var phi_315_: f32;
    var phi_316_: f32;
    var phi_345_: f32;
    var phi_346_: f32;
    var phi_347_: f32;
    var phi_351_: f32;
    var phi_352_: f32;
    var phi_353_: f32;
    var phi_354_: f32;

    let _e41 = (*param_4);
    let _e42 = (1f - _e41);
    let _e51 = (0.5f * _e41);
    let _e52 = ((param_5.x * _e42) + _e51);
    let _e53 = ((param_5.y * _e42) + _e51);
    let _e55 = ((param_5.w * _e42) + _e51);
    let _e57 = (_e53 - (_e52 * _e52));
    let _e59 = (((param_5.z * _e42) + _e51) - (_e52 * _e53));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_208_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_207_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_206_ = 1f;
            } else {
                phi_206_ = param_6;
            }
            let _e71 = phi_206_;
            phi_207_ = _e71;
        }
        let _e73 = phi_207_;
        phi_208_ = _e73;
    }
    let _e75 = phi_208_;
    if (_e52 == _e55) {
        phi_214_ = (_e52 > 0.5f);
    } else {
        phi_214_ = false;
    }
    let _e79 = phi_214_;
    if _e79 {
        if (_e75 > 0f) {
            if ((bitcast<u32>(_e52) & 2147483647u) > 2139095040u) {
                phi_238_ = _e52;
            } else {
                if (_e52 < 0f) {
                    phi_237_ = 0f;
                } else {
                    if (_e52 > 1f) {
                        phi_236_ = 1f;
                    } else {
                        phi_236_ = _e52;
                    }
                    let _e87 = phi_236_;
                    phi_237_ = _e87;
                }
                let _e89 = phi_237_;
                phi_238_ = _e89;
            }
            let _e91 = phi_238_;
            phi_239_ = _e91;
            phi_240_ = false;
        } else {
            phi_239_ = f32();
            phi_240_ = true;
        }
        let _e93 = phi_239_;
        let _e95 = phi_240_;
        phi_241_ = _e93;
        phi_242_ = _e95;
    } else {
        phi_241_ = f32();
        phi_242_ = true;
    }
    let _e97 = phi_241_;
    let _e99 = phi_242_;
    if _e99 {
        let _e100 = (_e59 / _e57);
        let _e101 = (_e75 - _e52);
        let _e107 = (((((_e75 * _e75) - _e53) - (_e100 * _e101)) * _e57) / (((_e55 - (_e53 * _e53)) * _e57) - (_e59 * _e59)));
        let _e110 = ((_e101 / _e57) - (_e100 * _e107));
        let _e116 = ((0.5f * _e110) / _e107);
        let _e119 = ((_e116 * _e116) - (((1f - (_e110 * _e52)) - (_e107 * _e53)) / _e107));
        if (_e119 >= 0f) {
            let _e121 = sqrt(_e119);
            phi_280_ = vec2<f32>((-(_e116) - _e121), (-(_e116) + _e121));
        } else {
            phi_280_ = vec2(bitcast<f32>((bitcast<u32>(_e119) | 2143289344u)));
        }
        let _e132 = phi_280_;
        if (_e75 <= _e132.x) {
            phi_353_ = 1f;
        } else {
            if (_e75 > _e132.y) {
                let _e145 = (((_e53 - (_e52 * (_e132.x + _e132.y))) + (_e132.x * _e132.y)) / ((_e75 - _e132.x) * (_e75 - _e132.y)));
                if ((bitcast<u32>(_e145) & 2147483647u) > 2139095040u) {
                    phi_316_ = _e145;
                } else {
                    if (_e145 < 0f) {
                        phi_315_ = 0f;
                    } else {
                        if (_e145 > 1f) {
                            phi_314_ = 1f;
                        } else {
                            phi_314_ = _e145;
                        }
                        let _e152 = phi_314_;
                        phi_315_ = _e152;
                    }
                    let _e154 = phi_315_;
                    phi_316_ = _e154;
                }
                let _e156 = phi_316_;
                phi_352_ = _e156;
            } else {
                if (_e75 > _e132.x) {
                    let _e167 = (1f - (((_e53 - (_e52 * (_e75 + _e132.y))) + (_e75 * _e132.y)) / ((_e132.x - _e75) * (_e132.x - _e132.y))));
                    if ((bitcast<u32>(_e167) & 2147483647u) > 2139095040u) {
                        phi_347_ = _e167;
                    } else {
                        if (_e167 < 0f) {
                            phi_346_ = 0f;
                        } else {
                            if (_e167 > 1f) {
                                phi_345_ = 1f;
                            } else {
                                phi_345_ = _e167;
                            }
                            let _e174 = phi_345_;
                            phi_346_ = _e174;
                        }
                        let _e176 = phi_346_;
                        phi_347_ = _e176;
                    }
                    let _e178 = phi_347_;
                    phi_351_ = _e178;
                } else {
                    phi_351_ = bitcast<f32>((bitcast<u32>(_e132.x) | 2143289344u));
                }
                let _e183 = phi_351_;
                phi_352_ = _e183;
            }
            let _e185 = phi_352_;
            phi_353_ = _e185;
        }
        let _e187 = phi_353_;
        phi_354_ = _e187;
    } else {
        phi_354_ = _e97;
    }
    let _e189 = phi_354_;
    return _e189;
}

fn function_() {
    var local_1: f32;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_410_: bool;
    var phi_454_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_458_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_535_: bool;
    var phi_544_: bool;
    var phi_553_: bool;
    var phi_554_: bool;
    var phi_555_: bool;
    var phi_556_: bool;
    var phi_557_: bool;
    var phi_558_: bool;
    var phi_559_: bool;
    var phi_563_: bool;
    var phi_657_: f32;
    var phi_660_: f32;
    var phi_689_: f32;
    var phi_694_: f32;
    var phi_695_: bool;
    var phi_696_: f32;
    var phi_697_: bool;
    var phi_701_: f32;
    var phi_721_: f32;
    var phi_726_: f32;
    var phi_727_: bool;
    var phi_728_: f32;
    var phi_729_: bool;
    var phi_733_: f32;
    var phi_779_: i32;
    var phi_784_: i32;
    var phi_789_: i32;
    var phi_794_: i32;
    var phi_803_: i32;
    var phi_808_: i32;
    var phi_813_: i32;
    var phi_818_: i32;
    var phi_909_: bool;
    var phi_917_: bool;
    var phi_929_: bool;
    var phi_930_: bool;
    var phi_934_: f32;
    var phi_940_: f32;
    var phi_942_: evaluate_Verdict;
    var phi_947_: evaluate_Verdict;
    var phi_948_: evaluate_Verdict;
    var phi_952_: bool;
    var phi_953_: u32;
    var phi_964_: u32;

    let _e39 = id_1;
    let _e40 = local_2;
    let _e45 = arrayLength((&map.member));
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e39, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        let _e60 = p.member.light;
        let _e63 = samples.member[_e53.first_primitive].normal[0u];
        let _e65 = global[0u];
        if (_e63 == _e65) {
            let _e68 = samples.member[_e53.first_primitive].normal[1u];
            let _e70 = global[1u];
            if (_e68 == _e70) {
                let _e73 = samples.member[_e53.first_primitive].normal[2u];
                let _e75 = global[2u];
                phi_403_ = (_e73 == _e75);
                phi_404_ = false;
            } else {
                phi_403_ = bool();
                phi_404_ = true;
            }
            let _e78 = phi_403_;
            let _e80 = phi_404_;
            phi_405_ = _e78;
            phi_406_ = _e80;
        } else {
            phi_405_ = bool();
            phi_406_ = true;
        }
        let _e82 = phi_405_;
        let _e84 = phi_406_;
        if _e84 {
            phi_410_ = false;
        } else {
            phi_410_ = _e82;
        }
        let _e86 = phi_410_;
        if !(_e86) {
            let _e89 = samples.member[_e53.first_primitive].normal;
            let _e91 = samples.member[_e53.first_primitive].position;
            if ((((_e89.x * (_e60.x - (_e91.x * _e60.w))) + (_e89.y * (_e60.y - (_e91.y * _e60.w)))) + (_e89.z * (_e60.z - (_e91.z * _e60.w)))) > 0f) {
                let _e115 = samples.member[_e53.first_primitive].flags;
                let _e123 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e123.unnamed.visibility, false), _e123.unnamed_1);
                phi_454_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e129.unnamed, ((_e115 & 1u) == 0u));
            } else {
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_454_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, true);
            }
            let _e149 = phi_454_;
            phi_458_ = _e149;
        } else {
            let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e155.unnamed.visibility, false), _e155.unnamed_1);
            phi_458_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e161.unnamed, true);
        }
        let _e166 = phi_458_;
        if _e166.unnamed_1 {
            phi_948_ = evaluate_Verdict(_e166.unnamed.visibility, _e166.unnamed.is_doubted);
        } else {
            let _e174 = samples.member[_e53.first_primitive].position;
            let _e180 = p.member.projection.row_w;
            let _e191 = ((((_e180.x * _e174.x) + (_e180.y * _e174.y)) + (_e180.z * _e174.z)) + (_e180.w * 1f));
            let _e193 = p.member.projection.row_x;
            let _e205 = (((((_e193.x * _e174.x) + (_e193.y * _e174.y)) + (_e193.z * _e174.z)) + (_e193.w * 1f)) / _e191);
            let _e207 = p.member.projection.row_y;
            let _e219 = (((((_e207.x * _e174.x) + (_e207.y * _e174.y)) + (_e207.z * _e174.z)) + (_e207.w * 1f)) / _e191);
            let _e221 = p.member.projection.row_z;
            let _e232 = ((((_e221.x * _e174.x) + (_e221.y * _e174.y)) + (_e221.z * _e174.z)) + (_e221.w * 1f));
            if (_e191 > 0f) {
                if (_e205 >= 0f) {
                    phi_535_ = (_e205 <= 1f);
                } else {
                    phi_535_ = false;
                }
                let _e237 = phi_535_;
                if _e237 {
                    if (_e219 >= 0f) {
                        phi_544_ = (_e219 <= 1f);
                    } else {
                        phi_544_ = false;
                    }
                    let _e241 = phi_544_;
                    if _e241 {
                        if (_e232 >= 0f) {
                            phi_553_ = (_e232 <= 1f);
                        } else {
                            phi_553_ = false;
                        }
                        let _e245 = phi_553_;
                        phi_554_ = _e245;
                        phi_555_ = false;
                    } else {
                        phi_554_ = bool();
                        phi_555_ = true;
                    }
                    let _e247 = phi_554_;
                    let _e249 = phi_555_;
                    phi_556_ = _e247;
                    phi_557_ = _e249;
                } else {
                    phi_556_ = bool();
                    phi_557_ = true;
                }
                let _e251 = phi_556_;
                let _e253 = phi_557_;
                phi_558_ = _e251;
                phi_559_ = _e253;
            } else {
                phi_558_ = bool();
                phi_559_ = true;
            }
            let _e255 = phi_558_;
            let _e257 = phi_559_;
            if _e257 {
                phi_563_ = false;
            } else {
                phi_563_ = _e255;
            }
            let _e259 = phi_563_;
            if _e259 {
                if (0f > 0f) {
                    let _e262 = samples.member[_e53.first_primitive].normal;
                    let _e264 = p.member.map_size;
                    let _e267 = p.member.projection.row_x;
                    let _e289 = p.member.projection.row_y;
                    let _e311 = p.member.projection.row_z;
                    let _e338 = ((abs(((((_e267.x * _e262.x) + (_e267.y * _e262.y)) + (_e267.z * _e262.z)) / (((_e267.x * _e267.x) + (_e267.y * _e267.y)) + (_e267.z * _e267.z)))) + abs(((((_e289.x * _e262.x) + (_e289.y * _e262.y)) + (_e289.z * _e262.z)) / (((_e289.x * _e289.x) + (_e289.y * _e289.y)) + (_e289.z * _e289.z))))) / (abs(((((_e311.x * _e262.x) + (_e311.y * _e262.y)) + (_e311.z * _e262.z)) / (((_e311.x * _e311.x) + (_e311.y * _e311.y)) + (_e311.z * _e311.z)))) * f32(_e264)));
                    if (_e338 < 0.002f) {
                        phi_657_ = _e338;
                    } else {
                        phi_657_ = 0.002f;
                    }
                    let _e341 = phi_657_;
                    phi_660_ = (_e232 - (0f * _e341));
                } else {
                    phi_660_ = _e232;
                }
                let _e345 = phi_660_;
                let _e347 = p.member.map_size;
                let _e348 = f32(_e347);
                let _e351 = ((_e205 * _e348) - 0.5f);
                let _e352 = ((_e219 * _e348) - 0.5f);
                if (_e351 > -8388608f) {
                    let _e364 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e364 > _e351) {
                        phi_689_ = 1f;
                    } else {
                        phi_689_ = 0f;
                    }
                    let _e367 = phi_689_;
                    if (_e351 < 8388608f) {
                        phi_694_ = (_e364 - _e367);
                        phi_695_ = false;
                    } else {
                        phi_694_ = f32();
                        phi_695_ = true;
                    }
                    let _e370 = phi_694_;
                    let _e372 = phi_695_;
                    phi_696_ = _e370;
                    phi_697_ = _e372;
                } else {
                    phi_696_ = f32();
                    phi_697_ = true;
                }
                let _e374 = phi_696_;
                let _e376 = phi_697_;
                if _e376 {
                    phi_701_ = _e351;
                } else {
                    phi_701_ = _e374;
                }
                let _e378 = phi_701_;
                if (_e352 > -8388608f) {
                    let _e390 = f32(select(0i, select(select(i32(_e352), i32(-2147483648), (_e352 < bitcast<f32>(3472883712u))), 2147483647i, (_e352 > bitcast<f32>(1325400063u))), (_e352 == _e352)));
                    if (_e390 > _e352) {
                        phi_721_ = 1f;
                    } else {
                        phi_721_ = 0f;
                    }
                    let _e393 = phi_721_;
                    if (_e352 < 8388608f) {
                        phi_726_ = (_e390 - _e393);
                        phi_727_ = false;
                    } else {
                        phi_726_ = f32();
                        phi_727_ = true;
                    }
                    let _e396 = phi_726_;
                    let _e398 = phi_727_;
                    phi_728_ = _e396;
                    phi_729_ = _e398;
                } else {
                    phi_728_ = f32();
                    phi_729_ = true;
                }
                let _e400 = phi_728_;
                let _e402 = phi_729_;
                if _e402 {
                    phi_733_ = _e352;
                } else {
                    phi_733_ = _e400;
                }
                let _e404 = phi_733_;
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
                let _e439 = (bitcast<i32>(_e437) - 1i);
                if (_e415 > 0i) {
                    phi_779_ = _e415;
                } else {
                    phi_779_ = 0i;
                }
                let _e442 = phi_779_;
                if (_e424 > 0i) {
                    phi_784_ = _e424;
                } else {
                    phi_784_ = 0i;
                }
                let _e445 = phi_784_;
                if (_e442 < _e439) {
                    phi_789_ = _e442;
                } else {
                    phi_789_ = _e439;
                }
                let _e448 = phi_789_;
                if (_e445 < _e439) {
                    phi_794_ = _e445;
                } else {
                    phi_794_ = _e439;
                }
                let _e451 = phi_794_;
                let _e452 = bitcast<u32>(_e448);
                let _e454 = (_e415 + 1i);
                let _e455 = (_e424 + 1i);
                if (_e454 > 0i) {
                    phi_803_ = _e454;
                } else {
                    phi_803_ = 0i;
                }
                let _e458 = phi_803_;
                if (_e455 > 0i) {
                    phi_808_ = _e455;
                } else {
                    phi_808_ = 0i;
                }
                let _e461 = phi_808_;
                if (_e458 < _e439) {
                    phi_813_ = _e458;
                } else {
                    phi_813_ = _e439;
                }
                let _e464 = phi_813_;
                if (_e461 < _e439) {
                    phi_818_ = _e461;
                } else {
                    phi_818_ = _e439;
                }
                let _e467 = phi_818_;
                let _e468 = bitcast<u32>(_e464);
                let _e470 = (bitcast<u32>(_e451) * _e437);
                let _e471 = (bitcast<u32>(_e467) * _e437);
                let _e472 = (_e470 + _e452);
                let _e473 = (_e470 + _e468);
                let _e474 = (_e471 + _e452);
                let _e475 = (_e471 + _e468);
                if (_e472 < _e45) {
                } else {
                    return;
                }
                let _e479 = map.member[(0u + _e472)];
                if (_e473 < _e45) {
                } else {
                    return;
                }
                let _e491 = map.member[(0u + _e473)];
                if (_e474 < _e45) {
                } else {
                    return;
                }
                let _e507 = map.member[(0u + _e474)];
                if (_e475 < _e45) {
                } else {
                    return;
                }
                let _e523 = map.member[(0u + _e475)];
                let _e537 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e479.x * _e427) + (_e491.x * _e429)) + (_e507.x * _e431)) + (_e523.x * _e432)), ((((_e479.y * _e427) + (_e491.y * _e429)) + (_e507.y * _e431)) + (_e523.y * _e432)), ((((_e479.z * _e427) + (_e491.z * _e429)) + (_e507.z * _e431)) + (_e523.z * _e432)), ((((_e479.w * _e427) + (_e491.w * _e429)) + (_e507.w * _e431)) + (_e523.w * _e432))), _e345);
                let _e539 = p.member.epsilon;
                if (_e537 <= _e539) {
                    phi_909_ = true;
                } else {
                    phi_909_ = (_e537 >= (1f - _e539));
                }
                let _e544 = phi_909_;
                if ((bitcast<u32>(_e537) & 2147483647u) > 2139095040u) {
                    phi_917_ = true;
                } else {
                    phi_917_ = !(_e544);
                }
                let _e550 = phi_917_;
                if _e550 {
                    if (_e537 > 0f) {
                        if (_e537 < 1f) {
                            phi_929_ = false;
                        } else {
                            phi_929_ = true;
                        }
                        let _e554 = phi_929_;
                        phi_930_ = _e554;
                    } else {
                        phi_930_ = true;
                    }
                    let _e556 = phi_930_;
                    if _e556 {
                        phi_934_ = 0.5f;
                    } else {
                        phi_934_ = _e537;
                    }
                    let _e558 = phi_934_;
                    phi_942_ = evaluate_Verdict(_e558, true);
                } else {
                    if (_e537 > 0.5f) {
                        phi_940_ = 1f;
                    } else {
                        phi_940_ = 0f;
                    }
                    let _e562 = phi_940_;
                    phi_942_ = evaluate_Verdict(_e562, false);
                }
                let _e565 = phi_942_;
                phi_947_ = evaluate_Verdict(_e565.visibility, _e565.is_doubted);
            } else {
                phi_947_ = evaluate_Verdict(0.5f, true);
            }
            let _e571 = phi_947_;
            phi_948_ = _e571;
        }
        let _e573 = phi_948_;
        visibility.member[_e53.first_primitive] = _e573.visibility;
        phi_952_ = _e573.is_doubted;
        phi_953_ = _e53.first_primitive;
    } else {
        phi_952_ = false;
        phi_953_ = 0u;
    }
    let _e578 = phi_952_;
    let _e580 = phi_953_;
    if (_e40 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e578 {
        let _e584 = atomicAdd((&shared_[0u]), 1u);
        phi_964_ = _e584;
    } else {
        phi_964_ = 0u;
    }
    let _e586 = phi_964_;
    workgroupBarrier();
    if (_e40 == 0u) {
        let _e590 = atomicLoad((&shared_[0u]));
        let _e591 = atomicAdd((&list.member[3u]), _e590);
        atomicStore((&shared_[1u]), _e591);
    }
    workgroupBarrier();
    if _e578 {
        let _e594 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e594) + _e586)]), _e580);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
