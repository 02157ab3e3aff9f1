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

struct type_42 {
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
var<storage, read_write> list: type_42;
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_140_: lt_bvh_traverse_Tree;
    var phi_141_: bool;
    var phi_142_: lt_bvh_traverse_Tree;
    var phi_143_: bool;
    var phi_148_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_140_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_141_ = false;
        } else {
            phi_140_ = lt_bvh_traverse_Tree();
            phi_141_ = true;
        }
        let _e50 = phi_140_;
        let _e52 = phi_141_;
        phi_142_ = _e50;
        phi_143_ = _e52;
    } else {
        phi_142_ = lt_bvh_traverse_Tree();
        phi_143_ = true;
    }
    let _e54 = phi_142_;
    let _e56 = phi_143_;
    if _e56 {
        phi_148_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_148_ = _e54;
    }
    let _e61 = phi_148_;
    return lt_bvh_traverse_Tree(_e61.root, _e61.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_174_: f32;
    var phi_175_: f32;
    var phi_176_: f32;
    var phi_192_: f32;
    var phi_193_: f32;
    var phi_194_: f32;
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_228_: f32;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_246_: f32;
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_294_: bool;
    var phi_298_: f32;
    var phi_310_: bool;
    var phi_317_: f32;
    var phi_332_: f32;
    var phi_333_: f32;
    var phi_334_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_176_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_175_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_174_ = 1f;
            } else {
                phi_174_ = param_7;
            }
            let _e47 = phi_174_;
            phi_175_ = _e47;
        }
        let _e49 = phi_175_;
        phi_176_ = _e49;
    }
    let _e51 = phi_176_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_194_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_193_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_192_ = 1f;
            } else {
                phi_192_ = param_5.x;
            }
            let _e59 = phi_192_;
            phi_193_ = _e59;
        }
        let _e61 = phi_193_;
        phi_194_ = _e61;
    }
    let _e63 = phi_194_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_212_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_211_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_210_ = 1f;
            } else {
                phi_210_ = param_5.y;
            }
            let _e71 = phi_210_;
            phi_211_ = _e71;
        }
        let _e73 = phi_211_;
        phi_212_ = _e73;
    }
    let _e75 = phi_212_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_230_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_229_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_228_ = 1f;
            } else {
                phi_228_ = param_5.z;
            }
            let _e83 = phi_228_;
            phi_229_ = _e83;
        }
        let _e85 = phi_229_;
        phi_230_ = _e85;
    }
    let _e87 = phi_230_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_248_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_247_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_246_ = 1f;
            } else {
                phi_246_ = param_5.w;
            }
            let _e95 = phi_246_;
            phi_247_ = _e95;
        }
        let _e97 = phi_247_;
        phi_248_ = _e97;
    }
    let _e99 = phi_248_;
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
        phi_294_ = true;
    } else {
        let _e138 = (_e104 > _e134);
        if _e138 {
        }
        phi_294_ = _e138;
    }
    let _e140 = phi_294_;
    if _e140 {
        phi_298_ = _e104;
    } else {
        phi_298_ = _e134;
    }
    let _e142 = phi_298_;
    let _e143 = -(_e115);
    if (_e143 <= 0f) {
        let _e147 = ((bitcast<u32>(_e142) & 2147483647u) > 2139095040u);
        if _e147 {
        }
        phi_310_ = _e147;
    } else {
        phi_310_ = true;
    }
    let _e149 = phi_310_;
    if _e149 {
        phi_317_ = (_e142 / (_e142 + (_e143 * _e143)));
    } else {
        phi_317_ = 1f;
    }
    let _e154 = phi_317_;
    if ((bitcast<u32>(_e154) & 2147483647u) > 2139095040u) {
        phi_334_ = _e154;
    } else {
        if (_e154 < 0f) {
            phi_333_ = 0f;
        } else {
            if (_e154 > 1f) {
                phi_332_ = 1f;
            } else {
                phi_332_ = _e154;
            }
            let _e161 = phi_332_;
            phi_333_ = _e161;
        }
        let _e163 = phi_333_;
        phi_334_ = _e163;
    }
    let _e165 = phi_334_;
    return _e165;
}

