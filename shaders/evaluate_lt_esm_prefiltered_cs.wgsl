struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
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
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_148_: lt_mask_LightPlace;
    var phi_149_: bool;
    var phi_150_: lt_mask_LightPlace;
    var phi_151_: bool;
    var phi_156_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_148_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_149_ = false;
        } else {
            phi_148_ = lt_mask_LightPlace();
            phi_149_ = true;
        }
        let _e59 = phi_148_;
        let _e61 = phi_149_;
        phi_150_ = _e59;
        phi_151_ = _e61;
    } else {
        phi_150_ = lt_mask_LightPlace();
        phi_151_ = true;
    }
    let _e63 = phi_150_;
    let _e65 = phi_151_;
    if _e65 {
        phi_156_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_156_ = _e63;
    }
    let _e70 = phi_156_;
    return lt_mask_LightPlace(_e70.word, _e70.shift);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_176_: bool;
    var phi_180_: f32;

    let _e47 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_176_ = true;
    } else {
        let _e51 = (84f < _e47);
        if _e51 {
        }
        phi_176_ = _e51;
    }
    let _e53 = phi_176_;
    if _e53 {
        phi_180_ = 84f;
    } else {
        phi_180_ = _e47;
    }
    let _e55 = phi_180_;
    return _e55;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_199_: f32;
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_216_: f32;
    var phi_221_: f32;
    var phi_243_: f32;
    var phi_248_: f32;
    var phi_249_: bool;
    var phi_250_: f32;
    var phi_251_: bool;
    var phi_255_: f32;
    var phi_293_: f32;
    var phi_309_: f32;
    var phi_310_: f32;
    var phi_311_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_201_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_200_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_199_ = 1f;
            } else {
                phi_199_ = param_7;
            }
            let _e55 = phi_199_;
            phi_200_ = _e55;
        }
        let _e57 = phi_200_;
        phi_201_ = _e57;
    }
    let _e59 = phi_201_;
    let _e61 = _lt_math_esm_Esm_clamped_exponent(param_5);
    let _e63 = (_e61 * (1f - _e59));
    if ((bitcast<u32>(_e63) & 2147483647u) > 2139095040u) {
        phi_293_ = _e63;
    } else {
        if (_e63 < -87f) {
            phi_216_ = -87f;
        } else {
            phi_216_ = _e63;
        }
        let _e69 = phi_216_;
        if (_e69 > 88f) {
            phi_221_ = 88f;
        } else {
            phi_221_ = _e69;
        }
        let _e72 = phi_221_;
        let _e74 = ((_e72 * 1.442695f) + 0.5f);
        if (_e74 > -8388608f) {
            let _e86 = f32(select(0i, select(select(i32(_e74), i32(-2147483648), (_e74 < bitcast<f32>(3472883712u))), 2147483647i, (_e74 > bitcast<f32>(1325400063u))), (_e74 == _e74)));
            if (_e86 > _e74) {
                phi_243_ = 1f;
            } else {
                phi_243_ = 0f;
            }
            let _e89 = phi_243_;
            if (_e74 < 8388608f) {
                phi_248_ = (_e86 - _e89);
                phi_249_ = false;
            } else {
                phi_248_ = f32();
                phi_249_ = true;
            }
            let _e92 = phi_248_;
            let _e94 = phi_249_;
            phi_250_ = _e92;
            phi_251_ = _e94;
        } else {
            phi_250_ = f32();
            phi_251_ = true;
        }
        let _e96 = phi_250_;
        let _e98 = phi_251_;
        if _e98 {
            phi_255_ = _e74;
        } else {
            phi_255_ = _e96;
        }
        let _e100 = phi_255_;
        let _e104 = ((_e72 - (_e100 * 0.69314575f)) - (_e100 * 0.0000014286068f));
        phi_293_ = ((((((((((((((((1f / 5040f) * _e104) + (1f / 720f)) * _e104) + (1f / 120f)) * _e104) + (1f / 24f)) * _e104) + (1f / 6f)) * _e104) + 0.5f) * _e104) + 1f) * _e104) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e100), i32(-2147483648), (_e100 < bitcast<f32>(3472883712u))), 2147483647i, (_e100 > bitcast<f32>(1325400063u))), (_e100 == _e100)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e140 = phi_293_;
    let _e141 = (param_6.x * _e140);
    if ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u) {
        phi_311_ = _e141;
    } else {
        if (_e141 < 0f) {
            phi_310_ = 0f;
        } else {
            if (_e141 > 1f) {
                phi_309_ = 1f;
            } else {
                phi_309_ = _e141;
            }
            let _e148 = phi_309_;
            phi_310_ = _e148;
        }
        let _e150 = phi_310_;
        phi_311_ = _e150;
    }
    let _e152 = phi_311_;
    return _e152;
}

