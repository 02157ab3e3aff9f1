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

struct type_37 {
    member: array<vec4<f32>>,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
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

struct type_44 {
    member: abi_ShadowParams,
}

struct type_49 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_44;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_49;
@group(0) @binding(2) 
var<storage> map: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_167_: lt_bvh_traverse_Tree;
    var phi_168_: bool;
    var phi_169_: lt_bvh_traverse_Tree;
    var phi_170_: bool;
    var phi_175_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_167_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_168_ = false;
        } else {
            phi_167_ = lt_bvh_traverse_Tree();
            phi_168_ = true;
        }
        let _e64 = phi_167_;
        let _e66 = phi_168_;
        phi_169_ = _e64;
        phi_170_ = _e66;
    } else {
        phi_169_ = lt_bvh_traverse_Tree();
        phi_170_ = true;
    }
    let _e68 = phi_169_;
    let _e70 = phi_170_;
    if _e70 {
        phi_175_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_175_ = _e68;
    }
    let _e75 = phi_175_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_negative(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_423_: bool;
    var phi_427_: f32;

    let _e53 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_423_ = true;
    } else {
        let _e57 = (42f < _e53);
        if _e57 {
        }
        phi_423_ = _e57;
    }
    let _e59 = phi_423_;
    if _e59 {
        phi_427_ = 42f;
    } else {
        phi_427_ = _e53;
    }
    let _e61 = phi_427_;
    return _e61;
}

