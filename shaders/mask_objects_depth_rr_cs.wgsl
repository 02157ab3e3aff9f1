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
    member: array<vec4<f32>>,
}

struct type_48 {
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
var<storage, read_write> list: type_48;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(6) 
var<storage> last_depths: type_21;
@group(0) @binding(7) 
var<storage, read_write> depths: type_21;
@group(0) @binding(8) 
var<storage> past: type_43;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_167_: lt_bvh_traverse_Tree;
    var phi_168_: bool;
    var phi_169_: lt_bvh_traverse_Tree;
    var phi_170_: bool;
    var phi_175_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_167_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_168_ = false;
        } else {
            phi_167_ = lt_bvh_traverse_Tree();
            phi_168_ = true;
        }
        let _e66 = phi_167_;
        let _e68 = phi_168_;
        phi_169_ = _e66;
        phi_170_ = _e68;
    } else {
        phi_169_ = lt_bvh_traverse_Tree();
        phi_170_ = true;
    }
    let _e70 = phi_169_;
    let _e72 = phi_170_;
    if _e72 {
        phi_175_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_175_ = _e70;
    }
    let _e77 = phi_175_;
    return lt_bvh_traverse_Tree(_e77.root, _e77.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_193_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_193_ = vec2(0i);
            break;
        }
        case 1: {
            phi_193_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_193_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_193_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_193_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e62 = phi_193_;
    return vec2<i32>(_e62.x, _e62.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_211_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_211_ = vec2(0i);
            break;
        }
        case 1: {
            phi_211_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_211_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_211_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_211_ = vec2(1i);
            break;
        }
    }
    let _e62 = phi_211_;
    return vec2<i32>(_e62.x, _e62.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_230_: vec2<i32>;

    if (param_6 == 0u) {
        let _e56 = lt_mask_pattern_plus(param_5);
        phi_230_ = vec2<i32>(_e56.x, _e56.y);
    } else {
        let _e60 = lt_mask_pattern_cross(param_5);
        phi_230_ = vec2<i32>(_e60.x, _e60.y);
    }
    let _e65 = phi_230_;
    return vec2<i32>(_e65.x, _e65.y);
}

fn lt_mask_pattern_step_clamped(param_7: u32, param_8: i32, param_9: u32) -> u32 {
    var phi_251_: u32;
    var phi_252_: u32;

    let _e57 = (bitcast<i32>(param_7) + param_8);
    if (_e57 < 0i) {
        phi_252_ = 0u;
    } else {
        if (_e57 >= bitcast<i32>(param_9)) {
            phi_251_ = (param_9 - 1u);
        } else {
            phi_251_ = bitcast<u32>(_e57);
        }
        let _e64 = phi_251_;
        phi_252_ = _e64;
    }
    let _e66 = phi_252_;
    return _e66;
}

