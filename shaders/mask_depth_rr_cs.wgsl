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
    var phi_551_: bool;
    var phi_562_: bool;
    var phi_563_: bool;
    var phi_564_: bool;
    var phi_565_: bool;
    var phi_566_: bool;
    var phi_567_: bool;
    var phi_571_: bool;
    var phi_576_: bool;
    var phi_590_: u32;
    var phi_592_: u32;
    var phi_595_: lt_mask_Neighbourhood;
    var phi_607_: bool;
    var phi_608_: bool;
    var phi_617_: u32;
    var phi_618_: u32;
    var phi_678_: vec2<i32>;
    var phi_698_: vec2<i32>;
    var phi_725_: u32;
    var phi_744_: u32;
    var phi_752_: u32;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_777_: bool;
    var phi_778_: bool;
    var phi_796_: bool;
    var phi_797_: bool;
    var phi_798_: bool;
    var phi_593_: u32;
    var phi_596_: lt_mask_Neighbourhood;
    var phi_801_: lt_mask_Neighbourhood;
    var phi_802_: lt_mask_Neighbourhood;
    var phi_834_: bool;
    var phi_835_: bool;
    var phi_864_: bool;
    var phi_865_: bool;
    var phi_878_: bool;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_887_: u32;
    var phi_888_: u32;
    var phi_889_: u32;
    var phi_890_: u32;
    var phi_891_: u32;
    var phi_892_: u32;
    var phi_900_: bool;
    var phi_908_: u32;
    var phi_913_: u32;
    var phi_917_: u32;
    var phi_918_: u32;
    var phi_922_: f32;
    var phi_924_: mask_Masked;
    var phi_996_: bool;
    var phi_997_: bool;
    var phi_998_: bool;
    var phi_999_: bool;
    var phi_1003_: bool;
    var phi_1031_: f32;
    var phi_1034_: bool;
    var phi_1035_: u32;
    var phi_1046_: u32;
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
            phi_924_ = mask_Masked(_e256.unnamed.visibility, 0u, false);
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
            let _e317 = p.member.flags;
            if false {
                let _e321 = p.member.flags;
                phi_551_ = ((_e321 & 4u) == 0u);
            } else {
                phi_551_ = false;
            }
            let _e325 = phi_551_;
            if ((_e317 & 2u) != 0u) {
                if false {
                    phi_564_ = bool();
                    phi_565_ = true;
                } else {
                    if true {
                        phi_562_ = !(_e325);
                        phi_563_ = false;
                    } else {
                        phi_562_ = bool();
                        phi_563_ = true;
                    }
                    let _e328 = phi_562_;
                    let _e330 = phi_563_;
                    phi_564_ = _e328;
                    phi_565_ = _e330;
                }
                let _e332 = phi_564_;
                let _e334 = phi_565_;
                phi_566_ = _e332;
                phi_567_ = _e334;
            } else {
                phi_566_ = bool();
                phi_567_ = true;
            }
            let _e336 = phi_566_;
            let _e338 = phi_567_;
            if _e338 {
                phi_571_ = false;
            } else {
                phi_571_ = _e336;
            }
            let _e340 = phi_571_;
            let _e341 = lt_mask_Neighbourhood(false, true);
            if _e265 {
                phi_576_ = _e340;
            } else {
                phi_576_ = false;
            }
            let _e343 = phi_576_;
            if _e343 {
                if _e315 {
                    if false {
                        let _e345 = p.member.moving_pattern;
                        phi_590_ = _e345;
                    } else {
                        let _e347 = p.member.still_pattern;
                        phi_590_ = _e347;
                    }
                    let _e349 = phi_590_;
                    phi_592_ = 0u;
                    phi_595_ = _e341;
                    loop {
                        let _e351 = phi_592_;
                        let _e353 = phi_595_;
                        local_1 = _e353;
                        if (1u <= _e349) {
                            if (_e349 <= 4u) {
                                phi_607_ = false;
                            } else {
                                phi_607_ = true;
                            }
                            let _e357 = phi_607_;
                            phi_608_ = _e357;
                        } else {
                            phi_608_ = true;
                        }
                        let _e359 = phi_608_;
                        if _e359 {
                            switch bitcast<i32>(_e349) {
                                case 5: {
                                    phi_617_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_617_ = 25u;
                                    break;
                                }
                                case 7: {
                                    phi_617_ = 13u;
                                    break;
                                }
                                default: {
                                    phi_617_ = 9u;
                                    break;
                                }
                            }
                            let _e362 = phi_617_;
                            phi_618_ = _e362;
                        } else {
                            phi_618_ = 5u;
                        }
                        let _e364 = phi_618_;
                        let _e365 = (_e351 < _e364);
                        if _e365 {
                            let _e367 = p.member.frame;
                            let _e371 = p.member.current.size[0u];
                            let _e373 = p.member.current.size[1u];
                            switch bitcast<i32>(_e349) {
                                case 1: {
                                    let _e383 = lt_mask_pattern_plus(_e351);
                                    phi_698_ = vec2<i32>(_e383.x, _e383.y);
                                    break;
                                }
                                case 2: {
                                    let _e387 = lt_mask_pattern_cross(_e351);
                                    phi_698_ = vec2<i32>(_e387.x, _e387.y);
                                    break;
                                }
                                case 3: {
                                    let _e393 = lt_mask_pattern_plus_or_cross(_e351, ((_e47.x + _e47.y) & 1u));
                                    phi_698_ = vec2<i32>(_e393.x, _e393.y);
                                    break;
                                }
                                case 4: {
                                    let _e398 = lt_mask_pattern_plus_or_cross(_e351, (_e367 & 1u));
                                    phi_698_ = vec2<i32>(_e398.x, _e398.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e367 & 3u)) {
                                        case 0: {
                                            phi_678_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_678_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_678_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_678_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e409 = phi_678_;
                                    phi_698_ = (_e409 + vec2<i32>(bitcast<i32>((_e351 & 1u)), bitcast<i32>(((_e351 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_698_ = vec2<i32>((bitcast<i32>((_e351 % 5u)) - 2i), (bitcast<i32>(((_e351 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                case 7: {
                                    let _e426 = lt_mask_pattern_diamond(_e351);
                                    phi_698_ = vec2<i32>(_e426.x, _e426.y);
                                    break;
                                }
                                default: {
                                    phi_698_ = vec2<i32>((bitcast<i32>((_e351 % 3u)) - 1i), (bitcast<i32>(((_e351 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e431 = phi_698_;
                            let _e434 = lt_mask_pattern_step_clamped(_e47.x, _e431.x, _e371);
                            let _e435 = lt_mask_pattern_step_clamped(_e47.y, _e431.y, _e373);
                            let _e442 = ((((_e435 * _e98) + _e434) * _e94.words) + _e94.light.word);
                            if (_e94.light.shift > 29u) {
                                let _e446 = (_e442 + 1u);
                                if (_e446 < _e53) {
                                } else {
                                    return;
                                }
                                let _e450 = last_bits.member[(0u + _e446)];
                                phi_725_ = _e450;
                            } else {
                                phi_725_ = 0u;
                            }
                            let _e452 = phi_725_;
                            if (_e442 < _e53) {
                            } else {
                                return;
                            }
                            let _e458 = last_bits.member[(0u + _e442)];
                            let _e461 = (_e458 >> bitcast<u32>((_e94.light.shift & 31u)));
                            if (_e94.light.shift > 29u) {
                                phi_744_ = (_e461 | (_e452 << bitcast<u32>(((32u - _e94.light.shift) & 31u))));
                            } else {
                                phi_744_ = _e461;
                            }
                            let _e469 = phi_744_;
                            if ((_e469 & 2u) == 0u) {
                                phi_752_ = (_e469 & 1u);
                            } else {
                                phi_752_ = (_e469 & 7u);
                            }
                            let _e475 = phi_752_;
                            if _e353.any_expands {
                                phi_778_ = true;
                            } else {
                                if ((_e475 & 2u) != 0u) {
                                    if (((_e475 & 4u) != 0u) != _e261) {
                                        phi_769_ = false;
                                    } else {
                                        phi_769_ = true;
                                    }
                                    let _e484 = phi_769_;
                                    phi_770_ = _e484;
                                } else {
                                    phi_770_ = true;
                                }
                                let _e486 = phi_770_;
                                if _e486 {
                                    phi_777_ = (((_e475 & 1u) != 0u) != _e261);
                                } else {
                                    phi_777_ = true;
                                }
                                let _e491 = phi_777_;
                                phi_778_ = _e491;
                            }
                            let _e493 = phi_778_;
                            if _e353.all_remove {
                                if (((_e475 & 1u) != 0u) == _e261) {
                                    if ((_e475 & 2u) != 0u) {
                                        phi_796_ = (((_e475 & 4u) != 0u) == _e261);
                                    } else {
                                        phi_796_ = true;
                                    }
                                    let _e503 = phi_796_;
                                    phi_797_ = _e503;
                                } else {
                                    phi_797_ = false;
                                }
                                let _e505 = phi_797_;
                                phi_798_ = _e505;
                            } else {
                                phi_798_ = false;
                            }
                            let _e507 = phi_798_;
                            phi_593_ = (_e351 + 1u);
                            phi_596_ = lt_mask_Neighbourhood(_e493, _e507);
                        } else {
                            phi_593_ = u32();
                            phi_596_ = lt_mask_Neighbourhood();
                        }
                        let _e511 = phi_593_;
                        let _e513 = phi_596_;
                        continue;
                        continuing {
                            phi_592_ = _e511;
                            phi_595_ = _e513;
                            break if !(_e365);
                        }
                    }
                    let _e754 = local_1;
                    phi_801_ = _e754;
                } else {
                    phi_801_ = _e341;
                }
                let _e516 = phi_801_;
                phi_802_ = _e516;
            } else {
                phi_802_ = _e341;
            }
            let _e518 = phi_802_;
            let _e521 = p.member.frame;
            let _e523 = p.member.refresh;
            if (_e523 == 0u) {
                phi_835_ = false;
            } else {
                if (_e523 == 0u) {
                    return;
                }
                let _e532 = ((_e47.x + (_e47.y * (((_e523 * 5u) / 8u) | 1u))) + (_e521 % _e523));
                if (_e523 == 0u) {
                    phi_834_ = (_e532 == 0u);
                } else {
                    if (_e523 == 0u) {
                        return;
                    }
                    phi_834_ = ((_e532 % _e523) == 0u);
                }
                let _e539 = phi_834_;
                phi_835_ = _e539;
            }
            let _e541 = phi_835_;
            if (_e103 != 0.5f) {
                if _e315 {
                    if _e541 {
                        phi_890_ = 6u;
                    } else {
                        if _e265 {
                            phi_865_ = true;
                        } else {
                            if _e518.any_expands {
                                phi_864_ = false;
                            } else {
                                phi_864_ = true;
                            }
                            let _e545 = phi_864_;
                            phi_865_ = _e545;
                        }
                        let _e547 = phi_865_;
                        if _e547 {
                            if _e265 {
                                if _e340 {
                                    if _e518.all_remove {
                                        phi_878_ = false;
                                    } else {
                                        phi_878_ = true;
                                    }
                                    let _e549 = phi_878_;
                                    phi_879_ = _e549;
                                } else {
                                    phi_879_ = true;
                                }
                                let _e551 = phi_879_;
                                phi_880_ = _e551;
                            } else {
                                phi_880_ = true;
                            }
                            let _e553 = phi_880_;
                            if _e553 {
                                if _e265 {
                                    phi_887_ = 1u;
                                } else {
                                    phi_887_ = 0u;
                                }
                                let _e555 = phi_887_;
                                phi_888_ = _e555;
                            } else {
                                phi_888_ = 5u;
                            }
                            let _e557 = phi_888_;
                            phi_889_ = _e557;
                        } else {
                            phi_889_ = 4u;
                        }
                        let _e559 = phi_889_;
                        phi_890_ = _e559;
                    }
                    let _e561 = phi_890_;
                    phi_891_ = _e561;
                } else {
                    phi_891_ = 3u;
                }
                let _e563 = phi_891_;
                phi_892_ = _e563;
            } else {
                phi_892_ = 2u;
            }
            let _e565 = phi_892_;
            if !((_e565 == 0u)) {
                phi_900_ = !((_e565 == 5u));
            } else {
                phi_900_ = false;
            }
            let _e571 = phi_900_;
            if _e571 {
                if _e261 {
                    phi_908_ = (2u | 1u);
                } else {
                    phi_908_ = 2u;
                }
                let _e574 = phi_908_;
                if false {
                    phi_913_ = (_e574 | 4u);
                } else {
                    phi_913_ = _e574;
                }
                let _e577 = phi_913_;
                phi_918_ = _e577;
            } else {
                if _e261 {
                    phi_917_ = 1u;
                } else {
                    phi_917_ = 0u;
                }
                let _e579 = phi_917_;
                phi_918_ = _e579;
            }
            let _e581 = phi_918_;
            if _e261 {
                phi_922_ = 0f;
            } else {
                phi_922_ = 1f;
            }
            let _e583 = phi_922_;
            phi_924_ = mask_Masked(_e583, _e581, _e571);
        }
        let _e586 = phi_924_;
        visibility.member[_e67.shift] = _e586.visibility;
        let _e591 = p.member.light.number;
        let _e592 = (_e591 * 3u);
        let _e594 = (_e592 % 32u);
        let _e596 = p.member.light.mask_words;
        let _e598 = ((_e67.shift * _e596) + (_e592 / 32u));
        let _e600 = bits.member[_e598];
        bits.member[_e598] = ((_e600 & ~((7u << bitcast<u32>((_e594 & 31u))))) | (_e586.bits << bitcast<u32>((_e594 & 31u))));
        if (_e594 > 29u) {
            let _e615 = bits.member[(_e598 + 1u)];
            let _e617 = (32u - _e594);
            bits.member[(_e598 + 1u)] = ((_e615 & ~((7u >> bitcast<u32>((_e617 & 31u))))) | (_e586.bits >> bitcast<u32>((_e617 & 31u))));
        }
        let _e632 = samples.member[_e67.shift].normal[0u];
        let _e634 = global[0u];
        if (_e632 == _e634) {
            let _e637 = samples.member[_e67.shift].normal[1u];
            let _e639 = global[1u];
            if (_e637 == _e639) {
                let _e642 = samples.member[_e67.shift].normal[2u];
                let _e644 = global[2u];
                phi_996_ = (_e642 == _e644);
                phi_997_ = false;
            } else {
                phi_996_ = bool();
                phi_997_ = true;
            }
            let _e647 = phi_996_;
            let _e649 = phi_997_;
            phi_998_ = _e647;
            phi_999_ = _e649;
        } else {
            phi_998_ = bool();
            phi_999_ = true;
        }
        let _e651 = phi_998_;
        let _e653 = phi_999_;
        if _e653 {
            phi_1003_ = false;
        } else {
            phi_1003_ = _e651;
        }
        let _e655 = phi_1003_;
        if !(_e655) {
            let _e658 = samples.member[_e67.shift].position;
            let _e660 = p.member.current.eye;
            let _e671 = p.member.current.forward;
            phi_1031_ = ((((_e658.x - _e660.x) * _e671.x) + ((_e658.y - _e660.y) * _e671.y)) + ((_e658.z - _e660.z) * _e671.z));
        } else {
            phi_1031_ = 0f;
        }
        let _e681 = phi_1031_;
        depths.member[_e67.shift] = _e681;
        phi_1034_ = _e586.needs_ray;
        phi_1035_ = _e67.shift;
    } else {
        phi_1034_ = false;
        phi_1035_ = 0u;
    }
    let _e685 = phi_1034_;
    let _e687 = phi_1035_;
    if (_e48 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e685 {
        let _e691 = atomicAdd((&shared_[0u]), 1u);
        phi_1046_ = _e691;
    } else {
        phi_1046_ = 0u;
    }
    let _e693 = phi_1046_;
    workgroupBarrier();
    if (_e48 == 0u) {
        let _e697 = atomicLoad((&shared_[0u]));
        let _e698 = atomicAdd((&list.member[3u]), _e697);
        atomicStore((&shared_[1u]), _e698);
    }
    workgroupBarrier();
    if _e685 {
        let _e701 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e701) + _e693)]), _e687);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_depth_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
