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
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_36 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
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
    var phi_156_: lt_bvh_traverse_Tree;
    var phi_157_: bool;
    var phi_158_: lt_bvh_traverse_Tree;
    var phi_159_: bool;
    var phi_164_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_156_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_157_ = false;
        } else {
            phi_156_ = lt_bvh_traverse_Tree();
            phi_157_ = true;
        }
        let _e63 = phi_156_;
        let _e65 = phi_157_;
        phi_158_ = _e63;
        phi_159_ = _e65;
    } else {
        phi_158_ = lt_bvh_traverse_Tree();
        phi_159_ = true;
    }
    let _e67 = phi_158_;
    let _e69 = phi_159_;
    if _e69 {
        phi_164_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_164_ = _e67;
    }
    let _e74 = phi_164_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_184_: bool;
    var phi_188_: f32;

    let _e51 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_184_ = true;
    } else {
        let _e55 = (84f < _e51);
        if _e55 {
        }
        phi_184_ = _e55;
    }
    let _e57 = phi_184_;
    if _e57 {
        phi_188_ = 84f;
    } else {
        phi_188_ = _e51;
    }
    let _e59 = phi_188_;
    return _e59;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_209_: f32;
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_227_: f32;
    var phi_228_: f32;
    var phi_229_: f32;
    var phi_245_: f32;
    var phi_246_: f32;
    var phi_247_: f32;
    var phi_263_: f32;
    var phi_264_: f32;
    var phi_265_: f32;
    var phi_281_: f32;
    var phi_282_: f32;
    var phi_283_: f32;
    var phi_302_: f32;
    var phi_307_: f32;
    var phi_329_: f32;
    var phi_334_: f32;
    var phi_335_: bool;
    var phi_336_: f32;
    var phi_337_: bool;
    var phi_341_: f32;
    var phi_379_: f32;
    var phi_390_: f32;
    var phi_395_: f32;
    var phi_417_: f32;
    var phi_422_: f32;
    var phi_423_: bool;
    var phi_424_: f32;
    var phi_425_: bool;
    var phi_429_: f32;
    var phi_467_: f32;
    var phi_478_: f32;
    var phi_483_: f32;
    var phi_505_: f32;
    var phi_510_: f32;
    var phi_511_: bool;
    var phi_512_: f32;
    var phi_513_: bool;
    var phi_517_: f32;
    var phi_555_: f32;
    var phi_566_: f32;
    var phi_571_: f32;
    var phi_593_: f32;
    var phi_598_: f32;
    var phi_599_: bool;
    var phi_600_: f32;
    var phi_601_: bool;
    var phi_605_: f32;
    var phi_643_: f32;
    var phi_669_: f32;
    var phi_670_: f32;
    var phi_671_: f32;

    let _e54 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_211_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_210_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_209_ = 1f;
            } else {
                phi_209_ = param_8;
            }
            let _e61 = phi_209_;
            phi_210_ = _e61;
        }
        let _e63 = phi_210_;
        phi_211_ = _e63;
    }
    let _e65 = phi_211_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_229_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_228_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_227_ = 1f;
            } else {
                phi_227_ = param_6.x;
            }
            let _e73 = phi_227_;
            phi_228_ = _e73;
        }
        let _e75 = phi_228_;
        phi_229_ = _e75;
    }
    let _e77 = phi_229_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_247_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_246_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_245_ = 1f;
            } else {
                phi_245_ = param_6.y;
            }
            let _e85 = phi_245_;
            phi_246_ = _e85;
        }
        let _e87 = phi_246_;
        phi_247_ = _e87;
    }
    let _e89 = phi_247_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_265_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_264_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_263_ = 1f;
            } else {
                phi_263_ = param_6.z;
            }
            let _e97 = phi_263_;
            phi_264_ = _e97;
        }
        let _e99 = phi_264_;
        phi_265_ = _e99;
    }
    let _e101 = phi_265_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_283_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_282_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_281_ = 1f;
            } else {
                phi_281_ = param_6.w;
            }
            let _e109 = phi_281_;
            phi_282_ = _e109;
        }
        let _e111 = phi_282_;
        phi_283_ = _e111;
    }
    let _e113 = phi_283_;
    let _e118 = (_e54 * (_e77 - _e65));
    let _e119 = (_e54 * (_e89 - _e65));
    let _e120 = (_e54 * (_e101 - _e65));
    let _e121 = (_e54 * (_e113 - _e65));
    if ((bitcast<u32>(_e118) & 2147483647u) > 2139095040u) {
        phi_379_ = _e118;
    } else {
        if (_e118 < -87f) {
            phi_302_ = -87f;
        } else {
            phi_302_ = _e118;
        }
        let _e127 = phi_302_;
        if (_e127 > 88f) {
            phi_307_ = 88f;
        } else {
            phi_307_ = _e127;
        }
        let _e130 = phi_307_;
        let _e132 = ((_e130 * 1.442695f) + 0.5f);
        if (_e132 > -8388608f) {
            let _e144 = f32(select(0i, select(select(i32(_e132), i32(-2147483648), (_e132 < bitcast<f32>(3472883712u))), 2147483647i, (_e132 > bitcast<f32>(1325400063u))), (_e132 == _e132)));
            if (_e144 > _e132) {
                phi_329_ = 1f;
            } else {
                phi_329_ = 0f;
            }
            let _e147 = phi_329_;
            if (_e132 < 8388608f) {
                phi_334_ = (_e144 - _e147);
                phi_335_ = false;
            } else {
                phi_334_ = f32();
                phi_335_ = true;
            }
            let _e150 = phi_334_;
            let _e152 = phi_335_;
            phi_336_ = _e150;
            phi_337_ = _e152;
        } else {
            phi_336_ = f32();
            phi_337_ = true;
        }
        let _e154 = phi_336_;
        let _e156 = phi_337_;
        if _e156 {
            phi_341_ = _e132;
        } else {
            phi_341_ = _e154;
        }
        let _e158 = phi_341_;
        let _e162 = ((_e130 - (_e158 * 0.69314575f)) - (_e158 * 0.0000014286068f));
        phi_379_ = ((((((((((((((((1f / 5040f) * _e162) + (1f / 720f)) * _e162) + (1f / 120f)) * _e162) + (1f / 24f)) * _e162) + (1f / 6f)) * _e162) + 0.5f) * _e162) + 1f) * _e162) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e158), i32(-2147483648), (_e158 < bitcast<f32>(3472883712u))), 2147483647i, (_e158 > bitcast<f32>(1325400063u))), (_e158 == _e158)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e198 = phi_379_;
    if ((bitcast<u32>(_e119) & 2147483647u) > 2139095040u) {
        phi_467_ = _e119;
    } else {
        if (_e119 < -87f) {
            phi_390_ = -87f;
        } else {
            phi_390_ = _e119;
        }
        let _e204 = phi_390_;
        if (_e204 > 88f) {
            phi_395_ = 88f;
        } else {
            phi_395_ = _e204;
        }
        let _e207 = phi_395_;
        let _e209 = ((_e207 * 1.442695f) + 0.5f);
        if (_e209 > -8388608f) {
            let _e221 = f32(select(0i, select(select(i32(_e209), i32(-2147483648), (_e209 < bitcast<f32>(3472883712u))), 2147483647i, (_e209 > bitcast<f32>(1325400063u))), (_e209 == _e209)));
            if (_e221 > _e209) {
                phi_417_ = 1f;
            } else {
                phi_417_ = 0f;
            }
            let _e224 = phi_417_;
            if (_e209 < 8388608f) {
                phi_422_ = (_e221 - _e224);
                phi_423_ = false;
            } else {
                phi_422_ = f32();
                phi_423_ = true;
            }
            let _e227 = phi_422_;
            let _e229 = phi_423_;
            phi_424_ = _e227;
            phi_425_ = _e229;
        } else {
            phi_424_ = f32();
            phi_425_ = true;
        }
        let _e231 = phi_424_;
        let _e233 = phi_425_;
        if _e233 {
            phi_429_ = _e209;
        } else {
            phi_429_ = _e231;
        }
        let _e235 = phi_429_;
        let _e239 = ((_e207 - (_e235 * 0.69314575f)) - (_e235 * 0.0000014286068f));
        phi_467_ = ((((((((((((((((1f / 5040f) * _e239) + (1f / 720f)) * _e239) + (1f / 120f)) * _e239) + (1f / 24f)) * _e239) + (1f / 6f)) * _e239) + 0.5f) * _e239) + 1f) * _e239) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e235), i32(-2147483648), (_e235 < bitcast<f32>(3472883712u))), 2147483647i, (_e235 > bitcast<f32>(1325400063u))), (_e235 == _e235)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e275 = phi_467_;
    if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
        phi_555_ = _e120;
    } else {
        if (_e120 < -87f) {
            phi_478_ = -87f;
        } else {
            phi_478_ = _e120;
        }
        let _e281 = phi_478_;
        if (_e281 > 88f) {
            phi_483_ = 88f;
        } else {
            phi_483_ = _e281;
        }
        let _e284 = phi_483_;
        let _e286 = ((_e284 * 1.442695f) + 0.5f);
        if (_e286 > -8388608f) {
            let _e298 = f32(select(0i, select(select(i32(_e286), i32(-2147483648), (_e286 < bitcast<f32>(3472883712u))), 2147483647i, (_e286 > bitcast<f32>(1325400063u))), (_e286 == _e286)));
            if (_e298 > _e286) {
                phi_505_ = 1f;
            } else {
                phi_505_ = 0f;
            }
            let _e301 = phi_505_;
            if (_e286 < 8388608f) {
                phi_510_ = (_e298 - _e301);
                phi_511_ = false;
            } else {
                phi_510_ = f32();
                phi_511_ = true;
            }
            let _e304 = phi_510_;
            let _e306 = phi_511_;
            phi_512_ = _e304;
            phi_513_ = _e306;
        } else {
            phi_512_ = f32();
            phi_513_ = true;
        }
        let _e308 = phi_512_;
        let _e310 = phi_513_;
        if _e310 {
            phi_517_ = _e286;
        } else {
            phi_517_ = _e308;
        }
        let _e312 = phi_517_;
        let _e316 = ((_e284 - (_e312 * 0.69314575f)) - (_e312 * 0.0000014286068f));
        phi_555_ = ((((((((((((((((1f / 5040f) * _e316) + (1f / 720f)) * _e316) + (1f / 120f)) * _e316) + (1f / 24f)) * _e316) + (1f / 6f)) * _e316) + 0.5f) * _e316) + 1f) * _e316) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e312), i32(-2147483648), (_e312 < bitcast<f32>(3472883712u))), 2147483647i, (_e312 > bitcast<f32>(1325400063u))), (_e312 == _e312)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e352 = phi_555_;
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_643_ = _e121;
    } else {
        if (_e121 < -87f) {
            phi_566_ = -87f;
        } else {
            phi_566_ = _e121;
        }
        let _e358 = phi_566_;
        if (_e358 > 88f) {
            phi_571_ = 88f;
        } else {
            phi_571_ = _e358;
        }
        let _e361 = phi_571_;
        let _e363 = ((_e361 * 1.442695f) + 0.5f);
        if (_e363 > -8388608f) {
            let _e375 = f32(select(0i, select(select(i32(_e363), i32(-2147483648), (_e363 < bitcast<f32>(3472883712u))), 2147483647i, (_e363 > bitcast<f32>(1325400063u))), (_e363 == _e363)));
            if (_e375 > _e363) {
                phi_593_ = 1f;
            } else {
                phi_593_ = 0f;
            }
            let _e378 = phi_593_;
            if (_e363 < 8388608f) {
                phi_598_ = (_e375 - _e378);
                phi_599_ = false;
            } else {
                phi_598_ = f32();
                phi_599_ = true;
            }
            let _e381 = phi_598_;
            let _e383 = phi_599_;
            phi_600_ = _e381;
            phi_601_ = _e383;
        } else {
            phi_600_ = f32();
            phi_601_ = true;
        }
        let _e385 = phi_600_;
        let _e387 = phi_601_;
        if _e387 {
            phi_605_ = _e363;
        } else {
            phi_605_ = _e385;
        }
        let _e389 = phi_605_;
        let _e393 = ((_e361 - (_e389 * 0.69314575f)) - (_e389 * 0.0000014286068f));
        phi_643_ = ((((((((((((((((1f / 5040f) * _e393) + (1f / 720f)) * _e393) + (1f / 120f)) * _e393) + (1f / 24f)) * _e393) + (1f / 6f)) * _e393) + 0.5f) * _e393) + 1f) * _e393) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e389), i32(-2147483648), (_e389 < bitcast<f32>(3472883712u))), 2147483647i, (_e389 > bitcast<f32>(1325400063u))), (_e389 == _e389)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e429 = phi_643_;
    let _e440 = ((((_e198 * param_7.x) + (_e275 * param_7.y)) + (_e352 * param_7.z)) + (_e429 * param_7.w));
    if ((bitcast<u32>(_e440) & 2147483647u) > 2139095040u) {
        phi_671_ = _e440;
    } else {
        if (_e440 < 0f) {
            phi_670_ = 0f;
        } else {
            if (_e440 > 1f) {
                phi_669_ = 1f;
            } else {
                phi_669_ = _e440;
            }
            let _e447 = phi_669_;
            phi_670_ = _e447;
        }
        let _e449 = phi_670_;
        phi_671_ = _e449;
    }
    let _e451 = phi_671_;
    return _e451;
}

