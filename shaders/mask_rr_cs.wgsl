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
    var phi_157_: lt_mask_LightPlace;
    var phi_158_: bool;
    var phi_159_: lt_mask_LightPlace;
    var phi_160_: bool;
    var phi_165_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_157_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_158_ = false;
        } else {
            phi_157_ = lt_mask_LightPlace();
            phi_158_ = true;
        }
        let _e56 = phi_157_;
        let _e58 = phi_158_;
        phi_159_ = _e56;
        phi_160_ = _e58;
    } else {
        phi_159_ = lt_mask_LightPlace();
        phi_160_ = true;
    }
    let _e60 = phi_159_;
    let _e62 = phi_160_;
    if _e62 {
        phi_165_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_165_ = _e60;
    }
    let _e67 = phi_165_;
    return lt_mask_LightPlace(_e67.word, _e67.shift);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_183_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_183_ = vec2(0i);
            break;
        }
        case 1: {
            phi_183_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_183_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_183_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_183_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e52 = phi_183_;
    return vec2<i32>(_e52.x, _e52.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_201_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_201_ = vec2(0i);
            break;
        }
        case 1: {
            phi_201_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_201_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_201_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_201_ = vec2(1i);
            break;
        }
    }
    let _e52 = phi_201_;
    return vec2<i32>(_e52.x, _e52.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_220_: vec2<i32>;

    if (param_6 == 0u) {
        let _e46 = lt_mask_pattern_plus(param_5);
        phi_220_ = vec2<i32>(_e46.x, _e46.y);
    } else {
        let _e50 = lt_mask_pattern_cross(param_5);
        phi_220_ = vec2<i32>(_e50.x, _e50.y);
    }
    let _e55 = phi_220_;
    return vec2<i32>(_e55.x, _e55.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_245_: vec2<i32>;

    let _e44 = (param_7 % 13u);
    switch bitcast<i32>(_e44) {
        case 9: {
            phi_245_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_245_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_245_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_245_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_245_ = vec2<i32>((bitcast<i32>((_e44 % 3u)) - 1i), (bitcast<i32>(((_e44 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e59 = phi_245_;
    return vec2<i32>(_e59.x, _e59.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_266_: u32;
    var phi_267_: u32;

    let _e47 = (bitcast<i32>(param_8) + param_9);
    if (_e47 < 0i) {
        phi_267_ = 0u;
    } else {
        if (_e47 >= bitcast<i32>(param_10)) {
            phi_266_ = (param_10 - 1u);
        } else {
            phi_266_ = bitcast<u32>(_e47);
        }
        let _e54 = phi_266_;
        phi_267_ = _e54;
    }
    let _e56 = phi_267_;
    return _e56;
}

fn function_() {
    var phi_339_: bool;
    var phi_340_: bool;
    var phi_341_: bool;
    var phi_342_: bool;
    var phi_346_: bool;
    var phi_416_: bool;
    var phi_417_: bool;
    var phi_428_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_429_: bool;
    var phi_430_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_431_: bool;
    var phi_438_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_442_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_455_: bool;
    var phi_527_: u32;
    var phi_546_: u32;
    var phi_554_: u32;
    var phi_555_: u32;
    var phi_556_: bool;
    var phi_557_: u32;
    var phi_558_: bool;
    var phi_559_: bool;
    var phi_560_: u32;
    var phi_561_: bool;
    var phi_562_: bool;
    var phi_566_: bool;
    var phi_570_: u32;
    var phi_575_: bool;
    var phi_596_: u32;
    var phi_598_: u32;
    var phi_601_: lt_mask_Neighbourhood;
    var phi_613_: bool;
    var phi_614_: bool;
    var phi_623_: u32;
    var phi_624_: u32;
    var phi_684_: vec2<i32>;
    var phi_704_: vec2<i32>;
    var phi_729_: u32;
    var phi_748_: u32;
    var phi_756_: u32;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_786_: bool;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_793_: bool;
    var phi_794_: bool;
    var phi_795_: bool;
    var phi_796_: bool;
    var phi_797_: bool;
    var phi_798_: bool;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_832_: bool;
    var phi_833_: bool;
    var phi_834_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_843_: bool;
    var phi_844_: bool;
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_599_: u32;
    var phi_602_: lt_mask_Neighbourhood;
    var phi_867_: lt_mask_Neighbourhood;
    var phi_868_: lt_mask_Neighbourhood;
    var phi_869_: lt_mask_Neighbourhood;
    var phi_901_: bool;
    var phi_902_: bool;
    var phi_924_: bool;
    var phi_925_: bool;
    var phi_926_: bool;
    var phi_930_: bool;
    var phi_952_: bool;
    var phi_953_: bool;
    var phi_966_: bool;
    var phi_967_: bool;
    var phi_968_: bool;
    var phi_975_: u32;
    var phi_976_: u32;
    var phi_977_: u32;
    var phi_978_: u32;
    var phi_979_: u32;
    var phi_980_: u32;
    var phi_981_: u32;
    var phi_993_: bool;
    var phi_994_: bool;
    var phi_995_: bool;
    var phi_996_: bool;
    var phi_1000_: bool;
    var phi_1006_: bool;
    var phi_1014_: u32;
    var phi_1019_: u32;
    var phi_1028_: u32;
    var phi_1033_: u32;
    var phi_1037_: u32;
    var phi_1038_: u32;
    var phi_1039_: u32;
    var phi_1043_: f32;
    var phi_1045_: mask_Masked;
    var phi_1095_: bool;
    var phi_1096_: u32;
    var phi_1107_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e43 = id_1;
    let _e44 = local_2;
    let _e49 = arrayLength((&last_bits.member));
    let _e56 = p.member.current.size[0u];
    let _e58 = p.member.current.size[1u];
    let _e59 = lt_shaders_entry_pixel_index(_e43, _e56, _e58);
    if (bitcast<i32>(_e59.word) != 0i) {
        let _e66 = p.member.light.number;
        let _e67 = (_e66 * 3u);
        let _e68 = (_e67 / 32u);
        let _e69 = (_e67 % 32u);
        let _e71 = p.member.light.mask_words;
        let _e75 = p.member.current.size[0u];
        let _e78 = samples.member[_e59.shift].position;
        let _e80 = visibility.member[_e59.shift];
        let _e86 = samples.member[_e59.shift].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[_e59.shift].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[_e59.shift].normal[2u];
                let _e98 = global[2u];
                phi_339_ = (_e96 == _e98);
                phi_340_ = false;
            } else {
                phi_339_ = bool();
                phi_340_ = true;
            }
            let _e101 = phi_339_;
            let _e103 = phi_340_;
            phi_341_ = _e101;
            phi_342_ = _e103;
        } else {
            phi_341_ = bool();
            phi_342_ = true;
        }
        let _e105 = phi_341_;
        let _e107 = phi_342_;
        if _e107 {
            phi_346_ = false;
        } else {
            phi_346_ = _e105;
        }
        let _e109 = phi_346_;
        if !(_e109) {
            let _e112 = samples.member[_e59.shift].position;
            let _e114 = p.member.light.place;
            let _e120 = p.member.light.place[3u];
            let _e127 = (_e114.x - (_e112.x * _e120));
            let _e128 = (_e114.y - (_e112.y * _e120));
            let _e129 = (_e114.z - (_e112.z * _e120));
            let _e131 = samples.member[_e59.shift].normal;
            if ((((_e131.x * _e127) + (_e131.y * _e128)) + (_e131.z * _e129)) > 0f) {
                let _e145 = (((_e127 * _e127) + (_e128 * _e128)) + (_e129 * _e129));
                let _e147 = p.member.light.axis;
                let _e159 = p.member.light.place[3u];
                if (_e159 == 0f) {
                    phi_417_ = true;
                } else {
                    let _e162 = p.member.light.range_squared;
                    if (_e145 <= _e162) {
                        let _e165 = p.member.light.cos_outer;
                        phi_416_ = (-((((_e127 * _e147.x) + (_e128 * _e147.y)) + (_e129 * _e147.z))) >= (_e165 * sqrt(_e145)));
                    } else {
                        phi_416_ = false;
                    }
                    let _e170 = phi_416_;
                    phi_417_ = _e170;
                }
                let _e172 = phi_417_;
                if _e172 {
                    let _e174 = samples.member[_e59.shift].flags;
                    let _e182 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e182.unnamed.visibility, false), _e182.unnamed_1);
                    phi_428_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e188.unnamed, ((_e174 & 1u) == 0u));
                    phi_429_ = false;
                } else {
                    phi_428_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_429_ = true;
                }
                let _e193 = phi_428_;
                let _e195 = phi_429_;
                phi_430_ = _e193;
                phi_431_ = _e195;
            } else {
                phi_430_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_431_ = true;
            }
            let _e197 = phi_430_;
            let _e199 = phi_431_;
            if _e199 {
                let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
                phi_438_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
            } else {
                phi_438_ = _e197;
            }
            let _e216 = phi_438_;
            phi_442_ = _e216;
        } else {
            let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
            phi_442_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, true);
        }
        let _e233 = phi_442_;
        if _e233.unnamed_1 {
            phi_1045_ = mask_Masked(_e233.unnamed.visibility, 0u, false);
        } else {
            let _e238 = (_e80 < 0.5f);
            if (_e80 > 0f) {
                phi_455_ = (_e80 < 1f);
            } else {
                phi_455_ = false;
            }
            let _e242 = phi_455_;
            let _e244 = p.member.flags;
            if ((_e244 & 16u) == 0u) {
            } else {
                let _e250 = samples.member[_e59.shift].position[0u];
                if (_e78.x == _e250) {
                    let _e254 = samples.member[_e59.shift].position[1u];
                    if (_e78.y == _e254) {
                    }
                }
            }
            let _e259 = p.member.flags;
            let _e261 = ((_e259 & 1u) != 0u);
            let _e263 = p.member.flags;
            let _e265 = ((_e263 & 2u) != 0u);
            let _e267 = p.member.flags;
            if ((_e267 & 4u) == 0u) {
                phi_560_ = u32();
                phi_561_ = true;
                phi_562_ = false;
            } else {
                if _e261 {
                    if !(false) {
                        let _e274 = ((((_e43.y * _e75) + _e43.x) * _e71) + _e68);
                        if (_e69 > 29u) {
                            let _e276 = (_e274 + 1u);
                            if (_e276 < _e49) {
                            } else {
                                return;
                            }
                            let _e280 = last_bits.member[(0u + _e276)];
                            phi_527_ = _e280;
                        } else {
                            phi_527_ = 0u;
                        }
                        let _e282 = phi_527_;
                        if (_e274 < _e49) {
                        } else {
                            return;
                        }
                        let _e286 = last_bits.member[(0u + _e274)];
                        let _e289 = (_e286 >> bitcast<u32>((_e69 & 31u)));
                        if (_e69 > 29u) {
                            phi_546_ = (_e289 | (_e282 << bitcast<u32>(((32u - _e69) & 31u))));
                        } else {
                            phi_546_ = _e289;
                        }
                        let _e297 = phi_546_;
                        if ((_e297 & 2u) == 0u) {
                            phi_554_ = (_e297 & 1u);
                        } else {
                            phi_554_ = (_e297 & 7u);
                        }
                        let _e303 = phi_554_;
                        phi_555_ = _e303;
                        phi_556_ = false;
                    } else {
                        phi_555_ = u32();
                        phi_556_ = true;
                    }
                    let _e305 = phi_555_;
                    let _e307 = phi_556_;
                    phi_557_ = _e305;
                    phi_558_ = false;
                    phi_559_ = _e307;
                } else {
                    phi_557_ = u32();
                    phi_558_ = true;
                    phi_559_ = false;
                }
                let _e309 = phi_557_;
                let _e311 = phi_558_;
                let _e313 = phi_559_;
                phi_560_ = _e309;
                phi_561_ = _e311;
                phi_562_ = _e313;
            }
            let _e315 = phi_560_;
            let _e317 = phi_561_;
            let _e319 = phi_562_;
            if _e317 {
                phi_566_ = true;
            } else {
                phi_566_ = _e319;
            }
            let _e321 = phi_566_;
            if _e321 {
                phi_570_ = 0u;
            } else {
                phi_570_ = _e315;
            }
            let _e323 = phi_570_;
            let _e324 = lt_mask_Neighbourhood(false, true);
            if _e242 {
                phi_575_ = _e265;
            } else {
                phi_575_ = false;
            }
            let _e326 = phi_575_;
            if _e326 {
                if _e261 {
                    if ((_e323 & 2u) != 0u) {
                        phi_867_ = _e324;
                    } else {
                        let _e330 = p.member.expansion;
                        if false {
                            let _e332 = p.member.moving_pattern;
                            phi_596_ = _e332;
                        } else {
                            let _e334 = p.member.still_pattern;
                            phi_596_ = _e334;
                        }
                        let _e336 = phi_596_;
                        phi_598_ = 0u;
                        phi_601_ = _e324;
                        loop {
                            let _e338 = phi_598_;
                            let _e340 = phi_601_;
                            local_1 = _e340;
                            if (1u <= _e336) {
                                if (_e336 <= 4u) {
                                    phi_613_ = false;
                                } else {
                                    phi_613_ = true;
                                }
                                let _e344 = phi_613_;
                                phi_614_ = _e344;
                            } else {
                                phi_614_ = true;
                            }
                            let _e346 = phi_614_;
                            if _e346 {
                                switch bitcast<i32>(_e336) {
                                    case 5: {
                                        phi_623_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_623_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_623_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_623_ = 9u;
                                        break;
                                    }
                                }
                                let _e349 = phi_623_;
                                phi_624_ = _e349;
                            } else {
                                phi_624_ = 5u;
                            }
                            let _e351 = phi_624_;
                            let _e352 = (_e338 < _e351);
                            if _e352 {
                                let _e354 = p.member.frame;
                                let _e358 = p.member.current.size[0u];
                                let _e360 = p.member.current.size[1u];
                                switch bitcast<i32>(_e336) {
                                    case 1: {
                                        let _e370 = lt_mask_pattern_plus(_e338);
                                        phi_704_ = vec2<i32>(_e370.x, _e370.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e374 = lt_mask_pattern_cross(_e338);
                                        phi_704_ = vec2<i32>(_e374.x, _e374.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e380 = lt_mask_pattern_plus_or_cross(_e338, ((_e43.x + _e43.y) & 1u));
                                        phi_704_ = vec2<i32>(_e380.x, _e380.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e385 = lt_mask_pattern_plus_or_cross(_e338, (_e354 & 1u));
                                        phi_704_ = vec2<i32>(_e385.x, _e385.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e354 & 3u)) {
                                            case 0: {
                                                phi_684_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_684_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_684_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_684_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e396 = phi_684_;
                                        phi_704_ = (_e396 + vec2<i32>(bitcast<i32>((_e338 & 1u)), bitcast<i32>(((_e338 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_704_ = vec2<i32>((bitcast<i32>((_e338 % 5u)) - 2i), (bitcast<i32>(((_e338 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e413 = lt_mask_pattern_diamond(_e338);
                                        phi_704_ = vec2<i32>(_e413.x, _e413.y);
                                        break;
                                    }
                                    default: {
                                        phi_704_ = vec2<i32>((bitcast<i32>((_e338 % 3u)) - 1i), (bitcast<i32>(((_e338 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e418 = phi_704_;
                                let _e421 = lt_mask_pattern_step_clamped(_e43.x, _e418.x, _e358);
                                let _e422 = lt_mask_pattern_step_clamped(_e43.y, _e418.y, _e360);
                                let _e426 = ((((_e422 * _e75) + _e421) * _e71) + _e68);
                                if (_e69 > 29u) {
                                    let _e428 = (_e426 + 1u);
                                    if (_e428 < _e49) {
                                    } else {
                                        return;
                                    }
                                    let _e432 = last_bits.member[(0u + _e428)];
                                    phi_729_ = _e432;
                                } else {
                                    phi_729_ = 0u;
                                }
                                let _e434 = phi_729_;
                                if (_e426 < _e49) {
                                } else {
                                    return;
                                }
                                let _e438 = last_bits.member[(0u + _e426)];
                                let _e441 = (_e438 >> bitcast<u32>((_e69 & 31u)));
                                if (_e69 > 29u) {
                                    phi_748_ = (_e441 | (_e434 << bitcast<u32>(((32u - _e69) & 31u))));
                                } else {
                                    phi_748_ = _e441;
                                }
                                let _e449 = phi_748_;
                                if ((_e449 & 2u) == 0u) {
                                    phi_756_ = (_e449 & 1u);
                                } else {
                                    phi_756_ = (_e449 & 7u);
                                }
                                let _e455 = phi_756_;
                                if _e340.any_expands {
                                    phi_844_ = true;
                                } else {
                                    if ((_e455 & 2u) != 0u) {
                                        let _e462 = (((_e455 & 4u) != 0u) != _e238);
                                        switch bitcast<i32>(_e330) {
                                            case 1: {
                                                phi_784_ = bool();
                                                phi_785_ = false;
                                                phi_786_ = true;
                                                phi_787_ = false;
                                                phi_788_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e462 {
                                                    phi_782_ = (((_e455 & 4u) != 0u) != ((_e455 & 1u) != 0u));
                                                    phi_783_ = false;
                                                } else {
                                                    phi_782_ = bool();
                                                    phi_783_ = true;
                                                }
                                                let _e470 = phi_782_;
                                                let _e472 = phi_783_;
                                                phi_784_ = _e470;
                                                phi_785_ = false;
                                                phi_786_ = false;
                                                phi_787_ = _e472;
                                                phi_788_ = _e462;
                                                break;
                                            }
                                            default: {
                                                phi_784_ = bool();
                                                phi_785_ = true;
                                                phi_786_ = false;
                                                phi_787_ = false;
                                                phi_788_ = false;
                                                break;
                                            }
                                        }
                                        let _e474 = phi_784_;
                                        let _e476 = phi_785_;
                                        let _e478 = phi_786_;
                                        let _e480 = phi_787_;
                                        let _e482 = phi_788_;
                                        phi_796_ = _e462;
                                        phi_797_ = _e474;
                                        phi_798_ = _e476;
                                        phi_799_ = _e478;
                                        phi_800_ = _e480;
                                        phi_801_ = _e482;
                                    } else {
                                        switch bitcast<i32>(_e330) {
                                            case 1: {
                                                phi_793_ = false;
                                                phi_794_ = true;
                                                phi_795_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_793_ = false;
                                                phi_794_ = false;
                                                phi_795_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_793_ = true;
                                                phi_794_ = false;
                                                phi_795_ = false;
                                                break;
                                            }
                                        }
                                        let _e485 = phi_793_;
                                        let _e487 = phi_794_;
                                        let _e489 = phi_795_;
                                        phi_796_ = false;
                                        phi_797_ = bool();
                                        phi_798_ = _e485;
                                        phi_799_ = _e487;
                                        phi_800_ = _e489;
                                        phi_801_ = false;
                                    }
                                    let _e491 = phi_796_;
                                    let _e493 = phi_797_;
                                    let _e495 = phi_798_;
                                    let _e497 = phi_799_;
                                    let _e499 = phi_800_;
                                    let _e501 = phi_801_;
                                    if _e495 {
                                        if ((_e455 & 2u) != 0u) {
                                            if (((_e455 & 4u) != 0u) != _e238) {
                                                phi_816_ = false;
                                            } else {
                                                phi_816_ = true;
                                            }
                                            let _e508 = phi_816_;
                                            phi_817_ = _e508;
                                        } else {
                                            phi_817_ = true;
                                        }
                                        let _e510 = phi_817_;
                                        if _e510 {
                                            phi_824_ = (((_e455 & 1u) != 0u) != _e238);
                                        } else {
                                            phi_824_ = true;
                                        }
                                        let _e515 = phi_824_;
                                        phi_825_ = _e515;
                                        phi_826_ = false;
                                        phi_827_ = false;
                                        phi_828_ = false;
                                    } else {
                                        phi_825_ = bool();
                                        phi_826_ = _e497;
                                        phi_827_ = _e499;
                                        phi_828_ = _e501;
                                    }
                                    let _e517 = phi_825_;
                                    let _e519 = phi_826_;
                                    let _e521 = phi_827_;
                                    let _e523 = phi_828_;
                                    if _e519 {
                                        phi_832_ = _e491;
                                        phi_833_ = false;
                                        phi_834_ = false;
                                    } else {
                                        phi_832_ = _e517;
                                        phi_833_ = _e521;
                                        phi_834_ = _e523;
                                    }
                                    let _e525 = phi_832_;
                                    let _e527 = phi_833_;
                                    let _e529 = phi_834_;
                                    if _e527 {
                                        phi_838_ = false;
                                        phi_839_ = true;
                                    } else {
                                        phi_838_ = _e493;
                                        phi_839_ = _e529;
                                    }
                                    let _e531 = phi_838_;
                                    let _e533 = phi_839_;
                                    if _e533 {
                                        phi_843_ = _e531;
                                    } else {
                                        phi_843_ = _e525;
                                    }
                                    let _e535 = phi_843_;
                                    phi_844_ = _e535;
                                }
                                let _e537 = phi_844_;
                                if _e340.all_remove {
                                    if (((_e455 & 1u) != 0u) == _e238) {
                                        if ((_e455 & 2u) != 0u) {
                                            phi_862_ = (((_e455 & 4u) != 0u) == _e238);
                                        } else {
                                            phi_862_ = true;
                                        }
                                        let _e547 = phi_862_;
                                        phi_863_ = _e547;
                                    } else {
                                        phi_863_ = false;
                                    }
                                    let _e549 = phi_863_;
                                    phi_864_ = _e549;
                                } else {
                                    phi_864_ = false;
                                }
                                let _e551 = phi_864_;
                                phi_599_ = (_e338 + 1u);
                                phi_602_ = lt_mask_Neighbourhood(_e537, _e551);
                            } else {
                                phi_599_ = u32();
                                phi_602_ = lt_mask_Neighbourhood();
                            }
                            let _e555 = phi_599_;
                            let _e557 = phi_602_;
                            continue;
                            continuing {
                                phi_598_ = _e555;
                                phi_601_ = _e557;
                                break if !(_e352);
                            }
                        }
                        let _e808 = local_1;
                        phi_867_ = _e808;
                    }
                    let _e560 = phi_867_;
                    phi_868_ = _e560;
                } else {
                    phi_868_ = _e324;
                }
                let _e562 = phi_868_;
                phi_869_ = _e562;
            } else {
                phi_869_ = _e324;
            }
            let _e564 = phi_869_;
            let _e567 = p.member.frame;
            let _e569 = p.member.refresh;
            if (_e569 == 0u) {
                phi_902_ = false;
            } else {
                if (_e569 == 0u) {
                    return;
                }
                let _e578 = ((_e43.x + (_e43.y * (((_e569 * 5u) / 8u) | 1u))) + (_e567 % _e569));
                if (_e569 == 0u) {
                    phi_901_ = (_e578 == 0u);
                } else {
                    if (_e569 == 0u) {
                        return;
                    }
                    phi_901_ = ((_e578 % _e569) == 0u);
                }
                let _e585 = phi_901_;
                phi_902_ = _e585;
            }
            let _e587 = phi_902_;
            if _e261 {
                if _e587 {
                    phi_924_ = bool();
                } else {
                    phi_924_ = ((_e323 & 2u) != 0u);
                }
                let _e593 = phi_924_;
                phi_925_ = _e593;
                phi_926_ = _e587;
            } else {
                phi_925_ = bool();
                phi_926_ = true;
            }
            let _e595 = phi_925_;
            let _e597 = phi_926_;
            if _e597 {
                phi_930_ = false;
            } else {
                phi_930_ = _e595;
            }
            let _e599 = phi_930_;
            if _e599 {
                phi_981_ = 7u;
            } else {
                if (_e80 != 0.5f) {
                    if _e261 {
                        if _e587 {
                            phi_978_ = 6u;
                        } else {
                            if _e242 {
                                phi_953_ = true;
                            } else {
                                if _e564.any_expands {
                                    phi_952_ = false;
                                } else {
                                    phi_952_ = true;
                                }
                                let _e601 = phi_952_;
                                phi_953_ = _e601;
                            }
                            let _e603 = phi_953_;
                            if _e603 {
                                if _e242 {
                                    if _e265 {
                                        if _e564.all_remove {
                                            phi_966_ = false;
                                        } else {
                                            phi_966_ = true;
                                        }
                                        let _e605 = phi_966_;
                                        phi_967_ = _e605;
                                    } else {
                                        phi_967_ = true;
                                    }
                                    let _e607 = phi_967_;
                                    phi_968_ = _e607;
                                } else {
                                    phi_968_ = true;
                                }
                                let _e609 = phi_968_;
                                if _e609 {
                                    if _e242 {
                                        phi_975_ = 1u;
                                    } else {
                                        phi_975_ = 0u;
                                    }
                                    let _e611 = phi_975_;
                                    phi_976_ = _e611;
                                } else {
                                    phi_976_ = 5u;
                                }
                                let _e613 = phi_976_;
                                phi_977_ = _e613;
                            } else {
                                phi_977_ = 4u;
                            }
                            let _e615 = phi_977_;
                            phi_978_ = _e615;
                        }
                        let _e617 = phi_978_;
                        phi_979_ = _e617;
                    } else {
                        phi_979_ = 3u;
                    }
                    let _e619 = phi_979_;
                    phi_980_ = _e619;
                } else {
                    phi_980_ = 2u;
                }
                let _e621 = phi_980_;
                phi_981_ = _e621;
            }
            let _e623 = phi_981_;
            if !((_e623 == 0u)) {
                if !((_e623 == 5u)) {
                    phi_993_ = !(_e599);
                    phi_994_ = false;
                } else {
                    phi_993_ = bool();
                    phi_994_ = true;
                }
                let _e630 = phi_993_;
                let _e632 = phi_994_;
                phi_995_ = _e630;
                phi_996_ = _e632;
            } else {
                phi_995_ = bool();
                phi_996_ = true;
            }
            let _e634 = phi_995_;
            let _e636 = phi_996_;
            if _e636 {
                phi_1000_ = false;
            } else {
                phi_1000_ = _e634;
            }
            let _e638 = phi_1000_;
            if _e599 {
                phi_1006_ = ((_e323 & 4u) != 0u);
            } else {
                phi_1006_ = _e238;
            }
            let _e642 = phi_1006_;
            if _e638 {
                if _e238 {
                    phi_1014_ = (2u | 1u);
                } else {
                    phi_1014_ = 2u;
                }
                let _e645 = phi_1014_;
                if false {
                    phi_1019_ = (_e645 | 4u);
                } else {
                    phi_1019_ = _e645;
                }
                let _e648 = phi_1019_;
                phi_1039_ = _e648;
            } else {
                if (_e623 == 7u) {
                    if _e238 {
                        phi_1028_ = (2u | 1u);
                    } else {
                        phi_1028_ = 2u;
                    }
                    let _e652 = phi_1028_;
                    if _e642 {
                        phi_1033_ = (_e652 | 4u);
                    } else {
                        phi_1033_ = _e652;
                    }
                    let _e655 = phi_1033_;
                    phi_1038_ = _e655;
                } else {
                    if _e238 {
                        phi_1037_ = 1u;
                    } else {
                        phi_1037_ = 0u;
                    }
                    let _e657 = phi_1037_;
                    phi_1038_ = _e657;
                }
                let _e659 = phi_1038_;
                phi_1039_ = _e659;
            }
            let _e661 = phi_1039_;
            if _e642 {
                phi_1043_ = 0f;
            } else {
                phi_1043_ = 1f;
            }
            let _e663 = phi_1043_;
            phi_1045_ = mask_Masked(_e663, _e661, _e638);
        }
        let _e666 = phi_1045_;
        visibility.member[_e59.shift] = _e666.visibility;
        let _e671 = p.member.light.number;
        let _e672 = (_e671 * 3u);
        let _e674 = (_e672 % 32u);
        let _e676 = p.member.light.mask_words;
        let _e678 = ((_e59.shift * _e676) + (_e672 / 32u));
        let _e680 = bits.member[_e678];
        bits.member[_e678] = ((_e680 & ~((7u << bitcast<u32>((_e674 & 31u))))) | (_e666.bits << bitcast<u32>((_e674 & 31u))));
        if (_e674 > 29u) {
            let _e695 = bits.member[(_e678 + 1u)];
            let _e697 = (32u - _e674);
            bits.member[(_e678 + 1u)] = ((_e695 & ~((7u >> bitcast<u32>((_e697 & 31u))))) | (_e666.bits >> bitcast<u32>((_e697 & 31u))));
        }
        phi_1095_ = _e666.needs_ray;
        phi_1096_ = _e59.shift;
    } else {
        phi_1095_ = false;
        phi_1096_ = 0u;
    }
    let _e711 = phi_1095_;
    let _e713 = phi_1096_;
    if (_e44 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e711 {
        let _e717 = atomicAdd((&shared_[0u]), 1u);
        phi_1107_ = _e717;
    } else {
        phi_1107_ = 0u;
    }
    let _e719 = phi_1107_;
    workgroupBarrier();
    if (_e44 == 0u) {
        let _e723 = atomicLoad((&shared_[0u]));
        let _e724 = atomicAdd((&list.member[3u]), _e723);
        atomicStore((&shared_[1u]), _e724);
    }
    workgroupBarrier();
    if _e711 {
        let _e727 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e727) + _e719)]), _e713);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
