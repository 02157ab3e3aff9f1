struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct type_8 {
    member: array<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_23 {
    member: array<abi_Sample>,
}

struct type_27 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_36 {
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

struct type_40 {
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

struct type_47 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_23;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_40;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_27;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_47;
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(2) 
var<storage> map: type_36;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_158_: lt_bvh_traverse_Tree;
    var phi_159_: bool;
    var phi_160_: lt_bvh_traverse_Tree;
    var phi_161_: bool;
    var phi_166_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_158_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_159_ = false;
        } else {
            phi_158_ = lt_bvh_traverse_Tree();
            phi_159_ = true;
        }
        let _e63 = phi_158_;
        let _e65 = phi_159_;
        phi_160_ = _e63;
        phi_161_ = _e65;
    } else {
        phi_160_ = lt_bvh_traverse_Tree();
        phi_161_ = true;
    }
    let _e67 = phi_160_;
    let _e69 = phi_161_;
    if _e69 {
        phi_166_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_166_ = _e67;
    }
    let _e74 = phi_166_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_186_: bool;
    var phi_190_: f32;

    let _e51 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_186_ = true;
    } else {
        let _e55 = (84f < _e51);
        if _e55 {
        }
        phi_186_ = _e55;
    }
    let _e57 = phi_186_;
    if _e57 {
        phi_190_ = 84f;
    } else {
        phi_190_ = _e51;
    }
    let _e59 = phi_190_;
    return _e59;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_209_: f32;
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_226_: f32;
    var phi_231_: f32;
    var phi_253_: f32;
    var phi_258_: f32;
    var phi_259_: bool;
    var phi_260_: f32;
    var phi_261_: bool;
    var phi_265_: f32;
    var phi_303_: f32;
    var phi_319_: f32;
    var phi_320_: f32;
    var phi_321_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_211_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_210_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_209_ = 1f;
            } else {
                phi_209_ = param_7;
            }
            let _e59 = phi_209_;
            phi_210_ = _e59;
        }
        let _e61 = phi_210_;
        phi_211_ = _e61;
    }
    let _e63 = phi_211_;
    let _e65 = _lt_math_esm_Esm_clamped_exponent(param_5);
    let _e67 = (_e65 * (1f - _e63));
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_303_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_226_ = -87f;
        } else {
            phi_226_ = _e67;
        }
        let _e73 = phi_226_;
        if (_e73 > 88f) {
            phi_231_ = 88f;
        } else {
            phi_231_ = _e73;
        }
        let _e76 = phi_231_;
        let _e78 = ((_e76 * 1.442695f) + 0.5f);
        if (_e78 > -8388608f) {
            let _e90 = f32(select(0i, select(select(i32(_e78), i32(-2147483648), (_e78 < bitcast<f32>(3472883712u))), 2147483647i, (_e78 > bitcast<f32>(1325400063u))), (_e78 == _e78)));
            if (_e90 > _e78) {
                phi_253_ = 1f;
            } else {
                phi_253_ = 0f;
            }
            let _e93 = phi_253_;
            if (_e78 < 8388608f) {
                phi_258_ = (_e90 - _e93);
                phi_259_ = false;
            } else {
                phi_258_ = f32();
                phi_259_ = true;
            }
            let _e96 = phi_258_;
            let _e98 = phi_259_;
            phi_260_ = _e96;
            phi_261_ = _e98;
        } else {
            phi_260_ = f32();
            phi_261_ = true;
        }
        let _e100 = phi_260_;
        let _e102 = phi_261_;
        if _e102 {
            phi_265_ = _e78;
        } else {
            phi_265_ = _e100;
        }
        let _e104 = phi_265_;
        let _e108 = ((_e76 - (_e104 * 0.69314575f)) - (_e104 * 0.0000014286068f));
        phi_303_ = ((((((((((((((((1f / 5040f) * _e108) + (1f / 720f)) * _e108) + (1f / 120f)) * _e108) + (1f / 24f)) * _e108) + (1f / 6f)) * _e108) + 0.5f) * _e108) + 1f) * _e108) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e104), i32(-2147483648), (_e104 < bitcast<f32>(3472883712u))), 2147483647i, (_e104 > bitcast<f32>(1325400063u))), (_e104 == _e104)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e144 = phi_303_;
    let _e145 = (param_6.x * _e144);
    if ((bitcast<u32>(_e145) & 2147483647u) > 2139095040u) {
        phi_321_ = _e145;
    } else {
        if (_e145 < 0f) {
            phi_320_ = 0f;
        } else {
            if (_e145 > 1f) {
                phi_319_ = 1f;
            } else {
                phi_319_ = _e145;
            }
            let _e152 = phi_319_;
            phi_320_ = _e152;
        }
        let _e154 = phi_320_;
        phi_321_ = _e154;
    }
    let _e156 = phi_321_;
    return _e156;
}

