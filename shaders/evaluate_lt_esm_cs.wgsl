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

struct type_28 {
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
var<uniform> p: type_28;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_140_: lt_bvh_traverse_Tree;
    var phi_141_: bool;
    var phi_142_: lt_bvh_traverse_Tree;
    var phi_143_: bool;
    var phi_148_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_140_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_141_ = false;
        } else {
            phi_140_ = lt_bvh_traverse_Tree();
            phi_141_ = true;
        }
        let _e59 = phi_140_;
        let _e61 = phi_141_;
        phi_142_ = _e59;
        phi_143_ = _e61;
    } else {
        phi_142_ = lt_bvh_traverse_Tree();
        phi_143_ = true;
    }
    let _e63 = phi_142_;
    let _e65 = phi_143_;
    if _e65 {
        phi_148_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_148_ = _e63;
    }
    let _e70 = phi_148_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_168_: bool;
    var phi_172_: f32;

    let _e47 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_168_ = true;
    } else {
        let _e51 = (84f < _e47);
        if _e51 {
        }
        phi_168_ = _e51;
    }
    let _e53 = phi_168_;
    if _e53 {
        phi_172_ = 84f;
    } else {
        phi_172_ = _e47;
    }
    let _e55 = phi_172_;
    return _e55;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_193_: f32;
    var phi_194_: f32;
    var phi_195_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_249_: f32;
    var phi_265_: f32;
    var phi_266_: f32;
    var phi_267_: f32;
    var phi_286_: f32;
    var phi_291_: f32;
    var phi_313_: f32;
    var phi_318_: f32;
    var phi_319_: bool;
    var phi_320_: f32;
    var phi_321_: bool;
    var phi_325_: f32;
    var phi_363_: f32;
    var phi_374_: f32;
    var phi_379_: f32;
    var phi_401_: f32;
    var phi_406_: f32;
    var phi_407_: bool;
    var phi_408_: f32;
    var phi_409_: bool;
    var phi_413_: f32;
    var phi_451_: f32;
    var phi_462_: f32;
    var phi_467_: f32;
    var phi_489_: f32;
    var phi_494_: f32;
    var phi_495_: bool;
    var phi_496_: f32;
    var phi_497_: bool;
    var phi_501_: f32;
    var phi_539_: f32;
    var phi_550_: f32;
    var phi_555_: f32;
    var phi_577_: f32;
    var phi_582_: f32;
    var phi_583_: bool;
    var phi_584_: f32;
    var phi_585_: bool;
    var phi_589_: f32;
    var phi_627_: f32;
    var phi_653_: f32;
    var phi_654_: f32;
    var phi_655_: f32;

    let _e50 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_195_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_194_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_193_ = 1f;
            } else {
                phi_193_ = param_8;
            }
            let _e57 = phi_193_;
            phi_194_ = _e57;
        }
        let _e59 = phi_194_;
        phi_195_ = _e59;
    }
    let _e61 = phi_195_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_213_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_212_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_211_ = 1f;
            } else {
                phi_211_ = param_6.x;
            }
            let _e69 = phi_211_;
            phi_212_ = _e69;
        }
        let _e71 = phi_212_;
        phi_213_ = _e71;
    }
    let _e73 = phi_213_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_231_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_230_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_229_ = 1f;
            } else {
                phi_229_ = param_6.y;
            }
            let _e81 = phi_229_;
            phi_230_ = _e81;
        }
        let _e83 = phi_230_;
        phi_231_ = _e83;
    }
    let _e85 = phi_231_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_249_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_248_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_247_ = 1f;
            } else {
                phi_247_ = param_6.z;
            }
            let _e93 = phi_247_;
            phi_248_ = _e93;
        }
        let _e95 = phi_248_;
        phi_249_ = _e95;
    }
    let _e97 = phi_249_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_267_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_266_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_265_ = 1f;
            } else {
                phi_265_ = param_6.w;
            }
            let _e105 = phi_265_;
            phi_266_ = _e105;
        }
        let _e107 = phi_266_;
        phi_267_ = _e107;
    }
    let _e109 = phi_267_;
    let _e114 = (_e50 * (_e73 - _e61));
    let _e115 = (_e50 * (_e85 - _e61));
    let _e116 = (_e50 * (_e97 - _e61));
    let _e117 = (_e50 * (_e109 - _e61));
    if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
        phi_363_ = _e114;
    } else {
        if (_e114 < -87f) {
            phi_286_ = -87f;
        } else {
            phi_286_ = _e114;
        }
        let _e123 = phi_286_;
        if (_e123 > 88f) {
            phi_291_ = 88f;
        } else {
            phi_291_ = _e123;
        }
        let _e126 = phi_291_;
        let _e128 = ((_e126 * 1.442695f) + 0.5f);
        if (_e128 > -8388608f) {
            let _e140 = f32(select(0i, select(select(i32(_e128), i32(-2147483648), (_e128 < bitcast<f32>(3472883712u))), 2147483647i, (_e128 > bitcast<f32>(1325400063u))), (_e128 == _e128)));
            if (_e140 > _e128) {
                phi_313_ = 1f;
            } else {
                phi_313_ = 0f;
            }
            let _e143 = phi_313_;
            if (_e128 < 8388608f) {
                phi_318_ = (_e140 - _e143);
                phi_319_ = false;
            } else {
                phi_318_ = f32();
                phi_319_ = true;
            }
            let _e146 = phi_318_;
            let _e148 = phi_319_;
            phi_320_ = _e146;
            phi_321_ = _e148;
        } else {
            phi_320_ = f32();
            phi_321_ = true;
        }
        let _e150 = phi_320_;
        let _e152 = phi_321_;
        if _e152 {
            phi_325_ = _e128;
        } else {
            phi_325_ = _e150;
        }
        let _e154 = phi_325_;
        let _e158 = ((_e126 - (_e154 * 0.69314575f)) - (_e154 * 0.0000014286068f));
        phi_363_ = ((((((((((((((((1f / 5040f) * _e158) + (1f / 720f)) * _e158) + (1f / 120f)) * _e158) + (1f / 24f)) * _e158) + (1f / 6f)) * _e158) + 0.5f) * _e158) + 1f) * _e158) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e154), i32(-2147483648), (_e154 < bitcast<f32>(3472883712u))), 2147483647i, (_e154 > bitcast<f32>(1325400063u))), (_e154 == _e154)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e194 = phi_363_;
    if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
        phi_451_ = _e115;
    } else {
        if (_e115 < -87f) {
            phi_374_ = -87f;
        } else {
            phi_374_ = _e115;
        }
        let _e200 = phi_374_;
        if (_e200 > 88f) {
            phi_379_ = 88f;
        } else {
            phi_379_ = _e200;
        }
        let _e203 = phi_379_;
        let _e205 = ((_e203 * 1.442695f) + 0.5f);
        if (_e205 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(_e205), i32(-2147483648), (_e205 < bitcast<f32>(3472883712u))), 2147483647i, (_e205 > bitcast<f32>(1325400063u))), (_e205 == _e205)));
            if (_e217 > _e205) {
                phi_401_ = 1f;
            } else {
                phi_401_ = 0f;
            }
            let _e220 = phi_401_;
            if (_e205 < 8388608f) {
                phi_406_ = (_e217 - _e220);
                phi_407_ = false;
            } else {
                phi_406_ = f32();
                phi_407_ = true;
            }
            let _e223 = phi_406_;
            let _e225 = phi_407_;
            phi_408_ = _e223;
            phi_409_ = _e225;
        } else {
            phi_408_ = f32();
            phi_409_ = true;
        }
        let _e227 = phi_408_;
        let _e229 = phi_409_;
        if _e229 {
            phi_413_ = _e205;
        } else {
            phi_413_ = _e227;
        }
        let _e231 = phi_413_;
        let _e235 = ((_e203 - (_e231 * 0.69314575f)) - (_e231 * 0.0000014286068f));
        phi_451_ = ((((((((((((((((1f / 5040f) * _e235) + (1f / 720f)) * _e235) + (1f / 120f)) * _e235) + (1f / 24f)) * _e235) + (1f / 6f)) * _e235) + 0.5f) * _e235) + 1f) * _e235) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e231), i32(-2147483648), (_e231 < bitcast<f32>(3472883712u))), 2147483647i, (_e231 > bitcast<f32>(1325400063u))), (_e231 == _e231)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e271 = phi_451_;
    if ((bitcast<u32>(_e116) & 2147483647u) > 2139095040u) {
        phi_539_ = _e116;
    } else {
        if (_e116 < -87f) {
            phi_462_ = -87f;
        } else {
            phi_462_ = _e116;
        }
        let _e277 = phi_462_;
        if (_e277 > 88f) {
            phi_467_ = 88f;
        } else {
            phi_467_ = _e277;
        }
        let _e280 = phi_467_;
        let _e282 = ((_e280 * 1.442695f) + 0.5f);
        if (_e282 > -8388608f) {
            let _e294 = f32(select(0i, select(select(i32(_e282), i32(-2147483648), (_e282 < bitcast<f32>(3472883712u))), 2147483647i, (_e282 > bitcast<f32>(1325400063u))), (_e282 == _e282)));
            if (_e294 > _e282) {
                phi_489_ = 1f;
            } else {
                phi_489_ = 0f;
            }
            let _e297 = phi_489_;
            if (_e282 < 8388608f) {
                phi_494_ = (_e294 - _e297);
                phi_495_ = false;
            } else {
                phi_494_ = f32();
                phi_495_ = true;
            }
            let _e300 = phi_494_;
            let _e302 = phi_495_;
            phi_496_ = _e300;
            phi_497_ = _e302;
        } else {
            phi_496_ = f32();
            phi_497_ = true;
        }
        let _e304 = phi_496_;
        let _e306 = phi_497_;
        if _e306 {
            phi_501_ = _e282;
        } else {
            phi_501_ = _e304;
        }
        let _e308 = phi_501_;
        let _e312 = ((_e280 - (_e308 * 0.69314575f)) - (_e308 * 0.0000014286068f));
        phi_539_ = ((((((((((((((((1f / 5040f) * _e312) + (1f / 720f)) * _e312) + (1f / 120f)) * _e312) + (1f / 24f)) * _e312) + (1f / 6f)) * _e312) + 0.5f) * _e312) + 1f) * _e312) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e308), i32(-2147483648), (_e308 < bitcast<f32>(3472883712u))), 2147483647i, (_e308 > bitcast<f32>(1325400063u))), (_e308 == _e308)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e348 = phi_539_;
    if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
        phi_627_ = _e117;
    } else {
        if (_e117 < -87f) {
            phi_550_ = -87f;
        } else {
            phi_550_ = _e117;
        }
        let _e354 = phi_550_;
        if (_e354 > 88f) {
            phi_555_ = 88f;
        } else {
            phi_555_ = _e354;
        }
        let _e357 = phi_555_;
        let _e359 = ((_e357 * 1.442695f) + 0.5f);
        if (_e359 > -8388608f) {
            let _e371 = f32(select(0i, select(select(i32(_e359), i32(-2147483648), (_e359 < bitcast<f32>(3472883712u))), 2147483647i, (_e359 > bitcast<f32>(1325400063u))), (_e359 == _e359)));
            if (_e371 > _e359) {
                phi_577_ = 1f;
            } else {
                phi_577_ = 0f;
            }
            let _e374 = phi_577_;
            if (_e359 < 8388608f) {
                phi_582_ = (_e371 - _e374);
                phi_583_ = false;
            } else {
                phi_582_ = f32();
                phi_583_ = true;
            }
            let _e377 = phi_582_;
            let _e379 = phi_583_;
            phi_584_ = _e377;
            phi_585_ = _e379;
        } else {
            phi_584_ = f32();
            phi_585_ = true;
        }
        let _e381 = phi_584_;
        let _e383 = phi_585_;
        if _e383 {
            phi_589_ = _e359;
        } else {
            phi_589_ = _e381;
        }
        let _e385 = phi_589_;
        let _e389 = ((_e357 - (_e385 * 0.69314575f)) - (_e385 * 0.0000014286068f));
        phi_627_ = ((((((((((((((((1f / 5040f) * _e389) + (1f / 720f)) * _e389) + (1f / 120f)) * _e389) + (1f / 24f)) * _e389) + (1f / 6f)) * _e389) + 0.5f) * _e389) + 1f) * _e389) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e385), i32(-2147483648), (_e385 < bitcast<f32>(3472883712u))), 2147483647i, (_e385 > bitcast<f32>(1325400063u))), (_e385 == _e385)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e425 = phi_627_;
    let _e436 = ((((_e194 * param_7.x) + (_e271 * param_7.y)) + (_e348 * param_7.z)) + (_e425 * param_7.w));
    if ((bitcast<u32>(_e436) & 2147483647u) > 2139095040u) {
        phi_655_ = _e436;
    } else {
        if (_e436 < 0f) {
            phi_654_ = 0f;
        } else {
            if (_e436 > 1f) {
                phi_653_ = 1f;
            } else {
                phi_653_ = _e436;
            }
            let _e443 = phi_653_;
            phi_654_ = _e443;
        }
        let _e445 = phi_654_;
        phi_655_ = _e445;
    }
    let _e447 = phi_655_;
    return _e447;
}

