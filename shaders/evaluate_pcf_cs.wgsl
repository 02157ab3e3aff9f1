struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_17 {
    member: array<abi_Sample>,
}

struct type_21 {
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

struct type_29 {
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

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_17;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_29;
@group(0) @binding(2) 
var<storage> map: type_21;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_21;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_121_: lt_bvh_traverse_Tree;
    var phi_122_: bool;
    var phi_123_: lt_bvh_traverse_Tree;
    var phi_124_: bool;
    var phi_129_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_121_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_122_ = false;
        } else {
            phi_121_ = lt_bvh_traverse_Tree();
            phi_122_ = true;
        }
        let _e46 = phi_121_;
        let _e48 = phi_122_;
        phi_123_ = _e46;
        phi_124_ = _e48;
    } else {
        phi_123_ = lt_bvh_traverse_Tree();
        phi_124_ = true;
    }
    let _e50 = phi_123_;
    let _e52 = phi_124_;
    if _e52 {
        phi_129_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_129_ = _e50;
    }
    let _e57 = phi_129_;
    return lt_bvh_traverse_Tree(_e57.root, _e57.first_primitive);
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_3: ptr<function, f32>, param_4: vec4<f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_677_: f32;
    var phi_678_: f32;
    var phi_679_: f32;
    var phi_697_: f32;
    var phi_698_: f32;
    var phi_699_: f32;
    var phi_717_: f32;
    var phi_718_: f32;
    var phi_719_: f32;
    var phi_737_: f32;
    var phi_738_: f32;
    var phi_739_: f32;
    var phi_756_: f32;
    var phi_757_: f32;
    var phi_758_: f32;
    var phi_775_: f32;
    var phi_776_: f32;
    var phi_777_: f32;
    var phi_794_: f32;
    var phi_795_: f32;
    var phi_796_: f32;
    var phi_813_: f32;
    var phi_814_: f32;
    var phi_815_: f32;
    var phi_832_: f32;
    var phi_833_: f32;
    var phi_834_: f32;
    var phi_860_: f32;
    var phi_861_: f32;
    var phi_862_: f32;

    if ((bitcast<u32>(param_4.x) & 2147483647u) > 2139095040u) {
        phi_679_ = param_4.x;
    } else {
        if (param_4.x < 0f) {
            phi_678_ = 0f;
        } else {
            if (param_4.x > 1f) {
                phi_677_ = 1f;
            } else {
                phi_677_ = param_4.x;
            }
            let _e44 = phi_677_;
            phi_678_ = _e44;
        }
        let _e46 = phi_678_;
        phi_679_ = _e46;
    }
    let _e48 = phi_679_;
    let _e49 = (*param_3);
    let _e50 = (_e48 + _e49);
    if ((bitcast<u32>(param_4.y) & 2147483647u) > 2139095040u) {
        phi_699_ = param_4.y;
    } else {
        if (param_4.y < 0f) {
            phi_698_ = 0f;
        } else {
            if (param_4.y > 1f) {
                phi_697_ = 1f;
            } else {
                phi_697_ = param_4.y;
            }
            let _e58 = phi_697_;
            phi_698_ = _e58;
        }
        let _e60 = phi_698_;
        phi_699_ = _e60;
    }
    let _e62 = phi_699_;
    let _e63 = (*param_3);
    let _e64 = (_e62 + _e63);
    if ((bitcast<u32>(param_4.z) & 2147483647u) > 2139095040u) {
        phi_719_ = param_4.z;
    } else {
        if (param_4.z < 0f) {
            phi_718_ = 0f;
        } else {
            if (param_4.z > 1f) {
                phi_717_ = 1f;
            } else {
                phi_717_ = param_4.z;
            }
            let _e72 = phi_717_;
            phi_718_ = _e72;
        }
        let _e74 = phi_718_;
        phi_719_ = _e74;
    }
    let _e76 = phi_719_;
    let _e77 = (*param_3);
    let _e78 = (_e76 + _e77);
    if ((bitcast<u32>(param_4.w) & 2147483647u) > 2139095040u) {
        phi_739_ = param_4.w;
    } else {
        if (param_4.w < 0f) {
            phi_738_ = 0f;
        } else {
            if (param_4.w > 1f) {
                phi_737_ = 1f;
            } else {
                phi_737_ = param_4.w;
            }
            let _e86 = phi_737_;
            phi_738_ = _e86;
        }
        let _e88 = phi_738_;
        phi_739_ = _e88;
    }
    let _e90 = phi_739_;
    let _e91 = (*param_3);
    let _e92 = (_e90 + _e91);
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_758_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_757_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_756_ = 1f;
            } else {
                phi_756_ = param_6;
            }
            let _e99 = phi_756_;
            phi_757_ = _e99;
        }
        let _e101 = phi_757_;
        phi_758_ = _e101;
    }
    let _e103 = phi_758_;
    if ((bitcast<u32>(_e50) & 2147483647u) > 2139095040u) {
        phi_777_ = _e50;
    } else {
        if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
            phi_776_ = _e103;
        } else {
            if (_e50 < _e103) {
                phi_775_ = 0f;
            } else {
                phi_775_ = 1f;
            }
            let _e112 = phi_775_;
            phi_776_ = _e112;
        }
        let _e114 = phi_776_;
        phi_777_ = _e114;
    }
    let _e116 = phi_777_;
    if ((bitcast<u32>(_e64) & 2147483647u) > 2139095040u) {
        phi_796_ = _e64;
    } else {
        if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
            phi_795_ = _e103;
        } else {
            if (_e64 < _e103) {
                phi_794_ = 0f;
            } else {
                phi_794_ = 1f;
            }
            let _e125 = phi_794_;
            phi_795_ = _e125;
        }
        let _e127 = phi_795_;
        phi_796_ = _e127;
    }
    let _e129 = phi_796_;
    if ((bitcast<u32>(_e78) & 2147483647u) > 2139095040u) {
        phi_815_ = _e78;
    } else {
        if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
            phi_814_ = _e103;
        } else {
            if (_e78 < _e103) {
                phi_813_ = 0f;
            } else {
                phi_813_ = 1f;
            }
            let _e138 = phi_813_;
            phi_814_ = _e138;
        }
        let _e140 = phi_814_;
        phi_815_ = _e140;
    }
    let _e142 = phi_815_;
    if ((bitcast<u32>(_e92) & 2147483647u) > 2139095040u) {
        phi_834_ = _e92;
    } else {
        if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
            phi_833_ = _e103;
        } else {
            if (_e92 < _e103) {
                phi_832_ = 0f;
            } else {
                phi_832_ = 1f;
            }
            let _e151 = phi_832_;
            phi_833_ = _e151;
        }
        let _e153 = phi_833_;
        phi_834_ = _e153;
    }
    let _e155 = phi_834_;
    let _e166 = ((((_e116 * param_5.x) + (_e129 * param_5.y)) + (_e142 * param_5.z)) + (_e155 * param_5.w));
    if ((bitcast<u32>(_e166) & 2147483647u) > 2139095040u) {
        phi_862_ = _e166;
    } else {
        if (_e166 < 0f) {
            phi_861_ = 0f;
        } else {
            if (_e166 > 1f) {
                phi_860_ = 1f;
            } else {
                phi_860_ = _e166;
            }
            let _e173 = phi_860_;
            phi_861_ = _e173;
        }
        let _e175 = phi_861_;
        phi_862_ = _e175;
    }
    let _e177 = phi_862_;
    return _e177;
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_7: vec4<f32>, param_8: f32) -> f32 {
    return (param_7.x + param_8);
}

