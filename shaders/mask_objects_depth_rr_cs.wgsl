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
        let _e67 = phi_168_;
        let _e69 = phi_169_;
        phi_170_ = _e67;
        phi_171_ = _e69;
    } else {
        phi_170_ = lt_bvh_traverse_Tree();
        phi_171_ = true;
    }
    let _e71 = phi_170_;
    let _e73 = phi_171_;
    if _e73 {
        phi_176_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_176_ = _e71;
    }
    let _e78 = phi_176_;
    return lt_bvh_traverse_Tree(_e78.root, _e78.first_primitive);
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
    let _e63 = phi_194_;
    return vec2<i32>(_e63.x, _e63.y);
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
    let _e63 = phi_212_;
    return vec2<i32>(_e63.x, _e63.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_231_: vec2<i32>;

    if (param_6 == 0u) {
        let _e57 = lt_mask_pattern_plus(param_5);
        phi_231_ = vec2<i32>(_e57.x, _e57.y);
    } else {
        let _e61 = lt_mask_pattern_cross(param_5);
        phi_231_ = vec2<i32>(_e61.x, _e61.y);
    }
    let _e66 = phi_231_;
    return vec2<i32>(_e66.x, _e66.y);
}

fn lt_mask_pattern_step_clamped(param_7: u32, param_8: i32, param_9: u32) -> u32 {
    var phi_252_: u32;
    var phi_253_: u32;

    let _e58 = (bitcast<i32>(param_7) + param_8);
    if (_e58 < 0i) {
        phi_253_ = 0u;
    } else {
        if (_e58 >= bitcast<i32>(param_9)) {
            phi_252_ = (param_9 - 1u);
        } else {
            phi_252_ = bitcast<u32>(_e58);
        }
        let _e65 = phi_252_;
        phi_253_ = _e65;
    }
    let _e67 = phi_253_;
    return _e67;
}

