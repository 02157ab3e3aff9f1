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
    frame: u32,
    still_pattern: u32,
    moving_pattern: u32,
    flags: u32,
    depth_tolerance: f32,
    refresh: u32,
    pad0_: u32,
    pad1_: u32,
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

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
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

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_156_: lt_mask_LightPlace;
    var phi_157_: bool;
    var phi_158_: lt_mask_LightPlace;
    var phi_159_: bool;
    var phi_164_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_156_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_157_ = false;
        } else {
            phi_156_ = lt_mask_LightPlace();
            phi_157_ = true;
        }
        let _e55 = phi_156_;
        let _e57 = phi_157_;
        phi_158_ = _e55;
        phi_159_ = _e57;
    } else {
        phi_158_ = lt_mask_LightPlace();
        phi_159_ = true;
    }
    let _e59 = phi_158_;
    let _e61 = phi_159_;
    if _e61 {
        phi_164_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_164_ = _e59;
    }
    let _e66 = phi_164_;
    return lt_mask_LightPlace(_e66.word, _e66.shift);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_182_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_182_ = vec2(0i);
            break;
        }
        case 1: {
            phi_182_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_182_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_182_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_182_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e51 = phi_182_;
    return vec2<i32>(_e51.x, _e51.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_200_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_200_ = vec2(0i);
            break;
        }
        case 1: {
            phi_200_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_200_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_200_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_200_ = vec2(1i);
            break;
        }
    }
    let _e51 = phi_200_;
    return vec2<i32>(_e51.x, _e51.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_219_: vec2<i32>;

    if (param_6 == 0u) {
        let _e45 = lt_mask_pattern_plus(param_5);
        phi_219_ = vec2<i32>(_e45.x, _e45.y);
    } else {
        let _e49 = lt_mask_pattern_cross(param_5);
        phi_219_ = vec2<i32>(_e49.x, _e49.y);
    }
    let _e54 = phi_219_;
    return vec2<i32>(_e54.x, _e54.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_244_: vec2<i32>;

    let _e43 = (param_7 % 13u);
    switch bitcast<i32>(_e43) {
        case 9: {
            phi_244_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_244_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_244_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_244_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_244_ = vec2<i32>((bitcast<i32>((_e43 % 3u)) - 1i), (bitcast<i32>(((_e43 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e58 = phi_244_;
    return vec2<i32>(_e58.x, _e58.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_265_: u32;
    var phi_266_: u32;

    let _e46 = (bitcast<i32>(param_8) + param_9);
    if (_e46 < 0i) {
        phi_266_ = 0u;
    } else {
        if (_e46 >= bitcast<i32>(param_10)) {
            phi_265_ = (param_10 - 1u);
        } else {
            phi_265_ = bitcast<u32>(_e46);
        }
        let _e53 = phi_265_;
        phi_266_ = _e53;
    }
    let _e55 = phi_266_;
    return _e55;
}

fn function_() {
    var phi_338_: bool;
    var phi_339_: bool;
    var phi_340_: bool;
    var phi_341_: bool;
    var phi_345_: bool;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_427_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_428_: bool;
    var phi_429_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_430_: bool;
    var phi_437_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_441_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_454_: bool;
    var phi_475_: bool;
    var phi_486_: bool;
    var phi_487_: bool;
    var phi_488_: bool;
    var phi_489_: bool;
    var phi_490_: bool;
    var phi_491_: bool;
    var phi_495_: bool;
    var phi_500_: bool;
    var phi_514_: u32;
    var phi_516_: u32;
    var phi_519_: lt_mask_Neighbourhood;
    var phi_531_: bool;
    var phi_532_: bool;
    var phi_541_: u32;
    var phi_542_: u32;
    var phi_602_: vec2<i32>;
    var phi_622_: vec2<i32>;
    var phi_647_: u32;
    var phi_666_: u32;
    var phi_674_: u32;
    var phi_691_: bool;
    var phi_692_: bool;
    var phi_699_: bool;
    var phi_700_: bool;
    var phi_718_: bool;
    var phi_719_: bool;
    var phi_720_: bool;
    var phi_517_: u32;
    var phi_520_: lt_mask_Neighbourhood;
    var phi_723_: lt_mask_Neighbourhood;
    var phi_724_: lt_mask_Neighbourhood;
    var phi_756_: bool;
    var phi_757_: bool;
    var phi_786_: bool;
    var phi_787_: bool;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_809_: u32;
    var phi_810_: u32;
    var phi_811_: u32;
    var phi_812_: u32;
    var phi_813_: u32;
    var phi_814_: u32;
    var phi_822_: bool;
    var phi_830_: u32;
    var phi_835_: u32;
    var phi_839_: u32;
    var phi_840_: u32;
    var phi_844_: f32;
    var phi_846_: mask_Masked;
    var phi_896_: bool;
    var phi_897_: u32;
    var phi_908_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e42 = id_1;
    let _e43 = local_2;
    let _e48 = arrayLength((&last_bits.member));
    let _e55 = p.member.current.size[0u];
    let _e57 = p.member.current.size[1u];
    let _e58 = lt_shaders_entry_pixel_index(_e42, _e55, _e57);
    if (bitcast<i32>(_e58.word) != 0i) {
        let _e65 = p.member.light.number;
        let _e66 = (_e65 * 3u);
        let _e68 = (_e66 % 32u);
        let _e70 = p.member.light.mask_words;
        let _e74 = p.member.current.size[0u];
        let _e79 = visibility.member[_e58.shift];
        let _e85 = samples.member[_e58.shift].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[_e58.shift].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[_e58.shift].normal[2u];
                let _e97 = global[2u];
                phi_338_ = (_e95 == _e97);
                phi_339_ = false;
            } else {
                phi_338_ = bool();
                phi_339_ = true;
            }
            let _e100 = phi_338_;
            let _e102 = phi_339_;
            phi_340_ = _e100;
            phi_341_ = _e102;
        } else {
            phi_340_ = bool();
            phi_341_ = true;
        }
        let _e104 = phi_340_;
        let _e106 = phi_341_;
        if _e106 {
            phi_345_ = false;
        } else {
            phi_345_ = _e104;
        }
        let _e108 = phi_345_;
        if !(_e108) {
            let _e111 = samples.member[_e58.shift].position;
            let _e113 = p.member.light.place;
            let _e119 = p.member.light.place[3u];
            let _e126 = (_e113.x - (_e111.x * _e119));
            let _e127 = (_e113.y - (_e111.y * _e119));
            let _e128 = (_e113.z - (_e111.z * _e119));
            let _e130 = samples.member[_e58.shift].normal;
            if ((((_e130.x * _e126) + (_e130.y * _e127)) + (_e130.z * _e128)) > 0f) {
                let _e144 = (((_e126 * _e126) + (_e127 * _e127)) + (_e128 * _e128));
                let _e146 = p.member.light.axis;
                let _e158 = p.member.light.place[3u];
                if (_e158 == 0f) {
                    phi_416_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_415_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_415_ = false;
                    }
                    let _e169 = phi_415_;
                    phi_416_ = _e169;
                }
                let _e171 = phi_416_;
                if _e171 {
                    let _e173 = samples.member[_e58.shift].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_427_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_428_ = false;
                } else {
                    phi_427_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_428_ = true;
                }
                let _e192 = phi_427_;
                let _e194 = phi_428_;
                phi_429_ = _e192;
                phi_430_ = _e194;
            } else {
                phi_429_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_430_ = true;
            }
            let _e196 = phi_429_;
            let _e198 = phi_430_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_437_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_437_ = _e196;
            }
            let _e215 = phi_437_;
            phi_441_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_441_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_441_;
        if _e232.unnamed_1 {
            phi_846_ = mask_Masked(_e232.unnamed.visibility, 0u, false);
        } else {
            let _e237 = (_e79 < 0.5f);
            if (_e79 > 0f) {
                phi_454_ = (_e79 < 1f);
            } else {
                phi_454_ = false;
            }
            let _e241 = phi_454_;
            let _e243 = p.member.flags;
            let _e245 = ((_e243 & 1u) != 0u);
            let _e247 = p.member.flags;
            if false {
                let _e251 = p.member.flags;
                phi_475_ = ((_e251 & 4u) == 0u);
            } else {
                phi_475_ = false;
            }
            let _e255 = phi_475_;
            if ((_e247 & 2u) != 0u) {
                if false {
                    phi_488_ = bool();
                    phi_489_ = true;
                } else {
                    if true {
                        phi_486_ = !(_e255);
                        phi_487_ = false;
                    } else {
                        phi_486_ = bool();
                        phi_487_ = true;
                    }
                    let _e258 = phi_486_;
                    let _e260 = phi_487_;
                    phi_488_ = _e258;
                    phi_489_ = _e260;
                }
                let _e262 = phi_488_;
                let _e264 = phi_489_;
                phi_490_ = _e262;
                phi_491_ = _e264;
            } else {
                phi_490_ = bool();
                phi_491_ = true;
            }
            let _e266 = phi_490_;
            let _e268 = phi_491_;
            if _e268 {
                phi_495_ = false;
            } else {
                phi_495_ = _e266;
            }
            let _e270 = phi_495_;
            let _e271 = lt_mask_Neighbourhood(false, true);
            if _e241 {
                phi_500_ = _e270;
            } else {
                phi_500_ = true;
            }
            let _e273 = phi_500_;
            if _e273 {
                if _e245 {
                    if false {
                        let _e275 = p.member.moving_pattern;
                        phi_514_ = _e275;
                    } else {
                        let _e277 = p.member.still_pattern;
                        phi_514_ = _e277;
                    }
                    let _e279 = phi_514_;
                    phi_516_ = 0u;
                    phi_519_ = _e271;
                    loop {
                        let _e281 = phi_516_;
                        let _e283 = phi_519_;
                        local_1 = _e283;
                        if (1u <= _e279) {
                            if (_e279 <= 4u) {
                                phi_531_ = false;
                            } else {
                                phi_531_ = true;
                            }
                            let _e287 = phi_531_;
                            phi_532_ = _e287;
                        } else {
                            phi_532_ = true;
                        }
                        let _e289 = phi_532_;
                        if _e289 {
                            switch bitcast<i32>(_e279) {
                                case 5: {
                                    phi_541_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_541_ = 25u;
                                    break;
                                }
                                case 7: {
                                    phi_541_ = 13u;
                                    break;
                                }
                                default: {
                                    phi_541_ = 9u;
                                    break;
                                }
                            }
                            let _e292 = phi_541_;
                            phi_542_ = _e292;
                        } else {
                            phi_542_ = 5u;
                        }
                        let _e294 = phi_542_;
                        let _e295 = (_e281 < _e294);
                        if _e295 {
                            let _e297 = p.member.frame;
                            let _e301 = p.member.current.size[0u];
                            let _e303 = p.member.current.size[1u];
                            switch bitcast<i32>(_e279) {
                                case 1: {
                                    let _e313 = lt_mask_pattern_plus(_e281);
                                    phi_622_ = vec2<i32>(_e313.x, _e313.y);
                                    break;
                                }
                                case 2: {
                                    let _e317 = lt_mask_pattern_cross(_e281);
                                    phi_622_ = vec2<i32>(_e317.x, _e317.y);
                                    break;
                                }
                                case 3: {
                                    let _e323 = lt_mask_pattern_plus_or_cross(_e281, ((_e42.x + _e42.y) & 1u));
                                    phi_622_ = vec2<i32>(_e323.x, _e323.y);
                                    break;
                                }
                                case 4: {
                                    let _e328 = lt_mask_pattern_plus_or_cross(_e281, (_e297 & 1u));
                                    phi_622_ = vec2<i32>(_e328.x, _e328.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e297 & 3u)) {
                                        case 0: {
                                            phi_602_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_602_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_602_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_602_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e339 = phi_602_;
                                    phi_622_ = (_e339 + vec2<i32>(bitcast<i32>((_e281 & 1u)), bitcast<i32>(((_e281 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_622_ = vec2<i32>((bitcast<i32>((_e281 % 5u)) - 2i), (bitcast<i32>(((_e281 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                case 7: {
                                    let _e356 = lt_mask_pattern_diamond(_e281);
                                    phi_622_ = vec2<i32>(_e356.x, _e356.y);
                                    break;
                                }
                                default: {
                                    phi_622_ = vec2<i32>((bitcast<i32>((_e281 % 3u)) - 1i), (bitcast<i32>(((_e281 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e361 = phi_622_;
                            let _e364 = lt_mask_pattern_step_clamped(_e42.x, _e361.x, _e301);
                            let _e365 = lt_mask_pattern_step_clamped(_e42.y, _e361.y, _e303);
                            let _e369 = ((((_e365 * _e74) + _e364) * _e70) + (_e66 / 32u));
                            if (_e68 > 29u) {
                                let _e371 = (_e369 + 1u);
                                if (_e371 < _e48) {
                                } else {
                                    return;
                                }
                                let _e375 = last_bits.member[(0u + _e371)];
                                phi_647_ = _e375;
                            } else {
                                phi_647_ = 0u;
                            }
                            let _e377 = phi_647_;
                            if (_e369 < _e48) {
                            } else {
                                return;
                            }
                            let _e381 = last_bits.member[(0u + _e369)];
                            let _e384 = (_e381 >> bitcast<u32>((_e68 & 31u)));
                            if (_e68 > 29u) {
                                phi_666_ = (_e384 | (_e377 << bitcast<u32>(((32u - _e68) & 31u))));
                            } else {
                                phi_666_ = _e384;
                            }
                            let _e392 = phi_666_;
                            if ((_e392 & 2u) == 0u) {
                                phi_674_ = (_e392 & 1u);
                            } else {
                                phi_674_ = (_e392 & 7u);
                            }
                            let _e398 = phi_674_;
                            if _e283.any_expands {
                                phi_700_ = true;
                            } else {
                                if ((_e398 & 2u) != 0u) {
                                    if (((_e398 & 4u) != 0u) != _e237) {
                                        phi_691_ = false;
                                    } else {
                                        phi_691_ = true;
                                    }
                                    let _e407 = phi_691_;
                                    phi_692_ = _e407;
                                } else {
                                    phi_692_ = true;
                                }
                                let _e409 = phi_692_;
                                if _e409 {
                                    phi_699_ = (((_e398 & 1u) != 0u) != _e237);
                                } else {
                                    phi_699_ = true;
                                }
                                let _e414 = phi_699_;
                                phi_700_ = _e414;
                            }
                            let _e416 = phi_700_;
                            if _e283.all_remove {
                                if (((_e398 & 1u) != 0u) == _e237) {
                                    if ((_e398 & 2u) != 0u) {
                                        phi_718_ = (((_e398 & 4u) != 0u) == _e237);
                                    } else {
                                        phi_718_ = true;
                                    }
                                    let _e426 = phi_718_;
                                    phi_719_ = _e426;
                                } else {
                                    phi_719_ = false;
                                }
                                let _e428 = phi_719_;
                                phi_720_ = _e428;
                            } else {
                                phi_720_ = false;
                            }
                            let _e430 = phi_720_;
                            phi_517_ = (_e281 + 1u);
                            phi_520_ = lt_mask_Neighbourhood(_e416, _e430);
                        } else {
                            phi_517_ = u32();
                            phi_520_ = lt_mask_Neighbourhood();
                        }
                        let _e434 = phi_517_;
                        let _e436 = phi_520_;
                        continue;
                        continuing {
                            phi_516_ = _e434;
                            phi_519_ = _e436;
                            break if !(_e295);
                        }
                    }
                    let _e620 = local_1;
                    phi_723_ = _e620;
                } else {
                    phi_723_ = _e271;
                }
                let _e439 = phi_723_;
                phi_724_ = _e439;
            } else {
                phi_724_ = _e271;
            }
            let _e441 = phi_724_;
            let _e444 = p.member.frame;
            let _e446 = p.member.refresh;
            if (_e446 == 0u) {
                phi_757_ = false;
            } else {
                if (_e446 == 0u) {
                    return;
                }
                let _e455 = ((_e42.x + (_e42.y * (((_e446 * 5u) / 8u) | 1u))) + (_e444 % _e446));
                if (_e446 == 0u) {
                    phi_756_ = (_e455 == 0u);
                } else {
                    if (_e446 == 0u) {
                        return;
                    }
                    phi_756_ = ((_e455 % _e446) == 0u);
                }
                let _e462 = phi_756_;
                phi_757_ = _e462;
            }
            let _e464 = phi_757_;
            if (_e79 != 0.5f) {
                if _e245 {
                    if _e464 {
                        phi_812_ = 6u;
                    } else {
                        if _e241 {
                            phi_787_ = true;
                        } else {
                            if _e441.any_expands {
                                phi_786_ = false;
                            } else {
                                phi_786_ = true;
                            }
                            let _e468 = phi_786_;
                            phi_787_ = _e468;
                        }
                        let _e470 = phi_787_;
                        if _e470 {
                            if _e241 {
                                if _e270 {
                                    if _e441.all_remove {
                                        phi_800_ = false;
                                    } else {
                                        phi_800_ = true;
                                    }
                                    let _e472 = phi_800_;
                                    phi_801_ = _e472;
                                } else {
                                    phi_801_ = true;
                                }
                                let _e474 = phi_801_;
                                phi_802_ = _e474;
                            } else {
                                phi_802_ = true;
                            }
                            let _e476 = phi_802_;
                            if _e476 {
                                if _e241 {
                                    phi_809_ = 1u;
                                } else {
                                    phi_809_ = 0u;
                                }
                                let _e478 = phi_809_;
                                phi_810_ = _e478;
                            } else {
                                phi_810_ = 5u;
                            }
                            let _e480 = phi_810_;
                            phi_811_ = _e480;
                        } else {
                            phi_811_ = 4u;
                        }
                        let _e482 = phi_811_;
                        phi_812_ = _e482;
                    }
                    let _e484 = phi_812_;
                    phi_813_ = _e484;
                } else {
                    phi_813_ = 3u;
                }
                let _e486 = phi_813_;
                phi_814_ = _e486;
            } else {
                phi_814_ = 2u;
            }
            let _e488 = phi_814_;
            if !((_e488 == 0u)) {
                phi_822_ = !((_e488 == 5u));
            } else {
                phi_822_ = false;
            }
            let _e494 = phi_822_;
            if _e494 {
                if _e237 {
                    phi_830_ = (2u | 1u);
                } else {
                    phi_830_ = 2u;
                }
                let _e497 = phi_830_;
                if false {
                    phi_835_ = (_e497 | 4u);
                } else {
                    phi_835_ = _e497;
                }
                let _e500 = phi_835_;
                phi_840_ = _e500;
            } else {
                if _e237 {
                    phi_839_ = 1u;
                } else {
                    phi_839_ = 0u;
                }
                let _e502 = phi_839_;
                phi_840_ = _e502;
            }
            let _e504 = phi_840_;
            if _e237 {
                phi_844_ = 0f;
            } else {
                phi_844_ = 1f;
            }
            let _e506 = phi_844_;
            phi_846_ = mask_Masked(_e506, _e504, _e494);
        }
        let _e509 = phi_846_;
        visibility.member[_e58.shift] = _e509.visibility;
        let _e514 = p.member.light.number;
        let _e515 = (_e514 * 3u);
        let _e517 = (_e515 % 32u);
        let _e519 = p.member.light.mask_words;
        let _e521 = ((_e58.shift * _e519) + (_e515 / 32u));
        let _e523 = bits.member[_e521];
        bits.member[_e521] = ((_e523 & ~((7u << bitcast<u32>((_e517 & 31u))))) | (_e509.bits << bitcast<u32>((_e517 & 31u))));
        if (_e517 > 29u) {
            let _e538 = bits.member[(_e521 + 1u)];
            let _e540 = (32u - _e517);
            bits.member[(_e521 + 1u)] = ((_e538 & ~((7u >> bitcast<u32>((_e540 & 31u))))) | (_e509.bits >> bitcast<u32>((_e540 & 31u))));
        }
        phi_896_ = _e509.needs_ray;
        phi_897_ = _e58.shift;
    } else {
        phi_896_ = false;
        phi_897_ = 0u;
    }
    let _e554 = phi_896_;
    let _e556 = phi_897_;
    if (_e43 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e554 {
        let _e560 = atomicAdd((&shared_[0u]), 1u);
        phi_908_ = _e560;
    } else {
        phi_908_ = 0u;
    }
    let _e562 = phi_908_;
    workgroupBarrier();
    if (_e43 == 0u) {
        let _e566 = atomicLoad((&shared_[0u]));
        let _e567 = atomicAdd((&list.member[3u]), _e566);
        atomicStore((&shared_[1u]), _e567);
    }
    workgroupBarrier();
    if _e554 {
        let _e570 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e570) + _e562)]), _e556);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
