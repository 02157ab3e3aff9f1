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
    var phi_1041_: u32;
    var phi_1042_: u32;

    let _e47 = (bitcast<i32>(param) + param_1);
    if (_e47 < 0i) {
        phi_1042_ = 0u;
    } else {
        if (_e47 >= bitcast<i32>(param_2)) {
            phi_1041_ = (param_2 - 1u);
        } else {
            phi_1041_ = bitcast<u32>(_e47);
        }
        let _e54 = phi_1041_;
        phi_1042_ = _e54;
    }
    let _e56 = phi_1042_;
    return _e56;
}

fn lt_mask_pattern_diamond(param_3: u32) -> vec2<i32> {
    var phi_1020_: vec2<i32>;

    let _e44 = (param_3 % 13u);
    switch bitcast<i32>(_e44) {
        case 9: {
            phi_1020_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_1020_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_1020_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_1020_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_1020_ = vec2<i32>((bitcast<i32>((_e44 % 3u)) - 1i), (bitcast<i32>(((_e44 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e59 = phi_1020_;
    return vec2<i32>(_e59.x, _e59.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_976_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_976_ = vec2(0i);
            break;
        }
        case 1: {
            phi_976_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_976_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_976_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_976_ = vec2(1i);
            break;
        }
    }
    let _e52 = phi_976_;
    return vec2<i32>(_e52.x, _e52.y);
}

fn lt_mask_pattern_plus(param_5: u32) -> vec2<i32> {
    var phi_958_: vec2<i32>;

    switch bitcast<i32>((param_5 % 5u)) {
        case 0: {
            phi_958_ = vec2(0i);
            break;
        }
        case 1: {
            phi_958_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_958_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_958_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_958_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e52 = phi_958_;
    return vec2<i32>(_e52.x, _e52.y);
}

fn lt_mask_pattern_plus_or_cross(param_6: u32, param_7: u32) -> vec2<i32> {
    var phi_995_: vec2<i32>;

    if (param_7 == 0u) {
        let _e46 = lt_mask_pattern_plus(param_6);
        phi_995_ = vec2<i32>(_e46.x, _e46.y);
    } else {
        let _e50 = lt_mask_pattern_cross(param_6);
        phi_995_ = vec2<i32>(_e50.x, _e50.y);
    }
    let _e55 = phi_995_;
    return vec2<i32>(_e55.x, _e55.y);
}

fn lt_shaders_entry_pixel_index(param_8: vec3<u32>, param_9: u32, param_10: u32) -> lt_mask_LightPlace {
    var phi_932_: lt_mask_LightPlace;
    var phi_933_: bool;
    var phi_934_: lt_mask_LightPlace;
    var phi_935_: bool;
    var phi_940_: lt_mask_LightPlace;

    if (param_8.x < param_9) {
        if (param_8.y < param_10) {
            phi_932_ = lt_mask_LightPlace(1u, ((param_8.y * param_9) + param_8.x));
            phi_933_ = false;
        } else {
            phi_932_ = lt_mask_LightPlace();
            phi_933_ = true;
        }
        let _e56 = phi_932_;
        let _e58 = phi_933_;
        phi_934_ = _e56;
        phi_935_ = _e58;
    } else {
        phi_934_ = lt_mask_LightPlace();
        phi_935_ = true;
    }
    let _e60 = phi_934_;
    let _e62 = phi_935_;
    if _e62 {
        phi_940_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_940_ = _e60;
    }
    let _e67 = phi_940_;
    return lt_mask_LightPlace(_e67.word, _e67.shift);
}

fn function_() {
    var phi_209_: bool;
    var phi_210_: bool;
    var phi_211_: bool;
    var phi_212_: bool;
    var phi_216_: bool;
    var phi_286_: bool;
    var phi_287_: bool;
    var phi_298_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_299_: bool;
    var phi_300_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_301_: bool;
    var phi_308_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_312_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_325_: bool;
    var phi_363_: bool;
    var phi_384_: u32;
    var phi_386_: u32;
    var phi_389_: lt_mask_Neighbourhood;
    var phi_401_: bool;
    var phi_402_: bool;
    var phi_411_: u32;
    var phi_412_: u32;
    var phi_472_: vec2<i32>;
    var phi_492_: vec2<i32>;
    var phi_517_: u32;
    var phi_536_: u32;
    var phi_544_: u32;
    var phi_570_: bool;
    var phi_571_: bool;
    var phi_572_: bool;
    var phi_573_: bool;
    var phi_574_: bool;
    var phi_575_: bool;
    var phi_576_: bool;
    var phi_581_: bool;
    var phi_582_: bool;
    var phi_583_: bool;
    var phi_584_: bool;
    var phi_585_: bool;
    var phi_586_: bool;
    var phi_587_: bool;
    var phi_588_: bool;
    var phi_589_: bool;
    var phi_604_: bool;
    var phi_605_: bool;
    var phi_612_: bool;
    var phi_613_: bool;
    var phi_614_: bool;
    var phi_615_: bool;
    var phi_616_: bool;
    var phi_620_: bool;
    var phi_621_: bool;
    var phi_622_: bool;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_387_: u32;
    var phi_390_: lt_mask_Neighbourhood;
    var phi_655_: lt_mask_Neighbourhood;
    var phi_656_: lt_mask_Neighbourhood;
    var phi_657_: lt_mask_Neighbourhood;
    var phi_689_: bool;
    var phi_690_: bool;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_714_: bool;
    var phi_718_: bool;
    var phi_740_: bool;
    var phi_741_: bool;
    var phi_754_: bool;
    var phi_755_: bool;
    var phi_756_: bool;
    var phi_763_: u32;
    var phi_764_: u32;
    var phi_765_: u32;
    var phi_766_: u32;
    var phi_767_: u32;
    var phi_768_: u32;
    var phi_769_: u32;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_788_: bool;
    var phi_794_: bool;
    var phi_802_: u32;
    var phi_807_: u32;
    var phi_816_: u32;
    var phi_821_: u32;
    var phi_825_: u32;
    var phi_826_: u32;
    var phi_827_: u32;
    var phi_831_: f32;
    var phi_833_: mask_Masked;
    var phi_883_: bool;
    var phi_884_: u32;
    var phi_895_: u32;
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
                phi_209_ = (_e96 == _e98);
                phi_210_ = false;
            } else {
                phi_209_ = bool();
                phi_210_ = true;
            }
            let _e101 = phi_209_;
            let _e103 = phi_210_;
            phi_211_ = _e101;
            phi_212_ = _e103;
        } else {
            phi_211_ = bool();
            phi_212_ = true;
        }
        let _e105 = phi_211_;
        let _e107 = phi_212_;
        if _e107 {
            phi_216_ = false;
        } else {
            phi_216_ = _e105;
        }
        let _e109 = phi_216_;
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
                    phi_287_ = true;
                } else {
                    let _e162 = p.member.light.range_squared;
                    if (_e145 <= _e162) {
                        let _e165 = p.member.light.cos_outer;
                        phi_286_ = (-((((_e127 * _e147.x) + (_e128 * _e147.y)) + (_e129 * _e147.z))) >= (_e165 * sqrt(_e145)));
                    } else {
                        phi_286_ = false;
                    }
                    let _e170 = phi_286_;
                    phi_287_ = _e170;
                }
                let _e172 = phi_287_;
                if _e172 {
                    let _e174 = samples.member[_e59.shift].flags;
                    let _e182 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e182.unnamed.visibility, false), _e182.unnamed_1);
                    phi_298_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e188.unnamed, ((_e174 & 1u) == 0u));
                    phi_299_ = false;
                } else {
                    phi_298_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_299_ = true;
                }
                let _e193 = phi_298_;
                let _e195 = phi_299_;
                phi_300_ = _e193;
                phi_301_ = _e195;
            } else {
                phi_300_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_301_ = true;
            }
            let _e197 = phi_300_;
            let _e199 = phi_301_;
            if _e199 {
                let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
                phi_308_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
            } else {
                phi_308_ = _e197;
            }
            let _e216 = phi_308_;
            phi_312_ = _e216;
        } else {
            let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
            phi_312_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, true);
        }
        let _e233 = phi_312_;
        if _e233.unnamed_1 {
            phi_833_ = mask_Masked(_e233.unnamed.visibility, 0u, false);
        } else {
            let _e238 = (_e80 < 0.5f);
            if (_e80 > 0f) {
                phi_325_ = (_e80 < 1f);
            } else {
                phi_325_ = false;
            }
            let _e242 = phi_325_;
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
            let _e262 = lt_mask_Neighbourhood(false, true);
            if _e242 {
                phi_363_ = false;
            } else {
                phi_363_ = true;
            }
            let _e264 = phi_363_;
            if _e264 {
                if _e261 {
                    if ((0u & 2u) != 0u) {
                        phi_655_ = _e262;
                    } else {
                        let _e268 = p.member.expansion;
                        if false {
                            let _e270 = p.member.moving_pattern;
                            phi_384_ = _e270;
                        } else {
                            let _e272 = p.member.still_pattern;
                            phi_384_ = _e272;
                        }
                        let _e274 = phi_384_;
                        phi_386_ = 0u;
                        phi_389_ = _e262;
                        loop {
                            let _e276 = phi_386_;
                            let _e278 = phi_389_;
                            local_1 = _e278;
                            if (1u <= _e274) {
                                if (_e274 <= 4u) {
                                    phi_401_ = false;
                                } else {
                                    phi_401_ = true;
                                }
                                let _e282 = phi_401_;
                                phi_402_ = _e282;
                            } else {
                                phi_402_ = true;
                            }
                            let _e284 = phi_402_;
                            if _e284 {
                                switch bitcast<i32>(_e274) {
                                    case 5: {
                                        phi_411_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_411_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_411_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_411_ = 9u;
                                        break;
                                    }
                                }
                                let _e287 = phi_411_;
                                phi_412_ = _e287;
                            } else {
                                phi_412_ = 5u;
                            }
                            let _e289 = phi_412_;
                            let _e290 = (_e276 < _e289);
                            if _e290 {
                                let _e292 = p.member.frame;
                                let _e296 = p.member.current.size[0u];
                                let _e298 = p.member.current.size[1u];
                                switch bitcast<i32>(_e274) {
                                    case 1: {
                                        let _e308 = lt_mask_pattern_plus(_e276);
                                        phi_492_ = vec2<i32>(_e308.x, _e308.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e312 = lt_mask_pattern_cross(_e276);
                                        phi_492_ = vec2<i32>(_e312.x, _e312.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e318 = lt_mask_pattern_plus_or_cross(_e276, ((_e43.x + _e43.y) & 1u));
                                        phi_492_ = vec2<i32>(_e318.x, _e318.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e323 = lt_mask_pattern_plus_or_cross(_e276, (_e292 & 1u));
                                        phi_492_ = vec2<i32>(_e323.x, _e323.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e292 & 3u)) {
                                            case 0: {
                                                phi_472_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_472_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_472_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_472_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e334 = phi_472_;
                                        phi_492_ = (_e334 + vec2<i32>(bitcast<i32>((_e276 & 1u)), bitcast<i32>(((_e276 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_492_ = vec2<i32>((bitcast<i32>((_e276 % 5u)) - 2i), (bitcast<i32>(((_e276 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e351 = lt_mask_pattern_diamond(_e276);
                                        phi_492_ = vec2<i32>(_e351.x, _e351.y);
                                        break;
                                    }
                                    default: {
                                        phi_492_ = vec2<i32>((bitcast<i32>((_e276 % 3u)) - 1i), (bitcast<i32>(((_e276 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e356 = phi_492_;
                                let _e359 = lt_mask_pattern_step_clamped(_e43.x, _e356.x, _e296);
                                let _e360 = lt_mask_pattern_step_clamped(_e43.y, _e356.y, _e298);
                                let _e364 = ((((_e360 * _e75) + _e359) * _e71) + (_e67 / 32u));
                                if (_e69 > 29u) {
                                    let _e366 = (_e364 + 1u);
                                    if (_e366 < _e49) {
                                    } else {
                                        return;
                                    }
                                    let _e370 = last_bits.member[(0u + _e366)];
                                    phi_517_ = _e370;
                                } else {
                                    phi_517_ = 0u;
                                }
                                let _e372 = phi_517_;
                                if (_e364 < _e49) {
                                } else {
                                    return;
                                }
                                let _e376 = last_bits.member[(0u + _e364)];
                                let _e379 = (_e376 >> bitcast<u32>((_e69 & 31u)));
                                if (_e69 > 29u) {
                                    phi_536_ = (_e379 | (_e372 << bitcast<u32>(((32u - _e69) & 31u))));
                                } else {
                                    phi_536_ = _e379;
                                }
                                let _e387 = phi_536_;
                                if ((_e387 & 2u) == 0u) {
                                    phi_544_ = (_e387 & 1u);
                                } else {
                                    phi_544_ = (_e387 & 7u);
                                }
                                let _e393 = phi_544_;
                                if _e278.any_expands {
                                    phi_632_ = true;
                                } else {
                                    if ((_e393 & 2u) != 0u) {
                                        let _e400 = (((_e393 & 4u) != 0u) != _e238);
                                        switch bitcast<i32>(_e268) {
                                            case 1: {
                                                phi_572_ = bool();
                                                phi_573_ = false;
                                                phi_574_ = true;
                                                phi_575_ = false;
                                                phi_576_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e400 {
                                                    phi_570_ = (((_e393 & 4u) != 0u) != ((_e393 & 1u) != 0u));
                                                    phi_571_ = false;
                                                } else {
                                                    phi_570_ = bool();
                                                    phi_571_ = true;
                                                }
                                                let _e408 = phi_570_;
                                                let _e410 = phi_571_;
                                                phi_572_ = _e408;
                                                phi_573_ = false;
                                                phi_574_ = false;
                                                phi_575_ = _e410;
                                                phi_576_ = _e400;
                                                break;
                                            }
                                            default: {
                                                phi_572_ = bool();
                                                phi_573_ = true;
                                                phi_574_ = false;
                                                phi_575_ = false;
                                                phi_576_ = false;
                                                break;
                                            }
                                        }
                                        let _e412 = phi_572_;
                                        let _e414 = phi_573_;
                                        let _e416 = phi_574_;
                                        let _e418 = phi_575_;
                                        let _e420 = phi_576_;
                                        phi_584_ = _e400;
                                        phi_585_ = _e412;
                                        phi_586_ = _e414;
                                        phi_587_ = _e416;
                                        phi_588_ = _e418;
                                        phi_589_ = _e420;
                                    } else {
                                        switch bitcast<i32>(_e268) {
                                            case 1: {
                                                phi_581_ = false;
                                                phi_582_ = true;
                                                phi_583_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_581_ = false;
                                                phi_582_ = false;
                                                phi_583_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_581_ = true;
                                                phi_582_ = false;
                                                phi_583_ = false;
                                                break;
                                            }
                                        }
                                        let _e423 = phi_581_;
                                        let _e425 = phi_582_;
                                        let _e427 = phi_583_;
                                        phi_584_ = false;
                                        phi_585_ = bool();
                                        phi_586_ = _e423;
                                        phi_587_ = _e425;
                                        phi_588_ = _e427;
                                        phi_589_ = false;
                                    }
                                    let _e429 = phi_584_;
                                    let _e431 = phi_585_;
                                    let _e433 = phi_586_;
                                    let _e435 = phi_587_;
                                    let _e437 = phi_588_;
                                    let _e439 = phi_589_;
                                    if _e433 {
                                        if ((_e393 & 2u) != 0u) {
                                            if (((_e393 & 4u) != 0u) != _e238) {
                                                phi_604_ = false;
                                            } else {
                                                phi_604_ = true;
                                            }
                                            let _e446 = phi_604_;
                                            phi_605_ = _e446;
                                        } else {
                                            phi_605_ = true;
                                        }
                                        let _e448 = phi_605_;
                                        if _e448 {
                                            phi_612_ = (((_e393 & 1u) != 0u) != _e238);
                                        } else {
                                            phi_612_ = true;
                                        }
                                        let _e453 = phi_612_;
                                        phi_613_ = _e453;
                                        phi_614_ = false;
                                        phi_615_ = false;
                                        phi_616_ = false;
                                    } else {
                                        phi_613_ = bool();
                                        phi_614_ = _e435;
                                        phi_615_ = _e437;
                                        phi_616_ = _e439;
                                    }
                                    let _e455 = phi_613_;
                                    let _e457 = phi_614_;
                                    let _e459 = phi_615_;
                                    let _e461 = phi_616_;
                                    if _e457 {
                                        phi_620_ = _e429;
                                        phi_621_ = false;
                                        phi_622_ = false;
                                    } else {
                                        phi_620_ = _e455;
                                        phi_621_ = _e459;
                                        phi_622_ = _e461;
                                    }
                                    let _e463 = phi_620_;
                                    let _e465 = phi_621_;
                                    let _e467 = phi_622_;
                                    if _e465 {
                                        phi_626_ = false;
                                        phi_627_ = true;
                                    } else {
                                        phi_626_ = _e431;
                                        phi_627_ = _e467;
                                    }
                                    let _e469 = phi_626_;
                                    let _e471 = phi_627_;
                                    if _e471 {
                                        phi_631_ = _e469;
                                    } else {
                                        phi_631_ = _e463;
                                    }
                                    let _e473 = phi_631_;
                                    phi_632_ = _e473;
                                }
                                let _e475 = phi_632_;
                                if _e278.all_remove {
                                    if (((_e393 & 1u) != 0u) == _e238) {
                                        if ((_e393 & 2u) != 0u) {
                                            phi_650_ = (((_e393 & 4u) != 0u) == _e238);
                                        } else {
                                            phi_650_ = true;
                                        }
                                        let _e485 = phi_650_;
                                        phi_651_ = _e485;
                                    } else {
                                        phi_651_ = false;
                                    }
                                    let _e487 = phi_651_;
                                    phi_652_ = _e487;
                                } else {
                                    phi_652_ = false;
                                }
                                let _e489 = phi_652_;
                                phi_387_ = (_e276 + 1u);
                                phi_390_ = lt_mask_Neighbourhood(_e475, _e489);
                            } else {
                                phi_387_ = u32();
                                phi_390_ = lt_mask_Neighbourhood();
                            }
                            let _e493 = phi_387_;
                            let _e495 = phi_390_;
                            continue;
                            continuing {
                                phi_386_ = _e493;
                                phi_389_ = _e495;
                                break if !(_e290);
                            }
                        }
                        let _e733 = local_1;
                        phi_655_ = _e733;
                    }
                    let _e498 = phi_655_;
                    phi_656_ = _e498;
                } else {
                    phi_656_ = _e262;
                }
                let _e500 = phi_656_;
                phi_657_ = _e500;
            } else {
                phi_657_ = _e262;
            }
            let _e502 = phi_657_;
            let _e505 = p.member.frame;
            let _e507 = p.member.refresh;
            if (_e507 == 0u) {
                phi_690_ = false;
            } else {
                if (_e507 == 0u) {
                    return;
                }
                let _e516 = ((_e43.x + (_e43.y * (((_e507 * 5u) / 8u) | 1u))) + (_e505 % _e507));
                if (_e507 == 0u) {
                    phi_689_ = (_e516 == 0u);
                } else {
                    if (_e507 == 0u) {
                        return;
                    }
                    phi_689_ = ((_e516 % _e507) == 0u);
                }
                let _e523 = phi_689_;
                phi_690_ = _e523;
            }
            let _e525 = phi_690_;
            if _e261 {
                if _e525 {
                    phi_712_ = bool();
                } else {
                    phi_712_ = ((0u & 2u) != 0u);
                }
                let _e531 = phi_712_;
                phi_713_ = _e531;
                phi_714_ = _e525;
            } else {
                phi_713_ = bool();
                phi_714_ = true;
            }
            let _e533 = phi_713_;
            let _e535 = phi_714_;
            if _e535 {
                phi_718_ = false;
            } else {
                phi_718_ = _e533;
            }
            let _e537 = phi_718_;
            if _e537 {
                phi_769_ = 7u;
            } else {
                if (_e80 != 0.5f) {
                    if _e261 {
                        if _e525 {
                            phi_766_ = 6u;
                        } else {
                            if _e242 {
                                phi_741_ = true;
                            } else {
                                if _e502.any_expands {
                                    phi_740_ = false;
                                } else {
                                    phi_740_ = true;
                                }
                                let _e539 = phi_740_;
                                phi_741_ = _e539;
                            }
                            let _e541 = phi_741_;
                            if _e541 {
                                if _e242 {
                                    if false {
                                        if _e502.all_remove {
                                            phi_754_ = false;
                                        } else {
                                            phi_754_ = true;
                                        }
                                        let _e543 = phi_754_;
                                        phi_755_ = _e543;
                                    } else {
                                        phi_755_ = true;
                                    }
                                    let _e545 = phi_755_;
                                    phi_756_ = _e545;
                                } else {
                                    phi_756_ = true;
                                }
                                let _e547 = phi_756_;
                                if _e547 {
                                    if _e242 {
                                        phi_763_ = 1u;
                                    } else {
                                        phi_763_ = 0u;
                                    }
                                    let _e549 = phi_763_;
                                    phi_764_ = _e549;
                                } else {
                                    phi_764_ = 5u;
                                }
                                let _e551 = phi_764_;
                                phi_765_ = _e551;
                            } else {
                                phi_765_ = 4u;
                            }
                            let _e553 = phi_765_;
                            phi_766_ = _e553;
                        }
                        let _e555 = phi_766_;
                        phi_767_ = _e555;
                    } else {
                        phi_767_ = 3u;
                    }
                    let _e557 = phi_767_;
                    phi_768_ = _e557;
                } else {
                    phi_768_ = 2u;
                }
                let _e559 = phi_768_;
                phi_769_ = _e559;
            }
            let _e561 = phi_769_;
            if !((_e561 == 0u)) {
                if !((_e561 == 5u)) {
                    phi_781_ = !(_e537);
                    phi_782_ = false;
                } else {
                    phi_781_ = bool();
                    phi_782_ = true;
                }
                let _e568 = phi_781_;
                let _e570 = phi_782_;
                phi_783_ = _e568;
                phi_784_ = _e570;
            } else {
                phi_783_ = bool();
                phi_784_ = true;
            }
            let _e572 = phi_783_;
            let _e574 = phi_784_;
            if _e574 {
                phi_788_ = false;
            } else {
                phi_788_ = _e572;
            }
            let _e576 = phi_788_;
            if _e537 {
                phi_794_ = ((0u & 4u) != 0u);
            } else {
                phi_794_ = _e238;
            }
            let _e580 = phi_794_;
            if _e576 {
                if _e238 {
                    phi_802_ = (2u | 1u);
                } else {
                    phi_802_ = 2u;
                }
                let _e583 = phi_802_;
                if false {
                    phi_807_ = (_e583 | 4u);
                } else {
                    phi_807_ = _e583;
                }
                let _e586 = phi_807_;
                phi_827_ = _e586;
            } else {
                if (_e561 == 7u) {
                    if _e238 {
                        phi_816_ = (2u | 1u);
                    } else {
                        phi_816_ = 2u;
                    }
                    let _e590 = phi_816_;
                    if _e580 {
                        phi_821_ = (_e590 | 4u);
                    } else {
                        phi_821_ = _e590;
                    }
                    let _e593 = phi_821_;
                    phi_826_ = _e593;
                } else {
                    if _e238 {
                        phi_825_ = 1u;
                    } else {
                        phi_825_ = 0u;
                    }
                    let _e595 = phi_825_;
                    phi_826_ = _e595;
                }
                let _e597 = phi_826_;
                phi_827_ = _e597;
            }
            let _e599 = phi_827_;
            if _e580 {
                phi_831_ = 0f;
            } else {
                phi_831_ = 1f;
            }
            let _e601 = phi_831_;
            phi_833_ = mask_Masked(_e601, _e599, _e576);
        }
        let _e604 = phi_833_;
        visibility.member[_e59.shift] = _e604.visibility;
        let _e609 = p.member.light.number;
        let _e610 = (_e609 * 3u);
        let _e612 = (_e610 % 32u);
        let _e614 = p.member.light.mask_words;
        let _e616 = ((_e59.shift * _e614) + (_e610 / 32u));
        let _e618 = bits.member[_e616];
        bits.member[_e616] = ((_e618 & ~((7u << bitcast<u32>((_e612 & 31u))))) | (_e604.bits << bitcast<u32>((_e612 & 31u))));
        if (_e612 > 29u) {
            let _e633 = bits.member[(_e616 + 1u)];
            let _e635 = (32u - _e612);
            bits.member[(_e616 + 1u)] = ((_e633 & ~((7u >> bitcast<u32>((_e635 & 31u))))) | (_e604.bits >> bitcast<u32>((_e635 & 31u))));
        }
        phi_883_ = _e604.needs_ray;
        phi_884_ = _e59.shift;
    } else {
        phi_883_ = false;
        phi_884_ = 0u;
    }
    let _e649 = phi_883_;
    let _e651 = phi_884_;
    if (_e44 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e649 {
        let _e655 = atomicAdd((&shared_[0u]), 1u);
        phi_895_ = _e655;
    } else {
        phi_895_ = 0u;
    }
    let _e657 = phi_895_;
    workgroupBarrier();
    if (_e44 == 0u) {
        let _e661 = atomicLoad((&shared_[0u]));
        let _e662 = atomicAdd((&list.member[3u]), _e661);
        atomicStore((&shared_[1u]), _e662);
    }
    workgroupBarrier();
    if _e649 {
        let _e665 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e665) + _e657)]), _e651);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
