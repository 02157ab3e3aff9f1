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
    var phi_160_: lt_bvh_traverse_Tree;
    var phi_161_: bool;
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_168_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_160_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_161_ = false;
        } else {
            phi_160_ = lt_bvh_traverse_Tree();
            phi_161_ = true;
        }
        let _e63 = phi_160_;
        let _e65 = phi_161_;
        phi_162_ = _e63;
        phi_163_ = _e65;
    } else {
        phi_162_ = lt_bvh_traverse_Tree();
        phi_163_ = true;
    }
    let _e67 = phi_162_;
    let _e69 = phi_163_;
    if _e69 {
        phi_168_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_168_ = _e67;
    }
    let _e74 = phi_168_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_186_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_186_ = vec2(0i);
            break;
        }
        case 1: {
            phi_186_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_186_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_186_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_186_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e59 = phi_186_;
    return vec2<i32>(_e59.x, _e59.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_204_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_204_ = vec2(0i);
            break;
        }
        case 1: {
            phi_204_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_204_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_204_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_204_ = vec2(1i);
            break;
        }
    }
    let _e59 = phi_204_;
    return vec2<i32>(_e59.x, _e59.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_223_: vec2<i32>;

    if (param_6 == 0u) {
        let _e53 = lt_mask_pattern_plus(param_5);
        phi_223_ = vec2<i32>(_e53.x, _e53.y);
    } else {
        let _e57 = lt_mask_pattern_cross(param_5);
        phi_223_ = vec2<i32>(_e57.x, _e57.y);
    }
    let _e62 = phi_223_;
    return vec2<i32>(_e62.x, _e62.y);
}

fn lt_mask_pattern_step_clamped(param_7: u32, param_8: i32, param_9: u32) -> u32 {
    var phi_244_: u32;
    var phi_245_: u32;

    let _e54 = (bitcast<i32>(param_7) + param_8);
    if (_e54 < 0i) {
        phi_245_ = 0u;
    } else {
        if (_e54 >= bitcast<i32>(param_9)) {
            phi_244_ = (param_9 - 1u);
        } else {
            phi_244_ = bitcast<u32>(_e54);
        }
        let _e61 = phi_244_;
        phi_245_ = _e61;
    }
    let _e63 = phi_245_;
    return _e63;
}

