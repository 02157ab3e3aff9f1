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
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_167_: lt_bvh_traverse_Tree;
    var phi_168_: bool;
    var phi_173_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_165_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_166_ = false;
        } else {
            phi_165_ = lt_bvh_traverse_Tree();
            phi_166_ = true;
        }
        let _e68 = phi_165_;
        let _e70 = phi_166_;
        phi_167_ = _e68;
        phi_168_ = _e70;
    } else {
        phi_167_ = lt_bvh_traverse_Tree();
        phi_168_ = true;
    }
    let _e72 = phi_167_;
    let _e74 = phi_168_;
    if _e74 {
        phi_173_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_173_ = _e72;
    }
    let _e79 = phi_173_;
    return lt_bvh_traverse_Tree(_e79.root, _e79.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_191_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_191_ = vec2(0i);
            break;
        }
        case 1: {
            phi_191_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_191_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_191_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_191_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e64 = phi_191_;
    return vec2<i32>(_e64.x, _e64.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_209_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_209_ = vec2(0i);
            break;
        }
        case 1: {
            phi_209_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_209_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_209_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_209_ = vec2(1i);
            break;
        }
    }
    let _e64 = phi_209_;
    return vec2<i32>(_e64.x, _e64.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_228_: vec2<i32>;

    if (param_6 == 0u) {
        let _e58 = lt_mask_pattern_plus(param_5);
        phi_228_ = vec2<i32>(_e58.x, _e58.y);
    } else {
        let _e62 = lt_mask_pattern_cross(param_5);
        phi_228_ = vec2<i32>(_e62.x, _e62.y);
    }
    let _e67 = phi_228_;
    return vec2<i32>(_e67.x, _e67.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_253_: vec2<i32>;

    let _e56 = (param_7 % 13u);
    switch bitcast<i32>(_e56) {
        case 9: {
            phi_253_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_253_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_253_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_253_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_253_ = vec2<i32>((bitcast<i32>((_e56 % 3u)) - 1i), (bitcast<i32>(((_e56 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e71 = phi_253_;
    return vec2<i32>(_e71.x, _e71.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_274_: u32;
    var phi_275_: u32;

    let _e59 = (bitcast<i32>(param_8) + param_9);
    if (_e59 < 0i) {
        phi_275_ = 0u;
    } else {
        if (_e59 >= bitcast<i32>(param_10)) {
            phi_274_ = (param_10 - 1u);
        } else {
            phi_274_ = bitcast<u32>(_e59);
        }
        let _e66 = phi_274_;
        phi_275_ = _e66;
    }
    let _e68 = phi_275_;
    return _e68;
}

fn function_() {
    var phi_341_: bool;
    var phi_342_: bool;
    var phi_343_: bool;
    var phi_344_: bool;
    var phi_348_: bool;
    var phi_392_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_396_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_409_: bool;
    var phi_598_: f32;
    var phi_603_: f32;
    var phi_604_: bool;
    var phi_605_: f32;
    var phi_606_: bool;
    var phi_610_: f32;
    var phi_633_: f32;
    var phi_638_: f32;
    var phi_639_: bool;
    var phi_640_: f32;
    var phi_641_: bool;
    var phi_645_: f32;
    var phi_666_: bool;
    var phi_685_: vec2<u32>;
    var phi_686_: bool;
    var phi_687_: bool;
    var phi_688_: bool;
    var phi_689_: vec2<u32>;
    var phi_690_: bool;
    var phi_691_: bool;
    var phi_692_: bool;
    var phi_693_: bool;
    var phi_694_: bool;
    var phi_695_: bool;
    var phi_696_: vec2<u32>;
    var phi_697_: bool;
    var phi_698_: bool;
    var phi_699_: bool;
    var phi_700_: bool;
    var phi_701_: bool;
    var phi_702_: bool;
    var phi_703_: vec2<u32>;
    var phi_704_: bool;
    var phi_705_: bool;
    var phi_706_: bool;
    var phi_707_: bool;
    var phi_716_: bool;
    var phi_717_: bool;
    var phi_718_: bool;
    var phi_719_: bool;
    var phi_723_: bool;
    var phi_724_: bool;
    var phi_725_: vec2<u32>;
    var phi_814_: bool;
    var phi_818_: f32;
    var phi_822_: lt_mask_Reprojection;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_834_: bool;
    var phi_835_: lt_mask_Reprojection;
    var phi_836_: lt_mask_Reprojection;
    var phi_837_: bool;
    var phi_841_: bool;
    var phi_842_: lt_mask_Reprojection;
    var phi_856_: bool;
    var phi_867_: bool;
    var phi_868_: bool;
    var phi_869_: bool;
    var phi_870_: bool;
    var phi_871_: bool;
    var phi_872_: bool;
    var phi_876_: bool;
    var phi_881_: bool;
    var phi_896_: u32;
    var phi_898_: u32;
    var phi_901_: lt_mask_Neighbourhood;
    var phi_913_: bool;
    var phi_914_: bool;
    var phi_923_: u32;
    var phi_924_: u32;
    var phi_984_: vec2<i32>;
    var phi_1004_: vec2<i32>;
    var phi_1027_: u32;
    var phi_1044_: bool;
    var phi_1045_: bool;
    var phi_1052_: bool;
    var phi_1053_: bool;
    var phi_1071_: bool;
    var phi_1072_: bool;
    var phi_1073_: bool;
    var phi_899_: u32;
    var phi_902_: lt_mask_Neighbourhood;
    var phi_1076_: lt_mask_Neighbourhood;
    var phi_1077_: lt_mask_Neighbourhood;
    var phi_1102_: bool;
    var phi_1103_: bool;
    var phi_1116_: bool;
    var phi_1117_: bool;
    var phi_1118_: bool;
    var phi_1125_: u32;
    var phi_1126_: u32;
    var phi_1127_: u32;
    var phi_1128_: u32;
    var phi_1129_: u32;
    var phi_1137_: bool;
    var phi_1145_: u32;
    var phi_1150_: u32;
    var phi_1154_: u32;
    var phi_1155_: u32;
    var phi_1159_: f32;
    var phi_1161_: mask_Masked;
    var phi_1189_: bool;
    var phi_1190_: bool;
    var phi_1191_: bool;
    var phi_1192_: bool;
    var phi_1196_: bool;
    var phi_1224_: f32;
    var phi_1227_: bool;
    var phi_1228_: u32;
    var phi_1239_: u32;
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
        let _e92 = p.member.light;
        let _e95 = samples.member[_e75.first_primitive].normal[0u];
        let _e97 = global[0u];
        if (_e95 == _e97) {
            let _e100 = samples.member[_e75.first_primitive].normal[1u];
            let _e102 = global[1u];
            if (_e100 == _e102) {
                let _e105 = samples.member[_e75.first_primitive].normal[2u];
                let _e107 = global[2u];
                phi_341_ = (_e105 == _e107);
                phi_342_ = false;
            } else {
                phi_341_ = bool();
                phi_342_ = true;
            }
            let _e110 = phi_341_;
            let _e112 = phi_342_;
            phi_343_ = _e110;
            phi_344_ = _e112;
        } else {
            phi_343_ = bool();
            phi_344_ = true;
        }
        let _e114 = phi_343_;
        let _e116 = phi_344_;
        if _e116 {
            phi_348_ = false;
        } else {
            phi_348_ = _e114;
        }
        let _e118 = phi_348_;
        if !(_e118) {
            let _e121 = samples.member[_e75.first_primitive].normal;
            let _e123 = samples.member[_e75.first_primitive].position;
            if ((((_e121.x * (_e92.x - (_e123.x * _e92.w))) + (_e121.y * (_e92.y - (_e123.y * _e92.w)))) + (_e121.z * (_e92.z - (_e123.z * _e92.w)))) > 0f) {
                let _e147 = samples.member[_e75.first_primitive].flags;
                let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e155.unnamed.visibility, false), _e155.unnamed_1);
                phi_392_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e161.unnamed, ((_e147 & 1u) == 0u));
            } else {
                let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
                phi_392_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, true);
            }
            let _e181 = phi_392_;
            phi_396_ = _e181;
        } else {
            let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e187.unnamed.visibility, false), _e187.unnamed_1);
            phi_396_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e193.unnamed, true);
        }
        let _e198 = phi_396_;
        if _e198.unnamed_1 {
            phi_1161_ = mask_Masked(_e198.unnamed.visibility, 0u, false);
        } else {
            let _e203 = (_e88 < 0.5f);
            if (_e88 > 0f) {
                phi_409_ = (_e88 < 1f);
            } else {
                phi_409_ = false;
            }
            let _e207 = phi_409_;
            let _e209 = samples.member[_e75.first_primitive].position;
            let _e213 = p.member.previous.eye;
            let _e216 = (_e86.x - _e213.x);
            let _e219 = (_e86.y - _e213.y);
            let _e222 = (_e86.z - _e213.z);
            let _e224 = p.member.previous.forward;
            let _e232 = (((_e216 * _e224.x) + (_e219 * _e224.y)) + (_e222 * _e224.z));
            let _e234 = p.member.previous.right;
            let _e244 = p.member.previous.right;
            let _e259 = p.member.previous.up;
            let _e269 = p.member.previous.up;
            let _e284 = p.member.current.eye;
            let _e287 = (_e209.x - _e284.x);
            let _e290 = (_e209.y - _e284.y);
            let _e293 = (_e209.z - _e284.z);
            let _e295 = p.member.current.forward;
            let _e303 = (((_e287 * _e295.x) + (_e290 * _e295.y)) + (_e293 * _e295.z));
            let _e305 = p.member.current.right;
            let _e315 = p.member.current.right;
            let _e330 = p.member.current.up;
            let _e340 = p.member.current.up;
            let _e359 = p.member.current.size[0u];
            let _e361 = (((((((_e216 * _e234.x) + (_e219 * _e234.y)) + (_e222 * _e234.z)) / ((((_e244.x * _e244.x) + (_e244.y * _e244.y)) + (_e244.z * _e244.z)) * _e232)) - ((((_e287 * _e305.x) + (_e290 * _e305.y)) + (_e293 * _e305.z)) / ((((_e315.x * _e315.x) + (_e315.y * _e315.y)) + (_e315.z * _e315.z)) * _e303))) * 0.5f) * f32(_e359));
            let _e365 = p.member.current.size[1u];
            let _e367 = (((((((_e216 * _e259.x) + (_e219 * _e259.y)) + (_e222 * _e259.z)) / ((((_e269.x * _e269.x) + (_e269.y * _e269.y)) + (_e269.z * _e269.z)) * _e232)) - ((((_e287 * _e330.x) + (_e290 * _e330.y)) + (_e293 * _e330.z)) / ((((_e340.x * _e340.x) + (_e340.y * _e340.y)) + (_e340.z * _e340.z)) * _e303))) * -0.5f) * f32(_e365));
            let _e371 = p.member.current.size[0u];
            let _e373 = p.member.current.size[1u];
            let _e377 = ((f32(_e55.x) + 0.5f) + _e361);
            if (_e377 > -8388608f) {
                let _e389 = f32(select(0i, select(select(i32(_e377), i32(-2147483648), (_e377 < bitcast<f32>(3472883712u))), 2147483647i, (_e377 > bitcast<f32>(1325400063u))), (_e377 == _e377)));
                if (_e389 > _e377) {
                    phi_598_ = 1f;
                } else {
                    phi_598_ = 0f;
                }
                let _e392 = phi_598_;
                if (_e377 < 8388608f) {
                    phi_603_ = (_e389 - _e392);
                    phi_604_ = false;
                } else {
                    phi_603_ = f32();
                    phi_604_ = true;
                }
                let _e395 = phi_603_;
                let _e397 = phi_604_;
                phi_605_ = _e395;
                phi_606_ = _e397;
            } else {
                phi_605_ = f32();
                phi_606_ = true;
            }
            let _e399 = phi_605_;
            let _e401 = phi_606_;
            if _e401 {
                phi_610_ = _e377;
            } else {
                phi_610_ = _e399;
            }
            let _e403 = phi_610_;
            let _e406 = ((f32(_e55.y) + 0.5f) + _e367);
            if (_e406 > -8388608f) {
                let _e418 = f32(select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406)));
                if (_e418 > _e406) {
                    phi_633_ = 1f;
                } else {
                    phi_633_ = 0f;
                }
                let _e421 = phi_633_;
                if (_e406 < 8388608f) {
                    phi_638_ = (_e418 - _e421);
                    phi_639_ = false;
                } else {
                    phi_638_ = f32();
                    phi_639_ = true;
                }
                let _e424 = phi_638_;
                let _e426 = phi_639_;
                phi_640_ = _e424;
                phi_641_ = _e426;
            } else {
                phi_640_ = f32();
                phi_641_ = true;
            }
            let _e428 = phi_640_;
            let _e430 = phi_641_;
            if _e430 {
                phi_645_ = _e406;
            } else {
                phi_645_ = _e428;
            }
            let _e432 = phi_645_;
            if (_e403 >= 0f) {
                if (_e432 >= 0f) {
                    if (_e403 < f32(_e371)) {
                        let _e438 = (_e432 < f32(_e373));
                        if (_e361 == 0f) {
                            phi_666_ = (_e367 == 0f);
                        } else {
                            phi_666_ = false;
                        }
                        let _e442 = phi_666_;
                        if _e438 {
                            phi_685_ = vec2<u32>(select(select(u32(_e403), 0u, (_e403 < bitcast<f32>(0u))), 4294967295u, (_e403 > bitcast<f32>(1333788671u))), select(select(u32(_e432), 0u, (_e432 < bitcast<f32>(0u))), 4294967295u, (_e432 > bitcast<f32>(1333788671u))));
                            phi_686_ = false;
                        } else {
                            phi_685_ = vec2<u32>();
                            phi_686_ = true;
                        }
                        let _e459 = phi_685_;
                        let _e461 = phi_686_;
                        phi_687_ = _e442;
                        phi_688_ = _e438;
                        phi_689_ = _e459;
                        phi_690_ = _e442;
                        phi_691_ = _e438;
                        phi_692_ = false;
                        phi_693_ = _e461;
                    } else {
                        phi_687_ = bool();
                        phi_688_ = bool();
                        phi_689_ = vec2<u32>();
                        phi_690_ = bool();
                        phi_691_ = bool();
                        phi_692_ = true;
                        phi_693_ = false;
                    }
                    let _e463 = phi_687_;
                    let _e465 = phi_688_;
                    let _e467 = phi_689_;
                    let _e469 = phi_690_;
                    let _e471 = phi_691_;
                    let _e473 = phi_692_;
                    let _e475 = phi_693_;
                    phi_694_ = _e463;
                    phi_695_ = _e465;
                    phi_696_ = _e467;
                    phi_697_ = _e469;
                    phi_698_ = _e471;
                    phi_699_ = _e473;
                    phi_700_ = _e475;
                } else {
                    phi_694_ = bool();
                    phi_695_ = bool();
                    phi_696_ = vec2<u32>();
                    phi_697_ = bool();
                    phi_698_ = bool();
                    phi_699_ = true;
                    phi_700_ = false;
                }
                let _e477 = phi_694_;
                let _e479 = phi_695_;
                let _e481 = phi_696_;
                let _e483 = phi_697_;
                let _e485 = phi_698_;
                let _e487 = phi_699_;
                let _e489 = phi_700_;
                phi_701_ = _e477;
                phi_702_ = _e479;
                phi_703_ = _e481;
                phi_704_ = _e483;
                phi_705_ = _e485;
                phi_706_ = _e487;
                phi_707_ = _e489;
            } else {
                phi_701_ = bool();
                phi_702_ = bool();
                phi_703_ = vec2<u32>();
                phi_704_ = bool();
                phi_705_ = bool();
                phi_706_ = true;
                phi_707_ = false;
            }
            let _e491 = phi_701_;
            let _e493 = phi_702_;
            let _e495 = phi_703_;
            let _e497 = phi_704_;
            let _e499 = phi_705_;
            let _e501 = phi_706_;
            let _e503 = phi_707_;
            if _e501 {
                if (_e361 == 0f) {
                    phi_716_ = (_e367 == 0f);
                } else {
                    phi_716_ = false;
                }
                let _e507 = phi_716_;
                phi_717_ = _e507;
                phi_718_ = false;
                phi_719_ = true;
            } else {
                phi_717_ = _e497;
                phi_718_ = _e499;
                phi_719_ = _e503;
            }
            let _e509 = phi_717_;
            let _e511 = phi_718_;
            let _e513 = phi_719_;
            if _e513 {
                phi_723_ = _e509;
                phi_724_ = _e511;
                phi_725_ = vec2<u32>(_e55.x, _e55.y);
            } else {
                phi_723_ = _e491;
                phi_724_ = _e493;
                phi_725_ = _e495;
            }
            let _e515 = phi_723_;
            let _e517 = phi_724_;
            let _e519 = phi_725_;
            let _e529 = lt_mask_Reprojection(vec2<u32>(_e519.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e536 = lt_mask_Reprojection(vec2<u32>(_e529.pixel.x, _e519.y), _e529.is_valid, _e529.has_moved);
            let _e540 = lt_mask_Reprojection(_e536.pixel, _e517, _e536.has_moved);
            let _e544 = lt_mask_Reprojection(_e540.pixel, _e540.is_valid, !(_e515));
            if _e517 {
                let _e547 = p.member.previous.eye;
                let _e558 = p.member.previous.forward;
                let _e567 = (((((_e86.x - _e547.x) * _e558.x) + ((_e86.y - _e547.y) * _e558.y)) + ((_e86.z - _e547.z) * _e558.z)) > 0f);
                let _e571 = lt_mask_Reprojection(_e544.pixel, _e567, _e544.has_moved);
                if _e567 {
                    let _e574 = p.member.previous.eye;
                    let _e585 = p.member.previous.forward;
                    let _e593 = ((((_e86.x - _e574.x) * _e585.x) + ((_e86.y - _e574.y) * _e585.y)) + ((_e86.z - _e574.z) * _e585.z));
                    let _e595 = ((_e519.y * _e83) + _e519.x);
                    if (_e595 < arrayLength((&last_depths.member))) {
                    } else {
                        return;
                    }
                    let _e599 = last_depths.member[(0u + _e595)];
                    let _e601 = p.member.depth_tolerance;
                    let _e604 = abs(_e593);
                    let _e605 = abs(_e599);
                    if ((bitcast<u32>(_e605) & 2147483647u) > 2139095040u) {
                        phi_814_ = true;
                    } else {
                        let _e609 = (_e605 > _e604);
                        if _e609 {
                        }
                        phi_814_ = _e609;
                    }
                    let _e611 = phi_814_;
                    if _e611 {
                        phi_818_ = _e605;
                    } else {
                        phi_818_ = _e604;
                    }
                    let _e613 = phi_818_;
                    phi_822_ = lt_mask_Reprojection(_e571.pixel, (abs((_e593 - _e599)) <= (_e601 * _e613)), _e571.has_moved);
                } else {
                    phi_822_ = _e571;
                }
                let _e621 = phi_822_;
                if _e621.is_valid {
                    let _e624 = p.member.flags;
                    phi_831_ = ((_e624 & 1u) != 0u);
                    phi_832_ = false;
                } else {
                    phi_831_ = bool();
                    phi_832_ = true;
                }
                let _e628 = phi_831_;
                let _e630 = phi_832_;
                phi_834_ = _e628;
                phi_835_ = _e621;
                phi_836_ = _e621;
                phi_837_ = _e630;
            } else {
                phi_834_ = bool();
                phi_835_ = lt_mask_Reprojection();
                phi_836_ = lt_mask_Reprojection(_e544.pixel, false, _e544.has_moved);
                phi_837_ = true;
            }
            let _e636 = phi_834_;
            let _e638 = phi_835_;
            let _e640 = phi_836_;
            let _e642 = phi_837_;
            if _e642 {
                phi_841_ = false;
                phi_842_ = _e640;
            } else {
                phi_841_ = _e636;
                phi_842_ = _e638;
            }
            let _e644 = phi_841_;
            let _e646 = phi_842_;
            let _e650 = lt_mask_Reprojection(_e646.pixel, _e644, _e646.has_moved);
            let _e652 = p.member.flags;
            if _e650.has_moved {
                let _e657 = p.member.flags;
                phi_856_ = ((_e657 & 4u) == 0u);
            } else {
                phi_856_ = false;
            }
            let _e661 = phi_856_;
            if ((_e652 & 2u) != 0u) {
                if false {
                    phi_869_ = bool();
                    phi_870_ = true;
                } else {
                    if true {
                        phi_867_ = !(_e661);
                        phi_868_ = false;
                    } else {
                        phi_867_ = bool();
                        phi_868_ = true;
                    }
                    let _e664 = phi_867_;
                    let _e666 = phi_868_;
                    phi_869_ = _e664;
                    phi_870_ = _e666;
                }
                let _e668 = phi_869_;
                let _e670 = phi_870_;
                phi_871_ = _e668;
                phi_872_ = _e670;
            } else {
                phi_871_ = bool();
                phi_872_ = true;
            }
            let _e672 = phi_871_;
            let _e674 = phi_872_;
            if _e674 {
                phi_876_ = false;
            } else {
                phi_876_ = _e672;
            }
            let _e676 = phi_876_;
            let _e677 = lt_mask_Neighbourhood(false, true);
            if _e207 {
                phi_881_ = _e676;
            } else {
                phi_881_ = false;
            }
            let _e679 = phi_881_;
            if _e679 {
                if _e644 {
                    if _e650.has_moved {
                        let _e682 = p.member.moving_pattern;
                        phi_896_ = _e682;
                    } else {
                        let _e684 = p.member.still_pattern;
                        phi_896_ = _e684;
                    }
                    let _e686 = phi_896_;
                    phi_898_ = 0u;
                    phi_901_ = _e677;
                    loop {
                        let _e688 = phi_898_;
                        let _e690 = phi_901_;
                        local_1 = _e690;
                        if (1u <= _e686) {
                            if (_e686 <= 4u) {
                                phi_913_ = false;
                            } else {
                                phi_913_ = true;
                            }
                            let _e694 = phi_913_;
                            phi_914_ = _e694;
                        } else {
                            phi_914_ = true;
                        }
                        let _e696 = phi_914_;
                        if _e696 {
                            switch bitcast<i32>(_e686) {
                                case 5: {
                                    phi_923_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_923_ = 25u;
                                    break;
                                }
                                case 7: {
                                    phi_923_ = 13u;
                                    break;
                                }
                                default: {
                                    phi_923_ = 9u;
                                    break;
                                }
                            }
                            let _e699 = phi_923_;
                            phi_924_ = _e699;
                        } else {
                            phi_924_ = 5u;
                        }
                        let _e701 = phi_924_;
                        let _e702 = (_e688 < _e701);
                        if _e702 {
                            let _e708 = p.member.frame;
                            let _e712 = p.member.current.size[0u];
                            let _e714 = p.member.current.size[1u];
                            switch bitcast<i32>(_e686) {
                                case 1: {
                                    let _e724 = lt_mask_pattern_plus(_e688);
                                    phi_1004_ = vec2<i32>(_e724.x, _e724.y);
                                    break;
                                }
                                case 2: {
                                    let _e728 = lt_mask_pattern_cross(_e688);
                                    phi_1004_ = vec2<i32>(_e728.x, _e728.y);
                                    break;
                                }
                                case 3: {
                                    let _e734 = lt_mask_pattern_plus_or_cross(_e688, ((_e650.pixel.x + _e650.pixel.y) & 1u));
                                    phi_1004_ = vec2<i32>(_e734.x, _e734.y);
                                    break;
                                }
                                case 4: {
                                    let _e739 = lt_mask_pattern_plus_or_cross(_e688, (_e708 & 1u));
                                    phi_1004_ = vec2<i32>(_e739.x, _e739.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e708 & 3u)) {
                                        case 0: {
                                            phi_984_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_984_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_984_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_984_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e750 = phi_984_;
                                    phi_1004_ = (_e750 + vec2<i32>(bitcast<i32>((_e688 & 1u)), bitcast<i32>(((_e688 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_1004_ = vec2<i32>((bitcast<i32>((_e688 % 5u)) - 2i), (bitcast<i32>(((_e688 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                case 7: {
                                    let _e767 = lt_mask_pattern_diamond(_e688);
                                    phi_1004_ = vec2<i32>(_e767.x, _e767.y);
                                    break;
                                }
                                default: {
                                    phi_1004_ = vec2<i32>((bitcast<i32>((_e688 % 3u)) - 1i), (bitcast<i32>(((_e688 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e772 = phi_1004_;
                            let _e775 = lt_mask_pattern_step_clamped(_e650.pixel.x, _e772.x, _e712);
                            let _e776 = lt_mask_pattern_step_clamped(_e650.pixel.y, _e772.y, _e714);
                            let _e778 = ((_e776 * _e83) + _e775);
                            if (_e778 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e782 = last_bits.member[(0u + _e778)];
                            if ((_e782 & 2u) == 0u) {
                                phi_1027_ = (_e782 & 1u);
                            } else {
                                phi_1027_ = (_e782 & 7u);
                            }
                            let _e788 = phi_1027_;
                            if _e690.any_expands {
                                phi_1053_ = true;
                            } else {
                                if ((_e788 & 2u) != 0u) {
                                    if (((_e788 & 4u) != 0u) != _e203) {
                                        phi_1044_ = false;
                                    } else {
                                        phi_1044_ = true;
                                    }
                                    let _e797 = phi_1044_;
                                    phi_1045_ = _e797;
                                } else {
                                    phi_1045_ = true;
                                }
                                let _e799 = phi_1045_;
                                if _e799 {
                                    phi_1052_ = (((_e788 & 1u) != 0u) != _e203);
                                } else {
                                    phi_1052_ = true;
                                }
                                let _e804 = phi_1052_;
                                phi_1053_ = _e804;
                            }
                            let _e806 = phi_1053_;
                            if _e690.all_remove {
                                if (((_e788 & 1u) != 0u) == _e203) {
                                    if ((_e788 & 2u) != 0u) {
                                        phi_1071_ = (((_e788 & 4u) != 0u) == _e203);
                                    } else {
                                        phi_1071_ = true;
                                    }
                                    let _e816 = phi_1071_;
                                    phi_1072_ = _e816;
                                } else {
                                    phi_1072_ = false;
                                }
                                let _e818 = phi_1072_;
                                phi_1073_ = _e818;
                            } else {
                                phi_1073_ = false;
                            }
                            let _e820 = phi_1073_;
                            phi_899_ = (_e688 + 1u);
                            phi_902_ = lt_mask_Neighbourhood(_e806, _e820);
                        } else {
                            phi_899_ = u32();
                            phi_902_ = lt_mask_Neighbourhood();
                        }
                        let _e824 = phi_899_;
                        let _e826 = phi_902_;
                        continue;
                        continuing {
                            phi_898_ = _e824;
                            phi_901_ = _e826;
                            break if !(_e702);
                        }
                    }
                    let _e1048 = local_1;
                    phi_1076_ = _e1048;
                } else {
                    phi_1076_ = _e677;
                }
                let _e829 = phi_1076_;
                phi_1077_ = _e829;
            } else {
                phi_1077_ = _e677;
            }
            let _e831 = phi_1077_;
            if (_e88 != 0.5f) {
                if _e644 {
                    if _e207 {
                        phi_1103_ = true;
                    } else {
                        if _e831.any_expands {
                            phi_1102_ = false;
                        } else {
                            phi_1102_ = true;
                        }
                        let _e836 = phi_1102_;
                        phi_1103_ = _e836;
                    }
                    let _e838 = phi_1103_;
                    if _e838 {
                        if _e207 {
                            if _e676 {
                                if _e831.all_remove {
                                    phi_1116_ = false;
                                } else {
                                    phi_1116_ = true;
                                }
                                let _e840 = phi_1116_;
                                phi_1117_ = _e840;
                            } else {
                                phi_1117_ = true;
                            }
                            let _e842 = phi_1117_;
                            phi_1118_ = _e842;
                        } else {
                            phi_1118_ = true;
                        }
                        let _e844 = phi_1118_;
                        if _e844 {
                            if _e207 {
                                phi_1125_ = 1u;
                            } else {
                                phi_1125_ = 0u;
                            }
                            let _e846 = phi_1125_;
                            phi_1126_ = _e846;
                        } else {
                            phi_1126_ = 5u;
                        }
                        let _e848 = phi_1126_;
                        phi_1127_ = _e848;
                    } else {
                        phi_1127_ = 4u;
                    }
                    let _e850 = phi_1127_;
                    phi_1128_ = _e850;
                } else {
                    phi_1128_ = 3u;
                }
                let _e852 = phi_1128_;
                phi_1129_ = _e852;
            } else {
                phi_1129_ = 2u;
            }
            let _e854 = phi_1129_;
            if !((_e854 == 0u)) {
                phi_1137_ = !((_e854 == 5u));
            } else {
                phi_1137_ = false;
            }
            let _e860 = phi_1137_;
            if _e860 {
                if _e203 {
                    phi_1145_ = (2u | 1u);
                } else {
                    phi_1145_ = 2u;
                }
                let _e863 = phi_1145_;
                if false {
                    phi_1150_ = (_e863 | 4u);
                } else {
                    phi_1150_ = _e863;
                }
                let _e866 = phi_1150_;
                phi_1155_ = _e866;
            } else {
                if _e203 {
                    phi_1154_ = 1u;
                } else {
                    phi_1154_ = 0u;
                }
                let _e868 = phi_1154_;
                phi_1155_ = _e868;
            }
            let _e870 = phi_1155_;
            if _e203 {
                phi_1159_ = 0f;
            } else {
                phi_1159_ = 1f;
            }
            let _e872 = phi_1159_;
            phi_1161_ = mask_Masked(_e872, _e870, _e860);
        }
        let _e875 = phi_1161_;
        visibility.member[_e75.first_primitive] = _e875.visibility;
        bits.member[_e75.first_primitive] = _e875.bits;
        let _e883 = samples.member[_e75.first_primitive].normal[0u];
        let _e885 = global[0u];
        if (_e883 == _e885) {
            let _e888 = samples.member[_e75.first_primitive].normal[1u];
            let _e890 = global[1u];
            if (_e888 == _e890) {
                let _e893 = samples.member[_e75.first_primitive].normal[2u];
                let _e895 = global[2u];
                phi_1189_ = (_e893 == _e895);
                phi_1190_ = false;
            } else {
                phi_1189_ = bool();
                phi_1190_ = true;
            }
            let _e898 = phi_1189_;
            let _e900 = phi_1190_;
            phi_1191_ = _e898;
            phi_1192_ = _e900;
        } else {
            phi_1191_ = bool();
            phi_1192_ = true;
        }
        let _e902 = phi_1191_;
        let _e904 = phi_1192_;
        if _e904 {
            phi_1196_ = false;
        } else {
            phi_1196_ = _e902;
        }
        let _e906 = phi_1196_;
        if !(_e906) {
            let _e909 = samples.member[_e75.first_primitive].position;
            let _e911 = p.member.current.eye;
            let _e922 = p.member.current.forward;
            phi_1224_ = ((((_e909.x - _e911.x) * _e922.x) + ((_e909.y - _e911.y) * _e922.y)) + ((_e909.z - _e911.z) * _e922.z));
        } else {
            phi_1224_ = 0f;
        }
        let _e932 = phi_1224_;
        depths.member[_e75.first_primitive] = _e932;
        phi_1227_ = _e875.needs_ray;
        phi_1228_ = _e75.first_primitive;
    } else {
        phi_1227_ = false;
        phi_1228_ = 0u;
    }
    let _e936 = phi_1227_;
    let _e938 = phi_1228_;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e936 {
        let _e942 = atomicAdd((&shared_[0u]), 1u);
        phi_1239_ = _e942;
    } else {
        phi_1239_ = 0u;
    }
    let _e944 = phi_1239_;
    workgroupBarrier();
    if (_e56 == 0u) {
        let _e948 = atomicLoad((&shared_[0u]));
        let _e949 = atomicAdd((&list.member[3u]), _e948);
        atomicStore((&shared_[1u]), _e949);
    }
    workgroupBarrier();
    if _e936 {
        let _e952 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e952) + _e944)]), _e938);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
