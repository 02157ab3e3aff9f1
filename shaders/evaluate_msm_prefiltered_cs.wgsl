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

struct type_21 {
    member: array<abi_Sample>,
}

struct type_25 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_33 {
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

struct type_36 {
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
var<storage> samples: type_21;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_36;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_25;
@group(0) @binding(2) 
var<storage> map: type_33;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_132_: lt_bvh_traverse_Tree;
    var phi_133_: bool;
    var phi_134_: lt_bvh_traverse_Tree;
    var phi_135_: bool;
    var phi_140_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_132_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_133_ = false;
        } else {
            phi_132_ = lt_bvh_traverse_Tree();
            phi_133_ = true;
        }
        let _e43 = phi_132_;
        let _e45 = phi_133_;
        phi_134_ = _e43;
        phi_135_ = _e45;
    } else {
        phi_134_ = lt_bvh_traverse_Tree();
        phi_135_ = true;
    }
    let _e47 = phi_134_;
    let _e49 = phi_135_;
    if _e49 {
        phi_140_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_140_ = _e47;
    }
    let _e54 = phi_140_;
    return lt_bvh_traverse_Tree(_e54.root, _e54.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_to_light(param_4: vec3<f32>, param_5: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_5.x - (param_4.x * param_5.w)), (param_5.y - (param_4.y * param_5.w)), (param_5.z - (param_4.z * param_5.w)));
}

fn lt_shaders_evaluate_quad_indices(param_6: i32, param_7: i32, param_8: u32) -> array<u32, 4> {
    var phi_174_: i32;
    var phi_179_: i32;
    var phi_184_: i32;
    var phi_189_: i32;
    var phi_198_: i32;
    var phi_203_: i32;
    var phi_208_: i32;
    var phi_213_: i32;

    let _e34 = (bitcast<i32>(param_8) - 1i);
    if (param_6 > 0i) {
        phi_174_ = param_6;
    } else {
        phi_174_ = 0i;
    }
    let _e37 = phi_174_;
    if (param_7 > 0i) {
        phi_179_ = param_7;
    } else {
        phi_179_ = 0i;
    }
    let _e40 = phi_179_;
    if (_e37 < _e34) {
        phi_184_ = _e37;
    } else {
        phi_184_ = _e34;
    }
    let _e43 = phi_184_;
    if (_e40 < _e34) {
        phi_189_ = _e40;
    } else {
        phi_189_ = _e34;
    }
    let _e46 = phi_189_;
    let _e47 = bitcast<u32>(_e43);
    let _e49 = (param_6 + 1i);
    let _e50 = (param_7 + 1i);
    if (_e49 > 0i) {
        phi_198_ = _e49;
    } else {
        phi_198_ = 0i;
    }
    let _e53 = phi_198_;
    if (_e50 > 0i) {
        phi_203_ = _e50;
    } else {
        phi_203_ = 0i;
    }
    let _e56 = phi_203_;
    if (_e53 < _e34) {
        phi_208_ = _e53;
    } else {
        phi_208_ = _e34;
    }
    let _e59 = phi_208_;
    if (_e56 < _e34) {
        phi_213_ = _e56;
    } else {
        phi_213_ = _e34;
    }
    let _e62 = phi_213_;
    let _e63 = bitcast<u32>(_e59);
    let _e65 = (bitcast<u32>(_e46) * param_8);
    let _e66 = (bitcast<u32>(_e62) * param_8);
    return array<u32, 4>((_e65 + _e47), (_e65 + _e63), (_e66 + _e47), (_e66 + _e63));
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_9: ptr<function, f32>, param_10: vec4<f32>, param_11: f32) -> f32 {
    var phi_265_: f32;
    var phi_266_: f32;
    var phi_267_: f32;
    var phi_302_: vec2<f32>;
    var phi_336_: f32;
    var phi_337_: f32;
    var phi_338_: f32;
    var phi_367_: f32;
    var phi_368_: f32;
    var phi_369_: f32;
    var phi_373_: f32;
    var phi_374_: f32;
    var phi_375_: f32;

    let _e33 = (*param_9);
    let _e34 = (1f - _e33);
    let _e43 = (0.5f * _e33);
    let _e44 = ((param_10.x * _e34) + _e43);
    let _e45 = ((param_10.y * _e34) + _e43);
    let _e49 = (_e45 - (_e44 * _e44));
    let _e51 = (((param_10.z * _e34) + _e43) - (_e44 * _e45));
    if ((bitcast<u32>(param_11) & 2147483647u) > 2139095040u) {
        phi_267_ = param_11;
    } else {
        if (param_11 < 0f) {
            phi_266_ = 0f;
        } else {
            if (param_11 > 1f) {
                phi_265_ = 1f;
            } else {
                phi_265_ = param_11;
            }
            let _e63 = phi_265_;
            phi_266_ = _e63;
        }
        let _e65 = phi_266_;
        phi_267_ = _e65;
    }
    let _e67 = phi_267_;
    let _e68 = (_e51 / _e49);
    let _e69 = (_e67 - _e44);
    let _e75 = (((((_e67 * _e67) - _e45) - (_e68 * _e69)) * _e49) / (((((param_10.w * _e34) + _e43) - (_e45 * _e45)) * _e49) - (_e51 * _e51)));
    let _e78 = ((_e69 / _e49) - (_e68 * _e75));
    let _e84 = ((0.5f * _e78) / _e75);
    let _e87 = ((_e84 * _e84) - (((1f - (_e78 * _e44)) - (_e75 * _e45)) / _e75));
    if (_e87 >= 0f) {
        let _e89 = sqrt(_e87);
        phi_302_ = vec2<f32>((-(_e84) - _e89), (-(_e84) + _e89));
    } else {
        phi_302_ = vec2(bitcast<f32>((bitcast<u32>(_e87) | 2143289344u)));
    }
    let _e100 = phi_302_;
    if (_e67 <= _e100.x) {
        phi_375_ = 1f;
    } else {
        if (_e67 > _e100.y) {
            let _e113 = (((_e45 - (_e44 * (_e100.x + _e100.y))) + (_e100.x * _e100.y)) / ((_e67 - _e100.x) * (_e67 - _e100.y)));
            if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
                phi_338_ = _e113;
            } else {
                if (_e113 < 0f) {
                    phi_337_ = 0f;
                } else {
                    if (_e113 > 1f) {
                        phi_336_ = 1f;
                    } else {
                        phi_336_ = _e113;
                    }
                    let _e120 = phi_336_;
                    phi_337_ = _e120;
                }
                let _e122 = phi_337_;
                phi_338_ = _e122;
            }
            let _e124 = phi_338_;
            phi_374_ = _e124;
        } else {
            if (_e67 > _e100.x) {
                let _e135 = (1f - (((_e45 - (_e44 * (_e67 + _e100.y))) + (_e67 * _e100.y)) / ((_e100.x - _e67) * (_e100.x - _e100.y))));
                if ((bitcast<u32>(_e135) & 2147483647u) > 2139095040u) {
                    phi_369_ = _e135;
                } else {
                    if (_e135 < 0f) {
                        phi_368_ = 0f;
                    } else {
                        if (_e135 > 1f) {
                            phi_367_ = 1f;
                        } else {
                            phi_367_ = _e135;
                        }
                        let _e142 = phi_367_;
                        phi_368_ = _e142;
                    }
                    let _e144 = phi_368_;
                    phi_369_ = _e144;
                }
                let _e146 = phi_369_;
                phi_373_ = _e146;
            } else {
                phi_373_ = bitcast<f32>((bitcast<u32>(_e100.x) | 2143289344u));
            }
            let _e151 = phi_373_;
            phi_374_ = _e151;
        }
        let _e153 = phi_374_;
        phi_375_ = _e153;
    }
    let _e155 = phi_375_;
    return _e155;
}