fn _lt_math_evsm_Evsm_positive(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_404_: bool;
    var phi_408_: f32;

    let _e53 = (*param_5).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_404_ = true;
    } else {
        let _e57 = (42f < _e53);
        if _e57 {
        }
        phi_404_ = _e57;
    }
    let _e59 = phi_404_;
    if _e59 {
        phi_408_ = 42f;
    } else {
        phi_408_ = _e53;
    }
    let _e61 = phi_408_;
    return _e61;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6: ptr<function, lt_math_Evsm>, param_7: f32) -> vec4<f32> {
    var phi_202_: f32;
    var phi_203_: f32;
    var phi_204_: f32;
    var phi_217_: f32;
    var phi_222_: f32;
    var phi_244_: f32;
    var phi_249_: f32;
    var phi_250_: bool;
    var phi_251_: f32;
    var phi_252_: bool;
    var phi_256_: f32;
    var phi_294_: f32;
    var phi_308_: f32;
    var phi_313_: f32;
    var phi_335_: f32;
    var phi_340_: f32;
    var phi_341_: bool;
    var phi_342_: f32;
    var phi_343_: bool;
    var phi_347_: f32;
    var phi_385_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_204_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_203_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_202_ = 1f;
            } else {
                phi_202_ = param_7;
            }
            let _e59 = phi_202_;
            phi_203_ = _e59;
        }
        let _e61 = phi_203_;
        phi_204_ = _e61;
    }
    let _e63 = phi_204_;
    let _e64 = _lt_math_evsm_Evsm_positive(param_6);
    let _e65 = (_e64 * _e63);
    if ((bitcast<u32>(_e65) & 2147483647u) > 2139095040u) {
        phi_294_ = _e65;
    } else {
        if (_e65 < -87f) {
            phi_217_ = -87f;
        } else {
            phi_217_ = _e65;
        }
        let _e71 = phi_217_;
        if (_e71 > 88f) {
            phi_222_ = 88f;
        } else {
            phi_222_ = _e71;
        }
        let _e74 = phi_222_;
        let _e76 = ((_e74 * 1.442695f) + 0.5f);
        if (_e76 > -8388608f) {
            let _e88 = f32(select(0i, select(select(i32(_e76), i32(-2147483648), (_e76 < bitcast<f32>(3472883712u))), 2147483647i, (_e76 > bitcast<f32>(1325400063u))), (_e76 == _e76)));
            if (_e88 > _e76) {
                phi_244_ = 1f;
            } else {
                phi_244_ = 0f;
            }
            let _e91 = phi_244_;
            if (_e76 < 8388608f) {
                phi_249_ = (_e88 - _e91);
                phi_250_ = false;
            } else {
                phi_249_ = f32();
                phi_250_ = true;
            }
            let _e94 = phi_249_;
            let _e96 = phi_250_;
            phi_251_ = _e94;
            phi_252_ = _e96;
        } else {
            phi_251_ = f32();
            phi_252_ = true;
        }
        let _e98 = phi_251_;
        let _e100 = phi_252_;
        if _e100 {
            phi_256_ = _e76;
        } else {
            phi_256_ = _e98;
        }
        let _e102 = phi_256_;
        let _e106 = ((_e74 - (_e102 * 0.69314575f)) - (_e102 * 0.0000014286068f));
        phi_294_ = ((((((((((((((((1f / 5040f) * _e106) + (1f / 720f)) * _e106) + (1f / 120f)) * _e106) + (1f / 24f)) * _e106) + (1f / 6f)) * _e106) + 0.5f) * _e106) + 1f) * _e106) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e102), i32(-2147483648), (_e102 < bitcast<f32>(3472883712u))), 2147483647i, (_e102 > bitcast<f32>(1325400063u))), (_e102 == _e102)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e142 = phi_294_;
    let _e143 = _lt_math_evsm_Evsm_negative(param_6);
    let _e145 = (-(_e143) * _e63);
    if ((bitcast<u32>(_e145) & 2147483647u) > 2139095040u) {
        phi_385_ = _e145;
    } else {
        if (_e145 < -87f) {
            phi_308_ = -87f;
        } else {
            phi_308_ = _e145;
        }
        let _e151 = phi_308_;
        if (_e151 > 88f) {
            phi_313_ = 88f;
        } else {
            phi_313_ = _e151;
        }
        let _e154 = phi_313_;
        let _e156 = ((_e154 * 1.442695f) + 0.5f);
        if (_e156 > -8388608f) {
            let _e168 = f32(select(0i, select(select(i32(_e156), i32(-2147483648), (_e156 < bitcast<f32>(3472883712u))), 2147483647i, (_e156 > bitcast<f32>(1325400063u))), (_e156 == _e156)));
            if (_e168 > _e156) {
                phi_335_ = 1f;
            } else {
                phi_335_ = 0f;
            }
            let _e171 = phi_335_;
            if (_e156 < 8388608f) {
                phi_340_ = (_e168 - _e171);
                phi_341_ = false;
            } else {
                phi_340_ = f32();
                phi_341_ = true;
            }
            let _e174 = phi_340_;
            let _e176 = phi_341_;
            phi_342_ = _e174;
            phi_343_ = _e176;
        } else {
            phi_342_ = f32();
            phi_343_ = true;
        }
        let _e178 = phi_342_;
        let _e180 = phi_343_;
        if _e180 {
            phi_347_ = _e156;
        } else {
            phi_347_ = _e178;
        }
        let _e182 = phi_347_;
        let _e186 = ((_e154 - (_e182 * 0.69314575f)) - (_e182 * 0.0000014286068f));
        phi_385_ = ((((((((((((((((1f / 5040f) * _e186) + (1f / 720f)) * _e186) + (1f / 120f)) * _e186) + (1f / 24f)) * _e186) + (1f / 6f)) * _e186) + 0.5f) * _e186) + 1f) * _e186) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e182), i32(-2147483648), (_e182 < bitcast<f32>(3472883712u))), 2147483647i, (_e182 > bitcast<f32>(1325400063u))), (_e182 == _e182)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e222 = phi_385_;
    let _e223 = -(_e222);
    return vec4<f32>(_e142, (_e142 * _e142), _e223, (_e223 * _e223));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_8: ptr<function, lt_math_Evsm>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_457_: bool;
    var phi_461_: f32;
    var phi_473_: bool;
    var phi_480_: f32;
    var phi_505_: bool;
    var phi_509_: f32;
    var phi_521_: bool;
    var phi_528_: f32;
    var phi_539_: bool;
    var phi_543_: f32;
    var phi_558_: f32;
    var phi_559_: f32;
    var phi_560_: f32;

    let _e54 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_8, param_10);
    let _e55 = _lt_math_evsm_Evsm_positive(param_8);
    let _e57 = (*param_8).min_variance;
    let _e61 = (((_e57 * _e55) * _e55) * _e54.y);
    let _e68 = ((param_9.y - (param_9.x * param_9.x)) + (0.00000047683716f * param_9.y));
    if ((bitcast<u32>(_e61) & 2147483647u) > 2139095040u) {
        phi_457_ = true;
    } else {
        let _e72 = (_e61 > _e68);
        if _e72 {
        }
        phi_457_ = _e72;
    }
    let _e74 = phi_457_;
    if _e74 {
        phi_461_ = _e61;
    } else {
        phi_461_ = _e68;
    }
    let _e76 = phi_461_;
    let _e77 = (_e54.x - param_9.x);
    if (_e77 <= 0f) {
        let _e81 = ((bitcast<u32>(_e76) & 2147483647u) > 2139095040u);
        if _e81 {
        }
        phi_473_ = _e81;
    } else {
        phi_473_ = true;
    }
    let _e83 = phi_473_;
    if _e83 {
        phi_480_ = (_e76 / (_e76 + (_e77 * _e77)));
    } else {
        phi_480_ = 1f;
    }
    let _e88 = phi_480_;
    let _e89 = _lt_math_evsm_Evsm_negative(param_8);
    let _e91 = (*param_8).min_variance;
    let _e95 = (((_e91 * _e89) * _e89) * _e54.w);
    let _e102 = ((param_9.w - (param_9.z * param_9.z)) + (0.00000047683716f * param_9.w));
    if ((bitcast<u32>(_e95) & 2147483647u) > 2139095040u) {
        phi_505_ = true;
    } else {
        let _e106 = (_e95 > _e102);
        if _e106 {
        }
        phi_505_ = _e106;
    }
    let _e108 = phi_505_;
    if _e108 {
        phi_509_ = _e95;
    } else {
        phi_509_ = _e102;
    }
    let _e110 = phi_509_;
    let _e111 = (_e54.z - param_9.z);
    if (_e111 <= 0f) {
        let _e115 = ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u);
        if _e115 {
        }
        phi_521_ = _e115;
    } else {
        phi_521_ = true;
    }
    let _e117 = phi_521_;
    if _e117 {
        phi_528_ = (_e110 / (_e110 + (_e111 * _e111)));
    } else {
        phi_528_ = 1f;
    }
    let _e122 = phi_528_;
    if ((bitcast<u32>(_e122) & 2147483647u) > 2139095040u) {
        phi_539_ = true;
    } else {
        let _e126 = (_e122 < _e88);
        if _e126 {
        }
        phi_539_ = _e126;
    }
    let _e128 = phi_539_;
    if _e128 {
        phi_543_ = _e122;
    } else {
        phi_543_ = _e88;
    }
    let _e130 = phi_543_;
    if ((bitcast<u32>(_e130) & 2147483647u) > 2139095040u) {
        phi_560_ = _e130;
    } else {
        if (_e130 < 0f) {
            phi_559_ = 0f;
        } else {
            if (_e130 > 1f) {
                phi_558_ = 1f;
            } else {
                phi_558_ = _e130;
            }
            let _e137 = phi_558_;
            phi_559_ = _e137;
        }
        let _e139 = phi_559_;
        phi_560_ = _e139;
    }
    let _e141 = phi_560_;
    return _e141;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_609_: bool;
    var phi_610_: bool;
    var phi_611_: bool;
    var phi_612_: bool;
    var phi_616_: bool;
    var phi_660_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_664_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_741_: bool;
    var phi_750_: bool;
    var phi_759_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_762_: bool;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_769_: bool;
    var phi_863_: f32;
    var phi_866_: f32;
    var phi_895_: f32;
    var phi_900_: f32;
    var phi_901_: bool;
    var phi_902_: f32;
    var phi_903_: bool;
    var phi_907_: f32;
    var phi_927_: f32;
    var phi_932_: f32;
    var phi_933_: bool;
    var phi_934_: f32;
    var phi_935_: bool;
    var phi_939_: f32;
    var phi_989_: i32;
    var phi_994_: i32;
    var phi_999_: i32;
    var phi_1004_: i32;
    var phi_1013_: i32;
    var phi_1018_: i32;
    var phi_1023_: i32;
    var phi_1028_: i32;
    var phi_1119_: bool;
    var phi_1127_: bool;
    var phi_1139_: bool;
    var phi_1140_: bool;
    var phi_1144_: f32;
    var phi_1150_: f32;
    var phi_1152_: evaluate_Verdict;
    var phi_1157_: evaluate_Verdict;
    var phi_1158_: evaluate_Verdict;
    var phi_1162_: bool;
    var phi_1163_: u32;
    var phi_1174_: u32;

    let _e52 = id_1;
    let _e53 = local_2;
    let _e58 = arrayLength((&map.member));
    let _e63 = p.member.size[0u];
    let _e65 = p.member.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e52, _e63, _e65);
    if (bitcast<i32>(_e66.root) != 0i) {
        let _e73 = p.member.light;
        let _e76 = samples.member[_e66.first_primitive].normal[0u];
        let _e78 = global[0u];
        if (_e76 == _e78) {
            let _e81 = samples.member[_e66.first_primitive].normal[1u];
            let _e83 = global[1u];
            if (_e81 == _e83) {
                let _e86 = samples.member[_e66.first_primitive].normal[2u];
                let _e88 = global[2u];
                phi_609_ = (_e86 == _e88);
                phi_610_ = false;
            } else {
                phi_609_ = bool();
                phi_610_ = true;
            }
            let _e91 = phi_609_;
            let _e93 = phi_610_;
            phi_611_ = _e91;
            phi_612_ = _e93;
        } else {
            phi_611_ = bool();
            phi_612_ = true;
        }
        let _e95 = phi_611_;
        let _e97 = phi_612_;
        if _e97 {
            phi_616_ = false;
        } else {
            phi_616_ = _e95;
        }
        let _e99 = phi_616_;
        if !(_e99) {
            let _e102 = samples.member[_e66.first_primitive].normal;
            let _e104 = samples.member[_e66.first_primitive].position;
            if ((((_e102.x * (_e73.x - (_e104.x * _e73.w))) + (_e102.y * (_e73.y - (_e104.y * _e73.w)))) + (_e102.z * (_e73.z - (_e104.z * _e73.w)))) > 0f) {
                let _e128 = samples.member[_e66.first_primitive].flags;
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_660_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, ((_e128 & 1u) == 0u));
            } else {
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e151.unnamed.visibility, false), _e151.unnamed_1);
                phi_660_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e157.unnamed, true);
            }
            let _e162 = phi_660_;
            phi_664_ = _e162;
        } else {
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
            phi_664_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
        }
        let _e179 = phi_664_;
        if _e179.unnamed_1 {
            phi_1158_ = evaluate_Verdict(_e179.unnamed.visibility, _e179.unnamed.is_doubted);
        } else {
            let _e187 = samples.member[_e66.first_primitive].position;
            let _e193 = p.member.projection.row_w;
            let _e204 = ((((_e193.x * _e187.x) + (_e193.y * _e187.y)) + (_e193.z * _e187.z)) + (_e193.w * 1f));
            let _e206 = p.member.projection.row_x;
            let _e218 = (((((_e206.x * _e187.x) + (_e206.y * _e187.y)) + (_e206.z * _e187.z)) + (_e206.w * 1f)) / _e204);
            let _e220 = p.member.projection.row_y;
            let _e232 = (((((_e220.x * _e187.x) + (_e220.y * _e187.y)) + (_e220.z * _e187.z)) + (_e220.w * 1f)) / _e204);
            let _e234 = p.member.projection.row_z;
            let _e245 = ((((_e234.x * _e187.x) + (_e234.y * _e187.y)) + (_e234.z * _e187.z)) + (_e234.w * 1f));
            if (_e204 > 0f) {
                if (_e218 >= 0f) {
                    phi_741_ = (_e218 <= 1f);
                } else {
                    phi_741_ = false;
                }
                let _e250 = phi_741_;
                if _e250 {
                    if (_e232 >= 0f) {
                        phi_750_ = (_e232 <= 1f);
                    } else {
                        phi_750_ = false;
                    }
                    let _e254 = phi_750_;
                    if _e254 {
                        if (_e245 >= 0f) {
                            phi_759_ = (_e245 <= 1f);
                        } else {
                            phi_759_ = false;
                        }
                        let _e258 = phi_759_;
                        phi_760_ = _e258;
                        phi_761_ = false;
                    } else {
                        phi_760_ = bool();
                        phi_761_ = true;
                    }
                    let _e260 = phi_760_;
                    let _e262 = phi_761_;
                    phi_762_ = _e260;
                    phi_763_ = _e262;
                } else {
                    phi_762_ = bool();
                    phi_763_ = true;
                }
                let _e264 = phi_762_;
                let _e266 = phi_763_;
                phi_764_ = _e264;
                phi_765_ = _e266;
            } else {
                phi_764_ = bool();
                phi_765_ = true;
            }
            let _e268 = phi_764_;
            let _e270 = phi_765_;
            if _e270 {
                phi_769_ = false;
            } else {
                phi_769_ = _e268;
            }
            let _e272 = phi_769_;
            if _e272 {
                if (0f > 0f) {
                    let _e275 = samples.member[_e66.first_primitive].normal;
                    let _e277 = p.member.map_size;
                    let _e280 = p.member.projection.row_x;
                    let _e302 = p.member.projection.row_y;
                    let _e324 = p.member.projection.row_z;
                    let _e351 = ((abs(((((_e280.x * _e275.x) + (_e280.y * _e275.y)) + (_e280.z * _e275.z)) / (((_e280.x * _e280.x) + (_e280.y * _e280.y)) + (_e280.z * _e280.z)))) + abs(((((_e302.x * _e275.x) + (_e302.y * _e275.y)) + (_e302.z * _e275.z)) / (((_e302.x * _e302.x) + (_e302.y * _e302.y)) + (_e302.z * _e302.z))))) / (abs(((((_e324.x * _e275.x) + (_e324.y * _e275.y)) + (_e324.z * _e275.z)) / (((_e324.x * _e324.x) + (_e324.y * _e324.y)) + (_e324.z * _e324.z)))) * f32(_e277)));
                    if (_e351 < 0.002f) {
                        phi_863_ = _e351;
                    } else {
                        phi_863_ = 0.002f;
                    }
                    let _e354 = phi_863_;
                    phi_866_ = (_e245 - (0f * _e354));
                } else {
                    phi_866_ = _e245;
                }
                let _e358 = phi_866_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e218 * _e361) - 0.5f);
                let _e365 = ((_e232 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_895_ = 1f;
                    } else {
                        phi_895_ = 0f;
                    }
                    let _e380 = phi_895_;
                    if (_e364 < 8388608f) {
                        phi_900_ = (_e377 - _e380);
                        phi_901_ = false;
                    } else {
                        phi_900_ = f32();
                        phi_901_ = true;
                    }
                    let _e383 = phi_900_;
                    let _e385 = phi_901_;
                    phi_902_ = _e383;
                    phi_903_ = _e385;
                } else {
                    phi_902_ = f32();
                    phi_903_ = true;
                }
                let _e387 = phi_902_;
                let _e389 = phi_903_;
                if _e389 {
                    phi_907_ = _e364;
                } else {
                    phi_907_ = _e387;
                }
                let _e391 = phi_907_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_927_ = 1f;
                    } else {
                        phi_927_ = 0f;
                    }
                    let _e406 = phi_927_;
                    if (_e365 < 8388608f) {
                        phi_932_ = (_e403 - _e406);
                        phi_933_ = false;
                    } else {
                        phi_932_ = f32();
                        phi_933_ = true;
                    }
                    let _e409 = phi_932_;
                    let _e411 = phi_933_;
                    phi_934_ = _e409;
                    phi_935_ = _e411;
                } else {
                    phi_934_ = f32();
                    phi_935_ = true;
                }
                let _e413 = phi_934_;
                let _e415 = phi_935_;
                if _e415 {
                    phi_939_ = _e365;
                } else {
                    phi_939_ = _e413;
                }
                let _e417 = phi_939_;
                let _e418 = (_e364 - _e391);
                let _e419 = (_e365 - _e417);
                let _e428 = select(0i, select(select(i32(_e391), i32(-2147483648), (_e391 < bitcast<f32>(3472883712u))), 2147483647i, (_e391 > bitcast<f32>(1325400063u))), (_e391 == _e391));
                let _e437 = select(0i, select(select(i32(_e417), i32(-2147483648), (_e417 < bitcast<f32>(3472883712u))), 2147483647i, (_e417 > bitcast<f32>(1325400063u))), (_e417 == _e417));
                let _e440 = ((1f - _e418) * (1f - _e419));
                let _e442 = (_e418 * (1f - _e419));
                let _e444 = ((1f - _e418) * _e419);
                let _e445 = (_e418 * _e419);
                let _e447 = p.member.test;
                let _e448 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e447);
                let _e450 = p.member.map_size;
                local_1 = lt_math_Evsm(_e448.positive_exponent, _e448.negative_exponent, _e448.min_variance);
                let _e456 = (bitcast<i32>(_e450) - 1i);
                if (_e428 > 0i) {
                    phi_989_ = _e428;
                } else {
                    phi_989_ = 0i;
                }
                let _e459 = phi_989_;
                if (_e437 > 0i) {
                    phi_994_ = _e437;
                } else {
                    phi_994_ = 0i;
                }
                let _e462 = phi_994_;
                if (_e459 < _e456) {
                    phi_999_ = _e459;
                } else {
                    phi_999_ = _e456;
                }
                let _e465 = phi_999_;
                if (_e462 < _e456) {
                    phi_1004_ = _e462;
                } else {
                    phi_1004_ = _e456;
                }
                let _e468 = phi_1004_;
                let _e469 = bitcast<u32>(_e465);
                let _e471 = (_e428 + 1i);
                let _e472 = (_e437 + 1i);
                if (_e471 > 0i) {
                    phi_1013_ = _e471;
                } else {
                    phi_1013_ = 0i;
                }
                let _e475 = phi_1013_;
                if (_e472 > 0i) {
                    phi_1018_ = _e472;
                } else {
                    phi_1018_ = 0i;
                }
                let _e478 = phi_1018_;
                if (_e475 < _e456) {
                    phi_1023_ = _e475;
                } else {
                    phi_1023_ = _e456;
                }
                let _e481 = phi_1023_;
                if (_e478 < _e456) {
                    phi_1028_ = _e478;
                } else {
                    phi_1028_ = _e456;
                }
                let _e484 = phi_1028_;
                let _e485 = bitcast<u32>(_e481);
                let _e487 = (bitcast<u32>(_e468) * _e450);
                let _e488 = (bitcast<u32>(_e484) * _e450);
                let _e489 = (_e487 + _e469);
                let _e490 = (_e487 + _e485);
                let _e491 = (_e488 + _e469);
                let _e492 = (_e488 + _e485);
                if (_e489 < _e58) {
                } else {
                    return;
                }
                let _e496 = map.member[(0u + _e489)];
                if (_e490 < _e58) {
                } else {
                    return;
                }
                let _e508 = map.member[(0u + _e490)];
                if (_e491 < _e58) {
                } else {
                    return;
                }
                let _e524 = map.member[(0u + _e491)];
                if (_e492 < _e58) {
                } else {
                    return;
                }
                let _e540 = map.member[(0u + _e492)];
                let _e554 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e496.x * _e440) + (_e508.x * _e442)) + (_e524.x * _e444)) + (_e540.x * _e445)), ((((_e496.y * _e440) + (_e508.y * _e442)) + (_e524.y * _e444)) + (_e540.y * _e445)), ((((_e496.z * _e440) + (_e508.z * _e442)) + (_e524.z * _e444)) + (_e540.z * _e445)), ((((_e496.w * _e440) + (_e508.w * _e442)) + (_e524.w * _e444)) + (_e540.w * _e445))), _e358);
                let _e556 = p.member.epsilon;
                if (_e554 <= _e556) {
                    phi_1119_ = true;
                } else {
                    phi_1119_ = (_e554 >= (1f - _e556));
                }
                let _e561 = phi_1119_;
                if ((bitcast<u32>(_e554) & 2147483647u) > 2139095040u) {
                    phi_1127_ = true;
                } else {
                    phi_1127_ = !(_e561);
                }
                let _e567 = phi_1127_;
                if _e567 {
                    if (_e554 > 0f) {
                        if (_e554 < 1f) {
                            phi_1139_ = false;
                        } else {
                            phi_1139_ = true;
                        }
                        let _e571 = phi_1139_;
                        phi_1140_ = _e571;
                    } else {
                        phi_1140_ = true;
                    }
                    let _e573 = phi_1140_;
                    if _e573 {
                        phi_1144_ = 0.5f;
                    } else {
                        phi_1144_ = _e554;
                    }
                    let _e575 = phi_1144_;
                    phi_1152_ = evaluate_Verdict(_e575, true);
                } else {
                    if (_e554 > 0.5f) {
                        phi_1150_ = 1f;
                    } else {
                        phi_1150_ = 0f;
                    }
                    let _e579 = phi_1150_;
                    phi_1152_ = evaluate_Verdict(_e579, false);
                }
                let _e582 = phi_1152_;
                phi_1157_ = evaluate_Verdict(_e582.visibility, _e582.is_doubted);
            } else {
                phi_1157_ = evaluate_Verdict(0.5f, true);
            }
            let _e588 = phi_1157_;
            phi_1158_ = _e588;
        }
        let _e590 = phi_1158_;
        visibility.member[_e66.first_primitive] = _e590.visibility;
        phi_1162_ = _e590.is_doubted;
        phi_1163_ = _e66.first_primitive;
    } else {
        phi_1162_ = false;
        phi_1163_ = 0u;
    }
    let _e595 = phi_1162_;
    let _e597 = phi_1163_;
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e595 {
        let _e601 = atomicAdd((&shared_[0u]), 1u);
        phi_1174_ = _e601;
    } else {
        phi_1174_ = 0u;
    }
    let _e603 = phi_1174_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e607 = atomicLoad((&shared_[0u]));
        let _e608 = atomicAdd((&list.member[3u]), _e607);
        atomicStore((&shared_[1u]), _e608);
    }
    workgroupBarrier();
    if _e595 {
        let _e611 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e611) + _e603)]), _e597);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
