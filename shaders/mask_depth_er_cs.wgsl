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
    var phi_150_: lt_bvh_traverse_Tree;
    var phi_151_: bool;
    var phi_152_: lt_bvh_traverse_Tree;
    var phi_153_: bool;
    var phi_158_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_150_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_151_ = false;
        } else {
            phi_150_ = lt_bvh_traverse_Tree();
            phi_151_ = true;
        }
        let _e51 = phi_150_;
        let _e53 = phi_151_;
        phi_152_ = _e51;
        phi_153_ = _e53;
    } else {
        phi_152_ = lt_bvh_traverse_Tree();
        phi_153_ = true;
    }
    let _e55 = phi_152_;
    let _e57 = phi_153_;
    if _e57 {
        phi_158_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_158_ = _e55;
    }
    let _e62 = phi_158_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn function_() {
    var phi_226_: bool;
    var phi_227_: bool;
    var phi_228_: bool;
    var phi_229_: bool;
    var phi_233_: bool;
    var phi_303_: bool;
    var phi_304_: bool;
    var phi_315_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_316_: bool;
    var phi_317_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_318_: bool;
    var phi_325_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_329_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_342_: bool;
    var phi_398_: bool;
    var phi_402_: f32;
    var phi_413_: bool;
    var phi_419_: bool;
    var phi_450_: u32;
    var phi_479_: lt_mask_Neighbourhood;
    var phi_480_: lt_mask_Neighbourhood;
    var phi_481_: lt_mask_Neighbourhood;
    var phi_513_: bool;
    var phi_514_: bool;
    var phi_536_: bool;
    var phi_537_: bool;
    var phi_538_: bool;
    var phi_542_: bool;
    var phi_564_: bool;
    var phi_565_: bool;
    var phi_578_: bool;
    var phi_579_: bool;
    var phi_580_: bool;
    var phi_587_: u32;
    var phi_588_: u32;
    var phi_589_: u32;
    var phi_590_: u32;
    var phi_591_: u32;
    var phi_592_: u32;
    var phi_593_: u32;
    var phi_605_: bool;
    var phi_606_: bool;
    var phi_607_: bool;
    var phi_608_: bool;
    var phi_612_: bool;
    var phi_618_: bool;
    var phi_626_: u32;
    var phi_631_: u32;
    var phi_640_: u32;
    var phi_645_: u32;
    var phi_649_: u32;
    var phi_650_: u32;
    var phi_651_: u32;
    var phi_655_: f32;
    var phi_657_: mask_Masked;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_736_: bool;
    var phi_764_: f32;
    var phi_767_: bool;
    var phi_768_: u32;
    var phi_779_: u32;

    let _e38 = id_1;
    let _e39 = local_1;
    let _e55 = p.member.current.size[0u];
    let _e57 = p.member.current.size[1u];
    let _e58 = lt_shaders_entry_pixel_index(_e38, _e55, _e57);
    if (bitcast<i32>(_e58.root) != 0i) {
        let _e66 = p.member.current.size[0u];
        let _e69 = samples.member[_e58.first_primitive].position;
        let _e71 = visibility.member[_e58.first_primitive];
        let _e77 = samples.member[_e58.first_primitive].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[_e58.first_primitive].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[_e58.first_primitive].normal[2u];
                let _e89 = global[2u];
                phi_226_ = (_e87 == _e89);
                phi_227_ = false;
            } else {
                phi_226_ = bool();
                phi_227_ = true;
            }
            let _e92 = phi_226_;
            let _e94 = phi_227_;
            phi_228_ = _e92;
            phi_229_ = _e94;
        } else {
            phi_228_ = bool();
            phi_229_ = true;
        }
        let _e96 = phi_228_;
        let _e98 = phi_229_;
        if _e98 {
            phi_233_ = false;
        } else {
            phi_233_ = _e96;
        }
        let _e100 = phi_233_;
        if !(_e100) {
            let _e103 = samples.member[_e58.first_primitive].position;
            let _e105 = p.member.light.place;
            let _e111 = p.member.light.place[3u];
            let _e118 = (_e105.x - (_e103.x * _e111));
            let _e119 = (_e105.y - (_e103.y * _e111));
            let _e120 = (_e105.z - (_e103.z * _e111));
            let _e122 = samples.member[_e58.first_primitive].normal;
            if ((((_e122.x * _e118) + (_e122.y * _e119)) + (_e122.z * _e120)) > 0f) {
                let _e136 = (((_e118 * _e118) + (_e119 * _e119)) + (_e120 * _e120));
                let _e138 = p.member.light.axis;
                let _e150 = p.member.light.place[3u];
                if (_e150 == 0f) {
                    phi_304_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_303_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_303_ = false;
                    }
                    let _e161 = phi_303_;
                    phi_304_ = _e161;
                }
                let _e163 = phi_304_;
                if _e163 {
                    let _e165 = samples.member[_e58.first_primitive].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_315_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_316_ = false;
                } else {
                    phi_315_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_316_ = true;
                }
                let _e184 = phi_315_;
                let _e186 = phi_316_;
                phi_317_ = _e184;
                phi_318_ = _e186;
            } else {
                phi_317_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_318_ = true;
            }
            let _e188 = phi_317_;
            let _e190 = phi_318_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_325_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_325_ = _e188;
            }
            let _e207 = phi_325_;
            phi_329_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_329_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_329_;
        if _e224.unnamed_1 {
            phi_657_ = mask_Masked(_e224.unnamed.visibility, 0u, false);
        } else {
            let _e229 = (_e71 < 0.5f);
            if (_e71 > 0f) {
                phi_342_ = (_e71 < 1f);
            } else {
                phi_342_ = false;
            }
            let _e233 = phi_342_;
            let _e236 = p.member.previous.eye;
            let _e247 = p.member.previous.forward;
            let _e255 = ((((_e69.x - _e236.x) * _e247.x) + ((_e69.y - _e236.y) * _e247.y)) + ((_e69.z - _e236.z) * _e247.z));
            let _e257 = ((_e38.y * _e66) + _e38.x);
            if (_e257 < arrayLength((&last_depths.member))) {
            } else {
                return;
            }
            let _e261 = last_depths.member[(0u + _e257)];
            let _e263 = p.member.depth_tolerance;
            let _e266 = abs(_e255);
            let _e267 = abs(_e261);
            if ((bitcast<u32>(_e267) & 2147483647u) > 2139095040u) {
                phi_398_ = true;
            } else {
                let _e271 = (_e267 > _e266);
                if _e271 {
                }
                phi_398_ = _e271;
            }
            let _e273 = phi_398_;
            if _e273 {
                phi_402_ = _e267;
            } else {
                phi_402_ = _e266;
            }
            let _e275 = phi_402_;
            if (abs((_e255 - _e261)) <= (_e263 * _e275)) {
                let _e279 = p.member.flags;
                phi_413_ = ((_e279 & 1u) != 0u);
            } else {
                phi_413_ = false;
            }
            let _e283 = phi_413_;
            let _e284 = lt_mask_Neighbourhood(false, true);
            if _e233 {
                phi_419_ = false;
            } else {
                phi_419_ = true;
            }
            let _e286 = phi_419_;
            if _e286 {
                if _e283 {
                    if ((0u & 2u) != 0u) {
                        phi_479_ = _e284;
                    } else {
                        if (32u == 0u) {
                            return;
                        }
                        let _e290 = (_e66 / 32u);
                        if (32u == 0u) {
                            return;
                        }
                        if ((_e66 % 32u) > 0u) {
                            phi_450_ = (_e290 + 1u);
                        } else {
                            phi_450_ = _e290;
                        }
                        let _e296 = phi_450_;
                        let _e306 = ((((_e38.y * _e296) + (_e38.x / 32u)) * 6u) + (select(0u, 1u, _e229) | (select(0u, 1u, false) << bitcast<u32>(1i))));
                        if (_e306 < arrayLength((&heard.member))) {
                        } else {
                            return;
                        }
                        let _e310 = heard.member[(0u + _e306)];
                        let _e316 = (((_e310 >> bitcast<u32>(((_e38.x % 32u) & 31u))) & 1u) != 0u);
                        phi_479_ = lt_mask_Neighbourhood(_e316, !(_e316));
                    }
                    let _e320 = phi_479_;
                    phi_480_ = _e320;
                } else {
                    phi_480_ = _e284;
                }
                let _e322 = phi_480_;
                phi_481_ = _e322;
            } else {
                phi_481_ = _e284;
            }
            let _e324 = phi_481_;
            let _e327 = p.member.frame;
            let _e329 = p.member.refresh;
            if (_e329 == 0u) {
                phi_514_ = false;
            } else {
                if (_e329 == 0u) {
                    return;
                }
                let _e338 = ((_e38.x + (_e38.y * (((_e329 * 5u) / 8u) | 1u))) + (_e327 % _e329));
                if (_e329 == 0u) {
                    phi_513_ = (_e338 == 0u);
                } else {
                    if (_e329 == 0u) {
                        return;
                    }
                    phi_513_ = ((_e338 % _e329) == 0u);
                }
                let _e345 = phi_513_;
                phi_514_ = _e345;
            }
            let _e347 = phi_514_;
            if _e283 {
                if _e347 {
                    phi_536_ = bool();
                } else {
                    phi_536_ = ((0u & 2u) != 0u);
                }
                let _e353 = phi_536_;
                phi_537_ = _e353;
                phi_538_ = _e347;
            } else {
                phi_537_ = bool();
                phi_538_ = true;
            }
            let _e355 = phi_537_;
            let _e357 = phi_538_;
            if _e357 {
                phi_542_ = false;
            } else {
                phi_542_ = _e355;
            }
            let _e359 = phi_542_;
            if _e359 {
                phi_593_ = 7u;
            } else {
                if (_e71 != 0.5f) {
                    if _e283 {
                        if _e347 {
                            phi_590_ = 6u;
                        } else {
                            if _e233 {
                                phi_565_ = true;
                            } else {
                                if _e324.any_expands {
                                    phi_564_ = false;
                                } else {
                                    phi_564_ = true;
                                }
                                let _e361 = phi_564_;
                                phi_565_ = _e361;
                            }
                            let _e363 = phi_565_;
                            if _e363 {
                                if _e233 {
                                    if false {
                                        if _e324.all_remove {
                                            phi_578_ = false;
                                        } else {
                                            phi_578_ = true;
                                        }
                                        let _e365 = phi_578_;
                                        phi_579_ = _e365;
                                    } else {
                                        phi_579_ = true;
                                    }
                                    let _e367 = phi_579_;
                                    phi_580_ = _e367;
                                } else {
                                    phi_580_ = true;
                                }
                                let _e369 = phi_580_;
                                if _e369 {
                                    if _e233 {
                                        phi_587_ = 1u;
                                    } else {
                                        phi_587_ = 0u;
                                    }
                                    let _e371 = phi_587_;
                                    phi_588_ = _e371;
                                } else {
                                    phi_588_ = 5u;
                                }
                                let _e373 = phi_588_;
                                phi_589_ = _e373;
                            } else {
                                phi_589_ = 4u;
                            }
                            let _e375 = phi_589_;
                            phi_590_ = _e375;
                        }
                        let _e377 = phi_590_;
                        phi_591_ = _e377;
                    } else {
                        phi_591_ = 3u;
                    }
                    let _e379 = phi_591_;
                    phi_592_ = _e379;
                } else {
                    phi_592_ = 2u;
                }
                let _e381 = phi_592_;
                phi_593_ = _e381;
            }
            let _e383 = phi_593_;
            if !((_e383 == 0u)) {
                if !((_e383 == 5u)) {
                    phi_605_ = !(_e359);
                    phi_606_ = false;
                } else {
                    phi_605_ = bool();
                    phi_606_ = true;
                }
                let _e390 = phi_605_;
                let _e392 = phi_606_;
                phi_607_ = _e390;
                phi_608_ = _e392;
            } else {
                phi_607_ = bool();
                phi_608_ = true;
            }
            let _e394 = phi_607_;
            let _e396 = phi_608_;
            if _e396 {
                phi_612_ = false;
            } else {
                phi_612_ = _e394;
            }
            let _e398 = phi_612_;
            if _e359 {
                phi_618_ = ((0u & 4u) != 0u);
            } else {
                phi_618_ = _e229;
            }
            let _e402 = phi_618_;
            if _e398 {
                if _e229 {
                    phi_626_ = (2u | 1u);
                } else {
                    phi_626_ = 2u;
                }
                let _e405 = phi_626_;
                if false {
                    phi_631_ = (_e405 | 4u);
                } else {
                    phi_631_ = _e405;
                }
                let _e408 = phi_631_;
                phi_651_ = _e408;
            } else {
                if (_e383 == 7u) {
                    if _e229 {
                        phi_640_ = (2u | 1u);
                    } else {
                        phi_640_ = 2u;
                    }
                    let _e412 = phi_640_;
                    if _e402 {
                        phi_645_ = (_e412 | 4u);
                    } else {
                        phi_645_ = _e412;
                    }
                    let _e415 = phi_645_;
                    phi_650_ = _e415;
                } else {
                    if _e229 {
                        phi_649_ = 1u;
                    } else {
                        phi_649_ = 0u;
                    }
                    let _e417 = phi_649_;
                    phi_650_ = _e417;
                }
                let _e419 = phi_650_;
                phi_651_ = _e419;
            }
            let _e421 = phi_651_;
            if _e402 {
                phi_655_ = 0f;
            } else {
                phi_655_ = 1f;
            }
            let _e423 = phi_655_;
            phi_657_ = mask_Masked(_e423, _e421, _e398);
        }
        let _e426 = phi_657_;
        visibility.member[_e58.first_primitive] = _e426.visibility;
        let _e431 = p.member.light.number;
        let _e432 = (_e431 * 3u);
        let _e434 = (_e432 % 32u);
        let _e436 = p.member.light.mask_words;
        let _e438 = ((_e58.first_primitive * _e436) + (_e432 / 32u));
        let _e440 = bits.member[_e438];
        bits.member[_e438] = ((_e440 & ~((7u << bitcast<u32>((_e434 & 31u))))) | (_e426.bits << bitcast<u32>((_e434 & 31u))));
        if (_e434 > 29u) {
            let _e455 = bits.member[(_e438 + 1u)];
            let _e457 = (32u - _e434);
            bits.member[(_e438 + 1u)] = ((_e455 & ~((7u >> bitcast<u32>((_e457 & 31u))))) | (_e426.bits >> bitcast<u32>((_e457 & 31u))));
        }
        let _e472 = samples.member[_e58.first_primitive].normal[0u];
        let _e474 = global[0u];
        if (_e472 == _e474) {
            let _e477 = samples.member[_e58.first_primitive].normal[1u];
            let _e479 = global[1u];
            if (_e477 == _e479) {
                let _e482 = samples.member[_e58.first_primitive].normal[2u];
                let _e484 = global[2u];
                phi_729_ = (_e482 == _e484);
                phi_730_ = false;
            } else {
                phi_729_ = bool();
                phi_730_ = true;
            }
            let _e487 = phi_729_;
            let _e489 = phi_730_;
            phi_731_ = _e487;
            phi_732_ = _e489;
        } else {
            phi_731_ = bool();
            phi_732_ = true;
        }
        let _e491 = phi_731_;
        let _e493 = phi_732_;
        if _e493 {
            phi_736_ = false;
        } else {
            phi_736_ = _e491;
        }
        let _e495 = phi_736_;
        if !(_e495) {
            let _e498 = samples.member[_e58.first_primitive].position;
            let _e500 = p.member.current.eye;
            let _e511 = p.member.current.forward;
            phi_764_ = ((((_e498.x - _e500.x) * _e511.x) + ((_e498.y - _e500.y) * _e511.y)) + ((_e498.z - _e500.z) * _e511.z));
        } else {
            phi_764_ = 0f;
        }
        let _e521 = phi_764_;
        depths.member[_e58.first_primitive] = _e521;
        phi_767_ = _e426.needs_ray;
        phi_768_ = _e58.first_primitive;
    } else {
        phi_767_ = false;
        phi_768_ = 0u;
    }
    let _e525 = phi_767_;
    let _e527 = phi_768_;
    if (_e39 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e525 {
        let _e531 = atomicAdd((&shared_[0u]), 1u);
        phi_779_ = _e531;
    } else {
        phi_779_ = 0u;
    }
    let _e533 = phi_779_;
    workgroupBarrier();
    if (_e39 == 0u) {
        let _e537 = atomicLoad((&shared_[0u]));
        let _e538 = atomicAdd((&list.member[3u]), _e537);
        atomicStore((&shared_[1u]), _e538);
    }
    workgroupBarrier();
    if _e525 {
        let _e541 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e541) + _e533)]), _e527);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
