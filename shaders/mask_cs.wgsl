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

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_139_: lt_bvh_traverse_Tree;
    var phi_140_: bool;
    var phi_141_: lt_bvh_traverse_Tree;
    var phi_142_: bool;
    var phi_147_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_139_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_140_ = false;
        } else {
            phi_139_ = lt_bvh_traverse_Tree();
            phi_140_ = true;
        }
        let _e50 = phi_139_;
        let _e52 = phi_140_;
        phi_141_ = _e50;
        phi_142_ = _e52;
    } else {
        phi_141_ = lt_bvh_traverse_Tree();
        phi_142_ = true;
    }
    let _e54 = phi_141_;
    let _e56 = phi_142_;
    if _e56 {
        phi_147_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_147_ = _e54;
    }
    let _e61 = phi_147_;
    return lt_bvh_traverse_Tree(_e61.root, _e61.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_165_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_165_ = vec2(0i);
            break;
        }
        case 1: {
            phi_165_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_165_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_165_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_165_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e46 = phi_165_;
    return vec2<i32>(_e46.x, _e46.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_183_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_183_ = vec2(0i);
            break;
        }
        case 1: {
            phi_183_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_183_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_183_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_183_ = vec2(1i);
            break;
        }
    }
    let _e46 = phi_183_;
    return vec2<i32>(_e46.x, _e46.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_202_: vec2<i32>;

    if (param_6 == 0u) {
        let _e40 = lt_mask_pattern_plus(param_5);
        phi_202_ = vec2<i32>(_e40.x, _e40.y);
    } else {
        let _e44 = lt_mask_pattern_cross(param_5);
        phi_202_ = vec2<i32>(_e44.x, _e44.y);
    }
    let _e49 = phi_202_;
    return vec2<i32>(_e49.x, _e49.y);
}

fn lt_mask_pattern_step_clamped(param_7: u32, param_8: i32, param_9: u32) -> u32 {
    var phi_223_: u32;
    var phi_224_: u32;

    let _e41 = (bitcast<i32>(param_7) + param_8);
    if (_e41 < 0i) {
        phi_224_ = 0u;
    } else {
        if (_e41 >= bitcast<i32>(param_9)) {
            phi_223_ = (param_9 - 1u);
        } else {
            phi_223_ = bitcast<u32>(_e41);
        }
        let _e48 = phi_223_;
        phi_224_ = _e48;
    }
    let _e50 = phi_224_;
    return _e50;
}

