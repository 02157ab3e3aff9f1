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
    var phi_580_: u32;
    var phi_599_: u32;
    var phi_607_: u32;
    var phi_608_: u32;
    var phi_609_: bool;
    var phi_610_: u32;
    var phi_611_: bool;
    var phi_612_: bool;
    var phi_613_: u32;
    var phi_614_: bool;
    var phi_615_: bool;
    var phi_619_: bool;
    var phi_623_: u32;
    var phi_628_: bool;
    var phi_649_: u32;
    var phi_651_: u32;
    var phi_654_: lt_mask_Neighbourhood;
    var phi_666_: bool;
    var phi_667_: bool;
    var phi_676_: u32;
    var phi_677_: u32;
    var phi_737_: vec2<i32>;
    var phi_757_: vec2<i32>;
    var phi_784_: u32;
    var phi_803_: u32;
    var phi_811_: u32;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_842_: bool;
    var phi_843_: bool;
    var phi_848_: bool;
    var phi_849_: bool;
    var phi_850_: bool;
    var phi_851_: bool;
    var phi_852_: bool;
    var phi_853_: bool;
    var phi_854_: bool;
    var phi_855_: bool;
    var phi_856_: bool;
    var phi_871_: bool;
    var phi_872_: bool;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_887_: bool;
    var phi_888_: bool;
    var phi_889_: bool;
    var phi_893_: bool;
    var phi_894_: bool;
    var phi_898_: bool;
    var phi_899_: bool;
    var phi_917_: bool;
    var phi_918_: bool;
    var phi_919_: bool;
    var phi_652_: u32;
    var phi_655_: lt_mask_Neighbourhood;
    var phi_922_: lt_mask_Neighbourhood;
    var phi_923_: lt_mask_Neighbourhood;
    var phi_924_: lt_mask_Neighbourhood;
    var phi_956_: bool;
    var phi_957_: bool;
    var phi_979_: bool;
    var phi_980_: bool;
    var phi_981_: bool;
    var phi_985_: bool;
    var phi_1007_: bool;
    var phi_1008_: bool;
    var phi_1021_: bool;
    var phi_1022_: bool;
    var phi_1023_: bool;
    var phi_1030_: u32;
    var phi_1031_: u32;
    var phi_1032_: u32;
    var phi_1033_: u32;
    var phi_1034_: u32;
    var phi_1035_: u32;
    var phi_1036_: u32;
    var phi_1048_: bool;
    var phi_1049_: bool;
    var phi_1050_: bool;
    var phi_1051_: bool;
    var phi_1055_: bool;
    var phi_1061_: bool;
    var phi_1069_: u32;
    var phi_1074_: u32;
    var phi_1083_: u32;
    var phi_1088_: u32;
    var phi_1092_: u32;
    var phi_1093_: u32;
    var phi_1094_: u32;
    var phi_1098_: f32;
    var phi_1100_: mask_Masked;
    var phi_1172_: bool;
    var phi_1173_: bool;
    var phi_1174_: bool;
    var phi_1175_: bool;
    var phi_1179_: bool;
    var phi_1207_: f32;
    var phi_1210_: bool;
    var phi_1211_: u32;
    var phi_1222_: u32;
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
            phi_1100_ = mask_Masked(_e256.unnamed.visibility, 0u, false);
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
            let _e319 = ((_e317 & 2u) != 0u);
            let _e321 = p.member.flags;
            if ((_e321 & 4u) == 0u) {
                phi_613_ = u32();
                phi_614_ = true;
                phi_615_ = false;
            } else {
                if _e315 {
                    if !(false) {
                        let _e331 = ((((_e47.y * _e98) + _e47.x) * _e94.words) + _e94.light.word);
                        if (_e94.light.shift > 29u) {
                            let _e335 = (_e331 + 1u);
                            if (_e335 < _e53) {
                            } else {
                                return;
                            }
                            let _e339 = last_bits.member[(0u + _e335)];
                            phi_580_ = _e339;
                        } else {
                            phi_580_ = 0u;
                        }
                        let _e341 = phi_580_;
                        if (_e331 < _e53) {
                        } else {
                            return;
                        }
                        let _e347 = last_bits.member[(0u + _e331)];
                        let _e350 = (_e347 >> bitcast<u32>((_e94.light.shift & 31u)));
                        if (_e94.light.shift > 29u) {
                            phi_599_ = (_e350 | (_e341 << bitcast<u32>(((32u - _e94.light.shift) & 31u))));
                        } else {
                            phi_599_ = _e350;
                        }
                        let _e358 = phi_599_;
                        if ((_e358 & 2u) == 0u) {
                            phi_607_ = (_e358 & 1u);
                        } else {
                            phi_607_ = (_e358 & 7u);
                        }
                        let _e364 = phi_607_;
                        phi_608_ = _e364;
                        phi_609_ = false;
                    } else {
                        phi_608_ = u32();
                        phi_609_ = true;
                    }
                    let _e366 = phi_608_;
                    let _e368 = phi_609_;
                    phi_610_ = _e366;
                    phi_611_ = false;
                    phi_612_ = _e368;
                } else {
                    phi_610_ = u32();
                    phi_611_ = true;
                    phi_612_ = false;
                }
                let _e370 = phi_610_;
                let _e372 = phi_611_;
                let _e374 = phi_612_;
                phi_613_ = _e370;
                phi_614_ = _e372;
                phi_615_ = _e374;
            }
            let _e376 = phi_613_;
            let _e378 = phi_614_;
            let _e380 = phi_615_;
            if _e378 {
                phi_619_ = true;
            } else {
                phi_619_ = _e380;
            }
            let _e382 = phi_619_;
            if _e382 {
                phi_623_ = 0u;
            } else {
                phi_623_ = _e376;
            }
            let _e384 = phi_623_;
            let _e385 = lt_mask_Neighbourhood(false, true);
            if _e265 {
                phi_628_ = _e319;
            } else {
                phi_628_ = false;
            }
            let _e387 = phi_628_;
            if _e387 {
                if _e315 {
                    if ((_e384 & 2u) != 0u) {
                        phi_922_ = _e385;
                    } else {
                        let _e391 = p.member.expansion;
                        if false {
                            let _e393 = p.member.moving_pattern;
                            phi_649_ = _e393;
                        } else {
                            let _e395 = p.member.still_pattern;
                            phi_649_ = _e395;
                        }
                        let _e397 = phi_649_;
                        phi_651_ = 0u;
                        phi_654_ = _e385;
                        loop {
                            let _e399 = phi_651_;
                            let _e401 = phi_654_;
                            local_1 = _e401;
                            if (1u <= _e397) {
                                if (_e397 <= 4u) {
                                    phi_666_ = false;
                                } else {
                                    phi_666_ = true;
                                }
                                let _e405 = phi_666_;
                                phi_667_ = _e405;
                            } else {
                                phi_667_ = true;
                            }
                            let _e407 = phi_667_;
                            if _e407 {
                                switch bitcast<i32>(_e397) {
                                    case 5: {
                                        phi_676_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_676_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_676_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_676_ = 9u;
                                        break;
                                    }
                                }
                                let _e410 = phi_676_;
                                phi_677_ = _e410;
                            } else {
                                phi_677_ = 5u;
                            }
                            let _e412 = phi_677_;
                            let _e413 = (_e399 < _e412);
                            if _e413 {
                                let _e415 = p.member.frame;
                                let _e419 = p.member.current.size[0u];
                                let _e421 = p.member.current.size[1u];
                                switch bitcast<i32>(_e397) {
                                    case 1: {
                                        let _e431 = lt_mask_pattern_plus(_e399);
                                        phi_757_ = vec2<i32>(_e431.x, _e431.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e435 = lt_mask_pattern_cross(_e399);
                                        phi_757_ = vec2<i32>(_e435.x, _e435.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e441 = lt_mask_pattern_plus_or_cross(_e399, ((_e47.x + _e47.y) & 1u));
                                        phi_757_ = vec2<i32>(_e441.x, _e441.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e446 = lt_mask_pattern_plus_or_cross(_e399, (_e415 & 1u));
                                        phi_757_ = vec2<i32>(_e446.x, _e446.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e415 & 3u)) {
                                            case 0: {
                                                phi_737_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_737_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_737_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_737_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e457 = phi_737_;
                                        phi_757_ = (_e457 + vec2<i32>(bitcast<i32>((_e399 & 1u)), bitcast<i32>(((_e399 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_757_ = vec2<i32>((bitcast<i32>((_e399 % 5u)) - 2i), (bitcast<i32>(((_e399 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e474 = lt_mask_pattern_diamond(_e399);
                                        phi_757_ = vec2<i32>(_e474.x, _e474.y);
                                        break;
                                    }
                                    default: {
                                        phi_757_ = vec2<i32>((bitcast<i32>((_e399 % 3u)) - 1i), (bitcast<i32>(((_e399 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e479 = phi_757_;
                                let _e482 = lt_mask_pattern_step_clamped(_e47.x, _e479.x, _e419);
                                let _e483 = lt_mask_pattern_step_clamped(_e47.y, _e479.y, _e421);
                                let _e490 = ((((_e483 * _e98) + _e482) * _e94.words) + _e94.light.word);
                                if (_e94.light.shift > 29u) {
                                    let _e494 = (_e490 + 1u);
                                    if (_e494 < _e53) {
                                    } else {
                                        return;
                                    }
                                    let _e498 = last_bits.member[(0u + _e494)];
                                    phi_784_ = _e498;
                                } else {
                                    phi_784_ = 0u;
                                }
                                let _e500 = phi_784_;
                                if (_e490 < _e53) {
                                } else {
                                    return;
                                }
                                let _e506 = last_bits.member[(0u + _e490)];
                                let _e509 = (_e506 >> bitcast<u32>((_e94.light.shift & 31u)));
                                if (_e94.light.shift > 29u) {
                                    phi_803_ = (_e509 | (_e500 << bitcast<u32>(((32u - _e94.light.shift) & 31u))));
                                } else {
                                    phi_803_ = _e509;
                                }
                                let _e517 = phi_803_;
                                if ((_e517 & 2u) == 0u) {
                                    phi_811_ = (_e517 & 1u);
                                } else {
                                    phi_811_ = (_e517 & 7u);
                                }
                                let _e523 = phi_811_;
                                if _e401.any_expands {
                                    phi_899_ = true;
                                } else {
                                    if ((_e523 & 2u) != 0u) {
                                        let _e530 = (((_e523 & 4u) != 0u) != _e261);
                                        switch bitcast<i32>(_e391) {
                                            case 1: {
                                                phi_839_ = bool();
                                                phi_840_ = false;
                                                phi_841_ = true;
                                                phi_842_ = false;
                                                phi_843_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e530 {
                                                    phi_837_ = (((_e523 & 4u) != 0u) != ((_e523 & 1u) != 0u));
                                                    phi_838_ = false;
                                                } else {
                                                    phi_837_ = bool();
                                                    phi_838_ = true;
                                                }
                                                let _e538 = phi_837_;
                                                let _e540 = phi_838_;
                                                phi_839_ = _e538;
                                                phi_840_ = false;
                                                phi_841_ = false;
                                                phi_842_ = _e540;
                                                phi_843_ = _e530;
                                                break;
                                            }
                                            default: {
                                                phi_839_ = bool();
                                                phi_840_ = true;
                                                phi_841_ = false;
                                                phi_842_ = false;
                                                phi_843_ = false;
                                                break;
                                            }
                                        }
                                        let _e542 = phi_839_;
                                        let _e544 = phi_840_;
                                        let _e546 = phi_841_;
                                        let _e548 = phi_842_;
                                        let _e550 = phi_843_;
                                        phi_851_ = _e530;
                                        phi_852_ = _e542;
                                        phi_853_ = _e544;
                                        phi_854_ = _e546;
                                        phi_855_ = _e548;
                                        phi_856_ = _e550;
                                    } else {
                                        switch bitcast<i32>(_e391) {
                                            case 1: {
                                                phi_848_ = false;
                                                phi_849_ = true;
                                                phi_850_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_848_ = false;
                                                phi_849_ = false;
                                                phi_850_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_848_ = true;
                                                phi_849_ = false;
                                                phi_850_ = false;
                                                break;
                                            }
                                        }
                                        let _e553 = phi_848_;
                                        let _e555 = phi_849_;
                                        let _e557 = phi_850_;
                                        phi_851_ = false;
                                        phi_852_ = bool();
                                        phi_853_ = _e553;
                                        phi_854_ = _e555;
                                        phi_855_ = _e557;
                                        phi_856_ = false;
                                    }
                                    let _e559 = phi_851_;
                                    let _e561 = phi_852_;
                                    let _e563 = phi_853_;
                                    let _e565 = phi_854_;
                                    let _e567 = phi_855_;
                                    let _e569 = phi_856_;
                                    if _e563 {
                                        if ((_e523 & 2u) != 0u) {
                                            if (((_e523 & 4u) != 0u) != _e261) {
                                                phi_871_ = false;
                                            } else {
                                                phi_871_ = true;
                                            }
                                            let _e576 = phi_871_;
                                            phi_872_ = _e576;
                                        } else {
                                            phi_872_ = true;
                                        }
                                        let _e578 = phi_872_;
                                        if _e578 {
                                            phi_879_ = (((_e523 & 1u) != 0u) != _e261);
                                        } else {
                                            phi_879_ = true;
                                        }
                                        let _e583 = phi_879_;
                                        phi_880_ = _e583;
                                        phi_881_ = false;
                                        phi_882_ = false;
                                        phi_883_ = false;
                                    } else {
                                        phi_880_ = bool();
                                        phi_881_ = _e565;
                                        phi_882_ = _e567;
                                        phi_883_ = _e569;
                                    }
                                    let _e585 = phi_880_;
                                    let _e587 = phi_881_;
                                    let _e589 = phi_882_;
                                    let _e591 = phi_883_;
                                    if _e587 {
                                        phi_887_ = _e559;
                                        phi_888_ = false;
                                        phi_889_ = false;
                                    } else {
                                        phi_887_ = _e585;
                                        phi_888_ = _e589;
                                        phi_889_ = _e591;
                                    }
                                    let _e593 = phi_887_;
                                    let _e595 = phi_888_;
                                    let _e597 = phi_889_;
                                    if _e595 {
                                        phi_893_ = false;
                                        phi_894_ = true;
                                    } else {
                                        phi_893_ = _e561;
                                        phi_894_ = _e597;
                                    }
                                    let _e599 = phi_893_;
                                    let _e601 = phi_894_;
                                    if _e601 {
                                        phi_898_ = _e599;
                                    } else {
                                        phi_898_ = _e593;
                                    }
                                    let _e603 = phi_898_;
                                    phi_899_ = _e603;
                                }
                                let _e605 = phi_899_;
                                if _e401.all_remove {
                                    if (((_e523 & 1u) != 0u) == _e261) {
                                        if ((_e523 & 2u) != 0u) {
                                            phi_917_ = (((_e523 & 4u) != 0u) == _e261);
                                        } else {
                                            phi_917_ = true;
                                        }
                                        let _e615 = phi_917_;
                                        phi_918_ = _e615;
                                    } else {
                                        phi_918_ = false;
                                    }
                                    let _e617 = phi_918_;
                                    phi_919_ = _e617;
                                } else {
                                    phi_919_ = false;
                                }
                                let _e619 = phi_919_;
                                phi_652_ = (_e399 + 1u);
                                phi_655_ = lt_mask_Neighbourhood(_e605, _e619);
                            } else {
                                phi_652_ = u32();
                                phi_655_ = lt_mask_Neighbourhood();
                            }
                            let _e623 = phi_652_;
                            let _e625 = phi_655_;
                            continue;
                            continuing {
                                phi_651_ = _e623;
                                phi_654_ = _e625;
                                break if !(_e413);
                            }
                        }
                        let _e933 = local_1;
                        phi_922_ = _e933;
                    }
                    let _e628 = phi_922_;
                    phi_923_ = _e628;
                } else {
                    phi_923_ = _e385;
                }
                let _e630 = phi_923_;
                phi_924_ = _e630;
            } else {
                phi_924_ = _e385;
            }
            let _e632 = phi_924_;
            let _e635 = p.member.frame;
            let _e637 = p.member.refresh;
            if (_e637 == 0u) {
                phi_957_ = false;
            } else {
                if (_e637 == 0u) {
                    return;
                }
                let _e646 = ((_e47.x + (_e47.y * (((_e637 * 5u) / 8u) | 1u))) + (_e635 % _e637));
                if (_e637 == 0u) {
                    phi_956_ = (_e646 == 0u);
                } else {
                    if (_e637 == 0u) {
                        return;
                    }
                    phi_956_ = ((_e646 % _e637) == 0u);
                }
                let _e653 = phi_956_;
                phi_957_ = _e653;
            }
            let _e655 = phi_957_;
            if _e315 {
                if _e655 {
                    phi_979_ = bool();
                } else {
                    phi_979_ = ((_e384 & 2u) != 0u);
                }
                let _e661 = phi_979_;
                phi_980_ = _e661;
                phi_981_ = _e655;
            } else {
                phi_980_ = bool();
                phi_981_ = true;
            }
            let _e663 = phi_980_;
            let _e665 = phi_981_;
            if _e665 {
                phi_985_ = false;
            } else {
                phi_985_ = _e663;
            }
            let _e667 = phi_985_;
            if _e667 {
                phi_1036_ = 7u;
            } else {
                if (_e103 != 0.5f) {
                    if _e315 {
                        if _e655 {
                            phi_1033_ = 6u;
                        } else {
                            if _e265 {
                                phi_1008_ = true;
                            } else {
                                if _e632.any_expands {
                                    phi_1007_ = false;
                                } else {
                                    phi_1007_ = true;
                                }
                                let _e669 = phi_1007_;
                                phi_1008_ = _e669;
                            }
                            let _e671 = phi_1008_;
                            if _e671 {
                                if _e265 {
                                    if _e319 {
                                        if _e632.all_remove {
                                            phi_1021_ = false;
                                        } else {
                                            phi_1021_ = true;
                                        }
                                        let _e673 = phi_1021_;
                                        phi_1022_ = _e673;
                                    } else {
                                        phi_1022_ = true;
                                    }
                                    let _e675 = phi_1022_;
                                    phi_1023_ = _e675;
                                } else {
                                    phi_1023_ = true;
                                }
                                let _e677 = phi_1023_;
                                if _e677 {
                                    if _e265 {
                                        phi_1030_ = 1u;
                                    } else {
                                        phi_1030_ = 0u;
                                    }
                                    let _e679 = phi_1030_;
                                    phi_1031_ = _e679;
                                } else {
                                    phi_1031_ = 5u;
                                }
                                let _e681 = phi_1031_;
                                phi_1032_ = _e681;
                            } else {
                                phi_1032_ = 4u;
                            }
                            let _e683 = phi_1032_;
                            phi_1033_ = _e683;
                        }
                        let _e685 = phi_1033_;
                        phi_1034_ = _e685;
                    } else {
                        phi_1034_ = 3u;
                    }
                    let _e687 = phi_1034_;
                    phi_1035_ = _e687;
                } else {
                    phi_1035_ = 2u;
                }
                let _e689 = phi_1035_;
                phi_1036_ = _e689;
            }
            let _e691 = phi_1036_;
            if !((_e691 == 0u)) {
                if !((_e691 == 5u)) {
                    phi_1048_ = !(_e667);
                    phi_1049_ = false;
                } else {
                    phi_1048_ = bool();
                    phi_1049_ = true;
                }
                let _e698 = phi_1048_;
                let _e700 = phi_1049_;
                phi_1050_ = _e698;
                phi_1051_ = _e700;
            } else {
                phi_1050_ = bool();
                phi_1051_ = true;
            }
            let _e702 = phi_1050_;
            let _e704 = phi_1051_;
            if _e704 {
                phi_1055_ = false;
            } else {
                phi_1055_ = _e702;
            }
            let _e706 = phi_1055_;
            if _e667 {
                phi_1061_ = ((_e384 & 4u) != 0u);
            } else {
                phi_1061_ = _e261;
            }
            let _e710 = phi_1061_;
            if _e706 {
                if _e261 {
                    phi_1069_ = (2u | 1u);
                } else {
                    phi_1069_ = 2u;
                }
                let _e713 = phi_1069_;
                if false {
                    phi_1074_ = (_e713 | 4u);
                } else {
                    phi_1074_ = _e713;
                }
                let _e716 = phi_1074_;
                phi_1094_ = _e716;
            } else {
                if (_e691 == 7u) {
                    if _e261 {
                        phi_1083_ = (2u | 1u);
                    } else {
                        phi_1083_ = 2u;
                    }
                    let _e720 = phi_1083_;
                    if _e710 {
                        phi_1088_ = (_e720 | 4u);
                    } else {
                        phi_1088_ = _e720;
                    }
                    let _e723 = phi_1088_;
                    phi_1093_ = _e723;
                } else {
                    if _e261 {
                        phi_1092_ = 1u;
                    } else {
                        phi_1092_ = 0u;
                    }
                    let _e725 = phi_1092_;
                    phi_1093_ = _e725;
                }
                let _e727 = phi_1093_;
                phi_1094_ = _e727;
            }
            let _e729 = phi_1094_;
            if _e710 {
                phi_1098_ = 0f;
            } else {
                phi_1098_ = 1f;
            }
            let _e731 = phi_1098_;
            phi_1100_ = mask_Masked(_e731, _e729, _e706);
        }
        let _e734 = phi_1100_;
        visibility.member[_e67.shift] = _e734.visibility;
        let _e739 = p.member.light.number;
        let _e740 = (_e739 * 3u);
        let _e742 = (_e740 % 32u);
        let _e744 = p.member.light.mask_words;
        let _e746 = ((_e67.shift * _e744) + (_e740 / 32u));
        let _e748 = bits.member[_e746];
        bits.member[_e746] = ((_e748 & ~((7u << bitcast<u32>((_e742 & 31u))))) | (_e734.bits << bitcast<u32>((_e742 & 31u))));
        if (_e742 > 29u) {
            let _e763 = bits.member[(_e746 + 1u)];
            let _e765 = (32u - _e742);
            bits.member[(_e746 + 1u)] = ((_e763 & ~((7u >> bitcast<u32>((_e765 & 31u))))) | (_e734.bits >> bitcast<u32>((_e765 & 31u))));
        }
        let _e780 = samples.member[_e67.shift].normal[0u];
        let _e782 = global[0u];
        if (_e780 == _e782) {
            let _e785 = samples.member[_e67.shift].normal[1u];
            let _e787 = global[1u];
            if (_e785 == _e787) {
                let _e790 = samples.member[_e67.shift].normal[2u];
                let _e792 = global[2u];
                phi_1172_ = (_e790 == _e792);
                phi_1173_ = false;
            } else {
                phi_1172_ = bool();
                phi_1173_ = true;
            }
            let _e795 = phi_1172_;
            let _e797 = phi_1173_;
            phi_1174_ = _e795;
            phi_1175_ = _e797;
        } else {
            phi_1174_ = bool();
            phi_1175_ = true;
        }
        let _e799 = phi_1174_;
        let _e801 = phi_1175_;
        if _e801 {
            phi_1179_ = false;
        } else {
            phi_1179_ = _e799;
        }
        let _e803 = phi_1179_;
        if !(_e803) {
            let _e806 = samples.member[_e67.shift].position;
            let _e808 = p.member.current.eye;
            let _e819 = p.member.current.forward;
            phi_1207_ = ((((_e806.x - _e808.x) * _e819.x) + ((_e806.y - _e808.y) * _e819.y)) + ((_e806.z - _e808.z) * _e819.z));
        } else {
            phi_1207_ = 0f;
        }
        let _e829 = phi_1207_;
        depths.member[_e67.shift] = _e829;
        phi_1210_ = _e734.needs_ray;
        phi_1211_ = _e67.shift;
    } else {
        phi_1210_ = false;
        phi_1211_ = 0u;
    }
    let _e833 = phi_1210_;
    let _e835 = phi_1211_;
    if (_e48 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e833 {
        let _e839 = atomicAdd((&shared_[0u]), 1u);
        phi_1222_ = _e839;
    } else {
        phi_1222_ = 0u;
    }
    let _e841 = phi_1222_;
    workgroupBarrier();
    if (_e48 == 0u) {
        let _e845 = atomicLoad((&shared_[0u]));
        let _e846 = atomicAdd((&list.member[3u]), _e845);
        atomicStore((&shared_[1u]), _e846);
    }
    workgroupBarrier();
    if _e833 {
        let _e849 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e849) + _e841)]), _e835);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_depth_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
