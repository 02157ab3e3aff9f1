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
        let _e53 = phi_155_;
        let _e55 = phi_156_;
        phi_157_ = _e53;
        phi_158_ = _e55;
    } else {
        phi_157_ = lt_bvh_traverse_Tree();
        phi_158_ = true;
    }
    let _e57 = phi_157_;
    let _e59 = phi_158_;
    if _e59 {
        phi_163_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_163_ = _e57;
    }
    let _e64 = phi_163_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_214_: f32;
    var phi_220_: bool;
    var phi_242_: f32;
    var phi_243_: f32;
    var phi_244_: f32;
    var phi_245_: f32;
    var phi_246_: bool;
    var phi_247_: f32;
    var phi_248_: bool;
    var phi_286_: vec2<f32>;
    var phi_320_: f32;
    var phi_321_: f32;
    var phi_322_: f32;
    var phi_351_: f32;
    var phi_352_: f32;
    var phi_353_: f32;
    var phi_357_: f32;
    var phi_358_: f32;
    var phi_359_: f32;
    var phi_360_: f32;

    let _e43 = (*param_4);
    let _e44 = (1f - _e43);
    let _e53 = (0.5f * _e43);
    let _e54 = ((param_5.x * _e44) + _e53);
    let _e55 = ((param_5.y * _e44) + _e53);
    let _e57 = ((param_5.w * _e44) + _e53);
    let _e59 = (_e55 - (_e54 * _e54));
    let _e61 = (((param_5.z * _e44) + _e53) - (_e54 * _e55));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_214_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_213_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_212_ = 1f;
            } else {
                phi_212_ = param_6;
            }
            let _e73 = phi_212_;
            phi_213_ = _e73;
        }
        let _e75 = phi_213_;
        phi_214_ = _e75;
    }
    let _e77 = phi_214_;
    if (_e54 == _e57) {
        phi_220_ = (_e54 > 0.5f);
    } else {
        phi_220_ = false;
    }
    let _e81 = phi_220_;
    if _e81 {
        if (_e77 > 0f) {
            if ((bitcast<u32>(_e54) & 2147483647u) > 2139095040u) {
                phi_244_ = _e54;
            } else {
                if (_e54 < 0f) {
                    phi_243_ = 0f;
                } else {
                    if (_e54 > 1f) {
                        phi_242_ = 1f;
                    } else {
                        phi_242_ = _e54;
                    }
                    let _e89 = phi_242_;
                    phi_243_ = _e89;
                }
                let _e91 = phi_243_;
                phi_244_ = _e91;
            }
            let _e93 = phi_244_;
            phi_245_ = _e93;
            phi_246_ = false;
        } else {
            phi_245_ = f32();
            phi_246_ = true;
        }
        let _e95 = phi_245_;
        let _e97 = phi_246_;
        phi_247_ = _e95;
        phi_248_ = _e97;
    } else {
        phi_247_ = f32();
        phi_248_ = true;
    }
    let _e99 = phi_247_;
    let _e101 = phi_248_;
    if _e101 {
        let _e102 = (_e61 / _e59);
        let _e103 = (_e77 - _e54);
        let _e109 = (((((_e77 * _e77) - _e55) - (_e102 * _e103)) * _e59) / (((_e57 - (_e55 * _e55)) * _e59) - (_e61 * _e61)));
        let _e112 = ((_e103 / _e59) - (_e102 * _e109));
        let _e118 = ((0.5f * _e112) / _e109);
        let _e121 = ((_e118 * _e118) - (((1f - (_e112 * _e54)) - (_e109 * _e55)) / _e109));
        if (_e121 >= 0f) {
            let _e123 = sqrt(_e121);
            phi_286_ = vec2<f32>((-(_e118) - _e123), (-(_e118) + _e123));
        } else {
            phi_286_ = vec2(bitcast<f32>((bitcast<u32>(_e121) | 2143289344u)));
        }
        let _e134 = phi_286_;
        if (_e77 <= _e134.x) {
            phi_359_ = 1f;
        } else {
            if (_e77 > _e134.y) {
                let _e147 = (((_e55 - (_e54 * (_e134.x + _e134.y))) + (_e134.x * _e134.y)) / ((_e77 - _e134.x) * (_e77 - _e134.y)));
                if ((bitcast<u32>(_e147) & 2147483647u) > 2139095040u) {
                    phi_322_ = _e147;
                } else {
                    if (_e147 < 0f) {
                        phi_321_ = 0f;
                    } else {
                        if (_e147 > 1f) {
                            phi_320_ = 1f;
                        } else {
                            phi_320_ = _e147;
                        }
                        let _e154 = phi_320_;
                        phi_321_ = _e154;
                    }
                    let _e156 = phi_321_;
                    phi_322_ = _e156;
                }
                let _e158 = phi_322_;
                phi_358_ = _e158;
            } else {
                if (_e77 > _e134.x) {
                    let _e169 = (1f - (((_e55 - (_e54 * (_e77 + _e134.y))) + (_e77 * _e134.y)) / ((_e134.x - _e77) * (_e134.x - _e134.y))));
                    if ((bitcast<u32>(_e169) & 2147483647u) > 2139095040u) {
                        phi_353_ = _e169;
                    } else {
                        if (_e169 < 0f) {
                            phi_352_ = 0f;
                        } else {
                            if (_e169 > 1f) {
                                phi_351_ = 1f;
                            } else {
                                phi_351_ = _e169;
                            }
                            let _e176 = phi_351_;
                            phi_352_ = _e176;
                        }
                        let _e178 = phi_352_;
                        phi_353_ = _e178;
                    }
                    let _e180 = phi_353_;
                    phi_357_ = _e180;
                } else {
                    phi_357_ = bitcast<f32>((bitcast<u32>(_e134.x) | 2143289344u));
                }
                let _e185 = phi_357_;
                phi_358_ = _e185;
            }
            let _e187 = phi_358_;
            phi_359_ = _e187;
        }
        let _e189 = phi_359_;
        phi_360_ = _e189;
    } else {
        phi_360_ = _e99;
    }
    let _e191 = phi_360_;
    return _e191;
}

