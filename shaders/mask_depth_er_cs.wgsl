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

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_156_: lt_bvh_traverse_Tree;
    var phi_157_: bool;
    var phi_158_: lt_bvh_traverse_Tree;
    var phi_159_: bool;
    var phi_164_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_156_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_157_ = false;
        } else {
            phi_156_ = lt_bvh_traverse_Tree();
            phi_157_ = true;
        }
        let _e56 = phi_156_;
        let _e58 = phi_157_;
        phi_158_ = _e56;
        phi_159_ = _e58;
    } else {
        phi_158_ = lt_bvh_traverse_Tree();
        phi_159_ = true;
    }
    let _e60 = phi_158_;
    let _e62 = phi_159_;
    if _e62 {
        phi_164_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_164_ = _e60;
    }
    let _e67 = phi_164_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_182_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_182_ = vec2(0i);
            break;
        }
        case 1: {
            phi_182_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_182_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_182_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_182_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e52 = phi_182_;
    return vec2<i32>(_e52.x, _e52.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_200_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_200_ = vec2(0i);
            break;
        }
        case 1: {
            phi_200_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_200_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_200_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_200_ = vec2(1i);
            break;
        }
    }
    let _e52 = phi_200_;
    return vec2<i32>(_e52.x, _e52.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_219_: vec2<i32>;

    if (param_6 == 0u) {
        let _e46 = lt_mask_pattern_plus(param_5);
        phi_219_ = vec2<i32>(_e46.x, _e46.y);
    } else {
        let _e50 = lt_mask_pattern_cross(param_5);
        phi_219_ = vec2<i32>(_e50.x, _e50.y);
    }
    let _e55 = phi_219_;
    return vec2<i32>(_e55.x, _e55.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_244_: vec2<i32>;

    let _e44 = (param_7 % 13u);
    switch bitcast<i32>(_e44) {
        case 9: {
            phi_244_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_244_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_244_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_244_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_244_ = vec2<i32>((bitcast<i32>((_e44 % 3u)) - 1i), (bitcast<i32>(((_e44 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e59 = phi_244_;
    return vec2<i32>(_e59.x, _e59.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_265_: u32;
    var phi_266_: u32;

    let _e47 = (bitcast<i32>(param_8) + param_9);
    if (_e47 < 0i) {
        phi_266_ = 0u;
    } else {
        if (_e47 >= bitcast<i32>(param_10)) {
            phi_265_ = (param_10 - 1u);
        } else {
            phi_265_ = bitcast<u32>(_e47);
        }
        let _e54 = phi_265_;
        phi_266_ = _e54;
    }
    let _e56 = phi_266_;
    return _e56;
}

fn function_() {
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_333_: bool;
    var phi_334_: bool;
    var phi_338_: bool;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_420_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_421_: bool;
    var phi_422_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_423_: bool;
    var phi_430_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_434_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_447_: bool;
    var phi_503_: bool;
    var phi_507_: f32;
    var phi_518_: bool;
    var phi_544_: u32;
    var phi_546_: u32;
    var phi_549_: lt_mask_Neighbourhood;
    var phi_561_: bool;
    var phi_562_: bool;
    var phi_571_: u32;
    var phi_572_: u32;
    var phi_632_: vec2<i32>;
    var phi_652_: vec2<i32>;
    var phi_675_: u32;
    var phi_692_: bool;
    var phi_693_: bool;
    var phi_700_: bool;
    var phi_701_: bool;
    var phi_719_: bool;
    var phi_720_: bool;
    var phi_721_: bool;
    var phi_547_: u32;
    var phi_550_: lt_mask_Neighbourhood;
    var phi_724_: lt_mask_Neighbourhood;
    var phi_725_: lt_mask_Neighbourhood;
    var phi_726_: lt_mask_Neighbourhood;
    var phi_751_: bool;
    var phi_752_: bool;
    var phi_765_: bool;
    var phi_766_: bool;
    var phi_767_: bool;
    var phi_774_: u32;
    var phi_775_: u32;
    var phi_776_: u32;
    var phi_777_: u32;
    var phi_778_: u32;
    var phi_786_: bool;
    var phi_794_: u32;
    var phi_799_: u32;
    var phi_803_: u32;
    var phi_804_: u32;
    var phi_808_: f32;
    var phi_810_: mask_Masked;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_845_: bool;
    var phi_873_: f32;
    var phi_876_: bool;
    var phi_877_: u32;
    var phi_888_: u32;
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
        let _e82 = samples.member[_e63.first_primitive].normal[0u];
        let _e84 = global[0u];
        if (_e82 == _e84) {
            let _e87 = samples.member[_e63.first_primitive].normal[1u];
            let _e89 = global[1u];
            if (_e87 == _e89) {
                let _e92 = samples.member[_e63.first_primitive].normal[2u];
                let _e94 = global[2u];
                phi_331_ = (_e92 == _e94);
                phi_332_ = false;
            } else {
                phi_331_ = bool();
                phi_332_ = true;
            }
            let _e97 = phi_331_;
            let _e99 = phi_332_;
            phi_333_ = _e97;
            phi_334_ = _e99;
        } else {
            phi_333_ = bool();
            phi_334_ = true;
        }
        let _e101 = phi_333_;
        let _e103 = phi_334_;
        if _e103 {
            phi_338_ = false;
        } else {
            phi_338_ = _e101;
        }
        let _e105 = phi_338_;
        if !(_e105) {
            let _e108 = samples.member[_e63.first_primitive].position;
            let _e110 = p.member.light.place;
            let _e116 = p.member.light.place[3u];
            let _e123 = (_e110.x - (_e108.x * _e116));
            let _e124 = (_e110.y - (_e108.y * _e116));
            let _e125 = (_e110.z - (_e108.z * _e116));
            let _e127 = samples.member[_e63.first_primitive].normal;
            if ((((_e127.x * _e123) + (_e127.y * _e124)) + (_e127.z * _e125)) > 0f) {
                let _e141 = (((_e123 * _e123) + (_e124 * _e124)) + (_e125 * _e125));
                let _e143 = p.member.light.axis;
                let _e155 = p.member.light.place[3u];
                if (_e155 == 0f) {
                    phi_409_ = true;
                } else {
                    let _e158 = p.member.light.range_squared;
                    if (_e141 <= _e158) {
                        let _e161 = p.member.light.cos_outer;
                        phi_408_ = (-((((_e123 * _e143.x) + (_e124 * _e143.y)) + (_e125 * _e143.z))) >= (_e161 * sqrt(_e141)));
                    } else {
                        phi_408_ = false;
                    }
                    let _e166 = phi_408_;
                    phi_409_ = _e166;
                }
                let _e168 = phi_409_;
                if _e168 {
                    let _e170 = samples.member[_e63.first_primitive].flags;
                    let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e178.unnamed.visibility, false), _e178.unnamed_1);
                    phi_420_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e184.unnamed, ((_e170 & 1u) == 0u));
                    phi_421_ = false;
                } else {
                    phi_420_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_421_ = true;
                }
                let _e189 = phi_420_;
                let _e191 = phi_421_;
                phi_422_ = _e189;
                phi_423_ = _e191;
            } else {
                phi_422_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_423_ = true;
            }
            let _e193 = phi_422_;
            let _e195 = phi_423_;
            if _e195 {
                let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e201.unnamed.visibility, false), _e201.unnamed_1);
                phi_430_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e207.unnamed, true);
            } else {
                phi_430_ = _e193;
            }
            let _e212 = phi_430_;
            phi_434_ = _e212;
        } else {
            let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e224 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e218.unnamed.visibility, false), _e218.unnamed_1);
            phi_434_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e224.unnamed, true);
        }
        let _e229 = phi_434_;
        if _e229.unnamed_1 {
            phi_810_ = mask_Masked(_e229.unnamed.visibility, 0u, false);
        } else {
            let _e234 = (_e76 < 0.5f);
            if (_e76 > 0f) {
                phi_447_ = (_e76 < 1f);
            } else {
                phi_447_ = false;
            }
            let _e238 = phi_447_;
            let _e241 = p.member.previous.eye;
            let _e252 = p.member.previous.forward;
            let _e260 = ((((_e74.x - _e241.x) * _e252.x) + ((_e74.y - _e241.y) * _e252.y)) + ((_e74.z - _e241.z) * _e252.z));
            let _e262 = ((_e43.y * _e71) + _e43.x);
            if (_e262 < arrayLength((&last_depths.member))) {
            } else {
                return;
            }
            let _e266 = last_depths.member[(0u + _e262)];
            let _e268 = p.member.depth_tolerance;
            let _e271 = abs(_e260);
            let _e272 = abs(_e266);
            if ((bitcast<u32>(_e272) & 2147483647u) > 2139095040u) {
                phi_503_ = true;
            } else {
                let _e276 = (_e272 > _e271);
                if _e276 {
                }
                phi_503_ = _e276;
            }
            let _e278 = phi_503_;
            if _e278 {
                phi_507_ = _e272;
            } else {
                phi_507_ = _e271;
            }
            let _e280 = phi_507_;
            if (abs((_e260 - _e266)) <= (_e268 * _e280)) {
                let _e284 = p.member.flags;
                phi_518_ = ((_e284 & 1u) != 0u);
            } else {
                phi_518_ = false;
            }
            let _e288 = phi_518_;
            if false {
            }
            let _e293 = lt_mask_Neighbourhood(false, true);
            if _e238 {
                phi_726_ = _e293;
            } else {
                if true {
                    if _e288 {
                        if false {
                            let _e295 = p.member.moving_pattern;
                            phi_544_ = _e295;
                        } else {
                            let _e297 = p.member.still_pattern;
                            phi_544_ = _e297;
                        }
                        let _e299 = phi_544_;
                        phi_546_ = 0u;
                        phi_549_ = _e293;
                        loop {
                            let _e301 = phi_546_;
                            let _e303 = phi_549_;
                            local_1 = _e303;
                            if (1u <= _e299) {
                                if (_e299 <= 4u) {
                                    phi_561_ = false;
                                } else {
                                    phi_561_ = true;
                                }
                                let _e307 = phi_561_;
                                phi_562_ = _e307;
                            } else {
                                phi_562_ = true;
                            }
                            let _e309 = phi_562_;
                            if _e309 {
                                switch bitcast<i32>(_e299) {
                                    case 5: {
                                        phi_571_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_571_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_571_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_571_ = 9u;
                                        break;
                                    }
                                }
                                let _e312 = phi_571_;
                                phi_572_ = _e312;
                            } else {
                                phi_572_ = 5u;
                            }
                            let _e314 = phi_572_;
                            let _e315 = (_e301 < _e314);
                            if _e315 {
                                let _e317 = p.member.frame;
                                let _e321 = p.member.current.size[0u];
                                let _e323 = p.member.current.size[1u];
                                switch bitcast<i32>(_e299) {
                                    case 1: {
                                        let _e333 = lt_mask_pattern_plus(_e301);
                                        phi_652_ = vec2<i32>(_e333.x, _e333.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e337 = lt_mask_pattern_cross(_e301);
                                        phi_652_ = vec2<i32>(_e337.x, _e337.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e343 = lt_mask_pattern_plus_or_cross(_e301, ((_e43.x + _e43.y) & 1u));
                                        phi_652_ = vec2<i32>(_e343.x, _e343.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e348 = lt_mask_pattern_plus_or_cross(_e301, (_e317 & 1u));
                                        phi_652_ = vec2<i32>(_e348.x, _e348.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e317 & 3u)) {
                                            case 0: {
                                                phi_632_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_632_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_632_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_632_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e359 = phi_632_;
                                        phi_652_ = (_e359 + vec2<i32>(bitcast<i32>((_e301 & 1u)), bitcast<i32>(((_e301 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_652_ = vec2<i32>((bitcast<i32>((_e301 % 5u)) - 2i), (bitcast<i32>(((_e301 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e376 = lt_mask_pattern_diamond(_e301);
                                        phi_652_ = vec2<i32>(_e376.x, _e376.y);
                                        break;
                                    }
                                    default: {
                                        phi_652_ = vec2<i32>((bitcast<i32>((_e301 % 3u)) - 1i), (bitcast<i32>(((_e301 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e381 = phi_652_;
                                let _e384 = lt_mask_pattern_step_clamped(_e43.x, _e381.x, _e321);
                                let _e385 = lt_mask_pattern_step_clamped(_e43.y, _e381.y, _e323);
                                let _e387 = ((_e385 * _e71) + _e384);
                                if (_e387 < arrayLength((&last_bits.member))) {
                                } else {
                                    return;
                                }
                                let _e391 = last_bits.member[(0u + _e387)];
                                if ((_e391 & 2u) == 0u) {
                                    phi_675_ = (_e391 & 1u);
                                } else {
                                    phi_675_ = (_e391 & 7u);
                                }
                                let _e397 = phi_675_;
                                if _e303.any_expands {
                                    phi_701_ = true;
                                } else {
                                    if ((_e397 & 2u) != 0u) {
                                        if (((_e397 & 4u) != 0u) != _e234) {
                                            phi_692_ = false;
                                        } else {
                                            phi_692_ = true;
                                        }
                                        let _e406 = phi_692_;
                                        phi_693_ = _e406;
                                    } else {
                                        phi_693_ = true;
                                    }
                                    let _e408 = phi_693_;
                                    if _e408 {
                                        phi_700_ = (((_e397 & 1u) != 0u) != _e234);
                                    } else {
                                        phi_700_ = true;
                                    }
                                    let _e413 = phi_700_;
                                    phi_701_ = _e413;
                                }
                                let _e415 = phi_701_;
                                if _e303.all_remove {
                                    if (((_e397 & 1u) != 0u) == _e234) {
                                        if ((_e397 & 2u) != 0u) {
                                            phi_719_ = (((_e397 & 4u) != 0u) == _e234);
                                        } else {
                                            phi_719_ = true;
                                        }
                                        let _e425 = phi_719_;
                                        phi_720_ = _e425;
                                    } else {
                                        phi_720_ = false;
                                    }
                                    let _e427 = phi_720_;
                                    phi_721_ = _e427;
                                } else {
                                    phi_721_ = false;
                                }
                                let _e429 = phi_721_;
                                phi_547_ = (_e301 + 1u);
                                phi_550_ = lt_mask_Neighbourhood(_e415, _e429);
                            } else {
                                phi_547_ = u32();
                                phi_550_ = lt_mask_Neighbourhood();
                            }
                            let _e433 = phi_547_;
                            let _e435 = phi_550_;
                            continue;
                            continuing {
                                phi_546_ = _e433;
                                phi_549_ = _e435;
                                break if !(_e315);
                            }
                        }
                        let _e605 = local_1;
                        phi_724_ = _e605;
                    } else {
                        phi_724_ = _e293;
                    }
                    let _e438 = phi_724_;
                    phi_725_ = _e438;
                } else {
                    phi_725_ = _e293;
                }
                let _e440 = phi_725_;
                phi_726_ = _e440;
            }
            let _e442 = phi_726_;
            if (_e76 != 0.5f) {
                if _e288 {
                    if _e238 {
                        phi_752_ = true;
                    } else {
                        if _e442.any_expands {
                            phi_751_ = false;
                        } else {
                            phi_751_ = true;
                        }
                        let _e447 = phi_751_;
                        phi_752_ = _e447;
                    }
                    let _e449 = phi_752_;
                    if _e449 {
                        if _e238 {
                            if false {
                                if _e442.all_remove {
                                    phi_765_ = false;
                                } else {
                                    phi_765_ = true;
                                }
                                let _e451 = phi_765_;
                                phi_766_ = _e451;
                            } else {
                                phi_766_ = true;
                            }
                            let _e453 = phi_766_;
                            phi_767_ = _e453;
                        } else {
                            phi_767_ = true;
                        }
                        let _e455 = phi_767_;
                        if _e455 {
                            if _e238 {
                                phi_774_ = 1u;
                            } else {
                                phi_774_ = 0u;
                            }
                            let _e457 = phi_774_;
                            phi_775_ = _e457;
                        } else {
                            phi_775_ = 5u;
                        }
                        let _e459 = phi_775_;
                        phi_776_ = _e459;
                    } else {
                        phi_776_ = 4u;
                    }
                    let _e461 = phi_776_;
                    phi_777_ = _e461;
                } else {
                    phi_777_ = 3u;
                }
                let _e463 = phi_777_;
                phi_778_ = _e463;
            } else {
                phi_778_ = 2u;
            }
            let _e465 = phi_778_;
            if !((_e465 == 0u)) {
                phi_786_ = !((_e465 == 5u));
            } else {
                phi_786_ = false;
            }
            let _e471 = phi_786_;
            if _e471 {
                if _e234 {
                    phi_794_ = (2u | 1u);
                } else {
                    phi_794_ = 2u;
                }
                let _e474 = phi_794_;
                if false {
                    phi_799_ = (_e474 | 4u);
                } else {
                    phi_799_ = _e474;
                }
                let _e477 = phi_799_;
                phi_804_ = _e477;
            } else {
                if _e234 {
                    phi_803_ = 1u;
                } else {
                    phi_803_ = 0u;
                }
                let _e479 = phi_803_;
                phi_804_ = _e479;
            }
            let _e481 = phi_804_;
            if _e234 {
                phi_808_ = 0f;
            } else {
                phi_808_ = 1f;
            }
            let _e483 = phi_808_;
            phi_810_ = mask_Masked(_e483, _e481, _e471);
        }
        let _e486 = phi_810_;
        visibility.member[_e63.first_primitive] = _e486.visibility;
        bits.member[_e63.first_primitive] = _e486.bits;
        let _e494 = samples.member[_e63.first_primitive].normal[0u];
        let _e496 = global[0u];
        if (_e494 == _e496) {
            let _e499 = samples.member[_e63.first_primitive].normal[1u];
            let _e501 = global[1u];
            if (_e499 == _e501) {
                let _e504 = samples.member[_e63.first_primitive].normal[2u];
                let _e506 = global[2u];
                phi_838_ = (_e504 == _e506);
                phi_839_ = false;
            } else {
                phi_838_ = bool();
                phi_839_ = true;
            }
            let _e509 = phi_838_;
            let _e511 = phi_839_;
            phi_840_ = _e509;
            phi_841_ = _e511;
        } else {
            phi_840_ = bool();
            phi_841_ = true;
        }
        let _e513 = phi_840_;
        let _e515 = phi_841_;
        if _e515 {
            phi_845_ = false;
        } else {
            phi_845_ = _e513;
        }
        let _e517 = phi_845_;
        if !(_e517) {
            let _e520 = samples.member[_e63.first_primitive].position;
            let _e522 = p.member.current.eye;
            let _e533 = p.member.current.forward;
            phi_873_ = ((((_e520.x - _e522.x) * _e533.x) + ((_e520.y - _e522.y) * _e533.y)) + ((_e520.z - _e522.z) * _e533.z));
        } else {
            phi_873_ = 0f;
        }
        let _e543 = phi_873_;
        depths.member[_e63.first_primitive] = _e543;
        phi_876_ = _e486.needs_ray;
        phi_877_ = _e63.first_primitive;
    } else {
        phi_876_ = false;
        phi_877_ = 0u;
    }
    let _e547 = phi_876_;
    let _e549 = phi_877_;
    if (_e44 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e547 {
        let _e553 = atomicAdd((&shared_[0u]), 1u);
        phi_888_ = _e553;
    } else {
        phi_888_ = 0u;
    }
    let _e555 = phi_888_;
    workgroupBarrier();
    if (_e44 == 0u) {
        let _e559 = atomicLoad((&shared_[0u]));
        let _e560 = atomicAdd((&list.member[3u]), _e559);
        atomicStore((&shared_[1u]), _e560);
    }
    workgroupBarrier();
    if _e547 {
        let _e563 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e563) + _e555)]), _e549);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
