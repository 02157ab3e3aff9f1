struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_18 {
    member: array<abi_Sample>,
}

struct type_22 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_30 {
    member: array<vec4<f32>>,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_34 {
    member: abi_ShadowParams,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_18;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_34;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_22;
@group(0) @binding(2) 
var<storage> map: type_30;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_139_: lt_bvh_traverse_Tree;
    var phi_140_: bool;
    var phi_141_: lt_bvh_traverse_Tree;
    var phi_142_: bool;
    var phi_147_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_139_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_140_ = false;
        } else {
            phi_139_ = lt_bvh_traverse_Tree();
            phi_140_ = true;
        }
        let _e58 = phi_139_;
        let _e60 = phi_140_;
        phi_141_ = _e58;
        phi_142_ = _e60;
    } else {
        phi_141_ = lt_bvh_traverse_Tree();
        phi_142_ = true;
    }
    let _e62 = phi_141_;
    let _e64 = phi_142_;
    if _e64 {
        phi_147_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_147_ = _e62;
    }
    let _e69 = phi_147_;
    return lt_bvh_traverse_Tree(_e69.root, _e69.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_167_: bool;
    var phi_171_: f32;

    let _e46 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_167_ = true;
    } else {
        let _e50 = (84f < _e46);
        if _e50 {
        }
        phi_167_ = _e50;
    }
    let _e52 = phi_167_;
    if _e52 {
        phi_171_ = 84f;
    } else {
        phi_171_ = _e46;
    }
    let _e54 = phi_171_;
    return _e54;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_670_: f32;
    var phi_671_: f32;
    var phi_672_: f32;
    var phi_687_: f32;
    var phi_692_: f32;
    var phi_714_: f32;
    var phi_719_: f32;
    var phi_720_: bool;
    var phi_721_: f32;
    var phi_722_: bool;
    var phi_726_: f32;
    var phi_764_: f32;
    var phi_780_: f32;
    var phi_781_: f32;
    var phi_782_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_672_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_671_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_670_ = 1f;
            } else {
                phi_670_ = param_7;
            }
            let _e54 = phi_670_;
            phi_671_ = _e54;
        }
        let _e56 = phi_671_;
        phi_672_ = _e56;
    }
    let _e58 = phi_672_;
    let _e60 = _lt_math_esm_Esm_clamped_exponent(param_5);
    let _e62 = (_e60 * (1f - _e58));
    if ((bitcast<u32>(_e62) & 2147483647u) > 2139095040u) {
        phi_764_ = _e62;
    } else {
        if (_e62 < -87f) {
            phi_687_ = -87f;
        } else {
            phi_687_ = _e62;
        }
        let _e68 = phi_687_;
        if (_e68 > 88f) {
            phi_692_ = 88f;
        } else {
            phi_692_ = _e68;
        }
        let _e71 = phi_692_;
        let _e73 = ((_e71 * 1.442695f) + 0.5f);
        if (_e73 > -8388608f) {
            let _e85 = f32(select(0i, select(select(i32(_e73), i32(-2147483648), (_e73 < bitcast<f32>(3472883712u))), 2147483647i, (_e73 > bitcast<f32>(1325400063u))), (_e73 == _e73)));
            if (_e85 > _e73) {
                phi_714_ = 1f;
            } else {
                phi_714_ = 0f;
            }
            let _e88 = phi_714_;
            if (_e73 < 8388608f) {
                phi_719_ = (_e85 - _e88);
                phi_720_ = false;
            } else {
                phi_719_ = f32();
                phi_720_ = true;
            }
            let _e91 = phi_719_;
            let _e93 = phi_720_;
            phi_721_ = _e91;
            phi_722_ = _e93;
        } else {
            phi_721_ = f32();
            phi_722_ = true;
        }
        let _e95 = phi_721_;
        let _e97 = phi_722_;
        if _e97 {
            phi_726_ = _e73;
        } else {
            phi_726_ = _e95;
        }
        let _e99 = phi_726_;
        let _e103 = ((_e71 - (_e99 * 0.69314575f)) - (_e99 * 0.0000014286068f));
        phi_764_ = ((((((((((((((((1f / 5040f) * _e103) + (1f / 720f)) * _e103) + (1f / 120f)) * _e103) + (1f / 24f)) * _e103) + (1f / 6f)) * _e103) + 0.5f) * _e103) + 1f) * _e103) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e99), i32(-2147483648), (_e99 < bitcast<f32>(3472883712u))), 2147483647i, (_e99 > bitcast<f32>(1325400063u))), (_e99 == _e99)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e139 = phi_764_;
    let _e140 = (param_6.x * _e139);
    if ((bitcast<u32>(_e140) & 2147483647u) > 2139095040u) {
        phi_782_ = _e140;
    } else {
        if (_e140 < 0f) {
            phi_781_ = 0f;
        } else {
            if (_e140 > 1f) {
                phi_780_ = 1f;
            } else {
                phi_780_ = _e140;
            }
            let _e147 = phi_780_;
            phi_781_ = _e147;
        }
        let _e149 = phi_781_;
        phi_782_ = _e149;
    }
    let _e151 = phi_782_;
    return _e151;
}

