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
    var phi_151_: lt_bvh_traverse_Tree;
    var phi_152_: bool;
    var phi_153_: lt_bvh_traverse_Tree;
    var phi_154_: bool;
    var phi_159_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_151_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_152_ = false;
        } else {
            phi_151_ = lt_bvh_traverse_Tree();
            phi_152_ = true;
        }
        let _e52 = phi_151_;
        let _e54 = phi_152_;
        phi_153_ = _e52;
        phi_154_ = _e54;
    } else {
        phi_153_ = lt_bvh_traverse_Tree();
        phi_154_ = true;
    }
    let _e56 = phi_153_;
    let _e58 = phi_154_;
    if _e58 {
        phi_159_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_159_ = _e56;
    }
    let _e63 = phi_159_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn function_() {
    var phi_227_: bool;
    var phi_228_: bool;
    var phi_229_: bool;
    var phi_230_: bool;
    var phi_234_: bool;
    var phi_304_: bool;
    var phi_305_: bool;
    var phi_316_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_317_: bool;
    var phi_318_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_319_: bool;
    var phi_326_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_330_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_343_: bool;
    var phi_399_: bool;
    var phi_403_: f32;
    var phi_414_: bool;
    var phi_451_: u32;
    var phi_500_: u32;
    var phi_505_: u32;
    var phi_506_: u32;
    var phi_507_: u32;
    var phi_508_: bool;
    var phi_509_: u32;
    var phi_510_: bool;
    var phi_511_: bool;
    var phi_512_: u32;
    var phi_513_: bool;
    var phi_514_: bool;
    var phi_518_: bool;
    var phi_522_: u32;
    var phi_527_: bool;
    var phi_558_: u32;
    var phi_587_: lt_mask_Neighbourhood;
    var phi_588_: lt_mask_Neighbourhood;
    var phi_589_: lt_mask_Neighbourhood;
    var phi_621_: bool;
    var phi_622_: bool;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_650_: bool;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_686_: bool;
    var phi_687_: bool;
    var phi_688_: bool;
    var phi_695_: u32;
    var phi_696_: u32;
    var phi_697_: u32;
    var phi_698_: u32;
    var phi_699_: u32;
    var phi_700_: u32;
    var phi_701_: u32;
    var phi_713_: bool;
    var phi_714_: bool;
    var phi_715_: bool;
    var phi_716_: bool;
    var phi_720_: bool;
    var phi_726_: bool;
    var phi_734_: u32;
    var phi_739_: u32;
    var phi_748_: u32;
    var phi_753_: u32;
    var phi_757_: u32;
    var phi_758_: u32;
    var phi_759_: u32;
    var phi_763_: f32;
    var phi_765_: mask_Masked;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_844_: bool;
    var phi_872_: f32;
    var phi_875_: bool;
    var phi_876_: u32;
    var phi_887_: u32;

    let _e39 = id_1;
    let _e40 = local_1;
    let _e45 = arrayLength((&heard.member));
    let _e56 = p.member.current.size[0u];
    let _e58 = p.member.current.size[1u];
    let _e59 = lt_shaders_entry_pixel_index(_e39, _e56, _e58);
    if (bitcast<i32>(_e59.root) != 0i) {
        let _e67 = p.member.current.size[0u];
        let _e70 = samples.member[_e59.first_primitive].position;
        let _e72 = visibility.member[_e59.first_primitive];
        let _e78 = samples.member[_e59.first_primitive].normal[0u];
        let _e80 = global[0u];
        if (_e78 == _e80) {
            let _e83 = samples.member[_e59.first_primitive].normal[1u];
            let _e85 = global[1u];
            if (_e83 == _e85) {
                let _e88 = samples.member[_e59.first_primitive].normal[2u];
                let _e90 = global[2u];
                phi_227_ = (_e88 == _e90);
                phi_228_ = false;
            } else {
                phi_227_ = bool();
                phi_228_ = true;
            }
            let _e93 = phi_227_;
            let _e95 = phi_228_;
            phi_229_ = _e93;
            phi_230_ = _e95;
        } else {
            phi_229_ = bool();
            phi_230_ = true;
        }
        let _e97 = phi_229_;
        let _e99 = phi_230_;
        if _e99 {
            phi_234_ = false;
        } else {
            phi_234_ = _e97;
        }
        let _e101 = phi_234_;
        if !(_e101) {
            let _e104 = samples.member[_e59.first_primitive].position;
            let _e106 = p.member.light.place;
            let _e112 = p.member.light.place[3u];
            let _e119 = (_e106.x - (_e104.x * _e112));
            let _e120 = (_e106.y - (_e104.y * _e112));
            let _e121 = (_e106.z - (_e104.z * _e112));
            let _e123 = samples.member[_e59.first_primitive].normal;
            if ((((_e123.x * _e119) + (_e123.y * _e120)) + (_e123.z * _e121)) > 0f) {
                let _e137 = (((_e119 * _e119) + (_e120 * _e120)) + (_e121 * _e121));
                let _e139 = p.member.light.axis;
                let _e151 = p.member.light.place[3u];
                if (_e151 == 0f) {
                    phi_305_ = true;
                } else {
                    let _e154 = p.member.light.range_squared;
                    if (_e137 <= _e154) {
                        let _e157 = p.member.light.cos_outer;
                        phi_304_ = (-((((_e119 * _e139.x) + (_e120 * _e139.y)) + (_e121 * _e139.z))) >= (_e157 * sqrt(_e137)));
                    } else {
                        phi_304_ = false;
                    }
                    let _e162 = phi_304_;
                    phi_305_ = _e162;
                }
                let _e164 = phi_305_;
                if _e164 {
                    let _e166 = samples.member[_e59.first_primitive].flags;
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e174.unnamed.visibility, false), _e174.unnamed_1);
                    phi_316_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e180.unnamed, ((_e166 & 1u) == 0u));
                    phi_317_ = false;
                } else {
                    phi_316_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_317_ = true;
                }
                let _e185 = phi_316_;
                let _e187 = phi_317_;
                phi_318_ = _e185;
                phi_319_ = _e187;
            } else {
                phi_318_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_319_ = true;
            }
            let _e189 = phi_318_;
            let _e191 = phi_319_;
            if _e191 {
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e197.unnamed.visibility, false), _e197.unnamed_1);
                phi_326_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e203.unnamed, true);
            } else {
                phi_326_ = _e189;
            }
            let _e208 = phi_326_;
            phi_330_ = _e208;
        } else {
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e214.unnamed.visibility, false), _e214.unnamed_1);
            phi_330_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e220.unnamed, true);
        }
        let _e225 = phi_330_;
        if _e225.unnamed_1 {
            phi_765_ = mask_Masked(_e225.unnamed.visibility, 0u, false);
        } else {
            let _e230 = (_e72 < 0.5f);
            if (_e72 > 0f) {
                phi_343_ = (_e72 < 1f);
            } else {
                phi_343_ = false;
            }
            let _e234 = phi_343_;
            let _e237 = p.member.previous.eye;
            let _e248 = p.member.previous.forward;
            let _e256 = ((((_e70.x - _e237.x) * _e248.x) + ((_e70.y - _e237.y) * _e248.y)) + ((_e70.z - _e237.z) * _e248.z));
            let _e258 = ((_e39.y * _e67) + _e39.x);
            if (_e258 < arrayLength((&last_depths.member))) {
            } else {
                return;
            }
            let _e262 = last_depths.member[(0u + _e258)];
            let _e264 = p.member.depth_tolerance;
            let _e267 = abs(_e256);
            let _e268 = abs(_e262);
            if ((bitcast<u32>(_e268) & 2147483647u) > 2139095040u) {
                phi_399_ = true;
            } else {
                let _e272 = (_e268 > _e267);
                if _e272 {
                }
                phi_399_ = _e272;
            }
            let _e274 = phi_399_;
            if _e274 {
                phi_403_ = _e268;
            } else {
                phi_403_ = _e267;
            }
            let _e276 = phi_403_;
            if (abs((_e256 - _e262)) <= (_e264 * _e276)) {
                let _e280 = p.member.flags;
                phi_414_ = ((_e280 & 1u) != 0u);
            } else {
                phi_414_ = false;
            }
            let _e284 = phi_414_;
            let _e286 = p.member.flags;
            let _e288 = ((_e286 & 2u) != 0u);
            let _e290 = p.member.flags;
            if ((_e290 & 4u) == 0u) {
                phi_512_ = u32();
                phi_513_ = true;
                phi_514_ = false;
            } else {
                if _e284 {
                    if !(false) {
                        if (32u == 0u) {
                            return;
                        }
                        let _e295 = (_e67 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e67 % 32u) > 0u) {
                            phi_451_ = (_e295 + 1u);
                        } else {
                            phi_451_ = _e295;
                        }
                        let _e301 = phi_451_;
                        let _e306 = ((((_e39.y * _e301) + (_e39.x / 32u)) * 6u) + 4u);
                        if (_e306 < _e45) {
                        } else {
                            return;
                        }
                        let _e310 = heard.member[(0u + _e306)];
                        if (((_e310 >> bitcast<u32>(((_e39.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e321 = ((((_e39.y * _e301) + (_e39.x / 32u)) * 6u) + 5u);
                            if (_e321 < _e45) {
                            } else {
                                return;
                            }
                            let _e325 = heard.member[(0u + _e321)];
                            if false {
                                phi_500_ = (2u | 1u);
                            } else {
                                phi_500_ = 2u;
                            }
                            let _e334 = phi_500_;
                            if (((_e325 >> bitcast<u32>(((_e39.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_505_ = (_e334 | 4u);
                            } else {
                                phi_505_ = _e334;
                            }
                            let _e337 = phi_505_;
                            phi_506_ = _e337;
                        } else {
                            phi_506_ = 0u;
                        }
                        let _e339 = phi_506_;
                        phi_507_ = _e339;
                        phi_508_ = false;
                    } else {
                        phi_507_ = u32();
                        phi_508_ = true;
                    }
                    let _e341 = phi_507_;
                    let _e343 = phi_508_;
                    phi_509_ = _e341;
                    phi_510_ = false;
                    phi_511_ = _e343;
                } else {
                    phi_509_ = u32();
                    phi_510_ = true;
                    phi_511_ = false;
                }
                let _e345 = phi_509_;
                let _e347 = phi_510_;
                let _e349 = phi_511_;
                phi_512_ = _e345;
                phi_513_ = _e347;
                phi_514_ = _e349;
            }
            let _e351 = phi_512_;
            let _e353 = phi_513_;
            let _e355 = phi_514_;
            if _e353 {
                phi_518_ = true;
            } else {
                phi_518_ = _e355;
            }
            let _e357 = phi_518_;
            if _e357 {
                phi_522_ = 0u;
            } else {
                phi_522_ = _e351;
            }
            let _e359 = phi_522_;
            let _e360 = lt_mask_Neighbourhood(false, true);
            if _e234 {
                phi_527_ = _e288;
            } else {
                phi_527_ = true;
            }
            let _e362 = phi_527_;
            if _e362 {
                if _e284 {
                    if ((_e359 & 2u) != 0u) {
                        phi_587_ = _e360;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e366 = (_e67 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e67 % 32u) > 0u) {
                            phi_558_ = (_e366 + 1u);
                        } else {
                            phi_558_ = _e366;
                        }
                        let _e372 = phi_558_;
                        let _e382 = ((((_e39.y * _e372) + (_e39.x / 32u)) * 6u) + (select(0u, 1u, _e230) | (select(0u, 1u, false) << bitcast<u32>(1i))));
                        if (_e382 < _e45) {
                        } else {
                            return;
                        }
                        let _e386 = heard.member[(0u + _e382)];
                        let _e392 = (((_e386 >> bitcast<u32>(((_e39.x % 32u) & 31u))) & 1u) != 0u);
                        phi_587_ = lt_mask_Neighbourhood(_e392, !(_e392));
                    }
                    let _e396 = phi_587_;
                    phi_588_ = _e396;
                } else {
                    phi_588_ = _e360;
                }
                let _e398 = phi_588_;
                phi_589_ = _e398;
            } else {
                phi_589_ = _e360;
            }
            let _e400 = phi_589_;
            let _e403 = p.member.frame;
            let _e405 = p.member.refresh;
            if (_e405 == 0u) {
                phi_622_ = false;
            } else {
                if (_e405 == 0u) {
                    return;
                }
                let _e414 = ((_e39.x + (_e39.y * (((_e405 * 5u) / 8u) | 1u))) + (_e403 % _e405));
                if (_e405 == 0u) {
                    phi_621_ = (_e414 == 0u);
                } else {
                    if (_e405 == 0u) {
                        return;
                    }
                    phi_621_ = ((_e414 % _e405) == 0u);
                }
                let _e421 = phi_621_;
                phi_622_ = _e421;
            }
            let _e423 = phi_622_;
            if _e284 {
                if _e423 {
                    phi_644_ = bool();
                } else {
                    phi_644_ = ((_e359 & 2u) != 0u);
                }
                let _e429 = phi_644_;
                phi_645_ = _e429;
                phi_646_ = _e423;
            } else {
                phi_645_ = bool();
                phi_646_ = true;
            }
            let _e431 = phi_645_;
            let _e433 = phi_646_;
            if _e433 {
                phi_650_ = false;
            } else {
                phi_650_ = _e431;
            }
            let _e435 = phi_650_;
            if _e435 {
                phi_701_ = 7u;
            } else {
                if (_e72 != 0.5f) {
                    if _e284 {
                        if _e423 {
                            phi_698_ = 6u;
                        } else {
                            if _e234 {
                                phi_673_ = true;
                            } else {
                                if _e400.any_expands {
                                    phi_672_ = false;
                                } else {
                                    phi_672_ = true;
                                }
                                let _e437 = phi_672_;
                                phi_673_ = _e437;
                            }
                            let _e439 = phi_673_;
                            if _e439 {
                                if _e234 {
                                    if _e288 {
                                        if _e400.all_remove {
                                            phi_686_ = false;
                                        } else {
                                            phi_686_ = true;
                                        }
                                        let _e441 = phi_686_;
                                        phi_687_ = _e441;
                                    } else {
                                        phi_687_ = true;
                                    }
                                    let _e443 = phi_687_;
                                    phi_688_ = _e443;
                                } else {
                                    phi_688_ = true;
                                }
                                let _e445 = phi_688_;
                                if _e445 {
                                    if _e234 {
                                        phi_695_ = 1u;
                                    } else {
                                        phi_695_ = 0u;
                                    }
                                    let _e447 = phi_695_;
                                    phi_696_ = _e447;
                                } else {
                                    phi_696_ = 5u;
                                }
                                let _e449 = phi_696_;
                                phi_697_ = _e449;
                            } else {
                                phi_697_ = 4u;
                            }
                            let _e451 = phi_697_;
                            phi_698_ = _e451;
                        }
                        let _e453 = phi_698_;
                        phi_699_ = _e453;
                    } else {
                        phi_699_ = 3u;
                    }
                    let _e455 = phi_699_;
                    phi_700_ = _e455;
                } else {
                    phi_700_ = 2u;
                }
                let _e457 = phi_700_;
                phi_701_ = _e457;
            }
            let _e459 = phi_701_;
            if !((_e459 == 0u)) {
                if !((_e459 == 5u)) {
                    phi_713_ = !(_e435);
                    phi_714_ = false;
                } else {
                    phi_713_ = bool();
                    phi_714_ = true;
                }
                let _e466 = phi_713_;
                let _e468 = phi_714_;
                phi_715_ = _e466;
                phi_716_ = _e468;
            } else {
                phi_715_ = bool();
                phi_716_ = true;
            }
            let _e470 = phi_715_;
            let _e472 = phi_716_;
            if _e472 {
                phi_720_ = false;
            } else {
                phi_720_ = _e470;
            }
            let _e474 = phi_720_;
            if _e435 {
                phi_726_ = ((_e359 & 4u) != 0u);
            } else {
                phi_726_ = _e230;
            }
            let _e478 = phi_726_;
            if _e474 {
                if _e230 {
                    phi_734_ = (2u | 1u);
                } else {
                    phi_734_ = 2u;
                }
                let _e481 = phi_734_;
                if false {
                    phi_739_ = (_e481 | 4u);
                } else {
                    phi_739_ = _e481;
                }
                let _e484 = phi_739_;
                phi_759_ = _e484;
            } else {
                if (_e459 == 7u) {
                    if _e230 {
                        phi_748_ = (2u | 1u);
                    } else {
                        phi_748_ = 2u;
                    }
                    let _e488 = phi_748_;
                    if _e478 {
                        phi_753_ = (_e488 | 4u);
                    } else {
                        phi_753_ = _e488;
                    }
                    let _e491 = phi_753_;
                    phi_758_ = _e491;
                } else {
                    if _e230 {
                        phi_757_ = 1u;
                    } else {
                        phi_757_ = 0u;
                    }
                    let _e493 = phi_757_;
                    phi_758_ = _e493;
                }
                let _e495 = phi_758_;
                phi_759_ = _e495;
            }
            let _e497 = phi_759_;
            if _e478 {
                phi_763_ = 0f;
            } else {
                phi_763_ = 1f;
            }
            let _e499 = phi_763_;
            phi_765_ = mask_Masked(_e499, _e497, _e474);
        }
        let _e502 = phi_765_;
        visibility.member[_e59.first_primitive] = _e502.visibility;
        let _e507 = p.member.light.number;
        let _e508 = (_e507 * 3u);
        let _e510 = (_e508 % 32u);
        let _e512 = p.member.light.mask_words;
        let _e514 = ((_e59.first_primitive * _e512) + (_e508 / 32u));
        let _e516 = bits.member[_e514];
        bits.member[_e514] = ((_e516 & ~((7u << bitcast<u32>((_e510 & 31u))))) | (_e502.bits << bitcast<u32>((_e510 & 31u))));
        if (_e510 > 29u) {
            let _e531 = bits.member[(_e514 + 1u)];
            let _e533 = (32u - _e510);
            bits.member[(_e514 + 1u)] = ((_e531 & ~((7u >> bitcast<u32>((_e533 & 31u))))) | (_e502.bits >> bitcast<u32>((_e533 & 31u))));
        }
        let _e548 = samples.member[_e59.first_primitive].normal[0u];
        let _e550 = global[0u];
        if (_e548 == _e550) {
            let _e553 = samples.member[_e59.first_primitive].normal[1u];
            let _e555 = global[1u];
            if (_e553 == _e555) {
                let _e558 = samples.member[_e59.first_primitive].normal[2u];
                let _e560 = global[2u];
                phi_837_ = (_e558 == _e560);
                phi_838_ = false;
            } else {
                phi_837_ = bool();
                phi_838_ = true;
            }
            let _e563 = phi_837_;
            let _e565 = phi_838_;
            phi_839_ = _e563;
            phi_840_ = _e565;
        } else {
            phi_839_ = bool();
            phi_840_ = true;
        }
        let _e567 = phi_839_;
        let _e569 = phi_840_;
        if _e569 {
            phi_844_ = false;
        } else {
            phi_844_ = _e567;
        }
        let _e571 = phi_844_;
        if !(_e571) {
            let _e574 = samples.member[_e59.first_primitive].position;
            let _e576 = p.member.current.eye;
            let _e587 = p.member.current.forward;
            phi_872_ = ((((_e574.x - _e576.x) * _e587.x) + ((_e574.y - _e576.y) * _e587.y)) + ((_e574.z - _e576.z) * _e587.z));
        } else {
            phi_872_ = 0f;
        }
        let _e597 = phi_872_;
        depths.member[_e59.first_primitive] = _e597;
        phi_875_ = _e502.needs_ray;
        phi_876_ = _e59.first_primitive;
    } else {
        phi_875_ = false;
        phi_876_ = 0u;
    }
    let _e601 = phi_875_;
    let _e603 = phi_876_;
    if (_e40 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e601 {
        let _e607 = atomicAdd((&shared_[0u]), 1u);
        phi_887_ = _e607;
    } else {
        phi_887_ = 0u;
    }
    let _e609 = phi_887_;
    workgroupBarrier();
    if (_e40 == 0u) {
        let _e613 = atomicLoad((&shared_[0u]));
        let _e614 = atomicAdd((&list.member[3u]), _e613);
        atomicStore((&shared_[1u]), _e614);
    }
    workgroupBarrier();
    if _e601 {
        let _e617 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e617) + _e609)]), _e603);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_depth_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
