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
    var phi_146_: lt_bvh_traverse_Tree;
    var phi_147_: bool;
    var phi_148_: lt_bvh_traverse_Tree;
    var phi_149_: bool;
    var phi_154_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_146_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_147_ = false;
        } else {
            phi_146_ = lt_bvh_traverse_Tree();
            phi_147_ = true;
        }
        let _e59 = phi_146_;
        let _e61 = phi_147_;
        phi_148_ = _e59;
        phi_149_ = _e61;
    } else {
        phi_148_ = lt_bvh_traverse_Tree();
        phi_149_ = true;
    }
    let _e63 = phi_148_;
    let _e65 = phi_149_;
    if _e65 {
        phi_154_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_154_ = _e63;
    }
    let _e70 = phi_154_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_179_: f32;
    var phi_180_: f32;
    var phi_181_: f32;
    var phi_194_: bool;
    var phi_198_: f32;
    var phi_211_: f32;
    var phi_216_: f32;
    var phi_238_: f32;
    var phi_243_: f32;
    var phi_244_: bool;
    var phi_245_: f32;
    var phi_246_: bool;
    var phi_250_: f32;
    var phi_288_: f32;
    var phi_304_: f32;
    var phi_305_: f32;
    var phi_306_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_181_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_180_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_179_ = 1f;
            } else {
                phi_179_ = param_6;
            }
            let _e55 = phi_179_;
            phi_180_ = _e55;
        }
        let _e57 = phi_180_;
        phi_181_ = _e57;
    }
    let _e59 = phi_181_;
    let _e61 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_194_ = true;
    } else {
        let _e65 = (84f < _e61);
        if _e65 {
        }
        phi_194_ = _e65;
    }
    let _e67 = phi_194_;
    if _e67 {
        phi_198_ = 84f;
    } else {
        phi_198_ = _e61;
    }
    let _e69 = phi_198_;
    let _e71 = (_e69 * (1f - _e59));
    if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
        phi_288_ = _e71;
    } else {
        if (_e71 < -87f) {
            phi_211_ = -87f;
        } else {
            phi_211_ = _e71;
        }
        let _e77 = phi_211_;
        if (_e77 > 88f) {
            phi_216_ = 88f;
        } else {
            phi_216_ = _e77;
        }
        let _e80 = phi_216_;
        let _e82 = ((_e80 * 1.442695f) + 0.5f);
        if (_e82 > -8388608f) {
            let _e94 = f32(select(0i, select(select(i32(_e82), i32(-2147483648), (_e82 < bitcast<f32>(3472883712u))), 2147483647i, (_e82 > bitcast<f32>(1325400063u))), (_e82 == _e82)));
            if (_e94 > _e82) {
                phi_238_ = 1f;
            } else {
                phi_238_ = 0f;
            }
            let _e97 = phi_238_;
            if (_e82 < 8388608f) {
                phi_243_ = (_e94 - _e97);
                phi_244_ = false;
            } else {
                phi_243_ = f32();
                phi_244_ = true;
            }
            let _e100 = phi_243_;
            let _e102 = phi_244_;
            phi_245_ = _e100;
            phi_246_ = _e102;
        } else {
            phi_245_ = f32();
            phi_246_ = true;
        }
        let _e104 = phi_245_;
        let _e106 = phi_246_;
        if _e106 {
            phi_250_ = _e82;
        } else {
            phi_250_ = _e104;
        }
        let _e108 = phi_250_;
        let _e112 = ((_e80 - (_e108 * 0.69314575f)) - (_e108 * 0.0000014286068f));
        phi_288_ = ((((((((((((((((1f / 5040f) * _e112) + (1f / 720f)) * _e112) + (1f / 120f)) * _e112) + (1f / 24f)) * _e112) + (1f / 6f)) * _e112) + 0.5f) * _e112) + 1f) * _e112) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e108), i32(-2147483648), (_e108 < bitcast<f32>(3472883712u))), 2147483647i, (_e108 > bitcast<f32>(1325400063u))), (_e108 == _e108)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e148 = phi_288_;
    let _e149 = (param_5.x * _e148);
    if ((bitcast<u32>(_e149) & 2147483647u) > 2139095040u) {
        phi_306_ = _e149;
    } else {
        if (_e149 < 0f) {
            phi_305_ = 0f;
        } else {
            if (_e149 > 1f) {
                phi_304_ = 1f;
            } else {
                phi_304_ = _e149;
            }
            let _e156 = phi_304_;
            phi_305_ = _e156;
        }
        let _e158 = phi_305_;
        phi_306_ = _e158;
    }
    let _e160 = phi_306_;
    return _e160;
}

