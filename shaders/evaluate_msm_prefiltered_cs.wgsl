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
    var phi_133_: lt_bvh_traverse_Tree;
    var phi_134_: bool;
    var phi_135_: lt_bvh_traverse_Tree;
    var phi_136_: bool;
    var phi_141_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_133_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_134_ = false;
        } else {
            phi_133_ = lt_bvh_traverse_Tree();
            phi_134_ = true;
        }
        let _e44 = phi_133_;
        let _e46 = phi_134_;
        phi_135_ = _e44;
        phi_136_ = _e46;
    } else {
        phi_135_ = lt_bvh_traverse_Tree();
        phi_136_ = true;
    }
    let _e48 = phi_135_;
    let _e50 = phi_136_;
    if _e50 {
        phi_141_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_141_ = _e48;
    }
    let _e55 = phi_141_;
    return lt_bvh_traverse_Tree(_e55.root, _e55.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn lt_shaders_evaluate_to_light(param_4: vec3<f32>, param_5: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_5.x - (param_4.x * param_5.w)), (param_5.y - (param_4.y * param_5.w)), (param_5.z - (param_4.z * param_5.w)));
}

fn lt_shaders_evaluate_quad_indices(param_6: i32, param_7: i32, param_8: u32) -> array<u32, 4> {
    var phi_175_: i32;
    var phi_180_: i32;
    var phi_185_: i32;
    var phi_190_: i32;
    var phi_199_: i32;
    var phi_204_: i32;
    var phi_209_: i32;
    var phi_214_: i32;

    let _e35 = (bitcast<i32>(param_8) - 1i);
    if (param_6 > 0i) {
        phi_175_ = param_6;
    } else {
        phi_175_ = 0i;
    }
    let _e38 = phi_175_;
    if (param_7 > 0i) {
        phi_180_ = param_7;
    } else {
        phi_180_ = 0i;
    }
    let _e41 = phi_180_;
    if (_e38 < _e35) {
        phi_185_ = _e38;
    } else {
        phi_185_ = _e35;
    }
    let _e44 = phi_185_;
    if (_e41 < _e35) {
        phi_190_ = _e41;
    } else {
        phi_190_ = _e35;
    }
    let _e47 = phi_190_;
    let _e48 = bitcast<u32>(_e44);
    let _e50 = (param_6 + 1i);
    let _e51 = (param_7 + 1i);
    if (_e50 > 0i) {
        phi_199_ = _e50;
    } else {
        phi_199_ = 0i;
    }
    let _e54 = phi_199_;
    if (_e51 > 0i) {
        phi_204_ = _e51;
    } else {
        phi_204_ = 0i;
    }
    let _e57 = phi_204_;
    if (_e54 < _e35) {
        phi_209_ = _e54;
    } else {
        phi_209_ = _e35;
    }
    let _e60 = phi_209_;
    if (_e57 < _e35) {
        phi_214_ = _e57;
    } else {
        phi_214_ = _e35;
    }
    let _e63 = phi_214_;
    let _e64 = bitcast<u32>(_e60);
    let _e66 = (bitcast<u32>(_e47) * param_8);
    let _e67 = (bitcast<u32>(_e63) * param_8);
    return array<u32, 4>((_e66 + _e48), (_e66 + _e64), (_e67 + _e48), (_e67 + _e64));
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_9: ptr<function, f32>, param_10: vec4<f32>, param_11: f32) -> f32 {
    var phi_266_: f32;
    var phi_267_: f32;
    var phi_268_: f32;
    var phi_291_: f32;
    var phi_292_: f32;
    var phi_293_: f32;
    var phi_294_: f32;
    var phi_295_: bool;
    var phi_296_: f32;
    var phi_297_: bool;
    var phi_335_: vec2<f32>;
    var phi_369_: f32;
    var phi_370_: f32;
    var phi_371_: f32;
    var phi_400_: f32;
    var phi_401_: f32;
    var phi_402_: f32;
    var phi_406_: f32;
    var phi_407_: f32;
    var phi_408_: f32;
    var phi_409_: f32;

    let _e34 = (*param_9);
    let _e35 = (1f - _e34);
    let _e44 = (0.5f * _e34);
    let _e45 = ((param_10.x * _e35) + _e44);
    let _e46 = ((param_10.y * _e35) + _e44);
    let _e48 = ((param_10.w * _e35) + _e44);
    let _e50 = (_e46 - (_e45 * _e45));
    let _e52 = (((param_10.z * _e35) + _e44) - (_e45 * _e46));
    if ((bitcast<u32>(param_11) & 2147483647u) > 2139095040u) {
        phi_268_ = param_11;
    } else {
        if (param_11 < 0f) {
            phi_267_ = 0f;
        } else {
            if (param_11 > 1f) {
                phi_266_ = 1f;
            } else {
                phi_266_ = param_11;
            }
            let _e64 = phi_266_;
            phi_267_ = _e64;
        }
        let _e66 = phi_267_;
        phi_268_ = _e66;
    }
    let _e68 = phi_268_;
    if (_e45 == _e48) {
        if (_e68 > 0f) {
            if ((bitcast<u32>(_e45) & 2147483647u) > 2139095040u) {
                phi_293_ = _e45;
            } else {
                if (_e45 < 0f) {
                    phi_292_ = 0f;
                } else {
                    if (_e45 > 1f) {
                        phi_291_ = 1f;
                    } else {
                        phi_291_ = _e45;
                    }
                    let _e77 = phi_291_;
                    phi_292_ = _e77;
                }
                let _e79 = phi_292_;
                phi_293_ = _e79;
            }
            let _e81 = phi_293_;
            phi_294_ = _e81;
            phi_295_ = false;
        } else {
            phi_294_ = f32();
            phi_295_ = true;
        }
        let _e83 = phi_294_;
        let _e85 = phi_295_;
        phi_296_ = _e83;
        phi_297_ = _e85;
    } else {
        phi_296_ = f32();
        phi_297_ = true;
    }
    let _e87 = phi_296_;
    let _e89 = phi_297_;
    if _e89 {
        let _e90 = (_e52 / _e50);
        let _e91 = (_e68 - _e45);
        let _e97 = (((((_e68 * _e68) - _e46) - (_e90 * _e91)) * _e50) / (((_e48 - (_e46 * _e46)) * _e50) - (_e52 * _e52)));
        let _e100 = ((_e91 / _e50) - (_e90 * _e97));
        let _e106 = ((0.5f * _e100) / _e97);
        let _e109 = ((_e106 * _e106) - (((1f - (_e100 * _e45)) - (_e97 * _e46)) / _e97));
        if (_e109 >= 0f) {
            let _e111 = sqrt(_e109);
            phi_335_ = vec2<f32>((-(_e106) - _e111), (-(_e106) + _e111));
        } else {
            phi_335_ = vec2(bitcast<f32>((bitcast<u32>(_e109) | 2143289344u)));
        }
        let _e122 = phi_335_;
        if (_e68 <= _e122.x) {
            phi_408_ = 1f;
        } else {
            if (_e68 > _e122.y) {
                let _e135 = (((_e46 - (_e45 * (_e122.x + _e122.y))) + (_e122.x * _e122.y)) / ((_e68 - _e122.x) * (_e68 - _e122.y)));
                if ((bitcast<u32>(_e135) & 2147483647u) > 2139095040u) {
                    phi_371_ = _e135;
                } else {
                    if (_e135 < 0f) {
                        phi_370_ = 0f;
                    } else {
                        if (_e135 > 1f) {
                            phi_369_ = 1f;
                        } else {
                            phi_369_ = _e135;
                        }
                        let _e142 = phi_369_;
                        phi_370_ = _e142;
                    }
                    let _e144 = phi_370_;
                    phi_371_ = _e144;
                }
                let _e146 = phi_371_;
                phi_407_ = _e146;
            } else {
                if (_e68 > _e122.x) {
                    let _e157 = (1f - (((_e46 - (_e45 * (_e68 + _e122.y))) + (_e68 * _e122.y)) / ((_e122.x - _e68) * (_e122.x - _e122.y))));
                    if ((bitcast<u32>(_e157) & 2147483647u) > 2139095040u) {
                        phi_402_ = _e157;
                    } else {
                        if (_e157 < 0f) {
                            phi_401_ = 0f;
                        } else {
                            if (_e157 > 1f) {
                                phi_400_ = 1f;
                            } else {
                                phi_400_ = _e157;
                            }
                            let _e164 = phi_400_;
                            phi_401_ = _e164;
                        }
                        let _e166 = phi_401_;
                        phi_402_ = _e166;
                    }
                    let _e168 = phi_402_;
                    phi_406_ = _e168;
                } else {
                    phi_406_ = bitcast<f32>((bitcast<u32>(_e122.x) | 2143289344u));
                }
                let _e173 = phi_406_;
                phi_407_ = _e173;
            }
            let _e175 = phi_407_;
            phi_408_ = _e175;
        }
        let _e177 = phi_408_;
        phi_409_ = _e177;
    } else {
        phi_409_ = _e87;
    }
    let _e179 = phi_409_;
    return _e179;
}

