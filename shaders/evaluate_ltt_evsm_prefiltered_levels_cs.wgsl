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

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
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

struct type_39 {
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

struct type_43 {
    member: abi_ShadowParams,
}

struct type_47 {
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

struct type_56 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_5: u32;
@group(0) @binding(1) 
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_56;
@group(0) @binding(5) 
var<storage> levels: type_47;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_188_: lt_bvh_traverse_Tree;
    var phi_189_: bool;
    var phi_190_: lt_bvh_traverse_Tree;
    var phi_191_: bool;
    var phi_196_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_188_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_189_ = false;
        } else {
            phi_188_ = lt_bvh_traverse_Tree();
            phi_189_ = true;
        }
        let _e74 = phi_188_;
        let _e76 = phi_189_;
        phi_190_ = _e74;
        phi_191_ = _e76;
    } else {
        phi_190_ = lt_bvh_traverse_Tree();
        phi_191_ = true;
    }
    let _e78 = phi_190_;
    let _e80 = phi_191_;
    if _e80 {
        phi_196_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_196_ = _e78;
    }
    let _e85 = phi_196_;
    return lt_bvh_traverse_Tree(_e85.root, _e85.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_225_: f32;
    var phi_238_: bool;
    var phi_242_: f32;
    var phi_254_: f32;
    var phi_259_: f32;
    var phi_281_: f32;
    var phi_286_: f32;
    var phi_287_: bool;
    var phi_288_: f32;
    var phi_289_: bool;
    var phi_293_: f32;
    var phi_331_: f32;
    var phi_344_: bool;
    var phi_348_: f32;
    var phi_361_: f32;
    var phi_366_: f32;
    var phi_388_: f32;
    var phi_393_: f32;
    var phi_394_: bool;
    var phi_395_: f32;
    var phi_396_: bool;
    var phi_400_: f32;
    var phi_438_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_225_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_224_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_223_ = 1f;
            } else {
                phi_223_ = param_5;
            }
            let _e69 = phi_223_;
            phi_224_ = _e69;
        }
        let _e71 = phi_224_;
        phi_225_ = _e71;
    }
    let _e73 = phi_225_;
    let _e75 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_238_ = true;
    } else {
        let _e79 = (42f < _e75);
        if _e79 {
        }
        phi_238_ = _e79;
    }
    let _e81 = phi_238_;
    if _e81 {
        phi_242_ = 42f;
    } else {
        phi_242_ = _e75;
    }
    let _e83 = phi_242_;
    let _e84 = (_e83 * _e73);
    if ((bitcast<u32>(_e84) & 2147483647u) > 2139095040u) {
        phi_331_ = _e84;
    } else {
        if (_e84 < -87f) {
            phi_254_ = -87f;
        } else {
            phi_254_ = _e84;
        }
        let _e90 = phi_254_;
        if (_e90 > 88f) {
            phi_259_ = 88f;
        } else {
            phi_259_ = _e90;
        }
        let _e93 = phi_259_;
        let _e95 = ((_e93 * 1.442695f) + 0.5f);
        if (_e95 > -8388608f) {
            let _e107 = f32(select(0i, select(select(i32(_e95), i32(-2147483648), (_e95 < bitcast<f32>(3472883712u))), 2147483647i, (_e95 > bitcast<f32>(1325400063u))), (_e95 == _e95)));
            if (_e107 > _e95) {
                phi_281_ = 1f;
            } else {
                phi_281_ = 0f;
            }
            let _e110 = phi_281_;
            if (_e95 < 8388608f) {
                phi_286_ = (_e107 - _e110);
                phi_287_ = false;
            } else {
                phi_286_ = f32();
                phi_287_ = true;
            }
            let _e113 = phi_286_;
            let _e115 = phi_287_;
            phi_288_ = _e113;
            phi_289_ = _e115;
        } else {
            phi_288_ = f32();
            phi_289_ = true;
        }
        let _e117 = phi_288_;
        let _e119 = phi_289_;
        if _e119 {
            phi_293_ = _e95;
        } else {
            phi_293_ = _e117;
        }
        let _e121 = phi_293_;
        let _e125 = ((_e93 - (_e121 * 0.69314575f)) - (_e121 * 0.0000014286068f));
        phi_331_ = ((((((((((((((((1f / 5040f) * _e125) + (1f / 720f)) * _e125) + (1f / 120f)) * _e125) + (1f / 24f)) * _e125) + (1f / 6f)) * _e125) + 0.5f) * _e125) + 1f) * _e125) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e121), i32(-2147483648), (_e121 < bitcast<f32>(3472883712u))), 2147483647i, (_e121 > bitcast<f32>(1325400063u))), (_e121 == _e121)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e161 = phi_331_;
    let _e163 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_344_ = true;
    } else {
        let _e167 = (42f < _e163);
        if _e167 {
        }
        phi_344_ = _e167;
    }
    let _e169 = phi_344_;
    if _e169 {
        phi_348_ = 42f;
    } else {
        phi_348_ = _e163;
    }
    let _e171 = phi_348_;
    let _e173 = (-(_e171) * _e73);
    if ((bitcast<u32>(_e173) & 2147483647u) > 2139095040u) {
        phi_438_ = _e173;
    } else {
        if (_e173 < -87f) {
            phi_361_ = -87f;
        } else {
            phi_361_ = _e173;
        }
        let _e179 = phi_361_;
        if (_e179 > 88f) {
            phi_366_ = 88f;
        } else {
            phi_366_ = _e179;
        }
        let _e182 = phi_366_;
        let _e184 = ((_e182 * 1.442695f) + 0.5f);
        if (_e184 > -8388608f) {
            let _e196 = f32(select(0i, select(select(i32(_e184), i32(-2147483648), (_e184 < bitcast<f32>(3472883712u))), 2147483647i, (_e184 > bitcast<f32>(1325400063u))), (_e184 == _e184)));
            if (_e196 > _e184) {
                phi_388_ = 1f;
            } else {
                phi_388_ = 0f;
            }
            let _e199 = phi_388_;
            if (_e184 < 8388608f) {
                phi_393_ = (_e196 - _e199);
                phi_394_ = false;
            } else {
                phi_393_ = f32();
                phi_394_ = true;
            }
            let _e202 = phi_393_;
            let _e204 = phi_394_;
            phi_395_ = _e202;
            phi_396_ = _e204;
        } else {
            phi_395_ = f32();
            phi_396_ = true;
        }
        let _e206 = phi_395_;
        let _e208 = phi_396_;
        if _e208 {
            phi_400_ = _e184;
        } else {
            phi_400_ = _e206;
        }
        let _e210 = phi_400_;
        let _e214 = ((_e182 - (_e210 * 0.69314575f)) - (_e210 * 0.0000014286068f));
        phi_438_ = ((((((((((((((((1f / 5040f) * _e214) + (1f / 720f)) * _e214) + (1f / 120f)) * _e214) + (1f / 24f)) * _e214) + (1f / 6f)) * _e214) + 0.5f) * _e214) + 1f) * _e214) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e210), i32(-2147483648), (_e210 < bitcast<f32>(3472883712u))), 2147483647i, (_e210 > bitcast<f32>(1325400063u))), (_e210 == _e210)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e250 = phi_438_;
    let _e251 = -(_e250);
    return vec4<f32>(_e161, (_e161 * _e161), _e251, (_e251 * _e251));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_460_: bool;
    var phi_464_: f32;
    var phi_488_: bool;
    var phi_492_: f32;
    var phi_504_: bool;
    var phi_511_: f32;
    var phi_524_: bool;
    var phi_528_: f32;
    var phi_552_: bool;
    var phi_556_: f32;
    var phi_568_: bool;
    var phi_575_: f32;
    var phi_586_: bool;
    var phi_590_: f32;
    var phi_605_: f32;
    var phi_606_: f32;
    var phi_607_: f32;

    let _e64 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e66 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_460_ = true;
    } else {
        let _e70 = (42f < _e66);
        if _e70 {
        }
        phi_460_ = _e70;
    }
    let _e72 = phi_460_;
    if _e72 {
        phi_464_ = 42f;
    } else {
        phi_464_ = _e66;
    }
    let _e74 = phi_464_;
    let _e76 = (*param_6).min_variance;
    let _e80 = (((_e76 * _e74) * _e74) * _e64.y);
    let _e87 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e80) & 2147483647u) > 2139095040u) {
        phi_488_ = true;
    } else {
        let _e91 = (_e80 > _e87);
        if _e91 {
        }
        phi_488_ = _e91;
    }
    let _e93 = phi_488_;
    if _e93 {
        phi_492_ = _e80;
    } else {
        phi_492_ = _e87;
    }
    let _e95 = phi_492_;
    let _e96 = (_e64.x - param_7.x);
    if (_e96 <= 0f) {
        let _e100 = ((bitcast<u32>(_e95) & 2147483647u) > 2139095040u);
        if _e100 {
        }
        phi_504_ = _e100;
    } else {
        phi_504_ = true;
    }
    let _e102 = phi_504_;
    if _e102 {
        phi_511_ = (_e95 / (_e95 + (_e96 * _e96)));
    } else {
        phi_511_ = 1f;
    }
    let _e107 = phi_511_;
    let _e109 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_524_ = true;
    } else {
        let _e113 = (42f < _e109);
        if _e113 {
        }
        phi_524_ = _e113;
    }
    let _e115 = phi_524_;
    if _e115 {
        phi_528_ = 42f;
    } else {
        phi_528_ = _e109;
    }
    let _e117 = phi_528_;
    let _e119 = (*param_6).min_variance;
    let _e123 = (((_e119 * _e117) * _e117) * _e64.w);
    let _e130 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e123) & 2147483647u) > 2139095040u) {
        phi_552_ = true;
    } else {
        let _e134 = (_e123 > _e130);
        if _e134 {
        }
        phi_552_ = _e134;
    }
    let _e136 = phi_552_;
    if _e136 {
        phi_556_ = _e123;
    } else {
        phi_556_ = _e130;
    }
    let _e138 = phi_556_;
    let _e139 = (_e64.z - param_7.z);
    if (_e139 <= 0f) {
        let _e143 = ((bitcast<u32>(_e138) & 2147483647u) > 2139095040u);
        if _e143 {
        }
        phi_568_ = _e143;
    } else {
        phi_568_ = true;
    }
    let _e145 = phi_568_;
    if _e145 {
        phi_575_ = (_e138 / (_e138 + (_e139 * _e139)));
    } else {
        phi_575_ = 1f;
    }
    let _e150 = phi_575_;
    if ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u) {
        phi_586_ = true;
    } else {
        let _e154 = (_e150 < _e107);
        if _e154 {
        }
        phi_586_ = _e154;
    }
    let _e156 = phi_586_;
    if _e156 {
        phi_590_ = _e150;
    } else {
        phi_590_ = _e107;
    }
    let _e158 = phi_590_;
    if ((bitcast<u32>(_e158) & 2147483647u) > 2139095040u) {
        phi_607_ = _e158;
    } else {
        if (_e158 < 0f) {
            phi_606_ = 0f;
        } else {
            if (_e158 > 1f) {
                phi_605_ = 1f;
            } else {
                phi_605_ = _e158;
            }
            let _e165 = phi_605_;
            phi_606_ = _e165;
        }
        let _e167 = phi_606_;
        phi_607_ = _e167;
    }
    let _e169 = phi_607_;
    return _e169;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_669_: bool;
    var phi_739_: bool;
    var phi_740_: bool;
    var phi_751_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_752_: bool;
    var phi_753_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_754_: bool;
    var phi_761_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_765_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_785_: lt_math_LightPoint;
    var phi_788_: u32;
    var phi_790_: lt_math_LevelPoint;
    var phi_876_: bool;
    var phi_885_: bool;
    var phi_894_: bool;
    var phi_895_: bool;
    var phi_896_: bool;
    var phi_897_: bool;
    var phi_898_: bool;
    var phi_899_: bool;
    var phi_900_: bool;
    var phi_904_: bool;
    var phi_931_: bool;
    var phi_932_: bool;
    var phi_933_: bool;
    var phi_934_: bool;
    var phi_935_: bool;
    var phi_936_: bool;
    var phi_937_: bool;
    var phi_938_: bool;
    var phi_942_: bool;
    var phi_951_: lt_math_LightPoint;
    var phi_952_: u32;
    var phi_953_: lt_math_LevelPoint;
    var phi_954_: bool;
    var phi_786_: lt_math_LightPoint;
    var phi_789_: u32;
    var phi_791_: lt_math_LevelPoint;
    var phi_955_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_995_: bool;
    var phi_996_: bool;
    var phi_997_: bool;
    var phi_998_: bool;
    var phi_1002_: bool;
    var phi_1084_: f32;
    var phi_1202_: f32;
    var phi_1203_: f32;
    var phi_1206_: f32;
    var phi_1235_: f32;
    var phi_1240_: f32;
    var phi_1241_: bool;
    var phi_1242_: f32;
    var phi_1243_: bool;
    var phi_1247_: f32;
    var phi_1267_: f32;
    var phi_1272_: f32;
    var phi_1273_: bool;
    var phi_1274_: f32;
    var phi_1275_: bool;
    var phi_1279_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1332_: i32;
    var phi_1337_: i32;
    var phi_1342_: i32;
    var phi_1347_: i32;
    var phi_1356_: i32;
    var phi_1361_: i32;
    var phi_1366_: i32;
    var phi_1371_: i32;
    var phi_1468_: bool;
    var phi_1476_: bool;
    var phi_1488_: bool;
    var phi_1489_: bool;
    var phi_1493_: f32;
    var phi_1499_: f32;
    var phi_1501_: evaluate_Verdict;
    var phi_1511_: u32;
    var phi_1520_: f32;
    var phi_1522_: evaluate_Verdict;
    var phi_1523_: bool;
    var phi_1524_: evaluate_Verdict;
    var phi_1525_: bool;
    var phi_1530_: evaluate_Verdict;
    var phi_1535_: evaluate_Verdict;
    var phi_1536_: evaluate_Verdict;
    var phi_1540_: bool;
    var phi_1541_: u32;
    var phi_1552_: u32;
    var phi_1569_: u32;

    let _e62 = id_1;
    let _e63 = local_5;
    let _e68 = arrayLength((&map.member));
    let _e73 = arrayLength((&levels.member));
    let _e76 = p.member.size[0u];
    let _e78 = p.member.size[1u];
    let _e79 = lt_shaders_entry_pixel_index(_e62, _e76, _e78);
    if (bitcast<i32>(_e79.root) != 0i) {
        let _e86 = p.member.level_count;
        let _e90 = samples.member[_e79.first_primitive].normal[0u];
        let _e92 = global[0u];
        if (_e90 == _e92) {
            let _e95 = samples.member[_e79.first_primitive].normal[1u];
            let _e97 = global[1u];
            if (_e95 == _e97) {
                let _e100 = samples.member[_e79.first_primitive].normal[2u];
                let _e102 = global[2u];
                phi_662_ = (_e100 == _e102);
                phi_663_ = false;
            } else {
                phi_662_ = bool();
                phi_663_ = true;
            }
            let _e105 = phi_662_;
            let _e107 = phi_663_;
            phi_664_ = _e105;
            phi_665_ = _e107;
        } else {
            phi_664_ = bool();
            phi_665_ = true;
        }
        let _e109 = phi_664_;
        let _e111 = phi_665_;
        if _e111 {
            phi_669_ = false;
        } else {
            phi_669_ = _e109;
        }
        let _e113 = phi_669_;
        if !(_e113) {
            let _e116 = samples.member[_e79.first_primitive].position;
            let _e118 = p.member.light.place;
            let _e124 = p.member.light.place[3u];
            let _e131 = (_e118.x - (_e116.x * _e124));
            let _e132 = (_e118.y - (_e116.y * _e124));
            let _e133 = (_e118.z - (_e116.z * _e124));
            let _e135 = samples.member[_e79.first_primitive].normal;
            if ((((_e135.x * _e131) + (_e135.y * _e132)) + (_e135.z * _e133)) > 0f) {
                let _e149 = (((_e131 * _e131) + (_e132 * _e132)) + (_e133 * _e133));
                let _e151 = p.member.light.axis;
                let _e163 = p.member.light.place[3u];
                if (_e163 == 0f) {
                    phi_740_ = true;
                } else {
                    let _e166 = p.member.light.range_squared;
                    if (_e149 <= _e166) {
                        let _e169 = p.member.light.cos_outer;
                        phi_739_ = (-((((_e131 * _e151.x) + (_e132 * _e151.y)) + (_e133 * _e151.z))) >= (_e169 * sqrt(_e149)));
                    } else {
                        phi_739_ = false;
                    }
                    let _e174 = phi_739_;
                    phi_740_ = _e174;
                }
                let _e176 = phi_740_;
                if _e176 {
                    let _e178 = samples.member[_e79.first_primitive].flags;
                    let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e186.unnamed.visibility, false), _e186.unnamed_1);
                    phi_751_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e192.unnamed, ((_e178 & 1u) == 0u));
                    phi_752_ = false;
                } else {
                    phi_751_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_752_ = true;
                }
                let _e197 = phi_751_;
                let _e199 = phi_752_;
                phi_753_ = _e197;
                phi_754_ = _e199;
            } else {
                phi_753_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_754_ = true;
            }
            let _e201 = phi_753_;
            let _e203 = phi_754_;
            if _e203 {
                let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e209.unnamed.visibility, false), _e209.unnamed_1);
                phi_761_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e215.unnamed, true);
            } else {
                phi_761_ = _e201;
            }
            let _e220 = phi_761_;
            phi_765_ = _e220;
        } else {
            let _e226 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e232 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e226.unnamed.visibility, false), _e226.unnamed_1);
            phi_765_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e232.unnamed, true);
        }
        let _e237 = phi_765_;
        if _e237.unnamed_1 {
            phi_1536_ = evaluate_Verdict(_e237.unnamed.visibility, _e237.unnamed.is_doubted);
        } else {
            let _e245 = samples.member[_e79.first_primitive].position;
            let _e247 = p.member.map_size;
            let _e249 = (0.5f / f32(_e247));
            let _e256 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e263 = lt_math_LightPoint(vec2<f32>(_e256.uv.x, 0f), _e256.depth, _e256.is_inside);
            let _e267 = lt_math_LightPoint(_e263.uv, 0f, _e263.is_inside);
            phi_785_ = lt_math_LightPoint();
            phi_788_ = 0u;
            phi_790_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e267.uv, _e267.depth, false));
            loop {
                let _e274 = phi_785_;
                let _e276 = phi_788_;
                let _e278 = phi_790_;
                local_2 = _e278;
                local_3 = _e278;
                local_4 = _e278;
                if (_e276 < _e86) {
                    if _e278.point.is_inside {
                        phi_951_ = lt_math_LightPoint();
                        phi_952_ = u32();
                        phi_953_ = lt_math_LevelPoint();
                        phi_954_ = false;
                    } else {
                        if (_e276 < _e73) {
                        } else {
                            return;
                        }
                        let _e289 = levels.member[(0u + _e276)].row_w;
                        let _e300 = ((((_e289.x * _e245.x) + (_e289.y * _e245.y)) + (_e289.z * _e245.z)) + (_e289.w * 1f));
                        let _e302 = levels.member[(0u + _e276)].row_x;
                        let _e314 = (((((_e302.x * _e245.x) + (_e302.y * _e245.y)) + (_e302.z * _e245.z)) + (_e302.w * 1f)) / _e300);
                        let _e316 = levels.member[(0u + _e276)].row_y;
                        let _e328 = (((((_e316.x * _e245.x) + (_e316.y * _e245.y)) + (_e316.z * _e245.z)) + (_e316.w * 1f)) / _e300);
                        let _e330 = levels.member[(0u + _e276)].row_z;
                        let _e341 = ((((_e330.x * _e245.x) + (_e330.y * _e245.y)) + (_e330.z * _e245.z)) + (_e330.w * 1f));
                        if (_e300 > 0f) {
                            if (_e314 >= 0f) {
                                phi_876_ = (_e314 <= 1f);
                            } else {
                                phi_876_ = false;
                            }
                            let _e346 = phi_876_;
                            if _e346 {
                                if (_e328 >= 0f) {
                                    phi_885_ = (_e328 <= 1f);
                                } else {
                                    phi_885_ = false;
                                }
                                let _e350 = phi_885_;
                                if _e350 {
                                    if (_e341 >= 0f) {
                                        phi_894_ = (_e341 <= 1f);
                                    } else {
                                        phi_894_ = false;
                                    }
                                    let _e354 = phi_894_;
                                    phi_895_ = _e354;
                                    phi_896_ = false;
                                } else {
                                    phi_895_ = bool();
                                    phi_896_ = true;
                                }
                                let _e356 = phi_895_;
                                let _e358 = phi_896_;
                                phi_897_ = _e356;
                                phi_898_ = _e358;
                            } else {
                                phi_897_ = bool();
                                phi_898_ = true;
                            }
                            let _e360 = phi_897_;
                            let _e362 = phi_898_;
                            phi_899_ = _e360;
                            phi_900_ = _e362;
                        } else {
                            phi_899_ = bool();
                            phi_900_ = true;
                        }
                        let _e364 = phi_899_;
                        let _e366 = phi_900_;
                        if _e366 {
                            phi_904_ = false;
                        } else {
                            phi_904_ = _e364;
                        }
                        let _e368 = phi_904_;
                        if _e368 {
                            if (_e314 >= _e249) {
                                if (_e314 <= (1f - _e249)) {
                                    if (_e328 >= _e249) {
                                        phi_931_ = (_e328 <= (1f - _e249));
                                        phi_932_ = false;
                                    } else {
                                        phi_931_ = bool();
                                        phi_932_ = true;
                                    }
                                    let _e376 = phi_931_;
                                    let _e378 = phi_932_;
                                    phi_933_ = _e376;
                                    phi_934_ = _e378;
                                } else {
                                    phi_933_ = bool();
                                    phi_934_ = true;
                                }
                                let _e380 = phi_933_;
                                let _e382 = phi_934_;
                                phi_935_ = _e380;
                                phi_936_ = _e382;
                            } else {
                                phi_935_ = bool();
                                phi_936_ = true;
                            }
                            let _e384 = phi_935_;
                            let _e386 = phi_936_;
                            phi_937_ = _e384;
                            phi_938_ = _e386;
                        } else {
                            phi_937_ = bool();
                            phi_938_ = true;
                        }
                        let _e388 = phi_937_;
                        let _e390 = phi_938_;
                        if _e390 {
                            phi_942_ = false;
                        } else {
                            phi_942_ = _e388;
                        }
                        let _e392 = phi_942_;
                        let _e399 = lt_math_LightPoint(vec2<f32>(_e314, _e274.uv.y), _e274.depth, _e274.is_inside);
                        let _e406 = lt_math_LightPoint(vec2<f32>(_e399.uv.x, _e328), _e399.depth, _e399.is_inside);
                        let _e410 = lt_math_LightPoint(_e406.uv, _e341, _e406.is_inside);
                        let _e414 = lt_math_LightPoint(_e410.uv, _e410.depth, _e392);
                        phi_951_ = _e414;
                        phi_952_ = (_e276 + 1u);
                        phi_953_ = lt_math_LevelPoint(_e276, _e414);
                        phi_954_ = true;
                    }
                    let _e418 = phi_951_;
                    let _e420 = phi_952_;
                    let _e422 = phi_953_;
                    let _e424 = phi_954_;
                    phi_786_ = _e418;
                    phi_789_ = _e420;
                    phi_791_ = _e422;
                    phi_955_ = _e424;
                } else {
                    phi_786_ = lt_math_LightPoint();
                    phi_789_ = u32();
                    phi_791_ = lt_math_LevelPoint();
                    phi_955_ = false;
                }
                let _e426 = phi_786_;
                let _e428 = phi_789_;
                let _e430 = phi_791_;
                let _e432 = phi_955_;
                continue;
                continuing {
                    phi_785_ = _e426;
                    phi_788_ = _e428;
                    phi_790_ = _e430;
                    break if !(_e432);
                }
            }
            let _e435 = local_2;
            if _e435.point.is_inside {
                if (0f > 0f) {
                    let _e441 = local_3;
                    if (_e441.level < _e73) {
                    } else {
                        return;
                    }
                    let _e446 = levels.member[(0u + _e441.level)];
                    let _e452 = global[0u];
                    if (_e446.row_w.x == _e452) {
                        let _e455 = global[1u];
                        if (_e446.row_w.y == _e455) {
                            let _e458 = global[2u];
                            phi_995_ = (_e446.row_w.z == _e458);
                            phi_996_ = false;
                        } else {
                            phi_995_ = bool();
                            phi_996_ = true;
                        }
                        let _e461 = phi_995_;
                        let _e463 = phi_996_;
                        phi_997_ = _e461;
                        phi_998_ = _e463;
                    } else {
                        phi_997_ = bool();
                        phi_998_ = true;
                    }
                    let _e465 = phi_997_;
                    let _e467 = phi_998_;
                    if _e467 {
                        phi_1002_ = false;
                    } else {
                        phi_1002_ = _e465;
                    }
                    let _e469 = phi_1002_;
                    if _e469 {
                        let _e471 = samples.member[_e79.first_primitive].normal;
                        let _e473 = p.member.map_size;
                        let _e543 = ((abs(((((_e446.row_x.x * _e471.x) + (_e446.row_x.y * _e471.y)) + (_e446.row_x.z * _e471.z)) / (((_e446.row_x.x * _e446.row_x.x) + (_e446.row_x.y * _e446.row_x.y)) + (_e446.row_x.z * _e446.row_x.z)))) + abs(((((_e446.row_y.x * _e471.x) + (_e446.row_y.y * _e471.y)) + (_e446.row_y.z * _e471.z)) / (((_e446.row_y.x * _e446.row_y.x) + (_e446.row_y.y * _e446.row_y.y)) + (_e446.row_y.z * _e446.row_y.z))))) / (abs(((((_e446.row_z.x * _e471.x) + (_e446.row_z.y * _e471.y)) + (_e446.row_z.z * _e471.z)) / (((_e446.row_z.x * _e446.row_z.x) + (_e446.row_z.y * _e446.row_z.y)) + (_e446.row_z.z * _e446.row_z.z)))) * f32(_e473)));
                        if (_e543 < 0.002f) {
                            phi_1084_ = _e543;
                        } else {
                            phi_1084_ = 0.002f;
                        }
                        let _e546 = phi_1084_;
                        phi_1203_ = _e546;
                    } else {
                        let _e548 = p.member.map_size;
                        let _e554 = samples.member[_e79.first_primitive].position;
                        let _e565 = ((((_e446.row_w.x * _e554.x) + (_e446.row_w.y * _e554.y)) + (_e446.row_w.z * _e554.z)) + _e446.row_w.w);
                        let _e578 = ((_e446.row_x.x - (_e446.row_w.x * _e435.point.uv.x)) / _e565);
                        let _e579 = ((_e446.row_x.y - (_e446.row_w.y * _e435.point.uv.x)) / _e565);
                        let _e580 = ((_e446.row_x.z - (_e446.row_w.z * _e435.point.uv.x)) / _e565);
                        let _e593 = ((_e446.row_y.x - (_e446.row_w.x * _e435.point.uv.y)) / _e565);
                        let _e594 = ((_e446.row_y.y - (_e446.row_w.y * _e435.point.uv.y)) / _e565);
                        let _e595 = ((_e446.row_y.z - (_e446.row_w.z * _e435.point.uv.y)) / _e565);
                        let _e601 = samples.member[_e79.first_primitive].normal;
                        let _e606 = ((_e594 * _e601.z) - (_e601.y * _e595));
                        let _e611 = ((_e595 * _e601.x) - (_e601.z * _e593));
                        let _e616 = ((_e593 * _e601.y) - (_e601.x * _e594));
                        let _e618 = samples.member[_e79.first_primitive].normal;
                        let _e623 = ((_e579 * _e618.z) - (_e618.y * _e580));
                        let _e628 = ((_e580 * _e618.x) - (_e618.z * _e578));
                        let _e633 = ((_e578 * _e618.y) - (_e618.x * _e579));
                        let _e660 = ((abs(((((_e446.row_z.x * _e606) + (_e446.row_z.y * _e611)) + (_e446.row_z.z * _e616)) / (((_e578 * _e606) + (_e579 * _e611)) + (_e580 * _e616)))) + abs(((((_e446.row_z.x * _e623) + (_e446.row_z.y * _e628)) + (_e446.row_z.z * _e633)) / (((_e593 * _e623) + (_e594 * _e628)) + (_e595 * _e633))))) / f32(_e548));
                        let _e662 = (16f / f32(_e548));
                        if (_e660 < _e662) {
                            phi_1202_ = _e660;
                        } else {
                            phi_1202_ = _e662;
                        }
                        let _e665 = phi_1202_;
                        phi_1203_ = _e665;
                    }
                    let _e667 = phi_1203_;
                    phi_1206_ = (_e435.point.depth - (0f * _e667));
                } else {
                    phi_1206_ = _e435.point.depth;
                }
                let _e671 = phi_1206_;
                let _e677 = p.member.map_size;
                let _e678 = f32(_e677);
                let _e681 = ((_e435.point.uv.x * _e678) - 0.5f);
                let _e682 = ((_e435.point.uv.y * _e678) - 0.5f);
                if (_e681 > -8388608f) {
                    let _e694 = f32(select(0i, select(select(i32(_e681), i32(-2147483648), (_e681 < bitcast<f32>(3472883712u))), 2147483647i, (_e681 > bitcast<f32>(1325400063u))), (_e681 == _e681)));
                    if (_e694 > _e681) {
                        phi_1235_ = 1f;
                    } else {
                        phi_1235_ = 0f;
                    }
                    let _e697 = phi_1235_;
                    if (_e681 < 8388608f) {
                        phi_1240_ = (_e694 - _e697);
                        phi_1241_ = false;
                    } else {
                        phi_1240_ = f32();
                        phi_1241_ = true;
                    }
                    let _e700 = phi_1240_;
                    let _e702 = phi_1241_;
                    phi_1242_ = _e700;
                    phi_1243_ = _e702;
                } else {
                    phi_1242_ = f32();
                    phi_1243_ = true;
                }
                let _e704 = phi_1242_;
                let _e706 = phi_1243_;
                if _e706 {
                    phi_1247_ = _e681;
                } else {
                    phi_1247_ = _e704;
                }
                let _e708 = phi_1247_;
                if (_e682 > -8388608f) {
                    let _e720 = f32(select(0i, select(select(i32(_e682), i32(-2147483648), (_e682 < bitcast<f32>(3472883712u))), 2147483647i, (_e682 > bitcast<f32>(1325400063u))), (_e682 == _e682)));
                    if (_e720 > _e682) {
                        phi_1267_ = 1f;
                    } else {
                        phi_1267_ = 0f;
                    }
                    let _e723 = phi_1267_;
                    if (_e682 < 8388608f) {
                        phi_1272_ = (_e720 - _e723);
                        phi_1273_ = false;
                    } else {
                        phi_1272_ = f32();
                        phi_1273_ = true;
                    }
                    let _e726 = phi_1272_;
                    let _e728 = phi_1273_;
                    phi_1274_ = _e726;
                    phi_1275_ = _e728;
                } else {
                    phi_1274_ = f32();
                    phi_1275_ = true;
                }
                let _e730 = phi_1274_;
                let _e732 = phi_1275_;
                if _e732 {
                    phi_1279_ = _e682;
                } else {
                    phi_1279_ = _e730;
                }
                let _e734 = phi_1279_;
                let _e735 = (_e681 - _e708);
                let _e736 = (_e682 - _e734);
                let _e745 = select(0i, select(select(i32(_e708), i32(-2147483648), (_e708 < bitcast<f32>(3472883712u))), 2147483647i, (_e708 > bitcast<f32>(1325400063u))), (_e708 == _e708));
                let _e754 = select(0i, select(select(i32(_e734), i32(-2147483648), (_e734 < bitcast<f32>(3472883712u))), 2147483647i, (_e734 > bitcast<f32>(1325400063u))), (_e734 == _e734));
                let _e757 = ((1f - _e735) * (1f - _e736));
                let _e759 = (_e735 * (1f - _e736));
                let _e761 = ((1f - _e735) * _e736);
                let _e762 = (_e735 * _e736);
                let _e764 = p.member.test;
                let _e765 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e764);
                let _e767 = p.member.map_size;
                let _e769 = local_4;
                local_1 = lt_math_Evsm(_e765.positive_exponent, _e765.negative_exponent, _e765.min_variance);
                let _e776 = ((_e769.level * _e767) * _e767);
                let _e778 = (bitcast<i32>(_e767) - 1i);
                if (_e745 > 0i) {
                    phi_1332_ = _e745;
                } else {
                    phi_1332_ = 0i;
                }
                let _e781 = phi_1332_;
                if (_e754 > 0i) {
                    phi_1337_ = _e754;
                } else {
                    phi_1337_ = 0i;
                }
                let _e784 = phi_1337_;
                if (_e781 < _e778) {
                    phi_1342_ = _e781;
                } else {
                    phi_1342_ = _e778;
                }
                let _e787 = phi_1342_;
                if (_e784 < _e778) {
                    phi_1347_ = _e784;
                } else {
                    phi_1347_ = _e778;
                }
                let _e790 = phi_1347_;
                let _e791 = bitcast<u32>(_e787);
                let _e793 = (_e745 + 1i);
                let _e794 = (_e754 + 1i);
                if (_e793 > 0i) {
                    phi_1356_ = _e793;
                } else {
                    phi_1356_ = 0i;
                }
                let _e797 = phi_1356_;
                if (_e794 > 0i) {
                    phi_1361_ = _e794;
                } else {
                    phi_1361_ = 0i;
                }
                let _e800 = phi_1361_;
                if (_e797 < _e778) {
                    phi_1366_ = _e797;
                } else {
                    phi_1366_ = _e778;
                }
                let _e803 = phi_1366_;
                if (_e800 < _e778) {
                    phi_1371_ = _e800;
                } else {
                    phi_1371_ = _e778;
                }
                let _e806 = phi_1371_;
                let _e807 = bitcast<u32>(_e803);
                let _e809 = (bitcast<u32>(_e790) * _e767);
                let _e810 = (bitcast<u32>(_e806) * _e767);
                let _e815 = ((_e809 + _e791) + _e776);
                let _e816 = ((_e809 + _e807) + _e776);
                let _e817 = ((_e810 + _e791) + _e776);
                let _e818 = ((_e810 + _e807) + _e776);
                if (_e815 < _e68) {
                } else {
                    return;
                }
                let _e822 = map.member[(0u + _e815)];
                if (_e816 < _e68) {
                } else {
                    return;
                }
                let _e834 = map.member[(0u + _e816)];
                if (_e817 < _e68) {
                } else {
                    return;
                }
                let _e850 = map.member[(0u + _e817)];
                if (_e818 < _e68) {
                } else {
                    return;
                }
                let _e866 = map.member[(0u + _e818)];
                let _e880 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e822.x * _e757) + (_e834.x * _e759)) + (_e850.x * _e761)) + (_e866.x * _e762)), ((((_e822.y * _e757) + (_e834.y * _e759)) + (_e850.y * _e761)) + (_e866.y * _e762)), ((((_e822.z * _e757) + (_e834.z * _e759)) + (_e850.z * _e761)) + (_e866.z * _e762)), ((((_e822.w * _e757) + (_e834.w * _e759)) + (_e850.w * _e761)) + (_e866.w * _e762))), _e671);
                let _e884 = p.member.epsilon;
                if (_e880 <= _e884) {
                    phi_1468_ = true;
                } else {
                    phi_1468_ = (_e880 >= (1f - _e884));
                }
                let _e889 = phi_1468_;
                if ((bitcast<u32>(_e880) & 2147483647u) > 2139095040u) {
                    phi_1476_ = true;
                } else {
                    phi_1476_ = !(_e889);
                }
                let _e895 = phi_1476_;
                if _e895 {
                    if (_e880 > 0f) {
                        if (_e880 < 1f) {
                            phi_1488_ = false;
                        } else {
                            phi_1488_ = true;
                        }
                        let _e899 = phi_1488_;
                        phi_1489_ = _e899;
                    } else {
                        phi_1489_ = true;
                    }
                    let _e901 = phi_1489_;
                    if _e901 {
                        phi_1493_ = 0.5f;
                    } else {
                        phi_1493_ = _e880;
                    }
                    let _e903 = phi_1493_;
                    phi_1501_ = evaluate_Verdict(_e903, true);
                } else {
                    if (_e880 > 0.5f) {
                        phi_1499_ = 1f;
                    } else {
                        phi_1499_ = 0f;
                    }
                    let _e907 = phi_1499_;
                    phi_1501_ = evaluate_Verdict(_e907, false);
                }
                let _e910 = phi_1501_;
                let _e913 = (_e910.visibility < 0.5f);
                if _e910.is_doubted {
                    phi_1524_ = evaluate_Verdict();
                    phi_1525_ = true;
                } else {
                    if _e913 {
                        phi_1511_ = 2u;
                    } else {
                        phi_1511_ = 1u;
                    }
                    let _e915 = phi_1511_;
                    if ((0u & _e915) != 0u) {
                        if _e913 {
                            phi_1520_ = 0.000000059604645f;
                        } else {
                            phi_1520_ = 0.99999994f;
                        }
                        let _e919 = phi_1520_;
                        phi_1522_ = evaluate_Verdict(_e919, true);
                        phi_1523_ = false;
                    } else {
                        phi_1522_ = evaluate_Verdict();
                        phi_1523_ = true;
                    }
                    let _e922 = phi_1522_;
                    let _e924 = phi_1523_;
                    phi_1524_ = _e922;
                    phi_1525_ = _e924;
                }
                let _e926 = phi_1524_;
                let _e928 = phi_1525_;
                if _e928 {
                    phi_1530_ = evaluate_Verdict(_e910.visibility, _e910.is_doubted);
                } else {
                    phi_1530_ = _e926;
                }
                let _e931 = phi_1530_;
                phi_1535_ = evaluate_Verdict(_e931.visibility, _e931.is_doubted);
            } else {
                phi_1535_ = evaluate_Verdict(0.5f, true);
            }
            let _e937 = phi_1535_;
            phi_1536_ = _e937;
        }
        let _e939 = phi_1536_;
        visibility.member[_e79.first_primitive] = _e939.visibility;
        phi_1540_ = _e939.is_doubted;
        phi_1541_ = _e79.first_primitive;
    } else {
        phi_1540_ = false;
        phi_1541_ = 0u;
    }
    let _e944 = phi_1540_;
    let _e946 = phi_1541_;
    if (_e63 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e944 {
        let _e950 = atomicAdd((&shared_[0u]), 1u);
        phi_1552_ = _e950;
    } else {
        phi_1552_ = 0u;
    }
    let _e952 = phi_1552_;
    workgroupBarrier();
    if (_e63 == 0u) {
        let _e956 = atomicLoad((&shared_[0u]));
        let _e957 = atomicAdd((&list.member[3u]), _e956);
        atomicStore((&shared_[1u]), _e957);
    }
    workgroupBarrier();
    if _e944 {
        if false {
            phi_1569_ = (_e946 | 2147483648u);
        } else {
            phi_1569_ = _e946;
        }
        let _e961 = phi_1569_;
        let _e963 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e963) + _e952)]), _e961);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
