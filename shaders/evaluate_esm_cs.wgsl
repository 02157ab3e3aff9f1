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

struct type_27 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_27;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_137_: lt_bvh_traverse_Tree;
    var phi_138_: bool;
    var phi_139_: lt_bvh_traverse_Tree;
    var phi_140_: bool;
    var phi_145_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_137_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_138_ = false;
        } else {
            phi_137_ = lt_bvh_traverse_Tree();
            phi_138_ = true;
        }
        let _e59 = phi_137_;
        let _e61 = phi_138_;
        phi_139_ = _e59;
        phi_140_ = _e61;
    } else {
        phi_139_ = lt_bvh_traverse_Tree();
        phi_140_ = true;
    }
    let _e63 = phi_139_;
    let _e65 = phi_140_;
    if _e65 {
        phi_145_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_145_ = _e63;
    }
    let _e70 = phi_145_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_165_: bool;
    var phi_169_: f32;

    let _e47 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_165_ = true;
    } else {
        let _e51 = (84f < _e47);
        if _e51 {
        }
        phi_165_ = _e51;
    }
    let _e53 = phi_165_;
    if _e53 {
        phi_169_ = 84f;
    } else {
        phi_169_ = _e47;
    }
    let _e55 = phi_169_;
    return _e55;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_716_: f32;
    var phi_717_: f32;
    var phi_718_: f32;
    var phi_734_: f32;
    var phi_735_: f32;
    var phi_736_: f32;
    var phi_752_: f32;
    var phi_753_: f32;
    var phi_754_: f32;
    var phi_770_: f32;
    var phi_771_: f32;
    var phi_772_: f32;
    var phi_788_: f32;
    var phi_789_: f32;
    var phi_790_: f32;
    var phi_809_: f32;
    var phi_814_: f32;
    var phi_836_: f32;
    var phi_841_: f32;
    var phi_842_: bool;
    var phi_843_: f32;
    var phi_844_: bool;
    var phi_848_: f32;
    var phi_886_: f32;
    var phi_897_: f32;
    var phi_902_: f32;
    var phi_924_: f32;
    var phi_929_: f32;
    var phi_930_: bool;
    var phi_931_: f32;
    var phi_932_: bool;
    var phi_936_: f32;
    var phi_974_: f32;
    var phi_985_: f32;
    var phi_990_: f32;
    var phi_1012_: f32;
    var phi_1017_: f32;
    var phi_1018_: bool;
    var phi_1019_: f32;
    var phi_1020_: bool;
    var phi_1024_: f32;
    var phi_1062_: f32;
    var phi_1073_: f32;
    var phi_1078_: f32;
    var phi_1100_: f32;
    var phi_1105_: f32;
    var phi_1106_: bool;
    var phi_1107_: f32;
    var phi_1108_: bool;
    var phi_1112_: f32;
    var phi_1150_: f32;
    var phi_1176_: f32;
    var phi_1177_: f32;
    var phi_1178_: f32;

    let _e50 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_718_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_717_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_716_ = 1f;
            } else {
                phi_716_ = param_8;
            }
            let _e57 = phi_716_;
            phi_717_ = _e57;
        }
        let _e59 = phi_717_;
        phi_718_ = _e59;
    }
    let _e61 = phi_718_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_736_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_735_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_734_ = 1f;
            } else {
                phi_734_ = param_6.x;
            }
            let _e69 = phi_734_;
            phi_735_ = _e69;
        }
        let _e71 = phi_735_;
        phi_736_ = _e71;
    }
    let _e73 = phi_736_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_754_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_753_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_752_ = 1f;
            } else {
                phi_752_ = param_6.y;
            }
            let _e81 = phi_752_;
            phi_753_ = _e81;
        }
        let _e83 = phi_753_;
        phi_754_ = _e83;
    }
    let _e85 = phi_754_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_772_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_771_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_770_ = 1f;
            } else {
                phi_770_ = param_6.z;
            }
            let _e93 = phi_770_;
            phi_771_ = _e93;
        }
        let _e95 = phi_771_;
        phi_772_ = _e95;
    }
    let _e97 = phi_772_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_790_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_789_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_788_ = 1f;
            } else {
                phi_788_ = param_6.w;
            }
            let _e105 = phi_788_;
            phi_789_ = _e105;
        }
        let _e107 = phi_789_;
        phi_790_ = _e107;
    }
    let _e109 = phi_790_;
    let _e114 = (_e50 * (_e73 - _e61));
    let _e115 = (_e50 * (_e85 - _e61));
    let _e116 = (_e50 * (_e97 - _e61));
    let _e117 = (_e50 * (_e109 - _e61));
    if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
        phi_886_ = _e114;
    } else {
        if (_e114 < -87f) {
            phi_809_ = -87f;
        } else {
            phi_809_ = _e114;
        }
        let _e123 = phi_809_;
        if (_e123 > 88f) {
            phi_814_ = 88f;
        } else {
            phi_814_ = _e123;
        }
        let _e126 = phi_814_;
        let _e128 = ((_e126 * 1.442695f) + 0.5f);
        if (_e128 > -8388608f) {
            let _e140 = f32(select(0i, select(select(i32(_e128), i32(-2147483648), (_e128 < bitcast<f32>(3472883712u))), 2147483647i, (_e128 > bitcast<f32>(1325400063u))), (_e128 == _e128)));
            if (_e140 > _e128) {
                phi_836_ = 1f;
            } else {
                phi_836_ = 0f;
            }
            let _e143 = phi_836_;
            if (_e128 < 8388608f) {
                phi_841_ = (_e140 - _e143);
                phi_842_ = false;
            } else {
                phi_841_ = f32();
                phi_842_ = true;
            }
            let _e146 = phi_841_;
            let _e148 = phi_842_;
            phi_843_ = _e146;
            phi_844_ = _e148;
        } else {
            phi_843_ = f32();
            phi_844_ = true;
        }
        let _e150 = phi_843_;
        let _e152 = phi_844_;
        if _e152 {
            phi_848_ = _e128;
        } else {
            phi_848_ = _e150;
        }
        let _e154 = phi_848_;
        let _e158 = ((_e126 - (_e154 * 0.69314575f)) - (_e154 * 0.0000014286068f));
        phi_886_ = ((((((((((((((((1f / 5040f) * _e158) + (1f / 720f)) * _e158) + (1f / 120f)) * _e158) + (1f / 24f)) * _e158) + (1f / 6f)) * _e158) + 0.5f) * _e158) + 1f) * _e158) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e154), i32(-2147483648), (_e154 < bitcast<f32>(3472883712u))), 2147483647i, (_e154 > bitcast<f32>(1325400063u))), (_e154 == _e154)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e194 = phi_886_;
    if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
        phi_974_ = _e115;
    } else {
        if (_e115 < -87f) {
            phi_897_ = -87f;
        } else {
            phi_897_ = _e115;
        }
        let _e200 = phi_897_;
        if (_e200 > 88f) {
            phi_902_ = 88f;
        } else {
            phi_902_ = _e200;
        }
        let _e203 = phi_902_;
        let _e205 = ((_e203 * 1.442695f) + 0.5f);
        if (_e205 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(_e205), i32(-2147483648), (_e205 < bitcast<f32>(3472883712u))), 2147483647i, (_e205 > bitcast<f32>(1325400063u))), (_e205 == _e205)));
            if (_e217 > _e205) {
                phi_924_ = 1f;
            } else {
                phi_924_ = 0f;
            }
            let _e220 = phi_924_;
            if (_e205 < 8388608f) {
                phi_929_ = (_e217 - _e220);
                phi_930_ = false;
            } else {
                phi_929_ = f32();
                phi_930_ = true;
            }
            let _e223 = phi_929_;
            let _e225 = phi_930_;
            phi_931_ = _e223;
            phi_932_ = _e225;
        } else {
            phi_931_ = f32();
            phi_932_ = true;
        }
        let _e227 = phi_931_;
        let _e229 = phi_932_;
        if _e229 {
            phi_936_ = _e205;
        } else {
            phi_936_ = _e227;
        }
        let _e231 = phi_936_;
        let _e235 = ((_e203 - (_e231 * 0.69314575f)) - (_e231 * 0.0000014286068f));
        phi_974_ = ((((((((((((((((1f / 5040f) * _e235) + (1f / 720f)) * _e235) + (1f / 120f)) * _e235) + (1f / 24f)) * _e235) + (1f / 6f)) * _e235) + 0.5f) * _e235) + 1f) * _e235) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e231), i32(-2147483648), (_e231 < bitcast<f32>(3472883712u))), 2147483647i, (_e231 > bitcast<f32>(1325400063u))), (_e231 == _e231)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e271 = phi_974_;
    if ((bitcast<u32>(_e116) & 2147483647u) > 2139095040u) {
        phi_1062_ = _e116;
    } else {
        if (_e116 < -87f) {
            phi_985_ = -87f;
        } else {
            phi_985_ = _e116;
        }
        let _e277 = phi_985_;
        if (_e277 > 88f) {
            phi_990_ = 88f;
        } else {
            phi_990_ = _e277;
        }
        let _e280 = phi_990_;
        let _e282 = ((_e280 * 1.442695f) + 0.5f);
        if (_e282 > -8388608f) {
            let _e294 = f32(select(0i, select(select(i32(_e282), i32(-2147483648), (_e282 < bitcast<f32>(3472883712u))), 2147483647i, (_e282 > bitcast<f32>(1325400063u))), (_e282 == _e282)));
            if (_e294 > _e282) {
                phi_1012_ = 1f;
            } else {
                phi_1012_ = 0f;
            }
            let _e297 = phi_1012_;
            if (_e282 < 8388608f) {
                phi_1017_ = (_e294 - _e297);
                phi_1018_ = false;
            } else {
                phi_1017_ = f32();
                phi_1018_ = true;
            }
            let _e300 = phi_1017_;
            let _e302 = phi_1018_;
            phi_1019_ = _e300;
            phi_1020_ = _e302;
        } else {
            phi_1019_ = f32();
            phi_1020_ = true;
        }
        let _e304 = phi_1019_;
        let _e306 = phi_1020_;
        if _e306 {
            phi_1024_ = _e282;
        } else {
            phi_1024_ = _e304;
        }
        let _e308 = phi_1024_;
        let _e312 = ((_e280 - (_e308 * 0.69314575f)) - (_e308 * 0.0000014286068f));
        phi_1062_ = ((((((((((((((((1f / 5040f) * _e312) + (1f / 720f)) * _e312) + (1f / 120f)) * _e312) + (1f / 24f)) * _e312) + (1f / 6f)) * _e312) + 0.5f) * _e312) + 1f) * _e312) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e308), i32(-2147483648), (_e308 < bitcast<f32>(3472883712u))), 2147483647i, (_e308 > bitcast<f32>(1325400063u))), (_e308 == _e308)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e348 = phi_1062_;
    if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
        phi_1150_ = _e117;
    } else {
        if (_e117 < -87f) {
            phi_1073_ = -87f;
        } else {
            phi_1073_ = _e117;
        }
        let _e354 = phi_1073_;
        if (_e354 > 88f) {
            phi_1078_ = 88f;
        } else {
            phi_1078_ = _e354;
        }
        let _e357 = phi_1078_;
        let _e359 = ((_e357 * 1.442695f) + 0.5f);
        if (_e359 > -8388608f) {
            let _e371 = f32(select(0i, select(select(i32(_e359), i32(-2147483648), (_e359 < bitcast<f32>(3472883712u))), 2147483647i, (_e359 > bitcast<f32>(1325400063u))), (_e359 == _e359)));
            if (_e371 > _e359) {
                phi_1100_ = 1f;
            } else {
                phi_1100_ = 0f;
            }
            let _e374 = phi_1100_;
            if (_e359 < 8388608f) {
                phi_1105_ = (_e371 - _e374);
                phi_1106_ = false;
            } else {
                phi_1105_ = f32();
                phi_1106_ = true;
            }
            let _e377 = phi_1105_;
            let _e379 = phi_1106_;
            phi_1107_ = _e377;
            phi_1108_ = _e379;
        } else {
            phi_1107_ = f32();
            phi_1108_ = true;
        }
        let _e381 = phi_1107_;
        let _e383 = phi_1108_;
        if _e383 {
            phi_1112_ = _e359;
        } else {
            phi_1112_ = _e381;
        }
        let _e385 = phi_1112_;
        let _e389 = ((_e357 - (_e385 * 0.69314575f)) - (_e385 * 0.0000014286068f));
        phi_1150_ = ((((((((((((((((1f / 5040f) * _e389) + (1f / 720f)) * _e389) + (1f / 120f)) * _e389) + (1f / 24f)) * _e389) + (1f / 6f)) * _e389) + 0.5f) * _e389) + 1f) * _e389) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e385), i32(-2147483648), (_e385 < bitcast<f32>(3472883712u))), 2147483647i, (_e385 > bitcast<f32>(1325400063u))), (_e385 == _e385)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e425 = phi_1150_;
    let _e436 = ((((_e194 * param_7.x) + (_e271 * param_7.y)) + (_e348 * param_7.z)) + (_e425 * param_7.w));
    if ((bitcast<u32>(_e436) & 2147483647u) > 2139095040u) {
        phi_1178_ = _e436;
    } else {
        if (_e436 < 0f) {
            phi_1177_ = 0f;
        } else {
            if (_e436 > 1f) {
                phi_1176_ = 1f;
            } else {
                phi_1176_ = _e436;
            }
            let _e443 = phi_1176_;
            phi_1177_ = _e443;
        }
        let _e445 = phi_1177_;
        phi_1178_ = _e445;
    }
    let _e447 = phi_1178_;
    return _e447;
}

