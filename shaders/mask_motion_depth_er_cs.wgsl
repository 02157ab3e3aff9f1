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
        let _e66 = phi_162_;
        let _e68 = phi_163_;
        phi_164_ = _e66;
        phi_165_ = _e68;
    } else {
        phi_164_ = lt_bvh_traverse_Tree();
        phi_165_ = true;
    }
    let _e70 = phi_164_;
    let _e72 = phi_165_;
    if _e72 {
        phi_170_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_170_ = _e70;
    }
    let _e77 = phi_170_;
    return lt_bvh_traverse_Tree(_e77.root, _e77.first_primitive);
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
    let _e62 = phi_188_;
    return vec2<i32>(_e62.x, _e62.y);
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
    let _e62 = phi_206_;
    return vec2<i32>(_e62.x, _e62.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_225_: vec2<i32>;

    if (param_6 == 0u) {
        let _e56 = lt_mask_pattern_plus(param_5);
        phi_225_ = vec2<i32>(_e56.x, _e56.y);
    } else {
        let _e60 = lt_mask_pattern_cross(param_5);
        phi_225_ = vec2<i32>(_e60.x, _e60.y);
    }
    let _e65 = phi_225_;
    return vec2<i32>(_e65.x, _e65.y);
}

fn lt_mask_pattern_step_clamped(param_7: u32, param_8: i32, param_9: u32) -> u32 {
    var phi_246_: u32;
    var phi_247_: u32;

    let _e57 = (bitcast<i32>(param_7) + param_8);
    if (_e57 < 0i) {
        phi_247_ = 0u;
    } else {
        if (_e57 >= bitcast<i32>(param_9)) {
            phi_246_ = (param_9 - 1u);
        } else {
            phi_246_ = bitcast<u32>(_e57);
        }
        let _e64 = phi_246_;
        phi_247_ = _e64;
    }
    let _e66 = phi_247_;
    return _e66;
}

