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
    var phi_153_: lt_bvh_traverse_Tree;
    var phi_154_: bool;
    var phi_155_: lt_bvh_traverse_Tree;
    var phi_156_: bool;
    var phi_161_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_153_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_154_ = false;
        } else {
            phi_153_ = lt_bvh_traverse_Tree();
            phi_154_ = true;
        }
        let _e53 = phi_153_;
        let _e55 = phi_154_;
        phi_155_ = _e53;
        phi_156_ = _e55;
    } else {
        phi_155_ = lt_bvh_traverse_Tree();
        phi_156_ = true;
    }
    let _e57 = phi_155_;
    let _e59 = phi_156_;
    if _e59 {
        phi_161_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_161_ = _e57;
    }
    let _e64 = phi_161_;
    return lt_bvh_traverse_Tree(_e64.root, _e64.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_186_: f32;
    var phi_187_: f32;
    var phi_188_: f32;
    var phi_206_: bool;
    var phi_210_: f32;
    var phi_222_: bool;
    var phi_229_: f32;
    var phi_244_: f32;
    var phi_245_: f32;
    var phi_246_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_188_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_187_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_186_ = 1f;
            } else {
                phi_186_ = param_6;
            }
            let _e49 = phi_186_;
            phi_187_ = _e49;
        }
        let _e51 = phi_187_;
        phi_188_ = _e51;
    }
    let _e53 = phi_188_;
    let _e56 = (*param_4);
    let _e60 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e56) & 2147483647u) > 2139095040u) {
        phi_206_ = true;
    } else {
        let _e64 = (_e56 > _e60);
        if _e64 {
        }
        phi_206_ = _e64;
    }
    let _e66 = phi_206_;
    if _e66 {
        phi_210_ = _e56;
    } else {
        phi_210_ = _e60;
    }
    let _e68 = phi_210_;
    let _e69 = (_e53 - param_5.x);
    if (_e69 <= 0f) {
        let _e73 = ((bitcast<u32>(_e68) & 2147483647u) > 2139095040u);
        if _e73 {
        }
        phi_222_ = _e73;
    } else {
        phi_222_ = true;
    }
    let _e75 = phi_222_;
    if _e75 {
        phi_229_ = (_e68 / (_e68 + (_e69 * _e69)));
    } else {
        phi_229_ = 1f;
    }
    let _e80 = phi_229_;
    if ((bitcast<u32>(_e80) & 2147483647u) > 2139095040u) {
        phi_246_ = _e80;
    } else {
        if (_e80 < 0f) {
            phi_245_ = 0f;
        } else {
            if (_e80 > 1f) {
                phi_244_ = 1f;
            } else {
                phi_244_ = _e80;
            }
            let _e87 = phi_244_;
            phi_245_ = _e87;
        }
        let _e89 = phi_245_;
        phi_246_ = _e89;
    }
    let _e91 = phi_246_;
    return _e91;
}

