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
var<storage, read_write> list: type_44;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(6) 
var<storage> last_depths: type_21;
@group(0) @binding(7) 
var<storage, read_write> depths: type_21;

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
        let _e68 = phi_168_;
        let _e70 = phi_169_;
        phi_170_ = _e68;
        phi_171_ = _e70;
    } else {
        phi_170_ = lt_bvh_traverse_Tree();
        phi_171_ = true;
    }
    let _e72 = phi_170_;
    let _e74 = phi_171_;
    if _e74 {
        phi_176_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_176_ = _e72;
    }
    let _e79 = phi_176_;
    return lt_bvh_traverse_Tree(_e79.root, _e79.first_primitive);
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
    let _e64 = phi_194_;
    return vec2<i32>(_e64.x, _e64.y);
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
    let _e64 = phi_212_;
    return vec2<i32>(_e64.x, _e64.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_231_: vec2<i32>;

    if (param_6 == 0u) {
        let _e58 = lt_mask_pattern_plus(param_5);
        phi_231_ = vec2<i32>(_e58.x, _e58.y);
    } else {
        let _e62 = lt_mask_pattern_cross(param_5);
        phi_231_ = vec2<i32>(_e62.x, _e62.y);
    }
    let _e67 = phi_231_;
    return vec2<i32>(_e67.x, _e67.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_256_: vec2<i32>;

    let _e56 = (param_7 % 13u);
    switch bitcast<i32>(_e56) {
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
            phi_256_ = vec2<i32>((bitcast<i32>((_e56 % 3u)) - 1i), (bitcast<i32>(((_e56 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e71 = phi_256_;
    return vec2<i32>(_e71.x, _e71.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_277_: u32;
    var phi_278_: u32;

    let _e59 = (bitcast<i32>(param_8) + param_9);
    if (_e59 < 0i) {
        phi_278_ = 0u;
    } else {
        if (_e59 >= bitcast<i32>(param_10)) {
            phi_277_ = (param_10 - 1u);
        } else {
            phi_277_ = bitcast<u32>(_e59);
        }
        let _e66 = phi_277_;
        phi_278_ = _e66;
    }
    let _e68 = phi_278_;
    return _e68;
}

fn function_() {
    var phi_343_: bool;
    var phi_344_: bool;
    var phi_345_: bool;
    var phi_346_: bool;
    var phi_350_: bool;
    var phi_420_: bool;
    var phi_421_: bool;
    var phi_432_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_433_: bool;
    var phi_434_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_435_: bool;
    var phi_442_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_446_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_459_: bool;
    var phi_648_: f32;
    var phi_653_: f32;
    var phi_654_: bool;
    var phi_655_: f32;
    var phi_656_: bool;
    var phi_660_: f32;
    var phi_683_: f32;
    var phi_688_: f32;
    var phi_689_: bool;
    var phi_690_: f32;
    var phi_691_: bool;
    var phi_695_: f32;
    var phi_716_: bool;
    var phi_735_: vec2<u32>;
    var phi_736_: bool;
    var phi_737_: bool;
    var phi_738_: bool;
    var phi_739_: vec2<u32>;
    var phi_740_: bool;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_743_: bool;
    var phi_744_: bool;
    var phi_745_: bool;
    var phi_746_: vec2<u32>;
    var phi_747_: bool;
    var phi_748_: bool;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_752_: bool;
    var phi_753_: vec2<u32>;
    var phi_754_: bool;
    var phi_755_: bool;
    var phi_756_: bool;
    var phi_757_: bool;
    var phi_766_: bool;
    var phi_767_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
    var phi_773_: bool;
    var phi_774_: bool;
    var phi_775_: vec2<u32>;
    var phi_864_: bool;
    var phi_868_: f32;
    var phi_872_: lt_mask_Reprojection;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_884_: bool;
    var phi_885_: lt_mask_Reprojection;
    var phi_886_: lt_mask_Reprojection;
    var phi_887_: bool;
    var phi_891_: bool;
    var phi_892_: lt_mask_Reprojection;
    var phi_920_: u32;
    var phi_922_: u32;
    var phi_925_: lt_mask_Neighbourhood;
    var phi_937_: bool;
    var phi_938_: bool;
    var phi_947_: u32;
    var phi_948_: u32;
    var phi_1008_: vec2<i32>;
    var phi_1028_: vec2<i32>;
    var phi_1051_: u32;
    var phi_1068_: bool;
    var phi_1069_: bool;
    var phi_1076_: bool;
    var phi_1077_: bool;
    var phi_1095_: bool;
    var phi_1096_: bool;
    var phi_1097_: bool;
    var phi_923_: u32;
    var phi_926_: lt_mask_Neighbourhood;
    var phi_1100_: lt_mask_Neighbourhood;
    var phi_1101_: lt_mask_Neighbourhood;
    var phi_1102_: lt_mask_Neighbourhood;
    var phi_1127_: bool;
    var phi_1128_: bool;
    var phi_1141_: bool;
    var phi_1142_: bool;
    var phi_1143_: bool;
    var phi_1150_: u32;
    var phi_1151_: u32;
    var phi_1152_: u32;
    var phi_1153_: u32;
    var phi_1154_: u32;
    var phi_1162_: bool;
    var phi_1170_: u32;
    var phi_1175_: u32;
    var phi_1179_: u32;
    var phi_1180_: u32;
    var phi_1184_: f32;
    var phi_1186_: mask_Masked;
    var phi_1214_: bool;
    var phi_1215_: bool;
    var phi_1216_: bool;
    var phi_1217_: bool;
    var phi_1221_: bool;
    var phi_1249_: f32;
    var phi_1252_: bool;
    var phi_1253_: u32;
    var phi_1264_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e55 = id_1;
    let _e56 = local_2;
    let _e72 = p.member.current.size[0u];
    let _e74 = p.member.current.size[1u];
    let _e75 = lt_shaders_entry_pixel_index(_e55, _e72, _e74);
    if (bitcast<i32>(_e75.root) != 0i) {
        let _e83 = p.member.current.size[0u];
        let _e86 = samples.member[_e75.first_primitive].position;
        let _e88 = visibility.member[_e75.first_primitive];
        let _e94 = samples.member[_e75.first_primitive].normal[0u];
        let _e96 = global[0u];
        if (_e94 == _e96) {
            let _e99 = samples.member[_e75.first_primitive].normal[1u];
            let _e101 = global[1u];
            if (_e99 == _e101) {
                let _e104 = samples.member[_e75.first_primitive].normal[2u];
                let _e106 = global[2u];
                phi_343_ = (_e104 == _e106);
                phi_344_ = false;
            } else {
                phi_343_ = bool();
                phi_344_ = true;
            }
            let _e109 = phi_343_;
            let _e111 = phi_344_;
            phi_345_ = _e109;
            phi_346_ = _e111;
        } else {
            phi_345_ = bool();
            phi_346_ = true;
        }
        let _e113 = phi_345_;
        let _e115 = phi_346_;
        if _e115 {
            phi_350_ = false;
        } else {
            phi_350_ = _e113;
        }
        let _e117 = phi_350_;
        if !(_e117) {
            let _e120 = samples.member[_e75.first_primitive].position;
            let _e122 = p.member.light.place;
            let _e128 = p.member.light.place[3u];
            let _e135 = (_e122.x - (_e120.x * _e128));
            let _e136 = (_e122.y - (_e120.y * _e128));
            let _e137 = (_e122.z - (_e120.z * _e128));
            let _e139 = samples.member[_e75.first_primitive].normal;
            if ((((_e139.x * _e135) + (_e139.y * _e136)) + (_e139.z * _e137)) > 0f) {
                let _e153 = (((_e135 * _e135) + (_e136 * _e136)) + (_e137 * _e137));
                let _e155 = p.member.light.axis;
                let _e167 = p.member.light.place[3u];
                if (_e167 == 0f) {
                    phi_421_ = true;
                } else {
                    let _e170 = p.member.light.range_squared;
                    if (_e153 <= _e170) {
                        let _e173 = p.member.light.cos_outer;
                        phi_420_ = (-((((_e135 * _e155.x) + (_e136 * _e155.y)) + (_e137 * _e155.z))) >= (_e173 * sqrt(_e153)));
                    } else {
                        phi_420_ = false;
                    }
                    let _e178 = phi_420_;
                    phi_421_ = _e178;
                }
                let _e180 = phi_421_;
                if _e180 {
                    let _e182 = samples.member[_e75.first_primitive].flags;
                    let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e190.unnamed.visibility, false), _e190.unnamed_1);
                    phi_432_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e196.unnamed, ((_e182 & 1u) == 0u));
                    phi_433_ = false;
                } else {
                    phi_432_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_433_ = true;
                }
                let _e201 = phi_432_;
                let _e203 = phi_433_;
                phi_434_ = _e201;
                phi_435_ = _e203;
            } else {
                phi_434_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_435_ = true;
            }
            let _e205 = phi_434_;
            let _e207 = phi_435_;
            if _e207 {
                let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
                phi_442_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
            } else {
                phi_442_ = _e205;
            }
            let _e224 = phi_442_;
            phi_446_ = _e224;
        } else {
            let _e230 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e236 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e230.unnamed.visibility, false), _e230.unnamed_1);
            phi_446_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e236.unnamed, true);
        }
        let _e241 = phi_446_;
        if _e241.unnamed_1 {
            phi_1186_ = mask_Masked(_e241.unnamed.visibility, 0u, false);
        } else {
            let _e246 = (_e88 < 0.5f);
            if (_e88 > 0f) {
                phi_459_ = (_e88 < 1f);
            } else {
                phi_459_ = false;
            }
            let _e250 = phi_459_;
            let _e252 = samples.member[_e75.first_primitive].position;
            let _e256 = p.member.previous.eye;
            let _e259 = (_e86.x - _e256.x);
            let _e262 = (_e86.y - _e256.y);
            let _e265 = (_e86.z - _e256.z);
            let _e267 = p.member.previous.forward;
            let _e275 = (((_e259 * _e267.x) + (_e262 * _e267.y)) + (_e265 * _e267.z));
            let _e277 = p.member.previous.right;
            let _e287 = p.member.previous.right;
            let _e302 = p.member.previous.up;
            let _e312 = p.member.previous.up;
            let _e327 = p.member.current.eye;
            let _e330 = (_e252.x - _e327.x);
            let _e333 = (_e252.y - _e327.y);
            let _e336 = (_e252.z - _e327.z);
            let _e338 = p.member.current.forward;
            let _e346 = (((_e330 * _e338.x) + (_e333 * _e338.y)) + (_e336 * _e338.z));
            let _e348 = p.member.current.right;
            let _e358 = p.member.current.right;
            let _e373 = p.member.current.up;
            let _e383 = p.member.current.up;
            let _e402 = p.member.current.size[0u];
            let _e404 = (((((((_e259 * _e277.x) + (_e262 * _e277.y)) + (_e265 * _e277.z)) / ((((_e287.x * _e287.x) + (_e287.y * _e287.y)) + (_e287.z * _e287.z)) * _e275)) - ((((_e330 * _e348.x) + (_e333 * _e348.y)) + (_e336 * _e348.z)) / ((((_e358.x * _e358.x) + (_e358.y * _e358.y)) + (_e358.z * _e358.z)) * _e346))) * 0.5f) * f32(_e402));
            let _e408 = p.member.current.size[1u];
            let _e410 = (((((((_e259 * _e302.x) + (_e262 * _e302.y)) + (_e265 * _e302.z)) / ((((_e312.x * _e312.x) + (_e312.y * _e312.y)) + (_e312.z * _e312.z)) * _e275)) - ((((_e330 * _e373.x) + (_e333 * _e373.y)) + (_e336 * _e373.z)) / ((((_e383.x * _e383.x) + (_e383.y * _e383.y)) + (_e383.z * _e383.z)) * _e346))) * -0.5f) * f32(_e408));
            let _e414 = p.member.current.size[0u];
            let _e416 = p.member.current.size[1u];
            let _e420 = ((f32(_e55.x) + 0.5f) + _e404);
            if (_e420 > -8388608f) {
                let _e432 = f32(select(0i, select(select(i32(_e420), i32(-2147483648), (_e420 < bitcast<f32>(3472883712u))), 2147483647i, (_e420 > bitcast<f32>(1325400063u))), (_e420 == _e420)));
                if (_e432 > _e420) {
                    phi_648_ = 1f;
                } else {
                    phi_648_ = 0f;
                }
                let _e435 = phi_648_;
                if (_e420 < 8388608f) {
                    phi_653_ = (_e432 - _e435);
                    phi_654_ = false;
                } else {
                    phi_653_ = f32();
                    phi_654_ = true;
                }
                let _e438 = phi_653_;
                let _e440 = phi_654_;
                phi_655_ = _e438;
                phi_656_ = _e440;
            } else {
                phi_655_ = f32();
                phi_656_ = true;
            }
            let _e442 = phi_655_;
            let _e444 = phi_656_;
            if _e444 {
                phi_660_ = _e420;
            } else {
                phi_660_ = _e442;
            }
            let _e446 = phi_660_;
            let _e449 = ((f32(_e55.y) + 0.5f) + _e410);
            if (_e449 > -8388608f) {
                let _e461 = f32(select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < bitcast<f32>(3472883712u))), 2147483647i, (_e449 > bitcast<f32>(1325400063u))), (_e449 == _e449)));
                if (_e461 > _e449) {
                    phi_683_ = 1f;
                } else {
                    phi_683_ = 0f;
                }
                let _e464 = phi_683_;
                if (_e449 < 8388608f) {
                    phi_688_ = (_e461 - _e464);
                    phi_689_ = false;
                } else {
                    phi_688_ = f32();
                    phi_689_ = true;
                }
                let _e467 = phi_688_;
                let _e469 = phi_689_;
                phi_690_ = _e467;
                phi_691_ = _e469;
            } else {
                phi_690_ = f32();
                phi_691_ = true;
            }
            let _e471 = phi_690_;
            let _e473 = phi_691_;
            if _e473 {
                phi_695_ = _e449;
            } else {
                phi_695_ = _e471;
            }
            let _e475 = phi_695_;
            if (_e446 >= 0f) {
                if (_e475 >= 0f) {
                    if (_e446 < f32(_e414)) {
                        let _e481 = (_e475 < f32(_e416));
                        if (_e404 == 0f) {
                            phi_716_ = (_e410 == 0f);
                        } else {
                            phi_716_ = false;
                        }
                        let _e485 = phi_716_;
                        if _e481 {
                            phi_735_ = vec2<u32>(select(select(u32(_e446), 0u, (_e446 < bitcast<f32>(0u))), 4294967295u, (_e446 > bitcast<f32>(1333788671u))), select(select(u32(_e475), 0u, (_e475 < bitcast<f32>(0u))), 4294967295u, (_e475 > bitcast<f32>(1333788671u))));
                            phi_736_ = false;
                        } else {
                            phi_735_ = vec2<u32>();
                            phi_736_ = true;
                        }
                        let _e502 = phi_735_;
                        let _e504 = phi_736_;
                        phi_737_ = _e485;
                        phi_738_ = _e481;
                        phi_739_ = _e502;
                        phi_740_ = _e485;
                        phi_741_ = _e481;
                        phi_742_ = false;
                        phi_743_ = _e504;
                    } else {
                        phi_737_ = bool();
                        phi_738_ = bool();
                        phi_739_ = vec2<u32>();
                        phi_740_ = bool();
                        phi_741_ = bool();
                        phi_742_ = true;
                        phi_743_ = false;
                    }
                    let _e506 = phi_737_;
                    let _e508 = phi_738_;
                    let _e510 = phi_739_;
                    let _e512 = phi_740_;
                    let _e514 = phi_741_;
                    let _e516 = phi_742_;
                    let _e518 = phi_743_;
                    phi_744_ = _e506;
                    phi_745_ = _e508;
                    phi_746_ = _e510;
                    phi_747_ = _e512;
                    phi_748_ = _e514;
                    phi_749_ = _e516;
                    phi_750_ = _e518;
                } else {
                    phi_744_ = bool();
                    phi_745_ = bool();
                    phi_746_ = vec2<u32>();
                    phi_747_ = bool();
                    phi_748_ = bool();
                    phi_749_ = true;
                    phi_750_ = false;
                }
                let _e520 = phi_744_;
                let _e522 = phi_745_;
                let _e524 = phi_746_;
                let _e526 = phi_747_;
                let _e528 = phi_748_;
                let _e530 = phi_749_;
                let _e532 = phi_750_;
                phi_751_ = _e520;
                phi_752_ = _e522;
                phi_753_ = _e524;
                phi_754_ = _e526;
                phi_755_ = _e528;
                phi_756_ = _e530;
                phi_757_ = _e532;
            } else {
                phi_751_ = bool();
                phi_752_ = bool();
                phi_753_ = vec2<u32>();
                phi_754_ = bool();
                phi_755_ = bool();
                phi_756_ = true;
                phi_757_ = false;
            }
            let _e534 = phi_751_;
            let _e536 = phi_752_;
            let _e538 = phi_753_;
            let _e540 = phi_754_;
            let _e542 = phi_755_;
            let _e544 = phi_756_;
            let _e546 = phi_757_;
            if _e544 {
                if (_e404 == 0f) {
                    phi_766_ = (_e410 == 0f);
                } else {
                    phi_766_ = false;
                }
                let _e550 = phi_766_;
                phi_767_ = _e550;
                phi_768_ = false;
                phi_769_ = true;
            } else {
                phi_767_ = _e540;
                phi_768_ = _e542;
                phi_769_ = _e546;
            }
            let _e552 = phi_767_;
            let _e554 = phi_768_;
            let _e556 = phi_769_;
            if _e556 {
                phi_773_ = _e552;
                phi_774_ = _e554;
                phi_775_ = vec2<u32>(_e55.x, _e55.y);
            } else {
                phi_773_ = _e534;
                phi_774_ = _e536;
                phi_775_ = _e538;
            }
            let _e558 = phi_773_;
            let _e560 = phi_774_;
            let _e562 = phi_775_;
            let _e572 = lt_mask_Reprojection(vec2<u32>(_e562.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e579 = lt_mask_Reprojection(vec2<u32>(_e572.pixel.x, _e562.y), _e572.is_valid, _e572.has_moved);
            let _e583 = lt_mask_Reprojection(_e579.pixel, _e560, _e579.has_moved);
            let _e587 = lt_mask_Reprojection(_e583.pixel, _e583.is_valid, !(_e558));
            if _e560 {
                let _e590 = p.member.previous.eye;
                let _e601 = p.member.previous.forward;
                let _e610 = (((((_e86.x - _e590.x) * _e601.x) + ((_e86.y - _e590.y) * _e601.y)) + ((_e86.z - _e590.z) * _e601.z)) > 0f);
                let _e614 = lt_mask_Reprojection(_e587.pixel, _e610, _e587.has_moved);
                if _e610 {
                    let _e617 = p.member.previous.eye;
                    let _e628 = p.member.previous.forward;
                    let _e636 = ((((_e86.x - _e617.x) * _e628.x) + ((_e86.y - _e617.y) * _e628.y)) + ((_e86.z - _e617.z) * _e628.z));
                    let _e638 = ((_e562.y * _e83) + _e562.x);
                    if (_e638 < arrayLength((&last_depths.member))) {
                    } else {
                        return;
                    }
                    let _e642 = last_depths.member[(0u + _e638)];
                    let _e644 = p.member.depth_tolerance;
                    let _e647 = abs(_e636);
                    let _e648 = abs(_e642);
                    if ((bitcast<u32>(_e648) & 2147483647u) > 2139095040u) {
                        phi_864_ = true;
                    } else {
                        let _e652 = (_e648 > _e647);
                        if _e652 {
                        }
                        phi_864_ = _e652;
                    }
                    let _e654 = phi_864_;
                    if _e654 {
                        phi_868_ = _e648;
                    } else {
                        phi_868_ = _e647;
                    }
                    let _e656 = phi_868_;
                    phi_872_ = lt_mask_Reprojection(_e614.pixel, (abs((_e636 - _e642)) <= (_e644 * _e656)), _e614.has_moved);
                } else {
                    phi_872_ = _e614;
                }
                let _e664 = phi_872_;
                if _e664.is_valid {
                    let _e667 = p.member.flags;
                    phi_881_ = ((_e667 & 1u) != 0u);
                    phi_882_ = false;
                } else {
                    phi_881_ = bool();
                    phi_882_ = true;
                }
                let _e671 = phi_881_;
                let _e673 = phi_882_;
                phi_884_ = _e671;
                phi_885_ = _e664;
                phi_886_ = _e664;
                phi_887_ = _e673;
            } else {
                phi_884_ = bool();
                phi_885_ = lt_mask_Reprojection();
                phi_886_ = lt_mask_Reprojection(_e587.pixel, false, _e587.has_moved);
                phi_887_ = true;
            }
            let _e679 = phi_884_;
            let _e681 = phi_885_;
            let _e683 = phi_886_;
            let _e685 = phi_887_;
            if _e685 {
                phi_891_ = false;
                phi_892_ = _e683;
            } else {
                phi_891_ = _e679;
                phi_892_ = _e681;
            }
            let _e687 = phi_891_;
            let _e689 = phi_892_;
            let _e693 = lt_mask_Reprojection(_e689.pixel, _e687, _e689.has_moved);
            if _e693.has_moved {
            }
            let _e699 = lt_mask_Neighbourhood(false, true);
            if _e250 {
                phi_1102_ = _e699;
            } else {
                if true {
                    if _e687 {
                        if _e693.has_moved {
                            let _e702 = p.member.moving_pattern;
                            phi_920_ = _e702;
                        } else {
                            let _e704 = p.member.still_pattern;
                            phi_920_ = _e704;
                        }
                        let _e706 = phi_920_;
                        phi_922_ = 0u;
                        phi_925_ = _e699;
                        loop {
                            let _e708 = phi_922_;
                            let _e710 = phi_925_;
                            local_1 = _e710;
                            if (1u <= _e706) {
                                if (_e706 <= 4u) {
                                    phi_937_ = false;
                                } else {
                                    phi_937_ = true;
                                }
                                let _e714 = phi_937_;
                                phi_938_ = _e714;
                            } else {
                                phi_938_ = true;
                            }
                            let _e716 = phi_938_;
                            if _e716 {
                                switch bitcast<i32>(_e706) {
                                    case 5: {
                                        phi_947_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_947_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_947_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_947_ = 9u;
                                        break;
                                    }
                                }
                                let _e719 = phi_947_;
                                phi_948_ = _e719;
                            } else {
                                phi_948_ = 5u;
                            }
                            let _e721 = phi_948_;
                            let _e722 = (_e708 < _e721);
                            if _e722 {
                                let _e728 = p.member.frame;
                                let _e732 = p.member.current.size[0u];
                                let _e734 = p.member.current.size[1u];
                                switch bitcast<i32>(_e706) {
                                    case 1: {
                                        let _e744 = lt_mask_pattern_plus(_e708);
                                        phi_1028_ = vec2<i32>(_e744.x, _e744.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e748 = lt_mask_pattern_cross(_e708);
                                        phi_1028_ = vec2<i32>(_e748.x, _e748.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e754 = lt_mask_pattern_plus_or_cross(_e708, ((_e693.pixel.x + _e693.pixel.y) & 1u));
                                        phi_1028_ = vec2<i32>(_e754.x, _e754.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e759 = lt_mask_pattern_plus_or_cross(_e708, (_e728 & 1u));
                                        phi_1028_ = vec2<i32>(_e759.x, _e759.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e728 & 3u)) {
                                            case 0: {
                                                phi_1008_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1008_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1008_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1008_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e770 = phi_1008_;
                                        phi_1028_ = (_e770 + vec2<i32>(bitcast<i32>((_e708 & 1u)), bitcast<i32>(((_e708 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1028_ = vec2<i32>((bitcast<i32>((_e708 % 5u)) - 2i), (bitcast<i32>(((_e708 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e787 = lt_mask_pattern_diamond(_e708);
                                        phi_1028_ = vec2<i32>(_e787.x, _e787.y);
                                        break;
                                    }
                                    default: {
                                        phi_1028_ = vec2<i32>((bitcast<i32>((_e708 % 3u)) - 1i), (bitcast<i32>(((_e708 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e792 = phi_1028_;
                                let _e795 = lt_mask_pattern_step_clamped(_e693.pixel.x, _e792.x, _e732);
                                let _e796 = lt_mask_pattern_step_clamped(_e693.pixel.y, _e792.y, _e734);
                                let _e798 = ((_e796 * _e83) + _e795);
                                if (_e798 < arrayLength((&last_bits.member))) {
                                } else {
                                    return;
                                }
                                let _e802 = last_bits.member[(0u + _e798)];
                                if ((_e802 & 2u) == 0u) {
                                    phi_1051_ = (_e802 & 1u);
                                } else {
                                    phi_1051_ = (_e802 & 7u);
                                }
                                let _e808 = phi_1051_;
                                if _e710.any_expands {
                                    phi_1077_ = true;
                                } else {
                                    if ((_e808 & 2u) != 0u) {
                                        if (((_e808 & 4u) != 0u) != _e246) {
                                            phi_1068_ = false;
                                        } else {
                                            phi_1068_ = true;
                                        }
                                        let _e817 = phi_1068_;
                                        phi_1069_ = _e817;
                                    } else {
                                        phi_1069_ = true;
                                    }
                                    let _e819 = phi_1069_;
                                    if _e819 {
                                        phi_1076_ = (((_e808 & 1u) != 0u) != _e246);
                                    } else {
                                        phi_1076_ = true;
                                    }
                                    let _e824 = phi_1076_;
                                    phi_1077_ = _e824;
                                }
                                let _e826 = phi_1077_;
                                if _e710.all_remove {
                                    if (((_e808 & 1u) != 0u) == _e246) {
                                        if ((_e808 & 2u) != 0u) {
                                            phi_1095_ = (((_e808 & 4u) != 0u) == _e246);
                                        } else {
                                            phi_1095_ = true;
                                        }
                                        let _e836 = phi_1095_;
                                        phi_1096_ = _e836;
                                    } else {
                                        phi_1096_ = false;
                                    }
                                    let _e838 = phi_1096_;
                                    phi_1097_ = _e838;
                                } else {
                                    phi_1097_ = false;
                                }
                                let _e840 = phi_1097_;
                                phi_923_ = (_e708 + 1u);
                                phi_926_ = lt_mask_Neighbourhood(_e826, _e840);
                            } else {
                                phi_923_ = u32();
                                phi_926_ = lt_mask_Neighbourhood();
                            }
                            let _e844 = phi_923_;
                            let _e846 = phi_926_;
                            continue;
                            continuing {
                                phi_922_ = _e844;
                                phi_925_ = _e846;
                                break if !(_e722);
                            }
                        }
                        let _e1067 = local_1;
                        phi_1100_ = _e1067;
                    } else {
                        phi_1100_ = _e699;
                    }
                    let _e849 = phi_1100_;
                    phi_1101_ = _e849;
                } else {
                    phi_1101_ = _e699;
                }
                let _e851 = phi_1101_;
                phi_1102_ = _e851;
            }
            let _e853 = phi_1102_;
            if (_e88 != 0.5f) {
                if _e687 {
                    if _e250 {
                        phi_1128_ = true;
                    } else {
                        if _e853.any_expands {
                            phi_1127_ = false;
                        } else {
                            phi_1127_ = true;
                        }
                        let _e858 = phi_1127_;
                        phi_1128_ = _e858;
                    }
                    let _e860 = phi_1128_;
                    if _e860 {
                        if _e250 {
                            if false {
                                if _e853.all_remove {
                                    phi_1141_ = false;
                                } else {
                                    phi_1141_ = true;
                                }
                                let _e862 = phi_1141_;
                                phi_1142_ = _e862;
                            } else {
                                phi_1142_ = true;
                            }
                            let _e864 = phi_1142_;
                            phi_1143_ = _e864;
                        } else {
                            phi_1143_ = true;
                        }
                        let _e866 = phi_1143_;
                        if _e866 {
                            if _e250 {
                                phi_1150_ = 1u;
                            } else {
                                phi_1150_ = 0u;
                            }
                            let _e868 = phi_1150_;
                            phi_1151_ = _e868;
                        } else {
                            phi_1151_ = 5u;
                        }
                        let _e870 = phi_1151_;
                        phi_1152_ = _e870;
                    } else {
                        phi_1152_ = 4u;
                    }
                    let _e872 = phi_1152_;
                    phi_1153_ = _e872;
                } else {
                    phi_1153_ = 3u;
                }
                let _e874 = phi_1153_;
                phi_1154_ = _e874;
            } else {
                phi_1154_ = 2u;
            }
            let _e876 = phi_1154_;
            if !((_e876 == 0u)) {
                phi_1162_ = !((_e876 == 5u));
            } else {
                phi_1162_ = false;
            }
            let _e882 = phi_1162_;
            if _e882 {
                if _e246 {
                    phi_1170_ = (2u | 1u);
                } else {
                    phi_1170_ = 2u;
                }
                let _e885 = phi_1170_;
                if false {
                    phi_1175_ = (_e885 | 4u);
                } else {
                    phi_1175_ = _e885;
                }
                let _e888 = phi_1175_;
                phi_1180_ = _e888;
            } else {
                if _e246 {
                    phi_1179_ = 1u;
                } else {
                    phi_1179_ = 0u;
                }
                let _e890 = phi_1179_;
                phi_1180_ = _e890;
            }
            let _e892 = phi_1180_;
            if _e246 {
                phi_1184_ = 0f;
            } else {
                phi_1184_ = 1f;
            }
            let _e894 = phi_1184_;
            phi_1186_ = mask_Masked(_e894, _e892, _e882);
        }
        let _e897 = phi_1186_;
        visibility.member[_e75.first_primitive] = _e897.visibility;
        bits.member[_e75.first_primitive] = _e897.bits;
        let _e905 = samples.member[_e75.first_primitive].normal[0u];
        let _e907 = global[0u];
        if (_e905 == _e907) {
            let _e910 = samples.member[_e75.first_primitive].normal[1u];
            let _e912 = global[1u];
            if (_e910 == _e912) {
                let _e915 = samples.member[_e75.first_primitive].normal[2u];
                let _e917 = global[2u];
                phi_1214_ = (_e915 == _e917);
                phi_1215_ = false;
            } else {
                phi_1214_ = bool();
                phi_1215_ = true;
            }
            let _e920 = phi_1214_;
            let _e922 = phi_1215_;
            phi_1216_ = _e920;
            phi_1217_ = _e922;
        } else {
            phi_1216_ = bool();
            phi_1217_ = true;
        }
        let _e924 = phi_1216_;
        let _e926 = phi_1217_;
        if _e926 {
            phi_1221_ = false;
        } else {
            phi_1221_ = _e924;
        }
        let _e928 = phi_1221_;
        if !(_e928) {
            let _e931 = samples.member[_e75.first_primitive].position;
            let _e933 = p.member.current.eye;
            let _e944 = p.member.current.forward;
            phi_1249_ = ((((_e931.x - _e933.x) * _e944.x) + ((_e931.y - _e933.y) * _e944.y)) + ((_e931.z - _e933.z) * _e944.z));
        } else {
            phi_1249_ = 0f;
        }
        let _e954 = phi_1249_;
        depths.member[_e75.first_primitive] = _e954;
        phi_1252_ = _e897.needs_ray;
        phi_1253_ = _e75.first_primitive;
    } else {
        phi_1252_ = false;
        phi_1253_ = 0u;
    }
    let _e958 = phi_1252_;
    let _e960 = phi_1253_;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e958 {
        let _e964 = atomicAdd((&shared_[0u]), 1u);
        phi_1264_ = _e964;
    } else {
        phi_1264_ = 0u;
    }
    let _e966 = phi_1264_;
    workgroupBarrier();
    if (_e56 == 0u) {
        let _e970 = atomicLoad((&shared_[0u]));
        let _e971 = atomicAdd((&list.member[3u]), _e970);
        atomicStore((&shared_[1u]), _e971);
    }
    workgroupBarrier();
    if _e958 {
        let _e974 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e974) + _e966)]), _e960);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
