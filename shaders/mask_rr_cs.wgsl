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

struct type_42 {
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
var<storage, read_write> list: type_42;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;

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
        let _e51 = phi_146_;
        let _e53 = phi_147_;
        phi_148_ = _e51;
        phi_149_ = _e53;
    } else {
        phi_148_ = lt_bvh_traverse_Tree();
        phi_149_ = true;
    }
    let _e55 = phi_148_;
    let _e57 = phi_149_;
    if _e57 {
        phi_154_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_154_ = _e55;
    }
    let _e62 = phi_154_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn function_() {
    var phi_200_: u32;
    var phi_234_: bool;
    var phi_235_: bool;
    var phi_236_: bool;
    var phi_237_: bool;
    var phi_241_: bool;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_323_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_324_: bool;
    var phi_325_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_326_: bool;
    var phi_333_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_337_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_350_: bool;
    var phi_423_: u32;
    var phi_428_: u32;
    var phi_429_: u32;
    var phi_430_: u32;
    var phi_431_: bool;
    var phi_432_: u32;
    var phi_433_: bool;
    var phi_434_: bool;
    var phi_435_: u32;
    var phi_436_: bool;
    var phi_437_: bool;
    var phi_441_: bool;
    var phi_445_: u32;
    var phi_450_: bool;
    var phi_489_: lt_mask_Neighbourhood;
    var phi_490_: lt_mask_Neighbourhood;
    var phi_491_: lt_mask_Neighbourhood;
    var phi_523_: bool;
    var phi_524_: bool;
    var phi_546_: bool;
    var phi_547_: bool;
    var phi_548_: bool;
    var phi_552_: bool;
    var phi_574_: bool;
    var phi_575_: bool;
    var phi_588_: bool;
    var phi_589_: bool;
    var phi_590_: bool;
    var phi_597_: u32;
    var phi_598_: u32;
    var phi_599_: u32;
    var phi_600_: u32;
    var phi_601_: u32;
    var phi_602_: u32;
    var phi_603_: u32;
    var phi_615_: bool;
    var phi_616_: bool;
    var phi_617_: bool;
    var phi_618_: bool;
    var phi_622_: bool;
    var phi_628_: bool;
    var phi_636_: u32;
    var phi_641_: u32;
    var phi_650_: u32;
    var phi_655_: u32;
    var phi_659_: u32;
    var phi_660_: u32;
    var phi_661_: u32;
    var phi_665_: f32;
    var phi_674_: bool;
    var phi_675_: bool;
    var phi_677_: mask_Masked;
    var phi_729_: doubt_Listed;
    var phi_730_: bool;
    var phi_743_: u32;
    var phi_760_: u32;

    let _e38 = id_1;
    let _e39 = local_1;
    let _e44 = arrayLength((&heard.member));
    let _e52 = p.member.current.size[0u];
    let _e54 = p.member.current.size[1u];
    let _e55 = lt_shaders_entry_pixel_index(_e38, _e52, _e54);
    if (bitcast<i32>(_e55.root) != 0i) {
        let _e63 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e65 = (_e63 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e63 % 32u) > 0u) {
            phi_200_ = (_e65 + 1u);
        } else {
            phi_200_ = _e65;
        }
        let _e71 = phi_200_;
        let _e76 = visibility.member[_e55.first_primitive];
        let _e82 = samples.member[_e55.first_primitive].normal[0u];
        let _e84 = global[0u];
        if (_e82 == _e84) {
            let _e87 = samples.member[_e55.first_primitive].normal[1u];
            let _e89 = global[1u];
            if (_e87 == _e89) {
                let _e92 = samples.member[_e55.first_primitive].normal[2u];
                let _e94 = global[2u];
                phi_234_ = (_e92 == _e94);
                phi_235_ = false;
            } else {
                phi_234_ = bool();
                phi_235_ = true;
            }
            let _e97 = phi_234_;
            let _e99 = phi_235_;
            phi_236_ = _e97;
            phi_237_ = _e99;
        } else {
            phi_236_ = bool();
            phi_237_ = true;
        }
        let _e101 = phi_236_;
        let _e103 = phi_237_;
        if _e103 {
            phi_241_ = false;
        } else {
            phi_241_ = _e101;
        }
        let _e105 = phi_241_;
        if !(_e105) {
            let _e108 = samples.member[_e55.first_primitive].position;
            let _e110 = p.member.light.place;
            let _e116 = p.member.light.place[3u];
            let _e123 = (_e110.x - (_e108.x * _e116));
            let _e124 = (_e110.y - (_e108.y * _e116));
            let _e125 = (_e110.z - (_e108.z * _e116));
            let _e127 = samples.member[_e55.first_primitive].normal;
            if ((((_e127.x * _e123) + (_e127.y * _e124)) + (_e127.z * _e125)) > 0f) {
                let _e141 = (((_e123 * _e123) + (_e124 * _e124)) + (_e125 * _e125));
                let _e143 = p.member.light.axis;
                let _e155 = p.member.light.place[3u];
                if (_e155 == 0f) {
                    phi_312_ = true;
                } else {
                    let _e158 = p.member.light.range_squared;
                    if (_e141 <= _e158) {
                        let _e161 = p.member.light.cos_outer;
                        phi_311_ = (-((((_e123 * _e143.x) + (_e124 * _e143.y)) + (_e125 * _e143.z))) >= (_e161 * sqrt(_e141)));
                    } else {
                        phi_311_ = false;
                    }
                    let _e166 = phi_311_;
                    phi_312_ = _e166;
                }
                let _e168 = phi_312_;
                if _e168 {
                    let _e170 = samples.member[_e55.first_primitive].flags;
                    let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e178.unnamed.visibility, false), _e178.unnamed_1);
                    phi_323_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e184.unnamed, ((_e170 & 1u) == 0u));
                    phi_324_ = false;
                } else {
                    phi_323_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_324_ = true;
                }
                let _e189 = phi_323_;
                let _e191 = phi_324_;
                phi_325_ = _e189;
                phi_326_ = _e191;
            } else {
                phi_325_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_326_ = true;
            }
            let _e193 = phi_325_;
            let _e195 = phi_326_;
            if _e195 {
                let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e201.unnamed.visibility, false), _e201.unnamed_1);
                phi_333_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e207.unnamed, true);
            } else {
                phi_333_ = _e193;
            }
            let _e212 = phi_333_;
            phi_337_ = _e212;
        } else {
            let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e224 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e218.unnamed.visibility, false), _e218.unnamed_1);
            phi_337_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e224.unnamed, true);
        }
        let _e229 = phi_337_;
        if _e229.unnamed_1 {
            phi_677_ = mask_Masked(_e229.unnamed.visibility, 0u, false, false);
        } else {
            let _e234 = (_e76 < 0.5f);
            if (_e76 > 0f) {
                phi_350_ = (_e76 < 1f);
            } else {
                phi_350_ = false;
            }
            let _e238 = phi_350_;
            let _e240 = p.member.flags;
            let _e242 = ((_e240 & 1u) != 0u);
            let _e244 = p.member.flags;
            let _e246 = ((_e244 & 2u) != 0u);
            let _e248 = p.member.flags;
            if ((_e248 & 4u) == 0u) {
                phi_435_ = u32();
                phi_436_ = true;
                phi_437_ = false;
            } else {
                if _e242 {
                    if !(false) {
                        let _e256 = ((((_e38.y * _e71) + (_e38.x / 32u)) * 6u) + 4u);
                        if (_e256 < _e44) {
                        } else {
                            return;
                        }
                        let _e260 = heard.member[(0u + _e256)];
                        if (((_e260 >> bitcast<u32>(((_e38.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e271 = ((((_e38.y * _e71) + (_e38.x / 32u)) * 6u) + 5u);
                            if (_e271 < _e44) {
                            } else {
                                return;
                            }
                            let _e275 = heard.member[(0u + _e271)];
                            if false {
                                phi_423_ = (2u | 1u);
                            } else {
                                phi_423_ = 2u;
                            }
                            let _e284 = phi_423_;
                            if (((_e275 >> bitcast<u32>(((_e38.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_428_ = (_e284 | 4u);
                            } else {
                                phi_428_ = _e284;
                            }
                            let _e287 = phi_428_;
                            phi_429_ = _e287;
                        } else {
                            phi_429_ = 0u;
                        }
                        let _e289 = phi_429_;
                        phi_430_ = _e289;
                        phi_431_ = false;
                    } else {
                        phi_430_ = u32();
                        phi_431_ = true;
                    }
                    let _e291 = phi_430_;
                    let _e293 = phi_431_;
                    phi_432_ = _e291;
                    phi_433_ = false;
                    phi_434_ = _e293;
                } else {
                    phi_432_ = u32();
                    phi_433_ = true;
                    phi_434_ = false;
                }
                let _e295 = phi_432_;
                let _e297 = phi_433_;
                let _e299 = phi_434_;
                phi_435_ = _e295;
                phi_436_ = _e297;
                phi_437_ = _e299;
            }
            let _e301 = phi_435_;
            let _e303 = phi_436_;
            let _e305 = phi_437_;
            if _e303 {
                phi_441_ = true;
            } else {
                phi_441_ = _e305;
            }
            let _e307 = phi_441_;
            if _e307 {
                phi_445_ = 0u;
            } else {
                phi_445_ = _e301;
            }
            let _e309 = phi_445_;
            let _e310 = lt_mask_Neighbourhood(false, true);
            if _e238 {
                phi_450_ = _e246;
            } else {
                phi_450_ = false;
            }
            let _e312 = phi_450_;
            if _e312 {
                if _e242 {
                    if ((_e309 & 2u) != 0u) {
                        phi_489_ = _e310;
                    } else {
                        let _e324 = ((((_e38.y * _e71) + (_e38.x / 32u)) * 6u) + (select(0u, 1u, _e234) | (select(0u, 1u, false) << bitcast<u32>(1i))));
                        if (_e324 < _e44) {
                        } else {
                            return;
                        }
                        let _e328 = heard.member[(0u + _e324)];
                        let _e334 = (((_e328 >> bitcast<u32>(((_e38.x % 32u) & 31u))) & 1u) != 0u);
                        phi_489_ = lt_mask_Neighbourhood(_e334, !(_e334));
                    }
                    let _e338 = phi_489_;
                    phi_490_ = _e338;
                } else {
                    phi_490_ = _e310;
                }
                let _e340 = phi_490_;
                phi_491_ = _e340;
            } else {
                phi_491_ = _e310;
            }
            let _e342 = phi_491_;
            let _e345 = p.member.frame;
            let _e347 = p.member.refresh;
            if (_e347 == 0u) {
                phi_524_ = false;
            } else {
                if (_e347 == 0u) {
                    return;
                }
                let _e356 = ((_e38.x + (_e38.y * (((_e347 * 5u) / 8u) | 1u))) + (_e345 % _e347));
                if (_e347 == 0u) {
                    phi_523_ = (_e356 == 0u);
                } else {
                    if (_e347 == 0u) {
                        return;
                    }
                    phi_523_ = ((_e356 % _e347) == 0u);
                }
                let _e363 = phi_523_;
                phi_524_ = _e363;
            }
            let _e365 = phi_524_;
            if _e242 {
                if _e365 {
                    phi_546_ = bool();
                } else {
                    phi_546_ = ((_e309 & 2u) != 0u);
                }
                let _e371 = phi_546_;
                phi_547_ = _e371;
                phi_548_ = _e365;
            } else {
                phi_547_ = bool();
                phi_548_ = true;
            }
            let _e373 = phi_547_;
            let _e375 = phi_548_;
            if _e375 {
                phi_552_ = false;
            } else {
                phi_552_ = _e373;
            }
            let _e377 = phi_552_;
            if _e377 {
                phi_603_ = 7u;
            } else {
                if (_e76 != 0.5f) {
                    if _e242 {
                        if _e365 {
                            phi_600_ = 6u;
                        } else {
                            if _e238 {
                                phi_575_ = true;
                            } else {
                                if _e342.any_expands {
                                    phi_574_ = false;
                                } else {
                                    phi_574_ = true;
                                }
                                let _e379 = phi_574_;
                                phi_575_ = _e379;
                            }
                            let _e381 = phi_575_;
                            if _e381 {
                                if _e238 {
                                    if _e246 {
                                        if _e342.all_remove {
                                            phi_588_ = false;
                                        } else {
                                            phi_588_ = true;
                                        }
                                        let _e383 = phi_588_;
                                        phi_589_ = _e383;
                                    } else {
                                        phi_589_ = true;
                                    }
                                    let _e385 = phi_589_;
                                    phi_590_ = _e385;
                                } else {
                                    phi_590_ = true;
                                }
                                let _e387 = phi_590_;
                                if _e387 {
                                    if _e238 {
                                        phi_597_ = 1u;
                                    } else {
                                        phi_597_ = 0u;
                                    }
                                    let _e389 = phi_597_;
                                    phi_598_ = _e389;
                                } else {
                                    phi_598_ = 5u;
                                }
                                let _e391 = phi_598_;
                                phi_599_ = _e391;
                            } else {
                                phi_599_ = 4u;
                            }
                            let _e393 = phi_599_;
                            phi_600_ = _e393;
                        }
                        let _e395 = phi_600_;
                        phi_601_ = _e395;
                    } else {
                        phi_601_ = 3u;
                    }
                    let _e397 = phi_601_;
                    phi_602_ = _e397;
                } else {
                    phi_602_ = 2u;
                }
                let _e399 = phi_602_;
                phi_603_ = _e399;
            }
            let _e401 = phi_603_;
            if !((_e401 == 0u)) {
                if !((_e401 == 5u)) {
                    phi_615_ = !(_e377);
                    phi_616_ = false;
                } else {
                    phi_615_ = bool();
                    phi_616_ = true;
                }
                let _e408 = phi_615_;
                let _e410 = phi_616_;
                phi_617_ = _e408;
                phi_618_ = _e410;
            } else {
                phi_617_ = bool();
                phi_618_ = true;
            }
            let _e412 = phi_617_;
            let _e414 = phi_618_;
            if _e414 {
                phi_622_ = false;
            } else {
                phi_622_ = _e412;
            }
            let _e416 = phi_622_;
            if _e377 {
                phi_628_ = ((_e309 & 4u) != 0u);
            } else {
                phi_628_ = _e234;
            }
            let _e420 = phi_628_;
            if _e416 {
                if _e234 {
                    phi_636_ = (2u | 1u);
                } else {
                    phi_636_ = 2u;
                }
                let _e423 = phi_636_;
                if false {
                    phi_641_ = (_e423 | 4u);
                } else {
                    phi_641_ = _e423;
                }
                let _e426 = phi_641_;
                phi_661_ = _e426;
            } else {
                if (_e401 == 7u) {
                    if _e234 {
                        phi_650_ = (2u | 1u);
                    } else {
                        phi_650_ = 2u;
                    }
                    let _e430 = phi_650_;
                    if _e420 {
                        phi_655_ = (_e430 | 4u);
                    } else {
                        phi_655_ = _e430;
                    }
                    let _e433 = phi_655_;
                    phi_660_ = _e433;
                } else {
                    if _e234 {
                        phi_659_ = 1u;
                    } else {
                        phi_659_ = 0u;
                    }
                    let _e435 = phi_659_;
                    phi_660_ = _e435;
                }
                let _e437 = phi_660_;
                phi_661_ = _e437;
            }
            let _e439 = phi_661_;
            if _e420 {
                phi_665_ = 0f;
            } else {
                phi_665_ = 1f;
            }
            let _e441 = phi_665_;
            if _e238 {
                if (_e76 == 0.99999994f) {
                    phi_674_ = true;
                } else {
                    phi_674_ = (_e76 == 0.000000059604645f);
                }
                let _e445 = phi_674_;
                phi_675_ = _e445;
            } else {
                phi_675_ = true;
            }
            let _e447 = phi_675_;
            phi_677_ = mask_Masked(_e441, _e439, _e416, _e447);
        }
        let _e450 = phi_677_;
        visibility.member[_e55.first_primitive] = _e450.visibility;
        let _e455 = p.member.light.number;
        let _e456 = (_e455 * 3u);
        let _e458 = (_e456 % 32u);
        let _e460 = p.member.light.mask_words;
        let _e462 = ((_e55.first_primitive * _e460) + (_e456 / 32u));
        let _e464 = bits.member[_e462];
        bits.member[_e462] = ((_e464 & ~((7u << bitcast<u32>((_e458 & 31u))))) | (_e450.bits << bitcast<u32>((_e458 & 31u))));
        if (_e458 > 29u) {
            let _e479 = bits.member[(_e462 + 1u)];
            let _e481 = (32u - _e458);
            bits.member[(_e462 + 1u)] = ((_e479 & ~((7u >> bitcast<u32>((_e481 & 31u))))) | (_e450.bits >> bitcast<u32>((_e481 & 31u))));
        }
        phi_729_ = doubt_Listed(_e55.first_primitive, _e450.is_trusted);
        phi_730_ = _e450.needs_ray;
    } else {
        phi_729_ = doubt_Listed(0u, false);
        phi_730_ = false;
    }
    let _e497 = phi_729_;
    let _e499 = phi_730_;
    if (_e39 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e499 {
        let _e505 = atomicAdd((&shared_[0u]), 1u);
        phi_743_ = _e505;
    } else {
        phi_743_ = 0u;
    }
    let _e507 = phi_743_;
    workgroupBarrier();
    if (_e39 == 0u) {
        let _e511 = atomicLoad((&shared_[0u]));
        let _e512 = atomicAdd((&list.member[3u]), _e511);
        atomicStore((&shared_[1u]), _e512);
    }
    workgroupBarrier();
    if _e499 {
        if _e497.is_trusted {
            phi_760_ = (_e497.pixel | 2147483648u);
        } else {
            phi_760_ = _e497.pixel;
        }
        let _e516 = phi_760_;
        let _e518 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e518) + _e507)]), _e516);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
