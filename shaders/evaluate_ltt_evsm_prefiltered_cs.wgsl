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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct type_51 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_51;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_169_: lt_bvh_traverse_Tree;
    var phi_170_: bool;
    var phi_171_: lt_bvh_traverse_Tree;
    var phi_172_: bool;
    var phi_177_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_169_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_170_ = false;
        } else {
            phi_169_ = lt_bvh_traverse_Tree();
            phi_170_ = true;
        }
        let _e64 = phi_169_;
        let _e66 = phi_170_;
        phi_171_ = _e64;
        phi_172_ = _e66;
    } else {
        phi_171_ = lt_bvh_traverse_Tree();
        phi_172_ = true;
    }
    let _e68 = phi_171_;
    let _e70 = phi_172_;
    if _e70 {
        phi_177_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_177_ = _e68;
    }
    let _e75 = phi_177_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_204_: f32;
    var phi_205_: f32;
    var phi_206_: f32;
    var phi_219_: bool;
    var phi_223_: f32;
    var phi_235_: f32;
    var phi_240_: f32;
    var phi_262_: f32;
    var phi_267_: f32;
    var phi_268_: bool;
    var phi_269_: f32;
    var phi_270_: bool;
    var phi_274_: f32;
    var phi_312_: f32;
    var phi_325_: bool;
    var phi_329_: f32;
    var phi_342_: f32;
    var phi_347_: f32;
    var phi_369_: f32;
    var phi_374_: f32;
    var phi_375_: bool;
    var phi_376_: f32;
    var phi_377_: bool;
    var phi_381_: f32;
    var phi_419_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_206_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_205_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_204_ = 1f;
            } else {
                phi_204_ = param_5;
            }
            let _e59 = phi_204_;
            phi_205_ = _e59;
        }
        let _e61 = phi_205_;
        phi_206_ = _e61;
    }
    let _e63 = phi_206_;
    let _e65 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_219_ = true;
    } else {
        let _e69 = (42f < _e65);
        if _e69 {
        }
        phi_219_ = _e69;
    }
    let _e71 = phi_219_;
    if _e71 {
        phi_223_ = 42f;
    } else {
        phi_223_ = _e65;
    }
    let _e73 = phi_223_;
    let _e74 = (_e73 * _e63);
    if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
        phi_312_ = _e74;
    } else {
        if (_e74 < -87f) {
            phi_235_ = -87f;
        } else {
            phi_235_ = _e74;
        }
        let _e80 = phi_235_;
        if (_e80 > 88f) {
            phi_240_ = 88f;
        } else {
            phi_240_ = _e80;
        }
        let _e83 = phi_240_;
        let _e85 = ((_e83 * 1.442695f) + 0.5f);
        if (_e85 > -8388608f) {
            let _e97 = f32(select(0i, select(select(i32(_e85), i32(-2147483648), (_e85 < bitcast<f32>(3472883712u))), 2147483647i, (_e85 > bitcast<f32>(1325400063u))), (_e85 == _e85)));
            if (_e97 > _e85) {
                phi_262_ = 1f;
            } else {
                phi_262_ = 0f;
            }
            let _e100 = phi_262_;
            if (_e85 < 8388608f) {
                phi_267_ = (_e97 - _e100);
                phi_268_ = false;
            } else {
                phi_267_ = f32();
                phi_268_ = true;
            }
            let _e103 = phi_267_;
            let _e105 = phi_268_;
            phi_269_ = _e103;
            phi_270_ = _e105;
        } else {
            phi_269_ = f32();
            phi_270_ = true;
        }
        let _e107 = phi_269_;
        let _e109 = phi_270_;
        if _e109 {
            phi_274_ = _e85;
        } else {
            phi_274_ = _e107;
        }
        let _e111 = phi_274_;
        let _e115 = ((_e83 - (_e111 * 0.69314575f)) - (_e111 * 0.0000014286068f));
        phi_312_ = ((((((((((((((((1f / 5040f) * _e115) + (1f / 720f)) * _e115) + (1f / 120f)) * _e115) + (1f / 24f)) * _e115) + (1f / 6f)) * _e115) + 0.5f) * _e115) + 1f) * _e115) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e111), i32(-2147483648), (_e111 < bitcast<f32>(3472883712u))), 2147483647i, (_e111 > bitcast<f32>(1325400063u))), (_e111 == _e111)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e151 = phi_312_;
    let _e153 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_325_ = true;
    } else {
        let _e157 = (42f < _e153);
        if _e157 {
        }
        phi_325_ = _e157;
    }
    let _e159 = phi_325_;
    if _e159 {
        phi_329_ = 42f;
    } else {
        phi_329_ = _e153;
    }
    let _e161 = phi_329_;
    let _e163 = (-(_e161) * _e63);
    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
        phi_419_ = _e163;
    } else {
        if (_e163 < -87f) {
            phi_342_ = -87f;
        } else {
            phi_342_ = _e163;
        }
        let _e169 = phi_342_;
        if (_e169 > 88f) {
            phi_347_ = 88f;
        } else {
            phi_347_ = _e169;
        }
        let _e172 = phi_347_;
        let _e174 = ((_e172 * 1.442695f) + 0.5f);
        if (_e174 > -8388608f) {
            let _e186 = f32(select(0i, select(select(i32(_e174), i32(-2147483648), (_e174 < bitcast<f32>(3472883712u))), 2147483647i, (_e174 > bitcast<f32>(1325400063u))), (_e174 == _e174)));
            if (_e186 > _e174) {
                phi_369_ = 1f;
            } else {
                phi_369_ = 0f;
            }
            let _e189 = phi_369_;
            if (_e174 < 8388608f) {
                phi_374_ = (_e186 - _e189);
                phi_375_ = false;
            } else {
                phi_374_ = f32();
                phi_375_ = true;
            }
            let _e192 = phi_374_;
            let _e194 = phi_375_;
            phi_376_ = _e192;
            phi_377_ = _e194;
        } else {
            phi_376_ = f32();
            phi_377_ = true;
        }
        let _e196 = phi_376_;
        let _e198 = phi_377_;
        if _e198 {
            phi_381_ = _e174;
        } else {
            phi_381_ = _e196;
        }
        let _e200 = phi_381_;
        let _e204 = ((_e172 - (_e200 * 0.69314575f)) - (_e200 * 0.0000014286068f));
        phi_419_ = ((((((((((((((((1f / 5040f) * _e204) + (1f / 720f)) * _e204) + (1f / 120f)) * _e204) + (1f / 24f)) * _e204) + (1f / 6f)) * _e204) + 0.5f) * _e204) + 1f) * _e204) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e200), i32(-2147483648), (_e200 < bitcast<f32>(3472883712u))), 2147483647i, (_e200 > bitcast<f32>(1325400063u))), (_e200 == _e200)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e240 = phi_419_;
    let _e241 = -(_e240);
    return vec4<f32>(_e151, (_e151 * _e151), _e241, (_e241 * _e241));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_441_: bool;
    var phi_445_: f32;
    var phi_469_: bool;
    var phi_473_: f32;
    var phi_485_: bool;
    var phi_492_: f32;
    var phi_505_: bool;
    var phi_509_: f32;
    var phi_533_: bool;
    var phi_537_: f32;
    var phi_549_: bool;
    var phi_556_: f32;
    var phi_567_: bool;
    var phi_571_: f32;
    var phi_586_: f32;
    var phi_587_: f32;
    var phi_588_: f32;

    let _e54 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e56 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_441_ = true;
    } else {
        let _e60 = (42f < _e56);
        if _e60 {
        }
        phi_441_ = _e60;
    }
    let _e62 = phi_441_;
    if _e62 {
        phi_445_ = 42f;
    } else {
        phi_445_ = _e56;
    }
    let _e64 = phi_445_;
    let _e66 = (*param_6).min_variance;
    let _e70 = (((_e66 * _e64) * _e64) * _e54.y);
    let _e77 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
        phi_469_ = true;
    } else {
        let _e81 = (_e70 > _e77);
        if _e81 {
        }
        phi_469_ = _e81;
    }
    let _e83 = phi_469_;
    if _e83 {
        phi_473_ = _e70;
    } else {
        phi_473_ = _e77;
    }
    let _e85 = phi_473_;
    let _e86 = (_e54.x - param_7.x);
    if (_e86 <= 0f) {
        let _e90 = ((bitcast<u32>(_e85) & 2147483647u) > 2139095040u);
        if _e90 {
        }
        phi_485_ = _e90;
    } else {
        phi_485_ = true;
    }
    let _e92 = phi_485_;
    if _e92 {
        phi_492_ = (_e85 / (_e85 + (_e86 * _e86)));
    } else {
        phi_492_ = 1f;
    }
    let _e97 = phi_492_;
    let _e99 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_505_ = true;
    } else {
        let _e103 = (42f < _e99);
        if _e103 {
        }
        phi_505_ = _e103;
    }
    let _e105 = phi_505_;
    if _e105 {
        phi_509_ = 42f;
    } else {
        phi_509_ = _e99;
    }
    let _e107 = phi_509_;
    let _e109 = (*param_6).min_variance;
    let _e113 = (((_e109 * _e107) * _e107) * _e54.w);
    let _e120 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
        phi_533_ = true;
    } else {
        let _e124 = (_e113 > _e120);
        if _e124 {
        }
        phi_533_ = _e124;
    }
    let _e126 = phi_533_;
    if _e126 {
        phi_537_ = _e113;
    } else {
        phi_537_ = _e120;
    }
    let _e128 = phi_537_;
    let _e129 = (_e54.z - param_7.z);
    if (_e129 <= 0f) {
        let _e133 = ((bitcast<u32>(_e128) & 2147483647u) > 2139095040u);
        if _e133 {
        }
        phi_549_ = _e133;
    } else {
        phi_549_ = true;
    }
    let _e135 = phi_549_;
    if _e135 {
        phi_556_ = (_e128 / (_e128 + (_e129 * _e129)));
    } else {
        phi_556_ = 1f;
    }
    let _e140 = phi_556_;
    if ((bitcast<u32>(_e140) & 2147483647u) > 2139095040u) {
        phi_567_ = true;
    } else {
        let _e144 = (_e140 < _e97);
        if _e144 {
        }
        phi_567_ = _e144;
    }
    let _e146 = phi_567_;
    if _e146 {
        phi_571_ = _e140;
    } else {
        phi_571_ = _e97;
    }
    let _e148 = phi_571_;
    if ((bitcast<u32>(_e148) & 2147483647u) > 2139095040u) {
        phi_588_ = _e148;
    } else {
        if (_e148 < 0f) {
            phi_587_ = 0f;
        } else {
            if (_e148 > 1f) {
                phi_586_ = 1f;
            } else {
                phi_586_ = _e148;
            }
            let _e155 = phi_586_;
            phi_587_ = _e155;
        }
        let _e157 = phi_587_;
        phi_588_ = _e157;
    }
    let _e159 = phi_588_;
    return _e159;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_646_: bool;
    var phi_716_: bool;
    var phi_717_: bool;
    var phi_728_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_729_: bool;
    var phi_730_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_731_: bool;
    var phi_738_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_742_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_816_: bool;
    var phi_825_: bool;
    var phi_834_: bool;
    var phi_835_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_844_: bool;
    var phi_934_: f32;
    var phi_937_: f32;
    var phi_966_: f32;
    var phi_971_: f32;
    var phi_972_: bool;
    var phi_973_: f32;
    var phi_974_: bool;
    var phi_978_: f32;
    var phi_998_: f32;
    var phi_1003_: f32;
    var phi_1004_: bool;
    var phi_1005_: f32;
    var phi_1006_: bool;
    var phi_1010_: f32;
    var phi_1062_: i32;
    var phi_1067_: i32;
    var phi_1072_: i32;
    var phi_1077_: i32;
    var phi_1086_: i32;
    var phi_1091_: i32;
    var phi_1096_: i32;
    var phi_1101_: i32;
    var phi_1196_: bool;
    var phi_1204_: bool;
    var phi_1216_: bool;
    var phi_1217_: bool;
    var phi_1221_: f32;
    var phi_1227_: f32;
    var phi_1229_: evaluate_Verdict;
    var phi_1234_: evaluate_Verdict;
    var phi_1235_: evaluate_Verdict;
    var phi_1239_: bool;
    var phi_1240_: u32;
    var phi_1251_: u32;

    let _e52 = id_1;
    let _e53 = local_2;
    let _e58 = arrayLength((&map.member));
    let _e63 = p.member.size[0u];
    let _e65 = p.member.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e52, _e63, _e65);
    if (bitcast<i32>(_e66.root) != 0i) {
        let _e73 = p.member.projection;
        let _e74 = lt_math_OneLevel(_e73);
        let _e78 = samples.member[_e66.first_primitive].normal[0u];
        let _e80 = global[0u];
        if (_e78 == _e80) {
            let _e83 = samples.member[_e66.first_primitive].normal[1u];
            let _e85 = global[1u];
            if (_e83 == _e85) {
                let _e88 = samples.member[_e66.first_primitive].normal[2u];
                let _e90 = global[2u];
                phi_639_ = (_e88 == _e90);
                phi_640_ = false;
            } else {
                phi_639_ = bool();
                phi_640_ = true;
            }
            let _e93 = phi_639_;
            let _e95 = phi_640_;
            phi_641_ = _e93;
            phi_642_ = _e95;
        } else {
            phi_641_ = bool();
            phi_642_ = true;
        }
        let _e97 = phi_641_;
        let _e99 = phi_642_;
        if _e99 {
            phi_646_ = false;
        } else {
            phi_646_ = _e97;
        }
        let _e101 = phi_646_;
        if !(_e101) {
            let _e104 = samples.member[_e66.first_primitive].position;
            let _e106 = p.member.light.place;
            let _e112 = p.member.light.place[3u];
            let _e119 = (_e106.x - (_e104.x * _e112));
            let _e120 = (_e106.y - (_e104.y * _e112));
            let _e121 = (_e106.z - (_e104.z * _e112));
            let _e123 = samples.member[_e66.first_primitive].normal;
            if ((((_e123.x * _e119) + (_e123.y * _e120)) + (_e123.z * _e121)) > 0f) {
                let _e137 = (((_e119 * _e119) + (_e120 * _e120)) + (_e121 * _e121));
                let _e139 = p.member.light.axis;
                let _e151 = p.member.light.place[3u];
                if (_e151 == 0f) {
                    phi_717_ = true;
                } else {
                    let _e154 = p.member.light.range_squared;
                    if (_e137 <= _e154) {
                        let _e157 = p.member.light.cos_outer;
                        phi_716_ = (-((((_e119 * _e139.x) + (_e120 * _e139.y)) + (_e121 * _e139.z))) >= (_e157 * sqrt(_e137)));
                    } else {
                        phi_716_ = false;
                    }
                    let _e162 = phi_716_;
                    phi_717_ = _e162;
                }
                let _e164 = phi_717_;
                if _e164 {
                    let _e166 = samples.member[_e66.first_primitive].flags;
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e174.unnamed.visibility, false), _e174.unnamed_1);
                    phi_728_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e180.unnamed, ((_e166 & 1u) == 0u));
                    phi_729_ = false;
                } else {
                    phi_728_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_729_ = true;
                }
                let _e185 = phi_728_;
                let _e187 = phi_729_;
                phi_730_ = _e185;
                phi_731_ = _e187;
            } else {
                phi_730_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_731_ = true;
            }
            let _e189 = phi_730_;
            let _e191 = phi_731_;
            if _e191 {
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e197.unnamed.visibility, false), _e197.unnamed_1);
                phi_738_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e203.unnamed, true);
            } else {
                phi_738_ = _e189;
            }
            let _e208 = phi_738_;
            phi_742_ = _e208;
        } else {
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e214.unnamed.visibility, false), _e214.unnamed_1);
            phi_742_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e220.unnamed, true);
        }
        let _e225 = phi_742_;
        if _e225.unnamed_1 {
            phi_1235_ = evaluate_Verdict(_e225.unnamed.visibility, _e225.unnamed.is_doubted);
        } else {
            let _e233 = samples.member[_e66.first_primitive].position;
            let _e251 = ((((_e74.projection.row_w.x * _e233.x) + (_e74.projection.row_w.y * _e233.y)) + (_e74.projection.row_w.z * _e233.z)) + (_e74.projection.row_w.w * 1f));
            let _e265 = (((((_e74.projection.row_x.x * _e233.x) + (_e74.projection.row_x.y * _e233.y)) + (_e74.projection.row_x.z * _e233.z)) + (_e74.projection.row_x.w * 1f)) / _e251);
            let _e279 = (((((_e74.projection.row_y.x * _e233.x) + (_e74.projection.row_y.y * _e233.y)) + (_e74.projection.row_y.z * _e233.z)) + (_e74.projection.row_y.w * 1f)) / _e251);
            let _e292 = ((((_e74.projection.row_z.x * _e233.x) + (_e74.projection.row_z.y * _e233.y)) + (_e74.projection.row_z.z * _e233.z)) + (_e74.projection.row_z.w * 1f));
            if (_e251 > 0f) {
                if (_e265 >= 0f) {
                    phi_816_ = (_e265 <= 1f);
                } else {
                    phi_816_ = false;
                }
                let _e297 = phi_816_;
                if _e297 {
                    if (_e279 >= 0f) {
                        phi_825_ = (_e279 <= 1f);
                    } else {
                        phi_825_ = false;
                    }
                    let _e301 = phi_825_;
                    if _e301 {
                        if (_e292 >= 0f) {
                            phi_834_ = (_e292 <= 1f);
                        } else {
                            phi_834_ = false;
                        }
                        let _e305 = phi_834_;
                        phi_835_ = _e305;
                        phi_836_ = false;
                    } else {
                        phi_835_ = bool();
                        phi_836_ = true;
                    }
                    let _e307 = phi_835_;
                    let _e309 = phi_836_;
                    phi_837_ = _e307;
                    phi_838_ = _e309;
                } else {
                    phi_837_ = bool();
                    phi_838_ = true;
                }
                let _e311 = phi_837_;
                let _e313 = phi_838_;
                phi_839_ = _e311;
                phi_840_ = _e313;
            } else {
                phi_839_ = bool();
                phi_840_ = true;
            }
            let _e315 = phi_839_;
            let _e317 = phi_840_;
            if _e317 {
                phi_844_ = false;
            } else {
                phi_844_ = _e315;
            }
            let _e319 = phi_844_;
            if _e319 {
                if (0f > 0f) {
                    let _e322 = samples.member[_e66.first_primitive].normal;
                    let _e324 = p.member.map_size;
                    let _e394 = ((abs(((((_e73.row_x.x * _e322.x) + (_e73.row_x.y * _e322.y)) + (_e73.row_x.z * _e322.z)) / (((_e73.row_x.x * _e73.row_x.x) + (_e73.row_x.y * _e73.row_x.y)) + (_e73.row_x.z * _e73.row_x.z)))) + abs(((((_e73.row_y.x * _e322.x) + (_e73.row_y.y * _e322.y)) + (_e73.row_y.z * _e322.z)) / (((_e73.row_y.x * _e73.row_y.x) + (_e73.row_y.y * _e73.row_y.y)) + (_e73.row_y.z * _e73.row_y.z))))) / (abs(((((_e73.row_z.x * _e322.x) + (_e73.row_z.y * _e322.y)) + (_e73.row_z.z * _e322.z)) / (((_e73.row_z.x * _e73.row_z.x) + (_e73.row_z.y * _e73.row_z.y)) + (_e73.row_z.z * _e73.row_z.z)))) * f32(_e324)));
                    if (_e394 < 0.002f) {
                        phi_934_ = _e394;
                    } else {
                        phi_934_ = 0.002f;
                    }
                    let _e397 = phi_934_;
                    phi_937_ = (_e292 - (0f * _e397));
                } else {
                    phi_937_ = _e292;
                }
                let _e401 = phi_937_;
                let _e403 = p.member.map_size;
                let _e404 = f32(_e403);
                let _e407 = ((_e265 * _e404) - 0.5f);
                let _e408 = ((_e279 * _e404) - 0.5f);
                if (_e407 > -8388608f) {
                    let _e420 = f32(select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)));
                    if (_e420 > _e407) {
                        phi_966_ = 1f;
                    } else {
                        phi_966_ = 0f;
                    }
                    let _e423 = phi_966_;
                    if (_e407 < 8388608f) {
                        phi_971_ = (_e420 - _e423);
                        phi_972_ = false;
                    } else {
                        phi_971_ = f32();
                        phi_972_ = true;
                    }
                    let _e426 = phi_971_;
                    let _e428 = phi_972_;
                    phi_973_ = _e426;
                    phi_974_ = _e428;
                } else {
                    phi_973_ = f32();
                    phi_974_ = true;
                }
                let _e430 = phi_973_;
                let _e432 = phi_974_;
                if _e432 {
                    phi_978_ = _e407;
                } else {
                    phi_978_ = _e430;
                }
                let _e434 = phi_978_;
                if (_e408 > -8388608f) {
                    let _e446 = f32(select(0i, select(select(i32(_e408), i32(-2147483648), (_e408 < bitcast<f32>(3472883712u))), 2147483647i, (_e408 > bitcast<f32>(1325400063u))), (_e408 == _e408)));
                    if (_e446 > _e408) {
                        phi_998_ = 1f;
                    } else {
                        phi_998_ = 0f;
                    }
                    let _e449 = phi_998_;
                    if (_e408 < 8388608f) {
                        phi_1003_ = (_e446 - _e449);
                        phi_1004_ = false;
                    } else {
                        phi_1003_ = f32();
                        phi_1004_ = true;
                    }
                    let _e452 = phi_1003_;
                    let _e454 = phi_1004_;
                    phi_1005_ = _e452;
                    phi_1006_ = _e454;
                } else {
                    phi_1005_ = f32();
                    phi_1006_ = true;
                }
                let _e456 = phi_1005_;
                let _e458 = phi_1006_;
                if _e458 {
                    phi_1010_ = _e408;
                } else {
                    phi_1010_ = _e456;
                }
                let _e460 = phi_1010_;
                let _e461 = (_e407 - _e434);
                let _e462 = (_e408 - _e460);
                let _e471 = select(0i, select(select(i32(_e434), i32(-2147483648), (_e434 < bitcast<f32>(3472883712u))), 2147483647i, (_e434 > bitcast<f32>(1325400063u))), (_e434 == _e434));
                let _e480 = select(0i, select(select(i32(_e460), i32(-2147483648), (_e460 < bitcast<f32>(3472883712u))), 2147483647i, (_e460 > bitcast<f32>(1325400063u))), (_e460 == _e460));
                let _e483 = ((1f - _e461) * (1f - _e462));
                let _e485 = (_e461 * (1f - _e462));
                let _e487 = ((1f - _e461) * _e462);
                let _e488 = (_e461 * _e462);
                let _e490 = p.member.test;
                let _e491 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e490);
                let _e493 = p.member.map_size;
                local_1 = lt_math_Evsm(_e491.positive_exponent, _e491.negative_exponent, _e491.min_variance);
                let _e499 = ((0u * _e493) * _e493);
                let _e501 = (bitcast<i32>(_e493) - 1i);
                if (_e471 > 0i) {
                    phi_1062_ = _e471;
                } else {
                    phi_1062_ = 0i;
                }
                let _e504 = phi_1062_;
                if (_e480 > 0i) {
                    phi_1067_ = _e480;
                } else {
                    phi_1067_ = 0i;
                }
                let _e507 = phi_1067_;
                if (_e504 < _e501) {
                    phi_1072_ = _e504;
                } else {
                    phi_1072_ = _e501;
                }
                let _e510 = phi_1072_;
                if (_e507 < _e501) {
                    phi_1077_ = _e507;
                } else {
                    phi_1077_ = _e501;
                }
                let _e513 = phi_1077_;
                let _e514 = bitcast<u32>(_e510);
                let _e516 = (_e471 + 1i);
                let _e517 = (_e480 + 1i);
                if (_e516 > 0i) {
                    phi_1086_ = _e516;
                } else {
                    phi_1086_ = 0i;
                }
                let _e520 = phi_1086_;
                if (_e517 > 0i) {
                    phi_1091_ = _e517;
                } else {
                    phi_1091_ = 0i;
                }
                let _e523 = phi_1091_;
                if (_e520 < _e501) {
                    phi_1096_ = _e520;
                } else {
                    phi_1096_ = _e501;
                }
                let _e526 = phi_1096_;
                if (_e523 < _e501) {
                    phi_1101_ = _e523;
                } else {
                    phi_1101_ = _e501;
                }
                let _e529 = phi_1101_;
                let _e530 = bitcast<u32>(_e526);
                let _e532 = (bitcast<u32>(_e513) * _e493);
                let _e533 = (bitcast<u32>(_e529) * _e493);
                let _e538 = ((_e532 + _e514) + _e499);
                let _e539 = ((_e532 + _e530) + _e499);
                let _e540 = ((_e533 + _e514) + _e499);
                let _e541 = ((_e533 + _e530) + _e499);
                if (_e538 < _e58) {
                } else {
                    return;
                }
                let _e545 = map.member[(0u + _e538)];
                if (_e539 < _e58) {
                } else {
                    return;
                }
                let _e557 = map.member[(0u + _e539)];
                if (_e540 < _e58) {
                } else {
                    return;
                }
                let _e573 = map.member[(0u + _e540)];
                if (_e541 < _e58) {
                } else {
                    return;
                }
                let _e589 = map.member[(0u + _e541)];
                let _e603 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e545.x * _e483) + (_e557.x * _e485)) + (_e573.x * _e487)) + (_e589.x * _e488)), ((((_e545.y * _e483) + (_e557.y * _e485)) + (_e573.y * _e487)) + (_e589.y * _e488)), ((((_e545.z * _e483) + (_e557.z * _e485)) + (_e573.z * _e487)) + (_e589.z * _e488)), ((((_e545.w * _e483) + (_e557.w * _e485)) + (_e573.w * _e487)) + (_e589.w * _e488))), _e401);
                let _e605 = p.member.epsilon;
                if (_e603 <= _e605) {
                    phi_1196_ = true;
                } else {
                    phi_1196_ = (_e603 >= (1f - _e605));
                }
                let _e610 = phi_1196_;
                if ((bitcast<u32>(_e603) & 2147483647u) > 2139095040u) {
                    phi_1204_ = true;
                } else {
                    phi_1204_ = !(_e610);
                }
                let _e616 = phi_1204_;
                if _e616 {
                    if (_e603 > 0f) {
                        if (_e603 < 1f) {
                            phi_1216_ = false;
                        } else {
                            phi_1216_ = true;
                        }
                        let _e620 = phi_1216_;
                        phi_1217_ = _e620;
                    } else {
                        phi_1217_ = true;
                    }
                    let _e622 = phi_1217_;
                    if _e622 {
                        phi_1221_ = 0.5f;
                    } else {
                        phi_1221_ = _e603;
                    }
                    let _e624 = phi_1221_;
                    phi_1229_ = evaluate_Verdict(_e624, true);
                } else {
                    if (_e603 > 0.5f) {
                        phi_1227_ = 1f;
                    } else {
                        phi_1227_ = 0f;
                    }
                    let _e628 = phi_1227_;
                    phi_1229_ = evaluate_Verdict(_e628, false);
                }
                let _e631 = phi_1229_;
                phi_1234_ = evaluate_Verdict(_e631.visibility, _e631.is_doubted);
            } else {
                phi_1234_ = evaluate_Verdict(0.5f, true);
            }
            let _e637 = phi_1234_;
            phi_1235_ = _e637;
        }
        let _e639 = phi_1235_;
        visibility.member[_e66.first_primitive] = _e639.visibility;
        phi_1239_ = _e639.is_doubted;
        phi_1240_ = _e66.first_primitive;
    } else {
        phi_1239_ = false;
        phi_1240_ = 0u;
    }
    let _e644 = phi_1239_;
    let _e646 = phi_1240_;
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e644 {
        let _e650 = atomicAdd((&shared_[0u]), 1u);
        phi_1251_ = _e650;
    } else {
        phi_1251_ = 0u;
    }
    let _e652 = phi_1251_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e656 = atomicLoad((&shared_[0u]));
        let _e657 = atomicAdd((&list.member[3u]), _e656);
        atomicStore((&shared_[1u]), _e657);
    }
    workgroupBarrier();
    if _e644 {
        let _e660 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e660) + _e652)]), _e646);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