fn function_() {
    var local: f32;
    var phi_225_: bool;
    var phi_226_: bool;
    var phi_227_: bool;
    var phi_228_: bool;
    var phi_232_: bool;
    var phi_276_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_280_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_357_: bool;
    var phi_366_: bool;
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_377_: bool;
    var phi_378_: bool;
    var phi_379_: bool;
    var phi_380_: bool;
    var phi_381_: bool;
    var phi_385_: bool;
    var phi_421_: f32;
    var phi_426_: f32;
    var phi_427_: bool;
    var phi_428_: f32;
    var phi_429_: bool;
    var phi_433_: f32;
    var phi_453_: f32;
    var phi_458_: f32;
    var phi_459_: bool;
    var phi_460_: f32;
    var phi_461_: bool;
    var phi_465_: f32;
    var phi_511_: i32;
    var phi_516_: i32;
    var phi_521_: i32;
    var phi_526_: i32;
    var phi_535_: i32;
    var phi_540_: i32;
    var phi_545_: i32;
    var phi_550_: i32;
    var phi_635_: evaluate_Verdict;
    var phi_636_: evaluate_Verdict;
    var phi_637_: bool;
    var phi_638_: evaluate_Verdict;
    var phi_639_: evaluate_Verdict;
    var phi_640_: bool;
    var phi_644_: evaluate_Verdict;

    let _e46 = id_1;
    let _e53 = arrayLength((&map.member));
    let _e59 = p.member.size[0u];
    let _e61 = p.member.size[1u];
    let _e62 = lt_shaders_entry_pixel_index(_e46, _e59, _e61);
    if (bitcast<i32>(_e62.root) != 0i) {
        if (_e62.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e71 = p.member.light;
        let _e74 = samples.member[(0u + _e62.first_primitive)].normal[0u];
        let _e76 = global[0u];
        if (_e74 == _e76) {
            let _e79 = samples.member[(0u + _e62.first_primitive)].normal[1u];
            let _e81 = global[1u];
            if (_e79 == _e81) {
                let _e84 = samples.member[(0u + _e62.first_primitive)].normal[2u];
                let _e86 = global[2u];
                phi_225_ = (_e84 == _e86);
                phi_226_ = false;
            } else {
                phi_225_ = bool();
                phi_226_ = true;
            }
            let _e89 = phi_225_;
            let _e91 = phi_226_;
            phi_227_ = _e89;
            phi_228_ = _e91;
        } else {
            phi_227_ = bool();
            phi_228_ = true;
        }
        let _e93 = phi_227_;
        let _e95 = phi_228_;
        if _e95 {
            phi_232_ = false;
        } else {
            phi_232_ = _e93;
        }
        let _e97 = phi_232_;
        if !(_e97) {
            let _e100 = samples.member[(0u + _e62.first_primitive)].normal;
            let _e102 = samples.member[(0u + _e62.first_primitive)].position;
            if ((((_e100.x * (_e71.x - (_e102.x * _e71.w))) + (_e100.y * (_e71.y - (_e102.y * _e71.w)))) + (_e100.z * (_e71.z - (_e102.z * _e71.w)))) > 0f) {
                let _e126 = samples.member[(0u + _e62.first_primitive)].flags;
                let _e134 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e134.unnamed.visibility, false), _e134.unnamed_1);
                phi_276_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e140.unnamed, ((_e126 & 1u) == 0u));
            } else {
                let _e149 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e149.unnamed.visibility, false), _e149.unnamed_1);
                phi_276_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e155.unnamed, true);
            }
            let _e160 = phi_276_;
            phi_280_ = _e160;
        } else {
            let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e166.unnamed.visibility, false), _e166.unnamed_1);
            phi_280_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e172.unnamed, true);
        }
        let _e177 = phi_280_;
        if _e177.unnamed_1 {
            phi_638_ = evaluate_Verdict(_e177.unnamed.visibility, _e177.unnamed.is_doubted);
            phi_639_ = evaluate_Verdict();
            phi_640_ = true;
        } else {
            let _e185 = samples.member[(0u + _e62.first_primitive)].position;
            let _e191 = p.member.projection.row_w;
            let _e202 = ((((_e191.x * _e185.x) + (_e191.y * _e185.y)) + (_e191.z * _e185.z)) + (_e191.w * 1f));
            let _e204 = p.member.projection.row_x;
            let _e216 = (((((_e204.x * _e185.x) + (_e204.y * _e185.y)) + (_e204.z * _e185.z)) + (_e204.w * 1f)) / _e202);
            let _e218 = p.member.projection.row_y;
            let _e230 = (((((_e218.x * _e185.x) + (_e218.y * _e185.y)) + (_e218.z * _e185.z)) + (_e218.w * 1f)) / _e202);
            let _e232 = p.member.projection.row_z;
            let _e243 = ((((_e232.x * _e185.x) + (_e232.y * _e185.y)) + (_e232.z * _e185.z)) + (_e232.w * 1f));
            if (_e202 > 0f) {
                if (_e216 >= 0f) {
                    phi_357_ = (_e216 <= 1f);
                } else {
                    phi_357_ = false;
                }
                let _e248 = phi_357_;
                if _e248 {
                    if (_e230 >= 0f) {
                        phi_366_ = (_e230 <= 1f);
                    } else {
                        phi_366_ = false;
                    }
                    let _e252 = phi_366_;
                    if _e252 {
                        if (_e243 >= 0f) {
                            phi_375_ = (_e243 <= 1f);
                        } else {
                            phi_375_ = false;
                        }
                        let _e256 = phi_375_;
                        phi_376_ = _e256;
                        phi_377_ = false;
                    } else {
                        phi_376_ = bool();
                        phi_377_ = true;
                    }
                    let _e258 = phi_376_;
                    let _e260 = phi_377_;
                    phi_378_ = _e258;
                    phi_379_ = _e260;
                } else {
                    phi_378_ = bool();
                    phi_379_ = true;
                }
                let _e262 = phi_378_;
                let _e264 = phi_379_;
                phi_380_ = _e262;
                phi_381_ = _e264;
            } else {
                phi_380_ = bool();
                phi_381_ = true;
            }
            let _e266 = phi_380_;
            let _e268 = phi_381_;
            if _e268 {
                phi_385_ = false;
            } else {
                phi_385_ = _e266;
            }
            let _e270 = phi_385_;
            if _e270 {
                let _e272 = p.member.map_size;
                let _e273 = f32(_e272);
                let _e276 = ((_e216 * _e273) - 0.5f);
                let _e277 = ((_e230 * _e273) - 0.5f);
                if (_e276 > -8388608f) {
                    let _e289 = f32(select(0i, select(select(i32(_e276), i32(-2147483648), (_e276 < bitcast<f32>(3472883712u))), 2147483647i, (_e276 > bitcast<f32>(1325400063u))), (_e276 == _e276)));
                    if (_e289 > _e276) {
                        phi_421_ = 1f;
                    } else {
                        phi_421_ = 0f;
                    }
                    let _e292 = phi_421_;
                    if (_e276 < 8388608f) {
                        phi_426_ = (_e289 - _e292);
                        phi_427_ = false;
                    } else {
                        phi_426_ = f32();
                        phi_427_ = true;
                    }
                    let _e295 = phi_426_;
                    let _e297 = phi_427_;
                    phi_428_ = _e295;
                    phi_429_ = _e297;
                } else {
                    phi_428_ = f32();
                    phi_429_ = true;
                }
                let _e299 = phi_428_;
                let _e301 = phi_429_;
                if _e301 {
                    phi_433_ = _e276;
                } else {
                    phi_433_ = _e299;
                }
                let _e303 = phi_433_;
                if (_e277 > -8388608f) {
                    let _e315 = f32(select(0i, select(select(i32(_e277), i32(-2147483648), (_e277 < bitcast<f32>(3472883712u))), 2147483647i, (_e277 > bitcast<f32>(1325400063u))), (_e277 == _e277)));
                    if (_e315 > _e277) {
                        phi_453_ = 1f;
                    } else {
                        phi_453_ = 0f;
                    }
                    let _e318 = phi_453_;
                    if (_e277 < 8388608f) {
                        phi_458_ = (_e315 - _e318);
                        phi_459_ = false;
                    } else {
                        phi_458_ = f32();
                        phi_459_ = true;
                    }
                    let _e321 = phi_458_;
                    let _e323 = phi_459_;
                    phi_460_ = _e321;
                    phi_461_ = _e323;
                } else {
                    phi_460_ = f32();
                    phi_461_ = true;
                }
                let _e325 = phi_460_;
                let _e327 = phi_461_;
                if _e327 {
                    phi_465_ = _e277;
                } else {
                    phi_465_ = _e325;
                }
                let _e329 = phi_465_;
                let _e330 = (_e276 - _e303);
                let _e331 = (_e277 - _e329);
                let _e340 = select(0i, select(select(i32(_e303), i32(-2147483648), (_e303 < bitcast<f32>(3472883712u))), 2147483647i, (_e303 > bitcast<f32>(1325400063u))), (_e303 == _e303));
                let _e349 = select(0i, select(select(i32(_e329), i32(-2147483648), (_e329 < bitcast<f32>(3472883712u))), 2147483647i, (_e329 > bitcast<f32>(1325400063u))), (_e329 == _e329));
                let _e352 = ((1f - _e330) * (1f - _e331));
                let _e354 = (_e330 * (1f - _e331));
                let _e356 = ((1f - _e330) * _e331);
                let _e357 = (_e330 * _e331);
                let _e359 = p.member.test;
                let _e360 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e359);
                let _e362 = p.member.map_size;
                local = _e360;
                let _e364 = (bitcast<i32>(_e362) - 1i);
                if (_e340 > 0i) {
                    phi_511_ = _e340;
                } else {
                    phi_511_ = 0i;
                }
                let _e367 = phi_511_;
                if (_e349 > 0i) {
                    phi_516_ = _e349;
                } else {
                    phi_516_ = 0i;
                }
                let _e370 = phi_516_;
                if (_e367 < _e364) {
                    phi_521_ = _e367;
                } else {
                    phi_521_ = _e364;
                }
                let _e373 = phi_521_;
                if (_e370 < _e364) {
                    phi_526_ = _e370;
                } else {
                    phi_526_ = _e364;
                }
                let _e376 = phi_526_;
                let _e377 = bitcast<u32>(_e373);
                let _e379 = (_e340 + 1i);
                let _e380 = (_e349 + 1i);
                if (_e379 > 0i) {
                    phi_535_ = _e379;
                } else {
                    phi_535_ = 0i;
                }
                let _e383 = phi_535_;
                if (_e380 > 0i) {
                    phi_540_ = _e380;
                } else {
                    phi_540_ = 0i;
                }
                let _e386 = phi_540_;
                if (_e383 < _e364) {
                    phi_545_ = _e383;
                } else {
                    phi_545_ = _e364;
                }
                let _e389 = phi_545_;
                if (_e386 < _e364) {
                    phi_550_ = _e386;
                } else {
                    phi_550_ = _e364;
                }
                let _e392 = phi_550_;
                let _e393 = bitcast<u32>(_e389);
                let _e395 = (bitcast<u32>(_e376) * _e362);
                let _e396 = (bitcast<u32>(_e392) * _e362);
                let _e397 = (_e395 + _e377);
                let _e398 = (_e395 + _e393);
                let _e399 = (_e396 + _e377);
                let _e400 = (_e396 + _e393);
                if (_e397 < _e53) {
                } else {
                    return;
                }
                let _e404 = map.member[(0u + _e397)];
                if (_e398 < _e53) {
                } else {
                    return;
                }
                let _e416 = map.member[(0u + _e398)];
                if (_e399 < _e53) {
                } else {
                    return;
                }
                let _e432 = map.member[(0u + _e399)];
                if (_e400 < _e53) {
                } else {
                    return;
                }
                let _e448 = map.member[(0u + _e400)];
                let _e462 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e404.x * _e352) + (_e416.x * _e354)) + (_e432.x * _e356)) + (_e448.x * _e357)), ((((_e404.y * _e352) + (_e416.y * _e354)) + (_e432.y * _e356)) + (_e448.y * _e357)), ((((_e404.z * _e352) + (_e416.z * _e354)) + (_e432.z * _e356)) + (_e448.z * _e357)), ((((_e404.w * _e352) + (_e416.w * _e354)) + (_e432.w * _e356)) + (_e448.w * _e357))), _e243);
                phi_635_ = evaluate_Verdict(_e462, false);
                phi_636_ = evaluate_Verdict();
                phi_637_ = false;
            } else {
                phi_635_ = evaluate_Verdict();
                phi_636_ = evaluate_Verdict(1f, false);
                phi_637_ = true;
            }
            let _e466 = phi_635_;
            let _e468 = phi_636_;
            let _e470 = phi_637_;
            phi_638_ = _e468;
            phi_639_ = _e466;
            phi_640_ = _e470;
        }
        let _e472 = phi_638_;
        let _e474 = phi_639_;
        let _e476 = phi_640_;
        if _e476 {
            phi_644_ = _e472;
        } else {
            phi_644_ = _e474;
        }
        let _e478 = phi_644_;
        if (_e62.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e62.first_primitive)] = _e478.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
