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
    member: array<vec4<f32>>,
}

struct type_47 {
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
var<storage, read_write> list: type_47;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(6) 
var<storage> past: type_42;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_163_: lt_bvh_traverse_Tree;
    var phi_164_: bool;
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_171_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_163_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_164_ = false;
        } else {
            phi_163_ = lt_bvh_traverse_Tree();
            phi_164_ = true;
        }
        let _e65 = phi_163_;
        let _e67 = phi_164_;
        phi_165_ = _e65;
        phi_166_ = _e67;
    } else {
        phi_165_ = lt_bvh_traverse_Tree();
        phi_166_ = true;
    }
    let _e69 = phi_165_;
    let _e71 = phi_166_;
    if _e71 {
        phi_171_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_171_ = _e69;
    }
    let _e76 = phi_171_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_189_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_189_ = vec2(0i);
            break;
        }
        case 1: {
            phi_189_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_189_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_189_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_189_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e61 = phi_189_;
    return vec2<i32>(_e61.x, _e61.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_207_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_207_ = vec2(0i);
            break;
        }
        case 1: {
            phi_207_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_207_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_207_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_207_ = vec2(1i);
            break;
        }
    }
    let _e61 = phi_207_;
    return vec2<i32>(_e61.x, _e61.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_226_: vec2<i32>;

    if (param_6 == 0u) {
        let _e55 = lt_mask_pattern_plus(param_5);
        phi_226_ = vec2<i32>(_e55.x, _e55.y);
    } else {
        let _e59 = lt_mask_pattern_cross(param_5);
        phi_226_ = vec2<i32>(_e59.x, _e59.y);
    }
    let _e64 = phi_226_;
    return vec2<i32>(_e64.x, _e64.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_251_: vec2<i32>;

    let _e53 = (param_7 % 13u);
    switch bitcast<i32>(_e53) {
        case 9: {
            phi_251_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_251_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_251_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_251_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_251_ = vec2<i32>((bitcast<i32>((_e53 % 3u)) - 1i), (bitcast<i32>(((_e53 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e68 = phi_251_;
    return vec2<i32>(_e68.x, _e68.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_272_: u32;
    var phi_273_: u32;

    let _e56 = (bitcast<i32>(param_8) + param_9);
    if (_e56 < 0i) {
        phi_273_ = 0u;
    } else {
        if (_e56 >= bitcast<i32>(param_10)) {
            phi_272_ = (param_10 - 1u);
        } else {
            phi_272_ = bitcast<u32>(_e56);
        }
        let _e63 = phi_272_;
        phi_273_ = _e63;
    }
    let _e65 = phi_273_;
    return _e65;
}

fn function_() {
    var phi_338_: bool;
    var phi_339_: bool;
    var phi_340_: bool;
    var phi_341_: bool;
    var phi_345_: bool;
    var phi_389_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_393_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_406_: bool;
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
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_761_: bool;
    var phi_762_: lt_mask_Reprojection;
    var phi_763_: lt_mask_Reprojection;
    var phi_764_: bool;
    var phi_768_: bool;
    var phi_769_: lt_mask_Reprojection;
    var phi_783_: bool;
    var phi_794_: bool;
    var phi_795_: bool;
    var phi_796_: bool;
    var phi_797_: bool;
    var phi_798_: bool;
    var phi_799_: bool;
    var phi_803_: bool;
    var phi_808_: bool;
    var phi_823_: u32;
    var phi_825_: u32;
    var phi_828_: lt_mask_Neighbourhood;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_850_: u32;
    var phi_851_: u32;
    var phi_911_: vec2<i32>;
    var phi_931_: vec2<i32>;
    var phi_954_: u32;
    var phi_971_: bool;
    var phi_972_: bool;
    var phi_979_: bool;
    var phi_980_: bool;
    var phi_998_: bool;
    var phi_999_: bool;
    var phi_1000_: bool;
    var phi_826_: u32;
    var phi_829_: lt_mask_Neighbourhood;
    var phi_1003_: lt_mask_Neighbourhood;
    var phi_1004_: lt_mask_Neighbourhood;
    var phi_1029_: bool;
    var phi_1030_: bool;
    var phi_1043_: bool;
    var phi_1044_: bool;
    var phi_1045_: bool;
    var phi_1052_: u32;
    var phi_1053_: u32;
    var phi_1054_: u32;
    var phi_1055_: u32;
    var phi_1056_: u32;
    var phi_1064_: bool;
    var phi_1072_: u32;
    var phi_1077_: u32;
    var phi_1081_: u32;
    var phi_1082_: u32;
    var phi_1086_: f32;
    var phi_1088_: mask_Masked;
    var phi_1094_: bool;
    var phi_1095_: u32;
    var phi_1106_: u32;
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
        let _e89 = p.member.light;
        let _e92 = samples.member[_e69.first_primitive].normal[0u];
        let _e94 = global[0u];
        if (_e92 == _e94) {
            let _e97 = samples.member[_e69.first_primitive].normal[1u];
            let _e99 = global[1u];
            if (_e97 == _e99) {
                let _e102 = samples.member[_e69.first_primitive].normal[2u];
                let _e104 = global[2u];
                phi_338_ = (_e102 == _e104);
                phi_339_ = false;
            } else {
                phi_338_ = bool();
                phi_339_ = true;
            }
            let _e107 = phi_338_;
            let _e109 = phi_339_;
            phi_340_ = _e107;
            phi_341_ = _e109;
        } else {
            phi_340_ = bool();
            phi_341_ = true;
        }
        let _e111 = phi_340_;
        let _e113 = phi_341_;
        if _e113 {
            phi_345_ = false;
        } else {
            phi_345_ = _e111;
        }
        let _e115 = phi_345_;
        if !(_e115) {
            let _e118 = samples.member[_e69.first_primitive].normal;
            let _e120 = samples.member[_e69.first_primitive].position;
            if ((((_e118.x * (_e89.x - (_e120.x * _e89.w))) + (_e118.y * (_e89.y - (_e120.y * _e89.w)))) + (_e118.z * (_e89.z - (_e120.z * _e89.w)))) > 0f) {
                let _e144 = samples.member[_e69.first_primitive].flags;
                let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e152.unnamed.visibility, false), _e152.unnamed_1);
                phi_389_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e158.unnamed, ((_e144 & 1u) == 0u));
            } else {
                let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
                phi_389_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, true);
            }
            let _e178 = phi_389_;
            phi_393_ = _e178;
        } else {
            let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e184.unnamed.visibility, false), _e184.unnamed_1);
            phi_393_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e190.unnamed, true);
        }
        let _e195 = phi_393_;
        if _e195.unnamed_1 {
            phi_1088_ = mask_Masked(_e195.unnamed.visibility, 0u, false);
        } else {
            let _e200 = (_e85 < 0.5f);
            if (_e85 > 0f) {
                phi_406_ = (_e85 < 1f);
            } else {
                phi_406_ = false;
            }
            let _e204 = phi_406_;
            let _e206 = samples.member[_e69.first_primitive].position;
            let _e210 = p.member.previous.eye;
            let _e212 = (_e80.x - _e210.x);
            let _e214 = (_e80.y - _e210.y);
            let _e216 = (_e80.z - _e210.z);
            let _e218 = p.member.previous.forward;
            let _e226 = (((_e212 * _e218.x) + (_e214 * _e218.y)) + (_e216 * _e218.z));
            let _e228 = p.member.previous.right;
            let _e238 = p.member.previous.right;
            let _e253 = p.member.previous.up;
            let _e263 = p.member.previous.up;
            let _e278 = p.member.current.eye;
            let _e281 = (_e206.x - _e278.x);
            let _e284 = (_e206.y - _e278.y);
            let _e287 = (_e206.z - _e278.z);
            let _e289 = p.member.current.forward;
            let _e297 = (((_e281 * _e289.x) + (_e284 * _e289.y)) + (_e287 * _e289.z));
            let _e299 = p.member.current.right;
            let _e309 = p.member.current.right;
            let _e324 = p.member.current.up;
            let _e334 = p.member.current.up;
            let _e353 = p.member.current.size[0u];
            let _e355 = (((((((_e212 * _e228.x) + (_e214 * _e228.y)) + (_e216 * _e228.z)) / ((((_e238.x * _e238.x) + (_e238.y * _e238.y)) + (_e238.z * _e238.z)) * _e226)) - ((((_e281 * _e299.x) + (_e284 * _e299.y)) + (_e287 * _e299.z)) / ((((_e309.x * _e309.x) + (_e309.y * _e309.y)) + (_e309.z * _e309.z)) * _e297))) * 0.5f) * f32(_e353));
            let _e359 = p.member.current.size[1u];
            let _e361 = (((((((_e212 * _e253.x) + (_e214 * _e253.y)) + (_e216 * _e253.z)) / ((((_e263.x * _e263.x) + (_e263.y * _e263.y)) + (_e263.z * _e263.z)) * _e226)) - ((((_e281 * _e324.x) + (_e284 * _e324.y)) + (_e287 * _e324.z)) / ((((_e334.x * _e334.x) + (_e334.y * _e334.y)) + (_e334.z * _e334.z)) * _e297))) * -0.5f) * f32(_e359));
            let _e365 = p.member.current.size[0u];
            let _e367 = p.member.current.size[1u];
            let _e371 = ((f32(_e52.x) + 0.5f) + _e355);
            if (_e371 > -8388608f) {
                let _e383 = f32(select(0i, select(select(i32(_e371), i32(-2147483648), (_e371 < bitcast<f32>(3472883712u))), 2147483647i, (_e371 > bitcast<f32>(1325400063u))), (_e371 == _e371)));
                if (_e383 > _e371) {
                    phi_592_ = 1f;
                } else {
                    phi_592_ = 0f;
                }
                let _e386 = phi_592_;
                if (_e371 < 8388608f) {
                    phi_597_ = (_e383 - _e386);
                    phi_598_ = false;
                } else {
                    phi_597_ = f32();
                    phi_598_ = true;
                }
                let _e389 = phi_597_;
                let _e391 = phi_598_;
                phi_599_ = _e389;
                phi_600_ = _e391;
            } else {
                phi_599_ = f32();
                phi_600_ = true;
            }
            let _e393 = phi_599_;
            let _e395 = phi_600_;
            if _e395 {
                phi_604_ = _e371;
            } else {
                phi_604_ = _e393;
            }
            let _e397 = phi_604_;
            let _e400 = ((f32(_e52.y) + 0.5f) + _e361);
            if (_e400 > -8388608f) {
                let _e412 = f32(select(0i, select(select(i32(_e400), i32(-2147483648), (_e400 < bitcast<f32>(3472883712u))), 2147483647i, (_e400 > bitcast<f32>(1325400063u))), (_e400 == _e400)));
                if (_e412 > _e400) {
                    phi_627_ = 1f;
                } else {
                    phi_627_ = 0f;
                }
                let _e415 = phi_627_;
                if (_e400 < 8388608f) {
                    phi_632_ = (_e412 - _e415);
                    phi_633_ = false;
                } else {
                    phi_632_ = f32();
                    phi_633_ = true;
                }
                let _e418 = phi_632_;
                let _e420 = phi_633_;
                phi_634_ = _e418;
                phi_635_ = _e420;
            } else {
                phi_634_ = f32();
                phi_635_ = true;
            }
            let _e422 = phi_634_;
            let _e424 = phi_635_;
            if _e424 {
                phi_639_ = _e400;
            } else {
                phi_639_ = _e422;
            }
            let _e426 = phi_639_;
            if (_e397 >= 0f) {
                if (_e426 >= 0f) {
                    if (_e397 < f32(_e365)) {
                        let _e432 = (_e426 < f32(_e367));
                        if (_e355 == 0f) {
                            phi_660_ = (_e361 == 0f);
                        } else {
                            phi_660_ = false;
                        }
                        let _e436 = phi_660_;
                        if _e432 {
                            phi_679_ = vec2<u32>(select(select(u32(_e397), 0u, (_e397 < bitcast<f32>(0u))), 4294967295u, (_e397 > bitcast<f32>(1333788671u))), select(select(u32(_e426), 0u, (_e426 < bitcast<f32>(0u))), 4294967295u, (_e426 > bitcast<f32>(1333788671u))));
                            phi_680_ = false;
                        } else {
                            phi_679_ = vec2<u32>();
                            phi_680_ = true;
                        }
                        let _e453 = phi_679_;
                        let _e455 = phi_680_;
                        phi_681_ = _e436;
                        phi_682_ = _e432;
                        phi_683_ = _e453;
                        phi_684_ = _e436;
                        phi_685_ = _e432;
                        phi_686_ = false;
                        phi_687_ = _e455;
                    } else {
                        phi_681_ = bool();
                        phi_682_ = bool();
                        phi_683_ = vec2<u32>();
                        phi_684_ = bool();
                        phi_685_ = bool();
                        phi_686_ = true;
                        phi_687_ = false;
                    }
                    let _e457 = phi_681_;
                    let _e459 = phi_682_;
                    let _e461 = phi_683_;
                    let _e463 = phi_684_;
                    let _e465 = phi_685_;
                    let _e467 = phi_686_;
                    let _e469 = phi_687_;
                    phi_688_ = _e457;
                    phi_689_ = _e459;
                    phi_690_ = _e461;
                    phi_691_ = _e463;
                    phi_692_ = _e465;
                    phi_693_ = _e467;
                    phi_694_ = _e469;
                } else {
                    phi_688_ = bool();
                    phi_689_ = bool();
                    phi_690_ = vec2<u32>();
                    phi_691_ = bool();
                    phi_692_ = bool();
                    phi_693_ = true;
                    phi_694_ = false;
                }
                let _e471 = phi_688_;
                let _e473 = phi_689_;
                let _e475 = phi_690_;
                let _e477 = phi_691_;
                let _e479 = phi_692_;
                let _e481 = phi_693_;
                let _e483 = phi_694_;
                phi_695_ = _e471;
                phi_696_ = _e473;
                phi_697_ = _e475;
                phi_698_ = _e477;
                phi_699_ = _e479;
                phi_700_ = _e481;
                phi_701_ = _e483;
            } else {
                phi_695_ = bool();
                phi_696_ = bool();
                phi_697_ = vec2<u32>();
                phi_698_ = bool();
                phi_699_ = bool();
                phi_700_ = true;
                phi_701_ = false;
            }
            let _e485 = phi_695_;
            let _e487 = phi_696_;
            let _e489 = phi_697_;
            let _e491 = phi_698_;
            let _e493 = phi_699_;
            let _e495 = phi_700_;
            let _e497 = phi_701_;
            if _e495 {
                if (_e355 == 0f) {
                    phi_710_ = (_e361 == 0f);
                } else {
                    phi_710_ = false;
                }
                let _e501 = phi_710_;
                phi_711_ = _e501;
                phi_712_ = false;
                phi_713_ = true;
            } else {
                phi_711_ = _e491;
                phi_712_ = _e493;
                phi_713_ = _e497;
            }
            let _e503 = phi_711_;
            let _e505 = phi_712_;
            let _e507 = phi_713_;
            if _e507 {
                phi_717_ = _e503;
                phi_718_ = _e505;
                phi_719_ = vec2<u32>(_e52.x, _e52.y);
            } else {
                phi_717_ = _e485;
                phi_718_ = _e487;
                phi_719_ = _e489;
            }
            let _e509 = phi_717_;
            let _e511 = phi_718_;
            let _e513 = phi_719_;
            let _e523 = lt_mask_Reprojection(vec2<u32>(_e513.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e530 = lt_mask_Reprojection(vec2<u32>(_e523.pixel.x, _e513.y), _e523.is_valid, _e523.has_moved);
            let _e534 = lt_mask_Reprojection(_e530.pixel, _e511, _e530.has_moved);
            let _e538 = lt_mask_Reprojection(_e534.pixel, _e534.is_valid, !(_e509));
            if _e511 {
                let _e541 = p.member.previous.eye;
                let _e549 = p.member.previous.forward;
                let _e558 = (((((_e80.x - _e541.x) * _e549.x) + ((_e80.y - _e541.y) * _e549.y)) + ((_e80.z - _e541.z) * _e549.z)) > 0f);
                let _e562 = lt_mask_Reprojection(_e538.pixel, _e558, _e538.has_moved);
                if _e558 {
                    let _e564 = p.member.flags;
                    phi_758_ = ((_e564 & 1u) != 0u);
                    phi_759_ = false;
                } else {
                    phi_758_ = bool();
                    phi_759_ = true;
                }
                let _e568 = phi_758_;
                let _e570 = phi_759_;
                phi_761_ = _e568;
                phi_762_ = _e562;
                phi_763_ = _e562;
                phi_764_ = _e570;
            } else {
                phi_761_ = bool();
                phi_762_ = lt_mask_Reprojection();
                phi_763_ = lt_mask_Reprojection(_e538.pixel, false, _e538.has_moved);
                phi_764_ = true;
            }
            let _e576 = phi_761_;
            let _e578 = phi_762_;
            let _e580 = phi_763_;
            let _e582 = phi_764_;
            if _e582 {
                phi_768_ = false;
                phi_769_ = _e580;
            } else {
                phi_768_ = _e576;
                phi_769_ = _e578;
            }
            let _e584 = phi_768_;
            let _e586 = phi_769_;
            let _e590 = lt_mask_Reprojection(_e586.pixel, _e584, _e586.has_moved);
            let _e592 = p.member.flags;
            if _e590.has_moved {
                let _e597 = p.member.flags;
                phi_783_ = ((_e597 & 4u) == 0u);
            } else {
                phi_783_ = false;
            }
            let _e601 = phi_783_;
            if ((_e592 & 2u) != 0u) {
                if false {
                    phi_796_ = bool();
                    phi_797_ = true;
                } else {
                    if true {
                        phi_794_ = !(_e601);
                        phi_795_ = false;
                    } else {
                        phi_794_ = bool();
                        phi_795_ = true;
                    }
                    let _e604 = phi_794_;
                    let _e606 = phi_795_;
                    phi_796_ = _e604;
                    phi_797_ = _e606;
                }
                let _e608 = phi_796_;
                let _e610 = phi_797_;
                phi_798_ = _e608;
                phi_799_ = _e610;
            } else {
                phi_798_ = bool();
                phi_799_ = true;
            }
            let _e612 = phi_798_;
            let _e614 = phi_799_;
            if _e614 {
                phi_803_ = false;
            } else {
                phi_803_ = _e612;
            }
            let _e616 = phi_803_;
            let _e617 = lt_mask_Neighbourhood(false, true);
            if _e204 {
                phi_808_ = _e616;
            } else {
                phi_808_ = true;
            }
            let _e619 = phi_808_;
            if _e619 {
                if _e584 {
                    if _e590.has_moved {
                        let _e622 = p.member.moving_pattern;
                        phi_823_ = _e622;
                    } else {
                        let _e624 = p.member.still_pattern;
                        phi_823_ = _e624;
                    }
                    let _e626 = phi_823_;
                    phi_825_ = 0u;
                    phi_828_ = _e617;
                    loop {
                        let _e628 = phi_825_;
                        let _e630 = phi_828_;
                        local_1 = _e630;
                        if (1u <= _e626) {
                            if (_e626 <= 4u) {
                                phi_840_ = false;
                            } else {
                                phi_840_ = true;
                            }
                            let _e634 = phi_840_;
                            phi_841_ = _e634;
                        } else {
                            phi_841_ = true;
                        }
                        let _e636 = phi_841_;
                        if _e636 {
                            switch bitcast<i32>(_e626) {
                                case 5: {
                                    phi_850_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_850_ = 25u;
                                    break;
                                }
                                case 7: {
                                    phi_850_ = 13u;
                                    break;
                                }
                                default: {
                                    phi_850_ = 9u;
                                    break;
                                }
                            }
                            let _e639 = phi_850_;
                            phi_851_ = _e639;
                        } else {
                            phi_851_ = 5u;
                        }
                        let _e641 = phi_851_;
                        let _e642 = (_e628 < _e641);
                        if _e642 {
                            let _e648 = p.member.frame;
                            let _e652 = p.member.current.size[0u];
                            let _e654 = p.member.current.size[1u];
                            switch bitcast<i32>(_e626) {
                                case 1: {
                                    let _e664 = lt_mask_pattern_plus(_e628);
                                    phi_931_ = vec2<i32>(_e664.x, _e664.y);
                                    break;
                                }
                                case 2: {
                                    let _e668 = lt_mask_pattern_cross(_e628);
                                    phi_931_ = vec2<i32>(_e668.x, _e668.y);
                                    break;
                                }
                                case 3: {
                                    let _e674 = lt_mask_pattern_plus_or_cross(_e628, ((_e590.pixel.x + _e590.pixel.y) & 1u));
                                    phi_931_ = vec2<i32>(_e674.x, _e674.y);
                                    break;
                                }
                                case 4: {
                                    let _e679 = lt_mask_pattern_plus_or_cross(_e628, (_e648 & 1u));
                                    phi_931_ = vec2<i32>(_e679.x, _e679.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e648 & 3u)) {
                                        case 0: {
                                            phi_911_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_911_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_911_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_911_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e690 = phi_911_;
                                    phi_931_ = (_e690 + vec2<i32>(bitcast<i32>((_e628 & 1u)), bitcast<i32>(((_e628 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_931_ = vec2<i32>((bitcast<i32>((_e628 % 5u)) - 2i), (bitcast<i32>(((_e628 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                case 7: {
                                    let _e707 = lt_mask_pattern_diamond(_e628);
                                    phi_931_ = vec2<i32>(_e707.x, _e707.y);
                                    break;
                                }
                                default: {
                                    phi_931_ = vec2<i32>((bitcast<i32>((_e628 % 3u)) - 1i), (bitcast<i32>(((_e628 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e712 = phi_931_;
                            let _e715 = lt_mask_pattern_step_clamped(_e590.pixel.x, _e712.x, _e652);
                            let _e716 = lt_mask_pattern_step_clamped(_e590.pixel.y, _e712.y, _e654);
                            let _e718 = ((_e716 * _e77) + _e715);
                            if (_e718 < arrayLength((&last_bits.member))) {
                            } else {
                                return;
                            }
                            let _e722 = last_bits.member[(0u + _e718)];
                            if ((_e722 & 2u) == 0u) {
                                phi_954_ = (_e722 & 1u);
                            } else {
                                phi_954_ = (_e722 & 7u);
                            }
                            let _e728 = phi_954_;
                            if _e630.any_expands {
                                phi_980_ = true;
                            } else {
                                if ((_e728 & 2u) != 0u) {
                                    if (((_e728 & 4u) != 0u) != _e200) {
                                        phi_971_ = false;
                                    } else {
                                        phi_971_ = true;
                                    }
                                    let _e737 = phi_971_;
                                    phi_972_ = _e737;
                                } else {
                                    phi_972_ = true;
                                }
                                let _e739 = phi_972_;
                                if _e739 {
                                    phi_979_ = (((_e728 & 1u) != 0u) != _e200);
                                } else {
                                    phi_979_ = true;
                                }
                                let _e744 = phi_979_;
                                phi_980_ = _e744;
                            }
                            let _e746 = phi_980_;
                            if _e630.all_remove {
                                if (((_e728 & 1u) != 0u) == _e200) {
                                    if ((_e728 & 2u) != 0u) {
                                        phi_998_ = (((_e728 & 4u) != 0u) == _e200);
                                    } else {
                                        phi_998_ = true;
                                    }
                                    let _e756 = phi_998_;
                                    phi_999_ = _e756;
                                } else {
                                    phi_999_ = false;
                                }
                                let _e758 = phi_999_;
                                phi_1000_ = _e758;
                            } else {
                                phi_1000_ = false;
                            }
                            let _e760 = phi_1000_;
                            phi_826_ = (_e628 + 1u);
                            phi_829_ = lt_mask_Neighbourhood(_e746, _e760);
                        } else {
                            phi_826_ = u32();
                            phi_829_ = lt_mask_Neighbourhood();
                        }
                        let _e764 = phi_826_;
                        let _e766 = phi_829_;
                        continue;
                        continuing {
                            phi_825_ = _e764;
                            phi_828_ = _e766;
                            break if !(_e642);
                        }
                    }
                    let _e931 = local_1;
                    phi_1003_ = _e931;
                } else {
                    phi_1003_ = _e617;
                }
                let _e769 = phi_1003_;
                phi_1004_ = _e769;
            } else {
                phi_1004_ = _e617;
            }
            let _e771 = phi_1004_;
            if (_e85 != 0.5f) {
                if _e584 {
                    if _e204 {
                        phi_1030_ = true;
                    } else {
                        if _e771.any_expands {
                            phi_1029_ = false;
                        } else {
                            phi_1029_ = true;
                        }
                        let _e776 = phi_1029_;
                        phi_1030_ = _e776;
                    }
                    let _e778 = phi_1030_;
                    if _e778 {
                        if _e204 {
                            if _e616 {
                                if _e771.all_remove {
                                    phi_1043_ = false;
                                } else {
                                    phi_1043_ = true;
                                }
                                let _e780 = phi_1043_;
                                phi_1044_ = _e780;
                            } else {
                                phi_1044_ = true;
                            }
                            let _e782 = phi_1044_;
                            phi_1045_ = _e782;
                        } else {
                            phi_1045_ = true;
                        }
                        let _e784 = phi_1045_;
                        if _e784 {
                            if _e204 {
                                phi_1052_ = 1u;
                            } else {
                                phi_1052_ = 0u;
                            }
                            let _e786 = phi_1052_;
                            phi_1053_ = _e786;
                        } else {
                            phi_1053_ = 5u;
                        }
                        let _e788 = phi_1053_;
                        phi_1054_ = _e788;
                    } else {
                        phi_1054_ = 4u;
                    }
                    let _e790 = phi_1054_;
                    phi_1055_ = _e790;
                } else {
                    phi_1055_ = 3u;
                }
                let _e792 = phi_1055_;
                phi_1056_ = _e792;
            } else {
                phi_1056_ = 2u;
            }
            let _e794 = phi_1056_;
            if !((_e794 == 0u)) {
                phi_1064_ = !((_e794 == 5u));
            } else {
                phi_1064_ = false;
            }
            let _e800 = phi_1064_;
            if _e800 {
                if _e200 {
                    phi_1072_ = (2u | 1u);
                } else {
                    phi_1072_ = 2u;
                }
                let _e803 = phi_1072_;
                if false {
                    phi_1077_ = (_e803 | 4u);
                } else {
                    phi_1077_ = _e803;
                }
                let _e806 = phi_1077_;
                phi_1082_ = _e806;
            } else {
                if _e200 {
                    phi_1081_ = 1u;
                } else {
                    phi_1081_ = 0u;
                }
                let _e808 = phi_1081_;
                phi_1082_ = _e808;
            }
            let _e810 = phi_1082_;
            if _e200 {
                phi_1086_ = 0f;
            } else {
                phi_1086_ = 1f;
            }
            let _e812 = phi_1086_;
            phi_1088_ = mask_Masked(_e812, _e810, _e800);
        }
        let _e815 = phi_1088_;
        visibility.member[_e69.first_primitive] = _e815.visibility;
        bits.member[_e69.first_primitive] = _e815.bits;
        phi_1094_ = _e815.needs_ray;
        phi_1095_ = _e69.first_primitive;
    } else {
        phi_1094_ = false;
        phi_1095_ = 0u;
    }
    let _e822 = phi_1094_;
    let _e824 = phi_1095_;
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e822 {
        let _e828 = atomicAdd((&shared_[0u]), 1u);
        phi_1106_ = _e828;
    } else {
        phi_1106_ = 0u;
    }
    let _e830 = phi_1106_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e834 = atomicLoad((&shared_[0u]));
        let _e835 = atomicAdd((&list.member[3u]), _e834);
        atomicStore((&shared_[1u]), _e835);
    }
    workgroupBarrier();
    if _e822 {
        let _e838 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e838) + _e830)]), _e824);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