fn function_() {
    var local_1: f32;
    var phi_388_: bool;
    var phi_389_: bool;
    var phi_390_: bool;
    var phi_391_: bool;
    var phi_395_: bool;
    var phi_439_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_443_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_520_: bool;
    var phi_529_: bool;
    var phi_538_: bool;
    var phi_539_: bool;
    var phi_540_: bool;
    var phi_541_: bool;
    var phi_542_: bool;
    var phi_543_: bool;
    var phi_544_: bool;
    var phi_548_: bool;
    var phi_642_: f32;
    var phi_645_: f32;
    var phi_674_: f32;
    var phi_679_: f32;
    var phi_680_: bool;
    var phi_681_: f32;
    var phi_682_: bool;
    var phi_686_: f32;
    var phi_706_: f32;
    var phi_711_: f32;
    var phi_712_: bool;
    var phi_713_: f32;
    var phi_714_: bool;
    var phi_718_: f32;
    var phi_764_: i32;
    var phi_769_: i32;
    var phi_774_: i32;
    var phi_779_: i32;
    var phi_788_: i32;
    var phi_793_: i32;
    var phi_798_: i32;
    var phi_803_: i32;
    var phi_850_: bool;
    var phi_858_: bool;
    var phi_863_: f32;
    var phi_866_: evaluate_Verdict;
    var phi_867_: evaluate_Verdict;
    var phi_871_: bool;
    var phi_872_: u32;
    var phi_878_: u32;

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
                phi_388_ = (_e74 == _e76);
                phi_389_ = false;
            } else {
                phi_388_ = bool();
                phi_389_ = true;
            }
            let _e79 = phi_388_;
            let _e81 = phi_389_;
            phi_390_ = _e79;
            phi_391_ = _e81;
        } else {
            phi_390_ = bool();
            phi_391_ = true;
        }
        let _e83 = phi_390_;
        let _e85 = phi_391_;
        if _e85 {
            phi_395_ = false;
        } else {
            phi_395_ = _e83;
        }
        let _e87 = phi_395_;
        if !(_e87) {
            let _e90 = samples.member[_e54.first_primitive].normal;
            let _e92 = samples.member[_e54.first_primitive].position;
            if ((((_e90.x * (_e61.x - (_e92.x * _e61.w))) + (_e90.y * (_e61.y - (_e92.y * _e61.w)))) + (_e90.z * (_e61.z - (_e92.z * _e61.w)))) > 0f) {
                let _e116 = samples.member[_e54.first_primitive].flags;
                let _e124 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e130 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e124.unnamed.visibility, false), _e124.unnamed_1);
                phi_439_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e130.unnamed, ((_e116 & 1u) == 0u));
            } else {
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e139.unnamed.visibility, false), _e139.unnamed_1);
                phi_439_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e145.unnamed, true);
            }
            let _e150 = phi_439_;
            phi_443_ = _e150;
        } else {
            let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e156.unnamed.visibility, false), _e156.unnamed_1);
            phi_443_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e162.unnamed, true);
        }
        let _e167 = phi_443_;
        if _e167.unnamed_1 {
            phi_867_ = evaluate_Verdict(_e167.unnamed.visibility, _e167.unnamed.is_doubted);
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
                    phi_520_ = (_e206 <= 1f);
                } else {
                    phi_520_ = false;
                }
                let _e238 = phi_520_;
                if _e238 {
                    if (_e220 >= 0f) {
                        phi_529_ = (_e220 <= 1f);
                    } else {
                        phi_529_ = false;
                    }
                    let _e242 = phi_529_;
                    if _e242 {
                        if (_e233 >= 0f) {
                            phi_538_ = (_e233 <= 1f);
                        } else {
                            phi_538_ = false;
                        }
                        let _e246 = phi_538_;
                        phi_539_ = _e246;
                        phi_540_ = false;
                    } else {
                        phi_539_ = bool();
                        phi_540_ = true;
                    }
                    let _e248 = phi_539_;
                    let _e250 = phi_540_;
                    phi_541_ = _e248;
                    phi_542_ = _e250;
                } else {
                    phi_541_ = bool();
                    phi_542_ = true;
                }
                let _e252 = phi_541_;
                let _e254 = phi_542_;
                phi_543_ = _e252;
                phi_544_ = _e254;
            } else {
                phi_543_ = bool();
                phi_544_ = true;
            }
            let _e256 = phi_543_;
            let _e258 = phi_544_;
            if _e258 {
                phi_548_ = false;
            } else {
                phi_548_ = _e256;
            }
            let _e260 = phi_548_;
            if _e260 {
                if (0f > 0f) {
                    let _e263 = samples.member[_e54.first_primitive].normal;
                    let _e265 = p.member.map_size;
                    let _e268 = p.member.projection.row_x;
                    let _e290 = p.member.projection.row_y;
                    let _e312 = p.member.projection.row_z;
                    let _e339 = ((abs(((((_e268.x * _e263.x) + (_e268.y * _e263.y)) + (_e268.z * _e263.z)) / (((_e268.x * _e268.x) + (_e268.y * _e268.y)) + (_e268.z * _e268.z)))) + abs(((((_e290.x * _e263.x) + (_e290.y * _e263.y)) + (_e290.z * _e263.z)) / (((_e290.x * _e290.x) + (_e290.y * _e290.y)) + (_e290.z * _e290.z))))) / (abs(((((_e312.x * _e263.x) + (_e312.y * _e263.y)) + (_e312.z * _e263.z)) / (((_e312.x * _e312.x) + (_e312.y * _e312.y)) + (_e312.z * _e312.z)))) * f32(_e265)));
                    if (_e339 < 0.002f) {
                        phi_642_ = _e339;
                    } else {
                        phi_642_ = 0.002f;
                    }
                    let _e342 = phi_642_;
                    phi_645_ = (_e233 - (0f * _e342));
                } else {
                    phi_645_ = _e233;
                }
                let _e346 = phi_645_;
                let _e348 = p.member.map_size;
                let _e349 = f32(_e348);
                let _e352 = ((_e206 * _e349) - 0.5f);
                let _e353 = ((_e220 * _e349) - 0.5f);
                if (_e352 > -8388608f) {
                    let _e365 = f32(select(0i, select(select(i32(_e352), i32(-2147483648), (_e352 < bitcast<f32>(3472883712u))), 2147483647i, (_e352 > bitcast<f32>(1325400063u))), (_e352 == _e352)));
                    if (_e365 > _e352) {
                        phi_674_ = 1f;
                    } else {
                        phi_674_ = 0f;
                    }
                    let _e368 = phi_674_;
                    if (_e352 < 8388608f) {
                        phi_679_ = (_e365 - _e368);
                        phi_680_ = false;
                    } else {
                        phi_679_ = f32();
                        phi_680_ = true;
                    }
                    let _e371 = phi_679_;
                    let _e373 = phi_680_;
                    phi_681_ = _e371;
                    phi_682_ = _e373;
                } else {
                    phi_681_ = f32();
                    phi_682_ = true;
                }
                let _e375 = phi_681_;
                let _e377 = phi_682_;
                if _e377 {
                    phi_686_ = _e352;
                } else {
                    phi_686_ = _e375;
                }
                let _e379 = phi_686_;
                if (_e353 > -8388608f) {
                    let _e391 = f32(select(0i, select(select(i32(_e353), i32(-2147483648), (_e353 < bitcast<f32>(3472883712u))), 2147483647i, (_e353 > bitcast<f32>(1325400063u))), (_e353 == _e353)));
                    if (_e391 > _e353) {
                        phi_706_ = 1f;
                    } else {
                        phi_706_ = 0f;
                    }
                    let _e394 = phi_706_;
                    if (_e353 < 8388608f) {
                        phi_711_ = (_e391 - _e394);
                        phi_712_ = false;
                    } else {
                        phi_711_ = f32();
                        phi_712_ = true;
                    }
                    let _e397 = phi_711_;
                    let _e399 = phi_712_;
                    phi_713_ = _e397;
                    phi_714_ = _e399;
                } else {
                    phi_713_ = f32();
                    phi_714_ = true;
                }
                let _e401 = phi_713_;
                let _e403 = phi_714_;
                if _e403 {
                    phi_718_ = _e353;
                } else {
                    phi_718_ = _e401;
                }
                let _e405 = phi_718_;
                let _e406 = (_e352 - _e379);
                let _e407 = (_e353 - _e405);
                let _e416 = select(0i, select(select(i32(_e379), i32(-2147483648), (_e379 < bitcast<f32>(3472883712u))), 2147483647i, (_e379 > bitcast<f32>(1325400063u))), (_e379 == _e379));
                let _e425 = select(0i, select(select(i32(_e405), i32(-2147483648), (_e405 < bitcast<f32>(3472883712u))), 2147483647i, (_e405 > bitcast<f32>(1325400063u))), (_e405 == _e405));
                let _e436 = p.member.test;
                let _e437 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e436);
                let _e439 = p.member.map_size;
                local_1 = _e437;
                let _e441 = (bitcast<i32>(_e439) - 1i);
                if (_e416 > 0i) {
                    phi_764_ = _e416;
                } else {
                    phi_764_ = 0i;
                }
                let _e444 = phi_764_;
                if (_e425 > 0i) {
                    phi_769_ = _e425;
                } else {
                    phi_769_ = 0i;
                }
                let _e447 = phi_769_;
                if (_e444 < _e441) {
                    phi_774_ = _e444;
                } else {
                    phi_774_ = _e441;
                }
                let _e450 = phi_774_;
                if (_e447 < _e441) {
                    phi_779_ = _e447;
                } else {
                    phi_779_ = _e441;
                }
                let _e453 = phi_779_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e416 + 1i);
                let _e457 = (_e425 + 1i);
                if (_e456 > 0i) {
                    phi_788_ = _e456;
                } else {
                    phi_788_ = 0i;
                }
                let _e460 = phi_788_;
                if (_e457 > 0i) {
                    phi_793_ = _e457;
                } else {
                    phi_793_ = 0i;
                }
                let _e463 = phi_793_;
                if (_e460 < _e441) {
                    phi_798_ = _e460;
                } else {
                    phi_798_ = _e441;
                }
                let _e466 = phi_798_;
                if (_e463 < _e441) {
                    phi_803_ = _e463;
                } else {
                    phi_803_ = _e441;
                }
                let _e469 = phi_803_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (bitcast<u32>(_e453) * _e439);
                let _e473 = (bitcast<u32>(_e469) * _e439);
                let _e474 = (_e472 + _e454);
                let _e475 = (_e472 + _e470);
                let _e476 = (_e473 + _e454);
                let _e477 = (_e473 + _e470);
                if (_e474 < _e44) {
                } else {
                    return;
                }
                let _e481 = map.member[(0u + _e474)];
                if (_e475 < _e44) {
                } else {
                    return;
                }
                let _e485 = map.member[(0u + _e475)];
                if (_e476 < _e44) {
                } else {
                    return;
                }
                let _e489 = map.member[(0u + _e476)];
                if (_e477 < _e44) {
                } else {
                    return;
                }
                let _e493 = map.member[(0u + _e477)];
                let _e495 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e481, _e485, _e489, _e493), vec4<f32>(((1f - _e406) * (1f - _e407)), (_e406 * (1f - _e407)), ((1f - _e406) * _e407), (_e406 * _e407)), _e346);
                let _e497 = p.member.epsilon;
                if (_e495 <= _e497) {
                    phi_850_ = true;
                } else {
                    phi_850_ = (_e495 >= (1f - _e497));
                }
                let _e502 = phi_850_;
                if ((bitcast<u32>(_e495) & 2147483647u) > 2139095040u) {
                    phi_858_ = true;
                } else {
                    phi_858_ = !(_e502);
                }
                let _e508 = phi_858_;
                if (_e495 > 0.5f) {
                    phi_863_ = 1f;
                } else {
                    phi_863_ = 0f;
                }
                let _e511 = phi_863_;
                phi_866_ = evaluate_Verdict(_e511, _e508);
            } else {
                phi_866_ = evaluate_Verdict(1f, true);
            }
            let _e515 = phi_866_;
            phi_867_ = _e515;
        }
        let _e517 = phi_867_;
        visibility.member[_e54.first_primitive] = _e517.visibility;
        phi_871_ = _e517.is_doubted;
        phi_872_ = _e54.first_primitive;
    } else {
        phi_871_ = false;
        phi_872_ = 0u;
    }
    let _e522 = phi_871_;
    let _e524 = phi_872_;
    if _e522 {
        let _e526 = atomicAdd((&shared_[0u]), 1u);
        phi_878_ = _e526;
    } else {
        phi_878_ = 0u;
    }
    let _e528 = phi_878_;
    workgroupBarrier();
    if (_e39 == 0u) {
        let _e532 = atomicLoad((&shared_[0u]));
        let _e533 = atomicAdd((&list.member[3u]), _e532);
        atomicStore((&shared_[1u]), _e533);
    }
    workgroupBarrier();
    if _e522 {
        let _e536 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e536) + _e528)]), _e524);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
