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
    var phi_949_: u32;
    var phi_968_: u32;
    var phi_976_: u32;
    var phi_977_: u32;
    var phi_978_: bool;
    var phi_979_: u32;
    var phi_980_: bool;
    var phi_981_: bool;
    var phi_982_: u32;
    var phi_983_: bool;
    var phi_984_: bool;
    var phi_988_: bool;
    var phi_992_: u32;
    var phi_997_: bool;
    var phi_1019_: u32;
    var phi_1021_: u32;
    var phi_1024_: lt_mask_Neighbourhood;
    var phi_1036_: bool;
    var phi_1037_: bool;
    var phi_1046_: u32;
    var phi_1047_: u32;
    var phi_1107_: vec2<i32>;
    var phi_1127_: vec2<i32>;
    var phi_1152_: u32;
    var phi_1171_: u32;
    var phi_1179_: u32;
    var phi_1205_: bool;
    var phi_1206_: bool;
    var phi_1207_: bool;
    var phi_1208_: bool;
    var phi_1209_: bool;
    var phi_1210_: bool;
    var phi_1211_: bool;
    var phi_1216_: bool;
    var phi_1217_: bool;
    var phi_1218_: bool;
    var phi_1219_: bool;
    var phi_1220_: bool;
    var phi_1221_: bool;
    var phi_1222_: bool;
    var phi_1223_: bool;
    var phi_1224_: bool;
    var phi_1239_: bool;
    var phi_1240_: bool;
    var phi_1247_: bool;
    var phi_1248_: bool;
    var phi_1249_: bool;
    var phi_1250_: bool;
    var phi_1251_: bool;
    var phi_1255_: bool;
    var phi_1256_: bool;
    var phi_1257_: bool;
    var phi_1261_: bool;
    var phi_1262_: bool;
    var phi_1266_: bool;
    var phi_1267_: bool;
    var phi_1285_: bool;
    var phi_1286_: bool;
    var phi_1287_: bool;
    var phi_1022_: u32;
    var phi_1025_: lt_mask_Neighbourhood;
    var phi_1290_: lt_mask_Neighbourhood;
    var phi_1291_: lt_mask_Neighbourhood;
    var phi_1292_: lt_mask_Neighbourhood;
    var phi_1324_: bool;
    var phi_1325_: bool;
    var phi_1347_: bool;
    var phi_1348_: bool;
    var phi_1349_: bool;
    var phi_1353_: bool;
    var phi_1375_: bool;
    var phi_1376_: bool;
    var phi_1389_: bool;
    var phi_1390_: bool;
    var phi_1391_: bool;
    var phi_1398_: u32;
    var phi_1399_: u32;
    var phi_1400_: u32;
    var phi_1401_: u32;
    var phi_1402_: u32;
    var phi_1403_: u32;
    var phi_1404_: u32;
    var phi_1416_: bool;
    var phi_1417_: bool;
    var phi_1418_: bool;
    var phi_1419_: bool;
    var phi_1423_: bool;
    var phi_1429_: bool;
    var phi_1437_: u32;
    var phi_1442_: u32;
    var phi_1451_: u32;
    var phi_1456_: u32;
    var phi_1460_: u32;
    var phi_1461_: u32;
    var phi_1462_: u32;
    var phi_1466_: f32;
    var phi_1468_: mask_Masked;
    var phi_1518_: bool;
    var phi_1519_: u32;
    var phi_1530_: u32;
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
        let _e82 = (_e81 / 32u);
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
            phi_1468_ = mask_Masked(_e250.unnamed.visibility, 0u, false);
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
            let _e719 = p.member.flags;
            let _e721 = ((_e719 & 2u) != 0u);
            let _e723 = p.member.flags;
            if ((_e723 & 4u) == 0u) {
                phi_982_ = u32();
                phi_983_ = true;
                phi_984_ = false;
            } else {
                if _e711 {
                    if !(_e717.has_moved) {
                        let _e731 = ((((_e56.y * _e89) + _e56.x) * _e85) + _e82);
                        if (_e83 > 29u) {
                            let _e733 = (_e731 + 1u);
                            if (_e733 < _e62) {
                            } else {
                                return;
                            }
                            let _e737 = last_bits.member[(0u + _e733)];
                            phi_949_ = _e737;
                        } else {
                            phi_949_ = 0u;
                        }
                        let _e739 = phi_949_;
                        if (_e731 < _e62) {
                        } else {
                            return;
                        }
                        let _e743 = last_bits.member[(0u + _e731)];
                        let _e746 = (_e743 >> bitcast<u32>((_e83 & 31u)));
                        if (_e83 > 29u) {
                            phi_968_ = (_e746 | (_e739 << bitcast<u32>(((32u - _e83) & 31u))));
                        } else {
                            phi_968_ = _e746;
                        }
                        let _e754 = phi_968_;
                        if ((_e754 & 2u) == 0u) {
                            phi_976_ = (_e754 & 1u);
                        } else {
                            phi_976_ = (_e754 & 7u);
                        }
                        let _e760 = phi_976_;
                        phi_977_ = _e760;
                        phi_978_ = false;
                    } else {
                        phi_977_ = u32();
                        phi_978_ = true;
                    }
                    let _e762 = phi_977_;
                    let _e764 = phi_978_;
                    phi_979_ = _e762;
                    phi_980_ = false;
                    phi_981_ = _e764;
                } else {
                    phi_979_ = u32();
                    phi_980_ = true;
                    phi_981_ = false;
                }
                let _e766 = phi_979_;
                let _e768 = phi_980_;
                let _e770 = phi_981_;
                phi_982_ = _e766;
                phi_983_ = _e768;
                phi_984_ = _e770;
            }
            let _e772 = phi_982_;
            let _e774 = phi_983_;
            let _e776 = phi_984_;
            if _e774 {
                phi_988_ = true;
            } else {
                phi_988_ = _e776;
            }
            let _e778 = phi_988_;
            if _e778 {
                phi_992_ = 0u;
            } else {
                phi_992_ = _e772;
            }
            let _e780 = phi_992_;
            let _e781 = lt_mask_Neighbourhood(false, true);
            if _e259 {
                phi_997_ = _e721;
            } else {
                phi_997_ = false;
            }
            let _e783 = phi_997_;
            if _e783 {
                if _e711 {
                    if ((_e780 & 2u) != 0u) {
                        phi_1290_ = _e781;
                    } else {
                        let _e787 = p.member.expansion;
                        if _e717.has_moved {
                            let _e790 = p.member.moving_pattern;
                            phi_1019_ = _e790;
                        } else {
                            let _e792 = p.member.still_pattern;
                            phi_1019_ = _e792;
                        }
                        let _e794 = phi_1019_;
                        phi_1021_ = 0u;
                        phi_1024_ = _e781;
                        loop {
                            let _e796 = phi_1021_;
                            let _e798 = phi_1024_;
                            local_1 = _e798;
                            if (1u <= _e794) {
                                if (_e794 <= 4u) {
                                    phi_1036_ = false;
                                } else {
                                    phi_1036_ = true;
                                }
                                let _e802 = phi_1036_;
                                phi_1037_ = _e802;
                            } else {
                                phi_1037_ = true;
                            }
                            let _e804 = phi_1037_;
                            if _e804 {
                                switch bitcast<i32>(_e794) {
                                    case 5: {
                                        phi_1046_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_1046_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_1046_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_1046_ = 9u;
                                        break;
                                    }
                                }
                                let _e807 = phi_1046_;
                                phi_1047_ = _e807;
                            } else {
                                phi_1047_ = 5u;
                            }
                            let _e809 = phi_1047_;
                            let _e810 = (_e796 < _e809);
                            if _e810 {
                                let _e816 = p.member.frame;
                                let _e820 = p.member.current.size[0u];
                                let _e822 = p.member.current.size[1u];
                                switch bitcast<i32>(_e794) {
                                    case 1: {
                                        let _e832 = lt_mask_pattern_plus(_e796);
                                        phi_1127_ = vec2<i32>(_e832.x, _e832.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e836 = lt_mask_pattern_cross(_e796);
                                        phi_1127_ = vec2<i32>(_e836.x, _e836.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e842 = lt_mask_pattern_plus_or_cross(_e796, ((_e717.pixel.x + _e717.pixel.y) & 1u));
                                        phi_1127_ = vec2<i32>(_e842.x, _e842.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e847 = lt_mask_pattern_plus_or_cross(_e796, (_e816 & 1u));
                                        phi_1127_ = vec2<i32>(_e847.x, _e847.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e816 & 3u)) {
                                            case 0: {
                                                phi_1107_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1107_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1107_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1107_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e858 = phi_1107_;
                                        phi_1127_ = (_e858 + vec2<i32>(bitcast<i32>((_e796 & 1u)), bitcast<i32>(((_e796 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1127_ = vec2<i32>((bitcast<i32>((_e796 % 5u)) - 2i), (bitcast<i32>(((_e796 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e875 = lt_mask_pattern_diamond(_e796);
                                        phi_1127_ = vec2<i32>(_e875.x, _e875.y);
                                        break;
                                    }
                                    default: {
                                        phi_1127_ = vec2<i32>((bitcast<i32>((_e796 % 3u)) - 1i), (bitcast<i32>(((_e796 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e880 = phi_1127_;
                                let _e883 = lt_mask_pattern_step_clamped(_e717.pixel.x, _e880.x, _e820);
                                let _e884 = lt_mask_pattern_step_clamped(_e717.pixel.y, _e880.y, _e822);
                                let _e888 = ((((_e884 * _e89) + _e883) * _e85) + _e82);
                                if (_e83 > 29u) {
                                    let _e890 = (_e888 + 1u);
                                    if (_e890 < _e62) {
                                    } else {
                                        return;
                                    }
                                    let _e894 = last_bits.member[(0u + _e890)];
                                    phi_1152_ = _e894;
                                } else {
                                    phi_1152_ = 0u;
                                }
                                let _e896 = phi_1152_;
                                if (_e888 < _e62) {
                                } else {
                                    return;
                                }
                                let _e900 = last_bits.member[(0u + _e888)];
                                let _e903 = (_e900 >> bitcast<u32>((_e83 & 31u)));
                                if (_e83 > 29u) {
                                    phi_1171_ = (_e903 | (_e896 << bitcast<u32>(((32u - _e83) & 31u))));
                                } else {
                                    phi_1171_ = _e903;
                                }
                                let _e911 = phi_1171_;
                                if ((_e911 & 2u) == 0u) {
                                    phi_1179_ = (_e911 & 1u);
                                } else {
                                    phi_1179_ = (_e911 & 7u);
                                }
                                let _e917 = phi_1179_;
                                if _e798.any_expands {
                                    phi_1267_ = true;
                                } else {
                                    if ((_e917 & 2u) != 0u) {
                                        let _e924 = (((_e917 & 4u) != 0u) != _e255);
                                        switch bitcast<i32>(_e787) {
                                            case 1: {
                                                phi_1207_ = bool();
                                                phi_1208_ = false;
                                                phi_1209_ = true;
                                                phi_1210_ = false;
                                                phi_1211_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e924 {
                                                    phi_1205_ = (((_e917 & 4u) != 0u) != ((_e917 & 1u) != 0u));
                                                    phi_1206_ = false;
                                                } else {
                                                    phi_1205_ = bool();
                                                    phi_1206_ = true;
                                                }
                                                let _e932 = phi_1205_;
                                                let _e934 = phi_1206_;
                                                phi_1207_ = _e932;
                                                phi_1208_ = false;
                                                phi_1209_ = false;
                                                phi_1210_ = _e934;
                                                phi_1211_ = _e924;
                                                break;
                                            }
                                            default: {
                                                phi_1207_ = bool();
                                                phi_1208_ = true;
                                                phi_1209_ = false;
                                                phi_1210_ = false;
                                                phi_1211_ = false;
                                                break;
                                            }
                                        }
                                        let _e936 = phi_1207_;
                                        let _e938 = phi_1208_;
                                        let _e940 = phi_1209_;
                                        let _e942 = phi_1210_;
                                        let _e944 = phi_1211_;
                                        phi_1219_ = _e924;
                                        phi_1220_ = _e936;
                                        phi_1221_ = _e938;
                                        phi_1222_ = _e940;
                                        phi_1223_ = _e942;
                                        phi_1224_ = _e944;
                                    } else {
                                        switch bitcast<i32>(_e787) {
                                            case 1: {
                                                phi_1216_ = false;
                                                phi_1217_ = true;
                                                phi_1218_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1216_ = false;
                                                phi_1217_ = false;
                                                phi_1218_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1216_ = true;
                                                phi_1217_ = false;
                                                phi_1218_ = false;
                                                break;
                                            }
                                        }
                                        let _e947 = phi_1216_;
                                        let _e949 = phi_1217_;
                                        let _e951 = phi_1218_;
                                        phi_1219_ = false;
                                        phi_1220_ = bool();
                                        phi_1221_ = _e947;
                                        phi_1222_ = _e949;
                                        phi_1223_ = _e951;
                                        phi_1224_ = false;
                                    }
                                    let _e953 = phi_1219_;
                                    let _e955 = phi_1220_;
                                    let _e957 = phi_1221_;
                                    let _e959 = phi_1222_;
                                    let _e961 = phi_1223_;
                                    let _e963 = phi_1224_;
                                    if _e957 {
                                        if ((_e917 & 2u) != 0u) {
                                            if (((_e917 & 4u) != 0u) != _e255) {
                                                phi_1239_ = false;
                                            } else {
                                                phi_1239_ = true;
                                            }
                                            let _e970 = phi_1239_;
                                            phi_1240_ = _e970;
                                        } else {
                                            phi_1240_ = true;
                                        }
                                        let _e972 = phi_1240_;
                                        if _e972 {
                                            phi_1247_ = (((_e917 & 1u) != 0u) != _e255);
                                        } else {
                                            phi_1247_ = true;
                                        }
                                        let _e977 = phi_1247_;
                                        phi_1248_ = _e977;
                                        phi_1249_ = false;
                                        phi_1250_ = false;
                                        phi_1251_ = false;
                                    } else {
                                        phi_1248_ = bool();
                                        phi_1249_ = _e959;
                                        phi_1250_ = _e961;
                                        phi_1251_ = _e963;
                                    }
                                    let _e979 = phi_1248_;
                                    let _e981 = phi_1249_;
                                    let _e983 = phi_1250_;
                                    let _e985 = phi_1251_;
                                    if _e981 {
                                        phi_1255_ = _e953;
                                        phi_1256_ = false;
                                        phi_1257_ = false;
                                    } else {
                                        phi_1255_ = _e979;
                                        phi_1256_ = _e983;
                                        phi_1257_ = _e985;
                                    }
                                    let _e987 = phi_1255_;
                                    let _e989 = phi_1256_;
                                    let _e991 = phi_1257_;
                                    if _e989 {
                                        phi_1261_ = false;
                                        phi_1262_ = true;
                                    } else {
                                        phi_1261_ = _e955;
                                        phi_1262_ = _e991;
                                    }
                                    let _e993 = phi_1261_;
                                    let _e995 = phi_1262_;
                                    if _e995 {
                                        phi_1266_ = _e993;
                                    } else {
                                        phi_1266_ = _e987;
                                    }
                                    let _e997 = phi_1266_;
                                    phi_1267_ = _e997;
                                }
                                let _e999 = phi_1267_;
                                if _e798.all_remove {
                                    if (((_e917 & 1u) != 0u) == _e255) {
                                        if ((_e917 & 2u) != 0u) {
                                            phi_1285_ = (((_e917 & 4u) != 0u) == _e255);
                                        } else {
                                            phi_1285_ = true;
                                        }
                                        let _e1009 = phi_1285_;
                                        phi_1286_ = _e1009;
                                    } else {
                                        phi_1286_ = false;
                                    }
                                    let _e1011 = phi_1286_;
                                    phi_1287_ = _e1011;
                                } else {
                                    phi_1287_ = false;
                                }
                                let _e1013 = phi_1287_;
                                phi_1022_ = (_e796 + 1u);
                                phi_1025_ = lt_mask_Neighbourhood(_e999, _e1013);
                            } else {
                                phi_1022_ = u32();
                                phi_1025_ = lt_mask_Neighbourhood();
                            }
                            let _e1017 = phi_1022_;
                            let _e1019 = phi_1025_;
                            continue;
                            continuing {
                                phi_1021_ = _e1017;
                                phi_1024_ = _e1019;
                                break if !(_e810);
                            }
                        }
                        let _e1330 = local_1;
                        phi_1290_ = _e1330;
                    }
                    let _e1022 = phi_1290_;
                    phi_1291_ = _e1022;
                } else {
                    phi_1291_ = _e781;
                }
                let _e1024 = phi_1291_;
                phi_1292_ = _e1024;
            } else {
                phi_1292_ = _e781;
            }
            let _e1026 = phi_1292_;
            let _e1029 = p.member.frame;
            let _e1031 = p.member.refresh;
            if (_e1031 == 0u) {
                phi_1325_ = false;
            } else {
                if (_e1031 == 0u) {
                    return;
                }
                let _e1040 = ((_e56.x + (_e56.y * (((_e1031 * 5u) / 8u) | 1u))) + (_e1029 % _e1031));
                if (_e1031 == 0u) {
                    phi_1324_ = (_e1040 == 0u);
                } else {
                    if (_e1031 == 0u) {
                        return;
                    }
                    phi_1324_ = ((_e1040 % _e1031) == 0u);
                }
                let _e1047 = phi_1324_;
                phi_1325_ = _e1047;
            }
            let _e1049 = phi_1325_;
            if _e711 {
                if _e1049 {
                    phi_1347_ = bool();
                } else {
                    phi_1347_ = ((_e780 & 2u) != 0u);
                }
                let _e1055 = phi_1347_;
                phi_1348_ = _e1055;
                phi_1349_ = _e1049;
            } else {
                phi_1348_ = bool();
                phi_1349_ = true;
            }
            let _e1057 = phi_1348_;
            let _e1059 = phi_1349_;
            if _e1059 {
                phi_1353_ = false;
            } else {
                phi_1353_ = _e1057;
            }
            let _e1061 = phi_1353_;
            if _e1061 {
                phi_1404_ = 7u;
            } else {
                if (_e97 != 0.5f) {
                    if _e711 {
                        if _e1049 {
                            phi_1401_ = 6u;
                        } else {
                            if _e259 {
                                phi_1376_ = true;
                            } else {
                                if _e1026.any_expands {
                                    phi_1375_ = false;
                                } else {
                                    phi_1375_ = true;
                                }
                                let _e1063 = phi_1375_;
                                phi_1376_ = _e1063;
                            }
                            let _e1065 = phi_1376_;
                            if _e1065 {
                                if _e259 {
                                    if _e721 {
                                        if _e1026.all_remove {
                                            phi_1389_ = false;
                                        } else {
                                            phi_1389_ = true;
                                        }
                                        let _e1067 = phi_1389_;
                                        phi_1390_ = _e1067;
                                    } else {
                                        phi_1390_ = true;
                                    }
                                    let _e1069 = phi_1390_;
                                    phi_1391_ = _e1069;
                                } else {
                                    phi_1391_ = true;
                                }
                                let _e1071 = phi_1391_;
                                if _e1071 {
                                    if _e259 {
                                        phi_1398_ = 1u;
                                    } else {
                                        phi_1398_ = 0u;
                                    }
                                    let _e1073 = phi_1398_;
                                    phi_1399_ = _e1073;
                                } else {
                                    phi_1399_ = 5u;
                                }
                                let _e1075 = phi_1399_;
                                phi_1400_ = _e1075;
                            } else {
                                phi_1400_ = 4u;
                            }
                            let _e1077 = phi_1400_;
                            phi_1401_ = _e1077;
                        }
                        let _e1079 = phi_1401_;
                        phi_1402_ = _e1079;
                    } else {
                        phi_1402_ = 3u;
                    }
                    let _e1081 = phi_1402_;
                    phi_1403_ = _e1081;
                } else {
                    phi_1403_ = 2u;
                }
                let _e1083 = phi_1403_;
                phi_1404_ = _e1083;
            }
            let _e1085 = phi_1404_;
            if !((_e1085 == 0u)) {
                if !((_e1085 == 5u)) {
                    phi_1416_ = !(_e1061);
                    phi_1417_ = false;
                } else {
                    phi_1416_ = bool();
                    phi_1417_ = true;
                }
                let _e1092 = phi_1416_;
                let _e1094 = phi_1417_;
                phi_1418_ = _e1092;
                phi_1419_ = _e1094;
            } else {
                phi_1418_ = bool();
                phi_1419_ = true;
            }
            let _e1096 = phi_1418_;
            let _e1098 = phi_1419_;
            if _e1098 {
                phi_1423_ = false;
            } else {
                phi_1423_ = _e1096;
            }
            let _e1100 = phi_1423_;
            if _e1061 {
                phi_1429_ = ((_e780 & 4u) != 0u);
            } else {
                phi_1429_ = _e255;
            }
            let _e1104 = phi_1429_;
            if _e1100 {
                if _e255 {
                    phi_1437_ = (2u | 1u);
                } else {
                    phi_1437_ = 2u;
                }
                let _e1107 = phi_1437_;
                if false {
                    phi_1442_ = (_e1107 | 4u);
                } else {
                    phi_1442_ = _e1107;
                }
                let _e1110 = phi_1442_;
                phi_1462_ = _e1110;
            } else {
                if (_e1085 == 7u) {
                    if _e255 {
                        phi_1451_ = (2u | 1u);
                    } else {
                        phi_1451_ = 2u;
                    }
                    let _e1114 = phi_1451_;
                    if _e1104 {
                        phi_1456_ = (_e1114 | 4u);
                    } else {
                        phi_1456_ = _e1114;
                    }
                    let _e1117 = phi_1456_;
                    phi_1461_ = _e1117;
                } else {
                    if _e255 {
                        phi_1460_ = 1u;
                    } else {
                        phi_1460_ = 0u;
                    }
                    let _e1119 = phi_1460_;
                    phi_1461_ = _e1119;
                }
                let _e1121 = phi_1461_;
                phi_1462_ = _e1121;
            }
            let _e1123 = phi_1462_;
            if _e1104 {
                phi_1466_ = 0f;
            } else {
                phi_1466_ = 1f;
            }
            let _e1125 = phi_1466_;
            phi_1468_ = mask_Masked(_e1125, _e1123, _e1100);
        }
        let _e1128 = phi_1468_;
        visibility.member[_e73.shift] = _e1128.visibility;
        let _e1133 = p.member.light.number;
        let _e1134 = (_e1133 * 3u);
        let _e1136 = (_e1134 % 32u);
        let _e1138 = p.member.light.mask_words;
        let _e1140 = ((_e73.shift * _e1138) + (_e1134 / 32u));
        let _e1142 = bits.member[_e1140];
        bits.member[_e1140] = ((_e1142 & ~((7u << bitcast<u32>((_e1136 & 31u))))) | (_e1128.bits << bitcast<u32>((_e1136 & 31u))));
        if (_e1136 > 29u) {
            let _e1157 = bits.member[(_e1140 + 1u)];
            let _e1159 = (32u - _e1136);
            bits.member[(_e1140 + 1u)] = ((_e1157 & ~((7u >> bitcast<u32>((_e1159 & 31u))))) | (_e1128.bits >> bitcast<u32>((_e1159 & 31u))));
        }
        phi_1518_ = _e1128.needs_ray;
        phi_1519_ = _e73.shift;
    } else {
        phi_1518_ = false;
        phi_1519_ = 0u;
    }
    let _e1173 = phi_1518_;
    let _e1175 = phi_1519_;
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1173 {
        let _e1179 = atomicAdd((&shared_[0u]), 1u);
        phi_1530_ = _e1179;
    } else {
        phi_1530_ = 0u;
    }
    let _e1181 = phi_1530_;
    workgroupBarrier();
    if (_e57 == 0u) {
        let _e1185 = atomicLoad((&shared_[0u]));
        let _e1186 = atomicAdd((&list.member[3u]), _e1185);
        atomicStore((&shared_[1u]), _e1186);
    }
    workgroupBarrier();
    if _e1173 {
        let _e1189 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1189) + _e1181)]), _e1175);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