fn function_() {
    var local: f32;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_714_: bool;
    var phi_715_: bool;
    var phi_719_: bool;
    var phi_763_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_767_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_841_: bool;
    var phi_850_: bool;
    var phi_859_: bool;
    var phi_860_: bool;
    var phi_861_: bool;
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_865_: bool;
    var phi_869_: bool;
    var phi_959_: f32;
    var phi_962_: f32;
    var phi_991_: f32;
    var phi_996_: f32;
    var phi_997_: bool;
    var phi_998_: f32;
    var phi_999_: bool;
    var phi_1003_: f32;
    var phi_1023_: f32;
    var phi_1028_: f32;
    var phi_1029_: bool;
    var phi_1030_: f32;
    var phi_1031_: bool;
    var phi_1035_: f32;
    var phi_1083_: i32;
    var phi_1088_: i32;
    var phi_1093_: i32;
    var phi_1098_: i32;
    var phi_1107_: i32;
    var phi_1112_: i32;
    var phi_1117_: i32;
    var phi_1122_: i32;
    var phi_1173_: bool;
    var phi_1181_: bool;
    var phi_1193_: bool;
    var phi_1194_: bool;
    var phi_1198_: f32;
    var phi_1204_: f32;
    var phi_1206_: evaluate_Verdict;
    var phi_1211_: evaluate_Verdict;
    var phi_1212_: evaluate_Verdict;

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
                phi_712_ = (_e88 == _e90);
                phi_713_ = false;
            } else {
                phi_712_ = bool();
                phi_713_ = true;
            }
            let _e93 = phi_712_;
            let _e95 = phi_713_;
            phi_714_ = _e93;
            phi_715_ = _e95;
        } else {
            phi_714_ = bool();
            phi_715_ = true;
        }
        let _e97 = phi_714_;
        let _e99 = phi_715_;
        if _e99 {
            phi_719_ = false;
        } else {
            phi_719_ = _e97;
        }
        let _e101 = phi_719_;
        if !(_e101) {
            let _e104 = samples.member[(0u + _e63.first_primitive)].normal;
            let _e106 = samples.member[(0u + _e63.first_primitive)].position;
            if ((((_e104.x * (_e75.x - (_e106.x * _e75.w))) + (_e104.y * (_e75.y - (_e106.y * _e75.w)))) + (_e104.z * (_e75.z - (_e106.z * _e75.w)))) > 0f) {
                let _e130 = samples.member[(0u + _e63.first_primitive)].flags;
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_763_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, ((_e130 & 1u) == 0u));
            } else {
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e153.unnamed.visibility, false), _e153.unnamed_1);
                phi_763_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e159.unnamed, true);
            }
            let _e164 = phi_763_;
            phi_767_ = _e164;
        } else {
            let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
            phi_767_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, true);
        }
        let _e181 = phi_767_;
        if _e181.unnamed_1 {
            phi_1212_ = evaluate_Verdict(_e181.unnamed.visibility, _e181.unnamed.is_doubted);
        } else {
            let _e189 = samples.member[(0u + _e63.first_primitive)].position;
            let _e207 = ((((_e73.projection.row_w.x * _e189.x) + (_e73.projection.row_w.y * _e189.y)) + (_e73.projection.row_w.z * _e189.z)) + (_e73.projection.row_w.w * 1f));
            let _e221 = (((((_e73.projection.row_x.x * _e189.x) + (_e73.projection.row_x.y * _e189.y)) + (_e73.projection.row_x.z * _e189.z)) + (_e73.projection.row_x.w * 1f)) / _e207);
            let _e235 = (((((_e73.projection.row_y.x * _e189.x) + (_e73.projection.row_y.y * _e189.y)) + (_e73.projection.row_y.z * _e189.z)) + (_e73.projection.row_y.w * 1f)) / _e207);
            let _e248 = ((((_e73.projection.row_z.x * _e189.x) + (_e73.projection.row_z.y * _e189.y)) + (_e73.projection.row_z.z * _e189.z)) + (_e73.projection.row_z.w * 1f));
            if (_e207 > 0f) {
                if (_e221 >= 0f) {
                    phi_841_ = (_e221 <= 1f);
                } else {
                    phi_841_ = false;
                }
                let _e253 = phi_841_;
                if _e253 {
                    if (_e235 >= 0f) {
                        phi_850_ = (_e235 <= 1f);
                    } else {
                        phi_850_ = false;
                    }
                    let _e257 = phi_850_;
                    if _e257 {
                        if (_e248 >= 0f) {
                            phi_859_ = (_e248 <= 1f);
                        } else {
                            phi_859_ = false;
                        }
                        let _e261 = phi_859_;
                        phi_860_ = _e261;
                        phi_861_ = false;
                    } else {
                        phi_860_ = bool();
                        phi_861_ = true;
                    }
                    let _e263 = phi_860_;
                    let _e265 = phi_861_;
                    phi_862_ = _e263;
                    phi_863_ = _e265;
                } else {
                    phi_862_ = bool();
                    phi_863_ = true;
                }
                let _e267 = phi_862_;
                let _e269 = phi_863_;
                phi_864_ = _e267;
                phi_865_ = _e269;
            } else {
                phi_864_ = bool();
                phi_865_ = true;
            }
            let _e271 = phi_864_;
            let _e273 = phi_865_;
            if _e273 {
                phi_869_ = false;
            } else {
                phi_869_ = _e271;
            }
            let _e275 = phi_869_;
            if _e275 {
                if (0f > 0f) {
                    let _e278 = samples.member[(0u + _e63.first_primitive)].normal;
                    let _e280 = p.member.map_size;
                    let _e350 = ((abs(((((_e69.row_x.x * _e278.x) + (_e69.row_x.y * _e278.y)) + (_e69.row_x.z * _e278.z)) / (((_e69.row_x.x * _e69.row_x.x) + (_e69.row_x.y * _e69.row_x.y)) + (_e69.row_x.z * _e69.row_x.z)))) + abs(((((_e69.row_y.x * _e278.x) + (_e69.row_y.y * _e278.y)) + (_e69.row_y.z * _e278.z)) / (((_e69.row_y.x * _e69.row_y.x) + (_e69.row_y.y * _e69.row_y.y)) + (_e69.row_y.z * _e69.row_y.z))))) / (abs(((((_e69.row_z.x * _e278.x) + (_e69.row_z.y * _e278.y)) + (_e69.row_z.z * _e278.z)) / (((_e69.row_z.x * _e69.row_z.x) + (_e69.row_z.y * _e69.row_z.y)) + (_e69.row_z.z * _e69.row_z.z)))) * f32(_e280)));
                    if (_e350 < 0.002f) {
                        phi_959_ = _e350;
                    } else {
                        phi_959_ = 0.002f;
                    }
                    let _e353 = phi_959_;
                    phi_962_ = (_e248 - (0f * _e353));
                } else {
                    phi_962_ = _e248;
                }
                let _e357 = phi_962_;
                let _e359 = p.member.map_size;
                let _e360 = f32(_e359);
                let _e363 = ((_e221 * _e360) - 0.5f);
                let _e364 = ((_e235 * _e360) - 0.5f);
                if (_e363 > -8388608f) {
                    let _e376 = f32(select(0i, select(select(i32(_e363), i32(-2147483648), (_e363 < bitcast<f32>(3472883712u))), 2147483647i, (_e363 > bitcast<f32>(1325400063u))), (_e363 == _e363)));
                    if (_e376 > _e363) {
                        phi_991_ = 1f;
                    } else {
                        phi_991_ = 0f;
                    }
                    let _e379 = phi_991_;
                    if (_e363 < 8388608f) {
                        phi_996_ = (_e376 - _e379);
                        phi_997_ = false;
                    } else {
                        phi_996_ = f32();
                        phi_997_ = true;
                    }
                    let _e382 = phi_996_;
                    let _e384 = phi_997_;
                    phi_998_ = _e382;
                    phi_999_ = _e384;
                } else {
                    phi_998_ = f32();
                    phi_999_ = true;
                }
                let _e386 = phi_998_;
                let _e388 = phi_999_;
                if _e388 {
                    phi_1003_ = _e363;
                } else {
                    phi_1003_ = _e386;
                }
                let _e390 = phi_1003_;
                if (_e364 > -8388608f) {
                    let _e402 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e402 > _e364) {
                        phi_1023_ = 1f;
                    } else {
                        phi_1023_ = 0f;
                    }
                    let _e405 = phi_1023_;
                    if (_e364 < 8388608f) {
                        phi_1028_ = (_e402 - _e405);
                        phi_1029_ = false;
                    } else {
                        phi_1028_ = f32();
                        phi_1029_ = true;
                    }
                    let _e408 = phi_1028_;
                    let _e410 = phi_1029_;
                    phi_1030_ = _e408;
                    phi_1031_ = _e410;
                } else {
                    phi_1030_ = f32();
                    phi_1031_ = true;
                }
                let _e412 = phi_1030_;
                let _e414 = phi_1031_;
                if _e414 {
                    phi_1035_ = _e364;
                } else {
                    phi_1035_ = _e412;
                }
                let _e416 = phi_1035_;
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
                    phi_1083_ = _e427;
                } else {
                    phi_1083_ = 0i;
                }
                let _e457 = phi_1083_;
                if (_e436 > 0i) {
                    phi_1088_ = _e436;
                } else {
                    phi_1088_ = 0i;
                }
                let _e460 = phi_1088_;
                if (_e457 < _e454) {
                    phi_1093_ = _e457;
                } else {
                    phi_1093_ = _e454;
                }
                let _e463 = phi_1093_;
                if (_e460 < _e454) {
                    phi_1098_ = _e460;
                } else {
                    phi_1098_ = _e454;
                }
                let _e466 = phi_1098_;
                let _e467 = bitcast<u32>(_e463);
                let _e469 = (_e427 + 1i);
                let _e470 = (_e436 + 1i);
                if (_e469 > 0i) {
                    phi_1107_ = _e469;
                } else {
                    phi_1107_ = 0i;
                }
                let _e473 = phi_1107_;
                if (_e470 > 0i) {
                    phi_1112_ = _e470;
                } else {
                    phi_1112_ = 0i;
                }
                let _e476 = phi_1112_;
                if (_e473 < _e454) {
                    phi_1117_ = _e473;
                } else {
                    phi_1117_ = _e454;
                }
                let _e479 = phi_1117_;
                if (_e476 < _e454) {
                    phi_1122_ = _e476;
                } else {
                    phi_1122_ = _e454;
                }
                let _e482 = phi_1122_;
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
                let _e514 = p.member.epsilon;
                if (_e512 <= _e514) {
                    phi_1173_ = true;
                } else {
                    phi_1173_ = (_e512 >= (1f - _e514));
                }
                let _e519 = phi_1173_;
                if ((bitcast<u32>(_e512) & 2147483647u) > 2139095040u) {
                    phi_1181_ = true;
                } else {
                    phi_1181_ = !(_e519);
                }
                let _e525 = phi_1181_;
                if _e525 {
                    if (_e512 > 0f) {
                        if (_e512 < 1f) {
                            phi_1193_ = false;
                        } else {
                            phi_1193_ = true;
                        }
                        let _e529 = phi_1193_;
                        phi_1194_ = _e529;
                    } else {
                        phi_1194_ = true;
                    }
                    let _e531 = phi_1194_;
                    if _e531 {
                        phi_1198_ = 0.5f;
                    } else {
                        phi_1198_ = _e512;
                    }
                    let _e533 = phi_1198_;
                    phi_1206_ = evaluate_Verdict(_e533, true);
                } else {
                    if (_e512 > 0.5f) {
                        phi_1204_ = 1f;
                    } else {
                        phi_1204_ = 0f;
                    }
                    let _e537 = phi_1204_;
                    phi_1206_ = evaluate_Verdict(_e537, false);
                }
                let _e540 = phi_1206_;
                phi_1211_ = evaluate_Verdict(_e540.visibility, _e540.is_doubted);
            } else {
                phi_1211_ = evaluate_Verdict(0.5f, true);
            }
            let _e546 = phi_1211_;
            phi_1212_ = _e546;
        }
        let _e548 = phi_1212_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e548.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
