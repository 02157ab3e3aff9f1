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
    var phi_161_: lt_bvh_traverse_Tree;
    var phi_162_: bool;
    var phi_163_: lt_bvh_traverse_Tree;
    var phi_164_: bool;
    var phi_169_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_161_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_162_ = false;
        } else {
            phi_161_ = lt_bvh_traverse_Tree();
            phi_162_ = true;
        }
        let _e65 = phi_161_;
        let _e67 = phi_162_;
        phi_163_ = _e65;
        phi_164_ = _e67;
    } else {
        phi_163_ = lt_bvh_traverse_Tree();
        phi_164_ = true;
    }
    let _e69 = phi_163_;
    let _e71 = phi_164_;
    if _e71 {
        phi_169_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_169_ = _e69;
    }
    let _e76 = phi_169_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_187_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_187_ = vec2(0i);
            break;
        }
        case 1: {
            phi_187_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_187_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_187_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_187_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e61 = phi_187_;
    return vec2<i32>(_e61.x, _e61.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_205_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_205_ = vec2(0i);
            break;
        }
        case 1: {
            phi_205_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_205_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_205_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_205_ = vec2(1i);
            break;
        }
    }
    let _e61 = phi_205_;
    return vec2<i32>(_e61.x, _e61.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_224_: vec2<i32>;

    if (param_6 == 0u) {
        let _e55 = lt_mask_pattern_plus(param_5);
        phi_224_ = vec2<i32>(_e55.x, _e55.y);
    } else {
        let _e59 = lt_mask_pattern_cross(param_5);
        phi_224_ = vec2<i32>(_e59.x, _e59.y);
    }
    let _e64 = phi_224_;
    return vec2<i32>(_e64.x, _e64.y);
}

fn lt_mask_pattern_step_clamped(param_7: u32, param_8: i32, param_9: u32) -> u32 {
    var phi_245_: u32;
    var phi_246_: u32;

    let _e56 = (bitcast<i32>(param_7) + param_8);
    if (_e56 < 0i) {
        phi_246_ = 0u;
    } else {
        if (_e56 >= bitcast<i32>(param_9)) {
            phi_245_ = (param_9 - 1u);
        } else {
            phi_245_ = bitcast<u32>(_e56);
        }
        let _e63 = phi_245_;
        phi_246_ = _e63;
    }
    let _e65 = phi_246_;
    return _e65;
}