fn function_() {
    var local: f32;
    var phi_422_: bool;
    var phi_423_: bool;
    var phi_424_: bool;
    var phi_425_: bool;
    var phi_429_: bool;
    var phi_499_: bool;
    var phi_500_: bool;
    var phi_511_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_512_: bool;
    var phi_513_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_514_: bool;
    var phi_521_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_525_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_599_: bool;
    var phi_608_: bool;
    var phi_617_: bool;
    var phi_618_: bool;
    var phi_619_: bool;
    var phi_620_: bool;
    var phi_621_: bool;
    var phi_622_: bool;
    var phi_623_: bool;
    var phi_627_: bool;
    var phi_717_: f32;
    var phi_720_: f32;
    var phi_749_: f32;
    var phi_754_: f32;
    var phi_755_: bool;
    var phi_756_: f32;
    var phi_757_: bool;
    var phi_761_: f32;
    var phi_781_: f32;
    var phi_786_: f32;
    var phi_787_: bool;
    var phi_788_: f32;
    var phi_789_: bool;
    var phi_793_: f32;
    var phi_843_: i32;
    var phi_848_: i32;
    var phi_853_: i32;
    var phi_858_: i32;
    var phi_867_: i32;
    var phi_872_: i32;
    var phi_877_: i32;
    var phi_882_: i32;
    var phi_981_: i32;
    var phi_986_: i32;
    var phi_991_: i32;
    var phi_996_: i32;
    var phi_1015_: i32;
    var phi_1020_: i32;
    var phi_1025_: i32;
    var phi_1030_: i32;
    var phi_1049_: i32;
    var phi_1054_: i32;
    var phi_1059_: i32;
    var phi_1064_: i32;
    var phi_1083_: i32;
    var phi_1088_: i32;
    var phi_1093_: i32;
    var phi_1098_: i32;
    var phi_1176_: bool;
    var phi_1184_: bool;
    var phi_1196_: bool;
    var phi_1197_: bool;
    var phi_1201_: f32;
    var phi_1207_: f32;
    var phi_1209_: evaluate_Verdict;
    var phi_1219_: u32;
    var phi_1228_: f32;
    var phi_1230_: evaluate_Verdict;
    var phi_1231_: bool;
    var phi_1232_: evaluate_Verdict;
    var phi_1233_: bool;
    var phi_1238_: evaluate_Verdict;
    var phi_1243_: evaluate_Verdict;
    var phi_1244_: evaluate_Verdict;

    let _e41 = id_1;
    let _e48 = arrayLength((&map.member));
    let _e54 = arrayLength((&marks.member));
    let _e57 = p.member.size[0u];
    let _e59 = p.member.size[1u];
    let _e60 = lt_shaders_entry_pixel_index(_e41, _e57, _e59);
    if (bitcast<i32>(_e60.root) != 0i) {
        let _e66 = p.member.projection;
        if (_e60.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e70 = lt_math_OneLevel(_e66);
        let _e74 = samples.member[(0u + _e60.first_primitive)].normal[0u];
        let _e76 = global[0u];
        if (_e74 == _e76) {
            let _e79 = samples.member[(0u + _e60.first_primitive)].normal[1u];
            let _e81 = global[1u];
            if (_e79 == _e81) {
                let _e84 = samples.member[(0u + _e60.first_primitive)].normal[2u];
                let _e86 = global[2u];
                phi_422_ = (_e84 == _e86);
                phi_423_ = false;
            } else {
                phi_422_ = bool();
                phi_423_ = true;
            }
            let _e89 = phi_422_;
            let _e91 = phi_423_;
            phi_424_ = _e89;
            phi_425_ = _e91;
        } else {
            phi_424_ = bool();
            phi_425_ = true;
        }
        let _e93 = phi_424_;
        let _e95 = phi_425_;
        if _e95 {
            phi_429_ = false;
        } else {
            phi_429_ = _e93;
        }
        let _e97 = phi_429_;
        if !(_e97) {
            let _e100 = samples.member[(0u + _e60.first_primitive)].position;
            let _e102 = p.member.light.place;
            let _e108 = p.member.light.place[3u];
            let _e115 = (_e102.x - (_e100.x * _e108));
            let _e116 = (_e102.y - (_e100.y * _e108));
            let _e117 = (_e102.z - (_e100.z * _e108));
            let _e119 = samples.member[(0u + _e60.first_primitive)].normal;
            if ((((_e119.x * _e115) + (_e119.y * _e116)) + (_e119.z * _e117)) > 0f) {
                let _e133 = (((_e115 * _e115) + (_e116 * _e116)) + (_e117 * _e117));
                let _e135 = p.member.light.axis;
                let _e147 = p.member.light.place[3u];
                if (_e147 == 0f) {
                    phi_500_ = true;
                } else {
                    let _e150 = p.member.light.range_squared;
                    if (_e133 <= _e150) {
                        let _e153 = p.member.light.cos_outer;
                        phi_499_ = (-((((_e115 * _e135.x) + (_e116 * _e135.y)) + (_e117 * _e135.z))) >= (_e153 * sqrt(_e133)));
                    } else {
                        phi_499_ = false;
                    }
                    let _e158 = phi_499_;
                    phi_500_ = _e158;
                }
                let _e160 = phi_500_;
                if _e160 {
                    let _e162 = samples.member[(0u + _e60.first_primitive)].flags;
                    let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
                    phi_511_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, ((_e162 & 1u) == 0u));
                    phi_512_ = false;
                } else {
                    phi_511_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_512_ = true;
                }
                let _e181 = phi_511_;
                let _e183 = phi_512_;
                phi_513_ = _e181;
                phi_514_ = _e183;
            } else {
                phi_513_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_514_ = true;
            }
            let _e185 = phi_513_;
            let _e187 = phi_514_;
            if _e187 {
                let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e193.unnamed.visibility, false), _e193.unnamed_1);
                phi_521_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e199.unnamed, true);
            } else {
                phi_521_ = _e185;
            }
            let _e204 = phi_521_;
            phi_525_ = _e204;
        } else {
            let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e210.unnamed.visibility, false), _e210.unnamed_1);
            phi_525_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e216.unnamed, true);
        }
        let _e221 = phi_525_;
        if _e221.unnamed_1 {
            phi_1244_ = evaluate_Verdict(_e221.unnamed.visibility, _e221.unnamed.is_doubted);
        } else {
            let _e229 = samples.member[(0u + _e60.first_primitive)].position;
            let _e247 = ((((_e70.projection.row_w.x * _e229.x) + (_e70.projection.row_w.y * _e229.y)) + (_e70.projection.row_w.z * _e229.z)) + (_e70.projection.row_w.w * 1f));
            let _e261 = (((((_e70.projection.row_x.x * _e229.x) + (_e70.projection.row_x.y * _e229.y)) + (_e70.projection.row_x.z * _e229.z)) + (_e70.projection.row_x.w * 1f)) / _e247);
            let _e275 = (((((_e70.projection.row_y.x * _e229.x) + (_e70.projection.row_y.y * _e229.y)) + (_e70.projection.row_y.z * _e229.z)) + (_e70.projection.row_y.w * 1f)) / _e247);
            let _e288 = ((((_e70.projection.row_z.x * _e229.x) + (_e70.projection.row_z.y * _e229.y)) + (_e70.projection.row_z.z * _e229.z)) + (_e70.projection.row_z.w * 1f));
            if (_e247 > 0f) {
                if (_e261 >= 0f) {
                    phi_599_ = (_e261 <= 1f);
                } else {
                    phi_599_ = false;
                }
                let _e293 = phi_599_;
                if _e293 {
                    if (_e275 >= 0f) {
                        phi_608_ = (_e275 <= 1f);
                    } else {
                        phi_608_ = false;
                    }
                    let _e297 = phi_608_;
                    if _e297 {
                        if (_e288 >= 0f) {
                            phi_617_ = (_e288 <= 1f);
                        } else {
                            phi_617_ = false;
                        }
                        let _e301 = phi_617_;
                        phi_618_ = _e301;
                        phi_619_ = false;
                    } else {
                        phi_618_ = bool();
                        phi_619_ = true;
                    }
                    let _e303 = phi_618_;
                    let _e305 = phi_619_;
                    phi_620_ = _e303;
                    phi_621_ = _e305;
                } else {
                    phi_620_ = bool();
                    phi_621_ = true;
                }
                let _e307 = phi_620_;
                let _e309 = phi_621_;
                phi_622_ = _e307;
                phi_623_ = _e309;
            } else {
                phi_622_ = bool();
                phi_623_ = true;
            }
            let _e311 = phi_622_;
            let _e313 = phi_623_;
            if _e313 {
                phi_627_ = false;
            } else {
                phi_627_ = _e311;
            }
            let _e315 = phi_627_;
            if _e315 {
                if (0f > 0f) {
                    let _e318 = samples.member[(0u + _e60.first_primitive)].normal;
                    let _e320 = p.member.map_size;
                    let _e390 = ((abs(((((_e66.row_x.x * _e318.x) + (_e66.row_x.y * _e318.y)) + (_e66.row_x.z * _e318.z)) / (((_e66.row_x.x * _e66.row_x.x) + (_e66.row_x.y * _e66.row_x.y)) + (_e66.row_x.z * _e66.row_x.z)))) + abs(((((_e66.row_y.x * _e318.x) + (_e66.row_y.y * _e318.y)) + (_e66.row_y.z * _e318.z)) / (((_e66.row_y.x * _e66.row_y.x) + (_e66.row_y.y * _e66.row_y.y)) + (_e66.row_y.z * _e66.row_y.z))))) / (abs(((((_e66.row_z.x * _e318.x) + (_e66.row_z.y * _e318.y)) + (_e66.row_z.z * _e318.z)) / (((_e66.row_z.x * _e66.row_z.x) + (_e66.row_z.y * _e66.row_z.y)) + (_e66.row_z.z * _e66.row_z.z)))) * f32(_e320)));
                    if (_e390 < 0.002f) {
                        phi_717_ = _e390;
                    } else {
                        phi_717_ = 0.002f;
                    }
                    let _e393 = phi_717_;
                    phi_720_ = (_e288 - (0f * _e393));
                } else {
                    phi_720_ = _e288;
                }
                let _e397 = phi_720_;
                let _e399 = p.member.map_size;
                let _e400 = f32(_e399);
                let _e403 = ((_e261 * _e400) - 0.5f);
                let _e404 = ((_e275 * _e400) - 0.5f);
                if (_e403 > -8388608f) {
                    let _e416 = f32(select(0i, select(select(i32(_e403), i32(-2147483648), (_e403 < bitcast<f32>(3472883712u))), 2147483647i, (_e403 > bitcast<f32>(1325400063u))), (_e403 == _e403)));
                    if (_e416 > _e403) {
                        phi_749_ = 1f;
                    } else {
                        phi_749_ = 0f;
                    }
                    let _e419 = phi_749_;
                    if (_e403 < 8388608f) {
                        phi_754_ = (_e416 - _e419);
                        phi_755_ = false;
                    } else {
                        phi_754_ = f32();
                        phi_755_ = true;
                    }
                    let _e422 = phi_754_;
                    let _e424 = phi_755_;
                    phi_756_ = _e422;
                    phi_757_ = _e424;
                } else {
                    phi_756_ = f32();
                    phi_757_ = true;
                }
                let _e426 = phi_756_;
                let _e428 = phi_757_;
                if _e428 {
                    phi_761_ = _e403;
                } else {
                    phi_761_ = _e426;
                }
                let _e430 = phi_761_;
                if (_e404 > -8388608f) {
                    let _e442 = f32(select(0i, select(select(i32(_e404), i32(-2147483648), (_e404 < bitcast<f32>(3472883712u))), 2147483647i, (_e404 > bitcast<f32>(1325400063u))), (_e404 == _e404)));
                    if (_e442 > _e404) {
                        phi_781_ = 1f;
                    } else {
                        phi_781_ = 0f;
                    }
                    let _e445 = phi_781_;
                    if (_e404 < 8388608f) {
                        phi_786_ = (_e442 - _e445);
                        phi_787_ = false;
                    } else {
                        phi_786_ = f32();
                        phi_787_ = true;
                    }
                    let _e448 = phi_786_;
                    let _e450 = phi_787_;
                    phi_788_ = _e448;
                    phi_789_ = _e450;
                } else {
                    phi_788_ = f32();
                    phi_789_ = true;
                }
                let _e452 = phi_788_;
                let _e454 = phi_789_;
                if _e454 {
                    phi_793_ = _e404;
                } else {
                    phi_793_ = _e452;
                }
                let _e456 = phi_793_;
                let _e457 = (_e403 - _e430);
                let _e458 = (_e404 - _e456);
                let _e467 = select(0i, select(select(i32(_e430), i32(-2147483648), (_e430 < bitcast<f32>(3472883712u))), 2147483647i, (_e430 > bitcast<f32>(1325400063u))), (_e430 == _e430));
                let _e476 = select(0i, select(select(i32(_e456), i32(-2147483648), (_e456 < bitcast<f32>(3472883712u))), 2147483647i, (_e456 > bitcast<f32>(1325400063u))), (_e456 == _e456));
                let _e479 = ((1f - _e457) * (1f - _e458));
                let _e481 = (_e457 * (1f - _e458));
                let _e483 = ((1f - _e457) * _e458);
                let _e484 = (_e457 * _e458);
                let _e486 = p.member.test;
                let _e487 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e486);
                let _e489 = p.member.map_size;
                local = _e487;
                let _e491 = ((0u * _e489) * _e489);
                let _e493 = (bitcast<i32>(_e489) - 1i);
                if (_e467 > 0i) {
                    phi_843_ = _e467;
                } else {
                    phi_843_ = 0i;
                }
                let _e496 = phi_843_;
                if (_e476 > 0i) {
                    phi_848_ = _e476;
                } else {
                    phi_848_ = 0i;
                }
                let _e499 = phi_848_;
                if (_e496 < _e493) {
                    phi_853_ = _e496;
                } else {
                    phi_853_ = _e493;
                }
                let _e502 = phi_853_;
                if (_e499 < _e493) {
                    phi_858_ = _e499;
                } else {
                    phi_858_ = _e493;
                }
                let _e505 = phi_858_;
                let _e506 = bitcast<u32>(_e502);
                let _e508 = (_e467 + 1i);
                let _e509 = (_e476 + 1i);
                if (_e508 > 0i) {
                    phi_867_ = _e508;
                } else {
                    phi_867_ = 0i;
                }
                let _e512 = phi_867_;
                if (_e509 > 0i) {
                    phi_872_ = _e509;
                } else {
                    phi_872_ = 0i;
                }
                let _e515 = phi_872_;
                if (_e512 < _e493) {
                    phi_877_ = _e512;
                } else {
                    phi_877_ = _e493;
                }
                let _e518 = phi_877_;
                if (_e515 < _e493) {
                    phi_882_ = _e515;
                } else {
                    phi_882_ = _e493;
                }
                let _e521 = phi_882_;
                let _e522 = bitcast<u32>(_e518);
                let _e524 = (bitcast<u32>(_e505) * _e489);
                let _e525 = (bitcast<u32>(_e521) * _e489);
                let _e530 = ((_e524 + _e506) + _e491);
                let _e531 = ((_e524 + _e522) + _e491);
                let _e532 = ((_e525 + _e506) + _e491);
                let _e533 = ((_e525 + _e522) + _e491);
                if (_e530 < _e48) {
                } else {
                    return;
                }
                let _e537 = map.member[(0u + _e530)];
                if (_e531 < _e48) {
                } else {
                    return;
                }
                let _e549 = map.member[(0u + _e531)];
                if (_e532 < _e48) {
                } else {
                    return;
                }
                let _e565 = map.member[(0u + _e532)];
                if (_e533 < _e48) {
                } else {
                    return;
                }
                let _e581 = map.member[(0u + _e533)];
                let _e595 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e537.x * _e479) + (_e549.x * _e481)) + (_e565.x * _e483)) + (_e581.x * _e484)), ((((_e537.y * _e479) + (_e549.y * _e481)) + (_e565.y * _e483)) + (_e581.y * _e484)), ((((_e537.z * _e479) + (_e549.z * _e481)) + (_e565.z * _e483)) + (_e581.z * _e484)), ((((_e537.w * _e479) + (_e549.w * _e481)) + (_e565.w * _e483)) + (_e581.w * _e484))), _e397);
                let _e597 = p.member.map_size;
                let _e599 = (bitcast<i32>(_e597) - 1i);
                if (_e467 > 0i) {
                    phi_981_ = _e467;
                } else {
                    phi_981_ = 0i;
                }
                let _e602 = phi_981_;
                if (_e476 > 0i) {
                    phi_986_ = _e476;
                } else {
                    phi_986_ = 0i;
                }
                let _e605 = phi_986_;
                if (_e602 < _e599) {
                    phi_991_ = _e602;
                } else {
                    phi_991_ = _e599;
                }
                let _e608 = phi_991_;
                if (_e605 < _e599) {
                    phi_996_ = _e605;
                } else {
                    phi_996_ = _e599;
                }
                let _e611 = phi_996_;
                let _e612 = bitcast<u32>(_e608);
                let _e619 = ((((0u * _e597) + bitcast<u32>(_e611)) * (_e597 / 16u)) + (_e612 / 16u));
                let _e622 = (_e467 + 1i);
                let _e623 = (_e476 + 0i);
                let _e625 = (bitcast<i32>(_e597) - 1i);
                if (_e622 > 0i) {
                    phi_1015_ = _e622;
                } else {
                    phi_1015_ = 0i;
                }
                let _e628 = phi_1015_;
                if (_e623 > 0i) {
                    phi_1020_ = _e623;
                } else {
                    phi_1020_ = 0i;
                }
                let _e631 = phi_1020_;
                if (_e628 < _e625) {
                    phi_1025_ = _e628;
                } else {
                    phi_1025_ = _e625;
                }
                let _e634 = phi_1025_;
                if (_e631 < _e625) {
                    phi_1030_ = _e631;
                } else {
                    phi_1030_ = _e625;
                }
                let _e637 = phi_1030_;
                let _e638 = bitcast<u32>(_e634);
                let _e645 = ((((0u * _e597) + bitcast<u32>(_e637)) * (_e597 / 16u)) + (_e638 / 16u));
                let _e648 = (_e467 + 0i);
                let _e649 = (_e476 + 1i);
                let _e651 = (bitcast<i32>(_e597) - 1i);
                if (_e648 > 0i) {
                    phi_1049_ = _e648;
                } else {
                    phi_1049_ = 0i;
                }
                let _e654 = phi_1049_;
                if (_e649 > 0i) {
                    phi_1054_ = _e649;
                } else {
                    phi_1054_ = 0i;
                }
                let _e657 = phi_1054_;
                if (_e654 < _e651) {
                    phi_1059_ = _e654;
                } else {
                    phi_1059_ = _e651;
                }
                let _e660 = phi_1059_;
                if (_e657 < _e651) {
                    phi_1064_ = _e657;
                } else {
                    phi_1064_ = _e651;
                }
                let _e663 = phi_1064_;
                let _e664 = bitcast<u32>(_e660);
                let _e671 = ((((0u * _e597) + bitcast<u32>(_e663)) * (_e597 / 16u)) + (_e664 / 16u));
                let _e674 = (_e467 + 1i);
                let _e675 = (_e476 + 1i);
                let _e677 = (bitcast<i32>(_e597) - 1i);
                if (_e674 > 0i) {
                    phi_1083_ = _e674;
                } else {
                    phi_1083_ = 0i;
                }
                let _e680 = phi_1083_;
                if (_e675 > 0i) {
                    phi_1088_ = _e675;
                } else {
                    phi_1088_ = 0i;
                }
                let _e683 = phi_1088_;
                if (_e680 < _e677) {
                    phi_1093_ = _e680;
                } else {
                    phi_1093_ = _e677;
                }
                let _e686 = phi_1093_;
                if (_e683 < _e677) {
                    phi_1098_ = _e683;
                } else {
                    phi_1098_ = _e677;
                }
                let _e689 = phi_1098_;
                let _e690 = bitcast<u32>(_e686);
                let _e697 = ((((0u * _e597) + bitcast<u32>(_e689)) * (_e597 / 16u)) + (_e690 / 16u));
                if (_e619 < _e54) {
                } else {
                    return;
                }
                let _e703 = marks.member[(0u + _e619)];
                if (_e645 < _e54) {
                } else {
                    return;
                }
                let _e711 = marks.member[(0u + _e645)];
                if (_e671 < _e54) {
                } else {
                    return;
                }
                let _e720 = marks.member[(0u + _e671)];
                if (_e697 < _e54) {
                } else {
                    return;
                }
                let _e728 = marks.member[(0u + _e697)];
                let _e736 = p.member.epsilon;
                if (_e595 <= _e736) {
                    phi_1176_ = true;
                } else {
                    phi_1176_ = (_e595 >= (1f - _e736));
                }
                let _e741 = phi_1176_;
                if ((bitcast<u32>(_e595) & 2147483647u) > 2139095040u) {
                    phi_1184_ = true;
                } else {
                    phi_1184_ = !(_e741);
                }
                let _e747 = phi_1184_;
                if _e747 {
                    if (_e595 > 0f) {
                        if (_e595 < 1f) {
                            phi_1196_ = false;
                        } else {
                            phi_1196_ = true;
                        }
                        let _e751 = phi_1196_;
                        phi_1197_ = _e751;
                    } else {
                        phi_1197_ = true;
                    }
                    let _e753 = phi_1197_;
                    if _e753 {
                        phi_1201_ = 0.5f;
                    } else {
                        phi_1201_ = _e595;
                    }
                    let _e755 = phi_1201_;
                    phi_1209_ = evaluate_Verdict(_e755, true);
                } else {
                    if (_e595 > 0.5f) {
                        phi_1207_ = 1f;
                    } else {
                        phi_1207_ = 0f;
                    }
                    let _e759 = phi_1207_;
                    phi_1209_ = evaluate_Verdict(_e759, false);
                }
                let _e762 = phi_1209_;
                let _e765 = (_e762.visibility < 0.5f);
                if _e762.is_doubted {
                    phi_1232_ = evaluate_Verdict();
                    phi_1233_ = true;
                } else {
                    if _e765 {
                        phi_1219_ = 2u;
                    } else {
                        phi_1219_ = 1u;
                    }
                    let _e767 = phi_1219_;
                    if ((((((_e703 >> bitcast<u32>((((_e612 % 16u) * 2u) & 31u))) & 3u) | ((_e711 >> bitcast<u32>((((_e638 % 16u) * 2u) & 31u))) & 3u)) | (((_e720 >> bitcast<u32>((((_e664 % 16u) * 2u) & 31u))) & 3u) | ((_e728 >> bitcast<u32>((((_e690 % 16u) * 2u) & 31u))) & 3u))) & _e767) != 0u) {
                        if _e765 {
                            phi_1228_ = 0.000000059604645f;
                        } else {
                            phi_1228_ = 0.99999994f;
                        }
                        let _e771 = phi_1228_;
                        phi_1230_ = evaluate_Verdict(_e771, true);
                        phi_1231_ = false;
                    } else {
                        phi_1230_ = evaluate_Verdict();
                        phi_1231_ = true;
                    }
                    let _e774 = phi_1230_;
                    let _e776 = phi_1231_;
                    phi_1232_ = _e774;
                    phi_1233_ = _e776;
                }
                let _e778 = phi_1232_;
                let _e780 = phi_1233_;
                if _e780 {
                    phi_1238_ = evaluate_Verdict(_e762.visibility, _e762.is_doubted);
                } else {
                    phi_1238_ = _e778;
                }
                let _e783 = phi_1238_;
                phi_1243_ = evaluate_Verdict(_e783.visibility, _e783.is_doubted);
            } else {
                phi_1243_ = evaluate_Verdict(0.5f, true);
            }
            let _e789 = phi_1243_;
            phi_1244_ = _e789;
        }
        let _e791 = phi_1244_;
        if (_e60.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e60.first_primitive)] = _e791.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_prefiltered_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
