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
    var phi_828_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_842_: bool;
    var phi_843_: bool;
    var phi_844_: bool;
    var phi_848_: bool;
    var phi_853_: bool;
    var phi_868_: u32;
    var phi_870_: u32;
    var phi_873_: lt_mask_Neighbourhood;
    var phi_885_: bool;
    var phi_886_: bool;
    var phi_894_: u32;
    var phi_895_: u32;
    var phi_954_: vec2<i32>;
    var phi_970_: vec2<i32>;
    var phi_993_: u32;
    var phi_1010_: bool;
    var phi_1011_: bool;
    var phi_1018_: bool;
    var phi_1019_: bool;
    var phi_1037_: bool;
    var phi_1038_: bool;
    var phi_1039_: bool;
    var phi_871_: u32;
    var phi_874_: lt_mask_Neighbourhood;
    var phi_1042_: lt_mask_Neighbourhood;
    var phi_1043_: lt_mask_Neighbourhood;
    var phi_1068_: bool;
    var phi_1069_: bool;
    var phi_1082_: bool;
    var phi_1083_: bool;
    var phi_1084_: bool;
    var phi_1091_: u32;
    var phi_1092_: u32;
    var phi_1093_: u32;
    var phi_1094_: u32;
    var phi_1095_: u32;
    var phi_1103_: bool;
    var phi_1111_: u32;
    var phi_1116_: u32;
    var phi_1120_: u32;
    var phi_1121_: u32;
    var phi_1125_: f32;
    var phi_1127_: mask_Masked;
    var phi_1155_: bool;
    var phi_1156_: bool;
    var phi_1157_: bool;
    var phi_1158_: bool;
    var phi_1162_: bool;
    var phi_1190_: f32;
    var phi_1193_: bool;
    var phi_1194_: u32;
    var phi_1205_: u32;
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
            phi_1127_ = mask_Masked(_e196.unnamed.visibility, 0u, false);
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
            let _e650 = p.member.flags;
            if _e648.has_moved {
                let _e655 = p.member.flags;
                phi_828_ = ((_e655 & 4u) == 0u);
            } else {
                phi_828_ = false;
            }
            let _e659 = phi_828_;
            if ((_e650 & 2u) != 0u) {
                if false {
                    phi_841_ = bool();
                    phi_842_ = true;
                } else {
                    if true {
                        phi_839_ = !(_e659);
                        phi_840_ = false;
                    } else {
                        phi_839_ = bool();
                        phi_840_ = true;
                    }
                    let _e662 = phi_839_;
                    let _e664 = phi_840_;
                    phi_841_ = _e662;
                    phi_842_ = _e664;
                }
                let _e666 = phi_841_;
                let _e668 = phi_842_;
                phi_843_ = _e666;
                phi_844_ = _e668;
            } else {
                phi_843_ = bool();
                phi_844_ = true;
            }
            let _e670 = phi_843_;
            let _e672 = phi_844_;
            if _e672 {
                phi_848_ = false;
            } else {
                phi_848_ = _e670;
            }
            let _e674 = phi_848_;
            let _e675 = lt_mask_Neighbourhood(false, true);
            if _e205 {
                phi_853_ = _e674;
            } else {
                phi_853_ = false;
            }
            let _e677 = phi_853_;
            if _e677 {
                if _e642 {
                    if _e648.has_moved {
                        let _e680 = p.member.moving_pattern;
                        phi_868_ = _e680;
                    } else {
                        let _e682 = p.member.still_pattern;
                        phi_868_ = _e682;
                    }
                    let _e684 = phi_868_;
                    phi_870_ = 0u;
                    phi_873_ = _e675;
                    loop {
                        let _e686 = phi_870_;
                        let _e688 = phi_873_;
                        local_1 = _e688;
                        if (1u <= _e684) {
                            if (_e684 <= 4u) {
                                phi_885_ = false;
                            } else {
                                phi_885_ = true;
                            }
                            let _e692 = phi_885_;
                            phi_886_ = _e692;
                        } else {
                            phi_886_ = true;
                        }
                        let _e694 = phi_886_;
                        if _e694 {
                            switch bitcast<i32>(_e684) {
                                case 5: {
                                    phi_894_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_894_ = 25u;
                                    break;
                                }
                                default: {
                                    phi_894_ = 9u;
                                    break;
                                }
                            }
                            let _e697 = phi_894_;
                            phi_895_ = _e697;
                        } else {
                            phi_895_ = 5u;
                        }
                        let _e699 = phi_895_;
                        let _e700 = (_e686 < _e699);
                        if _e700 {
                            let _e706 = p.member.frame;
                            let _e710 = p.member.current.size[0u];
                            let _e712 = p.member.current.size[1u];
                            switch bitcast<i32>(_e684) {
                                case 1: {
                                    let _e722 = lt_mask_pattern_plus(_e686);
                                    phi_970_ = vec2<i32>(_e722.x, _e722.y);
                                    break;
                                }
                                case 2: {
                                    let _e726 = lt_mask_pattern_cross(_e686);
                                    phi_970_ = vec2<i32>(_e726.x, _e726.y);
                                    break;
                                }
                                case 3: {
                                    let _e732 = lt_mask_pattern_plus_or_cross(_e686, ((_e648.pixel.x + _e648.pixel.y) & 1u));
                                    phi_970_ = vec2<i32>(_e732.x, _e732.y);
                                    break;
                                }
                                case 4: {
                                    let _e737 = lt_mask_pattern_plus_or_cross(_e686, (_e706 & 1u));
                                    phi_970_ = vec2<i32>(_e737.x, _e737.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e706 & 3u)) {
                                        case 0: {
                                            phi_954_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_954_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_954_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_954_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e748 = phi_954_;
                                    phi_970_ = (_e748 + vec2<i32>(bitcast<i32>((_e686 & 1u)), bitcast<i32>(((_e686 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_970_ = vec2<i32>((bitcast<i32>((_e686 % 5u)) - 2i), (bitcast<i32>(((_e686 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                default: {
                                    phi_970_ = vec2<i32>((bitcast<i32>((_e686 % 3u)) - 1i), (bitcast<i32>(((_e686 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e766 = phi_970_;
                            let _e769 = lt_mask_pattern_step_clamped(_e648.pixel.x, _e766.x, _e710);
                            let _e770 = lt_mask_pattern_step_clamped(_e648.pixel.y, _e766.y, _e712);
                            let _e772 = ((_e770 * _e81) + _e769);
                            if (_e772 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e776 = last_bits.member[(0u + _e772)];
                            if ((_e776 & 2u) == 0u) {
                                phi_993_ = (_e776 & 1u);
                            } else {
                                phi_993_ = (_e776 & 7u);
                            }
                            let _e782 = phi_993_;
                            if _e688.any_expands {
                                phi_1019_ = true;
                            } else {
                                if ((_e782 & 2u) != 0u) {
                                    if (((_e782 & 4u) != 0u) != _e201) {
                                        phi_1010_ = false;
                                    } else {
                                        phi_1010_ = true;
                                    }
                                    let _e791 = phi_1010_;
                                    phi_1011_ = _e791;
                                } else {
                                    phi_1011_ = true;
                                }
                                let _e793 = phi_1011_;
                                if _e793 {
                                    phi_1018_ = (((_e782 & 1u) != 0u) != _e201);
                                } else {
                                    phi_1018_ = true;
                                }
                                let _e798 = phi_1018_;
                                phi_1019_ = _e798;
                            }
                            let _e800 = phi_1019_;
                            if _e688.all_remove {
                                if (((_e782 & 1u) != 0u) == _e201) {
                                    if ((_e782 & 2u) != 0u) {
                                        phi_1037_ = (((_e782 & 4u) != 0u) == _e201);
                                    } else {
                                        phi_1037_ = true;
                                    }
                                    let _e810 = phi_1037_;
                                    phi_1038_ = _e810;
                                } else {
                                    phi_1038_ = false;
                                }
                                let _e812 = phi_1038_;
                                phi_1039_ = _e812;
                            } else {
                                phi_1039_ = false;
                            }
                            let _e814 = phi_1039_;
                            phi_871_ = (_e686 + 1u);
                            phi_874_ = lt_mask_Neighbourhood(_e800, _e814);
                        } else {
                            phi_871_ = u32();
                            phi_874_ = lt_mask_Neighbourhood();
                        }
                        let _e818 = phi_871_;
                        let _e820 = phi_874_;
                        continue;
                        continuing {
                            phi_870_ = _e818;
                            phi_873_ = _e820;
                            break if !(_e700);
                        }
                    }
                    let _e1042 = local_1;
                    phi_1042_ = _e1042;
                } else {
                    phi_1042_ = _e675;
                }
                let _e823 = phi_1042_;
                phi_1043_ = _e823;
            } else {
                phi_1043_ = _e675;
            }
            let _e825 = phi_1043_;
            if (_e86 != 0.5f) {
                if _e642 {
                    if _e205 {
                        phi_1069_ = true;
                    } else {
                        if _e825.any_expands {
                            phi_1068_ = false;
                        } else {
                            phi_1068_ = true;
                        }
                        let _e830 = phi_1068_;
                        phi_1069_ = _e830;
                    }
                    let _e832 = phi_1069_;
                    if _e832 {
                        if _e205 {
                            if _e674 {
                                if _e825.all_remove {
                                    phi_1082_ = false;
                                } else {
                                    phi_1082_ = true;
                                }
                                let _e834 = phi_1082_;
                                phi_1083_ = _e834;
                            } else {
                                phi_1083_ = true;
                            }
                            let _e836 = phi_1083_;
                            phi_1084_ = _e836;
                        } else {
                            phi_1084_ = true;
                        }
                        let _e838 = phi_1084_;
                        if _e838 {
                            if _e205 {
                                phi_1091_ = 1u;
                            } else {
                                phi_1091_ = 0u;
                            }
                            let _e840 = phi_1091_;
                            phi_1092_ = _e840;
                        } else {
                            phi_1092_ = 5u;
                        }
                        let _e842 = phi_1092_;
                        phi_1093_ = _e842;
                    } else {
                        phi_1093_ = 4u;
                    }
                    let _e844 = phi_1093_;
                    phi_1094_ = _e844;
                } else {
                    phi_1094_ = 3u;
                }
                let _e846 = phi_1094_;
                phi_1095_ = _e846;
            } else {
                phi_1095_ = 2u;
            }
            let _e848 = phi_1095_;
            if !((_e848 == 0u)) {
                phi_1103_ = !((_e848 == 5u));
            } else {
                phi_1103_ = false;
            }
            let _e854 = phi_1103_;
            if _e854 {
                if _e201 {
                    phi_1111_ = (2u | 1u);
                } else {
                    phi_1111_ = 2u;
                }
                let _e857 = phi_1111_;
                if false {
                    phi_1116_ = (_e857 | 4u);
                } else {
                    phi_1116_ = _e857;
                }
                let _e860 = phi_1116_;
                phi_1121_ = _e860;
            } else {
                if _e201 {
                    phi_1120_ = 1u;
                } else {
                    phi_1120_ = 0u;
                }
                let _e862 = phi_1120_;
                phi_1121_ = _e862;
            }
            let _e864 = phi_1121_;
            if _e201 {
                phi_1125_ = 0f;
            } else {
                phi_1125_ = 1f;
            }
            let _e866 = phi_1125_;
            phi_1127_ = mask_Masked(_e866, _e864, _e854);
        }
        let _e869 = phi_1127_;
        visibility.member[_e73.first_primitive] = _e869.visibility;
        bits.member[_e73.first_primitive] = _e869.bits;
        let _e877 = samples.member[_e73.first_primitive].normal[0u];
        let _e879 = global[0u];
        if (_e877 == _e879) {
            let _e882 = samples.member[_e73.first_primitive].normal[1u];
            let _e884 = global[1u];
            if (_e882 == _e884) {
                let _e887 = samples.member[_e73.first_primitive].normal[2u];
                let _e889 = global[2u];
                phi_1155_ = (_e887 == _e889);
                phi_1156_ = false;
            } else {
                phi_1155_ = bool();
                phi_1156_ = true;
            }
            let _e892 = phi_1155_;
            let _e894 = phi_1156_;
            phi_1157_ = _e892;
            phi_1158_ = _e894;
        } else {
            phi_1157_ = bool();
            phi_1158_ = true;
        }
        let _e896 = phi_1157_;
        let _e898 = phi_1158_;
        if _e898 {
            phi_1162_ = false;
        } else {
            phi_1162_ = _e896;
        }
        let _e900 = phi_1162_;
        if !(_e900) {
            let _e903 = samples.member[_e73.first_primitive].position;
            let _e905 = p.member.current.eye;
            let _e916 = p.member.current.forward;
            phi_1190_ = ((((_e903.x - _e905.x) * _e916.x) + ((_e903.y - _e905.y) * _e916.y)) + ((_e903.z - _e905.z) * _e916.z));
        } else {
            phi_1190_ = 0f;
        }
        let _e926 = phi_1190_;
        depths.member[_e73.first_primitive] = _e926;
        phi_1193_ = _e869.needs_ray;
        phi_1194_ = _e73.first_primitive;
    } else {
        phi_1193_ = false;
        phi_1194_ = 0u;
    }
    let _e930 = phi_1193_;
    let _e932 = phi_1194_;
    if (_e54 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e930 {
        let _e936 = atomicAdd((&shared_[0u]), 1u);
        phi_1205_ = _e936;
    } else {
        phi_1205_ = 0u;
    }
    let _e938 = phi_1205_;
    workgroupBarrier();
    if (_e54 == 0u) {
        let _e942 = atomicLoad((&shared_[0u]));
        let _e943 = atomicAdd((&list.member[3u]), _e942);
        atomicStore((&shared_[1u]), _e943);
    }
    workgroupBarrier();
    if _e930 {
        let _e946 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e946) + _e938)]), _e932);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
