struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    pad0_: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    pad3_: vec2<u32>,
}

struct abi_MaskParams {
    current: abi_CameraParams,
    previous: abi_CameraParams,
    light: vec4<f32>,
    frame: u32,
    still_pattern: u32,
    moving_pattern: u32,
    flags: u32,
    depth_tolerance: f32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_9 {
    member: abi_MaskParams,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_13 {
    member: array<abi_Sample>,
}

struct type_17 {
    member: array<u32>,
}

struct type_21 {
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
var<private> local_2: u32;
@group(0) @binding(0) 
var<uniform> p: type_9;
@group(0) @binding(1) 
var<storage> samples: type_13;
@group(0) @binding(2) 
var<storage> last_bits: type_17;
@group(0) @binding(3) 
var<storage, read_write> bits: type_17;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_21;
@group(0) @binding(5) 
var<storage, read_write> list: type_43;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(6) 
var<storage> last_depths: type_21;
@group(0) @binding(7) 
var<storage, read_write> depths: type_21;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_153_: lt_bvh_traverse_Tree;
    var phi_154_: bool;
    var phi_155_: lt_bvh_traverse_Tree;
    var phi_156_: bool;
    var phi_161_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_153_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_154_ = false;
        } else {
            phi_153_ = lt_bvh_traverse_Tree();
            phi_154_ = true;
        }
        let _e56 = phi_153_;
        let _e58 = phi_154_;
        phi_155_ = _e56;
        phi_156_ = _e58;
    } else {
        phi_155_ = lt_bvh_traverse_Tree();
        phi_156_ = true;
    }
    let _e60 = phi_155_;
    let _e62 = phi_156_;
    if _e62 {
        phi_161_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_161_ = _e60;
    }
    let _e67 = phi_161_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_179_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_179_ = vec2(0i);
            break;
        }
        case 1: {
            phi_179_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_179_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_179_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_179_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e52 = phi_179_;
    return vec2<i32>(_e52.x, _e52.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_197_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_197_ = vec2(0i);
            break;
        }
        case 1: {
            phi_197_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_197_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_197_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_197_ = vec2(1i);
            break;
        }
    }
    let _e52 = phi_197_;
    return vec2<i32>(_e52.x, _e52.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_216_: vec2<i32>;

    if (param_6 == 0u) {
        let _e46 = lt_mask_pattern_plus(param_5);
        phi_216_ = vec2<i32>(_e46.x, _e46.y);
    } else {
        let _e50 = lt_mask_pattern_cross(param_5);
        phi_216_ = vec2<i32>(_e50.x, _e50.y);
    }
    let _e55 = phi_216_;
    return vec2<i32>(_e55.x, _e55.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_241_: vec2<i32>;

    let _e44 = (param_7 % 13u);
    switch bitcast<i32>(_e44) {
        case 9: {
            phi_241_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_241_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_241_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_241_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_241_ = vec2<i32>((bitcast<i32>((_e44 % 3u)) - 1i), (bitcast<i32>(((_e44 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e59 = phi_241_;
    return vec2<i32>(_e59.x, _e59.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_262_: u32;
    var phi_263_: u32;

    let _e47 = (bitcast<i32>(param_8) + param_9);
    if (_e47 < 0i) {
        phi_263_ = 0u;
    } else {
        if (_e47 >= bitcast<i32>(param_10)) {
            phi_262_ = (param_10 - 1u);
        } else {
            phi_262_ = bitcast<u32>(_e47);
        }
        let _e54 = phi_262_;
        phi_263_ = _e54;
    }
    let _e56 = phi_263_;
    return _e56;
}

fn function_() {
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_336_: bool;
    var phi_380_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_384_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_397_: bool;
    var phi_453_: bool;
    var phi_457_: f32;
    var phi_468_: bool;
    var phi_481_: bool;
    var phi_492_: bool;
    var phi_493_: bool;
    var phi_494_: bool;
    var phi_495_: bool;
    var phi_496_: bool;
    var phi_497_: bool;
    var phi_501_: bool;
    var phi_506_: bool;
    var phi_520_: u32;
    var phi_522_: u32;
    var phi_525_: lt_mask_Neighbourhood;
    var phi_537_: bool;
    var phi_538_: bool;
    var phi_547_: u32;
    var phi_548_: u32;
    var phi_608_: vec2<i32>;
    var phi_628_: vec2<i32>;
    var phi_651_: u32;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_695_: bool;
    var phi_696_: bool;
    var phi_697_: bool;
    var phi_523_: u32;
    var phi_526_: lt_mask_Neighbourhood;
    var phi_700_: lt_mask_Neighbourhood;
    var phi_701_: lt_mask_Neighbourhood;
    var phi_726_: bool;
    var phi_727_: bool;
    var phi_740_: bool;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_749_: u32;
    var phi_750_: u32;
    var phi_751_: u32;
    var phi_752_: u32;
    var phi_753_: u32;
    var phi_761_: bool;
    var phi_769_: u32;
    var phi_774_: u32;
    var phi_778_: u32;
    var phi_779_: u32;
    var phi_783_: f32;
    var phi_785_: mask_Masked;
    var phi_813_: bool;
    var phi_814_: bool;
    var phi_815_: bool;
    var phi_816_: bool;
    var phi_820_: bool;
    var phi_848_: f32;
    var phi_851_: bool;
    var phi_852_: u32;
    var phi_863_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e43 = id_1;
    let _e44 = local_2;
    let _e60 = p.member.current.size[0u];
    let _e62 = p.member.current.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e43, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        let _e71 = p.member.current.size[0u];
        let _e74 = samples.member[_e63.first_primitive].position;
        let _e76 = visibility.member[_e63.first_primitive];
        let _e80 = p.member.light;
        let _e83 = samples.member[_e63.first_primitive].normal[0u];
        let _e85 = global[0u];
        if (_e83 == _e85) {
            let _e88 = samples.member[_e63.first_primitive].normal[1u];
            let _e90 = global[1u];
            if (_e88 == _e90) {
                let _e93 = samples.member[_e63.first_primitive].normal[2u];
                let _e95 = global[2u];
                phi_329_ = (_e93 == _e95);
                phi_330_ = false;
            } else {
                phi_329_ = bool();
                phi_330_ = true;
            }
            let _e98 = phi_329_;
            let _e100 = phi_330_;
            phi_331_ = _e98;
            phi_332_ = _e100;
        } else {
            phi_331_ = bool();
            phi_332_ = true;
        }
        let _e102 = phi_331_;
        let _e104 = phi_332_;
        if _e104 {
            phi_336_ = false;
        } else {
            phi_336_ = _e102;
        }
        let _e106 = phi_336_;
        if !(_e106) {
            let _e109 = samples.member[_e63.first_primitive].normal;
            let _e111 = samples.member[_e63.first_primitive].position;
            if ((((_e109.x * (_e80.x - (_e111.x * _e80.w))) + (_e109.y * (_e80.y - (_e111.y * _e80.w)))) + (_e109.z * (_e80.z - (_e111.z * _e80.w)))) > 0f) {
                let _e135 = samples.member[_e63.first_primitive].flags;
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e149 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e143.unnamed.visibility, false), _e143.unnamed_1);
                phi_380_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e149.unnamed, ((_e135 & 1u) == 0u));
            } else {
                let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e164 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e158.unnamed.visibility, false), _e158.unnamed_1);
                phi_380_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e164.unnamed, true);
            }
            let _e169 = phi_380_;
            phi_384_ = _e169;
        } else {
            let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e175.unnamed.visibility, false), _e175.unnamed_1);
            phi_384_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e181.unnamed, true);
        }
        let _e186 = phi_384_;
        if _e186.unnamed_1 {
            phi_785_ = mask_Masked(_e186.unnamed.visibility, 0u, false);
        } else {
            let _e191 = (_e76 < 0.5f);
            if (_e76 > 0f) {
                phi_397_ = (_e76 < 1f);
            } else {
                phi_397_ = false;
            }
            let _e195 = phi_397_;
            let _e198 = p.member.previous.eye;
            let _e209 = p.member.previous.forward;
            let _e217 = ((((_e74.x - _e198.x) * _e209.x) + ((_e74.y - _e198.y) * _e209.y)) + ((_e74.z - _e198.z) * _e209.z));
            let _e219 = ((_e43.y * _e71) + _e43.x);
            if (_e219 < arrayLength((&last_depths.member))) {
            } else {
                return;
            }
            let _e223 = last_depths.member[(0u + _e219)];
            let _e225 = p.member.depth_tolerance;
            let _e228 = abs(_e217);
            let _e229 = abs(_e223);
            if ((bitcast<u32>(_e229) & 2147483647u) > 2139095040u) {
                phi_453_ = true;
            } else {
                let _e233 = (_e229 > _e228);
                if _e233 {
                }
                phi_453_ = _e233;
            }
            let _e235 = phi_453_;
            if _e235 {
                phi_457_ = _e229;
            } else {
                phi_457_ = _e228;
            }
            let _e237 = phi_457_;
            if (abs((_e217 - _e223)) <= (_e225 * _e237)) {
                let _e241 = p.member.flags;
                phi_468_ = ((_e241 & 1u) != 0u);
            } else {
                phi_468_ = false;
            }
            let _e245 = phi_468_;
            let _e247 = p.member.flags;
            if false {
                let _e251 = p.member.flags;
                phi_481_ = ((_e251 & 4u) == 0u);
            } else {
                phi_481_ = false;
            }
            let _e255 = phi_481_;
            if ((_e247 & 2u) != 0u) {
                if false {
                    phi_494_ = bool();
                    phi_495_ = true;
                } else {
                    if true {
                        phi_492_ = !(_e255);
                        phi_493_ = false;
                    } else {
                        phi_492_ = bool();
                        phi_493_ = true;
                    }
                    let _e258 = phi_492_;
                    let _e260 = phi_493_;
                    phi_494_ = _e258;
                    phi_495_ = _e260;
                }
                let _e262 = phi_494_;
                let _e264 = phi_495_;
                phi_496_ = _e262;
                phi_497_ = _e264;
            } else {
                phi_496_ = bool();
                phi_497_ = true;
            }
            let _e266 = phi_496_;
            let _e268 = phi_497_;
            if _e268 {
                phi_501_ = false;
            } else {
                phi_501_ = _e266;
            }
            let _e270 = phi_501_;
            let _e271 = lt_mask_Neighbourhood(false, true);
            if _e195 {
                phi_506_ = _e270;
            } else {
                phi_506_ = false;
            }
            let _e273 = phi_506_;
            if _e273 {
                if _e245 {
                    if false {
                        let _e275 = p.member.moving_pattern;
                        phi_520_ = _e275;
                    } else {
                        let _e277 = p.member.still_pattern;
                        phi_520_ = _e277;
                    }
                    let _e279 = phi_520_;
                    phi_522_ = 0u;
                    phi_525_ = _e271;
                    loop {
                        let _e281 = phi_522_;
                        let _e283 = phi_525_;
                        local_1 = _e283;
                        if (1u <= _e279) {
                            if (_e279 <= 4u) {
                                phi_537_ = false;
                            } else {
                                phi_537_ = true;
                            }
                            let _e287 = phi_537_;
                            phi_538_ = _e287;
                        } else {
                            phi_538_ = true;
                        }
                        let _e289 = phi_538_;
                        if _e289 {
                            switch bitcast<i32>(_e279) {
                                case 5: {
                                    phi_547_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_547_ = 25u;
                                    break;
                                }
                                case 7: {
                                    phi_547_ = 13u;
                                    break;
                                }
                                default: {
                                    phi_547_ = 9u;
                                    break;
                                }
                            }
                            let _e292 = phi_547_;
                            phi_548_ = _e292;
                        } else {
                            phi_548_ = 5u;
                        }
                        let _e294 = phi_548_;
                        let _e295 = (_e281 < _e294);
                        if _e295 {
                            let _e297 = p.member.frame;
                            let _e301 = p.member.current.size[0u];
                            let _e303 = p.member.current.size[1u];
                            switch bitcast<i32>(_e279) {
                                case 1: {
                                    let _e313 = lt_mask_pattern_plus(_e281);
                                    phi_628_ = vec2<i32>(_e313.x, _e313.y);
                                    break;
                                }
                                case 2: {
                                    let _e317 = lt_mask_pattern_cross(_e281);
                                    phi_628_ = vec2<i32>(_e317.x, _e317.y);
                                    break;
                                }
                                case 3: {
                                    let _e323 = lt_mask_pattern_plus_or_cross(_e281, ((_e43.x + _e43.y) & 1u));
                                    phi_628_ = vec2<i32>(_e323.x, _e323.y);
                                    break;
                                }
                                case 4: {
                                    let _e328 = lt_mask_pattern_plus_or_cross(_e281, (_e297 & 1u));
                                    phi_628_ = vec2<i32>(_e328.x, _e328.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e297 & 3u)) {
                                        case 0: {
                                            phi_608_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_608_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_608_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_608_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e339 = phi_608_;
                                    phi_628_ = (_e339 + vec2<i32>(bitcast<i32>((_e281 & 1u)), bitcast<i32>(((_e281 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_628_ = vec2<i32>((bitcast<i32>((_e281 % 5u)) - 2i), (bitcast<i32>(((_e281 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                case 7: {
                                    let _e356 = lt_mask_pattern_diamond(_e281);
                                    phi_628_ = vec2<i32>(_e356.x, _e356.y);
                                    break;
                                }
                                default: {
                                    phi_628_ = vec2<i32>((bitcast<i32>((_e281 % 3u)) - 1i), (bitcast<i32>(((_e281 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e361 = phi_628_;
                            let _e364 = lt_mask_pattern_step_clamped(_e43.x, _e361.x, _e301);
                            let _e365 = lt_mask_pattern_step_clamped(_e43.y, _e361.y, _e303);
                            let _e367 = ((_e365 * _e71) + _e364);
                            if (_e367 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e371 = last_bits.member[(0u + _e367)];
                            if ((_e371 & 2u) == 0u) {
                                phi_651_ = (_e371 & 1u);
                            } else {
                                phi_651_ = (_e371 & 7u);
                            }
                            let _e377 = phi_651_;
                            if _e283.any_expands {
                                phi_677_ = true;
                            } else {
                                if ((_e377 & 2u) != 0u) {
                                    if (((_e377 & 4u) != 0u) != _e191) {
                                        phi_668_ = false;
                                    } else {
                                        phi_668_ = true;
                                    }
                                    let _e386 = phi_668_;
                                    phi_669_ = _e386;
                                } else {
                                    phi_669_ = true;
                                }
                                let _e388 = phi_669_;
                                if _e388 {
                                    phi_676_ = (((_e377 & 1u) != 0u) != _e191);
                                } else {
                                    phi_676_ = true;
                                }
                                let _e393 = phi_676_;
                                phi_677_ = _e393;
                            }
                            let _e395 = phi_677_;
                            if _e283.all_remove {
                                if (((_e377 & 1u) != 0u) == _e191) {
                                    if ((_e377 & 2u) != 0u) {
                                        phi_695_ = (((_e377 & 4u) != 0u) == _e191);
                                    } else {
                                        phi_695_ = true;
                                    }
                                    let _e405 = phi_695_;
                                    phi_696_ = _e405;
                                } else {
                                    phi_696_ = false;
                                }
                                let _e407 = phi_696_;
                                phi_697_ = _e407;
                            } else {
                                phi_697_ = false;
                            }
                            let _e409 = phi_697_;
                            phi_523_ = (_e281 + 1u);
                            phi_526_ = lt_mask_Neighbourhood(_e395, _e409);
                        } else {
                            phi_523_ = u32();
                            phi_526_ = lt_mask_Neighbourhood();
                        }
                        let _e413 = phi_523_;
                        let _e415 = phi_526_;
                        continue;
                        continuing {
                            phi_522_ = _e413;
                            phi_525_ = _e415;
                            break if !(_e295);
                        }
                    }
                    let _e586 = local_1;
                    phi_700_ = _e586;
                } else {
                    phi_700_ = _e271;
                }
                let _e418 = phi_700_;
                phi_701_ = _e418;
            } else {
                phi_701_ = _e271;
            }
            let _e420 = phi_701_;
            if (_e76 != 0.5f) {
                if _e245 {
                    if _e195 {
                        phi_727_ = true;
                    } else {
                        if _e420.any_expands {
                            phi_726_ = false;
                        } else {
                            phi_726_ = true;
                        }
                        let _e425 = phi_726_;
                        phi_727_ = _e425;
                    }
                    let _e427 = phi_727_;
                    if _e427 {
                        if _e195 {
                            if _e270 {
                                if _e420.all_remove {
                                    phi_740_ = false;
                                } else {
                                    phi_740_ = true;
                                }
                                let _e429 = phi_740_;
                                phi_741_ = _e429;
                            } else {
                                phi_741_ = true;
                            }
                            let _e431 = phi_741_;
                            phi_742_ = _e431;
                        } else {
                            phi_742_ = true;
                        }
                        let _e433 = phi_742_;
                        if _e433 {
                            if _e195 {
                                phi_749_ = 1u;
                            } else {
                                phi_749_ = 0u;
                            }
                            let _e435 = phi_749_;
                            phi_750_ = _e435;
                        } else {
                            phi_750_ = 5u;
                        }
                        let _e437 = phi_750_;
                        phi_751_ = _e437;
                    } else {
                        phi_751_ = 4u;
                    }
                    let _e439 = phi_751_;
                    phi_752_ = _e439;
                } else {
                    phi_752_ = 3u;
                }
                let _e441 = phi_752_;
                phi_753_ = _e441;
            } else {
                phi_753_ = 2u;
            }
            let _e443 = phi_753_;
            if !((_e443 == 0u)) {
                phi_761_ = !((_e443 == 5u));
            } else {
                phi_761_ = false;
            }
            let _e449 = phi_761_;
            if _e449 {
                if _e191 {
                    phi_769_ = (2u | 1u);
                } else {
                    phi_769_ = 2u;
                }
                let _e452 = phi_769_;
                if false {
                    phi_774_ = (_e452 | 4u);
                } else {
                    phi_774_ = _e452;
                }
                let _e455 = phi_774_;
                phi_779_ = _e455;
            } else {
                if _e191 {
                    phi_778_ = 1u;
                } else {
                    phi_778_ = 0u;
                }
                let _e457 = phi_778_;
                phi_779_ = _e457;
            }
            let _e459 = phi_779_;
            if _e191 {
                phi_783_ = 0f;
            } else {
                phi_783_ = 1f;
            }
            let _e461 = phi_783_;
            phi_785_ = mask_Masked(_e461, _e459, _e449);
        }
        let _e464 = phi_785_;
        visibility.member[_e63.first_primitive] = _e464.visibility;
        bits.member[_e63.first_primitive] = _e464.bits;
        let _e472 = samples.member[_e63.first_primitive].normal[0u];
        let _e474 = global[0u];
        if (_e472 == _e474) {
            let _e477 = samples.member[_e63.first_primitive].normal[1u];
            let _e479 = global[1u];
            if (_e477 == _e479) {
                let _e482 = samples.member[_e63.first_primitive].normal[2u];
                let _e484 = global[2u];
                phi_813_ = (_e482 == _e484);
                phi_814_ = false;
            } else {
                phi_813_ = bool();
                phi_814_ = true;
            }
            let _e487 = phi_813_;
            let _e489 = phi_814_;
            phi_815_ = _e487;
            phi_816_ = _e489;
        } else {
            phi_815_ = bool();
            phi_816_ = true;
        }
        let _e491 = phi_815_;
        let _e493 = phi_816_;
        if _e493 {
            phi_820_ = false;
        } else {
            phi_820_ = _e491;
        }
        let _e495 = phi_820_;
        if !(_e495) {
            let _e498 = samples.member[_e63.first_primitive].position;
            let _e500 = p.member.current.eye;
            let _e511 = p.member.current.forward;
            phi_848_ = ((((_e498.x - _e500.x) * _e511.x) + ((_e498.y - _e500.y) * _e511.y)) + ((_e498.z - _e500.z) * _e511.z));
        } else {
            phi_848_ = 0f;
        }
        let _e521 = phi_848_;
        depths.member[_e63.first_primitive] = _e521;
        phi_851_ = _e464.needs_ray;
        phi_852_ = _e63.first_primitive;
    } else {
        phi_851_ = false;
        phi_852_ = 0u;
    }
    let _e525 = phi_851_;
    let _e527 = phi_852_;
    if (_e44 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e525 {
        let _e531 = atomicAdd((&shared_[0u]), 1u);
        phi_863_ = _e531;
    } else {
        phi_863_ = 0u;
    }
    let _e533 = phi_863_;
    workgroupBarrier();
    if (_e44 == 0u) {
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
fn entry_mask_mask_depth_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
