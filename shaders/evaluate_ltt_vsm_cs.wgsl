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

struct type_36 {
    member: abi_ShadowParams,
}

struct type_43 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_36;
@group(0) @binding(2) 
var<storage> map: type_18;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_43;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_141_: lt_bvh_traverse_Tree;
    var phi_142_: bool;
    var phi_143_: lt_bvh_traverse_Tree;
    var phi_144_: bool;
    var phi_149_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_141_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_142_ = false;
        } else {
            phi_141_ = lt_bvh_traverse_Tree();
            phi_142_ = true;
        }
        let _e50 = phi_141_;
        let _e52 = phi_142_;
        phi_143_ = _e50;
        phi_144_ = _e52;
    } else {
        phi_143_ = lt_bvh_traverse_Tree();
        phi_144_ = true;
    }
    let _e54 = phi_143_;
    let _e56 = phi_144_;
    if _e56 {
        phi_149_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_149_ = _e54;
    }
    let _e61 = phi_149_;
    return lt_bvh_traverse_Tree(_e61.root, _e61.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_175_: f32;
    var phi_176_: f32;
    var phi_177_: f32;
    var phi_193_: f32;
    var phi_194_: f32;
    var phi_195_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_249_: f32;
    var phi_295_: bool;
    var phi_299_: f32;
    var phi_311_: bool;
    var phi_318_: f32;
    var phi_333_: f32;
    var phi_334_: f32;
    var phi_335_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_177_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_176_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_175_ = 1f;
            } else {
                phi_175_ = param_7;
            }
            let _e47 = phi_175_;
            phi_176_ = _e47;
        }
        let _e49 = phi_176_;
        phi_177_ = _e49;
    }
    let _e51 = phi_177_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_195_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_194_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_193_ = 1f;
            } else {
                phi_193_ = param_5.x;
            }
            let _e59 = phi_193_;
            phi_194_ = _e59;
        }
        let _e61 = phi_194_;
        phi_195_ = _e61;
    }
    let _e63 = phi_195_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_213_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_212_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_211_ = 1f;
            } else {
                phi_211_ = param_5.y;
            }
            let _e71 = phi_211_;
            phi_212_ = _e71;
        }
        let _e73 = phi_212_;
        phi_213_ = _e73;
    }
    let _e75 = phi_213_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_231_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_230_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_229_ = 1f;
            } else {
                phi_229_ = param_5.z;
            }
            let _e83 = phi_229_;
            phi_230_ = _e83;
        }
        let _e85 = phi_230_;
        phi_231_ = _e85;
    }
    let _e87 = phi_231_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_249_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_248_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_247_ = 1f;
            } else {
                phi_247_ = param_5.w;
            }
            let _e95 = phi_247_;
            phi_248_ = _e95;
        }
        let _e97 = phi_248_;
        phi_249_ = _e97;
    }
    let _e99 = phi_249_;
    let _e100 = (_e63 - _e51);
    let _e101 = (_e75 - _e51);
    let _e102 = (_e87 - _e51);
    let _e103 = (_e99 - _e51);
    let _e104 = (*param_4);
    let _e115 = ((((_e100 * param_6.x) + (_e101 * param_6.y)) + (_e102 * param_6.z)) + (_e103 * param_6.w));
    let _e116 = (_e100 - _e115);
    let _e117 = (_e101 - _e115);
    let _e118 = (_e102 - _e115);
    let _e119 = (_e103 - _e115);
    let _e134 = (((((_e116 * _e116) * param_6.x) + ((_e117 * _e117) * param_6.y)) + ((_e118 * _e118) * param_6.z)) + ((_e119 * _e119) * param_6.w));
    if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
        phi_295_ = true;
    } else {
        let _e138 = (_e104 > _e134);
        if _e138 {
        }
        phi_295_ = _e138;
    }
    let _e140 = phi_295_;
    if _e140 {
        phi_299_ = _e104;
    } else {
        phi_299_ = _e134;
    }
    let _e142 = phi_299_;
    let _e143 = -(_e115);
    if (_e143 <= 0f) {
        let _e147 = ((bitcast<u32>(_e142) & 2147483647u) > 2139095040u);
        if _e147 {
        }
        phi_311_ = _e147;
    } else {
        phi_311_ = true;
    }
    let _e149 = phi_311_;
    if _e149 {
        phi_318_ = (_e142 / (_e142 + (_e143 * _e143)));
    } else {
        phi_318_ = 1f;
    }
    let _e154 = phi_318_;
    if ((bitcast<u32>(_e154) & 2147483647u) > 2139095040u) {
        phi_335_ = _e154;
    } else {
        if (_e154 < 0f) {
            phi_334_ = 0f;
        } else {
            if (_e154 > 1f) {
                phi_333_ = 1f;
            } else {
                phi_333_ = _e154;
            }
            let _e161 = phi_333_;
            phi_334_ = _e161;
        }
        let _e163 = phi_334_;
        phi_335_ = _e163;
    }
    let _e165 = phi_335_;
    return _e165;
}

