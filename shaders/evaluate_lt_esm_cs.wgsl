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
    var phi_144_: lt_mask_LightPlace;
    var phi_145_: bool;
    var phi_146_: lt_mask_LightPlace;
    var phi_147_: bool;
    var phi_152_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_144_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_145_ = false;
        } else {
            phi_144_ = lt_mask_LightPlace();
            phi_145_ = true;
        }
        let _e59 = phi_144_;
        let _e61 = phi_145_;
        phi_146_ = _e59;
        phi_147_ = _e61;
    } else {
        phi_146_ = lt_mask_LightPlace();
        phi_147_ = true;
    }
    let _e63 = phi_146_;
    let _e65 = phi_147_;
    if _e65 {
        phi_152_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_152_ = _e63;
    }
    let _e70 = phi_152_;
    return lt_mask_LightPlace(_e70.word, _e70.shift);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_172_: bool;
    var phi_176_: f32;

    let _e47 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_172_ = true;
    } else {
        let _e51 = (84f < _e47);
        if _e51 {
        }
        phi_172_ = _e51;
    }
    let _e53 = phi_172_;
    if _e53 {
        phi_176_ = 84f;
    } else {
        phi_176_ = _e47;
    }
    let _e55 = phi_176_;
    return _e55;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_197_: f32;
    var phi_198_: f32;
    var phi_199_: f32;
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_217_: f32;
    var phi_233_: f32;
    var phi_234_: f32;
    var phi_235_: f32;
    var phi_251_: f32;
    var phi_252_: f32;
    var phi_253_: f32;
    var phi_269_: f32;
    var phi_270_: f32;
    var phi_271_: f32;
    var phi_290_: f32;
    var phi_295_: f32;
    var phi_317_: f32;
    var phi_322_: f32;
    var phi_323_: bool;
    var phi_324_: f32;
    var phi_325_: bool;
    var phi_329_: f32;
    var phi_367_: f32;
    var phi_378_: f32;
    var phi_383_: f32;
    var phi_405_: f32;
    var phi_410_: f32;
    var phi_411_: bool;
    var phi_412_: f32;
    var phi_413_: bool;
    var phi_417_: f32;
    var phi_455_: f32;
    var phi_466_: f32;
    var phi_471_: f32;
    var phi_493_: f32;
    var phi_498_: f32;
    var phi_499_: bool;
    var phi_500_: f32;
    var phi_501_: bool;
    var phi_505_: f32;
    var phi_543_: f32;
    var phi_554_: f32;
    var phi_559_: f32;
    var phi_581_: f32;
    var phi_586_: f32;
    var phi_587_: bool;
    var phi_588_: f32;
    var phi_589_: bool;
    var phi_593_: f32;
    var phi_631_: f32;
    var phi_657_: f32;
    var phi_658_: f32;
    var phi_659_: f32;

    let _e50 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_199_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_198_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_197_ = 1f;
            } else {
                phi_197_ = param_8;
            }
            let _e57 = phi_197_;
            phi_198_ = _e57;
        }
        let _e59 = phi_198_;
        phi_199_ = _e59;
    }
    let _e61 = phi_199_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_217_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_216_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_215_ = 1f;
            } else {
                phi_215_ = param_6.x;
            }
            let _e69 = phi_215_;
            phi_216_ = _e69;
        }
        let _e71 = phi_216_;
        phi_217_ = _e71;
    }
    let _e73 = phi_217_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_235_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_234_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_233_ = 1f;
            } else {
                phi_233_ = param_6.y;
            }
            let _e81 = phi_233_;
            phi_234_ = _e81;
        }
        let _e83 = phi_234_;
        phi_235_ = _e83;
    }
    let _e85 = phi_235_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_253_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_252_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_251_ = 1f;
            } else {
                phi_251_ = param_6.z;
            }
            let _e93 = phi_251_;
            phi_252_ = _e93;
        }
        let _e95 = phi_252_;
        phi_253_ = _e95;
    }
    let _e97 = phi_253_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_271_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_270_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_269_ = 1f;
            } else {
                phi_269_ = param_6.w;
            }
            let _e105 = phi_269_;
            phi_270_ = _e105;
        }
        let _e107 = phi_270_;
        phi_271_ = _e107;
    }
    let _e109 = phi_271_;
    let _e114 = (_e50 * (_e73 - _e61));
    let _e115 = (_e50 * (_e85 - _e61));
    let _e116 = (_e50 * (_e97 - _e61));
    let _e117 = (_e50 * (_e109 - _e61));
    if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
        phi_367_ = _e114;
    } else {
        if (_e114 < -87f) {
            phi_290_ = -87f;
        } else {
            phi_290_ = _e114;
        }
        let _e123 = phi_290_;
        if (_e123 > 88f) {
            phi_295_ = 88f;
        } else {
            phi_295_ = _e123;
        }
        let _e126 = phi_295_;
        let _e128 = ((_e126 * 1.442695f) + 0.5f);
        if (_e128 > -8388608f) {
            let _e140 = f32(select(0i, select(select(i32(_e128), i32(-2147483648), (_e128 < bitcast<f32>(3472883712u))), 2147483647i, (_e128 > bitcast<f32>(1325400063u))), (_e128 == _e128)));
            if (_e140 > _e128) {
                phi_317_ = 1f;
            } else {
                phi_317_ = 0f;
            }
            let _e143 = phi_317_;
            if (_e128 < 8388608f) {
                phi_322_ = (_e140 - _e143);
                phi_323_ = false;
            } else {
                phi_322_ = f32();
                phi_323_ = true;
            }
            let _e146 = phi_322_;
            let _e148 = phi_323_;
            phi_324_ = _e146;
            phi_325_ = _e148;
        } else {
            phi_324_ = f32();
            phi_325_ = true;
        }
        let _e150 = phi_324_;
        let _e152 = phi_325_;
        if _e152 {
            phi_329_ = _e128;
        } else {
            phi_329_ = _e150;
        }
        let _e154 = phi_329_;
        let _e158 = ((_e126 - (_e154 * 0.69314575f)) - (_e154 * 0.0000014286068f));
        phi_367_ = ((((((((((((((((1f / 5040f) * _e158) + (1f / 720f)) * _e158) + (1f / 120f)) * _e158) + (1f / 24f)) * _e158) + (1f / 6f)) * _e158) + 0.5f) * _e158) + 1f) * _e158) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e154), i32(-2147483648), (_e154 < bitcast<f32>(3472883712u))), 2147483647i, (_e154 > bitcast<f32>(1325400063u))), (_e154 == _e154)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e194 = phi_367_;
    if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
        phi_455_ = _e115;
    } else {
        if (_e115 < -87f) {
            phi_378_ = -87f;
        } else {
            phi_378_ = _e115;
        }
        let _e200 = phi_378_;
        if (_e200 > 88f) {
            phi_383_ = 88f;
        } else {
            phi_383_ = _e200;
        }
        let _e203 = phi_383_;
        let _e205 = ((_e203 * 1.442695f) + 0.5f);
        if (_e205 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(_e205), i32(-2147483648), (_e205 < bitcast<f32>(3472883712u))), 2147483647i, (_e205 > bitcast<f32>(1325400063u))), (_e205 == _e205)));
            if (_e217 > _e205) {
                phi_405_ = 1f;
            } else {
                phi_405_ = 0f;
            }
            let _e220 = phi_405_;
            if (_e205 < 8388608f) {
                phi_410_ = (_e217 - _e220);
                phi_411_ = false;
            } else {
                phi_410_ = f32();
                phi_411_ = true;
            }
            let _e223 = phi_410_;
            let _e225 = phi_411_;
            phi_412_ = _e223;
            phi_413_ = _e225;
        } else {
            phi_412_ = f32();
            phi_413_ = true;
        }
        let _e227 = phi_412_;
        let _e229 = phi_413_;
        if _e229 {
            phi_417_ = _e205;
        } else {
            phi_417_ = _e227;
        }
        let _e231 = phi_417_;
        let _e235 = ((_e203 - (_e231 * 0.69314575f)) - (_e231 * 0.0000014286068f));
        phi_455_ = ((((((((((((((((1f / 5040f) * _e235) + (1f / 720f)) * _e235) + (1f / 120f)) * _e235) + (1f / 24f)) * _e235) + (1f / 6f)) * _e235) + 0.5f) * _e235) + 1f) * _e235) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e231), i32(-2147483648), (_e231 < bitcast<f32>(3472883712u))), 2147483647i, (_e231 > bitcast<f32>(1325400063u))), (_e231 == _e231)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e271 = phi_455_;
    if ((bitcast<u32>(_e116) & 2147483647u) > 2139095040u) {
        phi_543_ = _e116;
    } else {
        if (_e116 < -87f) {
            phi_466_ = -87f;
        } else {
            phi_466_ = _e116;
        }
        let _e277 = phi_466_;
        if (_e277 > 88f) {
            phi_471_ = 88f;
        } else {
            phi_471_ = _e277;
        }
        let _e280 = phi_471_;
        let _e282 = ((_e280 * 1.442695f) + 0.5f);
        if (_e282 > -8388608f) {
            let _e294 = f32(select(0i, select(select(i32(_e282), i32(-2147483648), (_e282 < bitcast<f32>(3472883712u))), 2147483647i, (_e282 > bitcast<f32>(1325400063u))), (_e282 == _e282)));
            if (_e294 > _e282) {
                phi_493_ = 1f;
            } else {
                phi_493_ = 0f;
            }
            let _e297 = phi_493_;
            if (_e282 < 8388608f) {
                phi_498_ = (_e294 - _e297);
                phi_499_ = false;
            } else {
                phi_498_ = f32();
                phi_499_ = true;
            }
            let _e300 = phi_498_;
            let _e302 = phi_499_;
            phi_500_ = _e300;
            phi_501_ = _e302;
        } else {
            phi_500_ = f32();
            phi_501_ = true;
        }
        let _e304 = phi_500_;
        let _e306 = phi_501_;
        if _e306 {
            phi_505_ = _e282;
        } else {
            phi_505_ = _e304;
        }
        let _e308 = phi_505_;
        let _e312 = ((_e280 - (_e308 * 0.69314575f)) - (_e308 * 0.0000014286068f));
        phi_543_ = ((((((((((((((((1f / 5040f) * _e312) + (1f / 720f)) * _e312) + (1f / 120f)) * _e312) + (1f / 24f)) * _e312) + (1f / 6f)) * _e312) + 0.5f) * _e312) + 1f) * _e312) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e308), i32(-2147483648), (_e308 < bitcast<f32>(3472883712u))), 2147483647i, (_e308 > bitcast<f32>(1325400063u))), (_e308 == _e308)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e348 = phi_543_;
    if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
        phi_631_ = _e117;
    } else {
        if (_e117 < -87f) {
            phi_554_ = -87f;
        } else {
            phi_554_ = _e117;
        }
        let _e354 = phi_554_;
        if (_e354 > 88f) {
            phi_559_ = 88f;
        } else {
            phi_559_ = _e354;
        }
        let _e357 = phi_559_;
        let _e359 = ((_e357 * 1.442695f) + 0.5f);
        if (_e359 > -8388608f) {
            let _e371 = f32(select(0i, select(select(i32(_e359), i32(-2147483648), (_e359 < bitcast<f32>(3472883712u))), 2147483647i, (_e359 > bitcast<f32>(1325400063u))), (_e359 == _e359)));
            if (_e371 > _e359) {
                phi_581_ = 1f;
            } else {
                phi_581_ = 0f;
            }
            let _e374 = phi_581_;
            if (_e359 < 8388608f) {
                phi_586_ = (_e371 - _e374);
                phi_587_ = false;
            } else {
                phi_586_ = f32();
                phi_587_ = true;
            }
            let _e377 = phi_586_;
            let _e379 = phi_587_;
            phi_588_ = _e377;
            phi_589_ = _e379;
        } else {
            phi_588_ = f32();
            phi_589_ = true;
        }
        let _e381 = phi_588_;
        let _e383 = phi_589_;
        if _e383 {
            phi_593_ = _e359;
        } else {
            phi_593_ = _e381;
        }
        let _e385 = phi_593_;
        let _e389 = ((_e357 - (_e385 * 0.69314575f)) - (_e385 * 0.0000014286068f));
        phi_631_ = ((((((((((((((((1f / 5040f) * _e389) + (1f / 720f)) * _e389) + (1f / 120f)) * _e389) + (1f / 24f)) * _e389) + (1f / 6f)) * _e389) + 0.5f) * _e389) + 1f) * _e389) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e385), i32(-2147483648), (_e385 < bitcast<f32>(3472883712u))), 2147483647i, (_e385 > bitcast<f32>(1325400063u))), (_e385 == _e385)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e425 = phi_631_;
    let _e436 = ((((_e194 * param_7.x) + (_e271 * param_7.y)) + (_e348 * param_7.z)) + (_e425 * param_7.w));
    if ((bitcast<u32>(_e436) & 2147483647u) > 2139095040u) {
        phi_659_ = _e436;
    } else {
        if (_e436 < 0f) {
            phi_658_ = 0f;
        } else {
            if (_e436 > 1f) {
                phi_657_ = 1f;
            } else {
                phi_657_ = _e436;
            }
            let _e443 = phi_657_;
            phi_658_ = _e443;
        }
        let _e445 = phi_658_;
        phi_659_ = _e445;
    }
    let _e447 = phi_659_;
    return _e447;
}