fn function_() {
    var phi_322_: bool;
    var phi_323_: bool;
    var phi_324_: bool;
    var phi_325_: bool;
    var phi_329_: bool;
    var phi_373_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_377_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_390_: bool;
    var phi_592_: f32;
    var phi_597_: f32;
    var phi_598_: bool;
    var phi_599_: f32;
    var phi_600_: bool;
    var phi_604_: f32;
    var phi_627_: f32;
    var phi_632_: f32;
    var phi_633_: bool;
    var phi_634_: f32;
    var phi_635_: bool;
    var phi_639_: f32;
    var phi_660_: bool;
    var phi_679_: vec2<u32>;
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
    var phi_695_: bool;
    var phi_696_: bool;
    var phi_697_: vec2<u32>;
    var phi_698_: bool;
    var phi_699_: bool;
    var phi_700_: bool;
    var phi_701_: bool;
    var phi_710_: bool;
    var phi_711_: bool;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_717_: bool;
    var phi_718_: bool;
    var phi_719_: vec2<u32>;
    var phi_802_: bool;
    var phi_806_: f32;
    var phi_810_: lt_mask_Reprojection;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_822_: bool;
    var phi_823_: lt_mask_Reprojection;
    var phi_824_: lt_mask_Reprojection;
    var phi_825_: bool;
    var phi_829_: bool;
    var phi_830_: lt_mask_Reprojection;
    var phi_844_: bool;
    var phi_855_: bool;
    var phi_856_: bool;
    var phi_857_: bool;
    var phi_858_: bool;
    var phi_859_: bool;
    var phi_860_: bool;
    var phi_864_: bool;
    var phi_869_: bool;
    var phi_884_: u32;
    var phi_886_: u32;
    var phi_889_: lt_mask_Neighbourhood;
    var phi_901_: bool;
    var phi_902_: bool;
    var phi_910_: u32;
    var phi_911_: u32;
    var phi_970_: vec2<i32>;
    var phi_986_: vec2<i32>;
    var phi_1009_: u32;
    var phi_1026_: bool;
    var phi_1027_: bool;
    var phi_1034_: bool;
    var phi_1035_: bool;
    var phi_1053_: bool;
    var phi_1054_: bool;
    var phi_1055_: bool;
    var phi_887_: u32;
    var phi_890_: lt_mask_Neighbourhood;
    var phi_1058_: lt_mask_Neighbourhood;
    var phi_1059_: lt_mask_Neighbourhood;
    var phi_1084_: bool;
    var phi_1085_: bool;
    var phi_1098_: bool;
    var phi_1099_: bool;
    var phi_1100_: bool;
    var phi_1107_: u32;
    var phi_1108_: u32;
    var phi_1109_: u32;
    var phi_1110_: u32;
    var phi_1111_: u32;
    var phi_1119_: bool;
    var phi_1127_: u32;
    var phi_1132_: u32;
    var phi_1136_: u32;
    var phi_1137_: u32;
    var phi_1141_: f32;
    var phi_1143_: mask_Masked;
    var phi_1171_: bool;
    var phi_1172_: bool;
    var phi_1173_: bool;
    var phi_1174_: bool;
    var phi_1178_: bool;
    var phi_1206_: f32;
    var phi_1209_: bool;
    var phi_1210_: u32;
    var phi_1221_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e53 = id_1;
    let _e54 = local_2;
    let _e71 = p.member.current.size[0u];
    let _e73 = p.member.current.size[1u];
    let _e74 = lt_shaders_entry_pixel_index(_e53, _e71, _e73);
    if (bitcast<i32>(_e74.root) != 0i) {
        let _e82 = p.member.current.size[0u];
        let _e85 = past.member[_e74.first_primitive];
        let _e90 = visibility.member[_e74.first_primitive];
        let _e94 = p.member.light;
        let _e97 = samples.member[_e74.first_primitive].normal[0u];
        let _e99 = global[0u];
        if (_e97 == _e99) {
            let _e102 = samples.member[_e74.first_primitive].normal[1u];
            let _e104 = global[1u];
            if (_e102 == _e104) {
                let _e107 = samples.member[_e74.first_primitive].normal[2u];
                let _e109 = global[2u];
                phi_322_ = (_e107 == _e109);
                phi_323_ = false;
            } else {
                phi_322_ = bool();
                phi_323_ = true;
            }
            let _e112 = phi_322_;
            let _e114 = phi_323_;
            phi_324_ = _e112;
            phi_325_ = _e114;
        } else {
            phi_324_ = bool();
            phi_325_ = true;
        }
        let _e116 = phi_324_;
        let _e118 = phi_325_;
        if _e118 {
            phi_329_ = false;
        } else {
            phi_329_ = _e116;
        }
        let _e120 = phi_329_;
        if !(_e120) {
            let _e123 = samples.member[_e74.first_primitive].normal;
            let _e125 = samples.member[_e74.first_primitive].position;
            if ((((_e123.x * (_e94.x - (_e125.x * _e94.w))) + (_e123.y * (_e94.y - (_e125.y * _e94.w)))) + (_e123.z * (_e94.z - (_e125.z * _e94.w)))) > 0f) {
                let _e149 = samples.member[_e74.first_primitive].flags;
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
                phi_373_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, ((_e149 & 1u) == 0u));
            } else {
                let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e172.unnamed.visibility, false), _e172.unnamed_1);
                phi_373_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e178.unnamed, true);
            }
            let _e183 = phi_373_;
            phi_377_ = _e183;
        } else {
            let _e189 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e189.unnamed.visibility, false), _e189.unnamed_1);
            phi_377_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e195.unnamed, true);
        }
        let _e200 = phi_377_;
        if _e200.unnamed_1 {
            phi_1143_ = mask_Masked(_e200.unnamed.visibility, 0u, false);
        } else {
            let _e205 = (_e90 < 0.5f);
            if (_e90 > 0f) {
                phi_390_ = (_e90 < 1f);
            } else {
                phi_390_ = false;
            }
            let _e209 = phi_390_;
            let _e211 = samples.member[_e74.first_primitive].position;
            let _e215 = p.member.previous.eye;
            let _e217 = (_e85.x - _e215.x);
            let _e219 = (_e85.y - _e215.y);
            let _e221 = (_e85.z - _e215.z);
            let _e223 = p.member.previous.forward;
            let _e231 = (((_e217 * _e223.x) + (_e219 * _e223.y)) + (_e221 * _e223.z));
            let _e233 = p.member.previous.right;
            let _e243 = p.member.previous.right;
            let _e258 = p.member.previous.up;
            let _e268 = p.member.previous.up;
            let _e286 = p.member.previous.size[0u];
            let _e293 = p.member.previous.size[1u];
            let _e297 = p.member.current.eye;
            let _e300 = (_e211.x - _e297.x);
            let _e303 = (_e211.y - _e297.y);
            let _e306 = (_e211.z - _e297.z);
            let _e308 = p.member.current.forward;
            let _e316 = (((_e300 * _e308.x) + (_e303 * _e308.y)) + (_e306 * _e308.z));
            let _e318 = p.member.current.right;
            let _e328 = p.member.current.right;
            let _e343 = p.member.current.up;
            let _e353 = p.member.current.up;
            let _e371 = p.member.current.size[0u];
            let _e378 = p.member.current.size[1u];
            let _e381 = ((((((((_e217 * _e233.x) + (_e219 * _e233.y)) + (_e221 * _e233.z)) / ((((_e243.x * _e243.x) + (_e243.y * _e243.y)) + (_e243.z * _e243.z)) * _e231)) * 0.5f) + 0.5f) * f32(_e286)) - (((((((_e300 * _e318.x) + (_e303 * _e318.y)) + (_e306 * _e318.z)) / ((((_e328.x * _e328.x) + (_e328.y * _e328.y)) + (_e328.z * _e328.z)) * _e316)) * 0.5f) + 0.5f) * f32(_e371)));
            let _e382 = (((0.5f - (((((_e217 * _e258.x) + (_e219 * _e258.y)) + (_e221 * _e258.z)) / ((((_e268.x * _e268.x) + (_e268.y * _e268.y)) + (_e268.z * _e268.z)) * _e231)) * 0.5f)) * f32(_e293)) - ((0.5f - (((((_e300 * _e343.x) + (_e303 * _e343.y)) + (_e306 * _e343.z)) / ((((_e353.x * _e353.x) + (_e353.y * _e353.y)) + (_e353.z * _e353.z)) * _e316)) * 0.5f)) * f32(_e378)));
            let _e386 = p.member.current.size[0u];
            let _e388 = p.member.current.size[1u];
            let _e392 = ((f32(_e53.x) + 0.5f) + _e381);
            if (_e392 > -8388608f) {
                let _e404 = f32(select(0i, select(select(i32(_e392), i32(-2147483648), (_e392 < bitcast<f32>(3472883712u))), 2147483647i, (_e392 > bitcast<f32>(1325400063u))), (_e392 == _e392)));
                if (_e404 > _e392) {
                    phi_592_ = 1f;
                } else {
                    phi_592_ = 0f;
                }
                let _e407 = phi_592_;
                if (_e392 < 8388608f) {
                    phi_597_ = (_e404 - _e407);
                    phi_598_ = false;
                } else {
                    phi_597_ = f32();
                    phi_598_ = true;
                }
                let _e410 = phi_597_;
                let _e412 = phi_598_;
                phi_599_ = _e410;
                phi_600_ = _e412;
            } else {
                phi_599_ = f32();
                phi_600_ = true;
            }
            let _e414 = phi_599_;
            let _e416 = phi_600_;
            if _e416 {
                phi_604_ = _e392;
            } else {
                phi_604_ = _e414;
            }
            let _e418 = phi_604_;
            let _e421 = ((f32(_e53.y) + 0.5f) + _e382);
            if (_e421 > -8388608f) {
                let _e433 = f32(select(0i, select(select(i32(_e421), i32(-2147483648), (_e421 < bitcast<f32>(3472883712u))), 2147483647i, (_e421 > bitcast<f32>(1325400063u))), (_e421 == _e421)));
                if (_e433 > _e421) {
                    phi_627_ = 1f;
                } else {
                    phi_627_ = 0f;
                }
                let _e436 = phi_627_;
                if (_e421 < 8388608f) {
                    phi_632_ = (_e433 - _e436);
                    phi_633_ = false;
                } else {
                    phi_632_ = f32();
                    phi_633_ = true;
                }
                let _e439 = phi_632_;
                let _e441 = phi_633_;
                phi_634_ = _e439;
                phi_635_ = _e441;
            } else {
                phi_634_ = f32();
                phi_635_ = true;
            }
            let _e443 = phi_634_;
            let _e445 = phi_635_;
            if _e445 {
                phi_639_ = _e421;
            } else {
                phi_639_ = _e443;
            }
            let _e447 = phi_639_;
            if (_e418 >= 0f) {
                if (_e447 >= 0f) {
                    if (_e418 < f32(_e386)) {
                        let _e453 = (_e447 < f32(_e388));
                        if (_e381 == 0f) {
                            phi_660_ = (_e382 == 0f);
                        } else {
                            phi_660_ = false;
                        }
                        let _e457 = phi_660_;
                        if _e453 {
                            phi_679_ = vec2<u32>(select(select(u32(_e418), 0u, (_e418 < bitcast<f32>(0u))), 4294967295u, (_e418 > bitcast<f32>(1333788671u))), select(select(u32(_e447), 0u, (_e447 < bitcast<f32>(0u))), 4294967295u, (_e447 > bitcast<f32>(1333788671u))));
                            phi_680_ = false;
                        } else {
                            phi_679_ = vec2<u32>();
                            phi_680_ = true;
                        }
                        let _e474 = phi_679_;
                        let _e476 = phi_680_;
                        phi_681_ = _e457;
                        phi_682_ = _e453;
                        phi_683_ = _e474;
                        phi_684_ = _e457;
                        phi_685_ = _e453;
                        phi_686_ = false;
                        phi_687_ = _e476;
                    } else {
                        phi_681_ = bool();
                        phi_682_ = bool();
                        phi_683_ = vec2<u32>();
                        phi_684_ = bool();
                        phi_685_ = bool();
                        phi_686_ = true;
                        phi_687_ = false;
                    }
                    let _e478 = phi_681_;
                    let _e480 = phi_682_;
                    let _e482 = phi_683_;
                    let _e484 = phi_684_;
                    let _e486 = phi_685_;
                    let _e488 = phi_686_;
                    let _e490 = phi_687_;
                    phi_688_ = _e478;
                    phi_689_ = _e480;
                    phi_690_ = _e482;
                    phi_691_ = _e484;
                    phi_692_ = _e486;
                    phi_693_ = _e488;
                    phi_694_ = _e490;
                } else {
                    phi_688_ = bool();
                    phi_689_ = bool();
                    phi_690_ = vec2<u32>();
                    phi_691_ = bool();
                    phi_692_ = bool();
                    phi_693_ = true;
                    phi_694_ = false;
                }
                let _e492 = phi_688_;
                let _e494 = phi_689_;
                let _e496 = phi_690_;
                let _e498 = phi_691_;
                let _e500 = phi_692_;
                let _e502 = phi_693_;
                let _e504 = phi_694_;
                phi_695_ = _e492;
                phi_696_ = _e494;
                phi_697_ = _e496;
                phi_698_ = _e498;
                phi_699_ = _e500;
                phi_700_ = _e502;
                phi_701_ = _e504;
            } else {
                phi_695_ = bool();
                phi_696_ = bool();
                phi_697_ = vec2<u32>();
                phi_698_ = bool();
                phi_699_ = bool();
                phi_700_ = true;
                phi_701_ = false;
            }
            let _e506 = phi_695_;
            let _e508 = phi_696_;
            let _e510 = phi_697_;
            let _e512 = phi_698_;
            let _e514 = phi_699_;
            let _e516 = phi_700_;
            let _e518 = phi_701_;
            if _e516 {
                if (_e381 == 0f) {
                    phi_710_ = (_e382 == 0f);
                } else {
                    phi_710_ = false;
                }
                let _e522 = phi_710_;
                phi_711_ = _e522;
                phi_712_ = false;
                phi_713_ = true;
            } else {
                phi_711_ = _e512;
                phi_712_ = _e514;
                phi_713_ = _e518;
            }
            let _e524 = phi_711_;
            let _e526 = phi_712_;
            let _e528 = phi_713_;
            if _e528 {
                phi_717_ = _e524;
                phi_718_ = _e526;
                phi_719_ = vec2<u32>(_e53.x, _e53.y);
            } else {
                phi_717_ = _e506;
                phi_718_ = _e508;
                phi_719_ = _e510;
            }
            let _e530 = phi_717_;
            let _e532 = phi_718_;
            let _e534 = phi_719_;
            let _e544 = lt_mask_Reprojection(vec2<u32>(_e534.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e551 = lt_mask_Reprojection(vec2<u32>(_e544.pixel.x, _e534.y), _e544.is_valid, _e544.has_moved);
            let _e555 = lt_mask_Reprojection(_e551.pixel, _e532, _e551.has_moved);
            let _e559 = lt_mask_Reprojection(_e555.pixel, _e555.is_valid, !(_e530));
            if _e532 {
                let _e562 = p.member.previous.eye;
                let _e570 = p.member.previous.forward;
                let _e579 = (((((_e85.x - _e562.x) * _e570.x) + ((_e85.y - _e562.y) * _e570.y)) + ((_e85.z - _e562.z) * _e570.z)) > 0f);
                let _e583 = lt_mask_Reprojection(_e559.pixel, _e579, _e559.has_moved);
                if _e579 {
                    let _e586 = p.member.previous.eye;
                    let _e594 = p.member.previous.forward;
                    let _e602 = ((((_e85.x - _e586.x) * _e594.x) + ((_e85.y - _e586.y) * _e594.y)) + ((_e85.z - _e586.z) * _e594.z));
                    let _e604 = ((_e534.y * _e82) + _e534.x);
                    if (_e604 < arrayLength((&last_depths.member))) {
                    } else {
                        return;
                    }
                    let _e608 = last_depths.member[(0u + _e604)];
                    let _e610 = p.member.depth_tolerance;
                    let _e613 = abs(_e602);
                    let _e614 = abs(_e608);
                    if ((bitcast<u32>(_e614) & 2147483647u) > 2139095040u) {
                        phi_802_ = true;
                    } else {
                        let _e618 = (_e614 > _e613);
                        if _e618 {
                        }
                        phi_802_ = _e618;
                    }
                    let _e620 = phi_802_;
                    if _e620 {
                        phi_806_ = _e614;
                    } else {
                        phi_806_ = _e613;
                    }
                    let _e622 = phi_806_;
                    phi_810_ = lt_mask_Reprojection(_e583.pixel, (abs((_e602 - _e608)) <= (_e610 * _e622)), _e583.has_moved);
                } else {
                    phi_810_ = _e583;
                }
                let _e630 = phi_810_;
                if _e630.is_valid {
                    let _e633 = p.member.flags;
                    phi_819_ = ((_e633 & 1u) != 0u);
                    phi_820_ = false;
                } else {
                    phi_819_ = bool();
                    phi_820_ = true;
                }
                let _e637 = phi_819_;
                let _e639 = phi_820_;
                phi_822_ = _e637;
                phi_823_ = _e630;
                phi_824_ = _e630;
                phi_825_ = _e639;
            } else {
                phi_822_ = bool();
                phi_823_ = lt_mask_Reprojection();
                phi_824_ = lt_mask_Reprojection(_e559.pixel, false, _e559.has_moved);
                phi_825_ = true;
            }
            let _e645 = phi_822_;
            let _e647 = phi_823_;
            let _e649 = phi_824_;
            let _e651 = phi_825_;
            if _e651 {
                phi_829_ = false;
                phi_830_ = _e649;
            } else {
                phi_829_ = _e645;
                phi_830_ = _e647;
            }
            let _e653 = phi_829_;
            let _e655 = phi_830_;
            let _e659 = lt_mask_Reprojection(_e655.pixel, _e653, _e655.has_moved);
            let _e661 = p.member.flags;
            if _e659.has_moved {
                let _e666 = p.member.flags;
                phi_844_ = ((_e666 & 4u) == 0u);
            } else {
                phi_844_ = false;
            }
            let _e670 = phi_844_;
            if ((_e661 & 2u) != 0u) {
                if false {
                    phi_857_ = bool();
                    phi_858_ = true;
                } else {
                    if true {
                        phi_855_ = !(_e670);
                        phi_856_ = false;
                    } else {
                        phi_855_ = bool();
                        phi_856_ = true;
                    }
                    let _e673 = phi_855_;
                    let _e675 = phi_856_;
                    phi_857_ = _e673;
                    phi_858_ = _e675;
                }
                let _e677 = phi_857_;
                let _e679 = phi_858_;
                phi_859_ = _e677;
                phi_860_ = _e679;
            } else {
                phi_859_ = bool();
                phi_860_ = true;
            }
            let _e681 = phi_859_;
            let _e683 = phi_860_;
            if _e683 {
                phi_864_ = false;
            } else {
                phi_864_ = _e681;
            }
            let _e685 = phi_864_;
            let _e686 = lt_mask_Neighbourhood(false, true);
            if _e209 {
                phi_869_ = _e685;
            } else {
                phi_869_ = false;
            }
            let _e688 = phi_869_;
            if _e688 {
                if _e653 {
                    if _e659.has_moved {
                        let _e691 = p.member.moving_pattern;
                        phi_884_ = _e691;
                    } else {
                        let _e693 = p.member.still_pattern;
                        phi_884_ = _e693;
                    }
                    let _e695 = phi_884_;
                    phi_886_ = 0u;
                    phi_889_ = _e686;
                    loop {
                        let _e697 = phi_886_;
                        let _e699 = phi_889_;
                        local_1 = _e699;
                        if (1u <= _e695) {
                            if (_e695 <= 4u) {
                                phi_901_ = false;
                            } else {
                                phi_901_ = true;
                            }
                            let _e703 = phi_901_;
                            phi_902_ = _e703;
                        } else {
                            phi_902_ = true;
                        }
                        let _e705 = phi_902_;
                        if _e705 {
                            switch bitcast<i32>(_e695) {
                                case 5: {
                                    phi_910_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_910_ = 25u;
                                    break;
                                }
                                default: {
                                    phi_910_ = 9u;
                                    break;
                                }
                            }
                            let _e708 = phi_910_;
                            phi_911_ = _e708;
                        } else {
                            phi_911_ = 5u;
                        }
                        let _e710 = phi_911_;
                        let _e711 = (_e697 < _e710);
                        if _e711 {
                            let _e717 = p.member.frame;
                            let _e721 = p.member.current.size[0u];
                            let _e723 = p.member.current.size[1u];
                            switch bitcast<i32>(_e695) {
                                case 1: {
                                    let _e733 = lt_mask_pattern_plus(_e697);
                                    phi_986_ = vec2<i32>(_e733.x, _e733.y);
                                    break;
                                }
                                case 2: {
                                    let _e737 = lt_mask_pattern_cross(_e697);
                                    phi_986_ = vec2<i32>(_e737.x, _e737.y);
                                    break;
                                }
                                case 3: {
                                    let _e743 = lt_mask_pattern_plus_or_cross(_e697, ((_e659.pixel.x + _e659.pixel.y) & 1u));
                                    phi_986_ = vec2<i32>(_e743.x, _e743.y);
                                    break;
                                }
                                case 4: {
                                    let _e748 = lt_mask_pattern_plus_or_cross(_e697, (_e717 & 1u));
                                    phi_986_ = vec2<i32>(_e748.x, _e748.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e717 & 3u)) {
                                        case 0: {
                                            phi_970_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_970_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_970_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_970_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e759 = phi_970_;
                                    phi_986_ = (_e759 + vec2<i32>(bitcast<i32>((_e697 & 1u)), bitcast<i32>(((_e697 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_986_ = vec2<i32>((bitcast<i32>((_e697 % 5u)) - 2i), (bitcast<i32>(((_e697 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                default: {
                                    phi_986_ = vec2<i32>((bitcast<i32>((_e697 % 3u)) - 1i), (bitcast<i32>(((_e697 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e777 = phi_986_;
                            let _e780 = lt_mask_pattern_step_clamped(_e659.pixel.x, _e777.x, _e721);
                            let _e781 = lt_mask_pattern_step_clamped(_e659.pixel.y, _e777.y, _e723);
                            let _e783 = ((_e781 * _e82) + _e780);
                            if (_e783 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e787 = last_bits.member[(0u + _e783)];
                            if ((_e787 & 2u) == 0u) {
                                phi_1009_ = (_e787 & 1u);
                            } else {
                                phi_1009_ = (_e787 & 7u);
                            }
                            let _e793 = phi_1009_;
                            if _e699.any_expands {
                                phi_1035_ = true;
                            } else {
                                if ((_e793 & 2u) != 0u) {
                                    if (((_e793 & 4u) != 0u) != _e205) {
                                        phi_1026_ = false;
                                    } else {
                                        phi_1026_ = true;
                                    }
                                    let _e802 = phi_1026_;
                                    phi_1027_ = _e802;
                                } else {
                                    phi_1027_ = true;
                                }
                                let _e804 = phi_1027_;
                                if _e804 {
                                    phi_1034_ = (((_e793 & 1u) != 0u) != _e205);
                                } else {
                                    phi_1034_ = true;
                                }
                                let _e809 = phi_1034_;
                                phi_1035_ = _e809;
                            }
                            let _e811 = phi_1035_;
                            if _e699.all_remove {
                                if (((_e793 & 1u) != 0u) == _e205) {
                                    if ((_e793 & 2u) != 0u) {
                                        phi_1053_ = (((_e793 & 4u) != 0u) == _e205);
                                    } else {
                                        phi_1053_ = true;
                                    }
                                    let _e821 = phi_1053_;
                                    phi_1054_ = _e821;
                                } else {
                                    phi_1054_ = false;
                                }
                                let _e823 = phi_1054_;
                                phi_1055_ = _e823;
                            } else {
                                phi_1055_ = false;
                            }
                            let _e825 = phi_1055_;
                            phi_887_ = (_e697 + 1u);
                            phi_890_ = lt_mask_Neighbourhood(_e811, _e825);
                        } else {
                            phi_887_ = u32();
                            phi_890_ = lt_mask_Neighbourhood();
                        }
                        let _e829 = phi_887_;
                        let _e831 = phi_890_;
                        continue;
                        continuing {
                            phi_886_ = _e829;
                            phi_889_ = _e831;
                            break if !(_e711);
                        }
                    }
                    let _e1053 = local_1;
                    phi_1058_ = _e1053;
                } else {
                    phi_1058_ = _e686;
                }
                let _e834 = phi_1058_;
                phi_1059_ = _e834;
            } else {
                phi_1059_ = _e686;
            }
            let _e836 = phi_1059_;
            if (_e90 != 0.5f) {
                if _e653 {
                    if _e209 {
                        phi_1085_ = true;
                    } else {
                        if _e836.any_expands {
                            phi_1084_ = false;
                        } else {
                            phi_1084_ = true;
                        }
                        let _e841 = phi_1084_;
                        phi_1085_ = _e841;
                    }
                    let _e843 = phi_1085_;
                    if _e843 {
                        if _e209 {
                            if _e685 {
                                if _e836.all_remove {
                                    phi_1098_ = false;
                                } else {
                                    phi_1098_ = true;
                                }
                                let _e845 = phi_1098_;
                                phi_1099_ = _e845;
                            } else {
                                phi_1099_ = true;
                            }
                            let _e847 = phi_1099_;
                            phi_1100_ = _e847;
                        } else {
                            phi_1100_ = true;
                        }
                        let _e849 = phi_1100_;
                        if _e849 {
                            if _e209 {
                                phi_1107_ = 1u;
                            } else {
                                phi_1107_ = 0u;
                            }
                            let _e851 = phi_1107_;
                            phi_1108_ = _e851;
                        } else {
                            phi_1108_ = 5u;
                        }
                        let _e853 = phi_1108_;
                        phi_1109_ = _e853;
                    } else {
                        phi_1109_ = 4u;
                    }
                    let _e855 = phi_1109_;
                    phi_1110_ = _e855;
                } else {
                    phi_1110_ = 3u;
                }
                let _e857 = phi_1110_;
                phi_1111_ = _e857;
            } else {
                phi_1111_ = 2u;
            }
            let _e859 = phi_1111_;
            if !((_e859 == 0u)) {
                phi_1119_ = !((_e859 == 5u));
            } else {
                phi_1119_ = false;
            }
            let _e865 = phi_1119_;
            if _e865 {
                if _e205 {
                    phi_1127_ = (2u | 1u);
                } else {
                    phi_1127_ = 2u;
                }
                let _e868 = phi_1127_;
                if false {
                    phi_1132_ = (_e868 | 4u);
                } else {
                    phi_1132_ = _e868;
                }
                let _e871 = phi_1132_;
                phi_1137_ = _e871;
            } else {
                if _e205 {
                    phi_1136_ = 1u;
                } else {
                    phi_1136_ = 0u;
                }
                let _e873 = phi_1136_;
                phi_1137_ = _e873;
            }
            let _e875 = phi_1137_;
            if _e205 {
                phi_1141_ = 0f;
            } else {
                phi_1141_ = 1f;
            }
            let _e877 = phi_1141_;
            phi_1143_ = mask_Masked(_e877, _e875, _e865);
        }
        let _e880 = phi_1143_;
        visibility.member[_e74.first_primitive] = _e880.visibility;
        bits.member[_e74.first_primitive] = _e880.bits;
        let _e888 = samples.member[_e74.first_primitive].normal[0u];
        let _e890 = global[0u];
        if (_e888 == _e890) {
            let _e893 = samples.member[_e74.first_primitive].normal[1u];
            let _e895 = global[1u];
            if (_e893 == _e895) {
                let _e898 = samples.member[_e74.first_primitive].normal[2u];
                let _e900 = global[2u];
                phi_1171_ = (_e898 == _e900);
                phi_1172_ = false;
            } else {
                phi_1171_ = bool();
                phi_1172_ = true;
            }
            let _e903 = phi_1171_;
            let _e905 = phi_1172_;
            phi_1173_ = _e903;
            phi_1174_ = _e905;
        } else {
            phi_1173_ = bool();
            phi_1174_ = true;
        }
        let _e907 = phi_1173_;
        let _e909 = phi_1174_;
        if _e909 {
            phi_1178_ = false;
        } else {
            phi_1178_ = _e907;
        }
        let _e911 = phi_1178_;
        if !(_e911) {
            let _e914 = samples.member[_e74.first_primitive].position;
            let _e916 = p.member.current.eye;
            let _e927 = p.member.current.forward;
            phi_1206_ = ((((_e914.x - _e916.x) * _e927.x) + ((_e914.y - _e916.y) * _e927.y)) + ((_e914.z - _e916.z) * _e927.z));
        } else {
            phi_1206_ = 0f;
        }
        let _e937 = phi_1206_;
        depths.member[_e74.first_primitive] = _e937;
        phi_1209_ = _e880.needs_ray;
        phi_1210_ = _e74.first_primitive;
    } else {
        phi_1209_ = false;
        phi_1210_ = 0u;
    }
    let _e941 = phi_1209_;
    let _e943 = phi_1210_;
    if (_e54 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e941 {
        let _e947 = atomicAdd((&shared_[0u]), 1u);
        phi_1221_ = _e947;
    } else {
        phi_1221_ = 0u;
    }
    let _e949 = phi_1221_;
    workgroupBarrier();
    if (_e54 == 0u) {
        let _e953 = atomicLoad((&shared_[0u]));
        let _e954 = atomicAdd((&list.member[3u]), _e953);
        atomicStore((&shared_[1u]), _e954);
    }
    workgroupBarrier();
    if _e941 {
        let _e957 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e957) + _e949)]), _e943);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
