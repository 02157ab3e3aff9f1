struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_9 {
    member: array<abi_Sample>,
}

struct type_13 {
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

struct type_28 {
    member: array<vec4<f32>>,
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

struct type_32 {
    member: abi_ShadowParams,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_32;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(2) 
var<storage> map: type_28;

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
        let _e60 = phi_146_;
        let _e62 = phi_147_;
        phi_148_ = _e60;
        phi_149_ = _e62;
    } else {
        phi_148_ = lt_bvh_traverse_Tree();
        phi_149_ = true;
    }
    let _e64 = phi_148_;
    let _e66 = phi_149_;
    if _e66 {
        phi_154_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_154_ = _e64;
    }
    let _e71 = phi_154_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_181_: f32;
    var phi_182_: f32;
    var phi_183_: f32;
    var phi_196_: bool;
    var phi_200_: f32;
    var phi_212_: f32;
    var phi_217_: f32;
    var phi_239_: f32;
    var phi_244_: f32;
    var phi_245_: bool;
    var phi_246_: f32;
    var phi_247_: bool;
    var phi_251_: f32;
    var phi_289_: f32;
    var phi_302_: bool;
    var phi_306_: f32;
    var phi_319_: f32;
    var phi_324_: f32;
    var phi_346_: f32;
    var phi_351_: f32;
    var phi_352_: bool;
    var phi_353_: f32;
    var phi_354_: bool;
    var phi_358_: f32;
    var phi_396_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_183_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_182_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_181_ = 1f;
            } else {
                phi_181_ = param_5;
            }
            let _e55 = phi_181_;
            phi_182_ = _e55;
        }
        let _e57 = phi_182_;
        phi_183_ = _e57;
    }
    let _e59 = phi_183_;
    let _e61 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_196_ = true;
    } else {
        let _e65 = (42f < _e61);
        if _e65 {
        }
        phi_196_ = _e65;
    }
    let _e67 = phi_196_;
    if _e67 {
        phi_200_ = 42f;
    } else {
        phi_200_ = _e61;
    }
    let _e69 = phi_200_;
    let _e70 = (_e69 * _e59);
    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
        phi_289_ = _e70;
    } else {
        if (_e70 < -87f) {
            phi_212_ = -87f;
        } else {
            phi_212_ = _e70;
        }
        let _e76 = phi_212_;
        if (_e76 > 88f) {
            phi_217_ = 88f;
        } else {
            phi_217_ = _e76;
        }
        let _e79 = phi_217_;
        let _e81 = ((_e79 * 1.442695f) + 0.5f);
        if (_e81 > -8388608f) {
            let _e93 = f32(select(0i, select(select(i32(_e81), i32(-2147483648), (_e81 < bitcast<f32>(3472883712u))), 2147483647i, (_e81 > bitcast<f32>(1325400063u))), (_e81 == _e81)));
            if (_e93 > _e81) {
                phi_239_ = 1f;
            } else {
                phi_239_ = 0f;
            }
            let _e96 = phi_239_;
            if (_e81 < 8388608f) {
                phi_244_ = (_e93 - _e96);
                phi_245_ = false;
            } else {
                phi_244_ = f32();
                phi_245_ = true;
            }
            let _e99 = phi_244_;
            let _e101 = phi_245_;
            phi_246_ = _e99;
            phi_247_ = _e101;
        } else {
            phi_246_ = f32();
            phi_247_ = true;
        }
        let _e103 = phi_246_;
        let _e105 = phi_247_;
        if _e105 {
            phi_251_ = _e81;
        } else {
            phi_251_ = _e103;
        }
        let _e107 = phi_251_;
        let _e111 = ((_e79 - (_e107 * 0.69314575f)) - (_e107 * 0.0000014286068f));
        phi_289_ = ((((((((((((((((1f / 5040f) * _e111) + (1f / 720f)) * _e111) + (1f / 120f)) * _e111) + (1f / 24f)) * _e111) + (1f / 6f)) * _e111) + 0.5f) * _e111) + 1f) * _e111) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e107), i32(-2147483648), (_e107 < bitcast<f32>(3472883712u))), 2147483647i, (_e107 > bitcast<f32>(1325400063u))), (_e107 == _e107)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e147 = phi_289_;
    let _e149 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_302_ = true;
    } else {
        let _e153 = (42f < _e149);
        if _e153 {
        }
        phi_302_ = _e153;
    }
    let _e155 = phi_302_;
    if _e155 {
        phi_306_ = 42f;
    } else {
        phi_306_ = _e149;
    }
    let _e157 = phi_306_;
    let _e159 = (-(_e157) * _e59);
    if ((bitcast<u32>(_e159) & 2147483647u) > 2139095040u) {
        phi_396_ = _e159;
    } else {
        if (_e159 < -87f) {
            phi_319_ = -87f;
        } else {
            phi_319_ = _e159;
        }
        let _e165 = phi_319_;
        if (_e165 > 88f) {
            phi_324_ = 88f;
        } else {
            phi_324_ = _e165;
        }
        let _e168 = phi_324_;
        let _e170 = ((_e168 * 1.442695f) + 0.5f);
        if (_e170 > -8388608f) {
            let _e182 = f32(select(0i, select(select(i32(_e170), i32(-2147483648), (_e170 < bitcast<f32>(3472883712u))), 2147483647i, (_e170 > bitcast<f32>(1325400063u))), (_e170 == _e170)));
            if (_e182 > _e170) {
                phi_346_ = 1f;
            } else {
                phi_346_ = 0f;
            }
            let _e185 = phi_346_;
            if (_e170 < 8388608f) {
                phi_351_ = (_e182 - _e185);
                phi_352_ = false;
            } else {
                phi_351_ = f32();
                phi_352_ = true;
            }
            let _e188 = phi_351_;
            let _e190 = phi_352_;
            phi_353_ = _e188;
            phi_354_ = _e190;
        } else {
            phi_353_ = f32();
            phi_354_ = true;
        }
        let _e192 = phi_353_;
        let _e194 = phi_354_;
        if _e194 {
            phi_358_ = _e170;
        } else {
            phi_358_ = _e192;
        }
        let _e196 = phi_358_;
        let _e200 = ((_e168 - (_e196 * 0.69314575f)) - (_e196 * 0.0000014286068f));
        phi_396_ = ((((((((((((((((1f / 5040f) * _e200) + (1f / 720f)) * _e200) + (1f / 120f)) * _e200) + (1f / 24f)) * _e200) + (1f / 6f)) * _e200) + 0.5f) * _e200) + 1f) * _e200) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e196), i32(-2147483648), (_e196 < bitcast<f32>(3472883712u))), 2147483647i, (_e196 > bitcast<f32>(1325400063u))), (_e196 == _e196)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e236 = phi_396_;
    let _e237 = -(_e236);
    return vec4<f32>(_e147, (_e147 * _e147), _e237, (_e237 * _e237));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_992_: bool;
    var phi_996_: f32;
    var phi_1020_: bool;
    var phi_1024_: f32;
    var phi_1036_: bool;
    var phi_1043_: f32;
    var phi_1056_: bool;
    var phi_1060_: f32;
    var phi_1084_: bool;
    var phi_1088_: f32;
    var phi_1100_: bool;
    var phi_1107_: f32;
    var phi_1118_: bool;
    var phi_1122_: f32;
    var phi_1137_: f32;
    var phi_1138_: f32;
    var phi_1139_: f32;

    let _e50 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e52 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_992_ = true;
    } else {
        let _e56 = (42f < _e52);
        if _e56 {
        }
        phi_992_ = _e56;
    }
    let _e58 = phi_992_;
    if _e58 {
        phi_996_ = 42f;
    } else {
        phi_996_ = _e52;
    }
    let _e60 = phi_996_;
    let _e62 = (*param_6).min_variance;
    let _e66 = (((_e62 * _e60) * _e60) * _e50.y);
    let _e73 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u) {
        phi_1020_ = true;
    } else {
        let _e77 = (_e66 > _e73);
        if _e77 {
        }
        phi_1020_ = _e77;
    }
    let _e79 = phi_1020_;
    if _e79 {
        phi_1024_ = _e66;
    } else {
        phi_1024_ = _e73;
    }
    let _e81 = phi_1024_;
    let _e82 = (_e50.x - param_7.x);
    if (_e82 <= 0f) {
        let _e86 = ((bitcast<u32>(_e81) & 2147483647u) > 2139095040u);
        if _e86 {
        }
        phi_1036_ = _e86;
    } else {
        phi_1036_ = true;
    }
    let _e88 = phi_1036_;
    if _e88 {
        phi_1043_ = (_e81 / (_e81 + (_e82 * _e82)));
    } else {
        phi_1043_ = 1f;
    }
    let _e93 = phi_1043_;
    let _e95 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_1056_ = true;
    } else {
        let _e99 = (42f < _e95);
        if _e99 {
        }
        phi_1056_ = _e99;
    }
    let _e101 = phi_1056_;
    if _e101 {
        phi_1060_ = 42f;
    } else {
        phi_1060_ = _e95;
    }
    let _e103 = phi_1060_;
    let _e105 = (*param_6).min_variance;
    let _e109 = (((_e105 * _e103) * _e103) * _e50.w);
    let _e116 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
        phi_1084_ = true;
    } else {
        let _e120 = (_e109 > _e116);
        if _e120 {
        }
        phi_1084_ = _e120;
    }
    let _e122 = phi_1084_;
    if _e122 {
        phi_1088_ = _e109;
    } else {
        phi_1088_ = _e116;
    }
    let _e124 = phi_1088_;
    let _e125 = (_e50.z - param_7.z);
    if (_e125 <= 0f) {
        let _e129 = ((bitcast<u32>(_e124) & 2147483647u) > 2139095040u);
        if _e129 {
        }
        phi_1100_ = _e129;
    } else {
        phi_1100_ = true;
    }
    let _e131 = phi_1100_;
    if _e131 {
        phi_1107_ = (_e124 / (_e124 + (_e125 * _e125)));
    } else {
        phi_1107_ = 1f;
    }
    let _e136 = phi_1107_;
    if ((bitcast<u32>(_e136) & 2147483647u) > 2139095040u) {
        phi_1118_ = true;
    } else {
        let _e140 = (_e136 < _e93);
        if _e140 {
        }
        phi_1118_ = _e140;
    }
    let _e142 = phi_1118_;
    if _e142 {
        phi_1122_ = _e136;
    } else {
        phi_1122_ = _e93;
    }
    let _e144 = phi_1122_;
    if ((bitcast<u32>(_e144) & 2147483647u) > 2139095040u) {
        phi_1139_ = _e144;
    } else {
        if (_e144 < 0f) {
            phi_1138_ = 0f;
        } else {
            if (_e144 > 1f) {
                phi_1137_ = 1f;
            } else {
                phi_1137_ = _e144;
            }
            let _e151 = phi_1137_;
            phi_1138_ = _e151;
        }
        let _e153 = phi_1138_;
        phi_1139_ = _e153;
    }
    let _e155 = phi_1139_;
    return _e155;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_454_: bool;
    var phi_455_: bool;
    var phi_456_: bool;
    var phi_457_: bool;
    var phi_461_: bool;
    var phi_505_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_509_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_586_: bool;
    var phi_595_: bool;
    var phi_604_: bool;
    var phi_605_: bool;
    var phi_606_: bool;
    var phi_607_: bool;
    var phi_608_: bool;
    var phi_609_: bool;
    var phi_610_: bool;
    var phi_614_: bool;
    var phi_708_: f32;
    var phi_711_: f32;
    var phi_740_: f32;
    var phi_745_: f32;
    var phi_746_: bool;
    var phi_747_: f32;
    var phi_748_: bool;
    var phi_752_: f32;
    var phi_772_: f32;
    var phi_777_: f32;
    var phi_778_: bool;
    var phi_779_: f32;
    var phi_780_: bool;
    var phi_784_: f32;
    var phi_834_: i32;
    var phi_839_: i32;
    var phi_844_: i32;
    var phi_849_: i32;
    var phi_858_: i32;
    var phi_863_: i32;
    var phi_868_: i32;
    var phi_873_: i32;
    var phi_958_: evaluate_Verdict;
    var phi_959_: evaluate_Verdict;
    var phi_960_: bool;
    var phi_961_: evaluate_Verdict;
    var phi_962_: evaluate_Verdict;
    var phi_963_: bool;
    var phi_967_: evaluate_Verdict;

    let _e48 = id_1;
    let _e55 = arrayLength((&map.member));
    let _e61 = p.member.size[0u];
    let _e63 = p.member.size[1u];
    let _e64 = lt_shaders_entry_pixel_index(_e48, _e61, _e63);
    if (bitcast<i32>(_e64.root) != 0i) {
        if (_e64.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e73 = p.member.light;
        let _e76 = samples.member[(0u + _e64.first_primitive)].normal[0u];
        let _e78 = global[0u];
        if (_e76 == _e78) {
            let _e81 = samples.member[(0u + _e64.first_primitive)].normal[1u];
            let _e83 = global[1u];
            if (_e81 == _e83) {
                let _e86 = samples.member[(0u + _e64.first_primitive)].normal[2u];
                let _e88 = global[2u];
                phi_454_ = (_e86 == _e88);
                phi_455_ = false;
            } else {
                phi_454_ = bool();
                phi_455_ = true;
            }
            let _e91 = phi_454_;
            let _e93 = phi_455_;
            phi_456_ = _e91;
            phi_457_ = _e93;
        } else {
            phi_456_ = bool();
            phi_457_ = true;
        }
        let _e95 = phi_456_;
        let _e97 = phi_457_;
        if _e97 {
            phi_461_ = false;
        } else {
            phi_461_ = _e95;
        }
        let _e99 = phi_461_;
        if !(_e99) {
            let _e102 = samples.member[(0u + _e64.first_primitive)].normal;
            let _e104 = samples.member[(0u + _e64.first_primitive)].position;
            if ((((_e102.x * (_e73.x - (_e104.x * _e73.w))) + (_e102.y * (_e73.y - (_e104.y * _e73.w)))) + (_e102.z * (_e73.z - (_e104.z * _e73.w)))) > 0f) {
                let _e128 = samples.member[(0u + _e64.first_primitive)].flags;
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_505_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, ((_e128 & 1u) == 0u));
            } else {
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e151.unnamed.visibility, false), _e151.unnamed_1);
                phi_505_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e157.unnamed, true);
            }
            let _e162 = phi_505_;
            phi_509_ = _e162;
        } else {
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
            phi_509_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
        }
        let _e179 = phi_509_;
        if _e179.unnamed_1 {
            phi_961_ = evaluate_Verdict(_e179.unnamed.visibility, _e179.unnamed.is_doubted);
            phi_962_ = evaluate_Verdict();
            phi_963_ = true;
        } else {
            let _e187 = samples.member[(0u + _e64.first_primitive)].position;
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
                    phi_586_ = (_e218 <= 1f);
                } else {
                    phi_586_ = false;
                }
                let _e250 = phi_586_;
                if _e250 {
                    if (_e232 >= 0f) {
                        phi_595_ = (_e232 <= 1f);
                    } else {
                        phi_595_ = false;
                    }
                    let _e254 = phi_595_;
                    if _e254 {
                        if (_e245 >= 0f) {
                            phi_604_ = (_e245 <= 1f);
                        } else {
                            phi_604_ = false;
                        }
                        let _e258 = phi_604_;
                        phi_605_ = _e258;
                        phi_606_ = false;
                    } else {
                        phi_605_ = bool();
                        phi_606_ = true;
                    }
                    let _e260 = phi_605_;
                    let _e262 = phi_606_;
                    phi_607_ = _e260;
                    phi_608_ = _e262;
                } else {
                    phi_607_ = bool();
                    phi_608_ = true;
                }
                let _e264 = phi_607_;
                let _e266 = phi_608_;
                phi_609_ = _e264;
                phi_610_ = _e266;
            } else {
                phi_609_ = bool();
                phi_610_ = true;
            }
            let _e268 = phi_609_;
            let _e270 = phi_610_;
            if _e270 {
                phi_614_ = false;
            } else {
                phi_614_ = _e268;
            }
            let _e272 = phi_614_;
            if _e272 {
                if (0f > 0f) {
                    let _e275 = samples.member[(0u + _e64.first_primitive)].normal;
                    let _e277 = p.member.map_size;
                    let _e280 = p.member.projection.row_x;
                    let _e302 = p.member.projection.row_y;
                    let _e324 = p.member.projection.row_z;
                    let _e351 = ((abs(((((_e280.x * _e275.x) + (_e280.y * _e275.y)) + (_e280.z * _e275.z)) / (((_e280.x * _e280.x) + (_e280.y * _e280.y)) + (_e280.z * _e280.z)))) + abs(((((_e302.x * _e275.x) + (_e302.y * _e275.y)) + (_e302.z * _e275.z)) / (((_e302.x * _e302.x) + (_e302.y * _e302.y)) + (_e302.z * _e302.z))))) / (abs(((((_e324.x * _e275.x) + (_e324.y * _e275.y)) + (_e324.z * _e275.z)) / (((_e324.x * _e324.x) + (_e324.y * _e324.y)) + (_e324.z * _e324.z)))) * f32(_e277)));
                    if (_e351 < 0.002f) {
                        phi_708_ = _e351;
                    } else {
                        phi_708_ = 0.002f;
                    }
                    let _e354 = phi_708_;
                    phi_711_ = (_e245 - (0f * _e354));
                } else {
                    phi_711_ = _e245;
                }
                let _e358 = phi_711_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e218 * _e361) - 0.5f);
                let _e365 = ((_e232 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_740_ = 1f;
                    } else {
                        phi_740_ = 0f;
                    }
                    let _e380 = phi_740_;
                    if (_e364 < 8388608f) {
                        phi_745_ = (_e377 - _e380);
                        phi_746_ = false;
                    } else {
                        phi_745_ = f32();
                        phi_746_ = true;
                    }
                    let _e383 = phi_745_;
                    let _e385 = phi_746_;
                    phi_747_ = _e383;
                    phi_748_ = _e385;
                } else {
                    phi_747_ = f32();
                    phi_748_ = true;
                }
                let _e387 = phi_747_;
                let _e389 = phi_748_;
                if _e389 {
                    phi_752_ = _e364;
                } else {
                    phi_752_ = _e387;
                }
                let _e391 = phi_752_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_772_ = 1f;
                    } else {
                        phi_772_ = 0f;
                    }
                    let _e406 = phi_772_;
                    if (_e365 < 8388608f) {
                        phi_777_ = (_e403 - _e406);
                        phi_778_ = false;
                    } else {
                        phi_777_ = f32();
                        phi_778_ = true;
                    }
                    let _e409 = phi_777_;
                    let _e411 = phi_778_;
                    phi_779_ = _e409;
                    phi_780_ = _e411;
                } else {
                    phi_779_ = f32();
                    phi_780_ = true;
                }
                let _e413 = phi_779_;
                let _e415 = phi_780_;
                if _e415 {
                    phi_784_ = _e365;
                } else {
                    phi_784_ = _e413;
                }
                let _e417 = phi_784_;
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
                local = lt_math_Evsm(_e448.positive_exponent, _e448.negative_exponent, _e448.min_variance);
                let _e456 = (bitcast<i32>(_e450) - 1i);
                if (_e428 > 0i) {
                    phi_834_ = _e428;
                } else {
                    phi_834_ = 0i;
                }
                let _e459 = phi_834_;
                if (_e437 > 0i) {
                    phi_839_ = _e437;
                } else {
                    phi_839_ = 0i;
                }
                let _e462 = phi_839_;
                if (_e459 < _e456) {
                    phi_844_ = _e459;
                } else {
                    phi_844_ = _e456;
                }
                let _e465 = phi_844_;
                if (_e462 < _e456) {
                    phi_849_ = _e462;
                } else {
                    phi_849_ = _e456;
                }
                let _e468 = phi_849_;
                let _e469 = bitcast<u32>(_e465);
                let _e471 = (_e428 + 1i);
                let _e472 = (_e437 + 1i);
                if (_e471 > 0i) {
                    phi_858_ = _e471;
                } else {
                    phi_858_ = 0i;
                }
                let _e475 = phi_858_;
                if (_e472 > 0i) {
                    phi_863_ = _e472;
                } else {
                    phi_863_ = 0i;
                }
                let _e478 = phi_863_;
                if (_e475 < _e456) {
                    phi_868_ = _e475;
                } else {
                    phi_868_ = _e456;
                }
                let _e481 = phi_868_;
                if (_e478 < _e456) {
                    phi_873_ = _e478;
                } else {
                    phi_873_ = _e456;
                }
                let _e484 = phi_873_;
                let _e485 = bitcast<u32>(_e481);
                let _e487 = (bitcast<u32>(_e468) * _e450);
                let _e488 = (bitcast<u32>(_e484) * _e450);
                let _e489 = (_e487 + _e469);
                let _e490 = (_e487 + _e485);
                let _e491 = (_e488 + _e469);
                let _e492 = (_e488 + _e485);
                if (_e489 < _e55) {
                } else {
                    return;
                }
                let _e496 = map.member[(0u + _e489)];
                if (_e490 < _e55) {
                } else {
                    return;
                }
                let _e508 = map.member[(0u + _e490)];
                if (_e491 < _e55) {
                } else {
                    return;
                }
                let _e524 = map.member[(0u + _e491)];
                if (_e492 < _e55) {
                } else {
                    return;
                }
                let _e540 = map.member[(0u + _e492)];
                let _e554 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e496.x * _e440) + (_e508.x * _e442)) + (_e524.x * _e444)) + (_e540.x * _e445)), ((((_e496.y * _e440) + (_e508.y * _e442)) + (_e524.y * _e444)) + (_e540.y * _e445)), ((((_e496.z * _e440) + (_e508.z * _e442)) + (_e524.z * _e444)) + (_e540.z * _e445)), ((((_e496.w * _e440) + (_e508.w * _e442)) + (_e524.w * _e444)) + (_e540.w * _e445))), _e358);
                phi_958_ = evaluate_Verdict(_e554, false);
                phi_959_ = evaluate_Verdict();
                phi_960_ = false;
            } else {
                phi_958_ = evaluate_Verdict();
                phi_959_ = evaluate_Verdict(1f, false);
                phi_960_ = true;
            }
            let _e558 = phi_958_;
            let _e560 = phi_959_;
            let _e562 = phi_960_;
            phi_961_ = _e560;
            phi_962_ = _e558;
            phi_963_ = _e562;
        }
        let _e564 = phi_961_;
        let _e566 = phi_962_;
        let _e568 = phi_963_;
        if _e568 {
            phi_967_ = _e564;
        } else {
            phi_967_ = _e566;
        }
        let _e570 = phi_967_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e570.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
