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
        let _e54 = phi_150_;
        let _e56 = phi_151_;
        phi_152_ = _e54;
        phi_153_ = _e56;
    } else {
        phi_152_ = lt_bvh_traverse_Tree();
        phi_153_ = true;
    }
    let _e58 = phi_152_;
    let _e60 = phi_153_;
    if _e60 {
        phi_158_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_158_ = _e58;
    }
    let _e65 = phi_158_;
    return lt_bvh_traverse_Tree(_e65.root, _e65.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_176_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_176_ = vec2(0i);
            break;
        }
        case 1: {
            phi_176_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_176_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_176_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_176_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e50 = phi_176_;
    return vec2<i32>(_e50.x, _e50.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_194_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_194_ = vec2(0i);
            break;
        }
        case 1: {
            phi_194_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_194_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_194_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_194_ = vec2(1i);
            break;
        }
    }
    let _e50 = phi_194_;
    return vec2<i32>(_e50.x, _e50.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_213_: vec2<i32>;

    if (param_6 == 0u) {
        let _e44 = lt_mask_pattern_plus(param_5);
        phi_213_ = vec2<i32>(_e44.x, _e44.y);
    } else {
        let _e48 = lt_mask_pattern_cross(param_5);
        phi_213_ = vec2<i32>(_e48.x, _e48.y);
    }
    let _e53 = phi_213_;
    return vec2<i32>(_e53.x, _e53.y);
}

fn lt_mask_pattern_step_clamped(param_7: u32, param_8: i32, param_9: u32) -> u32 {
    var phi_234_: u32;
    var phi_235_: u32;

    let _e45 = (bitcast<i32>(param_7) + param_8);
    if (_e45 < 0i) {
        phi_235_ = 0u;
    } else {
        if (_e45 >= bitcast<i32>(param_9)) {
            phi_234_ = (param_9 - 1u);
        } else {
            phi_234_ = bitcast<u32>(_e45);
        }
        let _e52 = phi_234_;
        phi_235_ = _e52;
    }
    let _e54 = phi_235_;
    return _e54;
}