fn function_() {
    var phi_313_: bool;
    var phi_314_: bool;
    var phi_315_: bool;
    var phi_316_: bool;
    var phi_320_: bool;
    var phi_364_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_368_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_381_: bool;
    var phi_570_: f32;
    var phi_575_: f32;
    var phi_576_: bool;
    var phi_577_: f32;
    var phi_578_: bool;
    var phi_582_: f32;
    var phi_605_: f32;
    var phi_610_: f32;
    var phi_611_: bool;
    var phi_612_: f32;
    var phi_613_: bool;
    var phi_617_: f32;
    var phi_638_: bool;
    var phi_657_: vec2<u32>;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_661_: vec2<u32>;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_667_: bool;
    var phi_668_: vec2<u32>;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_674_: bool;
    var phi_675_: vec2<u32>;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_678_: bool;
    var phi_679_: bool;
    var phi_688_: bool;
    var phi_689_: bool;
    var phi_690_: bool;
    var phi_691_: bool;
    var phi_695_: bool;
    var phi_696_: bool;
    var phi_697_: vec2<u32>;
    var phi_786_: bool;
    var phi_790_: f32;
    var phi_794_: lt_mask_Reprojection;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_806_: bool;
    var phi_807_: lt_mask_Reprojection;
    var phi_808_: lt_mask_Reprojection;
    var phi_809_: bool;
    var phi_813_: bool;
    var phi_814_: lt_mask_Reprojection;
    var phi_842_: u32;
    var phi_844_: u32;
    var phi_847_: lt_mask_Neighbourhood;
    var phi_859_: bool;
    var phi_860_: bool;
    var phi_868_: u32;
    var phi_869_: u32;
    var phi_928_: vec2<i32>;
    var phi_944_: vec2<i32>;
    var phi_967_: u32;
    var phi_984_: bool;
    var phi_985_: bool;
    var phi_992_: bool;
    var phi_993_: bool;
    var phi_1011_: bool;
    var phi_1012_: bool;
    var phi_1013_: bool;
    var phi_845_: u32;
    var phi_848_: lt_mask_Neighbourhood;
    var phi_1016_: lt_mask_Neighbourhood;
    var phi_1017_: lt_mask_Neighbourhood;
    var phi_1018_: lt_mask_Neighbourhood;
    var phi_1043_: bool;
    var phi_1044_: bool;
    var phi_1057_: bool;
    var phi_1058_: bool;
    var phi_1059_: bool;
    var phi_1066_: u32;
    var phi_1067_: u32;
    var phi_1068_: u32;
    var phi_1069_: u32;
    var phi_1070_: u32;
    var phi_1078_: bool;
    var phi_1086_: u32;
    var phi_1091_: u32;
    var phi_1095_: u32;
    var phi_1096_: u32;
    var phi_1100_: f32;
    var phi_1102_: mask_Masked;
    var phi_1130_: bool;
    var phi_1131_: bool;
    var phi_1132_: bool;
    var phi_1133_: bool;
    var phi_1137_: bool;
    var phi_1165_: f32;
    var phi_1168_: bool;
    var phi_1169_: u32;
    var phi_1180_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e53 = id_1;
    let _e54 = local_2;
    let _e70 = p.member.current.size[0u];
    let _e72 = p.member.current.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e53, _e70, _e72);
    if (bitcast<i32>(_e73.root) != 0i) {
        let _e81 = p.member.current.size[0u];
        let _e84 = samples.member[_e73.first_primitive].position;
        let _e86 = visibility.member[_e73.first_primitive];
        let _e90 = p.member.light;
        let _e93 = samples.member[_e73.first_primitive].normal[0u];
        let _e95 = global[0u];
        if (_e93 == _e95) {
            let _e98 = samples.member[_e73.first_primitive].normal[1u];
            let _e100 = global[1u];
            if (_e98 == _e100) {
                let _e103 = samples.member[_e73.first_primitive].normal[2u];
                let _e105 = global[2u];
                phi_313_ = (_e103 == _e105);
                phi_314_ = false;
            } else {
                phi_313_ = bool();
                phi_314_ = true;
            }
            let _e108 = phi_313_;
            let _e110 = phi_314_;
            phi_315_ = _e108;
            phi_316_ = _e110;
        } else {
            phi_315_ = bool();
            phi_316_ = true;
        }
        let _e112 = phi_315_;
        let _e114 = phi_316_;
        if _e114 {
            phi_320_ = false;
        } else {
            phi_320_ = _e112;
        }
        let _e116 = phi_320_;
        if !(_e116) {
            let _e119 = samples.member[_e73.first_primitive].normal;
            let _e121 = samples.member[_e73.first_primitive].position;
            if ((((_e119.x * (_e90.x - (_e121.x * _e90.w))) + (_e119.y * (_e90.y - (_e121.y * _e90.w)))) + (_e119.z * (_e90.z - (_e121.z * _e90.w)))) > 0f) {
                let _e145 = samples.member[_e73.first_primitive].flags;
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e153.unnamed.visibility, false), _e153.unnamed_1);
                phi_364_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e159.unnamed, ((_e145 & 1u) == 0u));
            } else {
                let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                phi_364_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
            }
            let _e179 = phi_364_;
            phi_368_ = _e179;
        } else {
            let _e185 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e185.unnamed.visibility, false), _e185.unnamed_1);
            phi_368_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e191.unnamed, true);
        }
        let _e196 = phi_368_;
        if _e196.unnamed_1 {
            phi_1102_ = mask_Masked(_e196.unnamed.visibility, 0u, false);
        } else {
            let _e201 = (_e86 < 0.5f);
            if (_e86 > 0f) {
                phi_381_ = (_e86 < 1f);
            } else {
                phi_381_ = false;
            }
            let _e205 = phi_381_;
            let _e207 = samples.member[_e73.first_primitive].position;
            let _e211 = p.member.previous.eye;
            let _e214 = (_e84.x - _e211.x);
            let _e217 = (_e84.y - _e211.y);
            let _e220 = (_e84.z - _e211.z);
            let _e222 = p.member.previous.forward;
            let _e230 = (((_e214 * _e222.x) + (_e217 * _e222.y)) + (_e220 * _e222.z));
            let _e232 = p.member.previous.right;
            let _e242 = p.member.previous.right;
            let _e257 = p.member.previous.up;
            let _e267 = p.member.previous.up;
            let _e282 = p.member.current.eye;
            let _e285 = (_e207.x - _e282.x);
            let _e288 = (_e207.y - _e282.y);
            let _e291 = (_e207.z - _e282.z);
            let _e293 = p.member.current.forward;
            let _e301 = (((_e285 * _e293.x) + (_e288 * _e293.y)) + (_e291 * _e293.z));
            let _e303 = p.member.current.right;
            let _e313 = p.member.current.right;
            let _e328 = p.member.current.up;
            let _e338 = p.member.current.up;
            let _e357 = p.member.current.size[0u];
            let _e359 = (((((((_e214 * _e232.x) + (_e217 * _e232.y)) + (_e220 * _e232.z)) / ((((_e242.x * _e242.x) + (_e242.y * _e242.y)) + (_e242.z * _e242.z)) * _e230)) - ((((_e285 * _e303.x) + (_e288 * _e303.y)) + (_e291 * _e303.z)) / ((((_e313.x * _e313.x) + (_e313.y * _e313.y)) + (_e313.z * _e313.z)) * _e301))) * 0.5f) * f32(_e357));
            let _e363 = p.member.current.size[1u];
            let _e365 = (((((((_e214 * _e257.x) + (_e217 * _e257.y)) + (_e220 * _e257.z)) / ((((_e267.x * _e267.x) + (_e267.y * _e267.y)) + (_e267.z * _e267.z)) * _e230)) - ((((_e285 * _e328.x) + (_e288 * _e328.y)) + (_e291 * _e328.z)) / ((((_e338.x * _e338.x) + (_e338.y * _e338.y)) + (_e338.z * _e338.z)) * _e301))) * -0.5f) * f32(_e363));
            let _e369 = p.member.current.size[0u];
            let _e371 = p.member.current.size[1u];
            let _e375 = ((f32(_e53.x) + 0.5f) + _e359);
            if (_e375 > -8388608f) {
                let _e387 = f32(select(0i, select(select(i32(_e375), i32(-2147483648), (_e375 < bitcast<f32>(3472883712u))), 2147483647i, (_e375 > bitcast<f32>(1325400063u))), (_e375 == _e375)));
                if (_e387 > _e375) {
                    phi_570_ = 1f;
                } else {
                    phi_570_ = 0f;
                }
                let _e390 = phi_570_;
                if (_e375 < 8388608f) {
                    phi_575_ = (_e387 - _e390);
                    phi_576_ = false;
                } else {
                    phi_575_ = f32();
                    phi_576_ = true;
                }
                let _e393 = phi_575_;
                let _e395 = phi_576_;
                phi_577_ = _e393;
                phi_578_ = _e395;
            } else {
                phi_577_ = f32();
                phi_578_ = true;
            }
            let _e397 = phi_577_;
            let _e399 = phi_578_;
            if _e399 {
                phi_582_ = _e375;
            } else {
                phi_582_ = _e397;
            }
            let _e401 = phi_582_;
            let _e404 = ((f32(_e53.y) + 0.5f) + _e365);
            if (_e404 > -8388608f) {
                let _e416 = f32(select(0i, select(select(i32(_e404), i32(-2147483648), (_e404 < bitcast<f32>(3472883712u))), 2147483647i, (_e404 > bitcast<f32>(1325400063u))), (_e404 == _e404)));
                if (_e416 > _e404) {
                    phi_605_ = 1f;
                } else {
                    phi_605_ = 0f;
                }
                let _e419 = phi_605_;
                if (_e404 < 8388608f) {
                    phi_610_ = (_e416 - _e419);
                    phi_611_ = false;
                } else {
                    phi_610_ = f32();
                    phi_611_ = true;
                }
                let _e422 = phi_610_;
                let _e424 = phi_611_;
                phi_612_ = _e422;
                phi_613_ = _e424;
            } else {
                phi_612_ = f32();
                phi_613_ = true;
            }
            let _e426 = phi_612_;
            let _e428 = phi_613_;
            if _e428 {
                phi_617_ = _e404;
            } else {
                phi_617_ = _e426;
            }
            let _e430 = phi_617_;
            if (_e401 >= 0f) {
                if (_e430 >= 0f) {
                    if (_e401 < f32(_e369)) {
                        let _e436 = (_e430 < f32(_e371));
                        if (_e359 == 0f) {
                            phi_638_ = (_e365 == 0f);
                        } else {
                            phi_638_ = false;
                        }
                        let _e440 = phi_638_;
                        if _e436 {
                            phi_657_ = vec2<u32>(select(select(u32(_e401), 0u, (_e401 < bitcast<f32>(0u))), 4294967295u, (_e401 > bitcast<f32>(1333788671u))), select(select(u32(_e430), 0u, (_e430 < bitcast<f32>(0u))), 4294967295u, (_e430 > bitcast<f32>(1333788671u))));
                            phi_658_ = false;
                        } else {
                            phi_657_ = vec2<u32>();
                            phi_658_ = true;
                        }
                        let _e457 = phi_657_;
                        let _e459 = phi_658_;
                        phi_659_ = _e440;
                        phi_660_ = _e436;
                        phi_661_ = _e457;
                        phi_662_ = _e440;
                        phi_663_ = _e436;
                        phi_664_ = false;
                        phi_665_ = _e459;
                    } else {
                        phi_659_ = bool();
                        phi_660_ = bool();
                        phi_661_ = vec2<u32>();
                        phi_662_ = bool();
                        phi_663_ = bool();
                        phi_664_ = true;
                        phi_665_ = false;
                    }
                    let _e461 = phi_659_;
                    let _e463 = phi_660_;
                    let _e465 = phi_661_;
                    let _e467 = phi_662_;
                    let _e469 = phi_663_;
                    let _e471 = phi_664_;
                    let _e473 = phi_665_;
                    phi_666_ = _e461;
                    phi_667_ = _e463;
                    phi_668_ = _e465;
                    phi_669_ = _e467;
                    phi_670_ = _e469;
                    phi_671_ = _e471;
                    phi_672_ = _e473;
                } else {
                    phi_666_ = bool();
                    phi_667_ = bool();
                    phi_668_ = vec2<u32>();
                    phi_669_ = bool();
                    phi_670_ = bool();
                    phi_671_ = true;
                    phi_672_ = false;
                }
                let _e475 = phi_666_;
                let _e477 = phi_667_;
                let _e479 = phi_668_;
                let _e481 = phi_669_;
                let _e483 = phi_670_;
                let _e485 = phi_671_;
                let _e487 = phi_672_;
                phi_673_ = _e475;
                phi_674_ = _e477;
                phi_675_ = _e479;
                phi_676_ = _e481;
                phi_677_ = _e483;
                phi_678_ = _e485;
                phi_679_ = _e487;
            } else {
                phi_673_ = bool();
                phi_674_ = bool();
                phi_675_ = vec2<u32>();
                phi_676_ = bool();
                phi_677_ = bool();
                phi_678_ = true;
                phi_679_ = false;
            }
            let _e489 = phi_673_;
            let _e491 = phi_674_;
            let _e493 = phi_675_;
            let _e495 = phi_676_;
            let _e497 = phi_677_;
            let _e499 = phi_678_;
            let _e501 = phi_679_;
            if _e499 {
                if (_e359 == 0f) {
                    phi_688_ = (_e365 == 0f);
                } else {
                    phi_688_ = false;
                }
                let _e505 = phi_688_;
                phi_689_ = _e505;
                phi_690_ = false;
                phi_691_ = true;
            } else {
                phi_689_ = _e495;
                phi_690_ = _e497;
                phi_691_ = _e501;
            }
            let _e507 = phi_689_;
            let _e509 = phi_690_;
            let _e511 = phi_691_;
            if _e511 {
                phi_695_ = _e507;
                phi_696_ = _e509;
                phi_697_ = vec2<u32>(_e53.x, _e53.y);
            } else {
                phi_695_ = _e489;
                phi_696_ = _e491;
                phi_697_ = _e493;
            }
            let _e513 = phi_695_;
            let _e515 = phi_696_;
            let _e517 = phi_697_;
            let _e527 = lt_mask_Reprojection(vec2<u32>(_e517.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e534 = lt_mask_Reprojection(vec2<u32>(_e527.pixel.x, _e517.y), _e527.is_valid, _e527.has_moved);
            let _e538 = lt_mask_Reprojection(_e534.pixel, _e515, _e534.has_moved);
            let _e542 = lt_mask_Reprojection(_e538.pixel, _e538.is_valid, !(_e513));
            if _e515 {
                let _e545 = p.member.previous.eye;
                let _e556 = p.member.previous.forward;
                let _e565 = (((((_e84.x - _e545.x) * _e556.x) + ((_e84.y - _e545.y) * _e556.y)) + ((_e84.z - _e545.z) * _e556.z)) > 0f);
                let _e569 = lt_mask_Reprojection(_e542.pixel, _e565, _e542.has_moved);
                if _e565 {
                    let _e572 = p.member.previous.eye;
                    let _e583 = p.member.previous.forward;
                    let _e591 = ((((_e84.x - _e572.x) * _e583.x) + ((_e84.y - _e572.y) * _e583.y)) + ((_e84.z - _e572.z) * _e583.z));
                    let _e593 = ((_e517.y * _e81) + _e517.x);
                    if (_e593 < arrayLength((&last_depths.member))) {
                    } else {
                        return;
                    }
                    let _e597 = last_depths.member[(0u + _e593)];
                    let _e599 = p.member.depth_tolerance;
                    let _e602 = abs(_e591);
                    let _e603 = abs(_e597);
                    if ((bitcast<u32>(_e603) & 2147483647u) > 2139095040u) {
                        phi_786_ = true;
                    } else {
                        let _e607 = (_e603 > _e602);
                        if _e607 {
                        }
                        phi_786_ = _e607;
                    }
                    let _e609 = phi_786_;
                    if _e609 {
                        phi_790_ = _e603;
                    } else {
                        phi_790_ = _e602;
                    }
                    let _e611 = phi_790_;
                    phi_794_ = lt_mask_Reprojection(_e569.pixel, (abs((_e591 - _e597)) <= (_e599 * _e611)), _e569.has_moved);
                } else {
                    phi_794_ = _e569;
                }
                let _e619 = phi_794_;
                if _e619.is_valid {
                    let _e622 = p.member.flags;
                    phi_803_ = ((_e622 & 1u) != 0u);
                    phi_804_ = false;
                } else {
                    phi_803_ = bool();
                    phi_804_ = true;
                }
                let _e626 = phi_803_;
                let _e628 = phi_804_;
                phi_806_ = _e626;
                phi_807_ = _e619;
                phi_808_ = _e619;
                phi_809_ = _e628;
            } else {
                phi_806_ = bool();
                phi_807_ = lt_mask_Reprojection();
                phi_808_ = lt_mask_Reprojection(_e542.pixel, false, _e542.has_moved);
                phi_809_ = true;
            }
            let _e634 = phi_806_;
            let _e636 = phi_807_;
            let _e638 = phi_808_;
            let _e640 = phi_809_;
            if _e640 {
                phi_813_ = false;
                phi_814_ = _e638;
            } else {
                phi_813_ = _e634;
                phi_814_ = _e636;
            }
            let _e642 = phi_813_;
            let _e644 = phi_814_;
            let _e648 = lt_mask_Reprojection(_e644.pixel, _e642, _e644.has_moved);
            if _e648.has_moved {
            }
            let _e654 = lt_mask_Neighbourhood(false, true);
            if _e205 {
                phi_1018_ = _e654;
            } else {
                if true {
                    if _e642 {
                        if _e648.has_moved {
                            let _e657 = p.member.moving_pattern;
                            phi_842_ = _e657;
                        } else {
                            let _e659 = p.member.still_pattern;
                            phi_842_ = _e659;
                        }
                        let _e661 = phi_842_;
                        phi_844_ = 0u;
                        phi_847_ = _e654;
                        loop {
                            let _e663 = phi_844_;
                            let _e665 = phi_847_;
                            local_1 = _e665;
                            if (1u <= _e661) {
                                if (_e661 <= 4u) {
                                    phi_859_ = false;
                                } else {
                                    phi_859_ = true;
                                }
                                let _e669 = phi_859_;
                                phi_860_ = _e669;
                            } else {
                                phi_860_ = true;
                            }
                            let _e671 = phi_860_;
                            if _e671 {
                                switch bitcast<i32>(_e661) {
                                    case 5: {
                                        phi_868_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_868_ = 25u;
                                        break;
                                    }
                                    default: {
                                        phi_868_ = 9u;
                                        break;
                                    }
                                }
                                let _e674 = phi_868_;
                                phi_869_ = _e674;
                            } else {
                                phi_869_ = 5u;
                            }
                            let _e676 = phi_869_;
                            let _e677 = (_e663 < _e676);
                            if _e677 {
                                let _e683 = p.member.frame;
                                let _e687 = p.member.current.size[0u];
                                let _e689 = p.member.current.size[1u];
                                switch bitcast<i32>(_e661) {
                                    case 1: {
                                        let _e699 = lt_mask_pattern_plus(_e663);
                                        phi_944_ = vec2<i32>(_e699.x, _e699.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e703 = lt_mask_pattern_cross(_e663);
                                        phi_944_ = vec2<i32>(_e703.x, _e703.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e709 = lt_mask_pattern_plus_or_cross(_e663, ((_e648.pixel.x + _e648.pixel.y) & 1u));
                                        phi_944_ = vec2<i32>(_e709.x, _e709.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e714 = lt_mask_pattern_plus_or_cross(_e663, (_e683 & 1u));
                                        phi_944_ = vec2<i32>(_e714.x, _e714.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e683 & 3u)) {
                                            case 0: {
                                                phi_928_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_928_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_928_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_928_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e725 = phi_928_;
                                        phi_944_ = (_e725 + vec2<i32>(bitcast<i32>((_e663 & 1u)), bitcast<i32>(((_e663 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_944_ = vec2<i32>((bitcast<i32>((_e663 % 5u)) - 2i), (bitcast<i32>(((_e663 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    default: {
                                        phi_944_ = vec2<i32>((bitcast<i32>((_e663 % 3u)) - 1i), (bitcast<i32>(((_e663 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e743 = phi_944_;
                                let _e746 = lt_mask_pattern_step_clamped(_e648.pixel.x, _e743.x, _e687);
                                let _e747 = lt_mask_pattern_step_clamped(_e648.pixel.y, _e743.y, _e689);
                                let _e749 = ((_e747 * _e81) + _e746);
                                if (_e749 < arrayLength((&last_bits.member))) {
                                } else {
                                    return;
                                }
                                let _e753 = last_bits.member[(0u + _e749)];
                                if ((_e753 & 2u) == 0u) {
                                    phi_967_ = (_e753 & 1u);
                                } else {
                                    phi_967_ = (_e753 & 7u);
                                }
                                let _e759 = phi_967_;
                                if _e665.any_expands {
                                    phi_993_ = true;
                                } else {
                                    if ((_e759 & 2u) != 0u) {
                                        if (((_e759 & 4u) != 0u) != _e201) {
                                            phi_984_ = false;
                                        } else {
                                            phi_984_ = true;
                                        }
                                        let _e768 = phi_984_;
                                        phi_985_ = _e768;
                                    } else {
                                        phi_985_ = true;
                                    }
                                    let _e770 = phi_985_;
                                    if _e770 {
                                        phi_992_ = (((_e759 & 1u) != 0u) != _e201);
                                    } else {
                                        phi_992_ = true;
                                    }
                                    let _e775 = phi_992_;
                                    phi_993_ = _e775;
                                }
                                let _e777 = phi_993_;
                                if _e665.all_remove {
                                    if (((_e759 & 1u) != 0u) == _e201) {
                                        if ((_e759 & 2u) != 0u) {
                                            phi_1011_ = (((_e759 & 4u) != 0u) == _e201);
                                        } else {
                                            phi_1011_ = true;
                                        }
                                        let _e787 = phi_1011_;
                                        phi_1012_ = _e787;
                                    } else {
                                        phi_1012_ = false;
                                    }
                                    let _e789 = phi_1012_;
                                    phi_1013_ = _e789;
                                } else {
                                    phi_1013_ = false;
                                }
                                let _e791 = phi_1013_;
                                phi_845_ = (_e663 + 1u);
                                phi_848_ = lt_mask_Neighbourhood(_e777, _e791);
                            } else {
                                phi_845_ = u32();
                                phi_848_ = lt_mask_Neighbourhood();
                            }
                            let _e795 = phi_845_;
                            let _e797 = phi_848_;
                            continue;
                            continuing {
                                phi_844_ = _e795;
                                phi_847_ = _e797;
                                break if !(_e677);
                            }
                        }
                        let _e1012 = local_1;
                        phi_1016_ = _e1012;
                    } else {
                        phi_1016_ = _e654;
                    }
                    let _e800 = phi_1016_;
                    phi_1017_ = _e800;
                } else {
                    phi_1017_ = _e654;
                }
                let _e802 = phi_1017_;
                phi_1018_ = _e802;
            }
            let _e804 = phi_1018_;
            if (_e86 != 0.5f) {
                if _e642 {
                    if _e205 {
                        phi_1044_ = true;
                    } else {
                        if _e804.any_expands {
                            phi_1043_ = false;
                        } else {
                            phi_1043_ = true;
                        }
                        let _e809 = phi_1043_;
                        phi_1044_ = _e809;
                    }
                    let _e811 = phi_1044_;
                    if _e811 {
                        if _e205 {
                            if false {
                                if _e804.all_remove {
                                    phi_1057_ = false;
                                } else {
                                    phi_1057_ = true;
                                }
                                let _e813 = phi_1057_;
                                phi_1058_ = _e813;
                            } else {
                                phi_1058_ = true;
                            }
                            let _e815 = phi_1058_;
                            phi_1059_ = _e815;
                        } else {
                            phi_1059_ = true;
                        }
                        let _e817 = phi_1059_;
                        if _e817 {
                            if _e205 {
                                phi_1066_ = 1u;
                            } else {
                                phi_1066_ = 0u;
                            }
                            let _e819 = phi_1066_;
                            phi_1067_ = _e819;
                        } else {
                            phi_1067_ = 5u;
                        }
                        let _e821 = phi_1067_;
                        phi_1068_ = _e821;
                    } else {
                        phi_1068_ = 4u;
                    }
                    let _e823 = phi_1068_;
                    phi_1069_ = _e823;
                } else {
                    phi_1069_ = 3u;
                }
                let _e825 = phi_1069_;
                phi_1070_ = _e825;
            } else {
                phi_1070_ = 2u;
            }
            let _e827 = phi_1070_;
            if !((_e827 == 0u)) {
                phi_1078_ = !((_e827 == 5u));
            } else {
                phi_1078_ = false;
            }
            let _e833 = phi_1078_;
            if _e833 {
                if _e201 {
                    phi_1086_ = (2u | 1u);
                } else {
                    phi_1086_ = 2u;
                }
                let _e836 = phi_1086_;
                if false {
                    phi_1091_ = (_e836 | 4u);
                } else {
                    phi_1091_ = _e836;
                }
                let _e839 = phi_1091_;
                phi_1096_ = _e839;
            } else {
                if _e201 {
                    phi_1095_ = 1u;
                } else {
                    phi_1095_ = 0u;
                }
                let _e841 = phi_1095_;
                phi_1096_ = _e841;
            }
            let _e843 = phi_1096_;
            if _e201 {
                phi_1100_ = 0f;
            } else {
                phi_1100_ = 1f;
            }
            let _e845 = phi_1100_;
            phi_1102_ = mask_Masked(_e845, _e843, _e833);
        }
        let _e848 = phi_1102_;
        visibility.member[_e73.first_primitive] = _e848.visibility;
        bits.member[_e73.first_primitive] = _e848.bits;
        let _e856 = samples.member[_e73.first_primitive].normal[0u];
        let _e858 = global[0u];
        if (_e856 == _e858) {
            let _e861 = samples.member[_e73.first_primitive].normal[1u];
            let _e863 = global[1u];
            if (_e861 == _e863) {
                let _e866 = samples.member[_e73.first_primitive].normal[2u];
                let _e868 = global[2u];
                phi_1130_ = (_e866 == _e868);
                phi_1131_ = false;
            } else {
                phi_1130_ = bool();
                phi_1131_ = true;
            }
            let _e871 = phi_1130_;
            let _e873 = phi_1131_;
            phi_1132_ = _e871;
            phi_1133_ = _e873;
        } else {
            phi_1132_ = bool();
            phi_1133_ = true;
        }
        let _e875 = phi_1132_;
        let _e877 = phi_1133_;
        if _e877 {
            phi_1137_ = false;
        } else {
            phi_1137_ = _e875;
        }
        let _e879 = phi_1137_;
        if !(_e879) {
            let _e882 = samples.member[_e73.first_primitive].position;
            let _e884 = p.member.current.eye;
            let _e895 = p.member.current.forward;
            phi_1165_ = ((((_e882.x - _e884.x) * _e895.x) + ((_e882.y - _e884.y) * _e895.y)) + ((_e882.z - _e884.z) * _e895.z));
        } else {
            phi_1165_ = 0f;
        }
        let _e905 = phi_1165_;
        depths.member[_e73.first_primitive] = _e905;
        phi_1168_ = _e848.needs_ray;
        phi_1169_ = _e73.first_primitive;
    } else {
        phi_1168_ = false;
        phi_1169_ = 0u;
    }
    let _e909 = phi_1168_;
    let _e911 = phi_1169_;
    if (_e54 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e909 {
        let _e915 = atomicAdd((&shared_[0u]), 1u);
        phi_1180_ = _e915;
    } else {
        phi_1180_ = 0u;
    }
    let _e917 = phi_1180_;
    workgroupBarrier();
    if (_e54 == 0u) {
        let _e921 = atomicLoad((&shared_[0u]));
        let _e922 = atomicAdd((&list.member[3u]), _e921);
        atomicStore((&shared_[1u]), _e922);
    }
    workgroupBarrier();
    if _e909 {
        let _e925 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e925) + _e917)]), _e911);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
