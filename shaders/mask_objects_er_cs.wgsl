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
    var phi_178_: lt_mask_LightPlace;
    var phi_179_: bool;
    var phi_180_: lt_mask_LightPlace;
    var phi_181_: bool;
    var phi_186_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_178_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_179_ = false;
        } else {
            phi_178_ = lt_mask_LightPlace();
            phi_179_ = true;
        }
        let _e69 = phi_178_;
        let _e71 = phi_179_;
        phi_180_ = _e69;
        phi_181_ = _e71;
    } else {
        phi_180_ = lt_mask_LightPlace();
        phi_181_ = true;
    }
    let _e73 = phi_180_;
    let _e75 = phi_181_;
    if _e75 {
        phi_186_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_186_ = _e73;
    }
    let _e80 = phi_186_;
    return lt_mask_LightPlace(_e80.word, _e80.shift);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_204_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_204_ = vec2(0i);
            break;
        }
        case 1: {
            phi_204_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_204_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_204_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_204_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e65 = phi_204_;
    return vec2<i32>(_e65.x, _e65.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_222_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_222_ = vec2(0i);
            break;
        }
        case 1: {
            phi_222_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_222_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_222_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_222_ = vec2(1i);
            break;
        }
    }
    let _e65 = phi_222_;
    return vec2<i32>(_e65.x, _e65.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_241_: vec2<i32>;

    if (param_6 == 0u) {
        let _e59 = lt_mask_pattern_plus(param_5);
        phi_241_ = vec2<i32>(_e59.x, _e59.y);
    } else {
        let _e63 = lt_mask_pattern_cross(param_5);
        phi_241_ = vec2<i32>(_e63.x, _e63.y);
    }
    let _e68 = phi_241_;
    return vec2<i32>(_e68.x, _e68.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_266_: vec2<i32>;

    let _e57 = (param_7 % 13u);
    switch bitcast<i32>(_e57) {
        case 9: {
            phi_266_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_266_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_266_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_266_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_266_ = vec2<i32>((bitcast<i32>((_e57 % 3u)) - 1i), (bitcast<i32>(((_e57 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e72 = phi_266_;
    return vec2<i32>(_e72.x, _e72.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_287_: u32;
    var phi_288_: u32;

    let _e60 = (bitcast<i32>(param_8) + param_9);
    if (_e60 < 0i) {
        phi_288_ = 0u;
    } else {
        if (_e60 >= bitcast<i32>(param_10)) {
            phi_287_ = (param_10 - 1u);
        } else {
            phi_287_ = bitcast<u32>(_e60);
        }
        let _e67 = phi_287_;
        phi_288_ = _e67;
    }
    let _e69 = phi_288_;
    return _e69;
}

fn function_() {
    var phi_364_: bool;
    var phi_365_: bool;
    var phi_366_: bool;
    var phi_367_: bool;
    var phi_371_: bool;
    var phi_441_: bool;
    var phi_442_: bool;
    var phi_453_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_454_: bool;
    var phi_455_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_456_: bool;
    var phi_463_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_467_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_480_: bool;
    var phi_508_: bool;
    var phi_509_: bool;
    var phi_510_: bool;
    var phi_511_: bool;
    var phi_515_: bool;
    var phi_519_: bool;
    var phi_520_: bool;
    var phi_728_: f32;
    var phi_733_: f32;
    var phi_734_: bool;
    var phi_735_: f32;
    var phi_736_: bool;
    var phi_740_: f32;
    var phi_761_: f32;
    var phi_766_: f32;
    var phi_767_: bool;
    var phi_768_: f32;
    var phi_769_: bool;
    var phi_773_: f32;
    var phi_794_: bool;
    var phi_813_: vec2<u32>;
    var phi_814_: bool;
    var phi_815_: bool;
    var phi_816_: bool;
    var phi_817_: vec2<u32>;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_824_: vec2<u32>;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: vec2<u32>;
    var phi_832_: bool;
    var phi_833_: bool;
    var phi_834_: bool;
    var phi_835_: bool;
    var phi_844_: bool;
    var phi_845_: bool;
    var phi_846_: bool;
    var phi_847_: bool;
    var phi_851_: bool;
    var phi_852_: bool;
    var phi_853_: vec2<u32>;
    var phi_888_: bool;
    var phi_890_: lt_mask_Reprojection;
    var phi_891_: lt_mask_Reprojection;
    var phi_892_: bool;
    var phi_896_: bool;
    var phi_897_: lt_mask_Reprojection;
    var phi_898_: lt_mask_Reprojection;
    var phi_899_: bool;
    var phi_907_: bool;
    var phi_908_: lt_mask_Reprojection;
    var phi_914_: bool;
    var phi_936_: u32;
    var phi_938_: u32;
    var phi_941_: lt_mask_Neighbourhood;
    var phi_953_: bool;
    var phi_954_: bool;
    var phi_963_: u32;
    var phi_964_: u32;
    var phi_1024_: vec2<i32>;
    var phi_1044_: vec2<i32>;
    var phi_1069_: u32;
    var phi_1088_: u32;
    var phi_1096_: u32;
    var phi_1122_: bool;
    var phi_1123_: bool;
    var phi_1124_: bool;
    var phi_1125_: bool;
    var phi_1126_: bool;
    var phi_1127_: bool;
    var phi_1128_: bool;
    var phi_1133_: bool;
    var phi_1134_: bool;
    var phi_1135_: bool;
    var phi_1136_: bool;
    var phi_1137_: bool;
    var phi_1138_: bool;
    var phi_1139_: bool;
    var phi_1140_: bool;
    var phi_1141_: bool;
    var phi_1156_: bool;
    var phi_1157_: bool;
    var phi_1164_: bool;
    var phi_1165_: bool;
    var phi_1166_: bool;
    var phi_1167_: bool;
    var phi_1168_: bool;
    var phi_1172_: bool;
    var phi_1173_: bool;
    var phi_1174_: bool;
    var phi_1178_: bool;
    var phi_1179_: bool;
    var phi_1183_: bool;
    var phi_1184_: bool;
    var phi_1202_: bool;
    var phi_1203_: bool;
    var phi_1204_: bool;
    var phi_939_: u32;
    var phi_942_: lt_mask_Neighbourhood;
    var phi_1207_: lt_mask_Neighbourhood;
    var phi_1208_: lt_mask_Neighbourhood;
    var phi_1209_: lt_mask_Neighbourhood;
    var phi_1241_: bool;
    var phi_1242_: bool;
    var phi_1264_: bool;
    var phi_1265_: bool;
    var phi_1266_: bool;
    var phi_1270_: bool;
    var phi_1292_: bool;
    var phi_1293_: bool;
    var phi_1306_: bool;
    var phi_1307_: bool;
    var phi_1308_: bool;
    var phi_1315_: u32;
    var phi_1316_: u32;
    var phi_1317_: u32;
    var phi_1318_: u32;
    var phi_1319_: u32;
    var phi_1320_: u32;
    var phi_1321_: u32;
    var phi_1333_: bool;
    var phi_1334_: bool;
    var phi_1335_: bool;
    var phi_1336_: bool;
    var phi_1340_: bool;
    var phi_1346_: bool;
    var phi_1354_: u32;
    var phi_1359_: u32;
    var phi_1368_: u32;
    var phi_1373_: u32;
    var phi_1377_: u32;
    var phi_1378_: u32;
    var phi_1379_: u32;
    var phi_1383_: f32;
    var phi_1385_: mask_Masked;
    var phi_1435_: bool;
    var phi_1436_: u32;
    var phi_1447_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e56 = id_1;
    let _e57 = local_2;
    let _e62 = arrayLength((&last_bits.member));
    let _e70 = p.member.current.size[0u];
    let _e72 = p.member.current.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e56, _e70, _e72);
    if (bitcast<i32>(_e73.word) != 0i) {
        let _e80 = p.member.light.number;
        let _e81 = (_e80 * 3u);
        let _e83 = (_e81 % 32u);
        let _e85 = p.member.light.mask_words;
        let _e89 = p.member.current.size[0u];
        let _e92 = past.member[_e73.shift];
        let _e97 = visibility.member[_e73.shift];
        let _e103 = samples.member[_e73.shift].normal[0u];
        let _e105 = global[0u];
        if (_e103 == _e105) {
            let _e108 = samples.member[_e73.shift].normal[1u];
            let _e110 = global[1u];
            if (_e108 == _e110) {
                let _e113 = samples.member[_e73.shift].normal[2u];
                let _e115 = global[2u];
                phi_364_ = (_e113 == _e115);
                phi_365_ = false;
            } else {
                phi_364_ = bool();
                phi_365_ = true;
            }
            let _e118 = phi_364_;
            let _e120 = phi_365_;
            phi_366_ = _e118;
            phi_367_ = _e120;
        } else {
            phi_366_ = bool();
            phi_367_ = true;
        }
        let _e122 = phi_366_;
        let _e124 = phi_367_;
        if _e124 {
            phi_371_ = false;
        } else {
            phi_371_ = _e122;
        }
        let _e126 = phi_371_;
        if !(_e126) {
            let _e129 = samples.member[_e73.shift].position;
            let _e131 = p.member.light.place;
            let _e137 = p.member.light.place[3u];
            let _e144 = (_e131.x - (_e129.x * _e137));
            let _e145 = (_e131.y - (_e129.y * _e137));
            let _e146 = (_e131.z - (_e129.z * _e137));
            let _e148 = samples.member[_e73.shift].normal;
            if ((((_e148.x * _e144) + (_e148.y * _e145)) + (_e148.z * _e146)) > 0f) {
                let _e162 = (((_e144 * _e144) + (_e145 * _e145)) + (_e146 * _e146));
                let _e164 = p.member.light.axis;
                let _e176 = p.member.light.place[3u];
                if (_e176 == 0f) {
                    phi_442_ = true;
                } else {
                    let _e179 = p.member.light.range_squared;
                    if (_e162 <= _e179) {
                        let _e182 = p.member.light.cos_outer;
                        phi_441_ = (-((((_e144 * _e164.x) + (_e145 * _e164.y)) + (_e146 * _e164.z))) >= (_e182 * sqrt(_e162)));
                    } else {
                        phi_441_ = false;
                    }
                    let _e187 = phi_441_;
                    phi_442_ = _e187;
                }
                let _e189 = phi_442_;
                if _e189 {
                    let _e191 = samples.member[_e73.shift].flags;
                    let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e199.unnamed.visibility, false), _e199.unnamed_1);
                    phi_453_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e205.unnamed, ((_e191 & 1u) == 0u));
                    phi_454_ = false;
                } else {
                    phi_453_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_454_ = true;
                }
                let _e210 = phi_453_;
                let _e212 = phi_454_;
                phi_455_ = _e210;
                phi_456_ = _e212;
            } else {
                phi_455_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_456_ = true;
            }
            let _e214 = phi_455_;
            let _e216 = phi_456_;
            if _e216 {
                let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
                phi_463_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, true);
            } else {
                phi_463_ = _e214;
            }
            let _e233 = phi_463_;
            phi_467_ = _e233;
        } else {
            let _e239 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e245 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e239.unnamed.visibility, false), _e239.unnamed_1);
            phi_467_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e245.unnamed, true);
        }
        let _e250 = phi_467_;
        if _e250.unnamed_1 {
            phi_1385_ = mask_Masked(_e250.unnamed.visibility, 0u, false);
        } else {
            let _e255 = (_e97 < 0.5f);
            if (_e97 > 0f) {
                phi_480_ = (_e97 < 1f);
            } else {
                phi_480_ = false;
            }
            let _e259 = phi_480_;
            let _e266 = lt_mask_Reprojection(vec2<u32>(_e56.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e273 = lt_mask_Reprojection(vec2<u32>(_e266.pixel.x, _e56.y), _e266.is_valid, _e266.has_moved);
            let _e277 = lt_mask_Reprojection(_e273.pixel, true, _e273.has_moved);
            let _e283 = p.member.flags;
            if ((_e283 & 16u) == 0u) {
                phi_520_ = true;
            } else {
                let _e288 = samples.member[_e73.shift].position[0u];
                if (_e92.x == _e288) {
                    let _e291 = samples.member[_e73.shift].position[1u];
                    if (_e92.y == _e291) {
                        let _e294 = samples.member[_e73.shift].position[2u];
                        phi_508_ = (_e92.z == _e294);
                        phi_509_ = false;
                    } else {
                        phi_508_ = bool();
                        phi_509_ = true;
                    }
                    let _e297 = phi_508_;
                    let _e299 = phi_509_;
                    phi_510_ = _e297;
                    phi_511_ = _e299;
                } else {
                    phi_510_ = bool();
                    phi_511_ = true;
                }
                let _e301 = phi_510_;
                let _e303 = phi_511_;
                if _e303 {
                    phi_515_ = false;
                } else {
                    phi_515_ = _e301;
                }
                let _e305 = phi_515_;
                if _e305 {
                    phi_519_ = false;
                } else {
                    phi_519_ = true;
                }
                let _e307 = phi_519_;
                phi_520_ = _e307;
            }
            let _e309 = phi_520_;
            if _e309 {
                let _e311 = samples.member[_e73.shift].position;
                let _e315 = p.member.previous.eye;
                let _e317 = (_e92.x - _e315.x);
                let _e319 = (_e92.y - _e315.y);
                let _e321 = (_e92.z - _e315.z);
                let _e323 = p.member.previous.forward;
                let _e331 = (((_e317 * _e323.x) + (_e319 * _e323.y)) + (_e321 * _e323.z));
                let _e333 = p.member.previous.right;
                let _e343 = p.member.previous.right;
                let _e358 = p.member.previous.up;
                let _e368 = p.member.previous.up;
                let _e383 = p.member.current.eye;
                let _e386 = (_e311.x - _e383.x);
                let _e389 = (_e311.y - _e383.y);
                let _e392 = (_e311.z - _e383.z);
                let _e394 = p.member.current.forward;
                let _e402 = (((_e386 * _e394.x) + (_e389 * _e394.y)) + (_e392 * _e394.z));
                let _e404 = p.member.current.right;
                let _e414 = p.member.current.right;
                let _e429 = p.member.current.up;
                let _e439 = p.member.current.up;
                let _e458 = p.member.current.size[0u];
                let _e460 = (((((((_e317 * _e333.x) + (_e319 * _e333.y)) + (_e321 * _e333.z)) / ((((_e343.x * _e343.x) + (_e343.y * _e343.y)) + (_e343.z * _e343.z)) * _e331)) - ((((_e386 * _e404.x) + (_e389 * _e404.y)) + (_e392 * _e404.z)) / ((((_e414.x * _e414.x) + (_e414.y * _e414.y)) + (_e414.z * _e414.z)) * _e402))) * 0.5f) * f32(_e458));
                let _e464 = p.member.current.size[1u];
                let _e466 = (((((((_e317 * _e358.x) + (_e319 * _e358.y)) + (_e321 * _e358.z)) / ((((_e368.x * _e368.x) + (_e368.y * _e368.y)) + (_e368.z * _e368.z)) * _e331)) - ((((_e386 * _e429.x) + (_e389 * _e429.y)) + (_e392 * _e429.z)) / ((((_e439.x * _e439.x) + (_e439.y * _e439.y)) + (_e439.z * _e439.z)) * _e402))) * -0.5f) * f32(_e464));
                let _e470 = p.member.current.grid[0u];
                let _e472 = p.member.current.grid[1u];
                let _e492 = p.member.current.size[0u];
                let _e494 = p.member.current.size[1u];
                let _e496 = ((f32(_e56.x) + ((f32((_e56.y & (_e472 - 1u))) + 0.5f) / f32(_e472))) + _e460);
                if (_e496 > -8388608f) {
                    let _e508 = f32(select(0i, select(select(i32(_e496), i32(-2147483648), (_e496 < bitcast<f32>(3472883712u))), 2147483647i, (_e496 > bitcast<f32>(1325400063u))), (_e496 == _e496)));
                    if (_e508 > _e496) {
                        phi_728_ = 1f;
                    } else {
                        phi_728_ = 0f;
                    }
                    let _e511 = phi_728_;
                    if (_e496 < 8388608f) {
                        phi_733_ = (_e508 - _e511);
                        phi_734_ = false;
                    } else {
                        phi_733_ = f32();
                        phi_734_ = true;
                    }
                    let _e514 = phi_733_;
                    let _e516 = phi_734_;
                    phi_735_ = _e514;
                    phi_736_ = _e516;
                } else {
                    phi_735_ = f32();
                    phi_736_ = true;
                }
                let _e518 = phi_735_;
                let _e520 = phi_736_;
                if _e520 {
                    phi_740_ = _e496;
                } else {
                    phi_740_ = _e518;
                }
                let _e522 = phi_740_;
                let _e523 = ((f32(_e56.y) + ((f32((_e56.x & (_e470 - 1u))) + 0.5f) / f32(_e470))) + _e466);
                if (_e523 > -8388608f) {
                    let _e535 = f32(select(0i, select(select(i32(_e523), i32(-2147483648), (_e523 < bitcast<f32>(3472883712u))), 2147483647i, (_e523 > bitcast<f32>(1325400063u))), (_e523 == _e523)));
                    if (_e535 > _e523) {
                        phi_761_ = 1f;
                    } else {
                        phi_761_ = 0f;
                    }
                    let _e538 = phi_761_;
                    if (_e523 < 8388608f) {
                        phi_766_ = (_e535 - _e538);
                        phi_767_ = false;
                    } else {
                        phi_766_ = f32();
                        phi_767_ = true;
                    }
                    let _e541 = phi_766_;
                    let _e543 = phi_767_;
                    phi_768_ = _e541;
                    phi_769_ = _e543;
                } else {
                    phi_768_ = f32();
                    phi_769_ = true;
                }
                let _e545 = phi_768_;
                let _e547 = phi_769_;
                if _e547 {
                    phi_773_ = _e523;
                } else {
                    phi_773_ = _e545;
                }
                let _e549 = phi_773_;
                if (_e522 >= 0f) {
                    if (_e549 >= 0f) {
                        if (_e522 < f32(_e492)) {
                            let _e555 = (_e549 < f32(_e494));
                            if (_e460 == 0f) {
                                phi_794_ = (_e466 == 0f);
                            } else {
                                phi_794_ = false;
                            }
                            let _e559 = phi_794_;
                            if _e555 {
                                phi_813_ = vec2<u32>(select(select(u32(_e522), 0u, (_e522 < bitcast<f32>(0u))), 4294967295u, (_e522 > bitcast<f32>(1333788671u))), select(select(u32(_e549), 0u, (_e549 < bitcast<f32>(0u))), 4294967295u, (_e549 > bitcast<f32>(1333788671u))));
                                phi_814_ = false;
                            } else {
                                phi_813_ = vec2<u32>();
                                phi_814_ = true;
                            }
                            let _e576 = phi_813_;
                            let _e578 = phi_814_;
                            phi_815_ = _e559;
                            phi_816_ = _e555;
                            phi_817_ = _e576;
                            phi_818_ = _e559;
                            phi_819_ = _e555;
                            phi_820_ = false;
                            phi_821_ = _e578;
                        } else {
                            phi_815_ = bool();
                            phi_816_ = bool();
                            phi_817_ = vec2<u32>();
                            phi_818_ = bool();
                            phi_819_ = bool();
                            phi_820_ = true;
                            phi_821_ = false;
                        }
                        let _e580 = phi_815_;
                        let _e582 = phi_816_;
                        let _e584 = phi_817_;
                        let _e586 = phi_818_;
                        let _e588 = phi_819_;
                        let _e590 = phi_820_;
                        let _e592 = phi_821_;
                        phi_822_ = _e580;
                        phi_823_ = _e582;
                        phi_824_ = _e584;
                        phi_825_ = _e586;
                        phi_826_ = _e588;
                        phi_827_ = _e590;
                        phi_828_ = _e592;
                    } else {
                        phi_822_ = bool();
                        phi_823_ = bool();
                        phi_824_ = vec2<u32>();
                        phi_825_ = bool();
                        phi_826_ = bool();
                        phi_827_ = true;
                        phi_828_ = false;
                    }
                    let _e594 = phi_822_;
                    let _e596 = phi_823_;
                    let _e598 = phi_824_;
                    let _e600 = phi_825_;
                    let _e602 = phi_826_;
                    let _e604 = phi_827_;
                    let _e606 = phi_828_;
                    phi_829_ = _e594;
                    phi_830_ = _e596;
                    phi_831_ = _e598;
                    phi_832_ = _e600;
                    phi_833_ = _e602;
                    phi_834_ = _e604;
                    phi_835_ = _e606;
                } else {
                    phi_829_ = bool();
                    phi_830_ = bool();
                    phi_831_ = vec2<u32>();
                    phi_832_ = bool();
                    phi_833_ = bool();
                    phi_834_ = true;
                    phi_835_ = false;
                }
                let _e608 = phi_829_;
                let _e610 = phi_830_;
                let _e612 = phi_831_;
                let _e614 = phi_832_;
                let _e616 = phi_833_;
                let _e618 = phi_834_;
                let _e620 = phi_835_;
                if _e618 {
                    if (_e460 == 0f) {
                        phi_844_ = (_e466 == 0f);
                    } else {
                        phi_844_ = false;
                    }
                    let _e624 = phi_844_;
                    phi_845_ = _e624;
                    phi_846_ = false;
                    phi_847_ = true;
                } else {
                    phi_845_ = _e614;
                    phi_846_ = _e616;
                    phi_847_ = _e620;
                }
                let _e626 = phi_845_;
                let _e628 = phi_846_;
                let _e630 = phi_847_;
                if _e630 {
                    phi_851_ = _e626;
                    phi_852_ = _e628;
                    phi_853_ = vec2<u32>(_e56.x, _e56.y);
                } else {
                    phi_851_ = _e608;
                    phi_852_ = _e610;
                    phi_853_ = _e612;
                }
                let _e632 = phi_851_;
                let _e634 = phi_852_;
                let _e636 = phi_853_;
                let _e646 = lt_mask_Reprojection(vec2<u32>(_e636.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e653 = lt_mask_Reprojection(vec2<u32>(_e646.pixel.x, _e636.y), _e646.is_valid, _e646.has_moved);
                let _e657 = lt_mask_Reprojection(_e653.pixel, _e634, _e653.has_moved);
                let _e661 = lt_mask_Reprojection(_e657.pixel, _e657.is_valid, !(_e632));
                if _e634 {
                    let _e664 = p.member.previous.eye;
                    let _e672 = p.member.previous.forward;
                    let _e681 = (((((_e92.x - _e664.x) * _e672.x) + ((_e92.y - _e664.y) * _e672.y)) + ((_e92.z - _e664.z) * _e672.z)) > 0f);
                    let _e685 = lt_mask_Reprojection(_e661.pixel, _e681, _e661.has_moved);
                    if _e681 {
                        phi_888_ = false;
                    } else {
                        phi_888_ = true;
                    }
                    let _e687 = phi_888_;
                    phi_890_ = _e685;
                    phi_891_ = _e685;
                    phi_892_ = _e687;
                } else {
                    phi_890_ = lt_mask_Reprojection();
                    phi_891_ = lt_mask_Reprojection(_e661.pixel, false, _e661.has_moved);
                    phi_892_ = true;
                }
                let _e693 = phi_890_;
                let _e695 = phi_891_;
                let _e697 = phi_892_;
                if _e697 {
                    phi_896_ = false;
                } else {
                    phi_896_ = true;
                }
                let _e699 = phi_896_;
                phi_897_ = _e695;
                phi_898_ = _e693;
                phi_899_ = _e699;
            } else {
                phi_897_ = lt_mask_Reprojection();
                phi_898_ = lt_mask_Reprojection(_e277.pixel, _e277.is_valid, false);
                phi_899_ = true;
            }
            let _e701 = phi_897_;
            let _e703 = phi_898_;
            let _e705 = phi_899_;
            if _e705 {
                let _e707 = p.member.flags;
                phi_907_ = ((_e707 & 1u) != 0u);
                phi_908_ = _e703;
            } else {
                phi_907_ = false;
                phi_908_ = _e701;
            }
            let _e711 = phi_907_;
            let _e713 = phi_908_;
            let _e717 = lt_mask_Reprojection(_e713.pixel, _e711, _e713.has_moved);
            let _e718 = lt_mask_Neighbourhood(false, true);
            if _e259 {
                phi_914_ = false;
            } else {
                phi_914_ = true;
            }
            let _e720 = phi_914_;
            if _e720 {
                if _e711 {
                    if ((0u & 2u) != 0u) {
                        phi_1207_ = _e718;
                    } else {
                        let _e724 = p.member.expansion;
                        if _e717.has_moved {
                            let _e727 = p.member.moving_pattern;
                            phi_936_ = _e727;
                        } else {
                            let _e729 = p.member.still_pattern;
                            phi_936_ = _e729;
                        }
                        let _e731 = phi_936_;
                        phi_938_ = 0u;
                        phi_941_ = _e718;
                        loop {
                            let _e733 = phi_938_;
                            let _e735 = phi_941_;
                            local_1 = _e735;
                            if (1u <= _e731) {
                                if (_e731 <= 4u) {
                                    phi_953_ = false;
                                } else {
                                    phi_953_ = true;
                                }
                                let _e739 = phi_953_;
                                phi_954_ = _e739;
                            } else {
                                phi_954_ = true;
                            }
                            let _e741 = phi_954_;
                            if _e741 {
                                switch bitcast<i32>(_e731) {
                                    case 5: {
                                        phi_963_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_963_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_963_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_963_ = 9u;
                                        break;
                                    }
                                }
                                let _e744 = phi_963_;
                                phi_964_ = _e744;
                            } else {
                                phi_964_ = 5u;
                            }
                            let _e746 = phi_964_;
                            let _e747 = (_e733 < _e746);
                            if _e747 {
                                let _e753 = p.member.frame;
                                let _e757 = p.member.current.size[0u];
                                let _e759 = p.member.current.size[1u];
                                switch bitcast<i32>(_e731) {
                                    case 1: {
                                        let _e769 = lt_mask_pattern_plus(_e733);
                                        phi_1044_ = vec2<i32>(_e769.x, _e769.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e773 = lt_mask_pattern_cross(_e733);
                                        phi_1044_ = vec2<i32>(_e773.x, _e773.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e779 = lt_mask_pattern_plus_or_cross(_e733, ((_e717.pixel.x + _e717.pixel.y) & 1u));
                                        phi_1044_ = vec2<i32>(_e779.x, _e779.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e784 = lt_mask_pattern_plus_or_cross(_e733, (_e753 & 1u));
                                        phi_1044_ = vec2<i32>(_e784.x, _e784.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e753 & 3u)) {
                                            case 0: {
                                                phi_1024_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1024_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1024_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1024_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e795 = phi_1024_;
                                        phi_1044_ = (_e795 + vec2<i32>(bitcast<i32>((_e733 & 1u)), bitcast<i32>(((_e733 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1044_ = vec2<i32>((bitcast<i32>((_e733 % 5u)) - 2i), (bitcast<i32>(((_e733 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e812 = lt_mask_pattern_diamond(_e733);
                                        phi_1044_ = vec2<i32>(_e812.x, _e812.y);
                                        break;
                                    }
                                    default: {
                                        phi_1044_ = vec2<i32>((bitcast<i32>((_e733 % 3u)) - 1i), (bitcast<i32>(((_e733 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e817 = phi_1044_;
                                let _e820 = lt_mask_pattern_step_clamped(_e717.pixel.x, _e817.x, _e757);
                                let _e821 = lt_mask_pattern_step_clamped(_e717.pixel.y, _e817.y, _e759);
                                let _e825 = ((((_e821 * _e89) + _e820) * _e85) + (_e81 / 32u));
                                if (_e83 > 29u) {
                                    let _e827 = (_e825 + 1u);
                                    if (_e827 < _e62) {
                                    } else {
                                        return;
                                    }
                                    let _e831 = last_bits.member[(0u + _e827)];
                                    phi_1069_ = _e831;
                                } else {
                                    phi_1069_ = 0u;
                                }
                                let _e833 = phi_1069_;
                                if (_e825 < _e62) {
                                } else {
                                    return;
                                }
                                let _e837 = last_bits.member[(0u + _e825)];
                                let _e840 = (_e837 >> bitcast<u32>((_e83 & 31u)));
                                if (_e83 > 29u) {
                                    phi_1088_ = (_e840 | (_e833 << bitcast<u32>(((32u - _e83) & 31u))));
                                } else {
                                    phi_1088_ = _e840;
                                }
                                let _e848 = phi_1088_;
                                if ((_e848 & 2u) == 0u) {
                                    phi_1096_ = (_e848 & 1u);
                                } else {
                                    phi_1096_ = (_e848 & 7u);
                                }
                                let _e854 = phi_1096_;
                                if _e735.any_expands {
                                    phi_1184_ = true;
                                } else {
                                    if ((_e854 & 2u) != 0u) {
                                        let _e861 = (((_e854 & 4u) != 0u) != _e255);
                                        switch bitcast<i32>(_e724) {
                                            case 1: {
                                                phi_1124_ = bool();
                                                phi_1125_ = false;
                                                phi_1126_ = true;
                                                phi_1127_ = false;
                                                phi_1128_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e861 {
                                                    phi_1122_ = (((_e854 & 4u) != 0u) != ((_e854 & 1u) != 0u));
                                                    phi_1123_ = false;
                                                } else {
                                                    phi_1122_ = bool();
                                                    phi_1123_ = true;
                                                }
                                                let _e869 = phi_1122_;
                                                let _e871 = phi_1123_;
                                                phi_1124_ = _e869;
                                                phi_1125_ = false;
                                                phi_1126_ = false;
                                                phi_1127_ = _e871;
                                                phi_1128_ = _e861;
                                                break;
                                            }
                                            default: {
                                                phi_1124_ = bool();
                                                phi_1125_ = true;
                                                phi_1126_ = false;
                                                phi_1127_ = false;
                                                phi_1128_ = false;
                                                break;
                                            }
                                        }
                                        let _e873 = phi_1124_;
                                        let _e875 = phi_1125_;
                                        let _e877 = phi_1126_;
                                        let _e879 = phi_1127_;
                                        let _e881 = phi_1128_;
                                        phi_1136_ = _e861;
                                        phi_1137_ = _e873;
                                        phi_1138_ = _e875;
                                        phi_1139_ = _e877;
                                        phi_1140_ = _e879;
                                        phi_1141_ = _e881;
                                    } else {
                                        switch bitcast<i32>(_e724) {
                                            case 1: {
                                                phi_1133_ = false;
                                                phi_1134_ = true;
                                                phi_1135_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1133_ = false;
                                                phi_1134_ = false;
                                                phi_1135_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1133_ = true;
                                                phi_1134_ = false;
                                                phi_1135_ = false;
                                                break;
                                            }
                                        }
                                        let _e884 = phi_1133_;
                                        let _e886 = phi_1134_;
                                        let _e888 = phi_1135_;
                                        phi_1136_ = false;
                                        phi_1137_ = bool();
                                        phi_1138_ = _e884;
                                        phi_1139_ = _e886;
                                        phi_1140_ = _e888;
                                        phi_1141_ = false;
                                    }
                                    let _e890 = phi_1136_;
                                    let _e892 = phi_1137_;
                                    let _e894 = phi_1138_;
                                    let _e896 = phi_1139_;
                                    let _e898 = phi_1140_;
                                    let _e900 = phi_1141_;
                                    if _e894 {
                                        if ((_e854 & 2u) != 0u) {
                                            if (((_e854 & 4u) != 0u) != _e255) {
                                                phi_1156_ = false;
                                            } else {
                                                phi_1156_ = true;
                                            }
                                            let _e907 = phi_1156_;
                                            phi_1157_ = _e907;
                                        } else {
                                            phi_1157_ = true;
                                        }
                                        let _e909 = phi_1157_;
                                        if _e909 {
                                            phi_1164_ = (((_e854 & 1u) != 0u) != _e255);
                                        } else {
                                            phi_1164_ = true;
                                        }
                                        let _e914 = phi_1164_;
                                        phi_1165_ = _e914;
                                        phi_1166_ = false;
                                        phi_1167_ = false;
                                        phi_1168_ = false;
                                    } else {
                                        phi_1165_ = bool();
                                        phi_1166_ = _e896;
                                        phi_1167_ = _e898;
                                        phi_1168_ = _e900;
                                    }
                                    let _e916 = phi_1165_;
                                    let _e918 = phi_1166_;
                                    let _e920 = phi_1167_;
                                    let _e922 = phi_1168_;
                                    if _e918 {
                                        phi_1172_ = _e890;
                                        phi_1173_ = false;
                                        phi_1174_ = false;
                                    } else {
                                        phi_1172_ = _e916;
                                        phi_1173_ = _e920;
                                        phi_1174_ = _e922;
                                    }
                                    let _e924 = phi_1172_;
                                    let _e926 = phi_1173_;
                                    let _e928 = phi_1174_;
                                    if _e926 {
                                        phi_1178_ = false;
                                        phi_1179_ = true;
                                    } else {
                                        phi_1178_ = _e892;
                                        phi_1179_ = _e928;
                                    }
                                    let _e930 = phi_1178_;
                                    let _e932 = phi_1179_;
                                    if _e932 {
                                        phi_1183_ = _e930;
                                    } else {
                                        phi_1183_ = _e924;
                                    }
                                    let _e934 = phi_1183_;
                                    phi_1184_ = _e934;
                                }
                                let _e936 = phi_1184_;
                                if _e735.all_remove {
                                    if (((_e854 & 1u) != 0u) == _e255) {
                                        if ((_e854 & 2u) != 0u) {
                                            phi_1202_ = (((_e854 & 4u) != 0u) == _e255);
                                        } else {
                                            phi_1202_ = true;
                                        }
                                        let _e946 = phi_1202_;
                                        phi_1203_ = _e946;
                                    } else {
                                        phi_1203_ = false;
                                    }
                                    let _e948 = phi_1203_;
                                    phi_1204_ = _e948;
                                } else {
                                    phi_1204_ = false;
                                }
                                let _e950 = phi_1204_;
                                phi_939_ = (_e733 + 1u);
                                phi_942_ = lt_mask_Neighbourhood(_e936, _e950);
                            } else {
                                phi_939_ = u32();
                                phi_942_ = lt_mask_Neighbourhood();
                            }
                            let _e954 = phi_939_;
                            let _e956 = phi_942_;
                            continue;
                            continuing {
                                phi_938_ = _e954;
                                phi_941_ = _e956;
                                break if !(_e747);
                            }
                        }
                        let _e1254 = local_1;
                        phi_1207_ = _e1254;
                    }
                    let _e959 = phi_1207_;
                    phi_1208_ = _e959;
                } else {
                    phi_1208_ = _e718;
                }
                let _e961 = phi_1208_;
                phi_1209_ = _e961;
            } else {
                phi_1209_ = _e718;
            }
            let _e963 = phi_1209_;
            let _e966 = p.member.frame;
            let _e968 = p.member.refresh;
            if (_e968 == 0u) {
                phi_1242_ = false;
            } else {
                if (_e968 == 0u) {
                    return;
                }
                let _e977 = ((_e56.x + (_e56.y * (((_e968 * 5u) / 8u) | 1u))) + (_e966 % _e968));
                if (_e968 == 0u) {
                    phi_1241_ = (_e977 == 0u);
                } else {
                    if (_e968 == 0u) {
                        return;
                    }
                    phi_1241_ = ((_e977 % _e968) == 0u);
                }
                let _e984 = phi_1241_;
                phi_1242_ = _e984;
            }
            let _e986 = phi_1242_;
            if _e711 {
                if _e986 {
                    phi_1264_ = bool();
                } else {
                    phi_1264_ = ((0u & 2u) != 0u);
                }
                let _e992 = phi_1264_;
                phi_1265_ = _e992;
                phi_1266_ = _e986;
            } else {
                phi_1265_ = bool();
                phi_1266_ = true;
            }
            let _e994 = phi_1265_;
            let _e996 = phi_1266_;
            if _e996 {
                phi_1270_ = false;
            } else {
                phi_1270_ = _e994;
            }
            let _e998 = phi_1270_;
            if _e998 {
                phi_1321_ = 7u;
            } else {
                if (_e97 != 0.5f) {
                    if _e711 {
                        if _e986 {
                            phi_1318_ = 6u;
                        } else {
                            if _e259 {
                                phi_1293_ = true;
                            } else {
                                if _e963.any_expands {
                                    phi_1292_ = false;
                                } else {
                                    phi_1292_ = true;
                                }
                                let _e1000 = phi_1292_;
                                phi_1293_ = _e1000;
                            }
                            let _e1002 = phi_1293_;
                            if _e1002 {
                                if _e259 {
                                    if false {
                                        if _e963.all_remove {
                                            phi_1306_ = false;
                                        } else {
                                            phi_1306_ = true;
                                        }
                                        let _e1004 = phi_1306_;
                                        phi_1307_ = _e1004;
                                    } else {
                                        phi_1307_ = true;
                                    }
                                    let _e1006 = phi_1307_;
                                    phi_1308_ = _e1006;
                                } else {
                                    phi_1308_ = true;
                                }
                                let _e1008 = phi_1308_;
                                if _e1008 {
                                    if _e259 {
                                        phi_1315_ = 1u;
                                    } else {
                                        phi_1315_ = 0u;
                                    }
                                    let _e1010 = phi_1315_;
                                    phi_1316_ = _e1010;
                                } else {
                                    phi_1316_ = 5u;
                                }
                                let _e1012 = phi_1316_;
                                phi_1317_ = _e1012;
                            } else {
                                phi_1317_ = 4u;
                            }
                            let _e1014 = phi_1317_;
                            phi_1318_ = _e1014;
                        }
                        let _e1016 = phi_1318_;
                        phi_1319_ = _e1016;
                    } else {
                        phi_1319_ = 3u;
                    }
                    let _e1018 = phi_1319_;
                    phi_1320_ = _e1018;
                } else {
                    phi_1320_ = 2u;
                }
                let _e1020 = phi_1320_;
                phi_1321_ = _e1020;
            }
            let _e1022 = phi_1321_;
            if !((_e1022 == 0u)) {
                if !((_e1022 == 5u)) {
                    phi_1333_ = !(_e998);
                    phi_1334_ = false;
                } else {
                    phi_1333_ = bool();
                    phi_1334_ = true;
                }
                let _e1029 = phi_1333_;
                let _e1031 = phi_1334_;
                phi_1335_ = _e1029;
                phi_1336_ = _e1031;
            } else {
                phi_1335_ = bool();
                phi_1336_ = true;
            }
            let _e1033 = phi_1335_;
            let _e1035 = phi_1336_;
            if _e1035 {
                phi_1340_ = false;
            } else {
                phi_1340_ = _e1033;
            }
            let _e1037 = phi_1340_;
            if _e998 {
                phi_1346_ = ((0u & 4u) != 0u);
            } else {
                phi_1346_ = _e255;
            }
            let _e1041 = phi_1346_;
            if _e1037 {
                if _e255 {
                    phi_1354_ = (2u | 1u);
                } else {
                    phi_1354_ = 2u;
                }
                let _e1044 = phi_1354_;
                if false {
                    phi_1359_ = (_e1044 | 4u);
                } else {
                    phi_1359_ = _e1044;
                }
                let _e1047 = phi_1359_;
                phi_1379_ = _e1047;
            } else {
                if (_e1022 == 7u) {
                    if _e255 {
                        phi_1368_ = (2u | 1u);
                    } else {
                        phi_1368_ = 2u;
                    }
                    let _e1051 = phi_1368_;
                    if _e1041 {
                        phi_1373_ = (_e1051 | 4u);
                    } else {
                        phi_1373_ = _e1051;
                    }
                    let _e1054 = phi_1373_;
                    phi_1378_ = _e1054;
                } else {
                    if _e255 {
                        phi_1377_ = 1u;
                    } else {
                        phi_1377_ = 0u;
                    }
                    let _e1056 = phi_1377_;
                    phi_1378_ = _e1056;
                }
                let _e1058 = phi_1378_;
                phi_1379_ = _e1058;
            }
            let _e1060 = phi_1379_;
            if _e1041 {
                phi_1383_ = 0f;
            } else {
                phi_1383_ = 1f;
            }
            let _e1062 = phi_1383_;
            phi_1385_ = mask_Masked(_e1062, _e1060, _e1037);
        }
        let _e1065 = phi_1385_;
        visibility.member[_e73.shift] = _e1065.visibility;
        let _e1070 = p.member.light.number;
        let _e1071 = (_e1070 * 3u);
        let _e1073 = (_e1071 % 32u);
        let _e1075 = p.member.light.mask_words;
        let _e1077 = ((_e73.shift * _e1075) + (_e1071 / 32u));
        let _e1079 = bits.member[_e1077];
        bits.member[_e1077] = ((_e1079 & ~((7u << bitcast<u32>((_e1073 & 31u))))) | (_e1065.bits << bitcast<u32>((_e1073 & 31u))));
        if (_e1073 > 29u) {
            let _e1094 = bits.member[(_e1077 + 1u)];
            let _e1096 = (32u - _e1073);
            bits.member[(_e1077 + 1u)] = ((_e1094 & ~((7u >> bitcast<u32>((_e1096 & 31u))))) | (_e1065.bits >> bitcast<u32>((_e1096 & 31u))));
        }
        phi_1435_ = _e1065.needs_ray;
        phi_1436_ = _e73.shift;
    } else {
        phi_1435_ = false;
        phi_1436_ = 0u;
    }
    let _e1110 = phi_1435_;
    let _e1112 = phi_1436_;
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1110 {
        let _e1116 = atomicAdd((&shared_[0u]), 1u);
        phi_1447_ = _e1116;
    } else {
        phi_1447_ = 0u;
    }
    let _e1118 = phi_1447_;
    workgroupBarrier();
    if (_e57 == 0u) {
        let _e1122 = atomicLoad((&shared_[0u]));
        let _e1123 = atomicAdd((&list.member[3u]), _e1122);
        atomicStore((&shared_[1u]), _e1123);
    }
    workgroupBarrier();
    if _e1110 {
        let _e1126 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1126) + _e1118)]), _e1112);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
