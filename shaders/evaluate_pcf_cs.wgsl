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

struct type_19 {
    member: array<abi_Sample>,
}

struct type_23 {
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

struct type_30 {
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
var<storage> samples: type_19;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> map: type_23;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_23;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_124_: lt_bvh_traverse_Tree;
    var phi_125_: bool;
    var phi_126_: lt_bvh_traverse_Tree;
    var phi_127_: bool;
    var phi_132_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_124_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_125_ = false;
        } else {
            phi_124_ = lt_bvh_traverse_Tree();
            phi_125_ = true;
        }
        let _e43 = phi_124_;
        let _e45 = phi_125_;
        phi_126_ = _e43;
        phi_127_ = _e45;
    } else {
        phi_126_ = lt_bvh_traverse_Tree();
        phi_127_ = true;
    }
    let _e47 = phi_126_;
    let _e49 = phi_127_;
    if _e49 {
        phi_132_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_132_ = _e47;
    }
    let _e54 = phi_132_;
    return lt_bvh_traverse_Tree(_e54.root, _e54.first_primitive);
}

fn lt_shaders_evaluate_to_light(param_3: vec3<f32>, param_4: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_4.x - (param_3.x * param_4.w)), (param_4.y - (param_3.y * param_4.w)), (param_4.z - (param_3.z * param_4.w)));
}