fn function_() {
    var phi_285_: bool;
    var phi_286_: bool;
    var phi_287_: bool;
    var phi_288_: bool;
    var phi_292_: bool;
    var phi_336_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_340_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_353_: bool;
    var phi_374_: bool;
    var phi_385_: bool;
    var phi_386_: bool;
    var phi_387_: bool;
    var phi_388_: bool;
    var phi_389_: bool;
    var phi_390_: bool;
    var phi_394_: bool;
    var phi_399_: bool;
    var phi_413_: u32;
    var phi_415_: u32;
    var phi_418_: lt_mask_Neighbourhood;
    var phi_430_: bool;
    var phi_431_: bool;
    var phi_439_: u32;
    var phi_440_: u32;
    var phi_499_: vec2<i32>;
    var phi_515_: vec2<i32>;
    var phi_538_: u32;
    var phi_555_: bool;
    var phi_556_: bool;
    var phi_563_: bool;
    var phi_564_: bool;
    var phi_582_: bool;
    var phi_583_: bool;
    var phi_584_: bool;
    var phi_416_: u32;
    var phi_419_: lt_mask_Neighbourhood;
    var phi_587_: lt_mask_Neighbourhood;
    var phi_588_: lt_mask_Neighbourhood;
    var phi_613_: bool;
    var phi_614_: bool;
    var phi_627_: bool;
    var phi_628_: bool;
    var phi_629_: bool;
    var phi_636_: u32;
    var phi_637_: u32;
    var phi_638_: u32;
    var phi_639_: u32;
    var phi_640_: u32;
    var phi_648_: bool;
    var phi_656_: u32;
    var phi_661_: u32;
    var phi_665_: u32;
    var phi_666_: u32;
    var phi_670_: f32;
    var phi_672_: mask_Masked;
    var phi_678_: bool;
    var phi_679_: u32;
    var phi_690_: u32;
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
                phi_285_ = (_e83 == _e85);
                phi_286_ = false;
            } else {
                phi_285_ = bool();
                phi_286_ = true;
            }
            let _e88 = phi_285_;
            let _e90 = phi_286_;
            phi_287_ = _e88;
            phi_288_ = _e90;
        } else {
            phi_287_ = bool();
            phi_288_ = true;
        }
        let _e92 = phi_287_;
        let _e94 = phi_288_;
        if _e94 {
            phi_292_ = false;
        } else {
            phi_292_ = _e92;
        }
        let _e96 = phi_292_;
        if !(_e96) {
            let _e99 = samples.member[_e53.first_primitive].normal;
            let _e101 = samples.member[_e53.first_primitive].position;
            if ((((_e99.x * (_e70.x - (_e101.x * _e70.w))) + (_e99.y * (_e70.y - (_e101.y * _e70.w)))) + (_e99.z * (_e70.z - (_e101.z * _e70.w)))) > 0f) {
                let _e125 = samples.member[_e53.first_primitive].flags;
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e133.unnamed.visibility, false), _e133.unnamed_1);
                phi_336_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e139.unnamed, ((_e125 & 1u) == 0u));
            } else {
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e148.unnamed.visibility, false), _e148.unnamed_1);
                phi_336_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e154.unnamed, true);
            }
            let _e159 = phi_336_;
            phi_340_ = _e159;
        } else {
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e165.unnamed.visibility, false), _e165.unnamed_1);
            phi_340_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e171.unnamed, true);
        }
        let _e176 = phi_340_;
        if _e176.unnamed_1 {
            phi_672_ = mask_Masked(_e176.unnamed.visibility, 0u, false);
        } else {
            let _e181 = (_e66 < 0.5f);
            if (_e66 > 0f) {
                phi_353_ = (_e66 < 1f);
            } else {
                phi_353_ = false;
            }
            let _e185 = phi_353_;
            let _e187 = p.member.flags;
            let _e189 = ((_e187 & 1u) != 0u);
            let _e191 = p.member.flags;
            if false {
                let _e195 = p.member.flags;
                phi_374_ = ((_e195 & 4u) == 0u);
            } else {
                phi_374_ = false;
            }
            let _e199 = phi_374_;
            if ((_e191 & 2u) != 0u) {
                if false {
                    phi_387_ = bool();
                    phi_388_ = true;
                } else {
                    if true {
                        phi_385_ = !(_e199);
                        phi_386_ = false;
                    } else {
                        phi_385_ = bool();
                        phi_386_ = true;
                    }
                    let _e202 = phi_385_;
                    let _e204 = phi_386_;
                    phi_387_ = _e202;
                    phi_388_ = _e204;
                }
                let _e206 = phi_387_;
                let _e208 = phi_388_;
                phi_389_ = _e206;
                phi_390_ = _e208;
            } else {
                phi_389_ = bool();
                phi_390_ = true;
            }
            let _e210 = phi_389_;
            let _e212 = phi_390_;
            if _e212 {
                phi_394_ = false;
            } else {
                phi_394_ = _e210;
            }
            let _e214 = phi_394_;
            let _e215 = lt_mask_Neighbourhood(false, true);
            if _e185 {
                phi_399_ = _e214;
            } else {
                phi_399_ = true;
            }
            let _e217 = phi_399_;
            if _e217 {
                if _e189 {
                    if false {
                        let _e219 = p.member.moving_pattern;
                        phi_413_ = _e219;
                    } else {
                        let _e221 = p.member.still_pattern;
                        phi_413_ = _e221;
                    }
                    let _e223 = phi_413_;
                    phi_415_ = 0u;
                    phi_418_ = _e215;
                    loop {
                        let _e225 = phi_415_;
                        let _e227 = phi_418_;
                        local_1 = _e227;
                        if (1u <= _e223) {
                            if (_e223 <= 4u) {
                                phi_430_ = false;
                            } else {
                                phi_430_ = true;
                            }
                            let _e231 = phi_430_;
                            phi_431_ = _e231;
                        } else {
                            phi_431_ = true;
                        }
                        let _e233 = phi_431_;
                        if _e233 {
                            switch bitcast<i32>(_e223) {
                                case 5: {
                                    phi_439_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_439_ = 25u;
                                    break;
                                }
                                default: {
                                    phi_439_ = 9u;
                                    break;
                                }
                            }
                            let _e236 = phi_439_;
                            phi_440_ = _e236;
                        } else {
                            phi_440_ = 5u;
                        }
                        let _e238 = phi_440_;
                        let _e239 = (_e225 < _e238);
                        if _e239 {
                            let _e241 = p.member.frame;
                            let _e245 = p.member.current.size[0u];
                            let _e247 = p.member.current.size[1u];
                            switch bitcast<i32>(_e223) {
                                case 1: {
                                    let _e257 = lt_mask_pattern_plus(_e225);
                                    phi_515_ = vec2<i32>(_e257.x, _e257.y);
                                    break;
                                }
                                case 2: {
                                    let _e261 = lt_mask_pattern_cross(_e225);
                                    phi_515_ = vec2<i32>(_e261.x, _e261.y);
                                    break;
                                }
                                case 3: {
                                    let _e267 = lt_mask_pattern_plus_or_cross(_e225, ((_e37.x + _e37.y) & 1u));
                                    phi_515_ = vec2<i32>(_e267.x, _e267.y);
                                    break;
                                }
                                case 4: {
                                    let _e272 = lt_mask_pattern_plus_or_cross(_e225, (_e241 & 1u));
                                    phi_515_ = vec2<i32>(_e272.x, _e272.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e241 & 3u)) {
                                        case 0: {
                                            phi_499_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_499_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_499_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_499_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e283 = phi_499_;
                                    phi_515_ = (_e283 + vec2<i32>(bitcast<i32>((_e225 & 1u)), bitcast<i32>(((_e225 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_515_ = vec2<i32>((bitcast<i32>((_e225 % 5u)) - 2i), (bitcast<i32>(((_e225 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                default: {
                                    phi_515_ = vec2<i32>((bitcast<i32>((_e225 % 3u)) - 1i), (bitcast<i32>(((_e225 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e301 = phi_515_;
                            let _e304 = lt_mask_pattern_step_clamped(_e37.x, _e301.x, _e245);
                            let _e305 = lt_mask_pattern_step_clamped(_e37.y, _e301.y, _e247);
                            let _e307 = ((_e305 * _e61) + _e304);
                            if (_e307 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e311 = last_bits.member[(0u + _e307)];
                            if ((_e311 & 2u) == 0u) {
                                phi_538_ = (_e311 & 1u);
                            } else {
                                phi_538_ = (_e311 & 7u);
                            }
                            let _e317 = phi_538_;
                            if _e227.any_expands {
                                phi_564_ = true;
                            } else {
                                if ((_e317 & 2u) != 0u) {
                                    if (((_e317 & 4u) != 0u) != _e181) {
                                        phi_555_ = false;
                                    } else {
                                        phi_555_ = true;
                                    }
                                    let _e326 = phi_555_;
                                    phi_556_ = _e326;
                                } else {
                                    phi_556_ = true;
                                }
                                let _e328 = phi_556_;
                                if _e328 {
                                    phi_563_ = (((_e317 & 1u) != 0u) != _e181);
                                } else {
                                    phi_563_ = true;
                                }
                                let _e333 = phi_563_;
                                phi_564_ = _e333;
                            }
                            let _e335 = phi_564_;
                            if _e227.all_remove {
                                if (((_e317 & 1u) != 0u) == _e181) {
                                    if ((_e317 & 2u) != 0u) {
                                        phi_582_ = (((_e317 & 4u) != 0u) == _e181);
                                    } else {
                                        phi_582_ = true;
                                    }
                                    let _e345 = phi_582_;
                                    phi_583_ = _e345;
                                } else {
                                    phi_583_ = false;
                                }
                                let _e347 = phi_583_;
                                phi_584_ = _e347;
                            } else {
                                phi_584_ = false;
                            }
                            let _e349 = phi_584_;
                            phi_416_ = (_e225 + 1u);
                            phi_419_ = lt_mask_Neighbourhood(_e335, _e349);
                        } else {
                            phi_416_ = u32();
                            phi_419_ = lt_mask_Neighbourhood();
                        }
                        let _e353 = phi_416_;
                        let _e355 = phi_419_;
                        continue;
                        continuing {
                            phi_415_ = _e353;
                            phi_418_ = _e355;
                            break if !(_e239);
                        }
                    }
                    let _e469 = local_1;
                    phi_587_ = _e469;
                } else {
                    phi_587_ = _e215;
                }
                let _e358 = phi_587_;
                phi_588_ = _e358;
            } else {
                phi_588_ = _e215;
            }
            let _e360 = phi_588_;
            if (_e66 != 0.5f) {
                if _e189 {
                    if _e185 {
                        phi_614_ = true;
                    } else {
                        if _e360.any_expands {
                            phi_613_ = false;
                        } else {
                            phi_613_ = true;
                        }
                        let _e365 = phi_613_;
                        phi_614_ = _e365;
                    }
                    let _e367 = phi_614_;
                    if _e367 {
                        if _e185 {
                            if _e214 {
                                if _e360.all_remove {
                                    phi_627_ = false;
                                } else {
                                    phi_627_ = true;
                                }
                                let _e369 = phi_627_;
                                phi_628_ = _e369;
                            } else {
                                phi_628_ = true;
                            }
                            let _e371 = phi_628_;
                            phi_629_ = _e371;
                        } else {
                            phi_629_ = true;
                        }
                        let _e373 = phi_629_;
                        if _e373 {
                            if _e185 {
                                phi_636_ = 1u;
                            } else {
                                phi_636_ = 0u;
                            }
                            let _e375 = phi_636_;
                            phi_637_ = _e375;
                        } else {
                            phi_637_ = 5u;
                        }
                        let _e377 = phi_637_;
                        phi_638_ = _e377;
                    } else {
                        phi_638_ = 4u;
                    }
                    let _e379 = phi_638_;
                    phi_639_ = _e379;
                } else {
                    phi_639_ = 3u;
                }
                let _e381 = phi_639_;
                phi_640_ = _e381;
            } else {
                phi_640_ = 2u;
            }
            let _e383 = phi_640_;
            if !((_e383 == 0u)) {
                phi_648_ = !((_e383 == 5u));
            } else {
                phi_648_ = false;
            }
            let _e389 = phi_648_;
            if _e389 {
                if _e181 {
                    phi_656_ = (2u | 1u);
                } else {
                    phi_656_ = 2u;
                }
                let _e392 = phi_656_;
                if false {
                    phi_661_ = (_e392 | 4u);
                } else {
                    phi_661_ = _e392;
                }
                let _e395 = phi_661_;
                phi_666_ = _e395;
            } else {
                if _e181 {
                    phi_665_ = 1u;
                } else {
                    phi_665_ = 0u;
                }
                let _e397 = phi_665_;
                phi_666_ = _e397;
            }
            let _e399 = phi_666_;
            if _e181 {
                phi_670_ = 0f;
            } else {
                phi_670_ = 1f;
            }
            let _e401 = phi_670_;
            phi_672_ = mask_Masked(_e401, _e399, _e389);
        }
        let _e404 = phi_672_;
        visibility.member[_e53.first_primitive] = _e404.visibility;
        bits.member[_e53.first_primitive] = _e404.bits;
        phi_678_ = _e404.needs_ray;
        phi_679_ = _e53.first_primitive;
    } else {
        phi_678_ = false;
        phi_679_ = 0u;
    }
    let _e411 = phi_678_;
    let _e413 = phi_679_;
    if (_e38 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e411 {
        let _e417 = atomicAdd((&shared_[0u]), 1u);
        phi_690_ = _e417;
    } else {
        phi_690_ = 0u;
    }
    let _e419 = phi_690_;
    workgroupBarrier();
    if (_e38 == 0u) {
        let _e423 = atomicLoad((&shared_[0u]));
        let _e424 = atomicAdd((&list.member[3u]), _e423);
        atomicStore((&shared_[1u]), _e424);
    }
    workgroupBarrier();
    if _e411 {
        let _e427 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e427) + _e419)]), _e413);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
