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
    var phi_899_: u32;
    var phi_900_: u32;

    let _e46 = (bitcast<i32>(param) + param_1);
    if (_e46 < 0i) {
        phi_900_ = 0u;
    } else {
        if (_e46 >= bitcast<i32>(param_2)) {
            phi_899_ = (param_2 - 1u);
        } else {
            phi_899_ = bitcast<u32>(_e46);
        }
        let _e53 = phi_899_;
        phi_900_ = _e53;
    }
    let _e55 = phi_900_;
    return _e55;
}

fn lt_mask_pattern_diamond(param_3: u32) -> vec2<i32> {
    var phi_878_: vec2<i32>;

    let _e43 = (param_3 % 13u);
    switch bitcast<i32>(_e43) {
        case 9: {
            phi_878_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_878_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_878_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_878_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_878_ = vec2<i32>((bitcast<i32>((_e43 % 3u)) - 1i), (bitcast<i32>(((_e43 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e58 = phi_878_;
    return vec2<i32>(_e58.x, _e58.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_834_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_834_ = vec2(0i);
            break;
        }
        case 1: {
            phi_834_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_834_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_834_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_834_ = vec2(1i);
            break;
        }
    }
    let _e51 = phi_834_;
    return vec2<i32>(_e51.x, _e51.y);
}

fn lt_mask_pattern_plus(param_5: u32) -> vec2<i32> {
    var phi_816_: vec2<i32>;

    switch bitcast<i32>((param_5 % 5u)) {
        case 0: {
            phi_816_ = vec2(0i);
            break;
        }
        case 1: {
            phi_816_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_816_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_816_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_816_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e51 = phi_816_;
    return vec2<i32>(_e51.x, _e51.y);
}

fn lt_mask_pattern_plus_or_cross(param_6: u32, param_7: u32) -> vec2<i32> {
    var phi_853_: vec2<i32>;

    if (param_7 == 0u) {
        let _e45 = lt_mask_pattern_plus(param_6);
        phi_853_ = vec2<i32>(_e45.x, _e45.y);
    } else {
        let _e49 = lt_mask_pattern_cross(param_6);
        phi_853_ = vec2<i32>(_e49.x, _e49.y);
    }
    let _e54 = phi_853_;
    return vec2<i32>(_e54.x, _e54.y);
}

fn lt_shaders_entry_pixel_index(param_8: vec3<u32>, param_9: u32, param_10: u32) -> lt_mask_LightPlace {
    var phi_790_: lt_mask_LightPlace;
    var phi_791_: bool;
    var phi_792_: lt_mask_LightPlace;
    var phi_793_: bool;
    var phi_798_: lt_mask_LightPlace;

    if (param_8.x < param_9) {
        if (param_8.y < param_10) {
            phi_790_ = lt_mask_LightPlace(1u, ((param_8.y * param_9) + param_8.x));
            phi_791_ = false;
        } else {
            phi_790_ = lt_mask_LightPlace();
            phi_791_ = true;
        }
        let _e55 = phi_790_;
        let _e57 = phi_791_;
        phi_792_ = _e55;
        phi_793_ = _e57;
    } else {
        phi_792_ = lt_mask_LightPlace();
        phi_793_ = true;
    }
    let _e59 = phi_792_;
    let _e61 = phi_793_;
    if _e61 {
        phi_798_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_798_ = _e59;
    }
    let _e66 = phi_798_;
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
    var phi_358_: u32;
    var phi_360_: u32;
    var phi_363_: lt_mask_Neighbourhood;
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_385_: u32;
    var phi_386_: u32;
    var phi_446_: vec2<i32>;
    var phi_466_: vec2<i32>;
    var phi_491_: u32;
    var phi_510_: u32;
    var phi_518_: u32;
    var phi_535_: bool;
    var phi_536_: bool;
    var phi_543_: bool;
    var phi_544_: bool;
    var phi_562_: bool;
    var phi_563_: bool;
    var phi_564_: bool;
    var phi_361_: u32;
    var phi_364_: lt_mask_Neighbourhood;
    var phi_567_: lt_mask_Neighbourhood;
    var phi_568_: lt_mask_Neighbourhood;
    var phi_569_: lt_mask_Neighbourhood;
    var phi_601_: bool;
    var phi_602_: bool;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_654_: u32;
    var phi_655_: u32;
    var phi_656_: u32;
    var phi_657_: u32;
    var phi_658_: u32;
    var phi_659_: u32;
    var phi_667_: bool;
    var phi_675_: u32;
    var phi_680_: u32;
    var phi_684_: u32;
    var phi_685_: u32;
    var phi_689_: f32;
    var phi_691_: mask_Masked;
    var phi_741_: bool;
    var phi_742_: u32;
    var phi_753_: u32;
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
            phi_691_ = mask_Masked(_e232.unnamed.visibility, 0u, false);
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
            if false {
            }
            let _e250 = lt_mask_Neighbourhood(false, true);
            if _e241 {
                phi_569_ = _e250;
            } else {
                if true {
                    if _e245 {
                        if false {
                            let _e252 = p.member.moving_pattern;
                            phi_358_ = _e252;
                        } else {
                            let _e254 = p.member.still_pattern;
                            phi_358_ = _e254;
                        }
                        let _e256 = phi_358_;
                        phi_360_ = 0u;
                        phi_363_ = _e250;
                        loop {
                            let _e258 = phi_360_;
                            let _e260 = phi_363_;
                            local_1 = _e260;
                            if (1u <= _e256) {
                                if (_e256 <= 4u) {
                                    phi_375_ = false;
                                } else {
                                    phi_375_ = true;
                                }
                                let _e264 = phi_375_;
                                phi_376_ = _e264;
                            } else {
                                phi_376_ = true;
                            }
                            let _e266 = phi_376_;
                            if _e266 {
                                switch bitcast<i32>(_e256) {
                                    case 5: {
                                        phi_385_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_385_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_385_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_385_ = 9u;
                                        break;
                                    }
                                }
                                let _e269 = phi_385_;
                                phi_386_ = _e269;
                            } else {
                                phi_386_ = 5u;
                            }
                            let _e271 = phi_386_;
                            let _e272 = (_e258 < _e271);
                            if _e272 {
                                let _e274 = p.member.frame;
                                let _e278 = p.member.current.size[0u];
                                let _e280 = p.member.current.size[1u];
                                switch bitcast<i32>(_e256) {
                                    case 1: {
                                        let _e290 = lt_mask_pattern_plus(_e258);
                                        phi_466_ = vec2<i32>(_e290.x, _e290.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e294 = lt_mask_pattern_cross(_e258);
                                        phi_466_ = vec2<i32>(_e294.x, _e294.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e300 = lt_mask_pattern_plus_or_cross(_e258, ((_e42.x + _e42.y) & 1u));
                                        phi_466_ = vec2<i32>(_e300.x, _e300.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e305 = lt_mask_pattern_plus_or_cross(_e258, (_e274 & 1u));
                                        phi_466_ = vec2<i32>(_e305.x, _e305.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e274 & 3u)) {
                                            case 0: {
                                                phi_446_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_446_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_446_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_446_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e316 = phi_446_;
                                        phi_466_ = (_e316 + vec2<i32>(bitcast<i32>((_e258 & 1u)), bitcast<i32>(((_e258 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_466_ = vec2<i32>((bitcast<i32>((_e258 % 5u)) - 2i), (bitcast<i32>(((_e258 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e333 = lt_mask_pattern_diamond(_e258);
                                        phi_466_ = vec2<i32>(_e333.x, _e333.y);
                                        break;
                                    }
                                    default: {
                                        phi_466_ = vec2<i32>((bitcast<i32>((_e258 % 3u)) - 1i), (bitcast<i32>(((_e258 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e338 = phi_466_;
                                let _e341 = lt_mask_pattern_step_clamped(_e42.x, _e338.x, _e278);
                                let _e342 = lt_mask_pattern_step_clamped(_e42.y, _e338.y, _e280);
                                let _e346 = ((((_e342 * _e74) + _e341) * _e70) + (_e66 / 32u));
                                if (_e68 > 29u) {
                                    let _e348 = (_e346 + 1u);
                                    if (_e348 < _e48) {
                                    } else {
                                        return;
                                    }
                                    let _e352 = last_bits.member[(0u + _e348)];
                                    phi_491_ = _e352;
                                } else {
                                    phi_491_ = 0u;
                                }
                                let _e354 = phi_491_;
                                if (_e346 < _e48) {
                                } else {
                                    return;
                                }
                                let _e358 = last_bits.member[(0u + _e346)];
                                let _e361 = (_e358 >> bitcast<u32>((_e68 & 31u)));
                                if (_e68 > 29u) {
                                    phi_510_ = (_e361 | (_e354 << bitcast<u32>(((32u - _e68) & 31u))));
                                } else {
                                    phi_510_ = _e361;
                                }
                                let _e369 = phi_510_;
                                if ((_e369 & 2u) == 0u) {
                                    phi_518_ = (_e369 & 1u);
                                } else {
                                    phi_518_ = (_e369 & 7u);
                                }
                                let _e375 = phi_518_;
                                if _e260.any_expands {
                                    phi_544_ = true;
                                } else {
                                    if ((_e375 & 2u) != 0u) {
                                        if (((_e375 & 4u) != 0u) != _e237) {
                                            phi_535_ = false;
                                        } else {
                                            phi_535_ = true;
                                        }
                                        let _e384 = phi_535_;
                                        phi_536_ = _e384;
                                    } else {
                                        phi_536_ = true;
                                    }
                                    let _e386 = phi_536_;
                                    if _e386 {
                                        phi_543_ = (((_e375 & 1u) != 0u) != _e237);
                                    } else {
                                        phi_543_ = true;
                                    }
                                    let _e391 = phi_543_;
                                    phi_544_ = _e391;
                                }
                                let _e393 = phi_544_;
                                if _e260.all_remove {
                                    if (((_e375 & 1u) != 0u) == _e237) {
                                        if ((_e375 & 2u) != 0u) {
                                            phi_562_ = (((_e375 & 4u) != 0u) == _e237);
                                        } else {
                                            phi_562_ = true;
                                        }
                                        let _e403 = phi_562_;
                                        phi_563_ = _e403;
                                    } else {
                                        phi_563_ = false;
                                    }
                                    let _e405 = phi_563_;
                                    phi_564_ = _e405;
                                } else {
                                    phi_564_ = false;
                                }
                                let _e407 = phi_564_;
                                phi_361_ = (_e258 + 1u);
                                phi_364_ = lt_mask_Neighbourhood(_e393, _e407);
                            } else {
                                phi_361_ = u32();
                                phi_364_ = lt_mask_Neighbourhood();
                            }
                            let _e411 = phi_361_;
                            let _e413 = phi_364_;
                            continue;
                            continuing {
                                phi_360_ = _e411;
                                phi_363_ = _e413;
                                break if !(_e272);
                            }
                        }
                        let _e590 = local_1;
                        phi_567_ = _e590;
                    } else {
                        phi_567_ = _e250;
                    }
                    let _e416 = phi_567_;
                    phi_568_ = _e416;
                } else {
                    phi_568_ = _e250;
                }
                let _e418 = phi_568_;
                phi_569_ = _e418;
            }
            let _e420 = phi_569_;
            let _e423 = p.member.frame;
            let _e425 = p.member.refresh;
            if (_e425 == 0u) {
                phi_602_ = false;
            } else {
                if (_e425 == 0u) {
                    return;
                }
                let _e434 = ((_e42.x + (_e42.y * (((_e425 * 5u) / 8u) | 1u))) + (_e423 % _e425));
                if (_e425 == 0u) {
                    phi_601_ = (_e434 == 0u);
                } else {
                    if (_e425 == 0u) {
                        return;
                    }
                    phi_601_ = ((_e434 % _e425) == 0u);
                }
                let _e441 = phi_601_;
                phi_602_ = _e441;
            }
            let _e443 = phi_602_;
            if (_e79 != 0.5f) {
                if _e245 {
                    if _e443 {
                        phi_657_ = 6u;
                    } else {
                        if _e241 {
                            phi_632_ = true;
                        } else {
                            if _e420.any_expands {
                                phi_631_ = false;
                            } else {
                                phi_631_ = true;
                            }
                            let _e447 = phi_631_;
                            phi_632_ = _e447;
                        }
                        let _e449 = phi_632_;
                        if _e449 {
                            if _e241 {
                                if false {
                                    if _e420.all_remove {
                                        phi_645_ = false;
                                    } else {
                                        phi_645_ = true;
                                    }
                                    let _e451 = phi_645_;
                                    phi_646_ = _e451;
                                } else {
                                    phi_646_ = true;
                                }
                                let _e453 = phi_646_;
                                phi_647_ = _e453;
                            } else {
                                phi_647_ = true;
                            }
                            let _e455 = phi_647_;
                            if _e455 {
                                if _e241 {
                                    phi_654_ = 1u;
                                } else {
                                    phi_654_ = 0u;
                                }
                                let _e457 = phi_654_;
                                phi_655_ = _e457;
                            } else {
                                phi_655_ = 5u;
                            }
                            let _e459 = phi_655_;
                            phi_656_ = _e459;
                        } else {
                            phi_656_ = 4u;
                        }
                        let _e461 = phi_656_;
                        phi_657_ = _e461;
                    }
                    let _e463 = phi_657_;
                    phi_658_ = _e463;
                } else {
                    phi_658_ = 3u;
                }
                let _e465 = phi_658_;
                phi_659_ = _e465;
            } else {
                phi_659_ = 2u;
            }
            let _e467 = phi_659_;
            if !((_e467 == 0u)) {
                phi_667_ = !((_e467 == 5u));
            } else {
                phi_667_ = false;
            }
            let _e473 = phi_667_;
            if _e473 {
                if _e237 {
                    phi_675_ = (2u | 1u);
                } else {
                    phi_675_ = 2u;
                }
                let _e476 = phi_675_;
                if false {
                    phi_680_ = (_e476 | 4u);
                } else {
                    phi_680_ = _e476;
                }
                let _e479 = phi_680_;
                phi_685_ = _e479;
            } else {
                if _e237 {
                    phi_684_ = 1u;
                } else {
                    phi_684_ = 0u;
                }
                let _e481 = phi_684_;
                phi_685_ = _e481;
            }
            let _e483 = phi_685_;
            if _e237 {
                phi_689_ = 0f;
            } else {
                phi_689_ = 1f;
            }
            let _e485 = phi_689_;
            phi_691_ = mask_Masked(_e485, _e483, _e473);
        }
        let _e488 = phi_691_;
        visibility.member[_e58.shift] = _e488.visibility;
        let _e493 = p.member.light.number;
        let _e494 = (_e493 * 3u);
        let _e496 = (_e494 % 32u);
        let _e498 = p.member.light.mask_words;
        let _e500 = ((_e58.shift * _e498) + (_e494 / 32u));
        let _e502 = bits.member[_e500];
        bits.member[_e500] = ((_e502 & ~((7u << bitcast<u32>((_e496 & 31u))))) | (_e488.bits << bitcast<u32>((_e496 & 31u))));
        if (_e496 > 29u) {
            let _e517 = bits.member[(_e500 + 1u)];
            let _e519 = (32u - _e496);
            bits.member[(_e500 + 1u)] = ((_e517 & ~((7u >> bitcast<u32>((_e519 & 31u))))) | (_e488.bits >> bitcast<u32>((_e519 & 31u))));
        }
        phi_741_ = _e488.needs_ray;
        phi_742_ = _e58.shift;
    } else {
        phi_741_ = false;
        phi_742_ = 0u;
    }
    let _e533 = phi_741_;
    let _e535 = phi_742_;
    if (_e43 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e533 {
        let _e539 = atomicAdd((&shared_[0u]), 1u);
        phi_753_ = _e539;
    } else {
        phi_753_ = 0u;
    }
    let _e541 = phi_753_;
    workgroupBarrier();
    if (_e43 == 0u) {
        let _e545 = atomicLoad((&shared_[0u]));
        let _e546 = atomicAdd((&list.member[3u]), _e545);
        atomicStore((&shared_[1u]), _e546);
    }
    workgroupBarrier();
    if _e533 {
        let _e549 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e549) + _e541)]), _e535);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