fn function_() {
    var local_1: f32;
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_377_: bool;
    var phi_378_: bool;
    var phi_382_: bool;
    var phi_426_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_430_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_507_: bool;
    var phi_516_: bool;
    var phi_525_: bool;
    var phi_526_: bool;
    var phi_527_: bool;
    var phi_528_: bool;
    var phi_529_: bool;
    var phi_530_: bool;
    var phi_531_: bool;
    var phi_535_: bool;
    var phi_629_: f32;
    var phi_632_: f32;
    var phi_661_: f32;
    var phi_666_: f32;
    var phi_667_: bool;
    var phi_668_: f32;
    var phi_669_: bool;
    var phi_673_: f32;
    var phi_693_: f32;
    var phi_698_: f32;
    var phi_699_: bool;
    var phi_700_: f32;
    var phi_701_: bool;
    var phi_705_: f32;
    var phi_751_: i32;
    var phi_756_: i32;
    var phi_761_: i32;
    var phi_766_: i32;
    var phi_775_: i32;
    var phi_780_: i32;
    var phi_785_: i32;
    var phi_790_: i32;
    var phi_881_: bool;
    var phi_889_: bool;
    var phi_894_: f32;
    var phi_897_: evaluate_Verdict;
    var phi_898_: evaluate_Verdict;
    var phi_902_: bool;
    var phi_903_: u32;
    var phi_909_: u32;

    let _e51 = id_1;
    let _e52 = local_2;
    let _e57 = arrayLength((&map.member));
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e64 = p.member.size[0u];
    let _e66 = p.member.size[1u];
    let _e67 = lt_shaders_entry_pixel_index(_e51, _e64, _e66);
    if (bitcast<i32>(_e67.root) != 0i) {
        let _e74 = p.member.light;
        let _e77 = samples.member[_e67.first_primitive].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[_e67.first_primitive].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[_e67.first_primitive].normal[2u];
                let _e89 = global[2u];
                phi_375_ = (_e87 == _e89);
                phi_376_ = false;
            } else {
                phi_375_ = bool();
                phi_376_ = true;
            }
            let _e92 = phi_375_;
            let _e94 = phi_376_;
            phi_377_ = _e92;
            phi_378_ = _e94;
        } else {
            phi_377_ = bool();
            phi_378_ = true;
        }
        let _e96 = phi_377_;
        let _e98 = phi_378_;
        if _e98 {
            phi_382_ = false;
        } else {
            phi_382_ = _e96;
        }
        let _e100 = phi_382_;
        if !(_e100) {
            let _e103 = samples.member[_e67.first_primitive].normal;
            let _e105 = samples.member[_e67.first_primitive].position;
            if ((((_e103.x * (_e74.x - (_e105.x * _e74.w))) + (_e103.y * (_e74.y - (_e105.y * _e74.w)))) + (_e103.z * (_e74.z - (_e105.z * _e74.w)))) > 0f) {
                let _e129 = samples.member[_e67.first_primitive].flags;
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_426_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, ((_e129 & 1u) == 0u));
            } else {
                let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e152.unnamed.visibility, false), _e152.unnamed_1);
                phi_426_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e158.unnamed, true);
            }
            let _e163 = phi_426_;
            phi_430_ = _e163;
        } else {
            let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e169.unnamed.visibility, false), _e169.unnamed_1);
            phi_430_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e175.unnamed, true);
        }
        let _e180 = phi_430_;
        if _e180.unnamed_1 {
            phi_898_ = evaluate_Verdict(_e180.unnamed.visibility, _e180.unnamed.is_doubted);
        } else {
            let _e188 = samples.member[_e67.first_primitive].position;
            let _e194 = p.member.projection.row_w;
            let _e205 = ((((_e194.x * _e188.x) + (_e194.y * _e188.y)) + (_e194.z * _e188.z)) + (_e194.w * 1f));
            let _e207 = p.member.projection.row_x;
            let _e219 = (((((_e207.x * _e188.x) + (_e207.y * _e188.y)) + (_e207.z * _e188.z)) + (_e207.w * 1f)) / _e205);
            let _e221 = p.member.projection.row_y;
            let _e233 = (((((_e221.x * _e188.x) + (_e221.y * _e188.y)) + (_e221.z * _e188.z)) + (_e221.w * 1f)) / _e205);
            let _e235 = p.member.projection.row_z;
            let _e246 = ((((_e235.x * _e188.x) + (_e235.y * _e188.y)) + (_e235.z * _e188.z)) + (_e235.w * 1f));
            if (_e205 > 0f) {
                if (_e219 >= 0f) {
                    phi_507_ = (_e219 <= 1f);
                } else {
                    phi_507_ = false;
                }
                let _e251 = phi_507_;
                if _e251 {
                    if (_e233 >= 0f) {
                        phi_516_ = (_e233 <= 1f);
                    } else {
                        phi_516_ = false;
                    }
                    let _e255 = phi_516_;
                    if _e255 {
                        if (_e246 >= 0f) {
                            phi_525_ = (_e246 <= 1f);
                        } else {
                            phi_525_ = false;
                        }
                        let _e259 = phi_525_;
                        phi_526_ = _e259;
                        phi_527_ = false;
                    } else {
                        phi_526_ = bool();
                        phi_527_ = true;
                    }
                    let _e261 = phi_526_;
                    let _e263 = phi_527_;
                    phi_528_ = _e261;
                    phi_529_ = _e263;
                } else {
                    phi_528_ = bool();
                    phi_529_ = true;
                }
                let _e265 = phi_528_;
                let _e267 = phi_529_;
                phi_530_ = _e265;
                phi_531_ = _e267;
            } else {
                phi_530_ = bool();
                phi_531_ = true;
            }
            let _e269 = phi_530_;
            let _e271 = phi_531_;
            if _e271 {
                phi_535_ = false;
            } else {
                phi_535_ = _e269;
            }
            let _e273 = phi_535_;
            if _e273 {
                if (0f > 0f) {
                    let _e276 = samples.member[_e67.first_primitive].normal;
                    let _e278 = p.member.map_size;
                    let _e281 = p.member.projection.row_x;
                    let _e303 = p.member.projection.row_y;
                    let _e325 = p.member.projection.row_z;
                    let _e352 = ((abs(((((_e281.x * _e276.x) + (_e281.y * _e276.y)) + (_e281.z * _e276.z)) / (((_e281.x * _e281.x) + (_e281.y * _e281.y)) + (_e281.z * _e281.z)))) + abs(((((_e303.x * _e276.x) + (_e303.y * _e276.y)) + (_e303.z * _e276.z)) / (((_e303.x * _e303.x) + (_e303.y * _e303.y)) + (_e303.z * _e303.z))))) / (abs(((((_e325.x * _e276.x) + (_e325.y * _e276.y)) + (_e325.z * _e276.z)) / (((_e325.x * _e325.x) + (_e325.y * _e325.y)) + (_e325.z * _e325.z)))) * f32(_e278)));
                    if (_e352 < 0.002f) {
                        phi_629_ = _e352;
                    } else {
                        phi_629_ = 0.002f;
                    }
                    let _e355 = phi_629_;
                    phi_632_ = (_e246 - (0f * _e355));
                } else {
                    phi_632_ = _e246;
                }
                let _e359 = phi_632_;
                let _e361 = p.member.map_size;
                let _e362 = f32(_e361);
                let _e365 = ((_e219 * _e362) - 0.5f);
                let _e366 = ((_e233 * _e362) - 0.5f);
                if (_e365 > -8388608f) {
                    let _e378 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e378 > _e365) {
                        phi_661_ = 1f;
                    } else {
                        phi_661_ = 0f;
                    }
                    let _e381 = phi_661_;
                    if (_e365 < 8388608f) {
                        phi_666_ = (_e378 - _e381);
                        phi_667_ = false;
                    } else {
                        phi_666_ = f32();
                        phi_667_ = true;
                    }
                    let _e384 = phi_666_;
                    let _e386 = phi_667_;
                    phi_668_ = _e384;
                    phi_669_ = _e386;
                } else {
                    phi_668_ = f32();
                    phi_669_ = true;
                }
                let _e388 = phi_668_;
                let _e390 = phi_669_;
                if _e390 {
                    phi_673_ = _e365;
                } else {
                    phi_673_ = _e388;
                }
                let _e392 = phi_673_;
                if (_e366 > -8388608f) {
                    let _e404 = f32(select(0i, select(select(i32(_e366), i32(-2147483648), (_e366 < bitcast<f32>(3472883712u))), 2147483647i, (_e366 > bitcast<f32>(1325400063u))), (_e366 == _e366)));
                    if (_e404 > _e366) {
                        phi_693_ = 1f;
                    } else {
                        phi_693_ = 0f;
                    }
                    let _e407 = phi_693_;
                    if (_e366 < 8388608f) {
                        phi_698_ = (_e404 - _e407);
                        phi_699_ = false;
                    } else {
                        phi_698_ = f32();
                        phi_699_ = true;
                    }
                    let _e410 = phi_698_;
                    let _e412 = phi_699_;
                    phi_700_ = _e410;
                    phi_701_ = _e412;
                } else {
                    phi_700_ = f32();
                    phi_701_ = true;
                }
                let _e414 = phi_700_;
                let _e416 = phi_701_;
                if _e416 {
                    phi_705_ = _e366;
                } else {
                    phi_705_ = _e414;
                }
                let _e418 = phi_705_;
                let _e419 = (_e365 - _e392);
                let _e420 = (_e366 - _e418);
                let _e429 = select(0i, select(select(i32(_e392), i32(-2147483648), (_e392 < bitcast<f32>(3472883712u))), 2147483647i, (_e392 > bitcast<f32>(1325400063u))), (_e392 == _e392));
                let _e438 = select(0i, select(select(i32(_e418), i32(-2147483648), (_e418 < bitcast<f32>(3472883712u))), 2147483647i, (_e418 > bitcast<f32>(1325400063u))), (_e418 == _e418));
                let _e441 = ((1f - _e419) * (1f - _e420));
                let _e443 = (_e419 * (1f - _e420));
                let _e445 = ((1f - _e419) * _e420);
                let _e446 = (_e419 * _e420);
                let _e448 = p.member.test;
                let _e449 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e448);
                let _e451 = p.member.map_size;
                local_1 = _e449;
                let _e453 = (bitcast<i32>(_e451) - 1i);
                if (_e429 > 0i) {
                    phi_751_ = _e429;
                } else {
                    phi_751_ = 0i;
                }
                let _e456 = phi_751_;
                if (_e438 > 0i) {
                    phi_756_ = _e438;
                } else {
                    phi_756_ = 0i;
                }
                let _e459 = phi_756_;
                if (_e456 < _e453) {
                    phi_761_ = _e456;
                } else {
                    phi_761_ = _e453;
                }
                let _e462 = phi_761_;
                if (_e459 < _e453) {
                    phi_766_ = _e459;
                } else {
                    phi_766_ = _e453;
                }
                let _e465 = phi_766_;
                let _e466 = bitcast<u32>(_e462);
                let _e468 = (_e429 + 1i);
                let _e469 = (_e438 + 1i);
                if (_e468 > 0i) {
                    phi_775_ = _e468;
                } else {
                    phi_775_ = 0i;
                }
                let _e472 = phi_775_;
                if (_e469 > 0i) {
                    phi_780_ = _e469;
                } else {
                    phi_780_ = 0i;
                }
                let _e475 = phi_780_;
                if (_e472 < _e453) {
                    phi_785_ = _e472;
                } else {
                    phi_785_ = _e453;
                }
                let _e478 = phi_785_;
                if (_e475 < _e453) {
                    phi_790_ = _e475;
                } else {
                    phi_790_ = _e453;
                }
                let _e481 = phi_790_;
                let _e482 = bitcast<u32>(_e478);
                let _e484 = (bitcast<u32>(_e465) * _e451);
                let _e485 = (bitcast<u32>(_e481) * _e451);
                let _e486 = (_e484 + _e466);
                let _e487 = (_e484 + _e482);
                let _e488 = (_e485 + _e466);
                let _e489 = (_e485 + _e482);
                if (_e486 < _e57) {
                } else {
                    return;
                }
                let _e493 = map.member[(0u + _e486)];
                if (_e487 < _e57) {
                } else {
                    return;
                }
                let _e505 = map.member[(0u + _e487)];
                if (_e488 < _e57) {
                } else {
                    return;
                }
                let _e521 = map.member[(0u + _e488)];
                if (_e489 < _e57) {
                } else {
                    return;
                }
                let _e537 = map.member[(0u + _e489)];
                let _e551 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e493.x * _e441) + (_e505.x * _e443)) + (_e521.x * _e445)) + (_e537.x * _e446)), ((((_e493.y * _e441) + (_e505.y * _e443)) + (_e521.y * _e445)) + (_e537.y * _e446)), ((((_e493.z * _e441) + (_e505.z * _e443)) + (_e521.z * _e445)) + (_e537.z * _e446)), ((((_e493.w * _e441) + (_e505.w * _e443)) + (_e521.w * _e445)) + (_e537.w * _e446))), _e359);
                let _e553 = p.member.epsilon;
                if (_e551 <= _e553) {
                    phi_881_ = true;
                } else {
                    phi_881_ = (_e551 >= (1f - _e553));
                }
                let _e558 = phi_881_;
                if ((bitcast<u32>(_e551) & 2147483647u) > 2139095040u) {
                    phi_889_ = true;
                } else {
                    phi_889_ = !(_e558);
                }
                let _e564 = phi_889_;
                if (_e551 > 0.5f) {
                    phi_894_ = 1f;
                } else {
                    phi_894_ = 0f;
                }
                let _e567 = phi_894_;
                phi_897_ = evaluate_Verdict(_e567, _e564);
            } else {
                phi_897_ = evaluate_Verdict(1f, true);
            }
            let _e571 = phi_897_;
            phi_898_ = _e571;
        }
        let _e573 = phi_898_;
        visibility.member[_e67.first_primitive] = _e573.visibility;
        phi_902_ = _e573.is_doubted;
        phi_903_ = _e67.first_primitive;
    } else {
        phi_902_ = false;
        phi_903_ = 0u;
    }
    let _e578 = phi_902_;
    let _e580 = phi_903_;
    if _e578 {
        let _e582 = atomicAdd((&shared_[0u]), 1u);
        phi_909_ = _e582;
    } else {
        phi_909_ = 0u;
    }
    let _e584 = phi_909_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e588 = atomicLoad((&shared_[0u]));
        let _e589 = atomicAdd((&list.member[3u]), _e588);
        atomicStore((&shared_[1u]), _e589);
    }
    workgroupBarrier();
    if _e578 {
        let _e592 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e592) + _e584)]), _e580);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
