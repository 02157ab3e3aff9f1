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
    var phi_141_: lt_bvh_traverse_Tree;
    var phi_142_: bool;
    var phi_143_: lt_bvh_traverse_Tree;
    var phi_144_: bool;
    var phi_149_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_141_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_142_ = false;
        } else {
            phi_141_ = lt_bvh_traverse_Tree();
            phi_142_ = true;
        }
        let _e48 = phi_141_;
        let _e50 = phi_142_;
        phi_143_ = _e48;
        phi_144_ = _e50;
    } else {
        phi_143_ = lt_bvh_traverse_Tree();
        phi_144_ = true;
    }
    let _e52 = phi_143_;
    let _e54 = phi_144_;
    if _e54 {
        phi_149_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_149_ = _e52;
    }
    let _e59 = phi_149_;
    return lt_bvh_traverse_Tree(_e59.root, _e59.first_primitive);
}

fn function_() {
    var phi_194_: u32;
    var phi_228_: bool;
    var phi_229_: bool;
    var phi_230_: bool;
    var phi_231_: bool;
    var phi_235_: bool;
    var phi_305_: bool;
    var phi_306_: bool;
    var phi_317_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_318_: bool;
    var phi_319_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_320_: bool;
    var phi_327_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_331_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_344_: bool;
    var phi_417_: u32;
    var phi_422_: u32;
    var phi_423_: u32;
    var phi_424_: u32;
    var phi_425_: bool;
    var phi_426_: u32;
    var phi_427_: bool;
    var phi_428_: bool;
    var phi_429_: u32;
    var phi_430_: bool;
    var phi_431_: bool;
    var phi_435_: bool;
    var phi_439_: u32;
    var phi_444_: bool;
    var phi_483_: lt_mask_Neighbourhood;
    var phi_484_: lt_mask_Neighbourhood;
    var phi_485_: lt_mask_Neighbourhood;
    var phi_517_: bool;
    var phi_518_: bool;
    var phi_540_: bool;
    var phi_541_: bool;
    var phi_542_: bool;
    var phi_546_: bool;
    var phi_568_: bool;
    var phi_569_: bool;
    var phi_582_: bool;
    var phi_583_: bool;
    var phi_584_: bool;
    var phi_591_: u32;
    var phi_592_: u32;
    var phi_593_: u32;
    var phi_594_: u32;
    var phi_595_: u32;
    var phi_596_: u32;
    var phi_597_: u32;
    var phi_609_: bool;
    var phi_610_: bool;
    var phi_611_: bool;
    var phi_612_: bool;
    var phi_616_: bool;
    var phi_622_: bool;
    var phi_630_: u32;
    var phi_635_: u32;
    var phi_644_: u32;
    var phi_649_: u32;
    var phi_653_: u32;
    var phi_654_: u32;
    var phi_655_: u32;
    var phi_659_: f32;
    var phi_661_: mask_Masked;
    var phi_711_: bool;
    var phi_712_: u32;
    var phi_723_: u32;

    let _e35 = id_1;
    let _e36 = local_1;
    let _e41 = arrayLength((&heard.member));
    let _e48 = p.member.current.size[0u];
    let _e50 = p.member.current.size[1u];
    let _e51 = lt_shaders_entry_pixel_index(_e35, _e48, _e50);
    if (bitcast<i32>(_e51.root) != 0i) {
        let _e59 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e61 = (_e59 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e59 % 32u) > 0u) {
            phi_194_ = (_e61 + 1u);
        } else {
            phi_194_ = _e61;
        }
        let _e67 = phi_194_;
        let _e72 = visibility.member[_e51.first_primitive];
        let _e78 = samples.member[_e51.first_primitive].normal[0u];
        let _e80 = global[0u];
        if (_e78 == _e80) {
            let _e83 = samples.member[_e51.first_primitive].normal[1u];
            let _e85 = global[1u];
            if (_e83 == _e85) {
                let _e88 = samples.member[_e51.first_primitive].normal[2u];
                let _e90 = global[2u];
                phi_228_ = (_e88 == _e90);
                phi_229_ = false;
            } else {
                phi_228_ = bool();
                phi_229_ = true;
            }
            let _e93 = phi_228_;
            let _e95 = phi_229_;
            phi_230_ = _e93;
            phi_231_ = _e95;
        } else {
            phi_230_ = bool();
            phi_231_ = true;
        }
        let _e97 = phi_230_;
        let _e99 = phi_231_;
        if _e99 {
            phi_235_ = false;
        } else {
            phi_235_ = _e97;
        }
        let _e101 = phi_235_;
        if !(_e101) {
            let _e104 = samples.member[_e51.first_primitive].position;
            let _e106 = p.member.light.place;
            let _e112 = p.member.light.place[3u];
            let _e119 = (_e106.x - (_e104.x * _e112));
            let _e120 = (_e106.y - (_e104.y * _e112));
            let _e121 = (_e106.z - (_e104.z * _e112));
            let _e123 = samples.member[_e51.first_primitive].normal;
            if ((((_e123.x * _e119) + (_e123.y * _e120)) + (_e123.z * _e121)) > 0f) {
                let _e137 = (((_e119 * _e119) + (_e120 * _e120)) + (_e121 * _e121));
                let _e139 = p.member.light.axis;
                let _e151 = p.member.light.place[3u];
                if (_e151 == 0f) {
                    phi_306_ = true;
                } else {
                    let _e154 = p.member.light.range_squared;
                    if (_e137 <= _e154) {
                        let _e157 = p.member.light.cos_outer;
                        phi_305_ = (-((((_e119 * _e139.x) + (_e120 * _e139.y)) + (_e121 * _e139.z))) >= (_e157 * sqrt(_e137)));
                    } else {
                        phi_305_ = false;
                    }
                    let _e162 = phi_305_;
                    phi_306_ = _e162;
                }
                let _e164 = phi_306_;
                if _e164 {
                    let _e166 = samples.member[_e51.first_primitive].flags;
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e174.unnamed.visibility, false), _e174.unnamed_1);
                    phi_317_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e180.unnamed, ((_e166 & 1u) == 0u));
                    phi_318_ = false;
                } else {
                    phi_317_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_318_ = true;
                }
                let _e185 = phi_317_;
                let _e187 = phi_318_;
                phi_319_ = _e185;
                phi_320_ = _e187;
            } else {
                phi_319_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_320_ = true;
            }
            let _e189 = phi_319_;
            let _e191 = phi_320_;
            if _e191 {
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e197.unnamed.visibility, false), _e197.unnamed_1);
                phi_327_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e203.unnamed, true);
            } else {
                phi_327_ = _e189;
            }
            let _e208 = phi_327_;
            phi_331_ = _e208;
        } else {
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e214.unnamed.visibility, false), _e214.unnamed_1);
            phi_331_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e220.unnamed, true);
        }
        let _e225 = phi_331_;
        if _e225.unnamed_1 {
            phi_661_ = mask_Masked(_e225.unnamed.visibility, 0u, false);
        } else {
            let _e230 = (_e72 < 0.5f);
            if (_e72 > 0f) {
                phi_344_ = (_e72 < 1f);
            } else {
                phi_344_ = false;
            }
            let _e234 = phi_344_;
            let _e236 = p.member.flags;
            let _e238 = ((_e236 & 1u) != 0u);
            let _e240 = p.member.flags;
            let _e242 = ((_e240 & 2u) != 0u);
            let _e244 = p.member.flags;
            if ((_e244 & 4u) == 0u) {
                phi_429_ = u32();
                phi_430_ = true;
                phi_431_ = false;
            } else {
                if _e238 {
                    if !(false) {
                        let _e252 = ((((_e35.y * _e67) + (_e35.x / 32u)) * 6u) + 4u);
                        if (_e252 < _e41) {
                        } else {
                            return;
                        }
                        let _e256 = heard.member[(0u + _e252)];
                        if (((_e256 >> bitcast<u32>(((_e35.x % 32u) & 31u))) & 1u) != 0u) {
                            let _e267 = ((((_e35.y * _e67) + (_e35.x / 32u)) * 6u) + 5u);
                            if (_e267 < _e41) {
                            } else {
                                return;
                            }
                            let _e271 = heard.member[(0u + _e267)];
                            if false {
                                phi_417_ = (2u | 1u);
                            } else {
                                phi_417_ = 2u;
                            }
                            let _e280 = phi_417_;
                            if (((_e271 >> bitcast<u32>(((_e35.x % 32u) & 31u))) & 1u) != 0u) {
                                phi_422_ = (_e280 | 4u);
                            } else {
                                phi_422_ = _e280;
                            }
                            let _e283 = phi_422_;
                            phi_423_ = _e283;
                        } else {
                            phi_423_ = 0u;
                        }
                        let _e285 = phi_423_;
                        phi_424_ = _e285;
                        phi_425_ = false;
                    } else {
                        phi_424_ = u32();
                        phi_425_ = true;
                    }
                    let _e287 = phi_424_;
                    let _e289 = phi_425_;
                    phi_426_ = _e287;
                    phi_427_ = false;
                    phi_428_ = _e289;
                } else {
                    phi_426_ = u32();
                    phi_427_ = true;
                    phi_428_ = false;
                }
                let _e291 = phi_426_;
                let _e293 = phi_427_;
                let _e295 = phi_428_;
                phi_429_ = _e291;
                phi_430_ = _e293;
                phi_431_ = _e295;
            }
            let _e297 = phi_429_;
            let _e299 = phi_430_;
            let _e301 = phi_431_;
            if _e299 {
                phi_435_ = true;
            } else {
                phi_435_ = _e301;
            }
            let _e303 = phi_435_;
            if _e303 {
                phi_439_ = 0u;
            } else {
                phi_439_ = _e297;
            }
            let _e305 = phi_439_;
            let _e306 = lt_mask_Neighbourhood(false, true);
            if _e234 {
                phi_444_ = _e242;
            } else {
                phi_444_ = true;
            }
            let _e308 = phi_444_;
            if _e308 {
                if _e238 {
                    if ((_e305 & 2u) != 0u) {
                        phi_483_ = _e306;
                    } else {
                        let _e320 = ((((_e35.y * _e67) + (_e35.x / 32u)) * 6u) + (select(0u, 1u, _e230) | (select(0u, 1u, false) << bitcast<u32>(1i))));
                        if (_e320 < _e41) {
                        } else {
                            return;
                        }
                        let _e324 = heard.member[(0u + _e320)];
                        let _e330 = (((_e324 >> bitcast<u32>(((_e35.x % 32u) & 31u))) & 1u) != 0u);
                        phi_483_ = lt_mask_Neighbourhood(_e330, !(_e330));
                    }
                    let _e334 = phi_483_;
                    phi_484_ = _e334;
                } else {
                    phi_484_ = _e306;
                }
                let _e336 = phi_484_;
                phi_485_ = _e336;
            } else {
                phi_485_ = _e306;
            }
            let _e338 = phi_485_;
            let _e341 = p.member.frame;
            let _e343 = p.member.refresh;
            if (_e343 == 0u) {
                phi_518_ = false;
            } else {
                if (_e343 == 0u) {
                    return;
                }
                let _e352 = ((_e35.x + (_e35.y * (((_e343 * 5u) / 8u) | 1u))) + (_e341 % _e343));
                if (_e343 == 0u) {
                    phi_517_ = (_e352 == 0u);
                } else {
                    if (_e343 == 0u) {
                        return;
                    }
                    phi_517_ = ((_e352 % _e343) == 0u);
                }
                let _e359 = phi_517_;
                phi_518_ = _e359;
            }
            let _e361 = phi_518_;
            if _e238 {
                if _e361 {
                    phi_540_ = bool();
                } else {
                    phi_540_ = ((_e305 & 2u) != 0u);
                }
                let _e367 = phi_540_;
                phi_541_ = _e367;
                phi_542_ = _e361;
            } else {
                phi_541_ = bool();
                phi_542_ = true;
            }
            let _e369 = phi_541_;
            let _e371 = phi_542_;
            if _e371 {
                phi_546_ = false;
            } else {
                phi_546_ = _e369;
            }
            let _e373 = phi_546_;
            if _e373 {
                phi_597_ = 7u;
            } else {
                if (_e72 != 0.5f) {
                    if _e238 {
                        if _e361 {
                            phi_594_ = 6u;
                        } else {
                            if _e234 {
                                phi_569_ = true;
                            } else {
                                if _e338.any_expands {
                                    phi_568_ = false;
                                } else {
                                    phi_568_ = true;
                                }
                                let _e375 = phi_568_;
                                phi_569_ = _e375;
                            }
                            let _e377 = phi_569_;
                            if _e377 {
                                if _e234 {
                                    if _e242 {
                                        if _e338.all_remove {
                                            phi_582_ = false;
                                        } else {
                                            phi_582_ = true;
                                        }
                                        let _e379 = phi_582_;
                                        phi_583_ = _e379;
                                    } else {
                                        phi_583_ = true;
                                    }
                                    let _e381 = phi_583_;
                                    phi_584_ = _e381;
                                } else {
                                    phi_584_ = true;
                                }
                                let _e383 = phi_584_;
                                if _e383 {
                                    if _e234 {
                                        phi_591_ = 1u;
                                    } else {
                                        phi_591_ = 0u;
                                    }
                                    let _e385 = phi_591_;
                                    phi_592_ = _e385;
                                } else {
                                    phi_592_ = 5u;
                                }
                                let _e387 = phi_592_;
                                phi_593_ = _e387;
                            } else {
                                phi_593_ = 4u;
                            }
                            let _e389 = phi_593_;
                            phi_594_ = _e389;
                        }
                        let _e391 = phi_594_;
                        phi_595_ = _e391;
                    } else {
                        phi_595_ = 3u;
                    }
                    let _e393 = phi_595_;
                    phi_596_ = _e393;
                } else {
                    phi_596_ = 2u;
                }
                let _e395 = phi_596_;
                phi_597_ = _e395;
            }
            let _e397 = phi_597_;
            if !((_e397 == 0u)) {
                if !((_e397 == 5u)) {
                    phi_609_ = !(_e373);
                    phi_610_ = false;
                } else {
                    phi_609_ = bool();
                    phi_610_ = true;
                }
                let _e404 = phi_609_;
                let _e406 = phi_610_;
                phi_611_ = _e404;
                phi_612_ = _e406;
            } else {
                phi_611_ = bool();
                phi_612_ = true;
            }
            let _e408 = phi_611_;
            let _e410 = phi_612_;
            if _e410 {
                phi_616_ = false;
            } else {
                phi_616_ = _e408;
            }
            let _e412 = phi_616_;
            if _e373 {
                phi_622_ = ((_e305 & 4u) != 0u);
            } else {
                phi_622_ = _e230;
            }
            let _e416 = phi_622_;
            if _e412 {
                if _e230 {
                    phi_630_ = (2u | 1u);
                } else {
                    phi_630_ = 2u;
                }
                let _e419 = phi_630_;
                if false {
                    phi_635_ = (_e419 | 4u);
                } else {
                    phi_635_ = _e419;
                }
                let _e422 = phi_635_;
                phi_655_ = _e422;
            } else {
                if (_e397 == 7u) {
                    if _e230 {
                        phi_644_ = (2u | 1u);
                    } else {
                        phi_644_ = 2u;
                    }
                    let _e426 = phi_644_;
                    if _e416 {
                        phi_649_ = (_e426 | 4u);
                    } else {
                        phi_649_ = _e426;
                    }
                    let _e429 = phi_649_;
                    phi_654_ = _e429;
                } else {
                    if _e230 {
                        phi_653_ = 1u;
                    } else {
                        phi_653_ = 0u;
                    }
                    let _e431 = phi_653_;
                    phi_654_ = _e431;
                }
                let _e433 = phi_654_;
                phi_655_ = _e433;
            }
            let _e435 = phi_655_;
            if _e416 {
                phi_659_ = 0f;
            } else {
                phi_659_ = 1f;
            }
            let _e437 = phi_659_;
            phi_661_ = mask_Masked(_e437, _e435, _e412);
        }
        let _e440 = phi_661_;
        visibility.member[_e51.first_primitive] = _e440.visibility;
        let _e445 = p.member.light.number;
        let _e446 = (_e445 * 3u);
        let _e448 = (_e446 % 32u);
        let _e450 = p.member.light.mask_words;
        let _e452 = ((_e51.first_primitive * _e450) + (_e446 / 32u));
        let _e454 = bits.member[_e452];
        bits.member[_e452] = ((_e454 & ~((7u << bitcast<u32>((_e448 & 31u))))) | (_e440.bits << bitcast<u32>((_e448 & 31u))));
        if (_e448 > 29u) {
            let _e469 = bits.member[(_e452 + 1u)];
            let _e471 = (32u - _e448);
            bits.member[(_e452 + 1u)] = ((_e469 & ~((7u >> bitcast<u32>((_e471 & 31u))))) | (_e440.bits >> bitcast<u32>((_e471 & 31u))));
        }
        phi_711_ = _e440.needs_ray;
        phi_712_ = _e51.first_primitive;
    } else {
        phi_711_ = false;
        phi_712_ = 0u;
    }
    let _e485 = phi_711_;
    let _e487 = phi_712_;
    if (_e36 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e485 {
        let _e491 = atomicAdd((&shared_[0u]), 1u);
        phi_723_ = _e491;
    } else {
        phi_723_ = 0u;
    }
    let _e493 = phi_723_;
    workgroupBarrier();
    if (_e36 == 0u) {
        let _e497 = atomicLoad((&shared_[0u]));
        let _e498 = atomicAdd((&list.member[3u]), _e497);
        atomicStore((&shared_[1u]), _e498);
    }
    workgroupBarrier();
    if _e485 {
        let _e501 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e501) + _e493)]), _e487);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