fn function_() {
    var local: f32;
    var phi_223_: bool;
    var phi_224_: bool;
    var phi_225_: bool;
    var phi_226_: bool;
    var phi_230_: bool;
    var phi_274_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_278_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_355_: bool;
    var phi_364_: bool;
    var phi_373_: bool;
    var phi_374_: bool;
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_377_: bool;
    var phi_378_: bool;
    var phi_379_: bool;
    var phi_383_: bool;
    var phi_477_: f32;
    var phi_480_: f32;
    var phi_509_: f32;
    var phi_514_: f32;
    var phi_515_: bool;
    var phi_516_: f32;
    var phi_517_: bool;
    var phi_521_: f32;
    var phi_541_: f32;
    var phi_546_: f32;
    var phi_547_: bool;
    var phi_548_: f32;
    var phi_549_: bool;
    var phi_553_: f32;
    var phi_599_: i32;
    var phi_604_: i32;
    var phi_609_: i32;
    var phi_614_: i32;
    var phi_623_: i32;
    var phi_628_: i32;
    var phi_633_: i32;
    var phi_638_: i32;
    var phi_679_: evaluate_Verdict;
    var phi_680_: evaluate_Verdict;
    var phi_681_: bool;
    var phi_682_: evaluate_Verdict;
    var phi_683_: evaluate_Verdict;
    var phi_684_: bool;
    var phi_688_: evaluate_Verdict;

    let _e47 = id_1;
    let _e54 = arrayLength((&map.member));
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e47, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        if (_e63.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e72 = p.member.light;
        let _e75 = samples.member[(0u + _e63.first_primitive)].normal[0u];
        let _e77 = global[0u];
        if (_e75 == _e77) {
            let _e80 = samples.member[(0u + _e63.first_primitive)].normal[1u];
            let _e82 = global[1u];
            if (_e80 == _e82) {
                let _e85 = samples.member[(0u + _e63.first_primitive)].normal[2u];
                let _e87 = global[2u];
                phi_223_ = (_e85 == _e87);
                phi_224_ = false;
            } else {
                phi_223_ = bool();
                phi_224_ = true;
            }
            let _e90 = phi_223_;
            let _e92 = phi_224_;
            phi_225_ = _e90;
            phi_226_ = _e92;
        } else {
            phi_225_ = bool();
            phi_226_ = true;
        }
        let _e94 = phi_225_;
        let _e96 = phi_226_;
        if _e96 {
            phi_230_ = false;
        } else {
            phi_230_ = _e94;
        }
        let _e98 = phi_230_;
        if !(_e98) {
            let _e101 = samples.member[(0u + _e63.first_primitive)].normal;
            let _e103 = samples.member[(0u + _e63.first_primitive)].position;
            if ((((_e101.x * (_e72.x - (_e103.x * _e72.w))) + (_e101.y * (_e72.y - (_e103.y * _e72.w)))) + (_e101.z * (_e72.z - (_e103.z * _e72.w)))) > 0f) {
                let _e127 = samples.member[(0u + _e63.first_primitive)].flags;
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e135.unnamed.visibility, false), _e135.unnamed_1);
                phi_274_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e141.unnamed, ((_e127 & 1u) == 0u));
            } else {
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e150.unnamed.visibility, false), _e150.unnamed_1);
                phi_274_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e156.unnamed, true);
            }
            let _e161 = phi_274_;
            phi_278_ = _e161;
        } else {
            let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
            phi_278_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, true);
        }
        let _e178 = phi_278_;
        if _e178.unnamed_1 {
            phi_682_ = evaluate_Verdict(_e178.unnamed.visibility, _e178.unnamed.is_doubted);
            phi_683_ = evaluate_Verdict();
            phi_684_ = true;
        } else {
            let _e186 = samples.member[(0u + _e63.first_primitive)].position;
            let _e192 = p.member.projection.row_w;
            let _e203 = ((((_e192.x * _e186.x) + (_e192.y * _e186.y)) + (_e192.z * _e186.z)) + (_e192.w * 1f));
            let _e205 = p.member.projection.row_x;
            let _e217 = (((((_e205.x * _e186.x) + (_e205.y * _e186.y)) + (_e205.z * _e186.z)) + (_e205.w * 1f)) / _e203);
            let _e219 = p.member.projection.row_y;
            let _e231 = (((((_e219.x * _e186.x) + (_e219.y * _e186.y)) + (_e219.z * _e186.z)) + (_e219.w * 1f)) / _e203);
            let _e233 = p.member.projection.row_z;
            let _e244 = ((((_e233.x * _e186.x) + (_e233.y * _e186.y)) + (_e233.z * _e186.z)) + (_e233.w * 1f));
            if (_e203 > 0f) {
                if (_e217 >= 0f) {
                    phi_355_ = (_e217 <= 1f);
                } else {
                    phi_355_ = false;
                }
                let _e249 = phi_355_;
                if _e249 {
                    if (_e231 >= 0f) {
                        phi_364_ = (_e231 <= 1f);
                    } else {
                        phi_364_ = false;
                    }
                    let _e253 = phi_364_;
                    if _e253 {
                        if (_e244 >= 0f) {
                            phi_373_ = (_e244 <= 1f);
                        } else {
                            phi_373_ = false;
                        }
                        let _e257 = phi_373_;
                        phi_374_ = _e257;
                        phi_375_ = false;
                    } else {
                        phi_374_ = bool();
                        phi_375_ = true;
                    }
                    let _e259 = phi_374_;
                    let _e261 = phi_375_;
                    phi_376_ = _e259;
                    phi_377_ = _e261;
                } else {
                    phi_376_ = bool();
                    phi_377_ = true;
                }
                let _e263 = phi_376_;
                let _e265 = phi_377_;
                phi_378_ = _e263;
                phi_379_ = _e265;
            } else {
                phi_378_ = bool();
                phi_379_ = true;
            }
            let _e267 = phi_378_;
            let _e269 = phi_379_;
            if _e269 {
                phi_383_ = false;
            } else {
                phi_383_ = _e267;
            }
            let _e271 = phi_383_;
            if _e271 {
                if (0f > 0f) {
                    let _e274 = samples.member[(0u + _e63.first_primitive)].normal;
                    let _e276 = p.member.map_size;
                    let _e279 = p.member.projection.row_x;
                    let _e301 = p.member.projection.row_y;
                    let _e323 = p.member.projection.row_z;
                    let _e350 = ((abs(((((_e279.x * _e274.x) + (_e279.y * _e274.y)) + (_e279.z * _e274.z)) / (((_e279.x * _e279.x) + (_e279.y * _e279.y)) + (_e279.z * _e279.z)))) + abs(((((_e301.x * _e274.x) + (_e301.y * _e274.y)) + (_e301.z * _e274.z)) / (((_e301.x * _e301.x) + (_e301.y * _e301.y)) + (_e301.z * _e301.z))))) / (abs(((((_e323.x * _e274.x) + (_e323.y * _e274.y)) + (_e323.z * _e274.z)) / (((_e323.x * _e323.x) + (_e323.y * _e323.y)) + (_e323.z * _e323.z)))) * f32(_e276)));
                    if (_e350 < 0.002f) {
                        phi_477_ = _e350;
                    } else {
                        phi_477_ = 0.002f;
                    }
                    let _e353 = phi_477_;
                    phi_480_ = (_e244 - (0f * _e353));
                } else {
                    phi_480_ = _e244;
                }
                let _e357 = phi_480_;
                let _e359 = p.member.map_size;
                let _e360 = f32(_e359);
                let _e363 = ((_e217 * _e360) - 0.5f);
                let _e364 = ((_e231 * _e360) - 0.5f);
                if (_e363 > -8388608f) {
                    let _e376 = f32(select(0i, select(select(i32(_e363), i32(-2147483648), (_e363 < bitcast<f32>(3472883712u))), 2147483647i, (_e363 > bitcast<f32>(1325400063u))), (_e363 == _e363)));
                    if (_e376 > _e363) {
                        phi_509_ = 1f;
                    } else {
                        phi_509_ = 0f;
                    }
                    let _e379 = phi_509_;
                    if (_e363 < 8388608f) {
                        phi_514_ = (_e376 - _e379);
                        phi_515_ = false;
                    } else {
                        phi_514_ = f32();
                        phi_515_ = true;
                    }
                    let _e382 = phi_514_;
                    let _e384 = phi_515_;
                    phi_516_ = _e382;
                    phi_517_ = _e384;
                } else {
                    phi_516_ = f32();
                    phi_517_ = true;
                }
                let _e386 = phi_516_;
                let _e388 = phi_517_;
                if _e388 {
                    phi_521_ = _e363;
                } else {
                    phi_521_ = _e386;
                }
                let _e390 = phi_521_;
                if (_e364 > -8388608f) {
                    let _e402 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e402 > _e364) {
                        phi_541_ = 1f;
                    } else {
                        phi_541_ = 0f;
                    }
                    let _e405 = phi_541_;
                    if (_e364 < 8388608f) {
                        phi_546_ = (_e402 - _e405);
                        phi_547_ = false;
                    } else {
                        phi_546_ = f32();
                        phi_547_ = true;
                    }
                    let _e408 = phi_546_;
                    let _e410 = phi_547_;
                    phi_548_ = _e408;
                    phi_549_ = _e410;
                } else {
                    phi_548_ = f32();
                    phi_549_ = true;
                }
                let _e412 = phi_548_;
                let _e414 = phi_549_;
                if _e414 {
                    phi_553_ = _e364;
                } else {
                    phi_553_ = _e412;
                }
                let _e416 = phi_553_;
                let _e417 = (_e363 - _e390);
                let _e418 = (_e364 - _e416);
                let _e427 = select(0i, select(select(i32(_e390), i32(-2147483648), (_e390 < bitcast<f32>(3472883712u))), 2147483647i, (_e390 > bitcast<f32>(1325400063u))), (_e390 == _e390));
                let _e436 = select(0i, select(select(i32(_e416), i32(-2147483648), (_e416 < bitcast<f32>(3472883712u))), 2147483647i, (_e416 > bitcast<f32>(1325400063u))), (_e416 == _e416));
                let _e447 = p.member.test;
                let _e448 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e447);
                let _e450 = p.member.map_size;
                local = _e448;
                let _e452 = (bitcast<i32>(_e450) - 1i);
                if (_e427 > 0i) {
                    phi_599_ = _e427;
                } else {
                    phi_599_ = 0i;
                }
                let _e455 = phi_599_;
                if (_e436 > 0i) {
                    phi_604_ = _e436;
                } else {
                    phi_604_ = 0i;
                }
                let _e458 = phi_604_;
                if (_e455 < _e452) {
                    phi_609_ = _e455;
                } else {
                    phi_609_ = _e452;
                }
                let _e461 = phi_609_;
                if (_e458 < _e452) {
                    phi_614_ = _e458;
                } else {
                    phi_614_ = _e452;
                }
                let _e464 = phi_614_;
                let _e465 = bitcast<u32>(_e461);
                let _e467 = (_e427 + 1i);
                let _e468 = (_e436 + 1i);
                if (_e467 > 0i) {
                    phi_623_ = _e467;
                } else {
                    phi_623_ = 0i;
                }
                let _e471 = phi_623_;
                if (_e468 > 0i) {
                    phi_628_ = _e468;
                } else {
                    phi_628_ = 0i;
                }
                let _e474 = phi_628_;
                if (_e471 < _e452) {
                    phi_633_ = _e471;
                } else {
                    phi_633_ = _e452;
                }
                let _e477 = phi_633_;
                if (_e474 < _e452) {
                    phi_638_ = _e474;
                } else {
                    phi_638_ = _e452;
                }
                let _e480 = phi_638_;
                let _e481 = bitcast<u32>(_e477);
                let _e483 = (bitcast<u32>(_e464) * _e450);
                let _e484 = (bitcast<u32>(_e480) * _e450);
                let _e485 = (_e483 + _e465);
                let _e486 = (_e483 + _e481);
                let _e487 = (_e484 + _e465);
                let _e488 = (_e484 + _e481);
                if (_e485 < _e54) {
                } else {
                    return;
                }
                let _e492 = map.member[(0u + _e485)];
                if (_e486 < _e54) {
                } else {
                    return;
                }
                let _e496 = map.member[(0u + _e486)];
                if (_e487 < _e54) {
                } else {
                    return;
                }
                let _e500 = map.member[(0u + _e487)];
                if (_e488 < _e54) {
                } else {
                    return;
                }
                let _e504 = map.member[(0u + _e488)];
                let _e506 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e492, _e496, _e500, _e504), vec4<f32>(((1f - _e417) * (1f - _e418)), (_e417 * (1f - _e418)), ((1f - _e417) * _e418), (_e417 * _e418)), _e357);
                phi_679_ = evaluate_Verdict(_e506, false);
                phi_680_ = evaluate_Verdict();
                phi_681_ = false;
            } else {
                phi_679_ = evaluate_Verdict();
                phi_680_ = evaluate_Verdict(1f, false);
                phi_681_ = true;
            }
            let _e510 = phi_679_;
            let _e512 = phi_680_;
            let _e514 = phi_681_;
            phi_682_ = _e512;
            phi_683_ = _e510;
            phi_684_ = _e514;
        }
        let _e516 = phi_682_;
        let _e518 = phi_683_;
        let _e520 = phi_684_;
        if _e520 {
            phi_688_ = _e516;
        } else {
            phi_688_ = _e518;
        }
        let _e522 = phi_688_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e522.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