fn function_() {
    var local: f32;
    var phi_463_: bool;
    var phi_464_: bool;
    var phi_465_: bool;
    var phi_466_: bool;
    var phi_470_: bool;
    var phi_505_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_509_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_602_: bool;
    var phi_603_: bool;
    var phi_604_: bool;
    var phi_605_: bool;
    var phi_606_: bool;
    var phi_607_: bool;
    var phi_608_: bool;
    var phi_609_: bool;
    var phi_610_: bool;
    var phi_611_: bool;
    var phi_612_: bool;
    var phi_613_: bool;
    var phi_617_: bool;
    var phi_756_: evaluate_Verdict;
    var phi_757_: evaluate_Verdict;
    var phi_758_: bool;
    var phi_759_: evaluate_Verdict;
    var phi_760_: evaluate_Verdict;
    var phi_761_: bool;
    var phi_765_: evaluate_Verdict;

    let _e32 = id_1;
    let _e39 = arrayLength((&map.member));
    let _e45 = p.member.size[0u];
    let _e47 = p.member.size[1u];
    let _e48 = lt_shaders_entry_pixel_index(_e32, _e45, _e47);
    if (bitcast<i32>(_e48.root) != 0i) {
        if (_e48.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e57 = p.member.light;
        let _e60 = samples.member[(0u + _e48.first_primitive)].normal[0u];
        let _e62 = global[0u];
        if (_e60 == _e62) {
            let _e65 = samples.member[(0u + _e48.first_primitive)].normal[1u];
            let _e67 = global[1u];
            if (_e65 == _e67) {
                let _e70 = samples.member[(0u + _e48.first_primitive)].normal[2u];
                let _e72 = global[2u];
                phi_463_ = (_e70 == _e72);
                phi_464_ = false;
            } else {
                phi_463_ = bool();
                phi_464_ = true;
            }
            let _e75 = phi_463_;
            let _e77 = phi_464_;
            phi_465_ = _e75;
            phi_466_ = _e77;
        } else {
            phi_465_ = bool();
            phi_466_ = true;
        }
        let _e79 = phi_465_;
        let _e81 = phi_466_;
        if _e81 {
            phi_470_ = false;
        } else {
            phi_470_ = _e79;
        }
        let _e83 = phi_470_;
        if !(_e83) {
            let _e86 = samples.member[(0u + _e48.first_primitive)].normal;
            let _e88 = samples.member[(0u + _e48.first_primitive)].position;
            let _e89 = lt_shaders_evaluate_to_light(_e88, _e57);
            if ((((_e86.x * _e89.x) + (_e86.y * _e89.y)) + (_e86.z * _e89.z)) > 0f) {
                let _e103 = samples.member[(0u + _e48.first_primitive)].flags;
                let _e111 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e117 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e111.unnamed.visibility, false), _e111.unnamed_1);
                phi_505_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e117.unnamed, ((_e103 & 1u) == 0u));
            } else {
                let _e126 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e132 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e126.unnamed.visibility, false), _e126.unnamed_1);
                phi_505_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e132.unnamed, true);
            }
            let _e137 = phi_505_;
            phi_509_ = _e137;
        } else {
            let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e149 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e143.unnamed.visibility, false), _e143.unnamed_1);
            phi_509_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e149.unnamed, true);
        }
        let _e154 = phi_509_;
        if _e154.unnamed_1 {
            phi_759_ = evaluate_Verdict(_e154.unnamed.visibility, _e154.unnamed.is_doubted);
            phi_760_ = evaluate_Verdict();
            phi_761_ = true;
        } else {
            let _e162 = samples.member[(0u + _e48.first_primitive)].position;
            let _e168 = p.member.projection.row_w;
            let _e179 = ((((_e168.x * _e162.x) + (_e168.y * _e162.y)) + (_e168.z * _e162.z)) + (_e168.w * 1f));
            let _e181 = p.member.projection.row_x;
            let _e193 = (((((_e181.x * _e162.x) + (_e181.y * _e162.y)) + (_e181.z * _e162.z)) + (_e181.w * 1f)) / _e179);
            let _e195 = p.member.projection.row_y;
            let _e207 = (((((_e195.x * _e162.x) + (_e195.y * _e162.y)) + (_e195.z * _e162.z)) + (_e195.w * 1f)) / _e179);
            let _e209 = p.member.projection.row_z;
            let _e220 = ((((_e209.x * _e162.x) + (_e209.y * _e162.y)) + (_e209.z * _e162.z)) + (_e209.w * 1f));
            if (_e179 > 0f) {
                if (_e193 >= 0f) {
                    if (_e193 <= 1f) {
                        if (_e207 >= 0f) {
                            if (_e207 <= 1f) {
                                if (_e220 >= 0f) {
                                    phi_602_ = (_e220 <= 1f);
                                    phi_603_ = false;
                                } else {
                                    phi_602_ = bool();
                                    phi_603_ = true;
                                }
                                let _e229 = phi_602_;
                                let _e231 = phi_603_;
                                phi_604_ = _e229;
                                phi_605_ = _e231;
                            } else {
                                phi_604_ = bool();
                                phi_605_ = true;
                            }
                            let _e233 = phi_604_;
                            let _e235 = phi_605_;
                            phi_606_ = _e233;
                            phi_607_ = _e235;
                        } else {
                            phi_606_ = bool();
                            phi_607_ = true;
                        }
                        let _e237 = phi_606_;
                        let _e239 = phi_607_;
                        phi_608_ = _e237;
                        phi_609_ = _e239;
                    } else {
                        phi_608_ = bool();
                        phi_609_ = true;
                    }
                    let _e241 = phi_608_;
                    let _e243 = phi_609_;
                    phi_610_ = _e241;
                    phi_611_ = _e243;
                } else {
                    phi_610_ = bool();
                    phi_611_ = true;
                }
                let _e245 = phi_610_;
                let _e247 = phi_611_;
                phi_612_ = _e245;
                phi_613_ = _e247;
            } else {
                phi_612_ = bool();
                phi_613_ = true;
            }
            let _e249 = phi_612_;
            let _e251 = phi_613_;
            if _e251 {
                phi_617_ = false;
            } else {
                phi_617_ = _e249;
            }
            let _e253 = phi_617_;
            if _e253 {
                let _e255 = p.member.map_size;
                let _e256 = f32(_e255);
                let _e259 = ((_e193 * _e256) - 0.5f);
                let _e260 = ((_e207 * _e256) - 0.5f);
                let _e261 = floor(_e259);
                let _e262 = floor(_e260);
                let _e263 = (_e259 - _e261);
                let _e264 = (_e260 - _e262);
                let _e285 = ((1f - _e263) * (1f - _e264));
                let _e287 = (_e263 * (1f - _e264));
                let _e289 = ((1f - _e263) * _e264);
                let _e290 = (_e263 * _e264);
                let _e292 = p.member.test;
                let _e293 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e292);
                let _e295 = p.member.map_size;
                local = _e293;
                let _e296 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e261), i32(-2147483648), (_e261 < bitcast<f32>(3472883712u))), 2147483647i, (_e261 > bitcast<f32>(1325400063u))), (_e261 == _e261)), select(0i, select(select(i32(_e262), i32(-2147483648), (_e262 < bitcast<f32>(3472883712u))), 2147483647i, (_e262 > bitcast<f32>(1325400063u))), (_e262 == _e262)), _e295);
                if (_e296[0] < _e39) {
                } else {
                    return;
                }
                let _e301 = map.member[(0u + _e296[0])];
                if (_e296[1] < _e39) {
                } else {
                    return;
                }
                let _e314 = map.member[(0u + _e296[1])];
                if (_e296[2] < _e39) {
                } else {
                    return;
                }
                let _e331 = map.member[(0u + _e296[2])];
                if (_e296[3] < _e39) {
                } else {
                    return;
                }
                let _e348 = map.member[(0u + _e296[3])];
                let _e362 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e301.x * _e285) + (_e314.x * _e287)) + (_e331.x * _e289)) + (_e348.x * _e290)), ((((_e301.y * _e285) + (_e314.y * _e287)) + (_e331.y * _e289)) + (_e348.y * _e290)), ((((_e301.z * _e285) + (_e314.z * _e287)) + (_e331.z * _e289)) + (_e348.z * _e290)), ((((_e301.w * _e285) + (_e314.w * _e287)) + (_e331.w * _e289)) + (_e348.w * _e290))), _e220);
                phi_756_ = evaluate_Verdict(_e362, false);
                phi_757_ = evaluate_Verdict();
                phi_758_ = false;
            } else {
                phi_756_ = evaluate_Verdict();
                phi_757_ = evaluate_Verdict(1f, false);
                phi_758_ = true;
            }
            let _e366 = phi_756_;
            let _e368 = phi_757_;
            let _e370 = phi_758_;
            phi_759_ = _e368;
            phi_760_ = _e366;
            phi_761_ = _e370;
        }
        let _e372 = phi_759_;
        let _e374 = phi_760_;
        let _e376 = phi_761_;
        if _e376 {
            phi_765_ = _e372;
        } else {
            phi_765_ = _e374;
        }
        let _e378 = phi_765_;
        if (_e48.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e48.first_primitive)] = _e378.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
