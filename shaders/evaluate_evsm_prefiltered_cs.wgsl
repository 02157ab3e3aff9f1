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

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
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
    var phi_152_: lt_bvh_traverse_Tree;
    var phi_153_: bool;
    var phi_154_: lt_bvh_traverse_Tree;
    var phi_155_: bool;
    var phi_160_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_152_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_153_ = false;
        } else {
            phi_152_ = lt_bvh_traverse_Tree();
            phi_153_ = true;
        }
        let _e60 = phi_152_;
        let _e62 = phi_153_;
        phi_154_ = _e60;
        phi_155_ = _e62;
    } else {
        phi_154_ = lt_bvh_traverse_Tree();
        phi_155_ = true;
    }
    let _e64 = phi_154_;
    let _e66 = phi_155_;
    if _e66 {
        phi_160_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_160_ = _e64;
    }
    let _e71 = phi_160_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_187_: f32;
    var phi_188_: f32;
    var phi_189_: f32;
    var phi_202_: bool;
    var phi_206_: f32;
    var phi_218_: f32;
    var phi_223_: f32;
    var phi_245_: f32;
    var phi_250_: f32;
    var phi_251_: bool;
    var phi_252_: f32;
    var phi_253_: bool;
    var phi_257_: f32;
    var phi_295_: f32;
    var phi_308_: bool;
    var phi_312_: f32;
    var phi_325_: f32;
    var phi_330_: f32;
    var phi_352_: f32;
    var phi_357_: f32;
    var phi_358_: bool;
    var phi_359_: f32;
    var phi_360_: bool;
    var phi_364_: f32;
    var phi_402_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_189_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_188_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_187_ = 1f;
            } else {
                phi_187_ = param_5;
            }
            let _e55 = phi_187_;
            phi_188_ = _e55;
        }
        let _e57 = phi_188_;
        phi_189_ = _e57;
    }
    let _e59 = phi_189_;
    let _e61 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_202_ = true;
    } else {
        let _e65 = (42f < _e61);
        if _e65 {
        }
        phi_202_ = _e65;
    }
    let _e67 = phi_202_;
    if _e67 {
        phi_206_ = 42f;
    } else {
        phi_206_ = _e61;
    }
    let _e69 = phi_206_;
    let _e70 = (_e69 * _e59);
    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
        phi_295_ = _e70;
    } else {
        if (_e70 < -87f) {
            phi_218_ = -87f;
        } else {
            phi_218_ = _e70;
        }
        let _e76 = phi_218_;
        if (_e76 > 88f) {
            phi_223_ = 88f;
        } else {
            phi_223_ = _e76;
        }
        let _e79 = phi_223_;
        let _e81 = ((_e79 * 1.442695f) + 0.5f);
        if (_e81 > -8388608f) {
            let _e93 = f32(select(0i, select(select(i32(_e81), i32(-2147483648), (_e81 < bitcast<f32>(3472883712u))), 2147483647i, (_e81 > bitcast<f32>(1325400063u))), (_e81 == _e81)));
            if (_e93 > _e81) {
                phi_245_ = 1f;
            } else {
                phi_245_ = 0f;
            }
            let _e96 = phi_245_;
            if (_e81 < 8388608f) {
                phi_250_ = (_e93 - _e96);
                phi_251_ = false;
            } else {
                phi_250_ = f32();
                phi_251_ = true;
            }
            let _e99 = phi_250_;
            let _e101 = phi_251_;
            phi_252_ = _e99;
            phi_253_ = _e101;
        } else {
            phi_252_ = f32();
            phi_253_ = true;
        }
        let _e103 = phi_252_;
        let _e105 = phi_253_;
        if _e105 {
            phi_257_ = _e81;
        } else {
            phi_257_ = _e103;
        }
        let _e107 = phi_257_;
        let _e111 = ((_e79 - (_e107 * 0.69314575f)) - (_e107 * 0.0000014286068f));
        phi_295_ = ((((((((((((((((1f / 5040f) * _e111) + (1f / 720f)) * _e111) + (1f / 120f)) * _e111) + (1f / 24f)) * _e111) + (1f / 6f)) * _e111) + 0.5f) * _e111) + 1f) * _e111) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e107), i32(-2147483648), (_e107 < bitcast<f32>(3472883712u))), 2147483647i, (_e107 > bitcast<f32>(1325400063u))), (_e107 == _e107)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e147 = phi_295_;
    let _e149 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_308_ = true;
    } else {
        let _e153 = (42f < _e149);
        if _e153 {
        }
        phi_308_ = _e153;
    }
    let _e155 = phi_308_;
    if _e155 {
        phi_312_ = 42f;
    } else {
        phi_312_ = _e149;
    }
    let _e157 = phi_312_;
    let _e159 = (-(_e157) * _e59);
    if ((bitcast<u32>(_e159) & 2147483647u) > 2139095040u) {
        phi_402_ = _e159;
    } else {
        if (_e159 < -87f) {
            phi_325_ = -87f;
        } else {
            phi_325_ = _e159;
        }
        let _e165 = phi_325_;
        if (_e165 > 88f) {
            phi_330_ = 88f;
        } else {
            phi_330_ = _e165;
        }
        let _e168 = phi_330_;
        let _e170 = ((_e168 * 1.442695f) + 0.5f);
        if (_e170 > -8388608f) {
            let _e182 = f32(select(0i, select(select(i32(_e170), i32(-2147483648), (_e170 < bitcast<f32>(3472883712u))), 2147483647i, (_e170 > bitcast<f32>(1325400063u))), (_e170 == _e170)));
            if (_e182 > _e170) {
                phi_352_ = 1f;
            } else {
                phi_352_ = 0f;
            }
            let _e185 = phi_352_;
            if (_e170 < 8388608f) {
                phi_357_ = (_e182 - _e185);
                phi_358_ = false;
            } else {
                phi_357_ = f32();
                phi_358_ = true;
            }
            let _e188 = phi_357_;
            let _e190 = phi_358_;
            phi_359_ = _e188;
            phi_360_ = _e190;
        } else {
            phi_359_ = f32();
            phi_360_ = true;
        }
        let _e192 = phi_359_;
        let _e194 = phi_360_;
        if _e194 {
            phi_364_ = _e170;
        } else {
            phi_364_ = _e192;
        }
        let _e196 = phi_364_;
        let _e200 = ((_e168 - (_e196 * 0.69314575f)) - (_e196 * 0.0000014286068f));
        phi_402_ = ((((((((((((((((1f / 5040f) * _e200) + (1f / 720f)) * _e200) + (1f / 120f)) * _e200) + (1f / 24f)) * _e200) + (1f / 6f)) * _e200) + 0.5f) * _e200) + 1f) * _e200) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e196), i32(-2147483648), (_e196 < bitcast<f32>(3472883712u))), 2147483647i, (_e196 > bitcast<f32>(1325400063u))), (_e196 == _e196)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e236 = phi_402_;
    let _e237 = -(_e236);
    return vec4<f32>(_e147, (_e147 * _e147), _e237, (_e237 * _e237));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_1047_: bool;
    var phi_1051_: f32;
    var phi_1075_: bool;
    var phi_1079_: f32;
    var phi_1091_: bool;
    var phi_1098_: f32;
    var phi_1111_: bool;
    var phi_1115_: f32;
    var phi_1139_: bool;
    var phi_1143_: f32;
    var phi_1155_: bool;
    var phi_1162_: f32;
    var phi_1173_: bool;
    var phi_1177_: f32;
    var phi_1192_: f32;
    var phi_1193_: f32;
    var phi_1194_: f32;

    let _e50 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e52 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_1047_ = true;
    } else {
        let _e56 = (42f < _e52);
        if _e56 {
        }
        phi_1047_ = _e56;
    }
    let _e58 = phi_1047_;
    if _e58 {
        phi_1051_ = 42f;
    } else {
        phi_1051_ = _e52;
    }
    let _e60 = phi_1051_;
    let _e62 = (*param_6).min_variance;
    let _e66 = (((_e62 * _e60) * _e60) * _e50.y);
    let _e73 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u) {
        phi_1075_ = true;
    } else {
        let _e77 = (_e66 > _e73);
        if _e77 {
        }
        phi_1075_ = _e77;
    }
    let _e79 = phi_1075_;
    if _e79 {
        phi_1079_ = _e66;
    } else {
        phi_1079_ = _e73;
    }
    let _e81 = phi_1079_;
    let _e82 = (_e50.x - param_7.x);
    if (_e82 <= 0f) {
        let _e86 = ((bitcast<u32>(_e81) & 2147483647u) > 2139095040u);
        if _e86 {
        }
        phi_1091_ = _e86;
    } else {
        phi_1091_ = true;
    }
    let _e88 = phi_1091_;
    if _e88 {
        phi_1098_ = (_e81 / (_e81 + (_e82 * _e82)));
    } else {
        phi_1098_ = 1f;
    }
    let _e93 = phi_1098_;
    let _e95 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_1111_ = true;
    } else {
        let _e99 = (42f < _e95);
        if _e99 {
        }
        phi_1111_ = _e99;
    }
    let _e101 = phi_1111_;
    if _e101 {
        phi_1115_ = 42f;
    } else {
        phi_1115_ = _e95;
    }
    let _e103 = phi_1115_;
    let _e105 = (*param_6).min_variance;
    let _e109 = (((_e105 * _e103) * _e103) * _e50.w);
    let _e116 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
        phi_1139_ = true;
    } else {
        let _e120 = (_e109 > _e116);
        if _e120 {
        }
        phi_1139_ = _e120;
    }
    let _e122 = phi_1139_;
    if _e122 {
        phi_1143_ = _e109;
    } else {
        phi_1143_ = _e116;
    }
    let _e124 = phi_1143_;
    let _e125 = (_e50.z - param_7.z);
    if (_e125 <= 0f) {
        let _e129 = ((bitcast<u32>(_e124) & 2147483647u) > 2139095040u);
        if _e129 {
        }
        phi_1155_ = _e129;
    } else {
        phi_1155_ = true;
    }
    let _e131 = phi_1155_;
    if _e131 {
        phi_1162_ = (_e124 / (_e124 + (_e125 * _e125)));
    } else {
        phi_1162_ = 1f;
    }
    let _e136 = phi_1162_;
    if ((bitcast<u32>(_e136) & 2147483647u) > 2139095040u) {
        phi_1173_ = true;
    } else {
        let _e140 = (_e136 < _e93);
        if _e140 {
        }
        phi_1173_ = _e140;
    }
    let _e142 = phi_1173_;
    if _e142 {
        phi_1177_ = _e136;
    } else {
        phi_1177_ = _e93;
    }
    let _e144 = phi_1177_;
    if ((bitcast<u32>(_e144) & 2147483647u) > 2139095040u) {
        phi_1194_ = _e144;
    } else {
        if (_e144 < 0f) {
            phi_1193_ = 0f;
        } else {
            if (_e144 > 1f) {
                phi_1192_ = 1f;
            } else {
                phi_1192_ = _e144;
            }
            let _e151 = phi_1192_;
            phi_1193_ = _e151;
        }
        let _e153 = phi_1193_;
        phi_1194_ = _e153;
    }
    let _e155 = phi_1194_;
    return _e155;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_462_: bool;
    var phi_463_: bool;
    var phi_464_: bool;
    var phi_465_: bool;
    var phi_469_: bool;
    var phi_539_: bool;
    var phi_540_: bool;
    var phi_551_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_552_: bool;
    var phi_553_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_554_: bool;
    var phi_561_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_565_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_639_: bool;
    var phi_648_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_667_: bool;
    var phi_757_: f32;
    var phi_760_: f32;
    var phi_789_: f32;
    var phi_794_: f32;
    var phi_795_: bool;
    var phi_796_: f32;
    var phi_797_: bool;
    var phi_801_: f32;
    var phi_821_: f32;
    var phi_826_: f32;
    var phi_827_: bool;
    var phi_828_: f32;
    var phi_829_: bool;
    var phi_833_: f32;
    var phi_885_: i32;
    var phi_890_: i32;
    var phi_895_: i32;
    var phi_900_: i32;
    var phi_909_: i32;
    var phi_914_: i32;
    var phi_919_: i32;
    var phi_924_: i32;
    var phi_1013_: evaluate_Verdict;
    var phi_1014_: evaluate_Verdict;
    var phi_1015_: bool;
    var phi_1016_: evaluate_Verdict;
    var phi_1017_: evaluate_Verdict;
    var phi_1018_: bool;
    var phi_1022_: evaluate_Verdict;

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
                phi_462_ = (_e88 == _e90);
                phi_463_ = false;
            } else {
                phi_462_ = bool();
                phi_463_ = true;
            }
            let _e93 = phi_462_;
            let _e95 = phi_463_;
            phi_464_ = _e93;
            phi_465_ = _e95;
        } else {
            phi_464_ = bool();
            phi_465_ = true;
        }
        let _e97 = phi_464_;
        let _e99 = phi_465_;
        if _e99 {
            phi_469_ = false;
        } else {
            phi_469_ = _e97;
        }
        let _e101 = phi_469_;
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
                    phi_540_ = true;
                } else {
                    let _e154 = p.member.light.range_squared;
                    if (_e137 <= _e154) {
                        let _e157 = p.member.light.cos_outer;
                        phi_539_ = (-((((_e119 * _e139.x) + (_e120 * _e139.y)) + (_e121 * _e139.z))) >= (_e157 * sqrt(_e137)));
                    } else {
                        phi_539_ = false;
                    }
                    let _e162 = phi_539_;
                    phi_540_ = _e162;
                }
                let _e164 = phi_540_;
                if _e164 {
                    let _e166 = samples.member[(0u + _e64.first_primitive)].flags;
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e174.unnamed.visibility, false), _e174.unnamed_1);
                    phi_551_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e180.unnamed, ((_e166 & 1u) == 0u));
                    phi_552_ = false;
                } else {
                    phi_551_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_552_ = true;
                }
                let _e185 = phi_551_;
                let _e187 = phi_552_;
                phi_553_ = _e185;
                phi_554_ = _e187;
            } else {
                phi_553_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_554_ = true;
            }
            let _e189 = phi_553_;
            let _e191 = phi_554_;
            if _e191 {
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e197.unnamed.visibility, false), _e197.unnamed_1);
                phi_561_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e203.unnamed, true);
            } else {
                phi_561_ = _e189;
            }
            let _e208 = phi_561_;
            phi_565_ = _e208;
        } else {
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e214.unnamed.visibility, false), _e214.unnamed_1);
            phi_565_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e220.unnamed, true);
        }
        let _e225 = phi_565_;
        if _e225.unnamed_1 {
            phi_1016_ = evaluate_Verdict(_e225.unnamed.visibility, _e225.unnamed.is_doubted);
            phi_1017_ = evaluate_Verdict();
            phi_1018_ = true;
        } else {
            let _e233 = samples.member[(0u + _e64.first_primitive)].position;
            let _e251 = ((((_e74.projection.row_w.x * _e233.x) + (_e74.projection.row_w.y * _e233.y)) + (_e74.projection.row_w.z * _e233.z)) + (_e74.projection.row_w.w * 1f));
            let _e265 = (((((_e74.projection.row_x.x * _e233.x) + (_e74.projection.row_x.y * _e233.y)) + (_e74.projection.row_x.z * _e233.z)) + (_e74.projection.row_x.w * 1f)) / _e251);
            let _e279 = (((((_e74.projection.row_y.x * _e233.x) + (_e74.projection.row_y.y * _e233.y)) + (_e74.projection.row_y.z * _e233.z)) + (_e74.projection.row_y.w * 1f)) / _e251);
            let _e292 = ((((_e74.projection.row_z.x * _e233.x) + (_e74.projection.row_z.y * _e233.y)) + (_e74.projection.row_z.z * _e233.z)) + (_e74.projection.row_z.w * 1f));
            if (_e251 > 0f) {
                if (_e265 >= 0f) {
                    phi_639_ = (_e265 <= 1f);
                } else {
                    phi_639_ = false;
                }
                let _e297 = phi_639_;
                if _e297 {
                    if (_e279 >= 0f) {
                        phi_648_ = (_e279 <= 1f);
                    } else {
                        phi_648_ = false;
                    }
                    let _e301 = phi_648_;
                    if _e301 {
                        if (_e292 >= 0f) {
                            phi_657_ = (_e292 <= 1f);
                        } else {
                            phi_657_ = false;
                        }
                        let _e305 = phi_657_;
                        phi_658_ = _e305;
                        phi_659_ = false;
                    } else {
                        phi_658_ = bool();
                        phi_659_ = true;
                    }
                    let _e307 = phi_658_;
                    let _e309 = phi_659_;
                    phi_660_ = _e307;
                    phi_661_ = _e309;
                } else {
                    phi_660_ = bool();
                    phi_661_ = true;
                }
                let _e311 = phi_660_;
                let _e313 = phi_661_;
                phi_662_ = _e311;
                phi_663_ = _e313;
            } else {
                phi_662_ = bool();
                phi_663_ = true;
            }
            let _e315 = phi_662_;
            let _e317 = phi_663_;
            if _e317 {
                phi_667_ = false;
            } else {
                phi_667_ = _e315;
            }
            let _e319 = phi_667_;
            if _e319 {
                if (0f > 0f) {
                    let _e322 = samples.member[(0u + _e64.first_primitive)].normal;
                    let _e324 = p.member.map_size;
                    let _e394 = ((abs(((((_e70.row_x.x * _e322.x) + (_e70.row_x.y * _e322.y)) + (_e70.row_x.z * _e322.z)) / (((_e70.row_x.x * _e70.row_x.x) + (_e70.row_x.y * _e70.row_x.y)) + (_e70.row_x.z * _e70.row_x.z)))) + abs(((((_e70.row_y.x * _e322.x) + (_e70.row_y.y * _e322.y)) + (_e70.row_y.z * _e322.z)) / (((_e70.row_y.x * _e70.row_y.x) + (_e70.row_y.y * _e70.row_y.y)) + (_e70.row_y.z * _e70.row_y.z))))) / (abs(((((_e70.row_z.x * _e322.x) + (_e70.row_z.y * _e322.y)) + (_e70.row_z.z * _e322.z)) / (((_e70.row_z.x * _e70.row_z.x) + (_e70.row_z.y * _e70.row_z.y)) + (_e70.row_z.z * _e70.row_z.z)))) * f32(_e324)));
                    if (_e394 < 0.002f) {
                        phi_757_ = _e394;
                    } else {
                        phi_757_ = 0.002f;
                    }
                    let _e397 = phi_757_;
                    phi_760_ = (_e292 - (0f * _e397));
                } else {
                    phi_760_ = _e292;
                }
                let _e401 = phi_760_;
                let _e403 = p.member.map_size;
                let _e404 = f32(_e403);
                let _e407 = ((_e265 * _e404) - 0.5f);
                let _e408 = ((_e279 * _e404) - 0.5f);
                if (_e407 > -8388608f) {
                    let _e420 = f32(select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)));
                    if (_e420 > _e407) {
                        phi_789_ = 1f;
                    } else {
                        phi_789_ = 0f;
                    }
                    let _e423 = phi_789_;
                    if (_e407 < 8388608f) {
                        phi_794_ = (_e420 - _e423);
                        phi_795_ = false;
                    } else {
                        phi_794_ = f32();
                        phi_795_ = true;
                    }
                    let _e426 = phi_794_;
                    let _e428 = phi_795_;
                    phi_796_ = _e426;
                    phi_797_ = _e428;
                } else {
                    phi_796_ = f32();
                    phi_797_ = true;
                }
                let _e430 = phi_796_;
                let _e432 = phi_797_;
                if _e432 {
                    phi_801_ = _e407;
                } else {
                    phi_801_ = _e430;
                }
                let _e434 = phi_801_;
                if (_e408 > -8388608f) {
                    let _e446 = f32(select(0i, select(select(i32(_e408), i32(-2147483648), (_e408 < bitcast<f32>(3472883712u))), 2147483647i, (_e408 > bitcast<f32>(1325400063u))), (_e408 == _e408)));
                    if (_e446 > _e408) {
                        phi_821_ = 1f;
                    } else {
                        phi_821_ = 0f;
                    }
                    let _e449 = phi_821_;
                    if (_e408 < 8388608f) {
                        phi_826_ = (_e446 - _e449);
                        phi_827_ = false;
                    } else {
                        phi_826_ = f32();
                        phi_827_ = true;
                    }
                    let _e452 = phi_826_;
                    let _e454 = phi_827_;
                    phi_828_ = _e452;
                    phi_829_ = _e454;
                } else {
                    phi_828_ = f32();
                    phi_829_ = true;
                }
                let _e456 = phi_828_;
                let _e458 = phi_829_;
                if _e458 {
                    phi_833_ = _e408;
                } else {
                    phi_833_ = _e456;
                }
                let _e460 = phi_833_;
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
                    phi_885_ = _e471;
                } else {
                    phi_885_ = 0i;
                }
                let _e504 = phi_885_;
                if (_e480 > 0i) {
                    phi_890_ = _e480;
                } else {
                    phi_890_ = 0i;
                }
                let _e507 = phi_890_;
                if (_e504 < _e501) {
                    phi_895_ = _e504;
                } else {
                    phi_895_ = _e501;
                }
                let _e510 = phi_895_;
                if (_e507 < _e501) {
                    phi_900_ = _e507;
                } else {
                    phi_900_ = _e501;
                }
                let _e513 = phi_900_;
                let _e514 = bitcast<u32>(_e510);
                let _e516 = (_e471 + 1i);
                let _e517 = (_e480 + 1i);
                if (_e516 > 0i) {
                    phi_909_ = _e516;
                } else {
                    phi_909_ = 0i;
                }
                let _e520 = phi_909_;
                if (_e517 > 0i) {
                    phi_914_ = _e517;
                } else {
                    phi_914_ = 0i;
                }
                let _e523 = phi_914_;
                if (_e520 < _e501) {
                    phi_919_ = _e520;
                } else {
                    phi_919_ = _e501;
                }
                let _e526 = phi_919_;
                if (_e523 < _e501) {
                    phi_924_ = _e523;
                } else {
                    phi_924_ = _e501;
                }
                let _e529 = phi_924_;
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
                phi_1013_ = evaluate_Verdict(_e603, false);
                phi_1014_ = evaluate_Verdict();
                phi_1015_ = false;
            } else {
                phi_1013_ = evaluate_Verdict();
                phi_1014_ = evaluate_Verdict(1f, false);
                phi_1015_ = true;
            }
            let _e607 = phi_1013_;
            let _e609 = phi_1014_;
            let _e611 = phi_1015_;
            phi_1016_ = _e609;
            phi_1017_ = _e607;
            phi_1018_ = _e611;
        }
        let _e613 = phi_1016_;
        let _e615 = phi_1017_;
        let _e617 = phi_1018_;
        if _e617 {
            phi_1022_ = _e613;
        } else {
            phi_1022_ = _e615;
        }
        let _e619 = phi_1022_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e619.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
