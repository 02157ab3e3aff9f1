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
    var phi_147_: lt_mask_LightPlace;
    var phi_148_: bool;
    var phi_149_: lt_mask_LightPlace;
    var phi_150_: bool;
    var phi_155_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_147_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_148_ = false;
        } else {
            phi_147_ = lt_mask_LightPlace();
            phi_148_ = true;
        }
        let _e59 = phi_147_;
        let _e61 = phi_148_;
        phi_149_ = _e59;
        phi_150_ = _e61;
    } else {
        phi_149_ = lt_mask_LightPlace();
        phi_150_ = true;
    }
    let _e63 = phi_149_;
    let _e65 = phi_150_;
    if _e65 {
        phi_155_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_155_ = _e63;
    }
    let _e70 = phi_155_;
    return lt_mask_LightPlace(_e70.word, _e70.shift);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_175_: bool;
    var phi_179_: f32;

    let _e47 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_175_ = true;
    } else {
        let _e51 = (84f < _e47);
        if _e51 {
        }
        phi_175_ = _e51;
    }
    let _e53 = phi_175_;
    if _e53 {
        phi_179_ = 84f;
    } else {
        phi_179_ = _e47;
    }
    let _e55 = phi_179_;
    return _e55;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_817_: f32;
    var phi_818_: f32;
    var phi_819_: f32;
    var phi_834_: f32;
    var phi_839_: f32;
    var phi_861_: f32;
    var phi_866_: f32;
    var phi_867_: bool;
    var phi_868_: f32;
    var phi_869_: bool;
    var phi_873_: f32;
    var phi_911_: f32;
    var phi_927_: f32;
    var phi_928_: f32;
    var phi_929_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_819_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_818_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_817_ = 1f;
            } else {
                phi_817_ = param_7;
            }
            let _e55 = phi_817_;
            phi_818_ = _e55;
        }
        let _e57 = phi_818_;
        phi_819_ = _e57;
    }
    let _e59 = phi_819_;
    let _e61 = _lt_math_esm_Esm_clamped_exponent(param_5);
    let _e63 = (_e61 * (1f - _e59));
    if ((bitcast<u32>(_e63) & 2147483647u) > 2139095040u) {
        phi_911_ = _e63;
    } else {
        if (_e63 < -87f) {
            phi_834_ = -87f;
        } else {
            phi_834_ = _e63;
        }
        let _e69 = phi_834_;
        if (_e69 > 88f) {
            phi_839_ = 88f;
        } else {
            phi_839_ = _e69;
        }
        let _e72 = phi_839_;
        let _e74 = ((_e72 * 1.442695f) + 0.5f);
        if (_e74 > -8388608f) {
            let _e86 = f32(select(0i, select(select(i32(_e74), i32(-2147483648), (_e74 < bitcast<f32>(3472883712u))), 2147483647i, (_e74 > bitcast<f32>(1325400063u))), (_e74 == _e74)));
            if (_e86 > _e74) {
                phi_861_ = 1f;
            } else {
                phi_861_ = 0f;
            }
            let _e89 = phi_861_;
            if (_e74 < 8388608f) {
                phi_866_ = (_e86 - _e89);
                phi_867_ = false;
            } else {
                phi_866_ = f32();
                phi_867_ = true;
            }
            let _e92 = phi_866_;
            let _e94 = phi_867_;
            phi_868_ = _e92;
            phi_869_ = _e94;
        } else {
            phi_868_ = f32();
            phi_869_ = true;
        }
        let _e96 = phi_868_;
        let _e98 = phi_869_;
        if _e98 {
            phi_873_ = _e74;
        } else {
            phi_873_ = _e96;
        }
        let _e100 = phi_873_;
        let _e104 = ((_e72 - (_e100 * 0.69314575f)) - (_e100 * 0.0000014286068f));
        phi_911_ = ((((((((((((((((1f / 5040f) * _e104) + (1f / 720f)) * _e104) + (1f / 120f)) * _e104) + (1f / 24f)) * _e104) + (1f / 6f)) * _e104) + 0.5f) * _e104) + 1f) * _e104) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e100), i32(-2147483648), (_e100 < bitcast<f32>(3472883712u))), 2147483647i, (_e100 > bitcast<f32>(1325400063u))), (_e100 == _e100)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e140 = phi_911_;
    let _e141 = (param_6.x * _e140);
    if ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u) {
        phi_929_ = _e141;
    } else {
        if (_e141 < 0f) {
            phi_928_ = 0f;
        } else {
            if (_e141 > 1f) {
                phi_927_ = 1f;
            } else {
                phi_927_ = _e141;
            }
            let _e148 = phi_927_;
            phi_928_ = _e148;
        }
        let _e150 = phi_928_;
        phi_929_ = _e150;
    }
    let _e152 = phi_929_;
    return _e152;
}

