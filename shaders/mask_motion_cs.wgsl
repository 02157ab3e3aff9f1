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

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_164_: lt_bvh_traverse_Tree;
    var phi_165_: bool;
    var phi_170_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_162_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_163_ = false;
        } else {
            phi_162_ = lt_bvh_traverse_Tree();
            phi_163_ = true;
        }
        let _e64 = phi_162_;
        let _e66 = phi_163_;
        phi_164_ = _e64;
        phi_165_ = _e66;
    } else {
        phi_164_ = lt_bvh_traverse_Tree();
        phi_165_ = true;
    }
    let _e68 = phi_164_;
    let _e70 = phi_165_;
    if _e70 {
        phi_170_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_170_ = _e68;
    }
    let _e75 = phi_170_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_188_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_188_ = vec2(0i);
            break;
        }
        case 1: {
            phi_188_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_188_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_188_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_188_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e60 = phi_188_;
    return vec2<i32>(_e60.x, _e60.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_206_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_206_ = vec2(0i);
            break;
        }
        case 1: {
            phi_206_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_206_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_206_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_206_ = vec2(1i);
            break;
        }
    }
    let _e60 = phi_206_;
    return vec2<i32>(_e60.x, _e60.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_225_: vec2<i32>;

    if (param_6 == 0u) {
        let _e54 = lt_mask_pattern_plus(param_5);
        phi_225_ = vec2<i32>(_e54.x, _e54.y);
    } else {
        let _e58 = lt_mask_pattern_cross(param_5);
        phi_225_ = vec2<i32>(_e58.x, _e58.y);
    }
    let _e63 = phi_225_;
    return vec2<i32>(_e63.x, _e63.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_250_: vec2<i32>;

    let _e52 = (param_7 % 13u);
    switch bitcast<i32>(_e52) {
        case 9: {
            phi_250_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_250_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_250_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_250_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_250_ = vec2<i32>((bitcast<i32>((_e52 % 3u)) - 1i), (bitcast<i32>(((_e52 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e67 = phi_250_;
    return vec2<i32>(_e67.x, _e67.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_271_: u32;
    var phi_272_: u32;

    let _e55 = (bitcast<i32>(param_8) + param_9);
    if (_e55 < 0i) {
        phi_272_ = 0u;
    } else {
        if (_e55 >= bitcast<i32>(param_10)) {
            phi_271_ = (param_10 - 1u);
        } else {
            phi_271_ = bitcast<u32>(_e55);
        }
        let _e62 = phi_271_;
        phi_272_ = _e62;
    }
    let _e64 = phi_272_;
    return _e64;
}

fn function_() {
    var phi_332_: bool;
    var phi_333_: bool;
    var phi_334_: bool;
    var phi_335_: bool;
    var phi_339_: bool;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_421_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_422_: bool;
    var phi_423_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_424_: bool;
    var phi_431_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_435_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_448_: bool;
    var phi_637_: f32;
    var phi_642_: f32;
    var phi_643_: bool;
    var phi_644_: f32;
    var phi_645_: bool;
    var phi_649_: f32;
    var phi_672_: f32;
    var phi_677_: f32;
    var phi_678_: bool;
    var phi_679_: f32;
    var phi_680_: bool;
    var phi_684_: f32;
    var phi_705_: bool;
    var phi_724_: vec2<u32>;
    var phi_725_: bool;
    var phi_726_: bool;
    var phi_727_: bool;
    var phi_728_: vec2<u32>;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_731_: bool;
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
    var phi_755_: bool;
    var phi_756_: bool;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_762_: bool;
    var phi_763_: bool;
    var phi_764_: vec2<u32>;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_809_: bool;
    var phi_810_: lt_mask_Reprojection;
    var phi_811_: lt_mask_Reprojection;
    var phi_812_: bool;
    var phi_816_: bool;
    var phi_817_: lt_mask_Reprojection;
    var phi_831_: bool;
    var phi_842_: bool;
    var phi_843_: bool;
    var phi_844_: bool;
    var phi_845_: bool;
    var phi_846_: bool;
    var phi_847_: bool;
    var phi_851_: bool;
    var phi_856_: bool;
    var phi_871_: u32;
    var phi_873_: u32;
    var phi_876_: lt_mask_Neighbourhood;
    var phi_888_: bool;
    var phi_889_: bool;
    var phi_898_: u32;
    var phi_899_: u32;
    var phi_959_: vec2<i32>;
    var phi_979_: vec2<i32>;
    var phi_1002_: u32;
    var phi_1019_: bool;
    var phi_1020_: bool;
    var phi_1027_: bool;
    var phi_1028_: bool;
    var phi_1046_: bool;
    var phi_1047_: bool;
    var phi_1048_: bool;
    var phi_874_: u32;
    var phi_877_: lt_mask_Neighbourhood;
    var phi_1051_: lt_mask_Neighbourhood;
    var phi_1052_: lt_mask_Neighbourhood;
    var phi_1077_: bool;
    var phi_1078_: bool;
    var phi_1091_: bool;
    var phi_1092_: bool;
    var phi_1093_: bool;
    var phi_1100_: u32;
    var phi_1101_: u32;
    var phi_1102_: u32;
    var phi_1103_: u32;
    var phi_1104_: u32;
    var phi_1112_: bool;
    var phi_1120_: u32;
    var phi_1125_: u32;
    var phi_1129_: u32;
    var phi_1130_: u32;
    var phi_1134_: f32;
    var phi_1136_: mask_Masked;
    var phi_1142_: bool;
    var phi_1143_: u32;
    var phi_1154_: u32;
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
        let _e86 = samples.member[_e67.first_primitive].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[_e67.first_primitive].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[_e67.first_primitive].normal[2u];
                let _e98 = global[2u];
                phi_332_ = (_e96 == _e98);
                phi_333_ = false;
            } else {
                phi_332_ = bool();
                phi_333_ = true;
            }
            let _e101 = phi_332_;
            let _e103 = phi_333_;
            phi_334_ = _e101;
            phi_335_ = _e103;
        } else {
            phi_334_ = bool();
            phi_335_ = true;
        }
        let _e105 = phi_334_;
        let _e107 = phi_335_;
        if _e107 {
            phi_339_ = false;
        } else {
            phi_339_ = _e105;
        }
        let _e109 = phi_339_;
        if !(_e109) {
            let _e112 = samples.member[_e67.first_primitive].position;
            let _e114 = p.member.light.place;
            let _e120 = p.member.light.place[3u];
            let _e127 = (_e114.x - (_e112.x * _e120));
            let _e128 = (_e114.y - (_e112.y * _e120));
            let _e129 = (_e114.z - (_e112.z * _e120));
            let _e131 = samples.member[_e67.first_primitive].normal;
            if ((((_e131.x * _e127) + (_e131.y * _e128)) + (_e131.z * _e129)) > 0f) {
                let _e145 = (((_e127 * _e127) + (_e128 * _e128)) + (_e129 * _e129));
                let _e147 = p.member.light.axis;
                let _e159 = p.member.light.place[3u];
                if (_e159 == 0f) {
                    phi_410_ = true;
                } else {
                    let _e162 = p.member.light.range_squared;
                    if (_e145 <= _e162) {
                        let _e165 = p.member.light.cos_outer;
                        phi_409_ = (-((((_e127 * _e147.x) + (_e128 * _e147.y)) + (_e129 * _e147.z))) >= (_e165 * sqrt(_e145)));
                    } else {
                        phi_409_ = false;
                    }
                    let _e170 = phi_409_;
                    phi_410_ = _e170;
                }
                let _e172 = phi_410_;
                if _e172 {
                    let _e174 = samples.member[_e67.first_primitive].flags;
                    let _e182 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e182.unnamed.visibility, false), _e182.unnamed_1);
                    phi_421_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e188.unnamed, ((_e174 & 1u) == 0u));
                    phi_422_ = false;
                } else {
                    phi_421_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_422_ = true;
                }
                let _e193 = phi_421_;
                let _e195 = phi_422_;
                phi_423_ = _e193;
                phi_424_ = _e195;
            } else {
                phi_423_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_424_ = true;
            }
            let _e197 = phi_423_;
            let _e199 = phi_424_;
            if _e199 {
                let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
                phi_431_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
            } else {
                phi_431_ = _e197;
            }
            let _e216 = phi_431_;
            phi_435_ = _e216;
        } else {
            let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
            phi_435_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, true);
        }
        let _e233 = phi_435_;
        if _e233.unnamed_1 {
            phi_1136_ = mask_Masked(_e233.unnamed.visibility, 0u, false);
        } else {
            let _e238 = (_e80 < 0.5f);
            if (_e80 > 0f) {
                phi_448_ = (_e80 < 1f);
            } else {
                phi_448_ = false;
            }
            let _e242 = phi_448_;
            let _e244 = samples.member[_e67.first_primitive].position;
            let _e248 = p.member.previous.eye;
            let _e251 = (_e78.x - _e248.x);
            let _e254 = (_e78.y - _e248.y);
            let _e257 = (_e78.z - _e248.z);
            let _e259 = p.member.previous.forward;
            let _e267 = (((_e251 * _e259.x) + (_e254 * _e259.y)) + (_e257 * _e259.z));
            let _e269 = p.member.previous.right;
            let _e279 = p.member.previous.right;
            let _e294 = p.member.previous.up;
            let _e304 = p.member.previous.up;
            let _e319 = p.member.current.eye;
            let _e322 = (_e244.x - _e319.x);
            let _e325 = (_e244.y - _e319.y);
            let _e328 = (_e244.z - _e319.z);
            let _e330 = p.member.current.forward;
            let _e338 = (((_e322 * _e330.x) + (_e325 * _e330.y)) + (_e328 * _e330.z));
            let _e340 = p.member.current.right;
            let _e350 = p.member.current.right;
            let _e365 = p.member.current.up;
            let _e375 = p.member.current.up;
            let _e394 = p.member.current.size[0u];
            let _e396 = (((((((_e251 * _e269.x) + (_e254 * _e269.y)) + (_e257 * _e269.z)) / ((((_e279.x * _e279.x) + (_e279.y * _e279.y)) + (_e279.z * _e279.z)) * _e267)) - ((((_e322 * _e340.x) + (_e325 * _e340.y)) + (_e328 * _e340.z)) / ((((_e350.x * _e350.x) + (_e350.y * _e350.y)) + (_e350.z * _e350.z)) * _e338))) * 0.5f) * f32(_e394));
            let _e400 = p.member.current.size[1u];
            let _e402 = (((((((_e251 * _e294.x) + (_e254 * _e294.y)) + (_e257 * _e294.z)) / ((((_e304.x * _e304.x) + (_e304.y * _e304.y)) + (_e304.z * _e304.z)) * _e267)) - ((((_e322 * _e365.x) + (_e325 * _e365.y)) + (_e328 * _e365.z)) / ((((_e375.x * _e375.x) + (_e375.y * _e375.y)) + (_e375.z * _e375.z)) * _e338))) * -0.5f) * f32(_e400));
            let _e406 = p.member.current.size[0u];
            let _e408 = p.member.current.size[1u];
            let _e412 = ((f32(_e51.x) + 0.5f) + _e396);
            if (_e412 > -8388608f) {
                let _e424 = f32(select(0i, select(select(i32(_e412), i32(-2147483648), (_e412 < bitcast<f32>(3472883712u))), 2147483647i, (_e412 > bitcast<f32>(1325400063u))), (_e412 == _e412)));
                if (_e424 > _e412) {
                    phi_637_ = 1f;
                } else {
                    phi_637_ = 0f;
                }
                let _e427 = phi_637_;
                if (_e412 < 8388608f) {
                    phi_642_ = (_e424 - _e427);
                    phi_643_ = false;
                } else {
                    phi_642_ = f32();
                    phi_643_ = true;
                }
                let _e430 = phi_642_;
                let _e432 = phi_643_;
                phi_644_ = _e430;
                phi_645_ = _e432;
            } else {
                phi_644_ = f32();
                phi_645_ = true;
            }
            let _e434 = phi_644_;
            let _e436 = phi_645_;
            if _e436 {
                phi_649_ = _e412;
            } else {
                phi_649_ = _e434;
            }
            let _e438 = phi_649_;
            let _e441 = ((f32(_e51.y) + 0.5f) + _e402);
            if (_e441 > -8388608f) {
                let _e453 = f32(select(0i, select(select(i32(_e441), i32(-2147483648), (_e441 < bitcast<f32>(3472883712u))), 2147483647i, (_e441 > bitcast<f32>(1325400063u))), (_e441 == _e441)));
                if (_e453 > _e441) {
                    phi_672_ = 1f;
                } else {
                    phi_672_ = 0f;
                }
                let _e456 = phi_672_;
                if (_e441 < 8388608f) {
                    phi_677_ = (_e453 - _e456);
                    phi_678_ = false;
                } else {
                    phi_677_ = f32();
                    phi_678_ = true;
                }
                let _e459 = phi_677_;
                let _e461 = phi_678_;
                phi_679_ = _e459;
                phi_680_ = _e461;
            } else {
                phi_679_ = f32();
                phi_680_ = true;
            }
            let _e463 = phi_679_;
            let _e465 = phi_680_;
            if _e465 {
                phi_684_ = _e441;
            } else {
                phi_684_ = _e463;
            }
            let _e467 = phi_684_;
            if (_e438 >= 0f) {
                if (_e467 >= 0f) {
                    if (_e438 < f32(_e406)) {
                        let _e473 = (_e467 < f32(_e408));
                        if (_e396 == 0f) {
                            phi_705_ = (_e402 == 0f);
                        } else {
                            phi_705_ = false;
                        }
                        let _e477 = phi_705_;
                        if _e473 {
                            phi_724_ = vec2<u32>(select(select(u32(_e438), 0u, (_e438 < bitcast<f32>(0u))), 4294967295u, (_e438 > bitcast<f32>(1333788671u))), select(select(u32(_e467), 0u, (_e467 < bitcast<f32>(0u))), 4294967295u, (_e467 > bitcast<f32>(1333788671u))));
                            phi_725_ = false;
                        } else {
                            phi_724_ = vec2<u32>();
                            phi_725_ = true;
                        }
                        let _e494 = phi_724_;
                        let _e496 = phi_725_;
                        phi_726_ = _e477;
                        phi_727_ = _e473;
                        phi_728_ = _e494;
                        phi_729_ = _e477;
                        phi_730_ = _e473;
                        phi_731_ = false;
                        phi_732_ = _e496;
                    } else {
                        phi_726_ = bool();
                        phi_727_ = bool();
                        phi_728_ = vec2<u32>();
                        phi_729_ = bool();
                        phi_730_ = bool();
                        phi_731_ = true;
                        phi_732_ = false;
                    }
                    let _e498 = phi_726_;
                    let _e500 = phi_727_;
                    let _e502 = phi_728_;
                    let _e504 = phi_729_;
                    let _e506 = phi_730_;
                    let _e508 = phi_731_;
                    let _e510 = phi_732_;
                    phi_733_ = _e498;
                    phi_734_ = _e500;
                    phi_735_ = _e502;
                    phi_736_ = _e504;
                    phi_737_ = _e506;
                    phi_738_ = _e508;
                    phi_739_ = _e510;
                } else {
                    phi_733_ = bool();
                    phi_734_ = bool();
                    phi_735_ = vec2<u32>();
                    phi_736_ = bool();
                    phi_737_ = bool();
                    phi_738_ = true;
                    phi_739_ = false;
                }
                let _e512 = phi_733_;
                let _e514 = phi_734_;
                let _e516 = phi_735_;
                let _e518 = phi_736_;
                let _e520 = phi_737_;
                let _e522 = phi_738_;
                let _e524 = phi_739_;
                phi_740_ = _e512;
                phi_741_ = _e514;
                phi_742_ = _e516;
                phi_743_ = _e518;
                phi_744_ = _e520;
                phi_745_ = _e522;
                phi_746_ = _e524;
            } else {
                phi_740_ = bool();
                phi_741_ = bool();
                phi_742_ = vec2<u32>();
                phi_743_ = bool();
                phi_744_ = bool();
                phi_745_ = true;
                phi_746_ = false;
            }
            let _e526 = phi_740_;
            let _e528 = phi_741_;
            let _e530 = phi_742_;
            let _e532 = phi_743_;
            let _e534 = phi_744_;
            let _e536 = phi_745_;
            let _e538 = phi_746_;
            if _e536 {
                if (_e396 == 0f) {
                    phi_755_ = (_e402 == 0f);
                } else {
                    phi_755_ = false;
                }
                let _e542 = phi_755_;
                phi_756_ = _e542;
                phi_757_ = false;
                phi_758_ = true;
            } else {
                phi_756_ = _e532;
                phi_757_ = _e534;
                phi_758_ = _e538;
            }
            let _e544 = phi_756_;
            let _e546 = phi_757_;
            let _e548 = phi_758_;
            if _e548 {
                phi_762_ = _e544;
                phi_763_ = _e546;
                phi_764_ = vec2<u32>(_e51.x, _e51.y);
            } else {
                phi_762_ = _e526;
                phi_763_ = _e528;
                phi_764_ = _e530;
            }
            let _e550 = phi_762_;
            let _e552 = phi_763_;
            let _e554 = phi_764_;
            let _e564 = lt_mask_Reprojection(vec2<u32>(_e554.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e571 = lt_mask_Reprojection(vec2<u32>(_e564.pixel.x, _e554.y), _e564.is_valid, _e564.has_moved);
            let _e575 = lt_mask_Reprojection(_e571.pixel, _e552, _e571.has_moved);
            let _e579 = lt_mask_Reprojection(_e575.pixel, _e575.is_valid, !(_e550));
            if _e552 {
                let _e582 = p.member.previous.eye;
                let _e593 = p.member.previous.forward;
                let _e602 = (((((_e78.x - _e582.x) * _e593.x) + ((_e78.y - _e582.y) * _e593.y)) + ((_e78.z - _e582.z) * _e593.z)) > 0f);
                let _e606 = lt_mask_Reprojection(_e579.pixel, _e602, _e579.has_moved);
                if _e602 {
                    let _e608 = p.member.flags;
                    phi_806_ = ((_e608 & 1u) != 0u);
                    phi_807_ = false;
                } else {
                    phi_806_ = bool();
                    phi_807_ = true;
                }
                let _e612 = phi_806_;
                let _e614 = phi_807_;
                phi_809_ = _e612;
                phi_810_ = _e606;
                phi_811_ = _e606;
                phi_812_ = _e614;
            } else {
                phi_809_ = bool();
                phi_810_ = lt_mask_Reprojection();
                phi_811_ = lt_mask_Reprojection(_e579.pixel, false, _e579.has_moved);
                phi_812_ = true;
            }
            let _e620 = phi_809_;
            let _e622 = phi_810_;
            let _e624 = phi_811_;
            let _e626 = phi_812_;
            if _e626 {
                phi_816_ = false;
                phi_817_ = _e624;
            } else {
                phi_816_ = _e620;
                phi_817_ = _e622;
            }
            let _e628 = phi_816_;
            let _e630 = phi_817_;
            let _e634 = lt_mask_Reprojection(_e630.pixel, _e628, _e630.has_moved);
            let _e636 = p.member.flags;
            if _e634.has_moved {
                let _e641 = p.member.flags;
                phi_831_ = ((_e641 & 4u) == 0u);
            } else {
                phi_831_ = false;
            }
            let _e645 = phi_831_;
            if ((_e636 & 2u) != 0u) {
                if false {
                    phi_844_ = bool();
                    phi_845_ = true;
                } else {
                    if true {
                        phi_842_ = !(_e645);
                        phi_843_ = false;
                    } else {
                        phi_842_ = bool();
                        phi_843_ = true;
                    }
                    let _e648 = phi_842_;
                    let _e650 = phi_843_;
                    phi_844_ = _e648;
                    phi_845_ = _e650;
                }
                let _e652 = phi_844_;
                let _e654 = phi_845_;
                phi_846_ = _e652;
                phi_847_ = _e654;
            } else {
                phi_846_ = bool();
                phi_847_ = true;
            }
            let _e656 = phi_846_;
            let _e658 = phi_847_;
            if _e658 {
                phi_851_ = false;
            } else {
                phi_851_ = _e656;
            }
            let _e660 = phi_851_;
            let _e661 = lt_mask_Neighbourhood(false, true);
            if _e242 {
                phi_856_ = _e660;
            } else {
                phi_856_ = true;
            }
            let _e663 = phi_856_;
            if _e663 {
                if _e628 {
                    if _e634.has_moved {
                        let _e666 = p.member.moving_pattern;
                        phi_871_ = _e666;
                    } else {
                        let _e668 = p.member.still_pattern;
                        phi_871_ = _e668;
                    }
                    let _e670 = phi_871_;
                    phi_873_ = 0u;
                    phi_876_ = _e661;
                    loop {
                        let _e672 = phi_873_;
                        let _e674 = phi_876_;
                        local_1 = _e674;
                        if (1u <= _e670) {
                            if (_e670 <= 4u) {
                                phi_888_ = false;
                            } else {
                                phi_888_ = true;
                            }
                            let _e678 = phi_888_;
                            phi_889_ = _e678;
                        } else {
                            phi_889_ = true;
                        }
                        let _e680 = phi_889_;
                        if _e680 {
                            switch bitcast<i32>(_e670) {
                                case 5: {
                                    phi_898_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_898_ = 25u;
                                    break;
                                }
                                case 7: {
                                    phi_898_ = 13u;
                                    break;
                                }
                                default: {
                                    phi_898_ = 9u;
                                    break;
                                }
                            }
                            let _e683 = phi_898_;
                            phi_899_ = _e683;
                        } else {
                            phi_899_ = 5u;
                        }
                        let _e685 = phi_899_;
                        let _e686 = (_e672 < _e685);
                        if _e686 {
                            let _e692 = p.member.frame;
                            let _e696 = p.member.current.size[0u];
                            let _e698 = p.member.current.size[1u];
                            switch bitcast<i32>(_e670) {
                                case 1: {
                                    let _e708 = lt_mask_pattern_plus(_e672);
                                    phi_979_ = vec2<i32>(_e708.x, _e708.y);
                                    break;
                                }
                                case 2: {
                                    let _e712 = lt_mask_pattern_cross(_e672);
                                    phi_979_ = vec2<i32>(_e712.x, _e712.y);
                                    break;
                                }
                                case 3: {
                                    let _e718 = lt_mask_pattern_plus_or_cross(_e672, ((_e634.pixel.x + _e634.pixel.y) & 1u));
                                    phi_979_ = vec2<i32>(_e718.x, _e718.y);
                                    break;
                                }
                                case 4: {
                                    let _e723 = lt_mask_pattern_plus_or_cross(_e672, (_e692 & 1u));
                                    phi_979_ = vec2<i32>(_e723.x, _e723.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e692 & 3u)) {
                                        case 0: {
                                            phi_959_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_959_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_959_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_959_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e734 = phi_959_;
                                    phi_979_ = (_e734 + vec2<i32>(bitcast<i32>((_e672 & 1u)), bitcast<i32>(((_e672 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_979_ = vec2<i32>((bitcast<i32>((_e672 % 5u)) - 2i), (bitcast<i32>(((_e672 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                case 7: {
                                    let _e751 = lt_mask_pattern_diamond(_e672);
                                    phi_979_ = vec2<i32>(_e751.x, _e751.y);
                                    break;
                                }
                                default: {
                                    phi_979_ = vec2<i32>((bitcast<i32>((_e672 % 3u)) - 1i), (bitcast<i32>(((_e672 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e756 = phi_979_;
                            let _e759 = lt_mask_pattern_step_clamped(_e634.pixel.x, _e756.x, _e696);
                            let _e760 = lt_mask_pattern_step_clamped(_e634.pixel.y, _e756.y, _e698);
                            let _e762 = ((_e760 * _e75) + _e759);
                            if (_e762 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e766 = last_bits.member[(0u + _e762)];
                            if ((_e766 & 2u) == 0u) {
                                phi_1002_ = (_e766 & 1u);
                            } else {
                                phi_1002_ = (_e766 & 7u);
                            }
                            let _e772 = phi_1002_;
                            if _e674.any_expands {
                                phi_1028_ = true;
                            } else {
                                if ((_e772 & 2u) != 0u) {
                                    if (((_e772 & 4u) != 0u) != _e238) {
                                        phi_1019_ = false;
                                    } else {
                                        phi_1019_ = true;
                                    }
                                    let _e781 = phi_1019_;
                                    phi_1020_ = _e781;
                                } else {
                                    phi_1020_ = true;
                                }
                                let _e783 = phi_1020_;
                                if _e783 {
                                    phi_1027_ = (((_e772 & 1u) != 0u) != _e238);
                                } else {
                                    phi_1027_ = true;
                                }
                                let _e788 = phi_1027_;
                                phi_1028_ = _e788;
                            }
                            let _e790 = phi_1028_;
                            if _e674.all_remove {
                                if (((_e772 & 1u) != 0u) == _e238) {
                                    if ((_e772 & 2u) != 0u) {
                                        phi_1046_ = (((_e772 & 4u) != 0u) == _e238);
                                    } else {
                                        phi_1046_ = true;
                                    }
                                    let _e800 = phi_1046_;
                                    phi_1047_ = _e800;
                                } else {
                                    phi_1047_ = false;
                                }
                                let _e802 = phi_1047_;
                                phi_1048_ = _e802;
                            } else {
                                phi_1048_ = false;
                            }
                            let _e804 = phi_1048_;
                            phi_874_ = (_e672 + 1u);
                            phi_877_ = lt_mask_Neighbourhood(_e790, _e804);
                        } else {
                            phi_874_ = u32();
                            phi_877_ = lt_mask_Neighbourhood();
                        }
                        let _e808 = phi_874_;
                        let _e810 = phi_877_;
                        continue;
                        continuing {
                            phi_873_ = _e808;
                            phi_876_ = _e810;
                            break if !(_e686);
                        }
                    }
                    let _e981 = local_1;
                    phi_1051_ = _e981;
                } else {
                    phi_1051_ = _e661;
                }
                let _e813 = phi_1051_;
                phi_1052_ = _e813;
            } else {
                phi_1052_ = _e661;
            }
            let _e815 = phi_1052_;
            if (_e80 != 0.5f) {
                if _e628 {
                    if _e242 {
                        phi_1078_ = true;
                    } else {
                        if _e815.any_expands {
                            phi_1077_ = false;
                        } else {
                            phi_1077_ = true;
                        }
                        let _e820 = phi_1077_;
                        phi_1078_ = _e820;
                    }
                    let _e822 = phi_1078_;
                    if _e822 {
                        if _e242 {
                            if _e660 {
                                if _e815.all_remove {
                                    phi_1091_ = false;
                                } else {
                                    phi_1091_ = true;
                                }
                                let _e824 = phi_1091_;
                                phi_1092_ = _e824;
                            } else {
                                phi_1092_ = true;
                            }
                            let _e826 = phi_1092_;
                            phi_1093_ = _e826;
                        } else {
                            phi_1093_ = true;
                        }
                        let _e828 = phi_1093_;
                        if _e828 {
                            if _e242 {
                                phi_1100_ = 1u;
                            } else {
                                phi_1100_ = 0u;
                            }
                            let _e830 = phi_1100_;
                            phi_1101_ = _e830;
                        } else {
                            phi_1101_ = 5u;
                        }
                        let _e832 = phi_1101_;
                        phi_1102_ = _e832;
                    } else {
                        phi_1102_ = 4u;
                    }
                    let _e834 = phi_1102_;
                    phi_1103_ = _e834;
                } else {
                    phi_1103_ = 3u;
                }
                let _e836 = phi_1103_;
                phi_1104_ = _e836;
            } else {
                phi_1104_ = 2u;
            }
            let _e838 = phi_1104_;
            if !((_e838 == 0u)) {
                phi_1112_ = !((_e838 == 5u));
            } else {
                phi_1112_ = false;
            }
            let _e844 = phi_1112_;
            if _e844 {
                if _e238 {
                    phi_1120_ = (2u | 1u);
                } else {
                    phi_1120_ = 2u;
                }
                let _e847 = phi_1120_;
                if false {
                    phi_1125_ = (_e847 | 4u);
                } else {
                    phi_1125_ = _e847;
                }
                let _e850 = phi_1125_;
                phi_1130_ = _e850;
            } else {
                if _e238 {
                    phi_1129_ = 1u;
                } else {
                    phi_1129_ = 0u;
                }
                let _e852 = phi_1129_;
                phi_1130_ = _e852;
            }
            let _e854 = phi_1130_;
            if _e238 {
                phi_1134_ = 0f;
            } else {
                phi_1134_ = 1f;
            }
            let _e856 = phi_1134_;
            phi_1136_ = mask_Masked(_e856, _e854, _e844);
        }
        let _e859 = phi_1136_;
        visibility.member[_e67.first_primitive] = _e859.visibility;
        bits.member[_e67.first_primitive] = _e859.bits;
        phi_1142_ = _e859.needs_ray;
        phi_1143_ = _e67.first_primitive;
    } else {
        phi_1142_ = false;
        phi_1143_ = 0u;
    }
    let _e866 = phi_1142_;
    let _e868 = phi_1143_;
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e866 {
        let _e872 = atomicAdd((&shared_[0u]), 1u);
        phi_1154_ = _e872;
    } else {
        phi_1154_ = 0u;
    }
    let _e874 = phi_1154_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e878 = atomicLoad((&shared_[0u]));
        let _e879 = atomicAdd((&list.member[3u]), _e878);
        atomicStore((&shared_[1u]), _e879);
    }
    workgroupBarrier();
    if _e866 {
        let _e882 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e882) + _e874)]), _e868);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
