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

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_170_: lt_mask_LightPlace;
    var phi_171_: bool;
    var phi_172_: lt_mask_LightPlace;
    var phi_173_: bool;
    var phi_178_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_170_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_171_ = false;
        } else {
            phi_170_ = lt_mask_LightPlace();
            phi_171_ = true;
        }
        let _e67 = phi_170_;
        let _e69 = phi_171_;
        phi_172_ = _e67;
        phi_173_ = _e69;
    } else {
        phi_172_ = lt_mask_LightPlace();
        phi_173_ = true;
    }
    let _e71 = phi_172_;
    let _e73 = phi_173_;
    if _e73 {
        phi_178_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_178_ = _e71;
    }
    let _e78 = phi_178_;
    return lt_mask_LightPlace(_e78.word, _e78.shift);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_196_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_196_ = vec2(0i);
            break;
        }
        case 1: {
            phi_196_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_196_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_196_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_196_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e63 = phi_196_;
    return vec2<i32>(_e63.x, _e63.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_214_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_214_ = vec2(0i);
            break;
        }
        case 1: {
            phi_214_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_214_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_214_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_214_ = vec2(1i);
            break;
        }
    }
    let _e63 = phi_214_;
    return vec2<i32>(_e63.x, _e63.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_233_: vec2<i32>;

    if (param_6 == 0u) {
        let _e57 = lt_mask_pattern_plus(param_5);
        phi_233_ = vec2<i32>(_e57.x, _e57.y);
    } else {
        let _e61 = lt_mask_pattern_cross(param_5);
        phi_233_ = vec2<i32>(_e61.x, _e61.y);
    }
    let _e66 = phi_233_;
    return vec2<i32>(_e66.x, _e66.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_258_: vec2<i32>;

    let _e55 = (param_7 % 13u);
    switch bitcast<i32>(_e55) {
        case 9: {
            phi_258_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_258_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_258_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_258_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_258_ = vec2<i32>((bitcast<i32>((_e55 % 3u)) - 1i), (bitcast<i32>(((_e55 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e70 = phi_258_;
    return vec2<i32>(_e70.x, _e70.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_279_: u32;
    var phi_280_: u32;

    let _e58 = (bitcast<i32>(param_8) + param_9);
    if (_e58 < 0i) {
        phi_280_ = 0u;
    } else {
        if (_e58 >= bitcast<i32>(param_10)) {
            phi_279_ = (param_10 - 1u);
        } else {
            phi_279_ = bitcast<u32>(_e58);
        }
        let _e65 = phi_279_;
        phi_280_ = _e65;
    }
    let _e67 = phi_280_;
    return _e67;
}

fn function_() {
    var phi_352_: bool;
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_359_: bool;
    var phi_429_: bool;
    var phi_430_: bool;
    var phi_441_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_442_: bool;
    var phi_443_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_444_: bool;
    var phi_451_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_455_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_468_: bool;
    var phi_657_: f32;
    var phi_662_: f32;
    var phi_663_: bool;
    var phi_664_: f32;
    var phi_665_: bool;
    var phi_669_: f32;
    var phi_692_: f32;
    var phi_697_: f32;
    var phi_698_: bool;
    var phi_699_: f32;
    var phi_700_: bool;
    var phi_704_: f32;
    var phi_725_: bool;
    var phi_744_: vec2<u32>;
    var phi_745_: bool;
    var phi_746_: bool;
    var phi_747_: bool;
    var phi_748_: vec2<u32>;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_754_: bool;
    var phi_755_: vec2<u32>;
    var phi_756_: bool;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_762_: vec2<u32>;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_766_: bool;
    var phi_775_: bool;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_778_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: vec2<u32>;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_829_: bool;
    var phi_830_: lt_mask_Reprojection;
    var phi_831_: lt_mask_Reprojection;
    var phi_832_: bool;
    var phi_836_: bool;
    var phi_837_: lt_mask_Reprojection;
    var phi_843_: bool;
    var phi_865_: u32;
    var phi_867_: u32;
    var phi_870_: lt_mask_Neighbourhood;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_892_: u32;
    var phi_893_: u32;
    var phi_953_: vec2<i32>;
    var phi_973_: vec2<i32>;
    var phi_998_: u32;
    var phi_1017_: u32;
    var phi_1025_: u32;
    var phi_1051_: bool;
    var phi_1052_: bool;
    var phi_1053_: bool;
    var phi_1054_: bool;
    var phi_1055_: bool;
    var phi_1056_: bool;
    var phi_1057_: bool;
    var phi_1062_: bool;
    var phi_1063_: bool;
    var phi_1064_: bool;
    var phi_1065_: bool;
    var phi_1066_: bool;
    var phi_1067_: bool;
    var phi_1068_: bool;
    var phi_1069_: bool;
    var phi_1070_: bool;
    var phi_1085_: bool;
    var phi_1086_: bool;
    var phi_1093_: bool;
    var phi_1094_: bool;
    var phi_1095_: bool;
    var phi_1096_: bool;
    var phi_1097_: bool;
    var phi_1101_: bool;
    var phi_1102_: bool;
    var phi_1103_: bool;
    var phi_1107_: bool;
    var phi_1108_: bool;
    var phi_1112_: bool;
    var phi_1113_: bool;
    var phi_1131_: bool;
    var phi_1132_: bool;
    var phi_1133_: bool;
    var phi_868_: u32;
    var phi_871_: lt_mask_Neighbourhood;
    var phi_1136_: lt_mask_Neighbourhood;
    var phi_1137_: lt_mask_Neighbourhood;
    var phi_1138_: lt_mask_Neighbourhood;
    var phi_1170_: bool;
    var phi_1171_: bool;
    var phi_1193_: bool;
    var phi_1194_: bool;
    var phi_1195_: bool;
    var phi_1199_: bool;
    var phi_1221_: bool;
    var phi_1222_: bool;
    var phi_1235_: bool;
    var phi_1236_: bool;
    var phi_1237_: bool;
    var phi_1244_: u32;
    var phi_1245_: u32;
    var phi_1246_: u32;
    var phi_1247_: u32;
    var phi_1248_: u32;
    var phi_1249_: u32;
    var phi_1250_: u32;
    var phi_1262_: bool;
    var phi_1263_: bool;
    var phi_1264_: bool;
    var phi_1265_: bool;
    var phi_1269_: bool;
    var phi_1275_: bool;
    var phi_1283_: u32;
    var phi_1288_: u32;
    var phi_1297_: u32;
    var phi_1302_: u32;
    var phi_1306_: u32;
    var phi_1307_: u32;
    var phi_1308_: u32;
    var phi_1312_: f32;
    var phi_1314_: mask_Masked;
    var phi_1364_: bool;
    var phi_1365_: u32;
    var phi_1376_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e54 = id_1;
    let _e55 = local_2;
    let _e60 = arrayLength((&last_bits.member));
    let _e67 = p.member.current.size[0u];
    let _e69 = p.member.current.size[1u];
    let _e70 = lt_shaders_entry_pixel_index(_e54, _e67, _e69);
    if (bitcast<i32>(_e70.word) != 0i) {
        let _e77 = p.member.light.number;
        let _e78 = (_e77 * 3u);
        let _e80 = (_e78 % 32u);
        let _e82 = p.member.light.mask_words;
        let _e86 = p.member.current.size[0u];
        let _e89 = samples.member[_e70.shift].position;
        let _e91 = visibility.member[_e70.shift];
        let _e97 = samples.member[_e70.shift].normal[0u];
        let _e99 = global[0u];
        if (_e97 == _e99) {
            let _e102 = samples.member[_e70.shift].normal[1u];
            let _e104 = global[1u];
            if (_e102 == _e104) {
                let _e107 = samples.member[_e70.shift].normal[2u];
                let _e109 = global[2u];
                phi_352_ = (_e107 == _e109);
                phi_353_ = false;
            } else {
                phi_352_ = bool();
                phi_353_ = true;
            }
            let _e112 = phi_352_;
            let _e114 = phi_353_;
            phi_354_ = _e112;
            phi_355_ = _e114;
        } else {
            phi_354_ = bool();
            phi_355_ = true;
        }
        let _e116 = phi_354_;
        let _e118 = phi_355_;
        if _e118 {
            phi_359_ = false;
        } else {
            phi_359_ = _e116;
        }
        let _e120 = phi_359_;
        if !(_e120) {
            let _e123 = samples.member[_e70.shift].position;
            let _e125 = p.member.light.place;
            let _e131 = p.member.light.place[3u];
            let _e138 = (_e125.x - (_e123.x * _e131));
            let _e139 = (_e125.y - (_e123.y * _e131));
            let _e140 = (_e125.z - (_e123.z * _e131));
            let _e142 = samples.member[_e70.shift].normal;
            if ((((_e142.x * _e138) + (_e142.y * _e139)) + (_e142.z * _e140)) > 0f) {
                let _e156 = (((_e138 * _e138) + (_e139 * _e139)) + (_e140 * _e140));
                let _e158 = p.member.light.axis;
                let _e170 = p.member.light.place[3u];
                if (_e170 == 0f) {
                    phi_430_ = true;
                } else {
                    let _e173 = p.member.light.range_squared;
                    if (_e156 <= _e173) {
                        let _e176 = p.member.light.cos_outer;
                        phi_429_ = (-((((_e138 * _e158.x) + (_e139 * _e158.y)) + (_e140 * _e158.z))) >= (_e176 * sqrt(_e156)));
                    } else {
                        phi_429_ = false;
                    }
                    let _e181 = phi_429_;
                    phi_430_ = _e181;
                }
                let _e183 = phi_430_;
                if _e183 {
                    let _e185 = samples.member[_e70.shift].flags;
                    let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e193.unnamed.visibility, false), _e193.unnamed_1);
                    phi_441_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e199.unnamed, ((_e185 & 1u) == 0u));
                    phi_442_ = false;
                } else {
                    phi_441_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_442_ = true;
                }
                let _e204 = phi_441_;
                let _e206 = phi_442_;
                phi_443_ = _e204;
                phi_444_ = _e206;
            } else {
                phi_443_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_444_ = true;
            }
            let _e208 = phi_443_;
            let _e210 = phi_444_;
            if _e210 {
                let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e216.unnamed.visibility, false), _e216.unnamed_1);
                phi_451_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e222.unnamed, true);
            } else {
                phi_451_ = _e208;
            }
            let _e227 = phi_451_;
            phi_455_ = _e227;
        } else {
            let _e233 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e239 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e233.unnamed.visibility, false), _e233.unnamed_1);
            phi_455_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e239.unnamed, true);
        }
        let _e244 = phi_455_;
        if _e244.unnamed_1 {
            phi_1314_ = mask_Masked(_e244.unnamed.visibility, 0u, false);
        } else {
            let _e249 = (_e91 < 0.5f);
            if (_e91 > 0f) {
                phi_468_ = (_e91 < 1f);
            } else {
                phi_468_ = false;
            }
            let _e253 = phi_468_;
            let _e255 = samples.member[_e70.shift].position;
            let _e259 = p.member.previous.eye;
            let _e262 = (_e89.x - _e259.x);
            let _e265 = (_e89.y - _e259.y);
            let _e268 = (_e89.z - _e259.z);
            let _e270 = p.member.previous.forward;
            let _e278 = (((_e262 * _e270.x) + (_e265 * _e270.y)) + (_e268 * _e270.z));
            let _e280 = p.member.previous.right;
            let _e290 = p.member.previous.right;
            let _e305 = p.member.previous.up;
            let _e315 = p.member.previous.up;
            let _e330 = p.member.current.eye;
            let _e333 = (_e255.x - _e330.x);
            let _e336 = (_e255.y - _e330.y);
            let _e339 = (_e255.z - _e330.z);
            let _e341 = p.member.current.forward;
            let _e349 = (((_e333 * _e341.x) + (_e336 * _e341.y)) + (_e339 * _e341.z));
            let _e351 = p.member.current.right;
            let _e361 = p.member.current.right;
            let _e376 = p.member.current.up;
            let _e386 = p.member.current.up;
            let _e405 = p.member.current.size[0u];
            let _e407 = (((((((_e262 * _e280.x) + (_e265 * _e280.y)) + (_e268 * _e280.z)) / ((((_e290.x * _e290.x) + (_e290.y * _e290.y)) + (_e290.z * _e290.z)) * _e278)) - ((((_e333 * _e351.x) + (_e336 * _e351.y)) + (_e339 * _e351.z)) / ((((_e361.x * _e361.x) + (_e361.y * _e361.y)) + (_e361.z * _e361.z)) * _e349))) * 0.5f) * f32(_e405));
            let _e411 = p.member.current.size[1u];
            let _e413 = (((((((_e262 * _e305.x) + (_e265 * _e305.y)) + (_e268 * _e305.z)) / ((((_e315.x * _e315.x) + (_e315.y * _e315.y)) + (_e315.z * _e315.z)) * _e278)) - ((((_e333 * _e376.x) + (_e336 * _e376.y)) + (_e339 * _e376.z)) / ((((_e386.x * _e386.x) + (_e386.y * _e386.y)) + (_e386.z * _e386.z)) * _e349))) * -0.5f) * f32(_e411));
            let _e417 = p.member.current.size[0u];
            let _e419 = p.member.current.size[1u];
            let _e423 = ((f32(_e54.x) + 0.5f) + _e407);
            if (_e423 > -8388608f) {
                let _e435 = f32(select(0i, select(select(i32(_e423), i32(-2147483648), (_e423 < bitcast<f32>(3472883712u))), 2147483647i, (_e423 > bitcast<f32>(1325400063u))), (_e423 == _e423)));
                if (_e435 > _e423) {
                    phi_657_ = 1f;
                } else {
                    phi_657_ = 0f;
                }
                let _e438 = phi_657_;
                if (_e423 < 8388608f) {
                    phi_662_ = (_e435 - _e438);
                    phi_663_ = false;
                } else {
                    phi_662_ = f32();
                    phi_663_ = true;
                }
                let _e441 = phi_662_;
                let _e443 = phi_663_;
                phi_664_ = _e441;
                phi_665_ = _e443;
            } else {
                phi_664_ = f32();
                phi_665_ = true;
            }
            let _e445 = phi_664_;
            let _e447 = phi_665_;
            if _e447 {
                phi_669_ = _e423;
            } else {
                phi_669_ = _e445;
            }
            let _e449 = phi_669_;
            let _e452 = ((f32(_e54.y) + 0.5f) + _e413);
            if (_e452 > -8388608f) {
                let _e464 = f32(select(0i, select(select(i32(_e452), i32(-2147483648), (_e452 < bitcast<f32>(3472883712u))), 2147483647i, (_e452 > bitcast<f32>(1325400063u))), (_e452 == _e452)));
                if (_e464 > _e452) {
                    phi_692_ = 1f;
                } else {
                    phi_692_ = 0f;
                }
                let _e467 = phi_692_;
                if (_e452 < 8388608f) {
                    phi_697_ = (_e464 - _e467);
                    phi_698_ = false;
                } else {
                    phi_697_ = f32();
                    phi_698_ = true;
                }
                let _e470 = phi_697_;
                let _e472 = phi_698_;
                phi_699_ = _e470;
                phi_700_ = _e472;
            } else {
                phi_699_ = f32();
                phi_700_ = true;
            }
            let _e474 = phi_699_;
            let _e476 = phi_700_;
            if _e476 {
                phi_704_ = _e452;
            } else {
                phi_704_ = _e474;
            }
            let _e478 = phi_704_;
            if (_e449 >= 0f) {
                if (_e478 >= 0f) {
                    if (_e449 < f32(_e417)) {
                        let _e484 = (_e478 < f32(_e419));
                        if (_e407 == 0f) {
                            phi_725_ = (_e413 == 0f);
                        } else {
                            phi_725_ = false;
                        }
                        let _e488 = phi_725_;
                        if _e484 {
                            phi_744_ = vec2<u32>(select(select(u32(_e449), 0u, (_e449 < bitcast<f32>(0u))), 4294967295u, (_e449 > bitcast<f32>(1333788671u))), select(select(u32(_e478), 0u, (_e478 < bitcast<f32>(0u))), 4294967295u, (_e478 > bitcast<f32>(1333788671u))));
                            phi_745_ = false;
                        } else {
                            phi_744_ = vec2<u32>();
                            phi_745_ = true;
                        }
                        let _e505 = phi_744_;
                        let _e507 = phi_745_;
                        phi_746_ = _e488;
                        phi_747_ = _e484;
                        phi_748_ = _e505;
                        phi_749_ = _e488;
                        phi_750_ = _e484;
                        phi_751_ = false;
                        phi_752_ = _e507;
                    } else {
                        phi_746_ = bool();
                        phi_747_ = bool();
                        phi_748_ = vec2<u32>();
                        phi_749_ = bool();
                        phi_750_ = bool();
                        phi_751_ = true;
                        phi_752_ = false;
                    }
                    let _e509 = phi_746_;
                    let _e511 = phi_747_;
                    let _e513 = phi_748_;
                    let _e515 = phi_749_;
                    let _e517 = phi_750_;
                    let _e519 = phi_751_;
                    let _e521 = phi_752_;
                    phi_753_ = _e509;
                    phi_754_ = _e511;
                    phi_755_ = _e513;
                    phi_756_ = _e515;
                    phi_757_ = _e517;
                    phi_758_ = _e519;
                    phi_759_ = _e521;
                } else {
                    phi_753_ = bool();
                    phi_754_ = bool();
                    phi_755_ = vec2<u32>();
                    phi_756_ = bool();
                    phi_757_ = bool();
                    phi_758_ = true;
                    phi_759_ = false;
                }
                let _e523 = phi_753_;
                let _e525 = phi_754_;
                let _e527 = phi_755_;
                let _e529 = phi_756_;
                let _e531 = phi_757_;
                let _e533 = phi_758_;
                let _e535 = phi_759_;
                phi_760_ = _e523;
                phi_761_ = _e525;
                phi_762_ = _e527;
                phi_763_ = _e529;
                phi_764_ = _e531;
                phi_765_ = _e533;
                phi_766_ = _e535;
            } else {
                phi_760_ = bool();
                phi_761_ = bool();
                phi_762_ = vec2<u32>();
                phi_763_ = bool();
                phi_764_ = bool();
                phi_765_ = true;
                phi_766_ = false;
            }
            let _e537 = phi_760_;
            let _e539 = phi_761_;
            let _e541 = phi_762_;
            let _e543 = phi_763_;
            let _e545 = phi_764_;
            let _e547 = phi_765_;
            let _e549 = phi_766_;
            if _e547 {
                if (_e407 == 0f) {
                    phi_775_ = (_e413 == 0f);
                } else {
                    phi_775_ = false;
                }
                let _e553 = phi_775_;
                phi_776_ = _e553;
                phi_777_ = false;
                phi_778_ = true;
            } else {
                phi_776_ = _e543;
                phi_777_ = _e545;
                phi_778_ = _e549;
            }
            let _e555 = phi_776_;
            let _e557 = phi_777_;
            let _e559 = phi_778_;
            if _e559 {
                phi_782_ = _e555;
                phi_783_ = _e557;
                phi_784_ = vec2<u32>(_e54.x, _e54.y);
            } else {
                phi_782_ = _e537;
                phi_783_ = _e539;
                phi_784_ = _e541;
            }
            let _e561 = phi_782_;
            let _e563 = phi_783_;
            let _e565 = phi_784_;
            let _e575 = lt_mask_Reprojection(vec2<u32>(_e565.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e582 = lt_mask_Reprojection(vec2<u32>(_e575.pixel.x, _e565.y), _e575.is_valid, _e575.has_moved);
            let _e586 = lt_mask_Reprojection(_e582.pixel, _e563, _e582.has_moved);
            let _e590 = lt_mask_Reprojection(_e586.pixel, _e586.is_valid, !(_e561));
            if _e563 {
                let _e593 = p.member.previous.eye;
                let _e604 = p.member.previous.forward;
                let _e613 = (((((_e89.x - _e593.x) * _e604.x) + ((_e89.y - _e593.y) * _e604.y)) + ((_e89.z - _e593.z) * _e604.z)) > 0f);
                let _e617 = lt_mask_Reprojection(_e590.pixel, _e613, _e590.has_moved);
                if _e613 {
                    let _e619 = p.member.flags;
                    phi_826_ = ((_e619 & 1u) != 0u);
                    phi_827_ = false;
                } else {
                    phi_826_ = bool();
                    phi_827_ = true;
                }
                let _e623 = phi_826_;
                let _e625 = phi_827_;
                phi_829_ = _e623;
                phi_830_ = _e617;
                phi_831_ = _e617;
                phi_832_ = _e625;
            } else {
                phi_829_ = bool();
                phi_830_ = lt_mask_Reprojection();
                phi_831_ = lt_mask_Reprojection(_e590.pixel, false, _e590.has_moved);
                phi_832_ = true;
            }
            let _e631 = phi_829_;
            let _e633 = phi_830_;
            let _e635 = phi_831_;
            let _e637 = phi_832_;
            if _e637 {
                phi_836_ = false;
                phi_837_ = _e635;
            } else {
                phi_836_ = _e631;
                phi_837_ = _e633;
            }
            let _e639 = phi_836_;
            let _e641 = phi_837_;
            let _e645 = lt_mask_Reprojection(_e641.pixel, _e639, _e641.has_moved);
            let _e646 = lt_mask_Neighbourhood(false, true);
            if _e253 {
                phi_843_ = false;
            } else {
                phi_843_ = true;
            }
            let _e648 = phi_843_;
            if _e648 {
                if _e639 {
                    if ((0u & 2u) != 0u) {
                        phi_1136_ = _e646;
                    } else {
                        let _e652 = p.member.expansion;
                        if _e645.has_moved {
                            let _e655 = p.member.moving_pattern;
                            phi_865_ = _e655;
                        } else {
                            let _e657 = p.member.still_pattern;
                            phi_865_ = _e657;
                        }
                        let _e659 = phi_865_;
                        phi_867_ = 0u;
                        phi_870_ = _e646;
                        loop {
                            let _e661 = phi_867_;
                            let _e663 = phi_870_;
                            local_1 = _e663;
                            if (1u <= _e659) {
                                if (_e659 <= 4u) {
                                    phi_882_ = false;
                                } else {
                                    phi_882_ = true;
                                }
                                let _e667 = phi_882_;
                                phi_883_ = _e667;
                            } else {
                                phi_883_ = true;
                            }
                            let _e669 = phi_883_;
                            if _e669 {
                                switch bitcast<i32>(_e659) {
                                    case 5: {
                                        phi_892_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_892_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_892_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_892_ = 9u;
                                        break;
                                    }
                                }
                                let _e672 = phi_892_;
                                phi_893_ = _e672;
                            } else {
                                phi_893_ = 5u;
                            }
                            let _e674 = phi_893_;
                            let _e675 = (_e661 < _e674);
                            if _e675 {
                                let _e681 = p.member.frame;
                                let _e685 = p.member.current.size[0u];
                                let _e687 = p.member.current.size[1u];
                                switch bitcast<i32>(_e659) {
                                    case 1: {
                                        let _e697 = lt_mask_pattern_plus(_e661);
                                        phi_973_ = vec2<i32>(_e697.x, _e697.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e701 = lt_mask_pattern_cross(_e661);
                                        phi_973_ = vec2<i32>(_e701.x, _e701.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e707 = lt_mask_pattern_plus_or_cross(_e661, ((_e645.pixel.x + _e645.pixel.y) & 1u));
                                        phi_973_ = vec2<i32>(_e707.x, _e707.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e712 = lt_mask_pattern_plus_or_cross(_e661, (_e681 & 1u));
                                        phi_973_ = vec2<i32>(_e712.x, _e712.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e681 & 3u)) {
                                            case 0: {
                                                phi_953_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_953_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_953_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_953_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e723 = phi_953_;
                                        phi_973_ = (_e723 + vec2<i32>(bitcast<i32>((_e661 & 1u)), bitcast<i32>(((_e661 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_973_ = vec2<i32>((bitcast<i32>((_e661 % 5u)) - 2i), (bitcast<i32>(((_e661 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e740 = lt_mask_pattern_diamond(_e661);
                                        phi_973_ = vec2<i32>(_e740.x, _e740.y);
                                        break;
                                    }
                                    default: {
                                        phi_973_ = vec2<i32>((bitcast<i32>((_e661 % 3u)) - 1i), (bitcast<i32>(((_e661 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e745 = phi_973_;
                                let _e748 = lt_mask_pattern_step_clamped(_e645.pixel.x, _e745.x, _e685);
                                let _e749 = lt_mask_pattern_step_clamped(_e645.pixel.y, _e745.y, _e687);
                                let _e753 = ((((_e749 * _e86) + _e748) * _e82) + (_e78 / 32u));
                                if (_e80 > 29u) {
                                    let _e755 = (_e753 + 1u);
                                    if (_e755 < _e60) {
                                    } else {
                                        return;
                                    }
                                    let _e759 = last_bits.member[(0u + _e755)];
                                    phi_998_ = _e759;
                                } else {
                                    phi_998_ = 0u;
                                }
                                let _e761 = phi_998_;
                                if (_e753 < _e60) {
                                } else {
                                    return;
                                }
                                let _e765 = last_bits.member[(0u + _e753)];
                                let _e768 = (_e765 >> bitcast<u32>((_e80 & 31u)));
                                if (_e80 > 29u) {
                                    phi_1017_ = (_e768 | (_e761 << bitcast<u32>(((32u - _e80) & 31u))));
                                } else {
                                    phi_1017_ = _e768;
                                }
                                let _e776 = phi_1017_;
                                if ((_e776 & 2u) == 0u) {
                                    phi_1025_ = (_e776 & 1u);
                                } else {
                                    phi_1025_ = (_e776 & 7u);
                                }
                                let _e782 = phi_1025_;
                                if _e663.any_expands {
                                    phi_1113_ = true;
                                } else {
                                    if ((_e782 & 2u) != 0u) {
                                        let _e789 = (((_e782 & 4u) != 0u) != _e249);
                                        switch bitcast<i32>(_e652) {
                                            case 1: {
                                                phi_1053_ = bool();
                                                phi_1054_ = false;
                                                phi_1055_ = true;
                                                phi_1056_ = false;
                                                phi_1057_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e789 {
                                                    phi_1051_ = (((_e782 & 4u) != 0u) != ((_e782 & 1u) != 0u));
                                                    phi_1052_ = false;
                                                } else {
                                                    phi_1051_ = bool();
                                                    phi_1052_ = true;
                                                }
                                                let _e797 = phi_1051_;
                                                let _e799 = phi_1052_;
                                                phi_1053_ = _e797;
                                                phi_1054_ = false;
                                                phi_1055_ = false;
                                                phi_1056_ = _e799;
                                                phi_1057_ = _e789;
                                                break;
                                            }
                                            default: {
                                                phi_1053_ = bool();
                                                phi_1054_ = true;
                                                phi_1055_ = false;
                                                phi_1056_ = false;
                                                phi_1057_ = false;
                                                break;
                                            }
                                        }
                                        let _e801 = phi_1053_;
                                        let _e803 = phi_1054_;
                                        let _e805 = phi_1055_;
                                        let _e807 = phi_1056_;
                                        let _e809 = phi_1057_;
                                        phi_1065_ = _e789;
                                        phi_1066_ = _e801;
                                        phi_1067_ = _e803;
                                        phi_1068_ = _e805;
                                        phi_1069_ = _e807;
                                        phi_1070_ = _e809;
                                    } else {
                                        switch bitcast<i32>(_e652) {
                                            case 1: {
                                                phi_1062_ = false;
                                                phi_1063_ = true;
                                                phi_1064_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1062_ = false;
                                                phi_1063_ = false;
                                                phi_1064_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1062_ = true;
                                                phi_1063_ = false;
                                                phi_1064_ = false;
                                                break;
                                            }
                                        }
                                        let _e812 = phi_1062_;
                                        let _e814 = phi_1063_;
                                        let _e816 = phi_1064_;
                                        phi_1065_ = false;
                                        phi_1066_ = bool();
                                        phi_1067_ = _e812;
                                        phi_1068_ = _e814;
                                        phi_1069_ = _e816;
                                        phi_1070_ = false;
                                    }
                                    let _e818 = phi_1065_;
                                    let _e820 = phi_1066_;
                                    let _e822 = phi_1067_;
                                    let _e824 = phi_1068_;
                                    let _e826 = phi_1069_;
                                    let _e828 = phi_1070_;
                                    if _e822 {
                                        if ((_e782 & 2u) != 0u) {
                                            if (((_e782 & 4u) != 0u) != _e249) {
                                                phi_1085_ = false;
                                            } else {
                                                phi_1085_ = true;
                                            }
                                            let _e835 = phi_1085_;
                                            phi_1086_ = _e835;
                                        } else {
                                            phi_1086_ = true;
                                        }
                                        let _e837 = phi_1086_;
                                        if _e837 {
                                            phi_1093_ = (((_e782 & 1u) != 0u) != _e249);
                                        } else {
                                            phi_1093_ = true;
                                        }
                                        let _e842 = phi_1093_;
                                        phi_1094_ = _e842;
                                        phi_1095_ = false;
                                        phi_1096_ = false;
                                        phi_1097_ = false;
                                    } else {
                                        phi_1094_ = bool();
                                        phi_1095_ = _e824;
                                        phi_1096_ = _e826;
                                        phi_1097_ = _e828;
                                    }
                                    let _e844 = phi_1094_;
                                    let _e846 = phi_1095_;
                                    let _e848 = phi_1096_;
                                    let _e850 = phi_1097_;
                                    if _e846 {
                                        phi_1101_ = _e818;
                                        phi_1102_ = false;
                                        phi_1103_ = false;
                                    } else {
                                        phi_1101_ = _e844;
                                        phi_1102_ = _e848;
                                        phi_1103_ = _e850;
                                    }
                                    let _e852 = phi_1101_;
                                    let _e854 = phi_1102_;
                                    let _e856 = phi_1103_;
                                    if _e854 {
                                        phi_1107_ = false;
                                        phi_1108_ = true;
                                    } else {
                                        phi_1107_ = _e820;
                                        phi_1108_ = _e856;
                                    }
                                    let _e858 = phi_1107_;
                                    let _e860 = phi_1108_;
                                    if _e860 {
                                        phi_1112_ = _e858;
                                    } else {
                                        phi_1112_ = _e852;
                                    }
                                    let _e862 = phi_1112_;
                                    phi_1113_ = _e862;
                                }
                                let _e864 = phi_1113_;
                                if _e663.all_remove {
                                    if (((_e782 & 1u) != 0u) == _e249) {
                                        if ((_e782 & 2u) != 0u) {
                                            phi_1131_ = (((_e782 & 4u) != 0u) == _e249);
                                        } else {
                                            phi_1131_ = true;
                                        }
                                        let _e874 = phi_1131_;
                                        phi_1132_ = _e874;
                                    } else {
                                        phi_1132_ = false;
                                    }
                                    let _e876 = phi_1132_;
                                    phi_1133_ = _e876;
                                } else {
                                    phi_1133_ = false;
                                }
                                let _e878 = phi_1133_;
                                phi_868_ = (_e661 + 1u);
                                phi_871_ = lt_mask_Neighbourhood(_e864, _e878);
                            } else {
                                phi_868_ = u32();
                                phi_871_ = lt_mask_Neighbourhood();
                            }
                            let _e882 = phi_868_;
                            let _e884 = phi_871_;
                            continue;
                            continuing {
                                phi_867_ = _e882;
                                phi_870_ = _e884;
                                break if !(_e675);
                            }
                        }
                        let _e1173 = local_1;
                        phi_1136_ = _e1173;
                    }
                    let _e887 = phi_1136_;
                    phi_1137_ = _e887;
                } else {
                    phi_1137_ = _e646;
                }
                let _e889 = phi_1137_;
                phi_1138_ = _e889;
            } else {
                phi_1138_ = _e646;
            }
            let _e891 = phi_1138_;
            let _e894 = p.member.frame;
            let _e896 = p.member.refresh;
            if (_e896 == 0u) {
                phi_1171_ = false;
            } else {
                if (_e896 == 0u) {
                    return;
                }
                let _e905 = ((_e54.x + (_e54.y * (((_e896 * 5u) / 8u) | 1u))) + (_e894 % _e896));
                if (_e896 == 0u) {
                    phi_1170_ = (_e905 == 0u);
                } else {
                    if (_e896 == 0u) {
                        return;
                    }
                    phi_1170_ = ((_e905 % _e896) == 0u);
                }
                let _e912 = phi_1170_;
                phi_1171_ = _e912;
            }
            let _e914 = phi_1171_;
            if _e639 {
                if _e914 {
                    phi_1193_ = bool();
                } else {
                    phi_1193_ = ((0u & 2u) != 0u);
                }
                let _e920 = phi_1193_;
                phi_1194_ = _e920;
                phi_1195_ = _e914;
            } else {
                phi_1194_ = bool();
                phi_1195_ = true;
            }
            let _e922 = phi_1194_;
            let _e924 = phi_1195_;
            if _e924 {
                phi_1199_ = false;
            } else {
                phi_1199_ = _e922;
            }
            let _e926 = phi_1199_;
            if _e926 {
                phi_1250_ = 7u;
            } else {
                if (_e91 != 0.5f) {
                    if _e639 {
                        if _e914 {
                            phi_1247_ = 6u;
                        } else {
                            if _e253 {
                                phi_1222_ = true;
                            } else {
                                if _e891.any_expands {
                                    phi_1221_ = false;
                                } else {
                                    phi_1221_ = true;
                                }
                                let _e928 = phi_1221_;
                                phi_1222_ = _e928;
                            }
                            let _e930 = phi_1222_;
                            if _e930 {
                                if _e253 {
                                    if false {
                                        if _e891.all_remove {
                                            phi_1235_ = false;
                                        } else {
                                            phi_1235_ = true;
                                        }
                                        let _e932 = phi_1235_;
                                        phi_1236_ = _e932;
                                    } else {
                                        phi_1236_ = true;
                                    }
                                    let _e934 = phi_1236_;
                                    phi_1237_ = _e934;
                                } else {
                                    phi_1237_ = true;
                                }
                                let _e936 = phi_1237_;
                                if _e936 {
                                    if _e253 {
                                        phi_1244_ = 1u;
                                    } else {
                                        phi_1244_ = 0u;
                                    }
                                    let _e938 = phi_1244_;
                                    phi_1245_ = _e938;
                                } else {
                                    phi_1245_ = 5u;
                                }
                                let _e940 = phi_1245_;
                                phi_1246_ = _e940;
                            } else {
                                phi_1246_ = 4u;
                            }
                            let _e942 = phi_1246_;
                            phi_1247_ = _e942;
                        }
                        let _e944 = phi_1247_;
                        phi_1248_ = _e944;
                    } else {
                        phi_1248_ = 3u;
                    }
                    let _e946 = phi_1248_;
                    phi_1249_ = _e946;
                } else {
                    phi_1249_ = 2u;
                }
                let _e948 = phi_1249_;
                phi_1250_ = _e948;
            }
            let _e950 = phi_1250_;
            if !((_e950 == 0u)) {
                if !((_e950 == 5u)) {
                    phi_1262_ = !(_e926);
                    phi_1263_ = false;
                } else {
                    phi_1262_ = bool();
                    phi_1263_ = true;
                }
                let _e957 = phi_1262_;
                let _e959 = phi_1263_;
                phi_1264_ = _e957;
                phi_1265_ = _e959;
            } else {
                phi_1264_ = bool();
                phi_1265_ = true;
            }
            let _e961 = phi_1264_;
            let _e963 = phi_1265_;
            if _e963 {
                phi_1269_ = false;
            } else {
                phi_1269_ = _e961;
            }
            let _e965 = phi_1269_;
            if _e926 {
                phi_1275_ = ((0u & 4u) != 0u);
            } else {
                phi_1275_ = _e249;
            }
            let _e969 = phi_1275_;
            if _e965 {
                if _e249 {
                    phi_1283_ = (2u | 1u);
                } else {
                    phi_1283_ = 2u;
                }
                let _e972 = phi_1283_;
                if false {
                    phi_1288_ = (_e972 | 4u);
                } else {
                    phi_1288_ = _e972;
                }
                let _e975 = phi_1288_;
                phi_1308_ = _e975;
            } else {
                if (_e950 == 7u) {
                    if _e249 {
                        phi_1297_ = (2u | 1u);
                    } else {
                        phi_1297_ = 2u;
                    }
                    let _e979 = phi_1297_;
                    if _e969 {
                        phi_1302_ = (_e979 | 4u);
                    } else {
                        phi_1302_ = _e979;
                    }
                    let _e982 = phi_1302_;
                    phi_1307_ = _e982;
                } else {
                    if _e249 {
                        phi_1306_ = 1u;
                    } else {
                        phi_1306_ = 0u;
                    }
                    let _e984 = phi_1306_;
                    phi_1307_ = _e984;
                }
                let _e986 = phi_1307_;
                phi_1308_ = _e986;
            }
            let _e988 = phi_1308_;
            if _e969 {
                phi_1312_ = 0f;
            } else {
                phi_1312_ = 1f;
            }
            let _e990 = phi_1312_;
            phi_1314_ = mask_Masked(_e990, _e988, _e965);
        }
        let _e993 = phi_1314_;
        visibility.member[_e70.shift] = _e993.visibility;
        let _e998 = p.member.light.number;
        let _e999 = (_e998 * 3u);
        let _e1001 = (_e999 % 32u);
        let _e1003 = p.member.light.mask_words;
        let _e1005 = ((_e70.shift * _e1003) + (_e999 / 32u));
        let _e1007 = bits.member[_e1005];
        bits.member[_e1005] = ((_e1007 & ~((7u << bitcast<u32>((_e1001 & 31u))))) | (_e993.bits << bitcast<u32>((_e1001 & 31u))));
        if (_e1001 > 29u) {
            let _e1022 = bits.member[(_e1005 + 1u)];
            let _e1024 = (32u - _e1001);
            bits.member[(_e1005 + 1u)] = ((_e1022 & ~((7u >> bitcast<u32>((_e1024 & 31u))))) | (_e993.bits >> bitcast<u32>((_e1024 & 31u))));
        }
        phi_1364_ = _e993.needs_ray;
        phi_1365_ = _e70.shift;
    } else {
        phi_1364_ = false;
        phi_1365_ = 0u;
    }
    let _e1038 = phi_1364_;
    let _e1040 = phi_1365_;
    if (_e55 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1038 {
        let _e1044 = atomicAdd((&shared_[0u]), 1u);
        phi_1376_ = _e1044;
    } else {
        phi_1376_ = 0u;
    }
    let _e1046 = phi_1376_;
    workgroupBarrier();
    if (_e55 == 0u) {
        let _e1050 = atomicLoad((&shared_[0u]));
        let _e1051 = atomicAdd((&list.member[3u]), _e1050);
        atomicStore((&shared_[1u]), _e1051);
    }
    workgroupBarrier();
    if _e1038 {
        let _e1054 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1054) + _e1046)]), _e1040);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