fn function_() {
    var local: f32;
    var phi_235_: bool;
    var phi_236_: bool;
    var phi_237_: bool;
    var phi_238_: bool;
    var phi_242_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_324_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_325_: bool;
    var phi_326_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_327_: bool;
    var phi_334_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_338_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_412_: bool;
    var phi_421_: bool;
    var phi_430_: bool;
    var phi_431_: bool;
    var phi_432_: bool;
    var phi_433_: bool;
    var phi_434_: bool;
    var phi_435_: bool;
    var phi_436_: bool;
    var phi_440_: bool;
    var phi_530_: f32;
    var phi_533_: f32;
    var phi_562_: f32;
    var phi_567_: f32;
    var phi_568_: bool;
    var phi_569_: f32;
    var phi_570_: bool;
    var phi_574_: f32;
    var phi_594_: f32;
    var phi_599_: f32;
    var phi_600_: bool;
    var phi_601_: f32;
    var phi_602_: bool;
    var phi_606_: f32;
    var phi_654_: i32;
    var phi_659_: i32;
    var phi_664_: i32;
    var phi_669_: i32;
    var phi_678_: i32;
    var phi_683_: i32;
    var phi_688_: i32;
    var phi_693_: i32;
    var phi_782_: evaluate_Verdict;
    var phi_783_: evaluate_Verdict;
    var phi_784_: bool;
    var phi_785_: evaluate_Verdict;
    var phi_786_: evaluate_Verdict;
    var phi_787_: bool;
    var phi_791_: evaluate_Verdict;

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
                phi_235_ = (_e87 == _e89);
                phi_236_ = false;
            } else {
                phi_235_ = bool();
                phi_236_ = true;
            }
            let _e92 = phi_235_;
            let _e94 = phi_236_;
            phi_237_ = _e92;
            phi_238_ = _e94;
        } else {
            phi_237_ = bool();
            phi_238_ = true;
        }
        let _e96 = phi_237_;
        let _e98 = phi_238_;
        if _e98 {
            phi_242_ = false;
        } else {
            phi_242_ = _e96;
        }
        let _e100 = phi_242_;
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
                    phi_313_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_312_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_312_ = false;
                    }
                    let _e161 = phi_312_;
                    phi_313_ = _e161;
                }
                let _e163 = phi_313_;
                if _e163 {
                    let _e165 = samples.member[(0u + _e63.shift)].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_324_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_325_ = false;
                } else {
                    phi_324_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_325_ = true;
                }
                let _e184 = phi_324_;
                let _e186 = phi_325_;
                phi_326_ = _e184;
                phi_327_ = _e186;
            } else {
                phi_326_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_327_ = true;
            }
            let _e188 = phi_326_;
            let _e190 = phi_327_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_334_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_334_ = _e188;
            }
            let _e207 = phi_334_;
            phi_338_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_338_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_338_;
        if _e224.unnamed_1 {
            phi_785_ = evaluate_Verdict(_e224.unnamed.visibility, _e224.unnamed.is_doubted);
            phi_786_ = evaluate_Verdict();
            phi_787_ = true;
        } else {
            let _e232 = samples.member[(0u + _e63.shift)].position;
            let _e250 = ((((_e73.projection.row_w.x * _e232.x) + (_e73.projection.row_w.y * _e232.y)) + (_e73.projection.row_w.z * _e232.z)) + (_e73.projection.row_w.w * 1f));
            let _e264 = (((((_e73.projection.row_x.x * _e232.x) + (_e73.projection.row_x.y * _e232.y)) + (_e73.projection.row_x.z * _e232.z)) + (_e73.projection.row_x.w * 1f)) / _e250);
            let _e278 = (((((_e73.projection.row_y.x * _e232.x) + (_e73.projection.row_y.y * _e232.y)) + (_e73.projection.row_y.z * _e232.z)) + (_e73.projection.row_y.w * 1f)) / _e250);
            let _e291 = ((((_e73.projection.row_z.x * _e232.x) + (_e73.projection.row_z.y * _e232.y)) + (_e73.projection.row_z.z * _e232.z)) + (_e73.projection.row_z.w * 1f));
            if (_e250 > 0f) {
                if (_e264 >= 0f) {
                    phi_412_ = (_e264 <= 1f);
                } else {
                    phi_412_ = false;
                }
                let _e296 = phi_412_;
                if _e296 {
                    if (_e278 >= 0f) {
                        phi_421_ = (_e278 <= 1f);
                    } else {
                        phi_421_ = false;
                    }
                    let _e300 = phi_421_;
                    if _e300 {
                        if (_e291 >= 0f) {
                            phi_430_ = (_e291 <= 1f);
                        } else {
                            phi_430_ = false;
                        }
                        let _e304 = phi_430_;
                        phi_431_ = _e304;
                        phi_432_ = false;
                    } else {
                        phi_431_ = bool();
                        phi_432_ = true;
                    }
                    let _e306 = phi_431_;
                    let _e308 = phi_432_;
                    phi_433_ = _e306;
                    phi_434_ = _e308;
                } else {
                    phi_433_ = bool();
                    phi_434_ = true;
                }
                let _e310 = phi_433_;
                let _e312 = phi_434_;
                phi_435_ = _e310;
                phi_436_ = _e312;
            } else {
                phi_435_ = bool();
                phi_436_ = true;
            }
            let _e314 = phi_435_;
            let _e316 = phi_436_;
            if _e316 {
                phi_440_ = false;
            } else {
                phi_440_ = _e314;
            }
            let _e318 = phi_440_;
            if _e318 {
                if (0f > 0f) {
                    let _e321 = samples.member[(0u + _e63.shift)].normal;
                    let _e323 = p.member.map_size;
                    let _e393 = ((abs(((((_e69.row_x.x * _e321.x) + (_e69.row_x.y * _e321.y)) + (_e69.row_x.z * _e321.z)) / (((_e69.row_x.x * _e69.row_x.x) + (_e69.row_x.y * _e69.row_x.y)) + (_e69.row_x.z * _e69.row_x.z)))) + abs(((((_e69.row_y.x * _e321.x) + (_e69.row_y.y * _e321.y)) + (_e69.row_y.z * _e321.z)) / (((_e69.row_y.x * _e69.row_y.x) + (_e69.row_y.y * _e69.row_y.y)) + (_e69.row_y.z * _e69.row_y.z))))) / (abs(((((_e69.row_z.x * _e321.x) + (_e69.row_z.y * _e321.y)) + (_e69.row_z.z * _e321.z)) / (((_e69.row_z.x * _e69.row_z.x) + (_e69.row_z.y * _e69.row_z.y)) + (_e69.row_z.z * _e69.row_z.z)))) * f32(_e323)));
                    if (_e393 < 0.002f) {
                        phi_530_ = _e393;
                    } else {
                        phi_530_ = 0.002f;
                    }
                    let _e396 = phi_530_;
                    phi_533_ = (_e291 - (0f * _e396));
                } else {
                    phi_533_ = _e291;
                }
                let _e400 = phi_533_;
                let _e402 = p.member.map_size;
                let _e403 = f32(_e402);
                let _e406 = ((_e264 * _e403) - 0.5f);
                let _e407 = ((_e278 * _e403) - 0.5f);
                if (_e406 > -8388608f) {
                    let _e419 = f32(select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406)));
                    if (_e419 > _e406) {
                        phi_562_ = 1f;
                    } else {
                        phi_562_ = 0f;
                    }
                    let _e422 = phi_562_;
                    if (_e406 < 8388608f) {
                        phi_567_ = (_e419 - _e422);
                        phi_568_ = false;
                    } else {
                        phi_567_ = f32();
                        phi_568_ = true;
                    }
                    let _e425 = phi_567_;
                    let _e427 = phi_568_;
                    phi_569_ = _e425;
                    phi_570_ = _e427;
                } else {
                    phi_569_ = f32();
                    phi_570_ = true;
                }
                let _e429 = phi_569_;
                let _e431 = phi_570_;
                if _e431 {
                    phi_574_ = _e406;
                } else {
                    phi_574_ = _e429;
                }
                let _e433 = phi_574_;
                if (_e407 > -8388608f) {
                    let _e445 = f32(select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)));
                    if (_e445 > _e407) {
                        phi_594_ = 1f;
                    } else {
                        phi_594_ = 0f;
                    }
                    let _e448 = phi_594_;
                    if (_e407 < 8388608f) {
                        phi_599_ = (_e445 - _e448);
                        phi_600_ = false;
                    } else {
                        phi_599_ = f32();
                        phi_600_ = true;
                    }
                    let _e451 = phi_599_;
                    let _e453 = phi_600_;
                    phi_601_ = _e451;
                    phi_602_ = _e453;
                } else {
                    phi_601_ = f32();
                    phi_602_ = true;
                }
                let _e455 = phi_601_;
                let _e457 = phi_602_;
                if _e457 {
                    phi_606_ = _e407;
                } else {
                    phi_606_ = _e455;
                }
                let _e459 = phi_606_;
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
                    phi_654_ = _e470;
                } else {
                    phi_654_ = 0i;
                }
                let _e499 = phi_654_;
                if (_e479 > 0i) {
                    phi_659_ = _e479;
                } else {
                    phi_659_ = 0i;
                }
                let _e502 = phi_659_;
                if (_e499 < _e496) {
                    phi_664_ = _e499;
                } else {
                    phi_664_ = _e496;
                }
                let _e505 = phi_664_;
                if (_e502 < _e496) {
                    phi_669_ = _e502;
                } else {
                    phi_669_ = _e496;
                }
                let _e508 = phi_669_;
                let _e509 = bitcast<u32>(_e505);
                let _e511 = (_e470 + 1i);
                let _e512 = (_e479 + 1i);
                if (_e511 > 0i) {
                    phi_678_ = _e511;
                } else {
                    phi_678_ = 0i;
                }
                let _e515 = phi_678_;
                if (_e512 > 0i) {
                    phi_683_ = _e512;
                } else {
                    phi_683_ = 0i;
                }
                let _e518 = phi_683_;
                if (_e515 < _e496) {
                    phi_688_ = _e515;
                } else {
                    phi_688_ = _e496;
                }
                let _e521 = phi_688_;
                if (_e518 < _e496) {
                    phi_693_ = _e518;
                } else {
                    phi_693_ = _e496;
                }
                let _e524 = phi_693_;
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
                phi_782_ = evaluate_Verdict(_e598, false);
                phi_783_ = evaluate_Verdict();
                phi_784_ = false;
            } else {
                phi_782_ = evaluate_Verdict();
                phi_783_ = evaluate_Verdict(1f, false);
                phi_784_ = true;
            }
            let _e602 = phi_782_;
            let _e604 = phi_783_;
            let _e606 = phi_784_;
            phi_785_ = _e604;
            phi_786_ = _e602;
            phi_787_ = _e606;
        }
        let _e608 = phi_785_;
        let _e610 = phi_786_;
        let _e612 = phi_787_;
        if _e612 {
            phi_791_ = _e608;
        } else {
            phi_791_ = _e610;
        }
        let _e614 = phi_791_;
        if (_e63.shift < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.shift)] = _e614.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
