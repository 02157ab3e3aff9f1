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

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
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

struct type_31 {
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
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> map: type_24;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;

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

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_164_: f32;
    var phi_165_: f32;
    var phi_166_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_166_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_165_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_164_ = 1f;
            } else {
                phi_164_ = param_4;
            }
            let _e38 = phi_164_;
            phi_165_ = _e38;
        }
        let _e40 = phi_165_;
        phi_166_ = _e40;
    }
    let _e42 = phi_166_;
    let _e43 = (_e42 * _e42);
    return vec4<f32>(_e42, _e43, (_e43 * _e42), (_e43 * _e43));
}

fn lt_shaders_evaluate_to_light(param_5: vec3<f32>, param_6: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_6.x - (param_5.x * param_6.w)), (param_6.y - (param_5.y * param_6.w)), (param_6.z - (param_5.z * param_6.w)));
}

fn lt_shaders_evaluate_quad_indices(param_7: i32, param_8: i32, param_9: u32) -> array<u32, 4> {
    var phi_198_: i32;
    var phi_203_: i32;
    var phi_208_: i32;
    var phi_213_: i32;
    var phi_222_: i32;
    var phi_227_: i32;
    var phi_232_: i32;
    var phi_237_: i32;

    let _e35 = (bitcast<i32>(param_9) - 1i);
    if (param_7 > 0i) {
        phi_198_ = param_7;
    } else {
        phi_198_ = 0i;
    }
    let _e38 = phi_198_;
    if (param_8 > 0i) {
        phi_203_ = param_8;
    } else {
        phi_203_ = 0i;
    }
    let _e41 = phi_203_;
    if (_e38 < _e35) {
        phi_208_ = _e38;
    } else {
        phi_208_ = _e35;
    }
    let _e44 = phi_208_;
    if (_e41 < _e35) {
        phi_213_ = _e41;
    } else {
        phi_213_ = _e35;
    }
    let _e47 = phi_213_;
    let _e48 = bitcast<u32>(_e44);
    let _e50 = (param_7 + 1i);
    let _e51 = (param_8 + 1i);
    if (_e50 > 0i) {
        phi_222_ = _e50;
    } else {
        phi_222_ = 0i;
    }
    let _e54 = phi_222_;
    if (_e51 > 0i) {
        phi_227_ = _e51;
    } else {
        phi_227_ = 0i;
    }
    let _e57 = phi_227_;
    if (_e54 < _e35) {
        phi_232_ = _e54;
    } else {
        phi_232_ = _e35;
    }
    let _e60 = phi_232_;
    if (_e57 < _e35) {
        phi_237_ = _e57;
    } else {
        phi_237_ = _e35;
    }
    let _e63 = phi_237_;
    let _e64 = bitcast<u32>(_e60);
    let _e66 = (bitcast<u32>(_e47) * param_9);
    let _e67 = (bitcast<u32>(_e63) * param_9);
    return array<u32, 4>((_e66 + _e48), (_e66 + _e64), (_e67 + _e48), (_e67 + _e64));
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_10: ptr<function, f32>, param_11: vec4<f32>, param_12: f32) -> f32 {
    var phi_671_: f32;
    var phi_672_: f32;
    var phi_673_: f32;
    var phi_696_: f32;
    var phi_697_: f32;
    var phi_698_: f32;
    var phi_699_: f32;
    var phi_700_: bool;
    var phi_701_: f32;
    var phi_702_: bool;
    var phi_740_: vec2<f32>;
    var phi_774_: f32;
    var phi_775_: f32;
    var phi_776_: f32;
    var phi_805_: f32;
    var phi_806_: f32;
    var phi_807_: f32;
    var phi_811_: f32;
    var phi_812_: f32;
    var phi_813_: f32;
    var phi_814_: f32;

    let _e34 = (*param_10);
    let _e35 = (1f - _e34);
    let _e44 = (0.5f * _e34);
    let _e45 = ((param_11.x * _e35) + _e44);
    let _e46 = ((param_11.y * _e35) + _e44);
    let _e48 = ((param_11.w * _e35) + _e44);
    let _e50 = (_e46 - (_e45 * _e45));
    let _e52 = (((param_11.z * _e35) + _e44) - (_e45 * _e46));
    if ((bitcast<u32>(param_12) & 2147483647u) > 2139095040u) {
        phi_673_ = param_12;
    } else {
        if (param_12 < 0f) {
            phi_672_ = 0f;
        } else {
            if (param_12 > 1f) {
                phi_671_ = 1f;
            } else {
                phi_671_ = param_12;
            }
            let _e64 = phi_671_;
            phi_672_ = _e64;
        }
        let _e66 = phi_672_;
        phi_673_ = _e66;
    }
    let _e68 = phi_673_;
    if (_e45 == _e48) {
        if (_e68 > 0f) {
            if ((bitcast<u32>(_e45) & 2147483647u) > 2139095040u) {
                phi_698_ = _e45;
            } else {
                if (_e45 < 0f) {
                    phi_697_ = 0f;
                } else {
                    if (_e45 > 1f) {
                        phi_696_ = 1f;
                    } else {
                        phi_696_ = _e45;
                    }
                    let _e77 = phi_696_;
                    phi_697_ = _e77;
                }
                let _e79 = phi_697_;
                phi_698_ = _e79;
            }
            let _e81 = phi_698_;
            phi_699_ = _e81;
            phi_700_ = false;
        } else {
            phi_699_ = f32();
            phi_700_ = true;
        }
        let _e83 = phi_699_;
        let _e85 = phi_700_;
        phi_701_ = _e83;
        phi_702_ = _e85;
    } else {
        phi_701_ = f32();
        phi_702_ = true;
    }
    let _e87 = phi_701_;
    let _e89 = phi_702_;
    if _e89 {
        let _e90 = (_e52 / _e50);
        let _e91 = (_e68 - _e45);
        let _e97 = (((((_e68 * _e68) - _e46) - (_e90 * _e91)) * _e50) / (((_e48 - (_e46 * _e46)) * _e50) - (_e52 * _e52)));
        let _e100 = ((_e91 / _e50) - (_e90 * _e97));
        let _e106 = ((0.5f * _e100) / _e97);
        let _e109 = ((_e106 * _e106) - (((1f - (_e100 * _e45)) - (_e97 * _e46)) / _e97));
        if (_e109 >= 0f) {
            let _e111 = sqrt(_e109);
            phi_740_ = vec2<f32>((-(_e106) - _e111), (-(_e106) + _e111));
        } else {
            phi_740_ = vec2(bitcast<f32>((bitcast<u32>(_e109) | 2143289344u)));
        }
        let _e122 = phi_740_;
        if (_e68 <= _e122.x) {
            phi_813_ = 1f;
        } else {
            if (_e68 > _e122.y) {
                let _e135 = (((_e46 - (_e45 * (_e122.x + _e122.y))) + (_e122.x * _e122.y)) / ((_e68 - _e122.x) * (_e68 - _e122.y)));
                if ((bitcast<u32>(_e135) & 2147483647u) > 2139095040u) {
                    phi_776_ = _e135;
                } else {
                    if (_e135 < 0f) {
                        phi_775_ = 0f;
                    } else {
                        if (_e135 > 1f) {
                            phi_774_ = 1f;
                        } else {
                            phi_774_ = _e135;
                        }
                        let _e142 = phi_774_;
                        phi_775_ = _e142;
                    }
                    let _e144 = phi_775_;
                    phi_776_ = _e144;
                }
                let _e146 = phi_776_;
                phi_812_ = _e146;
            } else {
                if (_e68 > _e122.x) {
                    let _e157 = (1f - (((_e46 - (_e45 * (_e68 + _e122.y))) + (_e68 * _e122.y)) / ((_e122.x - _e68) * (_e122.x - _e122.y))));
                    if ((bitcast<u32>(_e157) & 2147483647u) > 2139095040u) {
                        phi_807_ = _e157;
                    } else {
                        if (_e157 < 0f) {
                            phi_806_ = 0f;
                        } else {
                            if (_e157 > 1f) {
                                phi_805_ = 1f;
                            } else {
                                phi_805_ = _e157;
                            }
                            let _e164 = phi_805_;
                            phi_806_ = _e164;
                        }
                        let _e166 = phi_806_;
                        phi_807_ = _e166;
                    }
                    let _e168 = phi_807_;
                    phi_811_ = _e168;
                } else {
                    phi_811_ = bitcast<f32>((bitcast<u32>(_e122.x) | 2143289344u));
                }
                let _e173 = phi_811_;
                phi_812_ = _e173;
            }
            let _e175 = phi_812_;
            phi_813_ = _e175;
        }
        let _e177 = phi_813_;
        phi_814_ = _e177;
    } else {
        phi_814_ = _e87;
    }
    let _e179 = phi_814_;
    return _e179;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_13: ptr<function, f32>, param_14: vec4<f32>, param_15: vec4<f32>, param_16: f32) -> f32 {
    let _e36 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_14.x);
    let _e38 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_14.y);
    let _e40 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_14.z);
    let _e42 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_14.w);
    let _e92 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_13, vec4<f32>(((((_e36.x * param_15.x) + (_e38.x * param_15.y)) + (_e40.x * param_15.z)) + (_e42.x * param_15.w)), ((((_e36.y * param_15.x) + (_e38.y * param_15.y)) + (_e40.y * param_15.z)) + (_e42.y * param_15.w)), ((((_e36.z * param_15.x) + (_e38.z * param_15.y)) + (_e40.z * param_15.z)) + (_e42.z * param_15.w)), ((((_e36.w * param_15.x) + (_e38.w * param_15.y)) + (_e40.w * param_15.z)) + (_e42.w * param_15.w))), param_16);
    return _e92;
}

