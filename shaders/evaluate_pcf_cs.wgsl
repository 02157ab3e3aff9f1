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
    var phi_122_: lt_bvh_traverse_Tree;
    var phi_123_: bool;
    var phi_124_: lt_bvh_traverse_Tree;
    var phi_125_: bool;
    var phi_130_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_122_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_123_ = false;
        } else {
            phi_122_ = lt_bvh_traverse_Tree();
            phi_123_ = true;
        }
        let _e46 = phi_122_;
        let _e48 = phi_123_;
        phi_124_ = _e46;
        phi_125_ = _e48;
    } else {
        phi_124_ = lt_bvh_traverse_Tree();
        phi_125_ = true;
    }
    let _e50 = phi_124_;
    let _e52 = phi_125_;
    if _e52 {
        phi_130_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_130_ = _e50;
    }
    let _e57 = phi_130_;
    return lt_bvh_traverse_Tree(_e57.root, _e57.first_primitive);
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_3: ptr<function, f32>, param_4: vec4<f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_678_: f32;
    var phi_679_: f32;
    var phi_680_: f32;
    var phi_696_: f32;
    var phi_697_: f32;
    var phi_698_: f32;
    var phi_714_: f32;
    var phi_715_: f32;
    var phi_716_: f32;
    var phi_732_: f32;
    var phi_733_: f32;
    var phi_734_: f32;
    var phi_754_: f32;
    var phi_755_: f32;
    var phi_756_: f32;
    var phi_773_: f32;
    var phi_774_: f32;
    var phi_775_: f32;
    var phi_792_: f32;
    var phi_793_: f32;
    var phi_794_: f32;
    var phi_811_: f32;
    var phi_812_: f32;
    var phi_813_: f32;
    var phi_830_: f32;
    var phi_831_: f32;
    var phi_832_: f32;
    var phi_858_: f32;
    var phi_859_: f32;
    var phi_860_: f32;

    if ((bitcast<u32>(param_4.x) & 2147483647u) > 2139095040u) {
        phi_680_ = param_4.x;
    } else {
        if (param_4.x < 0f) {
            phi_679_ = 0f;
        } else {
            if (param_4.x > 1f) {
                phi_678_ = 1f;
            } else {
                phi_678_ = param_4.x;
            }
            let _e44 = phi_678_;
            phi_679_ = _e44;
        }
        let _e46 = phi_679_;
        phi_680_ = _e46;
    }
    let _e48 = phi_680_;
    if ((bitcast<u32>(param_4.y) & 2147483647u) > 2139095040u) {
        phi_698_ = param_4.y;
    } else {
        if (param_4.y < 0f) {
            phi_697_ = 0f;
        } else {
            if (param_4.y > 1f) {
                phi_696_ = 1f;
            } else {
                phi_696_ = param_4.y;
            }
            let _e56 = phi_696_;
            phi_697_ = _e56;
        }
        let _e58 = phi_697_;
        phi_698_ = _e58;
    }
    let _e60 = phi_698_;
    if ((bitcast<u32>(param_4.z) & 2147483647u) > 2139095040u) {
        phi_716_ = param_4.z;
    } else {
        if (param_4.z < 0f) {
            phi_715_ = 0f;
        } else {
            if (param_4.z > 1f) {
                phi_714_ = 1f;
            } else {
                phi_714_ = param_4.z;
            }
            let _e68 = phi_714_;
            phi_715_ = _e68;
        }
        let _e70 = phi_715_;
        phi_716_ = _e70;
    }
    let _e72 = phi_716_;
    if ((bitcast<u32>(param_4.w) & 2147483647u) > 2139095040u) {
        phi_734_ = param_4.w;
    } else {
        if (param_4.w < 0f) {
            phi_733_ = 0f;
        } else {
            if (param_4.w > 1f) {
                phi_732_ = 1f;
            } else {
                phi_732_ = param_4.w;
            }
            let _e80 = phi_732_;
            phi_733_ = _e80;
        }
        let _e82 = phi_733_;
        phi_734_ = _e82;
    }
    let _e84 = phi_734_;
    let _e85 = (*param_3);
    let _e86 = (_e48 + _e85);
    let _e87 = (_e60 + _e85);
    let _e88 = (_e72 + _e85);
    let _e89 = (_e84 + _e85);
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_756_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_755_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_754_ = 1f;
            } else {
                phi_754_ = param_6;
            }
            let _e96 = phi_754_;
            phi_755_ = _e96;
        }
        let _e98 = phi_755_;
        phi_756_ = _e98;
    }
    let _e100 = phi_756_;
    if ((bitcast<u32>(_e86) & 2147483647u) > 2139095040u) {
        phi_775_ = _e86;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_774_ = _e100;
        } else {
            if (_e86 < _e100) {
                phi_773_ = 0f;
            } else {
                phi_773_ = 1f;
            }
            let _e109 = phi_773_;
            phi_774_ = _e109;
        }
        let _e111 = phi_774_;
        phi_775_ = _e111;
    }
    let _e113 = phi_775_;
    if ((bitcast<u32>(_e87) & 2147483647u) > 2139095040u) {
        phi_794_ = _e87;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_793_ = _e100;
        } else {
            if (_e87 < _e100) {
                phi_792_ = 0f;
            } else {
                phi_792_ = 1f;
            }
            let _e122 = phi_792_;
            phi_793_ = _e122;
        }
        let _e124 = phi_793_;
        phi_794_ = _e124;
    }
    let _e126 = phi_794_;
    if ((bitcast<u32>(_e88) & 2147483647u) > 2139095040u) {
        phi_813_ = _e88;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_812_ = _e100;
        } else {
            if (_e88 < _e100) {
                phi_811_ = 0f;
            } else {
                phi_811_ = 1f;
            }
            let _e135 = phi_811_;
            phi_812_ = _e135;
        }
        let _e137 = phi_812_;
        phi_813_ = _e137;
    }
    let _e139 = phi_813_;
    if ((bitcast<u32>(_e89) & 2147483647u) > 2139095040u) {
        phi_832_ = _e89;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_831_ = _e100;
        } else {
            if (_e89 < _e100) {
                phi_830_ = 0f;
            } else {
                phi_830_ = 1f;
            }
            let _e148 = phi_830_;
            phi_831_ = _e148;
        }
        let _e150 = phi_831_;
        phi_832_ = _e150;
    }
    let _e152 = phi_832_;
    let _e163 = ((((_e113 * param_5.x) + (_e126 * param_5.y)) + (_e139 * param_5.z)) + (_e152 * param_5.w));
    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
        phi_860_ = _e163;
    } else {
        if (_e163 < 0f) {
            phi_859_ = 0f;
        } else {
            if (_e163 > 1f) {
                phi_858_ = 1f;
            } else {
                phi_858_ = _e163;
            }
            let _e170 = phi_858_;
            phi_859_ = _e170;
        }
        let _e172 = phi_859_;
        phi_860_ = _e172;
    }
    let _e174 = phi_860_;
    return _e174;
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_7: vec4<f32>, param_8: f32) -> f32 {
    return (param_7.x + param_8);
}

