struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct type_9 {
    member: array<u32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_19 {
    member: array<abi_Sample>,
}

struct type_23 {
    member: array<f32>,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct type_35 {
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

struct type_39 {
    member: abi_ShadowParams,
}

struct type_43 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_19;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_39;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_23;
@group(0) @binding(4) 
var<storage> marks: type_9;
@group(0) @binding(5) 
var<storage> levels: type_43;
@group(0) @binding(2) 
var<storage> map: type_35;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_184_: lt_bvh_traverse_Tree;
    var phi_185_: bool;
    var phi_186_: lt_bvh_traverse_Tree;
    var phi_187_: bool;
    var phi_192_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_184_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_185_ = false;
        } else {
            phi_184_ = lt_bvh_traverse_Tree();
            phi_185_ = true;
        }
        let _e72 = phi_184_;
        let _e74 = phi_185_;
        phi_186_ = _e72;
        phi_187_ = _e74;
    } else {
        phi_186_ = lt_bvh_traverse_Tree();
        phi_187_ = true;
    }
    let _e76 = phi_186_;
    let _e78 = phi_187_;
    if _e78 {
        phi_192_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_192_ = _e76;
    }
    let _e83 = phi_192_;
    return lt_bvh_traverse_Tree(_e83.root, _e83.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_219_: f32;
    var phi_220_: f32;
    var phi_221_: f32;
    var phi_234_: bool;
    var phi_238_: f32;
    var phi_250_: f32;
    var phi_255_: f32;
    var phi_277_: f32;
    var phi_282_: f32;
    var phi_283_: bool;
    var phi_284_: f32;
    var phi_285_: bool;
    var phi_289_: f32;
    var phi_327_: f32;
    var phi_340_: bool;
    var phi_344_: f32;
    var phi_357_: f32;
    var phi_362_: f32;
    var phi_384_: f32;
    var phi_389_: f32;
    var phi_390_: bool;
    var phi_391_: f32;
    var phi_392_: bool;
    var phi_396_: f32;
    var phi_434_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_221_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_220_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_219_ = 1f;
            } else {
                phi_219_ = param_5;
            }
            let _e67 = phi_219_;
            phi_220_ = _e67;
        }
        let _e69 = phi_220_;
        phi_221_ = _e69;
    }
    let _e71 = phi_221_;
    let _e73 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_234_ = true;
    } else {
        let _e77 = (42f < _e73);
        if _e77 {
        }
        phi_234_ = _e77;
    }
    let _e79 = phi_234_;
    if _e79 {
        phi_238_ = 42f;
    } else {
        phi_238_ = _e73;
    }
    let _e81 = phi_238_;
    let _e82 = (_e81 * _e71);
    if ((bitcast<u32>(_e82) & 2147483647u) > 2139095040u) {
        phi_327_ = _e82;
    } else {
        if (_e82 < -87f) {
            phi_250_ = -87f;
        } else {
            phi_250_ = _e82;
        }
        let _e88 = phi_250_;
        if (_e88 > 88f) {
            phi_255_ = 88f;
        } else {
            phi_255_ = _e88;
        }
        let _e91 = phi_255_;
        let _e93 = ((_e91 * 1.442695f) + 0.5f);
        if (_e93 > -8388608f) {
            let _e105 = f32(select(0i, select(select(i32(_e93), i32(-2147483648), (_e93 < bitcast<f32>(3472883712u))), 2147483647i, (_e93 > bitcast<f32>(1325400063u))), (_e93 == _e93)));
            if (_e105 > _e93) {
                phi_277_ = 1f;
            } else {
                phi_277_ = 0f;
            }
            let _e108 = phi_277_;
            if (_e93 < 8388608f) {
                phi_282_ = (_e105 - _e108);
                phi_283_ = false;
            } else {
                phi_282_ = f32();
                phi_283_ = true;
            }
            let _e111 = phi_282_;
            let _e113 = phi_283_;
            phi_284_ = _e111;
            phi_285_ = _e113;
        } else {
            phi_284_ = f32();
            phi_285_ = true;
        }
        let _e115 = phi_284_;
        let _e117 = phi_285_;
        if _e117 {
            phi_289_ = _e93;
        } else {
            phi_289_ = _e115;
        }
        let _e119 = phi_289_;
        let _e123 = ((_e91 - (_e119 * 0.69314575f)) - (_e119 * 0.0000014286068f));
        phi_327_ = ((((((((((((((((1f / 5040f) * _e123) + (1f / 720f)) * _e123) + (1f / 120f)) * _e123) + (1f / 24f)) * _e123) + (1f / 6f)) * _e123) + 0.5f) * _e123) + 1f) * _e123) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e119), i32(-2147483648), (_e119 < bitcast<f32>(3472883712u))), 2147483647i, (_e119 > bitcast<f32>(1325400063u))), (_e119 == _e119)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e159 = phi_327_;
    let _e161 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_340_ = true;
    } else {
        let _e165 = (42f < _e161);
        if _e165 {
        }
        phi_340_ = _e165;
    }
    let _e167 = phi_340_;
    if _e167 {
        phi_344_ = 42f;
    } else {
        phi_344_ = _e161;
    }
    let _e169 = phi_344_;
    let _e171 = (-(_e169) * _e71);
    if ((bitcast<u32>(_e171) & 2147483647u) > 2139095040u) {
        phi_434_ = _e171;
    } else {
        if (_e171 < -87f) {
            phi_357_ = -87f;
        } else {
            phi_357_ = _e171;
        }
        let _e177 = phi_357_;
        if (_e177 > 88f) {
            phi_362_ = 88f;
        } else {
            phi_362_ = _e177;
        }
        let _e180 = phi_362_;
        let _e182 = ((_e180 * 1.442695f) + 0.5f);
        if (_e182 > -8388608f) {
            let _e194 = f32(select(0i, select(select(i32(_e182), i32(-2147483648), (_e182 < bitcast<f32>(3472883712u))), 2147483647i, (_e182 > bitcast<f32>(1325400063u))), (_e182 == _e182)));
            if (_e194 > _e182) {
                phi_384_ = 1f;
            } else {
                phi_384_ = 0f;
            }
            let _e197 = phi_384_;
            if (_e182 < 8388608f) {
                phi_389_ = (_e194 - _e197);
                phi_390_ = false;
            } else {
                phi_389_ = f32();
                phi_390_ = true;
            }
            let _e200 = phi_389_;
            let _e202 = phi_390_;
            phi_391_ = _e200;
            phi_392_ = _e202;
        } else {
            phi_391_ = f32();
            phi_392_ = true;
        }
        let _e204 = phi_391_;
        let _e206 = phi_392_;
        if _e206 {
            phi_396_ = _e182;
        } else {
            phi_396_ = _e204;
        }
        let _e208 = phi_396_;
        let _e212 = ((_e180 - (_e208 * 0.69314575f)) - (_e208 * 0.0000014286068f));
        phi_434_ = ((((((((((((((((1f / 5040f) * _e212) + (1f / 720f)) * _e212) + (1f / 120f)) * _e212) + (1f / 24f)) * _e212) + (1f / 6f)) * _e212) + 0.5f) * _e212) + 1f) * _e212) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e208), i32(-2147483648), (_e208 < bitcast<f32>(3472883712u))), 2147483647i, (_e208 > bitcast<f32>(1325400063u))), (_e208 == _e208)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e248 = phi_434_;
    let _e249 = -(_e248);
    return vec4<f32>(_e159, (_e159 * _e159), _e249, (_e249 * _e249));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_456_: bool;
    var phi_460_: f32;
    var phi_484_: bool;
    var phi_488_: f32;
    var phi_500_: bool;
    var phi_507_: f32;
    var phi_520_: bool;
    var phi_524_: f32;
    var phi_548_: bool;
    var phi_552_: f32;
    var phi_564_: bool;
    var phi_571_: f32;
    var phi_582_: bool;
    var phi_586_: f32;
    var phi_601_: f32;
    var phi_602_: f32;
    var phi_603_: f32;

    let _e62 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e64 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_456_ = true;
    } else {
        let _e68 = (42f < _e64);
        if _e68 {
        }
        phi_456_ = _e68;
    }
    let _e70 = phi_456_;
    if _e70 {
        phi_460_ = 42f;
    } else {
        phi_460_ = _e64;
    }
    let _e72 = phi_460_;
    let _e74 = (*param_6).min_variance;
    let _e78 = (((_e74 * _e72) * _e72) * _e62.y);
    let _e85 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e78) & 2147483647u) > 2139095040u) {
        phi_484_ = true;
    } else {
        let _e89 = (_e78 > _e85);
        if _e89 {
        }
        phi_484_ = _e89;
    }
    let _e91 = phi_484_;
    if _e91 {
        phi_488_ = _e78;
    } else {
        phi_488_ = _e85;
    }
    let _e93 = phi_488_;
    let _e94 = (_e62.x - param_7.x);
    if (_e94 <= 0f) {
        let _e98 = ((bitcast<u32>(_e93) & 2147483647u) > 2139095040u);
        if _e98 {
        }
        phi_500_ = _e98;
    } else {
        phi_500_ = true;
    }
    let _e100 = phi_500_;
    if _e100 {
        phi_507_ = (_e93 / (_e93 + (_e94 * _e94)));
    } else {
        phi_507_ = 1f;
    }
    let _e105 = phi_507_;
    let _e107 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_520_ = true;
    } else {
        let _e111 = (42f < _e107);
        if _e111 {
        }
        phi_520_ = _e111;
    }
    let _e113 = phi_520_;
    if _e113 {
        phi_524_ = 42f;
    } else {
        phi_524_ = _e107;
    }
    let _e115 = phi_524_;
    let _e117 = (*param_6).min_variance;
    let _e121 = (((_e117 * _e115) * _e115) * _e62.w);
    let _e128 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_548_ = true;
    } else {
        let _e132 = (_e121 > _e128);
        if _e132 {
        }
        phi_548_ = _e132;
    }
    let _e134 = phi_548_;
    if _e134 {
        phi_552_ = _e121;
    } else {
        phi_552_ = _e128;
    }
    let _e136 = phi_552_;
    let _e137 = (_e62.z - param_7.z);
    if (_e137 <= 0f) {
        let _e141 = ((bitcast<u32>(_e136) & 2147483647u) > 2139095040u);
        if _e141 {
        }
        phi_564_ = _e141;
    } else {
        phi_564_ = true;
    }
    let _e143 = phi_564_;
    if _e143 {
        phi_571_ = (_e136 / (_e136 + (_e137 * _e137)));
    } else {
        phi_571_ = 1f;
    }
    let _e148 = phi_571_;
    if ((bitcast<u32>(_e148) & 2147483647u) > 2139095040u) {
        phi_582_ = true;
    } else {
        let _e152 = (_e148 < _e105);
        if _e152 {
        }
        phi_582_ = _e152;
    }
    let _e154 = phi_582_;
    if _e154 {
        phi_586_ = _e148;
    } else {
        phi_586_ = _e105;
    }
    let _e156 = phi_586_;
    if ((bitcast<u32>(_e156) & 2147483647u) > 2139095040u) {
        phi_603_ = _e156;
    } else {
        if (_e156 < 0f) {
            phi_602_ = 0f;
        } else {
            if (_e156 > 1f) {
                phi_601_ = 1f;
            } else {
                phi_601_ = _e156;
            }
            let _e163 = phi_601_;
            phi_602_ = _e163;
        }
        let _e165 = phi_602_;
        phi_603_ = _e165;
    }
    let _e167 = phi_603_;
    return _e167;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_676_: bool;
    var phi_746_: bool;
    var phi_747_: bool;
    var phi_758_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_759_: bool;
    var phi_760_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_761_: bool;
    var phi_768_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_772_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_792_: lt_math_LightPoint;
    var phi_795_: u32;
    var phi_797_: lt_math_LevelPoint;
    var phi_883_: bool;
    var phi_892_: bool;
    var phi_901_: bool;
    var phi_902_: bool;
    var phi_903_: bool;
    var phi_904_: bool;
    var phi_905_: bool;
    var phi_906_: bool;
    var phi_907_: bool;
    var phi_911_: bool;
    var phi_938_: bool;
    var phi_939_: bool;
    var phi_940_: bool;
    var phi_941_: bool;
    var phi_942_: bool;
    var phi_943_: bool;
    var phi_944_: bool;
    var phi_945_: bool;
    var phi_949_: bool;
    var phi_958_: lt_math_LightPoint;
    var phi_959_: u32;
    var phi_960_: lt_math_LevelPoint;
    var phi_961_: bool;
    var phi_793_: lt_math_LightPoint;
    var phi_796_: u32;
    var phi_798_: lt_math_LevelPoint;
    var phi_962_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1002_: bool;
    var phi_1003_: bool;
    var phi_1004_: bool;
    var phi_1005_: bool;
    var phi_1009_: bool;
    var phi_1091_: f32;
    var phi_1209_: f32;
    var phi_1210_: f32;
    var phi_1213_: f32;
    var phi_1242_: f32;
    var phi_1247_: f32;
    var phi_1248_: bool;
    var phi_1249_: f32;
    var phi_1250_: bool;
    var phi_1254_: f32;
    var phi_1274_: f32;
    var phi_1279_: f32;
    var phi_1280_: bool;
    var phi_1281_: f32;
    var phi_1282_: bool;
    var phi_1286_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1341_: i32;
    var phi_1346_: i32;
    var phi_1351_: i32;
    var phi_1356_: i32;
    var phi_1365_: i32;
    var phi_1370_: i32;
    var phi_1375_: i32;
    var phi_1380_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1480_: i32;
    var phi_1485_: i32;
    var phi_1490_: i32;
    var phi_1495_: i32;
    var phi_1514_: i32;
    var phi_1519_: i32;
    var phi_1524_: i32;
    var phi_1529_: i32;
    var phi_1548_: i32;
    var phi_1553_: i32;
    var phi_1558_: i32;
    var phi_1563_: i32;
    var phi_1582_: i32;
    var phi_1587_: i32;
    var phi_1592_: i32;
    var phi_1597_: i32;
    var phi_1675_: bool;
    var phi_1683_: bool;
    var phi_1695_: bool;
    var phi_1696_: bool;
    var phi_1700_: f32;
    var phi_1706_: f32;
    var phi_1708_: evaluate_Verdict;
    var phi_1718_: u32;
    var phi_1727_: f32;
    var phi_1729_: evaluate_Verdict;
    var phi_1730_: bool;
    var phi_1731_: evaluate_Verdict;
    var phi_1732_: bool;
    var phi_1737_: evaluate_Verdict;
    var phi_1742_: evaluate_Verdict;
    var phi_1743_: evaluate_Verdict;

    let _e60 = id_1;
    let _e67 = arrayLength((&map.member));
    let _e73 = arrayLength((&marks.member));
    let _e76 = arrayLength((&levels.member));
    let _e79 = p.member.size[0u];
    let _e81 = p.member.size[1u];
    let _e82 = lt_shaders_entry_pixel_index(_e60, _e79, _e81);
    if (bitcast<i32>(_e82.root) != 0i) {
        let _e88 = p.member.level_count;
        if (_e82.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e95 = samples.member[(0u + _e82.first_primitive)].normal[0u];
        let _e97 = global[0u];
        if (_e95 == _e97) {
            let _e100 = samples.member[(0u + _e82.first_primitive)].normal[1u];
            let _e102 = global[1u];
            if (_e100 == _e102) {
                let _e105 = samples.member[(0u + _e82.first_primitive)].normal[2u];
                let _e107 = global[2u];
                phi_669_ = (_e105 == _e107);
                phi_670_ = false;
            } else {
                phi_669_ = bool();
                phi_670_ = true;
            }
            let _e110 = phi_669_;
            let _e112 = phi_670_;
            phi_671_ = _e110;
            phi_672_ = _e112;
        } else {
            phi_671_ = bool();
            phi_672_ = true;
        }
        let _e114 = phi_671_;
        let _e116 = phi_672_;
        if _e116 {
            phi_676_ = false;
        } else {
            phi_676_ = _e114;
        }
        let _e118 = phi_676_;
        if !(_e118) {
            let _e121 = samples.member[(0u + _e82.first_primitive)].position;
            let _e123 = p.member.light.place;
            let _e129 = p.member.light.place[3u];
            let _e136 = (_e123.x - (_e121.x * _e129));
            let _e137 = (_e123.y - (_e121.y * _e129));
            let _e138 = (_e123.z - (_e121.z * _e129));
            let _e140 = samples.member[(0u + _e82.first_primitive)].normal;
            if ((((_e140.x * _e136) + (_e140.y * _e137)) + (_e140.z * _e138)) > 0f) {
                let _e154 = (((_e136 * _e136) + (_e137 * _e137)) + (_e138 * _e138));
                let _e156 = p.member.light.axis;
                let _e168 = p.member.light.place[3u];
                if (_e168 == 0f) {
                    phi_747_ = true;
                } else {
                    let _e171 = p.member.light.range_squared;
                    if (_e154 <= _e171) {
                        let _e174 = p.member.light.cos_outer;
                        phi_746_ = (-((((_e136 * _e156.x) + (_e137 * _e156.y)) + (_e138 * _e156.z))) >= (_e174 * sqrt(_e154)));
                    } else {
                        phi_746_ = false;
                    }
                    let _e179 = phi_746_;
                    phi_747_ = _e179;
                }
                let _e181 = phi_747_;
                if _e181 {
                    let _e183 = samples.member[(0u + _e82.first_primitive)].flags;
                    let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                    phi_758_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, ((_e183 & 1u) == 0u));
                    phi_759_ = false;
                } else {
                    phi_758_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_759_ = true;
                }
                let _e202 = phi_758_;
                let _e204 = phi_759_;
                phi_760_ = _e202;
                phi_761_ = _e204;
            } else {
                phi_760_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_761_ = true;
            }
            let _e206 = phi_760_;
            let _e208 = phi_761_;
            if _e208 {
                let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e214.unnamed.visibility, false), _e214.unnamed_1);
                phi_768_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e220.unnamed, true);
            } else {
                phi_768_ = _e206;
            }
            let _e225 = phi_768_;
            phi_772_ = _e225;
        } else {
            let _e231 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e237 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e231.unnamed.visibility, false), _e231.unnamed_1);
            phi_772_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e237.unnamed, true);
        }
        let _e242 = phi_772_;
        if _e242.unnamed_1 {
            phi_1743_ = evaluate_Verdict(_e242.unnamed.visibility, _e242.unnamed.is_doubted);
        } else {
            let _e250 = samples.member[(0u + _e82.first_primitive)].position;
            let _e252 = p.member.map_size;
            let _e254 = (0.5f / f32(_e252));
            let _e261 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e268 = lt_math_LightPoint(vec2<f32>(_e261.uv.x, 0f), _e261.depth, _e261.is_inside);
            let _e272 = lt_math_LightPoint(_e268.uv, 0f, _e268.is_inside);
            phi_792_ = lt_math_LightPoint();
            phi_795_ = 0u;
            phi_797_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e272.uv, _e272.depth, false));
            loop {
                let _e279 = phi_792_;
                let _e281 = phi_795_;
                let _e283 = phi_797_;
                local_1 = _e283;
                local_2 = _e283;
                local_3 = _e283;
                local_4 = _e283;
                if (_e281 < _e88) {
                    if _e283.point.is_inside {
                        phi_958_ = lt_math_LightPoint();
                        phi_959_ = u32();
                        phi_960_ = lt_math_LevelPoint();
                        phi_961_ = false;
                    } else {
                        if (_e281 < _e76) {
                        } else {
                            return;
                        }
                        let _e294 = levels.member[(0u + _e281)].row_w;
                        let _e305 = ((((_e294.x * _e250.x) + (_e294.y * _e250.y)) + (_e294.z * _e250.z)) + (_e294.w * 1f));
                        let _e307 = levels.member[(0u + _e281)].row_x;
                        let _e319 = (((((_e307.x * _e250.x) + (_e307.y * _e250.y)) + (_e307.z * _e250.z)) + (_e307.w * 1f)) / _e305);
                        let _e321 = levels.member[(0u + _e281)].row_y;
                        let _e333 = (((((_e321.x * _e250.x) + (_e321.y * _e250.y)) + (_e321.z * _e250.z)) + (_e321.w * 1f)) / _e305);
                        let _e335 = levels.member[(0u + _e281)].row_z;
                        let _e346 = ((((_e335.x * _e250.x) + (_e335.y * _e250.y)) + (_e335.z * _e250.z)) + (_e335.w * 1f));
                        if (_e305 > 0f) {
                            if (_e319 >= 0f) {
                                phi_883_ = (_e319 <= 1f);
                            } else {
                                phi_883_ = false;
                            }
                            let _e351 = phi_883_;
                            if _e351 {
                                if (_e333 >= 0f) {
                                    phi_892_ = (_e333 <= 1f);
                                } else {
                                    phi_892_ = false;
                                }
                                let _e355 = phi_892_;
                                if _e355 {
                                    if (_e346 >= 0f) {
                                        phi_901_ = (_e346 <= 1f);
                                    } else {
                                        phi_901_ = false;
                                    }
                                    let _e359 = phi_901_;
                                    phi_902_ = _e359;
                                    phi_903_ = false;
                                } else {
                                    phi_902_ = bool();
                                    phi_903_ = true;
                                }
                                let _e361 = phi_902_;
                                let _e363 = phi_903_;
                                phi_904_ = _e361;
                                phi_905_ = _e363;
                            } else {
                                phi_904_ = bool();
                                phi_905_ = true;
                            }
                            let _e365 = phi_904_;
                            let _e367 = phi_905_;
                            phi_906_ = _e365;
                            phi_907_ = _e367;
                        } else {
                            phi_906_ = bool();
                            phi_907_ = true;
                        }
                        let _e369 = phi_906_;
                        let _e371 = phi_907_;
                        if _e371 {
                            phi_911_ = false;
                        } else {
                            phi_911_ = _e369;
                        }
                        let _e373 = phi_911_;
                        if _e373 {
                            if (_e319 >= _e254) {
                                if (_e319 <= (1f - _e254)) {
                                    if (_e333 >= _e254) {
                                        phi_938_ = (_e333 <= (1f - _e254));
                                        phi_939_ = false;
                                    } else {
                                        phi_938_ = bool();
                                        phi_939_ = true;
                                    }
                                    let _e381 = phi_938_;
                                    let _e383 = phi_939_;
                                    phi_940_ = _e381;
                                    phi_941_ = _e383;
                                } else {
                                    phi_940_ = bool();
                                    phi_941_ = true;
                                }
                                let _e385 = phi_940_;
                                let _e387 = phi_941_;
                                phi_942_ = _e385;
                                phi_943_ = _e387;
                            } else {
                                phi_942_ = bool();
                                phi_943_ = true;
                            }
                            let _e389 = phi_942_;
                            let _e391 = phi_943_;
                            phi_944_ = _e389;
                            phi_945_ = _e391;
                        } else {
                            phi_944_ = bool();
                            phi_945_ = true;
                        }
                        let _e393 = phi_944_;
                        let _e395 = phi_945_;
                        if _e395 {
                            phi_949_ = false;
                        } else {
                            phi_949_ = _e393;
                        }
                        let _e397 = phi_949_;
                        let _e404 = lt_math_LightPoint(vec2<f32>(_e319, _e279.uv.y), _e279.depth, _e279.is_inside);
                        let _e411 = lt_math_LightPoint(vec2<f32>(_e404.uv.x, _e333), _e404.depth, _e404.is_inside);
                        let _e415 = lt_math_LightPoint(_e411.uv, _e346, _e411.is_inside);
                        let _e419 = lt_math_LightPoint(_e415.uv, _e415.depth, _e397);
                        phi_958_ = _e419;
                        phi_959_ = (_e281 + 1u);
                        phi_960_ = lt_math_LevelPoint(_e281, _e419);
                        phi_961_ = true;
                    }
                    let _e423 = phi_958_;
                    let _e425 = phi_959_;
                    let _e427 = phi_960_;
                    let _e429 = phi_961_;
                    phi_793_ = _e423;
                    phi_796_ = _e425;
                    phi_798_ = _e427;
                    phi_962_ = _e429;
                } else {
                    phi_793_ = lt_math_LightPoint();
                    phi_796_ = u32();
                    phi_798_ = lt_math_LevelPoint();
                    phi_962_ = false;
                }
                let _e431 = phi_793_;
                let _e433 = phi_796_;
                let _e435 = phi_798_;
                let _e437 = phi_962_;
                continue;
                continuing {
                    phi_792_ = _e431;
                    phi_795_ = _e433;
                    phi_797_ = _e435;
                    break if !(_e437);
                }
            }
            let _e440 = local_1;
            if _e440.point.is_inside {
                if (0f > 0f) {
                    let _e446 = local_2;
                    if (_e446.level < _e76) {
                    } else {
                        return;
                    }
                    let _e451 = levels.member[(0u + _e446.level)];
                    let _e457 = global[0u];
                    if (_e451.row_w.x == _e457) {
                        let _e460 = global[1u];
                        if (_e451.row_w.y == _e460) {
                            let _e463 = global[2u];
                            phi_1002_ = (_e451.row_w.z == _e463);
                            phi_1003_ = false;
                        } else {
                            phi_1002_ = bool();
                            phi_1003_ = true;
                        }
                        let _e466 = phi_1002_;
                        let _e468 = phi_1003_;
                        phi_1004_ = _e466;
                        phi_1005_ = _e468;
                    } else {
                        phi_1004_ = bool();
                        phi_1005_ = true;
                    }
                    let _e470 = phi_1004_;
                    let _e472 = phi_1005_;
                    if _e472 {
                        phi_1009_ = false;
                    } else {
                        phi_1009_ = _e470;
                    }
                    let _e474 = phi_1009_;
                    if _e474 {
                        let _e476 = samples.member[(0u + _e82.first_primitive)].normal;
                        let _e478 = p.member.map_size;
                        let _e548 = ((abs(((((_e451.row_x.x * _e476.x) + (_e451.row_x.y * _e476.y)) + (_e451.row_x.z * _e476.z)) / (((_e451.row_x.x * _e451.row_x.x) + (_e451.row_x.y * _e451.row_x.y)) + (_e451.row_x.z * _e451.row_x.z)))) + abs(((((_e451.row_y.x * _e476.x) + (_e451.row_y.y * _e476.y)) + (_e451.row_y.z * _e476.z)) / (((_e451.row_y.x * _e451.row_y.x) + (_e451.row_y.y * _e451.row_y.y)) + (_e451.row_y.z * _e451.row_y.z))))) / (abs(((((_e451.row_z.x * _e476.x) + (_e451.row_z.y * _e476.y)) + (_e451.row_z.z * _e476.z)) / (((_e451.row_z.x * _e451.row_z.x) + (_e451.row_z.y * _e451.row_z.y)) + (_e451.row_z.z * _e451.row_z.z)))) * f32(_e478)));
                        if (_e548 < 0.002f) {
                            phi_1091_ = _e548;
                        } else {
                            phi_1091_ = 0.002f;
                        }
                        let _e551 = phi_1091_;
                        phi_1210_ = _e551;
                    } else {
                        let _e553 = p.member.map_size;
                        let _e559 = samples.member[(0u + _e82.first_primitive)].position;
                        let _e570 = ((((_e451.row_w.x * _e559.x) + (_e451.row_w.y * _e559.y)) + (_e451.row_w.z * _e559.z)) + _e451.row_w.w);
                        let _e583 = ((_e451.row_x.x - (_e451.row_w.x * _e440.point.uv.x)) / _e570);
                        let _e584 = ((_e451.row_x.y - (_e451.row_w.y * _e440.point.uv.x)) / _e570);
                        let _e585 = ((_e451.row_x.z - (_e451.row_w.z * _e440.point.uv.x)) / _e570);
                        let _e598 = ((_e451.row_y.x - (_e451.row_w.x * _e440.point.uv.y)) / _e570);
                        let _e599 = ((_e451.row_y.y - (_e451.row_w.y * _e440.point.uv.y)) / _e570);
                        let _e600 = ((_e451.row_y.z - (_e451.row_w.z * _e440.point.uv.y)) / _e570);
                        let _e606 = samples.member[(0u + _e82.first_primitive)].normal;
                        let _e611 = ((_e599 * _e606.z) - (_e606.y * _e600));
                        let _e616 = ((_e600 * _e606.x) - (_e606.z * _e598));
                        let _e621 = ((_e598 * _e606.y) - (_e606.x * _e599));
                        let _e623 = samples.member[(0u + _e82.first_primitive)].normal;
                        let _e628 = ((_e584 * _e623.z) - (_e623.y * _e585));
                        let _e633 = ((_e585 * _e623.x) - (_e623.z * _e583));
                        let _e638 = ((_e583 * _e623.y) - (_e623.x * _e584));
                        let _e665 = ((abs(((((_e451.row_z.x * _e611) + (_e451.row_z.y * _e616)) + (_e451.row_z.z * _e621)) / (((_e583 * _e611) + (_e584 * _e616)) + (_e585 * _e621)))) + abs(((((_e451.row_z.x * _e628) + (_e451.row_z.y * _e633)) + (_e451.row_z.z * _e638)) / (((_e598 * _e628) + (_e599 * _e633)) + (_e600 * _e638))))) / f32(_e553));
                        let _e667 = (16f / f32(_e553));
                        if (_e665 < _e667) {
                            phi_1209_ = _e665;
                        } else {
                            phi_1209_ = _e667;
                        }
                        let _e670 = phi_1209_;
                        phi_1210_ = _e670;
                    }
                    let _e672 = phi_1210_;
                    phi_1213_ = (_e440.point.depth - (0f * _e672));
                } else {
                    phi_1213_ = _e440.point.depth;
                }
                let _e676 = phi_1213_;
                let _e682 = p.member.map_size;
                let _e683 = f32(_e682);
                let _e686 = ((_e440.point.uv.x * _e683) - 0.5f);
                let _e687 = ((_e440.point.uv.y * _e683) - 0.5f);
                if (_e686 > -8388608f) {
                    let _e699 = f32(select(0i, select(select(i32(_e686), i32(-2147483648), (_e686 < bitcast<f32>(3472883712u))), 2147483647i, (_e686 > bitcast<f32>(1325400063u))), (_e686 == _e686)));
                    if (_e699 > _e686) {
                        phi_1242_ = 1f;
                    } else {
                        phi_1242_ = 0f;
                    }
                    let _e702 = phi_1242_;
                    if (_e686 < 8388608f) {
                        phi_1247_ = (_e699 - _e702);
                        phi_1248_ = false;
                    } else {
                        phi_1247_ = f32();
                        phi_1248_ = true;
                    }
                    let _e705 = phi_1247_;
                    let _e707 = phi_1248_;
                    phi_1249_ = _e705;
                    phi_1250_ = _e707;
                } else {
                    phi_1249_ = f32();
                    phi_1250_ = true;
                }
                let _e709 = phi_1249_;
                let _e711 = phi_1250_;
                if _e711 {
                    phi_1254_ = _e686;
                } else {
                    phi_1254_ = _e709;
                }
                let _e713 = phi_1254_;
                if (_e687 > -8388608f) {
                    let _e725 = f32(select(0i, select(select(i32(_e687), i32(-2147483648), (_e687 < bitcast<f32>(3472883712u))), 2147483647i, (_e687 > bitcast<f32>(1325400063u))), (_e687 == _e687)));
                    if (_e725 > _e687) {
                        phi_1274_ = 1f;
                    } else {
                        phi_1274_ = 0f;
                    }
                    let _e728 = phi_1274_;
                    if (_e687 < 8388608f) {
                        phi_1279_ = (_e725 - _e728);
                        phi_1280_ = false;
                    } else {
                        phi_1279_ = f32();
                        phi_1280_ = true;
                    }
                    let _e731 = phi_1279_;
                    let _e733 = phi_1280_;
                    phi_1281_ = _e731;
                    phi_1282_ = _e733;
                } else {
                    phi_1281_ = f32();
                    phi_1282_ = true;
                }
                let _e735 = phi_1281_;
                let _e737 = phi_1282_;
                if _e737 {
                    phi_1286_ = _e687;
                } else {
                    phi_1286_ = _e735;
                }
                let _e739 = phi_1286_;
                let _e740 = (_e686 - _e713);
                let _e741 = (_e687 - _e739);
                let _e750 = select(0i, select(select(i32(_e713), i32(-2147483648), (_e713 < bitcast<f32>(3472883712u))), 2147483647i, (_e713 > bitcast<f32>(1325400063u))), (_e713 == _e713));
                let _e759 = select(0i, select(select(i32(_e739), i32(-2147483648), (_e739 < bitcast<f32>(3472883712u))), 2147483647i, (_e739 > bitcast<f32>(1325400063u))), (_e739 == _e739));
                let _e762 = ((1f - _e740) * (1f - _e741));
                let _e764 = (_e740 * (1f - _e741));
                let _e766 = ((1f - _e740) * _e741);
                let _e767 = (_e740 * _e741);
                let _e769 = p.member.test;
                let _e770 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e769);
                let _e772 = p.member.map_size;
                let _e774 = local_3;
                local = lt_math_Evsm(_e770.positive_exponent, _e770.negative_exponent, _e770.min_variance);
                let _e781 = ((_e774.level * _e772) * _e772);
                let _e783 = (bitcast<i32>(_e772) - 1i);
                if (_e750 > 0i) {
                    phi_1341_ = _e750;
                } else {
                    phi_1341_ = 0i;
                }
                let _e786 = phi_1341_;
                if (_e759 > 0i) {
                    phi_1346_ = _e759;
                } else {
                    phi_1346_ = 0i;
                }
                let _e789 = phi_1346_;
                if (_e786 < _e783) {
                    phi_1351_ = _e786;
                } else {
                    phi_1351_ = _e783;
                }
                let _e792 = phi_1351_;
                if (_e789 < _e783) {
                    phi_1356_ = _e789;
                } else {
                    phi_1356_ = _e783;
                }
                let _e795 = phi_1356_;
                let _e796 = bitcast<u32>(_e792);
                let _e798 = (_e750 + 1i);
                let _e799 = (_e759 + 1i);
                if (_e798 > 0i) {
                    phi_1365_ = _e798;
                } else {
                    phi_1365_ = 0i;
                }
                let _e802 = phi_1365_;
                if (_e799 > 0i) {
                    phi_1370_ = _e799;
                } else {
                    phi_1370_ = 0i;
                }
                let _e805 = phi_1370_;
                if (_e802 < _e783) {
                    phi_1375_ = _e802;
                } else {
                    phi_1375_ = _e783;
                }
                let _e808 = phi_1375_;
                if (_e805 < _e783) {
                    phi_1380_ = _e805;
                } else {
                    phi_1380_ = _e783;
                }
                let _e811 = phi_1380_;
                let _e812 = bitcast<u32>(_e808);
                let _e814 = (bitcast<u32>(_e795) * _e772);
                let _e815 = (bitcast<u32>(_e811) * _e772);
                let _e820 = ((_e814 + _e796) + _e781);
                let _e821 = ((_e814 + _e812) + _e781);
                let _e822 = ((_e815 + _e796) + _e781);
                let _e823 = ((_e815 + _e812) + _e781);
                if (_e820 < _e67) {
                } else {
                    return;
                }
                let _e827 = map.member[(0u + _e820)];
                if (_e821 < _e67) {
                } else {
                    return;
                }
                let _e839 = map.member[(0u + _e821)];
                if (_e822 < _e67) {
                } else {
                    return;
                }
                let _e855 = map.member[(0u + _e822)];
                if (_e823 < _e67) {
                } else {
                    return;
                }
                let _e871 = map.member[(0u + _e823)];
                let _e885 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e827.x * _e762) + (_e839.x * _e764)) + (_e855.x * _e766)) + (_e871.x * _e767)), ((((_e827.y * _e762) + (_e839.y * _e764)) + (_e855.y * _e766)) + (_e871.y * _e767)), ((((_e827.z * _e762) + (_e839.z * _e764)) + (_e855.z * _e766)) + (_e871.z * _e767)), ((((_e827.w * _e762) + (_e839.w * _e764)) + (_e855.w * _e766)) + (_e871.w * _e767))), _e676);
                let _e887 = p.member.map_size;
                let _e889 = local_4;
                let _e892 = (bitcast<i32>(_e887) - 1i);
                if (_e750 > 0i) {
                    phi_1480_ = _e750;
                } else {
                    phi_1480_ = 0i;
                }
                let _e895 = phi_1480_;
                if (_e759 > 0i) {
                    phi_1485_ = _e759;
                } else {
                    phi_1485_ = 0i;
                }
                let _e898 = phi_1485_;
                if (_e895 < _e892) {
                    phi_1490_ = _e895;
                } else {
                    phi_1490_ = _e892;
                }
                let _e901 = phi_1490_;
                if (_e898 < _e892) {
                    phi_1495_ = _e898;
                } else {
                    phi_1495_ = _e892;
                }
                let _e904 = phi_1495_;
                let _e905 = bitcast<u32>(_e901);
                let _e912 = ((((_e889.level * _e887) + bitcast<u32>(_e904)) * (_e887 / 16u)) + (_e905 / 16u));
                let _e915 = (_e750 + 1i);
                let _e916 = (_e759 + 0i);
                let _e918 = (bitcast<i32>(_e887) - 1i);
                if (_e915 > 0i) {
                    phi_1514_ = _e915;
                } else {
                    phi_1514_ = 0i;
                }
                let _e921 = phi_1514_;
                if (_e916 > 0i) {
                    phi_1519_ = _e916;
                } else {
                    phi_1519_ = 0i;
                }
                let _e924 = phi_1519_;
                if (_e921 < _e918) {
                    phi_1524_ = _e921;
                } else {
                    phi_1524_ = _e918;
                }
                let _e927 = phi_1524_;
                if (_e924 < _e918) {
                    phi_1529_ = _e924;
                } else {
                    phi_1529_ = _e918;
                }
                let _e930 = phi_1529_;
                let _e931 = bitcast<u32>(_e927);
                let _e938 = ((((_e889.level * _e887) + bitcast<u32>(_e930)) * (_e887 / 16u)) + (_e931 / 16u));
                let _e941 = (_e750 + 0i);
                let _e942 = (_e759 + 1i);
                let _e944 = (bitcast<i32>(_e887) - 1i);
                if (_e941 > 0i) {
                    phi_1548_ = _e941;
                } else {
                    phi_1548_ = 0i;
                }
                let _e947 = phi_1548_;
                if (_e942 > 0i) {
                    phi_1553_ = _e942;
                } else {
                    phi_1553_ = 0i;
                }
                let _e950 = phi_1553_;
                if (_e947 < _e944) {
                    phi_1558_ = _e947;
                } else {
                    phi_1558_ = _e944;
                }
                let _e953 = phi_1558_;
                if (_e950 < _e944) {
                    phi_1563_ = _e950;
                } else {
                    phi_1563_ = _e944;
                }
                let _e956 = phi_1563_;
                let _e957 = bitcast<u32>(_e953);
                let _e964 = ((((_e889.level * _e887) + bitcast<u32>(_e956)) * (_e887 / 16u)) + (_e957 / 16u));
                let _e967 = (_e750 + 1i);
                let _e968 = (_e759 + 1i);
                let _e970 = (bitcast<i32>(_e887) - 1i);
                if (_e967 > 0i) {
                    phi_1582_ = _e967;
                } else {
                    phi_1582_ = 0i;
                }
                let _e973 = phi_1582_;
                if (_e968 > 0i) {
                    phi_1587_ = _e968;
                } else {
                    phi_1587_ = 0i;
                }
                let _e976 = phi_1587_;
                if (_e973 < _e970) {
                    phi_1592_ = _e973;
                } else {
                    phi_1592_ = _e970;
                }
                let _e979 = phi_1592_;
                if (_e976 < _e970) {
                    phi_1597_ = _e976;
                } else {
                    phi_1597_ = _e970;
                }
                let _e982 = phi_1597_;
                let _e983 = bitcast<u32>(_e979);
                let _e990 = ((((_e889.level * _e887) + bitcast<u32>(_e982)) * (_e887 / 16u)) + (_e983 / 16u));
                if (_e912 < _e73) {
                } else {
                    return;
                }
                let _e996 = marks.member[(0u + _e912)];
                if (_e938 < _e73) {
                } else {
                    return;
                }
                let _e1004 = marks.member[(0u + _e938)];
                if (_e964 < _e73) {
                } else {
                    return;
                }
                let _e1013 = marks.member[(0u + _e964)];
                if (_e990 < _e73) {
                } else {
                    return;
                }
                let _e1021 = marks.member[(0u + _e990)];
                let _e1029 = p.member.epsilon;
                if (_e885 <= _e1029) {
                    phi_1675_ = true;
                } else {
                    phi_1675_ = (_e885 >= (1f - _e1029));
                }
                let _e1034 = phi_1675_;
                if ((bitcast<u32>(_e885) & 2147483647u) > 2139095040u) {
                    phi_1683_ = true;
                } else {
                    phi_1683_ = !(_e1034);
                }
                let _e1040 = phi_1683_;
                if _e1040 {
                    if (_e885 > 0f) {
                        if (_e885 < 1f) {
                            phi_1695_ = false;
                        } else {
                            phi_1695_ = true;
                        }
                        let _e1044 = phi_1695_;
                        phi_1696_ = _e1044;
                    } else {
                        phi_1696_ = true;
                    }
                    let _e1046 = phi_1696_;
                    if _e1046 {
                        phi_1700_ = 0.5f;
                    } else {
                        phi_1700_ = _e885;
                    }
                    let _e1048 = phi_1700_;
                    phi_1708_ = evaluate_Verdict(_e1048, true);
                } else {
                    if (_e885 > 0.5f) {
                        phi_1706_ = 1f;
                    } else {
                        phi_1706_ = 0f;
                    }
                    let _e1052 = phi_1706_;
                    phi_1708_ = evaluate_Verdict(_e1052, false);
                }
                let _e1055 = phi_1708_;
                let _e1058 = (_e1055.visibility < 0.5f);
                if _e1055.is_doubted {
                    phi_1731_ = evaluate_Verdict();
                    phi_1732_ = true;
                } else {
                    if _e1058 {
                        phi_1718_ = 2u;
                    } else {
                        phi_1718_ = 1u;
                    }
                    let _e1060 = phi_1718_;
                    if ((((((_e996 >> bitcast<u32>((((_e905 % 16u) * 2u) & 31u))) & 3u) | ((_e1004 >> bitcast<u32>((((_e931 % 16u) * 2u) & 31u))) & 3u)) | (((_e1013 >> bitcast<u32>((((_e957 % 16u) * 2u) & 31u))) & 3u) | ((_e1021 >> bitcast<u32>((((_e983 % 16u) * 2u) & 31u))) & 3u))) & _e1060) != 0u) {
                        if _e1058 {
                            phi_1727_ = 0.000000059604645f;
                        } else {
                            phi_1727_ = 0.99999994f;
                        }
                        let _e1064 = phi_1727_;
                        phi_1729_ = evaluate_Verdict(_e1064, true);
                        phi_1730_ = false;
                    } else {
                        phi_1729_ = evaluate_Verdict();
                        phi_1730_ = true;
                    }
                    let _e1067 = phi_1729_;
                    let _e1069 = phi_1730_;
                    phi_1731_ = _e1067;
                    phi_1732_ = _e1069;
                }
                let _e1071 = phi_1731_;
                let _e1073 = phi_1732_;
                if _e1073 {
                    phi_1737_ = evaluate_Verdict(_e1055.visibility, _e1055.is_doubted);
                } else {
                    phi_1737_ = _e1071;
                }
                let _e1076 = phi_1737_;
                phi_1742_ = evaluate_Verdict(_e1076.visibility, _e1076.is_doubted);
            } else {
                phi_1742_ = evaluate_Verdict(0.5f, true);
            }
            let _e1082 = phi_1742_;
            phi_1743_ = _e1082;
        }
        let _e1084 = phi_1743_;
        if (_e82.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e82.first_primitive)] = _e1084.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_prefiltered_levels_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
