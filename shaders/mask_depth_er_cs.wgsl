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
    var phi_165_: lt_mask_LightPlace;
    var phi_166_: bool;
    var phi_167_: lt_mask_LightPlace;
    var phi_168_: bool;
    var phi_173_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_165_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_166_ = false;
        } else {
            phi_165_ = lt_mask_LightPlace();
            phi_166_ = true;
        }
        let _e61 = phi_165_;
        let _e63 = phi_166_;
        phi_167_ = _e61;
        phi_168_ = _e63;
    } else {
        phi_167_ = lt_mask_LightPlace();
        phi_168_ = true;
    }
    let _e65 = phi_167_;
    let _e67 = phi_168_;
    if _e67 {
        phi_173_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_173_ = _e65;
    }
    let _e72 = phi_173_;
    return lt_mask_LightPlace(_e72.word, _e72.shift);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_191_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_191_ = vec2(0i);
            break;
        }
        case 1: {
            phi_191_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_191_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_191_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_191_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e57 = phi_191_;
    return vec2<i32>(_e57.x, _e57.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_209_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_209_ = vec2(0i);
            break;
        }
        case 1: {
            phi_209_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_209_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_209_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_209_ = vec2(1i);
            break;
        }
    }
    let _e57 = phi_209_;
    return vec2<i32>(_e57.x, _e57.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_228_: vec2<i32>;

    if (param_6 == 0u) {
        let _e51 = lt_mask_pattern_plus(param_5);
        phi_228_ = vec2<i32>(_e51.x, _e51.y);
    } else {
        let _e55 = lt_mask_pattern_cross(param_5);
        phi_228_ = vec2<i32>(_e55.x, _e55.y);
    }
    let _e60 = phi_228_;
    return vec2<i32>(_e60.x, _e60.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_253_: vec2<i32>;

    let _e49 = (param_7 % 13u);
    switch bitcast<i32>(_e49) {
        case 9: {
            phi_253_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_253_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_253_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_253_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_253_ = vec2<i32>((bitcast<i32>((_e49 % 3u)) - 1i), (bitcast<i32>(((_e49 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e64 = phi_253_;
    return vec2<i32>(_e64.x, _e64.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_274_: u32;
    var phi_275_: u32;

    let _e52 = (bitcast<i32>(param_8) + param_9);
    if (_e52 < 0i) {
        phi_275_ = 0u;
    } else {
        if (_e52 >= bitcast<i32>(param_10)) {
            phi_274_ = (param_10 - 1u);
        } else {
            phi_274_ = bitcast<u32>(_e52);
        }
        let _e59 = phi_274_;
        phi_275_ = _e59;
    }
    let _e61 = phi_275_;
    return _e61;
}

fn function_() {
    var phi_352_: bool;
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_359_: bool;
    var phi_429_: bool;
    var phi_430_: bool;
    var phi_441_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_442_: bool;
    var phi_443_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_444_: bool;
    var phi_451_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_455_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_468_: bool;
    var phi_548_: bool;
    var phi_552_: f32;
    var phi_563_: bool;
    var phi_569_: bool;
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
    var phi_778_: bool;
    var phi_779_: bool;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_791_: bool;
    var phi_792_: bool;
    var phi_793_: bool;
    var phi_794_: bool;
    var phi_795_: bool;
    var phi_796_: bool;
    var phi_797_: bool;
    var phi_812_: bool;
    var phi_813_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_834_: bool;
    var phi_835_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_858_: bool;
    var phi_859_: bool;
    var phi_860_: bool;
    var phi_593_: u32;
    var phi_596_: lt_mask_Neighbourhood;
    var phi_863_: lt_mask_Neighbourhood;
    var phi_864_: lt_mask_Neighbourhood;
    var phi_865_: lt_mask_Neighbourhood;
    var phi_897_: bool;
    var phi_898_: bool;
    var phi_920_: bool;
    var phi_921_: bool;
    var phi_922_: bool;
    var phi_926_: bool;
    var phi_948_: bool;
    var phi_949_: bool;
    var phi_962_: bool;
    var phi_963_: bool;
    var phi_964_: bool;
    var phi_971_: u32;
    var phi_972_: u32;
    var phi_973_: u32;
    var phi_974_: u32;
    var phi_975_: u32;
    var phi_976_: u32;
    var phi_977_: u32;
    var phi_989_: bool;
    var phi_990_: bool;
    var phi_991_: bool;
    var phi_992_: bool;
    var phi_996_: bool;
    var phi_1002_: bool;
    var phi_1010_: u32;
    var phi_1015_: u32;
    var phi_1024_: u32;
    var phi_1029_: u32;
    var phi_1033_: u32;
    var phi_1034_: u32;
    var phi_1035_: u32;
    var phi_1039_: f32;
    var phi_1041_: mask_Masked;
    var phi_1113_: bool;
    var phi_1114_: bool;
    var phi_1115_: bool;
    var phi_1116_: bool;
    var phi_1120_: bool;
    var phi_1148_: f32;
    var phi_1151_: bool;
    var phi_1152_: u32;
    var phi_1163_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e48 = id_1;
    let _e49 = local_2;
    let _e54 = arrayLength((&last_bits.member));
    let _e65 = p.member.current.size[0u];
    let _e67 = p.member.current.size[1u];
    let _e68 = lt_shaders_entry_pixel_index(_e48, _e65, _e67);
    if (bitcast<i32>(_e68.word) != 0i) {
        let _e75 = p.member.light.number;
        let _e76 = (_e75 * 3u);
        let _e80 = p.member.light.mask_words;
        let _e86 = mask_BitsPlace(lt_mask_LightPlace((_e76 / 32u), mask_BitsPlace().light.shift), mask_BitsPlace().words);
        let _e92 = mask_BitsPlace(lt_mask_LightPlace(_e86.light.word, (_e76 % 32u)), _e86.words);
        let _e95 = mask_BitsPlace(_e92.light, _e80);
        let _e99 = p.member.current.size[0u];
        let _e102 = samples.member[_e68.shift].position;
        let _e104 = visibility.member[_e68.shift];
        let _e110 = samples.member[_e68.shift].normal[0u];
        let _e112 = global[0u];
        if (_e110 == _e112) {
            let _e115 = samples.member[_e68.shift].normal[1u];
            let _e117 = global[1u];
            if (_e115 == _e117) {
                let _e120 = samples.member[_e68.shift].normal[2u];
                let _e122 = global[2u];
                phi_352_ = (_e120 == _e122);
                phi_353_ = false;
            } else {
                phi_352_ = bool();
                phi_353_ = true;
            }
            let _e125 = phi_352_;
            let _e127 = phi_353_;
            phi_354_ = _e125;
            phi_355_ = _e127;
        } else {
            phi_354_ = bool();
            phi_355_ = true;
        }
        let _e129 = phi_354_;
        let _e131 = phi_355_;
        if _e131 {
            phi_359_ = false;
        } else {
            phi_359_ = _e129;
        }
        let _e133 = phi_359_;
        if !(_e133) {
            let _e136 = samples.member[_e68.shift].position;
            let _e138 = p.member.light.place;
            let _e144 = p.member.light.place[3u];
            let _e151 = (_e138.x - (_e136.x * _e144));
            let _e152 = (_e138.y - (_e136.y * _e144));
            let _e153 = (_e138.z - (_e136.z * _e144));
            let _e155 = samples.member[_e68.shift].normal;
            if ((((_e155.x * _e151) + (_e155.y * _e152)) + (_e155.z * _e153)) > 0f) {
                let _e169 = (((_e151 * _e151) + (_e152 * _e152)) + (_e153 * _e153));
                let _e171 = p.member.light.axis;
                let _e183 = p.member.light.place[3u];
                if (_e183 == 0f) {
                    phi_430_ = true;
                } else {
                    let _e186 = p.member.light.range_squared;
                    if (_e169 <= _e186) {
                        let _e189 = p.member.light.cos_outer;
                        phi_429_ = (-((((_e151 * _e171.x) + (_e152 * _e171.y)) + (_e153 * _e171.z))) >= (_e189 * sqrt(_e169)));
                    } else {
                        phi_429_ = false;
                    }
                    let _e194 = phi_429_;
                    phi_430_ = _e194;
                }
                let _e196 = phi_430_;
                if _e196 {
                    let _e198 = samples.member[_e68.shift].flags;
                    let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e212 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e206.unnamed.visibility, false), _e206.unnamed_1);
                    phi_441_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e212.unnamed, ((_e198 & 1u) == 0u));
                    phi_442_ = false;
                } else {
                    phi_441_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_442_ = true;
                }
                let _e217 = phi_441_;
                let _e219 = phi_442_;
                phi_443_ = _e217;
                phi_444_ = _e219;
            } else {
                phi_443_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_444_ = true;
            }
            let _e221 = phi_443_;
            let _e223 = phi_444_;
            if _e223 {
                let _e229 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e235 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e229.unnamed.visibility, false), _e229.unnamed_1);
                phi_451_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e235.unnamed, true);
            } else {
                phi_451_ = _e221;
            }
            let _e240 = phi_451_;
            phi_455_ = _e240;
        } else {
            let _e246 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e252 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e246.unnamed.visibility, false), _e246.unnamed_1);
            phi_455_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e252.unnamed, true);
        }
        let _e257 = phi_455_;
        if _e257.unnamed_1 {
            phi_1041_ = mask_Masked(_e257.unnamed.visibility, 0u, false);
        } else {
            let _e262 = (_e104 < 0.5f);
            if (_e104 > 0f) {
                phi_468_ = (_e104 < 1f);
            } else {
                phi_468_ = false;
            }
            let _e266 = phi_468_;
            let _e268 = p.member.flags;
            if ((_e268 & 16u) == 0u) {
            } else {
                let _e274 = samples.member[_e68.shift].position[0u];
                if (_e102.x == _e274) {
                    let _e278 = samples.member[_e68.shift].position[1u];
                    if (_e102.y == _e278) {
                    }
                }
            }
            let _e284 = p.member.previous.eye;
            let _e295 = p.member.previous.forward;
            let _e303 = ((((_e102.x - _e284.x) * _e295.x) + ((_e102.y - _e284.y) * _e295.y)) + ((_e102.z - _e284.z) * _e295.z));
            let _e305 = ((_e48.y * _e99) + _e48.x);
            if (_e305 < arrayLength((&last_depths.member))) {
            } else {
                return;
            }
            let _e309 = last_depths.member[(0u + _e305)];
            let _e311 = p.member.depth_tolerance;
            let _e314 = abs(_e303);
            let _e315 = abs(_e309);
            if ((bitcast<u32>(_e315) & 2147483647u) > 2139095040u) {
                phi_548_ = true;
            } else {
                let _e319 = (_e315 > _e314);
                if _e319 {
                }
                phi_548_ = _e319;
            }
            let _e321 = phi_548_;
            if _e321 {
                phi_552_ = _e315;
            } else {
                phi_552_ = _e314;
            }
            let _e323 = phi_552_;
            if (abs((_e303 - _e309)) <= (_e311 * _e323)) {
                let _e327 = p.member.flags;
                phi_563_ = ((_e327 & 1u) != 0u);
            } else {
                phi_563_ = false;
            }
            let _e331 = phi_563_;
            let _e332 = lt_mask_Neighbourhood(false, true);
            if _e266 {
                phi_569_ = false;
            } else {
                phi_569_ = true;
            }
            let _e334 = phi_569_;
            if _e334 {
                if _e331 {
                    if ((0u & 2u) != 0u) {
                        phi_863_ = _e332;
                    } else {
                        let _e338 = p.member.expansion;
                        if false {
                            let _e340 = p.member.moving_pattern;
                            phi_590_ = _e340;
                        } else {
                            let _e342 = p.member.still_pattern;
                            phi_590_ = _e342;
                        }
                        let _e344 = phi_590_;
                        phi_592_ = 0u;
                        phi_595_ = _e332;
                        loop {
                            let _e346 = phi_592_;
                            let _e348 = phi_595_;
                            local_1 = _e348;
                            if (1u <= _e344) {
                                if (_e344 <= 4u) {
                                    phi_607_ = false;
                                } else {
                                    phi_607_ = true;
                                }
                                let _e352 = phi_607_;
                                phi_608_ = _e352;
                            } else {
                                phi_608_ = true;
                            }
                            let _e354 = phi_608_;
                            if _e354 {
                                switch bitcast<i32>(_e344) {
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
                                let _e357 = phi_617_;
                                phi_618_ = _e357;
                            } else {
                                phi_618_ = 5u;
                            }
                            let _e359 = phi_618_;
                            let _e360 = (_e346 < _e359);
                            if _e360 {
                                let _e362 = p.member.frame;
                                let _e366 = p.member.current.size[0u];
                                let _e368 = p.member.current.size[1u];
                                switch bitcast<i32>(_e344) {
                                    case 1: {
                                        let _e378 = lt_mask_pattern_plus(_e346);
                                        phi_698_ = vec2<i32>(_e378.x, _e378.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e382 = lt_mask_pattern_cross(_e346);
                                        phi_698_ = vec2<i32>(_e382.x, _e382.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e388 = lt_mask_pattern_plus_or_cross(_e346, ((_e48.x + _e48.y) & 1u));
                                        phi_698_ = vec2<i32>(_e388.x, _e388.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e393 = lt_mask_pattern_plus_or_cross(_e346, (_e362 & 1u));
                                        phi_698_ = vec2<i32>(_e393.x, _e393.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e362 & 3u)) {
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
                                        let _e404 = phi_678_;
                                        phi_698_ = (_e404 + vec2<i32>(bitcast<i32>((_e346 & 1u)), bitcast<i32>(((_e346 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_698_ = vec2<i32>((bitcast<i32>((_e346 % 5u)) - 2i), (bitcast<i32>(((_e346 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e421 = lt_mask_pattern_diamond(_e346);
                                        phi_698_ = vec2<i32>(_e421.x, _e421.y);
                                        break;
                                    }
                                    default: {
                                        phi_698_ = vec2<i32>((bitcast<i32>((_e346 % 3u)) - 1i), (bitcast<i32>(((_e346 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e426 = phi_698_;
                                let _e429 = lt_mask_pattern_step_clamped(_e48.x, _e426.x, _e366);
                                let _e430 = lt_mask_pattern_step_clamped(_e48.y, _e426.y, _e368);
                                let _e437 = ((((_e430 * _e99) + _e429) * _e95.words) + _e95.light.word);
                                if (_e95.light.shift > 29u) {
                                    let _e441 = (_e437 + 1u);
                                    if (_e441 < _e54) {
                                    } else {
                                        return;
                                    }
                                    let _e445 = last_bits.member[(0u + _e441)];
                                    phi_725_ = _e445;
                                } else {
                                    phi_725_ = 0u;
                                }
                                let _e447 = phi_725_;
                                if (_e437 < _e54) {
                                } else {
                                    return;
                                }
                                let _e453 = last_bits.member[(0u + _e437)];
                                let _e456 = (_e453 >> bitcast<u32>((_e95.light.shift & 31u)));
                                if (_e95.light.shift > 29u) {
                                    phi_744_ = (_e456 | (_e447 << bitcast<u32>(((32u - _e95.light.shift) & 31u))));
                                } else {
                                    phi_744_ = _e456;
                                }
                                let _e464 = phi_744_;
                                if ((_e464 & 2u) == 0u) {
                                    phi_752_ = (_e464 & 1u);
                                } else {
                                    phi_752_ = (_e464 & 7u);
                                }
                                let _e470 = phi_752_;
                                if _e348.any_expands {
                                    phi_840_ = true;
                                } else {
                                    if ((_e470 & 2u) != 0u) {
                                        let _e477 = (((_e470 & 4u) != 0u) != _e262);
                                        switch bitcast<i32>(_e338) {
                                            case 1: {
                                                phi_780_ = bool();
                                                phi_781_ = false;
                                                phi_782_ = true;
                                                phi_783_ = false;
                                                phi_784_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e477 {
                                                    phi_778_ = (((_e470 & 4u) != 0u) != ((_e470 & 1u) != 0u));
                                                    phi_779_ = false;
                                                } else {
                                                    phi_778_ = bool();
                                                    phi_779_ = true;
                                                }
                                                let _e485 = phi_778_;
                                                let _e487 = phi_779_;
                                                phi_780_ = _e485;
                                                phi_781_ = false;
                                                phi_782_ = false;
                                                phi_783_ = _e487;
                                                phi_784_ = _e477;
                                                break;
                                            }
                                            default: {
                                                phi_780_ = bool();
                                                phi_781_ = true;
                                                phi_782_ = false;
                                                phi_783_ = false;
                                                phi_784_ = false;
                                                break;
                                            }
                                        }
                                        let _e489 = phi_780_;
                                        let _e491 = phi_781_;
                                        let _e493 = phi_782_;
                                        let _e495 = phi_783_;
                                        let _e497 = phi_784_;
                                        phi_792_ = _e477;
                                        phi_793_ = _e489;
                                        phi_794_ = _e491;
                                        phi_795_ = _e493;
                                        phi_796_ = _e495;
                                        phi_797_ = _e497;
                                    } else {
                                        switch bitcast<i32>(_e338) {
                                            case 1: {
                                                phi_789_ = false;
                                                phi_790_ = true;
                                                phi_791_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_789_ = false;
                                                phi_790_ = false;
                                                phi_791_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_789_ = true;
                                                phi_790_ = false;
                                                phi_791_ = false;
                                                break;
                                            }
                                        }
                                        let _e500 = phi_789_;
                                        let _e502 = phi_790_;
                                        let _e504 = phi_791_;
                                        phi_792_ = false;
                                        phi_793_ = bool();
                                        phi_794_ = _e500;
                                        phi_795_ = _e502;
                                        phi_796_ = _e504;
                                        phi_797_ = false;
                                    }
                                    let _e506 = phi_792_;
                                    let _e508 = phi_793_;
                                    let _e510 = phi_794_;
                                    let _e512 = phi_795_;
                                    let _e514 = phi_796_;
                                    let _e516 = phi_797_;
                                    if _e510 {
                                        if ((_e470 & 2u) != 0u) {
                                            if (((_e470 & 4u) != 0u) != _e262) {
                                                phi_812_ = false;
                                            } else {
                                                phi_812_ = true;
                                            }
                                            let _e523 = phi_812_;
                                            phi_813_ = _e523;
                                        } else {
                                            phi_813_ = true;
                                        }
                                        let _e525 = phi_813_;
                                        if _e525 {
                                            phi_820_ = (((_e470 & 1u) != 0u) != _e262);
                                        } else {
                                            phi_820_ = true;
                                        }
                                        let _e530 = phi_820_;
                                        phi_821_ = _e530;
                                        phi_822_ = false;
                                        phi_823_ = false;
                                        phi_824_ = false;
                                    } else {
                                        phi_821_ = bool();
                                        phi_822_ = _e512;
                                        phi_823_ = _e514;
                                        phi_824_ = _e516;
                                    }
                                    let _e532 = phi_821_;
                                    let _e534 = phi_822_;
                                    let _e536 = phi_823_;
                                    let _e538 = phi_824_;
                                    if _e534 {
                                        phi_828_ = _e506;
                                        phi_829_ = false;
                                        phi_830_ = false;
                                    } else {
                                        phi_828_ = _e532;
                                        phi_829_ = _e536;
                                        phi_830_ = _e538;
                                    }
                                    let _e540 = phi_828_;
                                    let _e542 = phi_829_;
                                    let _e544 = phi_830_;
                                    if _e542 {
                                        phi_834_ = false;
                                        phi_835_ = true;
                                    } else {
                                        phi_834_ = _e508;
                                        phi_835_ = _e544;
                                    }
                                    let _e546 = phi_834_;
                                    let _e548 = phi_835_;
                                    if _e548 {
                                        phi_839_ = _e546;
                                    } else {
                                        phi_839_ = _e540;
                                    }
                                    let _e550 = phi_839_;
                                    phi_840_ = _e550;
                                }
                                let _e552 = phi_840_;
                                if _e348.all_remove {
                                    if (((_e470 & 1u) != 0u) == _e262) {
                                        if ((_e470 & 2u) != 0u) {
                                            phi_858_ = (((_e470 & 4u) != 0u) == _e262);
                                        } else {
                                            phi_858_ = true;
                                        }
                                        let _e562 = phi_858_;
                                        phi_859_ = _e562;
                                    } else {
                                        phi_859_ = false;
                                    }
                                    let _e564 = phi_859_;
                                    phi_860_ = _e564;
                                } else {
                                    phi_860_ = false;
                                }
                                let _e566 = phi_860_;
                                phi_593_ = (_e346 + 1u);
                                phi_596_ = lt_mask_Neighbourhood(_e552, _e566);
                            } else {
                                phi_593_ = u32();
                                phi_596_ = lt_mask_Neighbourhood();
                            }
                            let _e570 = phi_593_;
                            let _e572 = phi_596_;
                            continue;
                            continuing {
                                phi_592_ = _e570;
                                phi_595_ = _e572;
                                break if !(_e360);
                            }
                        }
                        let _e867 = local_1;
                        phi_863_ = _e867;
                    }
                    let _e575 = phi_863_;
                    phi_864_ = _e575;
                } else {
                    phi_864_ = _e332;
                }
                let _e577 = phi_864_;
                phi_865_ = _e577;
            } else {
                phi_865_ = _e332;
            }
            let _e579 = phi_865_;
            let _e582 = p.member.frame;
            let _e584 = p.member.refresh;
            if (_e584 == 0u) {
                phi_898_ = false;
            } else {
                if (_e584 == 0u) {
                    return;
                }
                let _e593 = ((_e48.x + (_e48.y * (((_e584 * 5u) / 8u) | 1u))) + (_e582 % _e584));
                if (_e584 == 0u) {
                    phi_897_ = (_e593 == 0u);
                } else {
                    if (_e584 == 0u) {
                        return;
                    }
                    phi_897_ = ((_e593 % _e584) == 0u);
                }
                let _e600 = phi_897_;
                phi_898_ = _e600;
            }
            let _e602 = phi_898_;
            if _e331 {
                if _e602 {
                    phi_920_ = bool();
                } else {
                    phi_920_ = ((0u & 2u) != 0u);
                }
                let _e608 = phi_920_;
                phi_921_ = _e608;
                phi_922_ = _e602;
            } else {
                phi_921_ = bool();
                phi_922_ = true;
            }
            let _e610 = phi_921_;
            let _e612 = phi_922_;
            if _e612 {
                phi_926_ = false;
            } else {
                phi_926_ = _e610;
            }
            let _e614 = phi_926_;
            if _e614 {
                phi_977_ = 7u;
            } else {
                if (_e104 != 0.5f) {
                    if _e331 {
                        if _e602 {
                            phi_974_ = 6u;
                        } else {
                            if _e266 {
                                phi_949_ = true;
                            } else {
                                if _e579.any_expands {
                                    phi_948_ = false;
                                } else {
                                    phi_948_ = true;
                                }
                                let _e616 = phi_948_;
                                phi_949_ = _e616;
                            }
                            let _e618 = phi_949_;
                            if _e618 {
                                if _e266 {
                                    if false {
                                        if _e579.all_remove {
                                            phi_962_ = false;
                                        } else {
                                            phi_962_ = true;
                                        }
                                        let _e620 = phi_962_;
                                        phi_963_ = _e620;
                                    } else {
                                        phi_963_ = true;
                                    }
                                    let _e622 = phi_963_;
                                    phi_964_ = _e622;
                                } else {
                                    phi_964_ = true;
                                }
                                let _e624 = phi_964_;
                                if _e624 {
                                    if _e266 {
                                        phi_971_ = 1u;
                                    } else {
                                        phi_971_ = 0u;
                                    }
                                    let _e626 = phi_971_;
                                    phi_972_ = _e626;
                                } else {
                                    phi_972_ = 5u;
                                }
                                let _e628 = phi_972_;
                                phi_973_ = _e628;
                            } else {
                                phi_973_ = 4u;
                            }
                            let _e630 = phi_973_;
                            phi_974_ = _e630;
                        }
                        let _e632 = phi_974_;
                        phi_975_ = _e632;
                    } else {
                        phi_975_ = 3u;
                    }
                    let _e634 = phi_975_;
                    phi_976_ = _e634;
                } else {
                    phi_976_ = 2u;
                }
                let _e636 = phi_976_;
                phi_977_ = _e636;
            }
            let _e638 = phi_977_;
            if !((_e638 == 0u)) {
                if !((_e638 == 5u)) {
                    phi_989_ = !(_e614);
                    phi_990_ = false;
                } else {
                    phi_989_ = bool();
                    phi_990_ = true;
                }
                let _e645 = phi_989_;
                let _e647 = phi_990_;
                phi_991_ = _e645;
                phi_992_ = _e647;
            } else {
                phi_991_ = bool();
                phi_992_ = true;
            }
            let _e649 = phi_991_;
            let _e651 = phi_992_;
            if _e651 {
                phi_996_ = false;
            } else {
                phi_996_ = _e649;
            }
            let _e653 = phi_996_;
            if _e614 {
                phi_1002_ = ((0u & 4u) != 0u);
            } else {
                phi_1002_ = _e262;
            }
            let _e657 = phi_1002_;
            if _e653 {
                if _e262 {
                    phi_1010_ = (2u | 1u);
                } else {
                    phi_1010_ = 2u;
                }
                let _e660 = phi_1010_;
                if false {
                    phi_1015_ = (_e660 | 4u);
                } else {
                    phi_1015_ = _e660;
                }
                let _e663 = phi_1015_;
                phi_1035_ = _e663;
            } else {
                if (_e638 == 7u) {
                    if _e262 {
                        phi_1024_ = (2u | 1u);
                    } else {
                        phi_1024_ = 2u;
                    }
                    let _e667 = phi_1024_;
                    if _e657 {
                        phi_1029_ = (_e667 | 4u);
                    } else {
                        phi_1029_ = _e667;
                    }
                    let _e670 = phi_1029_;
                    phi_1034_ = _e670;
                } else {
                    if _e262 {
                        phi_1033_ = 1u;
                    } else {
                        phi_1033_ = 0u;
                    }
                    let _e672 = phi_1033_;
                    phi_1034_ = _e672;
                }
                let _e674 = phi_1034_;
                phi_1035_ = _e674;
            }
            let _e676 = phi_1035_;
            if _e657 {
                phi_1039_ = 0f;
            } else {
                phi_1039_ = 1f;
            }
            let _e678 = phi_1039_;
            phi_1041_ = mask_Masked(_e678, _e676, _e653);
        }
        let _e681 = phi_1041_;
        visibility.member[_e68.shift] = _e681.visibility;
        let _e686 = p.member.light.number;
        let _e687 = (_e686 * 3u);
        let _e689 = (_e687 % 32u);
        let _e691 = p.member.light.mask_words;
        let _e693 = ((_e68.shift * _e691) + (_e687 / 32u));
        let _e695 = bits.member[_e693];
        bits.member[_e693] = ((_e695 & ~((7u << bitcast<u32>((_e689 & 31u))))) | (_e681.bits << bitcast<u32>((_e689 & 31u))));
        if (_e689 > 29u) {
            let _e710 = bits.member[(_e693 + 1u)];
            let _e712 = (32u - _e689);
            bits.member[(_e693 + 1u)] = ((_e710 & ~((7u >> bitcast<u32>((_e712 & 31u))))) | (_e681.bits >> bitcast<u32>((_e712 & 31u))));
        }
        let _e727 = samples.member[_e68.shift].normal[0u];
        let _e729 = global[0u];
        if (_e727 == _e729) {
            let _e732 = samples.member[_e68.shift].normal[1u];
            let _e734 = global[1u];
            if (_e732 == _e734) {
                let _e737 = samples.member[_e68.shift].normal[2u];
                let _e739 = global[2u];
                phi_1113_ = (_e737 == _e739);
                phi_1114_ = false;
            } else {
                phi_1113_ = bool();
                phi_1114_ = true;
            }
            let _e742 = phi_1113_;
            let _e744 = phi_1114_;
            phi_1115_ = _e742;
            phi_1116_ = _e744;
        } else {
            phi_1115_ = bool();
            phi_1116_ = true;
        }
        let _e746 = phi_1115_;
        let _e748 = phi_1116_;
        if _e748 {
            phi_1120_ = false;
        } else {
            phi_1120_ = _e746;
        }
        let _e750 = phi_1120_;
        if !(_e750) {
            let _e753 = samples.member[_e68.shift].position;
            let _e755 = p.member.current.eye;
            let _e766 = p.member.current.forward;
            phi_1148_ = ((((_e753.x - _e755.x) * _e766.x) + ((_e753.y - _e755.y) * _e766.y)) + ((_e753.z - _e755.z) * _e766.z));
        } else {
            phi_1148_ = 0f;
        }
        let _e776 = phi_1148_;
        depths.member[_e68.shift] = _e776;
        phi_1151_ = _e681.needs_ray;
        phi_1152_ = _e68.shift;
    } else {
        phi_1151_ = false;
        phi_1152_ = 0u;
    }
    let _e780 = phi_1151_;
    let _e782 = phi_1152_;
    if (_e49 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e780 {
        let _e786 = atomicAdd((&shared_[0u]), 1u);
        phi_1163_ = _e786;
    } else {
        phi_1163_ = 0u;
    }
    let _e788 = phi_1163_;
    workgroupBarrier();
    if (_e49 == 0u) {
        let _e792 = atomicLoad((&shared_[0u]));
        let _e793 = atomicAdd((&list.member[3u]), _e792);
        atomicStore((&shared_[1u]), _e793);
    }
    workgroupBarrier();
    if _e780 {
        let _e796 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e796) + _e788)]), _e782);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
