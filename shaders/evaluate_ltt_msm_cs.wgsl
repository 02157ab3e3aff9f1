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

struct type_38 {
    member: abi_ShadowParams,
}

struct type_44 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_38;
@group(0) @binding(2) 
var<storage> map: type_18;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_44;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_146_: lt_bvh_traverse_Tree;
    var phi_147_: bool;
    var phi_148_: lt_bvh_traverse_Tree;
    var phi_149_: bool;
    var phi_154_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_146_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_147_ = false;
        } else {
            phi_146_ = lt_bvh_traverse_Tree();
            phi_147_ = true;
        }
        let _e51 = phi_146_;
        let _e53 = phi_147_;
        phi_148_ = _e51;
        phi_149_ = _e53;
    } else {
        phi_148_ = lt_bvh_traverse_Tree();
        phi_149_ = true;
    }
    let _e55 = phi_148_;
    let _e57 = phi_149_;
    if _e57 {
        phi_154_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_154_ = _e55;
    }
    let _e62 = phi_154_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: f32) -> vec4<f32> {
    var phi_177_: f32;
    var phi_178_: f32;
    var phi_179_: f32;

    if ((bitcast<u32>(param_4) & 2147483647u) > 2139095040u) {
        phi_179_ = param_4;
    } else {
        if (param_4 < 0f) {
            phi_178_ = 0f;
        } else {
            if (param_4 > 1f) {
                phi_177_ = 1f;
            } else {
                phi_177_ = param_4;
            }
            let _e45 = phi_177_;
            phi_178_ = _e45;
        }
        let _e47 = phi_178_;
        phi_179_ = _e47;
    }
    let _e49 = phi_179_;
    let _e50 = (_e49 * _e49);
    return vec4<f32>(_e49, _e50, (_e50 * _e49), (_e50 * _e50));
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_226_: f32;
    var phi_227_: f32;
    var phi_228_: f32;
    var phi_234_: bool;
    var phi_256_: f32;
    var phi_257_: f32;
    var phi_258_: f32;
    var phi_259_: f32;
    var phi_260_: bool;
    var phi_261_: f32;
    var phi_262_: bool;
    var phi_300_: vec2<f32>;
    var phi_334_: f32;
    var phi_335_: f32;
    var phi_336_: f32;
    var phi_365_: f32;
    var phi_366_: f32;
    var phi_367_: f32;
    var phi_371_: f32;
    var phi_372_: f32;
    var phi_373_: f32;
    var phi_374_: f32;

    let _e41 = (*param_5);
    let _e42 = (1f - _e41);
    let _e51 = (0.5f * _e41);
    let _e52 = ((param_6.x * _e42) + _e51);
    let _e53 = ((param_6.y * _e42) + _e51);
    let _e55 = ((param_6.w * _e42) + _e51);
    let _e57 = (_e53 - (_e52 * _e52));
    let _e59 = (((param_6.z * _e42) + _e51) - (_e52 * _e53));
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_228_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_227_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_226_ = 1f;
            } else {
                phi_226_ = param_7;
            }
            let _e71 = phi_226_;
            phi_227_ = _e71;
        }
        let _e73 = phi_227_;
        phi_228_ = _e73;
    }
    let _e75 = phi_228_;
    if (_e52 == _e55) {
        phi_234_ = (_e52 > 0.5f);
    } else {
        phi_234_ = false;
    }
    let _e79 = phi_234_;
    if _e79 {
        if (_e75 > 0f) {
            if ((bitcast<u32>(_e52) & 2147483647u) > 2139095040u) {
                phi_258_ = _e52;
            } else {
                if (_e52 < 0f) {
                    phi_257_ = 0f;
                } else {
                    if (_e52 > 1f) {
                        phi_256_ = 1f;
                    } else {
                        phi_256_ = _e52;
                    }
                    let _e87 = phi_256_;
                    phi_257_ = _e87;
                }
                let _e89 = phi_257_;
                phi_258_ = _e89;
            }
            let _e91 = phi_258_;
            phi_259_ = _e91;
            phi_260_ = false;
        } else {
            phi_259_ = f32();
            phi_260_ = true;
        }
        let _e93 = phi_259_;
        let _e95 = phi_260_;
        phi_261_ = _e93;
        phi_262_ = _e95;
    } else {
        phi_261_ = f32();
        phi_262_ = true;
    }
    let _e97 = phi_261_;
    let _e99 = phi_262_;
    if _e99 {
        let _e100 = (_e59 / _e57);
        let _e101 = (_e75 - _e52);
        let _e107 = (((((_e75 * _e75) - _e53) - (_e100 * _e101)) * _e57) / (((_e55 - (_e53 * _e53)) * _e57) - (_e59 * _e59)));
        let _e110 = ((_e101 / _e57) - (_e100 * _e107));
        let _e116 = ((0.5f * _e110) / _e107);
        let _e119 = ((_e116 * _e116) - (((1f - (_e110 * _e52)) - (_e107 * _e53)) / _e107));
        if (_e119 >= 0f) {
            let _e121 = sqrt(_e119);
            phi_300_ = vec2<f32>((-(_e116) - _e121), (-(_e116) + _e121));
        } else {
            phi_300_ = vec2(bitcast<f32>((bitcast<u32>(_e119) | 2143289344u)));
        }
        let _e132 = phi_300_;
        if (_e75 <= _e132.x) {
            phi_373_ = 1f;
        } else {
            if (_e75 > _e132.y) {
                let _e145 = (((_e53 - (_e52 * (_e132.x + _e132.y))) + (_e132.x * _e132.y)) / ((_e75 - _e132.x) * (_e75 - _e132.y)));
                if ((bitcast<u32>(_e145) & 2147483647u) > 2139095040u) {
                    phi_336_ = _e145;
                } else {
                    if (_e145 < 0f) {
                        phi_335_ = 0f;
                    } else {
                        if (_e145 > 1f) {
                            phi_334_ = 1f;
                        } else {
                            phi_334_ = _e145;
                        }
                        let _e152 = phi_334_;
                        phi_335_ = _e152;
                    }
                    let _e154 = phi_335_;
                    phi_336_ = _e154;
                }
                let _e156 = phi_336_;
                phi_372_ = _e156;
            } else {
                if (_e75 > _e132.x) {
                    let _e167 = (1f - (((_e53 - (_e52 * (_e75 + _e132.y))) + (_e75 * _e132.y)) / ((_e132.x - _e75) * (_e132.x - _e132.y))));
                    if ((bitcast<u32>(_e167) & 2147483647u) > 2139095040u) {
                        phi_367_ = _e167;
                    } else {
                        if (_e167 < 0f) {
                            phi_366_ = 0f;
                        } else {
                            if (_e167 > 1f) {
                                phi_365_ = 1f;
                            } else {
                                phi_365_ = _e167;
                            }
                            let _e174 = phi_365_;
                            phi_366_ = _e174;
                        }
                        let _e176 = phi_366_;
                        phi_367_ = _e176;
                    }
                    let _e178 = phi_367_;
                    phi_371_ = _e178;
                } else {
                    phi_371_ = bitcast<f32>((bitcast<u32>(_e132.x) | 2143289344u));
                }
                let _e183 = phi_371_;
                phi_372_ = _e183;
            }
            let _e185 = phi_372_;
            phi_373_ = _e185;
        }
        let _e187 = phi_373_;
        phi_374_ = _e187;
    } else {
        phi_374_ = _e97;
    }
    let _e189 = phi_374_;
    return _e189;
}

