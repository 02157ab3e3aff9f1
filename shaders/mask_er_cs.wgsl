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

struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
}

struct abi_MaskParams {
    current: abi_CameraParams,
    previous: abi_CameraParams,
    light: abi_LightParams,
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

fn lt_mask_pattern_step_clamped(param: u32, param_1: i32, param_2: u32) -> u32 {
    var phi_768_: u32;
    var phi_769_: u32;

    let _e43 = (bitcast<i32>(param) + param_1);
    if (_e43 < 0i) {
        phi_769_ = 0u;
    } else {
        if (_e43 >= bitcast<i32>(param_2)) {
            phi_768_ = (param_2 - 1u);
        } else {
            phi_768_ = bitcast<u32>(_e43);
        }
        let _e50 = phi_768_;
        phi_769_ = _e50;
    }
    let _e52 = phi_769_;
    return _e52;
}

fn lt_mask_pattern_diamond(param_3: u32) -> vec2<i32> {
    var phi_747_: vec2<i32>;

    let _e40 = (param_3 % 13u);
    switch bitcast<i32>(_e40) {
        case 9: {
            phi_747_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_747_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_747_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_747_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_747_ = vec2<i32>((bitcast<i32>((_e40 % 3u)) - 1i), (bitcast<i32>(((_e40 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e55 = phi_747_;
    return vec2<i32>(_e55.x, _e55.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_703_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_703_ = vec2(0i);
            break;
        }
        case 1: {
            phi_703_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_703_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_703_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_703_ = vec2(1i);
            break;
        }
    }
    let _e48 = phi_703_;
    return vec2<i32>(_e48.x, _e48.y);
}

fn lt_mask_pattern_plus(param_5: u32) -> vec2<i32> {
    var phi_685_: vec2<i32>;

    switch bitcast<i32>((param_5 % 5u)) {
        case 0: {
            phi_685_ = vec2(0i);
            break;
        }
        case 1: {
            phi_685_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_685_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_685_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_685_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e48 = phi_685_;
    return vec2<i32>(_e48.x, _e48.y);
}

fn lt_mask_pattern_plus_or_cross(param_6: u32, param_7: u32) -> vec2<i32> {
    var phi_722_: vec2<i32>;

    if (param_7 == 0u) {
        let _e42 = lt_mask_pattern_plus(param_6);
        phi_722_ = vec2<i32>(_e42.x, _e42.y);
    } else {
        let _e46 = lt_mask_pattern_cross(param_6);
        phi_722_ = vec2<i32>(_e46.x, _e46.y);
    }
    let _e51 = phi_722_;
    return vec2<i32>(_e51.x, _e51.y);
}

fn lt_shaders_entry_pixel_index(param_8: vec3<u32>, param_9: u32, param_10: u32) -> lt_bvh_traverse_Tree {
    var phi_659_: lt_bvh_traverse_Tree;
    var phi_660_: bool;
    var phi_661_: lt_bvh_traverse_Tree;
    var phi_662_: bool;
    var phi_667_: lt_bvh_traverse_Tree;

    if (param_8.x < param_9) {
        if (param_8.y < param_10) {
            phi_659_ = lt_bvh_traverse_Tree(1u, ((param_8.y * param_9) + param_8.x));
            phi_660_ = false;
        } else {
            phi_659_ = lt_bvh_traverse_Tree();
            phi_660_ = true;
        }
        let _e52 = phi_659_;
        let _e54 = phi_660_;
        phi_661_ = _e52;
        phi_662_ = _e54;
    } else {
        phi_661_ = lt_bvh_traverse_Tree();
        phi_662_ = true;
    }
    let _e56 = phi_661_;
    let _e58 = phi_662_;
    if _e58 {
        phi_667_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_667_ = _e56;
    }
    let _e63 = phi_667_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn function_() {
    var phi_188_: bool;
    var phi_189_: bool;
    var phi_190_: bool;
    var phi_191_: bool;
    var phi_195_: bool;
    var phi_265_: bool;
    var phi_266_: bool;
    var phi_277_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_278_: bool;
    var phi_279_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_280_: bool;
    var phi_287_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_291_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_304_: bool;
    var phi_338_: u32;
    var phi_340_: u32;
    var phi_343_: lt_mask_Neighbourhood;
    var phi_355_: bool;
    var phi_356_: bool;
    var phi_365_: u32;
    var phi_366_: u32;
    var phi_426_: vec2<i32>;
    var phi_446_: vec2<i32>;
    var phi_469_: u32;
    var phi_486_: bool;
    var phi_487_: bool;
    var phi_494_: bool;
    var phi_495_: bool;
    var phi_513_: bool;
    var phi_514_: bool;
    var phi_515_: bool;
    var phi_341_: u32;
    var phi_344_: lt_mask_Neighbourhood;
    var phi_518_: lt_mask_Neighbourhood;
    var phi_519_: lt_mask_Neighbourhood;
    var phi_520_: lt_mask_Neighbourhood;
    var phi_545_: bool;
    var phi_546_: bool;
    var phi_559_: bool;
    var phi_560_: bool;
    var phi_561_: bool;
    var phi_568_: u32;
    var phi_569_: u32;
    var phi_570_: u32;
    var phi_571_: u32;
    var phi_572_: u32;
    var phi_580_: bool;
    var phi_588_: u32;
    var phi_593_: u32;
    var phi_597_: u32;
    var phi_598_: u32;
    var phi_602_: f32;
    var phi_604_: mask_Masked;
    var phi_610_: bool;
    var phi_611_: u32;
    var phi_622_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e39 = id_1;
    let _e40 = local_2;
    let _e52 = p.member.current.size[0u];
    let _e54 = p.member.current.size[1u];
    let _e55 = lt_shaders_entry_pixel_index(_e39, _e52, _e54);
    if (bitcast<i32>(_e55.root) != 0i) {
        let _e63 = p.member.current.size[0u];
        let _e68 = visibility.member[_e55.first_primitive];
        let _e74 = samples.member[_e55.first_primitive].normal[0u];
        let _e76 = global[0u];
        if (_e74 == _e76) {
            let _e79 = samples.member[_e55.first_primitive].normal[1u];
            let _e81 = global[1u];
            if (_e79 == _e81) {
                let _e84 = samples.member[_e55.first_primitive].normal[2u];
                let _e86 = global[2u];
                phi_188_ = (_e84 == _e86);
                phi_189_ = false;
            } else {
                phi_188_ = bool();
                phi_189_ = true;
            }
            let _e89 = phi_188_;
            let _e91 = phi_189_;
            phi_190_ = _e89;
            phi_191_ = _e91;
        } else {
            phi_190_ = bool();
            phi_191_ = true;
        }
        let _e93 = phi_190_;
        let _e95 = phi_191_;
        if _e95 {
            phi_195_ = false;
        } else {
            phi_195_ = _e93;
        }
        let _e97 = phi_195_;
        if !(_e97) {
            let _e100 = samples.member[_e55.first_primitive].position;
            let _e102 = p.member.light.place;
            let _e108 = p.member.light.place[3u];
            let _e115 = (_e102.x - (_e100.x * _e108));
            let _e116 = (_e102.y - (_e100.y * _e108));
            let _e117 = (_e102.z - (_e100.z * _e108));
            let _e119 = samples.member[_e55.first_primitive].normal;
            if ((((_e119.x * _e115) + (_e119.y * _e116)) + (_e119.z * _e117)) > 0f) {
                let _e133 = (((_e115 * _e115) + (_e116 * _e116)) + (_e117 * _e117));
                let _e135 = p.member.light.axis;
                let _e147 = p.member.light.place[3u];
                if (_e147 == 0f) {
                    phi_266_ = true;
                } else {
                    let _e150 = p.member.light.range_squared;
                    if (_e133 <= _e150) {
                        let _e153 = p.member.light.cos_outer;
                        phi_265_ = (-((((_e115 * _e135.x) + (_e116 * _e135.y)) + (_e117 * _e135.z))) >= (_e153 * sqrt(_e133)));
                    } else {
                        phi_265_ = false;
                    }
                    let _e158 = phi_265_;
                    phi_266_ = _e158;
                }
                let _e160 = phi_266_;
                if _e160 {
                    let _e162 = samples.member[_e55.first_primitive].flags;
                    let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
                    phi_277_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, ((_e162 & 1u) == 0u));
                    phi_278_ = false;
                } else {
                    phi_277_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_278_ = true;
                }
                let _e181 = phi_277_;
                let _e183 = phi_278_;
                phi_279_ = _e181;
                phi_280_ = _e183;
            } else {
                phi_279_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_280_ = true;
            }
            let _e185 = phi_279_;
            let _e187 = phi_280_;
            if _e187 {
                let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e193.unnamed.visibility, false), _e193.unnamed_1);
                phi_287_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e199.unnamed, true);
            } else {
                phi_287_ = _e185;
            }
            let _e204 = phi_287_;
            phi_291_ = _e204;
        } else {
            let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e210.unnamed.visibility, false), _e210.unnamed_1);
            phi_291_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e216.unnamed, true);
        }
        let _e221 = phi_291_;
        if _e221.unnamed_1 {
            phi_604_ = mask_Masked(_e221.unnamed.visibility, 0u, false);
        } else {
            let _e226 = (_e68 < 0.5f);
            if (_e68 > 0f) {
                phi_304_ = (_e68 < 1f);
            } else {
                phi_304_ = false;
            }
            let _e230 = phi_304_;
            let _e232 = p.member.flags;
            let _e234 = ((_e232 & 1u) != 0u);
            if false {
            }
            let _e239 = lt_mask_Neighbourhood(false, true);
            if _e230 {
                phi_520_ = _e239;
            } else {
                if true {
                    if _e234 {
                        if false {
                            let _e241 = p.member.moving_pattern;
                            phi_338_ = _e241;
                        } else {
                            let _e243 = p.member.still_pattern;
                            phi_338_ = _e243;
                        }
                        let _e245 = phi_338_;
                        phi_340_ = 0u;
                        phi_343_ = _e239;
                        loop {
                            let _e247 = phi_340_;
                            let _e249 = phi_343_;
                            local_1 = _e249;
                            if (1u <= _e245) {
                                if (_e245 <= 4u) {
                                    phi_355_ = false;
                                } else {
                                    phi_355_ = true;
                                }
                                let _e253 = phi_355_;
                                phi_356_ = _e253;
                            } else {
                                phi_356_ = true;
                            }
                            let _e255 = phi_356_;
                            if _e255 {
                                switch bitcast<i32>(_e245) {
                                    case 5: {
                                        phi_365_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_365_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_365_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_365_ = 9u;
                                        break;
                                    }
                                }
                                let _e258 = phi_365_;
                                phi_366_ = _e258;
                            } else {
                                phi_366_ = 5u;
                            }
                            let _e260 = phi_366_;
                            let _e261 = (_e247 < _e260);
                            if _e261 {
                                let _e263 = p.member.frame;
                                let _e267 = p.member.current.size[0u];
                                let _e269 = p.member.current.size[1u];
                                switch bitcast<i32>(_e245) {
                                    case 1: {
                                        let _e279 = lt_mask_pattern_plus(_e247);
                                        phi_446_ = vec2<i32>(_e279.x, _e279.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e283 = lt_mask_pattern_cross(_e247);
                                        phi_446_ = vec2<i32>(_e283.x, _e283.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e289 = lt_mask_pattern_plus_or_cross(_e247, ((_e39.x + _e39.y) & 1u));
                                        phi_446_ = vec2<i32>(_e289.x, _e289.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e294 = lt_mask_pattern_plus_or_cross(_e247, (_e263 & 1u));
                                        phi_446_ = vec2<i32>(_e294.x, _e294.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e263 & 3u)) {
                                            case 0: {
                                                phi_426_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_426_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_426_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_426_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e305 = phi_426_;
                                        phi_446_ = (_e305 + vec2<i32>(bitcast<i32>((_e247 & 1u)), bitcast<i32>(((_e247 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_446_ = vec2<i32>((bitcast<i32>((_e247 % 5u)) - 2i), (bitcast<i32>(((_e247 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e322 = lt_mask_pattern_diamond(_e247);
                                        phi_446_ = vec2<i32>(_e322.x, _e322.y);
                                        break;
                                    }
                                    default: {
                                        phi_446_ = vec2<i32>((bitcast<i32>((_e247 % 3u)) - 1i), (bitcast<i32>(((_e247 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e327 = phi_446_;
                                let _e330 = lt_mask_pattern_step_clamped(_e39.x, _e327.x, _e267);
                                let _e331 = lt_mask_pattern_step_clamped(_e39.y, _e327.y, _e269);
                                let _e333 = ((_e331 * _e63) + _e330);
                                if (_e333 < arrayLength((&last_bits.member))) {
                                } else {
                                    return;
                                }
                                let _e337 = last_bits.member[(0u + _e333)];
                                if ((_e337 & 2u) == 0u) {
                                    phi_469_ = (_e337 & 1u);
                                } else {
                                    phi_469_ = (_e337 & 7u);
                                }
                                let _e343 = phi_469_;
                                if _e249.any_expands {
                                    phi_495_ = true;
                                } else {
                                    if ((_e343 & 2u) != 0u) {
                                        if (((_e343 & 4u) != 0u) != _e226) {
                                            phi_486_ = false;
                                        } else {
                                            phi_486_ = true;
                                        }
                                        let _e352 = phi_486_;
                                        phi_487_ = _e352;
                                    } else {
                                        phi_487_ = true;
                                    }
                                    let _e354 = phi_487_;
                                    if _e354 {
                                        phi_494_ = (((_e343 & 1u) != 0u) != _e226);
                                    } else {
                                        phi_494_ = true;
                                    }
                                    let _e359 = phi_494_;
                                    phi_495_ = _e359;
                                }
                                let _e361 = phi_495_;
                                if _e249.all_remove {
                                    if (((_e343 & 1u) != 0u) == _e226) {
                                        if ((_e343 & 2u) != 0u) {
                                            phi_513_ = (((_e343 & 4u) != 0u) == _e226);
                                        } else {
                                            phi_513_ = true;
                                        }
                                        let _e371 = phi_513_;
                                        phi_514_ = _e371;
                                    } else {
                                        phi_514_ = false;
                                    }
                                    let _e373 = phi_514_;
                                    phi_515_ = _e373;
                                } else {
                                    phi_515_ = false;
                                }
                                let _e375 = phi_515_;
                                phi_341_ = (_e247 + 1u);
                                phi_344_ = lt_mask_Neighbourhood(_e361, _e375);
                            } else {
                                phi_341_ = u32();
                                phi_344_ = lt_mask_Neighbourhood();
                            }
                            let _e379 = phi_341_;
                            let _e381 = phi_344_;
                            continue;
                            continuing {
                                phi_340_ = _e379;
                                phi_343_ = _e381;
                                break if !(_e261);
                            }
                        }
                        let _e494 = local_1;
                        phi_518_ = _e494;
                    } else {
                        phi_518_ = _e239;
                    }
                    let _e384 = phi_518_;
                    phi_519_ = _e384;
                } else {
                    phi_519_ = _e239;
                }
                let _e386 = phi_519_;
                phi_520_ = _e386;
            }
            let _e388 = phi_520_;
            if (_e68 != 0.5f) {
                if _e234 {
                    if _e230 {
                        phi_546_ = true;
                    } else {
                        if _e388.any_expands {
                            phi_545_ = false;
                        } else {
                            phi_545_ = true;
                        }
                        let _e393 = phi_545_;
                        phi_546_ = _e393;
                    }
                    let _e395 = phi_546_;
                    if _e395 {
                        if _e230 {
                            if false {
                                if _e388.all_remove {
                                    phi_559_ = false;
                                } else {
                                    phi_559_ = true;
                                }
                                let _e397 = phi_559_;
                                phi_560_ = _e397;
                            } else {
                                phi_560_ = true;
                            }
                            let _e399 = phi_560_;
                            phi_561_ = _e399;
                        } else {
                            phi_561_ = true;
                        }
                        let _e401 = phi_561_;
                        if _e401 {
                            if _e230 {
                                phi_568_ = 1u;
                            } else {
                                phi_568_ = 0u;
                            }
                            let _e403 = phi_568_;
                            phi_569_ = _e403;
                        } else {
                            phi_569_ = 5u;
                        }
                        let _e405 = phi_569_;
                        phi_570_ = _e405;
                    } else {
                        phi_570_ = 4u;
                    }
                    let _e407 = phi_570_;
                    phi_571_ = _e407;
                } else {
                    phi_571_ = 3u;
                }
                let _e409 = phi_571_;
                phi_572_ = _e409;
            } else {
                phi_572_ = 2u;
            }
            let _e411 = phi_572_;
            if !((_e411 == 0u)) {
                phi_580_ = !((_e411 == 5u));
            } else {
                phi_580_ = false;
            }
            let _e417 = phi_580_;
            if _e417 {
                if _e226 {
                    phi_588_ = (2u | 1u);
                } else {
                    phi_588_ = 2u;
                }
                let _e420 = phi_588_;
                if false {
                    phi_593_ = (_e420 | 4u);
                } else {
                    phi_593_ = _e420;
                }
                let _e423 = phi_593_;
                phi_598_ = _e423;
            } else {
                if _e226 {
                    phi_597_ = 1u;
                } else {
                    phi_597_ = 0u;
                }
                let _e425 = phi_597_;
                phi_598_ = _e425;
            }
            let _e427 = phi_598_;
            if _e226 {
                phi_602_ = 0f;
            } else {
                phi_602_ = 1f;
            }
            let _e429 = phi_602_;
            phi_604_ = mask_Masked(_e429, _e427, _e417);
        }
        let _e432 = phi_604_;
        visibility.member[_e55.first_primitive] = _e432.visibility;
        bits.member[_e55.first_primitive] = _e432.bits;
        phi_610_ = _e432.needs_ray;
        phi_611_ = _e55.first_primitive;
    } else {
        phi_610_ = false;
        phi_611_ = 0u;
    }
    let _e439 = phi_610_;
    let _e441 = phi_611_;
    if (_e40 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e439 {
        let _e445 = atomicAdd((&shared_[0u]), 1u);
        phi_622_ = _e445;
    } else {
        phi_622_ = 0u;
    }
    let _e447 = phi_622_;
    workgroupBarrier();
    if (_e40 == 0u) {
        let _e451 = atomicLoad((&shared_[0u]));
        let _e452 = atomicAdd((&list.member[3u]), _e451);
        atomicStore((&shared_[1u]), _e452);
    }
    workgroupBarrier();
    if _e439 {
        let _e455 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e455) + _e447)]), _e441);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