fn function_() {
    var local_1: f32;
    var phi_384_: bool;
    var phi_385_: bool;
    var phi_386_: bool;
    var phi_387_: bool;
    var phi_391_: bool;
    var phi_435_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_439_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_516_: bool;
    var phi_525_: bool;
    var phi_534_: bool;
    var phi_535_: bool;
    var phi_536_: bool;
    var phi_537_: bool;
    var phi_538_: bool;
    var phi_539_: bool;
    var phi_540_: bool;
    var phi_544_: bool;
    var phi_638_: f32;
    var phi_641_: f32;
    var phi_670_: f32;
    var phi_675_: f32;
    var phi_676_: bool;
    var phi_677_: f32;
    var phi_678_: bool;
    var phi_682_: f32;
    var phi_702_: f32;
    var phi_707_: f32;
    var phi_708_: bool;
    var phi_709_: f32;
    var phi_710_: bool;
    var phi_714_: f32;
    var phi_760_: i32;
    var phi_765_: i32;
    var phi_770_: i32;
    var phi_775_: i32;
    var phi_784_: i32;
    var phi_789_: i32;
    var phi_794_: i32;
    var phi_799_: i32;
    var phi_846_: bool;
    var phi_854_: bool;
    var phi_866_: bool;
    var phi_867_: bool;
    var phi_871_: f32;
    var phi_877_: f32;
    var phi_879_: evaluate_Verdict;
    var phi_884_: evaluate_Verdict;
    var phi_885_: evaluate_Verdict;
    var phi_889_: bool;
    var phi_890_: u32;
    var phi_901_: u32;

    let _e38 = id_1;
    let _e39 = local_2;
    let _e44 = arrayLength((&map.member));
    let _e49 = p.member.size[0u];
    let _e51 = p.member.size[1u];
    let _e52 = lt_shaders_entry_pixel_index(_e38, _e49, _e51);
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
                phi_384_ = (_e72 == _e74);
                phi_385_ = false;
            } else {
                phi_384_ = bool();
                phi_385_ = true;
            }
            let _e77 = phi_384_;
            let _e79 = phi_385_;
            phi_386_ = _e77;
            phi_387_ = _e79;
        } else {
            phi_386_ = bool();
            phi_387_ = true;
        }
        let _e81 = phi_386_;
        let _e83 = phi_387_;
        if _e83 {
            phi_391_ = false;
        } else {
            phi_391_ = _e81;
        }
        let _e85 = phi_391_;
        if !(_e85) {
            let _e88 = samples.member[_e52.first_primitive].normal;
            let _e90 = samples.member[_e52.first_primitive].position;
            if ((((_e88.x * (_e59.x - (_e90.x * _e59.w))) + (_e88.y * (_e59.y - (_e90.y * _e59.w)))) + (_e88.z * (_e59.z - (_e90.z * _e59.w)))) > 0f) {
                let _e114 = samples.member[_e52.first_primitive].flags;
                let _e122 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e122.unnamed.visibility, false), _e122.unnamed_1);
                phi_435_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e128.unnamed, ((_e114 & 1u) == 0u));
            } else {
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_435_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, true);
            }
            let _e148 = phi_435_;
            phi_439_ = _e148;
        } else {
            let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
            phi_439_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
        }
        let _e165 = phi_439_;
        if _e165.unnamed_1 {
            phi_885_ = evaluate_Verdict(_e165.unnamed.visibility, _e165.unnamed.is_doubted);
        } else {
            let _e173 = samples.member[_e52.first_primitive].position;
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
                    phi_516_ = (_e204 <= 1f);
                } else {
                    phi_516_ = false;
                }
                let _e236 = phi_516_;
                if _e236 {
                    if (_e218 >= 0f) {
                        phi_525_ = (_e218 <= 1f);
                    } else {
                        phi_525_ = false;
                    }
                    let _e240 = phi_525_;
                    if _e240 {
                        if (_e231 >= 0f) {
                            phi_534_ = (_e231 <= 1f);
                        } else {
                            phi_534_ = false;
                        }
                        let _e244 = phi_534_;
                        phi_535_ = _e244;
                        phi_536_ = false;
                    } else {
                        phi_535_ = bool();
                        phi_536_ = true;
                    }
                    let _e246 = phi_535_;
                    let _e248 = phi_536_;
                    phi_537_ = _e246;
                    phi_538_ = _e248;
                } else {
                    phi_537_ = bool();
                    phi_538_ = true;
                }
                let _e250 = phi_537_;
                let _e252 = phi_538_;
                phi_539_ = _e250;
                phi_540_ = _e252;
            } else {
                phi_539_ = bool();
                phi_540_ = true;
            }
            let _e254 = phi_539_;
            let _e256 = phi_540_;
            if _e256 {
                phi_544_ = false;
            } else {
                phi_544_ = _e254;
            }
            let _e258 = phi_544_;
            if _e258 {
                if (0f > 0f) {
                    let _e261 = samples.member[_e52.first_primitive].normal;
                    let _e263 = p.member.map_size;
                    let _e266 = p.member.projection.row_x;
                    let _e288 = p.member.projection.row_y;
                    let _e310 = p.member.projection.row_z;
                    let _e337 = ((abs(((((_e266.x * _e261.x) + (_e266.y * _e261.y)) + (_e266.z * _e261.z)) / (((_e266.x * _e266.x) + (_e266.y * _e266.y)) + (_e266.z * _e266.z)))) + abs(((((_e288.x * _e261.x) + (_e288.y * _e261.y)) + (_e288.z * _e261.z)) / (((_e288.x * _e288.x) + (_e288.y * _e288.y)) + (_e288.z * _e288.z))))) / (abs(((((_e310.x * _e261.x) + (_e310.y * _e261.y)) + (_e310.z * _e261.z)) / (((_e310.x * _e310.x) + (_e310.y * _e310.y)) + (_e310.z * _e310.z)))) * f32(_e263)));
                    if (_e337 < 0.002f) {
                        phi_638_ = _e337;
                    } else {
                        phi_638_ = 0.002f;
                    }
                    let _e340 = phi_638_;
                    phi_641_ = (_e231 - (0f * _e340));
                } else {
                    phi_641_ = _e231;
                }
                let _e344 = phi_641_;
                let _e346 = p.member.map_size;
                let _e347 = f32(_e346);
                let _e350 = ((_e204 * _e347) - 0.5f);
                let _e351 = ((_e218 * _e347) - 0.5f);
                if (_e350 > -8388608f) {
                    let _e363 = f32(select(0i, select(select(i32(_e350), i32(-2147483648), (_e350 < bitcast<f32>(3472883712u))), 2147483647i, (_e350 > bitcast<f32>(1325400063u))), (_e350 == _e350)));
                    if (_e363 > _e350) {
                        phi_670_ = 1f;
                    } else {
                        phi_670_ = 0f;
                    }
                    let _e366 = phi_670_;
                    if (_e350 < 8388608f) {
                        phi_675_ = (_e363 - _e366);
                        phi_676_ = false;
                    } else {
                        phi_675_ = f32();
                        phi_676_ = true;
                    }
                    let _e369 = phi_675_;
                    let _e371 = phi_676_;
                    phi_677_ = _e369;
                    phi_678_ = _e371;
                } else {
                    phi_677_ = f32();
                    phi_678_ = true;
                }
                let _e373 = phi_677_;
                let _e375 = phi_678_;
                if _e375 {
                    phi_682_ = _e350;
                } else {
                    phi_682_ = _e373;
                }
                let _e377 = phi_682_;
                if (_e351 > -8388608f) {
                    let _e389 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e389 > _e351) {
                        phi_702_ = 1f;
                    } else {
                        phi_702_ = 0f;
                    }
                    let _e392 = phi_702_;
                    if (_e351 < 8388608f) {
                        phi_707_ = (_e389 - _e392);
                        phi_708_ = false;
                    } else {
                        phi_707_ = f32();
                        phi_708_ = true;
                    }
                    let _e395 = phi_707_;
                    let _e397 = phi_708_;
                    phi_709_ = _e395;
                    phi_710_ = _e397;
                } else {
                    phi_709_ = f32();
                    phi_710_ = true;
                }
                let _e399 = phi_709_;
                let _e401 = phi_710_;
                if _e401 {
                    phi_714_ = _e351;
                } else {
                    phi_714_ = _e399;
                }
                let _e403 = phi_714_;
                let _e404 = (_e350 - _e377);
                let _e405 = (_e351 - _e403);
                let _e414 = select(0i, select(select(i32(_e377), i32(-2147483648), (_e377 < bitcast<f32>(3472883712u))), 2147483647i, (_e377 > bitcast<f32>(1325400063u))), (_e377 == _e377));
                let _e423 = select(0i, select(select(i32(_e403), i32(-2147483648), (_e403 < bitcast<f32>(3472883712u))), 2147483647i, (_e403 > bitcast<f32>(1325400063u))), (_e403 == _e403));
                let _e434 = p.member.test;
                let _e435 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e434);
                let _e437 = p.member.map_size;
                local_1 = _e435;
                let _e439 = (bitcast<i32>(_e437) - 1i);
                if (_e414 > 0i) {
                    phi_760_ = _e414;
                } else {
                    phi_760_ = 0i;
                }
                let _e442 = phi_760_;
                if (_e423 > 0i) {
                    phi_765_ = _e423;
                } else {
                    phi_765_ = 0i;
                }
                let _e445 = phi_765_;
                if (_e442 < _e439) {
                    phi_770_ = _e442;
                } else {
                    phi_770_ = _e439;
                }
                let _e448 = phi_770_;
                if (_e445 < _e439) {
                    phi_775_ = _e445;
                } else {
                    phi_775_ = _e439;
                }
                let _e451 = phi_775_;
                let _e452 = bitcast<u32>(_e448);
                let _e454 = (_e414 + 1i);
                let _e455 = (_e423 + 1i);
                if (_e454 > 0i) {
                    phi_784_ = _e454;
                } else {
                    phi_784_ = 0i;
                }
                let _e458 = phi_784_;
                if (_e455 > 0i) {
                    phi_789_ = _e455;
                } else {
                    phi_789_ = 0i;
                }
                let _e461 = phi_789_;
                if (_e458 < _e439) {
                    phi_794_ = _e458;
                } else {
                    phi_794_ = _e439;
                }
                let _e464 = phi_794_;
                if (_e461 < _e439) {
                    phi_799_ = _e461;
                } else {
                    phi_799_ = _e439;
                }
                let _e467 = phi_799_;
                let _e468 = bitcast<u32>(_e464);
                let _e470 = (bitcast<u32>(_e451) * _e437);
                let _e471 = (bitcast<u32>(_e467) * _e437);
                let _e472 = (_e470 + _e452);
                let _e473 = (_e470 + _e468);
                let _e474 = (_e471 + _e452);
                let _e475 = (_e471 + _e468);
                if (_e472 < _e44) {
                } else {
                    return;
                }
                let _e479 = map.member[(0u + _e472)];
                if (_e473 < _e44) {
                } else {
                    return;
                }
                let _e483 = map.member[(0u + _e473)];
                if (_e474 < _e44) {
                } else {
                    return;
                }
                let _e487 = map.member[(0u + _e474)];
                if (_e475 < _e44) {
                } else {
                    return;
                }
                let _e491 = map.member[(0u + _e475)];
                let _e493 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e479, _e483, _e487, _e491), vec4<f32>(((1f - _e404) * (1f - _e405)), (_e404 * (1f - _e405)), ((1f - _e404) * _e405), (_e404 * _e405)), _e344);
                let _e495 = p.member.epsilon;
                if (_e493 <= _e495) {
                    phi_846_ = true;
                } else {
                    phi_846_ = (_e493 >= (1f - _e495));
                }
                let _e500 = phi_846_;
                if ((bitcast<u32>(_e493) & 2147483647u) > 2139095040u) {
                    phi_854_ = true;
                } else {
                    phi_854_ = !(_e500);
                }
                let _e506 = phi_854_;
                if _e506 {
                    if (_e493 > 0f) {
                        if (_e493 < 1f) {
                            phi_866_ = false;
                        } else {
                            phi_866_ = true;
                        }
                        let _e510 = phi_866_;
                        phi_867_ = _e510;
                    } else {
                        phi_867_ = true;
                    }
                    let _e512 = phi_867_;
                    if _e512 {
                        phi_871_ = 0.5f;
                    } else {
                        phi_871_ = _e493;
                    }
                    let _e514 = phi_871_;
                    phi_879_ = evaluate_Verdict(_e514, true);
                } else {
                    if (_e493 > 0.5f) {
                        phi_877_ = 1f;
                    } else {
                        phi_877_ = 0f;
                    }
                    let _e518 = phi_877_;
                    phi_879_ = evaluate_Verdict(_e518, false);
                }
                let _e521 = phi_879_;
                phi_884_ = evaluate_Verdict(_e521.visibility, _e521.is_doubted);
            } else {
                phi_884_ = evaluate_Verdict(0.5f, true);
            }
            let _e527 = phi_884_;
            phi_885_ = _e527;
        }
        let _e529 = phi_885_;
        visibility.member[_e52.first_primitive] = _e529.visibility;
        phi_889_ = _e529.is_doubted;
        phi_890_ = _e52.first_primitive;
    } else {
        phi_889_ = false;
        phi_890_ = 0u;
    }
    let _e534 = phi_889_;
    let _e536 = phi_890_;
    if (_e39 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e534 {
        let _e540 = atomicAdd((&shared_[0u]), 1u);
        phi_901_ = _e540;
    } else {
        phi_901_ = 0u;
    }
    let _e542 = phi_901_;
    workgroupBarrier();
    if (_e39 == 0u) {
        let _e546 = atomicLoad((&shared_[0u]));
        let _e547 = atomicAdd((&list.member[3u]), _e546);
        atomicStore((&shared_[1u]), _e547);
    }
    workgroupBarrier();
    if _e534 {
        let _e550 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e550) + _e542)]), _e536);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