fn function_() {
    var local: f32;
    var phi_186_: bool;
    var phi_187_: bool;
    var phi_188_: bool;
    var phi_189_: bool;
    var phi_193_: bool;
    var phi_237_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_241_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_318_: bool;
    var phi_327_: bool;
    var phi_336_: bool;
    var phi_337_: bool;
    var phi_338_: bool;
    var phi_339_: bool;
    var phi_340_: bool;
    var phi_341_: bool;
    var phi_342_: bool;
    var phi_346_: bool;
    var phi_436_: f32;
    var phi_465_: f32;
    var phi_470_: f32;
    var phi_471_: bool;
    var phi_472_: f32;
    var phi_473_: bool;
    var phi_477_: f32;
    var phi_497_: f32;
    var phi_502_: f32;
    var phi_503_: bool;
    var phi_504_: f32;
    var phi_505_: bool;
    var phi_509_: f32;
    var phi_555_: i32;
    var phi_560_: i32;
    var phi_565_: i32;
    var phi_570_: i32;
    var phi_579_: i32;
    var phi_584_: i32;
    var phi_589_: i32;
    var phi_594_: i32;
    var phi_635_: evaluate_Verdict;
    var phi_636_: evaluate_Verdict;
    var phi_637_: bool;
    var phi_638_: evaluate_Verdict;
    var phi_639_: evaluate_Verdict;
    var phi_640_: bool;
    var phi_644_: evaluate_Verdict;

    let _e34 = id_1;
    let _e41 = arrayLength((&map.member));
    let _e47 = p.member.size[0u];
    let _e49 = p.member.size[1u];
    let _e50 = lt_shaders_entry_pixel_index(_e34, _e47, _e49);
    if (bitcast<i32>(_e50.root) != 0i) {
        if (_e50.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e59 = p.member.light;
        let _e62 = samples.member[(0u + _e50.first_primitive)].normal[0u];
        let _e64 = global[0u];
        if (_e62 == _e64) {
            let _e67 = samples.member[(0u + _e50.first_primitive)].normal[1u];
            let _e69 = global[1u];
            if (_e67 == _e69) {
                let _e72 = samples.member[(0u + _e50.first_primitive)].normal[2u];
                let _e74 = global[2u];
                phi_186_ = (_e72 == _e74);
                phi_187_ = false;
            } else {
                phi_186_ = bool();
                phi_187_ = true;
            }
            let _e77 = phi_186_;
            let _e79 = phi_187_;
            phi_188_ = _e77;
            phi_189_ = _e79;
        } else {
            phi_188_ = bool();
            phi_189_ = true;
        }
        let _e81 = phi_188_;
        let _e83 = phi_189_;
        if _e83 {
            phi_193_ = false;
        } else {
            phi_193_ = _e81;
        }
        let _e85 = phi_193_;
        if !(_e85) {
            let _e88 = samples.member[(0u + _e50.first_primitive)].normal;
            let _e90 = samples.member[(0u + _e50.first_primitive)].position;
            if ((((_e88.x * (_e59.x - (_e90.x * _e59.w))) + (_e88.y * (_e59.y - (_e90.y * _e59.w)))) + (_e88.z * (_e59.z - (_e90.z * _e59.w)))) > 0f) {
                let _e114 = samples.member[(0u + _e50.first_primitive)].flags;
                let _e122 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e122.unnamed.visibility, false), _e122.unnamed_1);
                phi_237_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e128.unnamed, ((_e114 & 1u) == 0u));
            } else {
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_237_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, true);
            }
            let _e148 = phi_237_;
            phi_241_ = _e148;
        } else {
            let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
            phi_241_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
        }
        let _e165 = phi_241_;
        if _e165.unnamed_1 {
            phi_638_ = evaluate_Verdict(_e165.unnamed.visibility, _e165.unnamed.is_doubted);
            phi_639_ = evaluate_Verdict();
            phi_640_ = true;
        } else {
            let _e173 = samples.member[(0u + _e50.first_primitive)].position;
            let _e179 = p.member.projection.row_w;
            let _e190 = ((((_e179.x * _e173.x) + (_e179.y * _e173.y)) + (_e179.z * _e173.z)) + (_e179.w * 1f));
            let _e192 = p.member.projection.row_x;
            let _e204 = (((((_e192.x * _e173.x) + (_e192.y * _e173.y)) + (_e192.z * _e173.z)) + (_e192.w * 1f)) / _e190);
            let _e206 = p.member.projection.row_y;
            let _e218 = (((((_e206.x * _e173.x) + (_e206.y * _e173.y)) + (_e206.z * _e173.z)) + (_e206.w * 1f)) / _e190);
            let _e220 = p.member.projection.row_z;
            let _e231 = ((((_e220.x * _e173.x) + (_e220.y * _e173.y)) + (_e220.z * _e173.z)) + (_e220.w * 1f));
            if (_e190 > 0f) {
                if (_e204 >= 0f) {
                    phi_318_ = (_e204 <= 1f);
                } else {
                    phi_318_ = false;
                }
                let _e236 = phi_318_;
                if _e236 {
                    if (_e218 >= 0f) {
                        phi_327_ = (_e218 <= 1f);
                    } else {
                        phi_327_ = false;
                    }
                    let _e240 = phi_327_;
                    if _e240 {
                        if (_e231 >= 0f) {
                            phi_336_ = (_e231 <= 1f);
                        } else {
                            phi_336_ = false;
                        }
                        let _e244 = phi_336_;
                        phi_337_ = _e244;
                        phi_338_ = false;
                    } else {
                        phi_337_ = bool();
                        phi_338_ = true;
                    }
                    let _e246 = phi_337_;
                    let _e248 = phi_338_;
                    phi_339_ = _e246;
                    phi_340_ = _e248;
                } else {
                    phi_339_ = bool();
                    phi_340_ = true;
                }
                let _e250 = phi_339_;
                let _e252 = phi_340_;
                phi_341_ = _e250;
                phi_342_ = _e252;
            } else {
                phi_341_ = bool();
                phi_342_ = true;
            }
            let _e254 = phi_341_;
            let _e256 = phi_342_;
            if _e256 {
                phi_346_ = false;
            } else {
                phi_346_ = _e254;
            }
            let _e258 = phi_346_;
            if _e258 {
                let _e260 = samples.member[(0u + _e50.first_primitive)].normal;
                let _e262 = p.member.map_size;
                let _e265 = p.member.projection.row_x;
                let _e287 = p.member.projection.row_y;
                let _e309 = p.member.projection.row_z;
                let _e336 = ((abs(((((_e265.x * _e260.x) + (_e265.y * _e260.y)) + (_e265.z * _e260.z)) / (((_e265.x * _e265.x) + (_e265.y * _e265.y)) + (_e265.z * _e265.z)))) + abs(((((_e287.x * _e260.x) + (_e287.y * _e260.y)) + (_e287.z * _e260.z)) / (((_e287.x * _e287.x) + (_e287.y * _e287.y)) + (_e287.z * _e287.z))))) / (abs(((((_e309.x * _e260.x) + (_e309.y * _e260.y)) + (_e309.z * _e260.z)) / (((_e309.x * _e309.x) + (_e309.y * _e309.y)) + (_e309.z * _e309.z)))) * f32(_e262)));
                if (_e336 < 0.02f) {
                    phi_436_ = _e336;
                } else {
                    phi_436_ = 0.02f;
                }
                let _e339 = phi_436_;
                let _e341 = p.member.map_size;
                let _e342 = f32(_e341);
                let _e345 = ((_e204 * _e342) - 0.5f);
                let _e346 = ((_e218 * _e342) - 0.5f);
                if (_e345 > -8388608f) {
                    let _e358 = f32(select(0i, select(select(i32(_e345), i32(-2147483648), (_e345 < bitcast<f32>(3472883712u))), 2147483647i, (_e345 > bitcast<f32>(1325400063u))), (_e345 == _e345)));
                    if (_e358 > _e345) {
                        phi_465_ = 1f;
                    } else {
                        phi_465_ = 0f;
                    }
                    let _e361 = phi_465_;
                    if (_e345 < 8388608f) {
                        phi_470_ = (_e358 - _e361);
                        phi_471_ = false;
                    } else {
                        phi_470_ = f32();
                        phi_471_ = true;
                    }
                    let _e364 = phi_470_;
                    let _e366 = phi_471_;
                    phi_472_ = _e364;
                    phi_473_ = _e366;
                } else {
                    phi_472_ = f32();
                    phi_473_ = true;
                }
                let _e368 = phi_472_;
                let _e370 = phi_473_;
                if _e370 {
                    phi_477_ = _e345;
                } else {
                    phi_477_ = _e368;
                }
                let _e372 = phi_477_;
                if (_e346 > -8388608f) {
                    let _e384 = f32(select(0i, select(select(i32(_e346), i32(-2147483648), (_e346 < bitcast<f32>(3472883712u))), 2147483647i, (_e346 > bitcast<f32>(1325400063u))), (_e346 == _e346)));
                    if (_e384 > _e346) {
                        phi_497_ = 1f;
                    } else {
                        phi_497_ = 0f;
                    }
                    let _e387 = phi_497_;
                    if (_e346 < 8388608f) {
                        phi_502_ = (_e384 - _e387);
                        phi_503_ = false;
                    } else {
                        phi_502_ = f32();
                        phi_503_ = true;
                    }
                    let _e390 = phi_502_;
                    let _e392 = phi_503_;
                    phi_504_ = _e390;
                    phi_505_ = _e392;
                } else {
                    phi_504_ = f32();
                    phi_505_ = true;
                }
                let _e394 = phi_504_;
                let _e396 = phi_505_;
                if _e396 {
                    phi_509_ = _e346;
                } else {
                    phi_509_ = _e394;
                }
                let _e398 = phi_509_;
                let _e399 = (_e345 - _e372);
                let _e400 = (_e346 - _e398);
                let _e409 = select(0i, select(select(i32(_e372), i32(-2147483648), (_e372 < bitcast<f32>(3472883712u))), 2147483647i, (_e372 > bitcast<f32>(1325400063u))), (_e372 == _e372));
                let _e418 = select(0i, select(select(i32(_e398), i32(-2147483648), (_e398 < bitcast<f32>(3472883712u))), 2147483647i, (_e398 > bitcast<f32>(1325400063u))), (_e398 == _e398));
                let _e429 = p.member.test;
                let _e430 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e429, _e339);
                let _e432 = p.member.map_size;
                local = _e430;
                let _e434 = (bitcast<i32>(_e432) - 1i);
                if (_e409 > 0i) {
                    phi_555_ = _e409;
                } else {
                    phi_555_ = 0i;
                }
                let _e437 = phi_555_;
                if (_e418 > 0i) {
                    phi_560_ = _e418;
                } else {
                    phi_560_ = 0i;
                }
                let _e440 = phi_560_;
                if (_e437 < _e434) {
                    phi_565_ = _e437;
                } else {
                    phi_565_ = _e434;
                }
                let _e443 = phi_565_;
                if (_e440 < _e434) {
                    phi_570_ = _e440;
                } else {
                    phi_570_ = _e434;
                }
                let _e446 = phi_570_;
                let _e447 = bitcast<u32>(_e443);
                let _e449 = (_e409 + 1i);
                let _e450 = (_e418 + 1i);
                if (_e449 > 0i) {
                    phi_579_ = _e449;
                } else {
                    phi_579_ = 0i;
                }
                let _e453 = phi_579_;
                if (_e450 > 0i) {
                    phi_584_ = _e450;
                } else {
                    phi_584_ = 0i;
                }
                let _e456 = phi_584_;
                if (_e453 < _e434) {
                    phi_589_ = _e453;
                } else {
                    phi_589_ = _e434;
                }
                let _e459 = phi_589_;
                if (_e456 < _e434) {
                    phi_594_ = _e456;
                } else {
                    phi_594_ = _e434;
                }
                let _e462 = phi_594_;
                let _e463 = bitcast<u32>(_e459);
                let _e465 = (bitcast<u32>(_e446) * _e432);
                let _e466 = (bitcast<u32>(_e462) * _e432);
                let _e467 = (_e465 + _e447);
                let _e468 = (_e465 + _e463);
                let _e469 = (_e466 + _e447);
                let _e470 = (_e466 + _e463);
                if (_e467 < _e41) {
                } else {
                    return;
                }
                let _e474 = map.member[(0u + _e467)];
                if (_e468 < _e41) {
                } else {
                    return;
                }
                let _e478 = map.member[(0u + _e468)];
                if (_e469 < _e41) {
                } else {
                    return;
                }
                let _e482 = map.member[(0u + _e469)];
                if (_e470 < _e41) {
                } else {
                    return;
                }
                let _e486 = map.member[(0u + _e470)];
                let _e488 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e474, _e478, _e482, _e486), vec4<f32>(((1f - _e399) * (1f - _e400)), (_e399 * (1f - _e400)), ((1f - _e399) * _e400), (_e399 * _e400)), _e231);
                phi_635_ = evaluate_Verdict(_e488, false);
                phi_636_ = evaluate_Verdict();
                phi_637_ = false;
            } else {
                phi_635_ = evaluate_Verdict();
                phi_636_ = evaluate_Verdict(1f, false);
                phi_637_ = true;
            }
            let _e492 = phi_635_;
            let _e494 = phi_636_;
            let _e496 = phi_637_;
            phi_638_ = _e494;
            phi_639_ = _e492;
            phi_640_ = _e496;
        }
        let _e498 = phi_638_;
        let _e500 = phi_639_;
        let _e502 = phi_640_;
        if _e502 {
            phi_644_ = _e498;
        } else {
            phi_644_ = _e500;
        }
        let _e504 = phi_644_;
        if (_e50.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e50.first_primitive)] = _e504.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_pcf_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
