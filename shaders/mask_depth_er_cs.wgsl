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

struct mask_BitsPlace {
    light: lt_mask_LightPlace,
    words: u32,
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

struct type_44 {
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
var<storage, read_write> list: type_44;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(6) 
var<storage> last_depths: type_21;
@group(0) @binding(7) 
var<storage, read_write> depths: type_21;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_164_: lt_mask_LightPlace;
    var phi_165_: bool;
    var phi_166_: lt_mask_LightPlace;
    var phi_167_: bool;
    var phi_172_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_164_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_165_ = false;
        } else {
            phi_164_ = lt_mask_LightPlace();
            phi_165_ = true;
        }
        let _e60 = phi_164_;
        let _e62 = phi_165_;
        phi_166_ = _e60;
        phi_167_ = _e62;
    } else {
        phi_166_ = lt_mask_LightPlace();
        phi_167_ = true;
    }
    let _e64 = phi_166_;
    let _e66 = phi_167_;
    if _e66 {
        phi_172_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_172_ = _e64;
    }
    let _e71 = phi_172_;
    return lt_mask_LightPlace(_e71.word, _e71.shift);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_190_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_190_ = vec2(0i);
            break;
        }
        case 1: {
            phi_190_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_190_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_190_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_190_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e56 = phi_190_;
    return vec2<i32>(_e56.x, _e56.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_208_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_208_ = vec2(0i);
            break;
        }
        case 1: {
            phi_208_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_208_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_208_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_208_ = vec2(1i);
            break;
        }
    }
    let _e56 = phi_208_;
    return vec2<i32>(_e56.x, _e56.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_227_: vec2<i32>;

    if (param_6 == 0u) {
        let _e50 = lt_mask_pattern_plus(param_5);
        phi_227_ = vec2<i32>(_e50.x, _e50.y);
    } else {
        let _e54 = lt_mask_pattern_cross(param_5);
        phi_227_ = vec2<i32>(_e54.x, _e54.y);
    }
    let _e59 = phi_227_;
    return vec2<i32>(_e59.x, _e59.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_252_: vec2<i32>;

    let _e48 = (param_7 % 13u);
    switch bitcast<i32>(_e48) {
        case 9: {
            phi_252_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_252_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_252_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_252_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_252_ = vec2<i32>((bitcast<i32>((_e48 % 3u)) - 1i), (bitcast<i32>(((_e48 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e63 = phi_252_;
    return vec2<i32>(_e63.x, _e63.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_273_: u32;
    var phi_274_: u32;

    let _e51 = (bitcast<i32>(param_8) + param_9);
    if (_e51 < 0i) {
        phi_274_ = 0u;
    } else {
        if (_e51 >= bitcast<i32>(param_10)) {
            phi_273_ = (param_10 - 1u);
        } else {
            phi_273_ = bitcast<u32>(_e51);
        }
        let _e58 = phi_273_;
        phi_274_ = _e58;
    }
    let _e60 = phi_274_;
    return _e60;
}

fn function_() {
    var phi_351_: bool;
    var phi_352_: bool;
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_358_: bool;
    var phi_428_: bool;
    var phi_429_: bool;
    var phi_440_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_441_: bool;
    var phi_442_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_443_: bool;
    var phi_450_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_454_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_467_: bool;
    var phi_523_: bool;
    var phi_527_: f32;
    var phi_538_: bool;
    var phi_564_: u32;
    var phi_566_: u32;
    var phi_569_: lt_mask_Neighbourhood;
    var phi_581_: bool;
    var phi_582_: bool;
    var phi_591_: u32;
    var phi_592_: u32;
    var phi_652_: vec2<i32>;
    var phi_672_: vec2<i32>;
    var phi_699_: u32;
    var phi_718_: u32;
    var phi_726_: u32;
    var phi_743_: bool;
    var phi_744_: bool;
    var phi_751_: bool;
    var phi_752_: bool;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_567_: u32;
    var phi_570_: lt_mask_Neighbourhood;
    var phi_775_: lt_mask_Neighbourhood;
    var phi_776_: lt_mask_Neighbourhood;
    var phi_777_: lt_mask_Neighbourhood;
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_853_: bool;
    var phi_854_: bool;
    var phi_855_: bool;
    var phi_862_: u32;
    var phi_863_: u32;
    var phi_864_: u32;
    var phi_865_: u32;
    var phi_866_: u32;
    var phi_867_: u32;
    var phi_875_: bool;
    var phi_883_: u32;
    var phi_888_: u32;
    var phi_892_: u32;
    var phi_893_: u32;
    var phi_897_: f32;
    var phi_899_: mask_Masked;
    var phi_971_: bool;
    var phi_972_: bool;
    var phi_973_: bool;
    var phi_974_: bool;
    var phi_978_: bool;
    var phi_1006_: f32;
    var phi_1009_: bool;
    var phi_1010_: u32;
    var phi_1021_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e47 = id_1;
    let _e48 = local_2;
    let _e53 = arrayLength((&last_bits.member));
    let _e64 = p.member.current.size[0u];
    let _e66 = p.member.current.size[1u];
    let _e67 = lt_shaders_entry_pixel_index(_e47, _e64, _e66);
    if (bitcast<i32>(_e67.word) != 0i) {
        let _e74 = p.member.light.number;
        let _e75 = (_e74 * 3u);
        let _e79 = p.member.light.mask_words;
        let _e85 = mask_BitsPlace(lt_mask_LightPlace((_e75 / 32u), mask_BitsPlace().light.shift), mask_BitsPlace().words);
        let _e91 = mask_BitsPlace(lt_mask_LightPlace(_e85.light.word, (_e75 % 32u)), _e85.words);
        let _e94 = mask_BitsPlace(_e91.light, _e79);
        let _e98 = p.member.current.size[0u];
        let _e101 = samples.member[_e67.shift].position;
        let _e103 = visibility.member[_e67.shift];
        let _e109 = samples.member[_e67.shift].normal[0u];
        let _e111 = global[0u];
        if (_e109 == _e111) {
            let _e114 = samples.member[_e67.shift].normal[1u];
            let _e116 = global[1u];
            if (_e114 == _e116) {
                let _e119 = samples.member[_e67.shift].normal[2u];
                let _e121 = global[2u];
                phi_351_ = (_e119 == _e121);
                phi_352_ = false;
            } else {
                phi_351_ = bool();
                phi_352_ = true;
            }
            let _e124 = phi_351_;
            let _e126 = phi_352_;
            phi_353_ = _e124;
            phi_354_ = _e126;
        } else {
            phi_353_ = bool();
            phi_354_ = true;
        }
        let _e128 = phi_353_;
        let _e130 = phi_354_;
        if _e130 {
            phi_358_ = false;
        } else {
            phi_358_ = _e128;
        }
        let _e132 = phi_358_;
        if !(_e132) {
            let _e135 = samples.member[_e67.shift].position;
            let _e137 = p.member.light.place;
            let _e143 = p.member.light.place[3u];
            let _e150 = (_e137.x - (_e135.x * _e143));
            let _e151 = (_e137.y - (_e135.y * _e143));
            let _e152 = (_e137.z - (_e135.z * _e143));
            let _e154 = samples.member[_e67.shift].normal;
            if ((((_e154.x * _e150) + (_e154.y * _e151)) + (_e154.z * _e152)) > 0f) {
                let _e168 = (((_e150 * _e150) + (_e151 * _e151)) + (_e152 * _e152));
                let _e170 = p.member.light.axis;
                let _e182 = p.member.light.place[3u];
                if (_e182 == 0f) {
                    phi_429_ = true;
                } else {
                    let _e185 = p.member.light.range_squared;
                    if (_e168 <= _e185) {
                        let _e188 = p.member.light.cos_outer;
                        phi_428_ = (-((((_e150 * _e170.x) + (_e151 * _e170.y)) + (_e152 * _e170.z))) >= (_e188 * sqrt(_e168)));
                    } else {
                        phi_428_ = false;
                    }
                    let _e193 = phi_428_;
                    phi_429_ = _e193;
                }
                let _e195 = phi_429_;
                if _e195 {
                    let _e197 = samples.member[_e67.shift].flags;
                    let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
                    phi_440_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, ((_e197 & 1u) == 0u));
                    phi_441_ = false;
                } else {
                    phi_440_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_441_ = true;
                }
                let _e216 = phi_440_;
                let _e218 = phi_441_;
                phi_442_ = _e216;
                phi_443_ = _e218;
            } else {
                phi_442_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_443_ = true;
            }
            let _e220 = phi_442_;
            let _e222 = phi_443_;
            if _e222 {
                let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e234 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e228.unnamed.visibility, false), _e228.unnamed_1);
                phi_450_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e234.unnamed, true);
            } else {
                phi_450_ = _e220;
            }
            let _e239 = phi_450_;
            phi_454_ = _e239;
        } else {
            let _e245 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e251 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e245.unnamed.visibility, false), _e245.unnamed_1);
            phi_454_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e251.unnamed, true);
        }
        let _e256 = phi_454_;
        if _e256.unnamed_1 {
            phi_899_ = mask_Masked(_e256.unnamed.visibility, 0u, false);
        } else {
            let _e261 = (_e103 < 0.5f);
            if (_e103 > 0f) {
                phi_467_ = (_e103 < 1f);
            } else {
                phi_467_ = false;
            }
            let _e265 = phi_467_;
            let _e268 = p.member.previous.eye;
            let _e279 = p.member.previous.forward;
            let _e287 = ((((_e101.x - _e268.x) * _e279.x) + ((_e101.y - _e268.y) * _e279.y)) + ((_e101.z - _e268.z) * _e279.z));
            let _e289 = ((_e47.y * _e98) + _e47.x);
            if (_e289 < arrayLength((&last_depths.member))) {
            } else {
                return;
            }
            let _e293 = last_depths.member[(0u + _e289)];
            let _e295 = p.member.depth_tolerance;
            let _e298 = abs(_e287);
            let _e299 = abs(_e293);
            if ((bitcast<u32>(_e299) & 2147483647u) > 2139095040u) {
                phi_523_ = true;
            } else {
                let _e303 = (_e299 > _e298);
                if _e303 {
                }
                phi_523_ = _e303;
            }
            let _e305 = phi_523_;
            if _e305 {
                phi_527_ = _e299;
            } else {
                phi_527_ = _e298;
            }
            let _e307 = phi_527_;
            if (abs((_e287 - _e293)) <= (_e295 * _e307)) {
                let _e311 = p.member.flags;
                phi_538_ = ((_e311 & 1u) != 0u);
            } else {
                phi_538_ = false;
            }
            let _e315 = phi_538_;
            if false {
            }
            let _e320 = lt_mask_Neighbourhood(false, true);
            if _e265 {
                phi_777_ = _e320;
            } else {
                if true {
                    if _e315 {
                        if false {
                            let _e322 = p.member.moving_pattern;
                            phi_564_ = _e322;
                        } else {
                            let _e324 = p.member.still_pattern;
                            phi_564_ = _e324;
                        }
                        let _e326 = phi_564_;
                        phi_566_ = 0u;
                        phi_569_ = _e320;
                        loop {
                            let _e328 = phi_566_;
                            let _e330 = phi_569_;
                            local_1 = _e330;
                            if (1u <= _e326) {
                                if (_e326 <= 4u) {
                                    phi_581_ = false;
                                } else {
                                    phi_581_ = true;
                                }
                                let _e334 = phi_581_;
                                phi_582_ = _e334;
                            } else {
                                phi_582_ = true;
                            }
                            let _e336 = phi_582_;
                            if _e336 {
                                switch bitcast<i32>(_e326) {
                                    case 5: {
                                        phi_591_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_591_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_591_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_591_ = 9u;
                                        break;
                                    }
                                }
                                let _e339 = phi_591_;
                                phi_592_ = _e339;
                            } else {
                                phi_592_ = 5u;
                            }
                            let _e341 = phi_592_;
                            let _e342 = (_e328 < _e341);
                            if _e342 {
                                let _e344 = p.member.frame;
                                let _e348 = p.member.current.size[0u];
                                let _e350 = p.member.current.size[1u];
                                switch bitcast<i32>(_e326) {
                                    case 1: {
                                        let _e360 = lt_mask_pattern_plus(_e328);
                                        phi_672_ = vec2<i32>(_e360.x, _e360.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e364 = lt_mask_pattern_cross(_e328);
                                        phi_672_ = vec2<i32>(_e364.x, _e364.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e370 = lt_mask_pattern_plus_or_cross(_e328, ((_e47.x + _e47.y) & 1u));
                                        phi_672_ = vec2<i32>(_e370.x, _e370.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e375 = lt_mask_pattern_plus_or_cross(_e328, (_e344 & 1u));
                                        phi_672_ = vec2<i32>(_e375.x, _e375.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e344 & 3u)) {
                                            case 0: {
                                                phi_652_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_652_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_652_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_652_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e386 = phi_652_;
                                        phi_672_ = (_e386 + vec2<i32>(bitcast<i32>((_e328 & 1u)), bitcast<i32>(((_e328 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_672_ = vec2<i32>((bitcast<i32>((_e328 % 5u)) - 2i), (bitcast<i32>(((_e328 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e403 = lt_mask_pattern_diamond(_e328);
                                        phi_672_ = vec2<i32>(_e403.x, _e403.y);
                                        break;
                                    }
                                    default: {
                                        phi_672_ = vec2<i32>((bitcast<i32>((_e328 % 3u)) - 1i), (bitcast<i32>(((_e328 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e408 = phi_672_;
                                let _e411 = lt_mask_pattern_step_clamped(_e47.x, _e408.x, _e348);
                                let _e412 = lt_mask_pattern_step_clamped(_e47.y, _e408.y, _e350);
                                let _e419 = ((((_e412 * _e98) + _e411) * _e94.words) + _e94.light.word);
                                if (_e94.light.shift > 29u) {
                                    let _e423 = (_e419 + 1u);
                                    if (_e423 < _e53) {
                                    } else {
                                        return;
                                    }
                                    let _e427 = last_bits.member[(0u + _e423)];
                                    phi_699_ = _e427;
                                } else {
                                    phi_699_ = 0u;
                                }
                                let _e429 = phi_699_;
                                if (_e419 < _e53) {
                                } else {
                                    return;
                                }
                                let _e435 = last_bits.member[(0u + _e419)];
                                let _e438 = (_e435 >> bitcast<u32>((_e94.light.shift & 31u)));
                                if (_e94.light.shift > 29u) {
                                    phi_718_ = (_e438 | (_e429 << bitcast<u32>(((32u - _e94.light.shift) & 31u))));
                                } else {
                                    phi_718_ = _e438;
                                }
                                let _e446 = phi_718_;
                                if ((_e446 & 2u) == 0u) {
                                    phi_726_ = (_e446 & 1u);
                                } else {
                                    phi_726_ = (_e446 & 7u);
                                }
                                let _e452 = phi_726_;
                                if _e330.any_expands {
                                    phi_752_ = true;
                                } else {
                                    if ((_e452 & 2u) != 0u) {
                                        if (((_e452 & 4u) != 0u) != _e261) {
                                            phi_743_ = false;
                                        } else {
                                            phi_743_ = true;
                                        }
                                        let _e461 = phi_743_;
                                        phi_744_ = _e461;
                                    } else {
                                        phi_744_ = true;
                                    }
                                    let _e463 = phi_744_;
                                    if _e463 {
                                        phi_751_ = (((_e452 & 1u) != 0u) != _e261);
                                    } else {
                                        phi_751_ = true;
                                    }
                                    let _e468 = phi_751_;
                                    phi_752_ = _e468;
                                }
                                let _e470 = phi_752_;
                                if _e330.all_remove {
                                    if (((_e452 & 1u) != 0u) == _e261) {
                                        if ((_e452 & 2u) != 0u) {
                                            phi_770_ = (((_e452 & 4u) != 0u) == _e261);
                                        } else {
                                            phi_770_ = true;
                                        }
                                        let _e480 = phi_770_;
                                        phi_771_ = _e480;
                                    } else {
                                        phi_771_ = false;
                                    }
                                    let _e482 = phi_771_;
                                    phi_772_ = _e482;
                                } else {
                                    phi_772_ = false;
                                }
                                let _e484 = phi_772_;
                                phi_567_ = (_e328 + 1u);
                                phi_570_ = lt_mask_Neighbourhood(_e470, _e484);
                            } else {
                                phi_567_ = u32();
                                phi_570_ = lt_mask_Neighbourhood();
                            }
                            let _e488 = phi_567_;
                            let _e490 = phi_570_;
                            continue;
                            continuing {
                                phi_566_ = _e488;
                                phi_569_ = _e490;
                                break if !(_e342);
                            }
                        }
                        let _e724 = local_1;
                        phi_775_ = _e724;
                    } else {
                        phi_775_ = _e320;
                    }
                    let _e493 = phi_775_;
                    phi_776_ = _e493;
                } else {
                    phi_776_ = _e320;
                }
                let _e495 = phi_776_;
                phi_777_ = _e495;
            }
            let _e497 = phi_777_;
            let _e500 = p.member.frame;
            let _e502 = p.member.refresh;
            if (_e502 == 0u) {
                phi_810_ = false;
            } else {
                if (_e502 == 0u) {
                    return;
                }
                let _e511 = ((_e47.x + (_e47.y * (((_e502 * 5u) / 8u) | 1u))) + (_e500 % _e502));
                if (_e502 == 0u) {
                    phi_809_ = (_e511 == 0u);
                } else {
                    if (_e502 == 0u) {
                        return;
                    }
                    phi_809_ = ((_e511 % _e502) == 0u);
                }
                let _e518 = phi_809_;
                phi_810_ = _e518;
            }
            let _e520 = phi_810_;
            if (_e103 != 0.5f) {
                if _e315 {
                    if _e520 {
                        phi_865_ = 6u;
                    } else {
                        if _e265 {
                            phi_840_ = true;
                        } else {
                            if _e497.any_expands {
                                phi_839_ = false;
                            } else {
                                phi_839_ = true;
                            }
                            let _e524 = phi_839_;
                            phi_840_ = _e524;
                        }
                        let _e526 = phi_840_;
                        if _e526 {
                            if _e265 {
                                if false {
                                    if _e497.all_remove {
                                        phi_853_ = false;
                                    } else {
                                        phi_853_ = true;
                                    }
                                    let _e528 = phi_853_;
                                    phi_854_ = _e528;
                                } else {
                                    phi_854_ = true;
                                }
                                let _e530 = phi_854_;
                                phi_855_ = _e530;
                            } else {
                                phi_855_ = true;
                            }
                            let _e532 = phi_855_;
                            if _e532 {
                                if _e265 {
                                    phi_862_ = 1u;
                                } else {
                                    phi_862_ = 0u;
                                }
                                let _e534 = phi_862_;
                                phi_863_ = _e534;
                            } else {
                                phi_863_ = 5u;
                            }
                            let _e536 = phi_863_;
                            phi_864_ = _e536;
                        } else {
                            phi_864_ = 4u;
                        }
                        let _e538 = phi_864_;
                        phi_865_ = _e538;
                    }
                    let _e540 = phi_865_;
                    phi_866_ = _e540;
                } else {
                    phi_866_ = 3u;
                }
                let _e542 = phi_866_;
                phi_867_ = _e542;
            } else {
                phi_867_ = 2u;
            }
            let _e544 = phi_867_;
            if !((_e544 == 0u)) {
                phi_875_ = !((_e544 == 5u));
            } else {
                phi_875_ = false;
            }
            let _e550 = phi_875_;
            if _e550 {
                if _e261 {
                    phi_883_ = (2u | 1u);
                } else {
                    phi_883_ = 2u;
                }
                let _e553 = phi_883_;
                if false {
                    phi_888_ = (_e553 | 4u);
                } else {
                    phi_888_ = _e553;
                }
                let _e556 = phi_888_;
                phi_893_ = _e556;
            } else {
                if _e261 {
                    phi_892_ = 1u;
                } else {
                    phi_892_ = 0u;
                }
                let _e558 = phi_892_;
                phi_893_ = _e558;
            }
            let _e560 = phi_893_;
            if _e261 {
                phi_897_ = 0f;
            } else {
                phi_897_ = 1f;
            }
            let _e562 = phi_897_;
            phi_899_ = mask_Masked(_e562, _e560, _e550);
        }
        let _e565 = phi_899_;
        visibility.member[_e67.shift] = _e565.visibility;
        let _e570 = p.member.light.number;
        let _e571 = (_e570 * 3u);
        let _e573 = (_e571 % 32u);
        let _e575 = p.member.light.mask_words;
        let _e577 = ((_e67.shift * _e575) + (_e571 / 32u));
        let _e579 = bits.member[_e577];
        bits.member[_e577] = ((_e579 & ~((7u << bitcast<u32>((_e573 & 31u))))) | (_e565.bits << bitcast<u32>((_e573 & 31u))));
        if (_e573 > 29u) {
            let _e594 = bits.member[(_e577 + 1u)];
            let _e596 = (32u - _e573);
            bits.member[(_e577 + 1u)] = ((_e594 & ~((7u >> bitcast<u32>((_e596 & 31u))))) | (_e565.bits >> bitcast<u32>((_e596 & 31u))));
        }
        let _e611 = samples.member[_e67.shift].normal[0u];
        let _e613 = global[0u];
        if (_e611 == _e613) {
            let _e616 = samples.member[_e67.shift].normal[1u];
            let _e618 = global[1u];
            if (_e616 == _e618) {
                let _e621 = samples.member[_e67.shift].normal[2u];
                let _e623 = global[2u];
                phi_971_ = (_e621 == _e623);
                phi_972_ = false;
            } else {
                phi_971_ = bool();
                phi_972_ = true;
            }
            let _e626 = phi_971_;
            let _e628 = phi_972_;
            phi_973_ = _e626;
            phi_974_ = _e628;
        } else {
            phi_973_ = bool();
            phi_974_ = true;
        }
        let _e630 = phi_973_;
        let _e632 = phi_974_;
        if _e632 {
            phi_978_ = false;
        } else {
            phi_978_ = _e630;
        }
        let _e634 = phi_978_;
        if !(_e634) {
            let _e637 = samples.member[_e67.shift].position;
            let _e639 = p.member.current.eye;
            let _e650 = p.member.current.forward;
            phi_1006_ = ((((_e637.x - _e639.x) * _e650.x) + ((_e637.y - _e639.y) * _e650.y)) + ((_e637.z - _e639.z) * _e650.z));
        } else {
            phi_1006_ = 0f;
        }
        let _e660 = phi_1006_;
        depths.member[_e67.shift] = _e660;
        phi_1009_ = _e565.needs_ray;
        phi_1010_ = _e67.shift;
    } else {
        phi_1009_ = false;
        phi_1010_ = 0u;
    }
    let _e664 = phi_1009_;
    let _e666 = phi_1010_;
    if (_e48 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e664 {
        let _e670 = atomicAdd((&shared_[0u]), 1u);
        phi_1021_ = _e670;
    } else {
        phi_1021_ = 0u;
    }
    let _e672 = phi_1021_;
    workgroupBarrier();
    if (_e48 == 0u) {
        let _e676 = atomicLoad((&shared_[0u]));
        let _e677 = atomicAdd((&list.member[3u]), _e676);
        atomicStore((&shared_[1u]), _e677);
    }
    workgroupBarrier();
    if _e664 {
        let _e680 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e680) + _e672)]), _e666);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