fn function_() {
    var local: f32;
    var phi_429_: bool;
    var phi_430_: bool;
    var phi_431_: bool;
    var phi_432_: bool;
    var phi_436_: bool;
    var phi_471_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_475_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_568_: bool;
    var phi_569_: bool;
    var phi_570_: bool;
    var phi_571_: bool;
    var phi_572_: bool;
    var phi_573_: bool;
    var phi_574_: bool;
    var phi_575_: bool;
    var phi_576_: bool;
    var phi_577_: bool;
    var phi_578_: bool;
    var phi_579_: bool;
    var phi_583_: bool;
    var phi_722_: evaluate_Verdict;
    var phi_723_: evaluate_Verdict;
    var phi_724_: bool;
    var phi_725_: evaluate_Verdict;
    var phi_726_: evaluate_Verdict;
    var phi_727_: bool;
    var phi_731_: evaluate_Verdict;

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
                phi_429_ = (_e69 == _e71);
                phi_430_ = false;
            } else {
                phi_429_ = bool();
                phi_430_ = true;
            }
            let _e74 = phi_429_;
            let _e76 = phi_430_;
            phi_431_ = _e74;
            phi_432_ = _e76;
        } else {
            phi_431_ = bool();
            phi_432_ = true;
        }
        let _e78 = phi_431_;
        let _e80 = phi_432_;
        if _e80 {
            phi_436_ = false;
        } else {
            phi_436_ = _e78;
        }
        let _e82 = phi_436_;
        if !(_e82) {
            let _e85 = samples.member[(0u + _e47.first_primitive)].normal;
            let _e87 = samples.member[(0u + _e47.first_primitive)].position;
            let _e88 = lt_shaders_evaluate_to_light(_e87, _e56);
            if ((((_e85.x * _e88.x) + (_e85.y * _e88.y)) + (_e85.z * _e88.z)) > 0f) {
                let _e102 = samples.member[(0u + _e47.first_primitive)].flags;
                let _e110 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e116 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e110.unnamed.visibility, false), _e110.unnamed_1);
                phi_471_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e116.unnamed, ((_e102 & 1u) == 0u));
            } else {
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_471_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, true);
            }
            let _e136 = phi_471_;
            phi_475_ = _e136;
        } else {
            let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e142.unnamed.visibility, false), _e142.unnamed_1);
            phi_475_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e148.unnamed, true);
        }
        let _e153 = phi_475_;
        if _e153.unnamed_1 {
            phi_725_ = evaluate_Verdict(_e153.unnamed.visibility, _e153.unnamed.is_doubted);
            phi_726_ = evaluate_Verdict();
            phi_727_ = true;
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
                                    phi_568_ = (_e219 <= 1f);
                                    phi_569_ = false;
                                } else {
                                    phi_568_ = bool();
                                    phi_569_ = true;
                                }
                                let _e228 = phi_568_;
                                let _e230 = phi_569_;
                                phi_570_ = _e228;
                                phi_571_ = _e230;
                            } else {
                                phi_570_ = bool();
                                phi_571_ = true;
                            }
                            let _e232 = phi_570_;
                            let _e234 = phi_571_;
                            phi_572_ = _e232;
                            phi_573_ = _e234;
                        } else {
                            phi_572_ = bool();
                            phi_573_ = true;
                        }
                        let _e236 = phi_572_;
                        let _e238 = phi_573_;
                        phi_574_ = _e236;
                        phi_575_ = _e238;
                    } else {
                        phi_574_ = bool();
                        phi_575_ = true;
                    }
                    let _e240 = phi_574_;
                    let _e242 = phi_575_;
                    phi_576_ = _e240;
                    phi_577_ = _e242;
                } else {
                    phi_576_ = bool();
                    phi_577_ = true;
                }
                let _e244 = phi_576_;
                let _e246 = phi_577_;
                phi_578_ = _e244;
                phi_579_ = _e246;
            } else {
                phi_578_ = bool();
                phi_579_ = true;
            }
            let _e248 = phi_578_;
            let _e250 = phi_579_;
            if _e250 {
                phi_583_ = false;
            } else {
                phi_583_ = _e248;
            }
            let _e252 = phi_583_;
            if _e252 {
                let _e254 = p.member.map_size;
                let _e255 = f32(_e254);
                let _e258 = ((_e192 * _e255) - 0.5f);
                let _e259 = ((_e206 * _e255) - 0.5f);
                let _e260 = floor(_e258);
                let _e261 = floor(_e259);
                let _e262 = (_e258 - _e260);
                let _e263 = (_e259 - _e261);
                let _e284 = ((1f - _e262) * (1f - _e263));
                let _e286 = (_e262 * (1f - _e263));
                let _e288 = ((1f - _e262) * _e263);
                let _e289 = (_e262 * _e263);
                let _e291 = p.member.test;
                let _e292 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e291);
                let _e294 = p.member.map_size;
                local = _e292;
                let _e295 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e260), i32(-2147483648), (_e260 < bitcast<f32>(3472883712u))), 2147483647i, (_e260 > bitcast<f32>(1325400063u))), (_e260 == _e260)), select(0i, select(select(i32(_e261), i32(-2147483648), (_e261 < bitcast<f32>(3472883712u))), 2147483647i, (_e261 > bitcast<f32>(1325400063u))), (_e261 == _e261)), _e294);
                if (_e295[0] < _e38) {
                } else {
                    return;
                }
                let _e300 = map.member[(0u + _e295[0])];
                if (_e295[1] < _e38) {
                } else {
                    return;
                }
                let _e313 = map.member[(0u + _e295[1])];
                if (_e295[2] < _e38) {
                } else {
                    return;
                }
                let _e330 = map.member[(0u + _e295[2])];
                if (_e295[3] < _e38) {
                } else {
                    return;
                }
                let _e347 = map.member[(0u + _e295[3])];
                let _e361 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e300.x * _e284) + (_e313.x * _e286)) + (_e330.x * _e288)) + (_e347.x * _e289)), ((((_e300.y * _e284) + (_e313.y * _e286)) + (_e330.y * _e288)) + (_e347.y * _e289)), ((((_e300.z * _e284) + (_e313.z * _e286)) + (_e330.z * _e288)) + (_e347.z * _e289)), ((((_e300.w * _e284) + (_e313.w * _e286)) + (_e330.w * _e288)) + (_e347.w * _e289))), _e219);
                phi_722_ = evaluate_Verdict(_e361, false);
                phi_723_ = evaluate_Verdict();
                phi_724_ = false;
            } else {
                phi_722_ = evaluate_Verdict();
                phi_723_ = evaluate_Verdict(1f, false);
                phi_724_ = true;
            }
            let _e365 = phi_722_;
            let _e367 = phi_723_;
            let _e369 = phi_724_;
            phi_725_ = _e367;
            phi_726_ = _e365;
            phi_727_ = _e369;
        }
        let _e371 = phi_725_;
        let _e373 = phi_726_;
        let _e375 = phi_727_;
        if _e375 {
            phi_731_ = _e371;
        } else {
            phi_731_ = _e373;
        }
        let _e377 = phi_731_;
        if (_e47.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e47.first_primitive)] = _e377.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
