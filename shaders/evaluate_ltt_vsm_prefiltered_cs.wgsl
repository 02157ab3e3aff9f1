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

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct type_50 {
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
var<storage, read_write> list: type_50;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_157_: lt_bvh_traverse_Tree;
    var phi_158_: bool;
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_165_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_157_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_158_ = false;
        } else {
            phi_157_ = lt_bvh_traverse_Tree();
            phi_158_ = true;
        }
        let _e55 = phi_157_;
        let _e57 = phi_158_;
        phi_159_ = _e55;
        phi_160_ = _e57;
    } else {
        phi_159_ = lt_bvh_traverse_Tree();
        phi_160_ = true;
    }
    let _e59 = phi_159_;
    let _e61 = phi_160_;
    if _e61 {
        phi_165_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_165_ = _e59;
    }
    let _e66 = phi_165_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_190_: f32;
    var phi_191_: f32;
    var phi_192_: f32;
    var phi_210_: bool;
    var phi_214_: f32;
    var phi_226_: bool;
    var phi_233_: f32;
    var phi_248_: f32;
    var phi_249_: f32;
    var phi_250_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_192_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_191_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_190_ = 1f;
            } else {
                phi_190_ = param_6;
            }
            let _e51 = phi_190_;
            phi_191_ = _e51;
        }
        let _e53 = phi_191_;
        phi_192_ = _e53;
    }
    let _e55 = phi_192_;
    let _e58 = (*param_4);
    let _e62 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e58) & 2147483647u) > 2139095040u) {
        phi_210_ = true;
    } else {
        let _e66 = (_e58 > _e62);
        if _e66 {
        }
        phi_210_ = _e66;
    }
    let _e68 = phi_210_;
    if _e68 {
        phi_214_ = _e58;
    } else {
        phi_214_ = _e62;
    }
    let _e70 = phi_214_;
    let _e71 = (_e55 - param_5.x);
    if (_e71 <= 0f) {
        let _e75 = ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u);
        if _e75 {
        }
        phi_226_ = _e75;
    } else {
        phi_226_ = true;
    }
    let _e77 = phi_226_;
    if _e77 {
        phi_233_ = (_e70 / (_e70 + (_e71 * _e71)));
    } else {
        phi_233_ = 1f;
    }
    let _e82 = phi_233_;
    if ((bitcast<u32>(_e82) & 2147483647u) > 2139095040u) {
        phi_250_ = _e82;
    } else {
        if (_e82 < 0f) {
            phi_249_ = 0f;
        } else {
            if (_e82 > 1f) {
                phi_248_ = 1f;
            } else {
                phi_248_ = _e82;
            }
            let _e89 = phi_248_;
            phi_249_ = _e89;
        }
        let _e91 = phi_249_;
        phi_250_ = _e91;
    }
    let _e93 = phi_250_;
    return _e93;
}

