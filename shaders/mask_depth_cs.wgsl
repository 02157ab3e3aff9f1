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
    var phi_156_: lt_bvh_traverse_Tree;
    var phi_157_: bool;
    var phi_158_: lt_bvh_traverse_Tree;
    var phi_159_: bool;
    var phi_164_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_156_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_157_ = false;
        } else {
            phi_156_ = lt_bvh_traverse_Tree();
            phi_157_ = true;
        }
        let _e55 = phi_156_;
        let _e57 = phi_157_;
        phi_158_ = _e55;
        phi_159_ = _e57;
    } else {
        phi_158_ = lt_bvh_traverse_Tree();
        phi_159_ = true;
    }
    let _e59 = phi_158_;
    let _e61 = phi_159_;
    if _e61 {
        phi_164_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_164_ = _e59;
    }
    let _e66 = phi_164_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn function_() {
    var phi_233_: bool;
    var phi_234_: bool;
    var phi_235_: bool;
    var phi_236_: bool;
    var phi_240_: bool;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_322_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_323_: bool;
    var phi_324_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_325_: bool;
    var phi_332_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_336_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_349_: bool;
    var phi_405_: bool;
    var phi_409_: f32;
    var phi_420_: bool;
    var phi_457_: u32;
    var phi_506_: u32;
    var phi_511_: u32;
    var phi_512_: u32;
    var phi_513_: u32;
    var phi_514_: bool;
    var phi_515_: u32;
    var phi_516_: bool;
    var phi_517_: bool;
    var phi_518_: u32;
    var phi_519_: bool;
    var phi_520_: bool;
    var phi_524_: bool;
    var phi_528_: u32;
    var phi_533_: bool;
    var phi_564_: u32;
    var phi_593_: lt_mask_Neighbourhood;
    var phi_594_: lt_mask_Neighbourhood;
    var phi_595_: lt_mask_Neighbourhood;
    var phi_627_: bool;
    var phi_628_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_656_: bool;
    var phi_678_: bool;
    var phi_679_: bool;
    var phi_692_: bool;
    var phi_693_: bool;
    var phi_694_: bool;
    var phi_701_: u32;
    var phi_702_: u32;
    var phi_703_: u32;
    var phi_704_: u32;
    var phi_705_: u32;
    var phi_706_: u32;
    var phi_707_: u32;
    var phi_719_: bool;
    var phi_720_: bool;
    var phi_721_: bool;
    var phi_722_: bool;
    var phi_726_: bool;
    var phi_732_: bool;
    var phi_740_: u32;
    var phi_745_: u32;
    var phi_754_: u32;
    var phi_759_: u32;
    var phi_763_: u32;
    var phi_764_: u32;
    var phi_765_: u32;
    var phi_769_: f32;
    var phi_778_: bool;
    var phi_779_: bool;
    var phi_781_: mask_Masked;
    var phi_853_: bool;
    var phi_854_: bool;
    var phi_855_: bool;
    var phi_856_: bool;
    var phi_860_: bool;
    var phi_888_: f32;
    var phi_893_: doubt_Listed;
    var phi_894_: bool;
    var phi_907_: u32;
    var phi_924_: u32;

    let _e42 = id_1;
    let _e43 = local_1;
    let _e48 = arrayLength((&heard.member));
    let _e60 = p.member.current.size[0u];
    let _e62 = p.member.current.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e42, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        let _e71 = p.member.current.size[0u];
        let _e74 = samples.member[_e63.first_primitive].position;
        let _e76 = visibility.member[_e63.first_primitive];
        let _e82 = samples.member[_e63.first_primitive].normal[0u];
        let _e84 = global[0u];
        if (_e82 == _e84) {
            let _e87 = samples.member[_e63.first_primitive].normal[1u];
            let _e89 = global[1u];
            if (_e87 == _e89) {
                let _e92 = samples.member[_e63.first_primitive].normal[2u];
                let _e94 = global[2u];
                phi_233_ = (_e92 == _e94);
                phi_234_ = false;
            } else {
                phi_233_ = bool();
                phi_234_ = true;
            }
            let _e97 = phi_233_;
            let _e99 = phi_234_;
            phi_235_ = _e97;
            phi_236_ = _e99;
        } else {
            phi_235_ = bool();
            phi_236_ = true;
        }
        let _e101 = phi_235_;
        let _e103 = phi_236_;
        if _e103 {
            phi_240_ = false;
        } else {
            phi_240_ = _e101;
        }
        let _e105 = phi_240_;
        if !(_e105) {
            let _e108 = samples.member[_e63.first_primitive].position;
            let _e110 = p.member.light.place;
            let _e116 = p.member.light.place[3u];
            let _e123 = (_e110.x - (_e108.x * _e116));
            let _e124 = (_e110.y - (_e108.y * _e116));
            let _e125 = (_e110.z - (_e108.z * _e116));
            let _e127 = samples.member[_e63.first_primitive].normal;
            if ((((_e127.x * _e123) + (_e127.y * _e124)) + (_e127.z * _e125)) > 0f) {
                let _e141 = (((_e123 * _e123) + (_e124 * _e124)) + (_e125 * _e125));
                let _e143 = p.member.light.axis;
                let _e155 = p.member.light.place[3u];
                if (_e155 == 0f) {
                    phi_311_ = true;
                } else {
                    let _e158 = p.member.light.range_squared;
                    if (_e141 <= _e158) {
                        let _e161 = p.member.light.cos_outer;
                        phi_310_ = (-((((_e123 * _e143.x) + (_e124 * _e143.y)) + (_e125 * _e143.z))) >= (_e161 * sqrt(_e141)));
                    } else {
                        phi_310_ = false;
                    }
                    let _e166 = phi_310_;
                    phi_311_ = _e166;
                }
                let _e168 = phi_311_;
                if _e168 {
                    let _e170 = samples.member[_e63.first_primitive].flags;
                    let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e178.unnamed.visibility, false), _e178.unnamed_1);
                    phi_322_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e184.unnamed, ((_e170 & 1u) == 0u));
                    phi_323_ = false;
                } else {
                    phi_322_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_323_ = true;
                }
                let _e189 = phi_322_;
                let _e191 = phi_323_;
                phi_324_ = _e189;
                phi_325_ = _e191;
            } else {
                phi_324_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_325_ = true;
            }
            let _e193 = phi_324_;
            let _e195 = phi_325_;
            if _e195 {
                let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e201.unnamed.visibility, false), _e201.unnamed_1);
                phi_332_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e207.unnamed, true);
            } else {
                phi_332_ = _e193;
            }
            let _e212 = phi_332_;
            phi_336_ = _e212;
        } else {
            let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e224 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e218.unnamed.visibility, false), _e218.unnamed_1);
            phi_336_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e224.unnamed, true);
        }
        let _e229 = phi_336_;
        if _e229.unnamed_1 {
            phi_781_ = mask_Masked(_e229.unnamed.visibility, 0u, false, false);
        } else {
            let _e234 = (_e76 < 0.5f);
            if (_e76 > 0f) {
                phi_349_ = (_e76 < 1f);
            } else {
                phi_349_ = false;
            }
            let _e238 = phi_349_;
            let _e241 = p.member.previous.eye;
            let _e252 = p.member.previous.forward;
            let _e260 = ((((_e74.x - _e241.x) * _e252.x) + ((_e74.y - _e241.y) * _e252.y)) + ((_e74.z - _e241.z) * _e252.z));
            let _e262 = ((_e42.y * _e71) + _e42.x);
            if (_e262 < arrayLength((&last_depths.member))) {
            } else {
                return;
            }
            let _e266 = last_depths.member[(0u + _e262)];
            let _e268 = p.member.depth_tolerance;
            let _e271 = abs(_e260);
            let _e272 = abs(_e266);
            if ((bitcast<u32>(_e272) & 2147483647u) > 2139095040u) {
                phi_405_ = true;
            } else {
                let _e276 = (_e272 > _e271);
                if _e276 {
                }
                phi_405_ = _e276;
            }
            let _e278 = phi_405_;
            if _e278 {
                phi_409_ = _e272;
            } else {
                phi_409_ = _e271;
            }
            let _e280 = phi_409_;
            if (abs((_e260 - _e266)) <= (_e268 * _e280)) {
                let _e284 = p.member.flags;
                phi_420_ = ((_e284 & 1u) != 0u);
            } else {
                phi_420_ = false;
            }
            let _e288 = phi_420_;
            let _e290 = p.member.flags;
            let _e292 = ((_e290 & 2u) != 0u);
            let _e294 = p.member.flags;
            if ((_e294 & 4u) == 0u) {
                phi_518_ = u32();
                phi_519_ = true;
                phi_520_ = false;
            } else {
                if _e288 {
                    if !(false) {
                        if (32u == 0u) {
                            return;
                        }
                        let _e299 = (_e71 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e71 % 32u) > 0u) {
                            phi_457_ = (_e299 + 1u);
                        } else {
                            phi_457_ = _e299;
                        }
                        let _e305 = phi_457_;
                        let _e310 = ((((_e42.y * _e305) + (_e42.x / 32u)) * 6u) + 4u);
                        if (_e310 < _e48) {
                        } else {
                            return;
                        }
                        let _e314 = heard.member[(0u + _e310)];
                        if (((_e314 >> bitcast<u32>(((_e42.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e325 = ((((_e42.y * _e305) + (_e42.x / 32u)) * 6u) + 5u);
                            if (_e325 < _e48) {
                            } else {
                                return;
                            }
                            let _e329 = heard.member[(0u + _e325)];
                            if false {
                                phi_506_ = (2u | 1u);
                            } else {
                                phi_506_ = 2u;
                            }
                            let _e338 = phi_506_;
                            if (((_e329 >> bitcast<u32>(((_e42.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_511_ = (_e338 | 4u);
                            } else {
                                phi_511_ = _e338;
                            }
                            let _e341 = phi_511_;
                            phi_512_ = _e341;
                        } else {
                            phi_512_ = 0u;
                        }
                        let _e343 = phi_512_;
                        phi_513_ = _e343;
                        phi_514_ = false;
                    } else {
                        phi_513_ = u32();
                        phi_514_ = true;
                    }
                    let _e345 = phi_513_;
                    let _e347 = phi_514_;
                    phi_515_ = _e345;
                    phi_516_ = false;
                    phi_517_ = _e347;
                } else {
                    phi_515_ = u32();
                    phi_516_ = true;
                    phi_517_ = false;
                }
                let _e349 = phi_515_;
                let _e351 = phi_516_;
                let _e353 = phi_517_;
                phi_518_ = _e349;
                phi_519_ = _e351;
                phi_520_ = _e353;
            }
            let _e355 = phi_518_;
            let _e357 = phi_519_;
            let _e359 = phi_520_;
            if _e357 {
                phi_524_ = true;
            } else {
                phi_524_ = _e359;
            }
            let _e361 = phi_524_;
            if _e361 {
                phi_528_ = 0u;
            } else {
                phi_528_ = _e355;
            }
            let _e363 = phi_528_;
            let _e364 = lt_mask_Neighbourhood(false, true);
            if _e238 {
                phi_533_ = _e292;
            } else {
                phi_533_ = true;
            }
            let _e366 = phi_533_;
            if _e366 {
                if _e288 {
                    if ((_e363 & 2u) != 0u) {
                        phi_593_ = _e364;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e370 = (_e71 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e71 % 32u) > 0u) {
                            phi_564_ = (_e370 + 1u);
                        } else {
                            phi_564_ = _e370;
                        }
                        let _e376 = phi_564_;
                        let _e386 = ((((_e42.y * _e376) + (_e42.x / 32u)) * 6u) + (select(0u, 1u, _e234) | (select(0u, 1u, false) << bitcast<u32>(1i))));
                        if (_e386 < _e48) {
                        } else {
                            return;
                        }
                        let _e390 = heard.member[(0u + _e386)];
                        let _e396 = (((_e390 >> bitcast<u32>(((_e42.x % 32u) & 31u))) & 1u) != 0u);
                        phi_593_ = lt_mask_Neighbourhood(_e396, !(_e396));
                    }
                    let _e400 = phi_593_;
                    phi_594_ = _e400;
                } else {
                    phi_594_ = _e364;
                }
                let _e402 = phi_594_;
                phi_595_ = _e402;
            } else {
                phi_595_ = _e364;
            }
            let _e404 = phi_595_;
            let _e407 = p.member.frame;
            let _e409 = p.member.refresh;
            if (_e409 == 0u) {
                phi_628_ = false;
            } else {
                if (_e409 == 0u) {
                    return;
                }
                let _e418 = ((_e42.x + (_e42.y * (((_e409 * 5u) / 8u) | 1u))) + (_e407 % _e409));
                if (_e409 == 0u) {
                    phi_627_ = (_e418 == 0u);
                } else {
                    if (_e409 == 0u) {
                        return;
                    }
                    phi_627_ = ((_e418 % _e409) == 0u);
                }
                let _e425 = phi_627_;
                phi_628_ = _e425;
            }
            let _e427 = phi_628_;
            if _e288 {
                if _e427 {
                    phi_650_ = bool();
                } else {
                    phi_650_ = ((_e363 & 2u) != 0u);
                }
                let _e433 = phi_650_;
                phi_651_ = _e433;
                phi_652_ = _e427;
            } else {
                phi_651_ = bool();
                phi_652_ = true;
            }
            let _e435 = phi_651_;
            let _e437 = phi_652_;
            if _e437 {
                phi_656_ = false;
            } else {
                phi_656_ = _e435;
            }
            let _e439 = phi_656_;
            if _e439 {
                phi_707_ = 7u;
            } else {
                if (_e76 != 0.5f) {
                    if _e288 {
                        if _e427 {
                            phi_704_ = 6u;
                        } else {
                            if _e238 {
                                phi_679_ = true;
                            } else {
                                if _e404.any_expands {
                                    phi_678_ = false;
                                } else {
                                    phi_678_ = true;
                                }
                                let _e441 = phi_678_;
                                phi_679_ = _e441;
                            }
                            let _e443 = phi_679_;
                            if _e443 {
                                if _e238 {
                                    if _e292 {
                                        if _e404.all_remove {
                                            phi_692_ = false;
                                        } else {
                                            phi_692_ = true;
                                        }
                                        let _e445 = phi_692_;
                                        phi_693_ = _e445;
                                    } else {
                                        phi_693_ = true;
                                    }
                                    let _e447 = phi_693_;
                                    phi_694_ = _e447;
                                } else {
                                    phi_694_ = true;
                                }
                                let _e449 = phi_694_;
                                if _e449 {
                                    if _e238 {
                                        phi_701_ = 1u;
                                    } else {
                                        phi_701_ = 0u;
                                    }
                                    let _e451 = phi_701_;
                                    phi_702_ = _e451;
                                } else {
                                    phi_702_ = 5u;
                                }
                                let _e453 = phi_702_;
                                phi_703_ = _e453;
                            } else {
                                phi_703_ = 4u;
                            }
                            let _e455 = phi_703_;
                            phi_704_ = _e455;
                        }
                        let _e457 = phi_704_;
                        phi_705_ = _e457;
                    } else {
                        phi_705_ = 3u;
                    }
                    let _e459 = phi_705_;
                    phi_706_ = _e459;
                } else {
                    phi_706_ = 2u;
                }
                let _e461 = phi_706_;
                phi_707_ = _e461;
            }
            let _e463 = phi_707_;
            if !((_e463 == 0u)) {
                if !((_e463 == 5u)) {
                    phi_719_ = !(_e439);
                    phi_720_ = false;
                } else {
                    phi_719_ = bool();
                    phi_720_ = true;
                }
                let _e470 = phi_719_;
                let _e472 = phi_720_;
                phi_721_ = _e470;
                phi_722_ = _e472;
            } else {
                phi_721_ = bool();
                phi_722_ = true;
            }
            let _e474 = phi_721_;
            let _e476 = phi_722_;
            if _e476 {
                phi_726_ = false;
            } else {
                phi_726_ = _e474;
            }
            let _e478 = phi_726_;
            if _e439 {
                phi_732_ = ((_e363 & 4u) != 0u);
            } else {
                phi_732_ = _e234;
            }
            let _e482 = phi_732_;
            if _e478 {
                if _e234 {
                    phi_740_ = (2u | 1u);
                } else {
                    phi_740_ = 2u;
                }
                let _e485 = phi_740_;
                if false {
                    phi_745_ = (_e485 | 4u);
                } else {
                    phi_745_ = _e485;
                }
                let _e488 = phi_745_;
                phi_765_ = _e488;
            } else {
                if (_e463 == 7u) {
                    if _e234 {
                        phi_754_ = (2u | 1u);
                    } else {
                        phi_754_ = 2u;
                    }
                    let _e492 = phi_754_;
                    if _e482 {
                        phi_759_ = (_e492 | 4u);
                    } else {
                        phi_759_ = _e492;
                    }
                    let _e495 = phi_759_;
                    phi_764_ = _e495;
                } else {
                    if _e234 {
                        phi_763_ = 1u;
                    } else {
                        phi_763_ = 0u;
                    }
                    let _e497 = phi_763_;
                    phi_764_ = _e497;
                }
                let _e499 = phi_764_;
                phi_765_ = _e499;
            }
            let _e501 = phi_765_;
            if _e482 {
                phi_769_ = 0f;
            } else {
                phi_769_ = 1f;
            }
            let _e503 = phi_769_;
            if _e238 {
                if (_e76 == 0.99999994f) {
                    phi_778_ = true;
                } else {
                    phi_778_ = (_e76 == 0.000000059604645f);
                }
                let _e507 = phi_778_;
                phi_779_ = _e507;
            } else {
                phi_779_ = true;
            }
            let _e509 = phi_779_;
            phi_781_ = mask_Masked(_e503, _e501, _e478, _e509);
        }
        let _e512 = phi_781_;
        visibility.member[_e63.first_primitive] = _e512.visibility;
        let _e517 = p.member.light.number;
        let _e518 = (_e517 * 3u);
        let _e520 = (_e518 % 32u);
        let _e522 = p.member.light.mask_words;
        let _e524 = ((_e63.first_primitive * _e522) + (_e518 / 32u));
        let _e526 = bits.member[_e524];
        bits.member[_e524] = ((_e526 & ~((7u << bitcast<u32>((_e520 & 31u))))) | (_e512.bits << bitcast<u32>((_e520 & 31u))));
        if (_e520 > 29u) {
            let _e541 = bits.member[(_e524 + 1u)];
            let _e543 = (32u - _e520);
            bits.member[(_e524 + 1u)] = ((_e541 & ~((7u >> bitcast<u32>((_e543 & 31u))))) | (_e512.bits >> bitcast<u32>((_e543 & 31u))));
        }
        let _e558 = samples.member[_e63.first_primitive].normal[0u];
        let _e560 = global[0u];
        if (_e558 == _e560) {
            let _e563 = samples.member[_e63.first_primitive].normal[1u];
            let _e565 = global[1u];
            if (_e563 == _e565) {
                let _e568 = samples.member[_e63.first_primitive].normal[2u];
                let _e570 = global[2u];
                phi_853_ = (_e568 == _e570);
                phi_854_ = false;
            } else {
                phi_853_ = bool();
                phi_854_ = true;
            }
            let _e573 = phi_853_;
            let _e575 = phi_854_;
            phi_855_ = _e573;
            phi_856_ = _e575;
        } else {
            phi_855_ = bool();
            phi_856_ = true;
        }
        let _e577 = phi_855_;
        let _e579 = phi_856_;
        if _e579 {
            phi_860_ = false;
        } else {
            phi_860_ = _e577;
        }
        let _e581 = phi_860_;
        if !(_e581) {
            let _e584 = samples.member[_e63.first_primitive].position;
            let _e586 = p.member.current.eye;
            let _e597 = p.member.current.forward;
            phi_888_ = ((((_e584.x - _e586.x) * _e597.x) + ((_e584.y - _e586.y) * _e597.y)) + ((_e584.z - _e586.z) * _e597.z));
        } else {
            phi_888_ = 0f;
        }
        let _e607 = phi_888_;
        depths.member[_e63.first_primitive] = _e607;
        phi_893_ = doubt_Listed(_e63.first_primitive, _e512.is_trusted);
        phi_894_ = _e512.needs_ray;
    } else {
        phi_893_ = doubt_Listed(0u, false);
        phi_894_ = false;
    }
    let _e613 = phi_893_;
    let _e615 = phi_894_;
    if (_e43 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e615 {
        let _e621 = atomicAdd((&shared_[0u]), 1u);
        phi_907_ = _e621;
    } else {
        phi_907_ = 0u;
    }
    let _e623 = phi_907_;
    workgroupBarrier();
    if (_e43 == 0u) {
        let _e627 = atomicLoad((&shared_[0u]));
        let _e628 = atomicAdd((&list.member[3u]), _e627);
        atomicStore((&shared_[1u]), _e628);
    }
    workgroupBarrier();
    if _e615 {
        if _e613.is_trusted {
            phi_924_ = (_e613.pixel | 2147483648u);
        } else {
            phi_924_ = _e613.pixel;
        }
        let _e632 = phi_924_;
        let _e634 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e634) + _e623)]), _e632);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_depth_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
