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
    var phi_857_: u32;
    var phi_859_: u32;
    var phi_862_: lt_mask_Neighbourhood;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_883_: u32;
    var phi_884_: u32;
    var phi_943_: vec2<i32>;
    var phi_959_: vec2<i32>;
    var phi_982_: u32;
    var phi_999_: bool;
    var phi_1000_: bool;
    var phi_1007_: bool;
    var phi_1008_: bool;
    var phi_1026_: bool;
    var phi_1027_: bool;
    var phi_1028_: bool;
    var phi_860_: u32;
    var phi_863_: lt_mask_Neighbourhood;
    var phi_1031_: lt_mask_Neighbourhood;
    var phi_1032_: lt_mask_Neighbourhood;
    var phi_1033_: lt_mask_Neighbourhood;
    var phi_1058_: bool;
    var phi_1059_: bool;
    var phi_1072_: bool;
    var phi_1073_: bool;
    var phi_1074_: bool;
    var phi_1081_: u32;
    var phi_1082_: u32;
    var phi_1083_: u32;
    var phi_1084_: u32;
    var phi_1085_: u32;
    var phi_1093_: bool;
    var phi_1101_: u32;
    var phi_1106_: u32;
    var phi_1110_: u32;
    var phi_1111_: u32;
    var phi_1115_: f32;
    var phi_1117_: mask_Masked;
    var phi_1145_: bool;
    var phi_1146_: bool;
    var phi_1147_: bool;
    var phi_1148_: bool;
    var phi_1152_: bool;
    var phi_1180_: f32;
    var phi_1183_: bool;
    var phi_1184_: u32;
    var phi_1195_: u32;
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
            phi_1117_ = mask_Masked(_e195.unnamed.visibility, 0u, false);
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
            if _e663.has_moved {
            }
            let _e669 = lt_mask_Neighbourhood(false, true);
            if _e204 {
                phi_1033_ = _e669;
            } else {
                if true {
                    if _e657 {
                        if _e663.has_moved {
                            let _e672 = p.member.moving_pattern;
                            phi_857_ = _e672;
                        } else {
                            let _e674 = p.member.still_pattern;
                            phi_857_ = _e674;
                        }
                        let _e676 = phi_857_;
                        phi_859_ = 0u;
                        phi_862_ = _e669;
                        loop {
                            let _e678 = phi_859_;
                            let _e680 = phi_862_;
                            local_1 = _e680;
                            if (1u <= _e676) {
                                if (_e676 <= 4u) {
                                    phi_874_ = false;
                                } else {
                                    phi_874_ = true;
                                }
                                let _e684 = phi_874_;
                                phi_875_ = _e684;
                            } else {
                                phi_875_ = true;
                            }
                            let _e686 = phi_875_;
                            if _e686 {
                                switch bitcast<i32>(_e676) {
                                    case 5: {
                                        phi_883_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_883_ = 25u;
                                        break;
                                    }
                                    default: {
                                        phi_883_ = 9u;
                                        break;
                                    }
                                }
                                let _e689 = phi_883_;
                                phi_884_ = _e689;
                            } else {
                                phi_884_ = 5u;
                            }
                            let _e691 = phi_884_;
                            let _e692 = (_e678 < _e691);
                            if _e692 {
                                let _e698 = p.member.frame;
                                let _e702 = p.member.current.size[0u];
                                let _e704 = p.member.current.size[1u];
                                switch bitcast<i32>(_e676) {
                                    case 1: {
                                        let _e714 = lt_mask_pattern_plus(_e678);
                                        phi_959_ = vec2<i32>(_e714.x, _e714.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e718 = lt_mask_pattern_cross(_e678);
                                        phi_959_ = vec2<i32>(_e718.x, _e718.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e724 = lt_mask_pattern_plus_or_cross(_e678, ((_e663.pixel.x + _e663.pixel.y) & 1u));
                                        phi_959_ = vec2<i32>(_e724.x, _e724.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e729 = lt_mask_pattern_plus_or_cross(_e678, (_e698 & 1u));
                                        phi_959_ = vec2<i32>(_e729.x, _e729.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e698 & 3u)) {
                                            case 0: {
                                                phi_943_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_943_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_943_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_943_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e740 = phi_943_;
                                        phi_959_ = (_e740 + vec2<i32>(bitcast<i32>((_e678 & 1u)), bitcast<i32>(((_e678 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_959_ = vec2<i32>((bitcast<i32>((_e678 % 5u)) - 2i), (bitcast<i32>(((_e678 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    default: {
                                        phi_959_ = vec2<i32>((bitcast<i32>((_e678 % 3u)) - 1i), (bitcast<i32>(((_e678 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e758 = phi_959_;
                                let _e761 = lt_mask_pattern_step_clamped(_e663.pixel.x, _e758.x, _e702);
                                let _e762 = lt_mask_pattern_step_clamped(_e663.pixel.y, _e758.y, _e704);
                                let _e764 = ((_e762 * _e80) + _e761);
                                if (_e764 < arrayLength((&last_bits.member))) {
                                } else {
                                    return;
                                }
                                let _e768 = last_bits.member[(0u + _e764)];
                                if ((_e768 & 2u) == 0u) {
                                    phi_982_ = (_e768 & 1u);
                                } else {
                                    phi_982_ = (_e768 & 7u);
                                }
                                let _e774 = phi_982_;
                                if _e680.any_expands {
                                    phi_1008_ = true;
                                } else {
                                    if ((_e774 & 2u) != 0u) {
                                        if (((_e774 & 4u) != 0u) != _e200) {
                                            phi_999_ = false;
                                        } else {
                                            phi_999_ = true;
                                        }
                                        let _e783 = phi_999_;
                                        phi_1000_ = _e783;
                                    } else {
                                        phi_1000_ = true;
                                    }
                                    let _e785 = phi_1000_;
                                    if _e785 {
                                        phi_1007_ = (((_e774 & 1u) != 0u) != _e200);
                                    } else {
                                        phi_1007_ = true;
                                    }
                                    let _e790 = phi_1007_;
                                    phi_1008_ = _e790;
                                }
                                let _e792 = phi_1008_;
                                if _e680.all_remove {
                                    if (((_e774 & 1u) != 0u) == _e200) {
                                        if ((_e774 & 2u) != 0u) {
                                            phi_1026_ = (((_e774 & 4u) != 0u) == _e200);
                                        } else {
                                            phi_1026_ = true;
                                        }
                                        let _e802 = phi_1026_;
                                        phi_1027_ = _e802;
                                    } else {
                                        phi_1027_ = false;
                                    }
                                    let _e804 = phi_1027_;
                                    phi_1028_ = _e804;
                                } else {
                                    phi_1028_ = false;
                                }
                                let _e806 = phi_1028_;
                                phi_860_ = (_e678 + 1u);
                                phi_863_ = lt_mask_Neighbourhood(_e792, _e806);
                            } else {
                                phi_860_ = u32();
                                phi_863_ = lt_mask_Neighbourhood();
                            }
                            let _e810 = phi_860_;
                            let _e812 = phi_863_;
                            continue;
                            continuing {
                                phi_859_ = _e810;
                                phi_862_ = _e812;
                                break if !(_e692);
                            }
                        }
                        let _e1027 = local_1;
                        phi_1031_ = _e1027;
                    } else {
                        phi_1031_ = _e669;
                    }
                    let _e815 = phi_1031_;
                    phi_1032_ = _e815;
                } else {
                    phi_1032_ = _e669;
                }
                let _e817 = phi_1032_;
                phi_1033_ = _e817;
            }
            let _e819 = phi_1033_;
            if (_e85 != 0.5f) {
                if _e657 {
                    if _e204 {
                        phi_1059_ = true;
                    } else {
                        if _e819.any_expands {
                            phi_1058_ = false;
                        } else {
                            phi_1058_ = true;
                        }
                        let _e824 = phi_1058_;
                        phi_1059_ = _e824;
                    }
                    let _e826 = phi_1059_;
                    if _e826 {
                        if _e204 {
                            if false {
                                if _e819.all_remove {
                                    phi_1072_ = false;
                                } else {
                                    phi_1072_ = true;
                                }
                                let _e828 = phi_1072_;
                                phi_1073_ = _e828;
                            } else {
                                phi_1073_ = true;
                            }
                            let _e830 = phi_1073_;
                            phi_1074_ = _e830;
                        } else {
                            phi_1074_ = true;
                        }
                        let _e832 = phi_1074_;
                        if _e832 {
                            if _e204 {
                                phi_1081_ = 1u;
                            } else {
                                phi_1081_ = 0u;
                            }
                            let _e834 = phi_1081_;
                            phi_1082_ = _e834;
                        } else {
                            phi_1082_ = 5u;
                        }
                        let _e836 = phi_1082_;
                        phi_1083_ = _e836;
                    } else {
                        phi_1083_ = 4u;
                    }
                    let _e838 = phi_1083_;
                    phi_1084_ = _e838;
                } else {
                    phi_1084_ = 3u;
                }
                let _e840 = phi_1084_;
                phi_1085_ = _e840;
            } else {
                phi_1085_ = 2u;
            }
            let _e842 = phi_1085_;
            if !((_e842 == 0u)) {
                phi_1093_ = !((_e842 == 5u));
            } else {
                phi_1093_ = false;
            }
            let _e848 = phi_1093_;
            if _e848 {
                if _e200 {
                    phi_1101_ = (2u | 1u);
                } else {
                    phi_1101_ = 2u;
                }
                let _e851 = phi_1101_;
                if false {
                    phi_1106_ = (_e851 | 4u);
                } else {
                    phi_1106_ = _e851;
                }
                let _e854 = phi_1106_;
                phi_1111_ = _e854;
            } else {
                if _e200 {
                    phi_1110_ = 1u;
                } else {
                    phi_1110_ = 0u;
                }
                let _e856 = phi_1110_;
                phi_1111_ = _e856;
            }
            let _e858 = phi_1111_;
            if _e200 {
                phi_1115_ = 0f;
            } else {
                phi_1115_ = 1f;
            }
            let _e860 = phi_1115_;
            phi_1117_ = mask_Masked(_e860, _e858, _e848);
        }
        let _e863 = phi_1117_;
        visibility.member[_e72.first_primitive] = _e863.visibility;
        bits.member[_e72.first_primitive] = _e863.bits;
        let _e871 = samples.member[_e72.first_primitive].normal[0u];
        let _e873 = global[0u];
        if (_e871 == _e873) {
            let _e876 = samples.member[_e72.first_primitive].normal[1u];
            let _e878 = global[1u];
            if (_e876 == _e878) {
                let _e881 = samples.member[_e72.first_primitive].normal[2u];
                let _e883 = global[2u];
                phi_1145_ = (_e881 == _e883);
                phi_1146_ = false;
            } else {
                phi_1145_ = bool();
                phi_1146_ = true;
            }
            let _e886 = phi_1145_;
            let _e888 = phi_1146_;
            phi_1147_ = _e886;
            phi_1148_ = _e888;
        } else {
            phi_1147_ = bool();
            phi_1148_ = true;
        }
        let _e890 = phi_1147_;
        let _e892 = phi_1148_;
        if _e892 {
            phi_1152_ = false;
        } else {
            phi_1152_ = _e890;
        }
        let _e894 = phi_1152_;
        if !(_e894) {
            let _e897 = samples.member[_e72.first_primitive].position;
            let _e899 = p.member.current.eye;
            let _e910 = p.member.current.forward;
            phi_1180_ = ((((_e897.x - _e899.x) * _e910.x) + ((_e897.y - _e899.y) * _e910.y)) + ((_e897.z - _e899.z) * _e910.z));
        } else {
            phi_1180_ = 0f;
        }
        let _e920 = phi_1180_;
        depths.member[_e72.first_primitive] = _e920;
        phi_1183_ = _e863.needs_ray;
        phi_1184_ = _e72.first_primitive;
    } else {
        phi_1183_ = false;
        phi_1184_ = 0u;
    }
    let _e924 = phi_1183_;
    let _e926 = phi_1184_;
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e924 {
        let _e930 = atomicAdd((&shared_[0u]), 1u);
        phi_1195_ = _e930;
    } else {
        phi_1195_ = 0u;
    }
    let _e932 = phi_1195_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e936 = atomicLoad((&shared_[0u]));
        let _e937 = atomicAdd((&list.member[3u]), _e936);
        atomicStore((&shared_[1u]), _e937);
    }
    workgroupBarrier();
    if _e924 {
        let _e940 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e940) + _e932)]), _e926);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
