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
        let _e42 = phi_124_;
        let _e44 = phi_125_;
        phi_126_ = _e42;
        phi_127_ = _e44;
    } else {
        phi_126_ = lt_bvh_traverse_Tree();
        phi_127_ = true;
    }
    let _e46 = phi_126_;
    let _e48 = phi_127_;
    if _e48 {
        phi_132_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_132_ = _e46;
    }
    let _e53 = phi_132_;
    return lt_bvh_traverse_Tree(_e53.root, _e53.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_to_light(param_4: vec3<f32>, param_5: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_5.x - (param_4.x * param_5.w)), (param_5.y - (param_4.y * param_5.w)), (param_5.z - (param_4.z * param_5.w)));
}

fn lt_shaders_evaluate_quad_indices(param_6: i32, param_7: i32, param_8: u32) -> array<u32, 4> {
    var phi_166_: i32;
    var phi_171_: i32;
    var phi_176_: i32;
    var phi_181_: i32;
    var phi_190_: i32;
    var phi_195_: i32;
    var phi_200_: i32;
    var phi_205_: i32;

    let _e33 = (bitcast<i32>(param_8) - 1i);
    if (param_6 > 0i) {
        phi_166_ = param_6;
    } else {
        phi_166_ = 0i;
    }
    let _e36 = phi_166_;
    if (param_7 > 0i) {
        phi_171_ = param_7;
    } else {
        phi_171_ = 0i;
    }
    let _e39 = phi_171_;
    if (_e36 < _e33) {
        phi_176_ = _e36;
    } else {
        phi_176_ = _e33;
    }
    let _e42 = phi_176_;
    if (_e39 < _e33) {
        phi_181_ = _e39;
    } else {
        phi_181_ = _e33;
    }
    let _e45 = phi_181_;
    let _e46 = bitcast<u32>(_e42);
    let _e48 = (param_6 + 1i);
    let _e49 = (param_7 + 1i);
    if (_e48 > 0i) {
        phi_190_ = _e48;
    } else {
        phi_190_ = 0i;
    }
    let _e52 = phi_190_;
    if (_e49 > 0i) {
        phi_195_ = _e49;
    } else {
        phi_195_ = 0i;
    }
    let _e55 = phi_195_;
    if (_e52 < _e33) {
        phi_200_ = _e52;
    } else {
        phi_200_ = _e33;
    }
    let _e58 = phi_200_;
    if (_e55 < _e33) {
        phi_205_ = _e55;
    } else {
        phi_205_ = _e33;
    }
    let _e61 = phi_205_;
    let _e62 = bitcast<u32>(_e58);
    let _e64 = (bitcast<u32>(_e45) * param_8);
    let _e65 = (bitcast<u32>(_e61) * param_8);
    return array<u32, 4>((_e64 + _e46), (_e64 + _e62), (_e65 + _e46), (_e65 + _e62));
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_9: ptr<function, f32>, param_10: vec4<f32>, param_11: vec4<f32>, param_12: f32) -> f32 {
    var phi_553_: f32;
    var phi_554_: f32;
    var phi_555_: f32;
    var phi_571_: f32;
    var phi_572_: f32;
    var phi_573_: f32;
    var phi_590_: f32;
    var phi_591_: f32;
    var phi_592_: f32;
    var phi_609_: f32;
    var phi_610_: f32;
    var phi_611_: f32;
    var phi_628_: f32;
    var phi_629_: f32;
    var phi_630_: f32;
    var phi_679_: bool;
    var phi_683_: f32;
    var phi_684_: f32;
    var phi_696_: bool;
    var phi_703_: f32;
    var phi_718_: f32;
    var phi_719_: f32;
    var phi_720_: f32;

    if ((bitcast<u32>(param_12) & 2147483647u) > 2139095040u) {
        phi_555_ = param_12;
    } else {
        if (param_12 < 0f) {
            phi_554_ = 0f;
        } else {
            if (param_12 > 1f) {
                phi_553_ = 1f;
            } else {
                phi_553_ = param_12;
            }
            let _e39 = phi_553_;
            phi_554_ = _e39;
        }
        let _e41 = phi_554_;
        phi_555_ = _e41;
    }
    let _e43 = phi_555_;
    if ((bitcast<u32>(param_10.x) & 2147483647u) > 2139095040u) {
        phi_573_ = param_10.x;
    } else {
        if (param_10.x < 0f) {
            phi_572_ = 0f;
        } else {
            if (param_10.x > 1f) {
                phi_571_ = 1f;
            } else {
                phi_571_ = param_10.x;
            }
            let _e51 = phi_571_;
            phi_572_ = _e51;
        }
        let _e53 = phi_572_;
        phi_573_ = _e53;
    }
    let _e55 = phi_573_;
    let _e56 = (_e55 - _e43);
    if ((bitcast<u32>(param_10.y) & 2147483647u) > 2139095040u) {
        phi_592_ = param_10.y;
    } else {
        if (param_10.y < 0f) {
            phi_591_ = 0f;
        } else {
            if (param_10.y > 1f) {
                phi_590_ = 1f;
            } else {
                phi_590_ = param_10.y;
            }
            let _e64 = phi_590_;
            phi_591_ = _e64;
        }
        let _e66 = phi_591_;
        phi_592_ = _e66;
    }
    let _e68 = phi_592_;
    let _e69 = (_e68 - _e43);
    if ((bitcast<u32>(param_10.z) & 2147483647u) > 2139095040u) {
        phi_611_ = param_10.z;
    } else {
        if (param_10.z < 0f) {
            phi_610_ = 0f;
        } else {
            if (param_10.z > 1f) {
                phi_609_ = 1f;
            } else {
                phi_609_ = param_10.z;
            }
            let _e77 = phi_609_;
            phi_610_ = _e77;
        }
        let _e79 = phi_610_;
        phi_611_ = _e79;
    }
    let _e81 = phi_611_;
    let _e82 = (_e81 - _e43);
    if ((bitcast<u32>(param_10.w) & 2147483647u) > 2139095040u) {
        phi_630_ = param_10.w;
    } else {
        if (param_10.w < 0f) {
            phi_629_ = 0f;
        } else {
            if (param_10.w > 1f) {
                phi_628_ = 1f;
            } else {
                phi_628_ = param_10.w;
            }
            let _e90 = phi_628_;
            phi_629_ = _e90;
        }
        let _e92 = phi_629_;
        phi_630_ = _e92;
    }
    let _e94 = phi_630_;
    let _e95 = (_e94 - _e43);
    let _e96 = (*param_9);
    let _e107 = ((((_e56 * param_11.x) + (_e69 * param_11.y)) + (_e82 * param_11.z)) + (_e95 * param_11.w));
    let _e108 = (_e56 - _e107);
    let _e109 = (_e69 - _e107);
    let _e110 = (_e82 - _e107);
    let _e111 = (_e95 - _e107);
    let _e126 = (((((_e108 * _e108) * param_11.x) + ((_e109 * _e109) * param_11.y)) + ((_e110 * _e110) * param_11.z)) + ((_e111 * _e111) * param_11.w));
    if ((bitcast<u32>(_e126) & 2147483647u) > 2139095040u) {
        phi_684_ = _e126;
    } else {
        if ((bitcast<u32>(_e96) & 2147483647u) > 2139095040u) {
            phi_679_ = true;
        } else {
            let _e133 = (_e96 > _e126);
            if _e133 {
            }
            phi_679_ = _e133;
        }
        let _e135 = phi_679_;
        if _e135 {
            phi_683_ = _e96;
        } else {
            phi_683_ = _e126;
        }
        let _e137 = phi_683_;
        phi_684_ = _e137;
    }
    let _e139 = phi_684_;
    let _e140 = -(_e107);
    if (_e140 <= 0f) {
        let _e144 = ((bitcast<u32>(_e139) & 2147483647u) > 2139095040u);
        if _e144 {
        }
        phi_696_ = _e144;
    } else {
        phi_696_ = true;
    }
    let _e146 = phi_696_;
    if _e146 {
        phi_703_ = (_e139 / (_e139 + (_e140 * _e140)));
    } else {
        phi_703_ = 1f;
    }
    let _e151 = phi_703_;
    if ((bitcast<u32>(_e151) & 2147483647u) > 2139095040u) {
        phi_720_ = _e151;
    } else {
        if (_e151 < 0f) {
            phi_719_ = 0f;
        } else {
            if (_e151 > 1f) {
                phi_718_ = 1f;
            } else {
                phi_718_ = _e151;
            }
            let _e158 = phi_718_;
            phi_719_ = _e158;
        }
        let _e160 = phi_719_;
        phi_720_ = _e160;
    }
    let _e162 = phi_720_;
    return _e162;
}

