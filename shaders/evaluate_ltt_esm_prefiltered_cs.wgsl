struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_10 {
    member: array<abi_Sample>,
}

struct type_14 {
    member: array<u32>,
}

struct type_18 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct type_37 {
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

struct type_41 {
    member: abi_ShadowParams,
}

struct type_48 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_41;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_48;
@group(0) @binding(2) 
var<storage> map: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_161_: lt_bvh_traverse_Tree;
    var phi_162_: bool;
    var phi_167_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_159_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_160_ = false;
        } else {
            phi_159_ = lt_bvh_traverse_Tree();
            phi_160_ = true;
        }
        let _e63 = phi_159_;
        let _e65 = phi_160_;
        phi_161_ = _e63;
        phi_162_ = _e65;
    } else {
        phi_161_ = lt_bvh_traverse_Tree();
        phi_162_ = true;
    }
    let _e67 = phi_161_;
    let _e69 = phi_162_;
    if _e69 {
        phi_167_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_167_ = _e67;
    }
    let _e74 = phi_167_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_187_: bool;
    var phi_191_: f32;

    let _e51 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_187_ = true;
    } else {
        let _e55 = (84f < _e51);
        if _e55 {
        }
        phi_187_ = _e55;
    }
    let _e57 = phi_187_;
    if _e57 {
        phi_191_ = 84f;
    } else {
        phi_191_ = _e51;
    }
    let _e59 = phi_191_;
    return _e59;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_227_: f32;
    var phi_232_: f32;
    var phi_254_: f32;
    var phi_259_: f32;
    var phi_260_: bool;
    var phi_261_: f32;
    var phi_262_: bool;
    var phi_266_: f32;
    var phi_304_: f32;
    var phi_320_: f32;
    var phi_321_: f32;
    var phi_322_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_212_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_211_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_210_ = 1f;
            } else {
                phi_210_ = param_7;
            }
            let _e59 = phi_210_;
            phi_211_ = _e59;
        }
        let _e61 = phi_211_;
        phi_212_ = _e61;
    }
    let _e63 = phi_212_;
    let _e65 = _lt_math_esm_Esm_clamped_exponent(param_5);
    let _e67 = (_e65 * (1f - _e63));
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_304_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_227_ = -87f;
        } else {
            phi_227_ = _e67;
        }
        let _e73 = phi_227_;
        if (_e73 > 88f) {
            phi_232_ = 88f;
        } else {
            phi_232_ = _e73;
        }
        let _e76 = phi_232_;
        let _e78 = ((_e76 * 1.442695f) + 0.5f);
        if (_e78 > -8388608f) {
            let _e90 = f32(select(0i, select(select(i32(_e78), i32(-2147483648), (_e78 < bitcast<f32>(3472883712u))), 2147483647i, (_e78 > bitcast<f32>(1325400063u))), (_e78 == _e78)));
            if (_e90 > _e78) {
                phi_254_ = 1f;
            } else {
                phi_254_ = 0f;
            }
            let _e93 = phi_254_;
            if (_e78 < 8388608f) {
                phi_259_ = (_e90 - _e93);
                phi_260_ = false;
            } else {
                phi_259_ = f32();
                phi_260_ = true;
            }
            let _e96 = phi_259_;
            let _e98 = phi_260_;
            phi_261_ = _e96;
            phi_262_ = _e98;
        } else {
            phi_261_ = f32();
            phi_262_ = true;
        }
        let _e100 = phi_261_;
        let _e102 = phi_262_;
        if _e102 {
            phi_266_ = _e78;
        } else {
            phi_266_ = _e100;
        }
        let _e104 = phi_266_;
        let _e108 = ((_e76 - (_e104 * 0.69314575f)) - (_e104 * 0.0000014286068f));
        phi_304_ = ((((((((((((((((1f / 5040f) * _e108) + (1f / 720f)) * _e108) + (1f / 120f)) * _e108) + (1f / 24f)) * _e108) + (1f / 6f)) * _e108) + 0.5f) * _e108) + 1f) * _e108) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e104), i32(-2147483648), (_e104 < bitcast<f32>(3472883712u))), 2147483647i, (_e104 > bitcast<f32>(1325400063u))), (_e104 == _e104)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e144 = phi_304_;
    let _e145 = (param_6.x * _e144);
    if ((bitcast<u32>(_e145) & 2147483647u) > 2139095040u) {
        phi_322_ = _e145;
    } else {
        if (_e145 < 0f) {
            phi_321_ = 0f;
        } else {
            if (_e145 > 1f) {
                phi_320_ = 1f;
            } else {
                phi_320_ = _e145;
            }
            let _e152 = phi_320_;
            phi_321_ = _e152;
        }
        let _e154 = phi_321_;
        phi_322_ = _e154;
    }
    let _e156 = phi_322_;
    return _e156;
}

