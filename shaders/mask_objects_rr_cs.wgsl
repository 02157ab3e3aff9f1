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

struct lt_mask_Reprojection {
    pixel: vec2<u32>,
    is_valid: bool,
    has_moved: bool,
}

struct lt_mask_Neighbourhood {
    any_expands: bool,
    all_remove: bool,
}

struct type_42 {
    member: array<vec4<f32>>,
}

struct type_47 {
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
var<storage, read_write> list: type_47;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(6) 
var<storage> past: type_42;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_161_: lt_bvh_traverse_Tree;
    var phi_162_: bool;
    var phi_167_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_159_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_160_ = false;
        } else {
            phi_159_ = lt_bvh_traverse_Tree();
            phi_160_ = true;
        }
        let _e62 = phi_159_;
        let _e64 = phi_160_;
        phi_161_ = _e62;
        phi_162_ = _e64;
    } else {
        phi_161_ = lt_bvh_traverse_Tree();
        phi_162_ = true;
    }
    let _e66 = phi_161_;
    let _e68 = phi_162_;
    if _e68 {
        phi_167_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_167_ = _e66;
    }
    let _e73 = phi_167_;
    return lt_bvh_traverse_Tree(_e73.root, _e73.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_185_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_185_ = vec2(0i);
            break;
        }
        case 1: {
            phi_185_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_185_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_185_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_185_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e58 = phi_185_;
    return vec2<i32>(_e58.x, _e58.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_203_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_203_ = vec2(0i);
            break;
        }
        case 1: {
            phi_203_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_203_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_203_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_203_ = vec2(1i);
            break;
        }
    }
    let _e58 = phi_203_;
    return vec2<i32>(_e58.x, _e58.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_222_: vec2<i32>;

    if (param_6 == 0u) {
        let _e52 = lt_mask_pattern_plus(param_5);
        phi_222_ = vec2<i32>(_e52.x, _e52.y);
    } else {
        let _e56 = lt_mask_pattern_cross(param_5);
        phi_222_ = vec2<i32>(_e56.x, _e56.y);
    }
    let _e61 = phi_222_;
    return vec2<i32>(_e61.x, _e61.y);
}

fn lt_mask_pattern_step_clamped(param_7: u32, param_8: i32, param_9: u32) -> u32 {
    var phi_243_: u32;
    var phi_244_: u32;

    let _e53 = (bitcast<i32>(param_7) + param_8);
    if (_e53 < 0i) {
        phi_244_ = 0u;
    } else {
        if (_e53 >= bitcast<i32>(param_9)) {
            phi_243_ = (param_9 - 1u);
        } else {
            phi_243_ = bitcast<u32>(_e53);
        }
        let _e60 = phi_243_;
        phi_244_ = _e60;
    }
    let _e62 = phi_244_;
    return _e62;
}

