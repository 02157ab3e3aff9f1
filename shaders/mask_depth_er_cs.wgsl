struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    layers_behind: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    grid: vec2<u32>,
}

struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct abi_MaskParams {
    current: abi_CameraParams,
    previous: abi_CameraParams,
    light: abi_LightParams,
    still: vec2<u32>,
    moving: vec2<u32>,
    frame: u32,
    flags: u32,
    depth_tolerance: f32,
    refresh: u32,
    expansion: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_8 {
    member: abi_MaskParams,
}

struct type_12 {
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

struct type_23 {
    member: array<abi_Sample>,
}

struct type_27 {
    member: array<f32>,
}

struct doubt_Listed {
    pixel: u32,
    is_trusted: bool,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct mask_Masked {
    visibility: f32,
    bits: u32,
    needs_ray: bool,
    is_trusted: bool,
}

struct lt_mask_Neighbourhood {
    any_expands: bool,
    all_remove: bool,
}

struct type_43 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_8;
var<private> local_1: u32;
@group(0) @binding(1) 
var<storage> samples: type_23;
@group(0) @binding(2) 
var<storage> heard: type_12;
@group(0) @binding(3) 
var<storage, read_write> bits: type_12;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_27;
@group(0) @binding(5) 
var<storage, read_write> list: type_43;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(6) 
var<storage> last_depths: type_27;
@group(0) @binding(7) 
var<storage, read_write> depths: type_27;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_155_: lt_bvh_traverse_Tree;
    var phi_156_: bool;
    var phi_157_: lt_bvh_traverse_Tree;
    var phi_158_: bool;
    var phi_163_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_155_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_156_ = false;
        } else {
            phi_155_ = lt_bvh_traverse_Tree();
            phi_156_ = true;
        }
        let _e54 = phi_155_;
        let _e56 = phi_156_;
        phi_157_ = _e54;
        phi_158_ = _e56;
    } else {
        phi_157_ = lt_bvh_traverse_Tree();
        phi_158_ = true;
    }
    let _e58 = phi_157_;
    let _e60 = phi_158_;
    if _e60 {
        phi_163_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_163_ = _e58;
    }
    let _e65 = phi_163_;
    return lt_bvh_traverse_Tree(_e65.root, _e65.first_primitive);
}

