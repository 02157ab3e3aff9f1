struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_15 {
    member: array<abi_Sample>,
}

struct type_19 {
    member: array<f32>,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct type_31 {
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
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    pad0_: u32,
    pad1_: u32,
}

struct type_35 {
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
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_153_: lt_bvh_traverse_Tree;
    var phi_154_: bool;
    var phi_155_: lt_bvh_traverse_Tree;
    var phi_156_: bool;
    var phi_161_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_153_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_154_ = false;
        } else {
            phi_153_ = lt_bvh_traverse_Tree();
            phi_154_ = true;
        }
        let _e60 = phi_153_;
        let _e62 = phi_154_;
        phi_155_ = _e60;
        phi_156_ = _e62;
    } else {
        phi_155_ = lt_bvh_traverse_Tree();
        phi_156_ = true;
    }
    let _e64 = phi_155_;
    let _e66 = phi_156_;
    if _e66 {
        phi_161_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_161_ = _e64;
    }
    let _e71 = phi_161_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_188_: f32;
    var phi_189_: f32;
    var phi_190_: f32;
    var phi_203_: bool;
    var phi_207_: f32;
    var phi_219_: f32;
    var phi_224_: f32;
    var phi_246_: f32;
    var phi_251_: f32;
    var phi_252_: bool;
    var phi_253_: f32;
    var phi_254_: bool;
    var phi_258_: f32;
    var phi_296_: f32;
    var phi_309_: bool;
    var phi_313_: f32;
    var phi_326_: f32;
    var phi_331_: f32;
    var phi_353_: f32;
    var phi_358_: f32;
    var phi_359_: bool;
    var phi_360_: f32;
    var phi_361_: bool;
    var phi_365_: f32;
    var phi_403_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_190_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_189_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_188_ = 1f;
            } else {
                phi_188_ = param_5;
            }
            let _e55 = phi_188_;
            phi_189_ = _e55;
        }
        let _e57 = phi_189_;
        phi_190_ = _e57;
    }
    let _e59 = phi_190_;
    let _e61 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_203_ = true;
    } else {
        let _e65 = (42f < _e61);
        if _e65 {
        }
        phi_203_ = _e65;
    }
    let _e67 = phi_203_;
    if _e67 {
        phi_207_ = 42f;
    } else {
        phi_207_ = _e61;
    }
    let _e69 = phi_207_;
    let _e70 = (_e69 * _e59);
    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
        phi_296_ = _e70;
    } else {
        if (_e70 < -87f) {
            phi_219_ = -87f;
        } else {
            phi_219_ = _e70;
        }
        let _e76 = phi_219_;
        if (_e76 > 88f) {
            phi_224_ = 88f;
        } else {
            phi_224_ = _e76;
        }
        let _e79 = phi_224_;
        let _e81 = ((_e79 * 1.442695f) + 0.5f);
        if (_e81 > -8388608f) {
            let _e93 = f32(select(0i, select(select(i32(_e81), i32(-2147483648), (_e81 < bitcast<f32>(3472883712u))), 2147483647i, (_e81 > bitcast<f32>(1325400063u))), (_e81 == _e81)));
            if (_e93 > _e81) {
                phi_246_ = 1f;
            } else {
                phi_246_ = 0f;
            }
            let _e96 = phi_246_;
            if (_e81 < 8388608f) {
                phi_251_ = (_e93 - _e96);
                phi_252_ = false;
            } else {
                phi_251_ = f32();
                phi_252_ = true;
            }
            let _e99 = phi_251_;
            let _e101 = phi_252_;
            phi_253_ = _e99;
            phi_254_ = _e101;
        } else {
            phi_253_ = f32();
            phi_254_ = true;
        }
        let _e103 = phi_253_;
        let _e105 = phi_254_;
        if _e105 {
            phi_258_ = _e81;
        } else {
            phi_258_ = _e103;
        }
        let _e107 = phi_258_;
        let _e111 = ((_e79 - (_e107 * 0.69314575f)) - (_e107 * 0.0000014286068f));
        phi_296_ = ((((((((((((((((1f / 5040f) * _e111) + (1f / 720f)) * _e111) + (1f / 120f)) * _e111) + (1f / 24f)) * _e111) + (1f / 6f)) * _e111) + 0.5f) * _e111) + 1f) * _e111) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e107), i32(-2147483648), (_e107 < bitcast<f32>(3472883712u))), 2147483647i, (_e107 > bitcast<f32>(1325400063u))), (_e107 == _e107)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e147 = phi_296_;
    let _e149 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_309_ = true;
    } else {
        let _e153 = (42f < _e149);
        if _e153 {
        }
        phi_309_ = _e153;
    }
    let _e155 = phi_309_;
    if _e155 {
        phi_313_ = 42f;
    } else {
        phi_313_ = _e149;
    }
    let _e157 = phi_313_;
    let _e159 = (-(_e157) * _e59);
    if ((bitcast<u32>(_e159) & 2147483647u) > 2139095040u) {
        phi_403_ = _e159;
    } else {
        if (_e159 < -87f) {
            phi_326_ = -87f;
        } else {
            phi_326_ = _e159;
        }
        let _e165 = phi_326_;
        if (_e165 > 88f) {
            phi_331_ = 88f;
        } else {
            phi_331_ = _e165;
        }
        let _e168 = phi_331_;
        let _e170 = ((_e168 * 1.442695f) + 0.5f);
        if (_e170 > -8388608f) {
            let _e182 = f32(select(0i, select(select(i32(_e170), i32(-2147483648), (_e170 < bitcast<f32>(3472883712u))), 2147483647i, (_e170 > bitcast<f32>(1325400063u))), (_e170 == _e170)));
            if (_e182 > _e170) {
                phi_353_ = 1f;
            } else {
                phi_353_ = 0f;
            }
            let _e185 = phi_353_;
            if (_e170 < 8388608f) {
                phi_358_ = (_e182 - _e185);
                phi_359_ = false;
            } else {
                phi_358_ = f32();
                phi_359_ = true;
            }
            let _e188 = phi_358_;
            let _e190 = phi_359_;
            phi_360_ = _e188;
            phi_361_ = _e190;
        } else {
            phi_360_ = f32();
            phi_361_ = true;
        }
        let _e192 = phi_360_;
        let _e194 = phi_361_;
        if _e194 {
            phi_365_ = _e170;
        } else {
            phi_365_ = _e192;
        }
        let _e196 = phi_365_;
        let _e200 = ((_e168 - (_e196 * 0.69314575f)) - (_e196 * 0.0000014286068f));
        phi_403_ = ((((((((((((((((1f / 5040f) * _e200) + (1f / 720f)) * _e200) + (1f / 120f)) * _e200) + (1f / 24f)) * _e200) + (1f / 6f)) * _e200) + 0.5f) * _e200) + 1f) * _e200) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e196), i32(-2147483648), (_e196 < bitcast<f32>(3472883712u))), 2147483647i, (_e196 > bitcast<f32>(1325400063u))), (_e196 == _e196)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e236 = phi_403_;
    let _e237 = -(_e236);
    return vec4<f32>(_e147, (_e147 * _e147), _e237, (_e237 * _e237));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_425_: bool;
    var phi_429_: f32;
    var phi_453_: bool;
    var phi_457_: f32;
    var phi_469_: bool;
    var phi_476_: f32;
    var phi_489_: bool;
    var phi_493_: f32;
    var phi_517_: bool;
    var phi_521_: f32;
    var phi_533_: bool;
    var phi_540_: f32;
    var phi_551_: bool;
    var phi_555_: f32;
    var phi_570_: f32;
    var phi_571_: f32;
    var phi_572_: f32;

    let _e50 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e52 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_425_ = true;
    } else {
        let _e56 = (42f < _e52);
        if _e56 {
        }
        phi_425_ = _e56;
    }
    let _e58 = phi_425_;
    if _e58 {
        phi_429_ = 42f;
    } else {
        phi_429_ = _e52;
    }
    let _e60 = phi_429_;
    let _e62 = (*param_6).min_variance;
    let _e66 = (((_e62 * _e60) * _e60) * _e50.y);
    let _e73 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u) {
        phi_453_ = true;
    } else {
        let _e77 = (_e66 > _e73);
        if _e77 {
        }
        phi_453_ = _e77;
    }
    let _e79 = phi_453_;
    if _e79 {
        phi_457_ = _e66;
    } else {
        phi_457_ = _e73;
    }
    let _e81 = phi_457_;
    let _e82 = (_e50.x - param_7.x);
    if (_e82 <= 0f) {
        let _e86 = ((bitcast<u32>(_e81) & 2147483647u) > 2139095040u);
        if _e86 {
        }
        phi_469_ = _e86;
    } else {
        phi_469_ = true;
    }
    let _e88 = phi_469_;
    if _e88 {
        phi_476_ = (_e81 / (_e81 + (_e82 * _e82)));
    } else {
        phi_476_ = 1f;
    }
    let _e93 = phi_476_;
    let _e95 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_489_ = true;
    } else {
        let _e99 = (42f < _e95);
        if _e99 {
        }
        phi_489_ = _e99;
    }
    let _e101 = phi_489_;
    if _e101 {
        phi_493_ = 42f;
    } else {
        phi_493_ = _e95;
    }
    let _e103 = phi_493_;
    let _e105 = (*param_6).min_variance;
    let _e109 = (((_e105 * _e103) * _e103) * _e50.w);
    let _e116 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
        phi_517_ = true;
    } else {
        let _e120 = (_e109 > _e116);
        if _e120 {
        }
        phi_517_ = _e120;
    }
    let _e122 = phi_517_;
    if _e122 {
        phi_521_ = _e109;
    } else {
        phi_521_ = _e116;
    }
    let _e124 = phi_521_;
    let _e125 = (_e50.z - param_7.z);
    if (_e125 <= 0f) {
        let _e129 = ((bitcast<u32>(_e124) & 2147483647u) > 2139095040u);
        if _e129 {
        }
        phi_533_ = _e129;
    } else {
        phi_533_ = true;
    }
    let _e131 = phi_533_;
    if _e131 {
        phi_540_ = (_e124 / (_e124 + (_e125 * _e125)));
    } else {
        phi_540_ = 1f;
    }
    let _e136 = phi_540_;
    if ((bitcast<u32>(_e136) & 2147483647u) > 2139095040u) {
        phi_551_ = true;
    } else {
        let _e140 = (_e136 < _e93);
        if _e140 {
        }
        phi_551_ = _e140;
    }
    let _e142 = phi_551_;
    if _e142 {
        phi_555_ = _e136;
    } else {
        phi_555_ = _e93;
    }
    let _e144 = phi_555_;
    if ((bitcast<u32>(_e144) & 2147483647u) > 2139095040u) {
        phi_572_ = _e144;
    } else {
        if (_e144 < 0f) {
            phi_571_ = 0f;
        } else {
            if (_e144 > 1f) {
                phi_570_ = 1f;
            } else {
                phi_570_ = _e144;
            }
            let _e151 = phi_570_;
            phi_571_ = _e151;
        }
        let _e153 = phi_571_;
        phi_572_ = _e153;
    }
    let _e155 = phi_572_;
    return _e155;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_628_: bool;
    var phi_629_: bool;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_635_: bool;
    var phi_705_: bool;
    var phi_706_: bool;
    var phi_717_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_718_: bool;
    var phi_719_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_720_: bool;
    var phi_727_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_731_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_805_: bool;
    var phi_814_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_833_: bool;
    var phi_923_: f32;
    var phi_926_: f32;
    var phi_955_: f32;
    var phi_960_: f32;
    var phi_961_: bool;
    var phi_962_: f32;
    var phi_963_: bool;
    var phi_967_: f32;
    var phi_987_: f32;
    var phi_992_: f32;
    var phi_993_: bool;
    var phi_994_: f32;
    var phi_995_: bool;
    var phi_999_: f32;
    var phi_1051_: i32;
    var phi_1056_: i32;
    var phi_1061_: i32;
    var phi_1066_: i32;
    var phi_1075_: i32;
    var phi_1080_: i32;
    var phi_1085_: i32;
    var phi_1090_: i32;
    var phi_1185_: bool;
    var phi_1193_: bool;
    var phi_1205_: bool;
    var phi_1206_: bool;
    var phi_1210_: f32;
    var phi_1216_: f32;
    var phi_1218_: evaluate_Verdict;
    var phi_1223_: evaluate_Verdict;
    var phi_1224_: evaluate_Verdict;

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
        let _e78 = samples.member[(0u + _e64.first_primitive)].normal[0u];
        let _e80 = global[0u];
        if (_e78 == _e80) {
            let _e83 = samples.member[(0u + _e64.first_primitive)].normal[1u];
            let _e85 = global[1u];
            if (_e83 == _e85) {
                let _e88 = samples.member[(0u + _e64.first_primitive)].normal[2u];
                let _e90 = global[2u];
                phi_628_ = (_e88 == _e90);
                phi_629_ = false;
            } else {
                phi_628_ = bool();
                phi_629_ = true;
            }
            let _e93 = phi_628_;
            let _e95 = phi_629_;
            phi_630_ = _e93;
            phi_631_ = _e95;
        } else {
            phi_630_ = bool();
            phi_631_ = true;
        }
        let _e97 = phi_630_;
        let _e99 = phi_631_;
        if _e99 {
            phi_635_ = false;
        } else {
            phi_635_ = _e97;
        }
        let _e101 = phi_635_;
        if !(_e101) {
            let _e104 = samples.member[(0u + _e64.first_primitive)].position;
            let _e106 = p.member.light.place;
            let _e112 = p.member.light.place[3u];
            let _e119 = (_e106.x - (_e104.x * _e112));
            let _e120 = (_e106.y - (_e104.y * _e112));
            let _e121 = (_e106.z - (_e104.z * _e112));
            let _e123 = samples.member[(0u + _e64.first_primitive)].normal;
            if ((((_e123.x * _e119) + (_e123.y * _e120)) + (_e123.z * _e121)) > 0f) {
                let _e137 = (((_e119 * _e119) + (_e120 * _e120)) + (_e121 * _e121));
                let _e139 = p.member.light.axis;
                let _e151 = p.member.light.place[3u];
                if (_e151 == 0f) {
                    phi_706_ = true;
                } else {
                    let _e154 = p.member.light.range_squared;
                    if (_e137 <= _e154) {
                        let _e157 = p.member.light.cos_outer;
                        phi_705_ = (-((((_e119 * _e139.x) + (_e120 * _e139.y)) + (_e121 * _e139.z))) >= (_e157 * sqrt(_e137)));
                    } else {
                        phi_705_ = false;
                    }
                    let _e162 = phi_705_;
                    phi_706_ = _e162;
                }
                let _e164 = phi_706_;
                if _e164 {
                    let _e166 = samples.member[(0u + _e64.first_primitive)].flags;
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e174.unnamed.visibility, false), _e174.unnamed_1);
                    phi_717_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e180.unnamed, ((_e166 & 1u) == 0u));
                    phi_718_ = false;
                } else {
                    phi_717_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_718_ = true;
                }
                let _e185 = phi_717_;
                let _e187 = phi_718_;
                phi_719_ = _e185;
                phi_720_ = _e187;
            } else {
                phi_719_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_720_ = true;
            }
            let _e189 = phi_719_;
            let _e191 = phi_720_;
            if _e191 {
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e197.unnamed.visibility, false), _e197.unnamed_1);
                phi_727_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e203.unnamed, true);
            } else {
                phi_727_ = _e189;
            }
            let _e208 = phi_727_;
            phi_731_ = _e208;
        } else {
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e214.unnamed.visibility, false), _e214.unnamed_1);
            phi_731_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e220.unnamed, true);
        }
        let _e225 = phi_731_;
        if _e225.unnamed_1 {
            phi_1224_ = evaluate_Verdict(_e225.unnamed.visibility, _e225.unnamed.is_doubted);
        } else {
            let _e233 = samples.member[(0u + _e64.first_primitive)].position;
            let _e251 = ((((_e74.projection.row_w.x * _e233.x) + (_e74.projection.row_w.y * _e233.y)) + (_e74.projection.row_w.z * _e233.z)) + (_e74.projection.row_w.w * 1f));
            let _e265 = (((((_e74.projection.row_x.x * _e233.x) + (_e74.projection.row_x.y * _e233.y)) + (_e74.projection.row_x.z * _e233.z)) + (_e74.projection.row_x.w * 1f)) / _e251);
            let _e279 = (((((_e74.projection.row_y.x * _e233.x) + (_e74.projection.row_y.y * _e233.y)) + (_e74.projection.row_y.z * _e233.z)) + (_e74.projection.row_y.w * 1f)) / _e251);
            let _e292 = ((((_e74.projection.row_z.x * _e233.x) + (_e74.projection.row_z.y * _e233.y)) + (_e74.projection.row_z.z * _e233.z)) + (_e74.projection.row_z.w * 1f));
            if (_e251 > 0f) {
                if (_e265 >= 0f) {
                    phi_805_ = (_e265 <= 1f);
                } else {
                    phi_805_ = false;
                }
                let _e297 = phi_805_;
                if _e297 {
                    if (_e279 >= 0f) {
                        phi_814_ = (_e279 <= 1f);
                    } else {
                        phi_814_ = false;
                    }
                    let _e301 = phi_814_;
                    if _e301 {
                        if (_e292 >= 0f) {
                            phi_823_ = (_e292 <= 1f);
                        } else {
                            phi_823_ = false;
                        }
                        let _e305 = phi_823_;
                        phi_824_ = _e305;
                        phi_825_ = false;
                    } else {
                        phi_824_ = bool();
                        phi_825_ = true;
                    }
                    let _e307 = phi_824_;
                    let _e309 = phi_825_;
                    phi_826_ = _e307;
                    phi_827_ = _e309;
                } else {
                    phi_826_ = bool();
                    phi_827_ = true;
                }
                let _e311 = phi_826_;
                let _e313 = phi_827_;
                phi_828_ = _e311;
                phi_829_ = _e313;
            } else {
                phi_828_ = bool();
                phi_829_ = true;
            }
            let _e315 = phi_828_;
            let _e317 = phi_829_;
            if _e317 {
                phi_833_ = false;
            } else {
                phi_833_ = _e315;
            }
            let _e319 = phi_833_;
            if _e319 {
                if (0f > 0f) {
                    let _e322 = samples.member[(0u + _e64.first_primitive)].normal;
                    let _e324 = p.member.map_size;
                    let _e394 = ((abs(((((_e70.row_x.x * _e322.x) + (_e70.row_x.y * _e322.y)) + (_e70.row_x.z * _e322.z)) / (((_e70.row_x.x * _e70.row_x.x) + (_e70.row_x.y * _e70.row_x.y)) + (_e70.row_x.z * _e70.row_x.z)))) + abs(((((_e70.row_y.x * _e322.x) + (_e70.row_y.y * _e322.y)) + (_e70.row_y.z * _e322.z)) / (((_e70.row_y.x * _e70.row_y.x) + (_e70.row_y.y * _e70.row_y.y)) + (_e70.row_y.z * _e70.row_y.z))))) / (abs(((((_e70.row_z.x * _e322.x) + (_e70.row_z.y * _e322.y)) + (_e70.row_z.z * _e322.z)) / (((_e70.row_z.x * _e70.row_z.x) + (_e70.row_z.y * _e70.row_z.y)) + (_e70.row_z.z * _e70.row_z.z)))) * f32(_e324)));
                    if (_e394 < 0.002f) {
                        phi_923_ = _e394;
                    } else {
                        phi_923_ = 0.002f;
                    }
                    let _e397 = phi_923_;
                    phi_926_ = (_e292 - (0f * _e397));
                } else {
                    phi_926_ = _e292;
                }
                let _e401 = phi_926_;
                let _e403 = p.member.map_size;
                let _e404 = f32(_e403);
                let _e407 = ((_e265 * _e404) - 0.5f);
                let _e408 = ((_e279 * _e404) - 0.5f);
                if (_e407 > -8388608f) {
                    let _e420 = f32(select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)));
                    if (_e420 > _e407) {
                        phi_955_ = 1f;
                    } else {
                        phi_955_ = 0f;
                    }
                    let _e423 = phi_955_;
                    if (_e407 < 8388608f) {
                        phi_960_ = (_e420 - _e423);
                        phi_961_ = false;
                    } else {
                        phi_960_ = f32();
                        phi_961_ = true;
                    }
                    let _e426 = phi_960_;
                    let _e428 = phi_961_;
                    phi_962_ = _e426;
                    phi_963_ = _e428;
                } else {
                    phi_962_ = f32();
                    phi_963_ = true;
                }
                let _e430 = phi_962_;
                let _e432 = phi_963_;
                if _e432 {
                    phi_967_ = _e407;
                } else {
                    phi_967_ = _e430;
                }
                let _e434 = phi_967_;
                if (_e408 > -8388608f) {
                    let _e446 = f32(select(0i, select(select(i32(_e408), i32(-2147483648), (_e408 < bitcast<f32>(3472883712u))), 2147483647i, (_e408 > bitcast<f32>(1325400063u))), (_e408 == _e408)));
                    if (_e446 > _e408) {
                        phi_987_ = 1f;
                    } else {
                        phi_987_ = 0f;
                    }
                    let _e449 = phi_987_;
                    if (_e408 < 8388608f) {
                        phi_992_ = (_e446 - _e449);
                        phi_993_ = false;
                    } else {
                        phi_992_ = f32();
                        phi_993_ = true;
                    }
                    let _e452 = phi_992_;
                    let _e454 = phi_993_;
                    phi_994_ = _e452;
                    phi_995_ = _e454;
                } else {
                    phi_994_ = f32();
                    phi_995_ = true;
                }
                let _e456 = phi_994_;
                let _e458 = phi_995_;
                if _e458 {
                    phi_999_ = _e408;
                } else {
                    phi_999_ = _e456;
                }
                let _e460 = phi_999_;
                let _e461 = (_e407 - _e434);
                let _e462 = (_e408 - _e460);
                let _e471 = select(0i, select(select(i32(_e434), i32(-2147483648), (_e434 < bitcast<f32>(3472883712u))), 2147483647i, (_e434 > bitcast<f32>(1325400063u))), (_e434 == _e434));
                let _e480 = select(0i, select(select(i32(_e460), i32(-2147483648), (_e460 < bitcast<f32>(3472883712u))), 2147483647i, (_e460 > bitcast<f32>(1325400063u))), (_e460 == _e460));
                let _e483 = ((1f - _e461) * (1f - _e462));
                let _e485 = (_e461 * (1f - _e462));
                let _e487 = ((1f - _e461) * _e462);
                let _e488 = (_e461 * _e462);
                let _e490 = p.member.test;
                let _e491 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e490);
                let _e493 = p.member.map_size;
                local = lt_math_Evsm(_e491.positive_exponent, _e491.negative_exponent, _e491.min_variance);
                let _e499 = ((0u * _e493) * _e493);
                let _e501 = (bitcast<i32>(_e493) - 1i);
                if (_e471 > 0i) {
                    phi_1051_ = _e471;
                } else {
                    phi_1051_ = 0i;
                }
                let _e504 = phi_1051_;
                if (_e480 > 0i) {
                    phi_1056_ = _e480;
                } else {
                    phi_1056_ = 0i;
                }
                let _e507 = phi_1056_;
                if (_e504 < _e501) {
                    phi_1061_ = _e504;
                } else {
                    phi_1061_ = _e501;
                }
                let _e510 = phi_1061_;
                if (_e507 < _e501) {
                    phi_1066_ = _e507;
                } else {
                    phi_1066_ = _e501;
                }
                let _e513 = phi_1066_;
                let _e514 = bitcast<u32>(_e510);
                let _e516 = (_e471 + 1i);
                let _e517 = (_e480 + 1i);
                if (_e516 > 0i) {
                    phi_1075_ = _e516;
                } else {
                    phi_1075_ = 0i;
                }
                let _e520 = phi_1075_;
                if (_e517 > 0i) {
                    phi_1080_ = _e517;
                } else {
                    phi_1080_ = 0i;
                }
                let _e523 = phi_1080_;
                if (_e520 < _e501) {
                    phi_1085_ = _e520;
                } else {
                    phi_1085_ = _e501;
                }
                let _e526 = phi_1085_;
                if (_e523 < _e501) {
                    phi_1090_ = _e523;
                } else {
                    phi_1090_ = _e501;
                }
                let _e529 = phi_1090_;
                let _e530 = bitcast<u32>(_e526);
                let _e532 = (bitcast<u32>(_e513) * _e493);
                let _e533 = (bitcast<u32>(_e529) * _e493);
                let _e538 = ((_e532 + _e514) + _e499);
                let _e539 = ((_e532 + _e530) + _e499);
                let _e540 = ((_e533 + _e514) + _e499);
                let _e541 = ((_e533 + _e530) + _e499);
                if (_e538 < _e55) {
                } else {
                    return;
                }
                let _e545 = map.member[(0u + _e538)];
                if (_e539 < _e55) {
                } else {
                    return;
                }
                let _e557 = map.member[(0u + _e539)];
                if (_e540 < _e55) {
                } else {
                    return;
                }
                let _e573 = map.member[(0u + _e540)];
                if (_e541 < _e55) {
                } else {
                    return;
                }
                let _e589 = map.member[(0u + _e541)];
                let _e603 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e545.x * _e483) + (_e557.x * _e485)) + (_e573.x * _e487)) + (_e589.x * _e488)), ((((_e545.y * _e483) + (_e557.y * _e485)) + (_e573.y * _e487)) + (_e589.y * _e488)), ((((_e545.z * _e483) + (_e557.z * _e485)) + (_e573.z * _e487)) + (_e589.z * _e488)), ((((_e545.w * _e483) + (_e557.w * _e485)) + (_e573.w * _e487)) + (_e589.w * _e488))), _e401);
                let _e605 = p.member.epsilon;
                if (_e603 <= _e605) {
                    phi_1185_ = true;
                } else {
                    phi_1185_ = (_e603 >= (1f - _e605));
                }
                let _e610 = phi_1185_;
                if ((bitcast<u32>(_e603) & 2147483647u) > 2139095040u) {
                    phi_1193_ = true;
                } else {
                    phi_1193_ = !(_e610);
                }
                let _e616 = phi_1193_;
                if _e616 {
                    if (_e603 > 0f) {
                        if (_e603 < 1f) {
                            phi_1205_ = false;
                        } else {
                            phi_1205_ = true;
                        }
                        let _e620 = phi_1205_;
                        phi_1206_ = _e620;
                    } else {
                        phi_1206_ = true;
                    }
                    let _e622 = phi_1206_;
                    if _e622 {
                        phi_1210_ = 0.5f;
                    } else {
                        phi_1210_ = _e603;
                    }
                    let _e624 = phi_1210_;
                    phi_1218_ = evaluate_Verdict(_e624, true);
                } else {
                    if (_e603 > 0.5f) {
                        phi_1216_ = 1f;
                    } else {
                        phi_1216_ = 0f;
                    }
                    let _e628 = phi_1216_;
                    phi_1218_ = evaluate_Verdict(_e628, false);
                }
                let _e631 = phi_1218_;
                phi_1223_ = evaluate_Verdict(_e631.visibility, _e631.is_doubted);
            } else {
                phi_1223_ = evaluate_Verdict(0.5f, true);
            }
            let _e637 = phi_1223_;
            phi_1224_ = _e637;
        }
        let _e639 = phi_1224_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e639.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