fn function_() {
    var phi_323_: bool;
    var phi_324_: bool;
    var phi_325_: bool;
    var phi_326_: bool;
    var phi_330_: bool;
    var phi_374_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_378_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_391_: bool;
    var phi_577_: f32;
    var phi_582_: f32;
    var phi_583_: bool;
    var phi_584_: f32;
    var phi_585_: bool;
    var phi_589_: f32;
    var phi_612_: f32;
    var phi_617_: f32;
    var phi_618_: bool;
    var phi_619_: f32;
    var phi_620_: bool;
    var phi_624_: f32;
    var phi_645_: bool;
    var phi_664_: vec2<u32>;
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
    var phi_680_: bool;
    var phi_681_: bool;
    var phi_682_: vec2<u32>;
    var phi_683_: bool;
    var phi_684_: bool;
    var phi_685_: bool;
    var phi_686_: bool;
    var phi_695_: bool;
    var phi_696_: bool;
    var phi_697_: bool;
    var phi_698_: bool;
    var phi_702_: bool;
    var phi_703_: bool;
    var phi_704_: vec2<u32>;
    var phi_787_: bool;
    var phi_791_: f32;
    var phi_795_: lt_mask_Reprojection;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_807_: bool;
    var phi_808_: lt_mask_Reprojection;
    var phi_809_: lt_mask_Reprojection;
    var phi_810_: bool;
    var phi_814_: bool;
    var phi_815_: lt_mask_Reprojection;
    var phi_829_: bool;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_842_: bool;
    var phi_843_: bool;
    var phi_844_: bool;
    var phi_845_: bool;
    var phi_849_: bool;
    var phi_854_: bool;
    var phi_869_: u32;
    var phi_871_: u32;
    var phi_874_: lt_mask_Neighbourhood;
    var phi_886_: bool;
    var phi_887_: bool;
    var phi_895_: u32;
    var phi_896_: u32;
    var phi_955_: vec2<i32>;
    var phi_971_: vec2<i32>;
    var phi_994_: u32;
    var phi_1011_: bool;
    var phi_1012_: bool;
    var phi_1019_: bool;
    var phi_1020_: bool;
    var phi_1038_: bool;
    var phi_1039_: bool;
    var phi_1040_: bool;
    var phi_872_: u32;
    var phi_875_: lt_mask_Neighbourhood;
    var phi_1043_: lt_mask_Neighbourhood;
    var phi_1044_: lt_mask_Neighbourhood;
    var phi_1069_: bool;
    var phi_1070_: bool;
    var phi_1083_: bool;
    var phi_1084_: bool;
    var phi_1085_: bool;
    var phi_1092_: u32;
    var phi_1093_: u32;
    var phi_1094_: u32;
    var phi_1095_: u32;
    var phi_1096_: u32;
    var phi_1104_: bool;
    var phi_1112_: u32;
    var phi_1117_: u32;
    var phi_1121_: u32;
    var phi_1122_: u32;
    var phi_1126_: f32;
    var phi_1128_: mask_Masked;
    var phi_1156_: bool;
    var phi_1157_: bool;
    var phi_1158_: bool;
    var phi_1159_: bool;
    var phi_1163_: bool;
    var phi_1191_: f32;
    var phi_1194_: bool;
    var phi_1195_: u32;
    var phi_1206_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e54 = id_1;
    let _e55 = local_2;
    let _e72 = p.member.current.size[0u];
    let _e74 = p.member.current.size[1u];
    let _e75 = lt_shaders_entry_pixel_index(_e54, _e72, _e74);
    if (bitcast<i32>(_e75.root) != 0i) {
        let _e83 = p.member.current.size[0u];
        let _e86 = past.member[_e75.first_primitive];
        let _e91 = visibility.member[_e75.first_primitive];
        let _e95 = p.member.light;
        let _e98 = samples.member[_e75.first_primitive].normal[0u];
        let _e100 = global[0u];
        if (_e98 == _e100) {
            let _e103 = samples.member[_e75.first_primitive].normal[1u];
            let _e105 = global[1u];
            if (_e103 == _e105) {
                let _e108 = samples.member[_e75.first_primitive].normal[2u];
                let _e110 = global[2u];
                phi_323_ = (_e108 == _e110);
                phi_324_ = false;
            } else {
                phi_323_ = bool();
                phi_324_ = true;
            }
            let _e113 = phi_323_;
            let _e115 = phi_324_;
            phi_325_ = _e113;
            phi_326_ = _e115;
        } else {
            phi_325_ = bool();
            phi_326_ = true;
        }
        let _e117 = phi_325_;
        let _e119 = phi_326_;
        if _e119 {
            phi_330_ = false;
        } else {
            phi_330_ = _e117;
        }
        let _e121 = phi_330_;
        if !(_e121) {
            let _e124 = samples.member[_e75.first_primitive].normal;
            let _e126 = samples.member[_e75.first_primitive].position;
            if ((((_e124.x * (_e95.x - (_e126.x * _e95.w))) + (_e124.y * (_e95.y - (_e126.y * _e95.w)))) + (_e124.z * (_e95.z - (_e126.z * _e95.w)))) > 0f) {
                let _e150 = samples.member[_e75.first_primitive].flags;
                let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e164 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e158.unnamed.visibility, false), _e158.unnamed_1);
                phi_374_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e164.unnamed, ((_e150 & 1u) == 0u));
            } else {
                let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                phi_374_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, true);
            }
            let _e184 = phi_374_;
            phi_378_ = _e184;
        } else {
            let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e190.unnamed.visibility, false), _e190.unnamed_1);
            phi_378_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e196.unnamed, true);
        }
        let _e201 = phi_378_;
        if _e201.unnamed_1 {
            phi_1128_ = mask_Masked(_e201.unnamed.visibility, 0u, false);
        } else {
            let _e206 = (_e91 < 0.5f);
            if (_e91 > 0f) {
                phi_391_ = (_e91 < 1f);
            } else {
                phi_391_ = false;
            }
            let _e210 = phi_391_;
            let _e212 = samples.member[_e75.first_primitive].position;
            let _e216 = p.member.previous.eye;
            let _e218 = (_e86.x - _e216.x);
            let _e220 = (_e86.y - _e216.y);
            let _e222 = (_e86.z - _e216.z);
            let _e224 = p.member.previous.forward;
            let _e232 = (((_e218 * _e224.x) + (_e220 * _e224.y)) + (_e222 * _e224.z));
            let _e234 = p.member.previous.right;
            let _e244 = p.member.previous.right;
            let _e259 = p.member.previous.up;
            let _e269 = p.member.previous.up;
            let _e284 = p.member.current.eye;
            let _e287 = (_e212.x - _e284.x);
            let _e290 = (_e212.y - _e284.y);
            let _e293 = (_e212.z - _e284.z);
            let _e295 = p.member.current.forward;
            let _e303 = (((_e287 * _e295.x) + (_e290 * _e295.y)) + (_e293 * _e295.z));
            let _e305 = p.member.current.right;
            let _e315 = p.member.current.right;
            let _e330 = p.member.current.up;
            let _e340 = p.member.current.up;
            let _e359 = p.member.current.size[0u];
            let _e361 = (((((((_e218 * _e234.x) + (_e220 * _e234.y)) + (_e222 * _e234.z)) / ((((_e244.x * _e244.x) + (_e244.y * _e244.y)) + (_e244.z * _e244.z)) * _e232)) - ((((_e287 * _e305.x) + (_e290 * _e305.y)) + (_e293 * _e305.z)) / ((((_e315.x * _e315.x) + (_e315.y * _e315.y)) + (_e315.z * _e315.z)) * _e303))) * 0.5f) * f32(_e359));
            let _e365 = p.member.current.size[1u];
            let _e367 = (((((((_e218 * _e259.x) + (_e220 * _e259.y)) + (_e222 * _e259.z)) / ((((_e269.x * _e269.x) + (_e269.y * _e269.y)) + (_e269.z * _e269.z)) * _e232)) - ((((_e287 * _e330.x) + (_e290 * _e330.y)) + (_e293 * _e330.z)) / ((((_e340.x * _e340.x) + (_e340.y * _e340.y)) + (_e340.z * _e340.z)) * _e303))) * -0.5f) * f32(_e365));
            let _e371 = p.member.current.size[0u];
            let _e373 = p.member.current.size[1u];
            let _e377 = ((f32(_e54.x) + 0.5f) + _e361);
            if (_e377 > -8388608f) {
                let _e389 = f32(select(0i, select(select(i32(_e377), i32(-2147483648), (_e377 < bitcast<f32>(3472883712u))), 2147483647i, (_e377 > bitcast<f32>(1325400063u))), (_e377 == _e377)));
                if (_e389 > _e377) {
                    phi_577_ = 1f;
                } else {
                    phi_577_ = 0f;
                }
                let _e392 = phi_577_;
                if (_e377 < 8388608f) {
                    phi_582_ = (_e389 - _e392);
                    phi_583_ = false;
                } else {
                    phi_582_ = f32();
                    phi_583_ = true;
                }
                let _e395 = phi_582_;
                let _e397 = phi_583_;
                phi_584_ = _e395;
                phi_585_ = _e397;
            } else {
                phi_584_ = f32();
                phi_585_ = true;
            }
            let _e399 = phi_584_;
            let _e401 = phi_585_;
            if _e401 {
                phi_589_ = _e377;
            } else {
                phi_589_ = _e399;
            }
            let _e403 = phi_589_;
            let _e406 = ((f32(_e54.y) + 0.5f) + _e367);
            if (_e406 > -8388608f) {
                let _e418 = f32(select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406)));
                if (_e418 > _e406) {
                    phi_612_ = 1f;
                } else {
                    phi_612_ = 0f;
                }
                let _e421 = phi_612_;
                if (_e406 < 8388608f) {
                    phi_617_ = (_e418 - _e421);
                    phi_618_ = false;
                } else {
                    phi_617_ = f32();
                    phi_618_ = true;
                }
                let _e424 = phi_617_;
                let _e426 = phi_618_;
                phi_619_ = _e424;
                phi_620_ = _e426;
            } else {
                phi_619_ = f32();
                phi_620_ = true;
            }
            let _e428 = phi_619_;
            let _e430 = phi_620_;
            if _e430 {
                phi_624_ = _e406;
            } else {
                phi_624_ = _e428;
            }
            let _e432 = phi_624_;
            if (_e403 >= 0f) {
                if (_e432 >= 0f) {
                    if (_e403 < f32(_e371)) {
                        let _e438 = (_e432 < f32(_e373));
                        if (_e361 == 0f) {
                            phi_645_ = (_e367 == 0f);
                        } else {
                            phi_645_ = false;
                        }
                        let _e442 = phi_645_;
                        if _e438 {
                            phi_664_ = vec2<u32>(select(select(u32(_e403), 0u, (_e403 < bitcast<f32>(0u))), 4294967295u, (_e403 > bitcast<f32>(1333788671u))), select(select(u32(_e432), 0u, (_e432 < bitcast<f32>(0u))), 4294967295u, (_e432 > bitcast<f32>(1333788671u))));
                            phi_665_ = false;
                        } else {
                            phi_664_ = vec2<u32>();
                            phi_665_ = true;
                        }
                        let _e459 = phi_664_;
                        let _e461 = phi_665_;
                        phi_666_ = _e442;
                        phi_667_ = _e438;
                        phi_668_ = _e459;
                        phi_669_ = _e442;
                        phi_670_ = _e438;
                        phi_671_ = false;
                        phi_672_ = _e461;
                    } else {
                        phi_666_ = bool();
                        phi_667_ = bool();
                        phi_668_ = vec2<u32>();
                        phi_669_ = bool();
                        phi_670_ = bool();
                        phi_671_ = true;
                        phi_672_ = false;
                    }
                    let _e463 = phi_666_;
                    let _e465 = phi_667_;
                    let _e467 = phi_668_;
                    let _e469 = phi_669_;
                    let _e471 = phi_670_;
                    let _e473 = phi_671_;
                    let _e475 = phi_672_;
                    phi_673_ = _e463;
                    phi_674_ = _e465;
                    phi_675_ = _e467;
                    phi_676_ = _e469;
                    phi_677_ = _e471;
                    phi_678_ = _e473;
                    phi_679_ = _e475;
                } else {
                    phi_673_ = bool();
                    phi_674_ = bool();
                    phi_675_ = vec2<u32>();
                    phi_676_ = bool();
                    phi_677_ = bool();
                    phi_678_ = true;
                    phi_679_ = false;
                }
                let _e477 = phi_673_;
                let _e479 = phi_674_;
                let _e481 = phi_675_;
                let _e483 = phi_676_;
                let _e485 = phi_677_;
                let _e487 = phi_678_;
                let _e489 = phi_679_;
                phi_680_ = _e477;
                phi_681_ = _e479;
                phi_682_ = _e481;
                phi_683_ = _e483;
                phi_684_ = _e485;
                phi_685_ = _e487;
                phi_686_ = _e489;
            } else {
                phi_680_ = bool();
                phi_681_ = bool();
                phi_682_ = vec2<u32>();
                phi_683_ = bool();
                phi_684_ = bool();
                phi_685_ = true;
                phi_686_ = false;
            }
            let _e491 = phi_680_;
            let _e493 = phi_681_;
            let _e495 = phi_682_;
            let _e497 = phi_683_;
            let _e499 = phi_684_;
            let _e501 = phi_685_;
            let _e503 = phi_686_;
            if _e501 {
                if (_e361 == 0f) {
                    phi_695_ = (_e367 == 0f);
                } else {
                    phi_695_ = false;
                }
                let _e507 = phi_695_;
                phi_696_ = _e507;
                phi_697_ = false;
                phi_698_ = true;
            } else {
                phi_696_ = _e497;
                phi_697_ = _e499;
                phi_698_ = _e503;
            }
            let _e509 = phi_696_;
            let _e511 = phi_697_;
            let _e513 = phi_698_;
            if _e513 {
                phi_702_ = _e509;
                phi_703_ = _e511;
                phi_704_ = vec2<u32>(_e54.x, _e54.y);
            } else {
                phi_702_ = _e491;
                phi_703_ = _e493;
                phi_704_ = _e495;
            }
            let _e515 = phi_702_;
            let _e517 = phi_703_;
            let _e519 = phi_704_;
            let _e529 = lt_mask_Reprojection(vec2<u32>(_e519.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e536 = lt_mask_Reprojection(vec2<u32>(_e529.pixel.x, _e519.y), _e529.is_valid, _e529.has_moved);
            let _e540 = lt_mask_Reprojection(_e536.pixel, _e517, _e536.has_moved);
            let _e544 = lt_mask_Reprojection(_e540.pixel, _e540.is_valid, !(_e515));
            if _e517 {
                let _e547 = p.member.previous.eye;
                let _e555 = p.member.previous.forward;
                let _e564 = (((((_e86.x - _e547.x) * _e555.x) + ((_e86.y - _e547.y) * _e555.y)) + ((_e86.z - _e547.z) * _e555.z)) > 0f);
                let _e568 = lt_mask_Reprojection(_e544.pixel, _e564, _e544.has_moved);
                if _e564 {
                    let _e571 = p.member.previous.eye;
                    let _e579 = p.member.previous.forward;
                    let _e587 = ((((_e86.x - _e571.x) * _e579.x) + ((_e86.y - _e571.y) * _e579.y)) + ((_e86.z - _e571.z) * _e579.z));
                    let _e589 = ((_e519.y * _e83) + _e519.x);
                    if (_e589 < arrayLength((&last_depths.member))) {
                    } else {
                        return;
                    }
                    let _e593 = last_depths.member[(0u + _e589)];
                    let _e595 = p.member.depth_tolerance;
                    let _e598 = abs(_e587);
                    let _e599 = abs(_e593);
                    if ((bitcast<u32>(_e599) & 2147483647u) > 2139095040u) {
                        phi_787_ = true;
                    } else {
                        let _e603 = (_e599 > _e598);
                        if _e603 {
                        }
                        phi_787_ = _e603;
                    }
                    let _e605 = phi_787_;
                    if _e605 {
                        phi_791_ = _e599;
                    } else {
                        phi_791_ = _e598;
                    }
                    let _e607 = phi_791_;
                    phi_795_ = lt_mask_Reprojection(_e568.pixel, (abs((_e587 - _e593)) <= (_e595 * _e607)), _e568.has_moved);
                } else {
                    phi_795_ = _e568;
                }
                let _e615 = phi_795_;
                if _e615.is_valid {
                    let _e618 = p.member.flags;
                    phi_804_ = ((_e618 & 1u) != 0u);
                    phi_805_ = false;
                } else {
                    phi_804_ = bool();
                    phi_805_ = true;
                }
                let _e622 = phi_804_;
                let _e624 = phi_805_;
                phi_807_ = _e622;
                phi_808_ = _e615;
                phi_809_ = _e615;
                phi_810_ = _e624;
            } else {
                phi_807_ = bool();
                phi_808_ = lt_mask_Reprojection();
                phi_809_ = lt_mask_Reprojection(_e544.pixel, false, _e544.has_moved);
                phi_810_ = true;
            }
            let _e630 = phi_807_;
            let _e632 = phi_808_;
            let _e634 = phi_809_;
            let _e636 = phi_810_;
            if _e636 {
                phi_814_ = false;
                phi_815_ = _e634;
            } else {
                phi_814_ = _e630;
                phi_815_ = _e632;
            }
            let _e638 = phi_814_;
            let _e640 = phi_815_;
            let _e644 = lt_mask_Reprojection(_e640.pixel, _e638, _e640.has_moved);
            let _e646 = p.member.flags;
            if _e644.has_moved {
                let _e651 = p.member.flags;
                phi_829_ = ((_e651 & 4u) == 0u);
            } else {
                phi_829_ = false;
            }
            let _e655 = phi_829_;
            if ((_e646 & 2u) != 0u) {
                if false {
                    phi_842_ = bool();
                    phi_843_ = true;
                } else {
                    if true {
                        phi_840_ = !(_e655);
                        phi_841_ = false;
                    } else {
                        phi_840_ = bool();
                        phi_841_ = true;
                    }
                    let _e658 = phi_840_;
                    let _e660 = phi_841_;
                    phi_842_ = _e658;
                    phi_843_ = _e660;
                }
                let _e662 = phi_842_;
                let _e664 = phi_843_;
                phi_844_ = _e662;
                phi_845_ = _e664;
            } else {
                phi_844_ = bool();
                phi_845_ = true;
            }
            let _e666 = phi_844_;
            let _e668 = phi_845_;
            if _e668 {
                phi_849_ = false;
            } else {
                phi_849_ = _e666;
            }
            let _e670 = phi_849_;
            let _e671 = lt_mask_Neighbourhood(false, true);
            if _e210 {
                phi_854_ = _e670;
            } else {
                phi_854_ = false;
            }
            let _e673 = phi_854_;
            if _e673 {
                if _e638 {
                    if _e644.has_moved {
                        let _e676 = p.member.moving_pattern;
                        phi_869_ = _e676;
                    } else {
                        let _e678 = p.member.still_pattern;
                        phi_869_ = _e678;
                    }
                    let _e680 = phi_869_;
                    phi_871_ = 0u;
                    phi_874_ = _e671;
                    loop {
                        let _e682 = phi_871_;
                        let _e684 = phi_874_;
                        local_1 = _e684;
                        if (1u <= _e680) {
                            if (_e680 <= 4u) {
                                phi_886_ = false;
                            } else {
                                phi_886_ = true;
                            }
                            let _e688 = phi_886_;
                            phi_887_ = _e688;
                        } else {
                            phi_887_ = true;
                        }
                        let _e690 = phi_887_;
                        if _e690 {
                            switch bitcast<i32>(_e680) {
                                case 5: {
                                    phi_895_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_895_ = 25u;
                                    break;
                                }
                                default: {
                                    phi_895_ = 9u;
                                    break;
                                }
                            }
                            let _e693 = phi_895_;
                            phi_896_ = _e693;
                        } else {
                            phi_896_ = 5u;
                        }
                        let _e695 = phi_896_;
                        let _e696 = (_e682 < _e695);
                        if _e696 {
                            let _e702 = p.member.frame;
                            let _e706 = p.member.current.size[0u];
                            let _e708 = p.member.current.size[1u];
                            switch bitcast<i32>(_e680) {
                                case 1: {
                                    let _e718 = lt_mask_pattern_plus(_e682);
                                    phi_971_ = vec2<i32>(_e718.x, _e718.y);
                                    break;
                                }
                                case 2: {
                                    let _e722 = lt_mask_pattern_cross(_e682);
                                    phi_971_ = vec2<i32>(_e722.x, _e722.y);
                                    break;
                                }
                                case 3: {
                                    let _e728 = lt_mask_pattern_plus_or_cross(_e682, ((_e644.pixel.x + _e644.pixel.y) & 1u));
                                    phi_971_ = vec2<i32>(_e728.x, _e728.y);
                                    break;
                                }
                                case 4: {
                                    let _e733 = lt_mask_pattern_plus_or_cross(_e682, (_e702 & 1u));
                                    phi_971_ = vec2<i32>(_e733.x, _e733.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e702 & 3u)) {
                                        case 0: {
                                            phi_955_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_955_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_955_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_955_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e744 = phi_955_;
                                    phi_971_ = (_e744 + vec2<i32>(bitcast<i32>((_e682 & 1u)), bitcast<i32>(((_e682 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_971_ = vec2<i32>((bitcast<i32>((_e682 % 5u)) - 2i), (bitcast<i32>(((_e682 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                default: {
                                    phi_971_ = vec2<i32>((bitcast<i32>((_e682 % 3u)) - 1i), (bitcast<i32>(((_e682 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e762 = phi_971_;
                            let _e765 = lt_mask_pattern_step_clamped(_e644.pixel.x, _e762.x, _e706);
                            let _e766 = lt_mask_pattern_step_clamped(_e644.pixel.y, _e762.y, _e708);
                            let _e768 = ((_e766 * _e83) + _e765);
                            if (_e768 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e772 = last_bits.member[(0u + _e768)];
                            if ((_e772 & 2u) == 0u) {
                                phi_994_ = (_e772 & 1u);
                            } else {
                                phi_994_ = (_e772 & 7u);
                            }
                            let _e778 = phi_994_;
                            if _e684.any_expands {
                                phi_1020_ = true;
                            } else {
                                if ((_e778 & 2u) != 0u) {
                                    if (((_e778 & 4u) != 0u) != _e206) {
                                        phi_1011_ = false;
                                    } else {
                                        phi_1011_ = true;
                                    }
                                    let _e787 = phi_1011_;
                                    phi_1012_ = _e787;
                                } else {
                                    phi_1012_ = true;
                                }
                                let _e789 = phi_1012_;
                                if _e789 {
                                    phi_1019_ = (((_e778 & 1u) != 0u) != _e206);
                                } else {
                                    phi_1019_ = true;
                                }
                                let _e794 = phi_1019_;
                                phi_1020_ = _e794;
                            }
                            let _e796 = phi_1020_;
                            if _e684.all_remove {
                                if (((_e778 & 1u) != 0u) == _e206) {
                                    if ((_e778 & 2u) != 0u) {
                                        phi_1038_ = (((_e778 & 4u) != 0u) == _e206);
                                    } else {
                                        phi_1038_ = true;
                                    }
                                    let _e806 = phi_1038_;
                                    phi_1039_ = _e806;
                                } else {
                                    phi_1039_ = false;
                                }
                                let _e808 = phi_1039_;
                                phi_1040_ = _e808;
                            } else {
                                phi_1040_ = false;
                            }
                            let _e810 = phi_1040_;
                            phi_872_ = (_e682 + 1u);
                            phi_875_ = lt_mask_Neighbourhood(_e796, _e810);
                        } else {
                            phi_872_ = u32();
                            phi_875_ = lt_mask_Neighbourhood();
                        }
                        let _e814 = phi_872_;
                        let _e816 = phi_875_;
                        continue;
                        continuing {
                            phi_871_ = _e814;
                            phi_874_ = _e816;
                            break if !(_e696);
                        }
                    }
                    let _e1038 = local_1;
                    phi_1043_ = _e1038;
                } else {
                    phi_1043_ = _e671;
                }
                let _e819 = phi_1043_;
                phi_1044_ = _e819;
            } else {
                phi_1044_ = _e671;
            }
            let _e821 = phi_1044_;
            if (_e91 != 0.5f) {
                if _e638 {
                    if _e210 {
                        phi_1070_ = true;
                    } else {
                        if _e821.any_expands {
                            phi_1069_ = false;
                        } else {
                            phi_1069_ = true;
                        }
                        let _e826 = phi_1069_;
                        phi_1070_ = _e826;
                    }
                    let _e828 = phi_1070_;
                    if _e828 {
                        if _e210 {
                            if _e670 {
                                if _e821.all_remove {
                                    phi_1083_ = false;
                                } else {
                                    phi_1083_ = true;
                                }
                                let _e830 = phi_1083_;
                                phi_1084_ = _e830;
                            } else {
                                phi_1084_ = true;
                            }
                            let _e832 = phi_1084_;
                            phi_1085_ = _e832;
                        } else {
                            phi_1085_ = true;
                        }
                        let _e834 = phi_1085_;
                        if _e834 {
                            if _e210 {
                                phi_1092_ = 1u;
                            } else {
                                phi_1092_ = 0u;
                            }
                            let _e836 = phi_1092_;
                            phi_1093_ = _e836;
                        } else {
                            phi_1093_ = 5u;
                        }
                        let _e838 = phi_1093_;
                        phi_1094_ = _e838;
                    } else {
                        phi_1094_ = 4u;
                    }
                    let _e840 = phi_1094_;
                    phi_1095_ = _e840;
                } else {
                    phi_1095_ = 3u;
                }
                let _e842 = phi_1095_;
                phi_1096_ = _e842;
            } else {
                phi_1096_ = 2u;
            }
            let _e844 = phi_1096_;
            if !((_e844 == 0u)) {
                phi_1104_ = !((_e844 == 5u));
            } else {
                phi_1104_ = false;
            }
            let _e850 = phi_1104_;
            if _e850 {
                if _e206 {
                    phi_1112_ = (2u | 1u);
                } else {
                    phi_1112_ = 2u;
                }
                let _e853 = phi_1112_;
                if false {
                    phi_1117_ = (_e853 | 4u);
                } else {
                    phi_1117_ = _e853;
                }
                let _e856 = phi_1117_;
                phi_1122_ = _e856;
            } else {
                if _e206 {
                    phi_1121_ = 1u;
                } else {
                    phi_1121_ = 0u;
                }
                let _e858 = phi_1121_;
                phi_1122_ = _e858;
            }
            let _e860 = phi_1122_;
            if _e206 {
                phi_1126_ = 0f;
            } else {
                phi_1126_ = 1f;
            }
            let _e862 = phi_1126_;
            phi_1128_ = mask_Masked(_e862, _e860, _e850);
        }
        let _e865 = phi_1128_;
        visibility.member[_e75.first_primitive] = _e865.visibility;
        bits.member[_e75.first_primitive] = _e865.bits;
        let _e873 = samples.member[_e75.first_primitive].normal[0u];
        let _e875 = global[0u];
        if (_e873 == _e875) {
            let _e878 = samples.member[_e75.first_primitive].normal[1u];
            let _e880 = global[1u];
            if (_e878 == _e880) {
                let _e883 = samples.member[_e75.first_primitive].normal[2u];
                let _e885 = global[2u];
                phi_1156_ = (_e883 == _e885);
                phi_1157_ = false;
            } else {
                phi_1156_ = bool();
                phi_1157_ = true;
            }
            let _e888 = phi_1156_;
            let _e890 = phi_1157_;
            phi_1158_ = _e888;
            phi_1159_ = _e890;
        } else {
            phi_1158_ = bool();
            phi_1159_ = true;
        }
        let _e892 = phi_1158_;
        let _e894 = phi_1159_;
        if _e894 {
            phi_1163_ = false;
        } else {
            phi_1163_ = _e892;
        }
        let _e896 = phi_1163_;
        if !(_e896) {
            let _e899 = samples.member[_e75.first_primitive].position;
            let _e901 = p.member.current.eye;
            let _e912 = p.member.current.forward;
            phi_1191_ = ((((_e899.x - _e901.x) * _e912.x) + ((_e899.y - _e901.y) * _e912.y)) + ((_e899.z - _e901.z) * _e912.z));
        } else {
            phi_1191_ = 0f;
        }
        let _e922 = phi_1191_;
        depths.member[_e75.first_primitive] = _e922;
        phi_1194_ = _e865.needs_ray;
        phi_1195_ = _e75.first_primitive;
    } else {
        phi_1194_ = false;
        phi_1195_ = 0u;
    }
    let _e926 = phi_1194_;
    let _e928 = phi_1195_;
    if (_e55 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e926 {
        let _e932 = atomicAdd((&shared_[0u]), 1u);
        phi_1206_ = _e932;
    } else {
        phi_1206_ = 0u;
    }
    let _e934 = phi_1206_;
    workgroupBarrier();
    if (_e55 == 0u) {
        let _e938 = atomicLoad((&shared_[0u]));
        let _e939 = atomicAdd((&list.member[3u]), _e938);
        atomicStore((&shared_[1u]), _e939);
    }
    workgroupBarrier();
    if _e926 {
        let _e942 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e942) + _e934)]), _e928);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
