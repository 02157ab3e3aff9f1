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

struct type_28 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_28;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_139_: lt_bvh_traverse_Tree;
    var phi_140_: bool;
    var phi_141_: lt_bvh_traverse_Tree;
    var phi_142_: bool;
    var phi_147_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_139_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_140_ = false;
        } else {
            phi_139_ = lt_bvh_traverse_Tree();
            phi_140_ = true;
        }
        let _e59 = phi_139_;
        let _e61 = phi_140_;
        phi_141_ = _e59;
        phi_142_ = _e61;
    } else {
        phi_141_ = lt_bvh_traverse_Tree();
        phi_142_ = true;
    }
    let _e63 = phi_141_;
    let _e65 = phi_142_;
    if _e65 {
        phi_147_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_147_ = _e63;
    }
    let _e70 = phi_147_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_167_: bool;
    var phi_171_: f32;

    let _e47 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_167_ = true;
    } else {
        let _e51 = (84f < _e47);
        if _e51 {
        }
        phi_167_ = _e51;
    }
    let _e53 = phi_167_;
    if _e53 {
        phi_171_ = 84f;
    } else {
        phi_171_ = _e47;
    }
    let _e55 = phi_171_;
    return _e55;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_192_: f32;
    var phi_193_: f32;
    var phi_194_: f32;
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_228_: f32;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_246_: f32;
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_264_: f32;
    var phi_265_: f32;
    var phi_266_: f32;
    var phi_285_: f32;
    var phi_290_: f32;
    var phi_312_: f32;
    var phi_317_: f32;
    var phi_318_: bool;
    var phi_319_: f32;
    var phi_320_: bool;
    var phi_324_: f32;
    var phi_362_: f32;
    var phi_373_: f32;
    var phi_378_: f32;
    var phi_400_: f32;
    var phi_405_: f32;
    var phi_406_: bool;
    var phi_407_: f32;
    var phi_408_: bool;
    var phi_412_: f32;
    var phi_450_: f32;
    var phi_461_: f32;
    var phi_466_: f32;
    var phi_488_: f32;
    var phi_493_: f32;
    var phi_494_: bool;
    var phi_495_: f32;
    var phi_496_: bool;
    var phi_500_: f32;
    var phi_538_: f32;
    var phi_549_: f32;
    var phi_554_: f32;
    var phi_576_: f32;
    var phi_581_: f32;
    var phi_582_: bool;
    var phi_583_: f32;
    var phi_584_: bool;
    var phi_588_: f32;
    var phi_626_: f32;
    var phi_652_: f32;
    var phi_653_: f32;
    var phi_654_: f32;

    let _e50 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_194_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_193_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_192_ = 1f;
            } else {
                phi_192_ = param_8;
            }
            let _e57 = phi_192_;
            phi_193_ = _e57;
        }
        let _e59 = phi_193_;
        phi_194_ = _e59;
    }
    let _e61 = phi_194_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_212_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_211_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_210_ = 1f;
            } else {
                phi_210_ = param_6.x;
            }
            let _e69 = phi_210_;
            phi_211_ = _e69;
        }
        let _e71 = phi_211_;
        phi_212_ = _e71;
    }
    let _e73 = phi_212_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_230_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_229_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_228_ = 1f;
            } else {
                phi_228_ = param_6.y;
            }
            let _e81 = phi_228_;
            phi_229_ = _e81;
        }
        let _e83 = phi_229_;
        phi_230_ = _e83;
    }
    let _e85 = phi_230_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_248_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_247_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_246_ = 1f;
            } else {
                phi_246_ = param_6.z;
            }
            let _e93 = phi_246_;
            phi_247_ = _e93;
        }
        let _e95 = phi_247_;
        phi_248_ = _e95;
    }
    let _e97 = phi_248_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_266_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_265_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_264_ = 1f;
            } else {
                phi_264_ = param_6.w;
            }
            let _e105 = phi_264_;
            phi_265_ = _e105;
        }
        let _e107 = phi_265_;
        phi_266_ = _e107;
    }
    let _e109 = phi_266_;
    let _e114 = (_e50 * (_e73 - _e61));
    let _e115 = (_e50 * (_e85 - _e61));
    let _e116 = (_e50 * (_e97 - _e61));
    let _e117 = (_e50 * (_e109 - _e61));
    if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
        phi_362_ = _e114;
    } else {
        if (_e114 < -87f) {
            phi_285_ = -87f;
        } else {
            phi_285_ = _e114;
        }
        let _e123 = phi_285_;
        if (_e123 > 88f) {
            phi_290_ = 88f;
        } else {
            phi_290_ = _e123;
        }
        let _e126 = phi_290_;
        let _e128 = ((_e126 * 1.442695f) + 0.5f);
        if (_e128 > -8388608f) {
            let _e140 = f32(select(0i, select(select(i32(_e128), i32(-2147483648), (_e128 < bitcast<f32>(3472883712u))), 2147483647i, (_e128 > bitcast<f32>(1325400063u))), (_e128 == _e128)));
            if (_e140 > _e128) {
                phi_312_ = 1f;
            } else {
                phi_312_ = 0f;
            }
            let _e143 = phi_312_;
            if (_e128 < 8388608f) {
                phi_317_ = (_e140 - _e143);
                phi_318_ = false;
            } else {
                phi_317_ = f32();
                phi_318_ = true;
            }
            let _e146 = phi_317_;
            let _e148 = phi_318_;
            phi_319_ = _e146;
            phi_320_ = _e148;
        } else {
            phi_319_ = f32();
            phi_320_ = true;
        }
        let _e150 = phi_319_;
        let _e152 = phi_320_;
        if _e152 {
            phi_324_ = _e128;
        } else {
            phi_324_ = _e150;
        }
        let _e154 = phi_324_;
        let _e158 = ((_e126 - (_e154 * 0.69314575f)) - (_e154 * 0.0000014286068f));
        phi_362_ = ((((((((((((((((1f / 5040f) * _e158) + (1f / 720f)) * _e158) + (1f / 120f)) * _e158) + (1f / 24f)) * _e158) + (1f / 6f)) * _e158) + 0.5f) * _e158) + 1f) * _e158) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e154), i32(-2147483648), (_e154 < bitcast<f32>(3472883712u))), 2147483647i, (_e154 > bitcast<f32>(1325400063u))), (_e154 == _e154)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e194 = phi_362_;
    if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
        phi_450_ = _e115;
    } else {
        if (_e115 < -87f) {
            phi_373_ = -87f;
        } else {
            phi_373_ = _e115;
        }
        let _e200 = phi_373_;
        if (_e200 > 88f) {
            phi_378_ = 88f;
        } else {
            phi_378_ = _e200;
        }
        let _e203 = phi_378_;
        let _e205 = ((_e203 * 1.442695f) + 0.5f);
        if (_e205 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(_e205), i32(-2147483648), (_e205 < bitcast<f32>(3472883712u))), 2147483647i, (_e205 > bitcast<f32>(1325400063u))), (_e205 == _e205)));
            if (_e217 > _e205) {
                phi_400_ = 1f;
            } else {
                phi_400_ = 0f;
            }
            let _e220 = phi_400_;
            if (_e205 < 8388608f) {
                phi_405_ = (_e217 - _e220);
                phi_406_ = false;
            } else {
                phi_405_ = f32();
                phi_406_ = true;
            }
            let _e223 = phi_405_;
            let _e225 = phi_406_;
            phi_407_ = _e223;
            phi_408_ = _e225;
        } else {
            phi_407_ = f32();
            phi_408_ = true;
        }
        let _e227 = phi_407_;
        let _e229 = phi_408_;
        if _e229 {
            phi_412_ = _e205;
        } else {
            phi_412_ = _e227;
        }
        let _e231 = phi_412_;
        let _e235 = ((_e203 - (_e231 * 0.69314575f)) - (_e231 * 0.0000014286068f));
        phi_450_ = ((((((((((((((((1f / 5040f) * _e235) + (1f / 720f)) * _e235) + (1f / 120f)) * _e235) + (1f / 24f)) * _e235) + (1f / 6f)) * _e235) + 0.5f) * _e235) + 1f) * _e235) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e231), i32(-2147483648), (_e231 < bitcast<f32>(3472883712u))), 2147483647i, (_e231 > bitcast<f32>(1325400063u))), (_e231 == _e231)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e271 = phi_450_;
    if ((bitcast<u32>(_e116) & 2147483647u) > 2139095040u) {
        phi_538_ = _e116;
    } else {
        if (_e116 < -87f) {
            phi_461_ = -87f;
        } else {
            phi_461_ = _e116;
        }
        let _e277 = phi_461_;
        if (_e277 > 88f) {
            phi_466_ = 88f;
        } else {
            phi_466_ = _e277;
        }
        let _e280 = phi_466_;
        let _e282 = ((_e280 * 1.442695f) + 0.5f);
        if (_e282 > -8388608f) {
            let _e294 = f32(select(0i, select(select(i32(_e282), i32(-2147483648), (_e282 < bitcast<f32>(3472883712u))), 2147483647i, (_e282 > bitcast<f32>(1325400063u))), (_e282 == _e282)));
            if (_e294 > _e282) {
                phi_488_ = 1f;
            } else {
                phi_488_ = 0f;
            }
            let _e297 = phi_488_;
            if (_e282 < 8388608f) {
                phi_493_ = (_e294 - _e297);
                phi_494_ = false;
            } else {
                phi_493_ = f32();
                phi_494_ = true;
            }
            let _e300 = phi_493_;
            let _e302 = phi_494_;
            phi_495_ = _e300;
            phi_496_ = _e302;
        } else {
            phi_495_ = f32();
            phi_496_ = true;
        }
        let _e304 = phi_495_;
        let _e306 = phi_496_;
        if _e306 {
            phi_500_ = _e282;
        } else {
            phi_500_ = _e304;
        }
        let _e308 = phi_500_;
        let _e312 = ((_e280 - (_e308 * 0.69314575f)) - (_e308 * 0.0000014286068f));
        phi_538_ = ((((((((((((((((1f / 5040f) * _e312) + (1f / 720f)) * _e312) + (1f / 120f)) * _e312) + (1f / 24f)) * _e312) + (1f / 6f)) * _e312) + 0.5f) * _e312) + 1f) * _e312) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e308), i32(-2147483648), (_e308 < bitcast<f32>(3472883712u))), 2147483647i, (_e308 > bitcast<f32>(1325400063u))), (_e308 == _e308)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e348 = phi_538_;
    if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
        phi_626_ = _e117;
    } else {
        if (_e117 < -87f) {
            phi_549_ = -87f;
        } else {
            phi_549_ = _e117;
        }
        let _e354 = phi_549_;
        if (_e354 > 88f) {
            phi_554_ = 88f;
        } else {
            phi_554_ = _e354;
        }
        let _e357 = phi_554_;
        let _e359 = ((_e357 * 1.442695f) + 0.5f);
        if (_e359 > -8388608f) {
            let _e371 = f32(select(0i, select(select(i32(_e359), i32(-2147483648), (_e359 < bitcast<f32>(3472883712u))), 2147483647i, (_e359 > bitcast<f32>(1325400063u))), (_e359 == _e359)));
            if (_e371 > _e359) {
                phi_576_ = 1f;
            } else {
                phi_576_ = 0f;
            }
            let _e374 = phi_576_;
            if (_e359 < 8388608f) {
                phi_581_ = (_e371 - _e374);
                phi_582_ = false;
            } else {
                phi_581_ = f32();
                phi_582_ = true;
            }
            let _e377 = phi_581_;
            let _e379 = phi_582_;
            phi_583_ = _e377;
            phi_584_ = _e379;
        } else {
            phi_583_ = f32();
            phi_584_ = true;
        }
        let _e381 = phi_583_;
        let _e383 = phi_584_;
        if _e383 {
            phi_588_ = _e359;
        } else {
            phi_588_ = _e381;
        }
        let _e385 = phi_588_;
        let _e389 = ((_e357 - (_e385 * 0.69314575f)) - (_e385 * 0.0000014286068f));
        phi_626_ = ((((((((((((((((1f / 5040f) * _e389) + (1f / 720f)) * _e389) + (1f / 120f)) * _e389) + (1f / 24f)) * _e389) + (1f / 6f)) * _e389) + 0.5f) * _e389) + 1f) * _e389) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e385), i32(-2147483648), (_e385 < bitcast<f32>(3472883712u))), 2147483647i, (_e385 > bitcast<f32>(1325400063u))), (_e385 == _e385)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e425 = phi_626_;
    let _e436 = ((((_e194 * param_7.x) + (_e271 * param_7.y)) + (_e348 * param_7.z)) + (_e425 * param_7.w));
    if ((bitcast<u32>(_e436) & 2147483647u) > 2139095040u) {
        phi_654_ = _e436;
    } else {
        if (_e436 < 0f) {
            phi_653_ = 0f;
        } else {
            if (_e436 > 1f) {
                phi_652_ = 1f;
            } else {
                phi_652_ = _e436;
            }
            let _e443 = phi_652_;
            phi_653_ = _e443;
        }
        let _e445 = phi_653_;
        phi_654_ = _e445;
    }
    let _e447 = phi_654_;
    return _e447;
}

