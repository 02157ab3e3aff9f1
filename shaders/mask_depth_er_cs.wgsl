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

struct abi_MaskParams {
    current: abi_CameraParams,
    previous: abi_CameraParams,
    light: vec4<f32>,
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
@group(0) @binding(6) 
var<storage> last_depths: type_21;
@group(0) @binding(7) 
var<storage, read_write> depths: type_21;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_153_: lt_bvh_traverse_Tree;
    var phi_154_: bool;
    var phi_155_: lt_bvh_traverse_Tree;
    var phi_156_: bool;
    var phi_161_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_153_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_154_ = false;
        } else {
            phi_153_ = lt_bvh_traverse_Tree();
            phi_154_ = true;
        }
        let _e56 = phi_153_;
        let _e58 = phi_154_;
        phi_155_ = _e56;
        phi_156_ = _e58;
    } else {
        phi_155_ = lt_bvh_traverse_Tree();
        phi_156_ = true;
    }
    let _e60 = phi_155_;
    let _e62 = phi_156_;
    if _e62 {
        phi_161_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_161_ = _e60;
    }
    let _e67 = phi_161_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_179_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_179_ = vec2(0i);
            break;
        }
        case 1: {
            phi_179_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_179_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_179_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_179_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e52 = phi_179_;
    return vec2<i32>(_e52.x, _e52.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_197_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_197_ = vec2(0i);
            break;
        }
        case 1: {
            phi_197_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_197_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_197_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_197_ = vec2(1i);
            break;
        }
    }
    let _e52 = phi_197_;
    return vec2<i32>(_e52.x, _e52.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_216_: vec2<i32>;

    if (param_6 == 0u) {
        let _e46 = lt_mask_pattern_plus(param_5);
        phi_216_ = vec2<i32>(_e46.x, _e46.y);
    } else {
        let _e50 = lt_mask_pattern_cross(param_5);
        phi_216_ = vec2<i32>(_e50.x, _e50.y);
    }
    let _e55 = phi_216_;
    return vec2<i32>(_e55.x, _e55.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_241_: vec2<i32>;

    let _e44 = (param_7 % 13u);
    switch bitcast<i32>(_e44) {
        case 9: {
            phi_241_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_241_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_241_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_241_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_241_ = vec2<i32>((bitcast<i32>((_e44 % 3u)) - 1i), (bitcast<i32>(((_e44 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e59 = phi_241_;
    return vec2<i32>(_e59.x, _e59.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_262_: u32;
    var phi_263_: u32;

    let _e47 = (bitcast<i32>(param_8) + param_9);
    if (_e47 < 0i) {
        phi_263_ = 0u;
    } else {
        if (_e47 >= bitcast<i32>(param_10)) {
            phi_262_ = (param_10 - 1u);
        } else {
            phi_262_ = bitcast<u32>(_e47);
        }
        let _e54 = phi_262_;
        phi_263_ = _e54;
    }
    let _e56 = phi_263_;
    return _e56;
}

fn function_() {
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_336_: bool;
    var phi_380_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_384_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_397_: bool;
    var phi_453_: bool;
    var phi_457_: f32;
    var phi_468_: bool;
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
    var phi_676_: lt_mask_Neighbourhood;
    var phi_701_: bool;
    var phi_702_: bool;
    var phi_715_: bool;
    var phi_716_: bool;
    var phi_717_: bool;
    var phi_724_: u32;
    var phi_725_: u32;
    var phi_726_: u32;
    var phi_727_: u32;
    var phi_728_: u32;
    var phi_736_: bool;
    var phi_744_: u32;
    var phi_749_: u32;
    var phi_753_: u32;
    var phi_754_: u32;
    var phi_758_: f32;
    var phi_760_: mask_Masked;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_791_: bool;
    var phi_795_: bool;
    var phi_823_: f32;
    var phi_826_: bool;
    var phi_827_: u32;
    var phi_838_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e43 = id_1;
    let _e44 = local_2;
    let _e60 = p.member.current.size[0u];
    let _e62 = p.member.current.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e43, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        let _e71 = p.member.current.size[0u];
        let _e74 = samples.member[_e63.first_primitive].position;
        let _e76 = visibility.member[_e63.first_primitive];
        let _e80 = p.member.light;
        let _e83 = samples.member[_e63.first_primitive].normal[0u];
        let _e85 = global[0u];
        if (_e83 == _e85) {
            let _e88 = samples.member[_e63.first_primitive].normal[1u];
            let _e90 = global[1u];
            if (_e88 == _e90) {
                let _e93 = samples.member[_e63.first_primitive].normal[2u];
                let _e95 = global[2u];
                phi_329_ = (_e93 == _e95);
                phi_330_ = false;
            } else {
                phi_329_ = bool();
                phi_330_ = true;
            }
            let _e98 = phi_329_;
            let _e100 = phi_330_;
            phi_331_ = _e98;
            phi_332_ = _e100;
        } else {
            phi_331_ = bool();
            phi_332_ = true;
        }
        let _e102 = phi_331_;
        let _e104 = phi_332_;
        if _e104 {
            phi_336_ = false;
        } else {
            phi_336_ = _e102;
        }
        let _e106 = phi_336_;
        if !(_e106) {
            let _e109 = samples.member[_e63.first_primitive].normal;
            let _e111 = samples.member[_e63.first_primitive].position;
            if ((((_e109.x * (_e80.x - (_e111.x * _e80.w))) + (_e109.y * (_e80.y - (_e111.y * _e80.w)))) + (_e109.z * (_e80.z - (_e111.z * _e80.w)))) > 0f) {
                let _e135 = samples.member[_e63.first_primitive].flags;
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e149 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e143.unnamed.visibility, false), _e143.unnamed_1);
                phi_380_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e149.unnamed, ((_e135 & 1u) == 0u));
            } else {
                let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e164 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e158.unnamed.visibility, false), _e158.unnamed_1);
                phi_380_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e164.unnamed, true);
            }
            let _e169 = phi_380_;
            phi_384_ = _e169;
        } else {
            let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e175.unnamed.visibility, false), _e175.unnamed_1);
            phi_384_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e181.unnamed, true);
        }
        let _e186 = phi_384_;
        if _e186.unnamed_1 {
            phi_760_ = mask_Masked(_e186.unnamed.visibility, 0u, false);
        } else {
            let _e191 = (_e76 < 0.5f);
            if (_e76 > 0f) {
                phi_397_ = (_e76 < 1f);
            } else {
                phi_397_ = false;
            }
            let _e195 = phi_397_;
            let _e198 = p.member.previous.eye;
            let _e209 = p.member.previous.forward;
            let _e217 = ((((_e74.x - _e198.x) * _e209.x) + ((_e74.y - _e198.y) * _e209.y)) + ((_e74.z - _e198.z) * _e209.z));
            let _e219 = ((_e43.y * _e71) + _e43.x);
            if (_e219 < arrayLength((&last_depths.member))) {
            } else {
                return;
            }
            let _e223 = last_depths.member[(0u + _e219)];
            let _e225 = p.member.depth_tolerance;
            let _e228 = abs(_e217);
            let _e229 = abs(_e223);
            if ((bitcast<u32>(_e229) & 2147483647u) > 2139095040u) {
                phi_453_ = true;
            } else {
                let _e233 = (_e229 > _e228);
                if _e233 {
                }
                phi_453_ = _e233;
            }
            let _e235 = phi_453_;
            if _e235 {
                phi_457_ = _e229;
            } else {
                phi_457_ = _e228;
            }
            let _e237 = phi_457_;
            if (abs((_e217 - _e223)) <= (_e225 * _e237)) {
                let _e241 = p.member.flags;
                phi_468_ = ((_e241 & 1u) != 0u);
            } else {
                phi_468_ = false;
            }
            let _e245 = phi_468_;
            if false {
            }
            let _e250 = lt_mask_Neighbourhood(false, true);
            if _e195 {
                phi_676_ = _e250;
            } else {
                if true {
                    if _e245 {
                        if false {
                            let _e252 = p.member.moving_pattern;
                            phi_494_ = _e252;
                        } else {
                            let _e254 = p.member.still_pattern;
                            phi_494_ = _e254;
                        }
                        let _e256 = phi_494_;
                        phi_496_ = 0u;
                        phi_499_ = _e250;
                        loop {
                            let _e258 = phi_496_;
                            let _e260 = phi_499_;
                            local_1 = _e260;
                            if (1u <= _e256) {
                                if (_e256 <= 4u) {
                                    phi_511_ = false;
                                } else {
                                    phi_511_ = true;
                                }
                                let _e264 = phi_511_;
                                phi_512_ = _e264;
                            } else {
                                phi_512_ = true;
                            }
                            let _e266 = phi_512_;
                            if _e266 {
                                switch bitcast<i32>(_e256) {
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
                                let _e269 = phi_521_;
                                phi_522_ = _e269;
                            } else {
                                phi_522_ = 5u;
                            }
                            let _e271 = phi_522_;
                            let _e272 = (_e258 < _e271);
                            if _e272 {
                                let _e274 = p.member.frame;
                                let _e278 = p.member.current.size[0u];
                                let _e280 = p.member.current.size[1u];
                                switch bitcast<i32>(_e256) {
                                    case 1: {
                                        let _e290 = lt_mask_pattern_plus(_e258);
                                        phi_602_ = vec2<i32>(_e290.x, _e290.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e294 = lt_mask_pattern_cross(_e258);
                                        phi_602_ = vec2<i32>(_e294.x, _e294.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e300 = lt_mask_pattern_plus_or_cross(_e258, ((_e43.x + _e43.y) & 1u));
                                        phi_602_ = vec2<i32>(_e300.x, _e300.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e305 = lt_mask_pattern_plus_or_cross(_e258, (_e274 & 1u));
                                        phi_602_ = vec2<i32>(_e305.x, _e305.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e274 & 3u)) {
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
                                        let _e316 = phi_582_;
                                        phi_602_ = (_e316 + vec2<i32>(bitcast<i32>((_e258 & 1u)), bitcast<i32>(((_e258 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_602_ = vec2<i32>((bitcast<i32>((_e258 % 5u)) - 2i), (bitcast<i32>(((_e258 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e333 = lt_mask_pattern_diamond(_e258);
                                        phi_602_ = vec2<i32>(_e333.x, _e333.y);
                                        break;
                                    }
                                    default: {
                                        phi_602_ = vec2<i32>((bitcast<i32>((_e258 % 3u)) - 1i), (bitcast<i32>(((_e258 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e338 = phi_602_;
                                let _e341 = lt_mask_pattern_step_clamped(_e43.x, _e338.x, _e278);
                                let _e342 = lt_mask_pattern_step_clamped(_e43.y, _e338.y, _e280);
                                let _e344 = ((_e342 * _e71) + _e341);
                                if (_e344 < arrayLength((&last_bits.member))) {
                                } else {
                                    return;
                                }
                                let _e348 = last_bits.member[(0u + _e344)];
                                if ((_e348 & 2u) == 0u) {
                                    phi_625_ = (_e348 & 1u);
                                } else {
                                    phi_625_ = (_e348 & 7u);
                                }
                                let _e354 = phi_625_;
                                if _e260.any_expands {
                                    phi_651_ = true;
                                } else {
                                    if ((_e354 & 2u) != 0u) {
                                        if (((_e354 & 4u) != 0u) != _e191) {
                                            phi_642_ = false;
                                        } else {
                                            phi_642_ = true;
                                        }
                                        let _e363 = phi_642_;
                                        phi_643_ = _e363;
                                    } else {
                                        phi_643_ = true;
                                    }
                                    let _e365 = phi_643_;
                                    if _e365 {
                                        phi_650_ = (((_e354 & 1u) != 0u) != _e191);
                                    } else {
                                        phi_650_ = true;
                                    }
                                    let _e370 = phi_650_;
                                    phi_651_ = _e370;
                                }
                                let _e372 = phi_651_;
                                if _e260.all_remove {
                                    if (((_e354 & 1u) != 0u) == _e191) {
                                        if ((_e354 & 2u) != 0u) {
                                            phi_669_ = (((_e354 & 4u) != 0u) == _e191);
                                        } else {
                                            phi_669_ = true;
                                        }
                                        let _e382 = phi_669_;
                                        phi_670_ = _e382;
                                    } else {
                                        phi_670_ = false;
                                    }
                                    let _e384 = phi_670_;
                                    phi_671_ = _e384;
                                } else {
                                    phi_671_ = false;
                                }
                                let _e386 = phi_671_;
                                phi_497_ = (_e258 + 1u);
                                phi_500_ = lt_mask_Neighbourhood(_e372, _e386);
                            } else {
                                phi_497_ = u32();
                                phi_500_ = lt_mask_Neighbourhood();
                            }
                            let _e390 = phi_497_;
                            let _e392 = phi_500_;
                            continue;
                            continuing {
                                phi_496_ = _e390;
                                phi_499_ = _e392;
                                break if !(_e272);
                            }
                        }
                        let _e556 = local_1;
                        phi_674_ = _e556;
                    } else {
                        phi_674_ = _e250;
                    }
                    let _e395 = phi_674_;
                    phi_675_ = _e395;
                } else {
                    phi_675_ = _e250;
                }
                let _e397 = phi_675_;
                phi_676_ = _e397;
            }
            let _e399 = phi_676_;
            if (_e76 != 0.5f) {
                if _e245 {
                    if _e195 {
                        phi_702_ = true;
                    } else {
                        if _e399.any_expands {
                            phi_701_ = false;
                        } else {
                            phi_701_ = true;
                        }
                        let _e404 = phi_701_;
                        phi_702_ = _e404;
                    }
                    let _e406 = phi_702_;
                    if _e406 {
                        if _e195 {
                            if false {
                                if _e399.all_remove {
                                    phi_715_ = false;
                                } else {
                                    phi_715_ = true;
                                }
                                let _e408 = phi_715_;
                                phi_716_ = _e408;
                            } else {
                                phi_716_ = true;
                            }
                            let _e410 = phi_716_;
                            phi_717_ = _e410;
                        } else {
                            phi_717_ = true;
                        }
                        let _e412 = phi_717_;
                        if _e412 {
                            if _e195 {
                                phi_724_ = 1u;
                            } else {
                                phi_724_ = 0u;
                            }
                            let _e414 = phi_724_;
                            phi_725_ = _e414;
                        } else {
                            phi_725_ = 5u;
                        }
                        let _e416 = phi_725_;
                        phi_726_ = _e416;
                    } else {
                        phi_726_ = 4u;
                    }
                    let _e418 = phi_726_;
                    phi_727_ = _e418;
                } else {
                    phi_727_ = 3u;
                }
                let _e420 = phi_727_;
                phi_728_ = _e420;
            } else {
                phi_728_ = 2u;
            }
            let _e422 = phi_728_;
            if !((_e422 == 0u)) {
                phi_736_ = !((_e422 == 5u));
            } else {
                phi_736_ = false;
            }
            let _e428 = phi_736_;
            if _e428 {
                if _e191 {
                    phi_744_ = (2u | 1u);
                } else {
                    phi_744_ = 2u;
                }
                let _e431 = phi_744_;
                if false {
                    phi_749_ = (_e431 | 4u);
                } else {
                    phi_749_ = _e431;
                }
                let _e434 = phi_749_;
                phi_754_ = _e434;
            } else {
                if _e191 {
                    phi_753_ = 1u;
                } else {
                    phi_753_ = 0u;
                }
                let _e436 = phi_753_;
                phi_754_ = _e436;
            }
            let _e438 = phi_754_;
            if _e191 {
                phi_758_ = 0f;
            } else {
                phi_758_ = 1f;
            }
            let _e440 = phi_758_;
            phi_760_ = mask_Masked(_e440, _e438, _e428);
        }
        let _e443 = phi_760_;
        visibility.member[_e63.first_primitive] = _e443.visibility;
        bits.member[_e63.first_primitive] = _e443.bits;
        let _e451 = samples.member[_e63.first_primitive].normal[0u];
        let _e453 = global[0u];
        if (_e451 == _e453) {
            let _e456 = samples.member[_e63.first_primitive].normal[1u];
            let _e458 = global[1u];
            if (_e456 == _e458) {
                let _e461 = samples.member[_e63.first_primitive].normal[2u];
                let _e463 = global[2u];
                phi_788_ = (_e461 == _e463);
                phi_789_ = false;
            } else {
                phi_788_ = bool();
                phi_789_ = true;
            }
            let _e466 = phi_788_;
            let _e468 = phi_789_;
            phi_790_ = _e466;
            phi_791_ = _e468;
        } else {
            phi_790_ = bool();
            phi_791_ = true;
        }
        let _e470 = phi_790_;
        let _e472 = phi_791_;
        if _e472 {
            phi_795_ = false;
        } else {
            phi_795_ = _e470;
        }
        let _e474 = phi_795_;
        if !(_e474) {
            let _e477 = samples.member[_e63.first_primitive].position;
            let _e479 = p.member.current.eye;
            let _e490 = p.member.current.forward;
            phi_823_ = ((((_e477.x - _e479.x) * _e490.x) + ((_e477.y - _e479.y) * _e490.y)) + ((_e477.z - _e479.z) * _e490.z));
        } else {
            phi_823_ = 0f;
        }
        let _e500 = phi_823_;
        depths.member[_e63.first_primitive] = _e500;
        phi_826_ = _e443.needs_ray;
        phi_827_ = _e63.first_primitive;
    } else {
        phi_826_ = false;
        phi_827_ = 0u;
    }
    let _e504 = phi_826_;
    let _e506 = phi_827_;
    if (_e44 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e504 {
        let _e510 = atomicAdd((&shared_[0u]), 1u);
        phi_838_ = _e510;
    } else {
        phi_838_ = 0u;
    }
    let _e512 = phi_838_;
    workgroupBarrier();
    if (_e44 == 0u) {
        let _e516 = atomicLoad((&shared_[0u]));
        let _e517 = atomicAdd((&list.member[3u]), _e516);
        atomicStore((&shared_[1u]), _e517);
    }
    workgroupBarrier();
    if _e504 {
        let _e520 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e520) + _e512)]), _e506);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
