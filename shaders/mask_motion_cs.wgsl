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
    var phi_878_: u32;
    var phi_897_: u32;
    var phi_905_: u32;
    var phi_906_: u32;
    var phi_907_: bool;
    var phi_908_: u32;
    var phi_909_: bool;
    var phi_910_: bool;
    var phi_911_: u32;
    var phi_912_: bool;
    var phi_913_: bool;
    var phi_917_: bool;
    var phi_921_: u32;
    var phi_926_: bool;
    var phi_948_: u32;
    var phi_950_: u32;
    var phi_953_: lt_mask_Neighbourhood;
    var phi_965_: bool;
    var phi_966_: bool;
    var phi_975_: u32;
    var phi_976_: u32;
    var phi_1036_: vec2<i32>;
    var phi_1056_: vec2<i32>;
    var phi_1081_: u32;
    var phi_1100_: u32;
    var phi_1108_: u32;
    var phi_1134_: bool;
    var phi_1135_: bool;
    var phi_1136_: bool;
    var phi_1137_: bool;
    var phi_1138_: bool;
    var phi_1139_: bool;
    var phi_1140_: bool;
    var phi_1145_: bool;
    var phi_1146_: bool;
    var phi_1147_: bool;
    var phi_1148_: bool;
    var phi_1149_: bool;
    var phi_1150_: bool;
    var phi_1151_: bool;
    var phi_1152_: bool;
    var phi_1153_: bool;
    var phi_1168_: bool;
    var phi_1169_: bool;
    var phi_1176_: bool;
    var phi_1177_: bool;
    var phi_1178_: bool;
    var phi_1179_: bool;
    var phi_1180_: bool;
    var phi_1184_: bool;
    var phi_1185_: bool;
    var phi_1186_: bool;
    var phi_1190_: bool;
    var phi_1191_: bool;
    var phi_1195_: bool;
    var phi_1196_: bool;
    var phi_1214_: bool;
    var phi_1215_: bool;
    var phi_1216_: bool;
    var phi_951_: u32;
    var phi_954_: lt_mask_Neighbourhood;
    var phi_1219_: lt_mask_Neighbourhood;
    var phi_1220_: lt_mask_Neighbourhood;
    var phi_1221_: lt_mask_Neighbourhood;
    var phi_1253_: bool;
    var phi_1254_: bool;
    var phi_1276_: bool;
    var phi_1277_: bool;
    var phi_1278_: bool;
    var phi_1282_: bool;
    var phi_1304_: bool;
    var phi_1305_: bool;
    var phi_1318_: bool;
    var phi_1319_: bool;
    var phi_1320_: bool;
    var phi_1327_: u32;
    var phi_1328_: u32;
    var phi_1329_: u32;
    var phi_1330_: u32;
    var phi_1331_: u32;
    var phi_1332_: u32;
    var phi_1333_: u32;
    var phi_1345_: bool;
    var phi_1346_: bool;
    var phi_1347_: bool;
    var phi_1348_: bool;
    var phi_1352_: bool;
    var phi_1358_: bool;
    var phi_1366_: u32;
    var phi_1371_: u32;
    var phi_1380_: u32;
    var phi_1385_: u32;
    var phi_1389_: u32;
    var phi_1390_: u32;
    var phi_1391_: u32;
    var phi_1395_: f32;
    var phi_1397_: mask_Masked;
    var phi_1447_: bool;
    var phi_1448_: u32;
    var phi_1459_: u32;
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
        let _e79 = (_e78 / 32u);
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
            phi_1397_ = mask_Masked(_e244.unnamed.visibility, 0u, false);
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
            let _e647 = p.member.flags;
            let _e649 = ((_e647 & 2u) != 0u);
            let _e651 = p.member.flags;
            if ((_e651 & 4u) == 0u) {
                phi_911_ = u32();
                phi_912_ = true;
                phi_913_ = false;
            } else {
                if _e639 {
                    if !(_e645.has_moved) {
                        let _e659 = ((((_e54.y * _e86) + _e54.x) * _e82) + _e79);
                        if (_e80 > 29u) {
                            let _e661 = (_e659 + 1u);
                            if (_e661 < _e60) {
                            } else {
                                return;
                            }
                            let _e665 = last_bits.member[(0u + _e661)];
                            phi_878_ = _e665;
                        } else {
                            phi_878_ = 0u;
                        }
                        let _e667 = phi_878_;
                        if (_e659 < _e60) {
                        } else {
                            return;
                        }
                        let _e671 = last_bits.member[(0u + _e659)];
                        let _e674 = (_e671 >> bitcast<u32>((_e80 & 31u)));
                        if (_e80 > 29u) {
                            phi_897_ = (_e674 | (_e667 << bitcast<u32>(((32u - _e80) & 31u))));
                        } else {
                            phi_897_ = _e674;
                        }
                        let _e682 = phi_897_;
                        if ((_e682 & 2u) == 0u) {
                            phi_905_ = (_e682 & 1u);
                        } else {
                            phi_905_ = (_e682 & 7u);
                        }
                        let _e688 = phi_905_;
                        phi_906_ = _e688;
                        phi_907_ = false;
                    } else {
                        phi_906_ = u32();
                        phi_907_ = true;
                    }
                    let _e690 = phi_906_;
                    let _e692 = phi_907_;
                    phi_908_ = _e690;
                    phi_909_ = false;
                    phi_910_ = _e692;
                } else {
                    phi_908_ = u32();
                    phi_909_ = true;
                    phi_910_ = false;
                }
                let _e694 = phi_908_;
                let _e696 = phi_909_;
                let _e698 = phi_910_;
                phi_911_ = _e694;
                phi_912_ = _e696;
                phi_913_ = _e698;
            }
            let _e700 = phi_911_;
            let _e702 = phi_912_;
            let _e704 = phi_913_;
            if _e702 {
                phi_917_ = true;
            } else {
                phi_917_ = _e704;
            }
            let _e706 = phi_917_;
            if _e706 {
                phi_921_ = 0u;
            } else {
                phi_921_ = _e700;
            }
            let _e708 = phi_921_;
            let _e709 = lt_mask_Neighbourhood(false, true);
            if _e253 {
                phi_926_ = _e649;
            } else {
                phi_926_ = true;
            }
            let _e711 = phi_926_;
            if _e711 {
                if _e639 {
                    if ((_e708 & 2u) != 0u) {
                        phi_1219_ = _e709;
                    } else {
                        let _e715 = p.member.expansion;
                        if _e645.has_moved {
                            let _e718 = p.member.moving_pattern;
                            phi_948_ = _e718;
                        } else {
                            let _e720 = p.member.still_pattern;
                            phi_948_ = _e720;
                        }
                        let _e722 = phi_948_;
                        phi_950_ = 0u;
                        phi_953_ = _e709;
                        loop {
                            let _e724 = phi_950_;
                            let _e726 = phi_953_;
                            local_1 = _e726;
                            if (1u <= _e722) {
                                if (_e722 <= 4u) {
                                    phi_965_ = false;
                                } else {
                                    phi_965_ = true;
                                }
                                let _e730 = phi_965_;
                                phi_966_ = _e730;
                            } else {
                                phi_966_ = true;
                            }
                            let _e732 = phi_966_;
                            if _e732 {
                                switch bitcast<i32>(_e722) {
                                    case 5: {
                                        phi_975_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_975_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_975_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_975_ = 9u;
                                        break;
                                    }
                                }
                                let _e735 = phi_975_;
                                phi_976_ = _e735;
                            } else {
                                phi_976_ = 5u;
                            }
                            let _e737 = phi_976_;
                            let _e738 = (_e724 < _e737);
                            if _e738 {
                                let _e744 = p.member.frame;
                                let _e748 = p.member.current.size[0u];
                                let _e750 = p.member.current.size[1u];
                                switch bitcast<i32>(_e722) {
                                    case 1: {
                                        let _e760 = lt_mask_pattern_plus(_e724);
                                        phi_1056_ = vec2<i32>(_e760.x, _e760.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e764 = lt_mask_pattern_cross(_e724);
                                        phi_1056_ = vec2<i32>(_e764.x, _e764.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e770 = lt_mask_pattern_plus_or_cross(_e724, ((_e645.pixel.x + _e645.pixel.y) & 1u));
                                        phi_1056_ = vec2<i32>(_e770.x, _e770.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e775 = lt_mask_pattern_plus_or_cross(_e724, (_e744 & 1u));
                                        phi_1056_ = vec2<i32>(_e775.x, _e775.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e744 & 3u)) {
                                            case 0: {
                                                phi_1036_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1036_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1036_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1036_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e786 = phi_1036_;
                                        phi_1056_ = (_e786 + vec2<i32>(bitcast<i32>((_e724 & 1u)), bitcast<i32>(((_e724 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1056_ = vec2<i32>((bitcast<i32>((_e724 % 5u)) - 2i), (bitcast<i32>(((_e724 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e803 = lt_mask_pattern_diamond(_e724);
                                        phi_1056_ = vec2<i32>(_e803.x, _e803.y);
                                        break;
                                    }
                                    default: {
                                        phi_1056_ = vec2<i32>((bitcast<i32>((_e724 % 3u)) - 1i), (bitcast<i32>(((_e724 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e808 = phi_1056_;
                                let _e811 = lt_mask_pattern_step_clamped(_e645.pixel.x, _e808.x, _e748);
                                let _e812 = lt_mask_pattern_step_clamped(_e645.pixel.y, _e808.y, _e750);
                                let _e816 = ((((_e812 * _e86) + _e811) * _e82) + _e79);
                                if (_e80 > 29u) {
                                    let _e818 = (_e816 + 1u);
                                    if (_e818 < _e60) {
                                    } else {
                                        return;
                                    }
                                    let _e822 = last_bits.member[(0u + _e818)];
                                    phi_1081_ = _e822;
                                } else {
                                    phi_1081_ = 0u;
                                }
                                let _e824 = phi_1081_;
                                if (_e816 < _e60) {
                                } else {
                                    return;
                                }
                                let _e828 = last_bits.member[(0u + _e816)];
                                let _e831 = (_e828 >> bitcast<u32>((_e80 & 31u)));
                                if (_e80 > 29u) {
                                    phi_1100_ = (_e831 | (_e824 << bitcast<u32>(((32u - _e80) & 31u))));
                                } else {
                                    phi_1100_ = _e831;
                                }
                                let _e839 = phi_1100_;
                                if ((_e839 & 2u) == 0u) {
                                    phi_1108_ = (_e839 & 1u);
                                } else {
                                    phi_1108_ = (_e839 & 7u);
                                }
                                let _e845 = phi_1108_;
                                if _e726.any_expands {
                                    phi_1196_ = true;
                                } else {
                                    if ((_e845 & 2u) != 0u) {
                                        let _e852 = (((_e845 & 4u) != 0u) != _e249);
                                        switch bitcast<i32>(_e715) {
                                            case 1: {
                                                phi_1136_ = bool();
                                                phi_1137_ = false;
                                                phi_1138_ = true;
                                                phi_1139_ = false;
                                                phi_1140_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e852 {
                                                    phi_1134_ = (((_e845 & 4u) != 0u) != ((_e845 & 1u) != 0u));
                                                    phi_1135_ = false;
                                                } else {
                                                    phi_1134_ = bool();
                                                    phi_1135_ = true;
                                                }
                                                let _e860 = phi_1134_;
                                                let _e862 = phi_1135_;
                                                phi_1136_ = _e860;
                                                phi_1137_ = false;
                                                phi_1138_ = false;
                                                phi_1139_ = _e862;
                                                phi_1140_ = _e852;
                                                break;
                                            }
                                            default: {
                                                phi_1136_ = bool();
                                                phi_1137_ = true;
                                                phi_1138_ = false;
                                                phi_1139_ = false;
                                                phi_1140_ = false;
                                                break;
                                            }
                                        }
                                        let _e864 = phi_1136_;
                                        let _e866 = phi_1137_;
                                        let _e868 = phi_1138_;
                                        let _e870 = phi_1139_;
                                        let _e872 = phi_1140_;
                                        phi_1148_ = _e852;
                                        phi_1149_ = _e864;
                                        phi_1150_ = _e866;
                                        phi_1151_ = _e868;
                                        phi_1152_ = _e870;
                                        phi_1153_ = _e872;
                                    } else {
                                        switch bitcast<i32>(_e715) {
                                            case 1: {
                                                phi_1145_ = false;
                                                phi_1146_ = true;
                                                phi_1147_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1145_ = false;
                                                phi_1146_ = false;
                                                phi_1147_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1145_ = true;
                                                phi_1146_ = false;
                                                phi_1147_ = false;
                                                break;
                                            }
                                        }
                                        let _e875 = phi_1145_;
                                        let _e877 = phi_1146_;
                                        let _e879 = phi_1147_;
                                        phi_1148_ = false;
                                        phi_1149_ = bool();
                                        phi_1150_ = _e875;
                                        phi_1151_ = _e877;
                                        phi_1152_ = _e879;
                                        phi_1153_ = false;
                                    }
                                    let _e881 = phi_1148_;
                                    let _e883 = phi_1149_;
                                    let _e885 = phi_1150_;
                                    let _e887 = phi_1151_;
                                    let _e889 = phi_1152_;
                                    let _e891 = phi_1153_;
                                    if _e885 {
                                        if ((_e845 & 2u) != 0u) {
                                            if (((_e845 & 4u) != 0u) != _e249) {
                                                phi_1168_ = false;
                                            } else {
                                                phi_1168_ = true;
                                            }
                                            let _e898 = phi_1168_;
                                            phi_1169_ = _e898;
                                        } else {
                                            phi_1169_ = true;
                                        }
                                        let _e900 = phi_1169_;
                                        if _e900 {
                                            phi_1176_ = (((_e845 & 1u) != 0u) != _e249);
                                        } else {
                                            phi_1176_ = true;
                                        }
                                        let _e905 = phi_1176_;
                                        phi_1177_ = _e905;
                                        phi_1178_ = false;
                                        phi_1179_ = false;
                                        phi_1180_ = false;
                                    } else {
                                        phi_1177_ = bool();
                                        phi_1178_ = _e887;
                                        phi_1179_ = _e889;
                                        phi_1180_ = _e891;
                                    }
                                    let _e907 = phi_1177_;
                                    let _e909 = phi_1178_;
                                    let _e911 = phi_1179_;
                                    let _e913 = phi_1180_;
                                    if _e909 {
                                        phi_1184_ = _e881;
                                        phi_1185_ = false;
                                        phi_1186_ = false;
                                    } else {
                                        phi_1184_ = _e907;
                                        phi_1185_ = _e911;
                                        phi_1186_ = _e913;
                                    }
                                    let _e915 = phi_1184_;
                                    let _e917 = phi_1185_;
                                    let _e919 = phi_1186_;
                                    if _e917 {
                                        phi_1190_ = false;
                                        phi_1191_ = true;
                                    } else {
                                        phi_1190_ = _e883;
                                        phi_1191_ = _e919;
                                    }
                                    let _e921 = phi_1190_;
                                    let _e923 = phi_1191_;
                                    if _e923 {
                                        phi_1195_ = _e921;
                                    } else {
                                        phi_1195_ = _e915;
                                    }
                                    let _e925 = phi_1195_;
                                    phi_1196_ = _e925;
                                }
                                let _e927 = phi_1196_;
                                if _e726.all_remove {
                                    if (((_e845 & 1u) != 0u) == _e249) {
                                        if ((_e845 & 2u) != 0u) {
                                            phi_1214_ = (((_e845 & 4u) != 0u) == _e249);
                                        } else {
                                            phi_1214_ = true;
                                        }
                                        let _e937 = phi_1214_;
                                        phi_1215_ = _e937;
                                    } else {
                                        phi_1215_ = false;
                                    }
                                    let _e939 = phi_1215_;
                                    phi_1216_ = _e939;
                                } else {
                                    phi_1216_ = false;
                                }
                                let _e941 = phi_1216_;
                                phi_951_ = (_e724 + 1u);
                                phi_954_ = lt_mask_Neighbourhood(_e927, _e941);
                            } else {
                                phi_951_ = u32();
                                phi_954_ = lt_mask_Neighbourhood();
                            }
                            let _e945 = phi_951_;
                            let _e947 = phi_954_;
                            continue;
                            continuing {
                                phi_950_ = _e945;
                                phi_953_ = _e947;
                                break if !(_e738);
                            }
                        }
                        let _e1249 = local_1;
                        phi_1219_ = _e1249;
                    }
                    let _e950 = phi_1219_;
                    phi_1220_ = _e950;
                } else {
                    phi_1220_ = _e709;
                }
                let _e952 = phi_1220_;
                phi_1221_ = _e952;
            } else {
                phi_1221_ = _e709;
            }
            let _e954 = phi_1221_;
            let _e957 = p.member.frame;
            let _e959 = p.member.refresh;
            if (_e959 == 0u) {
                phi_1254_ = false;
            } else {
                if (_e959 == 0u) {
                    return;
                }
                let _e968 = ((_e54.x + (_e54.y * (((_e959 * 5u) / 8u) | 1u))) + (_e957 % _e959));
                if (_e959 == 0u) {
                    phi_1253_ = (_e968 == 0u);
                } else {
                    if (_e959 == 0u) {
                        return;
                    }
                    phi_1253_ = ((_e968 % _e959) == 0u);
                }
                let _e975 = phi_1253_;
                phi_1254_ = _e975;
            }
            let _e977 = phi_1254_;
            if _e639 {
                if _e977 {
                    phi_1276_ = bool();
                } else {
                    phi_1276_ = ((_e708 & 2u) != 0u);
                }
                let _e983 = phi_1276_;
                phi_1277_ = _e983;
                phi_1278_ = _e977;
            } else {
                phi_1277_ = bool();
                phi_1278_ = true;
            }
            let _e985 = phi_1277_;
            let _e987 = phi_1278_;
            if _e987 {
                phi_1282_ = false;
            } else {
                phi_1282_ = _e985;
            }
            let _e989 = phi_1282_;
            if _e989 {
                phi_1333_ = 7u;
            } else {
                if (_e91 != 0.5f) {
                    if _e639 {
                        if _e977 {
                            phi_1330_ = 6u;
                        } else {
                            if _e253 {
                                phi_1305_ = true;
                            } else {
                                if _e954.any_expands {
                                    phi_1304_ = false;
                                } else {
                                    phi_1304_ = true;
                                }
                                let _e991 = phi_1304_;
                                phi_1305_ = _e991;
                            }
                            let _e993 = phi_1305_;
                            if _e993 {
                                if _e253 {
                                    if _e649 {
                                        if _e954.all_remove {
                                            phi_1318_ = false;
                                        } else {
                                            phi_1318_ = true;
                                        }
                                        let _e995 = phi_1318_;
                                        phi_1319_ = _e995;
                                    } else {
                                        phi_1319_ = true;
                                    }
                                    let _e997 = phi_1319_;
                                    phi_1320_ = _e997;
                                } else {
                                    phi_1320_ = true;
                                }
                                let _e999 = phi_1320_;
                                if _e999 {
                                    if _e253 {
                                        phi_1327_ = 1u;
                                    } else {
                                        phi_1327_ = 0u;
                                    }
                                    let _e1001 = phi_1327_;
                                    phi_1328_ = _e1001;
                                } else {
                                    phi_1328_ = 5u;
                                }
                                let _e1003 = phi_1328_;
                                phi_1329_ = _e1003;
                            } else {
                                phi_1329_ = 4u;
                            }
                            let _e1005 = phi_1329_;
                            phi_1330_ = _e1005;
                        }
                        let _e1007 = phi_1330_;
                        phi_1331_ = _e1007;
                    } else {
                        phi_1331_ = 3u;
                    }
                    let _e1009 = phi_1331_;
                    phi_1332_ = _e1009;
                } else {
                    phi_1332_ = 2u;
                }
                let _e1011 = phi_1332_;
                phi_1333_ = _e1011;
            }
            let _e1013 = phi_1333_;
            if !((_e1013 == 0u)) {
                if !((_e1013 == 5u)) {
                    phi_1345_ = !(_e989);
                    phi_1346_ = false;
                } else {
                    phi_1345_ = bool();
                    phi_1346_ = true;
                }
                let _e1020 = phi_1345_;
                let _e1022 = phi_1346_;
                phi_1347_ = _e1020;
                phi_1348_ = _e1022;
            } else {
                phi_1347_ = bool();
                phi_1348_ = true;
            }
            let _e1024 = phi_1347_;
            let _e1026 = phi_1348_;
            if _e1026 {
                phi_1352_ = false;
            } else {
                phi_1352_ = _e1024;
            }
            let _e1028 = phi_1352_;
            if _e989 {
                phi_1358_ = ((_e708 & 4u) != 0u);
            } else {
                phi_1358_ = _e249;
            }
            let _e1032 = phi_1358_;
            if _e1028 {
                if _e249 {
                    phi_1366_ = (2u | 1u);
                } else {
                    phi_1366_ = 2u;
                }
                let _e1035 = phi_1366_;
                if false {
                    phi_1371_ = (_e1035 | 4u);
                } else {
                    phi_1371_ = _e1035;
                }
                let _e1038 = phi_1371_;
                phi_1391_ = _e1038;
            } else {
                if (_e1013 == 7u) {
                    if _e249 {
                        phi_1380_ = (2u | 1u);
                    } else {
                        phi_1380_ = 2u;
                    }
                    let _e1042 = phi_1380_;
                    if _e1032 {
                        phi_1385_ = (_e1042 | 4u);
                    } else {
                        phi_1385_ = _e1042;
                    }
                    let _e1045 = phi_1385_;
                    phi_1390_ = _e1045;
                } else {
                    if _e249 {
                        phi_1389_ = 1u;
                    } else {
                        phi_1389_ = 0u;
                    }
                    let _e1047 = phi_1389_;
                    phi_1390_ = _e1047;
                }
                let _e1049 = phi_1390_;
                phi_1391_ = _e1049;
            }
            let _e1051 = phi_1391_;
            if _e1032 {
                phi_1395_ = 0f;
            } else {
                phi_1395_ = 1f;
            }
            let _e1053 = phi_1395_;
            phi_1397_ = mask_Masked(_e1053, _e1051, _e1028);
        }
        let _e1056 = phi_1397_;
        visibility.member[_e70.shift] = _e1056.visibility;
        let _e1061 = p.member.light.number;
        let _e1062 = (_e1061 * 3u);
        let _e1064 = (_e1062 % 32u);
        let _e1066 = p.member.light.mask_words;
        let _e1068 = ((_e70.shift * _e1066) + (_e1062 / 32u));
        let _e1070 = bits.member[_e1068];
        bits.member[_e1068] = ((_e1070 & ~((7u << bitcast<u32>((_e1064 & 31u))))) | (_e1056.bits << bitcast<u32>((_e1064 & 31u))));
        if (_e1064 > 29u) {
            let _e1085 = bits.member[(_e1068 + 1u)];
            let _e1087 = (32u - _e1064);
            bits.member[(_e1068 + 1u)] = ((_e1085 & ~((7u >> bitcast<u32>((_e1087 & 31u))))) | (_e1056.bits >> bitcast<u32>((_e1087 & 31u))));
        }
        phi_1447_ = _e1056.needs_ray;
        phi_1448_ = _e70.shift;
    } else {
        phi_1447_ = false;
        phi_1448_ = 0u;
    }
    let _e1101 = phi_1447_;
    let _e1103 = phi_1448_;
    if (_e55 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1101 {
        let _e1107 = atomicAdd((&shared_[0u]), 1u);
        phi_1459_ = _e1107;
    } else {
        phi_1459_ = 0u;
    }
    let _e1109 = phi_1459_;
    workgroupBarrier();
    if (_e55 == 0u) {
        let _e1113 = atomicLoad((&shared_[0u]));
        let _e1114 = atomicAdd((&list.member[3u]), _e1113);
        atomicStore((&shared_[1u]), _e1114);
    }
    workgroupBarrier();
    if _e1101 {
        let _e1117 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1117) + _e1109)]), _e1103);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
