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
    var phi_157_: lt_bvh_traverse_Tree;
    var phi_158_: bool;
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_165_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_157_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_158_ = false;
        } else {
            phi_157_ = lt_bvh_traverse_Tree();
            phi_158_ = true;
        }
        let _e64 = phi_157_;
        let _e66 = phi_158_;
        phi_159_ = _e64;
        phi_160_ = _e66;
    } else {
        phi_159_ = lt_bvh_traverse_Tree();
        phi_160_ = true;
    }
    let _e68 = phi_159_;
    let _e70 = phi_160_;
    if _e70 {
        phi_165_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_165_ = _e68;
    }
    let _e75 = phi_165_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_183_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_183_ = vec2(0i);
            break;
        }
        case 1: {
            phi_183_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_183_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_183_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_183_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e60 = phi_183_;
    return vec2<i32>(_e60.x, _e60.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_201_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_201_ = vec2(0i);
            break;
        }
        case 1: {
            phi_201_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_201_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_201_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_201_ = vec2(1i);
            break;
        }
    }
    let _e60 = phi_201_;
    return vec2<i32>(_e60.x, _e60.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_220_: vec2<i32>;

    if (param_6 == 0u) {
        let _e54 = lt_mask_pattern_plus(param_5);
        phi_220_ = vec2<i32>(_e54.x, _e54.y);
    } else {
        let _e58 = lt_mask_pattern_cross(param_5);
        phi_220_ = vec2<i32>(_e58.x, _e58.y);
    }
    let _e63 = phi_220_;
    return vec2<i32>(_e63.x, _e63.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_245_: vec2<i32>;

    let _e52 = (param_7 % 13u);
    switch bitcast<i32>(_e52) {
        case 9: {
            phi_245_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_245_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_245_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_245_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_245_ = vec2<i32>((bitcast<i32>((_e52 % 3u)) - 1i), (bitcast<i32>(((_e52 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e67 = phi_245_;
    return vec2<i32>(_e67.x, _e67.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_266_: u32;
    var phi_267_: u32;

    let _e55 = (bitcast<i32>(param_8) + param_9);
    if (_e55 < 0i) {
        phi_267_ = 0u;
    } else {
        if (_e55 >= bitcast<i32>(param_10)) {
            phi_266_ = (param_10 - 1u);
        } else {
            phi_266_ = bitcast<u32>(_e55);
        }
        let _e62 = phi_266_;
        phi_267_ = _e62;
    }
    let _e64 = phi_267_;
    return _e64;
}

fn function_() {
    var phi_328_: bool;
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_335_: bool;
    var phi_379_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_383_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_396_: bool;
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
    var phi_754_: bool;
    var phi_755_: bool;
    var phi_757_: bool;
    var phi_758_: lt_mask_Reprojection;
    var phi_759_: lt_mask_Reprojection;
    var phi_760_: bool;
    var phi_764_: bool;
    var phi_765_: lt_mask_Reprojection;
    var phi_793_: u32;
    var phi_795_: u32;
    var phi_798_: lt_mask_Neighbourhood;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_820_: u32;
    var phi_821_: u32;
    var phi_881_: vec2<i32>;
    var phi_901_: vec2<i32>;
    var phi_924_: u32;
    var phi_941_: bool;
    var phi_942_: bool;
    var phi_949_: bool;
    var phi_950_: bool;
    var phi_968_: bool;
    var phi_969_: bool;
    var phi_970_: bool;
    var phi_796_: u32;
    var phi_799_: lt_mask_Neighbourhood;
    var phi_973_: lt_mask_Neighbourhood;
    var phi_974_: lt_mask_Neighbourhood;
    var phi_975_: lt_mask_Neighbourhood;
    var phi_1000_: bool;
    var phi_1001_: bool;
    var phi_1014_: bool;
    var phi_1015_: bool;
    var phi_1016_: bool;
    var phi_1023_: u32;
    var phi_1024_: u32;
    var phi_1025_: u32;
    var phi_1026_: u32;
    var phi_1027_: u32;
    var phi_1035_: bool;
    var phi_1043_: u32;
    var phi_1048_: u32;
    var phi_1052_: u32;
    var phi_1053_: u32;
    var phi_1057_: f32;
    var phi_1059_: mask_Masked;
    var phi_1065_: bool;
    var phi_1066_: u32;
    var phi_1077_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e51 = id_1;
    let _e52 = local_2;
    let _e64 = p.member.current.size[0u];
    let _e66 = p.member.current.size[1u];
    let _e67 = lt_shaders_entry_pixel_index(_e51, _e64, _e66);
    if (bitcast<i32>(_e67.root) != 0i) {
        let _e75 = p.member.current.size[0u];
        let _e78 = samples.member[_e67.first_primitive].position;
        let _e80 = visibility.member[_e67.first_primitive];
        let _e84 = p.member.light;
        let _e87 = samples.member[_e67.first_primitive].normal[0u];
        let _e89 = global[0u];
        if (_e87 == _e89) {
            let _e92 = samples.member[_e67.first_primitive].normal[1u];
            let _e94 = global[1u];
            if (_e92 == _e94) {
                let _e97 = samples.member[_e67.first_primitive].normal[2u];
                let _e99 = global[2u];
                phi_328_ = (_e97 == _e99);
                phi_329_ = false;
            } else {
                phi_328_ = bool();
                phi_329_ = true;
            }
            let _e102 = phi_328_;
            let _e104 = phi_329_;
            phi_330_ = _e102;
            phi_331_ = _e104;
        } else {
            phi_330_ = bool();
            phi_331_ = true;
        }
        let _e106 = phi_330_;
        let _e108 = phi_331_;
        if _e108 {
            phi_335_ = false;
        } else {
            phi_335_ = _e106;
        }
        let _e110 = phi_335_;
        if !(_e110) {
            let _e113 = samples.member[_e67.first_primitive].normal;
            let _e115 = samples.member[_e67.first_primitive].position;
            if ((((_e113.x * (_e84.x - (_e115.x * _e84.w))) + (_e113.y * (_e84.y - (_e115.y * _e84.w)))) + (_e113.z * (_e84.z - (_e115.z * _e84.w)))) > 0f) {
                let _e139 = samples.member[_e67.first_primitive].flags;
                let _e147 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e147.unnamed.visibility, false), _e147.unnamed_1);
                phi_379_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e153.unnamed, ((_e139 & 1u) == 0u));
            } else {
                let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e162.unnamed.visibility, false), _e162.unnamed_1);
                phi_379_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e168.unnamed, true);
            }
            let _e173 = phi_379_;
            phi_383_ = _e173;
        } else {
            let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e185 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e179.unnamed.visibility, false), _e179.unnamed_1);
            phi_383_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e185.unnamed, true);
        }
        let _e190 = phi_383_;
        if _e190.unnamed_1 {
            phi_1059_ = mask_Masked(_e190.unnamed.visibility, 0u, false);
        } else {
            let _e195 = (_e80 < 0.5f);
            if (_e80 > 0f) {
                phi_396_ = (_e80 < 1f);
            } else {
                phi_396_ = false;
            }
            let _e199 = phi_396_;
            let _e201 = samples.member[_e67.first_primitive].position;
            let _e205 = p.member.previous.eye;
            let _e208 = (_e78.x - _e205.x);
            let _e211 = (_e78.y - _e205.y);
            let _e214 = (_e78.z - _e205.z);
            let _e216 = p.member.previous.forward;
            let _e224 = (((_e208 * _e216.x) + (_e211 * _e216.y)) + (_e214 * _e216.z));
            let _e226 = p.member.previous.right;
            let _e236 = p.member.previous.right;
            let _e251 = p.member.previous.up;
            let _e261 = p.member.previous.up;
            let _e276 = p.member.current.eye;
            let _e279 = (_e201.x - _e276.x);
            let _e282 = (_e201.y - _e276.y);
            let _e285 = (_e201.z - _e276.z);
            let _e287 = p.member.current.forward;
            let _e295 = (((_e279 * _e287.x) + (_e282 * _e287.y)) + (_e285 * _e287.z));
            let _e297 = p.member.current.right;
            let _e307 = p.member.current.right;
            let _e322 = p.member.current.up;
            let _e332 = p.member.current.up;
            let _e351 = p.member.current.size[0u];
            let _e353 = (((((((_e208 * _e226.x) + (_e211 * _e226.y)) + (_e214 * _e226.z)) / ((((_e236.x * _e236.x) + (_e236.y * _e236.y)) + (_e236.z * _e236.z)) * _e224)) - ((((_e279 * _e297.x) + (_e282 * _e297.y)) + (_e285 * _e297.z)) / ((((_e307.x * _e307.x) + (_e307.y * _e307.y)) + (_e307.z * _e307.z)) * _e295))) * 0.5f) * f32(_e351));
            let _e357 = p.member.current.size[1u];
            let _e359 = (((((((_e208 * _e251.x) + (_e211 * _e251.y)) + (_e214 * _e251.z)) / ((((_e261.x * _e261.x) + (_e261.y * _e261.y)) + (_e261.z * _e261.z)) * _e224)) - ((((_e279 * _e322.x) + (_e282 * _e322.y)) + (_e285 * _e322.z)) / ((((_e332.x * _e332.x) + (_e332.y * _e332.y)) + (_e332.z * _e332.z)) * _e295))) * -0.5f) * f32(_e357));
            let _e363 = p.member.current.size[0u];
            let _e365 = p.member.current.size[1u];
            let _e369 = ((f32(_e51.x) + 0.5f) + _e353);
            if (_e369 > -8388608f) {
                let _e381 = f32(select(0i, select(select(i32(_e369), i32(-2147483648), (_e369 < bitcast<f32>(3472883712u))), 2147483647i, (_e369 > bitcast<f32>(1325400063u))), (_e369 == _e369)));
                if (_e381 > _e369) {
                    phi_585_ = 1f;
                } else {
                    phi_585_ = 0f;
                }
                let _e384 = phi_585_;
                if (_e369 < 8388608f) {
                    phi_590_ = (_e381 - _e384);
                    phi_591_ = false;
                } else {
                    phi_590_ = f32();
                    phi_591_ = true;
                }
                let _e387 = phi_590_;
                let _e389 = phi_591_;
                phi_592_ = _e387;
                phi_593_ = _e389;
            } else {
                phi_592_ = f32();
                phi_593_ = true;
            }
            let _e391 = phi_592_;
            let _e393 = phi_593_;
            if _e393 {
                phi_597_ = _e369;
            } else {
                phi_597_ = _e391;
            }
            let _e395 = phi_597_;
            let _e398 = ((f32(_e51.y) + 0.5f) + _e359);
            if (_e398 > -8388608f) {
                let _e410 = f32(select(0i, select(select(i32(_e398), i32(-2147483648), (_e398 < bitcast<f32>(3472883712u))), 2147483647i, (_e398 > bitcast<f32>(1325400063u))), (_e398 == _e398)));
                if (_e410 > _e398) {
                    phi_620_ = 1f;
                } else {
                    phi_620_ = 0f;
                }
                let _e413 = phi_620_;
                if (_e398 < 8388608f) {
                    phi_625_ = (_e410 - _e413);
                    phi_626_ = false;
                } else {
                    phi_625_ = f32();
                    phi_626_ = true;
                }
                let _e416 = phi_625_;
                let _e418 = phi_626_;
                phi_627_ = _e416;
                phi_628_ = _e418;
            } else {
                phi_627_ = f32();
                phi_628_ = true;
            }
            let _e420 = phi_627_;
            let _e422 = phi_628_;
            if _e422 {
                phi_632_ = _e398;
            } else {
                phi_632_ = _e420;
            }
            let _e424 = phi_632_;
            if (_e395 >= 0f) {
                if (_e424 >= 0f) {
                    if (_e395 < f32(_e363)) {
                        let _e430 = (_e424 < f32(_e365));
                        if (_e353 == 0f) {
                            phi_653_ = (_e359 == 0f);
                        } else {
                            phi_653_ = false;
                        }
                        let _e434 = phi_653_;
                        if _e430 {
                            phi_672_ = vec2<u32>(select(select(u32(_e395), 0u, (_e395 < bitcast<f32>(0u))), 4294967295u, (_e395 > bitcast<f32>(1333788671u))), select(select(u32(_e424), 0u, (_e424 < bitcast<f32>(0u))), 4294967295u, (_e424 > bitcast<f32>(1333788671u))));
                            phi_673_ = false;
                        } else {
                            phi_672_ = vec2<u32>();
                            phi_673_ = true;
                        }
                        let _e451 = phi_672_;
                        let _e453 = phi_673_;
                        phi_674_ = _e434;
                        phi_675_ = _e430;
                        phi_676_ = _e451;
                        phi_677_ = _e434;
                        phi_678_ = _e430;
                        phi_679_ = false;
                        phi_680_ = _e453;
                    } else {
                        phi_674_ = bool();
                        phi_675_ = bool();
                        phi_676_ = vec2<u32>();
                        phi_677_ = bool();
                        phi_678_ = bool();
                        phi_679_ = true;
                        phi_680_ = false;
                    }
                    let _e455 = phi_674_;
                    let _e457 = phi_675_;
                    let _e459 = phi_676_;
                    let _e461 = phi_677_;
                    let _e463 = phi_678_;
                    let _e465 = phi_679_;
                    let _e467 = phi_680_;
                    phi_681_ = _e455;
                    phi_682_ = _e457;
                    phi_683_ = _e459;
                    phi_684_ = _e461;
                    phi_685_ = _e463;
                    phi_686_ = _e465;
                    phi_687_ = _e467;
                } else {
                    phi_681_ = bool();
                    phi_682_ = bool();
                    phi_683_ = vec2<u32>();
                    phi_684_ = bool();
                    phi_685_ = bool();
                    phi_686_ = true;
                    phi_687_ = false;
                }
                let _e469 = phi_681_;
                let _e471 = phi_682_;
                let _e473 = phi_683_;
                let _e475 = phi_684_;
                let _e477 = phi_685_;
                let _e479 = phi_686_;
                let _e481 = phi_687_;
                phi_688_ = _e469;
                phi_689_ = _e471;
                phi_690_ = _e473;
                phi_691_ = _e475;
                phi_692_ = _e477;
                phi_693_ = _e479;
                phi_694_ = _e481;
            } else {
                phi_688_ = bool();
                phi_689_ = bool();
                phi_690_ = vec2<u32>();
                phi_691_ = bool();
                phi_692_ = bool();
                phi_693_ = true;
                phi_694_ = false;
            }
            let _e483 = phi_688_;
            let _e485 = phi_689_;
            let _e487 = phi_690_;
            let _e489 = phi_691_;
            let _e491 = phi_692_;
            let _e493 = phi_693_;
            let _e495 = phi_694_;
            if _e493 {
                if (_e353 == 0f) {
                    phi_703_ = (_e359 == 0f);
                } else {
                    phi_703_ = false;
                }
                let _e499 = phi_703_;
                phi_704_ = _e499;
                phi_705_ = false;
                phi_706_ = true;
            } else {
                phi_704_ = _e489;
                phi_705_ = _e491;
                phi_706_ = _e495;
            }
            let _e501 = phi_704_;
            let _e503 = phi_705_;
            let _e505 = phi_706_;
            if _e505 {
                phi_710_ = _e501;
                phi_711_ = _e503;
                phi_712_ = vec2<u32>(_e51.x, _e51.y);
            } else {
                phi_710_ = _e483;
                phi_711_ = _e485;
                phi_712_ = _e487;
            }
            let _e507 = phi_710_;
            let _e509 = phi_711_;
            let _e511 = phi_712_;
            let _e521 = lt_mask_Reprojection(vec2<u32>(_e511.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e528 = lt_mask_Reprojection(vec2<u32>(_e521.pixel.x, _e511.y), _e521.is_valid, _e521.has_moved);
            let _e532 = lt_mask_Reprojection(_e528.pixel, _e509, _e528.has_moved);
            let _e536 = lt_mask_Reprojection(_e532.pixel, _e532.is_valid, !(_e507));
            if _e509 {
                let _e539 = p.member.previous.eye;
                let _e550 = p.member.previous.forward;
                let _e559 = (((((_e78.x - _e539.x) * _e550.x) + ((_e78.y - _e539.y) * _e550.y)) + ((_e78.z - _e539.z) * _e550.z)) > 0f);
                let _e563 = lt_mask_Reprojection(_e536.pixel, _e559, _e536.has_moved);
                if _e559 {
                    let _e565 = p.member.flags;
                    phi_754_ = ((_e565 & 1u) != 0u);
                    phi_755_ = false;
                } else {
                    phi_754_ = bool();
                    phi_755_ = true;
                }
                let _e569 = phi_754_;
                let _e571 = phi_755_;
                phi_757_ = _e569;
                phi_758_ = _e563;
                phi_759_ = _e563;
                phi_760_ = _e571;
            } else {
                phi_757_ = bool();
                phi_758_ = lt_mask_Reprojection();
                phi_759_ = lt_mask_Reprojection(_e536.pixel, false, _e536.has_moved);
                phi_760_ = true;
            }
            let _e577 = phi_757_;
            let _e579 = phi_758_;
            let _e581 = phi_759_;
            let _e583 = phi_760_;
            if _e583 {
                phi_764_ = false;
                phi_765_ = _e581;
            } else {
                phi_764_ = _e577;
                phi_765_ = _e579;
            }
            let _e585 = phi_764_;
            let _e587 = phi_765_;
            let _e591 = lt_mask_Reprojection(_e587.pixel, _e585, _e587.has_moved);
            if _e591.has_moved {
            }
            let _e597 = lt_mask_Neighbourhood(false, true);
            if _e199 {
                phi_975_ = _e597;
            } else {
                if true {
                    if _e585 {
                        if _e591.has_moved {
                            let _e600 = p.member.moving_pattern;
                            phi_793_ = _e600;
                        } else {
                            let _e602 = p.member.still_pattern;
                            phi_793_ = _e602;
                        }
                        let _e604 = phi_793_;
                        phi_795_ = 0u;
                        phi_798_ = _e597;
                        loop {
                            let _e606 = phi_795_;
                            let _e608 = phi_798_;
                            local_1 = _e608;
                            if (1u <= _e604) {
                                if (_e604 <= 4u) {
                                    phi_810_ = false;
                                } else {
                                    phi_810_ = true;
                                }
                                let _e612 = phi_810_;
                                phi_811_ = _e612;
                            } else {
                                phi_811_ = true;
                            }
                            let _e614 = phi_811_;
                            if _e614 {
                                switch bitcast<i32>(_e604) {
                                    case 5: {
                                        phi_820_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_820_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_820_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_820_ = 9u;
                                        break;
                                    }
                                }
                                let _e617 = phi_820_;
                                phi_821_ = _e617;
                            } else {
                                phi_821_ = 5u;
                            }
                            let _e619 = phi_821_;
                            let _e620 = (_e606 < _e619);
                            if _e620 {
                                let _e626 = p.member.frame;
                                let _e630 = p.member.current.size[0u];
                                let _e632 = p.member.current.size[1u];
                                switch bitcast<i32>(_e604) {
                                    case 1: {
                                        let _e642 = lt_mask_pattern_plus(_e606);
                                        phi_901_ = vec2<i32>(_e642.x, _e642.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e646 = lt_mask_pattern_cross(_e606);
                                        phi_901_ = vec2<i32>(_e646.x, _e646.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e652 = lt_mask_pattern_plus_or_cross(_e606, ((_e591.pixel.x + _e591.pixel.y) & 1u));
                                        phi_901_ = vec2<i32>(_e652.x, _e652.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e657 = lt_mask_pattern_plus_or_cross(_e606, (_e626 & 1u));
                                        phi_901_ = vec2<i32>(_e657.x, _e657.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e626 & 3u)) {
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
                                        let _e668 = phi_881_;
                                        phi_901_ = (_e668 + vec2<i32>(bitcast<i32>((_e606 & 1u)), bitcast<i32>(((_e606 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_901_ = vec2<i32>((bitcast<i32>((_e606 % 5u)) - 2i), (bitcast<i32>(((_e606 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e685 = lt_mask_pattern_diamond(_e606);
                                        phi_901_ = vec2<i32>(_e685.x, _e685.y);
                                        break;
                                    }
                                    default: {
                                        phi_901_ = vec2<i32>((bitcast<i32>((_e606 % 3u)) - 1i), (bitcast<i32>(((_e606 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e690 = phi_901_;
                                let _e693 = lt_mask_pattern_step_clamped(_e591.pixel.x, _e690.x, _e630);
                                let _e694 = lt_mask_pattern_step_clamped(_e591.pixel.y, _e690.y, _e632);
                                let _e696 = ((_e694 * _e75) + _e693);
                                if (_e696 < arrayLength((&last_bits.member))) {
                                } else {
                                    return;
                                }
                                let _e700 = last_bits.member[(0u + _e696)];
                                if ((_e700 & 2u) == 0u) {
                                    phi_924_ = (_e700 & 1u);
                                } else {
                                    phi_924_ = (_e700 & 7u);
                                }
                                let _e706 = phi_924_;
                                if _e608.any_expands {
                                    phi_950_ = true;
                                } else {
                                    if ((_e706 & 2u) != 0u) {
                                        if (((_e706 & 4u) != 0u) != _e195) {
                                            phi_941_ = false;
                                        } else {
                                            phi_941_ = true;
                                        }
                                        let _e715 = phi_941_;
                                        phi_942_ = _e715;
                                    } else {
                                        phi_942_ = true;
                                    }
                                    let _e717 = phi_942_;
                                    if _e717 {
                                        phi_949_ = (((_e706 & 1u) != 0u) != _e195);
                                    } else {
                                        phi_949_ = true;
                                    }
                                    let _e722 = phi_949_;
                                    phi_950_ = _e722;
                                }
                                let _e724 = phi_950_;
                                if _e608.all_remove {
                                    if (((_e706 & 1u) != 0u) == _e195) {
                                        if ((_e706 & 2u) != 0u) {
                                            phi_968_ = (((_e706 & 4u) != 0u) == _e195);
                                        } else {
                                            phi_968_ = true;
                                        }
                                        let _e734 = phi_968_;
                                        phi_969_ = _e734;
                                    } else {
                                        phi_969_ = false;
                                    }
                                    let _e736 = phi_969_;
                                    phi_970_ = _e736;
                                } else {
                                    phi_970_ = false;
                                }
                                let _e738 = phi_970_;
                                phi_796_ = (_e606 + 1u);
                                phi_799_ = lt_mask_Neighbourhood(_e724, _e738);
                            } else {
                                phi_796_ = u32();
                                phi_799_ = lt_mask_Neighbourhood();
                            }
                            let _e742 = phi_796_;
                            let _e744 = phi_799_;
                            continue;
                            continuing {
                                phi_795_ = _e742;
                                phi_798_ = _e744;
                                break if !(_e620);
                            }
                        }
                        let _e902 = local_1;
                        phi_973_ = _e902;
                    } else {
                        phi_973_ = _e597;
                    }
                    let _e747 = phi_973_;
                    phi_974_ = _e747;
                } else {
                    phi_974_ = _e597;
                }
                let _e749 = phi_974_;
                phi_975_ = _e749;
            }
            let _e751 = phi_975_;
            if (_e80 != 0.5f) {
                if _e585 {
                    if _e199 {
                        phi_1001_ = true;
                    } else {
                        if _e751.any_expands {
                            phi_1000_ = false;
                        } else {
                            phi_1000_ = true;
                        }
                        let _e756 = phi_1000_;
                        phi_1001_ = _e756;
                    }
                    let _e758 = phi_1001_;
                    if _e758 {
                        if _e199 {
                            if false {
                                if _e751.all_remove {
                                    phi_1014_ = false;
                                } else {
                                    phi_1014_ = true;
                                }
                                let _e760 = phi_1014_;
                                phi_1015_ = _e760;
                            } else {
                                phi_1015_ = true;
                            }
                            let _e762 = phi_1015_;
                            phi_1016_ = _e762;
                        } else {
                            phi_1016_ = true;
                        }
                        let _e764 = phi_1016_;
                        if _e764 {
                            if _e199 {
                                phi_1023_ = 1u;
                            } else {
                                phi_1023_ = 0u;
                            }
                            let _e766 = phi_1023_;
                            phi_1024_ = _e766;
                        } else {
                            phi_1024_ = 5u;
                        }
                        let _e768 = phi_1024_;
                        phi_1025_ = _e768;
                    } else {
                        phi_1025_ = 4u;
                    }
                    let _e770 = phi_1025_;
                    phi_1026_ = _e770;
                } else {
                    phi_1026_ = 3u;
                }
                let _e772 = phi_1026_;
                phi_1027_ = _e772;
            } else {
                phi_1027_ = 2u;
            }
            let _e774 = phi_1027_;
            if !((_e774 == 0u)) {
                phi_1035_ = !((_e774 == 5u));
            } else {
                phi_1035_ = false;
            }
            let _e780 = phi_1035_;
            if _e780 {
                if _e195 {
                    phi_1043_ = (2u | 1u);
                } else {
                    phi_1043_ = 2u;
                }
                let _e783 = phi_1043_;
                if false {
                    phi_1048_ = (_e783 | 4u);
                } else {
                    phi_1048_ = _e783;
                }
                let _e786 = phi_1048_;
                phi_1053_ = _e786;
            } else {
                if _e195 {
                    phi_1052_ = 1u;
                } else {
                    phi_1052_ = 0u;
                }
                let _e788 = phi_1052_;
                phi_1053_ = _e788;
            }
            let _e790 = phi_1053_;
            if _e195 {
                phi_1057_ = 0f;
            } else {
                phi_1057_ = 1f;
            }
            let _e792 = phi_1057_;
            phi_1059_ = mask_Masked(_e792, _e790, _e780);
        }
        let _e795 = phi_1059_;
        visibility.member[_e67.first_primitive] = _e795.visibility;
        bits.member[_e67.first_primitive] = _e795.bits;
        phi_1065_ = _e795.needs_ray;
        phi_1066_ = _e67.first_primitive;
    } else {
        phi_1065_ = false;
        phi_1066_ = 0u;
    }
    let _e802 = phi_1065_;
    let _e804 = phi_1066_;
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e802 {
        let _e808 = atomicAdd((&shared_[0u]), 1u);
        phi_1077_ = _e808;
    } else {
        phi_1077_ = 0u;
    }
    let _e810 = phi_1077_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e814 = atomicLoad((&shared_[0u]));
        let _e815 = atomicAdd((&list.member[3u]), _e814);
        atomicStore((&shared_[1u]), _e815);
    }
    workgroupBarrier();
    if _e802 {
        let _e818 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e818) + _e810)]), _e804);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