fn lt_shaders_evaluate_quad_indices(param_5: i32, param_6: i32, param_7: u32) -> array<u32, 4> {
    var phi_163_: i32;
    var phi_168_: i32;
    var phi_173_: i32;
    var phi_178_: i32;
    var phi_187_: i32;
    var phi_192_: i32;
    var phi_197_: i32;
    var phi_202_: i32;

    let _e34 = (bitcast<i32>(param_7) - 1i);
    if (param_5 > 0i) {
        phi_163_ = param_5;
    } else {
        phi_163_ = 0i;
    }
    let _e37 = phi_163_;
    if (param_6 > 0i) {
        phi_168_ = param_6;
    } else {
        phi_168_ = 0i;
    }
    let _e40 = phi_168_;
    if (_e37 < _e34) {
        phi_173_ = _e37;
    } else {
        phi_173_ = _e34;
    }
    let _e43 = phi_173_;
    if (_e40 < _e34) {
        phi_178_ = _e40;
    } else {
        phi_178_ = _e34;
    }
    let _e46 = phi_178_;
    let _e47 = bitcast<u32>(_e43);
    let _e49 = (param_5 + 1i);
    let _e50 = (param_6 + 1i);
    if (_e49 > 0i) {
        phi_187_ = _e49;
    } else {
        phi_187_ = 0i;
    }
    let _e53 = phi_187_;
    if (_e50 > 0i) {
        phi_192_ = _e50;
    } else {
        phi_192_ = 0i;
    }
    let _e56 = phi_192_;
    if (_e53 < _e34) {
        phi_197_ = _e53;
    } else {
        phi_197_ = _e34;
    }
    let _e59 = phi_197_;
    if (_e56 < _e34) {
        phi_202_ = _e56;
    } else {
        phi_202_ = _e34;
    }
    let _e62 = phi_202_;
    let _e63 = bitcast<u32>(_e59);
    let _e65 = (bitcast<u32>(_e46) * param_7);
    let _e66 = (bitcast<u32>(_e62) * param_7);
    return array<u32, 4>((_e65 + _e47), (_e65 + _e63), (_e66 + _e47), (_e66 + _e63));
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_8: ptr<function, f32>, param_9: vec4<f32>, param_10: vec4<f32>, param_11: f32) -> f32 {
    var phi_639_: f32;
    var phi_640_: f32;
    var phi_641_: f32;
    var phi_659_: f32;
    var phi_660_: f32;
    var phi_661_: f32;
    var phi_679_: f32;
    var phi_680_: f32;
    var phi_681_: f32;
    var phi_699_: f32;
    var phi_700_: f32;
    var phi_701_: f32;
    var phi_718_: f32;
    var phi_719_: f32;
    var phi_720_: f32;
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
    var phi_822_: f32;
    var phi_823_: f32;
    var phi_824_: f32;

    if ((bitcast<u32>(param_9.x) & 2147483647u) > 2139095040u) {
        phi_641_ = param_9.x;
    } else {
        if (param_9.x < 0f) {
            phi_640_ = 0f;
        } else {
            if (param_9.x > 1f) {
                phi_639_ = 1f;
            } else {
                phi_639_ = param_9.x;
            }
            let _e41 = phi_639_;
            phi_640_ = _e41;
        }
        let _e43 = phi_640_;
        phi_641_ = _e43;
    }
    let _e45 = phi_641_;
    let _e46 = (*param_8);
    let _e47 = (_e45 + _e46);
    if ((bitcast<u32>(param_9.y) & 2147483647u) > 2139095040u) {
        phi_661_ = param_9.y;
    } else {
        if (param_9.y < 0f) {
            phi_660_ = 0f;
        } else {
            if (param_9.y > 1f) {
                phi_659_ = 1f;
            } else {
                phi_659_ = param_9.y;
            }
            let _e55 = phi_659_;
            phi_660_ = _e55;
        }
        let _e57 = phi_660_;
        phi_661_ = _e57;
    }
    let _e59 = phi_661_;
    let _e60 = (*param_8);
    let _e61 = (_e59 + _e60);
    if ((bitcast<u32>(param_9.z) & 2147483647u) > 2139095040u) {
        phi_681_ = param_9.z;
    } else {
        if (param_9.z < 0f) {
            phi_680_ = 0f;
        } else {
            if (param_9.z > 1f) {
                phi_679_ = 1f;
            } else {
                phi_679_ = param_9.z;
            }
            let _e69 = phi_679_;
            phi_680_ = _e69;
        }
        let _e71 = phi_680_;
        phi_681_ = _e71;
    }
    let _e73 = phi_681_;
    let _e74 = (*param_8);
    let _e75 = (_e73 + _e74);
    if ((bitcast<u32>(param_9.w) & 2147483647u) > 2139095040u) {
        phi_701_ = param_9.w;
    } else {
        if (param_9.w < 0f) {
            phi_700_ = 0f;
        } else {
            if (param_9.w > 1f) {
                phi_699_ = 1f;
            } else {
                phi_699_ = param_9.w;
            }
            let _e83 = phi_699_;
            phi_700_ = _e83;
        }
        let _e85 = phi_700_;
        phi_701_ = _e85;
    }
    let _e87 = phi_701_;
    let _e88 = (*param_8);
    let _e89 = (_e87 + _e88);
    if ((bitcast<u32>(param_11) & 2147483647u) > 2139095040u) {
        phi_720_ = param_11;
    } else {
        if (param_11 < 0f) {
            phi_719_ = 0f;
        } else {
            if (param_11 > 1f) {
                phi_718_ = 1f;
            } else {
                phi_718_ = param_11;
            }
            let _e96 = phi_718_;
            phi_719_ = _e96;
        }
        let _e98 = phi_719_;
        phi_720_ = _e98;
    }
    let _e100 = phi_720_;
    if ((bitcast<u32>(_e47) & 2147483647u) > 2139095040u) {
        phi_739_ = _e47;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_738_ = _e100;
        } else {
            if (_e47 < _e100) {
                phi_737_ = 0f;
            } else {
                phi_737_ = 1f;
            }
            let _e109 = phi_737_;
            phi_738_ = _e109;
        }
        let _e111 = phi_738_;
        phi_739_ = _e111;
    }
    let _e113 = phi_739_;
    if ((bitcast<u32>(_e61) & 2147483647u) > 2139095040u) {
        phi_758_ = _e61;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_757_ = _e100;
        } else {
            if (_e61 < _e100) {
                phi_756_ = 0f;
            } else {
                phi_756_ = 1f;
            }
            let _e122 = phi_756_;
            phi_757_ = _e122;
        }
        let _e124 = phi_757_;
        phi_758_ = _e124;
    }
    let _e126 = phi_758_;
    if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
        phi_777_ = _e75;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_776_ = _e100;
        } else {
            if (_e75 < _e100) {
                phi_775_ = 0f;
            } else {
                phi_775_ = 1f;
            }
            let _e135 = phi_775_;
            phi_776_ = _e135;
        }
        let _e137 = phi_776_;
        phi_777_ = _e137;
    }
    let _e139 = phi_777_;
    if ((bitcast<u32>(_e89) & 2147483647u) > 2139095040u) {
        phi_796_ = _e89;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_795_ = _e100;
        } else {
            if (_e89 < _e100) {
                phi_794_ = 0f;
            } else {
                phi_794_ = 1f;
            }
            let _e148 = phi_794_;
            phi_795_ = _e148;
        }
        let _e150 = phi_795_;
        phi_796_ = _e150;
    }
    let _e152 = phi_796_;
    let _e163 = ((((_e113 * param_10.x) + (_e126 * param_10.y)) + (_e139 * param_10.z)) + (_e152 * param_10.w));
    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
        phi_824_ = _e163;
    } else {
        if (_e163 < 0f) {
            phi_823_ = 0f;
        } else {
            if (_e163 > 1f) {
                phi_822_ = 1f;
            } else {
                phi_822_ = _e163;
            }
            let _e170 = phi_822_;
            phi_823_ = _e170;
        }
        let _e172 = phi_823_;
        phi_824_ = _e172;
    }
    let _e174 = phi_824_;
    return _e174;
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_12: vec4<f32>, param_13: f32) -> f32 {
    return (param_12.x + param_13);
}

