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

fn lt_mask_pattern_step_clamped(param: u32, param_1: i32, param_2: u32) -> u32 {
    var phi_1016_: u32;
    var phi_1017_: u32;

    let _e46 = (bitcast<i32>(param) + param_1);
    if (_e46 < 0i) {
        phi_1017_ = 0u;
    } else {
        if (_e46 >= bitcast<i32>(param_2)) {
            phi_1016_ = (param_2 - 1u);
        } else {
            phi_1016_ = bitcast<u32>(_e46);
        }
        let _e53 = phi_1016_;
        phi_1017_ = _e53;
    }
    let _e55 = phi_1017_;
    return _e55;
}

fn lt_mask_pattern_diamond(param_3: u32) -> vec2<i32> {
    var phi_995_: vec2<i32>;

    let _e43 = (param_3 % 13u);
    switch bitcast<i32>(_e43) {
        case 9: {
            phi_995_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_995_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_995_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_995_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_995_ = vec2<i32>((bitcast<i32>((_e43 % 3u)) - 1i), (bitcast<i32>(((_e43 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e58 = phi_995_;
    return vec2<i32>(_e58.x, _e58.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_951_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_951_ = vec2(0i);
            break;
        }
        case 1: {
            phi_951_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_951_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_951_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_951_ = vec2(1i);
            break;
        }
    }
    let _e51 = phi_951_;
    return vec2<i32>(_e51.x, _e51.y);
}

fn lt_mask_pattern_plus(param_5: u32) -> vec2<i32> {
    var phi_933_: vec2<i32>;

    switch bitcast<i32>((param_5 % 5u)) {
        case 0: {
            phi_933_ = vec2(0i);
            break;
        }
        case 1: {
            phi_933_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_933_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_933_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_933_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e51 = phi_933_;
    return vec2<i32>(_e51.x, _e51.y);
}

fn lt_mask_pattern_plus_or_cross(param_6: u32, param_7: u32) -> vec2<i32> {
    var phi_970_: vec2<i32>;

    if (param_7 == 0u) {
        let _e45 = lt_mask_pattern_plus(param_6);
        phi_970_ = vec2<i32>(_e45.x, _e45.y);
    } else {
        let _e49 = lt_mask_pattern_cross(param_6);
        phi_970_ = vec2<i32>(_e49.x, _e49.y);
    }
    let _e54 = phi_970_;
    return vec2<i32>(_e54.x, _e54.y);
}

fn lt_shaders_entry_pixel_index(param_8: vec3<u32>, param_9: u32, param_10: u32) -> lt_mask_LightPlace {
    var phi_907_: lt_mask_LightPlace;
    var phi_908_: bool;
    var phi_909_: lt_mask_LightPlace;
    var phi_910_: bool;
    var phi_915_: lt_mask_LightPlace;

    if (param_8.x < param_9) {
        if (param_8.y < param_10) {
            phi_907_ = lt_mask_LightPlace(1u, ((param_8.y * param_9) + param_8.x));
            phi_908_ = false;
        } else {
            phi_907_ = lt_mask_LightPlace();
            phi_908_ = true;
        }
        let _e55 = phi_907_;
        let _e57 = phi_908_;
        phi_909_ = _e55;
        phi_910_ = _e57;
    } else {
        phi_909_ = lt_mask_LightPlace();
        phi_910_ = true;
    }
    let _e59 = phi_909_;
    let _e61 = phi_910_;
    if _e61 {
        phi_915_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_915_ = _e59;
    }
    let _e66 = phi_915_;
    return lt_mask_LightPlace(_e66.word, _e66.shift);
}

fn function_() {
    var phi_208_: bool;
    var phi_209_: bool;
    var phi_210_: bool;
    var phi_211_: bool;
    var phi_215_: bool;
    var phi_285_: bool;
    var phi_286_: bool;
    var phi_297_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_298_: bool;
    var phi_299_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_300_: bool;
    var phi_307_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_311_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_324_: bool;
    var phi_338_: bool;
    var phi_359_: u32;
    var phi_361_: u32;
    var phi_364_: lt_mask_Neighbourhood;
    var phi_376_: bool;
    var phi_377_: bool;
    var phi_386_: u32;
    var phi_387_: u32;
    var phi_447_: vec2<i32>;
    var phi_467_: vec2<i32>;
    var phi_492_: u32;
    var phi_511_: u32;
    var phi_519_: u32;
    var phi_545_: bool;
    var phi_546_: bool;
    var phi_547_: bool;
    var phi_548_: bool;
    var phi_549_: bool;
    var phi_550_: bool;
    var phi_551_: bool;
    var phi_556_: bool;
    var phi_557_: bool;
    var phi_558_: bool;
    var phi_559_: bool;
    var phi_560_: bool;
    var phi_561_: bool;
    var phi_562_: bool;
    var phi_563_: bool;
    var phi_564_: bool;
    var phi_579_: bool;
    var phi_580_: bool;
    var phi_587_: bool;
    var phi_588_: bool;
    var phi_589_: bool;
    var phi_590_: bool;
    var phi_591_: bool;
    var phi_595_: bool;
    var phi_596_: bool;
    var phi_597_: bool;
    var phi_601_: bool;
    var phi_602_: bool;
    var phi_606_: bool;
    var phi_607_: bool;
    var phi_625_: bool;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_362_: u32;
    var phi_365_: lt_mask_Neighbourhood;
    var phi_630_: lt_mask_Neighbourhood;
    var phi_631_: lt_mask_Neighbourhood;
    var phi_632_: lt_mask_Neighbourhood;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_687_: bool;
    var phi_688_: bool;
    var phi_689_: bool;
    var phi_693_: bool;
    var phi_715_: bool;
    var phi_716_: bool;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_738_: u32;
    var phi_739_: u32;
    var phi_740_: u32;
    var phi_741_: u32;
    var phi_742_: u32;
    var phi_743_: u32;
    var phi_744_: u32;
    var phi_756_: bool;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_763_: bool;
    var phi_769_: bool;
    var phi_777_: u32;
    var phi_782_: u32;
    var phi_791_: u32;
    var phi_796_: u32;
    var phi_800_: u32;
    var phi_801_: u32;
    var phi_802_: u32;
    var phi_806_: f32;
    var phi_808_: mask_Masked;
    var phi_858_: bool;
    var phi_859_: u32;
    var phi_870_: u32;
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
                phi_208_ = (_e95 == _e97);
                phi_209_ = false;
            } else {
                phi_208_ = bool();
                phi_209_ = true;
            }
            let _e100 = phi_208_;
            let _e102 = phi_209_;
            phi_210_ = _e100;
            phi_211_ = _e102;
        } else {
            phi_210_ = bool();
            phi_211_ = true;
        }
        let _e104 = phi_210_;
        let _e106 = phi_211_;
        if _e106 {
            phi_215_ = false;
        } else {
            phi_215_ = _e104;
        }
        let _e108 = phi_215_;
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
                    phi_286_ = true;
                } else {
                    let _e161 = p.member.light.range_squared;
                    if (_e144 <= _e161) {
                        let _e164 = p.member.light.cos_outer;
                        phi_285_ = (-((((_e126 * _e146.x) + (_e127 * _e146.y)) + (_e128 * _e146.z))) >= (_e164 * sqrt(_e144)));
                    } else {
                        phi_285_ = false;
                    }
                    let _e169 = phi_285_;
                    phi_286_ = _e169;
                }
                let _e171 = phi_286_;
                if _e171 {
                    let _e173 = samples.member[_e58.shift].flags;
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
                    phi_297_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, ((_e173 & 1u) == 0u));
                    phi_298_ = false;
                } else {
                    phi_297_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_298_ = true;
                }
                let _e192 = phi_297_;
                let _e194 = phi_298_;
                phi_299_ = _e192;
                phi_300_ = _e194;
            } else {
                phi_299_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_300_ = true;
            }
            let _e196 = phi_299_;
            let _e198 = phi_300_;
            if _e198 {
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
                phi_307_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
            } else {
                phi_307_ = _e196;
            }
            let _e215 = phi_307_;
            phi_311_ = _e215;
        } else {
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
            phi_311_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
        }
        let _e232 = phi_311_;
        if _e232.unnamed_1 {
            phi_808_ = mask_Masked(_e232.unnamed.visibility, 0u, false);
        } else {
            let _e237 = (_e79 < 0.5f);
            if (_e79 > 0f) {
                phi_324_ = (_e79 < 1f);
            } else {
                phi_324_ = false;
            }
            let _e241 = phi_324_;
            let _e243 = p.member.flags;
            let _e245 = ((_e243 & 1u) != 0u);
            let _e246 = lt_mask_Neighbourhood(false, true);
            if _e241 {
                phi_338_ = false;
            } else {
                phi_338_ = true;
            }
            let _e248 = phi_338_;
            if _e248 {
                if _e245 {
                    if ((0u & 2u) != 0u) {
                        phi_630_ = _e246;
                    } else {
                        let _e252 = p.member.expansion;
                        if false {
                            let _e254 = p.member.moving_pattern;
                            phi_359_ = _e254;
                        } else {
                            let _e256 = p.member.still_pattern;
                            phi_359_ = _e256;
                        }
                        let _e258 = phi_359_;
                        phi_361_ = 0u;
                        phi_364_ = _e246;
                        loop {
                            let _e260 = phi_361_;
                            let _e262 = phi_364_;
                            local_1 = _e262;
                            if (1u <= _e258) {
                                if (_e258 <= 4u) {
                                    phi_376_ = false;
                                } else {
                                    phi_376_ = true;
                                }
                                let _e266 = phi_376_;
                                phi_377_ = _e266;
                            } else {
                                phi_377_ = true;
                            }
                            let _e268 = phi_377_;
                            if _e268 {
                                switch bitcast<i32>(_e258) {
                                    case 5: {
                                        phi_386_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_386_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_386_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_386_ = 9u;
                                        break;
                                    }
                                }
                                let _e271 = phi_386_;
                                phi_387_ = _e271;
                            } else {
                                phi_387_ = 5u;
                            }
                            let _e273 = phi_387_;
                            let _e274 = (_e260 < _e273);
                            if _e274 {
                                let _e276 = p.member.frame;
                                let _e280 = p.member.current.size[0u];
                                let _e282 = p.member.current.size[1u];
                                switch bitcast<i32>(_e258) {
                                    case 1: {
                                        let _e292 = lt_mask_pattern_plus(_e260);
                                        phi_467_ = vec2<i32>(_e292.x, _e292.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e296 = lt_mask_pattern_cross(_e260);
                                        phi_467_ = vec2<i32>(_e296.x, _e296.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e302 = lt_mask_pattern_plus_or_cross(_e260, ((_e42.x + _e42.y) & 1u));
                                        phi_467_ = vec2<i32>(_e302.x, _e302.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e307 = lt_mask_pattern_plus_or_cross(_e260, (_e276 & 1u));
                                        phi_467_ = vec2<i32>(_e307.x, _e307.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e276 & 3u)) {
                                            case 0: {
                                                phi_447_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_447_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_447_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_447_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e318 = phi_447_;
                                        phi_467_ = (_e318 + vec2<i32>(bitcast<i32>((_e260 & 1u)), bitcast<i32>(((_e260 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_467_ = vec2<i32>((bitcast<i32>((_e260 % 5u)) - 2i), (bitcast<i32>(((_e260 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e335 = lt_mask_pattern_diamond(_e260);
                                        phi_467_ = vec2<i32>(_e335.x, _e335.y);
                                        break;
                                    }
                                    default: {
                                        phi_467_ = vec2<i32>((bitcast<i32>((_e260 % 3u)) - 1i), (bitcast<i32>(((_e260 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e340 = phi_467_;
                                let _e343 = lt_mask_pattern_step_clamped(_e42.x, _e340.x, _e280);
                                let _e344 = lt_mask_pattern_step_clamped(_e42.y, _e340.y, _e282);
                                let _e348 = ((((_e344 * _e74) + _e343) * _e70) + (_e66 / 32u));
                                if (_e68 > 29u) {
                                    let _e350 = (_e348 + 1u);
                                    if (_e350 < _e48) {
                                    } else {
                                        return;
                                    }
                                    let _e354 = last_bits.member[(0u + _e350)];
                                    phi_492_ = _e354;
                                } else {
                                    phi_492_ = 0u;
                                }
                                let _e356 = phi_492_;
                                if (_e348 < _e48) {
                                } else {
                                    return;
                                }
                                let _e360 = last_bits.member[(0u + _e348)];
                                let _e363 = (_e360 >> bitcast<u32>((_e68 & 31u)));
                                if (_e68 > 29u) {
                                    phi_511_ = (_e363 | (_e356 << bitcast<u32>(((32u - _e68) & 31u))));
                                } else {
                                    phi_511_ = _e363;
                                }
                                let _e371 = phi_511_;
                                if ((_e371 & 2u) == 0u) {
                                    phi_519_ = (_e371 & 1u);
                                } else {
                                    phi_519_ = (_e371 & 7u);
                                }
                                let _e377 = phi_519_;
                                if _e262.any_expands {
                                    phi_607_ = true;
                                } else {
                                    if ((_e377 & 2u) != 0u) {
                                        let _e384 = (((_e377 & 4u) != 0u) != _e237);
                                        switch bitcast<i32>(_e252) {
                                            case 1: {
                                                phi_547_ = bool();
                                                phi_548_ = false;
                                                phi_549_ = true;
                                                phi_550_ = false;
                                                phi_551_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e384 {
                                                    phi_545_ = (((_e377 & 4u) != 0u) != ((_e377 & 1u) != 0u));
                                                    phi_546_ = false;
                                                } else {
                                                    phi_545_ = bool();
                                                    phi_546_ = true;
                                                }
                                                let _e392 = phi_545_;
                                                let _e394 = phi_546_;
                                                phi_547_ = _e392;
                                                phi_548_ = false;
                                                phi_549_ = false;
                                                phi_550_ = _e394;
                                                phi_551_ = _e384;
                                                break;
                                            }
                                            default: {
                                                phi_547_ = bool();
                                                phi_548_ = true;
                                                phi_549_ = false;
                                                phi_550_ = false;
                                                phi_551_ = false;
                                                break;
                                            }
                                        }
                                        let _e396 = phi_547_;
                                        let _e398 = phi_548_;
                                        let _e400 = phi_549_;
                                        let _e402 = phi_550_;
                                        let _e404 = phi_551_;
                                        phi_559_ = _e384;
                                        phi_560_ = _e396;
                                        phi_561_ = _e398;
                                        phi_562_ = _e400;
                                        phi_563_ = _e402;
                                        phi_564_ = _e404;
                                    } else {
                                        switch bitcast<i32>(_e252) {
                                            case 1: {
                                                phi_556_ = false;
                                                phi_557_ = true;
                                                phi_558_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_556_ = false;
                                                phi_557_ = false;
                                                phi_558_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_556_ = true;
                                                phi_557_ = false;
                                                phi_558_ = false;
                                                break;
                                            }
                                        }
                                        let _e407 = phi_556_;
                                        let _e409 = phi_557_;
                                        let _e411 = phi_558_;
                                        phi_559_ = false;
                                        phi_560_ = bool();
                                        phi_561_ = _e407;
                                        phi_562_ = _e409;
                                        phi_563_ = _e411;
                                        phi_564_ = false;
                                    }
                                    let _e413 = phi_559_;
                                    let _e415 = phi_560_;
                                    let _e417 = phi_561_;
                                    let _e419 = phi_562_;
                                    let _e421 = phi_563_;
                                    let _e423 = phi_564_;
                                    if _e417 {
                                        if ((_e377 & 2u) != 0u) {
                                            if (((_e377 & 4u) != 0u) != _e237) {
                                                phi_579_ = false;
                                            } else {
                                                phi_579_ = true;
                                            }
                                            let _e430 = phi_579_;
                                            phi_580_ = _e430;
                                        } else {
                                            phi_580_ = true;
                                        }
                                        let _e432 = phi_580_;
                                        if _e432 {
                                            phi_587_ = (((_e377 & 1u) != 0u) != _e237);
                                        } else {
                                            phi_587_ = true;
                                        }
                                        let _e437 = phi_587_;
                                        phi_588_ = _e437;
                                        phi_589_ = false;
                                        phi_590_ = false;
                                        phi_591_ = false;
                                    } else {
                                        phi_588_ = bool();
                                        phi_589_ = _e419;
                                        phi_590_ = _e421;
                                        phi_591_ = _e423;
                                    }
                                    let _e439 = phi_588_;
                                    let _e441 = phi_589_;
                                    let _e443 = phi_590_;
                                    let _e445 = phi_591_;
                                    if _e441 {
                                        phi_595_ = _e413;
                                        phi_596_ = false;
                                        phi_597_ = false;
                                    } else {
                                        phi_595_ = _e439;
                                        phi_596_ = _e443;
                                        phi_597_ = _e445;
                                    }
                                    let _e447 = phi_595_;
                                    let _e449 = phi_596_;
                                    let _e451 = phi_597_;
                                    if _e449 {
                                        phi_601_ = false;
                                        phi_602_ = true;
                                    } else {
                                        phi_601_ = _e415;
                                        phi_602_ = _e451;
                                    }
                                    let _e453 = phi_601_;
                                    let _e455 = phi_602_;
                                    if _e455 {
                                        phi_606_ = _e453;
                                    } else {
                                        phi_606_ = _e447;
                                    }
                                    let _e457 = phi_606_;
                                    phi_607_ = _e457;
                                }
                                let _e459 = phi_607_;
                                if _e262.all_remove {
                                    if (((_e377 & 1u) != 0u) == _e237) {
                                        if ((_e377 & 2u) != 0u) {
                                            phi_625_ = (((_e377 & 4u) != 0u) == _e237);
                                        } else {
                                            phi_625_ = true;
                                        }
                                        let _e469 = phi_625_;
                                        phi_626_ = _e469;
                                    } else {
                                        phi_626_ = false;
                                    }
                                    let _e471 = phi_626_;
                                    phi_627_ = _e471;
                                } else {
                                    phi_627_ = false;
                                }
                                let _e473 = phi_627_;
                                phi_362_ = (_e260 + 1u);
                                phi_365_ = lt_mask_Neighbourhood(_e459, _e473);
                            } else {
                                phi_362_ = u32();
                                phi_365_ = lt_mask_Neighbourhood();
                            }
                            let _e477 = phi_362_;
                            let _e479 = phi_365_;
                            continue;
                            continuing {
                                phi_361_ = _e477;
                                phi_364_ = _e479;
                                break if !(_e274);
                            }
                        }
                        let _e717 = local_1;
                        phi_630_ = _e717;
                    }
                    let _e482 = phi_630_;
                    phi_631_ = _e482;
                } else {
                    phi_631_ = _e246;
                }
                let _e484 = phi_631_;
                phi_632_ = _e484;
            } else {
                phi_632_ = _e246;
            }
            let _e486 = phi_632_;
            let _e489 = p.member.frame;
            let _e491 = p.member.refresh;
            if (_e491 == 0u) {
                phi_665_ = false;
            } else {
                if (_e491 == 0u) {
                    return;
                }
                let _e500 = ((_e42.x + (_e42.y * (((_e491 * 5u) / 8u) | 1u))) + (_e489 % _e491));
                if (_e491 == 0u) {
                    phi_664_ = (_e500 == 0u);
                } else {
                    if (_e491 == 0u) {
                        return;
                    }
                    phi_664_ = ((_e500 % _e491) == 0u);
                }
                let _e507 = phi_664_;
                phi_665_ = _e507;
            }
            let _e509 = phi_665_;
            if _e245 {
                if _e509 {
                    phi_687_ = bool();
                } else {
                    phi_687_ = ((0u & 2u) != 0u);
                }
                let _e515 = phi_687_;
                phi_688_ = _e515;
                phi_689_ = _e509;
            } else {
                phi_688_ = bool();
                phi_689_ = true;
            }
            let _e517 = phi_688_;
            let _e519 = phi_689_;
            if _e519 {
                phi_693_ = false;
            } else {
                phi_693_ = _e517;
            }
            let _e521 = phi_693_;
            if _e521 {
                phi_744_ = 7u;
            } else {
                if (_e79 != 0.5f) {
                    if _e245 {
                        if _e509 {
                            phi_741_ = 6u;
                        } else {
                            if _e241 {
                                phi_716_ = true;
                            } else {
                                if _e486.any_expands {
                                    phi_715_ = false;
                                } else {
                                    phi_715_ = true;
                                }
                                let _e523 = phi_715_;
                                phi_716_ = _e523;
                            }
                            let _e525 = phi_716_;
                            if _e525 {
                                if _e241 {
                                    if false {
                                        if _e486.all_remove {
                                            phi_729_ = false;
                                        } else {
                                            phi_729_ = true;
                                        }
                                        let _e527 = phi_729_;
                                        phi_730_ = _e527;
                                    } else {
                                        phi_730_ = true;
                                    }
                                    let _e529 = phi_730_;
                                    phi_731_ = _e529;
                                } else {
                                    phi_731_ = true;
                                }
                                let _e531 = phi_731_;
                                if _e531 {
                                    if _e241 {
                                        phi_738_ = 1u;
                                    } else {
                                        phi_738_ = 0u;
                                    }
                                    let _e533 = phi_738_;
                                    phi_739_ = _e533;
                                } else {
                                    phi_739_ = 5u;
                                }
                                let _e535 = phi_739_;
                                phi_740_ = _e535;
                            } else {
                                phi_740_ = 4u;
                            }
                            let _e537 = phi_740_;
                            phi_741_ = _e537;
                        }
                        let _e539 = phi_741_;
                        phi_742_ = _e539;
                    } else {
                        phi_742_ = 3u;
                    }
                    let _e541 = phi_742_;
                    phi_743_ = _e541;
                } else {
                    phi_743_ = 2u;
                }
                let _e543 = phi_743_;
                phi_744_ = _e543;
            }
            let _e545 = phi_744_;
            if !((_e545 == 0u)) {
                if !((_e545 == 5u)) {
                    phi_756_ = !(_e521);
                    phi_757_ = false;
                } else {
                    phi_756_ = bool();
                    phi_757_ = true;
                }
                let _e552 = phi_756_;
                let _e554 = phi_757_;
                phi_758_ = _e552;
                phi_759_ = _e554;
            } else {
                phi_758_ = bool();
                phi_759_ = true;
            }
            let _e556 = phi_758_;
            let _e558 = phi_759_;
            if _e558 {
                phi_763_ = false;
            } else {
                phi_763_ = _e556;
            }
            let _e560 = phi_763_;
            if _e521 {
                phi_769_ = ((0u & 4u) != 0u);
            } else {
                phi_769_ = _e237;
            }
            let _e564 = phi_769_;
            if _e560 {
                if _e237 {
                    phi_777_ = (2u | 1u);
                } else {
                    phi_777_ = 2u;
                }
                let _e567 = phi_777_;
                if false {
                    phi_782_ = (_e567 | 4u);
                } else {
                    phi_782_ = _e567;
                }
                let _e570 = phi_782_;
                phi_802_ = _e570;
            } else {
                if (_e545 == 7u) {
                    if _e237 {
                        phi_791_ = (2u | 1u);
                    } else {
                        phi_791_ = 2u;
                    }
                    let _e574 = phi_791_;
                    if _e564 {
                        phi_796_ = (_e574 | 4u);
                    } else {
                        phi_796_ = _e574;
                    }
                    let _e577 = phi_796_;
                    phi_801_ = _e577;
                } else {
                    if _e237 {
                        phi_800_ = 1u;
                    } else {
                        phi_800_ = 0u;
                    }
                    let _e579 = phi_800_;
                    phi_801_ = _e579;
                }
                let _e581 = phi_801_;
                phi_802_ = _e581;
            }
            let _e583 = phi_802_;
            if _e564 {
                phi_806_ = 0f;
            } else {
                phi_806_ = 1f;
            }
            let _e585 = phi_806_;
            phi_808_ = mask_Masked(_e585, _e583, _e560);
        }
        let _e588 = phi_808_;
        visibility.member[_e58.shift] = _e588.visibility;
        let _e593 = p.member.light.number;
        let _e594 = (_e593 * 3u);
        let _e596 = (_e594 % 32u);
        let _e598 = p.member.light.mask_words;
        let _e600 = ((_e58.shift * _e598) + (_e594 / 32u));
        let _e602 = bits.member[_e600];
        bits.member[_e600] = ((_e602 & ~((7u << bitcast<u32>((_e596 & 31u))))) | (_e588.bits << bitcast<u32>((_e596 & 31u))));
        if (_e596 > 29u) {
            let _e617 = bits.member[(_e600 + 1u)];
            let _e619 = (32u - _e596);
            bits.member[(_e600 + 1u)] = ((_e617 & ~((7u >> bitcast<u32>((_e619 & 31u))))) | (_e588.bits >> bitcast<u32>((_e619 & 31u))));
        }
        phi_858_ = _e588.needs_ray;
        phi_859_ = _e58.shift;
    } else {
        phi_858_ = false;
        phi_859_ = 0u;
    }
    let _e633 = phi_858_;
    let _e635 = phi_859_;
    if (_e43 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e633 {
        let _e639 = atomicAdd((&shared_[0u]), 1u);
        phi_870_ = _e639;
    } else {
        phi_870_ = 0u;
    }
    let _e641 = phi_870_;
    workgroupBarrier();
    if (_e43 == 0u) {
        let _e645 = atomicLoad((&shared_[0u]));
        let _e646 = atomicAdd((&list.member[3u]), _e645);
        atomicStore((&shared_[1u]), _e646);
    }
    workgroupBarrier();
    if _e633 {
        let _e649 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e649) + _e641)]), _e635);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