fn function_() {
    var local: f32;
    var phi_187_: bool;
    var phi_188_: bool;
    var phi_189_: bool;
    var phi_190_: bool;
    var phi_194_: bool;
    var phi_238_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_242_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_319_: bool;
    var phi_328_: bool;
    var phi_337_: bool;
    var phi_338_: bool;
    var phi_339_: bool;
    var phi_340_: bool;
    var phi_341_: bool;
    var phi_342_: bool;
    var phi_343_: bool;
    var phi_347_: bool;
    var phi_437_: f32;
    var phi_466_: f32;
    var phi_471_: f32;
    var phi_472_: bool;
    var phi_473_: f32;
    var phi_474_: bool;
    var phi_478_: f32;
    var phi_498_: f32;
    var phi_503_: f32;
    var phi_504_: bool;
    var phi_505_: f32;
    var phi_506_: bool;
    var phi_510_: f32;
    var phi_556_: i32;
    var phi_561_: i32;
    var phi_566_: i32;
    var phi_571_: i32;
    var phi_580_: i32;
    var phi_585_: i32;
    var phi_590_: i32;
    var phi_595_: i32;
    var phi_636_: evaluate_Verdict;
    var phi_637_: evaluate_Verdict;
    var phi_638_: bool;
    var phi_639_: evaluate_Verdict;
    var phi_640_: evaluate_Verdict;
    var phi_641_: bool;
    var phi_645_: evaluate_Verdict;

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
                phi_187_ = (_e72 == _e74);
                phi_188_ = false;
            } else {
                phi_187_ = bool();
                phi_188_ = true;
            }
            let _e77 = phi_187_;
            let _e79 = phi_188_;
            phi_189_ = _e77;
            phi_190_ = _e79;
        } else {
            phi_189_ = bool();
            phi_190_ = true;
        }
        let _e81 = phi_189_;
        let _e83 = phi_190_;
        if _e83 {
            phi_194_ = false;
        } else {
            phi_194_ = _e81;
        }
        let _e85 = phi_194_;
        if !(_e85) {
            let _e88 = samples.member[(0u + _e50.first_primitive)].normal;
            let _e90 = samples.member[(0u + _e50.first_primitive)].position;
            if ((((_e88.x * (_e59.x - (_e90.x * _e59.w))) + (_e88.y * (_e59.y - (_e90.y * _e59.w)))) + (_e88.z * (_e59.z - (_e90.z * _e59.w)))) > 0f) {
                let _e114 = samples.member[(0u + _e50.first_primitive)].flags;
                let _e122 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e122.unnamed.visibility, false), _e122.unnamed_1);
                phi_238_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e128.unnamed, ((_e114 & 1u) == 0u));
            } else {
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_238_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, true);
            }
            let _e148 = phi_238_;
            phi_242_ = _e148;
        } else {
            let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
            phi_242_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
        }
        let _e165 = phi_242_;
        if _e165.unnamed_1 {
            phi_639_ = evaluate_Verdict(_e165.unnamed.visibility, _e165.unnamed.is_doubted);
            phi_640_ = evaluate_Verdict();
            phi_641_ = true;
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
                    phi_319_ = (_e204 <= 1f);
                } else {
                    phi_319_ = false;
                }
                let _e236 = phi_319_;
                if _e236 {
                    if (_e218 >= 0f) {
                        phi_328_ = (_e218 <= 1f);
                    } else {
                        phi_328_ = false;
                    }
                    let _e240 = phi_328_;
                    if _e240 {
                        if (_e231 >= 0f) {
                            phi_337_ = (_e231 <= 1f);
                        } else {
                            phi_337_ = false;
                        }
                        let _e244 = phi_337_;
                        phi_338_ = _e244;
                        phi_339_ = false;
                    } else {
                        phi_338_ = bool();
                        phi_339_ = true;
                    }
                    let _e246 = phi_338_;
                    let _e248 = phi_339_;
                    phi_340_ = _e246;
                    phi_341_ = _e248;
                } else {
                    phi_340_ = bool();
                    phi_341_ = true;
                }
                let _e250 = phi_340_;
                let _e252 = phi_341_;
                phi_342_ = _e250;
                phi_343_ = _e252;
            } else {
                phi_342_ = bool();
                phi_343_ = true;
            }
            let _e254 = phi_342_;
            let _e256 = phi_343_;
            if _e256 {
                phi_347_ = false;
            } else {
                phi_347_ = _e254;
            }
            let _e258 = phi_347_;
            if _e258 {
                let _e260 = samples.member[(0u + _e50.first_primitive)].normal;
                let _e262 = p.member.map_size;
                let _e265 = p.member.projection.row_x;
                let _e287 = p.member.projection.row_y;
                let _e309 = p.member.projection.row_z;
                let _e336 = ((abs(((((_e265.x * _e260.x) + (_e265.y * _e260.y)) + (_e265.z * _e260.z)) / (((_e265.x * _e265.x) + (_e265.y * _e265.y)) + (_e265.z * _e265.z)))) + abs(((((_e287.x * _e260.x) + (_e287.y * _e260.y)) + (_e287.z * _e260.z)) / (((_e287.x * _e287.x) + (_e287.y * _e287.y)) + (_e287.z * _e287.z))))) / (abs(((((_e309.x * _e260.x) + (_e309.y * _e260.y)) + (_e309.z * _e260.z)) / (((_e309.x * _e309.x) + (_e309.y * _e309.y)) + (_e309.z * _e309.z)))) * f32(_e262)));
                if (_e336 < 0.002f) {
                    phi_437_ = _e336;
                } else {
                    phi_437_ = 0.002f;
                }
                let _e339 = phi_437_;
                let _e341 = p.member.map_size;
                let _e342 = f32(_e341);
                let _e345 = ((_e204 * _e342) - 0.5f);
                let _e346 = ((_e218 * _e342) - 0.5f);
                if (_e345 > -8388608f) {
                    let _e358 = f32(select(0i, select(select(i32(_e345), i32(-2147483648), (_e345 < bitcast<f32>(3472883712u))), 2147483647i, (_e345 > bitcast<f32>(1325400063u))), (_e345 == _e345)));
                    if (_e358 > _e345) {
                        phi_466_ = 1f;
                    } else {
                        phi_466_ = 0f;
                    }
                    let _e361 = phi_466_;
                    if (_e345 < 8388608f) {
                        phi_471_ = (_e358 - _e361);
                        phi_472_ = false;
                    } else {
                        phi_471_ = f32();
                        phi_472_ = true;
                    }
                    let _e364 = phi_471_;
                    let _e366 = phi_472_;
                    phi_473_ = _e364;
                    phi_474_ = _e366;
                } else {
                    phi_473_ = f32();
                    phi_474_ = true;
                }
                let _e368 = phi_473_;
                let _e370 = phi_474_;
                if _e370 {
                    phi_478_ = _e345;
                } else {
                    phi_478_ = _e368;
                }
                let _e372 = phi_478_;
                if (_e346 > -8388608f) {
                    let _e384 = f32(select(0i, select(select(i32(_e346), i32(-2147483648), (_e346 < bitcast<f32>(3472883712u))), 2147483647i, (_e346 > bitcast<f32>(1325400063u))), (_e346 == _e346)));
                    if (_e384 > _e346) {
                        phi_498_ = 1f;
                    } else {
                        phi_498_ = 0f;
                    }
                    let _e387 = phi_498_;
                    if (_e346 < 8388608f) {
                        phi_503_ = (_e384 - _e387);
                        phi_504_ = false;
                    } else {
                        phi_503_ = f32();
                        phi_504_ = true;
                    }
                    let _e390 = phi_503_;
                    let _e392 = phi_504_;
                    phi_505_ = _e390;
                    phi_506_ = _e392;
                } else {
                    phi_505_ = f32();
                    phi_506_ = true;
                }
                let _e394 = phi_505_;
                let _e396 = phi_506_;
                if _e396 {
                    phi_510_ = _e346;
                } else {
                    phi_510_ = _e394;
                }
                let _e398 = phi_510_;
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
                    phi_556_ = _e409;
                } else {
                    phi_556_ = 0i;
                }
                let _e437 = phi_556_;
                if (_e418 > 0i) {
                    phi_561_ = _e418;
                } else {
                    phi_561_ = 0i;
                }
                let _e440 = phi_561_;
                if (_e437 < _e434) {
                    phi_566_ = _e437;
                } else {
                    phi_566_ = _e434;
                }
                let _e443 = phi_566_;
                if (_e440 < _e434) {
                    phi_571_ = _e440;
                } else {
                    phi_571_ = _e434;
                }
                let _e446 = phi_571_;
                let _e447 = bitcast<u32>(_e443);
                let _e449 = (_e409 + 1i);
                let _e450 = (_e418 + 1i);
                if (_e449 > 0i) {
                    phi_580_ = _e449;
                } else {
                    phi_580_ = 0i;
                }
                let _e453 = phi_580_;
                if (_e450 > 0i) {
                    phi_585_ = _e450;
                } else {
                    phi_585_ = 0i;
                }
                let _e456 = phi_585_;
                if (_e453 < _e434) {
                    phi_590_ = _e453;
                } else {
                    phi_590_ = _e434;
                }
                let _e459 = phi_590_;
                if (_e456 < _e434) {
                    phi_595_ = _e456;
                } else {
                    phi_595_ = _e434;
                }
                let _e462 = phi_595_;
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
                phi_636_ = evaluate_Verdict(_e488, false);
                phi_637_ = evaluate_Verdict();
                phi_638_ = false;
            } else {
                phi_636_ = evaluate_Verdict();
                phi_637_ = evaluate_Verdict(1f, false);
                phi_638_ = true;
            }
            let _e492 = phi_636_;
            let _e494 = phi_637_;
            let _e496 = phi_638_;
            phi_639_ = _e494;
            phi_640_ = _e492;
            phi_641_ = _e496;
        }
        let _e498 = phi_639_;
        let _e500 = phi_640_;
        let _e502 = phi_641_;
        if _e502 {
            phi_645_ = _e498;
        } else {
            phi_645_ = _e500;
        }
        let _e504 = phi_645_;
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