fn function_() {
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_316_: bool;
    var phi_360_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_364_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_377_: bool;
    var phi_579_: f32;
    var phi_584_: f32;
    var phi_585_: bool;
    var phi_586_: f32;
    var phi_587_: bool;
    var phi_591_: f32;
    var phi_614_: f32;
    var phi_619_: f32;
    var phi_620_: bool;
    var phi_621_: f32;
    var phi_622_: bool;
    var phi_626_: f32;
    var phi_647_: bool;
    var phi_666_: vec2<u32>;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_670_: vec2<u32>;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_674_: bool;
    var phi_675_: bool;
    var phi_676_: bool;
    var phi_677_: vec2<u32>;
    var phi_678_: bool;
    var phi_679_: bool;
    var phi_680_: bool;
    var phi_681_: bool;
    var phi_682_: bool;
    var phi_683_: bool;
    var phi_684_: vec2<u32>;
    var phi_685_: bool;
    var phi_686_: bool;
    var phi_687_: bool;
    var phi_688_: bool;
    var phi_697_: bool;
    var phi_698_: bool;
    var phi_699_: bool;
    var phi_700_: bool;
    var phi_704_: bool;
    var phi_705_: bool;
    var phi_706_: vec2<u32>;
    var phi_745_: bool;
    var phi_746_: bool;
    var phi_748_: bool;
    var phi_749_: lt_mask_Reprojection;
    var phi_750_: lt_mask_Reprojection;
    var phi_751_: bool;
    var phi_755_: bool;
    var phi_756_: lt_mask_Reprojection;
    var phi_770_: bool;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_786_: bool;
    var phi_790_: bool;
    var phi_795_: bool;
    var phi_810_: u32;
    var phi_812_: u32;
    var phi_815_: lt_mask_Neighbourhood;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_836_: u32;
    var phi_837_: u32;
    var phi_896_: vec2<i32>;
    var phi_912_: vec2<i32>;
    var phi_935_: u32;
    var phi_952_: bool;
    var phi_953_: bool;
    var phi_960_: bool;
    var phi_961_: bool;
    var phi_979_: bool;
    var phi_980_: bool;
    var phi_981_: bool;
    var phi_813_: u32;
    var phi_816_: lt_mask_Neighbourhood;
    var phi_984_: lt_mask_Neighbourhood;
    var phi_985_: lt_mask_Neighbourhood;
    var phi_1010_: bool;
    var phi_1011_: bool;
    var phi_1024_: bool;
    var phi_1025_: bool;
    var phi_1026_: bool;
    var phi_1033_: u32;
    var phi_1034_: u32;
    var phi_1035_: u32;
    var phi_1036_: u32;
    var phi_1037_: u32;
    var phi_1045_: bool;
    var phi_1053_: u32;
    var phi_1058_: u32;
    var phi_1062_: u32;
    var phi_1063_: u32;
    var phi_1067_: f32;
    var phi_1069_: mask_Masked;
    var phi_1075_: bool;
    var phi_1076_: u32;
    var phi_1087_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e49 = id_1;
    let _e50 = local_2;
    let _e63 = p.member.current.size[0u];
    let _e65 = p.member.current.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e49, _e63, _e65);
    if (bitcast<i32>(_e66.root) != 0i) {
        let _e74 = p.member.current.size[0u];
        let _e77 = past.member[_e66.first_primitive];
        let _e82 = visibility.member[_e66.first_primitive];
        let _e86 = p.member.light;
        let _e89 = samples.member[_e66.first_primitive].normal[0u];
        let _e91 = global[0u];
        if (_e89 == _e91) {
            let _e94 = samples.member[_e66.first_primitive].normal[1u];
            let _e96 = global[1u];
            if (_e94 == _e96) {
                let _e99 = samples.member[_e66.first_primitive].normal[2u];
                let _e101 = global[2u];
                phi_309_ = (_e99 == _e101);
                phi_310_ = false;
            } else {
                phi_309_ = bool();
                phi_310_ = true;
            }
            let _e104 = phi_309_;
            let _e106 = phi_310_;
            phi_311_ = _e104;
            phi_312_ = _e106;
        } else {
            phi_311_ = bool();
            phi_312_ = true;
        }
        let _e108 = phi_311_;
        let _e110 = phi_312_;
        if _e110 {
            phi_316_ = false;
        } else {
            phi_316_ = _e108;
        }
        let _e112 = phi_316_;
        if !(_e112) {
            let _e115 = samples.member[_e66.first_primitive].normal;
            let _e117 = samples.member[_e66.first_primitive].position;
            if ((((_e115.x * (_e86.x - (_e117.x * _e86.w))) + (_e115.y * (_e86.y - (_e117.y * _e86.w)))) + (_e115.z * (_e86.z - (_e117.z * _e86.w)))) > 0f) {
                let _e141 = samples.member[_e66.first_primitive].flags;
                let _e149 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e149.unnamed.visibility, false), _e149.unnamed_1);
                phi_360_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e155.unnamed, ((_e141 & 1u) == 0u));
            } else {
                let _e164 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e164.unnamed.visibility, false), _e164.unnamed_1);
                phi_360_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e170.unnamed, true);
            }
            let _e175 = phi_360_;
            phi_364_ = _e175;
        } else {
            let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e181.unnamed.visibility, false), _e181.unnamed_1);
            phi_364_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e187.unnamed, true);
        }
        let _e192 = phi_364_;
        if _e192.unnamed_1 {
            phi_1069_ = mask_Masked(_e192.unnamed.visibility, 0u, false);
        } else {
            let _e197 = (_e82 < 0.5f);
            if (_e82 > 0f) {
                phi_377_ = (_e82 < 1f);
            } else {
                phi_377_ = false;
            }
            let _e201 = phi_377_;
            let _e203 = samples.member[_e66.first_primitive].position;
            let _e207 = p.member.previous.eye;
            let _e209 = (_e77.x - _e207.x);
            let _e211 = (_e77.y - _e207.y);
            let _e213 = (_e77.z - _e207.z);
            let _e215 = p.member.previous.forward;
            let _e223 = (((_e209 * _e215.x) + (_e211 * _e215.y)) + (_e213 * _e215.z));
            let _e225 = p.member.previous.right;
            let _e235 = p.member.previous.right;
            let _e250 = p.member.previous.up;
            let _e260 = p.member.previous.up;
            let _e278 = p.member.previous.size[0u];
            let _e285 = p.member.previous.size[1u];
            let _e289 = p.member.current.eye;
            let _e292 = (_e203.x - _e289.x);
            let _e295 = (_e203.y - _e289.y);
            let _e298 = (_e203.z - _e289.z);
            let _e300 = p.member.current.forward;
            let _e308 = (((_e292 * _e300.x) + (_e295 * _e300.y)) + (_e298 * _e300.z));
            let _e310 = p.member.current.right;
            let _e320 = p.member.current.right;
            let _e335 = p.member.current.up;
            let _e345 = p.member.current.up;
            let _e363 = p.member.current.size[0u];
            let _e370 = p.member.current.size[1u];
            let _e373 = ((((((((_e209 * _e225.x) + (_e211 * _e225.y)) + (_e213 * _e225.z)) / ((((_e235.x * _e235.x) + (_e235.y * _e235.y)) + (_e235.z * _e235.z)) * _e223)) * 0.5f) + 0.5f) * f32(_e278)) - (((((((_e292 * _e310.x) + (_e295 * _e310.y)) + (_e298 * _e310.z)) / ((((_e320.x * _e320.x) + (_e320.y * _e320.y)) + (_e320.z * _e320.z)) * _e308)) * 0.5f) + 0.5f) * f32(_e363)));
            let _e374 = (((0.5f - (((((_e209 * _e250.x) + (_e211 * _e250.y)) + (_e213 * _e250.z)) / ((((_e260.x * _e260.x) + (_e260.y * _e260.y)) + (_e260.z * _e260.z)) * _e223)) * 0.5f)) * f32(_e285)) - ((0.5f - (((((_e292 * _e335.x) + (_e295 * _e335.y)) + (_e298 * _e335.z)) / ((((_e345.x * _e345.x) + (_e345.y * _e345.y)) + (_e345.z * _e345.z)) * _e308)) * 0.5f)) * f32(_e370)));
            let _e378 = p.member.current.size[0u];
            let _e380 = p.member.current.size[1u];
            let _e384 = ((f32(_e49.x) + 0.5f) + _e373);
            if (_e384 > -8388608f) {
                let _e396 = f32(select(0i, select(select(i32(_e384), i32(-2147483648), (_e384 < bitcast<f32>(3472883712u))), 2147483647i, (_e384 > bitcast<f32>(1325400063u))), (_e384 == _e384)));
                if (_e396 > _e384) {
                    phi_579_ = 1f;
                } else {
                    phi_579_ = 0f;
                }
                let _e399 = phi_579_;
                if (_e384 < 8388608f) {
                    phi_584_ = (_e396 - _e399);
                    phi_585_ = false;
                } else {
                    phi_584_ = f32();
                    phi_585_ = true;
                }
                let _e402 = phi_584_;
                let _e404 = phi_585_;
                phi_586_ = _e402;
                phi_587_ = _e404;
            } else {
                phi_586_ = f32();
                phi_587_ = true;
            }
            let _e406 = phi_586_;
            let _e408 = phi_587_;
            if _e408 {
                phi_591_ = _e384;
            } else {
                phi_591_ = _e406;
            }
            let _e410 = phi_591_;
            let _e413 = ((f32(_e49.y) + 0.5f) + _e374);
            if (_e413 > -8388608f) {
                let _e425 = f32(select(0i, select(select(i32(_e413), i32(-2147483648), (_e413 < bitcast<f32>(3472883712u))), 2147483647i, (_e413 > bitcast<f32>(1325400063u))), (_e413 == _e413)));
                if (_e425 > _e413) {
                    phi_614_ = 1f;
                } else {
                    phi_614_ = 0f;
                }
                let _e428 = phi_614_;
                if (_e413 < 8388608f) {
                    phi_619_ = (_e425 - _e428);
                    phi_620_ = false;
                } else {
                    phi_619_ = f32();
                    phi_620_ = true;
                }
                let _e431 = phi_619_;
                let _e433 = phi_620_;
                phi_621_ = _e431;
                phi_622_ = _e433;
            } else {
                phi_621_ = f32();
                phi_622_ = true;
            }
            let _e435 = phi_621_;
            let _e437 = phi_622_;
            if _e437 {
                phi_626_ = _e413;
            } else {
                phi_626_ = _e435;
            }
            let _e439 = phi_626_;
            if (_e410 >= 0f) {
                if (_e439 >= 0f) {
                    if (_e410 < f32(_e378)) {
                        let _e445 = (_e439 < f32(_e380));
                        if (_e373 == 0f) {
                            phi_647_ = (_e374 == 0f);
                        } else {
                            phi_647_ = false;
                        }
                        let _e449 = phi_647_;
                        if _e445 {
                            phi_666_ = vec2<u32>(select(select(u32(_e410), 0u, (_e410 < bitcast<f32>(0u))), 4294967295u, (_e410 > bitcast<f32>(1333788671u))), select(select(u32(_e439), 0u, (_e439 < bitcast<f32>(0u))), 4294967295u, (_e439 > bitcast<f32>(1333788671u))));
                            phi_667_ = false;
                        } else {
                            phi_666_ = vec2<u32>();
                            phi_667_ = true;
                        }
                        let _e466 = phi_666_;
                        let _e468 = phi_667_;
                        phi_668_ = _e449;
                        phi_669_ = _e445;
                        phi_670_ = _e466;
                        phi_671_ = _e449;
                        phi_672_ = _e445;
                        phi_673_ = false;
                        phi_674_ = _e468;
                    } else {
                        phi_668_ = bool();
                        phi_669_ = bool();
                        phi_670_ = vec2<u32>();
                        phi_671_ = bool();
                        phi_672_ = bool();
                        phi_673_ = true;
                        phi_674_ = false;
                    }
                    let _e470 = phi_668_;
                    let _e472 = phi_669_;
                    let _e474 = phi_670_;
                    let _e476 = phi_671_;
                    let _e478 = phi_672_;
                    let _e480 = phi_673_;
                    let _e482 = phi_674_;
                    phi_675_ = _e470;
                    phi_676_ = _e472;
                    phi_677_ = _e474;
                    phi_678_ = _e476;
                    phi_679_ = _e478;
                    phi_680_ = _e480;
                    phi_681_ = _e482;
                } else {
                    phi_675_ = bool();
                    phi_676_ = bool();
                    phi_677_ = vec2<u32>();
                    phi_678_ = bool();
                    phi_679_ = bool();
                    phi_680_ = true;
                    phi_681_ = false;
                }
                let _e484 = phi_675_;
                let _e486 = phi_676_;
                let _e488 = phi_677_;
                let _e490 = phi_678_;
                let _e492 = phi_679_;
                let _e494 = phi_680_;
                let _e496 = phi_681_;
                phi_682_ = _e484;
                phi_683_ = _e486;
                phi_684_ = _e488;
                phi_685_ = _e490;
                phi_686_ = _e492;
                phi_687_ = _e494;
                phi_688_ = _e496;
            } else {
                phi_682_ = bool();
                phi_683_ = bool();
                phi_684_ = vec2<u32>();
                phi_685_ = bool();
                phi_686_ = bool();
                phi_687_ = true;
                phi_688_ = false;
            }
            let _e498 = phi_682_;
            let _e500 = phi_683_;
            let _e502 = phi_684_;
            let _e504 = phi_685_;
            let _e506 = phi_686_;
            let _e508 = phi_687_;
            let _e510 = phi_688_;
            if _e508 {
                if (_e373 == 0f) {
                    phi_697_ = (_e374 == 0f);
                } else {
                    phi_697_ = false;
                }
                let _e514 = phi_697_;
                phi_698_ = _e514;
                phi_699_ = false;
                phi_700_ = true;
            } else {
                phi_698_ = _e504;
                phi_699_ = _e506;
                phi_700_ = _e510;
            }
            let _e516 = phi_698_;
            let _e518 = phi_699_;
            let _e520 = phi_700_;
            if _e520 {
                phi_704_ = _e516;
                phi_705_ = _e518;
                phi_706_ = vec2<u32>(_e49.x, _e49.y);
            } else {
                phi_704_ = _e498;
                phi_705_ = _e500;
                phi_706_ = _e502;
            }
            let _e522 = phi_704_;
            let _e524 = phi_705_;
            let _e526 = phi_706_;
            let _e536 = lt_mask_Reprojection(vec2<u32>(_e526.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e543 = lt_mask_Reprojection(vec2<u32>(_e536.pixel.x, _e526.y), _e536.is_valid, _e536.has_moved);
            let _e547 = lt_mask_Reprojection(_e543.pixel, _e524, _e543.has_moved);
            let _e551 = lt_mask_Reprojection(_e547.pixel, _e547.is_valid, !(_e522));
            if _e524 {
                let _e554 = p.member.previous.eye;
                let _e562 = p.member.previous.forward;
                let _e571 = (((((_e77.x - _e554.x) * _e562.x) + ((_e77.y - _e554.y) * _e562.y)) + ((_e77.z - _e554.z) * _e562.z)) > 0f);
                let _e575 = lt_mask_Reprojection(_e551.pixel, _e571, _e551.has_moved);
                if _e571 {
                    let _e577 = p.member.flags;
                    phi_745_ = ((_e577 & 1u) != 0u);
                    phi_746_ = false;
                } else {
                    phi_745_ = bool();
                    phi_746_ = true;
                }
                let _e581 = phi_745_;
                let _e583 = phi_746_;
                phi_748_ = _e581;
                phi_749_ = _e575;
                phi_750_ = _e575;
                phi_751_ = _e583;
            } else {
                phi_748_ = bool();
                phi_749_ = lt_mask_Reprojection();
                phi_750_ = lt_mask_Reprojection(_e551.pixel, false, _e551.has_moved);
                phi_751_ = true;
            }
            let _e589 = phi_748_;
            let _e591 = phi_749_;
            let _e593 = phi_750_;
            let _e595 = phi_751_;
            if _e595 {
                phi_755_ = false;
                phi_756_ = _e593;
            } else {
                phi_755_ = _e589;
                phi_756_ = _e591;
            }
            let _e597 = phi_755_;
            let _e599 = phi_756_;
            let _e603 = lt_mask_Reprojection(_e599.pixel, _e597, _e599.has_moved);
            let _e605 = p.member.flags;
            if _e603.has_moved {
                let _e610 = p.member.flags;
                phi_770_ = ((_e610 & 4u) == 0u);
            } else {
                phi_770_ = false;
            }
            let _e614 = phi_770_;
            if ((_e605 & 2u) != 0u) {
                if false {
                    phi_783_ = bool();
                    phi_784_ = true;
                } else {
                    if true {
                        phi_781_ = !(_e614);
                        phi_782_ = false;
                    } else {
                        phi_781_ = bool();
                        phi_782_ = true;
                    }
                    let _e617 = phi_781_;
                    let _e619 = phi_782_;
                    phi_783_ = _e617;
                    phi_784_ = _e619;
                }
                let _e621 = phi_783_;
                let _e623 = phi_784_;
                phi_785_ = _e621;
                phi_786_ = _e623;
            } else {
                phi_785_ = bool();
                phi_786_ = true;
            }
            let _e625 = phi_785_;
            let _e627 = phi_786_;
            if _e627 {
                phi_790_ = false;
            } else {
                phi_790_ = _e625;
            }
            let _e629 = phi_790_;
            let _e630 = lt_mask_Neighbourhood(false, true);
            if _e201 {
                phi_795_ = _e629;
            } else {
                phi_795_ = false;
            }
            let _e632 = phi_795_;
            if _e632 {
                if _e597 {
                    if _e603.has_moved {
                        let _e635 = p.member.moving_pattern;
                        phi_810_ = _e635;
                    } else {
                        let _e637 = p.member.still_pattern;
                        phi_810_ = _e637;
                    }
                    let _e639 = phi_810_;
                    phi_812_ = 0u;
                    phi_815_ = _e630;
                    loop {
                        let _e641 = phi_812_;
                        let _e643 = phi_815_;
                        local_1 = _e643;
                        if (1u <= _e639) {
                            if (_e639 <= 4u) {
                                phi_827_ = false;
                            } else {
                                phi_827_ = true;
                            }
                            let _e647 = phi_827_;
                            phi_828_ = _e647;
                        } else {
                            phi_828_ = true;
                        }
                        let _e649 = phi_828_;
                        if _e649 {
                            switch bitcast<i32>(_e639) {
                                case 5: {
                                    phi_836_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_836_ = 25u;
                                    break;
                                }
                                default: {
                                    phi_836_ = 9u;
                                    break;
                                }
                            }
                            let _e652 = phi_836_;
                            phi_837_ = _e652;
                        } else {
                            phi_837_ = 5u;
                        }
                        let _e654 = phi_837_;
                        let _e655 = (_e641 < _e654);
                        if _e655 {
                            let _e661 = p.member.frame;
                            let _e665 = p.member.current.size[0u];
                            let _e667 = p.member.current.size[1u];
                            switch bitcast<i32>(_e639) {
                                case 1: {
                                    let _e677 = lt_mask_pattern_plus(_e641);
                                    phi_912_ = vec2<i32>(_e677.x, _e677.y);
                                    break;
                                }
                                case 2: {
                                    let _e681 = lt_mask_pattern_cross(_e641);
                                    phi_912_ = vec2<i32>(_e681.x, _e681.y);
                                    break;
                                }
                                case 3: {
                                    let _e687 = lt_mask_pattern_plus_or_cross(_e641, ((_e603.pixel.x + _e603.pixel.y) & 1u));
                                    phi_912_ = vec2<i32>(_e687.x, _e687.y);
                                    break;
                                }
                                case 4: {
                                    let _e692 = lt_mask_pattern_plus_or_cross(_e641, (_e661 & 1u));
                                    phi_912_ = vec2<i32>(_e692.x, _e692.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e661 & 3u)) {
                                        case 0: {
                                            phi_896_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_896_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_896_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_896_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e703 = phi_896_;
                                    phi_912_ = (_e703 + vec2<i32>(bitcast<i32>((_e641 & 1u)), bitcast<i32>(((_e641 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_912_ = vec2<i32>((bitcast<i32>((_e641 % 5u)) - 2i), (bitcast<i32>(((_e641 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                default: {
                                    phi_912_ = vec2<i32>((bitcast<i32>((_e641 % 3u)) - 1i), (bitcast<i32>(((_e641 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e721 = phi_912_;
                            let _e724 = lt_mask_pattern_step_clamped(_e603.pixel.x, _e721.x, _e665);
                            let _e725 = lt_mask_pattern_step_clamped(_e603.pixel.y, _e721.y, _e667);
                            let _e727 = ((_e725 * _e74) + _e724);
                            if (_e727 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e731 = last_bits.member[(0u + _e727)];
                            if ((_e731 & 2u) == 0u) {
                                phi_935_ = (_e731 & 1u);
                            } else {
                                phi_935_ = (_e731 & 7u);
                            }
                            let _e737 = phi_935_;
                            if _e643.any_expands {
                                phi_961_ = true;
                            } else {
                                if ((_e737 & 2u) != 0u) {
                                    if (((_e737 & 4u) != 0u) != _e197) {
                                        phi_952_ = false;
                                    } else {
                                        phi_952_ = true;
                                    }
                                    let _e746 = phi_952_;
                                    phi_953_ = _e746;
                                } else {
                                    phi_953_ = true;
                                }
                                let _e748 = phi_953_;
                                if _e748 {
                                    phi_960_ = (((_e737 & 1u) != 0u) != _e197);
                                } else {
                                    phi_960_ = true;
                                }
                                let _e753 = phi_960_;
                                phi_961_ = _e753;
                            }
                            let _e755 = phi_961_;
                            if _e643.all_remove {
                                if (((_e737 & 1u) != 0u) == _e197) {
                                    if ((_e737 & 2u) != 0u) {
                                        phi_979_ = (((_e737 & 4u) != 0u) == _e197);
                                    } else {
                                        phi_979_ = true;
                                    }
                                    let _e765 = phi_979_;
                                    phi_980_ = _e765;
                                } else {
                                    phi_980_ = false;
                                }
                                let _e767 = phi_980_;
                                phi_981_ = _e767;
                            } else {
                                phi_981_ = false;
                            }
                            let _e769 = phi_981_;
                            phi_813_ = (_e641 + 1u);
                            phi_816_ = lt_mask_Neighbourhood(_e755, _e769);
                        } else {
                            phi_813_ = u32();
                            phi_816_ = lt_mask_Neighbourhood();
                        }
                        let _e773 = phi_813_;
                        let _e775 = phi_816_;
                        continue;
                        continuing {
                            phi_812_ = _e773;
                            phi_815_ = _e775;
                            break if !(_e655);
                        }
                    }
                    let _e940 = local_1;
                    phi_984_ = _e940;
                } else {
                    phi_984_ = _e630;
                }
                let _e778 = phi_984_;
                phi_985_ = _e778;
            } else {
                phi_985_ = _e630;
            }
            let _e780 = phi_985_;
            if (_e82 != 0.5f) {
                if _e597 {
                    if _e201 {
                        phi_1011_ = true;
                    } else {
                        if _e780.any_expands {
                            phi_1010_ = false;
                        } else {
                            phi_1010_ = true;
                        }
                        let _e785 = phi_1010_;
                        phi_1011_ = _e785;
                    }
                    let _e787 = phi_1011_;
                    if _e787 {
                        if _e201 {
                            if _e629 {
                                if _e780.all_remove {
                                    phi_1024_ = false;
                                } else {
                                    phi_1024_ = true;
                                }
                                let _e789 = phi_1024_;
                                phi_1025_ = _e789;
                            } else {
                                phi_1025_ = true;
                            }
                            let _e791 = phi_1025_;
                            phi_1026_ = _e791;
                        } else {
                            phi_1026_ = true;
                        }
                        let _e793 = phi_1026_;
                        if _e793 {
                            if _e201 {
                                phi_1033_ = 1u;
                            } else {
                                phi_1033_ = 0u;
                            }
                            let _e795 = phi_1033_;
                            phi_1034_ = _e795;
                        } else {
                            phi_1034_ = 5u;
                        }
                        let _e797 = phi_1034_;
                        phi_1035_ = _e797;
                    } else {
                        phi_1035_ = 4u;
                    }
                    let _e799 = phi_1035_;
                    phi_1036_ = _e799;
                } else {
                    phi_1036_ = 3u;
                }
                let _e801 = phi_1036_;
                phi_1037_ = _e801;
            } else {
                phi_1037_ = 2u;
            }
            let _e803 = phi_1037_;
            if !((_e803 == 0u)) {
                phi_1045_ = !((_e803 == 5u));
            } else {
                phi_1045_ = false;
            }
            let _e809 = phi_1045_;
            if _e809 {
                if _e197 {
                    phi_1053_ = (2u | 1u);
                } else {
                    phi_1053_ = 2u;
                }
                let _e812 = phi_1053_;
                if false {
                    phi_1058_ = (_e812 | 4u);
                } else {
                    phi_1058_ = _e812;
                }
                let _e815 = phi_1058_;
                phi_1063_ = _e815;
            } else {
                if _e197 {
                    phi_1062_ = 1u;
                } else {
                    phi_1062_ = 0u;
                }
                let _e817 = phi_1062_;
                phi_1063_ = _e817;
            }
            let _e819 = phi_1063_;
            if _e197 {
                phi_1067_ = 0f;
            } else {
                phi_1067_ = 1f;
            }
            let _e821 = phi_1067_;
            phi_1069_ = mask_Masked(_e821, _e819, _e809);
        }
        let _e824 = phi_1069_;
        visibility.member[_e66.first_primitive] = _e824.visibility;
        bits.member[_e66.first_primitive] = _e824.bits;
        phi_1075_ = _e824.needs_ray;
        phi_1076_ = _e66.first_primitive;
    } else {
        phi_1075_ = false;
        phi_1076_ = 0u;
    }
    let _e831 = phi_1075_;
    let _e833 = phi_1076_;
    if (_e50 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e831 {
        let _e837 = atomicAdd((&shared_[0u]), 1u);
        phi_1087_ = _e837;
    } else {
        phi_1087_ = 0u;
    }
    let _e839 = phi_1087_;
    workgroupBarrier();
    if (_e50 == 0u) {
        let _e843 = atomicLoad((&shared_[0u]));
        let _e844 = atomicAdd((&list.member[3u]), _e843);
        atomicStore((&shared_[1u]), _e844);
    }
    workgroupBarrier();
    if _e831 {
        let _e847 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e847) + _e839)]), _e833);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
