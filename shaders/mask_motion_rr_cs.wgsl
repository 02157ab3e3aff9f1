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
var<storage, read_write> list: type_42;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;

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
        let _e61 = phi_153_;
        let _e63 = phi_154_;
        phi_155_ = _e61;
        phi_156_ = _e63;
    } else {
        phi_155_ = lt_bvh_traverse_Tree();
        phi_156_ = true;
    }
    let _e65 = phi_155_;
    let _e67 = phi_156_;
    if _e67 {
        phi_161_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_161_ = _e65;
    }
    let _e72 = phi_161_;
    return lt_bvh_traverse_Tree(_e72.root, _e72.first_primitive);
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
    let _e57 = phi_179_;
    return vec2<i32>(_e57.x, _e57.y);
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
    let _e57 = phi_197_;
    return vec2<i32>(_e57.x, _e57.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_216_: vec2<i32>;

    if (param_6 == 0u) {
        let _e51 = lt_mask_pattern_plus(param_5);
        phi_216_ = vec2<i32>(_e51.x, _e51.y);
    } else {
        let _e55 = lt_mask_pattern_cross(param_5);
        phi_216_ = vec2<i32>(_e55.x, _e55.y);
    }
    let _e60 = phi_216_;
    return vec2<i32>(_e60.x, _e60.y);
}

fn lt_mask_pattern_step_clamped(param_7: u32, param_8: i32, param_9: u32) -> u32 {
    var phi_237_: u32;
    var phi_238_: u32;

    let _e52 = (bitcast<i32>(param_7) + param_8);
    if (_e52 < 0i) {
        phi_238_ = 0u;
    } else {
        if (_e52 >= bitcast<i32>(param_9)) {
            phi_237_ = (param_9 - 1u);
        } else {
            phi_237_ = bitcast<u32>(_e52);
        }
        let _e59 = phi_237_;
        phi_238_ = _e59;
    }
    let _e61 = phi_238_;
    return _e61;
}