fn function_() {
    var local_1: f32;
    var phi_723_: bool;
    var phi_724_: bool;
    var phi_725_: bool;
    var phi_726_: bool;
    var phi_730_: bool;
    var phi_774_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_778_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_852_: bool;
    var phi_861_: bool;
    var phi_870_: bool;
    var phi_871_: bool;
    var phi_872_: bool;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_876_: bool;
    var phi_880_: bool;
    var phi_970_: f32;
    var phi_973_: f32;
    var phi_1002_: f32;
    var phi_1007_: f32;
    var phi_1008_: bool;
    var phi_1009_: f32;
    var phi_1010_: bool;
    var phi_1014_: f32;
    var phi_1034_: f32;
    var phi_1039_: f32;
    var phi_1040_: bool;
    var phi_1041_: f32;
    var phi_1042_: bool;
    var phi_1046_: f32;
    var phi_1094_: i32;
    var phi_1099_: i32;
    var phi_1104_: i32;
    var phi_1109_: i32;
    var phi_1118_: i32;
    var phi_1123_: i32;
    var phi_1128_: i32;
    var phi_1133_: i32;
    var phi_1184_: bool;
    var phi_1192_: bool;
    var phi_1204_: bool;
    var phi_1205_: bool;
    var phi_1209_: f32;
    var phi_1215_: f32;
    var phi_1217_: evaluate_Verdict;
    var phi_1222_: evaluate_Verdict;
    var phi_1223_: evaluate_Verdict;
    var phi_1227_: bool;
    var phi_1228_: u32;
    var phi_1239_: u32;

    let _e51 = id_1;
    let _e52 = local_2;
    let _e57 = arrayLength((&map.member));
    let _e62 = p.member.size[0u];
    let _e64 = p.member.size[1u];
    let _e65 = lt_shaders_entry_pixel_index(_e51, _e62, _e64);
    if (bitcast<i32>(_e65.root) != 0i) {
        let _e72 = p.member.projection;
        let _e73 = lt_math_OneLevel(_e72);
        let _e75 = p.member.light;
        let _e78 = samples.member[_e65.first_primitive].normal[0u];
        let _e80 = global[0u];
        if (_e78 == _e80) {
            let _e83 = samples.member[_e65.first_primitive].normal[1u];
            let _e85 = global[1u];
            if (_e83 == _e85) {
                let _e88 = samples.member[_e65.first_primitive].normal[2u];
                let _e90 = global[2u];
                phi_723_ = (_e88 == _e90);
                phi_724_ = false;
            } else {
                phi_723_ = bool();
                phi_724_ = true;
            }
            let _e93 = phi_723_;
            let _e95 = phi_724_;
            phi_725_ = _e93;
            phi_726_ = _e95;
        } else {
            phi_725_ = bool();
            phi_726_ = true;
        }
        let _e97 = phi_725_;
        let _e99 = phi_726_;
        if _e99 {
            phi_730_ = false;
        } else {
            phi_730_ = _e97;
        }
        let _e101 = phi_730_;
        if !(_e101) {
            let _e104 = samples.member[_e65.first_primitive].normal;
            let _e106 = samples.member[_e65.first_primitive].position;
            if ((((_e104.x * (_e75.x - (_e106.x * _e75.w))) + (_e104.y * (_e75.y - (_e106.y * _e75.w)))) + (_e104.z * (_e75.z - (_e106.z * _e75.w)))) > 0f) {
                let _e130 = samples.member[_e65.first_primitive].flags;
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_774_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, ((_e130 & 1u) == 0u));
            } else {
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e153.unnamed.visibility, false), _e153.unnamed_1);
                phi_774_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e159.unnamed, true);
            }
            let _e164 = phi_774_;
            phi_778_ = _e164;
        } else {
            let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
            phi_778_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, true);
        }
        let _e181 = phi_778_;
        if _e181.unnamed_1 {
            phi_1223_ = evaluate_Verdict(_e181.unnamed.visibility, _e181.unnamed.is_doubted);
        } else {
            let _e189 = samples.member[_e65.first_primitive].position;
            let _e207 = ((((_e73.projection.row_w.x * _e189.x) + (_e73.projection.row_w.y * _e189.y)) + (_e73.projection.row_w.z * _e189.z)) + (_e73.projection.row_w.w * 1f));
            let _e221 = (((((_e73.projection.row_x.x * _e189.x) + (_e73.projection.row_x.y * _e189.y)) + (_e73.projection.row_x.z * _e189.z)) + (_e73.projection.row_x.w * 1f)) / _e207);
            let _e235 = (((((_e73.projection.row_y.x * _e189.x) + (_e73.projection.row_y.y * _e189.y)) + (_e73.projection.row_y.z * _e189.z)) + (_e73.projection.row_y.w * 1f)) / _e207);
            let _e248 = ((((_e73.projection.row_z.x * _e189.x) + (_e73.projection.row_z.y * _e189.y)) + (_e73.projection.row_z.z * _e189.z)) + (_e73.projection.row_z.w * 1f));
            if (_e207 > 0f) {
                if (_e221 >= 0f) {
                    phi_852_ = (_e221 <= 1f);
                } else {
                    phi_852_ = false;
                }
                let _e253 = phi_852_;
                if _e253 {
                    if (_e235 >= 0f) {
                        phi_861_ = (_e235 <= 1f);
                    } else {
                        phi_861_ = false;
                    }
                    let _e257 = phi_861_;
                    if _e257 {
                        if (_e248 >= 0f) {
                            phi_870_ = (_e248 <= 1f);
                        } else {
                            phi_870_ = false;
                        }
                        let _e261 = phi_870_;
                        phi_871_ = _e261;
                        phi_872_ = false;
                    } else {
                        phi_871_ = bool();
                        phi_872_ = true;
                    }
                    let _e263 = phi_871_;
                    let _e265 = phi_872_;
                    phi_873_ = _e263;
                    phi_874_ = _e265;
                } else {
                    phi_873_ = bool();
                    phi_874_ = true;
                }
                let _e267 = phi_873_;
                let _e269 = phi_874_;
                phi_875_ = _e267;
                phi_876_ = _e269;
            } else {
                phi_875_ = bool();
                phi_876_ = true;
            }
            let _e271 = phi_875_;
            let _e273 = phi_876_;
            if _e273 {
                phi_880_ = false;
            } else {
                phi_880_ = _e271;
            }
            let _e275 = phi_880_;
            if _e275 {
                if (0f > 0f) {
                    let _e278 = samples.member[_e65.first_primitive].normal;
                    let _e280 = p.member.map_size;
                    let _e350 = ((abs(((((_e72.row_x.x * _e278.x) + (_e72.row_x.y * _e278.y)) + (_e72.row_x.z * _e278.z)) / (((_e72.row_x.x * _e72.row_x.x) + (_e72.row_x.y * _e72.row_x.y)) + (_e72.row_x.z * _e72.row_x.z)))) + abs(((((_e72.row_y.x * _e278.x) + (_e72.row_y.y * _e278.y)) + (_e72.row_y.z * _e278.z)) / (((_e72.row_y.x * _e72.row_y.x) + (_e72.row_y.y * _e72.row_y.y)) + (_e72.row_y.z * _e72.row_y.z))))) / (abs(((((_e72.row_z.x * _e278.x) + (_e72.row_z.y * _e278.y)) + (_e72.row_z.z * _e278.z)) / (((_e72.row_z.x * _e72.row_z.x) + (_e72.row_z.y * _e72.row_z.y)) + (_e72.row_z.z * _e72.row_z.z)))) * f32(_e280)));
                    if (_e350 < 0.002f) {
                        phi_970_ = _e350;
                    } else {
                        phi_970_ = 0.002f;
                    }
                    let _e353 = phi_970_;
                    phi_973_ = (_e248 - (0f * _e353));
                } else {
                    phi_973_ = _e248;
                }
                let _e357 = phi_973_;
                let _e359 = p.member.map_size;
                let _e360 = f32(_e359);
                let _e363 = ((_e221 * _e360) - 0.5f);
                let _e364 = ((_e235 * _e360) - 0.5f);
                if (_e363 > -8388608f) {
                    let _e376 = f32(select(0i, select(select(i32(_e363), i32(-2147483648), (_e363 < bitcast<f32>(3472883712u))), 2147483647i, (_e363 > bitcast<f32>(1325400063u))), (_e363 == _e363)));
                    if (_e376 > _e363) {
                        phi_1002_ = 1f;
                    } else {
                        phi_1002_ = 0f;
                    }
                    let _e379 = phi_1002_;
                    if (_e363 < 8388608f) {
                        phi_1007_ = (_e376 - _e379);
                        phi_1008_ = false;
                    } else {
                        phi_1007_ = f32();
                        phi_1008_ = true;
                    }
                    let _e382 = phi_1007_;
                    let _e384 = phi_1008_;
                    phi_1009_ = _e382;
                    phi_1010_ = _e384;
                } else {
                    phi_1009_ = f32();
                    phi_1010_ = true;
                }
                let _e386 = phi_1009_;
                let _e388 = phi_1010_;
                if _e388 {
                    phi_1014_ = _e363;
                } else {
                    phi_1014_ = _e386;
                }
                let _e390 = phi_1014_;
                if (_e364 > -8388608f) {
                    let _e402 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e402 > _e364) {
                        phi_1034_ = 1f;
                    } else {
                        phi_1034_ = 0f;
                    }
                    let _e405 = phi_1034_;
                    if (_e364 < 8388608f) {
                        phi_1039_ = (_e402 - _e405);
                        phi_1040_ = false;
                    } else {
                        phi_1039_ = f32();
                        phi_1040_ = true;
                    }
                    let _e408 = phi_1039_;
                    let _e410 = phi_1040_;
                    phi_1041_ = _e408;
                    phi_1042_ = _e410;
                } else {
                    phi_1041_ = f32();
                    phi_1042_ = true;
                }
                let _e412 = phi_1041_;
                let _e414 = phi_1042_;
                if _e414 {
                    phi_1046_ = _e364;
                } else {
                    phi_1046_ = _e412;
                }
                let _e416 = phi_1046_;
                let _e417 = (_e363 - _e390);
                let _e418 = (_e364 - _e416);
                let _e427 = select(0i, select(select(i32(_e390), i32(-2147483648), (_e390 < bitcast<f32>(3472883712u))), 2147483647i, (_e390 > bitcast<f32>(1325400063u))), (_e390 == _e390));
                let _e436 = select(0i, select(select(i32(_e416), i32(-2147483648), (_e416 < bitcast<f32>(3472883712u))), 2147483647i, (_e416 > bitcast<f32>(1325400063u))), (_e416 == _e416));
                let _e447 = p.member.test;
                let _e448 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e447);
                let _e450 = p.member.map_size;
                local_1 = _e448;
                let _e452 = ((0u * _e450) * _e450);
                let _e454 = (bitcast<i32>(_e450) - 1i);
                if (_e427 > 0i) {
                    phi_1094_ = _e427;
                } else {
                    phi_1094_ = 0i;
                }
                let _e457 = phi_1094_;
                if (_e436 > 0i) {
                    phi_1099_ = _e436;
                } else {
                    phi_1099_ = 0i;
                }
                let _e460 = phi_1099_;
                if (_e457 < _e454) {
                    phi_1104_ = _e457;
                } else {
                    phi_1104_ = _e454;
                }
                let _e463 = phi_1104_;
                if (_e460 < _e454) {
                    phi_1109_ = _e460;
                } else {
                    phi_1109_ = _e454;
                }
                let _e466 = phi_1109_;
                let _e467 = bitcast<u32>(_e463);
                let _e469 = (_e427 + 1i);
                let _e470 = (_e436 + 1i);
                if (_e469 > 0i) {
                    phi_1118_ = _e469;
                } else {
                    phi_1118_ = 0i;
                }
                let _e473 = phi_1118_;
                if (_e470 > 0i) {
                    phi_1123_ = _e470;
                } else {
                    phi_1123_ = 0i;
                }
                let _e476 = phi_1123_;
                if (_e473 < _e454) {
                    phi_1128_ = _e473;
                } else {
                    phi_1128_ = _e454;
                }
                let _e479 = phi_1128_;
                if (_e476 < _e454) {
                    phi_1133_ = _e476;
                } else {
                    phi_1133_ = _e454;
                }
                let _e482 = phi_1133_;
                let _e483 = bitcast<u32>(_e479);
                let _e485 = (bitcast<u32>(_e466) * _e450);
                let _e486 = (bitcast<u32>(_e482) * _e450);
                let _e491 = ((_e485 + _e467) + _e452);
                let _e492 = ((_e485 + _e483) + _e452);
                let _e493 = ((_e486 + _e467) + _e452);
                let _e494 = ((_e486 + _e483) + _e452);
                if (_e491 < _e57) {
                } else {
                    return;
                }
                let _e498 = map.member[(0u + _e491)];
                if (_e492 < _e57) {
                } else {
                    return;
                }
                let _e502 = map.member[(0u + _e492)];
                if (_e493 < _e57) {
                } else {
                    return;
                }
                let _e506 = map.member[(0u + _e493)];
                if (_e494 < _e57) {
                } else {
                    return;
                }
                let _e510 = map.member[(0u + _e494)];
                let _e512 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e498, _e502, _e506, _e510), vec4<f32>(((1f - _e417) * (1f - _e418)), (_e417 * (1f - _e418)), ((1f - _e417) * _e418), (_e417 * _e418)), _e357);
                let _e514 = p.member.epsilon;
                if (_e512 <= _e514) {
                    phi_1184_ = true;
                } else {
                    phi_1184_ = (_e512 >= (1f - _e514));
                }
                let _e519 = phi_1184_;
                if ((bitcast<u32>(_e512) & 2147483647u) > 2139095040u) {
                    phi_1192_ = true;
                } else {
                    phi_1192_ = !(_e519);
                }
                let _e525 = phi_1192_;
                if _e525 {
                    if (_e512 > 0f) {
                        if (_e512 < 1f) {
                            phi_1204_ = false;
                        } else {
                            phi_1204_ = true;
                        }
                        let _e529 = phi_1204_;
                        phi_1205_ = _e529;
                    } else {
                        phi_1205_ = true;
                    }
                    let _e531 = phi_1205_;
                    if _e531 {
                        phi_1209_ = 0.5f;
                    } else {
                        phi_1209_ = _e512;
                    }
                    let _e533 = phi_1209_;
                    phi_1217_ = evaluate_Verdict(_e533, true);
                } else {
                    if (_e512 > 0.5f) {
                        phi_1215_ = 1f;
                    } else {
                        phi_1215_ = 0f;
                    }
                    let _e537 = phi_1215_;
                    phi_1217_ = evaluate_Verdict(_e537, false);
                }
                let _e540 = phi_1217_;
                phi_1222_ = evaluate_Verdict(_e540.visibility, _e540.is_doubted);
            } else {
                phi_1222_ = evaluate_Verdict(0.5f, true);
            }
            let _e546 = phi_1222_;
            phi_1223_ = _e546;
        }
        let _e548 = phi_1223_;
        visibility.member[_e65.first_primitive] = _e548.visibility;
        phi_1227_ = _e548.is_doubted;
        phi_1228_ = _e65.first_primitive;
    } else {
        phi_1227_ = false;
        phi_1228_ = 0u;
    }
    let _e553 = phi_1227_;
    let _e555 = phi_1228_;
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e553 {
        let _e559 = atomicAdd((&shared_[0u]), 1u);
        phi_1239_ = _e559;
    } else {
        phi_1239_ = 0u;
    }
    let _e561 = phi_1239_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e565 = atomicLoad((&shared_[0u]));
        let _e566 = atomicAdd((&list.member[3u]), _e565);
        atomicStore((&shared_[1u]), _e566);
    }
    workgroupBarrier();
    if _e553 {
        let _e569 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e569) + _e561)]), _e555);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