fn function_() {
    var local_1: f32;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_304_: bool;
    var phi_308_: bool;
    var phi_378_: bool;
    var phi_379_: bool;
    var phi_390_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_391_: bool;
    var phi_392_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_393_: bool;
    var phi_400_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_404_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_478_: bool;
    var phi_487_: bool;
    var phi_496_: bool;
    var phi_497_: bool;
    var phi_498_: bool;
    var phi_499_: bool;
    var phi_500_: bool;
    var phi_501_: bool;
    var phi_502_: bool;
    var phi_506_: bool;
    var phi_596_: f32;
    var phi_599_: f32;
    var phi_628_: f32;
    var phi_633_: f32;
    var phi_634_: bool;
    var phi_635_: f32;
    var phi_636_: bool;
    var phi_640_: f32;
    var phi_660_: f32;
    var phi_665_: f32;
    var phi_666_: bool;
    var phi_667_: f32;
    var phi_668_: bool;
    var phi_672_: f32;
    var phi_720_: i32;
    var phi_725_: i32;
    var phi_730_: i32;
    var phi_735_: i32;
    var phi_744_: i32;
    var phi_749_: i32;
    var phi_754_: i32;
    var phi_759_: i32;
    var phi_856_: bool;
    var phi_864_: bool;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_881_: f32;
    var phi_887_: f32;
    var phi_889_: evaluate_Verdict;
    var phi_899_: u32;
    var phi_908_: f32;
    var phi_910_: evaluate_Verdict;
    var phi_911_: bool;
    var phi_912_: evaluate_Verdict;
    var phi_913_: bool;
    var phi_918_: evaluate_Verdict;
    var phi_923_: evaluate_Verdict;
    var phi_924_: evaluate_Verdict;
    var phi_928_: bool;
    var phi_929_: u32;
    var phi_940_: u32;
    var phi_957_: u32;

    let _e43 = id_1;
    let _e44 = local_2;
    let _e49 = arrayLength((&map.member));
    let _e54 = p.member.size[0u];
    let _e56 = p.member.size[1u];
    let _e57 = lt_shaders_entry_pixel_index(_e43, _e54, _e56);
    if (bitcast<i32>(_e57.root) != 0i) {
        let _e64 = p.member.projection;
        let _e65 = lt_math_OneLevel(_e64);
        let _e69 = samples.member[_e57.first_primitive].normal[0u];
        let _e71 = global[0u];
        if (_e69 == _e71) {
            let _e74 = samples.member[_e57.first_primitive].normal[1u];
            let _e76 = global[1u];
            if (_e74 == _e76) {
                let _e79 = samples.member[_e57.first_primitive].normal[2u];
                let _e81 = global[2u];
                phi_301_ = (_e79 == _e81);
                phi_302_ = false;
            } else {
                phi_301_ = bool();
                phi_302_ = true;
            }
            let _e84 = phi_301_;
            let _e86 = phi_302_;
            phi_303_ = _e84;
            phi_304_ = _e86;
        } else {
            phi_303_ = bool();
            phi_304_ = true;
        }
        let _e88 = phi_303_;
        let _e90 = phi_304_;
        if _e90 {
            phi_308_ = false;
        } else {
            phi_308_ = _e88;
        }
        let _e92 = phi_308_;
        if !(_e92) {
            let _e95 = samples.member[_e57.first_primitive].position;
            let _e97 = p.member.light.place;
            let _e103 = p.member.light.place[3u];
            let _e110 = (_e97.x - (_e95.x * _e103));
            let _e111 = (_e97.y - (_e95.y * _e103));
            let _e112 = (_e97.z - (_e95.z * _e103));
            let _e114 = samples.member[_e57.first_primitive].normal;
            if ((((_e114.x * _e110) + (_e114.y * _e111)) + (_e114.z * _e112)) > 0f) {
                let _e128 = (((_e110 * _e110) + (_e111 * _e111)) + (_e112 * _e112));
                let _e130 = p.member.light.axis;
                let _e142 = p.member.light.place[3u];
                if (_e142 == 0f) {
                    phi_379_ = true;
                } else {
                    let _e145 = p.member.light.range_squared;
                    if (_e128 <= _e145) {
                        let _e148 = p.member.light.cos_outer;
                        phi_378_ = (-((((_e110 * _e130.x) + (_e111 * _e130.y)) + (_e112 * _e130.z))) >= (_e148 * sqrt(_e128)));
                    } else {
                        phi_378_ = false;
                    }
                    let _e153 = phi_378_;
                    phi_379_ = _e153;
                }
                let _e155 = phi_379_;
                if _e155 {
                    let _e157 = samples.member[_e57.first_primitive].flags;
                    let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e165.unnamed.visibility, false), _e165.unnamed_1);
                    phi_390_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e171.unnamed, ((_e157 & 1u) == 0u));
                    phi_391_ = false;
                } else {
                    phi_390_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_391_ = true;
                }
                let _e176 = phi_390_;
                let _e178 = phi_391_;
                phi_392_ = _e176;
                phi_393_ = _e178;
            } else {
                phi_392_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_393_ = true;
            }
            let _e180 = phi_392_;
            let _e182 = phi_393_;
            if _e182 {
                let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e188.unnamed.visibility, false), _e188.unnamed_1);
                phi_400_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e194.unnamed, true);
            } else {
                phi_400_ = _e180;
            }
            let _e199 = phi_400_;
            phi_404_ = _e199;
        } else {
            let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
            phi_404_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
        }
        let _e216 = phi_404_;
        if _e216.unnamed_1 {
            phi_924_ = evaluate_Verdict(_e216.unnamed.visibility, _e216.unnamed.is_doubted);
        } else {
            let _e224 = samples.member[_e57.first_primitive].position;
            let _e242 = ((((_e65.projection.row_w.x * _e224.x) + (_e65.projection.row_w.y * _e224.y)) + (_e65.projection.row_w.z * _e224.z)) + (_e65.projection.row_w.w * 1f));
            let _e256 = (((((_e65.projection.row_x.x * _e224.x) + (_e65.projection.row_x.y * _e224.y)) + (_e65.projection.row_x.z * _e224.z)) + (_e65.projection.row_x.w * 1f)) / _e242);
            let _e270 = (((((_e65.projection.row_y.x * _e224.x) + (_e65.projection.row_y.y * _e224.y)) + (_e65.projection.row_y.z * _e224.z)) + (_e65.projection.row_y.w * 1f)) / _e242);
            let _e283 = ((((_e65.projection.row_z.x * _e224.x) + (_e65.projection.row_z.y * _e224.y)) + (_e65.projection.row_z.z * _e224.z)) + (_e65.projection.row_z.w * 1f));
            if (_e242 > 0f) {
                if (_e256 >= 0f) {
                    phi_478_ = (_e256 <= 1f);
                } else {
                    phi_478_ = false;
                }
                let _e288 = phi_478_;
                if _e288 {
                    if (_e270 >= 0f) {
                        phi_487_ = (_e270 <= 1f);
                    } else {
                        phi_487_ = false;
                    }
                    let _e292 = phi_487_;
                    if _e292 {
                        if (_e283 >= 0f) {
                            phi_496_ = (_e283 <= 1f);
                        } else {
                            phi_496_ = false;
                        }
                        let _e296 = phi_496_;
                        phi_497_ = _e296;
                        phi_498_ = false;
                    } else {
                        phi_497_ = bool();
                        phi_498_ = true;
                    }
                    let _e298 = phi_497_;
                    let _e300 = phi_498_;
                    phi_499_ = _e298;
                    phi_500_ = _e300;
                } else {
                    phi_499_ = bool();
                    phi_500_ = true;
                }
                let _e302 = phi_499_;
                let _e304 = phi_500_;
                phi_501_ = _e302;
                phi_502_ = _e304;
            } else {
                phi_501_ = bool();
                phi_502_ = true;
            }
            let _e306 = phi_501_;
            let _e308 = phi_502_;
            if _e308 {
                phi_506_ = false;
            } else {
                phi_506_ = _e306;
            }
            let _e310 = phi_506_;
            if _e310 {
                if (0f > 0f) {
                    let _e313 = samples.member[_e57.first_primitive].normal;
                    let _e315 = p.member.map_size;
                    let _e385 = ((abs(((((_e64.row_x.x * _e313.x) + (_e64.row_x.y * _e313.y)) + (_e64.row_x.z * _e313.z)) / (((_e64.row_x.x * _e64.row_x.x) + (_e64.row_x.y * _e64.row_x.y)) + (_e64.row_x.z * _e64.row_x.z)))) + abs(((((_e64.row_y.x * _e313.x) + (_e64.row_y.y * _e313.y)) + (_e64.row_y.z * _e313.z)) / (((_e64.row_y.x * _e64.row_y.x) + (_e64.row_y.y * _e64.row_y.y)) + (_e64.row_y.z * _e64.row_y.z))))) / (abs(((((_e64.row_z.x * _e313.x) + (_e64.row_z.y * _e313.y)) + (_e64.row_z.z * _e313.z)) / (((_e64.row_z.x * _e64.row_z.x) + (_e64.row_z.y * _e64.row_z.y)) + (_e64.row_z.z * _e64.row_z.z)))) * f32(_e315)));
                    if (_e385 < 0.002f) {
                        phi_596_ = _e385;
                    } else {
                        phi_596_ = 0.002f;
                    }
                    let _e388 = phi_596_;
                    phi_599_ = (_e283 - (0f * _e388));
                } else {
                    phi_599_ = _e283;
                }
                let _e392 = phi_599_;
                let _e394 = p.member.map_size;
                let _e395 = f32(_e394);
                let _e398 = ((_e256 * _e395) - 0.5f);
                let _e399 = ((_e270 * _e395) - 0.5f);
                if (_e398 > -8388608f) {
                    let _e411 = f32(select(0i, select(select(i32(_e398), i32(-2147483648), (_e398 < bitcast<f32>(3472883712u))), 2147483647i, (_e398 > bitcast<f32>(1325400063u))), (_e398 == _e398)));
                    if (_e411 > _e398) {
                        phi_628_ = 1f;
                    } else {
                        phi_628_ = 0f;
                    }
                    let _e414 = phi_628_;
                    if (_e398 < 8388608f) {
                        phi_633_ = (_e411 - _e414);
                        phi_634_ = false;
                    } else {
                        phi_633_ = f32();
                        phi_634_ = true;
                    }
                    let _e417 = phi_633_;
                    let _e419 = phi_634_;
                    phi_635_ = _e417;
                    phi_636_ = _e419;
                } else {
                    phi_635_ = f32();
                    phi_636_ = true;
                }
                let _e421 = phi_635_;
                let _e423 = phi_636_;
                if _e423 {
                    phi_640_ = _e398;
                } else {
                    phi_640_ = _e421;
                }
                let _e425 = phi_640_;
                if (_e399 > -8388608f) {
                    let _e437 = f32(select(0i, select(select(i32(_e399), i32(-2147483648), (_e399 < bitcast<f32>(3472883712u))), 2147483647i, (_e399 > bitcast<f32>(1325400063u))), (_e399 == _e399)));
                    if (_e437 > _e399) {
                        phi_660_ = 1f;
                    } else {
                        phi_660_ = 0f;
                    }
                    let _e440 = phi_660_;
                    if (_e399 < 8388608f) {
                        phi_665_ = (_e437 - _e440);
                        phi_666_ = false;
                    } else {
                        phi_665_ = f32();
                        phi_666_ = true;
                    }
                    let _e443 = phi_665_;
                    let _e445 = phi_666_;
                    phi_667_ = _e443;
                    phi_668_ = _e445;
                } else {
                    phi_667_ = f32();
                    phi_668_ = true;
                }
                let _e447 = phi_667_;
                let _e449 = phi_668_;
                if _e449 {
                    phi_672_ = _e399;
                } else {
                    phi_672_ = _e447;
                }
                let _e451 = phi_672_;
                let _e452 = (_e398 - _e425);
                let _e453 = (_e399 - _e451);
                let _e462 = select(0i, select(select(i32(_e425), i32(-2147483648), (_e425 < bitcast<f32>(3472883712u))), 2147483647i, (_e425 > bitcast<f32>(1325400063u))), (_e425 == _e425));
                let _e471 = select(0i, select(select(i32(_e451), i32(-2147483648), (_e451 < bitcast<f32>(3472883712u))), 2147483647i, (_e451 > bitcast<f32>(1325400063u))), (_e451 == _e451));
                let _e474 = ((1f - _e452) * (1f - _e453));
                let _e476 = (_e452 * (1f - _e453));
                let _e478 = ((1f - _e452) * _e453);
                let _e479 = (_e452 * _e453);
                let _e481 = p.member.test;
                let _e482 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e481);
                let _e484 = p.member.map_size;
                local_1 = _e482;
                let _e486 = ((0u * _e484) * _e484);
                let _e488 = (bitcast<i32>(_e484) - 1i);
                if (_e462 > 0i) {
                    phi_720_ = _e462;
                } else {
                    phi_720_ = 0i;
                }
                let _e491 = phi_720_;
                if (_e471 > 0i) {
                    phi_725_ = _e471;
                } else {
                    phi_725_ = 0i;
                }
                let _e494 = phi_725_;
                if (_e491 < _e488) {
                    phi_730_ = _e491;
                } else {
                    phi_730_ = _e488;
                }
                let _e497 = phi_730_;
                if (_e494 < _e488) {
                    phi_735_ = _e494;
                } else {
                    phi_735_ = _e488;
                }
                let _e500 = phi_735_;
                let _e501 = bitcast<u32>(_e497);
                let _e503 = (_e462 + 1i);
                let _e504 = (_e471 + 1i);
                if (_e503 > 0i) {
                    phi_744_ = _e503;
                } else {
                    phi_744_ = 0i;
                }
                let _e507 = phi_744_;
                if (_e504 > 0i) {
                    phi_749_ = _e504;
                } else {
                    phi_749_ = 0i;
                }
                let _e510 = phi_749_;
                if (_e507 < _e488) {
                    phi_754_ = _e507;
                } else {
                    phi_754_ = _e488;
                }
                let _e513 = phi_754_;
                if (_e510 < _e488) {
                    phi_759_ = _e510;
                } else {
                    phi_759_ = _e488;
                }
                let _e516 = phi_759_;
                let _e517 = bitcast<u32>(_e513);
                let _e519 = (bitcast<u32>(_e500) * _e484);
                let _e520 = (bitcast<u32>(_e516) * _e484);
                let _e525 = ((_e519 + _e501) + _e486);
                let _e526 = ((_e519 + _e517) + _e486);
                let _e527 = ((_e520 + _e501) + _e486);
                let _e528 = ((_e520 + _e517) + _e486);
                if (_e525 < _e49) {
                } else {
                    return;
                }
                let _e532 = map.member[(0u + _e525)];
                if (_e526 < _e49) {
                } else {
                    return;
                }
                let _e544 = map.member[(0u + _e526)];
                if (_e527 < _e49) {
                } else {
                    return;
                }
                let _e560 = map.member[(0u + _e527)];
                if (_e528 < _e49) {
                } else {
                    return;
                }
                let _e576 = map.member[(0u + _e528)];
                let _e590 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e532.x * _e474) + (_e544.x * _e476)) + (_e560.x * _e478)) + (_e576.x * _e479)), ((((_e532.y * _e474) + (_e544.y * _e476)) + (_e560.y * _e478)) + (_e576.y * _e479)), ((((_e532.z * _e474) + (_e544.z * _e476)) + (_e560.z * _e478)) + (_e576.z * _e479)), ((((_e532.w * _e474) + (_e544.w * _e476)) + (_e560.w * _e478)) + (_e576.w * _e479))), _e392);
                let _e594 = p.member.epsilon;
                if (_e590 <= _e594) {
                    phi_856_ = true;
                } else {
                    phi_856_ = (_e590 >= (1f - _e594));
                }
                let _e599 = phi_856_;
                if ((bitcast<u32>(_e590) & 2147483647u) > 2139095040u) {
                    phi_864_ = true;
                } else {
                    phi_864_ = !(_e599);
                }
                let _e605 = phi_864_;
                if _e605 {
                    if (_e590 > 0f) {
                        if (_e590 < 1f) {
                            phi_876_ = false;
                        } else {
                            phi_876_ = true;
                        }
                        let _e609 = phi_876_;
                        phi_877_ = _e609;
                    } else {
                        phi_877_ = true;
                    }
                    let _e611 = phi_877_;
                    if _e611 {
                        phi_881_ = 0.5f;
                    } else {
                        phi_881_ = _e590;
                    }
                    let _e613 = phi_881_;
                    phi_889_ = evaluate_Verdict(_e613, true);
                } else {
                    if (_e590 > 0.5f) {
                        phi_887_ = 1f;
                    } else {
                        phi_887_ = 0f;
                    }
                    let _e617 = phi_887_;
                    phi_889_ = evaluate_Verdict(_e617, false);
                }
                let _e620 = phi_889_;
                let _e623 = (_e620.visibility < 0.5f);
                if _e620.is_doubted {
                    phi_912_ = evaluate_Verdict();
                    phi_913_ = true;
                } else {
                    if _e623 {
                        phi_899_ = 2u;
                    } else {
                        phi_899_ = 1u;
                    }
                    let _e625 = phi_899_;
                    if ((0u & _e625) != 0u) {
                        if _e623 {
                            phi_908_ = 0.000000059604645f;
                        } else {
                            phi_908_ = 0.99999994f;
                        }
                        let _e629 = phi_908_;
                        phi_910_ = evaluate_Verdict(_e629, true);
                        phi_911_ = false;
                    } else {
                        phi_910_ = evaluate_Verdict();
                        phi_911_ = true;
                    }
                    let _e632 = phi_910_;
                    let _e634 = phi_911_;
                    phi_912_ = _e632;
                    phi_913_ = _e634;
                }
                let _e636 = phi_912_;
                let _e638 = phi_913_;
                if _e638 {
                    phi_918_ = evaluate_Verdict(_e620.visibility, _e620.is_doubted);
                } else {
                    phi_918_ = _e636;
                }
                let _e641 = phi_918_;
                phi_923_ = evaluate_Verdict(_e641.visibility, _e641.is_doubted);
            } else {
                phi_923_ = evaluate_Verdict(0.5f, true);
            }
            let _e647 = phi_923_;
            phi_924_ = _e647;
        }
        let _e649 = phi_924_;
        visibility.member[_e57.first_primitive] = _e649.visibility;
        phi_928_ = _e649.is_doubted;
        phi_929_ = _e57.first_primitive;
    } else {
        phi_928_ = false;
        phi_929_ = 0u;
    }
    let _e654 = phi_928_;
    let _e656 = phi_929_;
    if (_e44 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e654 {
        let _e660 = atomicAdd((&shared_[0u]), 1u);
        phi_940_ = _e660;
    } else {
        phi_940_ = 0u;
    }
    let _e662 = phi_940_;
    workgroupBarrier();
    if (_e44 == 0u) {
        let _e666 = atomicLoad((&shared_[0u]));
        let _e667 = atomicAdd((&list.member[3u]), _e666);
        atomicStore((&shared_[1u]), _e667);
    }
    workgroupBarrier();
    if _e654 {
        if false {
            phi_957_ = (_e656 | 2147483648u);
        } else {
            phi_957_ = _e656;
        }
        let _e671 = phi_957_;
        let _e673 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e673) + _e662)]), _e671);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
