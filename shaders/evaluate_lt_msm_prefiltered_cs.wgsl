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

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_141_: lt_bvh_traverse_Tree;
    var phi_142_: bool;
    var phi_143_: lt_bvh_traverse_Tree;
    var phi_144_: bool;
    var phi_149_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_141_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_142_ = false;
        } else {
            phi_141_ = lt_bvh_traverse_Tree();
            phi_142_ = true;
        }
        let _e50 = phi_141_;
        let _e52 = phi_142_;
        phi_143_ = _e50;
        phi_144_ = _e52;
    } else {
        phi_143_ = lt_bvh_traverse_Tree();
        phi_144_ = true;
    }
    let _e54 = phi_143_;
    let _e56 = phi_144_;
    if _e56 {
        phi_149_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_149_ = _e54;
    }
    let _e61 = phi_149_;
    return lt_bvh_traverse_Tree(_e61.root, _e61.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_198_: f32;
    var phi_199_: f32;
    var phi_200_: f32;
    var phi_206_: bool;
    var phi_228_: f32;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_232_: bool;
    var phi_233_: f32;
    var phi_234_: bool;
    var phi_272_: vec2<f32>;
    var phi_306_: f32;
    var phi_307_: f32;
    var phi_308_: f32;
    var phi_337_: f32;
    var phi_338_: f32;
    var phi_339_: f32;
    var phi_343_: f32;
    var phi_344_: f32;
    var phi_345_: f32;
    var phi_346_: f32;

    let _e40 = (*param_4);
    let _e41 = (1f - _e40);
    let _e50 = (0.5f * _e40);
    let _e51 = ((param_5.x * _e41) + _e50);
    let _e52 = ((param_5.y * _e41) + _e50);
    let _e54 = ((param_5.w * _e41) + _e50);
    let _e56 = (_e52 - (_e51 * _e51));
    let _e58 = (((param_5.z * _e41) + _e50) - (_e51 * _e52));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_200_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_199_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_198_ = 1f;
            } else {
                phi_198_ = param_6;
            }
            let _e70 = phi_198_;
            phi_199_ = _e70;
        }
        let _e72 = phi_199_;
        phi_200_ = _e72;
    }
    let _e74 = phi_200_;
    if (_e51 == _e54) {
        phi_206_ = (_e51 > 0.5f);
    } else {
        phi_206_ = false;
    }
    let _e78 = phi_206_;
    if _e78 {
        if (_e74 > 0f) {
            if ((bitcast<u32>(_e51) & 2147483647u) > 2139095040u) {
                phi_230_ = _e51;
            } else {
                if (_e51 < 0f) {
                    phi_229_ = 0f;
                } else {
                    if (_e51 > 1f) {
                        phi_228_ = 1f;
                    } else {
                        phi_228_ = _e51;
                    }
                    let _e86 = phi_228_;
                    phi_229_ = _e86;
                }
                let _e88 = phi_229_;
                phi_230_ = _e88;
            }
            let _e90 = phi_230_;
            phi_231_ = _e90;
            phi_232_ = false;
        } else {
            phi_231_ = f32();
            phi_232_ = true;
        }
        let _e92 = phi_231_;
        let _e94 = phi_232_;
        phi_233_ = _e92;
        phi_234_ = _e94;
    } else {
        phi_233_ = f32();
        phi_234_ = true;
    }
    let _e96 = phi_233_;
    let _e98 = phi_234_;
    if _e98 {
        let _e99 = (_e58 / _e56);
        let _e100 = (_e74 - _e51);
        let _e106 = (((((_e74 * _e74) - _e52) - (_e99 * _e100)) * _e56) / (((_e54 - (_e52 * _e52)) * _e56) - (_e58 * _e58)));
        let _e109 = ((_e100 / _e56) - (_e99 * _e106));
        let _e115 = ((0.5f * _e109) / _e106);
        let _e118 = ((_e115 * _e115) - (((1f - (_e109 * _e51)) - (_e106 * _e52)) / _e106));
        if (_e118 >= 0f) {
            let _e120 = sqrt(_e118);
            phi_272_ = vec2<f32>((-(_e115) - _e120), (-(_e115) + _e120));
        } else {
            phi_272_ = vec2(bitcast<f32>((bitcast<u32>(_e118) | 2143289344u)));
        }
        let _e131 = phi_272_;
        if (_e74 <= _e131.x) {
            phi_345_ = 1f;
        } else {
            if (_e74 > _e131.y) {
                let _e144 = (((_e52 - (_e51 * (_e131.x + _e131.y))) + (_e131.x * _e131.y)) / ((_e74 - _e131.x) * (_e74 - _e131.y)));
                if ((bitcast<u32>(_e144) & 2147483647u) > 2139095040u) {
                    phi_308_ = _e144;
                } else {
                    if (_e144 < 0f) {
                        phi_307_ = 0f;
                    } else {
                        if (_e144 > 1f) {
                            phi_306_ = 1f;
                        } else {
                            phi_306_ = _e144;
                        }
                        let _e151 = phi_306_;
                        phi_307_ = _e151;
                    }
                    let _e153 = phi_307_;
                    phi_308_ = _e153;
                }
                let _e155 = phi_308_;
                phi_344_ = _e155;
            } else {
                if (_e74 > _e131.x) {
                    let _e166 = (1f - (((_e52 - (_e51 * (_e74 + _e131.y))) + (_e74 * _e131.y)) / ((_e131.x - _e74) * (_e131.x - _e131.y))));
                    if ((bitcast<u32>(_e166) & 2147483647u) > 2139095040u) {
                        phi_339_ = _e166;
                    } else {
                        if (_e166 < 0f) {
                            phi_338_ = 0f;
                        } else {
                            if (_e166 > 1f) {
                                phi_337_ = 1f;
                            } else {
                                phi_337_ = _e166;
                            }
                            let _e173 = phi_337_;
                            phi_338_ = _e173;
                        }
                        let _e175 = phi_338_;
                        phi_339_ = _e175;
                    }
                    let _e177 = phi_339_;
                    phi_343_ = _e177;
                } else {
                    phi_343_ = bitcast<f32>((bitcast<u32>(_e131.x) | 2143289344u));
                }
                let _e182 = phi_343_;
                phi_344_ = _e182;
            }
            let _e184 = phi_344_;
            phi_345_ = _e184;
        }
        let _e186 = phi_345_;
        phi_346_ = _e186;
    } else {
        phi_346_ = _e96;
    }
    let _e188 = phi_346_;
    return _e188;
}