fn function_() {
    var local: f32;
    var phi_268_: bool;
    var phi_269_: bool;
    var phi_270_: bool;
    var phi_271_: bool;
    var phi_275_: bool;
    var phi_310_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_314_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_411_: bool;
    var phi_412_: bool;
    var phi_413_: bool;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_417_: bool;
    var phi_418_: bool;
    var phi_422_: bool;
    var phi_517_: evaluate_Verdict;
    var phi_518_: evaluate_Verdict;
    var phi_519_: bool;
    var phi_520_: evaluate_Verdict;
    var phi_521_: evaluate_Verdict;
    var phi_522_: bool;
    var phi_526_: evaluate_Verdict;

    let _e30 = id_1;
    let _e37 = arrayLength((&map.member));
    let _e43 = p.member.size[0u];
    let _e45 = p.member.size[1u];
    let _e46 = lt_shaders_entry_pixel_index(_e30, _e43, _e45);
    if (bitcast<i32>(_e46.root) != 0i) {
        if (_e46.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e55 = p.member.light;
        let _e58 = samples.member[(0u + _e46.first_primitive)].normal[0u];
        let _e60 = global[0u];
        if (_e58 == _e60) {
            let _e63 = samples.member[(0u + _e46.first_primitive)].normal[1u];
            let _e65 = global[1u];
            if (_e63 == _e65) {
                let _e68 = samples.member[(0u + _e46.first_primitive)].normal[2u];
                let _e70 = global[2u];
                phi_268_ = (_e68 == _e70);
                phi_269_ = false;
            } else {
                phi_268_ = bool();
                phi_269_ = true;
            }
            let _e73 = phi_268_;
            let _e75 = phi_269_;
            phi_270_ = _e73;
            phi_271_ = _e75;
        } else {
            phi_270_ = bool();
            phi_271_ = true;
        }
        let _e77 = phi_270_;
        let _e79 = phi_271_;
        if _e79 {
            phi_275_ = false;
        } else {
            phi_275_ = _e77;
        }
        let _e81 = phi_275_;
        if !(_e81) {
            let _e84 = samples.member[(0u + _e46.first_primitive)].normal;
            let _e86 = samples.member[(0u + _e46.first_primitive)].position;
            let _e87 = lt_shaders_evaluate_to_light(_e86, _e55);
            if ((((_e84.x * _e87.x) + (_e84.y * _e87.y)) + (_e84.z * _e87.z)) > 0f) {
                let _e101 = samples.member[(0u + _e46.first_primitive)].flags;
                let _e109 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e115 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e109.unnamed.visibility, false), _e109.unnamed_1);
                phi_310_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e115.unnamed, ((_e101 & 1u) == 0u));
            } else {
                let _e124 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e130 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e124.unnamed.visibility, false), _e124.unnamed_1);
                phi_310_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e130.unnamed, true);
            }
            let _e135 = phi_310_;
            phi_314_ = _e135;
        } else {
            let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e147 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e141.unnamed.visibility, false), _e141.unnamed_1);
            phi_314_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e147.unnamed, true);
        }
        let _e152 = phi_314_;
        if _e152.unnamed_1 {
            phi_520_ = evaluate_Verdict(_e152.unnamed.visibility, _e152.unnamed.is_doubted);
            phi_521_ = evaluate_Verdict();
            phi_522_ = true;
        } else {
            let _e160 = samples.member[(0u + _e46.first_primitive)].position;
            let _e166 = p.member.projection.row_w;
            let _e177 = ((((_e166.x * _e160.x) + (_e166.y * _e160.y)) + (_e166.z * _e160.z)) + (_e166.w * 1f));
            let _e179 = p.member.projection.row_x;
            let _e191 = (((((_e179.x * _e160.x) + (_e179.y * _e160.y)) + (_e179.z * _e160.z)) + (_e179.w * 1f)) / _e177);
            let _e193 = p.member.projection.row_y;
            let _e205 = (((((_e193.x * _e160.x) + (_e193.y * _e160.y)) + (_e193.z * _e160.z)) + (_e193.w * 1f)) / _e177);
            let _e207 = p.member.projection.row_z;
            let _e218 = ((((_e207.x * _e160.x) + (_e207.y * _e160.y)) + (_e207.z * _e160.z)) + (_e207.w * 1f));
            if (_e177 > 0f) {
                if (_e191 >= 0f) {
                    if (_e191 <= 1f) {
                        if (_e205 >= 0f) {
                            if (_e205 <= 1f) {
                                if (_e218 >= 0f) {
                                    phi_407_ = (_e218 <= 1f);
                                    phi_408_ = false;
                                } else {
                                    phi_407_ = bool();
                                    phi_408_ = true;
                                }
                                let _e227 = phi_407_;
                                let _e229 = phi_408_;
                                phi_409_ = _e227;
                                phi_410_ = _e229;
                            } else {
                                phi_409_ = bool();
                                phi_410_ = true;
                            }
                            let _e231 = phi_409_;
                            let _e233 = phi_410_;
                            phi_411_ = _e231;
                            phi_412_ = _e233;
                        } else {
                            phi_411_ = bool();
                            phi_412_ = true;
                        }
                        let _e235 = phi_411_;
                        let _e237 = phi_412_;
                        phi_413_ = _e235;
                        phi_414_ = _e237;
                    } else {
                        phi_413_ = bool();
                        phi_414_ = true;
                    }
                    let _e239 = phi_413_;
                    let _e241 = phi_414_;
                    phi_415_ = _e239;
                    phi_416_ = _e241;
                } else {
                    phi_415_ = bool();
                    phi_416_ = true;
                }
                let _e243 = phi_415_;
                let _e245 = phi_416_;
                phi_417_ = _e243;
                phi_418_ = _e245;
            } else {
                phi_417_ = bool();
                phi_418_ = true;
            }
            let _e247 = phi_417_;
            let _e249 = phi_418_;
            if _e249 {
                phi_422_ = false;
            } else {
                phi_422_ = _e247;
            }
            let _e251 = phi_422_;
            if _e251 {
                let _e253 = p.member.map_size;
                let _e254 = f32(_e253);
                let _e257 = ((_e191 * _e254) - 0.5f);
                let _e258 = ((_e205 * _e254) - 0.5f);
                let _e259 = floor(_e257);
                let _e260 = floor(_e258);
                let _e261 = (_e257 - _e259);
                let _e262 = (_e258 - _e260);
                let _e291 = p.member.test;
                let _e292 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e291);
                let _e294 = p.member.map_size;
                local = _e292;
                let _e295 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e259), i32(-2147483648), (_e259 < bitcast<f32>(3472883712u))), 2147483647i, (_e259 > bitcast<f32>(1325400063u))), (_e259 == _e259)), select(0i, select(select(i32(_e260), i32(-2147483648), (_e260 < bitcast<f32>(3472883712u))), 2147483647i, (_e260 > bitcast<f32>(1325400063u))), (_e260 == _e260)), _e294);
                if (_e295[0] < _e37) {
                } else {
                    return;
                }
                let _e300 = map.member[(0u + _e295[0])];
                if (_e295[1] < _e37) {
                } else {
                    return;
                }
                let _e305 = map.member[(0u + _e295[1])];
                if (_e295[2] < _e37) {
                } else {
                    return;
                }
                let _e310 = map.member[(0u + _e295[2])];
                if (_e295[3] < _e37) {
                } else {
                    return;
                }
                let _e315 = map.member[(0u + _e295[3])];
                let _e317 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e300, _e305, _e310, _e315), vec4<f32>(((1f - _e261) * (1f - _e262)), (_e261 * (1f - _e262)), ((1f - _e261) * _e262), (_e261 * _e262)), _e218);
                phi_517_ = evaluate_Verdict(_e317, false);
                phi_518_ = evaluate_Verdict();
                phi_519_ = false;
            } else {
                phi_517_ = evaluate_Verdict();
                phi_518_ = evaluate_Verdict(1f, false);
                phi_519_ = true;
            }
            let _e321 = phi_517_;
            let _e323 = phi_518_;
            let _e325 = phi_519_;
            phi_520_ = _e323;
            phi_521_ = _e321;
            phi_522_ = _e325;
        }
        let _e327 = phi_520_;
        let _e329 = phi_521_;
        let _e331 = phi_522_;
        if _e331 {
            phi_526_ = _e327;
        } else {
            phi_526_ = _e329;
        }
        let _e333 = phi_526_;
        if (_e46.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e46.first_primitive)] = _e333.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_vsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
