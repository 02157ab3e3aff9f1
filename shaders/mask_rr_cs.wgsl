struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    pad0_: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    pad3_: vec2<u32>,
}

struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
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

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
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

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_148_: lt_bvh_traverse_Tree;
    var phi_149_: bool;
    var phi_150_: lt_bvh_traverse_Tree;
    var phi_151_: bool;
    var phi_156_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_148_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_149_ = false;
        } else {
            phi_148_ = lt_bvh_traverse_Tree();
            phi_149_ = true;
        }
        let _e52 = phi_148_;
        let _e54 = phi_149_;
        phi_150_ = _e52;
        phi_151_ = _e54;
    } else {
        phi_150_ = lt_bvh_traverse_Tree();
        phi_151_ = true;
    }
    let _e56 = phi_150_;
    let _e58 = phi_151_;
    if _e58 {
        phi_156_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_156_ = _e56;
    }
    let _e63 = phi_156_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_174_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_174_ = vec2(0i);
            break;
        }
        case 1: {
            phi_174_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_174_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_174_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_174_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e48 = phi_174_;
    return vec2<i32>(_e48.x, _e48.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_192_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_192_ = vec2(0i);
            break;
        }
        case 1: {
            phi_192_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_192_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_192_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_192_ = vec2(1i);
            break;
        }
    }
    let _e48 = phi_192_;
    return vec2<i32>(_e48.x, _e48.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_211_: vec2<i32>;

    if (param_6 == 0u) {
        let _e42 = lt_mask_pattern_plus(param_5);
        phi_211_ = vec2<i32>(_e42.x, _e42.y);
    } else {
        let _e46 = lt_mask_pattern_cross(param_5);
        phi_211_ = vec2<i32>(_e46.x, _e46.y);
    }
    let _e51 = phi_211_;
    return vec2<i32>(_e51.x, _e51.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_236_: vec2<i32>;

    let _e40 = (param_7 % 13u);
    switch bitcast<i32>(_e40) {
        case 9: {
            phi_236_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_236_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_236_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_236_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_236_ = vec2<i32>((bitcast<i32>((_e40 % 3u)) - 1i), (bitcast<i32>(((_e40 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e55 = phi_236_;
    return vec2<i32>(_e55.x, _e55.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_257_: u32;
    var phi_258_: u32;

    let _e43 = (bitcast<i32>(param_8) + param_9);
    if (_e43 < 0i) {
        phi_258_ = 0u;
    } else {
        if (_e43 >= bitcast<i32>(param_10)) {
            phi_257_ = (param_10 - 1u);
        } else {
            phi_257_ = bitcast<u32>(_e43);
        }
        let _e50 = phi_257_;
        phi_258_ = _e50;
    }
    let _e52 = phi_258_;
    return _e52;
}

fn function_() {
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_321_: bool;
    var phi_325_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_407_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_408_: bool;
    var phi_409_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_410_: bool;
    var phi_417_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_421_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_434_: bool;
    var phi_455_: bool;
    var phi_466_: bool;
    var phi_467_: bool;
    var phi_468_: bool;
    var phi_469_: bool;
    var phi_470_: bool;
    var phi_471_: bool;
    var phi_475_: bool;
    var phi_480_: bool;
    var phi_494_: u32;
    var phi_496_: u32;
    var phi_499_: lt_mask_Neighbourhood;
    var phi_511_: bool;
    var phi_512_: bool;
    var phi_521_: u32;
    var phi_522_: u32;
    var phi_582_: vec2<i32>;
    var phi_602_: vec2<i32>;
    var phi_625_: u32;
    var phi_642_: bool;
    var phi_643_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_497_: u32;
    var phi_500_: lt_mask_Neighbourhood;
    var phi_674_: lt_mask_Neighbourhood;
    var phi_675_: lt_mask_Neighbourhood;
    var phi_700_: bool;
    var phi_701_: bool;
    var phi_714_: bool;
    var phi_715_: bool;
    var phi_716_: bool;
    var phi_723_: u32;
    var phi_724_: u32;
    var phi_725_: u32;
    var phi_726_: u32;
    var phi_727_: u32;
    var phi_735_: bool;
    var phi_743_: u32;
    var phi_748_: u32;
    var phi_752_: u32;
    var phi_753_: u32;
    var phi_757_: f32;
    var phi_759_: mask_Masked;
    var phi_765_: bool;
    var phi_766_: u32;
    var phi_777_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e39 = id_1;
    let _e40 = local_2;
    let _e52 = p.member.current.size[0u];
    let _e54 = p.member.current.size[1u];
    let _e55 = lt_shaders_entry_pixel_index(_e39, _e52, _e54);
    if (bitcast<i32>(_e55.root) != 0i) {
        let _e63 = p.member.current.size[0u];
        let _e68 = visibility.member[_e55.first_primitive];
        let _e74 = samples.member[_e55.first_primitive].normal[0u];
        let _e76 = global[0u];
        if (_e74 == _e76) {
            let _e79 = samples.member[_e55.first_primitive].normal[1u];
            let _e81 = global[1u];
            if (_e79 == _e81) {
                let _e84 = samples.member[_e55.first_primitive].normal[2u];
                let _e86 = global[2u];
                phi_318_ = (_e84 == _e86);
                phi_319_ = false;
            } else {
                phi_318_ = bool();
                phi_319_ = true;
            }
            let _e89 = phi_318_;
            let _e91 = phi_319_;
            phi_320_ = _e89;
            phi_321_ = _e91;
        } else {
            phi_320_ = bool();
            phi_321_ = true;
        }
        let _e93 = phi_320_;
        let _e95 = phi_321_;
        if _e95 {
            phi_325_ = false;
        } else {
            phi_325_ = _e93;
        }
        let _e97 = phi_325_;
        if !(_e97) {
            let _e100 = samples.member[_e55.first_primitive].position;
            let _e102 = p.member.light.place;
            let _e108 = p.member.light.place[3u];
            let _e115 = (_e102.x - (_e100.x * _e108));
            let _e116 = (_e102.y - (_e100.y * _e108));
            let _e117 = (_e102.z - (_e100.z * _e108));
            let _e119 = samples.member[_e55.first_primitive].normal;
            if ((((_e119.x * _e115) + (_e119.y * _e116)) + (_e119.z * _e117)) > 0f) {
                let _e133 = (((_e115 * _e115) + (_e116 * _e116)) + (_e117 * _e117));
                let _e135 = p.member.light.axis;
                let _e147 = p.member.light.place[3u];
                if (_e147 == 0f) {
                    phi_396_ = true;
                } else {
                    let _e150 = p.member.light.range_squared;
                    if (_e133 <= _e150) {
                        let _e153 = p.member.light.cos_outer;
                        phi_395_ = (-((((_e115 * _e135.x) + (_e116 * _e135.y)) + (_e117 * _e135.z))) >= (_e153 * sqrt(_e133)));
                    } else {
                        phi_395_ = false;
                    }
                    let _e158 = phi_395_;
                    phi_396_ = _e158;
                }
                let _e160 = phi_396_;
                if _e160 {
                    let _e162 = samples.member[_e55.first_primitive].flags;
                    let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
                    phi_407_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, ((_e162 & 1u) == 0u));
                    phi_408_ = false;
                } else {
                    phi_407_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_408_ = true;
                }
                let _e181 = phi_407_;
                let _e183 = phi_408_;
                phi_409_ = _e181;
                phi_410_ = _e183;
            } else {
                phi_409_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_410_ = true;
            }
            let _e185 = phi_409_;
            let _e187 = phi_410_;
            if _e187 {
                let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e193.unnamed.visibility, false), _e193.unnamed_1);
                phi_417_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e199.unnamed, true);
            } else {
                phi_417_ = _e185;
            }
            let _e204 = phi_417_;
            phi_421_ = _e204;
        } else {
            let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e210.unnamed.visibility, false), _e210.unnamed_1);
            phi_421_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e216.unnamed, true);
        }
        let _e221 = phi_421_;
        if _e221.unnamed_1 {
            phi_759_ = mask_Masked(_e221.unnamed.visibility, 0u, false);
        } else {
            let _e226 = (_e68 < 0.5f);
            if (_e68 > 0f) {
                phi_434_ = (_e68 < 1f);
            } else {
                phi_434_ = false;
            }
            let _e230 = phi_434_;
            let _e232 = p.member.flags;
            let _e234 = ((_e232 & 1u) != 0u);
            let _e236 = p.member.flags;
            if false {
                let _e240 = p.member.flags;
                phi_455_ = ((_e240 & 4u) == 0u);
            } else {
                phi_455_ = false;
            }
            let _e244 = phi_455_;
            if ((_e236 & 2u) != 0u) {
                if false {
                    phi_468_ = bool();
                    phi_469_ = true;
                } else {
                    if true {
                        phi_466_ = !(_e244);
                        phi_467_ = false;
                    } else {
                        phi_466_ = bool();
                        phi_467_ = true;
                    }
                    let _e247 = phi_466_;
                    let _e249 = phi_467_;
                    phi_468_ = _e247;
                    phi_469_ = _e249;
                }
                let _e251 = phi_468_;
                let _e253 = phi_469_;
                phi_470_ = _e251;
                phi_471_ = _e253;
            } else {
                phi_470_ = bool();
                phi_471_ = true;
            }
            let _e255 = phi_470_;
            let _e257 = phi_471_;
            if _e257 {
                phi_475_ = false;
            } else {
                phi_475_ = _e255;
            }
            let _e259 = phi_475_;
            let _e260 = lt_mask_Neighbourhood(false, true);
            if _e230 {
                phi_480_ = _e259;
            } else {
                phi_480_ = false;
            }
            let _e262 = phi_480_;
            if _e262 {
                if _e234 {
                    if false {
                        let _e264 = p.member.moving_pattern;
                        phi_494_ = _e264;
                    } else {
                        let _e266 = p.member.still_pattern;
                        phi_494_ = _e266;
                    }
                    let _e268 = phi_494_;
                    phi_496_ = 0u;
                    phi_499_ = _e260;
                    loop {
                        let _e270 = phi_496_;
                        let _e272 = phi_499_;
                        local_1 = _e272;
                        if (1u <= _e268) {
                            if (_e268 <= 4u) {
                                phi_511_ = false;
                            } else {
                                phi_511_ = true;
                            }
                            let _e276 = phi_511_;
                            phi_512_ = _e276;
                        } else {
                            phi_512_ = true;
                        }
                        let _e278 = phi_512_;
                        if _e278 {
                            switch bitcast<i32>(_e268) {
                                case 5: {
                                    phi_521_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_521_ = 25u;
                                    break;
                                }
                                case 7: {
                                    phi_521_ = 13u;
                                    break;
                                }
                                default: {
                                    phi_521_ = 9u;
                                    break;
                                }
                            }
                            let _e281 = phi_521_;
                            phi_522_ = _e281;
                        } else {
                            phi_522_ = 5u;
                        }
                        let _e283 = phi_522_;
                        let _e284 = (_e270 < _e283);
                        if _e284 {
                            let _e286 = p.member.frame;
                            let _e290 = p.member.current.size[0u];
                            let _e292 = p.member.current.size[1u];
                            switch bitcast<i32>(_e268) {
                                case 1: {
                                    let _e302 = lt_mask_pattern_plus(_e270);
                                    phi_602_ = vec2<i32>(_e302.x, _e302.y);
                                    break;
                                }
                                case 2: {
                                    let _e306 = lt_mask_pattern_cross(_e270);
                                    phi_602_ = vec2<i32>(_e306.x, _e306.y);
                                    break;
                                }
                                case 3: {
                                    let _e312 = lt_mask_pattern_plus_or_cross(_e270, ((_e39.x + _e39.y) & 1u));
                                    phi_602_ = vec2<i32>(_e312.x, _e312.y);
                                    break;
                                }
                                case 4: {
                                    let _e317 = lt_mask_pattern_plus_or_cross(_e270, (_e286 & 1u));
                                    phi_602_ = vec2<i32>(_e317.x, _e317.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e286 & 3u)) {
                                        case 0: {
                                            phi_582_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_582_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_582_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_582_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e328 = phi_582_;
                                    phi_602_ = (_e328 + vec2<i32>(bitcast<i32>((_e270 & 1u)), bitcast<i32>(((_e270 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_602_ = vec2<i32>((bitcast<i32>((_e270 % 5u)) - 2i), (bitcast<i32>(((_e270 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                case 7: {
                                    let _e345 = lt_mask_pattern_diamond(_e270);
                                    phi_602_ = vec2<i32>(_e345.x, _e345.y);
                                    break;
                                }
                                default: {
                                    phi_602_ = vec2<i32>((bitcast<i32>((_e270 % 3u)) - 1i), (bitcast<i32>(((_e270 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e350 = phi_602_;
                            let _e353 = lt_mask_pattern_step_clamped(_e39.x, _e350.x, _e290);
                            let _e354 = lt_mask_pattern_step_clamped(_e39.y, _e350.y, _e292);
                            let _e356 = ((_e354 * _e63) + _e353);
                            if (_e356 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e360 = last_bits.member[(0u + _e356)];
                            if ((_e360 & 2u) == 0u) {
                                phi_625_ = (_e360 & 1u);
                            } else {
                                phi_625_ = (_e360 & 7u);
                            }
                            let _e366 = phi_625_;
                            if _e272.any_expands {
                                phi_651_ = true;
                            } else {
                                if ((_e366 & 2u) != 0u) {
                                    if (((_e366 & 4u) != 0u) != _e226) {
                                        phi_642_ = false;
                                    } else {
                                        phi_642_ = true;
                                    }
                                    let _e375 = phi_642_;
                                    phi_643_ = _e375;
                                } else {
                                    phi_643_ = true;
                                }
                                let _e377 = phi_643_;
                                if _e377 {
                                    phi_650_ = (((_e366 & 1u) != 0u) != _e226);
                                } else {
                                    phi_650_ = true;
                                }
                                let _e382 = phi_650_;
                                phi_651_ = _e382;
                            }
                            let _e384 = phi_651_;
                            if _e272.all_remove {
                                if (((_e366 & 1u) != 0u) == _e226) {
                                    if ((_e366 & 2u) != 0u) {
                                        phi_669_ = (((_e366 & 4u) != 0u) == _e226);
                                    } else {
                                        phi_669_ = true;
                                    }
                                    let _e394 = phi_669_;
                                    phi_670_ = _e394;
                                } else {
                                    phi_670_ = false;
                                }
                                let _e396 = phi_670_;
                                phi_671_ = _e396;
                            } else {
                                phi_671_ = false;
                            }
                            let _e398 = phi_671_;
                            phi_497_ = (_e270 + 1u);
                            phi_500_ = lt_mask_Neighbourhood(_e384, _e398);
                        } else {
                            phi_497_ = u32();
                            phi_500_ = lt_mask_Neighbourhood();
                        }
                        let _e402 = phi_497_;
                        let _e404 = phi_500_;
                        continue;
                        continuing {
                            phi_496_ = _e402;
                            phi_499_ = _e404;
                            break if !(_e284);
                        }
                    }
                    let _e524 = local_1;
                    phi_674_ = _e524;
                } else {
                    phi_674_ = _e260;
                }
                let _e407 = phi_674_;
                phi_675_ = _e407;
            } else {
                phi_675_ = _e260;
            }
            let _e409 = phi_675_;
            if (_e68 != 0.5f) {
                if _e234 {
                    if _e230 {
                        phi_701_ = true;
                    } else {
                        if _e409.any_expands {
                            phi_700_ = false;
                        } else {
                            phi_700_ = true;
                        }
                        let _e414 = phi_700_;
                        phi_701_ = _e414;
                    }
                    let _e416 = phi_701_;
                    if _e416 {
                        if _e230 {
                            if _e259 {
                                if _e409.all_remove {
                                    phi_714_ = false;
                                } else {
                                    phi_714_ = true;
                                }
                                let _e418 = phi_714_;
                                phi_715_ = _e418;
                            } else {
                                phi_715_ = true;
                            }
                            let _e420 = phi_715_;
                            phi_716_ = _e420;
                        } else {
                            phi_716_ = true;
                        }
                        let _e422 = phi_716_;
                        if _e422 {
                            if _e230 {
                                phi_723_ = 1u;
                            } else {
                                phi_723_ = 0u;
                            }
                            let _e424 = phi_723_;
                            phi_724_ = _e424;
                        } else {
                            phi_724_ = 5u;
                        }
                        let _e426 = phi_724_;
                        phi_725_ = _e426;
                    } else {
                        phi_725_ = 4u;
                    }
                    let _e428 = phi_725_;
                    phi_726_ = _e428;
                } else {
                    phi_726_ = 3u;
                }
                let _e430 = phi_726_;
                phi_727_ = _e430;
            } else {
                phi_727_ = 2u;
            }
            let _e432 = phi_727_;
            if !((_e432 == 0u)) {
                phi_735_ = !((_e432 == 5u));
            } else {
                phi_735_ = false;
            }
            let _e438 = phi_735_;
            if _e438 {
                if _e226 {
                    phi_743_ = (2u | 1u);
                } else {
                    phi_743_ = 2u;
                }
                let _e441 = phi_743_;
                if false {
                    phi_748_ = (_e441 | 4u);
                } else {
                    phi_748_ = _e441;
                }
                let _e444 = phi_748_;
                phi_753_ = _e444;
            } else {
                if _e226 {
                    phi_752_ = 1u;
                } else {
                    phi_752_ = 0u;
                }
                let _e446 = phi_752_;
                phi_753_ = _e446;
            }
            let _e448 = phi_753_;
            if _e226 {
                phi_757_ = 0f;
            } else {
                phi_757_ = 1f;
            }
            let _e450 = phi_757_;
            phi_759_ = mask_Masked(_e450, _e448, _e438);
        }
        let _e453 = phi_759_;
        visibility.member[_e55.first_primitive] = _e453.visibility;
        bits.member[_e55.first_primitive] = _e453.bits;
        phi_765_ = _e453.needs_ray;
        phi_766_ = _e55.first_primitive;
    } else {
        phi_765_ = false;
        phi_766_ = 0u;
    }
    let _e460 = phi_765_;
    let _e462 = phi_766_;
    if (_e40 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e460 {
        let _e466 = atomicAdd((&shared_[0u]), 1u);
        phi_777_ = _e466;
    } else {
        phi_777_ = 0u;
    }
    let _e468 = phi_777_;
    workgroupBarrier();
    if (_e40 == 0u) {
        let _e472 = atomicLoad((&shared_[0u]));
        let _e473 = atomicAdd((&list.member[3u]), _e472);
        atomicStore((&shared_[1u]), _e473);
    }
    workgroupBarrier();
    if _e460 {
        let _e476 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e476) + _e468)]), _e462);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