fn function_() {
    var local_1: f32;
    var phi_371_: bool;
    var phi_372_: bool;
    var phi_373_: bool;
    var phi_374_: bool;
    var phi_378_: bool;
    var phi_422_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_426_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_503_: bool;
    var phi_512_: bool;
    var phi_521_: bool;
    var phi_522_: bool;
    var phi_523_: bool;
    var phi_524_: bool;
    var phi_525_: bool;
    var phi_526_: bool;
    var phi_527_: bool;
    var phi_531_: bool;
    var phi_625_: f32;
    var phi_628_: f32;
    var phi_657_: f32;
    var phi_662_: f32;
    var phi_663_: bool;
    var phi_664_: f32;
    var phi_665_: bool;
    var phi_669_: f32;
    var phi_689_: f32;
    var phi_694_: f32;
    var phi_695_: bool;
    var phi_696_: f32;
    var phi_697_: bool;
    var phi_701_: f32;
    var phi_747_: i32;
    var phi_752_: i32;
    var phi_757_: i32;
    var phi_762_: i32;
    var phi_771_: i32;
    var phi_776_: i32;
    var phi_781_: i32;
    var phi_786_: i32;
    var phi_877_: bool;
    var phi_885_: bool;
    var phi_897_: bool;
    var phi_898_: bool;
    var phi_902_: f32;
    var phi_908_: f32;
    var phi_910_: evaluate_Verdict;
    var phi_915_: evaluate_Verdict;
    var phi_916_: evaluate_Verdict;
    var phi_920_: bool;
    var phi_921_: u32;
    var phi_932_: u32;

    let _e51 = id_1;
    let _e52 = local_2;
    let _e57 = arrayLength((&map.member));
    let _e62 = p.member.size[0u];
    let _e64 = p.member.size[1u];
    let _e65 = lt_shaders_entry_pixel_index(_e51, _e62, _e64);
    if (bitcast<i32>(_e65.root) != 0i) {
        let _e72 = p.member.light;
        let _e75 = samples.member[_e65.first_primitive].normal[0u];
        let _e77 = global[0u];
        if (_e75 == _e77) {
            let _e80 = samples.member[_e65.first_primitive].normal[1u];
            let _e82 = global[1u];
            if (_e80 == _e82) {
                let _e85 = samples.member[_e65.first_primitive].normal[2u];
                let _e87 = global[2u];
                phi_371_ = (_e85 == _e87);
                phi_372_ = false;
            } else {
                phi_371_ = bool();
                phi_372_ = true;
            }
            let _e90 = phi_371_;
            let _e92 = phi_372_;
            phi_373_ = _e90;
            phi_374_ = _e92;
        } else {
            phi_373_ = bool();
            phi_374_ = true;
        }
        let _e94 = phi_373_;
        let _e96 = phi_374_;
        if _e96 {
            phi_378_ = false;
        } else {
            phi_378_ = _e94;
        }
        let _e98 = phi_378_;
        if !(_e98) {
            let _e101 = samples.member[_e65.first_primitive].normal;
            let _e103 = samples.member[_e65.first_primitive].position;
            if ((((_e101.x * (_e72.x - (_e103.x * _e72.w))) + (_e101.y * (_e72.y - (_e103.y * _e72.w)))) + (_e101.z * (_e72.z - (_e103.z * _e72.w)))) > 0f) {
                let _e127 = samples.member[_e65.first_primitive].flags;
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e135.unnamed.visibility, false), _e135.unnamed_1);
                phi_422_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e141.unnamed, ((_e127 & 1u) == 0u));
            } else {
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e150.unnamed.visibility, false), _e150.unnamed_1);
                phi_422_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e156.unnamed, true);
            }
            let _e161 = phi_422_;
            phi_426_ = _e161;
        } else {
            let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
            phi_426_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, true);
        }
        let _e178 = phi_426_;
        if _e178.unnamed_1 {
            phi_916_ = evaluate_Verdict(_e178.unnamed.visibility, _e178.unnamed.is_doubted);
        } else {
            let _e186 = samples.member[_e65.first_primitive].position;
            let _e192 = p.member.projection.row_w;
            let _e203 = ((((_e192.x * _e186.x) + (_e192.y * _e186.y)) + (_e192.z * _e186.z)) + (_e192.w * 1f));
            let _e205 = p.member.projection.row_x;
            let _e217 = (((((_e205.x * _e186.x) + (_e205.y * _e186.y)) + (_e205.z * _e186.z)) + (_e205.w * 1f)) / _e203);
            let _e219 = p.member.projection.row_y;
            let _e231 = (((((_e219.x * _e186.x) + (_e219.y * _e186.y)) + (_e219.z * _e186.z)) + (_e219.w * 1f)) / _e203);
            let _e233 = p.member.projection.row_z;
            let _e244 = ((((_e233.x * _e186.x) + (_e233.y * _e186.y)) + (_e233.z * _e186.z)) + (_e233.w * 1f));
            if (_e203 > 0f) {
                if (_e217 >= 0f) {
                    phi_503_ = (_e217 <= 1f);
                } else {
                    phi_503_ = false;
                }
                let _e249 = phi_503_;
                if _e249 {
                    if (_e231 >= 0f) {
                        phi_512_ = (_e231 <= 1f);
                    } else {
                        phi_512_ = false;
                    }
                    let _e253 = phi_512_;
                    if _e253 {
                        if (_e244 >= 0f) {
                            phi_521_ = (_e244 <= 1f);
                        } else {
                            phi_521_ = false;
                        }
                        let _e257 = phi_521_;
                        phi_522_ = _e257;
                        phi_523_ = false;
                    } else {
                        phi_522_ = bool();
                        phi_523_ = true;
                    }
                    let _e259 = phi_522_;
                    let _e261 = phi_523_;
                    phi_524_ = _e259;
                    phi_525_ = _e261;
                } else {
                    phi_524_ = bool();
                    phi_525_ = true;
                }
                let _e263 = phi_524_;
                let _e265 = phi_525_;
                phi_526_ = _e263;
                phi_527_ = _e265;
            } else {
                phi_526_ = bool();
                phi_527_ = true;
            }
            let _e267 = phi_526_;
            let _e269 = phi_527_;
            if _e269 {
                phi_531_ = false;
            } else {
                phi_531_ = _e267;
            }
            let _e271 = phi_531_;
            if _e271 {
                if (0f > 0f) {
                    let _e274 = samples.member[_e65.first_primitive].normal;
                    let _e276 = p.member.map_size;
                    let _e279 = p.member.projection.row_x;
                    let _e301 = p.member.projection.row_y;
                    let _e323 = p.member.projection.row_z;
                    let _e350 = ((abs(((((_e279.x * _e274.x) + (_e279.y * _e274.y)) + (_e279.z * _e274.z)) / (((_e279.x * _e279.x) + (_e279.y * _e279.y)) + (_e279.z * _e279.z)))) + abs(((((_e301.x * _e274.x) + (_e301.y * _e274.y)) + (_e301.z * _e274.z)) / (((_e301.x * _e301.x) + (_e301.y * _e301.y)) + (_e301.z * _e301.z))))) / (abs(((((_e323.x * _e274.x) + (_e323.y * _e274.y)) + (_e323.z * _e274.z)) / (((_e323.x * _e323.x) + (_e323.y * _e323.y)) + (_e323.z * _e323.z)))) * f32(_e276)));
                    if (_e350 < 0.002f) {
                        phi_625_ = _e350;
                    } else {
                        phi_625_ = 0.002f;
                    }
                    let _e353 = phi_625_;
                    phi_628_ = (_e244 - (0f * _e353));
                } else {
                    phi_628_ = _e244;
                }
                let _e357 = phi_628_;
                let _e359 = p.member.map_size;
                let _e360 = f32(_e359);
                let _e363 = ((_e217 * _e360) - 0.5f);
                let _e364 = ((_e231 * _e360) - 0.5f);
                if (_e363 > -8388608f) {
                    let _e376 = f32(select(0i, select(select(i32(_e363), i32(-2147483648), (_e363 < bitcast<f32>(3472883712u))), 2147483647i, (_e363 > bitcast<f32>(1325400063u))), (_e363 == _e363)));
                    if (_e376 > _e363) {
                        phi_657_ = 1f;
                    } else {
                        phi_657_ = 0f;
                    }
                    let _e379 = phi_657_;
                    if (_e363 < 8388608f) {
                        phi_662_ = (_e376 - _e379);
                        phi_663_ = false;
                    } else {
                        phi_662_ = f32();
                        phi_663_ = true;
                    }
                    let _e382 = phi_662_;
                    let _e384 = phi_663_;
                    phi_664_ = _e382;
                    phi_665_ = _e384;
                } else {
                    phi_664_ = f32();
                    phi_665_ = true;
                }
                let _e386 = phi_664_;
                let _e388 = phi_665_;
                if _e388 {
                    phi_669_ = _e363;
                } else {
                    phi_669_ = _e386;
                }
                let _e390 = phi_669_;
                if (_e364 > -8388608f) {
                    let _e402 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e402 > _e364) {
                        phi_689_ = 1f;
                    } else {
                        phi_689_ = 0f;
                    }
                    let _e405 = phi_689_;
                    if (_e364 < 8388608f) {
                        phi_694_ = (_e402 - _e405);
                        phi_695_ = false;
                    } else {
                        phi_694_ = f32();
                        phi_695_ = true;
                    }
                    let _e408 = phi_694_;
                    let _e410 = phi_695_;
                    phi_696_ = _e408;
                    phi_697_ = _e410;
                } else {
                    phi_696_ = f32();
                    phi_697_ = true;
                }
                let _e412 = phi_696_;
                let _e414 = phi_697_;
                if _e414 {
                    phi_701_ = _e364;
                } else {
                    phi_701_ = _e412;
                }
                let _e416 = phi_701_;
                let _e417 = (_e363 - _e390);
                let _e418 = (_e364 - _e416);
                let _e427 = select(0i, select(select(i32(_e390), i32(-2147483648), (_e390 < bitcast<f32>(3472883712u))), 2147483647i, (_e390 > bitcast<f32>(1325400063u))), (_e390 == _e390));
                let _e436 = select(0i, select(select(i32(_e416), i32(-2147483648), (_e416 < bitcast<f32>(3472883712u))), 2147483647i, (_e416 > bitcast<f32>(1325400063u))), (_e416 == _e416));
                let _e439 = ((1f - _e417) * (1f - _e418));
                let _e441 = (_e417 * (1f - _e418));
                let _e443 = ((1f - _e417) * _e418);
                let _e444 = (_e417 * _e418);
                let _e446 = p.member.test;
                let _e447 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e446);
                let _e449 = p.member.map_size;
                local_1 = _e447;
                let _e451 = (bitcast<i32>(_e449) - 1i);
                if (_e427 > 0i) {
                    phi_747_ = _e427;
                } else {
                    phi_747_ = 0i;
                }
                let _e454 = phi_747_;
                if (_e436 > 0i) {
                    phi_752_ = _e436;
                } else {
                    phi_752_ = 0i;
                }
                let _e457 = phi_752_;
                if (_e454 < _e451) {
                    phi_757_ = _e454;
                } else {
                    phi_757_ = _e451;
                }
                let _e460 = phi_757_;
                if (_e457 < _e451) {
                    phi_762_ = _e457;
                } else {
                    phi_762_ = _e451;
                }
                let _e463 = phi_762_;
                let _e464 = bitcast<u32>(_e460);
                let _e466 = (_e427 + 1i);
                let _e467 = (_e436 + 1i);
                if (_e466 > 0i) {
                    phi_771_ = _e466;
                } else {
                    phi_771_ = 0i;
                }
                let _e470 = phi_771_;
                if (_e467 > 0i) {
                    phi_776_ = _e467;
                } else {
                    phi_776_ = 0i;
                }
                let _e473 = phi_776_;
                if (_e470 < _e451) {
                    phi_781_ = _e470;
                } else {
                    phi_781_ = _e451;
                }
                let _e476 = phi_781_;
                if (_e473 < _e451) {
                    phi_786_ = _e473;
                } else {
                    phi_786_ = _e451;
                }
                let _e479 = phi_786_;
                let _e480 = bitcast<u32>(_e476);
                let _e482 = (bitcast<u32>(_e463) * _e449);
                let _e483 = (bitcast<u32>(_e479) * _e449);
                let _e484 = (_e482 + _e464);
                let _e485 = (_e482 + _e480);
                let _e486 = (_e483 + _e464);
                let _e487 = (_e483 + _e480);
                if (_e484 < _e57) {
                } else {
                    return;
                }
                let _e491 = map.member[(0u + _e484)];
                if (_e485 < _e57) {
                } else {
                    return;
                }
                let _e503 = map.member[(0u + _e485)];
                if (_e486 < _e57) {
                } else {
                    return;
                }
                let _e519 = map.member[(0u + _e486)];
                if (_e487 < _e57) {
                } else {
                    return;
                }
                let _e535 = map.member[(0u + _e487)];
                let _e549 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e491.x * _e439) + (_e503.x * _e441)) + (_e519.x * _e443)) + (_e535.x * _e444)), ((((_e491.y * _e439) + (_e503.y * _e441)) + (_e519.y * _e443)) + (_e535.y * _e444)), ((((_e491.z * _e439) + (_e503.z * _e441)) + (_e519.z * _e443)) + (_e535.z * _e444)), ((((_e491.w * _e439) + (_e503.w * _e441)) + (_e519.w * _e443)) + (_e535.w * _e444))), _e357);
                let _e551 = p.member.epsilon;
                if (_e549 <= _e551) {
                    phi_877_ = true;
                } else {
                    phi_877_ = (_e549 >= (1f - _e551));
                }
                let _e556 = phi_877_;
                if ((bitcast<u32>(_e549) & 2147483647u) > 2139095040u) {
                    phi_885_ = true;
                } else {
                    phi_885_ = !(_e556);
                }
                let _e562 = phi_885_;
                if _e562 {
                    if (_e549 > 0f) {
                        if (_e549 < 1f) {
                            phi_897_ = false;
                        } else {
                            phi_897_ = true;
                        }
                        let _e566 = phi_897_;
                        phi_898_ = _e566;
                    } else {
                        phi_898_ = true;
                    }
                    let _e568 = phi_898_;
                    if _e568 {
                        phi_902_ = 0.5f;
                    } else {
                        phi_902_ = _e549;
                    }
                    let _e570 = phi_902_;
                    phi_910_ = evaluate_Verdict(_e570, true);
                } else {
                    if (_e549 > 0.5f) {
                        phi_908_ = 1f;
                    } else {
                        phi_908_ = 0f;
                    }
                    let _e574 = phi_908_;
                    phi_910_ = evaluate_Verdict(_e574, false);
                }
                let _e577 = phi_910_;
                phi_915_ = evaluate_Verdict(_e577.visibility, _e577.is_doubted);
            } else {
                phi_915_ = evaluate_Verdict(0.5f, true);
            }
            let _e583 = phi_915_;
            phi_916_ = _e583;
        }
        let _e585 = phi_916_;
        visibility.member[_e65.first_primitive] = _e585.visibility;
        phi_920_ = _e585.is_doubted;
        phi_921_ = _e65.first_primitive;
    } else {
        phi_920_ = false;
        phi_921_ = 0u;
    }
    let _e590 = phi_920_;
    let _e592 = phi_921_;
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e590 {
        let _e596 = atomicAdd((&shared_[0u]), 1u);
        phi_932_ = _e596;
    } else {
        phi_932_ = 0u;
    }
    let _e598 = phi_932_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e602 = atomicLoad((&shared_[0u]));
        let _e603 = atomicAdd((&list.member[3u]), _e602);
        atomicStore((&shared_[1u]), _e603);
    }
    workgroupBarrier();
    if _e590 {
        let _e606 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e606) + _e598)]), _e592);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