fn function_() {
    var local: f32;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_711_: bool;
    var phi_715_: bool;
    var phi_759_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_763_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_840_: bool;
    var phi_849_: bool;
    var phi_858_: bool;
    var phi_859_: bool;
    var phi_860_: bool;
    var phi_861_: bool;
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_868_: bool;
    var phi_962_: f32;
    var phi_965_: f32;
    var phi_994_: f32;
    var phi_999_: f32;
    var phi_1000_: bool;
    var phi_1001_: f32;
    var phi_1002_: bool;
    var phi_1006_: f32;
    var phi_1026_: f32;
    var phi_1031_: f32;
    var phi_1032_: bool;
    var phi_1033_: f32;
    var phi_1034_: bool;
    var phi_1038_: f32;
    var phi_1084_: i32;
    var phi_1089_: i32;
    var phi_1094_: i32;
    var phi_1099_: i32;
    var phi_1108_: i32;
    var phi_1113_: i32;
    var phi_1118_: i32;
    var phi_1123_: i32;
    var phi_1170_: bool;
    var phi_1178_: bool;
    var phi_1190_: bool;
    var phi_1191_: bool;
    var phi_1195_: f32;
    var phi_1201_: f32;
    var phi_1203_: evaluate_Verdict;
    var phi_1208_: evaluate_Verdict;
    var phi_1209_: evaluate_Verdict;

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
                phi_708_ = (_e85 == _e87);
                phi_709_ = false;
            } else {
                phi_708_ = bool();
                phi_709_ = true;
            }
            let _e90 = phi_708_;
            let _e92 = phi_709_;
            phi_710_ = _e90;
            phi_711_ = _e92;
        } else {
            phi_710_ = bool();
            phi_711_ = true;
        }
        let _e94 = phi_710_;
        let _e96 = phi_711_;
        if _e96 {
            phi_715_ = false;
        } else {
            phi_715_ = _e94;
        }
        let _e98 = phi_715_;
        if !(_e98) {
            let _e101 = samples.member[(0u + _e63.first_primitive)].normal;
            let _e103 = samples.member[(0u + _e63.first_primitive)].position;
            if ((((_e101.x * (_e72.x - (_e103.x * _e72.w))) + (_e101.y * (_e72.y - (_e103.y * _e72.w)))) + (_e101.z * (_e72.z - (_e103.z * _e72.w)))) > 0f) {
                let _e127 = samples.member[(0u + _e63.first_primitive)].flags;
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e135.unnamed.visibility, false), _e135.unnamed_1);
                phi_759_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e141.unnamed, ((_e127 & 1u) == 0u));
            } else {
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e150.unnamed.visibility, false), _e150.unnamed_1);
                phi_759_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e156.unnamed, true);
            }
            let _e161 = phi_759_;
            phi_763_ = _e161;
        } else {
            let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
            phi_763_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, true);
        }
        let _e178 = phi_763_;
        if _e178.unnamed_1 {
            phi_1209_ = evaluate_Verdict(_e178.unnamed.visibility, _e178.unnamed.is_doubted);
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
                    phi_840_ = (_e217 <= 1f);
                } else {
                    phi_840_ = false;
                }
                let _e249 = phi_840_;
                if _e249 {
                    if (_e231 >= 0f) {
                        phi_849_ = (_e231 <= 1f);
                    } else {
                        phi_849_ = false;
                    }
                    let _e253 = phi_849_;
                    if _e253 {
                        if (_e244 >= 0f) {
                            phi_858_ = (_e244 <= 1f);
                        } else {
                            phi_858_ = false;
                        }
                        let _e257 = phi_858_;
                        phi_859_ = _e257;
                        phi_860_ = false;
                    } else {
                        phi_859_ = bool();
                        phi_860_ = true;
                    }
                    let _e259 = phi_859_;
                    let _e261 = phi_860_;
                    phi_861_ = _e259;
                    phi_862_ = _e261;
                } else {
                    phi_861_ = bool();
                    phi_862_ = true;
                }
                let _e263 = phi_861_;
                let _e265 = phi_862_;
                phi_863_ = _e263;
                phi_864_ = _e265;
            } else {
                phi_863_ = bool();
                phi_864_ = true;
            }
            let _e267 = phi_863_;
            let _e269 = phi_864_;
            if _e269 {
                phi_868_ = false;
            } else {
                phi_868_ = _e267;
            }
            let _e271 = phi_868_;
            if _e271 {
                if (0f > 0f) {
                    let _e274 = samples.member[(0u + _e63.first_primitive)].normal;
                    let _e276 = p.member.map_size;
                    let _e279 = p.member.projection.row_x;
                    let _e301 = p.member.projection.row_y;
                    let _e323 = p.member.projection.row_z;
                    let _e350 = ((abs(((((_e279.x * _e274.x) + (_e279.y * _e274.y)) + (_e279.z * _e274.z)) / (((_e279.x * _e279.x) + (_e279.y * _e279.y)) + (_e279.z * _e279.z)))) + abs(((((_e301.x * _e274.x) + (_e301.y * _e274.y)) + (_e301.z * _e274.z)) / (((_e301.x * _e301.x) + (_e301.y * _e301.y)) + (_e301.z * _e301.z))))) / (abs(((((_e323.x * _e274.x) + (_e323.y * _e274.y)) + (_e323.z * _e274.z)) / (((_e323.x * _e323.x) + (_e323.y * _e323.y)) + (_e323.z * _e323.z)))) * f32(_e276)));
                    if (_e350 < 0.002f) {
                        phi_962_ = _e350;
                    } else {
                        phi_962_ = 0.002f;
                    }
                    let _e353 = phi_962_;
                    phi_965_ = (_e244 - (0f * _e353));
                } else {
                    phi_965_ = _e244;
                }
                let _e357 = phi_965_;
                let _e359 = p.member.map_size;
                let _e360 = f32(_e359);
                let _e363 = ((_e217 * _e360) - 0.5f);
                let _e364 = ((_e231 * _e360) - 0.5f);
                if (_e363 > -8388608f) {
                    let _e376 = f32(select(0i, select(select(i32(_e363), i32(-2147483648), (_e363 < bitcast<f32>(3472883712u))), 2147483647i, (_e363 > bitcast<f32>(1325400063u))), (_e363 == _e363)));
                    if (_e376 > _e363) {
                        phi_994_ = 1f;
                    } else {
                        phi_994_ = 0f;
                    }
                    let _e379 = phi_994_;
                    if (_e363 < 8388608f) {
                        phi_999_ = (_e376 - _e379);
                        phi_1000_ = false;
                    } else {
                        phi_999_ = f32();
                        phi_1000_ = true;
                    }
                    let _e382 = phi_999_;
                    let _e384 = phi_1000_;
                    phi_1001_ = _e382;
                    phi_1002_ = _e384;
                } else {
                    phi_1001_ = f32();
                    phi_1002_ = true;
                }
                let _e386 = phi_1001_;
                let _e388 = phi_1002_;
                if _e388 {
                    phi_1006_ = _e363;
                } else {
                    phi_1006_ = _e386;
                }
                let _e390 = phi_1006_;
                if (_e364 > -8388608f) {
                    let _e402 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e402 > _e364) {
                        phi_1026_ = 1f;
                    } else {
                        phi_1026_ = 0f;
                    }
                    let _e405 = phi_1026_;
                    if (_e364 < 8388608f) {
                        phi_1031_ = (_e402 - _e405);
                        phi_1032_ = false;
                    } else {
                        phi_1031_ = f32();
                        phi_1032_ = true;
                    }
                    let _e408 = phi_1031_;
                    let _e410 = phi_1032_;
                    phi_1033_ = _e408;
                    phi_1034_ = _e410;
                } else {
                    phi_1033_ = f32();
                    phi_1034_ = true;
                }
                let _e412 = phi_1033_;
                let _e414 = phi_1034_;
                if _e414 {
                    phi_1038_ = _e364;
                } else {
                    phi_1038_ = _e412;
                }
                let _e416 = phi_1038_;
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
                    phi_1084_ = _e427;
                } else {
                    phi_1084_ = 0i;
                }
                let _e455 = phi_1084_;
                if (_e436 > 0i) {
                    phi_1089_ = _e436;
                } else {
                    phi_1089_ = 0i;
                }
                let _e458 = phi_1089_;
                if (_e455 < _e452) {
                    phi_1094_ = _e455;
                } else {
                    phi_1094_ = _e452;
                }
                let _e461 = phi_1094_;
                if (_e458 < _e452) {
                    phi_1099_ = _e458;
                } else {
                    phi_1099_ = _e452;
                }
                let _e464 = phi_1099_;
                let _e465 = bitcast<u32>(_e461);
                let _e467 = (_e427 + 1i);
                let _e468 = (_e436 + 1i);
                if (_e467 > 0i) {
                    phi_1108_ = _e467;
                } else {
                    phi_1108_ = 0i;
                }
                let _e471 = phi_1108_;
                if (_e468 > 0i) {
                    phi_1113_ = _e468;
                } else {
                    phi_1113_ = 0i;
                }
                let _e474 = phi_1113_;
                if (_e471 < _e452) {
                    phi_1118_ = _e471;
                } else {
                    phi_1118_ = _e452;
                }
                let _e477 = phi_1118_;
                if (_e474 < _e452) {
                    phi_1123_ = _e474;
                } else {
                    phi_1123_ = _e452;
                }
                let _e480 = phi_1123_;
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
                let _e508 = p.member.epsilon;
                if (_e506 <= _e508) {
                    phi_1170_ = true;
                } else {
                    phi_1170_ = (_e506 >= (1f - _e508));
                }
                let _e513 = phi_1170_;
                if ((bitcast<u32>(_e506) & 2147483647u) > 2139095040u) {
                    phi_1178_ = true;
                } else {
                    phi_1178_ = !(_e513);
                }
                let _e519 = phi_1178_;
                if _e519 {
                    if (_e506 > 0f) {
                        if (_e506 < 1f) {
                            phi_1190_ = false;
                        } else {
                            phi_1190_ = true;
                        }
                        let _e523 = phi_1190_;
                        phi_1191_ = _e523;
                    } else {
                        phi_1191_ = true;
                    }
                    let _e525 = phi_1191_;
                    if _e525 {
                        phi_1195_ = 0.5f;
                    } else {
                        phi_1195_ = _e506;
                    }
                    let _e527 = phi_1195_;
                    phi_1203_ = evaluate_Verdict(_e527, true);
                } else {
                    if (_e506 > 0.5f) {
                        phi_1201_ = 1f;
                    } else {
                        phi_1201_ = 0f;
                    }
                    let _e531 = phi_1201_;
                    phi_1203_ = evaluate_Verdict(_e531, false);
                }
                let _e534 = phi_1203_;
                phi_1208_ = evaluate_Verdict(_e534.visibility, _e534.is_doubted);
            } else {
                phi_1208_ = evaluate_Verdict(0.5f, true);
            }
            let _e540 = phi_1208_;
            phi_1209_ = _e540;
        }
        let _e542 = phi_1209_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e542.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