fn function_() {
    var local_1: f32;
    var phi_423_: bool;
    var phi_424_: bool;
    var phi_425_: bool;
    var phi_426_: bool;
    var phi_430_: bool;
    var phi_474_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_478_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_555_: bool;
    var phi_564_: bool;
    var phi_573_: bool;
    var phi_574_: bool;
    var phi_575_: bool;
    var phi_576_: bool;
    var phi_577_: bool;
    var phi_578_: bool;
    var phi_579_: bool;
    var phi_583_: bool;
    var phi_677_: f32;
    var phi_680_: f32;
    var phi_709_: f32;
    var phi_714_: f32;
    var phi_715_: bool;
    var phi_716_: f32;
    var phi_717_: bool;
    var phi_721_: f32;
    var phi_741_: f32;
    var phi_746_: f32;
    var phi_747_: bool;
    var phi_748_: f32;
    var phi_749_: bool;
    var phi_753_: f32;
    var phi_799_: i32;
    var phi_804_: i32;
    var phi_809_: i32;
    var phi_814_: i32;
    var phi_823_: i32;
    var phi_828_: i32;
    var phi_833_: i32;
    var phi_838_: i32;
    var phi_933_: bool;
    var phi_941_: bool;
    var phi_953_: bool;
    var phi_954_: bool;
    var phi_958_: f32;
    var phi_964_: f32;
    var phi_966_: evaluate_Verdict;
    var phi_971_: evaluate_Verdict;
    var phi_972_: evaluate_Verdict;
    var phi_976_: bool;
    var phi_977_: u32;
    var phi_988_: u32;

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
                phi_423_ = (_e73 == _e75);
                phi_424_ = false;
            } else {
                phi_423_ = bool();
                phi_424_ = true;
            }
            let _e78 = phi_423_;
            let _e80 = phi_424_;
            phi_425_ = _e78;
            phi_426_ = _e80;
        } else {
            phi_425_ = bool();
            phi_426_ = true;
        }
        let _e82 = phi_425_;
        let _e84 = phi_426_;
        if _e84 {
            phi_430_ = false;
        } else {
            phi_430_ = _e82;
        }
        let _e86 = phi_430_;
        if !(_e86) {
            let _e89 = samples.member[_e53.first_primitive].normal;
            let _e91 = samples.member[_e53.first_primitive].position;
            if ((((_e89.x * (_e60.x - (_e91.x * _e60.w))) + (_e89.y * (_e60.y - (_e91.y * _e60.w)))) + (_e89.z * (_e60.z - (_e91.z * _e60.w)))) > 0f) {
                let _e115 = samples.member[_e53.first_primitive].flags;
                let _e123 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e123.unnamed.visibility, false), _e123.unnamed_1);
                phi_474_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e129.unnamed, ((_e115 & 1u) == 0u));
            } else {
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_474_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, true);
            }
            let _e149 = phi_474_;
            phi_478_ = _e149;
        } else {
            let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e155.unnamed.visibility, false), _e155.unnamed_1);
            phi_478_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e161.unnamed, true);
        }
        let _e166 = phi_478_;
        if _e166.unnamed_1 {
            phi_972_ = evaluate_Verdict(_e166.unnamed.visibility, _e166.unnamed.is_doubted);
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
                    phi_555_ = (_e205 <= 1f);
                } else {
                    phi_555_ = false;
                }
                let _e237 = phi_555_;
                if _e237 {
                    if (_e219 >= 0f) {
                        phi_564_ = (_e219 <= 1f);
                    } else {
                        phi_564_ = false;
                    }
                    let _e241 = phi_564_;
                    if _e241 {
                        if (_e232 >= 0f) {
                            phi_573_ = (_e232 <= 1f);
                        } else {
                            phi_573_ = false;
                        }
                        let _e245 = phi_573_;
                        phi_574_ = _e245;
                        phi_575_ = false;
                    } else {
                        phi_574_ = bool();
                        phi_575_ = true;
                    }
                    let _e247 = phi_574_;
                    let _e249 = phi_575_;
                    phi_576_ = _e247;
                    phi_577_ = _e249;
                } else {
                    phi_576_ = bool();
                    phi_577_ = true;
                }
                let _e251 = phi_576_;
                let _e253 = phi_577_;
                phi_578_ = _e251;
                phi_579_ = _e253;
            } else {
                phi_578_ = bool();
                phi_579_ = true;
            }
            let _e255 = phi_578_;
            let _e257 = phi_579_;
            if _e257 {
                phi_583_ = false;
            } else {
                phi_583_ = _e255;
            }
            let _e259 = phi_583_;
            if _e259 {
                if (0f > 0f) {
                    let _e262 = samples.member[_e53.first_primitive].normal;
                    let _e264 = p.member.map_size;
                    let _e267 = p.member.projection.row_x;
                    let _e289 = p.member.projection.row_y;
                    let _e311 = p.member.projection.row_z;
                    let _e338 = ((abs(((((_e267.x * _e262.x) + (_e267.y * _e262.y)) + (_e267.z * _e262.z)) / (((_e267.x * _e267.x) + (_e267.y * _e267.y)) + (_e267.z * _e267.z)))) + abs(((((_e289.x * _e262.x) + (_e289.y * _e262.y)) + (_e289.z * _e262.z)) / (((_e289.x * _e289.x) + (_e289.y * _e289.y)) + (_e289.z * _e289.z))))) / (abs(((((_e311.x * _e262.x) + (_e311.y * _e262.y)) + (_e311.z * _e262.z)) / (((_e311.x * _e311.x) + (_e311.y * _e311.y)) + (_e311.z * _e311.z)))) * f32(_e264)));
                    if (_e338 < 0.002f) {
                        phi_677_ = _e338;
                    } else {
                        phi_677_ = 0.002f;
                    }
                    let _e341 = phi_677_;
                    phi_680_ = (_e232 - (0f * _e341));
                } else {
                    phi_680_ = _e232;
                }
                let _e345 = phi_680_;
                let _e347 = p.member.map_size;
                let _e348 = f32(_e347);
                let _e351 = ((_e205 * _e348) - 0.5f);
                let _e352 = ((_e219 * _e348) - 0.5f);
                if (_e351 > -8388608f) {
                    let _e364 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e364 > _e351) {
                        phi_709_ = 1f;
                    } else {
                        phi_709_ = 0f;
                    }
                    let _e367 = phi_709_;
                    if (_e351 < 8388608f) {
                        phi_714_ = (_e364 - _e367);
                        phi_715_ = false;
                    } else {
                        phi_714_ = f32();
                        phi_715_ = true;
                    }
                    let _e370 = phi_714_;
                    let _e372 = phi_715_;
                    phi_716_ = _e370;
                    phi_717_ = _e372;
                } else {
                    phi_716_ = f32();
                    phi_717_ = true;
                }
                let _e374 = phi_716_;
                let _e376 = phi_717_;
                if _e376 {
                    phi_721_ = _e351;
                } else {
                    phi_721_ = _e374;
                }
                let _e378 = phi_721_;
                if (_e352 > -8388608f) {
                    let _e390 = f32(select(0i, select(select(i32(_e352), i32(-2147483648), (_e352 < bitcast<f32>(3472883712u))), 2147483647i, (_e352 > bitcast<f32>(1325400063u))), (_e352 == _e352)));
                    if (_e390 > _e352) {
                        phi_741_ = 1f;
                    } else {
                        phi_741_ = 0f;
                    }
                    let _e393 = phi_741_;
                    if (_e352 < 8388608f) {
                        phi_746_ = (_e390 - _e393);
                        phi_747_ = false;
                    } else {
                        phi_746_ = f32();
                        phi_747_ = true;
                    }
                    let _e396 = phi_746_;
                    let _e398 = phi_747_;
                    phi_748_ = _e396;
                    phi_749_ = _e398;
                } else {
                    phi_748_ = f32();
                    phi_749_ = true;
                }
                let _e400 = phi_748_;
                let _e402 = phi_749_;
                if _e402 {
                    phi_753_ = _e352;
                } else {
                    phi_753_ = _e400;
                }
                let _e404 = phi_753_;
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
                    phi_799_ = _e415;
                } else {
                    phi_799_ = 0i;
                }
                let _e442 = phi_799_;
                if (_e424 > 0i) {
                    phi_804_ = _e424;
                } else {
                    phi_804_ = 0i;
                }
                let _e445 = phi_804_;
                if (_e442 < _e439) {
                    phi_809_ = _e442;
                } else {
                    phi_809_ = _e439;
                }
                let _e448 = phi_809_;
                if (_e445 < _e439) {
                    phi_814_ = _e445;
                } else {
                    phi_814_ = _e439;
                }
                let _e451 = phi_814_;
                let _e452 = bitcast<u32>(_e448);
                let _e454 = (_e415 + 1i);
                let _e455 = (_e424 + 1i);
                if (_e454 > 0i) {
                    phi_823_ = _e454;
                } else {
                    phi_823_ = 0i;
                }
                let _e458 = phi_823_;
                if (_e455 > 0i) {
                    phi_828_ = _e455;
                } else {
                    phi_828_ = 0i;
                }
                let _e461 = phi_828_;
                if (_e458 < _e439) {
                    phi_833_ = _e458;
                } else {
                    phi_833_ = _e439;
                }
                let _e464 = phi_833_;
                if (_e461 < _e439) {
                    phi_838_ = _e461;
                } else {
                    phi_838_ = _e439;
                }
                let _e467 = phi_838_;
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
                let _e483 = map.member[(0u + _e473)];
                if (_e474 < _e45) {
                } else {
                    return;
                }
                let _e487 = map.member[(0u + _e474)];
                if (_e475 < _e45) {
                } else {
                    return;
                }
                let _e491 = map.member[(0u + _e475)];
                let _e492 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e479);
                let _e493 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e483);
                let _e494 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e487);
                let _e495 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e491);
                let _e541 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e492.x * _e427) + (_e493.x * _e429)) + (_e494.x * _e431)) + (_e495.x * _e432)), ((((_e492.y * _e427) + (_e493.y * _e429)) + (_e494.y * _e431)) + (_e495.y * _e432)), ((((_e492.z * _e427) + (_e493.z * _e429)) + (_e494.z * _e431)) + (_e495.z * _e432)), ((((_e492.w * _e427) + (_e493.w * _e429)) + (_e494.w * _e431)) + (_e495.w * _e432))), _e345);
                let _e543 = p.member.epsilon;
                if (_e541 <= _e543) {
                    phi_933_ = true;
                } else {
                    phi_933_ = (_e541 >= (1f - _e543));
                }
                let _e548 = phi_933_;
                if ((bitcast<u32>(_e541) & 2147483647u) > 2139095040u) {
                    phi_941_ = true;
                } else {
                    phi_941_ = !(_e548);
                }
                let _e554 = phi_941_;
                if _e554 {
                    if (_e541 > 0f) {
                        if (_e541 < 1f) {
                            phi_953_ = false;
                        } else {
                            phi_953_ = true;
                        }
                        let _e558 = phi_953_;
                        phi_954_ = _e558;
                    } else {
                        phi_954_ = true;
                    }
                    let _e560 = phi_954_;
                    if _e560 {
                        phi_958_ = 0.5f;
                    } else {
                        phi_958_ = _e541;
                    }
                    let _e562 = phi_958_;
                    phi_966_ = evaluate_Verdict(_e562, true);
                } else {
                    if (_e541 > 0.5f) {
                        phi_964_ = 1f;
                    } else {
                        phi_964_ = 0f;
                    }
                    let _e566 = phi_964_;
                    phi_966_ = evaluate_Verdict(_e566, false);
                }
                let _e569 = phi_966_;
                phi_971_ = evaluate_Verdict(_e569.visibility, _e569.is_doubted);
            } else {
                phi_971_ = evaluate_Verdict(0.5f, true);
            }
            let _e575 = phi_971_;
            phi_972_ = _e575;
        }
        let _e577 = phi_972_;
        visibility.member[_e53.first_primitive] = _e577.visibility;
        phi_976_ = _e577.is_doubted;
        phi_977_ = _e53.first_primitive;
    } else {
        phi_976_ = false;
        phi_977_ = 0u;
    }
    let _e582 = phi_976_;
    let _e584 = phi_977_;
    if (_e40 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e582 {
        let _e588 = atomicAdd((&shared_[0u]), 1u);
        phi_988_ = _e588;
    } else {
        phi_988_ = 0u;
    }
    let _e590 = phi_988_;
    workgroupBarrier();
    if (_e40 == 0u) {
        let _e594 = atomicLoad((&shared_[0u]));
        let _e595 = atomicAdd((&list.member[3u]), _e594);
        atomicStore((&shared_[1u]), _e595);
    }
    workgroupBarrier();
    if _e582 {
        let _e598 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e598) + _e590)]), _e584);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
