struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

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

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
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

struct type_30 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_143_: lt_mask_LightPlace;
    var phi_144_: bool;
    var phi_145_: lt_mask_LightPlace;
    var phi_146_: bool;
    var phi_151_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_143_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_144_ = false;
        } else {
            phi_143_ = lt_mask_LightPlace();
            phi_144_ = true;
        }
        let _e59 = phi_143_;
        let _e61 = phi_144_;
        phi_145_ = _e59;
        phi_146_ = _e61;
    } else {
        phi_145_ = lt_mask_LightPlace();
        phi_146_ = true;
    }
    let _e63 = phi_145_;
    let _e65 = phi_146_;
    if _e65 {
        phi_151_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_151_ = _e63;
    }
    let _e70 = phi_151_;
    return lt_mask_LightPlace(_e70.word, _e70.shift);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_171_: bool;
    var phi_175_: f32;

    let _e47 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_171_ = true;
    } else {
        let _e51 = (84f < _e47);
        if _e51 {
        }
        phi_171_ = _e51;
    }
    let _e53 = phi_171_;
    if _e53 {
        phi_175_ = 84f;
    } else {
        phi_175_ = _e47;
    }
    let _e55 = phi_175_;
    return _e55;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_771_: f32;
    var phi_772_: f32;
    var phi_773_: f32;
    var phi_789_: f32;
    var phi_790_: f32;
    var phi_791_: f32;
    var phi_807_: f32;
    var phi_808_: f32;
    var phi_809_: f32;
    var phi_825_: f32;
    var phi_826_: f32;
    var phi_827_: f32;
    var phi_843_: f32;
    var phi_844_: f32;
    var phi_845_: f32;
    var phi_864_: f32;
    var phi_869_: f32;
    var phi_891_: f32;
    var phi_896_: f32;
    var phi_897_: bool;
    var phi_898_: f32;
    var phi_899_: bool;
    var phi_903_: f32;
    var phi_941_: f32;
    var phi_952_: f32;
    var phi_957_: f32;
    var phi_979_: f32;
    var phi_984_: f32;
    var phi_985_: bool;
    var phi_986_: f32;
    var phi_987_: bool;
    var phi_991_: f32;
    var phi_1029_: f32;
    var phi_1040_: f32;
    var phi_1045_: f32;
    var phi_1067_: f32;
    var phi_1072_: f32;
    var phi_1073_: bool;
    var phi_1074_: f32;
    var phi_1075_: bool;
    var phi_1079_: f32;
    var phi_1117_: f32;
    var phi_1128_: f32;
    var phi_1133_: f32;
    var phi_1155_: f32;
    var phi_1160_: f32;
    var phi_1161_: bool;
    var phi_1162_: f32;
    var phi_1163_: bool;
    var phi_1167_: f32;
    var phi_1205_: f32;
    var phi_1231_: f32;
    var phi_1232_: f32;
    var phi_1233_: f32;

    let _e50 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_773_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_772_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_771_ = 1f;
            } else {
                phi_771_ = param_8;
            }
            let _e57 = phi_771_;
            phi_772_ = _e57;
        }
        let _e59 = phi_772_;
        phi_773_ = _e59;
    }
    let _e61 = phi_773_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_791_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_790_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_789_ = 1f;
            } else {
                phi_789_ = param_6.x;
            }
            let _e69 = phi_789_;
            phi_790_ = _e69;
        }
        let _e71 = phi_790_;
        phi_791_ = _e71;
    }
    let _e73 = phi_791_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_809_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_808_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_807_ = 1f;
            } else {
                phi_807_ = param_6.y;
            }
            let _e81 = phi_807_;
            phi_808_ = _e81;
        }
        let _e83 = phi_808_;
        phi_809_ = _e83;
    }
    let _e85 = phi_809_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_827_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_826_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_825_ = 1f;
            } else {
                phi_825_ = param_6.z;
            }
            let _e93 = phi_825_;
            phi_826_ = _e93;
        }
        let _e95 = phi_826_;
        phi_827_ = _e95;
    }
    let _e97 = phi_827_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_845_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_844_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_843_ = 1f;
            } else {
                phi_843_ = param_6.w;
            }
            let _e105 = phi_843_;
            phi_844_ = _e105;
        }
        let _e107 = phi_844_;
        phi_845_ = _e107;
    }
    let _e109 = phi_845_;
    let _e114 = (_e50 * (_e73 - _e61));
    let _e115 = (_e50 * (_e85 - _e61));
    let _e116 = (_e50 * (_e97 - _e61));
    let _e117 = (_e50 * (_e109 - _e61));
    if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
        phi_941_ = _e114;
    } else {
        if (_e114 < -87f) {
            phi_864_ = -87f;
        } else {
            phi_864_ = _e114;
        }
        let _e123 = phi_864_;
        if (_e123 > 88f) {
            phi_869_ = 88f;
        } else {
            phi_869_ = _e123;
        }
        let _e126 = phi_869_;
        let _e128 = ((_e126 * 1.442695f) + 0.5f);
        if (_e128 > -8388608f) {
            let _e140 = f32(select(0i, select(select(i32(_e128), i32(-2147483648), (_e128 < bitcast<f32>(3472883712u))), 2147483647i, (_e128 > bitcast<f32>(1325400063u))), (_e128 == _e128)));
            if (_e140 > _e128) {
                phi_891_ = 1f;
            } else {
                phi_891_ = 0f;
            }
            let _e143 = phi_891_;
            if (_e128 < 8388608f) {
                phi_896_ = (_e140 - _e143);
                phi_897_ = false;
            } else {
                phi_896_ = f32();
                phi_897_ = true;
            }
            let _e146 = phi_896_;
            let _e148 = phi_897_;
            phi_898_ = _e146;
            phi_899_ = _e148;
        } else {
            phi_898_ = f32();
            phi_899_ = true;
        }
        let _e150 = phi_898_;
        let _e152 = phi_899_;
        if _e152 {
            phi_903_ = _e128;
        } else {
            phi_903_ = _e150;
        }
        let _e154 = phi_903_;
        let _e158 = ((_e126 - (_e154 * 0.69314575f)) - (_e154 * 0.0000014286068f));
        phi_941_ = ((((((((((((((((1f / 5040f) * _e158) + (1f / 720f)) * _e158) + (1f / 120f)) * _e158) + (1f / 24f)) * _e158) + (1f / 6f)) * _e158) + 0.5f) * _e158) + 1f) * _e158) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e154), i32(-2147483648), (_e154 < bitcast<f32>(3472883712u))), 2147483647i, (_e154 > bitcast<f32>(1325400063u))), (_e154 == _e154)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e194 = phi_941_;
    if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
        phi_1029_ = _e115;
    } else {
        if (_e115 < -87f) {
            phi_952_ = -87f;
        } else {
            phi_952_ = _e115;
        }
        let _e200 = phi_952_;
        if (_e200 > 88f) {
            phi_957_ = 88f;
        } else {
            phi_957_ = _e200;
        }
        let _e203 = phi_957_;
        let _e205 = ((_e203 * 1.442695f) + 0.5f);
        if (_e205 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(_e205), i32(-2147483648), (_e205 < bitcast<f32>(3472883712u))), 2147483647i, (_e205 > bitcast<f32>(1325400063u))), (_e205 == _e205)));
            if (_e217 > _e205) {
                phi_979_ = 1f;
            } else {
                phi_979_ = 0f;
            }
            let _e220 = phi_979_;
            if (_e205 < 8388608f) {
                phi_984_ = (_e217 - _e220);
                phi_985_ = false;
            } else {
                phi_984_ = f32();
                phi_985_ = true;
            }
            let _e223 = phi_984_;
            let _e225 = phi_985_;
            phi_986_ = _e223;
            phi_987_ = _e225;
        } else {
            phi_986_ = f32();
            phi_987_ = true;
        }
        let _e227 = phi_986_;
        let _e229 = phi_987_;
        if _e229 {
            phi_991_ = _e205;
        } else {
            phi_991_ = _e227;
        }
        let _e231 = phi_991_;
        let _e235 = ((_e203 - (_e231 * 0.69314575f)) - (_e231 * 0.0000014286068f));
        phi_1029_ = ((((((((((((((((1f / 5040f) * _e235) + (1f / 720f)) * _e235) + (1f / 120f)) * _e235) + (1f / 24f)) * _e235) + (1f / 6f)) * _e235) + 0.5f) * _e235) + 1f) * _e235) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e231), i32(-2147483648), (_e231 < bitcast<f32>(3472883712u))), 2147483647i, (_e231 > bitcast<f32>(1325400063u))), (_e231 == _e231)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e271 = phi_1029_;
    if ((bitcast<u32>(_e116) & 2147483647u) > 2139095040u) {
        phi_1117_ = _e116;
    } else {
        if (_e116 < -87f) {
            phi_1040_ = -87f;
        } else {
            phi_1040_ = _e116;
        }
        let _e277 = phi_1040_;
        if (_e277 > 88f) {
            phi_1045_ = 88f;
        } else {
            phi_1045_ = _e277;
        }
        let _e280 = phi_1045_;
        let _e282 = ((_e280 * 1.442695f) + 0.5f);
        if (_e282 > -8388608f) {
            let _e294 = f32(select(0i, select(select(i32(_e282), i32(-2147483648), (_e282 < bitcast<f32>(3472883712u))), 2147483647i, (_e282 > bitcast<f32>(1325400063u))), (_e282 == _e282)));
            if (_e294 > _e282) {
                phi_1067_ = 1f;
            } else {
                phi_1067_ = 0f;
            }
            let _e297 = phi_1067_;
            if (_e282 < 8388608f) {
                phi_1072_ = (_e294 - _e297);
                phi_1073_ = false;
            } else {
                phi_1072_ = f32();
                phi_1073_ = true;
            }
            let _e300 = phi_1072_;
            let _e302 = phi_1073_;
            phi_1074_ = _e300;
            phi_1075_ = _e302;
        } else {
            phi_1074_ = f32();
            phi_1075_ = true;
        }
        let _e304 = phi_1074_;
        let _e306 = phi_1075_;
        if _e306 {
            phi_1079_ = _e282;
        } else {
            phi_1079_ = _e304;
        }
        let _e308 = phi_1079_;
        let _e312 = ((_e280 - (_e308 * 0.69314575f)) - (_e308 * 0.0000014286068f));
        phi_1117_ = ((((((((((((((((1f / 5040f) * _e312) + (1f / 720f)) * _e312) + (1f / 120f)) * _e312) + (1f / 24f)) * _e312) + (1f / 6f)) * _e312) + 0.5f) * _e312) + 1f) * _e312) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e308), i32(-2147483648), (_e308 < bitcast<f32>(3472883712u))), 2147483647i, (_e308 > bitcast<f32>(1325400063u))), (_e308 == _e308)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e348 = phi_1117_;
    if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
        phi_1205_ = _e117;
    } else {
        if (_e117 < -87f) {
            phi_1128_ = -87f;
        } else {
            phi_1128_ = _e117;
        }
        let _e354 = phi_1128_;
        if (_e354 > 88f) {
            phi_1133_ = 88f;
        } else {
            phi_1133_ = _e354;
        }
        let _e357 = phi_1133_;
        let _e359 = ((_e357 * 1.442695f) + 0.5f);
        if (_e359 > -8388608f) {
            let _e371 = f32(select(0i, select(select(i32(_e359), i32(-2147483648), (_e359 < bitcast<f32>(3472883712u))), 2147483647i, (_e359 > bitcast<f32>(1325400063u))), (_e359 == _e359)));
            if (_e371 > _e359) {
                phi_1155_ = 1f;
            } else {
                phi_1155_ = 0f;
            }
            let _e374 = phi_1155_;
            if (_e359 < 8388608f) {
                phi_1160_ = (_e371 - _e374);
                phi_1161_ = false;
            } else {
                phi_1160_ = f32();
                phi_1161_ = true;
            }
            let _e377 = phi_1160_;
            let _e379 = phi_1161_;
            phi_1162_ = _e377;
            phi_1163_ = _e379;
        } else {
            phi_1162_ = f32();
            phi_1163_ = true;
        }
        let _e381 = phi_1162_;
        let _e383 = phi_1163_;
        if _e383 {
            phi_1167_ = _e359;
        } else {
            phi_1167_ = _e381;
        }
        let _e385 = phi_1167_;
        let _e389 = ((_e357 - (_e385 * 0.69314575f)) - (_e385 * 0.0000014286068f));
        phi_1205_ = ((((((((((((((((1f / 5040f) * _e389) + (1f / 720f)) * _e389) + (1f / 120f)) * _e389) + (1f / 24f)) * _e389) + (1f / 6f)) * _e389) + 0.5f) * _e389) + 1f) * _e389) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e385), i32(-2147483648), (_e385 < bitcast<f32>(3472883712u))), 2147483647i, (_e385 > bitcast<f32>(1325400063u))), (_e385 == _e385)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e425 = phi_1205_;
    let _e436 = ((((_e194 * param_7.x) + (_e271 * param_7.y)) + (_e348 * param_7.z)) + (_e425 * param_7.w));
    if ((bitcast<u32>(_e436) & 2147483647u) > 2139095040u) {
        phi_1233_ = _e436;
    } else {
        if (_e436 < 0f) {
            phi_1232_ = 0f;
        } else {
            if (_e436 > 1f) {
                phi_1231_ = 1f;
            } else {
                phi_1231_ = _e436;
            }
            let _e443 = phi_1231_;
            phi_1232_ = _e443;
        }
        let _e445 = phi_1232_;
        phi_1233_ = _e445;
    }
    let _e447 = phi_1233_;
    return _e447;
}

