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

struct type_29 {
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

struct type_33 {
    member: abi_ShadowParams,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_40 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_33;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_40;
@group(0) @binding(2) 
var<storage> map: type_29;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_163_: lt_bvh_traverse_Tree;
    var phi_164_: bool;
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_171_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_163_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_164_ = false;
        } else {
            phi_163_ = lt_bvh_traverse_Tree();
            phi_164_ = true;
        }
        let _e66 = phi_163_;
        let _e68 = phi_164_;
        phi_165_ = _e66;
        phi_166_ = _e68;
    } else {
        phi_165_ = lt_bvh_traverse_Tree();
        phi_166_ = true;
    }
    let _e70 = phi_165_;
    let _e72 = phi_166_;
    if _e72 {
        phi_171_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_171_ = _e70;
    }
    let _e77 = phi_171_;
    return lt_bvh_traverse_Tree(_e77.root, _e77.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_198_: f32;
    var phi_199_: f32;
    var phi_200_: f32;
    var phi_213_: bool;
    var phi_217_: f32;
    var phi_229_: f32;
    var phi_234_: f32;
    var phi_256_: f32;
    var phi_261_: f32;
    var phi_262_: bool;
    var phi_263_: f32;
    var phi_264_: bool;
    var phi_268_: f32;
    var phi_306_: f32;
    var phi_319_: bool;
    var phi_323_: f32;
    var phi_336_: f32;
    var phi_341_: f32;
    var phi_363_: f32;
    var phi_368_: f32;
    var phi_369_: bool;
    var phi_370_: f32;
    var phi_371_: bool;
    var phi_375_: f32;
    var phi_413_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_200_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_199_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_198_ = 1f;
            } else {
                phi_198_ = param_5;
            }
            let _e61 = phi_198_;
            phi_199_ = _e61;
        }
        let _e63 = phi_199_;
        phi_200_ = _e63;
    }
    let _e65 = phi_200_;
    let _e67 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_213_ = true;
    } else {
        let _e71 = (42f < _e67);
        if _e71 {
        }
        phi_213_ = _e71;
    }
    let _e73 = phi_213_;
    if _e73 {
        phi_217_ = 42f;
    } else {
        phi_217_ = _e67;
    }
    let _e75 = phi_217_;
    let _e76 = (_e75 * _e65);
    if ((bitcast<u32>(_e76) & 2147483647u) > 2139095040u) {
        phi_306_ = _e76;
    } else {
        if (_e76 < -87f) {
            phi_229_ = -87f;
        } else {
            phi_229_ = _e76;
        }
        let _e82 = phi_229_;
        if (_e82 > 88f) {
            phi_234_ = 88f;
        } else {
            phi_234_ = _e82;
        }
        let _e85 = phi_234_;
        let _e87 = ((_e85 * 1.442695f) + 0.5f);
        if (_e87 > -8388608f) {
            let _e99 = f32(select(0i, select(select(i32(_e87), i32(-2147483648), (_e87 < bitcast<f32>(3472883712u))), 2147483647i, (_e87 > bitcast<f32>(1325400063u))), (_e87 == _e87)));
            if (_e99 > _e87) {
                phi_256_ = 1f;
            } else {
                phi_256_ = 0f;
            }
            let _e102 = phi_256_;
            if (_e87 < 8388608f) {
                phi_261_ = (_e99 - _e102);
                phi_262_ = false;
            } else {
                phi_261_ = f32();
                phi_262_ = true;
            }
            let _e105 = phi_261_;
            let _e107 = phi_262_;
            phi_263_ = _e105;
            phi_264_ = _e107;
        } else {
            phi_263_ = f32();
            phi_264_ = true;
        }
        let _e109 = phi_263_;
        let _e111 = phi_264_;
        if _e111 {
            phi_268_ = _e87;
        } else {
            phi_268_ = _e109;
        }
        let _e113 = phi_268_;
        let _e117 = ((_e85 - (_e113 * 0.69314575f)) - (_e113 * 0.0000014286068f));
        phi_306_ = ((((((((((((((((1f / 5040f) * _e117) + (1f / 720f)) * _e117) + (1f / 120f)) * _e117) + (1f / 24f)) * _e117) + (1f / 6f)) * _e117) + 0.5f) * _e117) + 1f) * _e117) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e113), i32(-2147483648), (_e113 < bitcast<f32>(3472883712u))), 2147483647i, (_e113 > bitcast<f32>(1325400063u))), (_e113 == _e113)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e153 = phi_306_;
    let _e155 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_319_ = true;
    } else {
        let _e159 = (42f < _e155);
        if _e159 {
        }
        phi_319_ = _e159;
    }
    let _e161 = phi_319_;
    if _e161 {
        phi_323_ = 42f;
    } else {
        phi_323_ = _e155;
    }
    let _e163 = phi_323_;
    let _e165 = (-(_e163) * _e65);
    if ((bitcast<u32>(_e165) & 2147483647u) > 2139095040u) {
        phi_413_ = _e165;
    } else {
        if (_e165 < -87f) {
            phi_336_ = -87f;
        } else {
            phi_336_ = _e165;
        }
        let _e171 = phi_336_;
        if (_e171 > 88f) {
            phi_341_ = 88f;
        } else {
            phi_341_ = _e171;
        }
        let _e174 = phi_341_;
        let _e176 = ((_e174 * 1.442695f) + 0.5f);
        if (_e176 > -8388608f) {
            let _e188 = f32(select(0i, select(select(i32(_e176), i32(-2147483648), (_e176 < bitcast<f32>(3472883712u))), 2147483647i, (_e176 > bitcast<f32>(1325400063u))), (_e176 == _e176)));
            if (_e188 > _e176) {
                phi_363_ = 1f;
            } else {
                phi_363_ = 0f;
            }
            let _e191 = phi_363_;
            if (_e176 < 8388608f) {
                phi_368_ = (_e188 - _e191);
                phi_369_ = false;
            } else {
                phi_368_ = f32();
                phi_369_ = true;
            }
            let _e194 = phi_368_;
            let _e196 = phi_369_;
            phi_370_ = _e194;
            phi_371_ = _e196;
        } else {
            phi_370_ = f32();
            phi_371_ = true;
        }
        let _e198 = phi_370_;
        let _e200 = phi_371_;
        if _e200 {
            phi_375_ = _e176;
        } else {
            phi_375_ = _e198;
        }
        let _e202 = phi_375_;
        let _e206 = ((_e174 - (_e202 * 0.69314575f)) - (_e202 * 0.0000014286068f));
        phi_413_ = ((((((((((((((((1f / 5040f) * _e206) + (1f / 720f)) * _e206) + (1f / 120f)) * _e206) + (1f / 24f)) * _e206) + (1f / 6f)) * _e206) + 0.5f) * _e206) + 1f) * _e206) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e202), i32(-2147483648), (_e202 < bitcast<f32>(3472883712u))), 2147483647i, (_e202 > bitcast<f32>(1325400063u))), (_e202 == _e202)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e242 = phi_413_;
    let _e243 = -(_e242);
    return vec4<f32>(_e153, (_e153 * _e153), _e243, (_e243 * _e243));
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_6: f32, param_7: f32) -> f32 {
    var phi_425_: f32;

    if (param_6 < param_7) {
        phi_425_ = param_6;
    } else {
        phi_425_ = param_7;
    }
    let _e57 = phi_425_;
    return _e57;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_8: ptr<function, lt_math_Evsm>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_443_: bool;
    var phi_447_: f32;
    var phi_471_: bool;
    var phi_475_: f32;
    var phi_487_: bool;
    var phi_494_: f32;
    var phi_507_: bool;
    var phi_511_: f32;
    var phi_535_: bool;
    var phi_539_: f32;
    var phi_551_: bool;
    var phi_558_: f32;
    var phi_569_: bool;
    var phi_573_: f32;
    var phi_588_: f32;
    var phi_589_: f32;
    var phi_590_: f32;

    let _e56 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_8, param_10);
    let _e58 = (*param_8).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_443_ = true;
    } else {
        let _e62 = (42f < _e58);
        if _e62 {
        }
        phi_443_ = _e62;
    }
    let _e64 = phi_443_;
    if _e64 {
        phi_447_ = 42f;
    } else {
        phi_447_ = _e58;
    }
    let _e66 = phi_447_;
    let _e68 = (*param_8).min_variance;
    let _e72 = (((_e68 * _e66) * _e66) * _e56.y);
    let _e79 = ((param_9.y - (param_9.x * param_9.x)) + (0.00000047683716f * param_9.y));
    if ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u) {
        phi_471_ = true;
    } else {
        let _e83 = (_e72 > _e79);
        if _e83 {
        }
        phi_471_ = _e83;
    }
    let _e85 = phi_471_;
    if _e85 {
        phi_475_ = _e72;
    } else {
        phi_475_ = _e79;
    }
    let _e87 = phi_475_;
    let _e88 = (_e56.x - param_9.x);
    if (_e88 <= 0f) {
        let _e92 = ((bitcast<u32>(_e87) & 2147483647u) > 2139095040u);
        if _e92 {
        }
        phi_487_ = _e92;
    } else {
        phi_487_ = true;
    }
    let _e94 = phi_487_;
    if _e94 {
        phi_494_ = (_e87 / (_e87 + (_e88 * _e88)));
    } else {
        phi_494_ = 1f;
    }
    let _e99 = phi_494_;
    let _e101 = (*param_8).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_507_ = true;
    } else {
        let _e105 = (42f < _e101);
        if _e105 {
        }
        phi_507_ = _e105;
    }
    let _e107 = phi_507_;
    if _e107 {
        phi_511_ = 42f;
    } else {
        phi_511_ = _e101;
    }
    let _e109 = phi_511_;
    let _e111 = (*param_8).min_variance;
    let _e115 = (((_e111 * _e109) * _e109) * _e56.w);
    let _e122 = ((param_9.w - (param_9.z * param_9.z)) + (0.00000047683716f * param_9.w));
    if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
        phi_535_ = true;
    } else {
        let _e126 = (_e115 > _e122);
        if _e126 {
        }
        phi_535_ = _e126;
    }
    let _e128 = phi_535_;
    if _e128 {
        phi_539_ = _e115;
    } else {
        phi_539_ = _e122;
    }
    let _e130 = phi_539_;
    let _e131 = (_e56.z - param_9.z);
    if (_e131 <= 0f) {
        let _e135 = ((bitcast<u32>(_e130) & 2147483647u) > 2139095040u);
        if _e135 {
        }
        phi_551_ = _e135;
    } else {
        phi_551_ = true;
    }
    let _e137 = phi_551_;
    if _e137 {
        phi_558_ = (_e130 / (_e130 + (_e131 * _e131)));
    } else {
        phi_558_ = 1f;
    }
    let _e142 = phi_558_;
    if ((bitcast<u32>(_e142) & 2147483647u) > 2139095040u) {
        phi_569_ = true;
    } else {
        let _e146 = (_e142 < _e99);
        if _e146 {
        }
        phi_569_ = _e146;
    }
    let _e148 = phi_569_;
    if _e148 {
        phi_573_ = _e142;
    } else {
        phi_573_ = _e99;
    }
    let _e150 = phi_573_;
    if ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u) {
        phi_590_ = _e150;
    } else {
        if (_e150 < 0f) {
            phi_589_ = 0f;
        } else {
            if (_e150 > 1f) {
                phi_588_ = 1f;
            } else {
                phi_588_ = _e150;
            }
            let _e157 = phi_588_;
            phi_589_ = _e157;
        }
        let _e159 = phi_589_;
        phi_590_ = _e159;
    }
    let _e161 = phi_590_;
    return _e161;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_658_: bool;
    var phi_702_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_706_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_726_: lt_math_LightPoint;
    var phi_729_: u32;
    var phi_731_: lt_math_LevelPoint;
    var phi_817_: bool;
    var phi_826_: bool;
    var phi_835_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_845_: bool;
    var phi_872_: bool;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_878_: bool;
    var phi_879_: bool;
    var phi_883_: bool;
    var phi_892_: lt_math_LightPoint;
    var phi_893_: u32;
    var phi_894_: lt_math_LevelPoint;
    var phi_895_: bool;
    var phi_727_: lt_math_LightPoint;
    var phi_730_: u32;
    var phi_732_: lt_math_LevelPoint;
    var phi_896_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_936_: bool;
    var phi_937_: bool;
    var phi_938_: bool;
    var phi_939_: bool;
    var phi_943_: bool;
    var phi_1025_: f32;
    var phi_1141_: f32;
    var phi_1142_: f32;
    var phi_1145_: f32;
    var phi_1174_: f32;
    var phi_1179_: f32;
    var phi_1180_: bool;
    var phi_1181_: f32;
    var phi_1182_: bool;
    var phi_1186_: f32;
    var phi_1206_: f32;
    var phi_1211_: f32;
    var phi_1212_: bool;
    var phi_1213_: f32;
    var phi_1214_: bool;
    var phi_1218_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1271_: i32;
    var phi_1276_: i32;
    var phi_1281_: i32;
    var phi_1286_: i32;
    var phi_1295_: i32;
    var phi_1300_: i32;
    var phi_1305_: i32;
    var phi_1310_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1426_: f32;
    var phi_1428_: evaluate_Verdict;
    var phi_1429_: bool;
    var phi_1430_: evaluate_Verdict;
    var phi_1431_: bool;
    var phi_1436_: evaluate_Verdict;
    var phi_1437_: bool;
    var phi_1439_: evaluate_Verdict;
    var phi_1440_: evaluate_Verdict;
    var phi_1441_: bool;
    var phi_1445_: evaluate_Verdict;
    var phi_1446_: evaluate_Verdict;
    var phi_1447_: bool;
    var phi_1451_: evaluate_Verdict;

    let _e54 = id_1;
    let _e61 = arrayLength((&map.member));
    let _e67 = arrayLength((&levels.member));
    let _e70 = p.member.size[0u];
    let _e72 = p.member.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e54, _e70, _e72);
    if (bitcast<i32>(_e73.root) != 0i) {
        let _e79 = p.member.level_count;
        if (_e73.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e84 = p.member.light;
        let _e87 = samples.member[(0u + _e73.first_primitive)].normal[0u];
        let _e89 = global[0u];
        if (_e87 == _e89) {
            let _e92 = samples.member[(0u + _e73.first_primitive)].normal[1u];
            let _e94 = global[1u];
            if (_e92 == _e94) {
                let _e97 = samples.member[(0u + _e73.first_primitive)].normal[2u];
                let _e99 = global[2u];
                phi_651_ = (_e97 == _e99);
                phi_652_ = false;
            } else {
                phi_651_ = bool();
                phi_652_ = true;
            }
            let _e102 = phi_651_;
            let _e104 = phi_652_;
            phi_653_ = _e102;
            phi_654_ = _e104;
        } else {
            phi_653_ = bool();
            phi_654_ = true;
        }
        let _e106 = phi_653_;
        let _e108 = phi_654_;
        if _e108 {
            phi_658_ = false;
        } else {
            phi_658_ = _e106;
        }
        let _e110 = phi_658_;
        if !(_e110) {
            let _e113 = samples.member[(0u + _e73.first_primitive)].normal;
            let _e115 = samples.member[(0u + _e73.first_primitive)].position;
            if ((((_e113.x * (_e84.x - (_e115.x * _e84.w))) + (_e113.y * (_e84.y - (_e115.y * _e84.w)))) + (_e113.z * (_e84.z - (_e115.z * _e84.w)))) > 0f) {
                let _e139 = samples.member[(0u + _e73.first_primitive)].flags;
                let _e147 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e147.unnamed.visibility, false), _e147.unnamed_1);
                phi_702_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e153.unnamed, ((_e139 & 1u) == 0u));
            } else {
                let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e162.unnamed.visibility, false), _e162.unnamed_1);
                phi_702_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e168.unnamed, true);
            }
            let _e173 = phi_702_;
            phi_706_ = _e173;
        } else {
            let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e185 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e179.unnamed.visibility, false), _e179.unnamed_1);
            phi_706_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e185.unnamed, true);
        }
        let _e190 = phi_706_;
        if _e190.unnamed_1 {
            phi_1445_ = evaluate_Verdict(_e190.unnamed.visibility, _e190.unnamed.is_doubted);
            phi_1446_ = evaluate_Verdict();
            phi_1447_ = true;
        } else {
            let _e198 = samples.member[(0u + _e73.first_primitive)].position;
            let _e200 = p.member.map_size;
            let _e202 = (0.5f / f32(_e200));
            let _e209 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e216 = lt_math_LightPoint(vec2<f32>(_e209.uv.x, 0f), _e209.depth, _e209.is_inside);
            let _e220 = lt_math_LightPoint(_e216.uv, 0f, _e216.is_inside);
            phi_726_ = lt_math_LightPoint();
            phi_729_ = 0u;
            phi_731_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e220.uv, _e220.depth, false));
            loop {
                let _e227 = phi_726_;
                let _e229 = phi_729_;
                let _e231 = phi_731_;
                local_1 = _e231;
                local_2 = _e231;
                local_3 = _e231;
                local_4 = _e231;
                if (_e229 < _e79) {
                    if _e231.point.is_inside {
                        phi_892_ = lt_math_LightPoint();
                        phi_893_ = u32();
                        phi_894_ = lt_math_LevelPoint();
                        phi_895_ = false;
                    } else {
                        if (_e229 < _e67) {
                        } else {
                            return;
                        }
                        let _e242 = levels.member[(0u + _e229)].row_w;
                        let _e253 = ((((_e242.x * _e198.x) + (_e242.y * _e198.y)) + (_e242.z * _e198.z)) + (_e242.w * 1f));
                        let _e255 = levels.member[(0u + _e229)].row_x;
                        let _e267 = (((((_e255.x * _e198.x) + (_e255.y * _e198.y)) + (_e255.z * _e198.z)) + (_e255.w * 1f)) / _e253);
                        let _e269 = levels.member[(0u + _e229)].row_y;
                        let _e281 = (((((_e269.x * _e198.x) + (_e269.y * _e198.y)) + (_e269.z * _e198.z)) + (_e269.w * 1f)) / _e253);
                        let _e283 = levels.member[(0u + _e229)].row_z;
                        let _e294 = ((((_e283.x * _e198.x) + (_e283.y * _e198.y)) + (_e283.z * _e198.z)) + (_e283.w * 1f));
                        if (_e253 > 0f) {
                            if (_e267 >= 0f) {
                                phi_817_ = (_e267 <= 1f);
                            } else {
                                phi_817_ = false;
                            }
                            let _e299 = phi_817_;
                            if _e299 {
                                if (_e281 >= 0f) {
                                    phi_826_ = (_e281 <= 1f);
                                } else {
                                    phi_826_ = false;
                                }
                                let _e303 = phi_826_;
                                if _e303 {
                                    if (_e294 >= 0f) {
                                        phi_835_ = (_e294 <= 1f);
                                    } else {
                                        phi_835_ = false;
                                    }
                                    let _e307 = phi_835_;
                                    phi_836_ = _e307;
                                    phi_837_ = false;
                                } else {
                                    phi_836_ = bool();
                                    phi_837_ = true;
                                }
                                let _e309 = phi_836_;
                                let _e311 = phi_837_;
                                phi_838_ = _e309;
                                phi_839_ = _e311;
                            } else {
                                phi_838_ = bool();
                                phi_839_ = true;
                            }
                            let _e313 = phi_838_;
                            let _e315 = phi_839_;
                            phi_840_ = _e313;
                            phi_841_ = _e315;
                        } else {
                            phi_840_ = bool();
                            phi_841_ = true;
                        }
                        let _e317 = phi_840_;
                        let _e319 = phi_841_;
                        if _e319 {
                            phi_845_ = false;
                        } else {
                            phi_845_ = _e317;
                        }
                        let _e321 = phi_845_;
                        if _e321 {
                            if (_e267 >= _e202) {
                                if (_e267 <= (1f - _e202)) {
                                    if (_e281 >= _e202) {
                                        phi_872_ = (_e281 <= (1f - _e202));
                                        phi_873_ = false;
                                    } else {
                                        phi_872_ = bool();
                                        phi_873_ = true;
                                    }
                                    let _e329 = phi_872_;
                                    let _e331 = phi_873_;
                                    phi_874_ = _e329;
                                    phi_875_ = _e331;
                                } else {
                                    phi_874_ = bool();
                                    phi_875_ = true;
                                }
                                let _e333 = phi_874_;
                                let _e335 = phi_875_;
                                phi_876_ = _e333;
                                phi_877_ = _e335;
                            } else {
                                phi_876_ = bool();
                                phi_877_ = true;
                            }
                            let _e337 = phi_876_;
                            let _e339 = phi_877_;
                            phi_878_ = _e337;
                            phi_879_ = _e339;
                        } else {
                            phi_878_ = bool();
                            phi_879_ = true;
                        }
                        let _e341 = phi_878_;
                        let _e343 = phi_879_;
                        if _e343 {
                            phi_883_ = false;
                        } else {
                            phi_883_ = _e341;
                        }
                        let _e345 = phi_883_;
                        let _e352 = lt_math_LightPoint(vec2<f32>(_e267, _e227.uv.y), _e227.depth, _e227.is_inside);
                        let _e359 = lt_math_LightPoint(vec2<f32>(_e352.uv.x, _e281), _e352.depth, _e352.is_inside);
                        let _e363 = lt_math_LightPoint(_e359.uv, _e294, _e359.is_inside);
                        let _e367 = lt_math_LightPoint(_e363.uv, _e363.depth, _e345);
                        phi_892_ = _e367;
                        phi_893_ = (_e229 + 1u);
                        phi_894_ = lt_math_LevelPoint(_e229, _e367);
                        phi_895_ = true;
                    }
                    let _e371 = phi_892_;
                    let _e373 = phi_893_;
                    let _e375 = phi_894_;
                    let _e377 = phi_895_;
                    phi_727_ = _e371;
                    phi_730_ = _e373;
                    phi_732_ = _e375;
                    phi_896_ = _e377;
                } else {
                    phi_727_ = lt_math_LightPoint();
                    phi_730_ = u32();
                    phi_732_ = lt_math_LevelPoint();
                    phi_896_ = false;
                }
                let _e379 = phi_727_;
                let _e381 = phi_730_;
                let _e383 = phi_732_;
                let _e385 = phi_896_;
                continue;
                continuing {
                    phi_726_ = _e379;
                    phi_729_ = _e381;
                    phi_731_ = _e383;
                    break if !(_e385);
                }
            }
            let _e388 = local_1;
            if _e388.point.is_inside {
                if (0f > 0f) {
                    let _e394 = local_2;
                    if (_e394.level < _e67) {
                    } else {
                        return;
                    }
                    let _e399 = levels.member[(0u + _e394.level)];
                    let _e405 = global[0u];
                    if (_e399.row_w.x == _e405) {
                        let _e408 = global[1u];
                        if (_e399.row_w.y == _e408) {
                            let _e411 = global[2u];
                            phi_936_ = (_e399.row_w.z == _e411);
                            phi_937_ = false;
                        } else {
                            phi_936_ = bool();
                            phi_937_ = true;
                        }
                        let _e414 = phi_936_;
                        let _e416 = phi_937_;
                        phi_938_ = _e414;
                        phi_939_ = _e416;
                    } else {
                        phi_938_ = bool();
                        phi_939_ = true;
                    }
                    let _e418 = phi_938_;
                    let _e420 = phi_939_;
                    if _e420 {
                        phi_943_ = false;
                    } else {
                        phi_943_ = _e418;
                    }
                    let _e422 = phi_943_;
                    if _e422 {
                        let _e424 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e426 = p.member.map_size;
                        let _e496 = ((abs(((((_e399.row_x.x * _e424.x) + (_e399.row_x.y * _e424.y)) + (_e399.row_x.z * _e424.z)) / (((_e399.row_x.x * _e399.row_x.x) + (_e399.row_x.y * _e399.row_x.y)) + (_e399.row_x.z * _e399.row_x.z)))) + abs(((((_e399.row_y.x * _e424.x) + (_e399.row_y.y * _e424.y)) + (_e399.row_y.z * _e424.z)) / (((_e399.row_y.x * _e399.row_y.x) + (_e399.row_y.y * _e399.row_y.y)) + (_e399.row_y.z * _e399.row_y.z))))) / (abs(((((_e399.row_z.x * _e424.x) + (_e399.row_z.y * _e424.y)) + (_e399.row_z.z * _e424.z)) / (((_e399.row_z.x * _e399.row_z.x) + (_e399.row_z.y * _e399.row_z.y)) + (_e399.row_z.z * _e399.row_z.z)))) * f32(_e426)));
                        if (_e496 < 0.002f) {
                            phi_1025_ = _e496;
                        } else {
                            phi_1025_ = 0.002f;
                        }
                        let _e499 = phi_1025_;
                        phi_1142_ = _e499;
                    } else {
                        let _e501 = p.member.map_size;
                        let _e507 = samples.member[(0u + _e73.first_primitive)].position;
                        let _e518 = ((((_e399.row_w.x * _e507.x) + (_e399.row_w.y * _e507.y)) + (_e399.row_w.z * _e507.z)) + _e399.row_w.w);
                        let _e531 = ((_e399.row_x.x - (_e399.row_w.x * _e388.point.uv.x)) / _e518);
                        let _e532 = ((_e399.row_x.y - (_e399.row_w.y * _e388.point.uv.x)) / _e518);
                        let _e533 = ((_e399.row_x.z - (_e399.row_w.z * _e388.point.uv.x)) / _e518);
                        let _e546 = ((_e399.row_y.x - (_e399.row_w.x * _e388.point.uv.y)) / _e518);
                        let _e547 = ((_e399.row_y.y - (_e399.row_w.y * _e388.point.uv.y)) / _e518);
                        let _e548 = ((_e399.row_y.z - (_e399.row_w.z * _e388.point.uv.y)) / _e518);
                        let _e554 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e559 = ((_e547 * _e554.z) - (_e554.y * _e548));
                        let _e564 = ((_e548 * _e554.x) - (_e554.z * _e546));
                        let _e569 = ((_e546 * _e554.y) - (_e554.x * _e547));
                        let _e571 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e576 = ((_e532 * _e571.z) - (_e571.y * _e533));
                        let _e581 = ((_e533 * _e571.x) - (_e571.z * _e531));
                        let _e586 = ((_e531 * _e571.y) - (_e571.x * _e532));
                        let _e613 = ((abs(((((_e399.row_z.x * _e559) + (_e399.row_z.y * _e564)) + (_e399.row_z.z * _e569)) / (((_e531 * _e559) + (_e532 * _e564)) + (_e533 * _e569)))) + abs(((((_e399.row_z.x * _e576) + (_e399.row_z.y * _e581)) + (_e399.row_z.z * _e586)) / (((_e546 * _e576) + (_e547 * _e581)) + (_e548 * _e586))))) / f32(_e501));
                        if (_e613 < 0.002f) {
                            phi_1141_ = _e613;
                        } else {
                            phi_1141_ = 0.002f;
                        }
                        let _e616 = phi_1141_;
                        phi_1142_ = _e616;
                    }
                    let _e618 = phi_1142_;
                    phi_1145_ = (_e388.point.depth - (0f * _e618));
                } else {
                    phi_1145_ = _e388.point.depth;
                }
                let _e622 = phi_1145_;
                let _e628 = p.member.map_size;
                let _e629 = f32(_e628);
                let _e632 = ((_e388.point.uv.x * _e629) - 0.5f);
                let _e633 = ((_e388.point.uv.y * _e629) - 0.5f);
                if (_e632 > -8388608f) {
                    let _e645 = f32(select(0i, select(select(i32(_e632), i32(-2147483648), (_e632 < bitcast<f32>(3472883712u))), 2147483647i, (_e632 > bitcast<f32>(1325400063u))), (_e632 == _e632)));
                    if (_e645 > _e632) {
                        phi_1174_ = 1f;
                    } else {
                        phi_1174_ = 0f;
                    }
                    let _e648 = phi_1174_;
                    if (_e632 < 8388608f) {
                        phi_1179_ = (_e645 - _e648);
                        phi_1180_ = false;
                    } else {
                        phi_1179_ = f32();
                        phi_1180_ = true;
                    }
                    let _e651 = phi_1179_;
                    let _e653 = phi_1180_;
                    phi_1181_ = _e651;
                    phi_1182_ = _e653;
                } else {
                    phi_1181_ = f32();
                    phi_1182_ = true;
                }
                let _e655 = phi_1181_;
                let _e657 = phi_1182_;
                if _e657 {
                    phi_1186_ = _e632;
                } else {
                    phi_1186_ = _e655;
                }
                let _e659 = phi_1186_;
                if (_e633 > -8388608f) {
                    let _e671 = f32(select(0i, select(select(i32(_e633), i32(-2147483648), (_e633 < bitcast<f32>(3472883712u))), 2147483647i, (_e633 > bitcast<f32>(1325400063u))), (_e633 == _e633)));
                    if (_e671 > _e633) {
                        phi_1206_ = 1f;
                    } else {
                        phi_1206_ = 0f;
                    }
                    let _e674 = phi_1206_;
                    if (_e633 < 8388608f) {
                        phi_1211_ = (_e671 - _e674);
                        phi_1212_ = false;
                    } else {
                        phi_1211_ = f32();
                        phi_1212_ = true;
                    }
                    let _e677 = phi_1211_;
                    let _e679 = phi_1212_;
                    phi_1213_ = _e677;
                    phi_1214_ = _e679;
                } else {
                    phi_1213_ = f32();
                    phi_1214_ = true;
                }
                let _e681 = phi_1213_;
                let _e683 = phi_1214_;
                if _e683 {
                    phi_1218_ = _e633;
                } else {
                    phi_1218_ = _e681;
                }
                let _e685 = phi_1218_;
                let _e686 = (_e632 - _e659);
                let _e687 = (_e633 - _e685);
                let _e696 = select(0i, select(select(i32(_e659), i32(-2147483648), (_e659 < bitcast<f32>(3472883712u))), 2147483647i, (_e659 > bitcast<f32>(1325400063u))), (_e659 == _e659));
                let _e705 = select(0i, select(select(i32(_e685), i32(-2147483648), (_e685 < bitcast<f32>(3472883712u))), 2147483647i, (_e685 > bitcast<f32>(1325400063u))), (_e685 == _e685));
                let _e708 = ((1f - _e686) * (1f - _e687));
                let _e710 = (_e686 * (1f - _e687));
                let _e712 = ((1f - _e686) * _e687);
                let _e713 = (_e686 * _e687);
                let _e715 = p.member.test;
                let _e716 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e715);
                let _e718 = p.member.map_size;
                let _e720 = local_3;
                local = lt_math_Evsm(_e716.positive_exponent, _e716.negative_exponent, _e716.min_variance);
                let _e727 = ((_e720.level * _e718) * _e718);
                let _e729 = (bitcast<i32>(_e718) - 1i);
                if (_e696 > 0i) {
                    phi_1271_ = _e696;
                } else {
                    phi_1271_ = 0i;
                }
                let _e732 = phi_1271_;
                if (_e705 > 0i) {
                    phi_1276_ = _e705;
                } else {
                    phi_1276_ = 0i;
                }
                let _e735 = phi_1276_;
                if (_e732 < _e729) {
                    phi_1281_ = _e732;
                } else {
                    phi_1281_ = _e729;
                }
                let _e738 = phi_1281_;
                if (_e735 < _e729) {
                    phi_1286_ = _e735;
                } else {
                    phi_1286_ = _e729;
                }
                let _e741 = phi_1286_;
                let _e742 = bitcast<u32>(_e738);
                let _e744 = (_e696 + 1i);
                let _e745 = (_e705 + 1i);
                if (_e744 > 0i) {
                    phi_1295_ = _e744;
                } else {
                    phi_1295_ = 0i;
                }
                let _e748 = phi_1295_;
                if (_e745 > 0i) {
                    phi_1300_ = _e745;
                } else {
                    phi_1300_ = 0i;
                }
                let _e751 = phi_1300_;
                if (_e748 < _e729) {
                    phi_1305_ = _e748;
                } else {
                    phi_1305_ = _e729;
                }
                let _e754 = phi_1305_;
                if (_e751 < _e729) {
                    phi_1310_ = _e751;
                } else {
                    phi_1310_ = _e729;
                }
                let _e757 = phi_1310_;
                let _e758 = bitcast<u32>(_e754);
                let _e760 = (bitcast<u32>(_e741) * _e718);
                let _e761 = (bitcast<u32>(_e757) * _e718);
                let _e766 = ((_e760 + _e742) + _e727);
                let _e767 = ((_e760 + _e758) + _e727);
                let _e768 = ((_e761 + _e742) + _e727);
                let _e769 = ((_e761 + _e758) + _e727);
                if (_e766 < _e61) {
                } else {
                    return;
                }
                let _e773 = map.member[(0u + _e766)];
                if (_e767 < _e61) {
                } else {
                    return;
                }
                let _e785 = map.member[(0u + _e767)];
                if (_e768 < _e61) {
                } else {
                    return;
                }
                let _e801 = map.member[(0u + _e768)];
                if (_e769 < _e61) {
                } else {
                    return;
                }
                let _e817 = map.member[(0u + _e769)];
                let _e831 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e773.x * _e708) + (_e785.x * _e710)) + (_e801.x * _e712)) + (_e817.x * _e713)), ((((_e773.y * _e708) + (_e785.y * _e710)) + (_e801.y * _e712)) + (_e817.y * _e713)), ((((_e773.z * _e708) + (_e785.z * _e710)) + (_e801.z * _e712)) + (_e817.z * _e713)), ((((_e773.w * _e708) + (_e785.w * _e710)) + (_e801.w * _e712)) + (_e817.w * _e713))), _e622);
                let _e833 = p.member.fade_uv;
                if (_e833 > 0f) {
                    let _e836 = local_4;
                    if ((_e836.level + 1u) == _e79) {
                        let _e845 = p.member.fade_uv;
                        let _e847 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e388.point.uv.x, (1f - _e388.point.uv.x));
                        let _e849 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e388.point.uv.y, (1f - _e388.point.uv.y));
                        let _e850 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e847, _e849);
                        if (_e850 < _e845) {
                            phi_1426_ = (1f - ((1f - _e831) * (_e850 / _e845)));
                        } else {
                            phi_1426_ = _e831;
                        }
                        let _e857 = phi_1426_;
                        phi_1428_ = evaluate_Verdict(_e857, false);
                        phi_1429_ = false;
                    } else {
                        phi_1428_ = evaluate_Verdict();
                        phi_1429_ = true;
                    }
                    let _e860 = phi_1428_;
                    let _e862 = phi_1429_;
                    phi_1430_ = _e860;
                    phi_1431_ = _e862;
                } else {
                    phi_1430_ = evaluate_Verdict();
                    phi_1431_ = true;
                }
                let _e864 = phi_1430_;
                let _e866 = phi_1431_;
                if _e866 {
                    phi_1436_ = evaluate_Verdict(_e831, false);
                    phi_1437_ = false;
                } else {
                    phi_1436_ = evaluate_Verdict();
                    phi_1437_ = true;
                }
                let _e869 = phi_1436_;
                let _e871 = phi_1437_;
                phi_1439_ = _e869;
                phi_1440_ = _e864;
                phi_1441_ = _e871;
            } else {
                phi_1439_ = evaluate_Verdict();
                phi_1440_ = evaluate_Verdict(1f, false);
                phi_1441_ = true;
            }
            let _e874 = phi_1439_;
            let _e876 = phi_1440_;
            let _e878 = phi_1441_;
            if _e878 {
            }
            phi_1445_ = _e876;
            phi_1446_ = _e874;
            phi_1447_ = _e878;
        }
        let _e880 = phi_1445_;
        let _e882 = phi_1446_;
        let _e884 = phi_1447_;
        if _e884 {
            phi_1451_ = _e880;
        } else {
            phi_1451_ = _e882;
        }
        let _e886 = phi_1451_;
        if (_e73.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.first_primitive)] = _e886.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
