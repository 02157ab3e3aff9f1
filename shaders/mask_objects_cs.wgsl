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

struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
}

struct abi_MaskParams {
    current: abi_CameraParams,
    previous: abi_CameraParams,
    light: abi_LightParams,
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

struct type_44 {
    member: array<vec4<f32>>,
}

struct type_49 {
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
var<storage, read_write> list: type_49;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(6) 
var<storage> past: type_44;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_168_: lt_bvh_traverse_Tree;
    var phi_169_: bool;
    var phi_170_: lt_bvh_traverse_Tree;
    var phi_171_: bool;
    var phi_176_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_168_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_169_ = false;
        } else {
            phi_168_ = lt_bvh_traverse_Tree();
            phi_169_ = true;
        }
        let _e65 = phi_168_;
        let _e67 = phi_169_;
        phi_170_ = _e65;
        phi_171_ = _e67;
    } else {
        phi_170_ = lt_bvh_traverse_Tree();
        phi_171_ = true;
    }
    let _e69 = phi_170_;
    let _e71 = phi_171_;
    if _e71 {
        phi_176_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_176_ = _e69;
    }
    let _e76 = phi_176_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_194_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_194_ = vec2(0i);
            break;
        }
        case 1: {
            phi_194_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_194_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_194_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_194_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e61 = phi_194_;
    return vec2<i32>(_e61.x, _e61.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_212_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_212_ = vec2(0i);
            break;
        }
        case 1: {
            phi_212_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_212_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_212_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_212_ = vec2(1i);
            break;
        }
    }
    let _e61 = phi_212_;
    return vec2<i32>(_e61.x, _e61.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_231_: vec2<i32>;

    if (param_6 == 0u) {
        let _e55 = lt_mask_pattern_plus(param_5);
        phi_231_ = vec2<i32>(_e55.x, _e55.y);
    } else {
        let _e59 = lt_mask_pattern_cross(param_5);
        phi_231_ = vec2<i32>(_e59.x, _e59.y);
    }
    let _e64 = phi_231_;
    return vec2<i32>(_e64.x, _e64.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_256_: vec2<i32>;

    let _e53 = (param_7 % 13u);
    switch bitcast<i32>(_e53) {
        case 9: {
            phi_256_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_256_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_256_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_256_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_256_ = vec2<i32>((bitcast<i32>((_e53 % 3u)) - 1i), (bitcast<i32>(((_e53 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e68 = phi_256_;
    return vec2<i32>(_e68.x, _e68.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_277_: u32;
    var phi_278_: u32;

    let _e56 = (bitcast<i32>(param_8) + param_9);
    if (_e56 < 0i) {
        phi_278_ = 0u;
    } else {
        if (_e56 >= bitcast<i32>(param_10)) {
            phi_277_ = (param_10 - 1u);
        } else {
            phi_277_ = bitcast<u32>(_e56);
        }
        let _e63 = phi_277_;
        phi_278_ = _e63;
    }
    let _e65 = phi_278_;
    return _e65;
}

fn function_() {
    var phi_342_: bool;
    var phi_343_: bool;
    var phi_344_: bool;
    var phi_345_: bool;
    var phi_349_: bool;
    var phi_419_: bool;
    var phi_420_: bool;
    var phi_431_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_432_: bool;
    var phi_433_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_434_: bool;
    var phi_441_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_445_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_458_: bool;
    var phi_644_: f32;
    var phi_649_: f32;
    var phi_650_: bool;
    var phi_651_: f32;
    var phi_652_: bool;
    var phi_656_: f32;
    var phi_679_: f32;
    var phi_684_: f32;
    var phi_685_: bool;
    var phi_686_: f32;
    var phi_687_: bool;
    var phi_691_: f32;
    var phi_712_: bool;
    var phi_731_: vec2<u32>;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_734_: bool;
    var phi_735_: vec2<u32>;
    var phi_736_: bool;
    var phi_737_: bool;
    var phi_738_: bool;
    var phi_739_: bool;
    var phi_740_: bool;
    var phi_741_: bool;
    var phi_742_: vec2<u32>;
    var phi_743_: bool;
    var phi_744_: bool;
    var phi_745_: bool;
    var phi_746_: bool;
    var phi_747_: bool;
    var phi_748_: bool;
    var phi_749_: vec2<u32>;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_762_: bool;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_771_: vec2<u32>;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_813_: bool;
    var phi_814_: lt_mask_Reprojection;
    var phi_815_: lt_mask_Reprojection;
    var phi_816_: bool;
    var phi_820_: bool;
    var phi_821_: lt_mask_Reprojection;
    var phi_835_: bool;
    var phi_846_: bool;
    var phi_847_: bool;
    var phi_848_: bool;
    var phi_849_: bool;
    var phi_850_: bool;
    var phi_851_: bool;
    var phi_855_: bool;
    var phi_860_: bool;
    var phi_875_: u32;
    var phi_877_: u32;
    var phi_880_: lt_mask_Neighbourhood;
    var phi_892_: bool;
    var phi_893_: bool;
    var phi_902_: u32;
    var phi_903_: u32;
    var phi_963_: vec2<i32>;
    var phi_983_: vec2<i32>;
    var phi_1006_: u32;
    var phi_1023_: bool;
    var phi_1024_: bool;
    var phi_1031_: bool;
    var phi_1032_: bool;
    var phi_1050_: bool;
    var phi_1051_: bool;
    var phi_1052_: bool;
    var phi_878_: u32;
    var phi_881_: lt_mask_Neighbourhood;
    var phi_1055_: lt_mask_Neighbourhood;
    var phi_1056_: lt_mask_Neighbourhood;
    var phi_1081_: bool;
    var phi_1082_: bool;
    var phi_1095_: bool;
    var phi_1096_: bool;
    var phi_1097_: bool;
    var phi_1104_: u32;
    var phi_1105_: u32;
    var phi_1106_: u32;
    var phi_1107_: u32;
    var phi_1108_: u32;
    var phi_1116_: bool;
    var phi_1124_: u32;
    var phi_1129_: u32;
    var phi_1133_: u32;
    var phi_1134_: u32;
    var phi_1138_: f32;
    var phi_1140_: mask_Masked;
    var phi_1146_: bool;
    var phi_1147_: u32;
    var phi_1158_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e52 = id_1;
    let _e53 = local_2;
    let _e66 = p.member.current.size[0u];
    let _e68 = p.member.current.size[1u];
    let _e69 = lt_shaders_entry_pixel_index(_e52, _e66, _e68);
    if (bitcast<i32>(_e69.root) != 0i) {
        let _e77 = p.member.current.size[0u];
        let _e80 = past.member[_e69.first_primitive];
        let _e85 = visibility.member[_e69.first_primitive];
        let _e91 = samples.member[_e69.first_primitive].normal[0u];
        let _e93 = global[0u];
        if (_e91 == _e93) {
            let _e96 = samples.member[_e69.first_primitive].normal[1u];
            let _e98 = global[1u];
            if (_e96 == _e98) {
                let _e101 = samples.member[_e69.first_primitive].normal[2u];
                let _e103 = global[2u];
                phi_342_ = (_e101 == _e103);
                phi_343_ = false;
            } else {
                phi_342_ = bool();
                phi_343_ = true;
            }
            let _e106 = phi_342_;
            let _e108 = phi_343_;
            phi_344_ = _e106;
            phi_345_ = _e108;
        } else {
            phi_344_ = bool();
            phi_345_ = true;
        }
        let _e110 = phi_344_;
        let _e112 = phi_345_;
        if _e112 {
            phi_349_ = false;
        } else {
            phi_349_ = _e110;
        }
        let _e114 = phi_349_;
        if !(_e114) {
            let _e117 = samples.member[_e69.first_primitive].position;
            let _e119 = p.member.light.place;
            let _e125 = p.member.light.place[3u];
            let _e132 = (_e119.x - (_e117.x * _e125));
            let _e133 = (_e119.y - (_e117.y * _e125));
            let _e134 = (_e119.z - (_e117.z * _e125));
            let _e136 = samples.member[_e69.first_primitive].normal;
            if ((((_e136.x * _e132) + (_e136.y * _e133)) + (_e136.z * _e134)) > 0f) {
                let _e150 = (((_e132 * _e132) + (_e133 * _e133)) + (_e134 * _e134));
                let _e152 = p.member.light.axis;
                let _e164 = p.member.light.place[3u];
                if (_e164 == 0f) {
                    phi_420_ = true;
                } else {
                    let _e167 = p.member.light.range_squared;
                    if (_e150 <= _e167) {
                        let _e170 = p.member.light.cos_outer;
                        phi_419_ = (-((((_e132 * _e152.x) + (_e133 * _e152.y)) + (_e134 * _e152.z))) >= (_e170 * sqrt(_e150)));
                    } else {
                        phi_419_ = false;
                    }
                    let _e175 = phi_419_;
                    phi_420_ = _e175;
                }
                let _e177 = phi_420_;
                if _e177 {
                    let _e179 = samples.member[_e69.first_primitive].flags;
                    let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e187.unnamed.visibility, false), _e187.unnamed_1);
                    phi_431_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e193.unnamed, ((_e179 & 1u) == 0u));
                    phi_432_ = false;
                } else {
                    phi_431_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_432_ = true;
                }
                let _e198 = phi_431_;
                let _e200 = phi_432_;
                phi_433_ = _e198;
                phi_434_ = _e200;
            } else {
                phi_433_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_434_ = true;
            }
            let _e202 = phi_433_;
            let _e204 = phi_434_;
            if _e204 {
                let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e210.unnamed.visibility, false), _e210.unnamed_1);
                phi_441_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e216.unnamed, true);
            } else {
                phi_441_ = _e202;
            }
            let _e221 = phi_441_;
            phi_445_ = _e221;
        } else {
            let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e233 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e227.unnamed.visibility, false), _e227.unnamed_1);
            phi_445_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e233.unnamed, true);
        }
        let _e238 = phi_445_;
        if _e238.unnamed_1 {
            phi_1140_ = mask_Masked(_e238.unnamed.visibility, 0u, false);
        } else {
            let _e243 = (_e85 < 0.5f);
            if (_e85 > 0f) {
                phi_458_ = (_e85 < 1f);
            } else {
                phi_458_ = false;
            }
            let _e247 = phi_458_;
            let _e249 = samples.member[_e69.first_primitive].position;
            let _e253 = p.member.previous.eye;
            let _e255 = (_e80.x - _e253.x);
            let _e257 = (_e80.y - _e253.y);
            let _e259 = (_e80.z - _e253.z);
            let _e261 = p.member.previous.forward;
            let _e269 = (((_e255 * _e261.x) + (_e257 * _e261.y)) + (_e259 * _e261.z));
            let _e271 = p.member.previous.right;
            let _e281 = p.member.previous.right;
            let _e296 = p.member.previous.up;
            let _e306 = p.member.previous.up;
            let _e321 = p.member.current.eye;
            let _e324 = (_e249.x - _e321.x);
            let _e327 = (_e249.y - _e321.y);
            let _e330 = (_e249.z - _e321.z);
            let _e332 = p.member.current.forward;
            let _e340 = (((_e324 * _e332.x) + (_e327 * _e332.y)) + (_e330 * _e332.z));
            let _e342 = p.member.current.right;
            let _e352 = p.member.current.right;
            let _e367 = p.member.current.up;
            let _e377 = p.member.current.up;
            let _e396 = p.member.current.size[0u];
            let _e398 = (((((((_e255 * _e271.x) + (_e257 * _e271.y)) + (_e259 * _e271.z)) / ((((_e281.x * _e281.x) + (_e281.y * _e281.y)) + (_e281.z * _e281.z)) * _e269)) - ((((_e324 * _e342.x) + (_e327 * _e342.y)) + (_e330 * _e342.z)) / ((((_e352.x * _e352.x) + (_e352.y * _e352.y)) + (_e352.z * _e352.z)) * _e340))) * 0.5f) * f32(_e396));
            let _e402 = p.member.current.size[1u];
            let _e404 = (((((((_e255 * _e296.x) + (_e257 * _e296.y)) + (_e259 * _e296.z)) / ((((_e306.x * _e306.x) + (_e306.y * _e306.y)) + (_e306.z * _e306.z)) * _e269)) - ((((_e324 * _e367.x) + (_e327 * _e367.y)) + (_e330 * _e367.z)) / ((((_e377.x * _e377.x) + (_e377.y * _e377.y)) + (_e377.z * _e377.z)) * _e340))) * -0.5f) * f32(_e402));
            let _e408 = p.member.current.size[0u];
            let _e410 = p.member.current.size[1u];
            let _e414 = ((f32(_e52.x) + 0.5f) + _e398);
            if (_e414 > -8388608f) {
                let _e426 = f32(select(0i, select(select(i32(_e414), i32(-2147483648), (_e414 < bitcast<f32>(3472883712u))), 2147483647i, (_e414 > bitcast<f32>(1325400063u))), (_e414 == _e414)));
                if (_e426 > _e414) {
                    phi_644_ = 1f;
                } else {
                    phi_644_ = 0f;
                }
                let _e429 = phi_644_;
                if (_e414 < 8388608f) {
                    phi_649_ = (_e426 - _e429);
                    phi_650_ = false;
                } else {
                    phi_649_ = f32();
                    phi_650_ = true;
                }
                let _e432 = phi_649_;
                let _e434 = phi_650_;
                phi_651_ = _e432;
                phi_652_ = _e434;
            } else {
                phi_651_ = f32();
                phi_652_ = true;
            }
            let _e436 = phi_651_;
            let _e438 = phi_652_;
            if _e438 {
                phi_656_ = _e414;
            } else {
                phi_656_ = _e436;
            }
            let _e440 = phi_656_;
            let _e443 = ((f32(_e52.y) + 0.5f) + _e404);
            if (_e443 > -8388608f) {
                let _e455 = f32(select(0i, select(select(i32(_e443), i32(-2147483648), (_e443 < bitcast<f32>(3472883712u))), 2147483647i, (_e443 > bitcast<f32>(1325400063u))), (_e443 == _e443)));
                if (_e455 > _e443) {
                    phi_679_ = 1f;
                } else {
                    phi_679_ = 0f;
                }
                let _e458 = phi_679_;
                if (_e443 < 8388608f) {
                    phi_684_ = (_e455 - _e458);
                    phi_685_ = false;
                } else {
                    phi_684_ = f32();
                    phi_685_ = true;
                }
                let _e461 = phi_684_;
                let _e463 = phi_685_;
                phi_686_ = _e461;
                phi_687_ = _e463;
            } else {
                phi_686_ = f32();
                phi_687_ = true;
            }
            let _e465 = phi_686_;
            let _e467 = phi_687_;
            if _e467 {
                phi_691_ = _e443;
            } else {
                phi_691_ = _e465;
            }
            let _e469 = phi_691_;
            if (_e440 >= 0f) {
                if (_e469 >= 0f) {
                    if (_e440 < f32(_e408)) {
                        let _e475 = (_e469 < f32(_e410));
                        if (_e398 == 0f) {
                            phi_712_ = (_e404 == 0f);
                        } else {
                            phi_712_ = false;
                        }
                        let _e479 = phi_712_;
                        if _e475 {
                            phi_731_ = vec2<u32>(select(select(u32(_e440), 0u, (_e440 < bitcast<f32>(0u))), 4294967295u, (_e440 > bitcast<f32>(1333788671u))), select(select(u32(_e469), 0u, (_e469 < bitcast<f32>(0u))), 4294967295u, (_e469 > bitcast<f32>(1333788671u))));
                            phi_732_ = false;
                        } else {
                            phi_731_ = vec2<u32>();
                            phi_732_ = true;
                        }
                        let _e496 = phi_731_;
                        let _e498 = phi_732_;
                        phi_733_ = _e479;
                        phi_734_ = _e475;
                        phi_735_ = _e496;
                        phi_736_ = _e479;
                        phi_737_ = _e475;
                        phi_738_ = false;
                        phi_739_ = _e498;
                    } else {
                        phi_733_ = bool();
                        phi_734_ = bool();
                        phi_735_ = vec2<u32>();
                        phi_736_ = bool();
                        phi_737_ = bool();
                        phi_738_ = true;
                        phi_739_ = false;
                    }
                    let _e500 = phi_733_;
                    let _e502 = phi_734_;
                    let _e504 = phi_735_;
                    let _e506 = phi_736_;
                    let _e508 = phi_737_;
                    let _e510 = phi_738_;
                    let _e512 = phi_739_;
                    phi_740_ = _e500;
                    phi_741_ = _e502;
                    phi_742_ = _e504;
                    phi_743_ = _e506;
                    phi_744_ = _e508;
                    phi_745_ = _e510;
                    phi_746_ = _e512;
                } else {
                    phi_740_ = bool();
                    phi_741_ = bool();
                    phi_742_ = vec2<u32>();
                    phi_743_ = bool();
                    phi_744_ = bool();
                    phi_745_ = true;
                    phi_746_ = false;
                }
                let _e514 = phi_740_;
                let _e516 = phi_741_;
                let _e518 = phi_742_;
                let _e520 = phi_743_;
                let _e522 = phi_744_;
                let _e524 = phi_745_;
                let _e526 = phi_746_;
                phi_747_ = _e514;
                phi_748_ = _e516;
                phi_749_ = _e518;
                phi_750_ = _e520;
                phi_751_ = _e522;
                phi_752_ = _e524;
                phi_753_ = _e526;
            } else {
                phi_747_ = bool();
                phi_748_ = bool();
                phi_749_ = vec2<u32>();
                phi_750_ = bool();
                phi_751_ = bool();
                phi_752_ = true;
                phi_753_ = false;
            }
            let _e528 = phi_747_;
            let _e530 = phi_748_;
            let _e532 = phi_749_;
            let _e534 = phi_750_;
            let _e536 = phi_751_;
            let _e538 = phi_752_;
            let _e540 = phi_753_;
            if _e538 {
                if (_e398 == 0f) {
                    phi_762_ = (_e404 == 0f);
                } else {
                    phi_762_ = false;
                }
                let _e544 = phi_762_;
                phi_763_ = _e544;
                phi_764_ = false;
                phi_765_ = true;
            } else {
                phi_763_ = _e534;
                phi_764_ = _e536;
                phi_765_ = _e540;
            }
            let _e546 = phi_763_;
            let _e548 = phi_764_;
            let _e550 = phi_765_;
            if _e550 {
                phi_769_ = _e546;
                phi_770_ = _e548;
                phi_771_ = vec2<u32>(_e52.x, _e52.y);
            } else {
                phi_769_ = _e528;
                phi_770_ = _e530;
                phi_771_ = _e532;
            }
            let _e552 = phi_769_;
            let _e554 = phi_770_;
            let _e556 = phi_771_;
            let _e566 = lt_mask_Reprojection(vec2<u32>(_e556.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e573 = lt_mask_Reprojection(vec2<u32>(_e566.pixel.x, _e556.y), _e566.is_valid, _e566.has_moved);
            let _e577 = lt_mask_Reprojection(_e573.pixel, _e554, _e573.has_moved);
            let _e581 = lt_mask_Reprojection(_e577.pixel, _e577.is_valid, !(_e552));
            if _e554 {
                let _e584 = p.member.previous.eye;
                let _e592 = p.member.previous.forward;
                let _e601 = (((((_e80.x - _e584.x) * _e592.x) + ((_e80.y - _e584.y) * _e592.y)) + ((_e80.z - _e584.z) * _e592.z)) > 0f);
                let _e605 = lt_mask_Reprojection(_e581.pixel, _e601, _e581.has_moved);
                if _e601 {
                    let _e607 = p.member.flags;
                    phi_810_ = ((_e607 & 1u) != 0u);
                    phi_811_ = false;
                } else {
                    phi_810_ = bool();
                    phi_811_ = true;
                }
                let _e611 = phi_810_;
                let _e613 = phi_811_;
                phi_813_ = _e611;
                phi_814_ = _e605;
                phi_815_ = _e605;
                phi_816_ = _e613;
            } else {
                phi_813_ = bool();
                phi_814_ = lt_mask_Reprojection();
                phi_815_ = lt_mask_Reprojection(_e581.pixel, false, _e581.has_moved);
                phi_816_ = true;
            }
            let _e619 = phi_813_;
            let _e621 = phi_814_;
            let _e623 = phi_815_;
            let _e625 = phi_816_;
            if _e625 {
                phi_820_ = false;
                phi_821_ = _e623;
            } else {
                phi_820_ = _e619;
                phi_821_ = _e621;
            }
            let _e627 = phi_820_;
            let _e629 = phi_821_;
            let _e633 = lt_mask_Reprojection(_e629.pixel, _e627, _e629.has_moved);
            let _e635 = p.member.flags;
            if _e633.has_moved {
                let _e640 = p.member.flags;
                phi_835_ = ((_e640 & 4u) == 0u);
            } else {
                phi_835_ = false;
            }
            let _e644 = phi_835_;
            if ((_e635 & 2u) != 0u) {
                if false {
                    phi_848_ = bool();
                    phi_849_ = true;
                } else {
                    if true {
                        phi_846_ = !(_e644);
                        phi_847_ = false;
                    } else {
                        phi_846_ = bool();
                        phi_847_ = true;
                    }
                    let _e647 = phi_846_;
                    let _e649 = phi_847_;
                    phi_848_ = _e647;
                    phi_849_ = _e649;
                }
                let _e651 = phi_848_;
                let _e653 = phi_849_;
                phi_850_ = _e651;
                phi_851_ = _e653;
            } else {
                phi_850_ = bool();
                phi_851_ = true;
            }
            let _e655 = phi_850_;
            let _e657 = phi_851_;
            if _e657 {
                phi_855_ = false;
            } else {
                phi_855_ = _e655;
            }
            let _e659 = phi_855_;
            let _e660 = lt_mask_Neighbourhood(false, true);
            if _e247 {
                phi_860_ = _e659;
            } else {
                phi_860_ = true;
            }
            let _e662 = phi_860_;
            if _e662 {
                if _e627 {
                    if _e633.has_moved {
                        let _e665 = p.member.moving_pattern;
                        phi_875_ = _e665;
                    } else {
                        let _e667 = p.member.still_pattern;
                        phi_875_ = _e667;
                    }
                    let _e669 = phi_875_;
                    phi_877_ = 0u;
                    phi_880_ = _e660;
                    loop {
                        let _e671 = phi_877_;
                        let _e673 = phi_880_;
                        local_1 = _e673;
                        if (1u <= _e669) {
                            if (_e669 <= 4u) {
                                phi_892_ = false;
                            } else {
                                phi_892_ = true;
                            }
                            let _e677 = phi_892_;
                            phi_893_ = _e677;
                        } else {
                            phi_893_ = true;
                        }
                        let _e679 = phi_893_;
                        if _e679 {
                            switch bitcast<i32>(_e669) {
                                case 5: {
                                    phi_902_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_902_ = 25u;
                                    break;
                                }
                                case 7: {
                                    phi_902_ = 13u;
                                    break;
                                }
                                default: {
                                    phi_902_ = 9u;
                                    break;
                                }
                            }
                            let _e682 = phi_902_;
                            phi_903_ = _e682;
                        } else {
                            phi_903_ = 5u;
                        }
                        let _e684 = phi_903_;
                        let _e685 = (_e671 < _e684);
                        if _e685 {
                            let _e691 = p.member.frame;
                            let _e695 = p.member.current.size[0u];
                            let _e697 = p.member.current.size[1u];
                            switch bitcast<i32>(_e669) {
                                case 1: {
                                    let _e707 = lt_mask_pattern_plus(_e671);
                                    phi_983_ = vec2<i32>(_e707.x, _e707.y);
                                    break;
                                }
                                case 2: {
                                    let _e711 = lt_mask_pattern_cross(_e671);
                                    phi_983_ = vec2<i32>(_e711.x, _e711.y);
                                    break;
                                }
                                case 3: {
                                    let _e717 = lt_mask_pattern_plus_or_cross(_e671, ((_e633.pixel.x + _e633.pixel.y) & 1u));
                                    phi_983_ = vec2<i32>(_e717.x, _e717.y);
                                    break;
                                }
                                case 4: {
                                    let _e722 = lt_mask_pattern_plus_or_cross(_e671, (_e691 & 1u));
                                    phi_983_ = vec2<i32>(_e722.x, _e722.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e691 & 3u)) {
                                        case 0: {
                                            phi_963_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_963_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_963_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_963_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e733 = phi_963_;
                                    phi_983_ = (_e733 + vec2<i32>(bitcast<i32>((_e671 & 1u)), bitcast<i32>(((_e671 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_983_ = vec2<i32>((bitcast<i32>((_e671 % 5u)) - 2i), (bitcast<i32>(((_e671 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                case 7: {
                                    let _e750 = lt_mask_pattern_diamond(_e671);
                                    phi_983_ = vec2<i32>(_e750.x, _e750.y);
                                    break;
                                }
                                default: {
                                    phi_983_ = vec2<i32>((bitcast<i32>((_e671 % 3u)) - 1i), (bitcast<i32>(((_e671 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e755 = phi_983_;
                            let _e758 = lt_mask_pattern_step_clamped(_e633.pixel.x, _e755.x, _e695);
                            let _e759 = lt_mask_pattern_step_clamped(_e633.pixel.y, _e755.y, _e697);
                            let _e761 = ((_e759 * _e77) + _e758);
                            if (_e761 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e765 = last_bits.member[(0u + _e761)];
                            if ((_e765 & 2u) == 0u) {
                                phi_1006_ = (_e765 & 1u);
                            } else {
                                phi_1006_ = (_e765 & 7u);
                            }
                            let _e771 = phi_1006_;
                            if _e673.any_expands {
                                phi_1032_ = true;
                            } else {
                                if ((_e771 & 2u) != 0u) {
                                    if (((_e771 & 4u) != 0u) != _e243) {
                                        phi_1023_ = false;
                                    } else {
                                        phi_1023_ = true;
                                    }
                                    let _e780 = phi_1023_;
                                    phi_1024_ = _e780;
                                } else {
                                    phi_1024_ = true;
                                }
                                let _e782 = phi_1024_;
                                if _e782 {
                                    phi_1031_ = (((_e771 & 1u) != 0u) != _e243);
                                } else {
                                    phi_1031_ = true;
                                }
                                let _e787 = phi_1031_;
                                phi_1032_ = _e787;
                            }
                            let _e789 = phi_1032_;
                            if _e673.all_remove {
                                if (((_e771 & 1u) != 0u) == _e243) {
                                    if ((_e771 & 2u) != 0u) {
                                        phi_1050_ = (((_e771 & 4u) != 0u) == _e243);
                                    } else {
                                        phi_1050_ = true;
                                    }
                                    let _e799 = phi_1050_;
                                    phi_1051_ = _e799;
                                } else {
                                    phi_1051_ = false;
                                }
                                let _e801 = phi_1051_;
                                phi_1052_ = _e801;
                            } else {
                                phi_1052_ = false;
                            }
                            let _e803 = phi_1052_;
                            phi_878_ = (_e671 + 1u);
                            phi_881_ = lt_mask_Neighbourhood(_e789, _e803);
                        } else {
                            phi_878_ = u32();
                            phi_881_ = lt_mask_Neighbourhood();
                        }
                        let _e807 = phi_878_;
                        let _e809 = phi_881_;
                        continue;
                        continuing {
                            phi_877_ = _e807;
                            phi_880_ = _e809;
                            break if !(_e685);
                        }
                    }
                    let _e980 = local_1;
                    phi_1055_ = _e980;
                } else {
                    phi_1055_ = _e660;
                }
                let _e812 = phi_1055_;
                phi_1056_ = _e812;
            } else {
                phi_1056_ = _e660;
            }
            let _e814 = phi_1056_;
            if (_e85 != 0.5f) {
                if _e627 {
                    if _e247 {
                        phi_1082_ = true;
                    } else {
                        if _e814.any_expands {
                            phi_1081_ = false;
                        } else {
                            phi_1081_ = true;
                        }
                        let _e819 = phi_1081_;
                        phi_1082_ = _e819;
                    }
                    let _e821 = phi_1082_;
                    if _e821 {
                        if _e247 {
                            if _e659 {
                                if _e814.all_remove {
                                    phi_1095_ = false;
                                } else {
                                    phi_1095_ = true;
                                }
                                let _e823 = phi_1095_;
                                phi_1096_ = _e823;
                            } else {
                                phi_1096_ = true;
                            }
                            let _e825 = phi_1096_;
                            phi_1097_ = _e825;
                        } else {
                            phi_1097_ = true;
                        }
                        let _e827 = phi_1097_;
                        if _e827 {
                            if _e247 {
                                phi_1104_ = 1u;
                            } else {
                                phi_1104_ = 0u;
                            }
                            let _e829 = phi_1104_;
                            phi_1105_ = _e829;
                        } else {
                            phi_1105_ = 5u;
                        }
                        let _e831 = phi_1105_;
                        phi_1106_ = _e831;
                    } else {
                        phi_1106_ = 4u;
                    }
                    let _e833 = phi_1106_;
                    phi_1107_ = _e833;
                } else {
                    phi_1107_ = 3u;
                }
                let _e835 = phi_1107_;
                phi_1108_ = _e835;
            } else {
                phi_1108_ = 2u;
            }
            let _e837 = phi_1108_;
            if !((_e837 == 0u)) {
                phi_1116_ = !((_e837 == 5u));
            } else {
                phi_1116_ = false;
            }
            let _e843 = phi_1116_;
            if _e843 {
                if _e243 {
                    phi_1124_ = (2u | 1u);
                } else {
                    phi_1124_ = 2u;
                }
                let _e846 = phi_1124_;
                if false {
                    phi_1129_ = (_e846 | 4u);
                } else {
                    phi_1129_ = _e846;
                }
                let _e849 = phi_1129_;
                phi_1134_ = _e849;
            } else {
                if _e243 {
                    phi_1133_ = 1u;
                } else {
                    phi_1133_ = 0u;
                }
                let _e851 = phi_1133_;
                phi_1134_ = _e851;
            }
            let _e853 = phi_1134_;
            if _e243 {
                phi_1138_ = 0f;
            } else {
                phi_1138_ = 1f;
            }
            let _e855 = phi_1138_;
            phi_1140_ = mask_Masked(_e855, _e853, _e843);
        }
        let _e858 = phi_1140_;
        visibility.member[_e69.first_primitive] = _e858.visibility;
        bits.member[_e69.first_primitive] = _e858.bits;
        phi_1146_ = _e858.needs_ray;
        phi_1147_ = _e69.first_primitive;
    } else {
        phi_1146_ = false;
        phi_1147_ = 0u;
    }
    let _e865 = phi_1146_;
    let _e867 = phi_1147_;
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e865 {
        let _e871 = atomicAdd((&shared_[0u]), 1u);
        phi_1158_ = _e871;
    } else {
        phi_1158_ = 0u;
    }
    let _e873 = phi_1158_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e877 = atomicLoad((&shared_[0u]));
        let _e878 = atomicAdd((&list.member[3u]), _e877);
        atomicStore((&shared_[1u]), _e878);
    }
    workgroupBarrier();
    if _e865 {
        let _e881 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e881) + _e873)]), _e867);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