fn function_() {
    var phi_299_: bool;
    var phi_300_: bool;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_306_: bool;
    var phi_350_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_354_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_367_: bool;
    var phi_572_: f32;
    var phi_577_: f32;
    var phi_578_: bool;
    var phi_579_: f32;
    var phi_580_: bool;
    var phi_584_: f32;
    var phi_607_: f32;
    var phi_612_: f32;
    var phi_613_: bool;
    var phi_614_: f32;
    var phi_615_: bool;
    var phi_619_: f32;
    var phi_640_: bool;
    var phi_659_: vec2<u32>;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_663_: vec2<u32>;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
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
    var phi_690_: bool;
    var phi_691_: bool;
    var phi_692_: bool;
    var phi_693_: bool;
    var phi_697_: bool;
    var phi_698_: bool;
    var phi_699_: vec2<u32>;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_744_: bool;
    var phi_745_: lt_mask_Reprojection;
    var phi_746_: lt_mask_Reprojection;
    var phi_747_: bool;
    var phi_751_: bool;
    var phi_752_: lt_mask_Reprojection;
    var phi_766_: bool;
    var phi_777_: bool;
    var phi_778_: bool;
    var phi_779_: bool;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_786_: bool;
    var phi_791_: bool;
    var phi_806_: u32;
    var phi_808_: u32;
    var phi_811_: lt_mask_Neighbourhood;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_832_: u32;
    var phi_833_: u32;
    var phi_892_: vec2<i32>;
    var phi_908_: vec2<i32>;
    var phi_931_: u32;
    var phi_948_: bool;
    var phi_949_: bool;
    var phi_956_: bool;
    var phi_957_: bool;
    var phi_975_: bool;
    var phi_976_: bool;
    var phi_977_: bool;
    var phi_809_: u32;
    var phi_812_: lt_mask_Neighbourhood;
    var phi_980_: lt_mask_Neighbourhood;
    var phi_981_: lt_mask_Neighbourhood;
    var phi_1006_: bool;
    var phi_1007_: bool;
    var phi_1020_: bool;
    var phi_1021_: bool;
    var phi_1022_: bool;
    var phi_1029_: u32;
    var phi_1030_: u32;
    var phi_1031_: u32;
    var phi_1032_: u32;
    var phi_1033_: u32;
    var phi_1041_: bool;
    var phi_1049_: u32;
    var phi_1054_: u32;
    var phi_1058_: u32;
    var phi_1059_: u32;
    var phi_1063_: f32;
    var phi_1065_: mask_Masked;
    var phi_1071_: bool;
    var phi_1072_: u32;
    var phi_1083_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e48 = id_1;
    let _e49 = local_2;
    let _e61 = p.member.current.size[0u];
    let _e63 = p.member.current.size[1u];
    let _e64 = lt_shaders_entry_pixel_index(_e48, _e61, _e63);
    if (bitcast<i32>(_e64.root) != 0i) {
        let _e72 = p.member.current.size[0u];
        let _e75 = samples.member[_e64.first_primitive].position;
        let _e77 = visibility.member[_e64.first_primitive];
        let _e81 = p.member.light;
        let _e84 = samples.member[_e64.first_primitive].normal[0u];
        let _e86 = global[0u];
        if (_e84 == _e86) {
            let _e89 = samples.member[_e64.first_primitive].normal[1u];
            let _e91 = global[1u];
            if (_e89 == _e91) {
                let _e94 = samples.member[_e64.first_primitive].normal[2u];
                let _e96 = global[2u];
                phi_299_ = (_e94 == _e96);
                phi_300_ = false;
            } else {
                phi_299_ = bool();
                phi_300_ = true;
            }
            let _e99 = phi_299_;
            let _e101 = phi_300_;
            phi_301_ = _e99;
            phi_302_ = _e101;
        } else {
            phi_301_ = bool();
            phi_302_ = true;
        }
        let _e103 = phi_301_;
        let _e105 = phi_302_;
        if _e105 {
            phi_306_ = false;
        } else {
            phi_306_ = _e103;
        }
        let _e107 = phi_306_;
        if !(_e107) {
            let _e110 = samples.member[_e64.first_primitive].normal;
            let _e112 = samples.member[_e64.first_primitive].position;
            if ((((_e110.x * (_e81.x - (_e112.x * _e81.w))) + (_e110.y * (_e81.y - (_e112.y * _e81.w)))) + (_e110.z * (_e81.z - (_e112.z * _e81.w)))) > 0f) {
                let _e136 = samples.member[_e64.first_primitive].flags;
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e144.unnamed.visibility, false), _e144.unnamed_1);
                phi_350_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e150.unnamed, ((_e136 & 1u) == 0u));
            } else {
                let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e159.unnamed.visibility, false), _e159.unnamed_1);
                phi_350_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e165.unnamed, true);
            }
            let _e170 = phi_350_;
            phi_354_ = _e170;
        } else {
            let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e182 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e176.unnamed.visibility, false), _e176.unnamed_1);
            phi_354_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e182.unnamed, true);
        }
        let _e187 = phi_354_;
        if _e187.unnamed_1 {
            phi_1065_ = mask_Masked(_e187.unnamed.visibility, 0u, false);
        } else {
            let _e192 = (_e77 < 0.5f);
            if (_e77 > 0f) {
                phi_367_ = (_e77 < 1f);
            } else {
                phi_367_ = false;
            }
            let _e196 = phi_367_;
            let _e198 = samples.member[_e64.first_primitive].position;
            let _e202 = p.member.previous.eye;
            let _e205 = (_e75.x - _e202.x);
            let _e208 = (_e75.y - _e202.y);
            let _e211 = (_e75.z - _e202.z);
            let _e213 = p.member.previous.forward;
            let _e221 = (((_e205 * _e213.x) + (_e208 * _e213.y)) + (_e211 * _e213.z));
            let _e223 = p.member.previous.right;
            let _e233 = p.member.previous.right;
            let _e248 = p.member.previous.up;
            let _e258 = p.member.previous.up;
            let _e276 = p.member.previous.size[0u];
            let _e283 = p.member.previous.size[1u];
            let _e287 = p.member.current.eye;
            let _e290 = (_e198.x - _e287.x);
            let _e293 = (_e198.y - _e287.y);
            let _e296 = (_e198.z - _e287.z);
            let _e298 = p.member.current.forward;
            let _e306 = (((_e290 * _e298.x) + (_e293 * _e298.y)) + (_e296 * _e298.z));
            let _e308 = p.member.current.right;
            let _e318 = p.member.current.right;
            let _e333 = p.member.current.up;
            let _e343 = p.member.current.up;
            let _e361 = p.member.current.size[0u];
            let _e368 = p.member.current.size[1u];
            let _e371 = ((((((((_e205 * _e223.x) + (_e208 * _e223.y)) + (_e211 * _e223.z)) / ((((_e233.x * _e233.x) + (_e233.y * _e233.y)) + (_e233.z * _e233.z)) * _e221)) * 0.5f) + 0.5f) * f32(_e276)) - (((((((_e290 * _e308.x) + (_e293 * _e308.y)) + (_e296 * _e308.z)) / ((((_e318.x * _e318.x) + (_e318.y * _e318.y)) + (_e318.z * _e318.z)) * _e306)) * 0.5f) + 0.5f) * f32(_e361)));
            let _e372 = (((0.5f - (((((_e205 * _e248.x) + (_e208 * _e248.y)) + (_e211 * _e248.z)) / ((((_e258.x * _e258.x) + (_e258.y * _e258.y)) + (_e258.z * _e258.z)) * _e221)) * 0.5f)) * f32(_e283)) - ((0.5f - (((((_e290 * _e333.x) + (_e293 * _e333.y)) + (_e296 * _e333.z)) / ((((_e343.x * _e343.x) + (_e343.y * _e343.y)) + (_e343.z * _e343.z)) * _e306)) * 0.5f)) * f32(_e368)));
            let _e376 = p.member.current.size[0u];
            let _e378 = p.member.current.size[1u];
            let _e382 = ((f32(_e48.x) + 0.5f) + _e371);
            if (_e382 > -8388608f) {
                let _e394 = f32(select(0i, select(select(i32(_e382), i32(-2147483648), (_e382 < bitcast<f32>(3472883712u))), 2147483647i, (_e382 > bitcast<f32>(1325400063u))), (_e382 == _e382)));
                if (_e394 > _e382) {
                    phi_572_ = 1f;
                } else {
                    phi_572_ = 0f;
                }
                let _e397 = phi_572_;
                if (_e382 < 8388608f) {
                    phi_577_ = (_e394 - _e397);
                    phi_578_ = false;
                } else {
                    phi_577_ = f32();
                    phi_578_ = true;
                }
                let _e400 = phi_577_;
                let _e402 = phi_578_;
                phi_579_ = _e400;
                phi_580_ = _e402;
            } else {
                phi_579_ = f32();
                phi_580_ = true;
            }
            let _e404 = phi_579_;
            let _e406 = phi_580_;
            if _e406 {
                phi_584_ = _e382;
            } else {
                phi_584_ = _e404;
            }
            let _e408 = phi_584_;
            let _e411 = ((f32(_e48.y) + 0.5f) + _e372);
            if (_e411 > -8388608f) {
                let _e423 = f32(select(0i, select(select(i32(_e411), i32(-2147483648), (_e411 < bitcast<f32>(3472883712u))), 2147483647i, (_e411 > bitcast<f32>(1325400063u))), (_e411 == _e411)));
                if (_e423 > _e411) {
                    phi_607_ = 1f;
                } else {
                    phi_607_ = 0f;
                }
                let _e426 = phi_607_;
                if (_e411 < 8388608f) {
                    phi_612_ = (_e423 - _e426);
                    phi_613_ = false;
                } else {
                    phi_612_ = f32();
                    phi_613_ = true;
                }
                let _e429 = phi_612_;
                let _e431 = phi_613_;
                phi_614_ = _e429;
                phi_615_ = _e431;
            } else {
                phi_614_ = f32();
                phi_615_ = true;
            }
            let _e433 = phi_614_;
            let _e435 = phi_615_;
            if _e435 {
                phi_619_ = _e411;
            } else {
                phi_619_ = _e433;
            }
            let _e437 = phi_619_;
            if (_e408 >= 0f) {
                if (_e437 >= 0f) {
                    if (_e408 < f32(_e376)) {
                        let _e443 = (_e437 < f32(_e378));
                        if (_e371 == 0f) {
                            phi_640_ = (_e372 == 0f);
                        } else {
                            phi_640_ = false;
                        }
                        let _e447 = phi_640_;
                        if _e443 {
                            phi_659_ = vec2<u32>(select(select(u32(_e408), 0u, (_e408 < bitcast<f32>(0u))), 4294967295u, (_e408 > bitcast<f32>(1333788671u))), select(select(u32(_e437), 0u, (_e437 < bitcast<f32>(0u))), 4294967295u, (_e437 > bitcast<f32>(1333788671u))));
                            phi_660_ = false;
                        } else {
                            phi_659_ = vec2<u32>();
                            phi_660_ = true;
                        }
                        let _e464 = phi_659_;
                        let _e466 = phi_660_;
                        phi_661_ = _e447;
                        phi_662_ = _e443;
                        phi_663_ = _e464;
                        phi_664_ = _e447;
                        phi_665_ = _e443;
                        phi_666_ = false;
                        phi_667_ = _e466;
                    } else {
                        phi_661_ = bool();
                        phi_662_ = bool();
                        phi_663_ = vec2<u32>();
                        phi_664_ = bool();
                        phi_665_ = bool();
                        phi_666_ = true;
                        phi_667_ = false;
                    }
                    let _e468 = phi_661_;
                    let _e470 = phi_662_;
                    let _e472 = phi_663_;
                    let _e474 = phi_664_;
                    let _e476 = phi_665_;
                    let _e478 = phi_666_;
                    let _e480 = phi_667_;
                    phi_668_ = _e468;
                    phi_669_ = _e470;
                    phi_670_ = _e472;
                    phi_671_ = _e474;
                    phi_672_ = _e476;
                    phi_673_ = _e478;
                    phi_674_ = _e480;
                } else {
                    phi_668_ = bool();
                    phi_669_ = bool();
                    phi_670_ = vec2<u32>();
                    phi_671_ = bool();
                    phi_672_ = bool();
                    phi_673_ = true;
                    phi_674_ = false;
                }
                let _e482 = phi_668_;
                let _e484 = phi_669_;
                let _e486 = phi_670_;
                let _e488 = phi_671_;
                let _e490 = phi_672_;
                let _e492 = phi_673_;
                let _e494 = phi_674_;
                phi_675_ = _e482;
                phi_676_ = _e484;
                phi_677_ = _e486;
                phi_678_ = _e488;
                phi_679_ = _e490;
                phi_680_ = _e492;
                phi_681_ = _e494;
            } else {
                phi_675_ = bool();
                phi_676_ = bool();
                phi_677_ = vec2<u32>();
                phi_678_ = bool();
                phi_679_ = bool();
                phi_680_ = true;
                phi_681_ = false;
            }
            let _e496 = phi_675_;
            let _e498 = phi_676_;
            let _e500 = phi_677_;
            let _e502 = phi_678_;
            let _e504 = phi_679_;
            let _e506 = phi_680_;
            let _e508 = phi_681_;
            if _e506 {
                if (_e371 == 0f) {
                    phi_690_ = (_e372 == 0f);
                } else {
                    phi_690_ = false;
                }
                let _e512 = phi_690_;
                phi_691_ = _e512;
                phi_692_ = false;
                phi_693_ = true;
            } else {
                phi_691_ = _e502;
                phi_692_ = _e504;
                phi_693_ = _e508;
            }
            let _e514 = phi_691_;
            let _e516 = phi_692_;
            let _e518 = phi_693_;
            if _e518 {
                phi_697_ = _e514;
                phi_698_ = _e516;
                phi_699_ = vec2<u32>(_e48.x, _e48.y);
            } else {
                phi_697_ = _e496;
                phi_698_ = _e498;
                phi_699_ = _e500;
            }
            let _e520 = phi_697_;
            let _e522 = phi_698_;
            let _e524 = phi_699_;
            let _e534 = lt_mask_Reprojection(vec2<u32>(_e524.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e541 = lt_mask_Reprojection(vec2<u32>(_e534.pixel.x, _e524.y), _e534.is_valid, _e534.has_moved);
            let _e545 = lt_mask_Reprojection(_e541.pixel, _e522, _e541.has_moved);
            let _e549 = lt_mask_Reprojection(_e545.pixel, _e545.is_valid, !(_e520));
            if _e522 {
                let _e552 = p.member.previous.eye;
                let _e563 = p.member.previous.forward;
                let _e572 = (((((_e75.x - _e552.x) * _e563.x) + ((_e75.y - _e552.y) * _e563.y)) + ((_e75.z - _e552.z) * _e563.z)) > 0f);
                let _e576 = lt_mask_Reprojection(_e549.pixel, _e572, _e549.has_moved);
                if _e572 {
                    let _e578 = p.member.flags;
                    phi_741_ = ((_e578 & 1u) != 0u);
                    phi_742_ = false;
                } else {
                    phi_741_ = bool();
                    phi_742_ = true;
                }
                let _e582 = phi_741_;
                let _e584 = phi_742_;
                phi_744_ = _e582;
                phi_745_ = _e576;
                phi_746_ = _e576;
                phi_747_ = _e584;
            } else {
                phi_744_ = bool();
                phi_745_ = lt_mask_Reprojection();
                phi_746_ = lt_mask_Reprojection(_e549.pixel, false, _e549.has_moved);
                phi_747_ = true;
            }
            let _e590 = phi_744_;
            let _e592 = phi_745_;
            let _e594 = phi_746_;
            let _e596 = phi_747_;
            if _e596 {
                phi_751_ = false;
                phi_752_ = _e594;
            } else {
                phi_751_ = _e590;
                phi_752_ = _e592;
            }
            let _e598 = phi_751_;
            let _e600 = phi_752_;
            let _e604 = lt_mask_Reprojection(_e600.pixel, _e598, _e600.has_moved);
            let _e606 = p.member.flags;
            if _e604.has_moved {
                let _e611 = p.member.flags;
                phi_766_ = ((_e611 & 4u) == 0u);
            } else {
                phi_766_ = false;
            }
            let _e615 = phi_766_;
            if ((_e606 & 2u) != 0u) {
                if false {
                    phi_779_ = bool();
                    phi_780_ = true;
                } else {
                    if true {
                        phi_777_ = !(_e615);
                        phi_778_ = false;
                    } else {
                        phi_777_ = bool();
                        phi_778_ = true;
                    }
                    let _e618 = phi_777_;
                    let _e620 = phi_778_;
                    phi_779_ = _e618;
                    phi_780_ = _e620;
                }
                let _e622 = phi_779_;
                let _e624 = phi_780_;
                phi_781_ = _e622;
                phi_782_ = _e624;
            } else {
                phi_781_ = bool();
                phi_782_ = true;
            }
            let _e626 = phi_781_;
            let _e628 = phi_782_;
            if _e628 {
                phi_786_ = false;
            } else {
                phi_786_ = _e626;
            }
            let _e630 = phi_786_;
            let _e631 = lt_mask_Neighbourhood(false, true);
            if _e196 {
                phi_791_ = _e630;
            } else {
                phi_791_ = false;
            }
            let _e633 = phi_791_;
            if _e633 {
                if _e598 {
                    if _e604.has_moved {
                        let _e636 = p.member.moving_pattern;
                        phi_806_ = _e636;
                    } else {
                        let _e638 = p.member.still_pattern;
                        phi_806_ = _e638;
                    }
                    let _e640 = phi_806_;
                    phi_808_ = 0u;
                    phi_811_ = _e631;
                    loop {
                        let _e642 = phi_808_;
                        let _e644 = phi_811_;
                        local_1 = _e644;
                        if (1u <= _e640) {
                            if (_e640 <= 4u) {
                                phi_823_ = false;
                            } else {
                                phi_823_ = true;
                            }
                            let _e648 = phi_823_;
                            phi_824_ = _e648;
                        } else {
                            phi_824_ = true;
                        }
                        let _e650 = phi_824_;
                        if _e650 {
                            switch bitcast<i32>(_e640) {
                                case 5: {
                                    phi_832_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_832_ = 25u;
                                    break;
                                }
                                default: {
                                    phi_832_ = 9u;
                                    break;
                                }
                            }
                            let _e653 = phi_832_;
                            phi_833_ = _e653;
                        } else {
                            phi_833_ = 5u;
                        }
                        let _e655 = phi_833_;
                        let _e656 = (_e642 < _e655);
                        if _e656 {
                            let _e662 = p.member.frame;
                            let _e666 = p.member.current.size[0u];
                            let _e668 = p.member.current.size[1u];
                            switch bitcast<i32>(_e640) {
                                case 1: {
                                    let _e678 = lt_mask_pattern_plus(_e642);
                                    phi_908_ = vec2<i32>(_e678.x, _e678.y);
                                    break;
                                }
                                case 2: {
                                    let _e682 = lt_mask_pattern_cross(_e642);
                                    phi_908_ = vec2<i32>(_e682.x, _e682.y);
                                    break;
                                }
                                case 3: {
                                    let _e688 = lt_mask_pattern_plus_or_cross(_e642, ((_e604.pixel.x + _e604.pixel.y) & 1u));
                                    phi_908_ = vec2<i32>(_e688.x, _e688.y);
                                    break;
                                }
                                case 4: {
                                    let _e693 = lt_mask_pattern_plus_or_cross(_e642, (_e662 & 1u));
                                    phi_908_ = vec2<i32>(_e693.x, _e693.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e662 & 3u)) {
                                        case 0: {
                                            phi_892_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_892_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_892_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_892_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e704 = phi_892_;
                                    phi_908_ = (_e704 + vec2<i32>(bitcast<i32>((_e642 & 1u)), bitcast<i32>(((_e642 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_908_ = vec2<i32>((bitcast<i32>((_e642 % 5u)) - 2i), (bitcast<i32>(((_e642 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                default: {
                                    phi_908_ = vec2<i32>((bitcast<i32>((_e642 % 3u)) - 1i), (bitcast<i32>(((_e642 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e722 = phi_908_;
                            let _e725 = lt_mask_pattern_step_clamped(_e604.pixel.x, _e722.x, _e666);
                            let _e726 = lt_mask_pattern_step_clamped(_e604.pixel.y, _e722.y, _e668);
                            let _e728 = ((_e726 * _e72) + _e725);
                            if (_e728 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e732 = last_bits.member[(0u + _e728)];
                            if ((_e732 & 2u) == 0u) {
                                phi_931_ = (_e732 & 1u);
                            } else {
                                phi_931_ = (_e732 & 7u);
                            }
                            let _e738 = phi_931_;
                            if _e644.any_expands {
                                phi_957_ = true;
                            } else {
                                if ((_e738 & 2u) != 0u) {
                                    if (((_e738 & 4u) != 0u) != _e192) {
                                        phi_948_ = false;
                                    } else {
                                        phi_948_ = true;
                                    }
                                    let _e747 = phi_948_;
                                    phi_949_ = _e747;
                                } else {
                                    phi_949_ = true;
                                }
                                let _e749 = phi_949_;
                                if _e749 {
                                    phi_956_ = (((_e738 & 1u) != 0u) != _e192);
                                } else {
                                    phi_956_ = true;
                                }
                                let _e754 = phi_956_;
                                phi_957_ = _e754;
                            }
                            let _e756 = phi_957_;
                            if _e644.all_remove {
                                if (((_e738 & 1u) != 0u) == _e192) {
                                    if ((_e738 & 2u) != 0u) {
                                        phi_975_ = (((_e738 & 4u) != 0u) == _e192);
                                    } else {
                                        phi_975_ = true;
                                    }
                                    let _e766 = phi_975_;
                                    phi_976_ = _e766;
                                } else {
                                    phi_976_ = false;
                                }
                                let _e768 = phi_976_;
                                phi_977_ = _e768;
                            } else {
                                phi_977_ = false;
                            }
                            let _e770 = phi_977_;
                            phi_809_ = (_e642 + 1u);
                            phi_812_ = lt_mask_Neighbourhood(_e756, _e770);
                        } else {
                            phi_809_ = u32();
                            phi_812_ = lt_mask_Neighbourhood();
                        }
                        let _e774 = phi_809_;
                        let _e776 = phi_812_;
                        continue;
                        continuing {
                            phi_808_ = _e774;
                            phi_811_ = _e776;
                            break if !(_e656);
                        }
                    }
                    let _e941 = local_1;
                    phi_980_ = _e941;
                } else {
                    phi_980_ = _e631;
                }
                let _e779 = phi_980_;
                phi_981_ = _e779;
            } else {
                phi_981_ = _e631;
            }
            let _e781 = phi_981_;
            if (_e77 != 0.5f) {
                if _e598 {
                    if _e196 {
                        phi_1007_ = true;
                    } else {
                        if _e781.any_expands {
                            phi_1006_ = false;
                        } else {
                            phi_1006_ = true;
                        }
                        let _e786 = phi_1006_;
                        phi_1007_ = _e786;
                    }
                    let _e788 = phi_1007_;
                    if _e788 {
                        if _e196 {
                            if _e630 {
                                if _e781.all_remove {
                                    phi_1020_ = false;
                                } else {
                                    phi_1020_ = true;
                                }
                                let _e790 = phi_1020_;
                                phi_1021_ = _e790;
                            } else {
                                phi_1021_ = true;
                            }
                            let _e792 = phi_1021_;
                            phi_1022_ = _e792;
                        } else {
                            phi_1022_ = true;
                        }
                        let _e794 = phi_1022_;
                        if _e794 {
                            if _e196 {
                                phi_1029_ = 1u;
                            } else {
                                phi_1029_ = 0u;
                            }
                            let _e796 = phi_1029_;
                            phi_1030_ = _e796;
                        } else {
                            phi_1030_ = 5u;
                        }
                        let _e798 = phi_1030_;
                        phi_1031_ = _e798;
                    } else {
                        phi_1031_ = 4u;
                    }
                    let _e800 = phi_1031_;
                    phi_1032_ = _e800;
                } else {
                    phi_1032_ = 3u;
                }
                let _e802 = phi_1032_;
                phi_1033_ = _e802;
            } else {
                phi_1033_ = 2u;
            }
            let _e804 = phi_1033_;
            if !((_e804 == 0u)) {
                phi_1041_ = !((_e804 == 5u));
            } else {
                phi_1041_ = false;
            }
            let _e810 = phi_1041_;
            if _e810 {
                if _e192 {
                    phi_1049_ = (2u | 1u);
                } else {
                    phi_1049_ = 2u;
                }
                let _e813 = phi_1049_;
                if false {
                    phi_1054_ = (_e813 | 4u);
                } else {
                    phi_1054_ = _e813;
                }
                let _e816 = phi_1054_;
                phi_1059_ = _e816;
            } else {
                if _e192 {
                    phi_1058_ = 1u;
                } else {
                    phi_1058_ = 0u;
                }
                let _e818 = phi_1058_;
                phi_1059_ = _e818;
            }
            let _e820 = phi_1059_;
            if _e192 {
                phi_1063_ = 0f;
            } else {
                phi_1063_ = 1f;
            }
            let _e822 = phi_1063_;
            phi_1065_ = mask_Masked(_e822, _e820, _e810);
        }
        let _e825 = phi_1065_;
        visibility.member[_e64.first_primitive] = _e825.visibility;
        bits.member[_e64.first_primitive] = _e825.bits;
        phi_1071_ = _e825.needs_ray;
        phi_1072_ = _e64.first_primitive;
    } else {
        phi_1071_ = false;
        phi_1072_ = 0u;
    }
    let _e832 = phi_1071_;
    let _e834 = phi_1072_;
    if (_e49 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e832 {
        let _e838 = atomicAdd((&shared_[0u]), 1u);
        phi_1083_ = _e838;
    } else {
        phi_1083_ = 0u;
    }
    let _e840 = phi_1083_;
    workgroupBarrier();
    if (_e49 == 0u) {
        let _e844 = atomicLoad((&shared_[0u]));
        let _e845 = atomicAdd((&list.member[3u]), _e844);
        atomicStore((&shared_[1u]), _e845);
    }
    workgroupBarrier();
    if _e832 {
        let _e848 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e848) + _e840)]), _e834);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