fn function_() {
    var local: f32;
    var phi_402_: bool;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_409_: bool;
    var phi_479_: bool;
    var phi_480_: bool;
    var phi_491_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_492_: bool;
    var phi_493_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_494_: bool;
    var phi_501_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_505_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_579_: bool;
    var phi_588_: bool;
    var phi_597_: bool;
    var phi_598_: bool;
    var phi_599_: bool;
    var phi_600_: bool;
    var phi_601_: bool;
    var phi_602_: bool;
    var phi_603_: bool;
    var phi_607_: bool;
    var phi_697_: f32;
    var phi_700_: f32;
    var phi_729_: f32;
    var phi_734_: f32;
    var phi_735_: bool;
    var phi_736_: f32;
    var phi_737_: bool;
    var phi_741_: f32;
    var phi_761_: f32;
    var phi_766_: f32;
    var phi_767_: bool;
    var phi_768_: f32;
    var phi_769_: bool;
    var phi_773_: f32;
    var phi_821_: i32;
    var phi_826_: i32;
    var phi_831_: i32;
    var phi_836_: i32;
    var phi_845_: i32;
    var phi_850_: i32;
    var phi_855_: i32;
    var phi_860_: i32;
    var phi_957_: bool;
    var phi_965_: bool;
    var phi_977_: bool;
    var phi_978_: bool;
    var phi_982_: f32;
    var phi_988_: f32;
    var phi_990_: evaluate_Verdict;
    var phi_1000_: u32;
    var phi_1009_: f32;
    var phi_1011_: evaluate_Verdict;
    var phi_1012_: bool;
    var phi_1013_: evaluate_Verdict;
    var phi_1014_: bool;
    var phi_1019_: evaluate_Verdict;
    var phi_1024_: evaluate_Verdict;
    var phi_1025_: evaluate_Verdict;

    let _e38 = id_1;
    let _e45 = arrayLength((&map.member));
    let _e51 = p.member.size[0u];
    let _e53 = p.member.size[1u];
    let _e54 = lt_shaders_entry_pixel_index(_e38, _e51, _e53);
    if (bitcast<i32>(_e54.root) != 0i) {
        let _e60 = p.member.projection;
        if (_e54.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e64 = lt_math_OneLevel(_e60);
        let _e68 = samples.member[(0u + _e54.first_primitive)].normal[0u];
        let _e70 = global[0u];
        if (_e68 == _e70) {
            let _e73 = samples.member[(0u + _e54.first_primitive)].normal[1u];
            let _e75 = global[1u];
            if (_e73 == _e75) {
                let _e78 = samples.member[(0u + _e54.first_primitive)].normal[2u];
                let _e80 = global[2u];
                phi_402_ = (_e78 == _e80);
                phi_403_ = false;
            } else {
                phi_402_ = bool();
                phi_403_ = true;
            }
            let _e83 = phi_402_;
            let _e85 = phi_403_;
            phi_404_ = _e83;
            phi_405_ = _e85;
        } else {
            phi_404_ = bool();
            phi_405_ = true;
        }
        let _e87 = phi_404_;
        let _e89 = phi_405_;
        if _e89 {
            phi_409_ = false;
        } else {
            phi_409_ = _e87;
        }
        let _e91 = phi_409_;
        if !(_e91) {
            let _e94 = samples.member[(0u + _e54.first_primitive)].position;
            let _e96 = p.member.light.place;
            let _e102 = p.member.light.place[3u];
            let _e109 = (_e96.x - (_e94.x * _e102));
            let _e110 = (_e96.y - (_e94.y * _e102));
            let _e111 = (_e96.z - (_e94.z * _e102));
            let _e113 = samples.member[(0u + _e54.first_primitive)].normal;
            if ((((_e113.x * _e109) + (_e113.y * _e110)) + (_e113.z * _e111)) > 0f) {
                let _e127 = (((_e109 * _e109) + (_e110 * _e110)) + (_e111 * _e111));
                let _e129 = p.member.light.axis;
                let _e141 = p.member.light.place[3u];
                if (_e141 == 0f) {
                    phi_480_ = true;
                } else {
                    let _e144 = p.member.light.range_squared;
                    if (_e127 <= _e144) {
                        let _e147 = p.member.light.cos_outer;
                        phi_479_ = (-((((_e109 * _e129.x) + (_e110 * _e129.y)) + (_e111 * _e129.z))) >= (_e147 * sqrt(_e127)));
                    } else {
                        phi_479_ = false;
                    }
                    let _e152 = phi_479_;
                    phi_480_ = _e152;
                }
                let _e154 = phi_480_;
                if _e154 {
                    let _e156 = samples.member[(0u + _e54.first_primitive)].flags;
                    let _e164 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e164.unnamed.visibility, false), _e164.unnamed_1);
                    phi_491_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e170.unnamed, ((_e156 & 1u) == 0u));
                    phi_492_ = false;
                } else {
                    phi_491_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_492_ = true;
                }
                let _e175 = phi_491_;
                let _e177 = phi_492_;
                phi_493_ = _e175;
                phi_494_ = _e177;
            } else {
                phi_493_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_494_ = true;
            }
            let _e179 = phi_493_;
            let _e181 = phi_494_;
            if _e181 {
                let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e187.unnamed.visibility, false), _e187.unnamed_1);
                phi_501_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e193.unnamed, true);
            } else {
                phi_501_ = _e179;
            }
            let _e198 = phi_501_;
            phi_505_ = _e198;
        } else {
            let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
            phi_505_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
        }
        let _e215 = phi_505_;
        if _e215.unnamed_1 {
            phi_1025_ = evaluate_Verdict(_e215.unnamed.visibility, _e215.unnamed.is_doubted);
        } else {
            let _e223 = samples.member[(0u + _e54.first_primitive)].position;
            let _e241 = ((((_e64.projection.row_w.x * _e223.x) + (_e64.projection.row_w.y * _e223.y)) + (_e64.projection.row_w.z * _e223.z)) + (_e64.projection.row_w.w * 1f));
            let _e255 = (((((_e64.projection.row_x.x * _e223.x) + (_e64.projection.row_x.y * _e223.y)) + (_e64.projection.row_x.z * _e223.z)) + (_e64.projection.row_x.w * 1f)) / _e241);
            let _e269 = (((((_e64.projection.row_y.x * _e223.x) + (_e64.projection.row_y.y * _e223.y)) + (_e64.projection.row_y.z * _e223.z)) + (_e64.projection.row_y.w * 1f)) / _e241);
            let _e282 = ((((_e64.projection.row_z.x * _e223.x) + (_e64.projection.row_z.y * _e223.y)) + (_e64.projection.row_z.z * _e223.z)) + (_e64.projection.row_z.w * 1f));
            if (_e241 > 0f) {
                if (_e255 >= 0f) {
                    phi_579_ = (_e255 <= 1f);
                } else {
                    phi_579_ = false;
                }
                let _e287 = phi_579_;
                if _e287 {
                    if (_e269 >= 0f) {
                        phi_588_ = (_e269 <= 1f);
                    } else {
                        phi_588_ = false;
                    }
                    let _e291 = phi_588_;
                    if _e291 {
                        if (_e282 >= 0f) {
                            phi_597_ = (_e282 <= 1f);
                        } else {
                            phi_597_ = false;
                        }
                        let _e295 = phi_597_;
                        phi_598_ = _e295;
                        phi_599_ = false;
                    } else {
                        phi_598_ = bool();
                        phi_599_ = true;
                    }
                    let _e297 = phi_598_;
                    let _e299 = phi_599_;
                    phi_600_ = _e297;
                    phi_601_ = _e299;
                } else {
                    phi_600_ = bool();
                    phi_601_ = true;
                }
                let _e301 = phi_600_;
                let _e303 = phi_601_;
                phi_602_ = _e301;
                phi_603_ = _e303;
            } else {
                phi_602_ = bool();
                phi_603_ = true;
            }
            let _e305 = phi_602_;
            let _e307 = phi_603_;
            if _e307 {
                phi_607_ = false;
            } else {
                phi_607_ = _e305;
            }
            let _e309 = phi_607_;
            if _e309 {
                if (0f > 0f) {
                    let _e312 = samples.member[(0u + _e54.first_primitive)].normal;
                    let _e314 = p.member.map_size;
                    let _e384 = ((abs(((((_e60.row_x.x * _e312.x) + (_e60.row_x.y * _e312.y)) + (_e60.row_x.z * _e312.z)) / (((_e60.row_x.x * _e60.row_x.x) + (_e60.row_x.y * _e60.row_x.y)) + (_e60.row_x.z * _e60.row_x.z)))) + abs(((((_e60.row_y.x * _e312.x) + (_e60.row_y.y * _e312.y)) + (_e60.row_y.z * _e312.z)) / (((_e60.row_y.x * _e60.row_y.x) + (_e60.row_y.y * _e60.row_y.y)) + (_e60.row_y.z * _e60.row_y.z))))) / (abs(((((_e60.row_z.x * _e312.x) + (_e60.row_z.y * _e312.y)) + (_e60.row_z.z * _e312.z)) / (((_e60.row_z.x * _e60.row_z.x) + (_e60.row_z.y * _e60.row_z.y)) + (_e60.row_z.z * _e60.row_z.z)))) * f32(_e314)));
                    if (_e384 < 0.002f) {
                        phi_697_ = _e384;
                    } else {
                        phi_697_ = 0.002f;
                    }
                    let _e387 = phi_697_;
                    phi_700_ = (_e282 - (0f * _e387));
                } else {
                    phi_700_ = _e282;
                }
                let _e391 = phi_700_;
                let _e393 = p.member.map_size;
                let _e394 = f32(_e393);
                let _e397 = ((_e255 * _e394) - 0.5f);
                let _e398 = ((_e269 * _e394) - 0.5f);
                if (_e397 > -8388608f) {
                    let _e410 = f32(select(0i, select(select(i32(_e397), i32(-2147483648), (_e397 < bitcast<f32>(3472883712u))), 2147483647i, (_e397 > bitcast<f32>(1325400063u))), (_e397 == _e397)));
                    if (_e410 > _e397) {
                        phi_729_ = 1f;
                    } else {
                        phi_729_ = 0f;
                    }
                    let _e413 = phi_729_;
                    if (_e397 < 8388608f) {
                        phi_734_ = (_e410 - _e413);
                        phi_735_ = false;
                    } else {
                        phi_734_ = f32();
                        phi_735_ = true;
                    }
                    let _e416 = phi_734_;
                    let _e418 = phi_735_;
                    phi_736_ = _e416;
                    phi_737_ = _e418;
                } else {
                    phi_736_ = f32();
                    phi_737_ = true;
                }
                let _e420 = phi_736_;
                let _e422 = phi_737_;
                if _e422 {
                    phi_741_ = _e397;
                } else {
                    phi_741_ = _e420;
                }
                let _e424 = phi_741_;
                if (_e398 > -8388608f) {
                    let _e436 = f32(select(0i, select(select(i32(_e398), i32(-2147483648), (_e398 < bitcast<f32>(3472883712u))), 2147483647i, (_e398 > bitcast<f32>(1325400063u))), (_e398 == _e398)));
                    if (_e436 > _e398) {
                        phi_761_ = 1f;
                    } else {
                        phi_761_ = 0f;
                    }
                    let _e439 = phi_761_;
                    if (_e398 < 8388608f) {
                        phi_766_ = (_e436 - _e439);
                        phi_767_ = false;
                    } else {
                        phi_766_ = f32();
                        phi_767_ = true;
                    }
                    let _e442 = phi_766_;
                    let _e444 = phi_767_;
                    phi_768_ = _e442;
                    phi_769_ = _e444;
                } else {
                    phi_768_ = f32();
                    phi_769_ = true;
                }
                let _e446 = phi_768_;
                let _e448 = phi_769_;
                if _e448 {
                    phi_773_ = _e398;
                } else {
                    phi_773_ = _e446;
                }
                let _e450 = phi_773_;
                let _e451 = (_e397 - _e424);
                let _e452 = (_e398 - _e450);
                let _e461 = select(0i, select(select(i32(_e424), i32(-2147483648), (_e424 < bitcast<f32>(3472883712u))), 2147483647i, (_e424 > bitcast<f32>(1325400063u))), (_e424 == _e424));
                let _e470 = select(0i, select(select(i32(_e450), i32(-2147483648), (_e450 < bitcast<f32>(3472883712u))), 2147483647i, (_e450 > bitcast<f32>(1325400063u))), (_e450 == _e450));
                let _e473 = ((1f - _e451) * (1f - _e452));
                let _e475 = (_e451 * (1f - _e452));
                let _e477 = ((1f - _e451) * _e452);
                let _e478 = (_e451 * _e452);
                let _e480 = p.member.test;
                let _e481 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e480);
                let _e483 = p.member.map_size;
                local = _e481;
                let _e485 = ((0u * _e483) * _e483);
                let _e487 = (bitcast<i32>(_e483) - 1i);
                if (_e461 > 0i) {
                    phi_821_ = _e461;
                } else {
                    phi_821_ = 0i;
                }
                let _e490 = phi_821_;
                if (_e470 > 0i) {
                    phi_826_ = _e470;
                } else {
                    phi_826_ = 0i;
                }
                let _e493 = phi_826_;
                if (_e490 < _e487) {
                    phi_831_ = _e490;
                } else {
                    phi_831_ = _e487;
                }
                let _e496 = phi_831_;
                if (_e493 < _e487) {
                    phi_836_ = _e493;
                } else {
                    phi_836_ = _e487;
                }
                let _e499 = phi_836_;
                let _e500 = bitcast<u32>(_e496);
                let _e502 = (_e461 + 1i);
                let _e503 = (_e470 + 1i);
                if (_e502 > 0i) {
                    phi_845_ = _e502;
                } else {
                    phi_845_ = 0i;
                }
                let _e506 = phi_845_;
                if (_e503 > 0i) {
                    phi_850_ = _e503;
                } else {
                    phi_850_ = 0i;
                }
                let _e509 = phi_850_;
                if (_e506 < _e487) {
                    phi_855_ = _e506;
                } else {
                    phi_855_ = _e487;
                }
                let _e512 = phi_855_;
                if (_e509 < _e487) {
                    phi_860_ = _e509;
                } else {
                    phi_860_ = _e487;
                }
                let _e515 = phi_860_;
                let _e516 = bitcast<u32>(_e512);
                let _e518 = (bitcast<u32>(_e499) * _e483);
                let _e519 = (bitcast<u32>(_e515) * _e483);
                let _e524 = ((_e518 + _e500) + _e485);
                let _e525 = ((_e518 + _e516) + _e485);
                let _e526 = ((_e519 + _e500) + _e485);
                let _e527 = ((_e519 + _e516) + _e485);
                if (_e524 < _e45) {
                } else {
                    return;
                }
                let _e531 = map.member[(0u + _e524)];
                if (_e525 < _e45) {
                } else {
                    return;
                }
                let _e543 = map.member[(0u + _e525)];
                if (_e526 < _e45) {
                } else {
                    return;
                }
                let _e559 = map.member[(0u + _e526)];
                if (_e527 < _e45) {
                } else {
                    return;
                }
                let _e575 = map.member[(0u + _e527)];
                let _e589 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e531.x * _e473) + (_e543.x * _e475)) + (_e559.x * _e477)) + (_e575.x * _e478)), ((((_e531.y * _e473) + (_e543.y * _e475)) + (_e559.y * _e477)) + (_e575.y * _e478)), ((((_e531.z * _e473) + (_e543.z * _e475)) + (_e559.z * _e477)) + (_e575.z * _e478)), ((((_e531.w * _e473) + (_e543.w * _e475)) + (_e559.w * _e477)) + (_e575.w * _e478))), _e391);
                let _e593 = p.member.epsilon;
                if (_e589 <= _e593) {
                    phi_957_ = true;
                } else {
                    phi_957_ = (_e589 >= (1f - _e593));
                }
                let _e598 = phi_957_;
                if ((bitcast<u32>(_e589) & 2147483647u) > 2139095040u) {
                    phi_965_ = true;
                } else {
                    phi_965_ = !(_e598);
                }
                let _e604 = phi_965_;
                if _e604 {
                    if (_e589 > 0f) {
                        if (_e589 < 1f) {
                            phi_977_ = false;
                        } else {
                            phi_977_ = true;
                        }
                        let _e608 = phi_977_;
                        phi_978_ = _e608;
                    } else {
                        phi_978_ = true;
                    }
                    let _e610 = phi_978_;
                    if _e610 {
                        phi_982_ = 0.5f;
                    } else {
                        phi_982_ = _e589;
                    }
                    let _e612 = phi_982_;
                    phi_990_ = evaluate_Verdict(_e612, true);
                } else {
                    if (_e589 > 0.5f) {
                        phi_988_ = 1f;
                    } else {
                        phi_988_ = 0f;
                    }
                    let _e616 = phi_988_;
                    phi_990_ = evaluate_Verdict(_e616, false);
                }
                let _e619 = phi_990_;
                let _e622 = (_e619.visibility < 0.5f);
                if _e619.is_doubted {
                    phi_1013_ = evaluate_Verdict();
                    phi_1014_ = true;
                } else {
                    if _e622 {
                        phi_1000_ = 2u;
                    } else {
                        phi_1000_ = 1u;
                    }
                    let _e624 = phi_1000_;
                    if ((0u & _e624) != 0u) {
                        if _e622 {
                            phi_1009_ = 0.000000059604645f;
                        } else {
                            phi_1009_ = 0.99999994f;
                        }
                        let _e628 = phi_1009_;
                        phi_1011_ = evaluate_Verdict(_e628, true);
                        phi_1012_ = false;
                    } else {
                        phi_1011_ = evaluate_Verdict();
                        phi_1012_ = true;
                    }
                    let _e631 = phi_1011_;
                    let _e633 = phi_1012_;
                    phi_1013_ = _e631;
                    phi_1014_ = _e633;
                }
                let _e635 = phi_1013_;
                let _e637 = phi_1014_;
                if _e637 {
                    phi_1019_ = evaluate_Verdict(_e619.visibility, _e619.is_doubted);
                } else {
                    phi_1019_ = _e635;
                }
                let _e640 = phi_1019_;
                phi_1024_ = evaluate_Verdict(_e640.visibility, _e640.is_doubted);
            } else {
                phi_1024_ = evaluate_Verdict(0.5f, true);
            }
            let _e646 = phi_1024_;
            phi_1025_ = _e646;
        }
        let _e648 = phi_1025_;
        if (_e54.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e54.first_primitive)] = _e648.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