fn function_() {
    var local: f32;
    var phi_715_: bool;
    var phi_716_: bool;
    var phi_717_: bool;
    var phi_718_: bool;
    var phi_722_: bool;
    var phi_792_: bool;
    var phi_793_: bool;
    var phi_804_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_805_: bool;
    var phi_806_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_807_: bool;
    var phi_814_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_818_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_892_: bool;
    var phi_901_: bool;
    var phi_910_: bool;
    var phi_911_: bool;
    var phi_912_: bool;
    var phi_913_: bool;
    var phi_914_: bool;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_920_: bool;
    var phi_1010_: f32;
    var phi_1013_: f32;
    var phi_1042_: f32;
    var phi_1047_: f32;
    var phi_1048_: bool;
    var phi_1049_: f32;
    var phi_1050_: bool;
    var phi_1054_: f32;
    var phi_1074_: f32;
    var phi_1079_: f32;
    var phi_1080_: bool;
    var phi_1081_: f32;
    var phi_1082_: bool;
    var phi_1086_: f32;
    var phi_1134_: i32;
    var phi_1139_: i32;
    var phi_1144_: i32;
    var phi_1149_: i32;
    var phi_1158_: i32;
    var phi_1163_: i32;
    var phi_1168_: i32;
    var phi_1173_: i32;
    var phi_1224_: bool;
    var phi_1232_: bool;
    var phi_1244_: bool;
    var phi_1245_: bool;
    var phi_1249_: f32;
    var phi_1255_: f32;
    var phi_1257_: evaluate_Verdict;
    var phi_1262_: evaluate_Verdict;
    var phi_1263_: evaluate_Verdict;

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
                phi_715_ = (_e87 == _e89);
                phi_716_ = false;
            } else {
                phi_715_ = bool();
                phi_716_ = true;
            }
            let _e92 = phi_715_;
            let _e94 = phi_716_;
            phi_717_ = _e92;
            phi_718_ = _e94;
        } else {
            phi_717_ = bool();
            phi_718_ = true;
        }
        let _e96 = phi_717_;
        let _e98 = phi_718_;
        if _e98 {
            phi_722_ = false;
        } else {
            phi_722_ = _e96;
        }
        let _e100 = phi_722_;
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
                    phi_793_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_792_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_792_ = false;
                    }
                    let _e161 = phi_792_;
                    phi_793_ = _e161;
                }
                let _e163 = phi_793_;
                if _e163 {
                    let _e165 = samples.member[(0u + _e63.shift)].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_804_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_805_ = false;
                } else {
                    phi_804_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_805_ = true;
                }
                let _e184 = phi_804_;
                let _e186 = phi_805_;
                phi_806_ = _e184;
                phi_807_ = _e186;
            } else {
                phi_806_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_807_ = true;
            }
            let _e188 = phi_806_;
            let _e190 = phi_807_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_814_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_814_ = _e188;
            }
            let _e207 = phi_814_;
            phi_818_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_818_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_818_;
        if _e224.unnamed_1 {
            phi_1263_ = evaluate_Verdict(_e224.unnamed.visibility, _e224.unnamed.is_doubted);
        } else {
            let _e232 = samples.member[(0u + _e63.shift)].position;
            let _e250 = ((((_e73.projection.row_w.x * _e232.x) + (_e73.projection.row_w.y * _e232.y)) + (_e73.projection.row_w.z * _e232.z)) + (_e73.projection.row_w.w * 1f));
            let _e264 = (((((_e73.projection.row_x.x * _e232.x) + (_e73.projection.row_x.y * _e232.y)) + (_e73.projection.row_x.z * _e232.z)) + (_e73.projection.row_x.w * 1f)) / _e250);
            let _e278 = (((((_e73.projection.row_y.x * _e232.x) + (_e73.projection.row_y.y * _e232.y)) + (_e73.projection.row_y.z * _e232.z)) + (_e73.projection.row_y.w * 1f)) / _e250);
            let _e291 = ((((_e73.projection.row_z.x * _e232.x) + (_e73.projection.row_z.y * _e232.y)) + (_e73.projection.row_z.z * _e232.z)) + (_e73.projection.row_z.w * 1f));
            if (_e250 > 0f) {
                if (_e264 >= 0f) {
                    phi_892_ = (_e264 <= 1f);
                } else {
                    phi_892_ = false;
                }
                let _e296 = phi_892_;
                if _e296 {
                    if (_e278 >= 0f) {
                        phi_901_ = (_e278 <= 1f);
                    } else {
                        phi_901_ = false;
                    }
                    let _e300 = phi_901_;
                    if _e300 {
                        if (_e291 >= 0f) {
                            phi_910_ = (_e291 <= 1f);
                        } else {
                            phi_910_ = false;
                        }
                        let _e304 = phi_910_;
                        phi_911_ = _e304;
                        phi_912_ = false;
                    } else {
                        phi_911_ = bool();
                        phi_912_ = true;
                    }
                    let _e306 = phi_911_;
                    let _e308 = phi_912_;
                    phi_913_ = _e306;
                    phi_914_ = _e308;
                } else {
                    phi_913_ = bool();
                    phi_914_ = true;
                }
                let _e310 = phi_913_;
                let _e312 = phi_914_;
                phi_915_ = _e310;
                phi_916_ = _e312;
            } else {
                phi_915_ = bool();
                phi_916_ = true;
            }
            let _e314 = phi_915_;
            let _e316 = phi_916_;
            if _e316 {
                phi_920_ = false;
            } else {
                phi_920_ = _e314;
            }
            let _e318 = phi_920_;
            if _e318 {
                if (0f > 0f) {
                    let _e321 = samples.member[(0u + _e63.shift)].normal;
                    let _e323 = p.member.map_size;
                    let _e393 = ((abs(((((_e69.row_x.x * _e321.x) + (_e69.row_x.y * _e321.y)) + (_e69.row_x.z * _e321.z)) / (((_e69.row_x.x * _e69.row_x.x) + (_e69.row_x.y * _e69.row_x.y)) + (_e69.row_x.z * _e69.row_x.z)))) + abs(((((_e69.row_y.x * _e321.x) + (_e69.row_y.y * _e321.y)) + (_e69.row_y.z * _e321.z)) / (((_e69.row_y.x * _e69.row_y.x) + (_e69.row_y.y * _e69.row_y.y)) + (_e69.row_y.z * _e69.row_y.z))))) / (abs(((((_e69.row_z.x * _e321.x) + (_e69.row_z.y * _e321.y)) + (_e69.row_z.z * _e321.z)) / (((_e69.row_z.x * _e69.row_z.x) + (_e69.row_z.y * _e69.row_z.y)) + (_e69.row_z.z * _e69.row_z.z)))) * f32(_e323)));
                    if (_e393 < 0.002f) {
                        phi_1010_ = _e393;
                    } else {
                        phi_1010_ = 0.002f;
                    }
                    let _e396 = phi_1010_;
                    phi_1013_ = (_e291 - (0f * _e396));
                } else {
                    phi_1013_ = _e291;
                }
                let _e400 = phi_1013_;
                let _e402 = p.member.map_size;
                let _e403 = f32(_e402);
                let _e406 = ((_e264 * _e403) - 0.5f);
                let _e407 = ((_e278 * _e403) - 0.5f);
                if (_e406 > -8388608f) {
                    let _e419 = f32(select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406)));
                    if (_e419 > _e406) {
                        phi_1042_ = 1f;
                    } else {
                        phi_1042_ = 0f;
                    }
                    let _e422 = phi_1042_;
                    if (_e406 < 8388608f) {
                        phi_1047_ = (_e419 - _e422);
                        phi_1048_ = false;
                    } else {
                        phi_1047_ = f32();
                        phi_1048_ = true;
                    }
                    let _e425 = phi_1047_;
                    let _e427 = phi_1048_;
                    phi_1049_ = _e425;
                    phi_1050_ = _e427;
                } else {
                    phi_1049_ = f32();
                    phi_1050_ = true;
                }
                let _e429 = phi_1049_;
                let _e431 = phi_1050_;
                if _e431 {
                    phi_1054_ = _e406;
                } else {
                    phi_1054_ = _e429;
                }
                let _e433 = phi_1054_;
                if (_e407 > -8388608f) {
                    let _e445 = f32(select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)));
                    if (_e445 > _e407) {
                        phi_1074_ = 1f;
                    } else {
                        phi_1074_ = 0f;
                    }
                    let _e448 = phi_1074_;
                    if (_e407 < 8388608f) {
                        phi_1079_ = (_e445 - _e448);
                        phi_1080_ = false;
                    } else {
                        phi_1079_ = f32();
                        phi_1080_ = true;
                    }
                    let _e451 = phi_1079_;
                    let _e453 = phi_1080_;
                    phi_1081_ = _e451;
                    phi_1082_ = _e453;
                } else {
                    phi_1081_ = f32();
                    phi_1082_ = true;
                }
                let _e455 = phi_1081_;
                let _e457 = phi_1082_;
                if _e457 {
                    phi_1086_ = _e407;
                } else {
                    phi_1086_ = _e455;
                }
                let _e459 = phi_1086_;
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
                    phi_1134_ = _e470;
                } else {
                    phi_1134_ = 0i;
                }
                let _e500 = phi_1134_;
                if (_e479 > 0i) {
                    phi_1139_ = _e479;
                } else {
                    phi_1139_ = 0i;
                }
                let _e503 = phi_1139_;
                if (_e500 < _e497) {
                    phi_1144_ = _e500;
                } else {
                    phi_1144_ = _e497;
                }
                let _e506 = phi_1144_;
                if (_e503 < _e497) {
                    phi_1149_ = _e503;
                } else {
                    phi_1149_ = _e497;
                }
                let _e509 = phi_1149_;
                let _e510 = bitcast<u32>(_e506);
                let _e512 = (_e470 + 1i);
                let _e513 = (_e479 + 1i);
                if (_e512 > 0i) {
                    phi_1158_ = _e512;
                } else {
                    phi_1158_ = 0i;
                }
                let _e516 = phi_1158_;
                if (_e513 > 0i) {
                    phi_1163_ = _e513;
                } else {
                    phi_1163_ = 0i;
                }
                let _e519 = phi_1163_;
                if (_e516 < _e497) {
                    phi_1168_ = _e516;
                } else {
                    phi_1168_ = _e497;
                }
                let _e522 = phi_1168_;
                if (_e519 < _e497) {
                    phi_1173_ = _e519;
                } else {
                    phi_1173_ = _e497;
                }
                let _e525 = phi_1173_;
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
                let _e557 = p.member.epsilon;
                if (_e555 <= _e557) {
                    phi_1224_ = true;
                } else {
                    phi_1224_ = (_e555 >= (1f - _e557));
                }
                let _e562 = phi_1224_;
                if ((bitcast<u32>(_e555) & 2147483647u) > 2139095040u) {
                    phi_1232_ = true;
                } else {
                    phi_1232_ = !(_e562);
                }
                let _e568 = phi_1232_;
                if _e568 {
                    if (_e555 > 0f) {
                        if (_e555 < 1f) {
                            phi_1244_ = false;
                        } else {
                            phi_1244_ = true;
                        }
                        let _e572 = phi_1244_;
                        phi_1245_ = _e572;
                    } else {
                        phi_1245_ = true;
                    }
                    let _e574 = phi_1245_;
                    if _e574 {
                        phi_1249_ = 0.5f;
                    } else {
                        phi_1249_ = _e555;
                    }
                    let _e576 = phi_1249_;
                    phi_1257_ = evaluate_Verdict(_e576, true);
                } else {
                    if (_e555 > 0.5f) {
                        phi_1255_ = 1f;
                    } else {
                        phi_1255_ = 0f;
                    }
                    let _e580 = phi_1255_;
                    phi_1257_ = evaluate_Verdict(_e580, false);
                }
                let _e583 = phi_1257_;
                phi_1262_ = evaluate_Verdict(_e583.visibility, _e583.is_doubted);
            } else {
                phi_1262_ = evaluate_Verdict(0.5f, true);
            }
            let _e589 = phi_1262_;
            phi_1263_ = _e589;
        }
        let _e591 = phi_1263_;
        if (_e63.shift < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.shift)] = _e591.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
