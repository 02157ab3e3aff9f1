struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_10 {
    member: array<abi_Sample>,
}

struct type_14 {
    member: array<u32>,
}

struct type_18 {
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

struct type_36 {
    member: abi_ShadowParams,
}

struct type_43 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_36;
@group(0) @binding(2) 
var<storage> map: type_18;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_43;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_155_: lt_bvh_traverse_Tree;
    var phi_156_: bool;
    var phi_157_: lt_bvh_traverse_Tree;
    var phi_158_: bool;
    var phi_163_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_155_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_156_ = false;
        } else {
            phi_155_ = lt_bvh_traverse_Tree();
            phi_156_ = true;
        }
        let _e63 = phi_155_;
        let _e65 = phi_156_;
        phi_157_ = _e63;
        phi_158_ = _e65;
    } else {
        phi_157_ = lt_bvh_traverse_Tree();
        phi_158_ = true;
    }
    let _e67 = phi_157_;
    let _e69 = phi_158_;
    if _e69 {
        phi_163_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_163_ = _e67;
    }
    let _e74 = phi_163_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_183_: bool;
    var phi_187_: f32;

    let _e51 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_183_ = true;
    } else {
        let _e55 = (84f < _e51);
        if _e55 {
        }
        phi_183_ = _e55;
    }
    let _e57 = phi_183_;
    if _e57 {
        phi_187_ = 84f;
    } else {
        phi_187_ = _e51;
    }
    let _e59 = phi_187_;
    return _e59;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_208_: f32;
    var phi_209_: f32;
    var phi_210_: f32;
    var phi_226_: f32;
    var phi_227_: f32;
    var phi_228_: f32;
    var phi_244_: f32;
    var phi_245_: f32;
    var phi_246_: f32;
    var phi_262_: f32;
    var phi_263_: f32;
    var phi_264_: f32;
    var phi_280_: f32;
    var phi_281_: f32;
    var phi_282_: f32;
    var phi_301_: f32;
    var phi_306_: f32;
    var phi_328_: f32;
    var phi_333_: f32;
    var phi_334_: bool;
    var phi_335_: f32;
    var phi_336_: bool;
    var phi_340_: f32;
    var phi_378_: f32;
    var phi_389_: f32;
    var phi_394_: f32;
    var phi_416_: f32;
    var phi_421_: f32;
    var phi_422_: bool;
    var phi_423_: f32;
    var phi_424_: bool;
    var phi_428_: f32;
    var phi_466_: f32;
    var phi_477_: f32;
    var phi_482_: f32;
    var phi_504_: f32;
    var phi_509_: f32;
    var phi_510_: bool;
    var phi_511_: f32;
    var phi_512_: bool;
    var phi_516_: f32;
    var phi_554_: f32;
    var phi_565_: f32;
    var phi_570_: f32;
    var phi_592_: f32;
    var phi_597_: f32;
    var phi_598_: bool;
    var phi_599_: f32;
    var phi_600_: bool;
    var phi_604_: f32;
    var phi_642_: f32;
    var phi_668_: f32;
    var phi_669_: f32;
    var phi_670_: f32;

    let _e54 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_210_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_209_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_208_ = 1f;
            } else {
                phi_208_ = param_8;
            }
            let _e61 = phi_208_;
            phi_209_ = _e61;
        }
        let _e63 = phi_209_;
        phi_210_ = _e63;
    }
    let _e65 = phi_210_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_228_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_227_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_226_ = 1f;
            } else {
                phi_226_ = param_6.x;
            }
            let _e73 = phi_226_;
            phi_227_ = _e73;
        }
        let _e75 = phi_227_;
        phi_228_ = _e75;
    }
    let _e77 = phi_228_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_246_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_245_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_244_ = 1f;
            } else {
                phi_244_ = param_6.y;
            }
            let _e85 = phi_244_;
            phi_245_ = _e85;
        }
        let _e87 = phi_245_;
        phi_246_ = _e87;
    }
    let _e89 = phi_246_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_264_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_263_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_262_ = 1f;
            } else {
                phi_262_ = param_6.z;
            }
            let _e97 = phi_262_;
            phi_263_ = _e97;
        }
        let _e99 = phi_263_;
        phi_264_ = _e99;
    }
    let _e101 = phi_264_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_282_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_281_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_280_ = 1f;
            } else {
                phi_280_ = param_6.w;
            }
            let _e109 = phi_280_;
            phi_281_ = _e109;
        }
        let _e111 = phi_281_;
        phi_282_ = _e111;
    }
    let _e113 = phi_282_;
    let _e118 = (_e54 * (_e77 - _e65));
    let _e119 = (_e54 * (_e89 - _e65));
    let _e120 = (_e54 * (_e101 - _e65));
    let _e121 = (_e54 * (_e113 - _e65));
    if ((bitcast<u32>(_e118) & 2147483647u) > 2139095040u) {
        phi_378_ = _e118;
    } else {
        if (_e118 < -87f) {
            phi_301_ = -87f;
        } else {
            phi_301_ = _e118;
        }
        let _e127 = phi_301_;
        if (_e127 > 88f) {
            phi_306_ = 88f;
        } else {
            phi_306_ = _e127;
        }
        let _e130 = phi_306_;
        let _e132 = ((_e130 * 1.442695f) + 0.5f);
        if (_e132 > -8388608f) {
            let _e144 = f32(select(0i, select(select(i32(_e132), i32(-2147483648), (_e132 < bitcast<f32>(3472883712u))), 2147483647i, (_e132 > bitcast<f32>(1325400063u))), (_e132 == _e132)));
            if (_e144 > _e132) {
                phi_328_ = 1f;
            } else {
                phi_328_ = 0f;
            }
            let _e147 = phi_328_;
            if (_e132 < 8388608f) {
                phi_333_ = (_e144 - _e147);
                phi_334_ = false;
            } else {
                phi_333_ = f32();
                phi_334_ = true;
            }
            let _e150 = phi_333_;
            let _e152 = phi_334_;
            phi_335_ = _e150;
            phi_336_ = _e152;
        } else {
            phi_335_ = f32();
            phi_336_ = true;
        }
        let _e154 = phi_335_;
        let _e156 = phi_336_;
        if _e156 {
            phi_340_ = _e132;
        } else {
            phi_340_ = _e154;
        }
        let _e158 = phi_340_;
        let _e162 = ((_e130 - (_e158 * 0.69314575f)) - (_e158 * 0.0000014286068f));
        phi_378_ = ((((((((((((((((1f / 5040f) * _e162) + (1f / 720f)) * _e162) + (1f / 120f)) * _e162) + (1f / 24f)) * _e162) + (1f / 6f)) * _e162) + 0.5f) * _e162) + 1f) * _e162) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e158), i32(-2147483648), (_e158 < bitcast<f32>(3472883712u))), 2147483647i, (_e158 > bitcast<f32>(1325400063u))), (_e158 == _e158)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e198 = phi_378_;
    if ((bitcast<u32>(_e119) & 2147483647u) > 2139095040u) {
        phi_466_ = _e119;
    } else {
        if (_e119 < -87f) {
            phi_389_ = -87f;
        } else {
            phi_389_ = _e119;
        }
        let _e204 = phi_389_;
        if (_e204 > 88f) {
            phi_394_ = 88f;
        } else {
            phi_394_ = _e204;
        }
        let _e207 = phi_394_;
        let _e209 = ((_e207 * 1.442695f) + 0.5f);
        if (_e209 > -8388608f) {
            let _e221 = f32(select(0i, select(select(i32(_e209), i32(-2147483648), (_e209 < bitcast<f32>(3472883712u))), 2147483647i, (_e209 > bitcast<f32>(1325400063u))), (_e209 == _e209)));
            if (_e221 > _e209) {
                phi_416_ = 1f;
            } else {
                phi_416_ = 0f;
            }
            let _e224 = phi_416_;
            if (_e209 < 8388608f) {
                phi_421_ = (_e221 - _e224);
                phi_422_ = false;
            } else {
                phi_421_ = f32();
                phi_422_ = true;
            }
            let _e227 = phi_421_;
            let _e229 = phi_422_;
            phi_423_ = _e227;
            phi_424_ = _e229;
        } else {
            phi_423_ = f32();
            phi_424_ = true;
        }
        let _e231 = phi_423_;
        let _e233 = phi_424_;
        if _e233 {
            phi_428_ = _e209;
        } else {
            phi_428_ = _e231;
        }
        let _e235 = phi_428_;
        let _e239 = ((_e207 - (_e235 * 0.69314575f)) - (_e235 * 0.0000014286068f));
        phi_466_ = ((((((((((((((((1f / 5040f) * _e239) + (1f / 720f)) * _e239) + (1f / 120f)) * _e239) + (1f / 24f)) * _e239) + (1f / 6f)) * _e239) + 0.5f) * _e239) + 1f) * _e239) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e235), i32(-2147483648), (_e235 < bitcast<f32>(3472883712u))), 2147483647i, (_e235 > bitcast<f32>(1325400063u))), (_e235 == _e235)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e275 = phi_466_;
    if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
        phi_554_ = _e120;
    } else {
        if (_e120 < -87f) {
            phi_477_ = -87f;
        } else {
            phi_477_ = _e120;
        }
        let _e281 = phi_477_;
        if (_e281 > 88f) {
            phi_482_ = 88f;
        } else {
            phi_482_ = _e281;
        }
        let _e284 = phi_482_;
        let _e286 = ((_e284 * 1.442695f) + 0.5f);
        if (_e286 > -8388608f) {
            let _e298 = f32(select(0i, select(select(i32(_e286), i32(-2147483648), (_e286 < bitcast<f32>(3472883712u))), 2147483647i, (_e286 > bitcast<f32>(1325400063u))), (_e286 == _e286)));
            if (_e298 > _e286) {
                phi_504_ = 1f;
            } else {
                phi_504_ = 0f;
            }
            let _e301 = phi_504_;
            if (_e286 < 8388608f) {
                phi_509_ = (_e298 - _e301);
                phi_510_ = false;
            } else {
                phi_509_ = f32();
                phi_510_ = true;
            }
            let _e304 = phi_509_;
            let _e306 = phi_510_;
            phi_511_ = _e304;
            phi_512_ = _e306;
        } else {
            phi_511_ = f32();
            phi_512_ = true;
        }
        let _e308 = phi_511_;
        let _e310 = phi_512_;
        if _e310 {
            phi_516_ = _e286;
        } else {
            phi_516_ = _e308;
        }
        let _e312 = phi_516_;
        let _e316 = ((_e284 - (_e312 * 0.69314575f)) - (_e312 * 0.0000014286068f));
        phi_554_ = ((((((((((((((((1f / 5040f) * _e316) + (1f / 720f)) * _e316) + (1f / 120f)) * _e316) + (1f / 24f)) * _e316) + (1f / 6f)) * _e316) + 0.5f) * _e316) + 1f) * _e316) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e312), i32(-2147483648), (_e312 < bitcast<f32>(3472883712u))), 2147483647i, (_e312 > bitcast<f32>(1325400063u))), (_e312 == _e312)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e352 = phi_554_;
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_642_ = _e121;
    } else {
        if (_e121 < -87f) {
            phi_565_ = -87f;
        } else {
            phi_565_ = _e121;
        }
        let _e358 = phi_565_;
        if (_e358 > 88f) {
            phi_570_ = 88f;
        } else {
            phi_570_ = _e358;
        }
        let _e361 = phi_570_;
        let _e363 = ((_e361 * 1.442695f) + 0.5f);
        if (_e363 > -8388608f) {
            let _e375 = f32(select(0i, select(select(i32(_e363), i32(-2147483648), (_e363 < bitcast<f32>(3472883712u))), 2147483647i, (_e363 > bitcast<f32>(1325400063u))), (_e363 == _e363)));
            if (_e375 > _e363) {
                phi_592_ = 1f;
            } else {
                phi_592_ = 0f;
            }
            let _e378 = phi_592_;
            if (_e363 < 8388608f) {
                phi_597_ = (_e375 - _e378);
                phi_598_ = false;
            } else {
                phi_597_ = f32();
                phi_598_ = true;
            }
            let _e381 = phi_597_;
            let _e383 = phi_598_;
            phi_599_ = _e381;
            phi_600_ = _e383;
        } else {
            phi_599_ = f32();
            phi_600_ = true;
        }
        let _e385 = phi_599_;
        let _e387 = phi_600_;
        if _e387 {
            phi_604_ = _e363;
        } else {
            phi_604_ = _e385;
        }
        let _e389 = phi_604_;
        let _e393 = ((_e361 - (_e389 * 0.69314575f)) - (_e389 * 0.0000014286068f));
        phi_642_ = ((((((((((((((((1f / 5040f) * _e393) + (1f / 720f)) * _e393) + (1f / 120f)) * _e393) + (1f / 24f)) * _e393) + (1f / 6f)) * _e393) + 0.5f) * _e393) + 1f) * _e393) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e389), i32(-2147483648), (_e389 < bitcast<f32>(3472883712u))), 2147483647i, (_e389 > bitcast<f32>(1325400063u))), (_e389 == _e389)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e429 = phi_642_;
    let _e440 = ((((_e198 * param_7.x) + (_e275 * param_7.y)) + (_e352 * param_7.z)) + (_e429 * param_7.w));
    if ((bitcast<u32>(_e440) & 2147483647u) > 2139095040u) {
        phi_670_ = _e440;
    } else {
        if (_e440 < 0f) {
            phi_669_ = 0f;
        } else {
            if (_e440 > 1f) {
                phi_668_ = 1f;
            } else {
                phi_668_ = _e440;
            }
            let _e447 = phi_668_;
            phi_669_ = _e447;
        }
        let _e449 = phi_669_;
        phi_670_ = _e449;
    }
    let _e451 = phi_670_;
    return _e451;
}

