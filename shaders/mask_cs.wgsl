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
    expansion: u32,
    pad0_: u32,
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
    var phi_502_: u32;
    var phi_521_: u32;
    var phi_529_: u32;
    var phi_530_: u32;
    var phi_531_: bool;
    var phi_532_: u32;
    var phi_533_: bool;
    var phi_534_: bool;
    var phi_535_: u32;
    var phi_536_: bool;
    var phi_537_: bool;
    var phi_541_: bool;
    var phi_545_: u32;
    var phi_550_: bool;
    var phi_571_: u32;
    var phi_573_: u32;
    var phi_576_: lt_mask_Neighbourhood;
    var phi_588_: bool;
    var phi_589_: bool;
    var phi_598_: u32;
    var phi_599_: u32;
    var phi_659_: vec2<i32>;
    var phi_679_: vec2<i32>;
    var phi_704_: u32;
    var phi_723_: u32;
    var phi_731_: u32;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_762_: bool;
    var phi_763_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_773_: bool;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_776_: bool;
    var phi_791_: bool;
    var phi_792_: bool;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_803_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_813_: bool;
    var phi_814_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_574_: u32;
    var phi_577_: lt_mask_Neighbourhood;
    var phi_842_: lt_mask_Neighbourhood;
    var phi_843_: lt_mask_Neighbourhood;
    var phi_844_: lt_mask_Neighbourhood;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_899_: bool;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_905_: bool;
    var phi_927_: bool;
    var phi_928_: bool;
    var phi_941_: bool;
    var phi_942_: bool;
    var phi_943_: bool;
    var phi_950_: u32;
    var phi_951_: u32;
    var phi_952_: u32;
    var phi_953_: u32;
    var phi_954_: u32;
    var phi_955_: u32;
    var phi_956_: u32;
    var phi_968_: bool;
    var phi_969_: bool;
    var phi_970_: bool;
    var phi_971_: bool;
    var phi_975_: bool;
    var phi_981_: bool;
    var phi_989_: u32;
    var phi_994_: u32;
    var phi_1003_: u32;
    var phi_1008_: u32;
    var phi_1012_: u32;
    var phi_1013_: u32;
    var phi_1014_: u32;
    var phi_1018_: f32;
    var phi_1020_: mask_Masked;
    var phi_1070_: bool;
    var phi_1071_: u32;
    var phi_1082_: u32;
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
        let _e67 = (_e66 / 32u);
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
            phi_1020_ = mask_Masked(_e232.unnamed.visibility, 0u, false);
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
            let _e249 = ((_e247 & 2u) != 0u);
            let _e251 = p.member.flags;
            if ((_e251 & 4u) == 0u) {
                phi_535_ = u32();
                phi_536_ = true;
                phi_537_ = false;
            } else {
                if _e245 {
                    if !(false) {
                        let _e258 = ((((_e42.y * _e74) + _e42.x) * _e70) + _e67);
                        if (_e68 > 29u) {
                            let _e260 = (_e258 + 1u);
                            if (_e260 < _e48) {
                            } else {
                                return;
                            }
                            let _e264 = last_bits.member[(0u + _e260)];
                            phi_502_ = _e264;
                        } else {
                            phi_502_ = 0u;
                        }
                        let _e266 = phi_502_;
                        if (_e258 < _e48) {
                        } else {
                            return;
                        }
                        let _e270 = last_bits.member[(0u + _e258)];
                        let _e273 = (_e270 >> bitcast<u32>((_e68 & 31u)));
                        if (_e68 > 29u) {
                            phi_521_ = (_e273 | (_e266 << bitcast<u32>(((32u - _e68) & 31u))));
                        } else {
                            phi_521_ = _e273;
                        }
                        let _e281 = phi_521_;
                        if ((_e281 & 2u) == 0u) {
                            phi_529_ = (_e281 & 1u);
                        } else {
                            phi_529_ = (_e281 & 7u);
                        }
                        let _e287 = phi_529_;
                        phi_530_ = _e287;
                        phi_531_ = false;
                    } else {
                        phi_530_ = u32();
                        phi_531_ = true;
                    }
                    let _e289 = phi_530_;
                    let _e291 = phi_531_;
                    phi_532_ = _e289;
                    phi_533_ = false;
                    phi_534_ = _e291;
                } else {
                    phi_532_ = u32();
                    phi_533_ = true;
                    phi_534_ = false;
                }
                let _e293 = phi_532_;
                let _e295 = phi_533_;
                let _e297 = phi_534_;
                phi_535_ = _e293;
                phi_536_ = _e295;
                phi_537_ = _e297;
            }
            let _e299 = phi_535_;
            let _e301 = phi_536_;
            let _e303 = phi_537_;
            if _e301 {
                phi_541_ = true;
            } else {
                phi_541_ = _e303;
            }
            let _e305 = phi_541_;
            if _e305 {
                phi_545_ = 0u;
            } else {
                phi_545_ = _e299;
            }
            let _e307 = phi_545_;
            let _e308 = lt_mask_Neighbourhood(false, true);
            if _e241 {
                phi_550_ = _e249;
            } else {
                phi_550_ = true;
            }
            let _e310 = phi_550_;
            if _e310 {
                if _e245 {
                    if ((_e307 & 2u) != 0u) {
                        phi_842_ = _e308;
                    } else {
                        let _e314 = p.member.expansion;
                        if false {
                            let _e316 = p.member.moving_pattern;
                            phi_571_ = _e316;
                        } else {
                            let _e318 = p.member.still_pattern;
                            phi_571_ = _e318;
                        }
                        let _e320 = phi_571_;
                        phi_573_ = 0u;
                        phi_576_ = _e308;
                        loop {
                            let _e322 = phi_573_;
                            let _e324 = phi_576_;
                            local_1 = _e324;
                            if (1u <= _e320) {
                                if (_e320 <= 4u) {
                                    phi_588_ = false;
                                } else {
                                    phi_588_ = true;
                                }
                                let _e328 = phi_588_;
                                phi_589_ = _e328;
                            } else {
                                phi_589_ = true;
                            }
                            let _e330 = phi_589_;
                            if _e330 {
                                switch bitcast<i32>(_e320) {
                                    case 5: {
                                        phi_598_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_598_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_598_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_598_ = 9u;
                                        break;
                                    }
                                }
                                let _e333 = phi_598_;
                                phi_599_ = _e333;
                            } else {
                                phi_599_ = 5u;
                            }
                            let _e335 = phi_599_;
                            let _e336 = (_e322 < _e335);
                            if _e336 {
                                let _e338 = p.member.frame;
                                let _e342 = p.member.current.size[0u];
                                let _e344 = p.member.current.size[1u];
                                switch bitcast<i32>(_e320) {
                                    case 1: {
                                        let _e354 = lt_mask_pattern_plus(_e322);
                                        phi_679_ = vec2<i32>(_e354.x, _e354.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e358 = lt_mask_pattern_cross(_e322);
                                        phi_679_ = vec2<i32>(_e358.x, _e358.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e364 = lt_mask_pattern_plus_or_cross(_e322, ((_e42.x + _e42.y) & 1u));
                                        phi_679_ = vec2<i32>(_e364.x, _e364.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e369 = lt_mask_pattern_plus_or_cross(_e322, (_e338 & 1u));
                                        phi_679_ = vec2<i32>(_e369.x, _e369.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e338 & 3u)) {
                                            case 0: {
                                                phi_659_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_659_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_659_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_659_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e380 = phi_659_;
                                        phi_679_ = (_e380 + vec2<i32>(bitcast<i32>((_e322 & 1u)), bitcast<i32>(((_e322 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_679_ = vec2<i32>((bitcast<i32>((_e322 % 5u)) - 2i), (bitcast<i32>(((_e322 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e397 = lt_mask_pattern_diamond(_e322);
                                        phi_679_ = vec2<i32>(_e397.x, _e397.y);
                                        break;
                                    }
                                    default: {
                                        phi_679_ = vec2<i32>((bitcast<i32>((_e322 % 3u)) - 1i), (bitcast<i32>(((_e322 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e402 = phi_679_;
                                let _e405 = lt_mask_pattern_step_clamped(_e42.x, _e402.x, _e342);
                                let _e406 = lt_mask_pattern_step_clamped(_e42.y, _e402.y, _e344);
                                let _e410 = ((((_e406 * _e74) + _e405) * _e70) + _e67);
                                if (_e68 > 29u) {
                                    let _e412 = (_e410 + 1u);
                                    if (_e412 < _e48) {
                                    } else {
                                        return;
                                    }
                                    let _e416 = last_bits.member[(0u + _e412)];
                                    phi_704_ = _e416;
                                } else {
                                    phi_704_ = 0u;
                                }
                                let _e418 = phi_704_;
                                if (_e410 < _e48) {
                                } else {
                                    return;
                                }
                                let _e422 = last_bits.member[(0u + _e410)];
                                let _e425 = (_e422 >> bitcast<u32>((_e68 & 31u)));
                                if (_e68 > 29u) {
                                    phi_723_ = (_e425 | (_e418 << bitcast<u32>(((32u - _e68) & 31u))));
                                } else {
                                    phi_723_ = _e425;
                                }
                                let _e433 = phi_723_;
                                if ((_e433 & 2u) == 0u) {
                                    phi_731_ = (_e433 & 1u);
                                } else {
                                    phi_731_ = (_e433 & 7u);
                                }
                                let _e439 = phi_731_;
                                if _e324.any_expands {
                                    phi_819_ = true;
                                } else {
                                    if ((_e439 & 2u) != 0u) {
                                        let _e446 = (((_e439 & 4u) != 0u) != _e237);
                                        switch bitcast<i32>(_e314) {
                                            case 1: {
                                                phi_759_ = bool();
                                                phi_760_ = false;
                                                phi_761_ = true;
                                                phi_762_ = false;
                                                phi_763_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e446 {
                                                    phi_757_ = (((_e439 & 4u) != 0u) != ((_e439 & 1u) != 0u));
                                                    phi_758_ = false;
                                                } else {
                                                    phi_757_ = bool();
                                                    phi_758_ = true;
                                                }
                                                let _e454 = phi_757_;
                                                let _e456 = phi_758_;
                                                phi_759_ = _e454;
                                                phi_760_ = false;
                                                phi_761_ = false;
                                                phi_762_ = _e456;
                                                phi_763_ = _e446;
                                                break;
                                            }
                                            default: {
                                                phi_759_ = bool();
                                                phi_760_ = true;
                                                phi_761_ = false;
                                                phi_762_ = false;
                                                phi_763_ = false;
                                                break;
                                            }
                                        }
                                        let _e458 = phi_759_;
                                        let _e460 = phi_760_;
                                        let _e462 = phi_761_;
                                        let _e464 = phi_762_;
                                        let _e466 = phi_763_;
                                        phi_771_ = _e446;
                                        phi_772_ = _e458;
                                        phi_773_ = _e460;
                                        phi_774_ = _e462;
                                        phi_775_ = _e464;
                                        phi_776_ = _e466;
                                    } else {
                                        switch bitcast<i32>(_e314) {
                                            case 1: {
                                                phi_768_ = false;
                                                phi_769_ = true;
                                                phi_770_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_768_ = false;
                                                phi_769_ = false;
                                                phi_770_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_768_ = true;
                                                phi_769_ = false;
                                                phi_770_ = false;
                                                break;
                                            }
                                        }
                                        let _e469 = phi_768_;
                                        let _e471 = phi_769_;
                                        let _e473 = phi_770_;
                                        phi_771_ = false;
                                        phi_772_ = bool();
                                        phi_773_ = _e469;
                                        phi_774_ = _e471;
                                        phi_775_ = _e473;
                                        phi_776_ = false;
                                    }
                                    let _e475 = phi_771_;
                                    let _e477 = phi_772_;
                                    let _e479 = phi_773_;
                                    let _e481 = phi_774_;
                                    let _e483 = phi_775_;
                                    let _e485 = phi_776_;
                                    if _e479 {
                                        if ((_e439 & 2u) != 0u) {
                                            if (((_e439 & 4u) != 0u) != _e237) {
                                                phi_791_ = false;
                                            } else {
                                                phi_791_ = true;
                                            }
                                            let _e492 = phi_791_;
                                            phi_792_ = _e492;
                                        } else {
                                            phi_792_ = true;
                                        }
                                        let _e494 = phi_792_;
                                        if _e494 {
                                            phi_799_ = (((_e439 & 1u) != 0u) != _e237);
                                        } else {
                                            phi_799_ = true;
                                        }
                                        let _e499 = phi_799_;
                                        phi_800_ = _e499;
                                        phi_801_ = false;
                                        phi_802_ = false;
                                        phi_803_ = false;
                                    } else {
                                        phi_800_ = bool();
                                        phi_801_ = _e481;
                                        phi_802_ = _e483;
                                        phi_803_ = _e485;
                                    }
                                    let _e501 = phi_800_;
                                    let _e503 = phi_801_;
                                    let _e505 = phi_802_;
                                    let _e507 = phi_803_;
                                    if _e503 {
                                        phi_807_ = _e475;
                                        phi_808_ = false;
                                        phi_809_ = false;
                                    } else {
                                        phi_807_ = _e501;
                                        phi_808_ = _e505;
                                        phi_809_ = _e507;
                                    }
                                    let _e509 = phi_807_;
                                    let _e511 = phi_808_;
                                    let _e513 = phi_809_;
                                    if _e511 {
                                        phi_813_ = false;
                                        phi_814_ = true;
                                    } else {
                                        phi_813_ = _e477;
                                        phi_814_ = _e513;
                                    }
                                    let _e515 = phi_813_;
                                    let _e517 = phi_814_;
                                    if _e517 {
                                        phi_818_ = _e515;
                                    } else {
                                        phi_818_ = _e509;
                                    }
                                    let _e519 = phi_818_;
                                    phi_819_ = _e519;
                                }
                                let _e521 = phi_819_;
                                if _e324.all_remove {
                                    if (((_e439 & 1u) != 0u) == _e237) {
                                        if ((_e439 & 2u) != 0u) {
                                            phi_837_ = (((_e439 & 4u) != 0u) == _e237);
                                        } else {
                                            phi_837_ = true;
                                        }
                                        let _e531 = phi_837_;
                                        phi_838_ = _e531;
                                    } else {
                                        phi_838_ = false;
                                    }
                                    let _e533 = phi_838_;
                                    phi_839_ = _e533;
                                } else {
                                    phi_839_ = false;
                                }
                                let _e535 = phi_839_;
                                phi_574_ = (_e322 + 1u);
                                phi_577_ = lt_mask_Neighbourhood(_e521, _e535);
                            } else {
                                phi_574_ = u32();
                                phi_577_ = lt_mask_Neighbourhood();
                            }
                            let _e539 = phi_574_;
                            let _e541 = phi_577_;
                            continue;
                            continuing {
                                phi_573_ = _e539;
                                phi_576_ = _e541;
                                break if !(_e336);
                            }
                        }
                        let _e792 = local_1;
                        phi_842_ = _e792;
                    }
                    let _e544 = phi_842_;
                    phi_843_ = _e544;
                } else {
                    phi_843_ = _e308;
                }
                let _e546 = phi_843_;
                phi_844_ = _e546;
            } else {
                phi_844_ = _e308;
            }
            let _e548 = phi_844_;
            let _e551 = p.member.frame;
            let _e553 = p.member.refresh;
            if (_e553 == 0u) {
                phi_877_ = false;
            } else {
                if (_e553 == 0u) {
                    return;
                }
                let _e562 = ((_e42.x + (_e42.y * (((_e553 * 5u) / 8u) | 1u))) + (_e551 % _e553));
                if (_e553 == 0u) {
                    phi_876_ = (_e562 == 0u);
                } else {
                    if (_e553 == 0u) {
                        return;
                    }
                    phi_876_ = ((_e562 % _e553) == 0u);
                }
                let _e569 = phi_876_;
                phi_877_ = _e569;
            }
            let _e571 = phi_877_;
            if _e245 {
                if _e571 {
                    phi_899_ = bool();
                } else {
                    phi_899_ = ((_e307 & 2u) != 0u);
                }
                let _e577 = phi_899_;
                phi_900_ = _e577;
                phi_901_ = _e571;
            } else {
                phi_900_ = bool();
                phi_901_ = true;
            }
            let _e579 = phi_900_;
            let _e581 = phi_901_;
            if _e581 {
                phi_905_ = false;
            } else {
                phi_905_ = _e579;
            }
            let _e583 = phi_905_;
            if _e583 {
                phi_956_ = 7u;
            } else {
                if (_e79 != 0.5f) {
                    if _e245 {
                        if _e571 {
                            phi_953_ = 6u;
                        } else {
                            if _e241 {
                                phi_928_ = true;
                            } else {
                                if _e548.any_expands {
                                    phi_927_ = false;
                                } else {
                                    phi_927_ = true;
                                }
                                let _e585 = phi_927_;
                                phi_928_ = _e585;
                            }
                            let _e587 = phi_928_;
                            if _e587 {
                                if _e241 {
                                    if _e249 {
                                        if _e548.all_remove {
                                            phi_941_ = false;
                                        } else {
                                            phi_941_ = true;
                                        }
                                        let _e589 = phi_941_;
                                        phi_942_ = _e589;
                                    } else {
                                        phi_942_ = true;
                                    }
                                    let _e591 = phi_942_;
                                    phi_943_ = _e591;
                                } else {
                                    phi_943_ = true;
                                }
                                let _e593 = phi_943_;
                                if _e593 {
                                    if _e241 {
                                        phi_950_ = 1u;
                                    } else {
                                        phi_950_ = 0u;
                                    }
                                    let _e595 = phi_950_;
                                    phi_951_ = _e595;
                                } else {
                                    phi_951_ = 5u;
                                }
                                let _e597 = phi_951_;
                                phi_952_ = _e597;
                            } else {
                                phi_952_ = 4u;
                            }
                            let _e599 = phi_952_;
                            phi_953_ = _e599;
                        }
                        let _e601 = phi_953_;
                        phi_954_ = _e601;
                    } else {
                        phi_954_ = 3u;
                    }
                    let _e603 = phi_954_;
                    phi_955_ = _e603;
                } else {
                    phi_955_ = 2u;
                }
                let _e605 = phi_955_;
                phi_956_ = _e605;
            }
            let _e607 = phi_956_;
            if !((_e607 == 0u)) {
                if !((_e607 == 5u)) {
                    phi_968_ = !(_e583);
                    phi_969_ = false;
                } else {
                    phi_968_ = bool();
                    phi_969_ = true;
                }
                let _e614 = phi_968_;
                let _e616 = phi_969_;
                phi_970_ = _e614;
                phi_971_ = _e616;
            } else {
                phi_970_ = bool();
                phi_971_ = true;
            }
            let _e618 = phi_970_;
            let _e620 = phi_971_;
            if _e620 {
                phi_975_ = false;
            } else {
                phi_975_ = _e618;
            }
            let _e622 = phi_975_;
            if _e583 {
                phi_981_ = ((_e307 & 4u) != 0u);
            } else {
                phi_981_ = _e237;
            }
            let _e626 = phi_981_;
            if _e622 {
                if _e237 {
                    phi_989_ = (2u | 1u);
                } else {
                    phi_989_ = 2u;
                }
                let _e629 = phi_989_;
                if false {
                    phi_994_ = (_e629 | 4u);
                } else {
                    phi_994_ = _e629;
                }
                let _e632 = phi_994_;
                phi_1014_ = _e632;
            } else {
                if (_e607 == 7u) {
                    if _e237 {
                        phi_1003_ = (2u | 1u);
                    } else {
                        phi_1003_ = 2u;
                    }
                    let _e636 = phi_1003_;
                    if _e626 {
                        phi_1008_ = (_e636 | 4u);
                    } else {
                        phi_1008_ = _e636;
                    }
                    let _e639 = phi_1008_;
                    phi_1013_ = _e639;
                } else {
                    if _e237 {
                        phi_1012_ = 1u;
                    } else {
                        phi_1012_ = 0u;
                    }
                    let _e641 = phi_1012_;
                    phi_1013_ = _e641;
                }
                let _e643 = phi_1013_;
                phi_1014_ = _e643;
            }
            let _e645 = phi_1014_;
            if _e626 {
                phi_1018_ = 0f;
            } else {
                phi_1018_ = 1f;
            }
            let _e647 = phi_1018_;
            phi_1020_ = mask_Masked(_e647, _e645, _e622);
        }
        let _e650 = phi_1020_;
        visibility.member[_e58.shift] = _e650.visibility;
        let _e655 = p.member.light.number;
        let _e656 = (_e655 * 3u);
        let _e658 = (_e656 % 32u);
        let _e660 = p.member.light.mask_words;
        let _e662 = ((_e58.shift * _e660) + (_e656 / 32u));
        let _e664 = bits.member[_e662];
        bits.member[_e662] = ((_e664 & ~((7u << bitcast<u32>((_e658 & 31u))))) | (_e650.bits << bitcast<u32>((_e658 & 31u))));
        if (_e658 > 29u) {
            let _e679 = bits.member[(_e662 + 1u)];
            let _e681 = (32u - _e658);
            bits.member[(_e662 + 1u)] = ((_e679 & ~((7u >> bitcast<u32>((_e681 & 31u))))) | (_e650.bits >> bitcast<u32>((_e681 & 31u))));
        }
        phi_1070_ = _e650.needs_ray;
        phi_1071_ = _e58.shift;
    } else {
        phi_1070_ = false;
        phi_1071_ = 0u;
    }
    let _e695 = phi_1070_;
    let _e697 = phi_1071_;
    if (_e43 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e695 {
        let _e701 = atomicAdd((&shared_[0u]), 1u);
        phi_1082_ = _e701;
    } else {
        phi_1082_ = 0u;
    }
    let _e703 = phi_1082_;
    workgroupBarrier();
    if (_e43 == 0u) {
        let _e707 = atomicLoad((&shared_[0u]));
        let _e708 = atomicAdd((&list.member[3u]), _e707);
        atomicStore((&shared_[1u]), _e708);
    }
    workgroupBarrier();
    if _e695 {
        let _e711 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e711) + _e703)]), _e697);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
