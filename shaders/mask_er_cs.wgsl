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
    var phi_667_: lt_bvh_traverse_Tree;
    var phi_668_: bool;
    var phi_669_: lt_bvh_traverse_Tree;
    var phi_670_: bool;
    var phi_675_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_667_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_668_ = false;
        } else {
            phi_667_ = lt_bvh_traverse_Tree();
            phi_668_ = true;
        }
        let _e50 = phi_667_;
        let _e52 = phi_668_;
        phi_669_ = _e50;
        phi_670_ = _e52;
    } else {
        phi_669_ = lt_bvh_traverse_Tree();
        phi_670_ = true;
    }
    let _e54 = phi_669_;
    let _e56 = phi_670_;
    if _e56 {
        phi_675_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_675_ = _e54;
    }
    let _e61 = phi_675_;
    return lt_bvh_traverse_Tree(_e61.root, _e61.first_primitive);
}

fn function_() {
    var phi_168_: u32;
    var phi_202_: bool;
    var phi_203_: bool;
    var phi_204_: bool;
    var phi_205_: bool;
    var phi_209_: bool;
    var phi_279_: bool;
    var phi_280_: bool;
    var phi_291_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_292_: bool;
    var phi_293_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_294_: bool;
    var phi_301_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_305_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_318_: bool;
    var phi_332_: bool;
    var phi_371_: lt_mask_Neighbourhood;
    var phi_372_: lt_mask_Neighbourhood;
    var phi_373_: lt_mask_Neighbourhood;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_428_: bool;
    var phi_429_: bool;
    var phi_430_: bool;
    var phi_434_: bool;
    var phi_456_: bool;
    var phi_457_: bool;
    var phi_470_: bool;
    var phi_471_: bool;
    var phi_472_: bool;
    var phi_479_: u32;
    var phi_480_: u32;
    var phi_481_: u32;
    var phi_482_: u32;
    var phi_483_: u32;
    var phi_484_: u32;
    var phi_485_: u32;
    var phi_497_: bool;
    var phi_498_: bool;
    var phi_499_: bool;
    var phi_500_: bool;
    var phi_504_: bool;
    var phi_510_: bool;
    var phi_518_: u32;
    var phi_523_: u32;
    var phi_532_: u32;
    var phi_537_: u32;
    var phi_541_: u32;
    var phi_542_: u32;
    var phi_543_: u32;
    var phi_547_: f32;
    var phi_556_: bool;
    var phi_557_: bool;
    var phi_559_: mask_Masked;
    var phi_611_: doubt_Listed;
    var phi_612_: bool;
    var phi_625_: u32;
    var phi_642_: u32;

    let _e37 = id_1;
    let _e38 = local_1;
    let _e51 = p.member.current.size[0u];
    let _e53 = p.member.current.size[1u];
    let _e54 = lt_shaders_entry_pixel_index(_e37, _e51, _e53);
    if (bitcast<i32>(_e54.root) != 0i) {
        let _e62 = p.member.current.size[0u];
        if (32u == 0u) {
            return;
        }
        let _e64 = (_e62 / 32u);
        if (32u == 0u) {
            return;
        }
        if ((_e62 % 32u) > 0u) {
            phi_168_ = (_e64 + 1u);
        } else {
            phi_168_ = _e64;
        }
        let _e70 = phi_168_;
        let _e75 = visibility.member[_e54.first_primitive];
        let _e81 = samples.member[_e54.first_primitive].normal[0u];
        let _e83 = global[0u];
        if (_e81 == _e83) {
            let _e86 = samples.member[_e54.first_primitive].normal[1u];
            let _e88 = global[1u];
            if (_e86 == _e88) {
                let _e91 = samples.member[_e54.first_primitive].normal[2u];
                let _e93 = global[2u];
                phi_202_ = (_e91 == _e93);
                phi_203_ = false;
            } else {
                phi_202_ = bool();
                phi_203_ = true;
            }
            let _e96 = phi_202_;
            let _e98 = phi_203_;
            phi_204_ = _e96;
            phi_205_ = _e98;
        } else {
            phi_204_ = bool();
            phi_205_ = true;
        }
        let _e100 = phi_204_;
        let _e102 = phi_205_;
        if _e102 {
            phi_209_ = false;
        } else {
            phi_209_ = _e100;
        }
        let _e104 = phi_209_;
        if !(_e104) {
            let _e107 = samples.member[_e54.first_primitive].position;
            let _e109 = p.member.light.place;
            let _e115 = p.member.light.place[3u];
            let _e122 = (_e109.x - (_e107.x * _e115));
            let _e123 = (_e109.y - (_e107.y * _e115));
            let _e124 = (_e109.z - (_e107.z * _e115));
            let _e126 = samples.member[_e54.first_primitive].normal;
            if ((((_e126.x * _e122) + (_e126.y * _e123)) + (_e126.z * _e124)) > 0f) {
                let _e140 = (((_e122 * _e122) + (_e123 * _e123)) + (_e124 * _e124));
                let _e142 = p.member.light.axis;
                let _e154 = p.member.light.place[3u];
                if (_e154 == 0f) {
                    phi_280_ = true;
                } else {
                    let _e157 = p.member.light.range_squared;
                    if (_e140 <= _e157) {
                        let _e160 = p.member.light.cos_outer;
                        phi_279_ = (-((((_e122 * _e142.x) + (_e123 * _e142.y)) + (_e124 * _e142.z))) >= (_e160 * sqrt(_e140)));
                    } else {
                        phi_279_ = false;
                    }
                    let _e165 = phi_279_;
                    phi_280_ = _e165;
                }
                let _e167 = phi_280_;
                if _e167 {
                    let _e169 = samples.member[_e54.first_primitive].flags;
                    let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e177.unnamed.visibility, false), _e177.unnamed_1);
                    phi_291_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e183.unnamed, ((_e169 & 1u) == 0u));
                    phi_292_ = false;
                } else {
                    phi_291_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_292_ = true;
                }
                let _e188 = phi_291_;
                let _e190 = phi_292_;
                phi_293_ = _e188;
                phi_294_ = _e190;
            } else {
                phi_293_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_294_ = true;
            }
            let _e192 = phi_293_;
            let _e194 = phi_294_;
            if _e194 {
                let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e200.unnamed.visibility, false), _e200.unnamed_1);
                phi_301_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e206.unnamed, true);
            } else {
                phi_301_ = _e192;
            }
            let _e211 = phi_301_;
            phi_305_ = _e211;
        } else {
            let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e223 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e217.unnamed.visibility, false), _e217.unnamed_1);
            phi_305_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e223.unnamed, true);
        }
        let _e228 = phi_305_;
        if _e228.unnamed_1 {
            phi_559_ = mask_Masked(_e228.unnamed.visibility, 0u, false, false);
        } else {
            let _e233 = (_e75 < 0.5f);
            if (_e75 > 0f) {
                phi_318_ = (_e75 < 1f);
            } else {
                phi_318_ = false;
            }
            let _e237 = phi_318_;
            let _e239 = p.member.flags;
            let _e241 = ((_e239 & 1u) != 0u);
            let _e242 = lt_mask_Neighbourhood(false, true);
            if _e237 {
                phi_332_ = false;
            } else {
                phi_332_ = true;
            }
            let _e244 = phi_332_;
            if _e244 {
                if _e241 {
                    if ((0u & 2u) != 0u) {
                        phi_371_ = _e242;
                    } else {
                        let _e256 = ((((_e37.y * _e70) + (_e37.x / 32u)) * 6u) + (select(0u, 1u, _e233) | (select(0u, 1u, false) << bitcast<u32>(1i))));
                        if (_e256 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e260 = heard.member[(0u + _e256)];
                        let _e266 = (((_e260 >> bitcast<u32>(((_e37.x % 32u) & 31u))) & 1u) != 0u);
                        phi_371_ = lt_mask_Neighbourhood(_e266, !(_e266));
                    }
                    let _e270 = phi_371_;
                    phi_372_ = _e270;
                } else {
                    phi_372_ = _e242;
                }
                let _e272 = phi_372_;
                phi_373_ = _e272;
            } else {
                phi_373_ = _e242;
            }
            let _e274 = phi_373_;
            let _e277 = p.member.frame;
            let _e279 = p.member.refresh;
            if (_e279 == 0u) {
                phi_406_ = false;
            } else {
                if (_e279 == 0u) {
                    return;
                }
                let _e288 = ((_e37.x + (_e37.y * (((_e279 * 5u) / 8u) | 1u))) + (_e277 % _e279));
                if (_e279 == 0u) {
                    phi_405_ = (_e288 == 0u);
                } else {
                    if (_e279 == 0u) {
                        return;
                    }
                    phi_405_ = ((_e288 % _e279) == 0u);
                }
                let _e295 = phi_405_;
                phi_406_ = _e295;
            }
            let _e297 = phi_406_;
            if _e241 {
                if _e297 {
                    phi_428_ = bool();
                } else {
                    phi_428_ = ((0u & 2u) != 0u);
                }
                let _e303 = phi_428_;
                phi_429_ = _e303;
                phi_430_ = _e297;
            } else {
                phi_429_ = bool();
                phi_430_ = true;
            }
            let _e305 = phi_429_;
            let _e307 = phi_430_;
            if _e307 {
                phi_434_ = false;
            } else {
                phi_434_ = _e305;
            }
            let _e309 = phi_434_;
            if _e309 {
                phi_485_ = 7u;
            } else {
                if (_e75 != 0.5f) {
                    if _e241 {
                        if _e297 {
                            phi_482_ = 6u;
                        } else {
                            if _e237 {
                                phi_457_ = true;
                            } else {
                                if _e274.any_expands {
                                    phi_456_ = false;
                                } else {
                                    phi_456_ = true;
                                }
                                let _e311 = phi_456_;
                                phi_457_ = _e311;
                            }
                            let _e313 = phi_457_;
                            if _e313 {
                                if _e237 {
                                    if false {
                                        if _e274.all_remove {
                                            phi_470_ = false;
                                        } else {
                                            phi_470_ = true;
                                        }
                                        let _e315 = phi_470_;
                                        phi_471_ = _e315;
                                    } else {
                                        phi_471_ = true;
                                    }
                                    let _e317 = phi_471_;
                                    phi_472_ = _e317;
                                } else {
                                    phi_472_ = true;
                                }
                                let _e319 = phi_472_;
                                if _e319 {
                                    if _e237 {
                                        phi_479_ = 1u;
                                    } else {
                                        phi_479_ = 0u;
                                    }
                                    let _e321 = phi_479_;
                                    phi_480_ = _e321;
                                } else {
                                    phi_480_ = 5u;
                                }
                                let _e323 = phi_480_;
                                phi_481_ = _e323;
                            } else {
                                phi_481_ = 4u;
                            }
                            let _e325 = phi_481_;
                            phi_482_ = _e325;
                        }
                        let _e327 = phi_482_;
                        phi_483_ = _e327;
                    } else {
                        phi_483_ = 3u;
                    }
                    let _e329 = phi_483_;
                    phi_484_ = _e329;
                } else {
                    phi_484_ = 2u;
                }
                let _e331 = phi_484_;
                phi_485_ = _e331;
            }
            let _e333 = phi_485_;
            if !((_e333 == 0u)) {
                if !((_e333 == 5u)) {
                    phi_497_ = !(_e309);
                    phi_498_ = false;
                } else {
                    phi_497_ = bool();
                    phi_498_ = true;
                }
                let _e340 = phi_497_;
                let _e342 = phi_498_;
                phi_499_ = _e340;
                phi_500_ = _e342;
            } else {
                phi_499_ = bool();
                phi_500_ = true;
            }
            let _e344 = phi_499_;
            let _e346 = phi_500_;
            if _e346 {
                phi_504_ = false;
            } else {
                phi_504_ = _e344;
            }
            let _e348 = phi_504_;
            if _e309 {
                phi_510_ = ((0u & 4u) != 0u);
            } else {
                phi_510_ = _e233;
            }
            let _e352 = phi_510_;
            if _e348 {
                if _e233 {
                    phi_518_ = (2u | 1u);
                } else {
                    phi_518_ = 2u;
                }
                let _e355 = phi_518_;
                if false {
                    phi_523_ = (_e355 | 4u);
                } else {
                    phi_523_ = _e355;
                }
                let _e358 = phi_523_;
                phi_543_ = _e358;
            } else {
                if (_e333 == 7u) {
                    if _e233 {
                        phi_532_ = (2u | 1u);
                    } else {
                        phi_532_ = 2u;
                    }
                    let _e362 = phi_532_;
                    if _e352 {
                        phi_537_ = (_e362 | 4u);
                    } else {
                        phi_537_ = _e362;
                    }
                    let _e365 = phi_537_;
                    phi_542_ = _e365;
                } else {
                    if _e233 {
                        phi_541_ = 1u;
                    } else {
                        phi_541_ = 0u;
                    }
                    let _e367 = phi_541_;
                    phi_542_ = _e367;
                }
                let _e369 = phi_542_;
                phi_543_ = _e369;
            }
            let _e371 = phi_543_;
            if _e352 {
                phi_547_ = 0f;
            } else {
                phi_547_ = 1f;
            }
            let _e373 = phi_547_;
            if _e237 {
                if (_e75 == 0.99999994f) {
                    phi_556_ = true;
                } else {
                    phi_556_ = (_e75 == 0.000000059604645f);
                }
                let _e377 = phi_556_;
                phi_557_ = _e377;
            } else {
                phi_557_ = true;
            }
            let _e379 = phi_557_;
            phi_559_ = mask_Masked(_e373, _e371, _e348, _e379);
        }
        let _e382 = phi_559_;
        visibility.member[_e54.first_primitive] = _e382.visibility;
        let _e387 = p.member.light.number;
        let _e388 = (_e387 * 3u);
        let _e390 = (_e388 % 32u);
        let _e392 = p.member.light.mask_words;
        let _e394 = ((_e54.first_primitive * _e392) + (_e388 / 32u));
        let _e396 = bits.member[_e394];
        bits.member[_e394] = ((_e396 & ~((7u << bitcast<u32>((_e390 & 31u))))) | (_e382.bits << bitcast<u32>((_e390 & 31u))));
        if (_e390 > 29u) {
            let _e411 = bits.member[(_e394 + 1u)];
            let _e413 = (32u - _e390);
            bits.member[(_e394 + 1u)] = ((_e411 & ~((7u >> bitcast<u32>((_e413 & 31u))))) | (_e382.bits >> bitcast<u32>((_e413 & 31u))));
        }
        phi_611_ = doubt_Listed(_e54.first_primitive, _e382.is_trusted);
        phi_612_ = _e382.needs_ray;
    } else {
        phi_611_ = doubt_Listed(0u, false);
        phi_612_ = false;
    }
    let _e429 = phi_611_;
    let _e431 = phi_612_;
    if (_e38 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e431 {
        let _e437 = atomicAdd((&shared_[0u]), 1u);
        phi_625_ = _e437;
    } else {
        phi_625_ = 0u;
    }
    let _e439 = phi_625_;
    workgroupBarrier();
    if (_e38 == 0u) {
        let _e443 = atomicLoad((&shared_[0u]));
        let _e444 = atomicAdd((&list.member[3u]), _e443);
        atomicStore((&shared_[1u]), _e444);
    }
    workgroupBarrier();
    if _e431 {
        if _e429.is_trusted {
            phi_642_ = (_e429.pixel | 2147483648u);
        } else {
            phi_642_ = _e429.pixel;
        }
        let _e448 = phi_642_;
        let _e450 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e450) + _e439)]), _e448);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
