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
    var phi_164_: lt_bvh_traverse_Tree;
    var phi_165_: bool;
    var phi_166_: lt_bvh_traverse_Tree;
    var phi_167_: bool;
    var phi_172_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_164_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_165_ = false;
        } else {
            phi_164_ = lt_bvh_traverse_Tree();
            phi_165_ = true;
        }
        let _e65 = phi_164_;
        let _e67 = phi_165_;
        phi_166_ = _e65;
        phi_167_ = _e67;
    } else {
        phi_166_ = lt_bvh_traverse_Tree();
        phi_167_ = true;
    }
    let _e69 = phi_166_;
    let _e71 = phi_167_;
    if _e71 {
        phi_172_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_172_ = _e69;
    }
    let _e76 = phi_172_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_197_: f32;
    var phi_198_: f32;
    var phi_199_: f32;
    var phi_212_: bool;
    var phi_216_: f32;
    var phi_229_: f32;
    var phi_234_: f32;
    var phi_256_: f32;
    var phi_261_: f32;
    var phi_262_: bool;
    var phi_263_: f32;
    var phi_264_: bool;
    var phi_268_: f32;
    var phi_306_: f32;
    var phi_322_: f32;
    var phi_323_: f32;
    var phi_324_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_199_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_198_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_197_ = 1f;
            } else {
                phi_197_ = param_6;
            }
            let _e61 = phi_197_;
            phi_198_ = _e61;
        }
        let _e63 = phi_198_;
        phi_199_ = _e63;
    }
    let _e65 = phi_199_;
    let _e67 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_212_ = true;
    } else {
        let _e71 = (84f < _e67);
        if _e71 {
        }
        phi_212_ = _e71;
    }
    let _e73 = phi_212_;
    if _e73 {
        phi_216_ = 84f;
    } else {
        phi_216_ = _e67;
    }
    let _e75 = phi_216_;
    let _e77 = (_e75 * (1f - _e65));
    if ((bitcast<u32>(_e77) & 2147483647u) > 2139095040u) {
        phi_306_ = _e77;
    } else {
        if (_e77 < -87f) {
            phi_229_ = -87f;
        } else {
            phi_229_ = _e77;
        }
        let _e83 = phi_229_;
        if (_e83 > 88f) {
            phi_234_ = 88f;
        } else {
            phi_234_ = _e83;
        }
        let _e86 = phi_234_;
        let _e88 = ((_e86 * 1.442695f) + 0.5f);
        if (_e88 > -8388608f) {
            let _e100 = f32(select(0i, select(select(i32(_e88), i32(-2147483648), (_e88 < bitcast<f32>(3472883712u))), 2147483647i, (_e88 > bitcast<f32>(1325400063u))), (_e88 == _e88)));
            if (_e100 > _e88) {
                phi_256_ = 1f;
            } else {
                phi_256_ = 0f;
            }
            let _e103 = phi_256_;
            if (_e88 < 8388608f) {
                phi_261_ = (_e100 - _e103);
                phi_262_ = false;
            } else {
                phi_261_ = f32();
                phi_262_ = true;
            }
            let _e106 = phi_261_;
            let _e108 = phi_262_;
            phi_263_ = _e106;
            phi_264_ = _e108;
        } else {
            phi_263_ = f32();
            phi_264_ = true;
        }
        let _e110 = phi_263_;
        let _e112 = phi_264_;
        if _e112 {
            phi_268_ = _e88;
        } else {
            phi_268_ = _e110;
        }
        let _e114 = phi_268_;
        let _e118 = ((_e86 - (_e114 * 0.69314575f)) - (_e114 * 0.0000014286068f));
        phi_306_ = ((((((((((((((((1f / 5040f) * _e118) + (1f / 720f)) * _e118) + (1f / 120f)) * _e118) + (1f / 24f)) * _e118) + (1f / 6f)) * _e118) + 0.5f) * _e118) + 1f) * _e118) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e154 = phi_306_;
    let _e155 = (param_5.x * _e154);
    if ((bitcast<u32>(_e155) & 2147483647u) > 2139095040u) {
        phi_324_ = _e155;
    } else {
        if (_e155 < 0f) {
            phi_323_ = 0f;
        } else {
            if (_e155 > 1f) {
                phi_322_ = 1f;
            } else {
                phi_322_ = _e155;
            }
            let _e162 = phi_322_;
            phi_323_ = _e162;
        }
        let _e164 = phi_323_;
        phi_324_ = _e164;
    }
    let _e166 = phi_324_;
    return _e166;
}

fn function_() {
    var local: f32;
    var phi_386_: bool;
    var phi_387_: bool;
    var phi_388_: bool;
    var phi_389_: bool;
    var phi_393_: bool;
    var phi_463_: bool;
    var phi_464_: bool;
    var phi_475_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_476_: bool;
    var phi_477_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_478_: bool;
    var phi_485_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_489_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_563_: bool;
    var phi_572_: bool;
    var phi_581_: bool;
    var phi_582_: bool;
    var phi_583_: bool;
    var phi_584_: bool;
    var phi_585_: bool;
    var phi_586_: bool;
    var phi_587_: bool;
    var phi_591_: bool;
    var phi_681_: f32;
    var phi_684_: f32;
    var phi_713_: f32;
    var phi_718_: f32;
    var phi_719_: bool;
    var phi_720_: f32;
    var phi_721_: bool;
    var phi_725_: f32;
    var phi_745_: f32;
    var phi_750_: f32;
    var phi_751_: bool;
    var phi_752_: f32;
    var phi_753_: bool;
    var phi_757_: f32;
    var phi_807_: i32;
    var phi_812_: i32;
    var phi_817_: i32;
    var phi_822_: i32;
    var phi_831_: i32;
    var phi_836_: i32;
    var phi_841_: i32;
    var phi_846_: i32;
    var phi_945_: i32;
    var phi_950_: i32;
    var phi_955_: i32;
    var phi_960_: i32;
    var phi_979_: i32;
    var phi_984_: i32;
    var phi_989_: i32;
    var phi_994_: i32;
    var phi_1013_: i32;
    var phi_1018_: i32;
    var phi_1023_: i32;
    var phi_1028_: i32;
    var phi_1047_: i32;
    var phi_1052_: i32;
    var phi_1057_: i32;
    var phi_1062_: i32;
    var phi_1140_: bool;
    var phi_1148_: bool;
    var phi_1160_: bool;
    var phi_1161_: bool;
    var phi_1165_: f32;
    var phi_1171_: f32;
    var phi_1173_: evaluate_Verdict;
    var phi_1183_: u32;
    var phi_1192_: f32;
    var phi_1194_: evaluate_Verdict;
    var phi_1195_: bool;
    var phi_1196_: evaluate_Verdict;
    var phi_1197_: bool;
    var phi_1202_: evaluate_Verdict;
    var phi_1207_: evaluate_Verdict;
    var phi_1208_: evaluate_Verdict;

    let _e53 = id_1;
    let _e60 = arrayLength((&map.member));
    let _e66 = arrayLength((&marks.member));
    let _e69 = p.member.size[0u];
    let _e71 = p.member.size[1u];
    let _e72 = lt_shaders_entry_pixel_index(_e53, _e69, _e71);
    if (bitcast<i32>(_e72.root) != 0i) {
        let _e78 = p.member.projection;
        if (_e72.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e82 = lt_math_OneLevel(_e78);
        let _e86 = samples.member[(0u + _e72.first_primitive)].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[(0u + _e72.first_primitive)].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[(0u + _e72.first_primitive)].normal[2u];
                let _e98 = global[2u];
                phi_386_ = (_e96 == _e98);
                phi_387_ = false;
            } else {
                phi_386_ = bool();
                phi_387_ = true;
            }
            let _e101 = phi_386_;
            let _e103 = phi_387_;
            phi_388_ = _e101;
            phi_389_ = _e103;
        } else {
            phi_388_ = bool();
            phi_389_ = true;
        }
        let _e105 = phi_388_;
        let _e107 = phi_389_;
        if _e107 {
            phi_393_ = false;
        } else {
            phi_393_ = _e105;
        }
        let _e109 = phi_393_;
        if !(_e109) {
            let _e112 = samples.member[(0u + _e72.first_primitive)].position;
            let _e114 = p.member.light.place;
            let _e120 = p.member.light.place[3u];
            let _e127 = (_e114.x - (_e112.x * _e120));
            let _e128 = (_e114.y - (_e112.y * _e120));
            let _e129 = (_e114.z - (_e112.z * _e120));
            let _e131 = samples.member[(0u + _e72.first_primitive)].normal;
            if ((((_e131.x * _e127) + (_e131.y * _e128)) + (_e131.z * _e129)) > 0f) {
                let _e145 = (((_e127 * _e127) + (_e128 * _e128)) + (_e129 * _e129));
                let _e147 = p.member.light.axis;
                let _e159 = p.member.light.place[3u];
                if (_e159 == 0f) {
                    phi_464_ = true;
                } else {
                    let _e162 = p.member.light.range_squared;
                    if (_e145 <= _e162) {
                        let _e165 = p.member.light.cos_outer;
                        phi_463_ = (-((((_e127 * _e147.x) + (_e128 * _e147.y)) + (_e129 * _e147.z))) >= (_e165 * sqrt(_e145)));
                    } else {
                        phi_463_ = false;
                    }
                    let _e170 = phi_463_;
                    phi_464_ = _e170;
                }
                let _e172 = phi_464_;
                if _e172 {
                    let _e174 = samples.member[(0u + _e72.first_primitive)].flags;
                    let _e182 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e182.unnamed.visibility, false), _e182.unnamed_1);
                    phi_475_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e188.unnamed, ((_e174 & 1u) == 0u));
                    phi_476_ = false;
                } else {
                    phi_475_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_476_ = true;
                }
                let _e193 = phi_475_;
                let _e195 = phi_476_;
                phi_477_ = _e193;
                phi_478_ = _e195;
            } else {
                phi_477_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_478_ = true;
            }
            let _e197 = phi_477_;
            let _e199 = phi_478_;
            if _e199 {
                let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
                phi_485_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
            } else {
                phi_485_ = _e197;
            }
            let _e216 = phi_485_;
            phi_489_ = _e216;
        } else {
            let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
            phi_489_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, true);
        }
        let _e233 = phi_489_;
        if _e233.unnamed_1 {
            phi_1208_ = evaluate_Verdict(_e233.unnamed.visibility, _e233.unnamed.is_doubted);
        } else {
            let _e241 = samples.member[(0u + _e72.first_primitive)].position;
            let _e259 = ((((_e82.projection.row_w.x * _e241.x) + (_e82.projection.row_w.y * _e241.y)) + (_e82.projection.row_w.z * _e241.z)) + (_e82.projection.row_w.w * 1f));
            let _e273 = (((((_e82.projection.row_x.x * _e241.x) + (_e82.projection.row_x.y * _e241.y)) + (_e82.projection.row_x.z * _e241.z)) + (_e82.projection.row_x.w * 1f)) / _e259);
            let _e287 = (((((_e82.projection.row_y.x * _e241.x) + (_e82.projection.row_y.y * _e241.y)) + (_e82.projection.row_y.z * _e241.z)) + (_e82.projection.row_y.w * 1f)) / _e259);
            let _e300 = ((((_e82.projection.row_z.x * _e241.x) + (_e82.projection.row_z.y * _e241.y)) + (_e82.projection.row_z.z * _e241.z)) + (_e82.projection.row_z.w * 1f));
            if (_e259 > 0f) {
                if (_e273 >= 0f) {
                    phi_563_ = (_e273 <= 1f);
                } else {
                    phi_563_ = false;
                }
                let _e305 = phi_563_;
                if _e305 {
                    if (_e287 >= 0f) {
                        phi_572_ = (_e287 <= 1f);
                    } else {
                        phi_572_ = false;
                    }
                    let _e309 = phi_572_;
                    if _e309 {
                        if (_e300 >= 0f) {
                            phi_581_ = (_e300 <= 1f);
                        } else {
                            phi_581_ = false;
                        }
                        let _e313 = phi_581_;
                        phi_582_ = _e313;
                        phi_583_ = false;
                    } else {
                        phi_582_ = bool();
                        phi_583_ = true;
                    }
                    let _e315 = phi_582_;
                    let _e317 = phi_583_;
                    phi_584_ = _e315;
                    phi_585_ = _e317;
                } else {
                    phi_584_ = bool();
                    phi_585_ = true;
                }
                let _e319 = phi_584_;
                let _e321 = phi_585_;
                phi_586_ = _e319;
                phi_587_ = _e321;
            } else {
                phi_586_ = bool();
                phi_587_ = true;
            }
            let _e323 = phi_586_;
            let _e325 = phi_587_;
            if _e325 {
                phi_591_ = false;
            } else {
                phi_591_ = _e323;
            }
            let _e327 = phi_591_;
            if _e327 {
                if (0f > 0f) {
                    let _e330 = samples.member[(0u + _e72.first_primitive)].normal;
                    let _e332 = p.member.map_size;
                    let _e402 = ((abs(((((_e78.row_x.x * _e330.x) + (_e78.row_x.y * _e330.y)) + (_e78.row_x.z * _e330.z)) / (((_e78.row_x.x * _e78.row_x.x) + (_e78.row_x.y * _e78.row_x.y)) + (_e78.row_x.z * _e78.row_x.z)))) + abs(((((_e78.row_y.x * _e330.x) + (_e78.row_y.y * _e330.y)) + (_e78.row_y.z * _e330.z)) / (((_e78.row_y.x * _e78.row_y.x) + (_e78.row_y.y * _e78.row_y.y)) + (_e78.row_y.z * _e78.row_y.z))))) / (abs(((((_e78.row_z.x * _e330.x) + (_e78.row_z.y * _e330.y)) + (_e78.row_z.z * _e330.z)) / (((_e78.row_z.x * _e78.row_z.x) + (_e78.row_z.y * _e78.row_z.y)) + (_e78.row_z.z * _e78.row_z.z)))) * f32(_e332)));
                    if (_e402 < 0.002f) {
                        phi_681_ = _e402;
                    } else {
                        phi_681_ = 0.002f;
                    }
                    let _e405 = phi_681_;
                    phi_684_ = (_e300 - (0f * _e405));
                } else {
                    phi_684_ = _e300;
                }
                let _e409 = phi_684_;
                let _e411 = p.member.map_size;
                let _e412 = f32(_e411);
                let _e415 = ((_e273 * _e412) - 0.5f);
                let _e416 = ((_e287 * _e412) - 0.5f);
                if (_e415 > -8388608f) {
                    let _e428 = f32(select(0i, select(select(i32(_e415), i32(-2147483648), (_e415 < bitcast<f32>(3472883712u))), 2147483647i, (_e415 > bitcast<f32>(1325400063u))), (_e415 == _e415)));
                    if (_e428 > _e415) {
                        phi_713_ = 1f;
                    } else {
                        phi_713_ = 0f;
                    }
                    let _e431 = phi_713_;
                    if (_e415 < 8388608f) {
                        phi_718_ = (_e428 - _e431);
                        phi_719_ = false;
                    } else {
                        phi_718_ = f32();
                        phi_719_ = true;
                    }
                    let _e434 = phi_718_;
                    let _e436 = phi_719_;
                    phi_720_ = _e434;
                    phi_721_ = _e436;
                } else {
                    phi_720_ = f32();
                    phi_721_ = true;
                }
                let _e438 = phi_720_;
                let _e440 = phi_721_;
                if _e440 {
                    phi_725_ = _e415;
                } else {
                    phi_725_ = _e438;
                }
                let _e442 = phi_725_;
                if (_e416 > -8388608f) {
                    let _e454 = f32(select(0i, select(select(i32(_e416), i32(-2147483648), (_e416 < bitcast<f32>(3472883712u))), 2147483647i, (_e416 > bitcast<f32>(1325400063u))), (_e416 == _e416)));
                    if (_e454 > _e416) {
                        phi_745_ = 1f;
                    } else {
                        phi_745_ = 0f;
                    }
                    let _e457 = phi_745_;
                    if (_e416 < 8388608f) {
                        phi_750_ = (_e454 - _e457);
                        phi_751_ = false;
                    } else {
                        phi_750_ = f32();
                        phi_751_ = true;
                    }
                    let _e460 = phi_750_;
                    let _e462 = phi_751_;
                    phi_752_ = _e460;
                    phi_753_ = _e462;
                } else {
                    phi_752_ = f32();
                    phi_753_ = true;
                }
                let _e464 = phi_752_;
                let _e466 = phi_753_;
                if _e466 {
                    phi_757_ = _e416;
                } else {
                    phi_757_ = _e464;
                }
                let _e468 = phi_757_;
                let _e469 = (_e415 - _e442);
                let _e470 = (_e416 - _e468);
                let _e479 = select(0i, select(select(i32(_e442), i32(-2147483648), (_e442 < bitcast<f32>(3472883712u))), 2147483647i, (_e442 > bitcast<f32>(1325400063u))), (_e442 == _e442));
                let _e488 = select(0i, select(select(i32(_e468), i32(-2147483648), (_e468 < bitcast<f32>(3472883712u))), 2147483647i, (_e468 > bitcast<f32>(1325400063u))), (_e468 == _e468));
                let _e491 = ((1f - _e469) * (1f - _e470));
                let _e493 = (_e469 * (1f - _e470));
                let _e495 = ((1f - _e469) * _e470);
                let _e496 = (_e469 * _e470);
                let _e498 = p.member.test;
                let _e499 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e498);
                let _e501 = p.member.map_size;
                local = _e499;
                let _e503 = ((0u * _e501) * _e501);
                let _e505 = (bitcast<i32>(_e501) - 1i);
                if (_e479 > 0i) {
                    phi_807_ = _e479;
                } else {
                    phi_807_ = 0i;
                }
                let _e508 = phi_807_;
                if (_e488 > 0i) {
                    phi_812_ = _e488;
                } else {
                    phi_812_ = 0i;
                }
                let _e511 = phi_812_;
                if (_e508 < _e505) {
                    phi_817_ = _e508;
                } else {
                    phi_817_ = _e505;
                }
                let _e514 = phi_817_;
                if (_e511 < _e505) {
                    phi_822_ = _e511;
                } else {
                    phi_822_ = _e505;
                }
                let _e517 = phi_822_;
                let _e518 = bitcast<u32>(_e514);
                let _e520 = (_e479 + 1i);
                let _e521 = (_e488 + 1i);
                if (_e520 > 0i) {
                    phi_831_ = _e520;
                } else {
                    phi_831_ = 0i;
                }
                let _e524 = phi_831_;
                if (_e521 > 0i) {
                    phi_836_ = _e521;
                } else {
                    phi_836_ = 0i;
                }
                let _e527 = phi_836_;
                if (_e524 < _e505) {
                    phi_841_ = _e524;
                } else {
                    phi_841_ = _e505;
                }
                let _e530 = phi_841_;
                if (_e527 < _e505) {
                    phi_846_ = _e527;
                } else {
                    phi_846_ = _e505;
                }
                let _e533 = phi_846_;
                let _e534 = bitcast<u32>(_e530);
                let _e536 = (bitcast<u32>(_e517) * _e501);
                let _e537 = (bitcast<u32>(_e533) * _e501);
                let _e542 = ((_e536 + _e518) + _e503);
                let _e543 = ((_e536 + _e534) + _e503);
                let _e544 = ((_e537 + _e518) + _e503);
                let _e545 = ((_e537 + _e534) + _e503);
                if (_e542 < _e60) {
                } else {
                    return;
                }
                let _e549 = map.member[(0u + _e542)];
                if (_e543 < _e60) {
                } else {
                    return;
                }
                let _e561 = map.member[(0u + _e543)];
                if (_e544 < _e60) {
                } else {
                    return;
                }
                let _e577 = map.member[(0u + _e544)];
                if (_e545 < _e60) {
                } else {
                    return;
                }
                let _e593 = map.member[(0u + _e545)];
                let _e607 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e549.x * _e491) + (_e561.x * _e493)) + (_e577.x * _e495)) + (_e593.x * _e496)), ((((_e549.y * _e491) + (_e561.y * _e493)) + (_e577.y * _e495)) + (_e593.y * _e496)), ((((_e549.z * _e491) + (_e561.z * _e493)) + (_e577.z * _e495)) + (_e593.z * _e496)), ((((_e549.w * _e491) + (_e561.w * _e493)) + (_e577.w * _e495)) + (_e593.w * _e496))), _e409);
                let _e609 = p.member.map_size;
                let _e611 = (bitcast<i32>(_e609) - 1i);
                if (_e479 > 0i) {
                    phi_945_ = _e479;
                } else {
                    phi_945_ = 0i;
                }
                let _e614 = phi_945_;
                if (_e488 > 0i) {
                    phi_950_ = _e488;
                } else {
                    phi_950_ = 0i;
                }
                let _e617 = phi_950_;
                if (_e614 < _e611) {
                    phi_955_ = _e614;
                } else {
                    phi_955_ = _e611;
                }
                let _e620 = phi_955_;
                if (_e617 < _e611) {
                    phi_960_ = _e617;
                } else {
                    phi_960_ = _e611;
                }
                let _e623 = phi_960_;
                let _e624 = bitcast<u32>(_e620);
                let _e631 = ((((0u * _e609) + bitcast<u32>(_e623)) * (_e609 / 16u)) + (_e624 / 16u));
                let _e634 = (_e479 + 1i);
                let _e635 = (_e488 + 0i);
                let _e637 = (bitcast<i32>(_e609) - 1i);
                if (_e634 > 0i) {
                    phi_979_ = _e634;
                } else {
                    phi_979_ = 0i;
                }
                let _e640 = phi_979_;
                if (_e635 > 0i) {
                    phi_984_ = _e635;
                } else {
                    phi_984_ = 0i;
                }
                let _e643 = phi_984_;
                if (_e640 < _e637) {
                    phi_989_ = _e640;
                } else {
                    phi_989_ = _e637;
                }
                let _e646 = phi_989_;
                if (_e643 < _e637) {
                    phi_994_ = _e643;
                } else {
                    phi_994_ = _e637;
                }
                let _e649 = phi_994_;
                let _e650 = bitcast<u32>(_e646);
                let _e657 = ((((0u * _e609) + bitcast<u32>(_e649)) * (_e609 / 16u)) + (_e650 / 16u));
                let _e660 = (_e479 + 0i);
                let _e661 = (_e488 + 1i);
                let _e663 = (bitcast<i32>(_e609) - 1i);
                if (_e660 > 0i) {
                    phi_1013_ = _e660;
                } else {
                    phi_1013_ = 0i;
                }
                let _e666 = phi_1013_;
                if (_e661 > 0i) {
                    phi_1018_ = _e661;
                } else {
                    phi_1018_ = 0i;
                }
                let _e669 = phi_1018_;
                if (_e666 < _e663) {
                    phi_1023_ = _e666;
                } else {
                    phi_1023_ = _e663;
                }
                let _e672 = phi_1023_;
                if (_e669 < _e663) {
                    phi_1028_ = _e669;
                } else {
                    phi_1028_ = _e663;
                }
                let _e675 = phi_1028_;
                let _e676 = bitcast<u32>(_e672);
                let _e683 = ((((0u * _e609) + bitcast<u32>(_e675)) * (_e609 / 16u)) + (_e676 / 16u));
                let _e686 = (_e479 + 1i);
                let _e687 = (_e488 + 1i);
                let _e689 = (bitcast<i32>(_e609) - 1i);
                if (_e686 > 0i) {
                    phi_1047_ = _e686;
                } else {
                    phi_1047_ = 0i;
                }
                let _e692 = phi_1047_;
                if (_e687 > 0i) {
                    phi_1052_ = _e687;
                } else {
                    phi_1052_ = 0i;
                }
                let _e695 = phi_1052_;
                if (_e692 < _e689) {
                    phi_1057_ = _e692;
                } else {
                    phi_1057_ = _e689;
                }
                let _e698 = phi_1057_;
                if (_e695 < _e689) {
                    phi_1062_ = _e695;
                } else {
                    phi_1062_ = _e689;
                }
                let _e701 = phi_1062_;
                let _e702 = bitcast<u32>(_e698);
                let _e709 = ((((0u * _e609) + bitcast<u32>(_e701)) * (_e609 / 16u)) + (_e702 / 16u));
                if (_e631 < _e66) {
                } else {
                    return;
                }
                let _e715 = marks.member[(0u + _e631)];
                if (_e657 < _e66) {
                } else {
                    return;
                }
                let _e723 = marks.member[(0u + _e657)];
                if (_e683 < _e66) {
                } else {
                    return;
                }
                let _e732 = marks.member[(0u + _e683)];
                if (_e709 < _e66) {
                } else {
                    return;
                }
                let _e740 = marks.member[(0u + _e709)];
                let _e748 = p.member.epsilon;
                if (_e607 <= _e748) {
                    phi_1140_ = true;
                } else {
                    phi_1140_ = (_e607 >= (1f - _e748));
                }
                let _e753 = phi_1140_;
                if ((bitcast<u32>(_e607) & 2147483647u) > 2139095040u) {
                    phi_1148_ = true;
                } else {
                    phi_1148_ = !(_e753);
                }
                let _e759 = phi_1148_;
                if _e759 {
                    if (_e607 > 0f) {
                        if (_e607 < 1f) {
                            phi_1160_ = false;
                        } else {
                            phi_1160_ = true;
                        }
                        let _e763 = phi_1160_;
                        phi_1161_ = _e763;
                    } else {
                        phi_1161_ = true;
                    }
                    let _e765 = phi_1161_;
                    if _e765 {
                        phi_1165_ = 0.5f;
                    } else {
                        phi_1165_ = _e607;
                    }
                    let _e767 = phi_1165_;
                    phi_1173_ = evaluate_Verdict(_e767, true);
                } else {
                    if (_e607 > 0.5f) {
                        phi_1171_ = 1f;
                    } else {
                        phi_1171_ = 0f;
                    }
                    let _e771 = phi_1171_;
                    phi_1173_ = evaluate_Verdict(_e771, false);
                }
                let _e774 = phi_1173_;
                let _e777 = (_e774.visibility < 0.5f);
                if _e774.is_doubted {
                    phi_1196_ = evaluate_Verdict();
                    phi_1197_ = true;
                } else {
                    if _e777 {
                        phi_1183_ = 2u;
                    } else {
                        phi_1183_ = 1u;
                    }
                    let _e779 = phi_1183_;
                    if ((((((_e715 >> bitcast<u32>((((_e624 % 16u) * 2u) & 31u))) & 3u) | ((_e723 >> bitcast<u32>((((_e650 % 16u) * 2u) & 31u))) & 3u)) | (((_e732 >> bitcast<u32>((((_e676 % 16u) * 2u) & 31u))) & 3u) | ((_e740 >> bitcast<u32>((((_e702 % 16u) * 2u) & 31u))) & 3u))) & _e779) != 0u) {
                        if _e777 {
                            phi_1192_ = 0.000000059604645f;
                        } else {
                            phi_1192_ = 0.99999994f;
                        }
                        let _e783 = phi_1192_;
                        phi_1194_ = evaluate_Verdict(_e783, true);
                        phi_1195_ = false;
                    } else {
                        phi_1194_ = evaluate_Verdict();
                        phi_1195_ = true;
                    }
                    let _e786 = phi_1194_;
                    let _e788 = phi_1195_;
                    phi_1196_ = _e786;
                    phi_1197_ = _e788;
                }
                let _e790 = phi_1196_;
                let _e792 = phi_1197_;
                if _e792 {
                    phi_1202_ = evaluate_Verdict(_e774.visibility, _e774.is_doubted);
                } else {
                    phi_1202_ = _e790;
                }
                let _e795 = phi_1202_;
                phi_1207_ = evaluate_Verdict(_e795.visibility, _e795.is_doubted);
            } else {
                phi_1207_ = evaluate_Verdict(0.5f, true);
            }
            let _e801 = phi_1207_;
            phi_1208_ = _e801;
        }
        let _e803 = phi_1208_;
        if (_e72.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e72.first_primitive)] = _e803.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_prefiltered_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