fn function_() {
    var local: f32;
    var phi_300_: bool;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_307_: bool;
    var phi_342_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_346_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_439_: bool;
    var phi_440_: bool;
    var phi_441_: bool;
    var phi_442_: bool;
    var phi_443_: bool;
    var phi_444_: bool;
    var phi_445_: bool;
    var phi_446_: bool;
    var phi_447_: bool;
    var phi_448_: bool;
    var phi_449_: bool;
    var phi_450_: bool;
    var phi_454_: bool;
    var phi_549_: evaluate_Verdict;
    var phi_550_: evaluate_Verdict;
    var phi_551_: bool;
    var phi_552_: evaluate_Verdict;
    var phi_553_: evaluate_Verdict;
    var phi_554_: bool;
    var phi_558_: evaluate_Verdict;

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
                phi_300_ = (_e70 == _e72);
                phi_301_ = false;
            } else {
                phi_300_ = bool();
                phi_301_ = true;
            }
            let _e75 = phi_300_;
            let _e77 = phi_301_;
            phi_302_ = _e75;
            phi_303_ = _e77;
        } else {
            phi_302_ = bool();
            phi_303_ = true;
        }
        let _e79 = phi_302_;
        let _e81 = phi_303_;
        if _e81 {
            phi_307_ = false;
        } else {
            phi_307_ = _e79;
        }
        let _e83 = phi_307_;
        if !(_e83) {
            let _e86 = samples.member[(0u + _e48.first_primitive)].normal;
            let _e88 = samples.member[(0u + _e48.first_primitive)].position;
            let _e89 = lt_shaders_evaluate_to_light(_e88, _e57);
            if ((((_e86.x * _e89.x) + (_e86.y * _e89.y)) + (_e86.z * _e89.z)) > 0f) {
                let _e103 = samples.member[(0u + _e48.first_primitive)].flags;
                let _e111 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e117 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e111.unnamed.visibility, false), _e111.unnamed_1);
                phi_342_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e117.unnamed, ((_e103 & 1u) == 0u));
            } else {
                let _e126 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e132 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e126.unnamed.visibility, false), _e126.unnamed_1);
                phi_342_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e132.unnamed, true);
            }
            let _e137 = phi_342_;
            phi_346_ = _e137;
        } else {
            let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e149 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e143.unnamed.visibility, false), _e143.unnamed_1);
            phi_346_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e149.unnamed, true);
        }
        let _e154 = phi_346_;
        if _e154.unnamed_1 {
            phi_552_ = evaluate_Verdict(_e154.unnamed.visibility, _e154.unnamed.is_doubted);
            phi_553_ = evaluate_Verdict();
            phi_554_ = true;
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
                                    phi_439_ = (_e220 <= 1f);
                                    phi_440_ = false;
                                } else {
                                    phi_439_ = bool();
                                    phi_440_ = true;
                                }
                                let _e229 = phi_439_;
                                let _e231 = phi_440_;
                                phi_441_ = _e229;
                                phi_442_ = _e231;
                            } else {
                                phi_441_ = bool();
                                phi_442_ = true;
                            }
                            let _e233 = phi_441_;
                            let _e235 = phi_442_;
                            phi_443_ = _e233;
                            phi_444_ = _e235;
                        } else {
                            phi_443_ = bool();
                            phi_444_ = true;
                        }
                        let _e237 = phi_443_;
                        let _e239 = phi_444_;
                        phi_445_ = _e237;
                        phi_446_ = _e239;
                    } else {
                        phi_445_ = bool();
                        phi_446_ = true;
                    }
                    let _e241 = phi_445_;
                    let _e243 = phi_446_;
                    phi_447_ = _e241;
                    phi_448_ = _e243;
                } else {
                    phi_447_ = bool();
                    phi_448_ = true;
                }
                let _e245 = phi_447_;
                let _e247 = phi_448_;
                phi_449_ = _e245;
                phi_450_ = _e247;
            } else {
                phi_449_ = bool();
                phi_450_ = true;
            }
            let _e249 = phi_449_;
            let _e251 = phi_450_;
            if _e251 {
                phi_454_ = false;
            } else {
                phi_454_ = _e249;
            }
            let _e253 = phi_454_;
            if _e253 {
                let _e255 = p.member.map_size;
                let _e256 = f32(_e255);
                let _e259 = ((_e193 * _e256) - 0.5f);
                let _e260 = ((_e207 * _e256) - 0.5f);
                let _e261 = floor(_e259);
                let _e262 = floor(_e260);
                let _e263 = (_e259 - _e261);
                let _e264 = (_e260 - _e262);
                let _e293 = p.member.test;
                let _e294 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e293);
                let _e296 = p.member.map_size;
                local = _e294;
                let _e297 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e261), i32(-2147483648), (_e261 < bitcast<f32>(3472883712u))), 2147483647i, (_e261 > bitcast<f32>(1325400063u))), (_e261 == _e261)), select(0i, select(select(i32(_e262), i32(-2147483648), (_e262 < bitcast<f32>(3472883712u))), 2147483647i, (_e262 > bitcast<f32>(1325400063u))), (_e262 == _e262)), _e296);
                if (_e297[0] < _e39) {
                } else {
                    return;
                }
                let _e302 = map.member[(0u + _e297[0])];
                if (_e297[1] < _e39) {
                } else {
                    return;
                }
                let _e307 = map.member[(0u + _e297[1])];
                if (_e297[2] < _e39) {
                } else {
                    return;
                }
                let _e312 = map.member[(0u + _e297[2])];
                if (_e297[3] < _e39) {
                } else {
                    return;
                }
                let _e317 = map.member[(0u + _e297[3])];
                let _e319 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e302, _e307, _e312, _e317), vec4<f32>(((1f - _e263) * (1f - _e264)), (_e263 * (1f - _e264)), ((1f - _e263) * _e264), (_e263 * _e264)), _e220);
                phi_549_ = evaluate_Verdict(_e319, false);
                phi_550_ = evaluate_Verdict();
                phi_551_ = false;
            } else {
                phi_549_ = evaluate_Verdict();
                phi_550_ = evaluate_Verdict(1f, false);
                phi_551_ = true;
            }
            let _e323 = phi_549_;
            let _e325 = phi_550_;
            let _e327 = phi_551_;
            phi_552_ = _e325;
            phi_553_ = _e323;
            phi_554_ = _e327;
        }
        let _e329 = phi_552_;
        let _e331 = phi_553_;
        let _e333 = phi_554_;
        if _e333 {
            phi_558_ = _e329;
        } else {
            phi_558_ = _e331;
        }
        let _e335 = phi_558_;
        if (_e48.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e48.first_primitive)] = _e335.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
