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
    var phi_681_: u32;
    var phi_682_: u32;

    let _e41 = (bitcast<i32>(param) + param_1);
    if (_e41 < 0i) {
        phi_682_ = 0u;
    } else {
        if (_e41 >= bitcast<i32>(param_2)) {
            phi_681_ = (param_2 - 1u);
        } else {
            phi_681_ = bitcast<u32>(_e41);
        }
        let _e48 = phi_681_;
        phi_682_ = _e48;
    }
    let _e50 = phi_682_;
    return _e50;
}

fn lt_mask_pattern_cross(param_3: u32) -> vec2<i32> {
    var phi_641_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_641_ = vec2(0i);
            break;
        }
        case 1: {
            phi_641_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_641_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_641_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_641_ = vec2(1i);
            break;
        }
    }
    let _e46 = phi_641_;
    return vec2<i32>(_e46.x, _e46.y);
}

fn lt_mask_pattern_plus(param_4: u32) -> vec2<i32> {
    var phi_623_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_623_ = vec2(0i);
            break;
        }
        case 1: {
            phi_623_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_623_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_623_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_623_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e46 = phi_623_;
    return vec2<i32>(_e46.x, _e46.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_660_: vec2<i32>;

    if (param_6 == 0u) {
        let _e40 = lt_mask_pattern_plus(param_5);
        phi_660_ = vec2<i32>(_e40.x, _e40.y);
    } else {
        let _e44 = lt_mask_pattern_cross(param_5);
        phi_660_ = vec2<i32>(_e44.x, _e44.y);
    }
    let _e49 = phi_660_;
    return vec2<i32>(_e49.x, _e49.y);
}

fn lt_shaders_entry_pixel_index(param_7: vec3<u32>, param_8: u32, param_9: u32) -> lt_bvh_traverse_Tree {
    var phi_597_: lt_bvh_traverse_Tree;
    var phi_598_: bool;
    var phi_599_: lt_bvh_traverse_Tree;
    var phi_600_: bool;
    var phi_605_: lt_bvh_traverse_Tree;

    if (param_7.x < param_8) {
        if (param_7.y < param_9) {
            phi_597_ = lt_bvh_traverse_Tree(1u, ((param_7.y * param_8) + param_7.x));
            phi_598_ = false;
        } else {
            phi_597_ = lt_bvh_traverse_Tree();
            phi_598_ = true;
        }
        let _e50 = phi_597_;
        let _e52 = phi_598_;
        phi_599_ = _e50;
        phi_600_ = _e52;
    } else {
        phi_599_ = lt_bvh_traverse_Tree();
        phi_600_ = true;
    }
    let _e54 = phi_599_;
    let _e56 = phi_600_;
    if _e56 {
        phi_605_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_605_ = _e54;
    }
    let _e61 = phi_605_;
    return lt_bvh_traverse_Tree(_e61.root, _e61.first_primitive);
}

fn function_() {
    var phi_180_: bool;
    var phi_181_: bool;
    var phi_182_: bool;
    var phi_183_: bool;
    var phi_187_: bool;
    var phi_231_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_235_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_248_: bool;
    var phi_282_: u32;
    var phi_284_: u32;
    var phi_287_: lt_mask_Neighbourhood;
    var phi_299_: bool;
    var phi_300_: bool;
    var phi_308_: u32;
    var phi_309_: u32;
    var phi_368_: vec2<i32>;
    var phi_384_: vec2<i32>;
    var phi_407_: u32;
    var phi_424_: bool;
    var phi_425_: bool;
    var phi_432_: bool;
    var phi_433_: bool;
    var phi_451_: bool;
    var phi_452_: bool;
    var phi_453_: bool;
    var phi_285_: u32;
    var phi_288_: lt_mask_Neighbourhood;
    var phi_456_: lt_mask_Neighbourhood;
    var phi_457_: lt_mask_Neighbourhood;
    var phi_458_: lt_mask_Neighbourhood;
    var phi_483_: bool;
    var phi_484_: bool;
    var phi_497_: bool;
    var phi_498_: bool;
    var phi_499_: bool;
    var phi_506_: u32;
    var phi_507_: u32;
    var phi_508_: u32;
    var phi_509_: u32;
    var phi_510_: u32;
    var phi_518_: bool;
    var phi_526_: u32;
    var phi_531_: u32;
    var phi_535_: u32;
    var phi_536_: u32;
    var phi_540_: f32;
    var phi_542_: mask_Masked;
    var phi_548_: bool;
    var phi_549_: u32;
    var phi_560_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e37 = id_1;
    let _e38 = local_2;
    let _e50 = p.member.current.size[0u];
    let _e52 = p.member.current.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e37, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        let _e61 = p.member.current.size[0u];
        let _e66 = visibility.member[_e53.first_primitive];
        let _e70 = p.member.light;
        let _e73 = samples.member[_e53.first_primitive].normal[0u];
        let _e75 = global[0u];
        if (_e73 == _e75) {
            let _e78 = samples.member[_e53.first_primitive].normal[1u];
            let _e80 = global[1u];
            if (_e78 == _e80) {
                let _e83 = samples.member[_e53.first_primitive].normal[2u];
                let _e85 = global[2u];
                phi_180_ = (_e83 == _e85);
                phi_181_ = false;
            } else {
                phi_180_ = bool();
                phi_181_ = true;
            }
            let _e88 = phi_180_;
            let _e90 = phi_181_;
            phi_182_ = _e88;
            phi_183_ = _e90;
        } else {
            phi_182_ = bool();
            phi_183_ = true;
        }
        let _e92 = phi_182_;
        let _e94 = phi_183_;
        if _e94 {
            phi_187_ = false;
        } else {
            phi_187_ = _e92;
        }
        let _e96 = phi_187_;
        if !(_e96) {
            let _e99 = samples.member[_e53.first_primitive].normal;
            let _e101 = samples.member[_e53.first_primitive].position;
            if ((((_e99.x * (_e70.x - (_e101.x * _e70.w))) + (_e99.y * (_e70.y - (_e101.y * _e70.w)))) + (_e99.z * (_e70.z - (_e101.z * _e70.w)))) > 0f) {
                let _e125 = samples.member[_e53.first_primitive].flags;
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e133.unnamed.visibility, false), _e133.unnamed_1);
                phi_231_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e139.unnamed, ((_e125 & 1u) == 0u));
            } else {
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e148.unnamed.visibility, false), _e148.unnamed_1);
                phi_231_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e154.unnamed, true);
            }
            let _e159 = phi_231_;
            phi_235_ = _e159;
        } else {
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e165.unnamed.visibility, false), _e165.unnamed_1);
            phi_235_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e171.unnamed, true);
        }
        let _e176 = phi_235_;
        if _e176.unnamed_1 {
            phi_542_ = mask_Masked(_e176.unnamed.visibility, 0u, false);
        } else {
            let _e181 = (_e66 < 0.5f);
            if (_e66 > 0f) {
                phi_248_ = (_e66 < 1f);
            } else {
                phi_248_ = false;
            }
            let _e185 = phi_248_;
            let _e187 = p.member.flags;
            let _e189 = ((_e187 & 1u) != 0u);
            if false {
            }
            let _e194 = lt_mask_Neighbourhood(false, true);
            if _e185 {
                phi_458_ = _e194;
            } else {
                if true {
                    if _e189 {
                        if false {
                            let _e196 = p.member.moving_pattern;
                            phi_282_ = _e196;
                        } else {
                            let _e198 = p.member.still_pattern;
                            phi_282_ = _e198;
                        }
                        let _e200 = phi_282_;
                        phi_284_ = 0u;
                        phi_287_ = _e194;
                        loop {
                            let _e202 = phi_284_;
                            let _e204 = phi_287_;
                            local_1 = _e204;
                            if (1u <= _e200) {
                                if (_e200 <= 4u) {
                                    phi_299_ = false;
                                } else {
                                    phi_299_ = true;
                                }
                                let _e208 = phi_299_;
                                phi_300_ = _e208;
                            } else {
                                phi_300_ = true;
                            }
                            let _e210 = phi_300_;
                            if _e210 {
                                switch bitcast<i32>(_e200) {
                                    case 5: {
                                        phi_308_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_308_ = 25u;
                                        break;
                                    }
                                    default: {
                                        phi_308_ = 9u;
                                        break;
                                    }
                                }
                                let _e213 = phi_308_;
                                phi_309_ = _e213;
                            } else {
                                phi_309_ = 5u;
                            }
                            let _e215 = phi_309_;
                            let _e216 = (_e202 < _e215);
                            if _e216 {
                                let _e218 = p.member.frame;
                                let _e222 = p.member.current.size[0u];
                                let _e224 = p.member.current.size[1u];
                                switch bitcast<i32>(_e200) {
                                    case 1: {
                                        let _e234 = lt_mask_pattern_plus(_e202);
                                        phi_384_ = vec2<i32>(_e234.x, _e234.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e238 = lt_mask_pattern_cross(_e202);
                                        phi_384_ = vec2<i32>(_e238.x, _e238.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e244 = lt_mask_pattern_plus_or_cross(_e202, ((_e37.x + _e37.y) & 1u));
                                        phi_384_ = vec2<i32>(_e244.x, _e244.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e249 = lt_mask_pattern_plus_or_cross(_e202, (_e218 & 1u));
                                        phi_384_ = vec2<i32>(_e249.x, _e249.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e218 & 3u)) {
                                            case 0: {
                                                phi_368_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_368_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_368_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_368_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e260 = phi_368_;
                                        phi_384_ = (_e260 + vec2<i32>(bitcast<i32>((_e202 & 1u)), bitcast<i32>(((_e202 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_384_ = vec2<i32>((bitcast<i32>((_e202 % 5u)) - 2i), (bitcast<i32>(((_e202 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    default: {
                                        phi_384_ = vec2<i32>((bitcast<i32>((_e202 % 3u)) - 1i), (bitcast<i32>(((_e202 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e278 = phi_384_;
                                let _e281 = lt_mask_pattern_step_clamped(_e37.x, _e278.x, _e222);
                                let _e282 = lt_mask_pattern_step_clamped(_e37.y, _e278.y, _e224);
                                let _e284 = ((_e282 * _e61) + _e281);
                                if (_e284 < arrayLength((&last_bits.member))) {
                                } else {
                                    return;
                                }
                                let _e288 = last_bits.member[(0u + _e284)];
                                if ((_e288 & 2u) == 0u) {
                                    phi_407_ = (_e288 & 1u);
                                } else {
                                    phi_407_ = (_e288 & 7u);
                                }
                                let _e294 = phi_407_;
                                if _e204.any_expands {
                                    phi_433_ = true;
                                } else {
                                    if ((_e294 & 2u) != 0u) {
                                        if (((_e294 & 4u) != 0u) != _e181) {
                                            phi_424_ = false;
                                        } else {
                                            phi_424_ = true;
                                        }
                                        let _e303 = phi_424_;
                                        phi_425_ = _e303;
                                    } else {
                                        phi_425_ = true;
                                    }
                                    let _e305 = phi_425_;
                                    if _e305 {
                                        phi_432_ = (((_e294 & 1u) != 0u) != _e181);
                                    } else {
                                        phi_432_ = true;
                                    }
                                    let _e310 = phi_432_;
                                    phi_433_ = _e310;
                                }
                                let _e312 = phi_433_;
                                if _e204.all_remove {
                                    if (((_e294 & 1u) != 0u) == _e181) {
                                        if ((_e294 & 2u) != 0u) {
                                            phi_451_ = (((_e294 & 4u) != 0u) == _e181);
                                        } else {
                                            phi_451_ = true;
                                        }
                                        let _e322 = phi_451_;
                                        phi_452_ = _e322;
                                    } else {
                                        phi_452_ = false;
                                    }
                                    let _e324 = phi_452_;
                                    phi_453_ = _e324;
                                } else {
                                    phi_453_ = false;
                                }
                                let _e326 = phi_453_;
                                phi_285_ = (_e202 + 1u);
                                phi_288_ = lt_mask_Neighbourhood(_e312, _e326);
                            } else {
                                phi_285_ = u32();
                                phi_288_ = lt_mask_Neighbourhood();
                            }
                            let _e330 = phi_285_;
                            let _e332 = phi_288_;
                            continue;
                            continuing {
                                phi_284_ = _e330;
                                phi_287_ = _e332;
                                break if !(_e216);
                            }
                        }
                        let _e439 = local_1;
                        phi_456_ = _e439;
                    } else {
                        phi_456_ = _e194;
                    }
                    let _e335 = phi_456_;
                    phi_457_ = _e335;
                } else {
                    phi_457_ = _e194;
                }
                let _e337 = phi_457_;
                phi_458_ = _e337;
            }
            let _e339 = phi_458_;
            if (_e66 != 0.5f) {
                if _e189 {
                    if _e185 {
                        phi_484_ = true;
                    } else {
                        if _e339.any_expands {
                            phi_483_ = false;
                        } else {
                            phi_483_ = true;
                        }
                        let _e344 = phi_483_;
                        phi_484_ = _e344;
                    }
                    let _e346 = phi_484_;
                    if _e346 {
                        if _e185 {
                            if false {
                                if _e339.all_remove {
                                    phi_497_ = false;
                                } else {
                                    phi_497_ = true;
                                }
                                let _e348 = phi_497_;
                                phi_498_ = _e348;
                            } else {
                                phi_498_ = true;
                            }
                            let _e350 = phi_498_;
                            phi_499_ = _e350;
                        } else {
                            phi_499_ = true;
                        }
                        let _e352 = phi_499_;
                        if _e352 {
                            if _e185 {
                                phi_506_ = 1u;
                            } else {
                                phi_506_ = 0u;
                            }
                            let _e354 = phi_506_;
                            phi_507_ = _e354;
                        } else {
                            phi_507_ = 5u;
                        }
                        let _e356 = phi_507_;
                        phi_508_ = _e356;
                    } else {
                        phi_508_ = 4u;
                    }
                    let _e358 = phi_508_;
                    phi_509_ = _e358;
                } else {
                    phi_509_ = 3u;
                }
                let _e360 = phi_509_;
                phi_510_ = _e360;
            } else {
                phi_510_ = 2u;
            }
            let _e362 = phi_510_;
            if !((_e362 == 0u)) {
                phi_518_ = !((_e362 == 5u));
            } else {
                phi_518_ = false;
            }
            let _e368 = phi_518_;
            if _e368 {
                if _e181 {
                    phi_526_ = (2u | 1u);
                } else {
                    phi_526_ = 2u;
                }
                let _e371 = phi_526_;
                if false {
                    phi_531_ = (_e371 | 4u);
                } else {
                    phi_531_ = _e371;
                }
                let _e374 = phi_531_;
                phi_536_ = _e374;
            } else {
                if _e181 {
                    phi_535_ = 1u;
                } else {
                    phi_535_ = 0u;
                }
                let _e376 = phi_535_;
                phi_536_ = _e376;
            }
            let _e378 = phi_536_;
            if _e181 {
                phi_540_ = 0f;
            } else {
                phi_540_ = 1f;
            }
            let _e380 = phi_540_;
            phi_542_ = mask_Masked(_e380, _e378, _e368);
        }
        let _e383 = phi_542_;
        visibility.member[_e53.first_primitive] = _e383.visibility;
        bits.member[_e53.first_primitive] = _e383.bits;
        phi_548_ = _e383.needs_ray;
        phi_549_ = _e53.first_primitive;
    } else {
        phi_548_ = false;
        phi_549_ = 0u;
    }
    let _e390 = phi_548_;
    let _e392 = phi_549_;
    if (_e38 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e390 {
        let _e396 = atomicAdd((&shared_[0u]), 1u);
        phi_560_ = _e396;
    } else {
        phi_560_ = 0u;
    }
    let _e398 = phi_560_;
    workgroupBarrier();
    if (_e38 == 0u) {
        let _e402 = atomicLoad((&shared_[0u]));
        let _e403 = atomicAdd((&list.member[3u]), _e402);
        atomicStore((&shared_[1u]), _e403);
    }
    workgroupBarrier();
    if _e390 {
        let _e406 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e406) + _e398)]), _e392);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
