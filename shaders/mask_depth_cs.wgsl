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
    var phi_531_: bool;
    var phi_542_: bool;
    var phi_543_: bool;
    var phi_544_: bool;
    var phi_545_: bool;
    var phi_546_: bool;
    var phi_547_: bool;
    var phi_551_: bool;
    var phi_556_: bool;
    var phi_570_: u32;
    var phi_572_: u32;
    var phi_575_: lt_mask_Neighbourhood;
    var phi_587_: bool;
    var phi_588_: bool;
    var phi_597_: u32;
    var phi_598_: u32;
    var phi_658_: vec2<i32>;
    var phi_678_: vec2<i32>;
    var phi_701_: u32;
    var phi_718_: bool;
    var phi_719_: bool;
    var phi_726_: bool;
    var phi_727_: bool;
    var phi_745_: bool;
    var phi_746_: bool;
    var phi_747_: bool;
    var phi_573_: u32;
    var phi_576_: lt_mask_Neighbourhood;
    var phi_750_: lt_mask_Neighbourhood;
    var phi_751_: lt_mask_Neighbourhood;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_790_: bool;
    var phi_791_: bool;
    var phi_792_: bool;
    var phi_799_: u32;
    var phi_800_: u32;
    var phi_801_: u32;
    var phi_802_: u32;
    var phi_803_: u32;
    var phi_811_: bool;
    var phi_819_: u32;
    var phi_824_: u32;
    var phi_828_: u32;
    var phi_829_: u32;
    var phi_833_: f32;
    var phi_835_: mask_Masked;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_865_: bool;
    var phi_866_: bool;
    var phi_870_: bool;
    var phi_898_: f32;
    var phi_901_: bool;
    var phi_902_: u32;
    var phi_913_: u32;
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
            phi_835_ = mask_Masked(_e229.unnamed.visibility, 0u, false);
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
            let _e290 = p.member.flags;
            if false {
                let _e294 = p.member.flags;
                phi_531_ = ((_e294 & 4u) == 0u);
            } else {
                phi_531_ = false;
            }
            let _e298 = phi_531_;
            if ((_e290 & 2u) != 0u) {
                if false {
                    phi_544_ = bool();
                    phi_545_ = true;
                } else {
                    if true {
                        phi_542_ = !(_e298);
                        phi_543_ = false;
                    } else {
                        phi_542_ = bool();
                        phi_543_ = true;
                    }
                    let _e301 = phi_542_;
                    let _e303 = phi_543_;
                    phi_544_ = _e301;
                    phi_545_ = _e303;
                }
                let _e305 = phi_544_;
                let _e307 = phi_545_;
                phi_546_ = _e305;
                phi_547_ = _e307;
            } else {
                phi_546_ = bool();
                phi_547_ = true;
            }
            let _e309 = phi_546_;
            let _e311 = phi_547_;
            if _e311 {
                phi_551_ = false;
            } else {
                phi_551_ = _e309;
            }
            let _e313 = phi_551_;
            let _e314 = lt_mask_Neighbourhood(false, true);
            if _e238 {
                phi_556_ = _e313;
            } else {
                phi_556_ = true;
            }
            let _e316 = phi_556_;
            if _e316 {
                if _e288 {
                    if false {
                        let _e318 = p.member.moving_pattern;
                        phi_570_ = _e318;
                    } else {
                        let _e320 = p.member.still_pattern;
                        phi_570_ = _e320;
                    }
                    let _e322 = phi_570_;
                    phi_572_ = 0u;
                    phi_575_ = _e314;
                    loop {
                        let _e324 = phi_572_;
                        let _e326 = phi_575_;
                        local_1 = _e326;
                        if (1u <= _e322) {
                            if (_e322 <= 4u) {
                                phi_587_ = false;
                            } else {
                                phi_587_ = true;
                            }
                            let _e330 = phi_587_;
                            phi_588_ = _e330;
                        } else {
                            phi_588_ = true;
                        }
                        let _e332 = phi_588_;
                        if _e332 {
                            switch bitcast<i32>(_e322) {
                                case 5: {
                                    phi_597_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_597_ = 25u;
                                    break;
                                }
                                case 7: {
                                    phi_597_ = 13u;
                                    break;
                                }
                                default: {
                                    phi_597_ = 9u;
                                    break;
                                }
                            }
                            let _e335 = phi_597_;
                            phi_598_ = _e335;
                        } else {
                            phi_598_ = 5u;
                        }
                        let _e337 = phi_598_;
                        let _e338 = (_e324 < _e337);
                        if _e338 {
                            let _e340 = p.member.frame;
                            let _e344 = p.member.current.size[0u];
                            let _e346 = p.member.current.size[1u];
                            switch bitcast<i32>(_e322) {
                                case 1: {
                                    let _e356 = lt_mask_pattern_plus(_e324);
                                    phi_678_ = vec2<i32>(_e356.x, _e356.y);
                                    break;
                                }
                                case 2: {
                                    let _e360 = lt_mask_pattern_cross(_e324);
                                    phi_678_ = vec2<i32>(_e360.x, _e360.y);
                                    break;
                                }
                                case 3: {
                                    let _e366 = lt_mask_pattern_plus_or_cross(_e324, ((_e43.x + _e43.y) & 1u));
                                    phi_678_ = vec2<i32>(_e366.x, _e366.y);
                                    break;
                                }
                                case 4: {
                                    let _e371 = lt_mask_pattern_plus_or_cross(_e324, (_e340 & 1u));
                                    phi_678_ = vec2<i32>(_e371.x, _e371.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e340 & 3u)) {
                                        case 0: {
                                            phi_658_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_658_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_658_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_658_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e382 = phi_658_;
                                    phi_678_ = (_e382 + vec2<i32>(bitcast<i32>((_e324 & 1u)), bitcast<i32>(((_e324 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_678_ = vec2<i32>((bitcast<i32>((_e324 % 5u)) - 2i), (bitcast<i32>(((_e324 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                case 7: {
                                    let _e399 = lt_mask_pattern_diamond(_e324);
                                    phi_678_ = vec2<i32>(_e399.x, _e399.y);
                                    break;
                                }
                                default: {
                                    phi_678_ = vec2<i32>((bitcast<i32>((_e324 % 3u)) - 1i), (bitcast<i32>(((_e324 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e404 = phi_678_;
                            let _e407 = lt_mask_pattern_step_clamped(_e43.x, _e404.x, _e344);
                            let _e408 = lt_mask_pattern_step_clamped(_e43.y, _e404.y, _e346);
                            let _e410 = ((_e408 * _e71) + _e407);
                            if (_e410 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e414 = last_bits.member[(0u + _e410)];
                            if ((_e414 & 2u) == 0u) {
                                phi_701_ = (_e414 & 1u);
                            } else {
                                phi_701_ = (_e414 & 7u);
                            }
                            let _e420 = phi_701_;
                            if _e326.any_expands {
                                phi_727_ = true;
                            } else {
                                if ((_e420 & 2u) != 0u) {
                                    if (((_e420 & 4u) != 0u) != _e234) {
                                        phi_718_ = false;
                                    } else {
                                        phi_718_ = true;
                                    }
                                    let _e429 = phi_718_;
                                    phi_719_ = _e429;
                                } else {
                                    phi_719_ = true;
                                }
                                let _e431 = phi_719_;
                                if _e431 {
                                    phi_726_ = (((_e420 & 1u) != 0u) != _e234);
                                } else {
                                    phi_726_ = true;
                                }
                                let _e436 = phi_726_;
                                phi_727_ = _e436;
                            }
                            let _e438 = phi_727_;
                            if _e326.all_remove {
                                if (((_e420 & 1u) != 0u) == _e234) {
                                    if ((_e420 & 2u) != 0u) {
                                        phi_745_ = (((_e420 & 4u) != 0u) == _e234);
                                    } else {
                                        phi_745_ = true;
                                    }
                                    let _e448 = phi_745_;
                                    phi_746_ = _e448;
                                } else {
                                    phi_746_ = false;
                                }
                                let _e450 = phi_746_;
                                phi_747_ = _e450;
                            } else {
                                phi_747_ = false;
                            }
                            let _e452 = phi_747_;
                            phi_573_ = (_e324 + 1u);
                            phi_576_ = lt_mask_Neighbourhood(_e438, _e452);
                        } else {
                            phi_573_ = u32();
                            phi_576_ = lt_mask_Neighbourhood();
                        }
                        let _e456 = phi_573_;
                        let _e458 = phi_576_;
                        continue;
                        continuing {
                            phi_572_ = _e456;
                            phi_575_ = _e458;
                            break if !(_e338);
                        }
                    }
                    let _e635 = local_1;
                    phi_750_ = _e635;
                } else {
                    phi_750_ = _e314;
                }
                let _e461 = phi_750_;
                phi_751_ = _e461;
            } else {
                phi_751_ = _e314;
            }
            let _e463 = phi_751_;
            if (_e76 != 0.5f) {
                if _e288 {
                    if _e238 {
                        phi_777_ = true;
                    } else {
                        if _e463.any_expands {
                            phi_776_ = false;
                        } else {
                            phi_776_ = true;
                        }
                        let _e468 = phi_776_;
                        phi_777_ = _e468;
                    }
                    let _e470 = phi_777_;
                    if _e470 {
                        if _e238 {
                            if _e313 {
                                if _e463.all_remove {
                                    phi_790_ = false;
                                } else {
                                    phi_790_ = true;
                                }
                                let _e472 = phi_790_;
                                phi_791_ = _e472;
                            } else {
                                phi_791_ = true;
                            }
                            let _e474 = phi_791_;
                            phi_792_ = _e474;
                        } else {
                            phi_792_ = true;
                        }
                        let _e476 = phi_792_;
                        if _e476 {
                            if _e238 {
                                phi_799_ = 1u;
                            } else {
                                phi_799_ = 0u;
                            }
                            let _e478 = phi_799_;
                            phi_800_ = _e478;
                        } else {
                            phi_800_ = 5u;
                        }
                        let _e480 = phi_800_;
                        phi_801_ = _e480;
                    } else {
                        phi_801_ = 4u;
                    }
                    let _e482 = phi_801_;
                    phi_802_ = _e482;
                } else {
                    phi_802_ = 3u;
                }
                let _e484 = phi_802_;
                phi_803_ = _e484;
            } else {
                phi_803_ = 2u;
            }
            let _e486 = phi_803_;
            if !((_e486 == 0u)) {
                phi_811_ = !((_e486 == 5u));
            } else {
                phi_811_ = false;
            }
            let _e492 = phi_811_;
            if _e492 {
                if _e234 {
                    phi_819_ = (2u | 1u);
                } else {
                    phi_819_ = 2u;
                }
                let _e495 = phi_819_;
                if false {
                    phi_824_ = (_e495 | 4u);
                } else {
                    phi_824_ = _e495;
                }
                let _e498 = phi_824_;
                phi_829_ = _e498;
            } else {
                if _e234 {
                    phi_828_ = 1u;
                } else {
                    phi_828_ = 0u;
                }
                let _e500 = phi_828_;
                phi_829_ = _e500;
            }
            let _e502 = phi_829_;
            if _e234 {
                phi_833_ = 0f;
            } else {
                phi_833_ = 1f;
            }
            let _e504 = phi_833_;
            phi_835_ = mask_Masked(_e504, _e502, _e492);
        }
        let _e507 = phi_835_;
        visibility.member[_e63.first_primitive] = _e507.visibility;
        bits.member[_e63.first_primitive] = _e507.bits;
        let _e515 = samples.member[_e63.first_primitive].normal[0u];
        let _e517 = global[0u];
        if (_e515 == _e517) {
            let _e520 = samples.member[_e63.first_primitive].normal[1u];
            let _e522 = global[1u];
            if (_e520 == _e522) {
                let _e525 = samples.member[_e63.first_primitive].normal[2u];
                let _e527 = global[2u];
                phi_863_ = (_e525 == _e527);
                phi_864_ = false;
            } else {
                phi_863_ = bool();
                phi_864_ = true;
            }
            let _e530 = phi_863_;
            let _e532 = phi_864_;
            phi_865_ = _e530;
            phi_866_ = _e532;
        } else {
            phi_865_ = bool();
            phi_866_ = true;
        }
        let _e534 = phi_865_;
        let _e536 = phi_866_;
        if _e536 {
            phi_870_ = false;
        } else {
            phi_870_ = _e534;
        }
        let _e538 = phi_870_;
        if !(_e538) {
            let _e541 = samples.member[_e63.first_primitive].position;
            let _e543 = p.member.current.eye;
            let _e554 = p.member.current.forward;
            phi_898_ = ((((_e541.x - _e543.x) * _e554.x) + ((_e541.y - _e543.y) * _e554.y)) + ((_e541.z - _e543.z) * _e554.z));
        } else {
            phi_898_ = 0f;
        }
        let _e564 = phi_898_;
        depths.member[_e63.first_primitive] = _e564;
        phi_901_ = _e507.needs_ray;
        phi_902_ = _e63.first_primitive;
    } else {
        phi_901_ = false;
        phi_902_ = 0u;
    }
    let _e568 = phi_901_;
    let _e570 = phi_902_;
    if (_e44 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e568 {
        let _e574 = atomicAdd((&shared_[0u]), 1u);
        phi_913_ = _e574;
    } else {
        phi_913_ = 0u;
    }
    let _e576 = phi_913_;
    workgroupBarrier();
    if (_e44 == 0u) {
        let _e580 = atomicLoad((&shared_[0u]));
        let _e581 = atomicAdd((&list.member[3u]), _e580);
        atomicStore((&shared_[1u]), _e581);
    }
    workgroupBarrier();
    if _e568 {
        let _e584 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e584) + _e576)]), _e570);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_depth_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
