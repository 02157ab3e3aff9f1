struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    layers_behind: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    grid: vec2<u32>,
}

struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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
    refresh: u32,
    expansion: u32,
    pad0_: u32,
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

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
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

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_177_: lt_mask_LightPlace;
    var phi_178_: bool;
    var phi_179_: lt_mask_LightPlace;
    var phi_180_: bool;
    var phi_185_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_177_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_178_ = false;
        } else {
            phi_177_ = lt_mask_LightPlace();
            phi_178_ = true;
        }
        let _e68 = phi_177_;
        let _e70 = phi_178_;
        phi_179_ = _e68;
        phi_180_ = _e70;
    } else {
        phi_179_ = lt_mask_LightPlace();
        phi_180_ = true;
    }
    let _e72 = phi_179_;
    let _e74 = phi_180_;
    if _e74 {
        phi_185_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_185_ = _e72;
    }
    let _e79 = phi_185_;
    return lt_mask_LightPlace(_e79.word, _e79.shift);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_203_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_203_ = vec2(0i);
            break;
        }
        case 1: {
            phi_203_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_203_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_203_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_203_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e64 = phi_203_;
    return vec2<i32>(_e64.x, _e64.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_221_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_221_ = vec2(0i);
            break;
        }
        case 1: {
            phi_221_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_221_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_221_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_221_ = vec2(1i);
            break;
        }
    }
    let _e64 = phi_221_;
    return vec2<i32>(_e64.x, _e64.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_240_: vec2<i32>;

    if (param_6 == 0u) {
        let _e58 = lt_mask_pattern_plus(param_5);
        phi_240_ = vec2<i32>(_e58.x, _e58.y);
    } else {
        let _e62 = lt_mask_pattern_cross(param_5);
        phi_240_ = vec2<i32>(_e62.x, _e62.y);
    }
    let _e67 = phi_240_;
    return vec2<i32>(_e67.x, _e67.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_265_: vec2<i32>;

    let _e56 = (param_7 % 13u);
    switch bitcast<i32>(_e56) {
        case 9: {
            phi_265_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_265_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_265_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_265_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_265_ = vec2<i32>((bitcast<i32>((_e56 % 3u)) - 1i), (bitcast<i32>(((_e56 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e71 = phi_265_;
    return vec2<i32>(_e71.x, _e71.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_286_: u32;
    var phi_287_: u32;

    let _e59 = (bitcast<i32>(param_8) + param_9);
    if (_e59 < 0i) {
        phi_287_ = 0u;
    } else {
        if (_e59 >= bitcast<i32>(param_10)) {
            phi_286_ = (param_10 - 1u);
        } else {
            phi_286_ = bitcast<u32>(_e59);
        }
        let _e66 = phi_286_;
        phi_287_ = _e66;
    }
    let _e68 = phi_287_;
    return _e68;
}

fn function_() {
    var phi_363_: bool;
    var phi_364_: bool;
    var phi_365_: bool;
    var phi_366_: bool;
    var phi_370_: bool;
    var phi_440_: bool;
    var phi_441_: bool;
    var phi_452_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_453_: bool;
    var phi_454_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_455_: bool;
    var phi_462_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_466_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_479_: bool;
    var phi_684_: f32;
    var phi_689_: f32;
    var phi_690_: bool;
    var phi_691_: f32;
    var phi_692_: bool;
    var phi_696_: f32;
    var phi_717_: f32;
    var phi_722_: f32;
    var phi_723_: bool;
    var phi_724_: f32;
    var phi_725_: bool;
    var phi_729_: f32;
    var phi_750_: bool;
    var phi_769_: vec2<u32>;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_773_: vec2<u32>;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_778_: bool;
    var phi_779_: bool;
    var phi_780_: vec2<u32>;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_786_: bool;
    var phi_787_: vec2<u32>;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_791_: bool;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_803_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_809_: vec2<u32>;
    var phi_848_: bool;
    var phi_849_: bool;
    var phi_851_: bool;
    var phi_852_: lt_mask_Reprojection;
    var phi_853_: lt_mask_Reprojection;
    var phi_854_: bool;
    var phi_858_: bool;
    var phi_859_: lt_mask_Reprojection;
    var phi_865_: bool;
    var phi_887_: u32;
    var phi_889_: u32;
    var phi_892_: lt_mask_Neighbourhood;
    var phi_904_: bool;
    var phi_905_: bool;
    var phi_914_: u32;
    var phi_915_: u32;
    var phi_975_: vec2<i32>;
    var phi_995_: vec2<i32>;
    var phi_1020_: u32;
    var phi_1039_: u32;
    var phi_1047_: u32;
    var phi_1073_: bool;
    var phi_1074_: bool;
    var phi_1075_: bool;
    var phi_1076_: bool;
    var phi_1077_: bool;
    var phi_1078_: bool;
    var phi_1079_: bool;
    var phi_1084_: bool;
    var phi_1085_: bool;
    var phi_1086_: bool;
    var phi_1087_: bool;
    var phi_1088_: bool;
    var phi_1089_: bool;
    var phi_1090_: bool;
    var phi_1091_: bool;
    var phi_1092_: bool;
    var phi_1107_: bool;
    var phi_1108_: bool;
    var phi_1115_: bool;
    var phi_1116_: bool;
    var phi_1117_: bool;
    var phi_1118_: bool;
    var phi_1119_: bool;
    var phi_1123_: bool;
    var phi_1124_: bool;
    var phi_1125_: bool;
    var phi_1129_: bool;
    var phi_1130_: bool;
    var phi_1134_: bool;
    var phi_1135_: bool;
    var phi_1153_: bool;
    var phi_1154_: bool;
    var phi_1155_: bool;
    var phi_890_: u32;
    var phi_893_: lt_mask_Neighbourhood;
    var phi_1158_: lt_mask_Neighbourhood;
    var phi_1159_: lt_mask_Neighbourhood;
    var phi_1160_: lt_mask_Neighbourhood;
    var phi_1192_: bool;
    var phi_1193_: bool;
    var phi_1215_: bool;
    var phi_1216_: bool;
    var phi_1217_: bool;
    var phi_1221_: bool;
    var phi_1243_: bool;
    var phi_1244_: bool;
    var phi_1257_: bool;
    var phi_1258_: bool;
    var phi_1259_: bool;
    var phi_1266_: u32;
    var phi_1267_: u32;
    var phi_1268_: u32;
    var phi_1269_: u32;
    var phi_1270_: u32;
    var phi_1271_: u32;
    var phi_1272_: u32;
    var phi_1284_: bool;
    var phi_1285_: bool;
    var phi_1286_: bool;
    var phi_1287_: bool;
    var phi_1291_: bool;
    var phi_1297_: bool;
    var phi_1305_: u32;
    var phi_1310_: u32;
    var phi_1319_: u32;
    var phi_1324_: u32;
    var phi_1328_: u32;
    var phi_1329_: u32;
    var phi_1330_: u32;
    var phi_1334_: f32;
    var phi_1336_: mask_Masked;
    var phi_1386_: bool;
    var phi_1387_: u32;
    var phi_1398_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e55 = id_1;
    let _e56 = local_2;
    let _e61 = arrayLength((&last_bits.member));
    let _e69 = p.member.current.size[0u];
    let _e71 = p.member.current.size[1u];
    let _e72 = lt_shaders_entry_pixel_index(_e55, _e69, _e71);
    if (bitcast<i32>(_e72.word) != 0i) {
        let _e79 = p.member.light.number;
        let _e80 = (_e79 * 3u);
        let _e82 = (_e80 % 32u);
        let _e84 = p.member.light.mask_words;
        let _e88 = p.member.current.size[0u];
        let _e91 = past.member[_e72.shift];
        let _e96 = visibility.member[_e72.shift];
        let _e102 = samples.member[_e72.shift].normal[0u];
        let _e104 = global[0u];
        if (_e102 == _e104) {
            let _e107 = samples.member[_e72.shift].normal[1u];
            let _e109 = global[1u];
            if (_e107 == _e109) {
                let _e112 = samples.member[_e72.shift].normal[2u];
                let _e114 = global[2u];
                phi_363_ = (_e112 == _e114);
                phi_364_ = false;
            } else {
                phi_363_ = bool();
                phi_364_ = true;
            }
            let _e117 = phi_363_;
            let _e119 = phi_364_;
            phi_365_ = _e117;
            phi_366_ = _e119;
        } else {
            phi_365_ = bool();
            phi_366_ = true;
        }
        let _e121 = phi_365_;
        let _e123 = phi_366_;
        if _e123 {
            phi_370_ = false;
        } else {
            phi_370_ = _e121;
        }
        let _e125 = phi_370_;
        if !(_e125) {
            let _e128 = samples.member[_e72.shift].position;
            let _e130 = p.member.light.place;
            let _e136 = p.member.light.place[3u];
            let _e143 = (_e130.x - (_e128.x * _e136));
            let _e144 = (_e130.y - (_e128.y * _e136));
            let _e145 = (_e130.z - (_e128.z * _e136));
            let _e147 = samples.member[_e72.shift].normal;
            if ((((_e147.x * _e143) + (_e147.y * _e144)) + (_e147.z * _e145)) > 0f) {
                let _e161 = (((_e143 * _e143) + (_e144 * _e144)) + (_e145 * _e145));
                let _e163 = p.member.light.axis;
                let _e175 = p.member.light.place[3u];
                if (_e175 == 0f) {
                    phi_441_ = true;
                } else {
                    let _e178 = p.member.light.range_squared;
                    if (_e161 <= _e178) {
                        let _e181 = p.member.light.cos_outer;
                        phi_440_ = (-((((_e143 * _e163.x) + (_e144 * _e163.y)) + (_e145 * _e163.z))) >= (_e181 * sqrt(_e161)));
                    } else {
                        phi_440_ = false;
                    }
                    let _e186 = phi_440_;
                    phi_441_ = _e186;
                }
                let _e188 = phi_441_;
                if _e188 {
                    let _e190 = samples.member[_e72.shift].flags;
                    let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e198.unnamed.visibility, false), _e198.unnamed_1);
                    phi_452_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e204.unnamed, ((_e190 & 1u) == 0u));
                    phi_453_ = false;
                } else {
                    phi_452_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_453_ = true;
                }
                let _e209 = phi_452_;
                let _e211 = phi_453_;
                phi_454_ = _e209;
                phi_455_ = _e211;
            } else {
                phi_454_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_455_ = true;
            }
            let _e213 = phi_454_;
            let _e215 = phi_455_;
            if _e215 {
                let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
                phi_462_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
            } else {
                phi_462_ = _e213;
            }
            let _e232 = phi_462_;
            phi_466_ = _e232;
        } else {
            let _e238 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e244 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e238.unnamed.visibility, false), _e238.unnamed_1);
            phi_466_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e244.unnamed, true);
        }
        let _e249 = phi_466_;
        if _e249.unnamed_1 {
            phi_1336_ = mask_Masked(_e249.unnamed.visibility, 0u, false);
        } else {
            let _e254 = (_e96 < 0.5f);
            if (_e96 > 0f) {
                phi_479_ = (_e96 < 1f);
            } else {
                phi_479_ = false;
            }
            let _e258 = phi_479_;
            let _e260 = samples.member[_e72.shift].position;
            let _e264 = p.member.previous.eye;
            let _e266 = (_e91.x - _e264.x);
            let _e268 = (_e91.y - _e264.y);
            let _e270 = (_e91.z - _e264.z);
            let _e272 = p.member.previous.forward;
            let _e280 = (((_e266 * _e272.x) + (_e268 * _e272.y)) + (_e270 * _e272.z));
            let _e282 = p.member.previous.right;
            let _e292 = p.member.previous.right;
            let _e307 = p.member.previous.up;
            let _e317 = p.member.previous.up;
            let _e332 = p.member.current.eye;
            let _e335 = (_e260.x - _e332.x);
            let _e338 = (_e260.y - _e332.y);
            let _e341 = (_e260.z - _e332.z);
            let _e343 = p.member.current.forward;
            let _e351 = (((_e335 * _e343.x) + (_e338 * _e343.y)) + (_e341 * _e343.z));
            let _e353 = p.member.current.right;
            let _e363 = p.member.current.right;
            let _e378 = p.member.current.up;
            let _e388 = p.member.current.up;
            let _e407 = p.member.current.size[0u];
            let _e409 = (((((((_e266 * _e282.x) + (_e268 * _e282.y)) + (_e270 * _e282.z)) / ((((_e292.x * _e292.x) + (_e292.y * _e292.y)) + (_e292.z * _e292.z)) * _e280)) - ((((_e335 * _e353.x) + (_e338 * _e353.y)) + (_e341 * _e353.z)) / ((((_e363.x * _e363.x) + (_e363.y * _e363.y)) + (_e363.z * _e363.z)) * _e351))) * 0.5f) * f32(_e407));
            let _e413 = p.member.current.size[1u];
            let _e415 = (((((((_e266 * _e307.x) + (_e268 * _e307.y)) + (_e270 * _e307.z)) / ((((_e317.x * _e317.x) + (_e317.y * _e317.y)) + (_e317.z * _e317.z)) * _e280)) - ((((_e335 * _e378.x) + (_e338 * _e378.y)) + (_e341 * _e378.z)) / ((((_e388.x * _e388.x) + (_e388.y * _e388.y)) + (_e388.z * _e388.z)) * _e351))) * -0.5f) * f32(_e413));
            let _e419 = p.member.current.grid[0u];
            let _e421 = p.member.current.grid[1u];
            let _e441 = p.member.current.size[0u];
            let _e443 = p.member.current.size[1u];
            let _e445 = ((f32(_e55.x) + ((f32((_e55.y & (_e421 - 1u))) + 0.5f) / f32(_e421))) + _e409);
            if (_e445 > -8388608f) {
                let _e457 = f32(select(0i, select(select(i32(_e445), i32(-2147483648), (_e445 < bitcast<f32>(3472883712u))), 2147483647i, (_e445 > bitcast<f32>(1325400063u))), (_e445 == _e445)));
                if (_e457 > _e445) {
                    phi_684_ = 1f;
                } else {
                    phi_684_ = 0f;
                }
                let _e460 = phi_684_;
                if (_e445 < 8388608f) {
                    phi_689_ = (_e457 - _e460);
                    phi_690_ = false;
                } else {
                    phi_689_ = f32();
                    phi_690_ = true;
                }
                let _e463 = phi_689_;
                let _e465 = phi_690_;
                phi_691_ = _e463;
                phi_692_ = _e465;
            } else {
                phi_691_ = f32();
                phi_692_ = true;
            }
            let _e467 = phi_691_;
            let _e469 = phi_692_;
            if _e469 {
                phi_696_ = _e445;
            } else {
                phi_696_ = _e467;
            }
            let _e471 = phi_696_;
            let _e472 = ((f32(_e55.y) + ((f32((_e55.x & (_e419 - 1u))) + 0.5f) / f32(_e419))) + _e415);
            if (_e472 > -8388608f) {
                let _e484 = f32(select(0i, select(select(i32(_e472), i32(-2147483648), (_e472 < bitcast<f32>(3472883712u))), 2147483647i, (_e472 > bitcast<f32>(1325400063u))), (_e472 == _e472)));
                if (_e484 > _e472) {
                    phi_717_ = 1f;
                } else {
                    phi_717_ = 0f;
                }
                let _e487 = phi_717_;
                if (_e472 < 8388608f) {
                    phi_722_ = (_e484 - _e487);
                    phi_723_ = false;
                } else {
                    phi_722_ = f32();
                    phi_723_ = true;
                }
                let _e490 = phi_722_;
                let _e492 = phi_723_;
                phi_724_ = _e490;
                phi_725_ = _e492;
            } else {
                phi_724_ = f32();
                phi_725_ = true;
            }
            let _e494 = phi_724_;
            let _e496 = phi_725_;
            if _e496 {
                phi_729_ = _e472;
            } else {
                phi_729_ = _e494;
            }
            let _e498 = phi_729_;
            if (_e471 >= 0f) {
                if (_e498 >= 0f) {
                    if (_e471 < f32(_e441)) {
                        let _e504 = (_e498 < f32(_e443));
                        if (_e409 == 0f) {
                            phi_750_ = (_e415 == 0f);
                        } else {
                            phi_750_ = false;
                        }
                        let _e508 = phi_750_;
                        if _e504 {
                            phi_769_ = vec2<u32>(select(select(u32(_e471), 0u, (_e471 < bitcast<f32>(0u))), 4294967295u, (_e471 > bitcast<f32>(1333788671u))), select(select(u32(_e498), 0u, (_e498 < bitcast<f32>(0u))), 4294967295u, (_e498 > bitcast<f32>(1333788671u))));
                            phi_770_ = false;
                        } else {
                            phi_769_ = vec2<u32>();
                            phi_770_ = true;
                        }
                        let _e525 = phi_769_;
                        let _e527 = phi_770_;
                        phi_771_ = _e508;
                        phi_772_ = _e504;
                        phi_773_ = _e525;
                        phi_774_ = _e508;
                        phi_775_ = _e504;
                        phi_776_ = false;
                        phi_777_ = _e527;
                    } else {
                        phi_771_ = bool();
                        phi_772_ = bool();
                        phi_773_ = vec2<u32>();
                        phi_774_ = bool();
                        phi_775_ = bool();
                        phi_776_ = true;
                        phi_777_ = false;
                    }
                    let _e529 = phi_771_;
                    let _e531 = phi_772_;
                    let _e533 = phi_773_;
                    let _e535 = phi_774_;
                    let _e537 = phi_775_;
                    let _e539 = phi_776_;
                    let _e541 = phi_777_;
                    phi_778_ = _e529;
                    phi_779_ = _e531;
                    phi_780_ = _e533;
                    phi_781_ = _e535;
                    phi_782_ = _e537;
                    phi_783_ = _e539;
                    phi_784_ = _e541;
                } else {
                    phi_778_ = bool();
                    phi_779_ = bool();
                    phi_780_ = vec2<u32>();
                    phi_781_ = bool();
                    phi_782_ = bool();
                    phi_783_ = true;
                    phi_784_ = false;
                }
                let _e543 = phi_778_;
                let _e545 = phi_779_;
                let _e547 = phi_780_;
                let _e549 = phi_781_;
                let _e551 = phi_782_;
                let _e553 = phi_783_;
                let _e555 = phi_784_;
                phi_785_ = _e543;
                phi_786_ = _e545;
                phi_787_ = _e547;
                phi_788_ = _e549;
                phi_789_ = _e551;
                phi_790_ = _e553;
                phi_791_ = _e555;
            } else {
                phi_785_ = bool();
                phi_786_ = bool();
                phi_787_ = vec2<u32>();
                phi_788_ = bool();
                phi_789_ = bool();
                phi_790_ = true;
                phi_791_ = false;
            }
            let _e557 = phi_785_;
            let _e559 = phi_786_;
            let _e561 = phi_787_;
            let _e563 = phi_788_;
            let _e565 = phi_789_;
            let _e567 = phi_790_;
            let _e569 = phi_791_;
            if _e567 {
                if (_e409 == 0f) {
                    phi_800_ = (_e415 == 0f);
                } else {
                    phi_800_ = false;
                }
                let _e573 = phi_800_;
                phi_801_ = _e573;
                phi_802_ = false;
                phi_803_ = true;
            } else {
                phi_801_ = _e563;
                phi_802_ = _e565;
                phi_803_ = _e569;
            }
            let _e575 = phi_801_;
            let _e577 = phi_802_;
            let _e579 = phi_803_;
            if _e579 {
                phi_807_ = _e575;
                phi_808_ = _e577;
                phi_809_ = vec2<u32>(_e55.x, _e55.y);
            } else {
                phi_807_ = _e557;
                phi_808_ = _e559;
                phi_809_ = _e561;
            }
            let _e581 = phi_807_;
            let _e583 = phi_808_;
            let _e585 = phi_809_;
            let _e595 = lt_mask_Reprojection(vec2<u32>(_e585.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e602 = lt_mask_Reprojection(vec2<u32>(_e595.pixel.x, _e585.y), _e595.is_valid, _e595.has_moved);
            let _e606 = lt_mask_Reprojection(_e602.pixel, _e583, _e602.has_moved);
            let _e610 = lt_mask_Reprojection(_e606.pixel, _e606.is_valid, !(_e581));
            if _e583 {
                let _e613 = p.member.previous.eye;
                let _e621 = p.member.previous.forward;
                let _e630 = (((((_e91.x - _e613.x) * _e621.x) + ((_e91.y - _e613.y) * _e621.y)) + ((_e91.z - _e613.z) * _e621.z)) > 0f);
                let _e634 = lt_mask_Reprojection(_e610.pixel, _e630, _e610.has_moved);
                if _e630 {
                    let _e636 = p.member.flags;
                    phi_848_ = ((_e636 & 1u) != 0u);
                    phi_849_ = false;
                } else {
                    phi_848_ = bool();
                    phi_849_ = true;
                }
                let _e640 = phi_848_;
                let _e642 = phi_849_;
                phi_851_ = _e640;
                phi_852_ = _e634;
                phi_853_ = _e634;
                phi_854_ = _e642;
            } else {
                phi_851_ = bool();
                phi_852_ = lt_mask_Reprojection();
                phi_853_ = lt_mask_Reprojection(_e610.pixel, false, _e610.has_moved);
                phi_854_ = true;
            }
            let _e648 = phi_851_;
            let _e650 = phi_852_;
            let _e652 = phi_853_;
            let _e654 = phi_854_;
            if _e654 {
                phi_858_ = false;
                phi_859_ = _e652;
            } else {
                phi_858_ = _e648;
                phi_859_ = _e650;
            }
            let _e656 = phi_858_;
            let _e658 = phi_859_;
            let _e662 = lt_mask_Reprojection(_e658.pixel, _e656, _e658.has_moved);
            let _e663 = lt_mask_Neighbourhood(false, true);
            if _e258 {
                phi_865_ = false;
            } else {
                phi_865_ = true;
            }
            let _e665 = phi_865_;
            if _e665 {
                if _e656 {
                    if ((0u & 2u) != 0u) {
                        phi_1158_ = _e663;
                    } else {
                        let _e669 = p.member.expansion;
                        if _e662.has_moved {
                            let _e672 = p.member.moving_pattern;
                            phi_887_ = _e672;
                        } else {
                            let _e674 = p.member.still_pattern;
                            phi_887_ = _e674;
                        }
                        let _e676 = phi_887_;
                        phi_889_ = 0u;
                        phi_892_ = _e663;
                        loop {
                            let _e678 = phi_889_;
                            let _e680 = phi_892_;
                            local_1 = _e680;
                            if (1u <= _e676) {
                                if (_e676 <= 4u) {
                                    phi_904_ = false;
                                } else {
                                    phi_904_ = true;
                                }
                                let _e684 = phi_904_;
                                phi_905_ = _e684;
                            } else {
                                phi_905_ = true;
                            }
                            let _e686 = phi_905_;
                            if _e686 {
                                switch bitcast<i32>(_e676) {
                                    case 5: {
                                        phi_914_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_914_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_914_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_914_ = 9u;
                                        break;
                                    }
                                }
                                let _e689 = phi_914_;
                                phi_915_ = _e689;
                            } else {
                                phi_915_ = 5u;
                            }
                            let _e691 = phi_915_;
                            let _e692 = (_e678 < _e691);
                            if _e692 {
                                let _e698 = p.member.frame;
                                let _e702 = p.member.current.size[0u];
                                let _e704 = p.member.current.size[1u];
                                switch bitcast<i32>(_e676) {
                                    case 1: {
                                        let _e714 = lt_mask_pattern_plus(_e678);
                                        phi_995_ = vec2<i32>(_e714.x, _e714.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e718 = lt_mask_pattern_cross(_e678);
                                        phi_995_ = vec2<i32>(_e718.x, _e718.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e724 = lt_mask_pattern_plus_or_cross(_e678, ((_e662.pixel.x + _e662.pixel.y) & 1u));
                                        phi_995_ = vec2<i32>(_e724.x, _e724.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e729 = lt_mask_pattern_plus_or_cross(_e678, (_e698 & 1u));
                                        phi_995_ = vec2<i32>(_e729.x, _e729.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e698 & 3u)) {
                                            case 0: {
                                                phi_975_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_975_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_975_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_975_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e740 = phi_975_;
                                        phi_995_ = (_e740 + vec2<i32>(bitcast<i32>((_e678 & 1u)), bitcast<i32>(((_e678 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_995_ = vec2<i32>((bitcast<i32>((_e678 % 5u)) - 2i), (bitcast<i32>(((_e678 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e757 = lt_mask_pattern_diamond(_e678);
                                        phi_995_ = vec2<i32>(_e757.x, _e757.y);
                                        break;
                                    }
                                    default: {
                                        phi_995_ = vec2<i32>((bitcast<i32>((_e678 % 3u)) - 1i), (bitcast<i32>(((_e678 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e762 = phi_995_;
                                let _e765 = lt_mask_pattern_step_clamped(_e662.pixel.x, _e762.x, _e702);
                                let _e766 = lt_mask_pattern_step_clamped(_e662.pixel.y, _e762.y, _e704);
                                let _e770 = ((((_e766 * _e88) + _e765) * _e84) + (_e80 / 32u));
                                if (_e82 > 29u) {
                                    let _e772 = (_e770 + 1u);
                                    if (_e772 < _e61) {
                                    } else {
                                        return;
                                    }
                                    let _e776 = last_bits.member[(0u + _e772)];
                                    phi_1020_ = _e776;
                                } else {
                                    phi_1020_ = 0u;
                                }
                                let _e778 = phi_1020_;
                                if (_e770 < _e61) {
                                } else {
                                    return;
                                }
                                let _e782 = last_bits.member[(0u + _e770)];
                                let _e785 = (_e782 >> bitcast<u32>((_e82 & 31u)));
                                if (_e82 > 29u) {
                                    phi_1039_ = (_e785 | (_e778 << bitcast<u32>(((32u - _e82) & 31u))));
                                } else {
                                    phi_1039_ = _e785;
                                }
                                let _e793 = phi_1039_;
                                if ((_e793 & 2u) == 0u) {
                                    phi_1047_ = (_e793 & 1u);
                                } else {
                                    phi_1047_ = (_e793 & 7u);
                                }
                                let _e799 = phi_1047_;
                                if _e680.any_expands {
                                    phi_1135_ = true;
                                } else {
                                    if ((_e799 & 2u) != 0u) {
                                        let _e806 = (((_e799 & 4u) != 0u) != _e254);
                                        switch bitcast<i32>(_e669) {
                                            case 1: {
                                                phi_1075_ = bool();
                                                phi_1076_ = false;
                                                phi_1077_ = true;
                                                phi_1078_ = false;
                                                phi_1079_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e806 {
                                                    phi_1073_ = (((_e799 & 4u) != 0u) != ((_e799 & 1u) != 0u));
                                                    phi_1074_ = false;
                                                } else {
                                                    phi_1073_ = bool();
                                                    phi_1074_ = true;
                                                }
                                                let _e814 = phi_1073_;
                                                let _e816 = phi_1074_;
                                                phi_1075_ = _e814;
                                                phi_1076_ = false;
                                                phi_1077_ = false;
                                                phi_1078_ = _e816;
                                                phi_1079_ = _e806;
                                                break;
                                            }
                                            default: {
                                                phi_1075_ = bool();
                                                phi_1076_ = true;
                                                phi_1077_ = false;
                                                phi_1078_ = false;
                                                phi_1079_ = false;
                                                break;
                                            }
                                        }
                                        let _e818 = phi_1075_;
                                        let _e820 = phi_1076_;
                                        let _e822 = phi_1077_;
                                        let _e824 = phi_1078_;
                                        let _e826 = phi_1079_;
                                        phi_1087_ = _e806;
                                        phi_1088_ = _e818;
                                        phi_1089_ = _e820;
                                        phi_1090_ = _e822;
                                        phi_1091_ = _e824;
                                        phi_1092_ = _e826;
                                    } else {
                                        switch bitcast<i32>(_e669) {
                                            case 1: {
                                                phi_1084_ = false;
                                                phi_1085_ = true;
                                                phi_1086_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1084_ = false;
                                                phi_1085_ = false;
                                                phi_1086_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1084_ = true;
                                                phi_1085_ = false;
                                                phi_1086_ = false;
                                                break;
                                            }
                                        }
                                        let _e829 = phi_1084_;
                                        let _e831 = phi_1085_;
                                        let _e833 = phi_1086_;
                                        phi_1087_ = false;
                                        phi_1088_ = bool();
                                        phi_1089_ = _e829;
                                        phi_1090_ = _e831;
                                        phi_1091_ = _e833;
                                        phi_1092_ = false;
                                    }
                                    let _e835 = phi_1087_;
                                    let _e837 = phi_1088_;
                                    let _e839 = phi_1089_;
                                    let _e841 = phi_1090_;
                                    let _e843 = phi_1091_;
                                    let _e845 = phi_1092_;
                                    if _e839 {
                                        if ((_e799 & 2u) != 0u) {
                                            if (((_e799 & 4u) != 0u) != _e254) {
                                                phi_1107_ = false;
                                            } else {
                                                phi_1107_ = true;
                                            }
                                            let _e852 = phi_1107_;
                                            phi_1108_ = _e852;
                                        } else {
                                            phi_1108_ = true;
                                        }
                                        let _e854 = phi_1108_;
                                        if _e854 {
                                            phi_1115_ = (((_e799 & 1u) != 0u) != _e254);
                                        } else {
                                            phi_1115_ = true;
                                        }
                                        let _e859 = phi_1115_;
                                        phi_1116_ = _e859;
                                        phi_1117_ = false;
                                        phi_1118_ = false;
                                        phi_1119_ = false;
                                    } else {
                                        phi_1116_ = bool();
                                        phi_1117_ = _e841;
                                        phi_1118_ = _e843;
                                        phi_1119_ = _e845;
                                    }
                                    let _e861 = phi_1116_;
                                    let _e863 = phi_1117_;
                                    let _e865 = phi_1118_;
                                    let _e867 = phi_1119_;
                                    if _e863 {
                                        phi_1123_ = _e835;
                                        phi_1124_ = false;
                                        phi_1125_ = false;
                                    } else {
                                        phi_1123_ = _e861;
                                        phi_1124_ = _e865;
                                        phi_1125_ = _e867;
                                    }
                                    let _e869 = phi_1123_;
                                    let _e871 = phi_1124_;
                                    let _e873 = phi_1125_;
                                    if _e871 {
                                        phi_1129_ = false;
                                        phi_1130_ = true;
                                    } else {
                                        phi_1129_ = _e837;
                                        phi_1130_ = _e873;
                                    }
                                    let _e875 = phi_1129_;
                                    let _e877 = phi_1130_;
                                    if _e877 {
                                        phi_1134_ = _e875;
                                    } else {
                                        phi_1134_ = _e869;
                                    }
                                    let _e879 = phi_1134_;
                                    phi_1135_ = _e879;
                                }
                                let _e881 = phi_1135_;
                                if _e680.all_remove {
                                    if (((_e799 & 1u) != 0u) == _e254) {
                                        if ((_e799 & 2u) != 0u) {
                                            phi_1153_ = (((_e799 & 4u) != 0u) == _e254);
                                        } else {
                                            phi_1153_ = true;
                                        }
                                        let _e891 = phi_1153_;
                                        phi_1154_ = _e891;
                                    } else {
                                        phi_1154_ = false;
                                    }
                                    let _e893 = phi_1154_;
                                    phi_1155_ = _e893;
                                } else {
                                    phi_1155_ = false;
                                }
                                let _e895 = phi_1155_;
                                phi_890_ = (_e678 + 1u);
                                phi_893_ = lt_mask_Neighbourhood(_e881, _e895);
                            } else {
                                phi_890_ = u32();
                                phi_893_ = lt_mask_Neighbourhood();
                            }
                            let _e899 = phi_890_;
                            let _e901 = phi_893_;
                            continue;
                            continuing {
                                phi_889_ = _e899;
                                phi_892_ = _e901;
                                break if !(_e692);
                            }
                        }
                        let _e1190 = local_1;
                        phi_1158_ = _e1190;
                    }
                    let _e904 = phi_1158_;
                    phi_1159_ = _e904;
                } else {
                    phi_1159_ = _e663;
                }
                let _e906 = phi_1159_;
                phi_1160_ = _e906;
            } else {
                phi_1160_ = _e663;
            }
            let _e908 = phi_1160_;
            let _e911 = p.member.frame;
            let _e913 = p.member.refresh;
            if (_e913 == 0u) {
                phi_1193_ = false;
            } else {
                if (_e913 == 0u) {
                    return;
                }
                let _e922 = ((_e55.x + (_e55.y * (((_e913 * 5u) / 8u) | 1u))) + (_e911 % _e913));
                if (_e913 == 0u) {
                    phi_1192_ = (_e922 == 0u);
                } else {
                    if (_e913 == 0u) {
                        return;
                    }
                    phi_1192_ = ((_e922 % _e913) == 0u);
                }
                let _e929 = phi_1192_;
                phi_1193_ = _e929;
            }
            let _e931 = phi_1193_;
            if _e656 {
                if _e931 {
                    phi_1215_ = bool();
                } else {
                    phi_1215_ = ((0u & 2u) != 0u);
                }
                let _e937 = phi_1215_;
                phi_1216_ = _e937;
                phi_1217_ = _e931;
            } else {
                phi_1216_ = bool();
                phi_1217_ = true;
            }
            let _e939 = phi_1216_;
            let _e941 = phi_1217_;
            if _e941 {
                phi_1221_ = false;
            } else {
                phi_1221_ = _e939;
            }
            let _e943 = phi_1221_;
            if _e943 {
                phi_1272_ = 7u;
            } else {
                if (_e96 != 0.5f) {
                    if _e656 {
                        if _e931 {
                            phi_1269_ = 6u;
                        } else {
                            if _e258 {
                                phi_1244_ = true;
                            } else {
                                if _e908.any_expands {
                                    phi_1243_ = false;
                                } else {
                                    phi_1243_ = true;
                                }
                                let _e945 = phi_1243_;
                                phi_1244_ = _e945;
                            }
                            let _e947 = phi_1244_;
                            if _e947 {
                                if _e258 {
                                    if false {
                                        if _e908.all_remove {
                                            phi_1257_ = false;
                                        } else {
                                            phi_1257_ = true;
                                        }
                                        let _e949 = phi_1257_;
                                        phi_1258_ = _e949;
                                    } else {
                                        phi_1258_ = true;
                                    }
                                    let _e951 = phi_1258_;
                                    phi_1259_ = _e951;
                                } else {
                                    phi_1259_ = true;
                                }
                                let _e953 = phi_1259_;
                                if _e953 {
                                    if _e258 {
                                        phi_1266_ = 1u;
                                    } else {
                                        phi_1266_ = 0u;
                                    }
                                    let _e955 = phi_1266_;
                                    phi_1267_ = _e955;
                                } else {
                                    phi_1267_ = 5u;
                                }
                                let _e957 = phi_1267_;
                                phi_1268_ = _e957;
                            } else {
                                phi_1268_ = 4u;
                            }
                            let _e959 = phi_1268_;
                            phi_1269_ = _e959;
                        }
                        let _e961 = phi_1269_;
                        phi_1270_ = _e961;
                    } else {
                        phi_1270_ = 3u;
                    }
                    let _e963 = phi_1270_;
                    phi_1271_ = _e963;
                } else {
                    phi_1271_ = 2u;
                }
                let _e965 = phi_1271_;
                phi_1272_ = _e965;
            }
            let _e967 = phi_1272_;
            if !((_e967 == 0u)) {
                if !((_e967 == 5u)) {
                    phi_1284_ = !(_e943);
                    phi_1285_ = false;
                } else {
                    phi_1284_ = bool();
                    phi_1285_ = true;
                }
                let _e974 = phi_1284_;
                let _e976 = phi_1285_;
                phi_1286_ = _e974;
                phi_1287_ = _e976;
            } else {
                phi_1286_ = bool();
                phi_1287_ = true;
            }
            let _e978 = phi_1286_;
            let _e980 = phi_1287_;
            if _e980 {
                phi_1291_ = false;
            } else {
                phi_1291_ = _e978;
            }
            let _e982 = phi_1291_;
            if _e943 {
                phi_1297_ = ((0u & 4u) != 0u);
            } else {
                phi_1297_ = _e254;
            }
            let _e986 = phi_1297_;
            if _e982 {
                if _e254 {
                    phi_1305_ = (2u | 1u);
                } else {
                    phi_1305_ = 2u;
                }
                let _e989 = phi_1305_;
                if false {
                    phi_1310_ = (_e989 | 4u);
                } else {
                    phi_1310_ = _e989;
                }
                let _e992 = phi_1310_;
                phi_1330_ = _e992;
            } else {
                if (_e967 == 7u) {
                    if _e254 {
                        phi_1319_ = (2u | 1u);
                    } else {
                        phi_1319_ = 2u;
                    }
                    let _e996 = phi_1319_;
                    if _e986 {
                        phi_1324_ = (_e996 | 4u);
                    } else {
                        phi_1324_ = _e996;
                    }
                    let _e999 = phi_1324_;
                    phi_1329_ = _e999;
                } else {
                    if _e254 {
                        phi_1328_ = 1u;
                    } else {
                        phi_1328_ = 0u;
                    }
                    let _e1001 = phi_1328_;
                    phi_1329_ = _e1001;
                }
                let _e1003 = phi_1329_;
                phi_1330_ = _e1003;
            }
            let _e1005 = phi_1330_;
            if _e986 {
                phi_1334_ = 0f;
            } else {
                phi_1334_ = 1f;
            }
            let _e1007 = phi_1334_;
            phi_1336_ = mask_Masked(_e1007, _e1005, _e982);
        }
        let _e1010 = phi_1336_;
        visibility.member[_e72.shift] = _e1010.visibility;
        let _e1015 = p.member.light.number;
        let _e1016 = (_e1015 * 3u);
        let _e1018 = (_e1016 % 32u);
        let _e1020 = p.member.light.mask_words;
        let _e1022 = ((_e72.shift * _e1020) + (_e1016 / 32u));
        let _e1024 = bits.member[_e1022];
        bits.member[_e1022] = ((_e1024 & ~((7u << bitcast<u32>((_e1018 & 31u))))) | (_e1010.bits << bitcast<u32>((_e1018 & 31u))));
        if (_e1018 > 29u) {
            let _e1039 = bits.member[(_e1022 + 1u)];
            let _e1041 = (32u - _e1018);
            bits.member[(_e1022 + 1u)] = ((_e1039 & ~((7u >> bitcast<u32>((_e1041 & 31u))))) | (_e1010.bits >> bitcast<u32>((_e1041 & 31u))));
        }
        phi_1386_ = _e1010.needs_ray;
        phi_1387_ = _e72.shift;
    } else {
        phi_1386_ = false;
        phi_1387_ = 0u;
    }
    let _e1055 = phi_1386_;
    let _e1057 = phi_1387_;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1055 {
        let _e1061 = atomicAdd((&shared_[0u]), 1u);
        phi_1398_ = _e1061;
    } else {
        phi_1398_ = 0u;
    }
    let _e1063 = phi_1398_;
    workgroupBarrier();
    if (_e56 == 0u) {
        let _e1067 = atomicLoad((&shared_[0u]));
        let _e1068 = atomicAdd((&list.member[3u]), _e1067);
        atomicStore((&shared_[1u]), _e1068);
    }
    workgroupBarrier();
    if _e1055 {
        let _e1071 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1071) + _e1063)]), _e1057);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
