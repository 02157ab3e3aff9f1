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
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_32 {
    member: abi_ShadowParams,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
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
    var phi_147_: lt_bvh_traverse_Tree;
    var phi_148_: bool;
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_155_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_147_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_148_ = false;
        } else {
            phi_147_ = lt_bvh_traverse_Tree();
            phi_148_ = true;
        }
        let _e60 = phi_147_;
        let _e62 = phi_148_;
        phi_149_ = _e60;
        phi_150_ = _e62;
    } else {
        phi_149_ = lt_bvh_traverse_Tree();
        phi_150_ = true;
    }
    let _e64 = phi_149_;
    let _e66 = phi_150_;
    if _e66 {
        phi_155_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_155_ = _e64;
    }
    let _e71 = phi_155_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_182_: f32;
    var phi_183_: f32;
    var phi_184_: f32;
    var phi_197_: bool;
    var phi_201_: f32;
    var phi_213_: f32;
    var phi_218_: f32;
    var phi_240_: f32;
    var phi_245_: f32;
    var phi_246_: bool;
    var phi_247_: f32;
    var phi_248_: bool;
    var phi_252_: f32;
    var phi_290_: f32;
    var phi_303_: bool;
    var phi_307_: f32;
    var phi_320_: f32;
    var phi_325_: f32;
    var phi_347_: f32;
    var phi_352_: f32;
    var phi_353_: bool;
    var phi_354_: f32;
    var phi_355_: bool;
    var phi_359_: f32;
    var phi_397_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_184_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_183_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_182_ = 1f;
            } else {
                phi_182_ = param_5;
            }
            let _e55 = phi_182_;
            phi_183_ = _e55;
        }
        let _e57 = phi_183_;
        phi_184_ = _e57;
    }
    let _e59 = phi_184_;
    let _e61 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_197_ = true;
    } else {
        let _e65 = (42f < _e61);
        if _e65 {
        }
        phi_197_ = _e65;
    }
    let _e67 = phi_197_;
    if _e67 {
        phi_201_ = 42f;
    } else {
        phi_201_ = _e61;
    }
    let _e69 = phi_201_;
    let _e70 = (_e69 * _e59);
    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
        phi_290_ = _e70;
    } else {
        if (_e70 < -87f) {
            phi_213_ = -87f;
        } else {
            phi_213_ = _e70;
        }
        let _e76 = phi_213_;
        if (_e76 > 88f) {
            phi_218_ = 88f;
        } else {
            phi_218_ = _e76;
        }
        let _e79 = phi_218_;
        let _e81 = ((_e79 * 1.442695f) + 0.5f);
        if (_e81 > -8388608f) {
            let _e93 = f32(select(0i, select(select(i32(_e81), i32(-2147483648), (_e81 < bitcast<f32>(3472883712u))), 2147483647i, (_e81 > bitcast<f32>(1325400063u))), (_e81 == _e81)));
            if (_e93 > _e81) {
                phi_240_ = 1f;
            } else {
                phi_240_ = 0f;
            }
            let _e96 = phi_240_;
            if (_e81 < 8388608f) {
                phi_245_ = (_e93 - _e96);
                phi_246_ = false;
            } else {
                phi_245_ = f32();
                phi_246_ = true;
            }
            let _e99 = phi_245_;
            let _e101 = phi_246_;
            phi_247_ = _e99;
            phi_248_ = _e101;
        } else {
            phi_247_ = f32();
            phi_248_ = true;
        }
        let _e103 = phi_247_;
        let _e105 = phi_248_;
        if _e105 {
            phi_252_ = _e81;
        } else {
            phi_252_ = _e103;
        }
        let _e107 = phi_252_;
        let _e111 = ((_e79 - (_e107 * 0.69314575f)) - (_e107 * 0.0000014286068f));
        phi_290_ = ((((((((((((((((1f / 5040f) * _e111) + (1f / 720f)) * _e111) + (1f / 120f)) * _e111) + (1f / 24f)) * _e111) + (1f / 6f)) * _e111) + 0.5f) * _e111) + 1f) * _e111) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e107), i32(-2147483648), (_e107 < bitcast<f32>(3472883712u))), 2147483647i, (_e107 > bitcast<f32>(1325400063u))), (_e107 == _e107)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e147 = phi_290_;
    let _e149 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_303_ = true;
    } else {
        let _e153 = (42f < _e149);
        if _e153 {
        }
        phi_303_ = _e153;
    }
    let _e155 = phi_303_;
    if _e155 {
        phi_307_ = 42f;
    } else {
        phi_307_ = _e149;
    }
    let _e157 = phi_307_;
    let _e159 = (-(_e157) * _e59);
    if ((bitcast<u32>(_e159) & 2147483647u) > 2139095040u) {
        phi_397_ = _e159;
    } else {
        if (_e159 < -87f) {
            phi_320_ = -87f;
        } else {
            phi_320_ = _e159;
        }
        let _e165 = phi_320_;
        if (_e165 > 88f) {
            phi_325_ = 88f;
        } else {
            phi_325_ = _e165;
        }
        let _e168 = phi_325_;
        let _e170 = ((_e168 * 1.442695f) + 0.5f);
        if (_e170 > -8388608f) {
            let _e182 = f32(select(0i, select(select(i32(_e170), i32(-2147483648), (_e170 < bitcast<f32>(3472883712u))), 2147483647i, (_e170 > bitcast<f32>(1325400063u))), (_e170 == _e170)));
            if (_e182 > _e170) {
                phi_347_ = 1f;
            } else {
                phi_347_ = 0f;
            }
            let _e185 = phi_347_;
            if (_e170 < 8388608f) {
                phi_352_ = (_e182 - _e185);
                phi_353_ = false;
            } else {
                phi_352_ = f32();
                phi_353_ = true;
            }
            let _e188 = phi_352_;
            let _e190 = phi_353_;
            phi_354_ = _e188;
            phi_355_ = _e190;
        } else {
            phi_354_ = f32();
            phi_355_ = true;
        }
        let _e192 = phi_354_;
        let _e194 = phi_355_;
        if _e194 {
            phi_359_ = _e170;
        } else {
            phi_359_ = _e192;
        }
        let _e196 = phi_359_;
        let _e200 = ((_e168 - (_e196 * 0.69314575f)) - (_e196 * 0.0000014286068f));
        phi_397_ = ((((((((((((((((1f / 5040f) * _e200) + (1f / 720f)) * _e200) + (1f / 120f)) * _e200) + (1f / 24f)) * _e200) + (1f / 6f)) * _e200) + 0.5f) * _e200) + 1f) * _e200) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e196), i32(-2147483648), (_e196 < bitcast<f32>(3472883712u))), 2147483647i, (_e196 > bitcast<f32>(1325400063u))), (_e196 == _e196)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e236 = phi_397_;
    let _e237 = -(_e236);
    return vec4<f32>(_e147, (_e147 * _e147), _e237, (_e237 * _e237));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_995_: bool;
    var phi_999_: f32;
    var phi_1023_: bool;
    var phi_1027_: f32;
    var phi_1039_: bool;
    var phi_1046_: f32;
    var phi_1059_: bool;
    var phi_1063_: f32;
    var phi_1087_: bool;
    var phi_1091_: f32;
    var phi_1103_: bool;
    var phi_1110_: f32;
    var phi_1121_: bool;
    var phi_1125_: f32;
    var phi_1140_: f32;
    var phi_1141_: f32;
    var phi_1142_: f32;

    let _e50 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e52 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_995_ = true;
    } else {
        let _e56 = (42f < _e52);
        if _e56 {
        }
        phi_995_ = _e56;
    }
    let _e58 = phi_995_;
    if _e58 {
        phi_999_ = 42f;
    } else {
        phi_999_ = _e52;
    }
    let _e60 = phi_999_;
    let _e62 = (*param_6).min_variance;
    let _e66 = (((_e62 * _e60) * _e60) * _e50.y);
    let _e73 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u) {
        phi_1023_ = true;
    } else {
        let _e77 = (_e66 > _e73);
        if _e77 {
        }
        phi_1023_ = _e77;
    }
    let _e79 = phi_1023_;
    if _e79 {
        phi_1027_ = _e66;
    } else {
        phi_1027_ = _e73;
    }
    let _e81 = phi_1027_;
    let _e82 = (_e50.x - param_7.x);
    if (_e82 <= 0f) {
        let _e86 = ((bitcast<u32>(_e81) & 2147483647u) > 2139095040u);
        if _e86 {
        }
        phi_1039_ = _e86;
    } else {
        phi_1039_ = true;
    }
    let _e88 = phi_1039_;
    if _e88 {
        phi_1046_ = (_e81 / (_e81 + (_e82 * _e82)));
    } else {
        phi_1046_ = 1f;
    }
    let _e93 = phi_1046_;
    let _e95 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_1059_ = true;
    } else {
        let _e99 = (42f < _e95);
        if _e99 {
        }
        phi_1059_ = _e99;
    }
    let _e101 = phi_1059_;
    if _e101 {
        phi_1063_ = 42f;
    } else {
        phi_1063_ = _e95;
    }
    let _e103 = phi_1063_;
    let _e105 = (*param_6).min_variance;
    let _e109 = (((_e105 * _e103) * _e103) * _e50.w);
    let _e116 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
        phi_1087_ = true;
    } else {
        let _e120 = (_e109 > _e116);
        if _e120 {
        }
        phi_1087_ = _e120;
    }
    let _e122 = phi_1087_;
    if _e122 {
        phi_1091_ = _e109;
    } else {
        phi_1091_ = _e116;
    }
    let _e124 = phi_1091_;
    let _e125 = (_e50.z - param_7.z);
    if (_e125 <= 0f) {
        let _e129 = ((bitcast<u32>(_e124) & 2147483647u) > 2139095040u);
        if _e129 {
        }
        phi_1103_ = _e129;
    } else {
        phi_1103_ = true;
    }
    let _e131 = phi_1103_;
    if _e131 {
        phi_1110_ = (_e124 / (_e124 + (_e125 * _e125)));
    } else {
        phi_1110_ = 1f;
    }
    let _e136 = phi_1110_;
    if ((bitcast<u32>(_e136) & 2147483647u) > 2139095040u) {
        phi_1121_ = true;
    } else {
        let _e140 = (_e136 < _e93);
        if _e140 {
        }
        phi_1121_ = _e140;
    }
    let _e142 = phi_1121_;
    if _e142 {
        phi_1125_ = _e136;
    } else {
        phi_1125_ = _e93;
    }
    let _e144 = phi_1125_;
    if ((bitcast<u32>(_e144) & 2147483647u) > 2139095040u) {
        phi_1142_ = _e144;
    } else {
        if (_e144 < 0f) {
            phi_1141_ = 0f;
        } else {
            if (_e144 > 1f) {
                phi_1140_ = 1f;
            } else {
                phi_1140_ = _e144;
            }
            let _e151 = phi_1140_;
            phi_1141_ = _e151;
        }
        let _e153 = phi_1141_;
        phi_1142_ = _e153;
    }
    let _e155 = phi_1142_;
    return _e155;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_458_: bool;
    var phi_459_: bool;
    var phi_460_: bool;
    var phi_461_: bool;
    var phi_465_: bool;
    var phi_509_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_513_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_587_: bool;
    var phi_596_: bool;
    var phi_605_: bool;
    var phi_606_: bool;
    var phi_607_: bool;
    var phi_608_: bool;
    var phi_609_: bool;
    var phi_610_: bool;
    var phi_611_: bool;
    var phi_615_: bool;
    var phi_705_: f32;
    var phi_708_: f32;
    var phi_737_: f32;
    var phi_742_: f32;
    var phi_743_: bool;
    var phi_744_: f32;
    var phi_745_: bool;
    var phi_749_: f32;
    var phi_769_: f32;
    var phi_774_: f32;
    var phi_775_: bool;
    var phi_776_: f32;
    var phi_777_: bool;
    var phi_781_: f32;
    var phi_833_: i32;
    var phi_838_: i32;
    var phi_843_: i32;
    var phi_848_: i32;
    var phi_857_: i32;
    var phi_862_: i32;
    var phi_867_: i32;
    var phi_872_: i32;
    var phi_961_: evaluate_Verdict;
    var phi_962_: evaluate_Verdict;
    var phi_963_: bool;
    var phi_964_: evaluate_Verdict;
    var phi_965_: evaluate_Verdict;
    var phi_966_: bool;
    var phi_970_: evaluate_Verdict;

    let _e48 = id_1;
    let _e55 = arrayLength((&map.member));
    let _e61 = p.member.size[0u];
    let _e63 = p.member.size[1u];
    let _e64 = lt_shaders_entry_pixel_index(_e48, _e61, _e63);
    if (bitcast<i32>(_e64.root) != 0i) {
        let _e70 = p.member.projection;
        if (_e64.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e74 = lt_math_OneLevel(_e70);
        let _e76 = p.member.light;
        let _e79 = samples.member[(0u + _e64.first_primitive)].normal[0u];
        let _e81 = global[0u];
        if (_e79 == _e81) {
            let _e84 = samples.member[(0u + _e64.first_primitive)].normal[1u];
            let _e86 = global[1u];
            if (_e84 == _e86) {
                let _e89 = samples.member[(0u + _e64.first_primitive)].normal[2u];
                let _e91 = global[2u];
                phi_458_ = (_e89 == _e91);
                phi_459_ = false;
            } else {
                phi_458_ = bool();
                phi_459_ = true;
            }
            let _e94 = phi_458_;
            let _e96 = phi_459_;
            phi_460_ = _e94;
            phi_461_ = _e96;
        } else {
            phi_460_ = bool();
            phi_461_ = true;
        }
        let _e98 = phi_460_;
        let _e100 = phi_461_;
        if _e100 {
            phi_465_ = false;
        } else {
            phi_465_ = _e98;
        }
        let _e102 = phi_465_;
        if !(_e102) {
            let _e105 = samples.member[(0u + _e64.first_primitive)].normal;
            let _e107 = samples.member[(0u + _e64.first_primitive)].position;
            if ((((_e105.x * (_e76.x - (_e107.x * _e76.w))) + (_e105.y * (_e76.y - (_e107.y * _e76.w)))) + (_e105.z * (_e76.z - (_e107.z * _e76.w)))) > 0f) {
                let _e131 = samples.member[(0u + _e64.first_primitive)].flags;
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e139.unnamed.visibility, false), _e139.unnamed_1);
                phi_509_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e145.unnamed, ((_e131 & 1u) == 0u));
            } else {
                let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
                phi_509_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
            }
            let _e165 = phi_509_;
            phi_513_ = _e165;
        } else {
            let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e171.unnamed.visibility, false), _e171.unnamed_1);
            phi_513_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e177.unnamed, true);
        }
        let _e182 = phi_513_;
        if _e182.unnamed_1 {
            phi_964_ = evaluate_Verdict(_e182.unnamed.visibility, _e182.unnamed.is_doubted);
            phi_965_ = evaluate_Verdict();
            phi_966_ = true;
        } else {
            let _e190 = samples.member[(0u + _e64.first_primitive)].position;
            let _e208 = ((((_e74.projection.row_w.x * _e190.x) + (_e74.projection.row_w.y * _e190.y)) + (_e74.projection.row_w.z * _e190.z)) + (_e74.projection.row_w.w * 1f));
            let _e222 = (((((_e74.projection.row_x.x * _e190.x) + (_e74.projection.row_x.y * _e190.y)) + (_e74.projection.row_x.z * _e190.z)) + (_e74.projection.row_x.w * 1f)) / _e208);
            let _e236 = (((((_e74.projection.row_y.x * _e190.x) + (_e74.projection.row_y.y * _e190.y)) + (_e74.projection.row_y.z * _e190.z)) + (_e74.projection.row_y.w * 1f)) / _e208);
            let _e249 = ((((_e74.projection.row_z.x * _e190.x) + (_e74.projection.row_z.y * _e190.y)) + (_e74.projection.row_z.z * _e190.z)) + (_e74.projection.row_z.w * 1f));
            if (_e208 > 0f) {
                if (_e222 >= 0f) {
                    phi_587_ = (_e222 <= 1f);
                } else {
                    phi_587_ = false;
                }
                let _e254 = phi_587_;
                if _e254 {
                    if (_e236 >= 0f) {
                        phi_596_ = (_e236 <= 1f);
                    } else {
                        phi_596_ = false;
                    }
                    let _e258 = phi_596_;
                    if _e258 {
                        if (_e249 >= 0f) {
                            phi_605_ = (_e249 <= 1f);
                        } else {
                            phi_605_ = false;
                        }
                        let _e262 = phi_605_;
                        phi_606_ = _e262;
                        phi_607_ = false;
                    } else {
                        phi_606_ = bool();
                        phi_607_ = true;
                    }
                    let _e264 = phi_606_;
                    let _e266 = phi_607_;
                    phi_608_ = _e264;
                    phi_609_ = _e266;
                } else {
                    phi_608_ = bool();
                    phi_609_ = true;
                }
                let _e268 = phi_608_;
                let _e270 = phi_609_;
                phi_610_ = _e268;
                phi_611_ = _e270;
            } else {
                phi_610_ = bool();
                phi_611_ = true;
            }
            let _e272 = phi_610_;
            let _e274 = phi_611_;
            if _e274 {
                phi_615_ = false;
            } else {
                phi_615_ = _e272;
            }
            let _e276 = phi_615_;
            if _e276 {
                if (0f > 0f) {
                    let _e279 = samples.member[(0u + _e64.first_primitive)].normal;
                    let _e281 = p.member.map_size;
                    let _e351 = ((abs(((((_e70.row_x.x * _e279.x) + (_e70.row_x.y * _e279.y)) + (_e70.row_x.z * _e279.z)) / (((_e70.row_x.x * _e70.row_x.x) + (_e70.row_x.y * _e70.row_x.y)) + (_e70.row_x.z * _e70.row_x.z)))) + abs(((((_e70.row_y.x * _e279.x) + (_e70.row_y.y * _e279.y)) + (_e70.row_y.z * _e279.z)) / (((_e70.row_y.x * _e70.row_y.x) + (_e70.row_y.y * _e70.row_y.y)) + (_e70.row_y.z * _e70.row_y.z))))) / (abs(((((_e70.row_z.x * _e279.x) + (_e70.row_z.y * _e279.y)) + (_e70.row_z.z * _e279.z)) / (((_e70.row_z.x * _e70.row_z.x) + (_e70.row_z.y * _e70.row_z.y)) + (_e70.row_z.z * _e70.row_z.z)))) * f32(_e281)));
                    if (_e351 < 0.002f) {
                        phi_705_ = _e351;
                    } else {
                        phi_705_ = 0.002f;
                    }
                    let _e354 = phi_705_;
                    phi_708_ = (_e249 - (0f * _e354));
                } else {
                    phi_708_ = _e249;
                }
                let _e358 = phi_708_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e222 * _e361) - 0.5f);
                let _e365 = ((_e236 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_737_ = 1f;
                    } else {
                        phi_737_ = 0f;
                    }
                    let _e380 = phi_737_;
                    if (_e364 < 8388608f) {
                        phi_742_ = (_e377 - _e380);
                        phi_743_ = false;
                    } else {
                        phi_742_ = f32();
                        phi_743_ = true;
                    }
                    let _e383 = phi_742_;
                    let _e385 = phi_743_;
                    phi_744_ = _e383;
                    phi_745_ = _e385;
                } else {
                    phi_744_ = f32();
                    phi_745_ = true;
                }
                let _e387 = phi_744_;
                let _e389 = phi_745_;
                if _e389 {
                    phi_749_ = _e364;
                } else {
                    phi_749_ = _e387;
                }
                let _e391 = phi_749_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_769_ = 1f;
                    } else {
                        phi_769_ = 0f;
                    }
                    let _e406 = phi_769_;
                    if (_e365 < 8388608f) {
                        phi_774_ = (_e403 - _e406);
                        phi_775_ = false;
                    } else {
                        phi_774_ = f32();
                        phi_775_ = true;
                    }
                    let _e409 = phi_774_;
                    let _e411 = phi_775_;
                    phi_776_ = _e409;
                    phi_777_ = _e411;
                } else {
                    phi_776_ = f32();
                    phi_777_ = true;
                }
                let _e413 = phi_776_;
                let _e415 = phi_777_;
                if _e415 {
                    phi_781_ = _e365;
                } else {
                    phi_781_ = _e413;
                }
                let _e417 = phi_781_;
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
                let _e456 = ((0u * _e450) * _e450);
                let _e458 = (bitcast<i32>(_e450) - 1i);
                if (_e428 > 0i) {
                    phi_833_ = _e428;
                } else {
                    phi_833_ = 0i;
                }
                let _e461 = phi_833_;
                if (_e437 > 0i) {
                    phi_838_ = _e437;
                } else {
                    phi_838_ = 0i;
                }
                let _e464 = phi_838_;
                if (_e461 < _e458) {
                    phi_843_ = _e461;
                } else {
                    phi_843_ = _e458;
                }
                let _e467 = phi_843_;
                if (_e464 < _e458) {
                    phi_848_ = _e464;
                } else {
                    phi_848_ = _e458;
                }
                let _e470 = phi_848_;
                let _e471 = bitcast<u32>(_e467);
                let _e473 = (_e428 + 1i);
                let _e474 = (_e437 + 1i);
                if (_e473 > 0i) {
                    phi_857_ = _e473;
                } else {
                    phi_857_ = 0i;
                }
                let _e477 = phi_857_;
                if (_e474 > 0i) {
                    phi_862_ = _e474;
                } else {
                    phi_862_ = 0i;
                }
                let _e480 = phi_862_;
                if (_e477 < _e458) {
                    phi_867_ = _e477;
                } else {
                    phi_867_ = _e458;
                }
                let _e483 = phi_867_;
                if (_e480 < _e458) {
                    phi_872_ = _e480;
                } else {
                    phi_872_ = _e458;
                }
                let _e486 = phi_872_;
                let _e487 = bitcast<u32>(_e483);
                let _e489 = (bitcast<u32>(_e470) * _e450);
                let _e490 = (bitcast<u32>(_e486) * _e450);
                let _e495 = ((_e489 + _e471) + _e456);
                let _e496 = ((_e489 + _e487) + _e456);
                let _e497 = ((_e490 + _e471) + _e456);
                let _e498 = ((_e490 + _e487) + _e456);
                if (_e495 < _e55) {
                } else {
                    return;
                }
                let _e502 = map.member[(0u + _e495)];
                if (_e496 < _e55) {
                } else {
                    return;
                }
                let _e514 = map.member[(0u + _e496)];
                if (_e497 < _e55) {
                } else {
                    return;
                }
                let _e530 = map.member[(0u + _e497)];
                if (_e498 < _e55) {
                } else {
                    return;
                }
                let _e546 = map.member[(0u + _e498)];
                let _e560 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e502.x * _e440) + (_e514.x * _e442)) + (_e530.x * _e444)) + (_e546.x * _e445)), ((((_e502.y * _e440) + (_e514.y * _e442)) + (_e530.y * _e444)) + (_e546.y * _e445)), ((((_e502.z * _e440) + (_e514.z * _e442)) + (_e530.z * _e444)) + (_e546.z * _e445)), ((((_e502.w * _e440) + (_e514.w * _e442)) + (_e530.w * _e444)) + (_e546.w * _e445))), _e358);
                phi_961_ = evaluate_Verdict(_e560, false);
                phi_962_ = evaluate_Verdict();
                phi_963_ = false;
            } else {
                phi_961_ = evaluate_Verdict();
                phi_962_ = evaluate_Verdict(1f, false);
                phi_963_ = true;
            }
            let _e564 = phi_961_;
            let _e566 = phi_962_;
            let _e568 = phi_963_;
            phi_964_ = _e566;
            phi_965_ = _e564;
            phi_966_ = _e568;
        }
        let _e570 = phi_964_;
        let _e572 = phi_965_;
        let _e574 = phi_966_;
        if _e574 {
            phi_970_ = _e570;
        } else {
            phi_970_ = _e572;
        }
        let _e576 = phi_970_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e576.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