fn function_() {
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_304_: bool;
    var phi_308_: bool;
    var phi_352_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_356_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_369_: bool;
    var phi_425_: bool;
    var phi_429_: f32;
    var phi_440_: bool;
    var phi_453_: bool;
    var phi_464_: bool;
    var phi_465_: bool;
    var phi_466_: bool;
    var phi_467_: bool;
    var phi_468_: bool;
    var phi_469_: bool;
    var phi_473_: bool;
    var phi_478_: bool;
    var phi_492_: u32;
    var phi_494_: u32;
    var phi_497_: lt_mask_Neighbourhood;
    var phi_509_: bool;
    var phi_510_: bool;
    var phi_518_: u32;
    var phi_519_: u32;
    var phi_578_: vec2<i32>;
    var phi_594_: vec2<i32>;
    var phi_617_: u32;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_642_: bool;
    var phi_643_: bool;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_495_: u32;
    var phi_498_: lt_mask_Neighbourhood;
    var phi_666_: lt_mask_Neighbourhood;
    var phi_667_: lt_mask_Neighbourhood;
    var phi_692_: bool;
    var phi_693_: bool;
    var phi_706_: bool;
    var phi_707_: bool;
    var phi_708_: bool;
    var phi_715_: u32;
    var phi_716_: u32;
    var phi_717_: u32;
    var phi_718_: u32;
    var phi_719_: u32;
    var phi_727_: bool;
    var phi_735_: u32;
    var phi_740_: u32;
    var phi_744_: u32;
    var phi_745_: u32;
    var phi_749_: f32;
    var phi_751_: mask_Masked;
    var phi_779_: bool;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_786_: bool;
    var phi_814_: f32;
    var phi_817_: bool;
    var phi_818_: u32;
    var phi_829_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e41 = id_1;
    let _e42 = local_2;
    let _e58 = p.member.current.size[0u];
    let _e60 = p.member.current.size[1u];
    let _e61 = lt_shaders_entry_pixel_index(_e41, _e58, _e60);
    if (bitcast<i32>(_e61.root) != 0i) {
        let _e69 = p.member.current.size[0u];
        let _e72 = samples.member[_e61.first_primitive].position;
        let _e74 = visibility.member[_e61.first_primitive];
        let _e78 = p.member.light;
        let _e81 = samples.member[_e61.first_primitive].normal[0u];
        let _e83 = global[0u];
        if (_e81 == _e83) {
            let _e86 = samples.member[_e61.first_primitive].normal[1u];
            let _e88 = global[1u];
            if (_e86 == _e88) {
                let _e91 = samples.member[_e61.first_primitive].normal[2u];
                let _e93 = global[2u];
                phi_301_ = (_e91 == _e93);
                phi_302_ = false;
            } else {
                phi_301_ = bool();
                phi_302_ = true;
            }
            let _e96 = phi_301_;
            let _e98 = phi_302_;
            phi_303_ = _e96;
            phi_304_ = _e98;
        } else {
            phi_303_ = bool();
            phi_304_ = true;
        }
        let _e100 = phi_303_;
        let _e102 = phi_304_;
        if _e102 {
            phi_308_ = false;
        } else {
            phi_308_ = _e100;
        }
        let _e104 = phi_308_;
        if !(_e104) {
            let _e107 = samples.member[_e61.first_primitive].normal;
            let _e109 = samples.member[_e61.first_primitive].position;
            if ((((_e107.x * (_e78.x - (_e109.x * _e78.w))) + (_e107.y * (_e78.y - (_e109.y * _e78.w)))) + (_e107.z * (_e78.z - (_e109.z * _e78.w)))) > 0f) {
                let _e133 = samples.member[_e61.first_primitive].flags;
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e147 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e141.unnamed.visibility, false), _e141.unnamed_1);
                phi_352_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e147.unnamed, ((_e133 & 1u) == 0u));
            } else {
                let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e156.unnamed.visibility, false), _e156.unnamed_1);
                phi_352_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e162.unnamed, true);
            }
            let _e167 = phi_352_;
            phi_356_ = _e167;
        } else {
            let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
            phi_356_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, true);
        }
        let _e184 = phi_356_;
        if _e184.unnamed_1 {
            phi_751_ = mask_Masked(_e184.unnamed.visibility, 0u, false);
        } else {
            let _e189 = (_e74 < 0.5f);
            if (_e74 > 0f) {
                phi_369_ = (_e74 < 1f);
            } else {
                phi_369_ = false;
            }
            let _e193 = phi_369_;
            let _e196 = p.member.previous.eye;
            let _e207 = p.member.previous.forward;
            let _e215 = ((((_e72.x - _e196.x) * _e207.x) + ((_e72.y - _e196.y) * _e207.y)) + ((_e72.z - _e196.z) * _e207.z));
            let _e217 = ((_e41.y * _e69) + _e41.x);
            if (_e217 < arrayLength((&last_depths.member))) {
            } else {
                return;
            }
            let _e221 = last_depths.member[(0u + _e217)];
            let _e223 = p.member.depth_tolerance;
            let _e226 = abs(_e215);
            let _e227 = abs(_e221);
            if ((bitcast<u32>(_e227) & 2147483647u) > 2139095040u) {
                phi_425_ = true;
            } else {
                let _e231 = (_e227 > _e226);
                if _e231 {
                }
                phi_425_ = _e231;
            }
            let _e233 = phi_425_;
            if _e233 {
                phi_429_ = _e227;
            } else {
                phi_429_ = _e226;
            }
            let _e235 = phi_429_;
            if (abs((_e215 - _e221)) <= (_e223 * _e235)) {
                let _e239 = p.member.flags;
                phi_440_ = ((_e239 & 1u) != 0u);
            } else {
                phi_440_ = false;
            }
            let _e243 = phi_440_;
            let _e245 = p.member.flags;
            if false {
                let _e249 = p.member.flags;
                phi_453_ = ((_e249 & 4u) == 0u);
            } else {
                phi_453_ = false;
            }
            let _e253 = phi_453_;
            if ((_e245 & 2u) != 0u) {
                if false {
                    phi_466_ = bool();
                    phi_467_ = true;
                } else {
                    if true {
                        phi_464_ = !(_e253);
                        phi_465_ = false;
                    } else {
                        phi_464_ = bool();
                        phi_465_ = true;
                    }
                    let _e256 = phi_464_;
                    let _e258 = phi_465_;
                    phi_466_ = _e256;
                    phi_467_ = _e258;
                }
                let _e260 = phi_466_;
                let _e262 = phi_467_;
                phi_468_ = _e260;
                phi_469_ = _e262;
            } else {
                phi_468_ = bool();
                phi_469_ = true;
            }
            let _e264 = phi_468_;
            let _e266 = phi_469_;
            if _e266 {
                phi_473_ = false;
            } else {
                phi_473_ = _e264;
            }
            let _e268 = phi_473_;
            let _e269 = lt_mask_Neighbourhood(false, true);
            if _e193 {
                phi_478_ = _e268;
            } else {
                phi_478_ = true;
            }
            let _e271 = phi_478_;
            if _e271 {
                if _e243 {
                    if false {
                        let _e273 = p.member.moving_pattern;
                        phi_492_ = _e273;
                    } else {
                        let _e275 = p.member.still_pattern;
                        phi_492_ = _e275;
                    }
                    let _e277 = phi_492_;
                    phi_494_ = 0u;
                    phi_497_ = _e269;
                    loop {
                        let _e279 = phi_494_;
                        let _e281 = phi_497_;
                        local_1 = _e281;
                        if (1u <= _e277) {
                            if (_e277 <= 4u) {
                                phi_509_ = false;
                            } else {
                                phi_509_ = true;
                            }
                            let _e285 = phi_509_;
                            phi_510_ = _e285;
                        } else {
                            phi_510_ = true;
                        }
                        let _e287 = phi_510_;
                        if _e287 {
                            switch bitcast<i32>(_e277) {
                                case 5: {
                                    phi_518_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_518_ = 25u;
                                    break;
                                }
                                default: {
                                    phi_518_ = 9u;
                                    break;
                                }
                            }
                            let _e290 = phi_518_;
                            phi_519_ = _e290;
                        } else {
                            phi_519_ = 5u;
                        }
                        let _e292 = phi_519_;
                        let _e293 = (_e279 < _e292);
                        if _e293 {
                            let _e295 = p.member.frame;
                            let _e299 = p.member.current.size[0u];
                            let _e301 = p.member.current.size[1u];
                            switch bitcast<i32>(_e277) {
                                case 1: {
                                    let _e311 = lt_mask_pattern_plus(_e279);
                                    phi_594_ = vec2<i32>(_e311.x, _e311.y);
                                    break;
                                }
                                case 2: {
                                    let _e315 = lt_mask_pattern_cross(_e279);
                                    phi_594_ = vec2<i32>(_e315.x, _e315.y);
                                    break;
                                }
                                case 3: {
                                    let _e321 = lt_mask_pattern_plus_or_cross(_e279, ((_e41.x + _e41.y) & 1u));
                                    phi_594_ = vec2<i32>(_e321.x, _e321.y);
                                    break;
                                }
                                case 4: {
                                    let _e326 = lt_mask_pattern_plus_or_cross(_e279, (_e295 & 1u));
                                    phi_594_ = vec2<i32>(_e326.x, _e326.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e295 & 3u)) {
                                        case 0: {
                                            phi_578_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_578_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_578_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_578_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e337 = phi_578_;
                                    phi_594_ = (_e337 + vec2<i32>(bitcast<i32>((_e279 & 1u)), bitcast<i32>(((_e279 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_594_ = vec2<i32>((bitcast<i32>((_e279 % 5u)) - 2i), (bitcast<i32>(((_e279 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                default: {
                                    phi_594_ = vec2<i32>((bitcast<i32>((_e279 % 3u)) - 1i), (bitcast<i32>(((_e279 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e355 = phi_594_;
                            let _e358 = lt_mask_pattern_step_clamped(_e41.x, _e355.x, _e299);
                            let _e359 = lt_mask_pattern_step_clamped(_e41.y, _e355.y, _e301);
                            let _e361 = ((_e359 * _e69) + _e358);
                            if (_e361 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e365 = last_bits.member[(0u + _e361)];
                            if ((_e365 & 2u) == 0u) {
                                phi_617_ = (_e365 & 1u);
                            } else {
                                phi_617_ = (_e365 & 7u);
                            }
                            let _e371 = phi_617_;
                            if _e281.any_expands {
                                phi_643_ = true;
                            } else {
                                if ((_e371 & 2u) != 0u) {
                                    if (((_e371 & 4u) != 0u) != _e189) {
                                        phi_634_ = false;
                                    } else {
                                        phi_634_ = true;
                                    }
                                    let _e380 = phi_634_;
                                    phi_635_ = _e380;
                                } else {
                                    phi_635_ = true;
                                }
                                let _e382 = phi_635_;
                                if _e382 {
                                    phi_642_ = (((_e371 & 1u) != 0u) != _e189);
                                } else {
                                    phi_642_ = true;
                                }
                                let _e387 = phi_642_;
                                phi_643_ = _e387;
                            }
                            let _e389 = phi_643_;
                            if _e281.all_remove {
                                if (((_e371 & 1u) != 0u) == _e189) {
                                    if ((_e371 & 2u) != 0u) {
                                        phi_661_ = (((_e371 & 4u) != 0u) == _e189);
                                    } else {
                                        phi_661_ = true;
                                    }
                                    let _e399 = phi_661_;
                                    phi_662_ = _e399;
                                } else {
                                    phi_662_ = false;
                                }
                                let _e401 = phi_662_;
                                phi_663_ = _e401;
                            } else {
                                phi_663_ = false;
                            }
                            let _e403 = phi_663_;
                            phi_495_ = (_e279 + 1u);
                            phi_498_ = lt_mask_Neighbourhood(_e389, _e403);
                        } else {
                            phi_495_ = u32();
                            phi_498_ = lt_mask_Neighbourhood();
                        }
                        let _e407 = phi_495_;
                        let _e409 = phi_498_;
                        continue;
                        continuing {
                            phi_494_ = _e407;
                            phi_497_ = _e409;
                            break if !(_e293);
                        }
                    }
                    let _e580 = local_1;
                    phi_666_ = _e580;
                } else {
                    phi_666_ = _e269;
                }
                let _e412 = phi_666_;
                phi_667_ = _e412;
            } else {
                phi_667_ = _e269;
            }
            let _e414 = phi_667_;
            if (_e74 != 0.5f) {
                if _e243 {
                    if _e193 {
                        phi_693_ = true;
                    } else {
                        if _e414.any_expands {
                            phi_692_ = false;
                        } else {
                            phi_692_ = true;
                        }
                        let _e419 = phi_692_;
                        phi_693_ = _e419;
                    }
                    let _e421 = phi_693_;
                    if _e421 {
                        if _e193 {
                            if _e268 {
                                if _e414.all_remove {
                                    phi_706_ = false;
                                } else {
                                    phi_706_ = true;
                                }
                                let _e423 = phi_706_;
                                phi_707_ = _e423;
                            } else {
                                phi_707_ = true;
                            }
                            let _e425 = phi_707_;
                            phi_708_ = _e425;
                        } else {
                            phi_708_ = true;
                        }
                        let _e427 = phi_708_;
                        if _e427 {
                            if _e193 {
                                phi_715_ = 1u;
                            } else {
                                phi_715_ = 0u;
                            }
                            let _e429 = phi_715_;
                            phi_716_ = _e429;
                        } else {
                            phi_716_ = 5u;
                        }
                        let _e431 = phi_716_;
                        phi_717_ = _e431;
                    } else {
                        phi_717_ = 4u;
                    }
                    let _e433 = phi_717_;
                    phi_718_ = _e433;
                } else {
                    phi_718_ = 3u;
                }
                let _e435 = phi_718_;
                phi_719_ = _e435;
            } else {
                phi_719_ = 2u;
            }
            let _e437 = phi_719_;
            if !((_e437 == 0u)) {
                phi_727_ = !((_e437 == 5u));
            } else {
                phi_727_ = false;
            }
            let _e443 = phi_727_;
            if _e443 {
                if _e189 {
                    phi_735_ = (2u | 1u);
                } else {
                    phi_735_ = 2u;
                }
                let _e446 = phi_735_;
                if false {
                    phi_740_ = (_e446 | 4u);
                } else {
                    phi_740_ = _e446;
                }
                let _e449 = phi_740_;
                phi_745_ = _e449;
            } else {
                if _e189 {
                    phi_744_ = 1u;
                } else {
                    phi_744_ = 0u;
                }
                let _e451 = phi_744_;
                phi_745_ = _e451;
            }
            let _e453 = phi_745_;
            if _e189 {
                phi_749_ = 0f;
            } else {
                phi_749_ = 1f;
            }
            let _e455 = phi_749_;
            phi_751_ = mask_Masked(_e455, _e453, _e443);
        }
        let _e458 = phi_751_;
        visibility.member[_e61.first_primitive] = _e458.visibility;
        bits.member[_e61.first_primitive] = _e458.bits;
        let _e466 = samples.member[_e61.first_primitive].normal[0u];
        let _e468 = global[0u];
        if (_e466 == _e468) {
            let _e471 = samples.member[_e61.first_primitive].normal[1u];
            let _e473 = global[1u];
            if (_e471 == _e473) {
                let _e476 = samples.member[_e61.first_primitive].normal[2u];
                let _e478 = global[2u];
                phi_779_ = (_e476 == _e478);
                phi_780_ = false;
            } else {
                phi_779_ = bool();
                phi_780_ = true;
            }
            let _e481 = phi_779_;
            let _e483 = phi_780_;
            phi_781_ = _e481;
            phi_782_ = _e483;
        } else {
            phi_781_ = bool();
            phi_782_ = true;
        }
        let _e485 = phi_781_;
        let _e487 = phi_782_;
        if _e487 {
            phi_786_ = false;
        } else {
            phi_786_ = _e485;
        }
        let _e489 = phi_786_;
        if !(_e489) {
            let _e492 = samples.member[_e61.first_primitive].position;
            let _e494 = p.member.current.eye;
            let _e505 = p.member.current.forward;
            phi_814_ = ((((_e492.x - _e494.x) * _e505.x) + ((_e492.y - _e494.y) * _e505.y)) + ((_e492.z - _e494.z) * _e505.z));
        } else {
            phi_814_ = 0f;
        }
        let _e515 = phi_814_;
        depths.member[_e61.first_primitive] = _e515;
        phi_817_ = _e458.needs_ray;
        phi_818_ = _e61.first_primitive;
    } else {
        phi_817_ = false;
        phi_818_ = 0u;
    }
    let _e519 = phi_817_;
    let _e521 = phi_818_;
    if (_e42 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e519 {
        let _e525 = atomicAdd((&shared_[0u]), 1u);
        phi_829_ = _e525;
    } else {
        phi_829_ = 0u;
    }
    let _e527 = phi_829_;
    workgroupBarrier();
    if (_e42 == 0u) {
        let _e531 = atomicLoad((&shared_[0u]));
        let _e532 = atomicAdd((&list.member[3u]), _e531);
        atomicStore((&shared_[1u]), _e532);
    }
    workgroupBarrier();
    if _e519 {
        let _e535 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e535) + _e527)]), _e521);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_depth_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
