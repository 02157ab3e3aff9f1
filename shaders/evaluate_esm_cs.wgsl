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
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_27 {
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
var<uniform> p: type_27;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_138_: lt_bvh_traverse_Tree;
    var phi_139_: bool;
    var phi_140_: lt_bvh_traverse_Tree;
    var phi_141_: bool;
    var phi_146_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_138_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_139_ = false;
        } else {
            phi_138_ = lt_bvh_traverse_Tree();
            phi_139_ = true;
        }
        let _e59 = phi_138_;
        let _e61 = phi_139_;
        phi_140_ = _e59;
        phi_141_ = _e61;
    } else {
        phi_140_ = lt_bvh_traverse_Tree();
        phi_141_ = true;
    }
    let _e63 = phi_140_;
    let _e65 = phi_141_;
    if _e65 {
        phi_146_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_146_ = _e63;
    }
    let _e70 = phi_146_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_166_: bool;
    var phi_170_: f32;

    let _e47 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_166_ = true;
    } else {
        let _e51 = (84f < _e47);
        if _e51 {
        }
        phi_166_ = _e51;
    }
    let _e53 = phi_166_;
    if _e53 {
        phi_170_ = 84f;
    } else {
        phi_170_ = _e47;
    }
    let _e55 = phi_170_;
    return _e55;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_719_: f32;
    var phi_720_: f32;
    var phi_721_: f32;
    var phi_737_: f32;
    var phi_738_: f32;
    var phi_739_: f32;
    var phi_755_: f32;
    var phi_756_: f32;
    var phi_757_: f32;
    var phi_773_: f32;
    var phi_774_: f32;
    var phi_775_: f32;
    var phi_791_: f32;
    var phi_792_: f32;
    var phi_793_: f32;
    var phi_812_: f32;
    var phi_817_: f32;
    var phi_839_: f32;
    var phi_844_: f32;
    var phi_845_: bool;
    var phi_846_: f32;
    var phi_847_: bool;
    var phi_851_: f32;
    var phi_889_: f32;
    var phi_900_: f32;
    var phi_905_: f32;
    var phi_927_: f32;
    var phi_932_: f32;
    var phi_933_: bool;
    var phi_934_: f32;
    var phi_935_: bool;
    var phi_939_: f32;
    var phi_977_: f32;
    var phi_988_: f32;
    var phi_993_: f32;
    var phi_1015_: f32;
    var phi_1020_: f32;
    var phi_1021_: bool;
    var phi_1022_: f32;
    var phi_1023_: bool;
    var phi_1027_: f32;
    var phi_1065_: f32;
    var phi_1076_: f32;
    var phi_1081_: f32;
    var phi_1103_: f32;
    var phi_1108_: f32;
    var phi_1109_: bool;
    var phi_1110_: f32;
    var phi_1111_: bool;
    var phi_1115_: f32;
    var phi_1153_: f32;
    var phi_1179_: f32;
    var phi_1180_: f32;
    var phi_1181_: f32;

    let _e50 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_721_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_720_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_719_ = 1f;
            } else {
                phi_719_ = param_8;
            }
            let _e57 = phi_719_;
            phi_720_ = _e57;
        }
        let _e59 = phi_720_;
        phi_721_ = _e59;
    }
    let _e61 = phi_721_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_739_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_738_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_737_ = 1f;
            } else {
                phi_737_ = param_6.x;
            }
            let _e69 = phi_737_;
            phi_738_ = _e69;
        }
        let _e71 = phi_738_;
        phi_739_ = _e71;
    }
    let _e73 = phi_739_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_757_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_756_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_755_ = 1f;
            } else {
                phi_755_ = param_6.y;
            }
            let _e81 = phi_755_;
            phi_756_ = _e81;
        }
        let _e83 = phi_756_;
        phi_757_ = _e83;
    }
    let _e85 = phi_757_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_775_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_774_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_773_ = 1f;
            } else {
                phi_773_ = param_6.z;
            }
            let _e93 = phi_773_;
            phi_774_ = _e93;
        }
        let _e95 = phi_774_;
        phi_775_ = _e95;
    }
    let _e97 = phi_775_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_793_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_792_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_791_ = 1f;
            } else {
                phi_791_ = param_6.w;
            }
            let _e105 = phi_791_;
            phi_792_ = _e105;
        }
        let _e107 = phi_792_;
        phi_793_ = _e107;
    }
    let _e109 = phi_793_;
    let _e114 = (_e50 * (_e73 - _e61));
    let _e115 = (_e50 * (_e85 - _e61));
    let _e116 = (_e50 * (_e97 - _e61));
    let _e117 = (_e50 * (_e109 - _e61));
    if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
        phi_889_ = _e114;
    } else {
        if (_e114 < -87f) {
            phi_812_ = -87f;
        } else {
            phi_812_ = _e114;
        }
        let _e123 = phi_812_;
        if (_e123 > 88f) {
            phi_817_ = 88f;
        } else {
            phi_817_ = _e123;
        }
        let _e126 = phi_817_;
        let _e128 = ((_e126 * 1.442695f) + 0.5f);
        if (_e128 > -8388608f) {
            let _e140 = f32(select(0i, select(select(i32(_e128), i32(-2147483648), (_e128 < bitcast<f32>(3472883712u))), 2147483647i, (_e128 > bitcast<f32>(1325400063u))), (_e128 == _e128)));
            if (_e140 > _e128) {
                phi_839_ = 1f;
            } else {
                phi_839_ = 0f;
            }
            let _e143 = phi_839_;
            if (_e128 < 8388608f) {
                phi_844_ = (_e140 - _e143);
                phi_845_ = false;
            } else {
                phi_844_ = f32();
                phi_845_ = true;
            }
            let _e146 = phi_844_;
            let _e148 = phi_845_;
            phi_846_ = _e146;
            phi_847_ = _e148;
        } else {
            phi_846_ = f32();
            phi_847_ = true;
        }
        let _e150 = phi_846_;
        let _e152 = phi_847_;
        if _e152 {
            phi_851_ = _e128;
        } else {
            phi_851_ = _e150;
        }
        let _e154 = phi_851_;
        let _e158 = ((_e126 - (_e154 * 0.69314575f)) - (_e154 * 0.0000014286068f));
        phi_889_ = ((((((((((((((((1f / 5040f) * _e158) + (1f / 720f)) * _e158) + (1f / 120f)) * _e158) + (1f / 24f)) * _e158) + (1f / 6f)) * _e158) + 0.5f) * _e158) + 1f) * _e158) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e154), i32(-2147483648), (_e154 < bitcast<f32>(3472883712u))), 2147483647i, (_e154 > bitcast<f32>(1325400063u))), (_e154 == _e154)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e194 = phi_889_;
    if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
        phi_977_ = _e115;
    } else {
        if (_e115 < -87f) {
            phi_900_ = -87f;
        } else {
            phi_900_ = _e115;
        }
        let _e200 = phi_900_;
        if (_e200 > 88f) {
            phi_905_ = 88f;
        } else {
            phi_905_ = _e200;
        }
        let _e203 = phi_905_;
        let _e205 = ((_e203 * 1.442695f) + 0.5f);
        if (_e205 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(_e205), i32(-2147483648), (_e205 < bitcast<f32>(3472883712u))), 2147483647i, (_e205 > bitcast<f32>(1325400063u))), (_e205 == _e205)));
            if (_e217 > _e205) {
                phi_927_ = 1f;
            } else {
                phi_927_ = 0f;
            }
            let _e220 = phi_927_;
            if (_e205 < 8388608f) {
                phi_932_ = (_e217 - _e220);
                phi_933_ = false;
            } else {
                phi_932_ = f32();
                phi_933_ = true;
            }
            let _e223 = phi_932_;
            let _e225 = phi_933_;
            phi_934_ = _e223;
            phi_935_ = _e225;
        } else {
            phi_934_ = f32();
            phi_935_ = true;
        }
        let _e227 = phi_934_;
        let _e229 = phi_935_;
        if _e229 {
            phi_939_ = _e205;
        } else {
            phi_939_ = _e227;
        }
        let _e231 = phi_939_;
        let _e235 = ((_e203 - (_e231 * 0.69314575f)) - (_e231 * 0.0000014286068f));
        phi_977_ = ((((((((((((((((1f / 5040f) * _e235) + (1f / 720f)) * _e235) + (1f / 120f)) * _e235) + (1f / 24f)) * _e235) + (1f / 6f)) * _e235) + 0.5f) * _e235) + 1f) * _e235) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e231), i32(-2147483648), (_e231 < bitcast<f32>(3472883712u))), 2147483647i, (_e231 > bitcast<f32>(1325400063u))), (_e231 == _e231)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e271 = phi_977_;
    if ((bitcast<u32>(_e116) & 2147483647u) > 2139095040u) {
        phi_1065_ = _e116;
    } else {
        if (_e116 < -87f) {
            phi_988_ = -87f;
        } else {
            phi_988_ = _e116;
        }
        let _e277 = phi_988_;
        if (_e277 > 88f) {
            phi_993_ = 88f;
        } else {
            phi_993_ = _e277;
        }
        let _e280 = phi_993_;
        let _e282 = ((_e280 * 1.442695f) + 0.5f);
        if (_e282 > -8388608f) {
            let _e294 = f32(select(0i, select(select(i32(_e282), i32(-2147483648), (_e282 < bitcast<f32>(3472883712u))), 2147483647i, (_e282 > bitcast<f32>(1325400063u))), (_e282 == _e282)));
            if (_e294 > _e282) {
                phi_1015_ = 1f;
            } else {
                phi_1015_ = 0f;
            }
            let _e297 = phi_1015_;
            if (_e282 < 8388608f) {
                phi_1020_ = (_e294 - _e297);
                phi_1021_ = false;
            } else {
                phi_1020_ = f32();
                phi_1021_ = true;
            }
            let _e300 = phi_1020_;
            let _e302 = phi_1021_;
            phi_1022_ = _e300;
            phi_1023_ = _e302;
        } else {
            phi_1022_ = f32();
            phi_1023_ = true;
        }
        let _e304 = phi_1022_;
        let _e306 = phi_1023_;
        if _e306 {
            phi_1027_ = _e282;
        } else {
            phi_1027_ = _e304;
        }
        let _e308 = phi_1027_;
        let _e312 = ((_e280 - (_e308 * 0.69314575f)) - (_e308 * 0.0000014286068f));
        phi_1065_ = ((((((((((((((((1f / 5040f) * _e312) + (1f / 720f)) * _e312) + (1f / 120f)) * _e312) + (1f / 24f)) * _e312) + (1f / 6f)) * _e312) + 0.5f) * _e312) + 1f) * _e312) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e308), i32(-2147483648), (_e308 < bitcast<f32>(3472883712u))), 2147483647i, (_e308 > bitcast<f32>(1325400063u))), (_e308 == _e308)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e348 = phi_1065_;
    if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
        phi_1153_ = _e117;
    } else {
        if (_e117 < -87f) {
            phi_1076_ = -87f;
        } else {
            phi_1076_ = _e117;
        }
        let _e354 = phi_1076_;
        if (_e354 > 88f) {
            phi_1081_ = 88f;
        } else {
            phi_1081_ = _e354;
        }
        let _e357 = phi_1081_;
        let _e359 = ((_e357 * 1.442695f) + 0.5f);
        if (_e359 > -8388608f) {
            let _e371 = f32(select(0i, select(select(i32(_e359), i32(-2147483648), (_e359 < bitcast<f32>(3472883712u))), 2147483647i, (_e359 > bitcast<f32>(1325400063u))), (_e359 == _e359)));
            if (_e371 > _e359) {
                phi_1103_ = 1f;
            } else {
                phi_1103_ = 0f;
            }
            let _e374 = phi_1103_;
            if (_e359 < 8388608f) {
                phi_1108_ = (_e371 - _e374);
                phi_1109_ = false;
            } else {
                phi_1108_ = f32();
                phi_1109_ = true;
            }
            let _e377 = phi_1108_;
            let _e379 = phi_1109_;
            phi_1110_ = _e377;
            phi_1111_ = _e379;
        } else {
            phi_1110_ = f32();
            phi_1111_ = true;
        }
        let _e381 = phi_1110_;
        let _e383 = phi_1111_;
        if _e383 {
            phi_1115_ = _e359;
        } else {
            phi_1115_ = _e381;
        }
        let _e385 = phi_1115_;
        let _e389 = ((_e357 - (_e385 * 0.69314575f)) - (_e385 * 0.0000014286068f));
        phi_1153_ = ((((((((((((((((1f / 5040f) * _e389) + (1f / 720f)) * _e389) + (1f / 120f)) * _e389) + (1f / 24f)) * _e389) + (1f / 6f)) * _e389) + 0.5f) * _e389) + 1f) * _e389) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e385), i32(-2147483648), (_e385 < bitcast<f32>(3472883712u))), 2147483647i, (_e385 > bitcast<f32>(1325400063u))), (_e385 == _e385)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e425 = phi_1153_;
    let _e436 = ((((_e194 * param_7.x) + (_e271 * param_7.y)) + (_e348 * param_7.z)) + (_e425 * param_7.w));
    if ((bitcast<u32>(_e436) & 2147483647u) > 2139095040u) {
        phi_1181_ = _e436;
    } else {
        if (_e436 < 0f) {
            phi_1180_ = 0f;
        } else {
            if (_e436 > 1f) {
                phi_1179_ = 1f;
            } else {
                phi_1179_ = _e436;
            }
            let _e443 = phi_1179_;
            phi_1180_ = _e443;
        }
        let _e445 = phi_1180_;
        phi_1181_ = _e445;
    }
    let _e447 = phi_1181_;
    return _e447;
}

