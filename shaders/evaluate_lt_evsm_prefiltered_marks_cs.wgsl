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

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
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
@group(0) @binding(2) 
var<storage> map: type_35;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_171_: lt_bvh_traverse_Tree;
    var phi_172_: bool;
    var phi_173_: lt_bvh_traverse_Tree;
    var phi_174_: bool;
    var phi_179_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_171_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_172_ = false;
        } else {
            phi_171_ = lt_bvh_traverse_Tree();
            phi_172_ = true;
        }
        let _e66 = phi_171_;
        let _e68 = phi_172_;
        phi_173_ = _e66;
        phi_174_ = _e68;
    } else {
        phi_173_ = lt_bvh_traverse_Tree();
        phi_174_ = true;
    }
    let _e70 = phi_173_;
    let _e72 = phi_174_;
    if _e72 {
        phi_179_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_179_ = _e70;
    }
    let _e77 = phi_179_;
    return lt_bvh_traverse_Tree(_e77.root, _e77.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_206_: f32;
    var phi_207_: f32;
    var phi_208_: f32;
    var phi_221_: bool;
    var phi_225_: f32;
    var phi_237_: f32;
    var phi_242_: f32;
    var phi_264_: f32;
    var phi_269_: f32;
    var phi_270_: bool;
    var phi_271_: f32;
    var phi_272_: bool;
    var phi_276_: f32;
    var phi_314_: f32;
    var phi_327_: bool;
    var phi_331_: f32;
    var phi_344_: f32;
    var phi_349_: f32;
    var phi_371_: f32;
    var phi_376_: f32;
    var phi_377_: bool;
    var phi_378_: f32;
    var phi_379_: bool;
    var phi_383_: f32;
    var phi_421_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_208_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_207_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_206_ = 1f;
            } else {
                phi_206_ = param_5;
            }
            let _e61 = phi_206_;
            phi_207_ = _e61;
        }
        let _e63 = phi_207_;
        phi_208_ = _e63;
    }
    let _e65 = phi_208_;
    let _e67 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_221_ = true;
    } else {
        let _e71 = (42f < _e67);
        if _e71 {
        }
        phi_221_ = _e71;
    }
    let _e73 = phi_221_;
    if _e73 {
        phi_225_ = 42f;
    } else {
        phi_225_ = _e67;
    }
    let _e75 = phi_225_;
    let _e76 = (_e75 * _e65);
    if ((bitcast<u32>(_e76) & 2147483647u) > 2139095040u) {
        phi_314_ = _e76;
    } else {
        if (_e76 < -87f) {
            phi_237_ = -87f;
        } else {
            phi_237_ = _e76;
        }
        let _e82 = phi_237_;
        if (_e82 > 88f) {
            phi_242_ = 88f;
        } else {
            phi_242_ = _e82;
        }
        let _e85 = phi_242_;
        let _e87 = ((_e85 * 1.442695f) + 0.5f);
        if (_e87 > -8388608f) {
            let _e99 = f32(select(0i, select(select(i32(_e87), i32(-2147483648), (_e87 < bitcast<f32>(3472883712u))), 2147483647i, (_e87 > bitcast<f32>(1325400063u))), (_e87 == _e87)));
            if (_e99 > _e87) {
                phi_264_ = 1f;
            } else {
                phi_264_ = 0f;
            }
            let _e102 = phi_264_;
            if (_e87 < 8388608f) {
                phi_269_ = (_e99 - _e102);
                phi_270_ = false;
            } else {
                phi_269_ = f32();
                phi_270_ = true;
            }
            let _e105 = phi_269_;
            let _e107 = phi_270_;
            phi_271_ = _e105;
            phi_272_ = _e107;
        } else {
            phi_271_ = f32();
            phi_272_ = true;
        }
        let _e109 = phi_271_;
        let _e111 = phi_272_;
        if _e111 {
            phi_276_ = _e87;
        } else {
            phi_276_ = _e109;
        }
        let _e113 = phi_276_;
        let _e117 = ((_e85 - (_e113 * 0.69314575f)) - (_e113 * 0.0000014286068f));
        phi_314_ = ((((((((((((((((1f / 5040f) * _e117) + (1f / 720f)) * _e117) + (1f / 120f)) * _e117) + (1f / 24f)) * _e117) + (1f / 6f)) * _e117) + 0.5f) * _e117) + 1f) * _e117) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e113), i32(-2147483648), (_e113 < bitcast<f32>(3472883712u))), 2147483647i, (_e113 > bitcast<f32>(1325400063u))), (_e113 == _e113)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e153 = phi_314_;
    let _e155 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_327_ = true;
    } else {
        let _e159 = (42f < _e155);
        if _e159 {
        }
        phi_327_ = _e159;
    }
    let _e161 = phi_327_;
    if _e161 {
        phi_331_ = 42f;
    } else {
        phi_331_ = _e155;
    }
    let _e163 = phi_331_;
    let _e165 = (-(_e163) * _e65);
    if ((bitcast<u32>(_e165) & 2147483647u) > 2139095040u) {
        phi_421_ = _e165;
    } else {
        if (_e165 < -87f) {
            phi_344_ = -87f;
        } else {
            phi_344_ = _e165;
        }
        let _e171 = phi_344_;
        if (_e171 > 88f) {
            phi_349_ = 88f;
        } else {
            phi_349_ = _e171;
        }
        let _e174 = phi_349_;
        let _e176 = ((_e174 * 1.442695f) + 0.5f);
        if (_e176 > -8388608f) {
            let _e188 = f32(select(0i, select(select(i32(_e176), i32(-2147483648), (_e176 < bitcast<f32>(3472883712u))), 2147483647i, (_e176 > bitcast<f32>(1325400063u))), (_e176 == _e176)));
            if (_e188 > _e176) {
                phi_371_ = 1f;
            } else {
                phi_371_ = 0f;
            }
            let _e191 = phi_371_;
            if (_e176 < 8388608f) {
                phi_376_ = (_e188 - _e191);
                phi_377_ = false;
            } else {
                phi_376_ = f32();
                phi_377_ = true;
            }
            let _e194 = phi_376_;
            let _e196 = phi_377_;
            phi_378_ = _e194;
            phi_379_ = _e196;
        } else {
            phi_378_ = f32();
            phi_379_ = true;
        }
        let _e198 = phi_378_;
        let _e200 = phi_379_;
        if _e200 {
            phi_383_ = _e176;
        } else {
            phi_383_ = _e198;
        }
        let _e202 = phi_383_;
        let _e206 = ((_e174 - (_e202 * 0.69314575f)) - (_e202 * 0.0000014286068f));
        phi_421_ = ((((((((((((((((1f / 5040f) * _e206) + (1f / 720f)) * _e206) + (1f / 120f)) * _e206) + (1f / 24f)) * _e206) + (1f / 6f)) * _e206) + 0.5f) * _e206) + 1f) * _e206) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e202), i32(-2147483648), (_e202 < bitcast<f32>(3472883712u))), 2147483647i, (_e202 > bitcast<f32>(1325400063u))), (_e202 == _e202)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e242 = phi_421_;
    let _e243 = -(_e242);
    return vec4<f32>(_e153, (_e153 * _e153), _e243, (_e243 * _e243));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
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

    let _e56 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e58 = (*param_6).positive_exponent;
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
    let _e68 = (*param_6).min_variance;
    let _e72 = (((_e68 * _e66) * _e66) * _e56.y);
    let _e79 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
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
    let _e88 = (_e56.x - param_7.x);
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
    let _e101 = (*param_6).negative_exponent;
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
    let _e111 = (*param_6).min_variance;
    let _e115 = (((_e111 * _e109) * _e109) * _e56.w);
    let _e122 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
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
    let _e131 = (_e56.z - param_7.z);
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
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_655_: bool;
    var phi_659_: bool;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_741_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_742_: bool;
    var phi_743_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_744_: bool;
    var phi_751_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_755_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_829_: bool;
    var phi_838_: bool;
    var phi_847_: bool;
    var phi_848_: bool;
    var phi_849_: bool;
    var phi_850_: bool;
    var phi_851_: bool;
    var phi_852_: bool;
    var phi_853_: bool;
    var phi_857_: bool;
    var phi_947_: f32;
    var phi_950_: f32;
    var phi_979_: f32;
    var phi_984_: f32;
    var phi_985_: bool;
    var phi_986_: f32;
    var phi_987_: bool;
    var phi_991_: f32;
    var phi_1011_: f32;
    var phi_1016_: f32;
    var phi_1017_: bool;
    var phi_1018_: f32;
    var phi_1019_: bool;
    var phi_1023_: f32;
    var phi_1077_: i32;
    var phi_1082_: i32;
    var phi_1087_: i32;
    var phi_1092_: i32;
    var phi_1101_: i32;
    var phi_1106_: i32;
    var phi_1111_: i32;
    var phi_1116_: i32;
    var phi_1215_: i32;
    var phi_1220_: i32;
    var phi_1225_: i32;
    var phi_1230_: i32;
    var phi_1249_: i32;
    var phi_1254_: i32;
    var phi_1259_: i32;
    var phi_1264_: i32;
    var phi_1283_: i32;
    var phi_1288_: i32;
    var phi_1293_: i32;
    var phi_1298_: i32;
    var phi_1317_: i32;
    var phi_1322_: i32;
    var phi_1327_: i32;
    var phi_1332_: i32;
    var phi_1410_: bool;
    var phi_1418_: bool;
    var phi_1430_: bool;
    var phi_1431_: bool;
    var phi_1435_: f32;
    var phi_1441_: f32;
    var phi_1443_: evaluate_Verdict;
    var phi_1453_: u32;
    var phi_1462_: f32;
    var phi_1464_: evaluate_Verdict;
    var phi_1465_: bool;
    var phi_1466_: evaluate_Verdict;
    var phi_1467_: bool;
    var phi_1472_: evaluate_Verdict;
    var phi_1477_: evaluate_Verdict;
    var phi_1478_: evaluate_Verdict;

    let _e54 = id_1;
    let _e61 = arrayLength((&map.member));
    let _e67 = arrayLength((&marks.member));
    let _e70 = p.member.size[0u];
    let _e72 = p.member.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e54, _e70, _e72);
    if (bitcast<i32>(_e73.root) != 0i) {
        let _e79 = p.member.projection;
        if (_e73.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e83 = lt_math_OneLevel(_e79);
        let _e87 = samples.member[(0u + _e73.first_primitive)].normal[0u];
        let _e89 = global[0u];
        if (_e87 == _e89) {
            let _e92 = samples.member[(0u + _e73.first_primitive)].normal[1u];
            let _e94 = global[1u];
            if (_e92 == _e94) {
                let _e97 = samples.member[(0u + _e73.first_primitive)].normal[2u];
                let _e99 = global[2u];
                phi_652_ = (_e97 == _e99);
                phi_653_ = false;
            } else {
                phi_652_ = bool();
                phi_653_ = true;
            }
            let _e102 = phi_652_;
            let _e104 = phi_653_;
            phi_654_ = _e102;
            phi_655_ = _e104;
        } else {
            phi_654_ = bool();
            phi_655_ = true;
        }
        let _e106 = phi_654_;
        let _e108 = phi_655_;
        if _e108 {
            phi_659_ = false;
        } else {
            phi_659_ = _e106;
        }
        let _e110 = phi_659_;
        if !(_e110) {
            let _e113 = samples.member[(0u + _e73.first_primitive)].position;
            let _e115 = p.member.light.place;
            let _e121 = p.member.light.place[3u];
            let _e128 = (_e115.x - (_e113.x * _e121));
            let _e129 = (_e115.y - (_e113.y * _e121));
            let _e130 = (_e115.z - (_e113.z * _e121));
            let _e132 = samples.member[(0u + _e73.first_primitive)].normal;
            if ((((_e132.x * _e128) + (_e132.y * _e129)) + (_e132.z * _e130)) > 0f) {
                let _e146 = (((_e128 * _e128) + (_e129 * _e129)) + (_e130 * _e130));
                let _e148 = p.member.light.axis;
                let _e160 = p.member.light.place[3u];
                if (_e160 == 0f) {
                    phi_730_ = true;
                } else {
                    let _e163 = p.member.light.range_squared;
                    if (_e146 <= _e163) {
                        let _e166 = p.member.light.cos_outer;
                        phi_729_ = (-((((_e128 * _e148.x) + (_e129 * _e148.y)) + (_e130 * _e148.z))) >= (_e166 * sqrt(_e146)));
                    } else {
                        phi_729_ = false;
                    }
                    let _e171 = phi_729_;
                    phi_730_ = _e171;
                }
                let _e173 = phi_730_;
                if _e173 {
                    let _e175 = samples.member[(0u + _e73.first_primitive)].flags;
                    let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e189 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e183.unnamed.visibility, false), _e183.unnamed_1);
                    phi_741_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e189.unnamed, ((_e175 & 1u) == 0u));
                    phi_742_ = false;
                } else {
                    phi_741_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_742_ = true;
                }
                let _e194 = phi_741_;
                let _e196 = phi_742_;
                phi_743_ = _e194;
                phi_744_ = _e196;
            } else {
                phi_743_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_744_ = true;
            }
            let _e198 = phi_743_;
            let _e200 = phi_744_;
            if _e200 {
                let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e212 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e206.unnamed.visibility, false), _e206.unnamed_1);
                phi_751_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e212.unnamed, true);
            } else {
                phi_751_ = _e198;
            }
            let _e217 = phi_751_;
            phi_755_ = _e217;
        } else {
            let _e223 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e229 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e223.unnamed.visibility, false), _e223.unnamed_1);
            phi_755_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e229.unnamed, true);
        }
        let _e234 = phi_755_;
        if _e234.unnamed_1 {
            phi_1478_ = evaluate_Verdict(_e234.unnamed.visibility, _e234.unnamed.is_doubted);
        } else {
            let _e242 = samples.member[(0u + _e73.first_primitive)].position;
            let _e260 = ((((_e83.projection.row_w.x * _e242.x) + (_e83.projection.row_w.y * _e242.y)) + (_e83.projection.row_w.z * _e242.z)) + (_e83.projection.row_w.w * 1f));
            let _e274 = (((((_e83.projection.row_x.x * _e242.x) + (_e83.projection.row_x.y * _e242.y)) + (_e83.projection.row_x.z * _e242.z)) + (_e83.projection.row_x.w * 1f)) / _e260);
            let _e288 = (((((_e83.projection.row_y.x * _e242.x) + (_e83.projection.row_y.y * _e242.y)) + (_e83.projection.row_y.z * _e242.z)) + (_e83.projection.row_y.w * 1f)) / _e260);
            let _e301 = ((((_e83.projection.row_z.x * _e242.x) + (_e83.projection.row_z.y * _e242.y)) + (_e83.projection.row_z.z * _e242.z)) + (_e83.projection.row_z.w * 1f));
            if (_e260 > 0f) {
                if (_e274 >= 0f) {
                    phi_829_ = (_e274 <= 1f);
                } else {
                    phi_829_ = false;
                }
                let _e306 = phi_829_;
                if _e306 {
                    if (_e288 >= 0f) {
                        phi_838_ = (_e288 <= 1f);
                    } else {
                        phi_838_ = false;
                    }
                    let _e310 = phi_838_;
                    if _e310 {
                        if (_e301 >= 0f) {
                            phi_847_ = (_e301 <= 1f);
                        } else {
                            phi_847_ = false;
                        }
                        let _e314 = phi_847_;
                        phi_848_ = _e314;
                        phi_849_ = false;
                    } else {
                        phi_848_ = bool();
                        phi_849_ = true;
                    }
                    let _e316 = phi_848_;
                    let _e318 = phi_849_;
                    phi_850_ = _e316;
                    phi_851_ = _e318;
                } else {
                    phi_850_ = bool();
                    phi_851_ = true;
                }
                let _e320 = phi_850_;
                let _e322 = phi_851_;
                phi_852_ = _e320;
                phi_853_ = _e322;
            } else {
                phi_852_ = bool();
                phi_853_ = true;
            }
            let _e324 = phi_852_;
            let _e326 = phi_853_;
            if _e326 {
                phi_857_ = false;
            } else {
                phi_857_ = _e324;
            }
            let _e328 = phi_857_;
            if _e328 {
                if (0f > 0f) {
                    let _e331 = samples.member[(0u + _e73.first_primitive)].normal;
                    let _e333 = p.member.map_size;
                    let _e403 = ((abs(((((_e79.row_x.x * _e331.x) + (_e79.row_x.y * _e331.y)) + (_e79.row_x.z * _e331.z)) / (((_e79.row_x.x * _e79.row_x.x) + (_e79.row_x.y * _e79.row_x.y)) + (_e79.row_x.z * _e79.row_x.z)))) + abs(((((_e79.row_y.x * _e331.x) + (_e79.row_y.y * _e331.y)) + (_e79.row_y.z * _e331.z)) / (((_e79.row_y.x * _e79.row_y.x) + (_e79.row_y.y * _e79.row_y.y)) + (_e79.row_y.z * _e79.row_y.z))))) / (abs(((((_e79.row_z.x * _e331.x) + (_e79.row_z.y * _e331.y)) + (_e79.row_z.z * _e331.z)) / (((_e79.row_z.x * _e79.row_z.x) + (_e79.row_z.y * _e79.row_z.y)) + (_e79.row_z.z * _e79.row_z.z)))) * f32(_e333)));
                    if (_e403 < 0.002f) {
                        phi_947_ = _e403;
                    } else {
                        phi_947_ = 0.002f;
                    }
                    let _e406 = phi_947_;
                    phi_950_ = (_e301 - (0f * _e406));
                } else {
                    phi_950_ = _e301;
                }
                let _e410 = phi_950_;
                let _e412 = p.member.map_size;
                let _e413 = f32(_e412);
                let _e416 = ((_e274 * _e413) - 0.5f);
                let _e417 = ((_e288 * _e413) - 0.5f);
                if (_e416 > -8388608f) {
                    let _e429 = f32(select(0i, select(select(i32(_e416), i32(-2147483648), (_e416 < bitcast<f32>(3472883712u))), 2147483647i, (_e416 > bitcast<f32>(1325400063u))), (_e416 == _e416)));
                    if (_e429 > _e416) {
                        phi_979_ = 1f;
                    } else {
                        phi_979_ = 0f;
                    }
                    let _e432 = phi_979_;
                    if (_e416 < 8388608f) {
                        phi_984_ = (_e429 - _e432);
                        phi_985_ = false;
                    } else {
                        phi_984_ = f32();
                        phi_985_ = true;
                    }
                    let _e435 = phi_984_;
                    let _e437 = phi_985_;
                    phi_986_ = _e435;
                    phi_987_ = _e437;
                } else {
                    phi_986_ = f32();
                    phi_987_ = true;
                }
                let _e439 = phi_986_;
                let _e441 = phi_987_;
                if _e441 {
                    phi_991_ = _e416;
                } else {
                    phi_991_ = _e439;
                }
                let _e443 = phi_991_;
                if (_e417 > -8388608f) {
                    let _e455 = f32(select(0i, select(select(i32(_e417), i32(-2147483648), (_e417 < bitcast<f32>(3472883712u))), 2147483647i, (_e417 > bitcast<f32>(1325400063u))), (_e417 == _e417)));
                    if (_e455 > _e417) {
                        phi_1011_ = 1f;
                    } else {
                        phi_1011_ = 0f;
                    }
                    let _e458 = phi_1011_;
                    if (_e417 < 8388608f) {
                        phi_1016_ = (_e455 - _e458);
                        phi_1017_ = false;
                    } else {
                        phi_1016_ = f32();
                        phi_1017_ = true;
                    }
                    let _e461 = phi_1016_;
                    let _e463 = phi_1017_;
                    phi_1018_ = _e461;
                    phi_1019_ = _e463;
                } else {
                    phi_1018_ = f32();
                    phi_1019_ = true;
                }
                let _e465 = phi_1018_;
                let _e467 = phi_1019_;
                if _e467 {
                    phi_1023_ = _e417;
                } else {
                    phi_1023_ = _e465;
                }
                let _e469 = phi_1023_;
                let _e470 = (_e416 - _e443);
                let _e471 = (_e417 - _e469);
                let _e480 = select(0i, select(select(i32(_e443), i32(-2147483648), (_e443 < bitcast<f32>(3472883712u))), 2147483647i, (_e443 > bitcast<f32>(1325400063u))), (_e443 == _e443));
                let _e489 = select(0i, select(select(i32(_e469), i32(-2147483648), (_e469 < bitcast<f32>(3472883712u))), 2147483647i, (_e469 > bitcast<f32>(1325400063u))), (_e469 == _e469));
                let _e492 = ((1f - _e470) * (1f - _e471));
                let _e494 = (_e470 * (1f - _e471));
                let _e496 = ((1f - _e470) * _e471);
                let _e497 = (_e470 * _e471);
                let _e499 = p.member.test;
                let _e500 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e499);
                let _e502 = p.member.map_size;
                local = lt_math_Evsm(_e500.positive_exponent, _e500.negative_exponent, _e500.min_variance);
                let _e508 = ((0u * _e502) * _e502);
                let _e510 = (bitcast<i32>(_e502) - 1i);
                if (_e480 > 0i) {
                    phi_1077_ = _e480;
                } else {
                    phi_1077_ = 0i;
                }
                let _e513 = phi_1077_;
                if (_e489 > 0i) {
                    phi_1082_ = _e489;
                } else {
                    phi_1082_ = 0i;
                }
                let _e516 = phi_1082_;
                if (_e513 < _e510) {
                    phi_1087_ = _e513;
                } else {
                    phi_1087_ = _e510;
                }
                let _e519 = phi_1087_;
                if (_e516 < _e510) {
                    phi_1092_ = _e516;
                } else {
                    phi_1092_ = _e510;
                }
                let _e522 = phi_1092_;
                let _e523 = bitcast<u32>(_e519);
                let _e525 = (_e480 + 1i);
                let _e526 = (_e489 + 1i);
                if (_e525 > 0i) {
                    phi_1101_ = _e525;
                } else {
                    phi_1101_ = 0i;
                }
                let _e529 = phi_1101_;
                if (_e526 > 0i) {
                    phi_1106_ = _e526;
                } else {
                    phi_1106_ = 0i;
                }
                let _e532 = phi_1106_;
                if (_e529 < _e510) {
                    phi_1111_ = _e529;
                } else {
                    phi_1111_ = _e510;
                }
                let _e535 = phi_1111_;
                if (_e532 < _e510) {
                    phi_1116_ = _e532;
                } else {
                    phi_1116_ = _e510;
                }
                let _e538 = phi_1116_;
                let _e539 = bitcast<u32>(_e535);
                let _e541 = (bitcast<u32>(_e522) * _e502);
                let _e542 = (bitcast<u32>(_e538) * _e502);
                let _e547 = ((_e541 + _e523) + _e508);
                let _e548 = ((_e541 + _e539) + _e508);
                let _e549 = ((_e542 + _e523) + _e508);
                let _e550 = ((_e542 + _e539) + _e508);
                if (_e547 < _e61) {
                } else {
                    return;
                }
                let _e554 = map.member[(0u + _e547)];
                if (_e548 < _e61) {
                } else {
                    return;
                }
                let _e566 = map.member[(0u + _e548)];
                if (_e549 < _e61) {
                } else {
                    return;
                }
                let _e582 = map.member[(0u + _e549)];
                if (_e550 < _e61) {
                } else {
                    return;
                }
                let _e598 = map.member[(0u + _e550)];
                let _e612 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e554.x * _e492) + (_e566.x * _e494)) + (_e582.x * _e496)) + (_e598.x * _e497)), ((((_e554.y * _e492) + (_e566.y * _e494)) + (_e582.y * _e496)) + (_e598.y * _e497)), ((((_e554.z * _e492) + (_e566.z * _e494)) + (_e582.z * _e496)) + (_e598.z * _e497)), ((((_e554.w * _e492) + (_e566.w * _e494)) + (_e582.w * _e496)) + (_e598.w * _e497))), _e410);
                let _e614 = p.member.map_size;
                let _e616 = (bitcast<i32>(_e614) - 1i);
                if (_e480 > 0i) {
                    phi_1215_ = _e480;
                } else {
                    phi_1215_ = 0i;
                }
                let _e619 = phi_1215_;
                if (_e489 > 0i) {
                    phi_1220_ = _e489;
                } else {
                    phi_1220_ = 0i;
                }
                let _e622 = phi_1220_;
                if (_e619 < _e616) {
                    phi_1225_ = _e619;
                } else {
                    phi_1225_ = _e616;
                }
                let _e625 = phi_1225_;
                if (_e622 < _e616) {
                    phi_1230_ = _e622;
                } else {
                    phi_1230_ = _e616;
                }
                let _e628 = phi_1230_;
                let _e629 = bitcast<u32>(_e625);
                let _e636 = ((((0u * _e614) + bitcast<u32>(_e628)) * (_e614 / 16u)) + (_e629 / 16u));
                let _e639 = (_e480 + 1i);
                let _e640 = (_e489 + 0i);
                let _e642 = (bitcast<i32>(_e614) - 1i);
                if (_e639 > 0i) {
                    phi_1249_ = _e639;
                } else {
                    phi_1249_ = 0i;
                }
                let _e645 = phi_1249_;
                if (_e640 > 0i) {
                    phi_1254_ = _e640;
                } else {
                    phi_1254_ = 0i;
                }
                let _e648 = phi_1254_;
                if (_e645 < _e642) {
                    phi_1259_ = _e645;
                } else {
                    phi_1259_ = _e642;
                }
                let _e651 = phi_1259_;
                if (_e648 < _e642) {
                    phi_1264_ = _e648;
                } else {
                    phi_1264_ = _e642;
                }
                let _e654 = phi_1264_;
                let _e655 = bitcast<u32>(_e651);
                let _e662 = ((((0u * _e614) + bitcast<u32>(_e654)) * (_e614 / 16u)) + (_e655 / 16u));
                let _e665 = (_e480 + 0i);
                let _e666 = (_e489 + 1i);
                let _e668 = (bitcast<i32>(_e614) - 1i);
                if (_e665 > 0i) {
                    phi_1283_ = _e665;
                } else {
                    phi_1283_ = 0i;
                }
                let _e671 = phi_1283_;
                if (_e666 > 0i) {
                    phi_1288_ = _e666;
                } else {
                    phi_1288_ = 0i;
                }
                let _e674 = phi_1288_;
                if (_e671 < _e668) {
                    phi_1293_ = _e671;
                } else {
                    phi_1293_ = _e668;
                }
                let _e677 = phi_1293_;
                if (_e674 < _e668) {
                    phi_1298_ = _e674;
                } else {
                    phi_1298_ = _e668;
                }
                let _e680 = phi_1298_;
                let _e681 = bitcast<u32>(_e677);
                let _e688 = ((((0u * _e614) + bitcast<u32>(_e680)) * (_e614 / 16u)) + (_e681 / 16u));
                let _e691 = (_e480 + 1i);
                let _e692 = (_e489 + 1i);
                let _e694 = (bitcast<i32>(_e614) - 1i);
                if (_e691 > 0i) {
                    phi_1317_ = _e691;
                } else {
                    phi_1317_ = 0i;
                }
                let _e697 = phi_1317_;
                if (_e692 > 0i) {
                    phi_1322_ = _e692;
                } else {
                    phi_1322_ = 0i;
                }
                let _e700 = phi_1322_;
                if (_e697 < _e694) {
                    phi_1327_ = _e697;
                } else {
                    phi_1327_ = _e694;
                }
                let _e703 = phi_1327_;
                if (_e700 < _e694) {
                    phi_1332_ = _e700;
                } else {
                    phi_1332_ = _e694;
                }
                let _e706 = phi_1332_;
                let _e707 = bitcast<u32>(_e703);
                let _e714 = ((((0u * _e614) + bitcast<u32>(_e706)) * (_e614 / 16u)) + (_e707 / 16u));
                if (_e636 < _e67) {
                } else {
                    return;
                }
                let _e720 = marks.member[(0u + _e636)];
                if (_e662 < _e67) {
                } else {
                    return;
                }
                let _e728 = marks.member[(0u + _e662)];
                if (_e688 < _e67) {
                } else {
                    return;
                }
                let _e737 = marks.member[(0u + _e688)];
                if (_e714 < _e67) {
                } else {
                    return;
                }
                let _e745 = marks.member[(0u + _e714)];
                let _e753 = p.member.epsilon;
                if (_e612 <= _e753) {
                    phi_1410_ = true;
                } else {
                    phi_1410_ = (_e612 >= (1f - _e753));
                }
                let _e758 = phi_1410_;
                if ((bitcast<u32>(_e612) & 2147483647u) > 2139095040u) {
                    phi_1418_ = true;
                } else {
                    phi_1418_ = !(_e758);
                }
                let _e764 = phi_1418_;
                if _e764 {
                    if (_e612 > 0f) {
                        if (_e612 < 1f) {
                            phi_1430_ = false;
                        } else {
                            phi_1430_ = true;
                        }
                        let _e768 = phi_1430_;
                        phi_1431_ = _e768;
                    } else {
                        phi_1431_ = true;
                    }
                    let _e770 = phi_1431_;
                    if _e770 {
                        phi_1435_ = 0.5f;
                    } else {
                        phi_1435_ = _e612;
                    }
                    let _e772 = phi_1435_;
                    phi_1443_ = evaluate_Verdict(_e772, true);
                } else {
                    if (_e612 > 0.5f) {
                        phi_1441_ = 1f;
                    } else {
                        phi_1441_ = 0f;
                    }
                    let _e776 = phi_1441_;
                    phi_1443_ = evaluate_Verdict(_e776, false);
                }
                let _e779 = phi_1443_;
                let _e782 = (_e779.visibility < 0.5f);
                if _e779.is_doubted {
                    phi_1466_ = evaluate_Verdict();
                    phi_1467_ = true;
                } else {
                    if _e782 {
                        phi_1453_ = 2u;
                    } else {
                        phi_1453_ = 1u;
                    }
                    let _e784 = phi_1453_;
                    if ((((((_e720 >> bitcast<u32>((((_e629 % 16u) * 2u) & 31u))) & 3u) | ((_e728 >> bitcast<u32>((((_e655 % 16u) * 2u) & 31u))) & 3u)) | (((_e737 >> bitcast<u32>((((_e681 % 16u) * 2u) & 31u))) & 3u) | ((_e745 >> bitcast<u32>((((_e707 % 16u) * 2u) & 31u))) & 3u))) & _e784) != 0u) {
                        if _e782 {
                            phi_1462_ = 0.000000059604645f;
                        } else {
                            phi_1462_ = 0.99999994f;
                        }
                        let _e788 = phi_1462_;
                        phi_1464_ = evaluate_Verdict(_e788, true);
                        phi_1465_ = false;
                    } else {
                        phi_1464_ = evaluate_Verdict();
                        phi_1465_ = true;
                    }
                    let _e791 = phi_1464_;
                    let _e793 = phi_1465_;
                    phi_1466_ = _e791;
                    phi_1467_ = _e793;
                }
                let _e795 = phi_1466_;
                let _e797 = phi_1467_;
                if _e797 {
                    phi_1472_ = evaluate_Verdict(_e779.visibility, _e779.is_doubted);
                } else {
                    phi_1472_ = _e795;
                }
                let _e800 = phi_1472_;
                phi_1477_ = evaluate_Verdict(_e800.visibility, _e800.is_doubted);
            } else {
                phi_1477_ = evaluate_Verdict(0.5f, true);
            }
            let _e806 = phi_1477_;
            phi_1478_ = _e806;
        }
        let _e808 = phi_1478_;
        if (_e73.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.first_primitive)] = _e808.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_prefiltered_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
