struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
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

struct type_31 {
    member: array<vec4<f32>>,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
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
    fade_uv: f32,
    pad0_: u32,
}

struct type_37 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_42 {
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
var<uniform> p: type_37;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_42;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_167_: lt_bvh_traverse_Tree;
    var phi_168_: bool;
    var phi_169_: lt_bvh_traverse_Tree;
    var phi_170_: bool;
    var phi_175_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_167_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_168_ = false;
        } else {
            phi_167_ = lt_bvh_traverse_Tree();
            phi_168_ = true;
        }
        let _e66 = phi_167_;
        let _e68 = phi_168_;
        phi_169_ = _e66;
        phi_170_ = _e68;
    } else {
        phi_169_ = lt_bvh_traverse_Tree();
        phi_170_ = true;
    }
    let _e70 = phi_169_;
    let _e72 = phi_170_;
    if _e72 {
        phi_175_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_175_ = _e70;
    }
    let _e77 = phi_175_;
    return lt_bvh_traverse_Tree(_e77.root, _e77.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_202_: f32;
    var phi_203_: f32;
    var phi_204_: f32;
    var phi_217_: bool;
    var phi_221_: f32;
    var phi_233_: f32;
    var phi_238_: f32;
    var phi_260_: f32;
    var phi_265_: f32;
    var phi_266_: bool;
    var phi_267_: f32;
    var phi_268_: bool;
    var phi_272_: f32;
    var phi_310_: f32;
    var phi_323_: bool;
    var phi_327_: f32;
    var phi_340_: f32;
    var phi_345_: f32;
    var phi_367_: f32;
    var phi_372_: f32;
    var phi_373_: bool;
    var phi_374_: f32;
    var phi_375_: bool;
    var phi_379_: f32;
    var phi_417_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_204_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_203_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_202_ = 1f;
            } else {
                phi_202_ = param_5;
            }
            let _e61 = phi_202_;
            phi_203_ = _e61;
        }
        let _e63 = phi_203_;
        phi_204_ = _e63;
    }
    let _e65 = phi_204_;
    let _e67 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_217_ = true;
    } else {
        let _e71 = (42f < _e67);
        if _e71 {
        }
        phi_217_ = _e71;
    }
    let _e73 = phi_217_;
    if _e73 {
        phi_221_ = 42f;
    } else {
        phi_221_ = _e67;
    }
    let _e75 = phi_221_;
    let _e76 = (_e75 * _e65);
    if ((bitcast<u32>(_e76) & 2147483647u) > 2139095040u) {
        phi_310_ = _e76;
    } else {
        if (_e76 < -87f) {
            phi_233_ = -87f;
        } else {
            phi_233_ = _e76;
        }
        let _e82 = phi_233_;
        if (_e82 > 88f) {
            phi_238_ = 88f;
        } else {
            phi_238_ = _e82;
        }
        let _e85 = phi_238_;
        let _e87 = ((_e85 * 1.442695f) + 0.5f);
        if (_e87 > -8388608f) {
            let _e99 = f32(select(0i, select(select(i32(_e87), i32(-2147483648), (_e87 < bitcast<f32>(3472883712u))), 2147483647i, (_e87 > bitcast<f32>(1325400063u))), (_e87 == _e87)));
            if (_e99 > _e87) {
                phi_260_ = 1f;
            } else {
                phi_260_ = 0f;
            }
            let _e102 = phi_260_;
            if (_e87 < 8388608f) {
                phi_265_ = (_e99 - _e102);
                phi_266_ = false;
            } else {
                phi_265_ = f32();
                phi_266_ = true;
            }
            let _e105 = phi_265_;
            let _e107 = phi_266_;
            phi_267_ = _e105;
            phi_268_ = _e107;
        } else {
            phi_267_ = f32();
            phi_268_ = true;
        }
        let _e109 = phi_267_;
        let _e111 = phi_268_;
        if _e111 {
            phi_272_ = _e87;
        } else {
            phi_272_ = _e109;
        }
        let _e113 = phi_272_;
        let _e117 = ((_e85 - (_e113 * 0.69314575f)) - (_e113 * 0.0000014286068f));
        phi_310_ = ((((((((((((((((1f / 5040f) * _e117) + (1f / 720f)) * _e117) + (1f / 120f)) * _e117) + (1f / 24f)) * _e117) + (1f / 6f)) * _e117) + 0.5f) * _e117) + 1f) * _e117) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e113), i32(-2147483648), (_e113 < bitcast<f32>(3472883712u))), 2147483647i, (_e113 > bitcast<f32>(1325400063u))), (_e113 == _e113)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e153 = phi_310_;
    let _e155 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_323_ = true;
    } else {
        let _e159 = (42f < _e155);
        if _e159 {
        }
        phi_323_ = _e159;
    }
    let _e161 = phi_323_;
    if _e161 {
        phi_327_ = 42f;
    } else {
        phi_327_ = _e155;
    }
    let _e163 = phi_327_;
    let _e165 = (-(_e163) * _e65);
    if ((bitcast<u32>(_e165) & 2147483647u) > 2139095040u) {
        phi_417_ = _e165;
    } else {
        if (_e165 < -87f) {
            phi_340_ = -87f;
        } else {
            phi_340_ = _e165;
        }
        let _e171 = phi_340_;
        if (_e171 > 88f) {
            phi_345_ = 88f;
        } else {
            phi_345_ = _e171;
        }
        let _e174 = phi_345_;
        let _e176 = ((_e174 * 1.442695f) + 0.5f);
        if (_e176 > -8388608f) {
            let _e188 = f32(select(0i, select(select(i32(_e176), i32(-2147483648), (_e176 < bitcast<f32>(3472883712u))), 2147483647i, (_e176 > bitcast<f32>(1325400063u))), (_e176 == _e176)));
            if (_e188 > _e176) {
                phi_367_ = 1f;
            } else {
                phi_367_ = 0f;
            }
            let _e191 = phi_367_;
            if (_e176 < 8388608f) {
                phi_372_ = (_e188 - _e191);
                phi_373_ = false;
            } else {
                phi_372_ = f32();
                phi_373_ = true;
            }
            let _e194 = phi_372_;
            let _e196 = phi_373_;
            phi_374_ = _e194;
            phi_375_ = _e196;
        } else {
            phi_374_ = f32();
            phi_375_ = true;
        }
        let _e198 = phi_374_;
        let _e200 = phi_375_;
        if _e200 {
            phi_379_ = _e176;
        } else {
            phi_379_ = _e198;
        }
        let _e202 = phi_379_;
        let _e206 = ((_e174 - (_e202 * 0.69314575f)) - (_e202 * 0.0000014286068f));
        phi_417_ = ((((((((((((((((1f / 5040f) * _e206) + (1f / 720f)) * _e206) + (1f / 120f)) * _e206) + (1f / 24f)) * _e206) + (1f / 6f)) * _e206) + 0.5f) * _e206) + 1f) * _e206) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e202), i32(-2147483648), (_e202 < bitcast<f32>(3472883712u))), 2147483647i, (_e202 > bitcast<f32>(1325400063u))), (_e202 == _e202)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e242 = phi_417_;
    let _e243 = -(_e242);
    return vec4<f32>(_e153, (_e153 * _e153), _e243, (_e243 * _e243));
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_6: f32, param_7: f32) -> f32 {
    var phi_429_: f32;

    if (param_6 < param_7) {
        phi_429_ = param_6;
    } else {
        phi_429_ = param_7;
    }
    let _e57 = phi_429_;
    return _e57;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_8: ptr<function, lt_math_Evsm>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_447_: bool;
    var phi_451_: f32;
    var phi_475_: bool;
    var phi_479_: f32;
    var phi_491_: bool;
    var phi_498_: f32;
    var phi_511_: bool;
    var phi_515_: f32;
    var phi_539_: bool;
    var phi_543_: f32;
    var phi_555_: bool;
    var phi_562_: f32;
    var phi_573_: bool;
    var phi_577_: f32;
    var phi_592_: f32;
    var phi_593_: f32;
    var phi_594_: f32;

    let _e56 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_8, param_10);
    let _e58 = (*param_8).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_447_ = true;
    } else {
        let _e62 = (42f < _e58);
        if _e62 {
        }
        phi_447_ = _e62;
    }
    let _e64 = phi_447_;
    if _e64 {
        phi_451_ = 42f;
    } else {
        phi_451_ = _e58;
    }
    let _e66 = phi_451_;
    let _e68 = (*param_8).min_variance;
    let _e72 = (((_e68 * _e66) * _e66) * _e56.y);
    let _e79 = ((param_9.y - (param_9.x * param_9.x)) + (0.00000047683716f * param_9.y));
    if ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u) {
        phi_475_ = true;
    } else {
        let _e83 = (_e72 > _e79);
        if _e83 {
        }
        phi_475_ = _e83;
    }
    let _e85 = phi_475_;
    if _e85 {
        phi_479_ = _e72;
    } else {
        phi_479_ = _e79;
    }
    let _e87 = phi_479_;
    let _e88 = (_e56.x - param_9.x);
    if (_e88 <= 0f) {
        let _e92 = ((bitcast<u32>(_e87) & 2147483647u) > 2139095040u);
        if _e92 {
        }
        phi_491_ = _e92;
    } else {
        phi_491_ = true;
    }
    let _e94 = phi_491_;
    if _e94 {
        phi_498_ = (_e87 / (_e87 + (_e88 * _e88)));
    } else {
        phi_498_ = 1f;
    }
    let _e99 = phi_498_;
    let _e101 = (*param_8).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_511_ = true;
    } else {
        let _e105 = (42f < _e101);
        if _e105 {
        }
        phi_511_ = _e105;
    }
    let _e107 = phi_511_;
    if _e107 {
        phi_515_ = 42f;
    } else {
        phi_515_ = _e101;
    }
    let _e109 = phi_515_;
    let _e111 = (*param_8).min_variance;
    let _e115 = (((_e111 * _e109) * _e109) * _e56.w);
    let _e122 = ((param_9.w - (param_9.z * param_9.z)) + (0.00000047683716f * param_9.w));
    if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
        phi_539_ = true;
    } else {
        let _e126 = (_e115 > _e122);
        if _e126 {
        }
        phi_539_ = _e126;
    }
    let _e128 = phi_539_;
    if _e128 {
        phi_543_ = _e115;
    } else {
        phi_543_ = _e122;
    }
    let _e130 = phi_543_;
    let _e131 = (_e56.z - param_9.z);
    if (_e131 <= 0f) {
        let _e135 = ((bitcast<u32>(_e130) & 2147483647u) > 2139095040u);
        if _e135 {
        }
        phi_555_ = _e135;
    } else {
        phi_555_ = true;
    }
    let _e137 = phi_555_;
    if _e137 {
        phi_562_ = (_e130 / (_e130 + (_e131 * _e131)));
    } else {
        phi_562_ = 1f;
    }
    let _e142 = phi_562_;
    if ((bitcast<u32>(_e142) & 2147483647u) > 2139095040u) {
        phi_573_ = true;
    } else {
        let _e146 = (_e142 < _e99);
        if _e146 {
        }
        phi_573_ = _e146;
    }
    let _e148 = phi_573_;
    if _e148 {
        phi_577_ = _e142;
    } else {
        phi_577_ = _e99;
    }
    let _e150 = phi_577_;
    if ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u) {
        phi_594_ = _e150;
    } else {
        if (_e150 < 0f) {
            phi_593_ = 0f;
        } else {
            if (_e150 > 1f) {
                phi_592_ = 1f;
            } else {
                phi_592_ = _e150;
            }
            let _e157 = phi_592_;
            phi_593_ = _e157;
        }
        let _e159 = phi_593_;
        phi_594_ = _e159;
    }
    let _e161 = phi_594_;
    return _e161;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_654_: bool;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_661_: bool;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_743_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_744_: bool;
    var phi_745_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_746_: bool;
    var phi_753_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_757_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_777_: lt_math_LightPoint;
    var phi_780_: u32;
    var phi_782_: lt_math_LevelPoint;
    var phi_868_: bool;
    var phi_877_: bool;
    var phi_886_: bool;
    var phi_887_: bool;
    var phi_888_: bool;
    var phi_889_: bool;
    var phi_890_: bool;
    var phi_891_: bool;
    var phi_892_: bool;
    var phi_896_: bool;
    var phi_923_: bool;
    var phi_924_: bool;
    var phi_925_: bool;
    var phi_926_: bool;
    var phi_927_: bool;
    var phi_928_: bool;
    var phi_929_: bool;
    var phi_930_: bool;
    var phi_934_: bool;
    var phi_943_: lt_math_LightPoint;
    var phi_944_: u32;
    var phi_945_: lt_math_LevelPoint;
    var phi_946_: bool;
    var phi_778_: lt_math_LightPoint;
    var phi_781_: u32;
    var phi_783_: lt_math_LevelPoint;
    var phi_947_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_987_: bool;
    var phi_988_: bool;
    var phi_989_: bool;
    var phi_990_: bool;
    var phi_994_: bool;
    var phi_1076_: f32;
    var phi_1192_: f32;
    var phi_1193_: f32;
    var phi_1196_: f32;
    var phi_1225_: f32;
    var phi_1230_: f32;
    var phi_1231_: bool;
    var phi_1232_: f32;
    var phi_1233_: bool;
    var phi_1237_: f32;
    var phi_1257_: f32;
    var phi_1262_: f32;
    var phi_1263_: bool;
    var phi_1264_: f32;
    var phi_1265_: bool;
    var phi_1269_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1322_: i32;
    var phi_1327_: i32;
    var phi_1332_: i32;
    var phi_1337_: i32;
    var phi_1346_: i32;
    var phi_1351_: i32;
    var phi_1356_: i32;
    var phi_1361_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1477_: f32;
    var phi_1479_: evaluate_Verdict;
    var phi_1480_: bool;
    var phi_1481_: evaluate_Verdict;
    var phi_1482_: bool;
    var phi_1487_: evaluate_Verdict;
    var phi_1488_: bool;
    var phi_1490_: evaluate_Verdict;
    var phi_1491_: evaluate_Verdict;
    var phi_1492_: bool;
    var phi_1496_: evaluate_Verdict;
    var phi_1497_: evaluate_Verdict;
    var phi_1498_: bool;
    var phi_1502_: evaluate_Verdict;

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
        let _e86 = samples.member[(0u + _e73.first_primitive)].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[(0u + _e73.first_primitive)].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[(0u + _e73.first_primitive)].normal[2u];
                let _e98 = global[2u];
                phi_654_ = (_e96 == _e98);
                phi_655_ = false;
            } else {
                phi_654_ = bool();
                phi_655_ = true;
            }
            let _e101 = phi_654_;
            let _e103 = phi_655_;
            phi_656_ = _e101;
            phi_657_ = _e103;
        } else {
            phi_656_ = bool();
            phi_657_ = true;
        }
        let _e105 = phi_656_;
        let _e107 = phi_657_;
        if _e107 {
            phi_661_ = false;
        } else {
            phi_661_ = _e105;
        }
        let _e109 = phi_661_;
        if !(_e109) {
            let _e112 = samples.member[(0u + _e73.first_primitive)].position;
            let _e114 = p.member.light.place;
            let _e120 = p.member.light.place[3u];
            let _e127 = (_e114.x - (_e112.x * _e120));
            let _e128 = (_e114.y - (_e112.y * _e120));
            let _e129 = (_e114.z - (_e112.z * _e120));
            let _e131 = samples.member[(0u + _e73.first_primitive)].normal;
            if ((((_e131.x * _e127) + (_e131.y * _e128)) + (_e131.z * _e129)) > 0f) {
                let _e145 = (((_e127 * _e127) + (_e128 * _e128)) + (_e129 * _e129));
                let _e147 = p.member.light.axis;
                let _e159 = p.member.light.place[3u];
                if (_e159 == 0f) {
                    phi_732_ = true;
                } else {
                    let _e162 = p.member.light.range_squared;
                    if (_e145 <= _e162) {
                        let _e165 = p.member.light.cos_outer;
                        phi_731_ = (-((((_e127 * _e147.x) + (_e128 * _e147.y)) + (_e129 * _e147.z))) >= (_e165 * sqrt(_e145)));
                    } else {
                        phi_731_ = false;
                    }
                    let _e170 = phi_731_;
                    phi_732_ = _e170;
                }
                let _e172 = phi_732_;
                if _e172 {
                    let _e174 = samples.member[(0u + _e73.first_primitive)].flags;
                    let _e182 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e182.unnamed.visibility, false), _e182.unnamed_1);
                    phi_743_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e188.unnamed, ((_e174 & 1u) == 0u));
                    phi_744_ = false;
                } else {
                    phi_743_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_744_ = true;
                }
                let _e193 = phi_743_;
                let _e195 = phi_744_;
                phi_745_ = _e193;
                phi_746_ = _e195;
            } else {
                phi_745_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_746_ = true;
            }
            let _e197 = phi_745_;
            let _e199 = phi_746_;
            if _e199 {
                let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
                phi_753_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
            } else {
                phi_753_ = _e197;
            }
            let _e216 = phi_753_;
            phi_757_ = _e216;
        } else {
            let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
            phi_757_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, true);
        }
        let _e233 = phi_757_;
        if _e233.unnamed_1 {
            phi_1496_ = evaluate_Verdict(_e233.unnamed.visibility, _e233.unnamed.is_doubted);
            phi_1497_ = evaluate_Verdict();
            phi_1498_ = true;
        } else {
            let _e241 = samples.member[(0u + _e73.first_primitive)].position;
            let _e243 = p.member.map_size;
            let _e245 = (0.5f / f32(_e243));
            let _e252 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e259 = lt_math_LightPoint(vec2<f32>(_e252.uv.x, 0f), _e252.depth, _e252.is_inside);
            let _e263 = lt_math_LightPoint(_e259.uv, 0f, _e259.is_inside);
            phi_777_ = lt_math_LightPoint();
            phi_780_ = 0u;
            phi_782_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e263.uv, _e263.depth, false));
            loop {
                let _e270 = phi_777_;
                let _e272 = phi_780_;
                let _e274 = phi_782_;
                local_1 = _e274;
                local_2 = _e274;
                local_3 = _e274;
                local_4 = _e274;
                if (_e272 < _e79) {
                    if _e274.point.is_inside {
                        phi_943_ = lt_math_LightPoint();
                        phi_944_ = u32();
                        phi_945_ = lt_math_LevelPoint();
                        phi_946_ = false;
                    } else {
                        if (_e272 < _e67) {
                        } else {
                            return;
                        }
                        let _e285 = levels.member[(0u + _e272)].row_w;
                        let _e296 = ((((_e285.x * _e241.x) + (_e285.y * _e241.y)) + (_e285.z * _e241.z)) + (_e285.w * 1f));
                        let _e298 = levels.member[(0u + _e272)].row_x;
                        let _e310 = (((((_e298.x * _e241.x) + (_e298.y * _e241.y)) + (_e298.z * _e241.z)) + (_e298.w * 1f)) / _e296);
                        let _e312 = levels.member[(0u + _e272)].row_y;
                        let _e324 = (((((_e312.x * _e241.x) + (_e312.y * _e241.y)) + (_e312.z * _e241.z)) + (_e312.w * 1f)) / _e296);
                        let _e326 = levels.member[(0u + _e272)].row_z;
                        let _e337 = ((((_e326.x * _e241.x) + (_e326.y * _e241.y)) + (_e326.z * _e241.z)) + (_e326.w * 1f));
                        if (_e296 > 0f) {
                            if (_e310 >= 0f) {
                                phi_868_ = (_e310 <= 1f);
                            } else {
                                phi_868_ = false;
                            }
                            let _e342 = phi_868_;
                            if _e342 {
                                if (_e324 >= 0f) {
                                    phi_877_ = (_e324 <= 1f);
                                } else {
                                    phi_877_ = false;
                                }
                                let _e346 = phi_877_;
                                if _e346 {
                                    if (_e337 >= 0f) {
                                        phi_886_ = (_e337 <= 1f);
                                    } else {
                                        phi_886_ = false;
                                    }
                                    let _e350 = phi_886_;
                                    phi_887_ = _e350;
                                    phi_888_ = false;
                                } else {
                                    phi_887_ = bool();
                                    phi_888_ = true;
                                }
                                let _e352 = phi_887_;
                                let _e354 = phi_888_;
                                phi_889_ = _e352;
                                phi_890_ = _e354;
                            } else {
                                phi_889_ = bool();
                                phi_890_ = true;
                            }
                            let _e356 = phi_889_;
                            let _e358 = phi_890_;
                            phi_891_ = _e356;
                            phi_892_ = _e358;
                        } else {
                            phi_891_ = bool();
                            phi_892_ = true;
                        }
                        let _e360 = phi_891_;
                        let _e362 = phi_892_;
                        if _e362 {
                            phi_896_ = false;
                        } else {
                            phi_896_ = _e360;
                        }
                        let _e364 = phi_896_;
                        if _e364 {
                            if (_e310 >= _e245) {
                                if (_e310 <= (1f - _e245)) {
                                    if (_e324 >= _e245) {
                                        phi_923_ = (_e324 <= (1f - _e245));
                                        phi_924_ = false;
                                    } else {
                                        phi_923_ = bool();
                                        phi_924_ = true;
                                    }
                                    let _e372 = phi_923_;
                                    let _e374 = phi_924_;
                                    phi_925_ = _e372;
                                    phi_926_ = _e374;
                                } else {
                                    phi_925_ = bool();
                                    phi_926_ = true;
                                }
                                let _e376 = phi_925_;
                                let _e378 = phi_926_;
                                phi_927_ = _e376;
                                phi_928_ = _e378;
                            } else {
                                phi_927_ = bool();
                                phi_928_ = true;
                            }
                            let _e380 = phi_927_;
                            let _e382 = phi_928_;
                            phi_929_ = _e380;
                            phi_930_ = _e382;
                        } else {
                            phi_929_ = bool();
                            phi_930_ = true;
                        }
                        let _e384 = phi_929_;
                        let _e386 = phi_930_;
                        if _e386 {
                            phi_934_ = false;
                        } else {
                            phi_934_ = _e384;
                        }
                        let _e388 = phi_934_;
                        let _e395 = lt_math_LightPoint(vec2<f32>(_e310, _e270.uv.y), _e270.depth, _e270.is_inside);
                        let _e402 = lt_math_LightPoint(vec2<f32>(_e395.uv.x, _e324), _e395.depth, _e395.is_inside);
                        let _e406 = lt_math_LightPoint(_e402.uv, _e337, _e402.is_inside);
                        let _e410 = lt_math_LightPoint(_e406.uv, _e406.depth, _e388);
                        phi_943_ = _e410;
                        phi_944_ = (_e272 + 1u);
                        phi_945_ = lt_math_LevelPoint(_e272, _e410);
                        phi_946_ = true;
                    }
                    let _e414 = phi_943_;
                    let _e416 = phi_944_;
                    let _e418 = phi_945_;
                    let _e420 = phi_946_;
                    phi_778_ = _e414;
                    phi_781_ = _e416;
                    phi_783_ = _e418;
                    phi_947_ = _e420;
                } else {
                    phi_778_ = lt_math_LightPoint();
                    phi_781_ = u32();
                    phi_783_ = lt_math_LevelPoint();
                    phi_947_ = false;
                }
                let _e422 = phi_778_;
                let _e424 = phi_781_;
                let _e426 = phi_783_;
                let _e428 = phi_947_;
                continue;
                continuing {
                    phi_777_ = _e422;
                    phi_780_ = _e424;
                    phi_782_ = _e426;
                    break if !(_e428);
                }
            }
            let _e431 = local_1;
            if _e431.point.is_inside {
                if (0f > 0f) {
                    let _e437 = local_2;
                    if (_e437.level < _e67) {
                    } else {
                        return;
                    }
                    let _e442 = levels.member[(0u + _e437.level)];
                    let _e448 = global[0u];
                    if (_e442.row_w.x == _e448) {
                        let _e451 = global[1u];
                        if (_e442.row_w.y == _e451) {
                            let _e454 = global[2u];
                            phi_987_ = (_e442.row_w.z == _e454);
                            phi_988_ = false;
                        } else {
                            phi_987_ = bool();
                            phi_988_ = true;
                        }
                        let _e457 = phi_987_;
                        let _e459 = phi_988_;
                        phi_989_ = _e457;
                        phi_990_ = _e459;
                    } else {
                        phi_989_ = bool();
                        phi_990_ = true;
                    }
                    let _e461 = phi_989_;
                    let _e463 = phi_990_;
                    if _e463 {
                        phi_994_ = false;
                    } else {
                        phi_994_ = _e461;
                    }
                    let _e465 = phi_994_;
                    if _e465 {
                        let _e467 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e469 = p.member.map_size;
                        let _e539 = ((abs(((((_e442.row_x.x * _e467.x) + (_e442.row_x.y * _e467.y)) + (_e442.row_x.z * _e467.z)) / (((_e442.row_x.x * _e442.row_x.x) + (_e442.row_x.y * _e442.row_x.y)) + (_e442.row_x.z * _e442.row_x.z)))) + abs(((((_e442.row_y.x * _e467.x) + (_e442.row_y.y * _e467.y)) + (_e442.row_y.z * _e467.z)) / (((_e442.row_y.x * _e442.row_y.x) + (_e442.row_y.y * _e442.row_y.y)) + (_e442.row_y.z * _e442.row_y.z))))) / (abs(((((_e442.row_z.x * _e467.x) + (_e442.row_z.y * _e467.y)) + (_e442.row_z.z * _e467.z)) / (((_e442.row_z.x * _e442.row_z.x) + (_e442.row_z.y * _e442.row_z.y)) + (_e442.row_z.z * _e442.row_z.z)))) * f32(_e469)));
                        if (_e539 < 0.002f) {
                            phi_1076_ = _e539;
                        } else {
                            phi_1076_ = 0.002f;
                        }
                        let _e542 = phi_1076_;
                        phi_1193_ = _e542;
                    } else {
                        let _e544 = p.member.map_size;
                        let _e550 = samples.member[(0u + _e73.first_primitive)].position;
                        let _e561 = ((((_e442.row_w.x * _e550.x) + (_e442.row_w.y * _e550.y)) + (_e442.row_w.z * _e550.z)) + _e442.row_w.w);
                        let _e574 = ((_e442.row_x.x - (_e442.row_w.x * _e431.point.uv.x)) / _e561);
                        let _e575 = ((_e442.row_x.y - (_e442.row_w.y * _e431.point.uv.x)) / _e561);
                        let _e576 = ((_e442.row_x.z - (_e442.row_w.z * _e431.point.uv.x)) / _e561);
                        let _e589 = ((_e442.row_y.x - (_e442.row_w.x * _e431.point.uv.y)) / _e561);
                        let _e590 = ((_e442.row_y.y - (_e442.row_w.y * _e431.point.uv.y)) / _e561);
                        let _e591 = ((_e442.row_y.z - (_e442.row_w.z * _e431.point.uv.y)) / _e561);
                        let _e597 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e602 = ((_e590 * _e597.z) - (_e597.y * _e591));
                        let _e607 = ((_e591 * _e597.x) - (_e597.z * _e589));
                        let _e612 = ((_e589 * _e597.y) - (_e597.x * _e590));
                        let _e614 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e619 = ((_e575 * _e614.z) - (_e614.y * _e576));
                        let _e624 = ((_e576 * _e614.x) - (_e614.z * _e574));
                        let _e629 = ((_e574 * _e614.y) - (_e614.x * _e575));
                        let _e656 = ((abs(((((_e442.row_z.x * _e602) + (_e442.row_z.y * _e607)) + (_e442.row_z.z * _e612)) / (((_e574 * _e602) + (_e575 * _e607)) + (_e576 * _e612)))) + abs(((((_e442.row_z.x * _e619) + (_e442.row_z.y * _e624)) + (_e442.row_z.z * _e629)) / (((_e589 * _e619) + (_e590 * _e624)) + (_e591 * _e629))))) / f32(_e544));
                        if (_e656 < 0.002f) {
                            phi_1192_ = _e656;
                        } else {
                            phi_1192_ = 0.002f;
                        }
                        let _e659 = phi_1192_;
                        phi_1193_ = _e659;
                    }
                    let _e661 = phi_1193_;
                    phi_1196_ = (_e431.point.depth - (0f * _e661));
                } else {
                    phi_1196_ = _e431.point.depth;
                }
                let _e665 = phi_1196_;
                let _e671 = p.member.map_size;
                let _e672 = f32(_e671);
                let _e675 = ((_e431.point.uv.x * _e672) - 0.5f);
                let _e676 = ((_e431.point.uv.y * _e672) - 0.5f);
                if (_e675 > -8388608f) {
                    let _e688 = f32(select(0i, select(select(i32(_e675), i32(-2147483648), (_e675 < bitcast<f32>(3472883712u))), 2147483647i, (_e675 > bitcast<f32>(1325400063u))), (_e675 == _e675)));
                    if (_e688 > _e675) {
                        phi_1225_ = 1f;
                    } else {
                        phi_1225_ = 0f;
                    }
                    let _e691 = phi_1225_;
                    if (_e675 < 8388608f) {
                        phi_1230_ = (_e688 - _e691);
                        phi_1231_ = false;
                    } else {
                        phi_1230_ = f32();
                        phi_1231_ = true;
                    }
                    let _e694 = phi_1230_;
                    let _e696 = phi_1231_;
                    phi_1232_ = _e694;
                    phi_1233_ = _e696;
                } else {
                    phi_1232_ = f32();
                    phi_1233_ = true;
                }
                let _e698 = phi_1232_;
                let _e700 = phi_1233_;
                if _e700 {
                    phi_1237_ = _e675;
                } else {
                    phi_1237_ = _e698;
                }
                let _e702 = phi_1237_;
                if (_e676 > -8388608f) {
                    let _e714 = f32(select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < bitcast<f32>(3472883712u))), 2147483647i, (_e676 > bitcast<f32>(1325400063u))), (_e676 == _e676)));
                    if (_e714 > _e676) {
                        phi_1257_ = 1f;
                    } else {
                        phi_1257_ = 0f;
                    }
                    let _e717 = phi_1257_;
                    if (_e676 < 8388608f) {
                        phi_1262_ = (_e714 - _e717);
                        phi_1263_ = false;
                    } else {
                        phi_1262_ = f32();
                        phi_1263_ = true;
                    }
                    let _e720 = phi_1262_;
                    let _e722 = phi_1263_;
                    phi_1264_ = _e720;
                    phi_1265_ = _e722;
                } else {
                    phi_1264_ = f32();
                    phi_1265_ = true;
                }
                let _e724 = phi_1264_;
                let _e726 = phi_1265_;
                if _e726 {
                    phi_1269_ = _e676;
                } else {
                    phi_1269_ = _e724;
                }
                let _e728 = phi_1269_;
                let _e729 = (_e675 - _e702);
                let _e730 = (_e676 - _e728);
                let _e739 = select(0i, select(select(i32(_e702), i32(-2147483648), (_e702 < bitcast<f32>(3472883712u))), 2147483647i, (_e702 > bitcast<f32>(1325400063u))), (_e702 == _e702));
                let _e748 = select(0i, select(select(i32(_e728), i32(-2147483648), (_e728 < bitcast<f32>(3472883712u))), 2147483647i, (_e728 > bitcast<f32>(1325400063u))), (_e728 == _e728));
                let _e751 = ((1f - _e729) * (1f - _e730));
                let _e753 = (_e729 * (1f - _e730));
                let _e755 = ((1f - _e729) * _e730);
                let _e756 = (_e729 * _e730);
                let _e758 = p.member.test;
                let _e759 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e758);
                let _e761 = p.member.map_size;
                let _e763 = local_3;
                local = lt_math_Evsm(_e759.positive_exponent, _e759.negative_exponent, _e759.min_variance);
                let _e770 = ((_e763.level * _e761) * _e761);
                let _e772 = (bitcast<i32>(_e761) - 1i);
                if (_e739 > 0i) {
                    phi_1322_ = _e739;
                } else {
                    phi_1322_ = 0i;
                }
                let _e775 = phi_1322_;
                if (_e748 > 0i) {
                    phi_1327_ = _e748;
                } else {
                    phi_1327_ = 0i;
                }
                let _e778 = phi_1327_;
                if (_e775 < _e772) {
                    phi_1332_ = _e775;
                } else {
                    phi_1332_ = _e772;
                }
                let _e781 = phi_1332_;
                if (_e778 < _e772) {
                    phi_1337_ = _e778;
                } else {
                    phi_1337_ = _e772;
                }
                let _e784 = phi_1337_;
                let _e785 = bitcast<u32>(_e781);
                let _e787 = (_e739 + 1i);
                let _e788 = (_e748 + 1i);
                if (_e787 > 0i) {
                    phi_1346_ = _e787;
                } else {
                    phi_1346_ = 0i;
                }
                let _e791 = phi_1346_;
                if (_e788 > 0i) {
                    phi_1351_ = _e788;
                } else {
                    phi_1351_ = 0i;
                }
                let _e794 = phi_1351_;
                if (_e791 < _e772) {
                    phi_1356_ = _e791;
                } else {
                    phi_1356_ = _e772;
                }
                let _e797 = phi_1356_;
                if (_e794 < _e772) {
                    phi_1361_ = _e794;
                } else {
                    phi_1361_ = _e772;
                }
                let _e800 = phi_1361_;
                let _e801 = bitcast<u32>(_e797);
                let _e803 = (bitcast<u32>(_e784) * _e761);
                let _e804 = (bitcast<u32>(_e800) * _e761);
                let _e809 = ((_e803 + _e785) + _e770);
                let _e810 = ((_e803 + _e801) + _e770);
                let _e811 = ((_e804 + _e785) + _e770);
                let _e812 = ((_e804 + _e801) + _e770);
                if (_e809 < _e61) {
                } else {
                    return;
                }
                let _e816 = map.member[(0u + _e809)];
                if (_e810 < _e61) {
                } else {
                    return;
                }
                let _e828 = map.member[(0u + _e810)];
                if (_e811 < _e61) {
                } else {
                    return;
                }
                let _e844 = map.member[(0u + _e811)];
                if (_e812 < _e61) {
                } else {
                    return;
                }
                let _e860 = map.member[(0u + _e812)];
                let _e874 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e816.x * _e751) + (_e828.x * _e753)) + (_e844.x * _e755)) + (_e860.x * _e756)), ((((_e816.y * _e751) + (_e828.y * _e753)) + (_e844.y * _e755)) + (_e860.y * _e756)), ((((_e816.z * _e751) + (_e828.z * _e753)) + (_e844.z * _e755)) + (_e860.z * _e756)), ((((_e816.w * _e751) + (_e828.w * _e753)) + (_e844.w * _e755)) + (_e860.w * _e756))), _e665);
                let _e876 = p.member.fade_uv;
                if (_e876 > 0f) {
                    let _e879 = local_4;
                    if ((_e879.level + 1u) == _e79) {
                        let _e888 = p.member.fade_uv;
                        let _e890 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e431.point.uv.x, (1f - _e431.point.uv.x));
                        let _e892 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e431.point.uv.y, (1f - _e431.point.uv.y));
                        let _e893 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e890, _e892);
                        if (_e893 < _e888) {
                            phi_1477_ = (1f - ((1f - _e874) * (_e893 / _e888)));
                        } else {
                            phi_1477_ = _e874;
                        }
                        let _e900 = phi_1477_;
                        phi_1479_ = evaluate_Verdict(_e900, false);
                        phi_1480_ = false;
                    } else {
                        phi_1479_ = evaluate_Verdict();
                        phi_1480_ = true;
                    }
                    let _e903 = phi_1479_;
                    let _e905 = phi_1480_;
                    phi_1481_ = _e903;
                    phi_1482_ = _e905;
                } else {
                    phi_1481_ = evaluate_Verdict();
                    phi_1482_ = true;
                }
                let _e907 = phi_1481_;
                let _e909 = phi_1482_;
                if _e909 {
                    phi_1487_ = evaluate_Verdict(_e874, false);
                    phi_1488_ = false;
                } else {
                    phi_1487_ = evaluate_Verdict();
                    phi_1488_ = true;
                }
                let _e912 = phi_1487_;
                let _e914 = phi_1488_;
                phi_1490_ = _e912;
                phi_1491_ = _e907;
                phi_1492_ = _e914;
            } else {
                phi_1490_ = evaluate_Verdict();
                phi_1491_ = evaluate_Verdict(1f, false);
                phi_1492_ = true;
            }
            let _e917 = phi_1490_;
            let _e919 = phi_1491_;
            let _e921 = phi_1492_;
            if _e921 {
            }
            phi_1496_ = _e919;
            phi_1497_ = _e917;
            phi_1498_ = _e921;
        }
        let _e923 = phi_1496_;
        let _e925 = phi_1497_;
        let _e927 = phi_1498_;
        if _e927 {
            phi_1502_ = _e923;
        } else {
            phi_1502_ = _e925;
        }
        let _e929 = phi_1502_;
        if (_e73.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.first_primitive)] = _e929.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