fn function_() {
    var local: f32;
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_315_: bool;
    var phi_385_: bool;
    var phi_386_: bool;
    var phi_397_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_398_: bool;
    var phi_399_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_400_: bool;
    var phi_407_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_411_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_485_: bool;
    var phi_494_: bool;
    var phi_503_: bool;
    var phi_504_: bool;
    var phi_505_: bool;
    var phi_506_: bool;
    var phi_507_: bool;
    var phi_508_: bool;
    var phi_509_: bool;
    var phi_513_: bool;
    var phi_603_: f32;
    var phi_606_: f32;
    var phi_635_: f32;
    var phi_640_: f32;
    var phi_641_: bool;
    var phi_642_: f32;
    var phi_643_: bool;
    var phi_647_: f32;
    var phi_667_: f32;
    var phi_672_: f32;
    var phi_673_: bool;
    var phi_674_: f32;
    var phi_675_: bool;
    var phi_679_: f32;
    var phi_729_: i32;
    var phi_734_: i32;
    var phi_739_: i32;
    var phi_744_: i32;
    var phi_753_: i32;
    var phi_758_: i32;
    var phi_763_: i32;
    var phi_768_: i32;
    var phi_867_: i32;
    var phi_872_: i32;
    var phi_877_: i32;
    var phi_882_: i32;
    var phi_901_: i32;
    var phi_906_: i32;
    var phi_911_: i32;
    var phi_916_: i32;
    var phi_935_: i32;
    var phi_940_: i32;
    var phi_945_: i32;
    var phi_950_: i32;
    var phi_969_: i32;
    var phi_974_: i32;
    var phi_979_: i32;
    var phi_984_: i32;
    var phi_1062_: bool;
    var phi_1070_: bool;
    var phi_1082_: bool;
    var phi_1083_: bool;
    var phi_1087_: f32;
    var phi_1093_: f32;
    var phi_1095_: evaluate_Verdict;
    var phi_1105_: u32;
    var phi_1114_: f32;
    var phi_1116_: evaluate_Verdict;
    var phi_1117_: bool;
    var phi_1118_: evaluate_Verdict;
    var phi_1119_: bool;
    var phi_1124_: evaluate_Verdict;
    var phi_1129_: evaluate_Verdict;
    var phi_1130_: evaluate_Verdict;

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
                phi_308_ = (_e84 == _e86);
                phi_309_ = false;
            } else {
                phi_308_ = bool();
                phi_309_ = true;
            }
            let _e89 = phi_308_;
            let _e91 = phi_309_;
            phi_310_ = _e89;
            phi_311_ = _e91;
        } else {
            phi_310_ = bool();
            phi_311_ = true;
        }
        let _e93 = phi_310_;
        let _e95 = phi_311_;
        if _e95 {
            phi_315_ = false;
        } else {
            phi_315_ = _e93;
        }
        let _e97 = phi_315_;
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
                    phi_386_ = true;
                } else {
                    let _e150 = p.member.light.range_squared;
                    if (_e133 <= _e150) {
                        let _e153 = p.member.light.cos_outer;
                        phi_385_ = (-((((_e115 * _e135.x) + (_e116 * _e135.y)) + (_e117 * _e135.z))) >= (_e153 * sqrt(_e133)));
                    } else {
                        phi_385_ = false;
                    }
                    let _e158 = phi_385_;
                    phi_386_ = _e158;
                }
                let _e160 = phi_386_;
                if _e160 {
                    let _e162 = samples.member[(0u + _e60.first_primitive)].flags;
                    let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
                    phi_397_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, ((_e162 & 1u) == 0u));
                    phi_398_ = false;
                } else {
                    phi_397_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_398_ = true;
                }
                let _e181 = phi_397_;
                let _e183 = phi_398_;
                phi_399_ = _e181;
                phi_400_ = _e183;
            } else {
                phi_399_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_400_ = true;
            }
            let _e185 = phi_399_;
            let _e187 = phi_400_;
            if _e187 {
                let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e193.unnamed.visibility, false), _e193.unnamed_1);
                phi_407_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e199.unnamed, true);
            } else {
                phi_407_ = _e185;
            }
            let _e204 = phi_407_;
            phi_411_ = _e204;
        } else {
            let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e210.unnamed.visibility, false), _e210.unnamed_1);
            phi_411_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e216.unnamed, true);
        }
        let _e221 = phi_411_;
        if _e221.unnamed_1 {
            phi_1130_ = evaluate_Verdict(_e221.unnamed.visibility, _e221.unnamed.is_doubted);
        } else {
            let _e229 = samples.member[(0u + _e60.first_primitive)].position;
            let _e247 = ((((_e70.projection.row_w.x * _e229.x) + (_e70.projection.row_w.y * _e229.y)) + (_e70.projection.row_w.z * _e229.z)) + (_e70.projection.row_w.w * 1f));
            let _e261 = (((((_e70.projection.row_x.x * _e229.x) + (_e70.projection.row_x.y * _e229.y)) + (_e70.projection.row_x.z * _e229.z)) + (_e70.projection.row_x.w * 1f)) / _e247);
            let _e275 = (((((_e70.projection.row_y.x * _e229.x) + (_e70.projection.row_y.y * _e229.y)) + (_e70.projection.row_y.z * _e229.z)) + (_e70.projection.row_y.w * 1f)) / _e247);
            let _e288 = ((((_e70.projection.row_z.x * _e229.x) + (_e70.projection.row_z.y * _e229.y)) + (_e70.projection.row_z.z * _e229.z)) + (_e70.projection.row_z.w * 1f));
            if (_e247 > 0f) {
                if (_e261 >= 0f) {
                    phi_485_ = (_e261 <= 1f);
                } else {
                    phi_485_ = false;
                }
                let _e293 = phi_485_;
                if _e293 {
                    if (_e275 >= 0f) {
                        phi_494_ = (_e275 <= 1f);
                    } else {
                        phi_494_ = false;
                    }
                    let _e297 = phi_494_;
                    if _e297 {
                        if (_e288 >= 0f) {
                            phi_503_ = (_e288 <= 1f);
                        } else {
                            phi_503_ = false;
                        }
                        let _e301 = phi_503_;
                        phi_504_ = _e301;
                        phi_505_ = false;
                    } else {
                        phi_504_ = bool();
                        phi_505_ = true;
                    }
                    let _e303 = phi_504_;
                    let _e305 = phi_505_;
                    phi_506_ = _e303;
                    phi_507_ = _e305;
                } else {
                    phi_506_ = bool();
                    phi_507_ = true;
                }
                let _e307 = phi_506_;
                let _e309 = phi_507_;
                phi_508_ = _e307;
                phi_509_ = _e309;
            } else {
                phi_508_ = bool();
                phi_509_ = true;
            }
            let _e311 = phi_508_;
            let _e313 = phi_509_;
            if _e313 {
                phi_513_ = false;
            } else {
                phi_513_ = _e311;
            }
            let _e315 = phi_513_;
            if _e315 {
                if (0f > 0f) {
                    let _e318 = samples.member[(0u + _e60.first_primitive)].normal;
                    let _e320 = p.member.map_size;
                    let _e390 = ((abs(((((_e66.row_x.x * _e318.x) + (_e66.row_x.y * _e318.y)) + (_e66.row_x.z * _e318.z)) / (((_e66.row_x.x * _e66.row_x.x) + (_e66.row_x.y * _e66.row_x.y)) + (_e66.row_x.z * _e66.row_x.z)))) + abs(((((_e66.row_y.x * _e318.x) + (_e66.row_y.y * _e318.y)) + (_e66.row_y.z * _e318.z)) / (((_e66.row_y.x * _e66.row_y.x) + (_e66.row_y.y * _e66.row_y.y)) + (_e66.row_y.z * _e66.row_y.z))))) / (abs(((((_e66.row_z.x * _e318.x) + (_e66.row_z.y * _e318.y)) + (_e66.row_z.z * _e318.z)) / (((_e66.row_z.x * _e66.row_z.x) + (_e66.row_z.y * _e66.row_z.y)) + (_e66.row_z.z * _e66.row_z.z)))) * f32(_e320)));
                    if (_e390 < 0.002f) {
                        phi_603_ = _e390;
                    } else {
                        phi_603_ = 0.002f;
                    }
                    let _e393 = phi_603_;
                    phi_606_ = (_e288 - (0f * _e393));
                } else {
                    phi_606_ = _e288;
                }
                let _e397 = phi_606_;
                let _e399 = p.member.map_size;
                let _e400 = f32(_e399);
                let _e403 = ((_e261 * _e400) - 0.5f);
                let _e404 = ((_e275 * _e400) - 0.5f);
                if (_e403 > -8388608f) {
                    let _e416 = f32(select(0i, select(select(i32(_e403), i32(-2147483648), (_e403 < bitcast<f32>(3472883712u))), 2147483647i, (_e403 > bitcast<f32>(1325400063u))), (_e403 == _e403)));
                    if (_e416 > _e403) {
                        phi_635_ = 1f;
                    } else {
                        phi_635_ = 0f;
                    }
                    let _e419 = phi_635_;
                    if (_e403 < 8388608f) {
                        phi_640_ = (_e416 - _e419);
                        phi_641_ = false;
                    } else {
                        phi_640_ = f32();
                        phi_641_ = true;
                    }
                    let _e422 = phi_640_;
                    let _e424 = phi_641_;
                    phi_642_ = _e422;
                    phi_643_ = _e424;
                } else {
                    phi_642_ = f32();
                    phi_643_ = true;
                }
                let _e426 = phi_642_;
                let _e428 = phi_643_;
                if _e428 {
                    phi_647_ = _e403;
                } else {
                    phi_647_ = _e426;
                }
                let _e430 = phi_647_;
                if (_e404 > -8388608f) {
                    let _e442 = f32(select(0i, select(select(i32(_e404), i32(-2147483648), (_e404 < bitcast<f32>(3472883712u))), 2147483647i, (_e404 > bitcast<f32>(1325400063u))), (_e404 == _e404)));
                    if (_e442 > _e404) {
                        phi_667_ = 1f;
                    } else {
                        phi_667_ = 0f;
                    }
                    let _e445 = phi_667_;
                    if (_e404 < 8388608f) {
                        phi_672_ = (_e442 - _e445);
                        phi_673_ = false;
                    } else {
                        phi_672_ = f32();
                        phi_673_ = true;
                    }
                    let _e448 = phi_672_;
                    let _e450 = phi_673_;
                    phi_674_ = _e448;
                    phi_675_ = _e450;
                } else {
                    phi_674_ = f32();
                    phi_675_ = true;
                }
                let _e452 = phi_674_;
                let _e454 = phi_675_;
                if _e454 {
                    phi_679_ = _e404;
                } else {
                    phi_679_ = _e452;
                }
                let _e456 = phi_679_;
                let _e457 = (_e403 - _e430);
                let _e458 = (_e404 - _e456);
                let _e467 = select(0i, select(select(i32(_e430), i32(-2147483648), (_e430 < bitcast<f32>(3472883712u))), 2147483647i, (_e430 > bitcast<f32>(1325400063u))), (_e430 == _e430));
                let _e476 = select(0i, select(select(i32(_e456), i32(-2147483648), (_e456 < bitcast<f32>(3472883712u))), 2147483647i, (_e456 > bitcast<f32>(1325400063u))), (_e456 == _e456));
                let _e479 = ((1f - _e457) * (1f - _e458));
                let _e481 = (_e457 * (1f - _e458));
                let _e483 = ((1f - _e457) * _e458);
                let _e484 = (_e457 * _e458);
                let _e486 = p.member.test;
                let _e487 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e486);
                let _e489 = p.member.map_size;
                local = _e487;
                let _e491 = ((0u * _e489) * _e489);
                let _e493 = (bitcast<i32>(_e489) - 1i);
                if (_e467 > 0i) {
                    phi_729_ = _e467;
                } else {
                    phi_729_ = 0i;
                }
                let _e496 = phi_729_;
                if (_e476 > 0i) {
                    phi_734_ = _e476;
                } else {
                    phi_734_ = 0i;
                }
                let _e499 = phi_734_;
                if (_e496 < _e493) {
                    phi_739_ = _e496;
                } else {
                    phi_739_ = _e493;
                }
                let _e502 = phi_739_;
                if (_e499 < _e493) {
                    phi_744_ = _e499;
                } else {
                    phi_744_ = _e493;
                }
                let _e505 = phi_744_;
                let _e506 = bitcast<u32>(_e502);
                let _e508 = (_e467 + 1i);
                let _e509 = (_e476 + 1i);
                if (_e508 > 0i) {
                    phi_753_ = _e508;
                } else {
                    phi_753_ = 0i;
                }
                let _e512 = phi_753_;
                if (_e509 > 0i) {
                    phi_758_ = _e509;
                } else {
                    phi_758_ = 0i;
                }
                let _e515 = phi_758_;
                if (_e512 < _e493) {
                    phi_763_ = _e512;
                } else {
                    phi_763_ = _e493;
                }
                let _e518 = phi_763_;
                if (_e515 < _e493) {
                    phi_768_ = _e515;
                } else {
                    phi_768_ = _e493;
                }
                let _e521 = phi_768_;
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
                let _e595 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e537.x * _e479) + (_e549.x * _e481)) + (_e565.x * _e483)) + (_e581.x * _e484)), ((((_e537.y * _e479) + (_e549.y * _e481)) + (_e565.y * _e483)) + (_e581.y * _e484)), ((((_e537.z * _e479) + (_e549.z * _e481)) + (_e565.z * _e483)) + (_e581.z * _e484)), ((((_e537.w * _e479) + (_e549.w * _e481)) + (_e565.w * _e483)) + (_e581.w * _e484))), _e397);
                let _e597 = p.member.map_size;
                let _e599 = (bitcast<i32>(_e597) - 1i);
                if (_e467 > 0i) {
                    phi_867_ = _e467;
                } else {
                    phi_867_ = 0i;
                }
                let _e602 = phi_867_;
                if (_e476 > 0i) {
                    phi_872_ = _e476;
                } else {
                    phi_872_ = 0i;
                }
                let _e605 = phi_872_;
                if (_e602 < _e599) {
                    phi_877_ = _e602;
                } else {
                    phi_877_ = _e599;
                }
                let _e608 = phi_877_;
                if (_e605 < _e599) {
                    phi_882_ = _e605;
                } else {
                    phi_882_ = _e599;
                }
                let _e611 = phi_882_;
                let _e612 = bitcast<u32>(_e608);
                let _e619 = ((((0u * _e597) + bitcast<u32>(_e611)) * (_e597 / 16u)) + (_e612 / 16u));
                let _e622 = (_e467 + 1i);
                let _e623 = (_e476 + 0i);
                let _e625 = (bitcast<i32>(_e597) - 1i);
                if (_e622 > 0i) {
                    phi_901_ = _e622;
                } else {
                    phi_901_ = 0i;
                }
                let _e628 = phi_901_;
                if (_e623 > 0i) {
                    phi_906_ = _e623;
                } else {
                    phi_906_ = 0i;
                }
                let _e631 = phi_906_;
                if (_e628 < _e625) {
                    phi_911_ = _e628;
                } else {
                    phi_911_ = _e625;
                }
                let _e634 = phi_911_;
                if (_e631 < _e625) {
                    phi_916_ = _e631;
                } else {
                    phi_916_ = _e625;
                }
                let _e637 = phi_916_;
                let _e638 = bitcast<u32>(_e634);
                let _e645 = ((((0u * _e597) + bitcast<u32>(_e637)) * (_e597 / 16u)) + (_e638 / 16u));
                let _e648 = (_e467 + 0i);
                let _e649 = (_e476 + 1i);
                let _e651 = (bitcast<i32>(_e597) - 1i);
                if (_e648 > 0i) {
                    phi_935_ = _e648;
                } else {
                    phi_935_ = 0i;
                }
                let _e654 = phi_935_;
                if (_e649 > 0i) {
                    phi_940_ = _e649;
                } else {
                    phi_940_ = 0i;
                }
                let _e657 = phi_940_;
                if (_e654 < _e651) {
                    phi_945_ = _e654;
                } else {
                    phi_945_ = _e651;
                }
                let _e660 = phi_945_;
                if (_e657 < _e651) {
                    phi_950_ = _e657;
                } else {
                    phi_950_ = _e651;
                }
                let _e663 = phi_950_;
                let _e664 = bitcast<u32>(_e660);
                let _e671 = ((((0u * _e597) + bitcast<u32>(_e663)) * (_e597 / 16u)) + (_e664 / 16u));
                let _e674 = (_e467 + 1i);
                let _e675 = (_e476 + 1i);
                let _e677 = (bitcast<i32>(_e597) - 1i);
                if (_e674 > 0i) {
                    phi_969_ = _e674;
                } else {
                    phi_969_ = 0i;
                }
                let _e680 = phi_969_;
                if (_e675 > 0i) {
                    phi_974_ = _e675;
                } else {
                    phi_974_ = 0i;
                }
                let _e683 = phi_974_;
                if (_e680 < _e677) {
                    phi_979_ = _e680;
                } else {
                    phi_979_ = _e677;
                }
                let _e686 = phi_979_;
                if (_e683 < _e677) {
                    phi_984_ = _e683;
                } else {
                    phi_984_ = _e677;
                }
                let _e689 = phi_984_;
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
                    phi_1062_ = true;
                } else {
                    phi_1062_ = (_e595 >= (1f - _e736));
                }
                let _e741 = phi_1062_;
                if ((bitcast<u32>(_e595) & 2147483647u) > 2139095040u) {
                    phi_1070_ = true;
                } else {
                    phi_1070_ = !(_e741);
                }
                let _e747 = phi_1070_;
                if _e747 {
                    if (_e595 > 0f) {
                        if (_e595 < 1f) {
                            phi_1082_ = false;
                        } else {
                            phi_1082_ = true;
                        }
                        let _e751 = phi_1082_;
                        phi_1083_ = _e751;
                    } else {
                        phi_1083_ = true;
                    }
                    let _e753 = phi_1083_;
                    if _e753 {
                        phi_1087_ = 0.5f;
                    } else {
                        phi_1087_ = _e595;
                    }
                    let _e755 = phi_1087_;
                    phi_1095_ = evaluate_Verdict(_e755, true);
                } else {
                    if (_e595 > 0.5f) {
                        phi_1093_ = 1f;
                    } else {
                        phi_1093_ = 0f;
                    }
                    let _e759 = phi_1093_;
                    phi_1095_ = evaluate_Verdict(_e759, false);
                }
                let _e762 = phi_1095_;
                let _e765 = (_e762.visibility < 0.5f);
                if _e762.is_doubted {
                    phi_1118_ = evaluate_Verdict();
                    phi_1119_ = true;
                } else {
                    if _e765 {
                        phi_1105_ = 2u;
                    } else {
                        phi_1105_ = 1u;
                    }
                    let _e767 = phi_1105_;
                    if ((((((_e703 >> bitcast<u32>((((_e612 % 16u) * 2u) & 31u))) & 3u) | ((_e711 >> bitcast<u32>((((_e638 % 16u) * 2u) & 31u))) & 3u)) | (((_e720 >> bitcast<u32>((((_e664 % 16u) * 2u) & 31u))) & 3u) | ((_e728 >> bitcast<u32>((((_e690 % 16u) * 2u) & 31u))) & 3u))) & _e767) != 0u) {
                        if _e765 {
                            phi_1114_ = 0.000000059604645f;
                        } else {
                            phi_1114_ = 0.99999994f;
                        }
                        let _e771 = phi_1114_;
                        phi_1116_ = evaluate_Verdict(_e771, true);
                        phi_1117_ = false;
                    } else {
                        phi_1116_ = evaluate_Verdict();
                        phi_1117_ = true;
                    }
                    let _e774 = phi_1116_;
                    let _e776 = phi_1117_;
                    phi_1118_ = _e774;
                    phi_1119_ = _e776;
                }
                let _e778 = phi_1118_;
                let _e780 = phi_1119_;
                if _e780 {
                    phi_1124_ = evaluate_Verdict(_e762.visibility, _e762.is_doubted);
                } else {
                    phi_1124_ = _e778;
                }
                let _e783 = phi_1124_;
                phi_1129_ = evaluate_Verdict(_e783.visibility, _e783.is_doubted);
            } else {
                phi_1129_ = evaluate_Verdict(0.5f, true);
            }
            let _e789 = phi_1129_;
            phi_1130_ = _e789;
        }
        let _e791 = phi_1130_;
        if (_e60.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e60.first_primitive)] = _e791.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_vsm_prefiltered_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
