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
    var phi_173_: bool;
    var phi_177_: f32;
    var phi_178_: f32;

    let _e46 = (*param_4);
    if ((bitcast<u32>(_e46) & 2147483647u) > 2139095040u) {
        phi_178_ = _e46;
    } else {
        if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
            phi_173_ = true;
        } else {
            let _e53 = (84f < _e46);
            if _e53 {
            }
            phi_173_ = _e53;
        }
        let _e55 = phi_173_;
        if _e55 {
            phi_177_ = 84f;
        } else {
            phi_177_ = _e46;
        }
        let _e57 = phi_177_;
        phi_178_ = _e57;
    }
    let _e59 = phi_178_;
    return _e59;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_677_: f32;
    var phi_678_: f32;
    var phi_679_: f32;
    var phi_694_: f32;
    var phi_699_: f32;
    var phi_721_: f32;
    var phi_726_: f32;
    var phi_727_: bool;
    var phi_728_: f32;
    var phi_729_: bool;
    var phi_733_: f32;
    var phi_771_: f32;
    var phi_787_: f32;
    var phi_788_: f32;
    var phi_789_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_679_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_678_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_677_ = 1f;
            } else {
                phi_677_ = param_7;
            }
            let _e54 = phi_677_;
            phi_678_ = _e54;
        }
        let _e56 = phi_678_;
        phi_679_ = _e56;
    }
    let _e58 = phi_679_;
    let _e60 = _lt_math_esm_Esm_clamped_exponent(param_5);
    let _e62 = (_e60 * (1f - _e58));
    if ((bitcast<u32>(_e62) & 2147483647u) > 2139095040u) {
        phi_771_ = _e62;
    } else {
        if (_e62 < -87f) {
            phi_694_ = -87f;
        } else {
            phi_694_ = _e62;
        }
        let _e68 = phi_694_;
        if (_e68 > 88f) {
            phi_699_ = 88f;
        } else {
            phi_699_ = _e68;
        }
        let _e71 = phi_699_;
        let _e73 = ((_e71 * 1.442695f) + 0.5f);
        if (_e73 > -8388608f) {
            let _e85 = f32(select(0i, select(select(i32(_e73), i32(-2147483648), (_e73 < bitcast<f32>(3472883712u))), 2147483647i, (_e73 > bitcast<f32>(1325400063u))), (_e73 == _e73)));
            if (_e85 > _e73) {
                phi_721_ = 1f;
            } else {
                phi_721_ = 0f;
            }
            let _e88 = phi_721_;
            if (_e73 < 8388608f) {
                phi_726_ = (_e85 - _e88);
                phi_727_ = false;
            } else {
                phi_726_ = f32();
                phi_727_ = true;
            }
            let _e91 = phi_726_;
            let _e93 = phi_727_;
            phi_728_ = _e91;
            phi_729_ = _e93;
        } else {
            phi_728_ = f32();
            phi_729_ = true;
        }
        let _e95 = phi_728_;
        let _e97 = phi_729_;
        if _e97 {
            phi_733_ = _e73;
        } else {
            phi_733_ = _e95;
        }
        let _e99 = phi_733_;
        let _e103 = ((_e71 - (_e99 * 0.69314575f)) - (_e99 * 0.0000014286068f));
        phi_771_ = ((((((((((((((((1f / 5040f) * _e103) + (1f / 720f)) * _e103) + (1f / 120f)) * _e103) + (1f / 24f)) * _e103) + (1f / 6f)) * _e103) + 0.5f) * _e103) + 1f) * _e103) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e99), i32(-2147483648), (_e99 < bitcast<f32>(3472883712u))), 2147483647i, (_e99 > bitcast<f32>(1325400063u))), (_e99 == _e99)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e139 = phi_771_;
    let _e140 = (param_6.x * _e139);
    if ((bitcast<u32>(_e140) & 2147483647u) > 2139095040u) {
        phi_789_ = _e140;
    } else {
        if (_e140 < 0f) {
            phi_788_ = 0f;
        } else {
            if (_e140 > 1f) {
                phi_787_ = 1f;
            } else {
                phi_787_ = _e140;
            }
            let _e147 = phi_787_;
            phi_788_ = _e147;
        }
        let _e149 = phi_788_;
        phi_789_ = _e149;
    }
    let _e151 = phi_789_;
    return _e151;
}