fn function_() {
    var phi_232_: bool;
    var phi_233_: bool;
    var phi_234_: bool;
    var phi_235_: bool;
    var phi_239_: bool;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_321_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_322_: bool;
    var phi_323_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_324_: bool;
    var phi_331_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_335_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_348_: bool;
    var phi_404_: bool;
    var phi_408_: f32;
    var phi_419_: bool;
    var phi_425_: bool;
    var phi_456_: u32;
    var phi_485_: lt_mask_Neighbourhood;
    var phi_486_: lt_mask_Neighbourhood;
    var phi_487_: lt_mask_Neighbourhood;
    var phi_519_: bool;
    var phi_520_: bool;
    var phi_542_: bool;
    var phi_543_: bool;
    var phi_544_: bool;
    var phi_548_: bool;
    var phi_570_: bool;
    var phi_571_: bool;
    var phi_584_: bool;
    var phi_585_: bool;
    var phi_586_: bool;
    var phi_593_: u32;
    var phi_594_: u32;
    var phi_595_: u32;
    var phi_596_: u32;
    var phi_597_: u32;
    var phi_598_: u32;
    var phi_599_: u32;
    var phi_611_: bool;
    var phi_612_: bool;
    var phi_613_: bool;
    var phi_614_: bool;
    var phi_618_: bool;
    var phi_624_: bool;
    var phi_632_: u32;
    var phi_637_: u32;
    var phi_646_: u32;
    var phi_651_: u32;
    var phi_655_: u32;
    var phi_656_: u32;
    var phi_657_: u32;
    var phi_661_: f32;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_673_: mask_Masked;
    var phi_745_: bool;
    var phi_746_: bool;
    var phi_747_: bool;
    var phi_748_: bool;
    var phi_752_: bool;
    var phi_780_: f32;
    var phi_785_: doubt_Listed;
    var phi_786_: bool;
    var phi_799_: u32;
    var phi_816_: u32;

    let _e41 = id_1;
    let _e42 = local_1;
    let _e59 = p.member.current.size[0u];
    let _e61 = p.member.current.size[1u];
    let _e62 = lt_shaders_entry_pixel_index(_e41, _e59, _e61);
    if (bitcast<i32>(_e62.root) != 0i) {
        let _e70 = p.member.current.size[0u];
        let _e73 = samples.member[_e62.first_primitive].position;
        let _e75 = visibility.member[_e62.first_primitive];
        let _e81 = samples.member[_e62.first_primitive].normal[0u];
        let _e83 = global[0u];
        if (_e81 == _e83) {
            let _e86 = samples.member[_e62.first_primitive].normal[1u];
            let _e88 = global[1u];
            if (_e86 == _e88) {
                let _e91 = samples.member[_e62.first_primitive].normal[2u];
                let _e93 = global[2u];
                phi_232_ = (_e91 == _e93);
                phi_233_ = false;
            } else {
                phi_232_ = bool();
                phi_233_ = true;
            }
            let _e96 = phi_232_;
            let _e98 = phi_233_;
            phi_234_ = _e96;
            phi_235_ = _e98;
        } else {
            phi_234_ = bool();
            phi_235_ = true;
        }
        let _e100 = phi_234_;
        let _e102 = phi_235_;
        if _e102 {
            phi_239_ = false;
        } else {
            phi_239_ = _e100;
        }
        let _e104 = phi_239_;
        if !(_e104) {
            let _e107 = samples.member[_e62.first_primitive].position;
            let _e109 = p.member.light.place;
            let _e115 = p.member.light.place[3u];
            let _e122 = (_e109.x - (_e107.x * _e115));
            let _e123 = (_e109.y - (_e107.y * _e115));
            let _e124 = (_e109.z - (_e107.z * _e115));
            let _e126 = samples.member[_e62.first_primitive].normal;
            if ((((_e126.x * _e122) + (_e126.y * _e123)) + (_e126.z * _e124)) > 0f) {
                let _e140 = (((_e122 * _e122) + (_e123 * _e123)) + (_e124 * _e124));
                let _e142 = p.member.light.axis;
                let _e154 = p.member.light.place[3u];
                if (_e154 == 0f) {
                    phi_310_ = true;
                } else {
                    let _e157 = p.member.light.range_squared;
                    if (_e140 <= _e157) {
                        let _e160 = p.member.light.cos_outer;
                        phi_309_ = (-((((_e122 * _e142.x) + (_e123 * _e142.y)) + (_e124 * _e142.z))) >= (_e160 * sqrt(_e140)));
                    } else {
                        phi_309_ = false;
                    }
                    let _e165 = phi_309_;
                    phi_310_ = _e165;
                }
                let _e167 = phi_310_;
                if _e167 {
                    let _e169 = samples.member[_e62.first_primitive].flags;
                    let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e177.unnamed.visibility, false), _e177.unnamed_1);
                    phi_321_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e183.unnamed, ((_e169 & 1u) == 0u));
                    phi_322_ = false;
                } else {
                    phi_321_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_322_ = true;
                }
                let _e188 = phi_321_;
                let _e190 = phi_322_;
                phi_323_ = _e188;
                phi_324_ = _e190;
            } else {
                phi_323_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_324_ = true;
            }
            let _e192 = phi_323_;
            let _e194 = phi_324_;
            if _e194 {
                let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e200.unnamed.visibility, false), _e200.unnamed_1);
                phi_331_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e206.unnamed, true);
            } else {
                phi_331_ = _e192;
            }
            let _e211 = phi_331_;
            phi_335_ = _e211;
        } else {
            let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e223 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e217.unnamed.visibility, false), _e217.unnamed_1);
            phi_335_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e223.unnamed, true);
        }
        let _e228 = phi_335_;
        if _e228.unnamed_1 {
            phi_673_ = mask_Masked(_e228.unnamed.visibility, 0u, false, false);
        } else {
            let _e233 = (_e75 < 0.5f);
            if (_e75 > 0f) {
                phi_348_ = (_e75 < 1f);
            } else {
                phi_348_ = false;
            }
            let _e237 = phi_348_;
            let _e240 = p.member.previous.eye;
            let _e251 = p.member.previous.forward;
            let _e259 = ((((_e73.x - _e240.x) * _e251.x) + ((_e73.y - _e240.y) * _e251.y)) + ((_e73.z - _e240.z) * _e251.z));
            let _e261 = ((_e41.y * _e70) + _e41.x);
            if (_e261 < arrayLength((&last_depths.member))) {
            } else {
                return;
            }
            let _e265 = last_depths.member[(0u + _e261)];
            let _e267 = p.member.depth_tolerance;
            let _e270 = abs(_e259);
            let _e271 = abs(_e265);
            if ((bitcast<u32>(_e271) & 2147483647u) > 2139095040u) {
                phi_404_ = true;
            } else {
                let _e275 = (_e271 > _e270);
                if _e275 {
                }
                phi_404_ = _e275;
            }
            let _e277 = phi_404_;
            if _e277 {
                phi_408_ = _e271;
            } else {
                phi_408_ = _e270;
            }
            let _e279 = phi_408_;
            if (abs((_e259 - _e265)) <= (_e267 * _e279)) {
                let _e283 = p.member.flags;
                phi_419_ = ((_e283 & 1u) != 0u);
            } else {
                phi_419_ = false;
            }
            let _e287 = phi_419_;
            let _e288 = lt_mask_Neighbourhood(false, true);
            if _e237 {
                phi_425_ = false;
            } else {
                phi_425_ = true;
            }
            let _e290 = phi_425_;
            if _e290 {
                if _e287 {
                    if ((0u & 2u) != 0u) {
                        phi_485_ = _e288;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e294 = (_e70 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e70 % 32u) > 0u) {
                            phi_456_ = (_e294 + 1u);
                        } else {
                            phi_456_ = _e294;
                        }
                        let _e300 = phi_456_;
                        let _e310 = ((((_e41.y * _e300) + (_e41.x / 32u)) * 6u) + (select(0u, 1u, _e233) | (select(0u, 1u, false) << bitcast<u32>(1i))));
                        if (_e310 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e314 = heard.member[(0u + _e310)];
                        let _e320 = (((_e314 >> bitcast<u32>(((_e41.x % 32u) & 31u))) & 1u) != 0u);
                        phi_485_ = lt_mask_Neighbourhood(_e320, !(_e320));
                    }
                    let _e324 = phi_485_;
                    phi_486_ = _e324;
                } else {
                    phi_486_ = _e288;
                }
                let _e326 = phi_486_;
                phi_487_ = _e326;
            } else {
                phi_487_ = _e288;
            }
            let _e328 = phi_487_;
            let _e331 = p.member.frame;
            let _e333 = p.member.refresh;
            if (_e333 == 0u) {
                phi_520_ = false;
            } else {
                if (_e333 == 0u) {
                    return;
                }
                let _e342 = ((_e41.x + (_e41.y * (((_e333 * 5u) / 8u) | 1u))) + (_e331 % _e333));
                if (_e333 == 0u) {
                    phi_519_ = (_e342 == 0u);
                } else {
                    if (_e333 == 0u) {
                        return;
                    }
                    phi_519_ = ((_e342 % _e333) == 0u);
                }
                let _e349 = phi_519_;
                phi_520_ = _e349;
            }
            let _e351 = phi_520_;
            if _e287 {
                if _e351 {
                    phi_542_ = bool();
                } else {
                    phi_542_ = ((0u & 2u) != 0u);
                }
                let _e357 = phi_542_;
                phi_543_ = _e357;
                phi_544_ = _e351;
            } else {
                phi_543_ = bool();
                phi_544_ = true;
            }
            let _e359 = phi_543_;
            let _e361 = phi_544_;
            if _e361 {
                phi_548_ = false;
            } else {
                phi_548_ = _e359;
            }
            let _e363 = phi_548_;
            if _e363 {
                phi_599_ = 7u;
            } else {
                if (_e75 != 0.5f) {
                    if _e287 {
                        if _e351 {
                            phi_596_ = 6u;
                        } else {
                            if _e237 {
                                phi_571_ = true;
                            } else {
                                if _e328.any_expands {
                                    phi_570_ = false;
                                } else {
                                    phi_570_ = true;
                                }
                                let _e365 = phi_570_;
                                phi_571_ = _e365;
                            }
                            let _e367 = phi_571_;
                            if _e367 {
                                if _e237 {
                                    if false {
                                        if _e328.all_remove {
                                            phi_584_ = false;
                                        } else {
                                            phi_584_ = true;
                                        }
                                        let _e369 = phi_584_;
                                        phi_585_ = _e369;
                                    } else {
                                        phi_585_ = true;
                                    }
                                    let _e371 = phi_585_;
                                    phi_586_ = _e371;
                                } else {
                                    phi_586_ = true;
                                }
                                let _e373 = phi_586_;
                                if _e373 {
                                    if _e237 {
                                        phi_593_ = 1u;
                                    } else {
                                        phi_593_ = 0u;
                                    }
                                    let _e375 = phi_593_;
                                    phi_594_ = _e375;
                                } else {
                                    phi_594_ = 5u;
                                }
                                let _e377 = phi_594_;
                                phi_595_ = _e377;
                            } else {
                                phi_595_ = 4u;
                            }
                            let _e379 = phi_595_;
                            phi_596_ = _e379;
                        }
                        let _e381 = phi_596_;
                        phi_597_ = _e381;
                    } else {
                        phi_597_ = 3u;
                    }
                    let _e383 = phi_597_;
                    phi_598_ = _e383;
                } else {
                    phi_598_ = 2u;
                }
                let _e385 = phi_598_;
                phi_599_ = _e385;
            }
            let _e387 = phi_599_;
            if !((_e387 == 0u)) {
                if !((_e387 == 5u)) {
                    phi_611_ = !(_e363);
                    phi_612_ = false;
                } else {
                    phi_611_ = bool();
                    phi_612_ = true;
                }
                let _e394 = phi_611_;
                let _e396 = phi_612_;
                phi_613_ = _e394;
                phi_614_ = _e396;
            } else {
                phi_613_ = bool();
                phi_614_ = true;
            }
            let _e398 = phi_613_;
            let _e400 = phi_614_;
            if _e400 {
                phi_618_ = false;
            } else {
                phi_618_ = _e398;
            }
            let _e402 = phi_618_;
            if _e363 {
                phi_624_ = ((0u & 4u) != 0u);
            } else {
                phi_624_ = _e233;
            }
            let _e406 = phi_624_;
            if _e402 {
                if _e233 {
                    phi_632_ = (2u | 1u);
                } else {
                    phi_632_ = 2u;
                }
                let _e409 = phi_632_;
                if false {
                    phi_637_ = (_e409 | 4u);
                } else {
                    phi_637_ = _e409;
                }
                let _e412 = phi_637_;
                phi_657_ = _e412;
            } else {
                if (_e387 == 7u) {
                    if _e233 {
                        phi_646_ = (2u | 1u);
                    } else {
                        phi_646_ = 2u;
                    }
                    let _e416 = phi_646_;
                    if _e406 {
                        phi_651_ = (_e416 | 4u);
                    } else {
                        phi_651_ = _e416;
                    }
                    let _e419 = phi_651_;
                    phi_656_ = _e419;
                } else {
                    if _e233 {
                        phi_655_ = 1u;
                    } else {
                        phi_655_ = 0u;
                    }
                    let _e421 = phi_655_;
                    phi_656_ = _e421;
                }
                let _e423 = phi_656_;
                phi_657_ = _e423;
            }
            let _e425 = phi_657_;
            if _e406 {
                phi_661_ = 0f;
            } else {
                phi_661_ = 1f;
            }
            let _e427 = phi_661_;
            if _e237 {
                if (_e75 == 0.99999994f) {
                    phi_670_ = true;
                } else {
                    phi_670_ = (_e75 == 0.000000059604645f);
                }
                let _e431 = phi_670_;
                phi_671_ = _e431;
            } else {
                phi_671_ = true;
            }
            let _e433 = phi_671_;
            phi_673_ = mask_Masked(_e427, _e425, _e402, _e433);
        }
        let _e436 = phi_673_;
        visibility.member[_e62.first_primitive] = _e436.visibility;
        let _e441 = p.member.light.number;
        let _e442 = (_e441 * 3u);
        let _e444 = (_e442 % 32u);
        let _e446 = p.member.light.mask_words;
        let _e448 = ((_e62.first_primitive * _e446) + (_e442 / 32u));
        let _e450 = bits.member[_e448];
        bits.member[_e448] = ((_e450 & ~((7u << bitcast<u32>((_e444 & 31u))))) | (_e436.bits << bitcast<u32>((_e444 & 31u))));
        if (_e444 > 29u) {
            let _e465 = bits.member[(_e448 + 1u)];
            let _e467 = (32u - _e444);
            bits.member[(_e448 + 1u)] = ((_e465 & ~((7u >> bitcast<u32>((_e467 & 31u))))) | (_e436.bits >> bitcast<u32>((_e467 & 31u))));
        }
        let _e482 = samples.member[_e62.first_primitive].normal[0u];
        let _e484 = global[0u];
        if (_e482 == _e484) {
            let _e487 = samples.member[_e62.first_primitive].normal[1u];
            let _e489 = global[1u];
            if (_e487 == _e489) {
                let _e492 = samples.member[_e62.first_primitive].normal[2u];
                let _e494 = global[2u];
                phi_745_ = (_e492 == _e494);
                phi_746_ = false;
            } else {
                phi_745_ = bool();
                phi_746_ = true;
            }
            let _e497 = phi_745_;
            let _e499 = phi_746_;
            phi_747_ = _e497;
            phi_748_ = _e499;
        } else {
            phi_747_ = bool();
            phi_748_ = true;
        }
        let _e501 = phi_747_;
        let _e503 = phi_748_;
        if _e503 {
            phi_752_ = false;
        } else {
            phi_752_ = _e501;
        }
        let _e505 = phi_752_;
        if !(_e505) {
            let _e508 = samples.member[_e62.first_primitive].position;
            let _e510 = p.member.current.eye;
            let _e521 = p.member.current.forward;
            phi_780_ = ((((_e508.x - _e510.x) * _e521.x) + ((_e508.y - _e510.y) * _e521.y)) + ((_e508.z - _e510.z) * _e521.z));
        } else {
            phi_780_ = 0f;
        }
        let _e531 = phi_780_;
        depths.member[_e62.first_primitive] = _e531;
        phi_785_ = doubt_Listed(_e62.first_primitive, _e436.is_trusted);
        phi_786_ = _e436.needs_ray;
    } else {
        phi_785_ = doubt_Listed(0u, false);
        phi_786_ = false;
    }
    let _e537 = phi_785_;
    let _e539 = phi_786_;
    if (_e42 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e539 {
        let _e545 = atomicAdd((&shared_[0u]), 1u);
        phi_799_ = _e545;
    } else {
        phi_799_ = 0u;
    }
    let _e547 = phi_799_;
    workgroupBarrier();
    if (_e42 == 0u) {
        let _e551 = atomicLoad((&shared_[0u]));
        let _e552 = atomicAdd((&list.member[3u]), _e551);
        atomicStore((&shared_[1u]), _e552);
    }
    workgroupBarrier();
    if _e539 {
        if _e537.is_trusted {
            phi_816_ = (_e537.pixel | 2147483648u);
        } else {
            phi_816_ = _e537.pixel;
        }
        let _e556 = phi_816_;
        let _e558 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e558) + _e547)]), _e556);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
