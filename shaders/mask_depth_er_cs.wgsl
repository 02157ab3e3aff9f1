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
    var phi_466_: u32;
    var phi_468_: u32;
    var phi_471_: lt_mask_Neighbourhood;
    var phi_483_: bool;
    var phi_484_: bool;
    var phi_492_: u32;
    var phi_493_: u32;
    var phi_552_: vec2<i32>;
    var phi_568_: vec2<i32>;
    var phi_591_: u32;
    var phi_608_: bool;
    var phi_609_: bool;
    var phi_616_: bool;
    var phi_617_: bool;
    var phi_635_: bool;
    var phi_636_: bool;
    var phi_637_: bool;
    var phi_469_: u32;
    var phi_472_: lt_mask_Neighbourhood;
    var phi_640_: lt_mask_Neighbourhood;
    var phi_641_: lt_mask_Neighbourhood;
    var phi_642_: lt_mask_Neighbourhood;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_681_: bool;
    var phi_682_: bool;
    var phi_683_: bool;
    var phi_690_: u32;
    var phi_691_: u32;
    var phi_692_: u32;
    var phi_693_: u32;
    var phi_694_: u32;
    var phi_702_: bool;
    var phi_710_: u32;
    var phi_715_: u32;
    var phi_719_: u32;
    var phi_720_: u32;
    var phi_724_: f32;
    var phi_726_: mask_Masked;
    var phi_754_: bool;
    var phi_755_: bool;
    var phi_756_: bool;
    var phi_757_: bool;
    var phi_761_: bool;
    var phi_789_: f32;
    var phi_792_: bool;
    var phi_793_: u32;
    var phi_804_: u32;
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
            phi_726_ = mask_Masked(_e184.unnamed.visibility, 0u, false);
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
            if false {
            }
            let _e248 = lt_mask_Neighbourhood(false, true);
            if _e193 {
                phi_642_ = _e248;
            } else {
                if true {
                    if _e243 {
                        if false {
                            let _e250 = p.member.moving_pattern;
                            phi_466_ = _e250;
                        } else {
                            let _e252 = p.member.still_pattern;
                            phi_466_ = _e252;
                        }
                        let _e254 = phi_466_;
                        phi_468_ = 0u;
                        phi_471_ = _e248;
                        loop {
                            let _e256 = phi_468_;
                            let _e258 = phi_471_;
                            local_1 = _e258;
                            if (1u <= _e254) {
                                if (_e254 <= 4u) {
                                    phi_483_ = false;
                                } else {
                                    phi_483_ = true;
                                }
                                let _e262 = phi_483_;
                                phi_484_ = _e262;
                            } else {
                                phi_484_ = true;
                            }
                            let _e264 = phi_484_;
                            if _e264 {
                                switch bitcast<i32>(_e254) {
                                    case 5: {
                                        phi_492_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_492_ = 25u;
                                        break;
                                    }
                                    default: {
                                        phi_492_ = 9u;
                                        break;
                                    }
                                }
                                let _e267 = phi_492_;
                                phi_493_ = _e267;
                            } else {
                                phi_493_ = 5u;
                            }
                            let _e269 = phi_493_;
                            let _e270 = (_e256 < _e269);
                            if _e270 {
                                let _e272 = p.member.frame;
                                let _e276 = p.member.current.size[0u];
                                let _e278 = p.member.current.size[1u];
                                switch bitcast<i32>(_e254) {
                                    case 1: {
                                        let _e288 = lt_mask_pattern_plus(_e256);
                                        phi_568_ = vec2<i32>(_e288.x, _e288.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e292 = lt_mask_pattern_cross(_e256);
                                        phi_568_ = vec2<i32>(_e292.x, _e292.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e298 = lt_mask_pattern_plus_or_cross(_e256, ((_e41.x + _e41.y) & 1u));
                                        phi_568_ = vec2<i32>(_e298.x, _e298.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e303 = lt_mask_pattern_plus_or_cross(_e256, (_e272 & 1u));
                                        phi_568_ = vec2<i32>(_e303.x, _e303.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e272 & 3u)) {
                                            case 0: {
                                                phi_552_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_552_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_552_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_552_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e314 = phi_552_;
                                        phi_568_ = (_e314 + vec2<i32>(bitcast<i32>((_e256 & 1u)), bitcast<i32>(((_e256 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_568_ = vec2<i32>((bitcast<i32>((_e256 % 5u)) - 2i), (bitcast<i32>(((_e256 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    default: {
                                        phi_568_ = vec2<i32>((bitcast<i32>((_e256 % 3u)) - 1i), (bitcast<i32>(((_e256 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e332 = phi_568_;
                                let _e335 = lt_mask_pattern_step_clamped(_e41.x, _e332.x, _e276);
                                let _e336 = lt_mask_pattern_step_clamped(_e41.y, _e332.y, _e278);
                                let _e338 = ((_e336 * _e69) + _e335);
                                if (_e338 < arrayLength((&last_bits.member))) {
                                } else {
                                    return;
                                }
                                let _e342 = last_bits.member[(0u + _e338)];
                                if ((_e342 & 2u) == 0u) {
                                    phi_591_ = (_e342 & 1u);
                                } else {
                                    phi_591_ = (_e342 & 7u);
                                }
                                let _e348 = phi_591_;
                                if _e258.any_expands {
                                    phi_617_ = true;
                                } else {
                                    if ((_e348 & 2u) != 0u) {
                                        if (((_e348 & 4u) != 0u) != _e189) {
                                            phi_608_ = false;
                                        } else {
                                            phi_608_ = true;
                                        }
                                        let _e357 = phi_608_;
                                        phi_609_ = _e357;
                                    } else {
                                        phi_609_ = true;
                                    }
                                    let _e359 = phi_609_;
                                    if _e359 {
                                        phi_616_ = (((_e348 & 1u) != 0u) != _e189);
                                    } else {
                                        phi_616_ = true;
                                    }
                                    let _e364 = phi_616_;
                                    phi_617_ = _e364;
                                }
                                let _e366 = phi_617_;
                                if _e258.all_remove {
                                    if (((_e348 & 1u) != 0u) == _e189) {
                                        if ((_e348 & 2u) != 0u) {
                                            phi_635_ = (((_e348 & 4u) != 0u) == _e189);
                                        } else {
                                            phi_635_ = true;
                                        }
                                        let _e376 = phi_635_;
                                        phi_636_ = _e376;
                                    } else {
                                        phi_636_ = false;
                                    }
                                    let _e378 = phi_636_;
                                    phi_637_ = _e378;
                                } else {
                                    phi_637_ = false;
                                }
                                let _e380 = phi_637_;
                                phi_469_ = (_e256 + 1u);
                                phi_472_ = lt_mask_Neighbourhood(_e366, _e380);
                            } else {
                                phi_469_ = u32();
                                phi_472_ = lt_mask_Neighbourhood();
                            }
                            let _e384 = phi_469_;
                            let _e386 = phi_472_;
                            continue;
                            continuing {
                                phi_468_ = _e384;
                                phi_471_ = _e386;
                                break if !(_e270);
                            }
                        }
                        let _e550 = local_1;
                        phi_640_ = _e550;
                    } else {
                        phi_640_ = _e248;
                    }
                    let _e389 = phi_640_;
                    phi_641_ = _e389;
                } else {
                    phi_641_ = _e248;
                }
                let _e391 = phi_641_;
                phi_642_ = _e391;
            }
            let _e393 = phi_642_;
            if (_e74 != 0.5f) {
                if _e243 {
                    if _e193 {
                        phi_668_ = true;
                    } else {
                        if _e393.any_expands {
                            phi_667_ = false;
                        } else {
                            phi_667_ = true;
                        }
                        let _e398 = phi_667_;
                        phi_668_ = _e398;
                    }
                    let _e400 = phi_668_;
                    if _e400 {
                        if _e193 {
                            if false {
                                if _e393.all_remove {
                                    phi_681_ = false;
                                } else {
                                    phi_681_ = true;
                                }
                                let _e402 = phi_681_;
                                phi_682_ = _e402;
                            } else {
                                phi_682_ = true;
                            }
                            let _e404 = phi_682_;
                            phi_683_ = _e404;
                        } else {
                            phi_683_ = true;
                        }
                        let _e406 = phi_683_;
                        if _e406 {
                            if _e193 {
                                phi_690_ = 1u;
                            } else {
                                phi_690_ = 0u;
                            }
                            let _e408 = phi_690_;
                            phi_691_ = _e408;
                        } else {
                            phi_691_ = 5u;
                        }
                        let _e410 = phi_691_;
                        phi_692_ = _e410;
                    } else {
                        phi_692_ = 4u;
                    }
                    let _e412 = phi_692_;
                    phi_693_ = _e412;
                } else {
                    phi_693_ = 3u;
                }
                let _e414 = phi_693_;
                phi_694_ = _e414;
            } else {
                phi_694_ = 2u;
            }
            let _e416 = phi_694_;
            if !((_e416 == 0u)) {
                phi_702_ = !((_e416 == 5u));
            } else {
                phi_702_ = false;
            }
            let _e422 = phi_702_;
            if _e422 {
                if _e189 {
                    phi_710_ = (2u | 1u);
                } else {
                    phi_710_ = 2u;
                }
                let _e425 = phi_710_;
                if false {
                    phi_715_ = (_e425 | 4u);
                } else {
                    phi_715_ = _e425;
                }
                let _e428 = phi_715_;
                phi_720_ = _e428;
            } else {
                if _e189 {
                    phi_719_ = 1u;
                } else {
                    phi_719_ = 0u;
                }
                let _e430 = phi_719_;
                phi_720_ = _e430;
            }
            let _e432 = phi_720_;
            if _e189 {
                phi_724_ = 0f;
            } else {
                phi_724_ = 1f;
            }
            let _e434 = phi_724_;
            phi_726_ = mask_Masked(_e434, _e432, _e422);
        }
        let _e437 = phi_726_;
        visibility.member[_e61.first_primitive] = _e437.visibility;
        bits.member[_e61.first_primitive] = _e437.bits;
        let _e445 = samples.member[_e61.first_primitive].normal[0u];
        let _e447 = global[0u];
        if (_e445 == _e447) {
            let _e450 = samples.member[_e61.first_primitive].normal[1u];
            let _e452 = global[1u];
            if (_e450 == _e452) {
                let _e455 = samples.member[_e61.first_primitive].normal[2u];
                let _e457 = global[2u];
                phi_754_ = (_e455 == _e457);
                phi_755_ = false;
            } else {
                phi_754_ = bool();
                phi_755_ = true;
            }
            let _e460 = phi_754_;
            let _e462 = phi_755_;
            phi_756_ = _e460;
            phi_757_ = _e462;
        } else {
            phi_756_ = bool();
            phi_757_ = true;
        }
        let _e464 = phi_756_;
        let _e466 = phi_757_;
        if _e466 {
            phi_761_ = false;
        } else {
            phi_761_ = _e464;
        }
        let _e468 = phi_761_;
        if !(_e468) {
            let _e471 = samples.member[_e61.first_primitive].position;
            let _e473 = p.member.current.eye;
            let _e484 = p.member.current.forward;
            phi_789_ = ((((_e471.x - _e473.x) * _e484.x) + ((_e471.y - _e473.y) * _e484.y)) + ((_e471.z - _e473.z) * _e484.z));
        } else {
            phi_789_ = 0f;
        }
        let _e494 = phi_789_;
        depths.member[_e61.first_primitive] = _e494;
        phi_792_ = _e437.needs_ray;
        phi_793_ = _e61.first_primitive;
    } else {
        phi_792_ = false;
        phi_793_ = 0u;
    }
    let _e498 = phi_792_;
    let _e500 = phi_793_;
    if (_e42 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e498 {
        let _e504 = atomicAdd((&shared_[0u]), 1u);
        phi_804_ = _e504;
    } else {
        phi_804_ = 0u;
    }
    let _e506 = phi_804_;
    workgroupBarrier();
    if (_e42 == 0u) {
        let _e510 = atomicLoad((&shared_[0u]));
        let _e511 = atomicAdd((&list.member[3u]), _e510);
        atomicStore((&shared_[1u]), _e511);
    }
    workgroupBarrier();
    if _e498 {
        let _e514 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e514) + _e506)]), _e500);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
