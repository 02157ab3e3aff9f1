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
    var phi_605_: u32;
    var phi_624_: u32;
    var phi_632_: u32;
    var phi_633_: u32;
    var phi_634_: bool;
    var phi_635_: u32;
    var phi_636_: bool;
    var phi_637_: bool;
    var phi_638_: u32;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_644_: bool;
    var phi_648_: u32;
    var phi_653_: bool;
    var phi_674_: u32;
    var phi_676_: u32;
    var phi_679_: lt_mask_Neighbourhood;
    var phi_691_: bool;
    var phi_692_: bool;
    var phi_701_: u32;
    var phi_702_: u32;
    var phi_762_: vec2<i32>;
    var phi_782_: vec2<i32>;
    var phi_809_: u32;
    var phi_828_: u32;
    var phi_836_: u32;
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_865_: bool;
    var phi_866_: bool;
    var phi_867_: bool;
    var phi_868_: bool;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_878_: bool;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_896_: bool;
    var phi_897_: bool;
    var phi_904_: bool;
    var phi_905_: bool;
    var phi_906_: bool;
    var phi_907_: bool;
    var phi_908_: bool;
    var phi_912_: bool;
    var phi_913_: bool;
    var phi_914_: bool;
    var phi_918_: bool;
    var phi_919_: bool;
    var phi_923_: bool;
    var phi_924_: bool;
    var phi_942_: bool;
    var phi_943_: bool;
    var phi_944_: bool;
    var phi_677_: u32;
    var phi_680_: lt_mask_Neighbourhood;
    var phi_947_: lt_mask_Neighbourhood;
    var phi_948_: lt_mask_Neighbourhood;
    var phi_949_: lt_mask_Neighbourhood;
    var phi_981_: bool;
    var phi_982_: bool;
    var phi_1004_: bool;
    var phi_1005_: bool;
    var phi_1006_: bool;
    var phi_1010_: bool;
    var phi_1032_: bool;
    var phi_1033_: bool;
    var phi_1046_: bool;
    var phi_1047_: bool;
    var phi_1048_: bool;
    var phi_1055_: u32;
    var phi_1056_: u32;
    var phi_1057_: u32;
    var phi_1058_: u32;
    var phi_1059_: u32;
    var phi_1060_: u32;
    var phi_1061_: u32;
    var phi_1073_: bool;
    var phi_1074_: bool;
    var phi_1075_: bool;
    var phi_1076_: bool;
    var phi_1080_: bool;
    var phi_1086_: bool;
    var phi_1094_: u32;
    var phi_1099_: u32;
    var phi_1108_: u32;
    var phi_1113_: u32;
    var phi_1117_: u32;
    var phi_1118_: u32;
    var phi_1119_: u32;
    var phi_1123_: f32;
    var phi_1125_: mask_Masked;
    var phi_1197_: bool;
    var phi_1198_: bool;
    var phi_1199_: bool;
    var phi_1200_: bool;
    var phi_1204_: bool;
    var phi_1232_: f32;
    var phi_1235_: bool;
    var phi_1236_: u32;
    var phi_1247_: u32;
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
            phi_1125_ = mask_Masked(_e257.unnamed.visibility, 0u, false);
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
            let _e333 = p.member.flags;
            let _e335 = ((_e333 & 2u) != 0u);
            let _e337 = p.member.flags;
            if ((_e337 & 4u) == 0u) {
                phi_638_ = u32();
                phi_639_ = true;
                phi_640_ = false;
            } else {
                if _e331 {
                    if !(false) {
                        let _e347 = ((((_e48.y * _e99) + _e48.x) * _e95.words) + _e95.light.word);
                        if (_e95.light.shift > 29u) {
                            let _e351 = (_e347 + 1u);
                            if (_e351 < _e54) {
                            } else {
                                return;
                            }
                            let _e355 = last_bits.member[(0u + _e351)];
                            phi_605_ = _e355;
                        } else {
                            phi_605_ = 0u;
                        }
                        let _e357 = phi_605_;
                        if (_e347 < _e54) {
                        } else {
                            return;
                        }
                        let _e363 = last_bits.member[(0u + _e347)];
                        let _e366 = (_e363 >> bitcast<u32>((_e95.light.shift & 31u)));
                        if (_e95.light.shift > 29u) {
                            phi_624_ = (_e366 | (_e357 << bitcast<u32>(((32u - _e95.light.shift) & 31u))));
                        } else {
                            phi_624_ = _e366;
                        }
                        let _e374 = phi_624_;
                        if ((_e374 & 2u) == 0u) {
                            phi_632_ = (_e374 & 1u);
                        } else {
                            phi_632_ = (_e374 & 7u);
                        }
                        let _e380 = phi_632_;
                        phi_633_ = _e380;
                        phi_634_ = false;
                    } else {
                        phi_633_ = u32();
                        phi_634_ = true;
                    }
                    let _e382 = phi_633_;
                    let _e384 = phi_634_;
                    phi_635_ = _e382;
                    phi_636_ = false;
                    phi_637_ = _e384;
                } else {
                    phi_635_ = u32();
                    phi_636_ = true;
                    phi_637_ = false;
                }
                let _e386 = phi_635_;
                let _e388 = phi_636_;
                let _e390 = phi_637_;
                phi_638_ = _e386;
                phi_639_ = _e388;
                phi_640_ = _e390;
            }
            let _e392 = phi_638_;
            let _e394 = phi_639_;
            let _e396 = phi_640_;
            if _e394 {
                phi_644_ = true;
            } else {
                phi_644_ = _e396;
            }
            let _e398 = phi_644_;
            if _e398 {
                phi_648_ = 0u;
            } else {
                phi_648_ = _e392;
            }
            let _e400 = phi_648_;
            let _e401 = lt_mask_Neighbourhood(false, true);
            if _e266 {
                phi_653_ = _e335;
            } else {
                phi_653_ = false;
            }
            let _e403 = phi_653_;
            if _e403 {
                if _e331 {
                    if ((_e400 & 2u) != 0u) {
                        phi_947_ = _e401;
                    } else {
                        let _e407 = p.member.expansion;
                        if false {
                            let _e409 = p.member.moving_pattern;
                            phi_674_ = _e409;
                        } else {
                            let _e411 = p.member.still_pattern;
                            phi_674_ = _e411;
                        }
                        let _e413 = phi_674_;
                        phi_676_ = 0u;
                        phi_679_ = _e401;
                        loop {
                            let _e415 = phi_676_;
                            let _e417 = phi_679_;
                            local_1 = _e417;
                            if (1u <= _e413) {
                                if (_e413 <= 4u) {
                                    phi_691_ = false;
                                } else {
                                    phi_691_ = true;
                                }
                                let _e421 = phi_691_;
                                phi_692_ = _e421;
                            } else {
                                phi_692_ = true;
                            }
                            let _e423 = phi_692_;
                            if _e423 {
                                switch bitcast<i32>(_e413) {
                                    case 5: {
                                        phi_701_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_701_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_701_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_701_ = 9u;
                                        break;
                                    }
                                }
                                let _e426 = phi_701_;
                                phi_702_ = _e426;
                            } else {
                                phi_702_ = 5u;
                            }
                            let _e428 = phi_702_;
                            let _e429 = (_e415 < _e428);
                            if _e429 {
                                let _e431 = p.member.frame;
                                let _e435 = p.member.current.size[0u];
                                let _e437 = p.member.current.size[1u];
                                switch bitcast<i32>(_e413) {
                                    case 1: {
                                        let _e447 = lt_mask_pattern_plus(_e415);
                                        phi_782_ = vec2<i32>(_e447.x, _e447.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e451 = lt_mask_pattern_cross(_e415);
                                        phi_782_ = vec2<i32>(_e451.x, _e451.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e457 = lt_mask_pattern_plus_or_cross(_e415, ((_e48.x + _e48.y) & 1u));
                                        phi_782_ = vec2<i32>(_e457.x, _e457.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e462 = lt_mask_pattern_plus_or_cross(_e415, (_e431 & 1u));
                                        phi_782_ = vec2<i32>(_e462.x, _e462.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e431 & 3u)) {
                                            case 0: {
                                                phi_762_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_762_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_762_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_762_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e473 = phi_762_;
                                        phi_782_ = (_e473 + vec2<i32>(bitcast<i32>((_e415 & 1u)), bitcast<i32>(((_e415 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_782_ = vec2<i32>((bitcast<i32>((_e415 % 5u)) - 2i), (bitcast<i32>(((_e415 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e490 = lt_mask_pattern_diamond(_e415);
                                        phi_782_ = vec2<i32>(_e490.x, _e490.y);
                                        break;
                                    }
                                    default: {
                                        phi_782_ = vec2<i32>((bitcast<i32>((_e415 % 3u)) - 1i), (bitcast<i32>(((_e415 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e495 = phi_782_;
                                let _e498 = lt_mask_pattern_step_clamped(_e48.x, _e495.x, _e435);
                                let _e499 = lt_mask_pattern_step_clamped(_e48.y, _e495.y, _e437);
                                let _e506 = ((((_e499 * _e99) + _e498) * _e95.words) + _e95.light.word);
                                if (_e95.light.shift > 29u) {
                                    let _e510 = (_e506 + 1u);
                                    if (_e510 < _e54) {
                                    } else {
                                        return;
                                    }
                                    let _e514 = last_bits.member[(0u + _e510)];
                                    phi_809_ = _e514;
                                } else {
                                    phi_809_ = 0u;
                                }
                                let _e516 = phi_809_;
                                if (_e506 < _e54) {
                                } else {
                                    return;
                                }
                                let _e522 = last_bits.member[(0u + _e506)];
                                let _e525 = (_e522 >> bitcast<u32>((_e95.light.shift & 31u)));
                                if (_e95.light.shift > 29u) {
                                    phi_828_ = (_e525 | (_e516 << bitcast<u32>(((32u - _e95.light.shift) & 31u))));
                                } else {
                                    phi_828_ = _e525;
                                }
                                let _e533 = phi_828_;
                                if ((_e533 & 2u) == 0u) {
                                    phi_836_ = (_e533 & 1u);
                                } else {
                                    phi_836_ = (_e533 & 7u);
                                }
                                let _e539 = phi_836_;
                                if _e417.any_expands {
                                    phi_924_ = true;
                                } else {
                                    if ((_e539 & 2u) != 0u) {
                                        let _e546 = (((_e539 & 4u) != 0u) != _e262);
                                        switch bitcast<i32>(_e407) {
                                            case 1: {
                                                phi_864_ = bool();
                                                phi_865_ = false;
                                                phi_866_ = true;
                                                phi_867_ = false;
                                                phi_868_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e546 {
                                                    phi_862_ = (((_e539 & 4u) != 0u) != ((_e539 & 1u) != 0u));
                                                    phi_863_ = false;
                                                } else {
                                                    phi_862_ = bool();
                                                    phi_863_ = true;
                                                }
                                                let _e554 = phi_862_;
                                                let _e556 = phi_863_;
                                                phi_864_ = _e554;
                                                phi_865_ = false;
                                                phi_866_ = false;
                                                phi_867_ = _e556;
                                                phi_868_ = _e546;
                                                break;
                                            }
                                            default: {
                                                phi_864_ = bool();
                                                phi_865_ = true;
                                                phi_866_ = false;
                                                phi_867_ = false;
                                                phi_868_ = false;
                                                break;
                                            }
                                        }
                                        let _e558 = phi_864_;
                                        let _e560 = phi_865_;
                                        let _e562 = phi_866_;
                                        let _e564 = phi_867_;
                                        let _e566 = phi_868_;
                                        phi_876_ = _e546;
                                        phi_877_ = _e558;
                                        phi_878_ = _e560;
                                        phi_879_ = _e562;
                                        phi_880_ = _e564;
                                        phi_881_ = _e566;
                                    } else {
                                        switch bitcast<i32>(_e407) {
                                            case 1: {
                                                phi_873_ = false;
                                                phi_874_ = true;
                                                phi_875_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_873_ = false;
                                                phi_874_ = false;
                                                phi_875_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_873_ = true;
                                                phi_874_ = false;
                                                phi_875_ = false;
                                                break;
                                            }
                                        }
                                        let _e569 = phi_873_;
                                        let _e571 = phi_874_;
                                        let _e573 = phi_875_;
                                        phi_876_ = false;
                                        phi_877_ = bool();
                                        phi_878_ = _e569;
                                        phi_879_ = _e571;
                                        phi_880_ = _e573;
                                        phi_881_ = false;
                                    }
                                    let _e575 = phi_876_;
                                    let _e577 = phi_877_;
                                    let _e579 = phi_878_;
                                    let _e581 = phi_879_;
                                    let _e583 = phi_880_;
                                    let _e585 = phi_881_;
                                    if _e579 {
                                        if ((_e539 & 2u) != 0u) {
                                            if (((_e539 & 4u) != 0u) != _e262) {
                                                phi_896_ = false;
                                            } else {
                                                phi_896_ = true;
                                            }
                                            let _e592 = phi_896_;
                                            phi_897_ = _e592;
                                        } else {
                                            phi_897_ = true;
                                        }
                                        let _e594 = phi_897_;
                                        if _e594 {
                                            phi_904_ = (((_e539 & 1u) != 0u) != _e262);
                                        } else {
                                            phi_904_ = true;
                                        }
                                        let _e599 = phi_904_;
                                        phi_905_ = _e599;
                                        phi_906_ = false;
                                        phi_907_ = false;
                                        phi_908_ = false;
                                    } else {
                                        phi_905_ = bool();
                                        phi_906_ = _e581;
                                        phi_907_ = _e583;
                                        phi_908_ = _e585;
                                    }
                                    let _e601 = phi_905_;
                                    let _e603 = phi_906_;
                                    let _e605 = phi_907_;
                                    let _e607 = phi_908_;
                                    if _e603 {
                                        phi_912_ = _e575;
                                        phi_913_ = false;
                                        phi_914_ = false;
                                    } else {
                                        phi_912_ = _e601;
                                        phi_913_ = _e605;
                                        phi_914_ = _e607;
                                    }
                                    let _e609 = phi_912_;
                                    let _e611 = phi_913_;
                                    let _e613 = phi_914_;
                                    if _e611 {
                                        phi_918_ = false;
                                        phi_919_ = true;
                                    } else {
                                        phi_918_ = _e577;
                                        phi_919_ = _e613;
                                    }
                                    let _e615 = phi_918_;
                                    let _e617 = phi_919_;
                                    if _e617 {
                                        phi_923_ = _e615;
                                    } else {
                                        phi_923_ = _e609;
                                    }
                                    let _e619 = phi_923_;
                                    phi_924_ = _e619;
                                }
                                let _e621 = phi_924_;
                                if _e417.all_remove {
                                    if (((_e539 & 1u) != 0u) == _e262) {
                                        if ((_e539 & 2u) != 0u) {
                                            phi_942_ = (((_e539 & 4u) != 0u) == _e262);
                                        } else {
                                            phi_942_ = true;
                                        }
                                        let _e631 = phi_942_;
                                        phi_943_ = _e631;
                                    } else {
                                        phi_943_ = false;
                                    }
                                    let _e633 = phi_943_;
                                    phi_944_ = _e633;
                                } else {
                                    phi_944_ = false;
                                }
                                let _e635 = phi_944_;
                                phi_677_ = (_e415 + 1u);
                                phi_680_ = lt_mask_Neighbourhood(_e621, _e635);
                            } else {
                                phi_677_ = u32();
                                phi_680_ = lt_mask_Neighbourhood();
                            }
                            let _e639 = phi_677_;
                            let _e641 = phi_680_;
                            continue;
                            continuing {
                                phi_676_ = _e639;
                                phi_679_ = _e641;
                                break if !(_e429);
                            }
                        }
                        let _e949 = local_1;
                        phi_947_ = _e949;
                    }
                    let _e644 = phi_947_;
                    phi_948_ = _e644;
                } else {
                    phi_948_ = _e401;
                }
                let _e646 = phi_948_;
                phi_949_ = _e646;
            } else {
                phi_949_ = _e401;
            }
            let _e648 = phi_949_;
            let _e651 = p.member.frame;
            let _e653 = p.member.refresh;
            if (_e653 == 0u) {
                phi_982_ = false;
            } else {
                if (_e653 == 0u) {
                    return;
                }
                let _e662 = ((_e48.x + (_e48.y * (((_e653 * 5u) / 8u) | 1u))) + (_e651 % _e653));
                if (_e653 == 0u) {
                    phi_981_ = (_e662 == 0u);
                } else {
                    if (_e653 == 0u) {
                        return;
                    }
                    phi_981_ = ((_e662 % _e653) == 0u);
                }
                let _e669 = phi_981_;
                phi_982_ = _e669;
            }
            let _e671 = phi_982_;
            if _e331 {
                if _e671 {
                    phi_1004_ = bool();
                } else {
                    phi_1004_ = ((_e400 & 2u) != 0u);
                }
                let _e677 = phi_1004_;
                phi_1005_ = _e677;
                phi_1006_ = _e671;
            } else {
                phi_1005_ = bool();
                phi_1006_ = true;
            }
            let _e679 = phi_1005_;
            let _e681 = phi_1006_;
            if _e681 {
                phi_1010_ = false;
            } else {
                phi_1010_ = _e679;
            }
            let _e683 = phi_1010_;
            if _e683 {
                phi_1061_ = 7u;
            } else {
                if (_e104 != 0.5f) {
                    if _e331 {
                        if _e671 {
                            phi_1058_ = 6u;
                        } else {
                            if _e266 {
                                phi_1033_ = true;
                            } else {
                                if _e648.any_expands {
                                    phi_1032_ = false;
                                } else {
                                    phi_1032_ = true;
                                }
                                let _e685 = phi_1032_;
                                phi_1033_ = _e685;
                            }
                            let _e687 = phi_1033_;
                            if _e687 {
                                if _e266 {
                                    if _e335 {
                                        if _e648.all_remove {
                                            phi_1046_ = false;
                                        } else {
                                            phi_1046_ = true;
                                        }
                                        let _e689 = phi_1046_;
                                        phi_1047_ = _e689;
                                    } else {
                                        phi_1047_ = true;
                                    }
                                    let _e691 = phi_1047_;
                                    phi_1048_ = _e691;
                                } else {
                                    phi_1048_ = true;
                                }
                                let _e693 = phi_1048_;
                                if _e693 {
                                    if _e266 {
                                        phi_1055_ = 1u;
                                    } else {
                                        phi_1055_ = 0u;
                                    }
                                    let _e695 = phi_1055_;
                                    phi_1056_ = _e695;
                                } else {
                                    phi_1056_ = 5u;
                                }
                                let _e697 = phi_1056_;
                                phi_1057_ = _e697;
                            } else {
                                phi_1057_ = 4u;
                            }
                            let _e699 = phi_1057_;
                            phi_1058_ = _e699;
                        }
                        let _e701 = phi_1058_;
                        phi_1059_ = _e701;
                    } else {
                        phi_1059_ = 3u;
                    }
                    let _e703 = phi_1059_;
                    phi_1060_ = _e703;
                } else {
                    phi_1060_ = 2u;
                }
                let _e705 = phi_1060_;
                phi_1061_ = _e705;
            }
            let _e707 = phi_1061_;
            if !((_e707 == 0u)) {
                if !((_e707 == 5u)) {
                    phi_1073_ = !(_e683);
                    phi_1074_ = false;
                } else {
                    phi_1073_ = bool();
                    phi_1074_ = true;
                }
                let _e714 = phi_1073_;
                let _e716 = phi_1074_;
                phi_1075_ = _e714;
                phi_1076_ = _e716;
            } else {
                phi_1075_ = bool();
                phi_1076_ = true;
            }
            let _e718 = phi_1075_;
            let _e720 = phi_1076_;
            if _e720 {
                phi_1080_ = false;
            } else {
                phi_1080_ = _e718;
            }
            let _e722 = phi_1080_;
            if _e683 {
                phi_1086_ = ((_e400 & 4u) != 0u);
            } else {
                phi_1086_ = _e262;
            }
            let _e726 = phi_1086_;
            if _e722 {
                if _e262 {
                    phi_1094_ = (2u | 1u);
                } else {
                    phi_1094_ = 2u;
                }
                let _e729 = phi_1094_;
                if false {
                    phi_1099_ = (_e729 | 4u);
                } else {
                    phi_1099_ = _e729;
                }
                let _e732 = phi_1099_;
                phi_1119_ = _e732;
            } else {
                if (_e707 == 7u) {
                    if _e262 {
                        phi_1108_ = (2u | 1u);
                    } else {
                        phi_1108_ = 2u;
                    }
                    let _e736 = phi_1108_;
                    if _e726 {
                        phi_1113_ = (_e736 | 4u);
                    } else {
                        phi_1113_ = _e736;
                    }
                    let _e739 = phi_1113_;
                    phi_1118_ = _e739;
                } else {
                    if _e262 {
                        phi_1117_ = 1u;
                    } else {
                        phi_1117_ = 0u;
                    }
                    let _e741 = phi_1117_;
                    phi_1118_ = _e741;
                }
                let _e743 = phi_1118_;
                phi_1119_ = _e743;
            }
            let _e745 = phi_1119_;
            if _e726 {
                phi_1123_ = 0f;
            } else {
                phi_1123_ = 1f;
            }
            let _e747 = phi_1123_;
            phi_1125_ = mask_Masked(_e747, _e745, _e722);
        }
        let _e750 = phi_1125_;
        visibility.member[_e68.shift] = _e750.visibility;
        let _e755 = p.member.light.number;
        let _e756 = (_e755 * 3u);
        let _e758 = (_e756 % 32u);
        let _e760 = p.member.light.mask_words;
        let _e762 = ((_e68.shift * _e760) + (_e756 / 32u));
        let _e764 = bits.member[_e762];
        bits.member[_e762] = ((_e764 & ~((7u << bitcast<u32>((_e758 & 31u))))) | (_e750.bits << bitcast<u32>((_e758 & 31u))));
        if (_e758 > 29u) {
            let _e779 = bits.member[(_e762 + 1u)];
            let _e781 = (32u - _e758);
            bits.member[(_e762 + 1u)] = ((_e779 & ~((7u >> bitcast<u32>((_e781 & 31u))))) | (_e750.bits >> bitcast<u32>((_e781 & 31u))));
        }
        let _e796 = samples.member[_e68.shift].normal[0u];
        let _e798 = global[0u];
        if (_e796 == _e798) {
            let _e801 = samples.member[_e68.shift].normal[1u];
            let _e803 = global[1u];
            if (_e801 == _e803) {
                let _e806 = samples.member[_e68.shift].normal[2u];
                let _e808 = global[2u];
                phi_1197_ = (_e806 == _e808);
                phi_1198_ = false;
            } else {
                phi_1197_ = bool();
                phi_1198_ = true;
            }
            let _e811 = phi_1197_;
            let _e813 = phi_1198_;
            phi_1199_ = _e811;
            phi_1200_ = _e813;
        } else {
            phi_1199_ = bool();
            phi_1200_ = true;
        }
        let _e815 = phi_1199_;
        let _e817 = phi_1200_;
        if _e817 {
            phi_1204_ = false;
        } else {
            phi_1204_ = _e815;
        }
        let _e819 = phi_1204_;
        if !(_e819) {
            let _e822 = samples.member[_e68.shift].position;
            let _e824 = p.member.current.eye;
            let _e835 = p.member.current.forward;
            phi_1232_ = ((((_e822.x - _e824.x) * _e835.x) + ((_e822.y - _e824.y) * _e835.y)) + ((_e822.z - _e824.z) * _e835.z));
        } else {
            phi_1232_ = 0f;
        }
        let _e845 = phi_1232_;
        depths.member[_e68.shift] = _e845;
        phi_1235_ = _e750.needs_ray;
        phi_1236_ = _e68.shift;
    } else {
        phi_1235_ = false;
        phi_1236_ = 0u;
    }
    let _e849 = phi_1235_;
    let _e851 = phi_1236_;
    if (_e49 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e849 {
        let _e855 = atomicAdd((&shared_[0u]), 1u);
        phi_1247_ = _e855;
    } else {
        phi_1247_ = 0u;
    }
    let _e857 = phi_1247_;
    workgroupBarrier();
    if (_e49 == 0u) {
        let _e861 = atomicLoad((&shared_[0u]));
        let _e862 = atomicAdd((&list.member[3u]), _e861);
        atomicStore((&shared_[1u]), _e862);
    }
    workgroupBarrier();
    if _e849 {
        let _e865 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e865) + _e857)]), _e851);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_depth_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