fn function_() {
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_317_: bool;
    var phi_361_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_365_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_378_: bool;
    var phi_564_: f32;
    var phi_569_: f32;
    var phi_570_: bool;
    var phi_571_: f32;
    var phi_572_: bool;
    var phi_576_: f32;
    var phi_599_: f32;
    var phi_604_: f32;
    var phi_605_: bool;
    var phi_606_: f32;
    var phi_607_: bool;
    var phi_611_: f32;
    var phi_632_: bool;
    var phi_651_: vec2<u32>;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_655_: vec2<u32>;
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_662_: vec2<u32>;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_669_: vec2<u32>;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_682_: bool;
    var phi_683_: bool;
    var phi_684_: bool;
    var phi_685_: bool;
    var phi_689_: bool;
    var phi_690_: bool;
    var phi_691_: vec2<u32>;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_733_: bool;
    var phi_734_: lt_mask_Reprojection;
    var phi_735_: lt_mask_Reprojection;
    var phi_736_: bool;
    var phi_740_: bool;
    var phi_741_: lt_mask_Reprojection;
    var phi_755_: bool;
    var phi_766_: bool;
    var phi_767_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_775_: bool;
    var phi_780_: bool;
    var phi_795_: u32;
    var phi_797_: u32;
    var phi_800_: lt_mask_Neighbourhood;
    var phi_812_: bool;
    var phi_813_: bool;
    var phi_821_: u32;
    var phi_822_: u32;
    var phi_881_: vec2<i32>;
    var phi_897_: vec2<i32>;
    var phi_920_: u32;
    var phi_937_: bool;
    var phi_938_: bool;
    var phi_945_: bool;
    var phi_946_: bool;
    var phi_964_: bool;
    var phi_965_: bool;
    var phi_966_: bool;
    var phi_798_: u32;
    var phi_801_: lt_mask_Neighbourhood;
    var phi_969_: lt_mask_Neighbourhood;
    var phi_970_: lt_mask_Neighbourhood;
    var phi_995_: bool;
    var phi_996_: bool;
    var phi_1009_: bool;
    var phi_1010_: bool;
    var phi_1011_: bool;
    var phi_1018_: u32;
    var phi_1019_: u32;
    var phi_1020_: u32;
    var phi_1021_: u32;
    var phi_1022_: u32;
    var phi_1030_: bool;
    var phi_1038_: u32;
    var phi_1043_: u32;
    var phi_1047_: u32;
    var phi_1048_: u32;
    var phi_1052_: f32;
    var phi_1054_: mask_Masked;
    var phi_1060_: bool;
    var phi_1061_: u32;
    var phi_1072_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e50 = id_1;
    let _e51 = local_2;
    let _e64 = p.member.current.size[0u];
    let _e66 = p.member.current.size[1u];
    let _e67 = lt_shaders_entry_pixel_index(_e50, _e64, _e66);
    if (bitcast<i32>(_e67.root) != 0i) {
        let _e75 = p.member.current.size[0u];
        let _e78 = past.member[_e67.first_primitive];
        let _e83 = visibility.member[_e67.first_primitive];
        let _e87 = p.member.light;
        let _e90 = samples.member[_e67.first_primitive].normal[0u];
        let _e92 = global[0u];
        if (_e90 == _e92) {
            let _e95 = samples.member[_e67.first_primitive].normal[1u];
            let _e97 = global[1u];
            if (_e95 == _e97) {
                let _e100 = samples.member[_e67.first_primitive].normal[2u];
                let _e102 = global[2u];
                phi_310_ = (_e100 == _e102);
                phi_311_ = false;
            } else {
                phi_310_ = bool();
                phi_311_ = true;
            }
            let _e105 = phi_310_;
            let _e107 = phi_311_;
            phi_312_ = _e105;
            phi_313_ = _e107;
        } else {
            phi_312_ = bool();
            phi_313_ = true;
        }
        let _e109 = phi_312_;
        let _e111 = phi_313_;
        if _e111 {
            phi_317_ = false;
        } else {
            phi_317_ = _e109;
        }
        let _e113 = phi_317_;
        if !(_e113) {
            let _e116 = samples.member[_e67.first_primitive].normal;
            let _e118 = samples.member[_e67.first_primitive].position;
            if ((((_e116.x * (_e87.x - (_e118.x * _e87.w))) + (_e116.y * (_e87.y - (_e118.y * _e87.w)))) + (_e116.z * (_e87.z - (_e118.z * _e87.w)))) > 0f) {
                let _e142 = samples.member[_e67.first_primitive].flags;
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e150.unnamed.visibility, false), _e150.unnamed_1);
                phi_361_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e156.unnamed, ((_e142 & 1u) == 0u));
            } else {
                let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e165.unnamed.visibility, false), _e165.unnamed_1);
                phi_361_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e171.unnamed, true);
            }
            let _e176 = phi_361_;
            phi_365_ = _e176;
        } else {
            let _e182 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e182.unnamed.visibility, false), _e182.unnamed_1);
            phi_365_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e188.unnamed, true);
        }
        let _e193 = phi_365_;
        if _e193.unnamed_1 {
            phi_1054_ = mask_Masked(_e193.unnamed.visibility, 0u, false);
        } else {
            let _e198 = (_e83 < 0.5f);
            if (_e83 > 0f) {
                phi_378_ = (_e83 < 1f);
            } else {
                phi_378_ = false;
            }
            let _e202 = phi_378_;
            let _e204 = samples.member[_e67.first_primitive].position;
            let _e208 = p.member.previous.eye;
            let _e210 = (_e78.x - _e208.x);
            let _e212 = (_e78.y - _e208.y);
            let _e214 = (_e78.z - _e208.z);
            let _e216 = p.member.previous.forward;
            let _e224 = (((_e210 * _e216.x) + (_e212 * _e216.y)) + (_e214 * _e216.z));
            let _e226 = p.member.previous.right;
            let _e236 = p.member.previous.right;
            let _e251 = p.member.previous.up;
            let _e261 = p.member.previous.up;
            let _e276 = p.member.current.eye;
            let _e279 = (_e204.x - _e276.x);
            let _e282 = (_e204.y - _e276.y);
            let _e285 = (_e204.z - _e276.z);
            let _e287 = p.member.current.forward;
            let _e295 = (((_e279 * _e287.x) + (_e282 * _e287.y)) + (_e285 * _e287.z));
            let _e297 = p.member.current.right;
            let _e307 = p.member.current.right;
            let _e322 = p.member.current.up;
            let _e332 = p.member.current.up;
            let _e351 = p.member.current.size[0u];
            let _e353 = (((((((_e210 * _e226.x) + (_e212 * _e226.y)) + (_e214 * _e226.z)) / ((((_e236.x * _e236.x) + (_e236.y * _e236.y)) + (_e236.z * _e236.z)) * _e224)) - ((((_e279 * _e297.x) + (_e282 * _e297.y)) + (_e285 * _e297.z)) / ((((_e307.x * _e307.x) + (_e307.y * _e307.y)) + (_e307.z * _e307.z)) * _e295))) * 0.5f) * f32(_e351));
            let _e357 = p.member.current.size[1u];
            let _e359 = (((((((_e210 * _e251.x) + (_e212 * _e251.y)) + (_e214 * _e251.z)) / ((((_e261.x * _e261.x) + (_e261.y * _e261.y)) + (_e261.z * _e261.z)) * _e224)) - ((((_e279 * _e322.x) + (_e282 * _e322.y)) + (_e285 * _e322.z)) / ((((_e332.x * _e332.x) + (_e332.y * _e332.y)) + (_e332.z * _e332.z)) * _e295))) * -0.5f) * f32(_e357));
            let _e363 = p.member.current.size[0u];
            let _e365 = p.member.current.size[1u];
            let _e369 = ((f32(_e50.x) + 0.5f) + _e353);
            if (_e369 > -8388608f) {
                let _e381 = f32(select(0i, select(select(i32(_e369), i32(-2147483648), (_e369 < bitcast<f32>(3472883712u))), 2147483647i, (_e369 > bitcast<f32>(1325400063u))), (_e369 == _e369)));
                if (_e381 > _e369) {
                    phi_564_ = 1f;
                } else {
                    phi_564_ = 0f;
                }
                let _e384 = phi_564_;
                if (_e369 < 8388608f) {
                    phi_569_ = (_e381 - _e384);
                    phi_570_ = false;
                } else {
                    phi_569_ = f32();
                    phi_570_ = true;
                }
                let _e387 = phi_569_;
                let _e389 = phi_570_;
                phi_571_ = _e387;
                phi_572_ = _e389;
            } else {
                phi_571_ = f32();
                phi_572_ = true;
            }
            let _e391 = phi_571_;
            let _e393 = phi_572_;
            if _e393 {
                phi_576_ = _e369;
            } else {
                phi_576_ = _e391;
            }
            let _e395 = phi_576_;
            let _e398 = ((f32(_e50.y) + 0.5f) + _e359);
            if (_e398 > -8388608f) {
                let _e410 = f32(select(0i, select(select(i32(_e398), i32(-2147483648), (_e398 < bitcast<f32>(3472883712u))), 2147483647i, (_e398 > bitcast<f32>(1325400063u))), (_e398 == _e398)));
                if (_e410 > _e398) {
                    phi_599_ = 1f;
                } else {
                    phi_599_ = 0f;
                }
                let _e413 = phi_599_;
                if (_e398 < 8388608f) {
                    phi_604_ = (_e410 - _e413);
                    phi_605_ = false;
                } else {
                    phi_604_ = f32();
                    phi_605_ = true;
                }
                let _e416 = phi_604_;
                let _e418 = phi_605_;
                phi_606_ = _e416;
                phi_607_ = _e418;
            } else {
                phi_606_ = f32();
                phi_607_ = true;
            }
            let _e420 = phi_606_;
            let _e422 = phi_607_;
            if _e422 {
                phi_611_ = _e398;
            } else {
                phi_611_ = _e420;
            }
            let _e424 = phi_611_;
            if (_e395 >= 0f) {
                if (_e424 >= 0f) {
                    if (_e395 < f32(_e363)) {
                        let _e430 = (_e424 < f32(_e365));
                        if (_e353 == 0f) {
                            phi_632_ = (_e359 == 0f);
                        } else {
                            phi_632_ = false;
                        }
                        let _e434 = phi_632_;
                        if _e430 {
                            phi_651_ = vec2<u32>(select(select(u32(_e395), 0u, (_e395 < bitcast<f32>(0u))), 4294967295u, (_e395 > bitcast<f32>(1333788671u))), select(select(u32(_e424), 0u, (_e424 < bitcast<f32>(0u))), 4294967295u, (_e424 > bitcast<f32>(1333788671u))));
                            phi_652_ = false;
                        } else {
                            phi_651_ = vec2<u32>();
                            phi_652_ = true;
                        }
                        let _e451 = phi_651_;
                        let _e453 = phi_652_;
                        phi_653_ = _e434;
                        phi_654_ = _e430;
                        phi_655_ = _e451;
                        phi_656_ = _e434;
                        phi_657_ = _e430;
                        phi_658_ = false;
                        phi_659_ = _e453;
                    } else {
                        phi_653_ = bool();
                        phi_654_ = bool();
                        phi_655_ = vec2<u32>();
                        phi_656_ = bool();
                        phi_657_ = bool();
                        phi_658_ = true;
                        phi_659_ = false;
                    }
                    let _e455 = phi_653_;
                    let _e457 = phi_654_;
                    let _e459 = phi_655_;
                    let _e461 = phi_656_;
                    let _e463 = phi_657_;
                    let _e465 = phi_658_;
                    let _e467 = phi_659_;
                    phi_660_ = _e455;
                    phi_661_ = _e457;
                    phi_662_ = _e459;
                    phi_663_ = _e461;
                    phi_664_ = _e463;
                    phi_665_ = _e465;
                    phi_666_ = _e467;
                } else {
                    phi_660_ = bool();
                    phi_661_ = bool();
                    phi_662_ = vec2<u32>();
                    phi_663_ = bool();
                    phi_664_ = bool();
                    phi_665_ = true;
                    phi_666_ = false;
                }
                let _e469 = phi_660_;
                let _e471 = phi_661_;
                let _e473 = phi_662_;
                let _e475 = phi_663_;
                let _e477 = phi_664_;
                let _e479 = phi_665_;
                let _e481 = phi_666_;
                phi_667_ = _e469;
                phi_668_ = _e471;
                phi_669_ = _e473;
                phi_670_ = _e475;
                phi_671_ = _e477;
                phi_672_ = _e479;
                phi_673_ = _e481;
            } else {
                phi_667_ = bool();
                phi_668_ = bool();
                phi_669_ = vec2<u32>();
                phi_670_ = bool();
                phi_671_ = bool();
                phi_672_ = true;
                phi_673_ = false;
            }
            let _e483 = phi_667_;
            let _e485 = phi_668_;
            let _e487 = phi_669_;
            let _e489 = phi_670_;
            let _e491 = phi_671_;
            let _e493 = phi_672_;
            let _e495 = phi_673_;
            if _e493 {
                if (_e353 == 0f) {
                    phi_682_ = (_e359 == 0f);
                } else {
                    phi_682_ = false;
                }
                let _e499 = phi_682_;
                phi_683_ = _e499;
                phi_684_ = false;
                phi_685_ = true;
            } else {
                phi_683_ = _e489;
                phi_684_ = _e491;
                phi_685_ = _e495;
            }
            let _e501 = phi_683_;
            let _e503 = phi_684_;
            let _e505 = phi_685_;
            if _e505 {
                phi_689_ = _e501;
                phi_690_ = _e503;
                phi_691_ = vec2<u32>(_e50.x, _e50.y);
            } else {
                phi_689_ = _e483;
                phi_690_ = _e485;
                phi_691_ = _e487;
            }
            let _e507 = phi_689_;
            let _e509 = phi_690_;
            let _e511 = phi_691_;
            let _e521 = lt_mask_Reprojection(vec2<u32>(_e511.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e528 = lt_mask_Reprojection(vec2<u32>(_e521.pixel.x, _e511.y), _e521.is_valid, _e521.has_moved);
            let _e532 = lt_mask_Reprojection(_e528.pixel, _e509, _e528.has_moved);
            let _e536 = lt_mask_Reprojection(_e532.pixel, _e532.is_valid, !(_e507));
            if _e509 {
                let _e539 = p.member.previous.eye;
                let _e547 = p.member.previous.forward;
                let _e556 = (((((_e78.x - _e539.x) * _e547.x) + ((_e78.y - _e539.y) * _e547.y)) + ((_e78.z - _e539.z) * _e547.z)) > 0f);
                let _e560 = lt_mask_Reprojection(_e536.pixel, _e556, _e536.has_moved);
                if _e556 {
                    let _e562 = p.member.flags;
                    phi_730_ = ((_e562 & 1u) != 0u);
                    phi_731_ = false;
                } else {
                    phi_730_ = bool();
                    phi_731_ = true;
                }
                let _e566 = phi_730_;
                let _e568 = phi_731_;
                phi_733_ = _e566;
                phi_734_ = _e560;
                phi_735_ = _e560;
                phi_736_ = _e568;
            } else {
                phi_733_ = bool();
                phi_734_ = lt_mask_Reprojection();
                phi_735_ = lt_mask_Reprojection(_e536.pixel, false, _e536.has_moved);
                phi_736_ = true;
            }
            let _e574 = phi_733_;
            let _e576 = phi_734_;
            let _e578 = phi_735_;
            let _e580 = phi_736_;
            if _e580 {
                phi_740_ = false;
                phi_741_ = _e578;
            } else {
                phi_740_ = _e574;
                phi_741_ = _e576;
            }
            let _e582 = phi_740_;
            let _e584 = phi_741_;
            let _e588 = lt_mask_Reprojection(_e584.pixel, _e582, _e584.has_moved);
            let _e590 = p.member.flags;
            if _e588.has_moved {
                let _e595 = p.member.flags;
                phi_755_ = ((_e595 & 4u) == 0u);
            } else {
                phi_755_ = false;
            }
            let _e599 = phi_755_;
            if ((_e590 & 2u) != 0u) {
                if false {
                    phi_768_ = bool();
                    phi_769_ = true;
                } else {
                    if true {
                        phi_766_ = !(_e599);
                        phi_767_ = false;
                    } else {
                        phi_766_ = bool();
                        phi_767_ = true;
                    }
                    let _e602 = phi_766_;
                    let _e604 = phi_767_;
                    phi_768_ = _e602;
                    phi_769_ = _e604;
                }
                let _e606 = phi_768_;
                let _e608 = phi_769_;
                phi_770_ = _e606;
                phi_771_ = _e608;
            } else {
                phi_770_ = bool();
                phi_771_ = true;
            }
            let _e610 = phi_770_;
            let _e612 = phi_771_;
            if _e612 {
                phi_775_ = false;
            } else {
                phi_775_ = _e610;
            }
            let _e614 = phi_775_;
            let _e615 = lt_mask_Neighbourhood(false, true);
            if _e202 {
                phi_780_ = _e614;
            } else {
                phi_780_ = false;
            }
            let _e617 = phi_780_;
            if _e617 {
                if _e582 {
                    if _e588.has_moved {
                        let _e620 = p.member.moving_pattern;
                        phi_795_ = _e620;
                    } else {
                        let _e622 = p.member.still_pattern;
                        phi_795_ = _e622;
                    }
                    let _e624 = phi_795_;
                    phi_797_ = 0u;
                    phi_800_ = _e615;
                    loop {
                        let _e626 = phi_797_;
                        let _e628 = phi_800_;
                        local_1 = _e628;
                        if (1u <= _e624) {
                            if (_e624 <= 4u) {
                                phi_812_ = false;
                            } else {
                                phi_812_ = true;
                            }
                            let _e632 = phi_812_;
                            phi_813_ = _e632;
                        } else {
                            phi_813_ = true;
                        }
                        let _e634 = phi_813_;
                        if _e634 {
                            switch bitcast<i32>(_e624) {
                                case 5: {
                                    phi_821_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_821_ = 25u;
                                    break;
                                }
                                default: {
                                    phi_821_ = 9u;
                                    break;
                                }
                            }
                            let _e637 = phi_821_;
                            phi_822_ = _e637;
                        } else {
                            phi_822_ = 5u;
                        }
                        let _e639 = phi_822_;
                        let _e640 = (_e626 < _e639);
                        if _e640 {
                            let _e646 = p.member.frame;
                            let _e650 = p.member.current.size[0u];
                            let _e652 = p.member.current.size[1u];
                            switch bitcast<i32>(_e624) {
                                case 1: {
                                    let _e662 = lt_mask_pattern_plus(_e626);
                                    phi_897_ = vec2<i32>(_e662.x, _e662.y);
                                    break;
                                }
                                case 2: {
                                    let _e666 = lt_mask_pattern_cross(_e626);
                                    phi_897_ = vec2<i32>(_e666.x, _e666.y);
                                    break;
                                }
                                case 3: {
                                    let _e672 = lt_mask_pattern_plus_or_cross(_e626, ((_e588.pixel.x + _e588.pixel.y) & 1u));
                                    phi_897_ = vec2<i32>(_e672.x, _e672.y);
                                    break;
                                }
                                case 4: {
                                    let _e677 = lt_mask_pattern_plus_or_cross(_e626, (_e646 & 1u));
                                    phi_897_ = vec2<i32>(_e677.x, _e677.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e646 & 3u)) {
                                        case 0: {
                                            phi_881_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_881_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_881_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_881_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e688 = phi_881_;
                                    phi_897_ = (_e688 + vec2<i32>(bitcast<i32>((_e626 & 1u)), bitcast<i32>(((_e626 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_897_ = vec2<i32>((bitcast<i32>((_e626 % 5u)) - 2i), (bitcast<i32>(((_e626 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                default: {
                                    phi_897_ = vec2<i32>((bitcast<i32>((_e626 % 3u)) - 1i), (bitcast<i32>(((_e626 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e706 = phi_897_;
                            let _e709 = lt_mask_pattern_step_clamped(_e588.pixel.x, _e706.x, _e650);
                            let _e710 = lt_mask_pattern_step_clamped(_e588.pixel.y, _e706.y, _e652);
                            let _e712 = ((_e710 * _e75) + _e709);
                            if (_e712 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e716 = last_bits.member[(0u + _e712)];
                            if ((_e716 & 2u) == 0u) {
                                phi_920_ = (_e716 & 1u);
                            } else {
                                phi_920_ = (_e716 & 7u);
                            }
                            let _e722 = phi_920_;
                            if _e628.any_expands {
                                phi_946_ = true;
                            } else {
                                if ((_e722 & 2u) != 0u) {
                                    if (((_e722 & 4u) != 0u) != _e198) {
                                        phi_937_ = false;
                                    } else {
                                        phi_937_ = true;
                                    }
                                    let _e731 = phi_937_;
                                    phi_938_ = _e731;
                                } else {
                                    phi_938_ = true;
                                }
                                let _e733 = phi_938_;
                                if _e733 {
                                    phi_945_ = (((_e722 & 1u) != 0u) != _e198);
                                } else {
                                    phi_945_ = true;
                                }
                                let _e738 = phi_945_;
                                phi_946_ = _e738;
                            }
                            let _e740 = phi_946_;
                            if _e628.all_remove {
                                if (((_e722 & 1u) != 0u) == _e198) {
                                    if ((_e722 & 2u) != 0u) {
                                        phi_964_ = (((_e722 & 4u) != 0u) == _e198);
                                    } else {
                                        phi_964_ = true;
                                    }
                                    let _e750 = phi_964_;
                                    phi_965_ = _e750;
                                } else {
                                    phi_965_ = false;
                                }
                                let _e752 = phi_965_;
                                phi_966_ = _e752;
                            } else {
                                phi_966_ = false;
                            }
                            let _e754 = phi_966_;
                            phi_798_ = (_e626 + 1u);
                            phi_801_ = lt_mask_Neighbourhood(_e740, _e754);
                        } else {
                            phi_798_ = u32();
                            phi_801_ = lt_mask_Neighbourhood();
                        }
                        let _e758 = phi_798_;
                        let _e760 = phi_801_;
                        continue;
                        continuing {
                            phi_797_ = _e758;
                            phi_800_ = _e760;
                            break if !(_e640);
                        }
                    }
                    let _e925 = local_1;
                    phi_969_ = _e925;
                } else {
                    phi_969_ = _e615;
                }
                let _e763 = phi_969_;
                phi_970_ = _e763;
            } else {
                phi_970_ = _e615;
            }
            let _e765 = phi_970_;
            if (_e83 != 0.5f) {
                if _e582 {
                    if _e202 {
                        phi_996_ = true;
                    } else {
                        if _e765.any_expands {
                            phi_995_ = false;
                        } else {
                            phi_995_ = true;
                        }
                        let _e770 = phi_995_;
                        phi_996_ = _e770;
                    }
                    let _e772 = phi_996_;
                    if _e772 {
                        if _e202 {
                            if _e614 {
                                if _e765.all_remove {
                                    phi_1009_ = false;
                                } else {
                                    phi_1009_ = true;
                                }
                                let _e774 = phi_1009_;
                                phi_1010_ = _e774;
                            } else {
                                phi_1010_ = true;
                            }
                            let _e776 = phi_1010_;
                            phi_1011_ = _e776;
                        } else {
                            phi_1011_ = true;
                        }
                        let _e778 = phi_1011_;
                        if _e778 {
                            if _e202 {
                                phi_1018_ = 1u;
                            } else {
                                phi_1018_ = 0u;
                            }
                            let _e780 = phi_1018_;
                            phi_1019_ = _e780;
                        } else {
                            phi_1019_ = 5u;
                        }
                        let _e782 = phi_1019_;
                        phi_1020_ = _e782;
                    } else {
                        phi_1020_ = 4u;
                    }
                    let _e784 = phi_1020_;
                    phi_1021_ = _e784;
                } else {
                    phi_1021_ = 3u;
                }
                let _e786 = phi_1021_;
                phi_1022_ = _e786;
            } else {
                phi_1022_ = 2u;
            }
            let _e788 = phi_1022_;
            if !((_e788 == 0u)) {
                phi_1030_ = !((_e788 == 5u));
            } else {
                phi_1030_ = false;
            }
            let _e794 = phi_1030_;
            if _e794 {
                if _e198 {
                    phi_1038_ = (2u | 1u);
                } else {
                    phi_1038_ = 2u;
                }
                let _e797 = phi_1038_;
                if false {
                    phi_1043_ = (_e797 | 4u);
                } else {
                    phi_1043_ = _e797;
                }
                let _e800 = phi_1043_;
                phi_1048_ = _e800;
            } else {
                if _e198 {
                    phi_1047_ = 1u;
                } else {
                    phi_1047_ = 0u;
                }
                let _e802 = phi_1047_;
                phi_1048_ = _e802;
            }
            let _e804 = phi_1048_;
            if _e198 {
                phi_1052_ = 0f;
            } else {
                phi_1052_ = 1f;
            }
            let _e806 = phi_1052_;
            phi_1054_ = mask_Masked(_e806, _e804, _e794);
        }
        let _e809 = phi_1054_;
        visibility.member[_e67.first_primitive] = _e809.visibility;
        bits.member[_e67.first_primitive] = _e809.bits;
        phi_1060_ = _e809.needs_ray;
        phi_1061_ = _e67.first_primitive;
    } else {
        phi_1060_ = false;
        phi_1061_ = 0u;
    }
    let _e816 = phi_1060_;
    let _e818 = phi_1061_;
    if (_e51 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e816 {
        let _e822 = atomicAdd((&shared_[0u]), 1u);
        phi_1072_ = _e822;
    } else {
        phi_1072_ = 0u;
    }
    let _e824 = phi_1072_;
    workgroupBarrier();
    if (_e51 == 0u) {
        let _e828 = atomicLoad((&shared_[0u]));
        let _e829 = atomicAdd((&list.member[3u]), _e828);
        atomicStore((&shared_[1u]), _e829);
    }
    workgroupBarrier();
    if _e816 {
        let _e832 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e832) + _e824)]), _e818);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