fn function_() {
    var local_1: f32;
    var phi_719_: bool;
    var phi_720_: bool;
    var phi_721_: bool;
    var phi_722_: bool;
    var phi_726_: bool;
    var phi_770_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_774_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_851_: bool;
    var phi_860_: bool;
    var phi_869_: bool;
    var phi_870_: bool;
    var phi_871_: bool;
    var phi_872_: bool;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_879_: bool;
    var phi_973_: f32;
    var phi_976_: f32;
    var phi_1005_: f32;
    var phi_1010_: f32;
    var phi_1011_: bool;
    var phi_1012_: f32;
    var phi_1013_: bool;
    var phi_1017_: f32;
    var phi_1037_: f32;
    var phi_1042_: f32;
    var phi_1043_: bool;
    var phi_1044_: f32;
    var phi_1045_: bool;
    var phi_1049_: f32;
    var phi_1095_: i32;
    var phi_1100_: i32;
    var phi_1105_: i32;
    var phi_1110_: i32;
    var phi_1119_: i32;
    var phi_1124_: i32;
    var phi_1129_: i32;
    var phi_1134_: i32;
    var phi_1181_: bool;
    var phi_1189_: bool;
    var phi_1201_: bool;
    var phi_1202_: bool;
    var phi_1206_: f32;
    var phi_1212_: f32;
    var phi_1214_: evaluate_Verdict;
    var phi_1219_: evaluate_Verdict;
    var phi_1220_: evaluate_Verdict;
    var phi_1224_: bool;
    var phi_1225_: u32;
    var phi_1236_: u32;

    let _e51 = id_1;
    let _e52 = local_2;
    let _e57 = arrayLength((&map.member));
    let _e62 = p.member.size[0u];
    let _e64 = p.member.size[1u];
    let _e65 = lt_shaders_entry_pixel_index(_e51, _e62, _e64);
    if (bitcast<i32>(_e65.root) != 0i) {
        let _e72 = p.member.light;
        let _e75 = samples.member[_e65.first_primitive].normal[0u];
        let _e77 = global[0u];
        if (_e75 == _e77) {
            let _e80 = samples.member[_e65.first_primitive].normal[1u];
            let _e82 = global[1u];
            if (_e80 == _e82) {
                let _e85 = samples.member[_e65.first_primitive].normal[2u];
                let _e87 = global[2u];
                phi_719_ = (_e85 == _e87);
                phi_720_ = false;
            } else {
                phi_719_ = bool();
                phi_720_ = true;
            }
            let _e90 = phi_719_;
            let _e92 = phi_720_;
            phi_721_ = _e90;
            phi_722_ = _e92;
        } else {
            phi_721_ = bool();
            phi_722_ = true;
        }
        let _e94 = phi_721_;
        let _e96 = phi_722_;
        if _e96 {
            phi_726_ = false;
        } else {
            phi_726_ = _e94;
        }
        let _e98 = phi_726_;
        if !(_e98) {
            let _e101 = samples.member[_e65.first_primitive].normal;
            let _e103 = samples.member[_e65.first_primitive].position;
            if ((((_e101.x * (_e72.x - (_e103.x * _e72.w))) + (_e101.y * (_e72.y - (_e103.y * _e72.w)))) + (_e101.z * (_e72.z - (_e103.z * _e72.w)))) > 0f) {
                let _e127 = samples.member[_e65.first_primitive].flags;
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e135.unnamed.visibility, false), _e135.unnamed_1);
                phi_770_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e141.unnamed, ((_e127 & 1u) == 0u));
            } else {
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e150.unnamed.visibility, false), _e150.unnamed_1);
                phi_770_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e156.unnamed, true);
            }
            let _e161 = phi_770_;
            phi_774_ = _e161;
        } else {
            let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
            phi_774_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, true);
        }
        let _e178 = phi_774_;
        if _e178.unnamed_1 {
            phi_1220_ = evaluate_Verdict(_e178.unnamed.visibility, _e178.unnamed.is_doubted);
        } else {
            let _e186 = samples.member[_e65.first_primitive].position;
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
                    phi_851_ = (_e217 <= 1f);
                } else {
                    phi_851_ = false;
                }
                let _e249 = phi_851_;
                if _e249 {
                    if (_e231 >= 0f) {
                        phi_860_ = (_e231 <= 1f);
                    } else {
                        phi_860_ = false;
                    }
                    let _e253 = phi_860_;
                    if _e253 {
                        if (_e244 >= 0f) {
                            phi_869_ = (_e244 <= 1f);
                        } else {
                            phi_869_ = false;
                        }
                        let _e257 = phi_869_;
                        phi_870_ = _e257;
                        phi_871_ = false;
                    } else {
                        phi_870_ = bool();
                        phi_871_ = true;
                    }
                    let _e259 = phi_870_;
                    let _e261 = phi_871_;
                    phi_872_ = _e259;
                    phi_873_ = _e261;
                } else {
                    phi_872_ = bool();
                    phi_873_ = true;
                }
                let _e263 = phi_872_;
                let _e265 = phi_873_;
                phi_874_ = _e263;
                phi_875_ = _e265;
            } else {
                phi_874_ = bool();
                phi_875_ = true;
            }
            let _e267 = phi_874_;
            let _e269 = phi_875_;
            if _e269 {
                phi_879_ = false;
            } else {
                phi_879_ = _e267;
            }
            let _e271 = phi_879_;
            if _e271 {
                if (0f > 0f) {
                    let _e274 = samples.member[_e65.first_primitive].normal;
                    let _e276 = p.member.map_size;
                    let _e279 = p.member.projection.row_x;
                    let _e301 = p.member.projection.row_y;
                    let _e323 = p.member.projection.row_z;
                    let _e350 = ((abs(((((_e279.x * _e274.x) + (_e279.y * _e274.y)) + (_e279.z * _e274.z)) / (((_e279.x * _e279.x) + (_e279.y * _e279.y)) + (_e279.z * _e279.z)))) + abs(((((_e301.x * _e274.x) + (_e301.y * _e274.y)) + (_e301.z * _e274.z)) / (((_e301.x * _e301.x) + (_e301.y * _e301.y)) + (_e301.z * _e301.z))))) / (abs(((((_e323.x * _e274.x) + (_e323.y * _e274.y)) + (_e323.z * _e274.z)) / (((_e323.x * _e323.x) + (_e323.y * _e323.y)) + (_e323.z * _e323.z)))) * f32(_e276)));
                    if (_e350 < 0.002f) {
                        phi_973_ = _e350;
                    } else {
                        phi_973_ = 0.002f;
                    }
                    let _e353 = phi_973_;
                    phi_976_ = (_e244 - (0f * _e353));
                } else {
                    phi_976_ = _e244;
                }
                let _e357 = phi_976_;
                let _e359 = p.member.map_size;
                let _e360 = f32(_e359);
                let _e363 = ((_e217 * _e360) - 0.5f);
                let _e364 = ((_e231 * _e360) - 0.5f);
                if (_e363 > -8388608f) {
                    let _e376 = f32(select(0i, select(select(i32(_e363), i32(-2147483648), (_e363 < bitcast<f32>(3472883712u))), 2147483647i, (_e363 > bitcast<f32>(1325400063u))), (_e363 == _e363)));
                    if (_e376 > _e363) {
                        phi_1005_ = 1f;
                    } else {
                        phi_1005_ = 0f;
                    }
                    let _e379 = phi_1005_;
                    if (_e363 < 8388608f) {
                        phi_1010_ = (_e376 - _e379);
                        phi_1011_ = false;
                    } else {
                        phi_1010_ = f32();
                        phi_1011_ = true;
                    }
                    let _e382 = phi_1010_;
                    let _e384 = phi_1011_;
                    phi_1012_ = _e382;
                    phi_1013_ = _e384;
                } else {
                    phi_1012_ = f32();
                    phi_1013_ = true;
                }
                let _e386 = phi_1012_;
                let _e388 = phi_1013_;
                if _e388 {
                    phi_1017_ = _e363;
                } else {
                    phi_1017_ = _e386;
                }
                let _e390 = phi_1017_;
                if (_e364 > -8388608f) {
                    let _e402 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e402 > _e364) {
                        phi_1037_ = 1f;
                    } else {
                        phi_1037_ = 0f;
                    }
                    let _e405 = phi_1037_;
                    if (_e364 < 8388608f) {
                        phi_1042_ = (_e402 - _e405);
                        phi_1043_ = false;
                    } else {
                        phi_1042_ = f32();
                        phi_1043_ = true;
                    }
                    let _e408 = phi_1042_;
                    let _e410 = phi_1043_;
                    phi_1044_ = _e408;
                    phi_1045_ = _e410;
                } else {
                    phi_1044_ = f32();
                    phi_1045_ = true;
                }
                let _e412 = phi_1044_;
                let _e414 = phi_1045_;
                if _e414 {
                    phi_1049_ = _e364;
                } else {
                    phi_1049_ = _e412;
                }
                let _e416 = phi_1049_;
                let _e417 = (_e363 - _e390);
                let _e418 = (_e364 - _e416);
                let _e427 = select(0i, select(select(i32(_e390), i32(-2147483648), (_e390 < bitcast<f32>(3472883712u))), 2147483647i, (_e390 > bitcast<f32>(1325400063u))), (_e390 == _e390));
                let _e436 = select(0i, select(select(i32(_e416), i32(-2147483648), (_e416 < bitcast<f32>(3472883712u))), 2147483647i, (_e416 > bitcast<f32>(1325400063u))), (_e416 == _e416));
                let _e447 = p.member.test;
                let _e448 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e447);
                let _e450 = p.member.map_size;
                local_1 = _e448;
                let _e452 = (bitcast<i32>(_e450) - 1i);
                if (_e427 > 0i) {
                    phi_1095_ = _e427;
                } else {
                    phi_1095_ = 0i;
                }
                let _e455 = phi_1095_;
                if (_e436 > 0i) {
                    phi_1100_ = _e436;
                } else {
                    phi_1100_ = 0i;
                }
                let _e458 = phi_1100_;
                if (_e455 < _e452) {
                    phi_1105_ = _e455;
                } else {
                    phi_1105_ = _e452;
                }
                let _e461 = phi_1105_;
                if (_e458 < _e452) {
                    phi_1110_ = _e458;
                } else {
                    phi_1110_ = _e452;
                }
                let _e464 = phi_1110_;
                let _e465 = bitcast<u32>(_e461);
                let _e467 = (_e427 + 1i);
                let _e468 = (_e436 + 1i);
                if (_e467 > 0i) {
                    phi_1119_ = _e467;
                } else {
                    phi_1119_ = 0i;
                }
                let _e471 = phi_1119_;
                if (_e468 > 0i) {
                    phi_1124_ = _e468;
                } else {
                    phi_1124_ = 0i;
                }
                let _e474 = phi_1124_;
                if (_e471 < _e452) {
                    phi_1129_ = _e471;
                } else {
                    phi_1129_ = _e452;
                }
                let _e477 = phi_1129_;
                if (_e474 < _e452) {
                    phi_1134_ = _e474;
                } else {
                    phi_1134_ = _e452;
                }
                let _e480 = phi_1134_;
                let _e481 = bitcast<u32>(_e477);
                let _e483 = (bitcast<u32>(_e464) * _e450);
                let _e484 = (bitcast<u32>(_e480) * _e450);
                let _e485 = (_e483 + _e465);
                let _e486 = (_e483 + _e481);
                let _e487 = (_e484 + _e465);
                let _e488 = (_e484 + _e481);
                if (_e485 < _e57) {
                } else {
                    return;
                }
                let _e492 = map.member[(0u + _e485)];
                if (_e486 < _e57) {
                } else {
                    return;
                }
                let _e496 = map.member[(0u + _e486)];
                if (_e487 < _e57) {
                } else {
                    return;
                }
                let _e500 = map.member[(0u + _e487)];
                if (_e488 < _e57) {
                } else {
                    return;
                }
                let _e504 = map.member[(0u + _e488)];
                let _e506 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e492, _e496, _e500, _e504), vec4<f32>(((1f - _e417) * (1f - _e418)), (_e417 * (1f - _e418)), ((1f - _e417) * _e418), (_e417 * _e418)), _e357);
                let _e508 = p.member.epsilon;
                if (_e506 <= _e508) {
                    phi_1181_ = true;
                } else {
                    phi_1181_ = (_e506 >= (1f - _e508));
                }
                let _e513 = phi_1181_;
                if ((bitcast<u32>(_e506) & 2147483647u) > 2139095040u) {
                    phi_1189_ = true;
                } else {
                    phi_1189_ = !(_e513);
                }
                let _e519 = phi_1189_;
                if _e519 {
                    if (_e506 > 0f) {
                        if (_e506 < 1f) {
                            phi_1201_ = false;
                        } else {
                            phi_1201_ = true;
                        }
                        let _e523 = phi_1201_;
                        phi_1202_ = _e523;
                    } else {
                        phi_1202_ = true;
                    }
                    let _e525 = phi_1202_;
                    if _e525 {
                        phi_1206_ = 0.5f;
                    } else {
                        phi_1206_ = _e506;
                    }
                    let _e527 = phi_1206_;
                    phi_1214_ = evaluate_Verdict(_e527, true);
                } else {
                    if (_e506 > 0.5f) {
                        phi_1212_ = 1f;
                    } else {
                        phi_1212_ = 0f;
                    }
                    let _e531 = phi_1212_;
                    phi_1214_ = evaluate_Verdict(_e531, false);
                }
                let _e534 = phi_1214_;
                phi_1219_ = evaluate_Verdict(_e534.visibility, _e534.is_doubted);
            } else {
                phi_1219_ = evaluate_Verdict(0.5f, true);
            }
            let _e540 = phi_1219_;
            phi_1220_ = _e540;
        }
        let _e542 = phi_1220_;
        visibility.member[_e65.first_primitive] = _e542.visibility;
        phi_1224_ = _e542.is_doubted;
        phi_1225_ = _e65.first_primitive;
    } else {
        phi_1224_ = false;
        phi_1225_ = 0u;
    }
    let _e547 = phi_1224_;
    let _e549 = phi_1225_;
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e547 {
        let _e553 = atomicAdd((&shared_[0u]), 1u);
        phi_1236_ = _e553;
    } else {
        phi_1236_ = 0u;
    }
    let _e555 = phi_1236_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e559 = atomicLoad((&shared_[0u]));
        let _e560 = atomicAdd((&list.member[3u]), _e559);
        atomicStore((&shared_[1u]), _e560);
    }
    workgroupBarrier();
    if _e547 {
        let _e563 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e563) + _e555)]), _e549);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