fn function_() {
    var local: f32;
    var phi_231_: bool;
    var phi_232_: bool;
    var phi_233_: bool;
    var phi_234_: bool;
    var phi_238_: bool;
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_320_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_321_: bool;
    var phi_322_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_323_: bool;
    var phi_330_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_334_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_408_: bool;
    var phi_417_: bool;
    var phi_426_: bool;
    var phi_427_: bool;
    var phi_428_: bool;
    var phi_429_: bool;
    var phi_430_: bool;
    var phi_431_: bool;
    var phi_432_: bool;
    var phi_436_: bool;
    var phi_526_: f32;
    var phi_529_: f32;
    var phi_558_: f32;
    var phi_563_: f32;
    var phi_564_: bool;
    var phi_565_: f32;
    var phi_566_: bool;
    var phi_570_: f32;
    var phi_590_: f32;
    var phi_595_: f32;
    var phi_596_: bool;
    var phi_597_: f32;
    var phi_598_: bool;
    var phi_602_: f32;
    var phi_650_: i32;
    var phi_655_: i32;
    var phi_660_: i32;
    var phi_665_: i32;
    var phi_674_: i32;
    var phi_679_: i32;
    var phi_684_: i32;
    var phi_689_: i32;
    var phi_734_: evaluate_Verdict;
    var phi_735_: evaluate_Verdict;
    var phi_736_: bool;
    var phi_737_: evaluate_Verdict;
    var phi_738_: evaluate_Verdict;
    var phi_739_: bool;
    var phi_743_: evaluate_Verdict;

    let _e47 = id_1;
    let _e54 = arrayLength((&map.member));
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e47, _e60, _e62);
    if (bitcast<i32>(_e63.word) != 0i) {
        let _e69 = p.member.projection;
        if (_e63.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e73 = lt_math_OneLevel(_e69);
        let _e77 = samples.member[(0u + _e63.shift)].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[(0u + _e63.shift)].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[(0u + _e63.shift)].normal[2u];
                let _e89 = global[2u];
                phi_231_ = (_e87 == _e89);
                phi_232_ = false;
            } else {
                phi_231_ = bool();
                phi_232_ = true;
            }
            let _e92 = phi_231_;
            let _e94 = phi_232_;
            phi_233_ = _e92;
            phi_234_ = _e94;
        } else {
            phi_233_ = bool();
            phi_234_ = true;
        }
        let _e96 = phi_233_;
        let _e98 = phi_234_;
        if _e98 {
            phi_238_ = false;
        } else {
            phi_238_ = _e96;
        }
        let _e100 = phi_238_;
        if !(_e100) {
            let _e103 = samples.member[(0u + _e63.shift)].position;
            let _e105 = p.member.light.place;
            let _e111 = p.member.light.place[3u];
            let _e118 = (_e105.x - (_e103.x * _e111));
            let _e119 = (_e105.y - (_e103.y * _e111));
            let _e120 = (_e105.z - (_e103.z * _e111));
            let _e122 = samples.member[(0u + _e63.shift)].normal;
            if ((((_e122.x * _e118) + (_e122.y * _e119)) + (_e122.z * _e120)) > 0f) {
                let _e136 = (((_e118 * _e118) + (_e119 * _e119)) + (_e120 * _e120));
                let _e138 = p.member.light.axis;
                let _e150 = p.member.light.place[3u];
                if (_e150 == 0f) {
                    phi_309_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_308_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_308_ = false;
                    }
                    let _e161 = phi_308_;
                    phi_309_ = _e161;
                }
                let _e163 = phi_309_;
                if _e163 {
                    let _e165 = samples.member[(0u + _e63.shift)].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_320_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_321_ = false;
                } else {
                    phi_320_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_321_ = true;
                }
                let _e184 = phi_320_;
                let _e186 = phi_321_;
                phi_322_ = _e184;
                phi_323_ = _e186;
            } else {
                phi_322_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_323_ = true;
            }
            let _e188 = phi_322_;
            let _e190 = phi_323_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_330_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_330_ = _e188;
            }
            let _e207 = phi_330_;
            phi_334_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_334_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_334_;
        if _e224.unnamed_1 {
            phi_737_ = evaluate_Verdict(_e224.unnamed.visibility, _e224.unnamed.is_doubted);
            phi_738_ = evaluate_Verdict();
            phi_739_ = true;
        } else {
            let _e232 = samples.member[(0u + _e63.shift)].position;
            let _e250 = ((((_e73.projection.row_w.x * _e232.x) + (_e73.projection.row_w.y * _e232.y)) + (_e73.projection.row_w.z * _e232.z)) + (_e73.projection.row_w.w * 1f));
            let _e264 = (((((_e73.projection.row_x.x * _e232.x) + (_e73.projection.row_x.y * _e232.y)) + (_e73.projection.row_x.z * _e232.z)) + (_e73.projection.row_x.w * 1f)) / _e250);
            let _e278 = (((((_e73.projection.row_y.x * _e232.x) + (_e73.projection.row_y.y * _e232.y)) + (_e73.projection.row_y.z * _e232.z)) + (_e73.projection.row_y.w * 1f)) / _e250);
            let _e291 = ((((_e73.projection.row_z.x * _e232.x) + (_e73.projection.row_z.y * _e232.y)) + (_e73.projection.row_z.z * _e232.z)) + (_e73.projection.row_z.w * 1f));
            if (_e250 > 0f) {
                if (_e264 >= 0f) {
                    phi_408_ = (_e264 <= 1f);
                } else {
                    phi_408_ = false;
                }
                let _e296 = phi_408_;
                if _e296 {
                    if (_e278 >= 0f) {
                        phi_417_ = (_e278 <= 1f);
                    } else {
                        phi_417_ = false;
                    }
                    let _e300 = phi_417_;
                    if _e300 {
                        if (_e291 >= 0f) {
                            phi_426_ = (_e291 <= 1f);
                        } else {
                            phi_426_ = false;
                        }
                        let _e304 = phi_426_;
                        phi_427_ = _e304;
                        phi_428_ = false;
                    } else {
                        phi_427_ = bool();
                        phi_428_ = true;
                    }
                    let _e306 = phi_427_;
                    let _e308 = phi_428_;
                    phi_429_ = _e306;
                    phi_430_ = _e308;
                } else {
                    phi_429_ = bool();
                    phi_430_ = true;
                }
                let _e310 = phi_429_;
                let _e312 = phi_430_;
                phi_431_ = _e310;
                phi_432_ = _e312;
            } else {
                phi_431_ = bool();
                phi_432_ = true;
            }
            let _e314 = phi_431_;
            let _e316 = phi_432_;
            if _e316 {
                phi_436_ = false;
            } else {
                phi_436_ = _e314;
            }
            let _e318 = phi_436_;
            if _e318 {
                if (0f > 0f) {
                    let _e321 = samples.member[(0u + _e63.shift)].normal;
                    let _e323 = p.member.map_size;
                    let _e393 = ((abs(((((_e69.row_x.x * _e321.x) + (_e69.row_x.y * _e321.y)) + (_e69.row_x.z * _e321.z)) / (((_e69.row_x.x * _e69.row_x.x) + (_e69.row_x.y * _e69.row_x.y)) + (_e69.row_x.z * _e69.row_x.z)))) + abs(((((_e69.row_y.x * _e321.x) + (_e69.row_y.y * _e321.y)) + (_e69.row_y.z * _e321.z)) / (((_e69.row_y.x * _e69.row_y.x) + (_e69.row_y.y * _e69.row_y.y)) + (_e69.row_y.z * _e69.row_y.z))))) / (abs(((((_e69.row_z.x * _e321.x) + (_e69.row_z.y * _e321.y)) + (_e69.row_z.z * _e321.z)) / (((_e69.row_z.x * _e69.row_z.x) + (_e69.row_z.y * _e69.row_z.y)) + (_e69.row_z.z * _e69.row_z.z)))) * f32(_e323)));
                    if (_e393 < 0.002f) {
                        phi_526_ = _e393;
                    } else {
                        phi_526_ = 0.002f;
                    }
                    let _e396 = phi_526_;
                    phi_529_ = (_e291 - (0f * _e396));
                } else {
                    phi_529_ = _e291;
                }
                let _e400 = phi_529_;
                let _e402 = p.member.map_size;
                let _e403 = f32(_e402);
                let _e406 = ((_e264 * _e403) - 0.5f);
                let _e407 = ((_e278 * _e403) - 0.5f);
                if (_e406 > -8388608f) {
                    let _e419 = f32(select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406)));
                    if (_e419 > _e406) {
                        phi_558_ = 1f;
                    } else {
                        phi_558_ = 0f;
                    }
                    let _e422 = phi_558_;
                    if (_e406 < 8388608f) {
                        phi_563_ = (_e419 - _e422);
                        phi_564_ = false;
                    } else {
                        phi_563_ = f32();
                        phi_564_ = true;
                    }
                    let _e425 = phi_563_;
                    let _e427 = phi_564_;
                    phi_565_ = _e425;
                    phi_566_ = _e427;
                } else {
                    phi_565_ = f32();
                    phi_566_ = true;
                }
                let _e429 = phi_565_;
                let _e431 = phi_566_;
                if _e431 {
                    phi_570_ = _e406;
                } else {
                    phi_570_ = _e429;
                }
                let _e433 = phi_570_;
                if (_e407 > -8388608f) {
                    let _e445 = f32(select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)));
                    if (_e445 > _e407) {
                        phi_590_ = 1f;
                    } else {
                        phi_590_ = 0f;
                    }
                    let _e448 = phi_590_;
                    if (_e407 < 8388608f) {
                        phi_595_ = (_e445 - _e448);
                        phi_596_ = false;
                    } else {
                        phi_595_ = f32();
                        phi_596_ = true;
                    }
                    let _e451 = phi_595_;
                    let _e453 = phi_596_;
                    phi_597_ = _e451;
                    phi_598_ = _e453;
                } else {
                    phi_597_ = f32();
                    phi_598_ = true;
                }
                let _e455 = phi_597_;
                let _e457 = phi_598_;
                if _e457 {
                    phi_602_ = _e407;
                } else {
                    phi_602_ = _e455;
                }
                let _e459 = phi_602_;
                let _e460 = (_e406 - _e433);
                let _e461 = (_e407 - _e459);
                let _e470 = select(0i, select(select(i32(_e433), i32(-2147483648), (_e433 < bitcast<f32>(3472883712u))), 2147483647i, (_e433 > bitcast<f32>(1325400063u))), (_e433 == _e433));
                let _e479 = select(0i, select(select(i32(_e459), i32(-2147483648), (_e459 < bitcast<f32>(3472883712u))), 2147483647i, (_e459 > bitcast<f32>(1325400063u))), (_e459 == _e459));
                let _e490 = p.member.test;
                let _e491 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e490);
                let _e493 = p.member.map_size;
                local = _e491;
                let _e495 = ((0u * _e493) * _e493);
                let _e497 = (bitcast<i32>(_e493) - 1i);
                if (_e470 > 0i) {
                    phi_650_ = _e470;
                } else {
                    phi_650_ = 0i;
                }
                let _e500 = phi_650_;
                if (_e479 > 0i) {
                    phi_655_ = _e479;
                } else {
                    phi_655_ = 0i;
                }
                let _e503 = phi_655_;
                if (_e500 < _e497) {
                    phi_660_ = _e500;
                } else {
                    phi_660_ = _e497;
                }
                let _e506 = phi_660_;
                if (_e503 < _e497) {
                    phi_665_ = _e503;
                } else {
                    phi_665_ = _e497;
                }
                let _e509 = phi_665_;
                let _e510 = bitcast<u32>(_e506);
                let _e512 = (_e470 + 1i);
                let _e513 = (_e479 + 1i);
                if (_e512 > 0i) {
                    phi_674_ = _e512;
                } else {
                    phi_674_ = 0i;
                }
                let _e516 = phi_674_;
                if (_e513 > 0i) {
                    phi_679_ = _e513;
                } else {
                    phi_679_ = 0i;
                }
                let _e519 = phi_679_;
                if (_e516 < _e497) {
                    phi_684_ = _e516;
                } else {
                    phi_684_ = _e497;
                }
                let _e522 = phi_684_;
                if (_e519 < _e497) {
                    phi_689_ = _e519;
                } else {
                    phi_689_ = _e497;
                }
                let _e525 = phi_689_;
                let _e526 = bitcast<u32>(_e522);
                let _e528 = (bitcast<u32>(_e509) * _e493);
                let _e529 = (bitcast<u32>(_e525) * _e493);
                let _e534 = ((_e528 + _e510) + _e495);
                let _e535 = ((_e528 + _e526) + _e495);
                let _e536 = ((_e529 + _e510) + _e495);
                let _e537 = ((_e529 + _e526) + _e495);
                if (_e534 < _e54) {
                } else {
                    return;
                }
                let _e541 = map.member[(0u + _e534)];
                if (_e535 < _e54) {
                } else {
                    return;
                }
                let _e545 = map.member[(0u + _e535)];
                if (_e536 < _e54) {
                } else {
                    return;
                }
                let _e549 = map.member[(0u + _e536)];
                if (_e537 < _e54) {
                } else {
                    return;
                }
                let _e553 = map.member[(0u + _e537)];
                let _e555 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e541, _e545, _e549, _e553), vec4<f32>(((1f - _e460) * (1f - _e461)), (_e460 * (1f - _e461)), ((1f - _e460) * _e461), (_e460 * _e461)), _e400);
                phi_734_ = evaluate_Verdict(_e555, false);
                phi_735_ = evaluate_Verdict();
                phi_736_ = false;
            } else {
                phi_734_ = evaluate_Verdict();
                phi_735_ = evaluate_Verdict(1f, false);
                phi_736_ = true;
            }
            let _e559 = phi_734_;
            let _e561 = phi_735_;
            let _e563 = phi_736_;
            phi_737_ = _e561;
            phi_738_ = _e559;
            phi_739_ = _e563;
        }
        let _e565 = phi_737_;
        let _e567 = phi_738_;
        let _e569 = phi_739_;
        if _e569 {
            phi_743_ = _e565;
        } else {
            phi_743_ = _e567;
        }
        let _e571 = phi_743_;
        if (_e63.shift < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.shift)] = _e571.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