fn function_() {
    var local: f32;
    var phi_362_: bool;
    var phi_363_: bool;
    var phi_364_: bool;
    var phi_365_: bool;
    var phi_369_: bool;
    var phi_439_: bool;
    var phi_440_: bool;
    var phi_451_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_452_: bool;
    var phi_453_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_454_: bool;
    var phi_461_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_465_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_539_: bool;
    var phi_548_: bool;
    var phi_557_: bool;
    var phi_558_: bool;
    var phi_559_: bool;
    var phi_560_: bool;
    var phi_561_: bool;
    var phi_562_: bool;
    var phi_563_: bool;
    var phi_567_: bool;
    var phi_657_: f32;
    var phi_660_: f32;
    var phi_689_: f32;
    var phi_694_: f32;
    var phi_695_: bool;
    var phi_696_: f32;
    var phi_697_: bool;
    var phi_701_: f32;
    var phi_721_: f32;
    var phi_726_: f32;
    var phi_727_: bool;
    var phi_728_: f32;
    var phi_729_: bool;
    var phi_733_: f32;
    var phi_781_: i32;
    var phi_786_: i32;
    var phi_791_: i32;
    var phi_796_: i32;
    var phi_805_: i32;
    var phi_810_: i32;
    var phi_815_: i32;
    var phi_820_: i32;
    var phi_915_: bool;
    var phi_923_: bool;
    var phi_935_: bool;
    var phi_936_: bool;
    var phi_940_: f32;
    var phi_946_: f32;
    var phi_948_: evaluate_Verdict;
    var phi_953_: evaluate_Verdict;
    var phi_954_: evaluate_Verdict;

    let _e47 = id_1;
    let _e54 = arrayLength((&map.member));
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e47, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        let _e69 = p.member.projection;
        if (_e63.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e73 = lt_math_OneLevel(_e69);
        let _e77 = samples.member[(0u + _e63.first_primitive)].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[(0u + _e63.first_primitive)].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[(0u + _e63.first_primitive)].normal[2u];
                let _e89 = global[2u];
                phi_362_ = (_e87 == _e89);
                phi_363_ = false;
            } else {
                phi_362_ = bool();
                phi_363_ = true;
            }
            let _e92 = phi_362_;
            let _e94 = phi_363_;
            phi_364_ = _e92;
            phi_365_ = _e94;
        } else {
            phi_364_ = bool();
            phi_365_ = true;
        }
        let _e96 = phi_364_;
        let _e98 = phi_365_;
        if _e98 {
            phi_369_ = false;
        } else {
            phi_369_ = _e96;
        }
        let _e100 = phi_369_;
        if !(_e100) {
            let _e103 = samples.member[(0u + _e63.first_primitive)].position;
            let _e105 = p.member.light.place;
            let _e111 = p.member.light.place[3u];
            let _e118 = (_e105.x - (_e103.x * _e111));
            let _e119 = (_e105.y - (_e103.y * _e111));
            let _e120 = (_e105.z - (_e103.z * _e111));
            let _e122 = samples.member[(0u + _e63.first_primitive)].normal;
            if ((((_e122.x * _e118) + (_e122.y * _e119)) + (_e122.z * _e120)) > 0f) {
                let _e136 = (((_e118 * _e118) + (_e119 * _e119)) + (_e120 * _e120));
                let _e138 = p.member.light.axis;
                let _e150 = p.member.light.place[3u];
                if (_e150 == 0f) {
                    phi_440_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_439_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_439_ = false;
                    }
                    let _e161 = phi_439_;
                    phi_440_ = _e161;
                }
                let _e163 = phi_440_;
                if _e163 {
                    let _e165 = samples.member[(0u + _e63.first_primitive)].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_451_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_452_ = false;
                } else {
                    phi_451_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_452_ = true;
                }
                let _e184 = phi_451_;
                let _e186 = phi_452_;
                phi_453_ = _e184;
                phi_454_ = _e186;
            } else {
                phi_453_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_454_ = true;
            }
            let _e188 = phi_453_;
            let _e190 = phi_454_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_461_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_461_ = _e188;
            }
            let _e207 = phi_461_;
            phi_465_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_465_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_465_;
        if _e224.unnamed_1 {
            phi_954_ = evaluate_Verdict(_e224.unnamed.visibility, _e224.unnamed.is_doubted);
        } else {
            let _e232 = samples.member[(0u + _e63.first_primitive)].position;
            let _e250 = ((((_e73.projection.row_w.x * _e232.x) + (_e73.projection.row_w.y * _e232.y)) + (_e73.projection.row_w.z * _e232.z)) + (_e73.projection.row_w.w * 1f));
            let _e264 = (((((_e73.projection.row_x.x * _e232.x) + (_e73.projection.row_x.y * _e232.y)) + (_e73.projection.row_x.z * _e232.z)) + (_e73.projection.row_x.w * 1f)) / _e250);
            let _e278 = (((((_e73.projection.row_y.x * _e232.x) + (_e73.projection.row_y.y * _e232.y)) + (_e73.projection.row_y.z * _e232.z)) + (_e73.projection.row_y.w * 1f)) / _e250);
            let _e291 = ((((_e73.projection.row_z.x * _e232.x) + (_e73.projection.row_z.y * _e232.y)) + (_e73.projection.row_z.z * _e232.z)) + (_e73.projection.row_z.w * 1f));
            if (_e250 > 0f) {
                if (_e264 >= 0f) {
                    phi_539_ = (_e264 <= 1f);
                } else {
                    phi_539_ = false;
                }
                let _e296 = phi_539_;
                if _e296 {
                    if (_e278 >= 0f) {
                        phi_548_ = (_e278 <= 1f);
                    } else {
                        phi_548_ = false;
                    }
                    let _e300 = phi_548_;
                    if _e300 {
                        if (_e291 >= 0f) {
                            phi_557_ = (_e291 <= 1f);
                        } else {
                            phi_557_ = false;
                        }
                        let _e304 = phi_557_;
                        phi_558_ = _e304;
                        phi_559_ = false;
                    } else {
                        phi_558_ = bool();
                        phi_559_ = true;
                    }
                    let _e306 = phi_558_;
                    let _e308 = phi_559_;
                    phi_560_ = _e306;
                    phi_561_ = _e308;
                } else {
                    phi_560_ = bool();
                    phi_561_ = true;
                }
                let _e310 = phi_560_;
                let _e312 = phi_561_;
                phi_562_ = _e310;
                phi_563_ = _e312;
            } else {
                phi_562_ = bool();
                phi_563_ = true;
            }
            let _e314 = phi_562_;
            let _e316 = phi_563_;
            if _e316 {
                phi_567_ = false;
            } else {
                phi_567_ = _e314;
            }
            let _e318 = phi_567_;
            if _e318 {
                if (0f > 0f) {
                    let _e321 = samples.member[(0u + _e63.first_primitive)].normal;
                    let _e323 = p.member.map_size;
                    let _e393 = ((abs(((((_e69.row_x.x * _e321.x) + (_e69.row_x.y * _e321.y)) + (_e69.row_x.z * _e321.z)) / (((_e69.row_x.x * _e69.row_x.x) + (_e69.row_x.y * _e69.row_x.y)) + (_e69.row_x.z * _e69.row_x.z)))) + abs(((((_e69.row_y.x * _e321.x) + (_e69.row_y.y * _e321.y)) + (_e69.row_y.z * _e321.z)) / (((_e69.row_y.x * _e69.row_y.x) + (_e69.row_y.y * _e69.row_y.y)) + (_e69.row_y.z * _e69.row_y.z))))) / (abs(((((_e69.row_z.x * _e321.x) + (_e69.row_z.y * _e321.y)) + (_e69.row_z.z * _e321.z)) / (((_e69.row_z.x * _e69.row_z.x) + (_e69.row_z.y * _e69.row_z.y)) + (_e69.row_z.z * _e69.row_z.z)))) * f32(_e323)));
                    if (_e393 < 0.002f) {
                        phi_657_ = _e393;
                    } else {
                        phi_657_ = 0.002f;
                    }
                    let _e396 = phi_657_;
                    phi_660_ = (_e291 - (0f * _e396));
                } else {
                    phi_660_ = _e291;
                }
                let _e400 = phi_660_;
                let _e402 = p.member.map_size;
                let _e403 = f32(_e402);
                let _e406 = ((_e264 * _e403) - 0.5f);
                let _e407 = ((_e278 * _e403) - 0.5f);
                if (_e406 > -8388608f) {
                    let _e419 = f32(select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406)));
                    if (_e419 > _e406) {
                        phi_689_ = 1f;
                    } else {
                        phi_689_ = 0f;
                    }
                    let _e422 = phi_689_;
                    if (_e406 < 8388608f) {
                        phi_694_ = (_e419 - _e422);
                        phi_695_ = false;
                    } else {
                        phi_694_ = f32();
                        phi_695_ = true;
                    }
                    let _e425 = phi_694_;
                    let _e427 = phi_695_;
                    phi_696_ = _e425;
                    phi_697_ = _e427;
                } else {
                    phi_696_ = f32();
                    phi_697_ = true;
                }
                let _e429 = phi_696_;
                let _e431 = phi_697_;
                if _e431 {
                    phi_701_ = _e406;
                } else {
                    phi_701_ = _e429;
                }
                let _e433 = phi_701_;
                if (_e407 > -8388608f) {
                    let _e445 = f32(select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)));
                    if (_e445 > _e407) {
                        phi_721_ = 1f;
                    } else {
                        phi_721_ = 0f;
                    }
                    let _e448 = phi_721_;
                    if (_e407 < 8388608f) {
                        phi_726_ = (_e445 - _e448);
                        phi_727_ = false;
                    } else {
                        phi_726_ = f32();
                        phi_727_ = true;
                    }
                    let _e451 = phi_726_;
                    let _e453 = phi_727_;
                    phi_728_ = _e451;
                    phi_729_ = _e453;
                } else {
                    phi_728_ = f32();
                    phi_729_ = true;
                }
                let _e455 = phi_728_;
                let _e457 = phi_729_;
                if _e457 {
                    phi_733_ = _e407;
                } else {
                    phi_733_ = _e455;
                }
                let _e459 = phi_733_;
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
                    phi_781_ = _e470;
                } else {
                    phi_781_ = 0i;
                }
                let _e499 = phi_781_;
                if (_e479 > 0i) {
                    phi_786_ = _e479;
                } else {
                    phi_786_ = 0i;
                }
                let _e502 = phi_786_;
                if (_e499 < _e496) {
                    phi_791_ = _e499;
                } else {
                    phi_791_ = _e496;
                }
                let _e505 = phi_791_;
                if (_e502 < _e496) {
                    phi_796_ = _e502;
                } else {
                    phi_796_ = _e496;
                }
                let _e508 = phi_796_;
                let _e509 = bitcast<u32>(_e505);
                let _e511 = (_e470 + 1i);
                let _e512 = (_e479 + 1i);
                if (_e511 > 0i) {
                    phi_805_ = _e511;
                } else {
                    phi_805_ = 0i;
                }
                let _e515 = phi_805_;
                if (_e512 > 0i) {
                    phi_810_ = _e512;
                } else {
                    phi_810_ = 0i;
                }
                let _e518 = phi_810_;
                if (_e515 < _e496) {
                    phi_815_ = _e515;
                } else {
                    phi_815_ = _e496;
                }
                let _e521 = phi_815_;
                if (_e518 < _e496) {
                    phi_820_ = _e518;
                } else {
                    phi_820_ = _e496;
                }
                let _e524 = phi_820_;
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
                    phi_915_ = true;
                } else {
                    phi_915_ = (_e598 >= (1f - _e600));
                }
                let _e605 = phi_915_;
                if ((bitcast<u32>(_e598) & 2147483647u) > 2139095040u) {
                    phi_923_ = true;
                } else {
                    phi_923_ = !(_e605);
                }
                let _e611 = phi_923_;
                if _e611 {
                    if (_e598 > 0f) {
                        if (_e598 < 1f) {
                            phi_935_ = false;
                        } else {
                            phi_935_ = true;
                        }
                        let _e615 = phi_935_;
                        phi_936_ = _e615;
                    } else {
                        phi_936_ = true;
                    }
                    let _e617 = phi_936_;
                    if _e617 {
                        phi_940_ = 0.5f;
                    } else {
                        phi_940_ = _e598;
                    }
                    let _e619 = phi_940_;
                    phi_948_ = evaluate_Verdict(_e619, true);
                } else {
                    if (_e598 > 0.5f) {
                        phi_946_ = 1f;
                    } else {
                        phi_946_ = 0f;
                    }
                    let _e623 = phi_946_;
                    phi_948_ = evaluate_Verdict(_e623, false);
                }
                let _e626 = phi_948_;
                phi_953_ = evaluate_Verdict(_e626.visibility, _e626.is_doubted);
            } else {
                phi_953_ = evaluate_Verdict(0.5f, true);
            }
            let _e632 = phi_953_;
            phi_954_ = _e632;
        }
        let _e634 = phi_954_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e634.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