fn function_() {
    var local: f32;
    var phi_232_: bool;
    var phi_233_: bool;
    var phi_234_: bool;
    var phi_235_: bool;
    var phi_239_: bool;
    var phi_283_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_287_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_364_: bool;
    var phi_373_: bool;
    var phi_382_: bool;
    var phi_383_: bool;
    var phi_384_: bool;
    var phi_385_: bool;
    var phi_386_: bool;
    var phi_387_: bool;
    var phi_388_: bool;
    var phi_392_: bool;
    var phi_428_: f32;
    var phi_433_: f32;
    var phi_434_: bool;
    var phi_435_: f32;
    var phi_436_: bool;
    var phi_440_: f32;
    var phi_460_: f32;
    var phi_465_: f32;
    var phi_466_: bool;
    var phi_467_: f32;
    var phi_468_: bool;
    var phi_472_: f32;
    var phi_518_: i32;
    var phi_523_: i32;
    var phi_528_: i32;
    var phi_533_: i32;
    var phi_542_: i32;
    var phi_547_: i32;
    var phi_552_: i32;
    var phi_557_: i32;
    var phi_642_: evaluate_Verdict;
    var phi_643_: evaluate_Verdict;
    var phi_644_: bool;
    var phi_645_: evaluate_Verdict;
    var phi_646_: evaluate_Verdict;
    var phi_647_: bool;
    var phi_651_: evaluate_Verdict;

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
                phi_232_ = (_e84 == _e86);
                phi_233_ = false;
            } else {
                phi_232_ = bool();
                phi_233_ = true;
            }
            let _e89 = phi_232_;
            let _e91 = phi_233_;
            phi_234_ = _e89;
            phi_235_ = _e91;
        } else {
            phi_234_ = bool();
            phi_235_ = true;
        }
        let _e93 = phi_234_;
        let _e95 = phi_235_;
        if _e95 {
            phi_239_ = false;
        } else {
            phi_239_ = _e93;
        }
        let _e97 = phi_239_;
        if !(_e97) {
            let _e100 = samples.member[(0u + _e62.first_primitive)].normal;
            let _e102 = samples.member[(0u + _e62.first_primitive)].position;
            if ((((_e100.x * (_e71.x - (_e102.x * _e71.w))) + (_e100.y * (_e71.y - (_e102.y * _e71.w)))) + (_e100.z * (_e71.z - (_e102.z * _e71.w)))) > 0f) {
                let _e126 = samples.member[(0u + _e62.first_primitive)].flags;
                let _e134 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e134.unnamed.visibility, false), _e134.unnamed_1);
                phi_283_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e140.unnamed, ((_e126 & 1u) == 0u));
            } else {
                let _e149 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e149.unnamed.visibility, false), _e149.unnamed_1);
                phi_283_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e155.unnamed, true);
            }
            let _e160 = phi_283_;
            phi_287_ = _e160;
        } else {
            let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e166.unnamed.visibility, false), _e166.unnamed_1);
            phi_287_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e172.unnamed, true);
        }
        let _e177 = phi_287_;
        if _e177.unnamed_1 {
            phi_645_ = evaluate_Verdict(_e177.unnamed.visibility, _e177.unnamed.is_doubted);
            phi_646_ = evaluate_Verdict();
            phi_647_ = true;
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
                    phi_364_ = (_e216 <= 1f);
                } else {
                    phi_364_ = false;
                }
                let _e248 = phi_364_;
                if _e248 {
                    if (_e230 >= 0f) {
                        phi_373_ = (_e230 <= 1f);
                    } else {
                        phi_373_ = false;
                    }
                    let _e252 = phi_373_;
                    if _e252 {
                        if (_e243 >= 0f) {
                            phi_382_ = (_e243 <= 1f);
                        } else {
                            phi_382_ = false;
                        }
                        let _e256 = phi_382_;
                        phi_383_ = _e256;
                        phi_384_ = false;
                    } else {
                        phi_383_ = bool();
                        phi_384_ = true;
                    }
                    let _e258 = phi_383_;
                    let _e260 = phi_384_;
                    phi_385_ = _e258;
                    phi_386_ = _e260;
                } else {
                    phi_385_ = bool();
                    phi_386_ = true;
                }
                let _e262 = phi_385_;
                let _e264 = phi_386_;
                phi_387_ = _e262;
                phi_388_ = _e264;
            } else {
                phi_387_ = bool();
                phi_388_ = true;
            }
            let _e266 = phi_387_;
            let _e268 = phi_388_;
            if _e268 {
                phi_392_ = false;
            } else {
                phi_392_ = _e266;
            }
            let _e270 = phi_392_;
            if _e270 {
                let _e272 = p.member.map_size;
                let _e273 = f32(_e272);
                let _e276 = ((_e216 * _e273) - 0.5f);
                let _e277 = ((_e230 * _e273) - 0.5f);
                if (_e276 > -8388608f) {
                    let _e289 = f32(select(0i, select(select(i32(_e276), i32(-2147483648), (_e276 < bitcast<f32>(3472883712u))), 2147483647i, (_e276 > bitcast<f32>(1325400063u))), (_e276 == _e276)));
                    if (_e289 > _e276) {
                        phi_428_ = 1f;
                    } else {
                        phi_428_ = 0f;
                    }
                    let _e292 = phi_428_;
                    if (_e276 < 8388608f) {
                        phi_433_ = (_e289 - _e292);
                        phi_434_ = false;
                    } else {
                        phi_433_ = f32();
                        phi_434_ = true;
                    }
                    let _e295 = phi_433_;
                    let _e297 = phi_434_;
                    phi_435_ = _e295;
                    phi_436_ = _e297;
                } else {
                    phi_435_ = f32();
                    phi_436_ = true;
                }
                let _e299 = phi_435_;
                let _e301 = phi_436_;
                if _e301 {
                    phi_440_ = _e276;
                } else {
                    phi_440_ = _e299;
                }
                let _e303 = phi_440_;
                if (_e277 > -8388608f) {
                    let _e315 = f32(select(0i, select(select(i32(_e277), i32(-2147483648), (_e277 < bitcast<f32>(3472883712u))), 2147483647i, (_e277 > bitcast<f32>(1325400063u))), (_e277 == _e277)));
                    if (_e315 > _e277) {
                        phi_460_ = 1f;
                    } else {
                        phi_460_ = 0f;
                    }
                    let _e318 = phi_460_;
                    if (_e277 < 8388608f) {
                        phi_465_ = (_e315 - _e318);
                        phi_466_ = false;
                    } else {
                        phi_465_ = f32();
                        phi_466_ = true;
                    }
                    let _e321 = phi_465_;
                    let _e323 = phi_466_;
                    phi_467_ = _e321;
                    phi_468_ = _e323;
                } else {
                    phi_467_ = f32();
                    phi_468_ = true;
                }
                let _e325 = phi_467_;
                let _e327 = phi_468_;
                if _e327 {
                    phi_472_ = _e277;
                } else {
                    phi_472_ = _e325;
                }
                let _e329 = phi_472_;
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
                    phi_518_ = _e340;
                } else {
                    phi_518_ = 0i;
                }
                let _e367 = phi_518_;
                if (_e349 > 0i) {
                    phi_523_ = _e349;
                } else {
                    phi_523_ = 0i;
                }
                let _e370 = phi_523_;
                if (_e367 < _e364) {
                    phi_528_ = _e367;
                } else {
                    phi_528_ = _e364;
                }
                let _e373 = phi_528_;
                if (_e370 < _e364) {
                    phi_533_ = _e370;
                } else {
                    phi_533_ = _e364;
                }
                let _e376 = phi_533_;
                let _e377 = bitcast<u32>(_e373);
                let _e379 = (_e340 + 1i);
                let _e380 = (_e349 + 1i);
                if (_e379 > 0i) {
                    phi_542_ = _e379;
                } else {
                    phi_542_ = 0i;
                }
                let _e383 = phi_542_;
                if (_e380 > 0i) {
                    phi_547_ = _e380;
                } else {
                    phi_547_ = 0i;
                }
                let _e386 = phi_547_;
                if (_e383 < _e364) {
                    phi_552_ = _e383;
                } else {
                    phi_552_ = _e364;
                }
                let _e389 = phi_552_;
                if (_e386 < _e364) {
                    phi_557_ = _e386;
                } else {
                    phi_557_ = _e364;
                }
                let _e392 = phi_557_;
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
                phi_642_ = evaluate_Verdict(_e462, false);
                phi_643_ = evaluate_Verdict();
                phi_644_ = false;
            } else {
                phi_642_ = evaluate_Verdict();
                phi_643_ = evaluate_Verdict(1f, false);
                phi_644_ = true;
            }
            let _e466 = phi_642_;
            let _e468 = phi_643_;
            let _e470 = phi_644_;
            phi_645_ = _e468;
            phi_646_ = _e466;
            phi_647_ = _e470;
        }
        let _e472 = phi_645_;
        let _e474 = phi_646_;
        let _e476 = phi_647_;
        if _e476 {
            phi_651_ = _e472;
        } else {
            phi_651_ = _e474;
        }
        let _e478 = phi_651_;
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
