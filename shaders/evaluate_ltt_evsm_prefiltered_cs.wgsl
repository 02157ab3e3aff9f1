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

struct type_23 {
    member: array<abi_Sample>,
}

struct type_27 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_36 {
    member: array<vec4<f32>>,
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

struct type_41 {
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

struct type_48 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_23;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_41;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_27;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_48;
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(2) 
var<storage> map: type_36;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_166_: lt_bvh_traverse_Tree;
    var phi_167_: bool;
    var phi_168_: lt_bvh_traverse_Tree;
    var phi_169_: bool;
    var phi_174_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_166_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_167_ = false;
        } else {
            phi_166_ = lt_bvh_traverse_Tree();
            phi_167_ = true;
        }
        let _e64 = phi_166_;
        let _e66 = phi_167_;
        phi_168_ = _e64;
        phi_169_ = _e66;
    } else {
        phi_168_ = lt_bvh_traverse_Tree();
        phi_169_ = true;
    }
    let _e68 = phi_168_;
    let _e70 = phi_169_;
    if _e70 {
        phi_174_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_174_ = _e68;
    }
    let _e75 = phi_174_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_negative(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_422_: bool;
    var phi_426_: f32;

    let _e53 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_422_ = true;
    } else {
        let _e57 = (42f < _e53);
        if _e57 {
        }
        phi_422_ = _e57;
    }
    let _e59 = phi_422_;
    if _e59 {
        phi_426_ = 42f;
    } else {
        phi_426_ = _e53;
    }
    let _e61 = phi_426_;
    return _e61;
}

