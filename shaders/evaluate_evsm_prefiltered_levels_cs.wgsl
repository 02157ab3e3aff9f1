struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct type_15 {
    member: array<abi_Sample>,
}

struct type_19 {
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

struct type_31 {
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

struct type_35 {
    member: abi_ShadowParams,
}

struct type_39 {
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
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_39;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_167_: lt_bvh_traverse_Tree;
    var phi_168_: bool;
    var phi_173_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_165_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_166_ = false;
        } else {
            phi_165_ = lt_bvh_traverse_Tree();
            phi_166_ = true;
        }
        let _e66 = phi_165_;
        let _e68 = phi_166_;
        phi_167_ = _e66;
        phi_168_ = _e68;
    } else {
        phi_167_ = lt_bvh_traverse_Tree();
        phi_168_ = true;
    }
    let _e70 = phi_167_;
    let _e72 = phi_168_;
    if _e72 {
        phi_173_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_173_ = _e70;
    }
    let _e77 = phi_173_;
    return lt_bvh_traverse_Tree(_e77.root, _e77.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_202_: f32;
    var phi_215_: bool;
    var phi_219_: f32;
    var phi_231_: f32;
    var phi_236_: f32;
    var phi_258_: f32;
    var phi_263_: f32;
    var phi_264_: bool;
    var phi_265_: f32;
    var phi_266_: bool;
    var phi_270_: f32;
    var phi_308_: f32;
    var phi_321_: bool;
    var phi_325_: f32;
    var phi_338_: f32;
    var phi_343_: f32;
    var phi_365_: f32;
    var phi_370_: f32;
    var phi_371_: bool;
    var phi_372_: f32;
    var phi_373_: bool;
    var phi_377_: f32;
    var phi_415_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_202_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_201_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_200_ = 1f;
            } else {
                phi_200_ = param_5;
            }
            let _e61 = phi_200_;
            phi_201_ = _e61;
        }
        let _e63 = phi_201_;
        phi_202_ = _e63;
    }
    let _e65 = phi_202_;
    let _e67 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_215_ = true;
    } else {
        let _e71 = (42f < _e67);
        if _e71 {
        }
        phi_215_ = _e71;
    }
    let _e73 = phi_215_;
    if _e73 {
        phi_219_ = 42f;
    } else {
        phi_219_ = _e67;
    }
    let _e75 = phi_219_;
    let _e76 = (_e75 * _e65);
    if ((bitcast<u32>(_e76) & 2147483647u) > 2139095040u) {
        phi_308_ = _e76;
    } else {
        if (_e76 < -87f) {
            phi_231_ = -87f;
        } else {
            phi_231_ = _e76;
        }
        let _e82 = phi_231_;
        if (_e82 > 88f) {
            phi_236_ = 88f;
        } else {
            phi_236_ = _e82;
        }
        let _e85 = phi_236_;
        let _e87 = ((_e85 * 1.442695f) + 0.5f);
        if (_e87 > -8388608f) {
            let _e99 = f32(select(0i, select(select(i32(_e87), i32(-2147483648), (_e87 < bitcast<f32>(3472883712u))), 2147483647i, (_e87 > bitcast<f32>(1325400063u))), (_e87 == _e87)));
            if (_e99 > _e87) {
                phi_258_ = 1f;
            } else {
                phi_258_ = 0f;
            }
            let _e102 = phi_258_;
            if (_e87 < 8388608f) {
                phi_263_ = (_e99 - _e102);
                phi_264_ = false;
            } else {
                phi_263_ = f32();
                phi_264_ = true;
            }
            let _e105 = phi_263_;
            let _e107 = phi_264_;
            phi_265_ = _e105;
            phi_266_ = _e107;
        } else {
            phi_265_ = f32();
            phi_266_ = true;
        }
        let _e109 = phi_265_;
        let _e111 = phi_266_;
        if _e111 {
            phi_270_ = _e87;
        } else {
            phi_270_ = _e109;
        }
        let _e113 = phi_270_;
        let _e117 = ((_e85 - (_e113 * 0.69314575f)) - (_e113 * 0.0000014286068f));
        phi_308_ = ((((((((((((((((1f / 5040f) * _e117) + (1f / 720f)) * _e117) + (1f / 120f)) * _e117) + (1f / 24f)) * _e117) + (1f / 6f)) * _e117) + 0.5f) * _e117) + 1f) * _e117) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e113), i32(-2147483648), (_e113 < bitcast<f32>(3472883712u))), 2147483647i, (_e113 > bitcast<f32>(1325400063u))), (_e113 == _e113)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e153 = phi_308_;
    let _e155 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_321_ = true;
    } else {
        let _e159 = (42f < _e155);
        if _e159 {
        }
        phi_321_ = _e159;
    }
    let _e161 = phi_321_;
    if _e161 {
        phi_325_ = 42f;
    } else {
        phi_325_ = _e155;
    }
    let _e163 = phi_325_;
    let _e165 = (-(_e163) * _e65);
    if ((bitcast<u32>(_e165) & 2147483647u) > 2139095040u) {
        phi_415_ = _e165;
    } else {
        if (_e165 < -87f) {
            phi_338_ = -87f;
        } else {
            phi_338_ = _e165;
        }
        let _e171 = phi_338_;
        if (_e171 > 88f) {
            phi_343_ = 88f;
        } else {
            phi_343_ = _e171;
        }
        let _e174 = phi_343_;
        let _e176 = ((_e174 * 1.442695f) + 0.5f);
        if (_e176 > -8388608f) {
            let _e188 = f32(select(0i, select(select(i32(_e176), i32(-2147483648), (_e176 < bitcast<f32>(3472883712u))), 2147483647i, (_e176 > bitcast<f32>(1325400063u))), (_e176 == _e176)));
            if (_e188 > _e176) {
                phi_365_ = 1f;
            } else {
                phi_365_ = 0f;
            }
            let _e191 = phi_365_;
            if (_e176 < 8388608f) {
                phi_370_ = (_e188 - _e191);
                phi_371_ = false;
            } else {
                phi_370_ = f32();
                phi_371_ = true;
            }
            let _e194 = phi_370_;
            let _e196 = phi_371_;
            phi_372_ = _e194;
            phi_373_ = _e196;
        } else {
            phi_372_ = f32();
            phi_373_ = true;
        }
        let _e198 = phi_372_;
        let _e200 = phi_373_;
        if _e200 {
            phi_377_ = _e176;
        } else {
            phi_377_ = _e198;
        }
        let _e202 = phi_377_;
        let _e206 = ((_e174 - (_e202 * 0.69314575f)) - (_e202 * 0.0000014286068f));
        phi_415_ = ((((((((((((((((1f / 5040f) * _e206) + (1f / 720f)) * _e206) + (1f / 120f)) * _e206) + (1f / 24f)) * _e206) + (1f / 6f)) * _e206) + 0.5f) * _e206) + 1f) * _e206) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e202), i32(-2147483648), (_e202 < bitcast<f32>(3472883712u))), 2147483647i, (_e202 > bitcast<f32>(1325400063u))), (_e202 == _e202)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e242 = phi_415_;
    let _e243 = -(_e242);
    return vec4<f32>(_e153, (_e153 * _e153), _e243, (_e243 * _e243));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_437_: bool;
    var phi_441_: f32;
    var phi_465_: bool;
    var phi_469_: f32;
    var phi_481_: bool;
    var phi_488_: f32;
    var phi_501_: bool;
    var phi_505_: f32;
    var phi_529_: bool;
    var phi_533_: f32;
    var phi_545_: bool;
    var phi_552_: f32;
    var phi_563_: bool;
    var phi_567_: f32;
    var phi_582_: f32;
    var phi_583_: f32;
    var phi_584_: f32;

    let _e56 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e58 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_437_ = true;
    } else {
        let _e62 = (42f < _e58);
        if _e62 {
        }
        phi_437_ = _e62;
    }
    let _e64 = phi_437_;
    if _e64 {
        phi_441_ = 42f;
    } else {
        phi_441_ = _e58;
    }
    let _e66 = phi_441_;
    let _e68 = (*param_6).min_variance;
    let _e72 = (((_e68 * _e66) * _e66) * _e56.y);
    let _e79 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u) {
        phi_465_ = true;
    } else {
        let _e83 = (_e72 > _e79);
        if _e83 {
        }
        phi_465_ = _e83;
    }
    let _e85 = phi_465_;
    if _e85 {
        phi_469_ = _e72;
    } else {
        phi_469_ = _e79;
    }
    let _e87 = phi_469_;
    let _e88 = (_e56.x - param_7.x);
    if (_e88 <= 0f) {
        let _e92 = ((bitcast<u32>(_e87) & 2147483647u) > 2139095040u);
        if _e92 {
        }
        phi_481_ = _e92;
    } else {
        phi_481_ = true;
    }
    let _e94 = phi_481_;
    if _e94 {
        phi_488_ = (_e87 / (_e87 + (_e88 * _e88)));
    } else {
        phi_488_ = 1f;
    }
    let _e99 = phi_488_;
    let _e101 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_501_ = true;
    } else {
        let _e105 = (42f < _e101);
        if _e105 {
        }
        phi_501_ = _e105;
    }
    let _e107 = phi_501_;
    if _e107 {
        phi_505_ = 42f;
    } else {
        phi_505_ = _e101;
    }
    let _e109 = phi_505_;
    let _e111 = (*param_6).min_variance;
    let _e115 = (((_e111 * _e109) * _e109) * _e56.w);
    let _e122 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
        phi_529_ = true;
    } else {
        let _e126 = (_e115 > _e122);
        if _e126 {
        }
        phi_529_ = _e126;
    }
    let _e128 = phi_529_;
    if _e128 {
        phi_533_ = _e115;
    } else {
        phi_533_ = _e122;
    }
    let _e130 = phi_533_;
    let _e131 = (_e56.z - param_7.z);
    if (_e131 <= 0f) {
        let _e135 = ((bitcast<u32>(_e130) & 2147483647u) > 2139095040u);
        if _e135 {
        }
        phi_545_ = _e135;
    } else {
        phi_545_ = true;
    }
    let _e137 = phi_545_;
    if _e137 {
        phi_552_ = (_e130 / (_e130 + (_e131 * _e131)));
    } else {
        phi_552_ = 1f;
    }
    let _e142 = phi_552_;
    if ((bitcast<u32>(_e142) & 2147483647u) > 2139095040u) {
        phi_563_ = true;
    } else {
        let _e146 = (_e142 < _e99);
        if _e146 {
        }
        phi_563_ = _e146;
    }
    let _e148 = phi_563_;
    if _e148 {
        phi_567_ = _e142;
    } else {
        phi_567_ = _e99;
    }
    let _e150 = phi_567_;
    if ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u) {
        phi_584_ = _e150;
    } else {
        if (_e150 < 0f) {
            phi_583_ = 0f;
        } else {
            if (_e150 > 1f) {
                phi_582_ = 1f;
            } else {
                phi_582_ = _e150;
            }
            let _e157 = phi_582_;
            phi_583_ = _e157;
        }
        let _e159 = phi_583_;
        phi_584_ = _e159;
    }
    let _e161 = phi_584_;
    return _e161;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_651_: bool;
    var phi_721_: bool;
    var phi_722_: bool;
    var phi_733_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_734_: bool;
    var phi_735_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_736_: bool;
    var phi_743_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_747_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_767_: lt_math_LightPoint;
    var phi_770_: u32;
    var phi_772_: lt_math_LevelPoint;
    var phi_858_: bool;
    var phi_867_: bool;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_878_: bool;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_886_: bool;
    var phi_913_: bool;
    var phi_914_: bool;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_917_: bool;
    var phi_918_: bool;
    var phi_919_: bool;
    var phi_920_: bool;
    var phi_924_: bool;
    var phi_933_: lt_math_LightPoint;
    var phi_934_: u32;
    var phi_935_: lt_math_LevelPoint;
    var phi_936_: bool;
    var phi_768_: lt_math_LightPoint;
    var phi_771_: u32;
    var phi_773_: lt_math_LevelPoint;
    var phi_937_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_977_: bool;
    var phi_978_: bool;
    var phi_979_: bool;
    var phi_980_: bool;
    var phi_984_: bool;
    var phi_1066_: f32;
    var phi_1184_: f32;
    var phi_1185_: f32;
    var phi_1188_: f32;
    var phi_1217_: f32;
    var phi_1222_: f32;
    var phi_1223_: bool;
    var phi_1224_: f32;
    var phi_1225_: bool;
    var phi_1229_: f32;
    var phi_1249_: f32;
    var phi_1254_: f32;
    var phi_1255_: bool;
    var phi_1256_: f32;
    var phi_1257_: bool;
    var phi_1261_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1314_: i32;
    var phi_1319_: i32;
    var phi_1324_: i32;
    var phi_1329_: i32;
    var phi_1338_: i32;
    var phi_1343_: i32;
    var phi_1348_: i32;
    var phi_1353_: i32;
    var phi_1442_: evaluate_Verdict;
    var phi_1443_: evaluate_Verdict;
    var phi_1444_: bool;
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
        let _e86 = samples.member[(0u + _e73.first_primitive)].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[(0u + _e73.first_primitive)].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[(0u + _e73.first_primitive)].normal[2u];
                let _e98 = global[2u];
                phi_644_ = (_e96 == _e98);
                phi_645_ = false;
            } else {
                phi_644_ = bool();
                phi_645_ = true;
            }
            let _e101 = phi_644_;
            let _e103 = phi_645_;
            phi_646_ = _e101;
            phi_647_ = _e103;
        } else {
            phi_646_ = bool();
            phi_647_ = true;
        }
        let _e105 = phi_646_;
        let _e107 = phi_647_;
        if _e107 {
            phi_651_ = false;
        } else {
            phi_651_ = _e105;
        }
        let _e109 = phi_651_;
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
                    phi_722_ = true;
                } else {
                    let _e162 = p.member.light.range_squared;
                    if (_e145 <= _e162) {
                        let _e165 = p.member.light.cos_outer;
                        phi_721_ = (-((((_e127 * _e147.x) + (_e128 * _e147.y)) + (_e129 * _e147.z))) >= (_e165 * sqrt(_e145)));
                    } else {
                        phi_721_ = false;
                    }
                    let _e170 = phi_721_;
                    phi_722_ = _e170;
                }
                let _e172 = phi_722_;
                if _e172 {
                    let _e174 = samples.member[(0u + _e73.first_primitive)].flags;
                    let _e182 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e182.unnamed.visibility, false), _e182.unnamed_1);
                    phi_733_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e188.unnamed, ((_e174 & 1u) == 0u));
                    phi_734_ = false;
                } else {
                    phi_733_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_734_ = true;
                }
                let _e193 = phi_733_;
                let _e195 = phi_734_;
                phi_735_ = _e193;
                phi_736_ = _e195;
            } else {
                phi_735_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_736_ = true;
            }
            let _e197 = phi_735_;
            let _e199 = phi_736_;
            if _e199 {
                let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
                phi_743_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
            } else {
                phi_743_ = _e197;
            }
            let _e216 = phi_743_;
            phi_747_ = _e216;
        } else {
            let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
            phi_747_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, true);
        }
        let _e233 = phi_747_;
        if _e233.unnamed_1 {
            phi_1445_ = evaluate_Verdict(_e233.unnamed.visibility, _e233.unnamed.is_doubted);
            phi_1446_ = evaluate_Verdict();
            phi_1447_ = true;
        } else {
            let _e241 = samples.member[(0u + _e73.first_primitive)].position;
            let _e243 = p.member.map_size;
            let _e245 = (0.5f / f32(_e243));
            let _e252 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e259 = lt_math_LightPoint(vec2<f32>(_e252.uv.x, 0f), _e252.depth, _e252.is_inside);
            let _e263 = lt_math_LightPoint(_e259.uv, 0f, _e259.is_inside);
            phi_767_ = lt_math_LightPoint();
            phi_770_ = 0u;
            phi_772_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e263.uv, _e263.depth, false));
            loop {
                let _e270 = phi_767_;
                let _e272 = phi_770_;
                let _e274 = phi_772_;
                local_1 = _e274;
                local_2 = _e274;
                local_3 = _e274;
                if (_e272 < _e79) {
                    if _e274.point.is_inside {
                        phi_933_ = lt_math_LightPoint();
                        phi_934_ = u32();
                        phi_935_ = lt_math_LevelPoint();
                        phi_936_ = false;
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
                                phi_858_ = (_e310 <= 1f);
                            } else {
                                phi_858_ = false;
                            }
                            let _e342 = phi_858_;
                            if _e342 {
                                if (_e324 >= 0f) {
                                    phi_867_ = (_e324 <= 1f);
                                } else {
                                    phi_867_ = false;
                                }
                                let _e346 = phi_867_;
                                if _e346 {
                                    if (_e337 >= 0f) {
                                        phi_876_ = (_e337 <= 1f);
                                    } else {
                                        phi_876_ = false;
                                    }
                                    let _e350 = phi_876_;
                                    phi_877_ = _e350;
                                    phi_878_ = false;
                                } else {
                                    phi_877_ = bool();
                                    phi_878_ = true;
                                }
                                let _e352 = phi_877_;
                                let _e354 = phi_878_;
                                phi_879_ = _e352;
                                phi_880_ = _e354;
                            } else {
                                phi_879_ = bool();
                                phi_880_ = true;
                            }
                            let _e356 = phi_879_;
                            let _e358 = phi_880_;
                            phi_881_ = _e356;
                            phi_882_ = _e358;
                        } else {
                            phi_881_ = bool();
                            phi_882_ = true;
                        }
                        let _e360 = phi_881_;
                        let _e362 = phi_882_;
                        if _e362 {
                            phi_886_ = false;
                        } else {
                            phi_886_ = _e360;
                        }
                        let _e364 = phi_886_;
                        if _e364 {
                            if (_e310 >= _e245) {
                                if (_e310 <= (1f - _e245)) {
                                    if (_e324 >= _e245) {
                                        phi_913_ = (_e324 <= (1f - _e245));
                                        phi_914_ = false;
                                    } else {
                                        phi_913_ = bool();
                                        phi_914_ = true;
                                    }
                                    let _e372 = phi_913_;
                                    let _e374 = phi_914_;
                                    phi_915_ = _e372;
                                    phi_916_ = _e374;
                                } else {
                                    phi_915_ = bool();
                                    phi_916_ = true;
                                }
                                let _e376 = phi_915_;
                                let _e378 = phi_916_;
                                phi_917_ = _e376;
                                phi_918_ = _e378;
                            } else {
                                phi_917_ = bool();
                                phi_918_ = true;
                            }
                            let _e380 = phi_917_;
                            let _e382 = phi_918_;
                            phi_919_ = _e380;
                            phi_920_ = _e382;
                        } else {
                            phi_919_ = bool();
                            phi_920_ = true;
                        }
                        let _e384 = phi_919_;
                        let _e386 = phi_920_;
                        if _e386 {
                            phi_924_ = false;
                        } else {
                            phi_924_ = _e384;
                        }
                        let _e388 = phi_924_;
                        let _e395 = lt_math_LightPoint(vec2<f32>(_e310, _e270.uv.y), _e270.depth, _e270.is_inside);
                        let _e402 = lt_math_LightPoint(vec2<f32>(_e395.uv.x, _e324), _e395.depth, _e395.is_inside);
                        let _e406 = lt_math_LightPoint(_e402.uv, _e337, _e402.is_inside);
                        let _e410 = lt_math_LightPoint(_e406.uv, _e406.depth, _e388);
                        phi_933_ = _e410;
                        phi_934_ = (_e272 + 1u);
                        phi_935_ = lt_math_LevelPoint(_e272, _e410);
                        phi_936_ = true;
                    }
                    let _e414 = phi_933_;
                    let _e416 = phi_934_;
                    let _e418 = phi_935_;
                    let _e420 = phi_936_;
                    phi_768_ = _e414;
                    phi_771_ = _e416;
                    phi_773_ = _e418;
                    phi_937_ = _e420;
                } else {
                    phi_768_ = lt_math_LightPoint();
                    phi_771_ = u32();
                    phi_773_ = lt_math_LevelPoint();
                    phi_937_ = false;
                }
                let _e422 = phi_768_;
                let _e424 = phi_771_;
                let _e426 = phi_773_;
                let _e428 = phi_937_;
                continue;
                continuing {
                    phi_767_ = _e422;
                    phi_770_ = _e424;
                    phi_772_ = _e426;
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
                            phi_977_ = (_e442.row_w.z == _e454);
                            phi_978_ = false;
                        } else {
                            phi_977_ = bool();
                            phi_978_ = true;
                        }
                        let _e457 = phi_977_;
                        let _e459 = phi_978_;
                        phi_979_ = _e457;
                        phi_980_ = _e459;
                    } else {
                        phi_979_ = bool();
                        phi_980_ = true;
                    }
                    let _e461 = phi_979_;
                    let _e463 = phi_980_;
                    if _e463 {
                        phi_984_ = false;
                    } else {
                        phi_984_ = _e461;
                    }
                    let _e465 = phi_984_;
                    if _e465 {
                        let _e467 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e469 = p.member.map_size;
                        let _e539 = ((abs(((((_e442.row_x.x * _e467.x) + (_e442.row_x.y * _e467.y)) + (_e442.row_x.z * _e467.z)) / (((_e442.row_x.x * _e442.row_x.x) + (_e442.row_x.y * _e442.row_x.y)) + (_e442.row_x.z * _e442.row_x.z)))) + abs(((((_e442.row_y.x * _e467.x) + (_e442.row_y.y * _e467.y)) + (_e442.row_y.z * _e467.z)) / (((_e442.row_y.x * _e442.row_y.x) + (_e442.row_y.y * _e442.row_y.y)) + (_e442.row_y.z * _e442.row_y.z))))) / (abs(((((_e442.row_z.x * _e467.x) + (_e442.row_z.y * _e467.y)) + (_e442.row_z.z * _e467.z)) / (((_e442.row_z.x * _e442.row_z.x) + (_e442.row_z.y * _e442.row_z.y)) + (_e442.row_z.z * _e442.row_z.z)))) * f32(_e469)));
                        if (_e539 < 0.002f) {
                            phi_1066_ = _e539;
                        } else {
                            phi_1066_ = 0.002f;
                        }
                        let _e542 = phi_1066_;
                        phi_1185_ = _e542;
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
                        let _e658 = (16f / f32(_e544));
                        if (_e656 < _e658) {
                            phi_1184_ = _e656;
                        } else {
                            phi_1184_ = _e658;
                        }
                        let _e661 = phi_1184_;
                        phi_1185_ = _e661;
                    }
                    let _e663 = phi_1185_;
                    phi_1188_ = (_e431.point.depth - (0f * _e663));
                } else {
                    phi_1188_ = _e431.point.depth;
                }
                let _e667 = phi_1188_;
                let _e673 = p.member.map_size;
                let _e674 = f32(_e673);
                let _e677 = ((_e431.point.uv.x * _e674) - 0.5f);
                let _e678 = ((_e431.point.uv.y * _e674) - 0.5f);
                if (_e677 > -8388608f) {
                    let _e690 = f32(select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < bitcast<f32>(3472883712u))), 2147483647i, (_e677 > bitcast<f32>(1325400063u))), (_e677 == _e677)));
                    if (_e690 > _e677) {
                        phi_1217_ = 1f;
                    } else {
                        phi_1217_ = 0f;
                    }
                    let _e693 = phi_1217_;
                    if (_e677 < 8388608f) {
                        phi_1222_ = (_e690 - _e693);
                        phi_1223_ = false;
                    } else {
                        phi_1222_ = f32();
                        phi_1223_ = true;
                    }
                    let _e696 = phi_1222_;
                    let _e698 = phi_1223_;
                    phi_1224_ = _e696;
                    phi_1225_ = _e698;
                } else {
                    phi_1224_ = f32();
                    phi_1225_ = true;
                }
                let _e700 = phi_1224_;
                let _e702 = phi_1225_;
                if _e702 {
                    phi_1229_ = _e677;
                } else {
                    phi_1229_ = _e700;
                }
                let _e704 = phi_1229_;
                if (_e678 > -8388608f) {
                    let _e716 = f32(select(0i, select(select(i32(_e678), i32(-2147483648), (_e678 < bitcast<f32>(3472883712u))), 2147483647i, (_e678 > bitcast<f32>(1325400063u))), (_e678 == _e678)));
                    if (_e716 > _e678) {
                        phi_1249_ = 1f;
                    } else {
                        phi_1249_ = 0f;
                    }
                    let _e719 = phi_1249_;
                    if (_e678 < 8388608f) {
                        phi_1254_ = (_e716 - _e719);
                        phi_1255_ = false;
                    } else {
                        phi_1254_ = f32();
                        phi_1255_ = true;
                    }
                    let _e722 = phi_1254_;
                    let _e724 = phi_1255_;
                    phi_1256_ = _e722;
                    phi_1257_ = _e724;
                } else {
                    phi_1256_ = f32();
                    phi_1257_ = true;
                }
                let _e726 = phi_1256_;
                let _e728 = phi_1257_;
                if _e728 {
                    phi_1261_ = _e678;
                } else {
                    phi_1261_ = _e726;
                }
                let _e730 = phi_1261_;
                let _e731 = (_e677 - _e704);
                let _e732 = (_e678 - _e730);
                let _e741 = select(0i, select(select(i32(_e704), i32(-2147483648), (_e704 < bitcast<f32>(3472883712u))), 2147483647i, (_e704 > bitcast<f32>(1325400063u))), (_e704 == _e704));
                let _e750 = select(0i, select(select(i32(_e730), i32(-2147483648), (_e730 < bitcast<f32>(3472883712u))), 2147483647i, (_e730 > bitcast<f32>(1325400063u))), (_e730 == _e730));
                let _e753 = ((1f - _e731) * (1f - _e732));
                let _e755 = (_e731 * (1f - _e732));
                let _e757 = ((1f - _e731) * _e732);
                let _e758 = (_e731 * _e732);
                let _e760 = p.member.test;
                let _e761 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e760);
                let _e763 = p.member.map_size;
                let _e765 = local_3;
                local = lt_math_Evsm(_e761.positive_exponent, _e761.negative_exponent, _e761.min_variance);
                let _e772 = ((_e765.level * _e763) * _e763);
                let _e774 = (bitcast<i32>(_e763) - 1i);
                if (_e741 > 0i) {
                    phi_1314_ = _e741;
                } else {
                    phi_1314_ = 0i;
                }
                let _e777 = phi_1314_;
                if (_e750 > 0i) {
                    phi_1319_ = _e750;
                } else {
                    phi_1319_ = 0i;
                }
                let _e780 = phi_1319_;
                if (_e777 < _e774) {
                    phi_1324_ = _e777;
                } else {
                    phi_1324_ = _e774;
                }
                let _e783 = phi_1324_;
                if (_e780 < _e774) {
                    phi_1329_ = _e780;
                } else {
                    phi_1329_ = _e774;
                }
                let _e786 = phi_1329_;
                let _e787 = bitcast<u32>(_e783);
                let _e789 = (_e741 + 1i);
                let _e790 = (_e750 + 1i);
                if (_e789 > 0i) {
                    phi_1338_ = _e789;
                } else {
                    phi_1338_ = 0i;
                }
                let _e793 = phi_1338_;
                if (_e790 > 0i) {
                    phi_1343_ = _e790;
                } else {
                    phi_1343_ = 0i;
                }
                let _e796 = phi_1343_;
                if (_e793 < _e774) {
                    phi_1348_ = _e793;
                } else {
                    phi_1348_ = _e774;
                }
                let _e799 = phi_1348_;
                if (_e796 < _e774) {
                    phi_1353_ = _e796;
                } else {
                    phi_1353_ = _e774;
                }
                let _e802 = phi_1353_;
                let _e803 = bitcast<u32>(_e799);
                let _e805 = (bitcast<u32>(_e786) * _e763);
                let _e806 = (bitcast<u32>(_e802) * _e763);
                let _e811 = ((_e805 + _e787) + _e772);
                let _e812 = ((_e805 + _e803) + _e772);
                let _e813 = ((_e806 + _e787) + _e772);
                let _e814 = ((_e806 + _e803) + _e772);
                if (_e811 < _e61) {
                } else {
                    return;
                }
                let _e818 = map.member[(0u + _e811)];
                if (_e812 < _e61) {
                } else {
                    return;
                }
                let _e830 = map.member[(0u + _e812)];
                if (_e813 < _e61) {
                } else {
                    return;
                }
                let _e846 = map.member[(0u + _e813)];
                if (_e814 < _e61) {
                } else {
                    return;
                }
                let _e862 = map.member[(0u + _e814)];
                let _e876 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e818.x * _e753) + (_e830.x * _e755)) + (_e846.x * _e757)) + (_e862.x * _e758)), ((((_e818.y * _e753) + (_e830.y * _e755)) + (_e846.y * _e757)) + (_e862.y * _e758)), ((((_e818.z * _e753) + (_e830.z * _e755)) + (_e846.z * _e757)) + (_e862.z * _e758)), ((((_e818.w * _e753) + (_e830.w * _e755)) + (_e846.w * _e757)) + (_e862.w * _e758))), _e667);
                phi_1442_ = evaluate_Verdict(_e876, false);
                phi_1443_ = evaluate_Verdict();
                phi_1444_ = false;
            } else {
                phi_1442_ = evaluate_Verdict();
                phi_1443_ = evaluate_Verdict(1f, false);
                phi_1444_ = true;
            }
            let _e880 = phi_1442_;
            let _e882 = phi_1443_;
            let _e884 = phi_1444_;
            phi_1445_ = _e882;
            phi_1446_ = _e880;
            phi_1447_ = _e884;
        }
        let _e886 = phi_1445_;
        let _e888 = phi_1446_;
        let _e890 = phi_1447_;
        if _e890 {
            phi_1451_ = _e886;
        } else {
            phi_1451_ = _e888;
        }
        let _e892 = phi_1451_;
        if (_e73.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.first_primitive)] = _e892.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