fn function_() {
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_314_: bool;
    var phi_315_: bool;
    var phi_319_: bool;
    var phi_363_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_367_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_380_: bool;
    var phi_585_: f32;
    var phi_590_: f32;
    var phi_591_: bool;
    var phi_592_: f32;
    var phi_593_: bool;
    var phi_597_: f32;
    var phi_620_: f32;
    var phi_625_: f32;
    var phi_626_: bool;
    var phi_627_: f32;
    var phi_628_: bool;
    var phi_632_: f32;
    var phi_653_: bool;
    var phi_672_: vec2<u32>;
    var phi_673_: bool;
    var phi_674_: bool;
    var phi_675_: bool;
    var phi_676_: vec2<u32>;
    var phi_677_: bool;
    var phi_678_: bool;
    var phi_679_: bool;
    var phi_680_: bool;
    var phi_681_: bool;
    var phi_682_: bool;
    var phi_683_: vec2<u32>;
    var phi_684_: bool;
    var phi_685_: bool;
    var phi_686_: bool;
    var phi_687_: bool;
    var phi_688_: bool;
    var phi_689_: bool;
    var phi_690_: vec2<u32>;
    var phi_691_: bool;
    var phi_692_: bool;
    var phi_693_: bool;
    var phi_694_: bool;
    var phi_703_: bool;
    var phi_704_: bool;
    var phi_705_: bool;
    var phi_706_: bool;
    var phi_710_: bool;
    var phi_711_: bool;
    var phi_712_: vec2<u32>;
    var phi_801_: bool;
    var phi_805_: f32;
    var phi_809_: lt_mask_Reprojection;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_821_: bool;
    var phi_822_: lt_mask_Reprojection;
    var phi_823_: lt_mask_Reprojection;
    var phi_824_: bool;
    var phi_828_: bool;
    var phi_829_: lt_mask_Reprojection;
    var phi_843_: bool;
    var phi_854_: bool;
    var phi_855_: bool;
    var phi_856_: bool;
    var phi_857_: bool;
    var phi_858_: bool;
    var phi_859_: bool;
    var phi_863_: bool;
    var phi_868_: bool;
    var phi_883_: u32;
    var phi_885_: u32;
    var phi_888_: lt_mask_Neighbourhood;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_909_: u32;
    var phi_910_: u32;
    var phi_969_: vec2<i32>;
    var phi_985_: vec2<i32>;
    var phi_1008_: u32;
    var phi_1025_: bool;
    var phi_1026_: bool;
    var phi_1033_: bool;
    var phi_1034_: bool;
    var phi_1052_: bool;
    var phi_1053_: bool;
    var phi_1054_: bool;
    var phi_886_: u32;
    var phi_889_: lt_mask_Neighbourhood;
    var phi_1057_: lt_mask_Neighbourhood;
    var phi_1058_: lt_mask_Neighbourhood;
    var phi_1083_: bool;
    var phi_1084_: bool;
    var phi_1097_: bool;
    var phi_1098_: bool;
    var phi_1099_: bool;
    var phi_1106_: u32;
    var phi_1107_: u32;
    var phi_1108_: u32;
    var phi_1109_: u32;
    var phi_1110_: u32;
    var phi_1118_: bool;
    var phi_1126_: u32;
    var phi_1131_: u32;
    var phi_1135_: u32;
    var phi_1136_: u32;
    var phi_1140_: f32;
    var phi_1142_: mask_Masked;
    var phi_1170_: bool;
    var phi_1171_: bool;
    var phi_1172_: bool;
    var phi_1173_: bool;
    var phi_1177_: bool;
    var phi_1205_: f32;
    var phi_1208_: bool;
    var phi_1209_: u32;
    var phi_1220_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e52 = id_1;
    let _e53 = local_2;
    let _e69 = p.member.current.size[0u];
    let _e71 = p.member.current.size[1u];
    let _e72 = lt_shaders_entry_pixel_index(_e52, _e69, _e71);
    if (bitcast<i32>(_e72.root) != 0i) {
        let _e80 = p.member.current.size[0u];
        let _e83 = samples.member[_e72.first_primitive].position;
        let _e85 = visibility.member[_e72.first_primitive];
        let _e89 = p.member.light;
        let _e92 = samples.member[_e72.first_primitive].normal[0u];
        let _e94 = global[0u];
        if (_e92 == _e94) {
            let _e97 = samples.member[_e72.first_primitive].normal[1u];
            let _e99 = global[1u];
            if (_e97 == _e99) {
                let _e102 = samples.member[_e72.first_primitive].normal[2u];
                let _e104 = global[2u];
                phi_312_ = (_e102 == _e104);
                phi_313_ = false;
            } else {
                phi_312_ = bool();
                phi_313_ = true;
            }
            let _e107 = phi_312_;
            let _e109 = phi_313_;
            phi_314_ = _e107;
            phi_315_ = _e109;
        } else {
            phi_314_ = bool();
            phi_315_ = true;
        }
        let _e111 = phi_314_;
        let _e113 = phi_315_;
        if _e113 {
            phi_319_ = false;
        } else {
            phi_319_ = _e111;
        }
        let _e115 = phi_319_;
        if !(_e115) {
            let _e118 = samples.member[_e72.first_primitive].normal;
            let _e120 = samples.member[_e72.first_primitive].position;
            if ((((_e118.x * (_e89.x - (_e120.x * _e89.w))) + (_e118.y * (_e89.y - (_e120.y * _e89.w)))) + (_e118.z * (_e89.z - (_e120.z * _e89.w)))) > 0f) {
                let _e144 = samples.member[_e72.first_primitive].flags;
                let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e152.unnamed.visibility, false), _e152.unnamed_1);
                phi_363_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e158.unnamed, ((_e144 & 1u) == 0u));
            } else {
                let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
                phi_363_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, true);
            }
            let _e178 = phi_363_;
            phi_367_ = _e178;
        } else {
            let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e184.unnamed.visibility, false), _e184.unnamed_1);
            phi_367_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e190.unnamed, true);
        }
        let _e195 = phi_367_;
        if _e195.unnamed_1 {
            phi_1142_ = mask_Masked(_e195.unnamed.visibility, 0u, false);
        } else {
            let _e200 = (_e85 < 0.5f);
            if (_e85 > 0f) {
                phi_380_ = (_e85 < 1f);
            } else {
                phi_380_ = false;
            }
            let _e204 = phi_380_;
            let _e206 = samples.member[_e72.first_primitive].position;
            let _e210 = p.member.previous.eye;
            let _e213 = (_e83.x - _e210.x);
            let _e216 = (_e83.y - _e210.y);
            let _e219 = (_e83.z - _e210.z);
            let _e221 = p.member.previous.forward;
            let _e229 = (((_e213 * _e221.x) + (_e216 * _e221.y)) + (_e219 * _e221.z));
            let _e231 = p.member.previous.right;
            let _e241 = p.member.previous.right;
            let _e256 = p.member.previous.up;
            let _e266 = p.member.previous.up;
            let _e284 = p.member.previous.size[0u];
            let _e291 = p.member.previous.size[1u];
            let _e295 = p.member.current.eye;
            let _e298 = (_e206.x - _e295.x);
            let _e301 = (_e206.y - _e295.y);
            let _e304 = (_e206.z - _e295.z);
            let _e306 = p.member.current.forward;
            let _e314 = (((_e298 * _e306.x) + (_e301 * _e306.y)) + (_e304 * _e306.z));
            let _e316 = p.member.current.right;
            let _e326 = p.member.current.right;
            let _e341 = p.member.current.up;
            let _e351 = p.member.current.up;
            let _e369 = p.member.current.size[0u];
            let _e376 = p.member.current.size[1u];
            let _e379 = ((((((((_e213 * _e231.x) + (_e216 * _e231.y)) + (_e219 * _e231.z)) / ((((_e241.x * _e241.x) + (_e241.y * _e241.y)) + (_e241.z * _e241.z)) * _e229)) * 0.5f) + 0.5f) * f32(_e284)) - (((((((_e298 * _e316.x) + (_e301 * _e316.y)) + (_e304 * _e316.z)) / ((((_e326.x * _e326.x) + (_e326.y * _e326.y)) + (_e326.z * _e326.z)) * _e314)) * 0.5f) + 0.5f) * f32(_e369)));
            let _e380 = (((0.5f - (((((_e213 * _e256.x) + (_e216 * _e256.y)) + (_e219 * _e256.z)) / ((((_e266.x * _e266.x) + (_e266.y * _e266.y)) + (_e266.z * _e266.z)) * _e229)) * 0.5f)) * f32(_e291)) - ((0.5f - (((((_e298 * _e341.x) + (_e301 * _e341.y)) + (_e304 * _e341.z)) / ((((_e351.x * _e351.x) + (_e351.y * _e351.y)) + (_e351.z * _e351.z)) * _e314)) * 0.5f)) * f32(_e376)));
            let _e384 = p.member.current.size[0u];
            let _e386 = p.member.current.size[1u];
            let _e390 = ((f32(_e52.x) + 0.5f) + _e379);
            if (_e390 > -8388608f) {
                let _e402 = f32(select(0i, select(select(i32(_e390), i32(-2147483648), (_e390 < bitcast<f32>(3472883712u))), 2147483647i, (_e390 > bitcast<f32>(1325400063u))), (_e390 == _e390)));
                if (_e402 > _e390) {
                    phi_585_ = 1f;
                } else {
                    phi_585_ = 0f;
                }
                let _e405 = phi_585_;
                if (_e390 < 8388608f) {
                    phi_590_ = (_e402 - _e405);
                    phi_591_ = false;
                } else {
                    phi_590_ = f32();
                    phi_591_ = true;
                }
                let _e408 = phi_590_;
                let _e410 = phi_591_;
                phi_592_ = _e408;
                phi_593_ = _e410;
            } else {
                phi_592_ = f32();
                phi_593_ = true;
            }
            let _e412 = phi_592_;
            let _e414 = phi_593_;
            if _e414 {
                phi_597_ = _e390;
            } else {
                phi_597_ = _e412;
            }
            let _e416 = phi_597_;
            let _e419 = ((f32(_e52.y) + 0.5f) + _e380);
            if (_e419 > -8388608f) {
                let _e431 = f32(select(0i, select(select(i32(_e419), i32(-2147483648), (_e419 < bitcast<f32>(3472883712u))), 2147483647i, (_e419 > bitcast<f32>(1325400063u))), (_e419 == _e419)));
                if (_e431 > _e419) {
                    phi_620_ = 1f;
                } else {
                    phi_620_ = 0f;
                }
                let _e434 = phi_620_;
                if (_e419 < 8388608f) {
                    phi_625_ = (_e431 - _e434);
                    phi_626_ = false;
                } else {
                    phi_625_ = f32();
                    phi_626_ = true;
                }
                let _e437 = phi_625_;
                let _e439 = phi_626_;
                phi_627_ = _e437;
                phi_628_ = _e439;
            } else {
                phi_627_ = f32();
                phi_628_ = true;
            }
            let _e441 = phi_627_;
            let _e443 = phi_628_;
            if _e443 {
                phi_632_ = _e419;
            } else {
                phi_632_ = _e441;
            }
            let _e445 = phi_632_;
            if (_e416 >= 0f) {
                if (_e445 >= 0f) {
                    if (_e416 < f32(_e384)) {
                        let _e451 = (_e445 < f32(_e386));
                        if (_e379 == 0f) {
                            phi_653_ = (_e380 == 0f);
                        } else {
                            phi_653_ = false;
                        }
                        let _e455 = phi_653_;
                        if _e451 {
                            phi_672_ = vec2<u32>(select(select(u32(_e416), 0u, (_e416 < bitcast<f32>(0u))), 4294967295u, (_e416 > bitcast<f32>(1333788671u))), select(select(u32(_e445), 0u, (_e445 < bitcast<f32>(0u))), 4294967295u, (_e445 > bitcast<f32>(1333788671u))));
                            phi_673_ = false;
                        } else {
                            phi_672_ = vec2<u32>();
                            phi_673_ = true;
                        }
                        let _e472 = phi_672_;
                        let _e474 = phi_673_;
                        phi_674_ = _e455;
                        phi_675_ = _e451;
                        phi_676_ = _e472;
                        phi_677_ = _e455;
                        phi_678_ = _e451;
                        phi_679_ = false;
                        phi_680_ = _e474;
                    } else {
                        phi_674_ = bool();
                        phi_675_ = bool();
                        phi_676_ = vec2<u32>();
                        phi_677_ = bool();
                        phi_678_ = bool();
                        phi_679_ = true;
                        phi_680_ = false;
                    }
                    let _e476 = phi_674_;
                    let _e478 = phi_675_;
                    let _e480 = phi_676_;
                    let _e482 = phi_677_;
                    let _e484 = phi_678_;
                    let _e486 = phi_679_;
                    let _e488 = phi_680_;
                    phi_681_ = _e476;
                    phi_682_ = _e478;
                    phi_683_ = _e480;
                    phi_684_ = _e482;
                    phi_685_ = _e484;
                    phi_686_ = _e486;
                    phi_687_ = _e488;
                } else {
                    phi_681_ = bool();
                    phi_682_ = bool();
                    phi_683_ = vec2<u32>();
                    phi_684_ = bool();
                    phi_685_ = bool();
                    phi_686_ = true;
                    phi_687_ = false;
                }
                let _e490 = phi_681_;
                let _e492 = phi_682_;
                let _e494 = phi_683_;
                let _e496 = phi_684_;
                let _e498 = phi_685_;
                let _e500 = phi_686_;
                let _e502 = phi_687_;
                phi_688_ = _e490;
                phi_689_ = _e492;
                phi_690_ = _e494;
                phi_691_ = _e496;
                phi_692_ = _e498;
                phi_693_ = _e500;
                phi_694_ = _e502;
            } else {
                phi_688_ = bool();
                phi_689_ = bool();
                phi_690_ = vec2<u32>();
                phi_691_ = bool();
                phi_692_ = bool();
                phi_693_ = true;
                phi_694_ = false;
            }
            let _e504 = phi_688_;
            let _e506 = phi_689_;
            let _e508 = phi_690_;
            let _e510 = phi_691_;
            let _e512 = phi_692_;
            let _e514 = phi_693_;
            let _e516 = phi_694_;
            if _e514 {
                if (_e379 == 0f) {
                    phi_703_ = (_e380 == 0f);
                } else {
                    phi_703_ = false;
                }
                let _e520 = phi_703_;
                phi_704_ = _e520;
                phi_705_ = false;
                phi_706_ = true;
            } else {
                phi_704_ = _e510;
                phi_705_ = _e512;
                phi_706_ = _e516;
            }
            let _e522 = phi_704_;
            let _e524 = phi_705_;
            let _e526 = phi_706_;
            if _e526 {
                phi_710_ = _e522;
                phi_711_ = _e524;
                phi_712_ = vec2<u32>(_e52.x, _e52.y);
            } else {
                phi_710_ = _e504;
                phi_711_ = _e506;
                phi_712_ = _e508;
            }
            let _e528 = phi_710_;
            let _e530 = phi_711_;
            let _e532 = phi_712_;
            let _e542 = lt_mask_Reprojection(vec2<u32>(_e532.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e549 = lt_mask_Reprojection(vec2<u32>(_e542.pixel.x, _e532.y), _e542.is_valid, _e542.has_moved);
            let _e553 = lt_mask_Reprojection(_e549.pixel, _e530, _e549.has_moved);
            let _e557 = lt_mask_Reprojection(_e553.pixel, _e553.is_valid, !(_e528));
            if _e530 {
                let _e560 = p.member.previous.eye;
                let _e571 = p.member.previous.forward;
                let _e580 = (((((_e83.x - _e560.x) * _e571.x) + ((_e83.y - _e560.y) * _e571.y)) + ((_e83.z - _e560.z) * _e571.z)) > 0f);
                let _e584 = lt_mask_Reprojection(_e557.pixel, _e580, _e557.has_moved);
                if _e580 {
                    let _e587 = p.member.previous.eye;
                    let _e598 = p.member.previous.forward;
                    let _e606 = ((((_e83.x - _e587.x) * _e598.x) + ((_e83.y - _e587.y) * _e598.y)) + ((_e83.z - _e587.z) * _e598.z));
                    let _e608 = ((_e532.y * _e80) + _e532.x);
                    if (_e608 < arrayLength((&last_depths.member))) {
                    } else {
                        return;
                    }
                    let _e612 = last_depths.member[(0u + _e608)];
                    let _e614 = p.member.depth_tolerance;
                    let _e617 = abs(_e606);
                    let _e618 = abs(_e612);
                    if ((bitcast<u32>(_e618) & 2147483647u) > 2139095040u) {
                        phi_801_ = true;
                    } else {
                        let _e622 = (_e618 > _e617);
                        if _e622 {
                        }
                        phi_801_ = _e622;
                    }
                    let _e624 = phi_801_;
                    if _e624 {
                        phi_805_ = _e618;
                    } else {
                        phi_805_ = _e617;
                    }
                    let _e626 = phi_805_;
                    phi_809_ = lt_mask_Reprojection(_e584.pixel, (abs((_e606 - _e612)) <= (_e614 * _e626)), _e584.has_moved);
                } else {
                    phi_809_ = _e584;
                }
                let _e634 = phi_809_;
                if _e634.is_valid {
                    let _e637 = p.member.flags;
                    phi_818_ = ((_e637 & 1u) != 0u);
                    phi_819_ = false;
                } else {
                    phi_818_ = bool();
                    phi_819_ = true;
                }
                let _e641 = phi_818_;
                let _e643 = phi_819_;
                phi_821_ = _e641;
                phi_822_ = _e634;
                phi_823_ = _e634;
                phi_824_ = _e643;
            } else {
                phi_821_ = bool();
                phi_822_ = lt_mask_Reprojection();
                phi_823_ = lt_mask_Reprojection(_e557.pixel, false, _e557.has_moved);
                phi_824_ = true;
            }
            let _e649 = phi_821_;
            let _e651 = phi_822_;
            let _e653 = phi_823_;
            let _e655 = phi_824_;
            if _e655 {
                phi_828_ = false;
                phi_829_ = _e653;
            } else {
                phi_828_ = _e649;
                phi_829_ = _e651;
            }
            let _e657 = phi_828_;
            let _e659 = phi_829_;
            let _e663 = lt_mask_Reprojection(_e659.pixel, _e657, _e659.has_moved);
            let _e665 = p.member.flags;
            if _e663.has_moved {
                let _e670 = p.member.flags;
                phi_843_ = ((_e670 & 4u) == 0u);
            } else {
                phi_843_ = false;
            }
            let _e674 = phi_843_;
            if ((_e665 & 2u) != 0u) {
                if false {
                    phi_856_ = bool();
                    phi_857_ = true;
                } else {
                    if true {
                        phi_854_ = !(_e674);
                        phi_855_ = false;
                    } else {
                        phi_854_ = bool();
                        phi_855_ = true;
                    }
                    let _e677 = phi_854_;
                    let _e679 = phi_855_;
                    phi_856_ = _e677;
                    phi_857_ = _e679;
                }
                let _e681 = phi_856_;
                let _e683 = phi_857_;
                phi_858_ = _e681;
                phi_859_ = _e683;
            } else {
                phi_858_ = bool();
                phi_859_ = true;
            }
            let _e685 = phi_858_;
            let _e687 = phi_859_;
            if _e687 {
                phi_863_ = false;
            } else {
                phi_863_ = _e685;
            }
            let _e689 = phi_863_;
            let _e690 = lt_mask_Neighbourhood(false, true);
            if _e204 {
                phi_868_ = _e689;
            } else {
                phi_868_ = false;
            }
            let _e692 = phi_868_;
            if _e692 {
                if _e657 {
                    if _e663.has_moved {
                        let _e695 = p.member.moving_pattern;
                        phi_883_ = _e695;
                    } else {
                        let _e697 = p.member.still_pattern;
                        phi_883_ = _e697;
                    }
                    let _e699 = phi_883_;
                    phi_885_ = 0u;
                    phi_888_ = _e690;
                    loop {
                        let _e701 = phi_885_;
                        let _e703 = phi_888_;
                        local_1 = _e703;
                        if (1u <= _e699) {
                            if (_e699 <= 4u) {
                                phi_900_ = false;
                            } else {
                                phi_900_ = true;
                            }
                            let _e707 = phi_900_;
                            phi_901_ = _e707;
                        } else {
                            phi_901_ = true;
                        }
                        let _e709 = phi_901_;
                        if _e709 {
                            switch bitcast<i32>(_e699) {
                                case 5: {
                                    phi_909_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_909_ = 25u;
                                    break;
                                }
                                default: {
                                    phi_909_ = 9u;
                                    break;
                                }
                            }
                            let _e712 = phi_909_;
                            phi_910_ = _e712;
                        } else {
                            phi_910_ = 5u;
                        }
                        let _e714 = phi_910_;
                        let _e715 = (_e701 < _e714);
                        if _e715 {
                            let _e721 = p.member.frame;
                            let _e725 = p.member.current.size[0u];
                            let _e727 = p.member.current.size[1u];
                            switch bitcast<i32>(_e699) {
                                case 1: {
                                    let _e737 = lt_mask_pattern_plus(_e701);
                                    phi_985_ = vec2<i32>(_e737.x, _e737.y);
                                    break;
                                }
                                case 2: {
                                    let _e741 = lt_mask_pattern_cross(_e701);
                                    phi_985_ = vec2<i32>(_e741.x, _e741.y);
                                    break;
                                }
                                case 3: {
                                    let _e747 = lt_mask_pattern_plus_or_cross(_e701, ((_e663.pixel.x + _e663.pixel.y) & 1u));
                                    phi_985_ = vec2<i32>(_e747.x, _e747.y);
                                    break;
                                }
                                case 4: {
                                    let _e752 = lt_mask_pattern_plus_or_cross(_e701, (_e721 & 1u));
                                    phi_985_ = vec2<i32>(_e752.x, _e752.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e721 & 3u)) {
                                        case 0: {
                                            phi_969_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_969_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_969_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_969_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e763 = phi_969_;
                                    phi_985_ = (_e763 + vec2<i32>(bitcast<i32>((_e701 & 1u)), bitcast<i32>(((_e701 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_985_ = vec2<i32>((bitcast<i32>((_e701 % 5u)) - 2i), (bitcast<i32>(((_e701 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                default: {
                                    phi_985_ = vec2<i32>((bitcast<i32>((_e701 % 3u)) - 1i), (bitcast<i32>(((_e701 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e781 = phi_985_;
                            let _e784 = lt_mask_pattern_step_clamped(_e663.pixel.x, _e781.x, _e725);
                            let _e785 = lt_mask_pattern_step_clamped(_e663.pixel.y, _e781.y, _e727);
                            let _e787 = ((_e785 * _e80) + _e784);
                            if (_e787 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e791 = last_bits.member[(0u + _e787)];
                            if ((_e791 & 2u) == 0u) {
                                phi_1008_ = (_e791 & 1u);
                            } else {
                                phi_1008_ = (_e791 & 7u);
                            }
                            let _e797 = phi_1008_;
                            if _e703.any_expands {
                                phi_1034_ = true;
                            } else {
                                if ((_e797 & 2u) != 0u) {
                                    if (((_e797 & 4u) != 0u) != _e200) {
                                        phi_1025_ = false;
                                    } else {
                                        phi_1025_ = true;
                                    }
                                    let _e806 = phi_1025_;
                                    phi_1026_ = _e806;
                                } else {
                                    phi_1026_ = true;
                                }
                                let _e808 = phi_1026_;
                                if _e808 {
                                    phi_1033_ = (((_e797 & 1u) != 0u) != _e200);
                                } else {
                                    phi_1033_ = true;
                                }
                                let _e813 = phi_1033_;
                                phi_1034_ = _e813;
                            }
                            let _e815 = phi_1034_;
                            if _e703.all_remove {
                                if (((_e797 & 1u) != 0u) == _e200) {
                                    if ((_e797 & 2u) != 0u) {
                                        phi_1052_ = (((_e797 & 4u) != 0u) == _e200);
                                    } else {
                                        phi_1052_ = true;
                                    }
                                    let _e825 = phi_1052_;
                                    phi_1053_ = _e825;
                                } else {
                                    phi_1053_ = false;
                                }
                                let _e827 = phi_1053_;
                                phi_1054_ = _e827;
                            } else {
                                phi_1054_ = false;
                            }
                            let _e829 = phi_1054_;
                            phi_886_ = (_e701 + 1u);
                            phi_889_ = lt_mask_Neighbourhood(_e815, _e829);
                        } else {
                            phi_886_ = u32();
                            phi_889_ = lt_mask_Neighbourhood();
                        }
                        let _e833 = phi_886_;
                        let _e835 = phi_889_;
                        continue;
                        continuing {
                            phi_885_ = _e833;
                            phi_888_ = _e835;
                            break if !(_e715);
                        }
                    }
                    let _e1057 = local_1;
                    phi_1057_ = _e1057;
                } else {
                    phi_1057_ = _e690;
                }
                let _e838 = phi_1057_;
                phi_1058_ = _e838;
            } else {
                phi_1058_ = _e690;
            }
            let _e840 = phi_1058_;
            if (_e85 != 0.5f) {
                if _e657 {
                    if _e204 {
                        phi_1084_ = true;
                    } else {
                        if _e840.any_expands {
                            phi_1083_ = false;
                        } else {
                            phi_1083_ = true;
                        }
                        let _e845 = phi_1083_;
                        phi_1084_ = _e845;
                    }
                    let _e847 = phi_1084_;
                    if _e847 {
                        if _e204 {
                            if _e689 {
                                if _e840.all_remove {
                                    phi_1097_ = false;
                                } else {
                                    phi_1097_ = true;
                                }
                                let _e849 = phi_1097_;
                                phi_1098_ = _e849;
                            } else {
                                phi_1098_ = true;
                            }
                            let _e851 = phi_1098_;
                            phi_1099_ = _e851;
                        } else {
                            phi_1099_ = true;
                        }
                        let _e853 = phi_1099_;
                        if _e853 {
                            if _e204 {
                                phi_1106_ = 1u;
                            } else {
                                phi_1106_ = 0u;
                            }
                            let _e855 = phi_1106_;
                            phi_1107_ = _e855;
                        } else {
                            phi_1107_ = 5u;
                        }
                        let _e857 = phi_1107_;
                        phi_1108_ = _e857;
                    } else {
                        phi_1108_ = 4u;
                    }
                    let _e859 = phi_1108_;
                    phi_1109_ = _e859;
                } else {
                    phi_1109_ = 3u;
                }
                let _e861 = phi_1109_;
                phi_1110_ = _e861;
            } else {
                phi_1110_ = 2u;
            }
            let _e863 = phi_1110_;
            if !((_e863 == 0u)) {
                phi_1118_ = !((_e863 == 5u));
            } else {
                phi_1118_ = false;
            }
            let _e869 = phi_1118_;
            if _e869 {
                if _e200 {
                    phi_1126_ = (2u | 1u);
                } else {
                    phi_1126_ = 2u;
                }
                let _e872 = phi_1126_;
                if false {
                    phi_1131_ = (_e872 | 4u);
                } else {
                    phi_1131_ = _e872;
                }
                let _e875 = phi_1131_;
                phi_1136_ = _e875;
            } else {
                if _e200 {
                    phi_1135_ = 1u;
                } else {
                    phi_1135_ = 0u;
                }
                let _e877 = phi_1135_;
                phi_1136_ = _e877;
            }
            let _e879 = phi_1136_;
            if _e200 {
                phi_1140_ = 0f;
            } else {
                phi_1140_ = 1f;
            }
            let _e881 = phi_1140_;
            phi_1142_ = mask_Masked(_e881, _e879, _e869);
        }
        let _e884 = phi_1142_;
        visibility.member[_e72.first_primitive] = _e884.visibility;
        bits.member[_e72.first_primitive] = _e884.bits;
        let _e892 = samples.member[_e72.first_primitive].normal[0u];
        let _e894 = global[0u];
        if (_e892 == _e894) {
            let _e897 = samples.member[_e72.first_primitive].normal[1u];
            let _e899 = global[1u];
            if (_e897 == _e899) {
                let _e902 = samples.member[_e72.first_primitive].normal[2u];
                let _e904 = global[2u];
                phi_1170_ = (_e902 == _e904);
                phi_1171_ = false;
            } else {
                phi_1170_ = bool();
                phi_1171_ = true;
            }
            let _e907 = phi_1170_;
            let _e909 = phi_1171_;
            phi_1172_ = _e907;
            phi_1173_ = _e909;
        } else {
            phi_1172_ = bool();
            phi_1173_ = true;
        }
        let _e911 = phi_1172_;
        let _e913 = phi_1173_;
        if _e913 {
            phi_1177_ = false;
        } else {
            phi_1177_ = _e911;
        }
        let _e915 = phi_1177_;
        if !(_e915) {
            let _e918 = samples.member[_e72.first_primitive].position;
            let _e920 = p.member.current.eye;
            let _e931 = p.member.current.forward;
            phi_1205_ = ((((_e918.x - _e920.x) * _e931.x) + ((_e918.y - _e920.y) * _e931.y)) + ((_e918.z - _e920.z) * _e931.z));
        } else {
            phi_1205_ = 0f;
        }
        let _e941 = phi_1205_;
        depths.member[_e72.first_primitive] = _e941;
        phi_1208_ = _e884.needs_ray;
        phi_1209_ = _e72.first_primitive;
    } else {
        phi_1208_ = false;
        phi_1209_ = 0u;
    }
    let _e945 = phi_1208_;
    let _e947 = phi_1209_;
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e945 {
        let _e951 = atomicAdd((&shared_[0u]), 1u);
        phi_1220_ = _e951;
    } else {
        phi_1220_ = 0u;
    }
    let _e953 = phi_1220_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e957 = atomicLoad((&shared_[0u]));
        let _e958 = atomicAdd((&list.member[3u]), _e957);
        atomicStore((&shared_[1u]), _e958);
    }
    workgroupBarrier();
    if _e945 {
        let _e961 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e961) + _e953)]), _e947);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