fn _lt_math_evsm_Evsm_positive(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_403_: bool;
    var phi_407_: f32;

    let _e53 = (*param_5).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_403_ = true;
    } else {
        let _e57 = (42f < _e53);
        if _e57 {
        }
        phi_403_ = _e57;
    }
    let _e59 = phi_403_;
    if _e59 {
        phi_407_ = 42f;
    } else {
        phi_407_ = _e53;
    }
    let _e61 = phi_407_;
    return _e61;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6: ptr<function, lt_math_Evsm>, param_7: f32) -> vec4<f32> {
    var phi_201_: f32;
    var phi_202_: f32;
    var phi_203_: f32;
    var phi_216_: f32;
    var phi_221_: f32;
    var phi_243_: f32;
    var phi_248_: f32;
    var phi_249_: bool;
    var phi_250_: f32;
    var phi_251_: bool;
    var phi_255_: f32;
    var phi_293_: f32;
    var phi_307_: f32;
    var phi_312_: f32;
    var phi_334_: f32;
    var phi_339_: f32;
    var phi_340_: bool;
    var phi_341_: f32;
    var phi_342_: bool;
    var phi_346_: f32;
    var phi_384_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_203_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_202_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_201_ = 1f;
            } else {
                phi_201_ = param_7;
            }
            let _e59 = phi_201_;
            phi_202_ = _e59;
        }
        let _e61 = phi_202_;
        phi_203_ = _e61;
    }
    let _e63 = phi_203_;
    let _e64 = _lt_math_evsm_Evsm_positive(param_6);
    let _e65 = (_e64 * _e63);
    if ((bitcast<u32>(_e65) & 2147483647u) > 2139095040u) {
        phi_293_ = _e65;
    } else {
        if (_e65 < -87f) {
            phi_216_ = -87f;
        } else {
            phi_216_ = _e65;
        }
        let _e71 = phi_216_;
        if (_e71 > 88f) {
            phi_221_ = 88f;
        } else {
            phi_221_ = _e71;
        }
        let _e74 = phi_221_;
        let _e76 = ((_e74 * 1.442695f) + 0.5f);
        if (_e76 > -8388608f) {
            let _e88 = f32(select(0i, select(select(i32(_e76), i32(-2147483648), (_e76 < bitcast<f32>(3472883712u))), 2147483647i, (_e76 > bitcast<f32>(1325400063u))), (_e76 == _e76)));
            if (_e88 > _e76) {
                phi_243_ = 1f;
            } else {
                phi_243_ = 0f;
            }
            let _e91 = phi_243_;
            if (_e76 < 8388608f) {
                phi_248_ = (_e88 - _e91);
                phi_249_ = false;
            } else {
                phi_248_ = f32();
                phi_249_ = true;
            }
            let _e94 = phi_248_;
            let _e96 = phi_249_;
            phi_250_ = _e94;
            phi_251_ = _e96;
        } else {
            phi_250_ = f32();
            phi_251_ = true;
        }
        let _e98 = phi_250_;
        let _e100 = phi_251_;
        if _e100 {
            phi_255_ = _e76;
        } else {
            phi_255_ = _e98;
        }
        let _e102 = phi_255_;
        let _e106 = ((_e74 - (_e102 * 0.69314575f)) - (_e102 * 0.0000014286068f));
        phi_293_ = ((((((((((((((((1f / 5040f) * _e106) + (1f / 720f)) * _e106) + (1f / 120f)) * _e106) + (1f / 24f)) * _e106) + (1f / 6f)) * _e106) + 0.5f) * _e106) + 1f) * _e106) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e102), i32(-2147483648), (_e102 < bitcast<f32>(3472883712u))), 2147483647i, (_e102 > bitcast<f32>(1325400063u))), (_e102 == _e102)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e142 = phi_293_;
    let _e143 = _lt_math_evsm_Evsm_negative(param_6);
    let _e145 = (-(_e143) * _e63);
    if ((bitcast<u32>(_e145) & 2147483647u) > 2139095040u) {
        phi_384_ = _e145;
    } else {
        if (_e145 < -87f) {
            phi_307_ = -87f;
        } else {
            phi_307_ = _e145;
        }
        let _e151 = phi_307_;
        if (_e151 > 88f) {
            phi_312_ = 88f;
        } else {
            phi_312_ = _e151;
        }
        let _e154 = phi_312_;
        let _e156 = ((_e154 * 1.442695f) + 0.5f);
        if (_e156 > -8388608f) {
            let _e168 = f32(select(0i, select(select(i32(_e156), i32(-2147483648), (_e156 < bitcast<f32>(3472883712u))), 2147483647i, (_e156 > bitcast<f32>(1325400063u))), (_e156 == _e156)));
            if (_e168 > _e156) {
                phi_334_ = 1f;
            } else {
                phi_334_ = 0f;
            }
            let _e171 = phi_334_;
            if (_e156 < 8388608f) {
                phi_339_ = (_e168 - _e171);
                phi_340_ = false;
            } else {
                phi_339_ = f32();
                phi_340_ = true;
            }
            let _e174 = phi_339_;
            let _e176 = phi_340_;
            phi_341_ = _e174;
            phi_342_ = _e176;
        } else {
            phi_341_ = f32();
            phi_342_ = true;
        }
        let _e178 = phi_341_;
        let _e180 = phi_342_;
        if _e180 {
            phi_346_ = _e156;
        } else {
            phi_346_ = _e178;
        }
        let _e182 = phi_346_;
        let _e186 = ((_e154 - (_e182 * 0.69314575f)) - (_e182 * 0.0000014286068f));
        phi_384_ = ((((((((((((((((1f / 5040f) * _e186) + (1f / 720f)) * _e186) + (1f / 120f)) * _e186) + (1f / 24f)) * _e186) + (1f / 6f)) * _e186) + 0.5f) * _e186) + 1f) * _e186) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e182), i32(-2147483648), (_e182 < bitcast<f32>(3472883712u))), 2147483647i, (_e182 > bitcast<f32>(1325400063u))), (_e182 == _e182)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e222 = phi_384_;
    let _e223 = -(_e222);
    return vec4<f32>(_e142, (_e142 * _e142), _e223, (_e223 * _e223));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_8: ptr<function, lt_math_Evsm>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_456_: bool;
    var phi_460_: f32;
    var phi_472_: bool;
    var phi_479_: f32;
    var phi_504_: bool;
    var phi_508_: f32;
    var phi_520_: bool;
    var phi_527_: f32;
    var phi_538_: bool;
    var phi_542_: f32;
    var phi_557_: f32;
    var phi_558_: f32;
    var phi_559_: f32;

    let _e54 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_8, param_10);
    let _e55 = _lt_math_evsm_Evsm_positive(param_8);
    let _e57 = (*param_8).min_variance;
    let _e61 = (((_e57 * _e55) * _e55) * _e54.y);
    let _e68 = ((param_9.y - (param_9.x * param_9.x)) + (0.00000047683716f * param_9.y));
    if ((bitcast<u32>(_e61) & 2147483647u) > 2139095040u) {
        phi_456_ = true;
    } else {
        let _e72 = (_e61 > _e68);
        if _e72 {
        }
        phi_456_ = _e72;
    }
    let _e74 = phi_456_;
    if _e74 {
        phi_460_ = _e61;
    } else {
        phi_460_ = _e68;
    }
    let _e76 = phi_460_;
    let _e77 = (_e54.x - param_9.x);
    if (_e77 <= 0f) {
        let _e81 = ((bitcast<u32>(_e76) & 2147483647u) > 2139095040u);
        if _e81 {
        }
        phi_472_ = _e81;
    } else {
        phi_472_ = true;
    }
    let _e83 = phi_472_;
    if _e83 {
        phi_479_ = (_e76 / (_e76 + (_e77 * _e77)));
    } else {
        phi_479_ = 1f;
    }
    let _e88 = phi_479_;
    let _e89 = _lt_math_evsm_Evsm_negative(param_8);
    let _e91 = (*param_8).min_variance;
    let _e95 = (((_e91 * _e89) * _e89) * _e54.w);
    let _e102 = ((param_9.w - (param_9.z * param_9.z)) + (0.00000047683716f * param_9.w));
    if ((bitcast<u32>(_e95) & 2147483647u) > 2139095040u) {
        phi_504_ = true;
    } else {
        let _e106 = (_e95 > _e102);
        if _e106 {
        }
        phi_504_ = _e106;
    }
    let _e108 = phi_504_;
    if _e108 {
        phi_508_ = _e95;
    } else {
        phi_508_ = _e102;
    }
    let _e110 = phi_508_;
    let _e111 = (_e54.z - param_9.z);
    if (_e111 <= 0f) {
        let _e115 = ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u);
        if _e115 {
        }
        phi_520_ = _e115;
    } else {
        phi_520_ = true;
    }
    let _e117 = phi_520_;
    if _e117 {
        phi_527_ = (_e110 / (_e110 + (_e111 * _e111)));
    } else {
        phi_527_ = 1f;
    }
    let _e122 = phi_527_;
    if ((bitcast<u32>(_e122) & 2147483647u) > 2139095040u) {
        phi_538_ = true;
    } else {
        let _e126 = (_e122 < _e88);
        if _e126 {
        }
        phi_538_ = _e126;
    }
    let _e128 = phi_538_;
    if _e128 {
        phi_542_ = _e122;
    } else {
        phi_542_ = _e88;
    }
    let _e130 = phi_542_;
    if ((bitcast<u32>(_e130) & 2147483647u) > 2139095040u) {
        phi_559_ = _e130;
    } else {
        if (_e130 < 0f) {
            phi_558_ = 0f;
        } else {
            if (_e130 > 1f) {
                phi_557_ = 1f;
            } else {
                phi_557_ = _e130;
            }
            let _e137 = phi_557_;
            phi_558_ = _e137;
        }
        let _e139 = phi_558_;
        phi_559_ = _e139;
    }
    let _e141 = phi_559_;
    return _e141;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_613_: bool;
    var phi_614_: bool;
    var phi_615_: bool;
    var phi_616_: bool;
    var phi_620_: bool;
    var phi_664_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_668_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_745_: bool;
    var phi_754_: bool;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_766_: bool;
    var phi_767_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
    var phi_773_: bool;
    var phi_867_: f32;
    var phi_870_: f32;
    var phi_899_: f32;
    var phi_904_: f32;
    var phi_905_: bool;
    var phi_906_: f32;
    var phi_907_: bool;
    var phi_911_: f32;
    var phi_931_: f32;
    var phi_936_: f32;
    var phi_937_: bool;
    var phi_938_: f32;
    var phi_939_: bool;
    var phi_943_: f32;
    var phi_993_: i32;
    var phi_998_: i32;
    var phi_1003_: i32;
    var phi_1008_: i32;
    var phi_1017_: i32;
    var phi_1022_: i32;
    var phi_1027_: i32;
    var phi_1032_: i32;
    var phi_1123_: bool;
    var phi_1131_: bool;
    var phi_1136_: f32;
    var phi_1139_: evaluate_Verdict;
    var phi_1140_: evaluate_Verdict;
    var phi_1144_: bool;
    var phi_1145_: u32;
    var phi_1151_: u32;

    let _e52 = id_1;
    let _e53 = local_2;
    let _e58 = arrayLength((&map.member));
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e65 = p.member.size[0u];
    let _e67 = p.member.size[1u];
    let _e68 = lt_shaders_entry_pixel_index(_e52, _e65, _e67);
    if (bitcast<i32>(_e68.root) != 0i) {
        let _e75 = p.member.light;
        let _e78 = samples.member[_e68.first_primitive].normal[0u];
        let _e80 = global[0u];
        if (_e78 == _e80) {
            let _e83 = samples.member[_e68.first_primitive].normal[1u];
            let _e85 = global[1u];
            if (_e83 == _e85) {
                let _e88 = samples.member[_e68.first_primitive].normal[2u];
                let _e90 = global[2u];
                phi_613_ = (_e88 == _e90);
                phi_614_ = false;
            } else {
                phi_613_ = bool();
                phi_614_ = true;
            }
            let _e93 = phi_613_;
            let _e95 = phi_614_;
            phi_615_ = _e93;
            phi_616_ = _e95;
        } else {
            phi_615_ = bool();
            phi_616_ = true;
        }
        let _e97 = phi_615_;
        let _e99 = phi_616_;
        if _e99 {
            phi_620_ = false;
        } else {
            phi_620_ = _e97;
        }
        let _e101 = phi_620_;
        if !(_e101) {
            let _e104 = samples.member[_e68.first_primitive].normal;
            let _e106 = samples.member[_e68.first_primitive].position;
            if ((((_e104.x * (_e75.x - (_e106.x * _e75.w))) + (_e104.y * (_e75.y - (_e106.y * _e75.w)))) + (_e104.z * (_e75.z - (_e106.z * _e75.w)))) > 0f) {
                let _e130 = samples.member[_e68.first_primitive].flags;
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_664_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, ((_e130 & 1u) == 0u));
            } else {
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e153.unnamed.visibility, false), _e153.unnamed_1);
                phi_664_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e159.unnamed, true);
            }
            let _e164 = phi_664_;
            phi_668_ = _e164;
        } else {
            let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
            phi_668_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, true);
        }
        let _e181 = phi_668_;
        if _e181.unnamed_1 {
            phi_1140_ = evaluate_Verdict(_e181.unnamed.visibility, _e181.unnamed.is_doubted);
        } else {
            let _e189 = samples.member[_e68.first_primitive].position;
            let _e195 = p.member.projection.row_w;
            let _e206 = ((((_e195.x * _e189.x) + (_e195.y * _e189.y)) + (_e195.z * _e189.z)) + (_e195.w * 1f));
            let _e208 = p.member.projection.row_x;
            let _e220 = (((((_e208.x * _e189.x) + (_e208.y * _e189.y)) + (_e208.z * _e189.z)) + (_e208.w * 1f)) / _e206);
            let _e222 = p.member.projection.row_y;
            let _e234 = (((((_e222.x * _e189.x) + (_e222.y * _e189.y)) + (_e222.z * _e189.z)) + (_e222.w * 1f)) / _e206);
            let _e236 = p.member.projection.row_z;
            let _e247 = ((((_e236.x * _e189.x) + (_e236.y * _e189.y)) + (_e236.z * _e189.z)) + (_e236.w * 1f));
            if (_e206 > 0f) {
                if (_e220 >= 0f) {
                    phi_745_ = (_e220 <= 1f);
                } else {
                    phi_745_ = false;
                }
                let _e252 = phi_745_;
                if _e252 {
                    if (_e234 >= 0f) {
                        phi_754_ = (_e234 <= 1f);
                    } else {
                        phi_754_ = false;
                    }
                    let _e256 = phi_754_;
                    if _e256 {
                        if (_e247 >= 0f) {
                            phi_763_ = (_e247 <= 1f);
                        } else {
                            phi_763_ = false;
                        }
                        let _e260 = phi_763_;
                        phi_764_ = _e260;
                        phi_765_ = false;
                    } else {
                        phi_764_ = bool();
                        phi_765_ = true;
                    }
                    let _e262 = phi_764_;
                    let _e264 = phi_765_;
                    phi_766_ = _e262;
                    phi_767_ = _e264;
                } else {
                    phi_766_ = bool();
                    phi_767_ = true;
                }
                let _e266 = phi_766_;
                let _e268 = phi_767_;
                phi_768_ = _e266;
                phi_769_ = _e268;
            } else {
                phi_768_ = bool();
                phi_769_ = true;
            }
            let _e270 = phi_768_;
            let _e272 = phi_769_;
            if _e272 {
                phi_773_ = false;
            } else {
                phi_773_ = _e270;
            }
            let _e274 = phi_773_;
            if _e274 {
                if (0f > 0f) {
                    let _e277 = samples.member[_e68.first_primitive].normal;
                    let _e279 = p.member.map_size;
                    let _e282 = p.member.projection.row_x;
                    let _e304 = p.member.projection.row_y;
                    let _e326 = p.member.projection.row_z;
                    let _e353 = ((abs(((((_e282.x * _e277.x) + (_e282.y * _e277.y)) + (_e282.z * _e277.z)) / (((_e282.x * _e282.x) + (_e282.y * _e282.y)) + (_e282.z * _e282.z)))) + abs(((((_e304.x * _e277.x) + (_e304.y * _e277.y)) + (_e304.z * _e277.z)) / (((_e304.x * _e304.x) + (_e304.y * _e304.y)) + (_e304.z * _e304.z))))) / (abs(((((_e326.x * _e277.x) + (_e326.y * _e277.y)) + (_e326.z * _e277.z)) / (((_e326.x * _e326.x) + (_e326.y * _e326.y)) + (_e326.z * _e326.z)))) * f32(_e279)));
                    if (_e353 < 0.002f) {
                        phi_867_ = _e353;
                    } else {
                        phi_867_ = 0.002f;
                    }
                    let _e356 = phi_867_;
                    phi_870_ = (_e247 - (0f * _e356));
                } else {
                    phi_870_ = _e247;
                }
                let _e360 = phi_870_;
                let _e362 = p.member.map_size;
                let _e363 = f32(_e362);
                let _e366 = ((_e220 * _e363) - 0.5f);
                let _e367 = ((_e234 * _e363) - 0.5f);
                if (_e366 > -8388608f) {
                    let _e379 = f32(select(0i, select(select(i32(_e366), i32(-2147483648), (_e366 < bitcast<f32>(3472883712u))), 2147483647i, (_e366 > bitcast<f32>(1325400063u))), (_e366 == _e366)));
                    if (_e379 > _e366) {
                        phi_899_ = 1f;
                    } else {
                        phi_899_ = 0f;
                    }
                    let _e382 = phi_899_;
                    if (_e366 < 8388608f) {
                        phi_904_ = (_e379 - _e382);
                        phi_905_ = false;
                    } else {
                        phi_904_ = f32();
                        phi_905_ = true;
                    }
                    let _e385 = phi_904_;
                    let _e387 = phi_905_;
                    phi_906_ = _e385;
                    phi_907_ = _e387;
                } else {
                    phi_906_ = f32();
                    phi_907_ = true;
                }
                let _e389 = phi_906_;
                let _e391 = phi_907_;
                if _e391 {
                    phi_911_ = _e366;
                } else {
                    phi_911_ = _e389;
                }
                let _e393 = phi_911_;
                if (_e367 > -8388608f) {
                    let _e405 = f32(select(0i, select(select(i32(_e367), i32(-2147483648), (_e367 < bitcast<f32>(3472883712u))), 2147483647i, (_e367 > bitcast<f32>(1325400063u))), (_e367 == _e367)));
                    if (_e405 > _e367) {
                        phi_931_ = 1f;
                    } else {
                        phi_931_ = 0f;
                    }
                    let _e408 = phi_931_;
                    if (_e367 < 8388608f) {
                        phi_936_ = (_e405 - _e408);
                        phi_937_ = false;
                    } else {
                        phi_936_ = f32();
                        phi_937_ = true;
                    }
                    let _e411 = phi_936_;
                    let _e413 = phi_937_;
                    phi_938_ = _e411;
                    phi_939_ = _e413;
                } else {
                    phi_938_ = f32();
                    phi_939_ = true;
                }
                let _e415 = phi_938_;
                let _e417 = phi_939_;
                if _e417 {
                    phi_943_ = _e367;
                } else {
                    phi_943_ = _e415;
                }
                let _e419 = phi_943_;
                let _e420 = (_e366 - _e393);
                let _e421 = (_e367 - _e419);
                let _e430 = select(0i, select(select(i32(_e393), i32(-2147483648), (_e393 < bitcast<f32>(3472883712u))), 2147483647i, (_e393 > bitcast<f32>(1325400063u))), (_e393 == _e393));
                let _e439 = select(0i, select(select(i32(_e419), i32(-2147483648), (_e419 < bitcast<f32>(3472883712u))), 2147483647i, (_e419 > bitcast<f32>(1325400063u))), (_e419 == _e419));
                let _e442 = ((1f - _e420) * (1f - _e421));
                let _e444 = (_e420 * (1f - _e421));
                let _e446 = ((1f - _e420) * _e421);
                let _e447 = (_e420 * _e421);
                let _e449 = p.member.test;
                let _e450 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e449);
                let _e452 = p.member.map_size;
                local_1 = lt_math_Evsm(_e450.positive_exponent, _e450.negative_exponent, _e450.min_variance);
                let _e458 = (bitcast<i32>(_e452) - 1i);
                if (_e430 > 0i) {
                    phi_993_ = _e430;
                } else {
                    phi_993_ = 0i;
                }
                let _e461 = phi_993_;
                if (_e439 > 0i) {
                    phi_998_ = _e439;
                } else {
                    phi_998_ = 0i;
                }
                let _e464 = phi_998_;
                if (_e461 < _e458) {
                    phi_1003_ = _e461;
                } else {
                    phi_1003_ = _e458;
                }
                let _e467 = phi_1003_;
                if (_e464 < _e458) {
                    phi_1008_ = _e464;
                } else {
                    phi_1008_ = _e458;
                }
                let _e470 = phi_1008_;
                let _e471 = bitcast<u32>(_e467);
                let _e473 = (_e430 + 1i);
                let _e474 = (_e439 + 1i);
                if (_e473 > 0i) {
                    phi_1017_ = _e473;
                } else {
                    phi_1017_ = 0i;
                }
                let _e477 = phi_1017_;
                if (_e474 > 0i) {
                    phi_1022_ = _e474;
                } else {
                    phi_1022_ = 0i;
                }
                let _e480 = phi_1022_;
                if (_e477 < _e458) {
                    phi_1027_ = _e477;
                } else {
                    phi_1027_ = _e458;
                }
                let _e483 = phi_1027_;
                if (_e480 < _e458) {
                    phi_1032_ = _e480;
                } else {
                    phi_1032_ = _e458;
                }
                let _e486 = phi_1032_;
                let _e487 = bitcast<u32>(_e483);
                let _e489 = (bitcast<u32>(_e470) * _e452);
                let _e490 = (bitcast<u32>(_e486) * _e452);
                let _e491 = (_e489 + _e471);
                let _e492 = (_e489 + _e487);
                let _e493 = (_e490 + _e471);
                let _e494 = (_e490 + _e487);
                if (_e491 < _e58) {
                } else {
                    return;
                }
                let _e498 = map.member[(0u + _e491)];
                if (_e492 < _e58) {
                } else {
                    return;
                }
                let _e510 = map.member[(0u + _e492)];
                if (_e493 < _e58) {
                } else {
                    return;
                }
                let _e526 = map.member[(0u + _e493)];
                if (_e494 < _e58) {
                } else {
                    return;
                }
                let _e542 = map.member[(0u + _e494)];
                let _e556 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e498.x * _e442) + (_e510.x * _e444)) + (_e526.x * _e446)) + (_e542.x * _e447)), ((((_e498.y * _e442) + (_e510.y * _e444)) + (_e526.y * _e446)) + (_e542.y * _e447)), ((((_e498.z * _e442) + (_e510.z * _e444)) + (_e526.z * _e446)) + (_e542.z * _e447)), ((((_e498.w * _e442) + (_e510.w * _e444)) + (_e526.w * _e446)) + (_e542.w * _e447))), _e360);
                let _e558 = p.member.epsilon;
                if (_e556 <= _e558) {
                    phi_1123_ = true;
                } else {
                    phi_1123_ = (_e556 >= (1f - _e558));
                }
                let _e563 = phi_1123_;
                if ((bitcast<u32>(_e556) & 2147483647u) > 2139095040u) {
                    phi_1131_ = true;
                } else {
                    phi_1131_ = !(_e563);
                }
                let _e569 = phi_1131_;
                if (_e556 > 0.5f) {
                    phi_1136_ = 1f;
                } else {
                    phi_1136_ = 0f;
                }
                let _e572 = phi_1136_;
                phi_1139_ = evaluate_Verdict(_e572, _e569);
            } else {
                phi_1139_ = evaluate_Verdict(1f, true);
            }
            let _e576 = phi_1139_;
            phi_1140_ = _e576;
        }
        let _e578 = phi_1140_;
        visibility.member[_e68.first_primitive] = _e578.visibility;
        phi_1144_ = _e578.is_doubted;
        phi_1145_ = _e68.first_primitive;
    } else {
        phi_1144_ = false;
        phi_1145_ = 0u;
    }
    let _e583 = phi_1144_;
    let _e585 = phi_1145_;
    if _e583 {
        let _e587 = atomicAdd((&shared_[0u]), 1u);
        phi_1151_ = _e587;
    } else {
        phi_1151_ = 0u;
    }
    let _e589 = phi_1151_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e593 = atomicLoad((&shared_[0u]));
        let _e594 = atomicAdd((&list.member[3u]), _e593);
        atomicStore((&shared_[1u]), _e594);
    }
    workgroupBarrier();
    if _e583 {
        let _e597 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e597) + _e589)]), _e585);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
