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
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_33 {
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
var<uniform> p: type_33;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(2) 
var<storage> map: type_29;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_151_: lt_bvh_traverse_Tree;
    var phi_152_: bool;
    var phi_157_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_149_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_150_ = false;
        } else {
            phi_149_ = lt_bvh_traverse_Tree();
            phi_150_ = true;
        }
        let _e60 = phi_149_;
        let _e62 = phi_150_;
        phi_151_ = _e60;
        phi_152_ = _e62;
    } else {
        phi_151_ = lt_bvh_traverse_Tree();
        phi_152_ = true;
    }
    let _e64 = phi_151_;
    let _e66 = phi_152_;
    if _e66 {
        phi_157_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_157_ = _e64;
    }
    let _e71 = phi_157_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_184_: f32;
    var phi_185_: f32;
    var phi_186_: f32;
    var phi_199_: bool;
    var phi_203_: f32;
    var phi_215_: f32;
    var phi_220_: f32;
    var phi_242_: f32;
    var phi_247_: f32;
    var phi_248_: bool;
    var phi_249_: f32;
    var phi_250_: bool;
    var phi_254_: f32;
    var phi_292_: f32;
    var phi_305_: bool;
    var phi_309_: f32;
    var phi_322_: f32;
    var phi_327_: f32;
    var phi_349_: f32;
    var phi_354_: f32;
    var phi_355_: bool;
    var phi_356_: f32;
    var phi_357_: bool;
    var phi_361_: f32;
    var phi_399_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_186_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_185_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_184_ = 1f;
            } else {
                phi_184_ = param_5;
            }
            let _e55 = phi_184_;
            phi_185_ = _e55;
        }
        let _e57 = phi_185_;
        phi_186_ = _e57;
    }
    let _e59 = phi_186_;
    let _e61 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_199_ = true;
    } else {
        let _e65 = (42f < _e61);
        if _e65 {
        }
        phi_199_ = _e65;
    }
    let _e67 = phi_199_;
    if _e67 {
        phi_203_ = 42f;
    } else {
        phi_203_ = _e61;
    }
    let _e69 = phi_203_;
    let _e70 = (_e69 * _e59);
    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
        phi_292_ = _e70;
    } else {
        if (_e70 < -87f) {
            phi_215_ = -87f;
        } else {
            phi_215_ = _e70;
        }
        let _e76 = phi_215_;
        if (_e76 > 88f) {
            phi_220_ = 88f;
        } else {
            phi_220_ = _e76;
        }
        let _e79 = phi_220_;
        let _e81 = ((_e79 * 1.442695f) + 0.5f);
        if (_e81 > -8388608f) {
            let _e93 = f32(select(0i, select(select(i32(_e81), i32(-2147483648), (_e81 < bitcast<f32>(3472883712u))), 2147483647i, (_e81 > bitcast<f32>(1325400063u))), (_e81 == _e81)));
            if (_e93 > _e81) {
                phi_242_ = 1f;
            } else {
                phi_242_ = 0f;
            }
            let _e96 = phi_242_;
            if (_e81 < 8388608f) {
                phi_247_ = (_e93 - _e96);
                phi_248_ = false;
            } else {
                phi_247_ = f32();
                phi_248_ = true;
            }
            let _e99 = phi_247_;
            let _e101 = phi_248_;
            phi_249_ = _e99;
            phi_250_ = _e101;
        } else {
            phi_249_ = f32();
            phi_250_ = true;
        }
        let _e103 = phi_249_;
        let _e105 = phi_250_;
        if _e105 {
            phi_254_ = _e81;
        } else {
            phi_254_ = _e103;
        }
        let _e107 = phi_254_;
        let _e111 = ((_e79 - (_e107 * 0.69314575f)) - (_e107 * 0.0000014286068f));
        phi_292_ = ((((((((((((((((1f / 5040f) * _e111) + (1f / 720f)) * _e111) + (1f / 120f)) * _e111) + (1f / 24f)) * _e111) + (1f / 6f)) * _e111) + 0.5f) * _e111) + 1f) * _e111) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e107), i32(-2147483648), (_e107 < bitcast<f32>(3472883712u))), 2147483647i, (_e107 > bitcast<f32>(1325400063u))), (_e107 == _e107)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e147 = phi_292_;
    let _e149 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_305_ = true;
    } else {
        let _e153 = (42f < _e149);
        if _e153 {
        }
        phi_305_ = _e153;
    }
    let _e155 = phi_305_;
    if _e155 {
        phi_309_ = 42f;
    } else {
        phi_309_ = _e149;
    }
    let _e157 = phi_309_;
    let _e159 = (-(_e157) * _e59);
    if ((bitcast<u32>(_e159) & 2147483647u) > 2139095040u) {
        phi_399_ = _e159;
    } else {
        if (_e159 < -87f) {
            phi_322_ = -87f;
        } else {
            phi_322_ = _e159;
        }
        let _e165 = phi_322_;
        if (_e165 > 88f) {
            phi_327_ = 88f;
        } else {
            phi_327_ = _e165;
        }
        let _e168 = phi_327_;
        let _e170 = ((_e168 * 1.442695f) + 0.5f);
        if (_e170 > -8388608f) {
            let _e182 = f32(select(0i, select(select(i32(_e170), i32(-2147483648), (_e170 < bitcast<f32>(3472883712u))), 2147483647i, (_e170 > bitcast<f32>(1325400063u))), (_e170 == _e170)));
            if (_e182 > _e170) {
                phi_349_ = 1f;
            } else {
                phi_349_ = 0f;
            }
            let _e185 = phi_349_;
            if (_e170 < 8388608f) {
                phi_354_ = (_e182 - _e185);
                phi_355_ = false;
            } else {
                phi_354_ = f32();
                phi_355_ = true;
            }
            let _e188 = phi_354_;
            let _e190 = phi_355_;
            phi_356_ = _e188;
            phi_357_ = _e190;
        } else {
            phi_356_ = f32();
            phi_357_ = true;
        }
        let _e192 = phi_356_;
        let _e194 = phi_357_;
        if _e194 {
            phi_361_ = _e170;
        } else {
            phi_361_ = _e192;
        }
        let _e196 = phi_361_;
        let _e200 = ((_e168 - (_e196 * 0.69314575f)) - (_e196 * 0.0000014286068f));
        phi_399_ = ((((((((((((((((1f / 5040f) * _e200) + (1f / 720f)) * _e200) + (1f / 120f)) * _e200) + (1f / 24f)) * _e200) + (1f / 6f)) * _e200) + 0.5f) * _e200) + 1f) * _e200) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e196), i32(-2147483648), (_e196 < bitcast<f32>(3472883712u))), 2147483647i, (_e196 > bitcast<f32>(1325400063u))), (_e196 == _e196)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e236 = phi_399_;
    let _e237 = -(_e236);
    return vec4<f32>(_e147, (_e147 * _e147), _e237, (_e237 * _e237));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_421_: bool;
    var phi_425_: f32;
    var phi_449_: bool;
    var phi_453_: f32;
    var phi_465_: bool;
    var phi_472_: f32;
    var phi_485_: bool;
    var phi_489_: f32;
    var phi_513_: bool;
    var phi_517_: f32;
    var phi_529_: bool;
    var phi_536_: f32;
    var phi_547_: bool;
    var phi_551_: f32;
    var phi_566_: f32;
    var phi_567_: f32;
    var phi_568_: f32;

    let _e50 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e52 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_421_ = true;
    } else {
        let _e56 = (42f < _e52);
        if _e56 {
        }
        phi_421_ = _e56;
    }
    let _e58 = phi_421_;
    if _e58 {
        phi_425_ = 42f;
    } else {
        phi_425_ = _e52;
    }
    let _e60 = phi_425_;
    let _e62 = (*param_6).min_variance;
    let _e66 = (((_e62 * _e60) * _e60) * _e50.y);
    let _e73 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u) {
        phi_449_ = true;
    } else {
        let _e77 = (_e66 > _e73);
        if _e77 {
        }
        phi_449_ = _e77;
    }
    let _e79 = phi_449_;
    if _e79 {
        phi_453_ = _e66;
    } else {
        phi_453_ = _e73;
    }
    let _e81 = phi_453_;
    let _e82 = (_e50.x - param_7.x);
    if (_e82 <= 0f) {
        let _e86 = ((bitcast<u32>(_e81) & 2147483647u) > 2139095040u);
        if _e86 {
        }
        phi_465_ = _e86;
    } else {
        phi_465_ = true;
    }
    let _e88 = phi_465_;
    if _e88 {
        phi_472_ = (_e81 / (_e81 + (_e82 * _e82)));
    } else {
        phi_472_ = 1f;
    }
    let _e93 = phi_472_;
    let _e95 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_485_ = true;
    } else {
        let _e99 = (42f < _e95);
        if _e99 {
        }
        phi_485_ = _e99;
    }
    let _e101 = phi_485_;
    if _e101 {
        phi_489_ = 42f;
    } else {
        phi_489_ = _e95;
    }
    let _e103 = phi_489_;
    let _e105 = (*param_6).min_variance;
    let _e109 = (((_e105 * _e103) * _e103) * _e50.w);
    let _e116 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
        phi_513_ = true;
    } else {
        let _e120 = (_e109 > _e116);
        if _e120 {
        }
        phi_513_ = _e120;
    }
    let _e122 = phi_513_;
    if _e122 {
        phi_517_ = _e109;
    } else {
        phi_517_ = _e116;
    }
    let _e124 = phi_517_;
    let _e125 = (_e50.z - param_7.z);
    if (_e125 <= 0f) {
        let _e129 = ((bitcast<u32>(_e124) & 2147483647u) > 2139095040u);
        if _e129 {
        }
        phi_529_ = _e129;
    } else {
        phi_529_ = true;
    }
    let _e131 = phi_529_;
    if _e131 {
        phi_536_ = (_e124 / (_e124 + (_e125 * _e125)));
    } else {
        phi_536_ = 1f;
    }
    let _e136 = phi_536_;
    if ((bitcast<u32>(_e136) & 2147483647u) > 2139095040u) {
        phi_547_ = true;
    } else {
        let _e140 = (_e136 < _e93);
        if _e140 {
        }
        phi_547_ = _e140;
    }
    let _e142 = phi_547_;
    if _e142 {
        phi_551_ = _e136;
    } else {
        phi_551_ = _e93;
    }
    let _e144 = phi_551_;
    if ((bitcast<u32>(_e144) & 2147483647u) > 2139095040u) {
        phi_568_ = _e144;
    } else {
        if (_e144 < 0f) {
            phi_567_ = 0f;
        } else {
            if (_e144 > 1f) {
                phi_566_ = 1f;
            } else {
                phi_566_ = _e144;
            }
            let _e151 = phi_566_;
            phi_567_ = _e151;
        }
        let _e153 = phi_567_;
        phi_568_ = _e153;
    }
    let _e155 = phi_568_;
    return _e155;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_625_: bool;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_628_: bool;
    var phi_632_: bool;
    var phi_676_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_680_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_754_: bool;
    var phi_763_: bool;
    var phi_772_: bool;
    var phi_773_: bool;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_778_: bool;
    var phi_782_: bool;
    var phi_872_: f32;
    var phi_875_: f32;
    var phi_904_: f32;
    var phi_909_: f32;
    var phi_910_: bool;
    var phi_911_: f32;
    var phi_912_: bool;
    var phi_916_: f32;
    var phi_936_: f32;
    var phi_941_: f32;
    var phi_942_: bool;
    var phi_943_: f32;
    var phi_944_: bool;
    var phi_948_: f32;
    var phi_1000_: i32;
    var phi_1005_: i32;
    var phi_1010_: i32;
    var phi_1015_: i32;
    var phi_1024_: i32;
    var phi_1029_: i32;
    var phi_1034_: i32;
    var phi_1039_: i32;
    var phi_1134_: bool;
    var phi_1142_: bool;
    var phi_1154_: bool;
    var phi_1155_: bool;
    var phi_1159_: f32;
    var phi_1165_: f32;
    var phi_1167_: evaluate_Verdict;
    var phi_1172_: evaluate_Verdict;
    var phi_1173_: evaluate_Verdict;

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
                phi_625_ = (_e89 == _e91);
                phi_626_ = false;
            } else {
                phi_625_ = bool();
                phi_626_ = true;
            }
            let _e94 = phi_625_;
            let _e96 = phi_626_;
            phi_627_ = _e94;
            phi_628_ = _e96;
        } else {
            phi_627_ = bool();
            phi_628_ = true;
        }
        let _e98 = phi_627_;
        let _e100 = phi_628_;
        if _e100 {
            phi_632_ = false;
        } else {
            phi_632_ = _e98;
        }
        let _e102 = phi_632_;
        if !(_e102) {
            let _e105 = samples.member[(0u + _e64.first_primitive)].normal;
            let _e107 = samples.member[(0u + _e64.first_primitive)].position;
            if ((((_e105.x * (_e76.x - (_e107.x * _e76.w))) + (_e105.y * (_e76.y - (_e107.y * _e76.w)))) + (_e105.z * (_e76.z - (_e107.z * _e76.w)))) > 0f) {
                let _e131 = samples.member[(0u + _e64.first_primitive)].flags;
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e139.unnamed.visibility, false), _e139.unnamed_1);
                phi_676_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e145.unnamed, ((_e131 & 1u) == 0u));
            } else {
                let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
                phi_676_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
            }
            let _e165 = phi_676_;
            phi_680_ = _e165;
        } else {
            let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e171.unnamed.visibility, false), _e171.unnamed_1);
            phi_680_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e177.unnamed, true);
        }
        let _e182 = phi_680_;
        if _e182.unnamed_1 {
            phi_1173_ = evaluate_Verdict(_e182.unnamed.visibility, _e182.unnamed.is_doubted);
        } else {
            let _e190 = samples.member[(0u + _e64.first_primitive)].position;
            let _e208 = ((((_e74.projection.row_w.x * _e190.x) + (_e74.projection.row_w.y * _e190.y)) + (_e74.projection.row_w.z * _e190.z)) + (_e74.projection.row_w.w * 1f));
            let _e222 = (((((_e74.projection.row_x.x * _e190.x) + (_e74.projection.row_x.y * _e190.y)) + (_e74.projection.row_x.z * _e190.z)) + (_e74.projection.row_x.w * 1f)) / _e208);
            let _e236 = (((((_e74.projection.row_y.x * _e190.x) + (_e74.projection.row_y.y * _e190.y)) + (_e74.projection.row_y.z * _e190.z)) + (_e74.projection.row_y.w * 1f)) / _e208);
            let _e249 = ((((_e74.projection.row_z.x * _e190.x) + (_e74.projection.row_z.y * _e190.y)) + (_e74.projection.row_z.z * _e190.z)) + (_e74.projection.row_z.w * 1f));
            if (_e208 > 0f) {
                if (_e222 >= 0f) {
                    phi_754_ = (_e222 <= 1f);
                } else {
                    phi_754_ = false;
                }
                let _e254 = phi_754_;
                if _e254 {
                    if (_e236 >= 0f) {
                        phi_763_ = (_e236 <= 1f);
                    } else {
                        phi_763_ = false;
                    }
                    let _e258 = phi_763_;
                    if _e258 {
                        if (_e249 >= 0f) {
                            phi_772_ = (_e249 <= 1f);
                        } else {
                            phi_772_ = false;
                        }
                        let _e262 = phi_772_;
                        phi_773_ = _e262;
                        phi_774_ = false;
                    } else {
                        phi_773_ = bool();
                        phi_774_ = true;
                    }
                    let _e264 = phi_773_;
                    let _e266 = phi_774_;
                    phi_775_ = _e264;
                    phi_776_ = _e266;
                } else {
                    phi_775_ = bool();
                    phi_776_ = true;
                }
                let _e268 = phi_775_;
                let _e270 = phi_776_;
                phi_777_ = _e268;
                phi_778_ = _e270;
            } else {
                phi_777_ = bool();
                phi_778_ = true;
            }
            let _e272 = phi_777_;
            let _e274 = phi_778_;
            if _e274 {
                phi_782_ = false;
            } else {
                phi_782_ = _e272;
            }
            let _e276 = phi_782_;
            if _e276 {
                if (0f > 0f) {
                    let _e279 = samples.member[(0u + _e64.first_primitive)].normal;
                    let _e281 = p.member.map_size;
                    let _e351 = ((abs(((((_e70.row_x.x * _e279.x) + (_e70.row_x.y * _e279.y)) + (_e70.row_x.z * _e279.z)) / (((_e70.row_x.x * _e70.row_x.x) + (_e70.row_x.y * _e70.row_x.y)) + (_e70.row_x.z * _e70.row_x.z)))) + abs(((((_e70.row_y.x * _e279.x) + (_e70.row_y.y * _e279.y)) + (_e70.row_y.z * _e279.z)) / (((_e70.row_y.x * _e70.row_y.x) + (_e70.row_y.y * _e70.row_y.y)) + (_e70.row_y.z * _e70.row_y.z))))) / (abs(((((_e70.row_z.x * _e279.x) + (_e70.row_z.y * _e279.y)) + (_e70.row_z.z * _e279.z)) / (((_e70.row_z.x * _e70.row_z.x) + (_e70.row_z.y * _e70.row_z.y)) + (_e70.row_z.z * _e70.row_z.z)))) * f32(_e281)));
                    if (_e351 < 0.002f) {
                        phi_872_ = _e351;
                    } else {
                        phi_872_ = 0.002f;
                    }
                    let _e354 = phi_872_;
                    phi_875_ = (_e249 - (0f * _e354));
                } else {
                    phi_875_ = _e249;
                }
                let _e358 = phi_875_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e222 * _e361) - 0.5f);
                let _e365 = ((_e236 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_904_ = 1f;
                    } else {
                        phi_904_ = 0f;
                    }
                    let _e380 = phi_904_;
                    if (_e364 < 8388608f) {
                        phi_909_ = (_e377 - _e380);
                        phi_910_ = false;
                    } else {
                        phi_909_ = f32();
                        phi_910_ = true;
                    }
                    let _e383 = phi_909_;
                    let _e385 = phi_910_;
                    phi_911_ = _e383;
                    phi_912_ = _e385;
                } else {
                    phi_911_ = f32();
                    phi_912_ = true;
                }
                let _e387 = phi_911_;
                let _e389 = phi_912_;
                if _e389 {
                    phi_916_ = _e364;
                } else {
                    phi_916_ = _e387;
                }
                let _e391 = phi_916_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_936_ = 1f;
                    } else {
                        phi_936_ = 0f;
                    }
                    let _e406 = phi_936_;
                    if (_e365 < 8388608f) {
                        phi_941_ = (_e403 - _e406);
                        phi_942_ = false;
                    } else {
                        phi_941_ = f32();
                        phi_942_ = true;
                    }
                    let _e409 = phi_941_;
                    let _e411 = phi_942_;
                    phi_943_ = _e409;
                    phi_944_ = _e411;
                } else {
                    phi_943_ = f32();
                    phi_944_ = true;
                }
                let _e413 = phi_943_;
                let _e415 = phi_944_;
                if _e415 {
                    phi_948_ = _e365;
                } else {
                    phi_948_ = _e413;
                }
                let _e417 = phi_948_;
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
                    phi_1000_ = _e428;
                } else {
                    phi_1000_ = 0i;
                }
                let _e461 = phi_1000_;
                if (_e437 > 0i) {
                    phi_1005_ = _e437;
                } else {
                    phi_1005_ = 0i;
                }
                let _e464 = phi_1005_;
                if (_e461 < _e458) {
                    phi_1010_ = _e461;
                } else {
                    phi_1010_ = _e458;
                }
                let _e467 = phi_1010_;
                if (_e464 < _e458) {
                    phi_1015_ = _e464;
                } else {
                    phi_1015_ = _e458;
                }
                let _e470 = phi_1015_;
                let _e471 = bitcast<u32>(_e467);
                let _e473 = (_e428 + 1i);
                let _e474 = (_e437 + 1i);
                if (_e473 > 0i) {
                    phi_1024_ = _e473;
                } else {
                    phi_1024_ = 0i;
                }
                let _e477 = phi_1024_;
                if (_e474 > 0i) {
                    phi_1029_ = _e474;
                } else {
                    phi_1029_ = 0i;
                }
                let _e480 = phi_1029_;
                if (_e477 < _e458) {
                    phi_1034_ = _e477;
                } else {
                    phi_1034_ = _e458;
                }
                let _e483 = phi_1034_;
                if (_e480 < _e458) {
                    phi_1039_ = _e480;
                } else {
                    phi_1039_ = _e458;
                }
                let _e486 = phi_1039_;
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
                let _e562 = p.member.epsilon;
                if (_e560 <= _e562) {
                    phi_1134_ = true;
                } else {
                    phi_1134_ = (_e560 >= (1f - _e562));
                }
                let _e567 = phi_1134_;
                if ((bitcast<u32>(_e560) & 2147483647u) > 2139095040u) {
                    phi_1142_ = true;
                } else {
                    phi_1142_ = !(_e567);
                }
                let _e573 = phi_1142_;
                if _e573 {
                    if (_e560 > 0f) {
                        if (_e560 < 1f) {
                            phi_1154_ = false;
                        } else {
                            phi_1154_ = true;
                        }
                        let _e577 = phi_1154_;
                        phi_1155_ = _e577;
                    } else {
                        phi_1155_ = true;
                    }
                    let _e579 = phi_1155_;
                    if _e579 {
                        phi_1159_ = 0.5f;
                    } else {
                        phi_1159_ = _e560;
                    }
                    let _e581 = phi_1159_;
                    phi_1167_ = evaluate_Verdict(_e581, true);
                } else {
                    if (_e560 > 0.5f) {
                        phi_1165_ = 1f;
                    } else {
                        phi_1165_ = 0f;
                    }
                    let _e585 = phi_1165_;
                    phi_1167_ = evaluate_Verdict(_e585, false);
                }
                let _e588 = phi_1167_;
                phi_1172_ = evaluate_Verdict(_e588.visibility, _e588.is_doubted);
            } else {
                phi_1172_ = evaluate_Verdict(0.5f, true);
            }
            let _e594 = phi_1172_;
            phi_1173_ = _e594;
        }
        let _e596 = phi_1173_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e596.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