fn function_() {
    var local: f32;
    var phi_265_: bool;
    var phi_266_: bool;
    var phi_267_: bool;
    var phi_268_: bool;
    var phi_272_: bool;
    var phi_307_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_311_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_411_: bool;
    var phi_412_: bool;
    var phi_413_: bool;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_419_: bool;
    var phi_509_: f32;
    var phi_597_: evaluate_Verdict;
    var phi_598_: evaluate_Verdict;
    var phi_599_: bool;
    var phi_600_: evaluate_Verdict;
    var phi_601_: evaluate_Verdict;
    var phi_602_: bool;
    var phi_606_: evaluate_Verdict;

    let _e31 = id_1;
    let _e38 = arrayLength((&map.member));
    let _e44 = p.member.size[0u];
    let _e46 = p.member.size[1u];
    let _e47 = lt_shaders_entry_pixel_index(_e31, _e44, _e46);
    if (bitcast<i32>(_e47.root) != 0i) {
        if (_e47.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e56 = p.member.light;
        let _e59 = samples.member[(0u + _e47.first_primitive)].normal[0u];
        let _e61 = global[0u];
        if (_e59 == _e61) {
            let _e64 = samples.member[(0u + _e47.first_primitive)].normal[1u];
            let _e66 = global[1u];
            if (_e64 == _e66) {
                let _e69 = samples.member[(0u + _e47.first_primitive)].normal[2u];
                let _e71 = global[2u];
                phi_265_ = (_e69 == _e71);
                phi_266_ = false;
            } else {
                phi_265_ = bool();
                phi_266_ = true;
            }
            let _e74 = phi_265_;
            let _e76 = phi_266_;
            phi_267_ = _e74;
            phi_268_ = _e76;
        } else {
            phi_267_ = bool();
            phi_268_ = true;
        }
        let _e78 = phi_267_;
        let _e80 = phi_268_;
        if _e80 {
            phi_272_ = false;
        } else {
            phi_272_ = _e78;
        }
        let _e82 = phi_272_;
        if !(_e82) {
            let _e85 = samples.member[(0u + _e47.first_primitive)].normal;
            let _e87 = samples.member[(0u + _e47.first_primitive)].position;
            let _e88 = lt_shaders_evaluate_to_light(_e87, _e56);
            if ((((_e85.x * _e88.x) + (_e85.y * _e88.y)) + (_e85.z * _e88.z)) > 0f) {
                let _e102 = samples.member[(0u + _e47.first_primitive)].flags;
                let _e110 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e116 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e110.unnamed.visibility, false), _e110.unnamed_1);
                phi_307_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e116.unnamed, ((_e102 & 1u) == 0u));
            } else {
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_307_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, true);
            }
            let _e136 = phi_307_;
            phi_311_ = _e136;
        } else {
            let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e142.unnamed.visibility, false), _e142.unnamed_1);
            phi_311_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e148.unnamed, true);
        }
        let _e153 = phi_311_;
        if _e153.unnamed_1 {
            phi_600_ = evaluate_Verdict(_e153.unnamed.visibility, _e153.unnamed.is_doubted);
            phi_601_ = evaluate_Verdict();
            phi_602_ = true;
        } else {
            let _e161 = samples.member[(0u + _e47.first_primitive)].position;
            let _e167 = p.member.projection.row_w;
            let _e178 = ((((_e167.x * _e161.x) + (_e167.y * _e161.y)) + (_e167.z * _e161.z)) + (_e167.w * 1f));
            let _e180 = p.member.projection.row_x;
            let _e192 = (((((_e180.x * _e161.x) + (_e180.y * _e161.y)) + (_e180.z * _e161.z)) + (_e180.w * 1f)) / _e178);
            let _e194 = p.member.projection.row_y;
            let _e206 = (((((_e194.x * _e161.x) + (_e194.y * _e161.y)) + (_e194.z * _e161.z)) + (_e194.w * 1f)) / _e178);
            let _e208 = p.member.projection.row_z;
            let _e219 = ((((_e208.x * _e161.x) + (_e208.y * _e161.y)) + (_e208.z * _e161.z)) + (_e208.w * 1f));
            if (_e178 > 0f) {
                if (_e192 >= 0f) {
                    if (_e192 <= 1f) {
                        if (_e206 >= 0f) {
                            if (_e206 <= 1f) {
                                if (_e219 >= 0f) {
                                    phi_404_ = (_e219 <= 1f);
                                    phi_405_ = false;
                                } else {
                                    phi_404_ = bool();
                                    phi_405_ = true;
                                }
                                let _e228 = phi_404_;
                                let _e230 = phi_405_;
                                phi_406_ = _e228;
                                phi_407_ = _e230;
                            } else {
                                phi_406_ = bool();
                                phi_407_ = true;
                            }
                            let _e232 = phi_406_;
                            let _e234 = phi_407_;
                            phi_408_ = _e232;
                            phi_409_ = _e234;
                        } else {
                            phi_408_ = bool();
                            phi_409_ = true;
                        }
                        let _e236 = phi_408_;
                        let _e238 = phi_409_;
                        phi_410_ = _e236;
                        phi_411_ = _e238;
                    } else {
                        phi_410_ = bool();
                        phi_411_ = true;
                    }
                    let _e240 = phi_410_;
                    let _e242 = phi_411_;
                    phi_412_ = _e240;
                    phi_413_ = _e242;
                } else {
                    phi_412_ = bool();
                    phi_413_ = true;
                }
                let _e244 = phi_412_;
                let _e246 = phi_413_;
                phi_414_ = _e244;
                phi_415_ = _e246;
            } else {
                phi_414_ = bool();
                phi_415_ = true;
            }
            let _e248 = phi_414_;
            let _e250 = phi_415_;
            if _e250 {
                phi_419_ = false;
            } else {
                phi_419_ = _e248;
            }
            let _e252 = phi_419_;
            if _e252 {
                let _e254 = samples.member[(0u + _e47.first_primitive)].normal;
                let _e256 = p.member.map_size;
                let _e259 = p.member.projection.row_x;
                let _e281 = p.member.projection.row_y;
                let _e303 = p.member.projection.row_z;
                let _e330 = ((abs(((((_e259.x * _e254.x) + (_e259.y * _e254.y)) + (_e259.z * _e254.z)) / (((_e259.x * _e259.x) + (_e259.y * _e259.y)) + (_e259.z * _e259.z)))) + abs(((((_e281.x * _e254.x) + (_e281.y * _e254.y)) + (_e281.z * _e254.z)) / (((_e281.x * _e281.x) + (_e281.y * _e281.y)) + (_e281.z * _e281.z))))) / (abs(((((_e303.x * _e254.x) + (_e303.y * _e254.y)) + (_e303.z * _e254.z)) / (((_e303.x * _e303.x) + (_e303.y * _e303.y)) + (_e303.z * _e303.z)))) * f32(_e256)));
                if (_e330 < 0.02f) {
                    phi_509_ = _e330;
                } else {
                    phi_509_ = 0.02f;
                }
                let _e333 = phi_509_;
                let _e335 = p.member.map_size;
                let _e336 = f32(_e335);
                let _e339 = ((_e192 * _e336) - 0.5f);
                let _e340 = ((_e206 * _e336) - 0.5f);
                let _e341 = floor(_e339);
                let _e342 = floor(_e340);
                let _e343 = (_e339 - _e341);
                let _e344 = (_e340 - _e342);
                let _e373 = p.member.test;
                let _e374 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e373, _e333);
                let _e376 = p.member.map_size;
                local = _e374;
                let _e377 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e341), i32(-2147483648), (_e341 < bitcast<f32>(3472883712u))), 2147483647i, (_e341 > bitcast<f32>(1325400063u))), (_e341 == _e341)), select(0i, select(select(i32(_e342), i32(-2147483648), (_e342 < bitcast<f32>(3472883712u))), 2147483647i, (_e342 > bitcast<f32>(1325400063u))), (_e342 == _e342)), _e376);
                if (_e377[0] < _e38) {
                } else {
                    return;
                }
                let _e382 = map.member[(0u + _e377[0])];
                if (_e377[1] < _e38) {
                } else {
                    return;
                }
                let _e387 = map.member[(0u + _e377[1])];
                if (_e377[2] < _e38) {
                } else {
                    return;
                }
                let _e392 = map.member[(0u + _e377[2])];
                if (_e377[3] < _e38) {
                } else {
                    return;
                }
                let _e397 = map.member[(0u + _e377[3])];
                let _e399 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e382, _e387, _e392, _e397), vec4<f32>(((1f - _e343) * (1f - _e344)), (_e343 * (1f - _e344)), ((1f - _e343) * _e344), (_e343 * _e344)), _e219);
                phi_597_ = evaluate_Verdict(_e399, false);
                phi_598_ = evaluate_Verdict();
                phi_599_ = false;
            } else {
                phi_597_ = evaluate_Verdict();
                phi_598_ = evaluate_Verdict(1f, false);
                phi_599_ = true;
            }
            let _e403 = phi_597_;
            let _e405 = phi_598_;
            let _e407 = phi_599_;
            phi_600_ = _e405;
            phi_601_ = _e403;
            phi_602_ = _e407;
        }
        let _e409 = phi_600_;
        let _e411 = phi_601_;
        let _e413 = phi_602_;
        if _e413 {
            phi_606_ = _e409;
        } else {
            phi_606_ = _e411;
        }
        let _e415 = phi_606_;
        if (_e47.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e47.first_primitive)] = _e415.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_pcf_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
