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

struct type_29 {
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

struct type_33 {
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
var<uniform> p: type_33;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(2) 
var<storage> map: type_29;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_148_: lt_bvh_traverse_Tree;
    var phi_149_: bool;
    var phi_150_: lt_bvh_traverse_Tree;
    var phi_151_: bool;
    var phi_156_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_148_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_149_ = false;
        } else {
            phi_148_ = lt_bvh_traverse_Tree();
            phi_149_ = true;
        }
        let _e60 = phi_148_;
        let _e62 = phi_149_;
        phi_150_ = _e60;
        phi_151_ = _e62;
    } else {
        phi_150_ = lt_bvh_traverse_Tree();
        phi_151_ = true;
    }
    let _e64 = phi_150_;
    let _e66 = phi_151_;
    if _e66 {
        phi_156_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_156_ = _e64;
    }
    let _e71 = phi_156_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_183_: f32;
    var phi_184_: f32;
    var phi_185_: f32;
    var phi_198_: bool;
    var phi_202_: f32;
    var phi_214_: f32;
    var phi_219_: f32;
    var phi_241_: f32;
    var phi_246_: f32;
    var phi_247_: bool;
    var phi_248_: f32;
    var phi_249_: bool;
    var phi_253_: f32;
    var phi_291_: f32;
    var phi_304_: bool;
    var phi_308_: f32;
    var phi_321_: f32;
    var phi_326_: f32;
    var phi_348_: f32;
    var phi_353_: f32;
    var phi_354_: bool;
    var phi_355_: f32;
    var phi_356_: bool;
    var phi_360_: f32;
    var phi_398_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_185_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_184_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_183_ = 1f;
            } else {
                phi_183_ = param_5;
            }
            let _e55 = phi_183_;
            phi_184_ = _e55;
        }
        let _e57 = phi_184_;
        phi_185_ = _e57;
    }
    let _e59 = phi_185_;
    let _e61 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_198_ = true;
    } else {
        let _e65 = (42f < _e61);
        if _e65 {
        }
        phi_198_ = _e65;
    }
    let _e67 = phi_198_;
    if _e67 {
        phi_202_ = 42f;
    } else {
        phi_202_ = _e61;
    }
    let _e69 = phi_202_;
    let _e70 = (_e69 * _e59);
    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
        phi_291_ = _e70;
    } else {
        if (_e70 < -87f) {
            phi_214_ = -87f;
        } else {
            phi_214_ = _e70;
        }
        let _e76 = phi_214_;
        if (_e76 > 88f) {
            phi_219_ = 88f;
        } else {
            phi_219_ = _e76;
        }
        let _e79 = phi_219_;
        let _e81 = ((_e79 * 1.442695f) + 0.5f);
        if (_e81 > -8388608f) {
            let _e93 = f32(select(0i, select(select(i32(_e81), i32(-2147483648), (_e81 < bitcast<f32>(3472883712u))), 2147483647i, (_e81 > bitcast<f32>(1325400063u))), (_e81 == _e81)));
            if (_e93 > _e81) {
                phi_241_ = 1f;
            } else {
                phi_241_ = 0f;
            }
            let _e96 = phi_241_;
            if (_e81 < 8388608f) {
                phi_246_ = (_e93 - _e96);
                phi_247_ = false;
            } else {
                phi_246_ = f32();
                phi_247_ = true;
            }
            let _e99 = phi_246_;
            let _e101 = phi_247_;
            phi_248_ = _e99;
            phi_249_ = _e101;
        } else {
            phi_248_ = f32();
            phi_249_ = true;
        }
        let _e103 = phi_248_;
        let _e105 = phi_249_;
        if _e105 {
            phi_253_ = _e81;
        } else {
            phi_253_ = _e103;
        }
        let _e107 = phi_253_;
        let _e111 = ((_e79 - (_e107 * 0.69314575f)) - (_e107 * 0.0000014286068f));
        phi_291_ = ((((((((((((((((1f / 5040f) * _e111) + (1f / 720f)) * _e111) + (1f / 120f)) * _e111) + (1f / 24f)) * _e111) + (1f / 6f)) * _e111) + 0.5f) * _e111) + 1f) * _e111) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e107), i32(-2147483648), (_e107 < bitcast<f32>(3472883712u))), 2147483647i, (_e107 > bitcast<f32>(1325400063u))), (_e107 == _e107)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e147 = phi_291_;
    let _e149 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_304_ = true;
    } else {
        let _e153 = (42f < _e149);
        if _e153 {
        }
        phi_304_ = _e153;
    }
    let _e155 = phi_304_;
    if _e155 {
        phi_308_ = 42f;
    } else {
        phi_308_ = _e149;
    }
    let _e157 = phi_308_;
    let _e159 = (-(_e157) * _e59);
    if ((bitcast<u32>(_e159) & 2147483647u) > 2139095040u) {
        phi_398_ = _e159;
    } else {
        if (_e159 < -87f) {
            phi_321_ = -87f;
        } else {
            phi_321_ = _e159;
        }
        let _e165 = phi_321_;
        if (_e165 > 88f) {
            phi_326_ = 88f;
        } else {
            phi_326_ = _e165;
        }
        let _e168 = phi_326_;
        let _e170 = ((_e168 * 1.442695f) + 0.5f);
        if (_e170 > -8388608f) {
            let _e182 = f32(select(0i, select(select(i32(_e170), i32(-2147483648), (_e170 < bitcast<f32>(3472883712u))), 2147483647i, (_e170 > bitcast<f32>(1325400063u))), (_e170 == _e170)));
            if (_e182 > _e170) {
                phi_348_ = 1f;
            } else {
                phi_348_ = 0f;
            }
            let _e185 = phi_348_;
            if (_e170 < 8388608f) {
                phi_353_ = (_e182 - _e185);
                phi_354_ = false;
            } else {
                phi_353_ = f32();
                phi_354_ = true;
            }
            let _e188 = phi_353_;
            let _e190 = phi_354_;
            phi_355_ = _e188;
            phi_356_ = _e190;
        } else {
            phi_355_ = f32();
            phi_356_ = true;
        }
        let _e192 = phi_355_;
        let _e194 = phi_356_;
        if _e194 {
            phi_360_ = _e170;
        } else {
            phi_360_ = _e192;
        }
        let _e196 = phi_360_;
        let _e200 = ((_e168 - (_e196 * 0.69314575f)) - (_e196 * 0.0000014286068f));
        phi_398_ = ((((((((((((((((1f / 5040f) * _e200) + (1f / 720f)) * _e200) + (1f / 120f)) * _e200) + (1f / 24f)) * _e200) + (1f / 6f)) * _e200) + 0.5f) * _e200) + 1f) * _e200) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e196), i32(-2147483648), (_e196 < bitcast<f32>(3472883712u))), 2147483647i, (_e196 > bitcast<f32>(1325400063u))), (_e196 == _e196)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e236 = phi_398_;
    let _e237 = -(_e236);
    return vec4<f32>(_e147, (_e147 * _e147), _e237, (_e237 * _e237));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_420_: bool;
    var phi_424_: f32;
    var phi_448_: bool;
    var phi_452_: f32;
    var phi_464_: bool;
    var phi_471_: f32;
    var phi_484_: bool;
    var phi_488_: f32;
    var phi_512_: bool;
    var phi_516_: f32;
    var phi_528_: bool;
    var phi_535_: f32;
    var phi_546_: bool;
    var phi_550_: f32;
    var phi_565_: f32;
    var phi_566_: f32;
    var phi_567_: f32;

    let _e50 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e52 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_420_ = true;
    } else {
        let _e56 = (42f < _e52);
        if _e56 {
        }
        phi_420_ = _e56;
    }
    let _e58 = phi_420_;
    if _e58 {
        phi_424_ = 42f;
    } else {
        phi_424_ = _e52;
    }
    let _e60 = phi_424_;
    let _e62 = (*param_6).min_variance;
    let _e66 = (((_e62 * _e60) * _e60) * _e50.y);
    let _e73 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u) {
        phi_448_ = true;
    } else {
        let _e77 = (_e66 > _e73);
        if _e77 {
        }
        phi_448_ = _e77;
    }
    let _e79 = phi_448_;
    if _e79 {
        phi_452_ = _e66;
    } else {
        phi_452_ = _e73;
    }
    let _e81 = phi_452_;
    let _e82 = (_e50.x - param_7.x);
    if (_e82 <= 0f) {
        let _e86 = ((bitcast<u32>(_e81) & 2147483647u) > 2139095040u);
        if _e86 {
        }
        phi_464_ = _e86;
    } else {
        phi_464_ = true;
    }
    let _e88 = phi_464_;
    if _e88 {
        phi_471_ = (_e81 / (_e81 + (_e82 * _e82)));
    } else {
        phi_471_ = 1f;
    }
    let _e93 = phi_471_;
    let _e95 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_484_ = true;
    } else {
        let _e99 = (42f < _e95);
        if _e99 {
        }
        phi_484_ = _e99;
    }
    let _e101 = phi_484_;
    if _e101 {
        phi_488_ = 42f;
    } else {
        phi_488_ = _e95;
    }
    let _e103 = phi_488_;
    let _e105 = (*param_6).min_variance;
    let _e109 = (((_e105 * _e103) * _e103) * _e50.w);
    let _e116 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
        phi_512_ = true;
    } else {
        let _e120 = (_e109 > _e116);
        if _e120 {
        }
        phi_512_ = _e120;
    }
    let _e122 = phi_512_;
    if _e122 {
        phi_516_ = _e109;
    } else {
        phi_516_ = _e116;
    }
    let _e124 = phi_516_;
    let _e125 = (_e50.z - param_7.z);
    if (_e125 <= 0f) {
        let _e129 = ((bitcast<u32>(_e124) & 2147483647u) > 2139095040u);
        if _e129 {
        }
        phi_528_ = _e129;
    } else {
        phi_528_ = true;
    }
    let _e131 = phi_528_;
    if _e131 {
        phi_535_ = (_e124 / (_e124 + (_e125 * _e125)));
    } else {
        phi_535_ = 1f;
    }
    let _e136 = phi_535_;
    if ((bitcast<u32>(_e136) & 2147483647u) > 2139095040u) {
        phi_546_ = true;
    } else {
        let _e140 = (_e136 < _e93);
        if _e140 {
        }
        phi_546_ = _e140;
    }
    let _e142 = phi_546_;
    if _e142 {
        phi_550_ = _e136;
    } else {
        phi_550_ = _e93;
    }
    let _e144 = phi_550_;
    if ((bitcast<u32>(_e144) & 2147483647u) > 2139095040u) {
        phi_567_ = _e144;
    } else {
        if (_e144 < 0f) {
            phi_566_ = 0f;
        } else {
            if (_e144 > 1f) {
                phi_565_ = 1f;
            } else {
                phi_565_ = _e144;
            }
            let _e151 = phi_565_;
            phi_566_ = _e151;
        }
        let _e153 = phi_566_;
        phi_567_ = _e153;
    }
    let _e155 = phi_567_;
    return _e155;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_621_: bool;
    var phi_622_: bool;
    var phi_623_: bool;
    var phi_624_: bool;
    var phi_628_: bool;
    var phi_672_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_676_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_753_: bool;
    var phi_762_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_773_: bool;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_781_: bool;
    var phi_875_: f32;
    var phi_878_: f32;
    var phi_907_: f32;
    var phi_912_: f32;
    var phi_913_: bool;
    var phi_914_: f32;
    var phi_915_: bool;
    var phi_919_: f32;
    var phi_939_: f32;
    var phi_944_: f32;
    var phi_945_: bool;
    var phi_946_: f32;
    var phi_947_: bool;
    var phi_951_: f32;
    var phi_1001_: i32;
    var phi_1006_: i32;
    var phi_1011_: i32;
    var phi_1016_: i32;
    var phi_1025_: i32;
    var phi_1030_: i32;
    var phi_1035_: i32;
    var phi_1040_: i32;
    var phi_1131_: bool;
    var phi_1139_: bool;
    var phi_1151_: bool;
    var phi_1152_: bool;
    var phi_1156_: f32;
    var phi_1162_: f32;
    var phi_1164_: evaluate_Verdict;
    var phi_1169_: evaluate_Verdict;
    var phi_1170_: evaluate_Verdict;

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
                phi_621_ = (_e86 == _e88);
                phi_622_ = false;
            } else {
                phi_621_ = bool();
                phi_622_ = true;
            }
            let _e91 = phi_621_;
            let _e93 = phi_622_;
            phi_623_ = _e91;
            phi_624_ = _e93;
        } else {
            phi_623_ = bool();
            phi_624_ = true;
        }
        let _e95 = phi_623_;
        let _e97 = phi_624_;
        if _e97 {
            phi_628_ = false;
        } else {
            phi_628_ = _e95;
        }
        let _e99 = phi_628_;
        if !(_e99) {
            let _e102 = samples.member[(0u + _e64.first_primitive)].normal;
            let _e104 = samples.member[(0u + _e64.first_primitive)].position;
            if ((((_e102.x * (_e73.x - (_e104.x * _e73.w))) + (_e102.y * (_e73.y - (_e104.y * _e73.w)))) + (_e102.z * (_e73.z - (_e104.z * _e73.w)))) > 0f) {
                let _e128 = samples.member[(0u + _e64.first_primitive)].flags;
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_672_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, ((_e128 & 1u) == 0u));
            } else {
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e151.unnamed.visibility, false), _e151.unnamed_1);
                phi_672_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e157.unnamed, true);
            }
            let _e162 = phi_672_;
            phi_676_ = _e162;
        } else {
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
            phi_676_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
        }
        let _e179 = phi_676_;
        if _e179.unnamed_1 {
            phi_1170_ = evaluate_Verdict(_e179.unnamed.visibility, _e179.unnamed.is_doubted);
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
                    phi_753_ = (_e218 <= 1f);
                } else {
                    phi_753_ = false;
                }
                let _e250 = phi_753_;
                if _e250 {
                    if (_e232 >= 0f) {
                        phi_762_ = (_e232 <= 1f);
                    } else {
                        phi_762_ = false;
                    }
                    let _e254 = phi_762_;
                    if _e254 {
                        if (_e245 >= 0f) {
                            phi_771_ = (_e245 <= 1f);
                        } else {
                            phi_771_ = false;
                        }
                        let _e258 = phi_771_;
                        phi_772_ = _e258;
                        phi_773_ = false;
                    } else {
                        phi_772_ = bool();
                        phi_773_ = true;
                    }
                    let _e260 = phi_772_;
                    let _e262 = phi_773_;
                    phi_774_ = _e260;
                    phi_775_ = _e262;
                } else {
                    phi_774_ = bool();
                    phi_775_ = true;
                }
                let _e264 = phi_774_;
                let _e266 = phi_775_;
                phi_776_ = _e264;
                phi_777_ = _e266;
            } else {
                phi_776_ = bool();
                phi_777_ = true;
            }
            let _e268 = phi_776_;
            let _e270 = phi_777_;
            if _e270 {
                phi_781_ = false;
            } else {
                phi_781_ = _e268;
            }
            let _e272 = phi_781_;
            if _e272 {
                if (0f > 0f) {
                    let _e275 = samples.member[(0u + _e64.first_primitive)].normal;
                    let _e277 = p.member.map_size;
                    let _e280 = p.member.projection.row_x;
                    let _e302 = p.member.projection.row_y;
                    let _e324 = p.member.projection.row_z;
                    let _e351 = ((abs(((((_e280.x * _e275.x) + (_e280.y * _e275.y)) + (_e280.z * _e275.z)) / (((_e280.x * _e280.x) + (_e280.y * _e280.y)) + (_e280.z * _e280.z)))) + abs(((((_e302.x * _e275.x) + (_e302.y * _e275.y)) + (_e302.z * _e275.z)) / (((_e302.x * _e302.x) + (_e302.y * _e302.y)) + (_e302.z * _e302.z))))) / (abs(((((_e324.x * _e275.x) + (_e324.y * _e275.y)) + (_e324.z * _e275.z)) / (((_e324.x * _e324.x) + (_e324.y * _e324.y)) + (_e324.z * _e324.z)))) * f32(_e277)));
                    if (_e351 < 0.002f) {
                        phi_875_ = _e351;
                    } else {
                        phi_875_ = 0.002f;
                    }
                    let _e354 = phi_875_;
                    phi_878_ = (_e245 - (0f * _e354));
                } else {
                    phi_878_ = _e245;
                }
                let _e358 = phi_878_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e218 * _e361) - 0.5f);
                let _e365 = ((_e232 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_907_ = 1f;
                    } else {
                        phi_907_ = 0f;
                    }
                    let _e380 = phi_907_;
                    if (_e364 < 8388608f) {
                        phi_912_ = (_e377 - _e380);
                        phi_913_ = false;
                    } else {
                        phi_912_ = f32();
                        phi_913_ = true;
                    }
                    let _e383 = phi_912_;
                    let _e385 = phi_913_;
                    phi_914_ = _e383;
                    phi_915_ = _e385;
                } else {
                    phi_914_ = f32();
                    phi_915_ = true;
                }
                let _e387 = phi_914_;
                let _e389 = phi_915_;
                if _e389 {
                    phi_919_ = _e364;
                } else {
                    phi_919_ = _e387;
                }
                let _e391 = phi_919_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_939_ = 1f;
                    } else {
                        phi_939_ = 0f;
                    }
                    let _e406 = phi_939_;
                    if (_e365 < 8388608f) {
                        phi_944_ = (_e403 - _e406);
                        phi_945_ = false;
                    } else {
                        phi_944_ = f32();
                        phi_945_ = true;
                    }
                    let _e409 = phi_944_;
                    let _e411 = phi_945_;
                    phi_946_ = _e409;
                    phi_947_ = _e411;
                } else {
                    phi_946_ = f32();
                    phi_947_ = true;
                }
                let _e413 = phi_946_;
                let _e415 = phi_947_;
                if _e415 {
                    phi_951_ = _e365;
                } else {
                    phi_951_ = _e413;
                }
                let _e417 = phi_951_;
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
                    phi_1001_ = _e428;
                } else {
                    phi_1001_ = 0i;
                }
                let _e459 = phi_1001_;
                if (_e437 > 0i) {
                    phi_1006_ = _e437;
                } else {
                    phi_1006_ = 0i;
                }
                let _e462 = phi_1006_;
                if (_e459 < _e456) {
                    phi_1011_ = _e459;
                } else {
                    phi_1011_ = _e456;
                }
                let _e465 = phi_1011_;
                if (_e462 < _e456) {
                    phi_1016_ = _e462;
                } else {
                    phi_1016_ = _e456;
                }
                let _e468 = phi_1016_;
                let _e469 = bitcast<u32>(_e465);
                let _e471 = (_e428 + 1i);
                let _e472 = (_e437 + 1i);
                if (_e471 > 0i) {
                    phi_1025_ = _e471;
                } else {
                    phi_1025_ = 0i;
                }
                let _e475 = phi_1025_;
                if (_e472 > 0i) {
                    phi_1030_ = _e472;
                } else {
                    phi_1030_ = 0i;
                }
                let _e478 = phi_1030_;
                if (_e475 < _e456) {
                    phi_1035_ = _e475;
                } else {
                    phi_1035_ = _e456;
                }
                let _e481 = phi_1035_;
                if (_e478 < _e456) {
                    phi_1040_ = _e478;
                } else {
                    phi_1040_ = _e456;
                }
                let _e484 = phi_1040_;
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
                let _e556 = p.member.epsilon;
                if (_e554 <= _e556) {
                    phi_1131_ = true;
                } else {
                    phi_1131_ = (_e554 >= (1f - _e556));
                }
                let _e561 = phi_1131_;
                if ((bitcast<u32>(_e554) & 2147483647u) > 2139095040u) {
                    phi_1139_ = true;
                } else {
                    phi_1139_ = !(_e561);
                }
                let _e567 = phi_1139_;
                if _e567 {
                    if (_e554 > 0f) {
                        if (_e554 < 1f) {
                            phi_1151_ = false;
                        } else {
                            phi_1151_ = true;
                        }
                        let _e571 = phi_1151_;
                        phi_1152_ = _e571;
                    } else {
                        phi_1152_ = true;
                    }
                    let _e573 = phi_1152_;
                    if _e573 {
                        phi_1156_ = 0.5f;
                    } else {
                        phi_1156_ = _e554;
                    }
                    let _e575 = phi_1156_;
                    phi_1164_ = evaluate_Verdict(_e575, true);
                } else {
                    if (_e554 > 0.5f) {
                        phi_1162_ = 1f;
                    } else {
                        phi_1162_ = 0f;
                    }
                    let _e579 = phi_1162_;
                    phi_1164_ = evaluate_Verdict(_e579, false);
                }
                let _e582 = phi_1164_;
                phi_1169_ = evaluate_Verdict(_e582.visibility, _e582.is_doubted);
            } else {
                phi_1169_ = evaluate_Verdict(0.5f, true);
            }
            let _e588 = phi_1169_;
            phi_1170_ = _e588;
        }
        let _e590 = phi_1170_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e590.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