fn function_() {
    var local: f32;
    var phi_367_: bool;
    var phi_368_: bool;
    var phi_369_: bool;
    var phi_370_: bool;
    var phi_374_: bool;
    var phi_444_: bool;
    var phi_445_: bool;
    var phi_456_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_457_: bool;
    var phi_458_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_459_: bool;
    var phi_466_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_470_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_544_: bool;
    var phi_553_: bool;
    var phi_562_: bool;
    var phi_563_: bool;
    var phi_564_: bool;
    var phi_565_: bool;
    var phi_566_: bool;
    var phi_567_: bool;
    var phi_568_: bool;
    var phi_572_: bool;
    var phi_662_: f32;
    var phi_665_: f32;
    var phi_694_: f32;
    var phi_699_: f32;
    var phi_700_: bool;
    var phi_701_: f32;
    var phi_702_: bool;
    var phi_706_: f32;
    var phi_726_: f32;
    var phi_731_: f32;
    var phi_732_: bool;
    var phi_733_: f32;
    var phi_734_: bool;
    var phi_738_: f32;
    var phi_786_: i32;
    var phi_791_: i32;
    var phi_796_: i32;
    var phi_801_: i32;
    var phi_810_: i32;
    var phi_815_: i32;
    var phi_820_: i32;
    var phi_825_: i32;
    var phi_920_: bool;
    var phi_928_: bool;
    var phi_940_: bool;
    var phi_941_: bool;
    var phi_945_: f32;
    var phi_951_: f32;
    var phi_953_: evaluate_Verdict;
    var phi_958_: evaluate_Verdict;
    var phi_959_: evaluate_Verdict;

    let _e47 = id_1;
    let _e54 = arrayLength((&map.member));
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e47, _e60, _e62);
    if (bitcast<i32>(_e63.word) != 0i) {
        let _e69 = p.member.projection;
        if (_e63.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e73 = lt_math_OneLevel(_e69);
        let _e77 = samples.member[(0u + _e63.shift)].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[(0u + _e63.shift)].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[(0u + _e63.shift)].normal[2u];
                let _e89 = global[2u];
                phi_367_ = (_e87 == _e89);
                phi_368_ = false;
            } else {
                phi_367_ = bool();
                phi_368_ = true;
            }
            let _e92 = phi_367_;
            let _e94 = phi_368_;
            phi_369_ = _e92;
            phi_370_ = _e94;
        } else {
            phi_369_ = bool();
            phi_370_ = true;
        }
        let _e96 = phi_369_;
        let _e98 = phi_370_;
        if _e98 {
            phi_374_ = false;
        } else {
            phi_374_ = _e96;
        }
        let _e100 = phi_374_;
        if !(_e100) {
            let _e103 = samples.member[(0u + _e63.shift)].position;
            let _e105 = p.member.light.place;
            let _e111 = p.member.light.place[3u];
            let _e118 = (_e105.x - (_e103.x * _e111));
            let _e119 = (_e105.y - (_e103.y * _e111));
            let _e120 = (_e105.z - (_e103.z * _e111));
            let _e122 = samples.member[(0u + _e63.shift)].normal;
            if ((((_e122.x * _e118) + (_e122.y * _e119)) + (_e122.z * _e120)) > 0f) {
                let _e136 = (((_e118 * _e118) + (_e119 * _e119)) + (_e120 * _e120));
                let _e138 = p.member.light.axis;
                let _e150 = p.member.light.place[3u];
                if (_e150 == 0f) {
                    phi_445_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_444_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_444_ = false;
                    }
                    let _e161 = phi_444_;
                    phi_445_ = _e161;
                }
                let _e163 = phi_445_;
                if _e163 {
                    let _e165 = samples.member[(0u + _e63.shift)].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_456_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_457_ = false;
                } else {
                    phi_456_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_457_ = true;
                }
                let _e184 = phi_456_;
                let _e186 = phi_457_;
                phi_458_ = _e184;
                phi_459_ = _e186;
            } else {
                phi_458_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_459_ = true;
            }
            let _e188 = phi_458_;
            let _e190 = phi_459_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_466_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_466_ = _e188;
            }
            let _e207 = phi_466_;
            phi_470_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_470_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_470_;
        if _e224.unnamed_1 {
            phi_959_ = evaluate_Verdict(_e224.unnamed.visibility, _e224.unnamed.is_doubted);
        } else {
            let _e232 = samples.member[(0u + _e63.shift)].position;
            let _e250 = ((((_e73.projection.row_w.x * _e232.x) + (_e73.projection.row_w.y * _e232.y)) + (_e73.projection.row_w.z * _e232.z)) + (_e73.projection.row_w.w * 1f));
            let _e264 = (((((_e73.projection.row_x.x * _e232.x) + (_e73.projection.row_x.y * _e232.y)) + (_e73.projection.row_x.z * _e232.z)) + (_e73.projection.row_x.w * 1f)) / _e250);
            let _e278 = (((((_e73.projection.row_y.x * _e232.x) + (_e73.projection.row_y.y * _e232.y)) + (_e73.projection.row_y.z * _e232.z)) + (_e73.projection.row_y.w * 1f)) / _e250);
            let _e291 = ((((_e73.projection.row_z.x * _e232.x) + (_e73.projection.row_z.y * _e232.y)) + (_e73.projection.row_z.z * _e232.z)) + (_e73.projection.row_z.w * 1f));
            if (_e250 > 0f) {
                if (_e264 >= 0f) {
                    phi_544_ = (_e264 <= 1f);
                } else {
                    phi_544_ = false;
                }
                let _e296 = phi_544_;
                if _e296 {
                    if (_e278 >= 0f) {
                        phi_553_ = (_e278 <= 1f);
                    } else {
                        phi_553_ = false;
                    }
                    let _e300 = phi_553_;
                    if _e300 {
                        if (_e291 >= 0f) {
                            phi_562_ = (_e291 <= 1f);
                        } else {
                            phi_562_ = false;
                        }
                        let _e304 = phi_562_;
                        phi_563_ = _e304;
                        phi_564_ = false;
                    } else {
                        phi_563_ = bool();
                        phi_564_ = true;
                    }
                    let _e306 = phi_563_;
                    let _e308 = phi_564_;
                    phi_565_ = _e306;
                    phi_566_ = _e308;
                } else {
                    phi_565_ = bool();
                    phi_566_ = true;
                }
                let _e310 = phi_565_;
                let _e312 = phi_566_;
                phi_567_ = _e310;
                phi_568_ = _e312;
            } else {
                phi_567_ = bool();
                phi_568_ = true;
            }
            let _e314 = phi_567_;
            let _e316 = phi_568_;
            if _e316 {
                phi_572_ = false;
            } else {
                phi_572_ = _e314;
            }
            let _e318 = phi_572_;
            if _e318 {
                if (0f > 0f) {
                    let _e321 = samples.member[(0u + _e63.shift)].normal;
                    let _e323 = p.member.map_size;
                    let _e393 = ((abs(((((_e69.row_x.x * _e321.x) + (_e69.row_x.y * _e321.y)) + (_e69.row_x.z * _e321.z)) / (((_e69.row_x.x * _e69.row_x.x) + (_e69.row_x.y * _e69.row_x.y)) + (_e69.row_x.z * _e69.row_x.z)))) + abs(((((_e69.row_y.x * _e321.x) + (_e69.row_y.y * _e321.y)) + (_e69.row_y.z * _e321.z)) / (((_e69.row_y.x * _e69.row_y.x) + (_e69.row_y.y * _e69.row_y.y)) + (_e69.row_y.z * _e69.row_y.z))))) / (abs(((((_e69.row_z.x * _e321.x) + (_e69.row_z.y * _e321.y)) + (_e69.row_z.z * _e321.z)) / (((_e69.row_z.x * _e69.row_z.x) + (_e69.row_z.y * _e69.row_z.y)) + (_e69.row_z.z * _e69.row_z.z)))) * f32(_e323)));
                    if (_e393 < 0.002f) {
                        phi_662_ = _e393;
                    } else {
                        phi_662_ = 0.002f;
                    }
                    let _e396 = phi_662_;
                    phi_665_ = (_e291 - (0f * _e396));
                } else {
                    phi_665_ = _e291;
                }
                let _e400 = phi_665_;
                let _e402 = p.member.map_size;
                let _e403 = f32(_e402);
                let _e406 = ((_e264 * _e403) - 0.5f);
                let _e407 = ((_e278 * _e403) - 0.5f);
                if (_e406 > -8388608f) {
                    let _e419 = f32(select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406)));
                    if (_e419 > _e406) {
                        phi_694_ = 1f;
                    } else {
                        phi_694_ = 0f;
                    }
                    let _e422 = phi_694_;
                    if (_e406 < 8388608f) {
                        phi_699_ = (_e419 - _e422);
                        phi_700_ = false;
                    } else {
                        phi_699_ = f32();
                        phi_700_ = true;
                    }
                    let _e425 = phi_699_;
                    let _e427 = phi_700_;
                    phi_701_ = _e425;
                    phi_702_ = _e427;
                } else {
                    phi_701_ = f32();
                    phi_702_ = true;
                }
                let _e429 = phi_701_;
                let _e431 = phi_702_;
                if _e431 {
                    phi_706_ = _e406;
                } else {
                    phi_706_ = _e429;
                }
                let _e433 = phi_706_;
                if (_e407 > -8388608f) {
                    let _e445 = f32(select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)));
                    if (_e445 > _e407) {
                        phi_726_ = 1f;
                    } else {
                        phi_726_ = 0f;
                    }
                    let _e448 = phi_726_;
                    if (_e407 < 8388608f) {
                        phi_731_ = (_e445 - _e448);
                        phi_732_ = false;
                    } else {
                        phi_731_ = f32();
                        phi_732_ = true;
                    }
                    let _e451 = phi_731_;
                    let _e453 = phi_732_;
                    phi_733_ = _e451;
                    phi_734_ = _e453;
                } else {
                    phi_733_ = f32();
                    phi_734_ = true;
                }
                let _e455 = phi_733_;
                let _e457 = phi_734_;
                if _e457 {
                    phi_738_ = _e407;
                } else {
                    phi_738_ = _e455;
                }
                let _e459 = phi_738_;
                let _e460 = (_e406 - _e433);
                let _e461 = (_e407 - _e459);
                let _e470 = select(0i, select(select(i32(_e433), i32(-2147483648), (_e433 < bitcast<f32>(3472883712u))), 2147483647i, (_e433 > bitcast<f32>(1325400063u))), (_e433 == _e433));
                let _e479 = select(0i, select(select(i32(_e459), i32(-2147483648), (_e459 < bitcast<f32>(3472883712u))), 2147483647i, (_e459 > bitcast<f32>(1325400063u))), (_e459 == _e459));
                let _e482 = ((1f - _e460) * (1f - _e461));
                let _e484 = (_e460 * (1f - _e461));
                let _e486 = ((1f - _e460) * _e461);
                let _e487 = (_e460 * _e461);
                let _e489 = p.member.test;
                let _e490 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e489);
                let _e492 = p.member.map_size;
                local = _e490;
                let _e494 = ((0u * _e492) * _e492);
                let _e496 = (bitcast<i32>(_e492) - 1i);
                if (_e470 > 0i) {
                    phi_786_ = _e470;
                } else {
                    phi_786_ = 0i;
                }
                let _e499 = phi_786_;
                if (_e479 > 0i) {
                    phi_791_ = _e479;
                } else {
                    phi_791_ = 0i;
                }
                let _e502 = phi_791_;
                if (_e499 < _e496) {
                    phi_796_ = _e499;
                } else {
                    phi_796_ = _e496;
                }
                let _e505 = phi_796_;
                if (_e502 < _e496) {
                    phi_801_ = _e502;
                } else {
                    phi_801_ = _e496;
                }
                let _e508 = phi_801_;
                let _e509 = bitcast<u32>(_e505);
                let _e511 = (_e470 + 1i);
                let _e512 = (_e479 + 1i);
                if (_e511 > 0i) {
                    phi_810_ = _e511;
                } else {
                    phi_810_ = 0i;
                }
                let _e515 = phi_810_;
                if (_e512 > 0i) {
                    phi_815_ = _e512;
                } else {
                    phi_815_ = 0i;
                }
                let _e518 = phi_815_;
                if (_e515 < _e496) {
                    phi_820_ = _e515;
                } else {
                    phi_820_ = _e496;
                }
                let _e521 = phi_820_;
                if (_e518 < _e496) {
                    phi_825_ = _e518;
                } else {
                    phi_825_ = _e496;
                }
                let _e524 = phi_825_;
                let _e525 = bitcast<u32>(_e521);
                let _e527 = (bitcast<u32>(_e508) * _e492);
                let _e528 = (bitcast<u32>(_e524) * _e492);
                let _e533 = ((_e527 + _e509) + _e494);
                let _e534 = ((_e527 + _e525) + _e494);
                let _e535 = ((_e528 + _e509) + _e494);
                let _e536 = ((_e528 + _e525) + _e494);
                if (_e533 < _e54) {
                } else {
                    return;
                }
                let _e540 = map.member[(0u + _e533)];
                if (_e534 < _e54) {
                } else {
                    return;
                }
                let _e552 = map.member[(0u + _e534)];
                if (_e535 < _e54) {
                } else {
                    return;
                }
                let _e568 = map.member[(0u + _e535)];
                if (_e536 < _e54) {
                } else {
                    return;
                }
                let _e584 = map.member[(0u + _e536)];
                let _e598 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e540.x * _e482) + (_e552.x * _e484)) + (_e568.x * _e486)) + (_e584.x * _e487)), ((((_e540.y * _e482) + (_e552.y * _e484)) + (_e568.y * _e486)) + (_e584.y * _e487)), ((((_e540.z * _e482) + (_e552.z * _e484)) + (_e568.z * _e486)) + (_e584.z * _e487)), ((((_e540.w * _e482) + (_e552.w * _e484)) + (_e568.w * _e486)) + (_e584.w * _e487))), _e400);
                let _e600 = p.member.epsilon;
                if (_e598 <= _e600) {
                    phi_920_ = true;
                } else {
                    phi_920_ = (_e598 >= (1f - _e600));
                }
                let _e605 = phi_920_;
                if ((bitcast<u32>(_e598) & 2147483647u) > 2139095040u) {
                    phi_928_ = true;
                } else {
                    phi_928_ = !(_e605);
                }
                let _e611 = phi_928_;
                if _e611 {
                    if (_e598 > 0f) {
                        if (_e598 < 1f) {
                            phi_940_ = false;
                        } else {
                            phi_940_ = true;
                        }
                        let _e615 = phi_940_;
                        phi_941_ = _e615;
                    } else {
                        phi_941_ = true;
                    }
                    let _e617 = phi_941_;
                    if _e617 {
                        phi_945_ = 0.5f;
                    } else {
                        phi_945_ = _e598;
                    }
                    let _e619 = phi_945_;
                    phi_953_ = evaluate_Verdict(_e619, true);
                } else {
                    if (_e598 > 0.5f) {
                        phi_951_ = 1f;
                    } else {
                        phi_951_ = 0f;
                    }
                    let _e623 = phi_951_;
                    phi_953_ = evaluate_Verdict(_e623, false);
                }
                let _e626 = phi_953_;
                phi_958_ = evaluate_Verdict(_e626.visibility, _e626.is_doubted);
            } else {
                phi_958_ = evaluate_Verdict(0.5f, true);
            }
            let _e632 = phi_958_;
            phi_959_ = _e632;
        }
        let _e634 = phi_959_;
        if (_e63.shift < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.shift)] = _e634.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
