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
    var phi_171_: lt_bvh_traverse_Tree;
    var phi_172_: bool;
    var phi_173_: lt_bvh_traverse_Tree;
    var phi_174_: bool;
    var phi_179_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_171_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_172_ = false;
        } else {
            phi_171_ = lt_bvh_traverse_Tree();
            phi_172_ = true;
        }
        let _e69 = phi_171_;
        let _e71 = phi_172_;
        phi_173_ = _e69;
        phi_174_ = _e71;
    } else {
        phi_173_ = lt_bvh_traverse_Tree();
        phi_174_ = true;
    }
    let _e73 = phi_173_;
    let _e75 = phi_174_;
    if _e75 {
        phi_179_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_179_ = _e73;
    }
    let _e80 = phi_179_;
    return lt_bvh_traverse_Tree(_e80.root, _e80.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_197_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_197_ = vec2(0i);
            break;
        }
        case 1: {
            phi_197_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_197_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_197_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_197_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e65 = phi_197_;
    return vec2<i32>(_e65.x, _e65.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_215_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_215_ = vec2(0i);
            break;
        }
        case 1: {
            phi_215_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_215_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_215_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_215_ = vec2(1i);
            break;
        }
    }
    let _e65 = phi_215_;
    return vec2<i32>(_e65.x, _e65.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_234_: vec2<i32>;

    if (param_6 == 0u) {
        let _e59 = lt_mask_pattern_plus(param_5);
        phi_234_ = vec2<i32>(_e59.x, _e59.y);
    } else {
        let _e63 = lt_mask_pattern_cross(param_5);
        phi_234_ = vec2<i32>(_e63.x, _e63.y);
    }
    let _e68 = phi_234_;
    return vec2<i32>(_e68.x, _e68.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_259_: vec2<i32>;

    let _e57 = (param_7 % 13u);
    switch bitcast<i32>(_e57) {
        case 9: {
            phi_259_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_259_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_259_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_259_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_259_ = vec2<i32>((bitcast<i32>((_e57 % 3u)) - 1i), (bitcast<i32>(((_e57 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e72 = phi_259_;
    return vec2<i32>(_e72.x, _e72.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_280_: u32;
    var phi_281_: u32;

    let _e60 = (bitcast<i32>(param_8) + param_9);
    if (_e60 < 0i) {
        phi_281_ = 0u;
    } else {
        if (_e60 >= bitcast<i32>(param_10)) {
            phi_280_ = (param_10 - 1u);
        } else {
            phi_280_ = bitcast<u32>(_e60);
        }
        let _e67 = phi_280_;
        phi_281_ = _e67;
    }
    let _e69 = phi_281_;
    return _e69;
}

fn function_() {
    var phi_351_: bool;
    var phi_352_: bool;
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_358_: bool;
    var phi_402_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_406_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_419_: bool;
    var phi_605_: f32;
    var phi_610_: f32;
    var phi_611_: bool;
    var phi_612_: f32;
    var phi_613_: bool;
    var phi_617_: f32;
    var phi_640_: f32;
    var phi_645_: f32;
    var phi_646_: bool;
    var phi_647_: f32;
    var phi_648_: bool;
    var phi_652_: f32;
    var phi_673_: bool;
    var phi_692_: vec2<u32>;
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
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_710_: vec2<u32>;
    var phi_711_: bool;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_714_: bool;
    var phi_723_: bool;
    var phi_724_: bool;
    var phi_725_: bool;
    var phi_726_: bool;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_732_: vec2<u32>;
    var phi_815_: bool;
    var phi_819_: f32;
    var phi_823_: lt_mask_Reprojection;
    var phi_832_: bool;
    var phi_833_: bool;
    var phi_835_: bool;
    var phi_836_: lt_mask_Reprojection;
    var phi_837_: lt_mask_Reprojection;
    var phi_838_: bool;
    var phi_842_: bool;
    var phi_843_: lt_mask_Reprojection;
    var phi_857_: bool;
    var phi_868_: bool;
    var phi_869_: bool;
    var phi_870_: bool;
    var phi_871_: bool;
    var phi_872_: bool;
    var phi_873_: bool;
    var phi_877_: bool;
    var phi_882_: bool;
    var phi_897_: u32;
    var phi_899_: u32;
    var phi_902_: lt_mask_Neighbourhood;
    var phi_914_: bool;
    var phi_915_: bool;
    var phi_924_: u32;
    var phi_925_: u32;
    var phi_985_: vec2<i32>;
    var phi_1005_: vec2<i32>;
    var phi_1028_: u32;
    var phi_1045_: bool;
    var phi_1046_: bool;
    var phi_1053_: bool;
    var phi_1054_: bool;
    var phi_1072_: bool;
    var phi_1073_: bool;
    var phi_1074_: bool;
    var phi_900_: u32;
    var phi_903_: lt_mask_Neighbourhood;
    var phi_1077_: lt_mask_Neighbourhood;
    var phi_1078_: lt_mask_Neighbourhood;
    var phi_1103_: bool;
    var phi_1104_: bool;
    var phi_1117_: bool;
    var phi_1118_: bool;
    var phi_1119_: bool;
    var phi_1126_: u32;
    var phi_1127_: u32;
    var phi_1128_: u32;
    var phi_1129_: u32;
    var phi_1130_: u32;
    var phi_1138_: bool;
    var phi_1146_: u32;
    var phi_1151_: u32;
    var phi_1155_: u32;
    var phi_1156_: u32;
    var phi_1160_: f32;
    var phi_1162_: mask_Masked;
    var phi_1190_: bool;
    var phi_1191_: bool;
    var phi_1192_: bool;
    var phi_1193_: bool;
    var phi_1197_: bool;
    var phi_1225_: f32;
    var phi_1228_: bool;
    var phi_1229_: u32;
    var phi_1240_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e56 = id_1;
    let _e57 = local_2;
    let _e74 = p.member.current.size[0u];
    let _e76 = p.member.current.size[1u];
    let _e77 = lt_shaders_entry_pixel_index(_e56, _e74, _e76);
    if (bitcast<i32>(_e77.root) != 0i) {
        let _e85 = p.member.current.size[0u];
        let _e88 = past.member[_e77.first_primitive];
        let _e93 = visibility.member[_e77.first_primitive];
        let _e97 = p.member.light;
        let _e100 = samples.member[_e77.first_primitive].normal[0u];
        let _e102 = global[0u];
        if (_e100 == _e102) {
            let _e105 = samples.member[_e77.first_primitive].normal[1u];
            let _e107 = global[1u];
            if (_e105 == _e107) {
                let _e110 = samples.member[_e77.first_primitive].normal[2u];
                let _e112 = global[2u];
                phi_351_ = (_e110 == _e112);
                phi_352_ = false;
            } else {
                phi_351_ = bool();
                phi_352_ = true;
            }
            let _e115 = phi_351_;
            let _e117 = phi_352_;
            phi_353_ = _e115;
            phi_354_ = _e117;
        } else {
            phi_353_ = bool();
            phi_354_ = true;
        }
        let _e119 = phi_353_;
        let _e121 = phi_354_;
        if _e121 {
            phi_358_ = false;
        } else {
            phi_358_ = _e119;
        }
        let _e123 = phi_358_;
        if !(_e123) {
            let _e126 = samples.member[_e77.first_primitive].normal;
            let _e128 = samples.member[_e77.first_primitive].position;
            if ((((_e126.x * (_e97.x - (_e128.x * _e97.w))) + (_e126.y * (_e97.y - (_e128.y * _e97.w)))) + (_e126.z * (_e97.z - (_e128.z * _e97.w)))) > 0f) {
                let _e152 = samples.member[_e77.first_primitive].flags;
                let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e160.unnamed.visibility, false), _e160.unnamed_1);
                phi_402_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e166.unnamed, ((_e152 & 1u) == 0u));
            } else {
                let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e175.unnamed.visibility, false), _e175.unnamed_1);
                phi_402_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e181.unnamed, true);
            }
            let _e186 = phi_402_;
            phi_406_ = _e186;
        } else {
            let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e192.unnamed.visibility, false), _e192.unnamed_1);
            phi_406_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e198.unnamed, true);
        }
        let _e203 = phi_406_;
        if _e203.unnamed_1 {
            phi_1162_ = mask_Masked(_e203.unnamed.visibility, 0u, false);
        } else {
            let _e208 = (_e93 < 0.5f);
            if (_e93 > 0f) {
                phi_419_ = (_e93 < 1f);
            } else {
                phi_419_ = false;
            }
            let _e212 = phi_419_;
            let _e214 = samples.member[_e77.first_primitive].position;
            let _e218 = p.member.previous.eye;
            let _e220 = (_e88.x - _e218.x);
            let _e222 = (_e88.y - _e218.y);
            let _e224 = (_e88.z - _e218.z);
            let _e226 = p.member.previous.forward;
            let _e234 = (((_e220 * _e226.x) + (_e222 * _e226.y)) + (_e224 * _e226.z));
            let _e236 = p.member.previous.right;
            let _e246 = p.member.previous.right;
            let _e261 = p.member.previous.up;
            let _e271 = p.member.previous.up;
            let _e286 = p.member.current.eye;
            let _e289 = (_e214.x - _e286.x);
            let _e292 = (_e214.y - _e286.y);
            let _e295 = (_e214.z - _e286.z);
            let _e297 = p.member.current.forward;
            let _e305 = (((_e289 * _e297.x) + (_e292 * _e297.y)) + (_e295 * _e297.z));
            let _e307 = p.member.current.right;
            let _e317 = p.member.current.right;
            let _e332 = p.member.current.up;
            let _e342 = p.member.current.up;
            let _e361 = p.member.current.size[0u];
            let _e363 = (((((((_e220 * _e236.x) + (_e222 * _e236.y)) + (_e224 * _e236.z)) / ((((_e246.x * _e246.x) + (_e246.y * _e246.y)) + (_e246.z * _e246.z)) * _e234)) - ((((_e289 * _e307.x) + (_e292 * _e307.y)) + (_e295 * _e307.z)) / ((((_e317.x * _e317.x) + (_e317.y * _e317.y)) + (_e317.z * _e317.z)) * _e305))) * 0.5f) * f32(_e361));
            let _e367 = p.member.current.size[1u];
            let _e369 = (((((((_e220 * _e261.x) + (_e222 * _e261.y)) + (_e224 * _e261.z)) / ((((_e271.x * _e271.x) + (_e271.y * _e271.y)) + (_e271.z * _e271.z)) * _e234)) - ((((_e289 * _e332.x) + (_e292 * _e332.y)) + (_e295 * _e332.z)) / ((((_e342.x * _e342.x) + (_e342.y * _e342.y)) + (_e342.z * _e342.z)) * _e305))) * -0.5f) * f32(_e367));
            let _e373 = p.member.current.size[0u];
            let _e375 = p.member.current.size[1u];
            let _e379 = ((f32(_e56.x) + 0.5f) + _e363);
            if (_e379 > -8388608f) {
                let _e391 = f32(select(0i, select(select(i32(_e379), i32(-2147483648), (_e379 < bitcast<f32>(3472883712u))), 2147483647i, (_e379 > bitcast<f32>(1325400063u))), (_e379 == _e379)));
                if (_e391 > _e379) {
                    phi_605_ = 1f;
                } else {
                    phi_605_ = 0f;
                }
                let _e394 = phi_605_;
                if (_e379 < 8388608f) {
                    phi_610_ = (_e391 - _e394);
                    phi_611_ = false;
                } else {
                    phi_610_ = f32();
                    phi_611_ = true;
                }
                let _e397 = phi_610_;
                let _e399 = phi_611_;
                phi_612_ = _e397;
                phi_613_ = _e399;
            } else {
                phi_612_ = f32();
                phi_613_ = true;
            }
            let _e401 = phi_612_;
            let _e403 = phi_613_;
            if _e403 {
                phi_617_ = _e379;
            } else {
                phi_617_ = _e401;
            }
            let _e405 = phi_617_;
            let _e408 = ((f32(_e56.y) + 0.5f) + _e369);
            if (_e408 > -8388608f) {
                let _e420 = f32(select(0i, select(select(i32(_e408), i32(-2147483648), (_e408 < bitcast<f32>(3472883712u))), 2147483647i, (_e408 > bitcast<f32>(1325400063u))), (_e408 == _e408)));
                if (_e420 > _e408) {
                    phi_640_ = 1f;
                } else {
                    phi_640_ = 0f;
                }
                let _e423 = phi_640_;
                if (_e408 < 8388608f) {
                    phi_645_ = (_e420 - _e423);
                    phi_646_ = false;
                } else {
                    phi_645_ = f32();
                    phi_646_ = true;
                }
                let _e426 = phi_645_;
                let _e428 = phi_646_;
                phi_647_ = _e426;
                phi_648_ = _e428;
            } else {
                phi_647_ = f32();
                phi_648_ = true;
            }
            let _e430 = phi_647_;
            let _e432 = phi_648_;
            if _e432 {
                phi_652_ = _e408;
            } else {
                phi_652_ = _e430;
            }
            let _e434 = phi_652_;
            if (_e405 >= 0f) {
                if (_e434 >= 0f) {
                    if (_e405 < f32(_e373)) {
                        let _e440 = (_e434 < f32(_e375));
                        if (_e363 == 0f) {
                            phi_673_ = (_e369 == 0f);
                        } else {
                            phi_673_ = false;
                        }
                        let _e444 = phi_673_;
                        if _e440 {
                            phi_692_ = vec2<u32>(select(select(u32(_e405), 0u, (_e405 < bitcast<f32>(0u))), 4294967295u, (_e405 > bitcast<f32>(1333788671u))), select(select(u32(_e434), 0u, (_e434 < bitcast<f32>(0u))), 4294967295u, (_e434 > bitcast<f32>(1333788671u))));
                            phi_693_ = false;
                        } else {
                            phi_692_ = vec2<u32>();
                            phi_693_ = true;
                        }
                        let _e461 = phi_692_;
                        let _e463 = phi_693_;
                        phi_694_ = _e444;
                        phi_695_ = _e440;
                        phi_696_ = _e461;
                        phi_697_ = _e444;
                        phi_698_ = _e440;
                        phi_699_ = false;
                        phi_700_ = _e463;
                    } else {
                        phi_694_ = bool();
                        phi_695_ = bool();
                        phi_696_ = vec2<u32>();
                        phi_697_ = bool();
                        phi_698_ = bool();
                        phi_699_ = true;
                        phi_700_ = false;
                    }
                    let _e465 = phi_694_;
                    let _e467 = phi_695_;
                    let _e469 = phi_696_;
                    let _e471 = phi_697_;
                    let _e473 = phi_698_;
                    let _e475 = phi_699_;
                    let _e477 = phi_700_;
                    phi_701_ = _e465;
                    phi_702_ = _e467;
                    phi_703_ = _e469;
                    phi_704_ = _e471;
                    phi_705_ = _e473;
                    phi_706_ = _e475;
                    phi_707_ = _e477;
                } else {
                    phi_701_ = bool();
                    phi_702_ = bool();
                    phi_703_ = vec2<u32>();
                    phi_704_ = bool();
                    phi_705_ = bool();
                    phi_706_ = true;
                    phi_707_ = false;
                }
                let _e479 = phi_701_;
                let _e481 = phi_702_;
                let _e483 = phi_703_;
                let _e485 = phi_704_;
                let _e487 = phi_705_;
                let _e489 = phi_706_;
                let _e491 = phi_707_;
                phi_708_ = _e479;
                phi_709_ = _e481;
                phi_710_ = _e483;
                phi_711_ = _e485;
                phi_712_ = _e487;
                phi_713_ = _e489;
                phi_714_ = _e491;
            } else {
                phi_708_ = bool();
                phi_709_ = bool();
                phi_710_ = vec2<u32>();
                phi_711_ = bool();
                phi_712_ = bool();
                phi_713_ = true;
                phi_714_ = false;
            }
            let _e493 = phi_708_;
            let _e495 = phi_709_;
            let _e497 = phi_710_;
            let _e499 = phi_711_;
            let _e501 = phi_712_;
            let _e503 = phi_713_;
            let _e505 = phi_714_;
            if _e503 {
                if (_e363 == 0f) {
                    phi_723_ = (_e369 == 0f);
                } else {
                    phi_723_ = false;
                }
                let _e509 = phi_723_;
                phi_724_ = _e509;
                phi_725_ = false;
                phi_726_ = true;
            } else {
                phi_724_ = _e499;
                phi_725_ = _e501;
                phi_726_ = _e505;
            }
            let _e511 = phi_724_;
            let _e513 = phi_725_;
            let _e515 = phi_726_;
            if _e515 {
                phi_730_ = _e511;
                phi_731_ = _e513;
                phi_732_ = vec2<u32>(_e56.x, _e56.y);
            } else {
                phi_730_ = _e493;
                phi_731_ = _e495;
                phi_732_ = _e497;
            }
            let _e517 = phi_730_;
            let _e519 = phi_731_;
            let _e521 = phi_732_;
            let _e531 = lt_mask_Reprojection(vec2<u32>(_e521.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e538 = lt_mask_Reprojection(vec2<u32>(_e531.pixel.x, _e521.y), _e531.is_valid, _e531.has_moved);
            let _e542 = lt_mask_Reprojection(_e538.pixel, _e519, _e538.has_moved);
            let _e546 = lt_mask_Reprojection(_e542.pixel, _e542.is_valid, !(_e517));
            if _e519 {
                let _e549 = p.member.previous.eye;
                let _e557 = p.member.previous.forward;
                let _e566 = (((((_e88.x - _e549.x) * _e557.x) + ((_e88.y - _e549.y) * _e557.y)) + ((_e88.z - _e549.z) * _e557.z)) > 0f);
                let _e570 = lt_mask_Reprojection(_e546.pixel, _e566, _e546.has_moved);
                if _e566 {
                    let _e573 = p.member.previous.eye;
                    let _e581 = p.member.previous.forward;
                    let _e589 = ((((_e88.x - _e573.x) * _e581.x) + ((_e88.y - _e573.y) * _e581.y)) + ((_e88.z - _e573.z) * _e581.z));
                    let _e591 = ((_e521.y * _e85) + _e521.x);
                    if (_e591 < arrayLength((&last_depths.member))) {
                    } else {
                        return;
                    }
                    let _e595 = last_depths.member[(0u + _e591)];
                    let _e597 = p.member.depth_tolerance;
                    let _e600 = abs(_e589);
                    let _e601 = abs(_e595);
                    if ((bitcast<u32>(_e601) & 2147483647u) > 2139095040u) {
                        phi_815_ = true;
                    } else {
                        let _e605 = (_e601 > _e600);
                        if _e605 {
                        }
                        phi_815_ = _e605;
                    }
                    let _e607 = phi_815_;
                    if _e607 {
                        phi_819_ = _e601;
                    } else {
                        phi_819_ = _e600;
                    }
                    let _e609 = phi_819_;
                    phi_823_ = lt_mask_Reprojection(_e570.pixel, (abs((_e589 - _e595)) <= (_e597 * _e609)), _e570.has_moved);
                } else {
                    phi_823_ = _e570;
                }
                let _e617 = phi_823_;
                if _e617.is_valid {
                    let _e620 = p.member.flags;
                    phi_832_ = ((_e620 & 1u) != 0u);
                    phi_833_ = false;
                } else {
                    phi_832_ = bool();
                    phi_833_ = true;
                }
                let _e624 = phi_832_;
                let _e626 = phi_833_;
                phi_835_ = _e624;
                phi_836_ = _e617;
                phi_837_ = _e617;
                phi_838_ = _e626;
            } else {
                phi_835_ = bool();
                phi_836_ = lt_mask_Reprojection();
                phi_837_ = lt_mask_Reprojection(_e546.pixel, false, _e546.has_moved);
                phi_838_ = true;
            }
            let _e632 = phi_835_;
            let _e634 = phi_836_;
            let _e636 = phi_837_;
            let _e638 = phi_838_;
            if _e638 {
                phi_842_ = false;
                phi_843_ = _e636;
            } else {
                phi_842_ = _e632;
                phi_843_ = _e634;
            }
            let _e640 = phi_842_;
            let _e642 = phi_843_;
            let _e646 = lt_mask_Reprojection(_e642.pixel, _e640, _e642.has_moved);
            let _e648 = p.member.flags;
            if _e646.has_moved {
                let _e653 = p.member.flags;
                phi_857_ = ((_e653 & 4u) == 0u);
            } else {
                phi_857_ = false;
            }
            let _e657 = phi_857_;
            if ((_e648 & 2u) != 0u) {
                if false {
                    phi_870_ = bool();
                    phi_871_ = true;
                } else {
                    if true {
                        phi_868_ = !(_e657);
                        phi_869_ = false;
                    } else {
                        phi_868_ = bool();
                        phi_869_ = true;
                    }
                    let _e660 = phi_868_;
                    let _e662 = phi_869_;
                    phi_870_ = _e660;
                    phi_871_ = _e662;
                }
                let _e664 = phi_870_;
                let _e666 = phi_871_;
                phi_872_ = _e664;
                phi_873_ = _e666;
            } else {
                phi_872_ = bool();
                phi_873_ = true;
            }
            let _e668 = phi_872_;
            let _e670 = phi_873_;
            if _e670 {
                phi_877_ = false;
            } else {
                phi_877_ = _e668;
            }
            let _e672 = phi_877_;
            let _e673 = lt_mask_Neighbourhood(false, true);
            if _e212 {
                phi_882_ = _e672;
            } else {
                phi_882_ = false;
            }
            let _e675 = phi_882_;
            if _e675 {
                if _e640 {
                    if _e646.has_moved {
                        let _e678 = p.member.moving_pattern;
                        phi_897_ = _e678;
                    } else {
                        let _e680 = p.member.still_pattern;
                        phi_897_ = _e680;
                    }
                    let _e682 = phi_897_;
                    phi_899_ = 0u;
                    phi_902_ = _e673;
                    loop {
                        let _e684 = phi_899_;
                        let _e686 = phi_902_;
                        local_1 = _e686;
                        if (1u <= _e682) {
                            if (_e682 <= 4u) {
                                phi_914_ = false;
                            } else {
                                phi_914_ = true;
                            }
                            let _e690 = phi_914_;
                            phi_915_ = _e690;
                        } else {
                            phi_915_ = true;
                        }
                        let _e692 = phi_915_;
                        if _e692 {
                            switch bitcast<i32>(_e682) {
                                case 5: {
                                    phi_924_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_924_ = 25u;
                                    break;
                                }
                                case 7: {
                                    phi_924_ = 13u;
                                    break;
                                }
                                default: {
                                    phi_924_ = 9u;
                                    break;
                                }
                            }
                            let _e695 = phi_924_;
                            phi_925_ = _e695;
                        } else {
                            phi_925_ = 5u;
                        }
                        let _e697 = phi_925_;
                        let _e698 = (_e684 < _e697);
                        if _e698 {
                            let _e704 = p.member.frame;
                            let _e708 = p.member.current.size[0u];
                            let _e710 = p.member.current.size[1u];
                            switch bitcast<i32>(_e682) {
                                case 1: {
                                    let _e720 = lt_mask_pattern_plus(_e684);
                                    phi_1005_ = vec2<i32>(_e720.x, _e720.y);
                                    break;
                                }
                                case 2: {
                                    let _e724 = lt_mask_pattern_cross(_e684);
                                    phi_1005_ = vec2<i32>(_e724.x, _e724.y);
                                    break;
                                }
                                case 3: {
                                    let _e730 = lt_mask_pattern_plus_or_cross(_e684, ((_e646.pixel.x + _e646.pixel.y) & 1u));
                                    phi_1005_ = vec2<i32>(_e730.x, _e730.y);
                                    break;
                                }
                                case 4: {
                                    let _e735 = lt_mask_pattern_plus_or_cross(_e684, (_e704 & 1u));
                                    phi_1005_ = vec2<i32>(_e735.x, _e735.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e704 & 3u)) {
                                        case 0: {
                                            phi_985_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_985_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_985_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_985_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e746 = phi_985_;
                                    phi_1005_ = (_e746 + vec2<i32>(bitcast<i32>((_e684 & 1u)), bitcast<i32>(((_e684 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_1005_ = vec2<i32>((bitcast<i32>((_e684 % 5u)) - 2i), (bitcast<i32>(((_e684 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                case 7: {
                                    let _e763 = lt_mask_pattern_diamond(_e684);
                                    phi_1005_ = vec2<i32>(_e763.x, _e763.y);
                                    break;
                                }
                                default: {
                                    phi_1005_ = vec2<i32>((bitcast<i32>((_e684 % 3u)) - 1i), (bitcast<i32>(((_e684 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e768 = phi_1005_;
                            let _e771 = lt_mask_pattern_step_clamped(_e646.pixel.x, _e768.x, _e708);
                            let _e772 = lt_mask_pattern_step_clamped(_e646.pixel.y, _e768.y, _e710);
                            let _e774 = ((_e772 * _e85) + _e771);
                            if (_e774 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e778 = last_bits.member[(0u + _e774)];
                            if ((_e778 & 2u) == 0u) {
                                phi_1028_ = (_e778 & 1u);
                            } else {
                                phi_1028_ = (_e778 & 7u);
                            }
                            let _e784 = phi_1028_;
                            if _e686.any_expands {
                                phi_1054_ = true;
                            } else {
                                if ((_e784 & 2u) != 0u) {
                                    if (((_e784 & 4u) != 0u) != _e208) {
                                        phi_1045_ = false;
                                    } else {
                                        phi_1045_ = true;
                                    }
                                    let _e793 = phi_1045_;
                                    phi_1046_ = _e793;
                                } else {
                                    phi_1046_ = true;
                                }
                                let _e795 = phi_1046_;
                                if _e795 {
                                    phi_1053_ = (((_e784 & 1u) != 0u) != _e208);
                                } else {
                                    phi_1053_ = true;
                                }
                                let _e800 = phi_1053_;
                                phi_1054_ = _e800;
                            }
                            let _e802 = phi_1054_;
                            if _e686.all_remove {
                                if (((_e784 & 1u) != 0u) == _e208) {
                                    if ((_e784 & 2u) != 0u) {
                                        phi_1072_ = (((_e784 & 4u) != 0u) == _e208);
                                    } else {
                                        phi_1072_ = true;
                                    }
                                    let _e812 = phi_1072_;
                                    phi_1073_ = _e812;
                                } else {
                                    phi_1073_ = false;
                                }
                                let _e814 = phi_1073_;
                                phi_1074_ = _e814;
                            } else {
                                phi_1074_ = false;
                            }
                            let _e816 = phi_1074_;
                            phi_900_ = (_e684 + 1u);
                            phi_903_ = lt_mask_Neighbourhood(_e802, _e816);
                        } else {
                            phi_900_ = u32();
                            phi_903_ = lt_mask_Neighbourhood();
                        }
                        let _e820 = phi_900_;
                        let _e822 = phi_903_;
                        continue;
                        continuing {
                            phi_899_ = _e820;
                            phi_902_ = _e822;
                            break if !(_e698);
                        }
                    }
                    let _e1044 = local_1;
                    phi_1077_ = _e1044;
                } else {
                    phi_1077_ = _e673;
                }
                let _e825 = phi_1077_;
                phi_1078_ = _e825;
            } else {
                phi_1078_ = _e673;
            }
            let _e827 = phi_1078_;
            if (_e93 != 0.5f) {
                if _e640 {
                    if _e212 {
                        phi_1104_ = true;
                    } else {
                        if _e827.any_expands {
                            phi_1103_ = false;
                        } else {
                            phi_1103_ = true;
                        }
                        let _e832 = phi_1103_;
                        phi_1104_ = _e832;
                    }
                    let _e834 = phi_1104_;
                    if _e834 {
                        if _e212 {
                            if _e672 {
                                if _e827.all_remove {
                                    phi_1117_ = false;
                                } else {
                                    phi_1117_ = true;
                                }
                                let _e836 = phi_1117_;
                                phi_1118_ = _e836;
                            } else {
                                phi_1118_ = true;
                            }
                            let _e838 = phi_1118_;
                            phi_1119_ = _e838;
                        } else {
                            phi_1119_ = true;
                        }
                        let _e840 = phi_1119_;
                        if _e840 {
                            if _e212 {
                                phi_1126_ = 1u;
                            } else {
                                phi_1126_ = 0u;
                            }
                            let _e842 = phi_1126_;
                            phi_1127_ = _e842;
                        } else {
                            phi_1127_ = 5u;
                        }
                        let _e844 = phi_1127_;
                        phi_1128_ = _e844;
                    } else {
                        phi_1128_ = 4u;
                    }
                    let _e846 = phi_1128_;
                    phi_1129_ = _e846;
                } else {
                    phi_1129_ = 3u;
                }
                let _e848 = phi_1129_;
                phi_1130_ = _e848;
            } else {
                phi_1130_ = 2u;
            }
            let _e850 = phi_1130_;
            if !((_e850 == 0u)) {
                phi_1138_ = !((_e850 == 5u));
            } else {
                phi_1138_ = false;
            }
            let _e856 = phi_1138_;
            if _e856 {
                if _e208 {
                    phi_1146_ = (2u | 1u);
                } else {
                    phi_1146_ = 2u;
                }
                let _e859 = phi_1146_;
                if false {
                    phi_1151_ = (_e859 | 4u);
                } else {
                    phi_1151_ = _e859;
                }
                let _e862 = phi_1151_;
                phi_1156_ = _e862;
            } else {
                if _e208 {
                    phi_1155_ = 1u;
                } else {
                    phi_1155_ = 0u;
                }
                let _e864 = phi_1155_;
                phi_1156_ = _e864;
            }
            let _e866 = phi_1156_;
            if _e208 {
                phi_1160_ = 0f;
            } else {
                phi_1160_ = 1f;
            }
            let _e868 = phi_1160_;
            phi_1162_ = mask_Masked(_e868, _e866, _e856);
        }
        let _e871 = phi_1162_;
        visibility.member[_e77.first_primitive] = _e871.visibility;
        bits.member[_e77.first_primitive] = _e871.bits;
        let _e879 = samples.member[_e77.first_primitive].normal[0u];
        let _e881 = global[0u];
        if (_e879 == _e881) {
            let _e884 = samples.member[_e77.first_primitive].normal[1u];
            let _e886 = global[1u];
            if (_e884 == _e886) {
                let _e889 = samples.member[_e77.first_primitive].normal[2u];
                let _e891 = global[2u];
                phi_1190_ = (_e889 == _e891);
                phi_1191_ = false;
            } else {
                phi_1190_ = bool();
                phi_1191_ = true;
            }
            let _e894 = phi_1190_;
            let _e896 = phi_1191_;
            phi_1192_ = _e894;
            phi_1193_ = _e896;
        } else {
            phi_1192_ = bool();
            phi_1193_ = true;
        }
        let _e898 = phi_1192_;
        let _e900 = phi_1193_;
        if _e900 {
            phi_1197_ = false;
        } else {
            phi_1197_ = _e898;
        }
        let _e902 = phi_1197_;
        if !(_e902) {
            let _e905 = samples.member[_e77.first_primitive].position;
            let _e907 = p.member.current.eye;
            let _e918 = p.member.current.forward;
            phi_1225_ = ((((_e905.x - _e907.x) * _e918.x) + ((_e905.y - _e907.y) * _e918.y)) + ((_e905.z - _e907.z) * _e918.z));
        } else {
            phi_1225_ = 0f;
        }
        let _e928 = phi_1225_;
        depths.member[_e77.first_primitive] = _e928;
        phi_1228_ = _e871.needs_ray;
        phi_1229_ = _e77.first_primitive;
    } else {
        phi_1228_ = false;
        phi_1229_ = 0u;
    }
    let _e932 = phi_1228_;
    let _e934 = phi_1229_;
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e932 {
        let _e938 = atomicAdd((&shared_[0u]), 1u);
        phi_1240_ = _e938;
    } else {
        phi_1240_ = 0u;
    }
    let _e940 = phi_1240_;
    workgroupBarrier();
    if (_e57 == 0u) {
        let _e944 = atomicLoad((&shared_[0u]));
        let _e945 = atomicAdd((&list.member[3u]), _e944);
        atomicStore((&shared_[1u]), _e945);
    }
    workgroupBarrier();
    if _e932 {
        let _e948 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e948) + _e940)]), _e934);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