fn function_() {
    var local: f32;
    var phi_227_: bool;
    var phi_228_: bool;
    var phi_229_: bool;
    var phi_230_: bool;
    var phi_234_: bool;
    var phi_278_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_282_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_356_: bool;
    var phi_365_: bool;
    var phi_374_: bool;
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_377_: bool;
    var phi_378_: bool;
    var phi_379_: bool;
    var phi_380_: bool;
    var phi_384_: bool;
    var phi_474_: f32;
    var phi_477_: f32;
    var phi_506_: f32;
    var phi_511_: f32;
    var phi_512_: bool;
    var phi_513_: f32;
    var phi_514_: bool;
    var phi_518_: f32;
    var phi_538_: f32;
    var phi_543_: f32;
    var phi_544_: bool;
    var phi_545_: f32;
    var phi_546_: bool;
    var phi_550_: f32;
    var phi_598_: i32;
    var phi_603_: i32;
    var phi_608_: i32;
    var phi_613_: i32;
    var phi_622_: i32;
    var phi_627_: i32;
    var phi_632_: i32;
    var phi_637_: i32;
    var phi_682_: evaluate_Verdict;
    var phi_683_: evaluate_Verdict;
    var phi_684_: bool;
    var phi_685_: evaluate_Verdict;
    var phi_686_: evaluate_Verdict;
    var phi_687_: bool;
    var phi_691_: evaluate_Verdict;

    let _e47 = id_1;
    let _e54 = arrayLength((&map.member));
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e47, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        let _e69 = p.member.projection;
        if (_e63.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e73 = lt_math_OneLevel(_e69);
        let _e75 = p.member.light;
        let _e78 = samples.member[(0u + _e63.first_primitive)].normal[0u];
        let _e80 = global[0u];
        if (_e78 == _e80) {
            let _e83 = samples.member[(0u + _e63.first_primitive)].normal[1u];
            let _e85 = global[1u];
            if (_e83 == _e85) {
                let _e88 = samples.member[(0u + _e63.first_primitive)].normal[2u];
                let _e90 = global[2u];
                phi_227_ = (_e88 == _e90);
                phi_228_ = false;
            } else {
                phi_227_ = bool();
                phi_228_ = true;
            }
            let _e93 = phi_227_;
            let _e95 = phi_228_;
            phi_229_ = _e93;
            phi_230_ = _e95;
        } else {
            phi_229_ = bool();
            phi_230_ = true;
        }
        let _e97 = phi_229_;
        let _e99 = phi_230_;
        if _e99 {
            phi_234_ = false;
        } else {
            phi_234_ = _e97;
        }
        let _e101 = phi_234_;
        if !(_e101) {
            let _e104 = samples.member[(0u + _e63.first_primitive)].normal;
            let _e106 = samples.member[(0u + _e63.first_primitive)].position;
            if ((((_e104.x * (_e75.x - (_e106.x * _e75.w))) + (_e104.y * (_e75.y - (_e106.y * _e75.w)))) + (_e104.z * (_e75.z - (_e106.z * _e75.w)))) > 0f) {
                let _e130 = samples.member[(0u + _e63.first_primitive)].flags;
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_278_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, ((_e130 & 1u) == 0u));
            } else {
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e153.unnamed.visibility, false), _e153.unnamed_1);
                phi_278_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e159.unnamed, true);
            }
            let _e164 = phi_278_;
            phi_282_ = _e164;
        } else {
            let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
            phi_282_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, true);
        }
        let _e181 = phi_282_;
        if _e181.unnamed_1 {
            phi_685_ = evaluate_Verdict(_e181.unnamed.visibility, _e181.unnamed.is_doubted);
            phi_686_ = evaluate_Verdict();
            phi_687_ = true;
        } else {
            let _e189 = samples.member[(0u + _e63.first_primitive)].position;
            let _e207 = ((((_e73.projection.row_w.x * _e189.x) + (_e73.projection.row_w.y * _e189.y)) + (_e73.projection.row_w.z * _e189.z)) + (_e73.projection.row_w.w * 1f));
            let _e221 = (((((_e73.projection.row_x.x * _e189.x) + (_e73.projection.row_x.y * _e189.y)) + (_e73.projection.row_x.z * _e189.z)) + (_e73.projection.row_x.w * 1f)) / _e207);
            let _e235 = (((((_e73.projection.row_y.x * _e189.x) + (_e73.projection.row_y.y * _e189.y)) + (_e73.projection.row_y.z * _e189.z)) + (_e73.projection.row_y.w * 1f)) / _e207);
            let _e248 = ((((_e73.projection.row_z.x * _e189.x) + (_e73.projection.row_z.y * _e189.y)) + (_e73.projection.row_z.z * _e189.z)) + (_e73.projection.row_z.w * 1f));
            if (_e207 > 0f) {
                if (_e221 >= 0f) {
                    phi_356_ = (_e221 <= 1f);
                } else {
                    phi_356_ = false;
                }
                let _e253 = phi_356_;
                if _e253 {
                    if (_e235 >= 0f) {
                        phi_365_ = (_e235 <= 1f);
                    } else {
                        phi_365_ = false;
                    }
                    let _e257 = phi_365_;
                    if _e257 {
                        if (_e248 >= 0f) {
                            phi_374_ = (_e248 <= 1f);
                        } else {
                            phi_374_ = false;
                        }
                        let _e261 = phi_374_;
                        phi_375_ = _e261;
                        phi_376_ = false;
                    } else {
                        phi_375_ = bool();
                        phi_376_ = true;
                    }
                    let _e263 = phi_375_;
                    let _e265 = phi_376_;
                    phi_377_ = _e263;
                    phi_378_ = _e265;
                } else {
                    phi_377_ = bool();
                    phi_378_ = true;
                }
                let _e267 = phi_377_;
                let _e269 = phi_378_;
                phi_379_ = _e267;
                phi_380_ = _e269;
            } else {
                phi_379_ = bool();
                phi_380_ = true;
            }
            let _e271 = phi_379_;
            let _e273 = phi_380_;
            if _e273 {
                phi_384_ = false;
            } else {
                phi_384_ = _e271;
            }
            let _e275 = phi_384_;
            if _e275 {
                if (0f > 0f) {
                    let _e278 = samples.member[(0u + _e63.first_primitive)].normal;
                    let _e280 = p.member.map_size;
                    let _e350 = ((abs(((((_e69.row_x.x * _e278.x) + (_e69.row_x.y * _e278.y)) + (_e69.row_x.z * _e278.z)) / (((_e69.row_x.x * _e69.row_x.x) + (_e69.row_x.y * _e69.row_x.y)) + (_e69.row_x.z * _e69.row_x.z)))) + abs(((((_e69.row_y.x * _e278.x) + (_e69.row_y.y * _e278.y)) + (_e69.row_y.z * _e278.z)) / (((_e69.row_y.x * _e69.row_y.x) + (_e69.row_y.y * _e69.row_y.y)) + (_e69.row_y.z * _e69.row_y.z))))) / (abs(((((_e69.row_z.x * _e278.x) + (_e69.row_z.y * _e278.y)) + (_e69.row_z.z * _e278.z)) / (((_e69.row_z.x * _e69.row_z.x) + (_e69.row_z.y * _e69.row_z.y)) + (_e69.row_z.z * _e69.row_z.z)))) * f32(_e280)));
                    if (_e350 < 0.002f) {
                        phi_474_ = _e350;
                    } else {
                        phi_474_ = 0.002f;
                    }
                    let _e353 = phi_474_;
                    phi_477_ = (_e248 - (0f * _e353));
                } else {
                    phi_477_ = _e248;
                }
                let _e357 = phi_477_;
                let _e359 = p.member.map_size;
                let _e360 = f32(_e359);
                let _e363 = ((_e221 * _e360) - 0.5f);
                let _e364 = ((_e235 * _e360) - 0.5f);
                if (_e363 > -8388608f) {
                    let _e376 = f32(select(0i, select(select(i32(_e363), i32(-2147483648), (_e363 < bitcast<f32>(3472883712u))), 2147483647i, (_e363 > bitcast<f32>(1325400063u))), (_e363 == _e363)));
                    if (_e376 > _e363) {
                        phi_506_ = 1f;
                    } else {
                        phi_506_ = 0f;
                    }
                    let _e379 = phi_506_;
                    if (_e363 < 8388608f) {
                        phi_511_ = (_e376 - _e379);
                        phi_512_ = false;
                    } else {
                        phi_511_ = f32();
                        phi_512_ = true;
                    }
                    let _e382 = phi_511_;
                    let _e384 = phi_512_;
                    phi_513_ = _e382;
                    phi_514_ = _e384;
                } else {
                    phi_513_ = f32();
                    phi_514_ = true;
                }
                let _e386 = phi_513_;
                let _e388 = phi_514_;
                if _e388 {
                    phi_518_ = _e363;
                } else {
                    phi_518_ = _e386;
                }
                let _e390 = phi_518_;
                if (_e364 > -8388608f) {
                    let _e402 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e402 > _e364) {
                        phi_538_ = 1f;
                    } else {
                        phi_538_ = 0f;
                    }
                    let _e405 = phi_538_;
                    if (_e364 < 8388608f) {
                        phi_543_ = (_e402 - _e405);
                        phi_544_ = false;
                    } else {
                        phi_543_ = f32();
                        phi_544_ = true;
                    }
                    let _e408 = phi_543_;
                    let _e410 = phi_544_;
                    phi_545_ = _e408;
                    phi_546_ = _e410;
                } else {
                    phi_545_ = f32();
                    phi_546_ = true;
                }
                let _e412 = phi_545_;
                let _e414 = phi_546_;
                if _e414 {
                    phi_550_ = _e364;
                } else {
                    phi_550_ = _e412;
                }
                let _e416 = phi_550_;
                let _e417 = (_e363 - _e390);
                let _e418 = (_e364 - _e416);
                let _e427 = select(0i, select(select(i32(_e390), i32(-2147483648), (_e390 < bitcast<f32>(3472883712u))), 2147483647i, (_e390 > bitcast<f32>(1325400063u))), (_e390 == _e390));
                let _e436 = select(0i, select(select(i32(_e416), i32(-2147483648), (_e416 < bitcast<f32>(3472883712u))), 2147483647i, (_e416 > bitcast<f32>(1325400063u))), (_e416 == _e416));
                let _e447 = p.member.test;
                let _e448 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e447);
                let _e450 = p.member.map_size;
                local = _e448;
                let _e452 = ((0u * _e450) * _e450);
                let _e454 = (bitcast<i32>(_e450) - 1i);
                if (_e427 > 0i) {
                    phi_598_ = _e427;
                } else {
                    phi_598_ = 0i;
                }
                let _e457 = phi_598_;
                if (_e436 > 0i) {
                    phi_603_ = _e436;
                } else {
                    phi_603_ = 0i;
                }
                let _e460 = phi_603_;
                if (_e457 < _e454) {
                    phi_608_ = _e457;
                } else {
                    phi_608_ = _e454;
                }
                let _e463 = phi_608_;
                if (_e460 < _e454) {
                    phi_613_ = _e460;
                } else {
                    phi_613_ = _e454;
                }
                let _e466 = phi_613_;
                let _e467 = bitcast<u32>(_e463);
                let _e469 = (_e427 + 1i);
                let _e470 = (_e436 + 1i);
                if (_e469 > 0i) {
                    phi_622_ = _e469;
                } else {
                    phi_622_ = 0i;
                }
                let _e473 = phi_622_;
                if (_e470 > 0i) {
                    phi_627_ = _e470;
                } else {
                    phi_627_ = 0i;
                }
                let _e476 = phi_627_;
                if (_e473 < _e454) {
                    phi_632_ = _e473;
                } else {
                    phi_632_ = _e454;
                }
                let _e479 = phi_632_;
                if (_e476 < _e454) {
                    phi_637_ = _e476;
                } else {
                    phi_637_ = _e454;
                }
                let _e482 = phi_637_;
                let _e483 = bitcast<u32>(_e479);
                let _e485 = (bitcast<u32>(_e466) * _e450);
                let _e486 = (bitcast<u32>(_e482) * _e450);
                let _e491 = ((_e485 + _e467) + _e452);
                let _e492 = ((_e485 + _e483) + _e452);
                let _e493 = ((_e486 + _e467) + _e452);
                let _e494 = ((_e486 + _e483) + _e452);
                if (_e491 < _e54) {
                } else {
                    return;
                }
                let _e498 = map.member[(0u + _e491)];
                if (_e492 < _e54) {
                } else {
                    return;
                }
                let _e502 = map.member[(0u + _e492)];
                if (_e493 < _e54) {
                } else {
                    return;
                }
                let _e506 = map.member[(0u + _e493)];
                if (_e494 < _e54) {
                } else {
                    return;
                }
                let _e510 = map.member[(0u + _e494)];
                let _e512 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e498, _e502, _e506, _e510), vec4<f32>(((1f - _e417) * (1f - _e418)), (_e417 * (1f - _e418)), ((1f - _e417) * _e418), (_e417 * _e418)), _e357);
                phi_682_ = evaluate_Verdict(_e512, false);
                phi_683_ = evaluate_Verdict();
                phi_684_ = false;
            } else {
                phi_682_ = evaluate_Verdict();
                phi_683_ = evaluate_Verdict(1f, false);
                phi_684_ = true;
            }
            let _e516 = phi_682_;
            let _e518 = phi_683_;
            let _e520 = phi_684_;
            phi_685_ = _e518;
            phi_686_ = _e516;
            phi_687_ = _e520;
        }
        let _e522 = phi_685_;
        let _e524 = phi_686_;
        let _e526 = phi_687_;
        if _e526 {
            phi_691_ = _e522;
        } else {
            phi_691_ = _e524;
        }
        let _e528 = phi_691_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e528.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
