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

struct type_40 {
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
var<storage, read_write> list: type_40;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_mask_pattern_step_clamped(param: u32, param_1: i32, param_2: u32) -> u32 {
    var phi_715_: u32;
    var phi_716_: u32;

    let _e43 = (bitcast<i32>(param) + param_1);
    if (_e43 < 0i) {
        phi_716_ = 0u;
    } else {
        if (_e43 >= bitcast<i32>(param_2)) {
            phi_715_ = (param_2 - 1u);
        } else {
            phi_715_ = bitcast<u32>(_e43);
        }
        let _e50 = phi_715_;
        phi_716_ = _e50;
    }
    let _e52 = phi_716_;
    return _e52;
}

fn lt_mask_pattern_diamond(param_3: u32) -> vec2<i32> {
    var phi_694_: vec2<i32>;

    let _e40 = (param_3 % 13u);
    switch bitcast<i32>(_e40) {
        case 9: {
            phi_694_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_694_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_694_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_694_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_694_ = vec2<i32>((bitcast<i32>((_e40 % 3u)) - 1i), (bitcast<i32>(((_e40 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e55 = phi_694_;
    return vec2<i32>(_e55.x, _e55.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_650_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_650_ = vec2(0i);
            break;
        }
        case 1: {
            phi_650_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_650_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_650_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_650_ = vec2(1i);
            break;
        }
    }
    let _e48 = phi_650_;
    return vec2<i32>(_e48.x, _e48.y);
}

fn lt_mask_pattern_plus(param_5: u32) -> vec2<i32> {
    var phi_632_: vec2<i32>;

    switch bitcast<i32>((param_5 % 5u)) {
        case 0: {
            phi_632_ = vec2(0i);
            break;
        }
        case 1: {
            phi_632_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_632_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_632_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_632_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e48 = phi_632_;
    return vec2<i32>(_e48.x, _e48.y);
}

fn lt_mask_pattern_plus_or_cross(param_6: u32, param_7: u32) -> vec2<i32> {
    var phi_669_: vec2<i32>;

    if (param_7 == 0u) {
        let _e42 = lt_mask_pattern_plus(param_6);
        phi_669_ = vec2<i32>(_e42.x, _e42.y);
    } else {
        let _e46 = lt_mask_pattern_cross(param_6);
        phi_669_ = vec2<i32>(_e46.x, _e46.y);
    }
    let _e51 = phi_669_;
    return vec2<i32>(_e51.x, _e51.y);
}

fn lt_shaders_entry_pixel_index(param_8: vec3<u32>, param_9: u32, param_10: u32) -> lt_bvh_traverse_Tree {
    var phi_606_: lt_bvh_traverse_Tree;
    var phi_607_: bool;
    var phi_608_: lt_bvh_traverse_Tree;
    var phi_609_: bool;
    var phi_614_: lt_bvh_traverse_Tree;

    if (param_8.x < param_9) {
        if (param_8.y < param_10) {
            phi_606_ = lt_bvh_traverse_Tree(1u, ((param_8.y * param_9) + param_8.x));
            phi_607_ = false;
        } else {
            phi_606_ = lt_bvh_traverse_Tree();
            phi_607_ = true;
        }
        let _e52 = phi_606_;
        let _e54 = phi_607_;
        phi_608_ = _e52;
        phi_609_ = _e54;
    } else {
        phi_608_ = lt_bvh_traverse_Tree();
        phi_609_ = true;
    }
    let _e56 = phi_608_;
    let _e58 = phi_609_;
    if _e58 {
        phi_614_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_614_ = _e56;
    }
    let _e63 = phi_614_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn function_() {
    var phi_183_: bool;
    var phi_184_: bool;
    var phi_185_: bool;
    var phi_186_: bool;
    var phi_190_: bool;
    var phi_234_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_238_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_251_: bool;
    var phi_285_: u32;
    var phi_287_: u32;
    var phi_290_: lt_mask_Neighbourhood;
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_312_: u32;
    var phi_313_: u32;
    var phi_373_: vec2<i32>;
    var phi_393_: vec2<i32>;
    var phi_416_: u32;
    var phi_433_: bool;
    var phi_434_: bool;
    var phi_441_: bool;
    var phi_442_: bool;
    var phi_460_: bool;
    var phi_461_: bool;
    var phi_462_: bool;
    var phi_288_: u32;
    var phi_291_: lt_mask_Neighbourhood;
    var phi_465_: lt_mask_Neighbourhood;
    var phi_466_: lt_mask_Neighbourhood;
    var phi_467_: lt_mask_Neighbourhood;
    var phi_492_: bool;
    var phi_493_: bool;
    var phi_506_: bool;
    var phi_507_: bool;
    var phi_508_: bool;
    var phi_515_: u32;
    var phi_516_: u32;
    var phi_517_: u32;
    var phi_518_: u32;
    var phi_519_: u32;
    var phi_527_: bool;
    var phi_535_: u32;
    var phi_540_: u32;
    var phi_544_: u32;
    var phi_545_: u32;
    var phi_549_: f32;
    var phi_551_: mask_Masked;
    var phi_557_: bool;
    var phi_558_: u32;
    var phi_569_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e39 = id_1;
    let _e40 = local_2;
    let _e52 = p.member.current.size[0u];
    let _e54 = p.member.current.size[1u];
    let _e55 = lt_shaders_entry_pixel_index(_e39, _e52, _e54);
    if (bitcast<i32>(_e55.root) != 0i) {
        let _e63 = p.member.current.size[0u];
        let _e68 = visibility.member[_e55.first_primitive];
        let _e72 = p.member.light;
        let _e75 = samples.member[_e55.first_primitive].normal[0u];
        let _e77 = global[0u];
        if (_e75 == _e77) {
            let _e80 = samples.member[_e55.first_primitive].normal[1u];
            let _e82 = global[1u];
            if (_e80 == _e82) {
                let _e85 = samples.member[_e55.first_primitive].normal[2u];
                let _e87 = global[2u];
                phi_183_ = (_e85 == _e87);
                phi_184_ = false;
            } else {
                phi_183_ = bool();
                phi_184_ = true;
            }
            let _e90 = phi_183_;
            let _e92 = phi_184_;
            phi_185_ = _e90;
            phi_186_ = _e92;
        } else {
            phi_185_ = bool();
            phi_186_ = true;
        }
        let _e94 = phi_185_;
        let _e96 = phi_186_;
        if _e96 {
            phi_190_ = false;
        } else {
            phi_190_ = _e94;
        }
        let _e98 = phi_190_;
        if !(_e98) {
            let _e101 = samples.member[_e55.first_primitive].normal;
            let _e103 = samples.member[_e55.first_primitive].position;
            if ((((_e101.x * (_e72.x - (_e103.x * _e72.w))) + (_e101.y * (_e72.y - (_e103.y * _e72.w)))) + (_e101.z * (_e72.z - (_e103.z * _e72.w)))) > 0f) {
                let _e127 = samples.member[_e55.first_primitive].flags;
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e135.unnamed.visibility, false), _e135.unnamed_1);
                phi_234_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e141.unnamed, ((_e127 & 1u) == 0u));
            } else {
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e150.unnamed.visibility, false), _e150.unnamed_1);
                phi_234_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e156.unnamed, true);
            }
            let _e161 = phi_234_;
            phi_238_ = _e161;
        } else {
            let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
            phi_238_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, true);
        }
        let _e178 = phi_238_;
        if _e178.unnamed_1 {
            phi_551_ = mask_Masked(_e178.unnamed.visibility, 0u, false);
        } else {
            let _e183 = (_e68 < 0.5f);
            if (_e68 > 0f) {
                phi_251_ = (_e68 < 1f);
            } else {
                phi_251_ = false;
            }
            let _e187 = phi_251_;
            let _e189 = p.member.flags;
            let _e191 = ((_e189 & 1u) != 0u);
            if false {
            }
            let _e196 = lt_mask_Neighbourhood(false, true);
            if _e187 {
                phi_467_ = _e196;
            } else {
                if true {
                    if _e191 {
                        if false {
                            let _e198 = p.member.moving_pattern;
                            phi_285_ = _e198;
                        } else {
                            let _e200 = p.member.still_pattern;
                            phi_285_ = _e200;
                        }
                        let _e202 = phi_285_;
                        phi_287_ = 0u;
                        phi_290_ = _e196;
                        loop {
                            let _e204 = phi_287_;
                            let _e206 = phi_290_;
                            local_1 = _e206;
                            if (1u <= _e202) {
                                if (_e202 <= 4u) {
                                    phi_302_ = false;
                                } else {
                                    phi_302_ = true;
                                }
                                let _e210 = phi_302_;
                                phi_303_ = _e210;
                            } else {
                                phi_303_ = true;
                            }
                            let _e212 = phi_303_;
                            if _e212 {
                                switch bitcast<i32>(_e202) {
                                    case 5: {
                                        phi_312_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_312_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_312_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_312_ = 9u;
                                        break;
                                    }
                                }
                                let _e215 = phi_312_;
                                phi_313_ = _e215;
                            } else {
                                phi_313_ = 5u;
                            }
                            let _e217 = phi_313_;
                            let _e218 = (_e204 < _e217);
                            if _e218 {
                                let _e220 = p.member.frame;
                                let _e224 = p.member.current.size[0u];
                                let _e226 = p.member.current.size[1u];
                                switch bitcast<i32>(_e202) {
                                    case 1: {
                                        let _e236 = lt_mask_pattern_plus(_e204);
                                        phi_393_ = vec2<i32>(_e236.x, _e236.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e240 = lt_mask_pattern_cross(_e204);
                                        phi_393_ = vec2<i32>(_e240.x, _e240.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e246 = lt_mask_pattern_plus_or_cross(_e204, ((_e39.x + _e39.y) & 1u));
                                        phi_393_ = vec2<i32>(_e246.x, _e246.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e251 = lt_mask_pattern_plus_or_cross(_e204, (_e220 & 1u));
                                        phi_393_ = vec2<i32>(_e251.x, _e251.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e220 & 3u)) {
                                            case 0: {
                                                phi_373_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_373_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_373_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_373_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e262 = phi_373_;
                                        phi_393_ = (_e262 + vec2<i32>(bitcast<i32>((_e204 & 1u)), bitcast<i32>(((_e204 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_393_ = vec2<i32>((bitcast<i32>((_e204 % 5u)) - 2i), (bitcast<i32>(((_e204 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e279 = lt_mask_pattern_diamond(_e204);
                                        phi_393_ = vec2<i32>(_e279.x, _e279.y);
                                        break;
                                    }
                                    default: {
                                        phi_393_ = vec2<i32>((bitcast<i32>((_e204 % 3u)) - 1i), (bitcast<i32>(((_e204 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e284 = phi_393_;
                                let _e287 = lt_mask_pattern_step_clamped(_e39.x, _e284.x, _e224);
                                let _e288 = lt_mask_pattern_step_clamped(_e39.y, _e284.y, _e226);
                                let _e290 = ((_e288 * _e63) + _e287);
                                if (_e290 < arrayLength((&last_bits.member))) {
                                } else {
                                    return;
                                }
                                let _e294 = last_bits.member[(0u + _e290)];
                                if ((_e294 & 2u) == 0u) {
                                    phi_416_ = (_e294 & 1u);
                                } else {
                                    phi_416_ = (_e294 & 7u);
                                }
                                let _e300 = phi_416_;
                                if _e206.any_expands {
                                    phi_442_ = true;
                                } else {
                                    if ((_e300 & 2u) != 0u) {
                                        if (((_e300 & 4u) != 0u) != _e183) {
                                            phi_433_ = false;
                                        } else {
                                            phi_433_ = true;
                                        }
                                        let _e309 = phi_433_;
                                        phi_434_ = _e309;
                                    } else {
                                        phi_434_ = true;
                                    }
                                    let _e311 = phi_434_;
                                    if _e311 {
                                        phi_441_ = (((_e300 & 1u) != 0u) != _e183);
                                    } else {
                                        phi_441_ = true;
                                    }
                                    let _e316 = phi_441_;
                                    phi_442_ = _e316;
                                }
                                let _e318 = phi_442_;
                                if _e206.all_remove {
                                    if (((_e300 & 1u) != 0u) == _e183) {
                                        if ((_e300 & 2u) != 0u) {
                                            phi_460_ = (((_e300 & 4u) != 0u) == _e183);
                                        } else {
                                            phi_460_ = true;
                                        }
                                        let _e328 = phi_460_;
                                        phi_461_ = _e328;
                                    } else {
                                        phi_461_ = false;
                                    }
                                    let _e330 = phi_461_;
                                    phi_462_ = _e330;
                                } else {
                                    phi_462_ = false;
                                }
                                let _e332 = phi_462_;
                                phi_288_ = (_e204 + 1u);
                                phi_291_ = lt_mask_Neighbourhood(_e318, _e332);
                            } else {
                                phi_288_ = u32();
                                phi_291_ = lt_mask_Neighbourhood();
                            }
                            let _e336 = phi_288_;
                            let _e338 = phi_291_;
                            continue;
                            continuing {
                                phi_287_ = _e336;
                                phi_290_ = _e338;
                                break if !(_e218);
                            }
                        }
                        let _e445 = local_1;
                        phi_465_ = _e445;
                    } else {
                        phi_465_ = _e196;
                    }
                    let _e341 = phi_465_;
                    phi_466_ = _e341;
                } else {
                    phi_466_ = _e196;
                }
                let _e343 = phi_466_;
                phi_467_ = _e343;
            }
            let _e345 = phi_467_;
            if (_e68 != 0.5f) {
                if _e191 {
                    if _e187 {
                        phi_493_ = true;
                    } else {
                        if _e345.any_expands {
                            phi_492_ = false;
                        } else {
                            phi_492_ = true;
                        }
                        let _e350 = phi_492_;
                        phi_493_ = _e350;
                    }
                    let _e352 = phi_493_;
                    if _e352 {
                        if _e187 {
                            if false {
                                if _e345.all_remove {
                                    phi_506_ = false;
                                } else {
                                    phi_506_ = true;
                                }
                                let _e354 = phi_506_;
                                phi_507_ = _e354;
                            } else {
                                phi_507_ = true;
                            }
                            let _e356 = phi_507_;
                            phi_508_ = _e356;
                        } else {
                            phi_508_ = true;
                        }
                        let _e358 = phi_508_;
                        if _e358 {
                            if _e187 {
                                phi_515_ = 1u;
                            } else {
                                phi_515_ = 0u;
                            }
                            let _e360 = phi_515_;
                            phi_516_ = _e360;
                        } else {
                            phi_516_ = 5u;
                        }
                        let _e362 = phi_516_;
                        phi_517_ = _e362;
                    } else {
                        phi_517_ = 4u;
                    }
                    let _e364 = phi_517_;
                    phi_518_ = _e364;
                } else {
                    phi_518_ = 3u;
                }
                let _e366 = phi_518_;
                phi_519_ = _e366;
            } else {
                phi_519_ = 2u;
            }
            let _e368 = phi_519_;
            if !((_e368 == 0u)) {
                phi_527_ = !((_e368 == 5u));
            } else {
                phi_527_ = false;
            }
            let _e374 = phi_527_;
            if _e374 {
                if _e183 {
                    phi_535_ = (2u | 1u);
                } else {
                    phi_535_ = 2u;
                }
                let _e377 = phi_535_;
                if false {
                    phi_540_ = (_e377 | 4u);
                } else {
                    phi_540_ = _e377;
                }
                let _e380 = phi_540_;
                phi_545_ = _e380;
            } else {
                if _e183 {
                    phi_544_ = 1u;
                } else {
                    phi_544_ = 0u;
                }
                let _e382 = phi_544_;
                phi_545_ = _e382;
            }
            let _e384 = phi_545_;
            if _e183 {
                phi_549_ = 0f;
            } else {
                phi_549_ = 1f;
            }
            let _e386 = phi_549_;
            phi_551_ = mask_Masked(_e386, _e384, _e374);
        }
        let _e389 = phi_551_;
        visibility.member[_e55.first_primitive] = _e389.visibility;
        bits.member[_e55.first_primitive] = _e389.bits;
        phi_557_ = _e389.needs_ray;
        phi_558_ = _e55.first_primitive;
    } else {
        phi_557_ = false;
        phi_558_ = 0u;
    }
    let _e396 = phi_557_;
    let _e398 = phi_558_;
    if (_e40 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e396 {
        let _e402 = atomicAdd((&shared_[0u]), 1u);
        phi_569_ = _e402;
    } else {
        phi_569_ = 0u;
    }
    let _e404 = phi_569_;
    workgroupBarrier();
    if (_e40 == 0u) {
        let _e408 = atomicLoad((&shared_[0u]));
        let _e409 = atomicAdd((&list.member[3u]), _e408);
        atomicStore((&shared_[1u]), _e409);
    }
    workgroupBarrier();
    if _e396 {
        let _e412 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e412) + _e404)]), _e398);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
