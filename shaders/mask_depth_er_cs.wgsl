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
    var phi_544_: bool;
    var phi_565_: u32;
    var phi_567_: u32;
    var phi_570_: lt_mask_Neighbourhood;
    var phi_582_: bool;
    var phi_583_: bool;
    var phi_592_: u32;
    var phi_593_: u32;
    var phi_653_: vec2<i32>;
    var phi_673_: vec2<i32>;
    var phi_700_: u32;
    var phi_719_: u32;
    var phi_727_: u32;
    var phi_753_: bool;
    var phi_754_: bool;
    var phi_755_: bool;
    var phi_756_: bool;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_766_: bool;
    var phi_767_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_795_: bool;
    var phi_796_: bool;
    var phi_797_: bool;
    var phi_798_: bool;
    var phi_799_: bool;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_814_: bool;
    var phi_815_: bool;
    var phi_833_: bool;
    var phi_834_: bool;
    var phi_835_: bool;
    var phi_568_: u32;
    var phi_571_: lt_mask_Neighbourhood;
    var phi_838_: lt_mask_Neighbourhood;
    var phi_839_: lt_mask_Neighbourhood;
    var phi_840_: lt_mask_Neighbourhood;
    var phi_872_: bool;
    var phi_873_: bool;
    var phi_895_: bool;
    var phi_896_: bool;
    var phi_897_: bool;
    var phi_901_: bool;
    var phi_923_: bool;
    var phi_924_: bool;
    var phi_937_: bool;
    var phi_938_: bool;
    var phi_939_: bool;
    var phi_946_: u32;
    var phi_947_: u32;
    var phi_948_: u32;
    var phi_949_: u32;
    var phi_950_: u32;
    var phi_951_: u32;
    var phi_952_: u32;
    var phi_964_: bool;
    var phi_965_: bool;
    var phi_966_: bool;
    var phi_967_: bool;
    var phi_971_: bool;
    var phi_977_: bool;
    var phi_985_: u32;
    var phi_990_: u32;
    var phi_999_: u32;
    var phi_1004_: u32;
    var phi_1008_: u32;
    var phi_1009_: u32;
    var phi_1010_: u32;
    var phi_1014_: f32;
    var phi_1016_: mask_Masked;
    var phi_1088_: bool;
    var phi_1089_: bool;
    var phi_1090_: bool;
    var phi_1091_: bool;
    var phi_1095_: bool;
    var phi_1123_: f32;
    var phi_1126_: bool;
    var phi_1127_: u32;
    var phi_1138_: u32;
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
            phi_1016_ = mask_Masked(_e256.unnamed.visibility, 0u, false);
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
            let _e316 = lt_mask_Neighbourhood(false, true);
            if _e265 {
                phi_544_ = false;
            } else {
                phi_544_ = true;
            }
            let _e318 = phi_544_;
            if _e318 {
                if _e315 {
                    if ((0u & 2u) != 0u) {
                        phi_838_ = _e316;
                    } else {
                        let _e322 = p.member.expansion;
                        if false {
                            let _e324 = p.member.moving_pattern;
                            phi_565_ = _e324;
                        } else {
                            let _e326 = p.member.still_pattern;
                            phi_565_ = _e326;
                        }
                        let _e328 = phi_565_;
                        phi_567_ = 0u;
                        phi_570_ = _e316;
                        loop {
                            let _e330 = phi_567_;
                            let _e332 = phi_570_;
                            local_1 = _e332;
                            if (1u <= _e328) {
                                if (_e328 <= 4u) {
                                    phi_582_ = false;
                                } else {
                                    phi_582_ = true;
                                }
                                let _e336 = phi_582_;
                                phi_583_ = _e336;
                            } else {
                                phi_583_ = true;
                            }
                            let _e338 = phi_583_;
                            if _e338 {
                                switch bitcast<i32>(_e328) {
                                    case 5: {
                                        phi_592_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_592_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_592_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_592_ = 9u;
                                        break;
                                    }
                                }
                                let _e341 = phi_592_;
                                phi_593_ = _e341;
                            } else {
                                phi_593_ = 5u;
                            }
                            let _e343 = phi_593_;
                            let _e344 = (_e330 < _e343);
                            if _e344 {
                                let _e346 = p.member.frame;
                                let _e350 = p.member.current.size[0u];
                                let _e352 = p.member.current.size[1u];
                                switch bitcast<i32>(_e328) {
                                    case 1: {
                                        let _e362 = lt_mask_pattern_plus(_e330);
                                        phi_673_ = vec2<i32>(_e362.x, _e362.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e366 = lt_mask_pattern_cross(_e330);
                                        phi_673_ = vec2<i32>(_e366.x, _e366.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e372 = lt_mask_pattern_plus_or_cross(_e330, ((_e47.x + _e47.y) & 1u));
                                        phi_673_ = vec2<i32>(_e372.x, _e372.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e377 = lt_mask_pattern_plus_or_cross(_e330, (_e346 & 1u));
                                        phi_673_ = vec2<i32>(_e377.x, _e377.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e346 & 3u)) {
                                            case 0: {
                                                phi_653_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_653_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_653_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_653_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e388 = phi_653_;
                                        phi_673_ = (_e388 + vec2<i32>(bitcast<i32>((_e330 & 1u)), bitcast<i32>(((_e330 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_673_ = vec2<i32>((bitcast<i32>((_e330 % 5u)) - 2i), (bitcast<i32>(((_e330 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e405 = lt_mask_pattern_diamond(_e330);
                                        phi_673_ = vec2<i32>(_e405.x, _e405.y);
                                        break;
                                    }
                                    default: {
                                        phi_673_ = vec2<i32>((bitcast<i32>((_e330 % 3u)) - 1i), (bitcast<i32>(((_e330 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e410 = phi_673_;
                                let _e413 = lt_mask_pattern_step_clamped(_e47.x, _e410.x, _e350);
                                let _e414 = lt_mask_pattern_step_clamped(_e47.y, _e410.y, _e352);
                                let _e421 = ((((_e414 * _e98) + _e413) * _e94.words) + _e94.light.word);
                                if (_e94.light.shift > 29u) {
                                    let _e425 = (_e421 + 1u);
                                    if (_e425 < _e53) {
                                    } else {
                                        return;
                                    }
                                    let _e429 = last_bits.member[(0u + _e425)];
                                    phi_700_ = _e429;
                                } else {
                                    phi_700_ = 0u;
                                }
                                let _e431 = phi_700_;
                                if (_e421 < _e53) {
                                } else {
                                    return;
                                }
                                let _e437 = last_bits.member[(0u + _e421)];
                                let _e440 = (_e437 >> bitcast<u32>((_e94.light.shift & 31u)));
                                if (_e94.light.shift > 29u) {
                                    phi_719_ = (_e440 | (_e431 << bitcast<u32>(((32u - _e94.light.shift) & 31u))));
                                } else {
                                    phi_719_ = _e440;
                                }
                                let _e448 = phi_719_;
                                if ((_e448 & 2u) == 0u) {
                                    phi_727_ = (_e448 & 1u);
                                } else {
                                    phi_727_ = (_e448 & 7u);
                                }
                                let _e454 = phi_727_;
                                if _e332.any_expands {
                                    phi_815_ = true;
                                } else {
                                    if ((_e454 & 2u) != 0u) {
                                        let _e461 = (((_e454 & 4u) != 0u) != _e261);
                                        switch bitcast<i32>(_e322) {
                                            case 1: {
                                                phi_755_ = bool();
                                                phi_756_ = false;
                                                phi_757_ = true;
                                                phi_758_ = false;
                                                phi_759_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e461 {
                                                    phi_753_ = (((_e454 & 4u) != 0u) != ((_e454 & 1u) != 0u));
                                                    phi_754_ = false;
                                                } else {
                                                    phi_753_ = bool();
                                                    phi_754_ = true;
                                                }
                                                let _e469 = phi_753_;
                                                let _e471 = phi_754_;
                                                phi_755_ = _e469;
                                                phi_756_ = false;
                                                phi_757_ = false;
                                                phi_758_ = _e471;
                                                phi_759_ = _e461;
                                                break;
                                            }
                                            default: {
                                                phi_755_ = bool();
                                                phi_756_ = true;
                                                phi_757_ = false;
                                                phi_758_ = false;
                                                phi_759_ = false;
                                                break;
                                            }
                                        }
                                        let _e473 = phi_755_;
                                        let _e475 = phi_756_;
                                        let _e477 = phi_757_;
                                        let _e479 = phi_758_;
                                        let _e481 = phi_759_;
                                        phi_767_ = _e461;
                                        phi_768_ = _e473;
                                        phi_769_ = _e475;
                                        phi_770_ = _e477;
                                        phi_771_ = _e479;
                                        phi_772_ = _e481;
                                    } else {
                                        switch bitcast<i32>(_e322) {
                                            case 1: {
                                                phi_764_ = false;
                                                phi_765_ = true;
                                                phi_766_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_764_ = false;
                                                phi_765_ = false;
                                                phi_766_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_764_ = true;
                                                phi_765_ = false;
                                                phi_766_ = false;
                                                break;
                                            }
                                        }
                                        let _e484 = phi_764_;
                                        let _e486 = phi_765_;
                                        let _e488 = phi_766_;
                                        phi_767_ = false;
                                        phi_768_ = bool();
                                        phi_769_ = _e484;
                                        phi_770_ = _e486;
                                        phi_771_ = _e488;
                                        phi_772_ = false;
                                    }
                                    let _e490 = phi_767_;
                                    let _e492 = phi_768_;
                                    let _e494 = phi_769_;
                                    let _e496 = phi_770_;
                                    let _e498 = phi_771_;
                                    let _e500 = phi_772_;
                                    if _e494 {
                                        if ((_e454 & 2u) != 0u) {
                                            if (((_e454 & 4u) != 0u) != _e261) {
                                                phi_787_ = false;
                                            } else {
                                                phi_787_ = true;
                                            }
                                            let _e507 = phi_787_;
                                            phi_788_ = _e507;
                                        } else {
                                            phi_788_ = true;
                                        }
                                        let _e509 = phi_788_;
                                        if _e509 {
                                            phi_795_ = (((_e454 & 1u) != 0u) != _e261);
                                        } else {
                                            phi_795_ = true;
                                        }
                                        let _e514 = phi_795_;
                                        phi_796_ = _e514;
                                        phi_797_ = false;
                                        phi_798_ = false;
                                        phi_799_ = false;
                                    } else {
                                        phi_796_ = bool();
                                        phi_797_ = _e496;
                                        phi_798_ = _e498;
                                        phi_799_ = _e500;
                                    }
                                    let _e516 = phi_796_;
                                    let _e518 = phi_797_;
                                    let _e520 = phi_798_;
                                    let _e522 = phi_799_;
                                    if _e518 {
                                        phi_803_ = _e490;
                                        phi_804_ = false;
                                        phi_805_ = false;
                                    } else {
                                        phi_803_ = _e516;
                                        phi_804_ = _e520;
                                        phi_805_ = _e522;
                                    }
                                    let _e524 = phi_803_;
                                    let _e526 = phi_804_;
                                    let _e528 = phi_805_;
                                    if _e526 {
                                        phi_809_ = false;
                                        phi_810_ = true;
                                    } else {
                                        phi_809_ = _e492;
                                        phi_810_ = _e528;
                                    }
                                    let _e530 = phi_809_;
                                    let _e532 = phi_810_;
                                    if _e532 {
                                        phi_814_ = _e530;
                                    } else {
                                        phi_814_ = _e524;
                                    }
                                    let _e534 = phi_814_;
                                    phi_815_ = _e534;
                                }
                                let _e536 = phi_815_;
                                if _e332.all_remove {
                                    if (((_e454 & 1u) != 0u) == _e261) {
                                        if ((_e454 & 2u) != 0u) {
                                            phi_833_ = (((_e454 & 4u) != 0u) == _e261);
                                        } else {
                                            phi_833_ = true;
                                        }
                                        let _e546 = phi_833_;
                                        phi_834_ = _e546;
                                    } else {
                                        phi_834_ = false;
                                    }
                                    let _e548 = phi_834_;
                                    phi_835_ = _e548;
                                } else {
                                    phi_835_ = false;
                                }
                                let _e550 = phi_835_;
                                phi_568_ = (_e330 + 1u);
                                phi_571_ = lt_mask_Neighbourhood(_e536, _e550);
                            } else {
                                phi_568_ = u32();
                                phi_571_ = lt_mask_Neighbourhood();
                            }
                            let _e554 = phi_568_;
                            let _e556 = phi_571_;
                            continue;
                            continuing {
                                phi_567_ = _e554;
                                phi_570_ = _e556;
                                break if !(_e344);
                            }
                        }
                        let _e851 = local_1;
                        phi_838_ = _e851;
                    }
                    let _e559 = phi_838_;
                    phi_839_ = _e559;
                } else {
                    phi_839_ = _e316;
                }
                let _e561 = phi_839_;
                phi_840_ = _e561;
            } else {
                phi_840_ = _e316;
            }
            let _e563 = phi_840_;
            let _e566 = p.member.frame;
            let _e568 = p.member.refresh;
            if (_e568 == 0u) {
                phi_873_ = false;
            } else {
                if (_e568 == 0u) {
                    return;
                }
                let _e577 = ((_e47.x + (_e47.y * (((_e568 * 5u) / 8u) | 1u))) + (_e566 % _e568));
                if (_e568 == 0u) {
                    phi_872_ = (_e577 == 0u);
                } else {
                    if (_e568 == 0u) {
                        return;
                    }
                    phi_872_ = ((_e577 % _e568) == 0u);
                }
                let _e584 = phi_872_;
                phi_873_ = _e584;
            }
            let _e586 = phi_873_;
            if _e315 {
                if _e586 {
                    phi_895_ = bool();
                } else {
                    phi_895_ = ((0u & 2u) != 0u);
                }
                let _e592 = phi_895_;
                phi_896_ = _e592;
                phi_897_ = _e586;
            } else {
                phi_896_ = bool();
                phi_897_ = true;
            }
            let _e594 = phi_896_;
            let _e596 = phi_897_;
            if _e596 {
                phi_901_ = false;
            } else {
                phi_901_ = _e594;
            }
            let _e598 = phi_901_;
            if _e598 {
                phi_952_ = 7u;
            } else {
                if (_e103 != 0.5f) {
                    if _e315 {
                        if _e586 {
                            phi_949_ = 6u;
                        } else {
                            if _e265 {
                                phi_924_ = true;
                            } else {
                                if _e563.any_expands {
                                    phi_923_ = false;
                                } else {
                                    phi_923_ = true;
                                }
                                let _e600 = phi_923_;
                                phi_924_ = _e600;
                            }
                            let _e602 = phi_924_;
                            if _e602 {
                                if _e265 {
                                    if false {
                                        if _e563.all_remove {
                                            phi_937_ = false;
                                        } else {
                                            phi_937_ = true;
                                        }
                                        let _e604 = phi_937_;
                                        phi_938_ = _e604;
                                    } else {
                                        phi_938_ = true;
                                    }
                                    let _e606 = phi_938_;
                                    phi_939_ = _e606;
                                } else {
                                    phi_939_ = true;
                                }
                                let _e608 = phi_939_;
                                if _e608 {
                                    if _e265 {
                                        phi_946_ = 1u;
                                    } else {
                                        phi_946_ = 0u;
                                    }
                                    let _e610 = phi_946_;
                                    phi_947_ = _e610;
                                } else {
                                    phi_947_ = 5u;
                                }
                                let _e612 = phi_947_;
                                phi_948_ = _e612;
                            } else {
                                phi_948_ = 4u;
                            }
                            let _e614 = phi_948_;
                            phi_949_ = _e614;
                        }
                        let _e616 = phi_949_;
                        phi_950_ = _e616;
                    } else {
                        phi_950_ = 3u;
                    }
                    let _e618 = phi_950_;
                    phi_951_ = _e618;
                } else {
                    phi_951_ = 2u;
                }
                let _e620 = phi_951_;
                phi_952_ = _e620;
            }
            let _e622 = phi_952_;
            if !((_e622 == 0u)) {
                if !((_e622 == 5u)) {
                    phi_964_ = !(_e598);
                    phi_965_ = false;
                } else {
                    phi_964_ = bool();
                    phi_965_ = true;
                }
                let _e629 = phi_964_;
                let _e631 = phi_965_;
                phi_966_ = _e629;
                phi_967_ = _e631;
            } else {
                phi_966_ = bool();
                phi_967_ = true;
            }
            let _e633 = phi_966_;
            let _e635 = phi_967_;
            if _e635 {
                phi_971_ = false;
            } else {
                phi_971_ = _e633;
            }
            let _e637 = phi_971_;
            if _e598 {
                phi_977_ = ((0u & 4u) != 0u);
            } else {
                phi_977_ = _e261;
            }
            let _e641 = phi_977_;
            if _e637 {
                if _e261 {
                    phi_985_ = (2u | 1u);
                } else {
                    phi_985_ = 2u;
                }
                let _e644 = phi_985_;
                if false {
                    phi_990_ = (_e644 | 4u);
                } else {
                    phi_990_ = _e644;
                }
                let _e647 = phi_990_;
                phi_1010_ = _e647;
            } else {
                if (_e622 == 7u) {
                    if _e261 {
                        phi_999_ = (2u | 1u);
                    } else {
                        phi_999_ = 2u;
                    }
                    let _e651 = phi_999_;
                    if _e641 {
                        phi_1004_ = (_e651 | 4u);
                    } else {
                        phi_1004_ = _e651;
                    }
                    let _e654 = phi_1004_;
                    phi_1009_ = _e654;
                } else {
                    if _e261 {
                        phi_1008_ = 1u;
                    } else {
                        phi_1008_ = 0u;
                    }
                    let _e656 = phi_1008_;
                    phi_1009_ = _e656;
                }
                let _e658 = phi_1009_;
                phi_1010_ = _e658;
            }
            let _e660 = phi_1010_;
            if _e641 {
                phi_1014_ = 0f;
            } else {
                phi_1014_ = 1f;
            }
            let _e662 = phi_1014_;
            phi_1016_ = mask_Masked(_e662, _e660, _e637);
        }
        let _e665 = phi_1016_;
        visibility.member[_e67.shift] = _e665.visibility;
        let _e670 = p.member.light.number;
        let _e671 = (_e670 * 3u);
        let _e673 = (_e671 % 32u);
        let _e675 = p.member.light.mask_words;
        let _e677 = ((_e67.shift * _e675) + (_e671 / 32u));
        let _e679 = bits.member[_e677];
        bits.member[_e677] = ((_e679 & ~((7u << bitcast<u32>((_e673 & 31u))))) | (_e665.bits << bitcast<u32>((_e673 & 31u))));
        if (_e673 > 29u) {
            let _e694 = bits.member[(_e677 + 1u)];
            let _e696 = (32u - _e673);
            bits.member[(_e677 + 1u)] = ((_e694 & ~((7u >> bitcast<u32>((_e696 & 31u))))) | (_e665.bits >> bitcast<u32>((_e696 & 31u))));
        }
        let _e711 = samples.member[_e67.shift].normal[0u];
        let _e713 = global[0u];
        if (_e711 == _e713) {
            let _e716 = samples.member[_e67.shift].normal[1u];
            let _e718 = global[1u];
            if (_e716 == _e718) {
                let _e721 = samples.member[_e67.shift].normal[2u];
                let _e723 = global[2u];
                phi_1088_ = (_e721 == _e723);
                phi_1089_ = false;
            } else {
                phi_1088_ = bool();
                phi_1089_ = true;
            }
            let _e726 = phi_1088_;
            let _e728 = phi_1089_;
            phi_1090_ = _e726;
            phi_1091_ = _e728;
        } else {
            phi_1090_ = bool();
            phi_1091_ = true;
        }
        let _e730 = phi_1090_;
        let _e732 = phi_1091_;
        if _e732 {
            phi_1095_ = false;
        } else {
            phi_1095_ = _e730;
        }
        let _e734 = phi_1095_;
        if !(_e734) {
            let _e737 = samples.member[_e67.shift].position;
            let _e739 = p.member.current.eye;
            let _e750 = p.member.current.forward;
            phi_1123_ = ((((_e737.x - _e739.x) * _e750.x) + ((_e737.y - _e739.y) * _e750.y)) + ((_e737.z - _e739.z) * _e750.z));
        } else {
            phi_1123_ = 0f;
        }
        let _e760 = phi_1123_;
        depths.member[_e67.shift] = _e760;
        phi_1126_ = _e665.needs_ray;
        phi_1127_ = _e67.shift;
    } else {
        phi_1126_ = false;
        phi_1127_ = 0u;
    }
    let _e764 = phi_1126_;
    let _e766 = phi_1127_;
    if (_e48 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e764 {
        let _e770 = atomicAdd((&shared_[0u]), 1u);
        phi_1138_ = _e770;
    } else {
        phi_1138_ = 0u;
    }
    let _e772 = phi_1138_;
    workgroupBarrier();
    if (_e48 == 0u) {
        let _e776 = atomicLoad((&shared_[0u]));
        let _e777 = atomicAdd((&list.member[3u]), _e776);
        atomicStore((&shared_[1u]), _e777);
    }
    workgroupBarrier();
    if _e764 {
        let _e780 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e780) + _e772)]), _e766);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
